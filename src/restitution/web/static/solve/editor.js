// The editor: a plain text field, and behind it a layer that shows the same text in colours, with
// what is wrong underlined at its place. The layer is in the flow and gives the field its height.

import { html } from "../player/elements.js";
import { offers } from "./completion.js";
import { declared, lexicon, pieces } from "./highlight.js";
import { makeListbox } from "./listbox.js";

const WORD = /[\p{L}\p{N}_]+|./uy;

export function makeEditor(root, words, { onInput }) {
  const field = root.querySelector("textarea");
  const layer = root.querySelector(".layer");
  const lexis = lexicon(words);
  const list = makeListbox(field, { onTake: take });
  let drawn = []; // what each line of the layer shows
  let marks = []; // { line, column, text: what the line was }
  let offered = null;

  function draw() {
    const names = declared(field.value);
    const known = [...names].flat().join();
    const lines = field.value.split("\n");
    const shown = lines.map((line, index) => {
      const wrong = marks.find((mark) => mark.line === index + 1 && mark.text === line);
      return { line, column: wrong?.column ?? null, known };
    });
    shown.forEach((now, index) => {
      const was = drawn[index];
      if (was && Object.keys(now).every((key) => now[key] === was[key])) return;
      const node = lineOf(now, names, lexis);
      if (was) layer.children[index].replaceWith(node);
      else layer.append(node);
    });
    while (layer.children.length > shown.length) layer.lastChild.remove();
    drawn = shown;
  }

  function suggest(asked = false) {
    const at = field.selectionStart;
    const caret = at === field.selectionEnd;
    offered = caret ? offers(field.value, at, words, declared(field.value), asked) : null;
    if (offered === null) list.close();
    else list.open(offered.options, offered.sure, placeOf(offered.from));
  }

  function take(option) {
    const at = field.selectionStart;
    field.setSelectionRange(offered.from, at);
    type(field, option.insert);
  }

  // Where a character of the text stands in the window.
  function placeOf(offset) {
    const before = field.value.slice(0, offset).split("\n");
    const node = layer.children[before.length - 1];
    const column = before.at(-1).length;
    const walker = document.createTreeWalker(node, NodeFilter.SHOW_TEXT);
    let passed = 0;
    for (let text = walker.nextNode(); text; text = walker.nextNode()) {
      if (passed + text.length >= column) {
        const range = document.createRange();
        range.setStart(text, column - passed);
        range.collapse(true);
        const box = range.getClientRects()[0];
        if (box) return box;
      }
      passed += text.length;
    }
    return node.getBoundingClientRect();
  }

  field.addEventListener("input", () => {
    draw();
    suggest();
    onInput(field.value);
  });
  field.addEventListener("keydown", (event) => {
    const { key, ctrlKey, altKey } = event;
    const wanted = (key === " " && ctrlKey) || (key === "ArrowDown" && altKey);
    if (wanted && !list.isOpen) {
      event.preventDefault();
      suggest(true);
    } else list.key(event);
  });
  field.addEventListener("blur", () => list.close());
  document.addEventListener("selectionchange", () => {
    if (list.isOpen && field.selectionStart !== list.at) list.close();
  });

  root.classList.add("live");
  field.rows = 1; // as high as the layer
  draw();

  return {
    get text() {
      return field.value;
    },
    // Another text altogether.
    put(text) {
      field.value = text;
      marks = [];
      list.close();
      draw();
    },
    mark(errors) {
      const lines = field.value.split("\n");
      marks = errors
        .filter(({ line }) => line !== null && line <= lines.length)
        .map(({ line, column }) => ({ line, column: column ?? 1, text: lines[line - 1] }));
      field.setAttribute("aria-invalid", String(errors.length > 0));
      draw();
    },
    goTo(line, column) {
      const lines = field.value.split("\n");
      const before = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0);
      const [start, end] = extent(lines[line - 1] ?? "", column ?? 1);
      field.focus();
      field.setSelectionRange(before + start, before + end);
      layer.children[line - 1]?.scrollIntoView({ block: "nearest" });
    },
    // The edits of a cure, made as if they were typed, the last one in the text first.
    mend({ edits }) {
      const { value } = field;
      const stretches = edits.map(({ line, column, end_line, end_column, text }) =>
        [offsetOf(value, line, column), offsetOf(value, end_line, end_column), text]);
      for (const [start, end, text] of stretches.sort(([a], [b]) => b - a)) {
        field.focus();
        field.setSelectionRange(start, end);
        type(field, text);
      }
      list.close();
    },
    focus: () => field.focus(),
  };
}

// Where a place stands in a text; lines and columns count from 1, columns in characters.
function offsetOf(text, line, column) {
  const lines = text.split("\n");
  const before = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0);
  return before + [...(lines[line - 1] ?? "")].slice(0, column - 1).join("").length;
}

// Text put in as if it were typed, so that it can be undone.
function type(field, text) {
  if (document.execCommand("insertText", false, text)) return;
  field.setRangeText(text, field.selectionStart, field.selectionEnd, "end");
  field.dispatchEvent(new Event("input", { bubbles: true }));
}

function lineOf({ line, column }, names, lexis) {
  const node = html("div", { class: "row" });
  let at = 0;
  const [start, end] = column === null ? [Infinity, Infinity] : extent(line, column);
  for (const { kind, text } of pieces(line, names, lexis)) {
    const cuts = [0, start - at, end - at, text.length]
      .map((cut) => Math.min(Math.max(cut, 0), text.length));
    for (let k = 0; k < 3; k += 1) {
      if (cuts[k] === cuts[k + 1]) continue;
      const name = `${kind}${k === 1 ? " wrong" : ""}`.trim();
      const said = text.slice(cuts[k], cuts[k + 1]);
      node.append(name ? html("span", { class: name }, said) : said);
    }
    at += text.length;
  }
  const beyond = column !== null && start >= line.length;
  if (beyond) node.append(html("span", { class: "wrong" }, "\u00a0"));
  if (!node.firstChild) node.append(html("br"));
  return node;
}

// The first and the last offset of the word at a column; columns count characters from 1.
function extent(line, column) {
  const start = [...line].slice(0, column - 1).join("").length;
  WORD.lastIndex = start;
  const word = WORD.exec(line);
  return [start, start + (word ? word[0].length : 0)];
}
