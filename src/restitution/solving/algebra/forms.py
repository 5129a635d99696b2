"""Values as answers: signs resolved, angles as inverse tangents, everything in textbook form."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

import sympy as sp

from restitution import exact
from restitution.exact.degrees import function_of, has_sums_of_surds, with_ratio
from restitution.exact.simplicity import is_surd
from restitution.exact.symbols import atoms_in, symbols_in
from restitution.expression.enclosed import Enclosed, UndefinedError
from restitution.expression.evaluate import Angle, root
from restitution.oracle import Oracle, Relation, Some
from restitution.records import dataclass
from restitution.solving.algebra.neat import neat
from restitution.solving.algebra.numbers import FIELD, at, sign_at
from restitution.vector import Vector

Samples = Iterable[Mapping[str, Enclosed]]
_FEW = 4


@dataclass(frozen=True)
class _Moving:
    """Samples at which a vector is not zero, so that it has a direction."""

    samples: Samples
    oracle: Oracle | None

    def __iter__(self) -> Iterator[Mapping[str, Enclosed]]:
        return iter(self.samples)


def _moving(x: sp.Expr, y: sp.Expr, samples: Samples) -> Samples:
    oracle: Oracle | None = getattr(samples, "oracle", None)
    if oracle is None or not (x.free_symbols or y.free_symbols):
        return samples
    return _Moving(samples, oracle.with_facts([Some((Relation(x, "!="), Relation(y, "!=")))]))


def sign_of(x: sp.Expr, samples: Samples) -> int | None:
    """The sign of an expression: seen at all samples, and proved where they know how to.

    It may be zero besides, where a letter is at an end of what it may be.
    """
    oracle: Oracle | None = getattr(samples, "oracle", None)
    # A few show which sign there is to be proved.
    seen = None if oracle is None else sign_at(x, itertools.islice(samples, _FEW))
    if seen is None:
        seen = sign_at(x, samples)
    if seen is None or oracle is None or not symbols_in(sp.sympify(x, strict=True)):
        return seen
    claim = Relation(x, "=") if seen == 0 else Relation(seen * x, ">=")
    return seen if oracle.decide(claim) else None


def open_in(value: Angle | Vector | sp.Expr, samples: Samples) -> list[str]:
    """Hidden unknowns that a value rests on: names that begin with ``_``.

    Each of them is seen to matter, as the value is another where that alone is a little larger.
    This costs little beside a textbook form, which nobody would read.
    """
    sides = [value.x, value.y] if isinstance(value, Angle | Vector) else [value]
    sides = [sp.sympify(side, strict=True) for side in sides]
    present = sorted(
        (s for s in set().union(*(symbols_in(x) for x in sides)) if s.name.startswith("_")),
        key=lambda s: s.name,
    )
    angles = []
    for symbol in present:
        other = sp.Symbol(f"{symbol.name}_besides", real=True)
        there = [side.xreplace({symbol: other}) for side in sides]
        if isinstance(value, Angle):
            differences = [sides[0] * there[1] - sides[1] * there[0]]
        else:
            differences = [a - b for a, b in zip(sides, there, strict=True)]
        for point in itertools.islice(samples, _FEW):
            here = point.get(symbol.name)
            if here is None:
                continue
            moved = {**point, other.name: here + (abs(here) if here.sign else 1) / 1024}
            if any(sign_at(difference, [moved]) for difference in differences):
                angles.append(symbol.name)
                break
    return angles


LONG = 30
"""What there is more to read in, by its cost, is tidied once more."""
FOR_A_CALCULATOR = 150
"""A number of so many operations, with ratios such as sin 35°, is told by its digits alone."""
OF_SEVERAL_ANGLES = 30
"""The same for ratios of several angles: no other form of it becomes short."""


def plain(value: Any, samples: Samples) -> Any:
    """A value of any kind in textbook form: a SymPy expression, or a Vector of two."""
    if isinstance(value, Vector):
        return Vector(plain(value.x, samples), plain(value.y, samples))
    if isinstance(value, Angle):
        return angle(value, samples)
    value = signed(sp.sympify(value, strict=True), samples)
    if is_for_a_calculator(value):
        return value
    plainer = tidy(value)
    # With fewer bars, and of what was too long at first, there is more to be taken together.
    again = plainer.has(sp.Abs) or exact.cost(plainer) > LONG
    return exact.tidy(signed(plainer, samples)) if again else plainer


def is_for_a_calculator(value: sp.Expr) -> bool:
    """Whether a value is a long number with ratios of angles such as 35°, that nobody reads."""
    if symbols_in(value) or not value.has(sp.sin, sp.cos, sp.tan):
        return False
    if not OF_SEVERAL_ANGLES < sp.count_ops(value) <= FOR_A_CALCULATOR:
        return bool(sp.count_ops(value) > FOR_A_CALCULATOR)
    merged = exact.merged(value)
    several = len(exact.plain_angles_in(merged)) > 1
    return several and bool(sp.count_ops(merged) > OF_SEVERAL_ANGLES)


def bound(x: sp.Expr) -> sp.Expr:
    """An end of a range, or a greatest value, in textbook form."""
    if x.has(sp.atan, sp.acos, sp.asin, sp.atan2):
        return exact.tidy_angle(x)
    return exact.tidy(x)


def tidy(x: sp.Expr) -> sp.Expr:
    """Textbook form; sines of angles such as 37° are treated as those of a letter."""
    if x.has(sp.atan):
        x = x.replace(sp.atan, lambda a: sp.atan(tidy(a)))
    if not x.has(sp.sin, sp.cos, sp.tan):
        return unnested(exact.tidy(x))
    masked, angles = _angles_as_letters(x)
    if not angles:
        return exact.tidy(x)
    form = _with_angles(exact.tidy(neat(masked)), angles)
    # Ratios of 15° and 75° have roots that go together with others: 2 − √3 + 4 cos² 75°.
    surds = any(power.base.is_Rational for power in form.atoms(sp.Pow) if is_surd(power))
    again = surds and any(map(has_sums_of_surds, angles.values()))
    return exact.tidy(form) if again else form


def _with_angles(x: sp.Expr, angles: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
    """Letters of angles replaced by these, whose ratios stay: SymPy has roots for some of them."""
    ratios = {
        ratio: with_ratio(function_of(ratio), ratio.args[0].xreplace(angles))
        for ratio in x.atoms(sp.sin, sp.cos, sp.tan)
    }
    return x.xreplace(ratios).xreplace(angles)


def _angles_as_letters(x: sp.Expr) -> tuple[sp.Expr, dict[sp.Symbol, sp.Expr]]:
    """Sines, cosines and tangents of plain numbers as those of an acute letter."""
    letters: dict[sp.Expr, sp.Symbol] = {}
    put: dict[sp.Expr, sp.Expr] = {}
    for node in sorted(atoms_in(x, sp.sin, sp.cos, sp.tan), key=sp.default_sort_key):
        argument = node.args[0]
        if argument.free_symbols:
            continue
        # SymPy turns the sine of 50° into the cosine of 40°: one letter for both.
        other = sp.pi / 2 - argument
        if other in letters:
            complement = {sp.sin: sp.cos, sp.cos: sp.sin}.get(function_of(node))
            if complement is None:
                put[node] = 1 / sp.tan(letters[other])
            else:
                put[node] = complement(letters[other])
            continue
        if argument not in letters:
            letters[argument] = sp.Dummy("alpha", len(letters), positive=True)
        put[node] = function_of(node)(letters[argument])
    return x.xreplace(put), {letter: argument for argument, letter in letters.items()}


def unnested(x: sp.Expr) -> sp.Expr:
    """A numerical factor with roots inside roots, as a sum of plain roots where possible."""
    number, rest = x.as_independent(*symbols_in(x)) if symbols_in(x) else (x, sp.Integer(1))
    if symbols_in(x) and not x.is_Mul:
        return x
    if not exact.is_nested(number) or not number.is_real:
        return x
    plainer = exact.denested(sp.sqrt(sp.radsimp(sp.expand(number**2))))
    if number.is_negative:
        plainer = -plainer
    if exact.cost(plainer) < exact.cost(number):
        return exact.tidy(plainer * rest)
    return x


def signed(x: sp.Expr, samples: Samples) -> sp.Expr:
    """Sizes |x| and roots of squares without bars where the sign of x is known."""
    for _ in range(4):
        bars = list(atoms_in(x, sp.Abs))
        if not bars:
            break
        put = {}
        for node in bars:
            sign = sign_of(node.args[0], samples)
            if sign is not None:
                put[node] = sign * node.args[0]
        if not put:
            break
        x = x.xreplace(put)
    return x


def bars_of(x: sp.Basic, oracle: Oracle) -> dict[sp.Basic, sp.Expr]:
    """What stands for the sizes |x| in an expression, or a set, of which the sign is proved."""
    return {
        bars: own
        for bars in x.atoms(sp.Abs)
        for own in (bars.args[0], -bars.args[0])
        if oracle.decide(Relation(own, ">="))
    }


def angle(value: Angle, samples: Samples) -> sp.Expr:
    """An angle in radians: a sum of letters, or by an inverse function of what is simplest.

    A sum of two angles, or a multiple of one, may be more than half a turn.
    """
    own = _within_a_turn(value, samples)
    whole = sp.sympify(value.measure(), strict=True)
    if isinstance(whole, sp.atan2 | sp.Symbol):
        return own
    turns: set[int] = set()
    for values in samples:
        try:
            gap = (at(whole, values) - at(own, values)) / (2 * at(sp.pi, {}))
        except (UndefinedError, KeyError):
            continue
        turns.add(round(float(gap)))
    if len(turns) > 1:  # for some letters it is more, for others not: the sum tells both
        return sp.Add(*(_term(argument, samples) for argument in sp.Add.make_args(whole)))
    return own if turns <= {0} else exact.tidy_angle(own + 2 * turns.pop() * sp.pi)


def by_directions(value: Any, samples: Samples) -> sp.Expr | None:
    """An angle by the directions of vectors; None where that is not how it is worked out.

    It has a value wherever the vectors are not zero, and its textbook form may have none there:
    arctan(3/|2e − 1|) where e is ½, and the angle 90°.
    """
    if not isinstance(value, Angle):
        return None
    whole = sp.sympify(value.measure(), strict=True)
    if not whole.has(sp.atan2):
        return None
    return whole.replace(sp.atan2, lambda y, x: _direction_angle(y, x, samples))


def _direction_angle(y: sp.Expr, x: sp.Expr, samples: Samples) -> sp.Expr:
    """The angle of a vector, without the factors that are positive whatever the letters are."""
    sides = [signed(side, samples) for side in (y, x)]
    factors = [set(sp.Mul.make_args(sp.factor(side))) for side in sides]
    common = sp.Mul(*(factor for factor in factors[0] & factors[1] if factor.is_positive))
    return sp.atan2(*(tidy(side / common) for side in sides))


def _term(x: sp.Expr, samples: Samples) -> sp.Expr:
    """A term of a sum of angles, of which one may be that of a vector."""
    factor, arc = x.as_coeff_Mul()
    if not isinstance(arc, sp.atan2):
        return x
    above, below = arc.args
    return factor * _within_a_turn(Angle(below, above, lambda: arc), samples)


def _within_a_turn(value: Angle, samples: Samples) -> sp.Expr:
    """An angle by the direction of a vector, from −180° to 180°."""
    x, y = (signed(sp.sympify(part, strict=True), samples) for part in (value.x, value.y))
    if not x.free_symbols and not y.free_symbols and not (x + y).has(sp.sin, sp.cos, sp.tan):
        return exact.tidy_angle(sp.atan2(_number(y), _number(x)))
    samples = _moving(x, y, samples)
    sx, sy = sign_of(x, samples), sign_of(y, samples)
    if sy == 0 and sx is not None:
        return sp.Integer(0) if sx > 0 else sp.pi
    if sx == 0 and sy is not None:
        return sy * sp.pi / 2
    if sy == 0:
        return sp.atan2(sp.Integer(0), _deciding_sign(tidy(x), samples))
    measured = value.measure()
    if isinstance(measured, sp.Symbol) or (
        measured.is_Add and not measured.has(sp.atan2) and not measured.has(sp.Abs)
    ):
        return exact.tidy_angle(measured)
    whole = _sum_of_letters(x, y, samples)
    if whole is not None:
        return whole
    forms: list[sp.Expr] = []
    if sx == 1:
        forms = [_arc(y, x, sy)]
    elif sx == -1 and sy is not None:
        forms = [sy * sp.pi - sy * _arc(sy * y, -x, 1)]
    elif sy is not None:
        # Beyond a right angle or not: the complement is right for both.
        forms = [sy * sp.pi / 2 - sy * _arc(x, sy * y, None)]
        forms += _turned(x, y, samples) if sy == 1 else ()
    if sx == 1 or sy is not None:
        return min((*forms, *_doubled(x, y, samples)), key=exact.cost)
    return sp.atan2(tidy(y), tidy(x))


def _doubled(x: sp.Expr, y: sp.Expr, samples: Samples) -> Iterator[sp.Expr]:
    """An angle as twice another one, 2 arctan(e/tan α), where the size of the vector has no root.

    Half of it is less than a right angle.
    """
    if not y.free_symbols or exact.cost(y) + exact.cost(x) > LONG:
        return
    size = plain(root(x**2 + y**2), samples)
    if not _has_root(size) and not size.has(sp.Abs):
        yield 2 * sp.atan(tidy(neat(y / (size + x))))


def _deciding_sign(x: sp.Expr, samples: Samples) -> sp.Expr:
    """The factors of an expression that can change sign, with the sign of the others."""
    above, below = sp.together(x).as_numer_denom()
    kept: list[sp.Expr] = []
    for factor in (*sp.Mul.make_args(sp.factor(above)), *sp.Mul.make_args(sp.factor(below))):
        base = factor.base if factor.is_Pow and factor.exp.is_Integer and factor.exp % 2 else factor
        own = sign_of(base, samples)
        kept.append(base if own is None else sp.Integer(own))
    return tidy(sp.Mul(*kept))


def _arc(y: sp.Expr, x: sp.Expr, sy: int | None) -> sp.Expr:
    """The angle of a vector with x > 0: by its sine or cosine where that saves a root."""
    if is_for_a_calculator(y / x):
        return sp.atan(y / x)
    tangent = tidy(neat(y / x))
    if _has_root(tangent) and not exact.root_is_nested(x**2 + y**2):
        size = sp.sqrt(tidy(x**2 + y**2))
        for function, side in ((sp.asin, y), (sp.acos, x)):
            ratio = tidy(side / size)
            if not _has_root(ratio) and (function is sp.asin or sy == 1):
                return exact.tidy_angle(function(ratio))
    return exact.tidy_angle(sp.atan(tangent))


def acute_angle(angle: sp.Expr, sign: Callable[[sp.Expr], int | None]) -> sp.Expr:
    """An acute angle by its cosine or sine, where its tangent is longer for the letters in it.

    ``sign`` tells the sign of an expression, or None where it is open.
    """
    tangent = angle.args[0] if isinstance(angle, sp.atan) else sp.Integer(0)
    if not tangent.free_symbols or not _has_root(tangent):
        return angle
    above, below = tangent.as_numer_denom()
    own = sign(below)
    if not own or sign(above) != own:
        return angle
    above, below = own * above, own * below
    size = exact.tidy(sp.sqrt(tidy(sp.expand(above**2 + below**2))))
    size = size.replace(sp.Abs, lambda x: (sign(x) or 0) * x or sp.Abs(x))
    others = (sp.acos(tidy(below / size)), sp.asin(tidy(above / size)))
    return min((angle, *others), key=exact.cost)


def _has_root(x: sp.Expr) -> bool:
    return any(
        isinstance(atom, sp.Pow) and not atom.exp.is_Integer and atom.free_symbols
        for atom in atoms_in(x, sp.Pow)
    )


def _turned(x: sp.Expr, y: sp.Expr, samples: Samples) -> Iterator[sp.Expr]:
    """An angle from 0 to 180° as a letter and a rest: α + arctan(e tan α)."""
    for letter in _angles_in(x + y):
        for sense in (1, -1):
            c, s = sp.cos(letter), sense * sp.sin(letter)
            along, across = neat(x * c + y * s), neat(y * c - x * s)
            sign = sign_of(along, samples)
            if sign == 1:
                yield sense * letter + _arc(across, along, None)
            elif sign == -1 and sign_of(across, samples) == 1:
                yield sp.pi + sense * letter - _arc(across, -along, 1)


def _angles_in(x: sp.Expr) -> list[sp.Symbol]:
    angles = {
        atom.args[0] for atom in atoms_in(x, sp.sin, sp.cos, sp.tan) if atom.args[0].is_Symbol
    }
    return sorted(angles, key=lambda letter: letter.name)


def _sum_of_letters(x: sp.Expr, y: sp.Expr, samples: Samples) -> sp.Expr | None:
    """The direction as 2α, 2φ − α or 90° − α, if it is such a sum at all the samples."""
    angles = _angles_in(x + y)
    if not 1 <= len(angles) <= 3:
        return None
    chosen: tuple[int, ...] | None = None
    twelfths = 0
    for values in samples:
        try:
            whole = FIELD.arctan2(at(y, values), at(x, values))
        except UndefinedError:
            continue
        own = [values[letter.name] for letter in angles]
        if chosen is None:
            combination = _whole_numbers(whole, own)
            if combination is None:
                return None
            chosen, twelfths = combination
        rest = whole - sum(n * term for n, term in zip(chosen, own, strict=True))
        if (rest - twelfths * FIELD.pi / 12).sign:
            return None
    if chosen is None:
        return None
    terms = [n * letter for n, letter in zip(chosen, angles, strict=True)]
    return sp.Add(*terms, twelfths * sp.pi / 12)


def _whole_numbers(whole: Any, parts: list[Any]) -> tuple[tuple[int, ...], int] | None:
    """Small whole numbers n with whole = n₁a₁ + n₂a₂ + … + m π/12, and m."""
    step = FIELD.pi / 12
    for numbers in itertools.product((0, 1, -1, 2, -2), repeat=len(parts)):
        ratio = (whole - sum(n * part for n, part in zip(numbers, parts, strict=True))) / step
        nearest = round(float(ratio))
        if abs(nearest) <= 24 and not (ratio - nearest).sign:
            return numbers, nearest
    return None


def _number(x: sp.Expr) -> sp.Expr:
    plain = exact.rationalised(x)
    return sp.sqrtdenest(sp.radsimp(sp.expand(x), max_terms=4)) if plain is None else plain


def along_and_across(value: Vector, line: Vector, samples: Samples) -> sp.Expr:
    """A speed from the components of a velocity along a line and perpendicular to it."""
    length = sp.sqrt(tidy(line.dot(line)))
    parts = [neat(product / length) for product in (value.dot(line), value.cross(line))]
    # √6 − √2 e as √2 (√3 − e): the root goes outside.
    scale, parts = min(
        ((s, [tidy(part * sp.sqrt(s)) for part in parts]) for s in (1, 2, 3)),
        key=lambda pair: sum(exact.cost(value) for value in pair[1]),
    )
    return plain(root((parts[0] ** 2 + parts[1] ** 2) / scale), samples)


def direction(value: Vector, samples: Samples) -> Vector:
    """A direction vector, up to scale: without fractions or common factors."""
    x, y = (signed(sp.sympify(part, strict=True), samples) for part in value)
    if x == 0:
        return Vector(sp.Integer(0), sp.Integer(sign_of(y, samples) or 1))
    if y == 0:
        return Vector(sp.Integer(sign_of(x, samples) or 1), sp.Integer(0))
    ratio = tidy(neat(y / x))
    up, along = sp.fraction(ratio)
    if not _has_root(ratio) and exact.cost(up) + exact.cost(along) < 12:
        sense = sign_of(along * x, samples) or 1
        return Vector(sense * along, sense * up)
    return Vector(tidy(x), tidy(y))
