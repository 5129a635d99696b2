// What the server says of an experiment, as words on the page.

import { html } from "../player/elements.js";

// Words in which single letters are quantities, which are set in italics; "a" is a word.
const LETTER = /(?<![A-Za-zα-ω])([euvpxyt]|[αβ])(?![A-Za-zα-ω])/;

export const prose = (text) =>
  text.split(LETTER).map((piece, i) => (i % 2 ? html("var", {}, piece) : piece));

// With a capital, unless it begins with a quantity.
export const capital = (text) =>
  (LETTER.test(text[0]) && text[1] === " " ? text : text[0].toUpperCase() + text.slice(1));
