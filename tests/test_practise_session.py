"""Practice in the terminal, and a teacher's question varied."""

from __future__ import annotations

import json

import pytest
from commands import run

import restitution as r
from restitution.cli import practising
from restitution.errors import StatementError, UnsupportedError
from restitution.practice.questions.generate import practice_question
from restitution.practice.questions.session import (
    GUIDE,
    Conversation,
    Progress,
    State,
    Wanted,
    first_question,
)
from restitution.practice.questions.varying import variant


def talk(question, *lines):
    """What a conversation says to some lines, its outcome, and its attempt."""
    left, shown = list(lines), []
    conversation = Conversation(question, lambda _: left.pop(0) if left else None, shown.append)
    outcome = conversation.hold()
    return "\n".join(shown), outcome, conversation.attempt(100)


QUESTION = practice_question("wall-forward", 1, 1)  # -10i + 4j, a wall along j, e = 3/4


def test_a_right_answer_has_all_marks():
    shown, outcome, attempt = talk(
        QUESTION,
        "v_x = 3/4 * 10 = 7.5",
        "velocity = 7.5i + 4j",
        "speed = sqrt(7.5^2 + 4^2) = 8.5",
        "",
    )
    assert "speed of A immediately after" in shown
    assert "5 of 5 marks" in shown
    assert outcome == "quit"
    assert attempt["earned"] == attempt["of"] == 5
    assert not attempt["lost_method"]


def test_a_wrong_answer_loses_marks_and_may_be_tried_again():
    shown, outcome, attempt = talk(QUESTION, "speed = 2", "", "", "", "next")
    assert "Try again" in shown
    assert attempt["earned"] < attempt["of"]
    assert attempt["lost_method"]
    assert outcome == "next"


def test_lines_are_counted_as_they_were_typed():
    question = practice_question("sphere-at-rest", 2, 1)
    assert [part.label for part in question.question.parts if part.marks] == ["a", "b"]
    lines = ("x = 3 - 1", "v = 1", "", "y = 3", "z = 5 - 1", "", "", "quit")
    shown = talk(question, *lines[:2], "", "", *lines[3:])[0]
    numbered = [row for row in shown.splitlines() if row[:1].isdigit()]
    assert [row[:1] + row[3:] for row in numbered][:4] == [
        *("1 x = 3 - 1", "2 v = 1", "3 y = 3", "4 z = 5 - 1")
    ]


def test_hints_and_the_working_are_there():
    shown, _, attempt = talk(QUESTION, "hint", "show", "next")
    assert "What happens to the component" in shown or "What does e tell" in shown
    assert "Newton's experimental law" in shown
    assert attempt is None


def test_a_hint_for_a_line_says_for_which():
    shown = talk(QUESTION, "10 cos 40 = 7.66", "speed = 2", "hint", "quit")[0]
    assert "Line 2: " in shown


def test_a_hint_asked_again_is_longer():
    one, two, three = (talk(QUESTION, *["hint"] * n, "quit")[0] for n in (1, 2, 3))
    before = len(talk(QUESTION, "quit")[0])
    first, second, third = one[before:], two[len(one) :], three[len(two) :]
    assert "?" in first and len(set(map(str.strip, (first, second, third)))) == 3
    assert len(third) > len(second) and "the wall" in third
    shown, _, _ = talk(QUESTION, *["hint"] * 6, "quit")
    assert "There is no longer hint: show gives the working." in shown


def test_help_is_no_working():
    shown, _, attempt = talk(QUESTION, "help", "quit")
    assert shown.endswith(GUIDE) and attempt is None


@pytest.mark.parametrize("word", ["next", "quit", "another", "SKIP", "q"])
def test_words_end_a_question(word):
    _, outcome, _ = talk(QUESTION, word)
    assert outcome == {"skip": "next", "q": "quit"}.get(word.lower(), word.lower())


@pytest.mark.parametrize("line", ["\0", "x" * 5000, "__import__('os')", "((((", "é" * 300])
def test_whatever_is_typed_is_borne(line):
    _, outcome, _ = talk(QUESTION, line, "", "quit")
    assert outcome == "quit"


def test_a_question_left_open_comes_again():
    state = State([], {"topic": "wall-energy", "level": 2, "seed": 9, "mistake": None})
    assert first_question(Wanted(), state, 100, 1).address == "wall-energy/2/9/v3"
    assert first_question(Wanted("wall-angle"), state, 100, 4).address == "wall-angle/1/4/v3"


@pytest.mark.parametrize("opened", [{}, {"topic": 3}, {"topic": "wall-energy", "level": 99}, 5])
def test_what_is_no_open_question_is_left(opened):
    state = State.of_json(json.dumps({"attempts": [3, {}], "open": opened}))
    assert first_question(Wanted(), state, 100, 1).address == "wall-forward/1/1/v3"


@pytest.mark.parametrize("text", ["", "[]", "{}", "{" * 10**5, '{"attempts": 3}'])
def test_what_is_no_state_is_told(text):
    with pytest.raises(StatementError, match="no file of practice"):
        State.of_json(text)


def test_the_state_survives_its_file():
    state = State([{"topic": "ranges"}], {"topic": "ranges", "level": 1, "seed": 2})
    assert State.of_json(state.to_json()) == state


# --- the command --------------------------------------------------------------------------------


def test_the_command_writes_a_statement(tmp_path):
    path = tmp_path / "q.impact"
    status, _, _ = run("practise", "spheres-vectors", "--seed", "3", "-o", path)
    assert status == 0
    assert path.read_text() == practice_question("spheres-vectors", 1, 3).statement
    _, output, _ = run("practise", "spheres-vectors", "--seed", "3", "-o", "-")
    assert output == path.read_text()


def test_the_command_lists_topics():
    _, output, _ = run("practise", "--topics")
    assert "wall-forward" in output
    assert max(map(len, output.splitlines())) <= 80


def test_topics_are_no_wider_than_the_terminal(monkeypatch):
    monkeypatch.setattr(practising, "terminal_width", lambda: 40)
    _, output, _ = run("practise", "--topics")
    assert max(map(len, output.splitlines())) <= 40


def test_the_command_keeps_a_state(tmp_path):
    path = tmp_path / "mine.json"
    arguments = ("practise", "wall-forward", "--seed", "1", "--state", str(path))
    status, output, messages = run(*arguments, stdin=b"speed = 2\n\n\nquit\n")
    assert status == 0, messages
    assert "Good-bye" in output
    (attempt,) = json.loads(path.read_text())["attempts"]
    assert attempt["topic"] == "wall-forward"


def test_what_is_interrupted_is_left_open(tmp_path, monkeypatch):
    path = tmp_path / "mine.json"
    lines = iter(["speed = 2", ""])

    def read(prompt):
        try:
            return next(lines)
        except StopIteration:
            raise KeyboardInterrupt from None

    monkeypatch.setattr(practising, "_line", read)
    status, output, _ = run("practise", "wall-forward", "--seed", "1", "--state", path)
    assert status == 0
    assert "Go on with: restitution practise --state" in output
    kept = json.loads(path.read_text())
    assert kept["attempts"] == []
    assert kept["open"]["seed"] == 1


def test_what_is_typed_outlives_a_crash(tmp_path, monkeypatch):
    path = tmp_path / "mine.json"
    lines = iter(["speed = 2", "speed = 3"])
    monkeypatch.setattr(practising, "_line", lambda prompt: next(lines))
    with pytest.raises(StopIteration):
        practising.practise(practising.Practising("wall-forward", 1, 1, state=str(path)))
    opened = json.loads(path.read_text())["open"]
    assert opened["progress"]["draft"] == ["speed = 2", "speed = 3"]


PARTED = ("practise", "sphere-at-rest", "--level", "2", "--seed", "1", "--state")


def test_a_question_left_at_its_second_part_goes_on_there(tmp_path):
    path = tmp_path / "mine.json"
    _, output, messages = run(*PARTED, path, stdin=b"show\nmu = 3\nquit\n")
    assert "Part (b)" in output, messages
    assert json.loads(path.read_text())["open"]["progress"]["part"] == "b"
    _, output, _ = run("practise", "--state", path, stdin=b"quit\n")
    assert "seed 1 ---" in output
    assert "Part (a)" not in output and "Part (b)" in output
    assert "Your lines so far:\n> mu = 3" in output


def test_what_was_handed_in_keeps_its_first_marks(tmp_path):
    path = tmp_path / "mine.json"
    run(*PARTED, path, stdin=b"speed(A) = 1\n\n\nquit\n")
    kept = json.loads(path.read_text())
    assert kept["attempts"] == [] and kept["open"]["progress"]["first"]["a"]
    run("practise", "--state", path, stdin=b"show\nquit\n")
    kept = json.loads(path.read_text())
    (attempt,) = kept["attempts"]
    assert attempt["lost_method"] and kept["open"] is None


@pytest.mark.parametrize("data", [3, {}, {"part": 3, "lines": [1], "draft": {"a": 1}}])
def test_what_is_no_progress_is_left(data):
    assert Progress.of(data) == Progress()


@pytest.mark.parametrize(
    "arguments",
    [
        ("practise", "no-such-topic"),
        ("practise", "--mistake", "no-such-mistake"),
        ("practise", "--level", "5"),
        ("practise", "--seed", "-1"),
        ("practise", "--like", "no-such-file.impact"),
        ("practise", "ranges", "--like", "x.impact"),
        ("practise", "--seed", "99999999999999999999", "-o", "-"),
    ],
)
def test_the_command_refuses(arguments):
    status, _, messages = run(*arguments)
    assert status == 2
    assert "internal" not in messages


# --- like another -------------------------------------------------------------------------------

TEACHER = """
wall W: along i
sphere P: mass 2, velocity 5i - 3j
P hits W: e = 1/3
part a
find velocity(P)
part b
find impulse
"""


def test_one_like_a_statement_is_practised(tmp_path):
    (tmp_path / "ball.impact").write_text(TEACHER)
    typed = b"next\nquit\n"
    arguments = ("practise", "--like", "ball.impact", "--seed", "1")
    status, output, _ = run(*arguments, stdin=typed, cwd=tmp_path)
    assert status == 0
    for seed in (1, 2):
        assert f"--- Like ball.impact, seed {seed} ---\n\nA smooth uniform sphere" in output
    assert output.endswith("Go on with: restitution practise --like ball.impact --seed 2\n")
    assert run(*arguments, "--state", "mine.json", cwd=tmp_path)[0] == 2


def test_what_is_wrong_in_a_statement_is_told_at_its_place(tmp_path):
    (tmp_path / "ball.impact").write_text("wall W: along i\nvx = u sin 60\n")
    status, _, messages = run("practise", "--like", "ball.impact", cwd=tmp_path)
    assert status == 2
    assert messages.startswith("ball.impact:2:1: syntax: cannot read 'vx = u sin 60'")


def test_a_variant_has_other_numbers_and_the_same_words():
    one, again, other = (variant(r.parse(TEACHER), seed) for seed in (1, 1, 2))
    assert one == again
    assert one.statement != other.statement
    problem = r.parse(one.statement)
    assert problem.spheres[0].velocity != r.parse(TEACHER).spheres[0].velocity
    assert [part.label for part in problem.parts] == [None, "a", "b"]
    assert one.notes[0] == "the wall stays as it is, as velocities are told by it"


def test_values_given_afterwards_are_worked_out_again():
    variation = variant(
        r.parse(
            "wall W: along i\nsphere P: velocity 4i - 3j\nP hits W\n"
            "given velocity(P) = 4i + 2j\nfind e"
        ),
        3,
    )
    (item,) = (item for _, item in r.solve(r.parse(variation.statement)).items())
    assert 0 < item.decimal < 1


def test_a_printed_result_is_printed_anew():
    variation = variant(
        r.parse(
            "wall W: along i\nsphere P: velocity 4i - 3j\nP hits W: e = 2/3\n"
            "show speed(P) = 2sqrt(5)"
        ),
        3,
    )
    (item,) = (item for _, item in r.solve(r.parse(variation.statement)).items())
    assert item.holds


@pytest.mark.parametrize(
    ("statement", "words"),
    [
        (
            "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\nfind speed(P)",
            "no numbers",
        ),
        (
            """
            sphere A: mass 1, velocity 6i - 5j
            sphere B: mass 2, velocity -i - 6j
            A hits B
            given velocity(A) = 3i - 9j
            find e""",
            "line of centres",
        ),
    ],
)
def test_what_cannot_be_varied_is_told(statement, words):
    with pytest.raises(UnsupportedError, match=words):
        variant(r.parse(statement))
