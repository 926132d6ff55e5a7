# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings and plain bearings as records."""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.contact.hertz import plane_strain_compliance
from pitchpoint.contact.rolling import (
    LINE,
    POINT,
    Raceways,
    ball_bearing_stiffness,
    flange_stiffness,
    in_series,
    roller_slices,
    roller_stiffness,
)
from pitchpoint.core.errors import CompileError
from pitchpoint.elements import clearance_bearing, rolling_bearing
from pitchpoint.elements.signal import Pool
from pitchpoint.geometry.materials import Material, material
from pitchpoint.model.components.bearing_fault import play
from pitchpoint.model.components.bearing_geometry import BOTH, NEGATIVE
from pitchpoint.model.components.rolling_bearing import RollingBearing
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bearing_fault import put_faults
from pitchpoint.system.rules.places import Array, Places
from pitchpoint.system.rules.rings import mark_rings


def rolling_bearing_bank(places: Places) -> Bank:
    """All rolling bearings; the first end is the inner ring."""
    bearings = places.model.rolling_bearings
    rows = []
    pool = Pool()
    for name, part in bearings.items():
        row = np.zeros(1, rolling_bearing.RECORD)[0]
        inner, outer = mark_rings(places, row, part)
        row["A_i"] = row["A_i"] @ _untwisted(inner, outer)
        found = part.geometry
        row["n"], row["rows"] = found.elements, found.rows
        row["pitch"], row["element"] = found.pitch_diameter, found.element_diameter
        row["angle"], row["grooves"] = found.contact_angle, found.groove_distance
        row["aligns"], row["floats"] = found.aligns, found.floats
        row["gap"] = 0.5 * found.clearance
        row["gap"] += 0.5 * play(part.faults.values())
        row["exponent"] = POINT if found.is_ball else LINE
        row["stiffness"], row["chi"] = _stiffness(name, part), part.damping
        slices = _slices(part)
        if slices is not None:
            row["n_slices"], row["slices"] = len(slices), pool.add(slices)
        row["one_sided"] = found.one_shoulder
        row["offset"] = 0.5 * found.row_distance
        if found.axial_clearance is not None:
            row["flange"] = part.flange_stiffness or _flange_stiffness(part)
            row["flange_low"], row["flange_high"] = _flange_places(found.absorbs, found.axial_clearance)
        row["shift"] = _shift(part, row["stiffness"])
        if part.faults:
            put_faults(row, part, pool)
        rows.append(row)
    return pack("rolling_bearing", rolling_bearing.RECORD, rows, list(bearings), pool=pool.array())


def _slices(part: RollingBearing) -> Array | None:
    """Slices of a roller, as of `roller_slices`; None for balls and rollers of a given stiffness."""
    found = part.geometry
    if found.effective_length is None:
        return None
    cones = found.contact_angle != 0.0 and not found.aligns  # otherwise cylinders or barrels
    return roller_slices(found.effective_length, found.element_diameter, part.slices, tapered=cones)


def _shift(part: RollingBearing, stiffness: float) -> float:
    """Axial displacement of the inner ring to the outer one that preloads a bearing as assembled [m]."""
    found = part.geometry
    side = -1.0 if found.absorbs == NEGATIVE else 1.0
    if part.preload is None:
        return side * (part.preload_distance or 0.0)
    row = Raceways(
        elements=found.elements,
        stiffness=stiffness,
        exponent=POINT if found.is_ball else LINE,
        angle=abs(found.contact_angle),
        gap=0.5 * found.clearance,
        grooves=found.groove_distance,
        slices=_slices(part),
    )
    return side * row.shift_for(part.preload)


def _flange_places(absorbs: str, play: float) -> tuple[float, float]:
    """Axial displacements of the inner ring at which flanges touch [m]."""
    if absorbs == BOTH:
        return -0.5 * play, 0.5 * play
    return (-play, math.inf) if absorbs == NEGATIVE else (-math.inf, play)


def _flange_stiffness(part: RollingBearing) -> float:
    """Estimated stiffness of the flange contact [N/m]."""
    found = part.geometry
    return flange_stiffness(
        found.elements, found.element_diameter, float(found.dynamic or 0.0), _compliance(part)
    )


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
    compliance = _compliance(part)
    found = part.geometry
    if found.effective_length is not None:
        one = roller_stiffness(found.effective_length, compliance)
        return in_series(one, one, LINE)
    if found.grooves is not None:
        return ball_bearing_stiffness(
            found.element_diameter, found.pitch_diameter, found.grooves, found.contact_angle, compliance
        )
    missing = "grooves" if found.is_ball else "effective_length"
    raise CompileError(f"rolling_bearings.{name}: give {missing}, or stiffness")


def _compliance(part: RollingBearing) -> float:
    """Sum of (1 - nu^2)/E of rolling element and ring [1/Pa]."""
    own = part.material if isinstance(part.material, Material) else material(part.material)
    return 2.0 * plane_strain_compliance(own.youngs_modulus, own.poisson_ratio)


def plain_bearing_bank(places: Places) -> Bank:
    """All plain bearings with clearance; the first end is the journal."""
    bearings = places.model.plain_bearings
    rows = []
    for part in bearings.values():
        row = np.zeros(1, clearance_bearing.RECORD)[0]
        mark_rings(places, row, part)
        row["gap"], row["stiffness"] = 0.5 * part.clearance, part.stiffness
        row["exponent"], row["chi"] = part.exponent, part.damping
        rows.append(row)
    return pack("clearance_bearing", clearance_bearing.RECORD, rows, list(bearings))
