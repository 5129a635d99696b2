// Trees of the server, made into elements: ["name", {attributes}, child, …], a child being such a
// list or a text. Only what is known here comes through.

const HTML = "http://www.w3.org/1999/xhtml";
const MATH = "http://www.w3.org/1998/Math/MathML";

const spaces = (names, space) => names.split(" ").map((name) => [name, space]);
const SPACES = new Map([
  ...spaces("article section h1 h2 h3 h4 p span em strong b i ol ul li table tbody thead tr td " +
    "th div var sub sup code br wbr", HTML),
  ...spaces("math mrow mi mn mo mtext mspace mfrac msqrt mroot msub msup msubsup mover munder " +
    "munderover mtable mtr mtd mstyle mpadded mphantom menclose", MATH),
]);
const ATTRIBUTES = new Set(
  ("class colspan rowspan display form stretchy fence separator lspace rspace width height depth " +
    "mathvariant displaystyle scriptlevel columnalign linethickness accent minsize maxsize " +
    "aria-label role lang").split(" "),
);

export function grown(tree) {
  if (typeof tree === "string") return document.createTextNode(tree);
  const [name, attributes, ...children] = tree;
  const space = SPACES.get(name);
  if (space === undefined) throw new Error(`an element that is not expected: ${name}`);
  const node = document.createElementNS(space, name);
  for (const [key, value] of Object.entries(attributes)) {
    if (ATTRIBUTES.has(key)) node.setAttribute(key, value);
  }
  node.append(...children.map(grown));
  return node;
}
