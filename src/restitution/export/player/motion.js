// A motion, looked up: where everything is at a time, and what it takes up.

import { cross, dot, figures, plus, seconds, size } from "./numbers.js";

export function pieceAt(sphere, t, before = false) {
  const { pieces } = sphere;
  let low = 0;
  let high = pieces.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (before ? pieces[middle][0] < t : pieces[middle][0] <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}

export function placeAt(sphere, t) {
  const [start, , x, y, vx, vy] = sphere.pieces[pieceAt(sphere, t)];
  return [x + vx * (t - start), y + vy * (t - start)];
}

export function bounds(motion) {
  const xs = [];
  const ys = [];
  const see = ([x, y], r = 0) => {
    xs.push(x - r, x + r);
    ys.push(y - r, y + r);
  };
  for (const { pieces, radius } of motion.spheres) {
    for (const [start, end, x, y, vx, vy] of pieces) {
      see([x, y], radius);
      see([x + vx * (end - start), y + vy * (end - start)], radius);
    }
  }
  for (const wall of motion.walls) {
    if (wall.points) wall.points.forEach((point) => see(point));
    else see(wall.centre, wall.radius);
  }
  motion.points.forEach(({ at }) => see(at));
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

// Bounds widened to hold some more points.
export function around([left, bottom, right, top], points) {
  const xs = points.map(([x]) => x);
  const ys = points.map(([, y]) => y);
  return [
    Math.min(left, ...xs),
    Math.min(bottom, ...ys),
    Math.max(right, ...xs),
    Math.max(top, ...ys),
  ];
}

export function fastest(motion) {
  let most = 0;
  for (const { pieces } of motion.spheres) {
    for (const piece of pieces) most = Math.max(most, Math.hypot(piece[4], piece[5]));
  }
  return most || 1;
}

// On which side of a straight wall nothing ever is: +1 left of it, −1 right of it, 0 neither.
export function behind(a, b, motion) {
  const along = plus(b, a, -1);
  const unit = [along[0] / size(along), along[1] / size(along)];
  let left = 0;
  let right = 0;
  for (const sphere of motion.spheres) {
    for (const [start, end, x, y, vx, vy] of sphere.pieces) {
      for (const t of [0, end - start]) {
        const place = [x + vx * t, y + vy * t];
        const side = cross(unit, plus(place, a, -1));
        const beside = dot(unit, plus(place, a, -1));
        if (beside < 0 || beside > size(along)) continue;
        left = Math.max(left, side);
        right = Math.max(right, -side);
      }
    }
  }
  if (Math.min(left, right) > 0.1 * Math.max(left, right)) return 0;
  return left > right ? -1 : 1;
}

export function wordsOf(event) {
  if (event.kind === "blow") return `${event.bodies[0]} receives an impulse`;
  if (event.kind === "arrival") return `${event.bodies[0]} reaches ${event.target ?? "the point"}`;
  return `${event.bodies[0]} hits ${event.wall ?? event.bodies[1]}`;
}

// What is said aloud of an event, the first being number 1.
export function spoken(event, number) {
  const speeds = event.bodies.map((name) => {
    const [before, after] = [event.before, event.after].map((v) => figures(size(v[name])));
    return `speed of ${name} ${before}, then ${after}`;
  });
  return [`${number}: ${wordsOf(event)} at ${seconds(event.time)}`, ...speeds].join("; ");
}

// Components of a velocity along the line of centres and across it.
export const along = (event, v) => dot(v, event.line);
export const across = (event, v) => cross(event.line, v);
