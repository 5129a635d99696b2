"""Words with formulas among them, as they stand in a paragraph of HTML."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from html import escape
from itertools import pairwise
from typing import Any


def paragraph(
    pieces: Iterable[Any],
    markup: Callable[[Any], str],
    is_whole: Callable[[Any], bool],
) -> str:
    """Words with formulas, and other pieces than strings, of which ``markup`` is the HTML.

    Where ``is_whole``, what follows a piece without a blank, such as a full stop, stays on its
    line (in ``<span class="whole">``).
    """
    out = held = ""
    for piece, after in pairwise((*pieces, "")):
        if isinstance(piece, str):
            out += escape(piece.removeprefix(held))
            held = ""
            continue
        held = after.split(" ", 1)[0] if isinstance(after, str) and is_whole(piece) else ""
        own = markup(piece)
        out += f'<span class="whole">{own}{escape(held)}</span>' if held else own
    return out
