# SPDX-License-Identifier: Apache-2.0
"""Which components of a model belong to its planets, and the groups of their curves."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.report.scene.planets import grouped, planet_members
from pitchpoint.viz.scene.content import SceneChannel
from tests.support.planet_gearboxes import ravigneaux
from tests.support.planet_stages import planet_set

ON_BEARINGS = """\
gears:
  sun: {{number_of_teeth: 21, normal_module: 4 mm, face_width: 40 mm, profile_shift_coefficient: 0}}
  {gears}
bodies:
  sun: {{gears: [sun], position: [0, 0, 0]}}
  frame: {{motion: {motion}, inertia: 0.5 kg m^2, mass: 10 kg, position: [0, 0, 0]}}
  {bodies}
bearings:
  {bearings}
meshes:
  {meshes}
"""


def on_bearings(housing: str, motion: str = "torsion"):
    """Three planets on two bearings each, on a carrier or on ground, without a ring."""
    arm = 0.5 * 4.0 * (21 + 39)
    places = [arm * np.array([np.cos(a), np.sin(a)]) for a in 2 * np.pi * np.arange(3) / 3]
    parts = {
        "gears": [
            f"p{k}: {{number_of_teeth: 39, normal_module: 4 mm, face_width: 40 mm, "
            "profile_shift_coefficient: 0}"
            for k in range(3)
        ],
        "bodies": [
            f"b{k}: {{gears: [p{k}], position: [{x!r} mm, {y!r} mm, 0]}}"
            for k, (x, y) in enumerate((float(x), float(y)) for x, y in places)
        ],
        "bearings": [
            f"n{k}{side}: {{body: b{k}, {housing} position: [0, 0, {z} mm], stiffness: {{radial: 1e8 N/m}}}}"
            for k in range(3)
            for side, z in (("a", -30), ("b", 30))
        ],
        "meshes": [
            f"s{k}: {{gears: [sun, p{k}], stiffness: {{law: constant, value: 5e8 N/m}}}}" for k in range(3)
        ],
    }
    return loads_model(ON_BEARINGS.format(motion=motion, **{k: "\n  ".join(v) for k, v in parts.items()}))


@pytest.mark.parametrize(("teeth", "count"), [((21, 39, 99), 3), ((25, 35, 95), 5)])
def test_meshes_and_bodies_of_planets_belong_together(teeth, count):
    found = planet_members(planet_set(*teeth, count))
    for k in range(count):
        assert found[f"s{k}"] == ("planets with sun", k + 1)
        assert found[f"r{k}"] == ("planets with ring", k + 1)
        assert found[f"b{k}"] == ("planets", k + 1)
        assert found[f"pin{k}"] == ("pins of planets", k + 1)
    assert not {"sun", "ring", "carrier"} & set(found)


def test_planets_on_bearings_are_those_of_their_carrier():
    found = planet_members(on_bearings("housing: frame,"))
    assert found["n1a"] == ("bearings 1 of planets", 2) and found["n2b"] == ("bearings 2 of planets", 3)
    assert found["s2"] == ("planets with sun", 3)


def test_equal_gears_on_ground_are_no_planets():
    """Three equal wheels around a pinion, on bearings in the housing."""
    assert planet_members(on_bearings("")) == {}


@pytest.mark.parametrize(
    "name", ["shovel-gearbox/model.yaml", "camshaft-drive/train.yaml", "phm-2009-rig/model.yaml"]
)
def test_gearboxes_without_planets_have_no_groups(name):
    assert planet_members(load_model(f"examples/{name}")) == {}


def test_channels_get_the_name_of_their_group():
    names = ["normal_force[s0]", "normal_force[s1]", "normal_force[r2]", "displacement[b1.x]", "speed[sun]"]
    channels = [
        SceneChannel(
            name=name,
            label=name.split("[")[0].replace("_", " ") + ", " + name.split("[")[1][:-1].replace(".", " "),
            unit="N",
            shown_unit="N",
            scale=1.0,
            times=np.zeros(1),
            least=np.zeros(1),
            most=np.zeros(1),
            mean=np.zeros(1),
        )
        for name in names
    ]
    found = grouped(channels, planet_set(21, 39, 99, 3))
    assert [(c.group, c.group_label, c.planet) for c in found] == [
        ("normal_force[planets with sun]", "normal force, planets with sun", 1),
        ("normal_force[planets with sun]", "normal force, planets with sun", 2),
        ("normal_force[planets with ring]", "normal force, planets with ring", 3),
        ("displacement[planets.x]", "displacement, planets x", 2),
        ("", "", 0),
    ]


def test_planets_in_series_have_the_names_of_their_stages():
    found = planet_members(loads_model(ravigneaux()))
    assert found["small_sun-short_2"] == ("planets of short with small_sun", 2)
    assert found["long_3-ring"] == ("planets of long with ring", 3)
    assert found["short_1-long_1"] == ("planets of long with short", 1)
    assert found["short_3-pin"] == ("pins of planets of short", 3)
