"""Facts about letters, each told where the last of its letters appears."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from itertools import pairwise
from typing import Any, Literal

from restitution.expression.dimensions import SPEED
from restitution.expression.evaluate import letters_of_vector
from restitution.expression.tree import Expression, Letter, Polar, letters, walk
from restitution.problem import Compare, Given, Impact, Kick, Problem, Relation
from restitution.records import dataclass
from restitution.render import layout as lay
from restitution.wording import values
from restitution.wording.clauses import mathematics
from restitution.wording.later_facts import later_relations
from restitution.wording.letters import is_ratio, named_letters
from restitution.wording.scene import Scene, is_letter_fact
from restitution.wording.structure import Emphasis, Sentence, Words
from restitution.wording.words import listed, words

# Letters that stand for numbers wherever people write them.
_NUMBERS = frozenset(("k", "lambda", "mu", "nu"))


_TURNED: Mapping[str, Literal["<", "<="]] = {">": "<", ">=": "<="}


@dataclass(frozen=True)
class Fact:
    """A fact about letters, to be stated once they have appeared.

    ``nature`` is what a letter is (``acute``, ``a constant``); those of one nature are told
    together. A fact without it has its words in ``words``.
    """

    letters: frozenset[str]
    words: Words = ()
    nature: str = ""


def facts_of(scene: Scene) -> list[Fact]:
    """All facts about the letters of a statement."""
    problem = scene.problem
    positive, signed = _constants(scene)
    natures = [
        *((name, "acute") for name in sorted(scene.style.acute)),
        *((name, "a positive constant") for name in sorted(positive)),
        *((name, "a constant") for name in sorted(signed)),
    ]
    return [
        *(Fact(frozenset((name,)), nature=nature) for name, nature in natures),
        *(
            Fact(letters_of(relation), words(mathematics(relation)))
            for relation in _chained(_relations(problem))
            if _positive_letter(relation) not in positive
        ),
    ]


def _relations(problem: Problem) -> Iterator[Compare]:
    """The relations between letters that hold throughout."""
    lets, later = named_letters(problem), later_relations(problem)
    for part, step in problem.steps():
        if part.label is None and isinstance(step, Given):
            for relation in step.relations:
                if (
                    isinstance(relation, Compare)
                    and is_letter_fact(relation)
                    and not letters_of(relation) & lets
                    and not any(relation is other for other in later)
                ):
                    yield relation


def _chained(relations: Iterable[Compare]) -> Iterator[Compare]:
    """The relations, of which a lower and an upper bound of one letter are one chain."""
    rest = list(relations)
    while rest:
        relation = rest.pop(0)
        for comparison in rest:
            low, high = _upwards(relation), _upwards(comparison)
            low, high = (low, high) if _ends_alike(low, high) else (high, low)
            if _ends_alike(low, high):
                rest.remove(comparison)
                operands = (*low.operands, *high.operands[1:])
                relation = replace(
                    low, operands=operands, operators=(*low.operators, *high.operators)
                )
                break
        yield relation


def _upwards(relation: Compare) -> Compare:
    """A bound in which the lower side stands first; any other relation as it is."""
    match relation:
        case Compare((left, right), (">" | ">=" as sign,)):
            return replace(relation, operands=(right, left), operators=(_TURNED[sign],))
    return relation


def _ends_alike(low: Compare, high: Compare) -> bool:
    """Whether numbers bound one letter from below, and from above: ``1 ≤ k``, ``k ≤ 8``."""
    match low, high:
        case Compare((first, Letter() as letter), ("<" | "<=",)), Compare(
            (same, last), ("<" | "<=",)
        ):
            return same == letter and not letters(first) and not letters(last)
    return False


def letters_of(relation: Relation) -> frozenset[str]:
    """The letters of a relation of expressions."""
    if isinstance(relation, Compare):
        return frozenset().union(*(letters(operand) for operand in relation.operands))
    return frozenset()


def with_facts(
    sentences: Sequence[Sentence], facts: Sequence[Fact]
) -> tuple[list[Sentence], list[Fact]]:
    """The sentences with the facts in them, and the facts that found no place."""
    acute = frozenset().union(*map(_acute_letters, sentences))
    pending = [fact for fact in facts if not (fact.nature == "acute" and fact.letters <= acute)]
    seen: frozenset[str] = frozenset()
    out: list[Sentence] = []
    for sentence in sentences:
        here = letters_in(sentence)
        seen |= here
        due = [fact for fact in pending if fact.letters & here and fact.letters <= seen]
        pending = [fact for fact in pending if fact not in due]
        out.append(_where(sentence, due))
    return out, [fact for fact in pending if not fact.nature]


def _where(sentence: Sentence, facts: Sequence[Fact]) -> Sentence:
    if not facts:
        return sentence
    where = listed(_phrases(facts))
    broken = _broken(sentence, frozenset().union(*(fact.letters for fact in facts)))
    if broken is not None:
        before, after = broken
        return words(before, ", where ", where, ", and ", after)
    *front, last = sentence
    assert isinstance(last, str)
    return words(*front, last.removesuffix("."), ", where ", where, ".")


def _broken(sentence: Sentence, names: frozenset[str]) -> tuple[Words, Words] | None:
    """A sentence of two clauses, broken where the second begins, if it has none of the letters.

    ``A is moving at an acute angle α to i`` and ``B is at rest.``
    """
    joints = [
        place
        for place, piece in enumerate(sentence)
        if isinstance(piece, str)
        and piece.endswith(" and ")
        and isinstance(sentence[place + 1], Emphasis)
        and str(sentence[place + 2]).startswith((" is at rest", " is moving"))
    ]
    if len(joints) != 1 or any(", " in word for word in sentence if isinstance(word, str)):
        return None
    (place,) = joints
    joint = str(sentence[place]).removesuffix(" and ")
    before, after = words(sentence[:place], joint), words(sentence[place + 1 :])
    return None if letters_in(after) & names or not letters_in(before) & names else (before, after)


def _phrases(facts: Sequence[Fact]) -> list[Words]:
    """Facts in words: ``p and q are constants``, ``tan α = ¾``."""
    out: list[Words] = []
    for nature in dict.fromkeys(fact.nature for fact in facts if fact.nature):
        names = [name for fact in facts if fact.nature == nature for name in fact.letters]
        noun = nature.removeprefix("a ")
        several = noun if noun == nature else f"{noun}s"
        verb = f" is {nature}" if len(names) == 1 else f" are {several}"
        out.append(words(listed([lay.letter(name) for name in names]), verb))
    return out + [fact.words for fact in facts if not fact.nature]


def _acute_letters(sentence: Sentence) -> frozenset[str]:
    """The letters that a sentence calls acute angles already."""
    return frozenset().union(
        *(
            letters_in(word)
            for before, word in pairwise(sentence)
            if isinstance(before, str) and before.endswith("acute angle ")
        )
    )


def letters_in(value: Any) -> frozenset[str]:
    """The letters in a row of pieces, by their canonical names."""
    if isinstance(value, lay.Letter):
        return frozenset((f"{value.name}_{value.subscript}" if value.subscript else value.name,))
    if isinstance(value, tuple):
        return frozenset().union(*(letters_in(part) for part in value))
    if is_dataclass(value):
        return frozenset().union(*(letters_in(getattr(value, f.name)) for f in fields(value)))
    return frozenset()


# --- constants ------------------------------------------------------------------------------------


def _constants(scene: Scene) -> tuple[frozenset[str], frozenset[str]]:
    """Letters that stand for numbers: positive ones, and components of either sign."""
    positive: set[str] = set()
    signed: set[str] = set()
    asked = {letter.name for letter in scene.problem.letters_asked()}
    for sphere in scene.problem.spheres:
        mass, velocity = sphere.mass, sphere.velocity
        if isinstance(mass, Expression):
            factors = letters(mass)
            positive |= {
                factor for factor in factors if len(factors) > 1 and factor[:1] not in "mM"
            }
        if isinstance(velocity, Expression):
            positive |= letters(velocity) & _NUMBERS
            if not isinstance(velocity, Polar):
                # Of a component that is asked the sign decides between two values.
                positive |= letters_of_vector(velocity)[0] & asked
            if scene.style.fixes(SPEED) and not isinstance(velocity, Polar):
                signed |= _components(velocity)
                positive |= letters_of_vector(velocity)[0] & signed
    runs = [wall.along for wall in scene.problem.walls]
    for _, step in scene.problem.steps():
        if isinstance(step, Kick):
            positive |= letters(step.impulse) & _NUMBERS
        elif isinstance(step, Impact):
            runs.append(step.along)
    for run in runs:
        if isinstance(run, Expression) and values.is_vector(run):
            signed |= _components(run)
    signed -= positive
    bounded = {_positive_letter(relation) for relation in _relations(scene.problem)} - {None}
    positive, signed = positive | (signed & bounded), signed - bounded
    # One of which more is said is not called positive as well.
    more = {
        name for relation in _relations(scene.problem) for name in letters_of(relation)
    } - bounded
    lets = named_letters(scene.problem)
    return frozenset(positive - more - lets), frozenset((signed | (positive & more)) - lets)


def _components(tree: Expression) -> frozenset[str]:
    """The letters of a vector but for those of its angles."""
    inside = {name for node in walk(tree) if is_ratio(node) for name in letters(node)}
    return letters(tree) - inside


def _positive_letter(relation: Compare) -> str | None:
    """The letter of which a fact says that it is positive, and no more."""
    match relation:
        case Compare((Letter(name), zero), (">",)) | Compare((zero, Letter(name)), ("<",)):
            return name if values.is_zero(zero) else None
    return None
