// Keys: what they do, and the list of them.

import { button, html } from "./elements.js";

// Does what a key stands for, where nobody types and the control in focus has no use for the key
// itself: a slider uses the arrows, unless it is that of the `time`.
export function obey(event, does, time) {
  const { target } = event;
  if (event.ctrlKey || event.metaKey || event.altKey || isTyping(target)) return;
  const slides = target !== time && target.matches?.("input[type=range]");
  const own = slides ? ["ArrowRight", "ArrowLeft", "Home", "End"] : [];
  // What is not seen has lost the focus, even if the browser has yet to notice.
  const pressed = target.matches?.("button, input[type=checkbox]");
  if (pressed && target.getClientRects().length) own.push(" ");
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (!(key in does) || own.includes(key)) return;
  event.preventDefault();
  does[key]();
}

// Whether keys go into a text.
export const isTyping = (target) =>
  target.isContentEditable ||
  target.matches?.("textarea, select, input:not([type=range], [type=checkbox])");

// A list of [key, what it does]; what has no second half is said of those after it.
export function listOfKeys(keys) {
  const rows = keys.map(([key, does]) => html("tr", {},
    html("th", { scope: "row", colspan: does ? null : 2 }, does ? html("kbd", {}, key) : key),
    does ? html("td", {}, does) : null));
  const close = button("Close", () => made.close());
  const made = html("dialog", { "aria-label": "Keys" }, html("h2", {}, "Keys"),
    html("table", {}, html("tbody", {}, ...rows)), close);
  return made;
}
