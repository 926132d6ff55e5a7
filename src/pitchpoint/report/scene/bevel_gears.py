# SPDX-License-Identifier: Apache-2.0
"""Bevel gears of a scene: one tooth in several levels of detail, and the angles of its copies."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.bevel.sector import bevel_outline, bevel_sector, bevel_slices
from pitchpoint.model.components.tooth_faults import PitchError
from pitchpoint.report.scene.gears import ERRORS, FINEST, MAX_POINTS
from pitchpoint.viz.scene.content import SceneLevel, ScenePiece, SceneSolid

if TYPE_CHECKING:
    from pitchpoint.geometry import BevelGear as Shape
    from pitchpoint.model.components.bevel_gear import BevelGear
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]


def bevel_axes(gear: BevelGear, angle: float) -> Array:
    """Frame of a bevel gear on its body as columns: third axis into the gear, tooth 0 on the first axis.

    Parameters
    ----------
    gear
        The gear.
    angle
        Angle of tooth 0 about the z axis of the body [rad].
    """
    c, s, way = math.cos(angle), math.sin(angle), gear.direction
    return np.array([[c, -s * way, 0.0], [s, c * way, 0.0], [0.0, 0.0, way]])


def bevel_part(model: Model, name: str, seat: tuple[int, Array, Array], thinner: float) -> SceneSolid:
    """Bevel gear with its teeth.

    Parameters
    ----------
    model
        The model.
    name
        Name of the gear.
    seat
        Index of its body in the scene, its apex [m] and the axes of its body in the frame of the scene body.
    thinner
        Reduction of the normal tooth thickness at mid-face for the backlash of its meshes [m].

    Raises
    ------
    GeometryError
        If teeth or body are impossible.
    """
    gear = model.bevel_gears[name]
    shape = gear.geometry
    shape = replace(shape, thickness_allowance=shape.thickness_allowance - thinner)
    number, place, frame = seat
    return SceneSolid(
        name=name,
        kind="gear",
        body=number,
        teeth=shape.z,
        place=place,
        axes=frame @ bevel_axes(gear, model.bevel_angles[name]),
        pieces=_pieces(gear, shape),
    )


def _pieces(gear: BevelGear, shape: Shape) -> list[ScenePiece]:
    """Teeth at their positions with the gear body, and every broken tooth with its faults."""
    pitches: Array = 2.0 * math.pi / shape.z * np.arange(shape.z, dtype=np.float64)
    turns = pitches.copy()
    broken: dict[int, list[str]] = {}
    whole: dict[int, tuple[float, float]] = {}
    for label, fault in gear.faults.items():
        tooth = fault.tooth
        if isinstance(fault, PitchError):
            turns[tooth] += fault.severity * fault.amount / (0.5 * shape.d_m)
        elif fault.severity > 0.0:
            ends = fault.left(shape.R_i, shape.R_e)
            before = whole.get(tooth, ends)
            whole[tooth] = max(before[0], ends[0]), min(before[1], ends[1])
            broken.setdefault(tooth, []).append(f"tooth {tooth}: {label} (broken tooth)")
    sound = np.array([tooth for tooth in range(shape.z) if tooth not in broken], np.int64)
    teeth, body = _levels(gear, shape)
    found = [ScenePiece(pitches, body)]
    if sound.size:
        found.insert(0, ScenePiece(turns[sound], teeth))
    for tooth, labels in broken.items():
        stump = _levels(gear, shape, whole[tooth])[0]
        found.append(ScenePiece(turns[[tooth]], stump, "; ".join(labels)))
    return found


def _levels(
    gear: BevelGear, shape: Shape, whole: tuple[float, float] | None = None
) -> tuple[list[SceneLevel], list[SceneLevel]]:
    """Tooth and body behind it, from coarse to fine, with chords as for cylindrical gears.

    They are separate surfaces, because a nearly flat back cone would be shaded as round at its edge. `whole`:
    cone distances between which the tooth is complete [m].
    """
    teeth, body = [], []
    coarse = [e * shape.m_mn for e in ERRORS]
    for error in (*coarse, max(FINEST[0], FINEST[1] * shape.m_mn)):
        finest = error < coarse[-1]
        asked = gear.drawing_resolution if finest else None
        outline = bevel_outline(
            shape,
            error,
            None if asked is None else min(asked, MAX_POINTS),
            min(10.0 * error, coarse[-1]) if finest else error,
        )
        sector = bevel_sector(
            shape,
            outline,
            bevel_slices(shape, 10.0 * error if finest else error),
            bore_diameter=gear.bore_diameter,
            rim_thickness=gear.rim_thickness,
            whole=whole,
        )
        teeth.append(SceneLevel(error, *sector.part(0, sector.blank)))
        body.append(SceneLevel(error, *sector.part(sector.blank, len(sector.triangles))))
    return teeth, body
