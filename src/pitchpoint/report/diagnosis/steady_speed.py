# SPDX-License-Identifier: Apache-2.0
"""Exact speed of a record near a nominal one."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.line_tests import fine_spectrum
from pitchpoint.analysis.mesh_angle import has_clear_mesh
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.speed_search import FoundSpeed, speed_from_lines
from pitchpoint.analysis.tooth_numbers import sideband_teeth
from pitchpoint.analysis.turning_parts import TurningParts
from pitchpoint.report.diagnosis.over_angle import OverAngle
from pitchpoint.report.diagnosis.varying_speed import suggested_range

Array = NDArray[np.float64]


def at_speed(
    signals: Mapping[str, Array],
    sample_rate: float,
    parts: TurningParts,
    frequency: float,
    tolerance: float,
) -> OverAngle:
    """Channels at a steady speed near a nominal one [Hz]; lines of the record give the exact value.

    Raises
    ------
    SignalError
        If the record is shorter than one turn, or its sample rate too low for any line of a shaft.
    """
    length = next(iter(signals.values())).size / sample_rate
    if length * frequency < 1.0:
        raise SignalError(
            f"record: {length:.4g} s are {length * frequency:.2g} turns "
            "of the reference shaft (limit 1); use a longer record"
        )
    if sample_rate < 2.0 * frequency:
        raise SignalError(
            f"sample rate: {sample_rate:.6g} Hz are {sample_rate / frequency:.2g} samples per turn at "
            f"{frequency:.6g} Hz (limit 2); check both, such as --sample-rate {sample_rate:g}kHz"
        )
    spectra = [fine_spectrum(values, sample_rate) for values in signals.values()]
    found = speed_from_lines(spectra, parts, frequency, tolerance)
    per_turn, advice = sample_rate / found.frequency, ""
    clear = bool(found.what) and (not parts.meshes or has_clear_mesh(signals, per_turn, parts))
    if tolerance > 0.0 and not clear:
        advice = suggested_range(signals, sample_rate, parts, frequency, tolerance)
    return OverAngle(
        dict(signals),
        per_turn,
        found.frequency,
        per_turn,
        (*_remarks(found, parts, frequency, tolerance), *_other_teeth(signals, per_turn, parts, found)),
        tolerance=found.tolerance,
        lines=found.what,
        advice=advice,
    )


def _remarks(found: FoundSpeed, parts: TurningParts, frequency: float, tolerance: float) -> list[str]:
    """How the speed is known."""
    if found.what and abs(found.frequency / frequency - 1.0) > 1e-6:
        listed = ", ".join(f"{order * found.frequency:.4g}" for order in found.lines[:4])
        more = ", ..." if len(found.lines) > 4 else ""
        return [
            f"speed from the {found.what} lines at {listed}{more} Hz: {found.frequency:.6g} Hz "
            f"({found.frequency * 60:.6g} rpm) instead of {frequency:.6g} Hz"
        ]
    if found.tolerance == 0.0:
        return []
    lines, omitted = ("mesh or shaft", "shafts and gears") if parts.meshes else ("shaft", "shafts")
    bearings = ", bearings over the whole range" if parts.bearings else ""
    remarks = [
        f"speed: no {lines} lines determine it within ±{100.0 * tolerance:.2g} % of "
        f"{frequency:.6g} Hz; {omitted} are not tested{bearings}"
    ]
    if found.mains:
        listed = ", ".join(f"{line:g} Hz" for line in found.mains)
        remarks.append(
            f"speed: lines at {listed} may be those of the mains and are not evidence for it, since an "
            "induction motor is slower than its field; give the exact speed of a synchronous motor, such as "
            "--speed 1500rpm±0%"
        )
    return remarks


def _other_teeth(
    signals: Mapping[str, Array], per_turn: float, parts: TurningParts, found: FoundSpeed
) -> list[str]:
    """Remarks on tooth numbers that sidebands contradict: the speed from mesh lines depends on them."""
    if found.what != "mesh":
        return []
    return [
        f"tooth numbers: the sidebands of {row.gear} are spaced as those of {row.found} teeth instead of "
        f"{row.given}; check the tooth numbers, on which the speed depends"
        for row in sideband_teeth(signals, per_turn, parts)
        if row.found not in (0, row.given)
    ]
