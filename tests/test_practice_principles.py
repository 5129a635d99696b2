"""Which law a line uses, in whatever form it is written, and which altered law a wrong one uses."""

from __future__ import annotations

import pytest
from lines_of_practice import claim, meanings, world_of

from restitution.practice.script import ANYWHERE, Scope
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.principles import uses_of
from restitution.practice.worlds.world import World

LETTERS = """
sphere A: mass 2m, velocity u at 30°
sphere B: mass 3m, at rest
A hits B: along i
find velocity(A), velocity(B)
"""
OF_LETTERS = {
    "v": "along(velocity(A, 1), i)",
    "w": "along(velocity(B, 1), i)",
    "x": "-along(velocity(A, 1), i)",
    "y": "along(velocity(A, 1), j)",
    "q": "speed(A, 1)",
    "b": "angle(velocity(A, 1), i)",
    "d": "deflection(A)",
    "I": "impulse(1)",
    "L": "energy_lost(1)",
    "F": "velocity(A, 1)",
    "G": "velocity(B, 1)",
}

NUMBERS = """
sphere A: mass 0.2, velocity 3i - 2j
sphere B: mass 0.4, velocity -4i + j
A hits B: along i, e = 3/7
find velocity(A), velocity(B)
"""
# v = -17/3 + ..., both reversed
OF_NUMBERS = {**OF_LETTERS, "s": "across(velocity(B, 1), i)", "p": "along(velocity(A, 0), i)"}

WALL = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
find speed(P), deflection(P)
"""
OF_WALL = {
    "v": "speed(P, 1)",
    "b": "angle(velocity(P, 1), W)",
    "y": "along(velocity(P, 1), j)",
    "x": "along(velocity(P, 1), i)",
    "d": "deflection(P)",
    "I": "impulse(1)",
    "L": "energy_lost(1)",
}

CHAIN = """
sphere A: mass 2, velocity 4i + j
sphere B: mass 3, at rest
wall W: along 90°
A hits B: along i, e = 1/4
B hits W: e = 2/5
find velocity(B)
"""
# after A hits B: A 1i + j, B 2i; after the wall: B -0.8i
OF_CHAIN = {
    "v": "along(velocity(A, 1), i)",
    "w": "along(velocity(B, 1), i)",
    "z": "speed(B, 2)",
}


def first(world: World, text: str, table: dict[str, str], scope: Scope = ANYWHERE) -> str:
    """The principle of a line, with its event and bodies."""
    line, decimals = claim(text)
    uses = uses_of(line, world, meanings(table), decimals, scope)
    if not uses:
        return "none"
    use = uses[0]
    return " ".join(map(str, (use.principle, use.event, "".join(use.bodies))))


@pytest.mark.parametrize(
    ("text", "principle"),
    [
        ("2m u cos(30) = 2m v + 3m w", "momentum 1 AB"),
        ("2u cos(30) = 2v + 3w", "momentum 1 AB"),
        ("2m u sqrt(3)/2 - 2m v = 3m w", "momentum 1 AB"),
        ("sqrt(3) u = 2v + 3w", "momentum 1 AB"),
        ("1.73u = 2v + 3w", "momentum 1 AB"),
        ("w = (u sqrt(3) - 2v)/3", "momentum 1 AB"),
        ("u = (2v + 3w)/sqrt(3)", "momentum 1 AB"),
        ("2u cos(30) = -2x + 3w", "momentum 1 AB"),
        ("2m velocity(A, 0) = 2m F + 3m G", "momentum 1 AB"),
        ("2m u cos(30) = 2m q cos(b) + 3m w", "momentum 1 AB"),
        ("0 = 2v + 3w - 2u cos(30)", "momentum 1 AB"),
        ("2m u cos(30)*9.8 = (2m v + 3m w)*9.8", "momentum 1 AB"),
        ("w - v = e u cos(30)", "restitution 1 AB"),
        ("e = (w - v)/(u cos(30))", "restitution 1 AB"),
        ("2(w - v)/sqrt(3) = e u", "restitution 1 AB"),
        ("w + x = e u cos(30)", "restitution 1 AB"),
        ("v - w = -e u cos(30)", "restitution 1 AB"),
        ("(w - v)/e = 0.866u", "restitution 1 AB"),
        ("y = u sin(30)", "unchanged 1 A"),
        ("y = u/2", "unchanged 1 A"),
        ("q sin(b) = u/2", "unchanged 1 A"),
        ("F = v i + u/2 j", "unchanged 1 A"),
        ("tan(b) = u/(2v)", "angle 1 A"),
        ("q^2 = v^2 + u^2/4", "speed 1 A"),
        ("q^2 = v^2 + y^2", "speed 1 A"),
        ("I = 3m w", "impulse 1 B"),
        ("I = 2m(u cos(30) - v)", "impulse 1 A"),
        ("I = 3m (w - 0)", "impulse 1 B"),
        ("L = m u^2 - m q^2 - 1.5 m w^2", "energy 1 AB"),
        ("L = m*3u^2/4 - m v^2 - 1.5m w^2", "energy 1 AB"),
        ("L = 1/2*(6m/5)*(1 - e^2)*3u^2/4", "energy 1 "),
        ("w = 2(1 + e) u cos(30)/5", "value 1 B"),
        ("5v = sqrt(3) u - 3 e u sqrt(3)/2", "solve 1 A"),
        ("u cos(30) = sqrt(3) u/2", "arithmetic None "),
        ("sqrt(3)/2*3 = 2.598", "arithmetic None "),
    ],
)
def test_a_line_with_letters(text: str, principle: str) -> None:
    world = world_of(LETTERS)
    line, decimals = claim(text)
    assert agrees(line, world, meanings(OF_LETTERS), decimals) is not None
    assert first(world, text, OF_LETTERS).rstrip() == principle.rstrip()


@pytest.mark.parametrize(
    ("text", "principle"),
    [
        ("0.2*3 + 0.4*(-4) = 0.2v + 0.4w", "momentum 1 AB"),
        ("0.6 - 1.6 = 0.2v + 0.4w", "momentum 1 AB"),
        ("-1 = 0.2v + 0.4w", "momentum 1 AB"),
        ("v + 2w = -5", "momentum 1 AB"),
        ("v = -5 - 2w", "momentum 1 AB"),
        ("0.2p - 1.6 = 0.2v + 0.4w", "momentum 1 AB"),
        ("0.2(3 - v) = 0.4(w + 4)", "momentum 1 AB"),
        ("w - v = 3/7*(3 + 4)", "restitution 1 AB"),
        ("w - v = 3", "restitution 1 AB"),
        ("w = v + 3", "restitution 1 AB"),
        ("3/7 = (w - v)/7", "restitution 1 AB"),
        ("y = -2", "unchanged 1 A"),
        ("s = 1", "unchanged 1 B"),
        ("F = v i - 2j", "unchanged 1 A"),
        ("3v = -11", "solve 1 A"),
        ("v = -11/3", "value 1 A"),
        ("v = -3.67", "value 1 A"),
        ("F = -11/3 i - 2j", "value 1 A"),
    ],
)
def test_a_line_with_numbers(text: str, principle: str) -> None:
    world = world_of(NUMBERS)
    line, decimals = claim(text)
    assert agrees(line, world, meanings(OF_NUMBERS), decimals) is not None
    assert first(world, text, OF_NUMBERS) == principle


@pytest.mark.parametrize(
    ("text", "principle"),
    [
        ("v cos(b) = u cos(alpha)", "unchanged 1 P"),
        ("x = u cos(alpha)", "unchanged 1 P"),
        ("v sin(b) = e u sin(alpha)", "restitution 1 P"),
        ("y = e u sin(alpha)", "restitution 1 P"),
        ("abs(y) = e u sin(alpha)", "restitution 1 P"),
        ("e = v sin(b)/(u sin(alpha))", "restitution 1 P"),
        ("tan(b) = e tan(alpha)", "solve 1 P"),
        ("e = tan(b)/tan(alpha)", "solve 1 P"),
        ("tan(b) = e u sin(alpha)/(v cos(b))", "restitution 1 P"),
        ("d = alpha + b", "deflection 1 P"),
        ("I = m(v sin(b) + u sin(alpha))", "impulse 1 P"),
        ("I = (1 + e) m u sin(alpha)", "impulse 1 "),
        ("L = m u^2/2 - m v^2/2", "energy 1 P"),
        ("L = m u^2 sin(alpha)^2 (1 - e^2)/2", "energy 1 "),
        ("v^2 = u^2 cos(alpha)^2 + e^2 u^2 sin(alpha)^2", "speed 1 P"),
    ],
)
def test_a_line_at_a_wall(text: str, principle: str) -> None:
    world = world_of(WALL)
    line, decimals = claim(text)
    assert agrees(line, world, meanings(OF_WALL), decimals) is not None
    assert first(world, text, OF_WALL).rstrip() == principle.rstrip()


@pytest.mark.parametrize(
    ("text", "principle"),
    [
        ("2*4 = 2v + 3w", "momentum 1 AB"),
        ("w - v = 1", "restitution 1 AB"),
        ("z = 2/5 w", "restitution 2 B"),
        ("z = 0.4*2", "restitution 2 B"),
    ],
)
def test_a_line_of_a_chain(text: str, principle: str) -> None:
    assert first(world_of(CHAIN), text, OF_CHAIN) == principle


def altered(text: str, statement: str, table: dict[str, str]) -> set[str]:
    line, decimals = claim(text)
    world = world_of(statement)
    assert agrees(line, world, meanings(table), decimals) is None
    uses = uses_of(line, world, meanings(table), decimals, altered=True)
    return {str(use.altered).partition("/")[0] for use in uses}


@pytest.mark.parametrize(
    ("text", "mistake"),
    [
        ("0.2*3 + 0.4*4 = 0.2v + 0.4w", "momentum-sign"),
        ("3 - 8 = -v + 2w", "momentum-sign"),
        ("w + v = 3", "restitution-sign"),
        ("w - v = 3/7*(3 - 4)", "restitution-sign"),
        ("w - v = 7", "restitution-omitted"),
        ("3/7*(w - v) = 7", "restitution-inverted"),
        ("3 - 4 = v + w", "mass-omitted"),
        ("0.4*3 - 0.2*4 = 0.4v + 0.2w", "masses-exchanged"),
        ("y = 1", "across-exchanged"),
    ],
)
def test_a_line_of_an_altered_law(text: str, mistake: str) -> None:
    assert mistake in altered(text, NUMBERS, OF_NUMBERS)


@pytest.mark.parametrize(
    ("text", "mistake"),
    [
        ("v cos(b) = e u cos(alpha)", "restitution-parallel"),
        ("v = e u", "restitution-whole-speed"),
        ("v sin(b) = u sin(alpha)", "restitution-omitted"),
        ("v sin(b) = e u cos(alpha)", "sine-cosine"),
    ],
)
def test_an_altered_law_of_a_wall(text: str, mistake: str) -> None:
    assert mistake in altered(text, WALL, OF_WALL)


@pytest.mark.parametrize("text", ["v = 5", "w - v = 17", "2v + 3w = 4.13", "q = 3.3", "y = 1.9"])
def test_a_line_that_is_false_without_a_name(text: str) -> None:
    assert altered(text, NUMBERS, OF_NUMBERS) == set()


def test_an_inequality_uses_no_law() -> None:
    line, _ = claim("w > v")
    assert uses_of(line, world_of(LETTERS), meanings(OF_LETTERS)) == ()


def test_a_fact_is_recognised() -> None:
    statement = """
    sphere A: mass 2m, velocity u at 30°
    sphere B: mass m, at rest
    A hits B: along i
    given speed(B) = 3/4 u
    find e
    """
    world = world_of(statement)
    assert first(world, "w = 0.75u", {"w": "speed(B)"}).startswith("fact")


FOUND = """
sphere A: mass m, velocity u at 45°
sphere B: mass k m, at rest
A hits B: along i
given along(velocity(A), i) = 0, energy_lost = m u^2/8
find e, k
"""


@pytest.mark.parametrize(
    ("text", "principle"),
    [
        ("m u cos(45) = k m w", "momentum 1 AB"),
        ("u cos(45) = k w", "momentum 1 AB"),
        ("w = e u cos(45)", "restitution 1 AB"),
        ("u/(2 sqrt(2)) = e u/sqrt(2)", "restitution 1 AB"),
        ("e = w/(u cos(45))", "restitution 1 AB"),
    ],
)
def test_a_law_with_numbers_put_in(text: str, principle: str) -> None:
    table = {"w": "along(velocity(B, 1), i)"}
    world = world_of(FOUND)
    line, decimals = claim(text)
    assert agrees(line, world, meanings(table), decimals) is not None
    assert first(world, text, table) == principle


PUT_IN = [
    ("0.2*3 - 0.4*4 = 0.2*(-11/3) + 0.4w", "momentum 1 AB"),
    ("0.6 - 1.6 = -2.2/3 + 0.4w", "momentum 1 AB"),
    ("w + 11/3 = 3/7*(3 + 4)", "restitution 1 AB"),
    ("w - -3.667 = 3", "restitution 1 AB"),
]


@pytest.mark.parametrize(("text", "principle"), PUT_IN)
def test_a_law_in_which_a_component_has_its_value(text: str, principle: str) -> None:
    world = world_of(NUMBERS)
    line, decimals = claim(text)
    assert agrees(line, world, meanings(OF_NUMBERS), decimals) is not None
    assert first(world, text, OF_NUMBERS) == principle


@pytest.mark.parametrize(
    ("text", "mistake"),
    [
        ("d = b", "deflection-is-after"),
        ("d = alpha - b", "deflection-difference"),
        ("I = m(u sin(alpha) - v sin(b))", "impulse-sign"),
        ("I = (1 - e) m u sin(alpha)", "impulse-sign"),
        ("I = m(u - v)", "impulse-of-speeds"),
        ("L = m u^2 sin(alpha)^2 (1 - e)/2", "square-not-taken"),
        ("L = m abs(velocity(P, 1) - velocity(P, 0))^2/2", "energy-of-difference"),
    ],
)
def test_an_altered_result_of_a_wall(text: str, mistake: str) -> None:
    assert mistake in altered(text, WALL, OF_WALL)


@pytest.mark.parametrize(
    ("text", "mistake"),
    [
        ("L = 0.2*13/2 - 0.2*q^2/2", "energy-one-sphere"),
        ("L = 0.2*9/2 + 0.4*16/2 - 0.2 q^2/2 - 0.4 speed(B)^2/2", "energy-component-missing"),
        ("I = 0.2*(11/3 - 3)", "impulse-sign"),
    ],
)
def test_an_altered_result_of_spheres(text: str, mistake: str) -> None:
    assert mistake in altered(text, NUMBERS, OF_NUMBERS)


def test_a_line_with_sides_that_vanish_is_no_instance() -> None:
    # Under conserved energy v = u, and the line says 0 = 0.
    assert altered("L = m (u - v)^2/2", WALL, OF_WALL) == {"energy-of-difference"}


TO_FIND_E = """
sphere A: mass 2, velocity 4i + 3j
sphere B: mass 3, velocity -2i + j
A hits B: along i
given velocity(A) = -i + 3j
find e
"""


@pytest.mark.parametrize(
    ("text", "principles"),
    [
        ("w = 4/3", {"momentum"}),
        ("8 - 6 = -2 + 3w", {"momentum"}),
        ("w + 1 = 6e", {"restitution"}),
        ("e = 7/18", {"momentum", "restitution"}),
        ("velocity(A) = -i + 3j", set()),
    ],
)
def test_a_value_rests_on_no_law_with_a_letter_to_be_found(text: str, principles: set[str]) -> None:
    world = world_of(TO_FIND_E)
    line, decimals = claim(text)
    table = meanings({"w": "along(velocity(B, 1), i)"})
    assert agrees(line, world, table, decimals) is not None
    laws = {use.principle for use in uses_of(line, world, table, decimals)}
    assert laws & {"momentum", "restitution"} == principles


@pytest.mark.parametrize(
    ("text", "is_value"),
    [
        ("v = -11/3", True),
        ("F = -11/3 i - 2j", True),
        ("w = -2/3", True),
        ("y = -2", True),
        ("w = v + 3", False),
        ("w - v = 3", False),
        ("v = (-5 - 4*3/7*7)/3", False),
    ],
)
def test_a_value_is_told_from_a_law(text: str, is_value: bool) -> None:
    world = world_of(NUMBERS)
    line, decimals = claim(text)
    uses = uses_of(line, world, meanings(OF_NUMBERS), decimals)
    assert ("value" in {use.principle for use in uses}) == is_value


@pytest.mark.parametrize(
    ("text", "principle"),
    [
        ("3/7*7 = 3", "restitution 1 AB"),
        ("3/7*(3 + 4) = 3", "restitution 1 AB"),
        ("3/(3/7) = 7", "restitution 1 AB"),
        ("3*4 = 12", "arithmetic None "),
        ("0.6 - 1.6 = -1", "arithmetic None "),
    ],
)
def test_a_product_with_the_coefficient(text: str, principle: str) -> None:
    assert first(world_of(NUMBERS), text, OF_NUMBERS) == principle


def test_a_law_of_speeds_with_one_at_rest() -> None:
    table = {"w": "speed(B, 1)"}
    assert first(world_of(FOUND), "m u cos(45) = k m w", table) == "momentum 1 AB"
    assert first(world_of(FOUND), "w = e u cos(45)", table) == "restitution 1 AB"
