"""Mistakes in the terminal and in the browser: what is printed, played and said of them."""

from __future__ import annotations

import json

import pytest
from commands import run
from pages import minding

import restitution as r
from restitution.errors import StatementError, UnsupportedError
from restitution.explaining.mistakes.listing import about_mistake, all_mistakes
from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS, SLIPS
from restitution.export.player.beside import of_mistake

WALL = """\
title A ball and a wall
wall W: along i
sphere P: mass 2, velocity 3i - 4j
P hits W: e = 1/2
find velocity(P), deflection(P)
"""
SPHERES = """\
sphere A: mass 2, velocity 3i + 2j
sphere B: mass 1, velocity -4i + j
A hits B: along i, e = 1/2
find velocity(A), energy_lost
"""
TWO_WALLS = """\
wall AB: along i
wall BC: along 60°
sphere P: velocity u at 60° to AB
P hits AB: e = 1/2
P hits BC: e = 1/2
find speed(P)
"""


def command(*arguments, text=WALL):
    return run(*arguments, stdin=text.encode())


# --- the terminal ---------------------------------------------------------------------------------


def test_answers_are_labelled_and_stand_beside_the_true_ones():
    status, out, err = command("solve", "-", "--as", "restitution-inverted")
    assert (status, err) == (0, "")
    lines = out.splitlines()
    assert lines[0] == "A ball and a wall"
    assert "These are answers in an altered world, and not of the question." in lines
    (line,) = [each for each in lines if each.lstrip().startswith("velocity(P)")]
    assert "= 3𝐢 + 8𝐣 m s⁻¹" in line
    assert line.rstrip().endswith("not 3𝐢 + 2𝐣 m s⁻¹")


def test_every_variant_that_changes_an_answer():
    _, out, _ = command("solve", "-", "--as", "momentum-sign", text=SPHERES)
    for number in range(1, 8):
        assert f"momentum-sign/{number}" in out or f", /{number}" in out
    _, one, _ = command("solve", "-", "--as", "momentum-sign/2", text=SPHERES)
    assert "momentum-sign/2" in one
    assert "momentum-sign/3" not in one
    assert "(13/6)𝐢" in one


def test_a_result_alone():
    _, out, _ = command("solve", "-", "--as", "deflection-is-after/1")
    assert "deflection(P) = arctan(⅔) = 33.7°" in out or "arctan(2/3) = 33.7°" in out
    assert "velocity" not in out


def test_as_data():
    status, out, _ = command("solve", "-", "--as", "restitution-parallel", "--format", "json")
    content = json.loads(out)
    assert status == 0
    assert content["parts"][0]["items"][0]["answers"][0]["exact"] == ["3", "2"]
    told = content["as"]
    assert told["id"] == "restitution-parallel"
    assert [world["id"] for world in told["worlds"]] == [
        f"restitution-parallel/{n}" for n in (1, 2, 3)
    ]
    item = told["worlds"][0]["items"][0]
    assert (item["text"], item["answers"][0]["exact"]) == ("velocity(P)", ["3/2", "4"])


@pytest.mark.parametrize(
    ("arguments", "status", "message"),
    [
        (("--as", "restitution-paralel"), 2, "did you mean restitution-parallel?"),
        (("--as", "momentum-sign/8"), 2, "momentum-sign/1 to momentum-sign/7"),
        (
            ("--as", "momentum-sign"),
            1,
            "there is no impact of two spheres; these apply: deflection",
        ),
        (("--as", "rounding-early"), 1, "has no world of its own"),
        (("--as", "second-wall-angle"), 1, "no sphere goes from one wall to another"),
        (("--as", "speed-for-component/20"), 1, "lines of working"),
        (("--as", "impulse-sign", "--format", "html"), 2, "written as text or json"),
    ],
)
def test_what_cannot_be_is_an_error(arguments, status, message):
    code, out, err = command("solve", "-", *arguments)
    assert (code, out) == (status, "")
    assert message in " ".join(err.replace("│", " ").split())


def test_an_error_is_data_too():
    status, out, _ = command("solve", "-", "--as", "momentum-sign", "-f", "json")
    assert status == 1
    assert "these apply" in json.loads(out)["error"]["message"]


def test_the_list_fits_a_terminal():
    status, out, _ = run("mistakes")
    assert status == 0
    assert all(len(line) <= 80 for line in all_mistakes(80).splitlines())
    for name in (*MISCONCEPTIONS, *SLIPS):
        assert f"\n{name} " in f"\n{out}"


@pytest.mark.parametrize("name", MISCONCEPTIONS)
def test_one_mistake_fits_a_terminal(name):
    text = about_mistake(name)
    assert all(len(line) <= 80 for line in text.splitlines())
    assert MISCONCEPTIONS[name].line in text
    for each in MISCONCEPTIONS[name].variants:
        assert each.id in text


def test_of_one_mistake_and_of_none():
    assert "its variants" not in run("mistakes", "momentum-sign/2")[1]
    status, out, err = run("mistakes", "momentum-sing")
    assert (status, out) == (2, "")
    assert "did you mean momentum-sign?" in err
    assert "It is a slip" in run("mistakes", "sign")[1]


OUTSIDE = "though nothing acts from outside."


# --- what is wrong with a motion ------------------------------------------------------------------


def says(text, mistake):
    (motion,) = of_mistake(r.solve(r.parse(text)), mistake)["motions"]
    return motion["beside"]["says"]


def test_sentences_come_from_numbers():
    assert says(WALL, "restitution-parallel/2")[0] == "P goes through W."
    assert says(WALL, "restitution-inverted/1")[0] == (
        "W speeds P up, from 5 to 8.54: energy from nothing."
    )
    assert says(SPHERES, "momentum-sign/2")[:2] == [
        "The kinetic energy grows from 21.5 to 25.2: energy from nothing.",
        f"The momentum along the line of centres changes from 2 to 10, {OUTSIDE}",
    ]
    assert "A and B pass through each other." in says(SPHERES, "restitution-sign/5")
    assert says(WALL, "across-changed/2") == [
        "The component of P parallel to W changes, though nothing pushes it that way."
    ]
    assert says(WALL, "restitution-omitted/1") == [
        "P rebounds at 4, and e times the approach is 2."
    ]


@pytest.mark.parametrize("text", [WALL, SPHERES, TWO_WALLS])
def test_every_altered_motion_has_something_wrong_with_it(text):
    solution = r.solve(r.parse(text))
    shown = 0
    for row in MISCONCEPTIONS.values():
        for each in row.variants:
            if not (each.laws and each.solvable):
                continue
            try:
                data = of_mistake(solution, each.id)
            except UnsupportedError:
                continue
            for motion in data["motions"]:
                beside = motion["beside"]
                same = beside["motion"]["spheres"] == motion["spheres"]
                assert same or beside["says"], each.id
                assert (motion["start"], motion["end"]) == (
                    beside["motion"]["start"],
                    beside["motion"]["end"],
                )
                shown += 1
    assert shown > 8


def test_a_motion_of_a_result_cannot_be_played():
    with pytest.raises(UnsupportedError, match="result and not the motion"):
        r.play(r.solve(r.parse(WALL)), as_="deflection-is-after")
    with pytest.raises(StatementError, match="no mistake 'x'"):
        r.play(r.solve(r.parse(WALL)), as_="x")


# --- the browser ----------------------------------------------------------------------------------


@pytest.fixture
def opened(page, tmp_path):
    page.emulate_media(reduced_motion="reduce")
    file = tmp_path / "motion.html"
    status, _, err = run("play", "-", "--as", "momentum-sign/2", "-o", file, stdin=SPHERES.encode())
    assert status == 0, err
    with minding(page, file.as_uri()):
        page.goto(file.as_uri())
        page.wait_for_selector(".restitution-player .beside .stage circle")
        yield page


def test_both_motions_are_seen_and_told(opened):
    assert opened.locator(".stage").count() == 2
    assert "With the mistake momentum-sign/2" in opened.locator(".beside .label").inner_text()
    assert opened.locator(".says li").count() == 2
    assert "The true motion" in opened.locator(".both .first .label").inner_text()


def test_one_clock_moves_both(opened):
    def places():
        stages = opened.locator(".stage")
        return [stages.nth(n).locator("circle").first.bounding_box()["x"] for n in (0, 1)]

    start = places()
    opened.keyboard.press("End")
    end = places()
    left = opened.locator(".stage").nth(1).bounding_box()["x"]
    left -= opened.locator(".stage").nth(0).bounding_box()["x"]
    assert start[1] - start[0] == pytest.approx(left, abs=2)
    assert abs(end[1] - end[0] - left) > 20
    assert abs(end[0] - start[0]) > 5


def test_a_true_motion_alone_has_one_picture(page, tmp_path):
    file = tmp_path / "motion.html"
    file.write_text(r.play(r.solve(r.parse(SPHERES))).html, encoding="utf-8")
    page.goto(file.as_uri())
    page.wait_for_selector(".restitution-player .stage circle")
    assert page.locator(".stage").count() == 1
    assert page.locator(".beside, .mistaken, .says").count() == 0
