"""What the segments of a line state: relations in all their readings, declarations, values."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import pairwise, permutations, product

from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    Unit,
    letters,
    walk,
)
from restitution.practice.reading.angles import angular, is_angle, without_marks
from restitution.practice.reading.characters import Plain
from restitution.practice.reading.cursor import UnreadableError
from restitution.practice.reading.declarations import Declarations
from restitution.practice.reading.grammar import is_vector
from restitution.practice.reading.phrases import is_phrase
from restitution.practice.reading.readings import Side, read_sides
from restitution.practice.reading.relations import (
    claims,
    decimals,
    finished,
    has_head,
    is_function,
    is_heading,
    is_identity,
    is_law,
    is_letter,
    is_numeric,
    is_percentage,
    sides_of,
)
from restitution.practice.reading.segments import Segment, split_at_spaces
from restitution.practice.reading.tokens import Token, Usage
from restitution.practice.reading.vocabulary import DECLARES, DIRECTIONS, HEADS, STAGES
from restitution.practice.script import Claim, Declaration, Link, Sign
from restitution.problem import Impact, Problem

MAX_CLAIMS = 24
# Letters that stand for a sine, a cosine or a tangent where they are equated with one.
_SHORT_FOR = frozenset("cstCST")
# Words behind which a relation without a left side goes on from the last right one.
_CONNECTING = frozenset(
    ("so", "hence", "therefore", "=>", ",", "and", "or", "then", "thus", "which", "giving", "->")
)
_CONDITIONS = frozenset(("when", "if", "unless", "whenever"))
_PARTING = frozenset(("so", "hence", "therefore", "=>", ";", "thus", ",", "and", "or", "stop", "."))
_ENDING = frozenset(("so", "hence", "therefore", "=>", ";", "thus"))
# The way of a component behind its value: ``A: 3u along, 4u perp``.
_WAY = re.compile(
    r"\s+(along|parallel|perp|perpendicular|across|left|right|up|down)\b(?!\s+to\b)", re.IGNORECASE
)
# Phrases that are names of laws as well: ``momentum: 2u - 3w = -u``, ``restitution: 6e = 4``.
_LAW, _LAW_OF_RESTITUTION = "the momentum", "the restitution"
# Words before a way that say of what it is one: ``CLM along the line of centres: 6 - 4 = v + 2``.
_NAMES_OF_LAWS = frozenset(
    ("clm", "colm", "pclm", "momentum", "mom", "com", "nel", "nlr", "nell", "nli", "restitution")
)
_WAYS = frozenset(("along", "parallel", "perp", "perpendicular", "across"))
_TANGENTS = frozenset(("tangent", "tangential", "common"))
_WALLS = frozenset(("wall", "cushion", "barrier"))
_OF_WALLS = _WALLS | {"parallel", "along", "perp", "perpendicular", "to", "the", "direction", "of"}
_CENTRES = frozenset(("centres", "centers", "centre", "loc"))
_OPERANDS = frozenset(("number", "letter", "name", "unit", "pi", "function", "("))


def _ends_in_a_way(label: Token) -> bool:
    """Whether a label ends in a way, which the vector behind it is: ``comps along 2i - j``."""
    return label.kind == "phrase" and label.name.split()[-1] in _WAYS


def _is_way(label: Token) -> bool:
    """Whether a label names a way and no quantity: ``j direction: 2v + 3w = 4``."""
    heads = {HEADS[word] for word in label.name.split() if word in HEADS}
    return label.kind == "phrase" and heads <= {"direction", "component"}


def _is_power_of_phrase(segment: Segment) -> bool:
    """Whether a segment is the square of a quantity: ``speed^2: 9 + 16 = 25``."""
    return [each.kind for each in segment.tokens] == ["phrase", "^", "number"]


@dataclass(frozen=True)
class Past:
    """What a line may go on from: the last right side, and a left side that waits for one."""

    side: tuple[Side, ...] = ()
    waiting: tuple[Side, ...] = ()
    sign: Sign = "="


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


def read_statements(
    segments: Sequence[Segment],
    usage: Usage,
    problem: Problem,
    number: int,
    line: Plain,
    past: Past,
    whose: str | None = None,
) -> Statements:
    """What the segments of a line state; ``past`` is what the line above left to go on from.

    ``whose`` names the velocity that a vector alone is, behind a heading.
    """
    reader = _Reader(usage, problem, number, line, past, whose)
    for place, segment in enumerate(segments):
        try:
            reader.segment(segment, segments[place + 1 :])
        except UnreadableError as error:
            if segment.has_relation and reader.statements.fault is None:
                reader.statements.fault = f"expected {error.expected}"
                reader.statements.column = error.column
    reader.finish()
    return reader.statements


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


def _is_lettered_sum(tree: Expression) -> bool:
    """Whether a side is a sum with letters: between two of them stands an equation."""
    return isinstance(tree, Binary) and tree.op in ("+", "-") and bool(letters(tree))


def _vectors_of(body: str) -> tuple[Side, ...]:
    """What a vector behind the name of a sphere may be: its velocity, momentum or impulse."""
    phrases = (f"velocity of {body}", f"momentum of {body}", f"impulse on {body}")
    momentum, impulse = (Quantity(kind, (Name(body),)) for kind in ("momentum", "impulse"))
    trees: tuple[Expression, ...] = (*map(Letter, phrases), momentum, impulse, Negate(impulse))
    return tuple(map(Side, trees))


class _Reader:
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
        self.statements = Statements()
        self.links: list[Link] = []
        self.label: Token | None = None
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
        self.behind: Sequence[Segment] = ()
        self.of_law = False

    @property
    def walls(self) -> frozenset[str]:
        """The names of the walls."""
        return frozenset(each.name for each in self.problem.walls)

    def finish(self) -> None:
        """Puts together what was read."""
        self.declared.that_of(self.line.text)
        self.statements.declarations = self.declared.declarations
        self.statements.links = tuple(map(finished, self.links))
        self.statements.values = tuple(map(without_marks, self.statements.values))
        self.statements.supposed = tuple(
            replace(each, left=without_marks(each.left), right=without_marks(each.right))
            for each in self.statements.supposed
        )
        if self.label is not None and self.label.kind == "name" and not self.links:
            self.statements.body = self.body_of(self.label)
        last = self._last_sides() if self.links else (*self.worth, *self.past.side)
        self.statements.past = Past(last, self.waiting, self.waiting_sign)

    def _last_sides(self) -> tuple[Side, ...]:
        rights = dict.fromkeys(claim.right for claim in self.links[-1].readings)
        return tuple(Side(tree) for tree in rights)

    def body_of(self, token: Token) -> str | None:
        """The sphere that a label names."""
        return token.name if token.name in self.usage.spheres else None

    # -- segments -----------------------------------------------------------------------------

    def segment(self, segment: Segment, following: Sequence[Segment]) -> None:
        """Reads a segment: a label, a value, or relations."""
        words = set(segment.before)
        self.behind = following
        if ";" in words:
            self.case = ()
        if words & DECLARES:
            self.declares = True
        elif words & {"so", "hence", "therefore", "=>", ";", "then"}:
            self.declares = False
        elif ":" in words and self.declared.declarations:
            self.declares = False  # let x = 6/M: 17 = 25 - 10x
        if words & _CONDITIONS:
            self.supposes = True
        elif words & _ENDING:
            self.supposes = False
        self.defines = "where" in words or (self.defines and not words - {",", "and"})
        if not any(each.kind in (*_OPERANDS, "|", "phrase", "relation") for each in segment.tokens):
            return
        if segment.is_phrase and self._is_label(segment, following):
            if "only" in following[0].before and not has_head(segment.tokens[0]):
                return  # along only: ½(2)(16 - 4) = 12
            self.label = segment.tokens[0]
            self.of_law = bool(words & _NAMES_OF_LAWS)
            return
        if _is_power_of_phrase(segment) and self._is_label(segment, following):
            self.power = self.sides(segment.tokens)
            return
        if sum(each.kind == "phrase" for each in segment.tokens) > 1 and not segment.has_relation:
            self.titled = True  # mass x velocity: A 12i, B -3i
            return
        if segment.tokens[0].kind == "phrase":
            self.last_label = segment.tokens[0].name
        label = self._label(segment)
        if label is not None:
            self.label, segment = label, replace(segment, tokens=segment.tokens[1:])
        if self._is_of_a_body(segment):
            segment = replace(segment, tokens=segment.tokens[1:])
            if not segment.has_relation:
                self.statements.values += (self.sides(segment.tokens)[0].tree,)
                return
        if not segment.has_relation:
            self.value(segment)
            return
        if self.supposes or segment.rejected:
            self.supposed(segment)
            return
        if self._opens_a_case(segment, following):
            self.case = tuple(self._claims_of(segment))
            self.statements.values += tuple(each.right for each in self.case)
            return
        if is_identity(segment.tokens):
            return
        self.carry(segment)
        parts = list(split_at_spaces(segment))
        for place, (part, parting) in enumerate(parts):
            first = len(self.links)
            self.relations(part)
            if parting != "certain" and 0 < first < len(self.links):
                self.joined(parts[place - 1][0], part, first, parting == "doubtful")

    def carry(self, segment: Segment) -> None:
        """Finds the left side of a relation that begins with its sign behind words.

        It is the value before the words (``v after = 3``), or the last label at another stage
        (``perp before = 4, after = 2``).
        """
        if segment.tokens[0].kind != "relation" or self.waiting:
            return
        if not set(segment.before) & _PARTING:
            self.waiting = self.before
        elif segment.before[-1] in STAGES and self.last_label:
            words = [each for each in self.last_label.split() if each not in STAGES]
            self.waiting = (Side(Letter(" ".join((*words, segment.before[-1])))),)
        self.before = ()

    def supposed(self, segment: Segment) -> None:
        """What stands behind *when* or *if* is no claim; its sides are values of a remark."""
        sides, _ = sides_of(segment.tokens)
        read = [self.sides(tokens)[0].tree for tokens in sides if tokens]
        self.statements.values += tuple(read)
        if self.supposes:
            self.statements.supposed += tuple(self._claims_of(segment))

    def _claims_of(self, segment: Segment) -> Iterator[Claim]:
        """The relations of a segment in their first reading."""
        sides, signs = sides_of(segment.tokens)
        for sign, (left, right) in zip(signs, pairwise(sides), strict=False):
            if left and right:
                yield Claim(self.sides(left)[0].tree, sign, self.sides(right)[0].tree)

    def _opens_a_case(self, segment: Segment, following: Sequence[Segment]) -> bool:
        """Whether a letter of the question has a value, or a bound, for what is behind a colon.

        ``e = 0: v = u/2; e = 1: v = 2u`` claims neither that e is 0 nor that it is 1.
        """
        if not following or following[0].before[:1] != (":",) or not following[0].has_relation:
            return False
        claims_ = list(self._claims_of(segment))
        return len(claims_) == 1 and any(
            isinstance(one, Letter) and one.name in self.usage.letters and is_numeric(other)
            for one, other in permutations((claims_[0].left, claims_[0].right))
        )

    def joined(self, before: Segment, behind: Segment, first: int, rather: bool) -> None:
        """Adds the readings of ``w = 0.6u v = 2`` as a chain to those of two relations."""
        middle = [*sides_of(before.tokens)[0][-1], *sides_of(behind.tokens)[0][0]]
        try:
            chained = [side.tree for side in self.sides(middle)]
        except UnreadableError:
            return
        above, below = self.links[first - 1], self.links[first]
        pairs = [(tree, each) for tree in chained for each in above.readings]
        upper = tuple(dict.fromkeys(replace(each, right=tree) for tree, each in pairs))
        pairs = [(tree, each) for tree in chained for each in below.readings]
        lower = tuple(dict.fromkeys(replace(each, left=tree) for tree, each in pairs))
        half = MAX_CLAIMS // 2
        for place, whole, parted in (
            (first - 1, upper[:half], above.readings[:half]),
            (first, lower[:half], below.readings[:half]),
        ):
            readings = (*whole, *parted) if rather else (*parted, *whole)
            self.links[place] = replace(self.links[place], readings=readings)

    def _is_label(self, segment: Segment, following: Sequence[Segment]) -> bool:
        """Whether a phrase, or a name, labels what follows."""
        if not following or (self.pending_letters and ":" in segment.before):
            return False
        between = set(following[0].before)
        begins = following[0].tokens[0].kind == "relation"
        if segment.tokens[0].kind == "name":
            return between == {":"} or (begins and not between & _ENDING)
        named = ":" in between and not between & _ENDING
        begins = begins and not between & _ENDING
        return begins or named or between <= {"by", "of", "as", "to", "about", "only"}

    def _label(self, segment: Segment) -> Token | None:
        """A phrase with mathematics directly behind it."""
        first = segment.tokens[0]
        if first.kind != "phrase" or len(segment.tokens) < 2:
            return None
        if segment.tokens[1].kind == "-" and segment.tokens[1].gap and len(segment.tokens) > 2:
            sign = not segment.tokens[2].gap and segment.tokens[2].kind != "phrase"
            return first if sign else None  # along -u cos 60 = -u/2
        return first if segment.tokens[1].kind in (*_OPERANDS, "|") else None

    def _is_of_a_body(self, segment: Segment) -> bool:
        """Whether a body's name only says whose the numbers are: ``A 5 cos α = 4``, ``B -3``."""
        tokens = segment.tokens
        if len(tokens) < 2 or tokens[0].kind != "name":
            return False
        if any(each.kind == "unit" for each in tokens):
            return False  # a velocity
        loose = tokens[1].kind == "-" and tokens[1].gap > 0
        tight = loose and len(tokens) > 2 and not tokens[2].gap
        return tight or (tokens[1].kind in ("number", "function") and tokens[1].gap > 0)

    def sides(self, tokens: Sequence[Token]) -> tuple[Side, ...]:
        """The readings of a side."""
        end = tokens[-1] if tokens else None
        column = self.line.column(end.end) if end else self.line.column(len(self.line.text))
        return read_sides(tokens, self.usage, self.number, column)

    def value(self, segment: Segment) -> None:
        """A segment without a relation: a further value, the value of a label, or a remark."""
        tokens = segment.tokens
        if self.pending(segment) or self._names_its_way(segment):
            return
        if tokens[0].name in self.usage.spheres and self.velocities(tokens):
            return
        sides = self.before = self.sides(tokens)
        words = set(segment.before)
        if self.label is not None and tokens[0].name in self.usage.spheres:
            self.label = None  # relative to the mass centre: A 2, B -3
        if self.label is not None:
            label, self.label = self.label, None
            vector = is_vector(sides[0].tree, self.usage.vectors)
            if vector and (not has_head(label) or _ends_in_a_way(label)):
                self.statements.values += (sides[0].tree,)
                self.pointing(label, sides, tokens)
            elif not isinstance(sides[0].tree, Name):
                self.labelled(label, sides, tokens)
            return
        listed = words & {"or", ","} and not words - {"or", ",", "and", "either"}
        if self.links and listed and self.further(sides):
            return
        waiting, sign = self._waiting(segment)
        if waiting:
            self.link(waiting, sign, sides, tokens)
            return
        tree = sides[0].tree
        if self.whose and not self.links and not segment.before and self._is_moving(tree):
            self.link((Side(Letter(self.whose)),), "=", sides, tokens)
            return
        if len(tokens) == 1 and isinstance(tree, Letter) and not is_phrase(tree.name):
            if self.declared.another(tree, words):
                return
            self.pending_letters.append(tree)
        if [each.kind for each in tokens] == ["letter", "-", "phrase"] and tokens[1].gap:
            self.declared.declare(Letter(tokens[0].name), tokens[2])
            return
        if not isinstance(sides[0].tree, Name) and tokens[0].kind != "phrase":
            self.statements.values += (sides[0].tree,)
            if not isinstance(sides[0].tree, Letter | Number):
                self.worth = sides[:1]  # the next line may go on from it with a sign

    def _names_its_way(self, segment: Segment) -> bool:
        """Whether a vector alone says which way a label goes: ``A along n: (20 + 30)/5``."""
        label, tokens = self.label, segment.tokens
        vector = tokens[0].kind == "unit" or tokens[0].name in self.usage.vectors
        alone = len(tokens) == 1 and vector and not segment.before
        return alone and label is not None and _ends_in_a_way(label)

    def _is_moving(self, tree: Expression) -> bool:
        """Whether a vector may be a velocity: it is no letter alone."""
        return is_vector(tree, self.usage.vectors) and not isinstance(tree, Letter | Unit)

    def velocities(self, tokens: Sequence[Token]) -> bool:
        """Velocities with the bodies before them: ``A 3i + 5j  B 2i - j``."""
        places = [n for n, each in enumerate(tokens) if each.kind == "name"]
        stretches = [tokens[a + 1 : b] for a, b in pairwise((*places, len(tokens)))]
        if not all(stretches):
            return False
        read = [self.sides(each) for each in stretches]
        if not all(is_vector(each[0].tree, self.usage.vectors) for each in read):
            return False
        for place, stretch, sides in zip(places, stretches, read):
            if self.titled:
                self.statements.values += (sides[0].tree,)
            else:
                self.labelled(tokens[place], sides, stretch)
        return True

    def _waiting(self, segment: Segment) -> tuple[tuple[Side, ...], Sign]:
        """The left side that waits for its right one, on this line or the one above."""
        if self.waiting:
            sides, sign = self.waiting, self.waiting_sign
            self.waiting = ()
            return (() if set(segment.before) & _ENDING else sides), sign
        if self.past.waiting and not self.links:
            sides, self.past = self.past.waiting, replace(self.past, waiting=())
            return sides, self.past.sign
        return (), "="

    def pending(self, segment: Segment) -> bool:
        """A letter with a colon before a phrase: ``v: component of A after``."""
        token = segment.tokens[0]
        if not (segment.is_phrase and self.pending_letters):
            return False
        if token.kind == "phrase" and ":" in segment.before:
            self.declared.declare(self.pending_letters[-1], token)
            return True
        return False

    def labelled(self, label: Token, sides: tuple[Side, ...], tokens: Sequence[Token]) -> None:
        """The value of a label: ``A: 3i - 2j``, ``KE after: 12``.

        What may be negative, ``A: u(2 - 3e)``, may be a component rather than a speed.
        """
        own = [Side(self.label_tree(label, sides, tokens))]
        signed = any(
            isinstance(each, Negate) or (isinstance(each, Binary) and each.op == "-")
            for each in walk(sides[0].tree)
        )
        if label.name in self.usage.spheres and own[0].tree == Letter(f"speed of {label.name}"):
            own += [Side(Letter(f"component of {label.name} along"))] if signed else []
        self.link(tuple(own), "=", sides, tokens, label)

    def label_tree(
        self, label: Token, sides: tuple[Side, ...], tokens: Sequence[Token] = ()
    ) -> Expression:
        """A label as a letter; a body's name is its velocity, its speed or a component."""
        if label.kind == "phrase":
            return Letter(label.name)
        direction = _WAY.match(self.line.text, tokens[-1].end) if tokens else None
        if direction is not None:
            return Letter(f"component of {label.name} {direction[1].lower()}")
        vector = is_vector(sides[0].tree, self.usage.vectors)
        return Letter(f"{'velocity' if vector else 'speed'} of {label.name}")

    def further(self, sides: tuple[Side, ...]) -> bool:
        """A second value of the last relation: ``x = 2 or 3``."""
        last = self.links[-1]
        first = last.readings[0]
        if first.sign != "=" or letters(first.left) & letters(sides[0].tree):
            return False
        readings = tuple(
            replace(each, others=(*each.others, *self.alike(each.left, sides[0].tree)))
            for each in last.readings
        )
        self.links[-1] = replace(last, readings=readings)
        return True

    def alike(self, left: Expression, right: Expression) -> tuple[Expression, ...]:
        """A further value, in degrees where the left side is an angle."""
        angles = self.usage.angles
        return (angular(right, angles) if is_angle(left, angles) else right,)

    # -- relations ----------------------------------------------------------------------------

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
        return set(segment.before) <= _CONNECTING

    def chain(self, segment: Segment, sides: list[list[Token]], signs: list[Sign]) -> None:
        """Reads the sides of a chain, and what they state."""
        read: list[tuple[Side, ...]] = []
        for place, tokens in enumerate(sides):
            if tokens:
                read.append(self.sides(tokens))
            elif place == 0 and (self.waiting or self.links or self.label or self.past.side):
                read.append(self._side_before())
            else:
                column = segment.tokens[0].column
                if place:
                    ends = sides[place - 1]
                    column = self.line.column(ends[-1].end) if ends else column
                raise UnreadableError("an expression on both sides of the sign", column)
        if self.declaration(segment, sides, read, signs):
            return
        read = self.with_factor(read)
        if self._describes(read):
            self.statements.values += tuple(each[0].tree for each in read[1:])
            self.pointing(segment.tokens[0], read[1], sides[1])
            return
        angle = self._is_chain_angle(read) or self._is_angle_label()
        before = len(self.links)
        self.label_chain(read, signs, sides)
        if self.alternative(segment, read, signs):
            return
        label = self.links[-1].readings[0].left if len(self.links) > before else None
        percent = is_percentage(read[0][0].tree) or (label is not None and is_percentage(label))
        for place, sign in enumerate(signs):
            tokens = [*sides[place], *sides[place + 1]]
            self.link(read[place], sign, read[place + 1], tokens, angle=angle, percent=percent)

    def _is_chain_angle(self, read: Sequence[tuple[Side, ...]]) -> bool:
        return any(is_angle(each[0].tree, self.usage.angles) for each in read)

    def _describes(self, read: Sequence[tuple[Side, ...]]) -> bool:
        """Whether a relation says which way a line points: ``line of centres is 3i + 4j``."""
        first, second = read[0][0].tree, read[1][0].tree
        if not (isinstance(first, Letter) and is_phrase(first.name)):
            return False
        heads = {HEADS[each] for each in first.name.split() if each in HEADS}
        return heads <= {"direction"} and is_vector(second, self.usage.vectors)

    def pointing(self, label: Token, sides: Sequence[Side], tokens: Sequence[Token]) -> None:
        """The line of centres along a vector, as a relation: nothing of the vector is across it.

        So is a wall, which is perpendicular to it.
        """
        words = set(label.name.split())
        impacts = [each for each in self.problem.events if isinstance(each, Impact)]
        if len(impacts) != 1 or words & _TANGENTS:
            return
        wall = words & _WALLS and words <= _OF_WALLS and impacts[0].second in self.walls
        if wall and not words & DIRECTIONS.keys():
            return
        if not wall and not words & _CENTRES:
            return
        kind = "along" if ("perp" in label.name) != bool(wall) else "across"
        line = Quantity("line_of_centres", ())
        right = tuple(Side(Quantity(kind, (each.tree, line))) for each in sides)
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
        return self._last_sides() if self.links else self.past.side

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
        if _is_way(label) and is_vector(first, self.usage.vectors):
            return  # perp: (5, 10) - 10n = (-3, 4)
        if is_heading(label) and letters(first) and not is_angle(first, self.usage.angles):
            return  # opposite direction: y/x = tan α
        equation = all(_is_lettered_sum(each[0].tree) for each in (read[0], read[-1]))
        if equation and label.kind == "phrase":
            return
        if label.kind == "phrase" and (later := self._calculations()):
            own = {each.value for each in sides[-1] if each.kind == "number"}
            used = any(each.value in own for tokens in later for each in tokens)
            self.label = label if used else None
            return
        if label.kind == "name" or isinstance(first, Letter | Apply):
            self.declared.body = self.statements.body = self.body_of(label)
        known = frozenset[str]().union(*(letters(each.tree) for each in read[0]))
        evaluates = all(letters(each[0].tree) <= known for each in read[1:])
        evaluates = evaluates and set(signs) == {"="} and not is_law(read)
        if label.kind == "name":
            product = isinstance(first, Binary) and first.op == "*"  # as mass × velocity is
            if evaluates and not product and self._is_moving(first) and self.body_of(label):
                self.link(_vectors_of(label.name), "=", read[0], sides[0], label)
            return
        evaluates = evaluates and not (
            _is_way(label) and (self.of_law or self._is_sum_of_letters(first))
        )
        if label.name == _LAW or (label.name == _LAW_OF_RESTITUTION and letters(first)):
            return
        if evaluates and not isinstance(first, Letter) and not is_function(first):
            self.link(self._worth_of(label, first), "=", read[0], sides[0], label)

    def _worth_of(self, label: Token, first: Expression) -> tuple[Side, ...]:
        """What a label before a chain is: a speed before a sum of squares may be its square."""
        name = Letter(label.name)
        square = any(
            isinstance(each, Binary) and each.op == "^" for each in walk(first) if each is not first
        )
        summed = isinstance(first, Binary) and first.op == "+"
        if summed and square and HEADS.get(label.name.split()[0]) in ("speed", "magnitude"):
            return Side(name), Side(Binary("^", name, Number(Fraction(2))))
        return (Side(name),)

    def _calculations(self) -> list[list[Token]]:
        """The first sides of relations further on that work out numbers, and have no label.

        What a label names comes last, ``deflection: arctan(4/3) = 53.1, 180 - 53.1 - 45 = 81.9``,
        or is none of them.
        """
        found: list[list[Token]] = []
        for segment in self.behind:
            (first, *_), _ = sides_of(segment.tokens)
            numeric = any(each.kind == "number" for each in first)
            if any(each.kind in ("phrase", "name") for each in segment.tokens):
                break
            named = any(
                each.kind == "letter" and each.name not in self.usage.letters for each in first
            )
            if segment.has_relation and numeric and len(first) > 1 and not named:
                found.append(first)
        return found

    def _is_sum_of_letters(self, tree: Expression) -> bool:
        """Whether a side adds a letter of the student's own: it is no value of a component."""
        own = letters(tree) - self.usage.letters
        return isinstance(tree, Binary) and tree.op in ("+", "-") and bool(own)

    def alternative(
        self, segment: Segment, read: Sequence[tuple[Side, ...]], signs: Sequence[Sign]
    ) -> bool:
        """``x = 2 or x = 3``: a further value of the last relation."""
        if "or" not in segment.before or not self.links or list(signs) != ["="]:
            return False
        last = self.links[-1].readings[0]
        if last.sign != "=" or last.left != read[0][0].tree:
            return False
        return self.further(read[1])

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
        start = min((each.column for each in whole), default=1)
        end = max((self.line.column(each.end) for each in whole), default=start)
        figures = tuple(decimals(tokens, readings))
        self.links.append(Link(readings, start, end, figures, self.case))

    def with_factor(self, read: Sequence[tuple[Side, ...]]) -> list[tuple[Side, ...]]:
        """``5 + 7.5 = 12.5mu²``: the factor of the last side may belong to the sums before it."""
        known = frozenset("mMuU") & self.usage.letters
        last = read[-1][0].tree
        factor = _without_numbers(last) if letters(last) <= known else None
        if factor is None:
            return list(read)
        return [
            (*each, Side(Binary("*", each[0].tree, factor)))
            if isinstance(each[0].tree, Binary) and not letters(each[0].tree)
            else each
            for each in read
        ]

    # -- declarations ---------------------------------------------------------------------------

    def _is_shorthand(self, left: Letter, right: Expression) -> bool:
        """Whether a letter stands for a sine, a cosine or a tangent: ``t = tan α``."""
        free = left.name in _SHORT_FOR and left.name not in self.usage.letters
        return free and isinstance(right, Apply) and isinstance(right.argument, Letter)

    def _is_worth(self, phrase: str, letter: str) -> bool:
        """Whether a phrase of a speed, an energy or an impulse has a letter of the question."""
        heads = {HEADS.get(word) for word in phrase.split()}
        known = letter in self.usage.letters and not self.declares
        return known and bool(heads & {"speed", "energy", "impulse"})

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
        if self.declares or defined or self._is_shorthand(left, right):
            text = self.line.text[sides[1][0].start : sides[1][-1].end]
            self.declared.add(Declaration(left.name, tuple(s.tree for s in read[1]), text))
            return True
        return False
