"""The parsers of lark: each from a table that was made when the package was built, or anew.

To make a parser of its grammar takes twenty times as long as to load it. So ``hatch_build.py``
stores the tables in the package. A table serves only whoever has the very grammar and the very
lark that it was made of: else the parser is made of the grammar, as if there were no table.
"""

from __future__ import annotations

import hashlib
import pickle
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import Any

import lark
from lark import Lark, Token
from lark.lexer import Lexer

FOLDER = Path(__file__).with_name("tables")


class Tokens(Lexer):
    """Hands lark the tokens that the scanner has made already."""

    def __init__(self, lexer_conf: Any) -> None:
        """Nothing to prepare: the terminals are declared, not defined."""

    def lex(self, data: Any) -> Iterator[Token]:  # type: ignore[override]
        """The tokens, one after another."""
        return iter(data)


def make_parser(grammar: str, start: str) -> Lark:
    """An LALR parser that takes its tokens ready-made: from its table, where that fits."""
    try:
        stored = (FOLDER / f"{start}.table").read_bytes()
    except OSError:
        stored = b""
    return loaded(stored, grammar, start) or built(grammar, start)


def built(grammar: str, start: str) -> Lark:
    """The parser, made of its grammar."""
    return Lark(grammar, parser="lalr", lexer=Tokens, start=start)


def saved(grammar: str, start: str) -> bytes:
    """The table of a parser, behind a digest of what it was made of."""
    table = BytesIO()
    built(grammar, start).save(table)
    return _digest(grammar, start) + table.getvalue()


def loaded(stored: bytes, grammar: str, start: str) -> Lark | None:
    """The parser of a table; None where that was made of anything else, or is none."""
    digest = _digest(grammar, start)
    if not stored.startswith(digest):
        return None
    # lark stores a table as a pickle, which may do anything when it is loaded. This one is ours:
    # made by the build, shipped in the package like its modules, and trusted no more than they.
    # Nothing that a user gives is ever loaded so; and the digest is no defence, only a label.
    return Lark.load(BytesIO(stored[len(digest) :]))


def _digest(grammar: str, start: str) -> bytes:
    """The grammar declares its terminals too, so it is whole; ``Tokens`` is stored by its name."""
    whole = (lark.__version__, pickle.HIGHEST_PROTOCOL, Tokens.__module__, start, grammar)
    return hashlib.sha256(repr(whole).encode()).digest()
