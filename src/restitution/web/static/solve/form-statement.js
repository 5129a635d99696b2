// What is filled in, as a statement. Nothing here knows of the page: answers in, text out.
//
// A line is a list of pieces, each a text or [field, text], so that a mistake in it can be shown
// at the field that it came from.

import { bracketed, inDegrees, isSum, plainDegrees } from "./form-angle.js";
import { askedOf, countOf, eventsOf, isAway, isPlainWho, nameOf, spheresOf } from "./form-model.js";
import { objection } from "./form-objections.js";
import { factsOf, isPercentage, PERCENT, quantitiesOf } from "./form-quantities.js";

const FILL = "Fill this in, with a letter if it is not known.";
const CALLED = /(?:sqrt|√|sin|cos|tan|cot|sec|abs)(?!\s*\()|[*/^]\s*$/;
// A unit behind a number is judged as one where it ends what stands in brackets.
const MEASURED = /[\d)]\s*(?:kg|[kcm]?m\s*\/|ms|m\s*s|[kcm]m|N\s*s|rad\b)/;
const measured = (text) => (MEASURED.test(text) ? `(${text})` : text);

// Reads the fields: what is in them, what is missing, and what cannot stand in a statement.
function reader(answers) {
  const missing = [];
  const wrong = [];
  const read = (text, field, kind) => {
    const typed = (text ?? "").trim();
    const said = typed && objection(typed, kind);
    if (said) wrong.push([field, said]);
    return typed;
  };
  return {
    missing,
    wrong,
    miss: (field, text = FILL) => missing.push([field, text]),
    blame: (field, text) => wrong.push([field, text]),
    optional: (field, kind = "number") => read(answers[field], field, kind),
    // What has to be there: it is asked for where it is not.
    needed(field, kind = "number", text = answers[field]) {
      const typed = read(text, field, kind);
      if (typed === "") missing.push([field, FILL]);
      return typed;
    },
  };
}

function component(text) {
  const size = text.replace(/^[-−–]\s*/, "");
  // −a + b is not −(a + b): a sum goes into brackets whole, with its sign.
  if (size === "" || isSum(size)) return { negative: false, size: `(${text})` };
  // `sin 2` before i would be the sine of 2i.
  const whole = CALLED.test(size) ? `(${size})` : measured(size);
  return { negative: size !== text, size: whole };
}

function along(size, axis) {
  if (size === "1") return axis;
  return /^[\d.]+$/.test(size) ? size + axis : `${size} ${axis}`;
}

function components(answers, role, fields) {
  const both = [["X", "i"], ["Y", "j"]];
  const typed = both.map(([key, axis]) =>
    [role + key, fields.needed(role + key, "component"), axis]);
  if (typed.some(([, text]) => text === "")) return [];
  const shown = typed.filter(([, text]) => !/^0(\.0*)?$/.test(text));
  if (shown.length === 0) return ["velocity ", [`${role}X`, "0i"]];
  return ["velocity ", ...shown.map(([field, text, axis], index) => {
    const { negative, size } = component(text);
    const sign = index === 0 ? (negative ? "-" : "") : negative ? " - " : " + ";
    return [field, sign + along(size, axis)];
  })];
}

// Speed and angle as pieces of a vector; `behind` names what the angle is measured from.
function polar(fields, [speedField, speed], [angleField, angle], behind = "") {
  const size = fields.needed(speedField, "size", speed);
  const turned = fields.needed(angleField, "angle", angle);
  if (size === "" || turned === "") return [];
  if (behind && /\b(from|to)\b/.test(turned)) {
    fields.blame(angleField, "Leave out what the angle is measured from: it is chosen already.");
  }
  const text = inDegrees(turned);
  return [[speedField, size], " at ", [angleField, behind ? measured(text) : text], behind];
}

// The angle to the line of centres as one from a direction: that of the line, first to second, or
// the contrary one, from which the left of the line lies clockwise.
function turnedFromLine(answers, way, role, typed) {
  const [sense, side] = way.split("-");
  const isOnwards = (sense === "towards") === (role === "A");
  const angle = inDegrees(typed);
  const isPositive = (side === "left") === isOnwards;
  const turned = isPositive ? angle : `-${bracketed(angle)}`;
  switch (answers.line) {
    case "i":
      return isOnwards ? turned : `${turned} from -i`;
    case "angle": {
      const start = inDegrees(answers.lineAngle.trim()) + (isOnwards ? "" : " + 180°");
      return `${start} ${isPositive ? `+ ${angle}` : turned.replace("-", "- ")}`;
    }
    default: {
      const origin = answers.line === "j" ? "j" : `(${answers.lineVector.trim()})`;
      return `${turned} from ${isOnwards ? "" : "-"}${origin}`;
    }
  }
}

function toLine(answers, fields, role, way, [speedField, speed], [angleField, angle]) {
  if (answers.line === "unknown" || answers.line === "offset") {
    fields.miss("line",
      "An angle to the line of centres needs its direction: along i, if none is told.");
    return [];
  }
  const size = fields.needed(speedField, "size", speed);
  const turned = fields.needed(angleField, "number", angle);
  const bad = turned && objection(turned, "acute");
  if (bad) fields.blame(angleField, bad);
  if (size === "" || turned === "") return [];
  return [[speedField, size], " at ", [angleField, turnedFromLine(answers, way, role, turned)]];
}

// The pieces of a velocity, or [] where it is not known.
function velocity(answers, role, fields) {
  const [speed, angle] = ["Speed", "Angle"].map((key) => [role + key, answers[role + key]]);
  const put = (pieces) => (pieces.length ? ["velocity ", ...pieces] : []);
  switch (answers[`${role}Velocity`]) {
    case "rest":
      return ["at rest"];
    case "components":
      return components(answers, role, fields);
    case "vector": {
      const typed = fields.needed(`${role}Vector`, "vector");
      const [size, turned] = typed.split(/\s+at\s+/);
      const text = turned === undefined ? typed : `${size} at ${inDegrees(turned)}`;
      return put(typed && [[`${role}Vector`, text]]);
    }
    case "speed":
      return put(polar(fields, speed, angle));
    case "wall":
      return put(polar(fields, speed, angle, ` to ${nameOf(answers, eventsOf(answers)[0][1])}`));
    case "line":
      return put(toLine(answers, fields, role, answers[`${role}Way`], speed, angle));
  }
  return [];
}

// A sum of decimals without what binary fractions add to it.
const exactly = (value) => String(Number(value.toFixed(9)));

function direction(mode, fields, prefix) {
  if (mode === "i" || mode === "j") return [`along ${mode}`];
  if (mode === "vector") {
    const text = fields.needed(`${prefix}Vector`, "vector");
    return text && ["along ", [`${prefix}Vector`, text]];
  }
  if (mode === "angle") {
    const text = fields.needed(`${prefix}Angle`, "number");
    return text && ["along ", [`${prefix}Angle`, inDegrees(text)]];
  }
  return [];
}

// Properties behind a colon, with commas; without any the colon falls away.
function line(head, properties) {
  const shown = properties.filter((each) => each.length > 0);
  return [head, ...shown.flatMap((each, index) => [index === 0 ? ": " : ", ", ...each])];
}

function walls(answers, fields) {
  const head = (role) => `wall ${nameOf(answers, role)}`;
  if (answers.kind !== "walls") {
    if (answers.wall === undefined) return [];
    return [line(head("W"), [direction(answers.wall, fields, "wall")])];
  }
  const first = line(head("AB"), [direction(answers.first, fields, "first")]);
  if (answers.second !== "between") {
    return [first, line(head("BC"), [direction(answers.second, fields, "second")])];
  }
  const between = inDegrees(fields.needed("between"));
  const turned = inDegrees(answers.firstAngle.trim());
  const start = { i: "", j: "90° + ", angle: turned && `${turned} + ` }[answers.first];
  if (start === undefined) {
    fields.miss("second", "Choose how BC runs: beside a wall along a vector it has a direction.");
  }
  const begins = { i: 0, j: 90, angle: plainDegrees(turned) }[answers.first];
  const numbers = [begins, plainDegrees(between)];
  const sum = numbers.includes(null)
    ? `${start}180° - ${bracketed(between)}` : `${exactly(numbers[0] + 180 - numbers[1])}°`;
  const second = between ? ["along ", ["between", sum]] : [];
  return [first, line(head("BC"), [second])];
}

function impact(answers, index, fields) {
  const [first, second] = eventsOf(answers)[index].map((role) => nameOf(answers, role));
  const properties = [];
  if (index === 0 && answers.line !== undefined) {
    if (answers.line === "offset") {
      const apart = fields.needed("offset");
      properties.push(apart && ["offset ", ["offset", apart]]);
    } else properties.push(direction(answers.line, fields, "line"));
    if (isPlainWho(answers) && isAway(answers, "A") && isAway(answers, "B")) {
      fields.blame("BWay", "Both move away from each other: they cannot meet.");
    }
  }
  const e = fields.optional(`e${index + 1}`);
  if (e !== "") properties.push(["e = ", [`e${index + 1}`, e]]);
  return line(`${first} hits ${second}`, properties);
}

// What a value of a quantity is, as it goes into the statement.
function valued(quantity, typed, field, fields, kind = null) {
  const wanted = quantity?.percent ? "percentage"
    : quantity?.vector ? "vector" : quantity?.angle ? "angle" : "number";
  const said = typed && objection(typed, kind ?? wanted);
  if (said) fields.blame(field, said);
  if (quantity?.angle) return inDegrees(typed);
  if (quantity?.percent && !typed.includes("%")) return `${typed}%`;
  return typed;
}

function known(answers, fields) {
  const quantities = new Map(quantitiesOf(answers).map((each) => [each.key, each]));
  const facts = new Set(factsOf(answers).map(({ key }) => key));
  return answers.known.flatMap(({ what, value, speed, angle, way }, index) => {
    const field = `known${index}`;
    if (what === "") return [];
    if (facts.has(what)) return [["given ", [field, what]]];
    const [, mode, of] = /^(polar|line) (.*)$/.exec(what) ?? [];
    if (mode) {
      const quantity = quantities.get(of);
      if (!quantity) return [];
      const both = [[`${field}speed`, speed], [`${field}angle`, angle]];
      const role = spheresOf(answers).find((each) => of.includes(`(${nameOf(answers, each)},`));
      const pieces = mode === "polar"
        ? polar(fields, ...both) : toLine(answers, fields, role, way, ...both);
      return pieces.length ? [[`given ${quantity.item} = `, ...pieces]] : [];
    }
    const quantity = quantities.get(what);
    if (what !== "fact" && !quantity) return [];
    const typed = value.trim();
    if (typed === "") {
      fields.miss(field);
      return [];
    }
    const text = valued(quantity, typed, field, fields, what === "fact" ? "fact" : null);
    const head = what === "fact" ? "given " : `given ${quantity.item} = `;
    return [[head, [field, text]]];
  });
}

function shown(answers, fields) {
  const quantities = new Map(quantitiesOf(answers).map((each) => [each.key, each]));
  const facts = new Set(factsOf(answers).map(({ key }) => key));
  return answers.shows.flatMap(({ what, sign, value }, index) => {
    const field = `shown${index}`;
    if (what === "") return [];
    if (facts.has(what)) return [["show ", [field, what]]];
    const quantity = quantities.get(what);
    if (what !== "relation" && !quantity) return [];
    const typed = value.trim();
    if (typed === "") {
      fields.miss(field, "Fill in what is to be shown.");
      return [];
    }
    if (what === "relation") {
      const said = objection(typed, "fact");
      if (said) fields.blame(field, said);
      return [["show ", [field, typed]]];
    }
    const text = valued(quantity, typed, field, fields, quantity.percent ? null : "shown");
    return [[`show ${quantity.item} ${sign} `, [field, text]]];
  });
}

function found(answers, fields) {
  const offered = quantitiesOf(answers);
  const ticked = askedOf(answers);
  const asked = offered.filter(({ key }) => ticked.includes(key));
  const also = fields.optional("also", "items");
  const letters = fields.optional("terms", "items");
  const terms = letters ? [" in terms of ", ["terms", letters]] : [];
  const lines = [];
  // A percentage goes with all that stands before it on its line, so it has a line to itself.
  const together = asked.filter(({ key }) => !isPercentage(key)).map(({ item }) => item);
  if (together.length) lines.push([["asked", `find ${together.join(", ")}`], ...terms]);
  for (const { item, key } of asked) {
    if (isPercentage(key)) lines.push([["asked", `find ${item}${PERCENT}`], ...terms]);
  }
  if (also) lines.push(["find ", ["also", also], ...terms]);
  return lines;
}

// The lines, what is `missing`, and what is `wrong`, both as [field, text].
export function linesOf(answers) {
  const fields = reader(answers);
  const title = fields.optional("title", "title");
  const lines = title ? [["title ", ["title", title]]] : [];
  lines.push(...walls(answers, fields));
  const radius = answers.line === "offset" ? fields.needed("radius") : "";
  for (const role of spheresOf(answers)) {
    const mass = fields.optional(`${role}Mass`);
    lines.push(line(`sphere ${nameOf(answers, role)}`, [
      mass ? ["mass ", [`${role}Mass`, mass]] : [],
      velocity(answers, role, fields),
      radius ? ["radius ", ["radius", radius]] : [],
    ]));
  }
  for (let index = 0; index < countOf(answers); index += 1) {
    lines.push(impact(answers, index, fields));
  }
  lines.push(...known(answers, fields));
  const unknown = fields.optional("unknown", "items");
  if (unknown) lines.push(["unknown ", ["unknown", unknown]]);
  const finds = found(answers, fields);
  const shows = shown(answers, fields);
  lines.push(...finds, ...shows);
  if (finds.length + shows.length === 0) fields.miss("asked", "Choose at least one thing to find.");
  return { lines, missing: fields.missing, wrong: fields.wrong };
}

const textOf = (pieces) =>
  pieces.map((piece) => (typeof piece === "string" ? piece : piece[1])).join("");

export const statementOf = (answers) =>
  linesOf(answers).lines.map((pieces) => `${textOf(pieces)}\n`).join("");

// The field that wrote what stands at a place of the statement (both counted from 1), or null.
export function fieldAt(answers, lineNumber, column) {
  const pieces = linesOf(answers).lines[lineNumber - 1];
  if (!pieces) return null;
  let end = 0;
  let nearest = null;
  for (const piece of pieces) {
    end += textOf([piece]).length;
    if (typeof piece !== "string") nearest = piece[0];
    if (column <= end && nearest) return nearest;
  }
  return nearest;
}
