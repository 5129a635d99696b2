"""Workings judged in numbers: letters for which a story happens as it is told, and lines at them.

The motion is that of `plain_physics`, which uses nothing of the package but its reader. Where
facts tie letters, Newton's method finds numbers that obey them.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from typing import Any

import mpmath as mp
from plain_physics import ImpossibleWorldError, World, cross, dot, plus, scaled, size

from restitution import problem as p
from restitution.explaining.lines.derivation import Derivation, Line, Link, Meaning, Relation
from restitution.explaining.lines.trees import rebuilt
from restitution.expression import tree as t
from restitution.solving.story.letters import roles

NOTHING = mp.mpf(10) ** -40
_ORDERS = {
    "<": lambda x: x < -NOTHING,
    "<=": lambda x: x <= NOTHING,
    ">": lambda x: x > NOTHING,
    ">=": lambda x: x >= -NOTHING,
    "!=": lambda x: abs(x) > NOTHING,
}


class BeyondError(Exception):
    """What is not worked out in numbers: places, times, decimals."""


def worlds(problem: p.Problem, part: str | None, seed: int, wanted: int = 2) -> Iterator[World]:
    """Stories that happen as they are told, with the facts of one part."""
    chance = random.Random(seed)
    given = [
        (each, now)
        for label, now, step in _steps(problem)
        if isinstance(step, p.Given) and label in (None, part)
        for each in step.relations
    ]
    lets = {step.letter for _, _, step in _steps(problem) if isinstance(step, p.Let)}
    names = sorted(roles(problem).keys() - lets)
    for _ in range(60):
        start = [_any_value(roles(problem)[name], chance) for name in names]
        world = _obedient(problem, names, start, given)
        if world is not None:
            yield world
            wanted -= 1
        if not wanted:
            return


def _steps(problem: p.Problem) -> Iterator[tuple[str | None, int, Any]]:
    now = 0
    for part, step in problem.steps():
        yield part.label, now, step
        if isinstance(step, p.Impact | p.Kick):
            now += 1


def _any_value(role: Any, chance: random.Random) -> Any:
    low = 0.3 if role.low is not None else -3
    high = {"angle": 1.2, "restitution": 0.9}.get(role.kind, 3)
    if role.low is None and role.high is None:
        high = 3
    return mp.mpf(chance.uniform(low, high))


def _obedient(problem: Any, names: list[str], start: list[Any], given: list[Any]) -> World | None:
    x = mp.matrix(start or [0])
    try:
        for _ in range(40):
            world = World(problem, dict(zip(names, x, strict=bool(names))))
            gaps = _gaps(world, given)
            if not gaps or max(map(abs, gaps)) < mp.mpf(10) ** -100:
                break
            slopes = mp.matrix(len(gaps), len(names))
            for n in range(len(names)):
                aside = x.copy()
                aside[n] += mp.mpf(10) ** -70
                other = _gaps(World(problem, dict(zip(names, aside, strict=True))), given)
                for m, (a, b) in enumerate(zip(gaps, other, strict=True)):
                    slopes[m, n] = (b - a) * mp.mpf(10) ** 70
            square = slopes * slopes.T + mp.eye(len(gaps)) * mp.mpf(10) ** -60
            x = x - slopes.T * mp.lu_solve(square, mp.matrix(gaps))
        else:
            return None
        held = all(_holds(world, relation, now) for relation, now in given)
        return world if held and _within(problem, world) else None
    except (ImpossibleWorldError, ZeroDivisionError, KeyError):
        return None
    except (NotImplementedError, TypeError) as error:
        raise BeyondError(str(error)) from error


def _within(problem: Any, world: World) -> bool:
    for name, role in roles(problem).items():
        value = world.letters[name]
        if role.low is not None and value <= mp.mpf(str(role.low.evalf(20))) - NOTHING:
            return False
        if role.high is not None and value >= mp.mpf(str(role.high.evalf(20))) + NOTHING:
            return False
    return True


def _gaps(world: World, given: list[Any]) -> list[Any]:
    """What is zero where equations and directions that are given hold."""
    found: list[Any] = []
    for relation, now in given:
        match relation:
            case p.Compare(operands, operators):
                for a, sign, b in zip(operands, operators, operands[1:], strict=False):
                    if sign == "=":
                        found += _parts(world.value(a, now), world.value(b, now))
            case p.Aligned(left, how, right):
                a, b = (world.direction(each, now) for each in (left, right))
                found.append(dot(a, b) if how == "perpendicular to" else cross(a, b))
            case p.AtRest(body):
                found += world.stages[now][body.name]
    return found


def _parts(a: Any, b: Any) -> list[Any]:
    return list(plus(a, b, -1)) if isinstance(a, tuple) else [a - b]


def _holds(world: World, relation: Any, now: int) -> bool:
    match relation:
        case p.Compare(operands, operators):
            return all(
                sign == "=" or _ORDERS[sign](world.value(a, now) - world.value(b, now))
                for a, sign, b in zip(operands, operators, operands[1:], strict=False)
            )
        case p.AtRest():
            return True
        case p.Aligned(left, how, right):
            a, b = (world.direction(each, now) for each in (left, right))
            sense = {"in the direction of": 1, "opposite to": -1}.get(how)
            return sense is None or dot(a, b) * sense > 0
    return world.holds(relation, now)


# --- lines ----------------------------------------------------------------------------------------


class Judge:
    """What lines of a working say, at one story."""

    def __init__(self, world: World, derivation: Derivation) -> None:
        self.world = world
        self.now = len(world.events)
        self.derivation = derivation
        self._turn_axes()
        for meaning in derivation.meanings.values():
            self._introduce(meaning)

    def _turn_axes(self) -> None:
        """Lines of centres count in the sense in which the facts name them."""
        for fact in self.derivation.facts:
            (link,) = fact.relation.only
            match link.left:
                case t.Quantity("line_of_centres", (), int(n)):
                    told = self.world.direction(link.right, self.now)
                    normal = self.world.normals[n]
                    assert normal is not None
                    self.world.normals[n] = scaled(normal, -1) if dot(told, normal) < 0 else normal

    def _introduce(self, meaning: Meaning) -> None:
        try:
            value = self.value(meaning.quantity)
            if meaning.sense is not None:
                axis = meaning.quantity.arguments[-1]  # type: ignore[attr-defined]
                a, b = (self.world.direction(each, self.now) for each in (axis, meaning.sense))
                value = value if dot(a, b) > 0 else -value
        except (BeyondError, ImpossibleWorldError, ZeroDivisionError):
            return
        self.world.letters[meaning.letter] = value

    def value(self, tree: t.Expression) -> Any:
        """The value of a tree. Raises BeyondError for what is not worked out here."""

        def change(each: t.Expression) -> t.Expression:
            if isinstance(each, t.Quantity) and each.kind == "restitution":
                event = self.world.events[each.stage - 1]  # type: ignore[operator]
                return t.Letter("e") if event.e is None else event.e
            if isinstance(each, t.Quantity) and each.kind == "total_energy_lost":
                raise BeyondError(each.kind)
            return each

        try:
            return self.world.value(rebuilt(tree, change), self.now)
        except (NotImplementedError, TypeError, KeyError, AttributeError, IndexError) as error:
            raise BeyondError(str(error)) from error

    def applies(self, line: Line) -> bool:
        """Whether the story is one of the cases in which a line stands."""
        by_line: dict[int, list[bool]] = {}
        for case in self.derivation.cases:
            if line.number in case.lines:
                own = self.derivation.line(case.line)
                assert own is not None and isinstance(own.relation, Relation)
                option = Relation((own.relation.options[case.option],))
                by_line.setdefault(case.line, []).append(self.true(option))
        return all(any(each) for each in by_line.values())

    def true(self, relation: Relation) -> bool:
        """Whether a relation holds. Raises BeyondError, or ImpossibleWorldError for no value."""
        return any(all(self._link(link) for link in links) for links in relation.options)

    def _link(self, link: Link) -> bool:
        if link.sign == "≈":
            raise BeyondError("a decimal")
        if link.sign in ("parallel to", "perpendicular to"):
            try:
                a, b = (self.world.direction(x, self.now) for x in (link.left, link.right))
            except (NotImplementedError, TypeError, KeyError, AttributeError) as error:
                raise BeyondError(str(error)) from error
            gap = cross(a, b) if link.sign == "parallel to" else dot(a, b)
            return bool(abs(gap) <= NOTHING * (1 + size(a) * size(b)))
        a, b = self.value(link.left), self.value(link.right)
        if isinstance(a, tuple) != isinstance(b, tuple):
            a, b = (scaled((1, 1), 0) if x == 0 else x for x in (a, b))
        if isinstance(a, tuple) != isinstance(b, tuple):
            return False
        gaps = _parts(a, b)
        if link.sign == "=":
            return all(abs(each) <= NOTHING * (1 + abs(each)) for each in gaps)
        return len(gaps) == 1 and bool(_ORDERS[link.sign](gaps[0]))
