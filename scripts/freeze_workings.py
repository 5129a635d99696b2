"""Keep every worked solution as it is printed, and show what a change does to them.

    uv run python scripts/freeze_workings.py freeze FOLDER     write all workings into FOLDER
    uv run python scripts/freeze_workings.py compare FOLDER    print what differs from them now

Both take every statement that ships as an example and every question of the tests, or only those
whose names hold one of the words that follow the folder, which is best outside the repository.
Each working is kept as text; as data, with its marks; and as Markdown, LaTeX, HTML and Typst.
``compare`` prints a unified diff and ends with 1 where anything differs.
"""

from __future__ import annotations

import argparse
import difflib
import json
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import restitution.examples
from restitution.language import parse
from restitution.render.document.columns import inline
from restitution.render.text import to_text as in_a_line
from restitution.solving import solve
from restitution.workings import Explanation, explain, to_html, to_latex, to_markdown, to_text
from restitution.workings.rendering.document import to_typst
from restitution.workings.rendering.principles import about
from restitution.workings.rendering.steps import Row, Step

QUESTIONS = Path(__file__).resolve().parent.parent / "tests" / "questions"
EXAMPLES = Path(restitution.examples.__file__).parent


def main(arguments: Sequence[str] | None = None) -> int:
    """Freeze or compare; how many there were goes to the standard error stream."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("mode", choices=("freeze", "compare"))
    parser.add_argument("folder", type=Path)
    parser.add_argument("words", nargs="*", help="only statements with one of these in their names")
    parser.add_argument("--forms", default="txt,json,md,tex,html,typ", help="which to compare")
    given = parser.parse_intermixed_args(arguments)
    given.folder.mkdir(parents=True, exist_ok=True)
    start, count, differing = time.monotonic(), 0, 0
    for path in statements(given.words):
        count += 1
        forms = working(path)
        if given.mode == "freeze":
            for suffix, text in forms.items():
                _kept(given.folder, path, suffix).write_text(text, encoding="utf-8")
        else:
            wanted = given.forms.split(",")
            differing += _differs(
                given.folder, path, {each: text for each, text in forms.items() if each in wanted}
            )
    print(f"{count} statements in {time.monotonic() - start:.0f} s", end="", file=sys.stderr)
    print("" if given.mode == "freeze" else f", {differing} differ", file=sys.stderr)
    return 1 if differing else 0


def statements(words: Sequence[str] = ()) -> Iterator[Path]:
    """All statements, or those with one of the words in their names."""
    for path in sorted([*EXAMPLES.glob("*.impact"), *QUESTIONS.glob("*.impact")]):
        if not words or any(word in path.stem for word in words):
            yield path


def working(path: Path) -> dict[str, str]:
    """The working of a statement in every form, by the suffix of its file."""
    made = explain(solve(parse(path.read_text(encoding="utf-8"))))
    return {
        "txt": f"{to_text(made)}\n",
        "json": json.dumps(_data(made), ensure_ascii=False, indent=1) + "\n",
        "md": f"{to_markdown(made)}\n",
        "tex": f"{to_latex(made)}\n",
        "html": to_html(made).replace("<", "\n<") + "\n",
        # Words that follow each other are one.
        "typ": to_typst(made).replace('";#"', ""),
    }


def _data(explanation: Explanation) -> dict[str, Any]:
    return {
        "parts": [
            {
                "label": part.label,
                "marks": part.marks,
                "item_marks": part.item_marks,
                "asked": part.asked,
                "answers": part.answers,
                "steps": [_step(each) for each in part.steps],
            }
            for part in explanation.parts
        ],
        "warnings": explanation.warnings,
    }


def _step(step: Step) -> dict[str, Any]:
    return {
        "kind": step.kind,
        "principle": None if step.principle is None else str(step.principle),
        "about": about(step),
        "words": inline(step.words),
        "mark": str(step.mark),
        "marks": step.marks,
        "item": step.item,
        "event": step.event,
        "rows": [_row(each) for each in step.rows],
    }


def _row(row: Row) -> dict[str, Any]:
    operands = [None if each is None else in_a_line(each) for each in row.operands]
    return {
        "operands": operands,
        "signs": row.signs,
        "mark": str(row.mark),
        "note": inline(row.note),
    }


def _kept(folder: Path, path: Path, suffix: str) -> Path:
    return folder / f"{path.parent.name}-{path.stem}.{suffix}"


def _differs(folder: Path, path: Path, forms: Mapping[str, str]) -> bool:
    differing = False
    for suffix, text in forms.items():
        kept = _kept(folder, path, suffix)
        before = kept.read_text(encoding="utf-8") if kept.exists() else ""
        if before != text:
            differing = True
            lines = (before.splitlines(), text.splitlines())
            sys.stdout.writelines(
                f"{line}\n" for line in difflib.unified_diff(*lines, str(kept), "now", lineterm="")
            )
    sys.stdout.flush()
    return differing


if __name__ == "__main__":
    sys.exit(main())
