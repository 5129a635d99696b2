"""Laws of the size of steps in planned workings: what is wrong with a derivation, in words."""

from __future__ import annotations

from collections.abc import Callable

from restitution.explaining.lines.derivation import Derivation, Line, Link, Meaning, Relation
from restitution.explaining.lines.notation import write_relation
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    letters,
    walk,
)
from restitution.solving import Solution

Law = Callable[[Solution, Derivation], list[str]]


def standard_form(solution: Solution, derivation: Derivation) -> list[str]:
    """Roots that are not opposite come of ax² + bx + c = 0, or of its factors."""
    found = []
    for line in derivation.lines:
        if line.move.id != "roots" or not isinstance(line.relation, Relation):
            continue
        values = [links[-1].right for links in line.relation.options]
        if len(values) < 2 or _opposite(values):
            continue
        above = _line(derivation, line.premises[0])
        if above is None or _links(above)[-1].right != Number(0):
            found.append(f"line {line.number} solves what is not in standard form")
    return found


def _opposite(values: list[Expression]) -> bool:
    return len(values) == 2 and (Negate(values[0]) == values[1] or values[0] == Negate(values[1]))


def nothing_of_rest(solution: Solution, derivation: Derivation) -> list[str]:
    """What is at rest has no component: no line says so."""
    return [
        f"line {line.number} resolves what is at rest"
        for line in derivation.lines
        if _is_component(line) and _links(line)[0].right == Number(0)
    ]


def together(solution: Solution, derivation: Derivation) -> list[str]:
    """Both components of a velocity before an impact stand in one place."""
    found = []
    groups: dict[object, list[int]] = {}
    shown = [
        e for e in derivation.lines if e.shown == "line" and not isinstance(e.relation, Meaning)
    ]
    for place, line in enumerate(shown):
        if not _is_component(line):
            continue
        match _links(line)[0].left:
            case Quantity("along" | "across", (Quantity("velocity", (body,), int(stage)), axis)):
                before = isinstance(axis, Quantity) and axis.stage != stage
                if before and axis.kind == "line_of_centres":  # type: ignore[union-attr]
                    groups.setdefault((body, stage, axis), []).append(place)
    for own in groups.values():
        between = shown[own[0] : own[-1] + 1]
        if not all(map(_is_component, between)):
            found.append(f"lines {[shown[n].number for n in own]} are not in one place")
    return found


def values_have_lines(solution: Solution, derivation: Derivation) -> list[str]:
    """A component into which a value is put, and more than a number for a letter, has a line.

    Else a definition would take two steps in one: the component, and what is made of it.
    """
    found = []
    own = {each.letter for each in derivation.meanings.values()}
    for line in derivation.lines:
        if line.move.id != "define" or line.move.record not in ("speed", "energy", "assemble"):
            continue
        cited = [e for ref in line.premises if (e := _line(derivation, ref)) is not None]
        values = [(_links(e)[0].left, _links(e)[-1].right) for e in cited if _links(e)]
        known = dict(values)
        for left, right in values:
            named = isinstance(left, Letter) and left.name in own
            if (not named and not _is_of_velocity(left)) or isinstance(right, Letter):
                continue
            put = [e for e in walk(right) if e in known and _is_put(e, own)]
            angles = [e for e in walk(right) if isinstance(e, Apply) and e.argument in known]
            if angles or (put and not _is_plain(right, known, put)):
                found.append(
                    f"line {line.number} puts values into {write_relation_of(left, right)}"
                )
    return found


def _is_of_velocity(tree: Expression) -> bool:
    match tree:
        case Quantity("along" | "across", (Quantity("velocity"), *_)):
            return True
    return False


def write_relation_of(left: Expression, right: Expression) -> str:
    """``left = right``."""
    return write_relation(Relation(((Link(left, "=", right),),)))


def _is_put(tree: Expression, own: set[str]) -> bool:
    match tree:
        case Letter(name):
            return name not in own
        case Apply("sin" | "cos" | "tan", Letter()):
            return True
    return False


def _is_plain(
    right: Expression, known: dict[Expression, Expression], put: list[Expression]
) -> bool:
    """Whether a number takes the place of one letter in a product."""
    rational = all(
        isinstance(node, Number | Negate) or (isinstance(node, Binary) and node.op in "*/")
        for each in put
        for node in walk(known[each])
    )
    simple = all(
        not isinstance(node, Apply) and not (isinstance(node, Binary) and node.op in "+-^")
        for node in walk(right)
    )
    return rational and simple and len(set(put)) == 1


def one_sided(solution: Solution, derivation: Derivation) -> list[str]:
    """No denominator with a root in it turns into a number without one in a single step."""
    found = []
    for line in derivation.lines:
        if line.move.id != "rearrange" or len(_links(line)) != 1:
            continue
        above = _line(derivation, line.premises[0])
        (link,) = _links(line)
        if above is None or not isinstance(link.left, Letter) or letters(link.right):
            continue
        factor = _factor_of(link.left, _links(above))
        if factor is not None and _is_sum_of_roots(factor):
            found.append(f"line {line.number} divides by a sum of roots in one step")
    return found


def _factor_of(letter: Letter, links: tuple[Link, ...]) -> Expression | None:
    """By what a letter is multiplied, where that is a side of an equation."""
    for side in (links[0].left, links[-1].right):
        match side:
            case Binary("*", factor, right) if right == letter:
                return factor
            case Binary("*", left, factor) if left == letter:
                return factor
    return None


def _is_sum_of_roots(tree: Expression) -> bool:
    """Whether a sum has terms with different roots, or with a root and without."""
    roots = {
        frozenset(repr(e.argument) for e in walk(term) if isinstance(e, Apply))
        for term in _terms(tree)
    }
    return len(roots) > 1


def _terms(tree: Expression) -> list[Expression]:
    match tree:
        case Binary("+" | "-", left, right):
            return [*_terms(left), *_terms(right)]
        case Negate(operand):
            return _terms(operand)
    return [tree]


STEPS: dict[str, Law] = {
    "quadratics in standard form": standard_form,
    "nothing of what is at rest": nothing_of_rest,
    "both components together": together,
    "values have lines": values_have_lines,
    "no long division": one_sided,
}


def _is_component(line: Line) -> bool:
    return (line.move.id, line.move.record, line.shown) == ("define", "component", "line")


def _line(derivation: Derivation, ref: object) -> Line | None:
    return derivation.line(ref) if isinstance(ref, int) else None


def _links(line: Line) -> tuple[Link, ...]:
    return line.relation.options[0] if isinstance(line.relation, Relation) else ()


__all__ = ["STEPS"]
