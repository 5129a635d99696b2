"""Practice questions: the same for a seed, solvable, of simple numbers, told apart."""

from __future__ import annotations

from fractions import Fraction

import pytest

import restitution as r
from restitution.errors import StatementError
from restitution.explaining.mistakes.consequences import can_be_made
from restitution.practice.questions import diagnosis, nice
from restitution.practice.questions.choosing import next_question, sureness
from restitution.practice.questions.dice import Dice
from restitution.practice.questions.generate import objection, practice_question
from restitution.practice.questions.recipes import RECIPES
from restitution.practice.questions.session import State, Wanted, chosen
from restitution.practice.questions.topics import LEVELS, TOPICS

CELLS = [(topic.id, level) for topic in TOPICS for level in LEVELS]


def test_every_topic_has_recipes_at_every_level():
    assert set(RECIPES) == set(CELLS)


@pytest.mark.parametrize("cell", CELLS[::7], ids=str)
def test_a_question_is_solved_simple_and_told_apart(cell):
    asked = practice_question(*cell, seed=3)
    assert objection(asked.solution) == ""
    assert asked.marks > 0
    assert all(item.error is None for _, item in asked.solution.items())
    assert len(str(asked.question)) > 100


def test_a_seed_gives_one_question():
    one, again, other = (practice_question("spheres-vectors", 1, seed) for seed in (5, 5, 6))
    assert one == again
    assert one.statement != other.statement
    assert "--seed 5" in one.statement
    assert one.address == "spheres-vectors/1/5/v3"
    # frozen: the same on every machine, for this version of the generator
    assert practice_question("wall-forward", 1, 1).statement == WALL


WALL = """\
# restitution practise wall-forward --level 1 --seed 1  (generator version 3)
title Velocity after an impact with a wall
wall W: along j
sphere A: velocity -10i + 4j
A hits W: e = 3/4
find velocity(A), speed(A)
"""


def test_dice_are_hashes():
    dice = Dice("a key")
    assert [dice.below(6) for _ in range(8)] == [Dice("a key").below(6), *_later("a key", 7)]
    assert sorted(Dice("x").shuffled([1, 2, 3])) == [1, 2, 3]
    assert {Dice(f"{n}").sign() for n in range(20)} == {1, -1}


def _later(key, count):
    dice = Dice(key)
    dice.below(6)
    return [dice.below(6) for _ in range(count)]


@pytest.mark.parametrize(
    ("topic", "level", "seed", "words"),
    [
        ("wall-foward", 1, 1, "did you mean wall-forward"),
        ("wall-forward", 5, 1, "1, 2, 3 or 4"),
        ("wall-forward", 1, -1, "seed"),
    ],
)
def test_what_is_not_there_is_told(topic, level, seed, words):
    with pytest.raises(StatementError, match=words):
        practice_question(topic, level, seed)


# --- telling apart ------------------------------------------------------------------------------

VECTORS = """
sphere A: mass 2, velocity 3i - 4j
sphere B: mass 3, velocity {other}
A hits B: along i, e = 1/2
find velocity(A), velocity(B)
"""


def test_answers_in_doubles_are_those_of_the_solver():
    solution = r.solve(r.parse(VECTORS.format(other="-2i + j")))
    known = diagnosis.answers_of(solution)
    right = [
        value
        for pair in (solution["velocity(A)"], solution["velocity(B)"])
        for value in pair.decimal
    ]
    assert known[diagnosis.RIGHT][0] == pytest.approx(tuple(right))
    # restitution upside down: separation 2 × 5, momentum 0
    (inverted,) = known["restitution-inverted/2"]
    assert inverted[2] - inverted[0] == pytest.approx(10)
    assert 2 * inverted[0] + 3 * inverted[2] == pytest.approx(0)


def test_equal_sizes_hide_a_mistake():
    """|p| = |s| for A: sine for cosine changes nothing."""
    statement = (
        VECTORS.replace("3i - 4j", "4i - 4j")
        .format(other="at rest")
        .replace("velocity at rest", "at rest")
    )
    clash = diagnosis.clash(r.solve(r.parse(statement)))
    assert clash is not None
    assert "sine-cosine" in str(clash) or "angle-from-normal" in str(clash)


def test_facts_hold_in_altered_worlds():
    solution = r.solve(
        r.parse(
            "wall W: along i\nsphere P: velocity 4i - 3j\nP hits W\n"
            "given velocity(P) = 4i + 2j\nfind e"
        )
    )
    known = diagnosis.answers_of(solution)
    assert known[diagnosis.RIGHT] == (pytest.approx((2 / 3,)),)
    assert known["restitution-inverted/1"] == (pytest.approx((3 / 2,)),)


def test_the_difference_of_a_mistake():
    solution = r.solve(r.parse(VECTORS.format(other="-2i + j")))
    assert diagnosis.difference(solution, "restitution-inverted") > 0.5
    assert diagnosis.difference(solution, "second-wall-angle") == 0


# --- numbers ------------------------------------------------------------------------------------


@pytest.mark.parametrize("key", range(30))
def test_pairs_are_collisions_of_unlike_components(key):
    c = nice.pair(Dice(f"{key}"))
    assert c.m1 * c.p1 + c.m2 * c.p2 == c.m1 * c.q1 + c.m2 * c.q2
    assert c.q2 - c.q1 == c.e * (c.p1 - c.p2) > 0
    sizes = [abs(each) for each in (c.p1, c.s1, c.p2, c.s2, c.q1, c.q2)]
    assert len(set(sizes)) == 6
    assert all(each.denominator <= 6 for each in sizes)


@pytest.mark.parametrize(
    ("x", "y", "letter", "text"),
    [
        (3, -4, "", "3i - 4j"),
        (-1, 0, "", "-i"),
        (Fraction(1, 2), 1, "", "1/2 i + j"),
        (3, -1, "u", "3u i - u j"),
        (0, Fraction(-2, 3), "u", "-2/3 u j"),
    ],
)
def test_vectors_as_text(x, y, letter, text):
    assert nice.vector(x, y, letter) == text
    r.parse(f"sphere P: velocity {text}")


def test_nice_values():
    import sympy as sp

    assert nice.is_nice(sp.Rational(7, 60))
    assert nice.is_nice(2 * sp.sqrt(17) / 5)
    assert nice.is_nice((sp.Integer(3), sp.atan(sp.Rational(3, 4))))
    assert not nice.is_nice(sp.Rational(1, 61))
    assert not nice.is_nice(sp.sqrt(2) + sp.sqrt(3))
    assert not nice.is_nice(sp.sqrt(2 + sp.sqrt(3)))


# --- what comes next ----------------------------------------------------------------------------


def attempt(topic, day, earned=4, level=1, lost=False, mistakes=()):
    return {
        "topic": topic,
        "level": level,
        "seed": 1,
        "day": day,
        "earned": earned,
        "of": 4,
        "lost_method": lost,
        "mistakes": list(mistakes),
    }


def test_topics_come_in_order():
    assert next_question([], 100) == ("wall-forward", 1, None)
    assert next_question([attempt("wall-forward", 100)], 100).topic == "wall-coefficient"


@pytest.mark.parametrize(("successes", "pause"), [(1, 1), (2, 3), (3, 7), (4, 16), (5, 16)])
def test_a_topic_comes_back_after_longer_and_longer_pauses(successes, pause):
    done = [attempt("wall-forward", 100 + n) for n in range(successes)]
    last = 100 + successes - 1
    assert next_question(done, last + pause).topic == "wall-forward"
    assert next_question(done, last + pause - 1).topic == "wall-coefficient"


def test_a_topic_comes_back_when_a_method_mark_was_lost():
    done = [attempt("wall-forward", 100, earned=3, lost=True)]
    assert next_question(done, 100) == ("wall-forward", 1, None)


def test_a_mistake_named_twice_is_shown():
    done = [
        attempt("wall-forward", 100, 2, mistakes=["restitution-inverted"]),
        attempt("wall-forward", 101, 2, mistakes=["restitution-inverted", "sine-cosine"]),
    ]
    assert next_question(done, 101) == ("wall-forward", 1, "restitution-inverted")
    done.append(attempt("wall-forward", 102))
    assert next_question(done, 102).mistake is None


@pytest.mark.parametrize("slip", ["sign", "rounding-early", "no such"])
def test_a_slip_is_not_shown(slip):
    done = [attempt("wall-forward", day, 2, mistakes=[slip]) for day in (100, 101)]
    assert next_question(done, 101).mistake is None


def test_levels_go_up_and_down():
    two = [attempt("wall-forward", 100), attempt("wall-forward", 101)]
    assert next_question(two, 104) == ("wall-forward", 2, None)
    poor = [attempt("wall-forward", day, 1, level=3, lost=True) for day in (100, 101)]
    assert next_question(poor, 101) == ("wall-forward", 2, None)


def test_topics_are_shuffled_when_all_are_known():
    done = [attempt(topic.id, 100) for topic in TOPICS]
    chosen = next_question(done, 100)
    assert chosen.topic != TOPICS[-1].id
    assert chosen == next_question(done, 100)


def test_how_sure_one_is():
    assert set(sureness([], 5).values()) == {0.0}
    once = [attempt("wall-forward", 100)]
    often = once + [attempt("wall-forward", 101 + n, level=2) for n in range(3)]
    poor = [attempt("wall-forward", 100, earned=1)]

    def sure(done, day):
        return sureness(done, day)["wall-forward"]

    assert 0 < sure(poor, 100) < sure(once, 100) < sure(often, 103) <= 1
    assert 0 < sure(often, 300) < sure(often, 103)


@pytest.mark.parametrize(
    "rubbish",
    [
        None,
        {},
        {"topic": "no such"},
        {"topic": ["wall-forward"]},
        {**attempt("wall-forward", 100), "day": "yesterday"},
        {**attempt("wall-forward", 100), "earned": 9},
        {**attempt("wall-forward", 100), "level": 1.5},
        {**attempt("wall-forward", 100), "level": True},
        {**attempt("wall-forward", 10**30)},
    ],
)
def test_what_is_no_attempt_does_not_count(rubbish):
    assert next_question([rubbish], 100) == ("wall-forward", 1, None)
    assert set(sureness([rubbish], 100).values()) == {0.0}


def test_mistakes_that_are_no_ids_do_not_count():
    odd = {**attempt("wall-forward", 100), "mistakes": [None, 3, "x" * 1000, {}]}
    assert next_question([odd, odd], 100).mistake is None


@pytest.mark.nightly
@pytest.mark.timeout(3600)
@pytest.mark.parametrize("cell", CELLS, ids=str)
def test_questions_by_the_hundred(cell):
    """Solvable, of simple numbers, told apart, worded and drawn."""
    seen = set()
    for seed in range(1000):
        asked = practice_question(*cell, seed=seed)
        assert objection(asked.solution) == "", asked.address
        assert str(asked.question)
        assert r.draw(asked.solution) is not None
        seen.add(asked.statement.partition("\n")[2])
    assert len(seen) > 20


def test_the_second_part_on_lines_of_centres_asks_what_the_first_does_not_give():
    for seed in (1, 2):
        text = practice_question("line-of-centres", 1, seed).statement
        asked = [line for line in text.splitlines() if line.startswith("find")]
        assert asked == ["find velocity(B)", "find line_of_centres"]


@pytest.mark.parametrize(
    ("mistake", "topic", "said"),
    [
        ("momentum-sign", "wall-forward", "at level 1 it can in sphere-at-rest, spheres-moving"),
        ("second-wall-angle", "sphere-at-rest", "at level 1 it can in walls-at-90, walls-at-60"),
        ("energy-ratio-as-speed", "spheres-vectors", "at level 2 it can in wall-energy"),
        ("rounding-early", "wall-forward", "alters no law"),
    ],
)
def test_a_mistake_that_cannot_be_made_there_is_told(mistake, topic, said):
    with pytest.raises(StatementError, match=said):
        practice_question(topic, 1, 3, mistake)


def test_a_question_for_a_mistake_is_one_in_which_it_can_be_made():
    for mistake, topic, level in (
        ("deflection-is-after", "wall-impulse", 3),
        ("impulse-sign", "spheres-letters", 3),
    ):
        asked = practice_question(topic, level, 1, mistake)
        assert can_be_made(mistake, asked.problem)


def test_a_mistake_without_a_topic_chooses_one():
    asked = chosen(Wanted(mistake="momentum-sign"), State(), 100, 2)
    assert asked.topic == "sphere-at-rest"
    twice = [attempt("wall-forward", 100, mistakes=["deflection-is-after"])] * 2
    assert chosen(Wanted("wall-forward", 1), State(twice), 100, 2).topic == "wall-forward"
