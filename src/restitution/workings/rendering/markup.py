r"""A worked solution as Markdown with LaTeX, and as LaTeX.

Both use equations of amsmath and nothing else: ``aligned`` in Markdown, as every renderer knows
it, and in LaTeX ``align*``, whose tags put the marks at the right margin. Text is escaped; it
never comes through as markup.
"""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING
from unicodedata import decomposition

from restitution.explaining.lines.saying import note
from restitution.render.latex import SIGNS
from restitution.render.latex import to_latex as laid_latex
from restitution.render.layout import Layout, Sum
from restitution.render.markdown import escape as _markdown
from restitution.render.text import GREEK, width
from restitution.render.text import to_text as one_line
from restitution.workings.rendering.html import goes_on
from restitution.workings.rendering.steps import PartExplanation, Row, Step, Words, Working

if TYPE_CHECKING:
    from restitution.drawing.scene import Scene

_LATEX = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "&": r"\&",
    "%": r"\%",
    "#": r"\#",
    "_": r"\_",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
}
# Characters of a line as plain text that fit between the margins, marks beside them.
_LINE = 64

_BEGIN = "\n\\begin{align*}\n"
_END = "\n\\end{align*}"

_BY_SIGN = {
    "−": "-",
    "√": r"\surd",
    "÷": r"\div",
    "±": r"\pm",
    "°": r"^{\circ}",
    "∞": r"\infty",
    **SIGNS,
    **{sign: f"\\{name}" for name, sign in GREEK.items()},
}

_PREAMBLE = r"""\documentclass[11pt,fleqn]{article}
\usepackage[a4paper,margin=25mm]{geometry}
\usepackage{amsmath,amssymb}
\usepackage{iftex}
\ifPDFTeX\usepackage[utf8]{inputenc}\usepackage[T1]{fontenc}\fi
\setlength{\mathindent}{2em}
\allowdisplaybreaks
\AtBeginDocument{\abovedisplayskip=3pt \belowdisplayskip=3pt}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
\begin{document}
"""


# --- Markdown -----------------------------------------------------------------------------------


def to_markdown(explanation: Working) -> str:
    """The working as Markdown; mathematics between ``$`` and ``$$``."""
    blocks: list[str] = []
    if explanation.title:
        blocks.append(f"## {_markdown(explanation.title)}")
    for part in explanation.parts:
        if part.label:
            blocks.append(f"### ({_markdown(part.label)})")
        for step in part.steps:
            blocks += _markdown_step(step)
    blocks += [f"> {_markdown(note(warning))}" for warning in explanation.warnings]
    return "\n\n".join(blocks) + "\n"


def _markdown_step(step: Step) -> list[str]:
    if step.picture is not None:
        return [_image(step.picture)]
    text = _inline(step.words, _markdown)
    if step.kind == "heading":
        return [f"**{text}**" if not _has_math(step.words) else text]
    if step.principle:
        named = f"*{_markdown(step.principle)}*{step.sign}"
        text = f"{named} {text}" if text else named
    if step.mark:
        text = f"{text} **[{_markdown(step.mark)}]**"
    blocks = [text] if text.strip() else []
    if step.rows:
        blocks.append(f"$$\n{aligned(step.rows)}\n$$")
    return blocks


def _image(scene: Scene) -> str:
    """A picture in the text itself, so that the file needs no other beside it."""
    from restitution.drawing.svg import to_svg

    data = b64encode(to_svg(scene).encode()).decode()
    return f"![{_markdown(scene.title)}](data:image/svg+xml;base64,{data})"


def _has_math(words: Words) -> bool:
    return any(not isinstance(word, str) for word in words)


# --- LaTeX --------------------------------------------------------------------------------------


def to_latex(explanation: Working, document: bool = True) -> str:
    """The working as LaTeX: a whole document, or (``document`` False) what stands in one."""
    blocks: list[str] = []
    if explanation.title:
        blocks.append(rf"\textbf{{{_text(explanation.title)}}}")
    for part in explanation.parts:
        blocks += _latex_part(part)
    blocks += [rf"\emph{{{_text(note(warning))}}}" for warning in explanation.warnings]
    body = "\n\n".join(blocks) + "\n"
    return f"{_PREAMBLE}\n{body}\n\\end{{document}}\n" if document else body


def _latex_part(part: PartExplanation) -> list[str]:
    blocks = [rf"\textbf{{({_text(part.label)})}}"] if part.label else []
    for step in part.steps:
        if step.picture is not None:
            continue  # TeX takes no SVG
        text = _inline(step.words, _text)
        if step.kind == "heading":
            blocks.append(rf"\textbf{{{text}}}")
            continue
        if step.principle:
            named = rf"\emph{{{_text(step.principle)}}}{step.sign}"
            text = f"{named} {text}" if text else named
        if step.mark:
            text = rf"{text} \hspace*{{\fill}}\textbf{{{_text(step.mark)}}}"
        if text:
            blocks.append(text)
        if step.rows:
            _displayed(step.rows, blocks, fresh=bool(text))
    return blocks


def _displayed(rows: Sequence[Row], blocks: list[str], fresh: bool) -> None:
    """Adds lines to the equations that end the blocks, or sets new ones below the words."""
    for row in rows:
        wide = columns(row.operands[0]) > _LINE / 2
        aside = _aside(row)
        plain = replace(row, asides=(), reasons=(), number="") if aside else row
        body = " \\\\\n".join(_lines(plain, _tag(plain)))
        last = blocks[-1] if blocks else ""
        if last.endswith(_END) and not wide and not fresh:
            blocks[-1] = f"{last.removesuffix(_END)} \\\\\n{body}{_END}"
        elif last and fresh:
            blocks[-1] = f"{last}{_BEGIN}{body}{_END}"
        else:
            blocks.append(f"{_BEGIN.lstrip()}{body}{_END}")
        if aside:
            blocks[-1] += f"\n{aside}"
        fresh = False
        if wide:
            blocks.append("")
    blocks[:] = [block for block in blocks if block]


def _aside(row: Row) -> str:
    """A long note, as words below its line."""
    note = _note(row.note)
    return note if len(note) > _LINE / 2 else ""


def _tag(row: Row) -> str:
    return rf" \tag*{{\textbf{{{_text(row.mark)}}}}}" if row.mark else ""


def aligned(rows: Sequence[Row]) -> str:
    """Lines aligned at their signs, marks in a column of their own."""
    lines: list[str] = []
    for row in rows:
        lines += _lines(row, rf" &&\quad\text{{{_text(row.mark)}}}" if row.mark else "")
    body = " \\\\\n".join(lines)
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


def _lines(row: Row, mark: str) -> list[str]:
    """A chain in one line, or with each sign on its own if it is long; ``mark`` ends it."""
    gap = "" if goes_on(row.note) else r"\quad"
    note = rf"{gap}\text{{{_note(row.note)}}}" if row.note else ""
    label = rf"\text{{{_text(row.label)}}}\quad " if row.label else ""
    left = label + _operand(row.operands[0])
    if not row.signs:
        return [f"&{left}{note}{mark}"]
    parts = list(zip(row.signs, row.operands[1:], strict=True))
    room = sum(columns(operand) + 3 for operand in row.operands if operand is not None)
    pieces = [f"{SIGNS.get(sign, sign)} {_operand(operand)}" for sign, operand in parts]
    if row.answer:
        sign, operand = parts[-1]
        pieces[-1] = rf"{SIGNS.get(sign, sign)} \underline{{\underline{{{_operand(operand)}}}}}"
    lines = [" ".join(pieces)]
    if room > _LINE:
        lines = [
            part
            for (sign, operand), piece in zip(parts, pieces, strict=True)
            for part in _broken(sign, operand, piece, max(_LINE - columns(row.operands[0]), 40))
        ]
    if note and room > _LINE * 0.6:
        lines.append(rf"\quad\text{{{_note(row.note)}}}")
        note = ""
    lines[-1] += note + mark
    if columns(row.operands[0]) > _LINE / 2 and (len(lines) > 1 or room > _LINE):
        return [f"&{left}", *(rf"&\qquad {line}" for line in lines)]
    return [f"{left} &{lines[0]}", *(f"&{line}" for line in lines[1:])]


def _broken(sign: str, operand: Layout | None, piece: str, room: int) -> list[str]:
    """A long sum in lines of about the same length, broken before signs."""
    if not isinstance(operand, Sum) or len(operand.terms) < 2 or columns(operand) <= room:
        return [piece]
    most = columns(operand) / -(-columns(operand) // room)
    groups = [[operand.terms[0]]]
    for term in operand.terms[1:]:
        last = columns(Sum(tuple(groups[-1])))
        if last >= most or last + columns(Sum((term,))) > room:
            groups.append([term])
        else:
            groups[-1].append(term)
    first, *others = groups
    lines = [f"{SIGNS.get(sign, sign)} {_operand(Sum(tuple(first)))}"]
    for (sign_of_rest, middle), *rest in others:
        lines.append(rf"\qquad {{}}{sign_of_rest} {_operand(Sum((('+', middle), *rest)))}")
    return lines


def columns(layout: Layout | None) -> int:
    """About how long a formula is, by its plain text."""
    return 0 if layout is None else width(one_line(layout))


def _operand(layout: Layout | None) -> str:
    return "" if layout is None else laid_latex(layout)


def _note(words: Words) -> str:
    return "".join(
        _text(word) if isinstance(word, str) else f"${laid_latex(word)}$" for word in words
    )


def _inline(words: Words, escape: object) -> str:
    assert callable(escape)
    return "".join(
        escape(word) if isinstance(word, str) else f"${laid_latex(word)}$" for word in words
    )


def _text(text: str) -> str:
    return "".join(_LATEX.get(c) or _sign(c) for c in text).replace("\u00a0", "~")


def _sign(c: str) -> str:
    """A character of a formula among words, as mathematics; other characters as they are."""
    if c in _BY_SIGN:
        return f"${_BY_SIGN[c]}$"
    kind, _, parts = decomposition(c).partition(" ")
    if kind == "<fraction>":
        above, _, below = (chr(int(word, 16)) for word in parts.replace(" 2044 ", " 2f ").split())
        return rf"$\tfrac{{{above}}}{{{below}}}$"
    if kind in ("<super>", "<sub>") and len(parts) == 4:
        mark = "^" if kind == "<super>" else "_"
        return f"${mark}{{{chr(int(parts, 16))}}}$"
    return c
