# SPDX-License-Identifier: Apache-2.0
"""How long-running work tells its caller how far it is, without knowing who listens."""

from __future__ import annotations

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
