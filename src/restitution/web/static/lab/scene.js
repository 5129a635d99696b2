// A scene: what is on the table and how it starts. Values of this kind are never changed, only
// replaced. Numbers are in SI units, vectors pairs [x, y]:
//
//     { spheres: [{ name, mass, radius, position, velocity }],
//       walls: [{ name, start, end, e }], e, pairs: [[name, name, e]], seconds }

import { pieceAt, placeAt } from "../player/motion.js";
import { cross, dot, plus, size } from "../player/numbers.js";

export const MOST_SPHERES = 60; // what the server takes
export const MOST_WALLS = 40;
export const LARGEST = 1e6; // of all numbers
const DIGITS = 12; // as many as a motion has

const short = (x) => String(Number(Number(x).toPrecision(DIGITS)));

// --- as rows, and in an address ------------------------------------------------------------------

const sphereOf = ([name, mass, radius, x, y, vx, vy]) => ({
  name, mass, radius, position: [x, y], velocity: [vx, vy],
});
const wallOf = ([name, x1, y1, x2, y2, e]) => ({ name, start: [x1, y1], end: [x2, y2], e });

export const fromRows = ({ spheres, walls, e, seconds, pairs = [] }) => ({
  spheres: spheres.map(sphereOf), walls: walls.map(wallOf), e, pairs, seconds,
});

const rowOfSphere = ({ name, mass, radius, position, velocity }) => [
  name, mass, radius, ...position, ...velocity,
];
const rowOfWall = ({ name, start, end, e }) => [name, ...start, ...end, e];

const joined = (rows) =>
  rows.map((row) => row.map((x) => (typeof x === "string" ? x : short(x))).join(",")).join(";");

// The scene as a fragment of an address: names hold no other letters than A–Z, a–z and digits.
export function toText(scene) {
  const parts = [["spheres", joined(scene.spheres.map(rowOfSphere))]];
  if (scene.walls.length) parts.push(["walls", joined(scene.walls.map(rowOfWall))]);
  parts.push(["e", short(scene.e)]);
  if (scene.pairs.length) parts.push(["pairs", joined(scene.pairs)]);
  parts.push(["seconds", short(scene.seconds)]);
  return parts.map(([key, value]) => `${key}=${value}`).join("&");
}

// The scene of a fragment, or null where it holds none that can be read.
export function fromText(parameters) {
  const rows = (key, names, length) =>
    (parameters.get(key) ?? "").split(";").filter(Boolean).map((text) => {
      const cells = text.split(",");
      if (cells.length !== length) throw new Error(key);
      return cells.map((cell, i) => (i < names ? named(cell) : numbered(cell)));
    });
  try {
    const scene = fromRows({
      spheres: rows("spheres", 1, 7),
      walls: rows("walls", 1, 6),
      pairs: rows("pairs", 2, 3),
      e: numbered(parameters.get("e") ?? "1"),
      seconds: numbered(parameters.get("seconds") ?? "10"),
    });
    const { spheres, walls } = scene;
    const some = spheres.length > 0 && spheres.length <= MOST_SPHERES;
    return some && walls.length <= MOST_WALLS ? scene : null;
  } catch {
    return null;
  }
}

function named(text) {
  if (!isName(text)) throw new Error(text);
  return text;
}

function numbered(text) {
  const x = Number(text);
  if (text.trim() === "" || !(Math.abs(x) <= LARGEST)) throw new Error(text);
  return x;
}

export const isName = (text) => /^[A-Z][A-Za-z0-9]{0,11}$/.test(text);

// --- as a motion ---------------------------------------------------------------------------------

// As something to draw: all of it at time 0.
export const still = (scene) => ({
  start: 0,
  end: 0,
  spheres: scene.spheres.map(({ name, mass, radius, position, velocity }) => ({
    name, mass, radius, pieces: [[0, 0, ...position, ...velocity]], said: [null],
  })),
  walls: scene.walls.map(({ name, start, end }) => ({ name, points: [start, end], closed: false })),
  points: [],
  events: [],
  notes: [],
});

// The scene as it has become at a time of its motion.
export const at = (scene, motion, t) => ({
  ...scene,
  spheres: scene.spheres.map((sphere, i) => {
    const moved = motion.spheres[i];
    const [, , , , vx, vy] = moved.pieces[pieceAt(moved, t)];
    return { ...sphere, position: placeAt(moved, t), velocity: [vx, vy] };
  }),
});

// --- other scenes --------------------------------------------------------------------------------

const replaced = (list, i, change) =>
  list.map((each, k) => (k === i ? { ...each, ...change } : each));

export const withSphere = (scene, i, change) => ({
  ...scene,
  spheres: replaced(scene.spheres, i, change),
  pairs: change.name
    ? scene.pairs.map((pair) => pair.map((x) => (x === scene.spheres[i].name ? change.name : x)))
    : scene.pairs,
});

export const withWall = (scene, i, change) => ({
  ...scene, walls: replaced(scene.walls, i, change),
});

export function without(scene, kind, i) {
  const gone = scene[kind][i].name;
  return {
    ...scene,
    [kind]: scene[kind].filter((_, k) => k !== i),
    pairs: scene.pairs.filter((pair) => !pair.includes(gone)),
  };
}

// Walls that meet in a corner keep together.
export function withCorner(scene, from, to) {
  const same = (point) => size(plus(point, from, -1)) < 1e-9;
  return {
    ...scene,
    walls: scene.walls.map((wall) => ({
      ...wall, start: same(wall.start) ? to : wall.start, end: same(wall.end) ? to : wall.end,
    })),
  };
}

export function freeName(scene, wall = false) {
  const taken = new Set([...scene.spheres, ...scene.walls].map(({ name }) => name));
  const letters = wall ? ["W"] : [..."ABCDFGHJKLMNPQRSTUVXYZ"];
  for (const letter of letters) if (!taken.has(letter)) return letter;
  for (let n = 1; ; n += 1) {
    const name = `${letters[0]}${n}`;
    if (!taken.has(name)) return name;
  }
}

// --- room ----------------------------------------------------------------------------------------

// The point of a segment that is nearest to a place.
export function nearest({ start, end }, place) {
  const way = plus(end, start, -1);
  const share = dot(plus(place, start, -1), way) / (dot(way, way) || 1);
  return plus(start, way, Math.max(0, Math.min(1, share)));
}

// What a sphere would overlap at a place: [point, distance that it needs, name] each.
function obstacles(scene, i, place, radius) {
  const found = [];
  scene.spheres.forEach((other, k) => {
    if (k !== i) found.push([other.position, other.radius + radius, other.name]);
  });
  scene.walls.forEach((wall) => found.push([nearest(wall, place), radius, wall.name]));
  return found.filter(([point, need]) => size(plus(place, point, -1)) < need * (1 - 1e-9));
}

// The name of something that a sphere would overlap, or null.
export const overlaps = (scene, i, place, radius) =>
  obstacles(scene, i, place, radius)[0]?.[2] ?? null;

// The nearest place with room for a sphere, or null where none is found.
export function roomNear(scene, i, wanted, radius) {
  let place = wanted;
  for (let turn = 0; turn < 24; turn += 1) {
    const [first] = obstacles(scene, i, place, radius);
    if (!first) return place;
    const [point, need] = first;
    const way = plus(place, point, -1);
    const out = size(way) > 1e-9 ? way : [0, 1];
    place = plus(point, out, (need * (1 + 1e-9)) / size(out));
  }
  return null;
}

// Whether something on the way from one place to another is crossed: no sphere is dragged through
// a wall unseen.
export function crosses(scene, from, to) {
  const way = plus(to, from, -1);
  return scene.walls.some(({ start, end }) => {
    const wall = plus(end, start, -1);
    const [a, b] = [cross(wall, plus(from, start, -1)), cross(wall, plus(to, start, -1))];
    const [c, d] = [cross(way, plus(start, from, -1)), cross(way, plus(end, from, -1))];
    return a * b < 0 && c * d < 0;
  });
}

// A number that people like, no smaller than x: 1, 2 or 5 times a power of ten.
export function tidyStep(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return [1, 2, 5, 10].map((k) => k * power).find((step) => step >= x * (1 - 1e-9));
}

export const rounded = (v, step) =>
  v.map((x) => Number((Math.round(x / step) * step).toPrecision(DIGITS)) + 0);
