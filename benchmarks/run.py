"""How fast it is, as ratios of times taken in one run: ``uv run python benchmarks/run.py``.

Cold: the whole command against ``import sympy``, by the clock and by the processors' time, in pairs
that take turns; its help against an interpreter that does nothing. Warm: solving and explaining
each example, against ``sympy.solve`` on the same equations, each in a process of its own; the first
time in a process against another time. Drawing: the pictures of each example, against solving it.
Following: the lines of each working by hand, checked and recognised, against solving its statement.
Marking: the scripts that were marked by hand, with letters declared and with none.

``--repeat`` says of how many runs the shortest is taken, ``--pairs`` how many pairs there are, and
``--only`` takes one of them.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from statistics import median, quantiles

from raw import SYSTEMS

LIMIT = 20
"""Seconds after which one calculation is given up."""

HERE = Path(__file__).parent
EXAMPLES = HERE.parent / "src" / "restitution" / "examples"

PARTS = ("cold", "warm", "drawing", "following", "planning", "marking")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--pairs", type=int, default=15)
    parser.add_argument("--only", choices=PARTS)
    options = parser.parse_args()
    parts = {
        "cold": lambda: cold(options.pairs),
        "warm": lambda: warm(options.repeat),
        "drawing": lambda: drawing(options.repeat),
        "following": lambda: following(options.repeat),
        "planning": lambda: planning(options.repeat),
        "marking": lambda: marking(options.repeat),
    }
    for name, part in parts.items():
        if options.only in (None, name):
            part()


# --- cold -------------------------------------------------------------------------------------


ALGEBRA = 'python -c "import sympy"'
NOTHING = "python -c pass"
_BOUNDS = {ALGEBRA: ("1.3", "1.8"), NOTHING: ("15", "")}


@dataclass(frozen=True)
class Run:
    """What one run of a command took, in seconds: by the clock, and of all processors."""

    wall: float
    cpu: float


def cold(pairs: int) -> None:
    """Commands from the shell and back, each beside one that it is compared with."""
    if sys.dont_write_bytecode:
        print(
            "cold: PYTHONDONTWRITEBYTECODE is set, so that every start would compile the modules of"
            " the package anew (about 150 ms); nothing is measured. Unset it.\n"
        )
        return
    command = Path(sys.executable).with_name("restitution")
    baselines = {
        NOTHING: [sys.executable, "-c", "pass"],
        ALGEBRA: [sys.executable, "-c", "import sympy"],
    }
    cases = {
        "restitution --help": (NOTHING, [command, "--help"]),
        **{
            f"restitution solve {path.name}{beside}": (ALGEBRA, [command, "solve", path])
            for path, beside in (
                (EXAMPLES / "corner.impact", ""),
                (EXAMPLES / "two-spheres-with-vectors.impact", ""),
                (HERE / "decisions.impact", " (needs decisions)"),
            )
        },
    }
    busy = os.getloadavg()[0] if hasattr(os, "getloadavg") else float("nan")
    print(f"{os.cpu_count()} processors, {busy:.1f} processes at work when this began\n")
    seen: dict[str, list[tuple[Run, Run]]] = {name: [] for name in cases}
    for turn in range(pairs + 1):  # the first is to fill the caches of the disk
        for name, (against, arguments) in cases.items():
            pair = _run(baselines[against]), _run(arguments)
            if turn:
                seen[name].append(pair)
    print("| cold | ms | ms of processors | against | clock | at most | processors | at most |")
    print("|---|---:|---:|---|---:|---:|---:|---:|")
    for baseline in baselines:
        beside = [case for case, (against, _) in cases.items() if against == baseline]
        runs = [one for case in beside for one, _ in seen[case]]
        print(f"| `{baseline}` | {_typical(runs)} | | | | | |")
    for name, (against, _) in cases.items():
        ratios = [
            f"{median(each.wall / one.wall for one, each in seen[name]):.2f}",
            f"{median(each.cpu / one.cpu for one, each in seen[name]):.2f}",
        ]
        bounds = ("", "") if "decisions" in name else _BOUNDS[against]
        cells = [cell for pair in zip(ratios, bounds) for cell in pair]
        runs = [each for _, each in seen[name]]
        print(f"| `{name}` | {_typical(runs)} | `{against}` | {' | '.join(cells)} |")
    print()


def _typical(runs: list[Run]) -> str:
    wall, cpu = median(each.wall for each in runs), median(each.cpu for each in runs)
    return f"{1000 * wall:.0f} | {1000 * cpu:.0f}"


def _run(arguments: list[object]) -> Run:
    before = _processors()
    start = time.perf_counter()
    subprocess.run([str(each) for each in arguments], check=True, stdout=subprocess.DEVNULL)
    return Run(time.perf_counter() - start, _processors() - before)


def _processors() -> float:
    """Seconds of processors that all commands so far, and their own processes, have taken."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


# --- warm -------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Measured:
    """Seconds that an example takes, None where it was given up; and tellings of its story."""

    first: float | None
    solving: float | None
    explaining: float | None
    raw: float | None
    stories: int | None
    calls: int
    raw_calls: int | None

    @property
    def both(self) -> float | None:
        if self.solving is None or self.explaining is None:
            return None
        return self.solving + self.explaining


def warm(repeat: int) -> None:
    from restitution import examples
    from restitution.export.job import prepare, rehearse

    prepare()
    rehearse()  # as in the process of a command that waits for its statement
    found = {}
    # Each in a process of its own, a copy of this one: what one example leaves behind in the
    # memory of SymPy does not help the next.
    with multiprocessing.get_context("fork").Pool(1, maxtasksperchild=1) as pool:
        for name in examples.names():
            found[name] = pool.apply(measured, (name, repeat))
    print(
        "| example | solve, ms | explain, ms | `sympy.solve`, ms | ratio | first | stories |\n"
        "|---|---:|---:|---:|---:|---:|---:|"
    )
    ratios, firsts, totals, stories = {}, {}, {}, {}
    by_calls = {
        name: one.calls / one.raw_calls for name, one in found.items() if one.raw_calls is not None
    }
    for name, one in found.items():
        if one.both is not None:
            totals[name] = 1000 * one.both
            if one.first is not None:
                firsts[name] = one.first / one.both
            if name in SYSTEMS:
                # A solve that was given up took at least so long.
                ratios[name] = one.both / (one.raw or LIMIT)
        if one.stories is not None:
            stories[name] = one.stories
        cells = [
            _ms(one.solving),
            _ms(one.explaining),
            _ms(one.raw) if name in SYSTEMS else "",
            f"{ratios[name]:.2f}" if name in ratios else "",
            f"{firsts[name]:.1f}" if name in firsts else "",
            str(one.stories) if one.stories is not None else "",
        ]
        print(f"| {name} | {' | '.join(cells)} |")
    print("\n| warm | examples | median | 95 % | most | of |\n|---|---:|---:|---:|---:|---|")
    _distribution("solving and explaining, as a multiple of `sympy.solve`", ratios, 2)
    _distribution("the same by calls of Python functions", by_calls, 2)
    _distribution("solving and explaining, ms", totals, 0)
    _distribution("the first time in a process, as a multiple of another", firsts, 1)
    _distribution("stories of one solve", stories, 0)
    print()


def measured(name: str, repeat: int) -> Measured:
    """What one example takes, in a process in which nothing else was solved."""
    import sympy

    from restitution import examples, explain, parse, solve

    problem = parse(examples.text(name))
    first = _once(lambda: str(explain(solve(problem))))
    solution = solve(problem)
    solving = _shortest(lambda: solve(problem), repeat)
    explaining = _shortest(lambda: str(explain(solution)), repeat)
    stories = _stories(lambda: solve(problem))
    calls = _calls(lambda: solve(problem)) + _calls(lambda: str(explain(solution)))
    raw = raw_calls = None
    if name in SYSTEMS:
        equations, unknowns = SYSTEMS[name]()
        raw = _shortest(lambda: sympy.solve(equations, unknowns, dict=True), repeat)
        raw_calls = _calls(lambda: sympy.solve(equations, unknowns, dict=True))
    return Measured(first, solving, explaining, raw, stories, calls, raw_calls)


def _calls(work: Callable[[], object]) -> int:
    """How many functions written in Python are called: the same on a busy machine as on a free."""
    count = 0

    def counted(frame: object, event: str, argument: object) -> None:
        nonlocal count
        count += event == "call"

    sys.setprofile(counted)
    try:
        work()
    finally:
        sys.setprofile(None)
    return count


def _stories(work: Callable[[], object]) -> int | None:
    """How often a story is told; None where there is no such class any more."""
    try:
        from restitution.solving.story.forward import Story
    except ImportError:
        return None
    count = 0
    begin = Story.__init__

    def counted(self: Story, *values: object, **named: object) -> None:
        nonlocal count
        count += 1
        begin(self, *values, **named)

    Story.__init__ = counted
    try:
        work()
    finally:
        Story.__init__ = begin
    return count


def _distribution(what: str, values: dict[str, float], digits: int) -> None:
    if len(values) < 2:
        return
    most = max(values, key=values.__getitem__)
    last = quantiles(values.values(), n=20, method="inclusive")[-1]
    numbers = (median(values.values()), last, values[most])
    cells = " | ".join(f"{each:.{digits}f}" for each in numbers)
    print(f"| {what} | {len(values)} | {cells} | {most} |")


# --- drawing ----------------------------------------------------------------------------------


def drawing(repeat: int) -> None:
    """Pictures of every example, against solving it."""
    from restitution import draw, examples, parse, solve

    ratios, times = [], []
    for name in examples.names():
        problem = parse(examples.text(name))
        solution = solve(problem)
        solving = _shortest(lambda p=problem: solve(p), repeat)
        pictures = len(draw(solution).scenes)
        taken = _shortest(lambda s=solution: draw(s).svgs, repeat)
        if solving is not None and taken is not None and pictures:
            ratios.append(taken / solving)
            times.append((taken / pictures, name))
    slowest, name = max(times)
    print("\n| drawing | |\n|---|---:|")
    print(f"| median time of a picture, ms | {1000 * median(t for t, _ in times):.1f} |")
    print(f"| longest, ms (`{name}`) | {1000 * slowest:.1f} |")
    print(f"| pictures of an example, as a multiple of solving it: median | {median(ratios):.2f} |")


# --- following --------------------------------------------------------------------------------


def following(repeat: int) -> None:
    """The lines of workings by hand: each followed, and each recognised without its move."""
    sys.path.insert(0, str(HERE.parent / "tests"))
    from derivations import FOLDER, oracle_of, read_derivation

    from restitution import solve
    from restitution.explaining.following.follower import follow
    from restitution.explaining.following.tracing import Tracer
    from restitution.explaining.lines.derivation import Relation

    ratios, followed, recognised = [], [], []
    for path in sorted(FOLDER.glob("*.txt")):
        problem, derivation = read_derivation(path)
        oracle = oracle_of(problem)
        solving = _shortest(lambda p=problem: solve(p), repeat)
        taken = _shortest(lambda d=derivation, o=oracle: follow(d, o), repeat)
        if solving is None or taken is None:
            continue
        followed.append((taken / len(derivation.lines), path.stem))
        ratios.append(taken / solving)
        tracer = Tracer(replace(derivation, lines=()), oracle)
        for line in derivation.lines:
            if isinstance(line.relation, Relation):
                seconds = _seconds(lambda t=tracer, r=line.relation: t.trace(r))
                recognised.append((seconds, f"{path.stem}, line {line.number}"))
            tracer.add(line.number, line.relation)
    print("\n| following | median | 95 % | most | of |\n|---|---:|---:|---:|---|")
    for what, times in (("a line followed, ms", followed), ("a line recognised, ms", recognised)):
        ordered = sorted(1000 * seconds for seconds, _ in times)
        most, name = max(times)
        print(
            f"| {what} | {median(ordered):.1f} | {ordered[int(0.95 * len(ordered))]:.1f} "
            f"| {1000 * most:.1f} | {name} |"
        )
    print(f"| a working followed, as a multiple of solving: median | {median(ratios):.1f} | | | |")


# --- planning ---------------------------------------------------------------------------------


def planning(repeat: int) -> None:
    """Every example planned: in ms an item, and against solving it."""
    from restitution import parse, solve
    from restitution.planning.planner import plan
    from restitution.planning.writing.desk import NotPlannedError

    items, ratios, unplanned = [], [], 0
    for path in sorted(EXAMPLES.glob("*.impact")):
        solution = solve(parse(path.read_text()))
        count = sum(len(each.items) for each in solution.parts.values())
        try:
            plan(solution)
        except NotPlannedError:
            unplanned += 1
            continue
        solving = _shortest(lambda s=solution.problem: solve(s), repeat)
        taken = _shortest(lambda s=solution: plan(s), repeat)
        if solving is None or taken is None:
            continue
        items.append((taken / count, path.stem))
        ratios.append(taken / solving)
    ordered = sorted(1000 * seconds for seconds, _ in items)
    most, name = max(items)
    print("\n| planning | median | 95 % | most | of |\n|---|---:|---:|---:|---|")
    print(
        f"| an item planned, ms | {median(ordered):.1f} | {ordered[int(0.95 * len(ordered))]:.1f} "
        f"| {1000 * most:.1f} | {name} |"
    )
    print(f"| a working planned, as a multiple of solving: median | {median(ratios):.1f} | | | |")
    print(f"\n{len(items)} examples are planned, {unplanned} are not.")


def marking(repeat: int) -> None:
    """Seconds in which a script is marked, its question solved, after a first time."""
    sys.path.insert(0, str(HERE.parent / "tests"))
    from measure_marking import reply, scripts_of

    print("| marking, s | scripts | median | 95 % | most | of |\n|---|---:|---:|---:|---:|---|")
    scripts = scripts_of()[::4]
    for declared in (True, False):
        taken: dict[str, float] = {}
        for script in scripts:
            reply(script, declared)
            taken[script.name] = min(reply(script, declared)[1] for _ in range(max(repeat - 1, 1)))
        letters = "letters declared" if declared else "letters inferred"
        name = max(taken, key=lambda each: taken[each])
        usual = sorted(taken.values())[int(0.95 * (len(taken) - 1))]
        figures = f"{median(taken.values()):.2f} | {usual:.2f} | {taken[name]:.2f} | {name}"
        print(f"| {letters} | {len(taken)} | {figures} |")


def _ms(seconds: float | None) -> str:
    return f"> {1000 * LIMIT}" if seconds is None else f"{1000 * seconds:.1f}"


def _once(work: Callable[[], object]) -> float | None:
    """The time of one run; None if it lasts too long."""
    try:
        with _limited():
            return _seconds(work)
    except Exception:  # noqa: BLE001 - one that fails is a line without a time
        return None


def _shortest(work: Callable[[], object], repeat: int) -> float | None:
    """The shortest of some runs, after one that is not counted; None if it lasts too long."""
    try:
        with _limited():
            work()
            return min(_seconds(work) for _ in range(repeat))
    except Exception:  # noqa: BLE001 - one that fails is a line without a time
        return None


@contextmanager
def _limited() -> Iterator[None]:
    def ring(number: int, frame: object) -> None:
        raise TimeoutError

    signal.signal(signal.SIGALRM, ring)
    signal.alarm(LIMIT)
    try:
        yield
    finally:
        signal.alarm(0)


def _seconds(work: Callable[[], object]) -> float:
    """Seconds of a processor: on a machine that does other work the clock says little."""
    start = time.process_time()
    work()
    return time.process_time() - start


if __name__ == "__main__":
    main()
