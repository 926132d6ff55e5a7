# SPDX-License-Identifier: Apache-2.0
"""The body record: where a body hangs, how it may move, what it weighs.

A body has a *non-spinning frame* whose third axis is its spin axis; the spin is an angle beside the frame.
Mass is distributed symmetrically about the spin axis, so the inertia is constant in that frame and no sine of
the spin is needed. Every body hangs on its parent by one joint; today the parent is ground.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.multibody.joints import FIXED, FREE, JOINTS, PLANAR, TORSION

__all__ = ["BODY", "FIXED", "FREE", "PATH", "PLANAR", "TORSION", "Body", "body_records"]

BODY = np.dtype(
    [
        ("joint", "i8"),  # number of coordinates = code of the joint (see joints.py)
        ("parent", "i8"),  # body it hangs on, 0 = ground
        ("dof", "i8"),  # index of its first coordinate
        ("spin", "i8"),  # index of its spin coordinate, -1 if it has none
        ("path", "i8"),  # its own entry in the list of paths, -1 if fixed to ground
        ("ii", "i8"),  # its diagonal pair block, 0 = dump
        ("pos", "f8", 3),  # reference position of the origin, world [m]
        ("axes", "f8", (3, 3)),  # reference frame, columns in world axes; third = spin axis
        ("mass", "f8"),  # [kg]
        ("i_p", "f8"),  # inertia about the spin axis [kg m^2]
        ("i_t", "f8"),  # inertia about any transverse axis through the centre of mass [kg m^2]
        ("c_z", "f8"),  # centre of mass along the spin axis, from the origin [m]
    ],
    align=True,
)

# One row per joint on the way from ground to a body; with all bodies on ground: one per moving body.
PATH = np.dtype([("body", "i8"), ("joint", "i8"), ("dof", "i8"), ("n", "i8")], align=True)


@dataclass(frozen=True, kw_only=True)
class Body:
    """One rigid body, as numbers.

    Parameters
    ----------
    motion
        Code of the joint to ground: 0 fixed, 1 torsion, 3 planar, 6 free.
    position
        Reference position of the origin in world axes [m].
    axes
        Reference frame (3, 3), columns in world axes, right-handed; the third is the spin axis.
    mass, polar_inertia, transverse_inertia
        [kg], [kg m^2] about the spin axis, [kg m^2] about a transverse axis through the centre of mass.
    center
        Centre of mass along the spin axis from the origin [m].
    angle
        Initial spin [rad]; any number of turns.
    """

    motion: int = TORSION
    position: ArrayLike = (0.0, 0.0, 0.0)
    axes: ArrayLike = field(default_factory=lambda: np.eye(3))
    mass: float = 0.0
    polar_inertia: float = 0.0
    transverse_inertia: float = 0.0
    center: float = 0.0
    angle: float = 0.0
    name: str = ""

    def faults(self) -> list[str]:
        """Say what makes the body impossible to compute; empty if nothing does."""
        if self.motion not in JOINTS:
            return [f"motion {self.motion} is none of {sorted(JOINTS)}"]
        found = []
        axes = np.asarray(self.axes, float)
        if axes.shape != (3, 3) or np.abs(axes.T @ axes - np.eye(3)).max() > 1e-9 or np.linalg.det(axes) < 0:
            found.append("axes must be a right-handed orthonormal frame")
        numbers = (self.mass, self.polar_inertia, self.transverse_inertia, self.center, self.angle)
        if not np.all(np.isfinite(numbers)) or not np.all(np.isfinite(np.asarray(self.position, float))):
            found.append("every number must be finite")
        if self.motion != FIXED and not self.polar_inertia > 0.0:
            found.append("polar_inertia must be positive for a body that spins")
        if self.motion in (PLANAR, FREE) and not self.mass > 0.0:
            found.append("mass must be positive for a body that translates")
        if self.motion == FREE and not self.transverse_inertia > 0.0:
            found.append("transverse_inertia must be positive for a body that tilts")
        return found


def body_records(bodies: Sequence[Body]) -> NDArray[np.void]:
    """Fill the body records, ground first; coordinate indices are left to the layout.

    Parameters
    ----------
    bodies
        The bodies without ground; body k of this list gets index k + 1.

    Returns
    -------
    ndarray of BODY, shape (len(bodies) + 1,)
    """
    records = np.zeros(len(bodies) + 1, BODY)
    records["axes"] = np.eye(3)
    records["spin"] = records["path"] = -1
    for record, body in zip(records[1:], bodies, strict=True):
        record["joint"] = body.motion
        record["pos"] = body.position
        record["axes"] = body.axes
        record["mass"], record["i_p"] = body.mass, body.polar_inertia
        record["i_t"], record["c_z"] = body.transverse_inertia, body.center
    return records
