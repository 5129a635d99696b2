"""Units behind numbers: what is read, converted, refused, and when a letter is only a letter."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from restitution.errors import StatementError
from restitution.expression import units
from restitution.language import parse, to_statement
from restitution.mending import mended

HEAD = "sphere A\nsphere B\nwall W: along i\nA hits B\n"
# A line that is added to these four stands in line 5.

# What is typed, and the same in SI without units.
READ = {
    "sphere P: mass 0.4 kg": "sphere P: mass 0.4",
    "sphere P: mass 3/4 kg": "sphere P: mass 3/4",
    "sphere P: mass 400 g": "sphere P: mass 0.4",
    "sphere P: mass 400g, at rest": "sphere P: mass 0.4, at rest",
    "sphere P: mass 2 kilograms": "sphere P: mass 2",
    "sphere P: mass 2 Kg": "sphere P: mass 2",
    "sphere P: mass 2 KG": "sphere P: mass 2",
    "sphere P: mass 2 kgs": "sphere P: mass 2",
    "sphere P: mass 2, velocity 5 mps at 30°": "sphere P: mass 2, velocity 5 at 30°",
    "sphere P: velocity 5 m/s at 30°": "sphere P: velocity 5 at 30°",
    "sphere P: velocity 5 ms^-1 at 30°": "sphere P: velocity 5 at 30°",
    "sphere P: velocity 5 m s⁻¹ at 30 degrees": "sphere P: velocity 5 at 30°",
    "sphere P: velocity 5 m s−1 at 30 deg to W": "sphere P: velocity 5 at 30° to W",
    "sphere P: velocity 5 metres per second at 30°": "sphere P: velocity 5 at 30°",
    "sphere P: velocity 5 at 30° m/s": "sphere P: velocity 5 at 30°",
    "sphere P: velocity 5 m/s at 1 rad": "sphere P: velocity 5 at 1",
    "sphere P: velocity 36 km/h at 30°": "sphere P: velocity 10 at 30°",
    "sphere P: velocity 20 km/h at 30°": "sphere P: velocity 50/9 at 30°",
    "sphere P: velocity 3i + 4j m/s": "sphere P: velocity 3i + 4j",
    "sphere P: velocity (3i + 4j) m/s": "sphere P: velocity 3i + 4j",
    "sphere P: velocity 3 m/s i - 4 m/s j": "sphere P: velocity 3i - 4j",
    "sphere P: velocity 300i - 4j cm/s": "sphere P: velocity 3i - 0.04j",
    "sphere P: velocity (36, 18) km/h": "sphere P: velocity (10, 5)",
    "sphere P: velocity 3i+4jms^-1": "sphere P: velocity 3i + 4j",
    "sphere P: radius 2 m": "sphere P: radius 2",
    "sphere P: radius 2 cm, at (1 m, 20 cm)": "sphere P: radius 0.02, at (1, 0.2)",
    "sphere P: radius √2 mm": "sphere P: radius 0.001sqrt(2)",
    "wall V: from (0, 0) m to (400, 0) cm": "wall V: from (0, 0) to (4, 0)",
    "wall V: circle centre (0, 0) radius 3 m": "wall V: circle centre (0, 0) radius 3",
    "point N: (10 cm, 1)": "point N: (0.1, 1)",
    "A receives 2 Ns at 30°": "A receives 2 at 30°",
    "A receives 2i N s": "A receives 2i",
    "A receives (3i + 2j) kg m/s": "A receives 3i + 2j",
    "A reaches (3, 4) m": "A reaches (3, 4)",
    "A hits B: offset 20 cm": "A hits B: offset 0.2",
    "given energy_lost = 3 J": "given energy_lost = 3",
    "given impulse = 4 N s, mass(A) = 200 g": "given impulse = 4, mass(A) = 0.2",
    "given 2 m/s < speed(A) <= 18 km/h": "given 2 < speed(A) <= 5",
    "given velocity(A) = 3i m/s": "given velocity(A) = 3i",
    "given time(1) = 3 s, distance(A, B) = 2 m": "given time(1) = 3, distance(A, B) = 2",
    "given energy(A) - energy(B) = 12 joules": "given energy(A) - energy(B) = 12",
    "given angle(velocity(A), i) = 1 rad": "given angle(velocity(A), i) = 1",
    "sphere P: velocity u i\ngiven u = 18 km/h": "sphere P: velocity u i\ngiven u = 5",
    "sphere P: mass k, at rest\ngiven k = 300 g": "sphere P: mass k, at rest\ngiven k = 0.3",
    "show speed(A) = 3.2 m/s to 2 s.f.": "show speed(A) = 3.2 to 2 s.f.",
    "find distance(A, B, at 3 s)": "find distance(A, B, at 3)",
    "show speed(A) - 2 m/s > 0": "show speed(A) - 2 > 0",
    # One letter of the unit is a letter of the statement, another is none.
    "sphere P: mass 2m, velocity 3 m/s at 30°": "sphere P: mass 2m, velocity 3 at 30°",
    "sphere P: mass 2m, radius 5 cm": "sphere P: mass 2m, radius 0.05",
    "A receives 2i N s\npoint N: (0, 0)": "A receives 2i\npoint N: (0, 0)",
}


@pytest.mark.parametrize("line", READ)
def test_units_are_read(line) -> None:
    problem = parse(HEAD + line)
    assert problem == parse(HEAD + READ[line])
    assert parse(to_statement(problem)) == problem
    assert not parse(to_statement(problem)).notes


def unit_notes(problem):
    return [each for each in problem.notes if "was read as" in each.message]


@pytest.mark.parametrize("line", READ)
def test_units_draw_a_note_whose_fix_takes_them_out(line) -> None:
    """What is converted is told, with the value in SI to put in its place."""
    text = HEAD + line
    problem = parse(text)
    for _ in range(10):
        notes = unit_notes(parse(text))
        if not notes:
            break
        text = mended(text, notes[0].fixes[0])
        assert parse(text) == problem
    assert not unit_notes(parse(text))


def test_units_of_si_draw_no_note() -> None:
    """They are what is understood without them; what is converted is told."""
    assert not parse("sphere A: mass 2 kg, velocity 5 m/s at 30°\nsphere B: mass 3 kg").notes
    (note,) = parse("sphere A: mass 2 kg, velocity 36 km/h at 30°").notes
    assert str(note) == "line 1, column 34: 36 km/h was read as 10 m/s"


REFUSED = {
    "sphere P: mass 2 lb": (18, "the unit 'lb' is not read: the mass of P is in kg"),
    "sphere P: velocity 5 mph at 30°": (22, "g, cm, mm and km/h are read"),
    "sphere P: velocity 5 kg at 30°": (22, "of mass, and the velocity of P is in m/s"),
    "sphere P: mass 2 m/s": (18, "'m/s' is a unit of speed, and the mass of P is in kg"),
    "sphere P: radius 3 kg": (20, "the radius of P is in m"),
    "sphere P: mass 3 N": (18, "the unit 'N' is not read: the mass of P is in kg"),
    "sphere P: mass 3 J": (18, "'J' is a unit of energy, and the mass of P is in kg"),
    "sphere P: velocity 5 at 30 kg": (28, "the velocity of P is in m/s"),
    "sphere P: velocity 5 m/s at 30 kg": (32, "an angle takes ° or rad"),
    "sphere P: velocity 5 ms at 30°": (22, "did you mean 'm/s'?"),
    "sphere P: at (3 + 2 cm, 4)": (21, "behind one term of a sum"),
    "sphere P: velocity u/2 m/s at 30°": (24, "leave out 'm/s'"),
    "A hits B: e = 0.5 m/s": (19, "'m/s' is a unit of speed, and e has no unit"),
    "A receives 3i m/s": (15, "the impulse on A is in N s"),
    "given energy_lost = 3 kg": (23, "energy_lost is in J"),
    "given energy_lost = 3 kJ": (23, "the unit 'kJ' is not read: energy_lost is in J"),
    "given e = 3 kg": (13, "'kg' is a unit of mass"),
    "given speed(A)^2 = 9 m/s": (22, "leave out 'm/s'"),
    # letters of the unit are letters of the statement, and it does not fit
    "sphere P: mass 2m, radius 3 m/s": (29, "m is a letter of this statement"),
    "sphere P: mass 2 kg, velocity 4 kg at 30°\ngiven g = 9.8": (33, "g is a letter of this"),
}


@pytest.mark.parametrize("line", REFUSED)
def test_units_that_are_refused(line) -> None:
    column, said = REFUSED[line]
    with pytest.raises(StatementError) as caught:
        parse(HEAD + line)
    assert said in caught.value.message
    assert (caught.value.line, caught.value.column) == (5, column)
    for fix in caught.value.fixes:
        parse(mended(HEAD + line, fix))


@pytest.mark.parametrize(
    "lines",
    [
        "sphere P: mass 2m",
        "sphere P: mass 2m, radius 3m",
        "sphere P: mass m, radius 2 m",
        "sphere P: mass 2g, velocity g i",
        "given energy(A) = 12J\nfind J",
        "given impulse = 3J",
        "given time(1) = 3s\nunknown s",
        "given distance(A, B) = 2m\nfind e in terms of m",
        "let s = speed(A)\ngiven time(1) = 3s",
        "sphere P: velocity 2m i + 3j",
        "find 2m, 3 s",
        "given k = 2m",
        "sphere P: radius 2*m",
        "sphere P: radius sin 2m",
    ],
)
def test_letters_stay_letters(lines) -> None:
    problem = parse(HEAD + lines)
    assert not unit_notes(problem)
    assert parse(to_statement(problem)) == problem
    last = lines.splitlines()[-1].split()[-1][-1]
    assert last in "ij" or last in to_statement(problem).replace("mass", "")


def test_a_product_that_looks_like_a_unit_is_told() -> None:
    (note,) = parse("sphere A: mass 2cm, velocity c i, radius m").notes
    assert "'cm' was read as a product of letters" in note.message


@given(
    st.fractions(min_value=0, max_value=1000, max_denominator=60),
    st.sampled_from([("g", 1000), ("kg", 1)]),
)
@settings(max_examples=60, deadline=None)
def test_grams_are_exact(mass, unit) -> None:
    symbol, per = unit
    typed = parse(f"sphere A: mass {mass} {symbol}").spheres[0].mass
    plain = parse(f"sphere A: mass {mass / per}").spheres[0].mass

    def value(tree):
        return tree.value if hasattr(tree, "value") else tree.left.value / tree.right.value

    assert value(typed) == value(plain) == mass / per


def test_a_letter_behind_an_angle_is_a_letter():
    text = "wall W: along i\nsphere P: velocity 19 at 3{} to W\nP hits W: e = 1\nfind speed(P)"
    with_letter, plain = parse(text.format("m")), parse(text.format("*m"))
    assert with_letter.spheres == plain.spheres
    assert parse(text.format("0° m/s")).spheres == parse(text.format("0°")).spheres


@pytest.mark.parametrize("blank", ["", " "])
@pytest.mark.parametrize("unit", ["m s^-1", "m s^(-1)", "m s⁻¹", "m/s", "ms^-1"])
def test_a_unit_before_a_closing_bracket(unit, blank):
    text = "wall W: along i\nsphere P: velocity {}\nP hits W: e = 1\nfind speed(P)"
    measured = text.format(f"(3 {unit}){blank}i - (4 {unit}){blank}j")
    assert parse(measured).spheres == parse(text.format("3i - 4j")).spheres


WORDS = [
    "kg",
    "g",
    "cm",
    "mm",
    "m",
    "s",
    "J",
    "rad",
    "N",
    "newton",
    "newtons",
    "Newton",
    "kilometres",
    "km",
    "metre",
    "meters",
    "grams",
    "kilogram",
    "kilos",
    "centimeter",
    "millimetres",
    "sec",
    "seconds",
    "joules",
    "Joule",
    "radians",
    "lbs",
    "pound",
    "oz",
    "ounces",
    "stones",
    "tonne",
    "tons",
    "mg",
    "ft",
    "feet",
    "foot",
    "inch",
    "inches",
    "yards",
    "yd",
    "miles",
    "mi/h",
    "mph",
    "kph",
    "kmh",
    "knots",
    "minutes",
    "min",
    "hours",
    "hr",
    "ms",
    "kJ",
    "MJ",
    "mJ",
    "eV",
    "kcal",
    "kN",
    "Nm",
    "m/s",
    "cm/s",
    "km/h",
]


@pytest.mark.parametrize("word", WORDS)
def test_every_unit_is_seen_at_the_end_of_a_value(word):
    """No unit is missed for its first letter, which is looked at before anything else."""
    found = units.at_the_end(f"{word}, 3", 0)
    assert found is not None
    assert found.group() == word
    assert units.like_a_unit(word, 0) is (word not in ("g", "m", "s", "J", "N"))
