# SPDX-License-Identifier: Apache-2.0
"""Faults of rolling bearings as rows of the bearing element."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pitchpoint.contact.spall import spall_drop
from pitchpoint.elements.bearing_fault import ELEMENT, INNER, OUTER
from pitchpoint.elements.signal import Pool
from pitchpoint.model.checks.bearing_faults import element_angles, track_radius
from pitchpoint.model.components.bearing_fault import CageFault, ElementFault, LooseBearing, SpallFault
from pitchpoint.model.components.rolling_bearing import RollingBearing


def put_faults(row: Any, part: RollingBearing, pool: Pool) -> None:
    """Set the fault fields of a bearing record; the record of a healthy bearing is unchanged."""
    spalls = [fault for fault in part.faults.values() if not isinstance(fault, CageFault | LooseBearing)]
    rows = [one for fault in spalls for one in _spall(part, fault)]
    if rows:
        row["faults"] = pool.add(rows)
        # rows of zero severity are stored but not read: no extra computing time
        row["n_faults"] = len(rows) if any(drop > 0.0 for *_, drop in rows) else 0
    if any(isinstance(fault, CageFault) for fault in part.faults.values()):
        even = 2.0 * math.pi / part.geometry.elements * np.arange(part.geometry.elements)
        row["uneven"], row["spacing"] = 1, pool.add(element_angles(part) - even)


def _spall(part: RollingBearing, fault: SpallFault) -> list[tuple[float, ...]]:
    """Rows of `elements.bearing_fault` for a spall: one on a race, two (both races) on a rolling element."""
    if not isinstance(fault, ElementFault):
        inner = fault.form == "inner_race"
        return [_row(part, fault, INNER if inner else OUTER, inner, fault.angle)]
    return [
        _row(part, fault, ELEMENT, False, -fault.angle),
        _row(part, fault, ELEMENT, True, math.pi - fault.angle),
    ]


def _row(part: RollingBearing, fault: SpallFault, place: float, inner: bool, angle: float) -> Any:
    track = track_radius(part, inner)
    bent = track / math.cos(part.geometry.contact_angle) * (1.0 if inner else -1.0)
    own = 0.5 * part.geometry.element_diameter
    length = fault.severity * fault.length
    drop, ramp = spall_drop(length, fault.severity * fault.depth, own, bent)
    radius = own if isinstance(fault, ElementFault) else track
    number = fault.element if isinstance(fault, ElementFault) else -1
    return place, number, angle, 0.5 * length / radius, ramp / radius, drop
