"""The page that plays a motion, in a real browser: what it shows, does, says and leaves alone."""

from __future__ import annotations

import json
import math
import re
from html import unescape
from importlib.resources import files
from pathlib import Path

import pytest
from pages import SCREENS, enlarge_text, minding, still, too_wide

import restitution as r
from restitution.export.player import module, play, source, to_html
from restitution.export.player.data import of_motion
from restitution.motion.pieces import Motion, Piece, Track, WallLine
from restitution.vector import Vector

TWO_SPHERES = """\
title Two spheres & a <b>bold</b> claim
sphere A: mass 2, velocity 3i - 4j
sphere B: mass 3, velocity 2i + 3j
A hits B: along j, e = 3/7
find velocity(A), velocity(B)
"""
CORNER = """\
wall AB: along i
wall BC: along 60°
sphere P: velocity u at 60° to AB
P hits AB: e = 1/2
P hits BC: e = 1/2
find speed(P)
"""
PARTS = """\
sphere A: mass 1, velocity 4i
sphere B: mass 1, at rest
part a
A receives 3j
find speed(A)
part b
A hits B: along i, e = 1/2
find velocity(B)
"""


def solved(text: str):
    return r.solve(r.parse(text))


@pytest.fixture
def opened(page, tmp_path):
    """Opens the page of a statement, and minds what it says and asks for behind the scenes."""
    page.emulate_media(reduced_motion="reduce")  # steps jump
    file = tmp_path / "motion.html"

    def open_(text: str, html: str | None = None):
        file.write_text(html or play(solved(text)).html, encoding="utf-8")
        page.goto(file.as_uri())
        page.wait_for_selector(".restitution-player .stage circle")
        return page

    with minding(page, file.as_uri()):
        yield open_


def clock(page) -> float:
    return float(page.locator(".clock").inner_text().removesuffix("s").replace("−", "-"))


def table(page, kind: str) -> dict[str, list[str]]:
    """Rows of a table by what stands before them."""
    rows = page.locator(f".{kind} tbody tr").all()
    return {
        row.locator("th").inner_text(): [cell.inner_text() for cell in row.locator("td").all()]
        for row in rows
    }


def centre(page, index: int) -> tuple[float, float]:
    circle = page.locator(".stage circle.sphere").nth(index)
    return float(circle.get_attribute("cx")), float(circle.get_attribute("cy"))


def arrows(page, kind: str) -> list[tuple[float, float]]:
    """The arrows that are seen, as vectors with y up, from the tail of each shaft to its tip."""
    found = []
    for arrow in page.locator(f".stage .arrow.{kind}:not(.came):not([visibility])").all():
        tail = re.findall(r"-?[\d.]+(?:e-?\d+)?", arrow.locator(".shaft").get_attribute("d"))[:2]
        tip = re.findall(r"-?[\d.]+(?:e-?\d+)?", arrow.locator(".head").get_attribute("d"))[:2]
        found.append((float(tip[0]) - float(tail[0]), float(tail[1]) - float(tip[1])))
    return found


# --- what it does -------------------------------------------------------------------------------


def test_steps_go_from_impact_to_impact(opened):
    page = opened(CORNER)
    start = clock(page)
    times = []
    for _ in range(3):
        page.get_by_role("button", name="Next impact").click()
        times.append(clock(page))
    assert start < times[0] < times[1] < times[2]
    page.get_by_role("button", name="Previous impact").click()
    assert clock(page) == times[1]
    page.get_by_role("button", name="Back to the start").click()
    assert clock(page) == start


def test_it_plays_and_pauses_and_stops_at_the_end(opened):
    page = opened(CORNER)
    assert clock(page) == 0
    page.get_by_role("button", name="Play").click()
    page.wait_for_function("parseFloat(document.querySelector('.clock').textContent) > 0.1")
    page.get_by_role("button", name="Pause").click()
    stopped = clock(page)
    still(page)
    assert clock(page) == stopped > 0.1
    page.keyboard.press("End")
    end = clock(page)
    page.keyboard.press(",")
    page.get_by_role("button", name="Play").click()
    page.get_by_role("button", name="Play").wait_for()
    assert clock(page) == end


def test_keys_alone_do_everything(opened):
    page = opened(PARTS)
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowRight")
    second = clock(page)
    page.keyboard.press("ArrowLeft")
    first = clock(page)
    page.keyboard.press(".")
    assert first < clock(page) < second
    page.keyboard.press(",")
    assert clock(page) == pytest.approx(first, abs=0.006)
    page.keyboard.press("Home")
    assert clock(page) == 0
    for key, name in (("s", "Slow motion"), ("v", "Velocities"), ("c", "Comp"), ("t", "Trails")):
        box = page.get_by_label(re.compile(name))
        assert box.is_checked()
        page.keyboard.press(key)
        assert not box.is_checked()
    page.keyboard.press("-")
    assert page.locator(".rate .said").inner_text() != "1×"
    page.keyboard.press("?")
    assert page.get_by_role("dialog").is_visible()
    page.keyboard.press("Escape")
    assert not page.get_by_role("dialog").is_visible()
    page.keyboard.press(" ")
    page.get_by_role("button", name="Pause").wait_for()
    page.keyboard.press(" ")
    page.get_by_role("button", name="Play").wait_for()


def test_every_control_is_reached_by_tab_and_its_focus_is_seen(opened):
    page = opened(PARTS)
    reached = []
    for _ in range(14):
        page.keyboard.press("Tab")
        reached.append(
            page.evaluate(
                "(() => { const e = document.activeElement; return [e.ariaLabel ?? e.textContent"
                " ?? '', e.tagName, getComputedStyle(e).outlineStyle] })()"
            )
        )
    tags = [tag for _, tag, _ in reached]
    assert tags.count("BUTTON") >= 5
    assert tags.count("INPUT") >= 6
    assert "SELECT" in tags
    assert all(outline != "none" for _, tag, outline in reached if tag in ("BUTTON", "SELECT"))


def test_slow_motion_is_slow_at_impacts_only(opened):
    page = opened(TWO_SPHERES)
    rates = page.evaluate(
        """async () => {
          const start = document.querySelector("script[type=module]").textContent;
          const code = start.slice(0, start.lastIndexOf("mount(")) ;
          const url = "data:text/javascript," + encodeURIComponent(code);
          const { mount } = await import(url);
          const data = JSON.parse(document.getElementById("motion").textContent);
          const root = document.body.appendChild(document.createElement("div"));
          const player = mount(root, data);
          const hit = player.motion.events[0].time;
          const slow = [player.clock.ease(player.motion.start), player.clock.ease(hit)];
          player.slow.box.click();
          const fast = [player.clock.ease(player.motion.start), player.clock.ease(hit)];
          player.destroy();
          return [slow, fast];
        }"""
    )
    (before, at), usual = rates
    assert before == 1
    assert at <= 0.1
    assert usual == [1, 1]


def test_parts_are_chosen(opened):
    page = opened(PARTS)
    choice = page.get_by_role("combobox")
    assert choice.locator("option").all_inner_texts() == ["Part (a)", "Part (b)"]
    assert page.locator(".marks span").count() == 2
    choice.select_option("Part (a)")
    assert page.locator(".marks span").count() == 1
    assert page.locator(".stage circle.sphere").count() == 1


# --- what it shows ------------------------------------------------------------------------------


def test_the_tables_say_what_is_true(opened):
    """By hand: A leaves with 3i + 2j, B with 2i − j; 24 J are lost."""
    page = opened(TWO_SPHERES)
    before = table(page, "values")
    assert before["velocity j m s⁻¹"][:2] == ["−4", "3"]
    assert before["kinetic energy J"] == ["25", "19.5", "44.5"]
    page.keyboard.press("ArrowRight")
    now = table(page, "values")
    assert now["velocity i m s⁻¹"][:2] == ["3", "2"]
    assert now["velocity j m s⁻¹"][:2] == ["2", "−1"]
    assert now["speed m s⁻¹"][:2] == ["√13 3.61", "√5 2.24"]
    assert before["momentum j N s"] == ["−8", "9", "1"]
    assert now["momentum j N s"] == ["4", "−3", "1"]
    assert now["kinetic energy J"] == ["13", "7.50", "20.5"]
    card = table(page, "card")
    # Towards B, which is below A: 4 becomes −2 for A, −3 becomes 1 for B.
    assert card["A along A → B"] == ["4", "−2"]
    assert card["B along A → B"] == ["−3", "1"]
    assert card["A perpendicular"] == ["3", "3"]
    assert "12 N s" in page.locator(".card p").inner_text()
    assert "24 J" in page.locator(".card p").inner_text()


def test_letters_have_exact_values_and_it_is_said_for_which_they_are_drawn(opened):
    page = opened(CORNER)
    assert page.locator(".drawn").inner_text() == "Drawn for u = 2."
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowRight")
    exact, decimal = table(page, "values")["speed m s⁻¹"][0].rsplit(" ", 1)
    assert exact == "√103 u/16"
    assert float(decimal) == pytest.approx(2 * math.sqrt(103) / 16, abs=0.005)
    assert page.locator(".values var").first.inner_text() == "u"


def test_the_picture_shows_what_the_tables_say(opened):
    page = opened(TWO_SPHERES)
    for key in ("Home", "ArrowRight", "End"):
        page.keyboard.press(key)
        said = table(page, "values")
        numbers = [
            [float(said[f"velocity {axis} m s⁻¹"][k].replace("−", "-")) for axis in "ij"]
            for k in (0, 1)
        ]
        drawn = arrows(page, "velocity")
        scales = [math.hypot(*v) / math.hypot(*w) for v, w in zip(drawn, numbers, strict=True)]
        assert scales[0] == pytest.approx(scales[1], rel=1e-3)
        for v, w in zip(drawn, numbers, strict=True):
            assert math.atan2(v[1], v[0]) == pytest.approx(math.atan2(w[1], w[0]), abs=1e-3)


def test_centres_are_two_radii_apart_at_the_impact(opened):
    page = opened(TWO_SPHERES)
    page.keyboard.press("ArrowRight")
    (ax, ay), (bx, by) = centre(page, 0), centre(page, 1)
    radius = float(page.locator(".stage circle.sphere").first.get_attribute("r"))
    assert (bx - ax, by - ay) == pytest.approx((0, 2 * radius), abs=0.01)


def test_components_are_seen_at_impacts_and_can_be_hidden(opened):
    page = opened(TWO_SPHERES)
    assert arrows(page, "component") == []
    page.keyboard.press("ArrowRight")
    shown = arrows(page, "component")
    assert len(shown) == 4
    for x, y in shown:
        assert min(abs(x), abs(y)) < 1e-6  # the line of centres is vertical
    assert page.locator(".stage .guide").get_attribute("d") != "M0 0"
    page.keyboard.press("c")
    assert arrows(page, "component") == []
    page.keyboard.press("v")
    assert arrows(page, "velocity") == []


def test_impacts_are_announced_and_nothing_else(opened):
    page = opened(CORNER)
    live = page.locator("[aria-live]")
    assert live.inner_text() == ""
    page.keyboard.press(".")
    assert live.inner_text() == ""
    page.keyboard.press("ArrowRight")
    assert live.inner_text().startswith("1: P hits AB")
    page.keyboard.press("ArrowRight")
    assert live.inner_text().startswith("2: P hits BC")


def test_steps_glide_for_those_who_mind_no_motion(opened):
    page = opened(CORNER)
    page.keyboard.press("ArrowRight")
    time = clock(page)
    page.keyboard.press("Home")
    page.emulate_media(reduced_motion="no-preference")
    page.keyboard.press("ArrowRight")
    assert clock(page) < time
    page.wait_for_function(f"parseFloat(document.querySelector('.clock').textContent) >= {time}")
    assert clock(page) == time


def test_a_crowd_is_played_too(opened):
    tracks = tuple(
        Track(f"S{k}", 0.2, 1.0, (Piece(0.0, 4.0, Vector(k % 6, k // 6), Vector(0.1, 0.02 * k)),))
        for k in range(30)
    )
    page = opened("", to_html(of_motion(Motion(tracks, (), (), 0.0, 4.0))))
    assert page.locator(".stage circle.sphere").count() == 30
    rows = table(page, "values")
    assert len(rows) == 31  # and the sum
    assert float(rows["all"][4]) == pytest.approx(3.0)  # momentum along i
    # What is scrolled is reached by the keyboard.
    assert page.locator(".values .scroll").get_attribute("tabindex") == "0"
    page.keyboard.press("End")
    assert clock(page) == 4


def test_what_a_user_wrote_is_no_markup(opened):
    page = opened(TWO_SPHERES)
    assert page.locator("h1").inner_text() == "Two spheres & a <b>bold</b> claim"
    assert page.locator("h1 b").count() == 0
    hostile = "</script><script>document.title = 'taken'</script><!--"
    motion = Motion(
        (Track(hostile, 0.1, 1.0, (Piece(0.0, 1.0, Vector(0.0, 0.0), Vector(1.0, 0.0)),)),),
        (),
        (WallLine(hostile, (Vector(0.0, -1.0), Vector(1.0, -1.0))),),
        0.0,
        1.0,
        (hostile,),
    )
    html = to_html(of_motion(motion, hostile))
    page = opened("", html)
    assert page.title() == hostile
    assert page.locator("script").count() == 2
    assert hostile in page.locator(".notes").inner_text()


def test_nothing_is_wider_than_the_screen(opened):
    page = opened(CORNER)
    page.keyboard.press("ArrowRight")
    for width, height in SCREENS:
        page.set_viewport_size({"width": width, "height": height})
        assert not too_wide(page), width
        stage = page.locator(".stage").bounding_box()
        assert stage["width"] <= width
        assert stage["height"] < 0.7 * height


def test_text_may_be_twice_as_large(opened, page):
    page.set_viewport_size({"width": 1280, "height": 800})
    opened(CORNER)
    enlarge_text(page)
    assert not too_wide(page)
    assert page.locator(".clock").evaluate("e => parseFloat(getComputedStyle(e).fontSize)") >= 30


def luminance(colour: str) -> float:
    parts = [int(x) / 255 for x in re.findall(r"\d+", colour)[:3]]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_contrast_is_enough(opened, scheme):
    page = opened(CORNER)
    page.emulate_media(color_scheme=scheme, reduced_motion="reduce")
    page.keyboard.press("ArrowRight")
    paper = page.locator(".restitution-player").evaluate("e => getComputedStyle(e).backgroundColor")
    for what in (".title", ".drawn", ".notes", ".unit", "caption", "thead th", ".values td"):
        for each in page.locator(what).all()[:2]:
            ink = each.evaluate("e => getComputedStyle(e).color")
            light, dark = sorted((luminance(ink), luminance(paper)), reverse=True)
            assert (light + 0.05) / (dark + 0.05) >= 4.5, what
    colours = page.locator(".restitution-player").evaluate(
        """e => [0, 1, 2, 3, 4, 5].map((k) => {
          const probe = e.appendChild(document.createElement("i"));
          probe.style.color = `var(--body${k})`;
          return getComputedStyle(probe).color;
        })"""
    )
    for each in colours:
        light, dark = sorted((luminance(each), luminance(paper)), reverse=True)
        assert (light + 0.05) / (dark + 0.05) >= 4.5, each


# --- without a browser --------------------------------------------------------------------------


def test_the_page_is_one_file_that_asks_for_nothing():
    html = play(solved(CORNER)).html
    assert re.findall(r"<(?:script|link|img|iframe)[^>]+(?:src|href)=", html) == []
    code = re.sub(r"^\s*//.*$", "", module(), flags=re.MULTILINE)
    assert not re.search(r"\bimport\b|\bfetch\b|XMLHttpRequest|WebSocket|eval\(", code)
    assert "innerHTML" not in html
    assert len(html) < 80_000


def test_modules_can_stand_together():
    """Joined into one, no two of them may give one name to two things."""
    folder = Path(str(files("restitution.export.player")))
    names = [
        name
        for file in sorted(folder.glob("*.js"))
        for name in re.findall(
            r"^(?:export )?(?:class|const|let|function) (\w+)", source(file.name), re.MULTILINE
        )
    ]
    assert len(names) > 20
    assert sorted(names) == sorted(set(names))
    for name in names:
        assert name in module()


def test_it_shows_itself_in_a_notebook():
    shown = play(solved(CORNER))._repr_html_()
    inside = re.match(r'<iframe title="Motion" sandbox="allow-scripts" srcdoc="([^"]*)"', shown)
    assert unescape(inside[1]) == play(solved(CORNER)).html


def test_the_data_are_plain():
    data = play(solved(PARTS), "b").data
    assert json.loads(json.dumps(data)) == data
    (motion,) = data["motions"]
    assert [event["kind"] for event in motion["events"]] == ["blow", "impact"]
    (a, b) = motion["spheres"]
    for one, other in zip(a["pieces"], a["pieces"][1:], strict=False):
        assert one[1] == other[0]
        assert one[2] + one[4] * (one[1] - one[0]) == pytest.approx(other[2])
    assert (a["mass"], b["mass"]) == (1.0, 1.0)


def test_a_simulation_is_played_too():
    spheres = [
        r.Sphere("A", mass=1, radius=0.1, position=(1, 1), velocity=(2, 1)),
        r.Sphere("B", mass=1, radius=0.1, position=(2, 1.5), velocity=(0, 0)),
    ]
    run = r.simulate(r.Table.box(3, 2, spheres, e="9/10"), impacts=8)
    (motion,) = play(run).data["motions"]
    assert [wall["name"] for wall in motion["walls"]] == ["Left", "Right", "Bottom", "Top"]
    assert [event["time"] for event in motion["events"]] == pytest.approx(run.events["time"])
    walls = {event["wall"] for event in motion["events"]}
    assert walls - {None} <= {"Left", "Right", "Bottom", "Top"}
    assert play(run).data == play(run.motion()).data


def test_what_has_no_path_is_refused():
    gas = r.Gas.fluid(3, 0.1, seed=1)
    with pytest.raises(TypeError, match="takes a Solution, a Motion or a Run, and not Gas"):
        r.play(gas)


def test_the_command_writes_the_page(tmp_path):
    from test_cli import run

    (tmp_path / "corner.impact").write_text(CORNER, encoding="utf-8")
    status, out, err = run("play", "corner.impact", cwd=tmp_path)
    assert (status, out) == (0, "")
    assert "corner-motion.html" in err
    text = Path(tmp_path / "corner-motion.html").read_text(encoding="utf-8")
    assert text == play(solved(CORNER)).html
    status, out, err = run("play", "-", "-o", "-", "--part", "a", stdin=PARTS.encode())
    assert (status, err) == (0, "")
    assert out.startswith("<!DOCTYPE html>")


def test_the_command_says_why_there_is_no_motion(tmp_path):
    from test_cli import run

    text = (
        "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W\n"
        "given velocity(P) = 3i + 8j\nfind e\n"
    )
    status, out, err = run("play", "-", stdin=text.encode(), cwd=tmp_path)
    assert (status, out) == (1, "")
    assert "no motion can be shown: e would be 2" in err
    assert list(tmp_path.iterdir()) == []
