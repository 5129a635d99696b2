"""What all lines of a working share: its letters, events and names; and what a line cites."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from functools import cached_property

import sympy as sp

from restitution.explaining.lines.derivation import Event, Link, Meaning, Relation
from restitution.explaining.lines.notation import read_tree
from restitution.explaining.lines.trees import settled
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import Binary, Expression, Letter, Name, Quantity, letters
from restitution.oracle.roles import (
    ACUTE,
    DIRECTION,
    POSITIVE,
    REAL,
    TO_180,
    Role,
    of_two_angles,
)
from restitution.records import dataclass

TO_90 = Role("angle", sp.Integer(0), sp.pi / 2, (True, True))


@dataclass(frozen=True)
class Cited:
    """A premise that is on paper: a line or a fact."""

    ref: int | str
    relation: Relation | Meaning


@dataclass(frozen=True)
class Known:
    """What is known of letters, and cited: a relation that holds by their roles."""

    ref: str
    relation: Relation
    letters: frozenset[str]


@dataclass(frozen=True)
class Setting:
    """What all lines of a working share.

    The roles of letters, events, letters introduced, names, and the values that lines give to
    letters introduced.
    """

    roles: Mapping[str, Role]
    events: tuple[Event, ...] = ()
    meanings: Mapping[str, Meaning] = field(default_factory=dict)
    names: Mapping[str, str] = field(default_factory=dict)
    values: Mapping[str, Expression] = field(default_factory=dict)
    either: frozenset[int] = frozenset()
    """The impacts at which a line of centres may be on either side of **i**: they are mirrored."""
    bounces: tuple[Cited, ...] = ()
    """Data of velocities and walls, and both laws at walls: they tell the senses of velocities."""

    def role(self, name: str) -> Role:
        """What a letter may be: one of the statement, or an angle that a working introduces."""
        role = self.roles.get(name)
        if role is None and name in self.meanings:
            own = self.meanings[name]
            role = ACUTE if own.angle == "acute" else self.of_angle(own.quantity)
        return role or REAL

    def of_angle(self, quantity: Expression) -> Role | None:
        """What an angle may be: to a wall or a line of centres, no more than a right angle."""
        match quantity:
            case Quantity("angle", sides):
                return TO_90 if any(self._is_line(side) for side in sides) else TO_180
            case Quantity("deflection"):
                return TO_180
            case Quantity("direction", (Name(name),)) if self.names.get(name) != "wall":
                return DIRECTION
            case Binary("+" | "-" as sign, Letter(one), Letter(other)):
                return of_two_angles(self.role(one), sign, self.role(other))
        return None

    def _is_line(self, tree: Expression) -> bool:
        match tree:
            case Name(name):
                return self.names.get(name) == "wall"
            case Quantity("line_of_centres"):
                return True
        return False

    def event(self, number: int | None) -> Event | None:
        """The event with a number."""
        return next((event for event in self.events if event.number == number), None)

    def settled(self, link: Link) -> Link:
        """A link in which velocities have the number of the last event that changed them."""
        left, right = (settled(side, self.events) for side in (link.left, link.right))
        return Link(left, link.sign, right, link.by)

    def quantity(self, tree: Expression) -> Expression:
        """A tree in which velocities have the number of the last event that changed them."""
        return settled(tree, self.events)

    def tree(self, text: str) -> Expression:
        """The tree of a text, such as what a move eliminates."""
        return settled(read_tree(text, self.names), self.events)

    def of_letters(self, names: frozenset[str], *, with_bounces: bool) -> Setting:
        """The same setting, without letters introduced of which nothing is said.

        The laws at walls are left out too, unless it is ``with_bounces``.
        """
        if self.bounces and not with_bounces:
            return self._without_bounces.of_letters(names, with_bounces=True)
        names |= {
            name
            for premise in self.bounces
            if isinstance(premise.relation, Relation)
            for links in premise.relation.options
            for link in links
            for side in (link.left, link.right)
            for name in letters(side)
        }
        kept = set(names & self.meanings.keys())
        pending = list(kept)
        while pending:
            inside = letters(self.meanings[pending.pop()].quantity)
            more = inside & self.meanings.keys() - kept
            kept |= more
            pending += more
        if len(kept) == len(self.meanings):
            return self
        own = frozenset(kept)
        if own not in self._of_fewer:
            self._of_fewer[own] = replace(
                self,
                meanings={n: meaning for n, meaning in self.meanings.items() if n in kept},
                values={n: value for n, value in self.values.items() if n in kept},
            )
        return self._of_fewer[own]

    @cached_property
    def _without_bounces(self) -> Setting:
        return replace(self, bounces=())

    @cached_property
    def _of_fewer(self) -> dict[frozenset[str], Setting]:
        """The settings of fewer letters: each keeps its hash, and is found without comparing."""
        return {}

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        mappings = (self.roles, self.meanings, self.names, self.values)
        return hash(
            (
                self.events,
                self.either,
                self.bounces,
                *(tuple(sorted(mapping.items())) for mapping in mappings),
            )
        )

    @cached_property
    def angles(self) -> frozenset[str]:
        """The letters that are angles."""
        by_role = {name for name, role in self.roles.items() if role.kind == "angle"}
        return frozenset(by_role | {n for n, m in self.meanings.items() if is_angle(m)})

    @cached_property
    def vectors(self) -> frozenset[str]:
        """The letters that are vectors."""
        return frozenset(name for name, meaning in self.meanings.items() if meaning.vector)

    @cached_property
    def silent(self) -> Mapping[str, Role]:
        """What may be used of letters without a word: that masses, speeds, lengths are positive.

        A closer bound that is given of such a letter is a reason, and has to be cited.
        """
        return {n: POSITIVE if role.kind == "positive" else REAL for n, role in self.roles.items()}

    @cached_property
    def spheres(self) -> tuple[str, ...]:
        """The names of the spheres."""
        return tuple(name for name, kind in self.names.items() if kind == "sphere")


def is_angle(meaning: Meaning) -> bool:
    """Whether a letter stands for an angle."""
    return meaning.angle is not None or (
        isinstance(meaning.quantity, Quantity)
        and meaning.quantity.kind in ANGLES
        and not meaning.vector
    )


def is_direction(tree: Expression, setting: Setting) -> bool:
    """Whether a tree is a direction: of an axis, a wall, an impulse, or a vector letter."""
    match tree:
        case Quantity("line_of_centres", _):
            return True
        case Quantity("direction", (Name(name),), None):
            return setting.names.get(name) == "wall"
        case Quantity("impulse", (_,)):
            return True
        case Letter(name):
            return name in setting.vectors
    return False
