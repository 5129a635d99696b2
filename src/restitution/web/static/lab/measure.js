// Measuring on the table: readings of angles and speeds with their errors, a table of trials, and e.

import { ask, sentence } from "../api.js";
import { keep, kept } from "../kept.js";
import { allow, button, html, reachable } from "../player/elements.js";
import { across, along } from "../player/motion.js";
import { size } from "../player/numbers.js";
import { fragment } from "../experiment/address.js";
import { prose } from "../experiment/prose.js";
import { typed, written } from "./fields.js";

const MOST = 200; // trials
const PAUSE = 300; // ms after the last change
const NAME = "restitution.trials";
const COLUMNS = [
  ["alpha", "α", "°"], ["beta", "β", "°"], ["u", "u", "m s⁻¹"], ["v", "v", "m s⁻¹"],
];
const ANGLE_ERRORS = [0, 0.5, 1, 2, 3]; // degrees
const SPEED_ERRORS = [0, 0.02, 0.05, 0.1]; // m/s

// A number drawn from the normal distribution (G. Box and M. Muller, 1958).
const normal = () =>
  Math.sqrt(-2 * Math.log(1 - Math.random())) * Math.cos(2 * Math.PI * Math.random());

// The division of a scale that is read with an error: whole degrees for 1° and more.
const division = (error, finest, usual) => (error >= 2 * usual ? 2 * usual : error > 0 ? usual : finest);

const rounded = (x, step) => Number((Math.round(x / step) * step).toFixed(6));

// A value as it is read: with an error, on a scale, within its bounds.
function read(value, error, step, least, most) {
  for (let n = 0; n < 100; n += 1) {
    const reading = rounded(value + error * normal(), step);
    if (reading >= least && reading <= most) return reading;
  }
  return rounded(Math.max(least, Math.min(most, value)), step);
}

// The angle of a velocity to the wall, in degrees.
const toWall = (event, v) =>
  (Math.atan2(Math.abs(along(event, v)), Math.abs(across(event, v))) * 180) / Math.PI;

// `lab` gives the impact that is shown (`impact()`), all impacts with walls (`impacts()`), lays the
// protractor to one (`align(event)`), and hides e of the walls (`conceal()`) and shows it (`reveal()`).
export class Measure {
  constructor(lab) {
    this.lab = lab;
    this.rows = this.remembered();
    this.angle = this.chosen("Error of an angle", ANGLE_ERRORS, 1, "°");
    this.speed = this.chosen("Error of a speed", SPEED_ERRORS, 0.05, " m s⁻¹");
    this.speeds = html("input", { type: "checkbox", onchange: () => this.lay() });
    this.lies = button("Lay the protractor to this impact", () => this.lab.align(this.lab.impact()));
    this.takes = button("Read this impact", () => this.take([this.lab.impact()]), { class: "main" });
    this.takesAll = button("Read all impacts with walls", () => this.take(this.lab.impacts()));
    this.secret = button("A wall of unknown e", () => this.hide());
    this.body = html("tbody");
    this.heads = html("tr");
    this.table = html("div", { class: "scroll", role: "group", "aria-label": "Trials" },
      html("table", {}, html("thead", {}, this.heads), this.body));
    this.outcome = html("div", { class: "outcome", role: "status" });
    this.node = html("section", { class: "measure", hidden: true },
      html("h2", {}, "Measure"),
      html("p", {}, "Play, stop at an impact with a wall, lay the protractor to it, and type the " +
        "angles that you read between the path and the wall; or let them be read, with the error " +
        "that you choose."),
      html("div", { class: "choices" }, this.lies, this.takes, this.takesAll, this.secret),
      html("div", { class: "fields" }, this.angle.node, this.speed.node,
        html("label", { class: "tick" }, this.speeds, "Speeds too")),
      html("div", { class: "trials" },
        html("div", {}, this.table,
          html("div", { class: "choices" },
            button("Add a row", () => this.add()), button("Take all away", () => this.empty()))),
        this.outcome));
    this.lay();
  }

  chosen(label, values, usual, what) {
    const options = values.map((x) => html("option", { value: x, selected: x === usual },
      x ? `± ${x}${what}` : "none"));
    const select = html("select", { onchange: () => this.soon() }, ...options);
    return { select, node: html("label", {}, `${label} `, select) };
  }

  get shown() {
    return !this.node.hidden;
  }

  show(on) {
    this.node.hidden = !on;
    if (on) this.soon();
    else this.reveal();
  }

  // What can be done at the event that is shown.
  look() {
    const event = this.lab.impact();
    allow(this.lies, event);
    allow(this.takes, event);
    allow(this.takesAll, this.lab.impacts().length);
  }

  // --- trials ------------------------------------------------------------------------------------

  take(events) {
    const [error, speedError] = [Number(this.angle.select.value), Number(this.speed.select.value)];
    const [step, speedStep] = [division(error, 0.1, 0.5), speedError ? 0.01 : 0.001];
    const rows = events.filter(Boolean).map((event) => {
      const [u, v] = [event.before, event.after].map((when) => when[event.bodies[0]]);
      const alpha = read(toWall(event, u), error, step, step, 90 - step);
      const beta = read(toWall(event, v), error, step, 0, 90);
      const sizes = [u, v].map((w) => read(size(w), speedError, speedStep, speedStep, Infinity));
      return [alpha, beta, ...sizes].map(String);
    });
    if (!rows.length) {
      this.lab.refuse("Nothing hits a wall here. Play until something does, or throw it at one.");
      return;
    }
    this.put([...this.rows, ...rows]);
  }

  add() {
    this.put([...this.rows, ["", "", "", ""]]);
    this.body.lastElementChild?.querySelector("input").focus();
  }

  empty() {
    this.put([]);
  }

  put(rows) {
    if (rows.length > MOST) {
      this.lab.refuse(`There is room for ${MOST} trials.`);
      return;
    }
    this.rows = rows;
    this.remember();
    this.lay();
  }

  lay() {
    const columns = this.speeds.checked ? COLUMNS : COLUMNS.slice(0, 2);
    const head = (...words) => html("th", { scope: "col" }, ...words);
    const heads = columns.map(([, letter, what]) =>
      head(html("var", {}, letter), html("span", { class: "unit" }, ` ${what}`)));
    this.heads.replaceChildren(
      head("Trial"), ...heads, head(...prose("tan β / tan α")), html("td"));
    this.body.replaceChildren(...this.rows.map((row, i) => this.line(row, i, columns)));
    reachable(this.table);
    this.soon();
  }

  line(row, i, columns) {
    const quotient = html("td", {}, ratio(row));
    const cells = columns.map(([, letter], k) => {
      const field = html("input", {
        class: "number", inputmode: "decimal", value: row[k].replace("-", "−"),
        "aria-label": `${letter} of trial ${i + 1}`,
        oninput: () => {
          row[k] = field.value;
          const good = !row[k].trim() || !Number.isNaN(typed(row[k]));
          field.setAttribute("aria-invalid", String(!good));
          quotient.textContent = ratio(row);
          this.remember();
          this.soon();
        },
      });
      return html("td", {}, field);
    });
    const away = button("×", () => this.put(this.rows.filter((_, n) => n !== i)), {
      class: "away", "aria-label": `Take trial ${i + 1} away`, title: "Take it away",
    });
    const number = html("th", { scope: "row" }, String(i + 1));
    return html("tr", {}, number, ...cells, quotient, html("td", {}, away));
  }

  remembered() {
    try {
      const rows = JSON.parse(kept(NAME) ?? "[]");
      const good = (row) =>
        Array.isArray(row) && row.length === 4 && row.every((x) => typeof x === "string");
      return Array.isArray(rows) ? rows.filter(good).slice(0, MOST) : [];
    } catch {
      return [];
    }
  }

  remember() {
    keep(NAME, JSON.stringify(this.rows));
  }

  // --- e -----------------------------------------------------------------------------------------

  // The trials as a table that the fit takes; those with an empty cell are not there.
  data() {
    const names = (this.speeds.checked ? COLUMNS : COLUMNS.slice(0, 2)).map(([name]) => name);
    const rows = this.rows.filter((row) => names.every((_, k) => row[k].trim()));
    const cells = (row) => names.map((_, k) => row[k].trim()).join("\t");
    return rows.length ? [names.join("\t"), ...rows.map(cells)].join("\n") : "";
  }

  soon() {
    clearTimeout(this.timer);
    if (this.shown) this.timer = setTimeout(() => this.fit(), PAUSE);
  }

  // The errors that the fit is given: of the reading, and of the rounding.
  errors() {
    const rounding = (step) => step / Math.sqrt(12);
    const angle = Number(this.angle.select.value);
    const speed = Number(this.speed.select.value);
    return {
      angle_error: Math.hypot(angle, rounding(division(angle, 0.1, 0.5))),
      speed_error: Math.hypot(speed, rounding(speed ? 0.01 : 0.001)),
    };
  }

  async fit() {
    this.asking?.abort();
    const data = this.data();
    if (!data) {
      this.outcome.replaceChildren();
      return;
    }
    const giving = (this.asking = new AbortController());
    try {
      const asked = { data, ...this.errors() };
      this.report(await ask("experiment", asked, { signal: giving.signal }), data);
    } catch (error) {
      if (error.name === "AbortError") return;
      this.outcome.replaceChildren(html("p", {}, sentence(error.message)));
    }
  }

  report({ words, checks, pictures }, data) {
    const [value, interval] = words;
    const seen = checks.filter(({ verdict }) => verdict === "seen");
    if (this.picture) URL.revokeObjectURL(this.picture);
    const [plot] = pictures;
    this.picture = plot && URL.createObjectURL(new Blob([plot.svg], { type: "image/svg+xml" }));
    const { angle_error: angle, speed_error: speed } = this.errors();
    const of = { data, angle_error: written(angle) };
    if (this.speeds.checked) of.speed_error = written(speed);
    this.outcome.replaceChildren(
      html("p", { class: "value" }, ...prose(value)),
      html("p", {}, ...prose(interval)),
      ...seen.map((check) => html("p", { class: "seen" }, ...prose(check.sentence))),
      ...(plot ? [html("img", { src: this.picture, alt: plot.description })] : []),
      html("p", {}, html("a", { href: `./experiment${fragment(of)}` }, "Open in Experiment")),
    );
  }

  // --- a wall of unknown e -------------------------------------------------------------------------

  hide() {
    if (this.lab.concealed) this.reveal();
    else if (this.lab.conceal()) {
      this.empty();
      this.secret.textContent = "Show e of the walls";
    }
  }

  reveal() {
    this.lab.reveal();
    this.secret.textContent = "A wall of unknown e";
  }
}

// The quotient of the tangents of a trial, where both angles are there.
function ratio([alpha, beta]) {
  const tangents = [alpha, beta].map((text) => Math.tan((typed(text) * Math.PI) / 180));
  const quotient = tangents[1] / tangents[0];
  return Number.isFinite(quotient) && Math.abs(quotient) < 1000 ? quotient.toFixed(3) : "–";
}
