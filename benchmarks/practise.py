"""Processor time of a practice question: the median and the longest of each topic and level.

uv run python benchmarks/practise.py [SEEDS]
"""

from __future__ import annotations

import statistics
import sys
import time

from restitution.practice.questions.generate import practice_question
from restitution.practice.questions.topics import LEVELS, TOPICS


def main() -> None:
    seeds = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    practice_question(TOPICS[0].id)  # loads the algebra
    everything = []
    for topic in TOPICS:
        for level in LEVELS:
            times = []
            for seed in range(seeds):
                began = time.process_time()
                practice_question(topic.id, level, seed)
                times.append(time.process_time() - began)
            everything += times
            print(f"{topic.id:<20} {level}  {statistics.median(times):.2f} s  {max(times):.2f} s")
    print(f"all: median {statistics.median(everything):.2f} s, longest {max(everything):.2f} s")


if __name__ == "__main__":
    main()
