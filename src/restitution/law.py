"""The law of an impact between smooth bodies, written once, for every kind of number.

Notation: bodies 1 and 2 have velocities u1, u2 just before the impact and v1, v2 just after it
(m/s), and *inverse* masses w1, w2 (1/kg); c is a vector along the line of centres, of any length
and in either sense; e is the coefficient of restitution. A fixed wall is a body with w = 0 and
u = 0, and its line of centres is the common normal.

Velocities and c are vectors with ``+``, ``-``, multiplication by a number, ``dot`` and ``cross``.
As the line of centres need not be a unit vector, an impact is a rational function of its data:
no root, no branch, no trigonometry. So nothing is imported here, and the same lines serve
fractions, floats, arrays and symbols; whole numbers divide as Python's do, into floats.

The closed form follows from the three principles at the end of this file, which are written as
residuals: what is zero when the principle holds.
"""


def impulse(u1, u2, w1, w2, c, e):
    """The impulse on body 2, in N s; body 1 receives its opposite.

    It acts along the line of centres, as the bodies are smooth; its size is
    (1 + e) × (speed of approach) / (w1 + w2). Divides by zero where both bodies are fixed or
    c is zero.
    """
    return c * ((1 + e) * (u1 - u2).dot(c) / ((w1 + w2) * c.dot(c)))


def impact(u1, u2, w1, w2, c, e):
    """The velocities just after, as a pair (v1, v2), in m/s.

    Whether the bodies approach each other is not asked: bodies that separate would pass through
    one another, and that is for the caller to refuse.
    """
    return after_impulse(u1, u2, w1, w2, impulse(u1, u2, w1, w2, c, e))


def after_impulse(u1, u2, w1, w2, on_2):
    """The velocities just after an impulse on body 2 and its opposite on body 1, in m/s."""
    return u1 - on_2 * w1, u2 + on_2 * w2


def kinetic_energy_lost(u1, u2, w1, w2, c, e):
    """The kinetic energy that both bodies together lose, in J.

    ½ (1 − e²) (speed of approach)² / (w1 + w2): the velocities across the line of centres have
    no part in it.
    """
    approach = (u1 - u2).dot(c)
    return (1 - e * e) * approach * approach / (2 * (w1 + w2) * c.dot(c))


def momentum_along_line_of_centres(u1, u2, v1, v2, w1, w2, c):
    """Zero when momentum is conserved along the line of centres.

    m1 (v1 − u1)·c + m2 (v2 − u2)·c, divided by m1 m2: then a wall, w = 0, has its place too, and
    the equation says that it stays where it is.
    """
    return w2 * (v1 - u1).dot(c) + w1 * (v2 - u2).dot(c)


def newtons_experimental_law(u1, u2, v1, v2, c, e):
    """Zero when (speed of separation) = e × (speed of approach) along the line of centres."""
    return (v2 - v1).dot(c) - e * (u1 - u2).dot(c)


def change_across_line_of_centres(u, v, c):
    """Zero when a body's velocity perpendicular to the line of centres does not change."""
    return c.cross(v - u)
