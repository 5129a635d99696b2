"""Lines that no law fits, right or altered, and what they show by themselves."""

from __future__ import annotations

import pytest

import restitution

OBLIQUE = """
sphere A: mass m, velocity 5 at alpha
sphere B: mass 2m, at rest
A hits B: along i
given speed(A) = 3, speed(B) = 5/2
find e, alpha
"""
EQUAL = """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: at rest
A hits B: along i, e = 1/2
given energy_lost = 25% energy(0)
find alpha
"""
ELASTIC = """
sphere A: mass m, velocity u at 30°
sphere B: mass m, at rest
A hits B: along i, e = 1/2
find velocity(A), velocity(B)
"""
WALL = """
wall W
sphere P: mass 2, velocity 3i - 5j
P hits W
given impulse(P) = -8i + 16j
find e, velocity(P)
"""
HALF = """
sphere A: mass 2m, velocity u at alpha
sphere B: mass 3m, at rest
A hits B: along i
given direction(A) = 90°, deflection(A) = 60°
find alpha, energy_lost/energy(0)
"""
STOPPED = """
sphere A: mass m, velocity u at 45°
sphere B: mass 2m, at rest
A hits B: along i
given velocity(A) perpendicular to velocity(B)
find e
"""
V = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
FRACTION = "v + w = ucosα\nw - v = 0.5ucosα\nw = 0.75ucosα v = 0.25ucosα\n"


@pytest.mark.parametrize(
    ("statement", "working", "name"),
    [
        (OBLIQUE, "m(5) = m(3) + 2m(2.5)", "speed-for-component"),
        (EQUAL, FRACTION + "½mu²cos²α(1 - 5/8) = ¼ × ½mu²cos²α", "energy-fraction-of-line"),
        (ELASTIC, "mu√3/2 = mv + mw\nw - v = u√3/2", "restitution-omitted"),
        (WALL, "v = 3i - 5j - 8i + 16j", "mass-omitted"),
        (HALF, "α = 30\nKE after = ½(2m)(u/2)²", "energy-one-sphere"),
        (STOPPED, "mucos45 = 2mw\nw = eu", "restitution-whole-speed"),
    ],
)
def test_the_first_false_line_has_its_name(statement: str, working: str, name: str) -> None:
    letters = V if "sphere B" in statement else {"v": "velocity(P)"}
    marking = restitution.mark(restitution.parse(statement), working, letters=letters)
    assert marking.mistakes == (name,)


BLOW = """
sphere P: mass 2, at rest
wall W: along i
P receives 6i - 8j
P hits W: e = 1/2
find velocity(P), impulse, energy_lost
"""
SHARE = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
given tan(alpha) = 3/4
P hits W: e = 2/3
find energy_lost/energy(0) as a percentage
"""
SPED = """
wall W: along i
sphere P: mass m, at rest
P receives H at 60° to W
P hits W: e = 3/4
given speed(P) = u
find H
"""
NORMAL = """
wall W: along 3i + 4j
sphere P: mass 0.4, velocity 5i - 2j
P hits W: e = 1/2
find velocity(P)
"""
HEAVY = """
sphere A: mass m, velocity u i
sphere B: mass 3m, velocity -u i
A hits B: along i, e = 1/2
find energy(B), velocity(A), velocity(B)
"""
ACROSS = """
sphere A: mass 2, velocity 3i + 2j
sphere B: mass 1, at rest
A hits B: along i + j, e = 1/2
find velocity(A), velocity(B)
"""


@pytest.mark.parametrize(
    ("statement", "working", "name"),
    [
        (BLOW, "velocity after blow = 6i - 8j", "mass-omitted"),
        (BLOW, "v = 3i - 4j\nimpulse = 2 - -4 = 6", "mass-omitted"),
        (SHARE, "speed = 2u/√5\n% KE lost = (1 - 2/√5)*100 = 10.6%", "energy-ratio-as-speed"),
        (SPED, "H = mv\nu = 0.75v", "restitution-whole-speed"),
        (NORMAL, "approach = 5*0.6 - 2*0.8 = 1.4", "restitution-parallel"),
        (HEAVY, "mu - 3mu = 3mv + mw", "masses-exchanged"),
        (HEAVY, "v = -5u/4, w = -u/4\nKE of B after = ½m(u/4)²", "masses-exchanged"),
        (ACROSS, "vA = 5/4 i + 5/4 j", "across-changed"),
    ],
)
def test_what_is_left_out_or_exchanged_has_its_name(
    statement: str, working: str, name: str
) -> None:
    letters = V if "sphere B" in statement else {}
    marking = restitution.mark(restitution.parse(statement), working, letters=letters)
    false = [line for line in marking.json()["lines"] if line["verdict"] == "false"]
    assert false
    assert false[0]["mistake"]["id"] == name


MET = """
sphere P: mass 2m, velocity 3u at theta
sphere Q: mass m, velocity -2u j
given tan(theta) = 5/12
P hits Q: along i, e = 2/5
find speed(Q)
"""


def test_the_speed_of_a_sphere_that_moves_across_the_line_is_no_cosine() -> None:
    working = "2*3ucosθ - 2u = 2v + w\nw - v = 0.4*3ucosθ\n3.54u = 2v + w"
    letters = {"v": "along(velocity(P), i)", "w": "along(velocity(Q), i)"}
    marking = restitution.mark(restitution.parse(MET), working, letters=letters)
    assert marking.mistakes == ("speed-for-component",)
    (method,) = [
        x for x in marking.marks.points if (x.point.letter, x.point.principle) == ("M", "momentum")
    ]
    assert method.state == "lost"


def test_the_sine_of_a_known_angle_with_the_value_of_its_cosine_is_no_letter_of_its_own() -> None:
    working = "sina = 4/5, cosa = 3/5\npara = 3u/5\nperp = 2/3*4u/5 = 8u/15"
    lines = restitution.mark(restitution.parse(SHARE), working).json()["lines"]
    assert [line["verdict"] for line in lines] == ["false", "follows", "follows"]
    assert lines[0]["mistake"]["id"] == "sine-cosine"


UNRESOLVED = """
sphere A: mass M, velocity 6 at 30°
sphere B: mass 2, at rest
A hits B: along i
given speed(A) = sqrt(12), speed(B) = 3 sqrt(3)
find M, e
"""
QUARTER = """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along i, e = 1
given energy(B) = 1/4 energy(0)
find alpha
"""
SAME_ENERGIES = """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, velocity u at alpha from -i
A hits B: along i
given tan(alpha) = 3/4, energy(A) = energy(B)
find e
"""
ACROSS_AND_AT_AN_ANGLE = """
sphere A: mass m, velocity u at 60°
sphere B: mass 2m, velocity v j
A hits B: along i, e = 1/2
given speed(A) = speed(B)
find v
"""
QUARTER_LOST = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given energy_lost = 1/4 energy(0)
find range of e
"""


@pytest.mark.parametrize(
    ("statement", "working", "name"),
    [
        (UNRESOLVED, "6Mcos30 = √12 M + 2(3√3)", "speed-for-component"),
        (QUARTER, "w = 2/3 ucosα\n½(2m)w² = ¼mu²", "energy-no-half"),
        (SAME_ENERGIES, "w - v = 1.6eu\nv + 2w = -0.8u\n½mv² = mw²", "energy-component-missing"),
        (ACROSS_AND_AT_AN_ANGLE, "musin60 = mv' + 2mw", "sine-cosine"),
        (QUARTER_LOST, "½mu²sin²α - ½meu²sin²α = ⅛mu²", "square-not-taken"),
    ],
)
def test_facts_of_energies_and_whole_speeds_among_components(
    statement: str, working: str, name: str
) -> None:
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    letters = letters if "sphere B" in statement else {}
    if "v'" in working:
        letters = {"v'": letters["v"], "w": letters["w"]}
    found = restitution.mark(restitution.parse(statement), working, letters=letters)
    assert found.mistakes == (name,)


ONE_SIDE = """
sphere A: mass 2m, velocity 4u i + u j
sphere B: mass 3m, velocity -2u i
A hits B: along i, e = 2/5
find velocity(A)
"""


@pytest.mark.parametrize(
    "line", ["8mu - 6mu = mv + mw", "8u - 6u = 2v + 2w", "12u - 6u = 2v + 3w", "8u - 6u = v + w"]
)
def test_masses_left_out_on_one_side_of_momentum(line: str) -> None:
    found = restitution.mark(restitution.parse(ONE_SIDE), line, letters=V)
    assert found.mistakes == ("mass-omitted",)


SHARE_AT_A_WALL = """
wall W: along i
sphere P: mass m, velocity u at 60° to W
P hits W
given energy_lost = 3/8 energy(0)
find e
"""
LOSS_OF_18 = """
sphere P: mass 2, velocity 6i
sphere Q: mass 4, at rest
P hits Q: along i
given energy_lost = 18
find e, velocity(P), velocity(Q)
"""
IN_TURN = """
sphere A: mass 3m, velocity 4u i
sphere B: mass m, at rest
sphere C: mass 2m, at rest
A hits B: along i, e = 1/3
B hits C: along i, e = 1/2
find velocity(B), velocity(C)
"""


@pytest.mark.parametrize(
    ("statement", "working", "name"),
    [
        (SHARE_AT_A_WALL, "½m(usin60)²(1-e²) = 3/8 × ½m(usin60)²", "energy-fraction-of-line"),
        (LOSS_OF_18, "w = 2 + 2e\nv = 2 - 4e\n72 - 2(2-4e)² - 4(2+2e)² = 18", "energy-no-half"),
        (IN_TURN, "4u = p + 2q\nq - p = ⅓(4u)", "misread"),
        (IN_TURN, "4u = p + 2q\n⅓ = (q - p)/4u", "misread"),
        (IN_TURN, "4u = p + 2q\nq - p = 4u", "restitution-omitted"),
        (LOSS_OF_18, "12 = 2v + 4w\n½(2)(36) - ½(2)v² = 18", "energy-one-sphere"),
    ],
)
def test_a_line_shows_which_of_two_mistakes_with_one_value_it_has(
    statement: str, working: str, name: str
) -> None:
    letters = {"v": "along(velocity(P), i)", "w": "along(velocity(Q), i)"}
    if statement == IN_TURN:
        letters = {"p": "along(velocity(B), i)", "q": "along(velocity(C), i)"}
    letters = {} if statement == SHARE_AT_A_WALL else letters
    found = restitution.mark(restitution.parse(statement), working, letters=letters)
    assert found.mistakes == (name,)


def test_whole_speeds_are_named_below_the_component_that_is_right() -> None:
    wall = """
wall W: along i
sphere P: mass 2, velocity 4 at 30° to W
P hits W: e = 1/2
find speed(P)
"""
    lines = "perp after = ½ × 2 = 1\nspeed after = ½ × 4 = 2"
    assert restitution.mark(restitution.parse(wall), lines).mistakes == ("restitution-whole-speed",)


HEAD_ON = """sphere A: mass 4, velocity 5i
sphere B: mass 6, velocity -2i
A hits B: along i, e = 3/7
find energy_lost"""


@pytest.mark.parametrize(
    ("working", "verdicts", "mistake"),
    [
        (
            "½(4)(5+1)² + ½(6)(2+2)²\n= 72 + 48 = 120 J",
            ["false", "follows"],
            "energy-of-difference",
        ),
        ("½(4)(5-1)² = 32", ["false"], "energy-of-difference"),
        ("½×4×25 + ½×6×4 = 62", ["true"], None),  # on the way
        ("½(4)(25-1) = 48", ["true"], None),
        ("4×5 - 6×2 = 8", ["true"], None),  # nobody knows what of
    ],
)
def test_numbers_without_a_name_are_the_answer_if_their_mistake_has_one(
    working: str, verdicts: list[str], mistake: str | None
) -> None:
    solution = restitution.solve(restitution.parse(HEAD_ON))
    lines = restitution.mark(solution, working).lines
    assert [line.verdict for line in lines] == verdicts
    first = lines[0].mistake
    assert (None if first is None else first.id) == mistake


ELASTIC = """sphere A: mass 1, velocity 4i
sphere B: mass 1, velocity -2i
A hits B: along i, e = 1
find velocity(A)"""


@pytest.mark.parametrize(
    ("line", "mistake"),
    [
        ("CLM 4 + 2 = v + w", "momentum-sign"),
        ("NEL w + v = 4 + 2", "restitution-sign"),
        ("4 + 2 = v + w", None),
    ],
)
def test_the_law_that_a_line_names_decides_of_which_its_mistake_is(
    line: str, mistake: str | None
) -> None:
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    solution = restitution.solve(restitution.parse(ELASTIC))
    (judged,) = restitution.mark(solution, line, letters=letters).lines
    assert judged.mistake is not None and judged.mistake.id == mistake


PARTED = """sphere A: mass 2, velocity 2i + j
sphere B: mass 3/2, velocity -2i + 3j
A hits B: along i
given velocity(A) = -i + j
find e"""


@pytest.mark.parametrize("line", ["sep speed 3 and approach speed 4\ne = 4/3", "e = 4/3"])
def test_a_coefficient_upside_down_is_no_slip_and_no_datum(line: str) -> None:
    *_, last = restitution.mark(restitution.solve(restitution.parse(PARTED)), line).lines
    assert last.mistake is not None and last.mistake.id == "restitution-inverted"


def name_of(statement: str, working: str) -> str | None:
    marking = restitution.mark(restitution.solve(restitution.parse(statement)), working)
    line = marking.json()["lines"][-1]
    assert line["verdict"] == "false"
    name: str | None = line["mistake"]["id"]
    return name


ROUNDED = """
sphere A: mass 2, velocity 5 at 60°
sphere B: mass 3, velocity 4 at 150°
A hits B: along i, e = 1/2
find impulse
"""
IN_LINE = """
sphere A: mass 4, velocity 5i
sphere B: mass 6, velocity -2i
A hits B: along i, e = 1/2
find impulse
"""


def test_an_impulse_of_rounded_speeds_is_named() -> None:
    """The speed of B is 2.003, and he has 2; along one line it is the sign that is wrong."""
    assert name_of(ROUNDED, "I = 3(4 - 2) = 6") == "impulse-of-speeds"
    assert name_of(ROUNDED, "I = 3(4) - 3(2) = 6") == "impulse-of-speeds"
    assert name_of(ROUNDED, "I = 3(4 - 1) = 9") != "impulse-of-speeds"
    assert name_of(IN_LINE, "I = 6(2.2 - 2) = 1.2") != "impulse-of-speeds"


LOST = """
wall W: along i
sphere P: mass 2, velocity 10 at theta to W
P hits W
given tan(theta) = 3/4, energy_lost = 27
find e
"""


def test_squares_without_a_root_show_where_e_stands() -> None:
    assert name_of(LOST, "73 = 6² + (8e)²") == "restitution-parallel"
    assert name_of(LOST, "73 = 5² + (8e)²") is None
    assert name_of(LOST, "73 = 8² + (5e)²") != "restitution-parallel"


THREE = """
sphere A: mass m, velocity u i
sphere B: mass m, at rest
sphere C: mass 2m, at rest
A hits B: along i
B hits C: along i, e = e
find velocity(B), velocity(C)
"""


def test_a_law_at_a_later_impact_has_the_right_velocity_from_before_it() -> None:
    assert name_of(THREE, "m(1+e)u/2 = mp + 2mq\nq - p = eu") is None


ACROSS = """
sphere A: mass m, velocity 3u i + 4u j
sphere B: mass 3m, velocity u i
A hits B: along j, e = e
find along(velocity(A), j)
"""
SLOWED = """
sphere A: mass 2, velocity 5i + j
sphere B: mass 3, at rest
A hits B: e = e
given velocity(A) = 2i - 2j
find impulse
"""
CORNER = """
wall W: along i
wall X: along j
sphere P: mass 3, velocity 10 at theta to W
P hits W: e = 1/2
P hits X: e = 1/4
given tan(theta) = 4/3
find total_energy_lost
"""
TURNED = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given tan(alpha) = 3/2, deflection(P) = 90°
let beta = angle(velocity(P), W)
find energy_lost/energy(0)
"""
HALVED = """
sphere A, B: mass m
sphere A: velocity u at 60°
sphere B: at rest
A hits B: along i, e = 1/2
find speed(A), speed(B)
"""


@pytest.mark.parametrize(
    ("statement", "line", "name"),
    [
        (ACROSS, "3mu + 3mu = mp + 3mq", "sine-cosine"),
        (SLOWED, "I = 2(√8 - √26) = -4.54", "impulse-of-speeds"),
        (CORNER, "loss = ½×3×(10 - 4.27)² = 49.2", "energy-of-difference"),
        (CORNER, "loss = ½×3×(10 - 3)² = 73.5", None),
        (TURNED, "fraction lost = 1 - e² = 65/81", "energy-fraction-of-line"),
        (TURNED, "tan β = tan α/e", "restitution-inverted"),
        (HALVED, "speed A = u/8", None),  # the component across is lost, or that along taken for it
    ],
)
def test_lines_of_the_nineteenth_scripts_have_their_names(
    statement: str, line: str, name: str | None
) -> None:
    assert name_of(statement, line) == name


FOUND = """
sphere A: mass 3, velocity 4i + 2j
sphere B: mass 5, velocity -i
A hits B
given velocity(A) = i - 2j
find e
"""
SLOWER = """
wall AB: along i
wall BC: along j
sphere P: mass 2, velocity 13 at theta to AB
given tan(theta) = 5/12
P hits AB: e = 3/5
P hits BC
given speed(P) = 5
find e
"""
HEAVIER = """
sphere A: mass 3m, velocity u at 45°
sphere B: mass m, at rest
A hits B: along i, e = 1/3
find energy_lost/energy(0)
"""
APART = """
sphere A: mass m, velocity 2u i, radius r
sphere B: mass 2m, velocity -u i, radius r
A hits B: offset 1.2 r, e = 1/4
find energy_lost
"""
UPRIGHT = """
sphere A: mass 3, velocity 2i + 3j
sphere B: mass 1, velocity -i - j
A hits B: along j, e = 1/2
find velocity(A), velocity(B)
"""
STRUCK_AT_SIX = """
wall W: along j
sphere P: velocity 3i + 2j
P hits W: e = 1/3
find velocity(P)
"""
FORTY_FIVE = """
wall W: along i
sphere P: mass m, velocity u at 60° to W
P hits W
given angle(velocity(P), W) = 45°
find impulse
"""


@pytest.mark.parametrize(
    ("statement", "line", "name"),
    [
        (FOUND, "e = 23/17 = 1.35", "restitution-inverted"),
        (SLOWER, "5 = e√153", "restitution-whole-speed"),
        (HEAVIER, "fraction = 1/6 ÷ 3/4 = 2/9", "energy-fraction-of-line"),
        (APART, "KE after = ½m(1.6u²) + ½(2m)(0.04u²) = 0.84mu²", "energy-component-missing"),
        (UPRIGHT, "vA = -i + 1.5j", "across-exchanged"),
        (UPRIGHT, "vB - vA = ½(-3i - 4j)", "restitution-whole-speed"),
        (STRUCK_AT_SIX, "after: -3i + ⅔j", "restitution-parallel"),
        (FORTY_FIVE, "perp before: ucos60 = 0.5u", "sine-cosine"),
    ],
)
def test_values_and_vectors_show_laws_that_are_used_wrongly(
    statement: str, line: str, name: str
) -> None:
    assert name_of(statement, line) == name


STRUCK = (
    "sphere A: mass 3m, velocity 4u i\nsphere B: mass 2m, at rest\nA hits B: along i, e = 3/4\n"
)
OF_UNITS = STRUCK.replace("3m", "m").replace("2m", "3m")


@pytest.mark.parametrize(
    ("statement", "line", "name"),
    [
        (STRUCK, "I = 3m × 4.2u = 12.6mu", "masses-exchanged"),
        (STRUCK, "I = 2m(4u - 1.2u)", "masses-exchanged"),
        (OF_UNITS, "I = m × 7u/4", "mass-omitted"),
    ],
)
def test_an_impulse_with_the_mass_of_the_other_sphere_is_named(
    statement: str, line: str, name: str
) -> None:
    assert name_of(f"{statement}find impulse", line) == name


HEAVY = """
sphere A: mass 1, velocity 4i + 3j
sphere B: mass 3, at rest
A hits B: along i, e = 1/2
find velocity(A), velocity(B)
"""
BOTH_WAYS = """
sphere A: mass m, velocity u i
sphere B: mass 2m, at rest
A hits B: along i, e = e
find velocity(A)
"""


@pytest.mark.parametrize(
    ("statement", "line", "name"),
    [
        (HEAVY, "velocity of A = 0.5i + 3j", "sign"),
        (BOTH_WAYS, "v = u(1 + 2e)/3", "sign"),
        (HEAVY, "4 = 3w - v\nw - v = 2", "momentum-sign"),
    ],
)
def test_a_sign_in_a_value_is_no_sign_of_a_law(statement: str, line: str, name: str) -> None:
    """Where no term of a law stands in it, its sign alone is wrong."""
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    marking = restitution.mark(restitution.parse(statement), line, letters=letters).json()
    first, *_ = marking["lines"]
    assert first["verdict"] == "false"
    assert first["mistake"]["id"] == name


def test_of_two_walls_a_law_is_altered_at_one() -> None:
    """Newton's law at the second wall is stated in numbers; e is put across as well."""
    statement = (
        "wall AB: along i\nwall BC: along j\nsphere P: velocity 8i - 6j\n"
        "P hits AB: e = 1/3\nP hits BC: e = 3/4\nfind velocity(P)"
    )
    lines = "x: 3/4 × 8 = 6 to the left\ny: 3/4 × 2 = 1.5"
    _, line = restitution.mark(restitution.parse(statement), lines).json()["lines"]
    assert line["mistake"]["id"] == "across-changed"
    assert line["mistake"]["leads_to"] == {"velocity(P)": "−6𝐢 + (3/2)𝐣"}


AGAINST = """
sphere A: mass 2m, velocity 2u i + u j
sphere B: mass m, velocity -u i
A hits B: along i, e = 1/3
find velocity(A), velocity(B), energy_lost/energy(0) as a percentage
"""
AGAINST_THREE = AGAINST.replace("velocity 2u", "velocity 5u").replace("mass m,", "mass 3m,")
RAIL = """
wall W: along 4i + 3j
sphere P: mass 1, velocity 10i
P hits W: e = 1/3
find velocity(P)
"""
SQUARE = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given deflection(P) = 90°, tan(alpha) = 2
find e
"""
STILL = """
sphere A: mass 2, velocity 4i + 5j
sphere B: mass 3, at rest
A hits B: along i, e = 1/2
find velocity(A), velocity(B), speed(A)
"""
GONE = """
wall W: along i
sphere P: mass 0.2, velocity 20 at 30° to W
P hits W: e = 3/5
find energy_lost, impulse
"""


@pytest.mark.parametrize(
    ("statement", "lines", "names"),
    [
        # B moves along the line of centres: its speed is its component, with another sign.
        (
            AGAINST,
            "4mu + mu = 2mv + mw\nw - v = 1/3(2u - u)",
            ["momentum-sign"],  # with B as it is taken there, the law below is right
        ),
        # 13u is 3(5u) - 2u as well, in which no mass is seen.
        (AGAINST_THREE, "13u = 2v + 3w", ["momentum-sign"]),
        # What follows has the component along the wall as it was.
        (
            RAIL,
            "perp before = 6\nperp after = 6\nv = 8(4i + 3j)/5 + 6(-3i + 4j)/5",
            ["restitution-omitted"],
        ),
        # Both lines above are true, and decide e: 1 is the e of no law.
        (SQUARE, "tan β = e tan α = 2e\nα + β = 90 so tan β = 1/2\ne = 1", [None]),
        # B has what A has lost; of a speed nobody knows.
        (STILL, "velocity of A = 0.4i\nvelocity of B = 2.4i + 5j", ["across-exchanged"]),
        (STILL, "velocity of A = 0.4i\nvelocity of B = 2.4i", ["across-changed"]),
        (STILL, "speed of A = 0.4", [None]),
        (AGAINST, "percentage = (8/3)/(4 + 1/2) × 100 = 59.3%", ["energy-fraction-of-line"]),
        (GONE, "I = 0.2 × 1.6 × 20 cos 30 = 5.54", ["sine-cosine"]),
        (GONE, "energy lost = 1/2 × 0.2(400 - 36) = 36.4", ["energy-component-missing"]),
    ],
)
def test_of_several_names_the_lines_decide(
    statement: str, lines: str, names: list[str | None]
) -> None:
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    letters = letters if "sphere A" in statement else {}
    marking = restitution.mark(restitution.parse(statement), lines, letters=letters).json()
    false = [line for line in marking["lines"] if line["verdict"] == "false"]
    assert [line["mistake"]["id"] for line in false] == names


def test_a_time_that_goes_on_from_an_earlier_part_has_no_name() -> None:
    """Who has the velocity of part (a) wrong had it wrong there."""
    statement = (
        "wall V: along j, through (0, 0)\nwall W: along j, through (5, 0)\n"
        "sphere P: mass 2, at (2, 0), velocity -4i + 3j\nP hits V: e = 1/2\n"
        "part a\nfind time(1), velocity(P)\nP hits W: e = 1/4\npart b\nfind time(2)"
    )
    (line,) = restitution.mark(restitution.parse(statement), "time = 5/4", part="b").json()["lines"]
    assert line["verdict"] == "false"
    assert line["mistake"]["id"] is None


YARD = """
wall AB: along i
wall BC: along j
sphere P: mass 0.5, velocity 8i - 6j
P hits AB: e = 1/3
part a
find velocity(P), speed(P)
P hits BC: e = 3/4
part b
find velocity(P), total_energy_lost
"""
DIAGONAL = """
wall W: along i
sphere P: mass 2, velocity 4i - 4j
P hits W: e = 3/4
find velocity(P)
"""
FENCE = """
wall W: along i
sphere P: mass 3, velocity 8 at 30° to W
P hits W: e = 1/4
find speed(P)
"""


@pytest.mark.parametrize(
    ("statement", "part", "lines", "verdicts", "name"),
    [
        # Both squares are missing.
        (YARD, "a", "v = 8i + 2j\nspeed = √(8 + 2) = 3.16", "TF", "square-not-taken"),
        # Of the whole path, and the half is left out of both energies.
        (YARD, "b", "KE before = 0.5 × 100 = 50\nKE after = 0.5 × 40 = 20", "F>", "energy-no-half"),
        # Both components are 4, so none is seen to be taken for the other.
        (DIAGONAL, None, "velocity after = 4i - 3j", "F", "restitution-sign"),
        # In both components, and each is sine for cosine.
        (FENCE, None, "parallel 8 sin 30 = 4\nperp 1/4 × 8 cos 30 = √3", "F>", "sine-cosine"),
    ],
)
def test_what_is_wrong_twice_is_one_mistake(
    statement: str, part: str | None, lines: str, verdicts: str, name: str
) -> None:
    marking = restitution.mark(restitution.parse(statement), lines, part=part).json()
    signs = {"true": "T", "false": "F", "follows": ">"}
    assert "".join(signs[line["verdict"]] for line in marking["lines"]) == verdicts
    (mistake,) = (line["mistake"] for line in marking["lines"] if line["mistake"])
    assert mistake["id"] == name
