r"""Experiments: the coefficient of restitution from what was measured.

    >>> import restitution as r
    >>> result = r.experiment("alpha,beta\n30,21\n45,34\n60,49\n", angle_error=1)
    >>> round(result.e, 2)
    0.67

`records` holds what was measured, `results` what comes of it. SciPy and odrpack are loaded with
the first fit; they come with the extra "experiment".
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from restitution.experiments.records import Kind
from restitution.experiments.rows import Data
from restitution.experiments.whole import Experiment

if TYPE_CHECKING:
    from restitution.experiments.whole import Plan


def experiment(
    data: Data,
    *,
    kind: Kind | None = None,
    angle_error: float | None = None,
    speed_error: float | None = None,
    from_normal: bool = False,
) -> Experiment:
    """The value of e from what was measured, with its uncertainty, and a check of the model.

    ``data`` is a text in CSV with a header, a path to one, or columns by name. ``kind`` follows
    from the columns where it is None. ``angle_error`` is the standard error of all angles that
    have none of their own, in degrees, ``speed_error`` that of all speeds or components; without
    any, errors are estimated from the scatter. ``from_normal`` turns angles to a wall that were
    measured from the normal.

    Raises StatementError where the data cannot be read, MissingError where they do not determine
    e, and UnsupportedError where the extra "experiment" is not installed.
    """
    from restitution.experiments.analysis import analysed
    from restitution.experiments.rows import rows_of
    from restitution.experiments.tables import Options, table_of

    options = Options(kind, from_normal, angle_error, speed_error)
    return analysed(table_of(rows_of(data), options))


def experiment_plan(e: float, *, angle_error: float = 1.0, trials: int = 10, seed: int = 1) -> Plan:
    """Which angles to measure at with a wall, and how well e will be known.

        >>> import restitution as r
        >>> round(r.experiment_plan(0.7, angle_error=1, trials=10).best_angle)
        50

    ``e`` is what is expected, in [0, 1]; ``angle_error`` the standard error of one angle in
    degrees. Experiments are simulated from the ``seed`` and fitted as those that were measured.

    Raises StatementError for what no experiment has.
    """
    from restitution.experiments.planning import planned

    return planned(e, angle_error, trials, seed)
