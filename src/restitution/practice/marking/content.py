"""What a marked working holds, as values and as plain data."""

from __future__ import annotations

from typing import TYPE_CHECKING

from restitution.expression.writing import write_expression
from restitution.practice.judgement import JudgedLine, Meaning
from restitution.practice.marking.answers import AnswerMark
from restitution.practice.marking.grounds import LAWS
from restitution.practice.marking.marks import Marks, PointMark
from restitution.practice.marking.messages import Message
from restitution.records import dataclass

if TYPE_CHECKING:
    from restitution.practice.marking.objects import (
        JudgedLineObject,
        MarkingObject,
        MessageObject,
        PointObject,
    )


@dataclass(frozen=True)
class Ask:
    """A letter of which the meaning has to be known, with meanings that would do."""

    letter: str
    text: str
    proposals: tuple[tuple[str, str], ...]


@dataclass(frozen=True, repr=False)
class MarkingContent:
    """What a marked working of one part holds.

    ``lines`` have their verdicts, ``letters`` are their meanings, ``answers`` the values given for
    what is asked, ``marks`` the points.
    """

    part: str | None
    lines: tuple[JudgedLine, ...]
    letters: tuple[Meaning, ...]
    answers: tuple[AnswerMark, ...]
    marks: Marks
    messages: tuple[Message, ...]
    asks: tuple[Ask, ...] = ()
    error: str | None = None

    @property
    def mistakes(self) -> tuple[str, ...]:
        """The names of the mistakes that begin in its lines, in their order."""
        names = (line.mistake.id for line in self.lines if line.mistake is not None)
        return tuple(name for name in names if name is not None)

    def json(self) -> MarkingObject:
        """The marking as plain data; every line has all its keys."""
        return {
            "part": self.part,
            "letters": [
                {
                    "letter": letter.letter,
                    "meaning": write_expression(letter.quantity),
                    "words": letter.words,
                    "by": letter.by,
                }
                for letter in self.letters
            ],
            "lines": [_line(line) for line in self.lines],
            "answers": [answer.json() for answer in self.answers],
            "marks": {
                "earned": self.marks.earned,
                "lost": self.marks.lost,
                "open": self.marks.open,
                "of": self.marks.of,
                "points": [_point(point) for point in self.marks.points],
            },
            "messages": [_message(message) for message in self.messages],
            "asks": [
                {
                    "letter": ask.letter,
                    "text": ask.text,
                    "proposals": [{"meaning": m, "words": w} for m, w in ask.proposals],
                }
                for ask in self.asks
            ],
            "error": self.error,
        }


def _line(line: JudgedLine) -> JudgedLineObject:
    use = next(iter(line.uses), None)
    if use is not None and use.principle in ("value", "component"):
        # A value before the law in the relation behind it: u = 3.4, v = 3/4 × 3.4.
        use = next((x for x in line.stated if x.principle in LAWS and not x.altered), use)
    mistake = line.mistake
    return {
        "n": line.line.number,
        "text": line.line.text,
        "read_as": line.read_as,
        "verdict": line.verdict,
        "accuracy": line.accuracy,
        "principle": None if use is None else use.principle,
        "event": None if use is None else use.event,
        "link": line.link,
        "from": list(line.sources),
        "mistake": None
        if mistake is None
        else {
            "id": mistake.id,
            "variants": list(mistake.variants),
            "also": list(mistake.also),
            "kind": mistake.kind,
            "at": mistake.at,
            "sure": mistake.sure,
            "leads_to": dict(mistake.leads_to or {}),
        },
    }


def _point(mark: PointMark) -> PointObject:
    return {
        "id": mark.point.id,
        "kind": mark.point.kind,
        "for": mark.point.purpose,
        "state": mark.state,
        "line": mark.line,
        "why": mark.why,
    }


def _message(message: Message) -> MessageObject:
    return {"line": message.line, "level": message.level, "text": message.text}
