"""What has to be known of letters for factors, sizes and signs, as premises say it."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from restitution.exact.symbols import atoms_in
from restitution.explaining.lines.derivation import Ref
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import letters
from restitution.planning.writing.angle_ratios import range_of
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.polynomials import derivative, factored
from restitution.planning.writing.scene import Scene


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


def conditions(scene: Scene, names: Iterable[str]) -> tuple[Ref, ...]:
    """The conditions of letters that are in force, such as that of an answer."""
    known = frozenset(names)
    return tuple(
        fact.id
        for fact in scene.facts.values()
        if fact.kind == "case" and all(letters(tree) <= known for tree in trees_of(fact.relation))
    )


def not_negative(scene: Scene, size: sp.Expr) -> tuple[Ref, ...]:
    """What has to be known for the root of a square to be this, beyond what is silent."""
    odd = [
        factor
        for factor in sp.Mul.make_args(size)
        if not (factor.is_Pow and (factor.exp.is_even or factor.exp == sp.Rational(1, 2)))
    ]
    return nonzero(scene, sp.Mul(*odd), alone=True)


def nonzero(scene: Scene, factor: sp.Expr, *, alone: bool = False) -> tuple[Ref, ...]:
    """What has to be known for a factor not to vanish, beyond what is silent."""
    refs: list[Ref] = []
    for other in sp.Mul.make_args(factored(factor)):
        base = other.base if other.is_Pow else other
        for function in atoms_in(base, sp.sin, sp.cos):
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
    for factor in sp.Mul.make_args(factored(value)):
        base, power = factor.as_base_exp()
        if power.is_even:
            continue
        for function in atoms_in(base, sp.sin, sp.cos):
            refs += [range_of(scene, angle.name) for angle in function.free_symbols]
        for letter in sorted(base.free_symbols, key=lambda s: s.name):
            role = scene.model.unknowns.roles.get(letter.name)
            if role is not None and role.kind == "restitution":
                # It falls towards 0, from either side.
                falls = scene.model.sign(derivative(base, letter)) * scene.model.sign(base) < 0
                refs.append(f"{letter.name} <= 1" if falls else f"{letter.name} >= 0")
    return tuple(dict.fromkeys(refs))


def range_text(scene: Scene, name: str) -> str | None:
    """The range of an angle, as a premise says it; None where it is open."""
    try:
        return range_of(scene, name)
    except NotPlannedError:
        return None
