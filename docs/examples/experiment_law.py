"""The law of restitution, plotted from the readings of a class.

    uv run python docs/examples/experiment_law.py

draws docs/images/experiment-law.svg, which docs/experiment.md explains.
"""

from __future__ import annotations

from pathlib import Path

import restitution as r
from restitution.experiments.plots import law_plot

ALPHA = (22, 25.5, 30, 33.5, 40.5, 48, 50, 55, 61, 66, 84)  # degrees to the wall, before
BETA = (14.5, 16, 19.5, 24, 29, 34, 37.5, 40, 50.5, 54, 82)  # and after

IMAGE = Path(__file__).resolve().parent.parent / "images" / "experiment-law.svg"


def main() -> None:
    result = r.experiment({"alpha": ALPHA, "beta": BETA}, angle_error=1)
    IMAGE.write_text(law_plot(result), encoding="utf-8")


if __name__ == "__main__":
    main()
