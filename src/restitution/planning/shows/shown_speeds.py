"""A speed without a letter that others give, and a velocity as a multiple of another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack

import sympy as sp

from restitution.exact import in_sines, tidy
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation
from restitution.explaining.lines.trees import exchanged, rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Number,
    Polar,
    Quantity,
    is_function,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.angles.quantities import formula
from restitution.planning.closing.squared_ratios import keeping
from restitution.planning.formulas.definitions import write_formula
from restitution.planning.formulas.velocity_formulas import body_and_stage
from restitution.planning.inequalities.claims import Claims
from restitution.planning.writing.desk import NotPlannedError, chain
from restitution.planning.writing.forms import outer_terms, square, swept, total, tree_of, vector
from restitution.planning.writing.scene import Scene
from restitution.solving.story.letters import roles

_FORMS = (Move("rearrange"), Move("cancel"), Move("identity", "pythagoras"))


def speed_by_a_tie(claims: Claims, link: Link) -> int | None:
    """The lines of a speed by its square, in which a letter is put in that is not printed.

    None where there is no such letter, or the printed form does not come of it.
    """
    match link.left:
        case Quantity("speed", _, int()) as speed:
            pass
        case _:
            return None
    mark = claims.worths.mark()
    try:
        for tie, letter in _ties(claims, link):
            line = _written(claims, link, speed, tie, letter)
            if line is not None:
                return line
            claims.worths.back(mark)
    except NotPlannedError:
        claims.worths.back(mark)
    return None


def _ties(claims: Claims, link: Link) -> Iterator[tuple[int, Letter]]:
    """The lines that say what a letter is which is not printed."""
    scene, printed = claims.scene, letters(link.right)
    own = roles(scene.problem)
    for line in (*scene.desk.shown, *claims.ties.lines()):
        if not scene.desk.holds(line):
            continue
        equation = scene.desk.last_link(line)
        names = letters(equation.left) | letters(equation.right)
        for name in sorted(names - printed):
            if name in own and own[name].kind != "angle":
                subject = claims.ties.subject(line, name)
                if subject is not None:
                    yield subject, Letter(name)


def _written(claims: Claims, link: Link, speed: Quantity, tie: int, letter: Letter) -> int | None:
    scene, judge = claims.scene, claims.judge
    claims.worths.determine(speed)
    printed = sp.sympify(scene.scalar(link.right), strict=True)
    with ExitStack() as kept:
        for angle in printed.free_symbols:
            kept.enter_context(keeping(scene, angle))
        own = formula(scene, speed)
    radicand = swept(own.right)
    if not is_function(radicand, "sqrt"):
        return None
    radicand = radicand.argument
    symbol = roles(scene.problem)[letter.name].symbol(letter.name)
    worth = sp.sympify(scene.scalar(scene.desk.last_link(tie).right), strict=True)
    terms = [sp.sympify(scene.scalar(term), strict=True) for term in outer_terms(radicand)]
    put = total(tree_of(tidy(term.subs(symbol, in_sines(worth)))) for term in terms)
    squared = square(speed)
    names = letters(link.right) | letters(radicand)
    known: Sequence[Ref] = judge.known(names)
    line = judge.write((own.move,), own.refs, chain(squared, (radicand, None)), own.refs)
    plain = rebuilt(link.right, _of_the_angle)
    steps = (
        ((Move("put"),), (tie,), chain(squared, (put, None))),
        (_FORMS, (), chain(squared, (_squared(plain), None))),
        (_FORMS, (), chain(speed, (plain, None))),
        ((Move("identity", "complement"),), (), Relation(((link,),))),
    )
    for moves, more, relation in steps:
        line = None if line is None else judge.write(moves, [line, *more, *known], relation)
    return line


def _squared(tree: Expression) -> Expression:
    """The square of a product or a quotient, factor by factor."""
    match tree:
        case Binary("*" | "/" as op, left, right):
            return Binary(op, _squared(left), _squared(right))
        case Number(value):
            return Number(value**2)
    return square(tree)


def _of_the_angle(tree: Expression) -> Expression:
    """A ratio of 90° less an angle as one of that angle."""
    match tree:
        case Apply(ratio, Binary("-", Degrees(right_angle), angle)) if (
            right_angle == 90 and ratio in _COMPLEMENTS
        ):
            return Apply(_COMPLEMENTS[ratio], angle)
    return tree


def multiple_of_data(claims: Claims, link: Link, line: int) -> int | None:
    """A velocity as a multiple of one of the data in components: −e(u cos α 𝐢 − u sin α 𝐣).

    ``line`` gives it in components. None of another equation, and of a velocity along an axis.
    """
    scene = claims.scene
    early = [node for node in walk(link.right) if is_quantity(node, "velocity")]
    if len(early) != 1 or link.right == early[0]:
        return None
    given = scene.velocity(*body_and_stage(scene, early[0]))
    if 0 in given:
        return None
    whole = exchanged(link.right, {early[0]: vector(*map(tree_of, given))})
    pool = [line, *claims.judge.known(letters(whole))]
    return claims.judge.write((Move("rearrange"),), pool, chain(link.left, (whole, None)))


def components_of_data(scene: Scene, quantity: Quantity) -> tuple[Ref, ...] | None:
    """The line of a velocity of the data in components, where it is given by its angle to a wall.

    None of another one, and of one along an axis.
    """
    body, stage = body_and_stage(scene, quantity)
    fact = scene.facts.get(f"velocity {body}")
    match fact and fact.relation.only[0].right:
        case Polar(wall=wall) if wall is not None and 0 not in scene.velocity(body, stage):
            return (write_formula(scene, formula(scene, quantity)),)
    return None


_COMPLEMENTS = {"sin": "cos", "cos": "sin", "tan": "cot", "cot": "tan"}
