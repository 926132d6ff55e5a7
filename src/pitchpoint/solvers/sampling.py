# SPDX-License-Identifier: Apache-2.0
"""Output of time loops: sampled rows, running statistics, recorded events.

Nothing is stored per step. A chunk fills the caller's buffers: one row of channel values every n-th step, and
running statistics per channel over all steps for which they are enabled.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.kernel import invoke, kernel, view
from pitchpoint.core.status import OK, UNBOUNDED
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.solvers.contact_counts import COUNTS, count_contacts
from pitchpoint.system.residual import evaluate_events, observe
from pitchpoint.system.workspace import MACH

#: Columns of the running statistics. Sums are of x - reference, so that a large mean does not cost accuracy.
COUNT, REFERENCE, SUM, SQUARES, MINIMUM, MAXIMUM, NEGATIVE, ZERO = range(8)

#: Columns of a recorded event: time, index of the event function, direction (+1 rising, -1 falling).
EVENT_COLUMNS = 3
GREATEST = 1e100
"""Magnitude from which a solution counts as diverged, for any unit; its square is still finite."""


class Recorder(NamedTuple):
    """Output buffers of a chunk of steps.

    Parameters
    ----------
    every
        Store a row at step numbers divisible by it; 0: no rows. Fixed-step methods only.
    stride
        Update the statistics at step numbers divisible by it. Fixed-step methods only.
    rows
        Sample buffer (time, channel values ...), shape (n, no + 1).
    sums
        Running statistics, shape (no, 8); disabled if empty.
    counts
        Counters of the contacts of every mesh, updated with the statistics.
    found
        Event buffer (time, event function, direction), shape (n, 3); event detection is disabled if empty.
    done
        Number of steps, samples and events of the chunk.
    picked
        Channels of the samples, in this order; all if empty.
    """

    every: int
    stride: int
    rows: NDArray[np.float64]
    sums: NDArray[np.float64]
    counts: NDArray[np.void]
    found: NDArray[np.float64]
    done: NDArray[np.int64]
    picked: NDArray[np.int64]


@dataclass
class Accumulators:
    """Running statistics of a window, updated in place by a time loop.

    Parameters
    ----------
    sums
        Sums of the channels, shape (no, 8).
    counts
        Counters of the contacts of every mesh, see `contact_counts`.
    """

    sums: NDArray[np.float64]
    counts: NDArray[np.void]

    def copy(self) -> Accumulators:
        """Independent copy."""
        return Accumulators(self.sums.copy(), self.counts.copy())


def new_recorder(
    no: int,
    *,
    every: int = 0,
    stride: int = 1,
    rows: int = 0,
    sums: Accumulators | None,
    events: int,
    picked: NDArray[np.int64] | None = None,
) -> Recorder:
    """Allocate the buffers of a chunk: `rows` samples of all `no` or the picked channels, `events` events."""
    chosen = np.zeros(0, np.int64) if picked is None else picked
    return Recorder(
        every,
        stride,
        np.empty((rows, (len(chosen) or no) + 1)),
        np.zeros((0, 8)) if sums is None else sums.sums,
        np.zeros(0, COUNTS) if sums is None else sums.counts,
        np.empty((events, EVENT_COLUMNS)),
        np.zeros(3, np.int64),
        chosen,
    )


@dataclass
class Chunk:
    """Result of one call of a time loop.

    Parameters
    ----------
    status
        Status code; OK, or why the loop stopped.
    steps
        Accepted steps.
    rows
        Samples (time, channel values ...), shape (n, no + 1).
    events
        Recorded events (time, event function, direction), shape (n, 3).
    lost
        First diverged sample, shape (no + 1,); `rows` end before it.
    """

    status: int
    steps: int
    rows: NDArray[np.float64]
    events: NDArray[np.float64]
    lost: NDArray[np.float64] | None = None


#: Record layout of a Recorder: addresses and sizes of its buffers.
RECORDER = np.dtype(
    [
        (name, "i8")
        for name in (
            "every",
            "stride",
            "rows",
            "n_rows",
            "columns",
            "sums",
            "n_sums",
            "counts",
            "n_counts",
            "found",
            "n_found",
            "done",
            "picked",
            "n_picked",
        )
    ],
    align=True,
)


def fill_record(record: NDArray[np.void], recorder: Recorder) -> None:
    """Write the addresses and sizes of the buffers to a RECORDER record, shape (1,)."""
    record[0]["every"], record[0]["stride"] = recorder.every, recorder.stride
    record[0]["columns"] = recorder.rows.shape[1]
    buffers = (
        ("rows", recorder.rows),
        ("sums", recorder.sums),
        ("counts", recorder.counts),
        ("found", recorder.found),
        ("picked", recorder.picked),
    )
    for name, array in buffers:
        record[0][name], record[0][f"n_{name}"] = array.ctypes.data, len(array)
    record[0]["done"] = recorder.done.ctypes.data


def advance_into(entry: Any, at: int, order: NDArray[np.void], recorder: Recorder) -> Chunk:
    """Run a compiled time loop for one chunk.

    Parameters
    ----------
    entry
        Entry of the loop; takes the addresses of the control record, the order and a RECORDER record.
    at
        Address of the control record.
    order
        Arguments of the loop, a record in its own layout, shape (1,).
    recorder
        Buffers to fill.
    """
    rows, sums, found, done = recorder.rows, recorder.sums, recorder.found, recorder.done
    record = np.zeros(1, RECORDER)
    fill_record(record, recorder)
    status = invoke(entry, at, order.ctypes.data, record.ctypes.data)
    steps, samples, events = (int(n) for n in done)
    kept, lost = rows[:samples], None
    if not bounded(kept):
        first = int(np.argmax(~(np.abs(kept) < GREATEST).all(axis=1)))
        kept, lost = kept[:first], kept[first].copy()
    if lost is not None or not (bounded(sums[:, SUM]) and bounded(sums[:, MINIMUM : MAXIMUM + 1])):
        status = UNBOUNDED  # any other status is a consequence of the divergence
    return Chunk(status, steps, kept, found[: min(events, len(found))], lost)


def bounded(values: NDArray[np.float64]) -> bool:
    """Whether all values are finite and below the divergence limit; two passes without a copy.

    Examples
    --------
    >>> bounded(np.array([0.0, -1e99])), bounded(np.array([0.0, np.nan])), bounded(np.zeros((0, 3)))
    (True, False, True)
    """
    return not values.size or bool(values.min() > -GREATEST and values.max() < GREATEST)


@kernel(inline=True)
def recorder_at(where):
    """Recorder from the address of its record."""
    b = view(where, 1, RECORDER)[0]
    return Recorder(
        b["every"],
        b["stride"],
        view(b["rows"], (b["n_rows"], b["columns"]), F8),
        view(b["sums"], (b["n_sums"], 8), F8),
        view(b["counts"], b["n_counts"], COUNTS),
        view(b["found"], (b["n_found"], EVENT_COLUMNS), F8),
        view(b["done"], 3, I8),
        view(b["picked"], b["n_picked"], I8),
    )


@dataclass(frozen=True)
class Statistics:
    """Statistics of all channels over the steps of a window; arrays of shape (no,), NaN without steps.

    Parameters
    ----------
    count
        Number of steps, of the channels with most of them.
    mean, rms, least, most
        Mean, rms of the alternating part, minimum and maximum.
    share_negative, share_zero
        Fraction of the steps with a negative value and with zero; for the contact state: back-flank contact
        and contact loss.
    """

    count: int
    mean: NDArray[np.float64]
    rms: NDArray[np.float64]
    least: NDArray[np.float64]
    most: NDArray[np.float64]
    share_negative: NDArray[np.float64]
    share_zero: NDArray[np.float64]


def new_statistics(n: int, counts: NDArray[np.void] | None = None) -> Accumulators:
    """Empty accumulators for n channels, and the counters of `contact_counts.new_counts`."""
    return Accumulators(np.zeros((n, 8)), np.zeros(0, COUNTS) if counts is None else counts)


def read_statistics(accumulators: Accumulators) -> Statistics:
    """Compute statistics from the accumulators."""
    sums = accumulators.sums
    n = np.where(sums[:, COUNT] > 0.0, sums[:, COUNT], np.nan)
    mean = sums[:, SUM] / n
    variance = np.maximum(sums[:, SQUARES] / n - mean**2, 0.0)
    return Statistics(
        count=int(sums[:, COUNT].max()) if len(sums) else 0,
        mean=sums[:, REFERENCE] + mean,
        rms=np.sqrt(variance),
        least=np.where(n > 0.0, sums[:, MINIMUM], np.nan),
        most=np.where(n > 0.0, sums[:, MAXIMUM], np.nan),
        share_negative=sums[:, NEGATIVE] / n,
        share_zero=sums[:, ZERO] / n,
    )


@kernel(inline=True)
def add_value(x, s):
    """Add a channel value to the running statistics of this channel."""
    if s[COUNT] == 0.0:
        s[REFERENCE] = x
        s[MINIMUM] = x
        s[MAXIMUM] = x
    d = x - s[REFERENCE]
    s[COUNT] += 1.0
    s[SUM] += d
    s[SQUARES] += d * d
    s[MINIMUM] = min(s[MINIMUM], x)
    s[MAXIMUM] = max(s[MAXIMUM], x)
    s[NEGATIVE] += 1.0 if x < 0.0 else 0.0
    s[ZERO] += 1.0 if x == 0.0 else 0.0


@kernel(inline=True)
def accumulate(row, sums):
    """Add one row of channel values to the running statistics."""
    for k in range(row.size):
        add_value(row[k], sums[k])


@kernel
def take(at, t, recorder, measure, sample):
    """Evaluate the channels; update the statistics and store the row as requested, within the buffer."""
    status = observe(at, t, view(view(at, 1, CTL)[0]["mach"], 1, MACH)[0]["row"])
    if status == OK:
        keep(at, t, recorder, measure, sample)
    return status


@kernel(inline=True)
def keep(at, t, recorder, measure, sample):
    """Update the statistics with the evaluated row and store it as requested, within the buffer."""
    c = view(at, 1, CTL)[0]
    row = view(view(c["mach"], 1, MACH)[0]["row"], c["no"], F8)
    if measure != 0:
        accumulate(row, recorder.sums)
        count_contacts(t, row, recorder.counts)
    filled = recorder.done[1]
    if sample != 0 and filled < recorder.rows.shape[0]:
        recorder.rows[filled, 0] = t
        picked = recorder.picked
        if picked.size > 0:
            for k in range(picked.size):
                recorder.rows[filled, k + 1] = row[picked[k]]
        else:
            for k in range(row.size):
                recorder.rows[filled, k + 1] = row[k]
        recorder.done[1] += 1


@kernel
def samples_up_to(t, grid):
    """Index of the last sample up to a time; a sample that differs from it by rounding only is included."""
    limit = t + 1e-15 * abs(t)
    k = math.floor((t - grid[0]) / grid[1])
    while grid[0] + k * grid[1] > limit:
        k -= 1
    while grid[0] + (k + 1) * grid[1] <= limit:
        k += 1
    return k


@kernel
def changes_sign(a, b):
    """Whether an event function changes sign from `a` to `b`; the wrap of a phase does not count."""
    return ((a < 0.0 and b >= 0.0) or (a > 0.0 and b <= 0.0)) and abs(b - a) <= 0.5


@kernel
def crossings(ev0, ev1, t0, h, found, n):
    """Record sign changes between two steps by linear interpolation; returns the new number of records.

    A value that starts at zero does not count again, nor does the wrap of a phase. Records beyond the buffer
    are counted but not written.
    """
    for k in range(ev0.size):
        a = ev0[k]
        b = ev1[k]
        if changes_sign(a, b):
            if n < found.shape[0]:
                found[n, 0] = t0 + h * a / (a - b)
                found[n, 1] = k
                found[n, 2] = 1.0 if b > a else -1.0
            n += 1
    return n


@kernel(inline=True)
def due(number, recorder):
    """Flags (0 or 1) of whether statistics and a row are due after step `number` of a fixed-step loop."""
    measure = 1 if recorder.sums.shape[0] > 0 and number % recorder.stride == 0 else 0
    return measure, 1 if recorder.every > 0 and number % recorder.every == 0 else 0


@kernel(inline=True)
def record_step(at, t, h, number, recorder):
    """Record statistics, sample and events of step `number` of a fixed-step loop at t; returns a status."""
    measure, sample = due(number, recorder)
    if sample != 0 or measure != 0:
        status = take(at, t, recorder, measure, sample)
        if status != OK:
            return status
    return record_events(at, t, h, recorder)


@kernel(inline=True)
def record_events(at, t, h, recorder):
    """Record the sign changes of event functions in a step h that ends at t; returns a status."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    if recorder.found.shape[0] > 0 and c["ne"] > 0:
        status = evaluate_events(at, t, m["ev1"])
        if status != OK:
            return status
        ev0 = view(m["ev0"], c["ne"], F8)
        ev1 = view(m["ev1"], c["ne"], F8)
        recorder.done[2] = crossings(ev0, ev1, t - h, h, recorder.found, recorder.done[2])
        for i in range(ev0.size):
            ev0[i] = ev1[i]
    return OK
