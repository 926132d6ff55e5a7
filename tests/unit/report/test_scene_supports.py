# SPDX-License-Identifier: Apache-2.0
"""Symbols of parts in a scene: position, body they move with, note that they are symbols."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.geometry.triangle_file import join_corners
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.scene import shapes
from pitchpoint.report.scene.build import scene_of
from pitchpoint.viz.scene.file import scene_texts
from tests.support.scene_reader import Seen
from tests.unit.report.test_scene import CARRIER, PAIR


def drawn(text):
    return Seen(*scene_texts(scene_of(loads_model(text))))


def volume(surface):
    corners = surface[0][surface[1]]
    return np.einsum("ni,ni->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6.0


def is_closed(surface):
    _, triangles = join_corners(surface[0][surface[1]])
    edges = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]).tolist()
    one_way = set(map(tuple, edges))
    return len(one_way) == len(edges) and {(b, a) for a, b in one_way} == one_way


def polygon(n):
    """Area of a polygon over that of its circle."""
    return n / (2.0 * np.pi) * np.sin(2.0 * np.pi / n)


@pytest.mark.parametrize(
    ("surface", "exact"),
    [
        (shapes.disc(0.2, 0.1, sides=48), np.pi * 0.04 * 0.1 * polygon(48)),
        (shapes.disc(0.2, 0.1, 0.1, sides=48), np.pi * 0.03 * 0.1 * polygon(48)),
        (shapes.rod([1, 2, 3], [1, 2.5, 3], 0.02, 16), np.pi * 4e-4 * 0.5 * polygon(16)),
        (shapes.box((0.1, 0.2, 0.3), (1, 1, 1)), 0.006),
        (shapes.plate([[1, 0], [0, 1], [-1, 0], [0, -1]], 0.5), 1.0),
    ],
    ids=["disc", "ring", "rod", "box", "plate"],
)
def test_simple_surfaces_are_closed_and_hold_their_volume(surface, exact):
    assert is_closed(surface)
    assert volume(surface) == pytest.approx(exact, rel=1e-9)


def test_a_ball_and_a_coil_are_closed_with_their_outside_out():
    assert volume(shapes.ball(0.1, sides=64)) == pytest.approx(4e-3 / 3 * np.pi, rel=5e-3)
    points, triangles = shapes.coil(0.02, 0.003, 5)
    assert (points[:, 2].min(), points[:, 2].max()) == pytest.approx((0.0, 1.0), abs=0.02)
    # a tube along a helix: its length times its section; 14 chords a turn and the mitres between them
    # take away 1 - sin(a)/a cos(a), a = pi/14: 3 %
    long = 2.0 * 0.02 * 5
    exact = (
        np.sin(np.pi / 7) / (np.pi / 7) * np.pi * 0.003**2 * polygon(6) * np.hypot(2 * np.pi * 0.02 * 5, long)
    )
    assert volume((points * [1, 1, long], triangles)) == pytest.approx(exact, rel=0.01)


def test_rings_of_a_bearing_turn_with_their_body_or_stand_still():
    """In the middle of a gear they are drawn on both sides of it, and told to be no measure."""
    scene = drawn(PAIR.format(z="[1, 0, 0]", x="[0, 1, 0]"))
    solids = {s["name"] for s in scene.header["solids"]}
    assert {"bearing s1, inner ring", "bearing s1, outer ring", "housing (frame)"} <= solids
    rings = [s for s in scene.header["solids"] if s["name"].startswith("bearing s1")]
    bodies = {s["name"]: s["body"] for s in rings}
    assert bodies["bearing s1, inner ring"] == scene.body("first") and bodies["bearing s1, outer ring"] == -1
    assert all(s["schematic"] for s in rings) and len(rings) == 4
    middle = np.array([0.01, 0.02, 0.03])
    for ring in rings:
        points = scene.array(ring["points"]).astype(float)
        inner = ring["body"] >= 0
        origin, axes = scene.rest(ring["body"]) if inner else (np.zeros(3), np.eye(3))
        place = origin + axes @ np.array(ring["place"])
        # on the axis of the first body, which lies along x, next to its face
        assert place[1:] == pytest.approx(middle[1:], abs=1e-9)
        assert abs(place[0] - middle[0]) > 15e-3
        assert points[:, 2].max() < 15e-3
    notes = " ".join(scene.header["notes"])
    assert "linear bearings are drawn in catalogue sizes" in notes and "frames around gears" in notes


def test_a_frame_for_the_housing_holds_all_gears():
    scene = drawn(PAIR.format(z="[0, 0, 1]", x="[1, 0, 0]"))
    frame = scene.solid("housing (frame)")
    assert frame["see_through"] and frame["schematic"] and frame["body"] == -1
    box = scene.array(frame["points"])
    for gear in "ab":
        points = scene.placed(gear, 0)
        assert (points.min(axis=0) > box.min(axis=0)).all() and (points.max(axis=0) < box.max(axis=0)).all()


def test_a_carrier_has_a_plate_and_a_pin_where_its_planet_turns():
    scene = drawn(CARRIER)
    solid = scene.solid("carrier (carrier)")
    assert solid["kind"] == "carrier" and solid["body"] == scene.body("carrier")
    points = scene.placed("carrier (carrier)", 0)
    pin = points[points[:, 2] > 0.0]
    assert pin[:, :2].mean(axis=0) == pytest.approx([42e-3, 0.0], abs=1e-3)
    plate = points[points[:, 2] < -0.0101]
    assert np.hypot(plate[:, 0], plate[:, 1]).max() > 42e-3


CAM = """\
bodies:
  shaft: {motion: torsion, inertia: 0.02 kg m^2, position: [0, 0, 0], markers: {cam: {position: [0, -4 mm, 0]}}}
  follower: {mass: 1 kg, position: [0, 24 mm, 0], markers: {top: {position: [0, 60 mm, 0]}}}
joints:
  guide: {type: prismatic, bodies: [ground, follower], position: [0, 24 mm, 0], axes: {z: [0, 1, 0]}}
springs:
  valve: {ends: [follower.top, ground], stiffness: 20 N/mm, free_length: 20 mm}
cam_contacts:
  roller:
    ends: [follower, shaft.cam]
    curve: {shape: circle, radius: 18 mm}
    radius: 10 mm
    law: {force: 1 kN, depth: 2 um, exponent: 1}
surface_contacts:
  stop: {ends: [follower, ground], first: {shape: sphere, radius: 3 mm}, second: {shape: plane}, law: {force: 1 N, depth: 1 mm}}
"""  # noqa: E501


def test_curves_and_surfaces_of_contacts_lie_where_they_touch():
    """The cam is a circle of 18 mm 4 mm off the axis, the roller one of 10 mm on the follower."""
    scene = drawn(CAM)
    cam, roller, ball = (
        scene.placed(n, 0) for n in ("roller, curve", "roller, roller", "stop, first surface")
    )
    rim = np.hypot(cam[:, 0], cam[:, 1] + 4e-3)
    assert rim.max() == pytest.approx(18e-3, rel=1e-6)
    assert np.hypot(roller[:, 0], roller[:, 1] - 24e-3).max() == pytest.approx(10e-3, rel=1e-6)
    assert np.linalg.norm(ball - [0, 24e-3, 0], axis=1) == pytest.approx(3e-3 * np.ones(len(ball)), rel=1e-5)
    assert roller[:, 1].min() == pytest.approx(cam[:, 1].max(), abs=1e-6)
    spring = scene.solid("valve")
    assert spring["kind"] == "spring" and spring["between"]["bodies"] == [scene.body("follower"), -1]
    coil = scene.placed("valve", 0)
    assert coil[:, 1].max() == pytest.approx(84e-3, abs=2e-3) and coil[:, 1].min() == pytest.approx(
        0, abs=2e-3
    )
    assert any("without a shape in the model" in note for note in scene.header["notes"])
