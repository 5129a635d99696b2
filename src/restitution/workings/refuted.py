"""A claim that is not true in words: what is true instead, or numbers for which it fails."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, replace
from typing import Any

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Derivation,
    Link,
    Note,
    Relation,
    Sign,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.explaining.lines.trees import rebuilt, trees_of
from restitution.expression.evaluate import evaluate, in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    has_quantity,
    letters,
)
from restitution.oracle import REAL, Oracle, Role, compared
from restitution.oracle.roles import ACUTE, COEFFICIENT
from restitution.planning.writing.forms import (
    ZERO,
    difference,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.problem import Aligned, AtRest, Compare, Extremum, Meets, Show
from restitution.render import layout as lay
from restitution.render.text import to_text
from restitution.solving.story.letters import roles
from restitution.vector import Vector
from restitution.workings.leads.meetings import closing_of
from restitution.workings.naming.ends import Ends, claim_of_meeting
from restitution.workings.naming.measured import as_answer
from restitution.workings.naming.quantities import Naming
from restitution.workings.reasons.grounds import given_links

_HOLDS: Mapping[str, Callable[[float], bool]] = {
    "=": lambda gap: gap == 0,
    "<": lambda gap: gap < 0,
    "<=": lambda gap: gap <= 0,
    ">": lambda gap: gap > 0,
    ">=": lambda gap: gap >= 0,
}
_NEAR = 1e-12
_DENIED = {
    "perpendicular to": "claim.not-perpendicular",
    "parallel to": "claim.not-parallel",
    "in the direction of": "claim.not-same-direction",
    "opposite to": "claim.not-opposite",
}


def claim_of(note: Note, naming: Naming, ends: Ends) -> Sentence | lay.Layout | str:
    """What a claim says: in the words of the question, but for an equation in letters."""
    asked = ends.item(note.item)
    if isinstance(asked, Show) and isinstance(asked.relation, Meets):
        return claim_of_meeting(asked.relation, naming)
    if note.claim is not None and isinstance(asked, Show) and isinstance(asked.relation, Compare):
        formula, named = naming.relation(note.claim), ends.named(note.item)
        # The letters that the question has for quantities may be others in the working.
        lettered = "where" in (named if isinstance(named, str) else to_text(named)).split()
        if lettered or not _in_words(formula):
            return _with_article(formula)
    return ends.named(note.item)


def _in_words(layout: Any) -> bool:
    """Whether mathematics holds words: the name of a quantity that has no letter."""
    if isinstance(layout, tuple):
        return any(map(_in_words, layout))
    if isinstance(layout, lay.Words | lay.Phrase):
        return True
    return isinstance(layout, lay.Layout) and any(
        _in_words(getattr(layout, field.name)) for field in fields(layout)
    )


def _with_article(formula: lay.Layout) -> Sentence | lay.Layout:
    """An equation among words: where it begins with words, they have their article."""
    if isinstance(formula, lay.Relation) and isinstance(
        formula.operands[0], lay.Words | lay.Phrase
    ):
        return say("derived.the", quantity=formula)
    return formula


def refutation(note: Note, derivation: Derivation, naming: Naming, ends: Ends) -> Sentence:
    """That a claim is not true, and why."""
    asked = ends.item(note.item)
    relation = asked.relation if isinstance(asked, Show) else None
    claim = claim_of(note, naming, ends)
    values = tuple(_side(link, naming) for link in note.instance)
    equations = ((side, _side(side, naming)) for side in note.sides)
    sides = tuple(
        _by_another_ratio(side, note, derivation, naming) or _with_article(equation)
        for side, equation in equations
        if len(equation.operands) > 1
    )
    match relation:
        case Compare() if isinstance(asked, Show) and asked.subject is not None:
            return _of_subject(asked, claim, note, naming)
        case Compare(operators=("=",)):
            other_value = _value(note, derivation, naming)
            if other_value is not None:
                return other_value
        case AtRest(body) if note.lines:
            link = _link_of(derivation, note.lines[-1])
            return say("refuted.rest", body=body.name, velocity=_side(link, naming))
        case Aligned(left, how, right):
            trees = _sides_of(note, left, right, how)
            one, other_ = map(naming.side, trees)
            denied = say(_DENIED[how], left=one, right=other_)
            if not note.instance:
                return _apart(denied, how, trees, note, derivation, naming)
            if values and sides:
                slots: dict[str, Any] = {"claim": denied, "values": values, "sides": sides}
                product = _scalar_product(note) if how == "perpendicular to" else None
                if product is not None:
                    slots["product"] = naming.relation(Relation((product,)))
                    return say("refuted.product-instance", **slots)
                bearing = _bearing(note, trees, naming) if how != "perpendicular to" else None
                if bearing is not None:
                    return say("refuted.bearing-instance", **slots, bearing=bearing)
                return say("refuted.direction-instance", **slots)
            return say("refuted.direction", claim=denied)
        case Meets() if not values and note.lines:
            line = derivation.line(note.lines[-1])
            if line is not None and line.item != note.item:
                return say("refuted.opposite-above", claim=claim)
            other = replace(relation, happens=not relation.happens)
            return say("refuted.opposite", claim=claim_of_meeting(other, naming))
    claimed = trees_of(note.claim) if note.claim is not None else ()
    beside = tuple(side for side in note.sides if side not in note.instance)
    if sides and note.sides != beside and not any(link.left in claimed for link in beside):
        letter, value = (naming.layout(side) for side in (note.sides[0].left, note.sides[0].right))
        slots = {"claim": claim, "letter": letter, "value": value}
        if beside:
            others = tuple(_side(link, naming) for link in beside)
            return say("refuted.possible-when", **slots, values=others)
        if signs := tuple(_side(link, naming) for link in note.instance if link not in note.sides):
            return say("refuted.possible-with", **slots, values=signs)
        return say("refuted.possible", **slots)
    if len(beside) == 1:
        # A letter of which the instance says the value is a bound: its value is not said again.
        note, sides = replace(note, sides=beside), (_with_article(_side(beside[0], naming)),)
    sentence = say("refuted.sides", sides=sides)
    if isinstance(relation, Compare):
        sentence = _compared(note, sides, naming) or sentence
    elif isinstance(relation, Meets):
        closing = closing_of(relation, naming)
        sentence = sentence if closing is None else say("refuted.so", sides=sides, claim=closing)
    if values and sides:
        return say("refuted.general", claim=claim, values=values, sides=sentence)
    if values:
        return say("refuted.instance", claim=claim, values=values)
    if sides:
        return say("refuted.claim", claim=claim, sides=sentence)
    return say("refuted.plainly", claim=claim)


def _by_another_ratio(
    side: Link, note: Note, derivation: Derivation, naming: Naming
) -> Sentence | None:
    """A ratio of an angle by another one, of which a line above has the value in letters.

    None of another side, and where a line has the ratio itself.
    """
    match side:
        case Link(Apply("sin" | "cos" | "tan", angle), "=", worth) if not letters(worth):
            pass
        case _:
            return None
    values = {link.left: in_letters(link.right) for link in note.instance}
    names = {angle, *(Letter(n) for n, e in derivation.meanings.items() if e.quantity == angle)}
    place = list(derivation.asked).index(note.item)
    above = [
        line
        for line in derivation.lines
        if isinstance(line.relation, Relation)
        and len(line.relation.options) == 1
        and line.item in list(derivation.asked)[: place + 1]
    ]
    links = [_link_of(derivation, line.number) for line in above]
    assert isinstance(side.left, Apply)
    same = {Apply(side.left.function, name) for name in names}
    if any(link.left in same for link in links):
        return None
    for link in links:
        match link:
            case Link(Apply("sin" | "cos" | "tan", own), "=", right) if own in names:
                value = _at(right, values)
                if value is not None and _agree(link.left, value, side):
                    ratio = _side(Link(link.left, "=", tree_of(value)), naming)
                    return say("refuted.by-ratio", ratio=ratio, side=_side(side, naming))
    return None


def _at(tree: Expression, values: Mapping[Expression, Any]) -> sp.Expr | None:
    """What an expression is with values of its letters; None where it is no number."""
    names = {link.name: value for link, value in values.items() if isinstance(link, Letter)}
    if has_quantity(tree):
        return None
    try:
        value = tidy(evaluate(tree, lambda name: names.get(name, sp.Symbol(name, positive=True))))
    except (RestitutionError, ArithmeticError, TypeError, ValueError):
        return None
    return value if isinstance(value, sp.Expr) and value.is_real and value.is_finite else None


def _agree(ratio: Expression, value: sp.Expr, side: Link) -> bool:
    """Whether an angle of up to 180° with one ratio has the other, which then follows."""
    assert isinstance(ratio, Apply)
    assert isinstance(side.left, Apply)
    inverse = {"sin": sp.asin, "cos": sp.acos, "tan": sp.atan}[ratio.function](value)
    angle = inverse if inverse >= 0 else inverse + sp.pi
    own = {"sin": sp.sin, "cos": sp.cos, "tan": sp.tan}[side.left.function](angle)
    if ratio.function == "sin" and side.left.function != "sin":
        return False  # it may be acute or obtuse
    worth = in_letters(side.right)
    return isinstance(worth, sp.Expr) and tidy(own - worth) == 0


def _compared(
    note: Note, sides: tuple[Sentence | lay.Layout, ...], naming: Naming
) -> Sentence | None:
    """What the sides of a claim are worth, and how they compare; None where they are no numbers."""
    values = {link.left: link.right for link in (*note.sides, *note.instance)}
    assert note.claim is not None
    for link in note.claim.only:
        ends = (link.left, link.right)
        try:
            low, high = (_number(rebuilt(end, lambda tree: values.get(tree, tree))) for end in ends)
        except (RestitutionError, TypeError, ValueError, ZeroDivisionError):
            return None
        gap = 0 if abs(low - high) <= _NEAR * max(abs(low), abs(high)) else low - high
        if _HOLDS[link.sign](gap):
            continue
        worth = [e for e in ends if any(e == side.left != side.right for side in note.sides)]
        if link.sign == "=":
            if len(sides) == 2:
                return say("refuted.but", one=sides[0], other=sides[1])
        elif len(sides) == 2 == len(worth):
            word = "refuted.equal" if gap == 0 else "refuted.less" if gap > 0 else "refuted.more"
            return say(word, sides=sides)
        if len(sides) != 1 or len(worth) != 1:
            return None
        (other,) = [end for end in ends if end not in worth] or [link.right]
        above = gap if worth == [link.left] else -gap
        if link.sign == "=":
            word = "refuted.not-equal-to"
        elif above:
            word = "refuted.more-than" if above > 0 else "refuted.less-than"
        else:
            upper = (link.sign[0] == "<") == (worth == [link.left])
            word = "refuted.not-less-than" if upper else "refuted.not-more-than"
        return say(word, side=sides[0], bound=naming.layout(other))
    return None


def _number(tree: Expression) -> float:
    """An expression as a float, with 1 for letters of size."""
    value: Any = evaluate(tree, lambda name: sp.Integer(1))
    return float(sp.sympify(value, strict=True))


def _apart(
    denied: Sentence,
    how: str,
    trees: tuple[Expression, Expression],
    note: Note,
    derivation: Derivation,
    naming: Naming,
) -> Sentence:
    """That two directions do not stand to each other as claimed, and what they are."""
    given = (fact.relation.only for fact in derivation.facts if fact.kind == "data")
    known = {links[0].left: links[0].right for links in given}
    known |= {e.left: e.right for e in (_link_of(derivation, line) for line in note.lines)}
    worth = [known.get(tree, tree) for tree in trees]
    try:
        a, b = (in_letters(e, positive=True) for e in worth)
    except RestitutionError:
        return say("refuted.direction", claim=denied)
    if not (isinstance(a, Vector) and isinstance(b, Vector)) or 0 in (a.dot(a), b.dot(b)):
        return say("refuted.direction", claim=denied)
    if how == "perpendicular to":
        links = tuple(_product_in_components(trees, a, b))
    elif tidy(a.cross(b)) != 0:
        left, right = map(naming.layout, worth)
        return say("refuted.no-multiple", claim=denied, left=left, right=right)
    else:
        factor = tree_of(tidy(a.dot(b) / b.dot(b)))
        links = (Link(trees[0], "=", product(factor, trees[1])),)
    return say("refuted.direction-as", claim=denied, relation=naming.relation(Relation((links,))))


def _product_in_components(
    trees: tuple[Expression, Expression], a: Vector, b: Vector
) -> Iterator[Link]:
    """The scalar product of two vectors that is not zero, by their components."""
    value = tree_of(tidy(a.dot(b)))
    terms = [product(tree_of(p), tree_of(q)) for p, q in zip(a, b, strict=True) if p and q]
    worked = swept(total(terms))
    yield Link(Quantity("dot", trees), "=", worked)
    if worked != value:
        yield Link(worked, "=", value)
    yield Link(value, "!=", ZERO)


def _bearing(note: Note, trees: tuple[Expression, Expression], naming: Naming) -> Sentence | None:
    """How one direction stands to another, with the values of an instance; None if it is open."""
    known = {side.left: side.right for side in note.sides}
    try:
        a, b = (in_letters(known.get(tree, tree), positive=True) for tree in trees)
    except RestitutionError:
        return None
    if not (isinstance(a, Vector) and isinstance(b, Vector)) or 0 in (a.dot(a), b.dot(b)):
        return None
    if tidy(a.cross(b)) != 0:
        name: SentenceId = "refuted.no-multiple-of"
    else:
        along = tidy(a.dot(b)).is_positive
        if along is None:
            return None
        name = "refuted.same-direction" if along else "refuted.opposite-direction"
    if len(note.sides) == 1:
        one = {
            "refuted.no-multiple-of": "refuted.no-multiple-of-one",
            "refuted.same-direction": "refuted.in-direction-of-one",
            "refuted.opposite-direction": "refuted.opposite-to-one",
        }[name]
        (other,) = (tree for tree in trees if tree not in known)
        return say(one, other=naming.side(other))
    return say(name)


def _of_subject(
    asked: Show, claim: Sentence | lay.Layout | str, note: Note, naming: Naming
) -> Sentence:
    """That a range, or a greatest or least value, is another."""
    if isinstance(asked.subject, Extremum) and note.claim is not None:
        link = note.claim.only[0]
        extreme = naming.extreme(link.left, greatest=asked.subject.kind == "maximum")
        claimed = naming.layout(link.right)
        if not note.sides:
            return say("refuted.extreme", quantity=extreme, claimed=claimed)
        (true,) = note.sides
        value = _with_decimal(true.right, naming)
        return say("refuted.value", quantity=extreme, claimed=claimed, value=value)
    if note.claim is not None:
        claim = naming.relation(note.claim)
    if note.sides:
        true_range = naming.relation(Relation((note.sides,)))
        return say("refuted.range-is", range=claim, true=true_range)
    return say("refuted.range", range=claim)


def _value(note: Note, derivation: Derivation, naming: Naming) -> Sentence | None:
    """What a quantity is worth of which another value is claimed."""
    assert note.claim is not None
    link = note.claim.only[0]
    if not isinstance(link.left, Quantity) or has_quantity(link.right) or not note.lines:
        return None
    own = _link_of(derivation, note.lines[-1])
    if own.left != link.left:
        return None
    claimed, value = naming.layout(link.right), _with_decimal(own.right, naming)
    if note.sides and note.sides[0].sign == "≈":
        value = naming.layout(note.sides[0].right)
    name = naming.layout(link.left)
    plain, general = (
        ("refuted.vector", "refuted.vector-general")
        if isinstance(name, lay.Bold | lay.Letter)
        else ("refuted.value", "refuted.value-general")
    )
    facts = tuple(_bounds_of_letters(derivation, note.part))
    slots: dict[str, Any] = {"quantity": name, "claimed": claimed, "value": value}
    if not _may_agree(link.right, own.right):
        return say(plain, **slots)
    if not _differ(link.right, own.right, naming, facts):
        return say(general, **slots)
    apart = difference_of(link.right, own.right, naming, facts)
    if apart is None:
        return say(plain, **slots)
    differs: SentenceId = (
        "refuted.vector-differs" if plain == "refuted.vector" else "refuted.value-differs"
    )
    slots["difference"] = naming.relation(apart)
    if reasons := tuple(_reasons(apart.only[-1], naming, facts)):
        slots["difference"] = say("refuted.as", relation=slots["difference"], reasons=reasons)
    return say(differs, **slots)


def _reasons(
    bound: Link, naming: Naming, facts: tuple[Link, ...]
) -> Iterator[Sentence | lay.Layout]:
    """What is given of letters, and which angles are acute, without which a sign is not certain."""
    known = {
        name: COEFFICIENT if role.kind == "restitution" else role
        for name, role in roles(naming.problem).items()
    }
    for fact in facts:
        others = tuple(other for other in facts if other != fact)
        if not _is_certain(bound, known, others):
            is_turned = isinstance(fact.left, Number)
            own = Link(fact.right, FLIPPED[fact.sign], fact.left) if is_turned else fact
            yield naming.relation(Relation(((own,),)))
    for name in sorted(letters(bound.left)):
        if known.get(name) == ACUTE and not _is_certain(bound, {**known, name: REAL}, facts):
            yield say("derived.acute", angle=naming.layout(Letter(name)))


def _is_certain(bound: Link, known: Mapping[str, Role], facts: tuple[Link, ...]) -> bool:
    """Whether a bound holds for letters of these roles under what is given."""

    def symbol(name: str) -> sp.Symbol:
        return known.get(name, REAL).symbol(name)

    try:
        claim, *given = (
            compared(evaluate(link.left, symbol), link.sign, evaluate(link.right, symbol))
            for link in (bound, *facts)
        )
    except (RestitutionError, TypeError, ValueError):
        return False
    return Oracle(known, tuple(given)).proves(claim)


def _with_decimal(value: Expression, naming: Naming) -> lay.Layout:
    """A value with its decimal, as answers have it."""
    exact, added = naming.layout(value), as_answer(value)
    if not added:
        return exact
    return lay.Relation((exact, *(e for e, _ in added)), tuple(s for _, s in added))


def _may_agree(claimed: Expression, value: Expression) -> bool:
    """Whether two values in letters may be equal for some: their ratio is no number."""
    if not letters(claimed) | letters(value):
        return False
    try:
        ends: list[Any] = [in_letters(tree, positive=True) for tree in (claimed, value)]
    except RestitutionError:
        return True
    if not all(isinstance(end, sp.Expr) and end != 0 for end in ends):
        return True
    return bool(tidy(ends[0] / ends[1]).free_symbols)


def _scalar_product(note: Note) -> tuple[Link, ...] | None:
    """The scalar product of the two velocities of an instance, which is not zero."""
    if len(note.sides) != 2 or any(not isinstance(e.left, Quantity) for e in note.sides):
        return None
    try:
        vectors = [in_letters(side.right, positive=True) for side in note.sides]
    except RestitutionError:
        return None
    if not all(isinstance(vector, Vector) for vector in vectors):
        return None
    value = tidy(vectors[0].dot(vectors[1]))
    whole = Quantity("dot", tuple(side.left for side in note.sides))
    if value == 0:
        return None
    return Link(whole, "=", tree_of(value)), Link(tree_of(value), "!=", ZERO)


def _bounds_of_letters(derivation: Derivation, part: str | None) -> Iterator[Link]:
    """What is given of letters alone in a part, as ``0 < e`` and ``e < 1``."""
    for link in given_links(derivation, part):
        if not has_quantity(link.left) and not has_quantity(link.right):
            yield link


def _differ(
    claimed: Expression, value: Expression, naming: Naming, facts: tuple[Link, ...]
) -> bool:
    """Whether two values in letters differ for all that the letters may be under ``facts``.

    The squares of two numbers do, or the square of the difference of two vectors is positive.
    """
    try:
        (one, other), oracle = _in_letters(naming, facts, claimed, value)
        if isinstance(one, Vector) and isinstance(other, Vector):
            apart = Vector(one.x - other.x, one.y - other.y)
            return oracle.proves(compared(sp.factor(apart.dot(apart)), ">", sp.Integer(0)))
        gap = sp.factor(sp.sympify(one, strict=True) ** 2 - sp.sympify(other, strict=True) ** 2)
    except (RestitutionError, TypeError, ValueError):
        return False
    return any(oracle.proves(compared(gap, sign, sp.Integer(0))) for sign in (">", "<"))


def _in_letters(
    naming: Naming, facts: tuple[Link, ...], *trees: Expression
) -> tuple[tuple[Any, ...], Oracle]:
    """What trees are in the letters of the statement, and the oracle of these under ``facts``."""
    known = roles(naming.problem)

    def symbol(name: str) -> sp.Symbol:
        return known.get(name, REAL).symbol(name)

    bounds = tuple(
        compared(evaluate(link.left, symbol), link.sign, evaluate(link.right, symbol))
        for link in facts
    )
    return tuple(evaluate(tree, symbol) for tree in trees), Oracle(known, bounds)


def _squared(tree: Expression) -> Expression:
    """The square of a value as it stands: what is under a root, factor by factor."""
    match tree:
        case Negate(operand):
            return _squared(operand)
        case Apply("sqrt", inside):
            return inside
        case Binary("*" | "/" as op, left, right):
            return Binary(op, _squared(left), _squared(right))
        case Number(value):
            return Number(value**2)
    return square(tree)


def difference_of(
    claimed: Expression, value: Expression, naming: Naming, facts: tuple[Link, ...]
) -> Relation | None:
    """The difference of two values in letters, or of their squares, as factors, and its sign.

    None of vectors, and where the sign is not certain.
    """
    try:
        (one, other), oracle = _in_letters(naming, facts, value, claimed)
        if isinstance(one, Vector) or isinstance(other, Vector):
            return None
        sides = [sp.sympify(end, strict=True) for end in (one, other)]
        has_root = any(power.exp.q != 1 for end in sides for power in _powers(end))
        if has_root:
            sides = [sp.expand(end**2) for end in sides]
        gap = min(_as_factors(sides[0] - sides[1]), key=sp.count_ops)
        signs: tuple[Sign, ...] = (">", "<")
        sign = next((e for e in signs if oracle.proves(compared(gap, e, sp.Integer(0)))), None)
        trees = [_squared(end) for end in (value, claimed)] if has_root else [value, claimed]
        whole = tree_of(tidy(gap))
    except (RestitutionError, ArithmeticError, TypeError, ValueError):
        return None
    if sign is None:
        return None
    links = Link(difference(*trees), "=", whole), Link(whole, sign, ZERO)
    return Relation((links,))


def _powers(value: sp.Expr) -> set[sp.Pow]:
    return {power for power in value.atoms(sp.Pow) if power.exp.is_Rational}


def _as_factors(gap: sp.Expr) -> Iterator[sp.Expr]:
    """A difference as a product, with sines or with cosines alone in its factors."""
    for one, other in ((sp.sin, sp.cos), (sp.cos, sp.sin)):
        put = sp.expand(gap).replace(
            lambda own, one=one: own.is_Pow and own.exp == 2 and own.base.func is one,
            lambda own, other=other: 1 - other(own.base.args[0]) ** 2,
        )
        yield sp.factor(sp.expand(put))


def _link_of(derivation: Derivation, number: int) -> Link:
    """A line as one link, from its first side to its last."""
    line = derivation.line(number)
    assert line is not None
    assert isinstance(line.relation, Relation)
    links = line.relation.only
    return Link(links[0].left, links[0].sign, links[-1].right)


def _sides_of(
    note: Note, left: Expression, right: Expression, how: str
) -> tuple[Expression, Expression]:
    """The two directions of a claim, with the stages that are meant."""
    if note.claim is None:
        return left, right
    link = note.claim.only[0]
    turned = how == "opposite to" and isinstance(link.right, Negate)
    return link.left, link.right.operand if turned else link.right  # type: ignore[union-attr]


def _side(link: Link, naming: Naming) -> lay.Relation:
    """``tan β = 3/4 = 0.75``: what a letter or a quantity is worth.

    What is worth itself, as ``u/3``, is not said twice.
    """
    value = naming.layout(link.right)
    added = as_answer(link.right) if link.sign == "=" else ()
    # A decimal that was typed stands as such: its decimal is not said again.
    added = tuple(form for form in added if form[0] != value)
    operands = [naming.layout(link.left), value, *(e for e, _ in added)]
    signs = [lay.SIGNS.get(link.sign, link.sign), *(s for _, s in added)]
    if operands[0] == operands[1]:
        del operands[0], signs[0]
    return lay.Relation(tuple(operands), tuple(signs))
