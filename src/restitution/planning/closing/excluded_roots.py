"""Roots that the conditions exclude, and the lines from which that follows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import sympy as sp

from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Link, Meaning, Move, Ref, Relation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    COMPONENTS,
    Expression,
    Letter,
    Name,
    Quantity,
    is_function,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.closing.bounded_speeds import bounds_that_stand
from restitution.planning.formulas.impacts import (
    in_direction,
    momentum,
    residual,
    restitution,
)
from restitution.planning.formulas.velocity_formulas import velocity_source
from restitution.planning.writing.desk import NotPlannedError, together
from restitution.planning.writing.forms import (
    is_in_degrees,
    tree_of,
)
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene


def option(subject: Expression, value: sp.Expr) -> tuple[Link, ...]:
    """One of the alternatives, as a line has it."""
    if is_in_degrees(value):
        return (Link(subject, "=", tree_of(sp.factor_terms(value), as_it_is=True)),)
    return (Link(subject, "=", tree_of(value)),)


def rejected(
    scene: Scene,
    line: int,
    symbol: sp.Symbol,
    subject: Expression,
    kept: Sequence[sp.Expr],
) -> int:
    """The line of what remains, with what excludes the rest: the line that was squared may."""
    relation = Relation(tuple(option(subject, value) for value in kept))
    move = Move("reject")
    own = background(scene, {symbol.name})
    component = _is_component(scene, symbol)
    bare = _likely(scene, symbol, own)
    if not component and scene.judge.follows(move, (line, *bare), relation):
        return scene.desk.write(move, (line, *bare), relation)
    with_others = (*own, *background(scene, _others(scene, line, symbol)))
    if not component and len(with_others) > len(own):
        refs = scene.judge.enough(move, (line,), relation, with_others)
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    unsquared = _unsquared(scene, line, symbol)
    if unsquared:
        refs = scene.judge.enough(move, (line,), relation, (*unsquared, *own))
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    senses_ = senses(scene, symbol)
    if senses_:
        refs = scene.judge.enough(move, (line,), relation, (*senses_, *own))
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    if (pushed := _pushed(scene, symbol)) and scene.judge.follows(move, (line, *pushed), relation):
        refs = scene.judge.enough(move, (line,), relation, pushed)
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    laws = _laws(scene, symbol) if component else ()
    names = {symbol.name}
    for value in kept:
        names |= symbol_names(value)
    for ref in laws:
        names |= symbol_names(residual(scene, ref))  # type: ignore[arg-type]
    rest = [ref for ref in background(scene, names) if ref not in own]
    for premises in (*_by_one_law(scene, laws, rest), *_by_laws(laws, rest)):
        if scene.judge.follows(move, (line, *premises), relation):
            return scene.desk.write(move, (line, *premises), relation)
    facts = [ref for ref in scene.judge.known(names) if ref in scene.facts]
    for ground in (*_bearings(scene, line), *_approaches(scene, line, symbol)):
        refs = scene.judge.enough(move, (line,), relation, ground)
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    for sense in _senses_of_components(scene, symbol):
        refs = scene.judge.enough(move, (line,), relation, (*sense, *own))
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    for bound in bounds_that_stand(scene):
        refs = scene.judge.enough(move, (line,), relation, (*bound, *own))
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    for tied in _tied_letters(scene, line, symbol):
        refs = scene.judge.enough(move, (line,), relation, tied)
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    pool = (*own, *laws, *_values(scene, laws), *rest, *facts)
    refs = scene.judge.enough(move, (line,), relation, pool)
    if refs is None and scene.out_of_range:
        return line  # what excludes all roots tells none from the others
    if refs is None:
        raise NotPlannedError(f"nothing excludes a value of {symbol}")
    return scene.desk.write(move, refs, relation)


def _others(scene: Scene, line: int, symbol: sp.Symbol) -> set[str]:
    """The letters in the values of some roots."""
    options = scene.desk.relation(line).options
    return {name for links in options for name in letters(links[-1].right)} - {symbol.name}


def _tied_letters(scene: Scene, line: int, symbol: sp.Symbol) -> Iterator[tuple[Ref, ...]]:
    """Each line above some roots that gives another letter by this one, with what that may be."""
    for ref in sorted((e for e in scene.desk.under(line) if isinstance(e, int)), reverse=True):
        own = scene.desk.line(ref).relation
        if isinstance(own, Meaning) or len(own.options) != 1:
            continue
        match own.only:
            case (Link(Letter(name), "="), *_) if symbol.name in letters(own.only[-1].right):
                yield (ref, *background(scene, {name}))


def _unsquared(scene: Scene, line: int, symbol: sp.Symbol) -> tuple[Ref, ...]:
    """The line above some roots in which the unknown stands below a root: it was squared."""
    for ref in sorted((e for e in scene.desk.under(line) if isinstance(e, int)), reverse=True):
        own = scene.desk.line(ref).relation
        if isinstance(own, Meaning) or len(own.options) != 1:
            continue
        nodes = [node for tree in trees_of(own) for node in walk(tree)]
        if any(is_function(node, "sqrt") and symbol.name in letters(node) for node in nodes):
            return (ref,)
    return ()


def _bearings(scene: Scene, line: int) -> Iterator[tuple[Ref, ...]]:
    """Each direction that is given of a velocity, with the lines above some roots that tell it.

    A root at which the body would be at rest is excluded, as it would have no direction.
    """
    above = sorted((ref for ref in scene.desk.under(line) if isinstance(ref, int)), reverse=True)
    for equation in scene.given:
        match equation.link:
            case Link(left, "parallel to" | "perpendicular to", right):
                velocities = {side for side in (left, right) if is_quantity(side, "velocity")}
            case _:
                continue
        for velocity in velocities:
            own = [ref for ref in above if _is_about(scene, ref, velocity)]
            yield (*equation.refs, *own)


def _is_about(scene: Scene, ref: int, quantity: Expression) -> bool:
    """Whether a line is an equation for a quantity."""
    relation = scene.desk.line(ref).relation
    return isinstance(relation, Relation) and all(
        links[0].left == quantity and links[0].sign == "=" for links in relation.options
    )


def _approaches(scene: Scene, line: int, symbol: sp.Symbol) -> Iterator[tuple[Ref, ...]]:
    """That spheres approach each other, of which one has an open component at the start.

    With it where they are then, and the lines under this one that tie the components. The component
    may be a letter of the data.
    """
    for number in scene.model.frames:
        if f"approach {number}" in scene.facts:
            moving = (f"velocity {body}" for body in scene.spheres(number))
            start = (ref for ref in moving if ref in scene.facts)
            yield (f"approach {number}", *start, *scene.frame(number).refs)
    lets = [
        line.number
        for line in scene.desk.lines
        if isinstance(line.relation, Meaning) and isinstance(line.relation.quantity, Quantity)
    ]
    named = {scene.desk.line(number).relation.letter for number in lets}  # type: ignore[union-attr]
    if symbol.name not in named:
        return
    tied = [ref for ref in scene.desk.under(line) if isinstance(ref, int)]
    for number in scene.model.frames:
        bodies = scene.spheres(number)
        facts = [f"{kind} {body}" for body in bodies for kind in ("position", "velocity")]
        places = [scene.desk.known(Quantity("position", (Name(e),), number)) for e in bodies]
        stands = [ref for place in places if place is not None for ref in place.refs]
        own = [f"towards {number}", *(ref for ref in facts if ref in scene.facts)]
        if own[0] in scene.facts:
            yield tuple(dict.fromkeys((*own, *stands, *lets, *sorted(tied))))


def _likely(scene: Scene, symbol: sp.Symbol, own: tuple[Ref, ...]) -> tuple[Ref, ...]:
    """What excludes the other root of two: a coefficient is not negative, an angle in its range."""
    role = scene.model.unknowns.roles.get(symbol.name)
    if role is not None and role.kind == "restitution":
        return own[:1]
    return own


def _by_one_law(
    scene: Scene, laws: tuple[Ref, ...], rest: Sequence[Ref]
) -> Iterable[tuple[Ref, ...]]:
    """The same of one law, where it holds no other component: the later one first.

    A law alone excludes what only contradicts a letter that is positive, which nothing says: so
    that comes last.
    """
    components = {component.symbol for component in scene.model.components.values()}
    alone: list[tuple[Ref, ...]] = []
    for law in reversed(laws):
        letters = residual(scene, law).free_symbols  # type: ignore[arg-type]
        if len(letters & components) > 1:
            continue
        names = {letter.name for letter in letters}
        own = [ref for ref in rest if any(name in str(ref).split() for name in names)]
        alone.append((law,))
        for sign in (">= 0", "<= 1"):
            angles = [ref for ref in own if not str(ref).endswith(("= 0", "= 1"))]
            ends = [ref for ref in own if str(ref).endswith(sign)]
            if ends or angles:
                yield (law, *ends, *angles)
    yield from alone


def _by_laws(laws: tuple[Ref, ...], rest: Sequence[Ref]) -> Iterable[tuple[Ref, ...]]:
    """Sets of premises that may exclude a sense of a component: both laws, and 0 ≤ e ≤ 1."""
    if not laws:
        return
    angles = tuple(ref for ref in rest if not str(ref).endswith(("= 0", "= 1")))
    low = tuple(ref for ref in rest if str(ref).endswith(">= 0"))
    high = tuple(ref for ref in rest if str(ref).endswith("<= 1"))
    yield (*laws, *low, *angles)
    if high:
        yield (*laws, *high, *angles)


def _is_component(scene: Scene, symbol: sp.Symbol) -> bool:
    return any(component.symbol == symbol for component in scene.model.components.values())


def _laws(scene: Scene, symbol: sp.Symbol) -> tuple[Ref, ...]:
    """The laws of the impact after which a component is: they may exclude a sense of it."""
    for (number, _), component in scene.model.components.items():
        if component.symbol == symbol:
            frame = scene.frame(number)
            if frame.wall is None:
                first, second = (
                    written_law(scene, record, number) or write(scene, frame)
                    for record, write in (("momentum", momentum), ("restitution", restitution))
                )
                return second, first
    return ()


def _pushed(scene: Scene, symbol: sp.Symbol) -> tuple[Ref, ...]:
    """What tells that a sphere had no component along the line of centres, and what its letter is.

    It is pushed away from the other sphere. Empty where it had one, or is not known to have none.
    """
    for (number, body), component in scene.model.components.items():
        own = scene.model.frames.get(number)
        if component.symbol != symbol or own is None or own.wall is not None:
            continue
        early = in_direction(scene, "along", body, number - 1, scene.frame(number))
        if early.value != 0:
            return ()
        lets = [
            line.number
            for line in scene.desk.lines
            if isinstance(line.relation, Meaning) and line.relation.letter == symbol.name
        ]
        return together(early.whole, lets)
    return ()


def written_law(scene: Scene, record: str, number: int) -> int | None:
    """The line of a law of an impact, where it stands already."""
    move = Move("law", record, number, scene.bodies(number))
    for line in scene.desk.lines:
        if line.move == move and scene.desk.holds(line.number):
            return line.number
    return None


def _values(scene: Scene, laws: Sequence[Ref]) -> tuple[Ref, ...]:
    """The lines that give values of letters in laws."""
    refs: list[Ref] = []
    for line in laws:
        for symbol in residual(scene, line).free_symbols:  # type: ignore[arg-type]
            known = scene.desk.known(Letter(symbol.name))
            if known is not None:
                refs += known.refs
    return tuple(dict.fromkeys(refs))


def _senses_of_components(scene: Scene, symbol: sp.Symbol) -> Iterator[tuple[Ref, ...]]:
    """What is given of the senses of components that lines tell by a letter: of one, of all."""
    every: list[tuple[Ref, ...]] = []
    for (event, body), component in scene.model.components.items():
        own = scene.desk.known(Letter(component.symbol.name))
        if own is None or symbol not in sp.sympify(own.value, strict=True).free_symbols:
            continue
        facts = senses(scene, component.symbol)
        if facts:
            early, late = (velocity_source(scene, body, k) for k in (event - 1, event))
            every.append(together(own.refs, facts, early.refs, late.refs))
            yield every[-1]
    if len(every) > 1:
        yield together(*every)


def senses(scene: Scene, symbol: sp.Symbol) -> tuple[Ref, ...]:
    """Facts about the sense, or the range, of what a letter is, and what introduces the letter."""
    refs: list[Ref] = []
    bodies = {
        body
        for (_, body), component in scene.model.components.items()
        if component.symbol == symbol
    }
    for fact in scene.desk.facts:
        if not scene.desk.holds(fact.id) or not fact.id.startswith(("given", "sense")):
            continue
        nodes = [
            node
            for links in fact.relation.options
            for link in links
            for side in (link.left, link.right)
            for node in walk(side)
        ]
        about = any(
            is_quantity(node, "velocity", "direction", *COMPONENTS)
            and any(Name(body) in walk(node) for body in bodies)
            for node in nodes
        )
        ordered = any(
            link.sign in ("<", "<=", ">", ">=", "!=")
            for links in fact.relation.options
            for link in links
        )
        ranged = ordered and Letter(symbol.name) in nodes
        if about or ranged:
            refs.append(fact.id)
    if refs:
        known = [
            line.number
            for line in scene.desk.lines
            if line.move.id == "let" and getattr(line.relation, "letter", None) == symbol.name
        ]
        axes = [
            ref
            for (number, _), component in scene.model.components.items()
            if component.symbol == symbol
            for ref in scene.frame(number).refs
        ]
        return (*refs, *axes, *known)
    return ()
