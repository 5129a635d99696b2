// Angles as people type them: a number alone is in degrees. The sign that says so is put in here.

const NUMBER = String.raw`\d+(?:\.\d+)?`;
const PLAIN = new RegExp(`^${NUMBER}$`);
const QUOTIENT = new RegExp(`^${NUMBER}\\s*/\\s*${NUMBER}$`);
const ROOT = /sqrt|√/g;
const LETTERS = /[\p{L}_°º%]/u;
const FUNCTION = /(?:sqrt|√|a?r?c?(?:sin|cos|tan)|cot|sec|cosec|abs)(?:\s*\^\s*[\d-]+|²)?\s*$/;

// Whether a text has a plus or minus outside brackets.
export function isSum(text) {
  let depth = 0;
  for (const sign of text) {
    if (sign === "(") depth += 1;
    else if (sign === ")") depth -= 1;
    else if (depth === 0 && "+-−–".includes(sign)) return true;
  }
  return false;
}

export const bracketed = (text) => (isSum(text) ? `(${text})` : text);

// The text with ° behind each number that is an angle by itself: `180 - theta` is `180° - theta`,
// `60 from -i` is `60° from -i`; `2 theta`, `arctan(3/4)` and `pi/3` stay as they are.
export function inDegrees(text) {
  const [, angle, rest] = /^(.*?)(\s+(?:from|to)\b.*)?$/s.exec(text);
  return terms(angle).map(({ sign, term }) => sign + degrees(term)).join("") + (rest ?? "");
}

// The size of an angle that is a plain number of degrees, or null.
export function plainDegrees(text) {
  const found = new RegExp(`^(${NUMBER})\\s*(?:°|º|deg|degrees?)?$`).exec(text.trim());
  return found ? Number(found[1]) : null;
}

// The terms of a sum, each with the sign and the blanks before it.
function terms(text) {
  const found = [{ sign: "", term: "" }];
  let depth = 0;
  for (const each of text) {
    if (each === "(") depth += 1;
    if (each === ")") depth -= 1;
    const last = found.at(-1);
    if (depth === 0 && "+-−–".includes(each) && !/[\^*/]\s*$/.test(last.term)) {
      found.push({ sign: each, term: "" });
    } else last.term += each;
  }
  return found;
}

function degrees(whole) {
  const [, before, term, after] = /^(\s*)(.*?)(\s*)$/s.exec(whole);
  return before + marked(term) + after;
}

function marked(term) {
  if (term === "") return term;
  if (PLAIN.test(term) || QUOTIENT.test(term)) return `${term}°`;
  const groups = groupsOf(term);
  if (groups.length === 1 && groups[0].start === 0 && groups[0].end === term.length) {
    return `(${inDegrees(term.slice(1, -1))})`;
  }
  if (!LETTERS.test(term.replace(ROOT, ""))) return `${bracketed(term)}*1°`;
  // A sum with letters in brackets is the angle, and what stands outside a plain factor of it.
  const outside = groups.reduceRight((text, { start, end }) =>
    text.slice(0, start) + text.slice(end), term);
  if (groups.length !== 1 || LETTERS.test(outside)) return term;
  const [{ start, end }] = groups;
  return `${term.slice(0, start)}(${inDegrees(term.slice(start + 1, end - 1))})${term.slice(end)}`;
}

// The outermost brackets of a text that hold no argument of a function.
function groupsOf(text) {
  const found = [];
  let depth = 0;
  let start = 0;
  [...text].forEach((sign, index) => {
    if (sign === "(" && depth++ === 0) start = index;
    if (sign === ")" && --depth === 0 && !FUNCTION.test(text.slice(0, start))) {
      found.push({ start, end: index + 1 });
    }
  });
  return found;
}
