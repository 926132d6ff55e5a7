# SPDX-License-Identifier: Apache-2.0
"""Tooth contacts in a scene as plain data: contact lines and their loads."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class FlankSurface:
    """Part of a flank within the path of contact, for the tooth of pair 0.

    Attributes
    ----------
    body
        Index of its body.
    gear
        Name of the gear.
    teeth
        Number of teeth.
    points
        Shape (nz, nx, 3) [m] in the frame of the body, over the width and along the path from A to E.
    turn
        Angle about the third axis of the body from one pair to the next [rad].
    tooth, step
        Number of the tooth of pair 0, and from one pair to the next.
    """

    body: int
    gear: str
    teeth: int
    points: Array
    turn: float
    tooth: int
    step: int


@dataclass(frozen=True, kw_only=True)
class ContactFlank:
    """Contact of the front or the back flanks of a mesh.

    Attributes
    ----------
    side
        1 front, -1 back.
    travel
        Position of the contact line of pair 0 on the path of contact, in the plane of the pitch point, shape
        (n,) [m]; pair N is N base pitches behind.
    forces
        Forces of the slots along the base tangent, front positive, shape (n, p) [N]; pair N has slot N mod p.
    loads
        Loads per width at s equally spaced points of each line, shape (n, p, s) [N/m].
    surfaces
        Flanks of gear 1 and 2.
    """

    side: int
    travel: Array
    forces: Array
    loads: Array
    surfaces: Sequence[FlankSurface]


@dataclass(frozen=True, kw_only=True)
class SceneContact:
    """Tooth contacts of a mesh. Contact lines are straight in the plane of action.

    Attributes
    ----------
    name
        Name of the mesh.
    at
        Pitch point, shape (1, 3) or (n, 3) [m], world.
    axes
        Radial (towards gear 2), tangential and axial direction as columns, shape (1, 3, 3) or (n, 3, 3).
    pressure_angle
        Transverse working pressure angle, shape (1,) or (n,) [rad].
    base_helix
        Base helix angle of gear 1, right hand positive [rad].
    base_pitch
        Transverse base pitch [m].
    width
        Ends of the common face width, from the plane of the pitch point [m].
    path
        Ends A and E of the path of contact, from the pitch point [m].
    cone
        For bevel gears: mean cone distance [m] and pitch cone angle of gear 2 [rad]. The third axis is then
        along the pitch ray; widths are R_m ln(R/R_m), paths are arcs at R_m, and lines are straight in these.
    penetration
        Normal penetration of front and back flanks at the pitch point, negative for a gap, shape (n, 2) [m].
    flanks
        Front flanks, and back flanks if they touch at any time.
    unit_pressure
        Hertzian pressure for a load of 1 N/m at equally spaced points from A to E, shape (n,) [Pa]; it is
        proportional to the square root of the load. None if loads are not known.
    """

    name: str
    at: Array
    axes: Array
    pressure_angle: Array
    base_helix: float
    base_pitch: float
    width: tuple[float, float]
    path: tuple[float, float]
    penetration: Array
    flanks: Sequence[ContactFlank]
    unit_pressure: Array | None = None
    cone: tuple[float, float] | None = None
