"""Text in Markdown."""

from __future__ import annotations


def escape(text: str) -> str:
    """Plain text with the characters that mean something to Markdown made harmless."""
    return "".join(f"\\{c}" if c in "\\`*_[]<>$#|~" else c for c in text)
