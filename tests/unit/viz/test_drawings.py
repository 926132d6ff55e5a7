# SPDX-License-Identifier: Apache-2.0
"""Drawings of gears are well-formed, show the right points and never leave their frame."""

from __future__ import annotations

import re
import subprocess
import sys
import types
import xml.etree.ElementTree as ET
from typing import Any

import numpy as np
import pytest

from pitchpoint.core.errors import PitchpointError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.report.pictures import plot
from pitchpoint.viz import notebook
from pitchpoint.viz.gear_drawing import gear_svg, mesh_zone_svg, pair_svg
from pitchpoint.viz.svg import clip
from tests.support.report_data import cycle, pair

SVG = "{http://www.w3.org/2000/svg}"


def internal_pair() -> GearPair:
    return GearPair.at_distance(
        CylindricalGear(z=20, m_n=3e-3), CylindricalGear.internal(z=60, m_n=3e-3), 0.0601
    )


def texts(drawing: str) -> list[str]:
    return ["".join(e.itertext()) for e in ET.fromstring(drawing).iter(f"{SVG}text")]


@pytest.mark.parametrize("made", [pair, internal_pair])
def test_pair_shows_names_and_distance(made: Any) -> None:
    stage = made()
    shown = texts(pair_svg(stage, names=("sun", "ring")))
    assert f"sun: z = {stage.gear1.z}" in shown
    assert f"ring: z = {abs(stage.gear2.z)}" in shown
    assert any(t.startswith("centre distance") and "mm" in t for t in shown)


@pytest.mark.parametrize("made", [pair, internal_pair])
def test_mesh_zone_marks_the_path_of_contact(made: Any) -> None:
    drawing = mesh_zone_svg(made())
    assert {"A", "B", "C", "D", "E"} <= set(texts(drawing))
    path = next(e for e in ET.fromstring(drawing).iter(f"{SVG}line") if e.get("class") == "pp-path")
    ends = np.array([[path.get("x1"), path.get("y1")], [path.get("x2"), path.get("y2")]], dtype=float)
    assert ((ends > 0.0) & (ends < 480.0)).all()
    # gear 1 drives counter-clockwise: contact starts below and ends above the line of centres
    assert ends[0, 1] > ends[1, 1]


def test_outline_of_the_path_is_as_long_as_it_should_be() -> None:
    stage = pair()
    path = next(
        e for e in ET.fromstring(mesh_zone_svg(stage)).iter(f"{SVG}line") if e.get("class") == "pp-path"
    )
    x1, y1, x2, y2 = (float(path.get(k)) for k in ("x1", "y1", "x2", "y2"))  # type: ignore[arg-type]
    angle = np.degrees(np.arctan2(x2 - x1, y1 - y2))
    assert angle == pytest.approx(np.degrees(stage.alpha_wt), abs=0.1)


def test_single_gears_external_and_internal() -> None:
    for gear in (CylindricalGear(z=17, m_n=8e-3), CylindricalGear.internal(z=60, m_n=3e-3)):
        drawing = gear_svg(gear, name="it & that")
        assert f"it & that: z = {abs(gear.z)}" in texts(drawing)
        numbers = re.findall(r"[ML](-?[\d.]+) (-?[\d.]+)", drawing)
        points = np.array(numbers, dtype=float)
        assert points.min() >= 0.0
        assert points.max() <= 480.0


def test_clipping_keeps_what_is_inside() -> None:
    square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    window = np.array([-1.0, -1.0]), np.array([2.0, 2.0])
    np.testing.assert_array_equal(clip(square, *window), square)
    assert len(clip(square, np.array([3.0, 3.0]), np.array([4.0, 4.0]))) == 0


def test_show_and_save(tmp_path: Any) -> None:
    picture = plot(pair())
    assert "<svg" in picture._repr_html_()
    assert "transverse contact ratio" in picture.html
    picture.save(tmp_path / "pair.html")
    assert (tmp_path / "pair.html").read_text(encoding="utf-8").startswith("<!DOCTYPE html>")
    assert plot(cycle()).data
    with pytest.raises(PitchpointError, match="no picture available"):
        plot(3)


def test_a_model_shows_tables_and_its_pairs() -> None:
    stage = pair()
    model = types.SimpleNamespace(
        pairs={"stage": stage},
        meshes={"stage": types.SimpleNamespace(gears=("g1", "g2"))},
        _repr_html_=lambda: "<table></table>",
    )
    html = notebook.model_html(model)
    assert html.startswith("<table>")
    assert "g1: z = 50" in html


def test_gears_and_pairs_show_themselves_outside_ipython() -> None:
    """In a fresh interpreter: the classes get their method with the first public name that brings them in."""
    code = """
import sys, pitchpoint as pp
assert not {"numpy", "pitchpoint.viz"} & set(sys.modules)
gear = pp.CylindricalGear(z=17, m_n=3e-3, b=0.02)
from pitchpoint.io.yaml_model import loads_model
model = loads_model(TEXT)
pp.Model
for shown in (gear, pp.GearPair(gear, gear, 0.051), model.gears["a"], model.pairs["m"]):
    assert "<svg" in shown._repr_html_(), shown
assert "<table" in model._repr_html_()
assert not {"IPython", "plotly", "numba"} & set(sys.modules)
"""
    teeth = "{number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}"
    text = f"gears: {{a: {teeth}, b: {teeth}}}\nmeshes: {{m: {{gears: [a, b]}}}}\n"
    subprocess.run([sys.executable, "-c", f"TEXT = {text!r}\n{code}"], check=True)
