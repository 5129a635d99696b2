"""The words that say where a line comes from: what was put in, and what was solved."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.data.restated import axis_restated
from restitution.explaining.lines.derivation import (
    Line,
    Link,
    Meaning,
    Move,
    Relation,
    equality,
)
from restitution.explaining.lines.notation import read_tree
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.explaining.lines.trees import trees_of
from restitution.expression.evaluate import in_letters
from restitution.expression.quantities import LOSSES
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Quantity,
    is_binary,
    is_zero,
    letters,
    walk,
)
from restitution.planning.writing.forms import total, tree_of
from restitution.render import layout as lay
from restitution.vector import Vector
from restitution.workings.leads.lines_around import LinesAround
from restitution.workings.leads.meetings import condition_of, passing_of, returning_of
from restitution.workings.naming.facts import fact_in_words, meeting_of
from restitution.workings.naming.quantities import with_article
from restitution.workings.naming.sources import Source, is_multiple
from restitution.workings.reasons.grounds import compared_quantities, motion_of

_RATIOS = ("cos", "sin", "tan")
# What is subtracted, by the kinds of both.
_DIFFERENCES: Mapping[tuple[str, str], SentenceId] = {
    ("energy", "energy"): "made.difference-of-energies",
    ("velocity", "velocity"): "made.difference-of-velocities",
}


def _is_left(line: Line) -> bool:
    """Whether a time between events is what is left of one from the start."""
    match line.relation:
        case Relation(((Link(Binary("-"), "=", Binary("-")), *_),)):
            return True
    return False


class SourceLeads(LinesAround):
    """The words before lines that come from others."""

    def _of_the_story(self, line: Line) -> Sentence | None:
        """What has to be for there to be such an impact, where that is what a line says."""
        for ref in line.premises:
            kind, _, number = ref.partition(" ") if isinstance(ref, str) else ("", "", "")
            if kind == "most":
                return say("given.most")
            if kind not in ("within", "approach", "offset"):
                continue
            if line.move.id == "reject":
                continue  # it is the reason, which stands behind what remains
            event = self._naming.events[int(number)]
            one, other = event.bodies
            if kind == "offset":
                return say("given.offset", one=one, other=other)
            if kind == "within":
                return say("given.between", body=one, wall=other)
            called = self._naming.called(event)
            if event.wall:
                unequal = isinstance(line.relation, Relation) and any(
                    link.sign == "!=" for links in line.relation.options for link in links
                )
                name: SentenceId = "given.not-along-wall" if unequal else "given.towards-wall"
                return say(name, body=one, wall=other, event=called)
            return say("given.approach", one=one, other=other, event=called)
        return None

    def _component_equations(self, line: Line) -> list[lay.Layout]:
        """The two equations that the momentum of two spheres as vectors says for one unknown."""
        laws = self._derivation.lines_in(line.premises)
        assert isinstance(line.relation, Relation)
        value = line.relation.only[0]
        if not isinstance(value.left, Letter) or letters(value.right):
            return []
        match laws:
            case [Line(move=Move(record="momentum-vector"), relation=Relation() as law)]:
                pass
            case _:
                return []
        try:
            left, right = (in_letters(side) for side in (law.only[0].left, law.only[-1].right))
        except RestitutionError:
            return []
        if not isinstance(left, Vector) or not isinstance(right, Vector):
            return []
        return [
            self._naming.relation(equality(_numbers_first(one), _numbers_first(other)))
            for one, other in zip(left, right, strict=True)
        ]

    def _source(self, source: Source, line: Line) -> Iterator[Sentence]:
        """What is said of where a line comes from: from which equations, and by what step."""
        equations = self._numbers(source)
        match source.kind:
            case "combine":
                letter = self._naming.layout(read_tree(source.eliminated, self._naming.bodies))
                yield say("derived.combine", letter=letter, equations=equations)
            case "compare" if not equations and (both := self._component_equations(line)):
                yield say("given.compare-both", first=both[0], second=both[1])
            case "compare" if not equations:
                yield say("given.compare")
            case "times":
                yield say("flight.subtract" if _is_left(line) else "flight.add")
            case "case":
                yield say("derived.since", facts=(self._of_its_case(line),))
            case "made":
                yield say(self._combination(line))
            case "formula":
                yield say("derived.formula")
            case "solve" if equations:
                yield say("derived.solve", equations=equations)
            case "solve":
                yield say("derived.solve-this")
            case "divide":
                first, second = equations
                yield say("derived.divide", first=first, second=second)
            case "square-add":
                yield say("derived.square-add", equations=equations)
            case "put" if not source.facts and is_multiple(line.relation):
                yield say("derived.multiple")
            case "put":
                yield from self._put(source, line, equations)
            case _:
                compared = compared_quantities(self._derivation, line)
                if compared is not None and equations:
                    self._given.add(compared.id)
                    words = fact_in_words(self._naming, compared)
                    yield say("given.fact-from", fact=words, equations=equations)
                elif equations:
                    yield say("derived.add", equations=equations)

    def _put(
        self, source: Source, line: Line, equations: tuple[Sentence, ...]
    ) -> Iterator[Sentence]:
        """Which facts and values a line puts in, and into which equations."""
        facts = tuple(self._fact(fact) for fact in self._as_stated(source.facts))
        self._given |= {*source.facts}
        letters = self._letters_put(source, line)
        is_claim = any(isinstance(e, Sentence) and e.topic == "claim" for e in facts)
        moves = self._moves(source.facts)
        put = bool(letters) and not source.last
        if not facts and (ratios := self._equal_ratios(line)) is not None:
            yield say("derived.since", facts=(ratios,))
        elif facts and facts[0] == self._written(line):
            yield say("given.data")
        elif len(facts) == 1 and is_claim:
            yield self._meeting(source.facts[0], line) or say("given.fact", fact=facts[0])
        elif moves is not None and not equations:
            body, direction, moving = moves
            if put:
                yield say(
                    "derived.moves-put", body=body, way=direction, fact=moving, letters=letters
                )
            else:
                yield say("derived.moves", body=body, way=direction, fact=moving)
        elif facts and put and not equations:
            yield say("derived.since-put", facts=facts, letters=letters)
        elif facts and letters and len(equations) == 1:
            yield say("derived.since-put-in", facts=facts, letters=letters, equation=equations[0])
        elif facts and equations:
            yield say("derived.since-in", facts=facts, equations=equations)
        elif len(facts) == 1 and isinstance(facts[0], Sentence):
            axis = self._axis_of_distances(line)
            if axis is None:
                yield say("given.fact", fact=facts[0])
            else:
                yield say("given.fact-along-one", fact=facts[0], axis=axis)
        elif facts:
            yield say("derived.since", facts=facts)
        elif letters and len(equations) == 1 and source.last:
            yield say("derived.put-last", equation=equations[0])
        elif letters and len(equations) == 1 and self._stand_in(source):
            yield say("derived.put-in", letters=letters, equation=equations[0])
        elif equations:
            yield say("derived.add", equations=equations)
        elif (exchanged := self._sides_exchanged(line)) is not None:
            yield say("derived.since", facts=(exchanged,))
        elif put:
            yield say("derived.put", letters=letters)

    def _equal_ratios(self, line: Line) -> lay.Layout | None:
        """``cos δ = cos φ`` where a line has the values of both, as the angles are equal."""
        cited = [own for own in map(self._cited, line.premises) if own is not None]
        relations = [own.relation for own in cited if isinstance(own.relation, Relation)]
        pairs = [relation.only[0] for relation in relations if _is_of_two_letters(relation)]
        subjects = {relation.options[0][0].left for relation in relations}
        for pair in pairs:
            for ratio in _RATIOS:
                both = (Apply(ratio, pair.left), Apply(ratio, pair.right))
                if subjects.issuperset(both) and len(cited) == 3:
                    return self._naming.relation(equality(*both))
        return None

    def _axis_of_distances(self, line: Line) -> str | None:
        """The name of the coordinates that stand in the place of distances that are put in."""
        lines = self._derivation.lines_in(line.premises)
        axes = {
            axis.axis
            for own in lines
            if own.shown == "silent" and (axis := axis_restated(self._derivation, own))
        }
        return {"i": "x", "j": "y"}[axes.pop()] if len(axes) == 1 else None

    def _sides_exchanged(self, line: Line) -> lay.Layout | None:
        """``1/k = e`` from e = 1/k, where a line has e in the place of 1/k; None elsewhere."""
        cited = [own for own in map(self._cited, line.premises) if own is not None]
        relations = [own.relation for own in cited if isinstance(own.relation, Relation)]
        if len(relations) != 2 or isinstance(line.relation, Meaning):
            return None
        subject = _subject(line.relation)
        for value, other in (relations, relations[::-1]):
            match value:
                case Relation(((Link(Letter() as letter, "=", right),),)) if letters(right):
                    before, after = (
                        {node for tree in trees_of(own) for node in walk(tree)}
                        for own in (other, line.relation)
                    )
                    if letter != subject and letter in after - before:
                        return self._naming.relation(Relation(((Link(right, "=", letter),),)))
        return None

    def _letters_put(self, source: Source, line: Line) -> tuple[Sentence | lay.Layout, ...]:
        """The letters that a line puts in, by name, without those of which its facts speak."""
        spoken = self._spoken_of(source)
        # What a line says anew of its own letter is not put into it.
        subject = None if isinstance(line.relation, Meaning) else _subject(line.relation)
        return tuple(
            self._named(self._replaced(letter, line))
            for letter in source.letters
            if spoken.isdisjoint(walk(letter)) and letter != subject
        )

    def _as_stated(self, facts: Iterable[str]) -> list[str]:
        """Facts in the order in which the statement gives them."""
        place = {fact.id: n for n, fact in enumerate(self._derivation.facts)}
        return sorted(facts, key=lambda name: place.get(name, len(place)))

    def _of_its_case(self, line: Line) -> lay.Layout:
        """Which of several solutions holds where a line stands."""
        case = next(case for case in self._derivation.cases if line.number in case.lines)
        own = self._derivation.line(case.line)
        assert own is not None
        assert isinstance(own.relation, Relation)
        return self._naming.relation(Relation((own.relation.options[case.option],)))

    def _written(self, line: Line) -> lay.Layout | None:
        """A line as it is printed."""
        relation = line.relation
        return self._naming.relation(relation) if isinstance(relation, Relation) else None

    def _combination(self, line: Line) -> SentenceId:
        """What a line makes of values above it: their ratio, product, sum or difference."""
        assert isinstance(line.relation, Relation)
        match line.relation.options[0][0].left:
            case Binary("/", Quantity() as above, Quantity() as below):
                fraction = self._is_fraction_lost(above, below)
                return "made.fraction-lost" if fraction else "made.ratio"
            case Binary("*", Quantity(), Quantity()):
                return "made.product"
            case Binary("+"):
                return "made.sum"
            case Binary("-", Quantity(one), Quantity(other)):
                return _DIFFERENCES.get((one, other), "made.difference")
        return "made.by-these"

    def _is_fraction_lost(self, loss: Quantity, own: Quantity) -> bool:
        """Whether a loss is compared with the energy that a body has when the loss begins."""
        if own.kind != "energy" or loss.kind not in LOSSES:
            return False
        if not isinstance(own.stage, int) or not isinstance(loss.stage, int):
            return True
        if loss.kind == "total_energy_lost":
            return own.stage == 0
        bodies = {argument.name for argument in own.arguments if isinstance(argument, Name)}
        between = (e for e in self._derivation.events if own.stage < e.number < loss.stage)
        return own.stage < loss.stage and not any(bodies & set(e.bodies) for e in between)

    def _named(self, tree: Expression) -> Sentence | lay.Layout:
        """What is put in: a letter, or words with an article."""
        return with_article(self._naming.layout(tree))

    def _replaced(self, tree: Expression, line: Line) -> Expression:
        """What an equation is used for: of tan²α = e that may be e, where the line has tan α."""
        if isinstance(line.relation, Meaning):
            return tree
        inside = {node for tree in trees_of(line.relation) for node in walk(tree)}
        base = tree.left if is_binary(tree, "^") else tree
        for own in map(self._cited, line.premises) if base in inside else ():
            match own.relation if own is not None else None:
                case Relation(((Link(left, "=", Letter() as other),),)) if left == tree:
                    return tree if other in inside else other
        return tree

    def _numbers(self, source: Source) -> tuple[Sentence, ...]:
        """The numbers of the equations from which a line comes, in their order."""
        return self._numbered(source.numbered, ordered=source.kind != "divide")

    def _numbered(self, lines: Iterable[int], *, ordered: bool = True) -> tuple[Sentence, ...]:
        """The numbers of lines that have some, from the top if ``ordered``."""
        numbers = [self._sources.numbers[number] for number in lines]
        if ordered:
            numbers.sort()
        return tuple(say("derived.number", number=str(number)) for number in numbers)

    def _stand_in(self, source: Source) -> bool:
        """Whether what is put in stands in the equation into which it is."""
        line = self._derivation.line(source.numbered[0])
        own = [letter.name for letter in source.letters if isinstance(letter, Letter)]
        if line is None or len(own) < len(source.letters):
            return True
        nodes = (node for tree in trees_of(line.relation) for node in walk(tree))
        return any(isinstance(node, Letter) and node.name in own for node in nodes)

    def _spoken_of(self, source: Source) -> frozenset[Expression]:
        """The quantities of which the given facts speak that are put in: no word more is needed."""
        facts = [fact for ref in source.facts if (fact := self._derivation.fact(ref))]
        return frozenset(
            node
            for fact in facts
            for tree in trees_of(fact.relation)
            for node in walk(tree)
            if isinstance(node, Quantity)
        )

    def _meeting_behind(self, line: Line) -> Sentence | None:
        """When spheres meet again, where that is given and a line says that it is so anyway."""
        for ref in line.premises:
            fact = self._derivation.fact(ref)
            relation = None if fact is None else meeting_of(self._naming, fact)
            if relation is not None and fact is not None:
                by_a_wall = returning_of(relation, fact, self._naming, inequality=False)
                return by_a_wall or condition_of(relation, self._naming, inequality=False)
        return None

    def _meeting(self, name: str, line: Line) -> Sentence | None:
        """When bodies meet, where that is what a given fact tells."""
        fact = self._derivation.fact(name)
        relation = None if fact is None else meeting_of(self._naming, fact)
        if relation is None or fact is None:
            return None
        for of_fact in (passing_of, returning_of):
            sentence = of_fact(relation, fact, self._naming)
            if sentence is not None:
                return sentence
        written = self._of_letter(line)
        return condition_of(relation, self._naming, inequality=True, written=written)

    def _of_letter(self, line: Line) -> lay.Layout | None:
        """``v < 0``, where a line says that of the value of the letter."""
        match line.relation:
            case Relation(((Link(value, sign, right),),)) if is_zero(right):
                pass
            case _:
                return None
        for ref in line.premises:
            own = self._derivation.line(ref)
            match own.relation if own is not None else None:
                case Relation(((Link(Letter() as letter, "=", tree),),)) if tree == value:
                    return self._naming.relation(Relation(((Link(letter, sign, right),),)))
        return None

    def _moves(
        self, names: tuple[str, ...]
    ) -> tuple[str, lay.Layout, Sentence | lay.Layout] | None:
        """Which way a body moves, where that is given, and so the sign of its component."""
        sense = self._derivation.fact(names[0]) if len(names) == 1 else None
        motion = motion_of(sense)
        if sense is None or motion is None:
            return None
        body, direction = motion
        return body, self._naming.layout(direction), fact_in_words(self._naming, sense)

    def _fact(self, name: str) -> Sentence | lay.Layout:
        fact = self._derivation.fact(name)
        assert fact is not None
        return fact_in_words(self._naming, fact)


def _is_of_two_letters(relation: Relation) -> bool:
    """Whether a line says that one letter is another."""
    match relation:
        case Relation(((Link(Letter(), "=", Letter()),),)):
            return True
    return False


def _subject(relation: Relation) -> Expression | None:
    """The letter of which a line says what it is."""
    left = relation.options[0][0].left
    return left if isinstance(left, Letter) else None


def _numbers_first(value: sp.Expr) -> Expression:
    """A sum as its terms come from a vector equation: what has no letter, and then the rest."""
    known, rest = sp.expand(value).as_independent(*value.free_symbols, as_Add=True)
    return total(tree_of(value) for value in (known, rest) if value != 0)
