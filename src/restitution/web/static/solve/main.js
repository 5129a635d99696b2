// The page that solves: what is typed on the left, what follows from it on the right.

import { draft, hides, hold, keepHidden, linkable, onReturn, told } from "./address.js";
import { makeEditor } from "./editor.js";
import { makeForeign } from "./foreign.js";
import { makeHiding } from "./hiding.js";
import { makeMotion } from "./motion.js";
import { makeNotice } from "./notice.js";
import { makeOpening } from "./opening.js";
import { lazily, makeFold, makePanel } from "./panels.js";
import { makePaper } from "./paper.js";
import { makePictures } from "./pictures.js";
import { answersOf, failure, mistakes, numbered, spoken } from "./results.js";
import { keepReachable } from "./scrolling.js";
import { makeShare } from "./share.js";
import { makeSolver } from "./solver.js";
import { grown } from "./trees.js";
import { makeWorking } from "./working.js";

const $ = (id) => document.getElementById(id);
const { words, sheet } = JSON.parse($("told").textContent);
const SETTLED = 500; // ms after the last key at which the address is written
const PATIENCE = 500; // ms for which mistakes are not shown while one types on
const SLOW = 2000; // ms after which it is said what takes its time
const MEANWHILE = 300; // ms for which the earlier working stands below answers that have come

const results = $("results");
const editor = makeEditor($("editor"), words, { onInput: byHand });
const pictures = makePictures($("pictures"));
const hiding = makeHiding({
  results, answers: $("answers"), note: $("hidden"), tools: $("hiding"), working: $("working"),
  worked: $("worked"), motion: $("moving"), question: $("wording"), unfold: $("unfold"),
}, { onChange: hidden, stepwise: () => working.stepwise() });
const working = makeWorking($("working"), {
  onLine(line) {
    hiding.follow(line);
    seePictures();
  },
});
const paper = makePaper($("figure"), $("withheld"));
const motion = makeMotion($("motion"));
const solver = makeSolver(show);
const notice = makeNotice($("notice"), () => solver.solve(editor.text));
const foreign = makeForeign($("foreign"), results);
const look = keepReachable($("answers"), "li");
const share = makeShare($("share"), now, { sheet, say });
const opening = makeOpening($("opening"), $("solve"), {
  onKind: fillIn, onWrite: write, onTopic: (topic) => browse(topic),
});
let solved = null; // the last { text, reply }
let settling = 0;
let pending = 0;

function typed(text) {
  clearTimeout(settling);
  settling = setTimeout(settle, SETTLED, text);
  solver.typed(text);
}

function byHand(text) {
  typed(text);
  readIntoForm();
}

function settle(text) {
  clearTimeout(settling);
  hold(text);
  $("long").hidden = linkable(text);
}

// Another statement in the place of this one, which Back brings back.
function replace(text) {
  if (!opening.open) settle(editor.text);
  opening.show(false);
  if (text !== editor.text) hold(text, { push: true });
  editor.put(text);
  $("long").hidden = linkable(text);
  solver.solve(text);
}

// The same from elsewhere than the form, which reads it.
function replaceAll(text) {
  replace(text);
  readIntoForm(0);
}

// --- what is shown -------------------------------------------------------------------------------

function now() {
  const current = solved !== null && solved.text === editor.text;
  return {
    text: editor.text,
    title: solved?.reply.answer.title,
    reply: current ? solved.reply : null,
    isWhole: current && solved.isWhole,
    picture: current ? pictures.shown : null,
    hidden: hiding.hidden,
  };
}

function show(state) {
  clearTimeout(pending);
  const { kind } = state;
  results.setAttribute("aria-busy", String(kind === "waiting" || kind === "early"));
  results.classList.toggle("stale", !["solved", "early", "empty"].includes(kind));
  if (kind !== "solved") $("spoken").textContent = ""; // of an earlier question
  if (kind === "waiting") pending = setTimeout(notice.doing, SLOW, "Solving the question …");
  else notice.clear();
  const shows = {
    empty: showNothing, wrong: showMistakes, early: showSolved, solved: showSolved,
    refused: showRefusal,
  };
  shows[state.kind]?.(state);
  share.update();
}

function showNothing() {
  solved = null;
  mark([]);
  results.hidden = true;
  $("start").hidden = false;
  document.title = "Solve – Restitution";
}

function showMistakes({ errors }) {
  $("start").hidden = true;
  // Whoever is still typing the word need not be told.
  pending = setTimeout(mark, document.activeElement === $("statement") ? PATIENCE : 0, errors);
}

function mark(errors) {
  editor.mark(errors);
  $("mistakes").replaceChildren(...mistakes(errors, editor));
  $("wrong-heading").textContent = numbered(errors.length);
  $("wrong").hidden = !errors.length;
}

function showRefusal({ error }) {
  notice.refused(error);
}

async function showSolved({ kind, text, reply }) {
  if (text === editor.text) settle(text); // so that Back and Forward bring back what was solved
  const isWhole = kind === "solved";
  const isFirst = results.hidden;
  solved = { text, reply, isWhole };
  const { answer } = reply;
  mark([]);
  results.hidden = false;
  $("start").hidden = true;
  document.title = `${answer.title ?? "Solve"} – Restitution`;
  $("title").textContent = answer.title ?? "";
  $("title").hidden = !answer.title;
  $("answers").replaceChildren(...answersOf(reply, editor));
  $("own").href = `practise#${new URLSearchParams({ statement: text })}`;
  look();
  $("wording").hidden = reply.question === null;
  if (reply.question !== null) $("question").replaceChildren(grown(reply.question));
  hiding.put(reply, isWhole, !isFirst);
  reason("pictures", reply.pictures.length ? null : reply.pictures_error);
  if (isWhole) {
    showWorking(reply);
    $("spoken").textContent = hiding.instead ?? spoken(reply);
  } else pending = setTimeout(awaitWorking, isFirst ? 0 : MEANWHILE, reply);
  paper.put(reply);
  await seePictures();
}

function showWorking(reply) {
  working.put(reply.working);
  reason("working", working.empty ? reply.working_error : null);
  $("worked").hidden = working.empty && !reply.working_error;
  motion.put(reply);
}

// What stands there is of an earlier text; most often its successor comes before anyone sees that.
function awaitWorking(reply) {
  hiding.put(reply, false);
  showWorking(reply);
  notice.doing("The answers are there. The working is being written …");
}

async function seePictures() {
  const { reply } = solved;
  const seen = hiding.pictures(reply);
  $("pictures").hidden = !seen.length;
  $("pictured").hidden = !seen.length && (hiding.hidden || !reply.pictures_error);
  const withheld = seen !== reply.pictures;
  if (withheld || $("withheld").firstChild) paper.withhold(withheld ? reply.pictures : []);
  await pictures.put(seen);
  share.update();
}

function hidden() {
  keepHidden(hiding.hidden);
  if (editor.text.trim()) settle(editor.text);
  hiding.update();
  if (solved) {
    $("spoken").textContent = hiding.instead === null ? spoken(solved.reply) : "";
    seePictures();
  }
  say(hiding.hidden ? "The answers are hidden." : "The answers are shown.");
}

function reason(what, said) {
  $(`no-${what}`).replaceChildren(...(said ? [failure({ message: said })] : []));
}

function say(text) {
  $("said").textContent = text;
  clearTimeout(say.timer);
  say.timer = setTimeout(() => ($("said").textContent = ""), 6000);
}

// --- panels --------------------------------------------------------------------------------------

const examples = makePanel("Examples", "examples", lazily(
  "gallery.css",
  () => import("./gallery.js"),
  ({ mountGallery }, body, close) =>
    mountGallery(body, { onChoose: (_, text) => chosen(text, close) }),
));
let fields = null; // the form, once it has been opened
let reading = 0;

async function browse(topic) {
  const gallery = await examples();
  gallery?.go(topic);
}

const form = makeFold($("form"), $("filling"), lazily(
  "form.css",
  () => import("./form.js"),
  ({ mountForm }, body) => {
    fields = mountForm(body, {
      words, onStatement: written, onState: foreign.put, current: () => editor.text,
    });
    fields.read(editor.text);
  },
));
const help = makePanel("The language", "language", lazily(
  null,
  () => import("./help.js"),
  ({ mountHelp }, body) => mountHelp(body, words),
));

function chosen(text, close) {
  close();
  replaceAll(text);
  editor.focus();
}

let writing = false; // whether the form has already begun an entry of the history

function written(text) {
  if (writing) {
    editor.put(text);
    typed(text);
  } else replace(text);
  writing = true;
}

// --- ways to begin -------------------------------------------------------------------------------

function write() {
  opening.show(false);
  hold("", { push: true });
  editor.focus();
}

async function fillIn(kind) {
  write();
  writing = true;
  if ($("filling").hidden) await form();
  $("filling").querySelector(`input[name="kind"][value="${kind}"]`)?.click();
}

$("begin").addEventListener("click", () => {
  settle(editor.text);
  hold(null, { push: true });
  start(null);
});
$("examples").addEventListener("click", () => browse(null));
// What is typed by hand goes into the form as well, while it is open.
function readIntoForm(pause = PATIENCE) {
  clearTimeout(reading);
  if (!fields || $("filling").hidden) return;
  foreign.put({ kind: "read", problems: [] });
  reading = setTimeout(() => fields.read(editor.text), pause);
}

$("form").addEventListener("click", () => {
  writing = false;
  form();
  if ($("filling").hidden) foreign.put({ kind: "read", problems: [] });
  else readIntoForm(0);
});
$("unfold").addEventListener("click", () => {
  const open = !$("question").classList.toggle("folded");
  $("unfold").setAttribute("aria-expanded", String(open));
});
$("language").addEventListener("click", help);
$("filling").addEventListener("submit", () => {
  form();
  editor.focus();
});
$("new").addEventListener("click", () => {
  replaceAll("");
  editor.focus();
});

// Where there is one column, what is wrong stands right below the editor.
const wide = matchMedia("(min-width: 60em)");

function lay() {
  if (wide.matches) $("notice").before($("wrong"));
  else $("editor").after($("wrong"));
}

wide.addEventListener("change", lay);
lay();

// --- the start -----------------------------------------------------------------------------------

// The choice of ways to begin where nothing is stated, else the editor.
function start(text) {
  clearTimeout(settling);
  opening.show(text === null);
  editor.put(text ?? "");
  solver.solve(text ?? "");
  readIntoForm(0);
}

onReturn((text) => {
  // What is hidden stays so: an address from before shows nothing.
  if (hides()) hiding.begin(true);
  else keepHidden(hiding.hidden);
  start(text);
});

function begin() {
  const hide = hides();
  const text = told() ?? draft();
  $("sharing").open = wide.matches;
  start(text?.trim() ? text : null);
  if (!opening.open) settle(text);
  hiding.begin(hide);
}

begin();
