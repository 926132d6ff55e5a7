# SPDX-License-Identifier: Apache-2.0
"""A second Ctrl-C ends the process, whatever it is doing.

Python acts upon Ctrl-C between two of its own instructions: a compiled function that does not return, such as
a law with an endless loop, never gets there. Every signal is written into a socket at once, though, and a
thread that listens there can end the process.
"""

from __future__ import annotations

import os
import signal
import socket
import threading
import time

APART = 0.3
"""Signals closer than this count as one: some callers pass on what the terminal sends as well [s]."""
PATIENCE = 1.5
"""Time after which somebody who waits is told what else can be done [s]."""
INTERRUPTED = 130


def end_at_the_second_interrupt() -> None:
    """Begin to listen; does nothing outside the main thread, where signals cannot be caught."""
    here, there = socket.socketpair()
    there.setblocking(False)
    try:
        signal.set_wakeup_fd(there.fileno(), warn_on_full_buffer=False)
    except ValueError:
        here.close()
        there.close()
        return
    threading.Thread(target=_listen, args=(here, there), daemon=True, name="interrupts").start()


def _listen(here: socket.socket, there: socket.socket) -> None:
    """Wait for interrupts; `there` is only kept open."""
    first: float | None = None
    while True:
        try:
            received = here.recv(64)
        except TimeoutError:
            _say("still computing; what is on the disk is kept if you press Ctrl-C again, which ends at once")
            here.settimeout(None)
            continue
        if signal.SIGINT not in received:
            continue
        now = time.monotonic()
        if first is None:
            first = now
            here.settimeout(PATIENCE)
        elif now - first > APART:
            _say("ended at once; what was written before is kept")
            os._exit(INTERRUPTED)


def _say(text: str) -> None:
    """Write a line to stderr without the locks that the main thread may hold."""
    os.write(2, f"{text}\n".encode())
