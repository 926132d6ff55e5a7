# SPDX-License-Identifier: Apache-2.0
"""Gears of a scene: the mass that `pitchpoint mass` tells, faults where and as large as the model says."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.geometry.mass_properties import gear_mass_properties
from pitchpoint.geometry.tip_edge import sharp
from pitchpoint.geometry.tooth_form import tooth_form
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.scene.build import scene_of
from pitchpoint.viz.scene.file import scene_texts
from tests.support.scene_reader import Seen

GEAR = """\
gears:
  a:
    number_of_teeth: 23
    normal_module: 3 mm
    face_width: 30 mm
    profile_shift_coefficient: 0.2
    bore_diameter: 20 mm
{more}
bodies:
  first: {{gears: {{a: 12 mm}}, motion: fixed, position: [10 mm, 0, 0]}}
"""


def scene(more=""):
    model = loads_model(GEAR.format(more="".join(f"    {line}\n" for line in more.splitlines())))
    return Seen(*scene_texts(scene_of(model))), model


def volume(points, triangles):
    corners = points[triangles]
    return np.einsum("ni,ni->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6.0


def fault(found, words):
    pieces = [p for p in found.solid("a")["pieces"] if words in p.get("fault", "-")]
    assert len(pieces) == 1
    return pieces[0]


def corners(found, piece, level=-1):
    return found.array(piece["levels"][level]["points"]).astype(float)


def test_a_gear_is_one_tooth_and_weighs_what_it_should():
    """The bore is a polygon of 69 corners, which lacks 0.14 % of its circle."""
    found, model = scene()
    (piece,) = found.solid("a")["pieces"]
    assert found.array(piece["turns"]) == pytest.approx(2 * math.pi * np.arange(23) / 23)
    exact = gear_mass_properties(model.gears["a"].geometry, 1.0, bore_diameter=0.02).mass
    assert volume(*found.mesh("a")) == pytest.approx(exact, rel=3e-4)
    coarse, middle, fine = (len(corners(found, piece, k)) for k in range(3))
    assert coarse < middle < fine
    # its middle plane lies where the body has it
    assert found.placed("a", 0)[:, 2].mean() == pytest.approx(0.012, abs=1e-6)


@pytest.mark.parametrize("edge", ["tip_chamfer: 0.4 mm", "tip_rounding: 0.4 mm"])
def test_broken_tip_edges_are_drawn(edge):
    """The tooth weighs what it should, and its tip land is as narrow as the edges leave it."""
    found, model = scene(edge)
    gear = model.gears["a"].geometry
    exact = gear_mass_properties(gear, 1.0, bore_diameter=0.02).mass
    assert volume(*found.mesh("a")) == pytest.approx(exact, rel=3e-4)
    points = corners(found, found.solid("a")["pieces"][0])
    r = np.hypot(points[:, 0], points[:, 1])
    land = np.abs(np.arctan2(points[:, 1], points[:, 0]))[r > 0.5 * gear.d_a - 1e-6].max()
    assert land < tooth_form(gear).tip_half_angle + 1e-4 < 0.85 * tooth_form(sharp(gear)).tip_half_angle


def test_resolution_of_the_model_is_points_a_flank():
    found, _ = scene("drawing_resolution: 57")
    points = corners(found, found.solid("a")["pieces"][0])
    upper = points[points[:, 2] > 0.0149]
    radius = np.sort(np.hypot(upper[:, 0], upper[:, 1]))
    # points of one height differ by what the file rounds off, heights by 0.1 mm
    counts = np.diff(np.flatnonzero(np.diff(radius, prepend=-1.0, append=1.0) > 1e-7))
    # every height of a flank twice, root and tip circle apart
    assert (counts == 2).sum() == pytest.approx(55, abs=1)


@pytest.mark.parametrize(
    ("sizes", "width", "height"),
    [
        ("height: 3 mm", 30, 3),
        ("width: 12 mm, height: 4 mm, at: end", 12, 4),
        ("height: 3 mm, severity: 0.5", 30, 1.5),
    ],
)
def test_a_broken_tooth_lacks_what_the_model_says(sizes, width, height):
    found, model = scene(f"faults: {{chip: {{type: broken_tooth, tooth: 5, {sizes}}}}}")
    piece = fault(found, "tooth 5: chip (broken tooth)")
    assert found.array(piece["turns"]) == pytest.approx([2 * math.pi * 5 / 23])
    points = corners(found, piece)
    radius, tip = np.hypot(points[:, 0], points[:, 1]), 0.5 * model.gears["a"].geometry.d_a
    broken = points[:, 2] > 0.015 - 1e-3 * width + 1e-5 if width < 30 else points[:, 2] < 1.0
    assert radius[broken].max() == pytest.approx(tip - 1e-3 * height, abs=2e-6)
    if width < 30:
        assert radius[~broken].max() == pytest.approx(tip, abs=1e-7)


def test_a_missing_tooth_ends_at_its_root():
    found, model = scene("faults: {gone: {type: broken_tooth, tooth: 0}}")
    points = corners(found, fault(found, "gone"))
    assert np.hypot(points[:, 0], points[:, 1]).max() == pytest.approx(
        0.5 * model.gears["a"].geometry.d_f, rel=2e-3
    )
    assert found.array(found.solid("a")["pieces"][0]["turns"]).size == 22


def test_a_spall_is_as_deep_as_the_model_says():
    """Its middle lies on the reference circle, 0.3 mm deep normal to the flank; the other flank is whole."""
    at = "position: 15 mm, diameter: 70 mm, length: 10 mm, height: 2 mm, depth: 0.3 mm"
    found, model = scene(f"faults: {{spall: {{type: pitting, tooth: 2, flank: left, patches: [{{{at}}}]}}}}")
    points = corners(found, fault(found, "tooth 2: spall"))
    gear = model.gears["a"].geometry
    r, angle = np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])
    alpha = np.arccos(np.minimum(0.5 * gear.d_b / r, 1.0))
    half = gear.s_n / gear.d + (math.tan(gear.alpha_t) - gear.alpha_t) - (np.tan(alpha) - alpha)
    flank = (r > 0.5 * gear.d_Ff + 1e-5) & (r < 0.5 * gear.d_a - 1e-5) & (np.abs(angle) > 0.5 * half)
    # along the base tangent an angle is an arc of the base circle; spur teeth have it normal to the flank
    lacks = 0.5 * gear.d_b * (half - np.abs(angle))
    assert lacks[flank & (angle > 0)].max() == pytest.approx(0.3e-3, rel=0.03)
    assert np.abs(lacks[flank & (angle < 0)]).max() < 1e-7
    deepest = points[flank][np.argmax(lacks[flank])]
    assert abs(deepest[2]) < 1e-3 and np.hypot(*deepest[:2]) == pytest.approx(35e-3, abs=0.3e-3)


def test_relief_and_pitch_errors_are_drawn_at_their_size():
    """20 µm of tip relief; tooth 4 stands on by 30 µm on the reference circle."""
    found, model = scene(
        "modifications: {both: {tip_relief: {amount: 20 um, length: 3 mm}}}\n"
        "faults: {out: {type: pitch_error, tooth: 4, amount: 30 um}}"
    )
    (piece,) = found.solid("a")["pieces"]
    gear = model.gears["a"].geometry
    turns = found.array(piece["turns"]) - 2 * math.pi * np.arange(23) / 23
    assert turns[4] - turns[5] == pytest.approx(30e-6 / (0.5 * gear.d), rel=1e-6)
    points = corners(found, piece)
    r, angle = np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])
    tip = np.abs(angle[np.isclose(r, 0.5 * gear.d_a, atol=1e-8)]).max()
    alpha = math.acos(gear.d_b / gear.d_a)
    exact = gear.s_n / gear.d + (math.tan(gear.alpha_t) - gear.alpha_t) - (math.tan(alpha) - alpha)
    # its amount is normal to the flank, which the base tangent is too on spur teeth
    assert 0.5 * gear.d_b * (exact - tip) == pytest.approx(20e-6, rel=0.02)


def test_eccentric_teeth_stand_beside_the_axis():
    found, model = scene("faults: {off: {type: eccentricity, amount: 0.2 mm, phase: 90 deg, severity: 0.5}}")
    middle = found.placed("a", 0).mean(axis=0) - [0.01, 0.0, 0.0]
    turn = model.phasing.tooth_angle["a"] + math.pi / 2
    assert middle[:2] == pytest.approx(1e-4 * np.array([math.cos(turn), math.sin(turn)]), abs=1e-8)


def test_what_is_not_drawn_is_told():
    found, _ = scene(
        "faults:\n  worn: {type: wear, flank: left, depth: 40 um, severity: 0.5}\n"
        "  crack: {type: root_crack, tooth: 3, flank: left, depth: 2 mm}"
    )
    notes = " | ".join(found.header["notes"])
    assert "wear of a (worn, 20 µm at most) is included in the forces, but not drawn" in notes
    assert "root crack of a, tooth 3 (crack, 2 mm) is marked, not drawn" in notes
    assert fault(found, "tooth 3: crack (root crack)")
