"""The principles of some examples as raw equations, written by hand for ``sympy.solve``.

What somebody who knows SymPy would type: unknown components after each impact, conservation of
momentum and Newton's experimental law along the line of centres, impulse, energy and facts as
equations. Angles that are given are put in by sine and cosine; an unknown angle is its tangent
where that is natural, and else its sine and cosine with their identity.

Here are examples in which every item is a value or an equation: a range, an inequality or a
greatest value is no matter of ``sympy.solve``.
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


def angle_on_either_side() -> System:
    part = u / sqrt(2)
    return [
        *spheres(m, 2 * m, part, 0, v, w, e),
        Eq(part**2, (4 * v) ** 2),
    ], [v, w, e]


def bank_shot() -> System:
    # a = tan alpha, c = cos alpha; x is where it strikes the wall
    return [
        Eq(x * a, 2),
        Eq((8 - x) * half * a, 2),
        Eq(t * u * c, 8),
        Eq(c**2 * (1 + a**2), 1),
        Eq(d**2, (8 - x) ** 2 + 4),
    ], [x, a, c, t, d]


def before_the_wall() -> System:
    return [
        Eq(2, -half * y),
        Eq(x, 4),
        Eq(s**2, x**2 + y**2),
        Eq(t * x, y),
        Eq(J, 2 * (2 - y)),
    ], [x, y, s, t, J]


def both_moving_at_angles() -> System:
    lost = half * 2 * m * (9 * u**2 - v**2) + half * m * (16 * u**2 - w**2)
    return [
        *spheres(2 * m, m, 3 * u, -4 * u, v, w, Rational(5, 7)),
        Eq(a**2, v**2 + 16 * u**2),
        Eq(b**2, w**2 + 9 * u**2),
        Eq(t * v, -4 * u),
        Eq(c * 5 * u * a, 3 * u * v + 16 * u**2),
        Eq(J, 2 * m * (3 * u - v)),
        Eq(E, lost),
    ], [v, w, a, b, t, c, J, E]


def component_of_either_sign() -> System:
    return [Eq(v, 2), Eq(x**2 + v**2, 20)], [x, v]


def components_as_letters() -> System:
    return [*spheres(m, m, u / 2, 0, v, w, e), Eq(w, 3 * v)], [v, w, e]


def corner_energy() -> System:
    # c, s: cosine and sine of alpha
    return [
        Eq(v, e * u * s),
        Eq(w, e * u * c),
        Eq(q**2, v**2 + w**2),
        Eq(half * m * (u**2 - v**2 - w**2), Rational(9, 25) * half * m * u**2),
        Eq(s**2, 1 - c**2),
    ], [v, w, q, e, s]


def cushion_then_ball() -> System:
    third = Rational(1, 3)
    at_wall = half * m * (16 - x**2)
    lost = half * m * (9 - v**2) - m * w**2
    return [
        Eq(x, half * 4),
        *spheres(m, 2 * m, 3, 0, v, w, third),
        Eq(s**2, v**2 + x**2),
        Eq(J, m * (x + 4)),
        Eq(y, 2 * m * w),
        Eq(a, at_wall),
        Eq(b, lost),
        Eq(E, at_wall + lost),
        Eq(d, half * m * (9 + x**2)),
        Eq(c * 5 * sqrt(9 + x**2), 9 - 4 * x),
        Eq(t * sqrt(9 + x**2) * s, 3 * v + x**2),
    ], [x, v, w, s, J, y, a, b, E, d, c, t]


def distance_after_impact() -> System:
    return [
        *spheres(2, 3, -4, 3, v, w, Rational(3, 7)),
        Eq(d**2, (2 * (3 - 2)) ** 2 + (2 * (v - w)) ** 2),
        Eq(q**2, (t * (3 - 2)) ** 2 + (t * (v - w)) ** 2),
    ], [v, w, d, q]


def find_the_blow() -> System:
    # (c, s): cosine and sine of theta
    return [
        Eq(-J * s, half * (1 - 4)),
        Eq(J * c, half * 4),
        Eq(c**2 + s**2, 1),
        Eq(v**2, 17),
        Eq(w * 4 * v, 4),
    ], [J, c, s, v, w]


def find_the_offset() -> System:
    # (c, s) is the line of centres, along which B moves off
    return [
        Eq(c, sqrt(3) / 2),
        Eq(s, half),
        Eq(2 * r * s, d),
        *spheres(m, m, u * c, 0, v, w, e),
        Eq(J, m * w),
    ], [c, s, d, v, w, J]


def parallel_walls() -> System:
    return [
        Eq(0, 1 - 2 * a),
        Eq(v, half * 2),
        Eq(3, v * (b - a)),
        Eq(w, half * v),
        Eq(0, 3 - w * (c - b)),
        Eq(x, 3 * c),
        Eq(y, v * (2 - a)),
        Eq(d, 3 * (c - a)),
        Eq(q, half * w),
        Eq(s**2, 9 + q**2),
    ], [a, v, b, w, c, x, y, d, q, s]


def slanting_wall() -> System:
    return [
        Eq(a, Rational(7 * 3 + 1 * 4, 5)),
        Eq(b, Rational(-7 * 4 + 1 * 3, 5)),
        Eq(v, -Rational(3, 5) * b),
        Eq(x, (3 * a - 4 * v) / 5),
        Eq(y, (4 * a + 3 * v) / 5),
        Eq(s**2, x**2 + y**2),
        Eq(t * a, v),
        Eq(J, 2 * (v - b)),
    ], [a, b, v, x, y, s, t, J]


def speed_from_impulse() -> System:
    return [
        *spheres(3, 2, u / 2, 0, v, w, Rational(1, 3)),
        Eq(2 * w, 12),
        Eq(s**2, v**2 + 3 * u**2 / 4),
    ], [v, w, u, s]


def struck_on_the_other_side() -> System:
    return [
        Eq(2 * r * s, -r),
        Eq(c**2 + s**2, 1),
        *spheres(m, m, u * c, 0, v, w, half),
        Eq(x, w * c),
        Eq(y, w * s),
        Eq(a, v * c + u * s * s),
        Eq(b, v * s - u * s * c),
        Eq(t * a, b),
    ], [c, s, v, w, x, y, a, b, t]


def struck_then_wall() -> System:
    return [
        Eq(2 * (x - 3), 2),
        Eq(2 * y, -8),
        Eq(E, half * 2 * (x**2 + y**2)),
        Eq(v, -half * y),
        Eq(J, 2 * (v - y)),
        Eq(c * sqrt(x**2 + y**2) * sqrt(x**2 + v**2), x**2 + y * v),
        Eq(d, half * 2 * (y**2 - v**2)),
    ], [x, y, E, v, J, c, d]


def three_spheres_oblique() -> System:
    return [
        *spheres(m, m, u / 2, 0, v, w, half),
        Eq(a, v / 2 + u * 3 / 4),
        Eq(b, v * sqrt(3) / 2 - u * sqrt(3) / 4),
        *spheres(m, m, w * sqrt(3) / 2, 0, x, y, half),
        Eq(c, x * sqrt(3) / 2 - w / 4),
        Eq(d, x / 2 + w * sqrt(3) / 4),
    ], [v, w, a, b, x, y, c, d]


def two_coefficients_of_a_corner() -> System:
    return [
        Eq(x, -8),
        Eq(y, 6 * a),
        Eq(3, y),
        Eq(2, -b * x),
    ], [x, y, a, b]


def velocity_by_speed_and_angle() -> System:
    # the speed is s, its angle has cosine 1/7
    return [
        *spheres(1, 1, 2, 0, v, w, e),
        Eq(v, s / 7),
        Eq(2 * sqrt(3), s * 4 * sqrt(3) / 7),
    ], [v, w, e, s]


def wall_at_an_unknown_angle() -> System:
    # (c, s) is the direction of the wall, v the speed afterwards, along j
    return [
        Eq(c**2 + s**2, 1),
        Eq(v * s, u * c),
        Eq(v * c, u * s / 3),
    ], [c, s, v]


def meeting_again() -> System:
    return [
        Eq(6 * a, 6),
        *spheres(1, 2, 6, 0, v, w, half),
        Eq(6 + w * (b - a), 10),
        Eq(x, -w / 3),
        Eq(d, 10 - 6 - v * (b - a)),
        Eq(q, 10 + x * (3 - b) - 6 - v * (3 - a)),
        Eq(10 + x * (t - b), 6 + v * (t - a)),
        *spheres(1, 2, v, x, y, s, half),
    ], [a, v, w, b, x, d, q, t, y, s]


def radius_of_the_ball() -> System:
    return [
        Eq(half, Rational(5, 2) - 4 * t),
        Eq(x, 3 * t),
        Eq(v, Rational(3, 4) * 4),
        Eq(y, half + v * (2 - t)),
    ], [t, x, v, y]


SYSTEMS: dict[str, Callable[[], System]] = {
    each.__name__.replace("_", "-"): each
    for each in (
        two_spheres_with_vectors,
        wall_with_vectors,
        wall_in_letters,
        find_e_and_mass_ratio,
        which_line_of_centres,
        unknown_mass,
        right_angles_afterwards,
        parallel_paths,
        find_e_at_a_wall,
        speeds_and_angles,
        corner,
        two_unknown_angles,
        unknown_wall,
        rejected_root,
        velocities_before,
        two_angles_of_approach,
        energy_lost_at_a_wall,
        quarter_lost_at_right_angles,
        angle_on_either_side,
        bank_shot,
        before_the_wall,
        both_moving_at_angles,
        component_of_either_sign,
        components_as_letters,
        corner_energy,
        cushion_then_ball,
        distance_after_impact,
        find_the_blow,
        find_the_offset,
        parallel_walls,
        slanting_wall,
        speed_from_impulse,
        struck_on_the_other_side,
        struck_then_wall,
        three_spheres_oblique,
        two_coefficients_of_a_corner,
        velocity_by_speed_and_angle,
        wall_at_an_unknown_angle,
        meeting_again,
        radius_of_the_ball,
    )
}
