# SPDX-License-Identifier: Apache-2.0
"""Solids from files in a scene: as they lie in the file, with no more triangles than are seen."""

from __future__ import annotations

import importlib.util
import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.errors import MissingDependencyError
from pitchpoint.geometry.solid_mass import solid_of_triangles
from pitchpoint.geometry.step_triangles import step_triangles
from pitchpoint.io.yaml_model import load_model
from pitchpoint.report.scene.cad_files import MAX_TRIANGLES, fewer_triangles
from pitchpoint.report.scene.rest import rest_scene
from pitchpoint.report.scene.shapes import turned_profile
from pitchpoint.viz.scene.file import scene_texts
from tests.support.occ import needs_occ
from tests.support.scene_reader import Seen

MODEL = """
bodies: {{part: {{motion: free, position: [1 m, 0, 0], solid: {{{solid}}}}}}}
bushings:
  mount: {{ends: [ground, part], stiffness: {{radial: 1 kN/mm, axial: 1 kN/mm, tilt: 1e3, torsion: 1e3}}}}
"""


def ball(radius: float, rings: int, sides: int):
    """A ball of many triangles about the origin."""
    angle = np.linspace(-0.5 * math.pi, 0.5 * math.pi, rings)
    line = np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])
    line[[0, -1], 0] = 0.0
    return turned_profile(line, sides)


def test_fewer_triangles_are_the_same_body():
    """Volume of the ball, whose surface moves by less than a cell; what is few stays as it is."""
    points, triangles = ball(0.1, 70, 200)
    assert len(triangles) > 27_000
    assert fewer_triangles(points, triangles, len(triangles))[1] is triangles
    for most, cells in ((15_000, 60), (3_000, 30)):
        found, kept = fewer_triangles(points, triangles, most)
        assert 0.3 * most < len(kept) <= most
        cell = 0.2 / cells * math.sqrt(3.0)
        assert np.abs(np.linalg.norm(found[np.unique(kept)], axis=1) - 0.1).max() < cell
        # the middle of a triangle of that size lies so much below the ball
        sunk = 0.5 * (cell / 0.1) ** 2
        assert 1.0 - 3.0 * sunk < solid_of_triangles(found[kept]).volume / (4e-3 / 3 * math.pi) < 1.0


def test_a_solid_of_too_many_triangles_is_drawn_coarser_in_its_place(tmp_path: Path):
    points, triangles = ball(0.1, 110, 250)
    points = points + np.array([0.0, 0.0, 0.3])
    assert len(triangles) > MAX_TRIANGLES
    np.save(tmp_path / "ball.npy", points[triangles])
    model = tmp_path / "model.yaml"
    model.write_text(MODEL.format(solid="file: ball.npy, unit: 1 m"), encoding="utf-8")
    found = Seen(*scene_texts(rest_scene(load_model(str(model)))))
    part = found.solid("part")
    assert 0.3 * MAX_TRIANGLES < len(found.array(part["triangles"])) <= MAX_TRIANGLES
    middle = found.array(part["points"]).mean(axis=0)
    assert np.abs(middle - [0.0, 0.0, 0.3]).max() < 1e-3


def test_without_occ_step_files_say_what_brings_it(tmp_path: Path, monkeypatch):
    file = tmp_path / "part.step"
    file.write_text("ISO-10303-21;\nENDSEC;\nEND-ISO-10303-21;\n")
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    with pytest.raises(MissingDependencyError, match=r"pip install 'pitchpoint.cad.'"):
        step_triangles(file, "part")


@needs_occ
def test_a_solid_of_a_step_file_is_drawn_where_the_file_has_it(tmp_path: Path):
    """A rod of 10 x 40 mm that lies along -y, 100 mm from the origin, in a file in inches."""
    from tests.unit.io.test_step_export import assembly

    assembly(tmp_path / "parts.step", "INCH")
    corners = step_triangles(tmp_path / "parts.step", "rod (2)")
    low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    assert low == pytest.approx([0.095, -0.04, -0.005], abs=1e-4)
    assert high == pytest.approx([0.105, 0.0, 0.005], abs=1e-4)
    volume = solid_of_triangles(corners).volume
    assert 0.96 < volume / (math.pi * 0.005**2 * 0.04) < 1.0, "chords lie inside, triangles look outwards"
    model = tmp_path / "model.yaml"
    model.write_text(MODEL.format(solid="file: parts.step, part: block"), encoding="utf-8")
    found = Seen(*scene_texts(rest_scene(load_model(str(model)))))
    points = found.array(found.solid("part")["points"])
    assert np.ptp(points, axis=0) == pytest.approx([0.03, 0.02, 0.01], rel=1e-6)
    assert not any("is not drawn" in note for note in found.header["notes"])
