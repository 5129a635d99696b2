"""Principles, definitions and identities as records: what each says, what it gives, what it costs.

A template is text in the language of statements. In it X is the body that a move names first and Y
the second, F and S are the first and the second body of the event (for a wall, S is the wall), 0
is the stage before the event, and 1 the event and the stage after it. What a record is called, why
it holds, and the usual mistakes stand among the sentences, under the id of the record.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Literal

from restitution.explaining.laws.templates import AXIS
from restitution.explaining.laws.templates import across_line as _s
from restitution.explaining.laws.templates import along_line as _c
from restitution.explaining.lines.derivation import Event, Relation
from restitution.explaining.lines.notation import read_relation
from restitution.explaining.lines.saying import topic_of
from restitution.explaining.lines.sentences import SentenceId
from restitution.explaining.lines.titles import title_of
from restitution.explaining.lines.trees import renamed, trees_of
from restitution.expression.tree import COMPONENTS, Quantity, walk
from restitution.records import dataclass


def _x(body: str, stage: int) -> str:
    return f"along(velocity({body}, {stage}), i)"


def _y(body: str, stage: int) -> str:
    return f"along(velocity({body}, {stage}), j)"


def _square(body: str, stage: int) -> str:
    return f"({_c(body, stage)}^2 + {_s(body, stage)}^2)"


def _squares(body: str, stage: int) -> tuple[str, str, str]:
    """The square of a speed: as such, by its components, as a scalar product."""
    velocity = f"velocity({body}, {stage})"
    return f"speed({body}, {stage})^2", _square(body, stage), f"dot({velocity}, {velocity})"


@dataclass(frozen=True)
class Record:
    """A principle, a definition or an identity.

    ``templates`` are its forms, of which a line takes one. ``where`` tells at which impacts it
    holds; ``gives`` the kinds of quantity for which it is read. What it earns stands in
    `mark_rules`, what a line of it costs a reader in the planner. Of the angle to a wall or to a
    line of centres, which is at most 90°, the right side is taken positive; of an angle up to 180°
    whose tangent is a quotient, what stands above.
    """

    id: str
    kind: Literal["principle", "definition", "identity"]
    templates: tuple[str, ...] = ()
    where: Literal["wall", "spheres", "impact", "any"] = "any"
    gives: tuple[str, ...] = ()

    @property
    def needs(self) -> frozenset[str]:
        """The kinds of quantities in the record: all but one have to be known."""
        return frozenset(
            node.kind
            for template in self.templates
            for tree in trees_of(_read(template))
            for node in walk(tree)
            if isinstance(node, Quantity)
        )

    def title(self, event: Event | None = None) -> SentenceId | None:
        """The sentence that names the record above its lines; None where it has no name."""
        return title_of(self.id, event)

    def topic(self, event: Event | None = None) -> str | None:
        """The topic of the sentences on why the record holds, and on the usual mistakes.

        None where a reader may not ask.
        """
        title = self.title(event)
        return None if title is None else topic_of(title)

    def serves(self, event: Event | None) -> bool:
        """Whether the record is about such an event."""
        if self.where == "any":
            return True
        if event is None or event.kind != "impact":
            return False
        return self.where == "impact" or (self.where == "wall") == event.wall

    def relations(self, event: Event | None, bodies: tuple[str, ...]) -> tuple[Relation, ...]:
        """What the record says of some bodies in an event, in each of its forms.

        Forms that speak of more bodies than there are are left out.
        """
        return _relations(self.templates, event, bodies)


@cache
def _read(template: str) -> Relation:
    return read_relation(template, dict.fromkeys(("X", "Y", "F", "S"), "sphere"))


@cache
def _relations(
    templates: tuple[str, ...], event: Event | None, bodies: tuple[str, ...]
) -> tuple[Relation, ...]:
    put = dict(zip(("X", "Y"), bodies, strict=False))
    if event is not None:
        put |= dict(zip(("F", "S"), event.bodies, strict=False))
    number = 1 if event is None else event.number
    relations = (renamed(_read(template), put, number) for template in templates)
    return tuple(relation for relation in relations if relation is not None)


PRINCIPLES = (
    Record(
        "unchanged",
        "principle",
        (f"{_s('X', 1)} = {_s('X', 0)}",),
        "impact",
        ("across",),
    ),
    Record(
        "restitution-wall",
        "principle",
        (f"{_c('X', 1)} = -restitution(1) {_c('X', 0)}",),
        "wall",
        ("along", "restitution"),
    ),
    Record(
        "momentum",
        "principle",
        (
            (
                f"mass(F) {_c('F', 0)} + mass(S) {_c('S', 0)}"
                f" = mass(F) {_c('F', 1)} + mass(S) {_c('S', 1)}"
            ),
        ),
        "spheres",
        ("along", "mass"),
    ),
    Record(
        "restitution",
        "principle",
        (f"{_c('S', 1)} - {_c('F', 1)} = restitution(1) ({_c('F', 0)} - {_c('S', 0)})",),
        "spheres",
        ("along", "restitution"),
    ),
    Record(
        "momentum-vector",
        "principle",
        (
            (
                "mass(F) velocity(F, 0) + mass(S) velocity(S, 0)"
                " = mass(F) velocity(F, 1) + mass(S) velocity(S, 1)"
            ),
            "momentum(F, 0) + momentum(S, 0) = momentum(F, 1) + momentum(S, 1)",
        ),
        "spheres",
        ("velocity", "mass"),
    ),
    Record(
        "impulse-vector",
        "principle",
        ("impulse(X, 1) = mass(X) (velocity(X, 1) - velocity(X, 0))",),
        "any",
        ("impulse", "velocity", "line_of_centres"),
    ),
    Record(
        "opposite-impulses",
        "principle",
        (
            "impulse(S, 1) = -impulse(F, 1)",
            "impulse(S, 1) = -mass(F) (velocity(F, 1) - velocity(F, 0))",
            "impulse(F, 1) = -mass(S) (velocity(S, 1) - velocity(S, 0))",
        ),
        "spheres",
        ("impulse",),
    ),
    Record(
        "impulse",
        "principle",
        (
            f"impulse(1) = mass(F) ({_c('F', 0)} - {_c('F', 1)})",
            f"impulse(1) = mass(S) ({_c('S', 1)} - {_c('S', 0)})",
            f"along(impulse(X, 1), {AXIS}) = mass(X) ({_c('X', 1)} - {_c('X', 0)})",
        ),
        "impact",
        ("impulse", "along", "mass"),
    ),
    Record(
        "across-the-impulse",
        "principle",
        (
            f"{AXIS} parallel to impulse(X, 1)",
            f"angle({AXIS}, i) = angle(impulse(S, 1), i)",
            f"angle({AXIS}, i) = angle(i, impulse(S, 1))",
            f"angle({AXIS}, i) = 180° - angle(impulse(F, 1), i)",
            f"angle({AXIS}, i) = 180° - angle(i, impulse(F, 1))",
        ),
        "impact",
        ("line_of_centres",),
    ),
    Record(
        "along-the-change",
        "principle",
        (f"{AXIS} parallel to velocity(X, 1) - velocity(X, 0)",),
        "impact",
        ("line_of_centres",),
    ),
    # Its size, along the line of centres, away from the other body.
    Record("impulse-direction", "principle", (), "impact", ("impulse",)),
    # The velocity before, and the change along the line of centres, or into the wall.
    Record("changed-velocity", "principle", (), "impact", ("velocity",)),
    # Who was at rest goes along the line of centres: to where its next event is.
    Record("moves-off", "principle", (), "spheres", ("line_of_centres",)),
    Record(
        "wall-direction",
        "principle",
        (f"direction(S) perpendicular to {AXIS}",),
        "wall",
        ("direction",),
    ),
    Record(
        "equal-across",
        "principle",
        (
            "dot(velocity(X, 1), direction(S)) = dot(velocity(X, 0), direction(S))",
            f"dot(velocity(X, 1) - velocity(X, 0), direction(S)) = 0",  # noqa: F541
        ),
        "wall",
        ("direction",),
    ),
)

DEFINITIONS = (
    Record("component", "definition", gives=("along", "across", "dot")),
    Record("assemble", "definition", gives=("velocity",)),
    Record("relative-velocity", "definition"),
    Record("product", "definition", gives=("dot",)),
    Record(
        "tan",
        "definition",
        (
            f"tan(angle(velocity(X, 1), {AXIS})) = {_s('X', 1)}/{_c('X', 1)}",
            f"tan(angle(velocity(X, 0), {AXIS})) = {_s('X', 0)}/{_c('X', 0)}",
            f"tan(angle(velocity(X, 1), S)) = {_c('X', 1)}/{_s('X', 1)}",
            f"tan(angle(velocity(X, 0), S)) = {_c('X', 0)}/{_s('X', 0)}",
            # Between two velocities, by what stands above and below in the formula of a difference.
            *(
                f"tan(angle(velocity(X, {a}), velocity(Y, {b})))"
                f" = ({_c('X', a)} {_s('Y', b)} - {_s('X', a)} {_c('Y', b)})"
                f"/({_c('X', a)} {_c('Y', b)} + {_s('X', a)} {_s('Y', b)})"
                for a, b in ((1, 1), (0, 0))
            ),
            *(
                f"tan(angle(velocity(X, {n}), {a}))"
                f" = along(velocity(X, {n}), {b})/along(velocity(X, {n}), {a})"
                for a, b in ("ij", "ji")
                for n in (1, 0)
            ),
            *(
                f"tan(angle(velocity(X, {n}), -{a}))"
                f" = along(velocity(X, {n}), {b})/(-along(velocity(X, {n}), {a}))"
                for a, b in ("ij", "ji")
                for n in (1, 0)
            ),
        ),
        gives=("angle",),
    ),
    Record(
        "tan-direction",
        "definition",
        (
            "tan(direction(X, 1)) = along(velocity(X, 1), j)/along(velocity(X, 1), i)",
            "tan(direction(X, 0)) = along(velocity(X, 0), j)/along(velocity(X, 0), i)",
        ),
        gives=("direction",),
    ),
    Record(
        "tan-deflection",
        "definition",
        (
            (
                f"tan(deflection(X, 1)) = ({_c('X', 0)} {_s('X', 1)} - {_s('X', 0)} {_c('X', 1)})"
                f"/({_c('X', 0)} {_c('X', 1)} + {_s('X', 0)} {_s('X', 1)})"
            ),
        ),
        gives=("deflection",),
    ),
    Record(
        "tan-from-axis",
        "definition",
        (
            (
                f"tan(deflection(X, 1)) = ({_x('X', 0)} {_y('X', 1)} - {_y('X', 0)} {_x('X', 1)})"
                f"/({_x('X', 0)} {_x('X', 1)} + {_y('X', 0)} {_y('X', 1)})"
            ),
        ),
        gives=("deflection",),
    ),
    Record(
        "speed",
        "definition",
        (
            f"speed(X, 1)^2 = {_square('X', 1)}",
            f"speed(X, 0)^2 = {_square('X', 0)}",
            "speed(X, 1)^2 = dot(velocity(X, 1), velocity(X, 1))",
            "speed(X, 0)^2 = dot(velocity(X, 0), velocity(X, 0))",
            f"speed(X, 1) = sqrt{_square('X', 1)}",
            f"speed(X, 0) = sqrt{_square('X', 0)}",
            "speed(X, 1) = abs(velocity(X, 1))",
            "speed(X, 0) = abs(velocity(X, 0))",
        ),
        gives=("speed",),
    ),
    Record(
        "size",
        "definition",
        ("impulse(1) = abs(impulse(X, 1))", "impulse(1) = abs(impulse(F, 1))"),
        gives=("impulse",),
    ),
    Record(
        "energy",
        "definition",
        (
            "energy(X, 1) = 1/2 mass(X) speed(X, 1)^2",
            "energy(X, 0) = 1/2 mass(X) speed(X, 0)^2",
            f"energy(X, 1) = 1/2 mass(X) {_square('X', 1)}",
            f"energy(X, 0) = 1/2 mass(X) {_square('X', 0)}",
            "energy(X, 1) = 1/2 mass(X) dot(velocity(X, 1), velocity(X, 1))",
            "energy(X, 0) = 1/2 mass(X) dot(velocity(X, 0), velocity(X, 0))",
        ),
        gives=("energy",),
    ),
    Record(
        "energy-ratio",
        "definition",
        tuple(
            f"energy(X, 1)/energy(X, 0) = {late}/{early}"
            for late in _squares("X", 1)
            for early in _squares("X", 0)
        ),
        gives=("energy",),
    ),
    # The energies of all spheres: the terms are those of the spheres that there are.
    Record("total", "definition", gives=("energy",)),
    Record("total-lost", "definition", gives=("total_energy_lost",)),
    Record("energy-lost", "definition", gives=("energy_lost",)),
    # Of one body, of which the component across the line does not change.
    Record(
        "energy-change",
        "definition",
        ((f"energy(X, 1) - energy(X, 0) = 1/2 mass(X) ({_c('X', 1)}^2 - {_c('X', 0)}^2)"),),
        "impact",
        ("energy",),
    ),
    # What a cited right angle, or a cited common direction, says of components or vectors.
    Record("perpendicular", "definition", gives=COMPONENTS),
    Record("parallel", "definition", gives=COMPONENTS),
    Record(
        "scalar-angle",
        "definition",
        (
            (
                "cos(deflection(X, 1)) = dot(velocity(X, 0), velocity(X, 1))"
                "/(abs(velocity(X, 0)) abs(velocity(X, 1)))"
            ),
            (
                "cos(angle(velocity(X, 1), velocity(Y, 1))) = dot(velocity(X, 1), velocity(Y, 1))"
                "/(abs(velocity(X, 1)) abs(velocity(Y, 1)))"
            ),
            "cos(direction(X, 1)) = along(velocity(X, 1), i)/abs(velocity(X, 1))",
            f"cos(angle(velocity(X, 1), {AXIS})) = {_c('X', 1)}/sqrt{_square('X', 1)}",
            f"cos(angle(velocity(X, 0), {AXIS})) = {_c('X', 0)}/sqrt{_square('X', 0)}",
            (
                f"cos(deflection(X, 1)) = ({_c('X', 0)} {_c('X', 1)} + {_s('X', 0)} {_s('X', 1)})"
                f"/(sqrt{_square('X', 0)} sqrt{_square('X', 1)})"
            ),
        ),
        gives=("angle", "deflection"),
    ),
    Record(
        "sum",
        "definition",
        (
            "deflection(X, 1) = angle(velocity(X, 0), S) + angle(velocity(X, 1), S)",
            (
                f"deflection(X, 1) = 180° - angle(velocity(X, 0), {AXIS})"
                f" - angle(velocity(X, 1), {AXIS})"
            ),
        ),
        "wall",
        gives=("deflection",),
    ),
    Record(
        "difference",
        "definition",
        # Of angles to the line of centres: how they are put together, the components tell.
        ("energy_lost(1) = energy(0) - energy(1)",),
        gives=("deflection", "angle", "energy_lost"),
    ),
    Record(
        "momentum-of",
        "definition",
        ("momentum(X, 1) = mass(X) velocity(X, 1)", "momentum(X, 0) = mass(X) velocity(X, 0)"),
        gives=("momentum",),
    ),
    # A velocity by its size and how far it is turned, to a side that is told, or else taken.
    Record("turned", "definition", where="impact", gives=("velocity",)),
    # What is mirrored, where a line of centres may be on either side of **i**.
    Record("either-side", "definition", where="impact", gives=("direction",)),
    # The places are those of which a line speaks.
    Record("distance", "definition", gives=("distance",)),
    Record(
        "tan-squared",
        "definition",
        (
            f"tan(angle(velocity(X, 1), {AXIS}))^2 = {_s('X', 1)}^2/{_c('X', 1)}^2",
            f"tan(angle(velocity(X, 0), {AXIS}))^2 = {_s('X', 0)}^2/{_c('X', 0)}^2",
        ),
        gives=("angle",),
    ),
    # Centres that touch, on their line.
    Record("beside", "definition", where="spheres", gives=("position",)),
    # From one point of a circular wall to the next.
    Record("chord", "definition", gives=("along", "across", "time")),
    # By three chords back to where they began.
    Record("round", "definition", gives=("angle",)),
    Record(
        "straight-line",
        "definition",
        (
            "position(X, 1) - position(X, 0) = velocity(X, 0) (time(1) - time(0))",
            *(
                f"along(position(X, 1), {axis}) - along(position(X, 0), {axis})"
                f" = along(velocity(X, 0), {axis}) (time(1) - time(0))"
                for axis in "ij"
            ),
            (
                "(along(position(X, 1), j) - along(position(X, 0), j)) along(velocity(X, 0), i)"
                " = (along(position(X, 1), i) - along(position(X, 0), i)) along(velocity(X, 0), j)"
            ),
        ),
        gives=("position", "time"),
    ),
)

IDENTITIES = tuple(
    Record(name, "identity")
    for name in ("pythagoras", "double-angle", "half-angle", "sum-of-angles", "complement")
)

RECORDS: Mapping[str, Record] = {
    record.id: record for record in (*PRINCIPLES, *DEFINITIONS, *IDENTITIES)
}
