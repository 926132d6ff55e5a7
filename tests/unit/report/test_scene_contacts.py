# SPDX-License-Identifier: Apache-2.0
"""Contacts of scenes: forces in balance, lines and flanks where involute geometry has them."""

from __future__ import annotations

import math

import numpy as np
import pytest
import xarray as xr

from pitchpoint.report.scene.build import scene_of
from pitchpoint.viz.scene.file import scene_texts
from tests.support.model_files import TORSIONAL_PAIR
from tests.support.scene_models import CARRIER, PAIR, seen
from tests.support.scene_reader import Seen
from tests.support.scene_shapes import depth, end_face

LYING = PAIR.format(z="[1, 0, 0]", x="[0, 1, 0]")
SPUR = CARRIER.replace("{law: constant, value: 3e8 N/m}", "{law: din3990}").replace("0.4 s", "0.1 s")
BETA, ALPHA_N, MODULE = math.radians(15.0), math.radians(20.0), 3e-3
ALPHA_T = math.atan(math.tan(ALPHA_N) / math.cos(BETA))
GEARS = {"a": (23, 0.2, -1), "b": (41, 0.0, 1)}
"""Teeth, profile shift and hand of the gears of the pair."""


@pytest.fixture(scope="module")
def pair():
    return seen(LYING)


@pytest.fixture(scope="module")
def carrier():
    return seen(SPUR)


def frames_of(scene: Seen) -> range:
    return range(0, len(scene.times), max(1, len(scene.times) // 17))


def test_pairs_share_the_force_of_their_mesh(pair):
    scene, _, result = pair
    contact = scene.contact("m")
    (flank,) = contact["flanks"]
    forces = scene.array(flank["forces"])
    whole = result["mesh_force[m]"].values
    # each of the four slots is off by at most half a step, of which the largest force has 8191
    assert np.abs(forces.sum(axis=1) - whole).max() < 2.01 * np.abs(forces).max() / 8191
    for frame in frames_of(scene):
        lines = scene.lines(contact, 1, frame)
        assert sum(line["force"] for line in lines.values()) == pytest.approx(whole[frame], rel=1e-4)
        assert 2 <= len(lines) <= 4  # total contact ratio 2.3


def test_loads_along_a_line_add_up_to_the_force_of_its_pair(pair):
    """Simpson's rule between nine places: exact for the parabola of the law along a line that is whole on the
    face; 8 bits of the largest load are 0.2 %."""
    scene, _, _ = pair
    contact = scene.contact("m")
    tried = 0
    for frame in range(len(scene.times)):
        for line in scene.lines(contact, 1, frame).values():
            length = line["z"][-1] - line["z"][0]
            if length < 0.6 * (contact["width"][1] - contact["width"][0]):
                continue
            weights = np.array([1, 4, 2, 4, 2, 4, 2, 4, 1]) / 24.0
            assert length * weights @ line["loads"] == pytest.approx(line["force"], rel=0.012)
            tried += 1
    assert tried > 100


def test_meshes_and_bearings_hold_each_other(pair):
    """In the mean nothing accelerates: on gear 2 the mesh and its bearing add up to nothing, and the bearing
    of gear 1 carries what the mesh pushes back with."""
    scene, _, _ = pair
    mean = {
        name: np.mean([scene.force(name, k) for k in range(len(scene.times))], axis=0)
        for name in ("m", "s1", "s2")
    }
    size = np.linalg.norm(mean["m"])
    assert size > 3000.0
    assert np.linalg.norm(mean["m"] + mean["s2"]) < 2e-3 * size
    assert np.linalg.norm(mean["m"] - mean["s1"]) < 2e-3 * size
    for name, body in (("s1", "first"), ("s2", "second")):
        arrow = scene.arrow(name)
        place, axes = scene.rest(scene.body(body))
        assert np.allclose(scene.array(arrow["at"])[0], place, atol=3e-5)
        assert set(arrow["components"]) == {"radial", "axial"}
        axial = scene.array(arrow["components"]["axial"])
        assert np.abs(axial @ axes[:, :2]).max() < 1e-3 * np.abs(axial).max()


def test_contact_lines_lean_by_the_base_helix_angle(pair):
    """sin(beta_b) = sin(beta) cos(alpha_n), left hand negative; lines of a mesh are a base pitch apart."""
    scene, _, _ = pair
    contact = scene.contact("m")
    beta_b = -math.asin(math.sin(BETA) * math.cos(ALPHA_N))
    assert contact["base_helix"] == pytest.approx(beta_b, rel=1e-12)
    assert contact["base_pitch"] == pytest.approx(math.pi * MODULE / math.cos(BETA) * math.cos(ALPHA_T))
    _, axes = scene.rest(scene.body("first"))
    for frame in frames_of(scene):
        lines = scene.lines(contact, 1, frame)
        for line in lines.values():
            along = line["points"][-1] - line["points"][0]
            lean = math.acos(along @ axes[:, 2] / np.linalg.norm(along))
            # the bearings yield by 3 kN over 1e6 N m/rad and 1e8 N/m
            assert lean == pytest.approx(abs(beta_b), abs=2e-4)


def developed(points: np.ndarray, teeth: int, hand: int, sign: int) -> np.ndarray:
    """Angle of points of a flank in the frame of their gear, less that of the involute and of the helix."""
    r_b = 0.5 * teeth * MODULE / math.cos(BETA) * math.cos(ALPHA_T)
    r = np.hypot(points[..., 0], points[..., 1])
    alpha = np.arccos(np.minimum(r_b / r, 1.0))
    helix = hand * points[..., 2] * math.tan(BETA) * 2.0 * math.cos(BETA) / (teeth * MODULE)
    angle = np.arctan2(points[..., 1], points[..., 0]) - sign * (np.tan(alpha) - alpha) - helix
    return np.unwrap(angle.ravel())


def half_angle(teeth: int, shift: float, backlash: float) -> float:
    """Half of the angle of a tooth at the base circle; a quarter of the backlash off each flank."""
    r_b = 0.5 * teeth * MODULE / math.cos(BETA) * math.cos(ALPHA_T)
    half = (0.5 * math.pi + 2.0 * shift * math.tan(ALPHA_N)) / teeth + math.tan(ALPHA_T) - ALPHA_T
    return half - 0.25 * backlash / r_b


def test_painted_flanks_are_those_of_the_numbered_teeth(pair):
    """Left flanks, counter-clockwise of the middle of the tooth that is named, to 1 um (2e-5 rad): screws of
    the involute of the base circle, with the backlash of 0.1 mm normal to the flanks."""
    scene, system, _ = pair
    backlash = 0.1e-3 / math.sqrt(1.0 - (math.sin(BETA) * math.cos(ALPHA_N)) ** 2)
    for surface in scene.contact("m")["flanks"][0]["surfaces"]:
        teeth, shift, hand = GEARS[surface["gear"]]
        angle = developed(scene.array(surface["points"]).astype(float), teeth, hand, -1)
        assert np.ptp(angle) < 3e-5
        tooth = system.model.phasing.tooth_angle[surface["gear"]] + 2 * math.pi * surface["tooth"] / teeth
        off = angle.mean() - tooth - half_angle(teeth, shift, backlash)
        assert abs((off + math.pi) % (2 * math.pi) - math.pi) < 5e-5


def test_contact_lines_lie_on_the_flanks_of_both_gears(pair):
    """Every line, seen from each gear, is on the flank of the tooth that its pair makes."""
    scene, _, _ = pair
    contact = scene.contact("m")
    for surface in contact["flanks"][0]["surfaces"]:
        teeth, _, hand = GEARS[surface["gear"]]
        flank = developed(scene.array(surface["points"]).astype(float), teeth, hand, -1).mean()
        for frame in frames_of(scene):
            origin, axes = scene.pose(surface["body"], frame)
            for pair_number, line in scene.lines(contact, 1, frame).items():
                angle = developed((line["points"] - origin) @ axes, teeth, hand, -1)
                off = angle - flank - surface["turn"] * pair_number
                # flanks go 5 um into each other, half of it each, over base radii of 33 mm and more
                assert np.abs((off + math.pi) % (2 * math.pi) - math.pi).max() < 2e-4


@pytest.mark.parametrize(("name", "side"), [("sp", 1), ("pr", -1)])
def test_lines_of_planets_lie_between_drawn_teeth(carrier, name, side):
    """Spur teeth, one of them a ring: the end of every line that carries a force is on the outlines of both
    gears, but for the deflection (some 5 um) and the chords of drawn flanks (0.3 % of a module, 6 um)."""
    scene, _, result = carrier
    contact = scene.contact(name)
    whole = result[f"mesh_force[{name}]"].values
    gears = {"sp": ("sun", "p1"), "pr": ("p1", "ring")}[name]
    for frame in list(frames_of(scene))[::4]:
        origin, axes = scene.mesh_frame(contact, frame)[:2]
        lines = scene.lines(contact, side, frame).values()
        assert sum(line["force"] for line in lines) == pytest.approx(whole[frame], rel=2e-3)
        outlines = [end_face(scene, gear, frame, origin, axes) for gear in gears]
        carrying = [line for line in lines if line["force"]]
        assert carrying
        for line in carrying:
            end = ((line["points"][-1] - origin) @ axes)[:2]
            assert max(depth(end, outline) for outline in outlines) < 15e-6


def test_what_a_result_does_not_keep_comes_from_the_same_places(pair):
    """Without damping: in the mean of a steady run within a percent, and it is reported."""
    scene, system, result = pair
    dropped = [n for n in result.data_vars if str(n).startswith(("pair_force", "bearing_force", "radial"))]
    again = scene_of(system.model, result.drop_vars(dropped))
    assert any("s1" in note and "without damping" in note for note in again.notes)
    short = Seen(*scene_texts(again))
    for name in ("m", "s1", "s2"):
        kept, found = (np.mean([s.force(name, k) for k in range(400)], axis=0) for s in (scene, short))
        assert np.linalg.norm(found - kept) < 0.01 * np.linalg.norm(kept)
    forces = [s.array(s.contact("m")["flanks"][0]["forces"]).sum(axis=1).mean() for s in (scene, short)]
    assert forces[1] == pytest.approx(forces[0], rel=0.01)


def test_penetration_of_both_flanks_follows_from_the_channels(pair):
    """Deep plus apart is the whole backlash, 0.1 mm normal to the flanks at the centre distance of the
    drawing, and the bearings yield by 3 kN / (2e8 N/m) each, which opens it by 2 sin(alpha) of that."""
    scene, _, result = pair
    front, back = scene.array(scene.contact("m")["penetration"]).T
    assert np.abs(front - result["penetration[m]"].values).max() < 1.01 * np.ptp(front) / 4094
    radial = 2.0 * 1098.0 / 2e8
    # tangent of the working angle times cos(beta_b) is close to that of the normal angle
    assert -(front + back) == pytest.approx(0.1e-3 + 2.0 * radial * math.sin(math.radians(20.7)), rel=0.01)


def test_laws_without_pairs_carry_no_loads(tmp_path):
    scene, _, _ = seen(TORSIONAL_PAIR.replace("duration: 0.5 s", "duration: 0.01 s"), "steady")
    (contact,) = scene.header["contacts"]
    assert "loads" not in contact["flanks"][0]
    assert any("has no single tooth pairs" in note for note in scene.header["notes"])
    # what is known without pairs is there: where lines would be, and the gap
    assert len(scene.array(contact["flanks"][0]["travel"])) == len(scene.times)
    assert contact["base_pitch"] == pytest.approx(math.pi * 3e-3 * math.cos(math.radians(20.0)))


def test_rings_of_rolling_bearings_push_where_they_are():
    """A pinion on two ball bearings and a soft support: they carry what the mesh pushes back with."""
    rolling = "elements: 11, element_diameter: 10 mm, pitch_diameter: 60 mm, stiffness: 8e9, damping: 0.05"
    markers = "markers: {l: {position: [0, 0, -40 mm]}, h: {position: [0, 0, 40 mm]}}"
    place = "position: [10 mm, 20 mm, 30 mm]"
    text = PAIR.format(z="[0, 0, 1]", x="[1, 0, 0]")
    text = text.replace(place, f"{place}, {markers}")
    text = text.replace("bodies:\n", f"bodies:\n  house: {{motion: fixed, {place}, {markers}}}\n")
    text = text.replace("first, stiffness: {radial: 2e8 N/m", "first, stiffness: {radial: 1e7 N/m")
    bearings = "".join(f"  r{e}: {{ends: [first.{e}, house.{e}], {rolling}}}\n" for e in "lh")
    text = text.replace("loads:\n", f"rolling_bearings:\n{bearings}loads:\n")
    scene, _, _ = seen(text)
    half = len(scene.times) // 2  # the bearings have settled
    names = ("m", "s1", "rl", "rh")
    mean = {n: np.mean([scene.force(n, k) for k in range(half, 2 * half)], axis=0) for n in names}
    size = np.linalg.norm(mean["m"])
    assert np.linalg.norm(mean["s1"] + mean["rl"] + mean["rh"] - mean["m"]) < 5e-3 * size
    assert min(np.linalg.norm(mean[n]) for n in ("rl", "rh")) > 0.2 * size
    origin, _ = scene.rest(scene.body("first"))
    heights = [float(scene.array(scene.arrow(n)["at"])[0][2] - origin[2]) for n in ("rl", "rh")]
    assert heights == pytest.approx([-0.04, 0.04], abs=1e-4)


def test_a_result_of_another_state_of_the_model_says_so(pair):
    _, system, result = pair
    changed: xr.Dataset = result.assign_attrs(model_hash="another")
    assert any("different version" in note for note in scene_of(system.model, changed).notes)
    assert not any("different version" in note for note in scene_of(system.model, result).notes)
