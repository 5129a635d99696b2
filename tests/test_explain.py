"""Worked solutions: nothing fails, every answer is reached, and they read as they should."""

from __future__ import annotations

import re

import pytest
from laws_of_explanations import marks_of

from restitution.language import parse
from restitution.render.latex import words
from restitution.solving import solve
from restitution.workings import Explanation, explain, to_html, to_latex, to_markdown, to_text


def told(text: str) -> Explanation:
    return explain(solve(parse(text)))


# --- what a good solution says --------------------------------------------------------------------

SPHERES = """
sphere A: mass 2, velocity 3i - 4j
sphere B: mass 3, velocity 2i + 3j
A hits B: along j, e = 3/7
find velocity(A), velocity(B), impulse
"""

SPHERES_TOLD = """\
Let 𝐯_A and 𝐯_B be the velocities of A and B after the impact. Let v and w be
the components of the velocities of A and B along the line of centres, in the
direction of 𝐣, after the impact.
Perpendicular to the line of centres the velocities do not change: the
components in the direction of 𝐢 stay 3 m s⁻¹ for A and 2 m s⁻¹ for B.        B1
Conservation of momentum along the line of centres:
    2(−4) + 3 × 3 = 2v + 3w   (1)                                          M1 A1
Newton's experimental law:
    v − w = (3/7)(3 + 4)   (2)                                             M1 A1
Eliminating w from (1) and (2):
    v = 2 m s⁻¹                                                              DM1
The velocity, from its components:
    𝐯_A = (3𝐢 + 2𝐣) m s⁻¹                                                     A1
Substituting for v in (2):
    w = −1 m s⁻¹
The velocity, from its components:
    𝐯_B = (2𝐢 − 𝐣) m s⁻¹                                                      A1
Impulse = change of momentum of A along the line of centres:
    magnitude of the impulse = 2(2 + 4) = 12 N s                         M1 A1ft"""


def test_two_spheres_with_vectors() -> None:
    assert to_text(told(SPHERES)) == SPHERES_TOLD


WALL = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
find impulse, energy_lost
"""

WALL_TOLD = """\
Let 𝐯_P be the velocity of P after the impact.
Newton's experimental law:
    component of 𝐯_P away from W = eu sin α                                   B1
Impulse = change of momentum of P perpendicular to W:
    magnitude of the impulse = m(eu sin α + u sin α) = (1 + e)mu sin α     M1 A1
Kinetic energy lost, by the component that changes:
    kinetic energy lost = ½m((u sin α)² − (eu sin α)²)
                        = ½mu²(1 − e²) sin²α                             M1 A1ft"""


def test_a_wall_in_letters() -> None:
    assert to_text(told(WALL)) == WALL_TOLD


TWO_ROOTS = """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: at rest
A hits B: along i, e = 1/2
given deflection(A) = arctan(3/5)
find alpha
"""


def test_several_solutions_from_one_equation() -> None:
    text = to_text(told(TWO_ROOTS))
    flat = " ".join(text.split())
    assert "4 tan²α − 5 tan α + 1 = 0 (4 tan α − 1)(tan α − 1) = 0" in flat
    assert "tan α = 1 or tan α = ¼" in flat
    assert text.count("Conservation of momentum") == 1
    assert text.index("If tan α = 1:") < text.index("α = 45°")
    assert text.index("If tan α = ¼:") < text.index("α = arctan(1/4)")


def test_what_one_case_makes_use_of_stands_in_it() -> None:
    """The speed in letters stood below the first case, and served the second one only."""
    statement = TWO_ROOTS.replace("1/2", "1/3").replace("3/5", "1/2")
    text = to_text(told(statement.replace("find alpha", "find tan(alpha), speed(A)")))
    case = text.partition("If tan α = ⅓:")[2]
    assert "√((⅓u cos α)² + (u sin α)²)\nSubstituting for sin²α and cos²α:\n" in case
    assert text.count("√((⅓u cos α)²") == 1


def test_a_rejected_root_is_told_with_its_reason() -> None:
    text = to_text(
        told(
            "sphere A: mass M, velocity 6 at 30°\nsphere B: mass 2, at rest\n"
            "A hits B: along i\ngiven speed(A) = sqrt(12), speed(B) = 3 sqrt(3)\nfind M, e"
        )
    )
    flat = " ".join(text.split())
    assert flat.index("v = ±√3 (1)") < flat.index("v = √3 m s⁻¹, as ")
    assert "B was at rest, so it moves along the line of centres: w = 3√3 m s⁻¹" in flat
    assert "v = √3 m s⁻¹, as v = −√3 would give e = 4/3 by (3), but e ≤ 1" in flat


def test_what_is_given_comes_before_what_follows() -> None:
    """The given velocity in momentum, w from it, e from Newton's law: one unknown at a time."""
    text = to_text(
        told(
            "sphere A: mass 2, velocity 3i - 4j\nsphere B: mass 3, velocity 2i + 3j\n"
            "A hits B: along j\ngiven velocity(A) = 3i + 2j\nfind e"
        )
    )
    order = [text.index(each) for each in ("2 × 2 + 3w", "w = −1", "e = 3/7")]
    assert order == sorted(order)
    assert "Eliminating" not in text


def test_no_idle_lines() -> None:
    text = to_text(told(SPHERES.replace("find velocity(A), velocity(B), impulse", "find impulse")))
    assert "do not change" not in text
    assert ("    v = " in text) != ("    w = " in text)  # one component is enough


def test_later_parts_use_earlier_results() -> None:
    text = to_text(
        told(
            "sphere P: mass 3m, at rest\nsphere Q: mass m, velocity u at theta\n"
            "Q hits P: along i\ngiven velocity(P) perpendicular to velocity(Q)\n"
            "part a\nfind e\npart b\ngiven energy_lost = 1/6 energy(0)\nfind theta"
        )
    )
    first, second = text.split("(b)")
    assert "Conservation of momentum" in first
    assert "with w from part (a):" in second
    assert "Conservation of momentum" not in second
    assert "w = ⅓u cos θ" not in second  # the value of part (a) is put in at once
    assert "3m(⅓u cos θ)²" in second
    assert "cos²θ = ¼" in second


def test_show_ends_with_the_printed_result() -> None:
    text = to_text(
        told(
            WALL.replace(
                "find impulse, energy_lost",
                "show speed(P) = u sqrt(cos^2(alpha) + e^2 sin^2(alpha))",
            )
        )
    )
    lines = [line.strip() for line in text.splitlines()]
    assert "(as required)" in " ".join(lines[-2:])
    assert "A1*" in " ".join(lines[-2:])


def test_false_claims_are_refuted_not_shown() -> None:
    text = to_text(told(WALL.replace("find impulse, energy_lost", "show speed(P) = e u")))
    assert "The speed of P is not eu in general: it is" in " ".join(text.split())
    assert "A1*" not in text


def test_an_item_without_an_answer_says_why() -> None:
    text = to_text(
        told(
            "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W: e = 1/2\nfind impulse, speed(P)"
        )
    )
    assert "cannot be found" in text
    assert "√13" in text


def test_letters_of_the_problem_are_not_used_again() -> None:
    text = to_text(
        told(
            "sphere A: mass w, velocity v i\nsphere B: mass x, at rest\n"
            "A hits B: along i\nfind velocity(B)"
        )
    )
    (first, second) = re.findall(r"Let (\w) and (\w) be the components", text)[0]
    assert not {first, second} & {"v", "w", "x", "A", "B"}


def test_a_component_named_in_the_statement_keeps_its_name() -> None:
    text = to_text(
        told(
            "sphere A: mass m, velocity u i\nsphere B: mass m, at rest\nA hits B: along i\n"
            "let p = along(velocity(A), i)\nfind p"
        )
    )
    assert "Let v be the component of the velocity of B" in text
    assert "mu = mp + mv" in text
    assert "p = (1 − e)u/2" in text


def test_ranges_name_the_condition_that_bounds() -> None:
    text = to_text(
        told(
            "sphere A, B: mass m\nsphere C: mass k m\nsphere A: velocity u i\n"
            "sphere B, C: at rest\nA hits B: along i, e = 1/2\nB hits C: along i, e = 1/2\n"
            "given A and B collide again\nfind range of k"
        )
    )
    assert "u/4 > 3(2 − k)u/(8(1 + k))" in text
    assert text.count("k > ⅘") == 1


def test_a_difference_of_angles_is_told_by_its_tangent() -> None:
    text = to_text(
        told(
            "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W: e = 1/3\n"
            "let beta = angle(velocity(P), W)\ngiven alpha - beta = arctan(1/2)\nfind tan(alpha)"
        )
    )
    assert "tan β = ⅓u sin α/(u cos α) = ⅓ tan α" in text
    assert "(tan α − tan β)/(1 + tan α tan β) = ½" in text
    assert "tan²α − 4 tan α + 3 = 0" in text
    assert "tan α = 3 or tan α = 1" in text


def test_the_ends_of_a_range_of_angles_are_those_of_the_angle_itself() -> None:
    """The tangent changes sign on the way: arctan of it would be half a turn off at one end."""
    text = to_text(
        told(
            "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\n"
            "find range of deflection(P) in terms of alpha"
        )
    )
    assert "α ≤ δ ≤ 2α" in " ".join(text.split())


def test_an_inequality_of_letters_is_told_with_the_condition_behind_it() -> None:
    text = to_text(
        told(
            "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\n"
            "given deflection(P) = 90°\nunknown e\nshow alpha >= 45°"
        )
    )
    flat = " ".join(text.split())
    lines = ("tan²α = 1/e", "tan²α ≥ 1, as e ≤ 1", "tan α ≥ 1, as α is acute", "α ≥ 45°")
    assert "(as required)" in flat
    places = [flat.index(line) for line in lines]
    assert places == sorted(places)


def test_an_extremum_has_a_bound_and_the_place_where_it_is_reached() -> None:
    text = to_text(
        told(
            "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\n"
            "sphere C: mass 4m, at rest\nA hits B: along i\nB hits C: along i\n"
            "find maximum of speed(C) over k"
        )
    )
    bound, place = (text.index(each) for each in ("≤ (1 + e)²u/9", "so k = 2"))
    assert bound < place
    assert "greatest speed of C = (1 + e)²u/9" in text


# --- marks ----------------------------------------------------------------------------------------


def told_marks(text: str) -> list[str]:
    (part,) = told(text).parts
    return marks_of(part)


def test_marks_of_two_spheres() -> None:
    """Unchanged; momentum; restitution; solving; an answer each; the impulse follows from them."""
    laws = ["B1"] + ["M1", "A1"] * 2 + ["DM1"]
    assert told_marks(SPHERES) == [*laws, "A1", "A1", "M1", "A1ft"]


def test_marks_of_a_wall() -> None:
    text = WALL.replace("find impulse, energy_lost", "find speed(P)")
    assert told_marks(text) == ["B1", "B1", "M1", "A1"]


def test_marks_follow_through_at_a_second_impact() -> None:
    marks = told_marks(
        "wall V: along i\nwall W: along j\nsphere P: velocity 4i - 2j\n"
        "P hits V: e = 1/2\nP hits W: e = 1/3\nfind velocity(P), velocity(P, 1)"
    )
    # Both components at each wall, and each velocity below its own.
    assert marks == ["B1", "B1", "B1ft", "B1", "B1", "B1"]
    marks = told_marks(
        "sphere A, B, C: mass m\nsphere A: velocity u i\nsphere B, C: at rest\n"
        "A hits B: along i, e = 1/2\nB hits C: along i, e = 1/2\nfind velocity(C)"
    )
    laws = ["M1", "A1", "M1", "A1", "DM1", "A1"]
    assert marks == [*laws, *laws]


def test_marks_of_a_result_that_is_printed() -> None:
    text = WALL.replace(
        "find impulse, energy_lost", "show energy_lost = m u^2 (1-e^2) sin^2(alpha)/2"
    )
    assert told_marks(text)[-2:] == ["M1", "A1*"]


def test_a_part_follows_through_from_another() -> None:
    explanation = told(SPHERES + "part b\nfind energy_lost")
    first, second = explanation.parts
    assert (first.marks, second.marks) == (10, 2)
    assert first.item_marks == (7, 1, 2)
    assert marks_of(second) == ["M1", "A1ft"]
    assert explanation.marks == 12


def test_a_second_solution_adds_its_answer_only() -> None:
    marks = told_marks(TWO_ROOTS.replace("find alpha", "find speed(A)"))
    assert marks[-1] == "A1"
    # Solving, the turn with its tangent, the roots: once each.
    assert marks.count("DM1") == 3
    assert marks.count("A1") == 2 + 2 + 2


def test_what_needs_no_method_is_independent() -> None:
    assert told_marks("sphere A: mass 3, velocity 2i\nfind mass(A)") == ["B1"]


# --- the value ------------------------------------------------------------------------------------


def test_one_part_of_several() -> None:
    solution = solve(parse(SPHERES + "part b\nfind deflection(A)"))
    assert [p.label for p in explain(solution).parts] == [None, "b"]
    assert [p.label for p in explain(solution, "b").parts] == ["b"]
    assert solution.chosen(None) == [solution.parts[None], solution.parts["b"]]
    assert solution.chosen("b") == [solution.parts["b"]]
    with pytest.raises(KeyError, match="parts"):
        explain(solution, "c")


def test_an_explanation_is_immutable_and_shows_itself() -> None:
    explanation = told(SPHERES)
    with pytest.raises(AttributeError):
        explanation.title = "x"  # type: ignore[misc]
    assert str(explanation) == repr(explanation) == to_text(explanation)
    assert "<math" in explanation._repr_html_()
    assert "$$" in explanation._repr_markdown_()
    assert r"\begin{align*}" in explanation._repr_latex_()
    assert explanation == told(SPHERES)


def test_text_never_comes_through_as_markup() -> None:
    explanation = told("title <script>x</script> & $y$ 100%\n" + SPHERES.strip())
    assert "<script>" not in to_html(explanation)
    assert r"\$y\$ 100\%" in to_latex(explanation)
    assert r"\<script\>" in to_markdown(explanation)


def test_a_page_is_self_contained() -> None:
    page = to_html(told(SPHERES))
    assert page.startswith("<!DOCTYPE html>")
    assert "http" not in page
    assert "<script" not in page
    assert "prefers-color-scheme: dark" in page
    assert "@media print" in page


# --- LaTeX and HTML -------------------------------------------------------------------------------

# What LaTeX itself, amsmath and the few packages of the preamble define, among what is used.


def test_formulas_among_words_are_mathematics_in_latex() -> None:
    explanation = told(
        "wall W: along i\nsphere P: velocity 10 at 30° to W\nP hits W\n"
        "given angle(velocity(P), W) = 45°\nfind e"
    )
    source = to_latex(explanation)
    assert r"$e = \sqrt{3}$ is impossible" in source
    assert "√" not in source
    assert words("√3 or ½ m\u00a0s⁻¹, α_1") == r"$\surd$3 or $\tfrac{1}{2}$ m~s$^{-1}$, $\alpha$\_1"


def test_opposite_roots_are_mathematics_in_latex() -> None:
    source = to_latex(
        told(
            "sphere A: mass M, velocity 6 at 30°\nsphere B: mass 2, at rest\n"
            "A hits B: along i\ngiven speed(A) = sqrt(12), speed(B) = 3 sqrt(3)\nfind M, e"
        )
    )
    assert r"v &= \pm{}\sqrt{3}" in source
    assert "±" not in source


def test_long_sums_of_a_page_can_be_broken() -> None:
    """So that a narrow screen shows the whole line; short ones stay in one piece."""
    page = to_html(told(SPHERES.replace("find", "find energy_lost,")))
    assert page.count("<math") == page.count("</math>")
    short = to_html(told(WALL.replace("find impulse, energy_lost", "find impulse")))
    within = '<wbr><math><mo form="infix">'
    assert within in page and within not in short


def test_styled_text_differs_from_plain_text_in_type_only() -> None:
    explanation = told("title A **j** of a question\n" + SPHERES.strip() + "\npart b\nfind impulse")
    plain, styled = to_text(explanation), to_text(explanation, styled=True)
    assert "\x1b" not in plain
    assert "\x1b[1mj\x1b[0m" in styled
    assert "\x1b[1m(b)\x1b[0m" in styled
    assert "𝐣" not in styled
    without = re.sub(r"\x1b\[\d*m", "", styled)
    assert without == plain.replace("𝐢", "i").replace("𝐣", "j").replace("𝐯", "v")


LINE = """
sphere A: mass 3m, at rest
sphere B: mass m, velocity u i
sphere C: mass 3m, at rest
B hits C: along i, e = 2/3
B hits A: along i, e = 2/3
"""


@pytest.mark.parametrize(
    ("statement", "said"),
    [
        (LINE + "show B and C collide again", "So B and C will not collide again, and the claim"),
        ("sphere A: mass 50, velocity 3 i\nshow speed(A) + 1 < 2", "It is not true that"),
        (LINE + "show B at rest", "B is not at rest: 𝐯_B = (u/16)𝐢"),
        (LINE + "show speed(C) = 0.5u to 1 s.f.", "The speed of C is not 0.5u: it is 0.4u."),
        (LINE + "show speed(C) = u", "The speed of C is not u: it is 5u/12."),
        (
            WALL.replace("find impulse, energy_lost", "show 2 speed(P) = e u"),
            "It is not true that ",
        ),
        (LINE + "show velocity(B) in the direction of velocity(A)", "𝐯_B is not in the direction"),
    ],
)
def test_a_false_claim_is_answered_in_words(statement: str, said: str) -> None:
    text = " ".join(to_text(told(statement)).split())
    assert said in text
    assert "is false" not in text and " = 1/20 it does not" not in text
