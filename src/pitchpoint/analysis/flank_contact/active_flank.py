# SPDX-License-Identifier: Apache-2.0
"""Part of the flanks of both gears that is in contact under load, tip edges included."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.flank_contact.teeth import diameter_at, mesh_teeth, pair_positions
from pitchpoint.analysis.sampled import Array

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class ActiveFlank:
    """Ends of the flank in contact of one gear, towards root and tip, each of shape (2,).

    Attributes
    ----------
    diameter, roll_angle
        Under load [m, rad]. For contact inside the base circle the angle is negative, and the diameter that
        of the base circle.
    geometric_diameter, geometric_roll_angle
        From the path of contact A to E of undeformed gears: d_Nf and d_Na [m, rad].
    """

    diameter: Array
    roll_angle: Array
    geometric_diameter: Array
    geometric_roll_angle: Array


def active_flanks(data: xr.Dataset, torque: int = -1) -> tuple[ActiveFlank, ActiveFlank] | None:
    """Flanks of both gears in contact at one torque, over all mesh phases and planes; None without contact.

    Parameters
    ----------
    data
        Dataset of a contact analysis.
    torque
        Index of the torque.

    Notes
    -----
    d = 2 sqrt(r_b² + ρ²) with the length of roll ρ ≥ 0 (ISO 21771). A tip edge that touches before A or
    beyond E is farther from the axis of its mate than at A or E, so that it does not lengthen the flank in
    contact towards the root.

    Examples
    --------
    >>> import xarray as xr
    >>> data = xr.Dataset(coords={"torque": [100.0], "plane": [0.0]})
    >>> data["number_of_teeth"], data["base_radius"] = ("gear", [16.0, 24.0]), ("gear", [0.03, 0.05])
    >>> data["base_helix_angle"] = "gear", [0.0, 0.0]
    >>> data["mark_roll"] = ("gear", "mark"), [[0.01, 0.01, 0.02, 0.03, 0.04], [0.12, 0.1, 0.1, 0.1, 0.05]]
    >>> data["plane_width"], data["plane_advance"] = ("plane", [0.01]), ("plane", [0.0])
    >>> data["line_load"] = ("torque", "phase", "plane"), [[[1.0], [1.0], [float("nan")]]]
    >>> for k, rolls in ((1, [0.012, 0.04, 0.0]), (2, [0.12, 0.05, 0.0])):
    ...     data[f"roll_{k}"] = ("torque", "phase", "plane"), [[[r] for r in rolls]]
    >>> one, two = active_flanks(data)
    >>> [round(1e3 * float(d), 3) for d in (*one.diameter, *one.geometric_diameter)]
    [64.622, 100.0, 63.246, 100.0]
    """
    teeth = mesh_teeth(data)
    load = np.asarray(data["line_load"].isel(torque=torque).values, dtype=np.float64)
    touching = np.nan_to_num(load) > 0.0
    if not touching.any():
        return None
    found = []
    for gear in (0, 1):
        rolls = np.asarray(data[f"roll_{gear + 1}"].isel(torque=torque).values, dtype=np.float64)[touching]
        ends = np.array([rolls.min(), rolls.max()])
        if _is_internal(teeth.mark_roll):
            ends = ends if gear == 0 else ends[::-1]
        marks = np.sort(teeth.mark_roll[gear, [0, 4]])
        if gear == 1 and _is_internal(teeth.mark_roll):
            marks = marks[::-1]
        r_b = float(teeth.base_radius[gear])
        found.append(ActiveFlank(diameter_at(ends, r_b), ends / r_b, diameter_at(marks, r_b), marks / r_b))
    return found[0], found[1]


def contact_path(data: xr.Dataset, torque: int = -1) -> tuple[float, float] | None:
    """First and last contact on the path at one torque [base pitches from A]; None without contact.

    Parameters
    ----------
    data
        Dataset of a contact analysis.
    torque
        Index of the torque.

    Notes
    -----
    Negative, or beyond the transverse contact ratio: contact of tip edges before A and beyond E.

    Examples
    --------
    >>> import xarray as xr
    >>> data = xr.Dataset(coords={"torque": [1.0], "mesh_phase_position": [0.0, 0.5], "tooth_pair": [-1, 0]})
    >>> data["plane_advance"] = "plane", [0.0]
    >>> size = "torque", "mesh_phase_position", "tooth_pair", "plane"
    >>> data["line_load"] = size, [[[[float("nan")], [3.0]], [[2.0], [1.0]]]]
    >>> contact_path(data)
    (-0.5, 0.5)
    """
    load = (
        data["line_load"].isel(torque=torque).transpose("mesh_phase_position", "tooth_pair", "plane").values
    )
    advance = np.asarray(data["plane_advance"].values, dtype=np.float64)
    place = pair_positions(data)[:, :, None] + advance
    held = place[np.nan_to_num(np.asarray(load, dtype=np.float64)) > 0.0]
    return (float(held.min()), float(held.max())) if held.size else None


def _is_internal(mark_roll: Array) -> bool:
    """Whether gear 2 is internal: its length of roll increases together with that of gear 1."""
    return bool((mark_roll[0, 4] - mark_roll[0, 0]) * (mark_roll[1, 4] - mark_roll[1, 0]) > 0.0)
