// Copying text. Browsers lend the clipboard to secure origins only; elsewhere the text is shown
// selected, and the reader copies it.

import { button, html } from "../player/elements.js";

// True where it was copied, false where the reader was given the text.
export async function copy(text, what) {
  if (navigator.clipboard?.writeText) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      // not allowed here
    }
  }
  offer(text, what);
  return false;
}

function offer(text, what) {
  const field = html("textarea", {
    readonly: true, rows: 8, "aria-label": what, spellcheck: "false",
  });
  field.value = text;
  const heading = html("h2", { id: "copy-heading" }, `Copy the ${what}`);
  const hint = html("p", {}, "Press Ctrl+C (on a Mac ⌘C), or hold the text on a phone.");
  const close = button("Close", () => dialog.close());
  const named = { class: "copying", "aria-labelledby": heading.id };
  const dialog = html("dialog", named, heading, hint, field, close);
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  field.focus();
  field.select();
}
