"""Decimals with a comma: ``0,8u = v + 2w``, as they are written in many countries."""

from __future__ import annotations

import re
from collections.abc import Sequence

_POINT = re.compile(r"\d\.\d")
# A list of numbers, or a column, does not begin with a zero and a comma without a space.
_COMMA = re.compile(r"(?<![\d,.])0,\d")
# Nor does one stand before a sign at the beginning of a line, or within a sum or a product.
_FIRST = re.compile(r"^[^\w(]*(?:so\s+|hence,?\s+|then\s+)?\d+,\d+\s*[-=+×*]", re.MULTILINE)
_INSIDE = re.compile(r"(?<![\d,.])\d+,\d+\s*[-+*×/²^]")
_BETWEEN = re.compile(r"(?<=\d),(?=\d)")
_PAIR = re.compile(r"\(\s*[-−–]?\d+,\s*[-−–]?\d+\s*\)")


def with_decimal_points(texts: Sequence[str]) -> list[str]:
    """The lines of a script, in which all decimals have commas, with points in their places.

    Coordinates in brackets, ``(3,4)``, keep theirs.
    """
    whole = _PAIR.sub("", "\n".join(texts))
    if _POINT.search(whole) or not any(x.search(whole) for x in (_COMMA, _FIRST, _INSIDE)):
        return list(texts)
    return [_pointed(text) for text in texts]


def _pointed(text: str) -> str:
    """A line with a point for each comma between two figures, but in coordinates."""
    pairs = [range(*match.span()) for match in _PAIR.finditer(text)]
    return _BETWEEN.sub(
        lambda match: "," if any(match.start() in pair for pair in pairs) else ".", text
    )
