# SPDX-License-Identifier: Apache-2.0
"""Error message of a failed user law: repeats the call in Python, as compiled code only returns NaN."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pitchpoint.core.kernel import plain
from pitchpoint.core.user_law import UserLaw
from pitchpoint.elements import registry, signal
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
    call = registry.find(kind).law_call
    if not callable(function) or call is None:
        return ""
    pool = system.pools.get(kind, signal.Pool().array())
    t = float(system.workspace.ctl[0]["t"])
    x, first, count = call(system.records[kind][number], system.workspace.fr, pool, t)
    message = UserLaw(plain(function), pool[first : first + count], _name(function)).diagnose(t, x)
    return f": {message} (t = {t:.6g} s, x = {x:.6g})" if message else ""


def _name(function: Any) -> str:
    """File and function name, as in a model file."""
    found = plain(function)
    code = getattr(found, "__code__", None)
    file = f"{Path(code.co_filename).name}:" if code is not None else ""
    return f"{file}{getattr(found, '__name__', 'law')}"
