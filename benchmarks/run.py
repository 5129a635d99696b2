"""How fast it is, as ratios of times taken in one run: ``uv run python benchmarks/run.py``.

Warm: solving and explaining each example, against ``sympy.solve`` on the same equations.
Cold: the whole command against ``import sympy``; its help against an interpreter that does
nothing. Drawing: the pictures of each example, against solving it. ``--repeat`` says of how many
runs the shortest is taken.
"""

from __future__ import annotations

import argparse
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from statistics import median

from raw import SYSTEMS

LIMIT = 20
"""Seconds after which one calculation is given up."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeat", type=int, default=3)
    repeat = parser.parse_args().repeat
    cold(max(repeat, 5))
    warm(repeat)
    drawing(repeat)


# --- cold -------------------------------------------------------------------------------------


def cold(repeat: int) -> None:
    examples = Path(__file__).parents[1] / "src" / "restitution" / "examples"
    command = Path(sys.executable).with_name("restitution")
    cases = {
        "python -c pass": [sys.executable, "-c", "pass"],
        "restitution --help": [command, "--help"],
        'python -c "import sympy"': [sys.executable, "-c", "import sympy"],
        "restitution solve corner.impact": [command, "solve", examples / "corner.impact"],
        "restitution solve two-spheres-with-vectors.impact": [
            command,
            "solve",
            examples / "two-spheres-with-vectors.impact",
        ],
    }
    times = {name: [] for name in cases}
    for _ in range(repeat + 1):  # the first is to fill the caches of the disk
        for name, arguments in cases.items():
            times[name].append(_seconds(lambda a=arguments: _run(a)))
    # What is typical, not what is best: of runs that last so short, chance makes half.
    typical = {name: median(each[1:]) for name, each in times.items()}
    nothing, algebra = typical["python -c pass"], typical['python -c "import sympy"']
    print("| cold | ms | ratio | at most |\n|---|---:|---:|---:|")
    for name, seconds in typical.items():
        ratio, bound = "", ""
        if name == "restitution --help":
            ratio, bound = f"{seconds / nothing:.1f} × `python -c pass`", "15"
        elif name.startswith("restitution solve"):
            ratio, bound = f"{seconds / algebra:.2f} × `import sympy`", "2"
        print(f"| `{name}` | {1000 * seconds:.0f} | {ratio} | {bound} |")
    print()


def _run(arguments: list[object]) -> None:
    subprocess.run([str(each) for each in arguments], check=True, stdout=subprocess.DEVNULL)


# --- warm -------------------------------------------------------------------------------------


def warm(repeat: int) -> None:
    import sympy

    from restitution import examples, explain, parse, solve

    print("| example | solve, ms | explain, ms | `sympy.solve`, ms | ratio |")
    print("|---|---:|---:|---:|---:|")
    ratios = []
    totals = []
    for name in examples.names():
        problem = parse(examples.text(name))
        solution = solve(problem)
        solving = _shortest(lambda p=problem: solve(p), repeat)
        explaining = _shortest(lambda s=solution: str(explain(s)), repeat)
        raw = None
        if name in SYSTEMS:
            equations, unknowns = SYSTEMS[name]()
            raw = _shortest(lambda e=equations, x=unknowns: sympy.solve(e, x, dict=True), repeat)
        cells = [_ms(solving), _ms(explaining), "" if name not in SYSTEMS else _ms(raw), ""]
        if solving is not None and explaining is not None:
            totals.append(solving + explaining)
            if name in SYSTEMS:
                # A solve that was given up took at least so long.
                ratio = (solving + explaining) / (raw or LIMIT)
                ratios.append(ratio)
                cells[-1] = f"{ratio:.2f}"
        print(f"| {name} | {' | '.join(cells)} |")
    print(f"\nMedian ratio over {len(ratios)} examples: {median(ratios):.2f}")
    print(f"Median time over {len(totals)} examples: {1000 * median(totals):.0f} ms")


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


def _ms(seconds: float | None) -> str:
    return f"> {1000 * LIMIT}" if seconds is None else f"{1000 * seconds:.1f}"


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
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


if __name__ == "__main__":
    main()
