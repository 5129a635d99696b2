"""Expressions as LANGUAGE says: each reading written out by hand as a tree."""

from __future__ import annotations

from fractions import Fraction

import pytest

from restitution.errors import StatementError
from restitution.expression import read_expression, write_expression
from restitution.expression.lexer import scan
from restitution.expression.reading import BUILDERS, Reading, expression_parser, parse_tokens
from restitution.expression.source import Source
from restitution.expression.tree import (
    Apply,
    AtTime,
    Binary,
    Degrees,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Pi,
    Place,
    Polar,
    Quantity,
    Unit,
    functions_in,
    has_root,
    is_binary,
    is_function,
    is_quantity,
    negated,
    unsigned,
)

NAMES = {"A": "sphere", "P": "sphere", "W": "wall", "AB": "wall", "N": "point"}


def n(value):
    return Number(Fraction(value))


def deg(value):
    return Degrees(Fraction(value))


def mul(first, *rest):
    for each in rest:
        first = Binary("*", first, each)
    return first


def div(a, b):
    return Binary("/", a, b)


def add(a, b):
    return Binary("+", a, b)


def sub(a, b):
    return Binary("-", a, b)


def power(a, b):
    return Binary("^", a, b)


def sqrt(x):
    return Apply("sqrt", x)


def sin(x):
    return Apply("sin", x)


def cos(x):
    return Apply("cos", x)


e, g, h, k, m, u, v, x = map(Letter, "eghkmuvx")
alpha, theta, mu = Letter("alpha"), Letter("theta"), Letter("mu")
i, j = Unit("i"), Unit("j")
A, P, W, AB, N = map(Name, ("A", "P", "W", "AB", "N"))
one, two, three, four = map(n, (1, 2, 3, 4))

READINGS = {
    # numbers
    "3": three,
    "0.6": n("3/5"),
    ".5": n("1/2"),
    "3/4": div(three, four),
    "60%": n("3/5"),
    "12.5 %": n("1/8"),
    "2e+1": add(mul(two, e), one),
    "pi": Pi(),
    "2π": mul(two, Pi()),
    "60°": deg(60),
    "22.5 deg": deg("22.5"),
    "½m": mul(div(one, two), m),
    # a number over a number of degrees is one angle
    "90/2°": deg(45),
    "1/2°": deg("1/2"),
    "½°": deg("1/2"),
    "-1/3 deg": Negate(deg("1/3")),
    "0.9 / 0.2 °": deg("9/2"),
    "u at 90/2°": Polar(u, deg(45)),
    "90/2° u": mul(deg(45), u),
    "90/2°/3": div(deg(45), three),
    "sin(90/2°)": Apply("sin", deg(45)),
    "180°/3": div(deg(180), three),
    "u/(2°)": div(u, deg(2)),
    "90/(2°)": div(n(90), deg(2)),
    "180°/(2°)": div(deg(180), deg(2)),
    "u/(2°)^2": div(u, power(deg(2), two)),
    "u/sqrt 4°": div(u, sqrt(deg(4))),
    "⅔": div(two, three),
    # roots and powers
    "√7": sqrt(n(7)),
    "√7u": mul(sqrt(n(7)), u),
    "√(2gh)": sqrt(mul(two, g, h)),
    "sqrt(7)/4 u": mul(div(sqrt(n(7)), four), u),
    "√2g": mul(sqrt(two), g),
    "u^2": power(u, two),
    "u**2": power(u, two),
    "u²": power(u, two),
    "u³v": mul(power(u, three), v),
    "u⁻¹": power(u, Negate(one)),
    "2^3^k": power(two, power(three, k)),
    "-u^2": Negate(power(u, two)),
    "(-u)^2": power(Negate(u), two),
    "u^-1": power(u, Negate(one)),
    "(1+e)²": power(add(one, e), two),
    # multiplication left out, division
    "3m u": mul(three, m, u),
    "2(1+e)u": mul(two, add(one, e), u),
    "1/2u": mul(div(one, two), u),
    "1/2 m u^2": mul(div(one, two), m, power(u, two)),
    "u/2/k": div(div(u, two), k),
    "u*-2": mul(u, Negate(two)),
    "2 × u ÷ k": div(mul(two, u), k),
    "u − v": sub(u, v),
    "-2u i": Negate(mul(two, u, i)),
    "-i - 6j": sub(Negate(i), mul(n(6), j)),
    "u - -v": sub(u, Negate(v)),
    "+u": u,
    # letters
    "m1u1": mul(Letter("m_1"), Letter("u_1")),
    "e1": Letter("e_1"),
    "e_1": Letter("e_1"),
    "e₁": Letter("e_1"),
    "u12": Letter("u_12"),
    "v_A": Letter("v_A"),
    "alpha": alpha,
    "α": alpha,
    "alpha_2": Letter("alpha_2"),
    "θ1": Letter("theta_1"),
    "ϕ": Letter("phi"),
    "ϑ": theta,
    "ϵ": Letter("epsilon"),
    "lambda": Letter("lambda"),
    "mu": mul(m, u),
    "μ": mu,
    "µ": mu,
    "ν": Letter("nu"),
    "nu": mul(Letter("n"), u),
    "xi": mul(x, i),
    "ξ": Letter("xi"),
    "2ui": mul(two, u, i),
    "ucos(alpha)": mul(u, cos(alpha)),
    "eusintheta": mul(e, u, sin(theta)),
    "usinαcosβ": mul(u, sin(alpha), cos(Letter("beta"))),
    "emu": mul(e, m, u),
    "mgh": mul(m, g, h),
    "mua": mul(m, u, Letter("a")),
    "kmu": mul(k, m, u),
    "uvw": mul(u, v, Letter("w")),
    "kmuv": mul(k, m, u, v),
    "𝐢 + 2𝐣": add(i, mul(two, j)),
    "𝑢": u,
    # functions
    "tan^2(x)": power(Apply("tan", x), two),
    "sin^2 x": power(sin(x), two),
    "sin²x": power(sin(x), two),
    "sin(x)^2": power(sin(x), two),
    "cos α^2": cos(power(alpha, two)),
    "sin 2θ": sin(mul(two, theta)),
    "sin 2θ cos θ": mul(sin(mul(two, theta)), cos(theta)),
    "sin 2θ^2": sin(mul(two, power(theta, two))),
    "sin θ/2": div(sin(theta), two),
    "cos 60° u": mul(cos(deg(60)), u),
    "arctan(3/4)": Apply("arctan", div(three, four)),
    "arcsin 0.6": Apply("arcsin", n("0.6")),
    "sqrt 3 u": sqrt(mul(three, u)),
    "abs(u - v)": Apply("abs", sub(u, v)),
    "cosec(x)": Apply("cosec", x),
    "sin cos x": sin(cos(x)),
    # vectors
    "3i - 4j": sub(mul(three, i), mul(four, j)),
    "u cos(alpha) i - u sin(alpha) j": sub(mul(u, cos(alpha), i), mul(u, sin(alpha), j)),
    "(3, -4)": Pair(three, Negate(four)),
    "5 at 60°": Polar(n(5), deg(60)),
    "u at alpha from -i": Polar(u, alpha, Negate(i)),
    "u at alpha from i + j": Polar(u, alpha, add(i, j)),
    "u at alpha to W": Polar(u, alpha, None, W),
    "u at 180° - theta": Polar(u, sub(deg(180), theta)),
    "u + v at -30°": Polar(add(u, v), Negate(deg(30))),
    "(5 at 60°) + 2i": add(Polar(n(5), deg(60)), mul(two, i)),
    # quantities
    "velocity(A)": Quantity("velocity", (A,)),
    "velocity(A, 2)": Quantity("velocity", (A,), 2),
    "speed(P, 0)": Quantity("speed", (P,), 0),
    "speed(P, before)": Quantity("speed", (P,), "before"),
    "speed (P)": Quantity("speed", (P,)),
    "direction(W)": Quantity("direction", (W,)),
    "along(velocity(A), line_of_centres)": Quantity(
        "along", (Quantity("velocity", (A,)), Quantity("line_of_centres"))
    ),
    "across(3i, 60°)": Quantity("across", (mul(three, i), deg(60))),
    "angle(velocity(P), AB)": Quantity("angle", (Quantity("velocity", (P,)), AB)),
    "deflection(A, 1)": Quantity("deflection", (A,), 1),
    "impulse": Quantity("impulse"),
    "impulse(2)": Quantity("impulse", (), 2),
    "impulse(A)": Quantity("impulse", (A,)),
    "impulse(A, 2)": Quantity("impulse", (A,), 2),
    "impulse (1+e)": mul(Quantity("impulse"), add(one, e)),
    "impulse (2)": mul(Quantity("impulse"), two),
    "1/6 energy(0)": mul(div(one, n(6)), Quantity("energy", (), 0)),
    "energy(A, 2)": Quantity("energy", (A,), 2),
    "energy_lost(1)": Quantity("energy_lost", (), 1),
    "total_energy_lost": Quantity("total_energy_lost"),
    "momentum": Quantity("momentum"),
    "momentum(1)": Quantity("momentum", (), 1),
    "line_of_centres(1)": Quantity("line_of_centres", (), 1),
    "mass(A)": Quantity("mass", (A,)),
    "position(A, at t)": Quantity("position", (A,), AtTime(Letter("t"))),
    "position(A, at 2t + 1)": Quantity("position", (A,), AtTime(add(mul(two, Letter("t")), one))),
    "time(2)": Quantity("time", (), 2),
    "distance(A, (1, 2))": Quantity("distance", (A, Pair(one, two))),
    "distance(A, P, at 3)": Quantity("distance", (A, P), AtTime(three)),
    "dot(3i, (1, 2))": Quantity("dot", (mul(three, i), Pair(one, two))),
    "abs((3, 4))": Apply("abs", Pair(three, four)),
}


@pytest.mark.parametrize("text", READINGS)
def test_reading(text) -> None:
    assert read_expression(text, names=NAMES) == READINGS[text]


@pytest.mark.parametrize("text", READINGS)
def test_what_is_written_reads_back(text) -> None:
    assert read_expression(write_expression(READINGS[text]), names=NAMES) == READINGS[text]


WRITTEN = {
    "3i - 4j": "3i - 4j",
    "1/2u": "1/2 u",
    "(1/2)*u": "1/2 u",
    "u/(2 g)": "u/(2g)",
    "((u)) + (v)": "u + v",
    "u - (v - k)": "u - (v - k)",
    "u + (v + k)": "u + (v + k)",
    "2*3": "2*3",
    "sin(x)^2": "sin^2(x)",
    "sqrt(x)^2": "sqrt(x)^2",
    "μ v": "μ v",
    "mu": "m u",
    "2*m/s": "2*m/s",
    "2i*m/s": "2i*m/s",
    "u*m/s": "u*m/s",
    "2*N*s": "2*N s",
    "(-u)^2": "(-u)^2",
    "-(u v)": "-u v",
    "60%": "0.6",
}


@pytest.mark.parametrize("text", WRITTEN)
def test_writing_uses_the_fewest_brackets(text) -> None:
    assert write_expression(read_expression(text)) == WRITTEN[text]


REFUSED = {
    "tan^-1(2)": (1, "arctan"),
    "2 sin⁻¹ x": (3, "arcsin"),
    "sin^k x": (4, "whole number"),
    "spede(A)": (1, "unknown word 'spede': did you mean 'speed'?"),
    "2 + thta": (5, "did you mean 'theta'?"),
    "tna(x)": (1, "did you mean 'tan'?"),
    "mtheta": (1, "did you mean 'm theta'?"),
    "velocity(A) xylophone": (13, "unknown word 'xylophone'"),
    "uA": (2, "'A' is the name of a sphere and cannot be a letter too"),
    "i1": (1, "never a letter"),
    "v_abc": (2, "a subscript is digits or one letter"),
    "2 kg": (3, "no units"),
    "5 ms^-1": (3, "no units"),
    "5 m/s": (3, "no units"),
    "5 m s^-1": (3, "no units"),
    "5 N s": (3, "no units"),
    "5Ns": (2, "no units"),
    "2 rad": (3, "radians"),
    "3i + 4j m/s": (9, "leave out 'm/s'"),
    "(3i + 4j) m s⁻¹": (11, "no units"),
    "(3, 4) N s": (8, "no units"),
    "sqrt(5) m/s": (9, "no units"),
    "5 m s-1": (3, "no units"),
    "5 at 30° m/s": (10, "no units"),
    "x-axis": (1, "did you mean 'i'?"),
    "u°": (2, "degree sign"),
    "u/2°": (1, "write u/(2°)"),
    "(u+m)/30°": (1, "write (u+m)/(30°)"),
    "180°/2°": (1, "write 180°/(2°)"),
    "3 + 2*1/2 deg": (5, "write 2*1/(2 deg)"),
    "1/2/3°": (1, "write 1/2/(3°)"),
    "u/-2°": (1, "write u/(-2°)"),
    "90/2°^2": (1, "write 90/(2°^2)"),
    "sin 90/2°": (1, "write sin 90/(2°)"),
    "50%/2°": (1, "such as 90/2°, is one angle"),
    "90/0°": (4, "division by zero"),
    "1/0": (3, "division by zero"),
    "u + 3/0.0 i": (7, "division by zero"),
    f"0.{'0' * 37}1/777°": (1, "at most 40 digits"),
    "2 3": (3, "two numbers"),
    "2½": (2, "mixed number"),
    "": (1, "expected a value"),
    "3 +": (4, "expected a number, a letter or '(' after '+'"),
    "(u": (3, "expected ')'"),
    "u)": (2, "expected an operator or the end of the line after 'u', not ')'"),
    "[u]": (1, "round brackets"),
    "speed": (1, "'speed' needs brackets"),
    "speed(A, P)": (1, "'speed' is written speed(A) or speed(A, n)"),
    "energy_lost(A, P)": (1, "energy_lost(A, n)"),
    "1 + energy_lost(A, 0)": (5, "there is no energy_lost at 0"),
    "energy_lost(A, before)": (1, "takes no 'before'"),
    "time": (1, "time(n)"),
    "impulse(before)": (1, "takes no 'before'"),
    "deflection(A, before)": (1, "takes no 'before'"),
    "speed(A, at t)": (1, "takes no time"),
    "speed(before, A)": (7, "stands last"),
    "u at (1, 2)": (6, "expected an angle after 'at'"),
    "u at alpha to v": (15, "'to'"),
    "9" * 41: (1, "at most 40 digits"),
    "(" * 51 + "u" + ")" * 51: (51, "more than 50 deep"),
    "u+" * 150 + "u": (1, "too long or nested too deeply"),
    "u ; v": (3, "unexpected character ';'"),
    "u\x01": (2, "U+0001"),
    "energy lost": (1, "did you mean 'energy_lost'?"),
    "find": (1, "'find'"),
}


@pytest.mark.parametrize("text", REFUSED)
def test_refusal(text) -> None:
    column, said = REFUSED[text]
    with pytest.raises(StatementError) as caught:
        read_expression(text, names=NAMES)
    assert said in caught.value.message
    assert (caught.value.line, caught.value.column) == (1, column)


def test_places_count_from_where_the_text_begins() -> None:
    tree = read_expression("u + speed(A)", names=NAMES, line=4, column=11)
    assert tree.place == Place(4, 11)
    assert tree.right.place == Place(4, 15)
    with pytest.raises(StatementError) as caught:
        read_expression("u + ", line=4, column=11)
    assert (caught.value.line, caught.value.column) == (4, 14)


def test_names_are_letters_where_nothing_is_declared() -> None:
    assert read_expression("AB") == mul(Letter("A"), Letter("B"))


@pytest.mark.parametrize(("text", "bare", "other"), [("-2u", "2u", "2u"), ("v", "v", "-v")])
def test_a_tree_is_told_from_its_sign(text, bare, other) -> None:
    tree = read_expression(text)
    assert unsigned(tree) == read_expression(bare)
    assert negated(tree) == read_expression(other)


def test_a_node_is_of_a_kind() -> None:
    tree = read_expression("2 sin alpha")
    assert is_binary(tree, "*", "/") and not is_binary(tree, "+")
    assert is_function(tree.right, "sin") and not is_function(tree, "sin")
    assert is_quantity(Quantity("speed"), "speed") and not is_quantity(tree, "speed")


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("2u", set()),
        ("60° + 2/3", set()),
        ("sqrt(7)/4 u", {"sqrt"}),
        ("sin(arctan(3/4) + alpha) - sqrt(1 + cos theta)", {"sin", "arctan", "sqrt", "cos"}),
        ("(sin alpha) i + 3j", {"sin"}),
    ],
)
def test_a_tree_keeps_its_functions(text, names) -> None:
    tree = read_expression(text)
    whole = Binary("+", tree, Number(Fraction(1)))  # one that is made of a tree that has been asked
    assert functions_in(tree) == functions_in(whole) == names
    assert has_root(whole) is has_root(tree) is ("sqrt" in names)


@pytest.mark.parametrize(
    ("text", "doubtful"),
    [
        ("v^2/2g", True),
        ("u/2(1+e)", True),
        ("1/kv", True),
        ("speed(A)/2k", True),
        ("sin 2(1+e)", True),
        ("v^2/2 g", False),
        ("1/2u", False),
        ("sqrt(7)/4 u", False),
        ("sqrt(7)/4u", False),
        ("v^2/(2g)", False),
        ("(v^2/2)g", False),
        ("2/3mu", False),
    ],
)
def test_a_doubtful_quotient_draws_a_warning(text, doubtful) -> None:
    reading = Reading(scan(Source(text), NAMES))
    parse_tokens(expression_parser(), reading, BUILDERS)
    assert bool(reading.warnings) is doubtful
