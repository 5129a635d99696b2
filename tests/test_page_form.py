"""The form that writes a statement: every statement it writes reads well, and it can be used."""

from __future__ import annotations

import itertools
from typing import Any

import pytest
from answers import Expected, disagreements
from hosts import hosted, static_of, told
from pages import accessible, enlarge_text, minding, too_wide
from playwright.sync_api import Page, expect

import restitution
from restitution.errors import RestitutionError

KINDS = ("wall", "walls", "spheres", "chain")
WALLS = ("i", "j", "vector", "angle")
OF_WALLS = {
    "wall": {
        "wall": (*WALLS, "unknown"),
        "PVelocity": ("components", "wall", "speed", "unknown"),
        "PX": ("u", "3 - sqrt(2)", "-2u cos(alpha)"),
        "PMass": ("", "3m"),
        "e1": ("", "1/3"),
        "PAngle": ("60", "alpha"),
    },
    "walls": {
        "first": ("i", "j", "angle"),
        "second": ("between", *WALLS),
        "between": ("120", "90° + theta"),
        "PVelocity": ("components", "wall", "speed"),
        "e2": ("", "f"),
    },
}
OF_SPHERES = {
    "spheres": {
        "line": (*WALLS, "offset", "unknown"),
        "AVelocity": ("components", "speed", "rest", "unknown"),
        "BVelocity": ("components", "speed", "rest", "unknown"),
        "BAngle": ("60° from -i", "0.5"),
        "BMass": ("", "k m"),
    },
    "chain": {
        "line": ("i", "angle", "offset"),
        "wall": (*WALLS, "unknown"),
        "BVelocity": ("components", "rest"),
        "e1": ("", "1/3"),
    },
}
CHOICES: dict[str, dict[str, tuple[str, ...]]] = {**OF_WALLS, **OF_SPHERES}


@pytest.fixture(scope="module")
def writer(browser: Any, served: str):
    """Asks ``form-statement.js`` itself: (function, answers of each question) → its results."""
    page = browser.new_page()
    page.goto(served + "/health")
    address = f"{served}/{static_of(served)}/solve/form-statement.js"

    def ask(function: str, kind: str, changes: list[dict[str, Any]]) -> list[Any]:
        found: list[Any] = page.evaluate(
            """async ([address, name, kind, changes]) => {
              const module = await import(address);
              return changes.map((each) => module[name]({ ...module.defaultsOf(kind), ...each }));
            }""",
            [address, function, kind, changes],
        )
        return found

    yield ask
    page.close()


def combinations(kind: str) -> list[dict[str, str]]:
    choices = CHOICES[kind]
    return [dict(zip(choices, each)) for each in itertools.product(*choices.values())]


@pytest.mark.parametrize("kind", KINDS)
def test_whatever_is_chosen_reads_well(writer, kind: str) -> None:
    changes = combinations(kind)
    assert len(changes) >= 60
    for change, text in zip(changes, writer("statementOf", kind, changes)):
        try:
            restitution.parse(text)
        except RestitutionError as error:  # pragma: no cover
            pytest.fail(f"{change}\n{text}\n{error}")


@pytest.mark.parametrize("kind", KINDS)
def test_everything_that_can_be_asked_or_known_reads_well(writer, kind: str) -> None:
    blank = {"e1": "", "e2": "", "PMass": "", "AMass": "", "BMass": ""}
    (quantities,) = writer("quantitiesOf", kind, [blank])
    assert len(quantities) >= 8
    asked = [{**blank, "asked": [each["item"]]} for each in quantities]
    for change, text in zip(asked, writer("statementOf", kind, asked)):
        assert text.rstrip().endswith(f"find {change['asked'][0]}")
        restitution.parse(text)
    values = {"vector": "2i + 3j", "angle": "30"}
    facts = [
        {"what": each["item"], "value": next((v for k, v in values.items() if each.get(k)), "1/2")}
        for each in quantities
        if not each.get("fixed")
    ]
    (others,) = writer("factsOf", kind, [{}])
    facts += [{"what": fact, "value": ""} for fact, _ in others]
    facts.append({"what": "fact", "value": "tan(alpha) = 3/4"})
    known = [{"known": [fact]} for fact in facts]
    for change, text in zip(known, writer("statementOf", kind, known)):
        assert text.count("given ") == 1, change
        assert "= 30\n" not in text  # a number of degrees, not of radians
        restitution.parse(text)


FULL: list[tuple[str, dict[str, Any], dict[str, str]]] = [
    # worked by hand: the first view of each kind, and one question of each textbook shape
    ("wall", {}, {"velocity(P)": "5i + 3/2 j", "impulse": "9", "energy_lost": "27/4"}),
    (
        "wall",
        {"PVelocity": "wall", "PSpeed": "u", "PAngle": "60", "e1": "1/3", "PMass": "m"}
        | {"asked": ["speed(P)", "deflection(P)", "impulse"]},
        {"speed(P)": "u/sqrt(3)", "deflection(P)": "90°", "impulse": "2 sqrt(3)/3 m u"},
    ),
    (
        "wall",
        {"wall": "vector", "PX": "7", "PY": "1", "e1": "3/5", "asked": ["velocity(P)"]},
        {"velocity(P)": "3/5 i + 29/5 j"},
    ),
    ("walls", {}, {"speed(P, 1)": "sqrt(7)/4 u", "speed(P)": "sqrt(103)/16 u"}),
    (
        "spheres",
        {},
        {"velocity(A)": "3i + 2j", "velocity(B)": "2i - j", "impulse": "12"},
    ),
    (
        "spheres",
        {"AMass": "3m", "BMass": "2m", "AX": "u", "AY": "0", "BX": "-2u", "BY": "0"}
        | {"line": "offset", "offset": "1.6r", "e1": "1/6", "asked": ["impulse"]},
        {"impulse": "63/25 m u"},
    ),
    (
        "chain",
        {},
        {"velocity(A, 1)": "2/5 i", "velocity(B)": "-6/5 i", "total_energy_lost": "342/25"},
    ),
]


@pytest.mark.parametrize(("kind", "change", "answers"), FULL)
def test_what_is_told_in_full_is_solved(writer, kind, change, answers) -> None:
    (text,) = writer("statementOf", kind, [change])
    solution = restitution.solve(restitution.parse(text))
    wanted = [Expected(0, item, answer) for item, answer in answers.items()]
    assert disagreements(solution, wanted) == [], text


def test_what_is_unknown_is_found(writer) -> None:
    change = {
        "e1": "",
        "known": [{"what": "deflection(P)", "value": "90"}],
        "PVelocity": "wall",
        "PSpeed": "u",
        "PAngle": "60",
        "asked": ["e"],
    }
    (text,) = writer("statementOf", "wall", [change])
    assert "given deflection(P) = 90°\nfind e\n" in text
    solution = restitution.solve(restitution.parse(text))
    assert disagreements(solution, [Expected(0, "e", "1/3")]) == []


# --- the form in the browser ----------------------------------------------------------------------


@pytest.fixture
def form(page: Page, served: str) -> Page:
    with minding(page, served):
        hosted(page, served, "form", "mountForm")
        expect(page.get_by_role("radio")).to_have_count(4)
        yield page


def latest(page: Page) -> str:
    return told(page)[-1][1]


def test_nothing_is_overwritten_before_something_is_filled_in(form: Page) -> None:
    assert told(form) == []
    assert "velocity 5i - 3j" in form.locator("pre").inner_text()
    form.get_by_role("button", name="Put it into the editor").click()
    assert latest(form) == form.locator("pre").inner_text() + "\n" * (
        not form.locator("pre").inner_text().endswith("\n")
    )


def test_the_statement_grows_as_fields_are_filled_in(form: Page) -> None:
    form.get_by_label("Mass").fill("m")
    form.get_by_label("Velocity before").select_option("by its speed and angle to W")
    form.get_by_label("Speed", exact=True).fill("u")
    form.get_by_label("Angle to W").fill("alpha")
    form.get_by_label("e (if told)").fill("")
    form.get_by_label("coefficient of restitution e").check()
    form.get_by_label("It is known that").select_option("angle of deflection of P")
    form.get_by_label("is equal to").fill("90")
    form.get_by_role("button", name="Another fact").click()
    form.get_by_label("and that").select_option(label="another fact, such as tan(alpha) = 3/4")
    form.get_by_label("The fact").fill("tan(alpha) = 2")
    assert latest(form) == (
        "wall W: along i\n"
        "sphere P: mass m, velocity u at alpha to W\n"
        "P hits W\n"
        "given deflection(P) = 90°\n"
        "given tan(alpha) = 2\n"
        "find velocity(P), impulse, energy_lost, e\n"
    )
    form.get_by_label("Two spheres").check()
    expect(form.get_by_role("group", name="The line of centres")).to_be_visible()
    form.get_by_label("One wall").check()  # what was filled in there is still there
    expect(form.get_by_label("Angle to W")).to_have_value("alpha")


def test_a_mistake_is_told_at_its_field(form: Page) -> None:
    field = form.get_by_label("j component")
    for wrong, said in (("-3)", ")"), ("-3 + sphere", "sphere"), ("-3 m/s", "Leave out the unit")):
        field.fill(wrong)
        problem = form.locator("#problem-PY")
        expect(problem).to_contain_text(said)  # the server's own words, or the form's
        expect(field).to_have_attribute("aria-invalid", "true")
        assert "problem-PY" in field.get_attribute("aria-describedby")
    field.fill("-3")
    expect(problem).to_be_empty()
    assert field.get_attribute("aria-invalid") is None
    form.get_by_label("e (if told)").fill("1/")
    expect(form.locator("#problem-e1")).not_to_be_empty()
    form.get_by_label("e (if told)").fill("1/2")
    form.get_by_label("Mass").fill("2 # a comment")
    expect(form.locator("#problem-PMass")).to_contain_text("Leave out")
    assert "#" not in latest(form)
    form.get_by_label("velocity of P afterwards").uncheck()
    form.get_by_label("magnitude of the impulse").uncheck()
    form.get_by_label("kinetic energy lost", exact=True).uncheck()
    expect(form.locator("#problem-asked")).to_have_text("Choose at least one thing to find.")


def test_keyboard_alone_fills_it_in(form: Page) -> None:
    form.keyboard.press("Tab")
    expect(form.get_by_label("One wall")).to_be_focused()
    form.keyboard.press("ArrowRight")
    expect(form.get_by_label("Two walls")).to_be_focused()
    expect(form.get_by_label("Two walls")).to_be_checked()
    assert "P hits BC: e = 1/2" in latest(form)
    for _ in range(2):
        form.keyboard.press("Tab")
    expect(form.get_by_label("BC runs")).to_be_focused()
    form.keyboard.press("ArrowDown")
    expect(form.get_by_label("BC runs")).to_be_focused()  # though all fields were made anew
    assert "wall BC: along i\n" in latest(form)
    form.keyboard.press("Enter")


def test_it_fits_a_small_phone(form: Page) -> None:
    kinds = ("One wall", "Two walls", "Two spheres", "Spheres, then a wall")
    form.set_viewport_size({"width": 320, "height": 600})
    for kind in kinds:
        form.get_by_label(kind, exact=True).check()
        assert not too_wide(form), kind
        small = form.locator("select, input[type=text], button").evaluate_all(
            "all => all.filter((each) => each.getBoundingClientRect().height < 38).length"
        )
        assert small == 0, kind
    enlarge_text(form)
    form.set_viewport_size({"width": 640, "height": 600})
    for kind in kinds:
        form.get_by_label(kind, exact=True).check()
        assert not too_wide(form), kind


def test_anyone_can_use_it(form: Page) -> None:
    # Both kinds of fields, both schemes: colours do not depend on what is asked.
    for kind, scheme in (("Two walls", "light"), ("Two spheres", "dark")):
        form.emulate_media(color_scheme=scheme)
        form.get_by_label(kind).check()
        form.get_by_label("Mass").first.fill("2 kg")
        expect(form.locator("[aria-invalid]")).to_have_count(1)
        accessible(form)
