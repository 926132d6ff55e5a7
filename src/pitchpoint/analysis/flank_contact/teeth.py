# SPDX-License-Identifier: Apache-2.0
"""Geometry of the mesh in the dataset of a contact analysis: teeth, path of contact, contact planes.

Source: ISO 21771.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array

if TYPE_CHECKING:
    import xarray as xr

MARKS = ("A", "B", "C", "D", "E")


@dataclass(frozen=True)
class MeshTeeth:
    """Geometry of a mesh; all lengths and numbers of teeth are positive, but lengths of roll are signed.

    Attributes
    ----------
    number_of_teeth, base_radius
        Of both gears [-, m], shape (2,).
    beta_b
        Base helix angle [rad].
    mark_roll
        Lengths of roll at A, B, C, D, E on both gears [m], shape (2, 5); negative inside the base circle.
    z, width
        Middles and widths of the contact planes [m], shape (n_plane,).
    advance
        Base pitches by which the contact in a plane is ahead of that in the middle of the face [-], shape
        (n_plane,).
    """

    number_of_teeth: Array
    base_radius: Array
    beta_b: float
    mark_roll: Array
    z: Array
    width: Array
    advance: Array

    @property
    def base_pitch(self) -> float:
        """Transverse base pitch p_bt [m]."""
        return 2.0 * math.pi * float(self.base_radius[0] / self.number_of_teeth[0])

    @property
    def eps_alpha(self) -> float:
        """Transverse contact ratio of the unloaded pair [-]."""
        return float(self.mark_roll[0, 4] - self.mark_roll[0, 0]) / self.base_pitch

    @property
    def eps_beta(self) -> float:
        """Overlap ratio of the common face width [-]."""
        return float(np.ptp(self.advance)) * self.z.size / max(self.z.size - 1, 1)


def mesh_teeth(data: xr.Dataset) -> MeshTeeth:
    """Geometry of the mesh of a contact analysis.

    Parameters
    ----------
    data
        Dataset of a contact analysis.

    Examples
    --------
    >>> import xarray as xr
    >>> data = xr.Dataset(coords={"plane": [-0.005, 0.005]})
    >>> data["number_of_teeth"], data["base_radius"] = ("gear", [16.0, 24.0]), ("gear", [0.0338, 0.0507])
    >>> data["base_helix_angle"] = "gear", [0.1, 0.1]
    >>> data["mark_roll"] = ("gear", "mark"), [[0.004, 0.010, 0.014, 0.018, 0.024]] * 2
    >>> data["plane_width"], data["plane_advance"] = ("plane", [0.01, 0.01]), ("plane", [-0.1, 0.1])
    >>> teeth = mesh_teeth(data)
    >>> round(teeth.base_pitch, 6), round(teeth.eps_alpha, 3), round(teeth.eps_beta, 3)
    (0.013273, 1.507, 0.4)
    """
    found = {
        name: np.asarray(data[name].values, dtype=np.float64)
        for name in (
            "number_of_teeth",
            "base_radius",
            "base_helix_angle",
            "mark_roll",
            "plane",
            "plane_width",
            "plane_advance",
        )
    }
    return MeshTeeth(
        number_of_teeth=found["number_of_teeth"],
        base_radius=found["base_radius"],
        beta_b=float(found["base_helix_angle"][0]),
        mark_roll=found["mark_roll"],
        z=found["plane"],
        width=found["plane_width"],
        advance=found["plane_advance"],
    )


def diameter_at(roll: ArrayLike, base_radius: float) -> Array:
    """Diameter of a place on an involute [m], shape of `roll`.

    Parameters
    ----------
    roll
        Length of roll [m], any shape; negative, inside the base circle, gives the diameter of this circle.
    base_radius
        Base radius [m].

    Notes
    -----
    d = 2 sqrt(r_b² + ρ²) with the length of roll ρ ≥ 0 (ISO 21771).

    Examples
    --------
    >>> diameter_at([0.03, -0.01], 0.04).round(9).tolist()
    [0.1, 0.08]
    """
    return np.asarray(2.0 * np.hypot(base_radius, np.maximum(roll, 0.0)))


def pair_positions(data: xr.Dataset) -> Array:
    """Position of each tooth pair in the middle of the face [base pitches from A], shape (n_phase, n_pair).

    Parameters
    ----------
    data
        Dataset of a contact analysis.

    Examples
    --------
    >>> import xarray as xr
    >>> pair_positions(xr.Dataset(coords={"mesh_phase_position": [0.0, 0.25], "tooth_pair": [-1, 0, 1]}))
    array([[-1.  ,  0.  ,  1.  ],
           [-0.75,  0.25,  1.25]])
    """
    phase = np.asarray(data["mesh_phase_position"].values, dtype=np.float64)
    return phase[:, None] + np.asarray(data["tooth_pair"].values, dtype=np.float64)[None, :]
