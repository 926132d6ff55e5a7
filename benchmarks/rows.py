# SPDX-License-Identifier: Apache-2.0
"""One row of the table, and how times are taken."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Row:
    """One figure.

    Parameters
    ----------
    name, value, unit
        What was measured.
    target
        What it should be, as text such as ">= 700000"; empty if it only informs.
    peer
        What it is compared with, or how it was measured.
    """

    name: str
    value: float
    unit: str
    target: str = ""
    peer: str = ""

    @property
    def met(self) -> bool | None:
        """Whether the target is met; None without one."""
        if not self.target:
            return None
        sign, number = self.target.split()[:2]
        return self.value >= float(number) if sign == ">=" else self.value <= float(number)


def cpu_seconds(work: Callable[[], object], repeats: int = 7) -> float:
    """Least CPU time of several calls [s]: the disturbance of other programs is never negative."""
    best = float("inf")
    for _ in range(repeats):
        begun = time.process_time()
        work()
        best = min(best, time.process_time() - begun)
    return best


def in_turn(works: dict[str, Callable[[], object]], repeats: int = 7) -> dict[str, float]:
    """Least CPU times of several works taken in turn [s], so that drift of the machine hits all alike."""
    best = dict.fromkeys(works, float("inf"))
    for _ in range(repeats):
        for name, work in works.items():
            begun = time.process_time()
            work()
            best[name] = min(best[name], time.process_time() - begun)
    return best
