// Copying, downloading, printing.

import { Refused } from "../api.js";
import { html } from "../dom.js";
import { link, linkable } from "./address.js";
import { copy } from "./clipboard.js";

// `now()` tells { text, reply (or null), picture (or null) }.
export function makeShare(root, now, { sheet, say }) {
  const buttons = [
    ["link", "Copy link", () => (linkable(now().text) ? copied(link(now().text), "link") : tooLong())],
    ["statement", "Copy statement", () => copied(now().text, "statement")],
    ["latex", "Copy LaTeX", () => copied(now().reply.latex, "LaTeX")],
    ["svg", "Copy diagram as SVG", () => copied(now().picture.svg, "SVG")],
    ...(sheet ? [["pdf", "Download PDF", download]] : []),
    ["print", "Print", () => print()],
  ].map(([name, label, does]) =>
    html("button", { type: "button", "data-do": name, onclick: (event) => does(event.currentTarget) }, label),
  );
  root.append(...buttons);

  async function copied(text, what) {
    if (await copy(text, what)) say(`The ${what} is copied.`);
  }

  const tooLong = () => say("This statement is too long for a link; copy the statement instead.");

  async function download(button) {
    button.disabled = true;
    say("The sheet is being made …");
    try {
      const { text, title } = now();
      const file = await sheetOf(text);
      const name = (title ?? "worked solution").replace(/[^\p{L}\p{N} -]+/gu, "").trim().slice(0, 60);
      const address = URL.createObjectURL(file);
      html("a", { href: address, download: `${name || "worked solution"}.pdf` }).click();
      setTimeout(() => URL.revokeObjectURL(address), 60_000);
      say("The sheet is downloaded.");
    } catch (error) {
      say(`There is no sheet: ${error.message}`);
    } finally {
      update();
    }
  }

  // Which of them can be used.
  function update() {
    const { text, reply, picture } = now();
    const can = { latex: reply?.latex, svg: picture, pdf: reply, print: reply };
    for (const button of buttons) {
      const name = button.dataset.do;
      button.disabled = name in can ? !can[name] : !text.trim();
    }
  }

  return { update };
}

async function sheetOf(statement) {
  const reply = await fetch("api/sheet", {
    method: "POST",
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify({ statement, solutions: true }),
  }).catch(() => {
    throw new Refused(0, "the server does not answer.", null);
  });
  if (reply.ok) return reply.blob();
  const told = await reply.json().catch(() => ({}));
  throw new Refused(reply.status, told.error?.message ?? `the server says ${reply.status}.`, null);
}
