# SPDX-License-Identifier: Apache-2.0
"""Multistep steps that end at events, where forces have a jump or a kink.

A polynomial across a kink is not a solution, so the step must end there. The first guess is the event time on
the extrapolated polynomial of the history; it is refined with the polynomial of the shortened step, until the
step ends after the event by `LOCATED` of the trial step or less. `multistep.restart` continues from there.
"""

from __future__ import annotations

from pitchpoint.core.kernel import call, kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.multibody.channels import CTL, F8
from pitchpoint.solvers.explicit.dense_output import find_events
from pitchpoint.solvers.multistep.accepted_step import go_back, keep_accelerations, prepare_events, view_past
from pitchpoint.solvers.multistep.order_control import LARGEST, PAST
from pitchpoint.system.workspace import MACH

LOCATED = 1e-5
"""Largest distance of the end of a step after its event, relative to the trial step."""
MAX_TRIES = 10
ROOM = 5
"""Size of the event buffer in the search for the first event of a step."""


@kernel
def _first_event(at, where, h, n):
    """Fraction of the last step of length h at its first event; 2 if there is none, < 0 on failure."""
    b = view(where, 1, PAST)[0]
    found = view(b["p"], (ROOM, 3), F8)
    dense = prepare_events(at, where, h, n)
    _, share = find_events(at, b["t"] - h, h, dense, found, ROOM, b["wanted"])
    return share


@kernel
def _guess(at, where, h):
    """Fraction of the next step of length h at its first event, on the polynomial of the history."""
    b = view(where, 1, PAST)[0]
    _, times, _, _ = view_past(at, where)
    n = min(b["points"], b["k"] + 1)
    for j in range(n):
        times[j] -= h
    b["t"] += h
    share = _first_event(at, where, h, n)
    b["t"] -= h
    for j in range(n):
        times[j] += h
    return share


@kernel
def _copy_past(at, source, target):
    """Copy a history: rows, times and step control data."""
    a = view(source, 1, PAST)[0]
    b = view(target, 1, PAST)[0]
    rows, times, _, _ = view_past(at, source)
    other_rows, other_times, _, _ = view_past(at, target)
    for j in range(a["points"]):
        other_times[j] = times[j]
        for i in range(rows.shape[1]):
            other_rows[j, i] = rows[j, i]
    b["t"] = a["t"]
    b["h"] = a["h"]
    b["gridded"] = a["gridded"]
    b["used"] = a["used"]
    b["origin"] = a["origin"]
    b["error"] = a["error"]
    b["estimate"] = a["estimate"]
    b["k"] = a["k"]
    b["next_k"] = a["next_k"]
    b["points"] = a["points"]
    b["steady"] = a["steady"]
    b["rising"] = a["rising"]
    b["failures"] = a["failures"]


@kernel
def keep_past(at, where):
    """Save history and accelerations, for a step that may be undone."""
    c = view(at, 1, CTL)[0]
    _copy_past(at, where, view(where, 1, PAST)[0]["kept"])
    a = view(c["a"], c["nd"], F8)
    al = view(view(c["mach"], 1, MACH)[0]["al"], c["nd"], F8)
    for i in range(a.size):
        al[i] = a[i]


@kernel
def take_back(at, where):
    """Restore the history and state of `keep_past`: a step may have regridded or shortened the history."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    _copy_past(at, view(where, 1, PAST)[0]["kept"], where)
    ap = view(m["ap"], c["nd"], F8)
    al = view(m["al"], c["nd"], F8)
    for i in range(ap.size):
        ap[i] = al[i]
    go_back(at, where)


@kernel
def _pass_on(at):
    """Copy the event functions at the end of the step to the start of the next."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    ev0 = view(m["ev0"], c["ne"], F8)
    ev1 = view(m["ev1"], c["ne"], F8)
    for k in range(ev0.size):
        ev0[k] = ev1[k]


@kernel
def step_to_event(at, where, spare):
    """One step that ends at the first event in it; `event` is 1 if there is one."""
    b = view(where, 1, PAST)[0]
    keep_past(at, where)
    limit = b["limit"]
    t = b["t"]
    b["event"] = 0
    h = min(b["h"], view(b["tol"], LARGEST + 1, F8)[LARGEST])
    h = min(h, limit - t)
    room = LOCATED * h
    extra = 0.5 * room
    reach = h
    keep_accelerations(at)
    share = _guess(at, where, h)
    go_back(at, where)
    if 0.0 <= share <= 1.0:
        reach = min(h, share * h + extra)
    for tries in range(MAX_TRIES):
        b["limit"] = min(limit, t + reach) if reach < h else limit
        status = call(b["step"], at, where, 0)
        b["limit"] = limit
        if status != OK:
            return status
        used = b["used"]
        keep_accelerations(at)
        share = _first_event(at, where, used, min(b["points"] - 1, b["next_k"] + 1))
        go_back(at, where)
        if share < 0.0:
            return NOT_FINITE
        if share > 1.0:
            if tries == 0 or tries == MAX_TRIES - 1 or used < 0.9 * reach or extra > h:
                _pass_on(at)
                return OK  # no event, or the step became too short to reach it
            extra *= 8.0  # the step ended just before the event
            reach = used + extra
        else:
            if (1.0 - share) * used <= room or tries == MAX_TRIES - 1:
                b["event"] = 1
                return OK
            reach = share * used + extra
        take_back(at, where)
    return OK
