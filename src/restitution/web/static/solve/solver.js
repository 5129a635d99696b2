// Keeps up with the statement: checks it a moment after the last key, solves it if it reads, keeps
// the replies, and gives up what is superseded.

import { ask } from "../api.js";

const PAUSE = 150; // ms after the last key
const KEPT = 60; // replies

// What is told of the statement, each with its text:
//   { kind: "empty" }  { kind: "waiting" }  { kind: "wrong", errors }  { kind: "refused", error }
//   { kind: "early", reply }  where the working takes its time  { kind: "solved", reply }
export function makeSolver(tell) {
  const kept = new Map();
  let current = "";
  let timer = 0;
  let underWay = null;

  function keep(text, told) {
    kept.set(text, told);
    if (kept.size > KEPT) kept.delete(kept.keys().next().value);
    return told;
  }

  async function find(text, signal) {
    const { errors } = await ask("check", { statement: text }, { signal });
    if (errors.length) return keep(text, { kind: "wrong", text, errors });
    let early = null;
    const onEarly = (found) => {
      early = found;
      if (current === text) tell({ kind: "early", text, reply: early });
    };
    const reply = await ask("explain", { statement: text, early: true }, { signal, onEarly });
    const { error } = reply.answer;
    const passing = error?.kind === "time limit";
    // What was there before its process was ended stays.
    const kept = passing && early && !early.answer.error;
    const told = { kind: "solved", text, reply: kept ? { ...early, working_error: error.message } : reply };
    return passing ? told : keep(text, told);
  }

  async function start(text) {
    underWay?.abort();
    const mine = new AbortController();
    underWay = mine;
    try {
      const told = await find(text, mine.signal);
      if (current === text) tell(told);
    } catch (error) {
      if (error.name !== "AbortError" && current === text) tell({ kind: "refused", text, error });
    }
  }

  function consider(text, pause) {
    current = text;
    clearTimeout(timer);
    underWay?.abort();
    if (!text.trim()) return tell({ kind: "empty", text });
    const told = kept.get(text);
    if (told) return tell(told);
    tell({ kind: "waiting", text });
    if (pause) timer = setTimeout(start, pause, text);
    else start(text);
  }

  return {
    typed: (text) => consider(text, PAUSE),
    solve: (text) => consider(text, 0),
  };
}
