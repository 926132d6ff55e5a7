# SPDX-License-Identifier: Apache-2.0
"""Generalised-alpha with short steps of gear trains within longer steps of the rest of the machine.

A long step begins with the short steps of the gear trains (fast part), during which all other coordinates
(slow
part) follow the linear extrapolation of their accelerations. Then the slow part takes its step. It is loaded
by the mean force of the fast part, extrapolated to the end of the step from two long steps: forces at the
mesh
frequencies, sampled once per long step, would appear as slow vibrations. Both parts are implicit and of
second order; elements between them must be soft compared with the inertia of the slow part (`gear_part`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import BAD_CENTRE, DIVERGED, OK, SLOW, UNBOUNDED
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.solvers.contact_counts import count_contacts
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.implicit.newton import newton_step
from pitchpoint.solvers.implicit.step import DIVISION, MAX_PARTS, coefficients
from pitchpoint.solvers.sampling import (
    Accumulators,
    Chunk,
    add_value,
    advance_into,
    due,
    keep,
    new_recorder,
    record_events,
    record_step,
    recorder_at,
)
from pitchpoint.system import evaluate
from pitchpoint.system.part import Part
from pitchpoint.system.residual import observe, wrap
from pitchpoint.system.workspace import MACH, REJECTED, STAGE_ROWS, STEPS, VALID

BEGIN = 0
"""First of three rows of the stages of a part: q and v, a and both memories at the start of its step."""

SUM = 3
"""First of two rows of the stages of the slow part: mean forces of the fast part in this and in the last long
step, whether there has been one, and 1 for the coordinates with such forces."""

PAIR = np.dtype(
    [
        *((name, "f8") for name in ("t0", "h", "rho", "tol")),
        *((name, "i8") for name in ("first", "n", "fast", "slow", "count", "last")),
    ],
    align=True,
)
"""Arguments of the loop: short step h, n short steps, control records of both parts, number of short steps
per long step and in the last one."""


@kernel
def _keep(c, m):
    """Save the values of a part at the start of a step."""
    nd = c["nd"]
    own = view(m["own"], m["nown"], I8)
    stage = view(m["stage"], (STAGE_ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    al = view(m["al"], nd, F8)
    ap = view(m["ap"], nd, F8)
    for k in range(own.size):
        i = own[k]
        stage[BEGIN, i] = q[i]
        stage[BEGIN, nd + i] = v[i]
        stage[BEGIN + 1, i] = a[i]
        stage[BEGIN + 1, nd + i] = al[i]
        stage[BEGIN + 2, i] = ap[i]


@kernel
def _back(c, m):
    """Restore the values of a part at the start of a step."""
    nd = c["nd"]
    own = view(m["own"], m["nown"], I8)
    stage = view(m["stage"], (STAGE_ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    al = view(m["al"], nd, F8)
    ap = view(m["ap"], nd, F8)
    for k in range(own.size):
        i = own[k]
        q[i] = stage[BEGIN, i]
        v[i] = stage[BEGIN, nd + i]
        a[i] = stage[BEGIN + 1, i]
        al[i] = stage[BEGIN + 1, nd + i]
        ap[i] = stage[BEGIN + 2, i]


@kernel
def _follow(c, m, tau, h):
    """Extrapolate a part from the start of its step by tau, with the slope of its accelerations over h."""
    nd = c["nd"]
    own = view(m["own"], m["nown"], I8)
    stage = view(m["stage"], (STAGE_ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    for k in range(own.size):
        i = own[k]
        a0 = stage[BEGIN + 1, i]
        jerk = (a0 - stage[BEGIN + 2, i]) / h
        a[i] = a0 + jerk * tau
        v[i] = stage[BEGIN, nd + i] + tau * (a0 + 0.5 * jerk * tau)
        q[i] = stage[BEGIN, i] + tau * (stage[BEGIN, nd + i] + tau * (0.5 * a0 + jerk * tau / 6.0))


@kernel
def _other_step(c, m, ratio):
    """Rescale the values a fraction of a step ahead or behind, for steps of `ratio` times the length."""
    nd = c["nd"]
    own = view(m["own"], m["nown"], I8)
    a = view(c["a"], nd, F8)
    al = view(m["al"], nd, F8)
    ap = view(m["ap"], nd, F8)
    for k in range(own.size):
        i = own[k]
        al[i] = a[i] + (al[i] - a[i]) * ratio
        ap[i] = a[i] + (ap[i] - a[i]) * ratio
    view(m["clock"], 16, I8)[VALID] = 0


@kernel
def _add_force(c, n, k, count):
    """Add the forces of the fast part on the slow coordinates after short step k to their mean.

    After the last one, k = count, `shift` becomes the mean, extrapolated to the end of the long step, less
    the present forces.
    """
    nd = c["nd"]
    own = view(n["own"], n["nown"], I8)
    R = view(c["R"], nd, F8)
    shift = view(n["shift"], nd, F8)
    stage = view(n["stage"], (STAGE_ROWS, 2 * nd), F8)
    for j in range(own.size):
        i = own[j]
        if k == 1:
            stage[SUM, i] = 0.0
        stage[SUM, i] += R[i] / count
        if k == count and stage[SUM + 1, nd + i] != 0.0:
            mean = stage[SUM, i]
            before = mean if stage[SUM + 1, 0] == 0.0 else stage[SUM, nd + i]
            stage[SUM, nd + i] = mean
            shift[i] = mean + (mean - before) * (count - 1.0) / (2.0 * count) - R[i]
    if k == count:
        stage[SUM + 1, 0] = 1.0


@kernel
def part_step(at, t, h, rho, tol):
    """One generalised-alpha step of a part to the time t; see `step.alpha_step`."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    own = view(m["own"], m["nown"], I8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    a = view(c["a"], nd, F8)
    al = view(m["al"], nd, F8)
    ap = view(m["ap"], nd, F8)
    beta, gamma, alpha_m, alpha_f = coefficients(rho)
    cm = (1.0 - alpha_m) / (h * h * beta * (1.0 - alpha_f))
    cd = gamma / (h * beta)
    share = (1.0 - alpha_f) / (1.0 - alpha_m)
    for k in range(own.size):
        i = own[k]
        last = al[i]
        guess = 2.0 * a[i] - ap[i]
        new = ((1.0 - alpha_f) * guess + alpha_f * a[i] - alpha_m * last) / (1.0 - alpha_m)
        q[i] += h * v[i] + h * h * ((0.5 - beta) * last + beta * new)
        v[i] += h * ((1.0 - gamma) * last + gamma * new)
        ap[i] = a[i]
        a[i] = guess
        al[i] = new - share * guess  # the solved acceleration is added below
    status = newton_step(at, t, cm, cd, tol)
    if status == OK:
        for k in range(own.size):
            i = own[k]
            al[i] += share * a[i]
    return status


@kernel
def _short_step(at, other, t, tau, h, whole, rho, tol):
    """One short step that ends at t, tau after the start of the long step `whole`; divided if it fails."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    s = view(other, 1, CTL)[0]
    n = view(s["mach"], 1, MACH)[0]
    _keep(c, m)
    _follow(s, n, tau, whole)
    status = part_step(at, t, h, rho, tol)
    parts = DIVISION
    while parts <= MAX_PARTS:
        if not (status == SLOW or status == DIVERGED or status == BAD_CENTRE or status == UNBOUNDED):
            break
        view(m["clock"], 16, I8)[REJECTED] += 1 if parts == DIVISION else 0
        _back(c, m)
        _other_step(c, m, 1.0 / parts)
        for p in range(1, parts + 1):
            left = (parts - p) * h / parts
            _follow(s, n, tau - left, whole)
            status = part_step(at, t - left, h / parts, rho, tol)
            if status != OK:
                break
        if status == OK:
            _other_step(c, m, 1.0 * parts)
        parts *= DIVISION
    return status


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
        count = min(o["count"] - (o["first"] + done) % o["count"], o["n"] - done)
        if count != o["last"]:
            _other_step(s, n, count / o["last"])
            o["last"] = count
        whole = count * h
        start = o["t0"] + (o["first"] + done) * h
        _keep(s, n)
        for k in range(1, count + 1):
            t = o["t0"] + (o["first"] + done + k) * h
            status = _short_step(fast, slow, t, k * h, h, whole, o["rho"], o["tol"])
            if status != OK:
                _back(f, m)
                break
            _add_force(f, n, k, count)
            wrap(fast)
            clock[STEPS] += 1
            if k < count:
                status = _record_short(fast, t, h, o["first"] + done + k, rec)
                if status != OK:
                    break
        _back(s, n)
        if status == OK:
            status = part_step(slow, start + whole, whole, o["rho"], o["tol"])
            if status != OK:
                _back(s, n)
        if status == OK:
            wrap(slow)
            done += count
            rec.done[0] = done
            status = record_step(at, start + whole, h, o["first"] + done, rec)
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
    last
        Short steps in the last long step.
    """

    count: int = 1
    parts: tuple[Part, ...] = ()
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
        at = (part.at for part in self.parts)
        times = (self.t0, self.h, self.rho_inf, self.tolerance)
        order = np.array([(*times, self.steps, n, *at, self.count, self.last)], PAIR)
        done = advance_into(entry, system.workspace.at, order, recorder)
        self.last = int(order[0]["last"])
        system.workspace.clock[REJECTED] = self.parts[0].arrays["clock"][REJECTED]
        self.steps += done.steps
        return done

    def go_on(self) -> int:
        """Start or restart at the state in the workspace, after a jump of the forces; returns the status."""
        status, w = super().go_on(), self.system.workspace
        self._rescale(self.parts[1], 0.0)  # their slopes contain vibrations of the gear train
        self.last = self.count
        self.parts[1].arrays["stage"][SUM + 1, 0] = 0.0
        for part in self.parts:
            part.arrays["clock"][VALID] = 0
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
