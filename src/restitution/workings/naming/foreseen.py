"""Which letters in bold type a working is likely to use, as far as its printed lines show."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator

from restitution.explaining.lines.derivation import Derivation, Line, Link, Meaning, Relation
from restitution.explaining.lines.trees import settled, trees_of
from restitution.expression.tree import Expression, Name, Quantity, children, has_quantity, is_zero
from restitution.workings.naming.bold_letters import Used


def foreseen(derivation: Derivation, has_unit: Callable[[int], bool]) -> Used:
    """The velocities that stand in printed lines, and the unit vectors of components there.

    ``has_unit`` tells at which impacts there are unit vectors. Sentences are not looked through,
    so that it is a guess: whoever writes the lines sees whether it was right.
    """
    seen = _Seen(derivation, has_unit)
    for part in dict.fromkeys(derivation.asked.values()):
        for line in derivation.lines:
            if line.shown != "silent" and derivation.asked.get(line.item or "") == part:
                for tree in (*_given(derivation, line), *_printed(line)):
                    seen.look(tree, part)
    return Used(seen.velocities, frozenset(seen.units))


def _printed(line: Line) -> Iterable[Expression]:
    """The trees of a line that stand on paper."""
    match line.relation:
        case Meaning(_, Quantity("direction", arguments, int(stage))):
            return (Quantity("velocity", arguments, stage),)
        case Relation(
            (
                (
                    Link(
                        Quantity("along" | "across" as kind, (Quantity("velocity", (body,)), axis))
                    ),
                    *_,
                ),
            )
        ) if line.move.id == "law" and line.move.record == "unchanged":
            # That a component stays is said in words, of its body and its direction; that there is
            # none, of its body.
            stays = not is_zero(line.relation.only[-1].right)
            return (Quantity(kind, (body, axis)),) if stays else ()
    return trees_of(line.relation)


def _given(derivation: Derivation, line: Line) -> Iterator[Expression]:
    """The trees of the given facts that a definition takes: it is said that they are given."""
    if line.move.id != "define":
        return
    for ref in line.premises:
        fact = derivation.fact(ref)
        if fact is None or fact.kind != "given":
            continue
        for links in fact.relation.options:
            for own in links:
                # A velocity that has a value is a datum, which is put in.
                if own.sign != "=" or (has_quantity(own.left) and has_quantity(own.right)):
                    yield from (own.left, own.right)


class _Seen:
    """What has been seen in lines so far."""

    def __init__(self, derivation: Derivation, has_unit: Callable[[int], bool]) -> None:
        self._events = derivation.events
        self._has_unit = has_unit
        self._named: Collection[Expression] = {e.quantity for e in derivation.meanings.values()}
        self.velocities: dict[tuple[str, int], str | None] = {}
        self.units: set[tuple[int, str]] = set()

    def look(self, tree: Expression, part: str | None) -> None:
        """Takes up the velocities and the unit vectors of a tree."""
        if not has_quantity(tree):
            return
        match tree:
            case Quantity("velocity", (Name(body),)):
                own = settled(tree, self._events)
                if isinstance(own, Quantity) and isinstance(own.stage, int):
                    self.velocities.setdefault((body, own.stage), part)
                return
            case Quantity("direction", (Name(),), int()) if tree not in self._named:
                self.look(Quantity("velocity", tree.arguments, tree.stage), part)
                return
            case Quantity("along" | "across") if tree in self._named:
                return  # it is called by its letter
            case Quantity("along" | "across" as kind, (_, Quantity("line_of_centres", (), int(n)))):
                if self._has_unit(n):
                    self.units.add((n, kind))
        for node in children(tree):
            self.look(node, part)


__all__ = ["foreseen"]
