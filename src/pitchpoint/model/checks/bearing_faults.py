# SPDX-License-Identifier: Apache-2.0
"""Checks of bearing faults, and the geometry of races and elements of rolling bearings."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.components.bearing_fault import CageFault, ElementFault, LooseBearing
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.bearing import Bearing
    from pitchpoint.model.components.bearing_fault import SpallFault
    from pitchpoint.model.components.rolling_bearing import RollingBearing


def track_radius(part: RollingBearing, inner: bool) -> float:
    """Radius of the contact circle of the elements on a race [m]."""
    reach = 0.5 * part.geometry.element_diameter * math.cos(part.geometry.contact_angle)
    return 0.5 * part.geometry.pitch_diameter + (-reach if inner else reach)


def element_angles(part: RollingBearing, severity: float | None = None) -> NDArray[np.float64]:
    """Azimuth of every element relative to the cage [rad], shape (elements,); the mean is that of even
    spacing.

    `severity` replaces the severity of every fault.
    """
    n = part.geometry.elements
    found: NDArray[np.float64] = 2.0 * math.pi / n * np.arange(n, dtype=np.float64)
    for fault in part.faults.values():
        if isinstance(fault, CageFault):
            share = fault.severity if severity is None else severity
            behind = (np.arange(n) - fault.element - 1) % n
            found += share * fault.widening * (0.5 - behind / (n - 1.0))
    return found


def check_bearing_faults(name: str, bearing: RollingBearing, report: Reader) -> None:
    """Check element numbers, spall sizes and element spacing of bearing faults."""
    numbered = True
    for label, fault in bearing.faults.items():
        at: Place = ("rolling_bearings", name, "faults", label)
        if isinstance(fault, ElementFault | CageFault) and fault.element >= bearing.geometry.elements:
            numbered = False
            report.problem(
                (*at, "element"),
                f"does not exist in a bearing of {bearing.geometry.elements} elements",
                value=str(fault.element),
                limit=f"0 to {bearing.geometry.elements - 1}",
                remedy="elements are numbered from 0",
            )
        if not isinstance(fault, CageFault | LooseBearing):
            _spall(bearing, fault, at, report)
    cages = [label for label, fault in bearing.faults.items() if isinstance(fault, CageFault)]
    if cages and numbered:
        _room(bearing, ("rolling_bearings", name, "faults", cages[-1], "widening"), report)


def check_seat(name: str, bearing: Bearing, report: Reader) -> None:
    """Check that a loose bearing has no torsional stiffness and is radially isotropic and decoupled."""
    at: Place = ("bearings", name)
    if not bearing.faults or at in report.tainted:
        return
    label = next(iter(bearing.faults))
    if bearing.stiffness.matrix6()[5][5] != 0.0:
        report.problem(
            (*at, "faults", label),
            f"lets the ring rotate in its seat, but the bearing constrains the spin of {bearing.body}",
            limit="torsion: 0",
            remedy="remove torsion",
        )
    matrices = {"stiffness": bearing.stiffness.matrix6()}
    if bearing.damping is not None:
        matrices["damping"] = bearing.damping.matrix6()
    for key, matrix in matrices.items():
        crossed = any(matrix[i][j] != 0.0 for i in (0, 1) for j in range(6) if i != j)
        if matrix[0][0] != matrix[1][1] or crossed:
            report.problem(
                (*at, key),
                "is not radially isotropic and decoupled from the other directions, as a loose bearing "
                "requires",
                remedy="give radial, axial and tilt",
            )


def _spall(bearing: RollingBearing, fault: SpallFault, at: Place, report: Reader) -> None:
    own = 0.5 * bearing.geometry.element_diameter
    of_element = isinstance(fault, ElementFault)
    track = own if of_element else track_radius(bearing, fault.form == "inner_race")
    most = {"length": min(2.0 * own, math.pi * track), "depth": own}
    for key, limit in most.items():
        if getattr(fault, key) >= limit:
            report.problem(
                (*at, key),
                f"is more than a rolling element of {2e3 * own:.6g} mm can roll over",
                value=f"{getattr(fault, key) * 1e3:.6g} mm",
                limit=f"< {limit * 1e3:.6g} mm",
                remedy="give it with a unit, such as 2 mm or 50 um",
            )


def _room(bearing: RollingBearing, at: Place, report: Reader) -> None:
    """Check that the elements of a worn cage do not overlap."""
    angles = element_angles(bearing, 1.0)
    gaps = np.diff(np.append(angles, angles[0] + 2.0 * math.pi))
    ratio = bearing.geometry.element_diameter / bearing.geometry.pitch_diameter
    if ratio >= 1.0 or 2.0 * math.pi / bearing.geometry.elements < 2.0 * math.asin(ratio):
        return  # reported elsewhere, or elements without spacing
    least = 2.0 * math.asin(ratio)
    if gaps.min() < least:
        most = (2.0 * math.pi / bearing.geometry.elements - least) * (bearing.geometry.elements - 1)
        report.problem(
            at,
            "makes the other elements overlap",
            limit=f"<= {math.degrees(most):.6g} deg for all wider gaps together",
            remedy="reduce it",
        )
