# SPDX-License-Identifier: Apache-2.0
"""Root stress in the dataset of a contact analysis: loads, symmetries, gears without a result."""

from __future__ import annotations

import math
from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from pitchpoint.analysis.flank_contact.numbers import contact_numbers
from pitchpoint.analysis.flank_contact.root_stress import root_stress_of_tooth, root_stress_over_width
from pitchpoint.contact.root_section import helix_factor, root_section
from pitchpoint.contact.tooth_fe.solve import tooth_fe
from pitchpoint.contact.tooth_fe.tooth_model import Resolution, ToothModel
from pitchpoint.core.errors import SolverError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.contact_analysis import root_stress
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from pitchpoint.system.rules import flexible_teeth
from tests.support.contact_files import fzg

PAIR = """
gears:
  g1: {{number_of_teeth: 25, {one}normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0.2}}
  g2: {{number_of_teeth: {z}, {two}normal_module: 3 mm, face_width: 20 mm,
       profile_shift_coefficient: 0{more}}}
meshes:
  m: {{gears: [{order}], contact: {{level: {level}, planes: 5}}}}
"""
COARSE = Resolution(heights=4, widths=4, fillet_points=4)


@lru_cache(maxsize=16)
def coarse(geometry):
    return tooth_fe(ToothModel(gear=geometry, resolution=COARSE))


@pytest.fixture
def elements(monkeypatch):
    """Finite elements that take a fraction of a second."""
    for module in (root_stress, flexible_teeth):
        monkeypatch.setattr(module, "finite_elements_of", lambda gear: coarse(gear.geometry))


def pair(one="", two="", z=31, order="g1, g2", more="", level="rigid, stiffness: 4e8 N/m"):
    return loads_model(PAIR.format(one=one, two=two, z=z, order=order, more=more, level=level))


def hands(first: str, second: str) -> tuple[str, str]:
    one, two = (f"helix_angle: 15 deg, hand: {hand}, " for hand in (first, second))
    return one, two


def analysed(model, **options) -> xr.Dataset:
    return solve_contact(model, torque=options.pop("torque", 200.0), positions=16, **options)


def test_uniform_load_gives_the_stress_of_the_standard(tmp_path: Path) -> None:
    """Where one pair is in contact: F_t/(b m_n) Y_F Y_S at the height of the load; else its share of it."""
    model = fzg(tmp_path)
    data = analysed(model)
    force = data["plane_force"].values[0]
    for k, name in enumerate(("g1", "g2")):
        gear = model.gears[name].geometry
        section = root_section(gear)
        stress, roll = data["root_stress"].values[0, ..., k], data[f"roll_{k + 1}"].values[0]
        F_t = 200.0 / (0.5 * model.gears["g1"].geometry.d)
        load = F_t / (14e-3 * gear.m_n) * np.prod(section.factors(roll), axis=0)
        single = np.isclose(
            np.nansum(force, axis=(1, 2), keepdims=True), np.nansum(force, axis=2, keepdims=True)
        )
        single = single & np.isfinite(stress)
        assert single.sum() > 20
        assert stress[single] == pytest.approx(load[single], rel=1e-9)
        shared = np.isfinite(stress) & ~single
        assert (stress[shared] < load[shared]).all()
    assert (np.isnan(data["root_stress"].values[..., 0]) == np.isnan(data["plane_force"].values)).all()
    assert data["root_chord"].values[0] == root_section(model.gears["g1"].geometry).chord


def test_helix_and_rim_factors_apply() -> None:
    """A rim of 0.8 h_t has Y_B = 1.6 ln(2.242/0.8); both factors change the stress only."""
    model = pair(
        *hands("right", "left"), more=", rim_thickness: 5.4 mm, web_thickness: 6 mm, bore_diameter: 30 mm"
    )
    data = analysed(model)
    assert data["helix_factor"].values == pytest.approx(
        helix_factor(math.radians(15.0), model.pairs["m"].eps_beta)
    )
    assert data["rim_factor"].values == pytest.approx([1.0, 1.6 * math.log(2.242 / 0.8)])
    plain = analysed(pair(*hands("right", "left")))
    ratio = data["root_stress"].values[..., 1] / plain["root_stress"].values[..., 1]
    assert ratio[np.isfinite(ratio)] == pytest.approx(data["rim_factor"].values[1], rel=1e-6)


def test_swapped_gears_swap_their_stresses(elements) -> None:
    one = analysed(pair(), root_stress="finite_elements")
    ratio = 31.0 / 25.0
    two = analysed(pair(order="g2, g1"), root_stress="finite_elements", torque=200.0 * ratio)
    a, b = contact_numbers(one), contact_numbers(two)
    # phases of the other gear as the driving one lie between those of the first
    for name in ("root_stress", "root_stress_fe", "root_stress_fe_min"):
        assert a[f"{name}_1"] == pytest.approx(b[f"{name}_2"], rel=0.02)
        assert a[f"{name}_2"] == pytest.approx(b[f"{name}_1"], rel=0.02)


@pytest.mark.parametrize("z", [31, 70])
@pytest.mark.parametrize("level", ["rigid, stiffness: 4e8 N/m", "flexible, teeth: finite_elements"])
def test_mirrored_gears_have_the_same_stress_on_the_other_flanks(elements, z: int, level: str) -> None:
    """Mirror image in the transverse plane: other hand, other flank, same place over the width. Helical teeth
    are stiffer at the obtuse end, which is the other one on right flanks."""
    kind = "" if z == 31 else "type: internal, "
    first = hands("right", "left" if z == 31 else "right")
    second = hands("left", "right" if z == 31 else "left")
    options = {"misalignment": 2e-4, "root_stress": "finite_elements"}
    front = analysed(pair(first[0], kind + first[1], z, level=level), flank=1, **options)
    back = analysed(pair(second[0], kind + second[1], z, level=level), flank=-1, **options)
    for name in ("plane_force", "root_stress", "root_stress_fe", "root_stress_fe_min", "root_tangent_fe"):
        most = np.nanmax(np.abs(front[name].values))
        assert np.asarray(back[name]) == pytest.approx(
            np.asarray(front[name]), rel=1e-6, abs=1e-6 * most, nan_ok=True
        )


def test_stress_is_proportional_to_load_of_given_distribution(elements, tmp_path: Path) -> None:
    """Rigid spur gears: twice the load on the same places in single contact; neighbours follow by FE."""
    model = fzg(tmp_path)
    one, two = (
        contact_numbers(analysed(model, torque=torque, root_stress="finite_elements"))
        for torque in (1e-3, 2e-3)
    )
    for name in ("root_stress_1", "root_stress_2", "root_stress_fe_1", "root_stress_fe_min_2"):
        assert two[name] == pytest.approx(2.0 * one[name], rel=1e-5)


def test_load_of_the_next_tooth_compresses_the_fillet(elements) -> None:
    """Before A the tooth ahead of gear 1 is loaded: it presses on the tooth space at the loaded flank, and on
    gear 2 on the other space. Beyond E it is reversed."""
    data = analysed(pair(), torque=600.0, root_stress="finite_elements")
    way, by_tangent = root_stress_of_tooth(data)
    stress = root_stress_of_tooth(data, 0, "root_stress_fe")[1]
    before, beyond = (np.isnan(by_tangent[0]) & side for side in ((way > -0.3) & (way < 0.0), way > 1.0))
    for free, gear in ((before, 0), (beyond, 1)):
        assert free.sum() >= 2
        assert (stress[gear, free] < 0.0).all()
        assert (stress[1 - gear, free] > 0.0).all()


def test_both_methods_and_their_places(elements) -> None:
    data = analysed(pair(), misalignment=1e-3, root_stress="finite_elements")
    numbers = contact_numbers(data)
    for end in ("", "_fe"):
        over = root_stress_over_width(data, f"root_stress{end}")
        way, course = root_stress_of_tooth(data, 0, f"root_stress{end}")
        assert over.shape == (1, 2, 5)
        assert way.size == course.shape[1]
        for k in (0, 1):
            top = float(numbers[f"root_stress{end}_{k + 1}"][0])
            assert top == over[0, k].max() == np.nanmax(course[k])
            # the gap increases towards +z
            assert numbers[f"root_position{end}_{k + 1}"][0] < 0.0
    assert (numbers["root_stress_fe_min_1"] < 0.0).all()
    assert "finite elements (order 4, 4 polynomials" in data.attrs["root_stress"]


def test_default_method_follows_the_teeth_of_the_contact(elements) -> None:
    assert "root_stress_fe" not in analysed(pair())
    assert "root_stress_fe" in analysed(pair(), root_stress="finite_elements")
    with pytest.raises(SolverError, match="'fe' is not a method; choose tangent or finite_elements"):
        analysed(pair(), root_stress="fe")


def test_a_root_without_the_tangent_is_a_note(elements) -> None:
    """An internal gear with sharp root corners has no fillet."""
    data = analysed(
        pair(z=70, two="type: internal, ", more=", rack: {root_radius: 0}"), root_stress="finite_elements"
    )
    numbers = contact_numbers(data)
    assert np.isfinite(numbers["root_stress_1"]).all()
    assert np.isnan(numbers["root_stress_2"]).all()
    assert np.isnan(numbers["root_stress_fe_2"]).all()
    notes = data.attrs["notes"].split("; ")[-2:]
    assert notes[0] == (
        "gear g2: no root stress at the tangent of the fillet, root_fillet_radius: has no tangent at 60° to "
        "the centre line of the tooth, the critical section"
    )
    assert notes[1].startswith("gear g2: no root stress by finite elements, root_fillet_radius: ")
