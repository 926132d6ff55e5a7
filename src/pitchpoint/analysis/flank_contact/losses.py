# SPDX-License-Identifier: Apache-2.0
"""Friction losses of a contact analysis: sliding speeds and tooth loss factor.

Source: tooth loss factor after Ohlendorf (1958), here with the calculated load distribution.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.flank_contact.load_factors import OVER, plane_forces
from pitchpoint.analysis.flank_contact.teeth import mesh_teeth
from pitchpoint.analysis.sampled import Array

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.analysis.flank_contact.teeth import MeshTeeth


def sliding_radius(roll_1: Array, roll_2: Array, teeth: MeshTeeth) -> Array:
    """Sliding speed of the flanks over the angular speed of gear 1 [m], shape of the lengths of roll.

    Parameters
    ----------
    roll_1, roll_2
        Lengths of roll at the contact on both gears [m], negative inside a base circle, any shape.
    teeth
        Geometry of the mesh.

    Notes
    -----
    v_g/ω₁ = |ρ₁ − ρ₂ z₁/z₂| with the rolling speeds ω₁ρ₁ and ω₂ρ₂ of the flanks (ISO 21771:2007, 6.4), which
    point in the same direction for external and internal pairs. For a tip edge off the line of action an
    approximation.

    Examples
    --------
    >>> from pitchpoint.analysis.flank_contact.teeth import MeshTeeth
    >>> one = np.ones(2)
    >>> teeth = MeshTeeth(np.array([16.0, 24.0]), one, 0.0, np.ones((2, 5)), one, one, one)
    >>> sliding_radius(np.array([0.02]), np.array([0.015]), teeth).round(9).tolist()
    [0.01]
    """
    ratio = float(teeth.number_of_teeth[0] / teeth.number_of_teeth[1])
    return np.asarray(np.abs(roll_1 - roll_2 * ratio))


def loss_factor(data: xr.Dataset) -> Array:
    """Tooth loss factor H_V [-], shape (n_torque,): mean power loss = μ_m P H_V.

    Parameters
    ----------
    data
        Dataset of a contact analysis.

    Notes
    -----
    H_V = mean over the mesh phases of Σ F_n v_g/(T₁ ω₁), with the normal forces F_n of all contact planes
    and a constant coefficient of friction. With the load shared equally by two pairs it is Ohlendorf's factor
    (1958; `geometry.sliding.loss_factor_ohlendorf`). The effect of friction on the load is neglected.

    Examples
    --------
    >>> import xarray as xr
    >>> data = xr.Dataset({"plane_force": (OVER, [[[[2.0]]]]), "roll_1": (OVER, [[[[0.02]]]])})
    >>> data["roll_2"], data["torque"] = (OVER, [[[[0.015]]]]), ("torque", [0.2])
    >>> data["number_of_teeth"], data["base_radius"] = ("gear", [16.0, 24.0]), ("gear", [0.1, 0.15])
    >>> data["base_helix_angle"] = "gear", [0.0, 0.0]
    >>> data["mark_roll"] = ("gear", "mark"), np.ones((2, 5))
    >>> data["plane"], data["plane_width"], data["plane_advance"] = (("plane", [0.0]),) * 3
    >>> loss_factor(data).round(9).tolist()
    [0.1]
    """
    teeth = mesh_teeth(data)
    roll = [np.asarray(data[f"roll_{k}"].transpose(*OVER).values, dtype=np.float64) for k in (1, 2)]
    arm = np.nan_to_num(sliding_radius(roll[0], roll[1], teeth), nan=0.0)
    work = (plane_forces(data) * arm).sum(axis=(2, 3)).mean(axis=1) / math.cos(teeth.beta_b)
    return np.asarray(work / np.abs(np.asarray(data["torque"].values, dtype=np.float64)))
