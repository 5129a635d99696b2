"""A given bound of an angle that may be obtuse, or of a direction: its cotangent falls."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Fact,
    Link,
    Move,
    Ref,
    Relation,
    Sign,
    equality,
)
from restitution.expression.tree import (
    RIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Quantity,
    Unit,
    has_standard_ratios,
    is_function,
    unsigned,
    walk,
)
from restitution.planning.angles.quantities import formula
from restitution.planning.angles.turn_lines import by_tangents
from restitution.planning.angles.wall_turns import sum_at_a_wall
from restitution.planning.closing.cotangents import write_ratio_of
from restitution.planning.formulas.angle_formulas import deflection_formula
from restitution.planning.formulas.named_angles import letter_of, ratio_line
from restitution.planning.formulas.velocity_formulas import body_and_stage, in_the_plane
from restitution.planning.inequalities.angles_bounded import BOUND, Bound, Bounded, solved_with
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.desk import NotPlannedError, together
from restitution.planning.writing.forms import swept, tree_of
from restitution.planning.writing.inequalities import without_signs
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene


def write_by_cotangent(worths: Worths, fact: Fact, link: Link, angle: Quantity) -> Bounded | None:
    """The cotangent of an angle compared with that of its bound, in letters.

    None where no line gives it, or nothing is left to be compared.
    """
    mark = worths.mark()
    try:
        written = _written(worths, fact, link, angle)
    except NotPlannedError:
        written = None
    if written is None:
        worths.back(mark)
    return written


def _written(worths: Worths, fact: Fact, link: Link, angle: Quantity) -> Bounded | None:
    scene = worths.scene
    limit = tidy(sp.cot(scene.scalar(link.right)))
    if link.sign not in FLIPPED or limit.has(sp.zoo):
        return None
    sign = FLIPPED[link.sign]
    if angle.kind == "angle":
        return by_cotangents(worths, Bound(fact.id, angle, link.sign, link.right), angle)
    worths.determine(Quantity("velocity", angle.arguments, angle.stage))
    letter, let = letter_of(scene, angle)
    pool: list[Ref] = [fact.id, let]
    if angle.kind == "direction":
        x, y = in_the_plane(scene, *body_and_stage(scene, angle))
        line: int | None = write_ratio_of(scene, angle, "cot", x, y)
        side = _side(worths, angle, [let, *y.whole, *worths.known_in(y.value)], y.value)
        if side is None:
            return None
        pool.append(side)
    else:
        line = _cotangent_at_a_wall(worths, angle, letter)
        line = line or _cotangent_of_deflection(worths, angle, letter, let)
        pool.append(f"0° <= {letter} <= 180°")
    if line is None:
        return None
    return _compared(worths, pool, line, letter, (sign, limit, tree_of(limit)))


def _compared(
    worths: Worths,
    pool: Sequence[Ref],
    line: int,
    letter: str,
    bound: tuple[Sign, sp.Expr, Expression],
) -> Bounded | None:
    """A bound of a cotangent by that of its angle, and the same in letters."""
    judge, (sign, limit, end) = worths.judge, bound
    right = worths.scene.desk.last_link(line).right
    cotangent = Apply("cot", Letter(letter))
    compared = judge.write(
        (Move("compare"),), [*pool, line], Relation(((Link(cotangent, sign, end),),))
    )
    stripped = without_signs(worths.scene, expanded(worths.value(right) - limit), sign)
    if compared is None or stripped is None:
        return None
    put = judge.write((Move("put"),), [compared, line], Relation(((Link(right, sign, end),),)))
    if put is None or limit.is_number:
        return None if put is None else (put, *stripped)
    return solved_with(worths, put, stripped, end)


def by_cotangents(worths: Worths, bound: Bound, angle: Quantity) -> Bounded | None:
    """The bound of an angle to **i** or **j** as one of its cotangent, which falls up to 180°.

    None where its tangent is no quotient, as that of an angle to a line is not.
    """
    scene = worths.scene
    limit = tidy(sp.cot(scene.scalar(bound.end)))
    shown = tree_of(limit)
    if not isinstance(bound.end, Degrees) or _is_beyond_the_table(bound.end):
        limit, shown = sp.Symbol(BOUND, real=True), Apply("cot", bound.end)
    if not any(isinstance(unsigned(side), Unit) for side in angle.arguments) or limit.has(sp.zoo):
        return None
    worths.determine_angle(angle)
    letter, let = letter_of(scene, angle)
    line = cotangent_line(scene, angle, letter, let)
    if line is None or bound.sign not in FLIPPED:
        return None
    pool = [bound.ref, let, f"0° <= {letter} <= 180°"]
    return _compared(worths, pool, line, letter, (FLIPPED[bound.sign], limit, shown))


def _is_beyond_the_table(angle: Degrees) -> bool:
    """Whether an obtuse angle has a cotangent that only a calculator knows: cot 110°."""
    return angle.value > RIGHT_ANGLE.value and not has_standard_ratios(angle.value)


def cotangent_line(scene: Scene, angle: Quantity, letter: str, let: Ref) -> int | None:
    """The line of the cotangent of an angle of which the tangent is defined by a quotient."""
    own = formula(scene, angle)
    match own.right:
        case Binary("/", above, below):
            value = tidy(1 / sp.sympify(own.value, strict=True))
            ratio, turned_over = Apply("cot", Letter(letter)), Binary("/", below, above)
            refs = together(own.refs, (let,))
            return ratio_line(scene, own.move, refs, ratio, turned_over, value)
    return None


def _side(worths: Worths, angle: Quantity, pool: Sequence[Ref], up: sp.Expr) -> int | None:
    """The line that says on which side of **i** a velocity points."""
    low, high = (0, 180) if worths.scene.model.sign(up) > 0 else (-180, 0)
    ends = [tree_of(sp.Integer(number) * sp.pi / 180, angle=True) for number in (low, high)]
    links = (Link(ends[0], "<", angle), Link(angle, "<", ends[1]))
    return worths.judge.write((Move("sign"),), pool, Relation((links,)))


def _cotangent_at_a_wall(worths: Worths, angle: Quantity, letter: str) -> int | None:
    """The cotangent of a deflection at a wall by the tangents of the angles to that.

    None where it is open which way the path goes along the wall, or these have no tangents.
    """
    scene = worths.scene
    frame = scene.frame(int(str(angle.stage))) if angle.stage in scene.model.frames else None
    if frame is None or frame.wall is None:
        return None
    mark = worths.mark()
    own = sum_at_a_wall(scene, angle, frame)
    line = None
    if own is not None and not any(_has_a_size(term.tangent) for term in own[1]):
        line = by_tangents(scene, own[0], "sum", own[1], Apply("cot", Letter(letter)))
    if line is None:
        worths.back(mark)
    return line


def _has_a_size(tree: Expression) -> bool:
    """Whether a tree has the size of a component whose sign is open."""
    return any(is_function(node, "abs") for node in walk(tree))


def _cotangent_of_deflection(worths: Worths, angle: Quantity, letter: str, let: Ref) -> int | None:
    """The cotangent of a deflection, the tangent turned over: it is also one of a right angle."""
    own = deflection_formula(worths.scene, angle)
    match own.right:
        case Binary("/", above, below):
            pass
        case _:
            return None
    cotangent = Apply("cot", Letter(letter))
    value = tidy(1 / own.value)
    known = worths.known_in(value)
    pool = [*own.refs, let]
    first = equality(cotangent, swept(Binary("/", below, above)))
    line = worths.judge.write((own.move,), [*pool, *known], first)
    if line is None:
        return None
    # A root below stays there: (8 - k)/(3√3 k).
    top, bottom = (tree_of(value) for value in sp.fraction(own.value)[::-1])
    last = equality(cotangent, swept(Binary("/", top, bottom)))
    moves = (Move("rearrange"), Move("cancel"))
    return worths.judge.write(moves, [line, *known], last) or line


__all__ = ["by_cotangents", "cotangent_line", "write_by_cotangent"]
