// The letters box: what each letter means, in words; a letter can be changed, a sense turned.

import { button, html } from "../player/elements.js";

// `rows` are { letter, meaning, words, turned, turned_words }, as the server has them; what has no
// sense has null for the last two.
export function makeLetters(root, { onChange }) {
  const body = html("tbody");
  root.append(html("table", {}, body));
  let rows = [];

  function draw() {
    body.replaceChildren(...rows.map((row, index) => {
      const named = html("input", {
        type: "text", value: row.letter, size: 4, maxlength: 12, spellcheck: "false",
        autocapitalize: "off", "aria-label": `Letter for the ${row.words}`,
        onchange: ({ target }) => {
          rows[index] = { ...row, letter: target.value.trim() };
          onChange();
          draw();
        },
      });
      const turn = row.turned && button("⇄", () => {
        const { letter, meaning, words, turned, turned_words } = row;
        rows[index] = {
          letter, meaning: turned, words: turned_words, turned: meaning, turned_words: words,
        };
        onChange();
        draw();
        body.rows[index].querySelector("button")?.focus();
      }, { class: "turn", title: "Turn its sense", "aria-label": `Turn the sense of ${row.letter}` });
      const drop = button("×", () => {
        rows = rows.filter((_, k) => k !== index);
        onChange();
        draw();
      }, { class: "drop", title: "I do not use it", "aria-label": `Leave out ${row.letter}` });
      return html("tr", {}, html("td", {}, named), html("td", { class: "means" }, row.words),
        html("td", {}, turn, drop));
    }));
  }

  return {
    put(given) {
      rows = given.map((row) => ({ ...row }));
      draw();
      root.closest("details").hidden = !rows.length;
    },
    // A meaning on which a letter has been agreed.
    agree({ letter, meaning, words }) {
      rows = [...rows.filter((row) => row.letter !== letter),
        { letter, meaning, words, turned: null, turned_words: null }];
      draw();
      root.closest("details").hidden = false;
      onChange();
    },
    // { letter: meaning }, as marking takes it.
    get meanings() {
      return Object.fromEntries(
        rows.filter(({ letter }) => letter).map(({ letter, meaning }) => [letter, meaning]));
    },
  };
}
