"""How documents look as pages: light or dark, on a screen, a telephone or on A4."""

from __future__ import annotations

WORKING = """
.restitution { --ink: #1b1b1f; --paper: #fff; --soft: #5f6368; --line: #d9dbe0; --mark: #8a1c1c;
  color: var(--ink); background: var(--paper); max-width: 46rem; margin: 0 auto; padding: 1rem;
  font: 1.05rem/1.55 Georgia, "Times New Roman", serif; }
@media (prefers-color-scheme: dark) { .restitution { --ink: #e8e8ec; --paper: #17181c;
  --soft: #a3a7ae; --line: #3a3d44; --mark: #ff9d8f; } }
.restitution h1 { font-size: 1.35rem; line-height: 1.25; margin: 0 0 1rem; }
.restitution h2 { font-size: 1.1rem; margin: 1.6rem 0 .6rem; padding-top: .6rem;
  border-top: 1px solid var(--line); }
.restitution h3 { font-size: 1.02rem; margin: 1.2rem 0 .3rem; }
.restitution p { margin: .5rem 0 .2rem; }
.restitution table { border-collapse: collapse; margin: .1rem 0 .3rem 2rem;
  width: calc(100% - 2rem); }
.restitution td math { math-style: normal; }
.restitution td { padding: .16rem .15rem; vertical-align: baseline; }
.restitution td:first-child { position: relative; }
.restitution td .item { position: absolute; left: -2rem; }
.restitution td.l { text-align: right; white-space: nowrap; width: 1%; }
.restitution td.l wbr { display: none; }
.restitution td.l.w { white-space: normal; width: 50%; }
.restitution td.l.w wbr { display: inline; }
.restitution td.s { width: 1%; white-space: nowrap; }
.restitution td.m, .restitution .mark { color: var(--mark); font: 600 .8rem/1 system-ui, sans-serif;
  text-align: right; white-space: nowrap; }
.restitution td.m { width: 6rem; padding: 0 0 0 .6rem; }
.restitution .mark { float: right; padding: .4rem 0 0 .6rem; }
.restitution figure { margin: .8rem 0; text-align: center; break-inside: avoid; }
.restitution figure svg { width: 30rem; max-width: 100%; height: auto; }
.restitution .whole { white-space: nowrap; }
.restitution .answer { border-bottom: 3px double var(--soft); display: inline-block; }
.restitution .note { color: var(--soft); font-size: .9em; }
.restitution math { font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", math;
  font-size: 1.05em; }
@media (max-width: 34rem) {
  .restitution { padding: .7rem; }
  .restitution table, .restitution tbody { display: block; width: auto; margin-left: .6rem;
    overflow-x: auto; }
  .restitution tr { display: flow-root; line-height: 1.9; }
  .restitution td { display: inline; padding: 0 .1rem; }
  .restitution td.l, .restitution td.l.w { white-space: normal; }
  .restitution td.l wbr { display: inline; }
  .restitution td .item { position: static; padding-right: .5rem; }
  .restitution td.l:empty { padding-left: 1rem; }
  .restitution td.m { float: right; padding: .4rem 0 0 .6rem; }
  .restitution td.m:empty { display: none; }
}
@media print { .restitution { --ink: #000; --paper: #fff; --soft: #333; --line: #999;
  --mark: #000; max-width: none; padding: 0; font-size: 11pt; }
  .restitution table, .restitution p { break-inside: avoid; }
  .restitution td { vertical-align: middle; }
  .restitution p { break-after: avoid; } }
"""

QUESTION = """
.question { color: #1b1b1f; background: #fff; max-width: 42rem; margin: 0 auto; padding: 1rem;
  font: 1.05rem/1.6 Georgia, "Times New Roman", serif; }
.question h1 { font-size: 1.35rem; line-height: 1.25; margin: 0 0 1rem; }
.question p { margin: .5rem 0; }
.question .row { display: grid; grid-template-columns: minmax(2.4rem, max-content) minmax(0, 1fr);
  align-items: baseline; }
.question .row > span { padding-right: .5rem; }
.question .asked { display: grid;
  grid-template-columns: minmax(2.4rem, max-content) minmax(0, 1fr); }
.question .asked > * { grid-column: 1 / -1; }
.question .asked > .row { grid-template-columns: subgrid; }
.question .asked .row > div > p { margin: .1rem 0; }
.question .marks { text-align: right; }
.question .whole { white-space: nowrap; }
.question math { font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", math;
  font-size: 1.05em; }
@media (prefers-color-scheme: dark) { .question { color: #e8e8ec; background: #17181c; } }
@media print { .question { color: #000; background: #fff; max-width: none; padding: 0;
  font-size: 11pt; } .question p, .question .row, .question .figure { break-inside: avoid; }
  .question h1, .question h1 + p, .question p:has(+ .figure), .question .figure {
  break-after: avoid; } }
"""

REPORT = """
:root { --ink: #1b1b1f; --paper: #fff; --soft: #5f6368; --line: #b9bcc4 }
@media (prefers-color-scheme: dark) { :root { --ink: #e8e8ec; --paper: #17181c; --soft: #a3a7ae;
  --line: #4a4d55 } }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 1.02rem/1.5 Georgia, "Times New Roman", serif }
main { max-width: 46rem; margin: 0 auto; padding: 1rem; overflow-wrap: break-word }
h1 { font-size: 1.35rem; line-height: 1.25; margin: .5rem 0 1rem }
h2 { font-size: 1.1rem; margin: 1.5rem 0 .5rem; break-after: avoid }
p { margin: .5rem 0 } .result { font-size: 1.3rem } .remark { color: var(--soft); font-size: .9em }
.head { text-align: right; color: var(--soft); margin: 0 }
.wide { overflow-x: auto }
table { border-collapse: collapse; margin: .6rem 0; font-variant-numeric: tabular-nums }
table.full { width: 100% } thead { display: table-header-group } tr { break-inside: avoid }
th, td { padding: .18rem .5rem; vertical-align: top; font-size: .95em }
th { border-bottom: 1.5px solid var(--ink); font-weight: 600; vertical-align: bottom }
td { border-bottom: 1px solid var(--line) }
.ruled.full { table-layout: fixed } .ruled th, .ruled td { border: 1px solid var(--soft) }
.l { text-align: left } .c { text-align: center } .r { text-align: right }
figure { margin: 1rem 0; text-align: center; break-inside: avoid }
figure svg { max-width: 100%; height: auto }
ol, ul { padding-left: 1.6rem } li { margin: .4rem 0 }
.break { break-before: page }
.whole { white-space: nowrap }
math { font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", math }
@media print { @page { size: A4; margin: 20mm } main { padding: 0; max-width: none }
  :root { --ink: #000; --paper: #fff; --soft: #333; --line: #999 } body { font-size: 11pt }
  li, p { break-inside: avoid } }
"""

SHEET = """
body { margin: 0; background: #fff } main { max-width: 46rem; margin: 0 auto; padding: 1rem }
main > h1 { font: 600 1.3rem/1.3 Georgia, serif; margin: .5rem 0 1rem }
main > h2 { font: 600 1.15rem/1.3 Georgia, serif } main > .break { break-before: page }
.head { text-align: right; margin: 0 }
.entry { display: grid; grid-template-columns: 2rem 1fr; margin: 1.4rem 0 }
.entry > .number { font: 600 1.05rem/1.6 Georgia, serif }
.entry h3 { font: 600 1.05rem/1.6 Georgia, serif; margin: 0 }
.entry .question, .entry .restitution { padding: 0; margin: 0; max-width: none }
.question figure { text-align: center; margin: 1rem 0; break-inside: avoid }
.question figure svg { max-width: 100%; height: auto }
table.shared { border-collapse: collapse; width: 100%; font: 400 .92rem/1.4 Georgia, serif }
table.shared th, table.shared td { border: 1px solid #888; padding: .3rem .45rem; text-align: left;
  vertical-align: top } table.shared tr { break-inside: avoid }
table.shared b { white-space: nowrap; font-weight: 600 }
table.shared .remark { font-size: .86rem }
@media (prefers-color-scheme: dark) { body { background: #17181c; color: #e8e8ec } }
@media print { @page { size: A4; margin: 20mm } main { padding: 0; max-width: none }
  body { background: #fff; color: #000 } }
"""

# What is around a question or a worked solution that is a page of its own.
_BARE = "body { margin: 0 }"
_AROUND = (
    "html { background: #fff } @media (prefers-color-scheme: dark) "
    "{ html { background: #17181c } } body { margin: 0 }"
)

STYLES = {
    "working": WORKING,
    "question": QUESTION,
    "report": REPORT,
    "sheet": f"{QUESTION}{WORKING}{SHEET}",
}
"""The style of what stands in a page, by the kind of a document."""

AROUND = {"working": _AROUND, "question": _BARE, "report": ""}
"""The style of a page around it."""
