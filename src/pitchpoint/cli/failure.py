# SPDX-License-Identifier: Apache-2.0
"""Translation of exceptions to a message on stderr and an exit code.

| code | meaning |
|---|---|
| 0 | success |
| 1 | internal error of pitchpoint (or stdout was closed early) |
| 2 | invalid input: command line, model file, units, impossible gears, unreadable files, missing extras |
| 3 | the computation failed, or the disk is full or defective; partial results are kept |
| 129 | the terminal was closed (SIGHUP); partial results are kept |
| 130 | interrupted with Ctrl-C; partial results are kept |
| 143 | terminated with SIGTERM; partial results are kept |
"""

from __future__ import annotations

import os
import sys
import warnings

import click

from pitchpoint.cli.interrupt import code_of_interruption

OK, FAULT, BAD_INPUT, FAILED = 0, 1, 2, 3


def exit_code_of(error: BaseException, *, debug: bool = False) -> int:
    """Report an error on stderr and return its exit code."""
    from pitchpoint.core.errors import PitchpointError, SolverError
    from pitchpoint.io.target import is_disk_fault

    if debug and not isinstance(error, click.ClickException):
        import traceback

        traceback.print_exception(error, file=sys.stderr)
    if isinstance(error, click.ClickException):
        if isinstance(error, getattr(click.exceptions, "NoArgsIsHelpError", ())):
            error.show(file=sys.stderr)
        else:
            say(f"error: {_line_of(error)}")
        return BAD_INPUT
    if isinstance(error, click.Abort) and isinstance(error.__cause__, EOFError):  # click's name for both
        error = error.__cause__
    if isinstance(error, EOFError | ValueError) and "marshal data" in str(error):
        say(f"error: compiled Python files of the installation are damaged ({error}), as after a full disk")
        say("  delete the folders __pycache__ of the installation, or reinstall it")
        return FAILED
    if isinstance(error, KeyboardInterrupt | click.Abort) or _by_interrupt(error):
        say("interrupted")
        return code_of_interruption()
    if isinstance(error, SolverError):
        return _failed(error)
    if isinstance(error, PitchpointError):
        from pitchpoint.io.measured.record import as_options

        say(f"error: {as_options(str(error))}")
        return FAILED if is_disk_fault(error) else BAD_INPUT
    if isinstance(error, MemoryError):
        say("error: not enough memory; store fewer samples (sample_rate) or use fewer points")
        return FAILED
    if isinstance(error, OSError) and is_disk_fault(error):
        name = f"{error.filename}: " if error.filename is not None else ""
        say(f"error: {name}cannot be written ({error.strerror}); free disk space and rerun")
        return FAILED
    if isinstance(error, OSError) and error.filename is not None:
        say(f"error: {error.filename}: {(error.strerror or 'cannot be used').lower()}")
        return BAD_INPUT
    say(
        f"internal error: {type(error).__name__}: {error}\n"
        "This is a bug in pitchpoint, not in your input. Please report it as described in the README,\n"
        "with the command, the model file and the output of the same command with --debug."
    )
    return FAULT


def _by_interrupt(error: BaseException) -> bool:
    """Whether an error is due to an interrupt, as Python has it for one in `__set_name__` of a class."""
    while error.__cause__ is not None:
        error = error.__cause__
    return isinstance(error, KeyboardInterrupt)


def _line_of(error: click.ClickException) -> str:
    """Error of the command line in one line: the option with its wrong value, or where to find the names."""
    text = error.format_message().rstrip(".")
    if not isinstance(error, click.UsageError):
        return text
    if type(error) is click.BadParameter:
        hint = error.param_hint or (error.param.get_error_hint(error.ctx) if error.param else None)
        names = [hint] if isinstance(hint, str) else list(hint or ())
        place = " / ".join(names).replace("'", "")
        text = error.message.rstrip(".")
        return f"{place}: {text}" if place else text
    return f"{text}; see {error.ctx.command_path} --help" if error.ctx else text


def _failed(error: BaseException) -> int:
    """Report a failed or interrupted computation, with its status and the file of partial results."""
    from pitchpoint.core import status as st

    code = getattr(error, "status", st.DIED)
    interrupted = code == st.INTERRUPTED
    say(f"{'interrupted' if interrupted else 'computation failed'} (status {code}): {error}")
    partial = getattr(error, "partial", None)
    if isinstance(partial, str | os.PathLike):
        say(f"  partial results are in {os.fspath(partial)}")
    return code_of_interruption() if interrupted else FAILED


def say(text: str) -> None:
    """Write a line to stderr; characters that the terminal does not support are replaced."""
    click.echo(text, err=True)


def show_warnings_plainly() -> None:
    """Show each warning once as a line on stderr, without file names."""

    told: set[str] = set()  # threads may each report the same

    def show(
        message: Warning | str,
        category: type[Warning],
        filename: str,
        lineno: int,
        file: object = None,
        line: str | None = None,
    ) -> None:
        """Write a validity warning; others are ignored."""
        from pitchpoint.core.errors import ValidityWarning

        if issubclass(category, ValidityWarning) and str(message) not in told:
            told.add(str(message))
            say(f"warning: {message}")

    warnings.showwarning = show
