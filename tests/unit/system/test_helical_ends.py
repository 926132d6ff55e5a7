# SPDX-License-Identifier: Apache-2.0
"""Finite elements of helical teeth in the contact of a pair: which end of a flank is soft.

At the acute end of a flank there is less material behind it. Both flanks of a contact have opposite normals,
so that the acute end of one is at the obtuse end of the other, on external gears and in rings.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import pytest

from pitchpoint.contact.tooth_fe.section_mesh import Density
from pitchpoint.contact.tooth_fe.solve import tooth_fe
from pitchpoint.contact.tooth_fe.tooth_model import Resolution, ToothModel
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.system.rules import flexible_teeth

PAIR = """
gears:
  g1: {{number_of_teeth: 25, helix_angle: 18 deg, hand: {one}, normal_module: 3 mm, face_width: 24 mm,
       profile_shift_coefficient: 0.2}}
  g2: {{number_of_teeth: {z}, helix_angle: 18 deg, hand: {two}, normal_module: 3 mm, face_width: 24 mm,
       profile_shift_coefficient: 0{kind}}}
meshes:
  m: {{gears: [g1, g2], contact: {{level: flexible, teeth: finite_elements, planes: 5}}}}
"""
COARSE = Resolution(heights=4, widths=5, fillet_points=2, density=Density(order=3, body=(0.0, 1.0)))
OTHER = {"right": "left", "left": "right"}


@lru_cache(maxsize=8)
def coarse(geometry):
    return tooth_fe(ToothModel(gear=geometry, resolution=COARSE))


def acute_end(outward: float, slope: float) -> float:
    """Side z = ±1 of the acute end of a flank with its outward normal along y, at a trace (0, slope, 1).

    The normal is perpendicular to the trace; the angle of the material between flank and end face is acute
    where the outward normals of both form an obtuse angle.
    """
    trace, normal = np.array([0.0, slope, 1.0]), np.array([0.0, outward, 0.0])
    normal -= (normal @ trace) / (trace @ trace) * trace
    return -float(np.sign(normal[2]))


@pytest.mark.parametrize("hand", ["right", "left"])
@pytest.mark.parametrize("internal", [False, True])
def test_the_acute_end_of_each_flank_is_soft(monkeypatch, hand: str, internal: bool) -> None:
    monkeypatch.setattr(flexible_teeth, "finite_elements_of", lambda gear: coarse(gear.geometry))
    two, kind = (hand, ", type: internal") if internal else (OTHER[hand], "")
    model = loads_model(PAIR.format(one=hand, two=two, kind=kind, z=70 if internal else 31))
    gears = [model.gears[name] for name in ("g1", "g2")]
    contact = model.meshes["m"].contact
    found = flexible_teeth.elastic_flanks(contact, model.pairs["m"], gears, (0.0, 0.0))
    for k, (gear, influence) in enumerate(zip(gears, found.gears, strict=True)):
        assert influence.back is not None
        for flank, teeth in ((1.0, influence.teeth), (-1.0, influence.back)):
            # contact on the x axis: the front flank of gear 1 faces +y, that of gear 2 faces -y
            outward = flank if k == 0 else -flank
            # a right-hand trace runs counter-clockwise about its axis, towards +y where its point is at +x
            place = -1.0 if k == 1 and not internal else 1.0
            slope = place * math.tan(gear.geometry.beta)
            ends = teeth.own[0, 0, 0, 0], teeth.own[-1, -1, 0, 0]
            soft = 1.0 if ends[1] > 1.1 * ends[0] else -1.0
            assert max(ends) > 1.1 * min(ends)
            assert soft == acute_end(outward, slope)
