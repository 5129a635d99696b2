// The address of a question: a drawn one by topic, level and seed, or a statement of one's own.

const fragment = (told) => `#${new URLSearchParams(told)}`;

// What the address names: { topic, level, seed, version } or { statement, part }, or null.
export function read() {
  const told = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
  return told.statement || told.topic ? told : null;
}

// From now on the address is that of this question; null is none.
export function hold(told, { push = true } = {}) {
  const address = told === null ? "#" : fragment(told);
  if (address === (location.hash || "#")) return;
  if (push) history.pushState(null, "", address);
  else history.replaceState(null, "", address);
}

export const link = (told) => new URL(fragment(told), location.href).href;

export const onReturn = (go) => addEventListener("popstate", () => go(read()));
