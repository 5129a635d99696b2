"""All roots of an equation, and those that are rejected."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Literal

import sympy as sp

from restitution.explaining.lines.derivation import BEARINGS, Link, Relation
from restitution.explaining.lines.generators import Value
from restitution.explaining.lines.quotients import CONSTANT, Plane, Quotient
from restitution.explaining.lines.trees import exchanged
from restitution.explaining.moves.bases import base_of, ends_of, expected_residual, others_cited
from restitution.explaining.moves.inequalities import (
    is_at_rest_in,
    is_contradicted,
    is_of_vectors,
    same_option,
)
from restitution.explaining.steps.step import Step
from restitution.expression.evaluate import enclosed, in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    is_binary,
    letters,
    walk,
)
from restitution.oracle import REAL, Formula, Oracle
from restitution.oracle import Relation as Claim

# Of the ends between which a number is: more of them take long, and tell no more.
_PLACES = 40


def are_roots(step: Step, relation: Relation) -> bool:
    """All roots of an equation in one letter, or in one ratio, or its factors, each one zero."""
    base = base_of(step)
    if base is None or len(base.options) != 1 or any(len(links) != 1 for links in relation.options):
        return False
    equation = ends_of(base.only)
    links = [links[0] for links in relation.options]
    subject = links[0].left
    if equation is None or any(link.sign != "=" for link in links):
        return False
    if len(links) > 1 and _are_factors(step, equation, links):
        return True
    if any(link.left != subject for link in links):
        return False
    rules = step.rules(others_cited(step))
    polynomial = _polynomial(step, expected_residual(step, equation, rules), subject)
    if polynomial is None:
        return False
    if _are_of_a_power(step, polynomial, [step.world.scalar(link.right) for link in links]):
        return True
    for link in links:
        root = step.world.scalar(link.right)
        times = 0
        while len(polynomial) > 1:
            quotient, rest = _divided(step, polynomial, root)
            if not rest.vanishes:
                break
            polynomial, times = quotient, times + 1
        if not times:
            return False
    return _never_zero(step, polynomial)


def _are_of_a_power(step: Step, polynomial: list[Quotient], roots: list[Quotient]) -> bool:
    """Whether these are all roots of xⁿ = c: one where n is odd, two that are opposite if even."""
    degree = len(polynomial) - 1
    if degree < 3 or not all(coefficient.vanishes for coefficient in polynomial[1:-1]):
        return False
    reduced = step.world.reduced
    if step.signs.of(polynomial[-1]) is None or polynomial[0].vanishes:
        return False
    if any(not reduced(r**degree * polynomial[-1] + polynomial[0]).vanishes for r in roots):
        return False
    if degree % 2:
        return len(roots) == 1
    return len(roots) == 2 and reduced(roots[0] + roots[1]).vanishes


def _are_factors(step: Step, equation: Link, links: Sequence[Link]) -> bool:
    """Whether the sides of an equation are apart by the product of what those of others are.

    So A² = B² says that A = B or A = −B.
    """
    expected = expected_residual(step, equation, step.rules(others_cited(step)))
    product = CONSTANT(1)
    for link in links:
        own = step.residual(link)
        if isinstance(own, Plane) or own.vanishes:
            return False
        product *= own
    product = step.world.reduced(product)
    return not isinstance(expected, Plane) and step.is_multiple(product, expected) is not None


def _polynomial(step: Step, residual: Value, subject: Expression) -> list[Quotient] | None:
    """The coefficients of an equation in its subject, the constant one first."""
    if isinstance(residual, Plane) or residual.vanishes:
        return None
    world = step.world
    if is_binary(subject, "/"):
        above, below = (world.scalar(side) for side in (subject.left, subject.right))
        if len(above.above) != 1 or len(below.above) != 1:
            return None
    own = world.scalar(subject)
    above = own.above
    if len(above) != 1 or len(own.below) != 1:
        return None
    (monomial,) = above
    (under,) = own.below
    numbers = [n for n, power in enumerate(monomial) if power]
    if len(numbers) != 1:
        return None
    (number,) = numbers
    power = monomial[number]
    # subject = g^p/below: each term c g^(pk) rest is c rest below^k subject^k.
    rest = Quotient(own.below, above.ring.ground_new(above.LC))
    polynomial: dict[int, Quotient] = {}
    others = [n for n, p in enumerate(under) if p]
    for m, value in residual.above.items():
        times, left = divmod(m[number], power)
        if left:
            return None
        term = above.ring.from_dict({(*m[:number], 0, *m[number + 1 :]): value})
        polynomial[times] = (
            polynomial.get(times, CONSTANT(0)) + Quotient(term, above.ring.one) * rest**times
        )
    if not polynomial:
        return None
    coefficients = [
        world.reduced(polynomial.get(n, CONSTANT(0))) for n in range(max(polynomial) + 1)
    ]
    if others:
        # A ratio such as tan θ = sin θ/cos θ: what is left of the denominator is a common factor.
        lead = coefficients[-1]
        coefficients = [world.reduced(coefficient / lead) for coefficient in coefficients]
        if any(
            any(m[n] for n in others)
            for coefficient in coefficients
            for m in (*coefficient.above, *coefficient.below)
        ):
            return None
        if step.signs.of(lead) is None:
            return None
    return coefficients


def _divided(
    step: Step, polynomial: list[Quotient], root: Quotient
) -> tuple[list[Quotient], Quotient]:
    """A polynomial divided by x − root: quotient and remainder."""
    result: list[Quotient] = []
    carried = CONSTANT(0)
    for coefficient in reversed(polynomial):
        carried = step.world.reduced(coefficient + carried * root)
        result.append(carried)
    return list(reversed(result[:-1])), result[-1]


def _never_zero(step: Step, polynomial: list[Quotient]) -> bool:
    """Whether what is left of an equation has no root."""
    if len(polynomial) == 1:
        return step.signs.of(polynomial[0]) is not None
    x = sp.Symbol("x_subject", real=True)
    value = sp.Add(
        *(
            step.world.expression(coefficient, step.roles) * x**n
            for n, coefficient in enumerate(polynomial)
        )
    )
    return step.oracle.proves(Claim(value, "!="))


def is_rejection(step: Step, relation: Relation) -> bool:
    """Whether a line is its base without options that what is cited excludes."""
    base = base_of(step)
    if base is None or len(base.options) < 2:
        return False
    kept = [
        n
        for n, option in enumerate(base.options)
        if any(same_option(step, option, own) for own in relation.options)
    ]
    if len(kept) != len(relation.options) or len(kept) == len(base.options):
        return False
    rest = step.under(cited=others_cited(step))
    known = (*rest.facts, *rest.pushed())
    moving = [link for link in rest.links if is_of_vectors(link)]
    bearings = [link for link in rest.links if link.sign in BEARINGS]
    for n, option in enumerate(base.options):
        if n in kept:
            continue
        if any(is_at_rest_in(rest, option, link) for link in bearings):
            continue
        if moving:
            if not any(is_contradicted(rest, option, link) for link in moving):
                return False
            continue
        near = _between_ends(rest, option)
        if near is not None:
            verdict = _by_elimination(rest, known, Relation((option,)))
            if verdict == "no":
                continue
            if verdict == "yes":
                return False
        if _is_excluded(rest, known, Relation((near or option,))):
            continue
        if near is not None:
            return False  # of a number that only a calculator knows its digits are enough
        # Where two roots are one, what is dropped says what remains.
        oracle = Oracle(rest.roles, (*known, rest.formula(Relation((option,)))))
        if not oracle.proves(rest.formula(relation)):
            return False
    return bool(moving) or not _is_impossible(rest, relation)


def _is_impossible(rest: Step, relation: Relation) -> bool:
    """Whether what drops some options excludes all that are kept as well: it is no reason then."""
    options = tuple(_between_ends(rest, option) or option for option in relation.options)
    if options != relation.options:
        verdict = _by_elimination(rest, rest.facts, relation)
        if verdict != "unknown":
            return verdict == "no"
    return _is_excluded(rest, rest.facts, Relation(options))


def _is_excluded(rest: Step, known: Sequence[Formula], relation: Relation) -> bool:
    """Whether a relation cannot hold beside what is known."""
    oracle = Oracle(rest.roles, (*known, rest.formula(relation)))
    return oracle.possible.answer == "refuted"


def _by_elimination(
    rest: Step, known: Sequence[Formula], relation: Relation
) -> Literal["yes", "no", "unknown"]:
    """Whether a relation can hold beside what is known, as linear equations alone show."""
    return Oracle(rest.roles, (*known, rest.formula(relation))).by_elimination


def _between_ends(step: Step, option: tuple[Link, ...]) -> tuple[Link, ...] | None:
    """That a value is between two fractions, for one of ratios of angles such as 35°.

    It may be so many times a positive letter, as a component is of a speed. It says less than the
    value itself. None of any other option.
    """
    match option:
        case (Link(left, "=", right),) if _has_ratios(right):
            scale = _scale(step, right)
            number = enclosed(
                right if scale is None else exchanged(right, {scale: Number(Fraction(1))})
            )
            if number is None or not number.sign:
                return None
            low, high = (_times(end, scale) for end in _shortened(*number.between))
            return Link(low, "<=", left), Link(left, "<=", high)
    return None


def _shortened(low: Fraction, high: Fraction) -> tuple[Fraction, Fraction]:
    """Two ends with a few dozen places, between which there is a little more."""
    unit = 10**_PLACES
    return Fraction(math.floor(low * unit), unit), Fraction(math.ceil(high * unit), unit)


def _times(end: Fraction, scale: Letter | None) -> Expression:
    """An end as a value has it: so many times a letter, or alone."""
    own = Number(end) if end >= 0 else Negate(Number(-end))
    return own if scale is None else Binary("*", own, scale)


def _scale(step: Step, tree: Expression) -> Letter | None:
    """The one letter of a value, where that is so many times it, and it is positive."""
    match sorted(letters(tree)):
        case [name] if step.roles.get(name, REAL).symbol(name).is_positive:
            value = in_letters(tree, positive=True) / sp.Symbol(name, positive=True)
            return None if value.free_symbols else Letter(name)
    return None


def _has_ratios(tree: Expression) -> bool:
    """Whether ratios of angles in degrees stand in a number."""
    return any(
        isinstance(node, Apply) and isinstance(node.argument, Degrees) for node in walk(tree)
    )
