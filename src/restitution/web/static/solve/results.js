// The answers: each item with its values, what was rejected and why, what was shown or refuted.

import { sentence } from "../api.js";
import { button, html } from "../player/elements.js";
import { grown } from "./trees.js";

export function answersOf({ answer, working }, editor) {
  const parts = working.filter(({ answers }) => answers.length);
  const nodes = parts.map(({ label, answers }) =>
    html(
      "section",
      { class: "part" },
      label ? html("h3", {}, `(${label})`) : null,
      html("ul", { class: "answers" }, answers.map(answered)),
    ),
  );
  if (!parts.length) nodes.push(...answer.parts.map(unanswered));
  const { error } = answer;
  return [...warningsOf(answer, editor), ...(error ? [failure(error, editor.goTo)] : []), ...nodes];
}

function answered(told) {
  const { item, values, equal, holds, undecided, counterexample, error, rejected, unit } = told;
  return html(
    "li",
    holds === null && values.length ? { class: "row" } : {},
    html("span", { class: "item" }, grown(item)),
    " ",
    ...(holds === null ? equals(values, equal, unit) : shown(holds, counterexample, values)),
    undecided ? html("strong", { class: "undecided" }, "? Not decided") : null,
    error ? html("p", { class: "problem" }, `No answer: ${error}`) : null,
    rejected.map(({ value, reason }) =>
      html("p", { class: "rejected" }, "Rejected: ", maths(value), `, as ${reason}.`),
    ),
  );
}

const shown = (holds, counterexample, values) =>
  [verdict(holds, counterexample), values.length ? ": " : null, ...alternatives(values)];

// `speed(P) = …`, but `range of e: …`, whose answer is a sentence.
function equals(values, equal, unit) {
  if (!values.length) return [];
  const [kind, sign] = equal ? ["sign", "="] : ["colon", ":"];
  return [
    html("span", { class: kind }, sign),
    // The forms of a range are no choice.
    html("span", { class: "values" }, alternatives(values, equal ? " or " : "; "),
      unit ? html("span", { class: "unit" }, `\u00a0${unit}`) : null),
  ];
}

const alternatives = (values, between = " or ") =>
  values.flatMap((value, index) =>
    [index ? html("span", { class: "or" }, between) : null, maths(value)]);

const maths = (value) => html("span", { class: "value" }, grown(value));

function verdict(holds, counterexample) {
  if (holds) return html("strong", { class: "shown" }, "✓ Shown");
  const values = (counterexample ?? []).flatMap((each, index) => [index ? ", " : "", maths(each)]);
  return html(
    "span",
    {},
    html("strong", { class: "refuted" }, "✗ Not true"),
    values.length ? [", for instance with ", ...values] : null,
  );
}

const unanswered = ({ part, items }) =>
  html(
    "section",
    { class: "part" },
    part ? html("h3", {}, `(${part})`) : null,
    html("ul", { class: "answers" },
      items.map(({ text }) => html("li", {}, html("code", {}, text)))),
  );

// Those that the text itself draws have cures, as its mistakes do.
const warningsOf = ({ warnings, notes }, editor) =>
  warnings.map((said) => {
    const note = notes.find(({ message, line, column }) =>
      said === `line ${line}, column ${column}: ${message}`);
    return html("p", { class: "warning" }, `Note: ${said}`, cures(note?.fixes, editor));
  });

export function failure({ message, line, column }, goTo) {
  const place = line && button(`line ${line}`, () => goTo(line, column), { class: "place" });
  return html("p", { class: "problem" }, sentence(message), place ? [" ", place] : null);
}

// Kinds of items whose answers are no values but sentences.
const SENTENCES = new Set(["range", "extremum"]);

// What is said aloud of a reply.
export function spoken({ answer }) {
  const items = answer.parts.flatMap(({ items: each }) => each);
  const said = items.map(({ text, kind, answers, holds, proof, error }) => {
    if (error) return `${text}: no answer, ${error.message}`;
    if (holds !== null) return `${text}: ${holds ? "shown" : "not true"}`;
    if (kind === "show" && proof === "undecided") return `${text}: not decided`;
    const sign = SENTENCES.has(kind) ? ":" : " =";
    return `${text}${sign} ${[...new Set(answers.map(({ display }) => display))].join(" or ")}`;
  });
  return said.length ? said.slice(0, 8).join("; ") : answer.error?.message ?? "";
}

export const numbered = (count) =>
  count === 1 ? "One thing to mend first" : `${count} things to mend first`;

// What is wrong with the text: a button that goes there, and one for each cure.
export const mistakes = (errors, editor) =>
  errors.map(({ message, line, column, fixes }) => {
    const said = [html("b", {}, line ? `Line ${line}` : "Text"), ` ${message}`];
    return html("li", {},
      button(said, () => editor.goTo(line ?? 1, column), { class: "mistake" }),
      cures(fixes, editor));
  });

const cures = (fixes, editor) =>
  (fixes ?? []).map((fix) => button(fix.label, () => editor.mend(fix), { class: "cure" }));
