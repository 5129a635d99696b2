// Making elements. No markup is ever made of text: every text becomes a text node.

const SVG = "http://www.w3.org/2000/svg";

function put(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith("on")) node.addEventListener(name.slice(2), value);
    else node.setAttribute(name, value === true ? "" : value);
  }
  node.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return node;
}

export const html = (name, attributes = {}, ...children) =>
  put(document.createElement(name), attributes, children);
export const svg = (name, attributes = {}, ...children) =>
  put(document.createElementNS(SVG, name), attributes, children);

// Letters in italics, as mathematics is set; words such as sin stay upright.
export function mathematics(text) {
  const pieces = text.split(/([A-Za-zα-ωΑ-Ω]+)/);
  return pieces.map((piece, index) =>
    index % 2 && piece.length < 3 ? html("var", {}, piece) : document.createTextNode(piece),
  );
}

// What has to be scrolled can be reached by the keyboard.
export function reachable(scroll) {
  const over = scroll.scrollWidth > scroll.clientWidth || scroll.scrollHeight > scroll.clientHeight;
  if (over) scroll.setAttribute("tabindex", "0");
  else scroll.removeAttribute("tabindex");
}
