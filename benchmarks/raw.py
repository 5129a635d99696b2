"""The principles of some examples as raw equations, written by hand for ``sympy.solve``.

What somebody who knows SymPy would type: unknown components after each impact, conservation of
momentum and Newton's experimental law along the line of centres, impulse, energy and facts as
equations. Angles that are given are put in by sine and cosine; an unknown angle is its tangent
where that is natural, and else its sine and cosine with their identity.
"""

from __future__ import annotations

from collections.abc import Callable

from sympy import Eq, Expr, Rational, Symbol, sqrt, symbols

System = tuple[list[Eq], list[Symbol]]

u, m, e, k, r = symbols("u m e k r", positive=True)
v, w, x, y, a, b = symbols("v w x y a b", real=True)
J, E, c, s, d, t, q = symbols("J E c s d t q", real=True)
half = Rational(1, 2)


def spheres(m1: Expr, m2: Expr, u1: Expr, u2: Expr, v1: Expr, v2: Expr, e: Expr) -> list[Eq]:
    """Momentum and restitution along the line of centres."""
    return [Eq(m1 * u1 + m2 * u2, m1 * v1 + m2 * v2), Eq(v2 - v1, e * (u1 - u2))]


def two_spheres_with_vectors() -> System:
    lost = half * 2 * (16 - v**2) + half * 3 * (9 - w**2)
    return [
        *spheres(2, 3, -4, 3, v, w, Rational(3, 7)),
        Eq(J, 2 * (v + 4)),
        Eq(E, lost),
        Eq(c * 5 * sqrt(9 + v**2), 9 - 4 * v),
        Eq(d * sqrt(13) * sqrt(4 + w**2), 4 + 3 * w),
    ], [v, w, J, E, c, d]


def wall_with_vectors() -> System:
    return [
        Eq(v, half * 8),
        Eq(s**2, 36 + v**2),
        Eq(6 * t, v),
        Eq(J, half * (v + 8)),
        Eq(E, half * half * (64 - v**2)),
        Eq(c * 10 * s, 36 - 8 * v),
    ], [v, s, t, J, E, c]


def wall_in_letters() -> System:
    # a = tan alpha, with cos alpha = 1/sqrt(1 + a²)
    return [
        Eq(x, u / sqrt(1 + a**2)),
        Eq(v, e * u * a / sqrt(1 + a**2)),
        Eq(t * x, v),
        Eq(s, x**2 + v**2),
        Eq(J, m * (v + u * a / sqrt(1 + a**2))),
        Eq(E, half * m * (u**2 * a**2 / (1 + a**2) - v**2)),
        Eq(d * (1 - a * t), a + t),
    ], [x, v, t, s, J, E, d]


def find_e_and_mass_ratio() -> System:
    part = u / sqrt(2)
    return [
        *spheres(m, k * m, part, 0, v, w, e),
        Eq(v, 0),
        Eq(half * m * (part**2 - v**2) - half * k * m * w**2, half * m * u**2 / 4),
    ], [v, w, e, k]


def which_line_of_centres() -> System:
    # (c, s) is the line of centres; momentum gives B, restitution e
    return [
        Eq(6 - 2, 3 + 2 * x),
        Eq(-5 - 12, -9 + 2 * y),
        Eq((3 - 6) * s, (-9 + 5) * c),
        Eq(c**2 + s**2, 1),
        Eq((x - 3) * c + (y + 9) * s, e * (7 * c + s)),
        Eq(d, 6 * c - 5 * s),
    ], [x, y, c, s, e, d]


def unknown_mass() -> System:
    return [*spheres(m, 3, -4, 3, 2, -1, e), Eq(J, m * (2 + 4))], [m, e, J]


def brought_to_rest() -> System:
    return [
        *spheres(m, k * m, u, 0, 0, w, e),
        Eq(q, 1 - k * w**2 / u**2),
    ], [e, w, q]


def right_angles_afterwards() -> System:
    # a = sin theta, c = cos theta
    return [
        *spheres(m, 3 * m, u * c, 0, v, w, e),
        Eq(v * w, 0),
        Eq(half * m * ((u * c) ** 2 - v**2) - half * 3 * m * w**2, half * m * u**2 / 6),
        Eq(a**2 + c**2, 1),
    ], [v, w, e, a, c]


def parallel_paths() -> System:
    return [
        Eq(2 * r * s, Rational(8, 5) * r),
        Eq(c**2 + s**2, 1),
        *spheres(3 * m, 2 * m, u * c, -2 * u * c, v, w, Rational(1, 6)),
        Eq(J, 3 * m * (u * c - v)),
        Eq(x, v * c + u * s * s),
        Eq(y, v * s - u * s * c),
        Eq(a, w * c - 2 * u * s * s),
        Eq(b, w * s + 2 * u * s * c),
    ], [c, s, v, w, J, x, y, a, b]


def three_in_line() -> System:
    lost = half * m * u**2 - half * m * v**2 - half * 2 * m * x**2 - half * 4 * m * y**2
    return [
        *spheres(m, 2 * m, u, 0, v, w, half),
        *spheres(2 * m, 4 * m, w, 0, x, y, half),
        Eq(q, lost / (half * m * u**2)),
    ], [v, w, x, y, q]


def find_e_at_a_wall() -> System:
    return [
        Eq(v, e * u * sqrt(3) / 2),
        Eq(v, (u / 2) / sqrt(3)),
        Eq(s**2, (u / 2) ** 2 + v**2),
        Eq(J, m * (v + u * sqrt(3) / 2)),
    ], [v, e, s, J]


def speeds_and_angles() -> System:
    part = u * sqrt(3) / 2
    lost = half * m * (part**2 + (u / 2) ** 2 - v**2 - w**2)
    return [
        *spheres(m, m, part, -u / 2, v, w, sqrt(3) / 3),
        Eq(q, lost / (m * u**2)),
    ], [v, w, q]


def corner() -> System:
    along, normal = (half, sqrt(3) / 2), (sqrt(3) / 2, -half)
    p, n = u / 2, v
    return [
        Eq(v, half * u * sqrt(3) / 2),
        Eq(s**2, p**2 + v**2),
        Eq(w, half * (p * normal[0] + n * normal[1])),
        Eq(x, p * along[0] + n * along[1]),
        Eq(d**2, w**2 + x**2),
    ], [v, s, w, x, d]


def two_unknown_angles() -> System:
    return [
        *spheres(2, 1, 5 * c, -5 * d, v, 3, half),
        Eq(5 * t, 3),
        Eq(d**2 + t**2, 1),
        Eq(c**2 + s**2, 1),
        Eq(y, 5 * s),
    ], [c, s, d, t, v, y]


def unknown_wall() -> System:
    # (c, s) is the direction of the wall
    return [
        Eq(c**2 + s**2, 1),
        Eq(2 * c + 2 * s, 4 * c - 2 * s),
        Eq(-2 * s + 2 * c, -e * (-4 * s - 2 * c)),
    ], [c, s, e]


def mass_ratio() -> System:
    # c = cos alpha; a and b are B's component and the coefficient in part c, where k = 3
    return [
        *spheres(m, k * m, u * c, 0, v, w, e),
        Eq(v, 0),
        *spheres(m, 3 * m, u * c, 0, 0, a, b),
        Eq(q, 1 - (3 * a**2 + u**2 * (1 - c**2)) / u**2),
    ], [v, w, k, a, b, q]


def rejected_root() -> System:
    part = u / sqrt(2)
    return [
        *spheres(m, m, part, 0, v, w, e),
        Eq(part**2, (4 * v) ** 2),
    ], [v, w, e]


def velocities_before() -> System:
    return [
        Eq(a + 2 * b, -1 + 2 * 2),
        Eq(2 + 1, half * (a - b)),
        Eq(x, 2),
        Eq(y, -1),
        Eq(E, half * (a**2 - 1) + half * 2 * (b**2 - 4)),
    ], [a, b, x, y, E]


def two_angles_of_approach() -> System:
    # t = tan alpha; before (1, t), after (1/4, t): the angle between has tangent 3/5
    return [
        *spheres(m, m, 1, 0, v, w, half),
        Eq((t - v * t) * 5, 3 * (v + t**2)),
        Eq(s**2 * (1 + t**2), u**2 * (v**2 + t**2)),
    ], [v, w, t, s]


def energy_lost_at_a_wall() -> System:
    # the three parts: a fraction, a coefficient, and t = tan alpha
    return [
        Eq(v, half * 3 * u / 5),
        Eq(q, ((3 * u / 5) ** 2 - v**2) / u**2),
        Eq(w, e * u * sqrt(3) / 2),
        Eq(half * m * (3 * u**2 / 4 - w**2), half * m * u**2 / 4),
        Eq(c**2 + s**2, 1),
        Eq(x, half * u * s),
        Eq(half * m * ((u * s) ** 2 - x**2), half * half * m * u**2),
    ], [v, q, w, e, c, s, x]


def quarter_lost_at_right_angles() -> System:
    # c, s: cosine and sine of alpha
    return [
        Eq(c**2 + s**2, 1),
        Eq(c**2, e * s**2),
        Eq((1 - e**2) * s**2, Rational(1, 4)),
    ], [c, s, e]


def sphere_at_rest() -> System:
    lost = half * m * ((u / 2) ** 2 - v**2) - half * 2 * m * w**2
    return [
        *spheres(m, 2 * m, u / 2, 0, v, w, half),
        Eq(J, 2 * m * w),
        Eq(q, lost / (half * m * u**2)),
    ], [v, w, J, q]


SYSTEMS: dict[str, Callable[[], System]] = {
    each.__name__.replace("_", "-"): each
    for each in (
        two_spheres_with_vectors,
        wall_with_vectors,
        wall_in_letters,
        find_e_and_mass_ratio,
        which_line_of_centres,
        unknown_mass,
        brought_to_rest,
        right_angles_afterwards,
        parallel_paths,
        three_in_line,
        find_e_at_a_wall,
        speeds_and_angles,
        corner,
        two_unknown_angles,
        unknown_wall,
        mass_ratio,
        rejected_root,
        velocities_before,
        two_angles_of_approach,
        energy_lost_at_a_wall,
        quarter_lost_at_right_angles,
        sphere_at_rest,
    )
}
