# SPDX-License-Identifier: Apache-2.0
"""Two habits of the interpreter that cost a quarter of the time of compiling, and how to do without them."""

from __future__ import annotations

import gc
from collections.abc import Callable
from typing import TypeVar

T = TypeVar("T")

_WORDS = 1 << 17
"""Size that the frame below requests, 1 MB; the frames above it get as much."""


_GARBAGE = 1_500_000
"""Objects, about 500 MB, at which a collection between many kernels is worth its second."""


def _with_room(function: Callable[[], T]) -> T:
    return function()


# The interpreter keeps frames in pieces of 16 kB and maps a new piece whenever a call crosses the end of the
# last one. The compiler's calls are nested hundreds deep, and a loop at such an end maps and unmaps memory
# with each turn, 400 000 times for one pair of gears. A frame that requests 1 MB gets a piece of 2 MB, and
# those above it need no other.
_with_room.__code__ = _with_room.__code__.replace(co_stacksize=_WORDS)


def run_compiler(function: Callable[[], T]) -> T:
    """Call a function that compiles, without garbage collection and with room for its frames.

    Parameters
    ----------
    function
        What to call.

    Returns
    -------
    T
        Its result.
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
