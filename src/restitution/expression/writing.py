"""Expression trees back to text, with no more brackets than needed."""

from __future__ import annotations

import re
from fractions import Fraction

from restitution.expression.limits import MAX_DIGITS
from restitution.expression.tree import (
    Apply,
    AtTime,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Pi,
    Polar,
    Quantity,
    Unit,
    is_binary,
)
from restitution.expression.units import like_a_unit

# How tightly a text binds: what it may stand in without brackets.
_POLAR, _SUM, _PRODUCT, _POWER, _PRIMARY = range(5)

_SIGNS = {"mu": "μ", "nu": "ν", "xi": "ξ"}

# Where letters follow a value: what would be taken for a unit there (``2m/s``) is written as a
# product.
_AFTER_A_VALUE = re.compile(
    r"(?<=\d)\s*(?=[^\W\d_])|(?<=[\w°)])(?<!\bat)(?<!\bfrom)\s+(?=[^\W\d_])"
)


def write_expression(tree: Expression) -> str:
    """The text of an expression, which reads back as an equal tree.

    >>> from restitution.expression.tree import Binary, Letter, Number
    >>> write_expression(Binary("*", Binary("/", Number(1), Number(2)), Letter("u")))
    '1/2 u'
    """
    return _without_units(_write(tree)[0])


def write_sum(tree: Expression) -> str:
    """The text of an expression where ``at`` cannot stand without brackets."""
    return _without_units(_at_least(tree, _SUM))


def _without_units(text: str) -> str:
    return _AFTER_A_VALUE.sub(
        lambda gap: "*" if like_a_unit(text, gap.end()) else gap.group(), text
    )


def _at_least(tree: Expression, level: int) -> str:
    text, own = _write(tree)
    return text if own >= level else f"({text})"


def _write(tree: Expression) -> tuple[str, int]:
    match tree:
        case Number(value):
            return _number(value)
        case Degrees(value):
            text, level = _number(value)
            return f"{text}°", level
        case Pi():
            return "pi", _PRIMARY
        case Letter(name):
            head, line, subscript = name.partition("_")
            return _SIGNS.get(head, head) + line + subscript, _PRIMARY
        case Unit(axis):
            return axis, _PRIMARY
        case Name(name):
            return name, _PRIMARY
        case Pair(x, y):
            return f"({_write(x)[0]}, {_write(y)[0]})", _PRIMARY
        case Polar():
            return _polar(tree), _POLAR
        case Negate(operand):
            return f"-{_at_least(operand, _PRODUCT)}", _SUM
        case Binary("+" | "-", left, right):
            return f"{_at_least(left, _SUM)} {tree.op} {_at_least(right, _PRODUCT)}", _SUM
        case Binary("*", left, right):
            return _product(left, right), _PRODUCT
        case Binary("/", left, right):
            below = f"({_write(right)[0]})" if _in_degrees(right) else _at_least(right, _POWER)
            return f"{_at_least(left, _PRODUCT)}/{below}", _PRODUCT
        case Binary(_, Apply(function, argument), Number(value)) if (
            function not in ("sqrt", "abs") and value.denominator == 1
        ):
            return f"{function}^{value}({_write(argument)[0]})", _POWER
        case Binary(_, left, right):
            return f"{_at_least(left, _PRIMARY)}^{_at_least(right, _POWER)}", _POWER
        case Apply(function, argument):
            return f"{function}({_write(argument)[0]})", _PRIMARY
        case Quantity():
            return _quantity(tree), _PRIMARY


def _in_degrees(tree: Expression) -> bool:
    """Whether a factor begins with a degree sign's number: under a line it needs brackets."""
    return isinstance(tree, Degrees) or (is_binary(tree, "^") and isinstance(tree.left, Degrees))


def _number(value: Fraction | int) -> tuple[str, int]:
    text = _decimal(Fraction(value))
    if text is None or len(text) > MAX_DIGITS:
        return str(value), _PRODUCT
    return text, _PRIMARY


def _decimal(value: Fraction | int) -> str | None:
    """An exact decimal, or None where there is none."""
    value = Fraction(value)
    rest, places = value.denominator, 0
    for prime in (2, 5):
        count = 0
        while rest % prime == 0:
            rest //= prime
            count += 1
        places = max(places, count)
    if rest != 1:
        return None
    whole = value.numerator * 10**places // value.denominator
    digits = str(abs(whole)).rjust(places + 1, "0")
    sign = "-" if whole < 0 else ""
    return sign + (f"{digits[:-places]}.{digits[-places:]}" if places else digits)


def _product(left: Expression, right: Expression) -> str:
    before, after = _at_least(left, _PRODUCT), _at_least(right, _POWER)
    if after[0].isdigit():
        return f"{before}*{after}"
    close = isinstance(left, Number) and before[-1].isdigit()
    return before + ("" if close else " ") + after


def _polar(tree: Polar) -> str:
    text = f"{_at_least(tree.size, _SUM)} at {_at_least(tree.angle, _SUM)}"
    if tree.origin is not None:
        return f"{text} from {_at_least(tree.origin, _SUM)}"
    if tree.wall is not None:
        return f"{text} to {_at_least(tree.wall, _PRIMARY)}"
    return text


def _quantity(tree: Quantity) -> str:
    arguments = [_write(argument)[0] for argument in tree.arguments]
    if isinstance(tree.stage, AtTime):
        arguments.append(f"at {_at_least(tree.stage.time, _SUM)}")
    elif tree.stage is not None:
        arguments.append(str(tree.stage))
    return f"{tree.kind}({', '.join(arguments)})" if arguments else tree.kind
