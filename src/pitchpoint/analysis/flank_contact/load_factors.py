# SPDX-License-Identifier: Apache-2.0
"""Load distribution of a contact analysis: over the face width, over the tooth pairs, and its maxima.

A contact calculation contains the effects of face load factor, transverse load factor and contact ratio at
the same time. Each function here separates one of them; its definition is given.

Source: face load factor to ISO 6336-1:2019, Annex E.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.analysis.flank_contact.teeth import MeshTeeth

OVER = ("torque", "mesh_phase_position", "tooth_pair", "plane")


def plane_forces(data: xr.Dataset) -> Array:
    """Forces of the contact planes [N], shape (n_torque, n_phase, n_pair, n_plane); 0 without contact.

    Parameters
    ----------
    data
        Dataset of a contact analysis.

    Examples
    --------
    >>> import xarray as xr
    >>> float(plane_forces(xr.Dataset({"plane_force": (OVER, [[[[float("nan"), 2.0]]]])})).sum())
    2.0
    """
    return np.nan_to_num(np.asarray(data["plane_force"].transpose(*OVER).values, dtype=np.float64), nan=0.0)


def load_over_width(data: xr.Dataset) -> Array:
    """Line load over the face width, integrated over the profile [N/m], shape (n_torque, n_plane).

    Parameters
    ----------
    data
        Dataset of a contact analysis.

    Notes
    -----
    Sum over all tooth pairs of the force along the base tangent per width of the plane, and its mean over the
    mesh phases. Its mean over the planes is F_bt/b.

    Examples
    --------
    >>> import xarray as xr
    >>> data = xr.Dataset({"plane_force": (OVER, [[[[30.0, 10.0]], [[10.0, 10.0]]]])})
    >>> data["plane_width"] = "plane", [0.01, 0.01]
    >>> load_over_width(data).tolist()
    [[2000.0, 1000.0]]
    """
    width = np.asarray(data["plane_width"].values, dtype=np.float64)
    return np.asarray(plane_forces(data).sum(axis=2).mean(axis=1) / width)


def face_load_factor(line_load: ArrayLike) -> Array:
    """Face load factor K_Hβ of line loads over the face width [-], shape (...).

    Parameters
    ----------
    line_load
        Line load in equally wide planes over the face width, shape (..., n_plane), any unit.

    Notes
    -----
    Maximum over mean (ISO 6336-1:2019, Annex E). Planes have the load at their middles; the load at both end
    faces is extrapolated linearly from the two outermost planes, so that the error decreases with the square
    of the number of planes. A load that vanishes towards an end face is not extrapolated below zero.

    Examples
    --------
    A linear gap of 50 µm with 16.7 N/(mm µm) under 1319.34 N/mm, 1 + c f/(2 w):

    >>> z = (np.arange(11) + 0.5) / 11 - 0.5
    >>> round(float(face_load_factor(1319.34 + 16.70 * 50.0 * z)), 5)
    1.31645
    """
    w = np.asarray(line_load, dtype=np.float64)
    most = w.max(axis=-1)
    if w.shape[-1] > 1:
        most = np.maximum(most, 1.5 * w[..., 0] - 0.5 * w[..., 1])
        most = np.maximum(most, 1.5 * w[..., -1] - 0.5 * w[..., -2])
    return np.asarray(most / w.mean(axis=-1))


def nominal_share(teeth: MeshTeeth, position: ArrayLike) -> Array:
    """Share of the face width over which a tooth pair is in contact without load [-], shape of `position`.

    Parameters
    ----------
    teeth
        Geometry of the mesh.
    position
        Position in the middle of the face [base pitches from A], any shape.

    Examples
    --------
    >>> from pitchpoint.analysis.flank_contact.teeth import MeshTeeth
    >>> roll = np.array([[0.0, 0.6, 1.0, 1.0, 1.6]] * 2) * 0.1 * np.pi
    >>> ahead, one = np.array([-0.2, 0.2]), np.ones(2)
    >>> teeth = MeshTeeth(20.0 * one, one, 0.1, roll, ahead, one, ahead)
    >>> nominal_share(teeth, [-0.4, 0.0, 1.0, 2.0]).round(9).tolist()
    [0.0, 0.5, 1.0, 0.0]
    """
    place = np.asarray(position, dtype=np.float64)
    half = 0.5 * teeth.eps_beta
    middle = 0.5 * float(teeth.advance.min() + teeth.advance.max())
    if half == 0.0:
        return np.asarray((place >= 0.0) & (place <= teeth.eps_alpha), dtype=np.float64)
    low = np.maximum(middle - half, -place)
    high = np.minimum(middle + half, teeth.eps_alpha - place)
    return np.asarray(np.maximum(high - low, 0.0) / (2.0 * half))


def pair_shares(data: xr.Dataset) -> Array:
    """Load share of each tooth pair [-], shape (n_torque, n_phase, n_pair); 0 at phases without load.

    Parameters
    ----------
    data
        Dataset of a contact analysis.

    Examples
    --------
    >>> import xarray as xr
    >>> forces = [[[[1.0, 2.0], [0.0, 1.0]], [[0.0, 0.0], [0.0, 0.0]]]]
    >>> pair_shares(xr.Dataset({"plane_force": (OVER, forces)})).tolist()
    [[[0.75, 0.25], [0.0, 0.0]]]
    """
    forces = plane_forces(data).sum(axis=3)
    total = forces.sum(axis=2, keepdims=True)
    return np.divide(forces, total, out=np.zeros_like(forces), where=total > 0.0)


def transverse_load_factor(share: ArrayLike, phase: ArrayLike, teeth: MeshTeeth) -> Array:
    """Transverse load factor K_Hα [-], shape (n_torque,); NaN without nominal contact.

    Parameters
    ----------
    share
        Load share of each tooth pair [-], shape (n_torque, n_phase, n_pair).
    phase
        Mesh phases [base pitches], shape (n_phase,).
    teeth
        Geometry of the mesh.

    Notes
    -----
    Maximum load of one tooth pair over the mesh cycle, relative to that of a pair of rigid, perfect gears
    with a constant load along all contact lines between A and E. For spur gears with 1 < ε_α < 2 the latter
    is the whole load in the range of single contact, and K_Hα is 1. The reference of ISO 6336-1:2019, clause
    8, are gears without deviations, too.

    Examples
    --------
    One of two pairs has 60 % of the load; ε_α = 2:

    >>> from pitchpoint.analysis.flank_contact.teeth import MeshTeeth
    >>> one, pitch = np.ones(1), 0.1 * np.pi
    >>> roll = np.array([[0.0, 1.0, 1.0, 1.0, 2.0]] * 2) * pitch
    >>> teeth = MeshTeeth(np.full(2, 20.0), np.full(2, 1.0), 0.0, roll, 0.0 * one, one, 0.0 * one)
    >>> transverse_load_factor([[[0.6, 0.4]] * 2], [0.25, 0.75], teeth).round(9).tolist()
    [1.2]
    """
    actual = np.asarray(share, dtype=np.float64).max(axis=(1, 2))
    reach = int(np.ceil(teeth.eps_alpha + float(np.abs(teeth.advance).max()) + 0.5 * teeth.eps_beta)) + 1
    places = np.asarray(phase, dtype=np.float64)[:, None] + np.arange(-reach, reach + 1)
    nominal = nominal_share(teeth, places)
    nominal = nominal[nominal.sum(axis=1) > 0.0]
    if not nominal.size:
        return np.full(actual.shape, np.nan)
    return np.asarray(actual / float((nominal / nominal.sum(axis=1, keepdims=True)).max()))


def line_loads(data: xr.Dataset) -> tuple[Array, Array]:
    """Maximum and mean line load along the contact lines [N/m], each of shape (n_torque,).

    Parameters
    ----------
    data
        Dataset of a contact analysis.

    Notes
    -----
    Normal force per length of the contact line. The maximum is that of all planes, tooth pairs and phases;
    the mean is the sum of all normal forces over the sum of all lengths in contact during the mesh cycle.
    Their ratio contains face and transverse load factor, contact ratio and end effects together.

    Examples
    --------
    >>> import xarray as xr
    >>> most, mean = line_loads(xr.Dataset({"line_load": (OVER, [[[[4.0, 2.0], [float("nan"), 3.0]]]])}))
    >>> most.tolist(), mean.tolist()
    ([4.0], [3.0])
    """
    loads = np.asarray(data["line_load"].transpose(*OVER).values, dtype=np.float64)
    flat = loads.reshape(loads.shape[0], -1)
    known = np.isfinite(flat)
    count = np.maximum(known.sum(axis=1), 1)
    return np.where(known, flat, 0.0).max(axis=1), np.where(known, flat, 0.0).sum(axis=1) / count


def loaded_pairs(data: xr.Dataset) -> Array:
    """Mean number of tooth pairs under load over the mesh cycle [-], shape (n_torque,).

    Parameters
    ----------
    data
        Dataset of a contact analysis.

    Notes
    -----
    The total contact ratio under load: larger than ε_γ by contacts before A and after E, smaller with relief.

    Examples
    --------
    >>> import xarray as xr
    >>> loaded_pairs(xr.Dataset({"plane_force": (OVER, [[[[1.0], [2.0]], [[0.0], [3.0]]]])})).tolist()
    [1.5]
    """
    return np.asarray((plane_forces(data).sum(axis=3) > 0.0).sum(axis=2).mean(axis=1))
