"""Spheres of which one lies beside the other's path: an angle for the line of centres.

Where the offset is no number of radii, the line of centres has a letter for the acute angle that it
makes with the path, whose sine is the offset over the distance of the centres. So no root of these
is carried through the principles.
"""

from __future__ import annotations

from collections.abc import Set as AbstractSet

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.data.offset_angles import offset_angle
from restitution.explaining.lines.derivation import (
    Fact,
    Link,
    Meaning,
    Move,
    Relation,
    equality,
    numbers_in,
)
from restitution.explaining.lines.trees import trees_of
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Apply,
    Letter,
    Name,
    Polar,
    Quantity,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.formulas.named_angles import free_letter
from restitution.planning.writing.desk import Desk
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import cancelled, expanded
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.problem import Extremum, Problem, Range, Value
from restitution.solving.equations.solution import Solution
from restitution.solving.story.letters import roles
from restitution.vector import Vector


def paths_beside(solution: Solution, desk: Desk) -> dict[int, Vector]:
    """The paths of impacts whose line of centres gets a letter for its angle with the path.

    That is so where the offset is to be found in radii or stays a letter, both spheres move along
    the path, and nothing that is given speaks of the line of centres.
    """
    fact = next((fact for fact in desk.facts if fact.id == "axis 1"), None)
    branches = [branche for part in solution.parts.values() for branche in part.branches]
    if fact is None or not branches or any(map(_speaks_of_centres, desk.facts)):
        return {}
    own = offset_angle(fact.relation.only[0], roles(solution.problem))
    if own is None:
        return {}
    sought = all(letters(own.sine) & branche.values.keys() for branche in branches)
    over = _is_over(solution.problem, letters(own.sine))
    if not (sought or over or _is_its_range(solution, letters(own.sine))):
        return {}
    values = [fact for fact in desk.facts if _is_value_of(fact, letters(own.sine))]
    if any(fact.part is None or not over for fact in values):
        return {}
    one, other = (branches[0].story.velocity(body, 0) for body in desk.events[0].bodies)
    size = sp.sqrt(expanded(one.dot(one)))
    path = Vector(*(tidy(component / size) for component in one))
    if tidy(one.cross(other)) != 0 or not all(value.is_number for value in path):
        return {}
    return {1: path}


def _is_its_range(solution: Solution, names: AbstractSet[str]) -> bool:
    """Whether all that is asked is the range of the offset."""
    items = [item.item for part in solution.parts.values() for item in part.items]
    return all(
        isinstance(item, Range)
        and isinstance(item.expression, Letter)
        and item.expression.name in names
        for item in items
    )


def _is_over(problem: Problem, names: AbstractSet[str]) -> bool:
    """Whether the offset stays a letter: all that is asked are values in terms of it.

    Or a greatest or least angle is asked for over that.
    """
    items = [item for part in problem.parts for item, _ in problem.asked(part)]
    if len(names) > 1 and all(isinstance(item, Value) for item in items):
        return True
    return any(
        isinstance(item, Extremum)
        and is_quantity(item.expression, *ANGLES)
        and isinstance(item.over, Letter)
        and item.over.name in names
        for item in items
    )


def _is_value_of(fact: Fact, names: AbstractSet[str]) -> bool:
    """Whether a given fact says what one of some letters is."""
    match fact.relation.options:
        case ((Link(Letter(name), "="),),):
            return fact.kind == "given" and name in names
    return False


def _speaks_of_centres(fact: Fact) -> bool:
    """Whether a given fact has a line of centres in it."""
    return fact.kind == "given" and any(
        is_quantity(node, "line_of_centres")
        for tree in trees_of(fact.relation)
        for node in walk(tree)
    )


def write_angle(scene: Scene, number: int) -> int:
    """The letter for the angle between a line of centres and the path."""
    letter = scene.model.frames[number].angle
    assert letter is not None
    first = scene.bodies(number)[0]
    asked = Quantity(
        "angle",
        (Quantity("velocity", (Name(first),), 0), Quantity("line_of_centres", (), number)),
    )
    return scene.desk.write(Move("let"), (), Meaning(letter.name, asked, angle="acute"))


def frame_by_offset(scene: Scene, number: int) -> Frame:
    """The frame of an impact whose line of centres has a letter for its angle with the path.

    What the offset says of that angle stands before all else.
    """
    own = scene.model.frames[number]
    fact = f"axis {number}"
    for equation in scene.of_offsets:
        if equation.fact.id == fact:
            write_sine(scene, equation)
    centres = Quantity("line_of_centres", (), number)
    refs = (write_angle(scene, number), fact)
    return Frame(number, None, centres, None, own.n, own.t, refs, 1)


def given_by_offsets(scene: Scene) -> tuple[GivenEquation, ...]:
    """What offsets say of the angles that have letters: their sines."""
    equations = []
    for number, frame in scene.model.frames.items():
        fact = scene.facts.get(f"axis {number}")
        if frame.angle is None or fact is None:
            continue
        own = offset_angle(fact.relation.only[0], roles(scene.problem))
        if own is None:
            continue
        sine = tidy(scene.scalar(own.sine))
        link = Link(Apply("sin", Letter(frame.angle.name)), "=", tree_of(sine))
        above, below = sp.fraction(cancelled(sine))
        residual = below * sp.sin(frame.angle) - above
        equations.append(GivenEquation(fact, link, (residual,)))
    return tuple(equations)


def open_angles(scene: Scene) -> frozenset[sp.Symbol]:
    """The angles of lines of centres with a path of which the offset is left open.

    Their ratios are not put in: what is asked over the offset is worked out by the angle.
    """
    final = scene.model.final
    angles = {frame.angle for frame in scene.model.frames.values()}
    return frozenset(
        angle
        for equation in scene.of_offsets
        for angle in equation.residuals[0].free_symbols & angles
        if _is_over(
            scene.problem,
            {symbol.name for symbol in equation.residuals[0].free_symbols if symbol not in final},
        )
    )


def is_sine_of_an_offset(equation: GivenEquation) -> bool:
    """Whether a given equation is the sine of the angle by an offset."""
    return equation.fact.id.partition(" ")[0] == "axis"


def turns_from_an_offset(scene: Scene, body: str, number: int) -> bool:
    """Whether a sphere turns at a line of centres that an offset gives by its angle with the path.

    Its velocity after the impact does not stand as a vector.
    """
    if scene.desk.known(Quantity("velocity", (Name(body),), number)) is not None:
        return False
    fact = scene.facts.get(f"axis {number}")
    match None if fact is None else fact.relation.only[-1].right:
        case Polar(_, Apply("arcsin")):
            return True
    return False


def write_sine(scene: Scene, equation: GivenEquation) -> int:
    """The sine of the angle between a line of centres and the path, by an offset."""
    number = int(equation.fact.id.partition(" ")[2])
    premises = (write_angle(scene, number), equation.fact.id)
    return scene.desk.write(
        Move("define", "scalar-angle", number), premises, Relation(((equation.link,),))
    )


def ratios_by_offsets(
    scene: Scene, *values: sp.Expr
) -> tuple[dict[sp.Expr, sp.Expr], tuple[int, ...]]:
    """What the ratios of open angles in some values are by the offsets, and the lines of that."""
    ratios: dict[sp.Expr, sp.Expr] = {}
    lines: list[int] = []
    for equation in scene.of_offsets:
        for angle in equation.residuals[0].free_symbols & scene.kept:
            if not any(angle in value.free_symbols for value in values):
                continue
            sine = scene.scalar(equation.link.right)
            cosine = tidy(sp.sqrt(1 - sine**2))
            own = {"sin": sine, "cos": cosine, "tan": tidy(sine / cosine)}
            first = write_sine(scene, equation)
            lines.append(first)
            for name, size in own.items():
                ratio = getattr(sp, name)(angle)
                if not any(value.has(ratio) for value in values):
                    continue
                ratios[ratio] = size
                if name != "sin":
                    relation = equality(Apply(name, Letter(angle.name)), tree_of(size))
                    known = (first, f"acute: {angle.name}")
                    lines.append(scene.desk.write(Move("triangle"), known, relation))
    return ratios, tuple(lines)


def sine_of(scene: Scene, angle: str) -> GivenEquation | None:
    """What an offset says of the sine of an angle that has this letter; None of another one."""
    sine = Apply("sin", Letter(angle))
    return next((equation for equation in scene.of_offsets if equation.link.left == sine), None)


def angle_of_an_offset(scene: Scene, asked: Quantity) -> int | None:
    """The angle of a path with the line of centres, where the words above that line say it.

    That is so where the offset gives it in degrees. None of any other angle.
    """
    match asked:
        case Quantity(
            "angle", (Quantity("velocity", (Name(body),), 0), Quantity(_, (), int(number)))
        ):
            fact = scene.facts.get(f"axis {number}")
        case _:
            return None
    link = None if fact is None else fact.relation.only[0]
    own = None if link is None else offset_angle(link, roles(scene.problem))
    sine = None if own is None or asked.arguments[1] != own.axis else scene.scalar(own.sine)
    if sine is None or not (sp.asin(tidy(sine)) / sp.pi).is_Rational:
        return None
    assert fact is not None
    known = scene.desk.known(asked)
    if known is not None:
        return next(iter(numbers_in(known.refs)), None)
    letter = free_letter(scene, "angle")
    let = scene.desk.write(Move("let"), (), Meaning(letter, asked, angle="acute"), "silent")
    ratio = scene.judge.write(
        (Move("define", "scalar-angle", number),),
        (let, fact.id, f"velocity {body}"),
        equality(Apply("sin", Letter(letter)), tree_of(tidy(sine))),
        shown="silent",
    )
    if ratio is None:
        return None
    value = tree_of(sp.asin(tidy(sine)), angle=True)
    relation = equality(Letter(letter), value)
    line = scene.desk.write(Move("inverse"), (ratio, f"acute: {letter}"), relation, "silent")
    scene.desk.know(asked, scene.scalar(value), (line,))
    return line


__all__ = [
    "angle_of_an_offset",
    "frame_by_offset",
    "given_by_offsets",
    "is_sine_of_an_offset",
    "paths_beside",
    "ratios_by_offsets",
    "sine_of",
    "turns_from_an_offset",
    "write_sine",
]
