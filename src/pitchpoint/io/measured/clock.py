# SPDX-License-Identifier: Apache-2.0
"""Times of a record from its time axis, the sample rates that the file states, or the option."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pitchpoint.io.measured.record import Column, MeasuredError, Record, refused
from pitchpoint.io.measured.stated import AGREE, FASTEST, SLOWEST, Stated
from pitchpoint.io.measured.units import to_si

UNIFORM = 1e-6
"""Tolerance of the times of a uniform record, relative to the step, as in `analysis.sampled`."""
_SHOWN = 12


def finite(path: Path, columns: Sequence[Column]) -> None:
    """Reject samples that are NaN or infinite; all channels are reported together."""
    problems = []
    for c in columns:
        bad = np.flatnonzero(~np.isfinite(c.values))
        if bad.size:
            k = int(bad[0])
            problems.append(
                f"{c.name}: {bad.size} of {c.values.size} samples, first {c.values[k]} at sample {k}"
            )
    if problems:
        raise refused(
            path,
            "; ".join(problems[:_SHOWN]),
            "",
            "are not finite numbers",
            "0",
            "cut the record before them, repair them, or choose the other channels by channels=",
        )


@dataclass(frozen=True)
class Clock:
    """Times of a record.

    Attributes
    ----------
    time
        Times [s], shape (n,).
    rate
        Sample rate [Hz]; None if the steps differ.
    source
        Name of the number in the file that gives the sample rate; empty if another one gives it.
    notes
        Corrections of the times, and statements that were not used.
    """

    time: NDArray[np.float64]
    rate: float | None
    source: str = ""
    notes: tuple[str, ...] = ()


def clock_of(path: Path, record: Record, count: int, sample_rate: float | None) -> Clock:
    """Times of `count` samples; `sample_rate` [Hz] is the option, or None."""
    if sample_rate is not None and not (np.isfinite(sample_rate) and sample_rate > 0.0):
        raise refused(path, "sample_rate", f"{sample_rate:g} Hz", "is impossible", "> 0", "give it in Hz")
    stated, notes = _stated(path, record, sample_rate)
    rate = sample_rate if sample_rate is not None else stated.value if stated else None
    if record.time is not None:
        time, rate, more = _stored_axis(path, record, rate, stated if sample_rate is None else None)
        return Clock(time, rate, record.time.name, (*notes, *more))
    if rate is None:
        raise refused(
            path,
            "time",
            "",
            "the file has neither a time axis nor a sample rate",
            "one of them",
            "give sample_rate=",
        )
    source = stated.name if stated is not None and sample_rate is None else ""
    return Clock(_even_times(record.start, count, rate), rate, source, tuple(notes))


def _even_times(start: float, count: int, rate: float) -> NDArray[np.float64]:
    """Times of evenly spaced samples, without copies."""
    time = np.arange(count, dtype=np.float64)
    time /= rate
    time += start
    return time


def _stated(path: Path, record: Record, sample_rate: float | None) -> tuple[Stated | None, list[str]]:
    """Sample rate that the file states, and notes on the statements that the option overrules."""
    possible = [r for r in record.rates if SLOWEST <= r.value <= FASTEST]
    impossible = [r for r in record.rates if r not in possible]
    decided = sample_rate is not None
    if impossible and not decided and not (possible or record.time):
        one = impossible[0]
        raise refused(
            path, one.name, one.shown, "is not a sample rate", "0.01 Hz to 1 GHz", "give sample_rate="
        )
    notes = [f"{r.name} = {r.shown} is not a sample rate: not used" for r in impossible]
    if not possible:
        return None, notes
    agree = [r for r in possible if abs(r.value / (sample_rate or possible[0].value) - 1.0) <= AGREE]
    others = [r for r in possible if r not in agree]
    if others and not decided:
        remedy = "give the correct one by sample_rate="
        listed = _listed(possible)
        raise refused(path, "sample rate", listed, "contradict each other", "0.1 %", remedy)
    if decided and not agree and record.time is None:
        raise _contradiction(path, float(sample_rate or 0.0), _listed(possible))
    notes += [f"{r.name} = {r.shown} contradicts sample_rate=: not used" for r in others]
    return (agree[0] if agree else None), notes


def _listed(stated: Sequence[Stated]) -> str:
    """Statements with their values in the file, and in Hz if these are intervals."""
    return ", ".join(
        f"{r.name} {r.shown}" + ("" if r.shown.endswith("Hz") else f" ({r.value:.6g} Hz)") for r in stated
    )


def _contradiction(path: Path, given: float, limit: str) -> MeasuredError:
    return refused(
        path, "sample_rate=", f"{given:g} Hz", "contradicts the file", limit, "leave it out or correct it"
    )


def _agree(path: Path, given: float, axis: float, stated: Stated | None) -> None:
    """Compare the sample rate with that of the time axis."""
    if abs(given - axis) <= AGREE * axis:
        return
    if stated is None:
        raise _contradiction(path, given, f"{axis:.6g} Hz")
    remedy = "give the correct one by sample_rate="
    limit = f"{axis:.6g} Hz"
    raise refused(path, stated.name, _listed([stated]), "contradicts the time axis", limit, remedy)


def _stored_axis(
    path: Path, record: Record, rate: float | None, stated: Stated | None
) -> tuple[NDArray[np.float64], float | None, list[str]]:
    """Time axis of the file; rounded times are moved to an even grid."""
    assert record.time is not None
    unit, factor, known = to_si(record.time.unit)
    if unit not in ("", "s") or not known:
        message, remedy = "is not a unit of time", "correct it in the file, such as time [s]"
        raise refused(path, record.time.name, repr(record.time.unit), message, "s, ms, min, h", remedy)
    time, own = record.time.values * factor, record.form.startswith("pitchpoint")
    finite(path, [record.time])
    steps = np.diff(time)
    step = float(time[-1] - time[0]) / steps.size
    grid = time[0] + np.arange(time.size) * step
    off = float(np.abs(time - grid).max())
    exact = UNIFORM * step + 4.0 * np.finfo(np.float64).eps * float(np.abs(time).max())
    resolution = record.resolution * factor
    if step > 0.0 and off > exact and off <= 1.001 * resolution and resolution <= 0.25 * step:
        found = rate if rate is not None else 1.0 / step
        _agree(path, found, 1.0 / step, stated)
        note = f"times are rounded to {resolution:g} s and were moved to an even grid"
        return _even_times(float(time[0]), time.size, found), found, [note]
    back = np.flatnonzero(steps <= 0.0)
    if back.size:
        k = int(back[0])
        coarse = resolution > 0.25 * abs(step)
        message = "does not increase" + (f" (times are written to {resolution:g} s only)" if coarse else "")
        remedy = (
            "delete the column and give sample_rate=" if coarse else "sort the file, drop repeated samples"
        )
        raise _uneven(
            path, record, f"sample {k + 1} at {time[k + 1]:.9g} s after {time[k]:.9g} s", message, remedy
        )
    if off <= exact:
        if rate is not None:
            _agree(path, rate, 1.0 / step, stated)
        return time, 1.0 / step, []
    if own:  # adaptive solvers store variable steps; functions that require even steps report it
        return time, None, ["times are not evenly spaced"]
    usual = float(np.median(steps))
    k = int(np.argmax(np.abs(steps - usual)))
    value = f"step {steps[k]:.6g} s after sample {k}"
    raise _uneven(
        path,
        record,
        value,
        f"differs from the usual {usual:.6g} s: samples are missing or unevenly spaced",
        "resample the record evenly, or cut it where samples are missing",
    )


def _uneven(path: Path, record: Record, value: str, message: str, remedy: str) -> MeasuredError:
    assert record.time is not None
    return refused(path, record.time.name, value, message, "even steps", remedy)
