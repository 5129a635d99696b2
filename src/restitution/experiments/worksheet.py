"""A worksheet of the experiment with a wall, for a class: what to do, a table, axes, questions.

It needs no library of the extra "experiment". The angles to aim at are those that the plan of such
an experiment recommends, so that the class can check the model.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from restitution.counting import listed
from restitution.drawing.scene import (
    Arc,
    Arrow,
    Disc,
    Dot,
    Label,
    Line,
    LineRole,
    Scene,
    Shape,
    Side,
    StraightWall,
)
from restitution.drawing.svg import to_svg
from restitution.errors import StatementError
from restitution.experiments import questions
from restitution.experiments.formulas import ALPHA, BETA, TAN_ALPHA, TAN_BETA, E, U, V, mixed
from restitution.experiments.numbers import fixed
from restitution.experiments.planning import HIGHEST, LOWEST, planned
from restitution.experiments.whole import Plan
from restitution.records import dataclass
from restitution.render.document import (
    Block,
    Document,
    Heading,
    Inline,
    Item,
    Listing,
    NewPage,
    Paragraph,
    Picture,
    Table,
)
from restitution.render.layout import Fraction, Layout, Number
from restitution.render.typst import NAME
from restitution.vector import Vector

TITLE = "The coefficient of restitution of a wall"
USUAL_TRIALS = 8
FEWEST_TRIALS, MOST_TRIALS = 3, 40
TYPICAL_E = 0.7
"""Of a ball and a wall, by which angles to aim at are chosen."""
TYPICAL_ERROR = 1.0
"""Of an angle that is read with a protractor, in degrees."""


def worksheet(
    trials: int = USUAL_TRIALS, *, solutions: bool = False, title: str | None = None
) -> Document:
    """The worksheet, with as many rows to fill in as there are trials.

    With ``solutions`` answers and what to expect stand behind, for the teacher. Raises
    StatementError for a number of trials that makes no experiment.
    """
    if not FEWEST_TRIALS <= trials <= MOST_TRIALS:
        raise StatementError(
            f"trials is {trials}: a worksheet has from {FEWEST_TRIALS} to {MOST_TRIALS} of them"
        )
    plan = planned(TYPICAL_E, TYPICAL_ERROR, trials, 1)
    angles = plan.design(plan.recommended).angles
    blocks = [
        *_aim(),
        *_method(),
        NewPage(),
        *_readings(angles),
        *_axes(angles),
        NewPage(),
        *_questions(),
        *(_solutions(plan) if solutions else ()),
    ]
    return Document(title or TITLE, tuple(blocks), "" if solutions else NAME)


# --- what to do -------------------------------------------------------------------------------


def _aim() -> Iterator[Block]:
    yield Heading("Aim")
    yield Paragraph(mixed(questions.AIM))
    yield Picture(to_svg(_situation()), 84)
    yield Paragraph(mixed(questions.SITUATION), "remark")
    yield Heading("Apparatus")
    yield Paragraph(questions.APPARATUS)


def _method() -> Iterator[Block]:
    yield Heading("Method")
    steps = tuple(Item(mixed(sentence)) for sentence in questions.METHOD)
    yield Listing(steps, numbered=True)


_BALL = 4.0


def _situation() -> Scene:
    """A ball at a wall, with the angles named; not to the scale of any reading."""
    alpha, beta = math.radians(48), math.radians(33)
    start = Vector(-math.cos(alpha), math.sin(alpha)) * 32
    end = Vector(math.cos(beta), math.sin(beta)) * 32
    centre = Vector(0.0, 0.0)
    shapes: list[Shape] = [
        StraightWall("W", Vector(-36.0, -_BALL), Vector(36.0, -_BALL), Vector(0.0, -1.0)),
        Line("across", Vector(-36.0, 0.0), Vector(36.0, 0.0)),
        Disc("", centre, _BALL, ghost=True),
        Disc("", start, _BALL),
        Arrow("path", start - start * (_BALL / 32), start * 0.45),
        Line("path", start * 0.45, centre),
        Arrow("path", centre, end),
        Dot("", centre, 0.5),
        Arc("angle", centre, 9.0, math.pi - alpha, math.pi),
        Arc("angle", centre, 9.0, 0.0, beta),
    ]
    labels = [
        _named(ALPHA, math.pi - alpha / 2, 9.0, ("w", "nw")),
        _named(BETA, beta / 2, 9.0, ("e", "ne")),
        Label(U, start * 0.62, ("ne", "n", "e"), 1.0),
        Label(V, end * 0.6, ("nw", "n"), 1.0),
    ]
    return Scene(
        "A ball at a wall",
        "A ball comes to a wall at an angle alpha to it and leaves at a smaller angle beta.",
        (-40.0, -_BALL - 3.0, 40.0, 30.0),
        tuple(shapes),
        tuple(labels),
    )


def _named(letter: Layout, angle: float, radius: float, sides: tuple[Side, ...]) -> Label:
    at = Vector(math.cos(angle), math.sin(angle)) * radius
    return Label(letter, at, sides, 0.8)


# --- what is written down ---------------------------------------------------------------------


def _readings(angles: tuple[float, ...]) -> Iterator[Block]:
    yield Heading("Readings")
    heads: tuple[Inline, ...] = (
        "trial",
        ("aim at ", ALPHA),
        ALPHA,
        BETA,
        TAN_ALPHA,
        TAN_BETA,
        Fraction(TAN_BETA, TAN_ALPHA),
    )
    height = 8.0 if len(angles) <= 12 else 6.5
    rows = tuple((str(number), f"{angle:g}°", *[""] * 5) for number, angle in enumerate(angles, 1))
    yield Table(heads, rows, "ccccccc", height=height, ruled=True)
    yield Paragraph(questions.REPEATED)


@dataclass(frozen=True)
class _Grid:
    """Axes from 0 to ``most`` on both sides, with a line every tenth, in millimetres on paper."""

    most: float
    side_y: float
    side_x: float = 150.0

    def at(self, x: float, y: float) -> Vector:
        return Vector(self.side_x * x / self.most, self.side_y * y / self.most)

    @property
    def steps(self) -> int:
        return round(self.most * 10)


_SHARED, _ALONE = 100.0, 170.0  # height of the graph, in millimetres
_BESIDE = 8  # trials whose table leaves room for the graph on its page


def _axes(angles: tuple[float, ...]) -> Iterator[Block]:
    if len(angles) > _BESIDE:
        yield NewPage()
    yield Heading("Graph")
    largest = math.tan(math.radians(max(angles)))
    most = math.ceil(largest * 1.15 * 2) / 2
    height = _ALONE if len(angles) > _BESIDE else _SHARED
    yield Picture(to_svg(_grid(_Grid(most, height))), 165)


def _grid(grid: _Grid) -> Scene:
    """Axes to draw on."""
    shapes: list[Shape] = []
    labels: list[Label] = []
    every = 5 if grid.most <= 3 else 10
    for step in range(1, grid.steps + 1):
        value = step / 10
        role: LineRole = "measure" if step % every == 0 else "frame"
        shapes += [
            Line(role, grid.at(value, 0), grid.at(value, grid.most)),
            Line(role, grid.at(0, value), grid.at(grid.most, value)),
        ]
    for step in range(0, grid.steps + 1, every):
        number = Number(fixed(step / 10, 1))
        labels.append(Label(number, grid.at(step / 10, 0), ("s",), 1.2, 3.0, fixed=True))
        labels.append(Label(number, grid.at(0, step / 10), ("w",), 1.2, 3.0, fixed=True))
    beyond = 8.0
    shapes += [
        Arrow("axis", Vector(0.0, 0.0), Vector(grid.side_x + beyond, 0.0)),
        Arrow("axis", Vector(0.0, 0.0), Vector(0.0, grid.side_y + beyond)),
    ]
    labels += [
        Label(TAN_ALPHA, Vector(grid.side_x + beyond, 0.0), ("n",), 1.5, 3.4, fixed=True),
        Label(TAN_BETA, Vector(0.0, grid.side_y + beyond), ("e", "w"), 1.5, 3.4),
    ]
    return Scene(
        "Axes for the graph",
        f"Axes of tan alpha and tan beta from 0 to {grid.most:g}, with a line every tenth.",
        (-8.0, -8.0, grid.side_x + beyond + 5.0, grid.side_y + beyond + 1.0),
        tuple(shapes),
        tuple(labels),
    )


# --- questions and answers --------------------------------------------------------------------


def _questions() -> Iterator[Block]:
    yield Heading("Questions")
    items = tuple(Item(mixed(question.words), question.room) for question in questions.QUESTIONS)
    yield Listing(items, numbered=True)


def _solutions(plan: Plan) -> Iterator[Block]:
    yield NewPage()
    yield Heading("For the teacher: answers")
    answers = tuple(Item(mixed(question.answer)) for question in questions.QUESTIONS)
    yield Listing(answers, numbered=True)
    yield Heading("For the teacher: what to expect")
    yield from _expected(plan)


def _expected(plan: Plan) -> Iterator[Block]:
    design = plan.design(plan.recommended)
    heads: tuple[Inline, ...] = (ALPHA, *(_at_e(e) for e in _EXPECTED))
    rows = tuple(
        (f"{alpha:g}°", *(f"{fixed(_beta(alpha, e), 1)}°" for e in _EXPECTED))
        for alpha in range(LOWEST, HIGHEST + 1, 5)
    )
    yield Paragraph((BETA, " at the usual angles:"))
    yield Table(heads, rows, "r" * len(heads), narrow=True)
    counts = listed([f"{trials} trials for ±{width:g}" for width, trials in plan.trials_for])
    turn = design.smallest_turn
    seen = "" if turn is None else f" It sees a line of reference that is turned by {turn:.1f}°."
    yield Paragraph(
        mixed(
            f"With {{e}} near {plan.e:g} and angles read to ±{plan.angle_error:g}°, these "
            f"{plan.trials} trials tell {{e}} to ±{fixed(design.half_width, 3)} (95%); it takes "
            f"{counts}. The check of the model is possible as the angles are spread.{seen}"
        )
    )
    yield Paragraph(questions.COMMAND)


_EXPECTED = (0.5, 0.6, 0.7, 0.8, 0.9)


def _at_e(e: float) -> tuple[str | Layout, ...]:
    return E, f" = {e:g}"


def _beta(alpha: float, e: float) -> float:
    """β in degrees."""
    return math.degrees(math.atan(e * math.tan(math.radians(alpha))))
