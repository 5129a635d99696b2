"""Quantities that others define: the one that an expression is, for those who name it."""

from __future__ import annotations

from dataclasses import field

from restitution.expression.quantities import KINDS, Kind
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Name,
    Negate,
    Quantity,
    Stage,
    children,
)
from restitution.records import dataclass

_EVENT = 10**9  # the number of no event


def quantity_of(tree: Expression) -> Quantity | None:
    """The quantity that an expression defines, where that has a noun; None of any other tree."""
    for kind in KINDS.values():
        if kind.definition is not None and kind.noun:
            quantity = _as(kind, tree)
            if quantity is not None:
                return quantity
    return None


def _as(kind: Kind, tree: Expression) -> Quantity | None:
    """A tree as a quantity of a kind, by the definition of that; None where it is none."""
    arguments = tuple(Name(name) for name in "XY"[: kind.arguments[1]])
    stages: tuple[Stage, ...] = (None, "before", _EVENT) if kind.before else (None, _EVENT)
    for stage in stages:
        form = kind.written_out(arguments, stage, _EVENT)
        instance = _Instance()
        if form is not None and instance.fits(tree, form):
            less = instance.less
            late = _EVENT - less if stage == _EVENT and less is not None else stage
            return Quantity(kind.word, tuple(instance.names[name] for name in arguments), late)
    return None


@dataclass
class _Instance:
    """What an instance of a form puts in: names for names, and events that are so much earlier."""

    names: dict[Expression, Name] = field(default_factory=dict)
    less: int | None = None

    def fits(self, tree: Expression, form: Expression) -> bool:
        """Whether a tree is the form with other names and events in it."""
        match form, tree:
            case Name(), Name():
                return self.names.setdefault(form, tree) == tree
            case Quantity(kind, _, stage), Quantity(other, _, own):
                same = kind == other and self._is_at(own, stage)
            case (Binary(op), Binary(other)) | (Apply(op), Apply(other)):
                same = op == other
            case Negate(), Negate():
                same = True
            case _:
                return tree == form
        inner, outer = children(tree), children(form)
        return (
            same
            and len(inner) == len(outer)
            and all(self.fits(one, other) for one, other in zip(inner, outer, strict=True))
        )

    def _is_at(self, stage: Stage, form: Stage) -> bool:
        """Whether a stage is that of the form, so much earlier as all others."""
        if not (isinstance(stage, int) and isinstance(form, int)):
            return stage == form
        if self.less is None:
            self.less = form - stage
        return self.less == form - stage
