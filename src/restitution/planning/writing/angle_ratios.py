"""Ratios of an angle from one that is given, and the range of an angle."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any, Protocol

import sympy as sp

from restitution.components.models import Model
from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Fact, Link, Move, MoveId, Ref, Relation
from restitution.expression.tree import Apply, Binary, Degrees, Expression, Letter, Number
from restitution.planning.writing.desk import Desk, NotPlannedError, Source, chain
from restitution.planning.writing.forms import ONE, TWO, difference, product, square, total, tree_of
from restitution.planning.writing.judging import Judge
from restitution.planning.writing.polynomials import expanded, one_fraction


class Angles(Protocol):
    """What a scene knows of its angles."""

    model: Model
    desk: Desk

    @property
    def judge(self) -> Judge: ...

    @property
    def ratio_facts(self) -> Mapping[str, Fact]: ...

    def scalar(self, tree: Expression) -> sp.Expr: ...

    def put(self, value: Any) -> tuple[Any, tuple[Ref, ...]]: ...


def range_of(scene: Angles, name: str) -> str:
    """What is known of the range of an angle, as a premise says it."""
    role = scene.model.unknowns.roles[name]
    if role.low == 0 and role.high == sp.pi / 2 and not any(role.closed):
        return f"acute: {name}"
    signs = ["<=" if inside else "<" for inside in role.closed]
    if role.low is None or role.high is None:
        raise NotPlannedError(f"the range of {name} is open")
    ends = [f"{int(sp.deg(value))}°" for value in (role.low, role.high)]
    return f"{ends[0]} {signs[0]} {name} {signs[1]} {ends[1]}"


def ratio_of(kind: str, angle: sp.Expr) -> sp.Expr:
    """A sine, cosine or tangent as a number; with roots in roots as the root of its square."""
    ratio = tidy(getattr(sp, kind)(angle))
    if kind == "tan" or not ratio.is_number or not any(map(_has_root, ratio.atoms(sp.Pow))):
        return ratio
    square = sp.radsimp(expanded(getattr(sp, kind)(angle) ** 2))
    if any(map(_has_root, square.atoms(sp.Pow))):
        return ratio
    root = sp.sqrt(square) if ratio.is_positive else -sp.sqrt(square)
    return min(ratio, root, key=lambda value: value.count_ops())


def _has_root(power: sp.Pow) -> bool:
    """Whether a power is a root of a sum with roots."""
    return _is_root(power) and any(map(_is_root, power.base.atoms(sp.Pow)))


def _is_root(power: sp.Pow) -> bool:
    return bool(power.exp.is_Rational and not power.exp.is_Integer)


RECIPROCALS = {"cot": "tan", "sec": "cos", "cosec": "sin"}
"""Ratios of angles, each with the one of which it is the reciprocal."""


def letter_of_a_ratio(kind: str, angle: Expression) -> str | None:
    """The letter of an angle of which a ratio is given, or one of half of it; None of others."""
    match angle:
        case Letter(name) if kind in ("sin", "cos", "tan", *RECIPROCALS):
            return name
        case Binary("/", Letter(name), Number(value)) if kind in ("sin", "cos", "tan"):
            return name if value == 2 else None
        case Binary("*", Binary("/", Number(), Number()) as half, Letter(name)) if half == _HALF_OF:
            return name if kind in ("sin", "cos", "tan") else None
    return None


_HALF_OF = Binary("/", ONE, TWO)


def given_ratio(scene: Angles, name: str) -> tuple[Apply, Expression, Ref]:
    """The sine, cosine or tangent of an angle that is given, its value, and what says so.

    A reciprocal of one that is given is turned over first; of half the angle it is doubled.
    """
    fact = scene.ratio_facts[name]
    (link,) = fact.relation.only
    assert isinstance(link.left, Apply)
    if not isinstance(link.left.argument, Letter):
        return _doubled(scene, link.left, link.right, fact.id, Letter(name))
    plain = RECIPROCALS.get(link.left.function)
    if plain is None:
        return link.left, link.right, fact.id
    own = Apply(plain, Letter(name))
    right = tree_of(tidy(1 / scene.scalar(link.right)))
    first = scene.desk.write(Move("fact"), (fact.id,), fact.relation)
    return own, right, scene.desk.write(Move("rearrange"), (first,), chain(own, (right, None)))


def _doubled(
    scene: Angles, own: Apply, worth: Expression, ref: Ref, letter: Letter
) -> tuple[Apply, Expression, Ref]:
    """``cos α = 1 − 2 sin²(α/2) = 7/25``, or the tangent of α by that of α/2, as it is given."""

    def by(value: Expression) -> Expression:
        if own.function == "tan":
            return Binary("/", product(TWO, value), difference(ONE, square(value)))
        twice = product(TWO, square(value))
        return difference(ONE, twice) if own.function == "sin" else difference(twice, ONE)

    asked = Apply("tan" if own.function == "tan" else "cos", letter)
    final = tree_of(tidy(scene.scalar(by(worth))))
    relation = chain(asked, (by(own), None), (by(worth), "put"), (final, "rearrange"))
    number = scene.judge.write((Move("identity", "double-angle"),), (ref,), relation)
    if number is None:
        raise NotPlannedError("a ratio of half an angle")
    return asked, final, number


def write_ratios(scene: Angles, symbol: sp.Symbol) -> None:
    """``cos α = 3/5 and sin α = 4/5`` from the ratio that is given."""
    own, right, ref = given_ratio(scene, symbol.name)
    letter = Letter(symbol.name)
    angle = scene.model.final[symbol]
    given = own.function
    scene.desk.know(own, scene.scalar(right), (ref,))
    others = {ratio: ratio_of(ratio, angle) for ratio in ("sin", "cos", "tan") if ratio != given}
    shown = [ratio for ratio in ("sin", "cos") if ratio != given]
    links = tuple(Link(Apply(ratio, letter), "=", tree_of(others[ratio])) for ratio in shown)
    number = scene.desk.write(
        Move("triangle"), (ref, range_of(scene, symbol.name)), Relation((links,))
    )
    for ratio in shown:
        scene.desk.know(Apply(ratio, letter), others[ratio], (number,))
    if "tan" in others:
        scene.desk.know(Apply("tan", letter), others["tan"], (ref, number))


_OF_COMPLEMENTS = {"sin": "cos", "cos": "sin", "tan": "tan"}


def write_complement(scene: Angles, own: Apply, fact: Fact, other: str) -> None:
    """``sin β = cos α``, ``cos β = sin α`` or ``tan β = 1/tan α``, of two angles that make 90°."""
    ratio: Expression = Apply(_OF_COMPLEMENTS[own.function], Letter(other))
    if own.function == "tan":
        ratio = Binary("/", ONE, ratio)
    number = scene.desk.write(Move("identity", "complement"), (fact.id,), chain(own, (ratio, None)))
    scene.desk.know(own, scene.scalar(ratio), (number,))


def write_other_ratio(scene: Angles, symbol: sp.Symbol, kind: str) -> None:
    """A sine, cosine or tangent of an angle of which another is known, or the angle itself."""
    letter, worth = Letter(symbol.name), scene.model.final.get(symbol)
    for ratio in ("tan", "sin", "cos"):
        known = scene.desk.known(Apply(ratio, letter))
        if worth is None or known is None or len(known.refs) != 1:
            continue  # one of another part is open in this one
        known, angle = _in_numbers(scene, Apply(ratio, letter), known, worth)
        kinds = [kind] if kind == "tan" else [own for own in ("sin", "cos") if own != ratio]
        trees = {own: ratio_of(own, angle) for own in kinds}
        if ratio == "tan":
            trees |= _over_one_root(scene, known.value, trees)
        refs = known.refs
        nested = any(_has_root(power) for own in trees.values() for power in own.atoms(sp.Pow))
        exact = known.value.is_number and not known.value.has(sp.sin, sp.cos, sp.tan)
        of_roots = exact and not expanded(known.value**2).is_Rational
        if ratio == "tan" and exact and (nested or of_roots):
            refs = (square_of_cosine(scene, letter, known),)
            if not nested:
                for own in kinds:
                    _write_by_its_square(scene, Apply(own, letter), trees[own], refs)
                return
        links = tuple(Link(Apply(own, letter), "=", tree_of(trees[own])) for own in kinds)
        premises = (*refs, range_of(scene, symbol.name))
        more = scene.judge.known(symbol_names(known.value))
        enough = scene.judge.enough(Move("triangle"), premises, Relation((links,)), more)
        premises = premises if enough is None else enough
        number = scene.desk.write(Move("triangle"), premises, Relation((links,)))
        for own in kinds:
            scene.desk.know(Apply(own, letter), trees[own], (number,))
        return


def _write_by_its_square(
    scene: Angles, ratio: Apply, value: sp.Expr, squares: tuple[Ref, ...]
) -> None:
    """``sin φ = √((7 − √33)/24) = (√33 − 3)/12`` by the square of the cosine."""
    assert isinstance(ratio.argument, Letter)
    root, last = Apply("sqrt", tree_of(tidy(expanded(value**2)))), tree_of(value)
    premises = (*squares, range_of(scene, ratio.argument.name))
    number = scene.desk.write(Move("triangle"), premises, chain(ratio, (root, None)))
    if last != root:
        number = scene.desk.write(Move("rearrange"), (number,), chain(ratio, (last, None)))
    scene.desk.know(ratio, value, (number,))


def _over_one_root(
    scene: Angles, tangent: sp.Expr, ratios: Mapping[str, sp.Expr]
) -> dict[str, sp.Expr]:
    """Sine and cosine by a tangent p/q in letters as p and q over the root of p² + q².

    Those that are no shorter so are left out.
    """
    above, below = sp.fraction(one_fraction(tangent))
    if not tangent.free_symbols or not below.free_symbols:
        return {}
    if scene.model.sign(scene.model.in_data(below)) < 0:
        above, below = -above, -below
    whole = expanded(above**2 + below**2)
    # √3 and 3e are 1 and √3 e: no number is left in all of the root.
    shared = sp.sqrt(whole.as_content_primitive()[0])
    above, below, root = above / shared, below / shared, sp.sqrt(expanded(whole / shared**2))
    own = {"sin": above / root, "cos": below / root}
    return {
        kind: own[kind]
        for kind, value in ratios.items()
        if kind in own and own[kind].count_ops() < value.count_ops()
    }


def ratio_of_degrees(scene: Angles, asked: Apply) -> Source | None:
    """A ratio of an angle that is known as a number of degrees: tan θ = tan 45° = 1."""
    known = scene.desk.known(asked.argument)
    if known is None or isinstance(known.value, tuple):
        return None
    angle = tree_of(known.value, angle=True)
    if not isinstance(angle, Degrees):
        return None
    value, ratio = tidy(getattr(sp, asked.function)(known.value)), Apply(asked.function, angle)
    number = scene.desk.write(Move("rearrange"), known.refs, chain(asked, (ratio, None)))
    if tree_of(value) != ratio:
        last = chain(asked, (tree_of(value), None))
        number = scene.desk.write(Move("rearrange"), (number,), last)
    return scene.desk.know(asked, value, (number,))


def ratio_of_a_multiple(scene: Angles, ratio: sp.Expr) -> Source | None:
    """The sine, cosine or tangent of twice an angle, or the tangent of half, with a known ratio.

    What is known is a number, and so is what comes of it. Sine and cosine are written in one place.
    """
    count, symbol = ratio.args[0].as_coeff_Mul()
    if count not in _MULTIPLES or not symbol.is_Symbol or symbol not in scene.model.final:
        return None
    if (scene.model.final[symbol] / sp.pi).is_Rational:
        return None
    name, angle = type(ratio).__name__, _multiple(count, symbol)
    known = scene.desk.known(Apply(name, angle))
    if known is not None:
        return known
    if count == _HALF:
        if name == "tan":
            _write_half(scene, Letter(symbol.name), angle)
        return scene.desk.known(Apply(name, angle))
    if count > _TWICE:
        for own in (sp.tan,) if name == "tan" else (sp.sin, sp.cos):
            if ratio_of_a_multiple(scene, own(count * symbol / 2)) is None:
                return None
    for other in ("tan",) if name == "tan" else ("sin", "cos"):
        _write_double(scene, other, _multiple(count / 2, symbol), angle)
    return scene.desk.known(Apply(name, angle))


_TWICE, _HALF = sp.Integer(2), sp.Rational(1, 2)
_MULTIPLES = (_HALF, _TWICE, 2 * _TWICE)


def _multiple(count: sp.Rational, symbol: sp.Symbol) -> Expression:
    """So many times an angle, as a line has it: α, 2α, α/2."""
    letter = Letter(symbol.name)
    if count == _HALF:
        return Binary("/", letter, TWO)
    return letter if count == 1 else product(tree_of(count), letter)


def _write_half(scene: Angles, letter: Letter, half: Expression) -> None:
    """The tangent of half an angle by its sine and cosine: tan ½α = sin α/(1 + cos α)."""
    symbol = scene.model.unknowns.letter(letter.name)
    ratios = {own: Apply(own, letter) for own in ("sin", "cos")}
    sources = {own: scene.put(getattr(sp, own)(symbol)) for own in ratios}
    if any(not refs or not (value**2).is_Rational for value, refs in sources.values()):
        return
    numbers = {own: tree_of(value) for own, (value, _) in sources.items()}
    by_letter, by_number = (
        Binary("/", trees["sin"], total((ONE, trees["cos"]))) for trees in (ratios, numbers)
    )
    value = tidy(scene.scalar(by_number))
    asked = Apply("tan", half)
    relation = chain(asked, (by_letter, None), (by_number, "put"), (tree_of(value), "rearrange"))
    refs = dict.fromkeys(ref for _, own in sources.values() for ref in own)
    pool = (*refs, range_of(scene, letter.name))
    number = scene.judge.write((Move("identity", "half-angle"),), pool, relation)
    if number is not None:
        scene.desk.know(asked, value, (number,))


def _write_double(scene: Angles, name: str, letter: Expression, double: Expression) -> None:
    """The line of a ratio of twice an angle, by the tangent of that or by its sine and cosine."""
    ratios = {own: Apply(own, letter) for own in ("sin", "cos", "tan")}
    known = {own: scene.desk.known(tree) for own, tree in ratios.items()}
    by_both = all(known[own] is not None for own in ("sin", "cos")) and name != "tan"
    used = ("sin", "cos") if by_both else ("tan",)
    sources = {own: source for own in used if (source := known[own]) is not None}
    values = {own: source.value for own, source in sources.items()}
    if len(values) < len(used) or not all((value**2).is_Rational for value in values.values()):
        return
    numbers = {own: tree_of(value) for own, value in values.items()}
    by_letter, by_number = (_of_a_double(name, trees) for trees in (ratios, numbers))
    if not by_both:
        by_letter = _of_a_double(name, {"tan": ratios["tan"]})
    final = tree_of(tidy(scene.scalar(by_number)))
    asked = Apply(name, double)
    relation = chain(asked, (by_letter, None), (by_number, "put"), (final, "rearrange"))
    refs = dict.fromkeys(ref for source in sources.values() for ref in source.refs)
    number = scene.judge.write((Move("identity", "double-angle"),), refs, relation)
    if number is not None:
        scene.desk.know(asked, scene.scalar(final), (number,))


def _of_a_double(ratio: str, trees: Mapping[str, Expression]) -> Expression:
    """A ratio of twice an angle: by its sine and cosine, or by its tangent where these are none."""
    if "sin" in trees and ratio == "sin":
        return product(TWO, trees["sin"], trees["cos"])
    if "sin" in trees and ratio == "cos":
        return difference(square(trees["cos"]), square(trees["sin"]))
    t = trees["tan"]
    twice, squared = product(TWO, t), square(t)
    if ratio == "tan":
        return Binary("/", twice, difference(ONE, squared))
    above = twice if ratio == "sin" else difference(ONE, squared)
    return Binary("/", above, total((ONE, squared)))


def _in_numbers(
    scene: Angles, tree: Apply, known: Source, angle: sp.Expr
) -> tuple[Source, sp.Expr]:
    """A ratio, and its angle, with the numbers put in that its letters are in this part."""
    value, refs = scene.put(known.value)
    if not refs or value.free_symbols or not known.value.free_symbols:
        return known, angle
    pool = (*known.refs, *refs)
    number = scene.desk.write(Move("put"), pool, chain(tree, (tree_of(value), None)))
    scene.desk.know(tree, value, (number,))
    return Source(value, (number,)), scene.put(angle)[0]


def square_of_cosine(scene: Angles, letter: Letter, tangent: Source) -> int:
    """``cos²α = 1/(1 + tan²α)`` with a tangent that has roots put in, and what that comes to."""
    squared = square(Apply("cos", letter))
    whole = Binary("/", ONE, total((ONE, square(tree_of(tangent.value)))))
    premises = (*tangent.refs, range_of(scene, letter.name))
    first = scene.desk.write(Move("triangle"), premises, chain(squared, (whole, None)))
    above, below = sp.fraction(one_fraction(expanded(1 + tangent.value**2)))
    value = tidy(sp.radsimp(below / above))
    steps = [Binary("/", tree_of(below), tree_of(expanded(above), as_it_is=True)), tree_of(value)]
    one, *rest = dict.fromkeys(steps)
    by: MoveId = "rearrange"
    relation = chain(squared, (one, None), *((tree, by) for tree in rest))
    return scene.desk.write(Move("rearrange"), (first,), relation)


@lru_cache(maxsize=4096)
def ratios_and_letters(x: sp.Expr) -> tuple[tuple[sp.Expr, ...], tuple[sp.Symbol, ...]]:
    """The ratios of angles in an expression, and the letters outside of them."""
    ratios = x.atoms(sp.sin, sp.cos, sp.tan)
    bare = x.xreplace(dict.fromkeys(ratios, sp.Integer(1))) if ratios else x
    return (
        tuple(sorted(ratios, key=lambda ratio: ratio.sort_key())),
        tuple(sorted(bare.free_symbols, key=lambda symbol: symbol.name)),
    )
