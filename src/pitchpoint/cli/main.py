# SPDX-License-Identifier: Apache-2.0
"""The `pitchpoint` command: list of subcommands and handling of errors.

A command is a module of this folder with a function of the same name; for words of Python both end in an
underscore. It is imported when called, so that `pitchpoint --help` does not load numerical libraries.
"""

from __future__ import annotations

import gc
import importlib
import io
import keyword
import os
import sys
import warnings
from collections.abc import Sequence
from functools import partial

import click

from pitchpoint.cli.interrupt import end_at_the_second_interrupt, run_to_its_code

COMMANDS = {
    "new": "Write a commented model to start from.",
    "import": "Model from a REXS file of a gear unit.",
    "rexs": "Compare REXS files; write a model as REXS file.",
    "check": "Check a model file; list its parts and defaults.",
    "gears": "Geometry of gears and pairs; drawings.",
    "clearance": "Clearances between assembled gears, with pictures.",
    "mass": "Mass and inertia from geometry, solids, given values.",
    "mesh": "Mesh stiffness over the mesh cycle.",
    "contact": "Loaded tooth contact: load distribution, pressure, TE.",
    "contact-table": "Pre-computed contact of a mesh, with its error.",
    "relief": "Flank modifications of least transmission error.",
    "contact-levels": "Cost and error of the levels of contact; fitted law.",
    "frequencies": "Frequencies of shafts, meshes, planets, bearings.",
    "modes": "Natural frequencies and mode shapes.",
    "campbell": "Campbell diagram and ranked critical speeds.",
    "frf": "Frequency response about an operating point.",
    "reduce": "Condense linear parts and report the error.",
    "run": "Time response or slow roll of a scenario.",
    "sweep": "Speed sweep up and down; jumps of the response.",
    "study": "Spread, yield and sensitivities of results over tolerances.",
    "dataset": "Labelled data set of many cases from a plan.",
    "compare-solvers": "Accuracy and speed of all integrators on one model.",
    "analyse": "Spectra, orders and indicators of a record.",
    "fatigue": "Damage-equivalent loads of results, loads of all teeth.",
    "wind": "Turbulent wind from a seed, as a TurbSim file.",
    "diagnose": "Detect damaged gears, shafts and bearings in a record.",
    "view": "3-D scene of a model or result in one HTML file.",
    "report": "Report of a model and its results in one HTML file.",
    "export": "A model as an FMU (FMI 2.0, 3.0) for other programs.",
    "examples": "List or copy the examples.",
    "schema": "JSON schema of model files, for editors.",
    "warmup": "Compile all kernels in advance.",
}

EPILOG = (
    "Exit codes: 0 success, 1 internal error, 2 invalid input, 3 computation failed or disk full, "
    "129 hung up, 130 interrupted, 143 terminated. "
    "Errors go to stderr; with --json, stdout contains only JSON."
)


def command_of(name: str) -> click.Command:
    """Import a command.

    Parameters
    ----------
    name
        One of `COMMANDS`.
    """
    module = name.replace("-", "_")
    module += "_" if keyword.iskeyword(module) else ""
    command: click.Command = getattr(importlib.import_module(f"pitchpoint.cli.{module}"), module)
    return command


class LazyGroup(click.Group):
    """Command group that imports only the command that is called."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Names of the commands in the order of a typical workflow."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import a command; None for unknown names."""
        return command_of(cmd_name) if cmd_name in COMMANDS else None

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Resolve the command, or suggest the closest name."""
        if args and not args[0].startswith("-") and args[0] not in COMMANDS:
            from pitchpoint.core.nearest import did_you_mean

            guess = did_you_mean(args[0], COMMANDS).strip() or f"there are {', '.join(COMMANDS)}"
            ctx.fail(f"no command {args[0]!r}; {guess}")
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the commands without importing them."""
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))


@click.group(
    cls=LazyGroup,
    name="pitchpoint",
    epilog=EPILOG,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110},
)
@click.version_option(package_name="pitchpoint", message="pitchpoint %(version)s", help="Show the version.")
def pitchpoint() -> None:
    """Simulate gear drives: geometry, mesh stiffness, flank contact, dynamics."""


def main(arguments: Sequence[str] | None = None) -> None:
    """Run one command and exit with its code; entry point of the installed script."""
    # start-up creates a million permanent objects: garbage collection would take 5 % of the time
    gc.set_threshold(50_000, 20, 20)
    # dense matrices are small here: threads of linear algebra libraries slow a busy machine down
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    end_at_the_second_interrupt()
    if isinstance(sys.stdout, io.TextIOWrapper) and sys.stdout.errors == "strict":
        sys.stdout.reconfigure(errors="replace")  # terminals without Greek letters show question marks
    given = list(sys.argv[1:] if arguments is None else arguments)
    sys.exit(run_to_its_code(partial(run_command, given)))


def run_command(arguments: list[str]) -> int:
    """Run one command and return its exit code; errors are reported as messages on stderr."""
    from pitchpoint.cli.failure import exit_code_of, show_warnings_plainly
    from pitchpoint.core import notices

    quiet = bool({"-q", "--quiet"} & set(arguments))
    notices.listen((lambda _: None) if quiet else partial(click.echo, err=True))
    with warnings.catch_warnings():
        show_warnings_plainly()
        try:
            result = pitchpoint.main(args=arguments, prog_name="pitchpoint", standalone_mode=False)
        except click.exceptions.Exit as leave:
            return int(leave.exit_code)
        except SystemExit as leave:  # stdout was closed by its reader, as in `| head`
            return leave.code if isinstance(leave.code, int) else 1
        except BaseException as error:  # noqa: BLE001 - all exceptions are reported here
            return exit_code_of(error, debug="--debug" in arguments)
    return result if isinstance(result, int) else 0
