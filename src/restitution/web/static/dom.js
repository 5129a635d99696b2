// Making elements. No markup is ever made of text: every text becomes a text node.

export { html, svg } from "./player/elements.js";

const MATH = "http://www.w3.org/1998/Math/MathML";

// What the server sends as ["name", {attributes}, child, …], a child being such a list or a text.
const KNOWN = new Set(
  ("article section h1 h2 h3 h4 p span em strong b i ol ul li table tbody thead tr td th div var " +
    "sub sup code br wbr").split(" "),
);
const MATHS = new Set(
  ("math mrow mi mn mo mtext mspace mfrac msqrt mroot msub msup msubsup mover munder munderover " +
    "mtable mtr mtd mstyle mpadded mphantom menclose").split(" "),
);
const ATTRIBUTES = new Set(
  ("class colspan rowspan display form stretchy fence separator lspace rspace width height depth " +
    "mathvariant displaystyle scriptlevel columnalign linethickness accent minsize maxsize " +
    "aria-label role lang").split(" "),
);

export function grown(tree) {
  if (typeof tree === "string") return document.createTextNode(tree);
  const [name, attributes, ...children] = tree;
  const space = MATHS.has(name) ? MATH : KNOWN.has(name) ? "http://www.w3.org/1999/xhtml" : null;
  if (space === null) throw new Error(`an element that is not expected: ${name}`);
  const node = document.createElementNS(space, name);
  for (const [key, value] of Object.entries(attributes)) {
    if (ATTRIBUTES.has(key)) node.setAttribute(key, value);
  }
  node.append(...children.map(grown));
  return node;
}

// What scrolls sideways can be reached by the keyboard, and only while it does.
export function reachable(node) {
  if (node.scrollWidth > node.clientWidth + 1) node.tabIndex = 0;
  else node.removeAttribute("tabindex");
}
