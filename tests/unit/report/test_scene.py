# SPDX-License-Identifier: Apache-2.0
"""Scenes of results: bodies where the kernels have them, teeth that mesh, forces in balance."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.scene.build import scene_of
from pitchpoint.system import evaluate
from pitchpoint.viz.scene.file import scene_texts
from tests.support.scene_models import CARRIER, PAIR, seen
from tests.support.scene_reader import Seen
from tests.support.scene_shapes import depth, end_face, inside


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
