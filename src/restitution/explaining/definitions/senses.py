"""The sign of a ratio of components, where those that a working names are drawn in their sense."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from restitution.explaining.lines.derivation import FLIPPED, Relation
from restitution.explaining.lines.quotients import NotComparableError, Quotient
from restitution.explaining.steps.signs import Signs
from restitution.explaining.steps.step import Step
from restitution.expression.tree import Expression, has_quantity
from restitution.oracle import REAL, Formula, Oracle, Role
from restitution.oracle import Relation as Claim
from restitution.oracle.roles import ACUTE, POSITIVE


def oriented(step: Step, x: Quotient, loose: Collection[str] = ()) -> int | None:
    """The sign of a ratio of components; None where it is open.

    What letters of the statement may be need not be cited: an acute angle is named as such. What
    is given of them beyond that (``m > e M``) counts where it is cited. A component that a working
    names is drawn in its sense, unless a line gives it a value of which that is not certain; those
    of ``loose`` letters have either. That a body moves towards a wall counts where it is cited.
    """
    roles = drawn_roles(step)
    roles = {**roles, **{name: REAL for name in loose if name in step.setting.meanings}}
    oracle = Oracle(roles, (*ranges_cited(step), *_approaches_cited(step, roles)))
    sign = Signs(step.world, lambda: oracle).of(x)
    if sign:
        return sign
    # e, say, may be zero
    value = step.world.expression(x, oracle.roles)
    for number in (1, -1):
        if oracle.proves(Claim(number * value, ">=")):
            return number
    return None


def ranges_cited(step: Step, *, given: bool = False) -> Iterator[Formula]:
    """The inequalities between letters that a line cites; only those ``given``, if it is said."""
    for premise in step.cited:
        if given and isinstance(premise.ref, int):
            continue
        if isinstance(premise.relation, Relation):
            links = [link for links in premise.relation.options for link in links]
            sides = (side for link in links for side in (link.left, link.right))
            if all(link.sign in FLIPPED for link in links) and not any(map(has_quantity, sides)):
                yield step.formula(premise.relation)


def _approaches_cited(step: Step, roles: Mapping[str, Role]) -> Iterator[Formula]:
    """That bodies move towards walls, where a line cites it, in letters."""
    for premise in step.cited:
        if str(premise.ref).startswith("approach ") and isinstance(premise.relation, Relation):
            (link,) = premise.relation.only
            own = step.residual(step.setting.settled(link), step.rules())
            if isinstance(own, Quotient) and link.sign == ">":
                yield Claim(step.world.expression(own, roles), ">")


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
