"""Few spheres on a table: against closed forms, mirror images, and what any motion must satisfy."""

from __future__ import annotations

import math
import pickle
from dataclasses import replace
from fractions import Fraction
from itertools import combinations, pairwise

import mpmath
import numpy as np
import pytest
import strategies
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

import restitution as r
from restitution import Sphere, Table, Wall, simulate
from restitution.motion import polygon
from restitution.motion.contact import meeting
from restitution.motion.surds import Tower
from restitution.vector import Vector

KINDS = pytest.mark.parametrize("exact", [False, True], ids=["floats", "exact"])


def sphere(name, position, velocity, *, mass=1, radius="1/2"):
    return Sphere(name, mass=mass, radius=radius, position=position, velocity=velocity)


def size(vector):
    return math.hypot(float(vector[0]), float(vector[1]))


def gap(place, wall):
    """How far a point is from a wall, from its definition alone; a line is a long segment."""
    x, y = (float(each) for each in place)
    if wall.centre is not None:
        cx, cy = numbers(wall.centre)
        return abs(math.hypot(x - cx, y - cy) - number(wall.radius))
    (ax, ay), (bx, by) = numbers(wall.start), numbers(wall.end)
    dx, dy = bx - ax, by - ay
    share = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)
    share = min(max(share, 0.0), 1.0)
    return math.hypot(x - ax - share * dx, y - ay - share * dy)


def number(value):
    from restitution.expression.evaluate import evaluate

    return value if isinstance(value, float) else float(evaluate(value, None))


def numbers(pair):
    x, y = pair if isinstance(pair, tuple) else (pair.x, pair.y)
    return number(x), number(y)


def turned(table, angle, shift):
    """The same table in floats, turned and moved: nothing lies along an axis any more."""
    c, s = math.cos(angle), math.sin(angle)

    def turn(pair):
        x, y = numbers(pair)
        return c * x - s * y, s * x + c * y

    def move(pair):
        x, y = turn(pair)
        return x + shift[0], y + shift[1]

    spheres = [
        replace(each, position=move(each.position), velocity=turn(each.velocity))
        for each in table.spheres
    ]
    walls = [
        replace(wall, start=move(wall.start), end=move(wall.end))
        if wall.centre is None
        else replace(wall, centre=move(wall.centre))
        for wall in table.walls
    ]
    return replace(table, spheres=spheres, walls=walls)


def overlap(run, time):
    """The deepest overlap of any two bodies at a time, in m; negative where all are apart."""
    radii = {each.name: 0 if each.radius is None else number(each.radius) for each in balls(run)}
    now = run.at(time)
    depths = [
        radii[a] + radii[b] - size(now[a].position - now[b].position)
        for a, b in combinations(radii, 2)
    ]
    depths += [radii[a] - gap(now[a].position, wall) for a in radii for wall in run.table.walls]
    return max(depths)


def balls(run):
    return run.table.spheres


def moments(run, between=2):
    """The times of all impacts, and some between them."""
    times = sorted({0.0, *map(float, run.events["time"]), float(run.end)})
    for start, end in pairwise(times):
        yield start
        yield from (start + (end - start) * n / between for n in range(1, between))
    yield times[-1]


def energy(run, time):
    return sum(
        number(each.mass) * size(run.at(time)[each.name].velocity) ** 2 / 2 for each in balls(run)
    )


def played(table, **until):
    """The motion, up to a collapse if there is one."""
    try:
        return simulate(table, **until)
    except r.CollapseError as error:
        return error.run


# --- closed forms ------------------------------------------------------------------------------


@pytest.mark.parametrize("offset", [0.0, 0.3, -0.6, 0.9, 0.999])
@pytest.mark.parametrize("e", [0.0, 0.4, 1.0])
def test_two_discs_by_the_textbook(offset, e):
    """A strikes B at rest; b = (r₁ + r₂) sin φ, and B moves off along the line of centres."""
    m1, m2, r1, r2, u = 2.0, 3.0, 0.7, 0.4, 1.7
    table = Table(
        [
            sphere("A", (-5.0, 0.0), (u, 0.0), mass=m1, radius=r1),
            sphere("B", (3.0, offset * (r1 + r2)), (0.0, 0.0), mass=m2, radius=r2),
        ],
        e=e,
    )
    (hit,) = simulate(table, impacts=5).impacts
    phi = math.asin(offset)
    c, s = math.cos(phi), math.sin(phi)
    along = m2 * (1 + e) / (m1 + m2) * u * c
    assert hit.time == pytest.approx((8 - (r1 + r2) * c) / u, rel=1e-13)
    assert hit.line_of_centres == pytest.approx((c, s), rel=1e-13, abs=1e-13)
    assert hit.impulse == pytest.approx((m1 * along * c, m1 * along * s), rel=1e-13, abs=1e-13)
    assert hit.after[0] == pytest.approx((u - along * c, -along * s), rel=1e-13, abs=1e-13)
    speed = m1 / m2 * along
    assert hit.after[1] == pytest.approx((speed * c, speed * s), rel=1e-13, abs=1e-13)


@KINDS
def test_centres_on_parallel_paths(exact):
    """Masses 3 and 2, speeds 1 and 2 towards each other, d = 1.6 r, e = 1/6: impulse 2.52."""
    table = Table(
        [
            sphere("A", (0, 0), (1, 0), mass=3, radius=1),
            sphere("B", (9, "1.6"), (-2, 0), mass=2, radius=1),
        ],
        e="1/6",
        exact=exact,
    )
    (hit,) = simulate(table, impacts=9).impacts
    assert size(hit.impulse) == pytest.approx(63 * 2 / 50, rel=1e-14)
    assert hit.line_of_centres == pytest.approx((0.6, 0.8), rel=1e-14)
    if exact:
        assert hit.line_of_centres == (sympy.Rational(3, 5), sympy.Rational(4, 5))
        assert hit.time == sympy.Rational(13, 5)


def test_corner_of_120_degrees_in_surds():
    """The speed is √7/4 after the first wall and √103/16 after the second."""
    table = Table(
        [Sphere("P", mass=1, position="3i + j", velocity="1 at -60°")],
        [
            Wall("AB", start=(0, 0), end=(10, 0)),
            Wall("BC", start=(10, 0), end="10i + 10(i + √3 j)"),
        ],
        e="1/2",
        exact=True,
    )
    first, second = simulate(table, impacts=2).impacts
    assert (first.second, second.second) == ("AB", "BC")
    assert sympy.sqrt(first.after[0].dot(first.after[0])) == sympy.sqrt(7) / 4
    assert sympy.nsimplify(second.after[0].dot(second.after[0])) == sympy.Rational(103, 256)


@pytest.mark.parametrize("height", [-0.9, -0.5, 0.0, 0.3, 0.99])
@pytest.mark.parametrize("kind", ["end", "circle"])
def test_end_of_a_wall_and_a_circle_from_outside(height, kind):
    """A path at a height b comes to a point, or a circle, under the angle arcsin(b/reach)."""
    wall = (
        Wall("W", start=(0.0, 0.0), end=(9.0, 0.0))
        if kind == "end"
        else Wall("W", centre=(0.0, 0.0), radius=1.5)
    )
    reach = 0.5 if kind == "end" else 2.0
    ball = sphere("P", (-7.0, height * reach), (2.0, 0.0))
    (hit,) = simulate(Table([ball], [wall], e=0.5), impacts=9).impacts
    phi = math.asin(height)
    assert hit.time == pytest.approx((7 - reach * math.cos(phi)) / 2, rel=1e-13)
    normal = np.array([-math.cos(phi), math.sin(phi)])
    u = np.array([2.0, 0.0])
    assert hit.after[0] == pytest.approx(u - 1.5 * u.dot(normal) * normal, rel=1e-12, abs=1e-13)
    assert size(hit.place) == pytest.approx(reach - 0.5, abs=1e-14)


@KINDS
def test_ten_impacts_in_a_rectangle_by_mirror_images(exact):
    """Unfolded at every wall the path is straight: the place is that of a triangle wave."""
    width, height = Fraction(7), Fraction(4)
    radius, start, velocity = Fraction(1, 3), (Fraction(2), Fraction(1)), (Fraction(3), Fraction(5))
    ball = sphere("P", start, velocity, radius=radius)
    run = simulate(Table.box(width, height, [ball], exact=exact), impacts=10)
    assert len(run.events) == 10

    def folded(x, v, time, room):
        unfolded = (x - radius + v * time) % (2 * room)
        return radius + min(unfolded, 2 * room - unfolded)

    times = sorted(
        time
        for x, v, room in zip(start, velocity, (width - 2 * radius, height - 2 * radius))
        for n in range(1, 20)
        if (time := (n * room - (x - radius)) / v) > 0
    )
    for time, hit in zip(times, run.impacts):
        place = run.at(time)["P"].position
        rooms = (width - 2 * radius, height - 2 * radius)
        wanted = [folded(*each, time, room) for *each, room in zip(start, velocity, rooms)]
        if exact:
            assert hit.time == sympy.Rational(time.numerator, time.denominator)
            assert list(place) == [sympy.Rational(x.numerator, x.denominator) for x in wanted]
        else:
            assert hit.time == pytest.approx(float(time), rel=1e-14)
            assert place == pytest.approx([float(x) for x in wanted], rel=1e-13)


@KINDS
def test_inside_a_circle_every_chord_is_the_same(exact):
    run = simulate(
        Table(
            [sphere("P", (0, 0), ("1/5", 1), radius=1), sphere("Q", (90, 0), (0, 0))],
            [Wall("C", centre=(-1, 0), radius=4)],
            exact=exact,
        ),
        impacts=10 if exact else 400,
    )
    events = run.events
    sines = np.hypot(events["line_x"], events["line_y"])
    assert sines == pytest.approx(1, rel=1e-14)
    angle = events["u1_x"] * events["line_x"] + events["u1_y"] * events["line_y"]
    assert angle == pytest.approx(angle[0], rel=1e-11)
    assert np.diff(events["time"]) == pytest.approx(2 * angle[0] * 3 / 1.04, rel=1e-11)
    if exact:  # Q is outside, and one root is enough for ten impacts
        first, second = run.impacts[:2]
        left = run.impacts[9].time - first.time - 9 * (second.time - first.time)
        assert sympy.expand(left) == 0


def test_loss_inside_a_circle():
    """tan β = e tan α at every impact."""
    table = Table([sphere("P", (0, 1), (1, 0))], [Wall("C", centre=(0, 0), radius=3)], e=0.9)
    for hit in simulate(table, impacts=30).impacts:
        tangent = hit.line_of_centres.turned_left()
        (u, v), c = (hit.before[0], hit.after[0]), hit.line_of_centres
        assert v.dot(tangent) == pytest.approx(u.dot(tangent), rel=1e-12)
        assert v.dot(c) == pytest.approx(-0.9 * u.dot(c), rel=1e-12)


@pytest.mark.parametrize(
    ("figures", "exact", "wanted"),
    [
        (0, True, 3),
        (1, True, 31),
        (2, True, 314),
        (1, False, 31),
        (2, False, 314),
        (3, False, 3141),
    ],
)
def test_impacts_count_the_figures_of_pi(figures, exact, wanted):
    """Galperin (2003): a wall, a light sphere and one 100ⁿ times as heavy, all elastic."""
    table = Table(
        [
            sphere("A", (2, 0), (0, 0)),
            sphere("B", (5, 0), (-1, 0), mass=100**figures),
        ],
        [Wall("W", along="j", through=(0, 0))],
        exact=exact,
    )
    assert len(simulate(table, impacts=10**5).events) == wanted


# --- an independent finder of roots ------------------------------------------------------------

components = st.floats(-4, 4).map(lambda x: round(x, 6))


@given(st.tuples(components, components), st.tuples(components, components), st.floats(0.01, 2))
def test_time_of_meeting_by_a_finder_of_roots(place, velocity, reach):
    """The distance, with 60 digits, at its least and by bisection."""
    apart, v = Vector(*place), Vector(*velocity)
    if size(apart) <= reach * 1.001 or size(v) < 1e-3:
        return
    contact = meeting(apart, v, reach, math.sqrt, 0.0)
    with mpmath.workdps(60):
        x, y, vx, vy = map(mpmath.mpf, (*place, *velocity))

        def excess(time):
            return mpmath.hypot(x + vx * time, y + vy * time) - reach

        nearest = -(x * vx + y * vy) / (vx * vx + vy * vy)
        depth = -excess(nearest)
        if nearest <= 0 or depth < -1e-12:
            assert contact is None
        elif depth > 1e-6:
            time = mpmath.findroot(excess, (0, nearest), solver="anderson", tol=1e-40)
            assert contact.after == pytest.approx(float(time), rel=1e-13 / math.sqrt(depth))


# --- what any motion must satisfy --------------------------------------------------------------

coefficients = st.sampled_from([Fraction(n, 10) for n in (0, 3, 6, 9, 10)])


@settings(max_examples=60, deadline=None)
@given(
    strategies.tables(e=coefficients),
    st.none() | st.tuples(st.floats(0, 6.3), st.tuples(st.floats(-20, 20), st.floats(-20, 20))),
)
def test_no_impact_is_missed_or_made_up(table, moved):
    """Bodies never overlap, and each impact is of bodies that touch, approach, and part."""
    if moved is not None:
        table = turned(table, *moved)
    run = played(table, impacts=60, until=10**9)
    radii = {each.name: number(each.radius) for each in table.spheres}
    walls = {wall.name: wall for wall in table.walls}
    for time in moments(run):
        assert overlap(run, time) < 1e-12
    for hit in run.impacts:
        now, c = run.at(hit.time), hit.line_of_centres
        assert size(c) == pytest.approx(1, rel=1e-14)
        place = now[hit.first].position
        if hit.second in walls:
            apart = gap(place, walls[hit.second])
            assert gap(hit.place, walls[hit.second]) < 1e-12
        else:
            between = now[hit.second].position - place
            apart = size(between) - radii[hit.second]
            assert abs(between.cross(c)) < 1e-12
        assert abs(apart - radii[hit.first]) < 1e-12
        assert abs(size(hit.place - place) - radii[hit.first]) < 1e-12
        (u1, u2), (v1, v2) = hit.before, hit.after
        approach = (u1 - u2).dot(c)
        assert approach > 0
        assert (v2 - v1).dot(c) == pytest.approx(hit.e * approach, rel=1e-9, abs=1e-13)
        assert abs(c.cross(v1 - u1)) < 1e-13 and abs(c.cross(v2 - u2)) < 1e-13
        assert abs(c.cross(hit.impulse)) < 1e-12


@settings(max_examples=20, deadline=None)
@given(strategies.tables())
def test_energy_stays_without_loss(table):
    run = simulate(table, impacts=300)
    assert energy(run, run.end) == pytest.approx(energy(run, 0), rel=1e-12)


@settings(max_examples=25, deadline=None)
@given(strategies.tables(spheres=3))
def test_time_reversal(table):
    """Thrown back, the spheres find their way home, while the arithmetic allows it."""
    run = simulate(table, impacts=5)
    end = float(run.end) + 0.001
    states = simulate(table, until=end).at(end)
    back = [
        replace(
            each, position=tuple(states[each.name].position), velocity=-states[each.name].velocity
        )
        for each in table.spheres
    ]
    home = simulate(replace(table, spheres=back), until=end).at(end)
    for each in table.spheres:
        assert size(home[each.name].position - numbers(each.position)) < 1e-7
        assert size(home[each.name].velocity + Vector(*numbers(each.velocity))) < 1e-7


@settings(max_examples=15, deadline=None)
@given(strategies.tables(spheres=2, e=st.sampled_from([Fraction(1), Fraction(1, 2)])))
def test_exact_and_floats_tell_the_same(table):
    exact = played(replace(table, exact=True), impacts=4).events
    floats = played(table, impacts=4).events
    for n in range(min(len(exact), len(floats))):
        if n + 1 < len(exact) and exact["time"][n + 1] - exact["time"][n] < 1e-9:
            break  # at one time: rounding decides the order
        for column in exact.dtype.names:
            if column in ("first", "second"):
                assert exact[column][n] == floats[column][n]
            else:
                assert exact[column][n] == pytest.approx(floats[column][n], rel=1e-9, abs=1e-9)


def gas(count, seed, *, e=1.0, room=10.0):
    """A box of spheres of several masses and radii, on a lattice at first."""
    random = np.random.default_rng(seed)
    side = math.ceil(math.sqrt(count))
    return Table.box(
        room,
        room,
        [
            sphere(
                f"S{n}",
                ((n % side + 0.5) * room / side, (n // side + 0.5) * room / side),
                random.normal(size=2),
                mass=random.uniform(0.5, 2),
                radius=random.uniform(0.2, 0.45) * room / side,
            )
            for n in range(count)
        ],
        e=e,
    )


def depth(run, time):
    """As `overlap`, for a box of floats."""
    now, layout = run.at(time), run.table.layout
    room = layout.obstacles[1].shape.start.x
    places = np.array([now[each.name].position for each in layout.balls])
    radii = np.array([each.radius for each in layout.balls])
    apart = np.hypot(*(places[:, None] - places[None]).transpose(2, 0, 1))
    deep = (radii[:, None] + radii[None] - apart)[~np.eye(len(radii), dtype=bool)]
    beyond = np.maximum(radii[:, None] - places, places + radii[:, None] - room)
    return max(deep.max(), beyond.max())


def test_thousands_of_impacts():
    table = gas(9, seed=3)
    run = simulate(table, impacts=6000)
    assert energy_of_floats(run, run.end) == pytest.approx(energy_of_floats(run, 0), rel=1e-12)
    smallest = min(each.radius for each in table.layout.balls)
    worst = max(depth(run, time) for time in [*run.events["time"], *moments(run)][::3])
    assert worst < 1e-12 * smallest


def energy_of_floats(run, time):
    now = run.at(time)
    return sum(
        each.mass * size(now[each.name].velocity) ** 2 / 2 for each in run.table.layout.balls
    )


def test_many_spheres_are_not_slow():
    """Only the spheres just struck are looked at anew: a count, not a time."""
    looked = 0
    table = gas(50, seed=1)
    from restitution.motion.run import _Course

    course = _Course(table, None, 200)
    look = course.look

    def counting(ball, others):
        nonlocal looked
        looked += 1
        look(ball, others)

    course.look = counting
    course.run()
    assert looked <= 400
    assert len(course.due) < 20_000


def test_late_impacts_are_as_good_as_early_ones():
    """A slow sphere keeps the clock at large times, a fast one strikes all the while."""
    walls = polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    table = Table(
        [
            Sphere("P", mass=1, radius=0.1, position=(0.5, 0.5), velocity=(1e-3, 1.3e-3)),
            Sphere("Q", mass=1, radius=0.1, position=(0.2, 0.2), velocity=(0, 0)),
        ],
        walls,
    )
    run = simulate(table, impacts=3000)
    assert run.end > 5e5
    for hit in run.impacts[-200:]:
        assert depth_of_box(run, hit.time) < 1e-14


def depth_of_box(run, time):
    now = [state.position for state in run.at(time).values()]
    edges = [max(0.1 - x, x - 0.9) for place in now for x in place]
    return max(*edges, 0.2 - size(now[0] - now[1]))


# --- the same motion seen differently ----------------------------------------------------------


def three(turn=lambda x, y: (x, y), drift=(0.0, 0.0)):
    vx, vy = drift

    def seen(name, position, velocity, mass, radius):
        moving = turn(*velocity)
        return sphere(
            name,
            turn(*position),
            (moving[0] + vx, moving[1] + vy),
            mass=mass,
            radius=radius,
        )

    return [
        seen("A", (-3.0, 0.2), (2.0, 0.0), 1.0, 0.5),
        seen("B", (0.0, 0.0), (0.0, 0.1), 2.0, 0.4),
        seen("C", (2.0, 0.3), (-1.0, 0.0), 0.7, 0.8),
    ]


def test_galilean_shift():
    still, moving = (
        simulate(Table(three(drift=drift), e=0.7), until=9.0) for drift in ((0.0, 0.0), (3.0, -4.0))
    )
    assert len(still.events) == len(moving.events) >= 3
    assert moving.events["time"] == pytest.approx(still.events["time"], rel=1e-12)
    assert moving.events["impulse_x"] == pytest.approx(still.events["impulse_x"], abs=1e-12)
    assert moving.events["v2_y"] == pytest.approx(still.events["v2_y"] - 4, abs=1e-12)
    assert moving.at(9.0)["A"].position == pytest.approx(
        still.at(9.0)["A"].position + Vector(27, -36), abs=1e-11
    )


def test_rotation():
    c, s = math.cos(0.7), math.sin(0.7)

    def turn(x, y):
        return c * x - s * y, s * x + c * y

    corners = [
        (-5.0, -5.0),
        (5.0, -5.0),
        (5.0, 5.0),
        (1.0, 5.0),
        (0.0, 2.0),
        (-1.0, 5.0),
        (-5.0, 5.0),
    ]
    first = simulate(Table(three(), polygon(corners)), impacts=12)
    second = simulate(Table(three(turn), polygon([turn(*each) for each in corners])), impacts=12)
    assert [*first.events["second"]] == [*second.events["second"]]
    assert second.events["time"] == pytest.approx(first.events["time"], rel=1e-9)
    assert np.stack(turn(first.events["x"], first.events["y"])) == pytest.approx(
        np.stack([second.events["x"], second.events["y"]]), abs=1e-9
    )


# --- the rules ---------------------------------------------------------------------------------


@KINDS
@pytest.mark.parametrize("gap", [0, 1])
def test_newtons_line(exact, gap):
    """Equal spheres in line hand the velocity on, touching or apart."""
    row = [sphere(f"S{n}", (n * (1 + gap), 0), (0, 0)) for n in range(3)]
    table = Table([sphere("A", (-3, 0), (1, 0)), *row], exact=exact)
    run = simulate(table, impacts=50)
    pairs = [("A", "S0"), ("S0", "S1"), ("S1", "S2")]
    # the one with the lower place on the table is named first
    assert [(hit.first, hit.second) for hit in run.impacts] == pairs
    assert [each.velocity for each in run.at(run.end).values()] == [(0, 0)] * 3 + [(1, 0)]


@KINDS
def test_grazing_is_no_impact(exact):
    """Along a tangent to a sphere, a circle, the end of a wall, and along a wall."""
    walls = [
        Wall("C", centre=(10, 3), radius="5/2"),
        Wall("W", start=(20, "1/2"), end=(20, 9)),
        Wall("V", start=(30, "-1/2"), end=(40, "-1/2")),
        Wall("U", start=(40, "-1/2"), end=(50, "-1/2")),
    ]
    balls = [sphere("A", (0, 0), (3, 0)), sphere("B", (5, 1), (0, 0))]
    run = simulate(Table(balls, walls, exact=exact), until=30)
    assert len(run.events) == 0
    deeper = replace(balls[1], position=(5, "0.9999999"))
    assert len(simulate(Table([balls[0], deeper], exact=exact), until=30).events) == 1


@pytest.mark.parametrize("turn", [0.1 * n for n in range(16)])
def test_grazing_in_any_direction(turn):
    """Rounding may place a tangent path on either side: no sign of it may be seen."""
    c, s = math.cos(turn), math.sin(turn)

    def at(x, y):
        return (c * x - s * y, s * x + c * y)

    balls = [sphere("A", at(-7.0, 1.0), at(2.0, 0.0)), sphere("B", at(0.0, 0.0), (0.0, 0.0))]
    wall = Wall("W", start=at(9.0, 0.5), end=at(30.0, 0.5))
    assert len(simulate(Table(balls, [wall]), until=20.0).events) == 0


@KINDS
def test_inner_corner_reverses_the_velocity(exact):
    """Two walls at a right angle are struck at once: one impact with each."""
    for radius in ("0", "1/2"):
        ball = sphere("P", (2, 2), ("-3/2", "-3/2"), radius=radius)
        run = simulate(Table.box(4, 5, [ball], exact=exact), impacts=2)
        first, second = run.impacts
        assert (first.second, second.second) == ("Left", "Bottom")
        assert first.time == second.time
        assert tuple(map(float, run.at(run.end)["P"].velocity)) == (1.5, 1.5)


@KINDS
def test_corner_of_60_degrees_takes_three(exact):
    """An elastic corner of π/n reflects n times, whatever the path."""
    ball = sphere("P", (8, "3/2"), (-3, "-1/7"), radius="1/3")
    walls = [Wall("W", start=(0, 0), end=(50, 0)), Wall("V", start=(0, 0), end="50 at 60°")]
    run = simulate(Table([ball], walls, exact=exact), impacts=50)
    assert len(run.events) == 3


@KINDS
def test_corner_struck_from_outside_is_struck_once(exact):
    """The tip of a wedge is one point of two walls, and belongs to the first."""
    walls = [Wall("V", start=(0, 0), end=(5, 2)), Wall("W", start=(5, -2), end=(0, 0))]
    table = Table(
        [sphere("P", (-4, 0), (2, 0))],
        walls,
        coefficients={"V": "1/4", "W": "3/4"},
        exact=exact,
    )
    (hit,) = simulate(table, impacts=9).impacts
    assert (hit.second, hit.place, hit.after[0]) == ("V", (0, 0), (Fraction(-1, 2), 0))


@KINDS
def test_where_two_walls_continue_each_other(exact):
    """At the joint there is one impact, like anywhere else."""
    walls = polygon([(0, 0), (3, 0), (6, 0), (6, 6), (0, 6)])
    ball = sphere("P", (2, "3/2"), (1, -1))
    run = simulate(Table([ball], walls, exact=exact), until=2)
    assert len(run.events) == 1
    assert run.at(2)["P"].velocity == (1, 1)


@pytest.mark.parametrize("slope", [0.0, 1e-15, 1e-12, 1e-9, 3e-8, 1e-7, 1e-4])
def test_a_gap_as_wide_as_the_sphere(slope):
    """Whether it meets the end of a wall or only grazes it, the sphere does not sink in."""
    walls = [
        Wall("W", start=(-9, 1), end=(9, 1)),
        Wall("V", start=(0, -1), end=(4, -1)),
    ]
    table = Table([sphere("P", (-2.0, 0.0), (1.0, -slope), radius=1)], walls)
    run = simulate(table, until=9.0, impacts=200)
    for n in range(101):
        assert overlap(run, run.end * n / 100) < 1e-12


@KINDS
def test_simultaneous_impacts_of_separate_pairs(exact):
    balls = [
        sphere(f"{name}{n}", (x, 5 * n), (v, 0))
        for n in range(3)
        for name, x, v in (("A", 0, 1), ("B", 4, -1))
    ]
    events = simulate(Table(balls, e="1/2", exact=exact), impacts=9).events
    assert [*events["first"]] == ["A0", "A1", "A2"]
    assert {*events["time"]} == {1.5}
    assert {*events["v1_x"]} == {-0.5}


@KINDS
@pytest.mark.parametrize("swapped", [False, True])
def test_two_struck_at_once_go_in_the_order_of_the_table(exact, swapped):
    """The first takes its share as if it were alone, the second of what is left."""
    left = sphere("B", (0, "1/2"), (0, 0))
    right = sphere("C", (0, "-1/2"), (0, 0))
    table = Table(
        [sphere("A", (-5, 0), (2, 0)), *((right, left) if swapped else (left, right))], exact=exact
    )
    first, second = simulate(table, impacts=2).impacts
    assert first.time == second.time
    assert (first.second, second.second) == (("C", "B") if swapped else ("B", "C"))
    # line of centres at 30°: B leaves with 2 cos 30°, A is left with 2 sin 30° across it
    assert size(first.after[1]) == pytest.approx(math.sqrt(3), rel=1e-14)
    assert size(first.after[0]) == pytest.approx(1, rel=1e-14)
    # and that velocity makes 30° with the other line of centres
    assert size(second.after[1]) == pytest.approx(math.sqrt(3) / 2, rel=1e-14)


@pytest.mark.parametrize("turn", [0.1 * n for n in range(16)])
def test_the_order_does_not_hang_on_rounding(turn):
    c, s = math.cos(turn), math.sin(turn)

    def at(x, y):
        return (c * x - s * y, s * x + c * y)

    balls = [
        sphere("A", at(-5.0, 0.0), at(2.0, 0.0)),
        sphere("B", at(0.0, 0.6), (0.0, 0.0)),
        sphere("C", at(0.0, -0.6), (0.0, 0.0)),
    ]
    events = simulate(Table(balls), impacts=2).events
    assert [*events["second"]] == ["B", "C"]
    assert events["time"][0] == pytest.approx(events["time"][1], rel=1e-14)


@KINDS
def test_without_rebound_a_sphere_slides(exact):
    """e = 0: along one wall to the next, and there it stays."""
    ball = sphere("P", (2, 2), (-1, 3))
    run = simulate(Table.box(40, 40, [ball], e=0, exact=exact), until=1000)
    assert [hit.second for hit in run.impacts] == ["Left", "Top"]
    position, velocity = run.at(1000)["P"]
    assert (tuple(map(float, position)), velocity) == ((0.5, 39.5), (0, 0))


@pytest.mark.parametrize("turn", [0.1 * n for n in range(16)])
def test_sliding_in_any_direction(turn):
    c, s = math.cos(turn), math.sin(turn)

    def at(x, y):
        return (c * x - s * y, s * x + c * y)

    walls = polygon([at(0.0, 0.0), at(3.0, 0.0), at(7.0, 0.0), at(7.0, 4.0), at(0.0, 4.0)])
    balls = [sphere("P", at(1.0, 1.0), at(1.0, -2.0)), sphere("Q", at(5.0, 0.5), (0.0, 0.0))]
    table = Table(balls, walls, coefficients=dict.fromkeys(["W1", "W2", "W3"], 0))
    run = simulate(table, until=30.0)
    # P falls on the wall, slides, strikes Q head-on, which slides on to the next wall
    assert [(hit.first, hit.second) for hit in run.impacts] == [
        ("P", "W1"),
        ("P", "Q"),
        ("Q", "W3"),
    ]
    assert size(run.at(30.0)["Q"].velocity) < 1e-14
    assert run.at(30.0)["Q"].position == pytest.approx(at(6.5, 0.5), abs=1e-12)


@KINDS
def test_without_rebound_two_spheres_go_on_together(exact):
    balls = [sphere("A", (0, 0), (3, 0)), sphere("B", (5, 0), (0, 0), mass=2)]
    run = simulate(Table(balls, e=0, exact=exact), until=90)
    assert len(run.events) == 1
    assert {name: state.velocity for name, state in run.at(90).items()} == {
        "A": (1, 0),
        "B": (1, 0),
    }


# --- collapse ----------------------------------------------------------------------------------


def three_in_line(e, exact):
    balls = [
        sphere("A", (-3, 0), (1, 0)),
        sphere("B", (0, 0), (0, 0)),
        sphere("C", (2, 0), (-1, 0)),
    ]
    return Table(balls, e=e, exact=exact)


@KINDS
def test_three_in_line_collapse_below_the_known_coefficient(exact):
    """Equal spheres collapse for e < 7 − 4√3 = 0.0718 (Bernu and Mazighi 1990, McNamara 1992)."""
    with pytest.raises(r.CollapseError, match="without end") as caught:
        simulate(three_in_line("0.07", exact), until=100)
    assert len(caught.value.run.events) > 10
    assert caught.value.run.end <= 2
    assert len(simulate(three_in_line("0.073", exact), until=1000).events) < 40


@KINDS
@pytest.mark.parametrize("e", ["0", "1/100", "1/20"])
def test_a_wedge_holds_a_sphere(exact, e):
    walls = [Wall("W", start=(0, 0), end=(40, 0)), Wall("V", start=(0, 0), end=(40, 20))]
    table = Table([sphere("P", (10, 2), (-1, 0))], walls, e=e, exact=exact)
    with pytest.raises(r.CollapseError, match="inelastic collapse"):
        simulate(table, until=1e9 if not exact else 10**9)


@KINDS
@pytest.mark.parametrize("e", ["0", "1/20", "1/2"])
def test_a_circle_is_slid_along(exact, e):
    """The chords shrink as e, e², …: their time has a sum, tangential speed stays."""
    table = Table(
        [sphere("P", (0, 0), (1, 2), radius=1), sphere("Q", (50, 0), (0, 0))],
        [Wall("C", centre=(-1, 0), radius=4)],
        e=e,
        exact=exact,
    )
    with pytest.raises(r.CollapseError, match="P comes to slide along C") as caught:
        simulate(table, until=100)
    first = simulate(table, impacts=1).impacts[0]
    wanted = first.time
    if e != "0":
        c, tangent = first.line_of_centres, first.line_of_centres.turned_left()
        across = abs(first.before[0].dot(tangent))
        share = first.before[0].dot(c) / across
        ratio = float(Fraction(e))
        chord = [ratio**n * share for n in range(1, 200)]
        wanted += sum(2 * 3 * t / (across * (1 + t * t)) for t in chord)
    assert float(caught.value.run.end) == pytest.approx(float(wanted), rel=1e-6)


def test_squeezed_between_a_heavy_sphere_and_a_wall():
    balls = [sphere("P", (1, 0), (1, 0)), sphere("M", (6, 0), (-1, 0), mass=10**6)]
    wall = Wall("W", along="j", through=(0, 0))
    with pytest.raises(r.CollapseError):
        simulate(Table(balls, [wall], e=0.5), until=100)
    assert len(simulate(Table(balls, [wall]), until=100).events) > 1000


def test_a_collapse_can_be_sent_to_another_process():
    error = pickle.loads(pickle.dumps(r.CollapseError("what happened")))
    assert (error.message, error.run, error.kind) == ("what happened", None, "collapse")


# --- tables ------------------------------------------------------------------------------------


def test_coefficients_of_walls_and_pairs():
    balls = [
        sphere("A", (2, 2), (1, 0)),
        sphere("B", (5, 2), (-1, 0)),
    ]
    table = Table.box(
        8, 4, balls, e=0.9, coefficients={"Left": 0.5, ("B", "A"): 0.3, ("Right", "B"): 0.1}
    )
    coefficients = {(hit.first, hit.second): hit.e for hit in simulate(table, impacts=4).impacts}
    assert coefficients == {("A", "B"): 0.3, ("A", "Left"): 0.5, ("B", "Right"): 0.1} | coefficients
    assert set(coefficients.values()) <= {0.3, 0.5, 0.1}


def test_a_wall_has_two_sides():
    wall = Wall("W", start=(0, -5), end=(0, 5))
    balls = [sphere("A", (-3, 0), (1, 0)), sphere("B", (4, 0), (-1, 0))]
    events = simulate(Table(balls, [wall]), impacts=5).events
    assert [*events["line_x"]] == [1, -1]
    assert [*events["x"]] == [0, 0]


def test_circles_are_struck_from_where_a_sphere_starts():
    ring = Wall("C", centre=(0, 0), radius=3)
    balls = [sphere("A", (0, 0), (1, 0)), sphere("B", (9, 0), (-1, 0))]
    events = simulate(Table(balls, [ring]), impacts=2).events
    assert [*events["time"]] == [2.5, 5.5]
    assert [*events["x"]] == [3, 3]


def test_spheres_that_start_in_contact():
    """Rounding in the places given is no overlap, and approaching ones collide at once."""
    apart = 0.1 + 0.2  # a little more than 0.3
    table = Table(
        [sphere("A", (0, 0), (1, 0), radius=0.1), sphere("B", (0.3, 0), (0, 0), radius=0.2)]
    )
    assert apart > 0.3
    (hit,) = simulate(table, impacts=3).impacts
    assert hit.time == 0


def test_a_sphere_of_no_size_stays_in():
    """Also where rounding would put it through a corner or onto the other side."""
    corners = [(0.0, 0.0), (math.pi, 0.0), (math.e, math.sqrt(2)), (1.1, 2.3)]
    inside = []
    for n in range(40):
        ball = Sphere("P", mass=1, position=(1.5, 0.5), velocity=(math.cos(n), math.sin(n)))
        run = simulate(Table.polygon(corners, [ball]), impacts=300)
        inside += [run.at(run.end)["P"].position]
        aimed = replace(ball, velocity=tuple(Vector(*corners[n % 4]) - (1.5, 0.5)))
        run = simulate(Table.polygon(corners, [aimed]), impacts=30)
        inside += [run.at(time)["P"].position for time in moments(run)]
    for place in inside:
        for start, end in pairwise([*corners, corners[0]]):
            along = Vector(*end) - start
            assert along.cross(place - start) > -1e-12


A = sphere("A", (1, 1), (1, 0))
W = Wall("W", start=(0, 0), end=(9, 0))


@pytest.mark.parametrize(
    ("make", "error", "message"),
    [
        (lambda: Table([replace(A, mass=0)]), r.ImpossibleError, "mass of A is 0: a mass is pos"),
        (lambda: Table([replace(A, mass=None)]), r.MissingError, "the mass of A was not given"),
        (lambda: Table([replace(A, velocity=None)]), r.MissingError, "velocity of A was not"),
        (lambda: Table([replace(A, radius=-1)]), r.ImpossibleError, "radius of A is -1: a radius"),
        (lambda: Table([replace(A, mass=math.nan)]), r.StatementError, "mass of A is nan: it must"),
        (lambda: Table([replace(A, position=(math.inf, 0))]), r.StatementError, "along i is inf"),
        (
            lambda: Table([replace(A, mass="2m")]),
            r.StatementError,
            "mass of A: the letter m has no",
        ),
        (lambda: Table([replace(A, mass="two")]), r.StatementError, "the mass of A"),
        (lambda: Table([replace(A, velocity=(1, 2, 3))]), r.StatementError, "not a vector"),
        (lambda: Table([replace(A, velocity=3)]), r.StatementError, "velocity of A is not a vec"),
        (lambda: Table([replace(A, mass=True)]), r.StatementError, "not a number: True"),
        (lambda: Table([A, A]), r.StatementError, "two bodies are named A"),
        (lambda: Table(["A"]), r.StatementError, "values of type Sphere, not 'A'"),
        (lambda: Table([A], [A]), r.StatementError, "values of type Wall"),
        (lambda: Table([A], [replace(W, name="A")]), r.StatementError, "two bodies are named A"),
        (lambda: Table([A], e=1.2), r.ImpossibleError, "e is 1.2: a coefficient of restitution"),
        (lambda: Table([A], e="-1/2"), r.ImpossibleError, "e is -0.5"),
        (
            lambda: Table([A], [W], coefficients={"W": 2}),
            r.ImpossibleError,
            "e of W is 2: a coefficient",
        ),
        (
            lambda: Table([A], [W], coefficients={("A", "V"): 1}),
            r.StatementError,
            "e of A and V: there is no V here, only A, W",
        ),
        (
            lambda: Table([A], [W], coefficients={"A": 1}),
            r.StatementError,
            "that of a wall, of two",
        ),
        (
            lambda: Table([A, sphere("B", (1, "3/2"), 0)]),
            r.ImpossibleError,
            r"A and B overlap at the start: their centres, at \(1, 1\) and \(1, 1.5\)",
        ),
        (
            lambda: Table([replace(A, radius=None), sphere("B", (5, 5), 0, radius=None)]),
            r.MissingError,
            "radii of A and B were not given",
        ),
        (
            lambda: Table([replace(A, position=(1, "1/4"))], [W]),
            r.ImpossibleError,
            r"the wall W cuts through A at the start, at \(1, 0.25\)",
        ),
        (
            lambda: Table.box(4, 3, [replace(A, position=(9, 9))]),
            r.ImpossibleError,
            r"A is outside the box at the start, at \(9, 9\): the box is from \(0, 0\) to \(4, 3\)",
        ),
        (
            lambda: Table.box(4, 3, [replace(A, position=(1, -1), radius=None)], exact=True),
            r.ImpossibleError,
            r"A is outside the box at the start, at \(1, -1\)",
        ),
        (
            lambda: Table([A], [Wall("C", centre=(0, 0), radius=1)]),
            r.ImpossibleError,
            "the wall C cuts through A",
        ),
        (
            lambda: Table([A], [Wall("C", centre=(1, 1), radius="1/4")]),
            r.ImpossibleError,
            "A does not fit into the circular wall C",
        ),
        (
            lambda: Table([A], [Wall("C", centre=(1, 1), radius=0)]),
            r.ImpossibleError,
            "radius of C is 0: a radius is positive",
        ),
        (
            lambda: Table([A], [Wall("W", start=(3, 4), end=(3, 4))]),
            r.ImpossibleError,
            r"the wall W starts and ends at \(3, 4\): a wall has a length",
        ),
        (
            lambda: Table([A], [Wall("W", along=(0, 0), through=(0, 0))]),
            r.ImpossibleError,
            "the wall W is along the zero vector",
        ),
        (lambda: Table([A], [Wall("W")]), r.MissingError, "where the wall W is was not given"),
        (lambda: Table([A], [Wall("W", along="i")]), r.MissingError, "through=…"),
        (
            lambda: Table([A], [replace(W, radius=1)]),
            r.StatementError,
            "the wall W is told in two ways",
        ),
        (lambda: Table.box(0, 4, [A]), r.ImpossibleError, "the width of the box is 0: a width"),
        (lambda: polygon([(0, 0), (1, 1)]), r.StatementError, "at least three points, not 2"),
        (
            lambda: Table([replace(A, mass=0.1)], exact=True),
            r.StatementError,
            "mass of A is the float 0.1: an exact motion takes text",
        ),
        (
            lambda: Table([replace(A, velocity=("pi", 0))], exact=True),
            r.UnsupportedError,
            "velocity of A along i is pi: an exact motion takes rational numbers and square roots",
        ),
        (lambda: Table(A), r.StatementError, "the spheres of a table are a list, not one Sphere"),
        (lambda: Table([A], W), r.StatementError, "the walls of a table are a list, not one Wall"),
        (lambda: Table.box(9, 9, [A], walls=3), r.StatementError, "walls of a table are a list"),
        (lambda: polygon(3), r.StatementError, "points of a polygon are a list, not one int"),
        (lambda: Table([A], coefficients={3: 1}), r.StatementError, "e of 3: there is no 3 here"),
        (lambda: Table([A], coefficients=[1]), r.StatementError, "are a dictionary from names"),
        (lambda: simulate(None, until=1), r.StatementError, "simulated is a Table, not None"),
        (lambda: simulate(Table([A])), r.StatementError, "a motion has an end"),
        (lambda: simulate(Table([A]), until=-1), r.StatementError, "the motion starts at 0"),
        (lambda: simulate(Table([A]), until=math.inf), r.StatementError, "must be a finite"),
        (lambda: simulate(Table([A]), impacts=1.5), r.StatementError, "a whole number from 0"),
        (lambda: simulate(Table([A]), until=1).at(2), r.ImpossibleError, "goes from 0 to 1 s, and"),
    ],
)
def test_errors_name_what_is_wrong(make, error, message):
    with pytest.raises(error, match=message):
        make()


# --- exact numbers -----------------------------------------------------------------------------


def test_ten_impacts_in_surds():
    """In an equilateral triangle, from a start and with a velocity in surds, to 30 digits."""
    corners = [(0, 0), (4, 0), ("2", "2√3")]
    ball = sphere("P", (2, 1), (1, "√2"), radius="1/5")
    run = simulate(Table.polygon(corners, [ball], exact=True), impacts=10)
    with mpmath.workdps(40):
        root = mpmath.sqrt
        place, v = [mpmath.mpf(2), mpmath.mpf(1)], [mpmath.mpf(1), root(2)]
        inward = [(0, 1), (-root(3) / 2, -mpmath.mpf(1) / 2), (root(3) / 2, -mpmath.mpf(1) / 2)]
        points = [(0, 0), (4, 0), (0, 0)]
        time = mpmath.mpf(0)
        for hit in run.impacts:
            due = []
            for (nx, ny), (px, py) in zip(inward, points):
                speed = nx * v[0] + ny * v[1]
                if speed < 0:
                    height = nx * (place[0] - px) + ny * (place[1] - py) - mpmath.mpf(1) / 5
                    due.append((-height / speed, nx, ny, speed))
            after, nx, ny, speed = min(due)
            time += after
            place = [x + w * after for x, w in zip(place, v)]
            v = [v[0] - 2 * speed * nx, v[1] - 2 * speed * ny]
            assert abs(mpmath.mpf(str(sympy.N(hit.time, 35))) - time) < mpmath.mpf(10) ** -28
            assert abs(mpmath.mpf(str(sympy.N(hit.after[0].y, 35))) - v[1]) < mpmath.mpf(10) ** -28
    assert all(isinstance(each, sympy.Expr) for each in (hit.time, *hit.place, run.end))


def test_ten_impacts_round_a_circle_among_walls():
    """Roots within roots: each impact with the circle adjoins one, and all comparisons hold."""
    ball = sphere("P", (1, 1), (1, "1/2"), radius="1/5")
    table = Table.box(4, 4, [ball], walls=[Wall("C", centre=(2, 2), radius=1)], exact=True)
    run = simulate(table, impacts=10)
    assert [*run.events["second"]].count("C") >= 3
    speeds = [sympy.N(hit.after[0].dot(hit.after[0]), 40) for hit in run.impacts]
    assert all(abs(each - sympy.Rational(5, 4)) < sympy.Float("1e-35", 40) for each in speeds)
    for hit, other in zip(
        run.impacts[:4], simulate(replace(table, exact=False), impacts=4).impacts
    ):
        assert float(hit.time) == pytest.approx(other.time, rel=1e-12)
        assert float(hit.place.x) == pytest.approx(other.place.x, rel=1e-10)


def test_too_many_roots_are_refused():
    balls = [sphere("P", (1, 1), (1, "1/2"), radius="1/5")]
    posts = [
        Wall(f"C{x}{y}", centre=(4 * x + 3, 4 * y + 3), radius="3/2")
        for x in range(3)
        for y in range(3)
    ]
    with pytest.raises(r.UnsupportedError, match="nested deeper than 4: exact numbers grow"):
        simulate(Table.box(14, 14, balls, walls=posts, exact=True), impacts=100)


def test_state_of_an_exact_motion():
    ball = Sphere("P", mass=1, position=(0, 0), velocity=(1, "√3"))
    run = simulate(Table.box(9, 9, [ball], exact=True), until="7/2")
    assert run.at("1/2")["P"].position == (sympy.Rational(1, 2), sympy.sqrt(3) / 2)
    assert run.at(Fraction(1, 2)) == run.at(sympy.Rational(1, 2))
    assert run.at(0.5)["P"].position == pytest.approx((0.5, math.sqrt(3) / 2))
    assert run.end == sympy.Rational(7, 2)


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(st.sampled_from("+-*/q"), st.integers(-9, 9)), max_size=8))
def test_surds_are_what_sympy_says(steps):
    """Operations and roots in a tower, against SymPy's to 40 digits; equality is exact."""
    tower = Tower()
    x, wanted = Fraction(2), sympy.Integer(2)
    for operation, n in steps:
        if operation == "q":
            x, wanted = tower.sqrt(x * x + n * n + 1), sympy.sqrt(wanted * wanted + n * n + 1)
        elif operation == "/" and n:
            x, wanted = 1 / (x * x + abs(n)), 1 / (wanted * wanted + abs(n))
        elif operation == "*":
            x, wanted = x * tower.sqrt(Fraction(abs(n))), wanted * sympy.sqrt(abs(n))
        else:
            x, wanted = (x + n, wanted + n) if operation == "+" else (n - x, n - wanted)
        assert float(x) == pytest.approx(float(wanted.evalf(40)), rel=1e-15, abs=1e-300)
    assert x - x == 0 and tower.sqrt(x * x) == abs(x)
    assert (x > 0) - (x < 0) == sympy.sign(wanted.evalf(40))
    if x:
        assert x * (1 / x) == 1


def test_numbers_of_two_towers_compare():
    one, other = Tower(), Tower()
    a = one.sqrt(Fraction(2)) + one.sqrt(Fraction(3))
    b = other.sqrt(5 + 2 * other.sqrt(Fraction(6)))
    assert a == b and not a < b and a <= b
    assert a + Fraction(1, 10**200) > b
    assert Tower().tentative_sqrt(Fraction(4)) == 2


# --- what comes of it --------------------------------------------------------------------------


def two():
    return Table.box(
        4, 3, [sphere("P", (1, 1), (1, 2), radius="1/4"), sphere("Ball 2", (3, 1), 0, radius="1/4")]
    )


@pytest.mark.parametrize("impacts", [0, 6])
@pytest.mark.parametrize("exact", [False, True])
def test_events_go_into_pandas_and_polars(exact, impacts):
    import pandas as pd  # a second, in every process that collects tests
    import polars as pl

    run = simulate(replace(two(), exact=exact), impacts=impacts)
    frames = pd.DataFrame(run.events), pl.from_numpy(run.events), pl.DataFrame(run.events)
    for frame in frames:
        assert list(frame.columns) == list(run.events.dtype.names)
        assert len(frame) == impacts
        assert frame["time"].to_numpy().dtype == float
        assert set(frame["second"]) <= {"Ball 2", "Left", "Right", "Top", "Bottom"}


def test_events_are_the_impacts():
    run = simulate(two(), impacts=6)
    for row, hit in zip(run.events, run.impacts):
        assert (row["time"], row["first"], row["second"]) == (hit.time, hit.first, hit.second)
        assert (row["v2_x"], row["v2_y"]) == hit.after[1]
        assert (row["u1_x"], row["u1_y"]) == hit.before[0]
        assert (row["impulse_x"], row["impulse_y"]) == hit.impulse


def test_state_is_continuous_and_motion_is_the_same():
    run = simulate(two(), until=20)
    motion = run.motion()
    assert (motion.start, motion.end) == (0, 20) == (0, run.end)
    for track in motion.tracks:
        assert track.pieces[0].start == 0 and track.pieces[-1].end == 20
        for before, after in pairwise(track.pieces):
            assert before.end == after.start
            assert before.at(before.end) == pytest.approx(after.place, abs=1e-14)
    for time in moments(run):
        for name, (place, velocity) in motion.at(time).items():
            assert run.at(time)[name].position == pytest.approx(place, abs=1e-13)
            assert run.at(time)[name].velocity == velocity
    assert motion.impacts == run.impacts
    assert [wall.name for wall in motion.walls] == ["Left", "Right", "Bottom", "Top"]


def test_a_whole_line_is_drawn_as_far_as_there_is_something():
    table = Table(
        [sphere("P", (1, 3), (1, -1))], [Wall("W", along="2i", through=(0, 0))], exact=True
    )
    (wall,) = simulate(table, until=10).motion().walls
    assert wall.points == ((0, 0), (11, 0))


def test_until_and_impacts_together():
    assert len(simulate(two(), until=100, impacts=3).events) == 3
    assert simulate(two(), until=1, impacts=3).end == 1
    alone = simulate(Table([sphere("P", (0, 0), (1, 0))]), impacts=5)
    assert (alone.end, len(alone.events)) == (0, 0)


def test_they_show_themselves():
    run = simulate(two(), impacts=30)
    assert repr(run).splitlines()[:2] == [
        f"Motion of 2 spheres from 0 to {run.end:.6g} s, 30 impacts",
        "       0.875 s  P hits Top at (1.875, 3), impulse 4 N s",
    ]
    assert "19 more" in repr(run)
    assert repr(two()).startswith(
        "Table with 2 spheres and 4 walls, e = 1\n  P: mass 1, radius 0.25"
    )


@KINDS
def test_they_go_to_other_processes(exact):
    """As an ensemble of motions needs it."""
    table = pickle.loads(pickle.dumps(replace(two(), exact=exact)))
    run = pickle.loads(pickle.dumps(simulate(table, impacts=6)))
    assert (run.events == simulate(replace(two(), exact=exact), impacts=6).events).all()
    assert run.at("1/2") == simulate(table, until=1).at("1/2")


@pytest.mark.parametrize("tiny", [1e-309, 1e-200, 1e-150, 1e-100])
@pytest.mark.parametrize("e", [0, 0.5, 1])
def test_speeds_at_the_end_of_floats(tiny, e):
    balls = [
        sphere("P", (2.0, 2.0), (tiny, -tiny)),
        sphere("Q", (5.0, 2.1), (0.0, tiny)),
        sphere("R", (7.0, 7.0), (1.0, tiny)),
    ]
    run = played(Table.box(9, 9, balls, e=e), impacts=40)
    assert math.isfinite(run.end)
    for column in set(run.events.dtype.names) - {"first", "second"}:
        assert np.isfinite(run.events[column]).all()
