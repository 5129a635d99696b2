// Asking the server. Every address is relative to the page.

// `message` begins small and ends without a full stop, as the server's own do: see `sentence`.
class Refused extends Error {
  constructor(status, message, { wait = null, line = null } = {}) {
    super(message);
    this.status = status; // 0 where there is no answer at all
    this.wait = wait; // seconds after which to try again, or null
    this.line = line; // of the text that was sent, which is to blame, or null
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
  const { message = `the server says ${reply.status}`, line = null } = told.error ?? {};
  throw new Refused(reply.status, message, { wait, line });
}

// The reply, whole; `onEarly` is told what of it is there before, where that takes its time: then the
// reply has two lines.
export async function ask(what, body, { signal, onEarly } = {}) {
  const reply = await post(what, body, signal);
  if (!onEarly) return reply.json().catch(unreachable);
  const reader = reply.body.pipeThrough(new TextDecoderStream()).getReader();
  let text = "";
  let whole = 0; // where the last line begins
  for (;;) {
    const { value, done } = await reader.read().catch(unreachable);
    if (done) break;
    text += value;
    const end = whole ? -1 : text.indexOf("\n");
    if (end < 0) continue;
    whole = end + 1;
    onEarly(JSON.parse(text.slice(0, end)));
  }
  let made;
  try {
    made = JSON.parse(text.slice(whole));
  } catch (error) {
    unreachable(error); // cut short
  }
  if (made.answer) return made;
  throw new Refused(503, made.error?.message ?? "the server broke off");
}

// The same for a file.
export async function fetched(what, body) {
  const reply = await post(what, body);
  return reply.blob().catch(unreachable);
}

// What the server says in a few words, as a sentence.
export const sentence = (said) =>
  `${said[0].toUpperCase()}${said.slice(1)}${/[.?!]$/.test(said) ? "" : "."}`;
