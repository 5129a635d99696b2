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

// A button with words on it.
export const button = (label, onclick, attributes = {}) =>
  html("button", { type: "button", onclick, ...attributes }, label);

// Letters in italics, as mathematics is set; words such as sin stay upright.
export function mathematics(text) {
  const pieces = text.split(/([A-Za-zα-ωΑ-Ω]+)/);
  return pieces.map((piece, index) =>
    index % 2 && piece.length < 3 ? html("var", {}, piece) : document.createTextNode(piece),
  );
}

// Whether a button does anything just now. One that does not keeps the focus, which is never lost.
export function allow(button, on) {
  button.setAttribute("aria-disabled", String(!on));
}

// What has to be scrolled, by more than sizes are rounded, can be reached by the keyboard.
export function reachable(scroll) {
  const { scrollWidth, clientWidth, scrollHeight, clientHeight } = scroll;
  const over = Math.max(scrollWidth - clientWidth, scrollHeight - clientHeight) > 1;
  if (over) scroll.setAttribute("tabindex", "0");
  else scroll.removeAttribute("tabindex");
}
