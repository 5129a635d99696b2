"""Ratios of 90° less an angle as those of the angle: tan(90° − θ) is 1/tan θ."""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Derivation, Line, Link, Move
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    RIGHT_ANGLE,
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    walk,
)
from restitution.oracle import Oracle
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import ONE
from restitution.planning.writing.scene import Scene


def without_complements(scene: Scene, number: int) -> int:
    """The line in ratios of angles themselves; the same line, where it has no others."""
    link = scene.desk.last_link(number)
    put = {
        node: own
        for side in (link.left, link.right)
        for node in walk(side)
        if (own := _of_the_angle(node)) is not None
    }
    if link.sign != "=" or not put:
        return number
    left, right = (exchanged(side, put) for side in (link.left, link.right))
    written = scene.judge.write(
        (Move("identity", "complement"),), (number,), chain(left, (right, None))
    )
    return number if written is None else written


def has_complement(link: Link) -> bool:
    """Whether an equation has a ratio of 90° less an angle."""
    return any(
        _of_the_angle(node) is not None for side in (link.left, link.right) for node in walk(side)
    )


def with_complements(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which 90° − θ is a complement, and no difference like any other."""
    sums = [
        line
        for line in derivation.lines
        if line.move.id == "identity" and line.move.record == "sum-of-angles"
    ]
    if not sums:
        return derivation
    read, changed = reader_of(derivation, oracle), dict[int, Line]()
    for line in sums:
        own = replace(line, move=replace(line.move, record="complement"))
        if read.accepts(own):
            changed[line.number] = own
    lines = tuple(changed.get(line.number, line) for line in derivation.lines)
    return replace(derivation, lines=lines)


def _of_the_angle(node: Expression) -> Expression | None:
    match node:
        case Apply("sin" | "cos" | "tan" as ratio, Binary("-", right, angle)) if (
            right == RIGHT_ANGLE
        ):
            pass
        case _:
            return None
    match angle:
        case Letter() | Binary("*", Number(), Letter()):
            if ratio == "tan":
                return Binary("/", ONE, Apply("tan", angle))
            return Apply("cos" if ratio == "sin" else "sin", angle)
    return None
