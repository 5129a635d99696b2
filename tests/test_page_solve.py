"""The page that solves, in a real browser: what one types, sees, shares, prints and hears."""

from __future__ import annotations

import json
import re
from pathlib import Path
from unicodedata import normalize
from urllib.parse import parse_qs, quote, urlparse

import httpx
import pytest
from pages import SCREENS, accessible, enlarge_text, minding, too_wide
from playwright.sync_api import expect

from restitution import parse, solve
from restitution.examples.topics import TOPICS
from restitution.expression.quantities import QUANTITIES
from restitution.expression.words import PROPERTY_WORDS
from restitution.web.pages import GHOST
from restitution.web.words import vocabulary

WALL = """\
title A ball at a wall
wall W: along i
sphere P: mass 2, velocity 5i - 3j
P hits W
given energy_lost = 5
find e, deflection(P)
"""
REJECTED = """\
sphere A, B: mass m
sphere A: velocity u at 45°
sphere B: at rest
A hits B: along i
given angle(velocity(A), line_of_centres) = arctan(4)
find e
"""
FALSE = """\
wall W: along i
sphere P: velocity u at 45° to W
P hits W
show speed(P) = e u
"""
CORNER = """\
wall AB: along i
wall BC: along 60°
sphere P: velocity u at 60° to AB
P hits AB: e = 1/2
show speed(P) = sqrt(7)/4 u
P hits BC: e = 1/2
find speed(P)
"""


@pytest.fixture
def complaints(page, served):
    """What the console says, which has to be taken out where it is expected."""
    with minding(page, served) as said:
        yield said


@pytest.fixture
def open_(page, served, complaints):
    """Opens the page, with a statement in its address, and waits until it is solved."""
    page.emulate_media(reduced_motion="reduce")

    def go(statement: str = GHOST):
        page.goto(f"{served}/#statement={quote(statement)}")
        solved(page)
        return page

    return go


def solved(page) -> None:
    page.locator("#results:not(.stale)[aria-busy=false]").wait_for()


def answers(page) -> str:
    """What is answered, in plain letters, without blanks and without invisible operators."""
    shown = normalize("NFKC", page.locator("#answers").inner_text())
    return re.sub(r"[\s\u2061\u2062]", "", shown)


def typed(page) -> str:
    return page.locator("#statement").input_value()


def stated(page) -> str | None:
    """The statement of the address."""
    return parse_qs(urlparse(page.url).fragment, keep_blank_values=True).get("statement", [None])[0]


# --- the first visit ------------------------------------------------------------------------------


@pytest.fixture
def opening(page, served, complaints):
    """The page as it is first seen."""
    page.emulate_media(reduced_motion="reduce")
    page.goto(served + "/")
    page.locator("#opening").wait_for()
    return page


def test_a_first_visit_has_a_choice_of_ways(opening):
    page = opening
    headings = page.locator("#opening :is(h2, h3):visible").all_inner_texts()
    ways = ["Fill in a form", "Write it", "Take an example"]
    assert headings == ["Solve a question", *ways, "Lab"]
    assert page.locator("#statement").is_hidden()
    assert page.locator("[data-kind] svg").count() == 4
    expect(page.locator("[data-topic] img").first).to_have_js_property("complete", True)
    names = page.locator("[data-topic]").evaluate_all(
        "all => all.map((each) => each.dataset.topic)"
    )
    assert names == list(TOPICS)
    assert stated(page) is None


def test_no_link_of_the_choice_is_dead(opening, served):
    found = opening.locator("a").evaluate_all("all => all.map((each) => each.href)")
    assert {urlparse(each).path for each in found} > {
        "/lab",
        "/guides/students",
        "/guides/teachers",
    }
    assert all(httpx.get(each, timeout=100).status_code == 200 for each in found)


@pytest.mark.parametrize("kind", ["wall", "walls", "spheres", "chain"])
def test_what_happens_opens_the_form(opening, kind):
    page = opening
    page.locator(f"[data-kind={kind}]").click()
    chosen = page.locator(f"#filling label.kind input[value={kind}]")
    expect(chosen).to_be_checked()
    assert page.locator("#opening").is_hidden()
    name = page.locator(f"[data-kind={kind}]").text_content()
    assert page.locator("label.kind:has(:checked)").inner_text().strip() == name
    page.go_back()
    assert page.locator("#opening").is_visible()


def test_writing_begins_with_an_empty_editor_that_shows_how(opening):
    page = opening
    page.get_by_role("button", name="Write a question of your own").click()
    assert page.evaluate("() => document.activeElement.id") == "statement"
    assert typed(page) == ""
    ghost = page.locator("#statement").get_attribute("placeholder")
    assert ghost == GHOST.strip()
    items = [item for _, item in solve(parse(ghost)).items()]
    assert items and all(item.answers for item in items)
    field = page.locator("#statement")
    assert field.evaluate("node => node.scrollHeight <= node.clientHeight")
    page.keyboard.insert_text(WALL)
    solved(page)
    assert "e=23" in answers(page)
    page.go_back()
    assert page.locator("#opening").is_visible()
    assert page.locator("#solve").is_hidden()
    page.go_forward()
    solved(page)
    assert typed(page) == WALL


def test_a_topic_opens_the_gallery_there(opening):
    page = opening
    page.get_by_role("button", name="Ranges of values").click()
    gallery = page.get_by_role("dialog", name="Examples")
    heading = gallery.get_by_role("heading", name="Ranges of values")
    expect(heading).to_be_in_viewport()
    chosen = gallery.locator("section[data-topic='Ranges of values'] button").first
    expect(chosen).to_be_focused()
    page.keyboard.press("Enter")
    solved(page)
    assert page.locator("#opening").is_hidden()
    assert "find range of" in typed(page)
    page.go_back()
    assert page.locator("#opening").is_visible()


def test_the_choice_comes_again(open_):
    page = open_(WALL)
    page.get_by_role("button", name="New", exact=True).click()
    page.get_by_role("button", name="All ways to begin").click()
    assert page.locator("#opening").is_visible()
    page.reload()
    assert page.locator("#opening").is_visible()
    page.go_back()
    page.go_back()
    solved(page)
    assert typed(page) == WALL


def test_a_browser_that_keeps_nothing_costs_nothing_else(page, served, complaints):
    refuse = "Object.defineProperty(window, 'sessionStorage', { get() { throw new Error('no'); } })"
    page.add_init_script(refuse)
    page.goto(served + "/")
    page.get_by_role("button", name="Write a question of your own").click()
    page.keyboard.insert_text(WALL)
    solved(page)
    page.wait_for_function("() => location.hash.includes('ball')")
    page.reload()
    solved(page)
    assert typed(page) == WALL


def test_a_question_is_shown_solved(open_):
    page = open_(GHOST)
    assert "velocityofAimmediatelyafterthecollision=3i+2j" in answers(page)
    assert page.locator("#pictures img").first.get_attribute("alt")
    assert page.locator("#working tr").count() > 5
    assert page.locator(".principle", has_text="Newton's experimental law").count() == 1
    assert page.title() == f"{page.locator('#title').inner_text()} – Restitution"


# --- typing ---------------------------------------------------------------------------------------


def test_an_edit_shows_its_new_solution_and_the_address_holds_it(open_):
    page = open_(WALL)
    assert "e=23" in answers(page)
    page.locator("#statement").fill(WALL.replace("= 5\n", "= 9\n"))
    page.locator("#spoken", has_text="e = 0").wait_for()
    page.wait_for_function("() => location.hash.includes('%3D+9')")
    assert stated(page) == typed(page)
    page.reload()
    solved(page)
    assert "= 9\n" in typed(page)
    assert "e=0" in answers(page)


def test_a_mistake_is_marked_at_its_place_and_clears(open_):
    page = open_(WALL)
    page.locator("#statement").fill(WALL.replace("velocity", "velocty"))
    wrong = page.locator(".layer .wrong")
    wrong.wait_for()
    assert wrong.inner_text() == "velocty"
    message = page.locator("#mistakes .mistake")
    assert "Line 3" in message.inner_text()
    assert "did you mean 'velocity'" in message.inner_text()
    assert page.locator("#statement").get_attribute("aria-invalid") == "true"
    assert "stale" in page.locator("#results").get_attribute("class")
    over = "each => getComputedStyle(each, '::before').marginBottom"
    assert page.locator("#results").evaluate(over) == "0px"  # the title stands beside it
    message.click()
    assert page.evaluate("() => getSelection().toString()") == "velocty"
    page.keyboard.insert_text("velocity")
    wrong.wait_for(state="detached")
    solved(page)
    assert page.locator("#mistakes").is_hidden()
    assert page.locator("#statement").get_attribute("aria-invalid") == "false"


def test_a_cure_mends_with_one_click(open_):
    page = open_(WALL)

    def told(route):
        reply = route.fetch()
        found = reply.json()
        for error in found["errors"]:
            edit = {"line": 3, "column": 19, "end_line": 3, "end_column": 26, "text": "velocity"}
            error["fixes"] = [{"label": "Write velocity", "edits": [edit]}]
        route.fulfill(response=reply, json=found)

    page.route("**/api/check", told)
    wrong = WALL.replace("A ball", "𝐀 ball").replace("velocity", "velocty")
    page.locator("#statement").fill(wrong)
    page.get_by_role("heading", name="One thing to mend first").wait_for()
    accessible(page)
    page.get_by_role("button", name="Write velocity").click()
    solved(page)
    assert typed(page) == wrong.replace("velocty", "velocity")
    assert page.locator("#wrong").is_hidden()
    page.locator("#statement").focus()
    page.keyboard.press("Control+z")
    assert typed(page) == wrong


def test_a_note_has_its_cure_too(open_):
    page = open_(WALL.replace("mass 2", "mass 2000 g"))
    assert "e=23" in answers(page)
    page.get_by_role("button", name="Write 2", exact=True).click()
    solved(page)
    assert typed(page) == WALL
    assert page.locator(".warning").count() == 0


def test_every_mistake_of_a_text_is_listed(open_):
    page = open_(WALL)
    page.locator("#statement").fill("spher P\nwall W: alon i\nfind speed(Q)\n")
    page.locator("#mistakes .mistake").nth(1).wait_for()
    assert page.locator(".layer .wrong").count() >= 2


def test_the_layer_has_the_letters_of_the_field_in_their_places(open_):
    page = open_(CORNER + "# " + "word " * 60 + "\n")
    field, layer = page.locator("#statement"), page.locator(".layer")
    shown = layer.evaluate("node => [...node.children].map((row) => row.textContent).join('\\n')")
    assert shown == typed(page)
    heights = field.evaluate("node => [node.scrollHeight, node.clientHeight]")
    assert heights[0] == heights[1]
    assert layer.evaluate("node => node.clientHeight") == heights[1]
    names = page.locator(".layer .name").all_inner_texts()
    assert names.count("P") == 5
    assert "AB" in names


def test_words_are_completed_by_keyboard(open_):
    page = open_(WALL)
    field = page.locator("#statement")
    field.fill("")
    field.press_sequentially("sph")
    box = page.get_by_role("listbox", name="Suggestions")
    box.wait_for()
    first = box.get_by_role("option").first
    assert field.get_attribute("aria-activedescendant") == first.get_attribute("id")
    assert "a smooth sphere" in first.inner_text()
    page.keyboard.press("Tab")
    assert typed(page) == "sphere A: velocity "
    page.keyboard.insert_text("3i - j\nwall W: along i\nA ")
    page.get_by_role("option", name="hits").wait_for()
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    page.get_by_role("option", name="W wall").wait_for()
    page.keyboard.press("ArrowDown")
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    assert typed(page).endswith("\nA hits W")
    page.keyboard.press("Enter")
    page.keyboard.type("find energy_l")
    page.keyboard.press("Enter")
    assert typed(page).endswith("find energy_lost")
    page.keyboard.press("Control+z")
    assert typed(page).endswith("find energy_l")


def test_suggestions_lie_over_the_results(open_):
    page = open_()
    page.set_viewport_size({"width": 1280, "height": 800})
    page.locator("#statement").press("Control+End")
    page.keyboard.type("\nfind angle(velocity(A), li")
    option = page.locator(".suggestions").get_by_role("option").last
    option.wait_for()
    page.evaluate("() => document.querySelector('.suggestions').style.left = '600px'")
    there = option.bounding_box()
    place = [there["x"] + there["width"] - 10, there["y"] + there["height"] / 2]
    assert page.evaluate("([x, y]) => !!document.elementFromPoint(x, y).closest('li')", place)


def test_an_end_of_line_is_never_taken_for_a_choice(open_):
    page = open_(WALL)
    field = page.locator("#statement")
    field.fill("")
    text = (
        "sphere P: mass m, velocity u i\nwall W: along 60°\nP hits W: e = e\nfind energy\nfind e\n"
    )
    field.press_sequentially(text)
    assert typed(page) == text


def test_tab_leaves_the_editor_when_nothing_is_suggested(open_):
    page = open_(WALL)
    field = page.locator("#statement")
    field.focus()
    page.keyboard.press("Control+End")
    page.keyboard.type("sp")
    page.get_by_role("listbox").wait_for()
    page.keyboard.press("Escape")
    assert page.get_by_role("listbox").count() == 0
    page.keyboard.press("Tab")
    assert typed(page).endswith("sp")
    assert field.evaluate("node => document.activeElement !== node")


# --- results --------------------------------------------------------------------------------------


def test_a_rejected_value_has_its_reason(open_):
    page = open_(REJECTED)
    assert "e=12" in answers(page)
    rejected = page.locator(".rejected").inner_text()
    assert rejected.startswith("Rejected:")
    assert "coefficient of restitution lies" in rejected


def test_a_rejected_angle_is_in_degrees(open_):
    page = open_(
        "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W\n"
        "given speed(P)^2 = 13\nfind arctan(e)"
    )
    assert "arctan(12)=26.6°" in answers(page)
    assert "−arctan(12)=−26.6°" in answers(page)


def test_what_is_false_is_refuted(open_):
    page = open_(FALSE)
    assert "✗Nottrue,forinstancewithe=" in answers(page)


def test_numbers_that_refute_are_mathematics(open_):
    page = open_("wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\nshow speed(P) = u")
    assert re.search("instancewith(.*,)?α=[0-9]+°", answers(page))
    assert "alpha" not in answers(page)


def test_what_is_not_decided_is_said(open_):
    page = open_(
        "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\nshow sin(alpha) < alpha\n"
    )
    assert "?Notdecided" in answers(page)
    assert "hown" not in page.locator("#answers").inner_text()
    assert "sin(alpha) < alpha: not decided" in page.locator("body").text_content()
    accessible(page)


def test_long_values_stand_below_a_long_name(open_):
    page = open_(
        "sphere A: mass 1, velocity 3i + j\nsphere B: mass k, at rest\nA hits B: along i\n"
        "unknown e\nfind range of tan(direction(A))\n"
    )
    assert "fork>1" in answers(page)
    row = page.locator("#answers li").first
    wide, there = row.evaluate("each => [each.scrollWidth, each.clientWidth]")
    assert wide <= there  # else a part of the answer is cut off


def test_an_answer_with_its_condition(open_):
    page = open_(
        "wall W: along i\nsphere P: velocity a i - 4j\nP hits W\ngiven speed(P) = 5\nfind e\n"
    )
    assert ",for−5≤a≤−3or3≤a≤5" in answers(page)
    assert page.locator("#answers .condition math").count() == 2
    assert "for −5 ≤ a ≤ −3 or 3 ≤ a ≤ 5" in page.locator("body").text_content()
    accessible(page)


def test_what_is_missing_is_said(open_):
    page = open_("wall W: along i\nsphere P: velocity 3i - 4j\nP hits W: e = 1/2\nfind impulse\n")
    assert "Noanswer:" in answers(page)
    assert "mass" in answers(page)


def test_the_question_is_told_in_words(open_):
    page = open_(WALL)
    page.get_by_text("The question in words").click()
    assert "coefficient of restitution" in page.locator("#question").inner_text()


def test_line_by_line(open_):
    page = open_(WALL)
    lines = page.locator("#working .said:visible, #working tr:visible")
    whole = lines.count()
    page.get_by_role("button", name="Line by line").click()
    assert lines.count() < whole
    progress = page.locator("#working .progress")
    total = int(progress.inner_text().split(" of ")[1])
    assert progress.inner_text() == f"line 1 of {total}"
    page.get_by_role("button", name="Next line").click()
    assert progress.inner_text() == f"line 2 of {total}"
    assert page.locator("#working .newest:visible").count() >= 1
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowLeft")
    page.keyboard.press("Space")
    assert progress.inner_text() == f"line 3 of {total}"
    for _ in range(total):
        page.keyboard.press("ArrowRight")
    assert lines.count() == whole
    assert page.get_by_role("button", name="Next line").is_disabled()
    page.get_by_role("button", name="Whole").click()
    assert progress.is_hidden()
    assert lines.count() == whole


def test_at_the_last_line_the_focus_is_not_lost(open_):
    page = open_(WALL)
    page.get_by_role("button", name="Line by line").press("Enter")
    total = int(page.locator("#working .progress").inner_text().split()[-1])
    for _ in range(total + 1):
        page.keyboard.press("Enter")
    assert page.locator("#working .progress").inner_text() == f"line {total} of {total}"
    assert page.evaluate("() => document.activeElement.textContent") == "Next line"


def test_a_line_says_more_about_its_principle(open_):
    page = open_()
    why = page.get_by_role("button", name="Why? Newton's experimental law")
    about = page.locator("#working .about:visible")
    assert about.count() == 0
    why.click()
    assert "speed of approach" in about.inner_text()
    why.click()
    assert about.count() == 0


def test_marks_can_be_hidden(open_):
    page = open_(WALL)
    mark = page.locator("#working td.m", has_text="M1").first
    assert mark.is_visible()
    page.get_by_label("Marks").uncheck()
    assert not mark.is_visible()


def test_diagrams_are_turned_and_enlarged(open_):
    page = open_(CORNER)
    seen = page.locator("#pictures figure:visible figcaption")
    first = seen.inner_text()
    page.get_by_role("button", name="Next", exact=True).click()
    assert seen.inner_text() != first
    page.locator("#pictures .picture:visible").click()
    large = page.get_by_role("dialog", name="Diagram")
    assert large.locator("img").get_attribute("src").startswith("blob:")
    page.keyboard.press("ArrowLeft")
    assert large.locator("p").inner_text() == first
    page.keyboard.press("Escape")
    assert seen.inner_text() == first


def test_the_motion_is_fetched_when_it_comes_into_view(open_):
    page = open_(WALL)
    fetched = "() => performance.getEntriesByType('resource').some((e) => /player/.test(e.name))"
    page.locator("#motion").scroll_into_view_if_needed()
    page.locator("#motion .stage circle").first.wait_for()
    assert page.evaluate(fetched)
    page.locator("#statement").fill("sphere P: velocity 3i\nfind speed(P)\n")
    page.locator("#motion", has_text="no motion").wait_for()


# --- the address, and what survives ---------------------------------------------------------------


def test_back_and_forward(open_):
    page = open_(WALL)
    page.get_by_role("button", name="New", exact=True).click()
    assert typed(page) == ""
    assert page.locator("#results").is_hidden()
    page.locator("#statement").fill(CORNER)
    page.locator("#answers", has_text="speed of P").wait_for()
    page.wait_for_function("() => location.hash.includes('BC')")
    page.go_back()
    assert typed(page) == WALL
    solved(page)
    assert "e=23" in answers(page)
    page.go_forward()
    assert typed(page) == CORNER
    solved(page)
    assert "speedofP" in answers(page)


def test_typed_work_survives_leaving_and_coming_back(open_, served):
    page = open_()
    page.locator("#statement").fill(WALL)
    page.wait_for_function("() => location.hash.includes('ball')")
    page.goto(served + "/lab")
    page.goto(served + "/")
    solved(page)
    assert typed(page) == WALL


def test_a_statement_too_long_for_a_link_is_kept(open_):
    page = open_(WALL)
    long = WALL + "# words and words\n" * 400
    page.locator("#statement").fill(long)
    page.get_by_text("too long for the address").wait_for()
    page.reload()
    solved(page)
    assert typed(page) == long
    assert page.get_by_text("too long for the address").is_visible()


# --- examples, the form, the language -------------------------------------------------------------


def test_an_example_is_chosen_and_back_takes_it_away(open_):
    page = open_(WALL)
    page.get_by_role("button", name="Examples").click()
    gallery = page.get_by_role("dialog", name="Examples")
    gallery.get_by_role("button", name="A ball in a corner of 120 degrees").click()
    gallery.wait_for(state="hidden")
    page.locator("#title", has_text="corner of 120 degrees").wait_for()
    assert "P hits BC" in typed(page)
    assert stated(page) == typed(page)
    page.go_back()
    assert typed(page) == WALL


def test_the_form_writes_where_one_sees_it(open_):
    page = open_(WALL)
    button = page.get_by_role("button", name="Fill in a form")
    button.click()
    form = page.locator("#filling form")
    expect(form.locator("#form-PX")).to_have_value("5")  # it reads what stands in the editor
    form.locator("#form-PMass").fill("3")
    page.locator("#answers", has_text="e = ").wait_for()
    page.wait_for_function("() => location.hash.includes('mass+3')")
    form.locator("#form-PX").fill("6")
    page.locator(".layer .number", has_text="6").first.wait_for()
    assert page.locator("#statement").is_visible()
    page.wait_for_function("() => location.hash.includes('velocity+6i')")
    page.go_back()
    assert typed(page) == WALL  # however much was filled in
    expect(form.locator("#form-PX")).to_have_value("5")
    button.click()
    assert button.get_attribute("aria-expanded") == "false"


def test_the_language_on_one_panel(open_):
    page = open_(WALL)
    page.get_by_role("button", name="Language").click()
    panel = page.get_by_role("dialog", name="The language")
    panel.get_by_text("A hits B: along j, e = 3/7").wait_for()
    assert panel.get_by_text("line_of_centres").first.is_visible()
    page.keyboard.press("Escape")
    assert page.evaluate("() => document.activeElement.id") == "language"


# --- sharing --------------------------------------------------------------------------------------


def test_copying(open_):
    page = open_(WALL)
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    for button, what, holds in (
        ("Copy statement", "statement", WALL),
        ("Copy link", "link", "#statement=title+A+ball"),
        ("Link without answers", "link without answers", "&answers=hidden"),
        ("Copy LaTeX", "LaTeX", r"\begin{document}"),
        ("Copy diagram as SVG", "SVG", "<svg"),
    ):
        page.get_by_role("button", name=button).click()
        page.locator("#said", has_text=f"The {what} is copied.").wait_for()
        assert holds in page.evaluate("() => navigator.clipboard.readText()")


def test_copying_without_a_clipboard(open_):
    page = open_(WALL)
    page.evaluate("() => Object.defineProperty(navigator, 'clipboard', { value: undefined })")
    page.get_by_role("button", name="Copy statement").click()
    field = page.get_by_role("dialog").get_by_role("textbox")
    assert field.input_value() == WALL
    selected = "node => node.value.slice(node.selectionStart, node.selectionEnd)"
    assert field.evaluate(selected) == WALL


def test_the_sheet_is_downloaded(open_):
    page = open_(WALL)
    with page.expect_download() as told:
        page.get_by_role("button", name="Download PDF").click()
    assert told.value.suggested_filename == "A ball at a wall.pdf"
    assert Path(told.value.path()).read_bytes().startswith(b"%PDF")


def test_what_is_printed(open_):
    page = open_(CORNER)
    page.emulate_media(media="print")
    assert page.locator("#statement").is_hidden()
    assert page.get_by_role("button").count() == page.locator("#pictures .picture").count()
    assert page.locator("#question").is_visible()
    assert page.locator("#pictures img:visible").count() == 3
    assert page.locator("#working tr").last.is_visible()


def test_no_equation_is_parted_from_its_group_on_paper(open_):
    page = open_(
        "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W: e = 1/2\n"
        "given tan(alpha) = 3/4\nfind speed(P)"
    )
    page.emulate_media(media="print")
    groups = page.locator("#working .rows").all()
    assert any(group.locator("tr").count() > 1 for group in groups)
    for group in groups:
        assert group.evaluate("node => getComputedStyle(node).breakInside") == "avoid"
        before = group.locator("xpath=preceding-sibling::*[1]")
        if before.count() and "said" in (before.get_attribute("class") or ""):
            assert before.evaluate("node => getComputedStyle(node).breakAfter") == "avoid"


# --- when the server cannot -----------------------------------------------------------------------


def test_a_slow_question_is_said_to_be_solved(open_):
    page = open_(WALL)
    assert "e =" in page.locator("#spoken").text_content()
    held = []

    def hold(route):
        if held:
            route.continue_()
        held.append(route)

    page.route("**/api/explain", hold)
    page.locator("#statement").fill(CORNER)
    page.locator("#notice", has_text="Solving").wait_for()
    assert "speedofP" not in answers(page)
    # Nothing is told of an earlier question.
    assert page.locator("#spoken").text_content() == ""
    held.pop().continue_()
    page.locator("#answers", has_text="speed of P").wait_for()
    page.locator("#notice").wait_for(state="hidden")
    page.locator("#spoken", has_text="speed(P)").wait_for(state="attached")


# As the server does where the working takes long: the answers stand in a line of their own.
SLOWLY = """() => {
  const fetched = window.fetch;
  window.fetch = async (address, options) => {
    if (address !== "api/explain") return fetched(address, options);
    const reply = await (await fetched(address, options)).json();
    const early = { ...reply, motion: null, latex: null };
    early.working = reply.working.map((part) => ({ ...part, steps: [] }));
    const lines = [early, reply].map((each) => new TextEncoder().encode(JSON.stringify(each)));
    return new Response(new ReadableStream({
      async start(out) {
        out.enqueue(lines[0].slice(0, 100));
        out.enqueue(lines[0].slice(100));
        out.enqueue(new TextEncoder().encode("\\n"));
        await new Promise((go) => { window.go = go; });
        if (!window.cut) out.enqueue(lines[1]);
        out.close();
      },
    }));
  };
}"""


def test_answers_and_diagrams_come_before_a_slow_working(open_):
    page = open_(WALL)
    page.evaluate(SLOWLY)
    page.locator("#statement").fill(CORNER)
    page.locator("#notice", has_text="The working is being written").wait_for()
    assert "speedofP" in answers(page)
    assert page.locator("#pictures img:visible").count() == 1
    assert page.locator("#worked").is_hidden()
    assert page.locator("#motion").is_hidden()
    assert page.locator("#results").get_attribute("aria-busy") == "true"
    assert page.locator("#results:not(.stale)").count() == 1
    accessible(page)
    page.evaluate("() => window.go()")
    solved(page)
    assert page.locator("#working tr").count() > 5
    assert page.locator("#notice").is_hidden()


def test_the_earlier_working_keeps_its_place_until_the_next_one_comes(open_):
    page = open_(WALL)
    page.evaluate(SLOWLY)
    page.evaluate(
        """() => {
          const seen = () => ["worked", "working", "moving"].map((id) =>
            !document.getElementById(id).hidden);
          new MutationObserver(() => { window.stood ??= seen(); })
            .observe(document.getElementById("answers"), { childList: true });
        }"""
    )
    page.locator("#statement").fill(WALL.replace("energy_lost = 5", "energy_lost = 6"))
    page.wait_for_function("() => window.stood && window.go")
    assert page.evaluate("() => window.stood") == [True, True, True]
    assert page.locator("#share [data-do=print]").is_disabled()
    page.evaluate("() => window.go()")
    solved(page)
    assert page.locator("#share [data-do=print]").is_enabled()


def test_another_number_is_solved_without_waiting_for_its_reading(open_):
    page = open_(WALL)
    held = []

    def hold(route):
        if held:
            route.continue_()
        held.append(route)

    page.route(re.compile("/api/check$"), hold)
    with page.expect_request(re.compile("/api/explain$")) as asked:
        page.locator("#statement").fill(WALL.replace("5i", "7i"))
    assert "7i" in asked.value.post_data_json["statement"]
    while not held:
        page.wait_for_timeout(10)
    held[0].continue_()
    solved(page)


def test_another_number_that_cannot_be_read_is_marked(open_):
    page = open_(WALL)
    page.locator("#statement").fill(WALL.replace("energy_lost = 5", "energy_lost = 5.5.5"))
    page.locator("#mistakes .mistake").wait_for()
    assert "Line 5" in page.locator("#mistakes .mistake").inner_text()


def test_a_reply_that_breaks_off_is_told(open_):
    page = open_(WALL)
    page.evaluate(SLOWLY)
    page.evaluate("() => { window.cut = true; }")
    page.locator("#statement").fill(CORNER)
    page.locator("#notice", has_text="The working is being written").wait_for()
    page.evaluate("() => window.go()")
    page.locator("#notice", has_text="The connection to the server is lost.").wait_for()


def test_a_server_that_comes_back_is_noticed(open_, complaints):
    page = open_(WALL)
    page.route(re.compile("/health$|/api/"), lambda route: route.abort())
    page.locator("#statement").fill(CORNER)
    page.locator("#notice", has_text="The connection to the server is lost.").wait_for()
    assert typed(page) == CORNER
    page.unroute(re.compile("/health$|/api/"))
    page.locator("#answers", has_text="speed of P").wait_for()
    assert page.locator("#notice").is_hidden()
    complaints[:] = [said for said in complaints if "ERR_FAILED" not in said]


def test_the_motion_of_an_earlier_question_is_not_kept(open_):
    page = open_(WALL)
    motion = page.locator("#motion")
    motion.scroll_into_view_if_needed()
    motion.locator(".stage circle").first.wait_for()
    motion.get_by_role("button", name="Next impact").click()
    live = motion.locator("[aria-live]")
    expect(live).to_contain_text("1: P hits W")
    page.locator("#statement").scroll_into_view_if_needed()
    page.set_viewport_size({"width": 400, "height": 300})
    page.evaluate("() => scrollTo(0, 0)")
    page.locator("#statement").fill(CORNER)
    page.locator("#answers", has_text="speed of P").wait_for()
    assert live.is_hidden() or live.text_content() == ""


def test_each_diagram_is_told_as_it_is_turned_to(open_):
    page = open_(CORNER)
    told = page.locator("#pictures [role=status]")
    assert told.text_content() == "1 of 3: Path of P"
    page.get_by_role("button", name="Next", exact=True).click()
    assert told.text_content() == "2 of 3: Before and after: P hits AB"


def test_words_and_mathematics_have_one_face(open_):
    page = open_(CORNER)
    page.evaluate("() => document.fonts.ready")
    face = "node => getComputedStyle(node).fontFamily.split(',')[0]"
    words = page.locator("#working .said").first.evaluate(face)
    assert words == page.locator("#working math").first.evaluate(face) == '"STIX Two Math"'
    assert page.evaluate("() => [...document.fonts].every((each) => each.status === 'loaded')")


def test_a_busy_server_is_asked_again(open_, complaints):
    page = open_(WALL)
    refused = []

    def busy(route):
        if len(refused) < 1:
            refused.append(route.request.url)
            body = json.dumps({"error": {"kind": "busy", "message": "many are asking"}})
            route.fulfill(status=503, headers={"Retry-After": "1"}, body=body)
        else:
            route.fallback()

    page.route("**/api/explain", busy)
    page.locator("#statement").fill(CORNER)
    notice = page.locator("#notice")
    notice.filter(has_text=re.compile(r"busy just now\. Trying again in \d s")).wait_for()
    assert typed(page) == CORNER
    page.locator("#answers", has_text="speed of P").wait_for()
    assert notice.is_hidden()
    complaints[:] = [said for said in complaints if "503" not in said]


def test_a_statement_that_is_refused_is_told_in_sentences(page, served):
    page.goto(f"{served}/#statement=a")
    page.locator("#statement").fill("a" * 20_001)
    notice = page.locator("#notice").get_by_text("Your work is kept.")
    notice.wait_for()
    assert re.fullmatch(r"A statement has .*, this one 20001\. Your.*", notice.inner_text())


def test_without_a_network_the_work_is_kept(open_, complaints):
    page = open_(WALL)
    page.route("**/api/check", lambda route: route.abort())
    page.locator("#statement").fill(CORNER)
    page.locator("#notice", has_text="Your work is kept").wait_for()
    assert typed(page) == CORNER
    page.unroute("**/api/check")
    page.get_by_role("button", name="Try again").click()
    page.locator("#answers", has_text="speed of P").wait_for()
    complaints[:] = [said for said in complaints if "ERR_FAILED" not in said]


# --- hostile texts --------------------------------------------------------------------------------


def test_no_text_becomes_markup(open_):
    bad = "<img src=x onerror=alert(1)><script>alert(2)</script>"
    page = open_(f"title {bad}\n{WALL.split(chr(10), 1)[1]}# {bad}\n")
    assert page.locator("#title").inner_text() == bad
    page.get_by_text("The question in words").click()
    assert page.locator("main img[src=x], main script:not([type])").count() == 0
    page.locator("#statement").fill(f"{bad}\n")
    page.locator("#mistakes .mistake").first.wait_for()
    assert page.locator("img[src=x]").count() == 0


# --- for everyone ---------------------------------------------------------------------------------


def test_the_keyboard_alone(open_):
    page = open_(WALL)

    def tab_to(*names: str) -> None:
        for _ in range(60):
            page.keyboard.press("Tab")
            here = page.evaluate(
                "() => document.activeElement.ariaLabel || document.activeElement.textContent"
            )
            if here.strip() in names:
                return
        raise AssertionError(f"{names} cannot be reached")

    tab_to("New")
    page.keyboard.press("Enter")
    assert page.evaluate("() => document.activeElement.id") == "statement"
    for line in WALL.splitlines():
        page.keyboard.type(line)
        page.keyboard.press("Escape")
        page.keyboard.press("Enter")
    page.locator("#answers li", has_text="angle of deflection").wait_for()
    assert "e = " in page.locator("#spoken").text_content()
    tab_to("Line by line")
    page.keyboard.press("Enter")
    assert page.evaluate("() => document.activeElement.textContent") == "Next line"
    page.keyboard.press("Enter")
    assert page.locator("#working .progress").inner_text().startswith("line 2 of ")


def test_the_keyboard_alone_from_the_choice_on(opening):
    page = opening

    def tab_to(name: str) -> None:
        for _ in range(60):
            page.keyboard.press("Tab")
            if page.evaluate("() => document.activeElement.textContent").strip() == name:
                return
        raise AssertionError(f"{name} cannot be reached")

    tab_to("Skip to the content")
    page.keyboard.press("Enter")
    tab_to("Greatest and least values")
    page.keyboard.press("Enter")
    gallery = page.get_by_role("dialog", name="Examples")
    expect(gallery.locator("[data-topic='Greatest and least values'] button").first).to_be_focused()
    page.keyboard.press("Escape")
    assert (
        page.evaluate("() => document.activeElement.dataset.topic") == "Greatest and least values"
    )
    page.keyboard.press("Shift+Tab")
    page.keyboard.press("Enter")
    expect(gallery.locator("[data-topic='Ranges of values'] button").first).to_be_focused()
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    solved(page)
    assert page.evaluate("() => document.activeElement.id") == "statement"
    page.keyboard.press("Control+Home")
    page.keyboard.type("spher ")
    page.keyboard.press("Escape")
    page.locator("#mistakes .mistake").wait_for()
    tab_to(page.locator("#mistakes .mistake").text_content().strip())
    page.keyboard.press("Enter")
    page.keyboard.press("Delete")
    page.keyboard.press("Delete")
    solved(page)


def test_fingers_alone(browser, served):
    with browser.new_context(
        has_touch=True, is_mobile=True, viewport={"width": 390, "height": 844}
    ) as touched:
        page = touched.new_page()
        with minding(page, served):
            page.goto(served + "/")
            page.get_by_role("button", name="Two spheres", exact=True).first.tap()
            page.locator("#filling form").wait_for()
            page.go_back()
            page.get_by_role("button", name="Impulse and kinetic energy").tap()
            gallery = page.get_by_role("dialog", name="Examples")
            gallery.get_by_role("button", name="The share of the kinetic energy").tap()
            solved(page)
            page.get_by_role("button", name="Line by line").tap()
            page.get_by_role("button", name="Next line").tap()
            assert page.locator("#working .progress").inner_text().startswith("line 2 of ")
            page.get_by_role("button", name="New", exact=True).tap()
            page.get_by_role("button", name="All ways to begin").tap()
            page.get_by_role("link", name="for students").tap()
            page.get_by_role("heading", level=1, name="The page").wait_for()
            height = "all => all.map((each) => each.getBoundingClientRect().height)"
            assert min(page.locator("nav a").evaluate_all(height)) >= 24


def test_axe_finds_nothing_in_the_choice(opening):
    page = opening
    for colours, width in (("light", 390), ("dark", 1280)):
        page.set_viewport_size({"width": width, "height": 800})
        page.emulate_media(color_scheme=colours)
        accessible(page)
    page.get_by_role("button", name="Write a question of your own").click()
    accessible(page)
    page.keyboard.insert_text("spher A\n")
    page.locator("#mistakes .mistake").wait_for()
    for colours in ("light", "dark"):
        page.emulate_media(color_scheme=colours)
        accessible(page)


@pytest.mark.parametrize("width", [360, 1920])
def test_axe_finds_nothing_in_fractions_and_headings(open_, width):
    """High fractions in long lines, sections with and without parts, an earlier solution."""
    page = open_(CORNER + "find energy_lost/energy(0) as a percentage, deflection(P)\n")
    page.set_viewport_size({"width": width, "height": 800})
    page.evaluate("() => document.fonts.ready")
    accessible(page)
    page.locator("#statement").fill(CORNER + "find speed(P")
    page.locator("#mistakes .mistake").wait_for()
    accessible(page)


def test_axe_finds_nothing(open_):
    page = open_()
    page.locator("#motion").scroll_into_view_if_needed()
    page.locator("#motion .stage circle").first.wait_for()
    page.get_by_role("button", name="Line by line").click()
    # Colours do not depend on the width, nor the layout on the colours.
    for colours, width in (("light", 360), ("dark", 1280)):
        page.set_viewport_size({"width": width, "height": 800})
        page.emulate_media(color_scheme=colours)
        accessible(page)


def test_the_page_never_scrolls_sideways(open_):
    page = open_(CORNER)
    enlarge_text(page)
    for width, height in SCREENS:
        page.set_viewport_size({"width": width, "height": height})
        assert not too_wide(page), width


def test_the_choice_never_scrolls_sideways(opening):
    enlarge_text(opening)
    for width, height in SCREENS:
        opening.set_viewport_size({"width": width, "height": height})
        assert not too_wide(opening), width


# --- the words of the editor ----------------------------------------------------------------------


def test_the_vocabulary_is_that_of_the_language():
    words = vocabulary()
    assert {each["word"] for each in words["quantities"]} == set(QUANTITIES)
    described = [each for kind in words["properties"].values() for each in kind]
    known = " ".join(f"{each['word']} {each['about']}" for each in described)
    assert set(PROPERTY_WORDS) <= set(re.findall(r"\w+", known))


def test_every_example_of_a_line_reads():
    begun = {
        "given": "sphere A: velocity u at alpha\n",
        "let": "wall W: along i\nsphere P: velocity u i - u j\nP hits W\n",
        "find": "sphere P: mass 1, velocity u i\n",
        "show": "sphere P: mass 1, velocity u i\n",
        "unknown": "",
    }
    for line in vocabulary()["lines"]:
        before = begun.get(line["word"], "")
        parse(before + line["example"] + "\n")
    spheres = "sphere A: velocity i\nsphere B: velocity j\nsphere P: mass 1, velocity i\n"
    for event in vocabulary()["events"]:
        parse(spheres + event["example"] + "\n")
