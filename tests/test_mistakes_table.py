"""The table of misconceptions: complete, read as trees, each different from the law it replaces."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from restitution.errors import StatementError
from restitution.explaining.lines.derivation import Event
from restitution.explaining.lines.sentences import SENTENCES
from restitution.explaining.lines.usual_mistakes import PHRASES, USUAL_MISTAKES
from restitution.explaining.mistakes.listing import about_mistake
from restitution.explaining.mistakes.misconceptions import (
    MISCONCEPTIONS,
    SLIPS,
    alteration,
    misconception,
    mistake_id,
    variants_at,
)
from restitution.expression.tree import Quantity, walk

WALLS = (
    Event(1, "impact", ("P", "W"), wall=True),
    Event(2, "impact", ("P", "V"), wall=True),
)
SPHERES = Event(3, "impact", ("P", "Q"))
EVENTS = (*WALLS, SPHERES)

TABLE = [
    "deflection-is-after",
    "deflection-difference",
    "restitution-parallel",
    "restitution-whole-speed",
    "restitution-inverted",
    "restitution-omitted",
    "momentum-sign",
    "restitution-sign",
    "impulse-sign",
    "speed-for-component",
    "sine-cosine",
    "angle-from-normal",
    "across-exchanged",
    "across-changed",
    "mass-omitted",
    "masses-exchanged",
    "energy-of-difference",
    "energy-one-sphere",
    "energy-fraction-of-line",
    "energy-component-missing",
    "energy-ratio-as-speed",
    "energy-conserved",
    "energy-no-half",
    "square-not-taken",
    "impulse-of-speeds",
    "second-wall-angle",
    "rounding-early",
]


def test_every_row_of_the_table_is_there():
    assert list(MISCONCEPTIONS) == TABLE
    assert set(SLIPS) == {
        "sign", "arithmetic", "algebra", "misread", "calculator", "root", "copied"
    }  # fmt: skip


def test_sign_patterns_of_momentum_are_seven_laws():
    variants = MISCONCEPTIONS["momentum-sign"].variants
    assert [each.id for each in variants] == [f"momentum-sign/{n}" for n in range(1, 8)]
    assert len({each.laws[0].template for each in variants}) == 7


@pytest.mark.parametrize("name", TABLE)
def test_what_it_alters_is_as_its_kind_tells(name):
    row = MISCONCEPTIONS[name]
    if row.world == "motion":
        assert any(each.laws for each in row.variants)
    elif row.world == "result":
        assert all(each.results and not each.laws for each in row.variants)
        assert row.variants
    else:
        assert not row.variants
    assert alteration(f"{name}/1") is row.variants[0] if row.variants else True


@pytest.mark.parametrize("event", EVENTS, ids=("first wall", "second wall", "spheres"))
def test_variants_at_an_event_speak_of_its_bodies_and_stages(event):
    for variant in variants_at(event, EVENTS):
        trees = [side for law in variant.laws for side in law.sides]
        trees += [tree for result in variant.results for tree in (result.quantity, result.value)]
        assert trees
        for tree in (*trees, *variant.senses):
            for node in walk(tree):
                if isinstance(node, Quantity) and isinstance(node.stage, int):
                    assert 0 <= node.stage <= event.number
        names = {
            node.arguments[0].name
            for tree in trees
            for node in walk(tree)
            if isinstance(node, Quantity) and node.kind in ("velocity", "speed", "mass")
        }
        assert names <= set(event.bodies)


def test_the_old_angle_needs_a_wall_before():
    ids = [{each.mistake for each in variants_at(event, EVENTS)} for event in EVENTS]
    assert "second-wall-angle" not in ids[0] | ids[2]
    assert "second-wall-angle" in ids[1]
    assert "second-wall-angle" not in {each.mistake for each in variants_at(WALLS[1])}


def test_nothing_is_altered_where_nothing_is_struck():
    assert variants_at(Event(1, "arrival", ("P", "W"), wall=True)) == ()
    assert variants_at(Event(1, "kick", ("P",))) == ()


def test_ids_are_of_the_table():
    rng = random.Random(3)
    rows = rng.sample([each for each in MISCONCEPTIONS.values() if each.variants], 9)
    for row in rows:
        for each in row.variants:
            assert each.mistake == row.id
            assert alteration(each.id) is each
    with pytest.raises(KeyError):
        alteration("momentum/1")


def test_usual_mistakes_have_one_wording():
    """Each topic lists phrases of the table; no phrase stands twice, and none is left over."""
    assert len(set(PHRASES.values())) == len(PHRASES)
    listed = " ".join(USUAL_MISTAKES.values())
    for name, phrase in PHRASES.items():
        assert phrase in listed or name in MISCONCEPTIONS, name
    for name, row in MISCONCEPTIONS.items():
        assert row.phrase == PHRASES[name]
    assert all(SENTENCES[name] == text for name, text in USUAL_MISTAKES.items())
    assert {name for name in SENTENCES if name.endswith(".mistakes")} == set(USUAL_MISTAKES)


@pytest.mark.parametrize("name", TABLE)
def test_the_page_for_teachers_tells_each_mistake_in_the_words_of_the_table(name):
    docs = Path(__file__).parents[1] / "docs"
    text = (docs / "mistakes.md").read_text(encoding="utf-8")
    row = MISCONCEPTIONS[name]
    assert f"`{name}`: {row.sentence} {row.consequence}" in text
    assert f"A usual line: {row.line}." in text
    shown = row.world != "none"
    assert (f"(images/mistakes/{name}.svg)" in text) == shown
    assert (f', "{name}/' in text) == shown


@pytest.mark.parametrize("name", MISCONCEPTIONS)
def test_no_two_rows_of_a_list_have_the_same_words(name):
    rows = about_mistake(name, 1000).splitlines()
    words = [row.partition("  ")[2].strip() for row in rows if row.startswith(f"{name}/")]
    assert len(words) == len(set(words))


def test_a_slip_is_no_unknown_mistake():
    with pytest.raises(StatementError, match="'sign' is a slip, which has no world of its own"):
        misconception("sign")


@pytest.mark.parametrize("record", [*MISCONCEPTIONS.values(), *SLIPS.values()])
def test_a_mistake_is_known_by_its_title(record):
    assert mistake_id(record.title.upper().replace(" ", "-")) == record.id == mistake_id(record.id)
    assert mistake_id(f"{record.title}/2") == f"{record.id}/2"


def test_the_nearest_title_is_told_by_its_id():
    with pytest.raises(StatementError, match="did you mean masses-exchanged"):
        misconception("masses exchangd")
    with pytest.raises(StatementError, match="did you mean mass-omitted"):
        misconception("Masses left ot")
