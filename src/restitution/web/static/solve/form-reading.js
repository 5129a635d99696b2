// A statement that the server has taken apart, as the answers of a form, where a form can hold it.

import { countOf, emptyOf, eventsOf, noFact, noResult, spheresOf } from "./form-model.js";
import { factsOf, PERCENT, quantitiesOf, speaksOfMotion } from "./form-quantities.js";

// What a form has no field for: why, and the line where it stands.
class Beyond extends Error {
  constructor(said, line = null) {
    super(said);
    this.line = line;
  }
}

// { answers }, or { reason, line } where the form cannot hold all that the statement says.
export function answersOf(outline, text) {
  try {
    return { answers: read(outline, text) };
  } catch (error) {
    if (!(error instanceof Beyond)) throw error;
    return { reason: error.message, line: error.line };
  }
}

function read(outline, text) {
  text.split("\n").forEach((each, index) => {
    if (each.includes("#") && !/^\s*title\b/.test(each)) {
      throw new Beyond("the form keeps no comments", index + 1);
    }
  });
  if (outline.parts.length > 1) throw new Beyond("the form has no parts");
  if (outline.points.length) throw new Beyond("the form has no places");
  for (const body of [...outline.spheres, ...outline.walls]) {
    if (body.placed) throw new Beyond("the form has no places", body.line);
  }
  const impacts = outline.steps.filter(({ kind }) => kind === "impact");
  const answers = story(outline, impacts);
  answers.title = outline.title ?? "";
  for (const step of outline.steps) {
    const take = { impact: () => {}, given, unknown, find, show }[step.kind];
    if (!take) throw new Beyond("the form has no field for this line", step.line);
    take(answers, step);
  }
  answers.known.push(noFact());
  answers.shows.push(noResult());
  // A row that is empty stands at the end only.
  answers.known = [...answers.known.filter(({ what }) => what), noFact()];
  answers.shows = [...answers.shows.filter(({ what }) => what), noResult()];
  return answers;
}

function story(outline, impacts) {
  const isSphere = (name) => outline.spheres.some((each) => each.name === name);
  const shape = impacts.map(({ second }) => (isSphere(second) ? "s" : "w")).join("");
  const kind = { w: "wall", ww: "walls", s: "spheres", sw: "chain" }[shape];
  if (!kind) throw new Beyond("the form tells one or two impacts, each with a wall or a sphere");
  const answers = emptyOf(kind);
  const [one, two] = impacts;
  const names = {
    wall: () => ({ P: one.first, W: one.second }),
    walls: () => ({ P: one.first, AB: one.second, BC: two.second }),
    spheres: () => ({ A: one.first, B: one.second }),
    chain: () => {
      const turned = two.first === one.first;
      answers.order = turned ? "BA" : "AB";
      return { A: turned ? one.second : one.first, B: two.first, W: two.second };
    },
  }[kind]();
  answers.names = names;
  const told = new Set(Object.values(names));
  const bodies = [...outline.spheres, ...outline.walls];
  if (told.size !== bodies.length || bodies.some(({ name }) => !told.has(name))) {
    throw new Beyond("the form tells one or two impacts, of bodies that all take part");
  }
  if (impacts.some(({ first }) => !isSphere(first)) ||
      (kind === "walls" && one.first !== two.first) ||
      (kind === "chain" && two.first !== one.first && two.first !== one.second)) {
    throw new Beyond("the form tells other impacts", impacts.at(-1).line);
  }
  answers.asked = [];
  for (const role of spheresOf(answers)) {
    const sphere = outline.spheres.find(({ name }) => name === names[role]);
    answers[`${role}Mass`] = sphere.mass ?? "";
    velocity(answers, role, sphere.velocity);
  }
  const along = (prefix, given, line) => way(answers, prefix, given, line);
  if (kind === "walls") {
    for (const [prefix, role] of [["first", "AB"], ["second", "BC"]]) {
      const wall = outline.walls.find(({ name }) => name === names[role]);
      along(prefix, wall.along, wall.line);
      if (!wall.along) throw new Beyond("the form needs the directions of both walls", wall.line);
    }
  } else if (names.W) {
    const wall = outline.walls.find(({ name }) => name === names.W);
    along("wall", wall.along, wall.line);
  }
  const radii = new Set(outline.spheres.map(({ radius }) => radius).filter(Boolean));
  if (one.offset !== null) {
    answers.line = "offset";
    answers.offset = one.offset;
    if (radii.size > 1) throw new Beyond("the form has one radius for both spheres");
    answers.radius = [...radii][0] ?? "";
  } else if (radii.size) {
    const line = outline.spheres.find(({ radius }) => radius).line;
    throw new Beyond("the form has a radius only beside a distance between paths", line);
  } else if (answers.line !== undefined) along("line", one.along, one.line);
  impacts.forEach(({ e }, index) => (answers[`e${index + 1}`] = e ?? ""));
  return answers;
}

function velocity(answers, role, given) {
  const put = (key, value) => (answers[role + key] = value);
  const [[, struck]] = eventsOf(answers);
  if (given === null) put("Velocity", "unknown");
  else if (given.way === "rest") put("Velocity", "rest");
  else if (given.way === "components") {
    put("Velocity", "components");
    put("X", given.x);
    put("Y", given.y);
  } else if (given.way === "polar" && (!given.wall || given.wall === answers.names[struck])) {
    put("Velocity", given.wall ? "wall" : "speed");
    put("Speed", given.size);
    put("Angle", given.angle + (given.origin ? ` from ${given.origin}` : ""));
  } else {
    put("Velocity", "vector");
    put("Vector", given.text);
  }
  // A sphere before a wall cannot be at rest; the form offers it no such choice.
  if (given?.way === "rest" && spheresOf(answers).length === 1) {
    throw new Beyond("the form lets a sphere move towards its wall");
  }
}

function way(answers, prefix, given) {
  answers[prefix] = given === null ? "unknown" : given.way;
  if (given?.way === "vector") answers[`${prefix}Vector`] = given.text;
  if (given?.way === "angle") answers[`${prefix}Angle`] = given.text;
}

// What is said after the last event can be said where the form says it; else its stages tell.
const placed = (answers, step, each) => {
  const text = step.after === countOf(answers) ? each.text : each.staged;
  if (text === null) throw new Beyond("the form says this at the end only", step.line);
  return text;
};

function given(answers, step) {
  const quantities = quantitiesOf(answers);
  const facts = factsOf(answers);
  for (const relation of step.relations) {
    const text = placed(answers, step, relation);
    const fact = facts.find(({ key }) => key === (relation.staged ?? text));
    const quantity = relation.sign === "=" &&
      quantities.find(({ key, fixed }) => key === relation.left && !fixed);
    if (fact) answers.known.push({ ...noFact(), what: fact.key });
    else if (quantity && !speaksOfMotion(relation.right)) {
      answers.known.push({ ...noFact(), what: quantity.key, value: relation.right });
    } else answers.known.push({ ...noFact(), what: "fact", value: text });
  }
}

function unknown(answers, { letters }) {
  answers.unknown += (answers.unknown ? ", " : "") + letters;
}

function find(answers, step) {
  const quantities = quantitiesOf(answers);
  const terms = step.in_terms_of ?? "";
  if (answers.terms !== terms && (answers.asked.length || answers.also)) {
    throw new Beyond("the form has “in terms of” for all that is to be found", step.line);
  }
  answers.terms = terms;
  for (const item of step.items) {
    const wanted = item.value === null ? null : item.value + (item.percentage ? PERCENT : "");
    const quantity = quantities.find(({ key }) => key === wanted);
    if (quantity) answers.asked.push(quantity.key);
    else {
      if (item.percentage) throw new Beyond("the form has no such percentage", step.line);
      answers.also += (answers.also ? ", " : "") + placed(answers, step, item);
    }
  }
}

function show(answers, step) {
  if (step.subject !== null || step.in_terms_of !== null) {
    throw new Beyond("the form has no field for this line", step.line);
  }
  const [relation] = step.relations;
  const text = placed(answers, step, relation);
  const fact = factsOf(answers).find(({ key }) => key === (relation.staged ?? text));
  const quantity = quantitiesOf(answers).find(({ key }) => key === relation.left);
  if (fact) answers.shows.push({ ...noResult(), what: fact.key });
  else if (quantity && !speaksOfMotion(relation.right)) {
    const { left, sign, right } = relation;
    answers.shows.push({ what: left, sign, value: right });
  } else answers.shows.push({ ...noResult(), what: "relation", value: text });
}

