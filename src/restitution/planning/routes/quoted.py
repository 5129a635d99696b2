"""What is given of a quantity that stands in letters already: the two are equal."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import (
    Link,
    Meaning,
    Move,
    MoveId,
    Ref,
    Relation,
    numbers_in,
)
from restitution.explaining.lines.trees import exchanged
from restitution.expression.quantities import ENERGIES, UNSIGNED_ANGLES
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Quantity,
    has_quantity,
    is_binary,
    is_quantity,
    letters,
    quantities_in,
    walk,
)
from restitution.planning.formulas.shares_left import as_a_loss
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import product_without, square, tree_of
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene

QUOTED = ENERGIES | {"speed", "impulse"}
"""The quantities that are quoted from the line that has them in letters."""


def quoted(scene: Scene, equation: GivenEquation, quantity: Quantity) -> int | None:
    """What is given of a quantity that stands in letters already: the two are equal."""
    turned = quantity.kind in UNSIGNED_ANGLES
    if quantity.kind not in QUOTED and not turned:
        return None
    if turned and (line := _by_a_sum(scene, equation, quantity)) is not None:
        return line
    return quoted_as(scene, equation, Apply("tan", quantity) if turned else quantity)


def _by_a_sum(scene: Scene, equation: GivenEquation, quantity: Quantity) -> int | None:
    """An angle that is given, put into a line that has it as a sum: 45° + θ = 75°.

    So θ is 30°, and that goes into the line of its tangent in letters, tan θ = e.
    """
    for line in reversed(scene.desk.lines):
        match line.relation, equation.link.right:
            case (
                Relation(((Link(left, "=", sum_), *_),)),
                Degrees() as given,
            ) if left == quantity and scene.desk.holds(line.number):
                pass
            case _:
                continue
        match sum_:
            case Binary("+", Degrees() as first, Letter(name) as angle):
                size = given.value - first.value
            case Binary("-", Letter(name) as angle, Degrees() as first):
                size = given.value + first.value
            case _:
                return None
        meant = tuple(scene.desk.introducing({name}))
        tangent = _standing_tangent(scene, Apply("tan", angle))
        if tangent is None or not 0 < size < 90:
            return None
        right = scene.desk.last_link(tangent).right
        mark = scene.desk.mark()
        steps: list[tuple[MoveId, tuple[Ref, ...], Relation]] = [
            ("put", (line.number, equation.fact.id, *meant), chain(sum_, (given, None))),
            ("rearrange", (), chain(angle, (Degrees(size), None))),
            ("put", (tangent, *meant), chain(Apply("tan", Degrees(size)), (right, None))),
        ]
        last: int | None = None
        for move, refs, relation in steps:
            above = () if last is None else (last,)
            last = scene.judge.write((Move(move),), (*refs, *above), relation)
            if last is None:
                scene.desk.back(mark)
                return None
        return last
    return None


def quoted_ratio(scene: Scene, equation: GivenEquation) -> int | None:
    """What is given of the ratio of two quantities that an item above has in letters.

    From ``loss/energy before = ½ cos²α`` and a loss of a quarter of that energy it is
    ``½ cos²α = ¼``: neither of the two is worked out again.
    """
    left, right = equation.link.left, equation.link.right
    match left:
        case Quantity() as one:
            others = set(quantities_in(right))
            other = next(iter(others)) if len(others) == 1 else None
            share = None if other is None else product_without(right, other)
        case Binary("/", Quantity() as one, Quantity() as other):
            share = right
        case _:
            return None
    if other is None or share is None or has_quantity(share):
        return None
    for end in reversed(scene.desk.ends):
        if not scene.desk.holds(end.line) or len(scene.desk.relation(end.line).options) > 1:
            continue
        own, of_the_loss = scene.desk.last_link(end.line), None
        if own.sign != "=" or has_quantity(own.right):
            continue
        if own.left != Binary("/", one, other):
            of_the_loss = as_a_loss(scene, equation.link, own.left)
            if of_the_loss is None:
                continue
        value, refs = scene.put(scene.scalar(own.right))
        if not scene.unknown(value) or has_root(value):
            continue
        mark, own_share = scene.desk.mark(), share
        given: Ref | None = equation.fact.id
        if of_the_loss is not None:
            # What is left tells what is lost.
            lost, defined = of_the_loss
            pool = (equation.fact.id, defined, *equation.lets)
            given = scene.judge.write((Move("put"),), pool, Relation(((lost,),)))
            own_share = tree_of(1 - scene.scalar(share))
        relation = chain(own.right if not refs else tree_of(value), (own_share, None))
        if given is not None:
            pool = (given, end.line, *equation.lets, *refs)
            written = scene.judge.write((Move("put"),), pool, relation)
            if written is not None:
                return written
        scene.desk.back(mark)
    return None


def has_root(value: sp.Expr) -> bool:
    """Whether letters stand below a root: then the squares of components are simpler."""
    roots = sp.sympify(value, strict=True).atoms(sp.Pow)
    return any(root.exp.is_Rational and root.exp.q == 2 and root.free_symbols for root in roots)


def quoted_sum(scene: Scene, equation: GivenEquation) -> int | None:
    """What is given of a sum, or of a difference, that a line above has in letters.

    The energy that one sphere loses is a difference, too. The values of letters go in first.
    """
    left, right = equation.link.left, equation.link.right
    if not is_binary(left, "+", "-") or has_quantity(right):
        return None
    known = scene.desk.known(left) or _as_answered(scene, left)
    lines = () if known is None else numbers_in(known.refs)
    if known is None or len(lines) != 1 or not scene.unknown(known.value):
        return None
    value, refs = scene.put(known.value)
    if has_root(value):
        return None
    mark, line = scene.desk.mark(), lines[0]
    if refs:
        put = chain(left, (tree_of(value), None))
        line = scene.judge.write((Move("put"),), (line, *refs), put) or line
    relation = chain(tree_of(value) if refs else scene.desk.last_link(line).right, (right, None))
    pool = (line, equation.fact.id, *equation.lets)
    written = scene.judge.write((Move("combine"),), pool, relation)
    if written is None:
        scene.desk.back(mark)
    return written


def quoted_as(scene: Scene, equation: GivenEquation, subject: Expression) -> int | None:
    """The same of what stands as a quantity, as its tangent, or as a letter for it."""
    turned = isinstance(subject, Apply) and not isinstance(equation.link.left, Apply)
    if has_quantity(equation.link.right):
        return None
    squared = _by_its_square(scene, equation, subject)
    if squared is not None:
        return squared
    known = as_shown(scene, subject) or scene.desk.known(subject)
    if known is None and turned and isinstance(subject, Apply):
        return _by_its_tangent(scene, equation, subject.argument)
    if known is None:
        return None
    if not scene.unknown(known.value) and not _ties_letters(scene, known):
        return None
    if has_root(known.value):
        plain = _without_its_root(scene, equation, known)
        return _squared_as(scene, equation, subject, known) if plain is None else plain
    value, refs = scene.put(known.value)
    right, more = scene.put(scene.scalar(equation.link.right))
    if turned and (more or right == sp.pi / 2):
        return None
    tree = equation.link.right if not more else tree_of(right)
    tree = tree_of(tidy(sp.tan(right))) if turned else tree
    relation = chain(tree, (tree_of(value), None))
    lines = numbers_in(known.refs)
    names = {name for number in lines for name in letters(scene.desk.last_link(number).right)}
    lets = tuple(f"let {name}" for name in sorted(names) if f"let {name}" in scene.facts)
    premises = scene.judge.enough(
        Move("put"),
        (*known.refs, equation.fact.id),
        relation,
        together(equation.lets, lets, refs, more),
    )
    return None if premises is None else scene.desk.write(Move("put"), premises, relation)


def _ties_letters(scene: Scene, known: Source) -> bool:
    """Whether a value that was shown is an equation of letters of the data that are left open.

    So it is where a range of one of them is asked.
    """
    shown = {end.line for end in scene.desk.ends if end.shown}
    return set(known.refs) <= shown and bool(scene.put(known.value)[0].free_symbols)


def _by_its_square(scene: Scene, equation: GivenEquation, subject: Expression) -> int | None:
    """A given speed, put into the line of its square; None of all else, and where its root is."""
    known = scene.desk.known(square(subject)) if is_quantity(subject, "speed") else None
    if known is None or scene.desk.known(subject) is not None or not scene.unknown(known.value):
        return None
    (line, *more) = known.refs
    own = scene.desk.last_link(line) if isinstance(line, int) and not more else None
    value, refs = scene.put(known.value)
    if own is None or own.left != square(subject):
        return None
    pool = (line, equation.fact.id, *equation.lets, *refs)
    for right in (tree_of(value), _with_letters_put(scene, own.right)) if refs else (own.right,):
        relation = chain(square(equation.link.right), (right, None))
        written = scene.judge.write((Move("put"),), pool, relation)
        if written is not None:
            return written
    return None


def _with_letters_put(scene: Scene, tree: Expression) -> Expression:
    """An expression with the values of its letters, which is not worked out."""
    values: dict[Expression, Expression] = {}
    for name in letters(tree):
        own = Letter(name)
        value, refs = scene.put(scene.scalar(own))
        if refs:
            values[own] = tree_of(value, angle=True)
    return exchanged(tree, values)


def as_shown(scene: Scene, subject: Expression) -> Source | None:
    """A value as it was to be shown, where it is known in that form: what is printed is quoted."""
    known = scene.desk.known(subject)
    for end in scene.desk.ends if known is not None else ():
        if not end.shown or not scene.desk.holds(end.line):
            continue
        own = scene.desk.relation(end.line)
        if len(own.options) > 1 or own.only[0].left != subject or own.only[0].sign != "=":
            continue
        value = scene.scalar(own.only[-1].right)
        if scene.model.identically_zero(value - known.value):  # type: ignore[union-attr]
            return Source(value, (end.line,))
    return None


def _as_answered(scene: Scene, subject: Expression) -> Source | None:
    """What an item above says of an expression of quantities, in letters; None without one."""
    for end in reversed(scene.desk.ends):
        if not scene.desk.holds(end.line) or len(scene.desk.relation(end.line).options) > 1:
            continue
        own = scene.desk.last_link(end.line)
        if (own.left, own.sign) == (subject, "=") and not has_quantity(own.right):
            return Source(scene.scalar(own.right), (end.line,))
    return None


def _by_its_tangent(scene: Scene, equation: GivenEquation, angle: Expression) -> int | None:
    """The value of an angle that is given, put into a line that has its tangent in letters."""
    value, more = scene.put(scene.scalar(equation.link.right))
    tangent = tidy(sp.tan(value))
    if more or has_quantity(equation.link.right) or not tangent.is_number or not tangent.is_finite:
        return None
    for meaning in scene.desk.lines:
        if not isinstance(meaning.relation, Meaning) or meaning.relation.quantity != angle:
            continue
        letter = Letter(meaning.relation.letter)
        line = _standing_tangent(scene, Apply("tan", letter))
        if line is None:
            continue
        left = scene.desk.last_link(line).right
        if not scene.unknown(scene.scalar(left)):
            continue
        mark = scene.desk.mark()
        equal = chain(letter, (equation.link.right, None))
        pool = equation.fact.id, meaning.number
        fact = scene.judge.write((Move("fact"),), pool, equal)
        relation = chain(left, (tree_of(tangent), None))
        if isinstance(equation.link.right, Degrees):
            own = Apply("tan", equation.link.right)
            relation = chain(left, (own, None), (tree_of(tangent), "rearrange"))
        put = fact and scene.judge.write((Move("put"),), (line, fact), relation)
        if put:
            return put
        scene.desk.back(mark)
    return None


def _standing_tangent(scene: Scene, tangent: Apply) -> int | None:
    """The last line in force that gives a tangent in letters."""
    for line in reversed(scene.desk.lines):
        own = line.relation
        if not isinstance(own, Relation) or len(own.options) > 1 or own.only[0].left != tangent:
            continue
        plain = all(link.sign == "=" for link in own.only)
        if plain and not has_quantity(own.only[-1].right) and scene.desk.holds(line.number):
            ratios = [node for node in walk(own.only[-1].right) if isinstance(node, Apply)]
            meant = scene.desk.meanings([line.number])
            named = {scene.desk.line(number).relation.letter for number in meant}  # type: ignore[union-attr]
            return None if any(named & letters(node) for node in ratios) else line.number
    return None


def _without_its_root(scene: Scene, equation: GivenEquation, known: Source) -> int | None:
    """What is given of a quantity that stands as a root, where equal letters leave none in it."""
    ties = {symbol: scene.put(symbol)[0] for symbol in known.value.free_symbols}
    equal = {one: other for one, other in ties.items() if other.is_Symbol and one != other}
    lines = numbers_in(known.refs)
    if not equal or len(lines) != 1:
        return None
    value, (right, more) = known.value.subs(equal), scene.put(scene.scalar(equation.link.right))
    angles = {ratio.args[0]: sp.Dummy("c", positive=True) for ratio in value.atoms(sp.sin, sp.cos)}
    put = {sp.cos(value): c for value, c in angles.items()}
    put |= {sp.sin(value): sp.sqrt(1 - c**2) for value, c in angles.items()}
    plain = tidy(sp.sqrt(expanded(value.xreplace(put) ** 2)))
    if more or has_root(plain) or plain.atoms(sp.Dummy):
        return None
    refs = (ref for symbol in equal for ref in scene.put(symbol)[1])
    names = symbol_names(value)
    letters_: dict[Expression, Expression] = {
        Letter(one.name): Letter(other.name) for one, other in equal.items()
    }
    tree = exchanged(scene.desk.last_link(lines[0]).right, letters_)
    relation = chain(tree_of(right), (tree, None), (tree_of(plain), "identity"))
    pool = together(known.refs, (equation.fact.id,), refs)
    premises = scene.judge.enough(Move("put"), pool, relation, background(scene, names))
    return None if premises is None else scene.desk.write(Move("put"), premises, relation)


def _squared_as(
    scene: Scene, equation: GivenEquation, subject: Expression, known: Source
) -> int | None:
    """What is given of a speed that stands as one root: the squares are equal; None of another."""
    value, refs = scene.put(known.value)
    squared = tidy(value**2)
    _, more = scene.put(scene.scalar(equation.link.right))
    lines = numbers_in(known.refs)
    if refs or more or has_root(squared) or len(lines) != 1:
        return None
    if not is_quantity(subject, "speed"):
        return None
    names = symbol_names(squared)
    pool = (lines[0], *background(scene, names))
    relation = chain(square(subject), (tree_of(squared), None))
    line = scene.judge.write((Move("rearrange"),), pool, relation)
    if line is None:
        return None
    relation = chain(square(equation.link.right), (tree_of(squared), None))
    return scene.judge.write((Move("put"),), (line, equation.fact.id, *equation.lets), relation)
