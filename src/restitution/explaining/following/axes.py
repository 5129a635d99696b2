"""Whether a working keeps the sense of each line of centres."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from restitution.explaining.data.setting import Cited, Setting
from restitution.explaining.lines.derivation import (
    Derivation,
    Meaning,
    Move,
    Ref,
    Relation,
    equality,
)
from restitution.explaining.lines.quotients import NotComparableError, Plane
from restitution.explaining.lines.trees import trees_of
from restitution.explaining.steps.signs import Signs
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    is_component,
    is_quantity,
    walk,
)
from restitution.oracle import Oracle


class Axes:
    """The lines of centres of a working, and the senses in which its lines take them."""

    def __init__(self, derivation: Derivation, setting: Setting) -> None:
        self._derivation = derivation
        self._setting = setting

    def turned_in_laws(self) -> Iterator[Ref]:
        """Directions of lines of centres that laws use, against one that they use as well."""
        axes: dict[int, list[tuple[Ref, Expression]]] = {}
        used = {
            ref
            for line in self._derivation.lines
            if line.move.id in ("law", "define") and line.move.record != "size"
            if not (isinstance(line.relation, Relation) and _tells_an_axis(line.relation))
            for ref in line.premises
        }
        for number, relation in self._relations():
            if number not in used:
                continue
            for link in relation.options[0] if len(relation.options) == 1 else ():
                for left, right in ((link.left, link.right), (link.right, link.left)):
                    match left:
                        case Quantity("line_of_centres", (), int(event)):
                            axes.setdefault(event, []).append((number, right))
                        case Quantity("impulse", (Name(body),), int(event)) if link.sign == "=":
                            own = self._setting.event(event)
                            if own is not None:
                                sense = Negate(left) if body == own.bodies[0] else left
                                axes.setdefault(event, []).append((number, sense))
        for trees in axes.values():
            for axis in self._by_cases(trees):
                if len(axis) > 1:
                    yield from self._turned(axis)

    def turned_in_components(self) -> Iterator[tuple[int, Ref]]:
        """Lines whose components count one way, with the premise by which others count the other.

        An event has one axis with one sense.
        """
        senses: dict[Expression, dict[Ref, Expression]] = {}
        for line in self._derivation.lines:
            if isinstance(line.relation, Meaning):
                continue
            cited = [own.relation for own in self._derivation.lines_in(line.premises)]
            named = [relation.quantity for relation in cited if isinstance(relation, Meaning)]
            used = {
                node.arguments[1]
                for tree in (*trees_of(line.relation), *named)
                for node in walk(tree)
                if is_component(node)
            }
            for ref in line.premises:
                for axis, direction in self._directions(ref):
                    known = senses.setdefault(axis, {})
                    if axis not in used or ref in known:
                        continue
                    if any(
                        not self._are_apart(ref, other) and not self._same_sense(direction, tree)
                        for other, tree in known.items()
                    ):
                        yield line.number, ref
                    known[ref] = direction

    def _relations(self) -> Iterator[tuple[Ref, Relation]]:
        for fact in self._derivation.facts:
            yield fact.id, fact.relation
        for line in self._derivation.lines:
            if isinstance(line.relation, Relation):
                yield line.number, line.relation
            elif line.relation.vector:
                letter = Letter(line.relation.letter)
                yield line.number, equality(line.relation.quantity, letter)

    def _by_cases(
        self, trees: Sequence[tuple[Ref, Expression]]
    ) -> Iterator[list[tuple[Ref, Expression]]]:
        """What stands above all cases with what stands in one: a line may be another in each."""
        numbers = {ref: self._cases_of(ref) for ref, _ in trees}
        for case in sorted(frozenset().union(*numbers.values())) or (0,):
            yield [tree for tree in trees if not numbers[tree[0]] or case in numbers[tree[0]]]

    def _cases_of(self, ref: Ref) -> frozenset[int]:
        """The cases in which a line stands; none of one above all, or of a fact."""
        return frozenset(case.number for case in self._derivation.cases if ref in case.lines)

    def _turned(self, trees: Iterable[tuple[Ref, Expression]]) -> Iterator[Ref]:
        cited = [
            *(Cited(fact.id, fact.relation) for fact in self._derivation.facts),
            *(Cited(line.number, line.relation) for line in self._derivation.lines),
        ]
        step = Step(self._setting, _NO_MOVE, tuple(cited), ())
        signs = Signs(step.world, lambda: Oracle(self._setting.silent))
        first: Plane | None = None
        for ref, tree in trees:
            try:
                own = step.rules().put_into(step.world.value(tree))
            except NotComparableError:
                continue
            if not isinstance(own, Plane):
                continue
            if first is None:
                first = own
            elif signs.of(step.world.reduced(first.x * own.x + first.y * own.y)) == -1:
                yield ref

    def _directions(self, ref: Ref) -> Iterator[tuple[Expression, Expression]]:
        """The lines of centres of which a premise gives the direction, each with that."""
        given = self._derivation.cited(ref)
        if given is None or isinstance(given.relation, Meaning):
            return
        for links in given.relation.options:
            for link in links:
                if is_quantity(link.left, "line_of_centres"):
                    yield link.left, link.right

    def _are_apart(self, one: Ref, other: Ref) -> bool:
        """Whether two premises stand in different cases."""
        cases = self._cases_of(one), self._cases_of(other)
        return all(cases) and cases[0].isdisjoint(cases[1])

    def _same_sense(self, a: Expression, b: Expression) -> bool:
        step = Step(self._setting, _NO_MOVE, (), ())
        try:
            one, other = step.world.direction(a), step.world.direction(b)
            if one is None or other is None:
                return a == b
            product = step.world.reduced(one.x * other.x + one.y * other.y)
        except NotComparableError:
            return a == b
        return step.signs.of(product) == 1


def _tells_an_axis(relation: Relation) -> bool:
    """Whether a relation is of a line of centres and a direction."""
    return any(
        is_quantity(side, "line_of_centres")
        for links in relation.options
        for link in links
        for side in (link.left, link.right)
    )


_NO_MOVE = Move("let")
