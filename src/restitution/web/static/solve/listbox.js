// A list of what could be typed, at the caret of a text field that keeps the focus.

import { html } from "../player/elements.js";

export function makeListbox(field, { onTake }) {
  const list = html("ul", {
    role: "listbox", id: "suggestions", class: "suggestions", "aria-label": "Suggestions",
  });
  list.hidden = true;
  field.after(list);
  field.setAttribute("aria-autocomplete", "list");
  field.setAttribute("aria-haspopup", "listbox");
  field.setAttribute("aria-controls", list.id);
  let options = [];
  let chosen = -1;
  let at = null; // where the caret was when the list was opened

  function close() {
    if (list.hidden) return;
    list.hidden = true;
    at = null;
    field.removeAttribute("aria-activedescendant");
  }

  function open(offered, sure, { left, bottom, top }) {
    options = offered;
    at = field.selectionStart;
    list.replaceChildren(
      ...options.map(({ word, about }, index) =>
        html(
          "li",
          { role: "option", id: `suggestion-${index}`, "aria-selected": "false" },
          html("b", {}, word),
          " ",
          html("span", {}, about ?? ""),
        ),
      ),
    );
    list.hidden = false;
    list.scrollTop = 0;
    choose(sure ? 0 : -1);
    const { offsetWidth: width, offsetHeight: height } = list;
    const below = bottom + 4;
    const fits = below + height <= innerHeight || top < height;
    list.style.left = `${Math.max(4, Math.min(left - 8, innerWidth - width - 4))}px`;
    list.style.top = `${fits ? below : top - height - 4}px`;
  }

  function choose(index) {
    list.children[chosen]?.setAttribute("aria-selected", "false");
    chosen = index;
    const option = list.children[chosen];
    option?.setAttribute("aria-selected", "true");
    option?.scrollIntoView({ block: "nearest" });
    if (option) field.setAttribute("aria-activedescendant", option.id);
    else field.removeAttribute("aria-activedescendant");
  }

  function take(index) {
    close();
    onTake(options[index]);
  }

  // The field keeps the focus.
  list.addEventListener("pointerdown", (event) => event.preventDefault());
  list.addEventListener("click", (event) => {
    const option = event.target.closest("[role=option]");
    if (option) take([...list.children].indexOf(option));
  });
  addEventListener("scroll", close, { passive: true });

  return {
    open,
    close,
    get isOpen() {
      return !list.hidden;
    },
    get at() {
      return at;
    },
    key(event) {
      const { ctrlKey, metaKey, altKey, isComposing } = event;
      if (list.hidden || ctrlKey || metaKey || altKey || isComposing) return;
      const does = {
        ArrowDown: () => choose((chosen + 1) % options.length),
        ArrowUp: () => choose((Math.max(chosen, 0) + options.length - 1) % options.length),
        Escape: close,
      };
      if (!event.shiftKey) does.Tab = () => take(Math.max(chosen, 0));
      if (chosen >= 0 && !event.shiftKey) does.Enter = () => take(chosen);
      if (!(event.key in does)) return;
      event.preventDefault();
      event.stopPropagation();
      does[event.key]();
    },
  };
}
