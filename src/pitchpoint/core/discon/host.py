# SPDX-License-Identifier: Apache-2.0
"""Process of one controller library: loads it and calls it for each request, until the pipe is closed.

This file is run as a script, with the standard library only::

    python -I -S host.py LIBRARY PROCEDURE INFILE OUTNAME SIZE MESSAGE OUTNAME_SIZE

A request is one byte, "c" for a call or "e" for the end, and the swap record for a call. An answer is the
flag, the length of the message, the message and the swap record. The process ends as soon as the pipe is
closed, even during a call.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import queue
import signal
import struct
import sys
import threading
from typing import BinaryIO

LOADED, NOT_LOADED, NO_PROCEDURE = 0, 1, 2
"""Flags of the first answer."""
HEAD = struct.Struct("<iI")
CALL, END = b"c", b"e"


def _answer(pipe: BinaryIO, flag: int, message: bytes, record: bytes = b"") -> None:
    pipe.write(HEAD.pack(flag, len(message)) + message + record)
    pipe.flush()


def _read(pipe: BinaryIO, size: int, requests: queue.Queue[bytes | None]) -> None:
    """Pass requests on; a closed pipe ends the process."""
    while True:
        what = pipe.read(1)
        record = pipe.read(size) if what == CALL else b""
        if what == END:
            requests.put(None)
            return
        if not what or len(record) < size:
            if sys.platform != "win32" and os.getpgrp() == os.getpid():
                os.killpg(0, signal.SIGKILL)  # with what the library has started
            os._exit(0)
        requests.put(record)


def main(arguments: list[str]) -> int:
    """Load the library and answer the requests; returns the exit status of the process."""
    library, procedure, infile, outname = arguments[:4]
    size, message_size, outname_size = (int(x) for x in arguments[4:])
    requests_from = os.fdopen(os.dup(0), "rb")
    answers_to = os.fdopen(os.dup(1), "wb")
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.dup2(2, 1)  # what the library prints goes with its error messages
    for interrupt in ("SIGINT", "SIGTERM", "SIGHUP"):  # the caller decides, and closes the pipe
        if hasattr(signal, interrupt):
            signal.signal(getattr(signal, interrupt), signal.SIG_IGN)
    with contextlib.suppress(ImportError, ValueError, OSError):
        import resource

        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    try:
        function = getattr(ctypes.CDLL(library), procedure)
    except OSError as error:
        _answer(answers_to, NOT_LOADED, str(error).encode())
        return 0
    except AttributeError:
        _answer(answers_to, NO_PROCEDURE, b"")
        return 0
    _answer(answers_to, LOADED, b"")
    function.restype = None
    record = (ctypes.c_float * (size // 4))()
    flag = ctypes.c_int(0)
    # the record has the lengths; the buffers are longer, for libraries that write beyond them
    name = ctypes.create_string_buffer(os.fsencode(outname), outname_size + 4096)
    message = ctypes.create_string_buffer(message_size + 4096)
    given = ctypes.create_string_buffer(os.fsencode(infile), len(os.fsencode(infile)) + 4096)
    requests: queue.Queue[bytes | None] = queue.Queue()
    threading.Thread(target=_read, args=(requests_from, size, requests), daemon=True).start()
    while True:
        request = requests.get()
        if request is None:
            return 0
        ctypes.memmove(record, request, size)
        flag.value = 0
        ctypes.memset(message, 0, len(message))
        function(record, ctypes.byref(flag), given, name, message)
        _answer(answers_to, flag.value, message.raw.split(b"\0", 1)[0], bytes(record))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
