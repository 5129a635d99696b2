// The result of an experiment: e, the readings, what a class computes, the check of the model.

import { html } from "../player/elements.js";
import { capital, prose } from "./prose.js";

// Of each verdict its sign and its class.
const VERDICTS = {
  seen: ["!", "seen"], "not seen": ["✓", "unseen-pattern"], untested: ["?", "untested"],
};
const MOST_ROWS = 200; // of readings, in the page

const minus = (text) => text.replace("-", "−");
const fixed = (x, places) => minus(x.toFixed(places));

const cell = (text) => html("td", {}, text);
const head = (...words) => html("th", { scope: "col" }, ...words);
const row = (...cells) => html("tr", {}, ...cells.map(cell));

const ratio = ({ x, y }) => (x ? fixed(y / x, 3) : "–");

function headline({ words }) {
  const [value, interval, errors] = words;
  return html("div", { class: "headline" },
    html("p", { class: "value" }, ...prose(value)),
    html("p", {}, ...prose(interval)),
    html("p", { class: "quiet" }, errors));
}

function readings({ points, kind }) {
  const angles = points[0]?.alpha !== null;
  const heads = angles
    ? [["Line"], ["α"], ["β"], ["tan α"], ["tan β"], ["tan β / tan α"]]
    : [["Line"], ["Approach"], ["Separation"], ["Ratio"]];
  const rows = points.slice(0, MOST_ROWS).map((point) => {
    const { line, label, alpha, beta, x, y, residual } = point;
    const measured = angles
      ? [`${fixed(alpha, 1)}°`, `${fixed(beta, 1)}°`, fixed(x, 3), fixed(y, 3)]
      : [minus(String(Number(x.toPrecision(4)))), minus(String(Number(y.toPrecision(4))))];
    return row(label || String(line), ...measured, ratio(point), fixed(residual, 1));
  });
  if (kind === "tracks") heads[0] = ["Trial"];
  const more = points.length > MOST_ROWS ? `, the first ${MOST_ROWS} of ${points.length}` : "";
  return html("details", { class: "readings", open: points.length <= 12 },
    html("summary", {}, `The readings${more}`),
    html("div", { class: "scroll", tabindex: 0, role: "group", "aria-label": "The readings" },
      html("table", { class: "numbers" },
        html("thead", {}, html("tr", {},
          ...heads.map(([words]) => head(...prose(words))), head("Distance"))),
        html("tbody", {}, ...rows))),
    html("p", { class: "hint" },
      "Distance from the law, in standard errors; more than 3 is rare."));
}

function classValues({ class_values: { why }, class_words: [mean, slope, fit], points }) {
  const angles = points[0]?.alpha !== null;
  const quotient = angles ? "tan β / tan α" : "separation / approach";
  const line = (words, value) =>
    html("tr", {}, html("th", { scope: "row" }, ...prose(words)), cell(value));
  return html("section", { class: "class-values" },
    html("h3", {}, "What a class computes"),
    html("table", {}, html("tbody", {},
      line(`Mean of ${quotient}`, mean),
      line("Slope of the line through the origin", slope),
      line("The fit, with errors in both", fit))),
    html("p", {}, ...prose(why)));
}

function check({ title, verdict, sentence }) {
  const words = capital(sentence.replace(/^Untested: /, ""));
  const [sign, kind] = VERDICTS[verdict];
  return html("li", { class: kind },
    html("span", { class: "sign", "aria-hidden": "true" }, sign),
    html("h4", {}, ...prose(capital(title)), ": ", html("em", {}, verdict)),
    html("p", {}, ...prose(words)));
}

function checks({ checks: all }) {
  return html("section", { class: "checks" },
    html("h3", {}, "Check of the model"), html("ul", {}, ...all.map(check)));
}

function notes({ table, notes: all }) {
  const faults = table.faults.map(({ message }) => html("li", {}, message));
  const section = (title, items) =>
    items.length ? html("section", {}, html("h3", {}, title), html("ul", {}, ...items)) : null;
  const rows = faults.length === 1 ? "1 row" : `${faults.length} rows`;
  return [
    section(`Left out: ${rows}`, faults),
    section("Notes", all.map((note) => html("li", {}, ...prose(`${capital(note)}.`)))),
  ].filter(Boolean);
}

// The parts of a page that shows it; `pictures` is where its pictures are.
export function results(reply, pictures) {
  return [
    headline(reply), pictures, checks(reply), classValues(reply), readings(reply), ...notes(reply),
  ];
}
