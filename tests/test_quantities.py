"""The registry of quantities: what each record says is what every door makes of it."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

import restitution
from restitution.expression.defined import quantity_of
from restitution.expression.dimensions import SPEED
from restitution.expression.quantities import (
    ANGLES,
    CHANGED,
    ENERGIES,
    KINDS,
    LASTING,
    LOSSES,
    PLACED,
    QUANTITIES,
    UNSIGNED_ANGLES,
    Kind,
    dimension_of,
)
from restitution.expression.reading import read_expression
from restitution.expression.tree import Binary, Expression, Name, Quantity, Stage
from restitution.practice.letters.wordings import words_of
from restitution.workings import to_text

STORY = """
sphere A: mass 2, velocity 3i + j, at (0, 0)
sphere B: mass 1, velocity -i + j, at (8, 0)
A hits B: along i, e = 1/2
find {}
"""
NAMES = {"A": "sphere", "B": "sphere"}
ARGUMENTS = {"V": "velocity(A)", "W": "velocity(B)", "D": "i", "n": "1", "t": "3"}
ENDS = {"angle": ("velocity(A)", "velocity(B)"), "distance": ("A", "(1, 1)")}
KINDS_OF_ANSWERS = {
    "scalar": {"value"},
    "angle": {"value"},
    "vector": {"vector", "point", "direction"},
}


def forms(kind: str) -> list[str]:
    """The forms in which a quantity is written, by its own record, of the bodies of the story."""
    put = ARGUMENTS | dict(zip("XY", ENDS.get(kind, ("A", "B")), strict=True))
    usage = re.split(r", (?![^()]*\))| or ", KINDS[kind].usage)
    return [re.sub(r"\b[A-Znt]\b", lambda name: put.get(name[0], name[0]), form) for form in usage]


FORMS = [form for kind in QUANTITIES for form in forms(kind)]


@cache
def solution(form: str) -> restitution.Solution:
    """The story solved for one quantity."""
    return restitution.solve(restitution.parse(STORY.format(form)))


@pytest.mark.parametrize("form", FORMS)
def test_a_quantity_is_worth_what_its_record_says_and_is_asked_in_words(form: str) -> None:
    """By every form of its usage: a value of its nature, and a question without a formula."""
    solved = solution(form)
    ((_, result),) = solved.items()
    tree = read_expression(form, names=NAMES)
    if isinstance(tree, Quantity):
        nature = KINDS[tree.kind].nature_of(tree.arguments)
        assert result.kind in KINDS_OF_ANSWERS[nature]
        assert result.answers[0].angle == (nature == "angle")
    assert dimension_of(tree) is not None
    asked = str(restitution.question(solved.problem)).replace("\n", " ").split("Find ")[1]
    assert re.search(r"\w\(|_", asked) is None


@pytest.mark.parametrize("form", FORMS)
def test_a_quantity_has_a_working(form: str) -> None:
    """One that is followed, and written out to its end."""
    working = restitution.explain(solution(form), check=True)
    text = to_text(working)
    assert "written out" not in text


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("energy_lost(A)", "energy(A, before) - energy(A)"),
        ("energy_lost(B, 2)", "energy(B, 1) - energy(B, 2)"),
        ("2 energy_lost(A)/energy(A)", "2 (energy(A, before) - energy(A))/energy(A)"),
    ],
)
def test_what_others_define_is_read_as_its_definition(text: str, same: str) -> None:
    assert read_expression(text, names=NAMES) == read_expression(same, names=NAMES)


def test_what_all_lose_is_no_other_quantity() -> None:
    assert read_expression("energy_lost(2)") == Quantity("energy_lost", (), 2)


def test_what_one_event_of_several_takes_from_a_body_is_its_decrease_there() -> None:
    events = "wall W: along j\nA hits B: along i, e = 1/2\nB hits W: e = 1/3"
    story = STORY.replace("A hits B: along i, e = 1/2", events)
    asked = str(restitution.question(restitution.parse(story.format("energy_lost(A)"))))
    assert " ".join(asked.split()).endswith(
        "Find the decrease in the kinetic energy of A in the collision between A and B."
    )


def test_a_tree_that_nobody_read_is_worth_its_definition() -> None:
    (part,) = solution("energy_lost").parts.values()
    (branch,) = part.branches
    assert branch.numbers.quantity(Quantity("energy_lost", (Name("A"),), 1), 1) == 8
    assert branch.numbers.quantity(Quantity("energy_lost", (), 1), 1) == 4


def _approach(bodies: tuple[Expression, ...], early: Stage, late: Stage) -> Expression:
    one, other = (Quantity("speed", (body,), early) for body in bodies)
    return Binary("+", one, other)


@pytest.fixture
def approach(monkeypatch: pytest.MonkeyPatch) -> Kind:
    """A quantity that stands in the registry for the time of a test."""
    kind = Kind(
        "approach",
        "at which spheres on one line approach",
        "approach(A, B) or approach(A, B, n)",
        (2, 2),
        "scalar",
        SPEED,
        staged=True,
        of_an_event=True,
        noun="speed of approach",
        definition=_approach,
    )
    monkeypatch.setitem(KINDS, kind.word, kind)  # type: ignore[arg-type]
    return kind


BOTH = (Name("A"), Name("B"))


@pytest.mark.parametrize(
    ("text", "stage"),
    [
        ("speed(A, before) + speed(B, before)", None),
        ("speed(A, 0) + speed(B, 0)", 1),
        ("speed(A, 4) + speed(B, 4)", 5),
    ],
)
def test_what_others_define_is_known_by_its_definition(
    approach: Kind, text: str, stage: int | None
) -> None:
    tree = read_expression(text, names=NAMES)
    assert quantity_of(tree) == Quantity(approach.word, BOTH, stage)


@pytest.mark.parametrize(
    "text",
    [
        "speed(A, 0) + speed(B, 1)",
        "speed(A, before) - speed(B, before)",
        "speed(A) + energy(B)",
        "speed(A)",
        "speed(A, 0) + speed(B, before)",
    ],
)
def test_nothing_else_is_taken_for_it(approach: Kind, text: str) -> None:
    assert quantity_of(read_expression(text, names=NAMES)) is None


@pytest.mark.usefixtures("approach")
def test_its_noun_is_asked_for_and_said_to_students() -> None:
    problem = restitution.parse(STORY.format("speed(A, 0) + speed(B, 0)"))
    asked = " ".join(str(restitution.question(problem)).split())
    assert asked.endswith("Find the speed of approach of A and B.")
    tree = read_expression("speed(A, 0) + speed(B, 0)", names=NAMES)
    assert words_of(tree, problem) == "speed of approach of A and B"


@pytest.mark.usefixtures("approach")
def test_its_noun_stands_in_a_working() -> None:
    solved = restitution.solve(restitution.parse(STORY.format("speed(A, 0) + speed(B, 0)")))
    text = to_text(restitution.explain(solved, check=True))
    assert "speed of approach of A and B = " in text
    assert "does not follow" not in text


# --- families -------------------------------------------------------------------------------------

FAMILIES = {
    "ANGLES": ANGLES,
    "CHANGED": CHANGED,
    "ENERGIES": ENERGIES,
    "LASTING": LASTING,
    "LOSSES": LOSSES,
    "PLACED": PLACED,
    "UNSIGNED_ANGLES": UNSIGNED_ANGLES,
}
SOURCES = Path(restitution.__file__).parent


def spelled_out(module: ast.Module) -> Iterator[tuple[int, frozenset[str]]]:
    """The kinds that a module lists where it asks for the kind of a quantity, by their lines."""
    for node in ast.walk(module):
        match node:
            case ast.MatchClass(ast.Name("Quantity"), [ast.MatchOr(patterns), *_]) | ast.MatchClass(
                ast.Name("Quantity"), [ast.MatchAs(ast.MatchOr(patterns)), *_]
            ):
                values = [each.value for each in patterns if isinstance(each, ast.MatchValue)]
            case ast.Compare(ast.Attribute(attr="kind"), [ast.In() | ast.NotIn()], [listed]):
                values = list(getattr(listed, "elts", ()))
            case ast.Call(ast.Name("is_quantity"), [_, *values]):
                pass
            case _:
                continue
        kinds = [each.value for each in values if isinstance(each, ast.Constant)]
        if len(kinds) == len(values) > 1:
            yield node.lineno, frozenset(kinds)


@pytest.mark.parametrize("package", sorted(path.name for path in SOURCES.iterdir()))
def test_nobody_lists_the_kinds_of_a_family(package: str) -> None:
    """A quantity that joins a family by its record is found wherever the family is asked for."""
    root = SOURCES / package
    listed = [
        f"{path.relative_to(SOURCES)}:{line}: {name}"
        for path in ([root] if root.suffix == ".py" else root.rglob("*.py"))
        for line, kinds in spelled_out(ast.parse(path.read_text("utf-8")))
        for name, family in FAMILIES.items()
        if kinds == family
    ]
    assert listed == []
