"""What no premise says: that a letter, a sum or a factor is positive, or not zero."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from restitution.explaining.lines.derivation import (
    Line,
    Link,
    Relation,
)
from restitution.explaining.lines.notation import read_relation, read_tree
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    letters,
    walk,
)
from restitution.planning.writing.forms import factors
from restitution.render import layout as lay
from restitution.workings.reasons.equality import divisor_left_out
from restitution.workings.reasons.factors import factor_left, positive_factor_left, sums_left
from restitution.workings.reasons.known import Known
from restitution.workings.reasons.multipliers import cleared_factors
from restitution.workings.reasons.plain_signs import (
    are_squares,
    multiples_compared,
    positive_letters,
    signs_in_a_sum,
)
from restitution.workings.reasons.shape_reasons import DOWN, UP, ZERO
from restitution.workings.reasons.together import merged


class PositiveReasons(Known):
    """That letters and factors are positive, where a line needs it and cites nothing."""

    def _silent(self, line: Line) -> Iterator[lay.Layout]:
        """That a letter is positive, where a range begins with 0 that nothing else bounds."""
        assert isinstance(line.relation, Relation)
        if line.move.id != "compare":
            return
        match line.relation.options[0]:
            case (Link(left, "<", Letter(name) as letter), Link()) if left == ZERO:
                role = self._roles.get(name)
                if role is None or role.kind != "positive":
                    return
                for ref in line.premises:
                    if _bounds_below(self._shapes.relation_of(ref), letter):
                        return
                yield self._layout(Relation(((Link(letter, ">", ZERO),),)))

    def _cleared(self, line: Line) -> Iterator[lay.Layout]:
        """That the factors are positive by which an inequality is multiplied."""
        cited = [own for ref in line.premises if (own := self._shapes.relation_of(ref)) is not None]
        assert isinstance(line.relation, Relation)
        if any(divisor_left_out(relation, line.relation, self._roles) for relation in cited):
            return  # another reason says more
        yield from map(self._layout, cleared_factors(self._derivation, line, self.is_positive))

    def _dropped(self, line: Line) -> Iterator[lay.Layout]:
        """That a sum which was a factor of a product is not zero, or positive."""
        factor = factor_left(self._derivation, line)
        if factor is not None:
            yield self._layout(Relation(((Link(factor, "!=", ZERO),),)))
        positive = positive_factor_left(self._derivation, line, self._roles)
        if positive is not None:
            yield self._layout(Relation(((Link(positive, ">", ZERO),),)))
        for tree in sums_left(self._derivation, line, self._roles):
            yield self._layout(Relation(((Link(tree, ">", ZERO),),)))

    def _divided_by(self, line: Line) -> Iterator[lay.Layout]:
        """That a ratio and 1 make something positive, below the value of which a sign is given."""
        assert isinstance(line.relation, Relation)
        match line.relation.options:
            case ((Link(left, sign, right),),) if (
                line.move.id == "put" and sign in (*UP, *DOWN) and right == ZERO
            ):
                standing = set(walk(left))
            case _:
                return
        for ref in line.premises:
            own = self._shapes.relation_of(ref) if isinstance(ref, int) else None
            match None if own is None or len(own.options) > 1 else own.only[-1].right:
                case Binary("/", _, below):
                    for factor in factors(below):
                        gone = isinstance(factor, Binary) and factor not in standing
                        if gone and _is_one_and_more(factor, self.is_positive):
                            yield self._layout(Relation(((Link(factor, ">", ZERO),),)))
                            return

    def _positive(self, line: Line) -> Iterator[Sentence]:
        """The silent reason: the letter stands for something positive, and for no component."""
        assert isinstance(line.relation, Relation)
        left = line.relation.options[0][0].left
        if not isinstance(left, Letter):
            return
        meaning = self._derivation.meanings.get(left.name)
        kind = None if meaning is None else getattr(meaning.quantity, "kind", None)
        component = kind in ("along", "across", "dot")
        if not component and (meaning is not None or self.is_positive(left.name)):
            sentence: SentenceId = "derived.positive"
            if meaning is None and self.is_of_a_line(left):
                sentence = "derived.taken-positive"
            yield say(sentence, letter=self._naming.layout(left))

    def _by_its_own_sign(self, line: Line) -> bool:
        """Whether a root is rejected by what it may be itself, and the ranges of other letters."""
        assert isinstance(line.relation, Relation)
        left = line.relation.options[0][0].left
        ranges = [ref for ref in line.premises[1:] if isinstance(ref, str)]
        if len(ranges) < len(line.premises) - 1 or not isinstance(left, Letter):
            return False
        return not any(self._derivation.fact(e) is not None or self._is_of(e, left) for e in ranges)

    def _is_of(self, ref: str, letter: Letter) -> bool:
        """Whether what is known of letters, as a premise says it, is about one of them."""
        head, colon, text = ref.partition(":")
        if colon and head.strip() == "acute":
            return letter in set(walk(read_tree(text, self._naming.bodies)))
        trees = trees_of(read_relation(ref, self._naming.bodies))
        return any(letter in set(walk(tree)) for tree in trees)

    def _positive_sum(self, line: Line) -> Iterator[lay.Layout]:
        """The signs of letters by which a reader sees that a sum is positive."""
        cited = [self._shapes.relation_of(ref) for ref in line.premises]
        if line.move.id == "sign" and len(cited) == 1 and cited[0] is not None:
            yield from map(self._layout, signs_in_a_sum(cited[0], self._roles))

    def _compared(self, line: Line) -> Iterator[lay.Layout]:
        """That one number is less than another, of two multiples of one thing."""
        cited = [self._shapes.relation_of(ref) for ref in line.premises]
        if line.move.id == "sign":
            assert isinstance(line.relation, Relation)
            numbers = multiples_compared(line.relation, [own for own in cited if own is not None])
            if numbers is not None:
                yield self._layout(numbers)

    def _positive_ratio(self, line: Line) -> Iterator[lay.Layout]:
        """That a letter is positive, of a ratio of an angle that is so by it."""
        cited = [self._shapes.relation_of(ref) for ref in line.premises]
        match line.relation:
            case Relation(((Link(Apply(), ">", right),),)) if right == ZERO and len(cited) == 1:
                pass
            case _:
                return
        if line.move.id == "sign" and cited[0] is not None:
            for letter in positive_letters(cited[0].options[0][-1].right, self._roles):
                yield self._layout(Relation(((Link(letter, ">", ZERO),),)))

    def _both_squared(self, line: Line) -> Iterator[Sentence]:
        """That both sides of an inequality may be squared."""
        assert isinstance(line.relation, Relation)
        cited = [own for ref in line.premises if (own := self._shapes.relation_of(ref)) is not None]
        squared = line.move.id == "compare" and len(cited) == 1
        if squared and are_squares(line.relation, cited[0], self._roles):
            yield say("derived.squared")

    def _given_ranges(self, line: Line) -> Iterator[lay.Layout]:
        """The ranges that the statement gives of the letters in a root, which tell its sign."""
        assert isinstance(line.relation, Relation)
        names = letters(line.relation.only[0].left)
        bounds = [
            link
            for fact in self._derivation.facts
            if fact.kind == "range" and len(fact.relation.options) == 1
            for link in fact.relation.only
            if link.sign in (*UP, *DOWN)
            and any(letters(side) & names for side in (link.left, link.right))
        ]
        yield from (self._layout(relation) for relation in merged(bounds))


def _bounds_below(relation: Relation | None, letter: Letter) -> bool:
    """Whether a relation says that a letter is more than something."""
    return relation is not None and any(
        (link.left == letter and link.sign in DOWN) or (link.right == letter and link.sign in UP)
        for links in relation.options
        for link in links
    )


def _is_one_and_more(tree: Expression, is_positive: Callable[[str], bool]) -> bool:
    """Whether a tree is a number and a letter, each positive, added."""
    match tree:
        case Binary("+", Number(), Letter(name)) | Binary("+", Letter(name), Number()):
            return is_positive(name)
    return False
