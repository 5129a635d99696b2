// What stands on paper only: the picture of the question, room for working, and the diagrams that
// the screen withholds.

import { html } from "../player/elements.js";

const [LEAST, MOST] = [6, 18]; // centimetres of room

export function makePaper(figure, withheld) {
  const addresses = new Map([[figure, []], [withheld, []]]);

  function images(root, pictures) {
    addresses.get(root).forEach((each) => URL.revokeObjectURL(each));
    const made = pictures.map(({ svg }) =>
      URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" })));
    addresses.set(root, made);
    return pictures.map(({ description }, k) => html("img", { alt: description, src: made[k] }));
  }

  return {
    // A centimetre of room for each mark.
    put({ figure: told, working }) {
      const marks = working.reduce((sum, part) => sum + part.marks, 0);
      const room = html("div", { class: "room" });
      room.style.height = `${Math.min(Math.max(marks, LEAST), MOST)}cm`;
      figure.replaceChildren(...images(figure, told ? [told] : []), room);
    },
    withhold: (pictures) => withheld.replaceChildren(...images(withheld, pictures)),
  };
}
