# SPDX-License-Identifier: Apache-2.0
"""SIGTERM and SIGHUP (a closed terminal) end a command in order, as Ctrl-C does; a second one ends at once.

Python acts upon Ctrl-C between two of its own instructions: a compiled function that does not return, such as
a law with an endless loop, never gets there. Every signal is written into a socket at once, though, and a
thread that listens there can end the process. It also sends a Ctrl-C again that was lost on the way.
"""

from __future__ import annotations

import _thread
import os
import signal
import socket
import sys
import threading
import time
from typing import Any

APART = 0.3
"""Signals closer than this count as one: some callers pass on what the terminal sends as well [s]."""
PATIENCE = 1.5
"""Time after which a waiting user is shown what else can be done [s]."""
_ENDS = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
_CODES = {number: 128 + number for number in (signal.SIGINT, *_ENDS)}
_received: list[int] = []
AGAIN = b"\xff"
"""Request for a signal that was lost; no signal has this number."""
PAUSE = 0.01
"""Time after which it is sent again: what lost it has ended by then [s]."""


def code_of_interruption() -> int:
    """Exit code of a command that a signal ended: 143 after SIGTERM, 129 after SIGHUP, else 130."""
    return _CODES[_received[0] if _received else signal.SIGINT]


def _terminate(number: int, _: Any) -> None:
    """End what is computed as Ctrl-C would, so that results are closed."""
    _received.append(number)
    raise KeyboardInterrupt


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
    for number in _ENDS:
        if signal.getsignal(number) is not signal.SIG_IGN:  # nohup has SIGHUP ignored
            signal.signal(number, _terminate)
    _hear_what_is_lost(there)
    threading.Thread(target=_listen, args=(here, there), daemon=True, name="interrupts").start()


def _hear_what_is_lost(there: socket.socket) -> None:
    """Have a Ctrl-C sent again that Python acted upon where no exception can pass: `__del__`, callbacks."""
    before = sys.unraisablehook

    def hook(found: Any) -> None:
        """Notify the listening thread; pass on everything else."""
        if issubclass(found.exc_type, KeyboardInterrupt):
            there.send(AGAIN)
        else:
            before(found)

    sys.unraisablehook = hook


def _listen(here: socket.socket, there: socket.socket) -> None:
    """Wait for interrupts; `there` is only kept open."""
    first: float | None = None
    own = 0  # signals that were sent again and are still to come
    while True:
        try:
            received = here.recv(64)
        except TimeoutError:
            _say("still computing; what is on the disk is kept if you press Ctrl-C again, which ends at once")
            here.settimeout(None)
            continue
        for byte in received:
            if byte == AGAIN[0]:
                own += 1
                time.sleep(PAUSE)
                _interrupt_main()
            elif byte == signal.SIGINT and own:
                own -= 1
            elif byte in _CODES:
                now = time.monotonic()
                if first is None:
                    first = now
                    here.settimeout(PATIENCE)
                elif now - first > APART:
                    _say("ended at once; what was written before is kept")
                    os._exit(_CODES[signal.Signals(byte)])


def _interrupt_main() -> None:
    """Send the main thread what Ctrl-C sends; a system call that it waits in ends by that where it can."""
    if hasattr(signal, "pthread_kill"):
        signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)
    else:
        _thread.interrupt_main()


def _say(text: str) -> None:
    """Write a line to stderr without the locks that the main thread may hold."""
    os.write(2, f"{text}\n".encode())
