// Asking the server. Every address is relative to the page.

// `message` begins small and ends without a full stop, as the server's own do: see `sentence`.
class Refused extends Error {
  constructor(status, message, wait = null) {
    super(message);
    this.status = status; // 0 where there is no answer at all
    this.wait = wait; // seconds after which to try again, or null
  }
}

const unreachable = (error) => {
  if (error.name === "AbortError") throw error;
  throw new Refused(0, "the server does not answer");
};

// The reply to what is posted; throws Refused, or an AbortError where `signal` says so.
async function post(what, body, signal) {
  const reply = await fetch(`api/${what}`, {
    method: "POST",
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify(body),
    signal,
  }).catch(unreachable);
  if (reply.ok) return reply;
  const told = await reply.json().catch(() => ({}));
  signal?.throwIfAborted();
  const wait = Number(reply.headers.get("Retry-After")) || null;
  throw new Refused(reply.status, told.error?.message ?? `the server says ${reply.status}`, wait);
}

export async function ask(what, body, { signal } = {}) {
  const reply = await post(what, body, signal);
  return reply.json().catch(unreachable);
}

// The same for a file.
export async function fetched(what, body) {
  const reply = await post(what, body);
  return reply.blob().catch(unreachable);
}

// What the server says in a few words, as a sentence.
export const sentence = (said) =>
  `${said[0].toUpperCase()}${said.slice(1)}${/[.?!]$/.test(said) ? "" : "."}`;
