"""Which letters in bold type a working is likely to use, as far as its printed lines show."""

from __future__ import annotations

from collections.abc import Callable, Collection

from restitution.explaining.lines.derivation import Derivation
from restitution.explaining.lines.trees import settled, trees_of
from restitution.expression.tree import Expression, Name, Quantity, children, has_quantity
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
                for tree in trees_of(line.relation):
                    seen.look(tree, part)
    return Used(seen.velocities, frozenset(seen.units))


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
            case Quantity("along" | "across") if tree in self._named:
                return  # it is called by its letter
            case Quantity("along" | "across" as kind, (_, Quantity("line_of_centres", (), int(n)))):
                if self._has_unit(n):
                    self.units.add((n, kind))
        for each in children(tree):
            self.look(each, part)


__all__ = ["foreseen"]
