# SPDX-License-Identifier: Apache-2.0
"""Contact lines of bevel meshes in a scene: on the flanks of both gears, with the forces of the result."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from pitchpoint.report.scene.bevel_gears import bevel_axes
from pitchpoint.report.scene.contact_lines import ContactLines
from pitchpoint.report.scene.motion import motion
from pitchpoint.report.scene.solids import drawn_allowances
from tests.support.bevel_teeth import PAIR, RUN, angles_inside
from tests.support.scene_models import seen

STRAIGHT = PAIR
for hand in ("left", "right"):
    STRAIGHT = STRAIGHT.replace(f"spiral_angle: 30 deg, hand: {hand}, ", "")
NARROW = PAIR.replace("face_width: 14 mm, bore_diameter: 25 mm", "face_width: 9 mm, bore_diameter: 25 mm")
CASES = {
    "spiral": (PAIR, 60, 1),
    "straight": (STRAIGHT, 60, 1),
    "backwards": (PAIR, -60, -1),
    "narrow mate": (NARROW, 60, 1),
}


@pytest.fixture(scope="module", params=CASES)
def machine(request):
    text, torque, side = CASES[request.param]
    return *seen(text + RUN % torque, "turn"), side


def in_gear(scene, model, name, points, frame):
    """Points in the frame of a gear whose tooth 0 is on the first axis; frame None: they turn with it."""
    body = model.body_of(name)
    apex = [0.0, 0.0, model.bodies[body].bevel_gears[name]]
    if frame is not None:
        origin, axes = scene.pose(scene.body(body), frame)
        points = (points - origin) @ axes
    return (points - apex) @ bevel_axes(model.bevel_gears[name], model.bevel_angles[name])


def drawn(model, name):
    gear = model.bevel_gears[name].geometry
    return replace(gear, thickness_allowance=-drawn_allowances(model)[name])


def test_lines_lie_on_the_flanks_of_both_gears(machine):
    """Flanks that are pressed together by x have given way by half of it each, as an angle x/(2 R_m sin δ_b).

    Tracks of the scene have 16 bits."""
    scene, system, result, side = machine
    contact = scene.contact("stage")
    pair = system.model.bevel_pairs["stage"]
    gap = 200e-6 / math.cos(pair.beta_b)
    tried = 0
    for frame in range(0, len(scene.times), 17):
        deep = side * float(result["transmission_error[stage]"][frame]) - 0.5 * gap
        assert 0.0 < deep < 50e-6
        for line in scene.lines(contact, side, frame).values():
            for name in ("pinion", "wheel"):
                gear = drawn(system.model, name)
                points = in_gear(scene, system.model, name, line["points"], frame)
                half = 0.5 * deep / pair.R_m / math.sin(gear.delta_b)
                assert angles_inside(gear, 0.0, points[1:-1]) == pytest.approx(half, abs=2e-6)
                tried += 1
    assert tried > 30


def test_forces_are_those_of_the_result_and_loads_add_up_to_them(machine):
    """Widths are z = R_m ln(R/R_m), dR = R/R_m dz; Simpson's rule between nine places is exact to 1 % beside
    kinks of the law, and loads have 8 bits."""
    scene, system, result, side = machine
    contact = scene.contact("stage")
    R_m = contact["cone"][0]
    assert R_m == pytest.approx(system.model.bevel_pairs["stage"].R_m)
    whole = result["mesh_force[stage]"].values
    compared = 0
    for frame in range(0, len(scene.times), 17):
        lines = scene.lines(contact, side, frame).values()
        # mesh_force times the base radius at R_m is the torque, which loads at R make by R / R_m
        torque = sum(line["force"] * _lever(line, R_m) for line in lines)
        assert torque == pytest.approx(whole[frame], rel=2e-2)
        for line in lines:
            width = line["z"][-1] - line["z"][0]
            if width < 0.5 * (contact["width"][1] - contact["width"][0]):
                continue
            weights = np.array([1, 4, 2, 4, 2, 4, 2, 4, 1]) / 24.0 * np.exp(line["z"] / R_m)
            assert width * weights @ line["loads"] == pytest.approx(side * line["force"], rel=0.02)
            compared += 1
    assert compared > 10


def _lever(line, R_m):
    """Mean of R / R_m over the loads of a line."""
    weights = np.array([1, 4, 2, 4, 2, 4, 2, 4, 1]) * line["loads"] * np.exp(line["z"] / R_m)
    return float(weights @ np.exp(line["z"] / R_m) / weights.sum()) if weights.sum() > 0.0 else 1.0


def test_painted_flanks_are_those_of_the_numbered_teeth(machine):
    scene, system, _, side = machine
    flank = next(f for f in scene.contact("stage")["flanks"] if f["side"] == side)
    for surface in flank["surfaces"]:
        gear = drawn(system.model, surface["gear"])
        points = scene.array(surface["points"]).astype(float)
        own = in_gear(scene, system.model, surface["gear"], points.reshape(-1, 3), None)
        assert np.abs(angles_inside(gear, 0.0, own)).max() < 2e-6
        R = np.linalg.norm(own, axis=1)
        turned = np.arctan2(own[:, 1], own[:, 0]) - gear.spiral_rate * np.log(R / gear.R_m)
        off = np.mean(np.exp(1j * turned)) * np.exp(-2j * math.pi * surface["tooth"] / gear.z)
        # less than half of a pitch next to the middle of the tooth that is named, on one side of it
        assert 0.1 < abs(np.angle(off)) * gear.z / (2.0 * math.pi) < 0.4
        assert surface["teeth"] == gear.z
        assert abs(surface["turn"]) == pytest.approx(2.0 * math.pi / gear.z)


@pytest.mark.parametrize("kind", ["spiral", "straight"])
def test_loads_of_gears_that_bearings_let_aside_are_those_of_the_kernel(kind):
    """On bearings of 50 N/µm apexes shift and axes lean; pair forces are those that the kernel kept,
    before they are brought to them."""
    text = CASES[kind][0].replace("bodies:\n  one: {", "bodies:\n  one: {motion: free, ")
    text = text.replace("  two: {", "  two: {motion: free, ")
    shafts = {"one": (40, 90), "two": (-90, -40)}
    text += "bearings:\n" + "".join(
        f"  {body}_{k}: {{body: {body}, position: [0, 0, {place} mm], "
        f"stiffness: {{radial: 5e7, axial: 5e7}}, damping: {{radial: 3e3, axial: 3e3}}}}\n"
        for body, places in shafts.items()
        for k, place in enumerate(places)
    )
    scenario = (RUN % 60).replace("duration: 20 ms", "duration: 4 ms")
    _, system, result = seen(text + scenario, "turn")
    count = result.sizes["time"]

    def read(name):
        return np.asarray(result[name].values) if name in result else None

    lines = ContactLines(system, read, count)
    motion(system, count, read, result["time"].values, lines.look)
    bevel = lines.meshes["stage"]
    kept = np.stack([result[f"pair_force[stage.{k}]"].values for k in range(bevel.pairs)], axis=1)
    largest = kept.max()
    loaded = kept > 0.2 * largest
    assert loaded.sum() > count // 2
    assert bevel.forces[:, 0][loaded] == pytest.approx(kept[loaded], abs=1e-5 * largest)
