"""Quotients without the factors that both sides have in common, where only surds show them."""

from __future__ import annotations

import mpmath
import sympy
from mpmath.libmp import NoConvergence
from sympy import Add, Expr, Mul, Pow, Rational, Symbol

from restitution.exact.simplicity import cost, is_surd
from restitution.exact.symbols import atoms_in
from restitution.work import spend

_SURDS = 2
_TERMS = 16
_LETTERS = 4
_COUNTED = 20


def over_surds(value: Expr) -> Expr:
    """``(√3 u² + 4uv + √3 v²)/(3v² − u²)`` as ``(√3 u + v)/(√3 v − u)``.

    A value that has no such factor comes back as it is.
    """
    surds = {power for power in atoms_in(value, Pow) if is_surd(power)}
    plain = all(surd.exp.q == 2 and surd.base.is_Integer for surd in surds)
    if not plain or not 0 < len(surds) <= _SURDS or len(value.free_symbols) > _LETTERS:
        return value
    above, below = sympy.fraction(value)
    if not any(_have_a_common_root(a, b) for a in _sums(above) for b in _sums(below)):
        return value
    spend(_COUNTED)
    try:
        form = sympy.cancel(value, extension=sorted(surds, key=sympy.default_sort_key))
    except (sympy.PolynomialError, NotImplementedError):
        return value
    above, below = sympy.fraction(form)
    forms = [sympy.factor(form)]
    for surd in surds:
        # √3 m/(√3 u − 3m) is m/(u − √3 m).
        sides = (sympy.factor_terms(sympy.expand(side / surd)) for side in (above, below))
        forms.append(next(sides) / next(sides))
    return min(forms, key=cost)


def _sums(side: Expr) -> list[Add]:
    """The sums among the factors of a side, of which none is long."""
    bases = [factor.as_base_exp()[0] for factor in Mul.make_args(side)]
    return [
        base
        for base in bases
        if isinstance(base, Add) and len(base.args) <= _TERMS and base.is_polynomial()
    ]


def _have_a_common_root(a: Add, b: Add) -> bool:
    """Whether two polynomials vanish together where all letters but one have some values."""
    common = sorted(a.free_symbols & b.free_symbols, key=sympy.default_sort_key)
    return bool(common) and all(_vanish_together(a, b, letter) for letter in common[:1])


def _vanish_together(a: Add, b: Add, letter: Symbol) -> bool:
    others = sorted((a.free_symbols | b.free_symbols) - {letter}, key=sympy.default_sort_key)
    put = {value: Rational(7 * n + 11, 13 + n) for n, value in enumerate(others)}
    polynomials = []
    for value in (a, b):
        coefficients = sympy.Poly(value.xreplace(put), letter).all_coeffs()
        # With numbers for letters there may be roots of negative numbers.
        parts = [number.evalf(40).as_real_imag() for number in coefficients]
        polynomials.append(
            [mpmath.mpc(*map(str, p)) if p[1] else mpmath.mpf(str(p[0])) for p in parts]
        )
    # Where one of them has a double root, this is found only as a root of the other.
    return any(_vanishes_at_a_root(*pair) for pair in (polynomials, polynomials[::-1]))


def _vanishes_at_a_root(one: list[mpmath.mpf], other: list[mpmath.mpf]) -> bool:
    """Whether a polynomial is zero at a root of another one, by their coefficients."""
    try:
        roots = mpmath.polyroots(one, maxsteps=80, extraprec=80)
    except (NoConvergence, ZeroDivisionError):
        return False
    sizes = [abs(number) for number in other]
    return any(abs(mpmath.polyval(other, x)) < 1e-9 * mpmath.polyval(sizes, abs(x)) for x in roots)


def reduced_over_surds(value: Expr) -> Expr:
    """A quotient without what `over_surds` leaves out, in which u² is |u|²."""
    sizes = sizes_in(value) if value.has(sympy.Abs) else {}
    return over_surds(value.xreplace(sizes)).xreplace(bars_again(sizes))


def sizes_in(value: Expr) -> dict[Expr, Expr]:
    """Positive letters for |u| and u, where a value is the same for u and −u."""
    put: dict[Expr, Expr] = {}
    bars = [bar for bar in value.atoms(sympy.Abs) if bar.args[0].is_Symbol]
    for n, bar in enumerate(sorted(bars, key=sympy.default_sort_key)):
        letter = bar.args[0]
        size = sympy.Dummy(letter.name, n, positive=True)
        there = value.xreplace({bar: size})
        if letter in there.free_symbols and there.xreplace({letter: -letter}) == there:
            put |= {bar: size, letter: size}
    return put


def bars_again(sizes: dict[Expr, Expr]) -> dict[Expr, Expr]:
    """The bars for the letters that stood for them."""
    return {size: bar for bar, size in sizes.items() if isinstance(bar, sympy.Abs)}
