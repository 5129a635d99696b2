"""A speed after a wall and its angle to that: its components, which both laws take.

*u cos α = 4 cos 20°* along the wall, and *½u sin α = 4 sin 20°* perpendicular to it.
"""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation
from restitution.explaining.lines.trees import has_ratio_of_a_sum
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Polar,
    Quantity,
    has_quantity,
    is_function,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.formulas.impacts import before, component_letter
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.writing.angles import angle_to_its_wall
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import neat, negative, product, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene

_ACUTE = "0° <= {} <= 90°"
_RATIOS = ("cos", "sin")
_RECORDS = {"across": "unchanged", "along": "restitution-wall"}
Shares = tuple[tuple[Expression, tuple[Ref, ...]], ...]
"""The cosine and the sine of an angle, each with the lines and facts that give it."""


def resolved_at_a_wall(
    scene: Scene, turned: GivenEquation, fast: GivenEquation
) -> tuple[int, int] | None:
    """Both laws at a wall, along it and perpendicular to it, of a speed after it and its angle.

    The angle to the wall is given, or its tangent, sine or cosine, or is what a deflection leaves
    of it. None where what is given is not that, or the velocity before has no components.
    """
    own = _body_and_stage(turned)
    met = None if own is None else _frame_and_size(scene, own, fast)
    if own is None or met is None:
        return None
    mark = scene.desk.mark()
    lines = _written(scene, turned, fast, own[0], met[0])
    if lines is None:
        scene.desk.back(mark)
    return lines


def _frame_and_size(
    scene: Scene, own: tuple[str, int], fast: GivenEquation
) -> tuple[Frame, Expression] | None:
    """The frame of the wall after which a body has a speed that is given, and that speed."""
    match fast.link:
        case Link(Quantity("speed", (Name(body),), int(stage)), "=", size) if own == (body, stage):
            if stage not in scene.model.frames or has_quantity(size):
                return None
            frame = scene.frame(stage)
            return (frame, size) if frame.wall is not None else None
    return None


def _body_and_stage(turned: GivenEquation) -> tuple[str, int] | None:
    """The body of which an angle is given, and the event after which it is that."""
    left = turned.link.left
    angle = left.argument if isinstance(left, Apply) else left
    if turned.link.sign != "=" or has_quantity(turned.link.right):
        return None
    match angle:
        case Quantity("deflection", (Name(body),), int(stage)) if angle is left:
            return body, stage
        case Quantity("angle", (Quantity("velocity", (Name(body),), int(stage)), Name())):
            return body, stage
    return None


def _written(
    scene: Scene, turned: GivenEquation, fast: GivenEquation, body: str, frame: Frame
) -> tuple[int, int] | None:
    shares = _shares(scene, turned, body, frame)
    if shares is None:
        return None
    lines = []
    for kind, (ratio, sources) in zip(("across", "along"), shares, strict=True):
        share = product(fast.link.right, ratio), together(sources, fast.refs)
        line = _law(scene, body, frame, kind, share)
        if line is None:
            return None
        lines.append(line)
    return lines[0], lines[1]


def _law(
    scene: Scene, body: str, frame: Frame, kind: str, share: tuple[Expression, tuple[Ref, ...]]
) -> int | None:
    """The law of one component, of which the size after the wall is a share of the speed."""
    early = before(scene, kind, body, frame)
    value, refs = scene.put(early.value)
    sign = scene.model.sign(scene.model.in_data(value))
    if sign == 0:
        return None
    tree = tree_of(value) if early.form is None or refs else early.form
    came, e = tree if sign > 0 else negative(tree), scene.coefficient(frame.number)
    if kind == "along":
        plain = e.value.is_number or early.form is not None
        came = product(tree_of(e.value), came) if plain else tree_of(neat(e.value * sign * value))
    size, sources = share
    whole = chain(came, (size, None))
    if not _has_ratio(size) and not isinstance(came, Letter):
        whole = chain(came, (size, None), (tree_of(tidy(scene.scalar(size))), "rearrange"))
    pool = together(sources, early.whole, refs, e.refs if kind == "along" else ())
    move = Move("law", _RECORDS[kind], frame.number, (body,))
    premises = scene.judge.enough(move, pool, whole, _spare(scene, body, frame, whole))
    if premises is None:
        return None
    late = tidy(sign * scene.scalar(size) * (1 if kind == "across" else -1))
    known = tuple(ref for ref in premises if ref not in e.refs)
    line = scene.desk.write(move, premises, whole)
    if not has_ratio_of_a_sum(size):
        _know_after(scene, body, frame, kind, late, known)
    elif kind == "along":
        # Along the wall it is u cos α; away from it, 5 sin(60° − α) is worked out where it is used.
        _know_after(scene, body, frame, kind, late, known, size if sign < 0 else negative(size))
    return line


def _know_after(
    scene: Scene,
    body: str,
    frame: Frame,
    kind: str,
    late: sp.Expr,
    refs: tuple[Ref, ...],
    form: Expression | None = None,
) -> None:
    """From here on a component after the wall is known by what is given."""
    scene.desk.know(frame.component(kind, body, frame.number), late, refs, form)
    if kind == "along":
        letter = component_letter(scene, body, frame)
        scene.desk.know(Letter(letter.name), frame.letter_sign * late, refs)


def _spare(scene: Scene, body: str, frame: Frame, relation: Relation) -> tuple[Ref, ...]:
    """What a law may have to cite besides what is in it."""
    names = {name for link in relation.only for e in (link.left, link.right) for name in letters(e)}
    own = (f"velocity {body}", f"approach {frame.number}")
    facts = [ref for ref in scene.facts if ref.startswith("wall ") or ref in own]
    return (*facts, *frame.refs, *background(scene, names), *scene.judge.known(names))


def start_by_what_follows(scene: Scene, turned: GivenEquation, fast: GivenEquation) -> bool:
    """Whether the velocity before a wall, of which nothing is told, has its components in lines.

    They come of the speed after it and its angle to the wall, and have no letters.
    """
    own = _body_and_stage(turned)
    if own is None or not (met := _frame_and_size(scene, own, fast)):
        return False
    (body, number), (frame, size) = own, met
    velocity = scene.velocity(body, 0)
    known = f"velocity {body}" in scene.facts or scene.last_event(body, number - 1)
    if known or scene.others or not all(part.is_Symbol for part in velocity):
        return False
    if not all(part.is_number for part in frame.n):
        return False
    mark = scene.desk.mark()
    shares = _shares(scene, turned, body, frame)
    e = scene.coefficient(number)
    if shares is None or scene.unknown(e.value) or scene.model.sign(e.value) <= 0:
        return False
    worths: dict[str, sp.Expr] = {}
    lines: list[int] = []
    for kind, (ratio, sources) in zip(("across", "along"), shares, strict=True):
        share = product(size, ratio)
        component = frame.component(kind, body, 0)
        named = frame.names_axis(kind)
        pool = together(sources, fast.refs, e.refs if kind == "along" else (), named)
        worth = tidy(scene.scalar(share) / (e.value if kind == "along" else 1))
        move = Move("law", _RECORDS[kind], frame.number, (body,))
        if kind == "along":
            law = chain(share, (product(tree_of(e.value), component), None))
        elif tree_of(worth) == share:
            law = chain(component, (share, None))
        else:
            law = chain(component, (share, None), (tree_of(worth), "rearrange"))
        premises = scene.judge.enough(move, pool, law, _spare(scene, body, frame, law))
        if premises is None:
            scene.desk.back(mark)
            return False
        line = scene.desk.write(move, premises, law)
        if kind == "along":
            alone = chain(component, (tree_of(worth), None))
            line = scene.desk.write(Move("rearrange"), (line,), alone)
        scene.desk.know(component, worth, (line,))
        late = tidy(scene.scalar(share) * (1 if kind == "across" else -1))
        after = together(sources, fast.refs, named, (line,))
        _know_after(scene, body, frame, kind, late, after)
        worths[kind] = worth
        lines.append(line)
    whole = frame.n * worths["along"] + frame.t * worths["across"]
    for letter, part in zip(velocity, whole, strict=True):
        scene.desk.know(Letter(letter.name), tidy(part), lines)
    return True


def _shares(scene: Scene, turned: GivenEquation, body: str, frame: Frame) -> Shares | None:
    """The cosine and the sine of the angle of a path to the wall, and where they come from."""
    link = turned.link
    if isinstance(link.left, Apply):
        return _by_a_ratio(scene, turned, link.left)
    rest, sources = link.right, turned.refs
    if is_quantity(link.left, "deflection"):
        own = _left_by_the_deflection(scene, turned, body, frame)
        if own is None:
            return None
        rest, sources = own
    return tuple((Apply(ratio, rest), sources) for ratio in _RATIOS)


def _left_by_the_deflection(
    scene: Scene, turned: GivenEquation, body: str, frame: Frame
) -> tuple[Expression, tuple[Ref, ...]] | None:
    """What a deflection leaves of the angle after a wall: ``δ − α``, as a line."""
    fact = scene.facts.get(f"velocity {body}")
    if fact is None or scene.last_event(body, frame.number - 1) or frame.wall is None:
        return None
    match fact.relation.only[0].right:
        case Polar(_, turned_by, wall=Name(name)) if name == frame.wall:
            angle = angle_to_its_wall(scene, turned_by)
        case _:
            return None
    later = Quantity("angle", (Quantity("velocity", (Name(body),), frame.number), Name(frame.wall)))
    rest = Binary("-", turned.link.right, angle)
    move = Move("define", "sum", frame.number, (body,))
    line = scene.judge.write((move,), (*turned.refs, fact.id), chain(later, (rest, None)))
    return None if line is None else (rest, (line,))


def _by_a_ratio(scene: Scene, turned: GivenEquation, given: Apply) -> Shares | None:
    """The cosine and sine of an angle of which one ratio is given as a number: lines."""
    angle, value = given.argument, scene.scalar(turned.link.right)
    if not value.is_number or not isinstance(angle, Quantity):
        return None
    worth = {"tan": sp.atan, "sin": sp.asin, "cos": sp.acos}[given.function](value)
    letter, meaning = letter_of(scene, angle)
    named = Apply(given.function, Letter(letter))
    first = scene.judge.write(
        (Move("fact"),), (*turned.refs, meaning), chain(named, (turned.link.right, None))
    )
    if first is None:
        return None
    values = {"cos": tidy(sp.cos(worth)), "sin": tidy(sp.sin(worth))}
    trees = {ratio: tree_of(own) for ratio, own in values.items()}
    trees[given.function] = tree_of(value)
    links = tuple(
        Link(Apply(ratio, Letter(letter)), "=", trees[ratio])
        for ratio in ("sin", "cos")
        if ratio != given.function
    )
    pool = (first, meaning, *scene.judge.known([letter]), _ACUTE.format(letter))
    second = scene.judge.write((Move("triangle"),), pool, Relation((links,)))
    if second is None:
        return None
    lines = [first if ratio == given.function else second for ratio in _RATIOS]
    return tuple((trees[ratio], (line, meaning)) for ratio, line in zip(_RATIOS, lines))


def _has_ratio(tree: Expression) -> bool:
    """Whether there is a sine or a cosine in a product."""
    return any(is_function(node, *_RATIOS) for node in walk(tree))


__all__ = ["resolved_at_a_wall", "start_by_what_follows"]
