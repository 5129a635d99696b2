"""From a problem to its question: what is told, in which order, and what is asked of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any

from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Pi,
    Polar,
    letters,
    walk,
)
from restitution.problem import (
    Arrival,
    Compare,
    Find,
    Given,
    Impact,
    Kick,
    Let,
    Part,
    Problem,
    Relation,
    Show,
    Unknown,
    trees,
)
from restitution.render import layout as lay
from restitution.wording import values
from restitution.wording.asking import groups, in_terms, shown
from restitution.wording.clauses import clause, clauses, mathematics
from restitution.wording.nouns import phrase
from restitution.wording.question import (
    Block,
    Listing,
    Paragraph,
    Question,
    QuestionPart,
    Sentence,
    Words,
)
from restitution.wording.scene import INITIALLY, Scene, before, is_letter_fact, scene_of
from restitution.wording.setting import setting, spheres_told, start
from restitution.wording.story import told
from restitution.wording.units import LENGTH, SPEED
from restitution.wording.words import alphabetic, listed, roman, sentence, words

# Letters that stand for numbers wherever people write them.
_NUMBERS = frozenset(("k", "lambda", "mu", "nu"))


def question(problem: Problem, *, marks: Mapping[str | None, int] | None = None) -> Question:
    """The exam-style question that a statement makes; nothing is solved for it.

    Units are printed as exam papers do: behind numbers, which are SI. ``marks`` are by the label
    of a part (None for what is asked before the first); they are only printed.

    >>> from restitution.language import parse
    >>> print(question(parse('wall W: along i\\nsphere P: velocity 2i - 6j\\nP hits W: e = 1/3\\n'
    ...                      'find speed(P)')))
    A smooth uniform sphere P moves on a smooth horizontal plane. Perpendicular unit
    vectors 𝐢 and 𝐣 lie in the plane. A fixed smooth vertical wall W is parallel to
    𝐢. Immediately before the impact P is moving with velocity (2𝐢 − 6𝐣) m s⁻¹. P
    hits W. The coefficient of restitution between P and W is ⅓. Find the speed of P
    immediately after the impact.
    """
    scene = scene_of(problem)
    drafts = list(_drafts(scene))
    first = [*setting(scene), *(() if _event_first(scene) else start(scene)), *drafts[0].opening]
    blocks = [replace(drafts[0], opening=tuple(first)), *drafts[1:]]
    blocks = _with_facts(problem, blocks)
    opening = _with_axes(scene, blocks)
    marks = marks or {}
    parts = tuple(
        QuestionPart(each.label, each.blocks, marks.get(each.label))
        for each in (replace(blocks[0], opening=()), *blocks[1:])
        if each.blocks
    )
    return Question(problem.title, opening, parts)


@dataclass(frozen=True)
class _Draft:
    """A part in the making: sentences before anything is asked, then the rest."""

    label: str | None
    opening: tuple[Sentence, ...]
    rest: tuple[Block, ...] = ()

    @property
    def blocks(self) -> tuple[Block, ...]:
        return (Paragraph(self.opening), *self.rest) if self.opening else self.rest


# --- parts ----------------------------------------------------------------------------------------


def _drafts(scene: Scene) -> Iterator[_Draft]:
    number = _numbering(scene.problem)
    lets = _lets(scene.problem)
    now = 0
    for part in scene.problem.parts:
        blocks: list[Block] = []
        for run in _runs(part):
            now, made = _run(scene, now, run, lets)
            blocks += made
        yield _draft(part.label, _numbered(blocks, number))


def _numbered(blocks: Sequence[Block], number: Callable[[int], str]) -> list[Block]:
    """What is asked with its numbers, unless it is one thing only."""
    asked = [each for each in blocks if isinstance(each, Listing)]
    if sum(len(each.entries) for each in asked) <= 1:
        return list(blocks)
    out: list[Block] = []
    count = 0
    for block in blocks:
        if isinstance(block, Listing):
            entries = tuple((number(count + n), said) for n, (_, said) in enumerate(block.entries, 1))
            count += len(entries)
            block = replace(block, entries=entries)
        out.append(block)
    return out


def _event_first(scene: Scene) -> bool:
    """Whether the only event is told before the velocities that hold just before it."""
    return len(scene.events) == 1 and before(scene) != INITIALLY and bool(scene.problem.spheres)


def _draft(label: str | None, blocks: Sequence[Block]) -> _Draft:
    """The blocks with neighbouring paragraphs made one."""
    merged: list[Block] = []
    for block in blocks:
        last = merged[-1] if merged else None
        if isinstance(block, Paragraph) and isinstance(last, Paragraph):
            merged[-1] = Paragraph(last.sentences + block.sentences)
        else:
            merged.append(block)
    if merged and isinstance(merged[0], Paragraph):
        return _Draft(label, merged[0].sentences, tuple(merged[1:]))
    return _Draft(label, (), tuple(merged))


def _numbering(problem: Problem) -> Any:
    """Roman numbers, unless they are the labels of the parts themselves."""
    labels = {part.label for part in problem.parts}
    return alphabetic if labels & {"i", "ii"} else roman


def _lets(problem: Problem) -> frozenset[str]:
    return frozenset(step.letter for _, step in problem.steps() if isinstance(step, Let))


@dataclass(frozen=True)
class _Run:
    """What is said between one event and the next."""

    event: Impact | Kick | Arrival | None
    label: str | None
    lets: tuple[Let, ...]
    relations: tuple[Relation, ...]
    unknown: tuple[str, ...]
    asks: tuple[Find | Show, ...]


def _runs(part: Part) -> Iterator[_Run]:
    event: Any = None
    steps: list[Any] = []
    for step in part.steps:
        if isinstance(step, Impact | Kick | Arrival):
            yield _run_of(part.label, event, steps)
            event, steps = step, []
        else:
            steps.append(step)
    yield _run_of(part.label, event, steps)


def _run_of(label: str | None, event: Any, steps: Sequence[Any]) -> _Run:
    return _Run(
        event,
        label,
        tuple(each for each in steps if isinstance(each, Let)),
        tuple(one for each in steps if isinstance(each, Given) for one in each.relations),
        tuple(one for each in steps if isinstance(each, Unknown) for one in each.letters),
        tuple(each for each in steps if isinstance(each, Find | Show)),
    )


def _run(scene: Scene, now: int, run: _Run, lets: frozenset[str]) -> tuple[int, list[Block]]:
    """An event, then what is named, given and asked before the next."""
    sentences: list[Sentence] = []
    if run.event is not None:
        now += 1
        hit, *more = told(scene, now)
        sentences += [hit, *(start(scene) if _event_first(scene) else ()), *more]
    scene = scene.at(now)
    for let in run.lets:
        sentences.append(sentence("let ", lay.letter(let.letter), " denote ", phrase(scene, let.expression)))
    if run.unknown:
        sentences.append(_not_known(run))
    facts = [
        each
        for each in run.relations
        if run.label is not None or not is_letter_fact(each) or _letters(each) & lets
    ]
    asked = _asked(scene, run.asks)
    if asked is not None and facts and (asked.lead or len(asked.entries) == 1):
        asked = _under(scene, facts, asked)
        facts = []
    motion = [each for each in facts if not is_letter_fact(each)]
    sentences += [sentence(each) for each in clauses(scene, motion)]
    if len(motion) < len(facts):
        said = [clause(scene, each) for each in facts if is_letter_fact(each)]
        sentences.append(sentence("it is given that ", listed(said)))
    blocks: list[Block] = [Paragraph(tuple(sentences))] if sentences else []
    if asked is not None:
        blocks.append(asked)
    return now, blocks


def _under(scene: Scene, facts: Sequence[Relation], asked: Listing) -> Listing:
    """What is asked with what is given for it: ``Given that k = 3, find …``."""
    motion = clauses(scene, [each for each in facts if not is_letter_fact(each)])
    of_letters = [clause(scene, each) for each in facts if is_letter_fact(each)]
    told_each = [*of_letters, *(words("that ", each) if n or of_letters else each for n, each in enumerate(motion))]
    given = words("Given that ", listed(told_each), ", ")
    if asked.lead:
        return replace(asked, lead=words(given, _lower(asked.lead)))
    ((number, only),) = asked.entries
    return replace(asked, entries=((number, words(given, _lower(only))),))


def _stem(said: Sentence) -> str:
    """The last words of a sentence, without its full stop."""
    last = said[-1]
    assert isinstance(last, str)
    return last.removesuffix(".")


def _lower(said: Words) -> Words:
    """Words that no longer begin a sentence."""
    first = said[0]
    if isinstance(first, str):
        return (first[:1].lower() + first[1:], *said[1:])
    return said


def _not_known(run: _Run) -> Sentence:
    where = "in this part " if run.label is not None else ""
    each = [lay.letter(name) for name in run.unknown]
    verb = "value of {} is" if len(each) == 1 else "values of {} are"
    front, back = verb.split("{}")
    return sentence(where, "the ", front, listed(each), back, " not known")


def _letters(relation: Relation) -> frozenset[str]:
    if isinstance(relation, Compare):
        return frozenset().union(*(letters(each) for each in relation.operands))
    return frozenset()


# --- asking ---------------------------------------------------------------------------------------


def _asked(scene: Scene, asks: Sequence[Find | Show]) -> Listing | None:
    if not asks:
        return None
    if all(isinstance(each, Find) and not each.in_terms_of for each in asks):
        items = [one for each in asks if isinstance(each, Find) for one in groups(scene, each)]
        if len(items) <= 2:
            return Listing((), (("", sentence("find ", listed(items))),))
        return Listing(("Find",), tuple(("", each) for each in items))
    if len(asks) == 1:
        (only,) = asks
        if isinstance(only, Show):
            return Listing((), (("", sentence(shown(scene, only))),))
        items = groups(scene, only)
        if len(items) <= 2:
            return Listing((), (("", sentence(_found(scene, only))),))
        lead = words("Find, ", in_terms(only), ",")
        return Listing(lead, tuple(("", each) for each in items))
    entries = [
        sentence(shown(scene, each)) if isinstance(each, Show) else sentence(_found(scene, each))
        for each in asks
    ]
    return Listing((), tuple(("", each) for each in entries))


def _found(scene: Scene, find: Find) -> Words:
    items = groups(scene, find)
    terms = in_terms(find)
    if not terms:
        return words("find ", listed(items))
    if len(items) == 1:
        comma = "," if len(words(items)) > 1 else ""
        return words("find ", items[0], comma, " ", terms)
    return words("find, ", terms, ", ", listed(items))


# --- facts about letters --------------------------------------------------------------------------


@dataclass(frozen=True)
class _Fact:
    """Something to be said of letters once they have appeared."""

    letters: frozenset[str]
    said: Words
    acute: str = ""


def _with_facts(problem: Problem, drafts: Sequence[_Draft]) -> list[_Draft]:
    """The facts about letters, each told where the last of its letters appears."""
    pending = [*_natures(problem), *_letter_facts(problem)]
    seen: frozenset[str] = frozenset()
    out: list[_Draft] = []
    for draft in drafts:
        opening: list[Sentence] = []
        for each in draft.opening:
            here = letters_in(each)
            seen |= here
            pending = [fact for fact in pending if not (fact.acute and _says_acute(each, fact.acute))]
            due = [fact for fact in pending if fact.letters & here and fact.letters <= seen]
            pending = [fact for fact in pending if fact not in due]
            opening.append(_where(each, due))
        out.append(replace(draft, opening=tuple(opening)))
    left = [fact for fact in pending if not fact.acute]
    extra = [sentence("it is given that ", listed([fact.said for fact in left]))] if left else []
    out[0] = replace(out[0], opening=(*out[0].opening, *extra))
    return out


def _where(said: Sentence, facts: Sequence[_Fact]) -> Sentence:
    if not facts:
        return said
    return words(said[:-1], _stem(said), ", where ", listed([each.said for each in facts]), ".")


def _says_acute(said: Sentence, name: str) -> bool:
    return any(
        isinstance(before, str) and before.endswith("acute angle ") and each == lay.letter(name)
        for before, each in zip(said, said[1:], strict=False)
    )


def letters_in(said: Any) -> frozenset[str]:
    """The letters in a row of pieces, by their canonical names."""
    if isinstance(said, lay.Letter):
        return frozenset((f"{said.name}_{said.subscript}" if said.subscript else said.name,))
    if isinstance(said, tuple):
        return frozenset().union(*(letters_in(each) for each in said))
    if is_dataclass(said):
        return frozenset().union(*(letters_in(getattr(said, f.name)) for f in fields(said)))
    return frozenset()


def _letter_facts(problem: Problem) -> Iterator[_Fact]:
    """The facts about letters that hold throughout."""
    lets = _lets(problem)
    constants, _ = _constants(problem)
    for part, step in problem.steps():
        if part.label is None and isinstance(step, Given):
            for relation in step.relations:
                if not isinstance(relation, Compare) or not is_letter_fact(relation):
                    continue
                if not _letters(relation) & lets and _said_positive(relation) not in constants:
                    yield _Fact(_letters(relation), words(mathematics(relation)))


def _natures(problem: Problem) -> Iterator[_Fact]:
    """Which letters are acute angles, and which are constants."""
    lets = _lets(problem)
    for name in sorted(_angles(problem) - lets):
        if not _wide(problem, name):
            yield _Fact(frozenset((name,)), words(lay.letter(name), " is acute"), name)
    positive, any_sign = _constants(problem)
    for group, word in ((positive - lets, "positive constant"), (any_sign - positive - lets, "constant")):
        for name in sorted(group):
            yield _Fact(frozenset((name,)), words(lay.letter(name), f" is a {word}"))


def _angles(problem: Problem) -> frozenset[str]:
    """Letters in the directions of what is given."""
    found: list[Expression] = []
    for each in trees(problem):
        found += [node.angle for node in walk(each) if isinstance(node, Polar)]
    for sphere in problem.spheres:
        if isinstance(sphere.velocity, Expression):
            found += [node for node in walk(sphere.velocity) if _is_ratio(node)]
    plain = [wall.along for wall in problem.walls]
    plain += [step.along for _, step in problem.steps() if isinstance(step, Impact)]
    found += [each for each in plain if isinstance(each, Expression) and not values.is_vector(each)]
    return frozenset().union(*(letters(each) for each in found))


def _is_ratio(tree: Expression) -> bool:
    """Whether a tree is the sine, cosine or tangent of an angle, or the like."""
    return isinstance(tree, Apply) and tree.function not in ("sqrt", "abs")


def _wide(problem: Problem, name: str) -> bool:
    """Whether a fact lets an angle be other than acute."""
    for part, step in problem.steps():
        if not (isinstance(step, Given) and part.label is None):
            continue
        for relation in step.relations:
            if isinstance(relation, Compare) and Letter(name) in relation.operands:
                if any(_not_acute(each) for each in relation.operands):
                    return True
    return False


def _not_acute(tree: Expression) -> bool:
    match tree:
        case Degrees(value):
            return value > 90
        case Negate():
            return True
        case Pi():
            return True
    return False


def _constants(problem: Problem) -> tuple[frozenset[str], frozenset[str]]:
    """Letters that stand for numbers: positive ones, and components of either sign."""
    positive: set[str] = set()
    signed: set[str] = set()
    scale = scene_of(problem).scale
    for sphere in problem.spheres:
        mass, velocity = sphere.mass, sphere.velocity
        if isinstance(mass, Expression):
            positive |= {each for each in letters(mass) if len(letters(mass)) > 1 and each[:1] not in "mM"}
        if isinstance(velocity, Expression):
            positive |= {each for each in letters(velocity) if each in _NUMBERS}
            if scale.fixes(SPEED) and not isinstance(velocity, Polar):
                signed |= _outside_functions(velocity)
    for part, step in problem.steps():
        if isinstance(step, Kick):
            positive |= {each for each in letters(step.impulse) if each in _NUMBERS}
        elif isinstance(step, Given) and part.label is None:
            above = {_said_positive(each) for each in step.relations} & signed
            positive |= above
    return frozenset(positive), frozenset(signed)


def _said_positive(relation: Relation) -> str | None:
    """The letter of which a fact says that it is positive."""
    match relation:
        case Compare((Letter(name), zero), (">",)) | Compare((zero, Letter(name)), ("<",)):
            return name if values.is_zero(zero) else None
    return None


def _outside_functions(tree: Expression) -> set[str]:
    inside = {name for node in walk(tree) if _is_ratio(node) for name in letters(node)}
    return set(letters(tree)) - inside


# --- the axes -------------------------------------------------------------------------------------


def _with_axes(scene: Scene, drafts: Sequence[_Draft]) -> tuple[Sentence, ...]:
    """The opening, with **i** and **j** and coordinates explained where they are used."""
    opening = list(drafts[0].opening)
    everything = [each.blocks for each in drafts]
    units = _contains(everything, lambda each: each in (lay.Bold("i"), lay.Bold("j")))
    points = _contains(everything, lambda each: isinstance(each, lay.Coordinates))
    points = points or _contains(everything, lambda each: isinstance(each, str) and "coordinates" in each)
    turning = _contains(everything, lambda each: isinstance(each, str) and "clockwise" in each)
    told_axes: list[Sentence] = []
    if units or points:
        sense = ""
        if turning:
            told_axes.append(
                sentence(
                    "perpendicular unit vectors ", lay.Bold("i"), " and ", lay.Bold("j"),
                    " lie in the plane, ", lay.Bold("j"), " at 90° anticlockwise from ", lay.Bold("i"),
                )
            )
        else:
            told_axes.append(
                sentence(
                    "perpendicular unit vectors ", lay.Bold("i"), " and ", lay.Bold("j"),
                    " lie in the plane",
                )
            )
    if points:
        metres = ", in metres," if scene.scale.fixes(LENGTH) else ""
        told_axes.append(
            sentence(
                f"the coordinates of points{metres} are referred to axes in the directions of ",
                lay.Bold("i"), " and ", lay.Bold("j"),
            )
        )
    return (*opening[:_bodies_end(scene)], *told_axes, *opening[_bodies_end(scene):])


def _bodies_end(scene: Scene) -> int:
    """After how many sentences all spheres have been introduced."""
    return len(list(spheres_told(scene)))


def _contains(said: Any, wanted: Any) -> bool:
    if wanted(said):
        return True
    if isinstance(said, tuple | list):
        return any(_contains(each, wanted) for each in said)
    if is_dataclass(said) and not isinstance(said, type):
        return any(_contains(getattr(said, each.name), wanted) for each in fields(said))
    return False
