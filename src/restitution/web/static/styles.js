// Style sheets of the page's own, each when it is first needed.

import { html } from "./player/elements.js";

// Done when it is there, or will not come: without it the page is plain, and works.
export function style(name) {
  const { href } = new URL(name, import.meta.url);
  const known = [...document.querySelectorAll("link[rel=stylesheet]")];
  if (known.some((link) => link.href === href)) return Promise.resolve();
  return new Promise((done) => {
    document.head.append(html("link", { rel: "stylesheet", href, onload: done, onerror: done }));
  });
}
