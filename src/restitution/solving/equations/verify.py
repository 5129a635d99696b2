"""Every solution is checked by numbers before it is returned.

The closed form of the law gave the velocities; here the textbook principles, which it does not
use, must hold for them, and each printed value must be what the motion itself gives.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from restitution import law
from restitution.errors import UnsupportedError
from restitution.expression.enclosed import UndefinedError
from restitution.expression.evaluate import Angle
from restitution.problem import Impact, Value
from restitution.solving.algebra.numbers import FIELD, at
from restitution.solving.equations.solution import Branch
from restitution.solving.story.forward import Story
from restitution.vector import Vector


def verify_principles(story: Story) -> None:
    """Checks a story told in numbers against the principles, event by event.

    Raises UnsupportedError where one does not hold: a defect here, never the user's mistake.
    """
    zero = Vector(FIELD.zero, FIELD.zero)
    one = FIELD.number(Fraction(1))
    for event in story.happenings:
        step = event.step
        if not isinstance(step, Impact) or event.centres is None:
            continue
        u1, v1 = event.before[step.first], event.after[step.first]
        u2, v2 = event.before.get(step.second, zero), event.after.get(step.second, zero)
        wall = step.second in story.walls
        w1 = one if wall else one / story.mass(step.first)
        w2 = FIELD.zero if wall else one / story.mass(step.second)
        c = event.centres
        if event.altered:
            if not story.altered_laws[event.number].hold(event.after):
                raise _failed(event.number)
            continue
        residuals = (
            law.momentum_along_line_of_centres(u1, u2, v1, v2, w1, w2, c),
            law.newtons_experimental_law(u1, u2, v1, v2, c, event.e),
            law.change_across_line_of_centres(u1, v1, c),
            law.change_across_line_of_centres(u2, v2, c),
        )
        if any(residual.sign for residual in residuals):
            raise _failed(event.number)


def _failed(number: int) -> UnsupportedError:
    return UnsupportedError(
        f"the solution of event {number} failed its check against the principles; "
        "please report this question"
    )


def verify_value(value: Any, item: Value, branch: Branch, now: int) -> None:
    """Checks an exact answer against the motion told in numbers.

    Raises UnsupportedError where they differ: a defect here, never the user's mistake.
    """
    try:
        expected = branch.numbers.evaluator(now).value(item.expression)
        if isinstance(expected, Angle):
            expected = expected.measure()
        pairs = zip(
            expected if isinstance(expected, Vector) else (expected,),
            value if isinstance(value, tuple) else (value,),
            strict=True,
        )
        wrong = [
            (number, value) for number, value in pairs if (number - at(value, branch.sample)).sign
        ]
    except (UndefinedError, KeyError):
        return  # nothing to compare at this point
    if wrong:
        raise UnsupportedError(
            f"the value of {item.text} failed its check by numbers; please report this question"
        )
