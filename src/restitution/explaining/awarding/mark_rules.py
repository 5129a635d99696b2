"""The table of mark rules: what a line earns, by its move, record and conditions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from functools import lru_cache

from restitution.explaining.lines.derivation import MoveId, Note, NoteKind
from restitution.explaining.lines.marks import Mark, Marks, Style, reasoned
from restitution.records import dataclass


@dataclass(frozen=True)
class Rule:
    """What a kind of line earns.

    ``moves`` and ``records`` are those of the line (none: any), ``when`` names the conditions of
    `CONDITIONS` that hold there. ``points`` are M, A and B, and V for an A that belongs to the
    value: it stands on the line that simplifies this one, if there is such a line. U is an A for
    the unknown of an equation, where a line below solves that for it. ``others`` are the points in
    styles that differ.
    """

    name: str
    moves: frozenset[MoveId]
    records: frozenset[str] = frozenset()
    when: tuple[str, ...] = ()
    points: str = ""
    others: Mapping[Style, str] = field(default_factory=dict)

    def earned(self, style: Style) -> str:
        """The points in a style."""
        return self.others.get(style, self.points)


def _rule(
    name: str,
    moves: tuple[MoveId, ...],
    points: str,
    records: tuple[str, ...] = (),
    when: tuple[str, ...] = (),
    m4: str | None = None,
    caie: str | None = None,
) -> Rule:
    styles: tuple[tuple[Style, str | None], ...] = (("m4", m4), ("caie", caie))
    others = {style: own for style, own in styles if own is not None}
    return Rule(name, frozenset(moves), frozenset(records), when, points, others)


PAIR = ("momentum", "restitution")


_VECTORS = (
    "momentum-vector",
    "impulse-vector",
    "opposite-impulses",
    "across-the-impulse",
    "impulse-direction",
    "along-the-change",
    "changed-velocity",
    "equal-across",
)


_CLOSING = (
    "tan",
    "tan-squared",
    "tan-direction",
    "tan-deflection",
    "tan-from-axis",
    "perpendicular",
    "parallel",
    "sum",
)


ENERGIES = (
    "energy",
    "energy-ratio",
    "energy-lost",
    "energy-change",
    "total",
    "total-lost",
    "difference",
)


STAYS_ZERO = "component-that-stays-zero"
"""The rule of a component that an impact leaves at nothing."""


RULES: tuple[Rule, ...] = (
    # Principles. What an earlier part has used at the same impact is no method again.
    _rule("repeated", ("law",), "", when=("repeated",)),
    _rule(STAYS_ZERO, ("law",), "", ("unchanged",), ("zero",)),
    _rule("coefficient-sought", ("law",), "M A", ("restitution-wall",), ("sought",)),
    _rule(
        "component-at-a-wall", ("law",), "B", ("unchanged", "restitution-wall"), ("wall",), m4="M A"
    ),
    _rule("first-component-unchanged", ("law",), "B", ("unchanged",), ("first-at-event",)),
    _rule("component-unchanged", ("law",), "", ("unchanged",)),
    _rule("one-of-two-alone", ("law",), "M A", PAIR, ("alone",)),
    _rule("first-of-two", ("law",), "M A", PAIR, ("first-of-several",), caie="M"),
    _rule("second-of-two", ("law",), "M A", PAIR, ("second-of-several",)),
    _rule("impulse", ("law",), "M V", ("impulse",)),
    _rule("opposite-impulse", ("law",), "", ("opposite-impulses",), ("of-an-impulse",)),
    _rule("another-changed", ("law",), "", ("changed-velocity",), ("another-assembled",)),
    _rule("principle-of-vectors", ("law",), "M V", _VECTORS),
    # Solving.
    _rule("put-in-together", ("combine",), "M", when=("of-laws", "first", "unknowns"), caie=""),
    _rule("solved-together", ("combine",), "M A", when=("of-laws", "first"), caie=""),
    _rule("solved-by-putting", ("put",), "M A", when=("of-laws", "first", "of-a-letter"), caie=""),
    _rule("put-together-with-a-law", ("put",), "M", when=("of-laws", "first"), caie=""),
    _rule("two-values-of-a-letter", ("put",), "M", when=("of-one-letter",)),
    _rule("another-value", ("combine",), "A", when=("of-laws", "another")),
    _rule("another-value-later", ("put",), "M", when=("of-laws", "another", "of-an-earlier-part")),
    _rule("another-value-put-in", ("put",), "A", when=("of-laws", "another", "of-a-letter")),
    _rule("solved-again", ("combine",), "", when=("of-laws",)),
    _rule("unknowns-of-equations", ("solve",), "M A"),
    _rule("equations-joined", ("combine", "divide", "square-add"), "M"),
    _rule("complement-that-is-given", ("identity",), "M", ("complement",), ("fact-of-motion",)),
    _rule("complement-of-the-data", ("identity",), "", ("complement",), ("of-facts",)),
    _rule("identity-again", ("identity",), "A", when=("on-the-way", "identity-again")),
    _rule("identity", ("identity",), "M", when=("on-the-way",)),
    _rule("square-root", ("roots",), "", when=("opposite",)),
    _rule("roots", ("roots",), "M"),
    _rule("reason-for-a-root", ("reject",), "B", when=("justified",)),
    # Vectors and their components.
    _rule("component-with-a-letter", ("define",), "", ("component",), ("by-its-letter",)),
    _rule("component-of-nothing", ("define",), "", ("component",), ("zero",)),
    _rule("component-of-two-terms", ("define",), "M A", ("component",), ("resolved-again",)),
    _rule("component-alone", ("define",), "B", ("component",), ("alone",)),
    _rule("component-read-off", ("define",), "B", ("component",), ("read-off", "first-of-several")),
    _rule("further-component-read-off", ("define",), "", ("component",), ("read-off",)),
    _rule("first-scalar-product", ("define",), "M", ("component",), ("first-of-several",)),
    _rule("last-scalar-product", ("define",), "A", ("component",), ("last-of-several",)),
    _rule("given-speed", ("define",), "M", ("speed", "size"), ("of-one-term", "an-equation")),
    _rule("read-off", ("define",), "", ("assemble", "speed", "size"), ("of-one-term",)),
    _rule("for-an-angle", ("define",), "", ("speed", "size"), ("on-the-way", "for-an-angle")),
    _rule(
        "another-that-is-asked",  # its end has the A
        ("define",),
        "",
        ("assemble",),
        ("on-the-way", "another-assembled", "asked"),
    ),
    _rule(
        "another-put-together", ("define",), "V", ("assemble",), ("on-the-way", "another-assembled")
    ),
    _rule("put-together", ("define",), "M", ("assemble", "speed", "size"), ("on-the-way",)),
    _rule("velocity-in-components", ("define",), "", ("assemble", "relative-velocity")),
    _rule("velocity-by-size-and-direction", ("define",), "M", ("turned",), ("asked",)),
    # Facts closed into equations, and what is asked.
    _rule("sine-of-an-offset", ("define",), "M A", ("scalar-angle",), ("of-an-offset", "of-facts")),
    _rule("angle-of-the-data", ("define",), "", ("scalar-angle",), ("of-facts", "of-a-number")),
    _rule("distance-restated", ("define",), "", ("distance",), ("restated",)),
    _rule("distance-at-rest", ("define",), "B", ("distance",), ("distance-at-rest",)),
    _rule("distance-at-another-time", ("define",), "", ("distance",), ("another-time",)),
    _rule("product-read-off", ("define",), "", ("product",), ("of-one-component",)),
    _rule("another-speed", ("define",), "V", ("speed",), ("like-one-above",)),
    _rule(
        "speed-size-angle-distance",
        ("define",),
        "M V",
        ("speed", "size", "scalar-angle", "distance", "product", "momentum-of"),
    ),
    _rule(
        "condition-on-one-component", ("define",), "B", ("perpendicular", "parallel"), ("at-sight",)
    ),
    _rule("right-angle-by-a-product", ("define",), "", ("perpendicular",), ("product-above",)),
    _rule("direction-read-off", ("define",), "", ("parallel",), ("a-direction",)),
    _rule("direction-of-the-data", ("define",), "", ("difference",), ("a-direction", "at-once")),
    _rule("direction-by-a-difference", ("define",), "M", ("difference",), ("a-direction",)),
    _rule("same-angle", ("define",), "", ("difference",), ("an-angle-for-another",)),
    _rule("angle-seen", ("define",), "", ("parallel", "perpendicular"), ("an-angle-to-a-line",)),
    _rule("condition", ("define",), "M U", _CLOSING, m4="M A"),
    _rule(
        "difference-of-angles",
        ("define",),
        "",
        ("difference",),
        ("of-angles", "in-letters", "on-the-way"),
    ),
    _rule("angle-read-off", ("define",), "", ("difference",), ("of-angles", "at-once")),
    _rule("angle-by-a-difference", ("define",), "M", ("difference",), ("of-angles",)),
    _rule("time-of-no-way", ("define",), "", ("straight-line",), ("zero", "time")),
    _rule("place-at-rest", ("define",), "", ("straight-line",), ("at-rest", "on-the-way")),
    _rule("place-at-rest-asked", ("define",), "B", ("straight-line",), ("at-rest",)),
    _rule("place-in-an-open-time", ("define",), "", ("straight-line",), ("open-place",)),
    _rule(
        "place-by-a-path-on-the-way",
        ("define",),
        "M V",
        ("straight-line",),
        ("place-of-facts", "goes-on"),
    ),
    _rule("place-by-a-path", ("define",), "M", ("straight-line",), ("place-of-facts",)),
    _rule(
        "place-on-an-axis", ("define",), "", ("straight-line",), ("zero", "on-the-way", "at-once")
    ),
    _rule(
        "time-by-the-data", ("define",), "B", ("straight-line",), ("of-facts", "time", "on-the-way")
    ),
    _rule("place-by-the-data", ("define",), "", ("straight-line",), ("of-facts", "a-place")),
    _rule("energy-lost-by-the-data", ("define",), "M A", ("energy-lost",), ("of-facts",)),
    _rule("share-by-the-data", ("define",), "M", ("energy-ratio",), ("of-facts", "on-the-way")),
    _rule("share-asked-by-the-data", ("define",), "M A", ("energy-ratio",), ("of-facts",)),
    _rule("share-by-other-shares", ("define",), "", ("energy-ratio",), ("of-shares",)),
    _rule("data", ("define",), "", ENERGIES, ("of-facts", "on-the-way")),
    _rule("place-on-the-way", ("define",), "M V", ("straight-line",), ("goes-on",)),
    _rule("time-or-place", ("define",), "M", ("straight-line",)),
    _rule("times-put-together", ("put",), "A", when=("times-together", "on-the-way")),
    _rule("centres-by-a-path", ("law",), "M", ("moves-off",)),
    _rule("centres-two-radii-apart", ("define",), "A", ("beside",)),
    _rule("chord-again", ("define",), "", ("chord",), ("another-chord",)),
    _rule("chord", ("define",), "M", ("chord",)),
    _rule("angles-round-a-circle", ("define",), "M", ("round",)),
    _rule("share-of-what-is-given", ("put",), "M", when=("share-of-the-data",)),
    _rule("energy-of-all", ("define",), "", ("total",), ("of-one-body",)),
    _rule("energy-that-goes-on", ("define",), "M", ENERGIES, ("inline",)),
    _rule("another-energy", ("define",), "V", ("energy",), ("alone", "like-one-above")),
    _rule("energy", ("define",), "M A", ENERGIES, ("alone",)),
    _rule("first-of-several-energies", ("define",), "M", ENERGIES, ("first-of-several",)),
    _rule("second-of-several-energies", ("define",), "A", ENERGIES, ("second-of-several",)),
    # Inequalities, ranges and greatest values.
    _rule(
        "condition-as-inequality",
        ("sign", "put", "fact", "compare"),
        "M",
        when=("new-inequality", "on-the-way"),
    ),
    _rule("tangent-to-be-bounded", ("put",), "A", when=("of-a-sum", "on-the-way")),
    _rule("bounds", ("monotone", "complete"), "M"),
    _rule("bound-that-is-approached", ("compare",), "M", when=("approached",)),
    _rule("comparison", ("sign", "compare"), "M", when=("claim-without-method",)),
    _rule("value-that-is-given", ("fact",), "B", when=("given-as-asked", "fact-of-motion")),
    _rule("given-fact", ("put", "fact", "rearrange"), "M", when=("fact-of-motion",)),
    _rule("centres-beside-a-path", ("fact",), "M A", when=("of-an-offset",)),
    _rule("centres-between-places", ("put",), "M V", when=("between-places",)),
    _rule("place-of-a-contact", ("fact",), "M A", when=("of-a-contact", "of-facts")),
    _rule("equation-of-a-contact", ("fact",), "M", when=("of-a-contact",)),
)
"""The table. A line that no rule fits earns nothing by itself."""


@lru_cache(maxsize=1024)
def rules_of(move: MoveId, record: str | None) -> tuple[Rule, ...]:
    """The rules of the table for a move and a record, in its order."""
    return tuple(
        rule for rule in RULES if move in rule.moves and record in (rule.records or {record})
    )


CONCLUDING: frozenset[NoteKind] = frozenset({"impossible", "contradiction", "missing"})
"""Notes that end an item: it has no answer, and that is what there is to conclude."""


def marks_of_note(note: Note, of_the_end: Marks = ()) -> Marks:
    """What a note earns: a counter-example a method, and that the claim is not true the answer.

    Of an equation it is enough that a line above says another value. Where there is no answer, the
    conclusion has the mark ``of_the_end``, which a value would have, or else one of its own; what
    the data show without a line has none. Steps that are not written out have no line at which
    marks could stand.
    """
    equation = note.claim is not None and {e.sign for e in note.claim.options[0]} == {"="}
    if note.kind == "refuted" and note.instance and not equation:
        return (reasoned(Mark("M")), reasoned(Mark("A")))
    if note.kind in CONCLUDING and of_the_end:
        return of_the_end
    concluding = note.kind in CONCLUDING or note.kind in ("standing", "refuted")
    at_sight = note.kind == "impossible" and not note.lines and not note.premises
    return (reasoned(Mark("B")),) if concluding and not at_sight else ()


UNWRITTEN: Marks = (reasoned(Mark("M")), reasoned(Mark("A")))
"""What a student earns by a method that the working does not write out, and by its answer."""
