"""What a working leads to: its items as they were asked, and the lines in which they end."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

import sympy as sp

from restitution.explaining.data.facts import staged
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Derivation,
    ItemEnd,
    Line,
    Link,
    Relation,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Quantity,
    has_quantity,
    is_function,
    is_quantity,
    is_zero,
    letters,
    quantities_in,
    walk,
)
from restitution.problem import (
    Aligned,
    Arrival,
    Find,
    Impact,
    Item,
    Kick,
    Meets,
    Problem,
    Show,
    Value,
)
from restitution.render import layout as lay
from restitution.render.document import Emphasis, Typed
from restitution.solving.story.letters import roles
from restitution.vector import Vector
from restitution.wording.asking import names_of
from restitution.wording.scene import scene_of
from restitution.wording.structure import Words
from restitution.wording.telling import numbers_of_items
from restitution.workings.naming.quantities import Naming

_VECTOR = Pair(Number(Fraction(2)), Number(Fraction(3)))

_ALIGNED = {
    "perpendicular to": "claim.perpendicular",
    "parallel to": "claim.parallel",
    "in the direction of": "claim.same-direction",
    "opposite to": "claim.opposite",
}


class Ends:
    """The items of one derivation, and the lines in which they end."""

    def __init__(self, derivation: Derivation, problem: Problem, naming: Naming) -> None:
        self._naming = naming
        self._problem = problem
        self._named: dict[str, Words] | None = None
        self._ends: dict[int, list[ItemEnd]] = {}
        for end in _ends(derivation):
            self._ends.setdefault(end.line, []).append(end)
        self._parts = derivation.asked
        self._numbers = _numbers(derivation, problem)
        self._facts = derivation.facts
        self._places = {
            item: [e for e in self._parts if self._parts[e] == self._parts[item]].index(item)
            for item in self._parts
        }
        asked = [question for _, step in problem.steps() for question in _asked(step)]
        self._events = dict(zip(self._parts, _events_above(problem), strict=False))
        self._asked: Mapping[str, Item | Show] = (
            dict(zip(self._parts, asked, strict=True)) if len(asked) == len(self._parts) else {}
        )
        self._in_letters = dict(self._answers_in_letters(derivation))

    def part(self, line: Line) -> str | None:
        """The label of the part to which a line belongs."""
        return self._parts.get(line.item or "")

    def place(self, line: Line) -> int | None:
        """Which item of its part a line belongs to, counted from 0."""
        return self.place_of(line.item)

    def place_of(self, item: str | None) -> int | None:
        """Which of its part an item is, counted from 0."""
        return self._places.get(item or "")

    def label(self, line: Line, said_again: Collection[str] = ()) -> str:
        """The numbers in the question of the items that end in a line: ``"(i)"``.

        Those that are said again below have their numbers there, as those that a sentence below
        another item ends, and those asked in terms of letters where these still stand.
        """
        elsewhere = {*said_again, *self._ended_below(line)}
        own = [e.item for e in self._at(line) if e.item not in elsewhere]
        early = [item for item, number in self._in_letters.items() if number == line.number]
        return self._label([*early, *(item for item in own if item not in self._in_letters)])

    def label_of_claims(self, line: Line) -> str:
        """The numbers of the items that the sentences below a line end: ``"(ii)"``."""
        below = self._ended_below(line)
        return self._label(below) if below else self.label(line)

    def _ended_below(self, line: Line) -> list[str]:
        """The items of a line that ends another one, of which a sentence below says the claim."""
        claimed = [end.item for end in self._at(line) if end.shown and self._claim(end) is not None]
        return claimed if len(claimed) < len(self._at(line)) else []

    def _answers_in_letters(self, derivation: Derivation) -> Iterator[tuple[str, int]]:
        """The lines above the ends of items in which they are in the letters that are asked.

        A fact further down has given these letters values since, or gives the answer itself.
        """
        every = [
            frozenset(step.in_terms_of or ()) if isinstance(step, Find) else frozenset[str]()
            for _, step in self._problem.steps()
            for _ in _asked(step)
        ]
        terms = dict(zip(self._asked, every, strict=False))
        for end in derivation.items:
            last = derivation.line(end.line)
            is_given = last is not None and last.shown == "silent"
            asked = terms.get(end.item)
            if not (asked or is_given) or end.shown or len(end.answer.options) != 1:
                continue
            left = letters(end.answer.only[-1].right)
            for line in derivation.lines:
                match line.relation:
                    case Relation(((Link(subject, "="), *_) as links,)) if (
                        subject == end.answer.only[0].left and line.number < end.line
                    ):
                        names = letters(links[-1].right)
                        wanted = left < names and (is_given or names <= (asked or frozenset()))
                        if wanted and not has_quantity(links[-1].right):
                            yield end.item, line.number
                            break

    def label_of(self, *items: str | None) -> str:
        """The numbers of items in the question, in brackets; empty where they have none."""
        return self._label([item or "" for item in items])

    def _label(self, items: Sequence[str]) -> str:
        numbers = dict.fromkeys(self._numbers.get(item, "") for item in items)
        return ", ".join(f"({number})" for number in numbers if number)

    def of(self, line: Line) -> ItemEnd | None:
        """The end of an item in a line; None where none ends.

        Of what is found and shown in one line that of what is found.
        """
        ends = self._ends.get(line.number)
        return min(ends, key=lambda end: end.shown) if ends else None

    def again(self, label: str | None, lines: Sequence[Line]) -> dict[int, list[ItemEnd]]:
        """The ends of items that an earlier item has answered, by the number of lines above them.

        ``lines`` are those of the part. Where nothing stands between both items the answer is not
        said again.
        """
        order = {item: n for n, item in enumerate(self._parts)}
        numbers = [line.number for line in lines]
        places: dict[int, list[ItemEnd]] = {}
        for ends in self._ends.values():
            first, *others = sorted(ends, key=lambda end: order[end.item])
            for end in others:
                if end.part != label or end.shown or first.shown or end.line not in numbers:
                    continue
                last = max(
                    n
                    for n, line in enumerate(lines, 1)
                    if line.item is not None
                    and order[first.item] <= order[line.item] <= order[end.item]
                )
                apart = last > numbers.index(end.line) + 1
                if apart and end.answer == first.answer and end not in places.get(last, ()):
                    places.setdefault(last, []).append(end)
        return places

    def is_required(self, line: Line) -> bool:
        """Whether a line is, as it stands, what was to be shown in its part."""
        return any(
            end.shown and self._parts.get(end.item) == self.part(line)
            for end in self._at(line)
            if self._claim(end) is None
        )

    def _at(self, line: Line) -> Sequence[ItemEnd]:
        return self._ends.get(line.number, ())

    def asked(self, line: Line) -> Item | Show | None:
        """What was asked, in the line that ends it."""
        end = self.of(line)
        return None if end is None else self._asked.get(end.item)

    def typed(self, line: Line, link: Link) -> lay.Layout | None:
        """The right side of what was to be shown as it was typed, in the line that says it."""
        for end in self._at(line):
            match end.answer.options:
                case ((own,),) if end.shown and (own.left, own.sign) == (link.left, link.sign):
                    asked = self._asked.get(end.item)
                    text = "" if asked is None else asked.text.rstrip()
                    if isinstance(own.right, Number) and text.endswith("%"):
                        return lay.Percent(self._naming.as_typed(Number(100 * own.right.value)))
                    return self._naming.as_typed(own.right)
        return None

    def item(self, name: str) -> Item | Show | None:
        """An item by its name in the working."""
        return self._asked.get(name)

    def events_before(self, name: str) -> int:
        """How many events are told before an item."""
        asked = self.item(name)
        return next((e for step, e, _ in self._problem.timeline() if step is asked), 0)

    def text(self, item: str) -> str:
        """An item as it was typed."""
        known = self._asked.get(item)
        return known.text if known is not None and known.text else item

    def named(self, item: str) -> lay.Layout | str:
        """An item in the words of the question; as it was typed where it has none."""
        if self._named is None:
            self._named = {}
            scene, events = scene_of(self._problem), 0
            spoken: list[Words] = []
            for _, step in self._problem.steps():
                events += isinstance(step, Impact | Kick | Arrival)
                if isinstance(step, Find | Show):
                    spoken += names_of(scene.at(events), step)
            if len(spoken) == len(self._parts):
                self._named = dict(zip(self._parts, spoken, strict=True))
        words = self._named.get(item)
        return self.text(item) if words is None else _operand(words)

    def is_place(self, line: Line) -> bool:
        """Whether it is a place that was asked."""
        match self.asked(line):
            case Value(expression=Quantity("position", _, _)):
                return True
        return False

    def claims(self, line: Line) -> Iterator[Sentence]:
        """What was to be shown, where a line only says by what it holds."""
        claims = (self._claim(end) for end in self._at(line) if end.shown)
        yield from dict.fromkeys(claim for claim in claims if claim is not None)

    def _claim(self, end: ItemEnd) -> Sentence | None:
        """That bodies will meet, or how two velocities stand to each other that are in a ratio."""
        asked = self._asked.get(end.item)
        match asked.relation if isinstance(asked, Show) else None:
            case Meets() as relation:
                return claim_of_meeting(relation, self._naming)
            case Aligned(_, "perpendicular to" as how) if end.answer.only[0].sign == "=":
                product = end.answer.only[0].left  # which is zero
                assert isinstance(product, Quantity)
                one, two = map(self._side, product.arguments)
                return say(_ALIGNED[how], left=one, right=two)
            case Aligned(_, how, other) if end.answer.only[0].sign == "=":
                link = end.answer.only[0]
                own = list(quantities_in(link.right))
                known = next(iter(own), other)
                if own and isinstance(other, Negate):
                    known = Negate(own[0])
                left, right = map(self._side, (link.left, known))
                claim = say(_ALIGNED[how], left=left, right=right)
                positive = self._given_positive(link.right)
                if how in ("in the direction of", "opposite to") and positive is not None:
                    return say("claim.as", claim=claim, reason=self._naming.relation(positive))
                acute = self._acute_in(link.right)
                if how in ("in the direction of", "opposite to") and acute is not None:
                    angle = say("derived.acute", angle=self._naming.layout(acute))
                    return say("claim.as", claim=claim, reason=angle)
                if how in ("in the direction of", "opposite to"):
                    rest = self._perhaps_at_rest(link)
                    if rest is not None:
                        body, letter, value = rest
                        moving = self._given_apart(end.item, letter, value)
                        if moving is not None:
                            reason = self._naming.relation(moving)
                            return say("claim.as", claim=claim, reason=reason)
                        return say("claim.unless-at-rest", claim=claim, body=body)
                return claim
            case Aligned(left, how, right) if end.answer.only[0].sign in FLIPPED:
                # The sign of a component says it, of the velocity that the line is about.
                events = self._events[end.item]
                left, right = (
                    self._side(staged(self._problem, tree, events)) for tree in (left, right)
                )
                return say(_ALIGNED[how], left=left, right=right)
        return None

    def _given_positive(self, multiple: Expression) -> Relation | None:
        """That a letter of a multiple is positive, where that is given: so the sense is certain."""
        for fact in self._facts:
            match fact.relation.options:
                case ((Link(Letter(name), ">", right),),) if is_zero(right):
                    if fact.kind in ("given", "range") and name in letters(multiple):
                        return fact.relation
        return None

    def _given_apart(self, item: str, name: str, value: int) -> Relation | None:
        """The given bound by which a coefficient is not 0, or not 1, in the part of an item."""
        for fact in self._facts:
            match fact.relation.options:
                case ((Link(Letter(own), "<" | ">" | "!=" as sign, Number(bound)),),):
                    pass
                case _:
                    continue
            if fact.kind not in ("given", "range") or own != name:
                continue
            below, above = sign == "<" and bound <= value, sign == ">" and bound >= value
            in_force = fact.part in (None, self._parts.get(item))
            if in_force and (below or above or (sign == "!=" and bound == value)):
                return fact.relation
        return None

    def _perhaps_at_rest(self, link: Link) -> tuple[str, str, int] | None:
        """The body whose velocity is a multiple that a coefficient of 0 or 1 makes zero.

        With it stand that coefficient and its value.
        """
        if not is_quantity(link.left, "velocity"):
            return None
        known = roles(self._problem)
        # A velocity stands for any vector that is not zero.
        multiple = rebuilt(link.right, lambda tree: _VECTOR if isinstance(tree, Quantity) else tree)
        value = in_letters(multiple)
        for symbol in sorted(value.x.free_symbols, key=str) if isinstance(value, Vector) else ():
            if symbol.name in known and known[symbol.name].kind == "restitution":
                rest = next((end for end in (0, 1) if value.x.subs(symbol, end) == 0), None)
                body = next((n.name for n in link.left.arguments if isinstance(n, Name)), None)
                if rest is not None and body is not None:
                    return body, symbol.name, rest
        return None

    def _acute_in(self, multiple: Expression) -> Letter | None:
        """The one acute angle of which ratios are factors of a multiple, whose sign they tell."""
        known = roles(self._problem)
        angles = {
            node.argument for node in walk(multiple) if is_function(node, "sin", "cos", "tan")
        }
        match tuple(angles):
            case (Letter(name) as angle,) if name in known:
                own = known[name]
                return angle if (own.kind, own.low, own.high) == ("angle", 0, sp.pi / 2) else None
        return None

    def _side(self, tree: Expression) -> Sentence | lay.Layout | str:
        """A direction or a vector; words have their article."""
        side = self._naming.side(tree)
        words = isinstance(side, lay.Words | lay.Phrase)
        return say("derived.the", quantity=side) if words else side


def _operand(words: Words) -> lay.Layout | str:
    """Words of a question as an operand."""
    pieces = [word.text if isinstance(word, Emphasis | Typed) else word for word in words]
    if all(isinstance(piece, str) for piece in pieces):
        return "".join(map(str, pieces))
    if len(pieces) == 1:
        return pieces[0]
    return lay.Phrase(tuple(lay.Words(e) if isinstance(e, str) else e for e in pieces), "")


def claim_of_meeting(relation: Meets, naming: Naming) -> Sentence:
    """That two bodies will meet, or that they will not."""
    one, other = relation.first.name, relation.second.name
    again = say("again") if relation.again else ""
    if naming.bodies.get(other) == "wall":
        if relation.happens:
            return say("claim.will-hit", body=one, wall=other, again=again)
        return say("claim.will-not-hit", body=one, wall=other, again=again)
    if relation.happens:
        return say("claim.will-collide", one=one, other=other, again=again)
    return say("claim.will-not-collide", one=one, other=other, again=again)


def _ends(derivation: Derivation) -> Iterator[ItemEnd]:
    """The last lines of items, also of one of which the value is impossible."""
    yield from derivation.items
    items = Counter(max(note.lines, default=0) for note in derivation.notes)
    for note in derivation.notes:
        line = derivation.line(max(note.lines, default=0))
        if note.kind != "impossible" or note.claim is not None:
            continue  # with a claim it is a value by the way
        if line is not None and line.item == note.item:
            assert isinstance(line.relation, Relation)
            if items[line.number] > 1 and isinstance(line.relation.options[0][0].left, Quantity):
                continue  # how a body moves: several items fail by it, and it is the value of none
            yield ItemEnd(note.item, line.number, line.relation, note.part)


def _numbers(derivation: Derivation, problem: Problem) -> dict[str, str]:
    """The numbers that the items have in the question."""
    numbers = [n for own in numbers_of_items(problem).values() for n in own]
    if len(numbers) != len(derivation.asked):
        return {}
    return dict(zip(derivation.asked, numbers, strict=True))


def _events_above(problem: Problem) -> Iterator[int]:
    """How many events are told above each thing that is asked."""
    events = 0
    for _, step in problem.steps():
        events += isinstance(step, Impact | Kick | Arrival)
        yield from (events for _ in _asked(step))


def _asked(step: Any) -> Iterator[Item | Show]:
    if isinstance(step, Find):
        yield from step.items
    elif isinstance(step, Show):
        yield step
