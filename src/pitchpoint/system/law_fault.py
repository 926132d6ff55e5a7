# SPDX-License-Identifier: Apache-2.0
"""Error message of a failed user law: repeats the call in Python, as compiled code only returns NaN."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

from pitchpoint.core.kernel import plain
from pitchpoint.core.user_law import UserLaw
from pitchpoint.elements import signal
from pitchpoint.elements.line import line_between
from pitchpoint.system.system import System


def law_fault(system: System, kind: str, number: int) -> str:
    """Error message of the law of one record; "" if it has no law or the repeated call succeeds.

    Parameters
    ----------
    system
        The system right after the failure: time, frames and scratch arrays are those of the failed call.
    kind, number
        Name of the kind and number of the record.
    """
    laws = system.laws.get(kind, ())
    function = laws[number] if number < len(laws) else None
    if not callable(function):
        return ""
    record = system.records[kind][number]
    pool = system.pools.get(kind)
    t, x, first, count = _arguments(system, record, pool)
    p = pool[first : first + count] if pool is not None and count else signal.Pool().array()
    message = UserLaw(plain(function), p, _name(function)).diagnose(t, x)
    return f": {message} (t = {t:.6g} s, x = {x:.6g})" if message else ""


def _arguments(system: System, record: Any, pool: Any) -> tuple[float, float, int, int]:
    """Time, second argument, and position and number of the parameters in the failed call."""
    t = float(system.workspace.ctl[0]["t"])
    if "now" in record.dtype.names:  # a mesh
        return t, float(record["now"]["psi"]), int(record["params"]), len(pool)
    if "slot" in record.dtype.names:  # a signal of another signal
        return t, float(pool[int(record["a"])]), int(record["start"]), int(record["n"])
    if "free" in record.dtype.names:  # a spring along a line
        ends = (system.workspace.fr[int(record[end])] for end in "ij")
        return (
            t,
            line_between(record, *ends)[3] - float(record["free"]),
            int(record["start"]),
            int(record["n"]),
        )
    frame = system.workspace.fr[int(record["i"])]
    x = float(frame["phi"]) + 2.0 * math.pi * int(frame["turns"])
    if record["over"] == signal.OVER_TIME:
        x = t
    elif record["over"] == signal.OVER_SPEED:
        x = float(frame["R"][:, 2] @ frame["tw"][3:])
    return t, x, int(record["start"]), int(record["n"])


def _name(function: Any) -> str:
    """File and function name, as in a model file."""
    found = plain(function)
    code = getattr(found, "__code__", None)
    file = f"{Path(code.co_filename).name}:" if code is not None else ""
    return f"{file}{getattr(found, '__name__', 'law')}"
