// What stands on paper only: the picture of the question, room for working, and the diagrams that
// the screen withholds.

import { html } from "../player/elements.js";

const [LEAST, MOST] = [6, 18]; // centimetres of room
const LOADED = 10_000; // ms after which a picture that is gone is surely loaded, or not wanted

// The pictures in an element, made anew only where they are others.
function imagesIn(root) {
  let shown = [];
  let addresses = [];
  return (pictures, ...more) => {
    const same = pictures.length === shown.length &&
      pictures.every(({ svg }, k) => svg === shown[k].svg);
    if (same && !more.length) return;
    addresses.forEach((each) => setTimeout(() => URL.revokeObjectURL(each), LOADED));
    addresses = pictures.map(({ svg }) =>
      URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" })));
    shown = pictures;
    const images = pictures.map(({ description }, k) =>
      html("img", { alt: description, src: addresses[k] }));
    root.replaceChildren(...images, ...more);
  };
}

export function makePaper(figure, withheld) {
  const putFigure = imagesIn(figure);
  return {
    // A centimetre of room for each mark.
    put({ figure: told, working }) {
      const marks = working.reduce((sum, part) => sum + part.marks, 0);
      const room = html("div", { class: "room" });
      room.style.height = `${Math.min(Math.max(marks, LEAST), MOST)}cm`;
      putFigure(told ? [told] : [], room);
    },
    withhold: imagesIn(withheld),
  };
}
