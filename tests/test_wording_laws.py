"""Laws of questions in words, over all that a statement can ask for in a number of scenes."""

from __future__ import annotations

import random
import re
from functools import cache
from itertools import product

import pytest
from laws_of_questions import check_english, leaves, plain, read_through, sentences

from restitution.language import parse
from restitution.render import layout as lay
from restitution.solving import solve
from restitution.wording import Emphasis, Listing, Question, question, to_text

# A statement without its questions, its spheres and walls, and how many events it has.
SCENES = {
    "wall": (
        "wall W: along i\nsphere P: mass 2, velocity 5i - 3j\nP hits W: e = 1/2",
        ("P",),
        ("W",),
        1,
    ),
    "two walls": (
        (
            "wall V: along i\nwall W: along 60°\nsphere P: mass m, velocity u at alpha to V\n"
            "P hits V\nP hits W: e = f"
        ),
        ("P",),
        ("V", "W"),
        2,
    ),
    "two spheres": (
        (
            "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, velocity -2u i\n"
            "A hits B: along i"
        ),
        ("A", "B"),
        (),
        1,
    ),
    "three spheres": (
        (
            "sphere A: mass 1, velocity 4i + j\nsphere B: mass 2, at rest\n"
            "sphere C: mass 3, velocity -i\nA hits B: along i, e = 1/2\n"
            "B hits C: along 30°, e = 1/4"
        ),
        ("A", "B", "C"),
        (),
        2,
    ),
    "places": (
        (
            "point O: (0, 0)\npoint N: (8, 2)\nwall W: along i, through (0, 0)\n"
            "sphere P: mass 2, at (0, 2), velocity u at alpha to W\nP hits W: e = 1/2\nP reaches N"
        ),
        ("P",),
        ("W",),
        2,
    ),
    "meeting again": (
        (
            "point O: (0, 0)\nwall W: along j, through (10, 0)\n"
            "sphere A: mass 1, at (0, 0), velocity 6i\nsphere B: mass 2, at (6, 0), at rest\n"
            "A hits B: along i, e = 1/2\nB hits W: e = 1/3\nB hits A: along i, e = 1/2"
        ),
        ("A", "B"),
        ("W",),
        3,
    ),
    "a blow": (
        (
            "sphere P: mass 2, velocity 3i\nsphere Q: mass 4, velocity j\nP receives 4i + 6j\n"
            "P hits Q: along i, e = 1/2"
        ),
        ("P", "Q"),
        (),
        2,
    ),
    "spheres with a radius": (
        (
            "point O: (0, 0)\nsphere A, B: mass m, radius 1\nsphere A: at (0, 0), velocity 5i\n"
            "sphere B: at (6.6, 1.2), at rest\nA hits B: e = 1/2"
        ),
        ("A", "B"),
        (),
        1,
    ),
}
WITH_PLACES = ("places", "meeting again", "spheres with a radius")
GOING_ON = ("speed", "velocity", "energy", "momentum", "direction")


@cache
def quantities(name: str) -> tuple[str, ...]:
    """What may be asked for in a scene, each at a stage of its own."""
    _, spheres, walls, events = SCENES[name]
    stages = range(events + 1)
    out = [f"{kind}({s}, {n})" for kind, s, n in product(GOING_ON, spheres, stages)]
    out += [f"energy({n})" for n in stages if len(spheres) > 1]
    if name in WITH_PLACES:
        out += [f"position({s}, {n})" for s, n in product(spheres, stages)]
        out += [f"time({n})" for n in range(1, events + 1)]
        out += [f"distance({spheres[0]}, O, {n})" for n in stages]
        if len(spheres) > 1:
            out += [f"distance({spheres[0]}, {spheres[1]}, {n})" for n in stages]
    axes = ("3i + 4j", *walls, f"velocity({spheres[-1]}, 0)", f"velocity({spheres[0]}, {events})")
    for s, n, axis in product(spheres, stages, axes):
        out.append(f"along(velocity({s}, {n}), {axis})")
        out.append(f"across(velocity({s}, {n}), {axis})")
        if axis != f"velocity({s}, {n})":
            out.append(f"angle(velocity({s}, {n}), {axis})")
    return tuple(out)


def combined(name: str, r: random.Random) -> str:
    """An expression of quantities."""
    events, spheres = SCENES[name][3], SCENES[name][1]
    kinds = ["speed", "energy", "velocity", "momentum"]
    if name in WITH_PLACES:
        kinds += ["position", "time"]
    kind = r.choice(kinds)
    if kind == "time":
        one, other = f"time({r.randint(1, events)})", f"time({r.randint(1, events)})"
    else:
        one, other = (f"{kind}({r.choice(spheres)}, {r.randint(0, events)})" for _ in range(2))
    shapes = ["{0} - {1}", "{0} + {1}", "2 {0} - 3 {1}", "-{0}", "abs({0} - {1})", "{0} + 2 {1}"]
    if kind in ("speed", "energy", "time"):
        shapes += ["{0}/{1}", "({0} - {1})/{0}", "{0}^2", "{0}^2 + {1}^2", "{0} + {1} + {0}"]
    return r.choice(shapes).format(one, other)


def asked(name: str, lines: str) -> Question:
    return question(parse(f"{SCENES[name][0]}\n{lines}"))


def drawn(seed: int, name: str) -> str:
    """Lines that give and ask something of a scene."""
    r = random.Random(f"{seed} {name}")
    spheres, events = SCENES[name][1], SCENES[name][3]

    def moving() -> str:
        return f"velocity({r.choice(spheres)}, {r.randint(0, events)})"

    def way() -> str:
        if name not in WITH_PLACES or r.random() < 0.4:
            return moving()
        place = f"position({r.choice(spheres)}, {r.randint(0, events)})"
        return r.choice(["O - {}", "(0, 0) - {}", "-{}", "{}", "{} - O", "(3, 4) - {}"]).format(
            place
        )

    one = combined(name, r)
    other = re.search(r"[a-z]+\([^()]*\)", one)
    assert other is not None
    how = r.choice(["perpendicular to", "parallel to", "in the direction of", "opposite to"])
    lines = [
        f"{r.choice(['given', 'show'])} {moving()} {how} {way()}",
        f"find {combined(name, r)}, {r.choice(quantities(name))}, {combined(name, r)}",
        f"{r.choice(['given', 'show'])} {one} = {r.choice([2, 3])} {other[0].replace('0)', '1)')}",
        f"find range of {combined(name, r)}",
        f"find {combined(name, r)}",
    ]
    return "\n".join(lines[n] for n in sorted(r.sample(range(4), 2))) + "\n" + lines[4]


DRAWN = [(name, drawn(seed, name)) for name in SCENES for seed in range(12)]


@cache
def question_of(name: str, lines: str) -> Question:
    return asked(name, lines)


# --- what no exam setter would print --------------------------------------------------------------

# More than a long sentence of an examination paper has; a formula counts as one word.


@pytest.mark.parametrize(("name", "lines"), DRAWN)
def test_whatever_is_asked_can_be_read(name: str, lines: str) -> None:
    found = question_of(name, lines)
    read_through(found)
    for each in sentences(found):
        check_english(each)


# --- the statement, and nothing else --------------------------------------------------------------


@pytest.mark.parametrize("name", SCENES)
def test_what_differs_is_told_differently(name: str) -> None:
    """Each quantity at each stage, and each with its sign, has words of its own."""
    seen: dict[str, str] = {}
    for each in quantities(name):
        text = to_text(asked(name, f"find {each}"), 10_000)
        assert text not in seen, (each, seen.get(text), text)
        seen[text] = each


@pytest.mark.parametrize("name", SCENES)
def test_what_two_quantities_make_is_told_differently(name: str) -> None:
    """Sums, differences and ratios of what goes on have words, or a formula, of their own."""
    _, spheres, _, events = SCENES[name]
    seen: dict[str, str] = {}
    kinds = ["speed", "velocity", *(["position", "time"] if name in WITH_PLACES else [])]
    for kind in kinds:
        each = [f"{kind}({s}, {n})" for s, n in product(spheres, range(events + 1))]
        if kind == "time":
            each = [f"time({n})" for n in range(1, events + 1)]
        for one, other in product(each, each):
            if one == other:
                continue
            shapes = ["{} - {}"] + ["{}/{}"] * (kind in ("speed", "time"))
            for shape in shapes:
                asks = shape.format(one, other)
                text = to_text(asked(name, f"find {asks}"), 10_000)
                # An event that is none of a body's leaves it what it was.
                same = text in seen and answers(name, asks) == answers(name, seen[text])
                assert text not in seen or same, (asks, seen.get(text), text)
                seen[text] = asks


def answers(name: str, asks: str) -> list[object]:
    """The exact values of what is asked of a scene."""
    solution = solve(parse(f"{SCENES[name][0]}\nfind {asks}"))
    (part,) = solution.parts.values()
    (item,) = part.items
    assert item.answers, asks
    return [answer.exact for answer in item.answers]


@pytest.mark.parametrize("name", SCENES)
def test_what_was_at_first_is_called_so(name: str) -> None:
    """At stage 0 a quantity that events change is initial, or one before the impact."""
    for each in quantities(name):
        if "0)" not in each or each.startswith(("along", "across", "angle")):
            continue
        (listing,) = asked(name, f"find {each}").parts[0].body
        assert isinstance(listing, Listing)
        text = plain(listing.entries[0].words)
        assert re.search("initial|immediately before", text), (each, text)


@pytest.mark.parametrize("how", ["in the direction of", "opposite to", "parallel to"])
def test_directions_at_first_are_called_so(how: str) -> None:
    for name in SCENES:
        _, spheres, _, events = SCENES[name]
        lines = f"given velocity({spheres[0]}, {events}) {how} velocity({spheres[-1]}, 0)\nfind 1/e"
        text = " ".join(to_text(asked(name, lines), 10_000).split())
        assert re.search(f"{'initial velocity'}|velocity (of . )?immediately before", text), text


@pytest.mark.parametrize(("name", "lines"), DRAWN)
def test_a_letter_of_a_formula_is_new_and_denotes_one_thing(name: str, lines: str) -> None:
    """A letter that the words bring in is told each time, is free, and means the same."""
    base = {letter_of(each) for each in leaves(question_of(name, "find 1").intro, lay.Letter)}
    taken = {*base, *SCENES[name][1], *SCENES[name][2], "e", "i", "j"}
    meaning: dict[str, str] = {}
    for each in sentences(question_of(name, lines)):
        _, where, told = plain(each).rpartition(", where ")
        if not where or "constant" in told or " acute" in told:
            continue
        for letter, denoted in DEFINITION.findall(told):
            assert letter not in taken, (letter, told)
            assert meaning.setdefault(letter, denoted) == denoted, (letter, meaning[letter], told)


UNIT = r"(?:\u00a0(?:m|kg|J|N\u00a0s|s|m\u00a0s⁻¹))?"
DEFINITION = re.compile(rf"(?:^|and )([^\s,]+){UNIT} is (the (?:(?! and \S+ is ).)*)")


def letter_of(piece: lay.Letter) -> str:
    return f"{piece.name}_{piece.subscript}".rstrip("_")


# --- single cases ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "lines", "wanted"),
    [
        (
            "places",
            "given velocity(P, 1) in the direction of (0, 0) - position(P, 1)\nfind e",
            "Given that immediately after the impact P is moving directly towards O",
        ),
        (
            "places",
            "given velocity(P, 1) opposite to N - position(P, 1)\nfind e",
            "immediately after the impact P is moving directly away from N",
        ),
        (
            "places",
            "find angle(velocity(P, 1), N - position(P, 0))",
            (
                "the angle between the direction of motion of P immediately after the impact and "
                "the vector from the initial position of P to N"
            ),
        ),
        ("places", "find position(P, 1) - position(P, 0)", "from the initial position of P to its"),
        (
            "meeting again",
            "find time(1) + time(2)",
            (
                "the sum of the times from the start until A collides with B for the first time "
                "and until B hits W"
            ),
        ),
        ("meeting again", "find time(1) - time(2)", "exceeds the time from the start until B"),
        ("meeting again", "find velocity(A, 0) - velocity(B, 0)", "the initial velocity of A rel"),
        (
            "two spheres",
            "show speed(A) = 2 speed(B)",
            "immediately after the collision the speed of A is twice the speed of B",
        ),
        (
            "two spheres",
            "show 2 velocity(A) + velocity(B) = u i",
            "Show that 2𝐯 + 𝐰 = u𝐢, where 𝐯 and 𝐰 are the velocities of A and B immediately after",
        ),
        (
            "two spheres",
            "show impulse(A) = -impulse(B)",
            "is equal in magnitude and opposite in direction to the impulse on B",
        ),
        ("two spheres", "show speed(A)^2 - speed(B)^2 > 0", "is greater than the square of the"),
        (
            "wall",
            "find (speed(P, 0) - speed(P))/speed(P, 0) as a percentage",
            "the decrease in the speed of P in the impact as a percentage of the speed of P",
        ),
        (
            "three spheres",
            "find angle(velocity(A, 1), line_of_centres(2))",
            (
                "immediately after the collision between A and B and the line of centres in the "
                "collision between B and C"
            ),
        ),
    ],
)
def test_what_a_teacher_would_say(name: str, lines: str, wanted: str) -> None:
    assert wanted in " ".join(to_text(asked(name, lines), 10_000).split())


def test_facts_that_are_many_are_told_before_what_is_asked() -> None:
    facts = ", ".join(f"angle(velocity(P, {n}), 3i + 4j) = 3{n}°" for n in range(3))
    text = to_text(asked("two walls", f"given {facts}, energy(2) < energy(1)\nfind e"), 10_000)
    assert "Given that" not in text and text.endswith("Find the value of e.")


def test_names_are_in_italics_in_formulas_too() -> None:
    found = question_of("places", "find 2 position(P, 1) - 3 position(P, 0)")
    assert Emphasis("P") in sentences(found)[-1]
