# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings and plain bearings as records."""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.contact.hertz import plane_strain_compliance
from pitchpoint.contact.rolling import LINE, POINT, ball_bearing_stiffness, in_series, roller_stiffness
from pitchpoint.core.errors import CompileError
from pitchpoint.elements import clearance_bearing, rolling_bearing
from pitchpoint.elements.signal import Pool
from pitchpoint.geometry.materials import Material, material
from pitchpoint.model.components.bearing_fault import play
from pitchpoint.model.components.rolling_bearing import RollingBearing
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bearing_fault import put_faults
from pitchpoint.system.rules.places import Array, Places


def rolling_bearing_bank(places: Places) -> Bank:
    """All rolling bearings; the first end is the inner ring."""
    bearings = places.model.rolling_bearings
    rows = []
    pool = Pool()
    for name, part in bearings.items():
        row = np.zeros(1, rolling_bearing.RECORD)[0]
        places.mark(row, part.ends)
        row["A_i"] = row["A_i"] @ _untwisted(*(places.axes(end) for end in part.ends))
        row["n"], row["pitch"], row["element"] = part.elements, part.pitch_diameter, part.element_diameter
        row["angle"], row["gap"] = part.contact_angle, 0.5 * part.clearance
        row["gap"] += 0.5 * play(part.faults.values())
        row["exponent"] = POINT if part.type == "ball" else LINE
        row["stiffness"], row["chi"] = _stiffness(name, part), part.damping
        if part.grooves is not None:
            row["grooves"] = (sum(part.grooves) - 1.0) * part.element_diameter
        if part.faults:
            put_faults(row, part, pool)
        rows.append(row)
    return pack("rolling_bearing", rolling_bearing.RECORD, rows, list(bearings), pool=pool.array())


def _untwisted(inner: Array, outer: Array) -> Array:
    """Rotation of the inner marker about its axis that removes its assembled twist to the outer marker.

    Whole turns are counted from this position; a twist of half a turn would make the count ambiguous.
    """
    B = outer.T @ inner
    twist = math.atan2(B[1, 0] - B[0, 1], B[0, 0] + B[1, 1])
    c, s = math.cos(twist), math.sin(twist)
    return np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])


def _stiffness(name: str, part: RollingBearing) -> float:
    """Constant K of one rolling element between both raceways."""
    if part.stiffness is not None:
        return part.stiffness
    own = part.material if isinstance(part.material, Material) else material(part.material)
    compliance = 2.0 * plane_strain_compliance(own.youngs_modulus, own.poisson_ratio)
    if part.type == "roller" and part.effective_length is not None:
        one = roller_stiffness(part.effective_length, compliance)
        return in_series(one, one, LINE)
    if part.type == "ball" and part.grooves is not None:
        return ball_bearing_stiffness(
            part.element_diameter, part.pitch_diameter, part.grooves, part.contact_angle, compliance
        )
    missing = "grooves" if part.type == "ball" else "effective_length"
    raise CompileError(f"rolling_bearings.{name}: give {missing}, or stiffness")


def plain_bearing_bank(places: Places) -> Bank:
    """All plain bearings with clearance; the first end is the journal."""
    bearings = places.model.plain_bearings
    rows = []
    for part in bearings.values():
        row = np.zeros(1, clearance_bearing.RECORD)[0]
        places.mark(row, part.ends)
        row["gap"], row["stiffness"] = 0.5 * part.clearance, part.stiffness
        row["exponent"], row["chi"] = part.exponent, part.damping
        rows.append(row)
    return pack("clearance_bearing", clearance_bearing.RECORD, rows, list(bearings))
