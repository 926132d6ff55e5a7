# SPDX-License-Identifier: Apache-2.0
"""How long-running work tells its caller how far it is, without knowing who listens."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Protocol


class Progress(Protocol):
    """Anything that can be told how much of the work is done.

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
            A few words on what is going on.
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


def _nobody(_: str) -> None:
    """Where nobody listens."""


_listener: ContextVar[Callable[[str], None]] = ContextVar("listener", default=_nobody)


@contextmanager
def heard_by(listener: Callable[[str], None]) -> Iterator[None]:
    """Let somebody hear what is told aside in the meantime.

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


def tell_aside(words: str) -> None:
    """Say what is being done before the work whose share is known, or between its parts.

    Parameters
    ----------
    words
        A few words on what is going on.

    Examples
    --------
    >>> with heard_by(print):
    ...     tell_aside("equilibrium, step 3")
    equilibrium, step 3
    """
    _listener.get()(words)
