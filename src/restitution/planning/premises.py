"""What a line needs to follow, and nothing more: premises are tried as a reader tries them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from restitution.explaining.algebra import NotComparableError
from restitution.explaining.derivation import Derivation, Meaning, Move, Ref, Relation
from restitution.explaining.follower import known_of_letters, setting_of
from restitution.explaining.moves import follows
from restitution.explaining.step import Cited, Known, Setting, Step
from restitution.oracle import Oracle
from restitution.planning.angles import range_of
from restitution.planning.desk import NotPlannedError
from restitution.planning.scene import Scene
from restitution.solve.letters import roles


def follows_from(scene: Scene, move: Move, premises: Sequence[Ref], relation: Relation) -> bool:
    """Whether a relation is what a move makes of some premises."""
    return _follows(scene, _setting(scene), move, premises, relation)


def needed(
    scene: Scene,
    move: Move,
    own: Iterable[Ref],
    relation: Relation,
    others: Iterable[Ref] = (),
) -> tuple[Ref, ...] | None:
    """The premises that a line needs: its own, and as few as possible of some others.

    None where it does not follow from all of them. Of the others, the later ones are left out
    first.
    """
    setting = _setting(scene)
    first = tuple(dict.fromkeys(own))
    if _follows(scene, setting, move, first, relation):
        return first
    rest = [each for each in dict.fromkeys(others) if each not in first]
    if not rest or not _follows(scene, setting, move, (*first, *rest), relation):
        return None
    for each in rest:
        if _follows(scene, setting, move, (*first, each), relation):
            return (*first, each)
    for each in reversed(list(rest)):
        fewer = [ref for ref in rest if ref != each]
        if _follows(scene, setting, move, (*first, *fewer), relation):
            rest = fewer
    return (*first, *rest)


def background(scene: Scene, names: Iterable[str]) -> tuple[Ref, ...]:
    """What is known of letters by their roles, as premises say it."""
    refs: list[Ref] = []
    for name in sorted(names):
        role = scene.model.unknowns.roles.get(name)
        if role is None or role.kind in ("positive", "real"):
            continue
        if role.kind == "restitution":
            refs += [f"{name} >= 0", f"{name} <= 1"]
        elif (text := range_text(scene, name)) is not None:
            refs.append(text)
    return tuple(refs)


def not_negative(scene: Scene, size: sp.Expr) -> tuple[Ref, ...]:
    """What has to be known for the root of a square to be this, beyond what is silent."""
    odd = [
        each
        for each in sp.Mul.make_args(size)
        if not (each.is_Pow and (each.exp.is_even or each.exp == sp.Rational(1, 2)))
    ]
    return nonzero(scene, sp.Mul(*odd), alone=True)


def nonzero(scene: Scene, factor: sp.Expr, *, alone: bool = False) -> tuple[Ref, ...]:
    """What has to be known for a factor not to vanish, beyond what is silent."""
    refs: list[Ref] = []
    for each in sp.Mul.make_args(sp.factor(factor)):
        base = each.base if each.is_Pow else each
        for function in base.atoms(sp.sin, sp.cos):
            for angle in function.free_symbols:
                refs.append(range_of(scene, angle.name))
        for letter in sorted(base.free_symbols, key=lambda s: s.name):
            role = scene.model.unknowns.roles.get(letter.name)
            if role is not None and role.kind == "restitution" and (alone or base != letter):
                refs.append(f"{letter.name} >= 0")
    return tuple(dict.fromkeys(refs))


def sign_known(scene: Scene, value: sp.Expr) -> tuple[Ref, ...]:
    """What has to be known of letters for the sign of a product, beyond what is silent."""
    refs: list[Ref] = []
    for each in sp.Mul.make_args(sp.factor(value)):
        base, power = each.as_base_exp()
        if power.is_even:
            continue
        for function in base.atoms(sp.sin, sp.cos):
            refs += [range_of(scene, angle.name) for angle in function.free_symbols]
        for letter in sorted(base.free_symbols, key=lambda s: s.name):
            role = scene.model.unknowns.roles.get(letter.name)
            if role is not None and role.kind == "restitution":
                falls = scene.model.sign(sp.diff(base, letter)) < 0
                refs.append(f"{letter.name} <= 1" if falls else f"{letter.name} >= 0")
    return tuple(dict.fromkeys(refs))


def range_text(scene: Scene, name: str) -> str | None:
    """The range of an angle, as a premise says it; None where it is open."""
    try:
        return range_of(scene, name)
    except NotPlannedError:
        return None


def _setting(scene: Scene) -> Setting:
    desk = scene.desk
    told = Derivation(desk.facts, tuple(desk.lines), (), desk.events)
    return setting_of(told, Oracle(roles(scene.problem)))


def _follows(
    scene: Scene, setting: Setting, move: Move, premises: Sequence[Ref], relation: Relation
) -> bool:
    cited: list[Cited] = []
    known: list[Known] = []
    for ref in premises:
        if isinstance(ref, int):
            cited.append(Cited(ref, _cited(scene, ref)))
        elif ref in scene.facts:
            cited.append(Cited(ref, scene.facts[ref].relation))
        else:
            own = known_of_letters(ref, setting)
            if own is None:
                return False
            known.append(own)
    try:
        return follows(Step(setting, move, tuple(cited), tuple(known)), relation)
    except NotComparableError:
        return False


def _cited(scene: Scene, number: int) -> Relation | Meaning:
    """What a line says: of alternatives, the one under which the next lines stand."""
    own = scene.desk.line(number).relation
    for line, option in scene.desk.splits:
        if line == number and isinstance(own, Relation):
            return Relation((own.options[option],))
    return own
