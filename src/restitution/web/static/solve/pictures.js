// The diagrams: one at a time, each enlarged when it is chosen; all of them on paper.

import { allow, button, html } from "../player/elements.js";

export function makePictures(root) {
  const figures = html("div", { class: "figures" });
  const previous = button("Previous", () => show(at - 1));
  const next = button("Next", () => show(at + 1));
  const count = html("span", { class: "progress", role: "status" });
  const turning = html("div", { class: "pace" }, previous, count, next);
  root.append(figures, turning);
  let pictures = [];
  let addresses = [];
  let at = 0;
  let enlarged = null; // the dialog of the large picture

  function show(index) {
    at = Math.max(0, Math.min(index, pictures.length - 1));
    [...figures.children].forEach((figure, k) => figure.classList.toggle("aside", k !== at));
    turning.hidden = pictures.length < 2;
    allow(previous, at > 0);
    allow(next, at < pictures.length - 1);
    const title = pictures[at]?.title ?? "";
    count.replaceChildren(
      `${at + 1} of ${pictures.length}`, html("span", { class: "unseen" }, `: ${title}`),
    );
  }

  // A picture in a window of its own size, to be turned with the arrows.
  function enlarge(index) {
    const image = html("img");
    const said = html("p");
    const close = button("Close", () => dialog.close());
    const dialog = html(
      "dialog",
      { class: "large", "aria-label": "Diagram", closedby: "any" },
      image,
      html("div", { class: "pace" }, said, close),
    );
    enlarged = dialog;
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
      enlarged = null;
      figures.children[at]?.querySelector("button").focus();
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
      const asMany = given.length === pictures.length;
      if (asMany && given.every(({ svg }, k) => svg === pictures[k].svg)) return;
      const made = given.map(({ svg }) =>
        URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" })));
      const old = addresses;
      const kept = asMany ? at : 0;
      [pictures, addresses] = [given, made];
      const nodes = given.map(({ title, description }, k) => {
        const image = html("img", { src: made[k], alt: description });
        const open = button(image, () => enlarge(k), { class: "picture", title: "Enlarge" });
        return html("figure", {}, open, html("figcaption", {}, title));
      });
      await nodes[kept]?.querySelector("img").decode().catch(() => {});
      old.forEach((each) => URL.revokeObjectURL(each)); // what is seen of them is loaded
      if (addresses !== made) return; // superseded in the meantime
      enlarged?.close();
      figures.replaceChildren(...nodes);
      show(kept);
    },
  };
}
