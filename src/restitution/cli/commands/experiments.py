"""Find e from measured data."""

from __future__ import annotations

from typing import Annotated

import typer

from restitution.cli import experimenting
from restitution.cli.commands.options import refusing
from restitution.cli.experimenting import (
    ExperimentFormat,
    Experimenting,
    ExperimentKind,
    Planning,
)
from restitution.cli.output import (
    interruptible,
)

EXPERIMENT = """Find e from what was measured, with its uncertainty, and check the model.

\b
    restitution experiment angles.csv --angle-error 1
    restitution experiment angles.csv --from-normal
    restitution experiment pucks.csv --kind spheres --speed-error 0.02
    restitution experiment video.csv --format json
    restitution experiment angles.csv -o report.html
    restitution experiment angles.csv -o law.svg
    restitution experiment --plan --e 0.7 --angle-error 1 --trials 10

The table has a header: alpha, beta (degrees to the wall), perhaps u, v; or
u_A_x, u_A_y, u_B_x, ... v_B_y, perhaps m_A, m_B, line; or t, x, y, perhaps
body, trial, wall. An error stands beside, as alpha_error. Needs the extra
"experiment": pip install 'restitution[experiment]'. With --plan, at which angles
to measure, and how well e will be known. Exit status: 0 fitted; 1
these data give no value of e; 2 they cannot be read.
"""


def experiment(
    data: Annotated[
        str | None, typer.Argument(metavar="DATA.csv", help="A table; - is standard input.")
    ] = None,
    kind: Annotated[
        ExperimentKind | None, typer.Option("--kind", help="Else the columns tell it.")
    ] = None,
    angle_error: Annotated[
        float | None,
        typer.Option(metavar="DEGREES", help="Standard error of each angle; else the scatter."),
    ] = None,
    speed_error: Annotated[
        float | None,
        typer.Option(metavar="M/S", help="Standard error of each speed or component."),
    ] = None,
    from_normal: Annotated[
        bool, typer.Option("--from-normal", help="Angles are from the normal, not the wall.")
    ] = False,
    form: Annotated[
        ExperimentFormat, typer.Option("--format", "-f", help="How to write the result down.")
    ] = ExperimentFormat.text,
    output: Annotated[
        str | None,
        typer.Option(
            "--output",
            "-o",
            metavar="PATH",
            help="A report too (.html, .pdf), or the picture of the law (.svg, .png).",
        ),
    ] = None,
    plan: Annotated[
        bool, typer.Option("--plan", help="Plan angles and trials at a wall; takes no table.")
    ] = False,
    e: Annotated[
        float | None, typer.Option("--e", metavar="E", help="What is expected, with --plan.")
    ] = None,
    trials: Annotated[
        int | None, typer.Option("--trials", metavar="N", help="With --plan; else 10.")
    ] = None,
    seed: Annotated[
        int | None, typer.Option("--seed", metavar="S", help="Of the simulation, with --plan.")
    ] = None,
) -> None:
    """Find e from one table, or plan how to measure it."""
    with refusing():
        if plan:
            others = (data, kind, speed_error, from_normal or None, output)
            planning = Planning(e, angle_error, trials, seed, form)
            raise typer.Exit(experimenting.plan(planning, others))
        experimenting.require_no_plan(e, trials, seed)
    if data is None:
        raise typer.BadParameter("a table is missing, or --plan", param_hint="DATA.csv")
    asked = Experimenting(
        data,
        None if kind is None else kind.value,
        angle_error,
        speed_error,
        from_normal,
        form,
        output,
    )
    with interruptible(), refusing():
        status = experimenting.experiment(asked)
    raise typer.Exit(status)
