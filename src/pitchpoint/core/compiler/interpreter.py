# SPDX-License-Identifier: Apache-2.0
"""Faster compilation: no garbage collection, and one large memory chunk for the interpreter frames (25 %)."""

from __future__ import annotations

import gc
from collections.abc import Callable
from typing import TypeVar

T = TypeVar("T")

_WORDS = 1 << 17
"""Stack size of the frame of `_with_room` in words, 1 MB."""


_GARBAGE = 1_500_000
"""Number of objects (about 500 MB) above which garbage is collected between kernels (about 1 s)."""


def _with_room(function: Callable[[], T]) -> T:
    return function()


# The interpreter allocates frames in chunks of 16 kB and maps a new chunk when a call exceeds the last one.
# Calls of the compiler are nested hundreds deep, and a loop at the end of a chunk maps and unmaps memory in
# each iteration, 400 000 times for one gear pair. A frame that requests 1 MB gets a chunk of 2 MB, which is
# sufficient for all nested frames.
_with_room.__code__ = _with_room.__code__.replace(co_stacksize=_WORDS)


def run_compiler(function: Callable[[], T]) -> T:
    """Call a compiling function without garbage collection and with a large frame chunk.

    Parameters
    ----------
    function
        Function to call.

    Returns
    -------
    T
        Result of the function.
    """
    was_on = gc.isenabled()
    gc.disable()
    try:
        return _with_room(function)
    finally:
        if was_on:
            gc.enable()
        elif gc.get_count()[0] > _GARBAGE:
            gc.collect()
