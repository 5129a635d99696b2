"""The one root that a line rejects: what it makes of another letter, or of what was squared."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.exact.symbols import atoms_in, symbol_names
from restitution.explaining.lines.derivation import (
    OPPOSITE,
    Derivation,
    Line,
    Link,
    Meaning,
    Ref,
    Relation,
    Sign,
    equality,
    numbers_in,
)
from restitution.explaining.lines.notation import read_relation, read_tree
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    is_function,
    letters,
    walk,
)
from restitution.oracle.roles import ACUTE, Role
from restitution.planning.writing.forms import UnwrittenError, tree_of

_BEYOND = {"<": sp.Lt, "<=": sp.Le, ">": sp.Gt, ">=": sp.Ge}


def bound_broken(derivation: Derivation, line: Line) -> tuple[tuple[Link, ...], Link] | None:
    """The one root that a line rejects, and what it would make of another letter: e > 1.

    None where several roots are rejected, or by what is known of the letter itself.
    """
    first = line.premises[0] if line.premises else None
    above = derivation.line(first)
    if above is None or not isinstance(above.relation, Relation):
        return None
    assert isinstance(line.relation, Relation)
    dropped = [option for option in above.relation.options if option not in line.relation.options]
    bodies = {body: "sphere" for event in derivation.events for body in event.bodies}
    bounds = [
        links[0]
        for ref in line.premises
        if isinstance(ref, str) and ref.partition(" ")[2][:1] in ("<", ">")
        for links in read_relation(ref, bodies).options
        if len(links) == 1  # a range between two ends is that of an angle
    ]
    if not bounds and len(dropped) == 1:
        return (
            _ratio_broken(derivation, line, dropped[0])
            or _made_negative(derivation, line, dropped[0])
            or _positive_broken(derivation, line, dropped[0])
        )
    if len(dropped) != 1 or len(bounds) != 1 or bounds[0].sign not in OPPOSITE:
        return None
    bound = bounds[0]
    if letters(bound.left) & letters(dropped[0][0].left) or bound.left == dropped[0][0].left:
        return None
    sign = OPPOSITE[bound.sign]
    return dropped[0], Link(bound.left, sign, bound.right)


def _ratio_broken(
    derivation: Derivation, line: Line, dropped: tuple[Link, ...]
) -> tuple[tuple[Link, ...], Link] | None:
    """A root and the ratio of an acute angle that it makes negative, or more than 1."""
    angles = [ref.partition(":") for ref in line.premises if isinstance(ref, str)]
    if len(angles) != 1 or angles[0][0].strip() != "acute":
        return None
    angle = read_tree(angles[0][2], {})
    nodes = {node for pair in equations_of(derivation, line) for e in pair for node in walk(e)}
    ratios = {node for node in nodes if isinstance(node, Apply) and node.argument == angle}
    if len(ratios) != 1:
        return None
    (ratio,) = ratios
    ends: tuple[tuple[Sign, int], ...] = (("<=", 0),)
    if ratio.function in ("sin", "cos"):
        ends = (*ends, (">=", 1))
    for sign, end in ends:
        bound = Link(ratio, sign, Number(Fraction(end)))
        if made_by_a_root(derivation, line, dropped, bound):
            return dropped, bound
    return None


def _made_negative(
    derivation: Derivation, line: Line, dropped: tuple[Link, ...]
) -> tuple[tuple[Link, ...], Link] | None:
    """A root and the letter that it makes negative, by the one line that is cited beside it."""
    match [premise.relation for ref in line.premises[1:] if (premise := _line(derivation, ref))]:
        case [Relation(((Link(Letter() as other, "="), *_) as links,))]:
            root = dropped[0].left
            if len(line.premises) != 2 or not isinstance(root, Letter) or root == other:
                return None
            try:
                value, worth = (
                    in_letters(chain[-1].right, positive=True) for chain in (dropped, links)
                )
            except (RestitutionError, TypeError):
                return None
            if worth.subs(sp.Symbol(root.name, positive=True), value).is_negative:
                return dropped, Link(other, "<", Number(Fraction(0)))
    return None


def _positive_broken(
    derivation: Derivation, line: Line, dropped: tuple[Link, ...]
) -> tuple[tuple[Link, ...], Link] | None:
    """A root and the letter that it makes 0 or less, which is found and positive silently.

    None where a line cites what else its letters may be.
    """
    if any(isinstance(ref, str) for ref in line.premises):
        return None
    pairs = equations_of(derivation, line)
    names = {name for pair in pairs for side in pair for name in letters(side)}
    lefts = [
        line.relation.options[0][0].left
        for line in derivation.lines
        if isinstance(line.relation, Relation)
    ]
    named = {left.name for left in lefts if isinstance(left, Letter)}
    for name in sorted(names & named - derivation.meanings.keys()):
        bound = Link(Letter(name), "<=", Number(Fraction(0)))
        if made_by_a_root(derivation, line, dropped, bound):
            return dropped, bound
    return None


def _line(derivation: Derivation, ref: Ref) -> Line | None:
    return derivation.line(ref)


def root_of_a_square(derivation: Derivation, line: Line) -> tuple[tuple[Link, ...], int] | None:
    """The one root that a line rejects, and the line with a root by which that is none.

    It came of squaring that line.
    """
    cited = numbers_in(line.premises)
    if line.move.id != "reject" or len(cited) != 2:
        return None
    roots, other = (derivation.line(number) for number in cited)
    if line.premises[0] != cited[0]:
        return None
    assert isinstance(line.relation, Relation)
    if roots is None or other is None or other.move.id == "law":
        return None
    if not isinstance(roots.relation, Relation) or not isinstance(other.relation, Relation):
        return None
    dropped = [option for option in roots.relation.options if option not in line.relation.options]
    own = other.relation.options
    if len(dropped) != 1 or len(own) != 1 or any(link.sign != "=" for link in own[0]):
        return None
    nodes = (node for link in own[0] for node in walk(Binary("-", link.left, link.right)))
    unknown = letters(dropped[0][0].left)
    if not any(is_function(node, "sqrt") and letters(node) & unknown for node in nodes):
        return None
    return dropped[0], cited[1]


def root_against_a_law(derivation: Derivation, line: Line) -> tuple[tuple[Link, ...], int] | None:
    """The one root that a line rejects, and the equation that it makes false for all letters.

    ``w = −u`` in ``2mu − nmu = −2mu + nmw`` leaves 4mu = 0.
    """
    assert isinstance(line.relation, Relation)
    cited = numbers_in(line.premises)
    if line.move.id != "reject" or len(cited) != 2 or len(line.premises) != 2:
        return None
    roots, equations = derivation.line(line.premises[0]), list(equations_of(derivation, line))
    if roots is None or not isinstance(roots.relation, Relation) or len(equations) != 1:
        return None
    dropped = [option for option in roots.relation.options if option not in line.relation.options]
    if len(dropped) != 1 or not isinstance(dropped[0][0].left, Letter):
        return None
    root = sp.Symbol(dropped[0][0].left.name, positive=True)
    try:
        value, *sides = (
            in_letters(side, positive=True) for side in (dropped[0][-1].right, *equations[0])
        )
    except (RestitutionError, TypeError):
        return None
    gap = sp.factor(sp.expand((sides[0] - sides[1]).subs(root, value)))
    return (dropped[0], int(line.premises[1])) if gap.is_nonzero else None


def positive_by_a_law(
    derivation: Derivation, line: Line, known: Mapping[str, Role]
) -> tuple[Link, int] | None:
    """That the letter of a root which a line keeps is positive, by the one equation that it cites.

    ``w > 0`` by ``mu cos(alpha) = kmw``, where the other letters are ``known`` to be positive, or
    not negative, or acute angles.
    """
    cited = numbers_in(line.premises)
    if line.move.id != "reject" or len(cited) != 2 or line.premises[0] != cited[0]:
        return None
    if not all(ref in cited or str(ref).startswith("acute:") for ref in line.premises):
        return None
    equations = list(equations_of(derivation, line))
    assert isinstance(line.relation, Relation)
    own = line.relation.options[0][0].left
    if len(equations) != 1 or len(line.relation.options) != 1 or not isinstance(own, Letter):
        return None
    try:
        left, right = map(in_letters, equations[0])
    except (RestitutionError, TypeError):
        return None
    unknown, gap = sp.Symbol(own.name), sp.expand(left - right)
    for node in atoms_in(gap, sp.sin, sp.cos, sp.tan):
        if known.get(str(node.args[0])) == ACUTE:
            gap = gap.xreplace({node: sp.Dummy(positive=True)})
    for name in {symbol.name for symbol in gap.free_symbols} & known.keys():
        if known[name].kind == "positive":
            gap = gap.xreplace({sp.Symbol(name): sp.Dummy(positive=True)})
        elif known[name].kind == "restitution":
            gap = gap.xreplace({sp.Symbol(name): sp.Dummy(nonnegative=True)})
    if not gap.is_polynomial(unknown) or sp.degree(gap, unknown) != 1:
        return None
    value = sp.factor(-gap.subs(unknown, 0) / gap.coeff(unknown))
    return (Link(own, ">", Number(Fraction(0))), cited[1]) if value.is_positive else None


def made_by_a_root(
    derivation: Derivation, line: Line, dropped: Sequence[Link], bound: Link
) -> tuple[Relation, ...]:
    """What the other letters of the cited equations would be, that of the bound last.

    Empty where these equations do not tell, or are not linear in them.
    """
    equations = list(equations_of(derivation, line))
    own = {line.relation.letter for line in derivation.lines if isinstance(line.relation, Meaning)}
    if not isinstance(dropped[0].left, Letter) or not isinstance(bound.left, Letter | Apply):
        return ()
    root, last = dropped[0].left.name, getattr(bound.left, "name", "_ratio")
    try:
        ratio = {in_letters(bound.left, positive=True): sp.Symbol(last, positive=True)}
        gaps = [
            sp.sympify(
                in_letters(a, positive=True) - in_letters(b, positive=True), strict=True
            ).xreplace(ratio)
            for a, b in equations
        ]
        value = in_letters(dropped[-1].right, positive=True)
        limit = in_letters(bound.right, positive=True)
    except (RestitutionError, TypeError):
        return ()
    put = [sp.expand(gap.subs(sp.Symbol(root, positive=True), value)) for gap in gaps]
    names = sorted(symbol_names(*put) & (own | {last}) - {root})
    unknowns = [sp.Symbol(name, positive=True) for name in names if name != last]
    unknowns.append(sp.Symbol(last, positive=True))
    signed = {value: sp.Dummy(value.name) for value in unknowns}
    put = [gap for gap in (value.xreplace(signed) for value in put) if gap != 0]
    if len(put) != len(unknowns) or last not in names:
        return ()
    values = _solved(put, list(signed.values()))
    if not values or any(value.free_symbols & set(signed.values()) for value in values):
        return ()
    if _BEYOND[bound.sign](values[-1], limit) != sp.true:
        return ()
    try:
        trees = [tree_of(value) for value in values]
    except UnwrittenError:
        return ()
    lefts: list[Expression] = [Letter(value.name) for value in unknowns[:-1]]
    relations = [
        equality(left, tree)
        for left, tree in zip((*lefts, bound.left), trees, strict=True)
        if left not in {tree for tree, _ in equations}  # it stands there already
    ]
    if values[-1].free_symbols and relations:
        strict: Sign = "<" if bound.sign[0] == "<" else ">"
        sure = _BEYOND[strict](values[-1], limit) == sp.true
        beyond = Link(trees[-1], strict if sure else bound.sign, bound.right)
        relations[-1] = Relation(((Link(bound.left, "=", trees[-1]), beyond),))
    return tuple(relations)


def _solved(gaps: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> list[sp.Expr]:
    """The values of unknowns, in their order, by equations that are linear in all or one by one.

    Empty where they are not.
    """
    # Roots and sines of numbers stand as letters: SymPy would look for the field that they make.
    atoms = {
        node: sp.Dummy(positive=True)
        for gap in gaps
        for node in atoms_in(gap, sp.Pow, sp.sin, sp.cos, sp.tan)
        if not node.free_symbols & set(unknowns) and not (node.is_Pow and node.exp.is_Integer)
    }
    back = {letter: node for node, letter in atoms.items()}
    try:
        (solution,) = sp.linsolve([gap.xreplace(atoms) for gap in gaps], list(unknowns))
        return [tidy(value.xreplace(back)) for value in solution]
    except (ValueError, sp.polys.polyerrors.PolynomialError):
        pass
    values: dict[sp.Symbol, sp.Expr] = {}
    rest = list(gaps)
    while rest:
        for gap in rest:
            left = sp.expand(gap.subs(values))
            open_ = left.free_symbols & set(unknowns)
            if len(open_) == 1 and left.is_polynomial(*open_) and sp.degree(left, *open_) == 1:
                (unknown,) = open_
                values[unknown] = tidy(-left.subs(unknown, 0) / sp.diff(left, unknown))
                rest.remove(gap)
                break
        else:
            return []
    return [values[unknown] for unknown in unknowns]


def equations_of(derivation: Derivation, line: Line) -> Iterator[tuple[Expression, Expression]]:
    """The sides of the equations that a line cites, but for its roots."""
    for ref in line.premises[1:]:
        above = derivation.line(ref)
        relation = None if above is None else above.relation
        if isinstance(relation, Relation) and len(relation.options) == 1:
            links = relation.only
            if all(link.sign == "=" for link in links):
                yield links[0].left, links[-1].right


__all__ = [
    "bound_broken",
    "made_by_a_root",
    "positive_by_a_law",
    "root_against_a_law",
    "root_of_a_square",
]
