// The values table: it mirrors the picture, and whatever stands in it can be typed anew.

import { button, html, reachable } from "../player/elements.js";
import { COLOURS } from "../player/picture.js";
import { coefficient, COLUMNS, FORMS, POSITIVE, put, show, typed, written } from "./fields.js";
import { isName, LARGEST, overlaps, withSphere, withWall } from "./scene.js";

const BOUNDS = `numbers go up to ${LARGEST}`;

const unit = (text) => html("span", { class: "unit" }, text);
const labelled = (label, what, node) =>
  html("span", { class: "field" }, html("span", {}, label, unit(what)), node);
const head = (...words) => html("th", { scope: "col" }, ...words);

// `lab` as in tools.js, with `initial()`, the scene at the start, to which masses, names and
// coefficients belong; `lab.remove(kind, index)` takes a body away.
export class ValuesTable {
  constructor(lab) {
    this.lab = lab;
    this.form = html(
      "select",
      { onchange: () => this.lay(this.lab.current(), true) },
      html("option", { value: "components" }, "components i and j"),
      html("option", { value: "polar" }, "speed and direction"),
    );
    this.sizes = html("input", { type: "checkbox" });
    this.time = html("span", { class: "when" });
    this.ballScroll = html("div", { class: "scroll", role: "group", "aria-label": "Spheres" });
    this.wallScroll = html("div", { class: "scroll", role: "group", "aria-label": "Walls" });
    this.e = coefficient("e between spheres", 1, (e) => this.setE(e));
    this.allWalls = coefficient("e of all walls", 1, (e) => this.setWalls(e));
    this.pairs = html("div", { class: "pairs" });
    this.seconds = html("input", {
      class: "number", inputmode: "decimal", "aria-label": "Duration in seconds",
      onchange: () => this.setSeconds(),
    });
    this.node = html(
      "section",
      { class: "editor" },
      html("h2", {}, "Values", this.time),
      html(
        "div",
        {},
        html(
          "div",
          { class: "fields" },
          html("label", {}, "Velocity as ", this.form),
          html("label", { class: "tick" }, this.sizes, "Size follows mass"),
        ),
        this.ballScroll,
      ),
      html(
        "div",
        {},
        html(
          "div",
          { class: "fields" },
          labelled("e", " between spheres", this.e.node),
          labelled("e", " of all walls", this.allWalls.node),
          html("label", {}, "Followed for ", this.seconds, unit(" s")),
        ),
        this.pairs,
        this.wallScroll,
      ),
    );
  }

  // Makes the rows anew where there are others.
  lay(scene, anew = false) {
    const key = [this.form.value, scene.spheres.length, scene.walls.length].join();
    if (anew || key !== this.key) {
      this.key = key;
      this.makeBalls(scene);
      this.makeWalls(scene);
    }
    this.makePairs(scene);
    this.showAll(scene, this.time.textContent);
    reachable(this.ballScroll);
    reachable(this.wallScroll);
  }

  makeBalls(scene) {
    const columns = FORMS[this.form.value];
    const heads = columns.map((key) => {
      const [label, symbol] = COLUMNS[key];
      return head(label, unit(` ${symbol}`));
    });
    this.balls = scene.spheres.map((_, i) => ({
      name: this.nameField("spheres", i),
      cells: columns.map((key) => this.field((text) => this.setSphere(i, key, text))),
      away: this.away("spheres", i),
    }));
    this.columns = columns;
    this.ballScroll.replaceChildren(html(
      "table",
      {},
      html("caption", { class: "unseen" }, "Spheres"),
      html("thead", {}, html("tr", {}, head("sphere"), ...heads, html("td"))),
      html("tbody", {}, ...this.balls.map(({ name, cells, away }, i) => html(
        "tr", { class: `body${i % COLOURS}` },
        html("th", { scope: "row", class: "who" }, name),
        ...cells.map((cell) => html("td", {}, cell)),
        html("td", {}, away),
      ))),
    ));
  }

  makeWalls(scene) {
    const ends = [["start", 0], ["start", 1], ["end", 0], ["end", 1]];
    this.walls = scene.walls.map((_, i) => ({
      name: this.nameField("walls", i),
      cells: ends.map(([end, k]) => this.field((text) => this.setWall(i, end, k, text))),
      e: coefficient("e", 1, (e) => this.setWallE(i, e)),
      away: this.away("walls", i),
    }));
    this.wallScroll.hidden = !scene.walls.length;
    const heads = ["from x", "y", "to x", "y"].map((label) => head(label, unit(" m")));
    this.wallScroll.replaceChildren(html(
      "table",
      {},
      html("caption", { class: "unseen" }, "Walls"),
      html("thead", {}, html("tr", {}, head("wall"), ...heads, head("e"), html("td"))),
      html("tbody", {}, ...this.walls.map(({ name, cells, e, away }) => html(
        "tr", {},
        html("th", { scope: "row" }, name),
        ...cells.map((cell) => html("td", {}, cell)),
        html("td", {}, e.node),
        html("td", {}, away),
      ))),
    ));
  }

  makePairs(scene) {
    const names = scene.spheres.map(({ name }) => name);
    const key = JSON.stringify([scene.pairs.map(([a, b]) => [a, b]), names]);
    if (key === this.pairKey) return;
    const had = this.pairs.contains(document.activeElement);
    this.pairKey = key;
    this.pairE = scene.pairs.map(([a, b], i) =>
      coefficient(`e of ${a} and ${b}`, 1, (e) => this.setPair(i, e)));
    const choose = (label, usual) => html("select", { "aria-label": label }, names.map((value) =>
      html("option", { value, selected: value === names[usual] }, value)));
    const first = choose("First sphere of the pair", 0);
    const second = choose("Second sphere of the pair", 1);
    const add = button("Set its own e", () => this.addPair(first.value, second.value));
    this.pairs.hidden = names.length < 3;
    this.pairs.replaceChildren(
      ...scene.pairs.map(([a, b], i) => html(
        "span", { class: "field" }, html("span", {}, `e of ${a} and ${b}`), this.pairE[i].node,
        button("×", () => this.removePair(i), {
          class: "away", "aria-label": `No e of its own for ${a} and ${b}`,
        }),
      )),
      html("span", { class: "field" }, "A pair:", first, second, add),
    );
    if (had) add.focus();
  }

  field(change) {
    const field = html("input", {
      class: "number", inputmode: "decimal",
      onchange: () => {
        field.setAttribute("aria-invalid", String(!change(field.value)));
      },
      onkeydown: (event) => event.key === "Enter" && field.dispatchEvent(new Event("change")),
      onfocus: () => this.lab.pause(),
    });
    return field;
  }

  nameField(kind, i) {
    const field = html("input", {
      class: "name", maxlength: 12, autocomplete: "off",
      onchange: () => {
        field.setAttribute("aria-invalid", String(!this.setName(kind, i, field.value.trim())));
      },
      onfocus: () => {
        this.lab.pause();
        this.lab.choose({ kind, index: i });
      },
    });
    return field;
  }

  // To the button that takes away what stands now in a row of the table.
  focusAway(kind, i) {
    const rows = kind === "spheres" ? this.balls : this.walls;
    (rows[i] ?? rows.at(-1))?.away.focus();
  }

  away(kind, i) {
    return button("×", () => this.lab.remove(kind, i), { class: "away" });
  }

  // Puts the numbers of a scene into the fields, but for the one that is being typed in.
  show(scene, when) {
    this.time.textContent = when;
    scene.spheres.forEach((sphere, i) => this.showBall(sphere, this.balls[i]));
  }

  showBall(sphere, { name, cells }) {
    show(name, sphere.name);
    cells.forEach((field, k) => show(field, written(COLUMNS[this.columns[k]][2](sphere))));
  }

  // A few rows at a time, in turn.
  follow(scene, rows, when) {
    this.time.textContent = when;
    for (let n = 0; n < rows; n += 1) {
      this.turn = ((this.turn ?? 0) + 1) % this.balls.length;
      this.showBall(scene.spheres[this.turn], this.balls[this.turn]);
    }
  }

  // Puts the rest there as well: what does not change while it plays.
  showAll(scene, when) {
    this.show(scene, when);
    const label = (field, text) => field.setAttribute("aria-label", text);
    const heads = this.columns.map((key) => COLUMNS[key]);
    scene.spheres.forEach(({ name }, i) => {
      const row = this.balls[i];
      label(row.name, `name of ${name}`);
      label(row.away, `Take ${name} away`);
      row.cells.forEach((field, k) => label(field, `${heads[k][0]} of ${name}, ${heads[k][1]}`));
    });
    scene.walls.forEach(({ name, start, end, e }, i) => {
      const row = this.walls[i];
      show(row.name, name);
      [...start, ...end].forEach((x, k) => {
        show(row.cells[k], written(x));
        label(row.cells[k], `${["start x", "start y", "end x", "end y"][k]} of ${name}, m`);
      });
      row.e.set(e);
      label(row.name, `name of ${name}`);
      label(row.away, `Take ${name} away`);
      label(row.e.field, `e of ${name}`);
      label(row.e.slider, `e of ${name}, slider`);
    });
    this.e.set(scene.e);
    scene.pairs.forEach(([, , e], i) => this.pairE[i].set(e));
    if (scene.walls.length) this.allWalls.set(scene.walls[0].e);
    show(this.seconds, written(scene.seconds));
  }

  // --- what was typed ----------------------------------------------------------------------------

  refuse(text) {
    this.lab.refuse(text);
    return false;
  }

  // What stands there already: whatever was said against another value holds no more.
  accept() {
    this.lab.say("");
    return true;
  }

  setSphere(i, key, text) {
    const scene = POSITIVE.includes(key) ? this.lab.initial() : this.lab.current();
    const sphere = scene.spheres[i];
    const [label, , get, change] = COLUMNS[key];
    const x = typed(text);
    const what = `The ${label} of ${sphere.name}`;
    if (!Number.isFinite(x)) return this.refuse(`${what} is a number, such as 1.5 or 3/4.`);
    if (text.trim() === written(get(sphere))) return this.accept();
    if (Math.abs(x) > LARGEST) return this.refuse(`${what} is out of bounds: ${BOUNDS}.`);
    if (POSITIVE.includes(key) && x <= 0) return this.refuse(`${what} is positive.`);
    if (key === "speed" && x < 0) {
      return this.refuse("A speed is not negative: turn the direction.");
    }
    const made = change(sphere, x);
    if (key === "mass" && this.sizes.checked) {
      made.radius = Number((sphere.radius * Math.cbrt(x / sphere.mass)).toPrecision(4));
    }
    const next = { ...sphere, ...made };
    const met = overlaps(scene, i, next.position, next.radius);
    if (met && (made.position || made.radius)) {
      return this.refuse(`${sphere.name} would overlap ${met} there.`);
    }
    this.lab.commit(withSphere(scene, i, made));
    return true;
  }

  setWall(i, end, k, text) {
    const scene = this.lab.current();
    const x = typed(text);
    const { name } = scene.walls[i];
    if (!Number.isFinite(x)) return this.refuse(`Where ${name} is, is told in numbers.`);
    if (Math.abs(x) > LARGEST) return this.refuse(`That is out of bounds: ${BOUNDS}.`);
    const next = withWall(scene, i, { [end]: put(scene.walls[i][end], k, x) });
    return this.settle(next, name);
  }

  settle(next, name) {
    for (const [i, { position, radius }] of next.spheres.entries()) {
      if (overlaps(next, i, position, radius) === name) {
        return this.refuse(`${name} would go through ${next.spheres[i].name}.`);
      }
    }
    this.lab.commit(next);
    return true;
  }

  setName(kind, i, name) {
    const scene = this.lab.initial();
    if (name === scene[kind][i].name) return this.accept();
    if (!isName(name)) return this.refuse("A name is a capital letter, then letters or digits.");
    const taken = [...scene.spheres, ...scene.walls].some((body) => body.name === name);
    if (taken) return this.refuse(`There is a ${name} already.`);
    this.lab.commit((kind === "spheres" ? withSphere : withWall)(scene, i, { name }));
    return true;
  }

  coefficient(e, change, key) {
    if (e === null) this.refuse("A coefficient of restitution lies between 0 and 1.");
    else this.lab.commit(change(this.lab.initial()), key);
  }

  setE(e) {
    this.coefficient(e, (scene) => ({ ...scene, e }), "e");
  }

  setWalls(e) {
    const change = (scene) => ({ ...scene, walls: scene.walls.map((wall) => ({ ...wall, e })) });
    this.coefficient(e, change, "walls");
  }

  setWallE(i, e) {
    this.coefficient(e, (scene) => withWall(scene, i, { e }), `wall ${i}`);
  }

  setPair(i, e) {
    const change = (scene) => ({
      ...scene, pairs: scene.pairs.map((pair, k) => (k === i ? [pair[0], pair[1], e] : pair)),
    });
    this.coefficient(e, change, `pair ${i}`);
  }

  addPair(a, b) {
    const scene = this.lab.initial();
    const same = ([c, d]) => (a === c && b === d) || (a === d && b === c);
    if (a === b) this.refuse("A pair is of two different spheres.");
    else if (!scene.pairs.some(same)) {
      this.lab.commit({ ...scene, pairs: [...scene.pairs, [a, b, scene.e]] });
    }
  }

  removePair(i) {
    const scene = this.lab.initial();
    this.lab.commit({ ...scene, pairs: scene.pairs.filter((_, k) => k !== i) });
  }

  setSeconds() {
    const x = typed(this.seconds.value);
    if (x > 0 && x <= 120) this.lab.commit({ ...this.lab.initial(), seconds: x });
    else this.refuse("A motion is followed for up to 120 s.");
  }
}
