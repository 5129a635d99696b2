// What the words of a statement are, for the eye only: the server alone knows what they mean.

const PIECE = new RegExp(
  [
    /(?<comment>#.*)/, /(?<number>\d+(?:\.\d+)?\s?(?:°|%|deg\b)?)/,
    /(?<word>[A-Za-z\u0370-\u03ff_][A-Za-z0-9\u0370-\u03ff_]*)/, /\s+/, /./,
  ].map(({ source }) => source).join("|"),
  "gu",
);
const DECLARED = /^[^\S\n]*(sphere|wall|point)\b([^:#\n]*)/gm;
const NAME = /^[A-Z][A-Za-z0-9]*$/;

// Names that the text declares, with what each is; the first declaration counts.
export function declared(text) {
  const names = new Map();
  for (const [, kind, told] of text.matchAll(DECLARED)) {
    for (const name of told.split(",").map((each) => each.trim())) {
      if (NAME.test(name) && !names.has(name)) names.set(name, kind);
    }
  }
  return names;
}

// Looks up what a word is, by the vocabulary that the page brings.
export function lexicon(words) {
  const kinds = new Map();
  const put = (kind, list) => list.forEach((word) => kinds.set(word, kind));
  put("function", words.functions.map(({ word }) => word));
  put("keyword", words.keywords);
  put("quantity", words.quantities.map(({ word }) => word));
  const phrases = words.phrases.map(({ word }) => word.replaceAll(" ", "\\s+"));
  const property = Object.values(words.properties)
    .flat()
    .map(({ word }) => word)
    .filter((word) => word.includes(" "));
  const any = [...phrases, ...property].join("|");
  return {
    kinds,
    lines: new Set(words.lines.map(({ word }) => word)),
    phrase: new RegExp(`(?<![A-Za-z0-9_])(?:${any})(?![A-Za-z0-9_])`, "gy"),
  };
}

// A line in pieces [{ kind, text }]; kind "" is plain.
export function pieces(line, names, { kinds, lines, phrase }) {
  const first = /^\s*([a-z]+)/.exec(line);
  if (first && lines.has(first[1])) {
    const head = { kind: "keyword", text: first[0] };
    const rest = line.slice(first[0].length);
    if (first[1] === "title") return [head, { kind: "title", text: rest }];
    if (first[1] === "part") return [head, { kind: "name", text: rest }];
    const property = first[1] === "sphere" || first[1] === "wall";
    return [head, ...inside(rest, names, { kinds, phrase, property })];
  }
  return inside(line, names, { kinds, phrase, property: false });
}

function inside(text, names, { kinds, phrase, property }) {
  const found = [];
  let at = 0;
  while (at < text.length) {
    phrase.lastIndex = at;
    const said = phrase.exec(text);
    PIECE.lastIndex = at;
    const match = said ?? PIECE.exec(text);
    const kind = said ? "keyword" : kindOf(match, text, names, kinds, property);
    found.push({ kind, text: match[0] });
    at += match[0].length;
  }
  return found;
}

function kindOf({ groups, 0: piece, index }, text, names, kinds, property) {
  if (groups.comment) return "comment";
  if (groups.number) return "number";
  if (!groups.word) return "";
  if (names.has(piece)) return "name";
  const kind = kinds.get(piece) ?? "";
  // `mass` and `along` are properties before a colon's values, quantities before their arguments.
  if (kind !== "quantity") return kind;
  const called = /^\s*\(/.test(text.slice(index + piece.length));
  return property || (piece === "along" && !called) ? "keyword" : "quantity";
}
