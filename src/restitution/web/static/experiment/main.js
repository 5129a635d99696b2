// The page of experiments: a table that was pasted, and what comes of it, at once.

import { ask, fetched, sentence } from "../api.js";
import { button, html } from "../player/elements.js";
import { makePictures } from "../solve/pictures.js";
import { fragment, hold, read } from "./address.js";
import { EXAMPLES } from "./examples.js";
import { results } from "./results.js";
import { bare, KNOWN, USUAL, withHeader } from "./table.js";

const $ = (id) => document.getElementById(id);
const PAUSE = 350; // ms after the last letter
const LARGEST = 120_000; // characters, which the server takes with room to spare

const frame = html("div", { class: "pictures" });
const pictures = makePictures(frame);
let timer = null;
let asking = null;

// --- what is asked -----------------------------------------------------------------------------

const fields = () => ({
  data: $("data").value,
  angle_error: $("angle-error").value.trim(),
  speed_error: $("speed-error").value.trim(),
  from_normal: $("from-normal").checked ? "1" : "",
});

// An error as a number; null where none is given. Throws a text that says what is wrong.
function errorOf(id, name) {
  const text = $(id).value.trim().replace(/°$/, "").replace(",", ".");
  const value = Number(text);
  const good = text === "" || (Number.isFinite(value) && value > 0);
  $(id).setAttribute("aria-invalid", String(!good));
  if (!good) throw new Error(`${name}: an error is a number above 0`);
  return text === "" ? null : value;
}

function body() {
  const errors = {
    angle_error: errorOf("angle-error", "The error of an angle"),
    speed_error: errorOf("speed-error", "The error of a speed"),
  };
  const { data, from_normal: turned } = fields();
  if (data.length > LARGEST) {
    throw new Error(
      `The table has ${data.length} characters, and the page takes ${LARGEST}: the command ` +
      "restitution experiment reads more",
    );
  }
  const given = Object.entries(errors).filter(([, value]) => value !== null);
  return { data, from_normal: Boolean(turned), ...Object.fromEntries(given) };
}

async function analyse() {
  clearTimeout(timer);
  asking?.abort();
  const { data } = fields();
  name(data);
  if (!data.trim()) {
    hold(fields());
    clear();
    return;
  }
  if (!$("naming").hidden) return;
  const giving = (asking = new AbortController());
  $("results").setAttribute("aria-busy", "true");
  try {
    const reply = await ask("experiment", body(), { signal: giving.signal });
    hold(fields());
    show(reply);
  } catch (error) {
    if (error.name === "AbortError") return;
    say(error.line ? `Line ${error.line}: ${sentence(error.message)}` : sentence(error.message));
    $("results").classList.add("stale");
  } finally {
    if (asking === giving) $("results").setAttribute("aria-busy", "false");
  }
}

function soon() {
  clearTimeout(timer);
  timer = setTimeout(analyse, PAUSE);
}

// --- numbers without a header --------------------------------------------------------------------

// Asks what bare columns are.
function name(data) {
  const cells = bare(data);
  const had = $("naming").hidden;
  $("naming").hidden = cells === null;
  if (cells === null) return;
  const count = cells.length;
  if (had || $("columns").dataset.count !== String(count)) lay(cells);
}

function lay(cells) {
  const count = cells.length;
  $("columns").dataset.count = String(count);
  const choose = (usual, i) =>
    html("label", {}, `${cells[i]}, … `,
      html("select", { "aria-label": `Column ${i + 1}` },
        ...KNOWN[count].map((each) => html("option", { selected: each === usual }, each))));
  $("columns").replaceChildren(
    ...USUAL[count].map(choose),
    button("Put this header above them", () => {
      const names = [...$("columns").querySelectorAll("select")].map(({ value }) => value);
      $("data").value = withHeader($("data").value, names);
      analyse();
    }, { class: "main" }),
  );
  clear();
}

// --- what is shown ---------------------------------------------------------------------------------

function show(reply) {
  say(reply.pictures_error ? sentence(reply.pictures_error) : null);
  $("results").classList.remove("stale");
  pictures.put(reply.pictures);
  frame.hidden = !reply.pictures.length;
  $("results").replaceChildren(...results(reply, frame));
  $("spoken").textContent = reply.words.slice(0, 2).join(". ");
  $("going").hidden = false;
  document.title = `${reply.words[0]} – Restitution`;
}

function clear() {
  say(null);
  $("results").replaceChildren();
  $("going").hidden = true;
  document.title = "Experiment – Restitution";
}

function say(text) {
  $("notice").replaceChildren(...(text ? [html("p", {}, text)] : []));
  $("notice").hidden = !text;
}

// --- ways in and out -------------------------------------------------------------------------------

function put(given) {
  $("data").value = given.data ?? "";
  $("angle-error").value = given.angle_error ?? "";
  $("speed-error").value = given.speed_error ?? "";
  $("from-normal").checked = Boolean(given.from_normal);
  analyse();
}

async function open() {
  const [file] = $("file").files;
  $("file").value = "";
  if (!file) return;
  if (file.size > 4 * LARGEST) {
    say(`${file.name} has ${file.size} bytes, too many for the page: the command restitution ` +
      "experiment reads more.");
    return;
  }
  $("data").value = decoded(await file.arrayBuffer());
  analyse();
}

// UTF-8, or UTF-16 as a spreadsheet may write it.
function decoded(buffer) {
  const [first, second] = new Uint8Array(buffer);
  const wide = (first === 0xff && second === 0xfe) || (first === 0xfe && second === 0xff);
  const encoding = wide ? (first === 0xff ? "utf-16le" : "utf-16be") : "utf-8";
  return new TextDecoder(encoding).decode(buffer);
}

async function copy({ target }) {
  const link = new URL(fragment(fields()), location.href).href;
  await navigator.clipboard?.writeText(link).catch(() => {});
  target.textContent = "Link copied";
}

// The report as a file.
async function download({ target }) {
  target.textContent = "The report is being made …";
  try {
    const address = URL.createObjectURL(await fetched("report", body()));
    html("a", { href: address, download: "experiment.pdf" }).click();
    setTimeout(() => URL.revokeObjectURL(address), 60_000);
  } catch (error) {
    say(sentence(error.message));
  }
  target.textContent = "Report as PDF";
}

EXAMPLES.forEach(({ title }, i) => $("example").append(html("option", { value: i }, title)));
$("example").addEventListener("change", ({ target }) => {
  const chosen = EXAMPLES[target.value];
  target.value = "";
  if (chosen) put(chosen);
});
$("open").addEventListener("click", () => $("file").click());
$("file").addEventListener("change", open);
const { sheet } = JSON.parse($("served").textContent);
$("going").append(
  button("Copy link", copy), button("Print", () => print()),
  ...(sheet ? [button("Report as PDF", download)] : []),
);
$("going").hidden = true;
for (const id of ["data", "angle-error", "speed-error"]) $(id).addEventListener("input", soon);
$("data").addEventListener("paste", () => setTimeout(analyse));
$("from-normal").addEventListener("change", analyse);

function start() {
  const given = read();
  if (given) put(given);
}

addEventListener("hashchange", start);
start();
