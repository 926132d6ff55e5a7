# SPDX-License-Identifier: Apache-2.0
"""Parallel execution of independent tasks in threads.

Threads share the compiled code, whose loops release the GIL. Results are processed in the calling thread, so
that files and tables have a single writer.
"""

from __future__ import annotations

import os
import queue
import threading
import time
from collections.abc import Callable, Sequence
from typing import TypeVar

LOOK = 0.05
"""Interval at which the waiting thread checks for Ctrl-C [s]."""
GRACE = 0.7
"""Maximum time that tasks in progress have to stop after an interruption [s]."""

W = TypeVar("W")
D = TypeVar("D")


def on_all_cores(
    work: Callable[[W, threading.Event], D],
    pieces: Sequence[W],
    take: Callable[[D], None],
    jobs: int | None = None,
) -> bool:
    """Execute all tasks; returns False if interrupted by Ctrl-C.

    Parameters
    ----------
    work
        Executes one task in one of the threads; must not raise. The event is set when the task should stop.
    pieces
        Tasks.
    take
        Called with each result in order of completion, in the calling thread.
    jobs
        Number of threads; default one per core.
    """
    finished: queue.SimpleQueue[D] = queue.SimpleQueue()
    stop = threading.Event()
    waiting = iter(pieces)
    turn = threading.Lock()
    nothing = object()

    def serve() -> None:
        """Execute tasks and queue their results until none is left or all stop."""
        while not stop.is_set():
            with turn:
                piece = next(waiting, nothing)
            if piece is nothing:
                return
            finished.put(work(piece, stop))  # type: ignore[arg-type]

    count = max(1, min(jobs or os.cpu_count() or 1, len(pieces)))
    # daemon threads: a task that ignores the event must not block the exit of the interpreter
    threads = [threading.Thread(target=serve, daemon=True, name=f"case-{k}") for k in range(count)]
    done = 0
    try:
        for thread in threads:
            thread.start()
        while done < len(pieces):
            try:
                result = finished.get(timeout=LOOK)
            except queue.Empty:
                continue
            done += 1
            take(result)
    except KeyboardInterrupt:
        stop.set()
        until = time.monotonic() + GRACE
        for thread in threads:
            thread.join(max(0.0, until - time.monotonic()))
        while not finished.empty():
            done += 1
            take(finished.get())
    finally:
        stop.set()
    return done == len(pieces)
