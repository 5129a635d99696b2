// Whether the solution that is shown answers the question in the form: said over it where it does
// not, with what keeps the form from being read.

import { button, html } from "../player/elements.js";

const MOST = 4; // fields that are named

export function makeForeign(root, results) {
  const label = results.getAttribute("aria-label");

  // `kind` is "read", "reading", "apart" (the form was not filled in from the editor), "waiting" (it
  // may not write yet), or "unread": some fields cannot be read.
  function put({ kind, problems, goTo }) {
    const isForeign = kind === "unread" || kind === "waiting";
    results.classList.toggle("foreign-to-form", isForeign);
    results.setAttribute("aria-label",
      isForeign ? `${label}, not of the question in the form` : label);
    if (kind === "reading") results.classList.add("stale");
    else if (isForeign) results.classList.remove("stale");
    root.classList.toggle("early", results.hidden);
    root.replaceChildren(...(isForeign ? said(kind, problems, goTo) : []));
  }

  function said(kind, problems, goTo) {
    const [head, of] = results.hidden
      ? ["Not solved yet.", "The form"]
      : ["Not of this question.", "What stands below answers an earlier statement: the form"];
    if (kind === "waiting") {
      return [html("p", {}, html("strong", {}, head), ` ${of} waits for you to say whether it may `,
        "replace what was typed in the editor.")];
    }
    const wrong = problems.filter(({ isWrong }) => isWrong);
    const shown = wrong.length ? wrong : problems;
    const state = wrong.length ? "cannot be read" : "is not filled in yet. Still missing";
    const words = ({ label, said }) =>
      (wrong.length || !label ? `${label ?? "Text"}: ${said}` : label);
    const rest = shown.length - MOST;
    return [
      html("p", {}, html("strong", {}, head), ` ${of} ${state}:`),
      html("ul", {}, shown.slice(0, MOST).map((each) => html("li", {}, each.field
        ? button(words(each), () => goTo(each.field)) : words(each)))),
      ...(rest > 0 ? [html("p", {}, `and ${rest} more`)] : []),
    ];
  }

  return { put };
}
