# SPDX-License-Identifier: Apache-2.0
"""Channels over the angle of the reference shaft."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.sampled import as_increasing, as_signal, same_length
from pitchpoint.analysis.speed_track import SpeedTrack

Array = NDArray[np.float64]

STEADY = 1e-3
"""Relative spread of the speed within which frequencies are given in Hz."""


@dataclass(frozen=True)
class FoundSpeed:
    """Speed found in a record, for its picture.

    Attributes
    ----------
    track
        Speed and angle.
    signals
        Channels over time, shape (n,) each.
    sample_rate
        Their sample rate [Hz].
    start
        Time of the first sample [s].
    """

    track: SpeedTrack
    signals: Mapping[str, Array]
    sample_rate: float
    start: float


@dataclass(frozen=True)
class OverAngle:
    """Channels over the angle of the reference shaft.

    Attributes
    ----------
    signals
        Values by channel, shape (n,) each.
    samples_per_turn
        Samples per turn [-].
    frequency
        Rotation frequency [Hz]; NaN if the speed varies.
    sampled_per_turn
        Samples per turn of the original record [-].
    remarks
        Remarks on the processing.
    zeros
        By shaft: its angle at the first sample, in its sense of rotation [rad], and the zero of this angle in
        words; a shaft that is not listed has angle 0 at `began`.
    began
        First sample in words.
    source
        Source of the speed.
    tolerance
        Relative tolerance of the speed [-]; 0 if an angle, a tacho or lines of the record determine it.
    lines
        Lines that determine the speed: `mesh`, `shaft`, or empty.
    speeds
        Lowest and highest rotation frequency [Hz], if the speed varies.
    found
        Varying speed that was found in the record itself.
    advice
        Remark that the speed varies and a range is to be given; empty if it does not.
    doubt
        Doubt about the tooth numbers on which the speed depends, in words; empty if there is none.
    names_gears
        Whether gears may be named in spite of this doubt.
    """

    signals: dict[str, Array]
    samples_per_turn: float
    frequency: float
    sampled_per_turn: float
    remarks: tuple[str, ...] = ()
    zeros: Mapping[str, tuple[float, str]] = field(default_factory=dict)
    began: str = "the start of the record"
    source: str = ""
    tolerance: float = 0.0
    lines: str = ""
    speeds: tuple[float, float] | None = None
    found: FoundSpeed | None = None
    advice: str = ""
    doubt: str = ""
    names_gears: bool = True


def over_angle(
    signals: Mapping[str, Array], time: Array, angle: Array, speeds: tuple[float, float] | None = None
) -> OverAngle:
    """Resample channels at equal steps of an angle [rad] recorded with them.

    `speeds` are the lowest and the highest rotation frequency [Hz], if they are known; else they are those of
    the angle, whose errors they contain.
    """
    from pitchpoint.analysis.orders import resample_over_angle

    clock = as_increasing(time)
    turned = as_signal(angle, "angle", 16)
    same_length(turned, clock, "angle, time")
    speed = np.gradient(turned, clock) / math.tau
    low, high = speeds or (float(np.abs(speed).min()), float(np.abs(speed).max()))
    found, rate = {}, math.nan
    for name, values in signals.items():
        resampled = resample_over_angle(as_signal(values, name, 16), turned)
        found[name], rate = resampled.values, resampled.samples_per_revolution
    mean = abs(float(turned[-1] - turned[0])) / float(clock[-1] - clock[0]) / math.tau
    tenths = np.abs(np.diff(turned[np.linspace(0, turned.size - 1, 11).astype(int)]))
    steady = float(np.ptp(tenths)) < 10.0 * STEADY * float(tenths.mean())
    remarks = (
        []
        if steady
        else [
            f"the speed varies from {60.0 * low:.4g} to {60.0 * high:.4g} rpm: orders instead of frequencies"
        ]
    )
    taken = (clock.size - 1) / (abs(float(turned[-1] - turned[0])) / math.tau)
    limits = None if steady else (low, high)
    return OverAngle(found, float(rate), mean if steady else math.nan, taken, tuple(remarks), speeds=limits)
