# SPDX-License-Identifier: Apache-2.0
"""FC-6 by CalculiX: load shares and approach of a spur pair in contact against `teeth: finite_elements`.

Source: CalculiX 2.20 (Debian package calculix-ccx) as an external program, plane strain, CPE8, frictionless
surface-to-surface penalty. Spur 17/43, m 1 mm, a 30 mm, tip radius 0.1 mm, bores r_f/1.4, E 206 GPa, 2 N m
per mm on gear 1. Gear 1 about the origin drives counter-clockwise with its left flanks, its bore is turned
by the approach over r_b1 from the contact of rigid gears; the bore of gear 2 is held. Our compliance is
that of `tooth_fe` in plane strain, with one polynomial over the width.

Shares and approaches are compared at the torque that CalculiX has at our approach.

* Between A and E: shares by 0.002, approach by 1.5 %. A ten times stiffer penalty leaves 0.4 % between
  both.
* Before A, tip edge of gear 2: shares by 0.005, approach by 1.5 %.
* Beyond E, tip edge of gear 1: this gear has turned on by the approach, 0.014 mm or 0.005 base pitches. Our
  theory has one position along the line of action for both flanks and neglects it: the leaving pair has a
  share of 0.088 and 0.059 by CalculiX. Our share at a position later by the approach, 0.062, agrees by
  0.01.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

import pitchpoint.system.rules.flank_contact as rules
from pitchpoint.contact.tooth_fe.solve import tooth_fe
from pitchpoint.contact.tooth_fe.tooth_model import Resolution
from pitchpoint.geometry.tooth_form import tooth_form
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from tests.support.calculix import requires_ccx
from tests.support.calculix_mesh import MeshInContact
from tests.support.whole_contact import Pair

pytestmark = [pytest.mark.study, requires_ccx]

BORES = (7.25 / 1.4, 20.25 / 1.4)


@pytest.fixture
def flanks(monkeypatch):
    """The pair with our finite elements in plane strain."""
    monkeypatch.setattr(
        rules, "stored_tooth_fe", lambda model: tooth_fe(replace(model, resolution=Resolution(widths=1)))
    )
    keys = tuple(f", tip_rounding: 0.1 mm, bore_diameter: {2.0 * bore!r} mm" for bore in BORES)
    contact = ", teeth: finite_elements, overlap: small"
    model = Pair(z=(17, 43), m=1.0, b=10.0, a=30.0, keys=keys, contact=contact).model()
    assert tooth_form(model.pairs["stage"].gear1).r_f == pytest.approx(7.25e-3, rel=1e-9)
    return FlankStates(model, "stage")


def ours(flanks, phase, torque=20.0):
    """Approach [mm] and shares of pairs -1, 0, 1."""
    states = flanks.states([phase])
    states["by_force"], states["force"] = 1, flanks.force_of(torque)
    nodes = flanks.solve(states, keep_nodes=True)[0][: int(states["n_nodes"][0])]
    shares = [float(nodes["force"][nodes["pair"] == -k].clip(0.0).sum()) for k in (-1, 0, 1)]
    return 1e3 * float(states["x_0"][0]), [share / sum(shares) for share in shares]


def by_calculix(flanks, folder, phase):
    """Approach and shares by CalculiX, its torque [N m], and ours at this torque."""
    mesh = MeshInContact(flanks.model.pairs["stage"], phase, BORES)
    guess = ours(flanks, phase)[0]
    torques = mesh.torques(folder, guess)
    torque = 0.01 * float(torques.sum())  # of 10 mm
    return guess, list(torques / torques.sum()), torque, ours(flanks, phase, torque)


@pytest.mark.parametrize("phase", [0.2, 0.5])
def test_between_a_and_e(tmp_path, flanks, phase):
    approach, shares, _, found = by_calculix(flanks, tmp_path, phase)
    assert found[1][1] == pytest.approx(shares[1], abs=0.002)
    assert found[1][2] == pytest.approx(shares[2], abs=0.002)
    assert found[0] == pytest.approx(approach, rel=0.015)


def test_before_a(tmp_path, flanks):
    approach, shares, _, found = by_calculix(flanks, tmp_path, 0.92)
    assert found[1][0] == pytest.approx(shares[0], abs=0.005)
    assert found[0] == pytest.approx(approach, rel=0.015)


def test_beyond_e(tmp_path, flanks):
    approach, shares, torque, found = by_calculix(flanks, tmp_path, 0.67)
    pitch = 1e3 * flanks.model.pairs["stage"].p_et
    later = ours(flanks, 0.67 + approach / pitch, torque)[1]
    assert found[1][2] > shares[2] + 0.02
    assert later[2] == pytest.approx(shares[2], abs=0.01)
