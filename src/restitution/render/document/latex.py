r"""A document as LaTeX: a whole one, or what stands in one."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from restitution.render.document import (
    Block,
    Chain,
    Document,
    Entries,
    Equations,
    Heading,
    Inset,
    Labelled,
    Listing,
    NewPage,
    Numbered,
    Paragraph,
    Picture,
    Room,
    Table,
    Together,
)
from restitution.render.document.aligned import LINE, columns, inline, lines
from restitution.render.latex import words as plain

_BEGIN = "\n\\begin{align*}\n"
_END = "\n\\end{align*}"
# The part of a line that columns with shares have.
_SHARED = 0.75
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


def to_latex(document: Document, whole: bool = True) -> str:
    """The document, or (``whole`` False) what stands in one; no pictures: TeX takes no SVG."""
    blocks = [rf"\textbf{{{plain(document.title)}}}"] if document.title else []
    _add(document.blocks, blocks)
    body = "\n\n".join(blocks) + "\n"
    return f"{_PREAMBLE}\n{body}\n\\end{{document}}\n" if whole else body


def _add(blocks: Iterable[Block], out: list[str]) -> None:
    """Adds blocks to those that stand already: equations may go on from these."""
    below_words = False
    for block in blocks:
        match block:
            case Heading(words):
                out.append(rf"\textbf{{{inline(words)}}}")
            case Paragraph(words, role, mark):
                text = inline(words)
                if role == "note":
                    text = rf"\emph{{{text}}}"
                out.append(rf"{text} \hspace*{{\fill}}\textbf{{{plain(mark)}}}" if mark else text)
            case Equations(chains):
                _displayed(chains, out, fresh=below_words)
            case Entries(entries, lead):
                out += [inline(lead)] if lead else []
                out += [f"{plain(label)} {inline(own)}".lstrip() for label, own in entries]
            case Labelled(label, inside, words):
                own: list[str] = []
                _add(inside, own)
                if own and label:
                    own[0] = rf"\textbf{{{plain(label)}}} {own[0]}"
                if own and words:
                    own[-1] += rf" \hspace*{{\fill}}{plain(words)}"
                out += own
            case Table():
                out.append(_table(block))
            case Listing(items, numbered):
                name = "enumerate" if numbered else "itemize"
                body = "\n".join(rf"\item {inline(item.words)}" for item in items)
                out.append(f"\\begin{{{name}}}\n{body}\n\\end{{{name}}}")
            case NewPage():
                out.append(r"\newpage")
            case Room(height):
                out.append(rf"\vspace{{{height:g}mm}}")
            case Together(inside):
                _add(inside, out)
            case Inset(document):
                out.append(to_latex(document, whole=False).rstrip("\n"))
            case Numbered(number, title, inside):
                head = rf"\textbf{{{number}}}"
                out.append(rf"{head}\quad\textbf{{{plain(title)}}}" if title else head)
                _add(inside, out)
            case Picture():
                pass
        below_words = isinstance(block, Paragraph)


def _table(table: Table) -> str:
    kinds = list(table.align)
    if table.shares:  # of the line, beside narrow columns
        whole = sum(filter(None, table.shares)) / _SHARED
        kinds = [
            side if share is None else rf"p{{{share / whole:.2f}\linewidth}}"
            for side, share in zip(table.align, table.shares, strict=True)
        ]
    body = " \\\\\n".join(" & ".join(map(inline, row)) for row in (table.heads, *table.rows))
    return f"\\begin{{tabular}}{{{''.join(kinds)}}}\n{body}\n\\end{{tabular}}"


def _displayed(chains: Iterable[Chain], out: list[str], fresh: bool) -> None:
    """Adds lines to the equations that end the blocks, or sets new ones below the words."""
    for chain in chains:
        wide = columns(chain.operands[0]) > LINE / 2
        note = inline(chain.note)
        aside = note if len(note) > LINE / 2 else ""  # a long note stands below its line
        own = replace(chain, note=()) if aside else chain
        tag = rf" \tag*{{\textbf{{{plain(own.mark)}}}}}" if own.mark else ""
        body = " \\\\\n".join(lines(own, tag))
        last = out[-1] if out else ""
        if last.endswith(_END) and not wide and not fresh:
            out[-1] = f"{last.removesuffix(_END)} \\\\\n{body}{_END}"
        elif last and fresh:
            out[-1] = f"{last}{_BEGIN}{body}{_END}"
        else:
            out.append(f"{_BEGIN.lstrip()}{body}{_END}")
        if aside:
            out[-1] += f"\n{aside}"
        fresh = False
        if wide:
            out.append("")
    out[:] = [block for block in out if block]
