"""What each kind of line says, by the rules of the grammar of lines."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

from lark import Token, Tree

from restitution.errors import StatementError
from restitution.expression.dimensions import NONE
from restitution.expression.quantities import dimension_of_any
from restitution.expression.reading import BUILDERS, Builder, Reading, Span
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Name,
    Negate,
    Number,
    Pair,
    Place,
    Polar,
    Quantity,
    Unit,
    negated,
)
from restitution.expression.units import NAMES
from restitution.expression.writing import write_expression
from restitution.mending import Fix, Note
from restitution.problem import (
    Aligned,
    Arrival,
    AtRest,
    Compare,
    Extremum,
    Find,
    Given,
    Impact,
    Kick,
    Let,
    Meets,
    Range,
    Relation,
    Show,
    Unknown,
    Value,
)
from restitution.records import dataclass


@dataclass(frozen=True)
class Declaration:
    """What a line says of bodies: of which, and which properties."""

    kind: str
    names: tuple[Token, ...]
    properties: tuple[tuple[str, Any, Place], ...]


_Property = tuple[str, Any, Place]


_SPHERE_FIELDS = {
    "MASS": "mass",
    "VELOCITY": "velocity",
    "AT_REST": "velocity",
    "AT": "position",
    "RADIUS": "radius",
}
_WALL_FIELDS = {"ALONG": "along", "THROUGH": "through", "RADIUS": "radius"}


PROPERTY = {
    "mass": "mass",
    "velocity": "velocity",
    "position": "place",
    "radius": "radius",
    "along": "direction",
    "through": "place",
    "start": "place",
    "end": "end",
    "centre": "centre",
}
"""Properties of bodies, by the names of their fields, as messages call them."""


def place_of(token: Token) -> Place:
    """The line and the column at which a token begins."""
    return Place(token.line or 1, token.column or 1)


def error_at(message: str, place: Place | None) -> StatementError:
    """An error that names its place, where it has one."""
    return StatementError(message, *((place.line, place.column) if place else (None, None)))


def _names(reading: Reading, node: Tree[Token], spans: list[Span]) -> tuple[Token, ...]:
    return tuple(span.first for span in spans[::2])


def _spheres(reading: Reading, node: Tree[Token], spans: list[Span]) -> Declaration:
    properties = spans[3].value if len(spans) > 3 else ()
    return Declaration("sphere", spans[1].value, _without_repeats(properties))


def _walls(reading: Reading, node: Tree[Token], spans: list[Span]) -> Declaration:
    properties = spans[3].value if len(spans) > 3 else ()
    return Declaration("wall", spans[1].value, _without_repeats(properties))


def _point(reading: Reading, node: Tree[Token], spans: list[Span]) -> Declaration:
    place = spans[3].place
    return Declaration("point", (spans[1].first,), (("position", spans[3].value, place),))


def _without_repeats(properties: tuple[_Property, ...]) -> tuple[_Property, ...]:
    seen: set[str] = set()
    for key, _, place in properties:
        if key in seen:
            raise error_at(f"the {PROPERTY[key]} is given twice", place)
        seen.add(key)
    return properties


def _sphere_properties(
    reading: Reading, node: Tree[Token], spans: list[Span]
) -> tuple[_Property, ...]:
    return tuple(span.value for span in spans[::2])


def _sphere_property(reading: Reading, node: Tree[Token], spans: list[Span]) -> _Property:
    key = _SPHERE_FIELDS[spans[0].first.type]
    value = spans[1].value if len(spans) > 1 else Pair(Number(Fraction(0)), Number(Fraction(0)))
    return key, _as_a_speed(value) if key == "velocity" else value, spans[0].place


def _as_a_speed(velocity: Expression) -> Expression:
    """A velocity of negative size as one in the opposite direction: no speed is −4.

    −u at 60° is u at 240°, −u at θ is u at θ from −**i**, −(u at θ) is the same.
    """
    match velocity:
        case Negate(Polar() as polar):
            return _as_a_speed(replace(polar, size=negated(polar.size)))
        case Polar(Negate(size), angle, wall=None) if not isinstance(angle, Degrees):
            origin = negated(velocity.origin or Unit("i"))
            return replace(velocity, size=size, origin=origin)
        case Polar(Negate(size), angle):
            return replace(velocity, size=size, angle=_turned_about(angle))
    return velocity


def _turned_about(angle: Expression) -> Expression:
    """The angle of the opposite direction."""
    half = Fraction(180)
    if isinstance(angle, Degrees):
        turn = half if angle.value < half else -half
        return replace(angle, value=angle.value + turn)
    return Binary("+", Degrees(half), angle)


def _wall_properties(
    reading: Reading, node: Tree[Token], spans: list[Span]
) -> tuple[_Property, ...]:
    first = spans[0].value
    if len(spans) == 1:
        return tuple(first)
    if spans[1].first.type == "COMMA":
        return (*first, *spans[2].value)
    return (*first, (_WALL_FIELDS[spans[1].first.type], spans[2].value, spans[1].place))


def _wall_property(reading: Reading, node: Tree[Token], spans: list[Span]) -> tuple[_Property, ...]:
    place = spans[0].place
    match spans[0].first.type:
        case "FROM":
            return ("start", spans[1].value, place), ("end", spans[3].value, place)
        case "CIRCLE":
            return (("centre", spans[2].value, place),)
        case kind:
            return ((_WALL_FIELDS[kind], spans[1].value, place),)


# --- events -----------------------------------------------------------------------------------


def _impact_property(reading: Reading, node: Tree[Token], spans: list[Span]) -> _Property:
    first = spans[0]
    if first.first.type != "LETTER":
        return str(first.first), spans[1].value, first.place
    if str(first.first) != "e":
        typed = reading.text(first.first, first.first)
        raise reading.error(
            f"unknown property '{typed}': the coefficient of restitution is given as e = …",
            first.place,
        )
    return "e", spans[2].value, first.place


def _impact(reading: Reading, node: Tree[Token], spans: list[Span]) -> Impact:
    first, second = str(spans[0].first), str(spans[2].first)
    properties: dict[str, Expression] = {}
    for key, value, place in spans[4].value if len(spans) > 4 else ():
        if key in properties:
            raise reading.error(f"'{key}' is given twice", place)
        properties[key] = value
    return Impact(first, second, **properties, place=spans[0].place)


def _kick(reading: Reading, node: Tree[Token], spans: list[Span]) -> Kick:
    return Kick(str(spans[0].first), spans[2].value, place=spans[0].place)


def _arrival(reading: Reading, node: Tree[Token], spans: list[Span]) -> Arrival:
    return Arrival(str(spans[0].first), spans[2].value, place=spans[0].place)


# --- facts ------------------------------------------------------------------------------------


def _let(reading: Reading, node: Tree[Token], spans: list[Span]) -> Let:
    return Let(spans[1].value.name, spans[3].value, place=spans[0].place)


def _given(reading: Reading, node: Tree[Token], spans: list[Span]) -> Given:
    return Given(tuple(span.value for span in spans[1::2]), place=spans[0].place)


def _unknown(reading: Reading, node: Tree[Token], spans: list[Span]) -> Unknown:
    return Unknown(_names_once(reading, spans[1::2]), place=spans[0].place)


def _names_once(reading: Reading, spans: list[Span]) -> tuple[str, ...]:
    names: list[str] = []
    for span in spans:
        if span.value.name in names:
            raise reading.error(f"'{span.value.name}' is listed twice", span.place)
        names.append(span.value.name)
    return tuple(names)


def _terms(reading: Reading, node: Tree[Token], spans: list[Span]) -> tuple[str, ...]:
    return _names_once(reading, spans[1::2])


def _compare(reading: Reading, node: Tree[Token], spans: list[Span]) -> Compare:
    operators: Any = tuple(str(span.first) for span in spans[1::2])
    operands = spans[::2]
    for one, other in (*pairwise(operands), *pairwise(operands[::-1])):
        _look_for_a_share(reading, one, other)
    return Compare(tuple(span.value for span in operands), operators)


def _look_for_a_share(reading: Reading, quantity: Span, number: Span) -> None:
    """Note ``energy_lost = 60%``, which says 0.6 J."""
    typed = reading.text(number.first, number.last)
    if number.first is not number.last or not str(number.first).endswith("%"):
        return
    tree = quantity.value
    if not isinstance(tree, Expression) or dimension_of_any([tree]) in (None, NONE):
        return
    message = f"{typed} was read as {write_expression(number.value)}, a number in SI"
    whole = _whole_of(tree, reading.events)
    fixes: tuple[Fix, ...] = ()
    if whole is not None:
        meant = f"{typed} of {whole}"
        message += f": did you mean {meant}?"
        fixes = (reading.fix(number.first, number.last, meant),)
    else:
        message += f": {typed} of what?"
    reading.warnings.append(Note(message, number.place.line, number.place.column, fixes))


def _whole_of(tree: Expression, events: int) -> str | None:
    """What a share of energy is surely a share of: the energy before."""
    match tree:
        case Quantity("energy_lost", (), stage):
            last = stage if isinstance(stage, int) else max(events, 1)
            return f"energy({last - 1})"
        case Quantity("total_energy_lost" | "energy", ()):
            return "energy(0)"
        case Quantity("energy", (Name(name),)):
            return f"energy({name}, 0)"
    return None


def _aligned(reading: Reading, node: Tree[Token], spans: list[Span]) -> Aligned:
    relation: Any = str(spans[1].first)
    return Aligned(spans[0].value, relation, spans[2].value)


def _at_rest(reading: Reading, node: Tree[Token], spans: list[Span]) -> AtRest:
    return AtRest(spans[0].value)


def _collide_again(reading: Reading, node: Tree[Token], spans: list[Span]) -> Meets:
    happens = str(spans[3].first) == "collide again"
    return Meets(spans[0].value, spans[2].value, again=True, happens=happens)


def _hits_again(reading: Reading, node: Tree[Token], spans: list[Span]) -> Meets:
    happens = spans[1].first.type == "HITS"
    return Meets(spans[0].value, spans[2].value, again=True, happens=happens)


def _will_hit(reading: Reading, node: Tree[Token], spans: list[Span]) -> Meets:
    happens = str(spans[1].first) == "will hit"
    return Meets(spans[0].value, spans[2].value, again=False, happens=happens)


# --- questions --------------------------------------------------------------------------------


def _percentage(spans: list[Span]) -> bool:
    return spans[-1].first.type == "PERCENTAGE"


def _value(reading: Reading, node: Tree[Token], spans: list[Span]) -> Value:
    text = reading.text(spans[0].first, spans[-1].last)
    if _percentage(spans):
        _look_for_a_unit(reading, spans[0])
    return Value(spans[0].value, _percentage(spans), text, place=spans[0].place)


def _look_for_a_unit(reading: Reading, item: Span) -> None:
    """Note a percentage of what has a unit: ``energy_lost as a percentage``."""
    dimension = dimension_of_any([item.value])
    whole = _whole_of(item.value, reading.events)
    if whole is None or dimension in (None, NONE):
        return
    typed = reading.text(item.first, item.last)
    message = f"a percentage needs a ratio, and {typed} is in {NAMES[dimension][1]}"
    meant = f"{typed}/{whole}"
    fix = reading.fix(item.first, item.last, meant)
    place = item.place
    reading.warnings.append(
        Note(f"{message}: did you mean {meant}?", place.line, place.column, (fix,))
    )


def _range(reading: Reading, node: Tree[Token], spans: list[Span]) -> Range:
    text = reading.text(spans[0].first, spans[-1].last)
    return Range(spans[1].value, _percentage(spans), text, place=spans[0].place)


def _extremum(reading: Reading, node: Tree[Token], spans: list[Span]) -> Extremum:
    kind: Any = str(spans[0].first).split()[0]
    text = reading.text(spans[0].first, spans[-1].last)
    return Extremum(
        kind, spans[1].value, spans[3].value, _percentage(spans), text, place=spans[0].place
    )


def _find(reading: Reading, node: Tree[Token], spans: list[Span]) -> Find:
    terms = spans[-1].value if isinstance(spans[-1].value, tuple) else None
    items = spans[1:-1:2] if terms is not None else spans[1::2]
    return Find(tuple(span.value for span in items), terms, place=spans[0].place)


def _show_with(reading: Reading, spans: list[Span], relation: Relation, subject: Any) -> Show:
    terms = None
    last = spans[-1]
    if isinstance(last.value, tuple):
        terms = last.value
        last = spans[-2]
    text = reading.text(spans[1].first, last.last)
    for span in spans:
        if span.first.type == "FIGURES":
            figures = int(str(span.first).split()[1].rstrip("sf."))
            if not isinstance(relation, Compare) or relation.operators[-1] != "=":
                raise reading.error("'s.f.' stands after a value, as in '= 0.236u'", span.place)
            if figures < 1:
                raise reading.error("expected at least 1 significant figure", span.place)
            relation = replace(relation, figures=figures)
    return Show(relation, subject, terms, text, place=spans[0].place)


def _show(reading: Reading, node: Tree[Token], spans: list[Span]) -> Show:
    return _show_with(reading, spans, spans[1].value, None)


def _show_range(reading: Reading, node: Tree[Token], spans: list[Span]) -> Show:
    text = reading.text(spans[1].first, spans[2].last)
    subject = Range(spans[2].value, False, text, place=spans[1].place)
    return _show_with(reading, spans, spans[4].value, subject)


def _show_extremum(reading: Reading, node: Tree[Token], spans: list[Span]) -> Show:
    kind: Any = str(spans[1].first).split()[0]
    text = reading.text(spans[1].first, spans[4].last)
    subject = Extremum(kind, spans[2].value, spans[4].value, False, text, place=spans[1].place)
    relation = Compare((spans[2].value, spans[6].value), ("=",))
    return _show_with(reading, spans, relation, subject)


LINES: Mapping[str, Builder] = {
    **BUILDERS,
    "names": _names,
    "spheres": _spheres,
    "walls": _walls,
    "point": _point,
    "sphere_properties": _sphere_properties,
    "sphere_property": _sphere_property,
    "wall_properties": _wall_properties,
    "wall_property": _wall_property,
    "impact_properties": _sphere_properties,
    "impact_property": _impact_property,
    "impact": _impact,
    "kick": _kick,
    "arrival": _arrival,
    "let": _let,
    "given": _given,
    "unknown": _unknown,
    "terms": _terms,
    "compare": _compare,
    "aligned": _aligned,
    "at_rest": _at_rest,
    "collide_again": _collide_again,
    "hits_again": _hits_again,
    "will_hit": _will_hit,
    "value": _value,
    "range": _range,
    "extremum": _extremum,
    "find": _find,
    "show": _show,
    "show_range": _show_range,
    "show_extremum": _show_extremum,
}
"""What a rule of the grammar of lines builds of the parts that it read."""
