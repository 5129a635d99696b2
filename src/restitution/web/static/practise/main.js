// The page that practises: a question, the reader's own working, what is said of its lines, marks.

import { ask, sentence } from "../api.js";
import { button, html } from "../player/elements.js";
import { makeMotion } from "../solve/motion.js";
import { makePictures } from "../solve/pictures.js";
import { grown } from "../solve/trees.js";
import { makeWorking } from "../solve/working.js";
import { hold, link, onReturn, read } from "./address.js";
import { makeLetters } from "./letters.js";
import { makeRecord, today } from "./record.js";
import { makeReply } from "./reply.js";

const $ = (id) => document.getElementById(id);
const groups = JSON.parse($("topics").textContent); // [[group, [[id, title], …]], …]
const topics = Object.fromEntries(groups.flatMap(([, inside]) => inside));
const record = makeRecord();
const pictures = makePictures($("pictures"));
const working = makeWorking($("working"), { onLine() {} });
const letters = makeLetters($("letters-box"), { onChange: changed });
const reply = makeReply($("reply"), { onHint, onAgree, onPlay });
const motion = makeMotion($("motion"));

let question = null; // { statement, topic, level, seed, version, letters }
let solved = null; // the reply of `explain` for it
let markings = []; // of what stands in the field, or of what stood there before
let levels = new Map(); // of hints, by line
let finished = false;
let asking = null; // what is being fetched, to be given up

// --- choosing --------------------------------------------------------------------------------------

const meter = (share) =>
  html("meter", { min: 0, max: 1, value: share, "aria-label": "how sure you are of it" });

async function choose() {
  $("choosing").hidden = false;
  $("practising").hidden = $("worked").hidden = $("playing").hidden = true;
  document.title = "Practise – Restitution";
  draw({});
  const { sureness } = await ask("progress", { record: history() })
    .catch(() => ({ sureness: {} }));
  draw(sureness);
}

function draw(sureness) {
  const card = ([id, title]) =>
    html("li", {}, button([html("span", {}, title), id in sureness ? meter(sureness[id]) : ""],
      () => begin({ topic: id, level: chosenLevel() }), { class: "card" }));
  $("topic-list").replaceChildren(...groups.flatMap(([group, inside]) => [
    html("h3", {}, group), html("ul", { class: "topics" }, inside.map(card)),
  ]));
}

const chosenLevel = () => Number($("level").value) || null;

function carry() {
  const field = html("input", { type: "text", "aria-label": "Code of a record", size: 30 });
  const said = html("p", { class: "quiet", role: "status" });
  const give = button("Copy my code", async () => {
    field.value = record.code;
    field.select();
    await navigator.clipboard?.writeText(record.code).catch(() => {});
    said.textContent = "The code stands in the field. Type it on the other machine.";
  });
  const take = button("Take a code", () => {
    said.textContent = record.take(field.value) ? "Taken." : "This is no code of a record.";
    choose();
  });
  $("carrying").replaceChildren(field, html("div", { class: "choices" }, give, take), said);
}

// --- a question --------------------------------------------------------------------------------------

// `wanted` is { statement } or { topic, level, seed }; what is missing is chosen.
async function begin(wanted, { push = true } = {}) {
  asking?.abort();
  const giving = (asking = new AbortController());
  $("choosing").hidden = true;
  $("practising").hidden = false;
  clear();
  say("Preparing the question …");
  try {
    question = await ask("practise", { wanted: { ...told(wanted), ...history() } }, { signal: giving.signal });
    hold(addressOf(question), { push });
    solved = await ask("explain", { statement: question.statement }, { signal: giving.signal });
  } catch (error) {
    if (error.name === "AbortError") return;
    say(sentence(error.message), button("Try again", () => begin(wanted, { push })));
    return;
  }
  say(null);
  show();
}

// What is asked of the server, in the kinds that it takes.
function told({ statement, part, topic, level, seed }) {
  if (statement) return part ? { statement, part } : { statement };
  return {
    ...(topic ? { topic } : {}),
    ...(level ? { level: Number(level) } : {}),
    ...(seed !== undefined && seed !== null ? { seed: Number(seed) } : {}),
  };
}

const history = () => ({ attempts: record.attempts, day: today() });

const addressOf = ({ topic, level, seed, version, statement }) =>
  topic ? { topic, level, seed, version } : { statement };

function clear() {
  [markings, levels, finished, solved] = [[], new Map(), false, null];
  $("script").value = "";
  $("worked").hidden = $("playing").hidden = true;
  $("question").replaceChildren();
  pictures.put([]);
  reply.clear();
  letters.put([]);
}

function show() {
  const { answer, question: words, figure, working: parts } = solved;
  const marks = parts.reduce((sum, part) => sum + part.marks, 0);
  const { topic, level, seed } = question;
  document.title = `${answer.title ?? topics[topic] ?? "Practise"} – Restitution`;
  $("provenance").textContent = [
    topic && `${topics[topic]}, level ${level}, number ${seed}`,
    marks && `${marks} ${marks === 1 ? "mark" : "marks"}`,
  ].filter(Boolean).join(" · ");
  $("question").replaceChildren(words ? grown(words) : html("pre", {}, question.statement));
  pictures.put(figure ? [figure] : []);
  letters.put(question.letters);
  $("of-parts").hidden = parts.length < 2;
  working.put(parts);
  $("going").replaceChildren(
    button("Another like this", () => begin({ topic, level }), topic ? {} : { hidden: true }),
    button("Next question", () => begin({}), { class: "main" }),
    button("All topics", () => {
      hold(null);
      choose();
    }),
    button("Copy link", copy),
  );
  $("script").focus({ preventScroll: true });
}

async function copy({ target }) {
  await navigator.clipboard?.writeText(link(addressOf(question))).catch(() => {});
  target.textContent = "Link copied";
}

function say(text, ...more) {
  $("notice").replaceChildren(...(text ? [html("p", {}, text), ...more] : []));
  $("notice").hidden = !text;
}

// --- marking -------------------------------------------------------------------------------------------

function changed() {
  $("reply").classList.add("stale");
}

async function mark({ end = finished } = {}) {
  const script = $("script").value;
  if (!script.trim() || !question) return;
  asking?.abort();
  const giving = (asking = new AbortController());
  const hints = Object.fromEntries(levels);
  const body = { statement: question.statement, working: script, letters: letters.meanings, hints };
  $("reply").setAttribute("aria-busy", "true");
  try {
    const told = await ask("mark", body, { signal: giving.signal });
    markings = told.parts ?? [told];
  } catch (error) {
    if (error.name !== "AbortError") say(sentence(error.message));
    return;
  } finally {
    $("reply").setAttribute("aria-busy", "false");
  }
  say(null);
  finished = end;
  $("reply").classList.remove("stale");
  reply.put(markings, { finished, exam: false, levels });
  $("spoken").textContent = reply.spoken(markings);
  if (finished) end_();
}

// The working may be seen now, and what was earned is kept.
function end_() {
  $("worked").hidden = working.empty;
  const sum = (what) => markings.reduce((total, { marks }) => total + marks[what], 0);
  const points = markings.flatMap(({ marks }) => marks.points);
  const mistakes = markings.flatMap(({ lines }) => lines.map(({ mistake }) => mistake?.id));
  if (!question.topic) return;
  const { topic, level, seed } = question;
  record.add({
    topic, level, seed, day: today(), earned: sum("earned"), of: sum("of"),
    lost_method: points.some(({ kind, state }) => kind.includes("M") && state === "lost"),
    mistakes: mistakes.filter(Boolean),
  });
}

function onHint(line, level) {
  levels.set(line, level);
  mark();
}

// The motion with the mistake beside the true one.
async function onPlay(mistake, part) {
  const { statement } = question;
  const about = { statement, mistake, ...(part ? { part } : {}) };
  $("playing").hidden = false;
  motion.put(await ask("mistake", about)
    .catch((error) => ({ motion: null, motion_error: error.message })));
  $("playing").scrollIntoView({ block: "nearest" });
}

function onAgree(meaning) {
  letters.agree(meaning);
  mark();
}

$("script").addEventListener("input", changed);
$("check").addEventListener("click", () => mark());
$("finish").addEventListener("click", () => mark({ end: true }));
$("script").addEventListener("keydown", (event) => {
  if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) mark();
});
$("suggested").addEventListener("click", () => begin({ level: chosenLevel() }));

function start(wanted) {
  if (wanted) begin(wanted, { push: false });
  else choose();
}

carry();
onReturn(start);
start(read());
