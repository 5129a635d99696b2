// What an event does, and all that is known of every sphere, in tables.

import { html, mathematics, reachable } from "./elements.js";
import { across, along, pieceAt, wordsOf } from "./motion.js";
import { dot, figures, seconds, size } from "./numbers.js";
import { COLOURS, CROWD } from "./picture.js";

const SELDOM = 120; // ms between the tables of a crowd, while it moves

// The exact value where there is one, and its decimals where they say more.
function value(said, x) {
  const decimal = figures(x);
  if (!said || said === decimal) return [html("span", {}, decimal)];
  if (Number(said.replace("−", "-")) === x) return [html("span", {}, said)];
  return [
    html("span", { class: "exact" }, ...mathematics(said)),
    " ",
    html("span", { class: "decimal" }, decimal),
  ];
}

function row(label, cells, kind = {}) {
  return html("tr", kind, html("th", { scope: "row" }, ...label), ...cells);
}

const unitOf = (...text) => html("span", { class: "unit" }, " ", ...text);

// What an event does to the components of the velocities.
export class Card {
  // With `angles`, also those that a ball makes with a wall, and what they say of e.
  constructor({ angles = false } = {}) {
    this.angles = angles;
    this.heading = html("h2");
    this.body = html("div", { class: "scroll", role: "group", "aria-label": "The impact" });
    this.node = html("section", { class: "card" }, this.heading, this.body);
  }

  show(event, number, t) {
    const done = event !== null && t >= event.time;
    const key = event === null ? "" : `${number} ${done}`;
    if (this.key === key) return;
    this.key = key;
    this.body.replaceChildren();
    this.heading.replaceChildren();
    this.heading.hidden = event === null;
    if (event === null) return;
    const e = event.kind === "impact" ? [", ", html("var", {}, "e"), " = "] : [];
    if (e.length) e.push(...mathematics(event.said?.e ?? String(Number(event.e.toPrecision(3)))));
    this.heading.append(`${number}: ${wordsOf(event)}`, ...e);
    if (event.kind === "impact") {
      this.body.append(this.table(this.components(event, done), "Components of velocity"));
      if (this.angles && event.wall) this.body.append(this.measured(event, done));
      if (event.impulse !== null) this.body.append(this.effects(event, done));
    } else if (event.kind === "blow") {
      this.body.append(this.table(this.axes(event, done), "Velocity"));
      this.body.append(html("p", {}, `Impulse ${figures(size(event.impulse))}`, unitOf("N s")));
    }
    reachable(this.body);
  }

  // Rows of the components along the line of centres (or towards a wall) and across it.
  components(event, done) {
    const { wall, bodies } = event;
    const words = wall
      ? [` towards ${wall}`, ` parallel to ${wall}`]
      : [` along ${bodies[0]} → ${bodies[1]}`, " perpendicular"];
    return bodies.flatMap((name) =>
      [along, across].map((component, k) => {
        const key = k ? "across" : "along";
        const cell = (when) =>
          value(event.said?.[when]?.[name]?.[key], component(event, event[when][name]));
        return this.line(name, [words[k]], cell("before"), done ? cell("after") : null, !k);
      }),
    );
  }

  // The angles to the wall before and after; the quotient of their tangents is e.
  measured(event, done) {
    const [name] = event.bodies;
    const tangents = ["before", "after"].map((when) => {
      const v = event[when][name];
      return Math.abs(along(event, v)) / Math.abs(across(event, v));
    });
    const angle = (tangent) => `${figures((Math.atan(tangent) * 180) / Math.PI)}°`;
    const made = html("p", { class: "angles" }, html("var", {}, "α"), ` = ${angle(tangents[0])}`);
    if (!done) return made;
    made.append(", ", html("var", {}, "β"), ` = ${angle(tangents[1])} to ${event.wall}`);
    if (tangents.every((tangent) => tangent > 1e-9 && tangent < 1e9)) {
      const e = figures(tangents[1] / tangents[0]);
      made.append("; tan ", html("var", {}, "β"), " / tan ", html("var", {}, "α"));
      made.append(` = ${e} = `, html("var", {}, "e"));
    }
    return made;
  }

  // Rows of the components along i and j, for an impulse from outside.
  axes(event, done) {
    const [name] = event.bodies;
    return [0, 1].map((k) =>
      this.line(
        name,
        [" along ", html("b", {}, "ij"[k])],
        value(null, event.before[name][k]),
        done ? value(null, event.after[name][k]) : null,
        !k,
      ),
    );
  }

  line(name, words, before, after, first) {
    const label = [html("span", { class: "who" }, name), ...words];
    const cells = [before, after ?? ["…"]].map((each) => html("td", {}, ...each));
    return row(label, cells, first ? { class: "first" } : {});
  }

  table(rows, caption) {
    const head = ["before", "after"].map((text) => html("th", { scope: "col" }, text));
    return html(
      "table",
      {},
      html("caption", {}, caption, unitOf("m s⁻¹")),
      html("thead", {}, html("tr", {}, html("td"), ...head)),
      html("tbody", {}, ...rows),
    );
  }

  effects(event, done) {
    const seen = (x) => (done ? figures(x) : "…");
    return html(
      "p",
      {},
      `Impulse ${seen(size(event.impulse))}`,
      unitOf("N s"),
      `; kinetic energy lost ${seen(event.lost)}`,
      unitOf("J"),
    );
  }
}

// All that is known of every sphere now.
export class Values {
  constructor() {
    this.heading = html("h2");
    this.scroll = html("div", { class: "scroll", role: "group", "aria-label": "Values" });
    this.node = html("section", { class: "values" }, this.heading, this.scroll);
  }

  lay(motion) {
    this.motion = motion;
    this.key = null;
  }

  show(t, playing) {
    const { spheres } = this.motion;
    const since = performance.now() - (this.shown ?? -SELDOM);
    if (playing && spheres.length > CROWD && since < SELDOM) return;
    this.shown = performance.now();
    this.heading.textContent = `At ${seconds(t)}`;
    const indices = spheres.map((sphere) => pieceAt(sphere, t));
    const key = indices.join();
    if (key === this.key) return;
    this.key = key;
    const now = spheres.map((sphere, i) => {
      const piece = sphere.pieces[indices[i]];
      return { ...sphere, v: [piece[4], piece[5]], exact: sphere.said?.[indices[i]] };
    });
    this.scroll.replaceChildren(this.table(now));
    reachable(this.scroll);
  }

  table(now) {
    const weighed = now.every(({ mass }) => mass !== null);
    const sum = weighed && now.length > 1;
    const turn = ({ v }) => (size(v) < 1e-12 ? null : (Math.atan2(v[1], v[0]) * 180) / Math.PI);
    const momentum = (k) => ({ mass, v }) => (mass === null ? null : mass * v[k]);
    const energy = ({ mass, v }) => (mass === null ? null : (mass * dot(v, v)) / 2);
    const bold = (text) => html("b", {}, text);
    const lines = [
      [["velocity ", bold("i")], "m s⁻¹", ({ v }) => v[0], "x", false],
      [["velocity ", bold("j")], "m s⁻¹", ({ v }) => v[1], "y", false],
      [["speed"], "m s⁻¹", ({ v }) => size(v), "speed", false],
      [["direction from ", bold("i")], "°", turn, null, false],
    ];
    if (now.some(({ mass }) => mass !== null)) {
      lines.push([["momentum ", bold("i")], "N s", momentum(0), null, sum]);
      lines.push([["momentum ", bold("j")], "N s", momentum(1), null, sum]);
      lines.push([["kinetic energy"], "J", energy, null, sum]);
    }
    const cell = (x, said) => html("td", {}, ...(x === null ? ["–"] : value(said, x)));
    const cells = ([, , number, key, summed]) => [
      ...now.map((sphere) => cell(number(sphere), key && sphere.exact?.[key])),
      ...(sum ? [summed ? cell(now.reduce((s, each) => s + number(each), 0)) : html("td")] : []),
    ];
    const heads = now.map(({ name, mass }, i) =>
      html("th", { scope: "col", class: `who body${i % COLOURS}` }, name),
    );
    if (sum) heads.push(html("th", { scope: "col" }, "all"));
    if (now.length <= 5) {
      return html(
        "table",
        {},
        html("thead", {}, html("tr", {}, html("td"), ...heads)),
        html(
          "tbody",
          {},
          ...lines.map((line) => row([...line[0], unitOf(line[1])], cells(line))),
        ),
      );
    }
    const columns = lines.map((line) =>
      html("th", { scope: "col" }, ...line[0], unitOf(line[1])),
    );
    const table = lines.map(cells);
    return html(
      "table",
      {},
      html("thead", {}, html("tr", {}, html("td"), ...columns)),
      html(
        "tbody",
        {},
        ...[...now.map(({ name }) => name), ...(sum ? ["all"] : [])].map((name, i) =>
          row([name], table.map((line) => line[i])),
        ),
      ),
    );
  }
}
