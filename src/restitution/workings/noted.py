"""Notes in words: why an item has no answer, and why a claim is not true."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import groupby

from restitution.explaining.lines.derivation import (
    Derivation,
    Link,
    Note,
    Ref,
    Relation,
    numbers_in,
)
from restitution.explaining.lines.notation import read_relation, read_tree
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.explaining.lines.trees import trees_of
from restitution.expression.quantities import ANGLES, LOSSES
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    has_root,
    is_binary,
    is_quantity,
    letters,
    walk,
)
from restitution.problem import Arrival, Extremum, Impact, Kick, Problem, Range, Show, Value
from restitution.render import layout as lay
from restitution.shapes import Line
from restitution.solving.equations.coefficients import COEFFICIENTS
from restitution.solving.story.letters import roles
from restitution.workings.naming.ends import Ends
from restitution.workings.naming.facts import fact_in_words
from restitution.workings.naming.measured import as_answer, number_carried, worth
from restitution.workings.naming.quantities import Naming
from restitution.workings.reasons.no_root import reason_of_no_root

# These notes are of one item each.
_ALONE = frozenset({"unbounded", "refuted", "undecided", "unwritten", "standing", "agreeing"})


# What is said of a component with acute angles in it that has the other sense.
_OF_SENSE: Mapping[bool, SentenceId] = {False: "note.against-sense", True: "note.against-opposite"}


def _is_negative(value: Expression) -> bool:
    """Whether a product begins with a minus sign."""
    return isinstance(value, Negate) or (isinstance(value, Binary) and _is_negative(value.left))


def _has_an_open_direction(problem: Problem) -> bool:
    """Whether neither the coefficient nor the direction of the one impact is given."""
    steps = [step for _, step in problem.steps() if isinstance(step, Arrival | Impact | Kick)]
    match steps:
        case [Impact(_, struck, e, along, offset)] if e is None or isinstance(e, Letter):
            walls = [wall for wall in problem.walls if wall.name == struck]
            straight = all(wall.shape == Line(None, wall.through) for wall in walls)
            return straight and along is None and offset is None
    return False


class Notes:
    """The notes of one working, and where they stand among its lines."""

    def __init__(
        self,
        derivation: Derivation,
        naming: Naming,
        ends: Ends,
        figures: Callable[[Link], Link],
    ) -> None:
        self._derivation = derivation
        self._naming = naming
        self._ends = ends
        self._figures = figures
        self._all = derivation.notes
        self._order = {item: n for n, item in enumerate(derivation.asked)}

    def of_part(self, label: str | None) -> list[Note]:
        """The notes of a part, in the order asked; why none can have an answer once for all."""
        own = [note for note in self._derivation.notes if note.part == label]
        clashes: set[object] = set()
        kept = []
        for note in sorted(own, key=lambda note: note.place):
            clash = note.reason, note.lines
            if note.lines and (note.kind == "contradiction" or self._is_out_of_range(note)):
                if clash in clashes:
                    continue
                clashes.add(clash)
            kept.append(note)
        return kept

    def alike(self, note: Note) -> list[str]:
        """The items of a part of which a note is said once for all."""
        reason = note.part, note.kind, note.reason, note.premises
        if note.kind != "contradiction" and not self._is_out_of_range(note):
            return []
        return [
            other.item
            for other in self._all
            if note.lines and (other.part, other.kind, other.reason, other.premises) == reason
        ]

    def places(self, label: str | None, items: Sequence[str | None]) -> dict[int, list[Note]]:
        """The notes of a part by the number of its lines above them.

        A note stands below the lines of its item, and of those asked before it.
        """
        places: dict[int, list[Note]] = {}
        for note in self.of_part(label):
            before = [
                n
                for n, item in enumerate(items, 1)
                if item is not None and self._order[item] <= self._order[note.item]
            ]
            places.setdefault(max(before, default=0), []).append(note)
        return places

    def sentences(self, notes: Sequence[Note]) -> Iterator[tuple[list[Note], Sentence]]:
        """Notes in words; those with one reason in one sentence."""

        def reason(note: Note) -> object:
            own = note.item if note.kind in _ALONE else None
            ends = note.kind != "missing" and self._ends_in(note)
            # That something cannot be shown is one sentence, that a value cannot be found another.
            shown = not note.premises and isinstance(self._ends.item(note.item), Show)
            return note.kind, note.reason, note.premises, ends, own, shown

        for _, group in groupby(notes, reason):
            own = list(group)
            yield own, self._of_several(own)

    def _of_several(self, notes: Sequence[Note]) -> Sentence:
        (first, *_) = notes
        items = self._items(notes)
        if first.kind in ("refuted", "undecided"):
            from restitution.workings.refuted import claim_of, refutation

        if first.kind == "refuted":
            return refutation(first, self._derivation, self._naming, self._ends)
        if first.kind == "undecided":
            return say("undecided.claim", claim=claim_of(first, self._naming, self._ends))
        if first.kind == "agreeing":
            return say("given.agrees", fact=self._given_fact(first))
        if first.kind == "standing":
            line = self._derivation.line(max(first.lines))
            label = None if line is None else self._ends.part(line)
            return say("carried.part", label=label) if label else say("carried.above")
        if first.kind == "unbounded":
            item = self._ends.item(first.item)
            assert isinstance(item, Extremum)
            extreme = self._naming.extreme(item.expression, greatest=item.kind == "maximum")
            return say("note.unbounded", extreme=extreme, reason=first.reason)
        if first.kind == "unwritten" and first.claim is not None:
            return say("note.unwritten-line-from" if first.premises else "note.unwritten-line")
        if cases_of(first):
            name = "note.unwritten-cases-from" if first.premises else "note.unwritten-cases"
            return say(name, item=self._in_words(first))
        if first.kind == "unwritten":
            name = "note.unwritten-from" if first.premises else "note.unwritten"
            return say(name, item=self._in_words(first), answer=first.reason)
        if first.kind == "unsolved":
            return say("note.unsolved", items=items, reason=first.reason)
        if first.kind == "impossible" and first.premises:
            return self._impossible(first, items)
        shown = isinstance(self._ends.item(first.item), Show)
        if shown:
            return say("note.none-shown", items=items, reason=first.reason)
        if first.kind == "contradiction":
            return self._against(first) if first.lines else say("note.clash", reason=first.reason)
        if first.kind == "impossible":
            return say("note.impossible", reason=first.reason)
        if first.premises:
            return say("note.idle", fact=self._given_fact(first), items=items)
        fact = self._fact_of_two(first)
        if fact is not None:
            return say("note.none-of-two", items=items, reason=first.reason, fact=fact)
        return say("note.none", items=items, reason=first.reason)

    def _fact_of_two(self, note: Note) -> Sentence | lay.Layout | None:
        """The one fact that is given of a letter and of a direction that is not given either."""
        item = self._ends.item(note.item)
        if not isinstance(item, Value) or not isinstance(item.expression, Letter):
            return None
        if note.kind != "missing" or not _has_an_open_direction(self._naming.problem):
            return None
        facts = [
            fact
            for fact in self._derivation.facts
            if fact.kind == "given"
            and fact.part in (None, note.part)
            and fact.relation.options[0][0].sign == "="
        ]
        return fact_in_words(self._naming, facts[0]) if len(facts) == 1 else None

    def _given_fact(self, note: Note) -> Sentence | lay.Layout:
        """The given fact among the premises of a note."""
        facts = self._derivation.facts_in(note.premises)
        fact = next(fact for fact in facts if fact.kind == "given")
        return fact_in_words(self._naming, fact)

    def _against(self, note: Note) -> Sentence:
        """A fact that the lines of a note contradict."""
        known = [str(ref).partition(":") for ref in note.premises]
        angles = [text.strip() for head, _, text in known if head == "acute"]
        if not angles:
            return say("note.against", fact=note.reason)
        reasons = (say("derived.acute", angle=self._naming.layout(Letter(e))) for e in angles)
        value = self._relation(note.lines[-1]).only[-1].right
        facts = self._derivation.facts_in(note.premises)
        of_a_direction = any(
            isinstance(left := fact.relation.options[0][0].left, Quantity) and left.kind in ANGLES
            for fact in facts
        )
        return say(
            _OF_SENSE[_is_negative(value)] if of_a_direction else "note.against-zero",
            value=self._naming.layout(value),
            reasons=tuple(reasons),
            fact=note.reason,
        )

    def _items(self, notes: Sequence[Note]) -> Sentence:
        """What was asked, in the words of the question."""
        names = dict.fromkeys(map(self._in_words, notes))
        return say("derived.items", items=tuple(names))

    def _in_words(self, note: Note) -> Sentence | lay.Layout | str:
        """An item in words, and not as it was typed."""
        return self._item_in_words(note.item)

    def _item_in_words(self, name: str) -> Sentence | lay.Layout | str:
        match self._ends.item(name):
            case Extremum(kind, expression):
                extreme = self._naming.extreme(expression, greatest=kind == "maximum")
                return say("derived.the", quantity=extreme)
        return self._ends.named(name)

    def _impossible(self, note: Note, items: Sentence) -> Sentence:
        """The value of a coefficient, and the bound that it breaks; what any other letter is."""
        if note.claim is not None:
            ahead = self._ahead(note.claim)
            if ahead is not None:
                return say("note.unreached-ahead", reason=note.reason, **ahead)
            side, unreached = self._side(note.claim), self._unreached(note)
            return unreached if side is None else say("note.on-its-side", **side, then=unreached)
        value, *bounds = note.premises
        relation = self._relation(value)
        if self._is_out_of_range(note):
            line = self._derivation.line(max(note.lines))
            label = None if line is None else self._ends.part(line)
            if label != note.part:
                own = [fact for e in bounds if (fact := self._derivation.fact(str(e))) is not None]
                if label is not None and any(fact.part == note.part for fact in own):
                    reasons = tuple(self._known(bounds).values())
                    own_value = self._naming.relation(relation)
                    return say(
                        "note.beyond-there", label=label, relation=own_value, reasons=reasons
                    )
                if label is None:
                    return say("note.impossible-above")
                return say("note.impossible-there", label=label)
            subject = relation.options[0][0].left
            if isinstance(subject, Letter):
                return self._out_of_range(subject, bounds, note.part)
            return self._without_a_root(relation, bounds)
        bound = bounds[0]
        left, right = _bounded(relation, self._bounds_of(bound))
        over = "<=" in str(bound)
        if not letters(right) and 0 <= worth(right) <= 1:
            # That is the value of a case that this part excludes.
            return say("note.none-value", items=items, letter=self._naming.layout(left))
        links = [self._figures(Link(left, "=", right))]
        if has_root(right) and any(is_binary(node, "+", "-") for node in walk(right)):
            links = [_rounded_beyond(links[0], int(over))]
        if letters(right):
            links.append(Link(right, ">" if over else "<", Number(Fraction(int(over)))))
        equation = self._naming.relation(Relation((tuple(links),)))
        if self._ends_in(note):
            name = "note.above-one" if over else "note.below-zero"
            return say(name, value=equation, letter=self._naming.layout(left))
        if any(other.premises == note.premises and self._ends_in(other) for other in self._all):
            item = self._ends.item(note.item)
            if isinstance(item, Range) and item.expression == left:
                return say("note.none-of-it", letter=self._naming.layout(left))
            shown = isinstance(item, Show)
            if shown:
                return say("note.none-shown-either", items=items)
            if any(self._goes_on(own) for own in self._all if own.premises == note.premises):
                # Something else could be worked out, though there is no such impact either.
                trees = walk(item.expression) if isinstance(item, Value) else ()
                gained = over and any(is_quantity(node, *LOSSES) for node in trees)
                reason: SentenceId = "note.none-lost" if gained else "note.none-without"
                return say(reason, items=items, letter=self._naming.layout(left))
            return say("note.none-either", items=items)
        if isinstance(value, int):
            name = "note.none-above-one" if over else "note.none-below-zero"
            return say(name, items=items, value=equation)
        name = "note.none-data-above-one" if over else "note.none-data-below-zero"
        return say(name, items=items, value=self._naming.layout(right))

    def onward(self, note: Note) -> Iterator[Sentence]:
        """What is said of the lines below a note of a value that a coefficient cannot have."""
        if note.kind != "impossible" or not note.premises or note.claim is not None:
            return
        if self._is_out_of_range(note) or not (self._ends_in(note) and self._goes_on(note)):
            return
        value, bound, *_ = note.premises
        left, _ = _bounded(self._relation(value), self._bounds_of(bound))
        item = self._answered_below(note)
        if self._rests(note):
            yield say("note.rests-on", item=item)
        else:
            yield say("note.goes-on", letter=self._naming.layout(left), item=item)

    def _answered_below(self, note: Note) -> Sentence | lay.Layout | str:
        """The one item of the part that is worked out below a note, in words; or all of them."""
        last = max(note.lines, default=0)
        ends = (end for end in self._derivation.items if end.line > last and end.part == note.part)
        match list(dict.fromkeys(end.item for end in ends)):
            case [item]:
                return self._item_in_words(item)
        return say("note.other-answers")

    def _ahead(self, claim: Relation) -> Mapping[str, str | lay.Layout] | None:
        """Which of two spheres that do not approach is ahead, as the other moves towards it.

        None at a wall, and where an earlier impact of the two tells how they are placed.
        """
        match claim.only:
            case (Link(Quantity(), "<" | ">" as sign, _) as link,):
                assert isinstance(link.left, Quantity)
                axis = link.left.arguments[-1]
            case _:
                return None
        nodes = (node for side in (link.left, link.right) for node in walk(side))
        velocities = [e for e in nodes if is_quantity(e, "velocity")]
        pair = [velocity.arguments[0] for velocity in velocities]
        names = tuple(tree.name for tree in pair if isinstance(tree, Name))
        if len(names) != 2 or any(self._naming.bodies.get(name) != "sphere" for name in names):
            return None
        stage = max((e.stage for e in velocities if isinstance(e.stage, int)), default=0)
        before = (event for n, event in self._naming.events.items() if n <= stage)
        if any(set(event.bodies) == set(names) for event in before):
            return None
        one, other = names
        direction = self._naming.layout(axis if sign == ">" else Negate(axis))
        return {"one": one, "other": other, "way": direction}

    def _side(self, claim: Relation) -> Mapping[str, str | lay.Layout] | None:
        """On which side of a wall a body is that would have to come to it.

        None where it left the wall earlier, between two spheres, and where no side is named.
        """
        match claim.only:
            case (
                Link(Quantity(_, (Quantity("velocity", (Name(body),), int(stage)), axis)), sign),
            ):
                impact = self._naming.events.get(stage + 1)
            case _:
                return None
        before = [event for n, event in self._naming.events.items() if n <= stage]
        if impact is None or not impact.wall or sign not in (">", "<"):
            return None
        if any(event.bodies == impact.bodies for event in before):
            return None
        away = Negate(axis) if sign == ">" else axis
        return {"body": body, "wall": impact.bodies[1], "way": self._naming.layout(away)}

    def _unreached(self, note: Note) -> Sentence:
        """Why two bodies do not meet: by the line just above, or by one further up, said again."""
        cited = numbers_in(note.premises)
        last = self._derivation.lines[-1].number if self._derivation.lines else 0
        if not cited or max(cited) == last:
            return say("note.unreached", reason=note.reason)
        links = self._relation(max(cited)).only
        left, right = links[0].left, links[-1].right
        exact = [side for side, sign in as_answer(right) if sign == "="]
        sides = (self._naming.layout(left), exact[-1] if exact else self._naming.layout(right))
        value = lay.Relation(sides, (links[-1].sign,))
        return say("note.unreached-as", value=value, reason=note.reason)

    @staticmethod
    def _is_out_of_range(note: Note) -> bool:
        """Whether a letter has only values that it cannot have; a coefficient alone has its own."""
        return note.kind == "impossible" and note.reason != COEFFICIENTS

    def _out_of_range(
        self, subject: Expression, bounds: Sequence[Ref], part: str | None
    ) -> Sentence:
        """What is known of a letter that has only values that it cannot have."""
        about = self._known(bounds)
        if subject not in about:
            given = [
                fact.id
                for fact in self._derivation.facts
                if fact.kind == "range" and fact.id.partition(" ")[0] == "given"
                if fact.part in (None, part) and len(fact.relation.options) == 1
                if {node for tree in trees_of(fact.relation) for node in walk(tree)} & {subject}
            ]
            about = {subject: self._positive(subject), **about, **self._known(given)}
        return say("note.out-of-range", reasons=tuple(about.values()))

    def _without_a_root(self, relation: Relation, bounds: Sequence[Ref]) -> Sentence:
        """What is known of the letters of an equation that none of their values satisfy."""
        own = reason_of_no_root(relation, self._naming)
        if own is not None:
            return say("note.no-root", reasons=(own,))
        about = self._known(bounds)
        known = roles(self._naming.problem)
        for node in (node for tree in trees_of(relation) for node in walk(tree)):
            if not isinstance(node, Letter) or node in about:
                continue
            if node.name in known and known[node.name].kind == "positive":
                about[node] = self._positive(node)
        if not about:
            return say("note.no-solution")
        return say("note.no-root", reasons=tuple(about.values()))

    def _positive(self, letter: Expression) -> Sentence:
        if isinstance(letter, Letter) and roles(self._naming.problem)[letter.name].kind == "angle":
            return say("derived.acute", angle=self._naming.layout(letter))
        return say("derived.positive", letter=self._naming.layout(letter))

    def _known(self, bounds: Sequence[Ref]) -> dict[Expression, Sentence | lay.Layout]:
        """What bounds say, by the letter of which they say it."""
        about: dict[Expression, Sentence | lay.Layout] = {}
        for text in map(str, bounds):
            head, _, rest = text.partition(":")
            if head == "acute":
                angle = read_tree(rest, self._naming.bodies)
                about[angle] = say("derived.acute", angle=self._naming.layout(angle))
                continue
            fact = self._derivation.fact(text)
            relation = read_relation(text, self._naming.bodies) if fact is None else fact.relation
            letter = next(
                e for tree in trees_of(relation) for e in walk(tree) if isinstance(e, Letter)
            )
            about[letter] = self._naming.relation(relation)
        return about

    def _bounds_of(self, bound: Ref) -> set[Expression]:
        """The letters of which a bound speaks."""
        trees = trees_of(read_relation(str(bound), self._naming.bodies))
        return {node for tree in trees for node in walk(tree) if isinstance(node, Letter)}

    def _ends_in(self, note: Note) -> bool:
        """Whether a note is of the item that its lines are about."""
        line = self._derivation.line(max(note.lines, default=0))
        return line is not None and line.item == note.item

    def _goes_on(self, note: Note) -> bool:
        """Whether lines of other items of the part stand below those of a note."""
        last = max(note.lines, default=0)
        return any(
            line.number > last and line.shown != "silent" and self._ends.part(line) == note.part
            for line in self._derivation.lines
        )

    def _rests(self, note: Note) -> bool:
        """Whether lines below those of a note rest on the value that it is about."""
        resting = {note.premises[0]}
        for line in self._derivation.lines:
            if resting & set(line.premises):
                resting.add(line.number)
        last = max(note.lines, default=0)
        return any(isinstance(ref, int) and ref > last for ref in resting)

    def _relation(self, ref: Ref) -> Relation:
        own = self._derivation.cited(ref)
        assert own is not None
        assert isinstance(own.relation, Relation)
        return own.relation


def _rounded_beyond(link: Link, end: int) -> Link:
    """A value with roots in it to three figures, where these are beyond an end, 0 or 1, too."""
    if letters(link.right):
        return link
    number = number_carried(worth(link.right), 3)
    beyond = number is not None and (number > 1 if end else number < 0)
    if number is None or not beyond:
        return link
    size = Number(abs(number))
    return replace(link, sign="≈", right=Negate(size) if number < 0 else size)


def _bounded(relation: Relation, bounded: Collection[Expression]) -> tuple[Expression, Expression]:
    """What a bound is about, and its value: of several values that a line gives the own one."""
    links = relation.only
    own = [n for n, link in enumerate(links) if link.left in bounded]
    first = last = own[0] if own else 0
    while last + 1 < len(links) and (not own or links[last + 1].left == links[last].right):
        last += 1
    return links[first].left, links[last].right


def cases_of(note: Note) -> tuple[str, ...]:
    """The forms of an answer whose steps are not written out, each with its condition."""
    cases = tuple(note.reason.split("; "))
    return cases if note.kind == "unwritten" and note.claim is None and len(cases) > 1 else ()
