# SPDX-License-Identifier: Apache-2.0
"""Whatever stands in a file with the points of a tooth, a gear or a `PitchpointError` comes out."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from pitchpoint.core.errors import PitchpointError
from pitchpoint.geometry import CylindricalGear
from pitchpoint.geometry.mass_properties import gear_mass_properties
from pitchpoint.geometry.modifications import flank_range
from pitchpoint.geometry.tooth_form import gear_outline, tooth_profile
from pitchpoint.geometry.tooth_outline import outline_from_flanks, outline_from_tooth
from pitchpoint.io.yaml_model import load_model
from tests.support.model_files import gear

REAL = CylindricalGear(z=30, m_n=3e-3, b=20e-3)
LINES = [f"{1e3 * x:.6f},{1e3 * y:.6f}" for x, y in tooth_profile(REAL, 12).points]
CELLS = st.one_of(
    st.floats().map(str),
    st.sampled_from(["", "nan", "1e999", "x", "1,5", "[", "\x00", "٣"]),
    st.text(max_size=4),
)
HEADS = st.sampled_from(
    ["x [mm],y [mm]", "x [mm],y [mm],tooth", "y [um];x [inch]", "x,y", "x [],y []", "[mm]", "x [kg],y [mm]"]
)
EDITS = st.lists(
    st.one_of(
        st.tuples(st.just("drop"), st.integers(0, 99), st.just("")),
        st.tuples(st.just("swap"), st.integers(0, 99), st.just("")),
        st.tuples(st.just("put"), st.integers(0, 99), st.builds("{},{}".format, CELLS, CELLS)),
    ),
    max_size=4,
)


@given(HEADS, EDITS, st.sampled_from(["tooth", "both", "left", "right"]), st.integers(0, 3))
def test_files_are_read_or_refused(tmp_path_factory, head, edits, part, number):
    lines = list(LINES)
    for kind, at, text in edits:
        at %= len(lines)
        if kind == "drop":
            del lines[at]
        elif kind == "swap":
            lines[at - 1], lines[at] = lines[at], lines[at - 1]
        else:
            lines[at] = text
    folder: Path = tmp_path_factory.getbasetemp()
    (folder / "fuzz.csv").write_text("\n".join([head, *lines]), encoding="utf-8")
    file = folder / "fuzz.yaml"
    file.write_text("gears:\n" + gear("a", more=f"tooth_profile: {{{part}: fuzz.csv, number: {number}}}"))
    try:
        model = load_model(file)
    except PitchpointError as error:
        assert "tooth_profile" in str(error)
        return
    found = model.gears["a"].geometry
    for flank in ("left", "right"):
        gap = found.outline.gap(found, flank, np.linspace(*flank_range(found), 9))
        assert np.isfinite(gap).all()
    assert gear_mass_properties(found, 7800.0).mass > 0.0


@st.composite
def gears(draw):
    sign = draw(st.sampled_from([1, -1]))
    return CylindricalGear(
        z=sign * draw(st.integers(20 if sign > 0 else 40, 120)),
        m_n=draw(st.floats(0.5e-3, 20e-3)),
        beta=math.radians(draw(st.floats(-35.0, 35.0))),
        x=draw(st.floats(-0.2, 0.4)),
    )


@given(gears(), st.floats(-0.01, 0.01), st.integers(40, 80))
def test_a_turned_flank_is_as_far_off_as_it_was_turned(wheel, share, n_flank):
    """A tooth thinner by the same angle on both flanks has the same gap everywhere; itself it has none."""
    points = tooth_profile(wheel, n_flank).points
    plain = wheel.replace(outline=outline_from_tooth(wheel, points))
    assert np.abs(gear_outline(plain, n_flank) - gear_outline(wheel, n_flank)).max() == 0.0
    roll = np.linspace(*flank_range(wheel), 11)
    turn = share * wheel.m_n / abs(wheel.r_b)
    side = points[points[:, 1] > 0.0][:, 0] + 1j * points[points[:, 1] > 0.0][:, 1]
    region = tooth_profile(wheel, n_flank).region[points[:, 1] > 0.0]
    thin = side[region == 2] * np.exp(-1j * turn)
    half = outline_from_flanks(wheel, left=np.column_stack([thin.real, thin.imag]))
    for outline, flank, expected in (
        (plain.outline, "left", 0.0),
        (plain.outline, "right", 0.0),
        (half, "left", share * wheel.m_n),
        (half, "right", 0.0),
    ):
        assert np.abs(outline.gap(wheel, flank, roll) - expected).max() < 1e-9 * wheel.m_n + 1e-12
