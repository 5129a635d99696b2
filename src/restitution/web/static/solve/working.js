// The worked solution: whole, or line by line as on a board.

import { allow, button, html } from "../player/elements.js";
import { keepReachable } from "./scrolling.js";
import { grown } from "./trees.js";

// The sections; of each step what it is about, and how many lines there are by its end; and for
// each line the elements that appear with it: a heading or a sentence comes with what follows it.
function laid(working) {
  const sections = [];
  const steps = [];
  const lines = [[]];
  const put = (node, ends = true) => {
    lines.at(-1).push(node);
    if (ends) lines.push([]);
    return node;
  };
  for (const [index, part] of working.entries()) {
    if (!part.steps.length) continue;
    const section = html("section", { class: "part" });
    const heading = part.label && html("h3", {}, `(${part.label})`, worth(part.marks));
    if (heading) section.append(put(heading, false));
    const level = part.label ? "h4" : "h3";
    for (const step of part.steps) {
      section.append(...stepped(step, put, level));
      steps.push({ part: index, item: step.item, event: step.event, until: lines.length - 1 });
    }
    sections.push(section);
  }
  const last = lines.pop();
  lines.at(-1)?.push(...last);
  return { sections, lines, steps };
}

const worth = (marks) =>
  marks ? html("span", { class: "mark" }, ` ${marks} ${marks === 1 ? "mark" : "marks"}`) : null;

function stepped(step, put, level) {
  const said = step.said === null ? null : grown(step.said);
  if (step.kind === "heading") return [put(html(level, {}, said), false)];
  const nodes = [];
  const named = step.principle &&
    html("em", { class: "principle" }, `${step.principle}${step.sign}`, said && " ");
  if (named || said) {
    const mark = step.mark && html("span", { class: "mark" }, step.mark);
    const { asking, more } = step.about ? why(step.principle ?? said.textContent, step.about) : {};
    const sentence = html("p", {}, mark || null, named || null, said, asking && [" ", asking]);
    nodes.push(put(html("div", { class: "said" }, sentence, more), !step.rows.length));
  }
  if (step.rows.length) {
    const body = html("tbody");
    const scroll = { class: "scroll", role: "group", "aria-label": "Equations" };
    const group = html("div", { class: "rows" }, html("div", scroll, html("table", {}, body)));
    for (const { row } of step.rows) {
      const rows = (Array.isArray(row[0]) ? row : [row]).map(grown);
      rows.forEach((each, index) => put(each, index === rows.length - 1));
      body.append(...rows);
    }
    nodes.push(group);
  }
  return nodes;
}

// A button behind a line, and what it unfolds below.
function why(of, about) {
  const more = html("p", { class: "about", hidden: true }, about);
  const asking = button("Why?", () => {
    more.hidden = !more.hidden;
    asking.setAttribute("aria-expanded", String(!more.hidden));
  }, { class: "why", "aria-expanded": "false", "aria-label": `Why? ${of}` });
  return { asking, more };
}

// A line still to come is hidden from sight, but not from paper.
const isLater = (node) => node.classList.contains("later");
const hideWith = (node, within) => node.classList.toggle("later", [...within].every(isLater));

// `onLine({ byLine, shown, total, steps })` is told how much of it is seen.
export function makeWorking(root, { onLine }) {
  const whole = button("Whole", () => setMode(false), { "aria-pressed": "true" });
  const stepwise = button("Line by line", () => setMode(true), { "aria-pressed": "false" });
  const marks = html("input", { type: "checkbox", checked: true });
  const body = html("div", { class: "lines" });
  const back = button("Back one line", () => show(shown - 1));
  const next = button("Next line", () => show(shown + 1), { class: "main next" });
  const progress = html("span", { class: "progress" });
  const pace = html("div", { class: "pace" }, back, next, progress);
  const modes = html("div", { class: "modes", role: "group", "aria-label": "How to show it" },
    whole, stepwise);
  root.append(
    html("div", { class: "tools" }, modes, html("label", { class: "check" }, marks, "Marks")),
    body,
    pace,
  );
  const look = keepReachable(body, ".scroll");
  let lines = [];
  let byLine = false;
  let shown = 0;
  let given = null;
  let steps = [];

  function setMode(on) {
    byLine = on;
    whole.setAttribute("aria-pressed", String(!on));
    stepwise.setAttribute("aria-pressed", String(on));
    show(on ? 1 : lines.length, false);
    if (on) next.focus();
  }

  function show(count, follow = true) {
    shown = Math.max(Math.min(count, lines.length), Math.min(1, lines.length));
    body.toggleAttribute("data-stepwise", byLine);
    if (byLine) body.setAttribute("aria-live", "polite");
    else body.removeAttribute("aria-live");
    lines.forEach((nodes, index) => {
      for (const node of nodes) {
        node.classList.toggle("later", byLine && index >= shown);
        node.classList.toggle("newest", byLine && index === shown - 1);
      }
    });
    for (const group of body.querySelectorAll(".rows")) {
      hideWith(group, group.querySelectorAll("tr"));
    }
    for (const section of body.children) hideWith(section, section.children);
    pace.hidden = !byLine;
    allow(back, shown > 1);
    allow(next, shown < lines.length);
    progress.textContent = `line ${shown} of ${lines.length}`;
    look();
    onLine({ byLine, shown, total: lines.length, steps });
    if (byLine && follow) lines[shown - 1]?.at(-1).scrollIntoView({ block: "nearest" });
  }

  marks.addEventListener("change", () => body.classList.toggle("unmarked", !marks.checked));
  root.addEventListener("keydown", (event) => {
    if (!byLine || event.ctrlKey || event.metaKey || event.altKey) return;
    const pressed = event.target.closest("button, summary, input");
    const does = { ArrowRight: 1, ArrowLeft: -1, ...(pressed ? {} : { " ": 1 }) }[event.key];
    if (!does) return;
    event.preventDefault();
    show(shown + does);
  });

  return {
    put(working) {
      if (working === given) return;
      given = working;
      const made = laid(working);
      lines = made.lines.filter((nodes) => nodes.length);
      steps = made.steps;
      body.replaceChildren(...made.sections);
      show(byLine ? 1 : lines.length, false);
    },
    stepwise: () => setMode(true),
    get empty() {
      return !lines.length;
    },
  };
}
