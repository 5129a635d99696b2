"""Directions that are tied to each other: a right angle or a common direction, in components."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation
from restitution.expression.tree import (
    COMPONENTS,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Polar,
    Quantity,
    Unit,
    has_root,
    letters,
    walk,
)
from restitution.planning.formulas.components_of_data import is_polar
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.velocity_formulas import (
    body_and_stage,
    frame_after,
    in_the_plane,
)
from restitution.planning.formulas.whereabouts import source_of
from restitution.planning.writing.desk import NotPlannedError, Source, link, together
from restitution.planning.writing.forms import ONE, ZERO, product, square, swept, total, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.planning.writing.unit_vectors import whole_direction
from restitution.vector import Vector


def write_tie(scene: Scene, equation: GivenEquation) -> int:
    """The line in which a tie of directions becomes an equation."""
    number = _tie(scene, equation)
    _know_what_vanishes(scene, equation, number)
    return number


def _know_what_vanishes(scene: Scene, equation: GivenEquation, number: int) -> None:
    """Takes a component that is zero for known, where its line has it in other letters.

    It is not worked out from what these come to.
    """
    line = scene.desk.line(number)
    (own, *more) = scene.desk.relation(number).only
    if more or own.right != ZERO or line.move.event not in scene.model.frames:
        return
    for body in line.move.bodies:
        component = scene.model.components.get((line.move.event or 0, body))
        letter = None if component is None else Letter(component.symbol.name)
        known = None if letter is None else scene.desk.known(letter)
        if letter is None or known is None or not known.value.free_symbols:
            continue
        if tree_of(known.value) != own.left:
            continue
        lets = scene.desk.introducing({letter.name})
        pool = together(equation.refs, lets, scene.frame(line.move.event or 0).refs)
        nothing = Relation(((link(letter, ZERO),),))
        zero = scene.judge.write((line.move,), pool, nothing, shown="silent")
        if zero is not None:
            scene.desk.know(letter, sp.Integer(0), (zero,))


def _tie(scene: Scene, equation: GivenEquation) -> int:
    left, right, record = tied(equation.link) or (equation.link.left, equation.link.right, "")
    pair = [moving(scene, side) for side in (left, right)]
    both = [own for own in pair if own is not None]
    if len(both) == 2:
        return _two_velocities(scene, equation, record, both)
    if not both:
        raise NotPlannedError("a tie of two directions that are given")
    other = right if pair[0] is not None else left
    return _to_a_direction(scene, equation, record, both[0], other)


def tied(own: Link) -> tuple[Expression, Expression, str] | None:
    """The two directions of a relation, and whether they are perpendicular or parallel."""
    if own.sign in ("perpendicular to", "parallel to"):
        return own.left, own.right, own.sign.removesuffix(" to")
    if own.sign != "=":
        return None
    match own.left, own.right:
        case Quantity("direction", (Name() as body,), int(stage)), angle:
            velocity = Quantity("velocity", (body,), stage)
            return velocity, Polar(ONE, angle), "parallel"
        case Quantity("deflection", (body,), int(stage)), _:
            early, late = (Quantity("velocity", (body,), n) for n in (stage - 1, stage))
            return early, late, _record(own.right)
        case Quantity("angle", (a, b)), _:
            return a, b, _record(own.right)
    return None


def _record(angle: Expression) -> str:
    """What an angle of 0°, 90° or 180° says of two directions."""
    straight = isinstance(angle, Degrees) and angle.value in (0, 180)
    return "parallel" if straight else "perpendicular"


def moving(scene: Scene, tree: Expression) -> tuple[str, int] | None:
    """The body and the event of a velocity; None for a direction in the plane."""
    match tree:
        case Negate(operand):
            return moving(scene, operand)
        case Quantity("velocity" | "direction", (Name(body),), int()):
            if body in scene.model.story.walls:
                return None
            return body_and_stage(scene, tree)
    return None


def _two_velocities(
    scene: Scene, equation: GivenEquation, record: str, both: list[tuple[str, int]]
) -> int:
    frame = frame_after(scene, *max(both, key=lambda own: own[1]))
    sources = _as_vectors(scene, both) if frame.is_slanted else None
    if sources is None:
        sources = [
            [in_direction(scene, kind, name, when, frame) for kind in COMPONENTS]
            for name, when in both
        ]
    (a, b), (c, d) = sources
    pairs = ((a, c), (b, d)) if record == "perpendicular" else ((a, d), (b, c))
    cited = [_cited(pair) for pair in pairs]
    first, second = (_product(source.value for source in pair) for pair in cited)
    bodies = tuple(dict.fromkeys(body for body, _ in both))
    move = Move("define", record, frame.number, bodies)
    for along, still in ((a, d), (c, b)) if record == "perpendicular" else ():
        if still.value != 0 or along.value == 0:
            continue
        # Who moves along the line of centres is at right angles to who moves across it.
        read = Relation(((link(tree_of(along.value), ZERO),),))
        cites = scene.judge.needed(move, together(equation.refs, along.whole, still.whole), read)
        if cites is not None:
            return scene.desk.write(move, cites, read)
    if record == "parallel" and len(bodies) == 1 and d.value != 0:
        line = _without_what_stays(scene, equation, move, b if both[0][1] < both[1][1] else d)
        if line is not None:
            return line
    refs = together(equation.refs, *(s.refs for p in cited for s in p), _axis(frame, cited))
    quotients = _in_proportion((a, b), (c, d)) if record == "parallel" else None
    if quotients is not None:
        names = letters(quotients.left) | letters(quotients.right)
        ratio = Relation(((quotients,),))
        cites = scene.judge.enough(move, refs, ratio, background(scene, names))
        if cites is not None:
            return scene.desk.write(move, cites, ratio)
    own = link(total((first, second)), ZERO) if record == "perpendicular" else link(first, second)
    relation = Relation(((own,),))
    # Components after another event are named by the line of centres of that.
    other = [
        ref for _, stage in both if stage in scene.model.frames for ref in scene.frame(stage).refs
    ]
    refs = scene.judge.enough(move, refs, relation, other) or refs
    return scene.desk.write(move, refs, relation)


def _in_proportion(one: tuple[Source, Source], other: tuple[Source, Source]) -> Link | None:
    """Components in the same direction as quotients, which are equal: ``fu/u = eu/(2u)``.

    Those of the velocity with fewer letters stand below. None where one is a sum, or zero.
    """
    values = [sp.sympify(source.value, strict=True) for source in (*one, *other)]
    if any(value == 0 or value.is_Add or value.has(sp.Add) for value in values):
        return None
    above, below = values[:2], values[2:]
    if len(sp.Tuple(*below).free_symbols) > len(sp.Tuple(*above).free_symbols):
        above, below = below, above
    minus = [
        top.could_extract_minus_sign() != bottom.could_extract_minus_sign()
        for top, bottom in zip(above, below, strict=True)
    ]
    if any(minus) and not all(minus):
        return None
    sides = [
        Binary("/", *(tree_of(-x if x.could_extract_minus_sign() else x) for x in pair))
        for pair in zip(above, below, strict=True)
    ]
    left, right = map(swept, sides)
    return link(left, right)


def _without_what_stays(
    scene: Scene, equation: GivenEquation, move: Move, still: Source
) -> int | None:
    """The line that what an impact leaves of a velocity is zero, as that keeps its line.

    Who comes back along his path, hits a wall at right angles. None where that does not follow.
    """
    relation = Relation(((link(tree_of(still.value), ZERO),),))
    pool = (*equation.refs, *still.whole)
    refs = scene.judge.needed(move, pool, relation)
    if refs is None:  # with components of another axis
        pool = (*pool, *scene.frame(move.event or 0).refs)
        refs = scene.judge.needed(move, pool, relation)
    return None if refs is None else scene.desk.write(move, refs, relation)


def _product(values: Iterable[sp.Expr]) -> Expression:
    """Components side by side; the square of one with a root in front as such: (√5 u)²."""
    factors = list(values)
    if len(factors) > 1 and all(factor == factors[0] for factor in factors):
        number, _ = factors[0].as_coeff_Mul()
        roots = [power for power in factors[0].atoms(sp.Pow) if power.is_number]
        if number.is_Rational and roots and factors[0].free_symbols:
            return square(tree_of(factors[0]))
    return product(*map(tree_of, factors))


def _as_vectors(scene: Scene, both: list[tuple[str, int]]) -> list[list[Source]] | None:
    """The parts of velocities that are vectors of the data or of lines; None where one is not."""
    vectors = []
    for body, stage in both:
        vector = scene.desk.known(Quantity("velocity", (Name(body),), stage))
        if vector is None and (stage or is_polar(scene, body)):
            return None
        own = scene.initial(body) if vector is None else vector
        vectors.append([source_of(scene, value, own.refs) for value in own.value])
    return vectors


def _cited(pair: tuple[Source, Source]) -> tuple[Source, ...]:
    """The factor that is zero, of a product that is zero."""
    return next(((source,) for source in pair if source.value == 0), pair)


def _axis(frame: Frame, pairs: Any) -> tuple[Ref, ...]:
    """The axis, where components of vectors stand beside those that are named by it."""
    named = isinstance(frame.along, Quantity)
    plain = frame.across is not None and named
    vectors = any(source.axis for pair in pairs for source in pair)
    return frame.refs if (vectors and named) or plain else ()


def _to_a_direction(
    scene: Scene, equation: GivenEquation, record: str, own: tuple[str, int], other: Expression
) -> int:
    body, stage = own
    frame = frame_after(scene, body, stage)
    move = Move("define", record, frame.number, (body,))
    centres = other == Quantity("line_of_centres", (), frame.number)
    wall = isinstance(other, Name) and other.name == frame.wall
    if centres or wall:
        kind = "along" if (record == "perpendicular") != wall else "across"
        source = in_direction(scene, kind, body, stage, frame)
        refs = together(equation.refs, source.whole, frame.names_axis(kind))
        return scene.desk.write(move, refs, Relation(((link(tree_of(source.value), ZERO),),)))
    direction, about = _direction(scene, other)
    vector = scene.desk.known(Quantity("velocity", (Name(body),), stage))
    if frame.is_slanted and vector is None:
        return _across_a_frame(scene, equation, move, body, stage, frame, direction, about)
    if vector is not None:
        x, y = (source_of(scene, value, vector.refs) for value in vector.value)
    else:
        x, y = in_the_plane(scene, body, stage)
    refs = together(equation.refs, about)
    if record == "perpendicular":
        terms = [(x, direction.x), (y, direction.y)]
        used = [(s, w) for s, w in terms if w != 0]
        relation = link(total(product(tree_of(w), tree_of(s.value)) for s, w in used), ZERO)
    else:
        terms = [(y, direction.x), (x, direction.y)]
        used = [(s, w) for s, w in terms if w != 0]
        sides = [_multiple(w, s.value) for s, w in terms]
        left, right = sides
        relation = link(left, right) if left != ZERO else link(right, ZERO)
        if len(used) == 1:
            relation = link(tree_of(used[0][0].value), ZERO)  # whatever the size and the sense
    refs = together(refs, *(source.whole for source, _ in used))
    return scene.desk.write(move, refs, Relation(((relation,),)))


def _multiple(factor: sp.Expr, component: sp.Expr) -> Expression:
    """A component of a velocity times one of a direction: both with their signs, as read off."""
    a, b = tree_of(factor), tree_of(component)
    if isinstance(a, Negate) and isinstance(b, Negate) and a.operand != ONE:
        return Binary("*", a, b)
    return product(a, b) if factor != 0 else ZERO


def _share(factor: sp.Expr, component: sp.Expr) -> Expression:
    """The share of a component in a direction: −sin²θ, and not sin θ sin θ.

    Where the roots of both cancel, 3(λ − 6)/20 of 3/√10 and (λ − 6)/(2√10), it has none.
    """
    whole = tidy(factor * component)
    if (component / factor).is_number or (_has_surd(factor) and not _has_surd(whole)):
        return tree_of(whole)
    return product(tree_of(factor), tree_of(component))


def _has_surd(value: sp.Expr) -> bool:
    """Whether a root of a number stands in a value."""
    return any(power.is_number and not power.exp.is_Integer for power in value.atoms(sp.Pow))


def _across_a_frame(
    scene: Scene,
    equation: GivenEquation,
    move: Move,
    body: str,
    stage: int,
    frame: Frame,
    direction: Vector,
    about: tuple[Ref, ...],
) -> int:
    """By the components in the directions of an impact that slants."""
    sources = [in_direction(scene, kind, body, stage, frame) for kind in COMPONENTS]
    if move.record == "parallel":
        direction = direction.turned_left()
        if direction.y == 0 and scene.model.sign(direction.x) < 0:
            direction = -direction  # the component in the direction of **i**
    shares = [tidy(direction.dot(vector)) for vector in (frame.n, frame.t)]
    used = [(s, w) for s, w in zip(sources, shares, strict=True) if w != 0]
    used.sort(key=lambda term: tidy(term[0].value * term[1]).could_extract_minus_sign())
    refs = together(equation.refs, about, *(s.refs for s, _ in used), frame.refs)
    # In the direction of **i**, or of **j**, they are the shares of a component.
    common_ = sp.Integer(1) if 0 in direction else _common_surd([w for _, w in used])
    trees = (
        total(_share(w / common, s.value) for s, w in used) for common in (common_, sp.Integer(1))
    )
    relations = [Relation(((link(tree, ZERO),),)) for tree in trees]
    relations.sort(key=lambda own: any(map(has_root, own.trees)))
    # Without a root that both shares have, where that follows too.
    own = next((e for e in relations if scene.judge.follows(move, refs, e)), relations[-1])
    return scene.desk.write(move, refs, own)


def _common_surd(shares: list[sp.Expr]) -> sp.Expr:
    """What numbers that are all multiples of one root have in common: √2 of 4√2 and −√2; else 1."""
    if len(shares) < 2 or any(not share.is_number or share.is_rational for share in shares):
        return sp.Integer(1)
    parts = [sp.Abs(share / shares[0]) for share in shares]
    if not all(value.is_Rational for value in map(tidy, parts)):
        return sp.Integer(1)
    return tidy(sp.Abs(shares[0]) * sp.gcd_list([tidy(part) for part in parts]))


def _is_an_open_wall(scene: Scene, tree: Expression) -> bool:
    """Whether a direction is that of a wall by the one angle that is sought."""
    fact = scene.facts.get(f"wall {tree.name}") if isinstance(tree, Name) else None
    right = None if fact is None else fact.relation.only[0].right
    return right is not None and len(letters(right)) == 1


def _direction(scene: Scene, tree: Expression) -> tuple[Vector, tuple[Ref, ...]]:
    """A direction in the plane as a vector, of whole numbers where that is so, and its facts."""
    refs = tuple(
        f"wall {node.name}"
        for node in walk(tree)
        if isinstance(node, Name) and f"wall {node.name}" in scene.facts
    )
    if isinstance(tree, Unit):
        return Vector(*(sp.Integer(tree.axis == axis) for axis in "ij")), refs
    own, more = scene.put(scene.model.story.direction(tree, scene.events))
    if any(scene.unknown(value) for value in own):
        if not _is_an_open_wall(scene, tree):
            raise NotPlannedError("a tie to a direction that is open")
        return Vector(*map(tidy, own)), together(refs, more)
    whole, _ = whole_direction(own)
    return Vector(*(tidy(component) for component in whole)), together(refs, more)


__all__ = ["moving", "tied", "write_tie"]
