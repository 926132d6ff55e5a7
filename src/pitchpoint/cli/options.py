# SPDX-License-Identifier: Apache-2.0
"""Options common to several commands, with identical names and help texts."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

import click

F = TypeVar("F", bound=Callable[..., Any])


class ModelFile(click.Path):
    """Existing file; for a missing one, the model file of the same folder with the nearest name."""

    def __init__(self) -> None:
        super().__init__(exists=True, dir_okay=False)

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Check the file."""
        try:
            return super().convert(value, param, ctx)
        except click.BadParameter:
            path = Path(os.fsdecode(value))
            if path.exists() or not path.parent.is_dir():
                raise
            from pitchpoint.core.nearest import similar_file

            near = similar_file(Path(), str(path), (".yaml", ".yml")).strip()
            text = f"the file {value} does not exist{f'; {near}' if near else ''}"
            raise click.BadParameter(text, ctx, param) from None


model_file = click.argument("file", type=ModelFile())
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
    """Add the common options of commands that evaluate a file: JSON, code, quiet, debug."""
    return as_json(allow_code(quiet(debug(function))))


def writes(
    *names: str, metavar: str = "OUT", help: str, folder: bool = False, required: bool = False
) -> Callable[[F], F]:
    """Option for an output file or folder.

    Missing parent folders are created and reported at the end of the command.
    """
    kind = click.Path(file_okay=not folder, dir_okay=folder)
    return click.option(
        *names, type=kind, callback=report_folders, metavar=metavar, help=help, required=required
    )


def output(what: str) -> Callable[[F], F]:
    """Option for the output file."""
    return writes("-o", "--output", help=what)


def report_folders(context: click.Context, option: click.Parameter, value: str | None) -> str | None:
    """Find the missing folder of a file, and report its creation at the end of the command.

    Two options with the same file are refused.
    """
    if value is not None:
        taken: dict[str, str] = context.meta.setdefault(f"{__name__}.files", {})
        other = taken.setdefault(os.path.abspath(value), option.opts[-1])
        if other != option.opts[-1]:
            raise click.BadParameter(
                f"{value} is also the file of {other}; name another file", context, option
            )
    missing = None if value is None else first_missing(Path(value))

    def report() -> None:
        """Report a new folder, except in quiet runs."""
        if missing is not None and missing.is_dir() and not context.params.get("quiet"):
            click.echo(f"note: the folder {missing} is new", err=True)

    context.call_on_close(report)
    return value


def first_missing(target: Path) -> Path | None:
    """Outermost missing folder of a path, if any.

    Examples
    --------
    >>> first_missing(Path("/no such folder/of/mine/run.h5")).as_posix()
    '/no such folder'
    """
    missing = [folder for folder in target.absolute().parents if not folder.exists()]
    return missing[-1] if missing else None


def quantity(flag: str, dimension: str, description: str, *, unit: bool = False) -> Callable[[F], F]:
    """Option that takes a quantity and returns its SI value; with `unit` it refuses numbers without unit."""

    def convert(_: click.Context, __: click.Parameter, text: str | None) -> float | None:
        """Convert the text of the option to SI; a number without unit is in SI."""
        from pitchpoint.cli.settings import say_bare_option
        from pitchpoint.core.errors import UnitError
        from pitchpoint.core.units import parse_quantity

        if text is None:
            return None
        try:
            value = float(text)
        except ValueError:
            value = None
        if unit and value is not None:
            from pitchpoint.core.unit_table import DIMENSIONS

            raise click.BadParameter(f"{text} has no unit; write '{text} {DIMENSIONS[dimension].si}'")
        try:
            found = parse_quantity(text if value is None else value, dimension, positive=True)
        except UnitError as error:
            raise click.BadParameter(str(error)) from None
        say_bare_option(text, dimension, flag)
        return found

    return click.option(flag, metavar="QUANTITY", callback=convert, help=description)


def with_suffix(path: str, suffix: str, option: str = "OUTPUT") -> str:
    """Check the ending of the name of an output file.

    Examples
    --------
    >>> with_suffix("unit.FMU", ".fmu")
    'unit.FMU'
    """
    if not Path(path).name:
        raise click.BadParameter(f"the name of the file is empty; write out{suffix}", param_hint=option)
    if Path(path).suffix.lower() != suffix:
        has = f"has the ending {Path(path).suffix}" if Path(path).suffix else "has no ending"
        remedy = f"write {Path(path).with_suffix(suffix)}"
        raise click.BadParameter(f"{path} {has} (limit {suffix}); {remedy}", param_hint=option)
    return path


def one_of(name: str | None, names: Sequence[str], what: str) -> str:
    """Check the name given by an option, or list the available names."""
    if name is None or name not in names:
        from pitchpoint.core.nearest import hint

        problem = f"select a {what}" if name is None else f"no {what} {name!r}"
        raise click.BadParameter(f"{problem}; {hint(name or '', names)}", param_hint=f"--{what}")
    return name


def pairs(texts: Sequence[str], flag: str) -> dict[str, str]:
    """Mapping from texts of the form name=value.

    Examples
    --------
    >>> pairs(["acc=50 m/s^2"], "--unit")
    {'acc': '50 m/s^2'}
    """
    found = {}
    for text in texts:
        name, sign, value = text.partition("=")
        if not sign or not name.strip() or not value.strip():
            raise click.BadParameter(f"{text!r} is not NAME=VALUE", param_hint=flag)
        found[name.strip()] = value.strip()
    return found
