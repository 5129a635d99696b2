"""Two spheres: trials → sample, points, what a class computes, and the patterns."""

from __future__ import annotations

import math
import statistics
from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from restitution.errors import MissingError
from restitution.experiments import common
from restitution.experiments.common import STRICT, Reasons, above_one, place_of, scatter, speed
from restitution.experiments.curves import SPHERES, Array, Readings
from restitution.experiments.distributions import upper_tail, upper_tail_of_squares
from restitution.experiments.impacts import Impact, impact_of
from restitution.experiments.numbers import percent, probability, with_error
from restitution.experiments.patterns import Pattern, Untested
from restitution.experiments.records import Fault, MeasuredSphere, SpheresTrial, Velocity
from restitution.experiments.regression import Regression, regression
from restitution.experiments.results import ClassValues, Point
from restitution.experiments.samples import Sample
from restitution.records import dataclass


@dataclass(frozen=True)
class ImpactTerms:
    """How sentences name what is along an impact and what is across it, of spheres or of a wall."""

    line: str
    column: str
    parting: str
    passing: str
    smooth: str
    approaching: str
    masses: str
    """The columns of the masses; "" of a wall, which momentum does not concern."""


OF_SPHERES = ImpactTerms(
    line="the line of centres",
    column="line",
    parting="the spheres part faster than they approach",
    passing="after the impact one sphere passes the other",
    smooth="smooth spheres leave",
    approaching="before the impact the spheres do not approach each other",
    masses="columns m_A and m_B",
)
OF_TWO_TRACKS = replace(OF_SPHERES, column="wall", masses="a column m")
OF_WALL = ImpactTerms(
    line="the normal of the wall",
    column="wall",
    parting="the ball leaves the wall faster than it comes",
    passing="after the impact the ball moves along the wall",
    smooth="a smooth wall leaves",
    approaching="before the impact the ball does not approach the wall",
    masses="",
)
"""A wall is a sphere B that stays at rest."""


@dataclass(frozen=True)
class Spheres:
    """The impacts that can be used, their sample, and the trials that cannot."""

    impacts: tuple[Impact, ...]
    sample: Sample
    unit: str = "m/s"
    faults: tuple[Fault, ...] = ()
    notes: tuple[str, ...] = ()
    words: ImpactTerms = OF_SPHERES

    @property
    def places(self) -> tuple[str, ...]:
        return tuple(place_of(impact.trial) for impact in self.impacts)


def spheres_of(trials: tuple[SpheresTrial, ...], unit: str) -> Spheres:
    """The sample of trials: with their errors, or with one error of all components if none has any.

    Raises MissingError where no trial can be used.
    """
    usual, notes = _usual_error(trials)
    covariances = [_covariance(trial, usual or 1.0) for trial in trials]
    return impacts_of(trials, unit, covariances, known=usual is not None, notes=notes)


def impacts_of(
    trials: tuple[SpheresTrial, ...],
    unit: str,
    covariances: list[Array],
    *,
    known: bool,
    freedom: int | None = None,
    notes: tuple[str, ...] = (),
    words: ImpactTerms = OF_SPHERES,
) -> Spheres:
    """The sample of trials whose components have covariances of shape (8, 8).

    ``known`` is False where these are so up to a factor, and ``freedom`` are the degrees of freedom
    with which they were estimated elsewhere. Raises MissingError where no trial can be used.
    """
    impacts, faults = [], []
    for trial, covariance in zip(trials, covariances):
        impact = impact_of(trial, covariance)
        rule = _unfit(impact, words, known=known)
        if impact is None or rule:
            name = f"trial {trial.label}: " if trial.label else ""
            faults.append(Fault(trial.line, "", "", f"{name}{rule}"))
        else:
            impacts.append(impact)
    if not impacts:
        raise MissingError(f"no trial can be used: {faults[0]}")
    sample = Sample(_readings(impacts), SPHERES, known, freedom)
    return Spheres(tuple(impacts), sample, unit, tuple(faults), notes, words)


_SINGULAR = 1e-9
_UNCLEAR = math.radians(20)
"""A line of centres with a larger error is not known."""


def _unfit(impact: Impact | None, words: ImpactTerms, *, known: bool) -> str:
    """Why an impact cannot be used; "" where it can."""
    if impact is None:
        return f"no velocity changes, so that {words.line} is not to be seen"
    if known and not impact.given and impact.direction_error() > _UNCLEAR:
        return (
            f"the velocities change by so little that {words.line} is known to "
            f"±{math.degrees(impact.direction_error()):.0f}° only; give a column {words.column}"
        )
    if impact.approach <= 0:
        return words.approaching
    along = impact.along()
    if not np.linalg.det(along) > _SINGULAR * along[0, 0] * along[1, 1]:
        return f"the velocities do not determine {words.line}; give a column {words.column}"
    return ""


def _velocities(trial: SpheresTrial) -> Iterator[Velocity]:
    for sphere in (trial.A, trial.B):
        yield from (sphere.u, sphere.v)


def _usual_error(trials: tuple[SpheresTrial, ...]) -> tuple[float | None, tuple[str, ...]]:
    """The error of a component that has none of its own; None where none has any."""
    components = [
        component.error for trial in trials for v in _velocities(trial) for component in (v.x, v.y)
    ]
    given = [component for component in components if component]
    if not given:
        return None, ()
    missing = sum(component is None for component in components)
    middle = statistics.median(given)
    if not missing:
        return middle, ()
    return middle, (
        f"components without errors ({missing}) are taken to have {middle:.2g}, the middle one",
    )


def _covariance(trial: SpheresTrial, usual: float) -> Array:
    """The covariance of all components, of shape (8, 8)."""
    result = np.zeros((8, 8))
    for place, sphere in ((0, trial.A), (4, trial.B)):
        result[place : place + 4, place : place + 4] = _of_sphere(sphere, usual)
    return result


def _of_sphere(sphere: MeasuredSphere, usual: float) -> Array:
    result = np.zeros((4, 4))
    for place, velocity in ((0, sphere.u), (2, sphere.v)):
        errors = [
            usual if component.error is None else component.error
            for component in (velocity.x, velocity.y)
        ]
        result[place, place], result[place + 1, place + 1] = errors[0] ** 2, errors[1] ** 2
        result[place, place + 1] = result[place + 1, place] = velocity.covariance
    return result


def _readings(impacts: list[Impact]) -> Readings:
    covariances = np.array([impact.along() for impact in impacts])
    return Readings(
        np.array([impact.approach for impact in impacts]),
        np.array([impact.separation for impact in impacts]),
        covariances[:, 0, 0],
        covariances[:, 1, 1],
        covariances[:, 0, 1],
    )


def component_error(spheres: Spheres) -> float | None:
    """The error of one component of a velocity where it is the same for all, else None."""
    diagonals = np.concatenate([np.diag(impact.covariance) for impact in spheres.impacts])
    measured = diagonals[diagonals > 0]
    if measured.max() > measured.min() * (1 + 1e-9):
        return None
    return math.sqrt(float(measured[0])) * spheres.sample.factor


# --- points, and what a class computes --------------------------------------------------------


def points(spheres: Spheres) -> tuple[Point, ...]:
    """The trials in the picture of the speed of separation against the speed of approach."""
    sample = spheres.sample
    arrays = sample.readings.scaled(sample.factor)
    rows = zip(
        spheres.impacts,
        np.sqrt(arrays.x_variance),
        np.sqrt(arrays.y_variance),
        sample.x_fitted,
        sample.residuals,
    )
    return tuple(
        Point(
            line=impact.trial.line,
            x=impact.approach,
            y=impact.separation,
            x_error=float(x_error),
            y_error=float(y_error),
            x_fitted=float(x),
            y_fitted=sample.e * float(x),
            residual=float(residual),
            speed=impact.approach,
            label=impact.trial.label,
        )
        for impact, x_error, y_error, x, residual in rows
    )


def class_values(spheres: Spheres) -> ClassValues:
    """The mean of separation / approach, the slope of the line through the origin, and why."""
    arrays = spheres.sample.readings.scaled(spheres.sample.factor)
    x, y = arrays.x, arrays.y
    ratios = y / x
    variances = arrays.y_variance - 2 * ratios * arrays.covariance + ratios**2 * arrays.x_variance
    errors = np.sqrt(variances) / x
    return common.class_values(spheres.sample, x, y, errors, spheres.places, _REASONS)


_REASONS = Reasons(
    alone="With one trial all of these are the same number.",
    mean=(
        "The mean lets every ratio count the same, though that of {worst} is known to "
        "±{worst_error:.2g} and that of {best} to ±{best_error:.2g}."
    ),
    line="The line leans on the fastest impact: {top} alone has {share} of its weight.",
    fit=(
        "The fit lets each trial count by its own error, in the speed of approach as well as in "
        "the speed of separation."
    ),
)


# --- patterns ---------------------------------------------------------------------------------


def patterns(spheres: Spheres) -> list[Pattern | Untested]:
    """The patterns of two spheres."""
    sample = spheres.sample
    straight = _turned_back(spheres, sample)
    spread = _scatter(spheres, straight)
    if isinstance(spread, Pattern) and spread.p_value < STRICT and len(spheres.impacts) > 1:
        # The errors given are too small, so they are no measure for the other patterns.
        sample = sample.with_scatter()
        straight = _turned_back(spheres, sample)
    words = spheres.words
    tested = [
        above_one(sample, spheres.sample, spheres.places, words.parting, _SIGNS),
        speed(straight, straight.readings.x, spheres.unit, "")[0],
        *_across(spheres, sample),
        spread,
    ]
    return [*tested, _momentum(spheres, sample)] if words.masses else tested


_SIGNS = "Look for velocities in the wrong columns, and for signs of components."


def _turned_back(spheres: Spheres, sample: Sample) -> Sample:
    """The sample with the lines of centres turned back, where they are seen to be turned.

    Against it e is tested with speed, and scatter, so that a line that was measured wrong is not
    seen as these too.
    """
    offset = _across(spheres, sample)[0]
    if not isinstance(offset, Pattern) or offset.p_value >= STRICT or offset.estimate is None:
        return sample
    turned = [impact.turned(-math.radians(offset.estimate)) for impact in spheres.impacts]
    return replace(sample, readings=_readings(turned))


def _scatter(spheres: Spheres, straight: Sample) -> Pattern | Untested:
    trend = speed(straight, straight.readings.x, spheres.unit, "")[1]
    return scatter(straight, [trend] if trend else [], spheres.places, "trials")


def _across(spheres: Spheres, sample: Sample) -> list[Pattern | Untested]:
    """The tests of a line of centres that is turned, and of friction, from what changes across it.

    The relative velocity along the tangent gains (approach + separation) ψ where the line is given
    turned by ψ, and loses a share of itself by friction. The one that explains more is tested
    alone, the other beside it, so that one of them does not show as both.
    """
    words = spheres.words
    if not all(impact.given for impact in spheres.impacts):
        reason = (
            f"Untested: {words.line} was found from the velocities, as the line along which they "
            f"change; give a column {words.column}."
        )
        return [Untested("offset", reason), Untested("friction", reason)]
    gains, variances, means = np.array([impact.across() for impact in spheres.impacts]).T
    columns = {"offset": sample.readings.x + sample.readings.y, "friction": -means}
    if float(np.mean(means**2)) < _OBLIQUE**2 * float(np.mean(variances)) * sample.factor**2:
        del columns["friction"]

    def fitted(names: Iterable[str]) -> Regression | None:
        chosen = [columns[name] for name in names]
        freedom = sample.freedom
        return regression(gains, variances, chosen, known=sample.known, freedom=freedom)

    alone = {name: fit for name in columns if (fit := fitted([name]))}
    both = fitted(columns) if len(alone) == 2 else None
    better = min(alone, key=lambda name: alone[name].p_values[0], default="")
    doubt = ""
    if len(alone) == 2 and (both is None or both.p_values[[*columns].index(better)] > _DOUBT):
        doubt = f" {_alike(words)}"
    results: list[Pattern | Untested] = []
    for name, sentences in (("offset", _offset), ("friction", _friction)):
        if name == better:
            results.append(sentences(words, alone[name], 0, doubt))
        elif both is not None and name in columns:
            results.append(sentences(words, both, [*columns].index(name), ""))
        else:
            reason = _alike(words) if name in alone else _FEW[name]
            results.append(Untested(name, f"Untested: {reason}"))
    return results


_OBLIQUE = 2.5
"""The velocities along the tangent, in errors of their change, from which friction would show."""
_FEW = {
    "offset": "it takes three trials or more, or errors of the velocities.",
    "friction": "it takes oblique impacts, three or more; these have little velocity across.",
}
_DOUBT = 0.05
"""The level at which the one is needed though the other may be there too."""


def _alike(words: ImpactTerms) -> str:
    return (
        f"Impacts on one side of {words.line} do not tell friction from a direction that was "
        "measured wrong."
    )


def _offset(words: ImpactTerms, fit: Regression, index: int, doubt: str) -> Pattern:
    angle, error, p = (
        float(array[index]) for array in (fit.coefficients, fit.errors, fit.p_values)
    )
    angle, error = math.degrees(angle), math.degrees(error)
    sense = "anticlockwise" if angle > 0 else "clockwise"
    seen = (
        f"The velocities do not change along {words.line} that is given: it is turned "
        f"{sense} by {with_error(abs(angle), error, '°')} against the impulse ({probability(p)})."
        f"{doubt} Compare with the result without the column {words.column}."
    )
    not_seen = (
        f"The velocities change along {words.line} that is given: it is turned against the "
        f"impulse by {with_error(angle, error, '°')} ({probability(p)})."
    )
    z = angle / error if error else 0.0
    return Pattern("offset", z, p, seen, not_seen, angle, error, "degrees")


def _friction(words: ImpactTerms, fit: Regression, index: int, doubt: str) -> Pattern:
    share, error, p = (
        float(array[index]) for array in (fit.coefficients, fit.errors, fit.p_values)
    )
    size = f"{percent(abs(share))} ± {percent(error)}"
    pace = "slower" if share > 0 else "faster"
    seen = (
        f"The velocity across {words.line} changes: {words.passing} {size} {pace} than before "
        f"({probability(p)}), though {words.smooth} that as it is.{doubt} What rubs begins to spin."
    )
    not_seen = (
        f"The velocity across {words.line} stays: {words.passing} {size} {pace} than before "
        f"({probability(p)})."
    )
    return Pattern("friction", share / error if error else 0.0, p, seen, not_seen, -share, error)


def _momentum(spheres: Spheres, sample: Sample) -> Pattern | Untested:
    """The test of the momentum before against that after, in all directions and along itself.

    The momentum that is lost in all trials, by χ², or F where errors are from the scatter; and the
    share of the momentum that is lost. The two are one pattern, so that the smaller p-value counts
    twice.
    """
    rows = [row for impact in spheres.impacts if (row := impact.momentum())]
    if len(rows) < len(spheres.impacts):
        return Untested("momentum", f"Untested: it takes the masses, {spheres.words.masses}.")
    freedom = sample.freedom if sample.known else sample.fit.degrees_of_freedom
    if sample.exact or (freedom is not None and freedom < 1):
        return Untested("momentum", "Untested: no errors were given, and there is no scatter.")
    weighted = [(lost, np.linalg.inv(covariance), mean) for lost, covariance, mean in rows]
    squares = np.array([float(lost @ weight @ lost) for lost, weight, _ in weighted])
    scale = sample.factor**2
    expected = 2 * len(rows)
    square = float(squares.sum()) / scale
    certainty = sum(float(mean @ weight @ mean) for _, weight, mean in weighted)
    share = sum(float(mean @ weight @ lost) for lost, weight, mean in weighted) / certainty
    error = math.sqrt(scale / certainty)
    p_all = upper_tail_of_squares(square, expected, freedom)
    p_share = 2 * upper_tail(abs(share) / error, freedom)
    p = min(1.0, 2 * min(p_all, p_share))
    comparison = "less" if share > 0 else "more"
    size = f"{percent(abs(share))} ± {percent(error)}"
    if p_share <= p_all:
        seen = (
            f"Momentum changes: after the impacts there is {size} {comparison} of it than before "
            f"({probability(p)}). Weigh both spheres again, and look at the scale of the speeds: "
            "with no force from outside, momentum stays."
        )
    else:
        far = int(np.argmax(squares))
        lost, covariance, _ = rows[far]
        size = with_error(float(np.linalg.norm(lost)), _length_error(lost, covariance * scale))
        seen = (
            f"Momentum changes by more than the errors explain ({probability(p)}), most in "
            f"{spheres.places[far]}, by {size} kg {spheres.unit}. Look for signs of components, "
            "and for masses that belong to the other sphere."
        )
    not_seen = (
        f"Momentum stays: after the impacts there is {size} {comparison} of it than before "
        f"({probability(p)})."
    )
    return Pattern("momentum", square, p, seen, not_seen, -share, error)


def _length_error(vector: Array, covariance: Array) -> float:
    along = vector / np.linalg.norm(vector)
    return math.sqrt(float(along @ covariance @ along))
