"""Impulses given from outside."""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sp

from restitution.exact import tidy
from restitution.explain.geometry import given_after
from restitution.explain.phrases import chain
from restitution.explain.steps import side
from restitution.explaining.marks import A1, M1
from restitution.explaining.printing import printed
from restitution.explaining.saying import say
from restitution.problem import Kick
from restitution.render.layout import Bold
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
    final = work.model.branch.story
    u, v = (final.velocity(body, number - k) for k in (1, 0))
    u, v = Vector(tidy(u.x), tidy(u.y)), Vector(tidy(v.x), tidy(v.y))
    mass = tidy(sp.sympify(work._known(sp.sympify(final.mass(body), strict=True)), strict=True))
    assert event.impulse is not None
    sought = work.open(tuple(event.impulse))
    given = final.happenings[number - 1].impulse
    assert given is not None
    push = Vector(tidy(given.x), tidy(given.y))
    name = Bold("v", body)
    kinds = given_after(work, body, number)
    turned = "speed" in kinds and bool(kinds & {"direction", "deflection"})
    if sought and turned:
        row = chain(side((v.x, v.y), name), side((v.x, v.y)), points=(M1,))
        work.write("fact", [row], sentences=(say("given.velocity-kick", body=body),))
    if sought and not turned and "velocity" not in kinds:
        # The velocity after follows in terms of the blow, which other facts fix.
        raw = (event.impulse.x, event.impulse.y)
        put = work.put(event.after[body])
        rows = [
            chain(
                side(raw),
                side(raw, printed("m*(v - u)", m=mass, v=name, u=(u.x, u.y))),
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
                side((push.x, push.y), printed("m*(v - u)", m=mass, v=(v.x, v.y), u=(u.x, u.y))),
                side((push.x, push.y)),
                points=(M1, A1),
            )
        ]
        work.write("principle", rows, say("impulse.title"))
        return
    for each in event.before.values():
        work.reach(work.open(tuple(each)))
    rows = [
        chain(
            side((push.x, push.y)),
            side((push.x, push.y), printed("m*(v - u)", m=mass, v=name, u=(u.x, u.y))),
            points=(M1,),
        ),
        chain(side((v.x, v.y), name), side((v.x, v.y)), points=(A1,)),
    ]
    work.done.add(("velocity", body, number))
    work.write("principle", rows, say("impulse.title"))
