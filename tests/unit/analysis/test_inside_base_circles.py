# SPDX-License-Identifier: Apache-2.0
"""Contact inside a base circle, before T1 or beyond T2: lengths of roll are negative there.

Gears so stiff that the load is on the path of contact, and shared equally by the pairs on it.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import pytest
import xarray as xr

from pitchpoint.analysis.flank_contact.active_flank import active_flanks
from pitchpoint.analysis.flank_contact.contact_pattern import contact_pattern, on_flank
from pitchpoint.analysis.flank_contact.losses import loss_factor
from pitchpoint.analysis.flank_contact.numbers import contact_numbers
from pitchpoint.analysis.flank_contact.teeth import mesh_teeth, pair_positions
from pitchpoint.contact.root_section import root_section
from pitchpoint.geometry import GearPair
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.model import Model
from pitchpoint.solvers.contact_analysis.lubrication import Operation, with_operation
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from pitchpoint.viz.active_flank_drawing import active_flank_svg
from pitchpoint.viz.contact_page import contacts_page
from pitchpoint.viz.quantities import number

MODEL = """
gears:
  g1: {{number_of_teeth: {z1}, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0{one}}}
  g2: {{number_of_teeth: {z2}, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0{two}}}
meshes:
  stage: {{gears: [g1, g2], contact: {{level: rigid, stiffness: 1e13 N/m, planes: 5}}}}
"""
HELIX = ", helix_angle: 15 deg, hand: {}"
CASES = {
    "pinion with few teeth": (12, 80, "", ""),
    "wheel with few teeth": (80, 12, "", ""),
    "ring": (17, 43, "", ", type: internal"),
    "helical": (9, 60, HELIX.format("left"), HELIX.format("right")),
}
PHASES = 200
every_case = pytest.mark.parametrize("case", CASES)
both_flanks = pytest.mark.parametrize("flank", [1, -1], ids=["front", "back"])


@lru_cache
def model_of(case: str) -> Model:
    z1, z2, one, two = CASES[case]
    return loads_model(MODEL.format(z1=z1, z2=z2, one=one, two=two))


@lru_cache
def analysed(case: str, flank: int = 1) -> xr.Dataset:
    return solve_contact(model_of(case), torque=50.0, positions=PHASES, flank=flank)


def pair_of(case: str) -> GearPair:
    return model_of(case).pairs["stage"]


def ways(data: xr.Dataset) -> np.ndarray:
    """Positions on the path of all nodes [base pitches from A], shape (n_phase, n_pair, n_plane)."""
    return pair_positions(data)[:, :, None] + data["plane_advance"].values


@every_case
@both_flanks
def test_lengths_of_roll_follow_the_path_of_contact(case: str, flank: int) -> None:
    """From T1 with the base pitch; both lengths add up to T1T2, or differ by it in an internal pair."""
    data, pair = analysed(case, flank), pair_of(case)
    roll_1, roll_2 = (data[f"roll_{k}"].values[0] for k in (1, 2))
    way = ways(data)
    on = np.isfinite(roll_1) & (way >= 0.0) & (way <= pair.eps_alpha)
    assert on.sum() > PHASES
    assert min(np.nanmin(roll_1), np.nanmin(roll_2)) < -0.5e-3
    assert roll_1[on] == pytest.approx(pair.T1A + way[on] * pair.p_et, abs=1e-9)
    other = -roll_2 if pair.is_internal else roll_2
    assert (roll_1 + other)[on] == pytest.approx(pair.T1T2, abs=1e-9)


@every_case
@both_flanks
def test_contact_ratio_and_marks(case: str, flank: int) -> None:
    """The contact ratio by tip and base circles of both gears, centre distance and pressure angle."""
    pair, teeth = pair_of(case), mesh_teeth(analysed(case, flank))
    sign = -1.0 if pair.is_internal else 1.0
    legs = [math.sqrt(g.d_Fa**2 - g.d_b**2) / 2.0 for g in (pair.gear1, pair.gear2)]
    path = legs[0] + sign * legs[1] - pair.a_w * math.sin(pair.alpha_wt)
    assert teeth.eps_alpha == pytest.approx(path / pair.gear1.p_bt, rel=1e-12)
    assert teeth.eps_alpha == pytest.approx(pair.eps_alpha, rel=1e-12)
    marks = np.array([pair.T1A, pair.T1B, pair.T1C, pair.T1D, pair.T1E])
    assert teeth.mark_roll[0] == pytest.approx(marks, rel=1e-12)
    assert teeth.mark_roll[1] == pytest.approx(sign * (pair.T1T2 - marks), rel=1e-12)


def test_transverse_load_factor_of_stiff_teeth() -> None:
    """The ring has 2 or 3 pairs in contact, which share the load equally: as that of the standard."""
    assert pair_of("ring").eps_alpha > 2.0
    found = contact_numbers(analysed("ring"))
    assert found["transverse_load_factor"] == pytest.approx([1.0], abs=0.01)


@every_case
@both_flanks
def test_losses_are_those_of_the_sliding_speed(case: str, flank: int) -> None:
    """At the distance from the pitch point the flanks slide with the relative speed of both gears."""
    data, pair = analysed(case, flank), pair_of(case)
    omega_1 = 1.0
    omega_2 = -omega_1 * pair.gear1.z / pair.gear2.z
    distance = ways(data) * pair.p_et - (pair.T1C - pair.T1A)
    normal = np.nan_to_num(data["plane_force"].values[0]) / math.cos(pair.gear1.beta_b)
    lost = np.sum(normal * np.abs(omega_1 - omega_2) * np.abs(distance), axis=(1, 2)).mean()
    # some nodes at the ends of the path are tip edges by their deflection below 1 nm
    assert float(loss_factor(data)[0]) == pytest.approx(lost / (50.0 * omega_1), rel=1e-5)


@every_case
@both_flanks
def test_active_flank_begins_at_the_base_circle(case: str, flank: int) -> None:
    """d_Nf and d_Na of the pair; roll angles are negative where the mate touches inside the base circle."""
    data, pair = analysed(case, flank), pair_of(case)
    step = pair.p_et / PHASES
    marks = mesh_teeth(data).mark_roll
    inside = 0
    for k, (one, gear, ends) in enumerate(
        zip(
            active_flanks(data) or (),
            (pair.gear1, pair.gear2),
            ((pair.d_Nf1, pair.d_Na1), (pair.d_Nf2, pair.d_Na2)),
            strict=True,
        )
    ):
        assert one.geometric_diameter == pytest.approx(np.abs(ends), rel=1e-12)
        rolls = np.sort(marks[k, [0, 4]])[:: -1 if gear.z < 0 else 1]
        assert one.geometric_roll_angle * abs(gear.r_b) == pytest.approx(rolls, rel=1e-12)
        assert one.roll_angle * abs(gear.r_b) == pytest.approx(rolls, abs=1.01 * step)
        on_involute = np.maximum(one.roll_angle * abs(gear.r_b), 0.0)
        assert one.diameter == pytest.approx(2.0 * np.sqrt(gear.r_b**2 + on_involute**2), rel=1e-12)
        if rolls[0] < 0.0:
            inside += 1
            assert one.diameter[0] == pytest.approx(abs(gear.d_b), rel=1e-12)
            text = active_flank_svg(gear, one, name="gear", words="50 N m")
            assert f"roll {number(math.degrees(float(one.roll_angle[0])), 4)}°" in text
    assert inside == 1


@every_case
def test_no_pressure_film_and_flash_temperature_inside_a_base_circle(case: str) -> None:
    """No involute has a positive radius of curvature there; elsewhere on the path they are known."""
    oil = Operation(speed=100.0, friction=0.05, viscosity=0.02)
    data = with_operation(analysed(case), oil)
    least = np.minimum(data["roll_1"].values, data["roll_2"].values)
    place, eps = ways(data)[None], pair_of(case).eps_alpha
    for name in ("pressure", "film_thickness", "flash_temperature"):
        values = data[name].values
        assert np.isnan(values[least <= 0.0]).all()
        assert np.isfinite(values[(least > 0.0) & (place > 0.0) & (place < eps)]).all()
    assert np.isnan(data["edge_pressure"].values[least <= 0.0]).all()
    both = np.isfinite(least)
    teeth = data["number_of_teeth"].values
    slip = 100.0 * np.abs(data["roll_1"].values - data["roll_2"].values * teeth[0] / teeth[1])
    assert data["sliding_speed"].values[both] == pytest.approx(slip[both], rel=1e-12)
    assert all(np.isfinite(contact_numbers(data)[name]) for name in ("loss_share", "max_flash_temperature"))


@pytest.mark.parametrize("case", ["pinion with few teeth", "wheel with few teeth", "ring"])
def test_root_stress_is_the_moment_of_the_force_along_the_base_tangent(case: str) -> None:
    """By the moment of the force about the middle of the section, in the frame of the tooth."""
    data, pair = analysed(case), pair_of(case)
    k = 1 if case.startswith("wheel") else 0
    gear = (pair.gear1, pair.gear2)[k]
    section = root_section(gear)
    roll = data[f"roll_{k + 1}"].values[0]
    inside = roll < 0.0
    assert inside.sum() > 20
    line_load = data["plane_force"].values[0][inside] / data["plane_width"].values[0]
    r_b, tooth = gear.r_b, section.tooth
    # the force touches the circle at T; the involute begins at the x axis
    at = roll[inside] / r_b
    T = r_b * np.stack([np.cos(at), np.sin(at)])
    e = np.stack([-np.sin(at), np.cos(at)]) * -1.0
    middle = np.array([math.cos(tooth.form.psi_b), math.sin(tooth.form.psi_b)])
    arm = T - tooth.distance * middle[:, None]
    moment = np.abs(arm[0] * e[1] - arm[1] * e[0])
    across = np.abs(middle[0] * e[1] - middle[1] * e[0])
    L = tooth.chord * across / moment  # s_Fn over h_F
    Y_S = (1.2 + 0.13 * L) * section.notch_parameter ** (1.0 / (1.21 + 2.3 / L))
    stress = 6.0 * line_load * moment / tooth.chord**2 * Y_S
    others = float(data["rim_factor"].values[k] * data["helix_factor"].values[k])
    found = data["root_stress"].values[0, ..., k][inside]
    assert found == pytest.approx(stress * others, rel=1e-9)


@every_case
def test_patterns_do_not_fold_at_the_base_circle(case: str) -> None:
    """A place on the flank for each place of the path."""
    data, pair = analysed(case), pair_of(case)
    k = 2 if case.startswith("wheel") else 1
    field = on_flank(contact_pattern(data), "line_load", k)
    marks = mesh_teeth(data).mark_roll[k - 1, [0, 4]]
    assert field.place[[0, -1]] == pytest.approx(np.sort(marks), abs=2e-6)
    assert field.place[0] < -0.5e-3
    known = np.isfinite(field.values[:, 2])
    assert known[2:-2].all()
    assert "Flanks in contact" in contacts_page(
        {"m": data}, gears={"m": {"g1": pair.gear1, "g2": pair.gear2}}
    )
