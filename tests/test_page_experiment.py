"""The page of experiments: a table is pasted, read, opened from a file, shared; e stands beside."""

from __future__ import annotations

from urllib.parse import urlencode

import pytest
from pages import SCREENS, accessible, minding, too_wide
from playwright.sync_api import Page, expect

WALL = "alpha\tbeta\n30\t22\n45\t36\n60\t50\n50\t40\n"


@pytest.fixture
def experiment(page: Page, served: str):
    """Opens the page with something in its address."""
    page.emulate_media(reduced_motion="reduce")
    with minding(page, served) as said:

        def go(**fields: str) -> Page:
            page.goto(f"{served}/experiment#{urlencode(fields)}")
            if fields:
                answered(page)
            return page

        go.said = said
        yield go


def answered(page: Page) -> None:
    expect(page.locator("#results[aria-busy=false] .headline")).to_be_visible(timeout=60_000)


def test_a_pasted_table_gives_e_at_once(experiment) -> None:
    page = experiment()
    page.locator("#data").fill(WALL)
    answered(page)
    expect(page.locator(".headline .value")).to_contain_text("e = 0.7")
    expect(page.locator(".headline")).to_contain_text("With 95% confidence")
    expect(page.locator(".checks li")).to_have_count(5)
    assert page.locator(".readings tbody tr").count() == 4
    expect(page.locator(".pictures figure").first).to_be_visible()


def test_an_error_of_reading_changes_where_the_errors_are_from(experiment) -> None:
    page = experiment(data=WALL)
    expect(page.locator(".headline")).to_contain_text("estimated from the scatter")
    page.locator("#angle-error").fill("0,5")
    expect(page.locator(".headline")).to_contain_text("0.5°")
    page.locator("#angle-error").fill("-1")
    expect(page.locator("#notice")).to_contain_text("above 0")
    expect(page.locator("#angle-error")).to_have_attribute("aria-invalid", "true")


def test_numbers_without_a_header_are_given_one(experiment) -> None:
    page = experiment()
    page.locator("#data").fill("22\t30\n36\t45\n50\t60")
    expect(page.locator("#naming")).to_be_visible()
    page.get_by_label("Column 1").select_option("beta")
    page.get_by_label("Column 2").select_option("alpha")
    page.get_by_role("button", name="Put this header").click()
    answered(page)
    assert page.locator("#data").input_value().startswith("beta\talpha\n22\t30")
    expect(page.locator("#naming")).to_be_hidden()


def test_a_bad_row_is_named_and_a_bad_table_keeps_the_last_result(experiment) -> None:
    page = experiment(data=WALL + "50\tx\n")
    expect(page.locator("#results")).to_contain_text("line 6, column beta: 'x': this is no number")
    experiment.said.clear()
    page.locator("#data").fill("alpha\tbeta\nx\ty")
    expect(page.locator("#notice")).to_contain_text("Line 2: No row can be read")
    expect(page.locator(".headline")).to_be_visible()
    # A browser says of itself that a request was refused.
    assert all("422" in each for each in experiment.said)
    experiment.said.clear()


def test_a_link_carries_the_table_and_how_it_is_read(experiment) -> None:
    page = experiment()
    page.locator("#data").fill(WALL)
    page.locator("#angle-error").fill("2")
    page.locator("#from-normal").check()
    answered(page)
    value = page.locator(".headline .value").inner_text()
    page.wait_for_function("() => location.hash.includes('from_normal')")
    page.reload()
    answered(page)
    assert page.locator("#data").input_value() == WALL
    assert page.locator(".headline .value").inner_text() == value


def test_a_file_is_opened(experiment) -> None:
    page = experiment()
    content = ("\ufeff" + WALL.replace("\t", ";")).encode("utf-16")
    page.locator("#file").set_input_files(
        {"name": "class.csv", "mimeType": "text/csv", "buffer": content}
    )
    answered(page)
    assert page.locator(".readings tbody tr").count() == 4


def test_each_example_shows_what_it_is_for(experiment) -> None:
    page = experiment()
    examples = (("wall", None), ("rough", "Friction"), ("askew", "misses"), ("tracks", None))
    for example, verdict in examples:
        options = page.locator("#example option").all_inner_texts()
        (chosen,) = [i for i, each in enumerate(options) if example in each.split(",")[0].lower()][
            :1
        ]
        page.locator("#results").evaluate("(node) => node.replaceChildren()")
        page.locator("#example").select_option(index=chosen)
        answered(page)
        seen = page.locator(".checks .seen h4").all_inner_texts()
        assert len(seen) == (verdict is not None), (example, seen)
        assert all(verdict in each for each in seen)


def test_the_page_is_accessible_and_fits_every_screen(experiment) -> None:
    page = experiment(data=WALL)
    accessible(page)
    for width, height in SCREENS:
        page.set_viewport_size({"width": width, "height": height})
        assert not too_wide(page), width


def test_what_cannot_be_worked_out_is_a_dash(experiment) -> None:
    steep = "alpha\tbeta\n89.9\t89.8\n89.7\t89.2\n89.6\t89.3\n"
    page = experiment(data=steep, angle_error="0.01")
    cells = page.locator(".class-values td").all_inner_texts()
    assert cells[:2] == ["–", "–"]
    expect(page.locator(".class-values")).to_contain_text("All angles are nearly 90°.")
