"""The mark points of a part: what an examiner would give marks for, and on what each rests.

They are read from the derivations that the planner makes, with the marks that stand beside their
lines (`explaining.awarding.awards`): one scheme a route. A working is
marked by the one that gives most.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice, takewhile

from restitution.explaining.awarding.awards import awarded
from restitution.explaining.awarding.mark_rules import CONCLUDING, UNWRITTEN
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Derivation,
    ItemEnd,
    Line,
    Link,
    Relation,
    numbers_in,
)
from restitution.explaining.lines.marks import Mark, Marks, Style
from restitution.explaining.lines.saying import say
from restitution.explaining.lines.titles import title_of
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import Apply, Expression, Letter, Name, Quantity
from restitution.planning.planner import plan
from restitution.problem import Compare, Show, Value
from restitution.records import dataclass
from restitution.solving.equations.solution import PartSolution, Solution

ROUTES = 3
"""How many ways to the answers have a scheme, at most."""

PRINCIPLES: Mapping[str, str] = {
    "unchanged": "unchanged",
    "restitution-wall": "restitution",
    "restitution": "restitution",
    "momentum": "momentum",
    "momentum-vector": "momentum",
    "impulse": "impulse",
    "impulse-vector": "impulse",
    "opposite-impulses": "impulse",
    "across-the-impulse": "impulse",
    "impulse-direction": "impulse",
    "along-the-change": "impulse",
    "changed-velocity": "velocity",
    "wall-direction": "impulse",
    "equal-across": "unchanged",
    "moves-off": "direction",
    "component": "component",
    "assemble": "velocity",
    "relative-velocity": "velocity",
    "product": "scalar-product",
    "speed": "speed",
    "size": "speed",
    "tan": "angle",
    "tan-squared": "angle",
    "tan-direction": "angle",
    "scalar-angle": "angle",
    "sum": "deflection",
    "difference": "deflection",
    "tan-deflection": "deflection",
    "tan-from-axis": "deflection",
    "perpendicular": "fact",
    "parallel": "fact",
    "energy": "energy",
    "energy-ratio": "energy",
    "energy-lost": "energy",
    "energy-change": "energy",
    "total": "energy",
    "total-lost": "energy",
    "straight-line": "place",
    "distance": "place",
    "momentum-of": "momentum-of",
}
"""What a line of each record uses, in the words of verdicts on lines."""

_FOR = {
    "unchanged": "component that the impact does not change",
    "restitution": "Newton's experimental law",
    "momentum": "momentum along the line of centres",
    "impulse": "impulse as a change of momentum",
    "direction": "direction of the line of centres",
    "component": "components",
    "velocity": "velocity from its components",
    "scalar-product": "scalar product",
    "speed": "speed from its components",
    "angle": "angle from components",
    "deflection": "angle of deflection",
    "fact": "the condition as an equation",
    "energy": "kinetic energy",
    "place": "distance = speed × time",
    "momentum-of": "momentum",
    "solve": "solving for one unknown",
    "inequality": "condition as an inequality",
    "condition": "the condition used",
}

_OF_MOVES = {
    "combine": "solve",
    "divide": "solve",
    "square-add": "solve",
    "solve": "solve",
    "identity": "solve",
    "roots": "solve",
    "reject": "condition",
    "sign": "inequality",
    "compare": "inequality",
    "monotone": "inequality",
    "complete": "inequality",
    "fact": "fact",
    "put": "condition",
}


@dataclass(frozen=True)
class MarkPoint:
    """One mark, and what it is for.

    ``kind`` is as printed (``DM1``, ``A1ft``, ``A1*``). ``principle``, ``event`` and ``bodies`` say
    which law earns it. ``link`` is what its line says, in quantities of the statement language.
    ``depends`` are the points without which it is not given: the method beside it, or those on
    which a dependent method rests; ``above`` all on which its line rests. ``item`` is the place of
    the item that it answers, ``shown`` tells that the statement prints that. ``bounds`` are the
    ends of a range that it is for.
    """

    id: str
    kind: str
    purpose: str
    principle: str
    event: int | None = None
    bodies: tuple[str, ...] = ()
    link: Link | None = None
    depends: tuple[str, ...] = ()
    above: tuple[str, ...] = ()
    item: int | None = None
    shown: bool = False
    equation: bool = False
    bounds: tuple[Link, ...] = ()

    @property
    def letter(self) -> str:
        """M for a method, A for accuracy, B for what stands by itself."""
        return self.kind.removeprefix("D")[0]

    @property
    def follows(self) -> bool:
        """Whether it follows through from an earlier slip."""
        return self.kind.endswith("ft")


@dataclass(frozen=True)
class Scheme:
    """The points of a part by one route, in order.

    ``by_angles`` tells that it is for a deflection that is put together of angles.
    """

    route: int
    points: tuple[MarkPoint, ...]
    by_angles: bool = False

    @property
    def total(self) -> int:
        return len(self.points)


def schemes(
    solution: Solution, part: str | None = None, style: Style = "fm1"
) -> tuple[Scheme, ...]:
    """The distinct schemes of a part, that of the usual method first.

    Raises KeyError for a part that is not there.
    """
    solved = solution.parts[part]
    known: dict[tuple[tuple[str, str, int | None], ...], Scheme] = {}
    earlier = tuple(takewhile(lambda other: other is not solved, solution.parts.values()))
    before: list[MarkPoint] = []
    for route in range(1, ROUTES + 1):
        derivation = awarded(plan(solution, route, partial=True), style)
        points = tuple(_points(derivation, solved))
        if not known:
            before = [point for other in earlier for point in _points(derivation, other)]
        key = tuple((point.kind, point.principle, point.event) for point in points)
        if points:
            known.setdefault(key, Scheme(route, points))
    by_angles = (_by_angles(scheme, solved, before) for scheme in islice(known.values(), 1))
    own = (*known.values(), *(scheme for scheme in by_angles if scheme is not None))
    return own or (_of_answers(solved),)


def _by_angles(scheme: Scheme, solved: PartSolution, before: Sequence[MarkPoint]) -> Scheme | None:
    """The scheme of a deflection by the angles of both velocities, where these are known.

    A method for an angle of either, one for how they are put together, and the answer. An angle
    after that is an answer among the points ``before``, of earlier parts, has no method here.
    """
    answer = scheme.points[-1]
    laws = {"momentum", "restitution", "unchanged", "impulse"}
    match answer.link:
        case Link(Quantity("deflection", (Name(),) as body, int(number))) if not answer.shown:
            pass
        case _:
            return None
    if len(solved.items) != 1 or laws & {point.principle for point in scheme.points}:
        return None
    names = tuple(name.name for name in body if isinstance(name, Name))
    line = Quantity("line_of_centres", (), number)
    velocity = Quantity("velocity", body, number)
    for point in before:
        match point.link:
            case Link(Quantity("angle", arguments)) if point.item is not None:
                if velocity in arguments:
                    return None
    after = Apply("tan", Quantity("angle", (velocity, line)))
    turn = Quantity("deflection", body, number)
    first = answer.id.rstrip("0123456789")
    angle = MarkPoint(
        f"{first}1", "M1", _FOR["angle"], "angle", number, names, Link(after, "=", after)
    )
    whole = MarkPoint(
        f"{first}2", "M1", _FOR["deflection"], "deflection", number, names, Link(turn, "=", turn)
    )
    above = (angle.id, whole.id)
    last = replace(answer, id=f"{first}3", depends=(whole.id,), above=above)
    return Scheme(scheme.route, (angle, whole, last), by_angles=True)


def _of_answers(solved: PartSolution) -> Scheme:
    """Where no working is known: a method and a value for each item."""
    points: list[MarkPoint] = []
    prefix = solved.part.label or ""
    for place, item in enumerate(solved.items):
        method = MarkPoint(
            f"{prefix}{len(points) + 1}", "M1", f"a method for {item.text}", "method", item=place
        )
        value = MarkPoint(
            f"{prefix}{len(points) + 2}",
            "A1",
            item.text,
            "answer",
            depends=(method.id,),
            above=(method.id,),
            item=place,
        )
        points += [method, value]
    return Scheme(1, tuple(points))


def _points(derivation: Derivation, solved: PartSolution) -> Iterator[MarkPoint]:
    """The points that stand beside the lines of a part, and beside what is not written out."""
    label = solved.part.label
    items = {name: place for place, name in enumerate(_items(derivation, label))}
    ends = {end.line: end for end in derivation.items}
    lines = {line.number: line for line in derivation.lines}
    concluded = _concluded(derivation)
    by_line: dict[int, list[MarkPoint]] = {}
    count = 0

    def above(line: Line) -> tuple[str, ...]:
        seen, open_ = set[int](), numbers_in(line.premises)
        while open_:
            number = open_.pop()
            if number not in seen and number in lines:
                seen.add(number)
                open_ += numbers_in(lines[number].premises)
        return tuple(point.id for n in sorted(seen) for point in by_line.get(n, ()))

    for line in derivation.lines:
        if line.item is None and not line.marks:
            continue
        if derivation.asked.get(line.item or "") != label:
            continue
        under = above(line)
        for mark in (*line.marks, *concluded.get(line.number, ())):
            count += 1
            method = [point.id for point in by_line.get(line.number, ()) if point.letter == "M"]
            rests = [p.id for n in mark.on for p in by_line.get(n, ()) if p.letter == "M"]
            if mark.kind == "A" and not method:
                method = _nearest_methods(line, lines, by_line)
            point = _point(
                f"{label or ''}{count}",
                mark,
                line,
                derivation,
                depends=tuple(rests if mark.kind == "M" else method),
                above=(*under, *(p.id for p in by_line.get(line.number, ()))),
                end=ends.get(line.number),
                item=items.get(_item_of(line, ends)),
            )
            by_line.setdefault(line.number, []).append(point)
            yield point
    for note in derivation.notes:
        # That a claim is not true, or has no answer, is told in words, which are not marked.
        if note.part != label or note.kind in ("refuted", "unsolved", *CONCLUDING):
            continue
        place = items.get(note.item)
        answer, shown = _asked(solved, place)
        needed: tuple[str, ...] = ()
        for mark in UNWRITTEN if note.kind == "unwritten" else note.marks:
            count += 1
            of_method = mark.kind == "M"
            name = f"{label or ''}{count}"
            yield MarkPoint(
                name,
                str(mark),
                "a method for it" if of_method else "the answer",
                "method" if of_method else "answer",
                link=None if of_method else answer,
                depends=() if of_method else needed,
                above=() if of_method else needed,
                item=place,
                shown=shown and not of_method,
            )
            needed = (name,) if of_method else needed


def _concluded(derivation: Derivation) -> Mapping[int, Marks]:
    """The marks of conclusions in words, by the last lines above them, which have none.

    What is typed is marked by the value from which it is concluded that there is no answer.
    """
    lines = {line.number: line for line in derivation.lines}
    return {
        last: note.marks
        for note in derivation.notes
        if note.kind in CONCLUDING and (last := max(note.lines, default=0)) in lines
        if lines[last].item == note.item and all(mark.kind == "M" for mark in lines[last].marks)
    }


def _asked(solved: PartSolution, place: int | None) -> tuple[Link | None, bool]:
    """What an item asks for, as a relation, and whether the statement prints it."""
    item = solved.items[place].item if place is not None and place < len(solved.items) else None
    if isinstance(item, Value):
        return Link(item.expression, "=", item.expression), False
    relation = item.relation if isinstance(item, Show) and item.subject is None else None
    if isinstance(relation, Compare) and relation.operators == ("=",):
        left, right = relation.operands
        return Link(left, "=", right), True
    return None, False


def _item_of(line: Line, ends: Mapping[int, ItemEnd]) -> str:
    """The item that a line ends, or to which it belongs."""
    end = ends.get(line.number)
    return (line.item or "") if end is None else end.item


def _items(derivation: Derivation, label: str | None) -> list[str]:
    return [name for name, part in derivation.asked.items() if part == label]


def _nearest_methods(
    line: Line, lines: Mapping[int, Line], by_line: Mapping[int, list[MarkPoint]]
) -> list[str]:
    """The methods on which a value directly rests: those of the nearest lines that have some."""
    methods: list[str] = []
    seen, open_ = set[int](), numbers_in(line.premises)
    while open_:
        number = open_.pop(0)
        if number in seen or number not in lines:
            continue
        seen.add(number)
        own = [point.id for point in by_line.get(number, ()) if point.letter == "M"]
        methods += own
        if not own:
            open_ += numbers_in(lines[number].premises)
    return methods


def _point(
    name: str,
    mark: Mark,
    line: Line,
    derivation: Derivation,
    depends: tuple[str, ...],
    above: tuple[str, ...],
    end: ItemEnd | None,
    item: int | None,
) -> MarkPoint:
    move = line.move
    principle = PRINCIPLES.get(move.record or "") or _OF_MOVES.get(move.id, "answer")
    link = _link(line, derivation)
    match link:
        case Link(Apply(_, Quantity("deflection"))) if move.id == "identity" and not depends:
            # The tangent of a difference puts the angles together, where no line above does.
            principle = "deflection"
    answers = end is not None and mark.kind != "M"
    equation = move.id == "law" and mark.kind == "A" and not answers
    return MarkPoint(
        name,
        str(mark),
        _purpose(mark, line, derivation, principle, answers, equation),
        principle,
        move.event,
        move.bodies,
        link,
        depends,
        above,
        item if answers else None,
        answers and end is not None and end.shown,
        equation,
        _bounds(line, derivation) if answers else (),
    )


def _purpose(
    mark: Mark,
    line: Line,
    derivation: Derivation,
    principle: str,
    answers: bool,
    equation: bool,
) -> str:
    """For what a mark is given, in words."""
    if mark.star:
        return "the printed result, from correct working"
    if answers:
        return "correct answer"
    if equation:
        return "correct equation"
    if mark.kind == "A":
        return "correct value"
    event = next((event for event in derivation.events if event.number == line.move.event), None)
    title = title_of(line.move.record or "", event)
    if title is not None and principle in ("momentum", "restitution"):
        words = str(say(title))
        return words[0].lower() + words[1:] if words.startswith("Conserv") else words
    return _FOR.get(principle, "method")


def _link(line: Line, derivation: Derivation) -> Link | None:
    """What a line says from its first side to its last, in quantities."""
    relation = line.relation
    if not isinstance(relation, Relation) or not relation.options:
        return None
    links = relation.options[0]
    first, last = links[0], links[-1]
    return Link(_settled(first.left, derivation), first.sign, _settled(last.right, derivation))


def _bounds(line: Line, derivation: Derivation) -> tuple[Link, ...]:
    """The ends of the range that a line says, each as a relation: ``2/3 <= k``, ``k <= 4``."""
    relation = line.relation
    if not isinstance(relation, Relation) or len(relation.options) != 1:
        return ()
    links = tuple(
        Link(_settled(link.left, derivation), link.sign, _settled(link.right, derivation))
        for link in relation.options[0]
    )
    return links if all(link.sign in FLIPPED for link in links) else ()


def _settled(tree: Expression, derivation: Derivation) -> Expression:
    """A tree in which the letters of the working are the quantities that they stand for."""
    meanings = derivation.meanings

    def put(node: Expression) -> Expression:
        meaning = meanings.get(node.name) if isinstance(node, Letter) else None
        return node if meaning is None else meaning.quantity

    return rebuilt(tree, put)
