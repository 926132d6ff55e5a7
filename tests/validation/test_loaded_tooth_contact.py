# SPDX-License-Identifier: Apache-2.0
"""FC-9, FC-10, FC-7: closed forms of the transmission error and of the face load factor, Hertz at C.

Rigid tooth surfaces with exponent 1 are independent springs of the stiffness c′ per face width, so that the
closed forms of independent springs apply (derived here, sources as for Harris maps: S. L. Harris, Proc. Inst.
Mech. Eng. 172 (1958)):

* TE_pp = w/(2c′) without relief and 1 < ε_α < 2; |w/c′ − C_a|/2 with linear relief C_a from the ends of
  single contact.
* K_Hβ of a linear gap f: 1 + c f/(2w) while c f ≤ 2w, else √(2cf/w); of a crowning C with contact over the
  whole width: 1 + cC/(3w).

n contact planes approach the closed forms with partial contact, or with crowning, as 1/n²; the sums over the
planes are met to 1e-9. c = 16.70 N/(mm µm), w = 1319.34 N/mm.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.flank_contact.load_factors import face_load_factor, load_over_width
from pitchpoint.analysis.flank_contact.losses import loss_factor
from pitchpoint.analysis.flank_contact.numbers import contact_numbers
from pitchpoint.geometry.sliding import loss_factor_integral
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from tests.support.contact_files import fzg

B = 14e-3
C = 16.70e9
W = 1319.34e3
ROUNDED = 4e-5
"""The three factors were computed before c and w were rounded."""
SINGLE = 0.75
"""Mesh phase in the range of single contact."""


def torque_of(model, w):
    return w * B * model.pairs["stage"].gear1.r_b


def factor(model, phase=SINGLE, **options):
    """Face load factor at one phase."""
    data = solve_contact(model, torque=torque_of(model, W), positions=4, **options)
    return float(face_load_factor(load_over_width(data.sel(mesh_phase_position=[phase])))[0])


def of_planes(gap, w=W, c=C):
    """Face load factor of independent planes with the given gaps [m]: penetration by bisection."""
    low, high = gap.min(), gap.max() + 2.0 * w / c
    for _ in range(200):
        x = 0.5 * (low + high)
        low, high = (x, high) if c * np.maximum(x - gap, 0.0).mean() < w else (low, x)
    return float(face_load_factor(c * np.maximum(x - gap, 0.0)))


@pytest.mark.parametrize("planes", [5, 11, 31])
def test_linear_gap_with_contact_over_the_whole_width(tmp_path, planes):
    model = fzg(tmp_path, k=C * B, planes=planes)
    assert 1.0 + C * 50e-6 / (2.0 * W) == pytest.approx(1.31645, abs=ROUNDED)
    assert factor(model, misalignment=50e-6 / B) == pytest.approx(1.0 + C * 50e-6 / (2.0 * W), abs=1e-9)
    # two pairs in contact are springs of twice the stiffness
    doubled = 1.0 + C * 50e-6 / W
    assert factor(model, phase=0.25, misalignment=50e-6 / B) == pytest.approx(doubled, abs=1e-9)


def test_linear_gap_with_contact_over_a_part_of_the_width(tmp_path):
    closed = np.sqrt(2.0 * C * 200e-6 / W)
    assert closed == pytest.approx(2.25011, abs=ROUNDED)
    errors = []
    for planes in (11, 101):
        z = (np.arange(planes) + 0.5) / planes
        found = factor(fzg(tmp_path, k=C * B, planes=planes), misalignment=200e-6 / B)
        assert found == pytest.approx(of_planes(200e-6 * z), abs=1e-9)
        errors.append(abs(found - closed))
    # within a plane the end of contact changes the sum by up to an eighth of the square of its share
    assert errors[0] < 2.25 / (8.0 * (0.889 * 11) ** 2)
    assert errors[1] < 2.25 / (8.0 * (0.889 * 101) ** 2)


def test_crowning_with_contact_over_the_whole_width(tmp_path):
    """Even numbers of planes have none in the middle of the face."""
    crowned = ("modifications: {both: {lead_crowning: 7 um}}", "")
    found = factor(fzg(tmp_path, k=C * B, planes=16, gears=crowned))
    z = (np.arange(16) + 0.5) / 16 - 0.5
    gap = 4.0 * 7e-6 * z**2
    assert found == pytest.approx(1.0 + C * (gap.mean() - gap.min()) / W, abs=1e-9)
    # odd numbers have one: 1 + c C/(3w) (1 - 1/n²)
    assert 1.0 + C * 7e-6 / (3.0 * W) == pytest.approx(1.02954, abs=ROUNDED)
    n = 31
    close = 1.0 + C * 7e-6 / (3.0 * W) * (1.0 - 1.0 / n**2)
    assert factor(fzg(tmp_path, k=C * B, planes=n, gears=crowned)) == pytest.approx(close, abs=1e-9)


def test_transmission_error_without_relief(tmp_path):
    model = fzg(tmp_path, k=C * B)
    torques = [torque_of(model, w) for w in (200e3, W)]
    found = contact_numbers(solve_contact(model, torque=torques))
    assert found["transmission_error_pp"] == pytest.approx([200e3 / (2.0 * C), W / (2.0 * C)], rel=1e-9)
    assert found["unloaded_transmission_error_pp"] == pytest.approx([0.0, 0.0], abs=1e-15)


@pytest.mark.parametrize("w", [0.4, 1.0, 1.6])
def test_transmission_error_with_long_linear_relief(tmp_path, w):
    """C_a = 40 µm; w/c′ in units of it."""
    C_a = 40e-6
    pair = fzg(tmp_path).pairs["stage"]
    at_D = 2.0 * np.hypot(pair.gear1.r_b, pair.T1D)
    at_B = 2.0 * np.hypot(pair.gear2.r_b, pair.T1T2 - pair.T1B)
    relief = "modifications: {{both: {{tip_relief: {{amount: 40 um, start_diameter: {d:.12f} m}}}}}}"
    model = fzg(tmp_path, k=C * B, gears=(relief.format(d=at_D), relief.format(d=at_B)))
    data = solve_contact(model, torque=torque_of(model, w * C_a * C), positions=200)
    found = float(contact_numbers(data)["transmission_error_pp"][0])
    assert found == pytest.approx(abs(w - 1.0) * C_a / 2.0, abs=1e-9 * C_a)


def test_pressure_at_the_pitch_point(tmp_path):
    """FC-7: 302 N m on FZG gears type C, 14 mm wide: 1655.55 MPa at C without Z_ε (ISO 6336-2)."""
    model = fzg(tmp_path)
    pair = model.pairs["stage"]
    at_C = (pair.T1C - pair.T1A) / pair.p_et
    data = solve_contact(model, torque=302.0, positions=2000)
    near = int(np.abs(data["mesh_phase_position"].values - at_C).argmin())
    pressure = float(data["pressure"].isel(mesh_phase_position=near).max()) * 1e-6
    assert pressure == pytest.approx(1655.55, rel=2e-4)


def test_loss_factor_of_stiff_teeth(tmp_path):
    """Without deformation the load is shared as in Ohlendorf's formula; 2000 positions meet the jumps of the
    load to 1e-3 of the loss."""
    model = fzg(tmp_path, k=1e13)
    data = solve_contact(model, torque=302.0, positions=2000)
    assert float(loss_factor(data)[0]) == pytest.approx(loss_factor_integral(model.pairs["stage"]), rel=1e-3)
