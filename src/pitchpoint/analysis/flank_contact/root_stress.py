# SPDX-License-Identifier: Apache-2.0
"""Root stress of a contact analysis: maxima over mesh cycle and face width, course of one tooth."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.flank_contact.load_factors import OVER
from pitchpoint.analysis.flank_contact.teeth import pair_positions
from pitchpoint.analysis.sampled import Array

if TYPE_CHECKING:
    import xarray as xr

METHODS = ("root_stress", "root_stress_fe")
"""Variables with root stress: at the 30° tangent, by finite elements."""


def root_stress_numbers(data: xr.Dataset) -> dict[str, Array]:
    """Largest root stress over mesh cycle and face width by name, shape (n_torque,) each in SI units.

    Parameters
    ----------
    data
        Dataset of a contact analysis.

    Returns
    -------
    dict
        `root_stress_1`, `root_stress_2` [Pa] of both gears at the 30° tangent and `root_position_1`,
        `root_position_2` [m], the middle of the contact plane. With finite elements the same as
        `root_stress_fe_1` ... `root_position_fe_2`, and `root_stress_fe_min_1`, `root_stress_fe_min_2`: the
        minimum over the mesh cycle at the point of the maximum. NaN without a value; empty for data without
        root stress.

    Examples
    --------
    >>> import xarray as xr
    >>> stress = np.array([[1.0, 3.0], [np.nan, np.nan]])[None, None, None]
    >>> data = xr.Dataset({"root_stress": ((*OVER, "gear"), stress.swapaxes(3, 4))})
    >>> data = data.assign_coords(plane=[-0.01, 0.01])
    >>> {name: values.tolist() for name, values in root_stress_numbers(data).items()}
    {'root_stress_1': [3.0], 'root_position_1': [0.01], 'root_stress_2': [nan], 'root_position_2': [nan]}
    """
    found: dict[str, Array] = {}
    z = np.asarray(data["plane"].values, dtype=np.float64)
    for name in METHODS:
        if name not in data:
            continue
        by_plane = root_stress_over_width(data, name)
        end = name.removeprefix("root_stress")
        for k in (0, 1):
            values = by_plane[:, k]
            known = np.where(np.isfinite(values), values, -np.inf)
            most = known.max(axis=1, initial=-np.inf)
            none = ~np.isfinite(most)
            found[f"root_stress{end}_{k + 1}"] = np.where(none, np.nan, most)
            found[f"root_position{end}_{k + 1}"] = np.where(none, np.nan, z[known.argmax(axis=1)])
    if "root_stress_fe_min" in data:
        least = np.asarray(data["root_stress_fe_min"].transpose("torque", "gear").values, dtype=np.float64)
        found |= {f"root_stress_fe_min_{k + 1}": least[:, k] for k in (0, 1)}
    return found


def root_stress_over_width(data: xr.Dataset, name: str = "root_stress") -> Array:
    """Largest root stress over the mesh cycle [Pa], shape (n_torque, 2, n_plane); NaN without a value.

    Parameters
    ----------
    data
        Dataset of a contact analysis.
    name
        One of `METHODS`.
    """
    values = _values(data, name)
    return _largest(values.transpose(0, 4, 3, 1, 2).reshape(len(values), 2, values.shape[3], -1))


def root_stress_of_tooth(data: xr.Dataset, torque: int = 0, name: str = "root_stress") -> tuple[Array, Array]:
    """Root stress of one tooth of each gear over its way, assembled from all mesh phases.

    Parameters
    ----------
    data
        Dataset of a contact analysis.
    torque
        Index of the torque.
    name
        One of `METHODS`.

    Returns
    -------
    way : ndarray, shape (n,)
        Positions of the tooth pair in the middle of the face [base pitches from A], ascending.
    stress : ndarray, shape (2, n)
        Maximum over the face width [Pa]; NaN without a value.
    """
    way = pair_positions(data).ravel()
    order = np.argsort(way, kind="stable")
    values = _values(data, name)[torque]
    return way[order], _largest(values.transpose(3, 0, 1, 2)).reshape(2, -1)[:, order]


def _values(data: xr.Dataset, name: str) -> Array:
    return np.asarray(data[name].transpose(*OVER, "gear").values, dtype=np.float64)


def _largest(values: Array) -> Array:
    """Maximum over the last axis; NaN without any value."""
    most = np.where(np.isfinite(values), values, -np.inf).max(axis=-1, initial=-np.inf)
    return np.where(np.isfinite(most), most, np.nan)
