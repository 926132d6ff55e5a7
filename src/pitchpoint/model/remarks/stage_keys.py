# SPDX-License-Identifier: Apache-2.0
"""Remarks on planetary stages: keys of meshes and members that the stage does not have, planets without
bearings."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, remark
from pitchpoint.core.words import listed
from pitchpoint.model.components.planetary_stage import SIDES
from pitchpoint.model.components.stage_mesh import SingleMesh, StageMesh
from pitchpoint.model.keys import defaults_of
from pitchpoint.model.remarks.trains import named_bodies
from pitchpoint.model.stage_members import SECTION
from pitchpoint.model.stand_ins import stands_in

if TYPE_CHECKING:
    from pitchpoint.model.components.planetary_stage import PlanetaryStage
    from pitchpoint.model.model import Model

MATE = {"sun": "sun", "ring": "ring", "planet": "inner_planets"}
"""Key that names the mate on each side."""
OF_INNER = ("planet_side", "planet_center_distance")
"""Keys that only stages with inner planets use."""
HOLDING = (
    "bearings",
    "rolling_bearings",
    "plain_bearings",
    "bushings",
    "springs",
    "maxwells",
    "beams",
    "couplings",
    "rods",
    "joints",
    "cam_contacts",
    "curve_contacts",
    "surface_contacts",
)
"""Sections whose components can hold a planet."""


def stage_keys(model: Model) -> Iterator[Message]:
    """Keys of stages without effect, and planets that nothing holds on their pins."""
    for name, stage in model.planetary_stages.items():
        written = {str(place[2]) for place in model.lines or {} if place[:2] == (SECTION, name) and place[2:]}
        yield from _idle_keys(stage, f"{SECTION}.{name}", written)
        yield from _loose(model, stage, f"{SECTION}.{name}")


def _idle_keys(stage: PlanetaryStage, at: str, written: set[str]) -> Iterator[Message]:
    """Settings of meshes that the stage does not have, and keys of stages with inner planets.

    `written` are the keys of the stage in its file; they may have the values of defaults.
    """
    (own, *steps), given = stage.wheels, []
    for side in SIDES:
        inherited = [
            s for s in steps if side in s.mates and getattr(stage.steps[s.step], f"{side}_mesh") is None
        ]
        key = f"{side}_mesh"
        if side not in own.mates and not inherited and (key in written or getattr(stage, key) != StageMesh()):
            given.append((f"{at}.{key}", side))
        for step in steps:
            if side not in step.mates and getattr(stage.steps[step.step], f"{side}_mesh") is not None:
                given.append((f"{at}.steps.{step.step}.{side}_mesh", side))
        for planet, single in stage.single_planets.items():
            if side not in own.mates and getattr(single, f"{side}_mesh") != SingleMesh():
                given.append((f"{at}.single_planets.{planet}.{side}_mesh", side))
    for where, side in given:
        yield remark(where, f"has no effect without {MATE[side]}", f"give {MATE[side]}, or remove it")
    usual = defaults_of(type(stage))
    if not any("planet" in wheel.mates for wheel in stage.wheels):
        for key in OF_INNER:
            if getattr(stage, key) != usual[key]:
                what = "has no effect without inner_planets"
                yield remark(f"{at}.{key}", what, "give inner_planets, or remove it")


def _loose(model: Model, stage: PlanetaryStage, at: str) -> Iterator[Message]:
    """Planets that can move on their pins without any force of a bearing."""
    if stage.motion == "torsion" or stage.bearing is not None:
        return
    held = {
        body
        for group in HOLDING
        for part in getattr(model, group).values()
        if not stands_in(part)
        for body in named_bodies(model, part)
    }
    loose = [planet for planet in stage.names if planet not in held]
    if loose:
        yield remark(
            f"{at}.bearing",
            f"is missing: with motion: {stage.motion} nothing holds {listed(loose)} on the carrier, which "
            "then transmits no torque of these planets",
            "give bearing, rolling bearings between carrier and planets, or motion: torsion",
        )
