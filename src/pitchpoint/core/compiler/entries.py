# SPDX-License-Identifier: Apache-2.0
"""Main program of the second process (`second_process`): compile entry points and report each on stdout."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Sequence
from typing import Any

from pitchpoint.core.compiler.interpreter import run_compiler
from pitchpoint.core.kernel import address


def main(entries: Sequence[str]) -> None:
    """Compile entry points, named "module:function", and report each on stdout."""
    for entry in entries:
        module, _, name = entry.partition(":")
        kind: Any = getattr(importlib.import_module(module), name)
        address(kind)
        sys.stdout.write(entry + "\n")
        sys.stdout.flush()


if __name__ == "__main__":
    run_compiler(lambda: main(sys.argv[1:]))
