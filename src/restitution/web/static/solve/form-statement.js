// What is filled in, as a statement. Nothing here knows of the page: answers in, text out.
//
// A line is a list of pieces, each a text or [field, text], so that a mistake in it can be shown
// at the field that it came from.

export const KINDS = [
  ["wall", "One wall"],
  ["walls", "Two walls"],
  ["spheres", "Two spheres"],
  ["chain", "Spheres, then a wall"],
];

const EVENTS = {
  wall: [["P", "W"]],
  walls: [["P", "AB"], ["P", "BC"]],
  spheres: [["A", "B"]],
  chain: [["A", "B"], ["B", "W"]],
};
const TIMES = ["after the first impact", "after the second impact"];

export const spheresOf = ({ kind }) => (kind === "wall" || kind === "walls" ? ["P"] : ["A", "B"]);
export const eventsOf = ({ kind }) => EVENTS[kind];

// A question of each kind that can be solved as it stands.
export function defaultsOf(kind) {
  const moving = { Mass: "2", Velocity: "components", X: "5", Y: "-3", Speed: "u", Angle: "60°" };
  const own = (name, values) => {
    const told = Object.entries({ ...moving, ...values });
    return Object.fromEntries(told.map(([key, value]) => [name + key, value]));
  };
  const shared = { kind, known: [{ what: "", value: "" }], letters: "", e1: "1/2", e2: "1/2" };
  const wall = { wall: "i", wallVector: "3i + 4j", wallAngle: "30°" };
  const spheres = {
    ...own("A", { X: "3", Y: "-4" }), ...own("B", { Mass: "3", X: "2", Y: "3" }),
    line: "j", lineVector: "3i + 4j", lineAngle: "30°", offset: "r", radius: "r", e1: "3/7",
  };
  switch (kind) {
    case "wall":
      return { ...shared, ...wall, ...own("P"), asked: ["velocity(P)", "impulse", "energy_lost"] };
    case "walls":
      return {
        ...shared, first: "i", firstAngle: "30°", second: "between", between: "120°",
        secondVector: "3i + 4j", secondAngle: "60°", ...own("P", { Mass: "", Velocity: "wall" }),
        asked: ["speed(P, 1)", "speed(P)"],
      };
    case "spheres":
      return { ...shared, ...spheres, asked: ["velocity(A)", "velocity(B)", "impulse"] };
    case "chain":
      return {
        ...shared, ...spheres, ...wall,
        ...own("A", { X: "4", Y: "0" }), ...own("B", { Mass: "3", Velocity: "rest" }),
        line: "i", wall: "j", e1: "1/2",
        asked: ["velocity(A, 1)", "velocity(B)", "total_energy_lost"],
      };
  }
}

// Quantities that can be asked for, or known afterwards; `fixed` ones can only be asked for.
export function quantitiesOf(answers) {
  const events = eventsOf(answers);
  const found = [];
  const put = (item, label, rest = {}) => found.push({ item, label, ...rest });
  events.forEach(([first, second], index) => {
    const last = index === events.length - 1;
    const stage = last ? "" : `, ${index + 1}`;
    const when = events.length === 1 ? "afterwards" : TIMES[index];
    const bodies = spheresOf(answers).includes(second) ? [first, second] : [first];
    for (const body of bodies) {
      put(`velocity(${body}${stage})`, `velocity of ${body} ${when}`, { vector: true });
      put(`speed(${body}${stage})`, `speed of ${body} ${when}`);
    }
    if (bodies.length === 1) {
      const label = `angle of ${first}’s path to ${second} ${when}`;
      put(`angle(velocity(${first}${stage}), ${second})`, label, { angle: true });
    }
    for (const body of bodies) {
      if (index > 0 || answers[`${body}Velocity`] !== "rest") {
        const which = events.length === 1 ? "" : last ? ", second impact" : ", first impact";
        const label = `angle of deflection of ${body}${which}`;
        put(`deflection(${body}${stage})`, label, { angle: true });
      }
    }
    const number = last ? "" : `(${index + 1})`;
    const ordinal = last ? "second" : "first";
    const which = events.length === 1 ? "" : ` at the ${ordinal} impact`;
    put(`impulse${number}`, `magnitude of the impulse${which}`);
    put(`energy_lost${number}`, `kinetic energy lost${which}`);
  });
  const total = events.length === 1 ? "energy_lost" : "total_energy_lost";
  if (events.length > 1) put(total, "kinetic energy lost in all");
  const share = `${total}/energy(0) as a percentage`;
  put(share, "kinetic energy lost, as a percentage", { fixed: true });
  const es = events.map((_, index) => clean(answers[`e${index + 1}`]));
  if (es.includes("")) put("e", "coefficient of restitution e", { fixed: true });
  for (const body of spheresOf(answers)) {
    if (!clean(answers[`${body}Mass`])) put(`mass(${body})`, `mass of ${body}`, { fixed: true });
    if (answers[`${body}Velocity`] === "unknown") {
      put(`velocity(${body}, 0)`, `velocity of ${body} before`, { fixed: true });
    }
  }
  if (answers.line === "unknown" || answers.line === "offset") {
    put("line_of_centres(1)", "line of centres", { fixed: true });
  }
  if (answers.wall === "unknown") put("direction(W)", "direction of the wall", { fixed: true });
  return found;
}

// What else may be known, that is no quantity with a value.
export function factsOf(answers) {
  const found = [];
  if (spheresOf(answers).length > 1) {
    found.push([
      "velocity(A, 1) perpendicular to velocity(B, 1)",
      "A and B move at right angles after their impact",
    ]);
    for (const body of ["A", "B"]) {
      const label = `${body} is at rest after the impact of the spheres`;
      found.push([`velocity(${body}, 1) = 0i`, label]);
    }
  }
  if (answers.kind === "chain") {
    found.push(["A and B collide again", "A and B collide again"]);
    found.push(["A and B do not collide again", "A and B do not collide again"]);
  }
  return found;
}

const SIGNS = /[#:\\\n]/;
const UNITS = /\d\s*(kg|m ?\/ ?s|m ?s ?(\^ ?-? ?1|⁻¹)|N ?s|J|rad)\s*$/;

// Why a field cannot go into a statement as it is, or null.
export function objection(text) {
  if (SIGNS.test(text ?? "")) {
    return "Leave out the signs # : and \\, which mean something else in a statement.";
  }
  if (UNITS.test(text ?? "")) return "Leave out the unit: all is in kg, m/s, N s and J.";
  return null;
}

const clean = (text) => (objection(text) ? "" : (text ?? "").trim());
// A number alone is meant in degrees; the language would read it in radians.
const angle = (text) => (/^\d+(\.\d+)?$/.test(clean(text)) ? `${clean(text)}°` : clean(text));

// Whether a text has a plus or minus outside brackets.
function isSum(text) {
  let depth = 0;
  for (const sign of text) {
    if (sign === "(") depth += 1;
    else if (sign === ")") depth -= 1;
    else if (depth === 0 && "+-−".includes(sign)) return true;
  }
  return false;
}

function component(text) {
  const size = text.replace(/^[-−]\s*/, "");
  // −a + b is not −(a + b): a sum goes into brackets whole, with its sign.
  return isSum(size) ? { negative: false, size: `(${text})` } : { negative: size !== text, size };
}

function along(size, axis) {
  if (size === "1") return axis;
  return /^[\d.]+$/.test(size) ? size + axis : `${size} ${axis}`;
}

// The pieces of a velocity, or [] where it is not known.
function velocity(answers, body, notes) {
  const told = (key) => clean(answers[body + key]);
  const [x, y, speed, turned] = ["X", "Y", "Speed", "Angle"].map(told);
  switch (answers[`${body}Velocity`]) {
    case "rest":
      return ["at rest"];
    case "components": {
      const both = [["X", x, "i"], ["Y", y, "j"]];
      const shown = both.filter(([, text]) => text !== "" && text !== "0");
      if (shown.length === 0) return x === "" && y === "" ? [] : ["velocity ", [`${body}X`, "0i"]];
      const pieces = shown.map(([key, text, axis], index) => {
        const { negative, size } = component(text);
        const sign = index === 0 ? (negative ? "-" : "") : negative ? " - " : " + ";
        return [body + key, sign + along(size, axis)];
      });
      return ["velocity ", ...pieces];
    }
    case "speed":
    case "wall": {
      if (speed === "" || turned === "") {
        const field = body + (speed === "" ? "Speed" : "Angle");
        notes.push([field, "Fill this in too, with a letter if it is not known."]);
        return [];
      }
      const [[, struck]] = eventsOf(answers);
      const towards = answers[`${body}Velocity`] === "wall" ? ` to ${struck}` : "";
      const turn = [`${body}Angle`, angle(turned) + towards];
      return ["velocity ", [`${body}Speed`, speed], " at ", turn];
    }
  }
  return [];
}

function direction(mode, answers, prefix, notes) {
  if (mode === "i" || mode === "j") return [`along ${mode}`];
  if (mode !== "vector" && mode !== "angle") return [];
  const field = prefix + (mode === "vector" ? "Vector" : "Angle");
  const text = mode === "vector" ? clean(answers[field]) : angle(answers[field]);
  if (text === "") {
    notes.push([field, "Fill this in, or choose another way to say it."]);
    return [];
  }
  return ["along ", [field, text]];
}

// Properties behind a colon, with commas; without any the colon falls away.
function line(head, properties) {
  const told = properties.filter((each) => each.length > 0);
  return [head, ...told.flatMap((each, index) => [index === 0 ? ": " : ", ", ...each])];
}

function walls(answers, notes) {
  if (answers.kind === "walls") {
    const first = direction(answers.first, answers, "first", notes);
    if (answers.second !== "between") {
      const second = direction(answers.second, answers, "second", notes);
      return [line("wall AB", [first]), line("wall BC", [second])];
    }
    const turned = angle(answers.firstAngle);
    const start = { i: "", j: "90° + ", angle: turned && `${turned} + ` }[answers.first];
    const between = angle(answers.between);
    if (between === "") notes.push(["between", "Fill in the angle between the walls."]);
    const whole = ["between", isSum(between) ? `(${between})` : between];
    const second = between === "" ? [] : [`along ${start}180° - `, whole];
    return [line("wall AB", [first]), line("wall BC", [second])];
  }
  if (answers.wall === undefined) return [];
  return [line("wall W", [direction(answers.wall, answers, "wall", notes)])];
}

function impact(answers, index, notes) {
  const [first, second] = eventsOf(answers)[index];
  const e = clean(answers[`e${index + 1}`]);
  const properties = [];
  if (index === 0 && answers.line !== undefined) {
    const apart = clean(answers.offset);
    if (answers.line !== "offset") properties.push(direction(answers.line, answers, "line", notes));
    else if (apart === "") notes.push(["offset", "Fill in the distance between the paths."]);
    else properties.push(["offset ", ["offset", apart]]);
  }
  if (e !== "") properties.push(["e = ", [`e${index + 1}`, e]]);
  return line(`${first} hits ${second}`, properties);
}

function known(answers, notes) {
  const quantities = new Map(quantitiesOf(answers).map((each) => [each.item, each]));
  const facts = new Set(factsOf(answers).map(([fact]) => fact));
  return answers.known.flatMap(({ what, value }, index) => {
    const field = `known${index}`;
    if (facts.has(what)) return [["given ", [field, what]]];
    const text = quantities.get(what)?.angle ? angle(value) : clean(value);
    if (what !== "fact" && !quantities.has(what)) return [];
    if (text === "") {
      notes.push([field, "Fill in what it is."]);
      return [];
    }
    return [what === "fact" ? ["given ", [field, text]] : [`given ${what} = `, [field, text]]];
  });
}

// The lines, and notes [field, text] on what is still missing.
export function linesOf(answers) {
  const notes = [];
  const lines = walls(answers, notes);
  for (const body of spheresOf(answers)) {
    const mass = clean(answers[`${body}Mass`]);
    const radius = answers.line === "offset" ? clean(answers.radius) : "";
    if (answers.line === "offset" && radius === "") {
      notes.push(["radius", "An offset needs the radius of the spheres."]);
    }
    lines.push(line(`sphere ${body}`, [
      mass ? ["mass ", [`${body}Mass`, mass]] : [],
      velocity(answers, body, notes),
      radius ? ["radius ", ["radius", radius]] : [],
    ]));
  }
  eventsOf(answers).forEach((_, index) => lines.push(impact(answers, index, notes)));
  lines.push(...known(answers, notes));
  const offered = quantitiesOf(answers).map(({ item }) => item);
  const asked = offered.filter((item) => answers.asked.includes(item));
  const letters = clean(answers.letters);
  // A percentage goes with all that stands before it on its line, so it has a line to itself.
  const alone = asked.filter((item) => item.endsWith("percentage"));
  const together = asked.filter((item) => !alone.includes(item));
  if (together.length > 0) lines.push([["asked", `find ${together.join(", ")}`]]);
  for (const item of alone) lines.push([["asked", `find ${item}`]]);
  if (letters) lines.push(["find ", ["letters", letters]]);
  if (asked.length === 0 && !letters) notes.push(["asked", "Choose at least one thing to find."]);
  return { lines, notes };
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
