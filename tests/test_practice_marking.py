"""Marks of workings, point by point, compared with those given by hand; and what is said."""

from __future__ import annotations

from functools import cache

import pytest

import restitution
from restitution.planning.planner import plan
from restitution.practice.marking import scheme
from restitution.practice.marking.scheme import schemes

PAIR = """
sphere A: mass 2, velocity 3i + 2j
sphere B: mass 4, velocity -i + j
A hits B: along i, e = 1/2
find velocity(A), velocity(B)
"""
SHOW = """
sphere A: mass m, velocity u*cos(alpha) i + u*sin(alpha) j
sphere B: mass 3m, at rest
A hits B: along i
show along(velocity(B), i) = u*(1 + e)*cos(alpha)/4
"""
WALL = """
wall W: along i
sphere P: mass 2, velocity u at alpha to W
let alpha = arctan(3/4)
P hits W: e = 1/3
part a
find speed(P)
part b
find deflection(P)
"""
EQUAL = """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along i, e = 1/4
given speed(A) = speed(B)
find tan(alpha)
"""
TURNED = """
wall W: along i
sphere P: mass 2, velocity 12i - 5j
P hits W: e = 1/3
find deflection(P)
"""
TWICE = """
sphere B: mass m, velocity u i
sphere C: mass 3m, at rest
sphere A: mass 3m, at rest
B hits C: along i, e = 2/3
B hits A: along i, e = 2/3
find total_energy_lost/energy(0)
"""
BOTH = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
ONE = {
    "v": "along(velocity(P), i)",
    "w": "along(velocity(P), j)",
    "b": "angle(velocity(P), W)",
}

# Each working with its marks by hand: + earned, - lost, in the order of the scheme.
BY_HAND = [
    (PAIR, None, "++++++++", "2*3 - 4*1 = 2v + 4w; w - v = 2; v = -1; w = 1; vel A; vel B"),
    (PAIR, None, "-++++---", "2*3 - 4*1 = 2v + 4w; w - v = 0.5*4"),
    (PAIR, None, "++-+++--", "6 + 4 = 2v + 4w; w - v = 2; w = 7/3, v = 1/3; wrong A; wrong B"),
    (PAIR, None, "+++-----", "6 - 4 = 2v + 4w; 1/2(w - v) = 4; w = 3, v = -5; ends A; ends B"),
    (PAIR, None, "++++++++", "vel A; vel B"),
    (PAIR, None, "-+++++-+", "vel B"),
    (SHOW, None, "++++++", "clm; nel; 4w = (1+e)u cos α; w = ends"),
    (SHOW, None, "+++++-", "clm; nel; w = ends"),
    (SHOW, None, "------", "w = ends"),
    (WALL, "a", "++++", "v = 4u/5; w = 1/3 * 3u/5 = u/5; speed = √(16/25 + 1/25) u = √17 u/5"),
    (WALL, "a", "++++", "speed = 0.825u"),
    (WALL, "a", "----", "speed = u/3"),
    (WALL, "b", "+++", "tan b = (u/5)/(4u/5) = 1/4; b = 14.0; deflection = 36.9 + 14.0 = 50.9"),
    (WALL, "b", "+--", "tan b = 1/4; b = 14.0; deflection = 14.0"),
    # A value may hold the angle that is asked for; a slip keeps the method, and what stays in it.
    (EQUAL, None, "++++++++++", "along; apart; v and w; sizes; tan α = √21/12"),
    (EQUAL, None, "+++++++++-", "along; apart; v and w; w² = v² - u² sin² α"),
    (EQUAL, None, "-+++++----", "along; apart; 6v = u cos α; v = 1/3 u cos α"),
    # Of two angles, a line earns the method of its own, with what it cannot be had without.
    (TURNED, None, "++++--", "tan b = 5/36; b = 7.91; deflection = 7.91"),
    (TURNED, None, "--+---", "tan a = 5/12; a = 22.6; deflection = 22.6"),
]  # fmt: skip
IN_FULL = {
    "clm": "m u cos α = m v + 3 m w",
    "nel": "w - v = e u cos α",
    "w = ends": "w = u(1+e) cos α / 4",
    "along": "u cos α = v + 2w",
    "apart": "w - v = 1/4 u cos α",
    "v and w": "v = 1/6 u cos α, w = 5/12 u cos α",
    "sizes": "w² = v² + u² sin² α",
    "vel A": "velocity of A = -i + 2j",
    "vel B": "velocity of B = i + j",
    "wrong A": "velocity of A = 1/3 i + 2j",
    "wrong B": "velocity of B = 7/3 i + j",
    "ends A": "velocity of A = -5i + 2j",
    "ends B": "velocity of B = 3i + j",
}


@cache
def solution(statement: str) -> restitution.Solution:
    return restitution.solve(restitution.parse(statement))


def marked(statement: str, typed: str, part: str | None = None, hints: int = 0):
    lines = [IN_FULL.get(line.strip(), line.strip()) for line in typed.split(";")]
    letters = ONE if "sphere P" in statement else BOTH
    return restitution.mark(solution(statement), lines, part, letters, hints=hints)


@pytest.mark.parametrize(("statement", "part", "wanted", "typed"), BY_HAND)
def test_points_are_those_given_by_hand(statement, part, wanted, typed):
    points = marked(statement, typed, part).marks.points
    signs = {"earned": "+", "lost": "-", "open": "?"}
    assert "".join(signs[each.state] for each in points) == wanted


def test_a_question_is_planned_once_for_all_that_is_handed_in(monkeypatch):
    planned = []

    def counted(solution, route=1, **how):
        planned.append(route)
        return plan(solution, route, **how)

    monkeypatch.setattr(scheme, "plan", counted)
    own = restitution.solve(restitution.parse(TWICE))
    one, other = (restitution.mark(own, text).marks for text in ("v = 3", "fraction = 0.443"))
    assert planned == [1, 2, 3]
    assert [each.point.id for each in one.points] == [each.point.id for each in other.points]


def test_a_label_is_not_taken_for_what_fits_to_one_figure_only():
    marks = restitution.mark(solution(TWICE), "fraction = 0.221/0.5 = 0.443").marks
    assert marks.points[-1].state == "earned"


APART = """
sphere A: mass 1, velocity 4i + 3j
sphere B: mass 2, velocity -2i + j
A hits B: along i, e = 1/2
find distance(A, B, at 2)
"""
SQUARE = """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along i
given deflection(A) = 90°
show tan(alpha)^2 = (2e - 1)/3
"""


@pytest.mark.parametrize(
    ("end", "state"), [("dist = 2√13 = 7.2", "earned"), ("dist = 7.2", "lost")]
)
def test_an_exact_value_before_a_coarse_one_is_fine_enough(end, state):
    marks = restitution.mark(solution(APART), ["4 - 4 = v + 2w", "w - v = 3", end], None, BOTH)
    assert marks.marks.points[-1].state == state


def test_a_condition_that_holds_by_one_law_earns_its_method():
    typed = ["v = (1-2e)ucosα/3", "ucosα·v + usinα·usinα = 0", "tan²α = (2e-1)/3"]
    points = restitution.mark(solution(SQUARE), typed, None, {"v": BOTH["v"]}).marks.points
    assert [
        each.state for each in points if each.point.purpose == "the condition as an equation"
    ] == ["earned"]


def test_a_scheme_names_what_single_points_is_for():
    scheme, *_ = schemes(solution(PAIR))
    assert [point.kind for point in scheme.points] == [
        "B1",
        "M1",
        "A1",
        "M1",
        "A1",
        "DM1",
        "A1",
        "A1",
    ]
    known = {point.id for point in scheme.points}
    assert len(known) == scheme.total
    assert all(set(point.depends) <= known for point in scheme.points)
    dependent = scheme.points[5]
    assert dependent.depends == (scheme.points[1].id, scheme.points[3].id)


def test_a_value_that_cannot_be_earns_what_is_concluded_from_it():
    statement = """sphere A: mass 1, velocity 4i + j
sphere B: mass 2, at rest
A hits B: along i
given velocity(B) = 3i
find e, velocity(A)"""
    points = marked(statement, "4 = v + 2*3; v = -2; 3 - v = 4e; e = 5/4; vel A").marks.points
    assert [each.point.kind for each in points] == ["B1", "M1", "A1", "M1", "A1", "A1", "A1ft"]
    assert points[5].state == "earned"


def test_what_cannot_be_read_leaves_marks_open():
    marks = marked(PAIR, "6 - 4 = 2v + 4w; w - v = )(").marks
    assert marks.earned == 2
    assert marks.open
    assert marks.earned + marks.open + marks.lost == marks.of


TWO_VECTORS = """
sphere A: mass 5, velocity 6i + 5j
sphere B: mass 1, velocity -i + 3j
A hits B: along i, e = 3/7
find velocity(A), velocity(B)
"""


@pytest.mark.parametrize(
    ("line", "letter", "means"),
    [
        ("v = 2i + j", "v", "velocity of A after"),
        ("x = 9i + 5j", "x", "velocity of A after"),
        ("w = 4", "w", "component of A in the direction of i after"),
    ],
)
def test_a_value_that_fits_nothing_and_is_not_used_is_asked_about(line, letter, means):
    marking = restitution.mark(restitution.parse(TWO_VECTORS), line)
    assert [own.verdict for own in marking.lines] == ["asks"]
    assert [ask.letter for ask in marking.asks] == [letter]
    assert marking.asks[0].text.endswith(f"such as: let {letter} = {means}.")


def test_a_vector_that_a_line_below_uses_is_its_definition():
    marking = restitution.mark(
        restitution.parse(TWO_VECTORS), "n = (3i + 4j)/5\ncomponent of u_A along n = 7.6"
    )
    assert marking.lines[0].verdict == "true"


def test_a_line_has_all_its_keys():
    data = marked(PAIR, "6 + 4 = 2v + 4w; so; w - v = )(; w - v = 2").json()
    keys = {"n", "text", "read_as", "verdict", "accuracy"}
    keys |= {"principle", "event", "link", "from", "mistake"}
    assert [keys <= set(line) for line in data["lines"]] == [True] * len(data["lines"])
    assert data["lines"][0]["mistake"]["id"] == "momentum-sign"
    assert set(data["marks"]) == {"earned", "lost", "open", "of", "points"}


def test_nothing_is_said_before_it_is_asked_for():
    typed = "6 + 4 = 2v + 4w; w - v = 2; w = 7/3"
    assert marked(PAIR, typed).messages == ()
    for level in (1, 2, 3):
        for message in marked(PAIR, typed, hints=level).messages:
            assert "4(−1)" not in message.text
    messages = [each.text for each in marked(PAIR, typed, hints=1).messages]
    assert messages[0].startswith("This is conservation of momentum")
    assert messages[-1] == "Right, with your values. The mistake is in line 1."
    last = marked(PAIR, typed, hints=4).messages[0].text
    assert last == "The line is 2 × 3 + 4(−1) = 2v + 4w."


def test_the_next_step_is_asked_for_before_its_principle_is_named():
    for level in (1, 2, 3):
        (message,) = marked(PAIR, "vel A", hints=level).messages or (None,)
        assert message is None or "=" not in message.text
    (message,) = marked(PAIR, "6 - 4 = 2v + 4w", hints=1).messages
    assert message.text.startswith("What happens to the component perpendicular to")
    (message,) = marked(PAIR, "6 - 4 = 2v + 4w", hints=2).messages
    assert message.text.startswith("You have not used the component")


MISTAKES = """
wall W: along i
sphere Q: velocity 17 at alpha to W
given cos(alpha) = 15/17
Q hits W: e = 1/2
find speed(Q), angle(velocity(Q), W)
"""


def _said(script: str, question: str) -> str:
    marking = restitution.mark(restitution.parse(question), script, hints=3)
    return " ".join(message.text for message in marking.messages)


def test_what_a_mistake_leads_to_is_said_in_words():
    said = _said("v cos b = 17cos a\nv sin b = 8", MISTAKES)
    assert "It leads to speed of Q = 17" in said and "speed(" not in said


def test_where_a_mistake_is_said_only_if_it_is_certain():
    assert "Check where you write 3." in _said("v = 3\nspeed = sqrt(15^2+3^2)", MISTAKES)
    # The wrong sign may be that of any term.
    pair = "sphere A: mass 2m, velocity 3u i\nsphere B: mass 3m, velocity -2u i\nA hits B: along i"
    script = "2m*3u - 3m*2u = 2mv + 3mw\nw - v = 1/2 (3u - 2u)"
    said = _said(script, f"{pair}, e = 1/2\nfind velocity(A)")
    assert "wrong sign in Newton's law" in said and "Check where" not in said


def test_a_part_that_is_not_there_and_a_level_that_is_not_there():
    with pytest.raises(KeyError, match="parts: a, b"):
        marked(WALL, "v = 1", "z")
    with pytest.raises(restitution.StatementError, match="0 to 4"):
        marked(PAIR, "v = 1", hints=7)


def test_a_marking_is_text_for_a_terminal_and_html_that_holds_no_markup_of_the_student():
    marking = marked(PAIR, "<b>6 - 4 = 2v + 4w</b>; w - v = 2")
    assert max(map(len, str(marking).splitlines())) <= 80
    assert "Marks:" in str(marking)
    assert "<b>6" not in marking._repr_html_()


LINE = """sphere A: mass 5, velocity 4i
sphere B: mass 3, velocity -4i
A hits B: along i, e = 1/3
"""

UNNAMED = """wall W: along i
sphere P: mass 2, velocity 6i - 8j
P hits W: e = 1/4
"""


def of_letters(statement: str, typed: str, letters=BOTH):
    return restitution.mark(solution(statement), typed, letters=letters)


def test_components_answer_for_a_velocity_whose_other_component_is_zero():
    typed = "5*4 - 3*4 = 5v + 3w\nw - v = 1/3 * 8\n8v = 0\nv = 0\nw = 8/3"
    for asked in ("velocity(A), velocity(B)", "speed(A), speed(B)"):
        reply = of_letters(LINE + f"find {asked}", typed)
        assert reply.marks.earned == reply.marks.of
    wrong = of_letters(LINE + "find velocity(A), velocity(B)", typed.replace("w = 8/3", "w = 3"))
    assert wrong.marks.earned == wrong.marks.of - 1


def test_the_letter_of_a_component_answers_as_that_of_the_velocity():
    """``vB = 1, va = -1``, and at the end ``v_A = -i + 2j``: one letter is both."""
    typed = ["6 - 4 = 2va + 4vb", "vb - va = 2", "vb = 1, va = -1", "v_A = -i + 2j", "vB = i + j"]
    marks = restitution.mark(solution(PAIR), typed).marks
    assert marks.earned == marks.of
    wrong = restitution.mark(solution(PAIR), [*typed[:4], "vB = i + 2j"]).marks
    assert wrong.earned == wrong.of - 2  # the component across of B, and its velocity


def test_two_components_answer_for_a_velocity():
    statement = UNNAMED + "find velocity(P)"
    typed = "x component after = 6\ny component after = 1/4*8 = 2"
    both, one = of_letters(statement, typed, {}), of_letters(statement, typed.splitlines()[1], {})
    assert both.marks.earned == both.marks.of
    assert one.marks.earned < one.marks.of


@pytest.mark.parametrize(
    ("asked", "typed"),
    [
        ("energy_lost", "1/2*2*(64 - 4) = 60"),
        ("impulse", "2*8 + 2*2 = 20"),
        ("deflection(P)", "53.13 + 18.43 = 71.6"),
    ],
)
def test_a_value_without_a_name_answers(asked, typed):
    right = of_letters(UNNAMED + f"find {asked}", typed, {})
    assert right.marks.earned == right.marks.of
    other = of_letters(UNNAMED + f"find {asked}", "2*8 = 16", {})
    assert other.marks.earned < other.marks.of


def test_a_letter_for_a_component_gives_a_printed_speed():
    statement = LINE + "show speed(B) = 8/3"
    reply = of_letters(statement, "5*4 - 3*4 = 5v + 3w\nw - v = 8/3\n8w = 64/3\nw = 8/3")
    assert reply.marks.earned == reply.marks.of
    assert of_letters(statement, "w = 8/3").marks.earned == 0


def test_right_answers_earn_what_they_do_without_and_a_mistake_does_not():
    statement = (
        "sphere A: mass 2m, velocity u at alpha\nsphere B: mass 3m, at rest\n"
        "A hits B: along i\ngiven direction(A) = 90°\nfind e"
    )
    typed = "2m u cos α = 3 m w\nw = e u cos α\ne = 2/3"
    right = of_letters(statement, typed)
    assert right.marks.earned == right.marks.of
    wrong = of_letters(statement, typed.replace("e = 2/3", "e = 3/2"))
    assert wrong.marks.earned < wrong.marks.of


def test_a_condition_with_values_put_in_is_the_condition() -> None:
    statement = (
        "sphere A: mass m, velocity u at alpha\nsphere B: mass 3m, at rest\nA hits B: along i\n"
        "given velocity(A) perpendicular to velocity(A, 0)\nshow tan^2(alpha) = (3e - 1)/4\n"
    )
    lines = [
        "s = u sin(α)",
        "m u cos(α) = m p + 3m q",
        "q - p = e u cos(α)",
        "p = 1/4 (1 - 3e) u cos(α)",
        "1/4 (1 - 3e) u cos(α) (u cos(α)) + u sin(α) (u sin(α)) = 0",
        "tan^2(α) = (3e - 1)/4",
    ]
    letters = {
        "p": "along(velocity(A), i)",
        "q": "along(velocity(B), i)",
        "s": "along(velocity(A), j)",
    }
    marks = restitution.mark(solution(statement), lines, None, letters).marks
    assert marks.earned == marks.of
    without = restitution.mark(solution(statement), lines[:4] + lines[5:], None, letters).marks
    assert without.earned < without.of


def test_the_speed_may_go_out_of_both_laws_before_the_tangents() -> None:
    statement = (
        "wall W: along i\nsphere P: mass m, velocity u at theta to W\nP hits W\n"
        "let phi = angle(velocity(P), W)\nshow e = tan(phi)/tan(theta)\n"
    )
    lines = [
        "v cos φ = u cos θ",
        "v sin φ = e u sin θ",
        "u cos θ/cos φ × sin φ = e u sin θ",
        "cos θ tan φ = e sin θ",
        "e = tan φ/tan θ",
    ]
    letters = {"v": "speed(P)"}
    marks = restitution.mark(solution(statement), lines, None, letters).marks
    assert marks.earned == marks.of
    without = restitution.mark(solution(statement), [*lines[:2], lines[4]], None, letters).marks
    assert without.earned < without.of


def test_an_impulse_that_is_given_is_used_with_its_numbers_and_not_in_a_formula() -> None:
    statement = (
        "sphere A: mass 0.4, velocity 5i - 2j\nwall W: along 3i + 4j\nA hits W\n"
        "given impulse(A) = -2.4 i + 1.8 j\nfind velocity(A)\n"
    )
    letters = {"v": "velocity(A)"}

    def states(line: str) -> list[str]:
        points = restitution.mark(solution(statement), line, None, letters).marks.points
        return [each.state for each in points if each.point.principle == "impulse"]

    assert states("v - u = (-2.4i + 1.8j)/0.4")[:2] == ["earned", "earned"]
    assert set(states("I = m(v - u)")) == {"lost"}


def test_a_component_in_words_states_the_law_if_e_is_in_it() -> None:
    statement = (
        "wall W: along i\nsphere P: mass 2, velocity 5i - 12j\nP hits W\ngiven impulse = 36\nfind e"
    )

    def states(*lines: str) -> list[str]:
        points = restitution.mark(solution(statement), lines).marks.points
        return [each.state for each in points if each.point.principle == "restitution"]

    assert states("it rebounds at 12e", "36 = 2(12 - 12e)")[:2] == ["earned", "earned"]
    assert states("it rebounds at 6", "36 = 2(12 - 6)")[:2] != ["earned", "earned"]


def kinds_lost(statement: str, lines: list[str], letters: dict[str, str], part=None) -> list[str]:  # type: ignore[no-untyped-def]
    points = restitution.mark(solution(statement), lines, part, letters).marks.points
    return [f"{each.point.kind} {each.point.principle}" for each in points if each.state == "lost"]


def test_a_step_may_stand_in_the_line_of_a_law() -> None:
    lines = ["m u cos α = m v + 3m w", "w - v = e u cos α hence v = w - e u cos α"]
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    assert kinds_lost(SHOW, [*lines, "w = u(1 + e) cos α/4"], letters) == []
    apart = [*lines[:1], "w - v = e u cos α", "w = u(1 + e) cos α/4"]
    assert kinds_lost(SHOW, apart, letters) != []


def test_the_vector_along_which_a_wall_points_may_be_seen() -> None:
    statement = (
        "wall W\nsphere P: mass 2, velocity 3i - 5j\nP hits W\n"
        "given impulse(P) = -8i + 16j\nfind direction(W)\n"
    )
    assert kinds_lost(statement, ["normal is along -i + 2j", "wall along 2i + j"], {}) == []
    assert kinds_lost(statement, ["wall along 2i - j"], {}) != []


def test_an_angle_may_be_worked_out_to_another_line_first() -> None:
    statement = (
        "wall AB: along i\nwall BC: along 45°\nsphere P: mass m, velocity u at alpha to AB\n"
        "given tan(alpha) = 3/4\nP hits AB: e = 1/2\nfind angle(velocity(P), BC)\n"
    )
    lines = ["parallel to AB: 1/2(4u/5) = 2u/5", "perp: 3u/5", "angle to AB = tan^-1(3/2) = 56.3"]
    assert "M1 angle" not in kinds_lost(statement, lines, {})
    assert "M1 angle" in kinds_lost(statement, lines[:2], {})


OFFSET = (
    "sphere A: mass 2m, velocity u i, radius r\nsphere B: mass m, velocity -u i, radius r\n"
    "A hits B: offset 2 r sin(alpha)\nfind impulse in terms of m, u, e, alpha\n"
    "show speed(A)^2 = u^2 (sin^2(alpha) + (1 - 2e)^2 cos^2(alpha)/9)\n"
)
CENTRES = {"x": "along(velocity(A), line_of_centres)", "y": "along(velocity(B), line_of_centres)"}


def test_an_equation_shows_the_components_in_it_though_a_result_is_printed() -> None:
    lines = [
        "2mu cos α - mu cos α = 2mx + my",
        "y - x = e(2u cos α)",
        "3x = u cos α - 2eu cos α",
        "x = u cos α(1 - 2e)/3",
        "I = 2m(u cos α - x) = 4/3m(1 + e)u cos α",
        "V² = u² sin²α + u² cos²α(1 - 2e)²/9",
    ]
    assert kinds_lost(OFFSET, lines, {**CENTRES, "V": "speed(A)"}) == []


def test_a_law_may_have_values_of_his_own_in_it() -> None:
    statement = (
        "sphere A: mass m, velocity 2u at 30°\nsphere B: mass 2m, velocity u at 120°\n"
        "A hits B: along i\ngiven deflection(B) = 60°\nfind e\n"
    )
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    lines = ["w = u/2", "m(2u cos 30) + 2m(u cos 60) = mv + 2mw", "v = 1.73u"]
    lost = kinds_lost(statement, [*lines, "e = (0.5 - 1.73)/(1.73 + 0.5) = -0.552"], letters)
    assert not [each for each in lost if each.endswith("restitution")]
    alone = kinds_lost(statement, [*lines, "e = -0.552"], letters)
    assert "A1 restitution" in alone


def test_what_a_law_has_cost_follows_through_to_no_answer() -> None:
    statement = (
        "sphere A: mass 2, velocity 3i + 2j\nsphere B: mass 4, velocity -i + j\n"
        "A hits B: along i, e = 1/2\nfind speed(A), angle(velocity(A), i)\n"
    )
    first = [
        "6 + 4 = 2v + 4w",
        "w - v = 2",
        "6v = 2, v = 1/3",
        "speed of A = √(1/9 + 4) = √37/3",
    ]
    end = "tan θ = 2/(1/3) = 6, θ = 80.5°"
    letters = {**BOTH, "θ": "angle(velocity(A), i)"}
    lost = kinds_lost(statement, [*first, end], letters)
    assert [each for each in lost if each.startswith("A1ft")]
    assert len(lost) == 3  # the equation of momentum, and both answers
    # Behind a slip in solving the next answer follows.
    first = ["6 - 4 = 2v + 4w", "w - v = 2", "6v = -6, v = 1", "speed of A = √(1 + 4) = √5"]
    lost = kinds_lost(statement, [*first, "tan θ = 2, θ = 63.4°"], letters)
    assert [each for each in lost if each.startswith("A1ft")] == []
    # A law that loses its method is not followed through.
    first = ["6 - 4 = 2v + 4w", "w - v = 8", "6v = -30, v = -5", "speed of A = √(25 + 4) = √29"]
    lost = kinds_lost(statement, [*first, "tan θ = -2/5, θ = 158°"], letters)
    assert [each for each in lost if each.startswith("A1ft")]


def test_of_two_answers_that_follow_none_is_left_out() -> None:
    statement = (
        "sphere A: mass 2, velocity p i + 3j\nsphere B: mass 1, velocity -2i + q j\n"
        "A hits B: along i, e = 1/4\ngiven velocity(A) = 2i + 3j, speed(B) = 5 sqrt(2)\n"
        "find p, q\n"
    )
    lines = [
        "2p - 2 = 4 + w",
        "w - 2 = 1/4(p + 2)",
        "p = 4w - 6",
        "8w - 14 = 4 + w",
        "w = 18/7, p = 30/7",
        "w² + q² = 50",
        "q² = 43.4, q = ±6.59",
    ]
    lost = kinds_lost(statement, lines, {"w": "along(velocity(B), i)"})
    assert lost == ["A1 solve"]  # p alone


def test_a_velocity_after_a_wall_shows_the_law_of_restitution() -> None:
    statement = (
        "wall W1: along i\nwall W2: along j\nsphere P: velocity u at alpha to W1\n"
        "P hits W1: e = e1\nP hits W2: e = e2\n"
        "given velocity(P) opposite to velocity(P, 0)\nfind e2\n"
    )
    marking = restitution.mark(restitution.parse(statement), "after W1 (ucosα, e1usinα)")
    earned = [each.point.kind for each in marking.marks.points if each.state == "earned"]
    assert earned == ["B1", "B1"]


def test_an_angle_by_its_tangent_counts_where_the_scheme_has_a_scalar_product() -> None:
    statement = (
        "sphere A: mass 3, velocity 5i + 10j\nsphere B: mass 2, at rest\n"
        "A hits B: along 4i + 3j, e = 1/2\nfind velocity(A), velocity(B)\npart c\n"
        "find deflection(A)\n"
    )
    solution = restitution.solve(restitution.parse(statement))
    lines = "tan^-1(10/5) = 63.4\ntan^-1(6.4/0.2) = 88.2\nturned 88.2 + 63.4 = 151.6"
    assert restitution.mark(solution, lines, part="c").marks.earned == 1
    other = "tan^-1(10/7) = 55.0\ntan^-1(6.4/0.8) = 82.9\nturned 82.9 + 55.0 = 137.9"
    assert restitution.mark(solution, other, part="c").marks.earned == 0


LOST = """
wall W: along i
sphere P: mass 0.3, velocity 5 at alpha to W
given sin(alpha) = 4/5
P hits W: e = 1/4
find energy_lost/energy(0) as a percentage
"""


@pytest.mark.parametrize("typed", ["60%", "60.0%", "60", "0.6", "3/5"])
def test_a_percentage_is_right_in_percent_and_as_a_number(typed: str) -> None:
    marking = restitution.mark(restitution.parse(LOST), f"percentage lost = {typed}")
    assert marking.json()["lines"][0]["verdict"] == "true"
    assert marking.marks.earned == marking.marks.of >= 3


@pytest.mark.parametrize("typed", ["12.3%", "75%", "7%", "59.9%", "12.3"])
@pytest.mark.parametrize("name", ["percentage lost", "% lost"])
def test_a_wrong_percentage_earns_nothing(name: str, typed: str) -> None:
    """A percent sign makes a decimal no coarser; it stands wherever its column may be.

    Columns of the script are none of the templates that say what a mistake leads to.
    """
    marking = restitution.mark(restitution.parse(LOST), f"{name} = {typed}")
    (line,) = marking.json()["lines"]
    assert (line["verdict"], line["mistake"]["id"], marking.marks.earned) == ("false", None, 0)


TWO_PARTS = """
sphere A: mass 5, velocity 5 at alpha
sphere B: mass 1, velocity -3i
given tan(alpha) = 4/3
A hits B: along i, e = 1/3
part a
find speed(A)
part b
find speed(B)
"""
IN_PART_A = "15 {sign} 3 = 5v + w\nw - v = 2\nv = {v}\nspeed of A = {speed}"


@pytest.mark.parametrize(
    "typed",
    ["w = 4.67\nspeed of B = 4.67", "w = v + 2 = 14/3", "w = 14/3", "speed of B = 14/3"],
)
def test_what_is_wrong_in_one_part_follows_through_to_the_next(typed: str) -> None:
    before = IN_PART_A.format(sign="+", v="8/3", speed="4.81")
    marking = restitution.mark(
        restitution.parse(TWO_PARTS), f"(a)\n{before}\n(b)\n{typed}", part="b"
    )
    verdicts = {each["verdict"] for each in marking.json()["lines"]}
    assert verdicts <= {"follows", "remark"}
    assert marking.marks.earned == 2


def test_right_lines_of_two_parts_are_right() -> None:
    before = IN_PART_A.format(sign="-", v="5/3", speed="13/3")
    for part, earned in (("a", 9), ("b", 2)):
        text = f"(a)\n{before}\n(b)\nw = v + 2 = 11/3\nspeed of B = 11/3"
        marking = restitution.mark(restitution.parse(TWO_PARTS), text, part=part)
        assert {each["verdict"] for each in marking.json()["lines"]} <= {"true", "remark"}
        assert marking.marks.earned == earned


def test_lines_of_a_part_with_data_of_its_own_are_none_of_the_next() -> None:
    question = """
    wall W: along i
    sphere P: mass 1, velocity 4i - 3j
    P hits W: e = k
    part a
    given k = 1/2
    find speed(P)
    part b
    given k = 1/3
    find speed(P)
    """
    text = "(a)\nv = 1/2*3 = 1.5\nspeed = 4.27\n(b)\nv = 1/3*3 = 1\nspeed = sqrt(17)"
    marking = restitution.mark(restitution.parse(question), text, part="b")
    assert {each["verdict"] for each in marking.json()["lines"]} <= {"true", "remark"}


GIVEN = """
wall W: along j
sphere P: mass 0.15, velocity 40 at arccos(0.6)
P hits W
given impulse = 5.4
find e, speed(P)
"""


def test_an_impulse_written_with_e_shows_the_law_of_restitution() -> None:
    """So it does above a slip, and what follows from the slip has its marks."""
    lines = "I = 0.15*24(1+e) = 5.4\n3.6 + 3.6e = 5.4 -> e = 0.55\nspeed = √(13.2² + 32²) = 34.6"
    marks = restitution.mark(restitution.parse(GIVEN), lines).marks
    lost = [each.point.purpose for each in marks.points if each.state != "earned"]
    assert lost == ["correct answer"]  # e


BLOW = """
wall W: along i
sphere P: mass 2, at rest
P receives 6i - 8j
P hits W: e = 1/2
find velocity(P)
"""


def test_the_laws_of_a_wall_are_shown_by_a_velocity_that_follows_from_a_blow() -> None:
    marks = restitution.mark(
        restitution.parse(BLOW), "velocity after blow = 6i - 8j\nv after wall = 6i + 4j"
    ).marks
    earned = [each.point.principle for each in marks.points if each.state == "earned"]
    assert {"unchanged", "restitution"} <= set(earned)


RATIO = """
sphere A: mass 3m, velocity p i
sphere B: mass 2m, velocity -q i
A hits B: along i, e = 1/4
given velocity(A) = -1/2 velocity(A, 0)
find q/p, speed(B)/q
"""


def test_a_ratio_is_answered_by_one_quantity_in_terms_of_the_other() -> None:
    lines = "w - v = ¼(p + q)\n3p - 2q = 3v + 2w\nq = 2p\nw/q = 1/8"
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    marks = restitution.mark(restitution.parse(RATIO), lines, letters=letters).marks
    assert (marks.earned, marks.of) == (marks.of, marks.of)


EITHER = """
sphere P: mass 3m, velocity 2u i
sphere Q: mass 2m, velocity -u i
P hits Q: along i
given speed(P) = u/5
find e, velocity(Q)
"""


def test_two_solutions_may_be_given_by_components() -> None:
    lines = (
        "6u - 2u = 3a + 2b\nb - a = 3eu\n5a = 4u - 6eu\n"
        "a = u/5: 1 = 4 - 6e, e = 1/2, b = 1.7u\na = -u/5: -1 = 4 - 6e, e = 5/6, b = 2.3u"
    )
    letters = {"a": "along(velocity(P), i)", "b": "along(velocity(Q), i)"}
    marks = restitution.mark(restitution.parse(EITHER), lines, letters=letters).marks
    assert marks.earned == marks.of


REST = """
sphere A: mass m, velocity u at 60°
sphere B: mass 2m, at rest
A hits B: along i, e = 1/2
show velocity(A) perpendicular to i
find energy_lost/energy(0) as a percentage
"""


@pytest.mark.parametrize(("end", "state"), [("so A moves perp to i", "earned"), ("v = 0", "lost")])
def test_a_printed_direction_may_be_concluded_in_words(end: str, state: str) -> None:
    lines = f"½u = v + 2w\nw - v = ¼u\nw = ¼u, v = 0\n{end}"
    marks = restitution.mark(restitution.parse(REST), lines).marks
    (shown,) = [each for each in marks.points if each.point.shown]
    assert shown.state == state


def test_a_percentage_is_no_ratio_of_masses() -> None:
    lines = "½u = v + 2w\nw - v = ¼u\nw = ¼u, v = 0\n% = (1/16)/(1/8) = 50%"
    *_, last = restitution.mark(restitution.parse(REST), lines).json()["lines"]
    assert (last["verdict"], last["mistake"]["id"]) == ("false", "energy-fraction-of-line")


def test_the_mistake_of_an_earlier_part_has_its_line(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each part of a working is judged by itself once, whichever parts rest on it."""
    from restitution.practice.judging import earlier_parts
    from restitution.practice.marking.marking import mark_parts

    judged: list[str | None] = []
    plain = earlier_parts.judge

    def counted(solution, script, part=None, letters=None):  # type: ignore[no-untyped-def]
        judged.append(part)
        return plain(solution, script, part, letters)

    monkeypatch.setattr(earlier_parts, "judge", counted)
    lines = "(a)\n5*3 + 3 = 5v + w\nw - v = 2\nv = 8/3, w = 14/3\n(b)\nspeed of B = 14/3"
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    markings = mark_parts(restitution.parse(TWO_PARTS), lines, letters, hints=1)
    assert judged == ["a", "b", "b"]
    (message,) = [each.text for each in markings[1].messages if each.line == 6]
    assert message == "Right, with your values. The mistake is in line 2."


def states(statement: str, working: str, letters: dict[str, str] | None = None) -> list[str]:
    marking = restitution.mark(restitution.parse(statement), working, letters=letters or {})
    return [each["state"] for each in marking.json()["marks"]["points"]]


REVERSED = """
sphere A: mass m, velocity 4u i
sphere B: mass k m, velocity -u i
A hits B: along i, e = 1/5
given along(velocity(A), i) < 0
find range of k
"""


@pytest.mark.parametrize(("last", "state"), [("k < 2", "lost"), ("k > 2", "earned")])
def test_a_range_that_another_one_replaces_is_withdrawn(last: str, state: str) -> None:
    lines = "4u - ku = v + kw\nw - v = u\nv = 2u(2 - k)/(1 + k) < 0\n-k < -2\n" + last
    assert states(REVERSED, lines)[-1] == state


EXCHANGED = """
sphere S: mass m, velocity u at theta
sphere T: mass 2m, at rest
S hits T: along i
find along(velocity(S), i)
"""


@pytest.mark.parametrize(("momentum", "state"), [("cos", "lost"), ("sin", "earned")])
def test_sine_for_cosine_in_restitution_alone_is_no_method(momentum: str, state: str) -> None:
    letters = {"v": "along(velocity(S), i)", "w": "along(velocity(T), i)"}
    lines = f"mu{momentum}θ = mv + 2mw\nw - v = eusinθ"
    assert states(EXCHANGED, lines, letters)[2] == state


TANGENTS = """
wall W: along i
sphere S: mass m, velocity u at alpha to W
given tan(alpha) = 3/4
S hits W: e = 2/3
part a
find tan(angle(velocity(S), W))
part b
find deflection(S)
"""


def test_the_angles_of_a_wrong_deflection_have_a_method_of_their_own() -> None:
    for sign, points in (("-", "earned lost lost"), ("+", "earned earned")):
        value = "10.3" if sign == "-" else "63.4"
        lines = f"β = tan^-1(1/2) = 26.6\nα = 36.9\ndeflection = 36.9 {sign} 26.6 = {value}"
        marking = restitution.mark(restitution.parse(TANGENTS), lines, part="b")
        found = [each["state"] for each in marking.json()["marks"]["points"]]
        assert found == points.split()


def test_the_old_angle_at_a_second_wall_finds_none_for_it() -> None:
    corner = """
wall AB: along i
wall BC: along 60°
sphere P: velocity 12 at 45° to AB
P hits AB: e = 1/2
P hits BC: e = 2/3
find speed(P, 1), angle(velocity(P, 1), AB), speed(P)
"""
    lines = """vcosθ = 12cos45
vsinθ = ½(12sin45)
v² = 72 + 18 = 90 so v = 9.49
θ = 26.6
wcosφ = 9.49cos26.6 = 8.49
wsinφ = 2/3(9.49sin26.6) = 2.83
w = 8.94"""
    letters = {"v": "speed(P, 1)", "w": "speed(P)"}
    letters |= {"θ": "angle(velocity(P, 1), AB)", "φ": "angle(velocity(P), BC)"}
    *_, angle, _, _, _, speed, answer = states(corner, lines, letters)
    assert (angle, speed, answer) == ("lost", "lost", "lost")


def test_a_printed_comparison_is_one_of_the_values() -> None:
    pair = """
sphere A: mass 3m, velocity 4u i
sphere B: mass m, at rest
sphere C: mass 2m, at rest
A hits B: along i, e = 1/3
find velocity(A), velocity(B)
B hits C: along i, e = 1/2
part a
find velocity(B)
part b
show along(velocity(A), i) > along(velocity(B), i)
"""
    for line, state in (("8u/3 > 0 so A is faster", "earned"), ("8u/3 > u so A is faster", "lost")):
        marking = restitution.mark(restitution.parse(pair), line, part="b")
        assert [each.state for each in marking.marks.points][-1] == state


def test_the_square_of_a_component_after_a_wall_shows_newtons_law() -> None:
    wall = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
show energy(P)/energy(0) = cos^2(alpha) + e^2 sin^2(alpha)
"""
    for square, state in (("(eu sinα)²", "earned"), ("(u sinα)²", "lost")):
        lines = f"v² = (u cosα)² + {square}"
        assert states(wall, lines)[1] == state


@pytest.mark.parametrize(
    ("line", "state"),
    [
        ("KE_after/KE_before = v²/u² = cos²α + e²sin²α = 1/5 + 4e²/5", "earned"),
        ("KE_after/KE_before = (1 + 4e²)/5", "lost"),
    ],
)
def test_a_printed_ratio_may_be_worked_out_in_its_line(line: str, state: str) -> None:
    wall = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given tan(alpha) = 2
show energy(P)/energy(0) = (1 + 4 e^2)/5
"""
    assert states(wall, f"sinα = 2/√5, cosα = 1/√5\n{line}")[-1] == state


INVERTED = """
wall W
sphere P: mass 0.5, velocity 5i - 5j
P hits W
given velocity(P) = i + 3j
find e
"""


def test_components_below_which_a_law_is_upside_down_imply_no_law() -> None:
    lines = "n = (-i + 2j)/√5\nu.n = -15/√5, v.n = 5/√5\n"
    right, wrong = (states(INVERTED, lines + end) for end in ("e = 5/15", "e = 15/5 = 3"))
    assert right[-3:] == ["earned"] * 3
    assert wrong[-3:] == ["lost"] * 3


IMPULSE_AND_LOSS = """
sphere A: mass 3, velocity 3i + 5j
sphere B: mass 1, velocity -5i + 2j
A hits B: along i, e = 1/4
find impulse, energy_lost
"""


@pytest.mark.parametrize(
    ("last", "state"),
    [("I = 3(3 + 0.5) = 10.5", "lost"), ("I = 7.6", "earned"), ("I = 7.5 = 15", "earned")],
)
def test_an_answer_that_another_one_replaces_is_withdrawn(last: str, state: str) -> None:
    """A decimal of it that is a little wrong, and a chain from it, withdraw nothing."""
    lines = f"v = 0.5, w = 2.5\nI = 3(3 - 0.5) = 7.5\nloss = 22.5\n{last}"
    marking = restitution.mark(restitution.parse(IMPULSE_AND_LOSS), lines).json()
    impulse = [each for each in marking["marks"]["points"] if each["line"] in (2, 4)]
    assert impulse[-1]["state"] == state


IN_NUMBERS = """
sphere A: mass 4m, velocity 5u at alpha
sphere B: mass m, velocity 13u at beta from -i
given tan(alpha) = 4/3, tan(beta) = 12/5
A hits B: along i, e = 1/4
find speed(A)
"""


def test_what_follows_from_sine_for_cosine_in_both_laws_keeps_their_methods() -> None:
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    lines = "along loc: A 5usinα = 4u\n4m(4u) - m(12u) = 4mv + mw\nw - v = ¼(4u + 12u)"
    assert states(IN_NUMBERS, lines, letters)[2:6] == ["earned", "lost", "earned", "lost"]


STOPPED = """sphere A: mass m, velocity 4u i
sphere B: mass k m, velocity -u i
A hits B: along i
given velocity(A) = 0
part a
show k = 4/(1 + 5e)
part b
find range of k"""


@pytest.mark.parametrize(
    ("last", "states"),
    [
        ("2/3 <= k <= 4", ["earned", "earned"]),
        ("k >= 0.667 and k ≤ 4", ["earned", "earned"]),
        ("2/3 <= k <= 5", ["earned", "lost"]),  # true, and not the range
        ("k > 1/2, k <= 4", ["earned", "lost"]),
    ],
)
def test_a_range_has_its_own_ends(last: str, states: list[str]) -> None:
    marking = restitution.mark(restitution.solve(restitution.parse(STOPPED)), last, part="b")
    assert [point.state for point in marking.marks.points] == states


LINE_OF_THREE = """sphere A: mass m, velocity u i
sphere B: mass m, at rest
A hits B: along i
show velocity(B) = (1 + e) u/2 i"""


def test_each_relation_of_a_line_may_state_a_law() -> None:
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    line = "CoM: v+w=u, NEL: w-v=eu, add them up: 2w=u(1+e), so w=½(1+e)u"
    assert set(states(LINE_OF_THREE, line, letters)) == {"earned"}


STRUCK = """sphere A: mass 0.17, velocity 3.2 at 28°
sphere B: mass 0.17, at rest
A hits B: along i, e = 0.92
find speed(A), speed(B)"""


def test_a_root_behind_the_name_of_a_sphere_is_its_speed() -> None:
    working = """x + y = 2.825
    y - x = 0.92×2.825
    y = 2.712, x = 0.113
    A: √(0.113²+1.502²) = 1.51 m/s
    B: 2.71 m/s"""
    letters = {"x": "along(velocity(A), i)", "y": "along(velocity(B), i)"}
    assert set(states(STRUCK, working, letters)) == {"earned"}
    wrong = working.replace("0.113²+1.502²) = 1.51", "0.113²+2.825²) = 2.83")
    solution = restitution.solve(restitution.parse(STRUCK))
    verdicts = [line.verdict for line in restitution.mark(solution, wrong, letters=letters).lines]
    assert verdicts == ["true", "true", "true", "false", "true"]


WALL_OF_TIMES = """wall W: along i, through (0, 0)
sphere P: mass 1/2, velocity 4i - 3j, at (0, 3)
P hits W: e = 2/3
find time(1), energy_lost"""


def test_a_number_is_told_by_its_unit() -> None:
    kinds = states(
        WALL_OF_TIMES, "3/3 = 1 sec\nbefore ½×½×25 = 6.25, after ½×½×20 = 5, so 1.25J lost"
    )
    assert set(kinds) == {"earned"}
    solution = restitution.solve(restitution.parse(WALL_OF_TIMES))
    lines = restitution.mark(solution, "3/4 = 0.75 s\n5/4 = 1.6 s\nso 1.5J lost").lines
    assert [line.verdict for line in lines] == ["remark", "false", "false"]


def test_the_same_mistake_again_is_not_said_to_be_right() -> None:
    statement = """sphere A: mass m, velocity u at theta
    sphere B: mass 2m, at rest
    A hits B: along i, e = 1/5
    given tan(theta) = 3/4
    find speed(B)"""
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    solution = restitution.solve(restitution.parse(statement))
    working = "0.6u = v + 2w\nw - v = 0.2×0.6u\nw = 0.24u"
    marking = restitution.mark(solution, working, letters=letters, hints=1)
    assert [line.verdict for line in marking.lines] == ["false", "follows", "follows"]
    told = [message.text for message in marking.messages if message.line != 1]
    assert told == [
        "This has the mistake of line 1 once more.",
        "Right, with your values. The mistake is in line 1.",
    ]


SHARE_AT_A_WALL = """wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
show energy_lost/energy(0) = (1 - e^2) sin(alpha)^2"""


def test_what_is_divided_by_gives_the_printed_share() -> None:
    """What stood last is divided: ``÷ ½mu² gives …`` is an equation, and may be false."""
    loss = "u cos α stays, u sin α → eu sin α\n½mu² - ½m(u²cos²α + e²u²sin²α) = ½mu²(1-e²)sin²α\n"
    for words in ("÷ ½mu² gives", "divide by ½mu²:"):
        assert set(states(SHARE_AT_A_WALL, f"{loss}{words} (1-e²)sin²α")) == {"earned"}
        solution = restitution.solve(restitution.parse(SHARE_AT_A_WALL))
        lines = restitution.mark(solution, f"{loss}{words} (1-e²)cos²α").lines
        assert [line.verdict for line in lines] == ["remark", "true", "false"]


THREE_IN_LINE = """sphere A: mass m, velocity 6u i
sphere B: mass 2m, at rest
sphere C: mass m, at rest
A hits B: along i, e = 1/2
part a
find speed(A)
B hits C: along i, e = 1/3
part b
find speed(B), speed(C)
part c
show A and B do not collide again"""


@pytest.mark.parametrize(
    ("line", "state"),
    [
        ("A at rest, B goes right at 5u/3 so no more collisions", "earned"),
        ("C is faster than B so no more collisions", "lost"),
    ],
)
def test_a_conclusion_in_words_is_of_the_spheres_that_are_asked(line: str, state: str) -> None:
    solution = restitution.solve(restitution.parse(THREE_IN_LINE))
    marks = restitution.mark(solution, line, part="c").marks
    assert {point.state for point in marks.points} == {state}


BY_IMPULSE = """sphere A: mass 4, velocity 3i + j
sphere B: mass 2, velocity -i - j
A hits B: along i
given impulse = 10
find velocity(A), velocity(B)"""
ALONG_I = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}


def earned_of(statement: str, working: str, letters: dict[str, str] | None = None) -> int:
    solution = restitution.solve(restitution.parse(statement))
    return restitution.mark(solution, working, letters=letters or {}).marks.earned


def test_the_impulse_on_one_sphere_is_not_the_momentum_of_both() -> None:
    last = "\nA ½i + j, B 4i - j"
    both = "10 = 4(3 - v), v = ½\n10 = 2(w + 1), w = 4"
    assert earned_of(BY_IMPULSE, both + last, ALONG_I) == 7
    wrong = "10 = 4(v - 3), v = 5.5\n10 = 2(w + 1), w = 4\nvA = 5.5i + j, vB = 4i - j"
    assert earned_of(BY_IMPULSE, wrong, ALONG_I) == 5
    without = "10 = 3 - v, v = -7\n10 = 2(w + 1), w = 4\nvA = -7i + j, vB = 4i - j"
    assert earned_of(BY_IMPULSE, without, ALONG_I) == 4
    assert earned_of(BY_IMPULSE, "10 = 4(3 - v), v = ½", ALONG_I) == 2
    assert earned_of(BY_IMPULSE, "10 = 4(√10 - V)\nV = 0.662", {"V": "speed(A)"}) == 0


BY_CHANGE = """sphere A: mass 3, velocity 4i + 2j
sphere B: mass 5, velocity -i
A hits B
given velocity(A) = i - 2j
part a
find velocity(B)
part b
find e"""


def test_known_velocities_show_no_law_for_an_unknown_coefficient() -> None:
    solution = restitution.solve(restitution.parse(BY_CHANGE))
    relative = "uA - uB = 5i+2j, vB - vA = -0.2i + 4.4j\n"
    inverted = """loc ∥ 3i+4j
    approach = (5i+2j).(3i+4j)/5 = 23/5
    separation = (-0.2i+4.4j).(3i+4j)/5 = 17/5
    """
    marks = [
        restitution.mark(solution, working, part="b").marks.earned
        for working in (relative + "e = √19.4/√29 = 0.818", inverted + "e = 23/17 = 1.35")
    ]
    assert marks == [0, 6]
    assert restitution.mark(solution, inverted + "e = 17/23", part="b").marks.earned == 9


AT_RIGHT_ANGLES = """sphere A: mass m, velocity u at alpha
sphere B: mass 3m, at rest
A hits B: along i
part a
find along(velocity(A), i), along(velocity(B), i)
part b
given tan(alpha) = 1/2, velocity(A) perpendicular to velocity(A, 0)
find e"""


def test_what_follows_from_a_slip_that_is_forgiven_is_no_right_answer() -> None:
    solution = restitution.solve(restitution.parse(AT_RIGHT_ANGLES))
    working = "usinα/v = 2\n¼(1-3e)ucosα = ½usinα\n1-3e = 1, e = 0"
    letters = {"v": "along(velocity(A), i)"}
    marks = restitution.mark(solution, working, part="b", letters=letters).marks
    assert [point.state for point in marks.points] == ["earned", "earned", "lost"]


PRINTED = """sphere A: mass m, velocity u i
sphere B: mass k m, velocity -2u i
A hits B: along i, e = 1/2
show along(velocity(B), i) = (5 - 4k)u/(2(1 + k))"""


def test_a_printed_quotient_may_be_typed_without_brackets_below() -> None:
    working = "u - 2ku = v + kw\nw - v = 3u/2\nu - 2ku + 3u/2 = w(1+k)\nw = (5u - 4ku)/2(1+k)"
    assert earned_of(PRINTED, working, ALONG_I) == 6


ALONG_A_VECTOR = """wall W: along 4i + 3j
sphere P: mass 3, velocity 7i - j
P hits W: e = 2/5
find velocity(P)"""


def test_a_sign_in_one_part_of_a_velocity_keeps_the_method_of_adding_up() -> None:
    kinds = states(ALONG_A_VECTOR, "v = 4i+3j + 2(3i-4j)/5 = 5.2i + 1.4j")
    assert kinds == ["lost", "lost", "earned", "lost"]


ENERGY_ONLY = """sphere A: mass 4, velocity 3i + j
sphere B: mass 2, velocity -i - j
A hits B: along i, e = 7/8
find energy_lost"""


def test_the_energy_before_alone_is_no_method_for_what_is_lost() -> None:
    assert states(ENERGY_ONLY, "KE before = ½·4·10 + ½·2·2 = 22")[:1] == ["lost"]


def test_a_wrong_number_may_stand_beside_the_same_number_that_is_right() -> None:
    statement = """wall W: along i
    sphere P: mass m, velocity u at 60° to W
    P hits W
    given angle(velocity(P), W) = 45°
    find impulse"""
    solution = restitution.solve(restitution.parse(statement))
    working = "perp before: ucos60 = 0.5u\nperp after: 0.5u\nI = m(0.5u + 0.5u) = mu"
    verdicts = [line.verdict for line in restitution.mark(solution, working).lines]
    assert verdicts == ["false", "true", "follows"]


TAPPED = """wall W: along j
sphere P: mass 3, velocity 3i + 2j
P hits W: e = 1/3
find speed(P), energy_lost"""
SECOND = """sphere A: mass m, velocity 6u i
sphere B: mass 2m, at rest
sphere C: mass m, at rest
A hits B: along i, e = 1/2
part a
find speed(A), speed(B)
B hits C: along i, e = 1/3
part b
find speed(B), speed(C)"""


def test_what_follows_from_a_wrong_law_is_no_right_answer() -> None:
    working = "v after = -3i + ⅔j\nspeed √(9+4/9) = 3.07\nlost ½·3(13 - 9.44) = 5.33J"
    marks = restitution.mark(restitution.parse(TAPPED), working).marks
    # What is lost at a wall is its B1 alone: the loss of energy, A1ft, follows through.
    assert [p.state for p in marks.points if p.point.item is not None] == ["lost", "earned"]
    solution = restitution.solve(restitution.parse(SECOND))
    letters = {"b": "along(velocity(B), i)", "c": "along(velocity(C), i)"}
    working = "6u=2b+c\nc - b = ⅓·6u = 2u\n3b = 4u, b = 4u/3, c = 10u/3"
    assert restitution.mark(solution, working, part="b", letters=letters).marks.earned == 4


def test_a_right_value_beside_one_that_follows_is_right() -> None:
    working = "10 = 12 - 4v, v=0.5\n12 + 2 = 4(0.5) + 2w\nw = 6\nA: 0.5i+j; B: 6i - j"
    marks = restitution.mark(restitution.parse(BY_IMPULSE), working, letters=ALONG_I).marks
    assert [p.state for p in marks.points if p.point.item is not None] == ["earned", "lost"]


def test_a_root_behind_a_sphere_is_its_speed_where_it_is_wrong_too() -> None:
    statement = "sphere A: mass 2, velocity 4i + j\nsphere B: mass 5, velocity -3i + 2j\n"
    problem = restitution.parse(f"{statement}A hits B: along i, e = 3/5\nfind speed(A)")
    assert [x.verdict for x in restitution.mark(problem, "A √(2²+3²) = √13").lines] == ["false"]
    assert [x.verdict for x in restitution.mark(problem, "A √(4²+1²) = √17").lines] == ["true"]


EQUAL_PUSH = """
sphere A: mass m, velocity 3u i + u j
sphere B: mass 2m, velocity -u i + 2u j
A hits B: along i
given impulse = 4m u
find velocity(A), velocity(B)
"""
HALF_OFFSET = """
sphere A: mass m, velocity u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset 0.48 r, e = 1/2
find speed(A), speed(B)
"""


def test_a_wrong_angle_from_an_offset_has_no_method_and_the_laws_no_accuracy() -> None:
    line = "line_of_centres"
    letters = {"v": f"along(velocity(A), {line})", "w": f"along(velocity(B), {line})"}
    working = """sin θ = 0.48r/r = 0.48, cos θ = 0.877
v + w = 0.877u
w - v = 0.4386u
w = 0.658u, v = 0.219u
speed of A = √(0.219² + 0.48²) u = 0.528u"""
    marking = restitution.mark(restitution.parse(HALF_OFFSET), working, letters=letters)
    assert marking.json()["lines"][0]["verdict"] == "false"
    assert marking.mistakes == ()
    states = {(p.point.letter, p.point.principle): p.state for p in marking.marks.points}
    assert states["M", "fact"] == "lost"
    assert states["M", "restitution"] == "earned"
    assert states["A", "restitution"] == "lost"


RESTING = """
sphere A: mass 3m, velocity 5u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/2
given tan(alpha) = 3/4
part a
find speed(A), speed(B)
part b
find deflection(A)
"""


def test_speeds_behind_the_names_of_their_bodies_are_answers() -> None:
    solution = restitution.solve(restitution.parse(RESTING))
    laws = "12u = 3v + w\nw - v = 2u\nv = 2.5u, w = 4.5u\n"
    for last, earned in (("A 3.91u, B 4.5u", 10), ("A 3.95u, B 4.5u", 7)):
        marks = restitution.mark(solution, laws + last, part="a", letters=BOTH).marks
        assert marks.earned == earned, last


def test_the_angles_of_a_deflection_are_its_first_method() -> None:
    solution = restitution.solve(restitution.parse(RESTING))
    for working, earned in (
        ("angles with the line 36.87 and 50.19\ndeflection = 87.1°", 1),
        ("36.87 + 50.19 = 87.1°", 1),
        ("deflection = 87.1°", 0),
    ):
        assert restitution.mark(solution, working, part="b").marks.earned == earned, working


def test_a_mistake_that_is_named_tells_its_id_once():
    shown = restitution.mark(restitution.parse(MISTAKES), "v cos b = 17cos a\nv sin b = 8", hints=3)
    assert str(shown).count("Mistake: restitution-omitted.") == 1
    shown = restitution.mark(restitution.parse(MISTAKES), "v cos b = 17cos a\nv sin b = 8", hints=2)
    assert "restitution-omitted" not in str(shown)


@pytest.mark.parametrize(
    "typed",
    [
        "w = 2\nw = sqrt(4 - 9)",
        "deflection = 42.3\ndeflection = arccos(34/26)",
        "w = sqrt(-1) i + 2j\nw = 3i",
        "speed = 5\nspeed = 1/0",
    ],
)
def test_a_value_that_is_no_number_is_false_and_the_rest_is_marked(typed):
    ball = "wall W: along i\nsphere P: velocity 12i - 5j\nP hits W: e = 1/3\nfind deflection(P)"
    (*_, last) = restitution.mark(solution(ball), f"{typed}\nv = 12i + 5/3 j").lines
    assert last.verdict == "true"


def test_a_question_that_asks_nothing_is_not_marked():
    asks_nothing = "wall W: along i\nsphere P: velocity 5i - 3j\nP hits W: e = 1/2"
    with pytest.raises(restitution.MissingError, match="find velocity"):
        restitution.mark(restitution.parse(asks_nothing), "v = 5i")


@pytest.mark.parametrize(
    ("wall", "told"), [("i", "away from W after = 2√3"), ("j", "towards W after = −2√3")]
)
def test_hints_speak_of_no_unit_vectors_where_the_question_has_none(wall: str, told: str) -> None:
    statement = (
        f"wall W: along {wall}\nsphere P: mass 2, velocity 8 at 60° to W\nP hits W: e = 1/2\n"
        "find speed(P)\n"
    )
    for line, hint in (("nothing yet", "parallel to W after = 4"), ("v = 4", told)):
        (message,) = restitution.mark(solution(statement), line, hints=4).messages
        assert message.text == f"The next line is component of P {hint}."
