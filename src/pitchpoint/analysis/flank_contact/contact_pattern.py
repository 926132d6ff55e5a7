# SPDX-License-Identifier: Apache-2.0
"""Contact pattern and load share of one tooth pair, assembled from all phases of a contact analysis.

At every phase several tooth pairs are in contact, each at another position of its path. The pair n at the
phase p is at p + n base pitches from A: all of them together are the way of one pair.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.flank_contact.load_factors import OVER, pair_shares
from pitchpoint.analysis.flank_contact.teeth import MeshTeeth, mesh_teeth, pair_positions
from pitchpoint.analysis.load_sharing import LoadSharing
from pitchpoint.analysis.sampled import Array

if TYPE_CHECKING:
    import xarray as xr

FIELDS = ("line_load", "pressure", "edge_pressure")
OTHERS = ("film_thickness", "flash_temperature", "sliding_speed", "rolling_speed")
"""Fields of a contact analysis with operating conditions."""
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
    others
        Further fields by name, in SI units, shape (n_position, n_plane).
    """

    position: Array
    z: Array
    roll: Array
    line_load: Array
    pressure: Array
    edge_pressure: Array
    teeth: MeshTeeth
    others: Mapping[str, Array] = field(default_factory=dict)


@dataclass(frozen=True)
class ContactField:
    """Values over the profile and the face width; NaN without contact.

    Attributes
    ----------
    place
        Equidistant places, shape (n_place,), ascending: lengths of roll [m], or positions on the path of
        contact [base pitches from A].
    z
        Middles of the contact planes [m], shape (n_plane,).
    values
        Shape (n_place, n_plane), in the unit of the field.
    """

    place: Array
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
        others={name: rows(name) for name in OTHERS if name in data},
        **fields,
    )


def on_path(pattern: ContactPattern, name: str, points: int = POINTS) -> ContactField:
    """Field of a contact pattern over the path of contact, contacts before A and beyond E included.

    Parameters
    ----------
    pattern
        The pattern.
    name
        "line_load", "pressure", "edge_pressure", "any_pressure" (the larger of both) or one of `others`.
    points
        Number of equidistant positions from the first to the last contact, A and E included.

    Notes
    -----
    Each plane has its own position on the path: that of the tooth pair in the middle of the face and the
    advance of the plane. Before A the tip edge of gear 2 is in contact, beyond E that of gear 1.

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
    >>> field = on_path(one_pair, "line_load", points=5)
    >>> field.place.tolist(), field.values[:, 0].tolist()
    ([0.0, 0.5, 1.0, 1.5, 2.0], [0.0, 500.0, 1000.0, 1500.0, 2000.0])
    """
    values, along = _values(pattern, name), _along(pattern)
    touching = along[np.isfinite(values)]
    low, high = min(0.0, touching.min(initial=0.0)), max(pattern.teeth.eps_alpha, touching.max(initial=0.0))
    grid = np.linspace(low, high, points)
    found = [_interpolated(grid, along[:, k], values[:, k], _step(pattern)) for k in range(pattern.z.size)]
    return ContactField(place=grid, z=pattern.z, values=np.stack(found, axis=1))


def on_flank(pattern: ContactPattern, name: str, gear: int = 1, points: int = POINTS) -> ContactField:
    """Field of a contact pattern on the flank of one gear: largest value at each place during contact.

    Parameters
    ----------
    pattern
        The pattern.
    name
        "line_load", "pressure", "edge_pressure", "any_pressure" (the larger of both) or one of `others`.
    gear
        1 or 2.
    points
        Number of equidistant lengths of roll from the smallest to the largest in contact, A and E included.

    Notes
    -----
    A tip edge before A or beyond E slides over places of the mating flank that are in contact a second time
    on the line of action. On its own gear it is in contact at a single length of roll.

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
    >>> field.place.tolist(), field.values[:, 0].tolist()
    ([0.0, 0.5, 1.0, 1.5, 2.0], [2000.0, 1500.0, 1000.0, 500.0, 0.0])
    """
    values, along, teeth = _values(pattern, name), _along(pattern), pattern.teeth
    ends = teeth.mark_roll[gear - 1, [0, 4]]
    roll = pattern.roll[gear - 1]
    rolls = np.append(roll[np.isfinite(values)], ends)
    grid = np.linspace(rolls.min(), rolls.max(), points)
    # without contact a plane has the roll of its position on the line of action
    sign = 1.0 if ends[1] > ends[0] else -1.0
    roll = np.where(np.isfinite(roll), roll, ends[0] + sign * teeth.base_pitch * along)
    before, beyond = along < 0.0, along > teeth.eps_alpha
    inside = ~(before | beyond)
    # tip edges begin where the contact on the line of action ends
    before[1:] |= before[:-1] & inside[1:]
    beyond[:-1] |= beyond[1:] & inside[:-1]
    step = _step(pattern) * teeth.base_pitch
    found = np.full((points, pattern.z.size), np.nan)
    for plane in range(pattern.z.size):
        for part in (before[:, plane], inside[:, plane], beyond[:, plane]):
            one = _interpolated(grid, roll[part, plane], values[part, plane], step)
            found[:, plane] = np.fmax(found[:, plane], one)
    return ContactField(place=grid, z=pattern.z, values=found)


def _values(pattern: ContactPattern, name: str) -> Array:
    if name == "any_pressure":
        return np.fmax(pattern.pressure, pattern.edge_pressure)
    if name in pattern.others:
        return pattern.others[name]
    return np.asarray(getattr(pattern, name))


def _along(pattern: ContactPattern) -> Array:
    """Position of each plane on the path of contact [base pitches from A], shape (n_position, n_plane)."""
    return pattern.position[:, None] + pattern.teeth.advance[None, :]


def _step(pattern: ContactPattern) -> float:
    """Distance of two positions [base pitches]."""
    return float(np.diff(pattern.position).max(initial=0.0))


def _interpolated(grid: Array, where: Array, values: Array, step: float) -> Array:
    """Values on a grid, NaN next to NaN and more than a step beyond the ends; the largest at equal places."""
    known = np.flatnonzero(np.isfinite(values))
    if not known.size:
        return np.full(grid.shape, np.nan)
    order = np.lexsort((np.nan_to_num(values, nan=-np.inf), where))
    where, values = where[order], values[order]
    last = np.append(np.diff(where) > 0.0, True)
    where, values = where[last], values[last]
    known = np.flatnonzero(np.isfinite(values))
    low, high = where[known[0]], where[known[-1]]
    inner = slice(int(known[0]), int(known[-1]) + 1)
    found = np.interp(grid, where[inner], values[inner])
    # a single length of roll is that of the nearest place
    reach = step if high > low else 0.5 * float(np.ptp(grid[:2]))
    return np.where((grid >= low - reach) & (grid <= high + reach), found, np.nan)


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
