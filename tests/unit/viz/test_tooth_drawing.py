# SPDX-License-Identifier: Apache-2.0
"""Previews of teeth and of the active parts of flanks: numbers, names, labels apart, chords that fit."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pitchpoint.cli.main import run_command
from pitchpoint.geometry.cutter import PinionCutter
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.outline_distance import gear_line
from pitchpoint.geometry.tooth_form import tooth_profile
from pitchpoint.viz.gear_drawing import MIN_POINTS, active_diameters, mesh_zone_svg, points_for
from pitchpoint.viz.labels import spread
from pitchpoint.viz.tooth_drawing import STEP, tooth_svg
from tests.support.cli_files import ISO_EX1, written

SVG = "{http://www.w3.org/2000/svg}"
M = 3e-3
CUTTER = PinionCutter(z_0=25, rho_aP0_star=0.2)
PAIRS = {
    "spur": GearPair(CylindricalGear(z=20, m_n=M), CylindricalGear(z=50, m_n=M), 0.1051),
    "undercut": GearPair(CylindricalGear(z=8, m_n=M, x=0.1), CylindricalGear(z=200, m_n=M, x=-0.1), 0.312),
    "helical": GearPair(
        CylindricalGear(z=17, m_n=M, beta=0.3, x=0.2), CylindricalGear(z=40, m_n=M, beta=-0.3), 0.0903
    ),
    "ring": GearPair(
        CylindricalGear(z=20, m_n=M),
        CylindricalGear.internal(z=70, m_n=M, tip_alteration=-0.1 * M, cutter=CUTTER),
        -0.0748,
    ),
}


def lines_of(drawing: str, css: str) -> list[np.ndarray]:
    """Points of the open lines of a class, in pixels."""
    found = [e.get("d") or "" for e in ET.fromstring(drawing).iter(f"{SVG}path") if e.get("class") == css]
    return [np.array(re.findall(r"(-?[\d.]+) (-?[\d.]+)", d), dtype=float) for d in found]


@given(st.lists(st.floats(0.0, 400.0), min_size=1, max_size=12))
def test_labels_keep_apart_and_in_order(wanted: list[float]) -> None:
    places = spread(wanted, 19.0, 0.0, 400.0)
    order = np.argsort(wanted, kind="stable")
    assert np.all(np.diff(places[order]) >= 19.0 - 1e-9)
    assert places.min() >= -1e-9 and places.max() <= 400.0 + 1e-9
    if len(wanted) == 1 or np.diff(np.sort(wanted)).min() >= 19.0:
        np.testing.assert_allclose(places, np.clip(wanted, 0.0, 400.0), atol=1e-9)


@pytest.mark.parametrize("name", PAIRS)
@pytest.mark.parametrize("which", [1, 2])
def test_a_preview_names_circles_and_active_flanks(name: str, which: int) -> None:
    pair = PAIRS[name]
    gear = pair.gear1 if which == 1 else pair.gear2
    drawing = tooth_svg(gear, name="it & that", meshes={"stage": (pair, which)})
    texts = [
        (float(e.get("y") or 0), "".join(e.itertext())) for e in ET.fromstring(drawing).iter(f"{SVG}text")
    ]
    words = " | ".join(text for _, text in texts)
    assert f"it & that: z = {abs(gear.z)}" in words
    # name and diameter of every circle, in a column without one label on another
    for diameter in (gear.d_a, gear.d, gear.d_b, gear.d_Ff, gear.d_fE):
        assert f"= {float(f'{1e3 * abs(diameter):.6g}'):g}"[:8] in words
    column = sorted(y for y, text in texts if " = " in text and "mm" in text and "z =" not in text)
    assert min(np.diff(column)) >= STEP - 1e-6
    # start and end of the active profile: on the drawn flank, at their diameters
    root, tip = active_diameters(pair, which)
    assert (root < tip) != gear.is_internal
    assert f"d {float(f'{1e3 * root:.6g}'):g}"[:7] in words and "(EAP)" in words
    (line,) = lines_of(drawing, "pp-active1")
    (frame,) = (e for e in ET.fromstring(drawing).iter(f"{SVG}rect") if e.get("class") == "pp-frame")
    assert line[:, 1].min() > 0.0 and line[:, 1].max() < float(frame.get("height") or 0.0)
    assert (lines_of(drawing, "pp-tool") != []) == (not gear.is_internal or gear.cutter is not None)


def test_active_diameters_are_those_of_the_path_of_contact() -> None:
    """d_Nf² = d_b² + (2 T1A)² and d_Na = d_a; an undercut flank ends at its form circle before."""
    pair = PAIRS["spur"]
    root = math.hypot(pair.gear1.d_b, 2.0 * pair.T1A)
    assert active_diameters(pair, 1) == pytest.approx((root, pair.gear1.d_a))
    undercut = PAIRS["undercut"]
    assert undercut.d_Nf1 < undercut.gear1.d_Ff
    assert active_diameters(undercut, 1)[0] == pytest.approx(undercut.gear1.d_Ff)
    assert active_diameters(PAIRS["ring"], 2)[1] == pytest.approx(-PAIRS["ring"].gear2.d_a)


@pytest.mark.parametrize("name", PAIRS)
def test_active_flanks_touch_on_the_path_of_contact(name: str) -> None:
    """In the drawing both meet on the line of action, between A and E, and nowhere cross."""
    drawing = mesh_zone_svg(PAIRS[name])
    (one,), (two,) = lines_of(drawing, "pp-active1"), lines_of(drawing, "pp-active2")
    one, two = (
        np.column_stack([np.interp(np.linspace(0, 39, 1500), range(40), c) for c in p.T]) for p in (one, two)
    )
    far = np.hypot(*(one[:, None, :] - two[None, :, :]).transpose(2, 0, 1))
    k = int(far.min(axis=1).argmin())
    assert far.min() < 2.0
    path = next(e for e in ET.fromstring(drawing).iter(f"{SVG}line") if e.get("class") == "pp-path")
    x1, y1, x2, y2 = (float(path.get(key) or 0.0) for key in ("x1", "y1", "x2", "y2"))
    along = np.array([x2 - x1, y2 - y1]) / math.hypot(x2 - x1, y2 - y1)
    away = one[k] - [x1, y1]
    assert abs(along[0] * away[1] - along[1] * away[0]) < 6.0
    assert 0.0 < along @ away < math.hypot(x2 - x1, y2 - y1)


@pytest.mark.parametrize("gear", [PAIRS["undercut"].gear1, PAIRS["undercut"].gear2, PAIRS["ring"].gear2])
def test_chords_of_drawings_stay_within_their_distance(gear: CylindricalGear) -> None:
    """Points of a far finer tooth keep the distance from the drawn one, which is no finer than it must be."""
    fine = tooth_profile(gear, 400).points
    for chord in (30e-6, 3e-6):
        n = points_for(gear, chord)
        off = np.abs(gear_line(gear, n).nearest(fine[:, 0] + 1j * fine[:, 1]).distance).max()
        assert off <= chord
        assert n == MIN_POINTS or off > 0.4 * chord


def test_preview_of_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """ISO/TR 6336-30 example 1: active from 132.921 to 159.66 mm."""
    model, target = written(tmp_path, ISO_EX1), tmp_path / "teeth.svg"
    assert run_command(["gears", model, "--gear", "pinion", "--preview", str(target)]) == 0
    assert "teeth of pinion drawn in" in capsys.readouterr().out
    text = target.read_text(encoding="utf-8")
    assert "active in stage: d 132.921 (SAP) to 159.66 mm (EAP)" in text
    assert run_command(["gears", model, "--gear", "wheel", "--preview", str(target)]) == 0
    for arguments, words in (
        (["--gear", "pinion", "--preview", str(tmp_path / "a.png")], "does not end in .svg"),
        (["--gear", "pinion", "--preview", str(target), "--export", str(target)], "name another file"),
        (["--preview", str(target)], "select a gear"),
    ):
        capsys.readouterr()
        assert run_command(["gears", model, *arguments]) == 2
        assert words in capsys.readouterr().err
