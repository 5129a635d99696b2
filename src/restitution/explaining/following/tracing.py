"""Lines from anyone: which law, definition or move gives a line from what stands above it.

The moves are run backwards. Every candidate is first tried in numbers: at a point at which the
candidate holds, the line has to hold. What passes is checked exactly, by the follower's own rules.
The answer may be that nothing was recognised; that never makes a line false.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import combinations, pairwise, permutations
from typing import Literal

from restitution.explaining.data.setting import Cited, Known, is_direction
from restitution.explaining.following.settled import settled_derivation
from restitution.explaining.following.trials import known_of_letters, setting_of
from restitution.explaining.laws.principles import RECORDS, Record
from restitution.explaining.lines.derivation import (
    Derivation,
    Link,
    Meaning,
    Move,
    MoveId,
    Ref,
    Relation,
    equality,
    whole_of,
)
from restitution.explaining.lines.quotients import (
    NotComparableError,
)
from restitution.explaining.lines.trees import trees_of
from restitution.explaining.moves import MOST_COMPARED, follows, records_of
from restitution.explaining.steps.samples_of_lines import NEAREST, Levels, Numbers
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Apply,
    Expression,
    Letter,
    Name,
    Polar,
    Quantity,
    children,
    is_quantity,
    walk,
)
from restitution.expression.writing import write_expression
from restitution.oracle import Oracle
from restitution.records import dataclass

_NEAR = 4
"""So many lines above are tried with moves that are dear to try."""


_SIZES = ("speed", "size", "energy", "energy-ratio", "total", "total-lost", "energy-lost")


_ANGLES = (
    "tan",
    "tan-direction",
    "tan-deflection",
    "tan-from-axis",
    "tan-squared",
    "scalar-angle",
    "sum",
)


_PLACES = ("difference", "momentum-of", "distance", "straight-line", "perpendicular", "parallel")


_GROUPS = (
    tuple(name for name, record in RECORDS.items() if record.kind == "principle"),
    _ANGLES,
    _SIZES,
    _PLACES,
)
"""Records by what they speak of: a group has generators of its own, of which there are not many."""


@dataclass(frozen=True)
class Trace:
    """What gives a line: one move, a composition of two, or nothing that was recognised."""

    kind: Literal["move", "composition", "unrecognised"]
    moves: tuple[Move, ...] = ()
    premises: tuple[Ref, ...] = ()

    @property
    def move(self) -> Move | None:
        """The move, or the first of a composition."""
        return self.moves[0] if self.moves else None


UNRECOGNISED = Trace("unrecognised")


def explain_line(relation: Relation, above: Derivation, oracle: Oracle) -> Trace:
    """The move that gives a relation from the facts and lines of a derivation.

    The lines above need neither moves nor premises; letters are introduced by theirs. For many
    lines of one working a `Tracer` is quicker.
    """
    tracer = Tracer(replace(above, lines=()), oracle)
    for line in above.lines:
        tracer.add(line.number, line.relation)
    return tracer.trace(relation)


class Tracer:
    """Recognises the lines of a working, one after another, under the facts of a statement."""

    def __init__(self, statement: Derivation, oracle: Oracle) -> None:
        self.statement = settled_derivation(statement)
        self.setting = setting_of(self.statement, oracle)
        self.facts = [Cited(fact.id, fact.relation) for fact in self.statement.facts]
        self.lines: list[Cited] = []
        self.lets: list[Cited] = []
        self._angles: set[Expression] = set()
        self._numbers: list[Numbers] | None = None
        for premise in (*self.facts, *self.lets):
            self._speak_of(premise.relation)

    def _speak_of(self, relation: Relation | Meaning) -> None:
        """Takes note of the angles that a line names: laws of others are left aside."""
        new = {
            self.setting.quantity(node)
            for tree in trees_of(relation)
            for node in walk(tree)
            if isinstance(node, Quantity) and self.setting.of_angle(node) is not None
        }
        if not new <= self._angles:
            self._angles |= new
            self._numbers = None

    def add(self, number: int, relation: Relation | Meaning) -> None:
        """Takes up a line: those that come can rest on it."""
        self._speak_of(relation)
        if isinstance(relation, Meaning):
            quantity = self.setting.quantity(relation.quantity)
            meaning = replace(relation, quantity=quantity)
            self.lets.append(Cited(number, meaning))
            meanings = {**self.setting.meanings, meaning.letter: meaning}
            self.setting = replace(self.setting, meanings=meanings)
            self._numbers = None
            return
        cited = Cited(number, self._settled(relation))
        self.lines.append(cited)
        if self._directs(cited):
            self._numbers = None
        for numbers in self._numbers or ():
            numbers.add(cited)

    @property
    def numbers(self) -> list[Numbers]:
        """Everything that a line may come from, in numbers: event by event, the latest first."""
        if self._numbers is None:
            events = [event.number for event in reversed(self.statement.events)] or [0]
            self._numbers = [Numbers(self, number, group) for group in _GROUPS for number in events]
            for numbers in self._numbers:
                for line in self.lines:
                    numbers.add(line)
        return self._numbers

    def _directs(self, cited: Cited) -> bool:
        """Whether a line tells where a wall, an axis or an impulse points."""
        assert isinstance(cited.relation, Relation)
        return len(cited.relation.options) == 1 and any(
            link.sign in ("=", "parallel to") and is_direction(link.left, self.setting)
            for link in cited.relation.only
        )

    @property
    def directions(self) -> list[Cited]:
        """The lines that tell where something points."""
        return [line for line in self.lines if self._directs(line)]

    def _settled(self, relation: Relation) -> Relation:
        return Relation(
            tuple(tuple(self.setting.settled(link) for link in links) for links in relation.options)
        )

    # --- what is tried ---------------------------------------------------------------------------

    def trace(self, relation: Relation) -> Trace:
        """The move that gives a relation, or two of them, or none that was recognised."""
        relation = self._settled(relation)
        self._speak_of(relation)
        for attempt in self._attempts(relation):
            try:
                traced = attempt()
            except NotComparableError:
                continue
            if traced is not None:
                return traced
        return UNRECOGNISED

    def _attempts(self, relation: Relation) -> Iterator[Callable[[], Trace | None]]:
        signs = {link.sign for links in relation.options for link in links}
        if "≈" in signs:
            yield lambda: self._from_one(relation, ("value",))
            return
        if signs <= {"=", "parallel to", "perpendicular to"}:
            if len(relation.options) > 1:
                yield lambda: self._from_one(relation, ("roots", "put", "rearrange"))
                return
            yield lambda: self._chain(relation)
            yield lambda: self._fact(relation)
            yield lambda: self._from_one(relation, ("reject", "inverse"))
            if signs != {"="}:
                yield lambda: self._of_directions(relation)
                return
            yield lambda: self._resolved(relation)
            yield lambda: self._by_numbers(relation, self._from_single)
            yield lambda: self._from_one(relation, ("roots", "triangle", "identity"))
            yield lambda: self._by_numbers(relation, self._from_several)
            return
        yield lambda: self._from_one(relation, ("rearrange", "put"))
        yield lambda: self._inequality(relation)

    def _chain(self, relation: Relation) -> Trace | None:
        """A chain is what its first link is, if the others are moves of their own."""
        links = relation.only
        if len(links) < 2 or whole_of(links) is None:
            return None
        for before, link in pairwise(links):
            base = Cited(0, Relation(((Link(links[0].left, links[0].sign, before.right),),)))
            own = Relation(((Link(links[0].left, links[0].sign, link.right),),))
            if self._from_line(base, own) is None:
                return None
        first = self.trace(Relation(((links[0],),)))
        whole = equality(links[0].left, links[-1].right)
        return first if first.kind != "unrecognised" else self.trace(whole)

    def _fact(self, relation: Relation) -> Trace | None:
        for fact in self.facts:
            if isinstance(fact.relation, Relation):
                step = Step(self.setting, Move("fact"), (fact,), ())
                if _tried(step, relation):
                    return Trace("move", (Move("fact"),), (fact.ref,))
        return None

    def _of_directions(self, relation: Relation) -> Trace | None:
        """A line that tells where something points: from a line like it, or by a principle."""
        for cited in reversed(self.lines):
            step = Step(self.setting, Move("rearrange"), (cited,), ())
            if _tried(step, relation):
                return Trace("move", (step.move,), (cited.ref,))
        for event in reversed(self.statement.events):
            for move, law in self.laws_of(event.number):
                if law.sign == relation.only[0].sign:
                    traced = self._from_law(move, law, relation)
                    if traced is not None:
                        return traced
        return None

    def _resolved(self, relation: Relation) -> Trace | None:
        """A component by a vector, or a vector by its components."""
        (first, *rest) = relation.only
        quantity = first.left
        if isinstance(quantity, Letter):
            name = quantity.name
            named = (let.relation for let in self.lets if isinstance(let.relation, Meaning))
            quantity = next(
                (meaning.quantity for meaning in named if meaning.letter == name), quantity
            )
        if rest or not isinstance(quantity, Quantity):
            return None
        record = {"along": "component", "across": "component", "velocity": "assemble"}
        if quantity.kind not in record:
            return None
        cited = self._relevant([*quantity.arguments, quantity], relation, True)
        move = Move("define", record[quantity.kind])
        step = Step(self.setting, move, tuple(cited), ())
        if _tried(step, relation):
            return Trace("move", (move,), self._needed(step, relation))
        return None

    # --- laws, definitions, and lines above, by numbers ------------------------------------------

    def laws_of(self, number: int, names: Iterable[str] = RECORDS) -> Iterator[tuple[Move, Link]]:
        """What every record, or some, say of an event."""
        for event in self.statement.events:
            if event.number != number:
                continue
            for record in (RECORDS[name] for name in names):
                if record.kind == "identity" or not record.serves(event):
                    continue
                kind: MoveId = "law" if record.kind == "principle" else "define"
                for bodies in self._bodies(record, event.bodies):
                    move = Move(kind, record.id, event.number, bodies)
                    step = Step(self.setting, move, tuple(self.facts), ())
                    for link in records_of(step):
                        if self._speaks_of(link):
                            yield move, link

    def _speaks_of(self, link: Link) -> bool:
        """Whether lines name all angles in a law."""
        return all(
            node in self._angles
            for tree in (link.left, link.right)
            for node in walk(tree)
            if isinstance(node, Quantity) and self.setting.of_angle(node) is not None
        )

    def _bodies(self, record: Record, bodies: tuple[str, ...]) -> Iterable[tuple[str, ...]]:
        spheres = [body for body in bodies if self.setting.names.get(body) == "sphere"]
        both = any("Y" in _names(template) for template in record.templates)
        if not any(_names(template) for template in record.templates):
            return [tuple(spheres)]
        return permutations(spheres, 2) if both and len(spheres) > 1 else [(x,) for x in spheres]

    def _by_numbers(
        self, relation: Relation, attempt: Callable[[Numbers, Levels, Relation], Trace | None]
    ) -> Trace | None:
        if len(relation.only) != 1:
            return None
        for numbers in self.numbers:
            own = numbers.residual(relation.only[0])
            traced = None if own is None else attempt(numbers, own, relation)
            if traced is not None:
                return traced
        return None

    def _from_single(self, numbers: Numbers, own: Levels, relation: Relation) -> Trace | None:
        """One law, or one line above."""
        for source in numbers.single(own):
            traced = (
                self._from_law(source.move, source.link, relation)
                if source.move is not None
                else self._from_line(source.cited, relation)
            )
            if traced is not None:
                return traced
        return None

    def _from_several(self, numbers: Numbers, own: Levels, relation: Relation) -> Trace | None:
        """Two lines above, or a law together with a line: the latter is a composition."""
        for first, second in numbers.pairs(own):
            if first.move is None and second.move is None:
                traced = self._from_two(second.cited, first.cited, relation)
                if traced is not None:
                    return traced
            if numbers.follows_from_both(own, first, second):
                moves = tuple(source.move or Move("put") for source in (first, second))
                refs = tuple(e.cited.ref for e in (first, second) if e.move is None)
                return Trace("composition", moves, refs)
        return None

    def _from_law(self, move: Move, law: Link, relation: Relation) -> Trace | None:
        for with_axes in (True, False):
            cited = self._relevant([law.left, law.right], relation, with_axes)
            known = self._background(relation) if with_axes else ()
            if move.record in ("perpendicular", "parallel", "across-the-impulse"):
                cited += [x for x in self.facts if x not in cited and _is_tie(x)]
            for own in ((), known) if known else ((),):
                step = Step(self.setting, move, tuple(cited), own)
                if _tried(step, relation):
                    return Trace("move", (move,), self._needed(step, relation))
        return None

    def _relevant(
        self, trees: Sequence[Expression], relation: Relation, with_axes: bool
    ) -> list[Cited]:
        """What is known of the quantities in some trees, and is not left as it is in a line."""
        kept = set(_outermost(trees_of(relation)))
        chosen: list[Cited] = []
        pending = list(trees)
        seen: set[Expression] = set()
        every = [*self.lets, *reversed(self.lines), *self.facts]
        while pending:
            for node in _outermost([pending.pop()]):
                if node in seen:
                    continue
                seen.add(node)
                source = next((x for x in every if x not in chosen and _gives(x, node)), None)
                if source is not None and (
                    node not in kept or isinstance(source.relation, Meaning)
                ):
                    chosen.append(source)
                    pending.extend(_rights(source))
                    if isinstance(source.relation, Meaning):
                        pending.append(Letter(source.relation.letter))
                elif is_quantity(node, "line_of_centres") and with_axes:
                    assert isinstance(node, Quantity)
                    pending.extend(
                        let.relation.quantity
                        for let in self.lets
                        if isinstance(let.relation, Meaning)
                        and _is_impulse(let.relation.quantity, node.stage)
                    )
                    pending.extend(
                        Letter(let.relation.letter)
                        for let in self.lets
                        if isinstance(let.relation, Meaning)
                        and _is_impulse(let.relation.quantity, node.stage)
                    )
                elif isinstance(node, Quantity) and node not in kept:
                    pending.extend(node.arguments)
                    if node.kind == "velocity":
                        parts = [x for x in every if x not in chosen and _tells_of(x, node)]
                        chosen.extend(parts)
                        pending.extend(tree for part in parts for tree in _rights(part))
                        pending.extend(tree for part in parts for tree in _axes(part))
                    if not with_axes:
                        seen |= {x for x in node.arguments if is_quantity(x, "line_of_centres")}
                elif isinstance(node, Quantity) and with_axes:
                    pending.extend(x for x in node.arguments if is_quantity(x, "line_of_centres"))
        return chosen

    def _from_line(self, cited: Cited, relation: Relation) -> Trace | None:
        """A rearrangement of a line, or values put into it."""
        step = Step(self.setting, Move("rearrange"), (cited,), ())
        if _tried(step, relation):
            return Trace("move", (step.move,), (cited.ref,))
        assert isinstance(cited.relation, Relation)
        trees = list(trees_of(cited.relation))
        values = [
            premise for premise in self._relevant(trees, relation, True) if premise.ref != cited.ref
        ]
        step = Step(self.setting, Move("put"), (cited, *values), ())
        if values and _tried(step, relation):
            return Trace("move", (step.move,), self._needed(step, relation))
        known = self._background(relation)
        step = Step(self.setting, Move("cancel"), (cited, *self.lets), known)
        if known and _tried(step, relation):
            return Trace("move", (step.move,), self._needed(step, relation))
        return None

    def _from_two(self, first: Cited, second: Cited, relation: Relation) -> Trace | None:
        for move in (
            *(Move("combine", eliminated=unknown) for unknown in self._shared(first, second)),
            Move("combine"),
            Move("divide"),
            Move("square-add"),
        ):
            known = self._background(relation) if move.id == "divide" else ()
            for pair in ((first, second), (second, first)):
                step = Step(self.setting, move, pair, known)
                if _tried(step, relation):
                    return Trace("move", (move,), self._needed(step, relation))
                if move.id == "combine":
                    break
        return None

    def _shared(self, first: Cited, second: Cited) -> list[str]:
        """The letters and quantities that stand in two lines."""
        own = []
        for premise in (first, second):
            assert isinstance(premise.relation, Relation)
            own.append(
                {
                    node
                    for tree in trees_of(premise.relation)
                    for node in walk(tree)
                    if isinstance(node, Letter) or is_quantity(node, "along", "across", "speed")
                }
            )
        return sorted(write_expression(unknown) for unknown in own[0] & own[1])

    def _from_one(self, relation: Relation, ids: Sequence[str]) -> Trace | None:
        """A move of its own kind on one line above, the newest first."""
        known = self._background(relation)
        given = {fact.id for fact in self.statement.facts if fact.kind == "given"}
        near = [*reversed(self.lines), *(fact for fact in self.facts if fact.ref in given)]
        for cited in near if ids == ("reject", "inverse") else near[:_NEAR]:
            for name in ids:
                if not _may_be(name, relation, cited):
                    continue
                for record in _IDENTITIES if name == "identity" else (None,):
                    move = Move(name, record)  # type: ignore[arg-type]
                    extra = [] if name == "value" else self.lets
                    step = Step(self.setting, move, (cited, *extra), known)
                    if _tried(step, relation):
                        return Trace("move", (move,), self._needed(step, relation))
        return None

    def _inequality(self, relation: Relation) -> Trace | None:
        """An inequality by one line or fact, or by two, and what is known of letters."""
        sources = [*reversed(self.lines), *(fact for fact in self.facts if _compares(fact))]
        letters = {n.name for t in trees_of(relation) for n in walk(t) if isinstance(n, Letter)}
        near = [source for source in sources if _letters(source) & letters][:NEAREST]
        tries = [(premise,) for premise in near[:3]] + list(combinations(near[:3], 2))
        for chosen in tries:
            names = letters.union(*(_letters(premise) for premise in chosen))
            known = self._background_of(names)
            room = min(len(known), MOST_COMPARED - len(chosen))
            for own in combinations(known, room):
                step = Step(self.setting, Move("sign"), chosen, own)
                if _tried(step, relation):
                    return Trace("move", (step.move,), self._needed(step, relation))
        return None

    def _background(self, relation: Relation) -> tuple[Known, ...]:
        """What is known of the letters of a line: acute angles, coefficients up to 1."""
        names = {n.name for t in trees_of(relation) for n in walk(t) if isinstance(n, Letter)}
        for let in self.lets:
            if isinstance(let.relation, Meaning) and let.relation.letter in names:
                names |= _letters_of(let.relation.quantity)
        return self._background_of(names)

    def _background_of(self, names: Iterable[str]) -> tuple[Known, ...]:
        background = []
        for name in sorted(names):
            role = self.setting.roles.get(name)
            if role is None:
                continue
            texts = {"angle": (f"acute: {name}",), "restitution": (f"{name} >= 0", f"{name} <= 1")}
            for text in texts.get(role.kind, ()):
                known = known_of_letters(text, self.setting)
                if known is not None:
                    background.append(known)
        return tuple(background)

    def _needed(self, step: Step, relation: Relation) -> tuple[Ref, ...]:
        """The premises of a step without those that it does not need."""
        cited, known = list(step.cited), list(step.known)
        for premise in list(cited):
            fewer = tuple(x for x in cited if x is not premise)
            if _tried(step.under(cited=fewer, known=tuple(known)), relation):
                cited.remove(premise)
        for own in list(known):
            rest = tuple(x for x in known if x is not own)
            if _tried(step.under(cited=tuple(cited), known=rest), relation):
                known.remove(own)
        return (*(premise.ref for premise in cited), *(premise.ref for premise in known))


_IDENTITIES = ("pythagoras", "double-angle", "half-angle", "sum-of-angles", "complement")


def _tried(step: Step, relation: Relation) -> bool:
    try:
        return follows(step, relation)
    except NotComparableError:
        return False


def _may_be(name: str, relation: Relation, cited: Cited) -> bool:
    """Whether a line has the form that a move gives, before it is tried."""
    assert isinstance(cited.relation, Relation)
    links = [link for option in relation.options for link in option]
    if name == "reject":
        return len(cited.relation.options) > len(relation.options)
    if name in ("roots", "value"):
        return len(cited.relation.options) == 1
    if name in ("triangle", "inverse"):
        ratio = any(isinstance(x.left, Apply) for x in links)
        known = any(isinstance(x.left, Apply | Letter) for x in cited.relation.options[0])
        return len(cited.relation.options) == 1 and known and ratio == (name == "triangle")
    if name == "identity":
        return any(isinstance(n, Apply) for t in trees_of(cited.relation) for n in walk(t))
    return True


def _compares(cited: Cited) -> bool:
    return isinstance(cited.relation, Relation) and not any(
        isinstance(node, Name) for tree in trees_of(cited.relation) for node in walk(tree)
    )


def _letters(cited: Cited) -> set[str]:
    return {name for tree in trees_of(cited.relation) for name in _letters_of(tree)}


def _letters_of(tree: Expression) -> set[str]:
    return {node.name for node in walk(tree) if isinstance(node, Letter)}


def _rights(cited: Cited) -> list[Expression]:
    if isinstance(cited.relation, Meaning):
        return []
    return [link.right for link in cited.relation.only]


def _names(template: str) -> set[str]:
    return {letter for letter in ("X", "Y") if f"{letter}," in template or f"{letter})" in template}


def _outermost(trees: Iterable[Expression]) -> Iterator[Expression]:
    """The letters, quantities and walls in trees, not looking into quantities."""
    pending = list(trees)
    while pending:
        tree = pending.pop()
        if isinstance(tree, Letter | Quantity):
            yield tree
            continue
        if isinstance(tree, Apply):
            yield tree
        if isinstance(tree, Polar):
            yield from (Apply(ratio, tree.angle) for ratio in ("cos", "sin"))
        if isinstance(tree, Name):
            yield Quantity("direction", (tree,))
        else:
            pending.extend(children(tree))


def _gives(cited: Cited, node: Expression) -> bool:
    """Whether a line or a fact has a quantity for its left side."""
    if isinstance(cited.relation, Meaning):
        return cited.relation.quantity == node
    if len(cited.relation.options) != 1:
        return False
    return any(
        link.left == node and link.sign in ("=", "parallel to") for link in cited.relation.only
    )


def _tells_of(cited: Cited, velocity: Quantity) -> bool:
    """Whether a line or a fact gives a component, the size or an angle of a velocity."""
    if isinstance(cited.relation, Meaning):
        left, sign = cited.relation.quantity, "="
    elif len(cited.relation.options) == 1:
        left, sign = cited.relation.only[0].left, cited.relation.only[0].sign
    else:
        return False
    if sign != "=" or not isinstance(left, Quantity):
        return False
    if left.kind == "speed":
        return left.arguments == velocity.arguments and left.stage == velocity.stage
    return left.kind in ("along", "across", "angle") and left.arguments[0] == velocity


def _is_impulse(tree: Expression, stage: object) -> bool:
    return is_quantity(tree, "impulse") and bool(tree.arguments) and tree.stage == stage


def _axes(cited: Cited) -> list[Expression]:
    """The axes in the left side of a line."""
    left = (
        cited.relation.quantity
        if isinstance(cited.relation, Meaning)
        else cited.relation.only[0].left
    )
    return [node for node in walk(left) if is_quantity(node, "line_of_centres")]


def _is_tie(cited: Cited) -> bool:
    return isinstance(cited.relation, Relation) and any(
        link.sign in ("perpendicular to", "parallel to") or _is_right_angle(link)
        for links in cited.relation.options
        for link in links
    )


def _is_right_angle(link: Link) -> bool:
    return is_quantity(link.left, "deflection")
