"""When a body touches a circular wall, or another body: along a chord, or from beside it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Link, Meaning, Move, Ref, Relation, equality
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Polar,
    Quantity,
)
from restitution.planning.closing.polynomial_trees import polynomial_tree
from restitution.planning.formulas.impacts import after, in_direction
from restitution.planning.formulas.named_angles import letters_taken
from restitution.planning.writing.circles import chord_from, circle_of, from_centre
from restitution.planning.writing.degrees import share_in_degrees
from restitution.planning.writing.desk import NotPlannedError, Source, chain, link, together
from restitution.planning.writing.flights import added
from restitution.planning.writing.forms import (
    ZERO,
    difference,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.place_trees import Axis, coordinate_tree, place_tree, time_tree
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.records import dataclass
from restitution.vector import Vector


def time_on_a_chord(scene: Scene, body: str, number: int, since: int, flight: Expression) -> Source:
    """The time from one point of a circular wall to the next: the chord over the speed.

    It is written as the value of ``flight``.
    """
    again = _as_before(scene, body, number, since, flight) if since else None
    if again is not None:
        return again
    begin: tuple[Ref, ...] = () if since else ("start",)
    speed = _speed_on_a_chord(scene, body, since)
    length = _chord(scene, body, number, since, speed)
    value = tidy(length.value / speed.value)
    line = scene.desk.write(
        Move("define", "chord", number, (body,)),
        together(length.refs, speed.refs, begin),
        chain(
            flight,
            (swept(Binary("/", tree_of(length.value), tree_of(speed.value))), None),
            (tree_of(value), "rearrange"),
        ),
    )
    return scene.desk.know(flight, value, (line,))


def _as_before(
    scene: Scene, body: str, number: int, since: int, flight: Expression
) -> Source | None:
    """The time on a chord as that on the one before, where both components keep their sizes.

    None where they do not, or no line gives that time.
    """
    before = chord_from(scene, body, since)
    earlier: Expression = time_tree(since)
    if before:
        earlier = difference(earlier, time_tree(before))
    known = scene.desk.known(earlier)
    if before is None or known is None:
        return None
    frame = scene.frame(since)
    sources: list[Source] = []
    for kind in COMPONENTS:
        component = scene.desk.known(frame.component(kind, body, before))
        late = after(scene, kind, body, frame)
        if component is None or tidy(_put(scene, component) ** 2 - _put(scene, late) ** 2) != 0:
            return None
        sources += [component, late]
    relation = chain(flight, (earlier, None), (tree_of(known.value), "put"))
    pool = together(
        ("start", f"position {body}", f"contact {since}", f"contact {number}"),
        (f"contact {before}",) if before else (),
        *(together(source.whole, scene.put(source.value)[1]) for source in sources),
        background(scene, symbol_names(*(source.value for source in sources))),
        known.refs,
    )
    move = Move("define", "chord", number, (body,))
    refs = scene.judge.needed(move, pool, relation, known.refs)
    if refs is None:
        return None
    return scene.desk.know(flight, known.value, (scene.desk.write(move, refs, relation),))


def place_on_a_level(
    scene: Scene, body: str, number: int, axis: Axis, level: Source, pace: Source
) -> Source | None:
    """Where a body hits a circular wall that moves parallel to an axis: by the circle alone.

    ``level`` is its other coordinate, which stays, ``pace`` its velocity along the axis. Of the two
    points of the circle it is the one at which it moves towards the wall. None where the letter for
    the coordinate is taken, or the follower does not see which point it is.
    """
    circle, letter = circle_of(scene, number), Letter(_COORDINATES[axis])
    if circle is None or letter.name in letters_taken(scene):
        return None
    mark = scene.desk.mark()
    place = scene.value(place_tree(body, number))
    seen = from_centre(scene, number, place)
    centre = place - seen
    x, y, middle, across = (
        (place.x, seen.y, centre.x, tidy(level.value - centre.y))
        if axis == "i"
        else (place.y, seen.x, centre.y, tidy(level.value - centre.x))
    )
    let = scene.desk.write(
        Move("let"), (), Meaning(letter.name, coordinate_tree(body, number, axis))
    )
    own, height = square(difference(letter, tree_of(middle))), square(swept(tree_of(across)))
    sides = (own, height) if axis == "i" else (height, own)
    radius, more = scene.put(scene.scalar(circle[1]))
    left = own if across == 0 else total(sides)
    fact = equality(swept(left), square(tree_of(radius)))
    line = scene.judge.write((Move("fact"),), (f"contact {number}", let, *level.refs, *more), fact)
    values = [tidy(scene.put(value)[0]) for value in (x, 2 * middle - x)]
    known = background(scene, symbol_names(*values, y))
    for move, right in ((Move("roots"), values), (Move("reject"), values[:1])):
        relation = Relation(tuple((Link(letter, "=", tree_of(value)),) for value in right))
        why = (*pace.refs, f"towards {number}", *level.refs, let) if len(right) == 1 else ()
        refs = line and scene.judge.enough(move, (line,), relation, (*why, *known))
        if not refs:
            scene.desk.back(mark)
            return None
        line = scene.desk.write(move, refs, relation)
    assert line is not None
    scene.desk.know(coordinate_tree(body, number, axis), values[0], (line, let))
    both = Vector(values[0], level.value) if axis == "i" else Vector(level.value, values[0])
    whole = scene.judge.write(
        (Move("define", "assemble", number, (body,)),),
        (line, let, *level.refs),
        chain(place_tree(body, number), (tree_of(both), None)),
    )
    if whole is None:
        scene.desk.back(mark)
        return None
    return scene.desk.know(place_tree(body, number), both, (whole,))


_COORDINATES: Mapping[Axis, str] = {"i": "x", "j": "y"}


def _put(scene: Scene, source: Source) -> sp.Expr:
    return sp.sympify(scene.put(source.value)[0], strict=True)


def _chord(scene: Scene, body: str, number: int, since: int, speed: Source) -> Source:
    """The length of a chord: 2r cos φ, where φ is the angle with the radius.

    cos φ is the component towards the wall over the speed.
    """
    quantity = Quantity("distance", (place_tree(body, since), place_tree(body, number)))
    circle = circle_of(scene, number) or circle_of(scene, since)
    assert circle is not None
    radius, more = scene.put(scene.scalar(circle[1]))
    refs: list[Ref] = [f"contact {number}", *more]
    if since:
        source = after(scene, "along", body, scene.frame(since))
        towards, used = scene.put(-source.value)
        refs += [f"contact {since}", *source.whole, *used]
    else:
        frame = scene.frame(number)
        source = _by_its_angle(scene, body, frame, speed.value) or in_direction(
            scene, "along", body, 0, frame
        )
        towards, used = scene.put(source.value)
        refs += [*source.whole, *used]
    tree = product(tree_of(sp.Integer(2)), tree_of(radius))
    angle = _cosine(scene, body, since, source.value, speed.value)
    if angle is not None:
        tree = product(tree, angle)
    elif towards != speed.value:
        tree = product(tree, Binary("/", tree_of(towards), tree_of(speed.value)))
    value = tidy(2 * radius * towards / speed.value)
    move = Move("define", "chord", number, (body,))
    relation = chain(quantity, (swept(tree), None), (tree_of(value), "rearrange"))
    premises = together(refs, speed.refs)
    if towards == speed.value:
        # Through the centre: how fast it goes is no matter.
        premises = scene.judge.needed(move, premises, relation) or premises
    line = scene.desk.write(move, premises, relation)
    return scene.desk.know(quantity, value, (line,))


def _by_its_angle(scene: Scene, body: str, frame: Frame, speed: sp.Expr) -> Source | None:
    """A component at the start by the letter of an angle that is found by now, as it stands."""
    known = scene.desk.known(frame.component("along", body, 0))
    if known is None or _cosine_in_degrees(scene, known.value, speed) is None:
        return None
    return known


def _cosine_in_degrees(scene: Scene, component: sp.Expr, speed: sp.Expr) -> Expression | None:
    """The cosine of the angle with a radius, where the component has a letter for that: cos 30°."""
    ratio = tidy(component / speed)
    if not isinstance(ratio, sp.cos) or not ratio.args[0].is_Symbol:
        return None
    known = scene.desk.known(Letter(ratio.args[0].name))
    if known is None or not (sp.sympify(known.value, strict=True) / sp.pi).is_Rational:
        return None
    return Apply("cos", tree_of(known.value, angle=True))


def _cosine(
    scene: Scene, body: str, since: int, component: sp.Expr, speed: sp.Expr
) -> Expression | None:
    """The cosine of the angle with a radius by that angle; None where it is no angle of the data.

    ``component`` is that of the velocity towards the wall, ``since`` the event before the chord.
    """
    by_a_letter = _cosine_in_degrees(scene, component, speed)
    if by_a_letter is not None:
        return by_a_letter
    ratio = tidy(component / speed)
    if isinstance(ratio, sp.cos | sp.sin) and ratio.args[0].is_Symbol:
        return tree_of(ratio)
    return None if since else share_in_degrees(scene, body, ratio)


def _speed_on_a_chord(scene: Scene, body: str, since: int) -> Source:
    """How fast a body goes after an impact with a circular wall; at the start, as is given."""
    quantity = Quantity("speed", (Name(body),), since)
    if not since:
        initial = scene.initial(body)
        right = scene.facts[f"velocity {body}"].relation.only[0].right
        given = scene.scalar(right.size) if isinstance(right, Polar) else None
        size, used = scene.put(scene.model.story.size(initial.value) if given is None else given)
        return Source(size, together(initial.refs, used))
    known = scene.desk.known(quantity)
    if known is not None:
        own, used = scene.put(known.value)
        return Source(own, together(known.refs, used))
    parts = [after(scene, kind, body, scene.frame(since)) for kind in COMPONENTS]
    values, refs = [], []
    for part in parts:
        value, used = scene.put(part.value)
        values.append(value)
        refs += [*part.whole, *used]
    if values[1] == 0:
        return Source(-values[0], together(refs))
    squares = total(square(tree_of(value)) for value in values)
    size = tidy(sp.sqrt(tidy(expanded(sum(value**2 for value in values)))))
    line = scene.desk.write(
        Move("define", "speed", since, (body,)),
        together(refs),
        chain(quantity, (Apply("sqrt", squares), None), (tree_of(size), "rearrange")),
    )
    return scene.desk.know(quantity, size, (line,))


@dataclass(frozen=True)
class Approach:
    """How a body comes to an event: from where, how fast, and since when; at rest without that."""

    body: str
    first: Source
    pace: Source
    early: Source | None


def time_from_the_centre(scene: Scene, body: str, number: int, flight: Expression) -> Source | None:
    """The time in which a body comes along a radius to a circular wall: the radius over the speed.

    None where it does not start at the centre.
    """
    circle = circle_of(scene, number)
    place = scene.facts.get(f"position {body}")
    if circle is None or place is None or scene.last_event(body, number - 1):
        return None
    start = from_centre(scene, number, scene.vector(place.relation.only[0].right))
    if not all(map(scene.model.identically_zero, start)):
        return None
    radius, more = scene.put(scene.scalar(circle[1]))
    speed = _speed_on_a_chord(scene, body, 0)
    value = tidy(radius / speed.value)
    parts = scene.initial(body).value
    pace = tree_of(speed.value)
    if all(part.is_Rational and part for part in parts):
        pace = Apply("sqrt", total(square(tree_of(abs(part))) for part in parts))
    ratio = swept(Binary("/", tree_of(radius), pace))
    line = scene.judge.write(
        (Move("define", "chord", number, (body,)),),
        ("start", place.id, f"contact {number}", *speed.refs, *more),
        chain(flight, (ratio, None), (tree_of(value), "rearrange")),
    )
    return None if line is None else scene.desk.know(flight, value, (line,))


def _standard_form(
    scene: Scene, fact: int, coefficients: tuple[sp.Expr, ...], t: Expression
) -> int:
    """The equation for a time as a quadratic in numbers, or as a product where it is one.

    The line itself where letters are in it, or where the time stands as a square alone.
    """
    x = sp.Dummy("x", real=True)
    polynomial = sp.Poly([tidy(expanded(c)) for c in coefficients], x)
    if polynomial.nth(1) == 0 or not all(c.is_number for c in polynomial.all_coeffs()):
        return fact
    whole = polynomial.primitive()[1] if polynomial.domain.is_QQ else polynomial
    whole = whole.clear_denoms(convert=True)[1] if whole.domain.is_QQ else whole
    whole = whole.primitive()[1] if whole.domain.is_ZZ else whole
    known = scene.judge.write(
        (Move("rearrange"),), (fact,), equality(polynomial_tree(whole, t), ZERO)
    )
    factors = sp.factor_list(whole)[1] if whole.domain.is_ZZ else []
    if known is None or whole.nth(0) == 0 or [n for _, n in factors] != [1, 1]:
        return known or fact
    trees = (polynomial_tree(factor, t) for factor, _ in factors)
    parted = equality(product(*trees), ZERO)
    return scene.judge.write((Move("rearrange"),), (known,), parted) or known


def time_of_touching(scene: Scene, number: int, approaches: Sequence[Approach]) -> Source:
    """The time at which a body is so far from a centre, or from that of another body.

    Of the two times of the equation one is before the last event, or that at which they would
    part again.
    """
    circle = circle_of(scene, number)
    if circle is None:
        raise NotPlannedError("the time of a contact whose place is not given")
    t = time_tree(number)
    refs: list[Ref] = [f"contact {number}"]
    begins = [approach.early for approach in approaches if approach.early is not None]
    begin = begins[0]
    flight = difference(t, tree_of(begin.value))
    lines: list[Ref] = []
    at, pace = Vector(sp.Integer(0), sp.Integer(0)), Vector(sp.Integer(0), sp.Integer(0))
    for path, sign in zip(approaches, (1, -1), strict=False):
        if path.early is None:
            refs += [*path.first.refs, *path.pace.refs]
            at += sign * path.first.value
            continue
        own = difference(t, tree_of(path.early.value))
        open_ = scene.desk.write(
            Move("define", "straight-line", number, (path.body,)),
            together(path.first.refs, path.pace.refs, path.early.refs),
            chain(
                place_tree(path.body, number),
                (added(path.first.value, own, path.pace.value), None),
            ),
        )
        lines.append(open_)
        late = tidy(begin.value - path.early.value)
        at += sign * (path.first.value + path.pace.value * late)
        pace += sign * path.pace.value
    if len(approaches) == 1:
        at = from_centre(scene, number, at)
    sides = []
    for a, v in zip(at, pace, strict=True):
        a, v = tidy(a), tidy(v)
        if a != 0 or v != 0:
            terms = (tree_of(a), product(tree_of(v), flight))
            first_moves = isinstance(terms[0], Negate) and not isinstance(terms[1], Negate)
            sides.append(square(swept(total(terms[::-1] if first_moves else terms))))
    radius, more = scene.put(scene.scalar(circle[1]))
    fact = scene.desk.write(
        Move("fact"),
        together(refs, lines, more),
        Relation(((link(swept(total(sides)), square(tree_of(radius))),),)),
    )
    speed = tidy(expanded(pace.dot(pace)))
    both = tidy(-2 * at.dot(pace) / speed)
    when, _ = scene.put(scene.value(t))
    other = tidy(2 * begin.value + both - when)
    roots = Relation(tuple((Link(t, "=", tree_of(value)),) for value in (when, other)))
    letters = symbol_names(when - other)
    known = background(scene, letters)
    rest = tidy(expanded(at.dot(at) - radius**2))
    standard = fact
    if 0 not in map(tidy, pace):
        standard = _standard_form(scene, fact, (speed, 2 * at.dot(pace), rest), t)
    elif len(sides) > 1:
        # The body comes across one of the directions: a square is alone.
        own = sides[0 if tidy(pace.x) != 0 else 1]
        alone = next(tidy(a) for a, v in zip(at, pace, strict=True) if tidy(v) == 0)
        value = tree_of(tidy(expanded(radius**2 - alone**2)))
        standard = scene.judge.write((Move("rearrange"),), (fact,), equality(own, value)) or fact
    for equation in (standard, fact) if flight == t else (fact,):
        premises = scene.judge.enough(Move("roots"), (equation,), roots, known)
        if premises is not None:
            break
    if premises is None:
        raise NotPlannedError("the times of a contact")
    line = scene.desk.write(Move("roots"), premises, roots)
    chosen = chain(t, (tree_of(when), None))
    if f"order {number}" in scene.facts:
        why: tuple[Ref, ...] = (f"order {number}", *begin.refs)
    else:
        why = (f"towards {number}", *lines)
        why = together(why, refs[1:], *(approach.pace.refs for approach in approaches))
    kept = scene.judge.enough(Move("reject"), (line,), chosen, (*why, *background(scene, letters)))
    if kept is None:
        raise NotPlannedError("which of two times it is")
    line = scene.desk.write(Move("reject"), kept, chosen)
    return scene.desk.know(t, when, (line,))
