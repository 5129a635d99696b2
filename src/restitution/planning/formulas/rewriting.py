"""A line in another form: rearranged, or with a factor left out."""

from __future__ import annotations

from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Move, Relation
from restitution.planning.formulas.impacts import residual
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene


def in_another_form(scene: Scene, number: int, relation: Relation) -> int | None:
    """Writes a line in another form, with what is known of its letters where it is needed.

    None where the one does not follow from the other so.
    """
    names = symbol_names(residual(scene, number))
    for move in (Move("rearrange"), Move("cancel")):
        refs = scene.judge.enough(move, (number,), relation, background(scene, names))
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    # A given fact may tell that what it is divided by is not zero.
    given = [ref for ref in scene.judge.known(names) if ref in scene.facts]
    known = (*background(scene, names), *given)
    refs = scene.judge.enough(Move("cancel"), (number,), relation, known) if given else None
    return None if refs is None else scene.desk.write(Move("cancel"), refs, relation)


__all__ = ["in_another_form"]
