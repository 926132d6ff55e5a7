# SPDX-License-Identifier: Apache-2.0
"""Progress reports of long-running work."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Protocol


class Progress(Protocol):
    """Receiver of progress reports.

    Called between blocks, never inside a compiled loop; it may raise KeyboardInterrupt to stop the work.
    """

    def __call__(self, done: float, total: float, note: str = "") -> None:
        """Report progress.

        Parameters
        ----------
        done
            Completed amount, in any unit.
        total
            Total amount, in the same unit; 0 if unknown.
        note
            Short description of the current step.
        """


def silent(done: float, total: float, note: str = "") -> None:
    """Ignore progress reports; the default receiver.

    Parameters
    ----------
    done
        Ignored.
    total
        Ignored.
    note
        Ignored.
    """


def _no_listener(_: str) -> None:
    """Default listener: ignores the notes."""


_listener: ContextVar[Callable[[str], None]] = ContextVar("listener", default=_no_listener)


@contextmanager
def listening(listener: Callable[[str], None]) -> Iterator[None]:
    """Pass the notes on current steps to a listener.

    Parameters
    ----------
    listener
        Called with a short description; it may raise KeyboardInterrupt to stop the work.
    """
    before = _listener.set(listener)
    try:
        yield
    finally:
        _listener.reset(before)


def as_steps(words: str) -> Progress:
    """Receiver that reports progress as steps, for work before that of a display.

    Parameters
    ----------
    words
        Short description of the work.

    Examples
    --------
    >>> with listening(print):
    ...     as_steps("matrices")(1.0, 4.0)
    matrices, 25 %
    """

    def report(done: float, total: float, note: str = "") -> None:
        """Report the share that is done."""
        report_step(f"{words}, {100.0 * done / max(total, 1e-300):.0f} %")

    return report


def report_step(words: str) -> None:
    """Report the current step to the listener.

    Parameters
    ----------
    words
        Short description of the step.

    Examples
    --------
    >>> with listening(print):
    ...     report_step("equilibrium, step 3")
    equilibrium, step 3
    """
    _listener.get()(words)
