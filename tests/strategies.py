"""Hypothesis strategies for everything that can be stated: expressions, relations, problems."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, partial, wraps
from typing import Any

import sympy
from hypothesis import assume
from hypothesis import strategies as st
from plain_physics import ImpossibleWorldError, World, value_of
from plain_physics import number as precise

from restitution import problem as p
from restitution.drawing import scene as scenes
from restitution.expression.quantities import KINDS
from restitution.expression.tree import (
    FUNCTIONS,
    Apply,
    AtTime,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Pi,
    Polar,
    Quantity,
    Unit,
)
from restitution.language import parse
from restitution.motion import Table, polygon
from restitution.render import layout
from restitution.vector import Vector


def once(make: Callable[..., st.SearchStrategy[Any]]) -> Callable[..., st.SearchStrategy[Any]]:
    """Make a strategy once for each choice of arguments, and not before it is used.

    The strategies below are built one upon another: made anew at each use they would be huge,
    and so would be what Hypothesis prints of them.
    """
    made = cache(make)

    @cache
    @wraps(make)
    def named(*args: Any, **kwargs: Any) -> st.SearchStrategy[Any]:
        @st.composite
        def drawn(draw: st.DrawFn) -> Any:
            return draw(made(*args, **kwargs))

        return drawn()

    return named


SPHERES = ("A", "B", "C", "P1")
WALLS = ("W", "OX")
POINTS = ("N", "O")
NAMES = {
    **dict.fromkeys(SPHERES, "sphere"),
    **dict.fromkeys(WALLS, "wall"),
    **dict.fromkeys(POINTS, "point"),
}
LETTERS = ("u", "v", "m", "M", "e", "k", "s", "r", "d", "g", "e_1", "v_A", "m_12") + (
    "alpha",
    "theta",
    "lambda",
    "mu",
    "nu",
    "xi",
    "beta_2",
)

sphere_names = st.sampled_from(SPHERES)
wall_names = st.sampled_from(WALLS)
point_names = st.sampled_from(POINTS)
letter_names = st.sampled_from(LETTERS)


# --- numbers and scalars ----------------------------------------------------------------------


@once
def decimals() -> st.SearchStrategy[Fraction]:
    """Numbers as typed: whole, or with up to four places."""
    return st.builds(
        lambda n, places: Fraction(n, 10**places), st.integers(0, 99_999), st.integers(0, 4)
    )


@once
def numbers() -> st.SearchStrategy[Number]:
    """Exact numbers, never negative."""
    return st.builds(Number, decimals())


@once
def degrees() -> st.SearchStrategy[Degrees]:
    """Numbers of degrees, fractions without an end among them: ``1/3°``."""
    fractions = st.builds(Fraction, st.integers(1, 400), st.sampled_from([3, 7, 9, 12]))
    return st.builds(Degrees, st.one_of(decimals(), fractions))


@once
def angles() -> st.SearchStrategy[Expression]:
    """Angles: degrees, Greek letters, multiples of pi, and differences of these."""
    simple = st.one_of(
        degrees(),
        st.sampled_from([Letter("alpha"), Letter("theta"), Pi()]),
        st.builds(Binary, st.just("*"), numbers(), st.just(Letter("alpha"))),
    )
    return st.one_of(
        simple,
        st.builds(Negate, simple),
        st.builds(Binary, st.sampled_from("+-"), simple, simple),
        st.builds(lambda x: Apply("arctan", x), numbers()),
    )


@once
def scalars(events: int = 0, quantities: bool = False) -> st.SearchStrategy[Expression]:
    """Expressions of numbers and letters, and of quantities where these are wanted."""
    leaves: list[st.SearchStrategy[Any]] = [
        numbers(),
        degrees(),
        st.builds(Letter, letter_names),
        st.just(Pi()),
    ]
    if quantities:
        leaves.append(scalar_quantities(events))
    return st.recursive(st.one_of(leaves), _grown, max_leaves=10)


def _grown(inner: st.SearchStrategy[Expression]) -> st.SearchStrategy[Expression]:
    return st.one_of(
        st.builds(Negate, inner),
        st.builds(Binary, st.sampled_from("+-*/^"), inner, inner),
        st.builds(Apply, st.sampled_from(FUNCTIONS), inner),
        st.builds(
            lambda f, x, n: Binary("^", Apply(f, x), Number(Fraction(n))),
            st.sampled_from(FUNCTIONS),
            inner,
            st.integers(0, 9),
        ),
    )


# --- vectors and points -----------------------------------------------------------------------


@once
def vectors() -> st.SearchStrategy[Expression]:
    """Vectors by components, as pairs, and by size and direction."""
    part = scalars()
    along = st.builds(
        lambda x, unit: Binary("*", x, unit), part, st.sampled_from([Unit("i"), Unit("j")])
    )
    rectangular = st.one_of(
        along,
        st.sampled_from([Unit("i"), Unit("j")]),
        st.builds(Negate, along),
        st.builds(Binary, st.sampled_from("+-"), along, along),
    )
    pairs = st.builds(Pair, part, part)
    polar = st.one_of(
        st.builds(Polar, part, angles()),
        st.builds(Polar, part, angles(), rectangular),
        st.builds(
            lambda size, angle, wall: Polar(size, angle, None, Name(wall)),
            part,
            angles(),
            wall_names,
        ),
    )
    return st.one_of(
        rectangular, pairs, polar, st.builds(Binary, st.sampled_from("+-"), polar, pairs)
    )


@once
def points() -> st.SearchStrategy[Expression]:
    """Points by coordinates and by name."""
    return st.one_of(st.builds(Pair, scalars(), scalars()), st.builds(Name, point_names))


@once
def directions(events: int) -> st.SearchStrategy[Expression]:
    """Whatever has a direction: vectors, walls, lines of centres."""
    return st.one_of(vectors(), st.builds(Name, wall_names), vector_quantities(events))


# --- quantities -------------------------------------------------------------------------------


@once
def stages(events: int, first: int = 0) -> st.SearchStrategy[Any]:
    """A number of one of the events told, or now."""
    if events < first:
        return st.none()
    return st.one_of(st.none(), st.integers(first, events))


def _of_spheres(events: int, *, vectors: bool) -> list[st.SearchStrategy[Quantity]]:
    """Quantities of a sphere and of all, by their records: the vectors, or all others."""
    kinds: list[st.SearchStrategy[Quantity]] = []
    for kind in KINDS.values():
        if not kind.in_statements or kind.stage_needed:
            continue
        stage = stages(events, first=kind.of_an_event) if kind.staged else st.none()
        if kind.stands_alone and (kind.nature_of(()) == "vector") == vectors:
            numbered = stage if "(n)" in kind.usage else st.none()
            kinds.append(st.builds(partial(Quantity, kind.word, ()), numbered))
        body = (Name("A"),)
        is_own = kind.written_out(body, None, events) is None  # else it is read as another
        of_one = kind.arguments[1] == 1 and "sphere" in kind.names and is_own
        if of_one and (kind.nature == "vector") == vectors:
            further = [st.just("before")] if kind.before else []
            further += [st.builds(AtTime, scalars())] if kind.at_time else []
            bodies = st.tuples(st.builds(Name, sphere_names))
            kinds.append(
                st.builds(partial(Quantity, kind.word), bodies, st.one_of(stage, *further))
            )
    return kinds


@once
def vector_quantities(events: int) -> st.SearchStrategy[Quantity]:
    """Quantities that are vectors or points."""
    return st.one_of(
        *_of_spheres(events, vectors=True),
        st.builds(lambda name: Quantity("direction", (Name(name),)), wall_names),
    )


@once
def scalar_quantities(events: int) -> st.SearchStrategy[Quantity]:
    """Quantities that are numbers or angles."""
    now = stages(events)
    vector = st.one_of(vectors(), vector_quantities(events))
    direction = st.one_of(vector, angles(), st.builds(Name, wall_names))
    kinds = [
        *_of_spheres(events, vectors=False),
        *(
            st.builds(lambda v, d, kind=kind: Quantity(kind, (v, d)), vector, direction)
            for kind in ("along", "across", "angle")
        ),
        st.builds(lambda v, w: Quantity("dot", (v, w)), vector, vector),
        st.builds(
            lambda a, b, s: Quantity("distance", (Name(a), b), s),
            sphere_names,
            st.one_of(points(), st.builds(Name, sphere_names)),
            st.one_of(now, st.builds(AtTime, scalars())),
        ),
    ]
    if events:
        kinds.append(st.builds(partial(Quantity, "time", ()), st.integers(1, events)))
    return st.one_of(kinds)


@once
def expressions() -> st.SearchStrategy[Expression]:
    """Anything an expression may be."""
    return st.one_of(scalars(events=3, quantities=True), vectors(), vector_quantities(3), points())


# --- relations and items ----------------------------------------------------------------------


@once
def comparisons(events: int) -> st.SearchStrategy[p.Compare]:
    """Equations, inequalities and chains of them."""
    sides = scalars(events, quantities=True)
    chains = st.lists(
        st.tuples(st.sampled_from(["=", "<", "<=", ">", ">="]), sides), min_size=1, max_size=2
    )
    numeric = st.builds(
        lambda first, rest: p.Compare(
            (first, *(side for _, side in rest)), tuple(sign for sign, _ in rest)
        ),
        sides,
        chains,
    )
    vector = st.builds(
        lambda left, right: p.Compare((left, right), ("=",)), vector_quantities(events), vectors()
    )
    return st.one_of(numeric, vector)


@once
def relations(events: int) -> st.SearchStrategy[p.Relation]:
    """All that may stand after ``given``."""
    aligned = st.builds(
        p.Aligned,
        directions(events),
        st.sampled_from(["perpendicular to", "parallel to", "in the direction of", "opposite to"]),
        directions(events),
    )
    meets = st.builds(
        p.Meets,
        st.just(Name("A")),
        st.sampled_from([Name("B"), Name("W"), Name("P1")]),
        st.booleans(),
        st.booleans(),
    )
    at_rest = st.builds(lambda name: p.AtRest(Name(name)), sphere_names)
    return st.one_of(comparisons(events), aligned, at_rest, meets)


@once
def items(events: int) -> st.SearchStrategy[p.Item]:
    """All that may stand after ``find``."""
    value = st.one_of(scalars(events, quantities=True), vector_quantities(events))
    return st.one_of(
        st.builds(p.Value, value, st.booleans()),
        st.builds(p.Range, value, st.booleans()),
        st.builds(
            p.Extremum, st.sampled_from(["maximum", "minimum"]), value, scalars(), st.booleans()
        ),
    )


@once
def _terms() -> st.SearchStrategy[Any]:
    return st.one_of(
        st.none(), st.lists(letter_names, min_size=1, max_size=3, unique=True).map(tuple)
    )


@once
def shows(events: int) -> st.SearchStrategy[p.Show]:
    """Results to be derived, of each kind."""
    figured = st.builds(
        lambda left, right, figures: p.Compare((left, right), ("=",), figures),
        scalars(events, quantities=True),
        scalars(),
        st.one_of(st.none(), st.integers(1, 9)),
    )
    extremum = st.builds(
        lambda kind, q, x, value, terms: p.Show(
            p.Compare((q, value), ("=",)), p.Extremum(kind, q, x), terms
        ),
        st.sampled_from(["maximum", "minimum"]),
        scalars(events, quantities=True),
        st.builds(Letter, letter_names),
        scalars(),
        _terms(),
    )
    ranged = st.builds(
        lambda x, chain, terms: p.Show(chain, p.Range(x), terms),
        scalars(events, quantities=True),
        comparisons(events),
        _terms(),
    )
    plain = st.builds(
        lambda relation, terms: p.Show(relation, None, terms),
        st.one_of(relations(events), figured),
        _terms(),
    )
    return st.one_of(plain, ranged, extremum)


# --- whole problems ---------------------------------------------------------------------------


def _maybe(strategy: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    return st.one_of(st.none(), strategy)


@once
def spheres(name: str) -> st.SearchStrategy[p.Sphere]:
    """A sphere of which anything may be known."""
    rest = st.just(Pair(Number(Fraction(0)), Number(Fraction(0))))
    return st.builds(
        p.Sphere,
        st.just(name),
        _maybe(scalars()),
        _maybe(st.one_of(vectors(), rest)),
        _maybe(points()),
        _maybe(scalars()),
    )


@once
def walls(name: str) -> st.SearchStrategy[p.Wall]:
    """Walls of each kind."""
    return st.one_of(
        st.builds(
            lambda along, through: p.Wall(name, along=along, through=through),
            _maybe(st.one_of(vectors(), angles())),
            _maybe(points()),
        ),
        st.builds(lambda start, end: p.Wall(name, start=start, end=end), points(), points()),
        st.builds(lambda c, r: p.Wall(name, centre=c, radius=r), points(), scalars()),
    )


@once
def events_told() -> st.SearchStrategy[p.Event]:
    """Impacts with spheres and walls, blows, arrivals."""
    line = st.one_of(
        st.just({}),
        st.builds(lambda v: {"along": v}, st.one_of(vectors(), angles())),
        st.builds(lambda d: {"offset": d}, scalars()),
    )
    return st.one_of(
        st.builds(
            lambda second, e, rest: p.Impact("A", second, e, **rest),
            st.sampled_from(("B", "C", "P1")),
            _maybe(scalars()),
            line,
        ),
        st.builds(p.Impact, sphere_names, wall_names, _maybe(scalars())),
        st.builds(p.Kick, sphere_names, vectors()),
        st.builds(p.Arrival, sphere_names, st.one_of(points(), st.builds(Name, wall_names))),
    )


@once
def titles() -> st.SearchStrategy[str]:
    """Titles without control characters and idle blanks; ``#`` is no comment in them."""
    text = st.text(st.characters(codec="utf-8", exclude_categories=("C", "Z")), min_size=1)
    return (
        st.lists(text, min_size=1, max_size=4)
        .map(" ".join)
        .filter(lambda title: title.isprintable() and not title.endswith("\\"))
    )


@st.composite
def problems(draw: st.DrawFn) -> p.Problem:
    """Whole problems, of every line, property, quantity, relation and item."""
    told = draw(st.integers(0, 3))
    lets = iter(draw(st.permutations(LETTERS)))
    unused = list(lets)
    steps: list[p.Step] = []
    for _ in range(told):
        steps.append(draw(events_told()))
    for _ in range(draw(st.integers(0, 4))):
        step = draw(
            st.one_of(
                st.builds(
                    lambda value: p.Let(unused.pop(), value),
                    st.one_of(scalars(told, quantities=True), vector_quantities(told)),
                ),
                st.builds(
                    lambda facts: p.Given(tuple(facts)),
                    st.lists(relations(told), min_size=1, max_size=2),
                ),
                st.builds(
                    lambda letters: p.Unknown(tuple(letters)),
                    st.lists(letter_names, min_size=1, max_size=3, unique=True),
                ),
                st.builds(
                    lambda wanted, terms: p.Find(tuple(wanted), terms),
                    st.lists(items(told), min_size=1, max_size=2),
                    _terms(),
                ),
                shows(told),
            )
        )
        steps.insert(draw(st.integers(0, len(steps))), step)
    labels = draw(st.lists(st.sampled_from(("a", "b", "ii", "2")), max_size=2, unique=True))
    cuts = sorted(draw(st.integers(0, len(steps))) for _ in labels)
    ends = [*cuts, len(steps)]
    starts = [0, *cuts]
    parts = tuple(
        p.Part(label, tuple(steps[start:end]))
        for label, start, end in zip([None, *labels], starts, ends, strict=True)
    )
    return p.Problem(
        title=draw(_maybe(titles())),
        spheres=tuple(draw(spheres(name)) for name in SPHERES),
        walls=tuple(draw(walls(name)) for name in WALLS),
        points=tuple(p.Point(name, draw(points())) for name in POINTS),
        parts=parts,
    )


# --- stories that can happen, with their numbers ----------------------------------------------


@dataclass(frozen=True)
class Said:
    """A number or a vector: the words of the statement, and its value (a pair for a vector)."""

    text: str
    value: Any


@dataclass(frozen=True)
class Blow:
    """``first hits second``. ``along`` is the line of centres, or the direction of the wall.

    With an ``offset`` the value of ``along`` is not used. A text that is empty is left out.
    """

    first: str
    second: str
    e: Said
    along: Said
    offset: Said | None = None

    @property
    def wall(self) -> bool:
        return self.second.startswith("W")


@dataclass(frozen=True)
class Tale:
    """Spheres with masses and velocities, and impacts one after another; all radii are r."""

    masses: dict[str, Said]
    velocities: dict[str, Said]
    blows: tuple[Blow, ...]

    def statement(self, *lines: str) -> str:
        """The tale in the statement language, with further lines at its end."""
        told = []
        for name in self.velocities:
            mass = f"mass {self.masses[name].text}, " if self.masses[name].text else ""
            velocity = self.velocities[name].text
            moving = "at rest" if velocity == "at rest" else f"velocity {velocity}"
            radius = ", radius r" if any(blow.offset for blow in self.blows) else ""
            said = mass + (moving if velocity else "") + radius
            told.append(f"sphere {name}: {said.rstrip(', ')}" if said else f"sphere {name}")
        for blow in self.blows:
            how = []
            if blow.wall:
                along = f": along {blow.along.text}" if blow.along.text else ""
                told.append(f"wall {blow.second}{along}")
            elif blow.offset:
                how.append(f"offset {blow.offset.text}")
            elif blow.along.text:
                how.append(f"along {blow.along.text}")
            if blow.e.text:
                how.append(f"e = {blow.e.text}")
            told.append(f"{blow.first} hits {blow.second}" + (": " + ", ".join(how) if how else ""))
        return "\n".join([*told, *lines]) + "\n"


def in_words(value: Any, letter: str = "") -> str:
    """An exact number or pair as it is typed, times a letter where one is given."""
    if isinstance(value, tuple):
        return "(" + ", ".join(in_words(each, letter) for each in value) + ")"
    return f"{value} {letter}".rstrip()


def said(value: Any, letter: str = "") -> Said:
    """A value with its words."""
    return Said(in_words(value, letter), value)


HEADINGS = ((1, 0), (0, 1), (1, 1), (1, -1), (3, 4), (4, -3), (5, 12), (2, 1), (-1, 3))
DEGREES = (0, 30, 45, 60, 90, 120, 135, 150)
SHARES = (Fraction(0), Fraction(1, 2), Fraction(3, 5), Fraction(4, 5), Fraction(-3, 5))


@once
def halves(low: int = -6, high: int = 6) -> st.SearchStrategy[Fraction]:
    """Small exact numbers."""
    return st.builds(Fraction, st.integers(low, high), st.sampled_from([1, 1, 1, 2, 3]))


@once
def coefficients() -> st.SearchStrategy[Fraction]:
    """Coefficients of restitution, both ends often among them."""
    inner = st.builds(lambda n, d: Fraction(min(n, d), max(n, d)), *[st.integers(1, 9)] * 2)
    return st.one_of(inner, inner, st.sampled_from([Fraction(0), Fraction(1), Fraction(1, 2)]))


def by_angle(size: Any, degrees: Any) -> tuple[float, float]:
    """Components of a vector given by its size and an angle in degrees."""
    angle = math.radians(degrees)
    return float(size) * math.cos(angle), float(size) * math.sin(angle)


@st.composite
def tales(
    draw: st.DrawFn,
    most: int = 3,
    exact: bool = False,
    letters: bool = False,
    offsets: bool = True,
) -> Tale:
    """Chains of impacts of spheres with spheres and walls; nothing tells yet that they can happen.

    With ``exact`` all values are Fractions (and there are no offsets); with ``letters`` masses
    are multiples of m, speeds of u. Impacts that follow one another are of different pairs, each
    wall is struck once: otherwise a sphere could come to stand on the wrong side of another.
    """
    count = draw(st.integers(1, most))
    blows: list[Blow] = []
    for number in range(1, count + 1):
        # all sorts of pairs, each with a sphere that moved in the impact before
        pairs = [("A", f"W{number}"), ("A", "B"), ("B", "A")]
        if number > 1:
            pairs += [("B", "C"), ("B", f"W{number}"), ("A", "C")]
        pairs = [
            pair for pair in pairs if not blows or {*pair} != {blows[-1].first, blows[-1].second}
        ]
        first, second = draw(st.sampled_from(pairs))
        heading = draw(st.sampled_from(HEADINGS))
        along = said((Fraction(heading[0]), Fraction(heading[1])))
        if any({first, second} == {blow.first, blow.second} for blow in blows):
            # they meet again on another line: who is on which side is not told
            along = said((Fraction(7 + number), Fraction(-3)))
        elif not exact and draw(st.booleans()):
            degrees = draw(st.sampled_from(DEGREES))
            along = Said(f"{degrees}°", by_angle(1, degrees))
        offset = None
        if number == 1 and second == "B" and offsets and not exact and draw(st.booleans()):
            share = draw(st.sampled_from(SHARES))
            offset = Said(in_words(2 * share, "r"), share)
        blows.append(Blow(first, second, said(draw(coefficients())), along, offset))
    present = sorted({n for b in blows for n in (b.first, b.second) if not n.startswith("W")})
    masses, velocities = {}, {}
    for name in present:
        masses[name] = said(draw(halves(1, 6)), "m" if letters else "")
        if name != blows[0].first and draw(st.booleans()):
            velocities[name] = Said("at rest", (Fraction(0), Fraction(0)))
        elif not exact and draw(st.booleans()):
            size, degrees = draw(halves(1, 6)), draw(st.sampled_from([*DEGREES, -60, -135]))
            text = f"{in_words(size, 'u' if letters else '')} at {degrees}°"
            velocities[name] = Said(text, by_angle(size, degrees))
        else:
            pair = draw(st.tuples(halves(), halves()).filter(any))
            velocities[name] = said(pair, "u" if letters else "")
    return Tale(masses, velocities, tuple(blows))


# --- questions as examinations ask them -------------------------------------------------------


@dataclass(frozen=True)
class Question:
    """A question about one impact or two, with numbers for which it happens as it is told.

    ``setting`` says what meets what; ``forgotten`` which of the data is to be worked out, from what
    is ``given`` in its place; ``asked`` the kinds of what is asked. ``letters`` is None where a
    condition is given, and it is open whether it can hold.
    """

    statement: str
    setting: str
    forgotten: str | None
    given: str | None
    asked: tuple[str, ...]
    letters: Mapping[str, Any] | None


@dataclass(frozen=True)
class Datum:
    """What a statement gives in some place, and what stands there if it is forgotten."""

    typed: str
    instead: str
    letter: str
    value: str


@dataclass(frozen=True)
class Draft:
    """A story with blanks, ``<e>``, for its data; ``letters`` has numbers for those that stay open.

    What is asked is asked of the ``body``, and of ``line``: the wall or line of centres of its last
    impact. ``speed`` and ``mass`` are the letters that scale everything, if there are such;
    ``mass`` is None where there are no masses. ``shows`` are claims for all values of the letters.
    """

    setting: str
    lines: tuple[str, ...]
    data: Mapping[str, Datum]
    letters: Mapping[str, Fraction]
    body: str
    line: str
    speed: str = ""
    mass: str | None = None
    shows: tuple[str, ...] = ()

    def text(self, forgotten: str | None = None) -> str:
        """The story, with a letter for what is forgotten."""
        told = "\n".join(self.lines)
        for name, datum in self.data.items():
            told = told.replace(f"<{name}>", datum.instead if name == forgotten else datum.typed)
        return told + "\n"

    @property
    def numbers(self) -> dict[str, Any]:
        """Numbers for all letters, those that data replace among them; scales are 1."""
        by_data = {each.letter: value_of(each.value) for each in self.data.values()}
        return {"u": 1, "m": 1, **by_data, **{n: precise(x) for n, x in self.letters.items()}}

    @property
    def scales(self) -> dict[str, Any]:
        """Numbers for the letters that scale everything, none of them 1."""
        scales = {self.speed: Fraction(223, 100), "m": Fraction(137, 100)}
        return {letter: precise(value) for letter, value in scales.items()}

    def scale(self, kind: str) -> str:
        """What a number is times, if it measures a speed, an impulse or an energy."""
        squared = f"{self.speed}^2" if self.speed else ""
        units = {"speed": ("", self.speed), "impulse": (self.mass, self.speed)}
        units["energy"] = (self.mass, squared)
        return " ".join(each for each in units.get(kind, ()) if each)

    def quantities(self) -> dict[str, tuple[str, str]]:
        """What there is to ask that is a number: by kind, in words, and what it measures."""
        one, line = self.body, self.line
        kinds = {
            "speed": (f"speed({one})", "speed"),
            "component": (f"along(velocity({one}), {line})", "speed"),
            "tangent": (f"tan(angle(velocity({one}), {line}))", ""),
            "tangent of the deflection": (f"tan(deflection({one}))", ""),
            "share of speed": (f"speed({one})/speed({one}, 0)", ""),
        }
        if line == "line_of_centres":
            kinds["speed of the second"] = ("speed(B)", "speed")
        if self.mass is not None:
            kinds["impulse"] = ("impulse", "impulse")
            kinds["energy"] = (f"energy({one})", "energy")
            kinds["energy lost"] = ("energy_lost", "energy")
            kinds["share of energy"] = ("energy_lost/energy(0)", "")
        return kinds

    def asks(self) -> dict[str, str]:
        """All that there is to find."""
        one, line = self.body, self.line
        asks = {kind: words for kind, (words, _) in self.quantities().items()}
        asks |= {
            "velocity": f"velocity({one})",
            "angle": f"angle(velocity({one}), {line})",
            "deflection": f"deflection({one})",
        }
        if self.mass is not None:
            asks["impulse as a vector"] = f"impulse({one})"
            asks["percentage"] = "energy_lost/energy(0) as a percentage"
        if line == "line_of_centres":
            asks["velocity of the second"] = "velocity(B)"
            asks["angle between"] = "angle(velocity(A), velocity(B))"
        return asks

    def conditions(self) -> list[str]:
        """What may be given of the motion without a number that fits."""
        one, line = self.body, self.line
        return [
            f"velocity({one}) perpendicular to velocity({one}, 0)",
            f"deflection({one}) = 60°",
            f"angle(velocity({one}), {line}) = 45°",
            f"speed({one}) = 1/2 speed({one}, 0)",
        ]

    def bounds(self) -> list[str]:
        """Inequalities that may be given of the motion."""
        one, line = self.body, self.line
        return [
            f"along(velocity({one}), {line}) < 0",
            f"angle(velocity({one}), {line}) < 45°",
            f"speed({one}) < 1/2 speed({one}, 0)",
        ]


COEFFICIENTS = ("1/2", "1/3", "2/3", "3/4", "1/4", "3/5", "0.6", "1")
_OPEN = (Fraction(2, 5), Fraction(5, 8))
_RATIOS = {
    "tan(alpha) = 3/4": "arctan(3/4)",
    "tan(alpha) = 1/2": "arctan(1/2)",
    "cos(alpha) = 3/5": "arccos(3/5)",
    "sin(alpha) = 5/13": "arcsin(5/13)",
}


@st.composite
def _velocities(
    draw: st.DrawFn, speed: str
) -> tuple[str, str, dict[str, Datum], dict[str, Fraction]]:
    """A velocity at an angle: its kind, its words, what is given of it, and open letters."""
    data: dict[str, Datum] = {}
    letters: dict[str, Fraction] = {}
    if not speed:
        size = draw(st.sampled_from(("5", "8", "2")))
        data["speed"] = Datum(size, "u", "u", size)
    kind = draw(st.sampled_from(("degrees", "ratio", "letter")))
    angle = "alpha"
    if kind == "degrees":
        angle = "<angle>"
        typed = draw(st.sampled_from(("30°", "45°", "60°")))
        data["angle"] = Datum(typed, "alpha", "alpha", typed)
    elif kind == "ratio":
        typed = draw(st.sampled_from(sorted(_RATIOS)))
        data["angle"] = Datum(f"given {typed}", "", "alpha", _RATIOS[typed])
    else:
        letters["alpha"] = draw(st.sampled_from(_OPEN))
    return kind, f"{speed or '<speed>'} at {angle}", data, letters


@st.composite
def _restitutions(draw: st.DrawFn) -> tuple[str, dict[str, Datum], dict[str, Fraction]]:
    """How a coefficient is told: as a number, or as a letter that stays open."""
    if draw(st.sampled_from((True, True, False))):
        typed = draw(st.sampled_from(COEFFICIENTS))
        return "e = <e>", {"e": Datum(typed, "e", "e", typed)}, {}
    return "e = e", {}, {"e": draw(st.sampled_from(_OPEN))}


def _pair(x: int, y: int, speed: str) -> str:
    """A vector as it is typed: ``2u i - j``."""
    told = ""
    for share, axis in ((x, "i"), (y, "j")):
        if share:
            size = f"{'' if abs(share) == 1 else abs(share)}{speed} {axis}".strip()
            sign = " - " if share < 0 else " + "
            told += sign + size if told else sign.strip(" +") + size
    return told


@st.composite
def _walls(draw: st.DrawFn) -> Draft:
    """A sphere that strikes a wall, and perhaps another."""
    speed = draw(st.sampled_from(("", "u")))
    mass = draw(st.sampled_from((None, "2", "m", "3m")))
    wall = draw(st.sampled_from(("i", "j", "i", "j", "3i + 4j", "i + j", "i - 2j", "60°", "theta")))
    e, data, letters = draw(_restitutions())
    shows: tuple[str, ...] = ()
    ratio = ""
    if wall == "theta":
        kind, velocity = "turned", f"{speed or 5} i"
        letters = {**letters, "theta": draw(st.sampled_from(_OPEN))}
    elif draw(st.booleans()):
        kind = "vector"
        x, y = draw(st.tuples(st.integers(-6, 6), st.integers(-6, 6)).filter(all))
        velocity = _pair(x, y, speed)
    else:
        kind, velocity, more, open_ = draw(_velocities(speed))
        velocity += " to W"
        data, letters = {**data, **more}, {**letters, **open_}
        ratio = "<angle>" if kind == "ratio" else ""
    several = draw(st.sampled_from((False, False, True)))
    lines = [
        f"wall W: along {wall}",
        f"sphere P: {'' if mass is None else f'mass {mass}, '}velocity {velocity}",
        ratio,
        f"P hits W: {e}",
    ]
    if several:
        second = draw(st.sampled_from((wall, "i", "j", "3i + 4j", "120°")))
        lines.insert(1, f"wall V: along {second}")
        lines.append(f"P hits V: {draw(st.sampled_from((e, 'e = 1/2', 'e = 2/3')))}")
    elif "alpha" in letters:
        coefficient = "e" if "e" in letters else "<e>"
        shows = (f"tan(angle(velocity(P), W)) = {coefficient} tan(alpha)",)
        if speed:
            squared = f"cos^2(alpha) + ({coefficient})^2 sin^2(alpha)"
            shows += (f"speed(P)^2 = u^2 ({squared})", "speed(P) <= u")
    return Draft(
        f"{'two walls' if several else 'a wall'}, {kind}",
        tuple(filter(None, lines)),
        data,
        letters,
        "P",
        "V" if several else "W",
        speed,
        mass if mass is None else mass.strip("23"),
        shows,
    )


@st.composite
def _collisions(draw: st.DrawFn) -> Draft:
    """Two spheres that collide, the second at rest or moving."""
    speed = draw(st.sampled_from(("", "u")))
    e, data, letters = draw(_restitutions())
    masses = draw(st.sampled_from(("2 3", "4 1", "m m", "m 2m", "3m 2m", "m <ratio>m", "m k*m")))
    first, second = masses.replace("*", " ").split(" ", 1)
    if "<ratio>" in second:
        typed = draw(st.sampled_from(("2", "4", "5")))
        data = {**data, "ratio": Datum(typed, "k ", "k", typed)}
    elif "k" in second:
        letters = {**letters, "k": draw(st.sampled_from((Fraction(3), Fraction(1, 2))))}
    line, (x, y) = draw(
        st.sampled_from(
            [("i", (1, 0)), ("i", (1, 0)), ("j", (0, 1)), ("3i + 4j", (3, 4)), ("i - j", (1, -1))]
        )
    )
    ratio = ""
    if line == "i" and draw(st.booleans()):
        kind, velocity, more, open_ = draw(_velocities(speed))
        data, letters = {**data, **more}, {**letters, **open_}
        ratio = "<angle>" if kind == "ratio" else ""
        number_ = speed or "3"
        others = ["", "", f"-2{speed} i", f"{number_} at 120°", f"{number_} at 90°"]
    else:
        kind = "vector"
        a, b = draw(st.tuples(st.integers(-5, 5), st.integers(-5, 5)).filter(any))
        own = a * x + b * y
        assume(own)
        c, d = draw(st.tuples(st.integers(-5, 5), st.integers(-5, 5)).filter(any))
        velocity = _pair(a, b, speed)
        approaching = (own - (c * x + d * y)) * own > 0
        others = ["", _pair(c, d, speed)] if approaching else [""]
    other = draw(st.sampled_from(others))
    shows: tuple[str, ...] = ()
    if not other and "alpha" in letters and masses == "m m":
        coefficient = "e" if "e" in letters else "<e>"
        shows = (
            f"along(velocity(A), i) = 1/2 (1 - {coefficient}) {speed or '<speed>'} cos(alpha)",
            f"speed(B) = 1/2 (1 + {coefficient}) {speed or '<speed>'} cos(alpha)",
        )
    lines = [
        f"sphere A: mass {first}, velocity {velocity}",
        f"sphere B: mass {second}, {f'velocity {other}' if other else 'at rest'}",
        ratio,
        f"A hits B: along {line}, {e}",
    ]
    return Draft(
        f"spheres, {kind}, {'both moving' if other else 'one at rest'}",
        tuple(filter(None, lines)),
        data,
        letters,
        "A",
        "line_of_centres",
        speed,
        first.strip("34") if "m" in first else "",
        shows,
    )


def exactly(value: Any) -> str | None:
    """A number of many digits as it is typed: a plain fraction, or the root of one."""
    for power in (1, 2):
        wanted = value**power
        near = Fraction(int(wanted * 10**60), 10**60).limit_denominator(2000)
        if abs(precise(near) - wanted) > precise(Fraction(1, 10**50)):
            continue
        if power == 1:
            return str(near)
        under = near.numerator * near.denominator
        outside = max(n for n in range(1, 100) if under % (n * n) == 0)
        share = Fraction(outside, near.denominator)
        return f"{share} sqrt({under // outside**2})" if value > 0 else None
    return None


def told_in_numbers(text: str, letters: Mapping[str, Any]) -> World | None:
    """A statement in numbers; None where it cannot happen."""
    try:
        return World(parse(text), letters)
    except ImpossibleWorldError:
        return None


def _worth(draft: Draft, kind: str) -> str | None:
    """What a quantity is, with its scale, if that is a plain number."""
    words, measure = draft.quantities()[kind]
    world = told_in_numbers(draft.text() + f"find {words}\n", draft.numbers)
    assert world is not None
    (find,) = (step for _, step in world.problem.steps() if isinstance(step, p.Find))
    try:
        value = world.value(find.items[0].expression, len(world.events))
    except ImpossibleWorldError:
        return None
    exact = exactly(value) if abs(value) < 1000 else None
    return exact and f"{exact} {draft.scale(measure)}".rstrip()


@st.composite
def questions(draw: st.DrawFn) -> Question:
    """Questions in the manner of examinations: of walls, and of two spheres.

    The story is worked in numbers first. Then one of the data may be forgotten, and a result be
    given instead; or a condition, of which it is open whether it can hold.
    """
    draft = draw(st.one_of(_walls(), _collisions()))
    letters: Mapping[str, Any] | None = draft.numbers
    assume(told_in_numbers(draft.text(), draft.numbers) is not None)
    forgotten = draw(st.sampled_from([None, *sorted(draft.data)]))
    asks = draft.asks()
    facts: list[str] = []
    first: list[tuple[str, str]] = []
    given = None
    if forgotten is not None:
        letter = draft.data[forgotten].letter
        first = [(forgotten, f"find {letter}")]
        kinds = [] if draft.letters else sorted(draft.quantities())
        kind = draw(st.sampled_from([*kinds, *kinds, "condition", "bound"]))
        if kind == "bound" and forgotten in ("e", "ratio"):
            given, letters = "bound", None
            facts = [f"given {draw(st.sampled_from(draft.bounds()))}"]
            first = [(f"range of {forgotten}", f"find range of {letter}")]
        elif kind in ("condition", "bound"):
            given, letters = "condition", None
            # With another letter open, an angle may be beyond what is solved in a short time.
            few = 1 if forgotten == "angle" and draft.letters else None
            assume(few is None or not draft.setting.startswith("two walls"))
            facts = [f"given {draw(st.sampled_from(draft.conditions()[:few]))}"]
        else:
            worth = _worth(draft, kind)
            assume(worth is not None)
            given = kind
            del asks[kind]
            facts = [f"given {draft.quantities()[kind][0]} = {worth}"]
    elif "e" in draft.letters and draw(st.integers(0, 3)) == 0:
        kind = draw(st.sampled_from(sorted(draft.quantities())))
        first = [("range of a quantity", f"find range of {asks[kind]}")]
    chosen = draw(st.lists(st.sampled_from(sorted(asks)), max_size=2, unique=True))
    then = [(kind, f"find {asks[kind]}") for kind in chosen]
    if letters is not None and draw(st.booleans()):
        then += draw(_shown(draft))
    assume(first or then)
    heads: tuple[list[str], ...] = (facts, [], [])
    if first and then:
        heads = draw(
            st.sampled_from(
                [
                    heads,
                    (facts, ["part a"], ["part b"]),
                    ([], ["part a", *facts], ["part b", *facts]),
                ]
            )
        )
    lines = [*heads[0], *heads[1], *(each for _, each in first)]
    lines += [*heads[2], *(each for _, each in then)]
    return Question(
        draft.text(forgotten) + "\n".join(lines) + "\n",
        draft.setting,
        forgotten,
        given,
        tuple(kind for kind, _ in (*first, *then)),
        None if letters is None else {**letters, **draft.scales},
    )


@st.composite
def _shown(draw: st.DrawFn, draft: Draft) -> list[tuple[str, str]]:
    """A result to be shown, if there is one: for all values of letters, or a number."""
    if draft.letters:
        if not draft.shows:
            return []
        claim = draw(st.sampled_from(draft.shows))
        for name, datum in draft.data.items():
            claim = claim.replace(f"<{name}>", datum.typed)
        return [("show in letters", f"show {claim}")]
    kind = draw(st.sampled_from(sorted(draft.quantities())))
    worth = _worth(draft, kind)
    return [] if worth is None else [("show", f"show {draft.quantities()[kind][0]} = {worth}")]


# --- tables -----------------------------------------------------------------------------------

CELL = 4  # m


@st.composite
def tables(
    draw: st.DrawFn, *, spheres: int = 4, e: st.SearchStrategy[Fraction] | None = None
) -> Table:
    """Tables with walls around and among up to so many spheres, each in a cell of its own.

    The wall around is a square or an L; all numbers are quarters or halves, so that every table
    can be played exactly too. What stands in a cell leaves a quarter of a metre around it.
    """
    e = st.just(Fraction(1)) if e is None else e
    cells = [(x, y) for x in range(3) for y in range(3)]
    corners = [(0, 0), (12, 0), (12, 12), (0, 12)]
    if draw(st.booleans()):
        cells.remove((2, 2))
        corners[2:3] = [(12, 8), (8, 8), (8, 12)]
    cells = draw(st.permutations(cells))
    centres = [((2 * x + 1) * CELL // 2, (2 * y + 1) * CELL // 2) for x, y in cells]
    count = draw(st.integers(1, spheres))
    radii = st.sampled_from([Fraction(n, 4) for n in (1, 2, 4, 7)])
    thrown = [
        p.Sphere(
            f"S{n}",
            mass=draw(st.sampled_from([Fraction(1, 2), 1, 2, 5])),
            radius=draw(radii),
            position=centre,
            velocity=draw(st.tuples(halves(), halves()).filter(any if n == 0 else bool)),
        )
        for n, centre in enumerate(centres[:count])
    ]
    among = []
    for n, (x, y) in enumerate(centres[count:], start=1):
        kind = draw(st.sampled_from(["none", "circle", "segment"]))
        if kind == "circle":
            among.append(p.Wall(f"C{n}", centre=(x, y), radius=draw(radii)))
        elif kind == "segment":
            dx, dy = draw(st.tuples(halves(-3, 3), halves(-3, 3)).filter(any))
            half = dx / 2, dy / 2
            among.append(
                p.Wall(f"B{n}", start=(x - half[0], y - half[1]), end=(x + half[0], y + half[1]))
            )
    around = polygon(corners)
    special = {wall.name: draw(e) for wall in (*around, *among) if draw(st.booleans())}
    return Table(thrown, (*around, *among), draw(e), special)


@st.composite
def gases(draw: st.DrawFn) -> dict[str, Any]:
    """What a small `Gas` is made of: discs of any radii and masses, each in a cell of its own.

    Some at rest; walls hard or periodic on either side. None touch at the start: in a row of such
    a blow may go to and fro more than a hundred times at one time, which is taken for a collapse.
    """
    columns, lines = draw(st.integers(5, 7)), draw(st.integers(5, 7))
    cells = [(x, y) for x in range(columns) for y in range(lines)]
    cells = draw(st.permutations(cells))[: draw(st.integers(1, 20))]
    part = st.floats(-3, 3).map(lambda x: round(x, 3))
    radii = st.one_of(st.just(0.5), st.floats(0.05, 0.5))
    each = st.lists(st.tuples(part, part), min_size=len(cells), max_size=len(cells))
    count = {"min_size": len(cells), "max_size": len(cells)}
    return {
        "positions": [(1.2 * x + 0.6, 1.2 * y + 0.6) for x, y in cells],
        "velocities": draw(each),
        "width": 1.2 * columns,
        "height": 1.2 * lines,
        "radius": draw(st.lists(radii, **count)),
        "mass": draw(st.lists(st.floats(0.01, 100), **count)),
        "periodic": draw(st.tuples(st.booleans(), st.booleans())),
        "e": draw(st.sampled_from([1.0, 1.0, 0.9, 0.5, 0.0])),
        "e_walls": draw(st.sampled_from([1.0, 0.8, 0.0])),
        "contact_time": draw(st.sampled_from([0.0, 0.01])),
    }


# --- pictures ---------------------------------------------------------------------------------

_ALPHA, _U, _E = layout.Letter("alpha"), layout.Letter("u"), layout.Letter("e")
CONTENTS: tuple[layout.Layout, ...] = (
    _U,
    _ALPHA,
    layout.Letter("v", "A"),
    layout.Bold("j"),
    layout.Words("A"),
    layout.Words("2 kg"),
    layout.Degrees(layout.Number("53.1")),
    layout.Product((_U, layout.Function("cos", _ALPHA))),
    layout.Product((_E, _U, layout.Function("sin", _ALPHA, layout.Number("2")))),
    layout.Product((layout.Fraction(layout.Root(layout.Number("103")), layout.Number("16")), _U)),
    layout.equation(layout.Letter("theta"), layout.Fraction(_E, layout.Number("7"))),
)
ROLES = ("velocity", "component", "impulse", "path", "measure", "line_of_centres", "onward")


@once
def places(width: int, height: int) -> st.SearchStrategy[Vector]:
    """Points of a picture, on half millimetres."""
    return st.builds(
        lambda x, y: Vector(x / 2, y / 2), st.integers(0, 2 * width), st.integers(0, 2 * height)
    )


@once
def shapes(width: int, height: int) -> st.SearchStrategy[scenes.Shape]:
    """Shapes of every kind within a picture."""
    points = places(width, height)
    roles = st.sampled_from(ROLES)
    lengths = st.integers(2, 16).map(lambda n: n / 2)
    angles_ = st.integers(-12, 24).map(lambda n: n * math.pi / 12)
    return st.one_of(
        st.builds(scenes.Line, roles, points, points),
        st.builds(scenes.Arrow, roles, points, points, st.booleans()),
        st.builds(
            scenes.Polyline, st.just("path"), st.lists(points, min_size=2, max_size=4).map(tuple)
        ),
        st.builds(scenes.Disc, st.just("A"), points, lengths, st.booleans()),
        st.builds(scenes.Dot, st.just("N"), points),
        st.builds(scenes.Arc, st.just("angle"), points, lengths, angles_, angles_),
        st.builds(
            lambda corner, angle: scenes.RightAngle(
                corner,
                Vector(math.cos(angle), math.sin(angle)),
                Vector(-math.sin(angle), math.cos(angle)),
            ),
            points,
            angles_,
        ),
        st.builds(scenes.StraightWall, st.just("W"), points, points, points),
        st.builds(
            scenes.RoundWall,
            st.just("W"),
            points,
            lengths,
            angles_,
            angles_,
            st.sampled_from(("inside", "outside")),
        ),
    )


@once
def labels(width: int, height: int) -> st.SearchStrategy[scenes.Label]:
    """Labels that want to stand anywhere, some fixed, some ringed."""
    points = places(width, height)
    return st.builds(
        scenes.Label,
        st.sampled_from(CONTENTS),
        points,
        st.permutations(("ne", "nw", "se", "sw", "n", "s", "e", "w", "centre")).map(
            lambda sides: tuple(sides[:4])
        ),
        st.integers(0, 16).map(lambda n: n / 4),
        st.sampled_from((2.6, 3.0)),
        st.booleans(),
        st.booleans(),
        st.lists(points, max_size=2).map(tuple),
    )


@once
def pictures() -> st.SearchStrategy[scenes.Scene]:
    """Scenes of shapes anywhere, with two panels or none, and up to nine labels."""
    width, height = 84, 40
    panels = (
        scenes.Panel("Before", (0.0, 0.0, 41.0, 40.0)),
        scenes.Panel("After", (43.0, 0.0, 84.0, 40.0)),
    )
    note = layout.Phrase((layout.Words("Drawn for"), layout.equation(_U, layout.Number("1"))))
    return st.builds(
        scenes.Scene,
        st.sampled_from(("A picture", "1 < 2 & 3")),
        st.just("What it shows."),
        st.just((0.0, 0.0, float(width), float(height))),
        st.lists(shapes(width, height), max_size=10).map(tuple),
        st.lists(labels(width, height), max_size=9).map(tuple),
        st.sampled_from(((), panels)),
        st.sampled_from((None, note)),
    )


# -- numbers --------------------------------------------------------------------------------------


def surds() -> st.SearchStrategy[sympy.Expr]:
    """Numbers made of rationals and roots of them by the four operations."""
    rational = st.builds(sympy.Rational, st.integers(-9, 9), st.integers(1, 9))
    inside = st.builds(sympy.Rational, st.integers(1, 15), st.integers(1, 3))
    leaves = st.builds(lambda times, square: times * sympy.sqrt(square), rational, inside)

    def grown(inner: st.SearchStrategy[sympy.Expr]) -> st.SearchStrategy[sympy.Expr]:
        quotients = st.builds(
            lambda a, b: a / b if sympy.expand(sympy.radsimp(b)) != 0 else a, inner, inner
        )
        return (
            st.builds(operator.add, inner, inner)
            | st.builds(operator.mul, inner, inner)
            | quotients
        )

    return st.recursive(leaves, grown, max_leaves=4)
