"""Labels of figures: in the simplest form, and with the letters of the working."""

from __future__ import annotations

import math
import random
from functools import cache

import pytest
import sympy as sp
from laws_of_labels import LET, check_forms, check_letters

import restitution as r
from restitution.drawing import scenes
from restitution.drawing.scene import Arc, Arrow
from restitution.exact import is_nested, tidy, tidy_angle
from restitution.examples import text
from restitution.expression import read_expression
from restitution.expression.evaluate import evaluate
from restitution.render import layout as lay
from restitution.render.short import angle_label, is_short
from restitution.render.text import to_text
from restitution.solving import Solution

# Walls and lines of centres at all angles, corners, three spheres, vectors, blows.
STATEMENTS = [
    "wall W: along theta\nsphere P: velocity u i\nP hits W: e = 1/2\nfind speed(P)",
    "wall W: along 180° - theta\nsphere P: velocity u at 30°\nP hits W\nfind speed(P)",
    "wall W: along i\nsphere P: velocity u at 180° + theta\nP hits W\nfind speed(P)",
    "wall W: along j\nsphere P: velocity u at 180° + theta\nP hits W\nfind speed(P)",
    (
        "sphere A: mass m, velocity u at 30° - alpha\nsphere B: mass 2m, at rest\n"
        "A hits B: along 30°, e = 1/2\nfind speed(A)"
    ),
    (
        "sphere A: mass m, velocity u at alpha\nsphere B: mass 2m, velocity v at 180° + beta\n"
        "A hits B: along i\nfind velocity(A)"
    ),
    (
        "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, velocity 2u at 180° - alpha\n"
        "A hits B: along j + i, e = 1/2\nfind velocity(A)"
    ),
    (
        "sphere A: mass 1, velocity 4 at 37°\nsphere B: mass 2, velocity 3 at 200°\n"
        "A hits B: along 20°, e = 0.7\nfind velocity(A)"
    ),
    (
        "sphere A: mass m, velocity u at 90° + theta\nsphere B: mass m, at rest\n"
        "A hits B: along j\nfind velocity(A)"
    ),
    (
        "sphere A: mass m, velocity u at 270° - theta\nsphere B: mass m, at rest\n"
        "A hits B: along 90°\nfind velocity(A)"
    ),
    (
        "wall V: along i\nwall W: along 60°\nsphere P: mass m, velocity u at alpha to V\n"
        "P hits V: e = sqrt(3)/3\nP hits W: e = 1/2\nfind speed(P)"
    ),
    (
        "wall V: along i\nwall W: along beta\nsphere P: mass m, velocity u at alpha to V\n"
        "P hits V: e = 1/2\nP hits W: e = 1/2\nfind speed(P)"
    ),
    (
        "wall X: along 15°\nwall Y: along 75°\nsphere P: velocity u at 30° to X\n"
        "P hits X: e = 1/4\nP hits Y: e = 1/3\nfind speed(P)"
    ),
    (
        "wall X: along i\nwall Y: along 120°\nsphere P: velocity u at 45° to X\nP hits X: e = 1/2\n"
        "P hits Y: e = 1/2\nfind speed(P)"
    ),
    (
        "sphere A, B, C: mass m\nsphere A: velocity u at alpha\nsphere B, C: at rest\n"
        "A hits B: along i\nB hits C: along 60°\nfind speed(C)"
    ),
    (
        "sphere P: mass 2, velocity 3i\nP receives 4 at 180° - theta\ngiven tan(theta) = 3/4\n"
        "find velocity(P)"
    ),
    (
        "wall W: circle centre (0, 0) radius a\nsphere P: at (0, -a/2), velocity u at alpha\n"
        "P hits W: e = 1/2\nfind speed(P)"
    ),
    (
        "wall V: along i, through (0, 0)\nwall W: along theta, through (0, 0)\n"
        "sphere P: mass m, at (5a, a), velocity u at 150° + theta\nP hits V\nfind speed(P)"
    ),
    "wall W: along i + j\nsphere P: mass m, velocity 2u i\nP hits W\nfind velocity(P)",
]
# The normal run looks at every third, the nightly one at the others.
SAMPLED = [
    pytest.param(statement, marks=() if n % 3 == 0 else pytest.mark.nightly, id=str(n))
    for n, statement in enumerate(STATEMENTS)
]


@cache
def solved(statement: str) -> Solution:
    return r.solve(r.parse(statement))


@pytest.mark.parametrize("statement", SAMPLED)
def test_labels_are_in_lowest_form(statement: str) -> None:
    check_forms(solved(statement), statement)


def test_the_letters_of_a_working_are_read() -> None:
    example = r.parse(text("two-spheres-with-vectors"))
    working = " ".join(str(r.explain(r.solve(example))).split())
    assert LET.findall(working) == [("v and w", "A", "B")]


@pytest.mark.parametrize("statement", SAMPLED)
def test_letters_of_components_are_those_of_the_working(statement: str) -> None:
    check_letters(solved(statement), str(r.explain(solved(statement))))


# --- angles ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("angle", "drawn_as", "wanted"),
    [
        ("180° + theta", "theta", "θ"),
        ("180° - theta", "theta", "θ"),
        ("90° + theta", "90° - theta", "90° − θ"),
        ("270° - theta", "90° - theta", "90° − θ"),
        ("theta", "180° - theta", "180° − θ"),
        ("-theta", "theta", "θ"),
        ("200°", "20°", "20°"),
        ("-30°", "30°", "30°"),
        ("30° - theta", "theta - 30°", "θ − 30°"),
        ("150° + theta", "theta - 30°", "θ − 30°"),
        ("pi - theta", "theta", "θ"),
        ("arctan(3/4)", "arctan(3/4)", "arctan(3/4)"),
        ("180° - arctan(3/4)", "arctan(3/4)", "arctan(3/4)"),
    ],
)
def test_an_angle_is_labelled_as_it_is_drawn(angle: str, drawn_as: str, wanted: str) -> None:
    tree = read_expression(angle)
    value, size = (float(evaluate(read_expression(x), at_35)) for x in (angle, drawn_as))
    shown = angle_label(tree, value, size, lay.from_tree(tree))
    assert shown is not None and to_text(shown) == wanted


def at_35(name: str) -> sp.Expr:
    return sp.Rational(35, 180) * sp.pi


def test_an_arc_of_another_angle_has_no_label() -> None:
    tree = read_expression("theta")
    assert angle_label(tree, 0.6, 0.7, lay.from_tree(tree)) is None


def test_any_angle_that_is_drawn_has_a_label_of_that_size() -> None:
    """The label, read as an angle again, is as large as the arc."""
    r_ = random.Random(5)
    for _ in range(60):
        turn = r_.choice([-360, -180, -90, 0, 30, 90, 120, 180, 270])
        sign = r_.choice("+-")
        tree = read_expression(f"{turn}° {sign} theta" if turn else f"{sign}theta".lstrip("+"))
        value = float(evaluate(tree, at_35))
        size = abs(math.remainder(value, 2 * math.pi))
        size = r_.choice([size, math.pi - size])
        shown = angle_label(tree, value, size, lay.from_tree(tree))
        assert shown is not None
        again = to_text(shown).replace("−", "-").replace("θ", "theta")
        assert float(evaluate(read_expression(again), at_35)) == pytest.approx(size)


def test_an_angle_of_a_wall_is_marked_where_it_is_given() -> None:
    scene = scenes(solved(STATEMENTS[0]))[0]
    assert "θ" in {to_text(each.content) for each in scene.labels}
    assert any(isinstance(each, Arc) for each in scene.shapes)
    plan = scenes(solved(STATEMENTS[10]))[0]
    assert "120°" in {to_text(each.content) for each in plan.labels}


def test_a_component_with_a_long_exact_form_is_a_decimal() -> None:
    second = scenes(solved(STATEMENTS[13]))[2]
    assert second.event == 2 and len(second.panels) == 2
    texts = [to_text(each.content) for each in second.labels]
    x, y = math.cos(math.radians(45)), 0.5 * math.sin(math.radians(45))
    half, high = 0.5, math.sqrt(3) / 2
    along, across = abs(y * high - x * half), x * high + y * half
    for size in (along, across, across / 2):
        assert f"{float(f'{size:.3g}'):g}u" in texts


def test_there_is_no_triangle_without_a_word() -> None:
    """Components of which neither has a short name are not drawn."""
    second = scenes(solved(STATEMENTS[13].replace("45°", "alpha")))[2]
    assert second.event == 2 and len(second.panels) == 2
    assert not [x for x in second.shapes if isinstance(x, Arrow) and x.role == "component"]


# --- what is short --------------------------------------------------------------------------------

u, e, k, m = sp.symbols("u e k m", positive=True)
alpha, theta = sp.symbols("alpha theta", positive=True)


@pytest.mark.parametrize(
    "short",
    [
        u * sp.cos(alpha),
        e * u * sp.sin(theta),
        sp.sqrt(3) * u / 2,
        5 * u / 13,
        12 * e * u / 13,
        u * sp.cos(alpha) / 2,
        (1 + e) * u / 2,
        u * sp.cos(theta - sp.pi / 6),
        e**2 * u,
        sp.Integer(5),
        u / sp.sqrt(2),
    ],
)
def test_what_a_textbook_prints_is_short(short: sp.Expr) -> None:
    assert is_short(short) and tidy(short) is not None


@pytest.mark.parametrize(
    "long",
    [
        sp.sqrt(3) * u * sp.cos(alpha) / 6,
        (sp.sqrt(6) + 3 * sp.sqrt(2)) * u / 16,
        u * (sp.cos(alpha) + sp.sin(alpha)) / 2,
        u * sp.sqrt(3 + sp.sin(alpha) ** 2) / 2,
        1234 * u,
        sp.sqrt(103) * u / 16,
        u * sp.cos(alpha) * sp.sin(theta),
        e * sp.sqrt(e) * u,
        (1 + e + k) * u,
    ],
)
def test_what_hides_more_than_it_says_is_not(long: sp.Expr) -> None:
    assert not is_short(long)


def test_no_root_stands_in_a_root() -> None:
    nested = sp.sqrt(2 + sp.sqrt(3)) * u
    assert is_nested(nested) and not is_short(nested)
    assert tidy_angle(sp.pi / 3) == sp.pi / 3
