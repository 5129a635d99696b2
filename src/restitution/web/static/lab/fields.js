// Numbers to be typed: how they are read and written, and what the columns of the table hold.

import { html } from "../player/elements.js";
import { size } from "../player/numbers.js";

const DEGREE = Math.PI / 180;

// A number as people type it: 1.5, 1,5, −2, 3/4; NaN where it is none.
export function typed(text) {
  const [over, under, ...more] = text.trim().replace("−", "-").replace(",", ".").split("/");
  const number = (part) => (/^-?(\d+\.?\d*|\.\d+)$/.test(part.trim()) ? Number(part) : NaN);
  if (more.length) return NaN;
  return under === undefined ? number(over) : number(over) / number(under);
}

export const written = (x) =>
  String(Number((Math.abs(x) < 5e-7 ? 0 : x).toPrecision(4))).replace("-", "−");
const turn = (v) => (size(v) < 1e-12 ? 0 : Math.atan2(v[1], v[0]) / DEGREE);
const polar = (speed, degrees) => [
  speed * Math.cos(degrees * DEGREE), speed * Math.sin(degrees * DEGREE),
].map((x) => (Math.abs(x) < 1e-15 * speed ? 0 : x));
export const put = (pair, k, x) => pair.map((old, i) => (i === k ? x : old));

// What a column shows of a sphere, and the sphere with another value there.
const part = (key, k) => [(s) => s[key][k], (s, x) => ({ [key]: put(s[key], k, x) })];
const whole = (key) => [(s) => s[key], (s, x) => ({ [key]: x })];
export const COLUMNS = {
  mass: ["mass", "kg", ...whole("mass")],
  radius: ["radius", "m", ...whole("radius")],
  x: ["x", "m", ...part("position", 0)],
  y: ["y", "m", ...part("position", 1)],
  vx: ["velocity i", "m s⁻¹", ...part("velocity", 0)],
  vy: ["velocity j", "m s⁻¹", ...part("velocity", 1)],
  speed: [
    "speed", "m s⁻¹",
    ({ velocity }) => size(velocity),
    ({ velocity }, x) => ({ velocity: polar(x, turn(velocity)) }),
  ],
  direction: [
    "direction from i", "°",
    ({ velocity }) => turn(velocity),
    ({ velocity }, x) => ({ velocity: polar(size(velocity), x) }),
  ],
};
export const FORMS = {
  components: ["mass", "radius", "x", "y", "vx", "vy"],
  polar: ["mass", "radius", "x", "y", "speed", "direction"],
};
export const POSITIVE = ["mass", "radius"];

// A field shows a value, unless somebody is typing in it: nothing typed is lost.
export function show(field, text) {
  if (field === document.activeElement || field.value === text) return;
  field.value = text;
  field.removeAttribute("aria-invalid");
}

// Fields of one number, a slider with it for coefficients.
export function coefficient(label, value, change) {
  const slider = html("input", {
    type: "range", min: 0, max: 1, step: 0.01, value, "aria-label": `${label}, slider`,
    oninput: () => change(Number(slider.value)),
  });
  const field = html("input", {
    class: "number", inputmode: "decimal", value: written(value), "aria-label": label,
    onchange: () => {
      const e = typed(field.value);
      const right = e >= 0 && e <= 1;
      field.setAttribute("aria-invalid", String(!right));
      change(right ? e : null);
    },
  });
  const set = (e) => {
    if (document.activeElement !== slider) slider.value = e;
    show(field, written(e));
  };
  return { slider, field, set, node: html("span", { class: "coefficient" }, slider, field) };
}
