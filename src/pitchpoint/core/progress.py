# SPDX-License-Identifier: Apache-2.0
"""Progress of long-running work, reported to whoever listens."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Protocol


class Progress(Protocol):
    """A receiver of the amount of work done.

    It is called between blocks, never inside a compiled loop, and may raise KeyboardInterrupt to stop.
    """

    def __call__(self, done: float, total: float, note: str = "") -> None:
        """Report progress.

        Parameters
        ----------
        done
            Amount done so far, in any unit.
        total
            Amount in all, in the same unit; 0 if unknown.
        note
            A few words on the current step.
        """


def silent(done: float, total: float, note: str = "") -> None:
    """Listen to nothing; the default where no caller wants to know.

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
    """Listener where there is none."""


_listener: ContextVar[Callable[[str], None]] = ContextVar("listener", default=_no_listener)


@contextmanager
def listening(listener: Callable[[str], None]) -> Iterator[None]:
    """Pass the notes on current steps to a listener.

    Parameters
    ----------
    listener
        Called with a few words; it may raise KeyboardInterrupt to stop.
    """
    before = _listener.set(listener)
    try:
        yield
    finally:
        _listener.reset(before)


def report_step(words: str) -> None:
    """Report the current step before work whose share is known, or between its parts.

    Parameters
    ----------
    words
        A few words on the current step.

    Examples
    --------
    >>> with listening(print):
    ...     report_step("equilibrium, step 3")
    equilibrium, step 3
    """
    _listener.get()(words)
