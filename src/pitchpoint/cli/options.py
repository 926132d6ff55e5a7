# SPDX-License-Identifier: Apache-2.0
"""Options that several commands share, so that they are spelled and explained the same everywhere."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

import click

F = TypeVar("F", bound=Callable[..., Any])

model_file = click.argument("file", type=click.Path(exists=True, dir_okay=False))
as_json = click.option("--json", "as_json", is_flag=True, help="Print only JSON, in SI units and radians.")
allow_code = click.option(
    "--allow-code",
    is_flag=True,
    help="Allow Python functions named in the file. They run with your permissions: trusted files only.",
)
quiet = click.option(
    "-q",
    "--quiet",
    is_flag=True,
    help="Omit progress, notes, and tables that are written to a result file.",
)
debug = click.option(
    "--debug", is_flag=True, expose_value=False, help="Show the traceback of an error, for bug reports."
)
scenario = click.option(
    "--scenario",
    "-s",
    metavar="NAME",
    help="Scenario of the file; default: the only one of a suitable type.",
)
state = click.option(
    "--scenario", "-s", metavar="NAME", help="Scenario with speeds and drives; default: at rest."
)
jobs = click.option(
    "--jobs",
    "-j",
    type=click.IntRange(min=1),
    metavar="N",
    help="Threads for --vary; default: one per core.",
)


def common(function: F) -> F:
    """Add the options of every command that computes something of a file: JSON, code, quiet, debug."""
    return as_json(allow_code(quiet(debug(function))))


def writes(*names: str, metavar: str = "OUT", help: str, folder: bool = False) -> Callable[[F], F]:
    """Make an option that names a file to write, or a folder.

    Folders on the way to it that do not exist are made, by every command, and reported at the end.
    """
    kind = click.Path(file_okay=not folder, dir_okay=folder)
    return click.option(*names, type=kind, callback=report_folders, metavar=metavar, help=help)


def output(what: str) -> Callable[[F], F]:
    """Make the option that names the file to write."""
    return writes("-o", "--output", help=what)


def report_folders(context: click.Context, _: click.Parameter, value: str | None) -> str | None:
    """Find which folder of a file is missing, and report at the end of the command that it was made."""
    missing = None if value is None else first_missing(Path(value))

    def report() -> None:
        """Report a new folder; quiet runs report nothing."""
        if missing is not None and missing.is_dir() and not context.params.get("quiet"):
            click.echo(f"note: the folder {missing} is new", err=True)

    context.call_on_close(report)
    return value


def first_missing(target: Path) -> Path | None:
    """The outermost folder on the way to a file that does not exist yet, if any.

    Examples
    --------
    >>> first_missing(Path("/no such folder/of/mine/run.h5")).as_posix()
    '/no such folder'
    """
    missing = [folder for folder in target.absolute().parents if not folder.exists()]
    return missing[-1] if missing else None


def quantity(flag: str, dimension: str, description: str) -> Callable[[F], F]:
    """Make an option that takes a quantity with a unit and returns SI."""

    def convert(_: click.Context, __: click.Parameter, text: str | None) -> float | None:
        """Read the text of the option as a quantity in SI; a bare number counts as SI."""
        from pitchpoint.core.errors import UnitError
        from pitchpoint.core.units import parse_quantity

        if text is None:
            return None
        try:
            value = float(text)
        except ValueError:
            value = None
        try:
            return parse_quantity(text if value is None else value, dimension, positive=True)
        except UnitError as error:
            raise click.BadParameter(str(error)) from None

    return click.option(flag, metavar="QUANTITY", callback=convert, help=description)


def one_of(name: str | None, names: Sequence[str], what: str) -> str:
    """Find the name that an option gives, or list the names there are."""
    if name is None or name not in names:
        from pitchpoint.core.nearest import hint

        problem = f"select a {what}" if name is None else f"no {what} {name!r}"
        raise click.BadParameter(f"{problem}; {hint(name or '', names)}", param_hint=f"--{what}")
    return name
