"""A plan of an experiment as text for a terminal."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Iterator

from restitution.counting import counted, listed
from restitution.experiments.numbers import decimals, fixed
from restitution.experiments.plans import Design, PlanContent

_MOST_ANGLES = 24
_LARGE = 20.0  # degrees, beyond which nobody overlooks a turn


def written(plan: PlanContent, width: int) -> str:
    """The best angle, the designs, the trials that it takes, and why angles are spread."""
    blocks = [
        list(_wrapped(f"Plan: {_asked(plan)}", width)),
        list(_wrapped(_best(plan), width)),
        list(_table(plan)),
        list(_below(plan, width)),
        list(_trials(plan, width)),
        list(_wrapped(_why(plan), width)),
        list(_wrapped(_CAVEAT, width)),
    ]
    return "\n\n".join("\n".join(block) for block in blocks if block) + "\n"


def _asked(plan: PlanContent) -> str:
    return (
        f"impacts with a wall, e near {plan.e:g}, angles read to ±{plan.angle_error:g}° (standard "
        f"error), {counted(plan.trials, 'trial')}"
    )


def _best(plan: PlanContent) -> str:
    angle = fixed(plan.best_angle, 0)
    exact = abs(plan.e * _square_of_tangent(plan.best_angle) - 1) < 1e-6
    beside = (
        "there the ball leaves at right angles to the way on which it came (α + β = 90°)"
        if exact
        else "the steepest that is tried here"
    )
    return f"One reading tells most of e at α = {angle}°: {beside}."


def _square_of_tangent(degrees: float) -> float:
    return math.tan(math.radians(degrees)) ** 2


def _table(plan: PlanContent) -> Iterator[str]:
    longest = max(len(design.title) for design in plan.designs)
    yield f"    {'angles α':<{longest}}   error of e   95% interval   turn seen"
    for design in plan.designs:
        sign = "*" if design.id == plan.recommended else " "
        turn = _turn(design.smallest_turn)
        places = decimals(design.half_width)
        yield (
            f"  {sign} {design.title:<{longest}}   {_size(design.simulated_error, places):>10}   "
            f"{_size(design.half_width, places):>12}   {turn:>9}"
        )


def _turn(degrees: float | None) -> str:
    if degrees is None:
        return "–"
    return f"{degrees:.1f}°" if degrees < _LARGE else f"above {_LARGE:g}°"


def _size(value: float, places: int) -> str:
    return f"±{fixed(value, places)}"


def _below(plan: PlanContent, width: int) -> Iterator[str]:
    design = plan.design(plan.recommended)
    yield from _wrapped(f"* recommended: {_angles(design)}", width, "  ")
    yield from _wrapped(
        f"error of e: standard deviation in {plan.simulations} simulated experiments, each fitted "
        f"(by propagation of errors it is ±{fixed(design.standard_error, 4)} for *)",
        width,
        "  ",
    )
    yield from _wrapped(
        "turn seen: by how much the line from which angles are measured has to be turned against "
        "the wall for the check of the model to see it in 8 of 10 experiments",
        width,
        "  ",
    )


def _angles(design: Design) -> str:
    if len(set(design.angles)) == 1:
        return f"α = {design.angles[0]:g}° each time"
    shown = [f"{angle:g}°" for angle in design.angles[:_MOST_ANGLES]]
    rest = len(design.angles) - len(shown)
    return "α = " + (", ".join(shown) + f" and {rest} more" if rest else listed(shown))


def _trials(plan: PlanContent, width: int) -> Iterator[str]:
    needs = [f"{trials} for ±{target:g}" for target, trials in plan.trials_for]
    yield from _wrapped(
        f"Trials for an interval of 95%, with angles as in *: {listed(needs)}.", width
    )


def _why(plan: PlanContent) -> str:
    best = plan.design("best")
    if plan.recommended == "best":
        return (
            "With fewer than three trials there is no check of the model: any law fits them. Take "
            "three or more, at angles that are spread."
        )
    design = plan.design(plan.recommended)
    cost = design.standard_error / best.standard_error - 1
    turn = f" {design.smallest_turn:.1f}°" if design.smallest_turn is not None else ""
    return (
        "Why the angles are spread: readings at one angle tell e best, but any law fits them, so "
        "that angles measured from a wrong line change e and nothing shows it. Spread angles make "
        f"the check of the model possible: it sees a turn of{turn} in 8 of 10 experiments. They "
        f"cost an error of e that is {100 * cost:.0f}% larger."
    )


_CAVEAT = (
    "The error is one that each angle has anew. One that all share, such as a protractor that is "
    "turned against the wall, does not fall with more trials."
)


def _wrapped(text: str, width: int, indent: str = "") -> list[str]:
    return textwrap.wrap(
        text, width, initial_indent=indent, subsequent_indent=indent + "  " * bool(indent)
    )
