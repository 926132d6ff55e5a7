# SPDX-License-Identifier: Apache-2.0
"""Tooth damage as level functions over the flank.

Where a level is positive it is the gap of the damage along the base tangent; its zero line is the edge of the
damage; where it is negative the flank is intact. Positions on the flank are z along the face width, −b/2 to
b/2, and roll lengths as in `geometry.modifications`; heights are radial.

Derivation: docs/theory/geometry.md, "Micro-geometry, deviations, damage".
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import GeometryError, Message
from pitchpoint.geometry.tooth_form import root_radius

if TYPE_CHECKING:
    from pitchpoint.geometry.bevel.gear import BevelGear
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

FloatArray = NDArray[np.float64]

FRACTURE_SLOPE = 1.0
"""Gap along the base tangent per distance from the edge of a fracture: a surface at 45 degrees. Elastic
deflection extends contact about 20 µm beyond the edge."""

_FIT = 1e-9


def tooth_height(gear: CylindricalGear) -> float:
    """Radial height of a tooth from its root circle to its tip circle [m].

    Parameters
    ----------
    gear
        External or internal gear.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> round(tooth_height(CylindricalGear(z=50, m_n=3e-3)), 9)
    0.00675
    """
    return abs(0.5 * abs(gear.d_a) - root_radius(gear))


def break_problems(width: float, height: float, gear: CylindricalGear) -> list[Message]:
    """Problems of a break that is larger than the tooth.

    Parameters
    ----------
    width, height
        Size of the missing part [m].
    gear
        External or internal gear.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=50, m_n=3e-3, b=0.02)
    >>> print(break_problems(0.03, 0.002, gear)[0])
    width: 30 mm is wider than the face (limit 20 mm); leave it out for the whole face
    """
    found = wider_than_face(width, gear.b)
    most = tooth_height(gear)
    if height > most * (1.0 + _FIT):
        message, remedy = "is higher than the tooth", "leave it out for the whole tooth"
        value, limit = f"{1e3 * height:.6g} mm", f"{1e3 * most:.6g} mm"
        found.append(Message("height", message, value, limit, remedy))
    return found


def wider_than_face(width: float, face_width: float, where: str = "width") -> list[Message]:
    """Problem of a missing width that is larger than the face width.

    Parameters
    ----------
    width, face_width
        Missing width and face width [m].
    where
        Path of the width in the model.

    Examples
    --------
    >>> print(*wider_than_face(0.03, 0.02))
    width: 30 mm is wider than the face (limit 20 mm); leave it out for the whole face
    """
    if width <= face_width * (1.0 + _FIT):
        return []
    value, limit = f"{1e3 * width:.6g} mm", f"{1e3 * face_width:.6g} mm"
    return [Message(where, "is wider than the face", value, limit, "leave it out for the whole face")]


def break_level(
    gear: CylindricalGear,
    z: ArrayLike,
    roll: ArrayLike,
    *,
    width: float,
    height: float,
    at: str = "start",
    corner: bool = False,
) -> FloatArray:
    """Level function of a break: distance from its straight edges times `FRACTURE_SLOPE`.

    Parameters
    ----------
    gear
        External or internal gear.
    z
        Positions along the face width [m], shape (n_z,).
    roll
        Roll lengths [m], shape (n_roll,).
    width, height
        Size of the missing part at the tip and at the end of the face [m]; 0 for no break.
    at
        "start" (z = −b/2) or "end".
    corner
        True if only the triangle between the tip and the end of the face is missing, not the rectangle.

    Returns
    -------
    ndarray, shape (n_z, n_roll)
        Level [m], positive in the missing part.

    Raises
    ------
    GeometryError
        If the break is larger than the tooth.

    Notes
    -----
    With ζ from the end of the face and η from the tip: corner 1 − ζ/width − η/height over
    √(1/width² + 1/height²), rectangle min(width − ζ, height − η); a break over the whole face has no edge
    across it.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.modifications import roll_length
    >>> gear = CylindricalGear(z=50, m_n=3e-3, b=0.02)
    >>> d = gear.d_a - 2 * np.array([0.0, 0.5e-3, 2e-3])
    >>> level = break_level(gear, [-0.01, 0.01], roll_length(gear, d), width=0.02, height=1e-3)
    >>> (1e3 * level).round(6).tolist()
    [[1.0, 0.5, -1.0], [1.0, 0.5, -1.0]]
    """
    for problem in break_problems(width, height, gear):
        raise GeometryError(
            problem.text,
            where=problem.where,
            value=problem.value,
            limit=problem.limit,
            remedy=problem.remedy,
        )
    z = np.atleast_1d(np.asarray(z, dtype=float))
    radius = np.hypot(np.atleast_1d(np.asarray(roll, dtype=float)), 0.5 * gear.d_b)
    eta = gear.sign * (0.5 * abs(gear.d_a) - radius)
    zeta = 0.5 * gear.b + (z if at == "start" else -z)
    if not (width > 0.0 and height > 0.0):
        return np.full((z.size, eta.size), -gear.m_n)
    if corner:
        steep = np.hypot(1.0 / width, 1.0 / height)
        level = (1.0 - zeta[:, None] / width - eta[None, :] / height) / steep
    else:
        level = np.broadcast_to(height - eta[None, :], (z.size, eta.size))
        if width < gear.b * (1.0 - _FIT):
            level = np.minimum(level, (width - zeta)[:, None])
    return np.asarray(FRACTURE_SLOPE * level)


def displaced_gap(gear: CylindricalGear | BevelGear, flank: str, amount: float) -> float:
    """Gap along the base tangent of a flank whose tooth is displaced along the reference circle [m].

    Parameters
    ----------
    gear
        Cylindrical gear, or bevel gear with the displacement along its pitch circle at mid-face.
    flank
        "left" or "right".
    amount
        Displacement [m], counter-clockwise positive.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=50, m_n=3e-3)
    >>> [round(1e6 * displaced_gap(gear, flank, 10e-6), 6) for flank in ("left", "right")]
    [-9.396926, 9.396926]
    """
    outwards = 1.0 if flank == "left" else -1.0
    return -outwards * amount * float(np.cos(gear.alpha_t))
