"""Expressions that would be a tangle in words: a formula, and what its letters denote.

``2 speed(A) + 3 speed(B)`` is *2v + 3w, where v and w are the speeds of A and B immediately
after the collision*.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any

from restitution.expression.defined import quantity_of
from restitution.expression.quantities import KINDS, dimension_of_any, is_vector_quantity
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Polar,
    Quantity,
    children,
    has_quantity,
    is_binary,
    is_function,
)
from restitution.render import layout as lay
from restitution.wording import values
from restitution.wording.noun_phrases import Noun, of_bodies
from restitution.wording.nouns import alike, ends, noun, terms, times_until, until
from restitution.wording.scene import Scene
from restitution.wording.structure import Words
from restitution.wording.words import listed, words

# Beyond this a phrase is a formula: a sum of two quantities is 3.
_MOST = 3
# The letters that people take for a quotient of two quantities, and for other angles.
_FRACTION = ("q", "k")
_ANGLES = ("theta", "phi", "psi", "beta", "gamma", "delta")


def noun_phrase(scene: Scene, tree: Expression) -> Noun:
    """An expression as a noun phrase, or as a formula with what its letters denote."""
    if plain(scene, tree):
        return noun(scene, tree)
    (shown,), where = formula(scene, (tree,))
    return Noun(words(shown), where=where)


def plain(scene: Scene, *trees: Expression) -> bool:
    """Whether expressions can be said in words that people can follow."""
    return all(cost(scene, tree) <= _MOST for tree in trees)


def cost(scene: Scene, tree: Expression) -> float:
    """How much there is to follow in an expression, if it were told in words: a quantity is 1."""
    if not has_quantity(tree):
        return 0
    tree = quantity_of(tree) or tree
    inner = [cost(scene, child) for child in children(tree)]
    match tree:
        case Quantity(_, arguments):
            return max([1, *(cost(scene, argument) for argument in arguments)])
        case Negate() | Apply():
            if is_function(tree, "abs"):
                scalar = isinstance(tree.argument, Binary) and not values.is_vector(tree.argument)
                return inner[0] + (3 if scalar and ends(scene, tree.argument) is None else 1)
            turned = isinstance(tree, Negate) and values.is_vector(tree)
            return inner[0] + (0.5 if turned else 3 if isinstance(tree, Negate) else 1)
        case Binary("+"):
            added = terms(tree)
            nouns = [noun(scene, tree) for tree in added if isinstance(tree, Quantity)]
            if len(nouns) == len(added) and (alike(nouns) or times_until(scene, added)):
                return 1 + len(added) / 4
            costs = [cost(scene, tree) if has_quantity(tree) else 2 for tree in added]
            return sum(costs) + len(added) - 1
        case Binary("-", left, right):
            if isinstance(left, Quantity) and isinstance(right, Quantity):
                together = not _says(noun(scene, tree), " exceeds ", " minus ")
            else:
                together = ends(scene, tree) is not None
            alone = 1 if has_quantity(left) != has_quantity(right) else 0
            return 1 if together else sum(inner) + 1 + 2 * alone
        case Binary("*", left, right) if not (has_quantity(left) and has_quantity(right)):
            factor = right if has_quantity(left) else left
            return sum(inner) + (0.5 if _is_short(factor) else 1.5)
        case Binary("/", _, right) if not has_quantity(right):
            return sum(inner) + (0.5 if isinstance(right, Number) else 3)
        case Binary("/", left, right):
            return 1 if _says(noun(scene, tree), "the fraction of ") else sum(inner) + 1
        case Binary("^", _, Number(power)):
            return sum(inner) + (1 if power == 2 else 3)
    return sum(inner) + 1


def _says(one: Noun, *texts: str) -> bool:
    return any(isinstance(word, str) and text in word for word in one.words() for text in texts)


def _is_short(factor: Expression) -> bool:
    """Whether a factor is one term without functions: ``2``, ``½``, ``½m``."""
    match factor:
        case Negate(inner):
            return _is_short(inner)
        case Binary("*" | "/", left, right):
            return _is_short(left) and _is_short(right)
    return isinstance(factor, Number | Letter)


# --- formulas -------------------------------------------------------------------------------------


def formula(scene: Scene, trees: Sequence[Expression]) -> tuple[list[lay.Layout], Words]:
    """Expressions as mathematics, with letters for quantities, and what these denote."""
    quantities: list[Expression] = []
    for tree in trees:
        for quantity in _quantities(scene, tree):
            if all(_key(scene, quantity) != _key(scene, one) for one in quantities):
                quantities.append(quantity)
    names = _named(scene, quantities)
    bold = {names[_key(scene, quantity)] for quantity in quantities if _is_vector(quantity)}
    shown = [_in_bold(values.layout_of(_replaced(scene, tree, names)), bold) for tree in trees]
    return shown, words("where ", listed(_definitions(scene, quantities, names, bold)))


def _quantities(scene: Scene, tree: Expression) -> list[Expression]:
    """What has a letter of its own in a formula: quantities, and what is as plain as these."""
    if _is_one(scene, tree):
        return [tree]
    return [one for node in children(tree) for one in _quantities(scene, node)]


def _is_one(scene: Scene, tree: Expression) -> bool:
    """A quantity, or a difference or a fraction with a name: the time between two impacts."""
    if isinstance(tree, Binary):
        return tree.op in "-/" and has_quantity(tree) and cost(scene, tree) == 1
    return isinstance(tree, Quantity)


def _key(scene: Scene, tree: Expression) -> Words:
    return noun(scene, tree).words()


def _kind(tree: Expression) -> str:
    match tree:
        case Quantity(kind):
            return kind
        case Binary("-", Quantity(kind)):
            return kind
    return "position" if is_binary(tree, "-") else "fraction"


def _is_vector(tree: Expression) -> bool:
    if isinstance(tree, Quantity):
        return is_vector_quantity(tree)
    kind = KINDS.get(_kind(tree))
    return kind is not None and kind.nature == "vector"


def _named(scene: Scene, quantities: Sequence[Expression]) -> dict[Words, str]:
    """A letter for each quantity, by its words; those of one kind have one letter, numbered."""
    groups: dict[str, list[Expression]] = {}
    for quantity in quantities:
        if _key(scene, quantity) not in scene.denoted:
            groups.setdefault(_kind(quantity), []).append(quantity)
    for kind, group in groups.items():
        for tree, name in zip(group, _free(scene, kind, group), strict=True):
            scene.denoted[_key(scene, tree)] = name
    for quantity in quantities:
        match quantity:
            case Quantity("speed", (Name(body),), stage):
                at = replace(quantity, stage=scene.stage(stage, body))
                scene.lettered[at] = scene.denoted[_key(scene, quantity)]
            case Quantity("time", (), int()) | Binary(
                "-", Quantity("time", (), int()), Quantity("time", (), int())
            ):
                scene.lettered[quantity] = scene.denoted[_key(scene, quantity)]
    return {_key(scene, quantity): scene.denoted[_key(scene, quantity)] for quantity in quantities}


def _free(scene: Scene, kind: str, group: Sequence[Expression]) -> list[str]:
    """Letters that nothing else has."""
    taken = scene.letters | set(scene.denoted.values())
    bases = (KINDS[kind].letters if kind in KINDS else _FRACTION) or _ANGLES
    if len(group) == 1 or (kind not in ("time", "speed") and len(group) == 2):
        free = [base for base in bases if base not in taken]
        if len(free) >= len(group):
            return free[: len(group)]
    bodies = [body for tree in group if len(body := noun(scene, tree).body) == 1]
    ends = [str(number) for number in range(1, len(group) + 1)]
    if len(set(bodies)) == len(group):
        ends = bodies
    for base in bases:
        names = [f"{base}_{end}" for end in ends]
        if not taken.intersection(names) and base not in taken:
            return names
    numbered = (f"{bases[0]}_{number}" for number in range(1, 10_000))
    return [
        letter for letter, _ in zip((n for n in numbered if n not in taken), group, strict=False)
    ]


def _replaced(scene: Scene, tree: Any, names: dict[Words, str]) -> Any:
    """An expression with letters in the place of its quantities."""
    if isinstance(tree, Expression) and _is_one(scene, tree):
        return Letter(names[_key(scene, tree)])
    match tree:
        case Negate(inner):
            return Negate(_replaced(scene, inner, names))
        case Apply(function, inner):
            return Apply(function, _replaced(scene, inner, names))
        case Binary(op, left, right):
            return Binary(op, _replaced(scene, left, names), _replaced(scene, right, names))
        case Pair(x, y):
            return Pair(_replaced(scene, x, names), _replaced(scene, y, names))
        case Polar(size, angle, origin):
            parts = [_replaced(scene, tree, names) for tree in (size, angle, origin)]
            return replace(tree, size=parts[0], angle=parts[1], origin=parts[2])
    return tree


def _in_bold(shown: Any, bold: set[str]) -> Any:
    """A layout with the letters of vectors in bold."""
    if isinstance(shown, lay.Letter):
        name = f"{shown.name}_{shown.subscript}" if shown.subscript else shown.name
        return lay.Bold(shown.name, shown.subscript) if name in bold else shown
    if isinstance(shown, tuple):
        return tuple(_in_bold(layout, bold) for layout in shown)
    if is_dataclass(shown) and not isinstance(shown, type):
        return replace(
            shown,
            **{field.name: _in_bold(getattr(shown, field.name), bold) for field in fields(shown)},
        )
    return shown


# --- what the letters denote ----------------------------------------------------------------------


def _definitions(
    scene: Scene, quantities: Sequence[Expression], names: dict[Words, str], bold: set[str]
) -> list[Words]:
    """``v and w are the speeds of A and B immediately after the collision``."""
    out: list[Words] = []
    rest = list(quantities)
    while rest:
        taken = _together(scene, rest)
        letters = listed(
            [
                words(
                    _in_bold(lay.letter(names[_key(scene, tree)]), bold),
                    scene.style.unit(dimension_of_any((tree,))),
                )
                for tree in rest[:taken]
            ]
        )
        out.append(words(letters, " is " if taken == 1 else " are ", _meaning(scene, rest[:taken])))
        rest = rest[taken:]
    return out


def _together(scene: Scene, quantities: Sequence[Expression]) -> int:
    """How many at the beginning can be told at once."""
    for number in range(len(quantities), 1, -1):
        first = quantities[:number]
        if alike([noun(scene, tree) for tree in first]) or times_until(scene, first):
            return number
        if _before_and_after(scene, first) is not None:
            return number
    return 1


def _meaning(scene: Scene, quantities: Sequence[Expression]) -> Words:
    nouns = [noun(scene, one) for one in quantities]
    if len(nouns) == 1:
        return nouns[0].words()
    if alike(nouns):
        head = of_bodies(nouns[0].kind, [one.body for one in nouns])
        return words(head, " ", nouns[0].when) if nouns[0].when else head
    times = times_until(scene, quantities)
    if times is not None:
        start, last = times
        return words("the times from ", start, " ", until(last), " respectively")
    both = _before_and_after(scene, quantities)
    assert both is not None
    return both


def _before_and_after(scene: Scene, quantities: Sequence[Expression]) -> Words | None:
    """``the speeds of P immediately before and immediately after the impact``."""
    if len(quantities) != 2:
        return None
    one, other = (noun(scene, quantity) for quantity in quantities)
    if not (one.kind and one.kind == other.kind and one.body == other.body and one.when):
        return None
    if one.when == other.when or not other.when or one.tail:
        return None
    first, then = one.when[0], other.when[0]
    for lead in ("immediately before ", "immediately after "):
        if isinstance(first, str) and isinstance(then, str) and first.startswith(lead):
            event = (first.removeprefix(lead), *one.when[1:])
            for second in ("immediately before ", "immediately after "):
                if then.startswith(second) and event == (
                    then.removeprefix(second),
                    *other.when[1:],
                ):
                    head = of_bodies(one.kind, (one.body,), several=True)
                    return words(head, f" {lead.strip()} and ", other.when)
    return None
