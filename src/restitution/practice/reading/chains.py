"""Relations in all their readings: the chains of a segment, their labels, and declarations."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import field, replace
from fractions import Fraction
from itertools import pairwise, product

from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Number,
    Quantity,
    Unit,
    is_binary,
    is_function,
    letters,
    walk,
)
from restitution.practice.reading.angles import angular, is_angle
from restitution.practice.reading.bodies import vectors_of, worths_of
from restitution.practice.reading.characters import Plain
from restitution.practice.reading.cursor import UnreadableError
from restitution.practice.reading.declarations import Declarations
from restitution.practice.reading.grammar import is_vector
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.reading.readings import Side, read_sides
from restitution.practice.reading.relations import (
    claims,
    decimals,
    is_heading,
    is_law,
    is_letter,
    is_numeric,
    is_percentage,
    is_ratio,
    sides_of,
    worked_out,
)
from restitution.practice.reading.segments import Segment
from restitution.practice.reading.tokens import Token, Usage
from restitution.practice.reading.vocabulary import DIRECTIONS, HEADS, STAGES
from restitution.practice.script import Claim, Decimal, Declaration, Link, Sign, column_of
from restitution.problem import Impact, Problem
from restitution.records import dataclass

MAX_CLAIMS = 24
# Letters that stand for a sine, a cosine or a tangent where they are equated with one.
_SHORT_FOR = frozenset("cstkpqxyzfCSTKXY")
# Words behind which a relation without a left side goes on from the last right one.
_CONNECTING = frozenset(
    ("so", "hence", "therefore", "=>", ",", "and", "or", "then", "thus", "which", "giving", "->")
)
# The way of a component behind its value: ``A: 3u along, 4u perp``.
_ON = re.compile(r"\bon\s+$")
_WAY = re.compile(
    r"\s+(along|parallel|perp|perpendicular|across|left|right|up|down)\b(?!\s+to\b)", re.IGNORECASE
)
# Phrases that are names of laws as well: ``momentum: 2u - 3w = -u``, ``restitution: 6e = 4``.
_LAW, _LAW_OF_RESTITUTION = "the momentum", "the restitution"
_TANGENTS = frozenset(("tangent", "tangential", "common"))
_WALLS = frozenset(("wall", "cushion", "barrier"))
_OF_WALLS = _WALLS | {"parallel", "along", "perp", "perpendicular", "to", "the", "direction", "of"}
_CENTRES = frozenset(("centres", "centers", "centre", "loc"))
_LOST = Letter("percentage lost")
_HUNDRED = Number(Fraction(100))


@dataclass(frozen=True)
class Past:
    """What a line may go on from: the last right side, and a left side that waits for one.

    ``earlier`` is where the chain above the last one ended: an aside may stand in between.
    ``decimals`` are those of the last relation.
    """

    side: tuple[Side, ...] = ()
    earlier: tuple[Side, ...] = ()
    waiting: tuple[Side, ...] = ()
    sign: Sign = "="
    decimals: tuple[Decimal, ...] = ()


@dataclass
class Statements:
    """What a line states. ``body`` is a sphere that labels it."""

    links: tuple[Link, ...] = ()
    declarations: tuple[Declaration, ...] = ()
    values: tuple[Expression, ...] = ()
    supposed: tuple[Claim, ...] = ()
    fault: str | None = None
    column: int | None = None
    body: str | None = None
    past: Past = field(default_factory=Past)


def _is_direction(label: Token) -> bool:
    """Whether a label names a way and no quantity: ``j direction: 2v + 3w = 4``."""
    heads = {HEADS[word] for word in label.name.split() if word in HEADS}
    return label.kind == "phrase" and heads <= {"direction", "component"}


def _without_numbers(tree: Expression) -> Expression | None:
    """The letters of a product of a number and letters; None of a number, and of a sum."""
    match tree:
        case Number():
            return None
        case Letter() | Binary("^", Letter(), Number()):
            return tree
        case Binary("*", left, right):
            one, other = _without_numbers(left), _without_numbers(right)
            return Binary("*", one, other) if one and other else one or other
        case Binary("/", left, Number()):
            return _without_numbers(left)
    return None


def _in_hundredths(
    read: Sequence[tuple[Side, ...]], sides: Sequence[Sequence[Token]]
) -> list[tuple[Side, ...]]:
    """``100 - 52.4 - 36 = 11.6%``: what works out the number of a percentage counts hundredths."""
    if [token.kind for token in sides[-1]] != ["number", "percent"]:
        return list(read)
    number = sides[-1][0].value
    return [
        (*sides, Side(Binary("/", sides[0].tree, _HUNDRED)))
        if (value := worked_out(sides[0].tree)) is not None and abs(value - number) < number / 100
        else sides
        for sides in read
    ]


def _is_sum_of_numbers(tree: Expression) -> bool:
    """Whether a side works out a number: a sum, a product, or the root of one."""
    root = is_function(tree, "sqrt")
    return (root or isinstance(tree, Binary)) and not letters(tree)


def _is_root(tree: Expression) -> bool:
    """Whether a side is the root of a sum, as a speed is, perhaps times a letter or divided."""
    if is_binary(tree, "*", "/"):
        return _is_root(tree.left) or _is_root(tree.right)
    match tree:
        case Apply("sqrt", Binary("+")):
            return True
    return False


def _is_lettered_sum(tree: Expression) -> bool:
    """Whether a side is a sum with letters: between two of them stands an equation."""
    return is_binary(tree, "+", "-") and bool(letters(tree))


class Chains:
    """What the chains of a line state; `Statements` gathers it."""

    def __init__(
        self,
        usage: Usage,
        problem: Problem,
        number: int,
        line: Plain,
        past: Past,
        whose: str | None = None,
    ) -> None:
        self.usage, self.problem, self.number, self.line = usage, problem, number, line
        self.whose = whose
        self.past = past
        self.continues = False
        self.statements = Statements()
        self.links: list[Link] = []
        self.label: Token | None = None
        self.direction: Token | None = None
        self.power: tuple[Side, ...] = ()
        self.declares = self.supposes = False
        self.defines = False
        self.waiting: tuple[Side, ...] = ()
        self.waiting_sign: Sign = "="
        self.before: tuple[Side, ...] = ()
        self.worth: tuple[Side, ...] = ()
        self.titled = False
        self.last_label = ""
        self.declared = Declarations(usage, problem)
        self.pending_letters: list[Letter] = []
        self.case: tuple[Claim, ...] = ()
        self.condition: tuple[Claim, ...] = ()
        self.behind: Sequence[Segment] = ()
        self.of_law = False
        self.became: dict[str, tuple[Side, ...]] = {}

    @property
    def walls(self) -> frozenset[str]:
        """The names of the walls."""
        return frozenset(wall.name for wall in self.problem.walls)

    def _last_sides(self) -> tuple[Side, ...]:
        rights = dict.fromkeys(claim.right for claim in self.links[-1].readings)
        return tuple(Side(tree) for tree in rights)

    def body_of(self, token: Token) -> str | None:
        """The sphere that a label names."""
        return token.name if token.name in self.usage.spheres else None

    def _claims_of(self, segment: Segment) -> Iterator[Claim]:
        """The relations of a segment in their first reading."""
        sides, signs = sides_of(segment.tokens)
        for sign, (left, right) in zip(signs, pairwise(sides), strict=False):
            if left and right:
                yield Claim(self.sides(left)[0].tree, sign, self.sides(right)[0].tree)

    def joined(self, before: Segment, behind: Segment, first: int, rather: bool) -> None:
        """Adds the readings of ``w = 0.6u v = 2`` as a chain to those of two relations."""
        middle = [*sides_of(before.tokens)[0][-1], *sides_of(behind.tokens)[0][0]]
        try:
            chained = [side.tree for side in self.sides(middle)]
        except UnreadableError:
            return
        above, below = self.links[first - 1], self.links[first]
        pairs = [(tree, reading) for tree in chained for reading in above.readings]
        upper = tuple(dict.fromkeys(replace(claim, right=tree) for tree, claim in pairs))
        pairs = [(tree, reading) for tree in chained for reading in below.readings]
        lower = tuple(dict.fromkeys(replace(claim, left=tree) for tree, claim in pairs))
        half = MAX_CLAIMS // 2
        for place, whole, parted in (
            (first - 1, upper[:half], above.readings[:half]),
            (first, lower[:half], below.readings[:half]),
        ):
            readings = (*whole, *parted) if rather else (*parted, *whole)
            self.links[place] = replace(self.links[place], readings=readings)

    def sides(self, tokens: Sequence[Token]) -> tuple[Side, ...]:
        """The readings of a side."""
        end = tokens[-1] if tokens else None
        column = self.line.column(end.end) if end else self.line.column(len(self.line.text))
        return read_sides(tokens, self.usage, self.number, column)

    def _is_moving(self, tree: Expression) -> bool:
        """Whether a vector may be a velocity: it is no letter alone.

        A u of the question is a number there, whatever the script calls by it elsewhere.
        """
        vectors = self.usage.vectors - self.usage.letters
        return is_vector(tree, vectors) and not isinstance(tree, Letter | Unit)

    def label_tree(
        self, label: Token, sides: tuple[Side, ...], tokens: Sequence[Token] = ()
    ) -> Expression:
        """A label as a letter; a body's name is its velocity, its speed or a component.

        Behind *on* it is the impulse on the body: ``impulse on A = -6i, so on B +6i``.
        """
        if label.kind == "phrase":
            return Letter(label.name)
        if _ON.search(self.line.text[: label.start]):
            return Letter(f"impulse on {label.name}")
        direction = _WAY.match(self.line.text, tokens[-1].end) if tokens else None
        if direction is not None:
            return Letter(f"component of {label.name} {direction[1].lower()}")
        vector = is_vector(sides[0].tree, self.usage.vectors)
        return Letter(f"{'velocity' if vector else 'speed'} of {label.name}")

    def further(self, sides: tuple[Side, ...], tokens: Sequence[Token]) -> bool:
        """A second value of the last relation: ``x = 2 or 3``."""
        last = self.links[-1]
        first = last.readings[0]
        if first.sign != "=" or letters(first.left) & letters(sides[0].tree):
            return False
        readings = tuple(
            replace(reading, others=(*reading.others, *self.alike(reading.left, sides[0].tree)))
            for reading in last.readings
        )
        figures = (*last.decimals, *decimals(tokens, readings))
        self.links[-1] = replace(last, readings=readings, decimals=figures)
        return True

    def alike(self, left: Expression, right: Expression) -> tuple[Expression, ...]:
        """A further value, in degrees where the left side is an angle."""
        angles = self.usage.angles
        return (angular(right, angles) if is_angle(left, angles) else right,)

    def relations(self, segment: Segment) -> None:
        """Reads a chain of relations."""
        sides, signs = sides_of(segment.tokens)
        if not sides[0] and not self._goes_on(segment):
            sides, signs = sides[1:], signs[1:]
        if not sides[-1] and len(sides) > 1 and sides[-2]:
            ending = self.sides(sides[-2])
            sides, sign, signs = sides[:-1], signs[-1], signs[:-1]
            if signs:
                self.chain(segment, sides, signs)
            self.label = None
            self.waiting, self.waiting_sign = ending, sign
            return
        if signs:
            self.chain(segment, sides, signs)

    def _goes_on(self, segment: Segment) -> bool:
        """Whether a relation without a left side goes on from something, or is a fault."""
        if self.waiting or self.label is not None:
            return True
        if not (self.links or self.past.side or self.past.earlier or segment.before):
            return sum(token.kind == "relation" for token in segment.tokens) == 1
        return set(segment.before) <= _CONNECTING

    def chain(self, segment: Segment, sides: list[list[Token]], signs: list[Sign]) -> None:
        """Reads the sides of a chain, and what they state."""
        read: list[tuple[Side, ...]] = []
        for place, tokens in enumerate(sides):
            if place == 0 and self._divides_what_stood_last(tokens):
                below = self.sides(tokens[1:])
                # ÷: tan θ = 3/4 says what is done, and not what is divided.
                read.append((*self.quotients(below), *below))
            elif tokens:
                read.append(self.sides(tokens))
            elif place == 0 and (self.waiting or self.links or self.label or self.past.side):
                read.append(self._side_before())
            else:
                column = segment.tokens[0].column
                if place:
                    ends = sides[place - 1]
                    column = self.line.column(ends[-1].end) if ends else column
                raise UnreadableError("an expression on both sides of the sign", column)
        if not sides[0] and len(signs) > 1 and self.continues and self._is_of_another_kind(read):
            sides, read, signs = sides[1:], read[1:], signs[1:]
        if self.declaration(segment, sides, read, signs):
            return
        name = sides[0][0] if len(sides[0]) == 1 else None
        of_body = name is not None and name.kind == "name" and self.body_of(name) is not None
        if name is not None and of_body and self._is_moving(read[1][0].tree):
            read[0] = vectors_of(name.name, self.problem)  # A = 3i - j
        elif name is not None and of_body and letters(read[1][0].tree) <= self.usage.letters:
            read[0] = (
                *worths_of(name.name, read[1][0].tree, self.problem),
                *read[0],
            )  # B = 2/3 × 3 = 2
        elif name is not None and name.kind == "name" and is_numeric(read[1][0].tree):
            # angle between the path and BC = 80 - 26 = 54: a wall is no number
            sides, read, signs = sides[1:], read[1:], signs[1:]
            name = None
        if not signs:
            return
        short = len(signs) > 1 and is_letter(read[0][0].tree) and is_ratio(read[1][0].tree)
        if short and self.declaration(segment, sides[:2], read[:2], signs[:1]):
            # y = tan δ = 5t/(1 + 6t²) says first what y is.
            sides, read, signs = sides[1:], read[1:], signs[1:]
        read = self.with_owner(_in_hundredths(self.with_factor(read), sides))
        if self._describes(read):
            self.statements.values += tuple(sides[0].tree for sides in read[1:])
            self.pointing(segment.tokens[0], read[1], sides[1])
            return
        angle = self._is_chain_angle(read) or self._is_angle_label()
        before = len(self.links)
        self.label_chain(read, signs, sides)
        if self.alternative(segment, read, signs):
            return
        label = self.links[-1].readings[0].left if len(self.links) > before else read[0][0].tree
        percent = is_percentage(read[0][0].tree) or is_percentage(label)
        share = (Side(_LOST),) if self._ends_in_a_share(label, sides) else ()
        for place, sign in enumerate(signs):
            tokens = [*sides[place], *sides[place + 1]]
            left = (*read[place], *(share if place == len(signs) - 1 else ()))
            self.link(left, sign, read[place + 1], tokens, angle=angle, percent=percent)

    def _is_of_another_kind(self, read: Sequence[tuple[Side, ...]]) -> bool:
        """Whether a chain of vectors goes on from a number: it begins with its first vector."""
        first, second = read[0][0].tree, read[1][0].tree
        known = not letters(first) - self.usage.letters
        return known and self._is_moving(second) and not is_vector(first, self.usage.vectors)

    def _ends_in_a_share(self, label: Expression, sides: Sequence[Sequence[Token]]) -> bool:
        """Whether a chain that works out what is lost ends in its share: ``lost = 3 J = 20%``."""
        words = label.name.split() if isinstance(label, Letter) else []
        lost = any(HEADS.get(word) == "loss" for word in words)
        return lost and [token.kind for token in sides[-1]] == ["number", "percent"]

    def _divides_what_stood_last(self, tokens: Sequence[Token]) -> bool:
        """Whether a side begins with its sign: ``loss = 1/16mu², /(1/2mu²) = 12.5%``."""
        begins = len(tokens) > 1 and tokens[0].kind == "/"
        return begins and bool(self.links or self.past.side)

    def quotients(self, below: Sequence[Side]) -> tuple[Side, ...]:
        """What stood last, or where the chain above it ended, divided."""
        above = self._last_sides() if self.links else (*self.past.side, *self.past.earlier)
        return tuple(Side(Binary("/", a.tree, b.tree)) for a, b in product(above, below))

    def with_owner(self, read: Sequence[tuple[Side, ...]]) -> list[tuple[Side, ...]]:
        """``KE of B = 4 > 0 = KE before``: what names no body may be of that of the chain."""
        phrases = [
            sides[0].tree.name
            for sides in read
            if isinstance(sides[0].tree, Letter) and is_phrase(sides[0].tree.name)
        ]
        owners = {word for name in phrases for word in name.split()} & self.usage.spheres
        if len(owners) != 1 or len(phrases) < 2:
            return list(read)
        (owner,) = owners
        return [
            (*sides, Side(Letter(f"{name} of {owner}")))
            if isinstance(sides[0].tree, Letter)
            and (name := sides[0].tree.name) in phrases
            and owner not in name.split()
            else sides
            for sides in read
        ]

    def _is_chain_angle(self, read: Sequence[tuple[Side, ...]]) -> bool:
        return any(is_angle(sides[0].tree, self.usage.angles) for sides in read)

    def _describes(self, read: Sequence[tuple[Side, ...]]) -> bool:
        """Whether a relation says which way a line points: ``line of centres is 3i + 4j``."""
        first, second = read[0][0].tree, read[1][0].tree
        if not (isinstance(first, Letter) and is_phrase(first.name)):
            return False
        heads = {HEADS[word] for word in first.name.split() if word in HEADS}
        return heads <= {"direction"} and is_vector(second, self.usage.vectors)

    def pointing(self, label: Token, sides: Sequence[Side], tokens: Sequence[Token]) -> None:
        """The line of centres along a vector, as a relation: nothing of the vector is across it.

        So is a wall, which is perpendicular to it.
        """
        words = set(label.name.split())
        impacts = [event for event in self.problem.events if isinstance(event, Impact)]
        if len(impacts) != 1 or words & _TANGENTS:
            return
        wall = words & _WALLS and words <= _OF_WALLS and impacts[0].second in self.walls
        if wall and not words & DIRECTIONS.keys():
            return
        if not wall and not words & _CENTRES:
            return
        kind = "along" if ("perp" in label.name) != bool(wall) else "across"
        line = Quantity("line_of_centres", ())
        right = tuple(Side(Quantity(kind, (side.tree, line))) for side in sides)
        self.link((Side(Number(Fraction(0))),), "=", right, tokens)

    def _is_angle_label(self) -> bool:
        label = self.label
        return label is not None and is_angle(Letter(label.name), self.usage.angles)

    def _side_before(self) -> tuple[Side, ...]:
        """The left side of a line that begins with its sign: the label, or what stood last."""
        if self.waiting:
            sides, self.waiting = self.waiting, ()
            return sides
        if self.label is not None:
            label, self.label = self.label, None
            return (Side(self.label_tree(label, (Side(Number(Fraction(0))),))),)
        if self.links:
            return self._last_sides()
        self.continues = True
        return (*self.past.side, *self.past.earlier)

    def label_chain(
        self,
        read: Sequence[tuple[Side, ...]],
        signs: Sequence[Sign],
        sides: Sequence[Sequence[Token]],
    ) -> None:
        """Makes a label the first link of a chain that works out its value; else drops it."""
        if self.power:
            power, self.power = self.power, ()
            self.link(power, "=", read[0], sides[0])
            return
        if self.label is None:
            return
        label, self.label = self.label, None
        first = read[0][0].tree
        if _is_direction(label) and is_vector(first, self.usage.vectors):
            return  # perp: (5, 10) - 10n = (-3, 4)
        if is_heading(label) and letters(first) and not is_angle(first, self.usage.angles):
            return  # opposite direction: y/x = tan α
        equation = all(_is_lettered_sum(sides[0].tree) for sides in (read[0], read[-1]))
        if label.kind == "phrase" and (equation or self._is_of_squares(first, label)):
            return
        if label.kind == "phrase" and (later := self._calculations()):
            own = {token.value for token in sides[-1] if token.kind == "number"}
            used = any(token.value in own for tokens in later for token in tokens)
            self.label = label if used else None
            return
        if label.kind == "name" or isinstance(first, Letter | Apply):
            self.declared.body = self.statements.body = self.body_of(label)
        known = frozenset[str]().union(*(letters(side.tree) for side in read[0]))
        evaluates = all(letters(sides[0].tree) <= known for sides in read[1:])
        lost = any(HEADS.get(word) == "loss" for word in label.name.split())
        law = is_law(read) and not (lost and known <= self.usage.letters)
        worked = evaluates and set(signs) == {"="}
        evaluates = worked and not law
        if label.kind == "name":
            product = is_binary(first, "*")  # as mass × velocity is
            if evaluates and not product and self._is_moving(first) and self.body_of(label):
                self.link(vectors_of(label.name, self.problem), "=", read[0], sides[0], label)
            elif evaluates and _is_root(first) and self.body_of(label):
                speed = Side(self.label_tree(label, read[0], sides[0]))
                self.link((speed,), "=", read[0], sides[0], label)
            elif worked and is_binary(first, "+", "-") and self.body_of(label):
                # A: 3 - 1.5 = 1.5 is its component, if it is worth that.
                worths = worths_of(label.name, first, self.problem)
                self.link((*worths, *read[0]), "=", read[0], sides[0], label)
            return
        evaluates = evaluates and not (
            _is_direction(label)
            and (self.of_law or self._is_sum_of_letters(first) or self._is_timed(first))
        )
        if label.name == _LAW or (label.name == _LAW_OF_RESTITUTION and letters(first)):
            return
        if evaluates and not isinstance(first, Letter) and not is_ratio(first):
            self.link(self._worth_of(label, first), "=", read[0], sides[0], label)

    def _is_of_squares(self, first: Expression, label: Token) -> bool:
        """Whether a sum of squares is one side of an equation for a letter of the student's own.

        So it is in ``rel vel: 4² + s² = 5²``; of energies it may be the value of the label.
        """
        heads = {HEADS[word] for word in label.name.split() if word in HEADS}
        square = any(is_binary(node, "^") for node in walk(first))
        return square and self._is_sum_of_letters(first) and not heads & {"energy", "loss", "gain"}

    def _worth_of(self, label: Token, first: Expression) -> tuple[Side, ...]:
        """What a label before a chain is: a speed before a sum of squares may be its square."""
        name = Letter(label.name)
        square = any(is_binary(node, "^") for node in walk(first) if node is not first)
        summed = is_binary(first, "+")
        if summed and square and HEADS.get(label.name.split()[0]) in ("speed", "magnitude"):
            return Side(name), Side(Binary("^", name, Number(Fraction(2))))
        return (Side(name), *self.became.get(label.name, ()))

    def _calculations(self) -> list[list[Token]]:
        """The first sides of relations further on that work out numbers, and have no label.

        What a label names comes last, ``deflection: arctan(4/3) = 53.1, 180 - 53.1 - 45 = 81.9``,
        or is none of them.
        """
        calculations: list[list[Token]] = []
        for segment in self.behind:
            (first, *_), _ = sides_of(segment.tokens)
            numeric = any(token.kind == "number" for token in first)
            if any(token.kind in ("phrase", "name") for token in segment.tokens):
                break
            if segment.before and segment.before[-1] in STAGES:
                break  # before 4 + 2 = 6, after 3 - 2 = 1
            named = any(
                token.kind == "letter" and token.name not in self.usage.letters for token in first
            )
            if segment.has_relation and numeric and len(first) > 1 and not named:
                calculations.append(first)
        return calculations

    def _is_timed(self, tree: Expression) -> bool:
        """Whether a side is a product with a time: a distance, and no component."""
        times = {letter for letter in letters(tree) if letter.partition("_")[0] in ("t", "T")}
        return bool(times - self.usage.angles) and is_binary(tree, "*")

    def _is_sum_of_letters(self, tree: Expression) -> bool:
        """Whether a side adds a letter of the student's own: it is no value of a component."""
        own = letters(tree) - self.usage.letters
        return is_binary(tree, "+", "-") and bool(own)

    def alternative(
        self, segment: Segment, read: Sequence[tuple[Side, ...]], signs: Sequence[Sign]
    ) -> bool:
        """``x = 2 or x = 3``: a further value of the last relation."""
        if "or" not in segment.before or not self.links or list(signs) != ["="]:
            return False
        last = self.links[-1].readings[0]
        if last.sign != "=" or last.left != read[0][0].tree:
            return False
        return self.further(read[1], sides_of(segment.tokens)[0][1])

    def link(
        self,
        left: tuple[Side, ...],
        sign: Sign,
        right: tuple[Side, ...],
        tokens: Sequence[Token],
        label: Token | None = None,
        angle: bool = False,
        percent: bool = False,
    ) -> None:
        """Adds a relation with every reading of its two sides."""
        distinct: dict[Claim, None] = {}
        ranked = sorted(product(range(len(left)), range(len(right))), key=sum)
        for first, second in ranked[: 2 * MAX_CLAIMS]:
            sides = left[first], sign, right[second]
            for claim in claims(*sides, angle, self.usage.angles, percent):
                distinct.setdefault(claim)
        whole = [label, *tokens] if label is not None else list(tokens)
        readings = tuple(distinct)[:MAX_CLAIMS]
        start = min((token.column for token in whole), default=1)
        end = max((self.line.column(token.end) for token in whole), default=start)
        figures = (*decimals(tokens, readings), *self._carried(tokens, readings))
        self.links.append(Link(readings, start, end, figures, self.case))

    def _carried(self, tokens: Sequence[Token], readings: Sequence[Claim]) -> Iterator[Decimal]:
        """The decimals of a side that stood before, or in the line above: ``= u/√3``."""
        above = (
            *self.past.decimals,
            *(decimal for link in self.links for decimal in link.decimals),
        )
        if not above:
            return
        numbers = {
            (column, node.value)
            for claim in readings
            for side in (claim.left, claim.right)
            for node in walk(side)
            if isinstance(node, Number | Degrees) and (column := column_of(node)) is not None
        }
        typed = {token.column for token in tokens}
        for decimal in dict.fromkeys(above):
            if decimal.column not in typed and (decimal.column, decimal.value) in numbers:
                yield decimal

    def with_factor(self, read: Sequence[tuple[Side, ...]]) -> list[tuple[Side, ...]]:
        """``5 + 7.5 = 12.5mu²``: the factor of the last side may belong to the sums before it."""
        known = frozenset("mMuU") & self.usage.letters
        last = read[-1][0].tree
        factor = _without_numbers(last) if letters(last) <= known else None
        if factor is None:
            return list(read)
        return [
            (*sides, Side(Binary("*", sides[0].tree, factor)))
            if _is_sum_of_numbers(sides[0].tree)
            else sides
            for sides in read
        ]

    def _is_shorthand(self, left: Letter, right: Expression) -> bool:
        """Whether a letter stands for a sine, a cosine or a tangent: ``t = tan α``."""
        free = left.name in _SHORT_FOR and left.name not in self.usage.letters
        return free and isinstance(right, Apply) and isinstance(right.argument, Letter)

    def _is_of_own_components(self, tree: Expression) -> bool:
        """Whether a vector has letters of the student's own as components: ``v = x i + y j``."""
        own = letters(tree) - self.usage.letters
        moving = bool(own) and self._is_moving(tree)
        return moving and not any(isinstance(node, Apply) for node in walk(tree))

    def _is_worth(self, phrase: str, letter: str) -> bool:
        """Whether a phrase of a speed, a deflection or the like has a letter of the question."""
        words = phrase.split()
        heads = {HEADS.get(word) for word in words}
        known = letter in self.usage.letters and not self.declares
        of_after = "angle" in heads and "after" in words
        return known and (of_after or bool(heads & {"speed", "energy", "impulse", "deflection"}))

    def declaration(
        self,
        segment: Segment,
        sides: Sequence[Sequence[Token]],
        read: Sequence[tuple[Side, ...]],
        signs: Sequence[Sign],
    ) -> bool:
        """Whether a relation declares a letter, and is no claim."""
        if len(signs) != 1 or signs[0] != "=" or not (sides[0] and sides[1]):
            return False
        left, right = read[0][0].tree, read[1][0].tree
        if is_letter(right) and not is_letter(left) and isinstance(left, Letter):
            assert isinstance(right, Letter)
            if self._is_worth(left.name, right.name):
                return False  # speed of B = u
            left, right, sides = right, left, (sides[1], sides[0])
        if not is_letter(left):
            return False
        assert isinstance(left, Letter)
        token = sides[1][0]
        if isinstance(right, Letter) and is_phrase(right.name):
            letters_before = [*self.pending_letters, left]
            self.pending_letters = []
            self.declared.declare_all(letters_before, token)
            return True
        defined = self.defines and not is_numeric(right)
        if self._is_of_own_components(right):
            return False
        if self.declares or defined or self._is_shorthand(left, right):
            text = self.line.text[sides[1][0].start : sides[1][-1].end]
            self.declared.add(Declaration(left.name, tuple(s.tree for s in read[1]), text))
            return True
        return False
