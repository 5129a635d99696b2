"""The Lab in a real browser: it is edited, played, weighed, shared and turned into questions."""

from __future__ import annotations

import math
import re

import pytest
from pages import SCREENS, accessible, enlarge_text, minding, still, too_wide
from playwright.sync_api import expect

HEAD_ON = "spheres=A,2,0.1,0.5,0.5,2,0;B,1,0.1,1.5,0.5,0,0&e=0.5&seconds=2"
"""A, 2 kg at 2 m/s, strikes B, 1 kg at rest, e = 1/2: by hand A goes on at 1, B at 2 m/s.
Kinetic energy 4 J before, 3 J after; momentum 4 N s; they meet at 0.4 s."""

WALL = "spheres=P,1,0.1,1,0.6,3,-4&walls=W,0,0,4,0,0.5&e=1&seconds=0.5"
"""P comes down on a wall: 3i - 4j becomes 3i + 2j; 12.5 J become 6.5 J; the wall takes -6j N s."""


@pytest.fixture
def lab(page, served):
    """Opens the Lab with a scene, and minds what it says and asks for behind the scenes."""
    page.emulate_media(reduced_motion="reduce")  # steps jump
    page.set_viewport_size({"width": 1280, "height": 900})

    def open_(fragment: str):
        page.goto(f"{served}/lab#{fragment}")
        ready(page)
        return page

    with minding(page, served):
        yield open_


def until(page, what: str):
    """Waits until an expression holds."""
    # As a function: the page lets no text be run as a program.
    page.wait_for_function(f"() => {what}")


def ready(page):
    until(page, "document.getElementById('lab').lab?.known")


def scene(page) -> dict:
    return page.evaluate("document.getElementById('lab').lab.initial()")


def sphere(page, name: str) -> dict:
    return next(each for each in scene(page)["spheres"] if each["name"] == name)


def clock(page) -> float:
    return float(page.locator(".clock").inner_text().removesuffix("s").replace("−", "-"))


def place(page, kind: str, index: int = 0) -> tuple[float, float]:
    """The middle of a handle on the screen."""
    box = page.locator(f'[data-kind="{kind}"][data-index="{index}"]').bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def drag(page, start, by, steps=8):
    page.mouse.move(*start)
    page.mouse.down()
    page.mouse.move(start[0] + by[0], start[1] + by[1], steps=steps)
    page.mouse.up()


def scale(page) -> float:
    """Pixels to a metre."""
    return page.evaluate("document.getElementById('lab').lab.stage.view.k")


def said(page, row: int) -> str:
    return page.locator(".bar-row .said").nth(row).inner_text()


# --- editing --------------------------------------------------------------------------------------


def test_a_sphere_is_dragged_and_never_onto_another(lab):
    page = lab(HEAD_ON)
    k = scale(page)
    drag(page, place(page, "sphere"), (0.3 * k, -0.2 * k))
    x, y = sphere(page, "A")["position"]
    assert (x, y) == pytest.approx((0.8, 0.7), abs=0.02)
    drag(page, place(page, "sphere"), ((1.5 - x) * k, (y - 0.5) * k))  # onto B
    x, y = sphere(page, "A")["position"]
    assert math.dist((x, y), (1.5, 0.5)) >= 0.2 * (1 - 1e-9)
    ready(page)
    assert "cannot" not in page.locator(".note").inner_text()


def test_a_sphere_is_thrown_by_its_arrow(lab):
    page = lab(HEAD_ON)
    arrow = page.evaluate("document.getElementById('lab').lab.stage.view.arrow")
    drag(page, place(page, "tip"), (0, -arrow))  # 1 m/s more along j
    assert sphere(page, "A")["velocity"] == pytest.approx([2, 1], abs=0.05)
    # One at rest is chosen first, then its handle is there.
    page.locator('[data-kind="sphere"][data-index="1"]').click()
    drag(page, place(page, "tip", 1), (arrow, 0), steps=20)
    vx, vy = sphere(page, "B")["velocity"]
    assert vx > 0.5
    assert abs(vy) < vx


def test_the_keyboard_alone_moves_throws_adds_and_takes_away(lab):
    page = lab(HEAD_ON)
    step = page.evaluate("document.getElementById('lab').lab.stage.step")
    for _ in range(40):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.dataset?.kind") == "sphere":
            break
    assert page.evaluate("document.activeElement.getAttribute('aria-label')").startswith("A: mass")
    page.keyboard.press("ArrowUp")
    page.keyboard.press("Shift+ArrowLeft")
    assert sphere(page, "A")["position"] == pytest.approx([0.5 - 10 * step, 0.5 + step])
    page.keyboard.press("Enter")
    page.keyboard.press("Shift+ArrowDown")
    vx, vy = sphere(page, "A")["velocity"]
    assert vx == pytest.approx(2)
    assert vy < 0
    page.keyboard.press("0")
    assert sphere(page, "A")["velocity"] == [0, 0]
    page.get_by_role("button", name="Add a sphere").focus()
    page.keyboard.press("Enter")
    assert len(scene(page)["spheres"]) == 3
    # The new one has the focus.
    page.keyboard.press("Delete")
    assert [each["name"] for each in scene(page)["spheres"]] == ["A", "B"]
    page.get_by_role("button", name="Add a wall").focus()
    page.keyboard.press("Enter")
    before = scene(page)["walls"][0]
    page.keyboard.press("ArrowUp")
    after = scene(page)["walls"][0]
    assert after["start"][1] > before["start"][1]
    assert after["end"][1] > before["end"][1]
    page.keyboard.press("Enter")
    page.keyboard.press("ArrowUp")
    assert scene(page)["walls"][0]["start"][1] > after["start"][1]
    assert scene(page)["walls"][0]["end"] == after["end"]


def test_a_double_click_adds_a_sphere_and_a_button_takes_it_away(lab):
    page = lab(HEAD_ON)
    k = scale(page)
    x, y = place(page, "sphere")
    page.mouse.dblclick(x, y - 0.4 * k)
    assert sphere(page, "C")["position"] == pytest.approx([0.5, 0.9], abs=0.02)
    page.get_by_role("button", name="Take C away").click()
    assert [each["name"] for each in scene(page)["spheres"]] == ["A", "B"]


def test_walls_are_drawn_and_their_ends_moved(lab):
    page = lab(HEAD_ON)
    k = scale(page)
    page.get_by_role("button", name="Draw walls").click()
    x, y = place(page, "sphere")
    drag(page, (x, y + 0.2 * k), (1.0 * k, 0))
    (wall,) = scene(page)["walls"]
    assert wall["start"] == pytest.approx([0.5, 0.3], abs=0.02)
    assert wall["end"] == pytest.approx([1.5, 0.3], abs=0.02)
    # Another one from its end: it snaps, and the corner keeps together.
    drag(page, (x + k - 3, y + 0.2 * k + 3), (0.2 * k, -0.15 * k))
    first, second = scene(page)["walls"]
    assert second["start"] == first["end"]
    page.get_by_role("button", name="Move and throw").click()
    drag(page, place(page, "start", 1), (0.1 * k, 0.05 * k))
    first, second = scene(page)["walls"]
    assert second["start"] == first["end"] == pytest.approx([1.6, 0.25], abs=0.03)
    # No wall goes through a sphere.
    page.get_by_role("button", name="Draw walls").click()
    drag(page, (x, y - 0.25 * k), (0, 0.4 * k))
    assert len(scene(page)["walls"]) == 2
    assert "cannot go through" in page.locator(".note").inner_text()


def test_the_values_table_mirrors_the_picture_and_is_typed_in(lab):
    page = lab(HEAD_ON)
    page.get_by_label("mass of B, kg").fill("3/4")
    page.keyboard.press("Enter")
    assert sphere(page, "B")["mass"] == 0.75
    page.get_by_label("velocity j of A").fill("−1,5")
    page.keyboard.press("Tab")
    assert sphere(page, "A")["velocity"] == [2, -1.5]
    page.get_by_label("Velocity as").select_option("speed and direction")
    assert page.get_by_label("speed of A").input_value() == "2.5"
    page.get_by_label("direction from i of A").fill("90")
    page.keyboard.press("Tab")
    assert sphere(page, "A")["velocity"] == pytest.approx([0, 2.5], abs=1e-12)
    page.get_by_label("x of B").fill("0.6")
    page.keyboard.press("Tab")
    assert "B would overlap A" in page.locator(".note").inner_text()
    assert sphere(page, "B")["position"] == [1.5, 0.5]
    page.get_by_label("name of A").fill("Q1")
    page.keyboard.press("Tab")
    assert sphere(page, "Q1")["mass"] == 2
    page.get_by_label("Size follows mass").check()
    page.get_by_label("mass of Q1").fill("16")
    page.keyboard.press("Tab")
    assert sphere(page, "Q1")["radius"] == pytest.approx(0.2)
    page.get_by_label("e between spheres", exact=True).fill("0.25")
    page.keyboard.press("Tab")
    assert scene(page)["e"] == 0.25
    page.get_by_label("e between spheres", exact=True).fill("1.5")
    page.keyboard.press("Tab")
    assert scene(page)["e"] == 0.25
    assert "between 0 and 1" in page.locator(".note").inner_text()


@pytest.mark.parametrize(
    ("label", "quantity"), [("e between spheres", "e"), ("Duration in seconds", "seconds")]
)
def test_what_is_being_typed_outlasts_a_picture_drawn_anew(lab, label, quantity):
    """The motion comes from a worker, at any moment between two keys."""
    page = lab(HEAD_ON)
    page.get_by_label(label, exact=True).fill("0.25")
    page.evaluate("document.getElementById('lab').lab.draw()")
    page.keyboard.press("Tab")
    assert scene(page)[quantity] == 0.25


def test_another_scene_begins_with_nothing_to_undo(lab):
    """The step of a slider there does not belong to one of the same slider before."""
    page = lab("scene=snooker")
    slider = page.get_by_label("e between spheres, slider")
    slider.press("ArrowLeft")
    page.get_by_label("Scene", exact=True).select_option("newton")
    before = scene(page)
    slider.press("ArrowLeft")
    assert scene(page) != before
    page.get_by_role("button", name="Undo").click()
    assert scene(page) == before


def test_edits_are_undone_and_done_again(lab):
    page = lab(HEAD_ON)
    first = scene(page)
    page.get_by_role("button", name="Add a sphere").click()
    page.get_by_label("e between spheres, slider").press("ArrowLeft")
    page.get_by_label("e between spheres, slider").press("ArrowLeft")
    assert scene(page)["e"] == pytest.approx(0.48)
    page.locator("h1").evaluate("document.activeElement.blur()")
    page.keyboard.press("Control+z")  # both steps of the slider at once
    assert scene(page)["e"] == 0.5
    page.keyboard.press("Control+z")
    assert scene(page) == first
    page.keyboard.press("Control+y")
    assert len(scene(page)["spheres"]) == 3
    page.get_by_role("button", name="Undo").click()
    assert scene(page) == first


# --- playing --------------------------------------------------------------------------------------


def test_play_pause_step_restart_and_reset(lab):
    page = lab(HEAD_ON)
    page.get_by_role("button", name="Next impact").click()
    assert clock(page) == 0.4
    page.get_by_role("button", name="Next impact").click()
    assert clock(page) == 2
    page.get_by_role("button", name="Previous impact").click()
    assert clock(page) == 0.4
    page.emulate_media(reduced_motion="no-preference")
    page.get_by_role("button", name=re.compile("Restart")).click()
    until(page, "parseFloat(document.querySelector('.clock').textContent) > 0.05")
    page.get_by_role("button", name="Pause").click()
    stopped = clock(page)
    assert 0.05 < stopped < 0.4
    still(page)
    assert clock(page) == stopped
    page.emulate_media(reduced_motion="reduce")
    # Restart is not reset: what was edited stays, until it is put back.
    page.keyboard.press("Home")
    page.get_by_label("mass of A").fill("5")
    page.keyboard.press("Tab")
    ready(page)
    page.get_by_role("button", name=re.compile("Restart")).click()
    page.get_by_role("button", name="Pause").click()
    assert sphere(page, "A")["mass"] == 5
    page.get_by_role("button", name=re.compile("Reset")).click()
    assert sphere(page, "A")["mass"] == 2
    assert clock(page) == 0


def test_it_is_slow_at_impacts_and_can_be_slow_all_the_time(lab):
    page = lab(HEAD_ON)
    rates = page.evaluate(
        """() => { const { clock } = document.getElementById('lab').lab;
        const at = clock.ease(0.4), away = clock.ease(1.5); return [at, away]; }"""
    )
    assert rates[0] <= 0.1
    assert rates[1] == 1
    page.get_by_label(re.compile("^Slow motion")).uncheck()
    assert page.evaluate("document.getElementById('lab').lab.clock.ease(0.4)") == 1
    page.keyboard.press("-")
    assert float(page.locator(".rate .said").inner_text().rstrip("×")) < 1


def test_who_wants_little_motion_sees_steps(lab):
    page = lab(HEAD_ON)
    page.keyboard.press(" ")
    until(page, "document.querySelector('.clock').textContent === '0.40 s'")
    still(page)
    assert clock(page) == 0.4
    until(page, "document.querySelector('.clock').textContent === '2.00 s'")
    page.get_by_role("button", name="Play", exact=True).wait_for()


def test_what_is_moved_later_begins_there(lab):
    page = lab(HEAD_ON)
    page.keyboard.press("ArrowRight")
    assert clock(page) == 0.4
    k = scale(page)
    drag(page, place(page, "sphere"), (0, -0.3 * k))
    a, b = sphere(page, "A"), sphere(page, "B")
    assert a["position"] == pytest.approx([1.3, 0.8], abs=0.02)
    assert (a["velocity"], b["velocity"]) == ([1, 0], [2, 0])
    assert "as it was at 0.40 s" in page.locator(".note").inner_text()
    assert clock(page) == 0
    page.keyboard.press("Control+z")
    assert sphere(page, "A")["velocity"] == [2, 0]


def test_toggles_show_and_hide(lab):
    page = lab(HEAD_ON)
    page.keyboard.press("ArrowRight")
    shown = {
        "Velocities": ".arrow.velocity:not([visibility])",
        "Components": ".guide:not([d='M0 0'])",
        "Momenta": ".arrow.momentum:not([visibility])",
        "Impulses": ".arrow.share:not([visibility])",
        "Trails": ".trail:not([d='M0 0'])",
    }
    for label, what in shown.items():
        box = page.get_by_label(label, exact=True)
        box.check()
        assert page.locator(f".stage {what}").count() > 0, label
        box.uncheck()
        assert page.locator(f".stage {what}").count() == 0, label
    page.get_by_label("Speeds", exact=True).check()
    assert page.locator(".stage text.number", has_text=re.compile(r"^2$")).count() == 1
    page.get_by_label("Impulses", exact=True).check()
    assert page.locator(".stage .arrow.share:not([visibility])").count() == 2


def test_impacts_are_announced_and_nothing_else(lab):
    page = lab(HEAD_ON)
    live = page.locator("[aria-live]")
    page.keyboard.press(".")
    assert live.inner_text() == ""
    page.keyboard.press("ArrowRight")
    assert live.inner_text().startswith("1: A hits B at 0.40 s")


def test_the_last_of_impacts_that_follow_fast_is_announced(lab):
    page = lab("spheres=A,1,0.1,0.5,0.5,2,0;B,1,0.1,1,0.5,0,0;C,1,0.1,1.25,0.5,0,0&e=1&seconds=2")
    page.get_by_label("Slow motion at impacts").uncheck()
    page.get_by_role("button", name="Play", exact=True).click()
    expect(page.locator("[aria-live]")).to_contain_text(re.compile("^2: B hits C"))


def test_names_of_the_views_begin_with_what_stands_on_them(lab):
    page = lab(HEAD_ON)
    fit = page.get_by_role("button", name="Fit: see all of the table")
    assert fit.inner_text() == "Fit"


def test_numbers_before_and_after_stand_beside_the_picture(lab):
    page = lab(WALL)
    page.keyboard.press("ArrowRight")
    card = page.locator(".card").inner_text()
    assert "P towards W\t4\t−2" in card
    assert "P parallel to W\t3\t3" in card
    # By hand: tan α = 4/3, tan β = 2/3.
    assert "α = 53.1°" in card
    assert "β = 33.7°" in card
    assert "= 0.500 = e" in card


# --- what is conserved and what is lost -----------------------------------------------------------


def test_bars_conserve_momentum_and_lose_energy_between_spheres(lab):
    page = lab(HEAD_ON)
    assert said(page, 0) == "4 N s, conserved"
    assert said(page, 2) == "4 J, conserved"
    page.keyboard.press("ArrowRight")
    assert said(page, 0) == "4 N s, conserved"
    assert said(page, 1) == "0 N s, conserved"
    assert said(page, 2) == "3 J; 1 J lost of 4 J (25 %)"
    label = page.locator(".bar-row svg").first.get_attribute("aria-label")
    assert "A 2 N s, B 2 N s" in label
    energy = page.locator(".bar-row").nth(2)
    width = {
        kind: float(energy.locator(f".{kind}").get_attribute("width")) for kind in ("sum", "rest")
    }
    assert width["rest"] / width["sum"] == pytest.approx(1 / 3)


def test_walls_take_momentum(lab):
    page = lab(WALL)
    page.keyboard.press("ArrowRight")
    assert said(page, 0) == "3 N s, conserved"
    assert said(page, 1) == "2 N s and −6 N s taken by the walls: together −4 N s"
    assert said(page, 2) == "6.50 J; 6 J lost of 12.5 J (48 %)"


# --- scenes, links, questions ---------------------------------------------------------------------


def test_every_prepared_scene_opens_and_moves(lab):
    page = lab("scene=snooker")
    options = page.locator("#scenes option:not([hidden])").all()
    ids = [each.get_attribute("value") for each in options]
    assert ids[:6] == ["snooker", "corner", "newton", "angles", "gas", "break"]
    for name in ids:
        page.get_by_label("Scene", exact=True).select_option(name)
        ready(page)
        assert len(page.locator(".watch").inner_text()) > 20
        assert page.url.endswith(f"#scene={name}")
        page.keyboard.press("ArrowRight")
        assert clock(page) > 0
    page.go_back()
    until(page, "document.getElementById('scenes').value === 'break'")
    page.go_forward()
    until(page, "document.getElementById('scenes').value === 'empty'")


def test_the_address_keeps_the_scene(lab):
    page = lab("scene=angles")
    page.get_by_label("mass of P").fill("7")
    page.keyboard.press("Tab")
    ready(page)
    assert "spheres=" in page.url
    edited = scene(page)
    page.reload()
    ready(page)
    assert scene(page) == edited
    page.get_by_role("button", name=re.compile("Reset")).click()
    assert sphere(page, "P")["mass"] == 1
    assert page.url.endswith("#scene=angles")


def test_what_cannot_be_read_or_cannot_be_is_told(lab):
    page = lab("spheres=A,1,0.1&e=1")
    assert "no scene that can be read" in page.locator(".note").inner_text()


def test_bodies_that_overlap_are_told(page, served):
    page.goto(f"{served}/lab#spheres=A,1,0.5,0,0,0,0;B,1,0.5,0.2,0,0,0&e=1&seconds=1")
    page.locator(".note", has_text="A and B overlap").wait_for()


def test_an_impact_becomes_a_question(lab, served):
    page = lab(HEAD_ON)
    page.keyboard.press("ArrowRight")
    page.get_by_role("button", name="Make a question of this impact").click()
    page.wait_for_url(f"{served}/#statement=*")
    told = page.evaluate("new URLSearchParams(location.hash.slice(1)).get('statement')")
    assert "sphere A: mass 2, velocity 2i" in told
    assert "sphere B: mass 1, at rest" in told
    assert "A hits B: " in told


# --- for everyone ---------------------------------------------------------------------------------


def test_axe_finds_nothing(lab):
    page = lab("scene=angles")
    page.keyboard.press("ArrowRight")
    page.locator('[data-kind="sphere"]').first.focus()
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme, reduced_motion="reduce")
        accessible(page)


def test_nothing_is_wider_than_the_screen(lab):
    page = lab("scene=snooker")
    for width, height in SCREENS:
        page.set_viewport_size({"width": width, "height": height})
        assert not too_wide(page), width
        small = page.evaluate(
            """[...document.querySelectorAll("#lab button, #lab select, .handle .hit")]
            .map((node) => node.getBoundingClientRect()).filter((box) => box.width && box.height)
            .filter((box) => Math.max(box.width, box.height) < 24).length"""
        )
        assert small == 0, width
    enlarge_text(page)
    for width, height in SCREENS:
        page.set_viewport_size({"width": width, "height": height})
        assert not too_wide(page), width


def test_a_frame_of_fifty_spheres_makes_little_anew(lab, page):
    """What a frame puts into the page, arrows and trails on, does not grow with the table."""
    balls = ";".join(
        f"S{n},1,0.08,{0.3 + 0.4 * (n % 10):.2f},{0.3 + 0.4 * (n // 10):.2f},"
        f"{math.cos(n):.3f},{math.sin(n):.3f}"
        for n in range(50)
    )
    walls = "walls=B,0,0,4.2,0,1;R,4.2,0,4.2,2.2,1;T,4.2,2.2,0,2.2,1;L,0,2.2,0,0,1"
    lab(f"spheres={balls}&{walls}&e=1&seconds=6")
    assert page.get_by_label("Velocities", exact=True).is_checked()
    assert page.get_by_label("Trails", exact=True).is_checked()
    page.emulate_media(reduced_motion="no-preference")
    page.evaluate(
        """() => {
          window.made = [];
          new MutationObserver((records) => {
            window.made.push(records.reduce((sum, each) => sum + each.addedNodes.length, 0));
          }).observe(document.body, { subtree: true, childList: true });
          const { lab } = document.getElementById("lab");
          window.frames = 0;
          const draw = lab.draw.bind(lab);
          lab.draw = () => {
            window.frames += 1;
            draw();
          };
        }"""
    )
    page.keyboard.press(" ")
    until(page, "window.frames > 60")
    page.keyboard.press(" ")
    made = sorted(page.evaluate("window.made"))
    frames = page.evaluate("window.frames")
    assert sum(made[:-1]) / frames < 20, made


def focused(page) -> str:
    """What has the focus, by its accessible name or text."""
    return page.evaluate(
        """() => document.activeElement.getAttribute("aria-label")
        || document.activeElement.innerText"""
    )


def test_the_focus_is_never_lost(lab, page):
    lab(HEAD_ON + "&walls=W,3,0,3,1,0.5")
    page.locator('[data-kind="sphere"][data-index="1"]').focus()
    page.keyboard.press("Delete")
    until(page, "document.getElementById('lab').lab.initial().spheres.length === 1")
    assert focused(page).startswith("A: mass 2 kg")
    page.get_by_role("button", name="Undo").press("Enter")
    assert focused(page) == "Undo"
    page.keyboard.press("Enter")
    assert "nothing to undo" in page.locator(".note").inner_text()
    page.get_by_role("button", name="Take A away").press("Enter")
    assert focused(page) == "Take B away"


def test_a_field_that_was_wrong_is_right_again(lab, page):
    lab(HEAD_ON)
    field = page.get_by_label("mass of A, kg")
    field.fill("-1")
    field.press("Enter")
    assert field.get_attribute("aria-invalid") == "true"
    assert "is positive" in page.locator(".note").inner_text()
    field.fill("2")  # as it was
    field.press("Enter")
    assert field.get_attribute("aria-invalid") == "false"
    assert page.locator(".note").inner_text() == ""
    field.fill("20000000")
    field.press("Enter")
    assert "out of bounds" in page.locator(".note").inner_text()
    assert sphere(page, "A")["mass"] == 2
    field.fill("3/4")
    field.press("Enter")
    assert field.get_attribute("aria-invalid") == "false"
    assert sphere(page, "A")["mass"] == 0.75


@pytest.mark.parametrize("mass", ["1e308", "NaN", "Infinity", ""])
def test_numbers_of_an_address_have_bounds(lab, page, mass):
    lab(f"spheres=A,{mass},0.1,0.5,0.5,2,0&seconds=2")
    assert "no scene that can be read" in page.locator(".note").inner_text()


# --- measuring ------------------------------------------------------------------------------------


def measuring(lab, fragment: str = WALL):
    page = lab(fragment)
    page.get_by_role("button", name="Measure", exact=True).click()
    return page


def test_readings_without_error_give_the_e_of_the_wall(lab):
    page = measuring(lab)
    page.get_by_label("Error of an angle").select_option("0")
    page.get_by_role("button", name="Read all impacts").click()
    # 4 towards the wall and 3 along it become 2 and 3.
    assert page.get_by_label("α of trial 1").input_value() == "53.1"
    assert page.get_by_label("β of trial 1").input_value() == "33.7"
    expect(page.locator(".measure tbody td").nth(2)).to_have_text("0.501")
    expect(page.locator(".measure .outcome .value")).to_contain_text("e = 0.50", timeout=60_000)


def test_readings_have_the_error_that_is_chosen(lab):
    page = measuring(lab)
    page.get_by_label("Error of an angle").select_option("2")
    for _ in range(40):
        page.get_by_role("button", name="Read all impacts").click()
    fields = page.get_by_label(re.compile("^α of trial"))
    values = [float(each.input_value()) for each in fields.all()]
    assert len(values) == 40
    assert all(value == int(value) for value in values)
    mean = sum(values) / 40
    assert abs(mean - 53.13) < 5 * 2 / 40**0.5
    spread = math.sqrt(sum((value - mean) ** 2 for value in values) / 39)
    assert 1 < spread < 3.5  # chance leaves these less than once in 10⁵


def test_the_protractor_is_laid_moved_and_turned(lab):
    page = measuring(lab)
    page.evaluate("document.getElementById('lab').lab.step()")
    page.get_by_role("button", name="Lay the protractor").click()
    protractor = page.locator(".protractor")
    k = scale(page)
    label = protractor.get_attribute("aria-label")
    # P is 0.1 from the wall, 1 + 3 × 0.125 along it; the base line lies along the wall.
    assert "at 1.38, 0.100 m, its base line at 0°" in label
    protractor.focus()
    page.keyboard.press("PageUp")
    page.keyboard.press("Shift+ArrowRight")
    label = protractor.get_attribute("aria-label")
    assert f"at {1.375 + 30 / k:.3g}".rstrip("0") in label
    assert "base line at 1.00°" in label or "base line at 1°" in label
    box = page.locator(".protractor .knob .seen").bounding_box()
    start = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    drag(page, start, (0, -60))
    turned = re.search(r"base line at ([\d.]+)°", protractor.get_attribute("aria-label"))
    assert 5 < float(turned[1]) < 60


def test_trials_are_typed_kept_and_carried_to_the_experiment(lab):
    page = measuring(lab)
    for alpha, beta in (("30", "22"), ("45", "35,5"), ("60", "50")):
        page.get_by_role("button", name="Add a row").click()
        row = page.locator(".measure tbody tr").last
        row.locator("input").nth(0).fill(alpha)
        row.locator("input").nth(1).fill(beta)
    expect(page.locator(".measure .outcome .value")).to_contain_text("e = 0.7", timeout=60_000)
    page.reload()
    ready(page)
    page.get_by_role("button", name="Measure", exact=True).click()
    assert page.get_by_label("β of trial 2").input_value() == "35,5"
    page.get_by_role("link", name="Open in Experiment").click()
    expect(page.locator(".readings tbody tr")).to_have_count(3, timeout=60_000)


def test_an_unknown_coefficient_is_hidden_until_it_is_asked_for(lab):
    page = measuring(lab)
    page.get_by_role("button", name="A wall of unknown e").click()
    ready(page)
    (wall,) = scene(page)["walls"]
    assert 0.3 < wall["e"] < 1
    assert not page.get_by_label("e of all walls", exact=True).is_visible()
    page.get_by_role("button", name="Show e of the walls").click()
    expect(page.locator(".note")).to_contain_text(f"is {wall['e']}")
    assert page.get_by_label("e of all walls", exact=True).is_visible()


@pytest.mark.parametrize(("width", "height"), SCREENS)
def test_measuring_fits_every_screen(lab, width, height):
    page = measuring(lab)
    page.set_viewport_size({"width": width, "height": height})
    page.get_by_role("button", name="Read all impacts").click()
    assert not too_wide(page)
    accessible(page)
