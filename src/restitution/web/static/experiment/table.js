// A table as a text: whether it has a header, and the columns of one that has none.

const NUMBER = /^[+\-−]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?°?$/i;


// The columns that bare numbers may be, by how many of them stand side by side.
export const USUAL = {
  2: ["alpha", "beta"],
  3: ["t", "x", "y"],
  4: ["alpha", "beta", "u", "v"],
};

export const KNOWN = {
  2: ["alpha", "beta"],
  3: ["t", "x", "y", "alpha", "beta", "u", "v"],
  4: ["alpha", "beta", "u", "v", "t", "x", "y", "body", "trial"],
};

const firstLine = (text) =>
  text.split(/\r?\n/).find((line) => line.trim() && !line.trimStart().startsWith("#")) ?? "";

// What parts the cells of a line: tabs, semicolons, commas with a space behind, spaces, or commas.
function partedBy(line) {
  for (const separator of ["\t", ";"]) if (line.includes(separator)) return separator;
  return /\s/.test(line) && !/,\s/.test(line) ? " " : ",";
}

const cellsOf = (line) => {
  const separator = partedBy(line);
  return line.split(separator === " " ? /\s+/ : separator).map((cell) => cell.trim());
};

// The cells of the first line, where all of them are numbers; else null: there is a header.
export function bare(text) {
  const line = firstLine(text).trim();
  if (!line) return null;
  const cells = cellsOf(line);
  return cells.length in USUAL && cells.every((cell) => NUMBER.test(cell)) ? cells : null;
}

// The text with a header above it.
export function withHeader(text, names) {
  return `${names.join(partedBy(firstLine(text).trim()))}\n${text.trimStart()}`;
}
