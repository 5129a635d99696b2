"""The page never answers another question, and can hide its answers."""

from __future__ import annotations

import random
from pathlib import Path
from urllib.parse import quote

import pytest
from pages import SCREENS, accessible, minding, too_wide
from playwright.sync_api import Page, expect
from pypdf import PdfReader

CHANCE = 3

WALL = """\
title A ball at a wall
wall W: along i
sphere P: mass 2, velocity 5i - 3j
P hits W: e = 1/3
find speed(P), impulse
find deflection(P)
"""
PARTS = """\
wall W: along i
sphere P: mass 2, velocity 5i - 3j
P hits W: e = 1/2
part a
find speed(P)
"""
CHAIN = """\
wall W: along j
sphere A: mass 2, velocity 4i
sphere B: mass 3, at rest
A hits B: along i, e = 1/2
B hits W: e = 1/2
find velocity(A, 1), velocity(B)
"""


@pytest.fixture
def open_(page: Page, served: str):
    """Opens the page with a statement in its address, and waits until it is solved."""
    page.emulate_media(reduced_motion="reduce")
    with minding(page, served):

        def go(statement: str, more: str = "") -> Page:
            page.goto(f"{served}/#statement={quote(statement)}{more}")
            if statement.strip():
                solved(page)
            return page

        yield go


def solved(page: Page) -> None:
    page.locator("#results:not(.stale):not(.foreign-to-form)[aria-busy=false]").wait_for()


def typed(page: Page) -> str:
    return page.locator("#statement").input_value()


def fill(page: Page, **fields: str) -> None:
    for name, value in fields.items():
        page.locator(f"#form-{name}").fill(value)


def opened(page: Page) -> Page:
    """The page with its form open and filled in from the editor."""
    page.get_by_role("button", name="Fill in a form").click()
    page.locator("#filling form").wait_for()
    return page


# --- never another question -----------------------------------------------------------------------


def test_a_choice_on_a_picture_is_named_by_what_it_asks(open_) -> None:
    page = opened(open_(WALL))
    page.get_by_label("Two spheres").check()
    for body in "AB":
        page.locator(f"#form-{body}Velocity").select_option("line")
    fill(page, ASpeed="5", AAngle="20", BSpeed="5", BAngle="20")
    for body, other in (("A", "B"), ("B", "A")):
        senses = page.get_by_role("radiogroup", name=f"How {body} moves")
        senses.get_by_label(f"away from {other}, up").check()
    said = "Sphere B, How B moves: Both move away from each other: they cannot meet."
    page.locator("#foreign").get_by_role("button", name=said).click()
    expect(page.locator("input[name=BWay]").first).to_be_focused()


def test_an_unread_field_marks_the_solution(open_) -> None:
    page = opened(open_(WALL))
    expect(page.locator("#form-PX")).to_have_value("5")
    for colours, width in (("light", 390), ("dark", 1280), ("light", 1920)):
        before = typed(page)
        page.set_viewport_size({"width": width, "height": 900})
        page.emulate_media(color_scheme=colours)
        fill(page, PX="5 +")
        mark = page.locator("#foreign")
        expect(mark).to_contain_text("Not of this question.")
        expect(mark).to_have_attribute("role", "status")
        expect(page.locator("#results")).to_have_attribute(
            "aria-label", "Solution, not of the question in the form"
        )
        assert typed(page) == before
        accessible(page)
        assert not too_wide(page)
        mark.get_by_role("button", name="Sphere P, i component").click()
        expect(page.locator("#form-PX")).to_be_focused()
        fill(page, PX="5")
        solved(page)
        expect(mark).to_be_empty()


def test_what_looks_current_is_of_what_is_filled_in(open_) -> None:
    """Whatever is typed into which field: the solution is of it, or says that it is not."""
    page = opened(open_(WALL))
    expect(page.locator("#form-PX")).to_have_value("5")
    draw = random.Random(CHANCE)
    texts = ("", "2", "u", "1/", "2 #", "3, mass 4", "-1", "5i", "1/2", "(", "2 at 30", "0.4 kg")
    marked = 0
    for _ in range(24):
        field = draw.choice(("PMass", "PX", "PY", "e1"))
        fill(page, **{field: draw.choice(texts)})
        page.locator("#results:not(.stale)[aria-busy=false]").wait_for()
        if page.locator("#foreign").inner_text():
            assert "foreign-to-form" in page.locator("#results").get_attribute("class")
            marked += 1
        else:
            written = page.locator("#filling pre").text_content()
            assert typed(page) == written
            values = page.locator("#filling input[type=text]").evaluate_all(
                "all => all.map((each) => each.value.trim())"
            )
            for value in filter(None, values):
                assert value.lstrip("-").rstrip() in written
    assert 0 < marked < 24


def test_it_asks_before_it_writes_over_what_was_typed(open_) -> None:
    page = opened(open_(PARTS))
    beside = page.locator("#filling .beside")
    expect(beside).to_contain_text("the form has no parts")
    fill(page, PX="2", PY="-1")
    expect(beside.get_by_role("button", name="Replace it")).to_be_visible()
    expect(page.locator("#foreign")).to_contain_text("waits for you to say")
    accessible(page)
    assert typed(page) == PARTS
    beside.get_by_role("button", name="Replace it").click()
    solved(page)
    assert "velocity 2i - j" in typed(page)
    fill(page, PX="3")  # it has been asked
    page.wait_for_function("() => document.getElementById('statement').value.includes('3i')")
    page.go_back()
    assert typed(page) == PARTS


def test_what_is_typed_by_hand_goes_into_the_form(open_) -> None:
    page = opened(open_(WALL))
    expect(page.locator("#form-title")).to_have_value("A ball at a wall")
    page.locator("#statement").fill(WALL.replace("5i", "7i").replace("1/3", "e"))
    expect(page.locator("#form-PX")).to_have_value("7")
    expect(page.locator("#form-e1")).to_have_value("e")
    page.locator("#statement").fill(CHAIN)
    expect(page.locator("#form-AX")).to_have_value("4")
    expect(page.get_by_label("Spheres, then a wall")).to_be_checked()
    solved(page)
    page.get_by_role("button", name="New", exact=True).click()
    expect(page.locator("#form-AX")).to_have_value("")


def test_an_empty_form_is_not_solved(open_) -> None:
    page = open_(WALL)
    page.get_by_role("button", name="New", exact=True).click()
    opened(page)
    page.get_by_label("Two spheres").check()
    fill(page, AMass="2")
    expect(page.locator("#foreign")).to_contain_text("Still missing")
    page.locator("#foreign").get_by_role("button", name="Sphere A, i component").wait_for()
    assert typed(page) == ""
    accessible(page)


# --- answers hidden -------------------------------------------------------------------------------


def seen(page: Page) -> str:
    return page.locator("main").inner_text()


def diagrams(page: Page) -> list[str]:
    return page.locator("#pictures figcaption").all_inner_texts()


def test_answers_are_hidden_by_a_switch(open_) -> None:
    page = open_(WALL)
    assert "Impulse" in seen(page) or "impulse" in seen(page)
    button = page.get_by_role("switch", name="Hide answers")
    button.click()
    expect(button).to_be_checked()
    for gone in ("#answers li", "#working", "#motion"):
        assert not page.locator(gone).first.is_visible()
    expect(page.locator("#pictures figcaption")).to_have_text("Before: P hits W")
    assert page.locator("#question").is_visible()  # what is asked
    assert page.locator("#spoken").text_content() == ""
    for colours, width in (("light", 390), ("dark", 1280)):
        page.set_viewport_size({"width": width, "height": 800})
        page.emulate_media(color_scheme=colours)
        accessible(page)
    for width, height in SCREENS:
        page.set_viewport_size({"width": width, "height": height})
        assert not too_wide(page)
    # What is solved next stays hidden, and so it is after a reload.
    page.locator("#statement").fill(WALL.replace("5i", "7i"))
    page.wait_for_function("() => location.hash.includes('7i')")
    solved(page)
    page.reload()
    page.locator("#hidden", has_text="The answers are hidden.").wait_for()
    expect(page.locator("#spoken")).to_have_text("Solved. The answers are hidden.")
    assert page.locator("#answers li:visible").count() == 0
    page.get_by_role("button", name="Show answers").click()
    expect(page.locator("#answers li")).to_have_count(3)
    expect(page.locator("#answers li:visible")).to_have_count(3)
    expect(page.locator("#pictures figcaption")).to_contain_text("Before and after")


def test_a_link_without_answers(open_) -> None:
    page = open_(WALL, "&answers=hidden")
    page.locator("#hidden", has_text="The answers are hidden.").wait_for()
    assert page.locator("#answers li:visible").count() == 0
    page.go_back()  # nothing that was there before shows what is hidden
    page.go_forward()
    page.locator("#hidden", has_text="The answers are hidden.").wait_for()


def test_line_by_line_an_answer_comes_with_its_line(open_) -> None:
    page = open_(WALL)
    page.get_by_role("button", name="Line by line").click()
    visible = page.locator("#answers li:visible")
    expect(visible).to_have_count(0)
    expect(page.locator("#hidden")).to_have_text("3 answers come with the lines below.")
    assert diagrams(page) == ["Before: P hits W"]
    following = page.get_by_role("button", name="Next line")
    counts = []
    while following.get_attribute("aria-disabled") == "false":
        counts.append(visible.count())
        assert not page.locator("#motion").is_visible()
        following.click()
    assert counts == sorted(counts)
    assert set(counts) == {0, 1, 2}
    expect(visible).to_have_count(3)
    expect(page.locator("#pictures figcaption")).to_contain_text("Before and after")
    expect(page.locator("#hidden")).to_be_hidden()
    page.get_by_role("button", name="Back one line").click()
    expect(visible).to_have_count(2)
    page.locator("#statement").fill(WALL.replace("5i", "7i"))
    expect(page.locator("#spoken")).to_have_text("Solved. The answers come line by line.")
    expect(visible).to_have_count(0)
    page.get_by_role("button", name="Whole").click()
    expect(visible).to_have_count(3)


def test_a_diagram_comes_with_the_last_line_of_its_impact(open_) -> None:
    page = open_(CHAIN)
    page.get_by_role("button", name="Line by line").click()
    following = page.get_by_role("button", name="Next line")
    counts = []
    while following.get_attribute("aria-disabled") == "false":
        following.click()
        counts.append(len(diagrams(page)))
    assert counts == sorted(counts) or counts[:-1] == sorted(counts[:-1])
    assert len(set(counts)) > 1


@pytest.mark.parametrize("paper", ["question", "room", "solution"])
def test_what_stands_on_paper(open_, tmp_path: Path, paper: str) -> None:
    page = open_(WALL)
    page.locator("#sharing").evaluate("node => { node.open = true; }")
    page.get_by_label("On paper").select_option(paper)
    path = tmp_path / "printed.pdf"
    page.pdf(path=path)
    printed = "\n".join(each.extract_text() for each in PdfReader(path).pages)
    assert "magnitude of the impulse" in printed
    assert ("Newton" in printed) == (paper == "solution")
    page.emulate_media(media="print")
    assert page.locator("#figure .room").is_visible() == (paper == "room")
    assert page.locator("#figure img").is_visible() == (paper != "solution")
    page.emulate_media(media="screen")
    with page.expect_download() as download:
        page.get_by_role("button", name="Download PDF").click()
    sheet = PdfReader(download.value.path())
    text = "\n".join(each.extract_text() for each in sheet.pages)
    assert ("Solutions" in text) == (paper == "solution")


def test_what_is_hidden_is_on_paper_where_it_is_chosen(open_, tmp_path: Path) -> None:
    page = open_(WALL, "&answers=hidden")
    page.locator("#sharing").evaluate("node => { node.open = true; }")
    paper = page.get_by_label("On paper")
    expect(paper).to_have_value("question")
    for chosen, holds in (("question", False), ("solution", True)):
        paper.select_option(chosen)
        page.pdf(path=tmp_path / "printed.pdf")
        printed = PdfReader(tmp_path / "printed.pdf").pages
        assert ("Newton" in "".join(each.extract_text() for each in printed)) == holds
    assert not page.locator("#working").is_visible()
