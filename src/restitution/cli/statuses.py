"""With which status a command ends, and what else all of them share."""

from __future__ import annotations

UNANSWERED = 1
UNREADABLE = 2
INTERRUPTED = 130

REPORT = "please report this, with the statement"

CLOSED: set[int] = set()
"""The standard streams (0, 1, 2) that were closed when the command began."""
