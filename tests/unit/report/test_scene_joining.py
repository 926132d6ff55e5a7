# SPDX-License-Identifier: Apache-2.0
"""What joins bodies in a scene: where it is, what it moves with, and that wheels of ratios roll."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.model.sections import GROUPS
from pitchpoint.report.scene import shapes
from pitchpoint.report.scene.rest import rest_scene
from pitchpoint.report.scene.supports import covers
from pitchpoint.viz.scene.file import scene_texts
from tests.support.scene_reader import Seen

SINGLE = 1e-7
"""What single precision loses of lengths up to 1 m [m]."""
DOCS = Path(__file__).parents[3] / "docs"

PARTS = """\
title: what joins bodies
gears:
  a: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  b: {number_of_teeth: 40, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  housing: {motion: fixed, position: [0, 0, 0], markers: {seat: {position: [-45 mm, 0, 60 mm]}, mount: {position: [0, -100 mm, 0], axes: {z: [0, 1, 0]}}}}
  pinion: {gears: [a], motion: free, position: [-45 mm, 0, 0], markers: {end: {position: [0, 0, 60 mm]}}}
  wheel: {gears: [b], motion: free, position: [45 mm, 0, 0]}
  disc: {motion: torsion, inertia: 1e-4 kg m^2, position: [-45 mm, 0, 150 mm]}
  motor: {motion: torsion, inertia: 1e-4 kg m^2, position: [-45 mm, 0, 250 mm]}
  fan: {motion: torsion, inertia: 1e-4 kg m^2, position: [200 mm, 150 mm, 100 mm]}
  pump: {motion: torsion, inertia: 1e-4 kg m^2, position: [300 mm, 150 mm, 100 mm]}
  mill: {motion: torsion, inertia: 1e-4 kg m^2, position: [300 mm, 300 mm, 50 mm], axes: {z: [0, 0, -1]}}
  rack: {mass: 1 kg, position: [300 mm, 350 mm, 50 mm]}
  gauge: {mass: 1 kg, center_of_mass: [0, 0, 20 mm], position: [0, 0, 300 mm]}
joints:
  slide: {type: prismatic, bodies: [ground, rack], axes: {z: [1, 0, 0]}}
  probe: {type: prismatic, bodies: [ground, gauge], axes: {z: [0, 0, 1]}}
plain_bearings:
  journal: {ends: [pinion.end, housing.seat], clearance: 0.4 mm, stiffness: 1e8}
couplings:
  flange: {bodies: [motor, disc], position: [0, 0, -40 mm], stiffness: {torsion: 1e4}}
  offset: {bodies: [disc, wheel], stiffness: {torsion: 1e4}}
clutches:
  clutch: {bodies: [pinion, disc], capacity: 10 N m}
  brake: {bodies: [motor], capacity: 10 N m}
torsion_springs:
  coil: {bodies: [disc, motor], stiffness: 100}
  spiral: {bodies: [fan], stiffness: 10}
torsion_maxwells:
  beside: {bodies: [fan, pump], stiffness: 10, damping: 1}
bushings:
  mount: {ends: [housing.mount, ground], stiffness: {radial: 1e6, axial: 1e6}}
ratios:
  belt: {terms: {fan: 30 mm, pump: -50 mm}}
  rolls: {terms: {pump: 30, mill: -45}}
  teeth: {terms: {mill: 25 mm, slide.z: 1}}
  same: {terms: {motor: 1, disc: -2}}
unbalances:
  mass: {body: disc, mass: 20 g, position: [30 mm, 0, 0]}
actuators:
  jack: {type: strut, signal: way, ends: [housing.mount, gauge]}
sensors:
  way: {type: joint, coordinate: probe.z}
meshes:
  m: {gears: [a, b], stiffness: {law: din3990}, damping: {ratio: 0.1}}
"""  # noqa: E501

PLANETS = """\
bodies:
  sun: {motion: torsion, inertia: 1e-3 kg m^2, position: [0, 0, 0], markers: {rim: {position: [84 mm, 0, 0]}}}
  carrier: {motion: torsion, inertia: 1e-3 kg m^2, position: [0, 0, 0]}
  planet: {inertia: 1e-4 kg m^2, mass: 0.1 kg}
joints:
  pin: {type: revolute, bodies: [carrier, planet], position: [84 mm, 0, 0]}
ratios:
  train: {terms: {sun: 24, planet: 18, carrier: -24}}
"""


@pytest.fixture(scope="module")
def scene():
    return Seen(*scene_texts(rest_scene(loads_model(PARTS))))


def points(scene, name):
    """Points of a solid in the world, at rest."""
    return scene.placed(name, 0)


def body_of(scene, name):
    number = scene.solid(name)["body"]
    return "ground" if number < 0 else scene.header["bodies"][number]["name"]


def middle(cloud):
    """Middle of the box around points, which files keep in single precision [m]."""
    return 0.5 * (cloud.min(axis=0) + cloud.max(axis=0))


def about(cloud, place, axis=2):
    """Least and largest distance of points from a line through a place along a world axis [m]."""
    across = np.delete(cloud - place, axis, axis=1)
    far = np.hypot(*across.T)
    return far.min(), far.max()


def test_a_journal_has_its_clearance_in_the_bush(scene):
    place = np.array([-0.045, 0.0, 0.06])
    journal, bush = (f"bearing journal, {word}" for word in ("journal", "bush"))
    assert (body_of(scene, journal), body_of(scene, bush)) == ("pinion", "housing")
    inner, outer = about(points(scene, bush), place)[0], about(points(scene, journal), place)[1]
    assert inner - outer == pytest.approx(0.2e-3, abs=1e-8)
    # corners of the inner polygon and middles of its chords are apart by less than an eighth of the play
    sides = len(points(scene, bush)) // 5
    assert inner * (1.0 - np.cos(np.pi / sides)) < 0.2e-3 / 8.0
    assert middle(points(scene, bush)) == pytest.approx(place, abs=SINGLE)


@pytest.mark.parametrize(
    ("name", "bodies", "between"),
    [
        ("coupling flange", ("motor", "disc"), (0.15, 0.25)),
        ("clutch clutch", ("pinion", "disc"), (0.06, 0.15)),
    ],
)
def test_halves_face_each_other_between_their_bodies(scene, name, bodies, between):
    x = -0.045
    first, second = (points(scene, f"{name}, {body}") for body in bodies)
    assert [body_of(scene, f"{name}, {body}") for body in bodies] == list(bodies)
    for half in (first, second):
        assert half[:, 2].min() > between[0] - SINGLE and half[:, 2].max() < between[1] + SINGLE
        assert about(half, [x, 0, 0])[1] > 5e-3 and middle(half)[:2] == pytest.approx([x, 0.0], abs=SINGLE)
    low, high = sorted((first, second), key=lambda half: half[:, 2].mean())
    assert low[:, 2].max() < high[:, 2].min()
    if name.startswith("coupling"):
        assert 0.5 * (low[:, 2].max() + high[:, 2].min()) == pytest.approx(0.21, abs=SINGLE)


def test_a_brake_has_pads_on_ground_around_its_disc(scene):
    disc, pads = points(scene, "brake brake, motor"), points(scene, "brake brake, pads")
    assert (body_of(scene, "brake brake, motor"), body_of(scene, "brake brake, pads")) == ("motor", "ground")
    assert pads[:, 2].min() < disc[:, 2].min() and pads[:, 2].max() > disc[:, 2].max()
    assert about(pads, [-0.045, 0, 0])[1] > about(disc, [-0.045, 0, 0])[1]


def test_what_couples_two_axes_goes_from_one_to_the_other(scene):
    for name, ends in {
        "coupling offset": ([-0.045, 0, 0.15], [0.045, 0, 0]),
        "beside": ([0.2, 0.15, 0.1], [0.3, 0.15, 0.1]),
        "coil": ([-0.045, 0, 0.15], [-0.045, 0, 0.25]),
        "actuator jack": ([0, -0.1, 0], [0, 0, 0.3]),
    }.items():
        solid = scene.solid(name)
        for body, end, expected in zip(
            solid["between"]["bodies"], solid["between"]["ends"], ends, strict=True
        ):
            origin, axes = scene.rest(body)
            assert origin + axes @ np.array(end) == pytest.approx(expected, abs=1e-9), name
    spiral = points(scene, "spiral")
    assert np.ptp(spiral[:, 2]) < 0.3 * np.ptp(spiral[:, 0]) and body_of(scene, "spiral") == "fan"


def test_small_parts_are_where_the_model_has_them(scene):
    sleeve, ring = (points(scene, f"bushing mount, {word}") for word in ("sleeve", "ring"))
    assert (body_of(scene, "bushing mount, sleeve"), body_of(scene, "bushing mount, ring")) == (
        "housing",
        "ground",
    )
    for part in (sleeve, ring):
        assert middle(part) == pytest.approx([0, -0.1, 0], abs=SINGLE)
        # round about the axis of the marker, which lies along y
        assert np.ptp(part, axis=0)[0] == pytest.approx(np.ptp(part, axis=0)[2], rel=1e-5)
    assert about(ring, [0, -0.1, 0], axis=1)[0] > about(sleeve, [0, -0.1, 0], axis=1)[1]
    ball = points(scene, "unbalance mass")
    assert middle(ball) == pytest.approx([-0.015, 0, 0.15], abs=SINGLE)
    for name, place, axis in (("slide", [0.3, 0.35, 0.05], 0), ("probe", [0, 0, 0.3], 2)):
        rails = points(scene, f"joint {name}")
        assert middle(rails) == pytest.approx(place, abs=SINGLE) and about(rails, place, axis)[0] > 0.0
        assert np.ptp(rails, axis=0).argmax() == axis and body_of(scene, f"joint {name}") == "ground"


def rim(scene, name, place, axis=2):
    return about(points(scene, name), place, axis)[1]


def test_rims_of_a_ratio_have_one_speed_where_they_touch(scene):
    """fan : pump = 50 : 30 by a belt; the mill looks the other way, so -45 turns it against the pump."""
    fan, pump, mill = ([0.2, 0.15, 0], [0.3, 0.15, 0], [0.3, 0.3, 0])
    assert rim(scene, "ratio belt, fan", fan) == pytest.approx(0.03, rel=1e-6)
    assert rim(scene, "ratio belt, pump", pump) == pytest.approx(0.05, rel=1e-6)
    radii = [rim(scene, f"ratio rolls, {name}", place) for name, place in (("pump", pump), ("mill", mill))]
    assert radii == pytest.approx([0.06, 0.09], rel=1e-6)
    belt = points(scene, "ratio belt, belt")
    near = [np.hypot(*(belt[:, :2] - place[:2]).T).min() for place in (fan, pump)]
    assert near[0] >= 0.03 - 1e-6 and near[1] >= 0.05 - 1e-6
    assert len({s["name"] for s in scene.header["solids"] if s["name"].startswith("fan")}) == 0


def test_a_rack_goes_with_the_rim_of_its_pinion(scene):
    """0.025 m * turn + way = constant: the mill, whose axis is -z, moves the rack by -25 mm a radian."""
    bar = points(scene, "ratio teeth, rack")
    centre = np.array([0.3, 0.3, 0.05])
    edge = middle(bar) - centre
    assert rim(scene, "ratio teeth, mill", centre) == pytest.approx(0.025, rel=1e-6)
    touching = 0.025 * np.sign(np.round(edge, 9))
    velocity = np.cross([0.0, 0.0, -1.0], touching)
    assert velocity == pytest.approx([-0.025, 0.0, 0.0], abs=1e-9)
    assert np.abs(bar - centre)[:, 1].min() == pytest.approx(0.025, rel=1e-6)


def test_planets_of_a_ratio_roll_on_their_sun_and_what_cannot_be_drawn_is_told(scene):
    found = Seen(*scene_texts(rest_scene(loads_model(PLANETS))))
    assert rim(found, "ratio train, sun", [0, 0, 0]) == pytest.approx(0.048, rel=1e-6)
    assert rim(found, "ratio train, planet", [0.084, 0, 0]) == pytest.approx(0.036, rel=1e-6)
    assert body_of(found, "ratio train, planet") == "planet" and not found.header["notes"][1:]
    assert any("ratio same is not drawn" in note for note in scene.header["notes"])
    assert not any(s["name"].startswith("ratio same") for s in scene.header["solids"])


def test_a_solid_that_holds_bearings_is_seen_through(tmp_path):
    wall, triangles = shapes.box((0.3, 0.2, 0.2))
    np.save(tmp_path / "wall.npy", wall[triangles])
    solid = "solid: {file: wall.npy, unit: 1 m}"
    text = PARTS.replace("housing: {motion: fixed,", f"housing: {{motion: fixed, {solid},")
    text = text.replace("gauge: {mass: 1 kg, center_of_mass: [0, 0, 20 mm],", f"gauge: {{{solid},")
    model = tmp_path / "model.yaml"
    model.write_text(text, encoding="utf-8")
    found = Seen(*scene_texts(rest_scene(load_model(str(model)))))
    housing, gauge = found.solid("housing"), found.solid("gauge")
    assert housing["see_through"] and housing["kind"] == "housing" and "schematic" not in housing
    assert not gauge["see_through"] and gauge["kind"] == "body"
    assert np.abs(points(found, "housing")).max(axis=0) == pytest.approx([0.15, 0.1, 0.1], abs=1e-6)


def test_carriers_of_planets_are_covers_and_gears_are_none():
    text = PLANETS.replace("bodies:\n", "gears:\n  p: {number_of_teeth: 18, normal_module: 2 mm, face_width: 9 mm, profile_shift_coefficient: 0}\nbodies:\n")  # fmt: skip  # noqa: E501
    model = loads_model(text.replace("planet: {", "planet: {gears: [p], "))
    assert covers(model) == {"carrier": "carrier"}
    seat = "plain_bearings: {seat: {ends: [sun.rim, planet], clearance: 1 mm, stiffness: 1e6}}\n"
    assert covers(loads_model(text.replace("planet: {", "planet: {gears: [p], ") + seat)) == {
        "carrier": "carrier"
    }
    assert covers(loads_model(text + seat)) == {"planet": "carrier"}


def test_the_page_on_the_scene_speaks_of_all_parts_of_a_model():
    """Every section of a model file is named where docs/view.md lists what is drawn and what is not."""
    text = (DOCS / "view.md").read_text(encoding="utf-8")
    section = text.split("## What is drawn")[1].split("\n## ")[0]
    assert set(re.findall(r"`(\w+)`", section)) >= set(GROUPS) - {"scenarios"}
