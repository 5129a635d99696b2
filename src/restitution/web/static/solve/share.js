// Copying, downloading, printing.

import { fetched } from "../api.js";
import { button, html } from "../player/elements.js";
import { link, linkable } from "./address.js";
import { copy } from "./clipboard.js";

const PAPER = [
  ["question", "the question only"],
  ["room", "the question, with room for working"],
  ["solution", "the question and its worked solution"],
];

// `now()` tells { text, reply (or null), whether it isWhole, picture (or null), hidden }.
export function makeShare(root, now, { sheet, say }) {
  const papers = sheet ? 2 : 1; // buttons, the last ones
  const buttons = [
    ["link", "Copy link", () => copyLink()],
    ["bare", "Link without answers", () => copyLink({ hidden: true })],
    ["statement", "Copy statement", () => copied(now().text, "statement")],
    ["latex", "Copy LaTeX", () => copied(now().reply.latex, "LaTeX")],
    ["svg", "Copy diagram as SVG", () => copied(now().picture.svg, "SVG")],
    ...(sheet ? [["pdf", "Download PDF", download]] : []),
    ["print", "Print", () => print()],
  ].map(([name, label, does]) =>
    button(label, (event) => does(event.currentTarget), { "data-do": name }));
  const paper = html("select", { id: "paper" }, PAPER.map(([value, said]) =>
    html("option", { value }, said)));
  paper.addEventListener("change", () => {
    chosen = paper.value;
    update();
  });
  let chosen = null; // what shall stand on paper; by itself, what is seen
  root.append(...buttons.slice(0, -papers),
    html("div", { class: "paper" }, html("label", { for: "paper" }, "On paper"), paper,
      ...buttons.slice(-papers)));

  async function copied(text, what) {
    if (await copy(text, what)) say(`The ${what} is copied.`);
  }

  function copyLink(what) {
    const { text } = now();
    if (linkable(text)) copied(link(text, what), what ? "link without answers" : "link");
    else say("This statement is too long for a link; copy the statement instead.");
  }

  async function download(pressed) {
    pressed.disabled = true;
    say("The sheet is being made …");
    try {
      const { text, title } = now();
      const asked = { solutions: paper.value === "solution", room: paper.value === "room" };
      const file = await fetched("sheet", { statement: text, ...asked });
      const name = (title ?? "").replace(/[^\p{L}\p{N} -]+/gu, "").trim().slice(0, 60);
      const address = URL.createObjectURL(file);
      html("a", { href: address, download: `${name || "question"}.pdf` }).click();
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
    const { text, reply, isWhole, picture, hidden } = now();
    paper.value = chosen ?? (hidden ? "question" : "solution");
    document.body.dataset.paper = paper.value;
    const can = { latex: !hidden && reply?.latex, svg: picture, pdf: reply, print: isWhole };
    for (const each of buttons) {
      const name = each.dataset.do;
      each.disabled = name in can ? !can[name] : !text.trim();
    }
  }

  return { update };
}
