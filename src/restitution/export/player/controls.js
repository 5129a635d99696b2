// Buttons with a picture, and boxes to tick.

import { button, html, svg } from "./elements.js";

export const ICONS = {
  play: "M6 4l14 8-14 8z",
  pause: "M6 4h4v16H6zM14 4h4v16h-4z",
  rewind: "M4 4h3v16H4zM20 4v16L8 12z",
  previous: "M13 4v16L3 12zM16.5 9a3 3 0 1 1 0 6 3 3 0 0 1 0-6z",
  next: "M11 4v16l10-8zM7.500 9a3 3 0 1 1 0 6 3 3 0 0 1 0-6z",
};

export function iconButton(icon, label, shortcut, does) {
  const path = svg("path", { d: ICONS[icon] });
  const picture = { viewBox: "0 0 24 24", "aria-hidden": "true", focusable: "false" };
  const told = { "aria-label": label, title: `${label} (${shortcut})`, "data-do": icon };
  return { node: button(svg("svg", picture, path), does, told), path };
}

export function check(label, shortcut, on) {
  const box = html("input", { type: "checkbox", checked: on });
  const node = html("label", { title: `${label} (${shortcut})` }, box, label);
  return { node, box };
}
