# SPDX-License-Identifier: Apache-2.0
"""How another Python process is started: with the packages of this one, and nothing from the working folder.

With ``-c`` and ``-m`` Python puts the working folder in front of its search path: a file `numpy.py` there
would be executed in place of the library. The option ``-P`` prevents that.
"""

from __future__ import annotations

import os
import sys


def python_command(*arguments: str) -> list[str]:
    """Command that runs this interpreter in safe-path mode.

    Parameters
    ----------
    *arguments
        What follows, such as ``-m`` and the name of a module.
    """
    return [sys.executable, "-P", *arguments]


def python_environment() -> dict[str, str]:
    """Environment in which the process finds the packages of this one; relative folders are omitted."""
    return {**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if os.path.isabs(p))}
