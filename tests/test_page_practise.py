"""The page that practises: choosing, reading lines, hints, agreeing on letters, marks."""

from __future__ import annotations

from urllib.parse import urlencode

import pytest
from pages import SCREENS, accessible, minding, too_wide
from playwright.sync_api import Page, expect

SPHERES = """\
sphere A: mass 2, velocity 3i + 2j
sphere B: mass 1, velocity -4i + j
A hits B: along i, e = 1/2
find velocity(A), velocity(B)
"""
PARTS = """\
wall W: along i
sphere P: mass 2, velocity 5i - 3j
P hits W: e = 1/3
part a
find velocity(P)
part b
find impulse
"""
SLIP = "CLM: 2*3 + 4 = 2v + w\nw - v = 0.5(3 + 4)\nv = 13/6"


@pytest.fixture
def practise(page: Page, served: str):
    """Opens the page with something in its address."""
    page.emulate_media(reduced_motion="reduce")
    with minding(page, served):

        def go(**told: str) -> Page:
            page.goto(f"{served}/practise#{urlencode(told)}")
            if told:
                expect(page.locator("#question")).not_to_be_empty(timeout=30_000)
            return page

        yield go


def read_lines(page: Page, script: str, button: str = "Read my lines") -> None:
    page.locator("#script").fill(script)
    page.get_by_role("button", name=button).click()
    settled(page)


def settled(page: Page) -> None:
    page.locator("#reply[aria-busy=false]").wait_for(timeout=30_000)
    page.locator("#reply li").first.wait_for()


def verdicts(page: Page) -> list[str]:
    return [each.get_attribute("class") or "" for each in page.locator(".lines-read li").all()]


def test_topics_stand_in_the_order_in_which_they_are_taught(practise) -> None:
    page = practise()
    groups = page.locator("#topic-list h3").all_inner_texts()
    assert groups[0] == "One wall"
    assert groups[-1] == "Ranges"
    expect(page.locator("#practising")).to_be_hidden()


def test_a_blank_behind_a_slanted_letter_has_room(practise) -> None:
    page = practise(topic="wall-forward", level="1", seed="5")
    room = "each => parseFloat(getComputedStyle(each).marginRight) / each.offsetHeight"
    assert page.locator("#question i").first.evaluate(room) > 0.05


def test_a_topic_gives_the_same_question_again_by_its_address(practise) -> None:
    page = practise(topic="wall-forward", level="1", seed="5")
    words = page.locator("#question").inner_text()
    assert "e" in words
    page.reload()
    expect(page.locator("#question")).not_to_be_empty(timeout=30_000)
    assert page.locator("#question").inner_text() == words
    page.get_by_role("button", name="Another like this").click()
    expect(page.locator("#provenance")).not_to_contain_text("number 5", timeout=30_000)


def test_lines_are_read_and_the_mistake_is_named_only_when_asked_for(practise) -> None:
    page = practise(statement=SPHERES)
    read_lines(page, SLIP)
    assert verdicts(page) == ["false", "true", "follows"]
    expect(page.locator(".lines-read li p")).to_have_count(0)
    said = set()
    for _ in range(3):
        page.get_by_label("A hint for line 1").click()
        settled(page)
        said.add(page.locator(".lines-read li").first.locator("p").first.inner_text())
    assert len(said) == 3
    expect(page.get_by_role("button", name="Show me this mistake")).to_be_visible()
    expect(page.locator("#worked")).to_be_hidden()


def test_a_mistake_is_played_beside_what_happens(practise) -> None:
    page = practise(statement=SPHERES)
    read_lines(page, SLIP)
    for _ in range(3):
        page.get_by_label("A hint for line 1").click()
        settled(page)
    page.get_by_role("button", name="Show me this mistake").click()
    expect(page.locator("#playing")).to_contain_text("With the mistake", timeout=30_000)


def test_marks_and_the_working_come_at_the_end(practise) -> None:
    page = practise(statement=SPHERES)
    read_lines(page, SLIP, "Finish, and mark it")
    expect(page.locator(".marks-given h3")).to_contain_text("of")
    expect(page.locator("#worked")).to_be_visible()
    expect(page.locator(".marks-given tr").first).to_be_visible()


def test_a_sense_that_is_turned_turns_the_lines(practise) -> None:
    page = practise(statement=SPHERES)
    turned = "2*3 - 4 = -2v + w\nw + v = 3.5\nv = 0.5"
    page.get_by_role("button", name="Turn the sense of v").click()
    read_lines(page, turned)
    assert verdicts(page) == ["true", "true", "true"]


def test_parts_are_marked_each_by_itself(practise) -> None:
    page = practise(statement=PARTS)
    expect(page.locator("#of-parts")).to_be_visible()
    script = "(a)\nv = 5i + j\n(b)\nI = 2(1 + 3) = 8"
    read_lines(page, script, "Finish, and mark it")
    expect(page.locator(".marks-given")).to_have_count(2)


def test_an_attempt_is_kept_and_shown_with_its_topic(practise) -> None:
    page = practise(topic="wall-forward", level="1", seed="5")
    read_lines(page, "1 = 1", "Finish, and mark it")
    kept = page.evaluate("() => JSON.parse(localStorage.getItem('restitution practice'))")
    assert [each["topic"] for each in kept] == ["wall-forward"]
    assert kept[0]["earned"] < kept[0]["of"]


@pytest.mark.parametrize("screen", SCREENS)
def test_it_fits_and_is_accessible(practise, screen: tuple[int, int]) -> None:
    page = practise(statement=SPHERES)
    page.set_viewport_size({"width": screen[0], "height": screen[1]})
    read_lines(page, SLIP, "Finish, and mark it")
    assert not too_wide(page)
    accessible(page)


def test_what_cannot_be_solved_is_said(page: Page, served: str) -> None:
    # The browser itself writes into its console that the server refused this.
    page.goto(f"{served}/practise#{urlencode({'statement': 'sphere A: mass'})}")
    expect(page.locator("#notice")).to_be_visible(timeout=30_000)
