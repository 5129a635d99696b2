"""Where a wall is, in any kind of number."""

from fractions import Fraction

import pytest

from restitution import Wall
from restitution.shapes import Circle, Line, Segment
from restitution.vector import Vector


@pytest.mark.parametrize(
    ("wall", "kind", "placed"),
    [
        (Wall("W"), Line, False),
        (Wall("W", along="i"), Line, False),
        (Wall("W", along="i", through="(0, 2)"), Line, True),
        (Wall("W", start=(0, 0), end=(3, 4)), Segment, True),
        (Wall("W", centre=(0, 0), radius=2), Circle, True),
    ],
)
def test_the_shape_of_a_wall_follows_from_what_is_given(wall, kind, placed):
    assert type(wall.shape) is kind
    assert wall.shape.is_placed is placed


def test_only_lines_and_segments_have_a_point_that_is_given():
    assert Line("i", (1, 2)).point == (1, 2)
    assert Segment((1, 2), (3, 4)).point == (1, 2)
    assert Circle((1, 2), 3).point is None


@pytest.mark.parametrize("number", [float, Fraction])
def test_a_shape_is_read_into_any_kind_of_number(number):
    names = []

    def point(pair, what):
        names.append(what)
        return Vector(*map(number, pair))

    def scalar(value, what):
        names.append(what)
        return number(value)

    ends = Segment((1, 2), (4, 6)).read("W", point, scalar)
    assert ends.along == Vector(number(3), number(4))
    ring = Circle((1, 2), 3).read("V", point, scalar)
    assert ring == Circle(Vector(number(1), number(2)), number(3))
    line = Line("i", None).read("U", point, scalar)
    assert line == Line("i", None)
    assert names == [
        "the start of W",
        "the end of W",
        "the centre of V",
        "the radius of V",
    ]


def test_lengths_are_those_that_are_given():
    assert Wall("W", along="i").lengths == ()
    assert len(Wall("W", centre=(0, 0), radius=2).lengths) == 2
