"""The letters box above a working: a row for every unknown that the diagram shows."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.components.frames import Frame
from restitution.components.models import Model
from restitution.components.telling import model
from restitution.errors import RestitutionError
from restitution.expression.tree import (
    Expression,
    Name,
    Negate,
    Polar,
    Quantity,
    Unit,
    negated,
    walk,
)
from restitution.expression.writing import write_expression
from restitution.practice.letters.candidates import velocity
from restitution.practice.letters.options import staged
from restitution.practice.letters.surroundings import letters_of
from restitution.practice.letters.wordings import words_of
from restitution.problem import Impact, Part, Problem, trees
from restitution.records import dataclass
from restitution.solving.equations.solution import Solution
from restitution.solving.story.forward import lets_of

_ANGLES = ("beta", "theta", "phi", "psi", "gamma", "omega", "delta", "eta")
_SPEEDS = ("V", "W", "S", "T", "R", "X", "Y", "Z")
_FAILURES = (RestitutionError, ArithmeticError, LookupError, AssertionError)


@dataclass(frozen=True)
class BoxRow:
    """A letter with its meaning, as text of the statement language, and in words.

    ``turned`` and ``turned_words`` are those of the other sense, None where it has none.
    """

    letter: str
    meaning: str
    words: str
    turned: str | None = None
    turned_words: str | None = None

    def json(self) -> dict[str, str | None]:
        """The row as an object."""
        return {
            "letter": self.letter,
            "meaning": self.meaning,
            "words": self.words,
            "turned": self.turned,
            "turned_words": self.turned_words,
        }


def letters_box(
    problem: Problem, solution: Solution, part: str | None = None
) -> tuple[BoxRow, ...]:
    """The rows for a part: unknown components after each of its impacts, speeds and angles.

    Letters are those of the working and of the diagram. Raises KeyError for a part that is not
    there; a part without a solution has no rows.
    """
    solved = solution.parts[part]
    if not solved.branches:
        return ()
    try:
        letters_model = model(problem, solved.part, solved.branches[0], solved.roles)
    except _FAILURES:
        return ()
    return tuple(_rows(problem, solved.part, letters_model))


def _rows(problem: Problem, part: Part, letters_model: Model) -> Iterator[BoxRow]:
    taken = set(letters_of(problem, part)) | {
        component.symbol.name for component in letters_model.components.values()
    }
    events = [n for n, step in enumerate(letters_model.story.happenings, 1)]
    for (number, body), component in letters_model.components.items():
        quantity = _component(letters_model, number, body)
        yield _row(component.symbol.name, quantity, problem, sensed=True)
    if not _in_angles(problem):
        return
    lets = lets_of(problem, part).values()
    named = {staged(let.expression, problem, part, now) for let, now in lets}
    angles = (name for name in _ANGLES if name not in taken)
    speeds = (name for name in _SPEEDS if name not in taken)
    for number in events:
        step = letters_model.story.happenings[number - 1].step
        if not isinstance(step, Impact):
            continue
        for body in letters_model.spheres(number):
            for letters, quantity in (
                (speeds, Quantity("speed", (Name(body),), number)),
                (angles, _angle(step, number, body, problem)),
            ):
                letter = None if quantity in named else next(letters, None)
                if letter is not None:
                    yield _row(letter, quantity, problem, sensed=False)


def _row(letter: str, quantity: Expression, problem: Problem, *, sensed: bool) -> BoxRow:
    other = negated(quantity) if sensed else None
    return BoxRow(
        letter,
        write_expression(quantity),
        words_of(quantity, problem),
        None if other is None else write_expression(other),
        None if other is None else words_of(other, problem),
    )


def _in_angles(problem: Problem) -> bool:
    """Whether the statement speaks in speeds and angles, and not in components alone."""
    return any(isinstance(node, Polar) for tree in trees(problem) for node in walk(tree))


def _angle(step: Impact, number: int, body: str, problem: Problem) -> Expression:
    if any(wall.name == step.second for wall in problem.walls):
        return Quantity("angle", (velocity(body, number), Name(step.second)))
    line = Quantity("line_of_centres", (), number)
    return Quantity("angle", (velocity(body, number), line))


def _component(letters_model: Model, number: int, body: str) -> Expression:
    """The component of a letter of the working: along i or j, or along the line of centres."""
    frame, of = letters_model.frames[number], velocity(body, number)
    if frame.axis is not None:
        unit = Unit(frame.axis)
        size = frame.n.x if frame.axis == "i" else frame.n.y
        value = Quantity("along", (of, unit))
        return value if letters_model.sign(size) > 0 else Negate(value)
    return _along_line(letters_model, frame, number, of)


def _along_line(letters_model: Model, frame: Frame, number: int, of: Expression) -> Expression:
    value = Quantity("along", (of, Quantity("line_of_centres", (), number)))
    same = letters_model.sign(frame.n.dot(letters_model.happening(number).oriented())) > 0
    return value if same else Negate(value)
