// The examples by topic, each with a small picture; typing narrows them down.

import { button, html } from "../player/elements.js";

// `onChoose(name, text)` is told the example that was chosen and its statement.
export function mountGallery(element, { onChoose }) {
  const field = html("input", {
    type: "search", id: "gallery-field", autocomplete: "off", spellcheck: "false",
    placeholder: "corner, energy, deflection…", oninput: () => narrow(),
  });
  const count = html("p", { class: "count", role: "status" });
  const topics = html("div", { class: "topics" });
  const root = html("div", { class: "gallery" },
    html("div", { class: "find" },
      html("label", { for: "gallery-field" }, "Find an example"), field, count),
    topics);
  let shown = [];

  function card({ name, title, topic, statement }) {
    const image = html("img", {
      src: `thumbnails/${name}.svg`, alt: "", loading: "lazy", decoding: "async",
      width: 200, height: 130, onerror: () => image.remove(),
    });
    const seen = [
      html("span", { class: "picture" }, image), html("span", { class: "title" }, title),
    ];
    const chosen = button(seen, () => onChoose(name, statement), { class: "card" });
    const words = `${title} ${topic} ${name} ${statement}`.toLowerCase();
    return { item: html("li", {}, chosen), words };
  }

  function show(examples) {
    const sections = Map.groupBy(examples, (each) => each.topic);
    for (const [topic, members] of sections) {
      const cards = members.map(card);
      const section = html("section", { "data-topic": topic },
        html("h3", {}, topic), html("ul", { class: "cards" }, ...cards.map((each) => each.item)));
      shown.push({ section, cards });
      topics.append(section);
    }
    narrow();
  }

  function narrow() {
    const wanted = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    let left = 0;
    for (const { section, cards } of shown) {
      let here = 0;
      for (const { item, words } of cards) {
        item.hidden = !wanted.every((word) => words.includes(word));
        here += !item.hidden;
      }
      section.hidden = here === 0;
      left += here;
    }
    const found = left === 1 ? "1 example" : `${left} examples`;
    count.textContent = left === 0 ? "No example has all these words." : found;
  }

  async function load() {
    topics.replaceChildren();
    shown = [];
    count.textContent = "Loading the examples…";
    try {
      const reply = await fetch("examples.json");
      if (!reply.ok) throw new Error(`the server says ${reply.status}`);
      show((await reply.json()).examples);
    } catch {
      count.textContent = "The examples cannot be loaded just now.";
      topics.append(button("Try again", load));
    }
  }

  element.append(root);
  const loaded = load();

  return {
    // A topic at the top, its first example at hand; null is the list as it stands.
    async go(topic) {
      if (topic === null) return;
      field.value = "";
      await loaded;
      narrow();
      const found = [...topics.children].find((each) => each.dataset.topic === topic);
      found?.scrollIntoView();
      found?.querySelector("button").focus({ preventScroll: true });
    },
  };
}
