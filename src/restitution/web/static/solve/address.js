// The address holds the statement, so that a link shares it and Back restores it.

import { keep, kept } from "../kept.js";

const LONGEST = 6000; // characters of an address that people can still send to each other
const DRAFT = "restitution statement";

const HIDDEN = { answers: "hidden" };
let hiding = false; // whether the address hides the answers

const fragment = (text, hidden = hiding) =>
  `#${new URLSearchParams({ statement: text, ...(hidden ? HIDDEN : {}) })}`;

// The statement of the address or of this entry of the history, or null.
export function told() {
  const given = new URLSearchParams(location.hash.slice(1)).get("statement");
  return given ?? history.state?.statement ?? null;
}

// Whether the address hides the answers.
export function hides() {
  hiding = new URLSearchParams(location.hash.slice(1)).get("answers") === HIDDEN.answers;
  return hiding;
}

// From now on it does, or does not.
export function keepHidden(on) {
  hiding = on;
}

// What was typed last in this tab, or null.
export function draft() {
  return kept(DRAFT);
}

// This entry of the history, or with `push` a new one, holds a statement from now on.
// Null is none: then the page shows the ways to begin.
export function hold(text, { push = false } = {}) {
  const address = text === null || !linkable(text) ? "#" : fragment(text);
  if (push) history.pushState({ statement: text }, "", address);
  else history.replaceState({ statement: text }, "", address);
  keep(DRAFT, text ?? "");
}

export const linkable = (text) => fragment(text).length <= LONGEST;

export const link = (text, { hidden = false } = {}) =>
  new URL(fragment(text, hidden), location.href).href;

// Calls back with the statement whenever Back, Forward or another fragment is chosen.
export function onReturn(go) {
  addEventListener("popstate", () => go(told()));
}
