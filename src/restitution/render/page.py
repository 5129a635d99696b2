"""A whole page of HTML around what stands in it: light or dark, and nothing from elsewhere."""

from __future__ import annotations

from html import escape


def page(title: str, style: str, body: str) -> str:
    """The text of an HTML file; ``title`` is plain text, the others are CSS and HTML."""
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        '<meta name="color-scheme" content="light dark">\n'
        f"<title>{escape(title)}</title>\n<style>{style}</style>\n</head>\n<body>\n"
        f"{body}\n</body>\n</html>\n"
    )
