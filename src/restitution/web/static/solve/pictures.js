// The diagrams: one at a time, each enlarged when it is chosen; all of them on paper.

import { html } from "../dom.js";

export function makePictures(root) {
  const figures = html("div", { class: "figures" });
  const previous = html("button", { type: "button", onclick: () => show(at - 1) }, "Previous");
  const next = html("button", { type: "button", onclick: () => show(at + 1) }, "Next");
  const count = html("span", { class: "progress", role: "status" });
  const turning = html("div", { class: "pace" }, previous, count, next);
  root.append(figures, turning);
  let pictures = [];
  let addresses = [];
  let at = 0;

  function show(index) {
    at = Math.max(0, Math.min(index, pictures.length - 1));
    [...figures.children].forEach((figure, k) => figure.classList.toggle("aside", k !== at));
    turning.hidden = pictures.length < 2;
    previous.disabled = at === 0;
    next.disabled = at === pictures.length - 1;
    count.textContent = `${at + 1} of ${pictures.length}`;
  }

  // A picture in a window of its own size, to be turned with the arrows.
  function enlarge(index) {
    const image = html("img");
    const said = html("p");
    const close = html("button", { type: "button", onclick: () => dialog.close() }, "Close");
    const dialog = html("dialog", { class: "large", "aria-label": "Diagram", closedby: "any" }, image, html("div", { class: "pace" }, said, close));
    const turn = (to) => {
      show(to);
      image.src = addresses[at];
      image.alt = pictures[at].description;
      said.textContent = pictures[at].title;
    };
    dialog.addEventListener("keydown", ({ key }) => {
      if (key === "ArrowRight") turn(at + 1);
      if (key === "ArrowLeft") turn(at - 1);
    });
    dialog.addEventListener("close", () => {
      dialog.remove();
      figures.children[at].querySelector("button").focus();
    });
    document.body.append(dialog);
    turn(index);
    dialog.showModal();
  }

  return {
    get shown() {
      return pictures[at] ?? null;
    },
    // New pictures; those that are seen stay until the new ones can be.
    async put(given) {
      const same = given.length === pictures.length && given.every(({ svg }, k) => svg === pictures[k].svg);
      if (same) return;
      const made = given.map(({ svg }) => URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" })));
      const old = addresses;
      const kept = given.length === pictures.length ? at : 0;
      [pictures, addresses] = [given, made];
      const nodes = given.map(({ title, description }, k) => {
        const image = html("img", { src: made[k], alt: description });
        const open = html("button", { type: "button", class: "picture", title: "Enlarge", onclick: () => enlarge(k) }, image);
        return html("figure", {}, open, html("figcaption", {}, title));
      });
      await nodes[kept]?.querySelector("img").decode().catch(() => {});
      if (addresses !== made) return; // superseded in the meantime
      figures.replaceChildren(...nodes);
      show(kept);
      old.forEach((each) => URL.revokeObjectURL(each));
    },
  };
}
