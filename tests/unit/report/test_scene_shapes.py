# SPDX-License-Identifier: Apache-2.0
"""Boxes and bodies of revolution of bodies in scenes."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.report.scene.rest import rest_scene
from pitchpoint.report.scene.shapes import rounded_box
from tests.support.rotors import FOLDER
from tests.unit.report.test_scene_gears import volume

TEXT = """\
bodies:
  base: {{motion: fixed, position: [1, 0, 0], axes: {{z: [1, 0, 0]}}, shapes: {{part: {{{shape}}}}}}}
  rotor: {{motion: torsion, inertia: 1 kg m^2}}
scenarios:
  s: {{speed: {{rotor: 1 rad/s}}, duration: 1 s}}
"""


def drawn(shape: str):
    scene = rest_scene(loads_model(TEXT.format(shape=shape)))
    (solid,) = [solid for solid in scene.solids if solid.name == "base.part"]
    return solid


def test_a_box_is_in_the_axes_of_its_body():
    """2 m along the z axis of the body; points of a scene are in the axes of their body."""
    solid = drawn("box: [0.2 m, 0.4 m, 2 m], position: [0, 0, 3 m]")
    assert (solid.kind, solid.see_through, solid.schematic) == ("body", False, False)
    low, high = solid.points.min(axis=0), solid.points.max(axis=0)
    assert low == pytest.approx([-0.1, -0.2, 2.0]) and high == pytest.approx([0.1, 0.2, 4.0])
    assert volume(solid.points, solid.triangles) == pytest.approx(0.16)


def test_a_rounded_box_is_closed_and_has_its_size():
    """Volume of a box with round edges: of the inner box, its faces, quarters of cylinders and a ball."""
    size, r = np.array([2.0, 1.0, 0.8]), 0.25
    a, b, c = inner = size - 2 * r
    points, triangles = rounded_box(size, r, 24)
    assert np.ptp(points, axis=0) == pytest.approx(size)
    exact = inner.prod() + 2 * r * (a * b + b * c + c * a) + np.pi * r**2 * (a + b + c) + 4 / 3 * np.pi * r**3
    assert volume(points, triangles) == pytest.approx(exact, rel=1e-3)


def test_a_body_of_revolution_is_closed_and_a_cover_transparent():
    """A frustum of a cone, with 48 corners per circle."""
    solid = drawn("heights: [0, 0.3 m], diameters: [0.4 m, 0.2 m], cover: true")
    assert (solid.kind, solid.see_through) == ("housing", True)
    exact = np.pi * 0.3 / 3 * (0.2**2 + 0.2 * 0.1 + 0.1**2)
    assert volume(solid.points, solid.triangles) == pytest.approx(exact, rel=4e-3)


def test_shapes_have_no_mass():
    model = loads_model(TEXT.format(shape="box: [1, 1, 1]"))
    assert model.body_inertia("base").mass == 0.0


def test_diameters_of_a_beam_are_those_of_its_ends():
    """The tower of the NREL turbine: 6 m at the foot, 3.87 m at the top."""
    (tower,) = [s for s in rest_scene(load_model(FOLDER.parent / "model.yaml")).solids if s.name == "tower"]
    for height, diameter in ((0.0, 6.0), (87.6, 3.87)):
        ring = tower.points[np.abs(tower.points[:, 2] - height) < 0.01]
        assert np.ptp(ring, axis=0)[0] == pytest.approx(diameter)


@pytest.mark.parametrize(
    ("shape", "words"),
    [
        ("position: [0, 0, 0]", "has no size"),
        ("box: [1, 1, 1], heights: [0, 1], diameters: [1, 1]", "is two shapes"),
        ("box: [1, 1, 0]", "is a size"),
        ("box: [1, 1, 1], rounding: 0.6", "is larger than half"),
        ("heights: [0, 1], diameters: [1, 1, 1]", "do not make an outline"),
        ("heights: [0], diameters: [1]", "do not make an outline"),
        ("heights: [1, 0], diameters: [1, 1]", "do not ascend"),
        ("heights: [0, 1], diameters: [0, 0]", "has no volume"),
        ("heights: [0, 1], diameters: [1, 1], rounding: 0.1", "rounding .*: is for boxes"),
    ],
)
def test_impossible_shapes_are_refused(shape, words):
    with pytest.raises(ModelError, match=words):
        loads_model(TEXT.format(shape=shape))


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        ("section: {diameter: 20 mm}, diameters: [1, 1]", "are for beams with properties"),
        (
            "properties: {position: [0, 1], mass: [1, 1], bending_1: [1, 1], bending_2: [1, 1]}, "
            "diameters: [1]",
            "is one diameter",
        ),
    ],
)
def test_impossible_diameters_of_beams_are_refused(keys, words):
    text = TEXT.format(shape="box: [1, 1, 1]") + f"beams:\n  b: {{ends: [ground, rotor], {keys}}}\n"
    with pytest.raises(ModelError, match=words):
        loads_model(text)
