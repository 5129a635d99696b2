"""Two spheres that separate meet again only by way of a wall: how one comes back is worked out."""

from __future__ import annotations

import pytest

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import to_text
from restitution.workings.derived import explanation_of

STORY = """sphere P: mass {}, velocity 6i
sphere Q: mass 2, at rest
wall W: along j
P hits Q: along i, e = 1/2
Q hits W: e = 1/2
P hits Q: e = 1/4
show P and Q {}
"""
# Along j, from the right, and with letters: v and w are (e² + 8e − 2)u/9 and −2(1 + e)²u/9.
DOWNWARDS = """sphere A: mass 2m, velocity -u j
sphere B: mass m, at rest
wall W: along i
A hits B: along j
B hits W: e = 1
A hits B: along j
show A and B collide again
"""
GIVEN = """wall W: along j
sphere A: mass m, velocity u i
sphere B: mass m, at rest
A hits B: along i, e = 1/2
B hits W: e = f
A hits B: along i, e = 1/2
given A and B {} again
find range of f
"""
FROM_THE_RIGHT = """sphere A: mass 3, velocity -3i
sphere B: mass 1, at rest
wall W: along j
A hits B: along i, e = 1/3
B hits W: e = 1/2
show A and B collide again
"""


def working(text: str) -> str:
    """The text of a working of which every line is followed."""
    problem = parse(text)
    solution = solve(problem)
    derivation = plan(solution)
    assert follow(derivation, Oracle(roles(problem))) == ()
    return " ".join(to_text(explanation_of(derivation, problem)).split())


# P of mass 6 goes on after Q, which comes back; P of mass 2 goes back faster than Q comes.
@pytest.mark.parametrize(
    ("text", "lines"),
    [
        (
            STORY.format(6, "collide again"),
            (
                "if Q moves towards W and the gap between them closes as it comes back with speed",
                "> 0 v₃ + ½w₃ > 0 So P and Q will collide again, as required.",
            ),
        ),
        (
            STORY.format(2, "do not collide again"),
            (
                "if the gap between them does not close as Q comes back from W with speed ½w₃.",
                "v₃ + ½w₃ ≤ 0 So P and Q will not collide again, as required.",
            ),
        ),
        (
            STORY.format(6, "do not collide again"),
            ("So P and Q will collide again, and the claim is not true.",),
        ),
        (
            DOWNWARDS,
            (
                "if the gap between them closes as B comes back from W with speed −w₃.",
                "= −(2 − e)²u/9 v₃ + w₃ < 0, as e ≤ 1",
            ),
        ),
        (
            GIVEN.format("collide"),
            (
                "the gap between them closes as B comes back from W: (1 − 9f)u/16 + 3(1 − f)fu/16",
                "0 ≤ f < (2√3 − 3)/3",
            ),
        ),
        (
            GIVEN.format("do not collide"),
            ("if the gap between them does not close as B comes back from W:", "≤ f ≤ 1"),
        ),
        # The line of centres is told against the approach: B is behind in the direction of i.
        (FROM_THE_RIGHT, ("component of 𝐯_B along 𝐢 = 3/2 > −2 = v",)),
    ],
    ids=["on", "apart", "refuted", "letters", "given", "given apart", "from the right"],
)
def test_one_comes_back_from_the_wall(text: str, lines: tuple[str, ...]) -> None:
    text = working(text)
    for line in lines:
        assert line in text


# Between two walls each sphere comes back from its own. A has −1 and B 0 or 1 after the last event.
TWO_WALLS = """wall V: along j
wall W: along j
sphere A: mass 1, velocity -4i
sphere B: mass 3, at rest
A hits V: e = 1/2
A hits B: along i, e = 1
B hits W: e = {}
A hits V: e = 1/2
A hits B: e = 1
show A and B collide again
"""
# C strikes A, so that it may catch B up; B comes back with −9/32, if that is not so.
STRUCK = """wall W: along j
sphere C: mass 1, velocity {}
sphere A: mass 2, velocity 6i
sphere B: mass 2, at rest
A hits B: along i, e = 1/2
B hits W: e = 1/2
A hits B: e = 1/2
C hits A: along i, e = 0
"""


@pytest.mark.parametrize("e", ["1/2", "1"])
def test_between_two_walls_they_always_meet(e: str) -> None:
    (part,) = solve(parse(TWO_WALLS.format(e))).parts.values()
    assert part.items[0].holds is True


def test_another_sphere_sends_one_after_the_other() -> None:
    text = STRUCK.format("k i") + "given k > 0, A and B collide again\nfind range of k"
    (part,) = solve(parse(text)).parts.values()
    (item,) = part.items
    assert str(item.answers[0].exact) == "Interval.open(57/32, oo)"
    assert item.proof != "undecided"
