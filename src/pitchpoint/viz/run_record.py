# SPDX-License-Identifier: Apache-2.0
"""Common functions of the sections on time responses: evaluated part, sampling, reference shafts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from pitchpoint.analysis.sampled import SignalError, sample_rate_of
from pitchpoint.viz.quantities import Array, Channel

# Main quantities, drawn over time and listed in this order; the file contains all.
TIME_QUANTITIES = (
    "deflection",
    "transmission_error",
    "mesh_force",
    "mesh_stiffness",
    "speed",
    "displacement",
    "slip_speed",
    "contact_force",
    "tension",
    "bearing_force",
    "coupling_force",
    "torque",
    "friction_power",
    "signal",
)
FORCE_PARTS = ("circumferential_force", "radial_force", "axial_force")
# Relative change of speed above which a run counts as a run-up: maps instead of one spectrum.
RUN_UP = 0.05
# Relative variation of the ratio of two shafts up to which they count as geared.
GEARED = 0.01
ROUND_OFF = 1e-12
"""Rounding error of a time relative to the length of the record."""
# Minimum revolutions of a shaft for an order spectrum (with many teeth per revolution), and for an order map.
ORDER_TURNS, MAP_TURNS = 0.25, 2.0


def owner(channel: Channel) -> str:
    """Element that a channel belongs to: `shaft` of `displacement[shaft.x]`."""
    return channel.name.partition("[")[2].rstrip("]").partition(".")[0]


def listed(channel: Channel, quantity: str) -> bool:
    """Whether a channel has a quantity and is not an internal signal of a block (`control.integral`)."""
    return channel.quantity == quantity and (quantity != "signal" or "." not in owner(channel))


def channel_word(count: int) -> str:
    """Singular or plural of "channel"."""
    return "channel" if count == 1 else "channels"


def after_settling(time: Array, settle_time: float) -> np.ndarray:
    """Samples from the settling time on.

    Examples
    --------
    >>> steps = np.arange(1501) * 2e-5 * (1.0 - 2e-16)  # the sample at 20 ms is below 0.02 by round-off
    >>> bool(steps[1000] < 0.02), int(np.argmax(after_settling(steps, 0.02)))
    (True, 1000)
    """
    return np.asarray(time >= time[0] + settle_time - ROUND_OFF * (time[-1] - time[0]))


def settled_part(time: Array, settle_time: float) -> np.ndarray:
    """Samples of the window of statistics; all if the run ended before it."""
    inside = after_settling(time, settle_time)
    return inside if int(inside.sum()) >= 64 else np.ones(time.size, dtype=bool)


def statistics_window(time: Array, found: Mapping[str, Channel], settle_time: float) -> tuple[float, float]:
    """Beginning and end of the window of the statistics [s], of all steps or else of the stored samples.

    Parameters
    ----------
    time
        Times of the record [s], shape (n,).
    found
        Channels by name.
    settle_time
        Start of the window after the first sample [s].

    Examples
    --------
    >>> t = np.linspace(0.0, 1.0, 101)
    >>> known = Channel("a", t, statistics={"mean": 0.5})
    >>> statistics_window(t, {"a": known}, 0.125), statistics_window(t, {"a": Channel("a", t)}, 0.125)
    ((0.125, 1.0), (0.13, 1.0))
    """
    begin, end = float(time[0]), float(time[-1])
    if any(channel.statistics is not None for channel in found.values()):
        return min(begin + settle_time, end), end
    inside = time[settled_part(time, settle_time)]
    return float(inside[0]), float(inside[-1])


def uniform(time: Array, values: Array) -> tuple[Array, float]:
    """Values at equal time steps and their sample rate; records of adaptive solvers are interpolated."""
    try:
        return values, sample_rate_of(time)
    except SignalError:
        grid = np.linspace(time[0], time[-1], time.size)
        return np.interp(grid, time, values), (time.size - 1) / float(time[-1] - time[0])


def tenth_speeds(time: Array, angle: Array) -> Array:
    """Mean speeds in the tenths of a record [rad/s], shape (10,)."""
    marks = np.linspace(0, time.size - 1, 11).round().astype(np.int64)
    speeds: Array = np.diff(angle[marks]) / np.diff(time[marks])
    return speeds


def changes_speed(time: Array, angle: Channel | None, window: np.ndarray) -> bool:
    """Whether the mean speeds of the tenths of a run differ by more than `RUN_UP`."""
    if angle is None or time.size < 11:
        return False
    speed = tenth_speeds(time, angle.values[window])
    fastest = float(np.abs(speed).max())
    return fastest > 0.0 and float(np.ptp(speed)) > RUN_UP * fastest


def turns_of(angle: Array) -> float:
    """Total rotation of a shaft [revolutions] from its unwrapped angle [rad].

    Examples
    --------
    >>> turns_of(2.0 * np.pi * np.array([0.5, 1.0, 2.0]))
    1.5
    """
    # tolerance for round-off at the end of a whole turn
    return round(float(abs(angle[-1] - angle[0])) / (2.0 * np.pi), 9)


def turning_angle(run: Any, found: Mapping[str, Channel], body: str = "") -> Channel | None:
    """Reference angle of orders: that given by the run, else that of `body`, else the first rotating one."""
    if run.angle:
        return found.get(run.angle)
    angles = [c for c in found.values() if c.quantity == "angle"]
    turning = [c for c in angles if c.values.size and float(np.ptp(c.values)) > 0.0]
    return next((c for c in turning if owner(c) == body), next(iter(turning or angles), None))


def geared_speeds(
    time: Array, reference: Channel, found: Mapping[str, Channel], window: np.ndarray
) -> dict[str, float]:
    """Mean speeds [rad/s] of the reference shaft and of all shafts with a constant ratio to it."""
    if time.size < 11:
        return {}
    own = tenth_speeds(time, reference.values[window])
    mean = (reference.values[window][-1] - reference.values[window][0]) / (time[-1] - time[0])
    # a shaft that reverses has no orders
    if not np.all(own * mean > 0.0):
        return {}
    speeds = {owner(reference): float(mean)}
    for channel in found.values():
        if channel.quantity != "angle" or channel.name == reference.name:
            continue
        ratio = tenth_speeds(time, channel.values[window]) / own
        if np.abs(ratio).min() > 0.0 and float(np.ptp(ratio)) < GEARED * float(np.abs(ratio.mean())):
            speeds[owner(channel)] = float(mean * ratio.mean())
    return speeds
