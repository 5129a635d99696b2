"""Lines read one by one: whether one follows from what it cites, and what of that it needs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import fields
from fractions import Fraction
from functools import lru_cache
from typing import Any

import sympy as sp

from restitution.errors import StatementError
from restitution.explaining.data.setting import Cited, Known, Setting
from restitution.explaining.lines.derivation import (
    Derivation,
    Event,
    Fact,
    Link,
    Meaning,
    Move,
    Ref,
    Relation,
    whole_of,
)
from restitution.explaining.lines.notation import read_relation, read_tree
from restitution.explaining.lines.quotients import NotComparableError
from restitution.explaining.lines.trees import trees_of
from restitution.explaining.moves import follows, is_certain
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    RIGHT_ANGLE,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Polar,
    Quantity,
    Unit,
    is_quantity,
    letters,
    walk,
)
from restitution.oracle import All, Oracle, broken_off, compared
from restitution.records import dataclass
from restitution.work import remembered


@dataclass(frozen=True)
class Trial:
    """What a working says so far, and what may be cited of it.

    ``cited`` gives what a line or a fact says, and None for what is neither; ``known`` what is
    known of letters.
    """

    setting: Setting
    cited: Callable[[Ref], Relation | Meaning | None]
    known: Callable[[str], Known | None]

    def step(self, move: Move, premises: Iterable[Ref]) -> Step:
        """A move with its premises; what says nothing is left out."""
        cited: list[Cited] = []
        known: list[Known] = []
        for ref in premises:
            statement = self.cited(ref)
            if statement is not None:
                cited.append(Cited(ref, statement))
            elif isinstance(ref, str) and (own := self.known(ref)) is not None:
                known.append(own)
        return Step(self.setting, move, tuple(cited), tuple(known))

    def follows(self, move: Move, premises: Iterable[Ref], relation: Relation) -> bool:
        """Whether a move makes a relation of some premises.

        Raises NotComparableError where that is beyond what is compared.
        """
        return _as_before(_read, self.step(move, premises), relation)

    def proves(self, premises: Iterable[Ref], relation: Relation) -> bool:
        """Whether premises make a relation certain, however many it takes.

        Raises NotComparableError where that is beyond what is compared.
        """
        return _as_before(_proves, self.step(Move("sign"), premises), relation)

    def needed(
        self,
        move: Move,
        premises: Sequence[Ref],
        relation: Relation,
        doubted: Iterable[Ref],
        right: Callable[[Move, Sequence[Ref], Relation], bool] | None = None,
    ) -> tuple[Ref, ...]:
        """The premises of a line that follows, without those of the doubted ones it can do without.

        They are tried in the order in which they stand. ``right`` says whether a line follows,
        where that is not for the move alone to say.
        """
        right = right or self.follows
        kept = tuple(premises)
        for ref in doubted:
            fewer = tuple(other for other in kept if other != ref)
            try:
                if right(move, fewer, relation):
                    kept = fewer
            except NotComparableError:
                continue
        return kept


class _OpenError(Exception):
    """A reading that is not kept: memory ran out in the search for what it rests on."""

    def __init__(self, right: bool | None) -> None:
        self.right = right


def _as_before(read: Callable[..., bool | None], step: Step, relation: Relation) -> bool:
    """What a reading comes to, as it did before where the same was cited."""
    own = [relation, *(c.relation for c in step.cited), *(k.relation for k in step.known)]
    names = frozenset(name for side in own for name in names_in(side))
    with_bounces = step.move.record in _BY_SENSES
    setting = step.setting.of_letters(names, with_bounces=with_bounces)
    try:
        right = read(setting, step.move, step.cited, step.known, relation)
    except _OpenError as open_:
        right = open_.right
    if right is None:
        raise NotComparableError
    return right


@remembered(4096)
def _read(
    setting: Setting,
    move: Move,
    cited: tuple[Cited, ...],
    known: tuple[Known, ...],
    relation: Relation,
) -> bool | None:
    """Whether a line follows; None where that is beyond what is compared."""
    return _kept(follows, Step(setting, move, cited, known), relation)


@remembered(2048)
def _proves(
    setting: Setting,
    move: Move,
    cited: tuple[Cited, ...],
    known: tuple[Known, ...],
    relation: Relation,
) -> bool | None:
    """Whether what is cited makes a relation certain; None where that is beyond comparing."""
    return _kept(is_certain, Step(setting, move, cited, known), relation)


def _kept(judge: Callable[[Step, Relation], bool], step: Step, relation: Relation) -> bool | None:
    open_ = broken_off()
    try:
        right = judge(step, relation)
    except NotComparableError:
        right = None
    if broken_off() != open_:
        raise _OpenError(right)
    return right


def setting_of(
    derivation: Derivation, oracle: Oracle, names: Mapping[str, str] | None = None
) -> Setting:
    """What all lines of a working share; ``names`` are `names_of` its facts, where known."""
    values: dict[str, Expression] = {}
    for line in derivation.lines:
        match line.relation:
            case Relation(((Link(Letter(name), "="), *_) as links,)) if (
                name in derivation.meanings and whole_of(links) is not None
            ):
                values[name] = links[-1].right
    own = names_of(derivation.events, derivation.facts) if names is None else names
    either = on_either_side(derivation)
    bounces = tuple(_bounces(derivation))
    return Setting(
        oracle.roles, derivation.events, derivation.meanings, own, values, either, bounces
    )


def _bounces(derivation: Derivation) -> Iterator[Cited]:
    """Both laws at walls, as lines have them, with the data of velocities and walls."""
    walls = {event.number for event in derivation.events if event.wall}
    lines = [
        line
        for line in derivation.lines
        if line.move.event in walls
        and line.move.record in ("unchanged", "restitution-wall")
        and isinstance(line.relation, Relation)
        and len(line.relation.options) == 1
    ]
    for fact in derivation.facts if walls else ():
        if fact.id.startswith(("axis ", "velocity ", "e ", "wall ")):
            yield Cited(fact.id, fact.relation)
    yield from (Cited(line.number, line.relation) for line in lines)


# The records of which a line may rest on the sides to which a body leaves walls.
_BY_SENSES = frozenset({"component", "difference"})


def names_of(events: Iterable[Event], facts: Iterable[Fact]) -> dict[str, str]:
    """What each body and point in events and facts is: a sphere, a wall or a point."""
    names: dict[str, str] = {}
    for event in events:
        for position, body in enumerate(event.bodies):
            names[body] = "wall" if event.wall and position else "sphere"
    for fact in facts:
        for tree in trees_of(fact.relation):
            for node in walk(tree):
                match node:
                    case Quantity("mass" | "velocity" | "speed" | "energy", (Name(name), *_)):
                        names.setdefault(name, "sphere")
                    case Quantity("direction", (Name(name),), None):
                        names.setdefault(name, "wall")
                    case Name(name):
                        names.setdefault(name, "point")
    return names


def on_either_side(derivation: Derivation) -> frozenset[int]:
    """The impacts at which a line of centres, or a wall, may be on either side of **i**.

    It is not given, all spheres start along **i** or are at rest, and nothing that is given tells
    one side from the other.
    """
    facts = {fact.id: fact for fact in derivation.facts}
    match derivation.events:
        case (event,) if event.kind == "impact":
            pass
        case _:
            return frozenset()
    kinds = {ref.partition(" ")[0] for ref in facts}
    if kinds & {"axis", "wall", "position", "let"}:
        return frozenset()
    for body in event.bodies[:1] if event.wall else event.bodies:
        fact = facts.get(f"velocity {body}")
        if fact is None or not _is_along_i(fact.relation.only[0].right):
            return frozenset()
    given = [fact.relation for fact in derivation.facts if fact.kind in ("given", "earlier")]
    if any(_tells_a_side(tree) for relation in given for tree in trees_of(relation)):
        return frozenset()
    return frozenset({event.number})


def _is_along_i(tree: Expression) -> bool:
    """Whether a vector of the data has no component in the direction of **j**."""
    match tree:
        case Pair(_, Number(value)):
            return not value
        case Pair():
            return False
    return not any(
        isinstance(node, Polar | Pair | Unit) and node != Unit("i") for node in walk(tree)
    )


def _tells_a_side(tree: Expression) -> bool:
    """Whether a side of a given relation would be another one in a mirror along **i**."""
    match tree:
        case Quantity("velocity"):
            return True
        case Quantity("direction", (Name(),), None):
            return True
        case Quantity("angle" | "along" | "dot", arguments):
            own = [
                argument
                for argument in arguments
                if not is_quantity(argument, "velocity", "impulse")
            ]
            return any(tree == Unit("j") or _tells_a_side(tree) for tree in own)
        case Quantity("direction" | "across" | "position" | "momentum"):
            return True
        case Quantity("impulse", arguments) if arguments:
            return True
        case Unit("j") | Pair() | Polar():
            return True
    parts: list[Any] = [getattr(tree, field.name) for field in fields(tree)]
    return any(_tells_a_side(part) for part in parts if isinstance(part, Expression))


def known_of_letters(ref: str, setting: Setting) -> Known | None:
    """What a premise such as ``acute: alpha`` or ``e <= 1`` says of letters.

    None where their roles do not say so, or the text says nothing.
    """
    try:
        return _known(ref, setting)
    except (StatementError, NotComparableError, KeyError):
        return None


def _known(ref: str, setting: Setting) -> Known | None:
    head, colon, text = ref.partition(":")
    if colon and head.strip() == "acute":
        angle = read_tree(text, setting.names)
        zero, right = Degrees(Fraction(0)), RIGHT_ANGLE
        relation = Relation(((Link(angle, ">", zero), Link(angle, "<", right)),))
        names = letters(angle)
    else:
        relation = read_relation(ref, setting.names)
        names = frozenset(names_in(relation))
        if not names and _of_a_coefficient(relation):
            return Known(ref, relation, names)
    if not names or any(isinstance(e, Quantity) for t in trees_of(relation) for e in walk(t)):
        return None
    if not _by_roles(ref, relation, setting):
        return None
    return Known(ref, relation, names)


def _of_a_coefficient(relation: Relation) -> bool:
    """Whether a relation is a bound that every coefficient of restitution has."""
    match relation.options:
        case ((Link(Quantity("restitution", (), int()), sign, Number(bound)),),):
            return (sign == "<=" and bound == 1) or (sign == ">=" and bound == 0)
    return False


def _by_roles(ref: str, relation: Relation, setting: Setting) -> bool:
    if len(relation.options) == 1 and all(_is_end(e, setting) for e in relation.options[0]):
        return True
    step = Step(setting, Move("let"), (), ())
    names = names_in(relation)
    roles = {name: setting.role(name) for name in sorted(names)}
    formulas = []
    for links in relation.options:
        for link in links:
            left, right = (step.world.scalar(side) for side in (link.left, link.right))
            formulas.append(
                compared(
                    step.world.expression(left, roles),
                    link.sign,
                    step.world.expression(right, roles),
                )
            )
    if len(relation.options) != 1:
        return False
    return _proved(tuple(roles.items()), All(tuple(formulas)))


def _is_end(link: Link, setting: Setting) -> bool:
    """Whether a link bounds a letter by no less than its role does."""
    match link:
        case Link(Letter(name), sign, Number() | Degrees() | Negate() as bound):
            lower = {">": True, ">=": True, "<": False, "<=": False}.get(sign)
        case Link(Number() | Degrees() | Negate() as bound, sign, Letter(name)):
            lower = {"<": True, "<=": True, ">": False, ">=": False}.get(sign)
        case _:
            return False
    role, number = setting.role(name), _number(bound)
    end = None if lower is None else role.low if lower else role.high
    if end is None or number is None:
        return False
    gap = (end - number) * (1 if lower else -1)
    closed = role.closed[0 if lower else 1]
    return bool(gap > 0) or (gap == 0 and ("=" in sign or not closed))


def _number(tree: Expression) -> sp.Expr | None:
    match tree:
        case Negate(inner):
            own = _number(inner)
            return None if own is None else -own
        case Number(value):
            return sp.Rational(*value.as_integer_ratio())
        case Degrees(value):
            return sp.Rational(*value.as_integer_ratio()) * sp.pi / 180
    return None


@lru_cache(maxsize=256)
def _proved(roles: tuple[tuple[str, object], ...], claim: All) -> bool:
    return Oracle(dict(roles)).proves(claim)  # type: ignore[arg-type]


def names_in(relation: Relation | Meaning) -> frozenset[str]:
    """The letters in a relation."""
    if isinstance(relation, Relation):
        return relation.letters
    return letters(relation.quantity) | {relation.letter}
