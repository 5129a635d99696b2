// What opens over the page, or within it: examples, the language, the form. Each is fetched when
// it is first wanted.

import { button, html } from "../player/elements.js";
import { style } from "../styles.js";

// A dialog, filled by `fill(body)` once, when it is first opened; returns what opens it.
// A call of that opens it, and gives what `fill` made of it, or nothing where it could not.
export function makePanel(title, className, fill) {
  let dialog = null;
  let made = null;

  async function build() {
    const heading = html("h2", { id: `${className}-heading` }, title);
    const body = html("div", { class: "body" }, html("p", { class: "quiet" }, "One moment …"));
    const close = button("Close", () => dialog.close());
    dialog = html(
      "dialog",
      { class: `panel ${className}`, "aria-labelledby": heading.id, closedby: "any" },
      html("header", {}, heading, close),
      body,
    );
    document.body.append(dialog);
    dialog.showModal();
    try {
      made = await fill(body, () => dialog.close());
    } catch {
      made = null;
      body.replaceChildren(lost());
      dialog.addEventListener("close", () => {
        dialog.remove();
        dialog = null; // to be tried again
      }, { once: true });
    }
  }

  return async () => {
    if (dialog) dialog.showModal();
    else await build();
    return made;
  };
}

// A fold below its button, filled once, when it is first opened.
export function makeFold(button, body, fill) {
  let filled = false;
  return async () => {
    body.hidden = !body.hidden;
    button.setAttribute("aria-expanded", String(!body.hidden));
    if (filled || body.hidden) return;
    filled = true;
    try {
      await fill(body);
    } catch {
      body.replaceChildren(lost());
      filled = false; // to be tried again
    }
  };
}

const lost = () =>
  html("p", { class: "problem" }, "This could not be loaded. Is the server still there?");

// Fills a panel with a module's own element, its style first.
export const lazily = (sheet, load, mount) => async (body, close) => {
  const [module] = await Promise.all([load(), sheet && style(sheet)]);
  body.replaceChildren();
  return mount(module, body, close);
};
