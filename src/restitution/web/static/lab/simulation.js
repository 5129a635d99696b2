// Motions of scenes, worked out by the server a moment after the last edit.

import { ask, sentence } from "../api.js";

const SOON = 120; // ms without another edit

// `came({ motion, stopped })`, `refused(error)` where a scene cannot be, or `failed(text)` where
// there is no answer; it is asked again by itself if that may help.
export class Simulation {
  constructor(told) {
    this.told = told;
  }

  // The motion of a scene, in the place of any that was asked for.
  request(scene, delay = SOON) {
    clearTimeout(this.timer);
    this.asking?.abort();
    this.timer = setTimeout(() => this.ask(scene), delay);
  }

  async ask(scene) {
    this.asking = new AbortController();
    const { signal } = this.asking;
    try {
      const told = await ask("simulate", { scene }, { signal });
      if (signal.aborted) return;
      if (told.motion) this.told.came(told);
      else this.told.refused(told.error);
    } catch (error) {
      if (error.name === "AbortError") return;
      const again = error.wait ? ` It is asked again in ${error.wait} s.` : "";
      this.told.failed(sentence(error.message) + again);
      if (error.wait) this.timer = setTimeout(() => this.ask(scene), 1000 * error.wait);
    }
  }
}
