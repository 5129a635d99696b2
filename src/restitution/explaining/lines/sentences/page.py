"""Lists, ordinals, the page around a working, and what marks are given for."""

from __future__ import annotations

from collections.abc import Mapping

SENTENCES: Mapping[str, str] = {
    "list.comma": ", ",
    "list.and": " and ",
    "list.or": " or ",
    "list.semicolon": "; ",
    "ordinal.1": "first",
    "ordinal.2": "second",
    "ordinal.3": "third",
    "ordinal.4": "fourth",
    "ordinal.5": "fifth",
    "ordinal.6": "sixth",
    "ordinal.7": "seventh",
    "ordinal.8": "eighth",
    "so": "So",
    "again": " again",
    "page.title": "Worked solution",
    "page.note": "Note: {warning}",
    "amiss.complaint": "the working does not follow: {complaint}",
    "amiss.pictures": "the pictures could not be drawn, by a fault of the program",
    "mark.method": "a principle or a method, with its values put in",
    "mark.accuracy": "the line or the answer is right",
    "mark.independent": "right by itself: it needs no method",
    "mark.dependent": "a method that rests on an earlier method of the same part",
    "mark.follow-through": "right for the values found before, even if a slip was made there",
    "mark.printed": "the printed result, reached without a gap",
}
