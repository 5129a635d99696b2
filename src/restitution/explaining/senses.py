"""The sign of a ratio of components, where those that a working names are drawn in their sense."""

from __future__ import annotations

from collections.abc import Mapping

from restitution.explaining.algebra import NotComparableError, Quotient
from restitution.explaining.signs import Signs
from restitution.explaining.step import Step
from restitution.expression.tree import Expression
from restitution.oracle import REAL, Oracle, Role
from restitution.oracle import Relation as Claim
from restitution.oracle.roles import ACUTE, POSITIVE


def oriented(step: Step, x: Quotient) -> int | None:
    """The sign of a ratio of components; None where it is open.

    What letters of the statement may be need not be cited: an acute angle is named as such. A
    component that a working names is drawn in its sense, unless a line gives it a value of which
    that is not certain.
    """
    oracle = Oracle(drawn_roles(step))
    sign = Signs(step.world, lambda: oracle).of(x)
    if sign:
        return sign
    # e, say, may be zero
    value = step.world.expression(x, oracle.roles)
    for number in (1, -1):
        if oracle.proves(Claim(number * value, ">=")):
            return number
    return None


def drawn_roles(step: Step) -> Mapping[str, Role]:
    """What letters may be, where components that a working names are drawn in their sense."""
    roles = {**step.setting.roles, **dict.fromkeys(step.setting.meanings, POSITIVE)}
    angles = step.setting.angles & step.setting.meanings.keys()
    roles |= {name: step.setting.roles.get(name, ACUTE) for name in angles}
    for name, value in step.setting.values.items():
        if name not in angles and not never_below(step, value, roles):
            roles[name] = REAL
    return roles


def never_below(step: Step, value: Expression, roles: Mapping[str, Role]) -> bool:
    """Whether a value is certain not to be negative, whatever the letters in it are."""
    try:
        least = step.world.expression(step.world.scalar(value), roles)
    except NotComparableError:
        return False
    return Oracle(roles).proves(Claim(least, ">="))
