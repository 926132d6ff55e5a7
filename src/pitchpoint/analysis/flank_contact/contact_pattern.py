# SPDX-License-Identifier: Apache-2.0
"""Contact pattern and load share of one tooth pair, assembled from all phases of a contact analysis.

At every phase several tooth pairs are in contact, each at another position of its path. The pair n at the
phase p is at p + n base pitches from A: all of them together are the way of one pair.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.flank_contact.load_factors import OVER, pair_shares
from pitchpoint.analysis.flank_contact.teeth import MeshTeeth, mesh_teeth, pair_positions
from pitchpoint.analysis.load_sharing import LoadSharing
from pitchpoint.analysis.sampled import Array

if TYPE_CHECKING:
    import xarray as xr

FIELDS = ("line_load", "pressure", "edge_pressure")
POINTS = 181
"""Lengths of roll of a pattern on a flank."""


@dataclass(frozen=True)
class ContactPattern:
    """Contact of one tooth pair along its way; NaN without contact.

    Attributes
    ----------
    position
        Position in the middle of the face [base pitches from A], shape (n_position,), ascending.
    z
        Middles of the contact planes [m], shape (n_plane,).
    roll
        Lengths of roll on both gears [m], shape (2, n_position, n_plane).
    line_load
        Normal force per length of the contact line [N/m], shape (n_position, n_plane).
    pressure, edge_pressure
        Maximum pressure of the flanks on the line of action, and of tip edges [Pa], shape (n_position,
        n_plane).
    teeth
        Geometry of the mesh.
    """

    position: Array
    z: Array
    roll: Array
    line_load: Array
    pressure: Array
    edge_pressure: Array
    teeth: MeshTeeth


@dataclass(frozen=True)
class FlankField:
    """Values on the flank of one gear over equidistant lengths of roll; NaN without contact.

    Attributes
    ----------
    roll
        Lengths of roll [m], shape (n_roll,), ascending.
    z
        Middles of the contact planes [m], shape (n_plane,).
    values
        Shape (n_roll, n_plane).
    """

    roll: Array
    z: Array
    values: Array


def contact_pattern(data: xr.Dataset, torque: int = 0) -> ContactPattern:
    """Contact pattern of one tooth pair from all mesh phases.

    Parameters
    ----------
    data
        Dataset of a contact analysis.
    torque
        Index of the torque.

    Notes
    -----
    Rows without any contact are included, NaN throughout.
    """
    one = data.isel(torque=torque)
    position = pair_positions(data).ravel()
    order = np.argsort(position, kind="stable")

    def rows(name: str) -> Array:
        """Values of all phases and pairs, shape (n_position, n_plane)."""
        values = np.asarray(one[name].transpose(*OVER[1:]).values, dtype=np.float64)
        return values.reshape(-1, values.shape[-1])[order]

    fields = {name: rows(name) for name in FIELDS}
    teeth = mesh_teeth(data)
    return ContactPattern(
        position=position[order],
        z=teeth.z,
        roll=np.stack([rows("roll_1"), rows("roll_2")]),
        teeth=teeth,
        **fields,
    )


def on_flank(pattern: ContactPattern, name: str, gear: int = 1, points: int = POINTS) -> FlankField:
    """Field of a contact pattern on the flank of one gear.

    Parameters
    ----------
    pattern
        The pattern.
    name
        "line_load", "pressure", "edge_pressure" or "any_pressure" (the larger of both).
    gear
        1 or 2.
    points
        Number of equidistant lengths of roll, from the smallest to the largest in contact, A and E included.

    Notes
    -----
    Each plane is interpolated linearly along the profile. A tip edge is in contact with the mating flank over
    a range of lengths of roll, but at a single one of its own; there the largest value is used.

    Examples
    --------
    >>> from pitchpoint.analysis.flank_contact.teeth import MeshTeeth
    >>> one = np.ones(1)
    >>> marks = np.array([[0.0, 1.0, 1.0, 1.0, 2.0], [2.0, 1.0, 1.0, 1.0, 0.0]])
    >>> teeth = MeshTeeth(np.full(2, 20.0), np.full(2, 10.0 / np.pi), 0.0, marks, 0.0 * one, one, 0.0 * one)
    >>> way = np.array([[0.0], [1.0], [2.0]])
    >>> nothing = np.full((3, 1), np.nan)
    >>> one_pair = ContactPattern(
    ...     way[:, 0], np.zeros(1), np.stack([way, 2.0 - way]), 1e3 * way, nothing, nothing, teeth
    ... )
    >>> field = on_flank(one_pair, "line_load", gear=2, points=5)
    >>> field.roll.tolist(), field.values[:, 0].tolist()
    ([0.0, 0.5, 1.0, 1.5, 2.0], [2000.0, 1500.0, 1000.0, 500.0, 0.0])
    """
    if name == "any_pressure":
        values = np.fmax(pattern.pressure, pattern.edge_pressure)
    else:
        values = np.asarray(getattr(pattern, name))
    roll = pattern.roll[gear - 1]
    ends = pattern.teeth.mark_roll[gear - 1, [0, 4]]
    low, high = np.nanmin([*ends, np.nanmin(roll)]), np.nanmax([*ends, np.nanmax(roll)])
    grid = np.linspace(low, high, points)
    # without contact a plane has the roll of its position on the line of action
    sign = 1.0 if ends[1] > ends[0] else -1.0
    along = pattern.position[:, None] + pattern.teeth.advance[None, :]
    nominal = ends[0] + sign * pattern.teeth.base_pitch * along
    inside = (along >= 0.0) & (along <= pattern.teeth.eps_alpha)
    found = np.full((points, pattern.z.size), np.nan)
    for plane in range(pattern.z.size):
        touching = np.isfinite(values[:, plane])
        kept = touching | (inside[:, plane] & ~np.isfinite(roll[:, plane]))
        if not touching.any():
            continue
        where = np.where(np.isfinite(roll[:, plane]), roll[:, plane], nominal[:, plane])[kept]
        found[:, plane] = _interpolated(grid, where, values[kept, plane])
    return FlankField(roll=grid, z=pattern.z, values=found)


def _interpolated(grid: Array, where: Array, values: Array) -> Array:
    """Values on a grid, NaN beyond the ends and next to NaN; the largest value of equal places."""
    order = np.lexsort((values, where))
    where, values = where[order], values[order]
    last = np.append(np.diff(where) > 0.0, True)
    return np.interp(grid, where[last], values[last], left=np.nan, right=np.nan)


def load_sharing(data: xr.Dataset, torque: int = 0) -> LoadSharing:
    """Load share of one tooth pair over its way, from its position in the middle of the face.

    Parameters
    ----------
    data
        Dataset of a contact analysis.
    torque
        Index of the torque.

    Examples
    --------
    >>> import xarray as xr
    >>> forces = [[[[0.0], [4.0]], [[1.0], [3.0]]]]
    >>> data = xr.Dataset({"plane_force": (OVER, forces)})
    >>> data = data.assign_coords(mesh_phase_position=[0.0, 0.5], tooth_pair=[0, 1], torque=[1.0])
    >>> found = load_sharing(data)
    >>> found.way.tolist(), found.share.tolist()
    ([0.0, 0.5, 1.0, 1.5], [0.0, 0.25, 1.0, 0.75])
    """
    way = pair_positions(data).ravel()
    share = pair_shares(data)[torque].ravel()
    order = np.argsort(way, kind="stable")
    return LoadSharing(way[order], share[order])
