# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint new`: write a commented model to start from."""

from __future__ import annotations

from pathlib import Path

import click

from pitchpoint.cli.options import debug, output
from pitchpoint.cli.output import show
from pitchpoint.cli.schema import SCHEMA_FILE, modeline

STARTERS = ("pair", "two-stage", "planetary", "rotor")


def starter_text(name: str) -> str:
    """Text of a model to start from.

    Parameters
    ----------
    name
        One of `STARTERS`.
    """
    return (Path(__file__).parent / "starters" / f"{name}.yaml").read_text(encoding="utf-8")


@click.command()
@click.argument("kind", metavar="KIND", type=click.Choice(STARTERS))
@output("Model file; default: KIND.yaml in the current folder.")
@click.option("--force", is_flag=True, help="Overwrite an existing file.")
@debug
def new(kind: str, output: str | None, force: bool) -> None:
    """Write a commented model: KIND is pair, two-stage, planetary or rotor.

    The model runs as it is. If the folder contains pitchpoint.schema.json (command schema), editors check the
    model while it is written.
    """
    from pitchpoint.io.target import write_file

    target = Path(output if output is not None else f"{kind}.yaml")
    if target.exists() and not force:
        raise click.BadParameter(f"{target} exists; use --force to overwrite", param_hint="--output")
    text = starter_text(kind)
    if (target.parent / SCHEMA_FILE).is_file():
        text = modeline(SCHEMA_FILE) + text
    write_file(target, text)
    show(f"written to {target}")
    show(f"  pitchpoint check {target}")
    show(f"  pitchpoint run {target} -s steady")
