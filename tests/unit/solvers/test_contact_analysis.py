# SPDX-License-Identifier: Apache-2.0
"""Dataset of a contact analysis: geometry of the mesh, numbers of tooth pairs, places of contact."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from pitchpoint.analysis.flank_contact.load_factors import face_load_factor, load_over_width
from pitchpoint.analysis.flank_contact.losses import sliding_radius
from pitchpoint.analysis.flank_contact.teeth import mesh_teeth, pair_positions
from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.contact_analysis.law_fit import fit_analytic_law
from pitchpoint.solvers.contact_analysis.levels import compare_levels
from pitchpoint.solvers.contact_analysis.on_shafts import solve_contacts_on_shafts
from pitchpoint.solvers.contact_analysis.precompute import TableRequest, contact_table
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from tests.support.contact_files import fzg
from tests.support.relief_models import pair

PAIRS = {
    "spur": ("", "", 60),
    "right": ("helix_angle: 18 deg, hand: right, ", "helix_angle: 18 deg, hand: left, ", 60),
    "left": ("helix_angle: 18 deg, hand: left, ", "helix_angle: 18 deg, hand: right, ", 60),
    "internal": (
        "helix_angle: 12 deg, hand: right, ",
        "helix_angle: 12 deg, hand: right, type: internal, ",
        70,
    ),
}
TEXT = """
gears:
  g1: {{number_of_teeth: 25, {one}normal_module: 3 mm, face_width: 40 mm, profile_shift_coefficient: 0}}
  g2: {{number_of_teeth: {z}, {two}normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}}
bodies:
  a: {{gears: [g1], motion: torsion}}
  b: {{gears: [g2], motion: torsion}}
meshes:
  m: {{gears: [g1, g2], contact: {{level: rigid, stiffness: 4e8 N/m, planes: 9}}}}
"""


def analysed(folder: Path, pair: str, flank: int, torque: float = 500.0) -> xr.Dataset:
    one, two, z = PAIRS[pair]
    path = folder / "pair.yaml"
    path.write_text(TEXT.format(one=one, two=two, z=z), encoding="utf-8")
    return solve_contact(load_model(path), torque=torque, positions=24, flank=flank)


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("flank", [1, -1])
def test_contacts_are_where_the_numbers_of_the_pairs_say(tmp_path: Path, pair: str, flank: int) -> None:
    """On the line of action: position of the pair plus the advance of the plane, on both gears."""
    data = analysed(tmp_path, pair, flank)
    teeth = mesh_teeth(data)
    along = pair_positions(data)[:, :, None] + teeth.advance
    inside = (along > 1e-9) & (along < teeth.eps_alpha - 1e-9)
    force = data["plane_force"].values[0]
    touching = inside & (force > 0.0)
    assert touching.sum() > 100
    way = along[touching] * teeth.base_pitch
    for gear in (0, 1):
        sign = np.sign(teeth.mark_roll[gear, 4] - teeth.mark_roll[gear, 0])
        expected = teeth.mark_roll[gear, 0] + sign * way
        assert data[f"roll_{gear + 1}"].values[0][touching] == pytest.approx(expected, abs=1e-12)
    assert np.all(force[inside] > 0.0)
    # tip edges: off the line of action, up to half a base pitch
    outside = ~inside & (force > 0.0)
    assert np.all((along[outside] > -0.5) & (along[outside] < teeth.eps_alpha + 0.5))


@pytest.mark.parametrize("pair", PAIRS)
def test_geometry_of_the_mesh_without_the_model(tmp_path: Path, pair: str) -> None:
    data = analysed(tmp_path, pair, 1)
    teeth = mesh_teeth(data)
    model = load_model(tmp_path / "pair.yaml")
    found = model.pairs["m"]
    assert teeth.base_pitch == pytest.approx(found.p_et, rel=1e-12)
    assert teeth.eps_alpha == pytest.approx(found.eps_alpha, rel=1e-12)
    assert teeth.eps_beta == pytest.approx(found.eps_beta, rel=1e-12, abs=1e-15)
    assert teeth.width.sum() == pytest.approx(found.b_w, rel=1e-12)
    # no sliding at C
    assert sliding_radius(*teeth.mark_roll[:, 2:3], teeth) == pytest.approx([0.0], abs=1e-12)


def test_the_force_of_all_planes_is_that_of_the_torque(tmp_path: Path) -> None:
    data = analysed(tmp_path, "right", 1)
    force = data["plane_force"].sum(("tooth_pair", "plane"))
    assert np.asarray(force) == pytest.approx(np.asarray(data["mesh_force"]), rel=1e-9)
    radius = float(data["base_radius"][0])
    assert np.asarray(force) == pytest.approx(np.full((1, 24), 500.0 / radius), rel=1e-9)


def test_attributes_describe_the_contact(tmp_path: Path) -> None:
    data = analysed(tmp_path, "spur", -1)
    assert (data.attrs["level"], data.attrs["planes"], data.attrs["stiffness"]) == ("rigid", 9, 4e8)
    assert '"flank": -1' in data.attrs["options"]


def test_what_it_refuses(tmp_path: Path) -> None:
    model = fzg(tmp_path)
    with pytest.raises(SolverError, match="no mesh 'x'; there are: stage") as caught:
        solve_contact(model, "x", torque=1.0)
    assert caught.value.status == INCONSISTENT
    for torque in (0.0, [1.0, float("nan")], [], ["x"], "5", True, [[1.0], [2.0, 3.0]]):
        with pytest.raises(SolverError, match="is not a load; give a number other than 0, in N m"):
            solve_contact(model, torque=torque)
    for analyse in (solve_contact, compare_levels):
        for angle in (1.0, -0.11, float("nan"), float("-inf"), "x", True):
            with pytest.raises(SolverError, match=r"is out of range \(limit -0.1 to 0.1 rad\); give the gap"):
                analyse(model, torque=5.0, misalignment=angle)
    with pytest.raises(SolverError, match="2 values; give one"):
        compare_levels(model, torque=[1.0, 2.0])


@pytest.mark.parametrize("positions", [0, 3, -8, 8.0, True, "8", None, 100_001])
def test_numbers_of_positions_that_are_refused(positions: object, tmp_path: Path) -> None:
    model = fzg(tmp_path)
    for analyse in (solve_contact, compare_levels):
        with pytest.raises(SolverError, match=r"positions: .* is out of range \(limit 4 to 100000\); give a"):
            analyse(model, torque=5.0, positions=positions)
    with pytest.raises(SolverError, match="positions: "):
        solve_contacts_on_shafts(model, positions=positions)


@pytest.mark.parametrize("flank", [0, 2, "front", "back", True, 1.0, None])
def test_flanks_that_are_refused(flank: object, tmp_path: Path) -> None:
    model = fzg(tmp_path)
    for analyse in (solve_contact, compare_levels, fit_analytic_law):
        with pytest.raises(SolverError, match=r"flank: .* is not a flank \(limit 1 or -1\); give 1"):
            analyse(model, torque=5.0, flank=flank)
    with pytest.raises(SolverError, match="flank: "):
        contact_table(model, "stage", TableRequest(torque=5.0), flank)


def test_all_problems_of_an_analysis_are_in_one_error(tmp_path: Path) -> None:
    with pytest.raises(SolverError) as caught:
        solve_contact(fzg(tmp_path), torque=0.0, positions=1, misalignment=2.0, flank=3, root_stress="fe")
    assert caught.value.status == INCONSISTENT
    assert str(caught.value).splitlines()[0] == "5 problems"
    for words in ("torque 0.0", "positions: 1", "misalignment: 2.0", "flank: 3", "root_stress 'fe'"):
        assert words in str(caught.value)


def test_load_in_few_planes_is_noted(tmp_path: Path) -> None:
    """A gap of 50 mrad leaves one of nine planes under load; K_Hβ of it is 1.5 × 9."""
    analysed(tmp_path, "spur", 1)
    model = load_model(tmp_path / "pair.yaml")
    data = solve_contact(model, torque=[500.0, 100.0], positions=4, misalignment=0.05)
    (note,) = data.attrs["notes"].split("; ")
    assert "load in only 1 of 9 planes at 500 N m" in note
    assert "up to 13.5 (1.5 × planes)" in note
    assert face_load_factor(load_over_width(data)) == pytest.approx([13.5, 13.5])
    assert solve_contact(model, torque=500.0, positions=4).attrs["notes"] == ""


def test_misalignment_of_one_plane_is_noted() -> None:
    model = pair(contact="level: rigid, stiffness: 3e8 N/m, planes: 1")
    tilted, level = (solve_contact(model, torque=100.0, positions=4, misalignment=k) for k in (0.01, 0.0))
    assert np.array_equal(tilted.transmission_error, level.transmission_error)
    assert tilted.attrs["notes"].startswith("mesh stage: misalignment has no effect with one contact plane")
    assert level.attrs["notes"] == ""
