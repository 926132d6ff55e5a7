# SPDX-License-Identifier: Apache-2.0
"""Channels over the angle of a shaft whose speed varies, found in the record itself."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.line_tests import LONG
from pitchpoint.analysis.sampled import SignalError, sample_rate_of
from pitchpoint.analysis.speed_track import SpeedTrack, speed_track
from pitchpoint.analysis.speed_without_gears import OTHER
from pitchpoint.analysis.tooth_numbers import sideband_teeth
from pitchpoint.analysis.turning_parts import TurningParts
from pitchpoint.report.diagnosis.over_angle import FoundSpeed, OverAngle, over_angle

Array = NDArray[np.float64]
OCTAVE = 2.0
"""Range about a nominal speed in which a varying speed is looked for, as a factor."""
SHOWN = 3
"""Maximum number of listed intervals and orders."""


def at_varying_speed(
    signals: Mapping[str, Array],
    time: Array,
    parts: TurningParts,
    limits: tuple[float, float],
    reference: str,
) -> OverAngle:
    """Channels over the angle that the record itself determines, with remarks on how.

    Parameters
    ----------
    signals, time
        Values by channel and their times [s], shape (n,) each.
    parts
        Rotating parts.
    limits
        Lowest and highest rotation frequency of the reference shaft [Hz].
    reference
        Name of the reference shaft.

    Raises
    ------
    SignalError
        If nothing in the record determines the speed.
    """
    rate = sample_rate_of(time)
    track = speed_track(signals, rate, parts, *limits)
    path = track.path
    span = float(path.frequency.min()), float(path.frequency.max())
    over = over_angle(signals, time, track.angle, span)
    remarks = [
        f"speed of {reference} found in the record: {_range(track)} rpm, in frames of "
        f"{1.0 / path.resolution:.3g} s; level of the lines {path.score:.2f}, of the best other path "
        f"{path.rival:.2f} (at {path.rival_ratio:.2f} times the speed), by chance {path.chance:.2f}"
    ]
    tolerance, how = _accuracy(track, reference)
    remarks += [how, *_without_gears(track, limits, reference)]
    if parts.meshes:
        about, doubt, names_gears = _teeth(over, parts, track)
    else:
        about, doubt, names_gears = [], _other_part(track, parts, reference), True
    remarks += _hidden(track) + about
    return replace(
        over,
        doubt=doubt,
        names_gears=names_gears,
        remarks=(*over.remarks, *remarks),
        tolerance=tolerance,
        found=FoundSpeed(track, signals, rate, float(time[0])),
    )


def _accuracy(track: SpeedTrack, reference: str) -> tuple[float, str]:
    """Relative tolerance of the speed [-], and how it is known in words."""
    path = track.path
    if track.orders:
        listed = ", ".join(f"{order:.5g}" for order in track.orders)
        many = len(track.orders) > 1
        return 0.0, (
            f"angle of {reference} by the phases of the {'lines' if many else 'line'} at order"
            f"{'s' * many} {listed}; {'agreement of the lines' if many else 'scatter by noise'} "
            f"{track.agreement:.2g} rad, without phase and delay from mesh to sensor, which all lines contain"
        )
    if track.motor is None:
        tolerance = path.resolution / (2.0 * track.lowest * float(np.mean(path.frequency)))
    else:
        tolerance = track.motor.tolerance
    return tolerance, (
        f"speed: known within ±{100.0 * tolerance:.2g} %, since no line is clear enough for its phase; "
        f"shafts{' and gears' * (track.motor is None)} are not tested"
    )


def _without_gears(track: SpeedTrack, limits: tuple[float, float], reference: str) -> list[str]:
    """What determines the speed of a machine without gears, and what does not."""
    motor = track.motor
    if motor is None:
        return []
    impacts = f"impacts of {motor.impacts}"
    if not motor.orders:
        return [f"speed: by the {impacts} alone, whose slip it contains"]
    listed = ", ".join(f"{order:.5g}" for order in motor.orders)
    found = [f"speed: by the shaft orders {listed}" + f" and {impacts}" * bool(motor.impacts)]
    low, high = (float(value) for value in (track.path.frequency.min(), track.path.frequency.max()))
    if not motor.impacts and low / 2.0 >= limits[0]:
        found.append(
            f"speed: half of it, {30.0 * low:.4g} to {30.0 * high:.4g} rpm, has the same lines if its odd "
            f"orders are not visible; exclude it with a range that begins above {30.0 * low:.4g} rpm"
        )
    return found


def _other_part(track: SpeedTrack, parts: TurningParts, reference: str) -> str:
    """Another part whose impacts would be alike at another speed, if no shaft orders exclude it; or empty."""
    motor = track.motor
    if motor is None or motor.orders:
        return ""
    orders = {
        f"{part} of {bearing.name}": order
        for bearing in parts.bearings
        for part, order in bearing.orders.items()
        if part != "cage"
    }
    own = orders[motor.impacts]
    others = {name: own / order for name, order in orders.items() if abs(own / order - 1.0) > OTHER}
    why = f"no orders of {reference} are visible, only the given range determines the speed"
    if not others:
        return why
    name = min(others, key=lambda one: abs(np.log(others[one])))
    low, high = (others[name] * float(x) for x in (track.path.frequency.min(), track.path.frequency.max()))
    return f"{why}; from {60.0 * low:.4g} to {60.0 * high:.4g} rpm it would be the {name}"


def suggested_range(
    signals: Mapping[str, Array], sample_rate: float, parts: TurningParts, frequency: float, tolerance: float
) -> str:
    """Remark on a speed that varies by more than the tolerance of a nominal one [Hz]; empty if it does not.

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> t = np.arange(60_000) / 6000.0
    >>> x = np.cos(2 * np.pi * 20 * (10 * t + 0.5 * t**2))
    >>> x += np.random.default_rng(1).standard_normal(t.size)
    >>> suggested_range({"acc": x}, 6000.0, train_parts([(20, 31)]), 15.0, 0.02).partition("give ")[2]
    'the range, --speed 580..1300rpm'
    """
    # of a long record the beginning, to limit memory
    begun = {name: values[:LONG] for name, values in signals.items()}
    try:
        track = speed_track(begun, sample_rate, parts, frequency / OCTAVE, frequency * OCTAVE)
    except SignalError:
        return ""
    low, high = float(track.path.frequency.min()), float(track.path.frequency.max())
    clear = len(track.motor.orders) > 1 if track.motor else bool(track.orders)
    if not clear or high - low < 4.0 * tolerance * frequency:
        return ""
    near = [float(f"{60.0 * value:.2g}") for value in (0.95 * low, 1.05 * high)]
    return (
        f"the speed varies from {_range(track)} rpm, by more than its tolerance; give the range, "
        f"--speed {near[0]:g}..{near[1]:g}rpm"
    )


def _range(track: SpeedTrack) -> str:
    """Lowest and highest speed [rpm] in words."""
    low, high = (60.0 * float(value) for value in (track.path.frequency.min(), track.path.frequency.max()))
    return f"{low:.4g} to {high:.4g}"


def _hidden(track: SpeedTrack) -> list[str]:
    """Remark on the times between which no line is visible."""
    if not track.hidden.size:
        return []
    listed = ", ".join(f"{a:.3g} to {b:.3g} s" for a, b in track.hidden[:SHOWN])
    more = f" and {len(track.hidden) - SHOWN} more" if len(track.hidden) > SHOWN else ""
    return [
        f"speed: lines are hardly above chance from {listed}{more}; the speed there is uncertain, and so "
        "is the number of revolutions"
    ]


def _teeth(over: OverAngle, parts: TurningParts, track: SpeedTrack) -> tuple[list[str], str, bool]:
    """Remarks on meshes without a line, and on tooth numbers, on which the speed depends.

    Returns
    -------
    tuple
        Remarks, doubt about tooth numbers in words, and whether gears may be named in spite of it.
    """
    found = []
    seen = {
        mesh.name
        for mesh in parts.meshes
        for order in track.orders
        if _is_harmonic(order, parts.mesh_order(mesh))
    }
    unseen = [mesh.name for mesh in parts.meshes if mesh.name not in seen]
    if seen and unseen:
        found.append(f"speed: no line of {', '.join(unseen)} confirms it; check the tooth numbers")
    rows = sideband_teeth(over.signals, over.samples_per_turn, parts)
    wrong = [row for row in rows if row.found not in (0, row.given)]
    found += [
        f"tooth numbers: the sidebands of {row.gear} are spaced as those of {row.found} teeth instead of "
        f"{row.given}; check the tooth numbers, on which the speed depends"
        for row in wrong
    ]
    depends = "the tooth numbers, on which the speed depends"
    if wrong:
        return found, f"{depends}, are contradicted by sidebands; no gear is named", False
    if seen and unseen:
        return found, f"{depends}, are not confirmed by {', '.join(unseen)}; no gear is named", False
    if any(row.found for row in rows):
        return found, "", True
    why = "tooth numbers: not confirmed by sidebands; with wrong ones the speed is wrong in proportion"
    return [*found, why], f"{depends}, are not confirmed by sidebands", True


def _is_harmonic(order: float, mesh: float) -> bool:
    """Whether an order is a harmonic of a mesh order."""
    return math.isclose(order / mesh, round(order / mesh), rel_tol=1e-9) and round(order / mesh) > 0
