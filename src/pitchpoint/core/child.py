# SPDX-License-Identifier: Apache-2.0
"""Command, environment and end of child Python processes: same packages, nothing from the working directory.

With ``-c`` and ``-m`` Python puts the working directory first in its search path: a file `numpy.py` there
would be executed instead of the library. The option ``-P`` prevents this.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from contextlib import suppress
from typing import Any


def python_command(*arguments: str) -> list[str]:
    """Command that runs this interpreter in safe-path mode.

    Parameters
    ----------
    *arguments
        Arguments of the interpreter, such as ``-m`` and the name of a module.
    """
    return [sys.executable, "-P", *arguments]


def python_environment() -> dict[str, str]:
    """Environment in which the child finds the packages of this process; relative folders are omitted."""
    return {**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if os.path.isabs(p))}


def end_with_children(process: subprocess.Popen[Any]) -> None:
    """Kill a process and what it has started; `Popen` has got `start_new_session=True`.

    Parameters
    ----------
    process
        The process; it may have ended.
    """
    if sys.platform != "win32":
        with suppress(ProcessLookupError, PermissionError):  # none remains
            os.killpg(process.pid, signal.SIGKILL)
    process.kill()
