"""A worked solution: nothing fails, every answer is reached, and it reads as it should."""

from __future__ import annotations

import io
import re
import unicodedata
from fractions import Fraction
from pathlib import Path

import pypdf
from statements import EXAMPLES, QUESTIONS, explained, law, solved

from restitution.export.sheet import Options, entry, to_document
from restitution.render.document.typst import to_pdf
from restitution.render.text import width
from restitution.wording import Listing, question
from restitution.workings import PartExplanation, to_html, to_latex, to_markdown, to_text
from restitution.workings.rendering.principles import about

SOME = [*EXAMPLES, *QUESTIONS[::6]]


@law(SOME)
def nothing_fails_and_no_line_is_left_out(path: Path) -> None:
    solution, explanation = solved(path), explained(path)
    assert not [w for w in explanation.warnings if "left out" in w]
    assert len(explanation.parts) == len(solution.parts)
    steps = [step for part in explanation.parts for step in part.steps]
    assert all(about(step) for step in steps if step.principle)
    text = to_text(explanation)
    assert "Limit(" not in text
    assert "sqrt" not in text
    assert "**" not in text
    assert not re.search(r"_[a-z]_", text)  # no hidden unknown shows its name
    assert to_html(explanation).count("<math") == to_html(explanation).count("</math>")
    assert to_latex(explanation).count("{aligned}") % 2 == 0
    assert to_markdown(explanation).count("$$") % 2 == 0


@law(EXAMPLES)
def every_answer_is_in_the_working(path: Path) -> None:
    solution, explanation = solved(path), explained(path)
    seen = "".join(to_text(explanation, width=2000).split())
    for part in solution.parts.values():
        for item in part.items:
            if item.error is not None:
                assert "".join(item.error.message.split()) in seen
            elif item.kind in ("value", "vector", "point", "extremum"):
                for answer in item.answers:
                    plain, *condition = answer.display.split(", for ")
                    last = plain.split(" when ")[0].split(" approached")[0].rpartition("=")[2]
                    for each in (last, *condition):
                        assert any(text in seen for text in spellings("".join(each.split()))), (
                            item.text,
                            answer.display,
                        )


def spellings(answer: str) -> list[str]:
    """How a working may write an answer: with data in decimals, a fraction is a decimal too."""
    in_decimals = re.sub(r"\(?\b(\d+)/(\d+)\b\)?|[¼½¾⅕⅖⅗⅘⅛⅜⅝⅞]", _decimal, answer)
    in_decimals = re.sub(r"(\.\d*[1-9])0+(?!\d)", r"\1", in_decimals)  # no zeros behind decimals
    # A place follows "P is at", any other value an equals sign; worked out by a velocity and a time
    # it is a vector.
    own = [answer, *(f"{start}{in_decimals}" for start in ("=", "=(", "isat"))]
    for point in (answer, in_decimals):
        place = re.fullmatch(r"\(([^,]+),([^,]+)\)", point)
        vector = "" if place is None else _as_a_vector(*place.groups())
        own += [f"={vector}", f"=({vector})"] if vector else []
    return own


def _as_a_vector(x: str, y: str) -> str:
    """A place by its coordinates, as a vector; one of zero is left out."""
    whole = ""
    for size, unit in ((x, "𝐢"), (y, "𝐣")):
        sign, size_ = ("−", size[1:]) if size.startswith("−") else ("+" if whole else "", size)
        if size_ != "0":
            bare = "" if size_ == "1" else f"({size_})" if "/" in size_ else size_
            whole += f"{sign}{bare}{unit}"
    return whole


def _decimal(fraction: re.Match[str]) -> str:
    text = fraction[0]
    if len(text) == 1:
        return str(unicodedata.numeric(text))
    value = Fraction(int(fraction[1]), int(fraction[2]))
    return str(float(value)) if 10**9 % value.denominator == 0 else text


@law([*EXAMPLES, *QUESTIONS])
def every_number_of_the_question_stands_before_its_answer(path: Path) -> None:
    content = question(solved(path).problem)
    numbers = {
        part.label: {
            f"({entry.number})"
            for block in part.body
            if isinstance(block, Listing)
            for entry in block.entries
            if entry.number
        }
        for part in content.parts
    }
    for part in explained(path).parts:
        labels = [
            label
            for step in part.steps
            for each in (step.label, *(row.label for row in step.rows))
            for label in each.split(", ")
            if label
        ]
        assert set(labels) == numbers.get(part.label, set())


@law(EXAMPLES[::3])
def text_fits_a_terminal(path: Path) -> None:
    lines = to_text(explained(path)).splitlines()
    wide = [line for line in lines if width(line) > 80]
    assert len(wide) <= max(1, len(lines) // 12), wide


def marks_of(part: PartExplanation) -> list[str]:
    """Every mark of a part, in the order in which they stand on the page."""
    return [
        mark
        for step in part.steps
        for each in (step.mark, *(row.mark for row in step.rows))
        for mark in each.split()
    ]


@law([*EXAMPLES, *QUESTIONS])
def directions_are_those_of_the_question(path: Path) -> None:
    in_words = str(question(solved(path).problem))
    if not re.search("[𝐢𝐣]", in_words):
        assert not re.search("[𝐢𝐣]", to_text(explained(path)))


@law(SOME)
def marks_agree_with_each_other(path: Path) -> None:
    solution = solved(path)
    for part, told_ in zip(solution.parts.values(), explained(path).parts, strict=True):
        marks = marks_of(told_)
        assert set(marks) <= {"M1", "DM1", "A1", "A1ft", "A1*", "B1", "B1ft"}
        for index, mark in enumerate(marks):
            before = set(marks[:index])
            if mark.startswith("A1"):
                assert before & {"M1", "DM1", "B1", "B1ft"}, marks
            if mark == "DM1":
                assert before & {"M1", "DM1"}, marks
        shown = [item for item in part.items if item.kind == "show"]
        assert shown or "A1*" not in marks
        # Of a chain, as in a ≤ b ≤ c, each link is shown by itself.
        links = sum(len(getattr(item.item.relation, "operators", "=")) for item in shown)
        assert marks.count("A1*") <= links
        answered = [item for item in part.items if item.error is None and item.holds is not False]
        # Steps that are not written out have no marks.
        unwritten = {e.part for e in told_.derivation.notes if e.kind == "unwritten"}
        assert not answered or len(marks) >= 1 or told_.label in unwritten
        assert told_.marks == len(marks) == sum(told_.item_marks)


def unescaped(source: str) -> str:
    return re.sub(r"\\[\\{}$&%#_]", " ", source)


COMMANDS = frozenset(
    re.findall(
        r"\w+",
        """
    documentclass usepackage begin end setlength mathindent parindent parskip allowdisplaybreaks
    AtBeginDocument abovedisplayskip belowdisplayskip ifPDFTeX fi
    textbf emph text mathbf underline hspace fill tag quad qquad left right
    frac tfrac sqrt surd times div pm cdot circ infty to leq geq neq approx lvert rvert
    sin cos tan sec csc cot arcsin arccos arctan
    alpha beta gamma delta epsilon varepsilon zeta eta theta iota kappa lambda mu nu xi pi rho
    sigma tau upsilon phi varphi chi psi omega textbackslash textasciicircum textasciitilde
    """,
    )
)


@law(SOME)
def latex_is_well_formed(path: Path) -> None:
    source = to_latex(explained(path))
    plain = unescaped(source)
    depth = 0
    for c in plain:
        depth += {"{": 1, "}": -1}.get(c, 0)
        assert depth >= 0
    assert depth == 0
    assert plain.count("$") % 2 == 0
    open_: list[str] = []
    for way, name in re.findall(r"\\(begin|end)\{([^}]*)\}", plain):
        if way == "begin":
            open_.append(name)
        else:
            assert open_.pop() == name
    assert not open_
    assert plain.count(r"\left") == plain.count(r"\right")
    assert set(re.findall(r"\\([A-Za-z]+)", plain)) <= COMMANDS
    title = solved(path).problem.title or ""
    assert all(c.isascii() for c in source.replace(title, "")), path
    # No display is empty or holds a blank line, and each line of it aligns at one place.
    for display in re.findall(r"\\begin\{align\*\}\n(.*?)\n\\end\{align\*\}", source, re.DOTALL):
        assert display.strip()
        assert "\n\n" not in display
        for line in display.split(" \\\\\n"):
            assert unescaped(line).count("&") == 1, line


@law(EXAMPLES)
def what_is_said_about_a_step_is_a_few_sentences_in_words(path: Path) -> None:
    for text in filter(None, (about(s) for part in explained(path).parts for s in part.steps)):
        assert 2 <= len(re.findall(r"[.;] |\.$", text)) <= 6, text
        assert 120 <= len(text) <= 480, text
        assert not re.search(r"[*$\\<>_{}`]", text), text
        assert text[0].isupper() and text.endswith("."), text


@law(EXAMPLES[::3])  # each by itself; the nightly run has all of them on one sheet
def it_can_be_set_on_a_sheet(path: Path) -> None:
    options = Options(solutions=True)
    pdf = to_pdf(to_document([entry(solved(path), options)], "All", options))
    read = pypdf.PdfReader(io.BytesIO(pdf))
    seen = " ".join(" ".join(page.extract_text() for page in read.pages).split())
    title = solved(path).problem.title or ""
    assert " ".join(plainly(title).split()) in plainly(seen)


def plainly(text: str) -> str:
    """Letters of mathematical alphabets as plain ones."""
    return unicodedata.normalize("NFKC", text)
