# SPDX-License-Identifier: Apache-2.0
"""SIGTERM and SIGHUP (closed terminal) end a command like Ctrl-C; a second signal ends it immediately.

Python handles Ctrl-C between two bytecode instructions: a compiled function that does not return, such as a
law with an infinite loop, never reaches this point. Every signal is also written to a socket immediately; a
thread that listens there can end the process. It also resends an interrupt that was lost.
"""

from __future__ import annotations

import _thread
import os
import signal
import socket
import sys
import threading
import time
from collections.abc import Callable
from typing import Any

APART = 0.3
"""Signals closer than this count as one: some callers forward signals that the terminal sends, too [s]."""
PATIENCE = 1.5
"""Time after which a hint is shown to a waiting user [s]."""
_ENDS = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
_CODES = {number: 128 + number for number in (signal.SIGINT, *_ENDS)}
_received: list[int] = []
AGAIN = b"\xff"
"""Code that requests a lost signal again; no signal has this number."""
PAUSE = 0.01
"""Delay before it is sent again, so that the code that lost it has finished [s]."""


def code_of_interruption() -> int:
    """Exit code of a command ended by a signal: 143 after SIGTERM, 129 after SIGHUP, else 130."""
    return _CODES[_received[0] if _received else signal.SIGINT]


def _terminate(number: int, _: Any) -> None:
    """Stop the computation like Ctrl-C, so that result files are closed."""
    _received.append(number)
    raise KeyboardInterrupt


def run_to_its_code(command: Callable[[], int]) -> int:
    """Exit code of a command, also if a signal arrives before its first or after its last instruction.

    Later signals have no effect, since the process is about to end. The evaluation at the end resets a flag
    of Python: an interrupt that left an `exec` of a text, as in `dataclass`, would otherwise end
    ``python -m`` by SIGINT although it has been handled.

    Parameters
    ----------
    command
        Function that runs the command and returns its exit code.
    """
    try:
        code = command()
    except KeyboardInterrupt:
        code = code_of_interruption()
    if threading.current_thread() is threading.main_thread():
        for number in _CODES:
            if signal.getsignal(number) is not signal.SIG_IGN:
                signal.signal(number, lambda *_: None)
    eval("0")  # noqa: S307 - a constant
    return code


def end_at_the_second_interrupt() -> None:
    """Start the listener; no effect outside the main thread, where signals cannot be caught."""
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
    """Request an interrupt again that occurred where exceptions are discarded: `__del__`, callbacks."""
    before = sys.unraisablehook

    def hook(found: Any) -> None:
        """Notify the listener thread; forward all other events."""
        if issubclass(found.exc_type, KeyboardInterrupt):
            there.send(AGAIN)
        else:
            before(found)

    sys.unraisablehook = hook


def _listen(here: socket.socket, there: socket.socket) -> None:
    """Wait for interrupts; the reference `there` only keeps the socket open."""
    first: float | None = None
    own: list[int] = []  # resent signals that have not arrived yet
    while True:
        try:
            received = here.recv(64)
        except TimeoutError:
            _say("still computing; press Ctrl-C again to end immediately, data on the disk is kept")
            here.settimeout(None)
            continue
        for byte in received:
            if byte == AGAIN[0]:
                own.append(_received[-1] if _received else signal.SIGINT)
                time.sleep(PAUSE)
                _interrupt_main(own[-1])
            elif byte in own:
                own.remove(byte)
            elif byte in _CODES:
                now = time.monotonic()
                if first is None:
                    first = now
                    here.settimeout(PATIENCE)
                elif now - first > APART:
                    _say("ended immediately; data on the disk is kept")
                    os._exit(_CODES[signal.Signals(byte)])


def _interrupt_main(number: int) -> None:
    """Send a signal to the main thread, which also interrupts blocking system calls where possible.

    It is the one that was lost: jobs in the background of a shell ignore SIGINT.
    """
    if hasattr(signal, "pthread_kill"):
        signal.pthread_kill(threading.main_thread().ident or 0, number)
    else:
        _thread.interrupt_main(signal.Signals(number))


def _say(text: str) -> None:
    """Write a line to stderr without locks, which the main thread may hold."""
    os.write(2, f"{text}\n".encode())
