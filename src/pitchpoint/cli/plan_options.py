# SPDX-License-Identifier: Apache-2.0
"""Options of the commands that compute the cases of a plan into a folder."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import click

from pitchpoint.cli.options import writes


def read_shard(_: click.Context, __: click.Parameter, text: str | None) -> tuple[int, int]:
    """Read I/N."""
    if text is None:
        return 1, 1
    part, slash, whole = text.partition("/")
    if not (slash and part.strip().isdigit() and whole.strip().isdigit()) or not 1 <= int(part) <= int(whole):
        raise click.BadParameter(f"{text!r} is not of the form I/N with 1 <= I <= N")
    return int(part), int(whole)


def plan_options(folder: str, reported: str) -> Callable[[Any], Any]:
    """Plan, folder, threads, shard and dry run, with the help of the folder and what a dry run reports."""
    options = (
        click.argument("file", metavar="PLAN", type=click.Path(exists=True, dir_okay=False)),
        writes("-o", "--output", metavar="FOLDER", folder=True, help=folder),
        click.option(
            "-j",
            "--jobs",
            type=click.IntRange(min=1),
            metavar="N",
            help="Threads; default: one per core.",
        ),
        click.option(
            "--shard",
            callback=read_shard,
            metavar="I/N",
            help="Compute every N-th case, starting with the I-th: to share a folder between N machines.",
        ),
        click.option("--dry-run", is_flag=True, help=f"Report {reported} and computing time."),
    )

    def add(command: Any) -> Any:
        """Add the options in their order."""
        for option in reversed(options):
            command = option(command)
        return command

    return add
