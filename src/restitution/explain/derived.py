"""A derivation as a worked solution: what it says in sentences and rows, for every renderer.

Premises are not printed but where a reader looks for them: which equations were combined, why a
root is rejected, on what an inequality rests. An equation has a number only where it is named.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import groupby
from typing import Any

from restitution.explain.steps import REQUIRED, Explanation, PartExplanation, Row, Step
from restitution.explaining.derivation import (
    Derivation,
    ItemEnd,
    Line,
    Link,
    Meaning,
    Relation,
)
from restitution.explaining.layouts import chains, of_chain, of_relation, of_tree
from restitution.explaining.notation import read_relation, read_tree
from restitution.explaining.saying import Sentence, operand, say
from restitution.explaining.sentences import SENTENCES
from restitution.expression.tree import Expression, Letter, Name, Negate, Quantity, Unit
from restitution.problem import Problem
from restitution.render import layout as lay

_TITLED = frozenset({"law", "define"})
_NUMBERED = frozenset({"combine", "divide", "square-add", "put"})
_REASONED = frozenset({"reject", "sign", "compare", "cancel", "monotone"})


def explanation_of(derivation: Derivation, problem: Problem) -> Explanation:
    """The working as a value that text, Markdown, LaTeX, HTML and Typst are made of."""
    writer = _Writer(derivation)
    parts: list[PartExplanation] = []
    by_part = groupby(derivation.lines, writer.part_of)
    for label, lines in by_part:
        steps = tuple(_joined(writer.steps(list(lines))))
        ends = [each for each in derivation.items if each.part == label]
        asked = tuple(dict.fromkeys(each.item for each in ends))
        answers = tuple(_plain(of_relation(each.answer, writer.vectors)) for each in ends)
        parts.append(PartExplanation(label, asked, steps, answers))
    return Explanation(problem.title, tuple(parts))


def _joined(steps: Iterator[Step]) -> Iterator[Step]:
    """Steps with the rows that follow without a word among the rows above them."""
    last: Step | None = None
    for step in steps:
        wordless = step.rows and not step.title and not step.sentences
        if last is not None and last.rows and wordless and step.item == last.item:
            last = replace(last, rows=(*last.rows, *step.rows))
            continue
        if last is not None:
            yield last
        last = step
    if last is not None:
        yield last


def _plain(layout: lay.Layout) -> str:
    from restitution.render.text import to_text

    return to_text(layout)


@dataclass
class _Writer:
    """One derivation on its way to paper."""

    derivation: Derivation
    heading: int | None = None
    title: Sentence | None = None

    def __post_init__(self) -> None:
        meanings = self.derivation.meanings
        self.vectors = frozenset(name for name, each in meanings.items() if each.vector)
        self.events = {each.number: each for each in self.derivation.events}
        self.ends = {each.line: each for each in self.derivation.items}
        parts = {each.item: each.part for each in self.derivation.items}
        self.items = {each: n for n, each in enumerate(parts)}
        self.parts = parts
        self.numbers = self._numbered()

    def part_of(self, line: Line) -> str | None:
        """The label of the part to which a line belongs."""
        return self.parts.get(line.item or "")

    def _numbered(self) -> Mapping[int, int]:
        """The lines that a later line names, and the numbers by which it does."""
        position = {each.number: n for n, each in enumerate(self.derivation.lines)}
        named: set[int] = set()
        for line in self.derivation.lines:
            if line.move.id not in _NUMBERED:
                continue
            cited = [ref for ref in line.premises if self._is_equation(ref)]
            after = [r for r in cited if position[line.number] - position[r] > 1]  # type: ignore[index]
            if len(cited) > 1 or after:
                named |= set(cited)  # type: ignore[arg-type]
        return {number: n for n, number in enumerate(sorted(named), 1)}

    def _is_equation(self, ref: Any) -> bool:
        line = self.derivation.line(ref) if isinstance(ref, int) else None
        return line is not None and isinstance(line.relation, Relation)

    # --- steps ----------------------------------------------------------------------------------

    def steps(self, lines: list[Line]) -> Iterator[Step]:
        """The lines of a part as steps."""
        lets: list[Meaning] = []
        for line in lines:
            if line.shown == "silent":
                continue
            if isinstance(line.relation, Meaning):
                lets.append(line.relation)
                continue
            yield from self._heading(line)
            if lets:
                yield Step("setting", sentences=tuple(self._setting(lets)))
                lets = []
            yield self._step(line)

    def _heading(self, line: Line) -> Iterator[Step]:
        """A heading where the next of several events begins."""
        number = line.move.event
        impacts = [each for each in self.events.values() if each.kind == "impact"]
        if number is None or number == self.heading or len(impacts) < 2:
            return
        event = self.events.get(number)
        self.heading = number
        if event is not None and event.kind == "impact":
            first, second = event.bodies
            ordinal = f"ordinal.{number}"
            title = (
                say("heading.impact", order=say(ordinal), first=first, second=second)
                if ordinal in SENTENCES
                else say("heading.impact-number", number=number, first=first, second=second)
            )
            yield Step("heading", sentences=(title,), event=number)

    def _setting(self, lets: list[Meaning]) -> Iterator[Sentence]:
        """What letters stand for: quantities by name, and the others as equations."""
        letters = {each.letter: of_tree(Letter(each.letter), self.vectors) for each in lets}
        named = [each for each in lets if isinstance(each.quantity, Quantity)]
        if named:
            meanings = (
                say(
                    "derived.meaning",
                    letter=letters[each.letter],
                    quantity=self._quantity(each.quantity, each.sense),
                )
                for each in named
            )
            yield say("derived.let", meanings=tuple(meanings))
        others = [each for each in lets if each not in named]
        if others:
            equations = (
                lay.Relation((letters[e.letter], of_tree(e.quantity, self.vectors)), ("=",))
                for e in others
            )
            yield say("derived.name", equations=tuple(equations))

    def _step(self, line: Line) -> Step:
        kind: Any = "principle" if line.move.id in _TITLED else "solve"
        title = self._title(line)
        above, self.title = self.title, title
        rows = list(self._rows(line))
        rows[-1] = replace(
            rows[-1],
            points=line.marks,
            asides=(*rows[-1].asides, *self._asides(line)),
        )
        return Step(
            kind,
            tuple(rows),
            None if title == above else title,
            tuple(self._sentences(line)),
            item=self.items.get(line.item or ""),
        )

    def _title(self, line: Line) -> Sentence | None:
        record, event = line.move.record, self.events.get(line.move.event or 0)
        if line.move.id not in _TITLED or record is None:
            return None
        wall = event is not None and event.wall
        if record in ("unchanged", "restitution-wall") and wall:
            assert event is not None
            if record == "unchanged":
                return say("unchanged-wall.title", wall=event.bodies[1])
            return say("restitution.title")
        if record == "impulse" and event is not None:
            body = line.move.bodies[0] if line.move.bodies else event.bodies[0]
            if wall:
                return say("impulse-wall.title", body=body, wall=event.bodies[1])
            return say("impulse-spheres.title", body=body)
        return say(_TITLES[record]) if record in _TITLES else None

    def _sentences(self, line: Line) -> Iterator[Sentence]:
        """What is said before a row: how it comes from the ones above."""
        move = line.move
        if move.id == "combine" and move.eliminated:
            letter = of_tree(read_tree(move.eliminated, self._names()), self.vectors)
            yield say("derived.combine", letter=letter, equations=self._equations(line))
        elif move.id in ("combine", "divide", "square-add", "put"):
            equations = self._equations(line)
            if equations:
                yield say(_FROM[move.id], equations=equations)
        elif move.id == "identity" and move.record in _BY:
            yield say(_BY[move.record])
        elif move.id == "fact":
            yield say("derived.fact")

    def _equations(self, line: Line) -> tuple[str, ...]:
        return tuple(
            f"({self.numbers[ref]})"
            for ref in line.premises
            if isinstance(ref, int) and ref in self.numbers
        )

    def _asides(self, line: Line) -> Iterator[Sentence]:
        """What stands behind a row: its number, its reason, and that it was to be shown."""
        if line.move.id in _REASONED:
            reasons = tuple(
                reason for ref in line.premises if (reason := self._reason(ref)) is not None
            )
            if reasons:
                yield say("derived.as", reasons=reasons)
        if line.number in self.numbers:
            yield say("derived.number", number=str(self.numbers[line.number]))
        end = self.ends.get(line.number)
        if isinstance(end, ItemEnd) and end.shown:
            yield from REQUIRED

    def _reason(self, ref: Any) -> Sentence | lay.Layout | None:
        """What is known of a letter, as a reader would say it."""
        if not isinstance(ref, str) or self.derivation.fact(ref) is not None:
            return None
        head, colon, text = ref.partition(":")
        if colon and head.strip() == "acute":
            return say("derived.acute", angle=of_tree(read_tree(text, self._names())))
        return of_relation(read_relation(ref, self._names()))

    def _names(self) -> dict[str, str]:
        return {
            body: "wall" if each.wall and n else "sphere"
            for each in self.events.values()
            for n, body in enumerate(each.bodies)
        }

    # --- rows -----------------------------------------------------------------------------------

    def _rows(self, line: Line) -> Iterator[Row]:
        assert isinstance(line.relation, Relation)
        options = line.relation.options
        if len(options) > 1:
            yield self._alternatives(options)
            return
        for chain in chains(options[0]):
            laid = of_chain(chain, self.vectors, self._name_of)
            yield Row(laid.operands, laid.signs)

    def _alternatives(self, options: tuple[tuple[Link, ...], ...]) -> Row:
        """``t = 1 or t = −1``, set at the first sign."""
        first, *rest = options
        laid = of_chain(first, self.vectors, self._name_of)
        others = [of_chain(each, self.vectors, self._name_of) for each in rest]
        last = lay.Phrase((laid.operands[-1], *others), str(say("list.or")))
        return Row((*laid.operands[:-1], last), laid.signs)

    def _name_of(self, tree: Quantity) -> lay.Layout | None:
        """How a quantity of the motion is called among letters; vectors keep their own form."""
        if tree.kind in _NAMED or tree == Quantity("impulse", (), tree.stage):
            return operand(self._quantity(tree, None))
        return None

    def _quantity(self, tree: Expression, sense: Expression | None) -> Sentence:
        """A quantity as the working calls it, without the time, which its heading tells."""
        match tree:
            case Quantity("along" | "across" as kind, (vector, axis)):
                return self._component(kind, vector, sense or axis)
            case Quantity("impulse", (), _):
                return say("derived.impulse-size")
            case Quantity(kind, arguments, _) if kind in _OF:
                return say(_OF[kind], of=tuple(self._plainly(each) for each in arguments))
        return say("derived.value", value=of_tree(self._timeless(tree), self.vectors))

    def _component(self, kind: str, vector: Expression, axis: Expression) -> Sentence:
        body = vector.arguments[0] if isinstance(vector, Quantity) else vector
        own = axis.operand if isinstance(axis, Negate) else axis
        event = (
            self.events.get(own.stage)
            if isinstance(own, Quantity) and isinstance(own.stage, int)
            else None
        )
        of = self._plainly(body)
        if event is not None and event.wall:
            return say(_AT_A_WALL[kind], body=of, wall=event.bodies[1])
        if event is not None:
            return say(_OF_CENTRES[kind], body=of)
        return say(_OF_A_VECTOR[kind], body=of, axis=of_tree(axis))

    def _plainly(self, tree: Expression) -> Any:
        match tree:
            case Name(name):
                return name
            case Quantity("velocity", (body,)):
                return self._plainly(body)
            case Unit():
                return of_tree(tree)
            case Quantity("line_of_centres", _):
                return say("derived.centres")
        return of_tree(self._timeless(tree), self.vectors)

    @staticmethod
    def _timeless(tree: Expression) -> Expression:
        from restitution.explaining.trees import rebuilt

        return rebuilt(
            tree, lambda each: replace(each, stage=None) if isinstance(each, Quantity) else each
        )


_NAMED = frozenset({"along", "across", "speed", "angle", "deflection"})
_OF = {
    "speed": "derived.speed",
    "angle": "derived.angle",
    "deflection": "derived.deflection",
    "impulse": "derived.impulse",
}
_AT_A_WALL = {"along": "derived.component-towards", "across": "derived.component-parallel"}
_OF_CENTRES = {"along": "derived.component-along", "across": "derived.component-across"}
_OF_A_VECTOR = {
    "along": "derived.component-along-vector",
    "across": "derived.component-across-vector",
}
_FROM = {
    "combine": "derived.add",
    "put": "derived.put",
    "divide": "derived.divide",
    "square-add": "derived.square-add",
}
_BY = {
    "pythagoras": "derived.pythagoras",
    "double-angle": "derived.double-angle",
    "half-angle": "derived.half-angle",
    "sum-of-angles": "derived.sum-of-angles",
    "complement": "derived.complement",
}
_TITLES = {
    "unchanged": "unchanged.title",
    "momentum": "momentum.title",
    "restitution": "restitution.title",
    "restitution-wall": "restitution.title",
    "momentum-vector": "derived-momentum.title",
    "impulse-vector": "impulse.title",
    "opposite-impulses": "derived-opposite.title",
    "across-the-impulse": "derived-axis.title",
    "along-the-change": "derived-axis.title",
    "energy": "derived-energy.title",
    "energy-ratio": "derived-energy.title",
    "energy-lost": "derived-energy.title",
    "total": "derived-energy.title",
    "tan": "derived-direction.title",
    "tan-direction": "derived-direction.title",
    "scalar-angle": "derived-direction.title",
    "tan-deflection": "derived-deflection.title",
    "sum": "derived-deflection.title",
    "difference": "derived-deflection.title",
    "speed": "derived-speed.title",
    "component": "derived-resolved.title",
    "assemble": "derived-assembled.title",
    "perpendicular": "derived-perpendicular.title",
    "parallel": "derived-parallel.title",
    "straight-line": "derived-journey.title",
}
