"""What is wrong with a text is mended by the fixes that its messages offer."""

from __future__ import annotations

import json
import pickle

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from typer.testing import CliRunner

from restitution.cli.commands.app import app
from restitution.errors import StatementError
from restitution.expression.words import WORDS
from restitution.language import parse
from restitution.mending import Edit, Fix, mended

HEAD = (
    "sphere A: mass 1, velocity 3i\nsphere B: mass 2, at rest\nwall W: along j\nA hits B: along i\n"
)

# What students write, behind a head of two spheres, a wall and an impact; and what it becomes.
BROKEN = {
    # bodies
    "sphere C, mass 2": "sphere C: mass 2",
    "sphere C mass 2": "sphere C: mass 2",
    "sphere C has mass 2": "sphere C: mass 2",
    "ball C: mass 2": "sphere C: mass 2",
    "Sphere C: mass 2": "sphere C: mass 2",
    "sphere C: mas 2": "sphere C: mass 2",
    "sphere C: speed 3 at 30°": "sphere C: velocity 3 at 30°",
    "sphere C: velocity 3 at 60° clockwise from -i": "sphere C: velocity 3 at -60° from -i",
    "sphere C: velocity 3 at theta clockwise": "sphere C: velocity 3 at -theta",
    "sphere C: speed 3 m/s at 30°": "sphere C: velocity 3 m/s at 30°",
    "sphere C: velocity 3 ms at 30°": "sphere C: velocity 3 m/s at 30°",
    "sphere C: mass = 2, velocity = 3i": "sphere C: mass 2, velocity 3i",
    "sphere C: m = 2, u = 3i": "sphere C: mass 2, velocity 3i",
    "sphere C: mass 2 velocity 3i": "sphere C: mass 2, velocity 3i",
    "particle C mass 2 velocity 3i": "sphere C: mass 2, velocity 3i",
    "sphere C: mass 2; velocity 3i": "sphere C: mass 2, velocity 3i",
    "sphere C: mass 2 and velocity 3i": "sphere C: mass 2, velocity 3i",
    "sphere C: mass 2,5": "sphere C: mass 2.5",
    "sphere C: mass=2, velocity=-3i": "sphere C: mass 2, velocity -3i",
    "sphere C: mass =2, velocity= (3, 4)": "sphere C: mass 2, velocity (3, 4)",
    "W hits B": "B hits W",
    "W hits A: e = 1/2": "A hits W: e = 1/2",
    "A strikes W: coefficient of restitution e": "A hits W",
    "A hits B: along i, e": "A hits B: along i",
    "A hits B: e, along i": "A hits B: along i",
    "A hits B: e = 1, impact parameter 2r": "A hits B: e = 1, offset 2r",
    "A hits W then B": "A hits W\nA hits B",
    "A hits B and then hits W": "A hits B\nA hits W",
    "given they move at right angles after collision": (
        "given angle(velocity(A), velocity(B)) = 90°"
    ),
    "given the spheres separate at right angles": "given angle(velocity(A), velocity(B)) = 90°",
    "find the angle through which it is deflected": "find deflection(A)",
    "find the angle by which the ball is turned": "find deflection(A)",
    "find total momentum before": "find momentum(0)",
    "find the total linear momentum before the collision, e": "find momentum(0), e",
    "find total momentum after impact": "find momentum",
    "find the ratio of the kinetic energies": "find energy(A)/energy(B)",
    "find ratio of their speeds after the impact": "find speed(A)/speed(B)",
    "find velocity(A) in cm/s": "find velocity(A)",
    "find speed(A) in km/h, energy(A) in J": "find speed(A), energy(A)",
    "sphere C: velocity [3, 4]": "sphere C: velocity (3, 4)",
    "sphere C: velocity <3, 4>": "sphere C: velocity (3, 4)",
    "sphere C: initially at rest": "sphere C: at rest",
    "sphere C: velocity 3 at an angle of 30° to i": "sphere C: velocity 3 at 30° from i",
    "sphere C: velocity 3 at 30° to the wall W": "sphere C: velocity 3 at 30° to W",
    "sphere C: mass 3 at (1, 2)": "sphere C: mass 3, at (1, 2)",
    "sphere C: at rest at (1, 2)": "sphere C: at rest, at (1, 2)",
    "sphere C: velocity 5m/s, 30°": "sphere C: velocity 5m/s at 30°",
    "sphere C: speed = 5, direction 30°": "sphere C: velocity 5 at 30°",
    "sphere C: moving at 5 m/s at 30°": "sphere C: velocity 5 m/s at 30°",
    "wall V: at 60° to i": "wall V: along 60°",
    "wall V: parallel to i": "wall V: along i",
    "wall V along i": "wall V: along i",
    "wall V: y = 2": "wall V: along i, through (0, 2)",
    "point N: 0, 0": "point N: (0, 0)",
    "two spheres C and D of mass 2": "sphere C, D: mass 2",
    "C is a sphere of mass 2": "sphere C: mass 2",
    "let C be a smooth sphere": "sphere C",
    "a wall V is parallel to i": "wall V: along i",
    "wall V: perpendicular to W": "wall V: along 1 at 90° from direction(W)",
    "wall V: at right angles to the wall W": "wall V: along 1 at 90° from direction(W)",
    "wall V: parallel to W": "wall V: along direction(W)",
    "wall V: at 60° to W": "wall V: along 1 at 60° from direction(W)",
    "wall V: inclined at an angle of 60° to W": "wall V: along 1 at 60° from direction(W)",
    "wall V: along 60° from i": "wall V: along 60°",
    "sphere C: velocity u perpendicular to W": "sphere C: velocity u at 90° to W",
    "sphere C: velocity 3 at right angles to the wall W": "sphere C: velocity 3 at 90° to W",
    "sphere C: velocity 3 directly towards W": "sphere C: velocity 3 at 90° to W",
    "sphere C: velocity 3 towards W at 30°": "sphere C: velocity 3 at 30° to W",
    "sphere C: velocity u parallel to W": "sphere C: velocity u at 0° from direction(W)",
    "A hits W at right angles": "A hits W\ngiven velocity(A, before) perpendicular to W",
    "A hits W\ngiven A rebounds at 20° to W": "A hits W\ngiven angle(velocity(A), W) = 20°",
    "A hits W\ngiven A leaves W at 20° to W": "A hits W\ngiven angle(velocity(A), W) = 20°",
    "A hits W\ngiven velocity(A) at 20° to W": "A hits W\ngiven angle(velocity(A), W) = 20°",
    "given the path of A is turned through 90 degrees": "given deflection(A) = 90 degrees",
    "find angle of rebound from W": "find angle(velocity(A), W)",
    "C has mass 2": "sphere C: mass 2",
    "C: mass 2": "sphere C: mass 2",
    "V: along 30°": "wall V: along 30°",
    "N: (1, 2)": "point N: (1, 2)",
    "sphere: mass 2": "sphere P: mass 2",
    "sphere C: 2 kg, 3i - 4j": "sphere C: mass 2 kg, velocity 3i - 4j",
    "sphere C: 2kg, (3i - 4j) m/s": "sphere C: mass 2kg, velocity (3i - 4j) m/s",
    "Sphere C of mass 3 kg moving at 4 m/s at 30°": "sphere C: mass 3 kg, velocity 4 m/s at 30°",
    "sphere C is at rest with mass 3": "sphere C: at rest, mass 3",
    "sphere C (mass 2, velocity 3i)": "sphere C: mass 2, velocity 3i",
    "sphere C - mass 2 - velocity 3i": "sphere C: mass 2, velocity 3i",
    "sphere C: m=2, v=3i": "sphere C: mass 2, velocity 3i",
    "sphere C: velocity at rest": "sphere C: at rest",
    "sphere C: velocity 5 at 30° j": "sphere C: velocity 5 at 30° from j",
    "sphere C: velocity 5 at 3i + 4j": "sphere C: velocity 5 at 0° from 3i + 4j",
    "sphere C: velocity 3i 4u j": "sphere C: velocity 3i + 4u j",
    "sphere C: speed 5 at 30 to W": "sphere C: velocity 5 at 30° to W",
    "sphere C: velocity u at alpha to W, tan alpha = 3/4": (
        "sphere C: velocity u at alpha to W\ngiven tan alpha = 3/4"
    ),
    "sphere C: velocity u at alpha where sin(alpha) = 3/5": (
        "sphere C: velocity u at alpha\ngiven sin(alpha) = 3/5"
    ),
    "sphere C: at rest initially": "sphere C: at rest",
    "sphere C: velocity 3 along i": "sphere C: velocity 3i",
    "sphere C: velocity 3 m/s in the direction of j": "sphere C: velocity 3j m/s",
    "sphere C: velocity u along 3i + 4j": "sphere C: velocity u at 0° from 3i + 4j",
    "sphere C: velocity 3 parallel to i": "sphere C: velocity 3i",
    "sphere C: velocity u to the left": "sphere C: velocity -u i",
    "sphere C: velocity 3 at 30° to the wall": "sphere C: velocity 3 at 30° to W",
    "sphere C: velocity 3 at 30° to the horizontal": "sphere C: velocity 3 at 30° from i",
    "sphere C: velocity 3 making an angle of 30° with i": "sphere C: velocity 3 at 30° from i",
    "wall V: along the x-axis": "wall V: along i",
    "wall V along j:": "wall V: along j",
    "wall V: perpendicular to i": "wall V: along j",
    "wall V: in direction 3i + 4j": "wall V: along 3i + 4j",
    # events
    "A hits W: 1/2": "A hits W: e = 1/2",
    "A hits W: impulse = 10": "A hits W\ngiven impulse = 10",
    "A hits W: impulse of 10 N s": "A hits W\ngiven impulse = 10 N s",
    "A hits W: J = 10, e = 1/2": "A hits W: e = 1/2\ngiven impulse = 10",
    "A hits W: e = 1/2, speed(A) = 3": "A hits W: e = 1/2\ngiven speed(A) = 3",
    "A hits B: along i, velocity(B) = (1, 0), e = 1/2": (
        "A hits B: along i, e = 1/2\ngiven velocity(B) = (1, 0)"
    ),
    "A hits W directly": "A hits W",
    "A hits the wall with e = 1/2": "A hits W: e = 1/2",
    "A hits B along j with e = 1/2": "A hits B: along j, e = 1/2",
    "A strikes B when the line of centres is parallel to j": "A hits B: along j",
    "A and B collide with coefficient of restitution 1/2": "A hits B: e = 1/2",
    "A then hits B with coefficient e": "A hits B: e = e",
    "A collides with B": "A hits B",
    "A collides with the wall": "A hits W",
    "A strikes the wall": "A hits W",
    "A then hits W": "A hits W",
    "A hits w": "A hits W",
    "a hits W": "A hits W",
    "B is struck by A": "A hits B",
    "A and B collide": "A hits B",
    "A hits W, e = 1/2": "A hits W: e = 1/2",
    "A hits W with e = 1/2": "A hits W: e = 1/2",
    "A hits W: coefficient of restitution 0.5": "A hits W: e = 0.5",
    "A receives an impulse of 3i": "A receives 3i",
    "A hits B (e = 1/2)": "A hits B: e = 1/2",
    "A hits B, e 1/2": "A hits B: e = 1/2",
    "A hits B: along j e 1/2": "A hits B: along j, e = 1/2",
    "A hits B: along 3i + 4j 0.5": "A hits B: along 3i + 4j, e = 0.5",
    "A hits B: e = 1, perpendicular distance 1/2": "A hits B: e = 1, offset 1/2",
    "collision between A and B": "A hits B",
    "impulse of 3i on A": "A receives 3i",
    # facts
    "A is at rest": "given A is at rest",
    "A is at rest after": "given A is at rest",
    "A is at rest after the impact": "given A is at rest",
    "A comes to rest": "given A at rest",
    "given A at rest after": "given A at rest",
    "given A hits W": "given A will hit W",
    "given A at rest after the collision": "given A at rest",
    "given A comes to rest": "given A at rest",
    "given A is at rest afterwards": "given A is at rest",
    "given 60% of the kinetic energy is lost": "given energy_lost = 60% of energy(0)",
    "given the speed of A after is 2 m/s": "given speed(A) = 2 m/s",
    "given energy_lost = half of energy(0)": "given energy_lost = 1/2 of energy(0)",
    "given energy_lost = 1/4 of the initial kinetic energy": "given energy_lost = 1/4 of energy(0)",
    "given 3/8 of the kinetic energy is lost": "given energy_lost = 3/8 of energy(0)",
    "given speed(A) : speed(B) = 2 : 3": "given speed(A)/speed(B) = 2/3",
    "given A is turned through a right angle": "given deflection(A) = 90°",
    "given A moves at 60° to the line of centres": (
        "given angle(velocity(A), line_of_centres) = 60°"
    ),
    "A moves at 60° to the line of centres": "given angle(velocity(A), line_of_centres) = 60°",
    "given A moves at right angles to i": "given velocity(A) perpendicular to i",
    "given the path of A makes 60° with i": "given angle(velocity(A), i) = 60°",
    "given velocity(A) makes an angle of 60° with W": "given angle(velocity(A), W) = 60°",
    "given the speed of A is half its original speed": "given speed(A) = 1/2 speed(A, 0)",
    "show that deflection(A) cannot exceed 30°": "show deflection(A) <= 30°",
    "show that speed(B) does not exceed 3": "show speed(B) <= 3",
    "show that speed(B) is not less than 3": "show speed(B) >= 3",
    "show e >= 1/2 and e <= 1": "show e >= 1/2\nshow e <= 1",
    "given alpha is acute": "given 0° < alpha < 90°",
    "find maximum of deflection(A) as e varies": "find maximum of deflection(A) over e",
    "find the impulse A exerts on B": "find impulse(B)",
    "find the magnitude of the impulse that A exerts on B": "find impulse",
    "state speed(A)": "find speed(A)",
    "sphere C: velocity 3 perpendicular to i": "sphere C: velocity 3 at 90° from i",
    "B hits A: line of centres at 30° to i": "B hits A: along 30°",
    "B hits A: along 30° to i": "B hits A: along 30°",
    "given energy_lost = 40% of the initial kinetic energy": "given energy_lost = 40% of energy(0)",
    "coefficient of restitution 0.5": "given e = 0.5",
    "The coefficient of restitution is 0.5": "given e = 0.5",
    "given the coefficient of restitution is 1/2": "given e = 1/2",
    "The speed of A is 3": "given speed(A) = 3",
    "speed of A = 3": "given speed(A) = 3",
    "given velocity(A) is perpendicular to velocity(B)": (
        "given velocity(A) perpendicular to velocity(B)"
    ),
    "given A is deflected by 30°": "given deflection(A) = 30°",
    "A is turned through 30°": "given deflection(A) = 30°",
    "e = 0.5": "given e = 0.5",
    "let v be the speed of A": "let v = speed(A)",
    "given 16 percent of the energy is lost": "given energy_lost = 16 percent of energy(0)",
    "given speed of A is twice speed of B": "given speed(A) = 2 speed(B)",
    "given that the speeds of A and B are equal": "given speed(A) = speed(B)",
    "given that after the collision A is at rest": "given A is at rest",
    "show that A and B move in opposite directions": "show velocity(A) opposite to velocity(B)",
    "show B moves faster than A": "show speed(B) > speed(A)",
    "given half of the kinetic energy is lost": "given energy_lost = 1/2 energy(0)",
    "given A loses 16% of its kinetic energy": (
        "given energy(A, before) - energy(A) = 16% of energy(A, before)"
    ),
    "given A loses 6 J of kinetic energy": "given energy(A, before) - energy(A) = 6",
    "given B rebounds with speed 2.4": "given speed(B) = 2.4",
    "given sphere B moves off with a speed of 2 after the collision": "given speed(B) = 2",
    "B leaves with speed sqrt(5)/2": "given speed(B) = sqrt(5)/2",
    "given B has speed 2": "given speed(B) = 2",
    "given the kinetic energy is halved": "given energy_lost = 1/2 energy(0)",
    "given the kinetic energy of A is halved": "given energy(A) = 1/2 energy(A, before)",
    "given A's speed is doubled": "given speed(A) = 2 speed(A, before)",
    "given the speed of A is unchanged": "given speed(A) = speed(A, before)",
    "find range of e such that speed(B) > 1": "given speed(B) > 1\nfind range of e",
    "A hits B: along 40° from -j": "A hits B: along 1 at 40° from -j",
    "given A loses half of its speed": "given speed(A) = 1/2 speed(A, before)",
    "given A loses 1/4 of its kinetic energy": (
        "given energy(A, before) - energy(A) = 1/4 energy(A, before)"
    ),
    "given A loses two thirds of its kinetic energy": (
        "given energy(A, before) - energy(A) = 2/3 energy(A, before)"
    ),
    "given A loses a quarter of its initial speed": "given speed(A) = 3/4 speed(A, before)",
    "given A moves at right angles to its original direction": (
        "given velocity(A) perpendicular to velocity(A, 0)"
    ),
    "given the direction of motion of A is turned through 30°": "given deflection(A) = 30°",
    # questions
    "find v(B)": "find velocity(B)",
    "find speed(A) to 2 decimal places, e": "find speed(A), e",
    "find speed(A) correct to three significant figures": "find speed(A)",
    "find change in velocity of A, e": "find velocity(A) - velocity(A, before), e",
    "find vA, vB": "find velocity(A), velocity(B)",
    "find v of A after": "find velocity(A)",
    "find v after": "find velocity(A)",
    "find u(A)": "find velocity(A, 0)",
    "find the speeds of both spheres": "find speed(A), speed(B)",
    "find velocities after the collision": "find velocity(A), velocity(B)",
    "find the speed of A after the first collision": "find speed(A, 1)",
    "find KE lost as a percentage": "find energy_lost/energy(0) as a percentage",
    "find percentage of KE lost": "find energy_lost/energy(0) as a percentage",
    "find what percentage of the kinetic energy is lost": (
        "find energy_lost/energy(0) as a percentage"
    ),
    "find energy lost in per cent": "find energy_lost/energy(0) as a percentage",
    "find % of KE lost": "find energy_lost/energy(0) as a percentage",
    "find KE loss %": "find energy_lost/energy(0) as a percentage",
    "find energy_lost as a percentage of energy(0)": "find energy_lost/energy(0) as a percentage",
    "find energy_lost as a fraction of the initial energy": "find energy_lost/energy(0)",
    "find how much kinetic energy is lost": "find energy_lost",
    "find percentage of KE lost by A": (
        "find (energy(A, before) - energy(A))/energy(A, before) as a percentage"
    ),
    "find speed of A & B": "find speed(A), speed(B)",
    "find |velocity(A)|": "find abs(velocity(A))",
    "find the magnitude of the velocity of A": "find speed(A)",
    "find velocity of A relative to B": "find velocity(A) - velocity(B)",
    "find ratio of speed(A) to speed(B)": "find (speed(A))/(speed(B))",
    "find the component of velocity of A parallel to W": "find along(velocity(A), W)",
    "find the KE of A before the collision": "find energy(A, before)",
    "find the change in momentum of A": "find impulse(A)",
    "find the magnitude of the impulse exerted on A by B": "find abs(impulse(A))",
    "find the angle A makes with the wall": "find angle(velocity(A), W)",
    "find angle between A and i": "find angle(velocity(A), i)",
    "find angle between velocities": "find angle(velocity(A), velocity(B))",
    "Find the value of e.": "find e",
    "work out e": "find e",
    "part (b) find e": "part (b)\nfind e",
    "(a) find the velocity of A immediately after the collision": "part a\nfind velocity(A)",
    "find e range": "find range of e",
    "find velocity of A": "find velocity(A)",
    "find the velocity of A": "find velocity(A)",
    "find the speeds of A and B": "find speed(A), speed(B)",
    "find speed of B after": "find speed(B)",
    "find speed of B after the impact": "find speed(B)",
    "find the speed of A before the impact": "find speed(A, before)",
    "find kinetic energy of A": "find energy(A)",
    "find the kinetic energy of A": "find energy(A)",
    "what is the speed of A": "find speed(A)",
    "find the angle A is deflected through": "find deflection(A)",
    "find total momentum": "find momentum",
    "find the kinetic energy lost": "find energy_lost",
    "find the percentage of kinetic energy lost": "find energy_lost/energy(0) as a percentage",
    "find impulse on B": "find impulse(B)",
    "find the impulse of A on B": "find impulse(B)",
    "find the coefficient of restitution": "find e",
    "find speed(a)": "find speed(A)",
    "find speed(A) when e = 1": "given e = 1\nfind speed(A)",
    "find speed(A) at e = 1": "given e = 1\nfind speed(A)",
    "find range of speed(A) for e = 1": "given e = 1\nfind range of speed(A)",
    "find range of speed(A) with e <= 1/2 in terms of u": (
        "given e <= 1/2\nfind range of speed(A) in terms of u"
    ),
    "find range of speed(A) over e": "unknown e\nfind range of speed(A)",
    "find range of speed(A) as e varies": "unknown e\nfind range of speed(A)",
    "find speed(A), find speed(B)": "find speed(A), speed(B)",
    "find speed(A) in m/s": "find speed(A)",
    "find tan^-1(3/4)": "find arctan(3/4)",
    "Find sped(A).": "find speed(A)",
    "prove that the speed of A is 1": "show speed(A) = 1",
    "a) find speed(A)": "part a\nfind speed(A)",
    "given e = ½ find speed(A)": "given e = ½\nfind speed(A)",
    # of one impact, of a motion from start to end
    "find the kinetic energy lost in the first impact": "find energy_lost(1)",
    "find the magnitude of the impulse in the first collision": "find impulse(1)",
    "find the speed of the ball immediately after the first impact": "find speed(A, 1)",
    "find the angle between the initial and final directions of motion of A": (
        "find angle(velocity(A, 0), velocity(A))"
    ),
    "find the angle through which the path of A is deflected": "find deflection(A)",
    "find ratio of speed(A, 0) to speed(A)": "find (speed(A, 0))/(speed(A))",
    "find velocity(A) in the form ai + bj": "find velocity(A)",
    "find the acute angle between velocity(B) and W": "find angle(velocity(B), W)",
    # of a wall
    "find the distance between A and the origin": "find distance(A, (0, 0))",
    "find the distance of A from B when it hits B": "find distance(A, B)",
    "find the coordinates of A": "find position(A)",
    "sphere C: velocity 3 at 30° to the normal to W": "sphere C: velocity 3 at 90° - 30° to W",
    "find the angle between velocity(B) and the normal to W": (
        "find angle(velocity(B), line_of_centres)"
    ),
    "wall V: perpendicular to 3i - 4j": "wall V: along 4i + 3j",
    "wall V: perpendicular to the vector -2i + j": "wall V: along i + 2j",
    "find a vector parallel to W": "find direction(W)",
    "find speed with which B hits W": "find speed(B, before)",
    "find range of e such that B hits W": "B hits W\nfind range of e",
}


def mistakes(text):
    try:
        parse(text)
    except StatementError as error:
        return [error, *error.others]
    return []


def mend(text, clicks=6):
    """A text with the first fix that is offered, again and again; and how many there were."""
    for count in range(clicks):
        fixes = [fix for mistake in mistakes(text) for fix in mistake.fixes]
        if not fixes:
            return text, count
        text = mended(text, fixes[0])
    return text, clicks


def assert_that_cures_hold(text) -> None:
    """With a cure in place nothing is wrong at the lines that it writes."""
    for mistake in mistakes(text):
        for fix in mistake.fixes:
            first = min(edit.line for edit in fix.edits)
            last = max(edit.end_line + edit.text.count("\n") for edit in fix.edits)
            then = mended(text, fix)
            assert not [m for m in mistakes(then) if first <= (m.line or 0) <= last], fix


@pytest.mark.parametrize("line", BROKEN)
def test_every_cure_holds(line) -> None:
    assert_that_cures_hold(HEAD + line)
    # Whatever else is broken.
    assert_that_cures_hold(f"{HEAD}sphere ?\n{line}\nfind ((")


@pytest.mark.parametrize("line", BROKEN)
def test_broken_lines_are_mended(line) -> None:
    assert mistakes(HEAD + line)
    text, clicks = mend(HEAD + line)
    assert not mistakes(text)
    assert text.removeprefix(HEAD) == BROKEN[line]
    assert clicks <= 2


# Those of which one click is promised.
@pytest.mark.parametrize(
    "line",
    [
        "sphere C, mass 2",
        "sphere C: speed 3 at 30°",
        "find velocity of A",
        "A is at rest",
        "A is at rest after",
        "given A at rest after",
        "A collides with B",
        "find speed of B after",
        "A strikes the wall",
    ],
)
def test_one_click(line) -> None:
    text, clicks = mend(HEAD + line)
    assert clicks == 1
    assert parse(text)


@pytest.mark.parametrize(
    ("line", "same"),
    [
        ("given energy_lost = 40% of energy(0)", "given energy_lost = 40%*energy(0)"),
        ("given A is at rest", "given A at rest"),
        ("sphere C: is at rest", "sphere C: at rest"),
    ],
)
def test_what_is_simply_read(line, same) -> None:
    assert parse(HEAD + line) == parse(HEAD + same)


def test_names_in_small_letters_are_mended_wherever_they_stand() -> None:
    text = """\
title about a ball and a wall
sphere a: mass 2, velocity 3i, at (3a, a)
sphere b: mass 3, at rest # a comment on a
wall w: along j
a hits b: along i
b hits w
given speed(b) = 1, a at rest
find velocity(a), distance(a, b), a, speed of b
"""
    assert (
        mended(text, mistakes(text)[0].fixes[0])
        == """\
title about a ball and a wall
sphere A: mass 2, velocity 3i, at (3a, a)
sphere B: mass 3, at rest # a comment on a
wall W: along j
A hits B: along i
B hits W
given speed(B) = 1, A at rest
find velocity(A), distance(A, B), a, speed of B
"""
    )
    text, _ = mend("sphere ball, mass 2\nwall w: along j\nball strikes w\nfind speed(ball)")
    assert text == "sphere Ball: mass 2\nwall W: along j\nBall hits W\nfind speed(Ball)"


@pytest.mark.parametrize(
    "line",
    [
        "find e for A hits B",
        "sphere C: 2",
        "sphere C: mass 2 3",
        "sphere C: velocity 3i 4",
        "given",
        "find ((",
        "A B C",
        "find the total distance travelled by A",
        "find the total time",
    ],
)
def test_where_no_cure_is_certain_none_is_offered(line) -> None:
    (mistake,) = mistakes(HEAD + line)
    assert mistake.fixes == ()


def test_what_is_suggested_for_a_whole_line_reads() -> None:
    (mistake,) = mistakes(HEAD + "A is at rest after")
    assert mistake.message == (
        "cannot read 'A is at rest after': did you mean 'given A is at rest'?"
    )


@given(
    st.lists(
        st.one_of(
            st.sampled_from([word for line in BROKEN for word in line.split()]),
            st.sampled_from(sorted(WORDS)),
        ),
        min_size=1,
        max_size=8,
    ).map(" ".join)
)
@settings(max_examples=200, deadline=None)
def test_mending_comes_to_an_end(line) -> None:
    """Whatever the words: no text comes again, and in the end none is offered."""
    text, seen = HEAD + line, set()
    while fixes := [fix for mistake in mistakes(text) for fix in mistake.fixes]:
        assert_that_cures_hold(text)
        assert text not in seen
        seen.add(text)
        text = mended(text, fixes[0])
        assert len(seen) < 20


@given(st.lists(st.sampled_from(list(BROKEN)), min_size=2, max_size=6, unique=True))
@settings(max_examples=40, deadline=None)
def test_cures_hold_whatever_else_is_broken(lines) -> None:
    assert_that_cures_hold(HEAD + "\n".join(lines))


def test_of_many_mistakes_the_first_are_mended() -> None:
    """Each cure of what lines say costs a reading of the whole: they are few, and enough."""
    text = HEAD + "find speed(a)\n" * 30
    found = mistakes(text)
    assert [bool(each.fixes) for each in found] == [True] * 5 + [False] * 15
    text, clicks = mend(text, 40)
    assert (mistakes(text), clicks) == ([], 30)


def test_edits_are_made_from_the_end() -> None:
    fix = Fix("", (Edit(1, 1, 1, 2, "xyz"), Edit(2, 2, 2, 2, "!"), Edit(1, 3, 2, 1, "")))
    assert mended("abc\r\nde", fix) == "xyzbd!e"


def test_fixes_come_through_a_pipe() -> None:
    (mistake,) = mistakes("fnd e")
    # Dask, where it is loaded, sends along what an error arose from.
    assert mistake.__cause__ is None
    assert mistake.__context__ is None
    assert pickle.loads(pickle.dumps(mistake)).fixes == mistake.fixes != ()


# --- doubts -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("line", "meant"),
    [
        ("given energy_lost = 60%", "given energy_lost = 60% of energy(0)"),
        ("given 60% = energy_lost", "given 60% of energy(0) = energy_lost"),
        ("A hits W\ngiven energy_lost = 60%", "A hits W\ngiven energy_lost = 60% of energy(1)"),
        ("A hits W\ngiven energy_lost(1) < 6%", "A hits W\ngiven energy_lost(1) < 6% of energy(0)"),
        ("show total_energy_lost = 60%", "show total_energy_lost = 60% of energy(0)"),
        ("given energy = 40%", "given energy = 40% of energy(0)"),
        ("given energy(A) = 40%", "given energy(A) = 40% of energy(A, 0)"),
    ],
)
def test_a_share_of_nothing_is_doubtful(line, meant) -> None:
    (note,) = parse(HEAD + line).notes
    assert "was read as 0." in note.message
    text = mended(HEAD + line, note.fixes[0])
    assert text == HEAD + meant
    assert parse(text).notes == ()


@pytest.mark.parametrize(
    "line",
    [
        "given e = 60%",
        "given energy_lost/energy(0) = 60%",
        "given energy_lost = 60% energy(0)",
        "given energy_lost = 0.6",
    ],
)
def test_other_shares_are_not(line) -> None:
    assert parse(HEAD + line).notes == ()


def test_a_percentage_of_what_has_a_unit_is_doubtful() -> None:
    (note,) = parse(HEAD + "find energy_lost as a percentage, energy_lost/energy(0)").notes
    assert note.message == (
        "a percentage needs a ratio, and energy_lost is in J: did you mean energy_lost/energy(0)?"
    )
    text = mended(HEAD + "find energy_lost as a percentage", note.fixes[0])
    assert text == HEAD + "find energy_lost/energy(0) as a percentage"
    assert parse(text).notes == ()


@pytest.mark.parametrize(
    ("line", "character", "name", "read"),
    [
        ("sphere С: mass 2", "С", "U+0421, Cyrillic capital letter es", "sphere C: mass 2"),
        ("find ѕрееd(A)", "ѕ", "U+0455, Cyrillic small letter dze", "find speed(A)"),
        ("fınd speed(A)", "ı", "U+0131, Latin small letter dotless i", "find speed(A)"),
        ("find speed(Β)", "Β", "U+0392, Greek capital letter beta", "find speed(B)"),
        ("А hits В: along і", "А", "U+0410, Cyrillic capital letter a", "A hits B: along i"),
    ],
)
def test_a_letter_that_looks_like_a_latin_one_is_named(line, character, name, read) -> None:
    (mistake,) = mistakes(HEAD + line)
    (fix,) = mistake.fixes
    assert mistake.message.startswith(f"'{character}' is {name}: did you mean '")
    assert mended(HEAD + line, fix) == HEAD + read


def test_a_name_in_look_alikes_is_known_elsewhere() -> None:
    (mistake,) = mistakes("sphere Р: velocity 3i\nwall W: along j\nP hits W\nfind speed(P)")
    assert mistake.line == 1


@pytest.mark.parametrize(
    ("line", "texts"),
    [
        ("sphere C: mass 1,000, velocity 3i", ["1000", "1.000"]),
        ("sphere C: mass 2, velocity -3i + 1,500j", ["1500 ", "1.500 "]),
        ("given impulse = 12,345", ["12345", "12.345"]),
        ("sphere C: mass 1,234,567", ["1234567"]),
        ("sphere C: mass 1,234.5", ["1234"]),
        ("sphere C: mass 0,125", ["."]),
        ("sphere C: velocity 1,25i", ["."]),
        ("given energy_lost = 1,2345", ["."]),
    ],
)
def test_a_comma_before_three_figures_may_part_thousands(line, texts) -> None:
    """The likelier reading comes first, and the message names both."""
    with pytest.raises(StatementError) as caught:
        parse(HEAD + line)
    fixes = caught.value.fixes
    assert [fix.edits[0].text for fix in fixes] == texts
    assert all(not mistakes(mended(HEAD + line, fix)) for fix in fixes)
    assert len(texts) == 1 or all(f"'{text.strip()}'" in caught.value.message for text in texts)


@pytest.mark.parametrize(
    ("line", "texts"),
    [
        ("find v_A", ["find velocity(A)", "find speed(A)"]),
        ("find u_B", ["find velocity(B, 0)", "find speed(B, 0)"]),
        ("find v", ["find velocity(A)", "find velocity(B)"]),
        ("find J", ["find impulse"]),
        ("find theta", []),
        ("given v_A = 3\nfind e", ["given speed(A) = 3\nfind e"]),
        ("A hits W\nwall V: along x", ["A hits W\nwall V: along i"]),
    ],
)
def test_a_letter_that_stands_for_nothing_is_doubtful(line, texts) -> None:
    (note,) = parse(HEAD + line).notes
    assert [mended(HEAD + line, fix) for fix in note.fixes] == [HEAD + each for each in texts]


@pytest.mark.parametrize(
    "line",
    [
        "find e",
        "sphere C: mass k\nfind k",
        "given speed(A) = v_A\nfind v_A",
        "sphere C: velocity x i\nwall V: along x",
    ],
)
def test_a_letter_that_stands_elsewhere_is_not(line) -> None:
    assert parse(HEAD + line).notes == ()


def test_a_stage_behind_a_letter_is_doubtful() -> None:
    (note,) = parse(f"{HEAD}A hits W\nfind e(2)").notes
    assert note.message == "e(2) was read as e times 2: a letter has no stage, so write e"
    (fix,) = note.fixes
    assert mended(f"{HEAD}A hits W\nfind e(2)", fix) == f"{HEAD}A hits W\nfind e"
    assert parse(f"{HEAD}A hits W\nfind e*2").notes == ()


@pytest.mark.parametrize("typed", ["16 percent", "16 per cent", "16percent"])
def test_per_cent_is_read(typed) -> None:
    assert parse(f"{HEAD}given energy_lost = {typed} of energy(0)") == parse(
        f"{HEAD}given energy_lost = 16% of energy(0)"
    )


# --- questions in words -------------------------------------------------------------------------

IN_WORDS = [
    (
        "A smooth sphere A of mass 2 kg is moving with speed 5 m s^-1 when it collides with a "
        "smooth sphere B of mass 3 kg, which is at rest. Find the speed of each after the impact."
    ),
    (
        "Two small smooth spheres P and Q have masses 2m and 3m respectively.\n"
        "They move towards each other on a smooth horizontal plane and collide obliquely.\n"
        "\n"
        "(a) Find, in terms of u, the speed of P immediately after the collision.\n"
        "(b) Find the kinetic energy lost in the collision."
    ),
    "A ball is projected along a smooth floor so that it strikes a vertical wall at 60°.",
    "[In this question i and j are perpendicular unit vectors in a horizontal plane.]",
    "1. A particle P of mass 0.3 kg is moving in a straight line when it is struck by a bat.",
]


@pytest.mark.parametrize("text", IN_WORDS)
def test_a_question_in_words_is_one_mistake(text) -> None:
    (mistake,) = mistakes(text)
    assert mistake.line == 1
    assert mistake.message.startswith("this is a question in words: write one fact a line")
    (fix,) = mistake.fixes
    kept = mended(text, fix)
    assert kept == "\n".join(f"# {row}" if row else row for row in text.split("\n"))
    assert mistakes(kept) == []


def test_beside_a_question_in_words_the_statement_is_read() -> None:
    text = IN_WORDS[0] + "\n" + HEAD + "find sped(A)"
    words, slip = mistakes(text)
    assert words.message.startswith("this is a question in words")
    assert (slip.line, slip.fixes[0].label) == (6, "Replace 'sped' by 'speed'")


@pytest.mark.parametrize("line", BROKEN)
def test_a_slip_is_no_question_in_words(line) -> None:
    assert all("in words" not in each.message for each in mistakes(HEAD + line))


@pytest.mark.parametrize(
    "line",
    [
        "A collides with B at some unknown time along the line of centres with speed",
        "find the speed of the sphere when it has gone round the table again",
        "given that the spheres move on and never come near to each other again",
    ],
)
def test_nor_is_what_begins_as_a_line_does(line) -> None:
    assert all("in words" not in each.message for each in mistakes(HEAD + line))


# --- names in lines that cannot be read ---------------------------------------------------------

USES = "A hits W\nA hits B: along i\ngiven speed(A) = 2, B at rest\nfind e, angle(velocity(A), W)"


@pytest.mark.parametrize(
    "line",
    [
        "sphere A mass 2 ( velocity 3i",
        "sphere A, mass",
        "Sphere A: ((",
        "spere A: mass 2",
        "ball A of mass 2 or 3",
        "A is a sphere of ((",
        "let A be a sphere with ((",
        "A: mass ((",
        "particle A mass",
    ],
)
def test_a_name_in_a_broken_line_is_known(line) -> None:
    text = f"{line}\nsphere B: mass 3, at rest\nwall W: along j\n{USES}"
    assert [each.line for each in mistakes(text)] == [1]


def test_names_of_several_broken_lines_are_known() -> None:
    text = f"two spheres A and B ((\nwalll W along j:\n{USES}"
    assert [each.line for each in mistakes(text)] == [1, 2]


def test_the_wall_is_the_only_one_though_it_has_no_name() -> None:
    text = "wall: along i\nsphere P: velocity 3i - j\nP hits the wall: e = 1/2\nfind speed(P)"
    assert mend(text)[0] == text.replace("the wall", "W").replace("wall:", "wall W:")


def test_a_name_that_no_line_declares_is_told_once() -> None:
    text = "sphere A: velocity 3i\nA hits W\nW hits A\nfind e\nA hits W"
    (mistake,) = mistakes(text)
    assert mistake.line == 2
    assert "unknown name 'W'" in mistake.message


def test_the_use_of_a_small_name_is_no_mistake_of_its_own() -> None:
    text = "sphere a: mass 2\nsphere b: mass 3\na hits b: along i\nfind speed(a)"
    (mistake,) = mistakes(text)
    assert mistake.line == 1
    assert not mistakes(mended(text, mistake.fixes[0]))


def test_a_line_of_centres_goes_to_the_line_of_the_impact() -> None:
    head = HEAD.replace(": along i", ": e = 1/2")
    (mistake,) = mistakes(head + "the line of centres is parallel to 3i + 4j\nfind e")
    assert mended(head + "the line of centres is parallel to 3i + 4j\nfind e", *mistake.fixes) == (
        head.replace("e = 1/2", "e = 1/2, along 3i + 4j") + "find e"
    )


def test_what_is_left_is_told_beside_a_cure_that_is_not_enough() -> None:
    (mistake,) = mistakes(HEAD + "sphere C: moving with speed 3")
    assert mistake.fixes == ()
    assert mistake.message == (
        "cannot read 'moving with speed': did you mean 'velocity'? Besides, expected a vector "
        "after 'velocity', and 3 has no direction: write 'velocity 3i' where it is along i, or "
        "'velocity 3 at 30°'"
    )


def test_alternatives_have_a_button_each() -> None:
    (mistake,) = mistakes(HEAD + "find v(B)")
    assert [fix.label for fix in mistake.fixes] == [
        "Replace 'v(B)' by 'velocity(B)'",
        "Replace 'v(B)' by 'speed(B)'",
    ]


# --- as others get it -------------------------------------------------------------------------


def test_the_command_shows_the_mended_line(tmp_path) -> None:
    path = tmp_path / "one.impact"
    path.write_text(HEAD + "sphere C, speed 3 at 30°\na) find e\n", encoding="utf-8")
    result = CliRunner().invoke(app, ["check", str(path)])
    assert result.exit_code == 2
    assert "    5 | sphere C, speed 3 at 30°\n" in result.stderr
    assert "  fix | sphere C: velocity 3 at 30°\n" in result.stderr
    assert "  fix | part a\n  fix | find e\n" in result.stderr


def test_the_command_shows_a_mended_line_longer_than_a_row(tmp_path) -> None:
    path = tmp_path / "one.impact"
    lost = "given A loses 75% of its kinetic energy, energy_lost = 1/4\n"
    path.write_text(HEAD + lost + "find e\n", encoding="utf-8")
    result = CliRunner().invoke(app, ["check", str(path)])
    cure = "energy(A, before) - energy(A) = 75% of energy(A, before), energy_lost = 1/4"
    assert f"  fix | given {cure}\n" in result.stderr


def test_the_command_checks_in_json(tmp_path) -> None:
    path = tmp_path / "one.impact"
    path.write_text("sphere A: mass 2 kg\nfnd e", encoding="utf-8")
    result = CliRunner().invoke(app, ["check", "--json", str(path)])
    assert result.exit_code == 2
    (error,) = json.loads(result.stdout)["errors"]
    assert error["fixes"] == [
        {
            "label": "Replace 'fnd' by 'find'",
            "edits": [{"line": 2, "column": 1, "end_line": 2, "end_column": 4, "text": "find"}],
        }
    ]
    path.write_text("sphere A: mass 400 g\nfind mass(A)", encoding="utf-8")
    result = CliRunner().invoke(app, ["check", "--json", str(path)])
    assert result.exit_code == 0
    found = json.loads(result.stdout)
    assert found["errors"] == []
    (note,) = found["notes"]
    assert note["fixes"][0]["edits"] == [
        {"line": 1, "column": 16, "end_line": 1, "end_column": 21, "text": "0.4"}
    ]


def test_a_name_behind_a_quantity_goes_into_its_brackets() -> None:
    text = "wall W: along i\nsphere A: velocity 8 at 60°\nA hits W: e = 1/2\nfind deflection A"
    assert mend(text)[0].endswith("find deflection(A)")


@pytest.mark.parametrize("angle", ["60", "60.0", "7.5"])
def test_degrees_without_their_sign_get_it(angle: str) -> None:
    text = f"wall W: along i\nsphere A: velocity 8 at {angle} to W\nA hits W\ngiven e = 1\nfind e"
    (note,) = parse(text).notes
    assert mended(text, note.fixes[0]) == text.replace(f"at {angle}", f"at {angle}°")


def test_a_quotient_that_is_an_angle_is_not_cut() -> None:
    text = "wall W: along i\nsphere A: velocity 8 at 90/2 to W\nA hits W: e = 1\nfind speed(A)"
    assert all(note.fixes == () for note in parse(text).notes)
