"""The command as a user meets it: files, formats, statuses, messages, limits."""

from __future__ import annotations

import json
import os
import pty
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from commands import COMMAND, run, run_process

from restitution import examples

GOOD = "wall W: along i\nsphere P: mass 2, velocity 5i - 3j\nP hits W: e = 1/3\nfind impulse\n"
BAD = "sphere P: velocty 3i\nfind speed(P)\n"
MISSING = "wall W: along i\nsphere P: velocity 5i - 3j\nP hits W: e = 1/3\nfind impulse, speed(P)\n"


@pytest.fixture
def folder(tmp_path):
    for name, text in (("good", GOOD), ("bad", BAD), ("missing", MISSING)):
        (tmp_path / f"{name}.impact").write_text(text)
    return tmp_path


# --- solve ------------------------------------------------------------------------------------


def test_solve_prints_the_working(folder):
    status, out, err = run_process("solve", "good.impact", cwd=folder)
    assert (status, err) == (0, "")
    assert "Newton's experimental law" in out
    assert "8" in out
    assert max(map(len, out.splitlines())) <= 80


def test_marks_of_a_working(folder):
    marks = re.compile(r"\b(?:DM|M|A|B)1(?:ft|\*)?(?!\w)")
    status, usual, _ = run("solve", "good.impact", cwd=folder)
    assert (status, bool(marks.search(usual))) == (0, True)
    assert run("solve", "good.impact", "--marks", "fm1", cwd=folder)[1] == usual
    status, bare, _ = run("solve", "good.impact", "--marks", "none", cwd=folder)
    assert (status, marks.search(bare)) == (0, None)
    lines = [marks.sub("", line).split() for line in usual.splitlines()]
    assert [line.split() for line in bare.splitlines()] == lines


def test_the_working_as_data_belongs_to_json(folder):
    plain = run("solve", "good.impact", "--format", "json", cwd=folder)[1]
    assert "derivation" not in json.loads(plain)["parts"][0]
    status, out, err = run("solve", "good.impact", "--format", "json", "--working", cwd=folder)
    assert (status, err) == (0, "")
    assert all("derivation" in part for part in json.loads(out)["parts"])
    for options, said in (
        (["--working"], "the working as data needs --format json; text has it in words"),
        (["--working", "-f", "html"], "the working as data needs --format json; html has it"),
        (["--working", "-f", "json", "--answers-only"], "with --answers-only there is no working"),
        (["--check", "--answers-only"], "with --answers-only there is no working"),
    ):
        status, out, err = run("solve", "good.impact", *options, cwd=folder)
        assert (status, out) == (2, "")
        assert said in " ".join(err.split())


def test_a_file_that_cannot_be_solved_has_parts_without_derivations(folder):
    name = "missing.impact"
    options = ("--format", "json", "--working", "--time-limit", "0.001")
    status, out, _ = run("solve", name, *options, cwd=folder)
    assert status == 1
    assert [part["derivation"] for part in json.loads(out)["parts"]] == [None]


def test_an_item_without_an_answer_has_a_note_in_the_derivation(folder):
    options = ("--format", "json", "--working", "--time-limit", "50")
    status, out, _ = run("solve", "missing.impact", *options, cwd=folder)
    assert status == 1
    (part,) = json.loads(out)["parts"]
    assert [each["kind"] for each in part["derivation"]["notes"]] == ["missing"]
    assert [each["item"] for each in part["derivation"]["items"]] == ["2"]


def test_a_check_tells_whether_the_working_was_followed(folder):
    status, out, err = run("solve", "good.impact", "--check", cwd=folder)
    assert "Newton's experimental law" in out
    followed = "good.impact: every line of the working was followed exactly" in err
    assert status == (0 if followed else 1)
    assert "followed" in err


def test_standard_input(folder):
    status, out, _ = run("solve", "-", "--answers-only", stdin=GOOD.encode())
    assert (status, out.strip()) == (0, "impulse = 8  N s")


def test_statuses(folder):
    def status(*names):
        return run("solve", *names, "--format", "json", cwd=folder)[0]

    assert status("good.impact") == 0
    assert status("missing.impact") == 1
    assert status("good.impact", "missing.impact") == 1
    assert status("bad.impact") == 2
    assert status("missing.impact", "bad.impact", "good.impact") == 2
    assert status("no-such-file.impact") == 2
    assert status(".") == 2


def test_a_refuted_show_is_an_answer():
    text = GOOD.replace("find impulse", "show impulse = 9")
    status, out, _ = run("solve", "-", "-f", "json", stdin=text.encode())
    assert status == 0
    assert json.loads(out)["parts"][0]["items"][0]["holds"] is False


UNDECIDED = (
    "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\nshow sin(alpha) < alpha\n"
)


def test_what_the_working_proves_has_no_warning():
    statement = (
        b"wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\n"
        b"find range of deflection(P) in terms of alpha\n"
    )
    status, out, err = run("solve", "-", stdin=statement)
    assert (status, err) == (0, "")
    assert "α ≤ δ ≤ 2α" in out
    # Without the working there is no proof of it.
    assert "not proved" in run("solve", "-", "--answers-only", stdin=statement)[2]


@pytest.mark.parametrize("form", ["text", "markdown", "latex", "html"])
@pytest.mark.parametrize("answers_only", [True, False])
def test_an_undecided_show_is_answered_with_a_warning(form, answers_only):
    options = ["--answers-only"] * answers_only
    status, out, err = run("solve", "-", "-f", form, *options, stdin=UNDECIDED.encode())
    assert status == 0
    assert "warning: sin(alpha) < alpha: this is not decided" in err
    assert "not decided" in out
    assert "A1*" not in out
    assert "hown" not in out


def test_an_undecided_show_in_json():
    status, out, err = run("solve", "-", "-f", "json", stdin=UNDECIDED.encode())
    content = json.loads(out)
    (item,) = content["parts"][0]["items"]
    assert (status, err) == (0, "")
    assert (item["holds"], item["proof"]) == (None, "undecided")
    assert "not decided" in content["warnings"][0]


CONDITIONAL = (
    "wall W: along i\nsphere P: mass 1, velocity a i - 4j\nP hits W\ngiven speed(P) = 5\nfind e\n"
)


@pytest.mark.parametrize(
    ("form", "said"),
    [
        ("text", "e = √(25 − a²)/4, for −5 ≤ a ≤ −3 or 3 ≤ a ≤ 5"),
        ("markdown", r"$\frac{\sqrt{25 - a^{2}}}{4}$, for $-5 \leq a \leq -3$ or $3 \leq a"),
        ("latex", r"$\frac{\sqrt{25 - a^{2}}}{4}$, for $-5 \leq a \leq -3$ or $3 \leq a"),
        ("html", "</math>,</span> for <math>"),
    ],
)
def test_an_answer_with_its_condition(form, said):
    """The words are outside the mathematics: lines end between them, and readers hear them."""
    _, out, _ = run("solve", "-", "-f", form, "--answers-only", stdin=CONDITIONAL.encode())
    assert said in out
    _, out, _ = run("solve", "-", "-f", form, stdin=CONDITIONAL.encode())
    assert "his holds for" in out


def test_numbers_that_refute_are_written_as_people_do():
    text = UNDECIDED.replace("sin(alpha) < alpha", "speed(P) = u")
    _, out, _ = run("solve", "-", "--answers-only", stdin=text.encode())
    assert re.search("not true, for instance with α = [0-9]+°, e = ", out)
    assert "alpha" not in out


def test_one_bad_file_does_not_stop_the_rest(folder):
    status, out, err = run(
        "solve", "bad.impact", "gone.impact", "good.impact", "--answers-only", cwd=folder
    )
    assert status == 2
    assert "impulse = 8" in out
    assert "=== good.impact ===" in out
    assert "bad.impact:1:11" in err
    assert "gone.impact: cannot be read" in err
    assert "\r" not in err, "no progress where nobody looks"


def test_mistake_is_shown_with_a_caret(folder):
    for command in ("solve", "check"):
        status, out, err = run(command, "bad.impact", cwd=folder)
        assert (status, out) == (2, "")
        first, second, third, hint = err.splitlines()
        assert hint == "  fix | " + second.partition("| ")[2].replace("velocty", "velocity")
        assert first.startswith("bad.impact:1:11: ")
        assert "velocity" in first
        assert second.endswith("| sphere P: velocty 3i")
        assert second[third.index("^")] == "v"


def test_caret_in_a_long_line_with_wide_letters(tmp_path):
    text = "title 漢字\nsphere P: velocity " + "1 + " * 60 + "velocty\nfind speed(P)\n"
    (tmp_path / "long.impact").write_text(text, encoding="utf-8")
    status, _, err = run("check", "long.impact", cwd=tmp_path)
    _, shown, caret, *_ = err.splitlines()
    assert status == 2
    assert len(shown) < 90
    assert shown[caret.index("^") :].startswith("velocty")


def test_missing_datum_is_located(folder):
    status, out, err = run("solve", "missing.impact", "--answers-only", cwd=folder)
    assert status == 1
    assert "speed(P) = √26" in out
    assert "missing.impact:4:6: missing: " in err


def test_part_and_unknown_part():
    text = GOOD.replace("find impulse", "part a\nfind impulse\npart b\nfind speed(P)")
    status, out, _ = run("solve", "-", "--part", "b", "--answers-only", stdin=text.encode())
    assert status == 0
    assert "speed(P)" in out
    assert "impulse" not in out
    status, _, err = run("solve", "-", "--part", "c", stdin=text.encode())
    assert status == 2
    assert "a, b" in err


@pytest.mark.parametrize("answers_only", [False, True])
@pytest.mark.parametrize(
    ("form", "ending", "sign"),
    [
        ("text", ".txt", "8"),
        ("markdown", ".md", "$"),
        ("latex", ".tex", "\\"),
        ("html", ".html", "<math"),
        ("json", ".json", '{"file"'),
    ],
)
def test_formats(folder, form, ending, sign, answers_only):
    extra = ["--answers-only"] if answers_only else []
    path = folder / f"out{ending}"
    status, out, _ = run("solve", "good.impact", "-f", form, "-o", path, *extra, cwd=folder)
    assert (status, out) == (0, "")
    assert sign in path.read_text(encoding="utf-8")
    # The same to standard output, and into a folder.
    assert run("solve", "good.impact", "-f", form, *extra, cwd=folder)[1] == path.read_text(
        encoding="utf-8"
    )
    run("solve", "good.impact", "-f", form, "-o", "sub/", *extra, cwd=folder)
    assert (folder / "sub" / f"good{ending}").read_text("utf-8") == path.read_text("utf-8")


def test_output_is_refused_where_something_would_be_lost(folder):
    (folder / "sub").mkdir()
    (folder / "sub" / "good.impact").write_text(GOOD)
    for arguments in (
        ["good.impact", "-o", "good.impact"],
        ["good.impact", "sub/good.impact", "-o", "out/"],
        ["good.impact", "missing.impact", "-f", "html"],
    ):
        status, out, err = run("solve", *arguments, cwd=folder)
        assert (status, out) == (2, ""), arguments
        assert err
    assert (folder / "good.impact").read_text() == GOOD
    status, _, err = run("solve", "good.impact", "-o", "no/such/folder.txt", cwd=folder)
    assert status == 1
    assert "cannot be written" in err


def test_a_wrong_option_is_explained():
    for arguments in (["solve"], ["solve", "-", "--format", "pdf"], ["solv"], ["-x"]):
        status, _, err = run(*arguments)
        assert status == 2
        assert "Usage" in err
    assert run("solve", "-", "--time-limit", "nan", stdin=b"")[0] == 2
    assert run("solve", "-", "--time-limit", "-1", stdin=b"")[0] == 2


def test_example_named_as_a_file():
    status, _, err = run("solve", "corner")
    assert status == 2
    assert "restitution examples corner" in err


# --- limits and interruptions -----------------------------------------------------------------


def slow(monkeypatch_dir: Path) -> dict[str, str]:
    """An environment in which solving never ends, and cannot be interrupted from inside."""
    (monkeypatch_dir / "sitecustomize.py").write_text(
        "import sys, signal, time\n"
        "from pathlib import Path\n"
        "class Finder:\n"
        "    def find_spec(self, name, path=None, target=None):\n"
        "        if name == 'restitution.killable':\n"
        "            import restitution.cli.worker\n"
        "            def spin(request):\n"
        "                if hasattr(signal, 'pthread_sigmask'):\n"
        "                    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGALRM])\n"
        f"                Path({str(monkeypatch_dir / 'begun')!r}).touch()\n"
        "                while True: time.sleep(0.1)\n"
        "            restitution.cli.worker._serve = spin\n"
        "        return None\n"
        "sys.meta_path.insert(0, Finder())\n"
    )
    return {"PYTHONPATH": str(monkeypatch_dir)}


def test_time_limit(folder, tmp_path):
    env = slow(tmp_path)
    # Without the limit it would never come back, and the test would fail by its own.
    status, out, err = run_process(
        "solve", "good.impact", "bad.impact", "missing.impact", "--time-limit", "0.3", "-f", "json",
        cwd=folder, env=env,
    )  # fmt: skip
    assert status == 2, "of the file that cannot be read"
    first, second, third = map(json.loads, out.splitlines())
    assert first["error"]["kind"] == third["error"]["kind"] == "time limit"
    assert second["error"]["kind"] == "syntax"
    # What was asked is still said, each item without an answer.
    (item,) = first["parts"][0]["items"]
    assert (item["text"], item["line"], item["answers"]) == ("impulse", 4, [])
    assert item["error"]["kind"] == "time limit"
    assert err.count("time limit") == err.count("--time-limit gives it longer") == 2


@pytest.mark.nightly  # what a time limit leaves is an item without an answer, as any other
def test_the_status_of_a_time_limit(folder, tmp_path):
    env = slow(tmp_path)
    assert run_process("solve", "good.impact", "--time-limit", "0.3", cwd=folder, env=env)[0] == 1


def test_control_c(folder, tmp_path):
    process = subprocess.Popen(
        [*COMMAND, "solve", "good.impact", "--time-limit", "0"],
        cwd=folder,
        env={**os.environ, **slow(tmp_path)},
        stderr=subprocess.PIPE,
        stdout=subprocess.PIPE,
        start_new_session=True,
    )
    while not (tmp_path / "begun").exists():
        assert process.poll() is None
        time.sleep(0.05)
    # As a terminal does: to the command and to the process that solves.
    os.killpg(process.pid, signal.SIGINT)
    out, err = process.communicate(timeout=100)
    assert (process.returncode, out, err) == (130, b"", b"interrupted\n")
    with pytest.raises(ProcessLookupError):
        os.killpg(process.pid, 0)


def test_reader_who_goes_away(folder):
    """He has gone before anything is written: nothing of it is told."""
    end, beginning = os.pipe()
    os.close(end)
    done = subprocess.run(
        [*COMMAND, "solve", "good.impact", "good.impact"],
        stdout=beginning,
        stderr=subprocess.PIPE,
        check=False,
        cwd=folder,
        timeout=100,
    )
    os.close(beginning)
    assert (done.returncode, done.stderr) == (1, b"")


WRITING = {
    "solve": "solve good.impact",
    "as JSON": "solve good.impact good.impact -f json",
    "draw": "draw good.impact",
    "sheet": "sheet good.impact -f html -o -",
    "play": "play good.impact -o -",
    "check": "check good.impact",
    "examples": "examples",
    "one example": "examples corner",
    "language": "language",
    "help": "--help",
    "version": "--version",
}
READING = ["check -", "solve -", "draw -", "sheet - -f html -o -", "play - -o -"]


def redirected(folder, rest):
    """The command with streams that a shell has closed or put elsewhere."""
    done = subprocess.run(
        ["sh", "-c", f"exec {sys.executable} -m restitution {rest}"],
        capture_output=True,
        check=False,
        cwd=folder,
        timeout=60,
    )
    return done.returncode, done.stdout.decode(), done.stderr.decode()


# Each is a process or two of its own; the nightly run has all.
IN_THE_NORMAL_RUN = {"solve", "help", READING[0]}


def some(names):
    """All of these; the nightly run alone has those that are not in the normal one."""
    return [
        pytest.param(name, marks=() if name in IN_THE_NORMAL_RUN else pytest.mark.nightly)
        for name in names
    ]


@pytest.mark.parametrize("name", some(WRITING))
def test_an_output_that_is_closed_or_full(folder, name):
    said = "standard output: cannot be written: "
    assert redirected(folder, f"{WRITING[name]} >&-") == (1, "", f"{said}it is closed\n")
    if Path("/dev/full").exists():
        full = redirected(folder, f"{WRITING[name]} > /dev/full")
        assert full == (1, "", f"{said}No space left on device\n")


@pytest.mark.parametrize("rest", some(READING))
def test_an_input_that_is_closed(folder, rest):
    status, out, err = redirected(folder, f"{rest} <&-")
    assert (status, out, err) == (2, "", "-: cannot be read: standard input is closed\n")


def test_what_is_not_needed_may_be_closed(folder):
    status, out, err = redirected(folder, "solve good.impact -o made.txt <&- >&- 2>&-")
    assert (status, out, err) == (0, "", "")
    assert "Newton" in (folder / "made.txt").read_text()


@pytest.mark.nightly
def test_messages_that_nobody_sees_are_lost(folder):
    status, out, _ = redirected(folder, "solve good.impact missing.impact --answers-only 2>&-")
    assert status == 1
    assert "impulse = 8" in out


def test_a_file_that_is_full(folder):
    if Path("/dev/full").exists():
        status, out, err = run("solve", "good.impact", "-o", "/dev/full", cwd=folder)
        assert (status, out) == (1, "")
        assert err == "/dev/full: cannot be written: No space left on device\n"


def test_no_name_of_python_reaches_a_reader():
    from restitution.errors import TimeLimitError
    from restitution.killable import portable
    from restitution.solving.worker import UNFORESEEN, unforeseen

    for kind in UNFORESEEN:
        for said in (unforeseen(kind("no attribute")).message, str(portable(kind("of NoneType")))):
            assert kind.__name__ not in said
            assert "attribute" not in said
            assert "NoneType" not in said
            assert "fault of the program" in said
    assert portable(TimeLimitError("too long")).message == "too long"


def test_progress_on_a_terminal(folder):
    primary, secondary = pty.openpty()
    done = subprocess.Popen(
        [*COMMAND, "solve", "good.impact", "missing.impact", "-f", "json"],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=secondary,
        env={**os.environ, "TERM": "xterm"},
    )
    os.close(secondary)
    out, _ = done.communicate(timeout=100)
    seen = b""
    try:
        while chunk := os.read(primary, 4096):
            seen += chunk
    except OSError:
        pass
    os.close(primary)
    assert len(out.splitlines()) == 2
    assert b"good.impact" in seen
    assert b"/2" in seen


def on_a_terminal(folder, arguments, term="xterm"):
    """Standard output as it goes to a terminal."""
    primary, secondary = pty.openpty()
    done = subprocess.Popen(
        [*COMMAND, *arguments],
        cwd=folder,
        stdout=secondary,
        stderr=subprocess.PIPE,
        env={**os.environ, "TERM": term},
    )
    os.close(secondary)
    seen = b""
    try:
        while chunk := os.read(primary, 4096):
            seen += chunk
    except OSError:
        pass
    done.communicate(timeout=100)
    os.close(primary)
    return seen.decode()


def test_bold_type_on_a_terminal_and_nowhere_else(folder):
    (folder / "titled.impact").write_text("title A wall\n" + GOOD, encoding="utf-8")
    assert "\x1b[1mA wall\x1b[0m" in on_a_terminal(folder, ["solve", "titled.impact"])
    _, out, _ = run("solve", "titled.impact", cwd=folder)
    assert "\x1b" not in out
    run("solve", "titled.impact", "-o", "out.txt", cwd=folder)
    assert "\x1b" not in (folder / "out.txt").read_text(encoding="utf-8")


@pytest.mark.nightly
def test_no_bold_type_where_a_terminal_or_a_format_has_none(folder):
    (folder / "titled.impact").write_text("title A wall\n" + GOOD, encoding="utf-8")
    assert "\x1b" not in on_a_terminal(folder, ["solve", "titled.impact"], term="dumb")
    assert "\x1b" not in on_a_terminal(folder, ["solve", "titled.impact", "-f", "latex"])


# --- the other commands -----------------------------------------------------------------------


def test_check(folder):
    status, out, err = run("check", "good.impact", "-", cwd=folder, stdin=GOOD.encode())
    assert (status, err) == (0, "")
    assert out.splitlines()[0] == "good.impact: reads well: 1 sphere, 1 wall, 1 event; 1 item asked"


def test_examples():
    status, out, _ = run("examples")
    assert status == 0
    listed = [line.split()[0] for line in out.splitlines() if line.startswith("  ")]
    assert sorted(listed) == list(examples.names())
    assert out.startswith("One wall\n  wall-with-vectors ")
    status, out, _ = run("examples", "corner")
    assert (status, out) == (0, examples.text("corner"))
    status, _, err = run("examples", "cornre")
    assert status == 2
    assert "corner" in err


def test_language_is_the_page_of_the_documentation():
    status, out, _ = run("language")
    page = Path(__file__).parents[1] / "docs" / "language.md"
    assert (status, out) == (0, page.read_text(encoding="utf-8"))


def test_version_and_help():
    assert re.fullmatch(r"restitution \d+\.\d+\.\d+\S*\n", run("--version")[1])
    status, out, _ = run("--help")
    assert status == 0
    # The statement in the help is one that can be solved.
    statement = "\n".join(line for line in out.splitlines() if line.startswith("      "))
    statement = statement.split("      restitution solve")[0]
    status, solved, _ = run("solve", "-", "--answers-only", stdin=statement.encode())
    assert status == 0
    assert "velocity(P) = 5𝐢 + 𝐣" in solved
    for command in ("solve", "check", "examples", "language"):
        assert command in out
        assert run(command, "--help")[0] == 0


def test_completion_writes_nothing_at_home(tmp_path):
    env = {"HOME": str(tmp_path), "_TYPER_COMPLETE_TEST_DISABLE_SHELL_DETECTION": "1"}
    status, out, _ = run_process("--show-completion", "bash", env=env)
    assert status == 0
    assert "_RESTITUTION_COMPLETE" in out
    words = {
        "_RESTITUTION_COMPLETE": "complete_bash",
        "COMP_WORDS": "restitution examples cor",
        "COMP_CWORD": "2",
    }
    out = run_process(env={**env, **words})[1]
    assert "corner" in out.split()
    run_process("solve", "-", stdin=GOOD.encode(), env=env)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("usual", "otherwise"),
    [
        ("good.impact -f json", "-fjson good.impact"),
        ("good.impact --format markdown --part a", "--part=a --format=markdown good.impact"),
        ("good.impact --answers-only", "--answers-only -- good.impact"),
        ("good.impact --marks none", "--marks=none good.impact"),
        ("good.impact -f json --working --marks m4", "-fjson --working --marks=m4 good.impact"),
        ("good.impact --check --route 2", "--check --route=2 good.impact"),
        ("good.impact --working", "--working -- good.impact"),
        (
            "good.impact missing.impact --time-limit 40",
            "--time-limit=40.0 good.impact missing.impact",
        ),
        ("good.impact bad.impact -f html", "-fhtml good.impact bad.impact"),
        ("good.impact --time-limit 9999999", "--time-limit=9999999 good.impact"),
    ],
)
def test_a_command_in_its_usual_form_is_read_as_in_any_other(folder, usual, otherwise):
    """The usual form is read without the library that reads the others."""
    from restitution.cli.solving import plainly

    assert plainly(usual.split()) is not None
    assert plainly(otherwise.split()) is None
    one, other = (run("solve", *each.split(), cwd=folder) for each in (usual, otherwise))
    assert one == other


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["--answers-only"],
        ["a.impact", "--format", "word"],
        ["a.impact", "--format"],
        ["a.impact", "-f", "json", "--format", "text"],
        ["a.impact", "--time-limit", "-1"],
        ["a.impact", "--time-limit", "1e3"],
        ["a.impact", "--marks", "ocr"],
        ["a.impact", "--marks", "m4", "--marks", "m4"],
        ["a.impact", "--route", "0"],
        ["a.impact", "--route", "4"],
        ["a.impact", "--part", "--answers-only"],
        ["a.impact", "--debug"],
        ["a.impact", "--help"],
        ["a.impact", "-h"],
        ["a.impact", ""],
        ["a.impact", "b\udcff.impact"],
    ],
)
def test_any_other_form_is_left_to_the_library_that_reads_options(arguments):
    from restitution.cli.solving import plainly

    assert plainly(arguments) is None


def test_the_usual_form_of_a_command():
    from restitution.cli.output import Format, Marks
    from restitution.cli.solving import Solving, plainly

    assert plainly(["a.impact"]) == Solving(("a.impact",))
    every = [
        "-o",
        "-",
        "a.impact",
        "--time-limit",
        "2.5",
        "-f",
        "latex",
        "-",
        "--part",
        "a",
        "--answers-only",
        "--working",
        "--marks",
        "caie",
        "--route",
        "2",
        "--check",
    ]
    assert plainly(every) == Solving(
        ("a.impact", "-"), Format.latex, "-", "a", True, 2.5, Marks.caie, True, 2, True
    )


def test_a_sum_loads_no_tensors():
    """And whoever wants tensors gets them."""
    code = (
        "import sys\n"
        "from restitution.export.job import prepare, rehearse\n"
        "prepare()\n"
        "rehearse()\n"
        "print('sympy.combinatorics' in sys.modules)\n"
        "from sympy.tensor.tensor import TensorHead, TensorIndexType, tensor_indices\n"
        "L = TensorIndexType('L', dummy_name='L', dim=3)\n"
        "a = tensor_indices('a', L)\n"
        "A = TensorHead('A', [L])\n"
        "print(A(a) + A(a))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=100
    )
    assert done.stdout.split() == ["False", "2*A(a)"], done.stderr


def test_what_solves_is_loaded_before_the_statement_is_there():
    """Else the process is ready at once, finds no statement, and rehearses in the way of it."""
    code = (
        "import sys\n"
        "from restitution.export.job import Job, load_what_few_need, prepare, serve\n"
        "prepare()\n"
        "load_what_few_need()\n"
        "loaded = set(sys.modules)\n"
        "from restitution import examples, parse\n"
        "problem = parse(examples.text('corner'))\n"
        "serve(Job('corner', problem))\n"
        "late = {name for name in sys.modules if name.startswith('restitution')} - loaded\n"
        "print(*sorted(name for name in late if '.language' not in name))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=100
    )
    assert not done.returncode, done.stderr
    late = set(done.stdout.split())
    assert late <= {"restitution.examples", "restitution.examples.topics", "restitution.mending"}


def test_what_both_processes_need_is_loaded_before_they_part():
    """Else each of them loads it for itself."""
    begin = (
        "import sys\n"
        "from restitution.cli.worker import load_shared\n"
        "load_shared()\n"
        "assert 'sympy' not in sys.modules\n"
        "loaded = set(sys.modules)\n"
    )
    reading = (
        "from restitution import examples\n"
        "from restitution.cli.files import parse\n"
        "parse(examples.text('corner').encode())\n"
    )
    solving = "from restitution.export.job import prepare\nprepare()\n"
    end = "print(*(set(sys.modules) - loaded))\n"
    late = []
    for work in (reading, solving):
        done = subprocess.run(
            [sys.executable, "-c", begin + work + end],
            capture_output=True,
            text=True,
            check=False,
            timeout=100,
        )
        assert not done.returncode, done.stderr
        late.append(set(done.stdout.split()))
    assert late[1]
    both = {name for name in set.intersection(*late) if name.startswith(("restitution", "lark"))}
    assert both == set()


def test_the_asking_process_loads_no_algebra(folder):
    code = (
        "import sys; sys.argv = ['restitution', 'solve', 'good.impact', '-f', 'json']\n"
        "from restitution.cli import main\n"
        "try: main()\n"
        "except SystemExit: pass\n"
        "heavy = ('sympy', 'numpy', 'rich', 'ziamath', 'typer', 'click', 'pydantic')\n"
        "print([m for m in heavy if m in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=False,
        cwd=folder,
        timeout=100,
    )
    assert done.stdout.splitlines()[-1] == "[]", done.stderr


# --- draw, sheet ------------------------------------------------------------------------------

TWO = (
    "wall AB: along i\nwall BC: along 60°\nsphere P: velocity u at 60° to AB\n"
    "P hits AB: e = 1/2\nP hits BC: e = 1/2\nfind speed(P)\n"
)


@pytest.mark.parametrize(
    ("name", "begins"), [("p.svg", b"<svg"), ("p.png", b"\x89PNG"), ("p.pdf", b"%PDF")]
)
def test_pictures_by_the_ending_of_their_name(folder, name, begins):
    status, out, err = run("draw", "good.impact", "-o", name, cwd=folder)
    assert (status, out, err) == (0, "", "")
    assert (folder / name).read_bytes().startswith(begins)


def test_one_picture_or_all(folder):
    (folder / "two.impact").write_text(TWO)
    _, every, _ = run("draw", "two.impact", cwd=folder)
    _, second, _ = run("draw", "two.impact", "--event", "2", cwd=folder)
    assert all(each in every for each in ("Path of P", "P hits AB", "P hits BC"))
    assert "P hits BC" in second and "P hits AB" not in second
    status, _, err = run("draw", "two.impact", "--event", "3", cwd=folder)
    assert status == 1
    assert "there is no picture of event 3: pictured are 1, 2" in err


def test_what_cannot_be_drawn_is_said(folder):
    status, out, err = run("draw", "bad.impact", "-o", "p.svg", cwd=folder)
    assert (status, out) == (2, "")
    assert "bad.impact:1:11" in err and not (folder / "p.svg").exists()
    status, _, err = run("draw", "good.impact", "-o", "p.gif", cwd=folder)
    assert status == 2 and ".svg, .png, .pdf" in err
    status, _, err = run("draw", "good.impact", "-o", "good.impact", "-f", "svg", cwd=folder)
    assert status == 2 and "overwritten" in err
    assert (folder / "good.impact").read_text() == GOOD
    status, _, err = run("draw", "good.impact", "-o", "no/p.svg", cwd=folder)
    assert status == 1 and "cannot be written" in err


@pytest.mark.parametrize(("name", "begins"), [("s.pdf", b"%PDF"), ("s.html", b"<!DOCTYPE html>")])
def test_a_bad_file_does_not_stop_the_sheet(folder, name, begins):
    status, out, err = run(
        *("sheet", "good.impact", "bad.impact", "missing.impact"),
        *("-o", name, "--solutions"),
        cwd=folder,
    )
    assert (status, out) == (2, "")
    assert "bad.impact:1:11" in err and "the mass of P" in err
    made = (folder / name).read_bytes()
    assert made.startswith(begins)
    if name == "s.html":
        assert made.count(b'<section class="entry">') == 4  # two questions, and their solutions


def test_no_sheet_of_nothing(folder):
    status, _, _ = run("sheet", "bad.impact", "-o", "s.pdf", cwd=folder)
    assert status == 2 and not (folder / "s.pdf").exists()
    status, _, err = run("sheet", "good.impact", cwd=folder)
    assert status == 2 and "--output" in err


def test_a_format_may_be_called_by_its_ending(folder):
    for ending, form in (("md", "markdown"), ("tex", "latex"), ("txt", "text")):
        one, other = (
            run("solve", "good.impact", "-f", name, cwd=folder) for name in (ending, form)
        )
        assert one == other and one[0] == 0


def test_a_long_line_that_is_quoted_shows_that_it_goes_on(folder):
    text = f"sphere P: mass 2, velocity 3i {'+ 0i ' * 20}@ j"
    _, _, messages = run("check", "-", stdin=text.encode(), cwd=folder)
    (quoted,) = (row for row in messages.splitlines() if " | " in row and "^" not in row)
    assert quoted.endswith("j")
    _, _, messages = run("check", "-", stdin=f"spere P: {'very ' * 30}".encode(), cwd=folder)
    (quoted, *_) = (row for row in messages.splitlines() if " | " in row and "^" not in row)
    assert quoted.endswith("…") and len(quoted) <= 80


def test_that_there_is_no_further_way_is_said(folder):
    status, out, err = run("solve", "good.impact", "--route", "2", cwd=folder)
    assert (status, out) == run("solve", "good.impact", cwd=folder)[:2]
    assert err == "good.impact: there is no further way: this is that of --route 1\n"
    two_ways = examples.text("mass-ratio").encode()
    for stdin, route in ((GOOD.encode(), "1"), (two_ways, "2")):
        assert "further way" not in run("solve", "-", "--route", route, stdin=stdin)[2]
