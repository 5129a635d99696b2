"""From which lines a line comes, as a working says it, and the numbers that it needs for that."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import pairwise
from typing import Literal

from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Meaning,
    Ref,
    Relation,
)
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    LEAVES,
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    Unit,
    children,
    has_quantity,
    is_binary,
    is_quantity,
    walk,
)
from restitution.records import dataclass
from restitution.workings.naming.angles_by_signs import signs_behind
from restitution.workings.naming.rejected import bound_broken, root_of_a_square

_PAIRED = frozenset({"combine", "divide", "square-add"})
_SILENT = frozenset({"law", "define", "fact", "let", "answer", "shown", "triangle"})


@dataclass(frozen=True)
class Source:
    """What is said of where a line comes from.

    ``numbered`` are the lines named by their numbers, ``letters`` what is put in, ``facts`` the ids
    of given facts that are, ``reasons`` the lines by which a root is rejected. ``last`` tells that
    the line just above is what is put in, or that into which it is.
    """

    kind: Literal[
        "compare",
        "combine",
        "add",
        "case",
        "divide",
        "square-add",
        "put",
        "made",
        "formula",
        "times",
        "solve",
    ]
    numbered: tuple[int, ...] = ()
    letters: tuple[Expression, ...] = ()
    facts: tuple[str, ...] = ()
    reasons: tuple[int, ...] = ()
    values: tuple[int, ...] = ()
    eliminated: str = ""
    last: bool = False


def is_time(tree: Expression) -> bool:
    """Whether a tree is a time, or the time between two events."""
    match tree:
        case Quantity("time"):
            return True
        case Binary("-", Quantity("time"), Quantity("time")):
            return True
    return False


def says_a_time(line: Line) -> bool:
    """Whether a line says when something happens, or how long a flight takes."""
    return isinstance(line.relation, Relation) and is_time(line.relation.options[0][0].left)


def is_displacement(tree: Expression) -> bool:
    """Whether a tree is how far a body comes in one direction: one of its coordinates less one."""
    match tree:
        case Binary(
            "-",
            Quantity("along", (Quantity("position", _, late), axis)),
            Quantity("along", (Quantity("position", _, early), other)),
        ):
            return axis == other and late != early
    return False


def is_vector(tree: Expression) -> bool:
    """Whether a side of an equation is written as a vector."""
    pending = [tree]
    while pending:
        node = pending.pop()
        match node:
            case Binary(_, left, right):
                pending += (left, right)
            case Unit() | Quantity("momentum"):
                return True
            case Quantity("velocity" | "impulse" | "position", arguments) if arguments:
                return True
            case Quantity() | Apply():
                pass
            case _ if type(node) not in LEAVES:
                pending += children(node)
    return False


def is_multiple(relation: Relation | Meaning) -> bool:
    """Whether a velocity is a multiple of another."""
    match relation:
        case Relation(((Link(Quantity("velocity") as one, "=", right),),)):
            return any(is_quantity(node, "velocity") and node != one for node in walk(right))
    return False


def _gives_value(relation: Relation) -> bool:
    """Whether a line says what one quantity is, or the letter of one."""
    match relation:
        case Relation(options=((Link(Quantity() | Letter(), "="), *_),)):
            return True
    return False


class Sources:
    """The sources of the lines of one derivation, and the numbers of those that are named."""

    def __init__(self, derivation: Derivation) -> None:
        self._derivation = derivation
        shown = [
            line
            for line in derivation.lines
            if line.shown != "silent" and isinstance(line.relation, Relation)
        ]
        parts = derivation.asked
        # What stands in another part is not just above.
        self._above = {
            line.number: before.number
            for before, line in pairwise(shown)
            if parts.get(before.item or "") == parts.get(line.item or "")
        }
        self._vectors = {
            line.number
            for line in shown
            if any(is_vector(tree) for tree in trees_of(line.relation))
        }
        self._lines = {line.number: line for line in shown}
        self._ended = {end.line for end in derivation.items}
        self._cases = {n: case.line for case in derivation.cases for n in case.lines}
        self._of = {line.number: self._source(line) for line in shown}
        sources = [source for source in self._of.values() if source]
        named = {ref for source in sources for ref in (*source.numbered, *source.reasons)}
        order = [line.number for line in shown if line.number in named]
        self.numbers: Mapping[int, int] = {number: n for n, number in enumerate(order, 1)}
        for line in shown:
            source = self._of[line.number]
            if source is not None:
                self._of[line.number] = self._with_numbered_values(line, source)

    def of(self, line: Line) -> Source | None:
        """What is to be said of a line; None where it is plain."""
        return self._of.get(line.number)

    def _with_numbered_values(self, line: Line, source: Source) -> Source:
        """A source of which the values of other parts that have numbers are named by these."""
        parts, numbered = self._derivation.asked, source.numbered
        part = parts.get(line.item or "")
        far = tuple(
            value
            for value in source.values
            if value in self.numbers and parts.get(self._lines[value].item or "") != part
        )
        if far != source.values or not (far and numbered):
            return source  # beside letters that are put in, it is put in by its letter too
        return replace(source, numbered=(*numbered, *far), letters=(), values=())

    def _equations(self, refs: tuple[Ref, ...]) -> list[int]:
        """The equations among premises; of one that is not printed that which says it."""
        numbers: list[int] = []
        for ref in refs:
            line = self._derivation.line(ref)
            if line is None or not isinstance(line.relation, Relation):
                continue
            if line.shown != "silent":
                numbers.append(line.number)
            elif line.move.id == "rearrange" or self._is_its_letter(line):
                numbers += self._equations(line.premises)
        return list(dict.fromkeys(numbers))

    def _is_its_letter(self, line: Line) -> bool:
        """Whether a line says of a component what one above it says of the letter for it."""
        if line.move.record != "component" or not isinstance(line.relation, Relation):
            return False
        value = line.relation.only[-1].right
        links = (own.relation for own in self._derivation.lines_in(line.premises))
        return any(
            isinstance(own, Relation)
            and isinstance(own.options[0][0].left, Letter)
            and own.options[0][-1].right == value
            for own in links
        )

    def _source(self, line: Line) -> Source | None:
        move, cited = line.move.id, self._equations(line.premises)
        above = self._above.get(line.number)
        if move == "triangle":
            facts = self._given(line.premises)
            if facts:
                return Source("put", facts=facts)
            # Below an answer it is a new thought, and says where it comes from.
            apart = bool(cited) and (cited[0] != above or above in self._ended)
            if apart and cited == [self._cases.get(line.number)]:
                own_cases = (c.lines for c in self._derivation.cases if line.number in c.lines)
                begins = not any(above in numbers for numbers in own_cases)
                return None if begins else Source("case")
            return Source("add", tuple(cited)) if apart else None
        if move == "rearrange" and not cited and (facts := self._given(line.premises)):
            return Source("put", facts=facts)
        if move == "solve":
            return Source("solve", () if cited == [above] else tuple(cited))
        if line.move.record == "size" and cited and cited[0] != above and self._is_read_off(line):
            return Source("add", tuple(cited[:1]))
        if move in _SILENT or signs_behind(self._derivation, line):
            return None
        if cited and isinstance(line.premises[0], int) and self._splits(line, cited[0]):
            first = above == cited[0]
            again = above in self._lines and self._splits(self._lines[above], cited[0])
            named = () if first or again else tuple(cited)
            return Source("compare", named) if not again else None
        if move == "put":
            if (divided := self._divided(line, cited)) is not None:
                return Source("divide", divided)
            return self._put(line, cited, above)
        if move in _PAIRED and len(cited) == 2:
            if move == "combine" and line.move.eliminated:
                return Source("combine", tuple(cited), eliminated=line.move.eliminated)
            kind = "add" if move == "combine" else move
            if move == "divide" and self._is_divided_by(line, cited[0]):
                cited.reverse()
            return Source(kind, tuple(cited))  # type: ignore[arg-type]
        if move == "roots" and cited == [above] and self._is_quadratic(cited[0]):
            return Source("formula")
        if move == "reject":
            cited, reasons = cited[:1], self._excluding(line)
            numbered = tuple(cited) if cited != [above] else ()
            return Source("add", numbered, reasons=reasons) if numbered or reasons else None
        if move == "inverse":
            # In which quadrant the angle lies, the signs of the components tell without a word.
            cited = [number for number in cited if self._is_ratio_of(line, number)] or cited
            if not cited and (facts := self._given(line.premises)):
                return Source("put", facts=facts)
        if cited == [self._cases.get(line.number)]:
            return None  # the heading of the case says it
        if len(cited) > 1 or (cited and cited[0] != above):
            return Source("add", tuple(cited))
        return None

    def _divided(self, line: Line, cited: list[int]) -> tuple[int, int] | None:
        """The two lines of which one gives what stands above in a ratio, the other what is below.

        It is for times: a ratio of other quantities has a title of its own.
        """
        assert isinstance(line.relation, Relation)
        match line.relation.options[0][0].left:
            case Binary("/", above, below) if is_time(above) and is_time(below):
                lefts = {self._left(number): number for number in cited}
                if above in lefts and below in lefts:
                    return lefts[above], lefts[below]
        return None

    def _is_divided_by(self, line: Line, number: int) -> bool:
        """Whether a line gives what stands below in the ratio that another line is about."""
        assert isinstance(line.relation, Relation)
        match line.relation.options[0][0].left:
            case Binary("/", _, below):
                return self._left(number) == below
        return False

    def _left(self, number: int) -> Expression | None:
        relation = self._lines[number].relation if number in self._lines else None
        return relation.options[0][0].left if isinstance(relation, Relation) else None

    @staticmethod
    def _is_read_off(line: Line) -> bool:
        """Whether a size is that of the one component that there is."""
        assert isinstance(line.relation, Relation)
        return not any(isinstance(node, Apply) for node in walk(line.relation.only[0].right))

    def _excluding(self, line: Line) -> tuple[int, ...]:
        """The laws by which a root would break the bound of another letter, or what was squared."""
        squared = root_of_a_square(self._derivation, line)
        if squared is not None and squared[1] in self._lines:
            return (squared[1],)
        if bound_broken(self._derivation, line) is None:
            return ()
        cited = [
            equation for equation in self._equations(line.premises[1:]) if equation in self._lines
        ]
        laws = tuple(number for number in cited if self._lines[number].move.id == "law")
        return laws or tuple(cited[:1])

    def _is_ratio_of(self, angle: Line, number: int) -> bool:
        """Whether a line says what the sine, the cosine or the tangent of an angle is."""
        above = self._lines.get(number)
        if above is None or not isinstance(above.relation, Relation):
            return False
        assert isinstance(angle.relation, Relation)
        left = above.relation.options[0][0].left
        own = angle.relation.options[0][0].left
        return isinstance(left, Apply) and left.argument == own

    def _is_quadratic(self, number: int) -> bool:
        """Whether a line says ax² + bx + c = 0, and not by its factors."""
        match self._lines[number].relation:
            case Relation(((Link(Binary("+" | "-", Binary("+" | "-"), _), "=", Number(value)),),)):
                return value == 0
        return False

    def _splits(self, line: Line, cited: int) -> bool:
        """Whether a line is one component of an equation of vectors."""
        return cited in self._vectors and line.number not in self._vectors

    def _given(self, refs: tuple[Ref, ...]) -> tuple[str, ...]:
        """The given facts among premises."""
        return tuple(
            ref
            for ref in refs
            if isinstance(ref, str)
            and (fact := self._derivation.fact(ref)) is not None
            and fact.kind in ("given", "range")
        )

    def _subjects(self, line: Line, target: int | None) -> Iterator[Expression]:
        """What a line says the value of; of several ratios those that are put in."""
        assert isinstance(line.relation, Relation)
        links = line.relation.options[0]
        into = None if target is None else self._derivation.line(target)
        if (
            line.move.id in ("triangle", "solve")
            and into is not None
            and isinstance(into.relation, Relation)
        ):
            nodes = {node for tree in trees_of(into.relation) for node in walk(tree)}
            # A square of a ratio is put in where that stands in a product that is squared.
            used = [
                ratio
                for ratio in (link.left for link in links)
                if ratio in nodes or (is_binary(ratio, "^") and ratio.left in nodes)
            ]
            if used:
                yield from used
                return
        yield links[0].left

    def _letters(self, values: Iterable[int], target: int | None) -> tuple[Expression, ...]:
        """The letters and quantities that are put in, of which lines say the values."""
        return tuple(
            letter
            for value in values
            if (own := self._derivation.line(value)) is not None
            for letter in self._subjects(own, target)
        )

    def _is_sum_of_times(self, line: Line, cited: list[int]) -> bool:
        """Whether a line adds up the times of several ways."""
        assert isinstance(line.relation, Relation)
        if any(has_quantity(link.right) for links in line.relation.options for link in links):
            return False  # it relates times to each other
        lines = [line, *(self._lines[number] for number in cited if number in self._lines)]
        return len(lines) == len(line.premises) + 1 and all(
            is_time(line.relation.options[0][0].left)
            for line in lines
            if isinstance(line.relation, Relation)
        )

    def _is_made_of(self, line: Line, cited: list[int]) -> bool:
        """Whether a line is worked out of the values of quantities: their ratio, say."""
        assert isinstance(line.relation, Relation)
        left = line.relation.options[0][0].left
        if not isinstance(left, Binary) or line.relation.options[0][0].sign != "=":
            return False
        parts = set(walk(left)) - {left}
        above = [self._lines[number].relation for number in cited if number in self._lines]
        subjects = [
            relation.only[0].left
            for relation in above
            if isinstance(relation, Relation) and _gives_value(relation)
        ]
        return (
            len(subjects) == len(cited) > 0
            and parts.issuperset(subjects)
            and any(isinstance(subject, Quantity) for subject in subjects)
        )

    def _has_quantity(self, number: int) -> bool:
        """Whether a line speaks of the motion, and not of letters alone."""
        own = self._derivation.line(number)
        return (
            own is None
            or not isinstance(own.relation, Relation)
            or any(map(has_quantity, trees_of(own.relation)))
        )

    def _are_equal(self, line: Line, cited: list[int]) -> bool:
        """Whether a line says that two quantities are equal, or opposite, which two lines tell.

        A third may say that two letters in these are equal.
        """
        assert isinstance(line.relation, Relation)
        match line.relation.options:
            case ((Link(Quantity() as one, "=", Quantity() as other),),):
                sides = {one, other}
            case ((Link(Quantity() as one, "=", Negate(Quantity() as other)),),):
                sides = {one, other}
            case _:
                return False
        lines = [own for number in cited if (own := self._derivation.line(number)) is not None]
        named: dict[Expression, Expression] = {
            Letter(letter): meaning.quantity
            for letter, meaning in self._derivation.meanings.items()
        }
        subjects = {
            named.get(e.relation.only[0].left, e.relation.only[0].left)
            for e in lines
            if isinstance(e.relation, Relation) and len(e.relation.options) == 1
        }
        return subjects == sides if len(cited) == 2 else len(cited) == 3 and subjects > sides

    def _put(self, line: Line, cited: list[int], above: int | None) -> Source | None:
        first, *_ = line.premises
        target = first if isinstance(first, int) and first in cited else None
        values = tuple(number for number in cited if number != target)
        # Where a fact is named first, the line into which values are put comes next.
        into = target if target is not None else next(iter(cited), None)
        letters = self._letters(values, into)
        facts = self._given(line.premises)
        if self._is_sum_of_times(line, cited):
            return Source("times")
        if not facts and self._is_made_of(line, cited):
            return Source("made")
        ties = [number for number in cited if not self._has_quantity(number)]
        others = [number for number in cited if number not in ties]
        if not facts and ties and self._is_made_of(line, others):
            return Source("add", tuple(ties))  # letters are put in by the way
        if not facts and self._are_equal(line, cited):
            return Source("add", tuple(cited))
        # Vectors that are compared are both seen.
        compared = not facts and is_multiple(line.relation)
        numbered = () if target is None or target == above or compared else (target,)
        # What is put in of several cases is named: its case stands between.
        last = values == (above,) and above != self._cases.get(line.number)
        if not (numbered or letters or facts):
            return None
        return Source("put", numbered, letters, facts, values=values, last=last)
