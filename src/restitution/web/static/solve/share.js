// Copying, downloading, printing.

import { fetched } from "../api.js";
import { button, html } from "../player/elements.js";
import { link, linkable } from "./address.js";
import { copy } from "./clipboard.js";

// `now()` tells { text, reply (or null), picture (or null) }.
export function makeShare(root, now, { sheet, say }) {
  const buttons = [
    ["link", "Copy link", copyLink],
    ["statement", "Copy statement", () => copied(now().text, "statement")],
    ["latex", "Copy LaTeX", () => copied(now().reply.latex, "LaTeX")],
    ["svg", "Copy diagram as SVG", () => copied(now().picture.svg, "SVG")],
    ...(sheet ? [["pdf", "Download PDF", download]] : []),
    ["print", "Print", () => print()],
  ].map(([name, label, does]) =>
    button(label, (event) => does(event.currentTarget), { "data-do": name }));
  root.append(...buttons);

  async function copied(text, what) {
    if (await copy(text, what)) say(`The ${what} is copied.`);
  }

  function copyLink() {
    const { text } = now();
    if (linkable(text)) copied(link(text), "link");
    else say("This statement is too long for a link; copy the statement instead.");
  }

  async function download(pressed) {
    pressed.disabled = true;
    say("The sheet is being made …");
    try {
      const { text, title } = now();
      const file = await fetched("sheet", { statement: text, solutions: true });
      const name = (title ?? "").replace(/[^\p{L}\p{N} -]+/gu, "").trim().slice(0, 60);
      const address = URL.createObjectURL(file);
      html("a", { href: address, download: `${name || "worked solution"}.pdf` }).click();
      setTimeout(() => URL.revokeObjectURL(address), 60_000);
      say("The sheet is downloaded.");
    } catch (error) {
      say(`There is no sheet: ${error.message}.`);
    } finally {
      update();
    }
  }

  // Which of them can be used.
  function update() {
    const { text, reply, picture } = now();
    const can = { latex: reply?.latex, svg: picture, pdf: reply, print: reply };
    for (const each of buttons) {
      const name = each.dataset.do;
      each.disabled = name in can ? !can[name] : !text.trim();
    }
  }

  return { update };
}
