// Asking the server. Every address is relative to the page.

export class Refused extends Error {
  constructor(status, message, wait) {
    super(message);
    this.status = status;
    this.wait = wait; // seconds after which to try again, or null
  }
}

export async function ask(what, body, { signal } = {}) {
  let reply;
  try {
    reply = await fetch(`api/${what}`, {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify(body),
      signal,
    });
  } catch (error) {
    if (error.name === "AbortError") throw error;
    throw new Refused(0, "The server does not answer.", null);
  }
  if (!reply.ok) {
    const told = await reply.json().catch(() => ({}));
    const wait = Number(reply.headers.get("Retry-After")) || null;
    throw new Refused(reply.status, told.error?.message ?? `The server says ${reply.status}.`, wait);
  }
  return reply.json();
}
