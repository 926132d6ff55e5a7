# SPDX-License-Identifier: Apache-2.0
"""Parallel compilation of entry points in a second process: half the wait with an empty cache.

Both processes write to the same disk cache. The second process reports every finished entry point; a caller
waits for the report and loads the code. A failure of the second process only costs time: entry points without
a report are compiled in this process.
"""

from __future__ import annotations

import logging
import os
import sys
import time
from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING

from pitchpoint.core.child import python_command, python_environment
from pitchpoint.core.compiler.machine_code import clear_drafts, is_stock
from pitchpoint.core.notices import notice

if TYPE_CHECKING:
    import subprocess

_pending: dict[str, subprocess.Popen[str]] = {}


KERNEL, STOCK = 90.0, 2.2
"""Compilation time of a kernel over the time of `_yardstick`; factor with the public interface of Numba."""


def announce(count: int) -> None:
    """Notify the user of the compilation of a number of kernels, with an estimate of its duration."""
    seconds = KERNEL * count * _yardstick() * (STOCK if is_stock() else 1.0)
    about = max(5, 5 * round(seconds / 5.0))
    kernels = "1 kernel" if count == 1 else f"{count} kernels"
    notice(f"compiling {kernels} for this machine: about {about} s, once", logging.INFO)


@cache
def _yardstick() -> float:
    """Time of a fixed amount of interpreted work [s]: the compiler is interpreted, too."""
    begun, total = time.perf_counter(), 0
    for k in range(200_000):
        total += k * k % 7
    return time.perf_counter() - begun


def cores() -> int:
    """Number of processor cores available to this process."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def delegate(entries: Sequence[str]) -> None:
    """Start the compilation of entry points, named "module:function", in a second process, in this order."""
    import subprocess  # on demand, since it is needed with an empty cache only

    wanted = [e for e in entries if e not in _pending]
    if not wanted or not sys.executable or cores() < 2:
        return
    try:
        process = subprocess.Popen(
            python_command("-m", "pitchpoint.core.compiler.entries", *wanted),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            env=python_environment(),
        )
    except OSError:
        return
    _pending.update(dict.fromkeys(wanted, process))


def await_entry(entry: str) -> None:
    """Wait until the second process has finished an entry point or has ended; no wait if not requested."""
    while entry in _pending:
        process = _pending[entry]
        assert process.stdout is not None
        line = process.stdout.readline()
        left = [n for n, p in _pending.items() if p is process and n != line.strip()]
        for name in [n for n, p in _pending.items() if p is process and (not line or n not in left)]:
            del _pending[name]
        if not line or not left:
            process.stdout.close()
            process.kill()  # withdrawn entry points are compiled here; files are written atomically
            process.wait()
            clear_drafts(process.pid)


def withdraw(entry: str) -> None:
    """Do not wait for an entry point: it is compiled here, and possibly by the second process too."""
    _pending.pop(entry, None)
