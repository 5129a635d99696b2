"""Pictures of experiments: what is drawn is what was measured, and it stays within its frame."""

from __future__ import annotations

import html
import io
import math
import re
import runpy
import unicodedata
import xml.etree.ElementTree as ET
from collections.abc import Callable
from functools import cache, partial
from pathlib import Path

import matplotlib as mpl
import numpy as np
import pypdf
import pytest
from commands import run
from hypothesis import given, settings
from hypothesis import strategies as st

import restitution as r
from restitution.drawing.svg import INK
from restitution.experiments.frames import frame_of, outlying
from restitution.experiments.plots import MOST_DRAWN, law_plot, residual_plot, speed_plot
from restitution.experiments.records import Table
from restitution.experiments.report import report
from restitution.experiments.results import Check, ClassValues, Interval, Point
from restitution.experiments.whole import Experiment

SVG = "{http://www.w3.org/2000/svg}"
USE, LINK = f"{SVG}use", "{http://www.w3.org/1999/xlink}href"


def wall(e: float, angles: list[float], error: float = 0.0, **more: list[float]) -> Experiment:
    rng = np.random.default_rng(1)
    alpha = np.array(angles)
    beta = np.degrees(np.arctan(e * np.tan(np.radians(alpha))))
    noise = rng.normal(0, error, (2, len(alpha)))
    columns = {"alpha": alpha + noise[0], "beta": np.maximum(beta + noise[1], 0), **more}
    return r.experiment(columns, angle_error=max(error, 0.3))


def spheres(
    e: float, rows: list[tuple[float, float]], interval: tuple[float, float] = (-math.inf, math.inf)
) -> Experiment:
    """What an experiment with two spheres comes to, with (approach, separation) of each trial."""
    points = tuple(
        Point(line, x, y, 0.05, 0.04, x, e * x, (y - e * x) / 0.05, speed=abs(x) + 1)
        for line, (x, y) in enumerate(rows, 2)
    )
    return Experiment(
        "spheres",
        Table("spheres", units={"u_A": "m/s"}),
        e,
        0.02,
        Interval(*interval, 0.95, ""),
        "given",
        None,
        ClassValues(e, None, e, ""),
        points,
        (Check("scatter", "scatter", "untested", "Untested."),),
    )


def marks(svg: str) -> list[tuple[float, float]]:
    """Where the filled discs of readings are, on paper; not that of the legend, which is last."""
    root = ET.fromstring(svg)
    discs = {
        f"#{path.get('id')}"
        for path in root.iter(f"{SVG}path")
        if path.get("id") and path.get("d", "").count("C") == 8
    }
    drawn = [
        (float(each.get("x")), float(each.get("y")))
        for each in root.iter(USE)
        if each.get(LINK) in discs and each.get("fill") == INK
    ]
    return drawn[:-1] if "The law" in svg else drawn


def box(svg: str) -> tuple[float, float, float, float]:
    x, y, width, height = map(float, ET.fromstring(svg).get("viewBox", "").split())
    return x, y, x + width, y + height


def test_readings_are_drawn_where_they_are():
    result = wall(0.7, list(range(20, 71, 5)), 1.0)
    places = np.array(marks(law_plot(result)))
    assert len(places) == len(result.points)
    for column, values in ((0, [p.x for p in result.points]), (1, [p.y for p in result.points])):
        straight = np.polyfit(values, places[:, column], 1)
        assert np.polyval(straight, values) == pytest.approx(places[:, column], abs=0.01)
        assert straight[0] > 0 if column == 0 else straight[0] < 0


@pytest.mark.parametrize("plot", [law_plot, residual_plot, speed_plot])
def test_a_picture_is_the_same_each_time_and_stands_on_a_page(plot):
    result = wall(0.6, [20, 30, 40, 50, 60], 1.0, u=[1.0, 2.0, 1.5, 1.2, 0.7])
    svg = plot(result)
    assert svg == plot(result)
    root = ET.fromstring(svg)
    name = root.get("id")
    ids = [each.get("id") for each in root.iter() if each.get("id")]
    assert len(set(ids)) == len(ids) and all(each.startswith(name) for each in ids)
    used = set(re.findall(r'(?:href="|url\()#([^")]+)', svg))
    assert used <= set(ids)
    colours = set(re.findall(r"#[0-9a-f]{6}(?=\")", svg))
    assert colours == {"#1a1a1a"}
    assert not re.search(r"<script|<image|<text|http://(?!www\.w3\.org)", svg)
    assert root.find(f"{SVG}title").text and root.find(f"{SVG}desc").text


def test_the_settings_of_matplotlib_neither_change_nor_matter():
    result = wall(0.6, [20, 30, 40, 50, 60])
    usual, before = law_plot(result), dict(mpl.rcParams)
    assert dict(mpl.rcParams) == before
    with mpl.rc_context({"lines.linewidth": 9, "font.size": 30, "axes.grid": True}):
        assert law_plot(result) == usual


HOSTILE: dict[str, Callable[[], Experiment]] = {
    "one reading": partial(wall, 0.7, [40]),
    "two hundred": partial(wall, 0.6, list(np.linspace(10, 85, 200)), 1.5),
    "e near 0": partial(wall, 0.01, [20, 30, 40, 50, 60], 0.2),
    "e near 1": partial(wall, 0.99, [20, 30, 40, 50, 60], 1.0),
    "e above 1": partial(wall, 1.4, [20, 30, 40, 50, 60], 1.0),
    "steep alone": partial(wall, 0.7, [80, 82, 84, 86, 88], 0.2),
    "two too steep": partial(wall, 0.7, [20, 30, 40, 50, 60, 85, 88], 0.3),
    "no bound": partial(spheres, 0.9, [(1.0, 0.95), (2.0, 1.7)]),
    "no upper bound": partial(spheres, 1.2, [(1.0, 1.2), (2.0, 2.4)], (1.1, math.inf)),
    "negative": partial(spheres, -0.1, [(1.0, -0.1), (2.0, -0.2)]),
}


@cache
def hostile(name: str) -> Experiment:
    """What one of these comes to."""
    return HOSTILE[name]()


@pytest.mark.parametrize("name", HOSTILE)
@pytest.mark.parametrize("plot", [law_plot, residual_plot, speed_plot])
def test_all_stays_within_the_picture(name, plot):
    svg = plot(hostile(name))
    if svg is None:
        return
    left, top, right, bottom = box(svg)
    assert right - left < 110 / 25.4 * 72 * 1.4 and bottom - top < 110 / 25.4 * 72 * 1.2
    places = marks(svg)
    assert places
    for x, y in places:
        assert left <= x <= right and top <= y <= bottom


@given(
    st.floats(0, 1.5),
    st.lists(st.tuples(st.floats(0.01, 50), st.floats(-20, 80)), min_size=1, max_size=30),
    st.tuples(st.floats(-2, 0.9), st.floats(0.9, 5)),
)
@settings(max_examples=100)
def test_any_readings_are_drawn(e, rows, interval):
    result = spheres(e, rows, interval)
    frame = frame_of(result)
    inside = [each for each in result.points if frame.holds(each.x, each.y)]
    svg = law_plot(result)
    assert len(marks(svg)) == len(inside)
    if len(inside) < len(rows):
        assert f"{len(rows) - len(inside)} of them outside" in svg
    for each in result.points:
        x, y = frame.at_edge(each.x, each.y)
        assert frame.left <= x <= frame.right and frame.bottom <= y <= frame.top


def test_steep_readings_do_not_squeeze_the_others():
    frame = frame_of(hostile("two too steep"))
    xs = sorted(each.x for each in hostile("two too steep").points)
    assert xs[4] > 0.8 * frame.right and xs[5] > frame.right
    svg = law_plot(hostile("two too steep"))
    assert "2 of them outside the frame" in svg


def test_what_many_readings_share_is_shown():
    assert outlying([1.0, 2, 3, 50, 60, 70], 5) == 70
    assert outlying([1.0, 2, 3, 4, 5, 70], 5) == 5
    assert outlying([1.0, 1.6e16], 5) == 1.0
    assert outlying([1.6e16], 5) == 1.0


def test_residuals_are_those_of_the_readings():
    result = wall(0.7, list(range(20, 71, 5)), 1.0)
    places = np.array(marks(residual_plot(result)))
    residuals = [each.residual for each in result.points]
    straight = np.polyfit(residuals, places[:, 1], 1)
    assert np.polyval(straight, residuals) == pytest.approx(places[:, 1], abs=0.01)


def test_a_reading_far_from_the_fit_is_named():
    angles = {"alpha": [20, 30, 40, 50, 60, 45], "beta": [14.5, 21, 32, 39, 50, 12.0]}
    plain = {"alpha": [20, 30, 40, 50, 60, 45], "beta": [14.5, 21, 32, 39, 50, 34.5]}
    glyphs = [
        len(re.findall("<use", law_plot(r.experiment(each, angle_error=1))))
        for each in (plain, angles)
    ]
    assert glyphs[1] > glyphs[0]


def test_without_speeds_there_is_no_plot_of_them():
    assert speed_plot(hostile("e near 1")) is None


# --- the command ------------------------------------------------------------------------------


def test_the_command_writes_the_picture_of_the_law(tmp_path):
    table = tmp_path / "angles.csv"
    table.write_text("alpha,beta\n30,21\n45,34\n60,49\n", encoding="utf-8")
    usual = [str(table), "--angle-error", "1"]
    svg = law_plot(r.experiment(table, angle_error=1))
    assert run("experiment", *usual, "-o", tmp_path / "law.svg")[0] == 0
    assert (tmp_path / "law.svg").read_text(encoding="utf-8") == svg
    assert run("experiment", *usual, "-o", tmp_path / "law.png")[0] == 0
    assert (tmp_path / "law.png").read_bytes().startswith(b"\x89PNG")
    status, _, messages = run("experiment", *usual, "-o", tmp_path / "law.gif")
    assert status == 2 and ".svg" in messages


# --- reports ----------------------------------------------------------------------------------

TABLE = "alpha,beta,u\n30,21,1\n45,34,2\n60,49,1.5\nforty,21,1\n50,40.5,\n"


def plain(pdf: bytes) -> str:
    """The text of a PDF of A4 pages, letters of mathematical alphabets as plain ones."""
    read = pypdf.PdfReader(io.BytesIO(pdf))
    assert all(tuple(map(round, page.mediabox[2:])) == (595, 842) for page in read.pages)
    text = "\n".join(page.extract_text() for page in read.pages)
    return " ".join(unicodedata.normalize("NFKC", text).split())


def test_a_report_has_the_value_the_readings_the_checks_and_what_was_left_out():
    result = r.experiment(TABLE, angle_error=1)
    assert result.table.faults
    page = report(result, "html").decode()
    bare = re.sub(r"(?s)<svg.*?</svg>|<style.*?</style>|<[^>]+>", " ", page)
    text = " ".join(html.unescape(bare).split())
    printed = plain(report(result, "pdf"))
    for wanted in (
        f"{result.e:.3f} ± {result.standard_error:.3f}",
        "2 rows left out" if len(result.table.faults) == 2 else "1 row left out",
        "forty",
        "45.0°",
        *(each.title for each in result.checks),
    ):
        assert wanted in text
        assert wanted in printed
    for each in result.checks:
        words = each.sentence.removeprefix("Untested: ")[1:].split()
        assert " ".join(words) in text
    assert page.count("<svg") == 2 + (speed_plot(result) is not None)
    assert page.count("<h2>") == len(re.findall(r"<h2>[^<]+</h2>", page))


def test_a_report_is_the_same_each_time_and_escapes_what_was_typed():
    result = r.experiment("alpha,beta\n30,21\n45,34\n<b>&,#set page()\n", angle_error=1)
    page = report(result, "html")
    assert page == report(result, "html") and report(result, "pdf") == report(result, "pdf")
    assert b"<b>" not in page and b"&lt;b&gt;&amp;" in page
    assert "<b>&" in plain(report(result, "pdf"))


def test_of_many_readings_some_are_counted():
    data = {"alpha": np.linspace(20, 60, 620), "beta": np.linspace(15, 52, 620)}
    page = report(r.experiment(data, angle_error=1), "html").decode()
    assert page.count("<tr>") < 540 and "120 more are not printed" in page


def test_the_command_writes_reports(tmp_path):
    table = tmp_path / "angles.csv"
    table.write_text(TABLE, encoding="utf-8")
    for ending, start in ((".html", b"<!DOCTYPE html>"), (".pdf", b"%PDF")):
        path = tmp_path / f"report{ending}"
        assert run("experiment", table, "--angle-error", "1", "-o", path)[0] == 0
        assert path.read_bytes().startswith(start)


def test_the_picture_of_the_guide_is_that_of_its_script():
    root = Path(__file__).parents[1] / "docs"
    script = runpy.run_path(str(root / "examples" / "experiment_law.py"))
    result = r.experiment({"alpha": script["ALPHA"], "beta": script["BETA"]}, angle_error=1)
    kept = (root / "images" / "experiment-law.svg").read_text(encoding="utf-8")
    drawn = law_plot(result)
    assert (
        re.findall(r"<desc.*?</desc>", kept)[0].partition(">")[2]
        == re.findall(r"<desc.*?</desc>", drawn)[0].partition(">")[2]
    )
    assert marks(kept) == pytest.approx(np.array(marks(drawn)))


def test_of_very_many_readings_some_are_drawn():
    rows = [(1 + k / 5000, 0.8 * (1 + k / 5000)) for k in range(5000)]
    rows[1234] = (1.25, 1.4)
    result = spheres(0.8, rows)
    for plot in (law_plot, residual_plot, speed_plot):
        svg = plot(result)
        assert len(marks(svg)) <= MOST_DRAWN + 6
        assert "5000 readings" in svg and len(svg) < 1_000_000
    x, y = np.array(marks(law_plot(result))).T
    off = np.abs(np.polyval(np.polyfit(x, y, 1), x) - y)
    assert sorted(off > 20) == [False] * (len(off) - 1) + [True]  # the one far off is among them
