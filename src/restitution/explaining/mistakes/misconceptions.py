"""Misconceptions and slips as records: what a student does, what it leads to, how it is marked.

A misconception is a law or a result that is altered; its variants, which the solver runs, stand in
`alterations`. A slip has no variants. The sentences on usual mistakes take their words from here.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from difflib import get_close_matches
from functools import cache
from typing import Literal

from restitution.errors import StatementError
from restitution.explaining.laws.principles import RECORDS
from restitution.explaining.lines.derivation import Event, Link, Relation
from restitution.explaining.lines.notation import read_relation, read_tree
from restitution.explaining.lines.trees import rebuilt
from restitution.explaining.lines.usual_mistakes import PHRASES
from restitution.explaining.mistakes.alteration import Alteration, LawName
from restitution.explaining.mistakes.alterations import alterations_of
from restitution.expression.tree import Expression, Name, Quantity
from restitution.records import dataclass

World = Literal["motion", "result", "none"]
_BODIES = dict.fromkeys(("X", "F", "S"), "sphere")


@dataclass(frozen=True)
class Misconception:
    """A mistake with a rule that can be run.

    ``replaces`` names the law, the result or the fact in whose place it stands, ``kinds`` the
    principles whose lines it fits. ``sentence`` is what the student does, ``consequence`` what it
    leads to, ``line`` a usual line of it. ``marks`` has for each principle what a line of it
    earns where the right one earns all, and ``rule`` what else is to be said. ``world`` tells
    whether the motion is altered or one result alone; ``none`` is a mistake that alters neither.
    """

    id: str
    title: str
    replaces: tuple[str, ...]
    kinds: tuple[str, ...]
    sentence: str
    consequence: str
    line: str
    marks: tuple[tuple[str, str], ...]
    rule: str = ""
    world: World = "motion"

    @property
    def variants(self) -> tuple[Alteration, ...]:
        """Its altered laws and results, ``ID/1`` first."""
        return alterations_of(self.id)

    @property
    def phrase(self) -> str:
        """The mistake in a few words, as it stands among the usual mistakes of a principle."""
        return PHRASES[self.id]

    def mark_of(self, principle: str) -> str | None:
        """What a line of a principle with this mistake earns: ``M1 A0``; None for no such line."""
        return dict(self.marks).get(principle)


@dataclass(frozen=True)
class Slip:
    """A mistake without a rule: ``sentence`` is what happened."""

    id: str
    title: str
    sentence: str


@dataclass(frozen=True)
class LawAt:
    """An altered law at an event: which law it replaces, of which bodies, and the equation."""

    law: LawName
    bodies: tuple[str, ...]
    relation: Relation

    @property
    def sides(self) -> tuple[Expression, Expression]:
        """The two sides of the equation."""
        (link,) = self.relation.only
        return link.left, link.right


@dataclass(frozen=True)
class ResultAt:
    """An altered result at an event: ``value`` stands in place of ``quantity``.

    It can be meant only where ``sense`` is not negative.
    """

    quantity: Expression
    value: Expression
    sense: Expression | None = None


@dataclass(frozen=True)
class VariantAt:
    """A variant of a misconception at an event, as trees.

    ``senses`` are scalars that are not negative where the student's signs are those of the
    components.
    """

    alteration: Alteration
    event: Event
    laws: tuple[LawAt, ...]
    results: tuple[ResultAt, ...]
    senses: tuple[Expression, ...] = ()

    @property
    def id(self) -> str:
        return self.alteration.id

    @property
    def mistake(self) -> str:
        return self.alteration.mistake


MISCONCEPTIONS: Mapping[str, Misconception] = {
    mistake.id: mistake
    for mistake in (
        Misconception(
            "deflection-is-after",
            "The angle after given as the deflection",
            ("deflection",),
            ("deflection", "angle"),
            "The angle of the new path is given as the angle of deflection.",
            "The deflection is the angle between the two directions of motion; the angle after is "
            "only a part of it.",
            "deflection = β",
            (("deflection", "M0"), ("angle", "M1 A0")),
            "M1 for finding β.",
            "result",
        ),
        Misconception(
            "deflection-difference",
            "The wrong combination of angles",
            ("deflection",),
            ("deflection", "angle"),
            "The angles before and after are put together in the wrong way.",
            "At a wall the path turns through α + β; their difference belongs to a path that goes "
            "on through the wall.",
            "deflection = α − β",
            (("deflection", "M0"), ("angle", "M0")),
            world="result",
        ),
        Misconception(
            "restitution-parallel",
            "Restitution in the wrong direction",
            ("restitution", "unchanged"),
            ("restitution", "unchanged"),
            "e is applied to the component parallel to the wall, or across the line of centres.",
            "The component that a smooth contact cannot touch is changed, and the one that has to "
            "change is kept.",
            "v cos β = eu cos α",
            (("restitution", "M0"), ("unchanged", "B0")),
        ),
        Misconception(
            "restitution-whole-speed",
            "Restitution with whole speeds",
            ("restitution",),
            ("restitution", "speed"),
            "e is applied to the speeds in place of their components along the line of centres.",
            "The whole velocity is shrunk, though only one component of it changes.",
            "v = eu",
            (("restitution", "M0"), ("speed", "M0")),
        ),
        Misconception(
            "restitution-inverted",
            "Restitution upside down",
            ("restitution",),
            ("restitution",),
            "e is put on the side of the separation.",
            "The bodies separate faster than they approached: energy comes from nothing.",
            "e(w − v) = speed of approach",
            (("restitution", "M0"),),
        ),
        Misconception(
            "restitution-omitted",
            "Restitution without e",
            ("restitution",),
            ("restitution",),
            "e is left out.",
            "The impact is perfectly elastic, whatever e is, and no energy is lost.",
            "v sin β = u sin α",
            (("restitution", "M0"),),
        ),
        Misconception(
            "momentum-sign",
            "A sign in momentum",
            ("momentum",),
            ("momentum",),
            "A momentum against the positive sense is given a plus sign, or another sign is lost.",
            "Momentum is not conserved; the spheres often pass through each other.",
            "2 × 3 + 3 × 4 = 2v + 3w, where the second moves the other way",
            (("momentum", "M1 A0"),),
        ),
        Misconception(
            "restitution-sign",
            "A sign in restitution",
            ("restitution",),
            ("restitution",),
            "A component against the positive sense is given the wrong sign in Newton's law.",
            "The speed of approach or of separation is a difference where it is a sum, or the "
            "other way round.",
            "w + v = e(3 − 4)",
            (("restitution", "M1 A0"),),
        ),
        Misconception(
            "impulse-sign",
            "A sign in the impulse",
            ("impulse",),
            ("impulse",),
            "The sign of the reversed component is lost: sizes are subtracted, not added.",
            "The impulse comes out as (1 − e)mu sin α in place of (1 + e)mu sin α.",
            "I = m(u sin α − v sin β)",
            (("impulse", "M1 A0"),),
            world="result",
        ),
        Misconception(
            "speed-for-component",
            "Speeds in place of components",
            ("momentum", "restitution", "impulse"),
            ("momentum", "restitution", "impulse"),
            "The velocities are not resolved: whole speeds stand where components belong.",
            "The oblique impact is treated as a direct one.",
            "mu = mv + 2mw, with the whole speed u",
            (("momentum", "M0"), ("restitution", "M0"), ("impulse", "M0")),
            "Not resolved.",
        ),
        Misconception(
            "sine-cosine",
            "Sine and cosine exchanged",
            ("momentum", "restitution", "unchanged"),
            ("momentum", "restitution", "unchanged"),
            "Sine stands for cosine, or the component across for the one along.",
            "The wrong component is the one that the impact changes.",
            "v sin β = eu cos α",
            (
                ("momentum", "M1 A0"),
                ("restitution", "M1 A0"),
                ("unchanged", "B0"),
                ("impulse", "M1 A0"),
            ),
            "In Newton's law M1 only if momentum has the same exchange; at a wall only if the "
            "parallel component has it too.",
        ),
        Misconception(
            "angle-from-normal",
            "The angle taken from the wrong line",
            ("momentum", "restitution", "unchanged"),
            ("momentum", "restitution", "unchanged"),
            "The angle is measured from the normal, where it is given to the wall, or from the "
            "perpendicular in place of the line of centres.",
            "Sine and cosine are exchanged in every line.",
            "v cos β = u sin α and v sin β = eu cos α",
            (("momentum", "M1 A0"), ("restitution", "M1 A0"), ("unchanged", "B0")),
            "As for sine and cosine exchanged.",
        ),
        Misconception(
            "across-exchanged",
            "Components across exchanged",
            ("unchanged",),
            ("unchanged",),
            "The spheres exchange their components across the line of centres.",
            "Each sphere has a component that only an impulse across the line could give it.",
            "A keeps the component of B",
            (("unchanged", "B0"),),
        ),
        Misconception(
            "across-changed",
            "The component across changed",
            ("unchanged",),
            ("unchanged",),
            "The component that stays is multiplied by e, left out, or replaced by the other one.",
            "The contact acts as if it were rough.",
            "component parallel to the wall after = eu cos α",
            (("unchanged", "B0"),),
        ),
        Misconception(
            "mass-omitted",
            "Masses left out",
            ("momentum", "energy"),
            ("momentum", "energy"),
            "The masses are left out though they differ.",
            "Velocities are conserved in place of momentum.",
            "u = v + w",
            (("momentum", "M0"), ("energy", "M0"), ("impulse", "M0")),
            "A common factor cancelled is right.",
        ),
        Misconception(
            "masses-exchanged",
            "Masses exchanged",
            ("momentum",),
            ("momentum",),
            "Each sphere's velocity is multiplied by the mass of the other.",
            "The lighter sphere behaves as the heavier one.",
            "3 × 2 + 2 × 1 = 3v + 2w, for masses 2 and 3",
            (("momentum", "M0"), ("impulse", "M0")),
        ),
        Misconception(
            "energy-of-difference",
            "The square of a difference",
            ("energy",),
            ("energy",),
            "The loss is taken as ½m(v − u)², the square of a difference in place of the "
            "difference of squares.",
            "The loss is too large wherever a component is reversed.",
            "loss = ½m(v − u)²",
            (("energy", "M0"),),
            world="result",
        ),
        Misconception(
            "energy-one-sphere",
            "One sphere's energy alone",
            ("energy",),
            ("energy",),
            "Only one sphere's change of energy is counted.",
            "What the other sphere gains or loses is missing.",
            "loss = ½m₁u² − ½m₁v²",
            (("energy", "M0"),),
            world="result",
        ),
        Misconception(
            "energy-fraction-of-line",
            "A fraction of the wrong energy",
            ("energy",),
            ("energy", "fraction"),
            "The loss is divided by the energy of the components along the line of centres alone.",
            "The fraction is too large.",
            "fraction lost = loss/(½m(u cos α)²)",
            (("energy", "M1 A0"), ("fraction", "M1 A0")),
            world="result",
        ),
        Misconception(
            "energy-component-missing",
            "A component missing in the energy",
            ("energy",),
            ("energy",),
            "The energy is taken from one component alone, on one side only.",
            "The component that stays seems to be lost.",
            "loss = ½mu² − ½m(v sin β)²",
            (("energy", "M0"),),
            "A loss from the components along the line on both sides is right.",
            "result",
        ),
        Misconception(
            "energy-ratio-as-speed",
            "Speeds in the ratio of energies",
            ("fact",),
            ("fact", "energy", "speed"),
            "The ratio of the energies is taken for that of the speeds.",
            "Half the energy becomes half the speed, which is a quarter of the energy.",
            "v = ½u, for half the energy",
            (("fact", "M0"), ("energy", "M0"), ("speed", "M0")),
            world="result",
        ),
        Misconception(
            "energy-conserved",
            "Energy taken as conserved",
            ("restitution",),
            ("restitution", "energy"),
            "Kinetic energy is conserved in place of Newton's law.",
            "The impact is perfectly elastic, whatever e is.",
            "½mu² = ½mv² + ½mw²",
            (("restitution", "M0"), ("energy", "M0")),
        ),
        Misconception(
            "energy-no-half",
            "The half left out",
            ("energy",),
            ("energy",),
            "The half of ½mv² is left out.",
            "Energies are twice what they are; a ratio is right if it is left out everywhere.",
            "loss = mu² − ½mv²",
            (("energy", "M1 A0"),),
            world="result",
        ),
        Misconception(
            "square-not-taken",
            "A square left out",
            ("energy", "speed"),
            ("energy", "speed"),
            "One term is not squared.",
            "The sizes of the terms do not fit each other.",
            "v² = u²(cos² α + e sin² α)",
            (("energy", "M1 A0"), ("speed", "M1 A0")),
            world="result",
        ),
        Misconception(
            "impulse-of-speeds",
            "Impulse from speeds",
            ("impulse",),
            ("impulse",),
            "The impulse is mass × (difference or sum of the speeds).",
            "A velocity that only turns would need no impulse.",
            "I = m(v − u), with speeds",
            (("impulse", "M0"),),
            world="result",
        ),
        Misconception(
            "second-wall-angle",
            "The old angle at the second wall",
            ("angle",),
            ("angle", "restitution", "unchanged"),
            "At a second wall the angle with the first wall is used again.",
            "The path between the walls has two directions at once.",
            "at BC: angle = β, in place of 120° − β",
            (("angle", "M0"), ("restitution", "M1 A0"), ("unchanged", "M1 A0")),
        ),
        Misconception(
            "rounding-early",
            "Rounded too early",
            (),
            ("arithmetic",),
            "Values were rounded to two figures before the end.",
            "The answer is off in its third figure.",
            "v = 1.7, so …",
            (("arithmetic", "A0"),),
            "The last A is lost.",
            "none",
        ),
    )
}

SLIPS: Mapping[str, Slip] = {
    slip.id: slip
    for slip in (
        Slip("sign", "A sign", "One sign is wrong."),
        Slip("arithmetic", "Arithmetic", "The numbers do not give this value."),
        Slip(
            "algebra",
            "Algebra",
            "A sign, a term, a factor or a power is another than before rearranging.",
        ),
        Slip("misread", "Misread", "One datum of the question was replaced by another."),
        Slip("calculator", "Calculator", "The calculator was set to radians."),
        Slip("root", "The other root", "The other sign of a root was taken."),
        Slip("copied", "Copied", "The line differs from an earlier one by a sign or a digit."),
    )
}


def mistake_id(name: str) -> str:
    """The id of a misconception, of one of its variants or of a slip, from its id or its title.

    Case, spaces and hyphens make no difference. Raises StatementError for one that is not there,
    with the nearest one, or with all.
    """
    base, stroke, number = name.partition("/")
    ids = _ids()
    plain = _plain(base)
    if plain not in ids:
        near = get_close_matches(plain, ids, 1)
        hint = f"did you mean {ids[near[0]]}?" if near else f"there are {', '.join(MISCONCEPTIONS)}"
        raise StatementError(f"there is no mistake '{base[:40]}': {hint}")
    return f"{ids[plain]}{stroke}{number}"


@cache
def _ids() -> dict[str, str]:
    """The ids of all mistakes by ids and titles in small letters without spaces."""
    records: tuple[Misconception | Slip, ...] = (*MISCONCEPTIONS.values(), *SLIPS.values())
    return {_plain(name): record.id for record in records for name in (record.id, record.title)}


def _plain(name: str) -> str:
    return "".join(filter(str.isalnum, name)).lower()


def misconception(name: str) -> Misconception:
    """A misconception by its id or title, or that of one of its variants.

    Raises StatementError for one that is not there.
    """
    name = mistake_id(name)
    base = name.partition("/")[0]
    if base in SLIPS:
        raise StatementError(f"'{base}' is a slip, which has no world of its own")
    record = MISCONCEPTIONS[base]
    if name != base and all(variant.id != name for variant in record.variants):
        count = len(record.variants)
        known = f"its variants are {base}/1 to {base}/{count}" if count else "it has no variants"
        raise StatementError(f"there is no mistake '{name}': {known}")
    return record


def alteration(id_: str) -> Alteration:
    """A variant by its id, such as ``momentum-sign/2``. Raises KeyError for one not there."""
    mistake = id_.partition("/")[0]
    return next(variant for variant in MISCONCEPTIONS[mistake].variants if variant.id == id_)


def variants_at(event: Event, events: Iterable[Event] = ()) -> tuple[VariantAt, ...]:
    """The variants of all misconceptions at an impact, as trees, in the order of the table.

    ``events`` are those of the story: without them, variants that speak of the wall before are
    left out. None are returned for an event that is no impact.
    """
    if event.kind != "impact":
        return ()
    return _variants_at(event, _last_wall(event, events))


def laws_at(event: Event) -> tuple[LawAt, ...]:
    """The true laws of an impact, in the form in which variants replace them."""
    if event.kind != "impact":
        return ()
    unchanged = RECORDS["unchanged"]
    kept = tuple(
        LawAt("unchanged", (body,), unchanged.relations(event, (body,))[0])
        for body in (event.bodies[:1] if event.wall else event.bodies)
    )
    if event.wall:
        (relation,) = RECORDS["restitution-wall"].relations(event, event.bodies[:1])
        return (*kept, LawAt("restitution", event.bodies[:1], relation))
    laws: tuple[LawName, ...] = ("momentum", "restitution")
    of_both = (LawAt(law, event.bodies, RECORDS[law].relations(event, ())[0]) for law in laws)
    return (*kept, *of_both)


def variant_at(wanted: Alteration, event: Event, events: Iterable[Event] = ()) -> VariantAt | None:
    """One variant at an event; None where it does not apply to an event of this kind."""
    variants = variants_at(event, events)
    return next((variant for variant in variants if variant.alteration is wanted), None)


def _last_wall(event: Event, events: Iterable[Event]) -> int | None:
    """The number of the impact with a wall that comes last before one with a wall."""
    mine = [
        other
        for other in events
        if other.number < event.number
        and event.bodies[0] in other.bodies
        and other.kind != "arrival"
    ]
    last = max(mine, key=lambda event: event.number, default=None)
    return last.number if last is not None and last.wall and event.wall else None


@cache
def _variants_at(event: Event, last_wall: int | None) -> tuple[VariantAt, ...]:
    variants = (
        _variant_at(variant, event, last_wall)
        for mistake in MISCONCEPTIONS.values()
        for variant in mistake.variants
    )
    return tuple(variant for variant in variants if variant is not None)


def _variant_at(variant: Alteration, event: Event, last_wall: int | None) -> VariantAt | None:
    if variant.where != "impact" and (variant.where == "wall") != event.wall:
        return None
    if variant.mistake == "second-wall-angle" and last_wall is None:
        return None
    spheres = event.bodies[:1] if event.wall else event.bodies
    names = dict(zip("FS", event.bodies, strict=False))

    def put(tree: Expression, body: str | None = None) -> Expression:
        own = names if body is None else {**names, "X": body}
        return _placed(tree, own, event.number, last_wall)

    laws = tuple(
        LawAt(
            law.law,
            spheres if law.body is None else (names[law.body],),
            _relation(law.template, put),
        )
        for law in variant.laws
    )
    results = tuple(
        ResultAt(
            put(_tree(result.quantity), body),
            put(_tree(result.template), body),
            put(_tree(result.sense), body) if result.sense else None,
        )
        for result in variant.results
        for body in (spheres if "(X, " in result.quantity else spheres[:1])
    )
    return VariantAt(
        variant, event, laws, results, tuple(put(_tree(text)) for text in variant.senses)
    )


def _relation(template: str, put: object) -> Relation:
    assert callable(put)
    (link,) = _read(template).only
    return Relation(((Link(put(link.left), link.sign, put(link.right)),),))


@cache
def _read(template: str) -> Relation:
    return read_relation(template, _BODIES)


@cache
def _tree(text: str) -> Expression:
    return read_tree(text, _BODIES)


def _placed(
    tree: Expression, names: Mapping[str, str], event: int, last_wall: int | None
) -> Expression:
    """A template at an event: 0 of a line of centres is the last wall, ``before`` before that."""

    def change(node: Expression) -> Expression:
        if isinstance(node, Name):
            return Name(names[node.name])
        if not isinstance(node, Quantity) or node.stage is None:
            return node
        if node.kind == "line_of_centres" and node.stage == 0:
            return replace(node, stage=last_wall)
        if node.stage == "before":
            return replace(node, stage=(last_wall or 1) - 1)
        assert isinstance(node.stage, int)
        return replace(node, stage=node.stage + event - 1)

    return rebuilt(tree, change)
