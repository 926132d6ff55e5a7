# SPDX-License-Identifier: Apache-2.0
"""Models of earlier versions keep their hash, from which the noise of data sets is drawn."""

from __future__ import annotations

import pytest

from pitchpoint.core.provenance import content_hash
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.components.gear import Gear
from pitchpoint.model.components.mesh import Backlash
from pitchpoint.model.components.rolling_bearing import RollingBearing
from tests.support.planet_stages import stage_file

BEARINGS = """\
bodies:
  rotor: {motion: free, mass: 2 kg, inertia: 2e-3, transverse_inertia: 2e-3, position: [0, 0, 0]}
  housing: {motion: free, mass: 9 kg, inertia: 0.1, transverse_inertia: 0.1, position: [0, 0, 0]}
bearings: {feet: {body: housing, stiffness: {radial: 1e7, axial: 1e7, tilt: 1e4, torsion: 1e4}}}
rolling_bearings:
  a: {ends: [rotor, housing], elements: 9, element_diameter: 8 mm, pitch_diameter: 39 mm,
    grooves: [0.52, 0.52]}
  b: {ends: [rotor, housing], type: roller, elements: 9, element_diameter: 8 mm, pitch_diameter: 39 mm,
    effective_length: 8 mm, clearance: 5 um, contact_angle: 10 deg}
plain_bearings: {p: {ends: [rotor, housing], clearance: 20 um, stiffness: 1e8}}
"""


def test_bearings_without_catalogue_data():
    """The hash of this file before there were bearings by designation."""
    assert content_hash(loads_model(BEARINGS)) == "d133ae0aa4f70b6b"


VALUES = ({}, {"clearance": 0.0}, {"slices": 11}, {"position": (0.0, 0.0, 0.1)}, {"preload_distance": 0.0})
PARTS = {
    "bearing": [RollingBearing(body="shaft", designation="6308", **more) for more in VALUES],
    "play": [
        RollingBearing(body="shaft", designation="NUP 208 E", **m) for m in ({}, {"axial_clearance": 0.0})
    ],
    "gear": [
        Gear(number_of_teeth=20, normal_module=2e-3, face_width=0.02, profile_shift_coefficient=0.0, **more)
        for more in ({}, {"tip_chamfer": 0.0}, {"tip_rounding": 0.0}, {"tip_chamfer": 1e-4})
    ],
}


@pytest.mark.parametrize("name", PARTS)
def test_a_value_is_never_taken_for_a_missing_one(name):
    """Without clearance a 6308 has that of its class, and a NUP 208 E has axial play: neither is 0."""
    assert len({content_hash(part) for part in PARTS[name]}) == len(PARTS[name])


def test_single_planets_without_mesh_data():
    """The hash of this file before the meshes of single planets had data of their own."""
    single = "planets: 3\nsingle_planets: {planet_1: {tooth_thickness_allowance: 10 um}}"
    assert content_hash(loads_model(stage_file(single))) == "7aa521b84bb26dae"


def test_backlash_has_the_hash_that_it_had_without_a_factor():
    assert content_hash(Backlash(normal=1e-4)) == "43a5f1e44f8a49f4"
