// The motion of the very problem: the player is fetched when it is first seen.

import { html } from "../dom.js";

const PLAYER = "../player/player.js";

export function makeMotion(root) {
  const said = html("p", { class: "quiet" });
  const stage = html("div");
  root.append(said, stage);
  let given = null; // { motion, motion_error }
  let played = null;
  let player = null;
  let seen = false;
  let fetched = null;

  new IntersectionObserver(
    (entries) => {
      seen = entries.at(-1).isIntersecting;
      update();
    },
    { rootMargin: "200px" },
  ).observe(root);

  const load = () => (fetched ??= Promise.all([import(PLAYER), style("player/player.css")]));

  async function update() {
    if (!given || !seen || played === given) return;
    const { motion, motion_error: reason } = (played = given);
    said.textContent = motion ? "" : `There is no motion to play: ${reason ?? "nothing moves"}.`;
    said.hidden = Boolean(motion);
    stage.hidden = !motion;
    if (!motion) return player?.pause();
    const [{ mount }] = await load();
    if (played.motion !== motion) return;
    if (player) player.load(motion);
    else player = mount(stage, motion, { page: false, heading: "h3" });
  }

  return {
    put(reply) {
      given = reply;
      update();
    },
  };
}

// A style sheet of the page's own, when it is first needed.
export function style(name) {
  const address = new URL(`../${name}`, import.meta.url).href;
  const known = [...document.querySelectorAll("link[rel=stylesheet]")].some(({ href }) => href === address);
  if (known) return Promise.resolve();
  return new Promise((done) => {
    document.head.append(html("link", { rel: "stylesheet", href: address, onload: done, onerror: done }));
  });
}
