"""The claims of ``tests/claims``: not one wrong verdict, and hardly one left undecided.

A false claim has to be refuted by numbers, and those are checked by other code than the
program's own: `plain_physics`.
"""

from __future__ import annotations

import random
from collections import defaultdict
from collections.abc import Iterable
from functools import cache

import claims
import pytest
from claims import Base, Concrete, Shown, judged

BASES = list(claims.bases())
EACH = 1  # so many of what follows from one line are tried in the normal run
LEAST = 160  # claims of the sample
BASES_ONE_IN = 3  # of the lines, one in so many is looked at in the normal run
SAMPLED = BASES[::BASES_ONE_IN]

all_claims = cache(claims.concrete)  # thousands of them: not before a test asks


def names(bases: Iterable[Base]) -> list[str]:
    """The groups of some lines."""
    return list(dict.fromkeys(each.group for each in bases))


def groups(chosen: Iterable[Concrete]) -> dict[str, list[Concrete]]:
    by_group = defaultdict(list)
    for each in chosen:
        by_group[each.group].append(each)
    return by_group


@cache
def sample() -> list[Concrete]:
    """A few of what follows from each line, the same at every run; the nightly run has all."""
    by_base = defaultdict(list)
    for each in all_claims():
        by_base[each.base].append(each)
    rng = random.Random(7)
    return [
        each
        for of_base in (by_base[base.place] for base in SAMPLED)
        for each in (rng.sample(of_base, EACH) if len(of_base) > EACH else of_base)
    ]


@cache
def of_sample(group: str) -> tuple[list[str], list[str]]:
    """What is wrong and what is undecided in a group of the sample."""
    return judged(groups(sample())[group])


def none_is_wrong(wrong: list[str], count: int) -> None:
    assert not wrong, "\n".join((f"{len(wrong)} of {count} wrong:", *wrong))


def hardly_one_is_open(open_: list[str], count: int, percent: int = 1) -> None:
    told = "\n".join((f"{len(open_)} of {count} undecided:", *open_))
    assert 100 * len(open_) < percent * count, told


@pytest.mark.parametrize("group", names(SAMPLED))
def test_no_verdict_is_wrong(group: str) -> None:
    none_is_wrong(of_sample(group)[0], len(groups(sample())[group]))


def test_hardly_one_is_undecided() -> None:
    open_ = [each for group in groups(sample()) for each in of_sample(group)[1]]
    hardly_one_is_open(open_, len(sample()), percent=2)


@pytest.mark.nightly
@pytest.mark.timeout(3600)
@pytest.mark.parametrize("group", names(BASES))
def test_no_verdict_of_all_is_wrong(group: str) -> None:
    chosen = groups(all_claims())[group]
    none_is_wrong(judged(chosen)[0], len(chosen))


@pytest.mark.nightly
@pytest.mark.timeout(7200)
def test_hardly_one_of_all_is_undecided() -> None:
    hardly_one_is_open(judged(all_claims())[1], len(all_claims()))


def test_there_are_enough_claims() -> None:
    assert len(BASES) >= 150
    assert len(all_claims()) >= 5000
    assert len(sample()) >= LEAST
    verdicts = [each.holds for each in all_claims() if isinstance(each, Shown)]
    assert 4 * min(verdicts.count(True), verdicts.count(False)) > len(verdicts)


def test_true_claims_hold_in_numbers() -> None:
    """What is written down as true is tried at random, by the physics of the tests alone."""
    rng = random.Random(3)
    doubts, tried = [], 0
    shown = defaultdict(list)
    for each in all_claims():
        if isinstance(each, Shown) and each.holds:
            shown[each.story].append(each)
    for story, of_story in shown.items():
        worlds = claims.possible_worlds(story, of_story, rng, wanted=12)
        tried += len(worlds)
        for world in worlds:
            for each, (show, now) in zip(of_story, world.claims, strict=True):
                if not world.holds(show.relation, now):
                    doubts.append(f"{each.base}: {each.claim} fails")
    assert not doubts, "\n".join(sorted(set(doubts)))
    assert tried > 6 * len(shown)
