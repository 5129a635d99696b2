"""A whole page of HTML around what stands in it: light or dark, and nothing from elsewhere."""

from __future__ import annotations

import re
from collections import Counter
from html import escape

_PICTURE = re.compile(r'<svg [^>]*?\bid="(\w+)".*?</svg>', re.DOTALL)


def page(title: str, style: str, body: str) -> str:
    """The text of an HTML file; ``title`` is plain text, the others are CSS and HTML.

    A picture (inline SVG whose ids all begin with its own) may stand in it several times.
    """
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        '<meta name="color-scheme" content="light dark">\n'
        f"<title>{escape(title)}</title>\n<style>{style}</style>\n</head>\n<body>\n"
        f"{_distinct(body)}\n</body>\n</html>\n"
    )


def _distinct(body: str) -> str:
    """The page with other ids for a picture that has stood in it before."""
    seen: Counter[str] = Counter()

    def once(match: re.Match[str]) -> str:
        picture, name = match[0], match[1]
        seen[name] += 1
        return picture if seen[name] == 1 else picture.replace(name, f"{name}n{seen[name]}")

    return _PICTURE.sub(once, body)
