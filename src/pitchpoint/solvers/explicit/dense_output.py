# SPDX-License-Identifier: Apache-2.0
"""Dense output of adaptive methods, and location of events (sign changes) within a step."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.solvers.explicit.derivative import DENSE, OLD, ROWS
from pitchpoint.solvers.sampling import changes_sign
from pitchpoint.system.residual import evaluate_events
from pitchpoint.system.workspace import MACH


@kernel
def interpolate(at, x, n):
    """Interpolate the state at the fraction x of the step into the workspace; n coefficients."""
    c = view(at, 1, CTL)[0]
    nd = c["nd"]
    stage = view(view(c["mach"], 1, MACH)[0]["stage"], (ROWS, 2 * nd), F8)
    q = view(c["q"], nd, F8)
    v = view(c["v"], nd, F8)
    for i in range(2 * nd):
        s = 0.0
        for r in range(n - 1, -1, -1):
            s = (s + stage[DENSE + r, i]) * (x if r % 2 == 0 else 1.0 - x)
        s += stage[OLD, i]
        if i < nd:
            q[i] = s
        else:
            v[i - nd] = s


@kernel
def _estimate(a, b, low, high, most):
    """Next trial point for a sign change between a and b, at most `most` from the middle (ITP method).

    The secant point, shifted slightly towards the middle so that both ends of the bracket move:
    I. F. D. Oliveira, R. H. C. Takahashi, ACM Trans. Math. Softw. 47 (2020), no. 5, with kappa_1 0.2,
    kappa_2 2.
    """
    middle = 0.5 * (a + b)
    chord = b - high * (b - a) / (high - low)
    off = chord - middle
    side = 1.0 if off > 0.0 else -1.0
    off = side * max(abs(off) - 0.2 * (b - a) * (b - a), 0.0)
    return middle + min(max(off, -most), most)


@kernel
def _locate(at, t, h, n, k, low, high):
    """Fraction of the step just after the sign change of event function k, to rounding of the time.

    Needs at most one evaluation more than bisection, even for discontinuous functions such as contact.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    ev = view(m["ev1"], c["ne"], F8)
    a = 0.0
    b = 1.0
    close = 1e-13 * max(abs(t), abs(h)) / abs(h)
    room = 0.5 * close  # half of the largest bracket for which the remaining bisections suffice
    while room < 1.0:
        room *= 2.0
    while b - a > close and room > 0.1 * close:
        x = _estimate(a, b, low, high, room - 0.5 * (b - a))
        room *= 0.5
        interpolate(at, x, n)
        if evaluate_events(at, t + x * h, m["ev1"]) != OK:
            break
        f = ev[k]
        if (f < 0.0) == (low < 0.0) and f != 0.0:
            a = x
            low = f
        else:
            b = x
            high = f
            if f == 0.0:
                break
    return b


@kernel
def find_events(at, t, h, dense, found, n, wanted):
    """Find all sign changes in the step, by function; returns their count and the earliest step fraction.

    wanted: address of one flag per function (0: ignored), or 0 if all functions count.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    ev0 = view(m["ev0"], c["ne"], F8)
    ev1 = view(m["ev1"], c["ne"], F8)
    first = 2.0
    counts = view(wanted, ev0.size if wanted != 0 else 0, I8)
    at_end = False
    for k in range(ev0.size):
        if wanted != 0 and counts[k] == 0:
            continue
        if not at_end:
            interpolate(at, 1.0, dense)
            if evaluate_events(at, t + h, m["ev1"]) != OK:
                return n, -1.0
            at_end = True
        low = ev0[k]
        high = ev1[k]
        if changes_sign(low, high):
            at_end = False
            x = _locate(at, t, h, dense, k, low, high)
            if x < first:
                first = x
            if n < found.shape[0]:
                found[n, 0] = t + x * h
                found[n, 1] = k
                found[n, 2] = 1.0 if high > low else -1.0
            n += 1
    return n, first


@kernel
def events_up_to(at, end, share, dense, found, before, n):
    """Discard the events after the time at which a step is cut; returns the number of records.

    Several functions may change sign simultaneously, with slightly different located times: all functions
    that have changed sign at the cut are retained.
    """
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    ev0 = view(m["ev0"], c["ne"], F8)
    ev1 = view(m["ev1"], c["ne"], F8)
    interpolate(at, share, dense)
    if evaluate_events(at, end, m["ev1"]) != OK:
        return n
    kept = before
    for r in range(before, min(n, found.shape[0])):
        k = int(found[r, 1])
        if found[r, 0] <= end or (ev1[k] > 0.0) != (ev0[k] > 0.0):
            for j in range(3):
                found[kept, j] = found[r, j]
            kept += 1
    return kept
