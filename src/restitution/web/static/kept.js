// What a tab remembers from page to page. A browser may refuse to keep anything: then nothing is
// remembered, and everything else goes on.

export function kept(name) {
  try {
    return sessionStorage.getItem(name);
  } catch {
    return null;
  }
}

export function keep(name, text) {
  try {
    sessionStorage.setItem(name, text);
  } catch {
    // The address and the history still hold it.
  }
}
