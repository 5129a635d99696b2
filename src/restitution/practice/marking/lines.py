"""What a judged line is to an examiner: sound, exact enough, and what it uses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from restitution.expression.tree import (
    Apply,
    Degrees,
    Expression,
    Letter,
    Number,
    Pair,
    Quantity,
    Unit,
    has_operator,
    is_binary,
    is_function,
    is_quantity,
    walk,
)
from restitution.practice.judgement import JudgedLine, Use
from restitution.practice.judging.angles import INVERSE
from restitution.practice.judging.supposing import becomes_vector
from restitution.practice.reading.relations import hundredth
from restitution.practice.script import Claim, Link
from restitution.practice.worlds.principles import is_worked

_FIGURES = 3
SOUND = ("true", "follows")


def is_sound(line: JudgedLine) -> bool:
    """Whether a line holds or follows, or is a remark whose value states a law: *then 12e*."""
    return line.verdict in SOUND or (line.verdict == "remark" and bool(line.uses))


def has_vector(line: JudgedLine) -> bool:
    """Whether a vector stands in a line, by its components."""
    return any(
        isinstance(node, Unit | Pair)
        for link in line.line.links
        for side in (link.readings[0].left, link.readings[0].right)
        for node in walk(side)
    )


def is_plain(line: JudgedLine) -> bool:
    """Whether a line gives quantities their values and no more, without a calculation."""
    claims = [link.readings[0] for link in line.line.links]
    return all(
        isinstance(claim.left, Letter | Quantity) and not is_worked(claim.right) for claim in claims
    )


def wrong_numbers(lines: Iterable[JudgedLine]) -> frozenset[Fraction]:
    """The numbers that false lines have worked out."""
    return frozenset(
        node.value
        for line in lines
        if line.verdict == "false"
        for link in line.line.links[line.link or 0 :]
        for claim in link.readings[:1]
        if isinstance(claim.right, Number | Degrees)
        for node in walk(claim.right)
        if isinstance(node, Number | Degrees)
    )


def ends_fine(line: JudgedLine) -> bool:
    """Whether the last decimal of a line, that of its answer, has figures enough.

    An exact value before it in its chain is fine as well: d = 2√13 = 7.2.
    """
    links = line.line.links
    decimals = links[-1].decimals if links else ()
    if len(links) > 1 and not links[-2].decimals and continues(links[-2], links[-1]):
        return True
    last = max(decimals, key=lambda decimal: decimal.column, default=None)
    return last is not None and last.figures >= _FIGURES


def continues(link: Link, behind: Link) -> bool:
    """Whether a link goes on from another in a chain."""
    return link.readings[0].leads_to(behind.readings[0])


def fitting_uses(line: JudgedLine) -> tuple[Use, ...]:
    """The uses of a line; of a named mistake those that are an instance of it."""
    mistake = line.mistake
    if mistake is None or mistake.kind != "misconception":
        return line.uses
    names = (mistake.id, *mistake.also)
    named = tuple(use for use in line.uses if (use.altered or "").partition("/")[0] in names)
    return named or line.uses


def subtracts_squares(line: JudgedLine) -> bool:
    """Whether a false line has a difference of squares by a slip in a sign: √(3.46² - 0.25²).

    They may be worked out: √(12 - 0.0625).
    """
    if line.mistake is None or line.mistake.id != "sign":
        return False
    return any(
        (is_binary(node, "-") and has_operator(node.left, "^") and has_operator(node.right, "^"))
        or (is_function(node, "sqrt") and is_binary(node.argument, "-"))
        for link in line.line.links
        for side in (link.readings[0].left, link.readings[0].right)
        for node in walk(side)
    )


def without_slip(line: JudgedLine) -> JudgedLine:
    """A line as it would be without its slip; any other as it is."""
    if line.mended is None or line.link is None or line.verdict != "false":
        return line
    claim, uses = line.mended
    links = list(line.line.links)
    links[line.link] = replace(links[line.link], readings=(claim,), decimals=())
    typed = replace(line.line, links=tuple(links))
    return replace(line, line=typed, verdict="true", uses=uses, mistake=None, link=None)


def is_slip(line: JudgedLine) -> bool:
    """Whether the mistake of a line is a slip."""
    return line.mistake is not None and line.mistake.kind == "slip"


def before_mistake(line: JudgedLine) -> JudgedLine:
    """A line without the relation that fails, and those behind it, if others stand before it."""
    if not line.before or line.link is None or line.verdict != "false":
        return line
    typed = replace(line.line, links=line.line.links[: line.link])
    return replace(line, line=typed, verdict="true", uses=line.before, mistake=None, link=None)


def as_true(line: JudgedLine) -> JudgedLine:
    """A line that follows, or that is misread, as if it held; any other as it is."""
    if line.verdict in ("follows", "false") and (
        line.verdict == "follows" or (line.mistake is not None and line.mistake.id == "misread")
    ):
        return replace(line, verdict="true", mistake=None)
    return line


def ratios_of_angles(claim: Claim) -> Iterator[tuple[str, Expression]]:
    """The ratios that give angles, each with its inverse function: ``tan δ = 4/3``, ``arctan 2``.

    A ratio may be a number that is worked out.
    """
    for one, other in ((claim.left, claim.right), (claim.right, claim.left)):
        if isinstance(one, Apply) and one.function in INVERSE and is_binary(other, "/"):
            yield INVERSE[one.function], other
        for node in walk(one):
            if not is_function(node, *INVERSE.values()):
                continue
            if is_binary(node.argument, "/") or isinstance(node.argument, Number):
                yield node.function, node.argument


def has_cosine(line: JudgedLine) -> bool:
    """Whether a line works out an angle from its cosine, as of a scalar product."""
    return any(
        function == "arccos"
        for link in line.line.links
        for function, _ in ratios_of_angles(link.readings[0])
    )


__all__ = [
    "SOUND",
    "as_true",
    "before_mistake",
    "continues",
    "ends_fine",
    "fitting_uses",
    "has_cosine",
    "has_vector",
    "is_plain",
    "is_slip",
    "is_sound",
    "ratios_of_angles",
    "subtracts_squares",
    "without_slip",
    "wrong_numbers",
]


def chains(line: JudgedLine) -> Iterator[Sequence[Claim]]:
    """The relations of a line, links of a chain together, in the reading that is most natural.

    Behind a percentage that counts hundredths, ``(1 - 0.51) × 100 = 49``, all of it does.
    """
    chain: list[Claim] = []
    for link in line.line.links:
        claim = _of_direction(link.readings[0])
        if chain and becomes_vector(claim, line.line):
            yield chain
            chain = []
        elif chain and not chain[-1].leads_to(claim):
            counted = replace(claim, left=hundredth(claim.left), right=hundredth(claim.right))
            if chain[-1].leads_to(counted):
                claim = counted
            else:
                yield chain
                chain = []
        chain.append(claim)
    if chain:
        yield chain


def _of_direction(claim: Claim) -> Claim:
    """A vector that has no part across a line, as the direction of that line."""
    right = claim.right
    if claim.left == Number(Fraction(0)) and is_quantity(right, "across"):
        vector, line = right.arguments
        return Claim(line, "=", vector)
    return claim
