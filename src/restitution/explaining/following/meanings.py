"""Whether there is what a letter is to stand for."""

from __future__ import annotations

from restitution.explaining.data.setting import Setting
from restitution.explaining.lines.derivation import (
    Meaning,
    Move,
)
from restitution.explaining.lines.quotients import NotComparableError, Plane
from restitution.explaining.steps.signs import Signs
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Number,
    Quantity,
    letters,
    walk,
)
from restitution.oracle import Oracle


def means_something(meaning: Meaning, setting: Setting) -> bool:
    """Whether there is what a letter is to stand for, whatever the letters in it are.

    It is not made of the letter itself, nothing in it is divided by what may be zero, and no root
    is taken of what may be negative. A sense is that of a component, along its axis.
    """
    if meaning.letter in letters(meaning.quantity):
        return False
    if meaning.sense is not None and not _is_sense(meaning):
        return False
    step = Step(setting, Move("let"), (), ())
    step.world.printed = False
    angles = {name: setting.role(name) for name, own in setting.meanings.items() if own.angle}
    signs = Signs(step.world, lambda: Oracle({**setting.roles, **angles}))
    try:
        value = step.world.value(meaning.quantity)
        if meaning.vector != isinstance(value, Plane):
            return False
        for node in walk(meaning.quantity):
            match node:
                case Binary("/", _, below) if signs.of(step.world.scalar(below)) is None:
                    return False
                case Binary("^", _, power) if not isinstance(power, Number):
                    return False
                case Apply("sqrt", inside) if signs.of(step.world.scalar(inside)) != 1:
                    return False
                case Apply("arcsin" | "arccos"):
                    return False
    except NotComparableError:
        return False
    return True


def _is_sense(meaning: Meaning) -> bool:
    match meaning.quantity:
        case Quantity("along" | "across", (_, axis)):
            return _is_direction(axis) and _is_direction(meaning.sense)
    return False


def _is_direction(tree: Expression | None) -> bool:
    return tree is not None and not isinstance(tree, Number | Degrees)
