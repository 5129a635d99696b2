"""The plan view of a story: walls, the paths of the centres, and where they meet."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import field, replace
from fractions import Fraction

from restitution import shapes
from restitution.counting import listed
from restitution.drawing.bodies import name_of
from restitution.drawing.distances import distances
from restitution.drawing.geometry import sides_towards
from restitution.drawing.ink import ink, overlap, padded, touched
from restitution.drawing.known import Known
from restitution.drawing.path_words import description, note
from restitution.drawing.sayings import is_angle, sayings, speaks_of_vectors
from restitution.drawing.scene import (
    WIDTH,
    Arc,
    Arrow,
    Disc,
    Dot,
    Label,
    Line,
    RightAngle,
    RoundWall,
    Scene,
    Shape,
    Side,
    StraightWall,
)
from restitution.errors import RestitutionError
from restitution.expression.tree import Binary, Degrees, Expression, Pair, Unit, walk
from restitution.problem import Arrival, Impact, Problem
from restitution.records import dataclass
from restitution.render import layout as lay
from restitution.render.glyphs import union
from restitution.render.layout import Bold, Layout, Number
from restitution.render.short import angle_label
from restitution.solving.equations.solution import Branch, PartSolution, Solution
from restitution.solving.story.forward import Story
from restitution.staging.geometry import direction, length, unit
from restitution.staging.plan import Leg, Plan, Stop, Straight
from restitution.staging.planning import lay_out
from restitution.staging.values import PartInNumbers, motion
from restitution.vector import Vector

_SAME = 1e-9
# On a longer way, only the first and the last speeds are shown; and none beside short pieces.
_MANY, _NARROW = 5, 9.0
_ARC = 6.0
_LEAST_ARC = 2.4
_MARGIN = 5.0
# The radius of a disc that has room for its letter.
_LETTERED = 2.3
# Spheres that are smaller are dots.
_DISC = 0.8
_NEAR = 1e-6


def path_scene(
    solution: Solution, part: PartSolution, branch: Branch, numbers: PartInNumbers | None = None
) -> Scene | None:
    """The plan view of the story up to a part, by one of its solutions.

    None for a story without walls and without places, which a plan would not make clearer.
    ``told`` is the part in numbers, where that is known already.
    """
    if not _is_plannable(solution):
        return None
    numbers = motion(solution, part, branch) if numbers is None else numbers
    plan = lay_out(numbers.story, len(numbers.story.happenings) - len(part.part.events))
    if plan is None:
        return None
    values = Known(solution, part, branch, numbers)
    drawing = _Drawing(plan, values)
    drawing.everything()
    names = list(dict.fromkeys(leg.body for leg in plan.legs))
    title = f"Plan of the paths of {listed(names)}" if len(names) > 1 else f"Path of {names[0]}"
    return drawing.scene(title, description(plan, values), note(plan, numbers))


def path_figure(
    solution: Solution, part: PartSolution, branch: Branch, numbers: PartInNumbers | None = None
) -> Scene | None:
    """The plan view of what a question tells: walls, places, and how the bodies come.

    It gives nothing of the answers away, and is None where ``path_scene`` is, and where the
    direction of a wall is sought.
    """
    problem = solution.problem
    unknown = [
        w for w in problem.walls if isinstance(w.shape, shapes.Line) and w.shape.along is None
    ]
    if unknown or not _is_plannable(solution):
        return None
    numbers = motion(solution, part, branch) if numbers is None else numbers
    plan = lay_out(numbers.story)
    if plan is None:
        return None
    legs = tuple(
        replace(leg, lane=0.0) for leg in plan.legs if leg.after == 0 and leg.kind != "exit"
    )
    plan = replace(plan, legs=legs, side_by_side=False)
    values = Known(solution, part, branch, numbers, sayings(numbers))
    drawing = _Drawing(plan, values)
    drawing.everything()
    names = [name for name in numbers.story.spheres if name in plan.starts]
    walls = [*(wall.name for wall in plan.walls), *(circle.name for circle in plan.rounds)]
    towards = [
        f"{leg.body} moves towards {stop.wall}"
        for leg in legs
        for stop in plan.stops
        if stop.wall is not None and stop.kind != "arrival"
        if length(stop.centres.get(leg.body, leg.start) - leg.end) < _NEAR
    ]
    sentences = [f"Plan view of {listed([*names, *(f'the wall {name}' for name in walls)])}"]
    return drawing.scene("Plan view", ". ".join([*sentences, *towards]) + ".", None)


def _is_plannable(solution: Solution) -> bool:
    problem = solution.problem
    return bool(problem.walls) or any(s.position is not None for s in problem.spheres)


# --- the drawing ----------------------------------------------------------------------------------


@dataclass
class _Drawing:
    """Shapes and labels as they are put down."""

    plan: Plan
    values: Known
    shapes: list[Shape] = field(default_factory=list)
    labels: list[Label] = field(default_factory=list)
    named: set[str] = field(default_factory=set)

    @property
    def question(self) -> bool:
        """Whether only what the question says is to be seen."""
        return self.values.sayings is not None

    def everything(self) -> None:
        """Draws all of it, in an order in which the later can make room for the earlier."""
        self.walls()
        self.corners()
        self.paths()
        self.bodies()
        self.angles()
        self.numbers()
        self.points()
        self.distances()
        self.axes()

    def scene(self, title: str, description: str, note: Layout | None) -> Scene:
        """What has been drawn, in the middle of a picture of the natural width or more."""
        left, bottom, right, top = self.box()
        middle = (left + right) / 2
        half = max((right - left) / 2, WIDTH / 2)
        box = middle - half, bottom, middle + half, top
        return Scene(title, description, box, tuple(self.shapes), tuple(self.labels), note=note)

    # --- walls ----------------------------------------------------------------------------

    def walls(self) -> None:
        for wall in self.plan.walls:
            self.shapes.append(StraightWall(wall.name, wall.start, wall.end, wall.far))
            self._wall_name(wall)
        for round_ in self.plan.rounds:
            self.shapes.append(
                RoundWall(
                    round_.name,
                    round_.centre,
                    round_.radius,
                    0.0,
                    2 * math.pi,
                    "outside" if round_.inside else "inside",
                )
            )
            self.shapes.append(Dot("", round_.centre, 0.5))

    def corners(self) -> None:
        """The angles at which walls meet, where they are given by angles."""
        directions = {wall.name: wall.along for wall in self.values.solution.problem.walls}
        for wall in self.plan.walls:
            for other in self.plan.walls:
                one, two = directions.get(wall.name), directions.get(other.name)
                if other.name not in wall.corners or wall.name > other.name:
                    continue
                tree = _between(one, two)
                if tree is not None:
                    self._corner(wall, other, tree)

    def _corner(self, wall: Straight, other: Straight, tree: Expression) -> None:
        ends = [(a, b) for a in (wall.start, wall.end) for b in (other.start, other.end)]
        corner, same = min(ends, key=lambda end: length(end[0] - end[1]))
        if length(corner - same) > _NEAR:
            return
        directions = [
            direction(line.end - corner if line.start in (corner, same) else line.start - corner)
            for line in (wall, other)
        ]
        turn = math.acos(max(-1.0, min(1.0, directions[0].dot(directions[1]))))
        if abs(turn - math.pi / 2) < _NEAR or turn < 0.1 or turn > math.pi - 0.1:
            return
        try:
            angle = self.values.motion.story.evaluator(0).value(tree)
            value = float(angle.measure() if hasattr(angle, "measure") else angle)
        except (RestitutionError, ArithmeticError, LookupError, TypeError, ValueError):
            return
        label = angle_label(tree, value, turn, lay.from_tree(tree))
        if label is None:
            return
        low, high = sorted(map(_bearing, directions))
        if high - low > math.pi:
            low, high = high, low + 2 * math.pi
        radius = min(_ARC, self._room(corner))
        self.shapes.append(Arc("angle", corner, radius, low, high))
        bisector = Vector(math.cos((low + high) / 2), math.sin((low + high) / 2))
        self.labels.append(
            Label(label, corner + bisector * radius, sides_towards(bisector), gap=0.7, size=2.7)
        )

    def _room(self, vertex: Vector) -> float:
        """The radius of an arc that no arc at another corner or impact meets."""
        others = [end for wall in self.plan.walls for end in (wall.start, wall.end)]
        others += [centre for stop in self.plan.stops for centre in stop.centres.values()]
        apart = (length(vector - vertex) for vector in others)
        return max(_LEAST_ARC, 0.45 * min((x for x in apart if x > _NEAR), default=math.inf))

    def _wall_name(self, wall: Straight) -> None:
        letters = _ends_named(wall.name)
        if letters is None:
            at, out = wall.end, unit(wall.end - wall.start)
            if wall.corners[1] is not None and wall.corners[0] is None:
                at, out = wall.start, -out
            inward = at - out * 3
            moves = (inward - out * 6,)
            self.labels.append(
                Label(name_of(wall.name), inward, sides_towards(wall.far), gap=2.6, moves=moves)
            )
            return
        corners = list(wall.corners)
        for k, other in enumerate(corners):
            if other is None:
                continue
            shared = set(letters) & set(_ends_named(other) or ())
            if len(shared) == 1:
                letter = shared.pop()
                beside = next(w for w in self.plan.walls if w.name == other)
                self._point_name(letter, (wall.start, wall.end)[k], wall.far + beside.far)
                rest = letters[1] if letters[0] == letter else letters[0]
                if corners[1 - k] is None:
                    self._end_name(rest, wall, 1 - k)
                return
        for k in (0, 1):
            if corners[k] is None:
                self._end_name(letters[k], wall, k)

    def _end_name(self, letter: str, wall: Straight, end: int) -> None:
        outward = unit(wall.end - wall.start) * (1 if end else -1)
        self._point_name(letter, (wall.start, wall.end)[end], outward)

    def _point_name(self, letter: str, at: Vector, outward: Vector) -> None:
        if letter not in self.named:
            self.named.add(letter)
            self.labels.append(Label(name_of(letter), at, sides_towards(outward), gap=1.6))

    # --- paths ----------------------------------------------------------------------------

    def paths(self) -> None:
        several = len({leg.body for leg in self.plan.legs}) > 1
        latest: dict[str, Leg] = {}
        for leg in self.plan.legs:
            start, end = leg.start + leg.shift, leg.end + leg.shift
            before = latest.get(leg.body)
            if before is not None:
                turn = before.end + before.shift
                if length(start - turn) > _NEAR:
                    self.shapes.append(Line("path", turn, start))
            latest[leg.body] = leg
            start = self._outside(start, leg)
            if leg.kind == "exit":
                self.shapes.append(Arrow("path", start, end))
            else:
                middle = start + (end - start) * 0.55
                self.shapes.append(Arrow("path", start, middle))
                self.shapes.append(Line("path", middle, end))
            self._speed(leg, start, end)
            if several and leg.kind == "exit":
                self.labels.append(
                    Label(name_of(leg.body), end, sides_towards(leg.direction), gap=1.2)
                )

    def _outside(self, start: Vector, leg: Leg) -> Vector:
        """Where a path leaves the disc that has a letter in it."""
        if self.plan.radius < _LETTERED:
            return start
        out = start - self._start(leg.body)
        return start + leg.direction * _half_chord(self.plan.radius, out)

    def _speed(self, leg: Leg, start: Vector, end: Vector) -> None:
        crowded = leg.kind != "exit" and (
            len(self.plan.legs) > _MANY or length(leg.end - leg.start) < _NARROW
        )
        if leg.after and (crowded or _unchanged(self.plan, leg)):
            return
        layout = self.values.speed(leg.body, leg.after)
        if layout is None:
            return
        across = leg.direction.turned_left()
        onward = next(
            (x for x in self.plan.legs if x.body == leg.body and x.after > leg.after), None
        )
        if leg.lane:
            down = leg.lane < 0
        elif leg.after == 0 and onward is not None and not onward.lane:
            down = across.dot(onward.direction) > 0  # outside the angle that the path makes
        else:
            down = across.y < 0
        across = -across if down else across
        spots = [start + (end - start) * share for share in (0.5, 0.4, 0.62, 0.3, 0.75)]
        sides = (*sides_towards(across)[:3], *sides_towards(-across)[:3])
        self.labels.append(Label(layout, spots[0], sides, gap=1.0, moves=tuple(spots[1:])))

    # --- bodies ---------------------------------------------------------------------------

    def bodies(self) -> None:
        radius = self.plan.radius
        for name in self.plan.starts:
            leg = next((leg for leg in self.plan.legs if leg.body == name), None)
            at = self._start(name)
            away = -leg.direction if leg is not None and leg.after == 0 else Vector(-1.0, 1.0)
            if radius >= _LETTERED and len(name) == 1:
                self.shapes.append(Disc(name, at, radius))
                self.labels.append(Label(name_of(name), at, ("centre",), fixed=True))
                continue
            self.shapes.append(Disc(name, at, radius) if radius >= _DISC else Dot(name, at, 1.0))
            self.labels.append(
                Label(name_of(name), at, sides_towards(away), gap=max(radius, 1.0) + 0.6)
            )
        for stop in () if self.question else self.plan.stops:
            if stop.kind == "spheres":
                self._meeting(stop)
            elif radius >= _DISC and stop.kind in ("wall", "circle"):
                for name, centre in stop.centres.items():
                    self.shapes.append(Disc(name, centre, radius, ghost=True))

    def _start(self, name: str) -> Vector:
        """Where a sphere is at the start: on the lane of the path that begins there."""
        leg = next((leg for leg in self.plan.legs if leg.body == name), None)
        start = self.plan.starts[name]
        return start if leg is None or length(leg.start - start) > _NEAR else start + leg.shift

    def _meeting(self, stop: Stop) -> None:
        assert stop.normal is not None
        radius = self.plan.radius
        centres = dict(stop.centres)
        if radius < _DISC:
            radius = 1.6
            signs = (-1, 1)
            centres = {
                name: stop.contact + stop.normal * (sign * radius)
                for name, sign in zip(stop.centres, signs, strict=True)
            }
        line = [-radius - 2.5, 2 * radius + radius + 2.5]
        for (name, centre), along in zip(centres.items(), (0.0, 2 * radius), strict=True):
            out = centre - self._start(name)
            if length(out) > self.plan.radius - _NEAR or not self.plan.radius:
                self.shapes.append(Disc(name, centre, radius, ghost=True))
            elif self.plan.radius >= _LETTERED:  # not through its letter
                line += [along - radius, along + radius]
        first = next(iter(centres.values()))
        ends = [first + stop.normal * x for x in sorted(line)]
        for start, end in zip(ends[::2], ends[1::2], strict=True):
            self.shapes.append(Line("line_of_centres", start, end))

    # --- angles ---------------------------------------------------------------------------

    def angles(self) -> None:
        for stop in self.plan.stops:
            if stop.kind not in ("wall", "circle") or stop.normal is None:
                continue
            body = next(iter(stop.centres))
            centre = stop.centres[body]
            before = self._leg_to(body, centre, stop.number)
            after = next(
                (leg for leg in self.plan.legs if leg.body == body and leg.after == stop.number),
                None,
            )
            along = stop.normal.turned_left()
            drawn = False
            for leg in (before, after):
                if leg is None or any(side is not None and side.lane for side in (before, after)):
                    continue
                if leg is before and self._alternate(body, stop):
                    continue
                ray = leg.direction if leg is after else -leg.direction
                layout = self.values.angle(body, stop, before=leg is before)
                if stop.kind == "circle":
                    reference = -stop.normal
                else:
                    reference = along if ray.dot(along) >= 0 else -along
                    if not self._on_wall(stop.contact + reference * 2):
                        continue  # struck in a corner
                drawn |= self._angle(centre, reference, ray, layout, leg)
            if stop.kind == "circle" and drawn:
                inside = any(r.name == stop.wall and r.inside for r in self.plan.rounds)
                wall = next(r for r in self.plan.rounds if r.name == stop.wall)
                end = wall.centre if inside else stop.contact - stop.normal * 12
                self.shapes.append(Line("across", stop.contact, end))
            elif drawn and self.plan.radius >= _DISC:
                self.shapes.append(Line("across", centre - along * 9, centre + along * 9))

    def _angle(
        self, corner: Vector, reference: Vector, ray: Vector, layout: Layout | None, leg: Leg
    ) -> bool:
        turn = abs(math.atan2(reference.cross(ray), reference.dot(ray)))
        if layout is None or turn < 0.02:
            return False
        if abs(turn - math.pi / 2) < _NEAR:
            self.shapes.append(RightAngle(corner, reference, ray))
            return True
        radius = min(_ARC if turn > 0.3 else 1.6 * _ARC, 0.45 * length(leg.end - leg.start))
        radius = min(radius, self._room(corner))
        low, high = sorted((_bearing(reference), _bearing(ray)))
        if high - low > math.pi:
            low, high = high, low + 2 * math.pi
        self.shapes.append(Arc("angle", corner, radius, low, high))
        middle = (low + high) / 2
        bisector = Vector(math.cos(middle), math.sin(middle))
        self.labels.append(
            Label(layout, corner + bisector * radius, sides_towards(bisector), gap=0.7, size=2.7)
        )
        return True

    def _on_wall(self, point: Vector) -> bool:
        return any(
            abs((point - wall.start).dot(wall.far)) < _NEAR
            and (point - wall.start).dot(wall.end - wall.start) > 0
            and (point - wall.end).dot(wall.start - wall.end) > 0
            for wall in self.plan.walls
        )

    def _alternate(self, body: str, stop: Stop) -> bool:
        """Whether an angle is that with the parallel wall before, where it is shown already."""
        own = [stop for stop in self.plan.stops if body in stop.centres]
        last = own[own.index(stop) - 1] if own.index(stop) else None
        return (
            last is not None
            and last.kind == stop.kind == "wall"
            and last.normal is not None
            and stop.normal is not None
            and abs(last.normal.cross(stop.normal)) < _SAME
            and self.values.angle(body, last, before=False) is not None
        )

    def _leg_to(self, body: str, centre: Vector, number: int) -> Leg | None:
        own = [leg for leg in self.plan.legs if leg.body == body and leg.after < number]
        return own[-1] if own and length(own[-1].end - centre) < _NEAR else None

    # --- numbers and points ---------------------------------------------------------------

    def numbers(self) -> None:
        for stop in () if self.question else self.plan.stops:
            beyond = stop.normal if stop.normal is not None else Vector(0.0, 1.0)
            gap = 2.8
            if stop.kind == "spheres":
                beyond, gap = beyond.turned_left(), max(self.plan.radius, 1.6) + 1.0
            elif stop.kind in ("kick", "arrival") and stop.wall is None:
                gap = 1.6
            self.labels.append(
                Label(
                    Number(str(stop.number)),
                    stop.contact,
                    (*sides_towards(beyond), *sides_towards(-beyond)[:1]),
                    gap=gap,
                    size=2.5,
                    ringed=True,
                )
            )
            if stop.kind != "spheres":
                self.shapes.append(Dot(str(stop.number), stop.contact, 0.6))

    def points(self) -> None:
        taken = [self.plan.starts[name] for name in self.plan.starts]
        for name, at in self.plan.points.items():
            if not any(length(at - s) < 0.5 for s in taken):
                self.shapes.append(Dot(name, at))
            if name not in self.named:
                self.named.add(name)
                self.labels.append(Label(name_of(name), at, gap=1.4))

    def distances(self) -> None:
        for distance in distances(self.plan, *self._exact()):
            for start, end in distance.leads:
                self.shapes.append(Line("leader", start, end))
            self.shapes.append(Arrow("measure", distance.start, distance.end, both=True))
            middle = (distance.start + distance.end) / 2
            spots = tuple(
                distance.start + (distance.end - distance.start) * k for k in (0.35, 0.65, 0.2, 0.8)
            )
            across = unit(distance.end - distance.start).turned_left()
            if abs(across.y) > 0.5 and across.y > 0:
                across = -across
            sides = (*sides_towards(across)[:3], *sides_towards(-across)[:3])
            self.labels.append(Label(distance.label, middle, sides, gap=0.8, size=2.7, moves=spots))

    def _exact(self) -> tuple[Story, Branch]:
        """The story in letters: with what is sought as letters still, in a question."""
        values = self.values
        still_open = values.part.open_story if self.question else None
        return still_open or values.branch.story, values.branch

    def axes(self) -> None:
        if not _speaks_of_axes(self.values.solution.problem):
            return
        left, bottom, right, top = self.box()
        size, room = 7.0, 11.0
        pieces = [piece for shape in self.shapes for piece in ink(shape)]
        taken = [padded((at.x, at.y, at.x, at.y), 3.0) for at in self._named_places()]
        xs = (left + 1, right - room, (left + right - room) / 2)
        corners = [Vector(x, y) for y in (bottom + 1, top - room) for x in xs]
        corners += [Vector(left + 1, bottom - room), Vector(left - room, bottom + 1)]

        def free(corner: Vector) -> bool:
            box = (corner.x - 1, corner.y - 1, corner.x + room, corner.y + room)
            return not touched(box, pieces, 1.0) and not any(overlap(box, place) for place in taken)

        origin = next(filter(free, corners), Vector(left - room, bottom + 1))
        named: tuple[tuple[Vector, str, tuple[Side, ...]], ...] = (
            (Vector(1.0, 0.0), "i", ("e", "se", "ne")),
            (Vector(0.0, 1.0), "j", ("n", "nw", "ne")),
        )
        for axis, name, sides in named:
            end = origin + axis * size
            self.shapes.append(Arrow("axis", origin, end))
            self.labels.append(Label(Bold(name), end, sides, gap=0.8))

    # --- extent ---------------------------------------------------------------------------

    def _named_places(self) -> Iterator[Vector]:
        for label in self.labels:
            yield label.at

    def box(self) -> tuple[float, float, float, float]:
        boxes = [piece.box for shape in self.shapes for piece in ink(shape)]
        return padded(union(boxes), _MARGIN)


# --- small geometry -------------------------------------------------------------------------------


def _between(one: object, other: object) -> Expression | None:
    """The angle between walls that run along **i** or at an angle with it; None for others."""
    trees = [Degrees(Fraction(0)) if ray == Unit("i") else ray for ray in (one, other)]
    first, second = trees
    if not isinstance(first, Expression) or not isinstance(second, Expression):
        return None
    if not (is_angle(first) and is_angle(second)):
        return None
    if first == Degrees(Fraction(0)):
        return second
    return first if second == Degrees(Fraction(0)) else Binary("-", second, first)


def _bearing(v: Vector) -> float:
    return math.atan2(v.y, v.x)


def _half_chord(radius: float, out: Vector) -> float:
    """How far it is to the rim of a disc along a line that passes its centre at right angles."""
    return math.sqrt(max(radius**2 - out.dot(out), 0.0)) if length(out) < radius else 0.0


def _unchanged(plan: Plan, leg: Leg) -> bool:
    """Whether a piece of path goes on as the one before: after a point that is only reached."""
    return any(stop.number == leg.after and stop.kind == "arrival" for stop in plan.stops)


def _ends_named(name: str) -> tuple[str, str] | None:
    """The two letters of a wall AB, which name its ends."""
    return (name[0], name[1]) if len(name) == 2 and name.isalpha() and name.isupper() else None


def _speaks_of_axes(problem: Problem) -> bool:
    """Whether **i** and **j** are more than a way to say how a wall lies, or where things are."""
    slanting = [wall.along for wall in problem.walls if not isinstance(wall.along, Unit)]
    return speaks_of_vectors(problem, apart_from=(Impact, Arrival)) or any(
        isinstance(node, Unit | Pair)
        for tree in slanting
        if isinstance(tree, Expression)
        for node in walk(tree)
    )
