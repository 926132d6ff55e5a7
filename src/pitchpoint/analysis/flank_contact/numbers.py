# SPDX-License-Identifier: Apache-2.0
"""Main results of a contact analysis, one set of numbers per torque."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.flank_contact.load_factors import (
    face_load_factor,
    line_loads,
    load_over_width,
    loaded_pairs,
    pair_shares,
    transverse_load_factor,
)
from pitchpoint.analysis.flank_contact.losses import loss_factor
from pitchpoint.analysis.flank_contact.mesh_orders import mesh_orders
from pitchpoint.analysis.flank_contact.root_stress import root_stress_numbers
from pitchpoint.analysis.flank_contact.teeth import mesh_teeth
from pitchpoint.analysis.sampled import Array

if TYPE_CHECKING:
    import xarray as xr

CYCLE = ("torque", "mesh_phase_position")


def contact_numbers(data: xr.Dataset, harmonics: int = 5) -> dict[str, Array]:
    """Main results by name, each of shape (n_torque,) in SI units; amplitudes of orders (n_torque, n_order).

    Parameters
    ----------
    data
        Dataset of a contact analysis.
    harmonics
        Number of mesh orders of the transmission error.

    Returns
    -------
    dict
        `mean_transmission_error`, `transmission_error_pp`, `unloaded_transmission_error_pp` (peak to peak);
        `transmission_error_orders`; `mean_mesh_stiffness` (mean of the derivative of the force) and
        `mean_secant_stiffness` (mean of force over approach from first contact); `flank_pressure` and
        `edge_pressure` (maxima; NaN without contact, or for sharp edges); `face_load_factor`,
        `transverse_load_factor`; `max_line_load`, `mean_line_load`, `line_load_ratio`; `loaded_pairs`;
        `loss_factor`; those of `root_stress_numbers`. With operating conditions `loss_share` (friction power
        over power), `max_flash_temperature` and `min_film_thickness`.
    """
    curves = {
        name: np.asarray(data[name].transpose(*CYCLE).values, dtype=np.float64)
        for name in (
            "transmission_error",
            "unloaded_transmission_error",
            "mesh_stiffness",
            "secant_stiffness",
        )
    }
    most, mean = line_loads(data)
    phase = np.asarray(data["mesh_phase_position"].values, dtype=np.float64)
    error = curves["transmission_error"]
    found = {
        "mean_transmission_error": error.mean(axis=1),
        "transmission_error_pp": np.ptp(error, axis=1),
        "unloaded_transmission_error_pp": np.ptp(curves["unloaded_transmission_error"], axis=1),
        "transmission_error_orders": mesh_orders(error, harmonics).amplitude,
        "mean_mesh_stiffness": curves["mesh_stiffness"].mean(axis=1),
        "mean_secant_stiffness": curves["secant_stiffness"].mean(axis=1),
        "flank_pressure": maximum(data, "pressure"),
        "edge_pressure": maximum(data, "edge_pressure"),
        "face_load_factor": face_load_factor(load_over_width(data)),
        "transverse_load_factor": transverse_load_factor(pair_shares(data), phase, mesh_teeth(data)),
        "max_line_load": most,
        "mean_line_load": mean,
        "line_load_ratio": most / mean,
        "loaded_pairs": loaded_pairs(data),
        "loss_factor": loss_factor(data),
        **root_stress_numbers(data),
    }
    if "friction_coefficient" in data:
        found["loss_share"] = np.asarray(data["friction_coefficient"].values) * found["loss_factor"]
    if "flash_temperature" in data:
        found["max_flash_temperature"] = maximum(data, "flash_temperature")
    if "film_thickness" in data:
        found["min_film_thickness"] = -maximum(-data[["film_thickness"]], "film_thickness")
    return found


def maximum(data: xr.Dataset, name: str) -> Array:
    """Maximum of a field of the contact nodes, shape (n_torque,); NaN if it has no value.

    Parameters
    ----------
    data
        Dataset of a contact analysis.
    name
        Variable over torque, phase, tooth pair and plane.

    Examples
    --------
    >>> import xarray as xr
    >>> data = xr.Dataset({"pressure": (("torque", "plane"), [[1.0, float("nan")], [float("nan")] * 2])})
    >>> maximum(data, "pressure").tolist()
    [1.0, nan]
    """
    values = np.asarray(data[name].transpose("torque", ...).values, dtype=np.float64)
    flat = values.reshape(values.shape[0], -1)
    most = np.where(np.isfinite(flat), flat, -np.inf).max(axis=1, initial=-np.inf)
    return np.where(np.isfinite(most), most, np.nan)
