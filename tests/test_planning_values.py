"""Planned workings of what is asked and given: angles, vectors, blows, energies, expressions.

Each is followed line by line, and its answers are those of the solver.
"""

from __future__ import annotations

import itertools
from dataclasses import replace
from functools import cache

import pytest
import sympy as sp

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Link, Relation
from restitution.explaining.lines.notation import read_relation, read_tree, write_relation
from restitution.expression.evaluate import Evaluator
from restitution.expression.tree import Expression, Letter, Quantity, has_quantity
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import alike
from restitution.solving import solve
from restitution.solving.equations.solution import Solution
from restitution.solving.story.letters import roles
from restitution.vector import Vector

STATEMENTS = {
    "energy lost by speeds that are given": """
wall W: along j
sphere Q: mass 3m, velocity 2w at 60° to W
Q hits W
given speed(Q) = 3w/2
find e, energy_lost
""",
    "a speed that is a root of a sum of roots": """
sphere A: mass 3m, velocity 2u at 60°
sphere B: mass 2m, velocity u at 45° from -i
A hits B: along i, e = 2/3
find speed(A), speed(B), energy_lost
""",
    "a speed whose root is undone": """
wall W: along i
sphere P: mass m, velocity u at 75° to W
P hits W
given angle(velocity(P), W) = 45°
find e, speed(P)
""",
    "products, sizes and momenta": """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass 4, velocity -i + j
sphere C: mass 1, at rest
A hits B: along i, e = 1/2
find momentum(A), momentum(A, 0), momentum, momentum(0), dot(velocity(A), i + 2j)
find abs(velocity(A)), abs(velocity(A, 0) - velocity(B)), dot(velocity(A) - velocity(B), j)
""",
    "components of relative velocities": """
sphere A: mass 2, velocity 3i + j
sphere B: mass m, velocity -i + j
A hits B: along i, e = 1/2
find along(velocity(B) - velocity(A), line_of_centres), across(velocity(A) + velocity(B), i)
find along(velocity(A, 0) - velocity(B, 0), line_of_centres)
""",
    "components of relative velocities along a slanting line": """
sphere A: mass 2, velocity u i
sphere B: mass 1, at rest
A hits B: along 3i + 4j
given along(velocity(B) - velocity(A), line_of_centres) = u/5
find e, along(velocity(A, 0) - velocity(B, 0), line_of_centres)
""",
    "a product in letters": """
sphere A: mass m, velocity 2u i + u j
sphere B: mass 3m, at rest
A hits B: along i
find dot(velocity(A), velocity(B)), momentum
""",
    "deflection by a scalar product": """
sphere A: mass 3, velocity 4i + 3j
sphere B: mass 2, velocity -i + 2j
A hits B: along i, e = 2/3
find deflection(A), deflection(B)
""",
    "deflection by its tangent": """
sphere A: mass m, velocity u at 60°
sphere B: mass 2m, at rest
A hits B: along i, e = 1/2
find deflection(A), tan(deflection(A)), speed(A)/speed(B)
""",
    "deflection of a right angle": """
wall W: along i
sphere P: velocity u at 45° to W
P hits W: e = 1
find deflection(P)
""",
    "directions": """
sphere A: mass 2, velocity i + 4j
sphere B: mass 1, velocity -3i - 2j
A hits B: along i, e = 1/2
find direction(A), direction(B), angle(velocity(A), velocity(B)), angle(velocity(B), j)
""",
    "a slanting line of centres": """
sphere A: mass 2, velocity 3i + j
sphere B: mass 1, velocity -2i + 2j
A hits B: along 4i + 3j, e = 1/3
find velocity(A), velocity(B), impulse, energy_lost
""",
    "a wall of irrational length": """
wall W: along i + 3j
sphere P: mass 2, velocity 5i + j
P hits W: e = 1/2
find velocity(P), angle(velocity(P), W), impulse(P), energy_lost/energy(0) as a percentage
""",
    "a wall that is found by a change": """
wall W
sphere P: mass 2, velocity 5i + 2j
P hits W
given velocity(P) = -i + 4j
find line_of_centres, e, impulse(P)
""",
    "a wall whose direction is asked": """
wall W
sphere P: mass 2, velocity 4i + 3j
P hits W: e = 1/2
given impulse(P) parallel to i - 2j
find direction(W), velocity(P)
""",
    "equal speeds": """
sphere A: mass m, velocity u at 60°
sphere B: mass 2m, velocity v j
A hits B: along i, e = 1/2
given speed(A) = 2 speed(B)
find v
""",
    "a wall at an angle in letters": """
wall W: along theta
sphere P: mass m, velocity u i
P hits W: e = 1/2
find speed(P), tan(angle(velocity(P), W)), energy_lost
""",
    "a line of centres that is found by an impulse": """
sphere A: mass m, velocity 3u i + u j
sphere B: mass 2m, velocity -u j
A hits B
given impulse(A) = -lambda m u (2i + j), e = 1/2
find lambda, velocity(A)
""",
    "a struck sphere": """
sphere A, B: mass m
sphere A: velocity u i
sphere B: at rest
A hits B
given direction(B) = 30°, speed(B) = 3sqrt(3)/8 u
find e, speed(A)
""",
    "velocities before": """
sphere A: mass 3, velocity p i + q j
sphere B: mass 1, velocity r i + s j
A hits B: along j, e = 1/2
given velocity(A) = 2i + j, velocity(B) = -i + 4j
find velocity(A, 0), velocity(B, 0)
""",
    "a blow, then a wall": """
wall W: along 3i + 4j
sphere P: mass 2, velocity i
P receives 4i - 6j
find velocity(P), deflection(P)
P hits W: e = 1/2
find speed(P), energy(P)
""",
    "a blow that is found": """
sphere P: mass 2, velocity 3i
P receives J at theta
given velocity(P) = 4i + 2j
find impulse(P), J, tan(theta)
""",
    "energies of two impacts": """
wall W: along i
wall X: along j
sphere P: mass 3, velocity 4i - 3j
P hits W: e = 1/3
P hits X: e = 1/2
find total_energy_lost, energy(P)/energy(P, 0), momentum(P)
""",
    "directions along j": """
sphere A: mass 1, velocity 4i + 3j
sphere B: mass 2, velocity -2j
A hits B: along i, e = 1/2
find direction(A), direction(B)
""",
    "a tie to a direction": """
sphere A: mass 2, velocity 3i + 2j
sphere B: mass 3, velocity p i - j
A hits B: along i, e = 1/2
given velocity(A) parallel to i + 2j
find p, speed(B)
""",
    "a direction along j": """
sphere A: mass 2m, velocity 2u at 60°
sphere B: mass m, velocity v at 120°
A hits B: along i, e = 1/2
given direction(A) = 90°
find v, speed(B)
""",
    "letters for angles": """
wall W: along i
sphere P: mass m, velocity u at alpha to W
given tan(alpha) = 3/4
P hits W: e = 2/3
let phi = angle(velocity(P), W)
find tan(phi), phi, energy(P)/energy(0)
""",
    "sums of quantities": """
sphere A: mass m, velocity 2u i
sphere B: mass 2m, velocity -u i
A hits B: along i, e = 1/2
find speed(A) + speed(B), velocity(B) - velocity(A), mass(A)/mass(B)*speed(A)
""",
}


@cache
def _planned(text: str) -> tuple[Solution, Derivation]:
    solution = solve(parse(text))
    return solution, plan(solution)


def _value(tree: Expression, solution: Solution) -> object:
    """What the last side of an answer is worth, in the letters of the statement."""
    known = roles(solution.problem)
    field = next(iter(solution.parts.values())).branches[0].exact
    story = field if field is not None else next(iter(solution.parts.values())).branches[0].story
    evaluator = Evaluator(story.field, lambda name: known[name].symbol(name))
    return evaluator.value(tree)


def _number(x: object, solution: Solution) -> float:
    """A number for comparing, with some number put in for each letter."""
    own = sp.sympify(x, strict=True)
    put = {s: sp.Rational(7 + 3 * n, 11) for n, s in enumerate(sorted(own.free_symbols, key=str))}
    return float(own.subs(put))


def _sides(answer: Relation) -> Link:
    (links,) = answer.options
    return links[-1]


@pytest.mark.parametrize("name", STATEMENTS)
def test_planned_working_is_followed_and_ends_in_the_answers(name: str) -> None:
    solution, derivation = _planned(STATEMENTS[name])
    complaints = follow(derivation, Oracle(roles(solution.problem)))
    nowhere = [each for each in complaints if each.reason != "leads-nowhere"]
    assert not nowhere
    results = [each for part in solution.parts.values() for each in part.items]
    assert len(results) == len(derivation.items)
    for result, end in zip(results, derivation.items, strict=True):
        link = _sides(end.answer)
        if link.sign == "parallel to":
            continue
        _agrees(result.exact, link, solution)


def _agrees(exact: object, link: Link, solution: Solution) -> None:
    if has_quantity(link.right):
        pytest.fail(f"an answer in quantities: {write_relation(Relation(((link,),)))}")
    value = _value(link.right, solution)
    near = 0.005 if link.sign == "≈" else 1e-9
    if isinstance(exact, Vector | tuple):
        pairs = list(zip(exact, value, strict=True))  # type: ignore[call-overload]
    else:
        pairs = [(exact, getattr(value, "radians", value))]
    for a, b in pairs:
        if hasattr(b, "y"):
            b = sp.atan2(b.y, b.x)
        assert _number(a, solution) == pytest.approx(_number(b, solution), rel=near, abs=1e-12)


@pytest.mark.parametrize(
    ("u", "v", "e"),
    list(itertools.product(((3, 4), (5, -2)), ((-4, 1), (1, -3)), ("1/2", "2/3"))),
)
def test_directions_of_numbers_lie_in_their_quadrants(
    u: tuple[int, int], v: tuple[int, int], e: str
) -> None:
    text = f"""
sphere A: mass 2, velocity {u[0]}i + {u[1]}j
sphere B: mass 3, velocity {v[0]}i + {v[1]}j
A hits B: along i, e = {e}
find direction(A), direction(B), deflection(A)
""".replace("+ -", "- ")
    solution, derivation = _planned(text)
    complaints = follow(derivation, Oracle(roles(solution.problem)))
    assert all(each.reason == "leads-nowhere" for each in complaints)
    results = [each for part in solution.parts.values() for each in part.items]
    for result, end in zip(results, derivation.items, strict=True):
        _agrees(result.exact, _sides(end.answer), solution)


def test_a_direction_in_the_other_quadrant_is_refused() -> None:
    _, derivation = _planned(STATEMENTS["directions"])
    oracle = Oracle(roles(parse(STATEMENTS["directions"])))
    (line, *_) = [each for each in derivation.lines if each.move.id == "inverse"]
    assert isinstance(line.relation, Relation)
    link = line.relation.only[0]
    other = read_relation(f"{write_relation(line.relation)} - 180°", {"A": "sphere", "B": "sphere"})
    assert isinstance(link.left, Letter)
    wrong = replace(
        derivation,
        lines=tuple(
            replace(each, relation=other) if each.number == line.number else each
            for each in derivation.lines
        ),
    )
    reasons = {each.line for each in follow(wrong, oracle) if each.reason == "does-not-follow"}
    assert line.number in reasons


def test_products_that_differ_in_brackets_are_alike() -> None:
    def tree(text: str) -> Expression:
        return read_tree(text, {})

    assert alike(tree("e (u sin(alpha))"), tree("e u sin(alpha)"))
    assert alike(tree("sqrt(3)/2 u"), tree("sqrt(3) u/2"))
    assert alike(tree("-(2u)"), tree("-2u"))
    assert not alike(tree("1/2 (4u)"), tree("2u"))
    assert not alike(tree("u/2"), tree("2u"))
    (links,) = chain(Quantity("time"), (tree("e (2u)"), None), (tree("2e u"), "rearrange")).options
    assert len(links) == 1
