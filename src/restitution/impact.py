"""The short form: one impact of two known bodies, and everything that follows from it.

>>> from restitution import Sphere, impact
>>> A = Sphere("A", mass=2, velocity="3i - 4j")
>>> B = Sphere("B", mass=3, velocity="2i + 3j")
>>> hit = impact(A, B, line_of_centres="j", e="3/7")
>>> hit.after.A.velocity
Vector(x=3, y=2)
>>> hit.impulse, hit.kinetic_energy_lost
(12, 24)

Any kind of number will do. Texts, whole numbers, fractions and SymPy's own expressions give
exact answers; a float or an array anywhere makes all the numbers floats, and arrays stand for
many impacts at once. SymPy is loaded only where there is something exact.
"""

from __future__ import annotations

import math
import numbers
from collections.abc import Callable, Iterable, Iterator
from dataclasses import field, replace
from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, NoReturn

from restitution import law, measure
from restitution.errors import ImpossibleError, MissingError, StatementError, UnsupportedError
from restitution.expression.tree import Expression, Letter, Name, letters
from restitution.problem import Sphere, Wall
from restitution.records import dataclass
from restitution.vector import Vector

Body = Sphere | Wall


def impact(
    first: Sphere, second: Sphere | Wall, *, line_of_centres: Any = None, e: Any = None
) -> Hit:
    """What happens when a sphere hits another sphere, or a wall.

    ``line_of_centres`` is a vector of any length, or an angle (text with its unit, ``"60°"``, or
    radians), in either sense: ``"j"``, ``"3i + 4j"``, ``(3, 4)``. A straight wall has its own, the
    normal. ``e`` is the coefficient of restitution; left out, it is the letter e. All quantities
    are in SI units, angles in radians. As velocities and ``line_of_centres`` an array of shape
    (…, 2), or a pair of arrays, stands for many impacts at once.

    Raises:
        StatementError: a text cannot be read, or something is not a number or a vector.
        MissingError: the answer depends on a mass, a velocity or a line of centres not given.
        ImpossibleError: e is not in [0, 1], a mass is not positive, or the bodies do not approach
            each other. Arrays are not asked.
        UnsupportedError: letters and arrays together.
    """
    _check_bodies(first, second)
    read = _Reader(first, second, line_of_centres, e)
    u1, m1 = read.velocity(first), read.mass(first)
    if isinstance(second, Wall):
        u2, w2, m2 = Vector(0, 0), 0, None
    else:
        u2, m2 = read.velocity(second), read.mass(second)
        for body, mass in ((first, m1), (second, m2)):
            if mass is None:
                raise MissingError(f"the velocities after need the mass of {body.name}")
        w2 = 1 / m2
    # A wall may be hit by a sphere of unknown mass: its velocity after does not depend on it.
    w1 = 1 if m1 is None else 1 / m1
    c, e = read.line_of_centres(), read.e()
    c = _towards_second((u1 - u2).dot(c), c, first, second)
    v1, v2 = (_tidied_vector(v) for v in law.impact(u1, u2, w1, w2, c, e))
    before = Bodies(
        replace(first, mass=m1, velocity=u1),
        second if isinstance(second, Wall) else replace(second, mass=m2, velocity=u2),
    )
    after = Bodies(
        replace(before.first, velocity=v1, position=None),
        second if isinstance(second, Wall) else replace(before.second, velocity=v2, position=None),
    )
    return Hit(before, after, e, c)


@dataclass(frozen=True)
class Bodies:
    """The two bodies at one moment: by name (``after.A``, ``after["A"]``), or one by one."""

    first: Sphere
    second: Any

    def __getitem__(self, name: str) -> Any:
        for body in self:
            if body.name == name:
                return body
        known = " and ".join(body.name for body in self)
        raise KeyError(f"no body {name!r} here, only {known}")

    def __getattr__(self, name: str) -> Any:
        for body in vars(self).values():
            if body.name == name:
                return body
        raise AttributeError(f"no body {name!r} in this impact")

    def __iter__(self) -> Iterator[Any]:
        return iter((self.first, self.second))

    def __dir__(self) -> list[str]:
        return [body.name for body in self]


@dataclass(frozen=True, repr=False)
class Hit:
    """An impact that has been worked out.

    ``before`` and ``after`` hold the bodies just before and just after it, by name:
    ``hit.after.A.velocity``; each is a ``Sphere`` that can go into the next impact.
    """

    before: Bodies
    after: Bodies
    e: Any
    # from the first body to the second, of any length, so that no root is taken without need
    _centres: Vector = field(repr=False)

    @property
    def line_of_centres(self) -> Vector:
        """The unit vector from the first body to the second; for a wall, into the wall."""
        return _tidied_vector(measure.unit(self._centres))

    @property
    def impulse(self) -> Any:
        """The magnitude of the impulse, in N s. Raises MissingError without the masses."""
        c = self._centres
        along = self._law(law.impulse, "the impulse").dot(c)
        return _tidied(_size(along) / measure.speed(c))

    def impulse_on(self, body: str | Body) -> Vector:
        """The impulse on one of the bodies: a vector, in N s. Raises MissingError as above."""
        on_second = self._law(law.impulse, "the impulse")
        return _tidied_vector(
            -on_second if self._name(body) == self.before.first.name else on_second
        )

    @property
    def kinetic_energy_lost(self) -> Any:
        """The kinetic energy that both bodies together lose, in J. Raises MissingError as above."""
        return _tidied(self._law(law.kinetic_energy_lost, "the kinetic energy lost"))

    def speed(self, body: str | Body, when: Literal["before", "after"] = "after") -> Any:
        """The speed of a body just after the impact, or just before it, in m/s."""
        return _tidied(measure.speed(self._velocity(body, when)))

    def direction(self, body: str | Body, when: Literal["before", "after"] = "after") -> Any:
        """The direction of a body's velocity, anticlockwise from **i**, in (−π, π], in radians.

        Raises ImpossibleError for a body at rest.
        """
        velocity = self._velocity(body, when)
        self._check_moving(body, when, velocity)
        return _tidied_angle(measure.direction(_tidied_vector(velocity)))

    def deflection(self, body: str | Body) -> Any:
        """The angle between a body's directions before and after, from 0 to π, in radians.

        Raises ImpossibleError for a body that is at rest before or after: it has no direction.
        """
        before, after = self._velocity(body, "before"), self._velocity(body, "after")
        self._check_moving(body, "before", before)
        self._check_moving(body, "after", after)
        return _angle(before, after)

    def _law(self, function: Callable[..., Any], what: str) -> Any:
        first, second = self.before
        fixed = isinstance(second, Wall)
        if first.mass is None:
            raise MissingError(f"{what} needs the mass of {first.name}")
        u2, w2 = (Vector(0, 0), 0) if fixed else (second.velocity, 1 / second.mass)
        return function(first.velocity, u2, 1 / first.mass, w2, self._centres, self.e)

    def _name(self, body: str | Body) -> str:
        name = body if isinstance(body, str) else body.name
        if name not in (value.name for value in self.before):
            known = " and ".join(value.name for value in self.before)
            raise StatementError(f"{name} takes no part in this impact of {known}")
        return name

    def _velocity(self, body: str | Body, when: str) -> Vector:
        if when not in ("before", "after"):
            raise StatementError(f"the time is 'before' or 'after' the impact, not {when!r}")
        body_then = (self.before if when == "before" else self.after)[self._name(body)]
        return Vector(0, 0) if isinstance(body_then, Wall) else body_then.velocity

    def _check_moving(self, body: str | Body, when: str, velocity: Vector) -> None:
        if all(_is_zero(component) for component in velocity):
            name = self._name(body)
            raise ImpossibleError(f"{name} is at rest {when} the impact: it has no direction then")

    def __repr__(self) -> str:
        names = " and ".join(body.name for body in self.before)
        lines = [f"Impact of {names}, e = {_shown(self.e)}"]
        for body in self.before:
            if isinstance(body, Wall):
                continue
            velocities = [_shown_vector(pair[body.name].velocity) for pair in self._moments()]
            speeds = [_shown(self.speed(body, "before")), _shown(self.speed(body))]
            lines.append(f"  {body.name}  velocity {velocities[0]} → {velocities[1]}")
            lines.append(f"     speed {speeds[0]} → {speeds[1]}")
            try:
                lines.append(f"     angle of deflection {_shown_angle(self.deflection(body))}")
            except ImpossibleError as error:
                lines.append(f"     angle of deflection: {error.message}")
        lines.append(f"  line of centres along {_shown_vector(self._centres)}")
        try:
            lines.append(f"  impulse {_shown(self.impulse)}")
            lines.append(f"  kinetic energy lost {_shown(self.kinetic_energy_lost)}")
        except MissingError as error:
            lines.append(f"  {error.message}")
        return "\n".join(lines)

    def _moments(self) -> tuple[Bodies, Bodies]:
        return self.before, self.after


# --- reading what was given --------------------------------------------------------------------


class _Reader:
    """The data of one impact, each read once and all turned into one kind of number."""

    def __init__(self, first: Sphere, second: Body, line_of_centres: Any, e: Any) -> None:
        self._first, self._second = first, second
        self._raw: dict[str, Any] = {}
        for body in (first, second):
            if isinstance(body, Sphere):
                self._raw[f"the mass of {body.name}"] = body.mass
                self._raw[f"the velocity of {body.name}"] = body.velocity
            elif line_of_centres is None or body.along is not None:
                self._raw[f"the direction of {body.name}"] = body.along
                self._raw[f"the start of {body.name}"] = body.start
                self._raw[f"the end of {body.name}"] = body.end
        self._raw["the line of centres"] = line_of_centres
        self._raw["e"] = e
        names = {first.name: "sphere", second.name: _kind(second)}
        trees = {what: _tree(value, what, names) for what, value in self._raw.items()}
        self._symbols = _symbols(trees)
        # The direction of the wall comes before velocities, which may be told by it.
        order = sorted(trees, key=lambda what: not what.endswith(f" of {second.name}"))
        values: dict[str, Any] = {}
        for what in order:
            values[what] = self._value(trees[what], what, values)
        self._values = _one_kind(values)
        if self._values["e"] is None:
            if any(_is_inexact(leaf) for leaf in _leaves(self._values.values())):
                raise MissingError("the coefficient of restitution e was not given")
            self._values["e"] = self._symbol("e")

    def velocity(self, body: Sphere) -> Vector:
        value = self._values[f"the velocity of {body.name}"]
        if value is None:
            raise MissingError(f"the velocity of {body.name} before the impact was not given")
        return _vector(value, f"the velocity of {body.name}")

    def mass(self, body: Sphere) -> Any:
        what = f"the mass of {body.name}"
        mass = self._values[what]
        if mass is None:
            return None
        _check_scalar(mass, what)
        if _is_comparable(mass) and not _holds(mass > 0):
            raise ImpossibleError(f"{what} is {_shown(mass)}: a mass is positive")
        return mass

    def e(self) -> Any:
        e = self._values["e"]
        _check_scalar(e, "e")
        if _is_comparable(e) and not (_holds(e >= 0) and _holds(e <= 1)):
            raise ImpossibleError(f"e = {_shown(e)}: a coefficient of restitution lies in [0, 1]")
        return e

    def line_of_centres(self) -> Vector:
        names = f"{self._first.name} and {self._second.name}"
        value = self._values["the line of centres"]
        if value is None and isinstance(self._second, Wall):
            value = _normal(self._values, self._second)
        if value is None:
            raise MissingError(
                f"the line of centres of {names} was not given: say line_of_centres=…"
            )
        line = _direction(value, "the line of centres")
        if all(_is_zero(component) for component in line):
            raise ImpossibleError("the line of centres is the zero vector, which has no direction")
        return line

    def _symbol(self, name: str) -> Any:
        import sympy

        return self._symbols.get(name) or sympy.Symbol(name, nonnegative=True)

    def _value(self, value: Any, what: str, known: dict[str, Any]) -> Any:
        """A tree's value in exact symbols; other values as they are, vectors as ``Vector``."""
        if isinstance(value, tuple) and len(value) == 2:
            # An array in it is a component for many impacts, even if it is of two.
            return Vector(
                *(
                    component if _is_array(component) else self._value(component, what, known)
                    for component in value
                )
            )
        if isinstance(value, Expression):
            from restitution.expression.evaluate import Angle, Evaluator, Symbolic

            def wall(tree: Expression) -> Vector:
                direction = None
                if isinstance(tree, Name) and tree.name == self._second.name:
                    direction = _along(known, self._second)
                if direction is None:
                    raise StatementError("this direction is not known here")
                return _direction(direction, f"the direction of {self._second.name}")

            evaluator = Evaluator(Symbolic(), self._symbol, name=wall, wall_direction=wall)
            try:
                read = evaluator.value(value)
            except StatementError as error:
                _blame(error, what)
            return read.measure() if isinstance(read, Angle) else read
        if isinstance(value, float) and not math.isfinite(value) and what != "e":
            raise StatementError(f"{what} is {value}: it must be a finite number")
        shape = getattr(value, "shape", ())
        if hasattr(value, "free_symbols"):  # SymPy: an expression, or a matrix of two
            return Vector(*value) if len(shape) == 2 and math.prod(shape) == 2 else value
        if _is_array(value) and shape and shape[-1] == 2 and not what.startswith(("the mass", "e")):
            return Vector(value[..., 0], value[..., 1])
        return value


def _kind(body: Body) -> str:
    return "wall" if isinstance(body, Wall) else "sphere"


def _tree(value: Any, what: str, names: dict[str, str]) -> Any:
    """Texts read into trees, also inside a pair."""
    if isinstance(value, str):
        from restitution.expression import read_expression

        try:
            return read_expression(value, names=names)
        except StatementError as error:
            _blame(error, f'{what}, "{value}"' if len(value) <= 60 else what)
    if isinstance(value, (tuple, list)):
        if len(value) != 2:
            raise StatementError(f"{what} has {len(value)} components where it needs two")
        return tuple(_tree(other, what, names) for other in value)
    return value


def _blame(error: StatementError, what: str) -> NoReturn:
    place = "" if error.column is None else f" (column {error.column})"
    raise StatementError(f"{what}{place}: {error.message}") from error


def _symbols(trees: dict[str, Any]) -> dict[str, Any]:
    """The letters of all the texts, with the signs that the language of statements gives them.

    A coefficient of restitution may be zero; a letter alone one of a velocity's components, and
    not in the other (``p i + 2j``), is any real number; all others are positive.
    """
    if not any(isinstance(leaf, Expression) and letters(leaf) for leaf in _leaves(trees.values())):
        return {}
    import sympy

    from restitution.expression.evaluate import evaluate

    def positive(name: str) -> Any:
        return sympy.Symbol(name, positive=True)

    coefficients = {trees["e"].name} if isinstance(trees["e"], Letter) else {"e"}
    signed: set[str] = set()
    unsigned: set[str] = set()
    for what, value in trees.items():
        vector: Any = None
        if what.startswith("the velocity"):
            try:
                vector = evaluate(value, positive) if isinstance(value, Expression) else value
                if isinstance(value, tuple):
                    vector = Vector(
                        *(evaluate(p, positive) if isinstance(p, Expression) else p for p in value)
                    )
            except StatementError:  # told by a wall, perhaps: then by its size
                vector = None
        if isinstance(vector, Vector):
            for one, other in (tuple(vector), tuple(vector)[::-1]):
                lone = _lone_letter(one)
                if lone is not None and other != 0 and lone not in _free_symbols(other):
                    signed.add(lone.name)
                else:
                    unsigned.update(symbol.name for symbol in _free_symbols(one))
        else:
            for tree in _leaves([value]):
                unsigned.update(letters(tree) if isinstance(tree, Expression) else ())
    symbols = {}
    for name in signed | unsigned:
        if name in coefficients:
            symbols[name] = sympy.Symbol(name, nonnegative=True)
        elif name in unsigned:
            symbols[name] = positive(name)
        else:
            symbols[name] = sympy.Symbol(name, real=True)
    return symbols


def _free_symbols(value: Any) -> Any:
    return getattr(value, "free_symbols", frozenset())


def _lone_letter(component: Any) -> Any:
    if not hasattr(component, "free_symbols"):
        return None
    _, rest = component.as_coeff_Mul()
    return rest if rest.is_Symbol else None


# --- one kind of number ------------------------------------------------------------------------


def _leaves(values: Iterable[Any]) -> Iterator[Any]:
    for value in values:
        if isinstance(value, tuple):
            yield from _leaves(value)
        else:
            yield value


def _is_array(value: Any) -> bool:
    return hasattr(value, "__array_namespace__") and not isinstance(value, numbers.Number)


def _is_inexact(value: Any) -> bool:
    return _is_array(value) or (
        isinstance(value, numbers.Real)
        and not isinstance(value, numbers.Rational)
        and not hasattr(value, "free_symbols")
    )


def _one_kind(values: dict[str, Any]) -> dict[str, Any]:
    """All numbers exact, or, if any is a float or an array, all of them floats."""
    leaves = [leaf for leaf in _leaves(values.values()) if leaf is not None]
    symbols = any(_free_symbols(leaf) for leaf in leaves)
    if symbols and any(_is_array(leaf) for leaf in leaves):
        raise UnsupportedError("letters and arrays cannot be mixed in one impact")
    inexact = any(_is_inexact(leaf) for leaf in leaves)
    convert = _as_float if inexact and not symbols else _as_exact

    def converted(value: Any, what: str) -> Any:
        if isinstance(value, tuple):
            return Vector(*(converted(part, what) for part in value))
        if value is None or _is_inexact(value):
            return value
        return convert(value, what)

    return {what: converted(value, what) for what, value in values.items()}


def _as_float(value: Any, what: str) -> float:
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise _refusal(value, what) from None


def _as_exact(value: Any, what: str) -> Any:
    if getattr(value, "is_real", False) is not False:  # SymPy; None where its letters are unknown
        return value
    if isinstance(value, Decimal) and value.is_finite():
        value = Fraction(value)
    if isinstance(value, numbers.Rational):
        import sympy

        return sympy.Rational(int(value.numerator), int(value.denominator))
    raise _refusal(value, what)


def _refusal(value: Any, what: str) -> StatementError:
    return StatementError(f"{what} is not a number or a vector: {value!r}")


def _vector(value: Any, what: str) -> Vector:
    if isinstance(value, Vector):
        return value
    if not _is_array(value) and _is_zero(value):
        return Vector(value, value)
    raise StatementError(f"{what} is a number, {value}, where a vector is needed")


def _direction(value: Any, what: str) -> Vector:
    """A vector, or an angle in radians from **i**, as a vector."""
    return value if isinstance(value, Vector) else measure.at_angle(value)


def _along(values: dict[str, Any], wall: Body) -> Any:
    """The direction of a straight wall, or None."""
    start = values.get(f"the start of {wall.name}")
    end = values.get(f"the end of {wall.name}")
    if isinstance(start, Vector) and isinstance(end, Vector):
        return end - start
    return values.get(f"the direction of {wall.name}")


def _normal(values: dict[str, Any], wall: Wall) -> Vector:
    along = _along(values, wall)
    if along is None:
        raise MissingError(
            f"the direction of the wall {wall.name} at the impact was not given: "
            "say Wall(…, along=…) or line_of_centres=…"
        )
    return _direction(along, f"the direction of {wall.name}").turned_left()


# --- checks ------------------------------------------------------------------------------------


def _check_bodies(first: Any, second: Any) -> None:
    if not isinstance(first, Sphere):
        raise StatementError(f"the first body of an impact is a Sphere, not {first!r}")
    if not isinstance(second, (Sphere, Wall)):
        raise StatementError(f"the second body of an impact is a Sphere or a Wall, not {second!r}")
    if first.name == second.name:
        raise StatementError(f"both bodies of the impact are named {first.name}")


def _check_scalar(value: Any, what: str) -> None:
    if isinstance(value, Vector):
        raise StatementError(f"{what} is a vector, {_shown_vector(value)}, not a number")


def _is_comparable(value: Any) -> bool:
    """Whether a value is one known number, exact or float."""
    if hasattr(value, "free_symbols"):
        return not value.free_symbols
    return not _is_array(value)


def _holds(relation: Any) -> bool:
    return bool(relation == True)  # noqa: E712 - SymPy's truth is not Python's


def _is_zero(value: Any) -> bool:
    """Whether a value is zero, identically if it has letters; never so for arrays."""
    if _is_array(value):
        return False
    if hasattr(value, "free_symbols"):
        from restitution.exact import is_zero

        return is_zero(value)
    return bool(value == 0)


def _towards_second(approach: Any, c: Vector, first: Body, second: Body) -> Vector:
    """The line of centres from the first body to the second: they approach along it."""
    if _is_array(approach):
        sense = 1 - 2 * (approach < 0)
        return Vector(c.x * sense, c.y * sense)
    if _is_zero(approach):  # in either sense of c the bodies approach, but not if it is zero
        raise ImpossibleError(
            f"{first.name} and {second.name} do not approach each other along the line of "
            "centres: they have the same velocity along it"
        )
    return -c if _sign(approach) == -1 else c


# --- results -------------------------------------------------------------------------------------


def _tidied(value: Any) -> Any:
    """An exact value in its simplest usual form; others as they are."""
    if not hasattr(value, "free_symbols"):
        return value
    from restitution.exact import tidy

    return tidy(value)


def _tidied_vector(vector: Vector) -> Vector:
    return Vector(_tidied(vector.x), _tidied(vector.y))


def _tidied_angle(value: Any) -> Any:
    if not hasattr(value, "free_symbols"):
        return value
    from restitution.exact import tidy_angle

    return tidy_angle(value)


def _sign(value: Any) -> int | None:
    """1 or -1, or None where the letters leave it open. A positive letter as an angle is acute."""
    if not hasattr(value, "free_symbols"):
        return None if value == 0 else 1 if value > 0 else -1
    import sympy

    acute = {
        ratio: sympy.Dummy(positive=True)
        for ratio in value.atoms(sympy.sin, sympy.cos, sympy.tan)
        if ratio.args[0].is_Symbol and ratio.args[0].is_positive
    }
    known = sympy.factor_terms(_tidied(value).xreplace(acute))
    return 1 if known.is_positive else -1 if known.is_negative else None


def _size(value: Any) -> Any:
    """The absolute value, without its bars where the sign is known."""
    if not hasattr(value, "free_symbols"):
        return abs(value)
    return {1: value, -1: -value, None: abs(value)}[_sign(value)]


def _angle(first: Vector, second: Vector) -> Any:
    """The angle between two vectors, from 0 to π; exact ones without common factors."""
    cross, dot = (_tidied(value) for value in (first.cross(second), first.dot(second)))
    if not any(hasattr(value, "free_symbols") for value in (cross, dot)):
        return measure.angle_between(first, second)
    import sympy

    cross = _size(sympy.sympify(cross, strict=True))
    if dot == 0 or _is_zero(cross):
        return _tidied_angle(sympy.atan2(cross, dot))
    above, below = sympy.fraction(_tidied(cross / dot))
    if _sign(dot / below) != 1:
        above, below = cross, dot
    return _tidied_angle(sympy.atan2(above, below))


# --- showing -------------------------------------------------------------------------------------


def _text(value: Any) -> str:
    return str(value).replace("**", "^")


def _shown(value: Any) -> str:
    """A number as text; an exact one also to 3 significant figures."""
    if _is_array(value):
        low, high = (f"{float(end) + 0.0:.6g}" for end in (value.min(), value.max()))
        return f"[{value.size} values from {low} to {high}]" if value.size else "[no values]"
    if hasattr(value, "free_symbols") and not (value.free_symbols or value.is_Rational):
        from restitution.exact import significant

        return f"{_text(value)} = {significant(value)}"
    return f"{value:.6g}" if isinstance(value, float) else _text(value)


def _shown_angle(value: Any) -> str:
    if _is_array(value) or _free_symbols(value):
        return _shown(value)
    if not hasattr(value, "free_symbols"):
        return f"{math.degrees(value):.6g}°"
    import sympy

    from restitution.exact import significant

    return f"{_text(value)} = {significant(value * 180 / sympy.pi)}°"


def _shown_vector(vector: Vector) -> str:
    if any(_is_array(component) for component in vector):
        return "(" + ", ".join(_shown(component) for component in vector) + ")"
    terms = []
    for component, axis in zip(vector, "ij", strict=True):
        if _is_zero(component):
            continue
        if getattr(component, "is_Add", False):
            terms.append(f"({_text(component)}) {axis}")
            continue
        text = f"{component:.6g}" if isinstance(component, float) else _text(component)
        space = "" if text.lstrip("-").isdigit() else " "
        terms.append({"1": axis, "-1": f"-{axis}"}.get(text, f"{text}{space}{axis}"))
    return " + ".join(terms).replace("+ -", "- ") or "0"
