"""The quantities of the language: how each is written, what it is, and what measures it.

One record a quantity: the grammar, the help, the completion of the page, the dimensions and the
units are read from it. How it is worked out from a story stands in ``solving.story.quantities``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Literal

from restitution.expression.dimensions import (
    ENERGY,
    IMPULSE,
    LENGTH,
    MASS,
    NONE,
    SPEED,
    TIME,
    Dimension,
    times,
)
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    Stage,
    has_quantity,
    letters,
)
from restitution.records import dataclass

Nature = Literal["scalar", "vector", "angle"]
Definition = Callable[[tuple[Expression, ...], Stage, Stage], Expression | None]
"""By its arguments, the stage before the event of which it is and that after it."""


@dataclass(frozen=True)
class Kind:
    """A kind of quantity.

    ``usage`` is how it is written, ``about`` what it is in a few words, ``arguments`` the fewest
    and the most that it takes. ``nature`` is what its value is, and ``alone`` what it is without
    arguments where that is another. ``dimension`` is None where the arguments give it.

    A ``staged`` quantity takes the number of an event, or with ``before`` that word, or with
    ``at_time`` a time; with ``stage_needed`` it cannot do without. One ``of_an_event`` has none
    at the start. A ``signed`` angle has a sense. ``names`` are the bodies whose names may be
    arguments. ``in_statements`` is False where only the lines of a working speak of it.

    ``noun`` is what people call it, of one body, and ``nouns`` of several; ``short`` among
    mathematics, where that is another; ``link`` is the word before its bodies, and ``of_all`` what
    it is called without. ``letters``
    are those that people take for it, in the order in which they do.

    ``definition`` says it by other quantities: as it is read these take its place, so nothing else
    has to know it. It gives None where it is no other.
    """

    word: str
    about: str
    usage: str
    arguments: tuple[int, int]
    nature: Nature
    dimension: Dimension | None
    alone: Nature | None = None
    staged: bool = False
    before: bool = False
    signed: bool = False
    at_time: bool = False
    stage_needed: bool = False
    of_an_event: bool = False
    names: frozenset[str] = frozenset({"sphere"})
    in_statements: bool = True
    noun: str = ""
    nouns: str = ""
    short: str = ""
    link: str = "of"
    of_all: str = ""
    letters: tuple[str, ...] = ()
    definition: Definition | None = None

    def called(self, number: int = 1) -> str:
        """What it is called, of so many bodies."""
        one = self.noun or self.word.replace("_", " ")
        return one if number == 1 else self.nouns or f"{one}s"

    @property
    def in_formulas(self) -> str:
        """What it is called among mathematics, with the word before its bodies."""
        return f"{self.short or self.called()} {self.link}"

    @property
    def called_of_all(self) -> str:
        """What it is called without a body."""
        return self.of_all or self.word.replace("_", " ")

    @property
    def stands_alone(self) -> bool:
        """Whether it may be written without arguments."""
        return self.arguments[0] == 0 and not self.stage_needed

    def written_out(
        self, arguments: tuple[Expression, ...], stage: Stage, events: int
    ) -> Expression | None:
        """What it is by its definition, after some events; None where it has none."""
        if self.definition is None:
            return None
        if not self.of_an_event:
            return self.definition(arguments, stage, stage)
        if stage is None and arguments:
            return self.definition(arguments, "before", None)
        late = stage if isinstance(stage, int) else events
        return self.definition(arguments, late - 1, late)

    def nature_of(self, arguments: tuple[Expression, ...]) -> Nature:
        """What its value is, with these arguments."""
        return self.nature if arguments or self.alone is None else self.alone


def _energy_lost_by(bodies: tuple[Expression, ...], early: Stage, late: Stage) -> Expression | None:
    """What one body loses is the fall of its energy; what all lose is a quantity of its own."""
    if not bodies:
        return None
    return Binary("-", Quantity("energy", bodies, early), Quantity("energy", bodies, late))


KINDS: Mapping[str, Kind] = {
    kind.word: kind
    for kind in (
        Kind(
            "velocity",
            "the velocity, a vector",
            "velocity(A) or velocity(A, n)",
            (1, 1),
            "vector",
            SPEED,
            staged=True,
            before=True,
            nouns="velocities",
            letters=("v", "w"),
        ),
        Kind(
            "speed",
            "the size of the velocity",
            "speed(A) or speed(A, n)",
            (1, 1),
            "scalar",
            SPEED,
            staged=True,
            before=True,
            # In a working v and w are components along the line of centres.
            letters=("V", "U"),
        ),
        Kind(
            "direction",
            "the angle of the velocity from i",
            "direction(A) or direction(A, n)",
            (1, 1),
            "angle",
            NONE,
            staged=True,
            before=True,
            signed=True,
            names=frozenset({"sphere", "wall"}),
            noun="direction of motion",
            nouns="directions of motion",
            short="direction",
        ),
        Kind(
            "along",
            "the component of V along D",
            "along(V, D)",
            (2, 2),
            "scalar",
            None,
            names=frozenset({"wall"}),
            letters=("p", "q", "r", "s"),
        ),
        Kind(
            "across",
            "the component of V perpendicular to D",
            "across(V, D)",
            (2, 2),
            "scalar",
            None,
            names=frozenset({"wall"}),
            letters=("p", "q", "r", "s"),
        ),
        Kind(
            "angle",
            "the angle between two vectors or with a wall",
            "angle(X, Y)",
            (2, 2),
            "angle",
            NONE,
            names=frozenset({"wall"}),
            link="between",
            # Those that angles have in a working.
            letters=("beta", "theta", "phi", "psi", "gamma"),
        ),
        Kind(
            "deflection",
            "the angle of deflection in the latest event",
            "deflection(A) or deflection(A, n)",
            (1, 1),
            "angle",
            NONE,
            staged=True,
            of_an_event=True,
            noun="angle of deflection",
            nouns="angles of deflection",
            letters=("delta", "phi", "psi"),
        ),
        Kind(
            "impulse",
            "the size of the latest impulse; impulse(A) is a vector",
            "impulse, impulse(n), impulse(A) or impulse(A, n)",
            (0, 1),
            "vector",
            IMPULSE,
            alone="scalar",
            staged=True,
            of_an_event=True,
            link="on",
            of_all="magnitude of the impulse",
            letters=("I", "J", "Q"),
        ),
        Kind(
            "energy",
            "the kinetic energy of A, or of all spheres",
            "energy, energy(n), energy(A) or energy(A, n)",
            (0, 1),
            "scalar",
            ENERGY,
            staged=True,
            before=True,
            noun="kinetic energy",
            nouns="kinetic energies",
            of_all="total kinetic energy",
            letters=("E", "K"),
        ),
        Kind(
            "energy_lost",
            "the kinetic energy that A, or all spheres, lose in the latest event",
            "energy_lost, energy_lost(n), energy_lost(A) or energy_lost(A, n)",
            (0, 1),
            "scalar",
            ENERGY,
            staged=True,
            of_an_event=True,
            of_all="kinetic energy lost",
            letters=("L", "E", "K"),
            definition=_energy_lost_by,
        ),
        Kind(
            "total_energy_lost",
            "the kinetic energy lost since the start",
            "total_energy_lost",
            (0, 0),
            "scalar",
            ENERGY,
            staged=True,
            of_all="total kinetic energy lost",
            letters=("L", "E", "K"),
        ),
        Kind(
            "momentum",
            "the momentum of A, or of all spheres",
            "momentum, momentum(A) or momentum(A, n)",
            (0, 1),
            "vector",
            IMPULSE,
            staged=True,
            before=True,
            nouns="momenta",
            of_all="total momentum",
            letters=("p", "q"),
        ),
        Kind(
            "line_of_centres",
            "the unit vector along the line of centres",
            "line_of_centres or line_of_centres(n)",
            (0, 0),
            "vector",
            NONE,
            staged=True,
            of_an_event=True,
            letters=("n", "c"),
        ),
        Kind(
            "mass",
            "the mass of A",
            "mass(A)",
            (1, 1),
            "scalar",
            MASS,
            nouns="masses",
            letters=("m", "M"),
        ),
        Kind(
            "position",
            "where the centre of A is",
            "position(A), position(A, n) or position(A, at t)",
            (1, 1),
            "vector",
            LENGTH,
            staged=True,
            before=True,
            at_time=True,
            letters=("r", "s", "p"),
        ),
        Kind(
            "time",
            "the time of event n",
            "time(n)",
            (0, 0),
            "scalar",
            TIME,
            staged=True,
            stage_needed=True,
            of_an_event=True,
            letters=("T", "t"),
        ),
        Kind(
            "distance",
            "between points or centres",
            "distance(X, Y) or distance(A, B, at t)",
            (2, 2),
            "scalar",
            LENGTH,
            staged=True,
            at_time=True,
            names=frozenset({"sphere", "point"}),
            link="between",
            letters=("d", "D", "s", "h"),
        ),
        Kind(
            "dot",
            "the scalar product",
            "dot(V, W)",
            (2, 2),
            "scalar",
            None,
            names=frozenset(),
            letters=("p", "q", "k"),
        ),
        # A statement gives e with the impact.
        Kind(
            "restitution",
            "the coefficient of restitution of event n",
            "restitution(n)",
            (0, 0),
            "scalar",
            NONE,
            staged=True,
            stage_needed=True,
            in_statements=False,
        ),
    )
}


def _words(belongs: Callable[[Kind], bool]) -> frozenset[str]:
    return frozenset(word for word, kind in KINDS.items() if belongs(kind))


ANGLES = _words(lambda kind: kind.nature == "angle")
"""The kinds of quantities that are angles."""
UNSIGNED_ANGLES = _words(lambda kind: kind.nature == "angle" and not kind.signed)
"""Angles from 0 to 180°, which are the same in either sense."""
ENERGIES = _words(lambda kind: kind.dimension == ENERGY)
"""Energies and what is lost of them."""
LOSSES = _words(lambda kind: kind.dimension == ENERGY and not kind.before)
"""What is lost of energies."""
PLACED = _words(lambda kind: kind.dimension in (LENGTH, TIME))
"""Quantities of the way from one event to the next."""
CHANGED = _words(lambda kind: kind.before and kind.dimension not in (NONE, LENGTH))
"""Quantities that last from one event to the next, which changes how much they are."""
LASTING = _words(lambda kind: kind.before and kind.dimension != LENGTH)
"""Quantities of a body that are the same after an event in which it took no part."""

# The words that a statement may hold.
QUANTITIES = tuple(word for word, kind in KINDS.items() if kind.in_statements)


def is_vector_quantity(quantity: Quantity) -> bool:
    """Whether a quantity is a vector, with the arguments that it has."""
    kind = KINDS.get(quantity.kind)
    return kind is not None and kind.nature_of(quantity.arguments) == "vector"


_NOTHING: Mapping[str, Dimension] = {}


def dimension_of(
    tree: Expression, of_letters: Mapping[str, Dimension] = _NOTHING
) -> Dimension | None:
    """The dimension of an expression of quantities; None where its quantities do not tell it.

    ``of_letters`` are the dimensions of the letters for which they are known.
    """
    match tree:
        case Quantity(kind, arguments):
            if kind in COMPONENTS:
                return dimension_of(arguments[0], of_letters)
            if kind == "dot":
                first, second = (dimension_of(argument, of_letters) for argument in arguments)
                return times(first, second, 1)
            return KINDS[kind].dimension if kind in KINDS else NONE
        case Letter(name) if name in of_letters:
            return of_letters[name]
        case Apply("abs", argument):
            return dimension_of(argument, of_letters)
        case Apply("sqrt", _):
            return None
        case Negate(operand):
            return dimension_of(operand, of_letters)
        case Binary("+" | "-", left, right):
            return dimension_of_any((left, right), of_letters)
        case Binary("*" | "/" as op, left, right):
            first, second = dimension_of(left, of_letters), dimension_of(right, of_letters)
            return times(first, second, 1 if op == "*" else -1)
        case Binary("^", base, Number(exponent)) if exponent.denominator == 1:
            dimension = dimension_of(base, of_letters)
            if dimension is None:
                return None
            a, b, c = dimension
            power = int(exponent)
            return (a * power, b * power, c * power)
    return None if letters(tree) else NONE


def dimension_of_any(
    operands: Iterable[Expression], of_letters: Mapping[str, Dimension] = _NOTHING
) -> Dimension | None:
    """The dimension of the first operand whose quantities, or known letters, tell it."""
    for operand in operands:
        if has_quantity(operand) or letters(operand) & of_letters.keys():
            dimension = dimension_of(operand, of_letters)
            if dimension is not None:
                return dimension
    return None
