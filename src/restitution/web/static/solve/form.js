// A form that writes the statement, for those who would rather not type a language.
//
// What is typed into it is either the question that is solved, or it is told that it is not: a field
// that is missing or cannot be read leaves the last good statement as it is.

import { ask, sentence } from "../api.js";
import { button, html } from "../player/elements.js";
import {
  KINDS, askedOf, countOf, emptyOf, eventsOf, isPlainWho, nameOf, noFact, noResult, spheresOf,
} from "./form-model.js";
import { moving, picture } from "./form-pictures.js";
import { factsOf, learn, quantitiesOf } from "./form-quantities.js";
import { answersOf } from "./form-reading.js";
import { fieldAt, linesOf, statementOf } from "./form-statement.js";
import { wordsOf } from "./solver.js";

const PAUSE = 250; // ms after the last key until the server reads the statement
const QUICK = 50; // ms where only a number is another
const ABOVE = 4; // pixels above the line of the statement that is brought into sight
const nothing = () => {};

// `onStatement(text)` is told each statement that can be read; `onState(state)` that the fields are
// being read, are all read, or that some are not: { kind, problems: [{ field, label, said }] }.
// `current()` is the text in the editor.
export function mountForm(element, { words, onStatement, onState = nothing, current = () => "" }) {
  learn(words);
  const filled = new Map(KINDS.map(([kind]) => [kind, emptyOf(kind)]));
  let kind = KINDS[0][0];
  let waiting = null;
  let asking = new AbortController();
  let own = ""; // the text of the editor that these fields stand for
  let ready = null; // the statement that waits until it may replace another
  let problems = [];
  const now = () => filled.get(kind);

  const body = html("div", { class: "fields" });
  const text = html("code", {});
  const trouble = html("p", { class: "trouble", role: "status" });
  const beside = html("div", { class: "beside", role: "status" });
  const root = html("form", { class: "filling", autocomplete: "off", novalidate: true },
    html("p", { class: "intro" },
      "Fill in what the question tells; the statement goes into the editor as soon as all of it can ",
      "be read. Grey words are examples, and count for nothing."),
    beside,
    html("div", { class: "layout" },
      body,
      html("section", { class: "written", "aria-labelledby": "form-written" },
        html("h3", { id: "form-written" }, "The statement"),
        html("pre", { tabindex: 0 }, text),
        trouble,
        html("button", { type: "submit", class: "main" }, "Put it into the editor"))));

  root.addEventListener("submit", (event) => {
    event.preventDefault();
    if (problems.length || waiting !== null || ready !== null) {
      event.stopPropagation(); // the form stays open
      goTo(problems[0]?.field);
      if (ready !== null) beside.querySelector("button").focus();
    } else onStatement(statementOf(now()));
  });
  root.addEventListener("input", (event) => {
    keep(event.target);
    changed();
  });

  // What a field holds goes into the answers; what changes the fields themselves shows them anew.
  function keep(field) {
    const { name, value, type, checked } = field;
    const row = /^(known|shown)(\d+)(what|sign|speed|angle|way)?$/.exec(name);
    if (name === "kind") kind = value;
    else if (name === "asked") {
      const others = askedOf(now()).filter((item) => item !== value);
      now().asked = checked ? [...others, value] : others;
    } else if (row) {
      const rows = row[1] === "known" ? now().known : now().shows;
      rows[row[2]][row[3] ?? "value"] = value;
    } else now()[name] = value;
    if (type === "radio" || field.tagName === "SELECT") show(field);
    else refresh();
  }

  function show(from = null) {
    const open = new Set([...body.querySelectorAll("details[open]")].map(({ id }) => id));
    body.replaceChildren(...fieldsets(now()));
    for (const each of body.querySelectorAll("details")) {
      each.open = open.has(each.id) || each.querySelector(":checked") !== null;
    }
    if (!from) return;
    const wanted = `[name="${from.name}"]${from.type === "radio" ? `[value="${from.value}"]` : ""}`;
    body.querySelector(wanted)?.focus();
  }

  // Only what may be asked for depends on what is typed, such as an e that is left out.
  function refresh() {
    const old = body.querySelector(".asked");
    const fresh = askedFields(now());
    if (old.dataset.offered !== fresh.dataset.offered) old.replaceWith(fresh);
  }

  function changed() {
    const { missing, wrong } = linesOf(now());
    const statement = statementOf(now());
    write(statement);
    clearTimeout(waiting);
    waiting = null;
    asking.abort();
    mark(missing, wrong);
    if (missing.length + wrong.length) return tell("unread");
    tell("reading");
    waiting = setTimeout(check, wordsOf(statement) === wordsOf(own ?? "") ? QUICK : PAUSE, statement);
  }

  // The statement beside the fields, with the line in sight that comes from the field in use.
  function write(statement) {
    text.textContent = statement;
    const name = document.activeElement?.name;
    const line = name && linesOf(now()).lines.findIndex((pieces) =>
      pieces.some(([field]) => field === name));
    if (!(line >= 0)) return;
    const lines = statement.split("\n");
    const before = lines.slice(0, line).reduce((sum, each) => sum + each.length + 1, 0);
    const range = document.createRange();
    range.setStart(text.firstChild, before);
    range.setEnd(text.firstChild, before + lines[line].length);
    const box = text.parentElement;
    box.scrollTop += range.getBoundingClientRect().top - box.getBoundingClientRect().top - ABOVE;
  }

  async function check(statement) {
    const mine = new AbortController();
    asking = mine;
    try {
      const { errors } = await ask("check", { statement }, { signal: mine.signal });
      mark([], errors.map(({ message, line, column }) =>
        [line ? fieldAt(now(), line, column ?? 1) : null, sentence(message)]));
    } catch (error) {
      if (error.name === "AbortError") return; // gone on typing
      // The server is busy: whoever solves the statement tells that.
    }
    if (mine.signal.aborted) return;
    waiting = null;
    if (problems.length) tell("unread");
    else put(statement);
  }

  // The statement goes into the editor, but never unasked over what somebody typed there.
  function put(statement) {
    const typed = current();
    if (typed.trim() && typed !== own && typed !== statement) {
      ready = statement;
      offer();
      tell("waiting");
      return;
    }
    settled(statement);
    onStatement(statement);
  }

  function settled(statement) {
    own = statement;
    ready = null;
    beside.replaceChildren();
    tell("read");
  }

  function offer() {
    if (beside.querySelector("button")) return;
    beside.replaceChildren(
      html("p", {}, "The editor holds a statement that was not written here. Put this question in ",
        "its place? The browser’s Back brings it back."),
      button("Replace it", () => {
        const statement = ready;
        if (statement === null) return;
        settled(statement);
        onStatement(statement);
      }, { class: "main" }));
  }

  function tell(state) {
    if (state !== "waiting") {
      ready = null;
      if (beside.querySelector("button")) beside.replaceChildren();
    }
    onState({ kind: state, problems: state === "unread" ? problems : [], goTo });
  }

  // Shows what is missing and what is wrong, each as [field, text], at its field; what belongs to
  // no field stands below the statement.
  function mark(missing, wrong) {
    for (const place of body.querySelectorAll(".problem")) {
      place.textContent = "";
      place.classList.remove("missing");
    }
    for (const each of body.querySelectorAll("[aria-invalid]")) {
      each.removeAttribute("aria-invalid");
    }
    const rest = [];
    problems = [];
    const put = ([name, said], isWrong) => {
      const place = name && body.querySelector(`#problem-${name}`);
      const [where, label] = place ? [name, labelOf(name)] : [null, null];
      problems.push({ field: where, label, said, isWrong });
      if (!place) rest.push(said);
      else if (!place.textContent) {
        place.textContent = said;
        place.classList.toggle("missing", !isWrong);
        const typed = isWrong && body.querySelector(`input[type=text][name="${name}"]`);
        if (typed) typed.setAttribute("aria-invalid", "true");
      }
    };
    for (const each of wrong) put(each, true);
    for (const each of missing) put(each, false);
    trouble.textContent = rest.join(" ");
  }

  // What a field is called, with the group that it stands in.
  function labelOf(name) {
    const place = body.querySelector(`#problem-${name}`);
    const group = place.closest("fieldset").querySelector("legend").textContent;
    const several = place.closest("[role=radiogroup]")?.getAttribute("aria-label");
    if (several) return `${group}, ${several}`;
    const label = place.closest(".field")?.querySelector("label");
    const nodes = [...(label?.childNodes ?? [])];
    const words = nodes.filter((each) => !each.classList?.contains("quiet"));
    const title = words.map((each) => each.textContent).join("");
    return title ? `${group}, ${title}` : group;
  }

  function goTo(name) {
    const place = name && body.querySelector(`#problem-${name}`);
    const field = place?.parentElement.querySelector("input, select");
    field?.focus();
  }

  show();
  text.textContent = statementOf(now());
  element.append(root);

  // --- reading what stands in the editor ----------------------------------------------------------

  let reading = new AbortController();

  // The fields are filled in from a statement, where they can hold it.
  async function read(statement) {
    reading.abort();
    if (statement === own) return repeat();
    clearTimeout(waiting);
    waiting = null;
    asking.abort();
    if (!statement.trim()) {
      filled.set(kind, emptyOf(kind));
      return fill(statement);
    }
    const mine = new AbortController();
    reading = mine;
    let outline = null;
    try {
      ({ outline } = await ask("outline", { statement }, { signal: mine.signal }));
    } catch {
      return;
    }
    if (mine.signal.aborted) return;
    const { answers, reason, line } = outline === null
      ? { reason: "it cannot be read yet" } : answersOf(outline, statement);
    if (answers) {
      kind = answers.kind;
      filled.set(kind, answers);
      fill(statement);
    } else {
      own = null;
      tell("apart");
      const where = line ? ` (line ${line})` : "";
      beside.replaceChildren(html("p", {}, "These fields are not filled in from the editor: ",
        `${reason}${where}. What stands there is left as it is until you say otherwise.`));
    }
  }

  function fill(statement) {
    show();
    mark([], []);
    text.textContent = statementOf(now());
    settled(statement);
  }

  function repeat() {
    if (problems.length) tell("unread");
  }

  return { read };

  // --- fields ---------------------------------------------------------------------------------

  function fieldsets(answers) {
    return [
      kinds(answers),
      ...(answers.kind === "walls"
        ? [twoWalls(answers)] : answers.wall === undefined ? [] : [wall(answers)]),
      ...(answers.line === undefined ? [] : [centres(answers)]),
      ...spheresOf(answers).map((role) => sphere(answers, role)),
      restitution(answers),
      knownFields(answers),
      askedFields(answers),
      shownFields(answers),
    ];
  }

  function kinds(answers) {
    return group("What happens?",
      html("div", { class: "kinds" }, ...KINDS.map(([value, label]) =>
        html("label", { class: "kind" },
          html("input", { type: "radio", name: "kind", value, checked: value === kind }),
          picture(value), html("span", {}, label)))),
      field(answers, "title", "Title", { optional: true, example: "such as Exercise 5, question 3" }));
  }

  function wall(answers) {
    const more = [["unknown", "not known"]];
    return group(`The wall ${nameOf(answers, "W")}`,
      choice(answers, "wall", "It runs", [...WAYS, ...more]), ...way(answers, "wall", answers.wall));
  }

  function twoWalls(answers) {
    const [first, second] = ["AB", "BC"].map((role) => nameOf(answers, role));
    const turned = [["between", `at an angle to ${first}`]];
    return group(`The walls ${first} and ${second}`,
      picture("between"),
      choice(answers, "first", `${first} runs`, WAYS), ...way(answers, "first", answers.first),
      choice(answers, "second", `${second} runs`,
        answers.first === "vector" && answers.second !== "between" ? WAYS : [...turned, ...WAYS]),
      ...(answers.second === "between"
        ? [field(answers, "between", "Angle between the walls, where the sphere is",
          { example: "such as 120" })]
        : way(answers, "second", answers.second)));
  }

  function way(answers, prefix, mode) {
    if (mode === "vector") {
      return [field(answers, `${prefix}Vector`, "Direction", { example: "such as 3i + 4j" })];
    }
    if (mode !== "angle") return [];
    return [field(answers, `${prefix}Angle`, "Angle from i, in degrees",
      { hint: "anticlockwise", example: "such as 30, or theta" })];
  }

  function sphere(answers, role) {
    const name = nameOf(answers, role);
    const struck = nameOf(answers, eventsOf(answers)[0][1]);
    const toWall = spheresOf(answers).length === 1;
    const ways = [
      ["components", "by i and j components"],
      ...(toWall ? [["wall", `by speed and angle to ${struck}`]]
        : [["line", "by speed and angle to the line of centres"]]),
      ["speed", "by speed and direction from i"],
      ["vector", "by a vector in one piece"],
      ...(toWall ? [] : [["rest", "at rest"]]),
      ["unknown", "not known"],
    ];
    const mode = answers[`${role}Velocity`];
    const speedAnd = (label, options) =>
      row(field(answers, `${role}Speed`, "Speed", { example: "such as 5, or u" }),
        field(answers, `${role}Angle`, label, options));
    const fields = {
      components: () => [row(...["i", "j"].map((axis) =>
        field(answers, role + (axis === "i" ? "X" : "Y"), [html("b", {}, axis), " component"],
          { example: axis === "i" ? "such as 3, or u" : "such as -4, or 0" })))],
      wall: () => [picture("angle", struck),
        speedAnd(`Angle to ${struck}, in degrees`, { example: "such as 60, or alpha" })],
      line: () => [
        speedAnd("Angle to the line of centres, in degrees", { example: "such as 60, or alpha" }),
        senses(answers, `${role}Way`, role, answers[`${role}Way`])],
      speed: () => [speedAnd("Direction from i, in degrees",
        { hint: "anticlockwise; or from another vector", example: "such as 60, or alpha from -i" })],
      vector: () => [field(answers, `${role}Vector`, "Velocity",
        { example: "such as 2(3i - 4j), or u at 60 from -j" })],
    }[mode];
    return group(`Sphere ${name}`,
      field(answers, `${role}Mass`, "Mass", { optional: true, example: "such as 2, or 3m" }),
      choice(answers, `${role}Velocity`, "Velocity before", ways), ...(fields ? fields() : []));
  }

  // How a sphere moves along the line of centres, and to which side, chosen on a picture.
  function senses(answers, name, role, chosen) {
    const body_ = nameOf(answers, role);
    const other = nameOf(answers, role === "A" ? "B" : "A");
    const sides = SIDES[answers.line] ?? SIDES.other;
    const options = ["towards-left", "towards-right", "away-left", "away-right"].map((value) => {
      const [sense, side] = value.split("-");
      const along = sense === "towards" ? `towards ${other}` : `away from ${other}`;
      const label = `${along}, ${sides[side]}`;
      return html("label", { class: "kind" },
        html("input", { type: "radio", name, value, checked: value === chosen }),
        moving(answers.line, role, value, answers.names), html("span", {}, label));
    });
    return html("div", { class: "field", role: "radiogroup", "aria-label": `How ${body_} moves` },
      html("div", { class: "kinds senses" }, ...options),
      html("p", { class: "problem", id: `problem-${name}` }));
  }

  function centres(answers) {
    const ways = [
      ...WAYS, ["offset", "as the distance between the paths tells"], ["unknown", "not known"],
    ];
    const apart = answers.line === "offset";
    const [a, b] = ["A", "B"].map((role) => nameOf(answers, role));
    const who = isPlainWho(answers) ? [] : [choice(answers, "order", "Which strikes the other", [
      ["AB", `${a} hits ${b}`], ["BA", `${b} hits ${a}`]],
    "where both move the same way along the line of centres, the faster one")];
    return group("The line of centres", picture(apart ? "offset" : "line"),
      choice(answers, "line", "It lies", ways,
        "along i, drawn from left to right, where the question names no vectors"),
      ...way(answers, "line", answers.line),
      ...(apart
        ? [row(field(answers, "offset", "Distance between the paths",
          { hint: "positive where the one struck lies to the left", example: "such as 1.6r" }),
        field(answers, "radius", "Radius of both spheres", { example: "such as r" }))]
        : []), ...who);
  }

  function restitution(answers) {
    const many = countOf(answers) > 1;
    const hits = eventsOf(answers).map((event) =>
      event.map((role) => nameOf(answers, role)).join(" hits "));
    const hint = many ? "left out, it is the letter e at both" : "left out, it is the letter e";
    const fields = hits.map((each, index) => field(answers, `e${index + 1}`,
      many ? `e where ${each}` : "e", { optional: true, hint, example: "such as 1/2" }));
    return group(many ? "Coefficients of restitution" : `${hits[0]}: coefficient of restitution`,
      row(...fields));
  }

  function knownFields(answers) {
    const quantities = quantitiesOf(answers).filter((each) => !each.fixed);
    const facts = factsOf(answers);
    const rows = answers.known.map((each, index) => {
      const name = `known${index}`;
      const begins = index === 0 ? "It is known that" : "and that";
      const vectors = quantities.filter(({ vector }) => vector);
      const pairs = vectors.flatMap(({ key, label, group: of }) => {
        const speed = label.replace("velocity", "speed and direction");
        const line = label.replace("velocity", "speed and angle to the line of centres");
        const hasLine = answers.line !== undefined && key.endsWith(", 1)");
        return [{ key: `polar ${key}`, label: `${speed}, from i`, group: of },
          ...(hasLine ? [{ key: `line ${key}`, label: line, group: of }] : [])];
      });
      const options = [["", "nothing more"], ["fact", "another fact, such as tan(alpha) = 3/4"],
        ...grouped([...quantities, ...pairs, ...facts])];
      const select = choice({ [`${name}what`]: each.what }, `${name}what`, begins, options);
      return [select, ...valueFields(answers, each, name, quantities)];
    });
    const full = answers.known.at(-1).what !== "";
    return group("What else is known", ...rows.flat(), full ? button("Another fact", () => {
      answers.known.push(noFact());
      show({ name: `known${answers.known.length - 1}what` });
    }) : null,
    field(answers, "unknown", "Letters that are unknown, and not asked for",
      { optional: true, example: "such as v, theta" }));
  }

  function valueFields(answers, each, name, quantities) {
    const { what } = each;
    const put = (end, label, options) =>
      field({ [name + end]: each[end || "value"] }, name + end, label, options);
    if (what === "fact") {
      return [put("", "The fact", { example: "such as tan(alpha) = 3/4, or k > 1" })];
    }
    const [, mode, key] = /^(polar|line) (.*)$/.exec(what) ?? [];
    const speed = () => put("speed", "Speed", { example: "such as 2, or v" });
    if (mode === "polar") {
      return [row(speed(), put("angle", "Direction from i, in degrees",
        { hint: "anticlockwise", example: "such as 30" }))];
    }
    if (mode === "line") {
      const role = spheresOf(answers).find((one) => key.includes(`(${nameOf(answers, one)},`));
      const angle = put("angle", "Angle to the line of centres, in degrees",
        { example: "such as 30" });
      return [row(speed(), angle), senses(answers, `${name}way`, role, each.way)];
    }
    const chosen = quantities.find((one) => one.key === what);
    return chosen ? [put("", "is equal to", exampleOf(chosen))] : [];
  }

  function askedFields(answers) {
    const offered = quantitiesOf(answers);
    const ticked = askedOf(answers);
    const groups = [...Map.groupBy(offered, (each) => each.group)].map(([name, members]) =>
      html("div", { class: "boxes", role: "group", "aria-label": name },
        html("p", { class: "name", "aria-hidden": "true" }, name),
        ...members.map(({ key, label }) => html("label", { class: "box" },
          html("input", {
            type: "checkbox", name: "asked", value: key, checked: ticked.includes(key),
          }),
          html("span", {}, label)))));
    const made = group("What is to be found?",
      ...groups,
      html("p", { class: "problem", id: "problem-asked" }),
      field(answers, "also", "Also to be found", {
        hint: "letters, or quantities of the language", example: "such as alpha, k, range of e" }),
      field(answers, "terms", "In terms of", { optional: true, example: "such as u, e" }));
    made.classList.add("asked");
    made.dataset.offered = offered.map((each) => each.key).join();
    return made;
  }

  function shownFields(answers) {
    const quantities = quantitiesOf(answers).filter(({ vector, fixed }) => !vector && !fixed);
    const rows = answers.shows.map((each, index) => {
      const name = `shown${index}`;
      const options = [["", "nothing more"], ["relation", "another result, such as tan(beta) = e"],
        ...grouped([...quantities, ...factsOf(answers)])];
      const select = choice({ [`${name}what`]: each.what }, `${name}what`,
        index === 0 ? "Show that" : "and that", options);
      if (each.what === "relation") {
        const value = { [name]: each.value };
        return [select, field(value, name, "The result", { example: "such as e = 1/3" })];
      }
      const chosen = quantities.find(({ key }) => key === each.what);
      if (!chosen) return [select];
      return [select, row(
        choice({ [`${name}sign`]: each.sign }, `${name}sign`, "is", SIGNS),
        field({ [name]: each.value }, name, "this", exampleOf(chosen)))];
    });
    const full = answers.shows.at(-1).what !== "";
    return group("What is to be shown?", ...rows.flat(), full ? button("Another result", () => {
      answers.shows.push(noResult());
      show({ name: `shown${answers.shows.length - 1}what` });
    }) : null);
  }
}

const WAYS = [
  ["i", "along i"], ["j", "along j"], ["vector", "along another vector"], ["angle", "at an angle"],
];
const SIDES = {
  i: { left: "up", right: "down" },
  j: { left: "to the left", right: "to the right" },
  other: { left: "to its left", right: "to its right" },
};
const SIGNS = [["=", "equal to"], ["<", "less than"], ["<=", "at most"], [">", "more than"],
  [">=", "at least"]];

const exampleOf = ({ vector, angle, percent }) => ({
  example: vector ? "such as 4i + 2j" : angle ? "such as 90, in degrees"
    : percent ? "such as 60, in per cent" : "such as 3, or u/2",
});

const group = (legend, ...inside) => html("fieldset", {}, html("legend", {}, legend), ...inside);
const row = (...fields) => html("div", { class: "row" }, ...fields);

// Options by the groups that they belong to.
const grouped = (members) =>
  [...Map.groupBy(members, (each) => each.group)].map(([label, each]) =>
    ({ label, options: each.map(({ key, label: said }) => [key, said]) }));

function field(answers, name, label, { hint = null, optional = false, example = null } = {}) {
  const id = `form-${name}`;
  const described = [hint && `hint-${name}`, `problem-${name}`].filter(Boolean).join(" ");
  return html("div", { class: "field" },
    html("label", { for: id }, label,
      optional ? html("span", { class: "quiet" }, " (if told)") : null),
    html("input", {
      id, name, type: "text", value: answers[name], spellcheck: "false",
      autocapitalize: "off", autocomplete: "off", "aria-describedby": described,
      placeholder: example,
    }),
    hint ? html("p", { class: "hint", id: `hint-${name}` }, hint) : null,
    html("p", { class: "problem", id: `problem-${name}` }));
}

function choice(answers, name, label, ways, hint = null) {
  const id = `form-${name}`;
  const option = ([value, said]) =>
    html("option", { value, selected: answers[name] === value }, said);
  return html("div", { class: "field" },
    html("label", { for: id }, label),
    html("select", { id, name, "aria-describedby": hint && `hint-${name}` }, ways.map((each) =>
      Array.isArray(each) ? option(each)
        : html("optgroup", { label: each.label }, each.options.map(option)))),
    hint ? html("p", { class: "hint", id: `hint-${name}` }, hint) : null,
    html("p", { class: "problem", id: `problem-${name}` }));
}
