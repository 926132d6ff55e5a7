# SPDX-License-Identifier: Apache-2.0
"""A second process that compiles entries while this one compiles others: half the wait on an empty cache.

Both write the same cache on disk. The second process reports every entry that it has finished; a caller that
needs one waits for that report and loads it. A second process that fails only costs time: what it did not
report is compiled here.
"""

from __future__ import annotations

import logging
import os
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING

from pitchpoint.core.child import python_command, python_environment
from pitchpoint.core.compiler.machine_code import clear_drafts, is_stock
from pitchpoint.core.notices import notice

if TYPE_CHECKING:
    import subprocess

_pending: dict[str, subprocess.Popen[str]] = {}


def announce() -> None:
    """Report why the first start takes longer."""
    seconds = 45 if is_stock() else 20
    notice(f"compiling kernels for this machine: about {seconds} s, once", logging.INFO)


def cores() -> int:
    """Number of processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def delegate(entries: Sequence[str]) -> None:
    """Let another process compile entries, named "module:function", in this order."""
    import subprocess  # only on a cold cache: every command pays for the import of this module

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
    """Wait until the second process has finished an entry, or has ended; at once if it was not requested."""
    while entry in _pending:
        process = _pending[entry]
        assert process.stdout is not None
        line = process.stdout.readline()
        left = [n for n, p in _pending.items() if p is process and n != line.strip()]
        for name in [n for n, p in _pending.items() if p is process and (not line or n not in left)]:
            del _pending[name]
        if not line or not left:
            process.stdout.close()
            process.kill()  # what was withdrawn is made here; every file is in place at once or not at all
            process.wait()
            clear_drafts(process.pid)


def withdraw(entry: str) -> None:
    """Stop waiting for an entry: it is compiled here, and perhaps by the second process too."""
    _pending.pop(entry, None)
