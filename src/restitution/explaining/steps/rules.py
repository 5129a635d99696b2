"""Values put in: what is cited of a letter or a quantity takes its place."""

from __future__ import annotations

from dataclasses import field
from typing import Any

from sympy.polys.rings import PolyElement

from restitution.explaining.lines.algebra import World
from restitution.explaining.lines.generators import Key, Value
from restitution.explaining.lines.quotients import (
    CONSTANT,
    NotComparableError,
    Plane,
    Quotient,
    lean,
    one,
    product,
    total,
)
from restitution.expression.tree import Expression, Quantity
from restitution.records import dataclass


@dataclass
class Rules:
    """Values for generators: what is cited with a letter or a quantity on its left side."""

    world: World
    substitutions: list[tuple[int, int, Quotient]] = field(default_factory=list)
    apart: frozenset[str] = frozenset()
    """Letters of components: the difference of two of them, as it is cited, tells one of them."""
    factors: frozenset[str] = frozenset()
    """Letters of components: a product of sums of them, as it is cited, tells one of them."""

    def add(self, left: Expression, right: Expression, sense: int = 1) -> None:
        """Takes up ``left = right`` (times the sense) where the left side is a subject."""
        try:
            own, value = self.world.value(left), self.world.value(right)
        except NotComparableError:
            return
        if isinstance(own, Plane):
            if isinstance(value, Quotient) and value.vanishes:
                value = Plane(value, value)
            if isinstance(value, Plane):
                self._add(own.x, value.x)
                self._add(own.y, value.y)
        elif isinstance(value, Quotient):
            self._add(own, value * CONSTANT(sense))

    def assemble(
        self,
        vector: Expression,
        axis: Expression,
        along: tuple[Expression, int],
        across: tuple[Expression, int],
    ) -> None:
        """Takes up a vector by its components, each with its sense, in directions in letters."""
        try:
            own, unit = self.world.value(vector), self.world.unit(axis)
            parts = [self.world.scalar(tree) * CONSTANT(sense) for tree, sense in (along, across)]
        except NotComparableError:
            return
        if not isinstance(own, Plane) or all(map(self._of_a_vector, (unit.x, unit.y))):
            return  # where the directions are numbers each component is a rule by itself
        a, b = parts
        self._add(own.x, self.world.reduced(a * unit.x - b * unit.y))
        self._add(own.y, self.world.reduced(a * unit.y + b * unit.x))

    def _add(self, own: Quotient, value: Quotient) -> None:
        plane, later = self._of_a_vector(own), self._later_time(own)
        own, value = self.put_into(own), self.put_into(value)  # type: ignore[assignment]
        pivot = later if later is not None and _uses(own, later[0]) else self._pivot(own, plane)
        if pivot is None:
            return
        number, power = pivot
        # own = c g^p + rest over below; so g^p = (value − rest/below) below/c
        lead = {m: v for m, v in own.above.items() if m[number]}
        rest = {m: v for m, v in own.above.items() if not m[number]}
        ring = own.above.ring
        factor = ring.from_dict({_without_power(m, number): v for m, v in lead.items()})
        other = Quotient(ring.from_dict(rest), own.below)
        result = (value - other) * Quotient(own.below, factor)
        if _uses(result, number):
            return
        self.substitutions = [
            (n, p, self._once(quotient, number, power, result))
            for n, p, quotient in self.substitutions
        ]
        self.substitutions.append((number, power, self.world.reduced(result)))

    def _of_a_vector(self, own: Quotient) -> bool:
        """Whether it is made of the components of vectors alone, with numbers and roots."""
        keys = self.world.keys(own.above).values()
        below = self.world.keys(own.below).values()
        return all(k[0] in ("x", "y", "root") for k in keys) and all(k[0] == "root" for k in below)

    def _later_time(self, own: Quotient) -> tuple[int, int] | None:
        """The later one of two times of which a difference is told, where it is known by that.

        The earlier one may be known already.
        """
        keys = self.world.keys(own.above)
        if not keys or len(own.above) == 1 or not all(map(_is_time, keys.values())):
            return None
        last = max(keys, key=lambda n: keys[n][1].stage)
        return (last, 1) if {m[last] for m in own.above if m[last]} == {1} else None

    def _pivot(self, own: Quotient, plane: bool) -> tuple[int, int] | None:
        keys = self.world.keys(own.above)
        powers = {
            n: {m[n] for m in own.above if m[n]} for n in keys if keys[n][0] not in ("root", "size")
        }
        single = len(own.above) == 1
        if len(keys) == 2 and all(k[0] == "letter" and k[1] in self.apart for k in keys.values()):
            return (
                (max(keys), 1) if all(exponents == {1} for exponents in powers.values()) else None
            )
        within = [n for n, key in keys.items() if key[0] == "letter" and key[1] in self.factors]
        if within and not single:
            last = max(within)
            return (last, 1) if powers[last] == {1} else None
        for n, key in keys.items():
            if n not in powers or len(powers[n]) != 1:
                continue
            (power,) = powers[n]
            roots = ("root",) if plane else ()
            others = [k for k in keys.values() if k != key and k[0] not in roots]
            if single and (not others or key[0] == "sin"):
                return n, power
            if single and key[0] == "cos" and all(k[0] == "letter" for k in others):
                return n, power
            if not single and plane and key[0] in ("x", "y") and power == 1:
                return n, power
        return None

    def complete(self) -> None:
        """Where the sine of an angle is a multiple of its cosine, put in its cosine too.

        It is for identities: from sin²+ cos² = 1, the square of the cosine is 1/(1 + tan²).
        """
        for number, power, result in list(self.substitutions):
            key = self.world.keys_by_number().get(number)
            if key is None or key[0] != "sin" or power != 1:
                continue
            cosine = self.world.generator(("cos", key[1]))
            (own,) = (n for m in cosine.above for n, p in enumerate(m) if p)
            tangent = result / cosine
            if not _uses(tangent, own):
                square = CONSTANT(1) / (CONSTANT(1) + tangent * tangent)
                self.substitutions.append((own, 2, square))

    def put_into(self, value: Value) -> Value:
        """A value with what is cited put in."""
        if isinstance(value, Plane):
            return Plane(self._into(value.x), self._into(value.y))
        return self._into(value)

    def _into(self, value: Quotient) -> Quotient:
        present = self.world.keys(value.above, value.below)
        for number, power, result in self.substitutions:
            if number in present or self.world.stands_below_roots(number):
                value = self._once(value, number, power, result)
                present = self.world.keys(value.above, value.below)
        return self.world.reduced(value)

    def _once(self, value: Quotient, number: int, power: int, result: Quotient) -> Quotient:
        value = self._into_roots(value, number, power, result)
        if not _uses(value, number):
            return value
        above = _substituted(value.above, number, power, result)
        below = _substituted(value.below, number, power, result)
        if below.vanishes:
            raise NotComparableError("a line divides by zero")
        if self.world.printed:
            self.world.denominators.append(below.above)
        return self.world.reduced(above / below)

    def _into_roots(self, value: Quotient, number: int, power: int, result: Quotient) -> Quotient:
        """The value with the generator put in below its roots."""
        if not self.world.stands_below_roots(number):
            return value
        for root, key in self.world.keys(value.above, value.below).items():
            if key[0] not in ("root", "size") or not any(m[number] for m in key[1]):
                continue
            inside = _substituted(key[1], number, power, result)
            new = self.world.root(inside if key[0] == "root" else inside * inside)
            above, below = (_substituted(x, root, 1, new) for x in (value.above, value.below))
            if below.vanishes:
                raise NotComparableError("a line divides by zero")
            value = self.world.reduced(above / below)
        return value


def _is_time(key: Key) -> bool:
    """Whether a generator is the time of an event."""
    match key:
        case ("quantity", Quantity("time", (), int())):
            return True
    return False


def _uses(value: Quotient, number: int) -> bool:
    return any(m[number] for m in value.above) or any(m[number] for m in value.below)


def _without_power(monomial: tuple[int, ...], number: int) -> tuple[int, ...]:
    return (*monomial[:number], 0, *monomial[number + 1 :])


def _substituted(polynomial: PolyElement, number: int, power: int, result: Quotient) -> Quotient:
    """A polynomial with g^power put in, as often as it goes."""
    by_times: dict[int, dict[tuple[int, ...], Any]] = {}
    for monomial, coefficient in polynomial.items():
        times, left = divmod(monomial[number], power)
        rest = (*monomial[:number], left, *monomial[number + 1 :])
        by_times.setdefault(times, {})[rest] = coefficient  # no two are alike
    most = max(by_times, default=0)
    above = polynomial.ring.zero
    for times, terms in by_times.items():
        term = product(polynomial.new(terms), _power(result.above, times))
        above = total(above, product(term, _power(result.below, most - times)))
    return lean(above, _power(result.below, most))


def _power(polynomial: PolyElement, times: int) -> PolyElement:
    """A power, of which SymPy knows none of zero to the power of zero."""
    if times == 1:
        return polynomial
    return polynomial**times if times else one()
