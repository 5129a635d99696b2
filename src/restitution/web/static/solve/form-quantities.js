// What can be asked for, known or shown of the bodies of a form: quantities, and facts.

import { countOf, eventsOf, nameOf, spheresOf } from "./form-model.js";

// The quantities of bodies that the language has, by their records, but for those below.
let records = [];
let alone = /(?!)/;
const WORDED = new Set(["velocity", "speed", "deflection"]);

export function learn(words) {
  records = words.offered.filter(({ word }) => !WORDED.has(word));
  const standing = words.quantities.filter((each) => each.alone).map(({ word }) => word);
  alone = new RegExp(`\\b(${standing.join("|")})\\b`);
}

// Whether a text speaks of the motion, by a quantity with brackets or one that stands alone.
export const speaksOfMotion = (text) => {
  const plain = text.replace(/(sqrt|arc(sin|cos|tan)|cosec)\(/g, "(");
  return /[a-z_]{4,}\(/.test(plain) || alone.test(plain);
};

const TIMES = ["after the first impact", "after the second impact"];

// Quantities as { item, key, label, group }: `item` as a statement has it after the last event,
// `key` with every stage told by its number. `vector`, `angle` and `percent` say what their value
// is; `fixed` ones can only be asked for, `fact` ones only be known or shown.
export function quantitiesOf(answers) {
  const count = countOf(answers);
  const found = [];
  // `write(stage, alone)` puts in the stage behind an argument, or alone in brackets.
  const put = (n, write, label, group, rest = {}) => found.push({
    item: n === count ? write("", "") : write(`, ${n}`, `(${n})`),
    key: write(`, ${n}`, `(${n})`), label, group, ...rest,
  });
  eventsOf(answers).forEach(([first, second], index) => {
    const n = index + 1;
    const [a, b] = [first, second].map((role) => nameOf(answers, role));
    const when = count === 1 ? "afterwards" : TIMES[index];
    const spheres = [first, second].filter((role) => spheresOf(answers).includes(role));
    for (const role of [...spheres].sort()) {
      const body = nameOf(answers, role);
      const group = `${body} ${when}`;
      const of = (quantity) => `${quantity} of ${group}`;
      put(n, (s) => `velocity(${body}${s})`, of("velocity"), group, { vector: true });
      put(n, (s) => `speed(${body}${s})`, of("speed"), group);
      put(n, (s) => `direction(${body}${s})`, `direction of ${group}, from i`, group,
        { angle: true });
      if (spheres.length === 1) {
        put(n, (s) => `angle(velocity(${body}${s}), ${b})`,
          `angle of ${body}’s path to ${b} ${when}`, group, { angle: true });
      } else {
        const line = (s) => `line_of_centres${s}`;
        put(n, (s, p) => `angle(velocity(${body}${s}), ${line(p)})`,
          `angle of ${body}’s path with the line of centres ${when}`, group, { angle: true });
        put(n, (s, p) => `along(velocity(${body}${s}), ${line(p)})`,
          `component of ${body} along the line of centres, from ${a} to ${b} positive, ${when}`,
          group);
        put(n, (s, p) => `across(velocity(${body}${s}), ${line(p)})`,
          `component of ${body} across the line of centres, to its left positive, ${when}`,
          group);
      }
      if (index > 0 || answers[`${role}Velocity`] !== "rest") {
        const where = count === 1 ? "" : `at the ${ORDINAL[index]} impact `;
        put(n, (s) => `deflection(${body}${s})`,
          `angle through which ${body} is turned ${where}(deflection)`, group, { angle: true });
      }
    }
    const which = count === 1 ? "" : ` at the ${ORDINAL[index]} impact`;
    for (const record of records) {
      const names = spheres.map((role) => nameOf(answers, role)).sort();
      const of = record.bodies === 1 ? names.map((body) => [body]) : [names];
      for (const bodies of of.filter(({ length }) => length === record.bodies)) {
        const key = record.key.replace(/\b(ONE|OTHER|EARLY|LATE)\b/g, (mark) =>
          ({ ONE: bodies[0], OTHER: bodies[1], EARLY: n - 1, LATE: n })[mark]);
        const said = `${record.noun} ${bodies.join(" and ")}`;
        put(n, (s) => `${record.word}(${bodies.join(", ")}${s})`,
          record.in_event ? `${said}${which}` : `${said} ${when}`, `${bodies.join(", ")} ${when}`,
          { key, vector: record.vector, angle: record.angle });
      }
    }
    const group = count === 1 ? "The impact" : `The ${ORDINAL[index]} impact`;
    put(n, (_, p) => `impulse${p}`, `magnitude of the impulse${which}`, group);
    put(n, (_, p) => `energy_lost${p}`, `kinetic energy lost${which}`, group);
  });
  const energy = "Kinetic energy";
  const total = (p) => (count === 1 ? `energy_lost${p}` : `total_energy_lost${p}`);
  if (count > 1) put(count, (_, p) => total(p), "kinetic energy lost in all", energy);
  const shares = [
    ["lost", (_, p) => `${total(p)}/energy(0)`], ["left", (_, p) => `energy${p}/energy(0)`],
  ];
  for (const [kept, write] of shares) {
    put(count, write, `kinetic energy ${kept}, as a percentage of that before`, energy,
      { percent: true });
    put(count, write, `kinetic energy ${kept}, as a fraction of that before`, energy);
  }
  for (const each of found) {
    if (each.percent) each.key += PERCENT;
  }
  return [...found, ...fixed(answers)];
}

const ORDINAL = ["first", "second"];
// What marks a share told in per cent: the same quantity is there as a fraction.
export const PERCENT = " as a percentage";
export const isPercentage = (key) => key.endsWith(PERCENT);

// What can be asked for only where it is not told.
function fixed(answers) {
  const found = [];
  const put = (item, label) =>
    found.push({ item, key: item, label, group: "What is not told", fixed: true });
  const es = eventsOf(answers).map((_, index) => (answers[`e${index + 1}`] ?? "").trim());
  if (es.includes("")) put("e", "coefficient of restitution e");
  for (const role of spheresOf(answers)) {
    const body = nameOf(answers, role);
    if (!(answers[`${role}Mass`] ?? "").trim()) put(`mass(${body})`, `mass of ${body}`);
    if (answers[`${role}Velocity`] === "unknown") {
      put(`velocity(${body}, 0)`, `velocity of ${body} before`);
      put(`speed(${body}, 0)`, `speed of ${body} before`);
    }
  }
  if (answers.line === "unknown" || answers.line === "offset") {
    put("line_of_centres(1)", "line of centres");
  }
  if (answers.wall === "unknown") {
    put(`direction(${nameOf(answers, "W")})`, "direction of the wall");
  }
  return found;
}

// What else may be known or shown, that is no quantity with a value.
export function factsOf(answers) {
  const found = [];
  const put = (key, label) => found.push({ key, label, group: "Directions and the like" });
  const spheres = spheresOf(answers).map((role) => nameOf(answers, role));
  if (spheres.length > 1) {
    const [a, b] = spheres;
    const [v, w] = spheres.map((body) => `velocity(${body}, 1)`);
    put(`${v} perpendicular to ${w}`, `${a} and ${b} move at right angles after their impact`);
    put(`${v} parallel to ${w}`, `${a} and ${b} move along parallel lines after their impact`);
    spheres.forEach((body, index) => {
      const after = [v, w][index];
      const role = spheresOf(answers)[index];
      if (answers[`${role}Velocity`] !== "rest") {
        put(`${after} perpendicular to velocity(${body}, 0)`,
          `${body} moves at right angles to its first direction after the impact`);
      }
      put(`${after} perpendicular to line_of_centres(1)`,
        `${body} moves at right angles to the line of centres after the impact`);
      put(`${after} = 0i`, `${body} is at rest after the impact of the spheres`);
    });
    if (answers.kind === "chain") {
      put(`${a} and ${b} collide again`, `${a} and ${b} collide again`);
      put(`${a} and ${b} do not collide again`, `${a} and ${b} do not collide again`);
    }
  } else {
    const [p] = spheres;
    const count = countOf(answers);
    const when = count === 1 ? "afterwards" : "in the end";
    put(`velocity(${p}, ${count}) perpendicular to velocity(${p}, 0)`,
      `${p} moves at right angles to its first direction ${when}`);
    if (count > 1) {
      put(`velocity(${p}, ${count}) opposite to velocity(${p}, 0)`,
        `${p} moves opposite to its first direction ${when}`);
    }
  }
  return found;
}
