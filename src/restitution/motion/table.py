"""What a motion happens on: spheres, the walls around and among them, and how they rebound."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from functools import partial
from itertools import combinations
from typing import Any, NamedTuple

from restitution.counting import counted
from restitution.errors import ImpossibleError, MissingError, StatementError
from restitution.motion.arithmetic import Arithmetic, ExactNumbers, Floats, direction, vector
from restitution.motion.contact import Face
from restitution.problem import Sphere, Wall
from restitution.records import dataclass
from restitution.shapes import Circle, Line, Segment
from restitution.vector import Vector

Pairs = Mapping[str | tuple[str, str], Any]


@dataclass(frozen=True, repr=False)
class Table:
    """Smooth spheres on a smooth horizontal table, with fixed smooth walls.

    ``spheres`` are `Sphere`s with a mass, a position and a velocity at time 0, and a radius; one
    left out is negligible, which serves for a sphere among walls and for one among others that
    have one. Spheres of different radii move as discs do: their centres stay in one plane.

    ``walls`` are `Wall`s: segments (``start``, ``end``), whose ends can be struck, as can corners
    that stand out; whole lines (``along``, ``through``); circles (``centre``, ``radius``), struck
    from inside by a sphere that starts inside, else from outside. Every wall has two sides.

    ``e`` is the coefficient of restitution of all impacts, but for those in ``coefficients``: of
    all impacts with a wall, by its name, or of a pair of bodies, by both names in either order. A
    corner of several walls belongs to the one that is listed first.

    Numbers may be of any kind; text is read as in statements (``"3/4"``, ``"2i + j"``). The
    motion is in floats, or with ``exact=True`` in exact numbers: rationals and square roots of
    them, floats not admitted. All units are SI.

    Raises:
        StatementError: something cannot be read or is not finite; names that are unknown or
            given twice.
        MissingError: a mass, position or velocity, or where a wall is, was not given; spheres
            that could meet have no radius.
        ImpossibleError: a mass or a size is not positive, e lies outside [0, 1], bodies overlap.
        UnsupportedError: a number of an exact table is not made with square roots.
    """

    spheres: Sequence[Sphere]
    walls: Sequence[Wall] = ()
    e: Any = 1
    coefficients: Pairs = field(default_factory=dict)
    exact: bool = False
    layout: Layout = field(init=False, compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "spheres", _several(self.spheres, "the spheres of a table"))
        object.__setattr__(self, "walls", _several(self.walls, "the walls of a table"))
        if not isinstance(self.coefficients, Mapping):
            raise StatementError(
                "the coefficients are a dictionary from names, or pairs of names, to values, not "
                f"{self.coefficients!r}"
            )
        object.__setattr__(self, "coefficients", dict(self.coefficients))
        kind: Arithmetic = ExactNumbers() if self.exact else Floats()
        object.__setattr__(self, "layout", _layout_of(self, kind))

    @classmethod
    def box(
        cls,
        width: Any,
        height: Any,
        spheres: Sequence[Sphere],
        *,
        walls: Sequence[Wall] = (),
        e: Any = 1,
        coefficients: Pairs | None = None,
        exact: bool = False,
    ) -> Table:
        """A table with walls Left, Right, Bottom and Top, from (0, 0) to (width, height).

        ``walls`` are further ones. Raises as the table does, and ImpossibleError for a sphere
        outside the box.
        """
        kind: Arithmetic = ExactNumbers() if exact else Floats()
        names = ("the width of the box", "the height of the box")
        corner = Vector(*map(kind.number, (width, height), names))
        for size, what in zip(corner, names):
            _check_positive(size, what, kind)
        corners = {"SW": (0, 0), "SE": (width, 0), "NE": (width, height), "NW": (0, height)}
        sides = {"Left": "NW SW", "Right": "SE NE", "Bottom": "SW SE", "Top": "NE NW"}
        around = [
            Wall(name, start=corners[ends[:2]], end=corners[ends[3:]])
            for name, ends in sides.items()
        ]
        inner = _several(walls, "the walls of a table")
        table = cls(spheres, (*around, *inner), e, coefficients or {}, exact)
        _check_within(table.layout, corner)
        return table

    @classmethod
    def polygon(
        cls,
        points: Sequence[Any],
        spheres: Sequence[Sphere],
        *,
        walls: Sequence[Wall] = (),
        e: Any = 1,
        coefficients: Pairs | None = None,
        exact: bool = False,
    ) -> Table:
        """A table with walls W1, W2, …: from the first point to the second, and so round.

        ``walls`` are further ones. Raises as the table does.
        """
        inner = _several(walls, "the walls of a table")
        return cls(spheres, (*polygon(points), *inner), e, coefficients or {}, exact)

    @property
    def bodies(self) -> tuple[Sphere | Wall, ...]:
        """The spheres, and then the walls."""
        return (*self.spheres, *self.walls)

    def __repr__(self) -> str:
        layout = self.layout
        lines = [
            f"Table with {counted(len(self.spheres), 'sphere')} and "
            f"{counted(len(self.walls), 'wall')}, e = {layout.shown(layout.default_e)}"
            + (", in exact numbers" if self.exact else "")
        ]
        lines += [
            f"  {ball.name}: mass {layout.shown(ball.mass)}, "
            + (f"radius {layout.shown(ball.radius)}, " if ball.radius != 0 else "")
            + f"at {layout.shown(ball.place)}, velocity {layout.shown(ball.velocity)}"
            for ball in layout.balls
        ]
        return "\n".join(lines)


def polygon(points: Sequence[Any], name: str = "W") -> tuple[Wall, ...]:
    """The walls of a closed polygon through these points (m): W1 from the first to the second, …

    It may be convex or not; spheres may be inside or outside. Raises StatementError for fewer
    than three points.
    """
    points = _several(points, "the points of a polygon")
    if len(points) < 3:
        raise StatementError(f"a polygon has at least three points, not {len(points)}")
    return tuple(
        Wall(f"{name}{n}", start=start, end=end)
        for n, (start, end) in enumerate(zip(points, (*points[1:], points[0])), start=1)
    )


# --- the table in numbers ----------------------------------------------------------------------


class Ball(NamedTuple):
    """A sphere in numbers of one kind: kg, m, m/s."""

    name: str
    mass: Any
    radius: Any
    place: Vector
    velocity: Vector


class Post(NamedTuple):
    """A point that can be struck: the end of a wall, or a corner of several."""

    place: Vector


class Ring(NamedTuple):
    """A circular wall."""

    centre: Vector
    radius: Any


class Obstacle(NamedTuple):
    """A wall, or a point of one, with its name."""

    name: str
    shape: Face | Post | Ring


@dataclass(frozen=True)
class Layout:
    """A table in numbers of one kind: faces and circles first, then points."""

    kind: Arithmetic
    balls: tuple[Ball, ...]
    obstacles: tuple[Obstacle, ...]
    default_e: Any
    special_e: Mapping[frozenset[str], Any]

    def e(self, first: str, second: str) -> Any:
        """The coefficient of restitution between two bodies, by name."""
        for names in (frozenset((first, second)), frozenset((second,))):
            if names in self.special_e:
                return self.special_e[names]
        return self.default_e

    def shown(self, value: Any) -> str:
        """A number or a vector as text, for messages."""
        return shown(value, self.kind)


def shown(value: Any, kind: Arithmetic) -> str:
    """A number or a vector as text, for messages."""
    if isinstance(value, Vector):
        return f"({shown(value.x, kind)}, {shown(value.y, kind)})"
    return f"{value:.6g}" if isinstance(value, float) else str(kind.shown(value))


def _layout_of(table: Table, kind: Arithmetic) -> Layout:
    _check_names(table)
    balls = tuple(_ball(sphere, kind) for sphere in table.spheres)
    shapes: list[Obstacle] = []
    ends: list[tuple[str, Vector]] = []  # a point of several walls stands with the first
    for wall in table.walls:
        shape, own = _shape(wall, kind)
        shapes.append(Obstacle(wall.name, shape))
        ends += [(wall.name, end) for end in own if all(end != other for _, other in ends)]
    layout = Layout(
        kind,
        balls,
        (*shapes, *(Obstacle(name, Post(end)) for name, end in ends)),
        _coefficient(table.e, "e", kind),
        {
            _names(key, table): _coefficient(value, f"e of {_words(key)}", kind)
            for key, value in table.coefficients.items()
        },
    )
    _check_room(layout)
    return layout


def _ball(sphere: Sphere, kind: Arithmetic) -> Ball:
    name = sphere.name
    for what, value in (
        ("mass", sphere.mass),
        ("position", sphere.position),
        ("velocity", sphere.velocity),
    ):
        if value is None:
            raise MissingError(f"the {what} of {name} was not given: say Sphere(…, {what}=…)")
    mass = kind.number(sphere.mass, f"the mass of {name}")
    _check_positive(mass, f"the mass of {name}", kind)
    radius = kind.number(0 if sphere.radius is None else sphere.radius, f"the radius of {name}")
    if radius < 0:
        raise ImpossibleError(
            f"the radius of {name} is {shown(radius, kind)}: a radius is not negative"
        )
    place = vector(sphere.position, f"the position of {name}", kind)
    return Ball(name, mass, radius, place, vector(sphere.velocity, f"the velocity of {name}", kind))


def _shape(wall: Wall, kind: Arithmetic) -> tuple[Face | Ring, tuple[Vector, ...]]:
    """Where a wall is, with the points at which it ends."""
    name = wall.name
    shapes = {shape for shape in _SHAPES for part in shape if getattr(wall, part) is not None}
    if len(shapes) > 1:
        raise StatementError(
            f"the wall {name} is told in two ways: it is a segment (start, end), a whole line "
            "(along, through) or a circle (centre, radius)"
        )
    for parts in shapes or {_SHAPES[0]}:
        for part in parts:
            if getattr(wall, part) is None:
                raise MissingError(f"where the wall {name} is was not given: say Wall(…, {part}=…)")
    shape = wall.shape.read(name, partial(vector, kind=kind), kind.number)
    match shape:
        case Circle(centre, radius):
            _check_positive(radius, f"the radius of {name}", kind)
            return Ring(centre, radius), ()
        case Segment(start, end):
            return _face(start, end - start, name, kind, bounded=True), (start, end)
        case Line(along, through):
            along = direction(along, f"the direction of {name}", kind)
            return _face(through, along, name, kind, bounded=False), ()


def _face(start: Vector, along: Vector, name: str, kind: Arithmetic, *, bounded: bool) -> Face:
    square = along.dot(along)
    if square == 0:
        what = f"starts and ends at {shown(start, kind)}" if bounded else "is along the zero vector"
        raise ImpossibleError(f"the wall {name} {what}: a wall has a length")
    return Face(start, along, kind.root(square), bounded)


_SHAPES = (("start", "end"), ("along", "through"), ("centre", "radius"))


def _coefficient(value: Any, what: str, kind: Arithmetic) -> Any:
    e = kind.number(value, what)
    if e < 0 or e > 1:
        raise ImpossibleError(
            f"{what} is {shown(e, kind)}: a coefficient of restitution lies in [0, 1]"
        )
    return e


# --- checks ------------------------------------------------------------------------------------


def _check_positive(value: Any, what: str, kind: Arithmetic) -> None:
    if value <= 0:
        noun = what.split()[1]
        raise ImpossibleError(f"{what} is {shown(value, kind)}: a {noun} is positive")


def _several(values: Any, what: str) -> tuple[Any, ...]:
    try:
        return tuple(values)
    except TypeError as error:
        raise StatementError(f"{what} are a list, not one {type(values).__name__}") from error


def _check_names(table: Table) -> None:
    for bodies, kind, noun in ((table.spheres, Sphere, "spheres"), (table.walls, Wall, "walls")):
        for body in bodies:
            if not isinstance(body, kind):
                raise StatementError(
                    f"the {noun} of a table are values of type {kind.__name__}, not {body!r}"
                )
    seen = set()
    for body in table.bodies:
        if not body.name:
            raise StatementError("a body on a table has a name")
        if body.name in seen:
            raise StatementError(f"two bodies are named {body.name}")
        seen.add(body.name)


def _names(key: str | tuple[str, str], table: Table) -> frozenset[str]:
    """The bodies that a coefficient is for: a wall, or a pair."""
    walls = [wall.name for wall in table.walls]
    names = _pair(key)
    known = [body.name for body in table.bodies]
    for name in names:
        if name not in known:
            raise StatementError(
                f"e of {_words(key)}: there is no {name} here, only {', '.join(known)}"
            )
    among_walls = [name for name in names if name in walls]
    if (len(names), len(among_walls)) not in {(1, 1), (2, 0), (2, 1)} or len({*names}) < len(names):
        raise StatementError(
            f"e of {_words(key)}: a coefficient is that of a wall, of two spheres, or of a sphere "
            "and a wall"
        )
    return frozenset(names)


def _words(key: str | tuple[str, str]) -> str:
    return " and ".join(map(str, _pair(key)))


def _pair(key: Any) -> tuple[Any, ...]:
    """The names of a key, of which a wall has one."""
    return (key,) if isinstance(key, str) or not isinstance(key, Iterable) else tuple(key)


def is_inside(ball: Ball, ring: Ring, kind: Arithmetic) -> bool:
    """Whether a sphere starts within a circular wall; a point on it counts as within."""
    apart = ball.place - ring.centre
    room = ring.radius + kind.rounding((*ball.place, *ring.centre, ring.radius))
    return bool(apart.dot(apart) <= room * room)


def _check_room(layout: Layout) -> None:
    """At the start no two bodies overlap; touching is allowed."""
    kind = layout.kind
    for first, second in combinations(layout.balls, 2):
        reach = first.radius + second.radius
        if reach == 0:
            raise MissingError(
                f"the radii of {first.name} and {second.name} were not given: spheres of no size "
                "never meet"
            )
        if _nearer(first.place, second.place, reach, kind):
            raise ImpossibleError(
                f"{first.name} and {second.name} overlap at the start: their centres, at "
                f"{layout.shown(first.place)} and {layout.shown(second.place)}, are nearer to one "
                f"another than their radii together, {layout.shown(reach)}"
            )
    for ball in layout.balls:
        for obstacle in layout.obstacles:
            if _cuts(ball, obstacle, kind):
                raise ImpossibleError(
                    f"the wall {obstacle.name} cuts through {ball.name} at the start, at "
                    f"{layout.shown(ball.place)} with radius {layout.shown(ball.radius)}"
                )


def _check_within(layout: Layout, corner: Vector) -> None:
    """At the start no sphere is outside the box from (0, 0) to a corner."""
    for ball in layout.balls:
        room = layout.kind.rounding((*ball.place, *corner))
        if not all(-room <= x <= side + room for x, side in zip(ball.place, corner)):
            raise ImpossibleError(
                f"{ball.name} is outside the box at the start, at {layout.shown(ball.place)}: the "
                f"box is from (0, 0) to {layout.shown(corner)}"
            )


def _cuts(ball: Ball, obstacle: Obstacle, kind: Arithmetic) -> bool:
    shape = obstacle.shape
    if isinstance(shape, Post):
        return _nearer(shape.place, ball.place, ball.radius, kind)
    if isinstance(shape, Face):
        sure = ball.radius - kind.rounding((*ball.place, *shape.start, ball.radius))
        foot = shape.along.dot(ball.place - shape.start)
        beside = shape.bounded and (foot < 0 or foot > shape.length * shape.length)
        return bool(abs(shape.height(ball.place)) < sure) and not beside
    if not is_inside(ball, shape, kind):
        return _nearer(shape.centre, ball.place, shape.radius + ball.radius, kind)
    room = shape.radius - ball.radius
    if room <= 0:
        raise ImpossibleError(
            f"{ball.name} does not fit into the circular wall {obstacle.name}: their radii are "
            f"{shown(ball.radius, kind)} and {shown(shape.radius, kind)}"
        )
    apart = ball.place - shape.centre
    room += kind.rounding((*ball.place, *shape.centre, shape.radius))
    return bool(apart.dot(apart) > room * room)


def _nearer(one: Vector, other: Vector, reach: Any, kind: Arithmetic) -> bool:
    """Whether two points are nearer to one another than ``reach``, beyond rounding."""
    apart = other - one
    sure = reach - kind.rounding((*one, *other, reach))
    return bool(sure > 0 and apart.dot(apart) < sure * sure)
