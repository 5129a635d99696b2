// What is said of a working: a sign at each line, hints one at a time, and in the end the marks.

import { button, html } from "../player/elements.js";

const SIGNS = {
  true: ["✓", "true"], follows: ["→", "follows from your line"], false: ["✗", "not so"],
  asks: ["?", "a letter is not clear"], unread: ["…", "could not be read"], remark: ["", "a remark"],
  unsupported: ["!", "does not follow from your lines"],
};
const PLAYED = 3; // a mistake is played once it has been named
const HINTS = 4; // the last level gives the line itself

const said = (marking, line) =>
  marking.messages.filter((message) => message.line === line).map(({ text }) => text);

function lineOf(line, marking, { onHint, onPlay, levels, exam }) {
  const [sign, words] = SIGNS[line.verdict];
  const texts = said(marking, line.n);
  const level = levels.get(line.n) ?? 0;
  const { mistake } = line;
  const shown = !exam && mistake?.kind === "misconception" && mistake.id && level >= PLAYED &&
    button("Show me this mistake", () => onPlay(mistake.variants[0] ?? mistake.id, marking.part),
      { class: "asking-hint" });
  const wrong = line.verdict === "false" || line.verdict === "unsupported";
  const more = wrong && !exam && level < HINTS && button(
    level ? "A further hint" : "A hint", () => onHint(line.n, level + 1),
    { class: "asking-hint", "aria-label": `A hint for line ${line.n}` });
  return html("li", { class: line.verdict, "data-line": line.n },
    html("span", { class: "sign", title: words }, sign, html("span", { class: "unseen" }, ` ${words}: `)),
    html("span", { class: "typed" }, line.text),
    more || null,
    texts.map((text) => html("p", {}, text)),
    shown ? html("p", {}, shown) : null);
}

// A letter that has to be known: the meanings that would do, one tap each.
const asking = ({ letter, text, proposals }, onAgree) =>
  html("div", { class: "asks" },
    html("p", {}, text ?? `What is ${letter} here?`),
    html("div", { class: "choices" }, (proposals ?? []).map((each) =>
      button(`${letter}: ${each.words}`, () => onAgree({ letter, ...each })))));

const STATES = { earned: "✓", lost: "✗", open: "?" };

const marksOf = ({ earned, open, of, points }) =>
  html("section", { class: "marks-given", "aria-label": "Marks" },
    html("h3", {}, open ? `${earned} to ${earned + open} of ${of} marks` : `${earned} of ${of} marks`),
    html("table", {},
      html("tbody", {}, points.map(({ kind, state, why, line, ...point }) =>
        html("tr", { class: state },
          html("td", { class: "kind" }, `${kind} ${STATES[state]}`),
          html("td", {}, point.for, why ? html("span", { class: "quiet" }, ` – ${why}`) : null),
          html("td", { class: "quiet" }, line ? `line ${line}` : ""))))));

// `markings` are the objects of the server, one a part.
export function makeReply(root, callbacks) {
  return {
    clear: () => root.replaceChildren(),
    put(markings, { finished, exam, levels }) {
      root.replaceChildren(...markings.flatMap((marking) => [
        markings.length > 1 && marking.part ? html("h3", {}, `(${marking.part})`) : null,
        html("ol", { class: "lines-read" },
          marking.lines.map((line) => lineOf(line, marking, { ...callbacks, levels, exam }))),
        ...said(marking, null).map((text) => html("p", { class: "next-step" }, text)),
        ...marking.asks.map((each) => asking(each, callbacks.onAgree)),
        finished ? marksOf(marking.marks) : null,
      ]).filter(Boolean));
    },
    // What is read aloud: how many lines of each kind.
    spoken(markings) {
      const lines = markings.flatMap((marking) => marking.lines);
      const first = lines.find(({ verdict }) => verdict === "false");
      const right = lines.filter(({ verdict }) => verdict === "true").length;
      return `${right} of ${lines.length} lines are true. ` +
        (first ? `Line ${first.n} is not so.` : "");
    },
  };
}
