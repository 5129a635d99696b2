// What the page opens on: a form by what happens, a question of one's own, an example by topic, the
// Lab. Its words come with the page; the pictures of the form are drawn when it is first seen.

import { style } from "../styles.js";

// `onKind(kind)`, `onWrite()` and `onTopic(topic)` are told what is chosen.
export function makeOpening(root, beside, { onKind, onWrite, onTopic }) {
  const kinds = [...root.querySelectorAll("[data-kind]")];
  let drawn = false;

  async function draw() {
    if (drawn) return;
    drawn = true;
    const [{ picture }] = await Promise.all([import("./form-pictures.js"), style("form.css")]);
    for (const each of kinds) each.firstElementChild.replaceChildren(picture(each.dataset.kind));
  }

  for (const each of kinds) each.addEventListener("click", () => onKind(each.dataset.kind));
  root.querySelector("#write").addEventListener("click", onWrite);
  for (const each of root.querySelectorAll("[data-topic]")) {
    each.addEventListener("click", () => onTopic(each.dataset.topic));
  }

  return {
    get open() {
      return !root.hidden;
    },
    show(on) {
      root.hidden = !on;
      beside.hidden = on;
      if (on) draw().catch(() => {}); // plain, and works
    },
  };
}
