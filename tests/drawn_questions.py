"""Questions for `printed_answers`, drawn at random: a story, a fact about it, and what is asked."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from printed_answers import Question

AFTER = "A hits B: along i\n"
AT_REST = "sphere A: mass {a}m, velocity u i\nsphere B: mass k m, at rest\n" + AFTER
OBLIQUE = "sphere A: mass {a}m, velocity u at alpha\nsphere B: mass {k} m, at rest\n" + AFTER
CORNER = (
    "wall W: along i\nwall V: along j\nsphere P: mass m, velocity u at alpha to W\n"
    "P hits W: e = e\nP hits V: e = {f}\n"
)


@dataclass(frozen=True)
class Shape:
    """Stories of one kind, what may be said of a body in them, and the letters that may vary."""

    stories: tuple[str, ...]
    facts: tuple[str, ...]
    letters: tuple[str, ...]
    quantities: tuple[str, ...] = ()


OF_WALL = (
    "speed(P) {R} {x} u",
    "energy_lost {R} {x} energy(0)",
    "impulse {R} {2x} m u",
    "deflection(P) {R} {angle}",
    "angle(velocity(P), W) {R} {acute}",
    "speed(P) {R} {x} u sin(alpha)",
    "across(velocity(P), W) {R} {x} u",
    "energy(P) {R} {x} energy(P, 0)",
)
OF_SPHERES = (
    "speed(A) {R} {x} u",
    "speed(B) {R} {2x} u",
    "speed(A) {R} {x} speed(B)",
    "energy_lost {R} {x} energy(0)",
    "energy(B) {R} {x} energy(0)",
    "energy(A) {R} {x} energy(A, 0)",
    "impulse {R} {2x} m u",
    "along(velocity(A), i) {R} {component}",
)
OF_PATHS = (
    "speed(A) {R} speed(B)",
    "deflection(A) {R} {angle}",
    "angle(velocity(A), i) {R} {angle}",
    "angle(velocity(A), velocity(B)) {R} {angle}",
    "tan(angle(velocity(A), i)) {R} {two} tan(alpha)",
)
ALIGNED = (
    "velocity(A) perpendicular to velocity(A, 0)",
    "velocity(A) perpendicular to velocity(B)",
)

SHAPES = {
    "wall": Shape(
        ("wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n",),
        OF_WALL,
        ("e", "alpha"),
        ("speed(P)", "energy_lost"),
    ),
    "direct": Shape(
        (
            AT_REST,
            "sphere A: mass {a}m, velocity {b}u i\nsphere B: mass k m, velocity -{a}u i\n" + AFTER,
            "sphere A: mass m, velocity {b}u i\nsphere B: mass k m, velocity u i\n" + AFTER,
        ),
        OF_SPHERES,
        ("e", "k"),
        ("speed(A)", "speed(B)"),
    ),
    "oblique": Shape((OBLIQUE,), OF_SPHERES + OF_PATHS, ("e", "k", "alpha"), ("energy_lost",)),
    "both moving": Shape(
        (
            "sphere A: mass {a}m, velocity u at alpha\n"
            "sphere B: mass k m, velocity {b}u at 180° - {acute}\n" + AFTER,
            "sphere A: mass {a}m, velocity u at alpha\n"
            "sphere B: mass k m, velocity {b}u j\n" + AFTER,
        ),
        OF_SPHERES + OF_PATHS,
        ("e", "k", "alpha"),
        ("speed(A)",),
    ),
    "a second impact": Shape(
        (
            AT_REST + "sphere C: mass {b}m, at rest\nB hits C: along i, e = {x}\n",
            AT_REST + "sphere C: mass {b}m, at rest\nB hits C: along i, e = e\n",
            AT_REST + "wall V: along j\nB hits V: e = f\n",
        ),
        ("A and B collide again", "A and B do not collide again"),
        ("e", "f", "k"),
    ),
    "two walls": Shape(
        (CORNER,),
        tuple(fact.replace("energy_lost", "total_energy_lost") for fact in OF_WALL),
        ("e", "f", "alpha"),
        ("speed(P)",),
    ),
}


def drawn_question(seed: int) -> Question:
    """The question of a seed, of the shapes by turns."""
    rng = random.Random(seed)
    names = [*SHAPES]
    name = names[seed % len(names)]
    shape = SHAPES[name]
    fixed = bool(shape.quantities) and rng.random() < 0.5
    facts = shape.facts + (ALIGNED if fixed and "speed(A) {R} speed(B)" in shape.facts else ())
    story, fact = (_filled(rng.choice(texts), rng, fixed) for texts in (shape.stories, facts))
    letters = _letters_of(story)
    letter = rng.choice([other for other in shape.letters if other in letters])
    data = tuple(sorted(letters - {letter}))
    asked = rng.choice((letter, *shape.quantities)) if fixed else f"range of {letter}"
    return Question(f"{seed}, {name}: {fact}", f"{story}given {fact}\n", letter, data, asked, fixed)


def _filled(text: str, rng: random.Random, is_equation: bool) -> str:
    put: dict[str, Callable[[], str]] = {
        "R": lambda: "=" if is_equation else rng.choice(("<", "<=", ">", ">=")),
        "x": lambda: _share(rng, 1),
        "2x": lambda: _share(rng, 2),
        "a": lambda: rng.choice(("", "2", "3")),
        "b": lambda: rng.choice(("2", "3", "4")),
        "k": lambda: rng.choice(("k", "k", "2")),
        "f": lambda: rng.choice(("f", _share(rng, 1))),
        "two": lambda: rng.choice(("2", "3", "3/2")),
        "acute": lambda: rng.choice(("30°", "45°", "60°")),
        "angle": lambda: rng.choice(("30°", "45°", "60°", "90°", "120°")),
        "component": lambda: rng.choice(("0", "1/4 u", "-1/4 u", "-1/2 u")),
    }
    return re.sub(r"\{(\w+)\}", lambda found: put[found[1]](), text)


def _share(rng: random.Random, most: int) -> str:
    below = rng.choice((2, 3, 4, 5, 6, 8))
    return str(Fraction(rng.randint(1, most * below - 1), below))


def _letters_of(story: str) -> set[str]:
    """The letters in a story; an impact of which no coefficient is told has e."""
    names = {name for name in ("k", "f", "alpha") if re.search(rf"(?<![a-z]){name}\b", story)}
    has_e = "e = e" in story or re.search(r"hits W\n|along i\n", story)
    return names | {"u", "m"} | ({"e"} if has_e else set())
