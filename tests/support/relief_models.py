# SPDX-License-Identifier: Apache-2.0
"""Gear pairs with contact of tooth surfaces, and plans for their relief."""

from __future__ import annotations

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.contact_analysis.relief.plan import ReliefPlan

K = 3e8
TIP = "gears.{}.modifications.both.tip_relief.{}"


def pair(
    one: str = "",
    two: str = "",
    *,
    contact: str = f"level: rigid, stiffness: {K} N/m, planes: 3",
    beta: float = 0.0,
    internal: bool = False,
):
    """Pair 25/31 (internal: 25/73), m 3 mm, b 20 mm; `one`, `two`: modifications of the gears."""
    gear = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    hands = ("left", "left" if internal else "right")
    texts = [
        f"{gear}, helix_angle: {beta} deg, hand: {hand}"
        + (f", modifications: {{{modified}}}" if modified else "")
        for hand, modified in zip(hands, (one, two), strict=True)
    ]
    ring = "type: internal, number_of_teeth: 73" if internal else "number_of_teeth: 31"
    return loads_model(f"""
title: Relief
gears:
  pinion: {{number_of_teeth: 25, {texts[0]}}}
  wheel: {{{ring}, {texts[1]}}}
meshes:
  stage:
    gears: [pinion, wheel]
    contact: {{{contact}}}
""")


def torque(model, force):
    """Torque on the pinion of a force along the base tangent."""
    return force * model.pairs["stage"].gear1.r_b


def reliefs(amount=(0.0, 40e-6), length=None):
    """Bounds of the tip reliefs of both gears by path."""
    found = {}
    for gear in ("pinion", "wheel"):
        found[TIP.format(gear, "amount")] = amount
        if length is not None:
            found[TIP.format(gear, "length")] = length
    return found


def plan(model, forces, vary, **more):
    """Plan for forces along the base tangent."""
    return ReliefPlan(vary=vary, torques=[torque(model, force) for force in forces], **more)
