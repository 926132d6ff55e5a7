# SPDX-License-Identifier: Apache-2.0
"""Contacts of teeth in a scene: where flanks touch, and what they carry there. Numbers alone, as `scene`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class FlankSurface:
    """The part of a flank that the path of contact reaches, of the tooth of pair 0.

    Attributes
    ----------
    body
        Number of the body it is fixed to.
    gear
        Name of the gear.
    teeth
        Its number of teeth.
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
    """What the front or the back flanks of a mesh carry.

    Attributes
    ----------
    side
        1 front, -1 back.
    travel
        Place of the contact line of pair 0 on the path of contact, in the plane of the pitch point, shape
        (n,) [m]; pair N is N base pitches behind.
    forces
        Of the slots, along the base tangent, front positive, shape (n, p) [N]; pair N has slot N mod p.
    loads
        Per width at s even places on each line, shape (n, p, s) [N/m].
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
    """Where and how the teeth of a mesh touch. Contact lines are straight in the plane of action.

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
        Ends of the shared face width, from the plane of the pitch point [m].
    path
        Ends A and E of the path of contact, from the pitch point [m].
    cone
        Of bevel gears: mean cone distance [m] and pitch cone angle of gear 2 [rad]. The third axis then goes
        along the pitch ray; widths are R_m ln(R/R_m), paths are arcs at R_m, and lines are straight in these.
    penetration
        Of front and back flanks normal to them at the pitch point, below 0 their distance, shape (n, 2) [m].
    flanks
        The front flanks, and the back flanks where they ever touch.
    unit_pressure
        Hertzian pressure that a load of 1 N/m makes, at even places from A to E, shape (n,) [Pa]; that of
        another load goes with its square root. None where loads are not known.
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
