"""Two equations made into one."""

from __future__ import annotations

from restitution.explaining.lines.algebra import multiplied
from restitution.explaining.lines.derivation import Link
from restitution.explaining.lines.quotients import CONSTANT, Plane, Quotient
from restitution.explaining.moves.bases import matches, pair_cited, plus
from restitution.explaining.steps.step import Step


def is_combination(step: Step, line: Link) -> bool:
    """Whether a line is the sum or the difference of two equations, or of multiples of them."""
    pair = pair_cited(step)
    if pair is None or line.sign != "=":
        return False
    step.world.printed = True
    a, b = (step.residual(link) for link in pair)
    if step.move.eliminated is None:
        for sign in (1, -1):
            other = multiplied(b, CONSTANT(sign))
            if matches(step, line, plus(a, other)):
                return True
        return False
    if isinstance(a, Plane) or isinstance(b, Plane):
        return False
    own = step.world.value(step.setting.tree(step.move.eliminated))
    if not isinstance(own, Quotient):
        return False
    number = (
        next((n for m in own.above for n, power in enumerate(m) if power), None)
        if len(own.above) == 1
        else None
    )
    if number is None:
        return False
    p, q = _coefficient(a, number), _coefficient(b, number)
    if p is None or q is None:
        return False
    return matches(step, line, step.world.reduced(a * q - b * p))


def _coefficient(x: Quotient, number: int) -> Quotient | None:
    """The factor of a generator in what is linear in it; None where it is not linear, or absent."""
    if any(m[number] for m in x.below) or any(m[number] > 1 for m in x.above):
        return None
    lead = {(*m[:number], 0, *m[number + 1 :]): v for m, v in x.above.items() if m[number]}
    return Quotient(x.above.ring.from_dict(lead), x.below) if lead else None


def sides_of(step: Step) -> tuple[Quotient, Quotient, Quotient, Quotient] | None:
    """The sides of the two equations that are cited, left and right of each."""
    pair = pair_cited(step)
    if pair is None:
        return None
    step.world.printed = True
    sides = [step.world.value(side) for link in pair for side in (link.left, link.right)]
    if any(isinstance(side, Plane) for side in sides):
        return None
    a, b, c, d = sides
    return a, b, c, d  # type: ignore[return-value]


def is_quotient(step: Step, line: Link) -> bool:
    """Whether a line is one equation divided by another, side by side."""
    sides = sides_of(step)
    if sides is None:
        return False
    a, b, c, d = sides
    return line.sign == "=" and matches(step, line, step.world.reduced(a * d - b * c))


def is_sum_of_squares(step: Step, line: Link) -> bool:
    """Whether a line is the sum of the squares of two equations."""
    chosen = step.under(identities=frozenset({"pythagoras"}))
    sides = sides_of(chosen)
    if sides is None:
        return False
    a, b, c, d = sides
    # Sines and cosines become known to each other only where they are squared and added.
    expected = chosen.world.reduced(a * a + c * c - b * b - d * d)
    return line.sign == "=" and matches(chosen, line, expected)
