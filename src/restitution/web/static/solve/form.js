// A form that writes the statement, for those who would rather not type a language.

import { ask, sentence } from "../api.js";
import { button, html } from "../player/elements.js";
import {
  KINDS, defaultsOf, eventsOf, factsOf, fieldAt, linesOf, objection, quantitiesOf, spheresOf,
  statementOf,
} from "./form-statement.js";
import { picture } from "./form-pictures.js";

const PAUSE = 400; // ms after the last key until the server reads the statement

// `onStatement(text)` is told the statement at each change.
export function mountForm(element, { onStatement }) {
  const answers = new Map(KINDS.map(([kind]) => [kind, defaultsOf(kind)]));
  let kind = KINDS[0][0];
  let waiting = null;
  let asking = new AbortController();
  const now = () => answers.get(kind);

  const body = html("div", { class: "fields" });
  const text = html("code", {});
  const trouble = html("p", { class: "trouble", role: "status" });
  const root = html("form", { class: "filling", autocomplete: "off", novalidate: true },
    html("p", { class: "intro" },
      "Fill in what the question tells; the statement grows as you do, and goes into the editor. ",
      "The form starts afresh each time: it does not read what stands in the editor."),
    html("div", { class: "layout" },
      body,
      html("section", { class: "written", "aria-labelledby": "form-written" },
        html("h3", { id: "form-written" }, "The statement"),
        html("pre", { tabindex: 0 }, text),
        trouble,
        html("button", { type: "submit", class: "main" }, "Put it into the editor"))));

  root.addEventListener("submit", (event) => {
    event.preventDefault();
    onStatement(statementOf(now()));
  });
  root.addEventListener("input", (event) => {
    keep(event.target);
    changed();
  });

  // What a field holds goes into the answers; what changes the fields themselves shows them anew.
  function keep(field) {
    const { name, value, type, checked } = field;
    const row = /^(what|known)(\d+)$/.exec(name);
    if (name === "kind") kind = value;
    else if (name === "asked") {
      const others = now().asked.filter((item) => item !== value);
      now().asked = checked ? [...others, value] : others;
    } else if (row) now().known[row[2]][row[1] === "what" ? "what" : "value"] = value;
    else now()[name] = value;
    if (type === "radio" || field.tagName === "SELECT") show(field);
    else refresh();
  }

  function show(from = null) {
    body.replaceChildren(...fieldsets(now()));
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
    const statement = statementOf(now());
    write(statement);
    onStatement(statement);
    clearTimeout(waiting);
    asking.abort();
    waiting = setTimeout(() => check(statement), PAUSE);
  }

  function write(statement) {
    text.textContent = statement;
    mark(linesOf(now()).notes);
  }

  async function check(statement) {
    asking = new AbortController();
    try {
      const { errors } = await ask("check", { statement }, { signal: asking.signal });
      const told = errors.map(({ message, line, column }) =>
        [line ? fieldAt(now(), line, column ?? 1) : null, sentence(message)]);
      mark(linesOf(now()).notes, told);
    } catch {
      // Gone on typing, or a server that is busy: the editor tells that.
    }
  }

  // Shows what is missing and what is wrong, each as [field, text], at its field; what belongs to
  // no field stands below the statement.
  function mark(missing, wrong = []) {
    const objections = [...body.querySelectorAll("input[type=text]")]
      .map((field) => [field.name, objection(field.value)]).filter(([, said]) => said);
    for (const place of body.querySelectorAll(".problem")) {
      place.textContent = "";
      place.classList.remove("missing");
    }
    for (const each of body.querySelectorAll("[aria-invalid]")) {
      each.removeAttribute("aria-invalid");
    }
    const rest = [];
    const put = ([name, message], isWrong) => {
      const place = name && body.querySelector(`#problem-${name}`);
      if (!place) {
        if (isWrong) rest.push(message);
      } else if (!place.textContent) {
        place.textContent = message;
        place.classList.toggle("missing", !isWrong);
        const typed = isWrong && body.querySelector(`input[type=text][name="${name}"]`);
        if (typed) typed.setAttribute("aria-invalid", "true");
      }
    };
    for (const each of [...objections, ...wrong]) put(each, true);
    for (const each of missing) put(each, false);
    trouble.textContent = rest.join(" ");
  }

  show();
  write(statementOf(now()));
  element.append(root);

  // --- fields ---------------------------------------------------------------------------------

  function fieldsets(told) {
    const [first] = eventsOf(told);
    const many = eventsOf(told).length > 1;
    return [
      kinds(),
      ...(told.kind === "walls" ? [twoWalls(told)] : told.wall === undefined ? [] : [wall(told)]),
      ...spheresOf(told).map((name) => sphere(told, name)),
      ...(told.line === undefined ? [] : [centres(told)]),
      restitution(told, first, many),
      knownFields(told),
      askedFields(told),
    ];
  }

  function kinds() {
    return group("What happens?", html("div", { class: "kinds" }, ...KINDS.map(([value, label]) =>
      html("label", { class: "kind" },
        html("input", { type: "radio", name: "kind", value, checked: value === kind }),
        picture(value), html("span", {}, label)))));
  }

  function wall(told) {
    const more = [["unknown", "not known"]];
    return group("The wall W",
      choice(told, "wall", "It runs", [...WAYS, ...more]), ...way(told, "wall", told.wall));
  }

  function twoWalls(told) {
    return group("The walls AB and BC",
      picture("between"),
      choice(told, "first", "AB runs", WAYS.filter(([value]) => value !== "vector")),
      ...way(told, "first", told.first),
      choice(told, "second", "BC runs", [["between", "at an angle to AB"], ...WAYS]),
      ...(told.second === "between"
        ? [field(told, "between", "Angle ABC between the walls", { hint: "such as 120°" })]
        : way(told, "second", told.second)));
  }

  function way(told, prefix, mode) {
    if (mode === "vector") {
      return [field(told, `${prefix}Vector`, "Direction", { hint: "such as 3i + 4j" })];
    }
    if (mode !== "angle") return [];
    const hint = "anticlockwise, such as 30° or theta";
    return [field(told, `${prefix}Angle`, "Angle from i", { hint })];
  }

  function sphere(told, name) {
    const [, struck] = eventsOf(told)[0];
    const toWall = spheresOf(told).length === 1;
    const ways = [
      ["components", "by its i and j components"],
      ...(toWall ? [["wall", `by its speed and angle to ${struck}`]] : []),
      ["speed", "by its speed and direction"],
      ...(toWall ? [] : [["rest", "at rest"]]),
      ["unknown", "not known"],
    ];
    const mode = told[`${name}Velocity`];
    const speedAnd = (label, hint) =>
      row(field(told, `${name}Speed`, "Speed"), field(told, `${name}Angle`, label, { hint }));
    const by = {
      components: () => [row(...["i", "j"].map((axis) =>
        field(told, name + (axis === "i" ? "X" : "Y"), [html("b", {}, axis), " component"])))],
      wall: () => [
        picture("angle", struck), speedAnd(`Angle to ${struck}`, "such as 60° or alpha"),
      ],
      speed: () => [speedAnd("Direction from i", "anticlockwise: 60°, -alpha, or alpha from -i")],
    }[mode];
    const hint = "a number or a letter, such as 2 or 3m";
    return group(`Sphere ${name}`,
      field(told, `${name}Mass`, "Mass", { optional: true, hint }),
      choice(told, `${name}Velocity`, "Velocity before", ways), ...(by ? by() : []));
  }

  function centres(told) {
    const ways = [
      ...WAYS, ["offset", "as the distance between the paths tells"], ["unknown", "not known"],
    ];
    const apart = told.line === "offset";
    const hint = "positive where B lies to the left";
    return group("The line of centres", picture(apart ? "offset" : "line"),
      choice(told, "line", "It lies", ways), ...way(told, "line", told.line),
      ...(apart
        ? [row(field(told, "offset", "Distance between the paths", { hint }),
          field(told, "radius", "Radius of both spheres"))]
        : []));
  }

  function restitution(told, [first, second], many) {
    const label = (index) => {
      const [a, b] = eventsOf(told)[index];
      return many ? `e where ${a} hits ${b}` : "e";
    };
    const one = `${first} hits ${second}: coefficient of restitution`;
    const more = { optional: true, hint: "left out, it is the letter e" };
    return group(many ? "Coefficients of restitution" : one,
      row(...eventsOf(told).map((_, i) => field(told, `e${i + 1}`, label(i), more))));
  }

  function knownFields(told) {
    const quantities = quantitiesOf(told).filter((each) => !each.fixed);
    const rows = told.known.map(({ what, value }, index) => {
      const chosen = quantities.find(({ item }) => item === what);
      const [whats, values] = [`what${index}`, `known${index}`];
      const begins = index === 0 ? "It is known that" : "and that";
      const select = choice({ [whats]: what }, whats, begins, [
        ["", "nothing more"], ...quantities.map(({ item, label }) => [item, label]),
        ...factsOf(told), ["fact", "another fact, such as tan(alpha) = 3/4"],
      ]);
      if (what === "fact") {
        const hint = "such as tan(alpha) = 3/4, or k > 1";
        return [select, field({ [values]: value }, values, "The fact", { hint })];
      }
      if (!chosen) return [select];
      const hint = chosen.vector ? "such as 4i + 2j" : chosen.angle ? "such as 90°" : null;
      return [select, field({ [values]: value }, values, "is equal to", { hint })];
    });
    const another = button("Another fact", () => {
      told.known.push({ what: "", value: "" });
      show({ name: `what${told.known.length - 1}` });
    });
    const full = told.known.at(-1).what !== "";
    return group("What else is known", ...rows.flat(), full ? another : null);
  }

  function askedFields(told) {
    const offered = quantitiesOf(told);
    const boxes = offered.map(({ item, label }) => {
      const checked = told.asked.includes(item);
      return html("label", { class: "box" },
        html("input", { type: "checkbox", name: "asked", value: item, checked }),
        html("span", {}, label));
    });
    const made = group("What is to be found?",
      html("div", { class: "boxes" }, ...boxes),
      html("p", { class: "problem", id: "problem-asked" }),
      field(told, "letters", "Letters to be found", { hint: "such as alpha, k" }));
    made.classList.add("asked");
    made.dataset.offered = offered.map((each) => each.item).join();
    return made;
  }
}

const WAYS = [
  ["i", "along i"], ["j", "along j"], ["vector", "along another vector"], ["angle", "at an angle"],
];

const group = (legend, ...inside) => html("fieldset", {}, html("legend", {}, legend), ...inside);
const row = (...fields) => html("div", { class: "row" }, ...fields);

function field(told, name, label, { hint = null, optional = false } = {}) {
  const id = `form-${name}`;
  const described = [hint && `hint-${name}`, `problem-${name}`].filter(Boolean).join(" ");
  return html("div", { class: "field" },
    html("label", { for: id }, label,
      optional ? html("span", { class: "quiet" }, " (if told)") : null),
    html("input", {
      id, name, type: "text", value: told[name], maxlength: 80, spellcheck: "false",
      autocapitalize: "off", autocomplete: "off", "aria-describedby": described,
    }),
    hint ? html("p", { class: "hint", id: `hint-${name}` }, hint) : null,
    html("p", { class: "problem", id: `problem-${name}` }));
}

function choice(told, name, label, ways) {
  const id = `form-${name}`;
  return html("div", { class: "field" },
    html("label", { for: id }, label),
    html("select", { id, name }, ways.map(([value, said]) =>
      html("option", { value, selected: told[name] === value }, said))));
}
