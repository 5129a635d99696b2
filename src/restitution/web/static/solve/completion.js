// Which words could stand at a place of the statement.

const MOST = 40;
const PARTIAL = /[A-Za-z_][A-Za-z0-9_]*$/;

// What is offered at the offset `at`: { from, options: [{ word, insert, about }], sure }, or null.
// Where it is `sure`, the first of them may be taken without being chosen; `asked` is true where
// the reader asked for it, and then it may be offered before anything is typed.
export function offers(text, at, words, names, asked = false) {
  const start = text.lastIndexOf("\n", at - 1) + 1;
  const before = text.slice(start, at);
  if (/^\s*title\b/.test(before) || before.includes("#")) return null;
  if (/^[A-Za-z0-9_]/.test(text.slice(at))) return null;
  const partial = PARTIAL.exec(before)?.[0] ?? "";
  const told = before.slice(0, before.length - partial.length);
  if (/[0-9]$/.test(told) && partial) return null;
  const place = placeOf(told, words, names);
  if (place === null || (partial.length < place.least && !asked)) return null;
  const options = matching(place.options, partial);
  const whole = options.some(({ word }) => word === partial);
  if (!options.length || (whole && options.length === 1)) return null;
  const sure = partial !== "" && !whole;
  return { from: at - partial.length, options: options.slice(0, MOST), sure };
}

function matching(options, partial) {
  const wanted = partial.toLowerCase();
  const begins = options.filter(({ word }) => word.toLowerCase().startsWith(wanted));
  if (wanted.length < 3) return begins;
  const within = ({ word }) => word.toLowerCase().indexOf(wanted) > 0;
  return [...begins, ...options.filter(within)];
}

// The options at the end of what is told in a line, and how much of a word is to be typed first.
function placeOf(told, words, names) {
  if (/^\s*$/.test(told)) {
    return { least: 1, options: [...words.lines.map(beginning), ...bodies(names, "sphere")] };
  }
  const actor = /^\s*([A-Z][A-Za-z0-9]*)\s+$/.exec(told);
  if (actor && names.get(actor[1]) === "sphere") {
    const options = words.events.map((each) => ({ ...each, insert: `${each.word} ` }));
    return { least: 0, options };
  }
  if (/\bhits\s+$/.test(told)) return { least: 0, options: bodies(names, "sphere", "wall") };
  const kind = propertied(told);
  if (kind && /[:,]\s*$/.test(told) && depth(told) === 0) {
    const insert = (word) => (word === "e" ? "e = " : word === "at rest" ? word : `${word} `);
    const options = words.properties[kind].map((each) => ({ ...each, insert: insert(each.word) }));
    return { least: 0, options };
  }
  if (/^\s*(sphere|wall|point)\s+[A-Z]?[A-Za-z0-9, ]*$/.test(told)) return null; // a new name
  if (/[a-z]\s*\(\s*$/.test(told)) {
    const options = [...bodies(names, "sphere", "wall", "point"), ...quantities(words)];
    return { least: 0, options };
  }
  return { least: 2, options: values(told, words, names) };
}

function values(told, words, names) {
  const line = /^\s*([a-z]+)/.exec(told)?.[1];
  const phrases = words.phrases
    .filter(({ lines }) => lines.includes(line))
    .map((each) => ({ ...each, insert: each.word }));
  const asks = ["find", "show", "given", "let"].includes(line);
  return [
    ...(asks ? quantities(words) : []),
    ...phrases,
    ...words.functions.map((each) => ({ ...each, insert: `${each.word}(` })),
    ...Object.entries(words.greek).map(([word, sign]) => ({ word, insert: word, about: sign })),
    ...bodies(names, "sphere", "wall", "point"),
  ];
}

const beginning = ({ word, begin, about }) => ({ word, insert: begin, about });

const quantities = (words) =>
  words.quantities.map(({ word, about, alone }) => ({
    word, insert: alone ? word : `${word}(`, about,
  }));

const bodies = (names, ...kinds) =>
  [...names].filter(([, kind]) => kinds.includes(kind))
    .map(([word, about]) => ({ word, insert: word, about }));

// Which properties a line takes, by how it begins; null before its colon.
function propertied(told) {
  const match = /^\s*(?:(sphere|wall)\b|[A-Z][A-Za-z0-9]*\s+(hits)\b)[^:]*:/.exec(told);
  return match && (match[1] ?? match[2]);
}

function depth(text) {
  let open = 0;
  for (const character of text) {
    if (character === "(") open += 1;
    if (character === ")") open -= 1;
  }
  return open;
}
