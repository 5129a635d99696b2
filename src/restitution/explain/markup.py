r"""A worked solution as Markdown with LaTeX, and as LaTeX.

Both use ``aligned`` equations from amsmath and nothing else. Text is escaped; it never comes
through as markup.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from restitution.explain.steps import Explanation, PartExplanation, Row, Step, Words
from restitution.render.latex import to_latex as laid_latex
from restitution.render.layout import Layout

_SIGNS = {"=": "=", "<": "<", ">": ">", "≤": r"\leq", "≥": r"\geq", "≠": r"\neq", "≈": r"\approx"}
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
_MARKDOWN = "\\`*_{}[]()#+-.!|<>$~"

_PREAMBLE = r"""\documentclass[11pt]{article}
\usepackage[a4paper,margin=25mm]{geometry}
\usepackage{amsmath,amssymb}
\usepackage{iftex}
\ifPDFTeX\usepackage[utf8]{inputenc}\usepackage[T1]{fontenc}\fi
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
\begin{document}
"""


# --- Markdown -----------------------------------------------------------------------------------


def to_markdown(explanation: Explanation) -> str:
    """The working as Markdown; mathematics between ``$`` and ``$$``."""
    blocks: list[str] = []
    if explanation.title:
        blocks.append(f"## {_markdown(explanation.title)}")
    for part in explanation.parts:
        if part.label:
            blocks.append(f"### ({_markdown(part.label)})")
        for step in part.steps:
            blocks += _markdown_step(step)
    blocks += [f"> Note: {_markdown(each)}" for each in explanation.warnings]
    return "\n\n".join(blocks) + "\n"


def _markdown_step(step: Step) -> list[str]:
    said = _inline(step.words, _markdown)
    if step.kind == "heading":
        return [f"**{said}**" if not _has_math(step.words) else said]
    if step.principle:
        named = f"*{_markdown(step.principle)}*:"
        said = f"{named} {said}" if said else named
    if step.mark:
        said = f"{said} **[{_markdown(step.mark)}]**"
    blocks = [said] if said.strip() else []
    if step.rows:
        blocks.append(f"$$\n{aligned(step.rows)}\n$$")
    return blocks


def _has_math(words: Words) -> bool:
    return any(not isinstance(each, str) for each in words)


def _markdown(text: str) -> str:
    return "".join(f"\\{c}" if c in "\\`*_[]<>$#|~" else c for c in text)


# --- LaTeX --------------------------------------------------------------------------------------


def to_latex(explanation: Explanation, document: bool = True) -> str:
    """The working as LaTeX: a whole document, or (``document`` False) what stands in one."""
    blocks: list[str] = []
    if explanation.title:
        blocks.append(rf"\textbf{{{_text(explanation.title)}}}")
    for part in explanation.parts:
        blocks += _latex_part(part)
    blocks += [rf"\emph{{Note: {_text(each)}}}" for each in explanation.warnings]
    body = "\n\n".join(blocks) + "\n"
    return f"{_PREAMBLE}\n{body}\n\\end{{document}}\n" if document else body


def _latex_part(part: PartExplanation) -> list[str]:
    blocks = [rf"\textbf{{({_text(part.label)})}}"] if part.label else []
    for step in part.steps:
        said = _inline(step.words, _text)
        if step.kind == "heading":
            blocks.append(rf"\textbf{{{said}}}")
            continue
        if step.principle:
            named = rf"\emph{{{_text(step.principle)}}}:"
            said = f"{named} {said}" if said else named
        if step.mark:
            said = rf"{said} \hfill\textbf{{{_text(step.mark)}}}"
        if step.rows:
            said = f"{said}\n\\[\n{aligned(step.rows)}\n\\]"
        if said.strip():
            blocks.append(said.strip())
    return blocks


def aligned(rows: Sequence[Row]) -> str:
    """Lines aligned at their signs, marks at the right."""
    lines: list[str] = []
    for row in rows:
        lines += _aligned_row(row)
    body = " \\\\\n".join(lines)
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


def _aligned_row(row: Row) -> list[str]:
    mark = rf" &&\quad\text{{{_text(row.mark)}}}" if row.mark else ""
    note = rf"\quad\text{{({_note(row.note)})}}" if row.note else ""
    left = _operand(row.operands[0])
    if not row.signs:
        return [f"&{left}{note}{mark}"]
    parts = [
        f"{_SIGNS.get(sign, sign)} {_operand(operand)}"
        for sign, operand in zip(row.signs, row.operands[1:], strict=True)
    ]
    long = len(parts) > 1 and sum(len(each) for each in parts) > 90
    if not long:
        return [f"{left} &{' '.join(parts)}{note}{mark}"]
    lines = [f"{left} &{parts[0]}", *(f"&{each}" for each in parts[1:])]
    lines[-1] += note + mark
    return lines


def _operand(layout: Layout | None) -> str:
    return "" if layout is None else laid_latex(layout)


def _note(words: Words) -> str:
    return "".join(
        _text(each) if isinstance(each, str) else f"${laid_latex(each)}$" for each in words
    )


def _inline(words: Words, escape: object) -> str:
    assert callable(escape)
    return "".join(
        escape(each) if isinstance(each, str) else f"${laid_latex(each)}$" for each in words
    )


def _text(text: str) -> str:
    return "".join(_LATEX.get(c, c) for c in text)


def joined(blocks: Iterable[str]) -> str:
    """Blocks with a blank line between them."""
    return "\n\n".join(blocks)
