"""Statements as LANGUAGE says: every line, property, relation and item, and every mistake."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path

import pytest

import restitution
from restitution.errors import StatementError
from restitution.expression import limits
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Place,
    Polar,
    Quantity,
    Unit,
)
from restitution.language import check, parse, read, to_statement
from restitution.problem import (
    Aligned,
    Arrival,
    AtRest,
    Compare,
    Extremum,
    Find,
    Given,
    Impact,
    Kick,
    Let,
    Meets,
    Part,
    Point,
    Problem,
    Range,
    Show,
    Sphere,
    Unknown,
    Value,
    Wall,
)

HEAD = """\
sphere A: mass 2
sphere B
wall W: along i
point N: (1, 2)
"""
# A line that is added to these four stands in line 5.


def n(value):
    return Number(Fraction(value))


def mul(a, b):
    return Binary("*", a, b)


def half():
    return Binary("/", n(1), n(2))


u, v, e, k, m, alpha = map(Letter, ("u", "v", "e", "k", "m", "alpha"))
i, j = Unit("i"), Unit("j")
A, B, W, N = map(Name, "ABWN")
REST = Pair(n(0), n(0))
velocity_a = Quantity("velocity", (A,))
velocity_b = Quantity("velocity", (B,))


def step(line):
    (part,) = parse(HEAD + line).parts
    (only,) = part.steps
    return only


# --- bodies -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("line", "sphere"),
    [
        ("sphere P", Sphere("P")),
        ("sphere P: mass 3m", Sphere("P", mass=mul(n(3), m))),
        ("sphere P: velocity 3i", Sphere("P", velocity=mul(n(3), i))),
        ("sphere P: velocity (3, -4)", Sphere("P", velocity=Pair(n(3), Negate(n(4))))),
        ("sphere P: velocity u at alpha to W", Sphere("P", velocity=Polar(u, alpha, None, W))),
        ("sphere P: at rest", Sphere("P", velocity=REST)),
        ("sphere P: at (1, 2)", Sphere("P", position=Pair(n(1), n(2)))),
        ("sphere P: at(1, 2)", Sphere("P", position=Pair(n(1), n(2)))),
        ("sphere P: at N, at rest", Sphere("P", velocity=REST, position=N)),
        ("sphere P: radius 1/2", Sphere("P", radius=half())),
        ("sphere P: mass(2m)", Sphere("P", mass=mul(n(2), m))),
        ("sphere P1: mass 2 # kg", Sphere("P1", mass=n(2))),
        ("sphere P: mass 2, \\\n velocity 3i", Sphere("P", mass=n(2), velocity=mul(n(3), i))),
        ("sphere P: mass 2\nsphere P: at rest", Sphere("P", mass=n(2), velocity=REST)),
    ],
)
def test_spheres(line, sphere) -> None:
    assert parse(HEAD + line).spheres[-1] == sphere


@pytest.mark.parametrize(
    ("line", "wall"),
    [
        ("wall V", Wall("V")),
        ("wall V: along 60°", Wall("V", along=Degrees(Fraction(60)))),
        ("wall V: along (3, 4)", Wall("V", along=Pair(n(3), n(4)))),
        ("wall V: along(3, 4)", Wall("V", along=Pair(n(3), n(4)))),
        ("wall V: along j, through (0, 2)", Wall("V", along=j, through=Pair(n(0), n(2)))),
        ("wall V: along j through N", Wall("V", along=j, through=N)),
        ("wall V: from N to (4, 0)", Wall("V", start=N, end=Pair(n(4), n(0)))),
        ("wall V: circle centre N radius 3", Wall("V", centre=N, radius=n(3))),
        ("wall V: circle centre N, radius 3", Wall("V", centre=N, radius=n(3))),
    ],
)
def test_walls(line, wall) -> None:
    assert parse(HEAD + line).walls[-1] == wall


def test_points() -> None:
    assert parse(HEAD).points == (Point("N", Pair(n(1), n(2))),)


def test_two_spheres_on_one_line() -> None:
    problem = parse("sphere A, B: mass m\nsphere A: velocity 2i")
    assert problem.spheres == (Sphere("A", mass=m, velocity=mul(n(2), i)), Sphere("B", mass=m))


def test_names_are_declared_anywhere() -> None:
    problem = parse("given speed(AB) = u\nsphere AB")
    assert problem.parts[0].steps == (
        Given((Compare((Quantity("speed", (Name("AB"),)), u), ("=",)),)),
    )


# --- the story --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("A hits B", Impact("A", "B")),
        ("A hits W", Impact("A", "W")),
        ("A hits B: e = 1/2", Impact("A", "B", e=half())),
        ("A hits B: along j, e = e1", Impact("A", "B", e=Letter("e_1"), along=j)),
        ("A hits B: along 60°", Impact("A", "B", along=Degrees(Fraction(60)))),
        ("A hits B: offset 1.6 r", Impact("A", "B", offset=mul(n("1.6"), Letter("r")))),
        ("A receives 3i", Kick("A", mul(n(3), i))),
        ("A receives 5 at 60°", Kick("A", Polar(n(5), Degrees(Fraction(60))))),
        ("A reaches (1, 2)", Arrival("A", Pair(n(1), n(2)))),
        ("A reaches N", Arrival("A", N)),
        ("A reaches W", Arrival("A", W)),
        (
            "let beta = angle(velocity(A), W)",
            Let("beta", Quantity("angle", (velocity_a, W))),
        ),
        ("let μ = speed(A)", Let("mu", Quantity("speed", (A,)))),
        (
            "given tan(alpha) = 3/4, k > 1",
            Given(
                (
                    Compare((Apply("tan", alpha), Binary("/", n(3), n(4))), ("=",)),
                    Compare((k, n(1)), (">",)),
                )
            ),
        ),
        ("given 0 < e <= 1", Given((Compare((n(0), e, n(1)), ("<", "<=")),))),
        ("given e ≥ ½", Given((Compare((e, half()), (">=",)),))),
        (
            "given velocity(A) perpendicular to velocity(B)",
            Given((Aligned(velocity_a, "perpendicular to", velocity_b),)),
        ),
        ("given velocity(A) parallel  to W", Given((Aligned(velocity_a, "parallel to", W),))),
        (
            "given velocity(A) in the direction of -i",
            Given((Aligned(velocity_a, "in the direction of", Negate(i)),)),
        ),
        (
            "given velocity(A) opposite to velocity(B)",
            Given((Aligned(velocity_a, "opposite to", velocity_b),)),
        ),
        ("given A at rest", Given((AtRest(A),))),
        ("given A and B collide again", Given((Meets(A, B, True, True),))),
        ("given A and B do not collide again", Given((Meets(A, B, True, False),))),
        ("given A hits W again", Given((Meets(A, W, True, True),))),
        ("given A does not hit W again", Given((Meets(A, W, True, False),))),
        ("given A will hit W", Given((Meets(A, W, False, True),))),
        ("given A will not hit W", Given((Meets(A, W, False, False),))),
        ("unknown k, e1, alpha", Unknown(("k", "e_1", "alpha"))),
        (
            "find speed(A), e",
            Find((Value(Quantity("speed", (A,))), Value(e))),
        ),
        (
            "find speed(A) in terms of u, m",
            Find((Value(Quantity("speed", (A,))),), ("u", "m")),
        ),
        ("find energy_lost as a percentage", Find((Value(Quantity("energy_lost"), True),))),
        ("find range of e, k", Find((Range(e), Value(k)))),
        (
            "find maximum of deflection(A) over alpha",
            Find((Extremum("maximum", Quantity("deflection", (A,)), alpha),)),
        ),
        (
            "find minimum of speed(A) over e in terms of u",
            Find((Extremum("minimum", Quantity("speed", (A,)), e),), ("u",)),
        ),
        ("show e = 1/2", Show(Compare((e, half()), ("=",)))),
        ("show A at rest", Show(AtRest(A))),
        (
            "show speed(A) = 0.236u to 3 s.f.",
            Show(Compare((Quantity("speed", (A,)), mul(n("0.236"), u)), ("=",), 3)),
        ),
        ("show e = 0.5 to 2 sf", Show(Compare((e, n("0.5")), ("=",), 2))),
        (
            "show e = k/u in terms of k, u",
            Show(Compare((e, Binary("/", k, u)), ("=",)), None, ("k", "u")),
        ),
        (
            "show range of e: 0 < e < 1/2",
            Show(Compare((n(0), e, half()), ("<", "<")), Range(e)),
        ),
        (
            "show maximum of deflection(A) over alpha = 30°",
            Show(
                Compare((Quantity("deflection", (A,)), Degrees(Fraction(30))), ("=",)),
                Extremum("maximum", Quantity("deflection", (A,)), alpha),
            ),
        ),
    ],
)
def test_steps(line, expected) -> None:
    assert step(line) == expected
    problem = parse(HEAD + line)
    assert parse(to_statement(problem)) == problem


def test_parts_and_title() -> None:
    problem = parse(
        "# a comment\ntitle Ball #1, and others\n\nsphere A\nfind e\npart a\nfind u\n"
        "part (ii)\nfind k # here\npart last:\n"
    )
    assert problem.title == "Ball #1, and others"
    assert problem.parts == (
        Part(None, (Find((Value(e),)),)),
        Part("a", (Find((Value(u),)),)),
        Part("ii", (Find((Value(k),)),)),
        Part("last", ()),
    )


def test_texts_of_items_are_as_typed() -> None:
    steps = (
        parse(
            "find  2 e , maximum of  k over u in terms of m\n"
            "show range of  e:  e<1 in terms of k\nshow e  = 0.5 to 2 s.f. # so"
        )
        .parts[0]
        .steps
    )
    assert [item.text for item in steps[0].items] == ["2 e", "maximum of  k over u"]
    assert [item.place for item in steps[0].items] == [Place(1, 7), Place(1, 13)]
    assert steps[1].text == "range of  e:  e<1"
    assert steps[1].subject.text == "range of  e"
    assert steps[2].text == "e  = 0.5 to 2 s.f."
    assert [each.place for each in steps] == [Place(1, 1), Place(2, 1), Place(3, 1)]


def test_places_of_a_line_that_goes_on() -> None:
    (find,) = parse("find e, \\\n   k").parts[0].steps
    assert find.items[1].place == Place(2, 4)


def test_line_ends_and_blanks_of_other_systems() -> None:
    expected = parse("sphere A: mass 2\nfind e")
    assert parse("\ufeffsphere A: mass 2\r\nfind e\r\n") == expected
    assert parse("\tsphere\u00a0A:\u2009mass\u00a02\rfind e".encode()) == expected


def test_a_doubtful_quotient_is_told() -> None:
    (warning,) = parse(HEAD + "find u^2/2k").warnings
    assert warning.startswith("line 5, column 6: 'u^2/2k' was read as (u^2/2) k")
    assert "u^2/(2k)" in warning
    assert parse(HEAD + "find sqrt(7)/4 u, 1/2u").warnings == ()


def test_read(tmp_path) -> None:
    path = tmp_path / "one.impact"
    path.write_text(HEAD, encoding="utf-8")
    assert read(path) == parse(HEAD)


# --- writing ----------------------------------------------------------------------------------


def test_the_statement_is_readable() -> None:
    text = """\
title A ball in a corner
sphere P: mass m, velocity u at 60° to AB, at (3a, a), radius r
sphere Q: at rest
wall AB: along i, through (0, 0)
wall C: circle centre O radius 2a
wall D: from O to (4a, 0)
point O: (0, 0)
P hits AB: e = 1/2
show speed(P) = sqrt(7)/4 u
part a
given Q at rest, P and Q collide again, P does not hit AB again
find range of e, speed(P, before) as a percentage in terms of u, m
show speed(P) = 0.66u to 2 s.f.
"""
    assert to_statement(parse(text)) == text


def test_a_body_told_on_several_lines_is_written_on_one() -> None:
    text = "sphere A, B: mass m\nsphere A: at rest\nsphere B: velocity -2u i"
    assert (
        to_statement(parse(text)) == "sphere A: mass m, at rest\nsphere B: mass m, velocity -2u i\n"
    )


@pytest.mark.parametrize(
    "problem",
    [
        Problem(title="two\nlines"),
        Problem(title="ends in \\"),
        Problem(spheres=(Sphere("a"),)),
        Problem(spheres=(Sphere("A", mass=0.5),)),
        Problem(parts=(Part("a b", ()),)),
    ],
)
def test_what_no_text_can_say(problem) -> None:
    with pytest.raises(StatementError):
        to_statement(problem)


# --- bodies made in Python --------------------------------------------------------------------


def test_bodies_read_their_texts() -> None:
    assert Sphere("A", mass=2, velocity="3i", radius="r/2") == Sphere(
        "A", mass=n(2), velocity=mul(n(3), i), radius=Binary("/", Letter("r"), n(2))
    )
    assert Sphere("A", mass=Fraction(-3, 7)).mass == Negate(Binary("/", n(3), n(7)))
    assert Sphere("A", velocity=(3, "u")).velocity == Pair(n(3), u)
    assert Sphere("A", velocity="u at alpha to W").velocity == Polar(u, alpha, None, W)
    assert Wall("W", start="N", end=(1, 2)) == Wall("W", start=N, end=Pair(n(1), n(2)))
    assert Point("N", "(1, 2)").position == Pair(n(1), n(2))


def test_other_values_stay_as_they_are() -> None:
    assert Sphere("A", mass=0.5).mass == 0.5
    assert Sphere("A", velocity=(0.5, 2)).velocity == (0.5, 2)


def test_check_of_a_problem_made_in_python() -> None:
    problem = Problem(spheres=(Sphere("A"),), parts=(Part(None, (Impact("A", "B"),)),))
    with pytest.raises(StatementError, match="unknown name 'B'"):
        check(problem)


# --- mistakes ---------------------------------------------------------------------------------

MISTAKES = {
    # words
    "spere P: mass 2": (1, "unknown word 'spere': did you mean 'sphere'?"),
    "fnd e": (1, "did you mean 'find'?"),
    "Find e": (1, "did you mean 'find'?"),
    "find spede(A)": (6, "unknown word 'spede': did you mean 'speed'?"),
    "A hit B": (3, "did you mean 'hits'?"),
    "A strikes B": (3, "did you mean 'hits'?"),
    "sphere P: mas 2": (11, "unknown property 'mas': did you mean 'mass'?"),
    "sphere P: colour 2": (11, "'colour'"),
    "find range e": (6, "did you mean 'range of'?"),
    "find energy lost": (6, "did you mean 'energy_lost'?"),
    # names
    "sphere p": (8, "a capital"),
    "sphere find": (8, "a capital"),
    "A hits C": (8, "unknown name 'C'"),
    "C hits A": (1, "unknown name 'C'"),
    "find speed(C)": (12, "unknown name 'C'"),
    "find speed(AC)": (12, "unknown name 'AC'"),
    "find speed(N)": (12, "'N' is the name of a point: 'speed' takes a sphere"),
    "find speed(W)": (12, "'W' is the name of a wall"),
    "find distance(A, W)": (18, "'position(A)' tells how far it is from W"),
    "find distance(W, N)": (15, "'distance' takes a point or a sphere"),
    "find mA": (7, "'A' is the name of a sphere and cannot be a letter too"),
    "find m A": (8, "'A' is the name of a sphere"),
    "find A": (6, "such as velocity(A)"),
    "given A = 3": (7, "such as velocity(A)"),
    "find angle(A, W)": (12, "perhaps velocity(A)"),
    "wall B": (6, "'B' is the name of a sphere already"),
    "let A = 3": (5, "expected a letter"),
    # bodies
    "sphere P: mass": (15, "expected a mass after 'mass'"),
    "sphere P: mass 2 velocity 3i": (18, "','"),
    "sphere P mass 2": (10, "':'"),
    "sphere A: mass 3": (11, "the mass of A was given already, in line 1"),
    "sphere P: mass 3, mass 4": (19, "given twice"),
    "sphere P: at rest, velocity 3i": (20, "given twice"),
    "sphere P: velocity 3": (20, "expected a vector after 'velocity'"),
    "sphere P: velocity u": (20, "expected a vector after 'velocity'"),
    "sphere P: mass 3i + (1, 2)": (16, "expected a number after 'mass'"),
    "sphere P: velocity 2i at (0, 0)": (26, "stands after a comma"),
    "wall W: along j": (9, "given already, in line 3"),
    "wall V: along": (14, "expected a vector or an angle after 'along'"),
    "wall V: from (0, 0)": (20, "'to'"),
    "wall V: circle radius 2": (16, "'centre'"),
    "wall V: circle centre N": (6, "a centre and a radius"),
    "wall V: along i, from (0, 0) to (1, 1)": (6, "either"),
    "wall V: along W": (15, "write direction(W)"),
    "point M": (8, "expected ':'"),
    "point M: 3": (10, "expected a point"),
    "point N: (0, 0)": (10, "given already, in line 4"),
    # events
    "A hits": (7, "expected the name of a sphere or a wall after 'hits'"),
    "A hits A": (1, "cannot hit itself"),
    "A hits N": (1, "point"),
    "W hits A": (1, "a sphere hits a wall: did you mean 'A hits W'?"),
    "A hits W: offset 2": (18, "takes no 'offset'"),
    "A hits W: along j": (17, "takes no 'along'"),
    "A hits B: along i, offset 2": (1, "not both"),
    "A hits B: e 1/2": (11, "did you mean 'e ='"),
    "A hits B: f = 1/2": (11, "unknown property 'f'"),
    "A hits B: e = 1, e = 1": (18, "given twice"),
    "A hits B: along": (16, "expected a vector or an angle after 'along'"),
    "A receives 3": (12, "expected a vector"),
    "A reaches B": (11, "sphere"),
    "A reaches 3": (11, "expected a point"),
    # facts
    "given": (6, "expected a relation after 'given'"),
    "given e": (8, "expected a relation"),
    "given A hits B": (7, "'A hits B again'"),
    "given A and A collide again": (7, "cannot hit itself"),
    "given e = 0.5 to 2 s.f.": (15, "to 2 s.f."),
    "given velocity(A) perpendicular velocity(B)": (19, "perpendicular to"),
    "given N parallel to W": (7, "point"),
    "let beta": (9, "expected '='"),
    "let i = 3": (5, "expected a letter after 'let', not 'i'"),
    "let k = 3\nlet k = 4": (1, "'k' names something already"),
    "unknown": (8, "expected a letter after 'unknown'"),
    "unknown k, k": (12, "listed twice"),
    # questions
    "find": (5, "expected what is to be found after 'find'"),
    "find e,": (8, "after ','"),
    "find e in terms of": (19, "expected a letter after 'in terms of'"),
    "find e in terms of u, speed(A)": (23, "expected a letter after ',', not 'speed'"),
    "find e in terms of u, u": (23, "listed twice"),
    "find maximum of e": (18, "'over'"),
    "find impulse(1)": (6, "there is no event 1: 0 events are told"),
    "find speed(A, B)": (6, "'speed' is written speed(A) or speed(A, n)"),
    "show maximum of e over u": (25, "expected '='"),
    "show e < 0.5 to 2 s.f.": (14, "s.f."),
    "show e = 0.5 to 0 s.f.": (14, "at least 1"),
    "part": (1, "one word as a label"),
    "part a b": (1, "one word as a label"),
    "part a\npart a": (1, "there is a part 'a' already"),
    "title": (1, "expected a text"),
    "title x\ntitle y": (1, "a title already"),
    "= 3": (1, "expected a line that begins with"),
    "find e \\": (8, "backslash"),
}


@pytest.mark.parametrize("line", MISTAKES)
def test_mistake(line) -> None:
    column, said = MISTAKES[line]
    with pytest.raises(StatementError) as caught:
        parse(HEAD + line)
    assert said in caught.value.message
    assert (caught.value.line, caught.value.column) == (5 + line.count("\n"), column)


# What students write, in a statement of two spheres and a wall (line 5 as above).
SLIPS = {
    # how lines begin
    "ball P: mass 2": (1, "did you mean 'sphere'?"),
    "Calculate speed(A)": (1, "did you mean 'find'?"),
    "a) find e": (1, "'part a'"),
    "(ii) find e": (1, "'part ii'"),
    "tan(alpha) = 3/4": (1, "did you mean 'given tan(alpha) = 3/4'?"),
    "speed(A) = 4": (1, "did you mean 'given speed(A) = 4'?"),
    "let tan(alpha) = 3/4": (1, "did you mean 'given tan(alpha) = 3/4'?"),
    "let k be 3": (7, "did you mean '='?"),
    "A and B collide again": (1, "did you mean 'given A and B collide again'?"),
    "A and B collide": (9, "did you mean 'A hits B'?"),
    "A collides with B: along i": (3, "did you mean 'hits'?"),
    "A bounces off the wall W": (3, "did you mean 'hits'?"),
    "hence find e": (1, "leave out 'hence'"),
    "given that e = 1": (7, "leave out 'that'"),
    "show that e = 1": (6, "leave out 'that'"),
    "// a comment": (1, "'#'"),
    # properties
    "sphere P mass 2": (10, "':'"),
    "sphere P has mass 2": (10, "':'"),
    "sphere P: m = 2": (11, "did you mean 'mass'?"),
    "sphere P: mass = 2": (16, "leave out '='"),
    "sphere P: mass 2,5": (17, "decimal point"),
    "sphere P: velocity 3 opposite to A": (22, "a direction is told by an angle or a vector"),
    "given momentum conserved": (7, "momentum is conserved wherever two spheres collide"),
    "given that total momentum is conserved": (7, "this line can be left out"),
    "sphere P: mass 2; at rest": (17, "did you mean ','?"),
    "sphere P: mass 2 and at rest": (18, "did you mean ','?"),
    "sphere P: speed 5 at 30°": (11, "did you mean 'velocity'?"),
    "sphere P: velocity 5 at an angle of 30°": (25, "leave out 'an angle of'"),
    "sphere P: velocity 5 at 30° to i": (29, "did you mean 'from i'?"),
    "sphere P: velocity 5 at 30° with W": (29, "did you mean 'to W'?"),
    "sphere P: velocity 5 at 30° to wall W": (32, "leave out 'wall'"),
    "sphere P: velocity 3i + 4k": (25, "i and j, and k is a letter here"),
    "sphere P: velocity (3i, 4j)": (21, "expected a number"),
    "sphere P: e = 0.5": (11, "stands on the line of an impact"),
    "wall V: parallel to i": (9, "did you mean 'along'?"),
    "wall V: along x-axis": (15, "did you mean 'i'?"),
    "wall V: y = 2": (9, "did you mean 'along i, through (0, 2)'?"),
    "A hits B along i": (10, "':'"),
    "A hits B: along i e = 1": (19, "expected ','"),
    "A hits B: coefficient of restitution 1/2": (11, "did you mean 'e ='?"),
    "A hits B: line of centres j": (11, "did you mean 'along'?"),
    "A receives impulse 4i": (12, "leave out 'impulse'"),
    # questions
    "find speed of A": (6, "did you mean 'speed(A)'?"),
    "find velocity A": (6, "did you mean 'velocity(A)'?"),
    "find A's speed": (6, "did you mean 'speed(A)'?"),
    "find initial speed of A": (6, "did you mean 'speed(A, 0)'?"),
    "find KE": (6, "did you mean 'energy'?"),
    "find KE lost": (6, "did you mean 'energy_lost'?"),
    "find kinetic energy of A": (6, "did you mean 'energy(A)'?"),
    "find angle of deflection of A": (6, "did you mean 'deflection(A)'?"),
    "find angle between velocity(A) and i": (6, "did you mean 'angle(velocity(A), i)'?"),
    "find speed(A) and e": (15, "did you mean ','?"),
    "find speed(A) when e = 1": (15, "a fact stands on a line of its own"),
    "find the range of e": (6, "leave out 'the'"),
    "find max of e over u": (6, "did you mean 'maximum of'?"),
    "find e as percentage": (8, "did you mean 'as a percentage'?"),
    "find e in term of u": (8, "did you mean 'in terms of'?"),
    "find e in terms of u, tan^2(theta)": (23, "is asked in terms of the letter in it: 'theta'"),
    "find e.": (7, "leave out '.'"),
    # relations
    "given e == 1": (9, "did you mean '='?"),
    "given e => 1": (9, "did you mean '>='?"),
    "given e is 1": (9, "did you mean '='?"),
    "given velocity(A) perp to i": (19, "did you mean 'perpendicular to'?"),
    "given velocity(A) is perpendicular to i": (19, "leave out 'is'"),
    "given A and B don't collide again": (15, "did you mean 'do not collide again'?"),
    "given energy_lost = 2 of energy(0)": (23, "leave out 'of'"),
    "find max deflection(A)": (6, "did you mean 'maximum of'?"),
    "find energy loss": (6, "did you mean 'energy_lost'?"),
    "point M: 0, 0": (10, "did you mean '(0, 0)'?"),
    "A hits B: elastic": (11, "did you mean 'e = 1'?"),
    "A hits B: at 30°": (11, "did you mean 'along'?"),
    "B is hit by A": (1, "did you mean 'A hits B'?"),
    "P arrives at W": (3, "did you mean 'reaches'?"),
    "given e between 0 and 1": (7, "did you mean '0 < e < 1'?"),
    # directions that are told otherwise, and what happens afterwards
    "sphere P: velocity 6 at 30° to the normal of W": (25, "did you mean '90° - 30° to W'?"),
    "find angle(velocity(A), normal to W)": (
        25,
        "90° less that to its normal, which is 'line_of_centres'",
    ),
    "sphere P: velocity 4 at bearing 060°": (25, "a bearing of 060° is the direction at 30°"),
    "A hits B: along due north": (17, "with i to the east and j to the north"),
    "wall V: through F and G": (18, "'from F to G'"),
    "wall V: x + 2y = 4": (9, "'along 2i - j, through (4, 0)'"),
    "A hits B and W": (10, "an impact is one of two bodies"),
    "A rebounds at 15° to W": (1, "did you mean 'given angle(velocity(A), W) = 15°'?"),
    "B leaves the wall W at beta to the wall W": (1, "did you mean 'given angle("),
    "sphere P: velocity 4i, at rest after": (32, "'given A at rest'"),
    "find range of e such that A changes direction": (27, "'given along(velocity(A), i) < 0'"),
    "find time between 0 and impact": (6, "'time(2) - time(1)'"),
    "find the point of impact": (6, "'position(P, 1)'"),
}


@pytest.mark.parametrize("line", SLIPS)
def test_what_was_probably_meant(line) -> None:
    column, said = SLIPS[line]
    with pytest.raises(StatementError) as caught:
        parse(HEAD + line)
    assert said in caught.value.message
    assert (caught.value.line, caught.value.column) == (5, column)


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        ("sphere P: velocity u at 30 to W", "line 5, column 25: 30 was read as 30 radians"),
        ("given direction(A) = 60", "line 5, column 22: 60 was read as 60 radians"),
        ("A hits W\ngiven sin(40) = e", "column 11: 40 was read as 40 radians"),
        ("sphere P: velocity u m/s at 30°", "column 22: 'm/s' was read as a product of letters"),
        ("sphere P: mass 2, velocity 1e3 i", "column 28: 1e3 was read as e_3"),
        ("sphere P: mass 2, velocity 3e2i", "column 28: 3e2 was read as 3 times e_2"),
        ("sphere P: mass 2.5E3", "column 16: 2.5E3 was read as 2.5 times E_3"),
        ("sphere P: mass 2, velocity 3x10^2 i", "column 28: 3x10^2 was read as a product with"),
        ("sphere P: mass 2e-3", "column 16: 2e-3 was read as 2e - 3"),
        ("sphere P: mass m kg", "column 18: 'kg' was read as a product of letters"),
        (
            "sphere P: velocity u at alpha\ngiven tan(theta) = 3/4",
            "line 6, column 7: theta stands nowhere else in the statement: did you mean alpha?",
        ),
    ],
)
def test_what_reads_but_is_doubtful(lines, said) -> None:
    (warning,) = parse(HEAD + lines).warnings
    assert said in warning


@pytest.mark.parametrize(
    "lines",
    [
        "sphere P: velocity u at pi/6 to W",
        "sphere P: velocity u at 1.2",
        "sphere P: velocity 2m u i, mass 3m",
        "sphere P: velocity 2i*m/s",
        "A hits W: e = e1\nfind speed(A)\nshow speed(A) = 3e1",
        "A hits W\nshow 3e-1 < 2",
        "sphere P: velocity u at alpha\ngiven tan(alpha) = k, k = 2",
        "sphere P: velocity u at alpha\ngiven tan(theta) = 2, alpha = 2theta",
        "A hits W\ngiven e = 1/2",
        "given k > 1\nfind range of k",
        "given energy(A) = 12J\nfind J",
    ],
)
def test_what_is_not_doubtful(lines) -> None:
    assert parse(HEAD + lines).warnings == ()


def test_all_mistakes_are_found() -> None:
    with pytest.raises(StatementError) as caught:
        parse("spere A\nsphere B\nfnd e\nfind speed(B")
    assert [caught.value.line, *(other.line for other in caught.value.others)] == [1, 3, 4]


def test_event_numbers_are_checked() -> None:
    text = "sphere A\nwall W\nA hits W\nfind impulse({})"
    parse(text.format(1))
    for wrong in (0, 2):
        with pytest.raises(StatementError):
            parse(text.format(wrong))


@pytest.mark.parametrize(
    ("text", "place", "said"),
    [
        (b"sphere A\nfind \xff", (2, 6), "UTF-8"),
        ("find \x00", (1, 6), "U+0000"),
        ("x" * (limits.MAX_TEXT_BYTES + 1), (1, 1), "too long"),
        ("\n" * limits.MAX_LINES, (limits.MAX_LINES + 1, 1), "lines"),
        ("find " + " " * limits.MAX_LINE_LENGTH, (1, 1), "too long"),
        (
            "\n".join(f"sphere A{n}" for n in range(limits.MAX_BODIES + 1)),
            (limits.MAX_BODIES + 1, 1),
            "spheres, walls and points",
        ),
        (
            "sphere A\nwall W\n" + "A hits W\n" * (limits.MAX_EVENTS + 1),
            (limits.MAX_EVENTS + 3, 1),
            "events",
        ),
    ],
    ids=["UTF-8", "NUL", "size", "lines", "line", "bodies", "events"],
)
def test_limits(text, place, said) -> None:
    with pytest.raises(StatementError) as caught:
        parse(text)
    assert said in caught.value.message
    assert (caught.value.line, caught.value.column) == place


# --- words outside the model ----------------------------------------------------------------------

OUTSIDE = {
    "given gravity = 9.8": (7, "gravity", "horizontal table"),
    "Gravity is 9.8": (1, "Gravity", "horizontal table"),
    "sphere C: height 3": (11, "height", "horizontal table"),
    "sphere C: vertical plane": (11, "vertical plane", "horizontal table"),
    "A falls to W": (3, "falls", "velocity just before an impact"),
    "wall V: inclined plane at 30°": (9, "inclined plane", "'wall W: along 30°'"),
    "given friction = 0.2": (7, "friction", "velocity just before an impact"),
    "wall V: along j, rough": (18, "rough", "smooth"),
    "string AB": (1, "string", "'A receives 2i'"),
    "A and B are joined by an elastic string": (26, "elastic string", "'A receives 2i'"),
    "A and B coalesce": (9, "coalesce", "e = 0"),
    "given A and B stick together": (15, "stick together", "e = 0"),
    "find spin": (6, "spin", "no spin"),
    "find spin(A)": (6, "spin", "no spin"),
    "A rolls to B": (3, "rolls", "no spin"),
    "find average force": (6, "average force", "ask for the impulse"),
    "find average(speed(A))": (6, "average", "ask for the impulse"),
    "given acceleration = 2": (7, "acceleration", "'A receives 2i'"),
}


@pytest.mark.parametrize("line", OUTSIDE)
def test_a_word_outside_the_model_gets_a_sentence(line) -> None:
    column, word, instead = OUTSIDE[line]
    text = "wall W: along i\nsphere A, B: mass 2, velocity 3i\n" + line
    with pytest.raises(StatementError) as caught:
        parse(text)
    assert (caught.value.line, caught.value.column) == (3, column)
    assert caught.value.message.startswith(f"'{word}' is outside the model: ")
    assert instead in caught.value.message


def test_every_row_of_the_reference_is_told() -> None:
    """The words in the first column of the table are answered as it says."""
    page = (Path(__file__).parents[1] / "docs" / "language.md").read_text(encoding="utf-8")
    table = page.partition("## What is outside")[2].partition("\n## ")[0]
    rows = [row.split("|")[1].strip() for row in table.splitlines() if row.startswith("| ")]
    assert len(rows) > 8
    for row in rows[1:-1]:
        for word in re.split(r", (?:or )?| or ", row.removeprefix("spheres that ")):
            with pytest.raises(StatementError) as caught:
                parse(f"sphere A: mass 1, {word.removeprefix('the ').removeprefix('a ')}")
            assert "is outside the model" in caught.value.message, word


@pytest.mark.parametrize(
    "line",
    [
        "title Gravity, friction and a rough string",
        "sphere C: mass 1 # rolling on a rough slope",
        "given g = 9.8, mu > 0, f < 2",
    ],
)
def test_what_reads_is_not_asked(line) -> None:
    parse("sphere A: velocity i\n" + line)


def test_a_word_outside_counts_in_lines_that_cannot_be_read_alone() -> None:
    with pytest.raises(StatementError) as caught:
        parse("sphere A: velocty 3i\n# gravity")
    assert "did you mean 'velocity'?" in caught.value.message


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: restitution.parse(None), r"parse takes a text, and not NoneType"),
        (lambda: restitution.mark("find e", "e = 1"), r"mark takes a Problem, and not str"),
        (lambda: restitution.play(restitution.parse("find e")), r"play takes a Solution, a Mo"),
        (lambda: restitution.solve("wall W"), r"Problem, and not str: restitution\.parse\(text\)"),
        (lambda: restitution.question("wall W"), r"question takes a Problem, and not str"),
        (lambda: restitution.explain(parse("wall W")), r"restitution\.solve\(problem\) makes one"),
        (lambda: restitution.draw(None), r"draw takes a Solution, and not NoneType"),
    ],
)
def test_what_is_given_for_something_else(call, said) -> None:
    with pytest.raises(TypeError, match=said):
        call()


@pytest.mark.parametrize("share", ["3/32 of energy(0)", "½ of energy(0)", "30% of energy(0)"])
def test_a_share_of_a_quantity_is_their_product(share: str) -> None:
    text = "sphere A: mass 1, velocity 3i\nsphere B: mass 2, at rest\nA hits B: along i\n"
    (read, written) = (
        parse(f"{text}given energy_lost = {own}\nfind e\n")
        for own in (share, share.replace("of", "*"))
    )
    assert read.parts == written.parts


@pytest.mark.parametrize(
    ("line", "plain"),
    [
        ("wall V: along 1 at 90° from 3i + 4j", "wall V: along -4i + 3j"),
        ("wall V: along 1 at 90° from direction(W)", "wall V: along i + 2j"),
        ("wall V: along 1 at 60° from direction(X)", "wall V: along 150°"),
        ("wall V: along 1 at 90° from direction(X)", "wall V: along i"),
        ("wall V: along 1 at theta from direction(Y)", "wall V: along theta"),
        ("wall V: along direction(W)", "wall V: along 2i - j"),
    ],
)
def test_a_wall_that_is_turned_from_a_direction_is_told_by_what_that_is(line, plain) -> None:
    head = "wall W: along 2i - j\nwall X: along j\nwall Y: along i\n"
    one, other = (parse(head + each).walls[-1].along for each in (line, plain))
    assert one == other


@pytest.mark.parametrize(
    ("typed", "other"),
    [
        ("-4 at 30°", "4 at 210°"),
        ("-2u/3 at 200° from i + j", "2u/3 at 20° from i + j"),
        ("-u at alpha", "u at alpha from -i"),
        ("-(u at alpha from j)", "u at alpha from -j"),
        ("-u at alpha to W", "u at 180° + alpha to W"),
        ("-(-u at 10° to W)", "u at 10° to W"),
    ],
)
def test_a_velocity_of_negative_size_is_one_in_the_opposite_direction(
    typed: str, other: str
) -> None:
    text = "wall W: along i\nsphere P: velocity {}\nP hits W\nfind speed(P)"
    assert parse(text.format(typed)) == parse(text.format(other))


def test_a_fact_below_all_that_its_part_asks_is_doubted() -> None:
    text = (
        "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W\n"
        "part a\nfind speed(P)\n{}part b\n{}find e"
    )
    fact = "given deflection(P) = 90°\n"
    below, above = (parse(text.format(*own)).warnings for own in ((fact, ""), ("", fact)))
    assert not above
    (warning,) = below
    assert "stands below the questions of part (a)" in warning
    assert warning.endswith("for part (b), write it below 'part b'")
