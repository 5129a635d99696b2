r"""Plots of an experiment: the law with its fit, the residuals, e against the speed.

    >>> import restitution as r
    >>> from restitution.experiments.plots import law_plot
    >>> law_plot(r.experiment("alpha,beta\n30,21\n45,34\n60,49\n", angle_error=1))[:4]
    '<svg'

All are texts of SVG files in ink alone, so that they are the same in black and white. What lies far
outside would squeeze the rest; it is left out of the frame, marked at its edge, and told beneath.
"""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from restitution.counting import listed
from restitution.drawing.ink import Piece, overlap, padded, stick, touched
from restitution.drawing.svg import INK
from restitution.experiments.canvas import POINT, SMALL, Canvas, canvas, svg_of
from restitution.experiments.frames import Frame, frame_of, outlying
from restitution.experiments.needs import needed
from restitution.experiments.numbers import decimals, fixed, with_error
from restitution.experiments.results import Point
from restitution.experiments.whole import Experiment
from restitution.records import dataclass
from restitution.render.glyphs import Box
from restitution.vector import Vector

WIDTH, HEIGHT = 96.0, 72.0
"""Of the frame of a plot, in millimetres."""
FAR = 3.0
"""Standard errors from the fit beyond which a reading is named in a plot."""

MOST_DRAWN = 600
"""Readings that are drawn; of more, some are left out evenly, and this is told beneath."""

_MANY = 60  # readings, beyond which their marks are small
_NAMED = 6  # readings that are named in a plot
_MOST_LISTED = 4  # readings outside the frame that are told one by one
_BAND = 0.13  # strength of the ink of an area
_LINE_OF_TEXT = 84  # characters beneath a plot


def law_plot(experiment: Experiment) -> str:
    """The law y = e x: tan β against tan α, or speed of separation against speed of approach.

    With the readings and their standard errors, the fit, the interval of e as a band about it, and
    the line e = 1. Raises UnsupportedError where Matplotlib is not installed.
    """
    frame, total = frame_of(experiment), len(experiment.points)
    experiment = _thinned(experiment)
    inside = [point for point in experiment.points if frame.holds(point.x, point.y)]
    outside = [point for point in experiment.points if not frame.holds(point.x, point.y)]
    with canvas(WIDTH, HEIGHT) as drawn:
        axes = drawn.axes
        axes.set_xlim(frame.left, frame.right)
        axes.set_ylim(frame.bottom, frame.top)
        _law_lines(axes, experiment, frame)
        _readings(axes, inside, frame)
        names = _law_names(experiment)
        axes.set_xlabel(names[0], labelpad=3)
        axes.set_ylabel(names[1], labelpad=3)
        walls = is_of_walls(experiment)
        if walls:
            _angles_beside(axes, frame)
        _legend(axes, above=9.5 if walls else 2.0)
        _edge_marks(axes, outside, frame)
        _note(drawn, _outside_words(outside), _thin_words(experiment, total))
        named = [(point.line, point.x, point.y, point.residual) for point in inside]
        lines = [(experiment.e, 0.0), (1.0, 0.0)]
        _name_far_ones(drawn, named, _error_pieces(inside, frame), lines)
        return svg_of(drawn, "The law of restitution", _law_words(experiment, total, len(outside)))


def residual_plot(experiment: Experiment) -> str:
    """The distances of the readings from the fit, in standard errors, by angle or by speed.

    Raises UnsupportedError where Matplotlib is not installed.
    """
    all_points = experiment.points
    experiment = _thinned(experiment)
    points = experiment.points
    walls = is_of_walls(experiment)
    x = [_angle_or_speed(point) for point in points]
    highest = max(
        FAR * 1.15, outlying([abs(point.residual) for point in all_points], 4 * FAR) * 1.1
    )
    with canvas(WIDTH, 0.55 * HEIGHT) as drawn:
        axes = drawn.axes
        axes.set_xlim(*_around(x))
        axes.set_ylim(-highest, highest)
        axes.axhspan(-2, 2, color=INK, alpha=_BAND / 2, linewidth=0)
        axes.axhline(0, color=INK, linewidth=0.9)
        for level in (-2, 2):
            axes.axhline(level, color=INK, linewidth=0.5, linestyle=(0, (4, 3)))
        shown = [abs(point.residual) <= highest for point in points]
        _marks(axes, [(a, p.residual) for a, p, s in zip(x, points, shown) if s])
        beyond = [(a, p) for a, p, s in zip(x, points, shown) if not s]
        for a, point in beyond:
            up = point.residual > 0
            axes.plot([a], [highest if up else -highest], **_edge("^" if up else "v"))
        axes.set_xlabel("α, in degrees" if walls else _law_names(experiment)[0], labelpad=3)
        axes.set_ylabel("distance from the fit,\nin standard errors", labelpad=3)
        words = [
            f"line {p.line} ({fixed(p.residual, 1)})"
            for _, p in sorted(beyond, key=lambda entry: -abs(entry[1].residual))
        ]
        thin = _thin_words(experiment, len(all_points))
        _note(drawn, _list_sentence("Outside the frame", words), thin)
        named = [(p.line, a, p.residual, p.residual) for a, p, s in zip(x, points, shown) if s]
        _name_far_ones(drawn, named, [], [(0.0, 0.0), (0.0, 2.0), (0.0, -2.0)])
        far = sum(abs(point.residual) > 2 for point in all_points)
        return svg_of(
            drawn,
            "Distances from the fit",
            f"Distances of {len(all_points)} readings from the fit in standard errors; {far} of "
            "them lie beyond 2.",
        )


def speed_plot(experiment: Experiment) -> str | None:
    """The ratio y/x of each reading against the speed before its impact, with e and its interval.

    None where the speeds are not known. Raises UnsupportedError where Matplotlib is not installed.
    """
    if any(point.speed is None for point in experiment.points):
        return None
    total = len(experiment.points)
    experiment = _thinned(experiment)
    points = [point for point in experiment.points if point.x > 0]
    if not points:
        return None
    rows = [_Ratio.of(point) for point in points]
    high = max(outlying([row.high for row in rows], 2.5), 1.25 * experiment.e, 0.1) * 1.05
    low = min(0.0, *(row.value for row in rows if row.value > -high))
    with canvas(WIDTH, 0.62 * HEIGHT) as drawn:
        axes = drawn.axes
        speeds = [row.speed for row in rows]
        left, right = _around(speeds)
        axes.set_xlim(left, right)
        axes.set_ylim(1.1 * low, high)
        band = _band(experiment)
        axes.axhspan(
            max(band[0], 2 * low - high),
            min(band[1], 2 * high),
            color=INK,
            alpha=_BAND,
            lw=0,
            label=_band_label(experiment),
        )
        axes.axhline(experiment.e, color=INK, linewidth=1.0, label=_fit_label(experiment))
        if high > 1:
            axes.axhline(
                1, color=INK, linewidth=0.6, linestyle=(0, (5, 3)), label="e = 1", zorder=1
            )
        _trend(axes, experiment, rows)
        inside = [row for row in rows if row.value <= high]
        for ratio in inside:
            ends = max(ratio.low, 2 * low - high), min(ratio.high, 2 * high)
            axes.vlines([ratio.speed], *ends, color=INK, lw=0.6, alpha=_strength(len(rows)))
        _marks(axes, [(ratio.speed, ratio.value) for ratio in inside])
        beyond = [row for row in rows if row.value > high]
        for ratio in beyond:
            axes.plot([ratio.speed], [high], **_edge("^"))
        axes.set_xlabel(f"speed before the impact, in {_unit(experiment)}", labelpad=3)
        axes.set_ylabel(_ratio_name(experiment), labelpad=3)
        _legend(axes, above=2.0)
        words = [f"line {ratio.line} ({ratio.value:.3g})" for ratio in beyond]
        _note(drawn, _list_sentence("Outside the frame", words), _thin_words(experiment, total))
        return svg_of(
            drawn,
            "e and speed",
            f"The ratio of each of {total} readings against the speed, from "
            f"{min(speeds):.3g} to {max(speeds):.3g}, with the fit e = {fixed(experiment.e, 3)}.",
        )


def _thinned(experiment: Experiment) -> Experiment:
    """The same with no more readings than a plot can show: every n-th, and those farthest off."""
    points = experiment.points
    if len(points) <= MOST_DRAWN:
        return experiment
    far = sorted(points, key=lambda point: -abs(point.residual))[:_NAMED]
    kept = {point.line: point for point in (*points[:: math.ceil(len(points) / MOST_DRAWN)], *far)}
    return replace(experiment, points=tuple(kept[line] for line in sorted(kept)))


# --- the parts of a plot ----------------------------------------------------------------------


def _law_lines(axes: Any, experiment: Experiment, frame: Frame) -> None:
    """The band, the fit and the line e = 1."""
    xs = [frame.left, 0.0, frame.right] if frame.left < 0 else [frame.left, frame.right]
    low, high = _band(experiment)
    limit = 3 * max(abs(frame.top), abs(frame.bottom)) / frame.right
    low, high = max(low, -limit), min(high, limit)
    axes.fill_between(
        xs,
        [low * x for x in xs],
        [high * x for x in xs],
        color=INK,
        alpha=_BAND,
        linewidth=0,
        label=_band_label(experiment),
    )
    axes.plot(xs, [experiment.e * x for x in xs], color=INK, lw=1.1, label=_fit_label(experiment))
    axes.plot(xs, xs, color=INK, linewidth=0.6, linestyle=(0, (5, 3)), label="e = 1", zorder=1)


def _readings(axes: Any, points: Sequence[Point], frame: Frame) -> None:
    strength = _strength(len(points))
    collections = needed("matplotlib.collections", "a plot")
    bars = _error_pieces(points, frame)
    axes.add_collection(
        collections.LineCollection(bars, colors=INK, linewidths=0.6, alpha=strength, zorder=2.5)
    )
    errors = any(point.x_error or point.y_error for point in points)
    label = "readings, with standard errors" if errors else "readings"
    _marks(axes, [(point.x, point.y) for point in points], label)


def _marks(axes: Any, places: Sequence[tuple[float, float]], label: str | None = None) -> None:
    if places:
        size = 3.4 if len(places) <= _MANY else 2.2
        axes.plot(
            *zip(*places),
            "o",
            color=INK,
            markersize=size,
            markeredgewidth=0,
            label=label,
            zorder=3,
            clip_on=False,
        )


def _strength(count: int) -> float:
    """The strength of the ink of error bars: weaker where there are many."""
    return 0.85 if count <= _MANY else 0.35


def _edge(marker: str) -> dict[str, Any]:
    """How a reading outside the frame is marked at its edge."""
    return {
        "marker": marker,
        "color": INK,
        "markersize": 4.5,
        "markeredgewidth": 0.6,
        "fillstyle": "none",
        "clip_on": False,
        "linestyle": "none",
        "zorder": 4,
    }


def _edge_marks(axes: Any, points: Sequence[Point], frame: Frame) -> None:
    """A mark at the edge for each reading outside, on its way from the origin."""
    for point in points:
        x, y = frame.at_edge(point.x, point.y)
        axes.plot([x], [y], **_edge("^" if y >= frame.top else "v" if y <= frame.bottom else ">"))


def _legend(axes: Any, above: float) -> None:
    """The legend above the frame, at a distance in millimetres, in two columns."""
    handles, labels = axes.get_legend_handles_labels()
    pairs = sorted(zip(labels, handles), key=lambda entry: _order(entry[0]))
    axes.legend(
        [handle for _, handle in pairs],
        [label for label, _ in pairs],
        loc="lower left",
        bbox_to_anchor=(0, 1 + above / (axes.figure.get_figheight() * 25.4)),
        ncols=2,
        frameon=False,
        borderaxespad=0,
        handlelength=2.4,
        columnspacing=2.0,
        borderpad=0,
    )


_ORDER = ("readings", "fit", "e = 1")


def _order(label: str) -> int:
    """The place of an entry in the legend: readings and fit, then band and reference."""
    places = [n for n, start in enumerate(_ORDER) if label.startswith(start)]
    return (0, 1, 3)[places[0]] if places else 2


def _angles_beside(axes: Any, frame: Frame) -> None:
    """The angles of the tangents, above and on the right."""
    above = axes.secondary_xaxis("top")
    ticks = _angle_ticks(frame.left, frame.right, WIDTH, 9.0)
    above.set_xticks([math.tan(math.radians(a)) for a in ticks], [f"{a}°" for a in ticks])
    above.set_xlabel(r"$\alpha$", labelpad=2)
    beside = axes.secondary_yaxis("right")
    ticks = _angle_ticks(frame.bottom, frame.top, HEIGHT, 5.5)
    beside.set_yticks([math.tan(math.radians(a)) for a in ticks], [f"{a}°" for a in ticks])
    for scale in (above, beside):
        scale.patch.set_visible(False)
    beside.set_ylabel(r"$\beta$", labelpad=3, rotation=0, va="center", ha="left")


_PREFERRED = (45, 60, 30, 70, 15, 75, 80, 20, 65, 10, 50, 40, 5, 55, 35, 25, 85, 2, 1, 3, 4, 88)


def _angle_ticks(low: float, high: float, length: float, apart: float) -> list[int]:
    """Angles whose tangents lie between two, no nearer to each other than so many millimetres."""
    chosen: list[int] = []
    for angle in _PREFERRED:
        at = math.tan(math.radians(angle))
        near = apart * (high - low) / length
        if low <= at <= high and all(
            abs(at - math.tan(math.radians(number))) >= near for number in chosen
        ):
            chosen.append(angle)
    return sorted(chosen)


def _note(drawn: Canvas, *texts: str) -> None:
    """Words beneath the axis."""
    text = " ".join(filter(None, texts))
    if text:
        lines = "\n".join(textwrap.wrap(text, _LINE_OF_TEXT))
        drawn.axes.annotate(
            lines, (0, 0), (0, -30), "axes fraction", "offset points", fontsize=SMALL, va="top"
        )


# --- names of readings that lie far off --------------------------------------------------------


def _name_far_ones(
    drawn: Canvas,
    readings: Sequence[tuple[int, float, float, float]],
    bars: Sequence[tuple[tuple[float, float], tuple[float, float]]],
    lines: Sequence[tuple[float, float]],
) -> None:
    """The line numbers of readings far from the fit, where there is room beside them.

    ``readings`` are line, x, y and residual; ``lines`` slope and height of what is drawn across.
    """
    far = [reading for reading in readings if abs(reading[3]) > FAR]
    far = sorted(far, key=lambda entry: -abs(entry[3]))[:_NAMED]
    if not far:
        return
    axes = drawn.axes
    millimetres = _Millimetres.of(drawn)
    left, right = axes.get_xlim()
    pieces: list[Piece] = [millimetres.piece((x, y), (x, y), 0.7) for _, x, y, _ in readings]
    pieces += [millimetres.piece(start, end, 0.2) for start, end in bars]
    pieces += [
        millimetres.piece((left, height + slope * left), (right, height + slope * right), 0.3)
        for slope, height in lines
    ]
    taken: list[Box] = []
    for line, x, y, _ in far:
        words = f"line {line}"
        place = millimetres.place_beside(millimetres.at((x, y)), len(words), pieces, taken)
        if place is not None:
            taken.append(place)
            at = millimetres.share(place)
            axes.text(*at, words, transform=axes.transAxes, fontsize=SMALL, va="bottom")


@dataclass(frozen=True)
class _Millimetres:
    """The frame of a plot in millimetres from its lower left corner."""

    left: float
    bottom: float
    across: float
    up: float
    width: float
    height: float

    @classmethod
    def of(cls, drawn: Canvas) -> _Millimetres:
        (left, right), (bottom, top) = drawn.axes.get_xlim(), drawn.axes.get_ylim()
        width, height = (inches * 25.4 for inches in drawn.figure.get_size_inches())
        return cls(left, bottom, width / (right - left), height / (top - bottom), width, height)

    def at(self, place: tuple[float, float]) -> Vector:
        return Vector((place[0] - self.left) * self.across, (place[1] - self.bottom) * self.up)

    def piece(self, start: tuple[float, float], end: tuple[float, float], half: float) -> Piece:
        return stick(self.at(start), self.at(end), half)

    def share(self, box: Box) -> tuple[float, float]:
        return box[0] / self.width, box[1] / self.height

    def place_beside(
        self, at: Vector, letters: int, pieces: Sequence[Piece], taken: Sequence[Box]
    ) -> Box | None:
        """A free box for so many letters near a point, or None."""
        width, height = letters * 0.48 * SMALL * POINT, 0.95 * SMALL * POINT
        for gap in (1.2, 2.2, 3.6):
            for x, y in _AROUND:
                left = at.x + x * gap + (x - 1) / 2 * width
                bottom = at.y + y * gap + (y - 1) / 2 * height
                box = (left, bottom, left + width, bottom + height)
                if (
                    padded(box, 0.4)[0] >= 0
                    and padded(box, 0.4)[1] >= 0
                    and box[2] <= self.width - 0.4
                    and box[3] <= self.height - 0.4
                    and not touched(box, pieces, 0.3)
                    and not any(overlap(box, place, 0.5) for place in taken)
                ):
                    return box
        return None


_AROUND = ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1))


# --- errors, bands, trends ---------------------------------------------------------------------

_Place = tuple[float, float]


def _bars(point: Point, frame: Frame) -> list[tuple[_Place, _Place]]:
    """The error bars of a reading: from α − σ to α + σ and so for β, where these are known."""
    x_ends = _ends(point.x, point.x_error, point.alpha, point.alpha_error)
    y_ends = _ends(point.y, point.y_error, point.beta, point.beta_error)
    x_low, x_high = (min(max(end, frame.left), frame.right) for end in x_ends)
    y_low, y_high = (min(max(end, frame.bottom), frame.top) for end in y_ends)
    return [
        ((x_low, point.y), (x_high, point.y)),
        ((point.x, y_low), (point.x, y_high)),
    ]


def _ends(
    value: float, error: float, angle: float | None, angle_error: float | None
) -> tuple[float, float]:
    if angle is None or angle_error is None:
        return value - error, value + error
    return _tangent(angle - angle_error), _tangent(angle + angle_error)


def _tangent(angle: float) -> float:
    """The tangent of an angle in degrees; infinite from 90° on."""
    return math.tan(math.radians(angle)) if angle < 90 else math.inf


def _error_pieces(points: Sequence[Point], frame: Frame) -> list[tuple[_Place, _Place]]:
    return [bar for point in points for bar in _bars(point, frame)]


def _band(experiment: Experiment) -> tuple[float, float]:
    """The slopes between which the band lies: the possible part of the interval, if any is."""
    interval = experiment.interval
    return interval.possible or (interval.low, interval.high)


@dataclass(frozen=True)
class _Ratio:
    """y/x of a reading, one standard error to both sides, and the speed."""

    line: int
    speed: float
    value: float
    low: float
    high: float
    error: float

    @classmethod
    def of(cls, point: Point) -> _Ratio:
        assert point.speed is not None
        value = point.y / point.x
        error = math.hypot(point.y_error, value * point.x_error) / point.x
        return cls(point.line, point.speed, value, value - error, value + error, error)


def _trend(axes: Any, experiment: Experiment, rows: Sequence[_Ratio]) -> None:
    """The line of e that the check found to change with the speed."""
    checks = [
        check for check in experiment.checks if check.id == "speed" and check.verdict == "seen"
    ]
    if not checks or checks[0].estimate is None:
        return
    speeds = [row.speed for row in rows]
    low, high = min(speeds), max(speeds)
    weights = [1 / max(row.error, 1e-9) ** 2 for row in rows]
    middle = sum(w * s for w, s in zip(weights, speeds)) / sum(weights)
    ends = [experiment.e + checks[0].estimate * (s - middle) / (high - low) for s in (low, high)]
    axes.plot(
        [low, high], ends, color=INK, lw=1.0, linestyle=(0, (1, 1.5)), label="the change with speed"
    )


# --- words -------------------------------------------------------------------------------------


def is_of_walls(experiment: Experiment) -> bool:
    """Whether angles at a wall were measured, and no speeds."""
    return experiment.points[0].alpha is not None


def _unit(experiment: Experiment) -> str:
    """The unit of speed as it is printed: m s⁻¹."""
    units = (unit for unit in experiment.table.units.values() if unit.endswith("/s"))
    return next(units, "m/s").replace("/s", r"$\,\mathrm{s}^{-1}$")


def _law_names(experiment: Experiment) -> tuple[str, str]:
    if is_of_walls(experiment):
        return r"$\tan\,\alpha$", r"$\tan\,\beta$"
    unit = _unit(experiment)
    return f"speed of approach, in {unit}", f"speed of separation, in {unit}"


def _ratio_name(experiment: Experiment) -> str:
    if is_of_walls(experiment):
        return r"$\tan\,\beta\;/\;\tan\,\alpha$"
    return "separation / approach"


def _fit_label(experiment: Experiment) -> str:
    return f"fit: e = {with_error(experiment.e, experiment.standard_error)}"


def _band_label(experiment: Experiment) -> str:
    low, high = _band(experiment)
    places = decimals(experiment.standard_error)
    ends = [
        fixed(number, places) if math.isfinite(number) else "any value" for number in (low, high)
    ]
    return f"{100 * experiment.interval.level:.0f}%: e from {ends[0]} to {ends[1]}"


def _outside_words(outside: Sequence[Point]) -> str:
    words = []
    for point in outside:
        if point.alpha is not None and point.beta is not None:
            words.append(f"line {point.line} ({_degrees(point.alpha)}, {_degrees(point.beta)})")
        else:
            words.append(f"line {point.line} ({point.x:.3g}, {point.y:.3g})")
    return _list_sentence("Outside the frame", words)


def _thin_words(experiment: Experiment, total: int) -> str:
    drawn = len(experiment.points)
    return "" if drawn == total else f"Of {total} readings {drawn} are drawn."


def _degrees(angle: float) -> str:
    return f"{fixed(angle, 1)}°"


def _list_sentence(what: str, words: Sequence[str]) -> str:
    if not words:
        return ""
    shown = list(words[:_MOST_LISTED])
    if len(words) > _MOST_LISTED:
        shown.append(f"{len(words) - _MOST_LISTED} more")
    return f"{what}: {listed(shown)}."


def _law_words(experiment: Experiment, total: int, outside: int) -> str:
    what = (
        "tan β against tan α" if is_of_walls(experiment) else "speed of separation against approach"
    )
    beside = f", {outside} of them outside the frame" if outside else ""
    return (
        f"{what}: {total} readings with their errors{beside}; the line of the fit, "
        f"{_fit_label(experiment).removeprefix('fit: ')}, with a band from "
        f"{_band_label(experiment).partition('from ')[2]}; and the line e = 1."
    )


def _angle_or_speed(point: Point) -> float:
    return point.x if point.alpha is None else point.alpha


def _around(values: Sequence[float]) -> tuple[float, float]:
    """Limits a little beyond values."""
    low, high = min(values), max(values)
    room = 0.06 * (high - low) or 0.1 * abs(high) or 1.0
    return low - room, high + room
