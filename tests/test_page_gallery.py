"""The gallery of examples: its data, its pictures, and the part of the page that shows them."""

from __future__ import annotations

import gzip
import re
import xml.etree.ElementTree as ET
from functools import partial

import httpx
import pytest
from hosts import hosted, told
from pages import accessible, minding, too_wide
from playwright.sync_api import Page, expect

import restitution
from restitution import examples
from restitution.drawing import scenes, thumbnail
from restitution.drawing.ink import ink
from restitution.drawing.svg import to_svg
from restitution.examples.topics import TOPICS

get = partial(httpx.get, timeout=100)


def solved(name: str):
    return restitution.solve(restitution.parse(examples.text(name)))


# --- topics ---------------------------------------------------------------------------------------


def test_every_example_has_one_topic() -> None:
    listed = [name for names in TOPICS.values() for name in names]
    assert sorted(listed) == list(examples.names())
    assert all(len(names) >= 3 for names in TOPICS.values())


@pytest.mark.parametrize("name", examples.names())
def test_an_example_without_its_answers_states_the_same(name: str) -> None:
    shown = examples.statement(name)
    assert restitution.parse(shown) == restitution.parse(examples.text(name))
    assert "#=" not in shown and "source" not in shown
    assert examples.title(name) and examples.title(name) != name


# --- pictures -------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [names[0] for names in TOPICS.values()])
def test_a_thumbnail_is_small_and_has_what_moves(name: str) -> None:
    solution = solved(name)
    picture = thumbnail(solution)
    assert picture is not None and not picture.labels
    whole = scenes(solution)[0]
    kinds = {"StraightWall", "RoundWall", "Disc", "Dot"}
    assert sum(type(each).__name__ in kinds for each in picture.shapes) == sum(
        type(each).__name__ in kinds for each in whole.shapes
    )
    left, bottom, right, top = picture.box
    for piece in (piece for shape in picture.shapes for piece in ink(shape)):
        x0, y0, x1, y1 = piece.box
        assert left <= x0 <= x1 <= right and bottom <= y0 <= y1 <= top
    svg = to_svg(picture)
    ET.fromstring(svg)
    assert len(gzip.compress(svg.encode())) < 3000


# --- what is served -------------------------------------------------------------------------------


def test_the_list_has_all_examples_in_the_order_of_teaching(served: str) -> None:
    reply = get(served + "/examples.json")
    found = reply.json()["examples"]
    assert [each["name"] for each in found] == [n for names in TOPICS.values() for n in names]
    assert {each["topic"] for each in found} == set(TOPICS)
    assert found[0]["statement"].startswith("title A wall, with vectors\nwall W: along i\n")
    assert len(gzip.compress(reply.content)) < 12_000


def test_pictures_are_served_and_kept(served: str) -> None:
    address = served + "/thumbnails/corner.svg"
    reply = get(address)
    assert reply.headers["content-type"] == "image/svg+xml"
    assert "max-age" in reply.headers["cache-control"]
    assert reply.text == to_svg(thumbnail(solved("corner")))
    again = get(address, headers={"If-None-Match": reply.headers["etag"]})
    assert (again.status_code, again.content) == (304, b"")
    assert get(served + "/thumbnails/..%2Fcorner.svg").status_code == 404
    assert get(served + "/thumbnails/no-such.svg").status_code == 404


def test_examples_have_pictures_and_no_placeholders(served: str) -> None:
    for name in ("corner", "wall-with-vectors", "centres-given"):
        assert "aria-labelledby" in get(f"{served}/thumbnails/{name}.svg").text


# --- the gallery ----------------------------------------------------------------------------------


@pytest.fixture
def gallery(page: Page, served: str) -> Page:
    with minding(page, served):
        hosted(page, served, "gallery", "mountGallery")
        expect(page.get_by_role("status")).to_have_text(f"{len(examples.names())} examples")
        yield page


def test_examples_stand_under_their_topics_with_pictures(gallery: Page) -> None:
    headings = gallery.get_by_role("heading", level=3).all_inner_texts()
    assert headings == list(TOPICS)
    picture = gallery.locator("img").first
    expect(picture).to_have_js_property("complete", True)
    assert picture.evaluate("image => image.naturalWidth") > 0
    assert gallery.locator("img[loading=lazy]").count() == len(examples.names())


def test_typing_narrows_the_list_and_enter_chooses(gallery: Page) -> None:
    gallery.keyboard.press("Tab")
    gallery.keyboard.type("CORNER energy")
    expect(gallery.get_by_role("status")).to_have_text(re.compile(r"^\d examples$"))
    assert "corner-energy" in " ".join(
        gallery.locator("li:visible img").evaluate_all("all => all.map((each) => each.src)")
    )
    gallery.keyboard.type(" 36")
    expect(gallery.get_by_role("status")).to_have_text("1 example")
    gallery.keyboard.press("Tab")
    gallery.keyboard.press("Enter")
    assert told(gallery) == [["chosen", "corner-energy", examples.statement("corner-energy")]]
    gallery.get_by_role("searchbox").fill("no such thing")
    expect(gallery.get_by_role("status")).to_have_text("No example has all these words.")
    expect(gallery.locator("h3:visible")).to_have_count(0)


def test_it_goes_from_one_column_to_four(gallery: Page) -> None:
    columns = {}
    for width in (320, 700, 1000, 1920):
        gallery.set_viewport_size({"width": width, "height": 900})
        lefts = gallery.locator("section:first-child li").evaluate_all(
            "all => all.map((each) => Math.round(each.getBoundingClientRect().left))"
        )
        columns[width] = len(set(lefts))
        assert not too_wide(gallery)
    assert columns == {320: 1, 700: 3, 1000: 4, 1920: 4}


def test_anyone_can_use_it(gallery: Page) -> None:
    for scheme in ("light", "dark"):
        gallery.emulate_media(color_scheme=scheme)
        accessible(gallery)


def test_a_server_that_fails_is_told_and_asked_again(page: Page, served: str) -> None:
    page.route("**/examples.json", lambda route: route.fulfill(status=503), times=1)
    hosted(page, served, "gallery", "mountGallery")
    expect(page.get_by_role("status")).to_have_text("The examples cannot be loaded just now.")
    page.get_by_role("button", name="Try again").click()
    expect(page.get_by_role("status")).to_have_text(f"{len(examples.names())} examples")
