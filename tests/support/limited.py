# SPDX-License-Identifier: Apache-2.0
"""A call with a limit of processor time: what never returns ends a process of its own, not the test run."""

from __future__ import annotations

import json
import os
import resource
import signal
from collections.abc import Callable
from typing import Any

SECONDS = 30
"""Processor time of a call that takes well below one second [s]."""


def within_limit(call: Callable[[], Any], seconds: int = SECONDS) -> Any:
    """What a call returns, as JSON has it; None if it did not return in time.

    The call runs in a copy of this process, so that what is compiled already is compiled there, too.
    """
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        code = 1
        try:
            signal.signal(signal.SIGXCPU, signal.SIG_DFL)
            used = resource.getrusage(resource.RUSAGE_SELF)
            limit = int(used.ru_utime + used.ru_stime) + seconds
            resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))
            os.close(reading)
            with os.fdopen(writing, "w") as pipe:
                json.dump(call(), pipe)
            code = 0
        finally:
            os._exit(code)
    os.close(writing)
    with os.fdopen(reading) as pipe:
        found = pipe.read()
    _, status = os.waitpid(child, 0)
    if os.WIFSIGNALED(status):
        return None
    assert status == 0, "the call ended with an exception"
    return json.loads(found)
