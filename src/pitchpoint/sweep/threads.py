# SPDX-License-Identifier: Apache-2.0
"""Independent pieces of work on all cores.

Threads share one compiled code, and its loops release the interpreter. Results are passed on in the
calling thread, so that files and tables have one writer.
"""

from __future__ import annotations

import os
import queue
import threading
import time
from collections.abc import Callable, Sequence
from typing import TypeVar

LOOK = 0.05
"""How often the waiting thread looks at the keyboard [s]."""
GRACE = 0.7
"""How long pieces under way may take to stop after an interruption [s]."""

W = TypeVar("W")
D = TypeVar("D")


def on_all_cores(
    work: Callable[[W, threading.Event], D],
    pieces: Sequence[W],
    take: Callable[[D], None],
    jobs: int | None = None,
) -> bool:
    """Do all pieces of work; states whether it came to the end, which Ctrl-C prevents.

    Parameters
    ----------
    work
        Does one piece in one of the threads; must not raise. The event is set when it should stop.
    pieces
        The pieces.
    take
        Takes what was done, in the order in which it is finished, in the calling thread.
    jobs
        Threads; default one per core.
    """
    finished: queue.SimpleQueue[D] = queue.SimpleQueue()
    stop = threading.Event()
    waiting = iter(pieces)
    turn = threading.Lock()
    nothing = object()

    def serve() -> None:
        """Take pieces and hand their results on, until there are none or all stop."""
        while not stop.is_set():
            with turn:
                piece = next(waiting, nothing)
            if piece is nothing:
                return
            finished.put(work(piece, stop))  # type: ignore[arg-type]

    count = max(1, min(jobs or os.cpu_count() or 1, len(pieces)))
    # daemons: a piece that does not listen must not keep the interpreter from leaving
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
