# SPDX-License-Identifier: Apache-2.0
"""Generalised-alpha with short steps of gear trains within longer steps of the rest of the machine.

A long step begins with the short steps of the gear trains (fast part), during which all other coordinates
(slow part) follow the linear extrapolation of their accelerations and, where forces of the fast part act, the
motion caused by them (`interface`). Then the slow part takes its step with their mean. Both parts are
implicit and of second order; elements between them must be soft compared with the inertia of the slow part
(`gear_part`). A long step that fails is replaced by short steps of the whole machine.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.kernel import address, call, kernel, view
from pitchpoint.core.status import BAD_CENTRE, DIVERGED, OK, SLOW, UNBOUNDED
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.solvers.contact_counts import count_contacts
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.implicit.generalized_alpha import ORDER
from pitchpoint.solvers.implicit.interface import (
    accept,
    begin,
    begin_signals,
    collect,
    keep_motion,
    measure,
    measure_entry,
    place,
    place_signals,
)
from pitchpoint.solvers.implicit.part_step import LONG, SHORT, follow, keep_part, part_step, rescale
from pitchpoint.solvers.implicit.step import DIVISION, MAX_PARTS
from pitchpoint.solvers.sampling import (
    RECORDER,
    Accumulators,
    Chunk,
    add_value,
    advance_into,
    crossings,
    due,
    fill_record,
    keep,
    new_recorder,
    record_events,
    recorder_at,
    take,
)
from pitchpoint.system import evaluate
from pitchpoint.system.part import Part
from pitchpoint.system.residual import evaluate_events, observe, wrap
from pitchpoint.system.workspace import MACH, REJECTED, STEPS, VALID

LONG_RHO = 0.2
"""Spectral radius at infinite frequency of long steps: their numerical damping, 0.1 % of the critical one at
32 long steps per period, exceeds the energy that late forces add."""

PAIR = np.dtype(
    [
        *((name, "f8") for name in ("t0", "h", "rho", "tol")),
        *(
            (name, "i8")
            for name in ("first", "n", "fast", "slow", "count", "last", "order", "code", "again", "mask")
        ),
    ],
    align=True,
)
"""Arguments of the loop: short step h, n short steps, control records of both parts, number of short steps
per long step and in the last one; ORDER and address of `generalized_alpha.entry`."""


@kernel
def _diverged(status):
    """Whether a step failed in a way that shorter steps may avoid."""
    return status == SLOW or status == DIVERGED or status == BAD_CENTRE or status == UNBOUNDED


@kernel
def _short_step(at, other, t, tau, h, whole, rho, tol):
    """One short step that ends at t, tau after the start of the long step `whole`; divided if it fails."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    s = view(other, 1, CTL)[0]
    n = view(s["mach"], 1, MACH)[0]
    keep_part(c, m, SHORT, 0)
    follow(s, n, tau, whole)
    place(s, n, tau, h)
    place_signals(m, tau)
    status = part_step(at, t, h, rho, tol)
    if status == OK:
        accept(n, h)
        return status
    keep_motion(n, 0)
    parts = DIVISION
    while parts <= MAX_PARTS and _diverged(status):
        view(m["clock"], 16, I8)[REJECTED] += 1 if parts == DIVISION else 0
        keep_part(c, m, SHORT, 1)
        keep_motion(n, 1)
        rescale(c, m, 1.0 / parts)
        for p in range(1, parts + 1):
            left = (parts - p) * h / parts
            follow(s, n, tau - left, whole)
            place(s, n, tau - left, h / parts)
            place_signals(m, tau - left)
            status = part_step(at, t - left, h / parts, rho, tol)
            if status != OK:
                break
            accept(n, h / parts)
        if status == OK:
            rescale(c, m, 1.0 * parts)
        parts *= DIVISION
    return status


@kernel
def _equal_steps(at, order, first, count, recorder):
    """Take short steps with the whole machine in place of a long step that failed.

    Samples and events of short steps already taken are recorded again, their statistics are not. Returns
    the status and the number of steps.
    """
    o = view(order, 1, PAIR)[0]
    plain = view(o["order"], 1, ORDER)[0]
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    view(m["clock"], 16, I8)[VALID] = 0
    status = evaluate_events(at, o["t0"] + first * o["h"], m["ev0"]) if c["ne"] > 0 else OK
    taken = 0
    while taken < count and status == OK:
        plain["first"] = first + taken
        status = call(o["code"], at, o["order"], recorder if taken + 1 == count else o["again"])
        taken += 1 if status == OK else 0
    return status, taken


@kernel
def _record_long(at, t, h, span, number, mask, recorder):
    """Record a long step that ends at t; events of other bodies are located in its whole span."""
    measure_it, sample = due(number, recorder)
    status = OK
    if sample != 0 or measure_it != 0:
        status = take(at, t, recorder, measure_it, sample)
    c = view(at, 1, CTL)[0]
    if status != OK or recorder.found.shape[0] == 0 or c["ne"] == 0:
        return status
    m = view(c["mach"], 1, MACH)[0]
    status = evaluate_events(at, t, m["ev1"])
    if status != OK:
        return status
    ev0 = view(m["ev0"], c["ne"], F8)
    ev1 = view(m["ev1"], c["ne"], F8)
    late = view(mask, c["ne"], I8)
    for k in range(ev0.size):
        long = span if late[k] != 0 else h
        before = recorder.done[2]
        one = ev0[k : k + 1]
        recorder.done[2] = crossings(one, ev1[k : k + 1], t - long, long, recorder.found, before)
        if recorder.done[2] > before and before < recorder.found.shape[0]:
            recorder.found[before, 1] = k
        ev0[k] = ev1[k]
    return OK


@kernel
def _record_short(at, t, h, number, recorder):
    """Record a short step: samples of all channels, statistics of those of the part; returns a status."""
    measure, sample = due(number, recorder)
    if sample != 0 or measure != 0:
        c = view(at, 1, CTL)[0]
        m = view(c["mach"], 1, MACH)[0]
        status = observe(at, t, m["row"])
        if status != OK:
            return status
        keep(at, t, recorder, 0, sample)
        if measure != 0:
            row = view(m["row"], c["no"], F8)
            chosen = view(m["chosen"], m["nchosen"], I8)
            for j in range(chosen.size):
                add_value(row[chosen[j]], recorder.sums[chosen[j]])
            count_contacts(t, row, recorder.counts)
    return record_events(at, t, h, recorder)


@kernel
def _long_step(fast, slow, order, first, count, recorder):
    """Short steps of the gear trains after step `first`, and the step of the rest; returns the status."""
    o = view(order, 1, PAIR)[0]
    s = view(slow, 1, CTL)[0]
    n = view(s["mach"], 1, MACH)[0]
    h = o["h"]
    whole = count * h
    start = o["t0"] + first * h
    begin(n)
    begin_signals(view(view(fast, 1, CTL)[0]["mach"], 1, MACH)[0], whole)
    for k in range(1, count + 1):
        t = o["t0"] + (first + k) * h
        status = _short_step(fast, slow, t, k * h, h, whole, o["rho"], o["tol"])
        if status != OK:
            return status
        collect(s, n, k, count, whole)
        wrap(fast)
        if k < count:
            status = _record_short(fast, t, h, first + k, recorder)
            if status != OK:
                return status
    keep_part(s, n, SHORT, 1)
    status = part_step(slow, start + whole, whole, LONG_RHO, o["tol"])
    if status == OK:
        wrap(slow)
    return status


@kernel
def entry(at, order, recorder):
    """Execute a PAIR; both arguments are addresses of records."""
    o = view(order, 1, PAIR)[0]
    rec = recorder_at(recorder)
    fast = o["fast"]
    slow = o["slow"]
    h = o["h"]
    f = view(fast, 1, CTL)[0]
    s = view(slow, 1, CTL)[0]
    m = view(f["mach"], 1, MACH)[0]
    n = view(s["mach"], 1, MACH)[0]
    w = view(at, 1, CTL)[0]
    clock = view(view(w["mach"], 1, MACH)[0]["clock"], 16, I8)
    f["held"] = 1
    s["held"] = 1
    status = OK
    done = 0
    while done < o["n"] and status == OK:
        # after a shorter one, long steps end at their multiples again
        first = o["first"] + done
        count = min(o["count"] - first % o["count"], o["n"] - done)
        if count != o["last"]:
            rescale(s, n, count / o["last"])
            o["last"] = count
        keep_part(s, n, SHORT, 0)
        keep_part(f, m, LONG, 0)
        samples = rec.done[1]
        events = rec.done[2]
        status = _long_step(fast, slow, order, first, count, rec)
        t = o["t0"] + (first + count) * h
        if status == OK:
            clock[STEPS] += count
            done += count
            rec.done[0] = done
            status = _record_long(at, t, h, count * h, first + count, o["mask"], rec)
        elif _diverged(status):
            clock[REJECTED] += 1
            keep_part(s, n, SHORT, 1)
            keep_part(f, m, LONG, 1)
            rescale(s, n, 1.0 / count)
            rec.done[1] = samples
            rec.done[2] = events
            status, taken = _equal_steps(at, order, first, count, recorder)
            done += taken
            rec.done[0] = done
            if status == OK:
                status = measure(fast, t)
            rescale(s, n, 0.0)  # its slopes contain vibrations of the gear trains
            view(m["clock"], 16, I8)[VALID] = 0
        else:
            keep_part(s, n, SHORT, 1)
            keep_part(f, m, LONG, 1)
    f["held"] = 0
    s["held"] = 0
    return status


@dataclass
class SubstepRun(generalized_alpha.Run):
    """Running integration with short steps h of the fast part; see `generalized_alpha.Run`.

    Parameters
    ----------
    count
        Short steps per long step.
    parts
        Fast and slow part.
    late
        For each event function, 1 if it has new values at the ends of long steps only.
    last
        Short steps in the last long step.
    """

    count: int = 1
    parts: tuple[Part, ...] = ()
    late: NDArray[np.int64] = field(default_factory=lambda: np.zeros(0, np.int64))
    last: int = 1

    def advance(
        self,
        n: int,
        *,
        every: int = 0,
        statistics: Accumulators | None = None,
        stride: int = 1,
        events: int = 0,
    ) -> Chunk:
        """Take n short steps; the last long step is shorter if they are not whole ones."""
        room = n // every + 1 if every else 0
        system = self.system
        recorder = new_recorder(
            system.sizes["no"], every=every, stride=stride, rows=room, sums=statistics, events=events
        )
        plain = self.order(1)
        again, blank = (
            np.zeros(1, RECORDER),
            recorder._replace(sums=recorder.sums[:0], counts=recorder.counts[:0]),
        )
        fill_record(again, blank)
        order = np.zeros(1, PAIR)
        o = order[0]
        o["t0"], o["h"], o["rho"], o["tol"] = self.t0, self.h, self.rho_inf, self.tolerance
        o["first"], o["n"], o["count"], o["last"] = self.steps, n, self.count, self.last
        o["fast"], o["slow"] = (part.at for part in self.parts)
        o["order"], o["code"] = plain.ctypes.data, address(generalized_alpha.entry)
        o["again"], o["mask"] = again.ctypes.data, self.late.ctypes.data
        done = advance_into(entry, system.workspace.at, order, recorder)
        self.last = int(order[0]["last"])
        for part in self.parts:
            system.workspace.clock[REJECTED] += part.arrays["clock"][REJECTED]
            part.arrays["clock"][REJECTED] = 0
        self.steps += done.steps
        return done

    def go_on(self) -> int:
        """Start or restart at the state in the workspace, after a jump of the forces; returns the status."""
        status, w = super().go_on(), self.system.workspace
        self._rescale(self.parts[1], 0.0)  # their slopes contain vibrations of the gear train
        self.last = self.count
        w.arrays["ev1"][:] = w.arrays["ev0"]  # short steps evaluate only events of the fast part
        for part in self.parts:
            part.arrays["clock"][VALID] = 0
        if status == OK:
            status = self.parts[0].run(measure_entry, self.t)
        if status == OK:  # short steps write only the channels of the fast part
            w.arrays["row"][:] = evaluate.observe(self.system, evaluate.store(self.system, self.t))
        return status

    def change_step(self, h: float) -> None:
        """Change the short step from the present time on."""
        for part in self.parts:
            self._rescale(part, h / self.h)
        self.t0, self.steps, self.h = self.t, 0, h

    def _rescale(self, part: Part, ratio: float) -> None:
        """Rescale the values of a part that are a fraction of a step ahead or behind."""
        w, own = self.system.workspace, part.own
        for name in ("al", "ap"):
            w.arrays[name][own] = w.a[own] + (w.arrays[name][own] - w.a[own]) * ratio
        part.arrays["clock"][VALID] = 0
