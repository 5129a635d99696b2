"""Impulses given from outside."""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sp

from restitution.exact import tidy
from restitution.explain.geometry import given_after
from restitution.explain.phrases import bold_velocity, chain, look, product_of
from restitution.explain.steps import side
from restitution.explaining.marks import A1, M1
from restitution.explaining.saying import say
from restitution.problem import Kick
from restitution.render import layout as lay
from restitution.render.layout import Brackets, Layout
from restitution.vector import Vector

if TYPE_CHECKING:
    from restitution.explain.working import Working


def kick(work: Working, number: int) -> None:
    """Impulse = change of momentum, as an equation of vectors."""
    if ("kick", number) in work.done:
        return
    work.done.add(("kick", number))
    event = work.model.happening(number)
    assert isinstance(event.step, Kick)
    body = event.step.body
    story = work.model.story
    final = work.model.branch.story
    u, v = (final.velocity(body, number - k) for k in (1, 0))
    u, v = Vector(tidy(u.x), tidy(u.y)), Vector(tidy(v.x), tidy(v.y))
    mass = tidy(sp.sympify(work._known(sp.sympify(final.mass(body), strict=True)), strict=True))
    assert event.impulse is not None
    sought = work.open(tuple(event.impulse))
    given = final.happenings[number - 1].impulse
    assert given is not None
    push = Vector(tidy(given.x), tidy(given.y))
    name = bold_velocity(body)
    told = event.after[body]
    kinds = given_after(work, body, number)
    turned = "speed" in kinds and bool(kinds & {"direction", "deflection"})
    if sought and turned:
        row = chain(side((v.x, v.y), name), side((v.x, v.y)), points=(M1,))
        work.write("fact", [row], sentences=(say("given.velocity-kick", body=body),))
    if sought and not turned and "velocity" not in kinds:
        # The velocity after follows in terms of the blow, which other facts fix.
        raw = (event.impulse.x, event.impulse.y)
        put = work.put(told)
        rows = [
            chain(
                side(raw),
                side(raw, _times(mass, _difference(name, u))),
                points=(M1,),
            ),
            chain(side((put.x, put.y), name), side((put.x, put.y)), points=(A1,)),
        ]
        work.write("principle", rows, say("impulse.title"))
        return
    if sought:
        # The blow itself is wanted: the velocities are known.
        raw = (event.impulse.x, event.impulse.y)
        rows = [
            chain(
                side(raw),
                side((push.x, push.y), _times(mass, _difference(look((v.x, v.y)), u))),
                side((push.x, push.y)),
                points=(M1, A1),
            )
        ]
        work.write("principle", rows, say("impulse.title"))
        for part, value in zip(raw, push, strict=True):
            del part, value
        return
    for each in event.before.values():
        work.reach(work.open(tuple(each)))
    rows = [
        chain(
            side((push.x, push.y)),
            side((push.x, push.y), _times(mass, _difference(name, u))),
            points=(M1,),
        ),
        chain(side((v.x, v.y), name), side((v.x, v.y)), points=(A1,)),
    ]
    del story
    work.done.add(("velocity", body, number))
    work.write("principle", rows, say("impulse.title"))


def _difference(first: Layout, u: Vector) -> Layout:
    """The velocity after less that before."""
    second = look((u.x, u.y))
    if second == lay.ZERO_VECTOR:
        return first
    a: Layout = Brackets(first) if isinstance(first, lay.Sum) else first
    b: Layout = Brackets(second) if isinstance(second, lay.Sum) else second
    return lay.Sum((("+", a), ("-", b)))


def _times(mass: sp.Expr, inside: Layout) -> Layout:
    if mass == 1:
        return inside
    return product_of(mass, Brackets(inside) if isinstance(inside, lay.Sum) else inside)
