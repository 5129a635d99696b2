// The time of a motion: it plays, pauses, goes from impact to impact, and is slow at impacts.

import { smooth } from "./numbers.js";

const HOLD = 900; // ms that slow motion rests at an impact
const SLOWEST = 0.1; // of the usual rate, at an impact
const GLIDE = 450; // ms that a step takes
const STAY = 1800; // ms at each impact, for those who want little motion: they see steps

// `moved()` is called when the time has changed, `met(event)` when an event is passed or stepped
// to, `turned()` when it begins or ceases to play. `base` is how many seconds of the motion pass
// in one of the viewer's.
export class Clock {
  constructor({ moved, met, turned }) {
    this.told = { moved, met, turned };
    this.calm = matchMedia("(prefers-reduced-motion: reduce)");
    this.speed = 1;
    this.slow = true;
    this.playing = false;
    this.load({ start: 0, end: 0, events: [] }, 1);
  }

  load(motion, base) {
    this.pause();
    this.motion = motion;
    this.base = base;
    this.span = motion.end - motion.start || 1;
    this.now = motion.start;
    this.reaches = motion.events.map((_, i) => this.reach(i));
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  play() {
    if (this.playing) return;
    if (this.now >= this.motion.end - 1e-9 * this.span) this.seek(this.motion.start);
    this.glide = null;
    this.playing = true;
    this.hold = 0;
    this.told.turned();
    this.last = performance.now();
    this.request = requestAnimationFrame((now) => this.frame(now));
  }

  pause() {
    this.glide = null;
    if (!this.playing) return;
    this.playing = false;
    cancelAnimationFrame(this.request);
    this.told.turned();
  }

  frame(now) {
    if (!this.playing) return;
    const passed = Math.max(0, Math.min(now - this.last, 100));
    this.last = now;
    if (this.hold > 0) this.hold -= passed;
    else if (this.calm.matches) this.stride();
    else this.advance(passed / 1000);
    if (this.playing) this.request = requestAnimationFrame((next) => this.frame(next));
  }

  // Goes on by some seconds of the viewer's time, and not past an impact without showing it.
  advance(passed) {
    const from = this.now;
    let to = from + this.base * this.speed * this.ease(from) * passed;
    const met = this.motion.events[this.after(from)];
    if (met && met.time <= to) {
      this.told.met(met);
      if (this.slow) {
        to = met.time;
        this.hold = HOLD / Math.min(2, this.speed);
      }
    }
    if (to >= this.motion.end) {
      this.seek(this.motion.end);
      this.pause();
    } else this.seek(to);
  }

  // To the next impact at once, and to the end after the last.
  stride() {
    const met = this.motion.events[this.after(this.now + 1e-9 * this.span)];
    this.hold = STAY / Math.max(0.25, this.speed);
    if (met) this.told.met(met);
    this.seek(met ? met.time : this.motion.end);
    if (!met) this.pause();
  }

  // How much slower time goes near an impact.
  ease(t) {
    if (!this.slow) return 1;
    const { events } = this.motion;
    const near = this.beside(t).map((i) => Math.abs(events[i].time - t) / this.reaches[i]);
    return SLOWEST + (1 - SLOWEST) * smooth(Math.min(1, ...near));
  }

  // The place in the list of the first event after a time.
  after(t) {
    const { events } = this.motion;
    let low = 0;
    let high = events.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (events[middle].time <= t) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  // The last event before a time and the first one after it, by their places in the list.
  beside(t) {
    const after = this.after(t);
    return [after - 1, after].filter((i) => i >= 0 && i < this.motion.events.length);
  }

  // For how long before and after an event it is looked at closely.
  reach(index) {
    const { events } = this.motion;
    const { time } = events[index];
    const gaps = [];
    for (const sense of [-1, 1]) {
      let i = index + sense;
      while (events[i]?.time === time) i += sense;
      if (events[i]) gaps.push(Math.abs(events[i].time - time) / 2.2);
    }
    return Math.min(0.12 * this.span, ...gaps);
  }

  seek(t) {
    this.now = Math.max(this.motion.start, Math.min(this.motion.end, t));
    this.told.moved();
  }

  rewind() {
    this.leap(this.motion.start);
  }

  nudge(sense) {
    this.pause();
    this.seek(this.now + (sense * this.base * this.speed) / 15);
  }

  next() {
    const from = this.glide?.to ?? this.now;
    const met = this.motion.events[this.after(from + 1e-9 * this.span)];
    this.leap(met ? met.time : this.motion.end, met);
  }

  previous() {
    const from = this.glide?.to ?? this.now;
    const met = this.motion.events.findLast(({ time }) => time < from - 1e-9 * this.span);
    this.leap(met ? met.time : this.motion.start, met);
  }

  // To another time: swiftly, or at once for those who want little motion.
  leap(to, event) {
    this.pause();
    if (event) this.told.met(event);
    if (this.calm.matches || document.hidden) {
      this.seek(to);
      return;
    }
    const glide = { from: this.now, to, since: performance.now() };
    this.glide = glide;
    const step = (now) => {
      if (this.glide !== glide) return;
      const share = Math.min(1, Math.max(0, (now - glide.since) / GLIDE));
      if (share === 1) this.glide = null;
      this.seek(share === 1 ? to : glide.from + (to - glide.from) * smooth(share));
      if (share < 1) requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  // What there is to see now: the event that the time is at, the one that it is near to (looked at
  // closely), and the one that is spoken of (near, or passed last, or the first).
  scene() {
    const { motion, now } = this;
    const beside = this.beside(now);
    const away = (i) => Math.abs(motion.events[i].time - now);
    const at = beside.find((i) => away(i) < 1e-9 * this.span);
    const focus = at ?? beside.find((i) => away(i) <= this.reaches[i]);
    const shown = focus ?? beside.findLast((i) => motion.events[i].time <= now) ?? 0;
    const event = (i) => motion.events[i] ?? null;
    const moment = at !== undefined;
    return { focus: event(focus), moment, shown: event(shown), number: shown + 1 };
  }
}
