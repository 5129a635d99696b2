"""Lines in the order in which they are read: the story in its order, what belongs together as one.

The working is written as it is needed; a reader wants the letters of an impact in one sentence, its
components before the laws, and the first impact before the second. A line moves only within its
part and its case, and never above what it rests on.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import replace

from restitution.explaining.data.offset_angles import letter_of_offset
from restitution.explaining.lines.derivation import (
    Derivation,
    ItemEnd,
    Line,
    Link,
    Meaning,
    Note,
    Ref,
    Relation,
)
from restitution.explaining.lines.trees import trees_of
from restitution.expression.quantities import KINDS
from restitution.expression.tree import (
    AtTime,
    Letter,
    Name,
    Quantity,
    Unit,
    has_quantity,
    letters,
    walk,
)

_LAWS = frozenset({"unchanged", "momentum", "restitution", "restitution-wall"})
_ENERGIES = frozenset({"energy", "total"})
_LOSSES = frozenset({"energy-lost", "total-lost"})
# So many lines stand between a letter and its use where it is introduced too early.
_TOGETHER = 2
# Lines that belong to the impact of which they speak, and go where its others are.
_OF_AN_IMPACT = _LAWS | {"component", "impulse-vector", "straight-line", "chord"}


def gathered(derivation: Derivation) -> Derivation:
    """The same working in the order of the story, with what belongs together in one place."""
    return _with_standing(_Gathering(_in_pairs(_where_needed(_by_items(derivation)))).whole())


def _by_items(derivation: Derivation) -> Derivation:
    """The same working, in which an item is finished before the next one is begun.

    What is given below both may have been put into each at the end. The working is as it was where
    the end of one item rests on lines of a later one.
    """
    items = {item: n for n, item in enumerate(derivation.asked)}
    order = sorted(derivation.lines, key=lambda line: items.get(line.item or "", len(items)))
    if derivation.cases or order == list(derivation.lines):
        return derivation
    written: set[int] = set()
    for line in order:
        if any(isinstance(ref, int) and ref not in written for ref in line.premises):
            return derivation
        written.add(line.number)
    return numbered_anew(derivation, order)


def _with_standing(derivation: Derivation) -> Derivation:
    """The same working with a note for each answer to which an earlier part came already."""
    parts = derivation.asked
    order = list(parts)
    standing: dict[str, list[ItemEnd]] = {}
    for end in derivation.items:
        line = derivation.line(end.line)
        if line is None or line.item not in parts or end.case is not None:
            continue
        if parts[line.item or ""] != end.part:
            standing.setdefault(end.item, []).append(end)
    notes = [
        Note(
            item,
            "standing",
            order.index(item),
            ends[0].part,
            premises=tuple(end.line for end in ends),
            claim=Relation(tuple(dict.fromkeys(o for end in ends for o in end.answer.options))),
        )
        for item, ends in standing.items()
    ]
    return replace(derivation, notes=(*derivation.notes, *notes)) if notes else derivation


def _where_needed(derivation: Derivation) -> Derivation:
    """The same working, in which what was written on the way stands where it is first used.

    That is another ratio of an angle, a bound of letters, an impulse, the line of centres that one
    tells, or a component, which may have been written for its sign; and whatever no item of its own
    part rests on.
    """
    parts = derivation.asked
    items = {part: n for n, part in enumerate(parts)}
    used = _first_ends(derivation)
    lines: list[Line] = []
    held, fixed = derivation.held, _fixed_lines(derivation)
    for line in reversed(derivation.lines):
        item = used.get(line.number, line.item)
        elsewhere = {item, line.item} <= items.keys() and parts[item or ""] != parts[
            line.item or ""
        ]
        moves = (
            line.number not in (fixed if elsewhere else held)
            and {item, line.item} <= items.keys()
            and (
                elsewhere
                or line.move.id in ("triangle", "sign")
                or line.move.record == "component"
                or _is_a_component_put_in(derivation, line)
                or _is_an_impulse_or_the_axis(line)
            )
            and items[item or ""] > items[line.item or ""]
        )
        own = line
        if moves:
            premises = _cited_in(derivation, line.premises, parts[item or ""])
            own = replace(line, item=item, premises=premises)
        lines.insert(0, own)
        for ref in own.premises:
            if isinstance(ref, int) and own.item in items:
                first = used.get(ref)
                if first is None or items.get(first, 0) > items[own.item or ""]:
                    used[ref] = own.item or ""
    if lines == list(derivation.lines):
        return derivation
    last = len(items)
    lines.sort(key=lambda line: items.get(line.item or "", last))
    return numbered_anew(derivation, lines)


def _is_a_component_put_in(derivation: Derivation, line: Line) -> bool:
    """Whether a line only puts values into a component of a velocity, or into its letter."""
    subject = _subject(line)
    if isinstance(subject, Letter) and subject.name in derivation.meanings:
        subject = derivation.meanings[subject.name].quantity
    match line.relation, subject:
        case Relation(((Link(_, "="),),)), Quantity("along" | "across", (Quantity("velocity"), _)):
            return line.move.id == "put"
    return False


def _is_an_impulse_or_the_axis(line: Line) -> bool:
    """Whether a line says what an impulse is, or to what the line of centres is parallel."""
    match line.relation:
        case Relation(((Link(Quantity("impulse", (_, *_)), "="), *_),)):
            return True
        case Relation(((Link(Quantity("line_of_centres"), "parallel to", _),),)):
            return True
    return False


def _first_ends(derivation: Derivation) -> dict[int, str]:
    """The first item that ends at a line, by the numbers of such lines."""
    items = {item: n for n, item in enumerate(derivation.asked)}
    first: dict[int, str] = {}
    for end in derivation.items:
        known = first.get(end.line)
        if end.item in items and (known is None or items[known] > items[end.item]):
            first[end.line] = end.item
    return first


def _fixed_lines(derivation: Derivation) -> frozenset[int]:
    """The lines of cases, of notes and of ends in a case, none of which goes to another part."""
    return frozenset(
        (
            *(end.line for end in derivation.items if end.case is not None),
            *(number for case in derivation.cases for number in (case.line, *case.lines)),
            *(number for note in derivation.notes for number in note.lines),
        )
    )


def _cited_in(
    derivation: Derivation, premises: tuple[Ref, ...], part: str | None
) -> tuple[Ref, ...]:
    """What a line cites, in another part: a fact that is given there too, as it is given there."""
    own = {fact.relation: fact.id for fact in derivation.facts if fact.part == part}
    cited: list[Ref] = []
    for ref in premises:
        fact = derivation.fact(ref)
        elsewhere = fact is not None and fact.part not in (None, part)
        cited.append(own.get(fact.relation, ref) if fact is not None and elsewhere else ref)
    return tuple(cited)


def _in_pairs(derivation: Derivation) -> Derivation:
    """The same working, in which both components after an impact are solved in one place.

    The second one may be needed only when the next impact has been told already.
    """
    parts = derivation.asked
    impacts: dict[str, int] = {}
    for letter, meaning in derivation.meanings.items():
        match meaning.quantity:
            case Quantity("along", (Quantity("velocity", _, int(stage)), _)):
                impacts[letter] = stage
    fixed = {number for case in derivation.cases for number in (case.line, *case.lines)}
    fixed |= {end.line for end in derivation.items}
    order = list(derivation.lines)
    for line in derivation.lines:
        event = impacts.get(_letter_solved(line) or "")
        if event is None or line.number in fixed:
            continue
        at = order.index(line)
        pair = next(
            (
                n
                for n in range(at - 1, -1, -1)
                if impacts.get(_letter_solved(order[n]) or "") == event
                and order[n].number not in fixed
                and parts.get(order[n].item or "", "") == parts.get(line.item or "", "-")
            ),
            None,
        )
        if pair is None:
            continue
        above = {line.number for line in order[: pair + 1]}
        stands = all(
            ref in above if isinstance(ref, int) else not ref.startswith("given ")
            for ref in line.premises
        )
        later = any((line.move.event or 0) > event for line in order[pair + 1 : at])
        if stands and later:
            order.insert(pair + 1, replace(order.pop(at), item=order[pair].item))
    return numbered_anew(derivation, order)


def _is_kept(line: Line) -> bool:
    """Whether a line says of a speed, or of an angle to a wall, that an impact does not change it.

    It rests on the coefficient of the impact, and on no component.
    """
    kept = line.move.id == "define" and line.move.record in ("speed", "difference")
    return kept and f"e {line.move.event}" in line.premises


def _is_a_time(line: Line) -> bool:
    """Whether a line gives the time of an impact by the data alone."""
    match line.relation:
        case Relation(((Link(Quantity("time", (), int(event)), "="), *_),)):
            return line.move.id == "define" and line.move.event == event
    return False


def _letter_solved(line: Line) -> str | None:
    """The letter of which a line gives the one value; None of another line."""
    if not isinstance(line.relation, Relation) or len(line.relation.options) != 1:
        return None
    links = line.relation.options[0]
    if any(link.sign != "=" for link in links) or not isinstance(links[0].left, Letter):
        return None
    return links[0].left.name


class _Gathering:
    """The lines of one derivation on their way to their places."""

    def __init__(self, derivation: Derivation) -> None:
        self._derivation = derivation
        self._parts = derivation.asked
        self._items = {part: n for n, part in enumerate(self._parts)}
        self._cases = {n: case.number for case in derivation.cases for n in case.lines}
        self._bodies = {event.number: event.bodies for event in derivation.events}
        self._ended = {end.line for end in derivation.items}
        self._order: list[Line] = []

    def whole(self) -> Derivation:
        """The derivation with its lines in order."""
        self._order = self._in_order_of_the_story(self._derivation.lines)
        for line in tuple(self._order):
            self._raise_to_its_event(line)
        for line in tuple(self._order):
            self._raise_a_speed(line)
        for kind in (self._letter, self._component, self._stays):
            for line in tuple(self._order):
                if line.item in self._parts:
                    self._raise(line, kind)
        for line in tuple(self._order):
            if line.move.id == "reject":
                self._raise_to_its_roots(line)
        for line in tuple(self._order):
            self._lower_to_its_use(line)
        for line in tuple(self._order):
            if line.move.id == "sign" and not any(isinstance(e, int) for e in line.premises):
                self._lower_to_the_line_on_it(line)
        for line in reversed(tuple(self._order)):
            if line.move.record in _ENERGIES:
                self._lower_to_the_energies(line)
        for line in tuple(self._order):
            if letter_of_offset(line) is not None:
                self._raise_to_the_start(line)
        for item in self._parts:
            self._raise_an_item(item)
        for item in self._parts:
            self._lower_an_item(item)
        return numbered_anew(self._derivation, self._order)

    # --- the order of the story -------------------------------------------------------------------

    def _in_order_of_the_story(self, lines: Sequence[Line]) -> list[Line]:
        """The lines of each item by the events that they need, each after what it rests on."""
        needs: dict[int, int] = {}
        latest: dict[Hashable, int] = {}
        ratios = {line.number for line in lines if self._is_for_components(line)}
        for line in lines:
            place = self._place(line)
            below = [needs.get(ref, 0) for ref in line.premises if isinstance(ref, int)]
            own = self._event(line)
            stays = line.move.id in ("define", "answer", "fact") and line.move.record != "assemble"
            if own is None and (stays or not below):
                # What speaks of no impact stays where it is.
                own = 0 if line.number in ratios else latest.get(place, 0)
            needs[line.number] = max([own or 0, *below])
            latest[place] = max(latest.get(place, 0), needs[line.number])
        last = len(self._items)

        def key(line: Line) -> tuple[int, int, int]:
            case = self._cases.get(line.number, 0)
            return self._items.get(line.item or "", last), case, needs[line.number]

        return sorted(lines, key=key) if self._is_sorted_by_items(lines) else list(lines)

    def _is_for_components(self, line: Line) -> bool:
        """Whether ratios of an angle of the data are only put into components of velocities."""
        users = [own for own in self._derivation.lines if line.number in own.premises]
        return line.move.id == "triangle" and all(
            _is_a_component_put_in(self._derivation, own) for own in users
        )

    def _is_sorted_by_items(self, lines: Sequence[Line]) -> bool:
        """Whether the items, and their cases, stand in order already, as they do but for ties."""
        last = len(self._items)
        keys = [
            (self._items.get(line.item or "", last), self._cases.get(line.number, 0))
            for line in lines
        ]
        return keys == sorted(keys)

    def _raise_to_its_event(self, line: Line) -> None:
        """Puts a law that a later item needs below the others of its impact, before the next one.

        So no item goes back to an impact that an item above has left. The time of an impact, and
        what a perfectly elastic wall leaves as it was, go with its laws.
        """
        goes = line.move.id == "law" or _is_a_time(line) or _is_kept(line)
        if not goes or line.item not in self._parts or line.number in self._ended:
            return
        order, at, event = self._order, self._order.index(line), self._event(line)
        near = [n for n in range(at) if self._place(order[n]) == self._place(line)]
        own = [n for n in near if self._event(order[n]) == event]
        if event is None or not own:
            return
        left = any((self._event(order[n]) or 0) > event for n in near if n > own[-1])
        place = own[-1] + 1
        # What an item has begun it goes on with, as far as that is about no later impact.
        while place < at and order[place].item == order[place - 1].item:
            if (self._event(order[place]) or order[place].move.event or 0) > event:
                break
            place += 1
        if left and self._may_stand(line, place):
            order.insert(place, replace(order.pop(at), item=order[own[-1]].item))

    def _raise_a_speed(self, line: Line) -> None:
        """Puts a speed that is asked after one impact before the lines of the next one."""
        event = line.move.event
        if (line.move.id, line.move.record) != ("define", "speed") or event is None:
            return
        if line.number not in self._ended:
            return
        order, at = self._order, self._order.index(line)
        later = (
            n
            for n in range(at)
            if self._place(order[n]) == self._place(line)
            and max(order[n].move.event or 0, self._event(order[n]) or 0) > event
        )
        to = next(later, at)
        if self._may_stand(line, to):
            order.insert(to, order.pop(at))

    def _raise_an_item(self, item: str) -> None:
        """Puts an item about one impact below the others of it, before the next one.

        So what is asked after the first impact stands under its heading.
        """
        order = self._order
        own = [line for line in order if line.item == item]
        events = {line.move.event or self._event(line) or 0 for line in own}
        ended = any(line.number in self._ended for line in own)
        if not ended or not max(events, default=0) or self._cases:
            return
        if self._still_holds(item, max(events)):
            return
        at = order.index(own[0])
        later = (
            n
            for n in range(at)
            if self._place(order[n]) == self._place(own[0])
            and max(order[n].move.event or 0, self._event(order[n]) or 0) > max(events)
        )
        to = next(later, at)
        written = {line.number for line in (*order[:to], *own)}
        if to < at and all(
            ref in written for line in own for ref in line.premises if isinstance(ref, int)
        ):
            left = [line for line in order[to:] if line.item != item]
            self._order = [*(line for line in order[:to]), *own, *left]

    def _lower_an_item(self, item: str) -> None:
        """Puts an end that needs no law of its impact below the laws of those before it.

        So a place at the second impact, which the data tell, stands under the heading of that.
        """
        order = self._order
        end = next(
            (line for line in order if line.item == item and line.number in self._ended), None
        )
        event = None if end is None else end.move.event
        if end is None or event is None or self._cases:
            return
        own = [line for line in order if line.item == item and line.move.event == event]
        at, numbers = order.index(own[0]), {line.number for line in own}
        to = at + len(own)
        if order[at:to] != own or any(
            line.move.id == "law" for line in order[:to] if line.move.event == event
        ):
            return
        near = [n for n in range(to, len(order)) if self._place(order[n]) == self._place(end)]
        below = next((n for n in near if (order[n].move.event or 0) >= event), to)
        between = order[to:below]
        earlier = any(line.move.id == "law" and line.move.record != "unchanged" for line in between)
        if earlier and not any(numbers.intersection(line.premises) for line in between):
            self._order = [*order[:at], *between, *own, *order[below:]]

    def _still_holds(self, item: str, event: int) -> bool:
        """Whether an item is about bodies that no later impact changes, or about a time."""
        end = next((end for end in self._derivation.items if end.item == item), None)
        if end is None:
            return True  # it has no answer, and stands where it says why
        subject = end.answer.options[0][0].left
        if isinstance(subject, Letter) and subject.name in self._derivation.meanings:
            subject = self._derivation.meanings[subject.name].quantity
        quantities = [node for node in walk(subject) if isinstance(node, Quantity)]
        if any(isinstance(quantity.stage, AtTime) for quantity in quantities):
            return True  # at a time that may be after any impact
        names = {node.name for node in walk(subject) if isinstance(node, Name)}
        later = {name for n, bodies in self._bodies.items() if n > event for name in bodies}
        of_an_event = any(KINDS[quantity.kind].of_an_event for quantity in quantities)
        return bool(names) and not of_an_event and not names & later

    @staticmethod
    def _event(line: Line) -> int | None:
        """The event to which a line belongs."""
        match line.relation:
            case Meaning(quantity=Quantity("along", (Quantity("velocity", _, int(stage)), _))):
                return stage
            case Relation(
                (
                    (
                        Link(
                            Quantity("along" | "across", (Quantity("velocity", _, int(stage)), _))
                        ),
                        *_,
                    ),
                )
            ) if line.move.id == "put":
                return stage or None
        if line.move.id in ("law", "define") and line.move.record in _OF_AN_IMPACT:
            return line.move.event
        return line.move.event if _is_kept(line) else None

    # --- what belongs together --------------------------------------------------------------------

    def _place(self, line: Line) -> Hashable:
        return self._parts.get(line.item or ""), self._cases.get(line.number)

    def _letter(self, line: Line) -> Hashable | None:
        """Letters of one impact."""
        match line.relation:
            case Meaning(quantity=Quantity("along", (Quantity("velocity", _, int(stage)), axis))):
                return "letter", stage, axis
        return None

    def _component(self, line: Line) -> Hashable | None:
        """Components at one time, in the directions of one impact."""
        if line.move.id != "define" or line.move.record != "component":
            return None
        subject = _subject(line)
        match subject:
            case Quantity("along" | "across" | "dot", (Quantity("velocity", _, int(stage)), _)):
                return "component", line.move.event, stage == line.move.event
        return None

    def _stays(self, line: Line) -> Hashable | None:
        """Components that an impact does not change, of which the line gives the value."""
        if line.move.id == "law" and line.move.record == "unchanged":
            if isinstance(line.relation, Relation) and has_quantity(line.relation.only[-1].right):
                return None  # what is to be shown stands where it is asked
            return "unchanged", line.move.event, isinstance(_subject(line), Quantity)
        return None

    def _raise(self, line: Line, kind: Callable[[Line], Hashable | None]) -> None:
        """Puts a line beside those of its kind, or before the laws of its impact."""
        own = kind(line)
        if own is None:
            return
        order, at = self._order, self._order.index(line)
        near = [n for n in range(at) if self._place(order[n]) == self._place(line)]
        alike = [n for n in near if kind(order[n]) == own]
        if alike:
            start = alike[0]
            end = next(n for n in range(start, at + 1) if n == at or kind(order[n]) != own)
            target = next(
                (n for n in range(start, end) if self._rank(line) < self._rank(order[n])), end
            )
        else:
            law = self._first_law(line, near)
            if law is None or (kind == self._component and not self._is_for_laws(line)):
                return
            target = law
        passed = order[target:at] if line.number in self._ended else ()
        if any(self._answers_earlier(other, line) for other in passed):
            return
        if target == at or not self._may_stand(line, target):
            return
        order.insert(target, order.pop(at))

    def _answers_earlier(self, other: Line, line: Line) -> bool:
        """Whether a line ends an item that is asked before that of another line."""
        own, later = (self._items.get(e.item or "", 0) for e in (other, line))
        return other.number in self._ended and own < later

    def _raise_to_its_roots(self, line: Line) -> None:
        """Puts the root that remains below the roots, where it is known already."""
        order, at = self._order, self._order.index(line)
        roots = [n for n in range(at) if order[n].number in line.premises[:1]]
        if roots and self._place(order[roots[0]]) == self._place(line):
            target = roots[0] + 1
            if target != at and self._may_stand(line, target):
                order.insert(target, order.pop(at))

    def _lower_to_the_line_on_it(self, line: Line) -> None:
        """Puts what is known of letters above the first line that rests on it, in its item."""
        order, at = self._order, self._order.index(line)
        users = [n for n, other in enumerate(order) if line.number in other.premises]
        if any(end.line == line.number for end in self._derivation.items) or not users:
            return
        own = order[users[0]]
        if own.item == line.item and self._place(own) == self._place(line) and users[0] > at + 1:
            order.insert(users[0] - 1, order.pop(at))

    def _lower_to_the_energies(self, line: Line) -> None:
        """Puts an energy above the others that are worked out with it, below what these need.

        So components that a later part puts in stand above all energies.
        """
        order, at = self._order, self._order.index(line)
        users = [n for n, other in enumerate(order) if line.number in other.premises]
        if line.number in self._ended or not users:
            return

        def is_beside(other: Line) -> bool:
            return other.item == line.item and self._place(other) == self._place(line)

        to = users[0]
        own = _ENERGIES | _LOSSES
        while to - 1 > at and order[to - 1].move.record in own and is_beside(order[to - 1]):
            to -= 1
        if to > at + 1 and is_beside(order[to]):
            order.insert(to - 1, order.pop(at))

    def _raise_to_the_start(self, line: Line) -> None:
        """Puts a line that rests on data alone, and the letters in it, at the start of its item."""
        order = self._order
        lets = [other for other in order if other.number in line.premises]
        start = next(n for n, other in enumerate(order) if other.item == line.item)
        for other in reversed((*lets, line)):
            order.remove(other)
            order.insert(start, other)

    def _lower_to_its_use(self, line: Line) -> None:
        """Puts the letter of an angle, or of a time, above the first line that has it.

        It may stand a line earlier, where letters are introduced together.
        """
        if not isinstance(line.relation, Meaning) or self._letter(line) is not None:
            return
        order, at = self._order, self._order.index(line)
        first = next((n for n in range(at + 1, len(order)) if _has(order[n], line)), at)
        between = [line for line in order[at + 1 : first] if isinstance(line.relation, Relation)]
        same = order[first].item == line.item and self._place(order[first]) == self._place(line)
        if len(between) >= _TOGETHER and same:
            order.insert(first - 1, order.pop(at))

    def _first_law(self, line: Line, near: Sequence[int]) -> int | None:
        """Where the laws of an impact begin above a line; those that stay may follow others."""
        if isinstance(line.relation, Meaning):
            return None
        for n in near:
            other = self._order[n]
            if self._is_later(other, line):
                return n
            impulse = other.move.record == "impulse" and line.move.record == "component"
            if other.move.id == "law" and (impulse or other.move.record in _LAWS):
                if other.move.event != line.move.event:
                    continue
                if other.move.record != "unchanged" or line.move.record == "component":
                    return n
        return None

    def _is_for_laws(self, line: Line) -> bool:
        """Whether a law of the impact of a component takes it, or one that it does not change."""
        return any(
            line.number in other.premises
            and other.move.id == "law"
            and other.move.event == line.move.event
            for other in self._order
        )

    def _is_later(self, line: Line, other: Line) -> bool:
        """Whether a component is that of an impact of which the other is one before it."""
        one, two = self._component(line), self._component(other)
        return (
            one is not None
            and two == ("component", other.move.event, False)
            and (one == ("component", other.move.event, True))
        )

    def _may_stand(self, line: Line, target: int) -> bool:
        written = {line.number for line in self._order[:target]}
        return all(ref in written for ref in line.premises if isinstance(ref, int))

    def _rank(self, line: Line) -> tuple[int, int]:
        """The bodies of an impact in their order, and along before across, **i** before **j**."""
        quantity = line.relation.quantity if isinstance(line.relation, Meaning) else _subject(line)
        match quantity:
            case Quantity(kind, (Quantity("velocity", (Name(body),), stage), axis)):
                event = stage if isinstance(line.relation, Meaning) else line.move.event
                bodies = self._bodies.get(event if isinstance(event, int) else 0, ())
                place = bodies.index(body) if body in bodies else len(bodies)
                return place, int(kind == "across" or axis == Unit("j"))
        return 0, 0


def _has(line: Line, let: Line) -> bool:
    """Whether a line has the letter that another introduces, or rests on it."""
    if let.number in line.premises:
        return True
    assert isinstance(let.relation, Meaning)
    if isinstance(line.relation, Meaning):
        return let.relation.letter in letters(line.relation.quantity)
    return any(let.relation.letter in letters(tree) for tree in trees_of(line.relation))


def _subject(line: Line) -> object:
    return line.relation.options[0][0].left if isinstance(line.relation, Relation) else None


def numbered_anew(derivation: Derivation, order: list[Line]) -> Derivation:
    """A working of these of its lines, in this order, with all that refers to them."""
    numbers = {line.number: n for n, line in enumerate(order, 1)}
    of_cases = {number for case in derivation.cases for number in case.lines}
    unmoved = len(order) == len(derivation.lines) and all(n == e for e, n in numbers.items())
    if unmoved and of_cases <= numbers.keys():  # nothing that refers to lines has to change
        same = all(a is b for a, b in zip(order, derivation.lines, strict=True))
        return derivation if same else replace(derivation, lines=tuple(order))

    def renumbered(line: Line) -> Line:
        premises = tuple(numbers[e] if isinstance(e, int) else e for e in line.premises)
        number = numbers[line.number]
        if number == line.number and premises == line.premises:
            return line
        return replace(line, number=number, premises=premises)

    return replace(
        derivation,
        lines=tuple(map(renumbered, order)),
        items=tuple(replace(item, line=numbers[item.line]) for item in derivation.items),
        notes=tuple(note.renumbered(numbers) for note in derivation.notes),
        cases=tuple(
            replace(
                case,
                line=numbers[case.line],
                lines=tuple(numbers[n] for n in case.lines if n in numbers),
            )
            for case in derivation.cases
        ),
    )
