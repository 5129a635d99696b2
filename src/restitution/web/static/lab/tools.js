// Pointers and keys on the table, made into other scenes.

import { plus, size } from "../player/numbers.js";
import {
  crosses, freeName, MOST_SPHERES, MOST_WALLS, nearest, overlaps, roomNear, rounded, withCorner,
  withSphere, withWall, without,
} from "./scene.js";

const SNAP = 12; // px within which a new wall begins or ends at an old one
const SHORTEST = 12; // px: what is drawn shorter was a slip
const STILL = 6; // px: a shorter arrow is rest
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

// `lab` says what is on the table now (`current()`), shows a scene while something is dragged
// (`preview(scene)`), takes one (`commit(scene, key)`), and tells what is chosen (`choose`), or
// why something is not done (`refuse(text)`).
export class Tools {
  constructor(stage, lab) {
    this.stage = stage;
    this.lab = lab;
    this.tool = "move";
    const { handles } = stage;
    // A finger on the empty table scrolls the page, one on a handle drags it. (In SVG touch-action
    // alone does not say so everywhere.)
    const held = (event) => {
      if (this.tool === "wall" || this.told(event.target)[0]) event.preventDefault();
    };
    handles.addEventListener("touchstart", held, { passive: false });
    handles.addEventListener("pointerdown", (event) => this.down(event));
    handles.addEventListener("pointermove", (event) => this.dragging(event)?.move(event));
    handles.addEventListener("pointerup", (event) => this.up(event));
    handles.addEventListener("pointercancel", (event) => this.give(event));
    handles.addEventListener("dblclick", (event) => this.double(event));
    handles.addEventListener("keydown", (event) => this.key(event));
    handles.addEventListener("focusin", (event) => {
      const [kind, index] = this.told(event.target);
      const of = kind === "sphere" || kind === "tip" ? "spheres" : "walls";
      if (kind) this.lab.choose({ kind: of, index });
    });
  }

  told(target) {
    const node = target.closest?.("[data-kind]");
    return node ? [node.dataset.kind, Number(node.dataset.index)] : [null, -1];
  }

  // --- pointers ----------------------------------------------------------------------------------

  down(event) {
    if (event.button || this.drag) return;
    const { stage } = this;
    const [kind, index] = this.told(event.target);
    const start = stage.pixel(event);
    const scene = this.lab.current();
    let made = null;
    if (this.tool === "wall") made = this.drawWall(scene, start);
    else if (kind === "sphere") made = this.dragSphere(scene, index, start);
    else if (kind === "tip") made = this.dragTip(scene, index, start);
    else if (kind === "wall") made = this.dragWall(scene, index, start);
    else if (kind) made = this.dragEnd(scene, index, kind, start);
    else {
      this.lab.choose(null);
      if (event.pointerType !== "touch") made = this.panning(start);
    }
    if (!made) return;
    this.drag = { ...made, id: event.pointerId };
    stage.handles.setPointerCapture(event.pointerId);
    if (kind && this.tool !== "wall") stage.focus(kind, index);
    event.preventDefault();
  }

  // What is dragged by this pointer: another finger does nothing.
  dragging({ pointerId }) {
    return this.drag?.id === pointerId ? this.drag : null;
  }

  up(event) {
    const drag = this.dragging(event);
    if (!drag) return;
    this.drag = null;
    this.stage.handles.releasePointerCapture?.(event.pointerId);
    drag.end?.();
  }

  // The browser has taken the pointer for itself: nothing was done.
  give(event) {
    if (!this.dragging(event)) return;
    this.drag = null;
    this.stage.drawDraft(null);
    this.lab.preview(null);
  }

  double(event) {
    if (this.tool === "move" && !this.told(event.target)[0]) {
      this.addSphere(this.stage.place(this.stage.pixel(event)));
    }
  }

  // What follows the pointer, by how far it has gone, and is kept when it is let go.
  following(start, change) {
    let made = null;
    const { stage, lab } = this;
    return {
      move: (event) => {
        const way = plus(stage.pixel(event), start, -1);
        if (!made && size(way) < 2) return;
        const next = change(way);
        if (!next) return;
        made = next;
        lab.preview(made);
      },
      end: () => made && lab.commit(made),
    };
  }

  metres([x, y]) {
    return [x / this.stage.view.k, -y / this.stage.view.k];
  }

  dragSphere(scene, i, start) {
    const { position, radius } = scene.spheres[i];
    let last = position;
    return this.following(start, (way) => {
      const wanted = rounded(plus(position, this.metres(way)), this.stage.step);
      const place = roomNear(scene, i, wanted, radius);
      if (!place || crosses(scene, last, place)) return null;
      last = place;
      return withSphere(scene, i, { position: place });
    });
  }

  dragTip(scene, i, start) {
    const { arrow, k } = this.stage.view;
    const { radius, velocity } = scene.spheres[i];
    const tip = this.stage.tipOf([0, 0], velocity, radius);
    // A short arrow was taken hold of beyond its end: that much is given back on the way.
    const spare = size(tip) - arrow * size(velocity);
    return this.following(start, (way) => {
      const out = plus(tip, way);
      const long = size(out) - spare * Math.max(0, 1 - size(way) / 60);
      const rest = size(out) < 0.6 * radius * k || long < STILL;
      const scale = rest ? 0 : long / size(out) / arrow;
      const v = rounded([out[0] * scale, -out[1] * scale], this.stage.speedStep);
      return withSphere(scene, i, { velocity: v });
    });
  }

  dragWall(scene, i, start) {
    const { start: a, end: b, name } = scene.walls[i];
    return this.following(start, (way) => {
      const by = rounded(this.metres(way), this.stage.step);
      const wall = { name, start: plus(a, by), end: plus(b, by) };
      return this.free(scene, [wall]) ? withWall(scene, i, wall) : null;
    });
  }

  dragEnd(scene, i, kind, start) {
    const from = scene.walls[i][kind];
    return this.following(start, (way) => {
      const to = rounded(plus(from, this.metres(way)), this.stage.step);
      return this.corner(scene, from, to);
    });
  }

  corner(scene, from, to) {
    const next = withCorner(scene, from, to);
    const moved = next.walls.filter(({ start, end }, k) =>
      start !== scene.walls[k].start || end !== scene.walls[k].end);
    const long = moved.every(({ start, end }) => size(plus(end, start, -1)) > 1e-6);
    return long && this.free(scene, moved) ? next : null;
  }

  // Whether walls stand in no sphere.
  free(scene, walls) {
    const clear = (wall, { position, radius }) =>
      size(plus(nearest(wall, position), position, -1)) >= radius * (1 - 1e-9);
    return scene.spheres.every((sphere) => walls.every((wall) => clear(wall, sphere)));
  }

  drawWall(scene, start) {
    const { stage, lab } = this;
    const snapped = (pixel) => {
      const ends = scene.walls.flatMap((wall) => [wall.start, wall.end]);
      const near = ends.find((end) => size(plus(stage.at(end), pixel, -1)) < SNAP);
      return near ?? rounded(stage.place(pixel), stage.step);
    };
    const from = snapped(start);
    let to = from;
    return {
      move: (event) => {
        to = snapped(stage.pixel(event));
        stage.drawDraft(from, to);
      },
      end: () => {
        stage.drawDraft(null);
        if (size(plus(to, from, -1)) * stage.view.k >= SHORTEST) this.addWall(scene, from, to);
        else lab.refuse("To make a wall, draw from one end to the other.");
      },
    };
  }

  panning(start) {
    let last = start;
    return {
      move: (event) => {
        const now = this.stage.pixel(event);
        this.lab.pan(plus(now, last, -1));
        last = now;
      },
    };
  }

  // --- adding and taking away --------------------------------------------------------------------

  addSphere(place = null) {
    const scene = this.lab.current();
    if (scene.spheres.length >= MOST_SPHERES) {
      return this.lab.refuse(`There is room for ${MOST_SPHERES} spheres.`);
    }
    const radii = scene.spheres.map(({ radius }) => radius).sort((a, b) => a - b);
    const radius = radii[radii.length >> 1] ?? 0.1;
    const name = freeName(scene);
    const i = scene.spheres.length;
    const wanted = rounded(place ?? this.somewhere(scene, radius), this.stage.step);
    const position = roomNear(scene, -1, wanted, radius);
    if (!position) return this.lab.refuse("There is no room for a sphere here.");
    const sphere = { name, mass: 1, radius, position, velocity: [0, 0] };
    this.lab.commit({ ...scene, spheres: [...scene.spheres, sphere] });
    this.stage.focus("sphere", i);
  }

  // A place with room, as near to the middle of what is seen as there is one.
  somewhere(scene, radius) {
    const { middle, k } = this.stage.view;
    for (let n = 0; n < 400; n += 1) {
      const far = (0.02 * Math.sqrt(n) * this.stage.width) / k;
      const place = plus(middle, [Math.cos(2.4 * n), Math.sin(2.4 * n)], far);
      if (!overlaps(scene, -1, place, radius)) return place;
    }
    return middle;
  }

  addWall(scene = this.lab.current(), start = null, end = null) {
    if (scene.walls.length >= MOST_WALLS) {
      return this.lab.refuse(`There is room for ${MOST_WALLS} walls.`);
    }
    const name = freeName(scene, true);
    const e = scene.walls.at(-1)?.e ?? 1;
    const wall = start ? { name, start, end, e } : this.someWall(scene, name, e);
    if (!wall || !this.free(scene, [wall])) {
      return this.lab.refuse("A wall cannot go through a sphere.");
    }
    this.lab.commit({ ...scene, walls: [...scene.walls, wall] });
    this.stage.focus("wall", scene.walls.length);
  }

  someWall(scene, name, e) {
    const { middle, k } = this.stage.view;
    const long = (0.15 * this.stage.width) / k;
    for (let n = 0; n < 200; n += 1) {
      const far = (0.02 * Math.sqrt(n) * this.stage.width) / k;
      const by = plus(middle, [Math.cos(2.4 * n), Math.sin(2.4 * n)], far);
      const ends = [-long, long].map((x) => rounded(plus(by, [x, 0]), this.stage.step));
      const wall = { name, start: ends[0], end: ends[1], e };
      if (this.free(scene, [wall])) return wall;
    }
    return null;
  }

  remove() {
    const chosen = this.stage.selected;
    const scene = this.lab.current();
    if (!chosen || !scene[chosen.kind][chosen.index]) return;
    if (chosen.kind === "spheres" && scene.spheres.length < 2) {
      return this.lab.refuse("One sphere stays on the table.");
    }
    this.lab.choose(null);
    this.lab.commit(without(scene, chosen.kind, chosen.index));
  }

  // --- keys --------------------------------------------------------------------------------------

  key(event) {
    const [kind, index] = this.told(event.target);
    if (!kind || event.ctrlKey || event.metaKey || event.altKey) return;
    const step = ARROWS[event.key];
    if (step) this.nudge(kind, index, step.map((x) => x * (event.shiftKey ? 10 : 1)));
    else if (event.key === "Delete" || event.key === "Backspace") this.remove();
    else if (event.key === "Enter") this.inner(kind, index);
    else if (event.key === "0" && kind === "tip") {
      this.lab.commit(withSphere(this.lab.current(), index, { velocity: [0, 0] }));
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  // From a sphere to its arrow and back, from a wall to its ends and back.
  inner(kind, index) {
    const to = { sphere: "tip", tip: "sphere", wall: "start", start: "end", end: "wall" };
    this.stage.focus(to[kind], index);
  }

  nudge(kind, i, way) {
    const scene = this.lab.current();
    const { step, speedStep } = this.stage;
    const key = `${kind} ${i}`;
    if (kind === "tip") {
      const velocity = rounded(plus(scene.spheres[i].velocity, way, speedStep), speedStep / 1000);
      this.lab.commit(withSphere(scene, i, { velocity }), key);
      return;
    }
    if (kind === "sphere") {
      const { name, position, radius } = scene.spheres[i];
      const to = rounded(plus(position, way, step), step / 1000);
      const met = overlaps(scene, i, to, radius);
      if (met || crosses(scene, position, to)) {
        this.lab.refuse(`${name} cannot go there: ${met ?? "a wall"} is in its way.`);
      } else this.lab.commit(withSphere(scene, i, { position: to }), key);
      return;
    }
    const wall = scene.walls[i];
    const moved = (point) => rounded(plus(point, way, step), step / 1000);
    let next;
    if (kind === "wall") {
      const change = { start: moved(wall.start), end: moved(wall.end) };
      next = this.free(scene, [change]) ? withWall(scene, i, change) : null;
    } else next = this.corner(scene, wall[kind], moved(wall[kind]));
    if (next) this.lab.commit(next, key);
    else this.lab.refuse(`${wall.name} cannot go there: a sphere is in its way.`);
  }
}
