"""From a problem to its question: what is told, in which order, and what is asked of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from itertools import islice
from typing import Any

from restitution.errors import StatementError, require
from restitution.expression.dimensions import LENGTH
from restitution.expression.tree import Binary, Expression, Place, Quantity, has_quantity, letters
from restitution.language import check
from restitution.problem import (
    Event,
    Find,
    Given,
    Let,
    Part,
    Point,
    Problem,
    Relation,
    Show,
    Sphere,
    Step,
    Unknown,
    Wall,
    count_of_items,
    once_a_problem,
)
from restitution.records import dataclass
from restitution.render import layout as lay
from restitution.wording import facts, formulas
from restitution.wording.asking import Group, groups, in_terms, names_of, shown
from restitution.wording.clauses import clause, clauses
from restitution.wording.facts import letters_of
from restitution.wording.later_facts import between_events, facts_apart
from restitution.wording.letters import named_letters
from restitution.wording.scene import INITIALLY, Scene, before, is_letter_fact, scene_of
from restitution.wording.setting import setting, spheres, start
from restitution.wording.story import event_sentences
from restitution.wording.structure import (
    Block,
    Emphasis,
    Entry,
    Listing,
    Paragraph,
    QuestionPart,
    Sentence,
    Words,
)
from restitution.wording.whole import Question
from restitution.wording.words import alphabetic, listed, number_of_words, roman, sentence, words


def question(problem: Problem, *, marks: Mapping[str | None, int] | None = None) -> Question:
    r"""The exam-style question that a statement makes; nothing is solved for it.

    Units are printed as exam papers do: behind numbers, which are SI. ``marks`` are by the label
    of a part (None for what is asked before the first); they are only printed. Raises
    StatementError for a problem that makes no sense, or that holds floats or arrays.

    >>> from restitution.language import parse
    >>> print(question(parse('wall W: along i\nsphere P: velocity 2i - 6j\nP hits W: e = 1/3\n'
    ...                      'find speed(P)')))
    A smooth uniform sphere P moves on a smooth horizontal plane. Perpendicular unit
    vectors 𝐢 and 𝐣 lie in the plane. A fixed smooth vertical wall W is parallel to
    𝐢. P hits W. Immediately before the impact P is moving with velocity
    (2𝐢 − 6𝐣) m s⁻¹. The coefficient of restitution between P and W is ⅓.
    <BLANKLINE>
    Find the speed of P immediately after the impact.
    """
    require(problem, Problem, "question")
    check(problem)
    _exact(problem)
    scene = scene_of(problem)
    drafts = list(_drafts(scene))
    first = [*setting(scene), *(() if _event_first(scene) else start(scene)), *drafts[0].opening]
    blocks = [replace(drafts[0], opening=tuple(first)), *drafts[1:]]
    blocks = _with_facts(scene, blocks)
    opening = _with_axes(scene, blocks)
    marks = marks or {}
    parts = tuple(
        QuestionPart(block.label, block.blocks, marks.get(block.label))
        for block in (replace(blocks[0], opening=()), *blocks[1:])
        if block.blocks
    )
    return Question(problem.title, opening, parts)


@once_a_problem
def has_axes(problem: Problem) -> bool:
    """Whether the question in words explains **i** and **j**. Raises StatementError as it does."""
    sentences = question(problem).intro
    return _contains(sentences, lambda part: part in (lay.Bold("i"), lay.Bold("j")))


@once_a_problem
def letters_of_formulas(problem: Problem) -> Mapping[Quantity | Binary, str]:
    """The letters that formulas of the question have for speeds and for times."""
    scene = scene_of(problem)
    list(_drafts(scene))
    return scene.lettered


def asked(problem: Problem) -> dict[str | None, tuple[Words, ...]]:
    """What each part asks, item by item, in words. Raises StatementError as `question` does."""
    check(problem)
    _exact(problem)
    scene = scene_of(problem)
    asked_: dict[str | None, tuple[Words, ...]] = {}
    for part in problem.parts:
        items: list[Words] = []
        for step, now, own in problem.timeline(part):
            if own is part and isinstance(step, Find | Show):
                items += names_of(scene.at(now), step)
        asked_[part.label] = tuple(items)
    return asked_


@once_a_problem
def numbers_of_items(problem: Problem) -> Mapping[str | None, tuple[str, ...]]:
    """The number in the question of each item of a part: ``"i"``, ``"ii"``, …

    Empty where the part asks one thing only. Items that are asked together have the same number.
    """
    number = _numbering(problem)
    scene = scene_of(problem)
    now = 0
    numbers: dict[str | None, tuple[str, ...]] = {}
    for part in problem.parts:
        runs = _runs(problem, part)
        asks = [ask for run in runs for ask in run.asks]
        alone = sum(map(count_of_items, asks)) < 2
        sizes: list[int] = []
        for run in runs:
            now += run.event is not None
            listing = None if alone else _asked(scene.at(now), run)
            sizes += [] if listing is None else [entry.items for entry in listing.entries]
        sizes = [1] * len(asks) if alone else sizes
        several = len(sizes) > 1
        numbers[part.label] = tuple(
            number(n) if several else "" for n, size in enumerate(sizes, 1) for _ in range(size)
        )
    return numbers


def _exact(problem: Problem) -> None:
    """Raise StatementError for data that no statement could hold."""
    bodies: list[Sphere | Wall | Point] = [*problem.spheres, *problem.walls, *problem.points]
    for body in bodies:
        for field in fields(body):
            value = getattr(body, field.name)
            if not isinstance(value, Expression | str | Place | None):
                message = f"the {field.name} of {body.name} is not an exact number: {value!r}"
                raise StatementError(message)


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
    lets = named_letters(scene.problem)
    now = 0
    for part in scene.problem.parts:
        blocks: list[Block] = []
        for run in _runs(scene.problem, part):
            now, more = _run(scene, now, run, lets)
            blocks += more
        yield _draft(part.label, _numbered(blocks, number))


def _numbered(blocks: Sequence[Block], number: Callable[[int], str]) -> list[Block]:
    """What is asked with its numbers, unless it is one thing only."""
    asked = [block for block in blocks if isinstance(block, Listing)]
    if sum(len(listing.entries) for listing in asked) <= 1:
        return list(blocks)
    out: list[Block] = []
    count = 0
    for block in blocks:
        if isinstance(block, Listing):
            entries = tuple(
                replace(entry, number=number(count + n)) for n, entry in enumerate(block.entries, 1)
            )
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
        elif (
            isinstance(block, Listing)
            and isinstance(last, Listing)
            and not (block.lead or last.lead)
        ):
            merged[-1] = replace(last, entries=last.entries + block.entries)
        else:
            merged.append(block)
    if merged and isinstance(merged[0], Paragraph):
        return _Draft(label, merged[0].sentences, tuple(merged[1:]))
    return _Draft(label, (), tuple(merged))


def _numbering(problem: Problem) -> Any:
    """Roman numbers, unless they are the labels of the parts themselves."""
    labels = {part.label for part in problem.parts}
    return alphabetic if labels & {"i", "ii"} else roman


@dataclass(frozen=True)
class _Run:
    """What is said between one event and the next."""

    event: Event | None
    label: str | None
    lets: tuple[Let, ...]
    relations: tuple[Relation, ...]
    unknown: tuple[str, ...]
    asks: tuple[Find | Show, ...]
    below: bool = False  # whether its facts stand below what is asked without them
    numbered: bool = False  # whether its part asks more than once: then each item has a number


def _runs(problem: Problem, part: Part) -> list[_Run]:
    """The runs of a part; what is said of letters alone stands where something is first asked.

    What is asked above a fact, and without it, has a run of its own.
    """
    events: list[Event | None] = [None]
    events += [step for step in part.steps if isinstance(step, Event)]
    runs: list[_Run] = []
    for event, steps in zip(events, between_events(part), strict=True):
        above, below = facts_apart(problem, steps)
        runs.append(_run_of(part.label, event, above))
        if below:
            runs.append(replace(_run_of(part.label, None, below), below=True))
    named = named_letters(problem)
    lets = tuple(
        one
        for run in runs
        for one in run.lets
        if not has_quantity(one.expression) and not letters(one.expression) & named
    )
    unknown = tuple(one for run in runs for one in run.unknown)
    runs = [
        replace(run, lets=tuple(one for one in run.lets if one not in lets), unknown=())
        for run in runs
    ]
    first = next((n for n, run in enumerate(runs) if run.asks), len(runs) - 1)
    runs[first] = replace(runs[first], lets=(*lets, *runs[first].lets), unknown=unknown)
    numbered = sum(len(run.asks) for run in runs) > 1
    return [replace(run, numbered=numbered) for run in runs]


def _run_of(label: str | None, event: Event | None, steps: Sequence[Step]) -> _Run:
    return _Run(
        event,
        label,
        tuple(step for step in steps if isinstance(step, Let)),
        tuple(one for step in steps if isinstance(step, Given) for one in step.relations),
        tuple(one for step in steps if isinstance(step, Unknown) for one in step.letters),
        tuple(step for step in steps if isinstance(step, Find | Show)),
    )


def _run(scene: Scene, now: int, run: _Run, lets: frozenset[str]) -> tuple[int, list[Block]]:
    """An event, then what is named, given and asked before the next."""
    sentences: list[Sentence] = []
    if run.event is not None:
        now += 1
        hit, *more = event_sentences(scene, now)
        sentences += [hit, *(start(scene) if _event_first(scene) else ()), *more]
    scene = scene.at(now)
    for let in run.lets:
        named = formulas.noun_phrase(scene, let.expression).words()
        sentences.append(sentence("let ", lay.letter(let.letter), " denote ", named))
    if run.unknown:
        sentences.append(_not_known(run))
    given = [
        relation
        for relation in run.relations
        if run.label is not None
        or run.below
        or not is_letter_fact(relation)
        or letters_of(relation) & lets
    ]
    asked = _asked(scene, run)
    if asked is not None and given and (asked.lead or len(asked.entries) == 1):
        under = _under(scene, given, asked)
        if under is not None:
            asked, given = under, []
    motion = [relation for relation in given if not is_letter_fact(relation)]
    sentences += [_statement(phrase) for phrase in clauses(scene, motion)]
    if len(motion) < len(given):
        clauses_ = [clause(scene, relation) for relation in given if is_letter_fact(relation)]
        sentences.append(sentence("it is given that ", listed(clauses_)))
    blocks: list[Block] = [Paragraph(tuple(sentences))] if sentences else []
    if asked is not None:
        blocks.append(asked)
    return now, blocks


def _statement(phrase: Words) -> Sentence:
    """A clause as a sentence, which does not begin with mathematics."""
    first = phrase[0]
    return sentence("" if isinstance(first, str | Emphasis) else "it is given that ", phrase)


def _under(scene: Scene, given: Sequence[Relation], asked: Listing) -> Listing | None:
    """What is asked with what is given for it: ``Given that k = 3, find …``; None if too long."""
    motion = clauses(scene, [relation for relation in given if not is_letter_fact(relation)])
    of_letters = [clause(scene, relation) for relation in given if is_letter_fact(relation)]
    phrases = [
        *of_letters,
        *(words("that ", phrase) if n or of_letters else phrase for n, phrase in enumerate(motion)),
    ]
    lead = words("Given that ", listed(phrases), ", ")
    longest = max(number_of_words(entry.words) for entry in asked.entries)
    if number_of_words(lead) + longest > _MOST_TOGETHER:
        return None
    if asked.lead:
        return replace(asked, lead=words(lead, _lower(asked.lead)))
    (only,) = asked.entries
    return replace(asked, entries=(replace(only, words=words(lead, _lower(only.words))),))


def _lower(phrase: Words) -> Words:
    """Words that no longer begin a sentence."""
    first = phrase[0]
    if isinstance(first, str):
        return (first[:1].lower() + first[1:], *phrase[1:])
    return phrase


def _not_known(run: _Run) -> Sentence:
    where = "in this part " if run.label is not None else ""
    unknown = [lay.letter(name) for name in run.unknown]
    verb = "value of {} is" if len(unknown) == 1 else "values of {} are"
    front, back = verb.split("{}")
    return sentence(where, "the ", front, listed(unknown), back, " not known")


# --- asking ---------------------------------------------------------------------------------------

# How many words may stand in one sentence, where it can be made two.
_MOST_WORDS = 42
_MOST_TOGETHER = 55


def _asked(scene: Scene, run: _Run) -> Listing | None:
    asks = run.asks
    if not asks:
        return None
    if all(isinstance(ask, Find) and not ask.in_terms_of for ask in asks):
        items = [one for ask in asks if isinstance(ask, Find) for one in groups(scene, ask)]
        together = len(items) <= 2 and len(_sentences(items)) == 1
        if len(items) == 1 or (together and not run.numbered):
            return Listing((), (_entry(items),))
        return _listed(("Find",), items)
    if len(asks) == 1:
        (only,) = asks
        if isinstance(only, Show):
            return Listing((), (Entry("", sentence(shown(scene, only))),))
        items = groups(scene, only)
        if len(items) > 2 or len(_sentences(items)) > 1:
            return _listed(words("Find, ", in_terms(only), ","), items)
    entries: list[Entry] = []
    for ask in asks:
        if isinstance(ask, Show):
            entries.append(Entry("", sentence(shown(scene, ask))))
        elif run.numbered and not ask.in_terms_of:
            entries += [_entry([item], in_terms(ask)) for item in groups(scene, ask)]
        else:
            parts = _sentences(groups(scene, ask))
            entries += [_entry(items, in_terms(ask)) for items in parts]
    return Listing((), tuple(entries))


def _listed(lead: Words, items: Sequence[Group]) -> Listing:
    """Each group of items as an entry of its own behind words in front of all."""
    return Listing(lead, tuple(Entry("", item.words, item.items) for item in items))


def _entry(items: Sequence[Group], terms: Words = ()) -> Entry:
    """Groups of items asked in one sentence."""
    clause_ = _find_clause([item.words for item in items], terms)
    return Entry("", sentence(clause_), sum(item.items for item in items))


def _sentences(items: Sequence[Group]) -> list[list[Group]]:
    """Items as they can stand together in a sentence; one with a clause of its own is alone."""
    out: list[list[Group]] = []
    room = 0
    for item in items:
        alone = len(items) > 1 and _has_clause(item.words)
        size = _MOST_WORDS if alone else number_of_words(item.words)
        if not out or size > room:
            out.append([])
            room = _MOST_WORDS
        out[-1].append(item)
        room -= size
    return out


def _has_clause(item: Words) -> bool:
    return any(
        isinstance(word, str) and (", where " in word or ", and the corr" in word) for word in item
    )


def _find_clause(items: Sequence[Words], terms: Words) -> Words:
    if not terms:
        return words("find ", listed(items))
    if len(items) == 1:
        comma = "," if len(items[0]) > 1 else ""
        return words("find ", items[0], comma, " ", terms)
    return words("find ", listed(items), ", each ", terms)


# --- facts and axes -------------------------------------------------------------------------------


def _with_facts(scene: Scene, drafts: Sequence[_Draft]) -> list[_Draft]:
    """The facts about letters told in the sentences of all parts."""
    paragraphs = [
        block
        for draft in drafts
        for block in (Paragraph(draft.opening), *draft.rest)
        if isinstance(block, Paragraph)
    ]
    retold, left = facts.with_facts(
        [one for paragraph in paragraphs for one in paragraph.sentences], facts.facts_of(scene)
    )
    sentences = iter(retold)
    out = [_retold(draft, sentences) for draft in drafts]
    if left:
        extra = sentence("it is given that ", listed([fact.words for fact in left]))
        out[0] = replace(out[0], opening=(*out[0].opening, extra))
    return out


def _retold(draft: _Draft, sentences: Iterator[Sentence]) -> _Draft:
    """A part with its sentences taken from others, one by one."""
    opening = tuple(islice(sentences, len(draft.opening)))
    rest = tuple(
        Paragraph(tuple(islice(sentences, len(block.sentences))))
        if isinstance(block, Paragraph)
        else block
        for block in draft.rest
    )
    return replace(draft, opening=opening, rest=rest)


# Words of which nobody knows what they mean for **j** who is not told how it lies.
_TURNING = ("clockwise", "to the left of", "to the right of", "on the left", "on the right")


def _with_axes(scene: Scene, drafts: Sequence[_Draft]) -> tuple[Sentence, ...]:
    """The opening, with **i** and **j** and coordinates explained where they are used."""
    opening = drafts[0].opening
    blocks = [draft.blocks for draft in drafts]
    i, j = lay.Bold("i"), lay.Bold("j")
    points = _contains(blocks, lambda x: isinstance(x, lay.Coordinates) or _has(x, "coordinates"))
    axes: list[Sentence] = []
    if points or _contains(blocks, lambda x: x in (i, j)):
        turning = _contains(blocks, lambda x: any(_has(x, sign) for sign in _TURNING))
        sense = (", with ", j, " at 90° anticlockwise from ", i) if turning else ()
        axes.append(
            sentence("perpendicular unit vectors ", i, " and ", j, " lie in the plane", sense)
        )
    if points:
        metres = ", in metres," if scene.style.fixes(LENGTH) else ""
        axes_words = f"the coordinates of points{metres} are referred to axes in the directions of "
        axes.append(sentence(axes_words, i, " and ", j))
    end = _bodies_end(scene)
    return (*opening[:end], *axes, *opening[end:])


def _has(value: Any, text: str) -> bool:
    return isinstance(value, str) and text in value


def _bodies_end(scene: Scene) -> int:
    """After how many sentences all spheres have been introduced."""
    return len(list(spheres(scene)))


def _contains(value: Any, wanted: Any) -> bool:
    if wanted(value):
        return True
    if isinstance(value, tuple | list):
        return any(_contains(part, wanted) for part in value)
    if is_dataclass(value) and not isinstance(value, type):
        return any(_contains(getattr(value, field.name), wanted) for field in fields(value))
    return False
