# SPDX-License-Identifier: Apache-2.0
"""Bevel gears and bevel meshes as components of REXS."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.io.rexs.exporting.draft import Draft, placed

if TYPE_CHECKING:
    from pitchpoint.model.components.bevel_gear import BevelGear


def add_bevels(draft: Draft) -> None:
    """Add all bevel gears on their shafts, and their stages."""
    model = draft.model
    for body, found in model.bodies.items():
        for name, apex in found.bevel_gears.items():
            if name in model.bevel_gears and body in draft.shafts:
                _add_gear(draft, name, model.bevel_gears[name], body, apex)
    for name in model.bevel_gears:
        if name not in draft.gears:
            draft.omit(f"bevel_gears.{name}", "is on no shaft or body: not written")
    for name, mesh in model.bevel_meshes.items():
        pair = model.bevel_pairs.get(name)
        if pair is None or any(gear not in draft.gears for gear in mesh.gears):
            draft.omit(f"bevel_meshes.{name}", "its gears are not in the file: not written")
            continue
        alpha = model.bevel_gears[mesh.gears[0]].normal_pressure_angle
        id = draft.part(
            "bevel_stage",
            name,
            draft.unit,
            shaft_angle=pair.Sigma,
            hypoid_offset=0.0,
            generated_pressure_angle_on_drive_side=alpha,
            generated_pressure_angle_on_coast_side=alpha,
            mean_normal_backlash=model.backlash(name) * math.cos(pair.beta_b),
        )
        draft.meshes[name] = id
        first, second = (draft.gears[gear] for gear in mesh.gears)
        draft.relate("stage", stage=id, gear_1=first, gear_2=second)


def _add_gear(draft: Draft, name: str, gear: BevelGear, body: str, apex: float) -> None:
    """Add a bevel gear: its origin is the middle of the face, projected on its axis."""
    geometry = gear.geometry
    u = apex + gear.direction * geometry.R_m * math.cos(geometry.delta)
    origin, axes = draft.frame(body)
    hand = None if gear.hand is None or not gear.spiral_angle else gear.hand
    id = draft.part(
        "bevel_gear",
        name,
        draft.shafts[body],
        **placed(origin + np.asarray(axes)[:, 2] * u, axes, draft.unit),
        u_coordinate_on_shaft=u,
        number_of_teeth=gear.number_of_teeth,
        mean_normal_module=geometry.m_mn,
        mean_spiral_angle=gear.beta_m,
        spiral_angle_pitch_direction=hand,
        face_width=gear.face_width,
        pitch_angle=geometry.delta,
        mean_cone_distance=geometry.R_m,
        profile_shift_coefficient=gear.profile_shift_coefficient,
        thickness_modification_coefficient=gear.thickness_modification_coefficient,
        basic_crown_gear_addendum_factor=gear.rack.addendum,
        basic_crown_gear_dedendum_factor=gear.rack.dedendum,
        bevel_cone_orientation="negative" if gear.direction > 0.0 else "positive",
        mass_of_component=gear.mass,
    )
    draft.gears[name] = id
    flanks = {
        side: draft.add("bevel_gear_flank", "", tool_edge_radius=gear.rack.root_radius * geometry.m_mn)
        for side in ("left", "right")
    }
    draft.relate("flank", gear=id, **flanks)
    draft.relate("reference", origin=id, referenced=draft.material(gear.material_data))
