// Keeps up with the statement: checks it a moment after the last key, solves it if it reads, keeps
// the replies, and gives up what is superseded.

import { ask } from "../api.js";

const PAUSE = 150; // ms after the last key
const QUICK = 400; // ms: who is answered within these is asked at once when a number changes
const KEPT = 60; // replies

// What is told of the statement, each with its text:
//   { kind: "empty" }  { kind: "waiting" }  { kind: "wrong", errors }  { kind: "refused", error }
//   { kind: "early", reply }  where the working takes its time  { kind: "solved", reply }
export function makeSolver(tell) {
  let taken = PAUSE; // ms that the last answer took
  let readable = null; // the words of the last statement that was answered
  const kept = new Map();
  let current = "";
  let timer = 0;
  let underWay = null;

  function keep(text, told) {
    kept.set(text, told);
    if (kept.size > KEPT) kept.delete(kept.keys().next().value);
    return told;
  }

  async function find(text, asking) {
    const { signal } = asking;
    const began = performance.now();
    const answered = () => {
      taken = performance.now() - began;
      readable = wordsOf(text);
    };
    let early = null;
    const onEarly = (found) => {
      early = found;
      answered();
      if (current === text) tell({ kind: "early", text, reply: early });
    };
    const explain = () =>
      ask("explain", { statement: text, early: true }, { signal, onEarly });
    // With other numbers what could be read can nearly always be read again.
    const explaining = isOtherNumbers(text) ? explain() : null;
    explaining?.catch(() => {}); // told below
    const { errors } = await ask("check", { statement: text }, { signal });
    if (errors.length) {
      asking.abort();
      return keep(text, { kind: "wrong", text, errors });
    }
    const reply = await (explaining ?? explain());
    if (!early) answered();
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
      const told = await find(text, mine);
      if (current === text) tell(told);
    } catch (error) {
      if (error.name !== "AbortError" && current === text) tell({ kind: "refused", text, error });
    } finally {
      if (underWay === mine) underWay = null;
    }
  }

  const isOtherNumbers = (text) => wordsOf(text) === readable;

  // Whoever writes a word is in the midst of it; a number may be whole with each key. So it is asked
  // for at once, unless that would pile up work: behind the last key, or where answers take long.
  function pauseBefore(text) {
    if (!isOtherNumbers(text)) return PAUSE;
    if (underWay) return Math.min(taken, PAUSE);
    return taken < QUICK ? 0 : PAUSE;
  }

  function consider(text, pause) {
    current = text;
    clearTimeout(timer);
    underWay?.abort();
    underWay = null;
    if (!text.trim()) return tell({ kind: "empty", text });
    const told = kept.get(text);
    if (told) return tell(told);
    tell({ kind: "waiting", text });
    if (pause) timer = setTimeout(start, pause, text);
    else start(text);
  }

  return {
    typed: (text) => consider(text, pauseBefore(text)),
    solve: (text) => consider(text, 0),
  };
}

// The same for statements that differ in their numbers alone.
export const wordsOf = (text) => text.replace(/[\d.+\-−/%°\s]+/g, " ");
