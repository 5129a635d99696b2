"""What walls and spheres share: the patterns e above 1, e with speed and scatter, class values."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from restitution.experiments.curves import Array, sum_of_squares
from restitution.experiments.distributions import upper_tail, upper_tail_of_squares
from restitution.experiments.fitting import Fit
from restitution.experiments.numbers import fixed, percent, probability, with_error
from restitution.experiments.patterns import Pattern, Untested
from restitution.experiments.records import SpheresTrial, WallReading
from restitution.experiments.results import ClassValues
from restitution.experiments.samples import Sample
from restitution.records import dataclass

STRICT = 0.01
"""The level at which scatter is so large that the errors given are not trusted in other tests."""


def place_of(measured: WallReading | SpheresTrial) -> str:
    """How a sentence names a reading: its trial, or its line in the table."""
    return f"trial {measured.label}" if measured.label else f"line {measured.line}"


@dataclass(frozen=True)
class Reasons:
    """Why what a class computes differs from the fit, as sentences with slots.

    ``alone`` is for one reading. ``mean`` has the slots worst, worst_error, best and best_error,
    ``line`` the slots top and share; ``fit`` has none.
    """

    alone: str
    mean: str
    line: str
    fit: str


def class_values(
    sample: Sample, x: Array, y: Array, errors: Array, places: Sequence[str], reasons: Reasons
) -> ClassValues:
    """The mean of y/x, the slope of the line through the origin, and why they differ from e.

    ``errors`` are those of the ratios, and ``places`` name the readings.
    """
    ratios = y / x
    mean, slope = float(ratios.mean()), float((x * y).sum() / (x * x).sum())
    if len(x) == 1:
        return ClassValues(mean, None, slope, reasons.alone)
    error = float(ratios.std(ddof=1) / math.sqrt(len(ratios)))
    best, worst, top = int(np.argmin(errors)), int(np.argmax(errors)), int(np.argmax(x))
    share = float(x[top] ** 2 / (x * x).sum())
    sentences = []
    if max(abs(mean - sample.e), abs(slope - sample.e)) < 0.5 * sample.standard_error:
        sentences.append("Here the three agree well within the error.")
    if errors[worst] > 1.2 * errors[best]:
        words = {"worst": places[worst], "worst_error": errors[worst]}
        sentences.append(reasons.mean.format(**words, best=places[best], best_error=errors[best]))
    if share > 1.5 / len(x):
        sentences.append(reasons.line.format(top=places[top], share=percent(share)))
    return ClassValues(mean, error, slope, " ".join((*sentences, reasons.fit)))


def above_one(
    sample: Sample, given: Sample, places: tuple[str, ...], what: str, advice: str
) -> Pattern:
    """Whether e is above 1, for all readings or for a single one; one-sided.

    ``given`` has the errors as they were given, to which a single reading is put, ``sample`` those
    in which all are trusted. ``places`` name the readings, ``what`` is the sign of it in one of
    them: "β is larger than α", and ``advice`` a sentence. The two questions are one pattern, so
    that the smaller p-value counts twice.
    """
    e, readings = sample.e, sample.readings
    at_one = float(sum_of_squares(readings, sample.law, 1.0))
    scale = sample.factor**2 if sample.factor > 0 else 1.0
    root = float(np.sqrt(max(at_one - sample.fit.sum_of_squares, 0.0) / scale))
    root = root if e > 1 else -root
    freedom = sample.freedom if sample.known else sample.fit.degrees_of_freedom
    p_fit = upper_tail(root, freedom)
    if sample.exact:
        p_fit = 0.0 if e > 1 + 1e-6 else 1.0
    single = _single(given)
    worst = int(np.argmin(single))
    p_single = min(1.0, float(single[worst]) * len(readings))
    p = min(1.0, 2 * min(p_fit, p_single))
    error = sample.standard_error
    if p_fit <= p_single or e > 1:
        seen = (
            f"e comes out as {with_error(e, error)}, above 1 ({probability(p)}): there would be "
            f"more energy after the impact than before it. {advice}"
        )
    else:
        seen = (
            f"In {places[worst]} {what} by more than the errors explain ({probability(p)}), "
            f"though e is {fixed(e, 2)} for all. No impact does that: look at that reading again."
        )
    not_seen = f"Nowhere is it seen that {what} by more than the errors allow ({probability(p)})."
    return Pattern("above-one", root, p, seen, not_seen, e - 1, error)


def _single(sample: Sample) -> Array:
    """For each reading the probability of so large a y − x by chance, where e is 1.

    Where errors are estimated, that of the reading is estimated from the others.
    """
    readings = sample.readings
    variance = readings.x_variance + readings.y_variance - 2 * readings.covariance
    z = (readings.y - readings.x) / np.sqrt(variance)
    if sample.known:
        return upper_tail(z, sample.freedom)
    freedom = sample.fit.degrees_of_freedom - 1
    if freedom < 1 or sample.exact:
        return np.ones_like(z)
    rest = np.maximum(sample.fit.sum_of_squares - sample.residuals**2 * sample.factor**2, 1e-300)
    return upper_tail(z / np.sqrt(rest / freedom), freedom)


def speed(
    sample: Sample, speeds: Array | None, unit: str, reason: str
) -> tuple[Pattern | Untested, Fit | None]:
    """Whether e changes with the speed of the impact, as a straight line would."""
    if speeds is None:
        return Untested("speed", reason), None
    low, high = float(speeds.min()), float(speeds.max())
    if len(speeds) == 1:
        return Untested("speed", "Untested: one trial has one speed."), None
    if high - low <= 1e-9 * high:
        return Untested("speed", f"Untested: all speeds are the same, {low:.3g} {unit}."), None
    share = (speeds - speeds.mean()) / (high - low)
    wider = sample.wider(lambda x, p: sample.law.value(x, p[0] + p[1] * share), 1)
    if wider is None:
        return Untested("speed", "Untested: too few readings for a trend with speed."), None
    p = sample.p_value(wider)
    change, error = wider.parameters[1], sample.error_of(wider, 1)
    begin = wider.parameters[0] + change * float(share[np.argmin(speeds)])
    span = f"from {low:.3g} {unit} to {high:.3g} {unit}"
    verb = "falls" if change < 0 else "rises"
    seen = (
        f"e {verb} with speed: {span} it goes from {fixed(begin, 2)} to "
        f"{fixed(begin + change, 2)}, "
        f"a change of {with_error(change, error)} ({probability(p)}). One value of e does not "
        "hold for all these speeds."
    )
    not_seen = (
        f"e shows no change with speed: {span} it changes by {with_error(change, error)} "
        f"({probability(p)})."
    )
    return Pattern(
        "speed", change / error if error else 0.0, p, seen, not_seen, change, error
    ), wider


def scatter(
    sample: Sample, wider: list[Fit], places: tuple[str, ...], what: str
) -> Pattern | Untested:
    """Whether the readings lie farther from the law than their errors explain.

    They are compared with the nearest of the wider models, so that a pattern which has a name of
    its own is not told twice.
    """
    if not sample.known:
        reason = "Untested: no errors were given; they are taken from the scatter itself."
        return Untested("scatter", reason)
    best = min([sample.fit, *wider], key=lambda fit: fit.sum_of_squares)
    freedom = best.degrees_of_freedom
    if freedom < 1:
        return Untested("scatter", "Untested: one reading has no scatter.")
    p = upper_tail_of_squares(best.sum_of_squares, freedom, sample.freedom)
    times = fixed(best.scatter, 1)
    far = int(np.argmax(np.abs(sample.residuals)))
    seen = (
        f"The {what} lie {times} times as far from the law as their errors explain "
        f"({probability(p)}): the errors are larger than stated, or a reading is wrong. The one "
        f"farthest off is in {places[far]}, by {fixed(abs(float(sample.residuals[far])), 1)} "
        "errors. The interval of e rests on the stated errors, and is too narrow then."
    )
    not_seen = (
        f"The {what} lie {times} times as far from the law as their errors let expect, which "
        f"chance explains ({probability(p)})."
    )
    return Pattern("scatter", best.sum_of_squares, p, seen, not_seen, best.scatter, None, "times")
