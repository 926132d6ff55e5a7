# SPDX-License-Identifier: Apache-2.0
"""What a model says without effect is said aloud, and has none."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import ValidityWarning
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.collect import (
    bushings_at_a_distance,
    gaps_in_contact,
    ignored_flanks,
    negative_backlash,
    no_backlash,
    odd_shapes,
)
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

RELIEF = ", modifications: {both: {tip_relief: {amount: 20 um, length: 2 mm}}}"
TEXT = """
gears:
  a: {{number_of_teeth: 24, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0{more}}}
  b: {{number_of_teeth: 36, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
bodies:
  one: {{gears: [a]}}
  two: {{gears: [b]}}
meshes:
  s: {{gears: [a, b], backlash: {{normal: 0.1 mm}}, stiffness: {law}}}
"""


def test_a_prescribed_stiffness_takes_no_notice_of_the_flanks():
    law = "{law: constant, value: 4e8 N/m}"
    with pytest.warns(
        ValidityWarning, match=r"meshes\.s \(line \d+\): the law constant .* of a have no effect"
    ):
        modified = compile_model(loads_model(TEXT.format(more=RELIEF, law=law)))
    plain = compile_model(loads_model(TEXT.format(more="", law=law)))
    for name in ("sep_min", "n_sep", "slices"):
        assert modified.records["gear_mesh"][name][0] == plain.records["gear_mesh"][name][0] == 0.0


def test_laws_of_a_tooth_pair_follow_the_flanks():
    model = loads_model(TEXT.format(more=RELIEF, law="{law: din3990}"))
    assert ignored_flanks(model) == ()
    assert compile_model(model).records["gear_mesh"]["n_sep"][0] > 0
    assert np.isfinite(compile_model(model).records["gear_mesh"]["sep_min"][0])


PAIR = """
gears:
  a: {{number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
  b: {{number_of_teeth: 60, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0{more}}}
bodies:
  one: {{gears: [a]}}
  two: {{gears: [b]}}
meshes:
  s: {{gears: [a, b], {mesh}}}
"""
RING = ", type: internal, tip_diameter: 176 mm"


@pytest.mark.parametrize(
    ("more", "mesh", "value", "remedy"),
    [
        (RING, "center_distance: 60.08 mm", "-55 µm", r"give center_distance <= 60\.000 mm"),
        ("", "center_distance: 119.92 mm", "-54.6 µm", r"give center_distance >= 120\.000 mm"),
        ("", "backlash: {base_tangent: -20 um}", "-20 µm", "give a backlash >= 0"),
    ],
)
def test_negative_backlash_is_said_aloud(more, mesh, value, remedy):
    model = loads_model(PAIR.format(more=more, mesh=mesh))
    with pytest.warns(ValidityWarning, match=f"{value}: both flanks are in contact without load; .*{remedy}"):
        compile_model(model)
    (text,) = negative_backlash(model)
    assert text.startswith("meshes.s: the backlash along the base tangent is ")


@pytest.mark.parametrize(
    ("more", "mesh"),
    [
        (RING, "center_distance: 60 mm"),
        ("", "center_distance: 120 mm"),
        ("", "center_distance: 119.9999 mm"),  # rounding
        ("", "center_distance: 119.92 mm, backlash: {normal: 0 mm}"),
    ],
)
def test_no_backlash_is_no_negative_backlash(more, mesh):
    assert negative_backlash(loads_model(PAIR.format(more=more, mesh=mesh))) == ()


def test_odd_shapes_are_told_with_the_gear_and_the_mesh():
    tool = ", rack: {addendum: 1, dedendum: 1.25, root_radius: 0.6}"
    (radius,) = odd_shapes(loads_model(PAIR.format(more=tool, mesh="center_distance: 125.5 mm")))
    assert radius.startswith("gears.b.rack.root_radius: 0.6 modules have no room between the flanks")
    assert "(limit 0.4719)" in radius
    assert odd_shapes(loads_model(PAIR.format(more="", mesh="center_distance: 120 mm"))) == ()


def test_moments_without_a_pair_in_contact_are_reported_by_whatever_compiles():
    model = loads_model(PAIR.format(more="", mesh="center_distance: 125.5 mm"))
    (gap,) = gaps_in_contact(model)
    assert gap.startswith("meshes.s.gears: total contact ratio 0.")
    with pytest.warns(ValidityWarning, match="leaves moments without a tooth pair in contact"):
        compile_model(model)
    assert gaps_in_contact(loads_model(PAIR.format(more="", mesh="center_distance: 120 mm"))) == ()


APART = """
bodies:
  wall: {motion: fixed, position: [0.3, 0.4, 0], markers: {here: {axes: {z: [0, 0, 1], x: [0, 1, 0]}}}}
  far: {motion: fixed, position: [0, 0, 0]}
  casing: {motion: free, mass: 5 kg, inertia_tensor: [0.1, 0.1, 0.1, 0, 0, 0], position: [0.3, 0, 0],
           markers: {foot: {position: [0, 0.4, 0], axes: {z: [0, 0, 1], x: [0, 1, 0]}}}}
bushings:
  mount: {ends: [casing.foot, END], stiffness: {x: 1e6, y: 1e6, axial: 1e6, tilt: 1e4, torsion: 1e4}}
"""


def test_a_bushing_whose_ends_are_drawn_apart_is_named():
    """0.3 m and 0.4 m at right angles: 500 mm. On ground it ends where the other end is drawn."""
    (told,) = bushings_at_a_distance(loads_model(APART.replace("END", "far")))
    assert told == (
        "bushings.mount (line 8): casing.foot and far are 500 mm apart in the initial position, "
        "and the bushing pulls them together"
    )
    for end in ("wall.here", "ground"):
        assert bushings_at_a_distance(loads_model(APART.replace("END", end))) == ()


@pytest.mark.parametrize(
    "ends", ["[casing.foot, ground]", "[ground, casing.foot]", "[casing.foot, wall.here]"]
)
def test_a_bushing_on_ground_has_no_force_as_drawn_and_the_directions_of_its_end(ends):
    """1 mm along x of the marker, which is y of the world: 1e6 N/m make 1 kN."""
    text = APART.replace("[casing.foot, END]", ends).replace("y: 1e6", "y: 3e6")
    if "wall" not in ends:
        text = text.replace("here:", "").replace("{ {axes: {z: [0, 0, 1], x: [0, 1, 0]}}}", "{}")
    system = compile_model(loads_model(text))
    state = system.initial_state()
    assert np.abs(evaluate.residual(system, state)).max() < 1e-6
    state.q[1] = 1e-3
    found = evaluate.residual(system, state)
    assert np.abs(found[:3]) == pytest.approx([0.0, 1000.0, 0.0], abs=1e-6)


ELASTIC = """
gears:
  a: {{number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm{shift}{thinner}}}
  b: {{number_of_teeth: 60, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
bodies:
  one: {{gears: [a], motion: {motion}}}
  two: {{gears: [b]}}
meshes:
  s: {{gears: [a, b], center_distance: 120.5 mm{backlash}}}
"""
BEARING = "bearings:\n  k: {body: one, stiffness: {radial: 1e8 N/m}}\n"


def test_no_backlash_on_elastic_supports_has_a_remark():
    """A shift from the centre distance leaves no gap; a larger distance only increases the shift."""
    plain = {"shift": "", "thinner": "", "motion": "planar", "backlash": ""}
    ((where, text),) = [
        (each.where, str(each)) for each in no_backlash(loads_model(ELASTIC.format(**plain) + BEARING))
    ]
    assert where == "meshes.s"
    assert "the backlash is 0 mm" in text and "tooth_thickness_allowance < 0" in text
    assert "profile_shift_coefficient of both gears" in text
    changes = (
        {"thinner": ", tooth_thickness_allowance: -40 um"},
        {"shift": ", profile_shift_coefficient: 0"},  # 0.5 mm above the distance without backlash
        {"backlash": ", backlash: {normal: 0 mm}"},  # as given
    )
    for change in changes:
        assert no_backlash(loads_model(ELASTIC.format(**plain | change) + BEARING)) == ()
    rigid = ELASTIC.format(**plain | {"motion": "torsion"})
    assert no_backlash(loads_model(rigid)) == ()
