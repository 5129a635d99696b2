// The motion of the very problem: the player is fetched when it is first seen.

import { sentence } from "../api.js";
import { html } from "../player/elements.js";
import { style } from "../styles.js";

const PLAYER = "../player/player.js";

export function makeMotion(root) {
  const said = html("p", { class: "quiet" });
  const stage = html("div");
  root.append(said, stage);
  let given = null; // { motion, motion_error }
  let played = null;
  let player = null;
  let seen = false;

  new IntersectionObserver(
    (entries) => {
      seen = entries.at(-1).isIntersecting;
      update();
    },
    { rootMargin: "200px" },
  ).observe(root);

  async function update() {
    if (!given || !seen || played === given) return;
    const { motion, motion_error: reason } = (played = given);
    say(motion ? null : sentence(reason ?? "there is no motion to play"));
    if (!motion) {
      player?.pause();
      return;
    }
    const loading = Promise.all([import(PLAYER), style("player/player.css")]);
    const [module] = await loading.catch(() => [null]);
    if (played?.motion !== motion) return; // superseded in the meantime
    if (!module) {
      say("The player could not be loaded. Is the server still there?");
      played = null; // to be tried again
    } else if (player) player.load(motion);
    else player = module.mount(stage, motion, { page: false, heading: "h3" });
  }

  function say(text) {
    said.textContent = text ?? "";
    said.hidden = text === null;
    stage.hidden = text !== null;
  }

  return {
    put(reply) {
      given = reply;
      if (!seen) { // what was played before is not of this question
        stage.hidden = true;
        player?.pause();
      }
      update();
    },
  };
}
