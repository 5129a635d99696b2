"""What only grows, or only falls, with a letter: which letter that is, and which way it goes."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import pairwise
from typing import Any

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Link, Relation
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import Expression, Letter, has_quantity, letters
from restitution.solving.algebra.signs import sign

_DOWN = (">", ">=")
# What every other letter is worth where one of them is looked at.
_OTHERS = sp.Rational(2, 3)
# At so many places a letter is looked at, and so small a change is none.
_LOOKS, _SMALL = 12, 1e-9
# Where a letter without cited ends is looked at: below the others, if not above them.
_PAIRS = ((sp.Integer(1), sp.Integer(2)), (sp.Rational(1, 4), sp.Rational(1, 2)))


def growth(
    tree: Expression,
    bound: Relation,
    ends: Sequence[Link],
    positive: Collection[str],
    varied: Collection[str] = (),
) -> tuple[str, int] | None:
    """The letter with which a tree grows (1) or falls (-1), so that a bound is that at its ends.

    ``ends`` are what is cited of letters; a ``positive`` one goes from 0 without limit. One that
    is ``varied`` is taken before others.
    """
    cited = {n for end in ends for side in (end.left, end.right) for n in letters(side)}
    names = [*sorted(cited), *sorted((set(positive) & letters(tree)) - cited)]
    # A letter that goes without limit is named where no other tells the bound.
    tried = [(name, True) for name in names if name in varied]
    tried += [(name, far) for far in (False, True) for name in names]
    for name, far in tried:
        own = [end for end in ends if name in letters(end.left) | letters(end.right)]
        if len(names) > 1 and not _is_end(tree, name, own, bound, name in positive, far):
            continue
        sense = way_of(tree, name, own, bound)
        if sense and _turns(tree, name, own):
            return None  # the bound is that at an end all the same: by another letter, or a sign
        if sense:
            return name, sense
    return None


def _turns(tree: Expression, name: str, ends: Sequence[Link]) -> bool:
    """Whether a tree both grows and falls between two ends of a letter, all others at one point."""
    try:
        places = sorted(float(place) for place, _ in _places(ends, False, name))
        low, high = places[0], places[-1]
        inside = [low + n * (high - low) / _LOOKS for n in range(1, _LOOKS)]
        values = [float(worth(tree, name, sp.Float(place))) for place in inside]
    except (RestitutionError, TypeError, ValueError, IndexError):
        return False
    steps = [second - first for first, second in pairwise(values)]
    least = _SMALL * max(map(abs, values))
    return max(steps) > least and min(steps) < -least


def _is_end(
    tree: Expression,
    name: str,
    ends: Sequence[Link],
    bound: Relation,
    positive: bool,
    far: bool,
) -> bool:
    """Whether a bound is what a tree is worth at ends of a letter, for others at one point.

    One end may be ``far`` away.
    """
    places = [place for place in _places(ends, positive, name) if far or place[0] is not sp.oo]
    return all(
        any(
            _agrees(tree, name, end, side)
            for side in (link.left, link.right)
            if not has_quantity(side) and name not in letters(side)
            for end, closed in places
            if closed == (len(link.sign) == 2)
        )
        for link in bound.only
    )


def _places(ends: Sequence[Link], positive: bool, name: str) -> Iterator[tuple[Any, bool]]:
    """The ends of a letter, and whether they belong to it."""
    low = high = False
    for end in ends:
        for letter, side, below in (
            (end.left, end.right, end.sign in _DOWN),
            (end.right, end.left, end.sign not in _DOWN),
        ):
            if letter == Letter(name) and name not in letters(side):
                low, high = low or below, high or not below
                yield worth(side, name, sp.Integer(0)), len(end.sign) == 2
    if positive and not low:
        yield sp.Integer(0), False
    if positive and not high:
        yield sp.oo, False


def _agrees(tree: Expression, name: str, end: Any, side: Expression) -> bool:
    try:
        if end is sp.oo:
            small = sp.Dummy("t", positive=True)
            there = sp.limit(sp.together(worth(tree, name, 1 / small)), small, 0)
        else:
            there = worth(tree, name, end)
        apart = sp.sympify(there - worth(side, name, sp.Integer(1)), strict=True)
        return sign(apart) == 0
    except (RestitutionError, TypeError, ValueError, AttributeError, NotImplementedError):
        return False


def limit_at_an_end(
    tree: Expression, bound: Relation, name: str, ends: Sequence[Link]
) -> tuple[Expression, Expression] | None:
    """The strict bound that a tree approaches at an end that does not belong to its letter."""
    for link in bound.only:
        for side in (link.left, link.right):
            if len(link.sign) == 2 or has_quantity(side) or name in letters(side):
                continue
            for end in ends:
                at = end.left if end.right == Letter(name) else end.right
                if Letter(name) not in (end.left, end.right) or len(end.sign) == 2:
                    continue
                if _agrees(tree, name, worth(at, name, sp.Integer(0)), side):
                    return side, at
    return None


def reached_at_ends(
    tree: Expression, subject: Expression, bound: Relation, name: str, ends: Sequence[Link]
) -> tuple[tuple[Expression, Expression], ...]:
    """The bounds that a tree has at ends that belong to its letter, each with its end.

    None where a bound that belongs to the subject is not taken so.
    """
    pairs: list[tuple[Expression, Expression]] = []
    for link in bound.only:
        side = link.right if link.left == subject else link.left
        own = _reached(tree, side, name, ends) if len(link.sign) == 2 else None
        if own is None:
            return ()
        pairs.append((side, own))
    return tuple(pairs)


def _reached(
    tree: Expression, side: Expression, name: str, ends: Sequence[Link]
) -> Expression | None:
    """The end of a letter, one that belongs to it, at which a tree is as great as a bound."""
    if has_quantity(side) or name in letters(side):
        return None
    for end in ends:
        at = end.left if end.right == Letter(name) else end.right
        if Letter(name) not in (end.left, end.right) or len(end.sign) != 2 or letters(at):
            continue
        if _agrees(tree, name, worth(at, name, sp.Integer(0)), side):
            return at
    return None


def way_of(tree: Expression, name: str, ends: Sequence[Link], bound: Relation) -> int:
    """The sign of the change from the lower to the upper end, all other letters at one point.

    A value that is not bounded in between changes its sign there: so it is that next to the end
    where the bound is taken.
    """

    def change(low: Any, high: Any) -> Any:
        try:
            return sp.sympify(worth(tree, name, high) - worth(tree, name, low), strict=True)
        except RestitutionError:
            return None  # at that end there is no value

    try:
        places = sorted(
            (
                worth(side, name, sp.Integer(0))
                for end in ends
                for side in (end.left, end.right)
                if name not in letters(side)
            ),
            key=float,
        )
        if len(places) >= 2:
            low, high = places[0], places[-1]
        elif not places:
            low, high = next(
                pair for pair in _PAIRS if getattr(change(*pair), "is_real", False) or pair[0] < 1
            )
        elif any(letters(end.left) and end.sign in _DOWN for end in ends):
            low, high = places[0], places[0] + 1
        else:
            low, high = places[0] / 2, places[0]
        middle = (low + high) / 2
        pairs = [(low, high), (middle, high), (low, middle)]
        step = (high - low) / 8
        for end, pair in ((high, (high - step, high)), (low, (low, low + step))):
            sides = [side for link in bound.only for side in (link.left, link.right)]
            if len(bound.only) == 1 and any(_agrees(tree, name, end, side) for side in sides):
                pairs.insert(0, pair)
        for pair in pairs:
            own = change(*pair)
            if own is not None and own.is_finite:
                return int(sp.sign(own))
        return 0
    except (RestitutionError, TypeError, ValueError, IndexError):
        return 0


def worth(tree: Expression, name: str, at: Any) -> Any:
    """What a tree is worth where one letter has a value, all others being 2/3."""
    return evaluate(tree, lambda letter: at if letter == name else _OTHERS)
