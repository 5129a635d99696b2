"""What the segments of a line state: relations in all their readings, declarations, values."""

from __future__ import annotations

import re
from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace
from itertools import pairwise, permutations

from restitution.expression.quantities import ENERGIES
from restitution.expression.tree import (
    Apply,
    Expression,
    Letter,
    Name,
    Number,
    is_binary,
    is_quantity,
    walk,
)
from restitution.practice.reading.angles import without_marks
from restitution.practice.reading.bodies import places_of, worths_of
from restitution.practice.reading.chains import Chains, Past, Statements
from restitution.practice.reading.characters import Plain
from restitution.practice.reading.cursor import UnreadableError
from restitution.practice.reading.grammar import is_vector
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.reading.phrases import read_phrase
from restitution.practice.reading.readings import Side
from restitution.practice.reading.relations import (
    finished,
    has_head,
    is_identity,
    is_numeric,
    sides_of,
)
from restitution.practice.reading.segments import Segment, split_at_spaces
from restitution.practice.reading.tokens import Token, Usage
from restitution.practice.reading.vocabulary import DECLARES, HEADS, STAGES
from restitution.practice.script import Claim, Sign
from restitution.problem import Find, Problem, Value

_CONDITIONS = frozenset(("when", "if", "unless", "whenever"))
_PARTING = frozenset(("so", "hence", "therefore", "=>", ";", "thus", ",", "and", "or", "stop", "."))
_ENDING = frozenset(("so", "hence", "therefore", "=>", ";", "thus"))
# Words before a direction that say of what: ``CLM along the line of centres: 6 - 4 = v + 2``.
_NAMES_OF_LAWS = frozenset(
    ("clm", "colm", "pclm", "momentum", "mom", "com", "nel", "nlr", "nell", "nli", "restitution")
)
_CONCLUDING = _ENDING | {"%", "percentage", "ans", "answer", "which", "giving"}
# What may stand behind a percentage alone: ``60% of the KE is lost``.
_LOST_BEHIND = re.compile(r"\s*(?:(?:is|was|are|of KE|of energy)\s+)*lost\b", re.IGNORECASE)
_BETWEEN_BEHIND = re.compile(r"\s*between(\s+(them|paths|A and B))?\s*\.?$", re.IGNORECASE)
_OF_A_SHARE = re.compile(
    r"\s*(?:(?:of\s+(?:the\s+)?)?(?:K\.?E\.?|(?:kinetic\s+)?energy)\s*)?(?:is\s+|was\s+)?(lost|loss)?[\s.!]*",
    re.IGNORECASE,
)
_STAGED = re.compile(rf"\s*({'|'.join(sorted(STAGES))})\b\s*(?:,|;|and\b)", re.IGNORECASE)
_DIVIDING = frozenset(("divide", "divided", "dividing"))
_INFERRING = frozenset(("so", "hence", "therefore", "thus", "giving", "gives", "=>", "==>", "->"))
# What may stand behind an angle; 6 along is none.
_AT_THE_END = re.compile(r"\s*(?:$|[,;.)]|(?:to|with|from|above|below)\b)")
_GIVING = frozenset(("gives", "giving", "get", "leaves", "leaving", "->", ":"))
_OF_DIRECTIONS = frozenset(("along", "parallel", "perp", "perpendicular", "across"))
_SIZES = frozenset(("the speed", "the size", "the magnitude"))
_OPERANDS = frozenset(("number", "letter", "name", "unit", "pi", "function", "("))
_OF_NUMBERS = frozenset(("number", "+", "-", "*", "/", "dot", "times", "^", "(", ")"))


def _ends_in_a_direction(label: Token) -> bool:
    """Whether a label ends in a direction, which a vector behind it is: ``comps along 2i - j``."""
    return label.kind == "phrase" and label.name.split()[-1] in _OF_DIRECTIONS


def _is_of_parts(label: Token) -> bool:
    """Whether a label names components, whose speed is no value of them."""
    return {HEADS[word] for word in label.name.split() if word in HEADS} == {"component"}


def _names_a_direction(label: Sequence[str]) -> bool:
    """Whether a label names a direction and perhaps a moment: ``perp``, ``along before``."""
    words = set(label) - {"the", "of"}
    known = (
        {word for word, head in HEADS.items() if head == "component"}
        | STAGES.keys()
        | _OF_DIRECTIONS
    )
    return bool(words & _OF_DIRECTIONS) and words <= known


def _is_power_of_phrase(segment: Segment) -> bool:
    """Whether a segment is the square of a quantity: ``speed^2: 9 + 16 = 25``."""
    return [token.kind for token in segment.tokens] == ["phrase", "^", "number"]


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


def _asks_time(problem: Problem) -> bool:
    """Whether a question asks for a time."""
    return any(
        isinstance(item, Value) and any(is_quantity(x, "time") for x in walk(item.expression))
        for _, step in problem.steps()
        for item in (step.items if isinstance(step, Find) else ())
    )


def _is_share(tree: Expression) -> bool:
    """Whether a quantity that is asked is a share of an energy."""
    return is_binary(tree, "/") and is_quantity(tree.left, *ENERGIES)


class _Reader(Chains):
    """Reads segment after segment."""

    def finish(self) -> None:
        """Puts together what was read."""
        self.declared.that_of(self.line.text)
        if not self.declared.declarations:
            self.declared.having(self.line.text)
        self._without_declared()
        self.statements.declarations = self.declared.declarations
        self.statements.links = tuple(map(finished, self.links))
        self.statements.values = tuple(map(without_marks, self.statements.values))
        self.statements.supposed = tuple(
            replace(claim, left=without_marks(claim.left), right=without_marks(claim.right))
            for claim in self.statements.supposed
        )
        if self.label is not None and self.label.kind == "name" and not self.links:
            self.statements.body = self.body_of(self.label)
        if self.statements.fault and not self.links:
            return  # nothing is known of what the next line goes on from
        last = self._last_sides() if self.links else (*self.worth, *self.past.side)
        aside = bool(self.links) and not self.continues
        earlier = self.past.side if aside else self.past.earlier
        figures = self.links[-1].decimals if self.links else self.past.decimals
        self.statements.past = Past(last, earlier, self.waiting, self.waiting_sign, figures)

    def _without_declared(self) -> None:
        """Drops relations that only give a letter to a phrase which declares it."""
        declared = {declaration.letter for declaration in self.declared.declarations}
        self.links = [
            link
            for link in self.links
            if not (
                isinstance(link.readings[0].left, Letter)
                and is_phrase(link.readings[0].left.name)
                and isinstance(link.readings[0].right, Letter)
                and link.readings[0].right.name in declared
            )
        ]

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
        if self._is_under_case(segment, following):
            self.supposes, self.case = False, self.condition
        if words & _CONDITIONS:
            self.supposes = True
        elif words & _ENDING or self._is_implied(words):
            self.supposes = False
        self.defines = "where" in words or (self.defines and not words - {",", "and"})
        if not any(
            token.kind in (*_OPERANDS, "|", "phrase", "relation") for token in segment.tokens
        ):
            return
        relative = not {"rel", "relative"}.isdisjoint(self.last_label.split())
        if relative and segment.tokens[0].name in _SIZES:
            own = replace(segment.tokens[0], name="relative speed")
            segment = replace(segment, tokens=(own, *segment.tokens[1:]))
        if segment.is_phrase and self._is_label(segment, following):
            if "only" in following[0].before and not has_head(segment.tokens[0]):
                return  # along only: ½(2)(16 - 4) = 12
            self.label, self.before = self._of_its_direction(segment.tokens[0]), ()
            self.of_law = bool(words & _NAMES_OF_LAWS)
            return
        if _is_power_of_phrase(segment) and self._is_label(segment, following):
            self.power = self.sides(segment.tokens)
            return
        if sum(token.kind == "phrase" for token in segment.tokens) > 1 and not segment.has_relation:
            self.titled = True  # mass x velocity: A 12i, B -3i
            return
        if segment.tokens[0].kind == "phrase":
            self.last_label = segment.tokens[0].name
        label = self._label(segment)
        if label is not None:
            self.label, segment = label, replace(segment, tokens=segment.tokens[1:])
        named = [x.kind for x in segment.tokens[:2]] == ["name", "relation"]
        if self.direction is not None and named:
            own = replace(self._of_its_direction(segment.tokens[0]), kind="phrase")
            self.label, segment = None, replace(segment, tokens=(own, *segment.tokens[1:]))
        if self._is_of_a_body(segment) and self.direction is not None and not segment.has_relation:
            self.label = self._of_its_direction(segment.tokens[0])
            segment = replace(segment, tokens=segment.tokens[1:])
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
            self.statements.values += tuple(claim.right for claim in self.case)
            return
        if is_identity(segment.tokens):
            return
        if self._is_of_a_time(segment):
            self.label = replace(segment.tokens[0], kind="phrase", name="the time", text="")
        if self._is_of_a_percentage(segment):
            name = "the percentage"
            self.label = replace(segment.tokens[0], kind="phrase", name=name, text="")
        self.relabel(segment)
        self.carry(segment)
        parts = list(split_at_spaces(segment, self.usage.vectors))
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
            words = [word for word in self.last_label.split() if word not in STAGES]
            self.waiting = (Side(Letter(" ".join((*words, segment.before[-1])))),)
        self.before = ()

    def relabel(self, segment: Segment) -> None:
        """Takes the last label at another stage: ``A before along 4 = 2 + 2, after 3 - 2 = 1``."""
        stage = next((word for word in reversed(segment.before) if word != ":"), "")
        words = self.last_label.split()
        if stage not in STAGES or STAGES.keys().isdisjoint(words) or stage in words:
            return
        if segment.tokens[0].kind in ("number", "function", "(", "-"):
            name = " ".join(stage if word in STAGES else word for word in words)
            self.label = replace(segment.tokens[0], kind="phrase", name=name, text=name)

    def supposed(self, segment: Segment) -> None:
        """What stands behind *when* or *if* is no claim; its sides are values of a remark."""
        sides, _ = sides_of(segment.tokens)
        read = [self.sides(tokens)[0].tree for tokens in sides if tokens]
        self.statements.values += tuple(read)
        if self.supposes:
            self.statements.supposed += tuple(self._claims_of(segment))
            self.condition = self._case_in(segment)

    def _opens_a_case(self, segment: Segment, following: Sequence[Segment]) -> bool:
        """Whether a letter of the question has a value, or a bound, for what is behind a colon.

        ``e = 0: v = u/2; e = 1: v = 2u`` claims neither that e is 0 nor that it is 1, and
        ``e = 1 gives v = 2u`` does not either.
        """
        opening = following[0].before[:1] if following else ()
        if opening not in ((":",), ("gives",), ("giving",)):
            return False
        if opening == (":",) and not following[0].has_relation:
            return False
        return bool(self._case_in(segment))

    def _case_in(self, segment: Segment) -> tuple[Claim, ...]:
        """The relation of a segment, if it puts a number for a letter of the question."""
        claims = tuple(self._claims_of(segment))
        single = len(claims) == 1 and any(
            isinstance(one, Letter) and one.name in self.usage.letters and is_numeric(other)
            for one, other in permutations((claims[0].left, claims[0].right))
        )
        return claims if single else ()

    def _is_implied(self, words: AbstractSet[str]) -> bool:
        """Whether a relation is what an inequality leads to: ``if v < 0 → 2 - k < 0``."""
        leads = "then" in words or any(word.endswith((">", "→")) for word in words)
        supposed = self.statements.supposed if self.supposes and leads else ()
        return bool(supposed) and all(claim.sign != "=" for claim in supposed)

    def _is_under_case(self, segment: Segment, following: Sequence[Segment]) -> bool:
        """Whether a relation holds in the case before it: ``least when e = 0, v = u cos α``."""
        parted = segment.before in ((",",), (":",)) and segment.has_relation
        further = any(
            _CONDITIONS & set(segment.before) or "then" in segment.before for segment in following
        )
        return self.supposes and bool(self.condition) and parted and not further

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

    def _of_its_direction(self, label: Token) -> Token:
        """A label; of a body behind a direction, ``perp: A: 3, B: -2``, that of its component."""
        if label.kind == "phrase":
            own = [word for word in label.name.split() if word not in self.usage.spheres]
            self.direction = replace(label, name=" ".join(own)) if _names_a_direction(own) else None
        if self.direction is None or label.name not in self.usage.spheres:
            return label
        return replace(self.direction, name=f"{self.direction.name} of {label.name}")

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
        """Whether a body's name only says whose the numbers are: ``A u cos α = 4``, ``B -3``."""
        tokens = segment.tokens
        if len(tokens) < 2 or tokens[0].kind != "name":
            return False
        if any(token.kind == "unit" for token in tokens):
            # A 3i + j is a velocity, and A (5i + 3j).(2i + j) = 13 a component of it.
            first = sides_of(tokens)[0][0][1:]
            product = segment.has_relation and any(token.kind == "dot" for token in first)
            return product and tokens[1].kind == "(" and tokens[1].gap > 0
        loose = tokens[1].kind == "-" and tokens[1].gap > 0
        tight = loose and len(tokens) > 2 and not tokens[2].gap
        glued = tokens[1].kind == "letter" and (len(tokens) == 2 or tokens[2].kind in _OPERANDS)
        return tight or ((tokens[1].kind in ("number", "function") or glued) and tokens[1].gap > 0)

    def value(self, segment: Segment) -> None:
        """A segment without a relation: a further value, the value of a label, or a remark."""
        tokens = segment.tokens
        if self.pending(segment) or self._names_its_direction(segment):
            return
        if tokens[0].name in self.usage.spheres and self.velocities(tokens):
            return
        if self._is_divisor(segment):
            below = self.sides(tokens[1:] if tokens[0].kind == "/" else tokens)
            self.waiting = self.quotients(below)
            return
        if self.label is None:
            self.relabel(segment)
        sides = self.before = self.sides(tokens)
        if tokens[-1].kind == "measure" and tokens[-1].name == "s":
            self.before = ()  # 1 s later AB = 2i + j
        words = set(segment.before)
        if self.label is not None and tokens[0].name in self.usage.spheres:
            self.label = None  # relative to the mass centre: A 2, B -3
        if self.label is not None and segment.before == ("of",) and _is_of_parts(self.label):
            self.label = None
            return  # comps of 3u: 3u cos θ and 3u sin θ
        if self.label is not None and self._becomes(self.label):
            self.becoming(self.label, sides, tokens)
            return
        if self.label is not None:
            label, self.label = self.label, None
            vector = is_vector(sides[0].tree, self.usage.vectors)
            if vector and (not has_head(label) or _ends_in_a_direction(label)):
                self.statements.values += (sides[0].tree,)
                self.pointing(label, sides, tokens)
            elif not isinstance(sides[0].tree, Name):
                self.labelled(label, sides, tokens)
            return
        if (angle := self._angle_of_ratio(segment)) is not None:
            self.link((Side(angle),), "=", sides, tokens, angle=True)
            return
        listed = words & {"or", ","} and not words - {"or", ",", "and", "either"}
        if self.links and listed and (segment.is_phrase or self.further(sides, tokens)):
            return  # I = -8i + 16j, perpendicular to the wall: a phrase is no value
        waiting, sign = self._waiting(segment)
        if waiting:
            self.link(waiting, sign, sides, tokens)
            return
        if (share := self._share(segment) or self._amount(segment)) is not None:
            self.link((Side(share),), "=", self.sides(tokens[:2]), tokens[:2])
            return
        tree = sides[0].tree
        named = any(token.kind == "phrase" for token in tokens)  # parallel to i - 3j
        alone = not (self.links or segment.before or named)
        if self.whose and alone and self._is_moving(tree):
            self.link((Side(Letter(self.whose)),), "=", sides, tokens)
            return
        if len(tokens) == 1 and isinstance(tree, Letter) and not is_phrase(tree.name):
            if self.declared.another(tree, words):
                return
            self.pending_letters.append(tree)
        if [token.kind for token in tokens] == ["letter", "-", "phrase"] and tokens[1].gap:
            self.declared.declare(Letter(tokens[0].name), tokens[2])
            return
        if not isinstance(sides[0].tree, Name) and tokens[0].kind != "phrase":
            self.statements.values += (sides[0].tree,)
            if not isinstance(sides[0].tree, Letter | Number):
                self.worth = sides[:1]  # the next line may go on from it with a sign

    def _angle_of_ratio(self, segment: Segment) -> Expression | None:
        """The angle whose sine, cosine or tangent stands before: ``tan θ = 0.56 so 29.2°``."""
        kinds = [token.kind for token in segment.tokens]
        words = set(segment.before)
        inferred = bool(words & _INFERRING) and not words & STAGES.keys()
        inferred = inferred and bool(_AT_THE_END.match(self.line.text, segment.tokens[-1].end))
        if kinds != ["number", "degrees"] and not (kinds == ["number"] and inferred):
            return None
        for link in reversed(self.links):
            match link.readings[0]:
                case Claim(Apply("sin" | "cos" | "tan", Letter() as angle), "="):
                    return angle
                case Claim(left, "=") if link is self.links[-1] or is_numeric(left):
                    continue  # tan θ = 1.8/3.2 = 0.56
            return None
        return None

    def _is_divisor(self, segment: Segment) -> bool:
        """Whether what stood last is divided, and what follows is all that it gives.

        ``÷ ½mu² gives (1 - e²)sin²α`` and ``divide by m: 3u/2`` are equations.
        """
        behind = self.behind[0] if self.behind else None
        if behind is None or behind.has_relation or not _GIVING & set(behind.before):
            return False
        signed = segment.tokens[0].kind == "/" and len(segment.tokens) > 1
        spoken = segment.before[-1:] == ("by",) and bool(_DIVIDING & set(segment.before))
        return (signed or spoken) and bool(self.links or self.past.side)

    def _becomes(self, label: Token) -> bool:
        """Whether an arrow leads from the value of a label to another: ``perp: 4 → 2``."""
        if (
            label.kind != "phrase"
            or not self.behind
            or not STAGES.keys().isdisjoint(label.name.split())
        ):
            return False
        following = self.behind[0]
        arrow = len(following.before) == 1 and following.before[0].endswith(">")
        first, *_ = sides_of(following.tokens)[0]
        return arrow and bool(first) and (len(first) > 1 or first[0].kind == "number")

    def becoming(self, label: Token, sides: tuple[Side, ...], tokens: Sequence[Token]) -> None:
        """The value of a label before the event; what is behind the arrow is that after it.

        Or the arrow only works it out: ``perp: u sin 30 → 0.5u``.
        """
        own = tuple(Side(Letter(name)) for name in (f"{label.name} before", label.name))
        self.link(own, "=", sides, tokens, label)
        name = f"{label.name} after"
        self.label = replace(label, name=name)
        self.became = {name: sides[:1]}

    def _share(self, segment: Segment) -> Letter | None:
        """What a percentage alone is, where the question asks for one: ``60%``, ``60% lost``."""
        first = [token.kind for token in segment.tokens[:2]] == ["number", "percent"]
        words = set(segment.before) - _CONCLUDING
        goes_on = bool(self.links) and not set(segment.before) & _ENDING
        if not first or goes_on or words:
            return None
        asked = self._asks_percentage()
        rest = _OF_A_SHARE.fullmatch(self.line.text, segment.tokens[1].end)
        if not asked or rest is None:
            return None
        return Letter("percentage lost" if rest[1] else "the percentage")

    def _amount(self, segment: Segment) -> Letter | None:
        """What words behind it make of a value: ``so 15J lost``, ``so 85.7° between``."""
        kinds = [token.kind for token in segment.tokens]
        if kinds == ["number", "degrees"]:
            between = _BETWEEN_BEHIND.match(self.line.text, segment.tokens[1].end)
            return None if between is None else Letter("angle between")
        if kinds != ["number", "measure"] or segment.tokens[1].name[0] not in "Jj":
            return None
        lost = _LOST_BEHIND.match(self.line.text, segment.tokens[1].end)
        return None if lost is None else Letter("KE lost")

    def _is_of_a_time(self, segment: Segment) -> bool:
        """Whether a chain works out a number of seconds, and nothing says what it is."""
        first, *_ = sides_of(segment.tokens)[0]
        numeric = bool(first) and all(token.kind in _OF_NUMBERS for token in first)
        seconds = segment.tokens[-1].kind == "measure" and segment.tokens[-1].name == "s"
        return numeric and seconds and self.label is None and _asks_time(self.problem)

    def _is_of_a_percentage(self, segment: Segment) -> bool:
        """Whether a chain works out a percentage, and nothing says what of: ``4/21.5 = 18.6%``."""
        sides, _ = sides_of(segment.tokens)
        numeric = bool(sides[0]) and all(token.kind in _OF_NUMBERS for token in sides[0])
        percent = segment.tokens[-1].kind == "percent" and len(sides) > 1
        if not (numeric and percent and self.label is None and self._asks_percentage()):
            return False
        return _OF_A_SHARE.fullmatch(self.line.text, segment.tokens[-1].end) is not None

    def _asks_percentage(self) -> bool:
        return any(
            isinstance(item, Value) and (item.percentage or _is_share(item.expression))
            for _, step in self.problem.steps()
            for item in (step.items if isinstance(step, Find) else ())
        )

    def _names_its_direction(self, segment: Segment) -> bool:
        """Whether a vector alone says which way a label goes: ``A along n: (20 + 30)/5``."""
        label, tokens = self.label, segment.tokens
        vector = tokens[0].kind == "unit" or tokens[0].name in self.usage.vectors
        alone = len(tokens) == 1 and vector and not segment.before
        return alone and label is not None and _ends_in_a_direction(label)

    def velocities(self, tokens: Sequence[Token]) -> bool:
        """Velocities with the bodies before them: ``A 3i + 5j  B 2i - j``."""
        places = [n for n, token in enumerate(tokens) if token.kind == "name"]
        stretches = [tokens[a + 1 : b] for a, b in pairwise((*places, len(tokens)))]
        if not all(stretches):
            return False
        read = [self.sides(stretch) for stretch in stretches]
        if not all(is_vector(sides[0].tree, self.usage.vectors) for sides in read):
            return False
        for place, stretch, sides in zip(places, stretches, read):
            if self.titled:
                self.statements.values += (sides[0].tree,)
            else:
                self.labelled(tokens[place], sides, stretch)
        return True

    def _is_unknown_distance(self, label: Token) -> bool:
        """Whether a phrase says how far something is of which the question does not tell where."""
        heads = {HEADS[word] for word in label.name.split() if word in HEADS}
        return heads == {"distance"} and not read_phrase(label.name, self.problem)

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
        if label.name in self.usage.spheres and _STAGED.match(self.line.text, tokens[-1].end):
            self.statements.values += (sides[0].tree,)
            return  # B: u/√2 before, (1 + k)u/√2 after
        own = [Side(self.label_tree(label, sides, tokens))]
        if self._is_unknown_distance(label):
            self.statements.values += (sides[0].tree,)
            return
        if label.name in self.usage.spheres and own[0].tree == Letter(f"speed of {label.name}"):
            own = list(worths_of(label.name, sides[0].tree, self.problem))
        elif own[0].tree == Letter(f"velocity of {label.name}"):
            own += [Side(place) for place in places_of(label.name, self.problem)]
        own += self.became.get(label.name, ())
        self.link(tuple(own), "=", sides, tokens, label)
