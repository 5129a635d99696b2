// Answers hidden: all of them, or line by line those whose line has not come yet.

import { button, html } from "../player/elements.js";

const COMING = (count) =>
  count === 1 ? "One answer comes with a line below." : `${count} answers come with the lines below.`;

// `elements` are those of the page by their names; `onChange()` is told that the answers were hidden
// or shown, `stepwise()` that they are to come line by line.
export function makeHiding(elements, { onChange, stepwise }) {
  const { results, answers, note, working, worked, motion, question, unfold } = elements;
  let hidden = false;
  let given = null;
  let isWhole = true;
  let isHeld = false;
  let line = null; // { byLine, shown, total, steps } of the working

  const toggle = button("Hide answers", () => set(!hidden), 
    { role: "switch", "aria-checked": "false" });
  const show = button("Show answers", () => set(false));
  const lines = button("Show them line by line", () => {
    set(false);
    stepwise();
  });
  elements.tools.append(toggle);
  const covered = html("div", { class: "covered" },
    html("p", {}, "The worked solution is hidden with the answers."), show, lines);
  worked.append(covered);

  // On paper the solution stands where it is chosen, whatever the screen hides.
  addEventListener("beforeprint", () => {
    if (document.body.dataset.paper === "solution" && given) working.hidden = isEmpty();
  });
  addEventListener("afterprint", update);

  const isEmpty = () => !given.working.some(({ steps }) => steps.length);

  function set(on) {
    hidden = on;
    if (on && unfold.getAttribute("aria-expanded") === "false") unfold.click();
    onChange();
    if (!on) toggle.focus();
  }

  // How many lines of the working have to stand there before an item has its answer.
  function linesBefore(part, item) {
    const own = line.steps.filter((step) => step.part === part && step.item === item);
    return own.length ? own.at(-1).until : line.total;
  }

  // How many before an event is told to its end.
  function linesOf(event) {
    const later = line.steps.findIndex((step) => step.event !== null && step.event > event);
    return later <= 0 ? line.total : line.steps[later - 1].until;
  }

  function update() {
    if (!given) return;
    const byLine = !hidden && line?.byLine;
    results.classList.toggle("hiding", hidden);
    results.classList.toggle("by-line", Boolean(byLine));
    toggle.setAttribute("aria-checked", String(hidden));
    working.hidden = hidden || (isEmpty() && !isHeld);
    covered.hidden = !hidden;
    lines.hidden = isEmpty();
    motion.hidden = hidden || !(isWhole || isHeld) || (byLine && line.shown < line.total);
    question.hidden = hidden && given.question === null;
    let coming = 0;
    const items = given.working.flatMap((part, index) =>
      part.answers.map((_, item) => ({ part: index, item })));
    [...answers.querySelectorAll(".answers > *")].forEach((node, index) => {
      const each = items[index];
      const isThere = () => isWhole && linesBefore(each.part, each.item) <= line.shown;
      const later = Boolean(hidden || (byLine && each && !isThere()));
      node.hidden = later;
      coming += later;
    });
    for (const part of answers.querySelectorAll(".part")) {
      part.hidden = part.querySelector(".answers > :not([hidden])") === null;
    }
    for (const each of answers.querySelectorAll(".warning, :scope > .problem")) each.hidden = hidden;
    note.textContent = hidden ? "The answers are hidden." : byLine && coming ? COMING(coming) : "";
    note.hidden = note.textContent === "";
  }

  return {
    get hidden() {
      return hidden;
    },
    // What is said aloud of a solution instead of its answers, or null.
    get instead() {
      if (hidden) return "Solved. The answers are hidden.";
      return line?.byLine ? "Solved. The answers come line by line." : null;
    },
    // Hidden from the start, as a link can have it.
    begin(on) {
      if (on) set(true);
    },
    // A solution; one that is not `whole` has no working yet, and line by line no answers either.
    // Where an earlier one is `held`, its working and motion stay in their places meanwhile.
    put(reply, whole = true, held = false) {
      given = reply;
      isWhole = whole;
      isHeld = held && !whole;
      update();
    },
    // Another line of the working, or another way to show it.
    follow(told) {
      line = told;
      update();
    },
    update,
    // The diagrams that may be seen: at least what the question tells.
    pictures({ pictures, figure }) {
      const told = figure ? [figure] : [];
      if (hidden) return told;
      if (!line?.byLine || (isWhole && line.shown >= line.total)) return pictures;
      if (!isWhole) return told;
      const seen = pictures.filter(({ event }) => event !== null && linesOf(event) <= line.shown);
      return [...told, ...seen];
    },
  };
}
