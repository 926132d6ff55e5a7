# SPDX-License-Identifier: Apache-2.0
"""Beams with properties over their length: closed forms of deflection, twist, offset mass; wrong lists."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.beam_table import BeamTable
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.model.openfast.elastodyn import read_elastodyn
from pitchpoint.model.remarks.collect import remarks_of
from pitchpoint.report.defaults import defaults
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from pitchpoint.system.rules.beam_pieces import beam_pieces
from tests.support.rotors import FOLDER
from tests.support.windio import VERSION_2

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
    """A shear centre at the axis except for rounding makes no coupled element; 0.1 mm does."""
    for distance, coupled in ((1e-15, 0), (1e-4, 1)):
        more = f", gyration: [0.1, 0.1], shear_center_1: [{distance!r}, {distance!r}]"
        system = mast(PLAIN + more)
        pieces = beam_pieces(system.model, "mast", 2.0)
        assert [word for word, *_ in pieces[0].parts] == ["", ".mass"]
        assert system.records["beam"]["coupled"].max() == coupled
    centre = ", center_1: [1e-15, 1e-15]"
    assert len(beam_pieces(mast(PLAIN + centre).model, "mast", 2.0)[0].parts) == 1


K = np.diag([1e5, 1e5, 1e5, 80.0, 20.0, 5.0])
M = np.diag([3.0, 3.0, 3.0, 0.02, 0.01, 0.03])
SAME = f"position: [0, 1], stiffness: {2 * [K.tolist()]}, inertia: {2 * [M.tolist()]}"


def test_section_matrices_are_the_lists():
    """Diagonal matrices as lists of the same section: deflection under forces and a moment, but for products
    of the twist of 4e-4 rad."""
    load = "loads: {push: {body: tip, force: [1e-3 N, 4e-3 N, 0], moment: [0, 0, 1e-3 N m]}}\n"
    lists = f"{PLAIN}, torsion: [5, 5], axial: [1e5, 1e5], shear_1: [1e5, 1e5], shear_2: [1e5, 1e5]"
    np.testing.assert_allclose(tip_of(mast(SAME, more=load)), tip_of(mast(lists, more=load)), rtol=1e-5)


def test_offsets_in_matrices_are_the_centres_of_lists():
    """Elastic centre (0.1, -0.2) m and shear centre (-0.3, 0.1) m of lists, and their terms of the matrix."""
    (x, y), (u, v) = (0.1, -0.2), (-0.3, 0.1)
    lists = f"{PLAIN}, torsion: [5, 5], axial: [1e5, 1e5], shear_1: [1e5, 1e5], shear_2: [2e5, 2e5]"
    for name, (one, two) in {"elastic": (x, y), "shear_center": (u, v)}.items():
        lists += f", {name}_1: [{one}, {one}], {name}_2: [{two}, {two}]"
    own = np.diag([1e5, 2e5, 1e5, 80.0 + 1e5 * y * y, 20.0 + 1e5 * x * x, 5.0 + 1e5 * v * v + 2e5 * u * u])
    for (i, j), value in {
        (2, 3): 1e5 * y,
        (2, 4): -1e5 * x,
        (3, 4): -1e5 * x * y,
        (0, 5): -1e5 * v,
        (1, 5): 2e5 * u,
    }.items():
        own[i, j] = own[j, i] = value
    found = [
        mast(text, 2).records["beam"][0]
        for text in (lists, SAME.replace(str(2 * [K.tolist()]), str(2 * [own.tolist()])))
    ]
    whole = [np.diag([b["k_u"], b["k_t"], b["k_d"], b["k_s"], b["k_d"], b["k_s"]]) + b["Q"] for b in found]
    np.testing.assert_allclose(whole[0], whole[1], atol=1e-9 * np.abs(whole[1]).max())


def test_defaults_are_those_in_effect():
    """Section matrices leave no lists of stiffnesses; lists leave no matrices."""
    for properties, shown, idle in (
        (SAME, {"twist", "offset_1", "damping"}, {"torsion", "axial", "gyration"}),
        (PLAIN, {"twist", "torsion", "gyration"}, {"damping"}),
    ):
        found = {key for key, _ in defaults(mast(properties).model)}
        assert {f"beams.mast.properties.{name}" for name in shown} <= found
        assert not {f"beams.mast.properties.{name}" for name in idle} & found


def test_internal_damping_is_a_default_only_without_damping_of_the_sections(tmp_path):
    """That of a windIO file counts, as does that of lists."""
    damped = "structural_damping: {mu: [0.003, 0.002, 0.001, 0.002, 0.003, 0.001]}"
    text = VERSION_2.replace("elastic_properties:\n", f"elastic_properties:\n        {damped}\n", 1)
    for number, (contents, shown) in enumerate(((VERSION_2, True), (text, False))):
        (tmp_path / f"{number}.yaml").write_text(contents)
        model = TEXT.replace("2 m]", "30 m]").replace("PIECES", "1")
        model = model.replace("PROPERTIES", f"windio: {tmp_path}/{number}.yaml, component: blade")
        assert (("beams.mast.internal_damping", "0 s") in defaults(loads_model(model))) is shown


def with_entry(i, j, value):
    """Properties with another entry of the second stiffness matrix."""
    other = K.copy()
    other[i, j] = value
    return SAME.replace(str(2 * [K.tolist()]), str([K.tolist(), other.tolist()]))


WRONG_MATRICES = {
    "not symmetric": (with_entry(3, 5, 1.0), "stiffness[1]", "is not symmetric"),
    "not definite": (with_entry(3, 3, 0.0), "stiffness[1]", "is not positive definite"),
    "negative": (with_entry(4, 4, -20.0), "stiffness[1]", "is not positive"),
    "mass": (SAME.replace("0.03]", "-0.03]"), "inertia", "is not positive"),
    "one": (SAME.replace(f", {M.tolist()}]", "]"), "inertia", "1 is the number of matrices (limit 2 as of"),
    "both": (f"{SAME}, mass: [3, 3]", "mass", "is in the section matrices too; remove it, or stiffness"),
    "alone": (SAME[: SAME.index(", inertia")], "stiffness", "inertia"),
    "place": (SAME.replace("[0, 1]", "[0, 0.5]"), "position", "is not a list of increasing places"),
    "five": (f"{SAME}, damping: [1, 1, 1, 1, 1]", "damping", "is out of range (limit six values >= 0)"),
}


@pytest.mark.parametrize("word", WRONG_MATRICES)
def test_wrong_section_matrices_are_told(word):
    properties, place, words = WRONG_MATRICES[word]
    with pytest.raises(ModelError) as error:
        mast(properties)
    told = [str(p) for p in error.value.problems]
    assert any(place in each and words in each for each in told), told
    assert all(p.line for p in error.value.problems)


def test_problems_at_one_line_are_in_the_order_of_the_keys():
    """Not in that of a set, which changes from process to process."""
    with pytest.raises(ModelError) as error:
        mast(f"{SAME}, gyration: [1, 1], mass: [3, 3], bending_2: [3, 3], bending_1: [3, 3]")
    keys = [p.where.rpartition(".")[2] for p in error.value.problems]
    assert keys == ["mass", "bending_1", "bending_2", "gyration"]


def test_a_section_that_is_not_flat_is_noted():
    """Entry 66 of 0.06 beside 0.02 + 0.01: 50 %."""
    text = TEXT.replace("PROPERTIES", SAME).replace("PIECES", "4")
    notes = [str(note) for note in remarks_of(loads_model(text.replace("0.03]", "0.06]")))]
    assert any("beams.mast.properties" in note and "by up to 50 %" in note for note in notes), notes
    assert not any("entry 66" in str(note) for note in remarks_of(loads_model(text)))


def test_section_matrices_of_the_page():
    """docs/howto/wind_turbine.md: a force bends the mast to one side and twists it, L = 10 m."""
    page = (Path(__file__).parents[3] / "docs" / "howto" / "wind_turbine.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```yaml\n(.*?)^```", page, re.DOTALL | re.MULTILINE)
    (block,) = (text for text in blocks if "&stiff" in text)
    bodies = TEXT[: TEXT.index("beams:")].replace("tip:", "top:").replace("2 m", "10 m")
    system = compile_model(loads_model(f"{bodies}{block}loads: {{pull: {{body: top, force: [0, 1, 0]}}}}\n"))
    rest = find_equilibrium(system).state
    moved = [rest.q[system.layout.coordinate(f"top.{c}")] for c in ("y", "spin")]
    S = np.linalg.inv([[4e9, 5e8], [5e8, 6e8]])
    assert moved == pytest.approx([S[0, 0] * 1000 / 3 + 10 / 2e8, -S[0, 1] * 50], rel=1e-6)
