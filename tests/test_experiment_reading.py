"""Tables of what was measured: every way to write them, and what is wrong with them."""

from __future__ import annotations

import random
from contextlib import suppress

import pytest
from commands import run

import restitution as r
from restitution.errors import MissingError, RestitutionError, StatementError
from restitution.experiments import rows, tables
from restitution.experiments.records import Table

PLAIN = "alpha,beta\n30,21\n45,34.5\n60,49\n"


def table(data: rows.Data, **options: object) -> Table:
    return tables.table_of(rows.rows_of(data), tables.Options(**options))


def angles(table: Table) -> list[tuple[float, float]]:
    return [(round(each.alpha.value, 6), round(each.beta.value, 6)) for each in table.readings]


EXPECTED = [(30, 21), (45, 34.5), (60, 49)]


@pytest.mark.parametrize(
    "text",
    [
        PLAIN,
        PLAIN.replace("\n", "\r\n"),
        PLAIN.replace("\n", "\r"),
        "\ufeff" + PLAIN,
        PLAIN.replace(",", "\t"),
        PLAIN.replace(",", ";").replace(".", ","),
        PLAIN.replace(",", "\t").replace(".", ","),
        PLAIN.replace(",", " "),
        PLAIN.replace("alpha", '"α (deg)"').replace("beta", " β / ° "),
        PLAIN.replace("34.5", '"34,5"'),
        "# a class\n\n" + PLAIN.replace("45", "\n  # the second\n45"),
        "Our experiment\n" + PLAIN,
        "name,alpha,beta,remark\nx,30,21,\ny,45,34.5,good\nz,60,49\n",
        "alpha,beta\n30°,21°\n45 ,34.5\n60,49\n,\n",
        "alpha (from normal),beta\n60,21\n45,34.5\n30,49\n",
    ],
)
def test_ways_to_write_the_same_table(text):
    assert angles(table(text)) == EXPECTED
    assert angles(table(text.encode())) == EXPECTED
    assert not table(text).faults


def test_other_encodings_and_sources(tmp_path):
    assert angles(table(PLAIN.encode("utf-16"))) == EXPECTED
    file = tmp_path / "angles.csv"
    file.write_text(PLAIN)
    assert angles(table(file)) == EXPECTED
    assert angles(table({"alpha": [30, 45, 60], "beta": [21, 34.5, 49]})) == EXPECTED


def test_from_normal_turns_both():
    turned = table("alpha,beta\n60,69\n", from_normal=True)
    assert angles(turned) == [(30, 21)]
    assert turned.from_normal


def test_units():
    text = "alpha (rad),beta (rad),u (cm/s),v / m s^-1\n0.5235987756,0.366519143,150,1.2\n"
    reading = table(text).readings[0]
    assert (round(reading.alpha.value, 4), round(reading.beta.value, 4)) == (30, 21)
    assert reading.u.value == 1.5
    assert reading.v.value == 1.2


@pytest.mark.parametrize("name", ["± alpha", "alpha ±", "alpha_error", "alpha error", "+/- α (°)"])
def test_columns_of_errors(name):
    reading = table(f"alpha,beta,{name}\n30,21,1.5\n").readings[0]
    assert reading.alpha.error == 1.5
    assert reading.beta.error is None


def test_errors_in_cells_and_for_all():
    readings = table("alpha,beta\n30 ± 2,21\n45,34\n", angle_error=1).readings
    assert [each.alpha.error for each in readings] == [2, 1]
    assert [each.beta.error for each in readings] == [1, 1]


@pytest.mark.parametrize(
    ("row", "fault"),
    [
        ("x,21", "line 3, column alpha: 'x': this is no number"),
        ("30,", "line 3, column beta: no value"),
        ("30", "line 3, column beta: no value"),
        ("NaN,21", "line 3, column alpha: 'NaN': a number is needed; leave a row out where"),
        ("30,inf", "line 3, column beta: 'inf': a number is needed"),
        ("30,1e999", "line 3, column beta: '1e999': a number is finite"),
        ("1e10,21", "line 3, column alpha: '1e10': a number is at most 1e+09 in size"),
        ("95,21", "line 3, column alpha: '95': an angle of impact is between 0° and 90°"),
        ("0,21", "line 3, column alpha: '0': an angle of impact is between"),
        ("30,-20", "line 3, column beta: '-20': an angle of rebound is from 0° to 90°"),
        ("30,5,21,5", "line 3: 4 values for 2 columns; with decimal commas, part the columns by"),
        ('"1,234.5",21', "line 3, column alpha: '1,234.5': a number has one decimal sign"),
        ('"30,21', "line 3, column beta: no value"),
        ("30,=2+3", "line 3, column beta: '=2+3': this is no number"),
        ("30,__import__('os')", "line 3, column beta: \"__import__('os')\": this is no number"),
    ],
)
def test_bad_row_is_told_and_the_rest_goes_on(row, fault):
    read = table(f"alpha,beta\n30,21\n{row}\n60,49\n")
    assert angles(read) == [(30, 21), (60, 49)]
    assert len(read.faults) == 1
    assert str(read.faults[0]).startswith(fault)


HOSTILE = {
    "empty": ("", "the table is empty"),
    "blank": (" \n\n;;\n", "the table is empty"),
    "comments": ("# alpha,beta\n", "the table is empty"),
    "header": ("alpha,beta\n", "no rows below it"),
    "numbers": ("30,21\n45,34\n", "the columns are 30, 21: a wall needs alpha and beta"),
    "one column": ("alpha\n30\n", "a header names two columns or more"),
    "unknown": ("a,b,c\n1,2,3\n", "a wall needs alpha and beta"),
    "half": ("alpha,u\n1,2\n", "a wall needs alpha and beta"),
    "twice": ("alpha,α,beta\n30,30,21\n", "two columns are alpha"),
    "unit": ("alpha (gon),beta\n30,21\n", "'gon' is no unit"),
    "unit of x": ("t,x (parsec),y\n0,1,2\n", "known are m, cm, mm, px"),
    "units of x and y": ("t,x (px),y (m)\n0,1,2\n", "x and y are in units of one kind"),
    "radians": ("alpha,beta\n0.5,0.4\n1.0,0.8\n", "write alpha (rad) in the header"),
    "two kinds": ("alpha,beta,t,x,y\n30,21,0,0,0\n", "give the kind"),
    "no good row": ("alpha,beta\nx,y\nz,w\n", "no row can be read; column alpha: 'x'"),
    "error alone": ("alpha,beta,u_error\n30,21,1\n", "there is no column u"),
    "nought": ("alpha,beta\n30,2\0\n", "a character of code 0"),
    "long name": (f"alpha,beta,{'x' * 1000}\n30,21,1\n", "at most 200 characters"),
    "long line": ("alpha," + "beta" * 100_000, "no such"),
    "huge field": (f"alpha,beta\n30,{'9' * 200_000}\n", "no such"),
    "too many rows": ("alpha,beta\n" + "30,21\n" * 30_000, "at most 20000 rows"),
    "a million rows": ("alpha,beta\n" + "30,21\n" * 1_000_000, "at most 4 MB"),
    "many commas": ("," * 100_000 + "alpha,beta\n1\n", "no such"),
    "open quote": ('"alpha,beta\n30,21\n', "a wall needs alpha and beta"),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_tables_are_refused_with_a_reason(name):
    text, reason = HOSTILE[name]
    with pytest.raises(StatementError) as raised:
        table(text)
    assert len(str(raised.value)) < 400
    if reason != "no such":
        assert reason in str(raised.value)


@pytest.mark.parametrize("data", [b"\xff\xff\x00", b"alpha,beta\n30,\xe9\n", bytes(range(256))])
def test_what_is_no_text(data):
    with pytest.raises(StatementError, match="no text"):
        table(data)


def test_random_bytes_never_crash():
    """Pieces of tables and of nothing, put together at random, with a fixed seed."""
    draw = random.Random(1)
    pieces = 'alpha beta , ; \t \n " 30 21,5 ± u_A_x t x y 0 -1 nan e9 # (deg) / é \r ( u v _error'
    for _ in range(1500):
        text = "alpha,beta\n" * draw.randrange(2) + "".join(
            draw.choices([*pieces.split(" "), " "], k=draw.randrange(40))
        )
        with suppress(RestitutionError):
            r.experiment(text, angle_error=1)


HEADS = (
    "u_A_x,u_A_y,v_A_x,v_A_y,v_B_x,v_B_y",
    "u_A_x,u_A_y,v_A_x,v_A_y,v_B_x,v_B_y,line,m_A,m_B",
    "u_A_x,u_A_y,u_A_x_error,v_A_x,v_A_y,v_B_x,v_B_y",
    "t,x,y",
    "t,x,y,wall,body",
    "alpha,beta,u,v",
    "alpha,beta,beta_error,u,u_error,v",
)


def test_random_numbers_never_crash():
    """Tables of random numbers, some of them absurd, with a fixed seed; warnings are errors."""
    draw = random.Random(2)
    odd = ("0", "1e9", "-9e8", "1e-9", "1e-300", "1e300", "", "x", "nan", "30")
    for _ in range(250):
        names = draw.choice(HEADS).split(",")
        rows = [",".join(names)]
        for frame in range(draw.randrange(1, 25)):
            cells = {name: f"{draw.uniform(-2, 2):.3f}" for name in names}
            cells |= {name: f"{draw.uniform(1, 89):.1f}" for name in names if name.endswith("a")}
            cells |= {"t": f"{frame / 10}", "wall": "30"}
            cells |= {name: draw.choice(odd) for name in names if draw.random() < 0.03}
            cells["body"] = draw.choice("AB")
            rows.append(",".join(cells[name] for name in names))
        for errors in ({}, {"angle_error": 1.0, "speed_error": 0.05}):
            with suppress(RestitutionError):
                result = r.experiment("\n".join(rows), **errors)
                assert result.text(80)
                assert result.json()


def test_columns_of_unlike_length():
    with pytest.raises(StatementError, match="alpha has 2, beta has 1"):
        table({"alpha": [1, 2], "beta": [1]})


# --- the command ------------------------------------------------------------------------------


def test_command_tells_e(tmp_path):
    file = tmp_path / "angles.csv"
    file.write_text(PLAIN)
    status, output, messages = run("experiment", file, "--angle-error", "1")
    assert status == 0 and not messages
    assert "e = 0.673 ± 0.022" in output
    assert "Check of the model" in output


def test_command_reads_standard_input():
    status, output, _ = run("experiment", "-", "--format", "json", stdin=PLAIN.encode())
    assert status == 0
    assert output.startswith('{"kind": "wall"')
    assert output.count("\n") == 1


def test_command_says_what_was_left_out():
    data = PLAIN + "x,3\n"
    status, output, messages = run("experiment", "-", "--angle-error", "1", stdin=data.encode())
    assert status == 0
    assert messages == "-: left out: line 5, column alpha: 'x': this is no number\n"
    assert "Left out: 1 row" in output


@pytest.mark.parametrize(
    ("data", "options", "status", "message"),
    [
        (b"", [], 2, "-: the table is empty"),
        (b"alpha,beta\nx,y\n", [], 2, "-:2: no row can be read"),
        (b"alpha,beta\n30,21\n", [], 1, "-: one reading has no scatter"),
        (b"alpha,beta\n30,21\n", ["--angle-error", "-1"], 2, "an error is more than 0"),
        (b"alpha,beta\n30,21\n", ["--kind", "tracks"], 2, "tracks: no column t, x, y"),
        (b"alpha,beta\n30,21\n", ["-o", "report.txt"], 2, "ends in .html or .pdf"),
    ],
)
def test_command_statuses(data, options, status, message):
    done = run("experiment", "-", *options, stdin=data)
    assert done[0] == status
    assert message in " ".join(done[2].replace("│", " ").split())
    assert not done[1]


def test_command_without_a_file():
    status, _, messages = run("experiment", "no-such.csv")
    assert status == 2
    assert "no-such.csv: cannot be read" in messages


@pytest.mark.parametrize(
    ("error", "rule"),
    [
        ("0", "an error is more than 0, and finite"),
        ("-1", "an error is more than 0, and finite"),
        ("1e-300", "an error is at least 1e-09"),
        ("50", "the error of an angle is at most 45°"),
    ],
)
def test_an_error_that_cannot_be_is_refused_with_its_place(error, rule):
    result = r.experiment(f"alpha,beta,± alpha\n30,22,1\n45,36,{error}\n60,50,1\n")
    (fault,) = result.table.faults
    assert str(fault) == f"line 3, column ± alpha: {error!r}: {rule}"
    with pytest.raises(StatementError, match=rule):
        r.experiment("alpha,beta\n30,22\n45,36\n", angle_error=float(error))


def test_where_too_few_rows_are_left_those_left_out_are_named():
    with pytest.raises(MissingError, match=r"left out: line 2, column beta: 'nan'.*and 1 more"):
        r.experiment("alpha,beta\n30,nan\n45,36\n50,x\n")


@pytest.mark.parametrize("name", ["angle_error", "speed_error"])
def test_an_error_beyond_every_float_is_refused(name):
    with pytest.raises(StatementError, match="more than 0, and finite"):
        r.experiment(PLAIN, **{name: 10**400})
