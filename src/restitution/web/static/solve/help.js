// The language on one panel: lines, quantities and expressions, with an example each.

import { html } from "../player/elements.js";

export function mountHelp(root, words) {
  // Nothing in it takes the focus, so it does itself, to be scrolled by keys.
  root.tabIndex = 0;
  root.setAttribute("role", "group");
  root.setAttribute("aria-labelledby", "language-heading");
  root.replaceChildren(
    html("p", {}, "One fact a line, in the order in which things happen. ",
      "Everything is seen from above, in SI units; none is typed."),
    section("Lines", [...words.lines, ...words.events].map(byExample)),
    section("Quantities", words.quantities.map(({ usage, about }) => [usage, about])),
    section("Numbers, letters, vectors", words.expressions.map(byExample)),
    section("Relations and questions", words.phrases.map(({ word, about }) => [word, about])),
    section("Functions", [[words.functions.map(({ word }) => word).join(" "), ""]]),
    section("In the editor", [
      ["Tab or Enter", "takes the suggestion that is marked"],
      ["↓ ↑", "another suggestion"],
      ["Ctrl + Space", "what could stand here"],
      ["Escape", "no suggestions; then Tab leaves the editor"],
    ]),
  );
}

const byExample = ({ example, about }) => [example, about];

const section = (heading, rows) =>
  html("section", {}, html("h3", {}, heading), html("dl", {}, rows.map(described)));

const described = ([term, about]) =>
  html("div", {}, html("dt", {}, html("code", {}, term)), html("dd", {}, about));
