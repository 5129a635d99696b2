"""Workings of questions of which some item has no answer: the others keep theirs."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from restitution.explaining.awarding.awards import awarded
from restitution.explaining.following.follower import Complaint, follow
from restitution.explaining.lines.derivation import Derivation, Meaning, Relation
from restitution.explaining.lines.notation import write_relation
from restitution.explaining.lines.storing import from_json, to_json
from restitution.expression.tree import Binary, letters
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning import planner
from restitution.planning.planner import plan
from restitution.planning.routes.order import Solver
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.scene import Scene
from restitution.solving import Solution, solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of

WALL = """
wall W: along i
sphere P: {mass}velocity 6i - 8j
P hits W{e}
"""
SPHERES = """
sphere A: mass 2, velocity {u}i + 3j
sphere B: mass 1, velocity {v}i
A hits B: along i{e}
"""

WITHOUT_E = (
    "Without e, the velocity of A immediately after the collision can still be worked out from the "
    "data."
)


@cache
def planned(text: str) -> tuple[Solution, Derivation]:
    """The solution of a statement, and its working, which the follower accepts."""
    solution = solve(parse(text))
    derivation = plan(solution)
    assert complaints(solution, derivation) == ()
    assert from_json(to_json(derivation)) == derivation
    return solution, derivation


def complaints(solution: Solution, derivation: Derivation) -> tuple[Complaint, ...]:
    return follow(derivation, Oracle(roles(solution.problem)))


def printed(solution: Solution) -> str:
    return " ".join(to_text(explain(solution)).split())


def test_a_coefficient_that_is_too_large_is_worked_out() -> None:
    """B leaves at 10, where it could leave at 8 at most."""
    text = SPHERES.format(u=6, v=0, e="") + "given velocity(B) = 10i\nfind e, velocity(A)"
    solution, derivation = planned(text)
    (note,) = derivation.notes
    assert (note.item, note.kind, note.place) == ("1", "impossible", 0)
    assert note.premises[1] == "e <= 1"
    assert [each.item for each in derivation.items] == ["2"]
    assert list(derivation.asked) == ["1", "2"]
    told = printed(solution)
    reason = "e = 3/2 is impossible, as a coefficient of restitution is at most 1."
    shown = f"{reason} So no value of e is possible: what is given cannot occur. A1"
    assert f"{shown} {WITHOUT_E}" in told
    assert "𝐯_A = (𝐢 + 3𝐣) m s⁻¹" in told


def test_a_coefficient_over_a_sum_of_roots_has_the_form_of_its_message() -> None:
    text = (
        "sphere A: mass m, velocity 2u at 60°\nsphere B: mass 2m, velocity u at 135°\n"
        "A hits B: along i\ngiven velocity(A) parallel to j\nfind e"
    )
    solution, derivation = planned(text)
    form = "e = (1 - sqrt(2))/(2 + sqrt(2)) = (4 - 3sqrt(2))/2"
    assert write_relation(derivation.lines[-1].relation).startswith(form)
    assert "≈ −0.121 e ≈ −0.121 is impossible" in printed(solution)


def test_the_range_of_an_impossible_coefficient_has_its_value() -> None:
    """It was said in one line, with a mark, that no value is possible; or that the data clash."""
    text = (
        "sphere A: mass m, velocity u at 45°\nsphere B: mass 3m, at rest\nA hits B: along i\n"
        "given deflection(A) = 90°\nfind range of e"
    )
    impossible = "e = 5/3 is impossible, as a coefficient of restitution is at most 1. So no value"
    assert impossible in printed(planned(text)[0])
    told = printed(planned(text.replace("find", "find e,"))[0])
    assert impossible in told
    assert told.endswith("No value of e is possible, as shown above.")


def test_an_impossible_coefficient_in_letters_is_worked_out_for_its_range() -> None:
    """That no value is possible stood above the lines that show it, with a mark."""
    text = (
        "sphere A: mass m, velocity u at theta\nsphere B: mass m, at rest\n"
        "given 0 < theta < 90°\nA hits B: along i\n"
        "given velocity(A) perpendicular to velocity(A, 0)\nfind range of e\nshow e > 0"
    )
    solution, derivation = planned(text)
    assert {note.premises[1:] for note in derivation.notes} == {("e <= 1", "acute: theta")}
    assert printed(solution).endswith(
        "(i) e = 1 + 2 tan²θ e = 1 + 2 tan²θ > 1 is impossible, as a coefficient of restitution is "
        "at most 1. So no value of e is possible: what is given cannot occur. A1 (ii) That e > 0 "
        "cannot be shown either, as there is no such impact."
    )


def test_a_negative_coefficient() -> None:
    text = SPHERES.format(u=6, v=0, e="") + "given velocity(A) = 5i + 3j\nfind e"
    solution, derivation = planned(text)
    assert derivation.notes[0].premises[1] == "e >= 0"
    assert "is impossible, as a coefficient of restitution is not negative." in printed(solution)


def test_what_cannot_be_found_beside_what_is_worked_out_says_why() -> None:
    """*Cannot be found either, as there is no such impact* stood below a speed that was found."""
    text = (
        "sphere A: mass m, velocity 3u at 30°\nsphere B: mass m, velocity u at 120°\n"
        "A hits B: along i\ngiven velocity(A) parallel to velocity(B, 0)\n"
        "find e, speed(A), energy_lost"
    )
    solution, _ = planned(text)
    assert "√3 u" in printed(solution)
    assert printed(solution).endswith(
        "(iii) There is no value of the kinetic energy lost in the collision: with e > 1 kinetic "
        "energy would be gained, which is impossible too."
    )


def test_what_is_and_what_is_not_worked_out_beside_an_impossible_coefficient() -> None:
    """*What else is asked does not depend on e* stood above what could not be found without it."""
    text = (
        "sphere A: mass 2, velocity 6i + 3j\nsphere B: mass 1, at rest\nA hits B: along i\n"
        "given velocity(A) = i + 3j\nfind e, energy_lost/energy(0), velocity(B), impulse"
    )
    shown = printed(planned(text)[0])
    assert "Without e, the other answers can still be worked out from the data." in shown
    assert "There is no value of the fraction of the total kinetic energy that is lost" in shown


def test_what_rests_on_an_impossible_coefficient_names_it() -> None:
    text = (
        "wall W: along i\nwall V: along j\nsphere P: mass 1, velocity 3i - 4j\nP hits W\n"
        "given speed(P) = 15\nP hits V\nfind e, speed(P)"
    )
    solution, derivation = planned(text)
    assert [each.item for each in derivation.notes] == ["1", "2"]
    assert (
        "e = 3√6/2 is impossible, as a coefficient of restitution is at most 1. So no value of e "
        "is possible: what is given cannot occur. A1 The speed of P immediately after the impact "
        "with V cannot be found either, as there is no such impact."
    ) in printed(solution)


def test_a_coefficient_of_the_data() -> None:
    text = WALL.format(mass="mass 1, ", e=": e = 5/4") + "find speed(P), impulse"
    solution, derivation = planned(text)
    assert derivation.lines == ()
    assert [each.premises for each in derivation.notes] == [("e 1", "restitution(1) <= 1")] * 2
    assert (
        "The speed of P immediately after the impact and the magnitude of the impulse in the "
        "impact cannot be found, as a coefficient of restitution is at most 1, and not 5/4."
        in printed(solution)
    )


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        (
            (
                "sphere A: mass m, velocity u at theta\nsphere B: mass 2m, at rest\n"
                "A hits B: along i, e = e\n"
                "given energy_lost = 1/3 m u^2 (1 - e^2) cos^2(theta)\nfind e, theta"
            ),
            "= ⅓mu²(1 − e²) cos²θ",
            "That is so for all values of e and θ, so e and θ cannot be found.",
        ),
        (
            (
                "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W: e = 1/2\n"
                "given tan(angle(velocity(P), W)) = 1/2 tan(alpha)\nfind alpha"
            ),
            "tan β = ½u sin α/(u cos α) = ½ tan α",
            "It is given that tan β = ½ tan α. That is so for all values of α, so α cannot be",
        ),
    ],
)
def test_a_fact_that_holds_whatever_a_letter_is(text: str, line: str, words: str) -> None:
    solution, derivation = planned(text)
    assert line in printed(solution)
    assert words in printed(solution)
    note = derivation.notes[0]
    assert note.lines
    # A follower asks that the fact says no more than the lines.
    lines = tuple(
        replace(each, relation=changed(each.relation)) if each.number in note.lines else each
        for each in derivation.lines
    )
    complaints = follow(replace(derivation, lines=lines), Oracle(roles(solution.problem)))
    assert "not-idle" in {each.reason for each in complaints}


SPARE = """
wall W: along i, through (0, 0)
sphere P: mass 2, at (0, 4), velocity u at 30° to W
P hits W: e = 1/2
given time(1) = 2, {given}
find u
"""


def test_a_given_fact_that_no_answer_needs_is_checked_without_a_mark() -> None:
    solution, derivation = planned(SPARE.format(given="impulse = 6"))
    words = printed(solution)
    assert "magnitude of the impulse = 2(1 + 2) = 6 N s It is also given that" in words
    (note,) = derivation.notes
    assert note.kind == "agreeing" and note.lines
    marked = awarded(derivation)
    own = [each for each in marked.lines if each.number in note.lines]
    assert own and not any(each.marks for each in own)
    lines = tuple(
        replace(each, relation=changed(each.relation)) if each.number in note.lines else each
        for each in derivation.lines
    )
    others = complaints(solution, replace(derivation, lines=lines))
    assert "not-idle" in {each.reason for each in others}


def test_a_given_letter_that_no_line_holds_is_not_needed() -> None:
    words = printed(solve(parse(SPARE.format(given="k = 3"))))
    assert "It is also given that k = 3, which is not needed here." in words


def test_a_value_of_another_part_does_not_stand_against_a_condition() -> None:
    text = (
        "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: velocity u at 180° - alpha\n"
        "A hits B: along i\npart a\ngiven tan^2(alpha) > e\n"
        "show tan(deflection(A)) = (1 + e) tan(alpha)/(tan^2(alpha) - e)\n"
        "part b\ngiven alpha = 30°, deflection(A) = 90°\nfind e\n"
    )
    explanation = explain(solve(parse(text)), check=True)
    assert explanation.followed
    words = " ".join(to_text(explanation).split())
    assert "= (1 + e) tan α/(tan²α − e) (as required)" in words and "e = ⅓" in words


def test_spheres_that_do_not_meet_are_shown_not_to() -> None:
    text = """
sphere A: mass 3, velocity 2i + 3j, at (0, 0)
sphere B: mass 2, velocity -3i + {}j, at (2, {})
A hits B: along i, e = 1
find velocity(A)
"""
    words = printed(solve(parse(text.format(1, 0))))
    assert "x-coordinates differ by 2 − 5t, which is 0 only at t = ⅖, and their y-coord" in words
    assert "their y-coordinates are never equal" in printed(solve(parse(text.format(3, 1))))


def test_a_square_that_letters_make_negative() -> None:
    """36u² − 2v² − w² = 40u²."""
    text = (
        "sphere A: mass 2m, velocity 4u i + 3u j\nsphere B: mass m, velocity -2u i + u j\n"
        "A hits B: along i\ngiven energy_lost = 20 m u^2\nfind e"
    )
    words = printed(solve(parse(text)))
    assert "v² = −(4u² + w²)/2 This cannot be, as a square is not negative." in words


def test_what_is_open_beside_an_item_is_not_known_either() -> None:
    text = WALL.format(mass="", e="").replace(": along i", "")
    words = printed(solve(parse(text + "given speed(P) = 4\nfind e, direction(W)")))
    assert "too little is given: e is not known either." in words


@pytest.mark.parametrize(
    ("item", "reason"),
    [
        ("energy_lost as a percentage", "a percentage needs a ratio"),
        ("range of e\ngiven velocity(B) > 1", "vectors cannot be compared by size"),
    ],
)
def test_what_is_asked_amiss_has_no_working_and_no_mark(item: str, reason: str) -> None:
    solution, derivation = planned(
        SPHERES.format(u=5, v=1, e=": e = e").replace(": e", ", e") + f"find {item}"
    )
    assert [note.kind for note in derivation.notes] == ["unsolved"]
    last = printed(solution).partition("There is no working of ")[2]
    assert reason in last and "B1" not in last
    assert not printed(solution).endswith("?.")


def changed(relation: Relation | Meaning) -> Relation:
    """A line that says twice as much as it should."""
    assert isinstance(relation, Relation)
    (*links, last) = relation.only
    return Relation(((*links, replace(last, right=Binary("+", last.right, last.right))),))


@pytest.mark.parametrize(
    ("text", "kind", "reason"),
    [
        (WALL.format(mass="", e="") + "find e", "missing", "too little is given"),
        (
            SPHERES.format(u=1, v=4, e=": e = 1/2").replace(": e", ", e") + "find speed(B)",
            "impossible",
            "A and B are separating",
        ),
        (
            (
                "wall W\nsphere P: velocity 4i - 2j\nP hits W: e = 1/2\n"
                "given speed(P) = 5\nfind direction(W)"
            ),
            "contradiction",
            "the other data make it impossible that the speed of P",
        ),
    ],
)
def test_a_question_without_any_answer(text: str, kind: str, reason: str) -> None:
    solution, derivation = planned(text)
    (note,) = derivation.notes
    assert note.kind == kind
    # That they do not approach is seen in their components; of the others nothing has a line.
    assert bool(note.premises) == bool(derivation.lines) == (kind == "impossible")
    assert note.reason.startswith(reason)
    assert reason.casefold() in printed(solution).casefold()


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ("velocity(A) = 3i + 3j, velocity(B) = 5i", "𝐯_A = ((7/2)𝐢 + 3𝐣) m s⁻¹ But it is"),
        ("velocity(B) = 8i, speed(A) = 9", "M1 A1 But it is given that the speed of A"),
    ],
)
def test_data_that_contradict_each_other_are_worked_out(given: str, told: str) -> None:
    solution, derivation = planned(SPHERES.format(u=6, v=0, e="") + f"given {given}\nfind e")
    (note,) = derivation.notes
    assert note.kind == "contradiction"
    assert note.lines
    assert note.premises[0].startswith("given ")  # type: ignore[union-attr]
    text = printed(solution)
    assert told in text
    assert text.rpartition(" ")[0].endswith("So the data contradict each other.")


@pytest.mark.parametrize(("share", "angle"), [("3/4", "50°"), ("1/2", "35°"), ("2/3", "60°")])
def test_premises_that_clash_before_the_last_is_cited_are_needed_still(
    share: str, angle: str
) -> None:
    # The component that stays, u sin α, is more than the speed: all follows of these two alone.
    text = (
        "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\n"
        f"A hits B: along i, e = e\ngiven speed(A) = {share} u, alpha = {angle}\nfind e"
    )
    solution, derivation = planned(text)
    assert derivation.notes[0].kind == "impossible"
    assert printed(solution).rstrip(" A1").endswith("So what is described cannot happen.")


def test_data_that_contradict_each_other_for_all_letters() -> None:
    text = (
        "sphere A: mass m, velocity u at 30°\nsphere B: mass 2m, velocity u at theta from -i\n"
        "A hits B: along i, e = 2/3\ngiven B at rest\nfind theta"
    )
    solution, _ = planned(text)
    assert "sin θ is not zero, as θ is acute. But it is given that B is at rest" in printed(
        solution
    )


def test_what_cannot_happen_is_not_said_of_what_is_asked() -> None:
    text = SPHERES.format(u=1, v=4, e=", e = 1/2") + "find velocity(A), impulse"
    words = printed(planned(text)[0])
    told = "So A and B are separating along the line of centres: what is described cannot happen."
    assert words.endswith(
        f"A moves in the direction of 𝐢 and hits B, so B is ahead of it. {told} B1"
    )
    assert words.count("cannot happen") == 1


def test_missing_data_leave_the_others_their_lines() -> None:
    text = (
        "sphere P: velocity 6i - 8j\nsphere Q: mass 2, velocity 4j\nwall W: along i\n"
        "P hits W: e = 1/4\npart a\nfind impulse(1), speed(P)\npart b\nfind angle(velocity(P), W)"
    )
    solution, derivation = planned(text)
    assert derivation.asked == {"a1": "a", "a2": "a", "b1": "b"}
    told = printed(solution)
    assert "as the mass of P is not given." in told
    assert told.index("cannot be found, as") < told.index("speed of P")


def test_the_follower_reads_notes() -> None:
    text = SPHERES.format(u=6, v=0, e="") + "given velocity(B) = 10i\nfind e"
    solution, derivation = planned(text)
    (note,) = derivation.notes

    def reasons(**changes: object) -> list[str]:
        changed = replace(derivation, notes=(replace(note, **changes),))  # type: ignore[arg-type]
        return [each.reason for each in complaints(solution, changed)]

    line = note.lines[0]
    assert reasons(premises=(line, "e >= 0")) == ["not-excluded"]
    assert reasons(premises=(line, "e <= 1", "e >= 0")) == ["premise-not-needed"]
    assert reasons(premises=(99, "e <= 1"))[0] == "premise-unknown"
    assert "leads-nowhere" in reasons(premises=())


IN_PARTS = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
part a
find speed(P), impulse
part b
find range of speed(P) in terms of u
"""


@pytest.fixture
def without_ranges(monkeypatch: pytest.MonkeyPatch) -> None:
    def write_range(scene: Scene, solver: Solver, *_: object) -> None:
        solver.determine([scene.velocity("P", 1).x])
        raise NotPlannedError("a range")

    monkeypatch.setattr(planner, "write_range", write_range)


@pytest.mark.usefixtures("without_ranges")
def test_one_item_without_a_plan_leaves_the_others_theirs() -> None:
    solution = solve(parse(IN_PARTS))
    with pytest.raises(NotPlannedError, match="a range"):
        plan(solution)
    derivation = plan(solution, partial=True)
    assert complaints(solution, derivation) == ()
    (note,) = derivation.notes
    assert (note.item, note.part, note.kind) == ("b1", "b", "unwritten")
    assert [each.item for each in derivation.items] == ["a1", "a2"]
    printed_note = to_text(explanation_of(derivation, solution.problem))
    flat = " ".join(printed_note.split())
    assert "The steps from here are not written out: 0 < speed of P ≤ u" in flat


@pytest.mark.usefixtures("without_ranges")
def test_a_part_without_a_plan_has_the_derivation_of_the_whole() -> None:
    solution = solve(parse(IN_PARTS))
    explanation = explain(solution, check=True)
    first, second = explanation.parts
    assert explanation.followed
    assert first.derivation is second.derivation is not None
    assert second.steps
    assert explain(solution, "a").parts == (first,)
    assert explain(solution, "b").parts == (second,)


def test_a_mass_that_is_not_given_cancels() -> None:
    text = (
        "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W: e = 1/2\n"
        "find impulse, energy_lost/energy(0)"
    )
    solution, derivation = planned(text)
    assert [(each.item, each.kind) for each in derivation.notes] == [("1", "missing")]
    assert "the mass cancels" in printed(solution)
    assert [write_relation(each.answer) for each in derivation.items] == [
        "energy_lost(1)/energy(0) = 12/25"
    ]


def test_a_mass_that_is_asked() -> None:
    text = (
        "sphere A: mass 3, velocity 4i + j\nsphere B: velocity -2i\nA hits B: along i, e = 1/3\n"
        "given velocity(B) = 2i\nfind mass(B), velocity(A)"
    )
    _, derivation = planned(text)
    assert derivation.notes == ()
    assert [write_relation(each.answer) for each in derivation.items] == [
        "m_B = 3",
        "velocity(A, 1) = j",
    ]


def test_what_does_not_rest_on_an_impossible_coefficient_earns_its_marks() -> None:
    """The coefficient has its answer mark, and so has a speed that comes of the direction alone."""
    text = (
        "sphere A: mass m, velocity 4u at 30°\nsphere B: mass m, velocity 2u at 120°\n"
        "A hits B: along i\ngiven velocity(A) parallel to velocity(B, 0)\n"
        "find e, speed(A)"
    )
    (part,) = explain(solve(parse(text))).parts
    assert part.item_marks[0] > 0
    assert part.item_marks[1] > 0


def test_an_answer_is_in_the_letters_that_are_asked_for() -> None:
    """Where lines lead to other letters, the answer of the solver is noted."""
    problem = parse(
        """
        wall W: along j
        sphere B: mass m, velocity U at theta
        B hits W
        given velocity(B) perpendicular to velocity(B, 0)
        find energy_lost in terms of m, U, e
        find energy_lost/energy(0) in terms of theta
        """
    )
    derivation = plan(solve(problem), partial=True)
    asked = {"1": {"m", "U", "e"}, "2": {"theta"}}
    for end in derivation.items:
        assert letters(end.answer.only[-1].right) <= asked[end.item]
    assert {each.item for each in (*derivation.items, *derivation.notes)} == {"1", "2"}
