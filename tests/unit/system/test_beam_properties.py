# SPDX-License-Identifier: Apache-2.0
"""Beams with properties over their length: closed forms of deflection, twist, offset mass; wrong lists."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.beam_table import BeamTable
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.model.openfast.elastodyn import read_elastodyn
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from pitchpoint.system.rules.beam_pieces import beam_pieces
from tests.support.rotors import FOLDER

TEXT = """\
bodies:
  tip: {motion: free, mass: 1e-4 kg, inertia_tensor: [1e-6, 1e-6, 1e-6, 0, 0, 0], position: [0, 0, 2 m]}
beams:
  mast: {ends: [ground, tip], axis: [1, 0, 0], pieces: PIECES, properties: {PROPERTIES}}
"""
PLAIN = "position: [0, 1], mass: [3 kg/m, 3 kg/m], bending_1: [20 N m^2, 20 N m^2], bending_2: [80, 80]"


def mast(properties=PLAIN, pieces=8, more=""):
    text = TEXT.replace("PROPERTIES", properties).replace("PIECES", str(pieces)) + more
    model = loads_model(text)
    assert loads_model(dump_model(model)) == model
    return compile_model(model)


def tip_of(system):
    """Place of the tip relative to its start under the loads [m]."""
    rest = find_equilibrium(system).state
    return np.array([rest.q[system.layout.coordinate(f"tip.{c}")] for c in "xyz"])


def test_a_uniform_mast_is_the_cantilever():
    """w = F L^3/(3 E I) in both directions, and omega = 3.516, 22.03 sqrt(E I/(m L^4)) (Euler, Bernoulli)."""
    load = "loads: {push: {body: tip, force: [1e-3 N, 4e-3 N, 0]}}\n"
    moved = tip_of(mast(more=load))
    np.testing.assert_allclose(moved[:2], [1e-3 * 8 / 60, 4e-3 * 8 / 240], rtol=1e-6)
    found = 2.0 * np.pi * np.asarray(find_modes(mast(), count=4).frequency)
    scale = np.sqrt(np.array([20.0, 80.0]) / (3.0 * 2.0**4))
    wanted = np.sort(np.outer([3.51602, 22.0345], scale).ravel())
    np.testing.assert_allclose(found[:3], wanted[:3], rtol=1e-3)


def test_a_tapered_mast_has_the_integral_of_its_flexibility():
    """w = F int (L - z)^2/(E I(z)) dz with a linear stiffness, by quadrature; error of pieces below 1 %."""
    tapered = "position: [0, 1], mass: [3, 1], bending_1: [40, 10], bending_2: [40, 10]"
    moved = tip_of(mast(tapered, 20, "loads: {push: {body: tip, force: [1e-3 N, 0, 0]}}\n"))
    z = np.linspace(0.0, 2.0, 20001)
    assert moved[0] == pytest.approx(1e-3 * np.trapezoid((2.0 - z) ** 2 / (40.0 - 15.0 * z), z), rel=2e-3)


def test_twist_turns_the_axes_about_the_beam():
    """By 30 deg from x towards y: a force along x bends the mast as the compliance in turned axes."""
    turned = f"{PLAIN}, twist: [30 deg, 30 deg]"
    moved = tip_of(mast(turned, more="loads: {push: {body: tip, force: [1e-3 N, 0, 0]}}\n"))
    axis = np.array([np.cos(np.pi / 6), np.sin(np.pi / 6)])
    across = np.array([-axis[1], axis[0]])
    weak, stiff = 8 / 60, 8 / 240
    wanted = 1e-3 * (axis[0] * weak * axis + across[0] * stiff * across)
    np.testing.assert_allclose(moved[:2], wanted, rtol=1e-5)


def test_a_mass_beside_the_axis_twists_the_mast_under_its_weight():
    """Weight across the mast with the centre 0.1 m beside it: twist m g d L^2/(2 G J)."""
    beside = f"{PLAIN}, torsion: [5, 5], center_2: [0.1 m, 0.1 m]"
    text = "gravity: [-0.01 m/s^2, 0, 0]\n"
    model = loads_model(text + TEXT.replace("PROPERTIES", beside).replace("PIECES", "8"))
    system = compile_model(model)
    rest = find_equilibrium(system).state
    turn = rest.q[system.layout.coordinate("tip.spin")]
    # weight along -x at y = 0.1 m: the moment about z is +
    assert turn == pytest.approx(3.0 * 0.01 * 0.1 * 2.0**2 / (2.0 * 5.0), rel=1e-3)
    total = sum(float(r["mass"]) for r in system.records["beam"])
    assert total == pytest.approx(6.0)


def test_files_of_blade_and_tower():
    """Mass of the tower of the report, 347 460 kg, and stiffness and twist of its tables."""
    tower = read_elastodyn(FOLDER / "5MW_Baseline" / "NRELOffshrBsline5MW_Onshore_ElastoDyn_Tower.dat")
    assert np.trapezoid(tower.mass, tower.position) * 87.6 == pytest.approx(347_460, rel=1e-3)
    blade = read_elastodyn(FOLDER / "5MW_Baseline" / "NRELOffshrBsline5MW_Blade.dat")
    assert blade.position.size == 49
    assert blade.mass[0] == pytest.approx(678.935 * 1.04536)
    assert np.degrees(blade.twist[0]) == pytest.approx(-13.308)


WRONG = {
    "position: [0, 1]": ("position: [0, 0.9]", "0 to 1"),
    "mass: [3 kg/m, 3 kg/m]": ("mass: [3 kg/m]", "2 as of position"),
    "bending_1: [20 N m^2, 20 N m^2]": ("bending_1: [20 N m^2, -20 N m^2]", "bending_1"),
    "bending_2: [80, 80]": ("", "has no bending_2"),
}


@pytest.mark.parametrize("word", WRONG)
def test_wrong_properties_are_told(word):
    new, words = WRONG[word]
    with pytest.raises(ModelError) as error:
        mast(PLAIN.replace(word, new))
    told = [str(p) for p in error.value.problems]
    assert any(words in each for each in told), told
    assert all(p.line for p in error.value.problems)


def test_a_section_and_properties_together_are_refused():
    with pytest.raises(ModelError, match="exactly one of section, properties"):
        loads_model(
            TEXT.replace("PROPERTIES", PLAIN)
            .replace("PIECES", "4")
            .replace("pieces:", "section: {diameter: 1 m}, pieces:")
        )


def test_a_file_without_a_table_is_told(tmp_path):
    file = tmp_path / "tower.dat"
    file.write_text("3 NTwInpSt\nHtFract TMassDen TwFAStif\n0 1 2\n", encoding="utf-8")
    with pytest.raises(ModelError, match="TwSSStif"):
        read_elastodyn(file)
    with pytest.raises(ModelError) as error:
        mast(f"elastodyn: {file}")
    assert "beams.mast.properties" in str(error.value)


@pytest.mark.parametrize(
    "given", [{"mass": [1, -1]}, {"axial": [0, 1]}, {"twist": [0, np.nan]}, {"mass": [1]}]
)
def test_tables_that_are_no_beam(given):
    plain = {"position": [0, 1], "mass": [1, 1], "bending_1": [1, 1], "bending_2": [1, 1]}
    with pytest.raises(ModelError):
        BeamTable(**{**plain, **given})


def test_centres_that_differ_by_rounding_are_one():
    """One element, not one for the axial stiffness beside it; 0.1 mm is no rounding."""
    for distance, words in ((1e-15, ["", ".mass"]), (1e-4, ["", ".axial", ".mass"])):
        more = f", shear_center_1: [0.1, 0.1], elastic_1: [{0.1 + distance!r}, {0.1 + distance!r}]"
        pieces = beam_pieces(mast(PLAIN + more).model, "mast", 2.0)
        assert [word for word, *_ in pieces[0].parts] == words
    centre = ", center_1: [1e-15, 1e-15]"
    assert len(beam_pieces(mast(PLAIN + centre).model, "mast", 2.0)[0].parts) == 1
