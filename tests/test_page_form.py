"""The form: what it writes is what was typed, or nothing; and the form in the browser."""

from __future__ import annotations

import itertools
import math
import random
import re
from pathlib import Path
from typing import Any

import pytest
from answers import Expected, disagreements
from hosts import hosted, static_of, told
from pages import accessible, enlarge_text, minding, too_wide
from playwright.sync_api import Page, expect

import restitution
from restitution import examples
from restitution.errors import RestitutionError
from restitution.export.outline import outline
from restitution.expression import read_expression
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Negate,
    Number,
    Polar,
    Unit,
)
from restitution.expression.writing import write_expression
from restitution.web.words import vocabulary

KINDS = ("wall", "walls", "spheres", "chain")
QUESTIONS = Path(__file__).parent / "questions"

# --- forms that are filled in in full -------------------------------------------------------------

FILLED: dict[str, dict[str, Any]] = {
    "wall": {"PMass": "2", "PX": "5", "PY": "-3", "e1": "1/2"},
    "walls": {"between": "120", "PSpeed": "u", "PAngle": "60", "e1": "1/2", "e2": "1/2"},
    "spheres": {
        "AMass": "2",
        "AX": "3",
        "AY": "-4",
        "BMass": "3",
        "BX": "2",
        "BY": "3",
        "line": "j",
        "e1": "3/7",
    },
    "chain": {
        "AMass": "2",
        "AX": "4",
        "AY": "0",
        "BMass": "3",
        "BVelocity": "rest",
        "e1": "1/2",
        "e2": "1/2",
    },
}
OTHERS = {
    "PSpeed": "v",
    "PAngle": "60",
    "PVector": "2(3i - 4j)",
    "ASpeed": "v",
    "AAngle": "alpha",
    "BSpeed": "w",
    "BAngle": "30",
    "AVector": "u i",
    "BVector": "u at 60 from -j",
    "BX": "2",
    "BY": "3",
    "PX": "5",
    "PY": "-3",
    "offset": "r",
    "radius": "r",
    **{f"{each}Vector": "3i + 4j" for each in ("wall", "first", "second", "line")},
    **{f"{each}Angle": "30" for each in ("wall", "first", "second", "line")},
}
WALLS = ("i", "j", "vector", "angle")
VELOCITIES = ("components", "speed", "vector", "unknown")
CHOICES: dict[str, dict[str, tuple[str, ...]]] = {
    "wall": {
        "wall": (*WALLS, "unknown"),
        "PVelocity": (*VELOCITIES, "wall"),
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
    "spheres": {
        "line": (*WALLS, "offset", "unknown"),
        "AVelocity": (*VELOCITIES, "rest"),
        "BVelocity": (*VELOCITIES, "rest"),
        "BAngle": ("60° from -i", "0.5"),
        "BMass": ("", "k m"),
    },
    "chain": {
        "line": ("i", "angle", "offset"),
        "wall": (*WALLS, "unknown"),
        "BVelocity": ("components", "rest"),
        "order": ("AB", "BA"),
        "e1": ("", "1/3"),
    },
}


class Writer:
    """Asks the modules of the form themselves, in a browser."""

    def __init__(self, page: Page, served: str) -> None:
        self._page = page
        self._folder = f"{served}/{static_of(served)}/solve"
        page.goto(served + "/health")

    def run(self, module: str, body: str, values: Any) -> Any:
        """What a function body makes of ``values``, with the module's names in ``m``."""
        return self._page.evaluate(
            "async ([folder, values, words]) => {"
            f" const m = await import(`${{folder}}/{module}.js`);"
            f" const w = await import(`${{folder}}/form-statement.js`);"
            f" (await import(`${{folder}}/form-quantities.js`)).learn(words); {body} }}",
            [self._folder, values, vocabulary()],
        )

    def written(self, kind: str, changes: list[dict[str, Any]]) -> list[dict[str, Any]]:
        """Of each filled form its ``text``, what is ``missing`` and what is ``wrong``."""
        found: list[dict[str, Any]] = self.run(
            "form-model",
            """return values.map((each) => {
                 const answers = { ...m.emptyOf(each.kind), ...each };
                 const { missing, wrong } = w.linesOf(answers);
                 return { text: w.statementOf(answers), missing, wrong };
               });""",
            [{"kind": kind, **OTHERS, **FILLED[kind], **each} for each in changes],
        )
        return found

    def offered(self, function: str, kind: str, change: dict[str, Any]) -> list[dict[str, Any]]:
        """The quantities or facts that a form offers."""
        found: list[dict[str, Any]] = self.run(
            "form-quantities",
            """const { emptyOf } = await import(`${folder}/form-model.js`);
               return m[values[0]]({ ...emptyOf(values[1]), ...values[2] });""",
            [function, kind, {**OTHERS, **FILLED[kind], **change}],
        )
        return found


@pytest.fixture(scope="module")
def writer(browser: Any, served: str):
    page = browser.new_page()
    yield Writer(page, served)
    page.close()


def texts(found: list[dict[str, Any]]) -> list[str]:
    """The statements of forms in which nothing is missing and nothing wrong."""
    for each in found:
        assert (each["missing"], each["wrong"]) == ([], []), each["text"]
    return [each["text"] for each in found]


def combinations(kind: str) -> list[dict[str, str]]:
    choices = CHOICES[kind]
    return [dict(zip(choices, each)) for each in itertools.product(*choices.values())]


@pytest.mark.parametrize("kind", KINDS)
def test_whatever_is_chosen_reads_well(writer, kind: str) -> None:
    changes = combinations(kind)
    assert len(changes) >= 60
    for change, text in zip(changes, texts(writer.written(kind, changes))):
        try:
            restitution.parse(text)
        except RestitutionError as error:  # pragma: no cover
            pytest.fail(f"{change}\n{text}\n{error}")


@pytest.mark.parametrize("kind", KINDS)
def test_everything_that_can_be_asked_known_or_shown_reads_well(writer, kind: str) -> None:
    blank = {"e1": "", "e2": "", "PMass": "", "AMass": "", "BMass": "", "AVelocity": "unknown"}
    if kind in ("spheres", "chain"):
        blank |= {"BVelocity": "components"}
    quantities = writer.offered("quantitiesOf", kind, blank)
    facts = writer.offered("factsOf", kind, blank)
    assert len(quantities) >= 12
    offered = {each["item"].partition("(")[0] for each in quantities}
    spheres = 2 if kind in ("spheres", "chain") else 1
    records = [each for each in vocabulary()["offered"] if each["bodies"] <= spheres]
    assert {each["word"] for each in records} <= offered
    assert len(facts) >= 1
    asked = [{**blank, "asked": [each["key"]]} for each in quantities]
    for change, text in zip(asked, texts(writer.written(kind, asked))):
        (step,) = [
            each for each in outline(restitution.parse(text))["steps"] if each["kind"] == "find"
        ]
        (item,) = step["items"]
        assert item["staged"] == change["asked"][0]
    values = {"vector": "2i + 3j", "angle": "30", "percent": "40"}
    rows = [
        {"what": each["key"], "value": next((v for k, v in values.items() if each.get(k)), "1/2")}
        for each in quantities
        if not each.get("fixed")
    ]
    rows += [{"what": each["key"], "value": ""} for each in facts]
    rows = [{"speed": "", "angle": "", "way": "towards-left", "sign": "=", **row} for row in rows]
    for name, word, other in (("known", "given", "fact"), ("shows", "show", "relation")):
        own = [*rows, {**rows[0], "what": other, "value": "tan(alpha) = 3/4"}]
        find = {"asked": ["impulse(1)"]}
        changes = [{**blank, **find, "e1": "1/2", name: [row]} for row in own]
        for change, text in zip(changes, texts(writer.written(kind, changes))):
            row = change[name][0]
            steps = [
                each for each in outline(restitution.parse(text))["steps"] if each["kind"] == word
            ]
            ((relation,),) = [step["relations"] for step in steps]
            if row["value"] == "":
                assert (relation["staged"] or relation["text"]) == row["what"]
            elif row["what"] != other:
                assert relation["left"] == row["what"].removesuffix(" as a percentage")
                wanted = {"30": "30°", "40": "0.4", "2i + 3j": "2i + 3j", "1/2": "1/2"}
                assert relation["right"] == wanted[row["value"]]


FULL: list[tuple[str, dict[str, Any], dict[str, str]]] = [
    # worked by hand: one question of each textbook shape
    (
        "wall",
        {"asked": ["velocity(P, 1)", "impulse(1)", "energy_lost(1)"]},
        {"velocity(P)": "5i + 3/2 j", "impulse": "9", "energy_lost": "27/4"},
    ),
    (
        "wall",
        {"PVelocity": "wall", "PSpeed": "u", "PAngle": "60", "e1": "1/3", "PMass": "m"}
        | {"asked": ["speed(P, 1)", "deflection(P, 1)", "impulse(1)"]},
        {"speed(P)": "u/sqrt(3)", "deflection(P)": "90°", "impulse": "2 sqrt(3)/3 m u"},
    ),
    (
        "wall",
        {"wall": "vector", "PX": "7", "PY": "1", "e1": "3/5"},
        {"velocity(P)": "3/5 i + 29/5 j"},
    ),
    (
        "walls",
        {"asked": ["speed(P, 1)", "speed(P, 2)"]},
        {"speed(P, 1)": "sqrt(7)/4 u", "speed(P)": "sqrt(103)/16 u"},
    ),
    (
        "spheres",
        {"asked": ["velocity(A, 1)", "velocity(B, 1)", "impulse(1)"]},
        {"velocity(A)": "3i + 2j", "velocity(B)": "2i - j", "impulse": "12"},
    ),
    (
        "spheres",
        {"AMass": "3m", "BMass": "2m", "AX": "u", "AY": "0", "BX": "-2u", "BY": "0"}
        | {"line": "offset", "offset": "1.6r", "e1": "1/6", "asked": ["impulse(1)"]},
        {"impulse": "63/25 m u"},
    ),
    (
        "chain",
        {"asked": ["velocity(A, 1)", "velocity(B, 2)", "total_energy_lost(2)"]},
        {"velocity(A, 1)": "2/5 i", "velocity(B)": "-6/5 i", "total_energy_lost": "342/25"},
    ),
    (
        # towards each other, both at 60° to the line, equal and elastic: they exchange it
        "spheres",
        {"AVelocity": "line", "ASpeed": "4", "AAngle": "60", "AWay": "towards-left"}
        | {"BVelocity": "line", "BSpeed": "8", "BAngle": "60", "BWay": "towards-right"}
        | {"AMass": "m", "BMass": "m", "e1": "1", "line": "i"},
        {"velocity(A)": "-4i + 2 sqrt(3) j", "velocity(B)": "2i - 4 sqrt(3) j"},
    ),
    (
        # A moves away and is caught up by B
        "spheres",
        {"AVelocity": "line", "ASpeed": "2", "AAngle": "60", "AWay": "away-left"}
        | {"BVelocity": "line", "BSpeed": "4", "BAngle": "60", "BWay": "towards-left"}
        | {"AMass": "m", "BMass": "m", "e1": "1", "line": "i"},
        {"velocity(A)": "-2i + sqrt(3) j", "velocity(B)": "-i + 2 sqrt(3) j"},
    ),
]


@pytest.mark.parametrize(("kind", "change", "answers"), FULL)
def test_what_is_filled_in_in_full_is_solved(writer, kind, change, answers) -> None:
    (text,) = texts(writer.written(kind, [change]))
    solution = restitution.solve(restitution.parse(text))
    wanted = [Expected(0, item, answer) for item, answer in answers.items()]
    assert disagreements(solution, wanted) == [], text


def test_what_is_unknown_is_found(writer) -> None:
    change = {
        "e1": "",
        "PVelocity": "wall",
        "PSpeed": "u",
        "PAngle": "60",
        "asked": ["e"],
        "known": [{"what": "deflection(P, 1)", "value": "90"}],
    }
    (text,) = texts(writer.written("wall", [change]))
    assert "given deflection(P) = 90°\nfind e\n" in text
    solution = restitution.solve(restitution.parse(text))
    assert disagreements(solution, [Expected(0, "e", "1/3")]) == []


# --- angles ---------------------------------------------------------------------------------------

ANGLES = {
    "60": "60°",
    " 22.5 ": " 22.5° ",
    "-60": "-60°",
    "60 from -i": "60° from -i",
    "60 from 3i + 4j": "60° from 3i + 4j",
    "180 - theta": "180° - theta",
    "180 - 2theta": "180° - 2theta",
    "theta + 30": "theta + 30°",
    "(180 - theta)/2": "(180° - theta)/2",
    "1/2(90 - theta)": "1/2(90° - theta)",
    "180 - (90 - theta)": "180° - (90° - theta)",
    "90/2": "90/2°",
    "arctan(3/4)": "arctan(3/4)",
    "90 - arctan(3/4)": "90° - arctan(3/4)",
    "tan^-1(3/4)": "tan^-1(3/4)",
    "pi/3": "pi/3",
    "60°": "60°",
    "60 deg": "60 deg",
    "30 degrees": "30 degrees",
    "alpha": "alpha",
    "2 alpha": "2 alpha",
    "20*3": "20*3*1°",
    "10 sqrt(9)": "10 sqrt(9)*1°",
}


def test_a_number_alone_is_in_degrees(writer) -> None:
    found = writer.run("form-angle", "return values.map(m.inDegrees);", list(ANGLES))
    assert dict(zip(ANGLES, found)) == ANGLES


def number(tree: Expression) -> complex:
    """What a vector or an angle without letters is: a number of the plane, in radians."""
    match tree:
        case Number(value):
            return float(value)
        case Degrees(value):
            return math.radians(float(value))
        case Unit(axis):
            return 1 if axis == "i" else 1j
        case Negate(operand):
            return -number(operand)
        case Binary(op, left, right):
            a, b = number(left), number(right)
            return {"+": a + b, "-": a - b, "*": a * b}[op]
        case Polar(size, angle, origin):
            start = 1 if origin is None else number(origin) / abs(number(origin))
            turn = number(angle).real
            return number(size) * start * complex(math.cos(turn), math.sin(turn))
    raise AssertionError(tree)


LINES = {"i": 1, "j": 1j, "vector": (3 + 4j) / 5, "angle": complex(math.sqrt(3), 1) / 2}
WAYS = [f"{sense}-{side}" for sense in ("towards", "away") for side in ("left", "right")]


@pytest.mark.parametrize("typed", ["20", "90 - 70"])
def test_a_velocity_by_its_angle_to_the_line_of_centres(writer, typed: str) -> None:
    cases = list(itertools.product(LINES, WAYS, WAYS))
    changes = [
        {
            "line": line,
            "AVelocity": "line",
            "ASpeed": "2",
            "AAngle": typed,
            "AWay": own,
            "BVelocity": "line",
            "BSpeed": "3",
            "BAngle": typed,
            "BWay": other,
        }
        for line, own, other in cases
    ]
    for (line, own, other), found in zip(cases, writer.written("spheres", changes)):
        if own.startswith("away") and other.startswith("away"):
            assert "cannot meet" in found["wrong"][0][1]
            continue
        assert found["wrong"] == found["missing"] == []
        problem = restitution.parse(found["text"])
        assert problem.parts[0].steps[0].first == ("B" if own.startswith("away") else "A")
        for sphere, way, onwards in zip(problem.spheres, (own, other), (1, -1)):
            velocity = number(sphere.velocity) / LINES[line]  # seen along the line, from A to B
            sense, side = way.split("-")
            size = 2 if sphere.name == "A" else 3
            along = onwards * (1 if sense == "towards" else -1) * size * math.cos(math.radians(20))
            across = (1 if side == "left" else -1) * size * math.sin(math.radians(20))
            assert velocity == pytest.approx(complex(along, across)), found["text"]


def test_an_angle_to_the_line_of_centres_is_acute(writer) -> None:
    change = {"AVelocity": "line", "ASpeed": "2", "AAngle": "120"}
    (found,) = writer.written("spheres", [change])
    assert found["wrong"] == [
        ["AAngle", "The angle with the line of centres is at most 90°; its sense is chosen below."]
    ]


# --- never another question -----------------------------------------------------------------------

PIECES = (
    *("2", "-3", "1/2", "u", "3m", "0.4", "u/2", "-2u", "sqrt(3)", "u cos(alpha)", "sin 2", "-u^2"),
    *(
        "2, velocity 3i",
        "2 at 30°",
        "5i",
        "2 i",
        "j",
        "2\nfind e",
        "2: 3",
        "3 # 4",
        "(2",
        "2)",
        "√",
    ),
    *("cos", "2^", "0.4 kg", "30 N s", "m v", "e = 2", "1,5", "1/", "-", "at rest", "-(u + v)"),
    *(
        "u - v",
        "--2",
        "u i + 2j",
        "a and b",
        "60 from -i",
        "2 to W",
        "1e3",
        "(1, 2)",
        "again",
        "\\",
    ),
    *("2 as a percentage", "= 3", "> 2", "e", "find", "sphere", "velocity(P)", "W", "P", "60%", ""),
)
UNIT = re.compile(r"\s*(kg|N s)$")
# What a field says, in the outline of the statement.
FIELDS: dict[str, Any] = {
    "PMass": ("components", lambda told: told["spheres"][0]["mass"]),
    "PX": ("components", lambda told: told["spheres"][0]["velocity"]["x"]),
    "PY": ("components", lambda told: told["spheres"][0]["velocity"]["y"]),
    "e1": ("components", lambda told: told["steps"][0]["e"]),
    "PSpeed": ("speed", lambda told: told["spheres"][0]["velocity"]["size"]),
    "PAngle": ("wall", lambda told: told["spheres"][0]["velocity"]["angle"]),
}


def without(told: dict[str, Any], field: str) -> dict[str, Any]:
    """An outline without what the field says."""
    read = FIELDS[field][1]
    place = read(told)
    text = repr(told)
    assert repr(place) in text
    return left_out(told, place)


def left_out(value: Any, place: Any) -> Any:
    """The same with every text that is ``place`` left out."""
    if isinstance(value, dict):
        return {key: left_out(each, place) for key, each in value.items() if key != "text"}
    if isinstance(value, list):
        return [left_out(each, place) for each in value]
    return None if value == place else value


@pytest.mark.parametrize("field", FIELDS)
def test_a_field_says_what_was_typed_or_nothing_at_all(writer, field: str) -> None:
    draw = random.Random(field)
    joined = [
        draw.choice(PIECES) + draw.choice(["", " ", " + ", "*", "("]) + draw.choice(PIECES)
        for _ in range(400)
    ]
    typed = [*PIECES, *joined]
    way, read = FIELDS[field]
    base = {"PVelocity": way, "PMass": "7", "PX": "11", "PY": "13", "e1": "0.17"}
    base |= {"PSpeed": "19", "PAngle": "23"}
    angle = field == "PAngle"
    degrees = writer.run("form-angle", "return values.map(m.inDegrees);", typed)
    (usual,) = texts(writer.written("wall", [base]))
    wanted = without(outline(restitution.parse(usual)), field)
    good = 0
    for text, turned, found in zip(
        typed, degrees, writer.written("wall", [{**base, field: each} for each in typed])
    ):
        if found["missing"] or found["wrong"]:
            continue  # it is told of, and goes nowhere
        if not text.strip():
            assert field in ("PMass", "e1")  # where it says that nothing is told
            continue
        try:
            problem = restitution.parse(found["text"])
        except RestitutionError:
            continue  # so is this, by the server
        told = outline(problem)
        names = {"P", "W"}
        alone = UNIT.sub("", turned if angle else text)
        try:
            read_alone = write_expression(read_expression(alone, names=names))
        except RestitutionError:
            assert re.search(r"kg|N s", alone)  # within a sum, what is measured tells of the unit
            continue
        assert read(told).replace("--", "") == read_alone.replace("--", ""), found["text"]
        assert without(told, field) == wanted, found["text"]
        good += 1
    assert good >= 20
    assert good < len(typed)


def test_a_unit_behind_a_letter_is_none_of_its_letters(writer) -> None:
    refused = [{"PMass": "m kg"}, {"PX": "u m/s"}, {"PY": "-2u ms^-1"}, {"e1": "e N s"}]
    for change, each in zip(refused, writer.written("wall", refused)):
        assert [name for name, _ in each["wrong"]] == list(change)
        assert "letter" in each["wrong"][0][1]
    passed = [{"PMass": "2 kg"}, {"PX": "18 km/h"}, {"PMass": "k m"}, {"PX": "3m u"}]
    assert [each["wrong"] for each in writer.written("wall", passed)] == [[]] * 4


def test_a_field_that_is_missing_is_told(writer) -> None:
    for kind, needed in (
        ("wall", ("PX", "PY")),
        ("walls", ("between", "PSpeed", "PAngle")),
        ("spheres", ("AX", "AY", "BX", "BY")),
    ):
        found = writer.written(kind, [{each: ""} for each in needed])
        for field, each in zip(needed, found):
            assert [name for name, _ in each["missing"]] == [field]


# --- read back ------------------------------------------------------------------------------------


def meaning(problem: restitution.Problem) -> dict[str, Any]:
    """What a statement says, in whatever order it says it."""
    told = outline(problem)
    steps = told["steps"]

    def relations(kind: str) -> list[str]:
        own = [step["relations"] for step in steps if step["kind"] == kind]
        return sorted(each["staged"] or each["text"] for each in itertools.chain(*own))

    def bare(what: dict[str, Any], *keys: str) -> str:
        return repr({key: value for key, value in what.items() if key not in ("line", *keys)})

    finds = [step for step in steps if step["kind"] == "find"]
    return {
        "title": told["title"],
        "spheres": sorted(bare(each, "radius") for each in told["spheres"]),
        "walls": sorted(map(bare, told["walls"])),
        "impacts": [bare(each) for each in steps if each["kind"] == "impact"],
        "given": relations("given"),
        "shown": relations("show"),
        "found": sorted(
            (item["staged"], step["in_terms_of"] or "") for step in finds for item in step["items"]
        ),
    }


def test_what_is_read_back_says_the_same(writer) -> None:
    """Of all examples and questions those that the form can hold."""
    statements = [examples.statement(name) for name in examples.names()]
    for path in sorted(QUESTIONS.glob("*.impact")):
        lines = path.read_text(encoding="utf-8").splitlines()
        statements.append("".join(f"{line}\n" for line in lines if not line.startswith("#")))
    problems = [restitution.parse(each) for each in statements]
    found = writer.run(
        "form-reading",
        """return values.map(([told, text]) => {
             const { answers, reason } = m.answersOf(told, text);
             if (!answers) return { reason };
             const { missing, wrong } = w.linesOf(answers);
             return { text: w.statementOf(answers), missing, wrong };
           });""",
        [[outline(problem), text] for problem, text in zip(problems, statements)],
    )
    held = 0
    for problem, statement, each in zip(problems, statements, found):
        if "reason" in each:
            assert each["reason"]
            continue
        assert each["wrong"] == [], statement
        if each["missing"]:  # an offset without a radius, which the form asks for
            assert "offset" in statement
            continue
        assert meaning(restitution.parse(each["text"])) == meaning(problem), statement
        held += 1
    assert held > len(statements) / 2


# --- the form in the browser ----------------------------------------------------------------------


@pytest.fixture
def form(page: Page, served: str) -> Page:
    with minding(page, served):
        hosted(page, served, "form", "mountForm")
        expect(page.get_by_role("radio", name=re.compile("wall|spheres", re.I))).to_have_count(4)
        yield page


def latest(page: Page) -> str:
    return told(page)[-1][1]


def fill(page: Page, **fields: str) -> None:
    for name, value in fields.items():
        place = page.locator(f"#form-{name}")
        if place.evaluate("node => node.tagName") == "SELECT":
            place.select_option(value)
        else:
            place.fill(value)


def wait_for_statement(page: Page, part: str) -> None:
    page.wait_for_function("part => window.told.at(-1)?.[1].includes(part)", arg=part)


def test_it_starts_empty(form: Page) -> None:
    assert told(form) == []
    for kind in ("One wall", "Two walls", "Two spheres", "Spheres, then a wall"):
        form.get_by_label(kind, exact=True).check()
        fields = form.locator("input[type=text]")
        assert set(fields.evaluate_all("all => all.map((each) => each.value)")) == {""}
        assert all(fields.evaluate_all("all => all.map((each) => each.placeholder)"))
        ticked = form.get_by_role("checkbox", checked=True)
        names = ticked.evaluate_all("all => all.map((each) => each.value)")
        assert names
        assert all(each.startswith("velocity(") for each in names)
    form.get_by_role("button", name="Put it into the editor").click()
    assert told(form) == []  # half a question is none
    expect(form.locator("#form-AX")).to_be_focused()


def test_the_statement_comes_as_soon_as_all_can_be_read(form: Page) -> None:
    fill(form, PMass="m", PVelocity="wall", PSpeed="u", PAngle="alpha")
    form.get_by_label("coefficient of restitution e").check()
    form.get_by_label("velocity of P afterwards", exact=True).uncheck()
    form.get_by_label("It is known that").select_option("deflection(P, 1)")
    form.get_by_label("is equal to").fill("90")
    form.get_by_role("button", name="Another fact").click()
    form.get_by_label("and that").select_option(label="another fact, such as tan(alpha) = 3/4")
    form.get_by_label("The fact").fill("tan(alpha) = 2")
    form.get_by_label("Show that").select_option("speed(P, 1)")
    form.get_by_label("this").fill("u/2")
    wait_for_statement(form, "u/2")
    assert latest(form) == (
        "wall W: along i\n"
        "sphere P: mass m, velocity u at alpha to W\n"
        "P hits W\n"
        "given deflection(P) = 90°\n"
        "given tan(alpha) = 2\n"
        "find e\n"
        "show speed(P) = u/2\n"
    )
    form.get_by_label("Two spheres").check()
    expect(form.get_by_role("group", name="The line of centres")).to_be_visible()
    form.get_by_label("One wall").check()  # what was filled in there is still there
    expect(form.locator("#form-PAngle")).to_have_value("alpha")


def ticked(form: Page) -> list[str]:
    found = form.get_by_role("checkbox", checked=True)
    return found.evaluate_all("all => all.map((each) => each.value)")


def test_what_is_known_or_to_be_shown_is_not_ticked(form: Page) -> None:
    form.get_by_label("Two spheres").check()
    both = ["velocity(A, 1)", "velocity(B, 1)"]
    assert ticked(form) == both
    known = form.get_by_label("It is known that")
    for what, left in (
        ("velocity(A, 1)", both[1:]),
        ("polar velocity(B, 1)", both[:1]),
        ("velocity(A, 1) = 0i", both[1:]),
        ("speed(A, 1)", both),
    ):
        known.select_option(what)
        assert ticked(form) == left
    known.select_option("")
    form.get_by_label("Show that").select_option("relation")
    assert ticked(form) == []
    # What somebody has chosen stays.
    form.get_by_label("speed of A afterwards", exact=True).check()
    known.select_option("velocity(A, 1)")
    form.get_by_label("Show that").select_option("")
    assert ticked(form) == ["speed(A, 1)"]


def test_two_spheres_by_their_angles_to_the_line_of_centres(form: Page) -> None:
    form.get_by_label("Two spheres").check()
    fill(form, AVelocity="line", ASpeed="5u", AAngle="alpha", BVelocity="line", BSpeed="5u")
    fill(form, BAngle="90 - alpha", e1="5/7", AMass="2m", BMass="m")
    form.get_by_role("radiogroup", name="How B moves").get_by_label("towards A, down").check()
    form.get_by_label("It is known that").select_option("line velocity(A, 1)")
    fill(form, known0speed="2", known0angle="30")
    form.get_by_role("radiogroup").last.get_by_label("away from B, up").check()
    wait_for_statement(form, "from -i\nfind")
    assert latest(form) == (
        "sphere A: mass 2m, velocity 5u at alpha\n"
        "sphere B: mass m, velocity 5u at 90° - alpha from -i\n"
        "A hits B: along i, e = 5/7\n"
        "given velocity(A) = 2 at -30° from -i\n"
        "find velocity(B)\n"
    )


def test_whoever_types_on_a_phone_has_the_screen_for_the_fields(form: Page) -> None:
    form.set_viewport_size({"width": 390, "height": 844})
    form.get_by_label("Two spheres").check()
    fill(form, AX="3", AY="-4", BX="2", BY="3", line="j")
    field, written = form.locator("#form-BX"), form.locator(".written")
    place = "node => node.getBoundingClientRect().top + scrollY"
    field.focus()
    before = form.locator("#form-BY").evaluate(place)
    field.press("End")
    field.press("7")
    seen = written.evaluate("node => innerHeight - node.getBoundingClientRect().top")
    assert seen <= 0.08 * 844
    line = written.locator("code").evaluate(
        """node => {
          const range = document.createRange();
          const start = node.textContent.indexOf("sphere B");
          range.setStart(node.firstChild, start);
          range.setEnd(node.firstChild, start + 8);
          return range.getBoundingClientRect().toJSON();
        }"""
    )
    assert 844 - seen < line["top"] < line["bottom"] <= 844
    # Nothing moves when the field is left, so that a finger meets what it aims at.
    form.locator("body").evaluate("() => document.activeElement.blur()")
    assert form.locator("#form-BY").evaluate(place) == before
    assert written.get_by_role("button").is_visible()


def test_a_mistake_is_told_at_its_field(form: Page) -> None:
    fill(form, PX="2", PY="-3")
    wait_for_statement(form, "2i - 3j")
    field = form.locator("#form-PY")
    before = len(told(form))
    for wrong, said in (("-3)", "bracket"), ("-3 + sphere", "sphere"), ("-3j", "Leave out j")):
        field.fill(wrong)
        problem = form.locator("#problem-PY")
        expect(problem).to_contain_text(said)  # the server's own words, or the form's
        expect(field).to_have_attribute("aria-invalid", "true")
        assert "problem-PY" in field.get_attribute("aria-describedby")
    field.fill("-3")
    expect(problem).to_be_empty()
    assert field.get_attribute("aria-invalid") is None
    form.wait_for_timeout(500)
    assert {each[1] for each in told(form)[before:]} <= {latest(form)}
    fill(form, e1="1/")
    expect(form.locator("#problem-e1")).not_to_be_empty()
    for wrong, said in (("e = 1/2", "Leave out “e =”"), ("0,5", "Write 0.5")):
        fill(form, e1=wrong)
        expect(form.locator("#problem-e1")).to_contain_text(said)
    fill(form, e1="1/2", PMass="2 # a comment")
    expect(form.locator("#problem-PMass")).to_contain_text("Leave out")
    fill(form, PMass="3i")
    expect(form.locator("#problem-PMass")).to_contain_text("not a vector")
    fill(form, PMass="")
    form.get_by_label("velocity of P afterwards").uncheck()
    expect(form.locator("#problem-asked")).to_have_text("Choose at least one thing to find.")


def test_keyboard_alone_fills_it_in(form: Page) -> None:
    form.keyboard.press("Tab")
    expect(form.get_by_label("One wall")).to_be_focused()
    form.keyboard.press("ArrowRight")
    expect(form.get_by_label("Two walls")).to_be_focused()
    expect(form.get_by_label("Two walls")).to_be_checked()
    for _ in range(3):
        form.keyboard.press("Tab")
    expect(form.get_by_label("BC runs")).to_be_focused()
    form.keyboard.press("ArrowDown")
    expect(form.get_by_label("BC runs")).to_be_focused()  # though all fields were made anew
    assert "wall BC: along i\n" in form.locator("pre").inner_text()
    form.keyboard.press("Enter")


def test_it_fits_a_small_phone(form: Page) -> None:
    kinds = ("One wall", "Two walls", "Two spheres", "Spheres, then a wall")
    form.set_viewport_size({"width": 320, "height": 600})
    for kind in kinds:
        form.get_by_label(kind, exact=True).check()
        if "pheres" in kind:
            fill(form, AVelocity="line")
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
        form.get_by_label("Mass").first.fill("2 #")
        if kind == "Two spheres":
            fill(form, AVelocity="line")
        expect(form.locator("[aria-invalid]")).to_have_count(1)
        accessible(form)
