// What a motion is played with: its time, the impacts on it, buttons, and how fast it goes.

import { iconButton, ICONS } from "./controls.js";
import { html } from "./elements.js";
import { wordsOf } from "./motion.js";
import { seconds } from "./numbers.js";

const MARKED = 300; // events, beyond which none is marked

// `start` is what the first button says, its key and what it does; `play` and `next` take the place
// of what the clock does itself; speeds go down to 2 ** `slowest`, and are told as so many times
// `of`.
export class Transport {
  constructor(clock, { start, slowest = -3, of, play, next }) {
    const toggle = play ?? (() => clock.toggle());
    const step = next ?? (() => clock.next());
    this.clock = clock;
    this.of = of;
    this.time = html("input", { type: "range", step: "any", "aria-label": "Time" });
    this.marks = html("div", { class: "marks", "aria-hidden": "true" });
    this.timeline = html("div", { class: "timeline" }, this.time, this.marks);
    this.reading = html("span", { class: "clock" });
    this.play = iconButton("play", "Play", "Space", toggle);
    this.rate = html("input", { type: "range", min: slowest, max: 2, step: 0.5, value: 0 });
    this.rateSaid = html("span", { class: "said" }, "1×");
    this.node = html("div", { class: "transport" },
      iconButton("rewind", start.label, start.key, start.does).node,
      iconButton("previous", "Previous impact", "←", () => clock.previous()).node,
      this.play.node,
      iconButton("next", "Next impact", "→", step).node,
      this.reading,
      html("label", { class: "rate" }, "Speed", this.rate, this.rateSaid));
    this.keys = {
      " ": toggle,
      ArrowRight: step,
      ArrowLeft: () => clock.previous(),
      ".": () => clock.nudge(1),
      ",": () => clock.nudge(-1),
      Home: () => clock.rewind(),
      End: () => clock.leap(clock.motion.end),
      "+": () => this.faster(1),
      "=": () => this.faster(1),
      "-": () => this.faster(-1),
      "−": () => this.faster(-1),
    };
    this.time.addEventListener("input", () => {
      clock.pause();
      clock.seek(Number(this.time.value));
    });
    this.rate.addEventListener("input", () => this.setSpeed(2 ** Number(this.rate.value)));
  }

  // For another motion, or another width in pixels: where on the time its impacts are, numbered
  // where there is room.
  lay(width) {
    const { start, events } = this.clock.motion;
    const { span } = this.clock;
    this.time.min = start;
    this.time.max = start + span;
    let last = -Infinity;
    const made = (events.length > MARKED ? [] : events).map((event, i) => {
      const share = (event.time - start) / span;
      const room = (share - last) * width > 9 * String(i + 1).length + 4;
      if (room) last = share;
      const mark = html("span", { title: wordsOf(event) }, room ? String(i + 1) : "");
      mark.style.setProperty("--share", share);
      return mark;
    });
    this.marks.replaceChildren(...made);
  }

  // The time as it is now.
  show() {
    const said = seconds(this.clock.now);
    this.time.value = String(this.clock.now);
    this.time.setAttribute("aria-valuetext", said);
    this.reading.textContent = said;
  }

  // Whether it plays.
  turn() {
    const { node, path } = this.play;
    const { playing } = this.clock;
    const label = playing ? "Pause" : "Play";
    node.setAttribute("aria-label", label);
    node.setAttribute("title", `${label} (Space)`);
    path.setAttribute("d", playing ? ICONS.pause : ICONS.play);
  }

  setSpeed(speed) {
    this.clock.speed = speed;
    this.rateSaid.textContent = `${Number(speed.toPrecision(2))}×`;
    this.rate.setAttribute("aria-valuetext", `${this.rateSaid.textContent} ${this.of}`);
  }

  faster(sense) {
    this.rate.value = String(Number(this.rate.value) + 0.5 * sense);
    this.setSpeed(2 ** Number(this.rate.value));
  }
}
