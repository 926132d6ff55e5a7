# SPDX-License-Identifier: Apache-2.0
"""FC-6 by CalculiX: load shares and approach of a spur pair in contact against `teeth: finite_elements`.

Source: CalculiX 2.20 (Debian package calculix-ccx) as an external program, plane strain, CPE8, frictionless
surface-to-surface penalty. Spur 17/43, m 1 mm, a 30 mm, tip radius 0.1 mm, bores r_f/1.4, E 206 GPa, 2 N m
per mm on gear 1. Gear 1 about the origin drives counter-clockwise with its left flanks, its bore is turned
by the approach over r_b1 from the contact of rigid gears; the bore of gear 2 is held. Our compliance is
that of `tooth_fe` in plane strain, with one polynomial over the width.

The position of a pair is the mean of both flanks, gear 1 being half the approach ahead of it. Torques of the
pairs on gear 1 at equal approach are compared, ours with the lever of a tip edge.

* Between A and E: by 1 %, ours are 0.6 to 0.9 % lower.
* Tip edge of gear 1 beyond E, and of gear 2 before A: the approach at which it begins to carry load, that is
  the gap of 11.1 and 9.4 um, by 0.2 %. From there its torque increases 7.6 and 6 % faster than by CalculiX:
  the corner of a tooth is softer than the half-space of our local approach. Elements of half the size and
  twice the number along the edge change it by 0.5 %.
* Ends of contact at 20 N m, extrapolated from two positions: 0.6852 and 0.9068 by CalculiX, by 1e-3 base
  pitches. Hence 1.778 loaded pairs in the mean.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import pitchpoint.system.rules.flexible_teeth as rules
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


def ours(flanks, mean, approach):
    """Torques of the pairs -1, 0, 1 on gear 1 [N m] at an approach [mm]."""
    states = flanks.states([mean])
    states["x_0"] = 1e-3 * approach
    nodes = flanks.solve(states, keep_nodes=True)[0][: int(states["n_nodes"][0])]
    torques = flanks.model.pairs["stage"].gear1.r_b * nodes["force"] * (1.0 + 0.5 * nodes["by_xi"])
    return np.array([float(torques[nodes["pair"] == -k].sum()) for k in (-1, 0, 1)])


def by_calculix(flanks, folder, mean, approach):
    """The same by CalculiX, of 10 mm."""
    pair = flanks.model.pairs["stage"]
    mesh = MeshInContact(pair, mean - 0.5e-3 * approach / pair.p_et, BORES)
    return 0.01 * mesh.torques(folder, approach)


@pytest.mark.parametrize("mean", [0.2, 0.5])
def test_between_a_and_e(tmp_path, flanks, mean):
    torques = by_calculix(flanks, tmp_path, mean, 0.014)
    found = ours(flanks, mean, 0.014)
    loaded = torques > 0.0
    assert found[loaded] == pytest.approx(torques[loaded], rel=0.01)
    assert not found[~loaded].any()


@pytest.mark.parametrize(("mean", "pair", "stiffer"), [(0.672, 2, 1.076), (0.922, 0, 1.06)])
def test_tip_edges(tmp_path, flanks, mean, pair, stiffer):
    """Pair 2 leaves beyond E, pair 0 enters before A."""
    approaches = (0.014, 0.017)
    torques, found = (
        [of(*where, x)[pair] for x in approaches]
        for of, where in ((by_calculix, (flanks, tmp_path, mean)), (ours, (flanks, mean)))
    )
    begins = [
        x[0] - y[0] * (x[1] - x[0]) / (y[1] - y[0]) for x, y in ((approaches, torques), (approaches, found))
    ]
    assert begins[1] == pytest.approx(begins[0], rel=2e-3)
    assert np.diff(found) / np.diff(torques) == pytest.approx(stiffer, abs=0.015)


@pytest.mark.parametrize(("means", "pair"), [((0.676, 0.679), 2), ((0.914, 0.91), 0)])
def test_ends_of_contact(tmp_path, flanks, means, pair):
    torques, found = [], []
    for mean in means:
        states = flanks.states([mean])
        states["by_force"], states["force"] = 1, flanks.force_of(20.0)
        flanks.solve(states)
        approach = 1e3 * float(states["x_0"][0])
        found.append(ours(flanks, mean, approach)[pair])
        approach *= 20.0 / by_calculix(flanks, tmp_path, mean, approach).sum()
        torques.append(by_calculix(flanks, tmp_path, mean, approach)[pair])
    ends = [means[1] - y[1] * (means[1] - means[0]) / (y[1] - y[0]) for y in (torques, found)]
    assert ends[1] == pytest.approx(ends[0], abs=1e-3)
