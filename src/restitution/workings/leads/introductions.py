"""What letters stand for: the sentences that introduce them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import Any

from restitution.explaining.lines.derivation import Derivation, Event, Meaning
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Polar,
    Quantity,
    Unit,
    has_quantity,
    is_function,
    unsigned,
)
from restitution.render import layout as lay
from restitution.workings.naming.multiples import multiples
from restitution.workings.naming.quantities import Naming

# Letters along a line of centres that is given as a direction, and one that is given by its angle.
_TOWARDS = ("let.component-centres-towards", "let.components-centres-towards")
_AT_A_WALL = {
    "derived.component-parallel": "let.component-parallel",
    "derived.component-towards": "derived.towards",
    "derived.component-away": "derived.away",
}
_AT = ("let.component-centres-at", "let.components-centres-at")
_CLOCKWISE = ("let.component-centres-clockwise", "let.components-centres-clockwise")


class Introductions:
    """The introductions of the letters of one derivation."""

    def __init__(self, derivation: Derivation, naming: Naming) -> None:
        self._derivation = derivation
        self._naming = naming
        self._multiples = multiples(derivation)

    def of(self, lets: Sequence[Meaning]) -> Iterator[Sentence]:
        """What letters stand for: quantities by name, and the others as equations."""
        early = self._naming.introduced_early | self._multiples
        new = [let for let in lets if let.letter not in early]
        for kind, group in groupby(new, self._kind):
            meanings = list(group)
            if kind is None:
                yield say(
                    "derived.name",
                    equations=tuple(
                        lay.Relation(
                            (self._letter(meaning), self._naming.layout(meaning.quantity)), ("=",)
                        )
                        for meaning in meanings
                    ),
                )
            elif kind == "named" and (vectors := self._resolved(meanings)):
                yield say("derived.name", equations=vectors)
            elif len(meanings) > 1 and (bodies := _with_masses(meanings)):
                letters = tuple(map(self._letter, meanings))
                yield say("let.masses", letters=letters, bodies=bodies)
            elif kind == "named":
                yield say(
                    "derived.let",
                    meanings=tuple(
                        say(
                            "derived.meaning",
                            letter=self._letter(meaning),
                            quantity=self._naming.of_letter(meaning),
                        )
                        for meaning in meanings
                    ),
                )
            else:
                yield from self._components(kind, meanings)
            for meaning in meanings:
                self._naming.knows(meaning.quantity, meaning.letter)

    def _resolved(self, meanings: Sequence[Meaning]) -> tuple[lay.Layout, ...]:
        """``𝐮 = a𝐢 + b𝐣`` of each velocity, if the letters are the components of velocities."""
        parts: dict[Expression, dict[str, Expression]] = {}
        for meaning in meanings:
            match meaning.quantity:
                case Quantity("along", (Quantity("velocity") as velocity, Unit(axis))):
                    parts.setdefault(velocity, {})[axis] = Letter(meaning.letter)
        if 2 * len(parts) != len(meanings) or any(len(part) != 2 for part in parts.values()):
            return ()
        sums = {
            velocity: Binary("+", *(Binary("*", part[axis], Unit(axis)) for axis in ("i", "j")))
            for velocity, part in parts.items()
        }
        return tuple(
            lay.Relation((self._naming.layout(velocity), self._naming.layout(total)), ("=",))
            for velocity, total in sums.items()
        )

    def _letter(self, meaning: Meaning) -> lay.Layout:
        return self._naming.layout(Letter(meaning.letter))

    def _kind(self, meaning: Meaning) -> Any:
        """Letters that are introduced in one sentence: components of one impact; the others."""
        match meaning.quantity:
            case Quantity("along", (Quantity("velocity", (Name(body),), int(stage)), axis)):
                event = self._naming.event_of_axis(axis)
                sense = meaning.sense if meaning.sense is not None else axis
                if event is not None and event.number == stage:
                    turned = self._turned(axis, sense)
                    if turned is None:
                        return ("axis", sense)
                    return ("wall" if event.wall else "centres", event, turned)
                last = self._naming.last(body)
                if isinstance(sense, Unit) and event is None and stage and stage == last:
                    return ("axis", sense)
                return "named"
            case Quantity():
                return "named"
        return None

    @staticmethod
    def _turned(axis: Expression, sense: Expression) -> bool | None:
        """Whether a sense is against the axis; None where it is another direction."""
        own, back = (
            (tree.operand, True) if isinstance(tree, Negate) else (tree, False)
            for tree in (axis, sense)
        )
        return own[1] != back[1] or own[1] if own[0] == back[0] else None

    def _components(self, kind: tuple[Any, ...], meanings: list[Meaning]) -> Iterator[Sentence]:
        letters = tuple(self._letter(meaning) for meaning in meanings)
        bodies = tuple(meaning.quantity.arguments[0].arguments[0].name for meaning in meanings)  # type: ignore[union-attr]
        if kind[0] == "axis":
            sense = self._naming.at_the_wall(kind[1])
            axis = self._naming.layout(kind[1])
            if sense is not None:
                for letter, body in zip(letters, bodies, strict=True):
                    yield say(_AT_A_WALL[sense[0]], letter=letter, body=body, wall=sense[1])
            elif len(letters) > 1:
                yield say("let.components", letters=letters, bodies=bodies, axis=axis)
            else:
                yield say("let.component", letter=letters[0], body=bodies[0], axis=axis)
            return
        event: Event = kind[1]
        first, second = reversed(event.bodies) if kind[2] else event.bodies
        if kind[0] == "wall":
            name = "derived.away" if kind[2] else "derived.towards"
            for letter, body in zip(letters, bodies, strict=True):
                yield say(name, letter=letter, body=body, wall=event.bodies[1])
        elif (given := self._given_axis(event, turned=kind[2])) is not None:
            (one, several), slots = given
            if len(letters) > 1:
                yield say(several, letters=letters, bodies=bodies, **slots)
            else:
                yield say(one, letter=letters[0], body=bodies[0], **slots)
        elif len(letters) > 1:
            yield say(
                "let.components-centres",
                letters=letters,
                bodies=bodies,
                first=first,
                second=second,
            )
        else:
            yield say(
                "let.component-centres",
                letter=letters[0],
                body=bodies[0],
                first=first,
                second=second,
            )

    def _given_axis(
        self, event: Event, *, turned: bool
    ) -> tuple[tuple[str, str], dict[str, Any]] | None:
        """The direction in which a line of centres is given, which need not be that of approach.

        The sentences for one letter and for several, and what they say; None where the line is
        worked out: then it leads from the first body to the second.
        """
        fact = self._derivation.fact(f"axis {event.number}")
        if fact is None:
            return None
        axis = fact.relation.only[0].right
        by_places = has_quantity(axis)
        if isinstance(axis, Polar) or by_places:
            return None
        own = unsigned(axis)
        if isinstance(own, Degrees | Letter) or is_function(own, "arcsin", "arccos", "arctan"):
            unit = self._naming.layout(Negate(Unit("i")) if turned else Unit("i"))
            names, angle = (_CLOCKWISE, axis.operand) if isinstance(axis, Negate) else (_AT, axis)
            return names, {"axis": self._naming.layout(angle), "unit": unit}
        sense: Expression = axis
        if turned:
            sense = _reversed(axis)
        return _TOWARDS, {"axis": self._naming.layout(sense)}


def _with_masses(meanings: Sequence[Meaning]) -> tuple[str, ...]:
    """The bodies of which letters are the masses; () where one is something else."""
    bodies = []
    for meaning in meanings:
        match meaning.quantity:
            case Quantity("mass", (Name(body),)):
                bodies.append(body)
            case _:
                return ()
    return tuple(bodies)


def _reversed(direction: Expression) -> Expression:
    """The opposite direction, term by term."""
    match direction:
        case Negate(operand):
            return operand
        case Binary("+" | "-" as sign, left, right):
            return Binary("-" if sign == "+" else "+", _reversed(left), right)
    return Negate(direction)
