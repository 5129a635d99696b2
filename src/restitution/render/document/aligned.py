r"""Lines of mathematics in LaTeX, aligned at their signs, in Markdown and in LaTeX alike.

They use amsmath and nothing else: ``aligned`` in Markdown, as every renderer knows it, and
``align*`` in LaTeX, whose tags put the marks at the right margin.
"""

from __future__ import annotations

from collections.abc import Sequence

from restitution.render.document import (
    Cell,
    Chain,
    Emphasis,
    LineBreak,
    Strong,
    Typed,
    pieces,
)
from restitution.render.latex import relation_sign, to_latex
from restitution.render.latex import words as plain
from restitution.render.layout import Layout, Sum
from restitution.render.text import to_text as one_line
from restitution.render.text import width

# Characters of a line as plain text that fit between the margins, marks beside them.
LINE = 64


def aligned(chains: Sequence[Chain]) -> str:
    """Lines aligned at their signs, marks in a column of their own."""
    rows: list[str] = []
    for chain in chains:
        rows += lines(chain, rf" &&\quad\text{{{plain(chain.mark)}}}" if chain.mark else "")
    body = " \\\\\n".join(rows)
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


def lines(chain: Chain, mark: str) -> list[str]:
    """A chain in one line, or with each sign on its own if it is long; ``mark`` ends it."""
    words = inline(chain.note)
    gap = "" if chain.goes_on else r"\quad"
    note = rf"{gap}\text{{{words}}}" if words else ""
    label = rf"\text{{{plain(chain.label)}}}\quad " if chain.label else ""
    left = label + _operand(chain.operands[0])
    if not chain.signs:
        return [f"&{left}{note}{mark}"]
    parts = list(zip(chain.signs, chain.operands[1:], strict=True))
    room = sum(columns(operand) + 3 for operand in chain.operands if operand is not None)
    terms = [f"{relation_sign(sign)} {_operand(operand)}" for sign, operand in parts]
    if chain.answer:
        sign, operand = parts[-1]
        terms[-1] = rf"{relation_sign(sign)} \underline{{\underline{{{_operand(operand)}}}}}"
    rows = [" ".join(terms)]
    if room > LINE:
        rows = [
            part
            for (sign, operand), term in zip(parts, terms, strict=True)
            for part in _broken(sign, operand, term, max(LINE - columns(chain.operands[0]), 40))
        ]
    if note and room > LINE * 0.6:
        rows.append(rf"\quad\text{{{words}}}")
        note = ""
    rows[-1] += note + mark
    if columns(chain.operands[0]) > LINE / 2 and (len(rows) > 1 or room > LINE):
        return [f"&{left}", *(rf"&\qquad {row}" for row in rows)]
    return [f"{left} &{rows[0]}", *(f"&{row}" for row in rows[1:])]


def _broken(sign: str, operand: Layout | None, term: str, room: int) -> list[str]:
    """A long sum in lines of about the same length, broken before signs."""
    if not isinstance(operand, Sum) or len(operand.terms) < 2 or columns(operand) <= room:
        return [term]
    most = columns(operand) / -(-columns(operand) // room)
    groups = [[operand.terms[0]]]
    for own in operand.terms[1:]:
        last = columns(Sum(tuple(groups[-1])))
        if last >= most or last + columns(Sum((own,))) > room:
            groups.append([own])
        else:
            groups[-1].append(own)
    first, *others = groups
    rows = [f"{relation_sign(sign)} {_operand(Sum(tuple(first)))}"]
    for (sign_of_rest, middle), *rest in others:
        rows.append(rf"\qquad {{}}{sign_of_rest} {_operand(Sum((('+', middle), *rest)))}")
    return rows


def columns(layout: Layout | None) -> int:
    """About how long a formula is, by its plain text."""
    return 0 if layout is None else width(one_line(layout))


def _operand(layout: Layout | None) -> str:
    return "" if layout is None else to_latex(layout)


def inline(words: Cell) -> str:
    """Words with their mathematics, as LaTeX."""
    out: list[str] = []
    for piece in pieces(words):
        if isinstance(piece, str):
            out.append(plain(piece))
        elif isinstance(piece, Emphasis):
            out.append(rf"\emph{{{plain(piece.text)}}}")
        elif isinstance(piece, Typed):
            out.append(rf"\texttt{{{plain(piece.text)}}}")
        elif isinstance(piece, Strong):
            out.append(rf"\textbf{{{plain(piece.text)}}}")
        elif isinstance(piece, LineBreak):
            out.append(r"\newline ")
        else:
            out.append(f"${to_latex(piece)}$")
    return "".join(out)
