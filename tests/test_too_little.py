"""Where too little is known, what is missing is named, and how it is written."""

from __future__ import annotations

import pytest
import sympy as sp

from restitution import solve
from restitution.expression.enclosed import Enclosed
from restitution.language import parse
from restitution.solving.algebra.forms import open_in

LINE = "the line of centres of A and B"
WRITTEN = "(write 'A hits B: along …')"

SPHERES = """\
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, velocity 2u at beta
"""
PLAIN = """\
sphere A: mass 2, velocity 5 at 30°
sphere B: mass 3, velocity 4 at 120°
"""
WALL = "wall W\nsphere P: mass m, velocity u at alpha\nP hits W\n"

# A statement, and what each of its items says; None where it is answered.
OPEN = {
    "wall W: along theta\nsphere P: velocity u i\nP hits W: e = 1/3\nfind impulse": [
        "the impulse needs the mass of P",
    ],
    PLAIN + "A hits B: e = 2/3\nfind speed(A), energy_lost, impulse": [
        f"speed(A) needs {LINE} {WRITTEN}",
        f"the energy lost needs {LINE} {WRITTEN}",
        f"the impulse needs {LINE} {WRITTEN}",
    ],
    SPHERES + "A hits B\nfind deflection(A), angle(velocity(A), velocity(B))": [
        f"deflection(A) needs {LINE} {WRITTEN}",
        f"angle(velocity(A), velocity(B)) needs {LINE} {WRITTEN}",
    ],
    SPHERES + "A hits B: e = 1/2\nfind range of deflection(A)\nshow speed(A) = u/2": [
        f"the range needs {LINE} {WRITTEN}",
        f"this claim needs {LINE} {WRITTEN}",
    ],
    SPHERES + "A hits B: e = 1/2\nfind maximum of deflection(A) over alpha": [
        f"the maximum needs {LINE} {WRITTEN}",
    ],
    PLAIN + "A hits B: e = 1/2\nfind line_of_centres": [
        f"{LINE} is not fixed by what is given {WRITTEN}",
    ],
    WALL + "given deflection(P) = 90°\nfind alpha": [
        (
            "alpha is not fixed by what is given while the direction of the wall W is open too "
            "(write 'wall W: along …')"
        ),
    ],
    WALL + "find tan(deflection(P))": [
        "tan(deflection(P)) needs the direction of the wall W (write 'wall W: along …')",
    ],
    "wall W\nsphere P: velocity 3i - 4j\nP hits W\ngiven speed(P) = 4\nfind e, direction(W)": [
        "e needs the direction of the wall W (write 'wall W: along …')",
        (
            "the direction of the wall W is not fixed by what is given while e is open too "
            "(write 'wall W: along …')"
        ),
    ],
    WALL + "find direction(W)": [
        ("the direction of the wall W is not fixed by what is given (write 'wall W: along …')"),
    ],
    "sphere A: mass 2, velocity u at 30°\nsphere B: mass 3, at rest\nA hits B: e = 2/3\n"
    "given speed(A) = 2\nfind u": [
        f"there are more unknowns than facts that could fix them: {LINE}, and u {WRITTEN}",
    ],
    # What can be found is found.
    PLAIN + "A hits B: e = 2/3\ngiven direction(A) = 90°\nfind line_of_centres, speed(A)": [
        None,
        None,
    ],
    "sphere A: mass m, velocity u i\nsphere B: mass m, at rest\nA hits B: e = 1/2\n"
    "given direction(B) = 30°\nfind velocity(A), line_of_centres": [None, None],
}


@pytest.mark.parametrize("text", OPEN)
def test_what_is_open_is_named(text) -> None:
    items = solve(parse(text)).parts[None].items
    assert [item.error and (item.error.kind, item.error.message) for item in items] == [
        said and ("missing", said) for said in OPEN[text]
    ]
    assert all(item.answers for item in items if item.error is None)


@pytest.mark.parametrize("at", [0, 2])
def test_a_value_rests_on_what_is_not_known_though_that_is_zero_at_a_sample(at: int) -> None:
    speed, mass = sp.Symbol("_speed", real=True), sp.Symbol("m", positive=True)
    samples = [{"_speed": Enclosed.of(at), "m": Enclosed.of(3)}]
    assert open_in(mass * (1 + speed), samples) == ["_speed"]
    assert open_in(mass * (1 + speed - speed), samples) == []
