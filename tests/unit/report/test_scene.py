# SPDX-License-Identifier: Apache-2.0
"""Scenes of results: bodies where the kernels have them, teeth that mesh, forces in balance."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.scene import scene_of
from pitchpoint.solvers.time import solve_time
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.viz.scene_file import scene_texts
from tests.support.scene_reader import Seen

PAIR = """\
title: helical pair in bearings
gears:
  a: {{number_of_teeth: 23, normal_module: 3 mm, helix_angle: 15 deg, hand: left, face_width: 30 mm, profile_shift_coefficient: 0.2}}
  b: {{number_of_teeth: 41, normal_module: 3 mm, helix_angle: 15 deg, hand: right, face_width: 30 mm, profile_shift_coefficient: 0}}
bodies:
  first: {{gears: [a], motion: free, axes: {{z: {z}, x: {x}}}, position: [10 mm, 20 mm, 30 mm]}}
  second: {{gears: [b], motion: free}}
meshes:
  m: {{gears: [a, b], direction: 25 deg, stiffness: {{law: din3990}}, damping: {{ratio: 0.1}}, backlash: {{normal: 0.1 mm}}}}
bearings:
  s1: {{body: first, stiffness: {{radial: 2e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}}, damping: {{ratio: 0.1}}}}
  s2: {{body: second, stiffness: {{radial: 2e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}}, damping: {{ratio: 0.1}}}}
loads:
  in: {{body: first, torque: 100 N m}}
  out: {{body: second, torque: balance}}
scenarios:
  on: {{speed: {{first: 600 rpm}}, duration: 0.2 s, sample_rate: 2 kHz}}
"""  # noqa: E501


def seen(text: str, scenario: str = "on"):
    model = loads_model(text)
    system = compile_model(model, scenario)
    result = solve_time(system)
    return Seen(*scene_texts(scene_of(model, result))), system, result


@pytest.fixture(scope="module", params=["upright", "lying"])
def pair(request):
    axes = {"upright": ("[0, 0, 1]", "[1, 0, 0]"), "lying": ("[1, 0, 0]", "[0, 1, 0]")}[request.param]
    return seen(PAIR.format(z=axes[0], x=axes[1]))


def kernel_frames(system, result, sample):
    """World frames by the compiled core, spin included, from the channels of one sample."""
    state = system.initial_state()
    for k, name in enumerate(system.layout.coordinates):
        body, _, coordinate = name.rpartition(".")
        word = {"alpha": "rx", "beta": "ry"}.get(coordinate, coordinate)
        channel = f"angle[{body}]" if coordinate == "spin" else f"displacement[{body}.{word}]"
        state.q[k] = float(result[channel].values[sample])
    evaluate.residual(system, state)
    frames = system.workspace.fr
    c, s = np.cos(frames["phi"]), np.sin(frames["phi"])
    spun = frames["R"].copy()
    for k in range(len(spun)):
        spun[k] = frames["R"][k] @ np.array([[c[k], -s[k], 0], [s[k], c[k], 0], [0, 0, 1]])
    return frames["r"].copy(), spun


def test_bodies_stand_where_the_kernels_have_them(pair):
    """To 1/65535 of what each track moves over: some nanometres, and 1e-6 rad of the spin."""
    scene, system, result = pair
    for frame in (0, len(scene.times) // 3, len(scene.times) - 1):
        sample = int(np.argmin(np.abs(result["time"].values - scene.times[frame])))
        places, axes = kernel_frames(system, result, sample)
        for b, name in enumerate(system.layout.bodies[1:], start=1):
            place, turned = scene.pose(scene.body(name), frame)
            assert np.allclose(place, places[b], atol=2e-9)
            assert np.allclose(turned, axes[b], atol=2e-6)


def end_face(scene, name, frame, origin, axes):
    """Edges of a gear's upper end face, shape (n, 2, 2), in the plane across the axes: those of triangles of
    the flanks, which have their third corner elsewhere."""
    points, triangles = scene.mesh(name)
    height = points[:, 2]
    at_end = np.isclose(height, height.max(), atol=1e-9)[triangles]
    flanks = at_end.sum(axis=1) == 2
    pairs = triangles[flanks][at_end[flanks]].reshape(-1, 2)
    return ((scene.placed(name, frame) - origin) @ axes)[:, :2][pairs]


def inside(points, edges):
    """Which points lie inside of closed lines (even-odd rule)."""
    x, y = points[:, :1], points[:, 1:]
    (x0, y0), (x1, y1) = edges[:, 0].T, edges[:, 1].T
    rise = np.where(y1 == y0, 1.0, y1 - y0)
    return (((y0 > y) != (y1 > y)) & (x < x0 + (y - y0) / rise * (x1 - x0))).sum(axis=1) % 2 == 1


def depth(point, edges):
    """Distance of a point from the nearest edge [m]."""
    start, along = edges[:, 0], edges[:, 1] - edges[:, 0]
    length = (along**2).sum(axis=1)
    share = np.clip(((point - start) * along).sum(axis=1) / np.where(length > 0.0, length, 1.0), 0.0, 1.0)
    return np.hypot(*(start + share[:, None] * along - point).T).min()


def test_drawn_teeth_mesh_without_cutting_into_each_other(pair):
    """Turned by a pitch against each other they would overlap by whole teeth; drawn right, no corner of one
    gear lies in the other by more than the deflection under load (3 kN over some 400 N/um, 8 um) and the
    chords of drawn flanks (0.2 % of a module, 6 um)."""
    scene, _, _ = pair
    for frame in range(0, len(scene.times), len(scene.times) // 7):
        origin, axes = scene.pose(scene.body("first"), frame)
        one, two = (end_face(scene, name, frame, origin, axes) for name in "ab")
        corners, middle = one[:, 0], two.mean(axis=(0, 1))
        within = corners[inside(corners, two)]
        deepest = max((depth(corner, two) for corner in within), default=0.0)
        assert deepest < 15e-6
        # and they do mesh: teeth of a reach far into the tip circle of b
        tips = np.hypot(*(two[:, 0] - middle).T).max()
        assert np.hypot(*(corners - middle).T).min() < tips - 5e-3


def test_force_arrows_hold_gear_2_against_its_bearing_and_load(pair):
    """In the mean over whole mesh cycles, nothing accelerates: mesh force + bearing force = 0, and its moment
    about the axis is that of the load."""
    scene, system, result = pair
    mean = np.mean([scene.force("m", k) for k in range(len(scene.times))], axis=0)
    _, axes = scene.rest(scene.body("second"))
    held = [float(result[f"bearing_force[s2.{c}]"].mean()) for c in ("fx", "fy", "fz")]
    assert np.allclose(mean @ axes, -np.array(held), atol=2e-3 * np.linalg.norm(mean))
    place, _ = scene.rest(scene.body("second"))
    at = scene.array(scene.arrow("m")["at"])[0]
    moment = np.cross(at - place, mean) @ axes[:, 2]
    assert abs(moment) == pytest.approx(100.0 * 41 / 23, rel=2e-3)


def test_a_model_without_result_is_drawn_at_rest():
    model = loads_model(PAIR.format(z="[0, 0, 1]", x="[1, 0, 0]"))
    scene = Seen(*scene_texts(scene_of(model)))
    assert len(scene.times) == 1
    assert {s["name"] for s in scene.header["solids"]} >= {"a", "b"}
    assert scene.header["arrows"] == [] and scene.header["channels"] == []


def test_the_same_scene_has_the_same_bits(pair):
    scene, system, result = pair
    again = scene_texts(scene_of(system.model, result))
    assert again == scene_texts(scene_of(system.model, result))


CARRIER = """\
title: planets on a carrier
gears:
  sun: {number_of_teeth: 24, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  p1: {number_of_teeth: 18, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  ring: {type: internal, number_of_teeth: 60, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0, tip_diameter: 118 mm}
bodies:
  sun: {gears: [sun], motion: torsion, position: [0, 0, 0], inertia: 0.01 kg m^2}
  carrier: {motion: torsion, position: [0, 0, 0], inertia: 0.05 kg m^2, mass: 2 kg}
  planet: {gears: [p1], inertia: 0.001 kg m^2, mass: 0.5 kg}
  rim: {gears: [ring], motion: fixed, position: [0, 0, 0]}
joints:
  pin: {type: revolute, bodies: [carrier, planet], position: [42 mm, 0, 0]}
meshes:
  sp: {gears: [sun, p1], stiffness: {law: constant, value: 3e8 N/m}, backlash: {base_tangent: 0.05 mm}, damping: {ratio: 0.05}}
  pr: {gears: [p1, ring], stiffness: {law: constant, value: 3e8 N/m}, backlash: {base_tangent: 0.05 mm}, damping: {ratio: 0.05}}
loads:
  in: {body: sun, torque: 20 N m}
  out: {body: carrier, torque: balance}
scenarios:
  on: {speed: {sun: 300 rpm}, duration: 0.4 s, sample_rate: 1 kHz}
"""  # noqa: E501


def test_planets_go_round_with_their_carrier():
    """Willis: at a fixed ring the carrier turns 24/(24 + 60) as fast as the sun; its planet keeps its
    distance."""
    scene, system, result = seen(CARRIER)
    planet = scene.header["bodies"][scene.body("planet")]
    assert scene.header["bodies"][planet["parent"]]["name"] == "carrier"
    turned = float(result["angle[sun]"][-1]) * 24 / 84
    place, _ = scene.pose(scene.body("planet"), len(scene.times) - 1)
    assert np.hypot(place[0], place[1]) == pytest.approx(42e-3, rel=1e-6)
    assert np.arctan2(place[1], place[0]) == pytest.approx(np.angle(np.exp(1j * turned)), abs=1e-3)
    arrow = scene.array(scene.arrow("sp")["at"])
    assert len(arrow) == len(scene.times)  # the pitch point goes round too
