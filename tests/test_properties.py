"""Laws that hold for every problem, on problems made up by Hypothesis.

The impacts are told a second time here, from the textbook's principles: for each impact the
linear equations (momentum along the line of centres, Newton's experimental law, no change along
the tangent) are put down in components and solved by elimination, in exact fractions where the
data are fractions and in floats otherwise. Nothing of this uses the closed form of the package.
"""

from __future__ import annotations

import dataclasses
import itertools
import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import pytest
import strategies
import sympy as sp
from hypothesis import assume, given, note, settings
from hypothesis import strategies as st
from strategies import Blow, Said, Tale, said

from restitution.language import parse, to_statement
from restitution.solving import ItemResult, Solution, solve

# Many solves each, of statements that nobody has seen before.
pytestmark = pytest.mark.timeout(300)

Number = Any  # a Fraction, or a float where a root or an angle comes in
Pair = tuple[Number, Number]

SCALE = {"m": 1.37, "u": 2.23, "r": 0.71}
"""Numbers for the letters that are left in answers."""


def examples(count: int) -> settings:
    """So many examples, each of which may take its time; failures print how to repeat them."""
    return settings(max_examples=count, deadline=None, print_blob=True)


# --- the impacts, told from the principles ----------------------------------------------------


def dot(a: Pair, b: Pair) -> Number:
    return a[0] * b[0] + a[1] * b[1]


def cross(a: Pair, b: Pair) -> Number:
    return a[0] * b[1] - a[1] * b[0]


def plus(a: Pair, b: Pair, factor: Number = 1) -> Pair:
    return a[0] + factor * b[0], a[1] + factor * b[1]


def linear(rows: list[list[Number]], right: list[Number]) -> list[Number]:
    """The solution of a square system, by elimination with the largest pivot."""
    table = [[*row, value] for row, value in zip(rows, right, strict=True)]
    size = len(table)
    for column in range(size):
        pivot = max(range(column, size), key=lambda k: abs(table[k][column]))
        table[column], table[pivot] = table[pivot], table[column]
        for other in range(size):
            if other != column:
                factor = table[other][column] / table[column][column]
                table[other] = [a - factor * b for a, b in zip(table[other], table[column])]
    return [table[k][size] / table[k][k] for k in range(size)]


def rebound(u: Pair, along: Pair, e: Number) -> Pair:
    """The velocity after a wall: unchanged along it, reversed and e times as large across it."""
    across = (-along[1], along[0])
    v = linear([[*along], [*across]], [dot(u, along), -e * dot(u, across)])
    return v[0], v[1]


def collide(m1: Number, u1: Pair, m2: Number, u2: Pair, c: Pair, e: Number) -> tuple[Pair, Pair]:
    """The velocities after an impact of two spheres with the line of centres ``c``."""
    t = (-c[1], c[0])
    v = linear(
        [
            [m1 * c[0], m1 * c[1], m2 * c[0], m2 * c[1]],
            [-c[0], -c[1], c[0], c[1]],
            [t[0], t[1], 0, 0],
            [0, 0, t[0], t[1]],
        ],
        [m1 * dot(u1, c) + m2 * dot(u2, c), e * (dot(u1, c) - dot(u2, c)), dot(u1, t), dot(u2, t)],
    )
    return (v[0], v[1]), (v[2], v[3])


@dataclass(frozen=True)
class Told:
    """A tale run: the velocities at each stage, and the unit normal of each impact."""

    tale: Tale
    stages: tuple[dict[str, Pair], ...]
    normals: tuple[Pair, ...]
    approaches: tuple[float, ...]

    def mass(self, name: str) -> Number:
        return self.tale.masses[name].value

    def velocity(self, name: str, stage: int = -1) -> Pair:
        return self.stages[stage][name]

    def speed(self, name: str, stage: int = -1) -> float:
        return math.hypot(*map(float, self.velocity(name, stage)))

    def energy(self, stage: int = -1) -> Number:
        return sum(self.mass(name) * dot(v, v) / 2 for name, v in self.stages[stage].items())

    def energy_lost(self, number: int = -1) -> Number:
        number = number % len(self.stages)
        return self.energy(number - 1) - self.energy(number)

    def momentum(self, stage: int = -1) -> Pair:
        pairs = [
            (self.mass(name) * v[0], self.mass(name) * v[1])
            for name, v in self.stages[stage].items()
        ]
        return sum(p[0] for p in pairs), sum(p[1] for p in pairs)

    def blow(self, name: str, number: int = -1) -> Pair:
        """The impulse on a sphere."""
        number = number % len(self.stages)
        change = plus(self.velocity(name, number), self.velocity(name, number - 1), -1)
        return self.mass(name) * change[0], self.mass(name) * change[1]

    def impulse(self, number: int = -1) -> float:
        return math.hypot(*map(float, self.blow(self.tale.blows[-1].first, number)))

    def deflection(self, name: str) -> float:
        """The angle between the directions just before and after the last impact."""
        return angle_between(self.velocity(name, -2), self.velocity(name))


def angle_between(a: Pair, b: Pair) -> float:
    return math.atan2(abs(float(cross(a, b))), float(dot(a, b)))


def line_of_centres(blow: Blow, u1: Pair, u2: Pair) -> Pair:
    """From A's centre to B's: as told, in the sense in which they approach, or by the offset.

    In the plane of motion relative to B the centre of A moves along g; the centre of B lies
    ``2r sin`` to the left of that line, so that the line of centres is g turned to the left.
    """
    g = plus(u1, u2, -1)
    if blow.offset is None:
        c = blow.along.value
        return c if dot(g, c) > 0 else (-c[0], -c[1])
    sine = blow.offset.value
    cosine = math.sqrt(1 - sine * sine)
    return cosine * g[0] - sine * g[1], cosine * g[1] + sine * g[0]


def tell(tale: Tale) -> Told | None:
    """Run a tale; None where it cannot happen: two bodies do not approach each other.

    A hits B says that A moves towards B, if it moves along the line of centres at all: where it
    does not, B moves towards A, and the tale is told the other way about.
    """
    now = {name: velocity.value for name, velocity in tale.velocities.items()}
    stages, normals, approaches, blows = [dict(now)], [], [], []
    sides: dict[tuple[str, str], Pair] = {}
    for blow in tale.blows:
        a, b = blow.first, blow.second
        if not blow.wall and blow.offset is None and (a, b) not in sides:
            c = blow.along.value
            own = float(dot(now[a], c))
            if abs(own) > 1e-9 and own * float(dot(plus(now[a], now[b], -1), c)) < 0:
                a, b = b, a
        blow = dataclasses.replace(blow, first=a, second=b)
        blows.append(blow)
        if blow.wall:
            along = blow.along.value
            normal = (-along[1], along[0])
            if dot(now[a], normal) < 0:
                normal = (along[1], -along[0])
            approach = float(dot(now[a], normal)) / math.hypot(*map(float, normal))
        else:
            normal = line_of_centres(blow, now[a], now[b])
            size = math.hypot(*map(float, normal))
            approach = float(dot(plus(now[a], now[b], -1), normal)) / size if size else 0.0
        if approach < 1e-6:
            return None
        if not blow.wall and blow.offset is None:
            met = sides.get((a, b))  # who is on which side, and on one line nobody passes
            relative = plus(now[a], now[b], -1)
            if met is not None and abs(float(cross(met, normal))) < 1e-9 * size:
                straight = abs(float(cross(relative, normal))) < 1e-9 * size
                if straight and float(dot(met, normal)) < 0:
                    return None
        if not blow.wall:
            sides[a, b] = (float(normal[0]), float(normal[1]))
            sides[b, a] = (-float(normal[0]), -float(normal[1]))
        if blow.wall:
            now[a] = rebound(now[a], along, blow.e.value)
        else:
            pairs = collide(
                tale.masses[a].value, now[a], tale.masses[b].value, now[b], normal, blow.e.value
            )
            now[a], now[b] = pairs
        size = math.hypot(*map(float, normal))
        normals.append((float(normal[0]) / size, float(normal[1]) / size))
        stages.append(dict(now))
        approaches.append(approach)
    tale = dataclasses.replace(tale, blows=tuple(blows))
    return Told(tale, tuple(stages), tuple(normals), tuple(approaches))


# --- reading answers --------------------------------------------------------------------------


FUNCTIONS = ["sqrt", "sin", "cos", "tan", "atan", "acos", "asin", "pi", "oo", "Abs", "CRootOf"]
SETS = ["Interval", "Lopen", "Ropen", "open", "Union", "FiniteSet", "EmptySet"]


def symbolic(text: str) -> Any:
    """An exact answer read again, as the contract says: SymPy syntax, every letter a symbol."""
    names = {*re.findall(r"[A-Za-z_]\w*", text)} - {*FUNCTIONS, *SETS}
    return sp.sympify(text, locals={name: sp.Symbol(name) for name in names})


def number(text: str, letters: dict[str, float]) -> float:
    value = symbolic(text)
    return float(value.subs({s: letters[s.name] for s in value.free_symbols}).evalf(25))


def values(item: ItemResult, letters: dict[str, float] | None = None) -> list[Any]:
    """All answers to an item in numbers: a float each, or a pair of floats."""
    if item.error is not None:
        raise AssertionError(f"{item.text}: {item.error.kind}: {item.error}") from item.error
    found = []
    for answer in item.answers:
        if isinstance(answer.exact, tuple):
            value: Any = tuple(number(each, letters or {}) for each in answer.exact)
        else:
            value = number(answer.exact, letters or {})
        if answer.decimal is not None:
            assert close(value, answer.decimal), (answer.exact, answer.decimal)
        found.append(value)
    return found


def single(solution: Solution, text: str, letters: dict[str, float] | None = None) -> Any:
    found = values(solution[text], letters)
    assert len(found) == 1, f"{text}: {[a.display for a in solution[text].answers]}"
    return found[0]


def close(a: Any, b: Any, tolerance: float = 1e-8) -> bool:
    if isinstance(a, tuple):
        if not isinstance(b, tuple):
            return False
        return all(close(x, y, tolerance) for x, y in zip(a, b, strict=True))
    return abs(float(a) - float(b)) <= tolerance * (1 + abs(float(a)))


def same_angle(a: float, b: float) -> bool:
    return abs(math.remainder(a - b, math.tau)) < 1e-7


def agrees(quantity: str, a: float, b: float) -> bool:
    return same_angle(a, b) if quantity.startswith("direction") else close(a, b, 1e-7)


def solved(text: str) -> Solution:
    note(text)
    return solve(parse(text))


def as_typed(exact: str | tuple[str, str]) -> str:
    """An exact answer in the words of the statement language."""
    if isinstance(exact, tuple):
        return f"({as_typed(exact[0])}, {as_typed(exact[1])})"
    for name, word in (("atan", "arctan"), ("acos", "arccos"), ("asin", "arcsin")):
        exact = re.sub(rf"\b{name}\b", word, exact)
    return exact


# --- 1. forward -------------------------------------------------------------------------------


def checked_forward(told: Told, solution: Solution, letters: dict[str, float]) -> None:
    mass, speed = letters.get("m", 1.0), letters.get("u", 1.0)
    for name in told.tale.velocities:
        vx, vy = map(float, told.velocity(name))
        assert close(single(solution, f"velocity({name})", letters), (vx * speed, vy * speed))
        assert close(single(solution, f"speed({name})", letters), told.speed(name) * speed)
    struck = [told.tale.blows[-1].first]
    if not told.tale.blows[-1].wall:
        struck.append(told.tale.blows[-1].second)
    assert close(single(solution, "impulse", letters), told.impulse() * mass * speed)
    for name in struck:
        jx, jy = map(float, told.blow(name))
        got = single(solution, f"impulse({name})", letters)
        assert close(got, (jx * mass * speed, jy * mass * speed))
        if told.speed(name, -2) > 1e-6 and told.speed(name) > 1e-6:
            assert abs(single(solution, f"deflection({name})") - told.deflection(name)) < 1e-7
    joules = mass * speed**2
    last = float(told.energy_lost())
    total = float(told.energy(0) - told.energy())
    assert close(single(solution, "energy_lost", letters), last * joules)
    assert close(single(solution, "total_energy_lost", letters), total * joules)
    assert close(single(solution, "energy", letters), float(told.energy()) * joules)


def asked(told: Told) -> list[str]:
    names = list(told.tale.velocities)
    items = [f"{kind}({name})" for name in names for kind in ("velocity", "speed")]
    struck = [n for n in (told.tale.blows[-1].first, told.tale.blows[-1].second) if n in names]
    items += ["impulse", *(f"impulse({name})" for name in struck)]
    items += [
        f"deflection({n})" for n in struck if told.speed(n, -2) > 1e-6 and told.speed(n) > 1e-6
    ]
    return [*items, "energy_lost", "total_energy_lost", "energy"]


def can_happen(tale: Tale) -> Told:
    told = tell(tale)
    assume(told is not None)
    assert told is not None
    return told


@examples(30)
@given(strategies.tales())
def test_numbers_agree_with_the_principles(tale: Tale) -> None:
    told = can_happen(tale)
    solution = solved(told.tale.statement("find " + ", ".join(asked(told))))
    checked_forward(told, solution, {"r": SCALE["r"]})


@examples(25)
@given(strategies.tales(letters=True))
def test_letters_agree_with_the_principles(tale: Tale) -> None:
    told = can_happen(tale)
    solution = solved(told.tale.statement("find " + ", ".join(asked(told))))
    checked_forward(told, solution, SCALE)


@examples(30)
@given(strategies.tales(exact=True, letters=True))
def test_momentum_is_conserved_and_no_energy_is_gained(tale: Tale) -> None:
    told = can_happen(tale)
    number_of = range(1, len(tale.blows) + 1)
    items = [f"energy_lost({n})" for n in number_of] + [f"impulse({n})" for n in number_of]
    items += [f"momentum({stage})" for stage in range(len(tale.blows) + 1)]
    solution = solved(told.tale.statement("find " + ", ".join(items)))
    for n, blow in enumerate(tale.blows, 1):
        lost = symbolic(solution[f"energy_lost({n})"].answers[0].exact)
        assert float(lost.subs(dict.fromkeys(lost.free_symbols, 1))) >= 0
        # in exact arithmetic, so these are equalities: nothing is lost where and only where e = 1
        assert (lost == 0) == (blow.e.value == 1)
        assert single(solution, f"impulse({n})", SCALE) > 0
        if not blow.wall:
            before, after = (solution[f"momentum({k})"].answers[0].exact for k in (n - 1, n))
            assert all(sp.expand(symbolic(a) - symbolic(b)) == 0 for a, b in zip(before, after))
    assert told.energy() <= told.energy(0)


@examples(25)
@given(strategies.tales(most=1, exact=True, letters=True))
def test_an_unknown_e_stays_in_the_answer_as_a_letter(tale: Tale) -> None:
    told = can_happen(tale)
    open_blow = dataclasses.replace(told.tale.blows[0], e=Said("", tale.blows[0].e.value))
    opened = dataclasses.replace(told.tale, blows=(open_blow,))
    items = ["velocity(A)", "impulse", "energy_lost", "speed(A)"]
    solution = solved(opened.statement("find " + ", ".join(items)))
    letters = SCALE | {"e": float(tale.blows[0].e.value)}
    vx, vy = (float(x) * SCALE["u"] for x in told.velocity("A"))
    joules = SCALE["m"] * SCALE["u"] ** 2
    assert close(single(solution, "velocity(A)", letters), (vx, vy))
    assert close(single(solution, "speed(A)", letters), told.speed("A") * SCALE["u"])
    assert close(single(solution, "impulse", letters), told.impulse() * SCALE["m"] * SCALE["u"])
    assert close(single(solution, "energy_lost", letters), float(told.energy_lost()) * joules)


# --- 2. what was given is forgotten, and found again ------------------------------------------


@dataclass(frozen=True)
class Hidden:
    """One datum taken out of a tale: what to ask for, its value, and the tale for another one."""

    ask: str
    value: float
    tale: Tale
    instead: Callable[[float], Tale]


def with_velocity(tale: Tale, name: str, velocity: Said) -> Tale:
    return dataclasses.replace(tale, velocities=tale.velocities | {name: velocity})


def with_blow(tale: Tale, **changes: Any) -> Tale:
    blow = dataclasses.replace(tale.blows[0], **changes)
    return dataclasses.replace(tale, blows=(blow, *tale.blows[1:]))


def hide_e(draw: st.DrawFn, tale: Tale) -> Hidden:
    text = draw(st.sampled_from(["", "f"]))
    value = float(tale.blows[0].e.value)

    def instead(x: float) -> Tale:
        return with_blow(tale, e=Said(text, x))

    return Hidden(text or "e", value, instead(value), instead)


def hide_mass(draw: st.DrawFn, tale: Tale) -> Hidden:
    name = draw(st.sampled_from(sorted(tale.masses)))
    value = float(tale.masses[name].value)

    def instead(x: float) -> Tale:
        return dataclasses.replace(tale, masses=tale.masses | {name: Said("m", x)})

    return Hidden("m", value, instead(value), instead)


def hide_speed(draw: st.DrawFn, tale: Tale) -> Hidden:
    """The velocity is u times a known vector, or u at a known angle."""
    name = tale.blows[0].first
    if draw(st.booleans()):
        degrees = draw(st.sampled_from(strategies.DEGREES))
        text, way = f"u at {degrees}°", strategies.by_angle(1, degrees)
    else:
        exact = draw(st.tuples(strategies.halves(), strategies.halves()).filter(all))
        text, way = strategies.in_words(exact, "u"), exact
    value = float(draw(strategies.halves(1, 6)))

    def instead(x: float) -> Tale:
        return with_velocity(tale, name, Said(text, (x * way[0], x * way[1])))

    return Hidden("u", value, instead(value), instead)


ACUTE = (30.0, 45.0, 60.0, math.degrees(math.atan(3 / 4)), math.degrees(math.atan(12 / 5)))


def hide_angle(draw: st.DrawFn, tale: Tale) -> Hidden:
    """The direction of motion is an acute angle from i, from -i or from j."""
    name = tale.blows[0].first
    size = draw(strategies.halves(1, 6))
    turn = draw(st.sampled_from([0, 180, 90]))
    origin = {0: "", 180: " from -i", 90: " from j"}[turn]
    text = f"{size} at alpha{origin}"
    value = math.radians(draw(st.sampled_from(ACUTE)))

    def instead(x: float) -> Tale:
        return with_velocity(
            tale, name, Said(text, strategies.by_angle(size, turn + math.degrees(x)))
        )

    return Hidden("alpha", value, instead(value), instead)


def hide_component(draw: st.DrawFn, tale: Tale) -> Hidden:
    """One component of a velocity, of either sign."""
    name = tale.blows[0].first
    known = draw(strategies.halves().filter(bool))
    value = float(draw(strategies.halves().filter(bool)))
    sideways = draw(st.booleans())
    text = f"(p, {known})" if sideways else f"{known} i + p j"

    def instead(x: float) -> Tale:
        return with_velocity(tale, name, Said(text, (x, known) if sideways else (known, x)))

    return Hidden("p", value, instead(value), instead)


def hide_line(draw: st.DrawFn, tale: Tale) -> Hidden:
    """The line of centres, or the wall, is at an acute angle to i."""
    value = math.radians(draw(st.sampled_from(ACUTE)))

    def instead(x: float) -> Tale:
        along = Said("theta", (math.cos(x), math.sin(x)))
        return with_blow(tale, along=along, offset=None)

    return Hidden("theta", value, instead(value), instead)


def of_results(told: Told) -> dict[str, float]:
    """Numbers that may be stated of a tale told."""
    found = {"energy_lost": float(told.energy_lost()), "impulse": told.impulse()}
    for name in told.stages[-1]:
        vx, vy = map(float, told.velocity(name))
        found[f"speed({name})"] = math.hypot(vx, vy)
        found[f"along(velocity({name}), i)"] = vx
        found[f"along(velocity({name}), 3i + 4j)"] = (3 * vx + 4 * vy) / 5
        if math.hypot(vx, vy) > 1e-6:
            found[f"direction({name})"] = math.atan2(vy, vx)
        struck = name in (told.tale.blows[-1].first, told.tale.blows[-1].second)
        if struck and told.speed(name, -2) > 1e-6 and told.speed(name) > 1e-6:
            found[f"deflection({name})"] = told.deflection(name)
    return found


def result(tale: Tale, text: str) -> float | None:
    told = tell(tale)
    if told is None or told.tale.blows != tale.blows:
        return None
    return of_results(told).get(text)


HIDE = [hide_e, hide_mass, hide_speed, hide_angle, hide_component, hide_line]
STATED = [
    "speed(A)",
    "along(velocity(A), i)",
    "along(velocity(A), 3i + 4j)",
    "direction(A)",
    "deflection(A)",
    "impulse",
    "energy_lost",
    "speed(B)",
    "direction(B)",
]


@pytest.mark.parametrize("hide", HIDE, ids=lambda hide: hide.__name__)
@examples(20)
@given(data=st.data())
def test_a_forgotten_datum_is_found_again(hide: Any, data: st.DataObject) -> None:
    tale = data.draw(strategies.tales(most=2, exact=True))
    hidden = data.draw(st.composite(lambda draw: hide(draw, tale))())
    told = can_happen(hidden.tale)
    assume(told.tale.blows == hidden.tale.blows)
    possible = of_results(told)
    stated = data.draw(st.sampled_from([each for each in STATED if each in possible]))
    # the datum must matter: otherwise there is nothing to find it by
    near = [result(hidden.instead(hidden.value * x), stated) for x in (0.93, 0.97)]
    assume(all(x is not None and abs(x - possible[stated]) > 1e-4 for x in near))

    # the exact result, from a tale in which the hidden datum is told in words
    words = exact_words(hidden)
    forward = solved(words.statement(f"find {stated}"))
    assert agrees(stated, single(forward, stated), possible[stated])
    fact = as_typed(forward[stated].answers[0].exact)
    back = solved(hidden.tale.statement(f"given {stated} = {fact}", f"find {hidden.ask}"))
    found = values(back[hidden.ask])
    assert any(close(x, hidden.value, 1e-7) for x in found), (found, hidden.value)
    for x in found:
        again = tell(hidden.instead(x))
        assert again is not None, f"{hidden.ask} = {x} cannot happen"
        assert agrees(stated, of_results(again)[stated], possible[stated])


def exact_words(hidden: Hidden) -> Tale:
    """The tale with the value written for the letter."""
    values_known = {30: "30°", 45: "45°", 60: "60°"}
    degrees = round(math.degrees(hidden.value), 6)
    if hidden.ask in ("alpha", "theta"):
        word = values_known.get(round(degrees)) if degrees == round(degrees) else None
        tangent = Fraction(math.tan(hidden.value)).limit_denominator(100)
        written = word or f"arctan({tangent})"
    else:
        written = str(Fraction(hidden.value).limit_denominator(1000))

    def put(text: str) -> str:
        return re.sub(rf"\b{hidden.ask}\b", f"({written})" if "°" not in written else written, text)

    tale = hidden.tale
    blow = tale.blows[0]
    e = put(blow.e.text) or (written if hidden.ask == "e" else "")
    blow = dataclasses.replace(
        blow, e=Said(e, blow.e.value), along=Said(put(blow.along.text), blow.along.value)
    )
    return Tale(
        {k: Said(put(x.text), x.value) for k, x in tale.masses.items()},
        {k: Said(put(x.text), x.value) for k, x in tale.velocities.items()},
        (blow, *tale.blows[1:]),
    )


@examples(25)
@given(strategies.tales(most=1, exact=True))
def test_the_line_of_centres_is_found_from_a_velocity_after(tale: Tale) -> None:
    told = can_happen(tale)
    blow = told.tale.blows[0]
    after = as_typed(tuple(map(str, told.velocity(blow.first))))
    hidden = dataclasses.replace(blow, along=Said("", None), e=Said("", None))
    ask = [f"direction({blow.second})"] if blow.wall else ["line_of_centres"]
    # the line follows from the change of velocity, and e from the line
    if not blow.wall:
        ask.append(f"velocity({blow.second})")
    text = dataclasses.replace(told.tale, blows=(hidden,)).statement(
        f"given velocity({blow.first}) = {after}", "find e, " + ", ".join(ask)
    )
    back = solved(text)
    assert close(single(back, "e"), float(blow.e.value))
    normal = single(back, ask[0])
    if blow.wall:
        assert abs(dot(normal, told.normals[0])) < 1e-8 * math.hypot(*normal)
    else:
        assert close(normal, told.normals[0])
        assert close(single(back, ask[1]), tuple(map(float, told.velocity(blow.second))))


@examples(25)
@given(strategies.tales(most=2, exact=True))
def test_velocities_before_are_found_from_velocities_after(tale: Tale) -> None:
    assume(all(blow.e.value > 0 for blow in tale.blows))  # e = 0 forgets the velocities
    told = can_happen(tale)
    names = list(told.tale.velocities)
    facts = [f"velocity({n}) = {as_typed(tuple(map(str, told.velocity(n))))}" for n in names]
    masses_only = {name: Said("", None) for name in names}
    back = solved(
        dataclasses.replace(told.tale, velocities=masses_only).statement(
            "given " + ", ".join(facts), "find " + ", ".join(f"velocity({n}, 0)" for n in names)
        )
    )
    for name in names:
        before = tuple(map(float, told.velocity(name, 0)))
        assert close(single(back, f"velocity({name}, 0)"), before)


@examples(20)
@given(strategies.tales(most=2, exact=True), st.data())
def test_a_forgotten_component_is_found_from_a_velocity_after(
    tale: Tale, data: st.DataObject
) -> None:
    """Two equations for one unknown, that agree."""
    hidden = data.draw(st.composite(lambda draw: hide_component(draw, tale))())
    told = can_happen(hidden.tale)
    assume(told.tale.blows == hidden.tale.blows)
    name = tale.blows[0].first
    moved = tell(hidden.instead(hidden.value * 1.01))
    assume(moved is not None and not close(told.velocity(name), moved.velocity(name), 1e-4))
    words = exact_words(hidden)
    forward = solved(words.statement(f"find velocity({name})"))
    fact = as_typed(forward[f"velocity({name})"].answers[0].exact)
    back = solved(hidden.tale.statement(f"given velocity({name}) = {fact}", "find p"))
    assert any(close(x, hidden.value) for x in values(back["p"]))


@pytest.mark.parametrize("hide", HIDE[1:-1], ids=lambda hide: hide.__name__)
@examples(8)
@given(data=st.data())
def test_two_forgotten_data_are_found_from_two_results(hide: Any, data: st.DataObject) -> None:
    """The coefficient of restitution, and another datum."""
    tale = data.draw(strategies.tales(most=1, exact=True))
    hidden = data.draw(st.composite(lambda draw: hide(draw, tale))())
    told = can_happen(hidden.tale)
    assume(told.tale.blows == hidden.tale.blows)
    possible = of_results(told)
    usable = [each for each in STATED if each in possible]
    first, second = data.draw(st.permutations(usable))[:2]
    # roots of 3 beside a line at arctan(4/3) make numbers that no question has
    assume(hidden.ask != "alpha" or round(math.degrees(hidden.value), 6) not in (30, 45, 60))
    e = tale.blows[0].e.value
    f = float(e)

    def both(x: float, y: float) -> Tale:
        return with_blow(hidden.instead(x), e=Said("", y))

    # neither datum alone, nor one in place of the other, explains the results: Jacobian not 0
    slopes = []
    for x, y in ((hidden.value * 1.001, f), (hidden.value, f * 0.999 + 0.0005)):
        moved = tell(both(x, y))
        assume(moved is not None and moved.tale.blows == both(x, y).blows)
        now = of_results(moved)
        slopes.append([_moved_by(q, now[q] - possible[q]) * 1000 for q in (first, second)])
    assume(abs(cross(slopes[0], slopes[1])) > 1e-2)
    forward = solved(exact_words(hidden).statement(f"find {first}, {second}"))
    facts = ", ".join(f"{q} = {as_typed(forward[q].answers[0].exact)}" for q in (first, second))
    back = solved(both(hidden.value, f).statement(f"given {facts}", f"find {hidden.ask}, e"))
    xs, ys = values(back[hidden.ask]), values(back["e"])
    # an answer that several solutions share is listed once: all pairs, then, that fit
    pairs = [(x, y) for x in xs for y in ys if explains(both(x, y), (first, second), possible)]
    assert any(close(x, hidden.value, 1e-7) and close(y, f, 1e-7) for x, y in pairs), (xs, ys)
    assert {x for x, _ in pairs} == set(xs) and {y for _, y in pairs} == set(ys)


def _moved_by(quantity: str, gap: float) -> float:
    """By how much a result has moved; a direction of 180° is that of −180°."""
    return math.remainder(gap, 2 * math.pi) if quantity.startswith("direction") else gap


def explains(tale: Tale, stated: tuple[str, ...], wanted: dict[str, float]) -> bool:
    told = tell(tale)
    if told is None:
        return False
    got = of_results(told)
    return all(q in got and agrees(q, got[q], wanted[q]) for q in stated)


@examples(15)
@given(
    strategies.tales(most=1, exact=True).filter(lambda tale: not tale.blows[0].wall),
    st.sampled_from([Fraction(3, 5), Fraction(4, 5), Fraction(-3, 5)]),  # rational cosines
    st.data(),
)
def test_a_forgotten_offset_is_found_again(
    tale: Tale, share: Fraction, data: st.DataObject
) -> None:
    """Told to be to the left (d) or to the right (-d)."""
    sign = "" if share > 0 else "-"

    def instead(x: float) -> Tale:
        return with_blow(tale, offset=Said(f"{sign}d", math.copysign(x, share)))

    told = can_happen(instead(abs(share)))
    possible = of_results(told)
    stated = data.draw(st.sampled_from([each for each in STATED if each in possible]))
    near = [of_results(can_happen(instead(abs(share) * x)))[stated] for x in (0.93, 0.97)]
    assume(all(abs(x - possible[stated]) > 1e-4 for x in near))
    written = with_blow(tale, offset=Said(f"{2 * share} r", share))
    forward = solved(written.statement(f"find {stated}"))
    fact = as_typed(forward[stated].answers[0].exact)
    back = solved(instead(abs(share)).statement(f"given {stated} = {fact}", "find d"))
    found = [x / 2 / SCALE["r"] for x in values(back["d"], SCALE)]
    assert any(close(x, abs(share), 1e-7) for x in found), found
    for x in found:
        assert agrees(stated, of_results(can_happen(instead(x)))[stated], possible[stated])


# --- 3. what does not depend on the axes, the units or the frame ------------------------------


@dataclass(frozen=True)
class Change:
    """A change of axes, units or frame, of velocities and of directions; exact."""

    name: str
    matrix: tuple[tuple[Fraction, Fraction], tuple[Fraction, Fraction]]
    factor: Fraction = Fraction(1)
    mass: Fraction = Fraction(1)

    def turned(self, v: Pair) -> Pair:
        (a, b), (c, d) = self.matrix
        return a * v[0] + b * v[1], c * v[0] + d * v[1]

    def velocity(self, v: Pair) -> Pair:
        x, y = self.turned(v)
        return self.factor * x, self.factor * y

    def tale(self, tale: Tale) -> Tale:
        velocities, masses = {}, {}
        for name, velocity in tale.velocities.items():
            value = self.velocity(velocity.value)
            velocities[name] = said(value) if velocity.text != "at rest" else velocity
            masses[name] = said(self.mass * tale.masses[name].value)
        blows = tuple(
            dataclasses.replace(blow, along=said(self.turned(blow.along.value)))
            for blow in tale.blows
        )
        return Tale(masses, velocities, blows)


F = Fraction
CHANGES = [
    Change("turned by 90 degrees", ((F(0), F(-1)), (F(1), F(0)))),
    Change("turned by arctan(4/3)", ((F(3, 5), F(-4, 5)), (F(4, 5), F(3, 5)))),
    Change("turned by 180 degrees", ((F(-1), F(0)), (F(0), F(-1)))),
    Change("reflected in the axis of i", ((F(1), F(0)), (F(0), F(-1)))),
    Change("reflected in 4i + 3j", ((F(7, 25), F(24, 25)), (F(24, 25), F(-7, 25)))),
    Change("in other units", ((F(1), F(0)), (F(0), F(1))), F(7, 2), F(3, 5)),
]
changes = pytest.mark.parametrize("change", CHANGES, ids=lambda change: change.name)


@changes
@examples(8)
@given(tale=strategies.tales(exact=True))
def test_answers_change_with_the_axes_and_the_units(change: Change, tale: Tale) -> None:
    told = can_happen(tale)
    items = asked(told)
    before = solved(told.tale.statement("find " + ", ".join(items)))
    after = solved(change.tale(told.tale).statement("find " + ", ".join(items)))
    for item in items:
        x, y = single(before, item), single(after, item)
        kind = item.partition("(")[0]
        if kind in ("velocity", "impulse") and isinstance(x, tuple):
            x = tuple(map(float, change.velocity(x)))
        elif kind in ("speed", "impulse"):
            x *= float(change.factor)
        elif "energy" in kind:
            x *= float(change.factor**2 * change.mass)
        if kind == "impulse":
            x = plus((0, 0), x, float(change.mass)) if isinstance(x, tuple) else x * change.mass
        assert close(x, y), item


@changes
@examples(8)
@given(tale=strategies.tales(most=2, exact=True), data=st.data())
def test_what_is_found_does_not_depend_on_the_axes_or_the_units(
    change: Change, tale: Tale, data: st.DataObject
) -> None:
    """As many answers, and the same, in every frame: here for e, or for one of the masses."""
    told = can_happen(tale)
    possible = [each for each in of_results(told) if not each.startswith(("along", "direction"))]
    stated = data.draw(st.sampled_from(sorted(possible)))
    forward = solved(told.tale.statement(f"find {stated}"))
    fact = symbolic(forward[stated].answers[0].exact)
    power = {"speed": 1, "impulse": 1, "energy_lost": 2, "deflection": 0}[stated.partition("(")[0]]
    masses = 1 if stated in ("impulse", "energy_lost") else 0
    factor = change.factor**power * change.mass**masses
    there = fact * sp.Rational(factor.numerator, factor.denominator)
    hide = data.draw(st.sampled_from([*told.tale.masses, "e"]))

    def hidden(tale: Tale) -> Tale:
        if hide == "e":
            return with_blow(tale, e=Said("", None))
        return dataclasses.replace(tale, masses=tale.masses | {hide: Said("k", None)})

    ask = "e" if hide == "e" else "k"
    here = solve_either(
        hidden(told.tale).statement(f"given {stated} = {as_typed(str(fact))}", f"find {ask}"), ask
    )
    moved = solve_either(
        hidden(change.tale(told.tale)).statement(
            f"given {stated} = {as_typed(str(there))}", f"find {ask}"
        ),
        ask,
    )
    unit = float(change.mass) if ask == "k" else 1.0
    assert isinstance(here, str) == isinstance(moved, str), (here, moved)
    if isinstance(here, str) or isinstance(moved, str):
        assert here == moved
    else:
        assert len(here) == len(moved)
        assert all(close(x * unit, y, 1e-7) for x, y in zip(sorted(here), sorted(moved)))


def solve_either(text: str, ask: str) -> list[float] | str:
    """The answers, or the kind of error: the datum asked for may not matter at all."""
    item = solved(text)[ask]
    return item.error.kind if item.error is not None else values(item)


@examples(25)
@given(
    strategies.tales(most=1, exact=True).filter(lambda tale: not tale.blows[0].wall),
    st.tuples(strategies.halves(), strategies.halves()),
)
def test_the_impact_of_two_spheres_is_the_same_in_a_moving_frame(tale: Tale, shift: Pair) -> None:
    told = can_happen(tale)
    shifted = {n: said(plus(v.value, shift)) for n, v in tale.velocities.items()}
    there = can_happen(dataclasses.replace(tale, velocities=shifted))
    items = ["impulse", "impulse(A)", "energy_lost", "velocity(A)", "velocity(B)"]
    a, b = (solved(each.tale.statement("find " + ", ".join(items))) for each in (told, there))
    for item in items:
        x, y = single(a, item), single(b, item)
        assert close(plus(x, shift) if item.startswith("velocity") else x, y), item


@changes
@examples(6)
@given(
    start=st.tuples(strategies.halves(), strategies.halves(1, 6)),
    velocity=st.tuples(strategies.halves(), strategies.halves(1, 6)),
    e=strategies.coefficients().filter(bool),
)
def test_places_and_times_change_with_the_axes_and_the_units(
    change: Change, start: Pair, velocity: Pair, e: Fraction
) -> None:
    """A ball to the wall through O along i, and on for 2 seconds; lengths scale as speeds do."""
    falling = (velocity[0], -velocity[1])

    def text(at: Pair, v: Pair, along: Pair) -> str:
        return (
            f"wall W: along {said(along).text}, through (0, 0)\n"
            f"sphere P: at {said(at).text}, velocity {said(v).text}\n"
            f"P hits W: e = {e}\n"
            "find time(1), position(P, 1), distance(P, (0, 0), at T)\n"
        ).replace("at T)", f"at {start[1] / velocity[1] + 2})")

    here = solved(text(start, falling, (F(1), F(0))))
    there = solved(
        text(change.velocity(start), change.velocity(falling), change.turned((F(1), F(0))))
    )
    arrival = float(start[1] / velocity[1])
    place = float(start[0] + velocity[0] * start[1] / velocity[1]), 0.0
    later = place[0] + 2 * float(velocity[0]), 2 * float(e * velocity[1])
    distance = f"distance(P, (0, 0), at {start[1] / velocity[1] + 2})"
    assert close(single(here, "time(1)"), arrival)
    assert close(single(there, "time(1)"), arrival)
    assert close(single(here, "position(P, 1)"), place)
    assert close(single(there, "position(P, 1)"), tuple(map(float, change.velocity(place))))
    assert close(single(here, distance), math.hypot(*later))
    assert close(single(there, distance), math.hypot(*later) * float(change.factor))


# --- 4. time reversed -------------------------------------------------------------------------


@examples(20)
@given(strategies.tales(exact=True))
def test_perfectly_elastic_impacts_run_backwards(tale: Tale) -> None:
    one = said(Fraction(1))
    elastic = tuple(dataclasses.replace(blow, e=one) for blow in tale.blows)
    told = can_happen(dataclasses.replace(tale, blows=elastic))
    names = list(told.tale.velocities)
    items = "find " + ", ".join(f"velocity({name})" for name in names)
    forward = solved(told.tale.statement(items))
    reversed_velocities = {}
    for name in names:
        x, y = (sp.Rational(each) for each in forward[f"velocity({name})"].answers[0].exact)
        reversed_velocities[name] = said((Fraction(str(-x)), Fraction(str(-y))))
    back = can_happen(Tale(tale.masses, reversed_velocities, told.tale.blows[::-1]))
    backward = solved(back.tale.statement(items))
    for name in names:
        x, y = tale.velocities[name].value
        assert close(single(backward, f"velocity({name})"), (float(-x), float(-y)))


# --- 5. written and read again ----------------------------------------------------------------


@examples(15)
@given(st.booleans().flatmap(lambda letters: strategies.tales(letters=letters)))
def test_a_statement_written_and_read_again_is_solved_alike(tale: Tale) -> None:
    told = can_happen(tale)
    text = told.tale.statement("find " + ", ".join(asked(told)))
    problem = parse(text)
    written = to_statement(problem)
    note(written)
    again = parse(written)
    assert again == problem
    assert to_statement(again) == written
    one, other = solve(problem), solve(again)
    for (_, a), (_, b) in zip(one.items(), other.items(), strict=True):
        assert a.error is None and b.error is None
        assert [x.exact for x in a.answers] == [x.exact for x in b.answers]


# --- 6. ranges and extrema, against sampling --------------------------------------------------


def intervals(item: ItemResult) -> list[tuple[float, float, bool, bool]]:
    """The pieces of a range in floats: both ends, and whether each belongs to it."""
    assert item.error is None, f"{item.text}: {item.error}"
    assert len(item.answers) == 1
    whole = symbolic(item.answers[0].exact)
    whole = sp.FiniteSet(*whole) if isinstance(whole, set) else whole  # SymPy prints {0}
    pieces = whole.args if isinstance(whole, sp.Union) else [whole]
    found = []
    for piece in pieces:
        if isinstance(piece, sp.FiniteSet):
            found += [(float(x), float(x), True, True) for x in piece]
        elif isinstance(piece, sp.Interval):
            low, high = float(piece.start), float(piece.end)
            found.append((low, high, not piece.left_open, not piece.right_open))
    return found


def inside(x: float, pieces: list[tuple[float, float, bool, bool]]) -> bool:
    return any(
        low < x < high or (x == low and closed) or (x == high and shut)
        for low, high, closed, shut in pieces
    )


def checked_range(
    text: str, ask: str, admissible: Callable[[Fraction], bool], grid: list[Fraction]
) -> None:
    """Every sampled value is in the range if and only if it can happen.

    Where nothing on the grid can happen, the range is empty or is refused as impossible.
    """
    item = solved(text)[f"range of {ask}"]
    wanted = {x: admissible(x) for x in grid}
    if item.error is not None:
        assert item.error.kind in ("impossible", "contradiction"), str(item.error)
        assert not any(wanted.values()), (str(item.error), [x for x in grid if wanted[x]])
        return
    pieces = intervals(item)
    # a rational end of the range decides by itself, on the very edge
    edges = [e for piece in pieces for e in piece[:2] if math.isfinite(e)]
    exact = {Fraction(e).limit_denominator(10**6) for e in edges}
    ends = {x for x in exact if any(abs(float(x) - e) < 1e-15 for e in edges) and x >= 0}
    for x in sorted({*grid, *ends}):
        close_to_an_end = any(abs(float(x) - e) < 1e-9 for e in edges)
        if close_to_an_end and x not in ends:
            continue
        expected = wanted.get(x, admissible(x))
        assert inside(float(x), pieces) == expected, (item.answers[0].display, x, expected)


UP_TO_ONE = [Fraction(k, 24) for k in range(25)]
POSITIVE = [Fraction(k, 8) for k in range(1, 40)] + [Fraction(k) for k in (6, 8, 12, 50)]
LIMITS = {"<": Fraction.__lt__, "<=": Fraction.__le__, ">": Fraction.__gt__, ">=": Fraction.__ge__}
signs = st.sampled_from(sorted(LIMITS))


def with_e(tale: Tale, e: Fraction) -> Tale:
    return dataclasses.replace(
        tale, blows=tuple(dataclasses.replace(blow, e=Said("e", e)) for blow in tale.blows)
    )


@examples(30)
@given(strategies.tales(most=2, exact=True), signs, st.sampled_from(strategies.HEADINGS), st.data())
def test_range_of_e_for_the_sense_of_a_component(
    tale: Tale, sign: str, heading: tuple[int, int], data: st.DataObject
) -> None:
    """One e for all impacts; the component of a velocity along some line has a given sign."""
    told = can_happen(with_e(tale, Fraction(1, 2)))
    name = data.draw(st.sampled_from(sorted(told.stages[0])))

    def admissible(e: Fraction) -> bool:
        now = tell(with_e(told.tale, e))
        if now is None or now.tale.blows != with_e(told.tale, e).blows:
            return False
        return LIMITS[sign](Fraction(dot(now.velocity(name), heading)), Fraction(0))

    component = f"along(velocity({name}), {said(heading).text})"
    text = told.tale.statement(f"given {component} {sign} 0", "find range of e")
    checked_range(text, "e", admissible, UP_TO_ONE)


@examples(20)
@given(strategies.tales(most=1, exact=True), signs, st.integers(1, 7))
def test_range_of_e_for_the_fraction_of_energy_lost(tale: Tale, sign: str, eighths: int) -> None:
    told = can_happen(with_e(tale, Fraction(1, 2)))

    def admissible(e: Fraction) -> bool:
        now = can_happen(with_e(told.tale, e))
        return LIMITS[sign](now.energy_lost(), Fraction(eighths, 8) * now.energy(0))

    fact = f"given energy_lost {sign} {eighths}/8 energy(0)"
    checked_range(told.tale.statement(fact, "find range of e"), "e", admissible, UP_TO_ONE)


@examples(20)
@given(strategies.tales(most=1, exact=True), st.data())
def test_range_of_a_mass_for_the_sense_of_a_component(tale: Tale, data: st.DataObject) -> None:
    told = can_happen(tale)
    assume(not told.tale.blows[0].wall)
    name, other = data.draw(st.permutations(["A", "B"]))
    sign, heading = data.draw(signs), told.tale.blows[0].along.value

    def massive(k: Fraction) -> Tale:
        return dataclasses.replace(
            told.tale, masses=told.tale.masses | {other: Said("k", Fraction(k))}
        )

    def admissible(k: Fraction) -> bool:
        if k <= 0:
            return False
        component = dot(can_happen(massive(k)).velocity(name), heading)
        return LIMITS[sign](Fraction(component), Fraction(0))

    component = f"along(velocity({name}), {said(heading).text})"
    text = massive(Fraction(1)).statement(f"given {component} {sign} 0", "find range of k")
    checked_range(text, "k", admissible, POSITIVE)


masses = strategies.halves(1, 6)
speeds = strategies.halves(1, 6)


@examples(20)
@given(masses, masses, speeds, strategies.halves(0, 3), st.booleans(), st.booleans())
def test_range_of_e_for_a_second_impact_after_a_wall(
    m1: Fraction, m2: Fraction, u: Fraction, w: Fraction, again: bool, one: bool
) -> None:
    """A strikes B, B strikes the wall: run on the line, the wall at the distance 1.

    The coefficient at the wall is f, data, or e again.
    """
    assume(u > w)
    f = None if one else Fraction(2, 3)

    def admissible(e: Fraction) -> bool:
        (v1, _), (v2, _) = collide(m1, (u, F(0)), m2, (w, F(0)), (F(1), F(0)), e)
        if v2 <= 0:
            return False  # B does not come to the wall
        back = -(e if f is None else f) * v2
        # B is at the wall at the time 1/v2, A is at v1/v2; they meet if A is the faster
        meet = v1 > back
        return meet == again

    fact = "collide again" if again else "do not collide again"
    text = (
        f"wall W: along j\nsphere A: mass {m1}, velocity {u} i\n"
        f"sphere B: mass {m2}, velocity {w} i\nA hits B: along i\n"
        f"B hits W{'' if f is None else f': e = {f}'}\ngiven A and B {fact}\nfind range of e\n"
    )
    checked_range(text, "e", admissible, UP_TO_ONE)


@examples(20)
@given(masses, masses, masses, speeds, st.booleans(), st.booleans())
def test_range_for_a_second_impact_after_a_third_sphere(
    m1: Fraction, m2: Fraction, m3: Fraction, u: Fraction, again: bool, of_e: bool
) -> None:
    """Three in line, B and C at rest; the range of e, or of the mass of C where e = 1/2."""

    def meets(e: Fraction, third: Fraction) -> bool:
        line = (F(1), F(0))
        v1, v2 = collide(m1, (u, F(0)), m2, (F(0), F(0)), line, e)
        v2, _ = collide(m2, v2, third, (F(0), F(0)), line, e)
        return bool(v1[0] > v2[0])

    fact = "collide again" if again else "do not collide again"
    e, third, ask = ("", m3, "e") if of_e else (", e = 1/2", "k", "k")
    text = (
        f"sphere A: mass {m1}, velocity {u} i\nsphere B: mass {m2}, at rest\n"
        f"sphere C: mass {third}, at rest\nA hits B: along i{e}\nB hits C: along i{e}\n"
        f"given A and B {fact}\nfind range of {ask}\n"
    )
    if of_e:
        checked_range(text, "e", lambda x: meets(x, m3) == again, UP_TO_ONE)
    else:
        half = Fraction(1, 2)
        checked_range(text, "k", lambda x: x > 0 and meets(half, x) == again, POSITIVE)


@examples(20)
@given(
    st.tuples(st.integers(1, 6), st.integers(1, 6)),
    st.tuples(st.integers(1, 4), st.integers(1, 4)),
    st.integers(1, 6),
    st.integers(1, 6),
)
def test_range_of_e_to_strike_a_second_wall(
    start: tuple[int, int], velocity: tuple[int, int], long: int, high: int
) -> None:
    """Segments on the axes, without their ends: the ball runs to the first, then to the second."""
    x, y = start
    vx, vy = velocity
    text = (
        f"wall OX: from (0, 0) to ({long}, 0)\nwall OY: from (0, 0) to (0, {high})\n"
        f"sphere P: at ({x}, {y}), velocity -{vx} i - {vy} j\n"
        "P hits OX\nP hits OY: e = f\nfind range of e\n"
    )
    first = Fraction(x) - Fraction(vx * y, vy)  # where it strikes the axis of i
    assume(0 < first < long)

    def admissible(e: Fraction) -> bool:
        return bool(0 < e * vy * first / vx < high)

    checked_range(text, "e", admissible, UP_TO_ONE)


@examples(20)
@given(strategies.tales(most=1, exact=True), st.data())
def test_range_of_a_result_where_e_is_not_known(tale: Tale, data: st.DataObject) -> None:
    """All values that a result takes as e goes from 0 to 1, and no others."""
    told = can_happen(with_e(tale, Fraction(1, 2)))
    runs = [can_happen(with_e(told.tale, Fraction(k, 40))) for k in range(41)]
    struck = told.tale.blows[0].first
    possible = ["impulse", "energy_lost", f"speed({struck})"]
    if all(struck_moves(run, struck) for run in runs):
        possible.append(f"deflection({struck})")
    wanted = data.draw(st.sampled_from(possible))
    item = solved(told.tale.statement(f"find range of {wanted}"))[f"range of {wanted}"]
    pieces = intervals(item)
    taken = [of_results(run)[wanted] for run in runs]
    assert len(pieces) == 1, "a continuous image of an interval"
    low, high = pieces[0][:2]
    size = 1 + max(map(abs, taken))
    assert all(low - 1e-9 * size <= x <= high + 1e-9 * size for x in taken)
    # between two samples a result cannot run away: it is smooth, and the steps are small
    step = max((abs(a - b) for a, b in itertools.pairwise(taken)), default=0.0) + 1e-9
    assert abs(min(taken) - low) <= step and abs(max(taken) - high) <= step


def struck_moves(told: Told, name: str) -> bool:
    return told.speed(name, -2) > 1e-3 and told.speed(name) > 1e-3


@examples(15)
@given(masses, masses, strategies.coefficients(), st.sampled_from(["deflection", "speed"]))
def test_extremum_over_the_angle_of_approach(
    m1: Fraction, m2: Fraction, e: Fraction, what: str
) -> None:
    """A, with the unit of speed, strikes B at rest at an angle to the line of centres."""
    assume(m1 != e * m2)  # else A may be at rest after a direct impact: no deflection there

    def value(angle: float) -> float:
        u = (math.cos(angle), math.sin(angle))
        v, _ = collide(float(m1), u, float(m2), (0.0, 0.0), (1.0, 0.0), float(e))
        return angle_between(u, v) if what == "deflection" else math.hypot(*v)

    samples = [value(k * math.pi / 2 / 4000) for k in range(1, 4000)]
    text = (
        f"sphere A: mass {m1}, velocity 1 at alpha\nsphere B: mass {m2}, at rest\n"
        f"A hits B: along i, e = {e}\nfind maximum of {what}(A) over alpha\n"
    )
    item = solved(text)[f"maximum of {what}(A) over alpha"]
    assert close(single_value(item), max(samples), 2e-3)
    assert single_value(item) >= max(samples) - 1e-9
    answer = item.answers[0]
    inner = max(samples) > max(samples[0], samples[-1]) + 1e-6
    assert answer.reached == inner, answer.display
    if inner:
        assert answer.where is not None
        assert close(value(number(answer.where["alpha"], {})), single_value(item))


def single_value(item: ItemResult) -> float:
    found = values(item)
    assert len(found) == 1
    return float(found[0])


GRIDS = {
    "hide_mass": POSITIVE,
    "hide_speed": POSITIVE,
    "hide_angle": [Fraction(k, 36) * Fraction(math.pi) / 2 for k in range(1, 36)],
    "hide_component": [Fraction(k, 4) for k in range(-30, 31)],
    "hide_line": [Fraction(k, 36) * Fraction(math.pi) / 2 for k in range(1, 36)],
}


@pytest.mark.parametrize("hide", HIDE[1:], ids=lambda hide: hide.__name__)
@examples(8)
@given(data=st.data())
def test_range_of_a_datum_for_an_inequality(hide: Any, data: st.DataObject) -> None:
    """A result is greater, or less, than a number: for which values of the datum?"""
    tale = data.draw(strategies.tales(most=1, exact=True))
    hidden = data.draw(st.composite(lambda draw: hide(draw, tale))())
    told = can_happen(hidden.tale)
    assume(told.tale.blows == hidden.tale.blows)
    possible = of_results(told)
    kinds = ["impulse", "energy_lost", "speed(A)", "speed(B)", "along(velocity(A), 3i + 4j)"]
    stated = data.draw(st.sampled_from([each for each in kinds if each in possible]))
    bound = Fraction(possible[stated]).limit_denominator(8)
    sign = data.draw(signs)

    def admissible(x: Fraction) -> bool | None:
        now = tell(hidden.instead(float(x)))
        if now is None or now.tale.blows != hidden.instead(float(x)).blows:
            return False
        got = of_results(now)[stated]
        # on the very edge floats do not decide
        return None if abs(got - bound) < 1e-9 else LIMITS[sign](Fraction(got), bound)

    text = hidden.tale.statement(f"given {stated} {sign} {bound}", f"find range of {hidden.ask}")
    item = solved(text)[f"range of {hidden.ask}"]
    wanted = {x: admissible(x) for x in GRIDS[hide.__name__]}
    if item.error is not None:
        assert item.error.kind in ("impossible", "contradiction"), str(item.error)
        assert not any(wanted.values()), str(item.error)
        return
    pieces = intervals(item)
    edges = [end for piece in pieces for end in piece[:2]]
    for x, expected in wanted.items():
        if expected is not None and all(abs(float(x) - end) > 1e-7 for end in edges):
            assert inside(float(x), pieces) == expected, (item.answers[0].display, float(x))
