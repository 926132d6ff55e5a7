# SPDX-License-Identifier: Apache-2.0
"""Flank in contact under load: d_Nf to d_Na of ISO 21771 for stiff teeth, path of contact with tip edges."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.flank_contact.active_flank import active_flanks, contact_path
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from pitchpoint.viz.active_flank_drawing import active_flank_svg
from pitchpoint.viz.contact_page import contacts_page
from tests.support.contact_files import fzg

RING = """
gears:
  g1: {number_of_teeth: 25, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0.4}
  g2: {type: internal, number_of_teeth: 70, normal_module: 3 mm, face_width: 30 mm, tip_diameter: 206 mm,
       profile_shift_coefficient: -0.4}
bodies:
  a: {gears: [g1], motion: torsion}
  b: {gears: [g2], motion: torsion}
meshes:
  stage: {gears: [g1, g2], contact: {level: rigid, stiffness: 1e12 N/m}}
"""


def ring(folder):
    path = folder / "ring.yaml"
    path.write_text(RING, encoding="utf-8")
    return load_model(path)


@pytest.mark.parametrize("make", [lambda p: fzg(p, k=1e12), ring])
def test_stiff_teeth_are_in_contact_from_d_Nf_to_d_Na(tmp_path, make):
    """Contact at 200 phases misses the ends by up to 1/200 base pitch, 0.1 mm of roll."""
    model = make(tmp_path)
    pair = model.pairs["stage"]
    found = active_flanks(solve_contact(model, torque=50.0, positions=200))
    for one, ends in zip(found, ((pair.d_Nf1, pair.d_Na1), (pair.d_Nf2, pair.d_Na2)), strict=True):
        assert one.geometric_diameter == pytest.approx(np.abs(ends), rel=1e-9)
        assert one.diameter == pytest.approx(np.abs(ends), abs=0.05e-3)
        r_b = one.diameter / 2.0 / np.hypot(1.0, one.roll_angle)
        assert np.ptp(r_b) == pytest.approx(0.0, abs=1e-12)


def test_deflected_teeth_touch_before_A_and_beyond_E(tmp_path):
    """The distance at which a tip edge is one deflection away from the flank follows from its gap."""
    model = fzg(tmp_path)
    data = solve_contact(model, torque=302.0, positions=200)
    first, last = contact_path(data)
    eps = model.pairs["stage"].eps_alpha
    assert -0.3 < first < -0.05
    assert eps + 0.05 < last < eps + 0.3
    stiff = contact_path(solve_contact(fzg(tmp_path, k=1e13), torque=1.0, positions=200))
    assert stiff == pytest.approx((0.0, eps), abs=0.01)
    # tip edges do not lengthen the flank in contact
    pair = model.pairs["stage"]
    one, two = active_flanks(data)
    assert one.diameter[0] >= abs(pair.d_Nf1) - 1e-9
    assert two.diameter[0] >= abs(pair.d_Nf2) - 1e-9


@pytest.mark.parametrize("make", [fzg, ring])
def test_the_drawing_fills_the_tooth_between_the_ends(tmp_path, make):
    model = make(tmp_path)
    data = solve_contact(model, torque=100.0, positions=16)
    for name, one in zip(("g1", "g2"), active_flanks(data), strict=True):
        text = active_flank_svg(model.gears[name].geometry, one, name=name, words="100 N m")
        assert 'class="pp-tool"' in text
        assert text.count('class="pp-active1"') == 2
        for words in ("contact, root side", "contact, tip side", "d_Nf, undeformed", "root form d_Ff"):
            assert words in text
    gears = {name: model.gears[name].geometry for name in ("g1", "g2")}
    page = contacts_page({"m": data}, gears={"m": gears})
    assert "Flanks in contact" in page
    assert "base pitches before A" in page
