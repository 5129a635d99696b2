"""Grounds of a line that a reader has to be shown: a quadrant, a root, a divisor, an identity."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from fractions import Fraction
from typing import TypeGuard

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import (
    Derivation,
    Fact,
    Line,
    Link,
    Ref,
    Relation,
    equality,
    turned,
)
from restitution.explaining.lines.trees import trees_of
from restitution.expression.evaluate import evaluate, in_letters
from restitution.expression.quantities import UNSIGNED_ANGLES
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    Unit,
    has_operator,
    has_quantity,
    has_root,
    is_binary,
    is_function,
    is_quantity,
    is_zero,
    letters,
    unsigned,
    walk,
)
from restitution.oracle.roles import Role
from restitution.planning.writing.forms import coordinates, factors, tree_of
from restitution.workings.naming.angles_by_signs import signs_behind

_ZERO, _ONE, _TWO = (Number(Fraction(n)) for n in (0, 1, 2))
_ORDER = ("<", "<=", ">", ">=")
_ABOVE = (">", ">=")


def grounds_of(derivation: Derivation, roles: Mapping[str, Role], line: Line) -> Iterator[Relation]:
    """What a line rests on beside what it cites, as relations to stand behind it."""
    match line.move.id:
        case "inverse":
            seen = list(_quadrant(derivation, line))
            yield from seen or _obtuse(derivation, line)
            if any(_is_of_a_cotangent(_relation(derivation, ref)) for ref in line.premises):
                yield from _half_plane(derivation, line)
        case "complete":
            yield from _roots(derivation, line)
        case "rearrange":
            yield from _divisors(roles, line)
            yield from _divided_by(derivation, roles, line)
            yield from _squares_of_sums(derivation, line)
        case "define":
            yield from _side(derivation, line)
        case "compare":
            yield from _double_angle(derivation, line)
            if not signs_behind(derivation, line):  # the words before it say them
                yield from _half_plane(derivation, line)


def _side(derivation: Derivation, line: Line) -> Iterator[Relation]:
    """To which side a velocity is turned, where that is given."""
    for ref in line.premises if line.move.record == "turned" else ():
        fact = derivation.fact(ref)
        match None if fact is None else fact.relation.options:
            case ((Link(Quantity("direction") as angle, "<" | ">" as sign, right),),) if (
                in_letters(right) == 0
            ):
                yield Relation(((Link(angle, sign, _ZERO),),))


def _squares_of_sums(derivation: Derivation, line: Line) -> Iterator[Relation]:
    """``(√33 − 3)² = 42 − 6√33``, where a number under a root is seen to be a square."""
    seen: list[Expression] = []
    squares = [
        node
        for tree in trees_of(line.relation)
        if has_root(tree)
        for node in walk(tree)
        if is_binary(node, "^") and node.right == _TWO
    ]
    if squares:
        cited = [own for ref in line.premises if (own := _relation(derivation, ref)) is not None]
        above = {node for relation in cited for tree in trees_of(relation) for node in walk(tree)}
        for square in squares:
            if square not in above:
                seen += [node for node in walk(square.left) if _is_sum_with_a_root(node)]
    for tree in dict.fromkeys(seen):
        worth = tree_of(sp.expand(in_letters(tree) ** 2))
        yield equality(Binary("^", tree, _TWO), worth)


def _is_sum_with_a_root(tree: Expression) -> bool:
    """Whether an expression is a number with a root, added to another one."""
    roots = (is_function(node, "sqrt") for node in walk(tree))
    is_sum = is_binary(tree, "+", "-")
    return is_sum and not letters(tree) and not has_quantity(tree) and any(roots)


def compared_quantities(derivation: Derivation, line: Line) -> Fact | None:
    """The given inequality of two quantities that a line compares by what lines above say."""
    cited = [own for own in derivation.lines_in(line.premises) if own.shown != "silent"]
    if line.move.id != "compare" or len(cited) < 2:
        return None
    for ref in line.premises:
        fact = derivation.fact(ref)
        if fact is not None and fact.kind == "given" and len(fact.relation.options) == 1:
            return fact if all(map(has_quantity, trees_of(fact.relation))) else None
    return None


def motion_of(fact: Fact | None) -> tuple[str, Expression] | None:
    """Which body moves in which direction, where that is given and tells a component's sign."""
    if fact is None or fact.id.partition(" ")[0] != "sense":
        return None
    match fact.relation.only:
        case (Link(Quantity("along" | "dot", (Quantity("velocity", (Name(body),)), axis)), sign),):
            return body, axis if sign == ">" else Negate(axis)
    return None


def acute_by_its_tangent(
    line: Line, extent: Relation, cited: Iterable[Relation | None]
) -> Letter | None:
    """The angle of up to 180° that a positive tangent makes acute, where that is compared.

    It is by any of its ratios, or itself.
    """
    match extent.options:
        case ((_, Link(Letter() as angle, "<=", Degrees(Fraction(numerator=180)))),):
            tangent = Apply("tan", angle)
        case _:
            return None
    if line.move.id != "compare" or not isinstance(line.relation, Relation):
        return None
    below = Relation(((Link(tangent, ">", _ZERO),),))
    match line.relation.options:
        case ((Link(Apply("sin" | "cos" | "tan", own)),),) if own == angle:
            return angle if below in cited else None
        case ((*_, Link(own, "<" | "<=", bound)),) if own == angle or is_quantity(
            own, *UNSIGNED_ANGLES
        ):
            if not _is_less_than_90(bound):
                return None
            acute = {ref.partition(":")[2].strip() for ref in line.premises if _is_acute(ref)}
            return (
                angle
                if any(_is_above_zero(tangent, relation, acute) for relation in cited)
                else None
            )
    return None


def _is_acute(ref: object) -> TypeGuard[str]:
    """Whether a premise says that an angle is acute."""
    return isinstance(ref, str) and ref.partition(":")[0] == "acute"


def angle_acute_by(derivation: Derivation, line: Line) -> Letter | None:
    """The angle that a printed line makes acute by its tangent, where one below needs that."""
    match line.relation:
        case Relation(((Link(Apply("tan", Letter() as angle), ">", right),),)) if right == _ZERO:
            pass
        case _:
            return None
    if line.shown != "line":
        return None
    text = f"0° <= {angle.name} <= 180°"
    low, high = (Degrees(Fraction(n)) for n in (0, 180))
    extent = Relation(((Link(low, "<=", angle), Link(angle, "<=", high)),))
    for other in derivation.lines:
        if line.number in other.premises and text in other.premises:
            cited = (_relation(derivation, ref) for ref in other.premises)
            if acute_by_its_tangent(other, extent, cited) == angle:
                return angle
    return None


def _is_less_than_90(bound: Expression) -> bool:
    match bound:
        case Apply("arctan" | "arcsin"):
            return True
        case Apply("arccos", ratio):
            return bool(in_letters(ratio).is_positive)
        case Degrees(value):
            return value < 90
        case Binary("-", Degrees(Fraction(numerator=90, denominator=1)), Letter()):
            return True
    return False


def _is_above_zero(tangent: Expression, relation: Relation | None, acute: Collection[str]) -> bool:
    """Whether a relation bounds a tangent below by zero, or by what is above that.

    That is a number, or what is made of ratios of ``acute`` angles without a difference.
    """
    for link in () if relation is None or len(relation.options) > 1 else relation.only:
        own = turned(link) if link.right == tangent else link
        if own.left != tangent:
            continue
        if letters(own.right):
            if own.sign in _ABOVE and _is_positive(own.right, acute):
                return True
            continue
        value = in_letters(own.right)
        if (own.sign == ">" and value == 0) or (own.sign in _ABOVE and value.is_positive):
            return True
    return False


def _is_positive(tree: Expression, acute: Collection[str]) -> bool:
    """Whether an expression is made of positive numbers and of ratios of acute angles."""
    match tree:
        case Number(value):
            return value > 0
        case Apply("sin" | "cos" | "tan", Letter(name)):
            return name in acute
        case Binary("^", base, Number()):
            return _is_positive(base, acute)
        case Binary("*" | "/" | "+", left, right):
            return _is_positive(left, acute) and _is_positive(right, acute)
    return False


def _relation(derivation: Derivation, ref: Ref) -> Relation | None:
    own = derivation.line(ref)
    return own.relation if own is not None and isinstance(own.relation, Relation) else None


def _quadrant(derivation: Derivation, line: Line) -> Iterator[Relation]:
    """Which way a body moves along **i**, where its direction is not between 0° and 90°."""
    assert isinstance(line.relation, Relation)
    link = line.relation.only[0]
    named = meant_by(derivation, link.left)
    angle = line.relation.only[-1].right
    beyond = _is_beyond(angle)
    if not is_quantity(named, "direction"):
        return
    if not (beyond or _is_negative(angle)):
        return
    for ref in line.premises:
        relation = _relation(derivation, ref)
        if relation is None or len(relation.options) > 1:
            continue
        component, value = relation.only[0].left, relation.only[-1].right
        parts = coordinates(value) if is_quantity(component, "velocity") else None
        if parts is not None:
            component, value = Quantity("along", (component, Unit("i"))), parts[0]
        if _is_along_i(derivation, component) and _is_negative(value if beyond else Negate(value)):
            yield Relation(((Link(component, "<" if beyond else ">", _ZERO),),))
            return


def _obtuse(derivation: Derivation, line: Line) -> Iterator[Relation]:
    """That the tangent of an angle of up to 180° is negative, which makes it obtuse."""
    assert isinstance(line.relation, Relation)
    angle, value = line.relation.only[0].left, line.relation.only[-1].right
    named = meant_by(derivation, angle)
    if not is_quantity(named, *UNSIGNED_ANGLES):
        return
    match value:
        case Binary("-", Degrees(Fraction(numerator=180, denominator=1)), Apply("arctan")):
            pass
        case _:
            return
    tangent = Apply("tan", angle)
    for ref in line.premises:
        relation = _relation(derivation, ref)
        if relation is not None and len(relation.options) == 1:
            link = relation.only[0]
            if link.left == tangent and _is_negative(relation.only[-1].right):
                yield Relation(((Link(tangent, "<", _ZERO),),))


def _is_of_a_cotangent(relation: Relation | None) -> bool:
    """Whether a relation says what the cotangent of an angle is."""
    match relation:
        case Relation(((Link(Apply("cot"), "="), *_),)):
            return True
    return False


def _half_plane(derivation: Derivation, line: Line) -> Iterator[Relation]:
    """To which side a body moves whose direction is bounded by a ratio of it."""
    assert isinstance(line.relation, Relation)
    sides = {side for link in line.relation.options[0] for side in (link.left, link.right)}
    named = {
        meaning.quantity
        for side in sides
        if isinstance(side, Letter) and (meaning := derivation.meanings.get(side.name))
    }
    if not any(is_quantity(side, "direction") for side in sides | named):
        return
    for ref in line.premises:
        match _relation(derivation, ref):
            case Relation(((Link(component, "="), *_) as links,)):
                value = links[-1].right
            case _:
                continue
        if _is_negative(value):
            yield Relation(((Link(component, "<", _ZERO),),))
        elif _is_negative(Negate(value)):
            yield Relation(((Link(component, ">", _ZERO),),))


def meant_by(derivation: Derivation, angle: Expression) -> Expression | None:
    """What a letter stands for: one of the working, or one that the statement has."""
    if not isinstance(angle, Letter):
        return None
    meaning = derivation.meanings.get(angle.name)
    if meaning is not None:
        return meaning.quantity
    for fact in derivation.facts:
        match fact.relation.options:
            case ((Link(quantity, "=", own),),) if own == angle and _is_name(fact):
                return quantity
    return None


def _is_name(fact: Fact) -> bool:
    """Whether a fact says what a letter of the statement stands for."""
    return fact.id.partition(" ")[0] == "let"


def _is_beyond(angle: Expression) -> bool:
    """Whether an angle is more than 90°, on either side."""
    size = unsigned(angle)
    if isinstance(size, Degrees):
        return abs(size.value) > 90
    return any(isinstance(node, Degrees) and node.value == 180 for node in walk(angle))


def _is_along_i(derivation: Derivation, component: Expression) -> bool:
    """Whether a component, or the letter for one, is in the direction of **i**."""
    quantity = component
    if isinstance(component, Letter):
        meaning = derivation.meanings.get(component.name)
        if meaning is None or meaning.sense is not None:
            return False
        quantity = meaning.quantity
    match quantity:
        case Quantity("along", (Quantity("velocity"), Unit("i"))):
            return True
        case Quantity("along", (Quantity("velocity"), Quantity("line_of_centres", (), int(event)))):
            fact = derivation.fact(f"axis {event}")
            return fact is not None and fact.relation.only[0].right == Unit("i")
    return False


def _is_negative(value: Expression) -> bool:
    """Whether an expression is seen to be negative, its letters being positive."""
    if has_quantity(value):
        return False
    try:
        worth = evaluate(value, lambda name: sp.Symbol(name, positive=True))
        return bool(sp.sympify(worth, strict=True).is_negative)
    except (RestitutionError, TypeError, ValueError):
        return False


def _roots(derivation: Derivation, line: Line) -> Iterator[Relation]:
    """What is given of the letters below a root that would not be real otherwise."""
    assert isinstance(line.relation, Relation)
    part = derivation.asked.get(line.item or "")
    names = {
        frozenset(letters(node.argument))
        for link in line.relation.options[0]
        for node in walk(link.right)
        if is_function(node, "sqrt") and has_operator(node.argument, "-")
    }
    for link in given_links(derivation, part):
        if link.sign in _ORDER and letters(link.left) | letters(link.right) in names:
            yield Relation(((link,),))


def given_links(derivation: Derivation, part: str | None) -> Iterator[Link]:
    """The equations and inequalities that are given in a part, but for those in alternatives."""
    for fact in derivation.facts:
        if fact.kind in ("given", "range") and fact.part in (None, part):
            yield from fact.relation.only if len(fact.relation.options) == 1 else ()


def _divisors(roles: Mapping[str, Role], line: Line) -> Iterator[Relation]:
    """That a coefficient by which an inequality is divided is positive."""
    assert isinstance(line.relation, Relation)
    match line.relation.options:
        case ((Link(Letter(), sign, Binary("/", _, below)),),) if sign in _ORDER:
            for factor in factors(below):
                role = roles.get(factor.name) if isinstance(factor, Letter) else None
                if role is not None and role.kind == "restitution":
                    yield Relation(((Link(factor, ">", _ZERO),),))


def _divided_by(
    derivation: Derivation, roles: Mapping[str, Role], line: Line
) -> Iterator[Relation]:
    """That a coefficient by which an equation is divided is not zero, where nothing else says it.

    It stands in a product that is not zero: then it is not zero itself.
    """
    assert isinstance(line.relation, Relation)
    above = [own for ref in line.premises if (own := _relation(derivation, ref)) is not None]
    match line.relation.options, above:
        case ((Link(Letter(), "=", Binary("/", _, below)),),), [
            Relation(((Link(left, "=", value),),))
        ]:
            pass
        case _:
            return
    if letters(value) or has_quantity(value) or is_zero(value) or len(line.premises) != 1:
        return
    product = factors(left)
    for factor in factors(below):
        role = roles.get(factor.name) if isinstance(factor, Letter) else None
        if role is not None and role.kind == "restitution" and factor in product:
            yield Relation(((Link(factor, "!=", _ZERO),),))


def _double_angle(derivation: Derivation, line: Line) -> Iterator[Relation]:
    """By which formula a bound of cos 2α comes from one of sin α or cos α."""
    assert isinstance(line.relation, Relation)
    angle = next(
        (
            node
            for link in line.relation.options[0]
            for side in (link.left, link.right)
            for node in walk(side)
            if is_function(node, "cos")
        ),
        None,
    )
    match angle:
        case Apply("cos", Binary("*", two, half)) if two == _TWO:
            pass
        case _:
            return
    for ref in line.premises:
        relation = _relation(derivation, ref)
        subject = None if relation is None else relation.options[0][0].left
        if subject not in (Apply("sin", half), Apply("cos", half)):
            continue
        square = Binary("*", _TWO, Binary("^", subject, _TWO))
        sine = subject == Apply("sin", half)
        right = Binary("-", _ONE, square) if sine else Binary("-", square, _ONE)
        yield equality(angle, right)
        return
