"""Scalar products of velocities in words, which are zero at a right angle.

``dot product = 9 − 9 = 0``, or ``velocity before . velocity after = 0``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from restitution.expression.tree import (
    RIGHT_ANGLE,
    Expression,
    Name,
    Quantity,
    is_quantity,
    walk,
)
from restitution.practice.reading.journeys import Journeys
from restitution.practice.reading.usage import letters_of_question
from restitution.practice.reading.vocabulary import SCALAR_PRODUCT_WORD
from restitution.problem import Problem, Show, trees_of_step

_VELOCITY = (
    r"(?:(?:the\s+)?(?:initial|final|old|new|incoming|outgoing)\s+)?(?:velocity|vel|v)"
    r"(?:\s+(?:before|after|initially|finally|in|out))?"
)
_DOT = r"[.·•∙⋅]"
SCALAR_PRODUCT = re.compile(
    r"(?P<start>^|[,;]|\b(?:so|and|then|hence)\b)\s*(?:the\s+|their\s+)?"
    r"(?:(?:dot|scalar)\s+prod(?:uct)?\b(?:\s+(?:of|between)\s+(?:[^\W\d]|[\s'])+)?"
    rf"|(?:the\s+)?{_VELOCITY}\s*{_DOT}\s*(?:the\s+)?{_VELOCITY}|u\s*{_DOT}\s*v)\s*"
    r"(?:=|:|\bis\b)\s*(?=(?P<value>[^,;]*))",
    re.IGNORECASE,
)
_SIMPLE = re.compile(rf"\b([uv])\s*{_DOT}\s*v\b", re.IGNORECASE)
_PAIR = r"\([^()=,]*\d[^()=,]*,[^()=,]*\)|\([^()=,]*\d?[ij]\)"
OF_PAIRS = re.compile(
    rf"^(\s*(?:so\s+)?)(?=(?:{_PAIR})\s*{_DOT}?\s*(?:{_PAIR})\s*=([^,;]*=)?\s*0\s*\.?\s*$)"
)
_ZERO = re.compile(r"(?:^|=)\s*0\s*\.?\s*$")


def scalar_product(match: re.Match[str], problem: Problem) -> str:
    """The scalar product of the velocities, where it is zero; else what it comes to, alone.

    That of other vectors, or of multiples of these, is no other then.
    """
    simple = _SIMPLE.search(match[0])
    if simple and not (simple[1] == "u" and "u" in letters_of_question(problem)):
        return match[0]  # v.v is the square of v, and u a vector
    label = f"{SCALAR_PRODUCT_WORD} = " if _ZERO.search(match["value"]) else ""
    return f"{match['start']} {label}"


def of_pairs(match: re.Match[str], problem: Problem) -> str:
    """A scalar product of vectors in numbers, where a right angle is to be shown."""
    shown = [step for _, step in problem.steps() if isinstance(step, Show)]
    right = any(
        node == RIGHT_ANGLE for step in shown for tree in trees_of_step(step) for node in walk(tree)
    )
    at_right_angles = any(
        getattr(step.relation, "relation", "") == "perpendicular to" for step in shown
    )
    return f"{match[1]} {SCALAR_PRODUCT_WORD} = " if right or at_right_angles else match[0]


class RightAngles(Journeys):
    """The scalar products that are zero where velocities are at right angles."""

    def scalar_products(self, event: int) -> Iterator[Expression]:
        """Of the velocities between which an angle is asked, and of those that a turn is between.

        Of two spheres those after their impact come last.
        """
        for angle in self.asked("angle"):
            match angle:
                case Quantity("angle", (first, second)) if all(
                    is_quantity(side, "velocity") for side in (first, second)
                ):
                    yield Quantity("dot", (first, second))
        after = self.after(event)
        for body in self.bodies(event):
            stages = [event - 1, *({0} - {event - 1})]
            for stage in stages:
                ends = (Quantity("velocity", (Name(body),), n) for n in (stage, after))
                yield Quantity("dot", tuple(ends))
        met = self.bodies_met(event)
        if len(met) == 2:
            yield Quantity("dot", tuple(Quantity("velocity", (Name(b),), after) for b in met))
