"""How a quantity grows or falls with a letter, as the reason of its bounds: *as 1/e falls*."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction

from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Ref,
    Relation,
    equality,
    turned,
)
from restitution.explaining.lines.notation import read_tree
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import (
    RIGHT_ANGLE,
    Binary,
    Degrees,
    Expression,
    Letter,
    Number,
    is_binary,
    letters,
    walk,
)
from restitution.oracle.roles import Role
from restitution.planning.writing.forms import factors
from restitution.render import layout as lay
from restitution.workings.naming.measured import Measures
from restitution.workings.naming.quantities import Naming
from restitution.workings.reasons.growing import growth, limit_at_an_end, reached_at_ends, way_of
from restitution.workings.reasons.seen import growth_said, less_than_its_limit, shown
from restitution.workings.reasons.shape_reasons import DOWN, UP, ZERO, ShapeReasons, is_short

Known = Callable[[Ref, Line], Sentence | Relation | None]
"""What is known of a letter by what a line cites, as a reader would say it."""


class GrowthReasons:
    """Reasons of lines whose bounds come of the way in which a quantity changes with a letter."""

    def __init__(
        self,
        derivation: Derivation,
        naming: Naming,
        roles: Mapping[str, Role],
        shapes: ShapeReasons,
        reason: Known,
        measures: Measures,
    ) -> None:
        self._measures = measures
        self._derivation = derivation
        self._naming = naming
        self._roles = roles
        self._shapes = shapes
        self._reason = reason

    def _layout(self, tree: Expression) -> lay.Layout:
        """A tree as the rows have it, in decimals where these have them."""
        return self._naming.layout(self._measures.with_decimals(tree))

    def between_ends(self, line: Line) -> Iterator[Sentence]:
        """That a quantity increases, or decreases, between the ends that are cited."""
        if line.move.id != "monotone":
            return
        if any(self._shapes.square_of_a_ratio(line)) or self._shapes.square_of_a_coefficient(line):
            return  # a limit says no more than that
        growths = [
            own.relation
            for ref in line.premises
            if isinstance(ref, int)
            and (own := self._derivation.line(ref)) is not None
            and isinstance(own.relation, Relation)
        ]
        above = [
            Link(relation.only[0].left, "=", relation.only[-1].right)
            for relation in growths
            if relation.only[0].sign == "="
        ]
        if len(above) == 1:
            yield from self._grown(line, above[0], self._ends_cited(line, growths))

    def _ends_cited(self, line: Line, growths: Sequence[Relation]) -> list[Link]:
        """The ends of letters that a line cites: those of lines, of facts, and of acute angles."""
        ends = [link for relation in growths for link in relation.only if link.sign != "="]
        ends += [
            link
            for ref in line.premises
            if isinstance(relation := self._reason(ref, line), Relation)
            for links in relation.options
            for link in links
        ]
        for ref in line.premises:
            if isinstance(ref, str) and ref.startswith("acute:"):
                angle = read_tree(ref.removeprefix("acute:"), self._naming.bodies)
                ends += [
                    Link(angle, ">", Degrees(Fraction(0))),
                    Link(angle, "<", RIGHT_ANGLE),
                ]
        return ends

    def _grown(self, line: Line, above: Link, ends: Sequence[Link]) -> Iterator[Sentence]:
        """How the value of a line grows, and to what it tends."""
        assert isinstance(line.relation, Relation)
        positive = {name for name, role in self._roles.items() if role.kind == "positive"}
        grown = growth(above.right, line.relation, ends, positive, self._varied(line))
        if grown is None:
            return
        name, sense = grown
        whole = above.right
        if _is_reciprocal(whole, name) and name not in positive:
            return  # of k = 1/e the bounds of e say it
        plain = _is_multiple(whole, name) or _is_plain_sum(whole, name)
        if name not in positive and plain and len(line.relation.only) == 1:
            return  # so they do of e tan(alpha), with the sign of what stands beside e
        if not is_short(whole):
            part = _part_with(whole, name)
            turn = 0 if part is None else way_of(part, name, ends, line.relation)
            whole, sense = (above.left, sense) if part is None or not turn else (part, turn)
        growth_, itself = growth_said(whole, name, sense, ends, self._roles, self._layout)
        far = _far_end(line.relation, above.left, name, sense, ends)
        if far is not None and self._is_no_range(line):
            less = less_than_its_limit(whole, name, sense, ends, self._roles)
            if less is not None:
                yield say("derived.fact", fact=self._naming.relation(less))
                return
        if len(reached := self._reached(line, above, name, ends)) == 2:
            # A claim with two ends takes both.
            (least, at_least), (most, at_most) = reached if sense > 0 else reached[::-1]
            between = {"low": least, "first": at_least, "high": most, "last": at_most}
            yield say("derived.from-to", growth=growth_, **between)
            return
        if itself and name not in positive and len(reached) == 1:
            ((value, at),) = reached
            bound = line.relation.only[0]
            own = bound if bound.left == above.left else turned(bound)
            onward = (own.sign in UP) == (sense > 0)
            yield say(
                "derived.to" if onward else "derived.from", growth=growth_, value=value, at=at
            )
            return
        yield growth_
        # Of what grows the limit may be another.
        named = not itself or whole not in (above.left, above.right)
        if name in positive and far is not None:
            near = self._near_zero(line.relation, name, ends)
            yield from self._tending(above.left, name, (far, None), named, near)
        elif name in positive and not any(
            Letter(name) in (end.left, end.right) for end in ends
        ):  # the bound is the value at zero
            low = Link(Letter(name), ">", ZERO)
            yield say("derived.fact", fact=self._naming.relation(Relation(((low,),))))
        elif any(end.line == line.number and end.shown for end in self._derivation.items):
            if len(reached) == 1:
                ((value, at),) = reached
                yield say("derived.it-is", value=value, at=at)
                return
            limit = limit_at_an_end(above.right, line.relation, name, ends) or (None, None)
            yield from self._tending(above.left, name, limit, named, ())

    def _reached(
        self, line: Line, above: Link, name: str, ends: Sequence[Link]
    ) -> list[tuple[lay.Layout, lay.Layout]]:
        """The bounds of what is shown that are values at ends of a letter, each with that end."""
        assert isinstance(line.relation, Relation)
        if not any(end.line == line.number and end.shown for end in self._derivation.items):
            return []
        return [
            (self._layout(value), self._naming.relation(equality(Letter(name), end)))
            for value, end in reached_at_ends(above.right, above.left, line.relation, name, ends)
        ]

    def _near_zero(
        self, relation: Relation, name: str, ends: Sequence[Link]
    ) -> tuple[Sentence, ...]:
        """The lower end of a letter, where a range has another end beside the limit."""
        if len(relation.only) == 1:
            return ()
        letter = Letter(name)
        least = (turned(e) if e.right == letter else e for e in ends)
        low = (e for e in least if e.left == letter and e.sign in DOWN)
        low_end = next(low, Link(letter, ">", ZERO))
        return (say("derived.fact", fact=self._naming.relation(Relation(((low_end,),)))),)

    def _tending(
        self,
        subject: Expression,
        name: str,
        limit: tuple[Expression | None, Expression | None],
        named: bool,
        near: tuple[Sentence, ...],
    ) -> Iterator[Sentence]:
        """To what a quantity tends, which is ``named`` once more where another one grows."""
        letter = self._naming.layout(Letter(name))
        value, end = (None if bound is None else self._layout(bound) for bound in limit)
        if value is None:
            return
        side = self._naming.side(subject)
        words = isinstance(side, lay.Words | lay.Phrase)
        quantity = say("derived.the", quantity=side) if words else side
        first = say("derived.its", quantity=quantity) if named else ""
        if named:
            yield from near
        yield (
            say("derived.tends", first=first, value=value, letter=letter)
            if end is None
            else say("derived.tends-to", first=first, value=value, letter=letter, end=end)
        )
        # What falls "and tends to 0" is named once: nothing stands between.
        yield from () if named else near

    def at_its_end(self, line: Line) -> Iterator[Sentence]:
        """How a bound goes with a letter that is in it twice, where its end is put in for that."""
        assert isinstance(line.relation, Relation)
        cited = [self._shapes.relation_of(ref) for ref in line.premises if isinstance(ref, int)]
        match line.relation.options, cited:
            case [((Link(subject, sign_, bound),),), [Relation(((Link(own, first, worth),),))]]:
                pass
            case _:
                return
        if line.move.id != "compare" or subject != own or sign_[0] != first[0] or sign_ == "=":
            return
        ends = [
            link
            for ref in line.premises
            if isinstance(ref, str) and isinstance(reason := self._reason(ref, line), Relation)
            for link in reason.options[0]
        ]
        names = [node.name for node in walk(worth) if isinstance(node, Letter)]
        for name in sorted(letters(worth) - letters(bound)):
            sense = way_of(worth, name, ends, Relation(((Link(worth, sign_, bound),),)))
            if names.count(name) > 1 and shown(worth, name, sense, ends, self._roles) is not None:
                yield growth_said(worth, name, sense, ends, self._roles, self._layout)[0]

    def _varied(self, line: Line) -> set[str]:
        """The letters of the places at which answers that rest on a bound are reached."""
        return {
            name
            for answer in self._derivation.lines
            if answer.move.id == "answer" and line.number in answer.premises[:1]
            for ref in answer.premises[1:]
            if isinstance(ref, int)
            and (there := self._derivation.line(ref)) is not None
            and isinstance(there.relation, Relation)
            for name in letters(there.relation.options[0][0].left)
        }

    def _is_no_range(self, line: Line) -> bool:
        """Whether a line leads to what is shown, or to a value that is only approached.

        Where a range is asked, its ends are limits.
        """
        above = {line.number}
        for earlier in self._derivation.lines:
            if above & set(earlier.premises):
                above.add(earlier.number)
        end = next((item for item in self._derivation.items if item.line in above), None)
        if end is None:
            return False
        last = self._derivation.line(end.line)
        return end.shown or (last is not None and last.move.record == "approached")


def _far_end(
    bound: Relation, subject: Expression, name: str, sense: int, ends: Sequence[Link]
) -> Expression | None:
    """The bound that is approached as a letter grows, where nothing cited bounds it above."""
    for end in ends:
        above = end.left if end.sign in UP else end.right
        if above == Letter(name):
            return None
    for link in bound.only:
        for side, other, signs in (
            (link.left, link.right, UP if sense > 0 else DOWN),
            (link.right, link.left, DOWN if sense > 0 else UP),
        ):
            if side == subject and link.sign in signs:
                return other
    return None


def _is_reciprocal(tree: Expression, name: str) -> bool:
    """Whether a value is a number over a letter."""
    match tree:
        case Binary("/", Number(), Letter(own)):
            return own == name
    return False


def _is_multiple(tree: Expression, name: str) -> bool:
    """Whether a value is a product in which a letter stands once, as a factor."""
    own = [factor for factor in factors(tree) if name in letters(factor)]
    return own == [Letter(name)] and tree != Letter(name)


def _is_plain_sum(tree: Expression, name: str) -> bool:
    """Whether a value is a number, and a multiple of a letter that is added or subtracted."""
    above = tree.left if is_binary(tree, "/") and isinstance(tree.right, Number) else tree
    match above:
        case Binary("+" | "-", left, right):
            own = [side for side in (left, right) if not isinstance(side, Number)]
            return len(own) == 1 and letters(tree) == {name} and Letter(name) in factors(own[0])
    return False


def _part_with(tree: Expression, name: str) -> Expression | None:
    """The one factor of a product, or above in a quotient, that has a letter, if it is short."""
    above = tree
    if is_binary(tree, "/"):
        if name in letters(tree.right):
            return None
        above = tree.left
    parts = [factor for factor in factors(above) if name in letters(factor)]
    return parts[0] if len(parts) == 1 and is_short(parts[0]) else None
