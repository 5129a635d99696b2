"""How well the marker agrees with a person: scripts in ``tests/scripts``, marked by hand.

A script is a text file. Its head names the question, the part and what each letter means, one to
a line, and says whether all of it is right. Below it stand the lines as typed, each behind its
verdict by hand (several are allowed: ``true/follows``), its principle where it is momentum,
restitution or unchanged, and behind ``?`` the names that its mistake may have (``none`` where it
may have no name). Then come the marks that an examiner gives, and their total.
"""

from __future__ import annotations

import argparse
import re
import time
import traceback
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from statistics import median
from typing import Any

import restitution
from restitution.solving.equations.solution import Solution

ROOT = Path(__file__).parents[1]
SCRIPTS = ROOT / "tests" / "scripts"
PRINCIPLES = ("momentum", "restitution", "unchanged")
SLIPS = [
    "sign",
    "arithmetic",
    "algebra",
    "misread",
    "calculator",
    "root",
    "copied",
    "rounding-early",
    "slip",
    "none",
]  # a mistake with one of these names has the name of no misconception


@dataclass(frozen=True)
class MarkedLine:
    """A line as typed, with the verdicts that a person accepts, and what it uses."""

    text: str
    verdicts: tuple[str, ...]
    principle: str | None = None
    names: tuple[str, ...] = ()


@dataclass(frozen=True)
class MarkedScript:
    """A script with what a person says of it."""

    name: str
    statement: str
    part: str | None
    letters: Mapping[str, str]
    correct: bool
    lines: tuple[MarkedLine, ...]
    earned: int
    of: int

    @property
    def working(self) -> str:
        return "\n".join(line.text for line in self.lines)

    @property
    def mistakes(self) -> list[int]:
        """The numbers of the lines in which a mistake begins, counted from 1."""
        return [n for n, line in enumerate(self.lines, 1) if line.verdicts == ("false",)]


def read_script(path: Path) -> MarkedScript:
    head: dict[str, str] = {}
    letters: dict[str, str] = {}
    lines: list[MarkedLine] = []
    for text in path.read_text(encoding="utf-8").splitlines():
        tag, separator, typed = text.partition(" | ")
        if separator:
            lines.append(_line(tag.split(), typed))
        elif text.startswith("letter "):
            letter, _, meaning = text.removeprefix("letter ").partition(" = ")
            letters[letter.strip()] = meaning.strip()
        elif text and not text.startswith("mark "):
            word, _, rest = text.partition(" ")
            head[word] = rest
    earned, of = map(int, head["total"].split("/"))
    statement = (ROOT / head["question"]).read_text(encoding="utf-8")
    correct = head["correct"] == "yes"
    part = head.get("part")
    return MarkedScript(path.stem, statement, part, letters, correct, tuple(lines), earned, of)


def _line(tag: Sequence[str], typed: str) -> MarkedLine:
    names = [name for word in tag if word.startswith("?") for name in word[1:].split("/")]
    principle = next((word for word in tag if word in PRINCIPLES), None)
    return MarkedLine(typed, tuple(tag[0].split("/")), principle, tuple(names))


def scripts_of(folder: Path = SCRIPTS) -> list[MarkedScript]:
    return [read_script(path) for path in sorted(folder.glob("*.txt"))]


@cache
def solution_of(statement: str) -> Solution:
    return restitution.solve(restitution.parse(statement))


def reply(script: MarkedScript, declared: bool) -> tuple[dict[str, Any], float]:
    """What the marker says, as of JSON, and the seconds of the processor that it took, warm."""
    solution = solution_of(script.statement)
    start = time.process_time()
    letters = dict(script.letters) if declared else {}
    marking = restitution.mark(solution, script.working, part=script.part, letters=letters)
    found = marking.json()
    return found, time.process_time() - start


@dataclass
class Measures:
    """The table of what the marker got right, and the lines that it did not."""

    counts: Counter[str] = field(default_factory=Counter)
    of: Counter[str] = field(default_factory=Counter)
    seconds: dict[str, float] = field(default_factory=dict)
    offences: list[str] = field(default_factory=list)
    losses: Counter[str] = field(default_factory=Counter)

    def note(self, what: str, hit: bool, offence: str | None = None, bad: bool = False) -> None:
        """Count a case; an offence is listed where the outcome is the one not wanted."""
        self.of[what] += 1
        self.counts[what] += hit
        if offence and hit == bad:
            self.offences.append(f"{what}: {offence}")

    def share(self, what: str) -> float:
        return self.counts[what] / self.of[what] if self.of[what] else 0.0

    def table(self) -> str:
        rows = [
            f"{what:<44} {self.counts[what]:>5} of {self.of[what]:<5} {self.share(what):7.1%}"
            for what in self.of
        ]
        if self.seconds:
            middle = median(self.seconds.values())
            slowest = sorted(self.seconds.items(), key=lambda each: -each[1])[:3]
            most = ", ".join(f"{seconds:.2f} ({name})" for name, seconds in slowest)
            rows.append(f"seconds a script: median {middle:.2f}, most {most}")
        rows += [f"  {what:<76} {count:>3}" for what, count in sorted(self.losses.items())]
        return "\n".join(rows)


def measure(scripts: Iterable[MarkedScript], declared: bool) -> Measures:
    measures = Measures()
    for script in scripts:
        try:
            found, seconds = reply(script, declared)
        except Exception as error:  # noqa: BLE001 - a crash is an outcome too
            measures.note("crashed", True, f"{script.name}: {error!r}", bad=True)
            last = traceback.extract_tb(error.__traceback__)[-1]
            measures.losses[f"crashed: {type(error).__name__} in {last.name}"] += 1
            continue
        measures.note("crashed", False)
        measures.seconds[script.name] = seconds
        compare(script, found, measures)
        measures.losses.update(losses(script, found))
    return measures


def losses(script: MarkedScript, found: Mapping[str, Any]) -> Iterable[str]:
    """How the marker saw what it missed, in words that tell nothing of the script.

    They are counted: of each mistake not found, of each line not followed and of the marks.
    """
    lines = {line["n"]: line for line in found["lines"]}
    letters = _letters_seen(script, found)
    for number, line in enumerate(script.lines, 1):
        verdict = lines[number]["verdict"] if number in lines else "nothing"
        later = any(lines[n]["verdict"] == "false" for n in lines if n > number)
        if line.verdicts == ("false",) and verdict != "false":
            accused = "a later line accused" if later else "no later line accused"
            yield f"mistake not found: {verdict}, {accused}, {letters}"
        if "follows" in line.verdicts and verdict not in ("follows", "true", *line.verdicts):
            first = script.mistakes[0] if script.mistakes else number
            cause = lines[first]["verdict"] if first in lines and first < number else "none"
            yield f"line not followed: {verdict}, its mistake {cause}, {letters}"
    marks = found.get("marks")
    if marks and marks["of"]:
        difference = marks["earned"] - script.earned * marks["of"] / script.of
        if difference:
            still_open = ", some open" if marks["open"] else ""
            yield f"marks: {difference:+.1f}{still_open}, {letters}"


def _letters_seen(script: MarkedScript, found: Mapping[str, Any]) -> str:
    """How the meanings of the letters compare with those that are declared."""
    if found["asks"]:
        return "letters open"
    meant = {each["letter"]: each["meaning"] for each in found["letters"]}
    wanted = {
        each["letter"]: each["meaning"]
        for each in reply(script, declared=True)[0]["letters"]
        if each["by"] == "declared"
    }
    other = [letter for letter, meaning in wanted.items() if meant.get(letter) != meaning]
    return "letters otherwise" if other else "letters as declared"


def compare(script: MarkedScript, found: Mapping[str, Any], measures: Measures) -> None:
    lines = {line["n"]: line for line in found["lines"]}
    for number, line in enumerate(script.lines, 1):
        if number in lines:
            _compare_line(script, line, lines[number], measures)
        else:
            measures.note("lines without a verdict", True, f"{script.name}: {line.text}", bad=True)
    said_false = [n for n, line in sorted(lines.items()) if line["verdict"] == "false"]
    if script.correct:
        where = "; ".join(script.lines[n - 1].text for n in said_false)
        accused = f"{script.name}: {where}"
        measures.note("correct scripts accused", bool(said_false), accused, bad=True)
    if script.mistakes:
        _compare_mistake(script, lines, said_false, measures)
    marks = found.get("marks")
    if marks and marks["of"]:
        near = abs(marks["earned"] / marks["of"] - script.earned / script.of) <= 0.1 + 1e-9
        said = f"{marks['earned']}/{marks['of']} for {script.earned}/{script.of}"
        measures.note("share of marks within 0.1", near, f"{script.name}: {said}")


def _compare_line(
    script: MarkedScript, line: MarkedLine, found: Mapping[str, Any], measures: Measures
) -> None:
    verdict = found["verdict"]
    offence = f"{script.name}: {line.text} -> {verdict} for {'/'.join(line.verdicts)}"
    if "true" in line.verdicts and "follows" not in line.verdicts:
        measures.note("true lines called false", verdict == "false", offence, bad=True)
        measures.note("true lines called unsupported", verdict == "unsupported", offence, bad=True)
    if line.verdicts != ("unread",):
        measures.note("asks or unread", verdict in ("asks", "unread"), offence, bad=True)
    if line.verdicts == ("false",):
        measures.note("mistakes called false", verdict == "false", offence)
    if "follows" in line.verdicts:
        fits = verdict in ("follows", "true", *line.verdicts)
        measures.note("follows recognised", fits, offence)
    if line.verdicts == ("unsupported",):
        measures.note("unsupported recognised", verdict == "unsupported", offence)
    if line.verdicts == ("remark",):
        measures.note("remarks called false", verdict == "false", offence, bad=True)
    if line.principle and line.verdicts[0] == "true" and verdict in ("true", "follows"):
        says = f"{script.name}: {line.text} -> {found['principle']} for {line.principle}"
        measures.note("principle", found["principle"] == line.principle, says)


def _compare_mistake(
    script: MarkedScript,
    lines: Mapping[int, Mapping[str, Any]],
    said_false: Sequence[int],
    measures: Measures,
) -> None:
    first = script.mistakes[0]
    at = said_false[0] if said_false else None
    text = script.lines[first - 1].text
    offence = f"{script.name}: line {at} for {first} ({text})"
    measures.note("line of the first mistake", at == first, offence)
    names = script.lines[first - 1].names
    mistake = lines.get(first, {}).get("mistake") or {}
    name = mistake.get("id")
    said = f"{script.name}: {text} -> {name} for {'/'.join(names)}"
    if any(wanted not in SLIPS for wanted in names):
        measures.note("named right", name in names, said)
    if names:
        wrong = name not in SLIPS and name is not None and name not in names
        measures.note("named wrong", wrong, said, bad=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    sets = [SCRIPTS, *sorted(each for each in SCRIPTS.iterdir() if each.is_dir())]
    parser.add_argument("folder", nargs="*", type=Path, default=sets)
    parser.add_argument("--letters", choices=["declared", "inferred"], help="only these")
    parser.add_argument("--only", help="scripts whose names match this regular expression")
    parser.add_argument("--quiet", action="store_true", help="the table without the lines")
    options = parser.parse_args()
    for folder in options.folder:
        scripts = [s for s in scripts_of(folder) if re.search(options.only or "", s.name)]
        for letters in ("declared", "inferred"):
            if not scripts or options.letters not in (None, letters):
                continue
            measures = measure(scripts, declared=letters == "declared")
            print(f"\n{folder.name}: {len(scripts)} scripts, letters {letters}")
            print(measures.table())
            if not options.quiet:
                print("\n".join(sorted(measures.offences)))


if __name__ == "__main__":
    main()
