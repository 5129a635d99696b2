"""The altered laws and results of each misconception, as templates in the language of statements.

With c the unit vector along the line of centres, from the first body to the second (into a wall),
p is a component along c before the impact and q after it, s and r are those across it, U and V the
speeds. Where a student puts a sign by hand, each sign is a variant.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import product

from restitution.explaining.laws.templates import AXIS, across_line, along_line
from restitution.explaining.mistakes.alteration import Alteration, AlteredLaw, AlteredResult, Where
from restitution.expression.tree import COMPONENTS

_Body = str
_Plain = tuple[Where, tuple[AlteredLaw, ...], tuple[AlteredResult, ...], tuple[str, ...], str]

_BODIES: Mapping[Where, tuple[_Body, ...]] = {"wall": ("F",), "spheres": ("F", "S")}
_SIGNS = (1, -1)


def _p(body: _Body) -> str:
    return along_line(body, 0)


def _q(body: _Body) -> str:
    return along_line(body, 1)


def _s(body: _Body) -> str:
    return across_line(body, 0)


def _r(body: _Body) -> str:
    return across_line(body, 1)


def _before(body: _Body) -> str:
    """The speed before."""
    return f"speed({body}, 0)"


def _after(body: _Body) -> str:
    """The speed after."""
    return f"speed({body}, 1)"


def _signed(sign: int, term: str) -> str:
    return term if sign > 0 else f"(-{term})"


# --- laws with other terms in them ----------------------------------------------------------------


def _momentum(first: str, second: str, after: str = _q("F"), other: str = _q("S")) -> AlteredLaw:
    """Conservation of momentum with other terms for the components."""
    template = f"mass(F) {first} + mass(S) {second} = mass(F) {after} + mass(S) {other}"
    return AlteredLaw("momentum", template)


def _restitution(first: str, second: str, separation: str = f"{_q('S')} - {_q('F')}") -> AlteredLaw:
    """Newton's experimental law of two spheres with other terms for the components."""
    return AlteredLaw("restitution", f"{separation} = restitution(1) ({first} - {second})")


def _rebound(term: str) -> AlteredLaw:
    """Newton's experimental law at a wall with another term for the component before."""
    return AlteredLaw("restitution", f"{_q('F')} = -restitution(1) {term}")


def _across(body: str, value: str) -> AlteredLaw:
    """Another value for a component across the line of centres."""
    return AlteredLaw("unchanged", f"{_r(body)} = {value}", "F" if body == "F" else "S")


def _world(where: Where, *laws: AlteredLaw, senses: tuple[str, ...] = (), words: str) -> _Plain:
    return where, laws, (), senses, words


def _result(where: Where, *results: tuple[str, ...], words: str) -> _Plain:
    return where, (), tuple(AlteredResult(*result) for result in results), (), words


# --- the worlds -----------------------------------------------------------------------------------


def _restitution_parallel() -> Iterator[_Plain]:
    e = "restitution(1)"
    shrunk = _across("F", f"{e} {_s('F')}")
    through = AlteredLaw("restitution", f"{_q('F')} = {_p('F')}")
    reversed_ = AlteredLaw("restitution", f"{_q('F')} = -{_p('F')}")
    yield _world("wall", shrunk, reversed_, words="e times the component parallel to the wall")
    yield _world(
        "wall",
        shrunk,
        through,
        words="e times the component parallel to the wall, the other one not even reversed",
    )
    yield _world(
        "wall",
        _across("F", f"-{e} {_s('F')}"),
        through,
        words="the component parallel to the wall reversed and multiplied by e",
    )
    yield _world(
        "spheres",
        AlteredLaw(
            "momentum",
            f"mass(F) {_s('F')} + mass(S) {_s('S')} = mass(F) {_r('F')} + mass(S) {_r('S')}",
        ),
        AlteredLaw("restitution", f"{_r('S')} - {_r('F')} = {e} ({_s('F')} - {_s('S')})"),
        AlteredLaw("unchanged", f"{_q('F')} = {_p('F')}", "F"),
        AlteredLaw("unchanged", f"{_q('S')} = {_p('S')}", "S"),
        words="momentum and restitution across the line of centres, nothing changed along it",
    )
    yield _world(
        "spheres",
        _across("F", f"{e} {_s('F')}"),
        _across("S", f"{e} {_s('S')}"),
        AlteredLaw("restitution", f"{_q('F')} = {_p('F')}"),
        words="e times the components across the line of centres, those along it kept",
    )


def _restitution_whole_speed() -> Iterator[_Plain]:
    e = "restitution(1)"
    yield _world(
        "wall",
        AlteredLaw("restitution", f"{_after('F')} = {e} {_before('F')}"),
        words="speed after = e × speed before",
    )
    for after, before in (("-", "-"), ("+", "+"), ("-", "+"), ("+", "-")):
        law = f"{_after('S')} {after} {_after('F')} = {e} ({_before('F')} {before} {_before('S')})"
        words = f"the {_OF_SPEEDS[after]} of the speeds after = e × the {_OF_SPEEDS[before]} before"
        yield _world("spheres", AlteredLaw("restitution", law), words=words)


_OF_SPEEDS = {"-": "difference", "+": "sum"}


def _restitution_inverted() -> Iterator[_Plain]:
    e = "restitution(1)"
    yield _world(
        "wall",
        AlteredLaw("restitution", f"{e} {_q('F')} = -{_p('F')}"),
        words="e × speed of rebound = speed of approach",
    )
    law = f"{e} ({_q('S')} - {_q('F')}) = {_p('F')} - {_p('S')}"
    yield _world(
        "spheres",
        AlteredLaw("restitution", law),
        words="e × speed of separation = speed of approach",
    )


def _restitution_omitted() -> Iterator[_Plain]:
    yield _world(
        "wall",
        AlteredLaw("restitution", f"{_q('F')} = -{_p('F')}"),
        words="speed of rebound = speed of approach",
    )
    law = f"{_q('S')} - {_q('F')} = {_p('F')} - {_p('S')}"
    yield _world(
        "spheres", AlteredLaw("restitution", law), words="speed of separation = speed of approach"
    )


# Which terms have the wrong sign, of p and q of the first body and the second: single ones first.
_TERMS = {
    "pF": "the first body before",
    "pS": "the second body before",
    "qF": "the first body after",
    "qS": "the second body after",
}
_WRONG_SIGNS: tuple[tuple[str, ...], ...] = (
    *((term,) for term in _TERMS),
    ("pF", "pS"),
    ("pF", "qF"),
    ("pF", "qS"),
)


def _term_words(terms: tuple[str, ...]) -> str:
    return f"wrong sign of {' and of '.join(_TERMS[term] for term in terms)}"


def _momentum_sign() -> Iterator[_Plain]:
    terms = {"pF": _p("F"), "pS": _p("S"), "qF": _q("F"), "qS": _q("S")}
    for wrong in _WRONG_SIGNS:
        put = [_signed(-1 if name in wrong else 1, term) for name, term in terms.items()]
        yield _world("spheres", _momentum(*put), words=_term_words(wrong))


def _restitution_sign() -> Iterator[_Plain]:
    for wrong in (("qF",), ("qS",), ("pF",), ("pS",), ("qF", "qS"), ("qF", "pS"), ("qF", "pF")):
        signs = {name: -1 if name in wrong else 1 for name in ("pF", "pS", "qF", "qS")}
        separation = f"{_signed(signs['qS'], _q('S'))} - {_signed(signs['qF'], _q('F'))}"
        law = _restitution(_signed(signs["pF"], _p("F")), _signed(signs["pS"], _p("S")), separation)
        yield _world("spheres", law, words=_term_words(wrong))
    yield _world(
        "wall",
        AlteredLaw("restitution", f"{_q('F')} = restitution(1) {_p('F')}"),
        words="the component not reversed",
    )


def _with_terms(
    first: str, second: str, *, senses: tuple[str, ...], words: str
) -> Iterator[_Plain]:
    """The same terms before put into momentum and restitution, into one of them, or into both."""
    clm, nel = _momentum(first, second), _restitution(first, second)
    for laws, place in (((clm, nel), "both"), ((clm,), "momentum"), ((nel,), "restitution")):
        where = "momentum and restitution" if place == "both" else place
        yield _world("spheres", *laws, senses=senses, words=f"{words} in {where}")


def _speed_for_component() -> Iterator[_Plain]:
    yield _world("wall", _rebound(_before("F")), words="the whole speed towards the wall")
    yield _world(
        "wall",
        _rebound(_before("F")),
        _across("F", "0"),
        words="treated as a direct impact with the wall",
    )
    for signs in product(_SIGNS, repeat=2):
        first, second = (
            _signed(sign, _before(body)) for sign, body in zip(signs, "FS", strict=True)
        )
        senses = tuple(_signed(sign, _p(body)) for sign, body in zip(signs, "FS", strict=True))
        yield from _with_terms(first, second, senses=senses, words="whole speeds before")
        yield _world(
            "spheres",
            _momentum(first, second),
            _restitution(first, second),
            _across("F", "0"),
            _across("S", "0"),
            senses=senses,
            words="treated as a direct impact",
        )


def _speeds_after() -> Iterator[_Plain]:
    """Whole speeds after as well, and of one body alone: lines, of which no world is made."""
    for signs in product(_SIGNS, repeat=2):
        after = [_signed(sign, _after(body)) for sign, body in zip(signs, "FS", strict=True)]
        yield _world("spheres", _momentum(_p("F"), _p("S"), *after), words="whole speeds after")
        for sign in _SIGNS:
            before = _before("F"), _signed(sign, _before("S"))
            words = "whole speeds before and after"
            yield _world("spheres", _momentum(*before, *after), words=words)
    yield from _speed_of_one()


def _speed_of_one() -> Iterator[_Plain]:
    """The whole speed before of one body, the other resolved."""
    for body, sign in product("FS", _SIGNS):
        put = {sphere: _p(sphere) for sphere in "FS"} | {body: _signed(sign, _before(body))}
        senses = (_signed(sign, _p(body)),)
        words = f"the whole speed before {_NAMES[(body,)]}"
        yield from _with_terms(put["F"], put["S"], senses=senses, words=words)


def _exchanged(terms: Mapping[str, int]) -> tuple[tuple[str, str], tuple[str, ...]]:
    """Components before, some of them exchanged with those across, and what tells their signs."""
    first, second = (_signed(terms[body], _s(body)) if body in terms else _p(body) for body in "FS")
    senses = tuple(f"{_signed(sign, _s(body))} {_p(body)}" for body, sign in terms.items())
    return (first, second), senses


_SOME: tuple[tuple[str, ...], ...] = (("F",), ("S",), ("F", "S"))
_NAMES = {("F",): "of the first body", ("S",): "of the second body", ("F", "S"): "of both bodies"}


def _turned_round(signs: Mapping[str, int]) -> str:
    """Of which bodies a component stands with its sign changed: `` turned round``."""
    turned = tuple(body for body, sign in signs.items() if sign < 0)
    if not turned:
        return ""
    return (
        ", turned round" if len(turned) == len(signs) else f", that {_NAMES[turned]} turned round"
    )


def _sine_cosine() -> Iterator[_Plain]:
    for sign in _SIGNS:
        senses: tuple[str, ...] = (f"{_signed(sign, _s('F'))} {_p('F')}",)
        yield _world(
            "wall",
            _rebound(_signed(sign, _s("F"))),
            senses=senses,
            words="the parallel component in restitution",
        )
        yield _world(
            "wall",
            _across("F", _signed(sign, _p("F"))),
            senses=senses,
            words="the perpendicular component as the one that stays",
        )
    for bodies in _SOME:
        for signs in product(_SIGNS, repeat=len(bodies)):
            terms = dict(zip(bodies, signs, strict=True))
            put, senses = _exchanged(terms)
            words = f"sine for cosine {_NAMES[bodies]}"
            yield from _with_terms(*put, senses=senses, words=words)
            stays = [_across(body, _signed(sign, _p(body))) for body, sign in terms.items()]
            yield _world(
                "spheres", *stays, senses=senses, words=f"{words} in the component that stays"
            )


def _angle_from_normal() -> Iterator[_Plain]:
    for sign in _SIGNS:
        yield _world(
            "wall",
            _rebound(_signed(sign, _s("F"))),
            _across("F", _signed(sign, _p("F"))),
            senses=(f"{_signed(sign, _s('F'))} {_p('F')}",),
            words="90° − α in place of α",
        )
    for signs in product(_SIGNS, repeat=2):
        terms = dict(zip("FS", signs, strict=True))
        put, senses = _exchanged(terms)
        yield _world(
            "spheres",
            _momentum(*put),
            _restitution(*put),
            *(_across(body, _signed(sign, _p(body))) for body, sign in terms.items()),
            senses=senses,
            words="90° − α in place of α",
        )


def _across_exchanged() -> Iterator[_Plain]:
    yield _world(
        "spheres",
        _across("F", _s("S")),
        _across("S", _s("F")),
        words="each sphere takes the component of the other",
    )


def _across_changed() -> Iterator[_Plain]:
    places: tuple[tuple[Where, tuple[tuple[str, ...], ...]], ...] = (
        ("wall", (("F",),)),
        ("spheres", _SOME),
    )
    for where, choices in places:
        for bodies in choices:
            of = "" if where == "wall" else f" {_NAMES[bodies]}"
            shrunk = [_across(body, f"restitution(1) {_s(body)}") for body in bodies]
            yield _world(where, *shrunk, words=f"e times the component that stays{of}")
            yield _world(
                where,
                *(_across(body, "0") for body in bodies),
                words=f"no component left{of}",
            )
            for signs in product(_SIGNS, repeat=len(bodies)):
                terms = dict(zip(bodies, signs, strict=True))
                yield _world(
                    where,
                    *(_across(body, _signed(sign, _p(body))) for body, sign in terms.items()),
                    senses=_exchanged(terms)[1],
                    words=f"the other component in its place{of}{_turned_round(terms)}",
                )


def _mass_omitted() -> Iterator[_Plain]:
    law = f"{_p('F')} + {_p('S')} = {_q('F')} + {_q('S')}"
    yield _world("spheres", AlteredLaw("momentum", law), words="no masses in momentum")
    for where, bodies in _BODIES.items():
        lost = " + ".join(f"1/2 ({_before(x)}^2 - {_after(x)}^2)" for x in bodies)
        yield _result(
            where,
            ("energy_lost(1)", lost),
            ("energy(X, 0)", f"1/2 {_before('X')}^2"),
            ("energy(X, 1)", f"1/2 {_after('X')}^2"),
            words="no masses in the energy",
        )


def _mass_omitted_once() -> Iterator[_Plain]:
    """Masses left out on one side alone: lines, of which no world is made.

    There the bodies have none, or both that of one of them.
    """
    before, after = (f"mass(F) {function('F')} + mass(S) {function('S')}" for function in (_p, _q))
    for mass in ("1", "mass(F)", "mass(S)"):
        for law, when in (
            (f"{before} = {mass} ({_q('F')} + {_q('S')})", "after"),
            (f"{mass} ({_p('F')} + {_p('S')}) = {after}", "before"),
        ):
            words = f"masses left out in momentum {when} the impact"
            yield _world("spheres", AlteredLaw("momentum", law), words=words)


def _masses_exchanged() -> Iterator[_Plain]:
    law = f"mass(S) {_p('F')} + mass(F) {_p('S')} = mass(S) {_q('F')} + mass(F) {_q('S')}"
    yield _world("spheres", AlteredLaw("momentum", law), words="each mass with the other velocity")


def _masses_exchanged_once() -> Iterator[_Plain]:
    """Masses with the other velocity on one side alone: lines, of which no world is made."""
    right = [f"mass(F) {function('F')} + mass(S) {function('S')}" for function in (_p, _q)]
    wrong = [f"mass(S) {function('F')} + mass(F) {function('S')}" for function in (_p, _q)]
    for before, after, words in (
        (right[0], wrong[1], "each mass with the other velocity after the impact"),
        (wrong[0], right[1], "each mass with the other velocity before the impact"),
    ):
        yield _world("spheres", AlteredLaw("momentum", f"{before} = {after}"), words=words)


def _energy_conserved() -> Iterator[_Plain]:
    yield _world(
        "wall",
        AlteredLaw("restitution", f"{_after('F')} = {_before('F')}"),
        words="the speed is the same after",
    )
    law = "energy(F, 1) + energy(S, 1) = energy(F, 0) + energy(S, 0)"
    yield _world("spheres", AlteredLaw("restitution", law), words="no kinetic energy is lost")


def _second_wall_angle() -> Iterator[_Plain]:
    """The components into the second wall by the angle with the first one."""
    last = "line_of_centres(0)"
    into, by = f"along(velocity(F, 0), {last})", f"across(velocity(F, 0), {last})"
    first = [f"{part}(velocity(F, before), {last})" for part in COMPONENTS]
    share = [f"{_before('F')} abs({direction})/speed(F, before)" for direction in first]
    for (normal, beside), words in (
        ((f"abs({into})", f"abs({by})"), "the angle after the last wall"),
        ((share[0], share[1]), "the angle before the last wall"),
    ):
        for sign in _SIGNS:
            yield _world(
                "wall",
                _rebound(normal),
                _across("F", _signed(sign, beside)),
                senses=(_signed(sign, _s("F")),),
                words=words,
            )


# --- results --------------------------------------------------------------------------------------


def _angle(stage: int, line: str) -> str:
    return f"angle(velocity(X, {stage}), {line})"


def _deflection_is_after() -> Iterator[_Plain]:
    of = "deflection(X, 1)"
    yield _result("wall", (of, _angle(1, "S")), words="the angle to the wall after")
    yield _result("wall", (of, _angle(1, AXIS)), words="the angle to the normal after")
    yield _result("spheres", (of, _angle(1, AXIS)), words="the angle to the line of centres after")
    yield _result(
        "spheres",
        (of, f"90° - {_angle(1, AXIS)}"),
        words="the angle to the common tangent after",
    )
    words = "the obtuse angle to the line of centres after"
    yield _result("spheres", (of, f"180° - {_angle(1, AXIS)}"), words=words)


def _deflection_difference() -> Iterator[_Plain]:
    of = "deflection(X, 1)"
    lines: tuple[tuple[Where, str], ...] = (("wall", "S"), ("spheres", AXIS))
    for where, line in lines:
        before, after = _angle(0, line), _angle(1, line)
        for larger, smaller in ((before, after), (after, before)):
            less = f"{larger} - {smaller}"
            yield _result(where, (of, less, less), words="the difference of the angles")
            words = "180° less the difference of the angles"
            yield _result(where, (of, f"180° - ({less})", less), words=words)
        yield _result(where, (of, f"{before} + {after}"), words="the sum of the angles")
        words = "180° less the sum of the angles"
        yield _result(where, (of, f"180° - ({before} + {after})"), words=words)
        words = "the sum of the angles, of which one is to the other line"
        yield _result(where, (of, f"{before} + 90° - {after}"), words=words)
        yield _result(where, (of, f"90° - {before} + {after}"), words=words)


def _impulse_sign() -> Iterator[_Plain]:
    for where, bodies in _BODIES.items():
        for body in bodies:
            total = f"({_q(body)} + {_p(body)})"
            yield _result(
                where,
                ("impulse(1)", f"mass({body}) abs{total}"),
                (f"impulse({body}, 1)", f"mass({body}) {total} {AXIS}"),
                words=f"a sign lost {_NAMES[(body,)]}",
            )


def _impulse_of_speeds() -> Iterator[_Plain]:
    for where, bodies in _BODIES.items():
        for body in bodies:
            for sign, kind in (("-", "difference"), ("+", "sum")):
                yield _result(
                    where,
                    ("impulse(1)", f"mass({body}) abs({_after(body)} {sign} {_before(body)})"),
                    words=f"mass × the {kind} of the speeds {_NAMES[(body,)]}",
                )


def _change(body: str) -> str:
    return f"(velocity({body}, 1) - velocity({body}, 0))"


def _energy_of_difference() -> Iterator[_Plain]:
    lost = "energy(X, 0) - energy(X, 1)"
    for where, bodies in _BODIES.items():
        squares = {x: f"1/2 mass({x}) dot({_change(x)}, {_change(x)})" for x in ("X", *bodies)}
        speeds = {x: f"1/2 mass({x}) ({_before(x)} - {_after(x)})^2" for x in ("X", *bodies)}
        for terms, words in ((squares, "of velocities"), (speeds, "of speeds")):
            yield _result(
                where,
                ("energy_lost(1)", " + ".join(terms[x] for x in bodies)),
                (lost, terms["X"]),
                words=f"the square of a difference {words}",
            )
    sizes = f"1/2 mass(X) ({_p('X')} + {_q('X')})^2"
    yield _result(
        "wall",
        ("energy_lost(1)", sizes),
        (lost, sizes),
        words="the square of a difference of sizes of components",
    )


def _energy_one_sphere() -> Iterator[_Plain]:
    for body in "FS":
        yield _result(
            "spheres",
            ("energy_lost(1)", f"energy({body}, 0) - energy({body}, 1)"),
            words=f"the energy {_NAMES[(body,)]} alone",
        )


def _energy_fraction_of_line() -> Iterator[_Plain]:
    for where, bodies in _BODIES.items():
        before = " + ".join(f"1/2 mass({x}) {_p(x)}^2" for x in bodies)
        after = " + ".join(f"1/2 mass({x}) {_q(x)}^2" for x in bodies)
        yield _result(
            where,
            ("energy_lost(1)/energy(0)", f"energy_lost(1)/({before})"),
            ("energy(1)/energy(0)", f"({after})/({before})"),
            words="a fraction of the energy along the line of centres",
        )


def _energy_component_missing() -> Iterator[_Plain]:
    for where, bodies in _BODIES.items():
        for stage, component, sign in ((1, _r, "+"), (0, _s, "-")):
            terms = {x: f"1/2 mass({x}) {component(x)}^2" for x in ("X", *bodies)}
            missing = " + ".join(terms[x] for x in bodies)
            yield _result(
                where,
                ("energy_lost(1)", f"energy_lost(1) {sign} ({missing})"),
                (f"energy({stage})", f"energy({stage}) - ({missing})"),
                (f"energy(X, {stage})", f"energy(X, {stage}) - {terms['X']}"),
                words=f"one component left out {'after' if stage else 'before'}",
            )


def _energy_ratio_as_speed() -> Iterator[_Plain]:
    single = (
        ("energy(X, 0)", f"mass(X) {_before('X')}"),
        ("energy(X, 1)", f"mass(X) {_after('X')}"),
    )
    yield _result(
        "wall",
        *single,
        ("energy(0)", f"mass(F) {_before('F')}"),
        ("energy(1)", f"mass(F) {_after('F')}"),
        ("energy_lost(1)", f"mass(F) ({_before('F')} - {_after('F')})"),
        words="speeds in the ratio of the energies",
    )
    yield _result("spheres", *single, words="speeds in the ratio of the energies")


def _energy_no_half() -> Iterator[_Plain]:
    for where, bodies in _BODIES.items():
        for stage, sign in ((1, "-"), (0, "+")):
            extra = " + ".join(f"energy({x}, {stage})" for x in bodies)
            yield _result(
                where,
                ("energy_lost(1)", f"energy_lost(1) {sign} ({extra})"),
                (f"energy({stage})", f"energy({stage}) + {extra}"),
                (f"energy(X, {stage})", f"2 energy(X, {stage})"),
                words=f"no half {'after' if stage else 'before'}",
            )
        yield _result(
            where,
            ("energy_lost(1)", "2 energy_lost(1)"),
            *((f"energy({stage})", f"2 energy({stage})") for stage in (0, 1)),
            *((f"energy(X, {stage})", f"2 energy(X, {stage})") for stage in (0, 1)),
            words="no half anywhere",
        )


def _square_not_taken() -> Iterator[_Plain]:
    e = "restitution(1)"
    yield _result(
        "wall", (_after("F"), f"sqrt({e} {_p('F')}^2 + {_r('F')}^2)"), words="e not squared"
    )
    for where, bodies in _BODIES.items():
        lost = f"energy_lost(1)/(1 + {e})"
        yield _result(where, ("energy_lost(1)", lost), words="e not squared in the energy")
        late = " - ".join(f"1/2 mass({x}) {_after(x)}" for x in bodies)
        early = " + ".join(f"energy({x}, 0)" for x in bodies)
        yield _result(
            where,
            ("energy_lost(1)", f"{early} - {late}"),
            ("energy(X, 1)", f"1/2 mass(X) {_after('X')}"),
            words="the speed after not squared",
        )
        for along, across in (
            (f"abs({_q('X')})", f"{_r('X')}^2"),
            (f"{_q('X')}^2", f"abs({_r('X')})"),
        ):
            yield _result(
                where, (_after("X"), f"sqrt({along} + {across})"), words="a component not squared"
            )


def _relative_speeds() -> Iterator[_Plain]:
    """The size of the relative velocity, in both directions: lines, of which no world is made."""
    before = f"sqrt(({_p('F')} - {_p('S')})^2 + ({_s('F')} - {_s('S')})^2)"
    after = f"sqrt(({_q('F')} - {_q('S')})^2 + ({_r('F')} - {_r('S')})^2)"
    yield _world(
        "spheres",
        AlteredLaw("restitution", f"{after} = restitution(1) {before}"),
        words="the relative speed after = e × the relative speed before",
    )


_MAKERS: Mapping[str, Callable[[], Iterator[_Plain]]] = {
    "deflection-is-after": _deflection_is_after,
    "deflection-difference": _deflection_difference,
    "restitution-parallel": _restitution_parallel,
    "restitution-whole-speed": _restitution_whole_speed,
    "restitution-inverted": _restitution_inverted,
    "restitution-omitted": _restitution_omitted,
    "momentum-sign": _momentum_sign,
    "restitution-sign": _restitution_sign,
    "impulse-sign": _impulse_sign,
    "speed-for-component": _speed_for_component,
    "sine-cosine": _sine_cosine,
    "angle-from-normal": _angle_from_normal,
    "across-exchanged": _across_exchanged,
    "across-changed": _across_changed,
    "mass-omitted": _mass_omitted,
    "masses-exchanged": _masses_exchanged,
    "energy-of-difference": _energy_of_difference,
    "energy-one-sphere": _energy_one_sphere,
    "energy-fraction-of-line": _energy_fraction_of_line,
    "energy-component-missing": _energy_component_missing,
    "energy-ratio-as-speed": _energy_ratio_as_speed,
    "energy-conserved": _energy_conserved,
    "energy-no-half": _energy_no_half,
    "square-not-taken": _square_not_taken,
    "impulse-of-speeds": _impulse_of_speeds,
    "second-wall-angle": _second_wall_angle,
}
# Lines of these are known, and no world.
_OF_LINES: Mapping[str, Callable[[], Iterator[_Plain]]] = {
    "speed-for-component": _speeds_after,
    "restitution-whole-speed": _relative_speeds,
    "masses-exchanged": _masses_exchanged_once,
    "mass-omitted": _mass_omitted_once,
}


def alterations_of(mistake: str) -> tuple[Alteration, ...]:
    """The variants of a misconception, numbered from 1; none where it alters no law or result."""
    return _ALTERATIONS.get(mistake, ())


def _numbered(mistake: str) -> tuple[Alteration, ...]:
    plain = [(variant, True) for variant in _MAKERS[mistake]()]
    plain += [(variant, False) for variant in _OF_LINES.get(mistake, tuple)()]
    return tuple(
        Alteration(f"{mistake}/{number}", *variant[:4], solvable, variant[4])
        for number, (variant, solvable) in enumerate(plain, 1)
    )


_ALTERATIONS: Mapping[str, tuple[Alteration, ...]] = {
    mistake: _numbered(mistake) for mistake in _MAKERS
}
