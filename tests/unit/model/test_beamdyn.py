# SPDX-License-Identifier: Apache-2.0
"""Files of BeamDyn: what is read, and a sentence with file and line for what is not."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from pitchpoint.core.errors import ModelError, PitchpointError
from pitchpoint.geometry.section_matrix import section_properties, symmetric
from pitchpoint.model.openfast.beamdyn import beam_table, read_beamdyn
from tests.support.beamdyn import TABLE, axis_of, matrices, write_beamdyn


@pytest.fixture
def primary(tmp_path):
    """Files of the NREL 5 MW blade, prebent by 2 m upwind; the path of the primary one."""
    return write_beamdyn(tmp_path, *matrices(), axis_of(-2.0))


def test_blade_of_the_nrel_5mw(primary):
    table = read_beamdyn(primary)
    assert table.length == pytest.approx(61.5)
    assert table.offset_1[-1] == pytest.approx(-2.0)
    assert table.twist[0] == pytest.approx(-np.radians(13.308))
    assert table.position.size == len(TABLE)
    np.testing.assert_allclose(table.bending_1, TABLE[:, 4], rtol=1e-3)  # places have six digits
    np.testing.assert_allclose(table.bending_2, TABLE[:, 3], rtol=1e-3)
    np.testing.assert_allclose(table.mass * table.gyration**2, TABLE[:, 7], rtol=1e-3)
    assert np.trapezoid(table.mass, table.position) * 61.5 == pytest.approx(16_845.0, rel=1e-3)


@settings(max_examples=60, deadline=None)
@given(
    one=st.floats(1e6, 1e10),
    ratio=st.floats(1.1, 30.0),
    turn=st.floats(-0.7, 0.7),
    x=st.floats(-1.0, 1.0),
    y=st.floats(-1.0, 1.0),
)
def test_sections_give_back_their_properties(one, ratio, turn, x, y):
    """Principal stiffnesses about an elastic centre, turned and moved to a reference point, and back."""
    axial, two = 1e10, ratio * one
    c, s = np.cos(turn), np.sin(turn)
    xx, yy, xy = one * c * c + two * s * s, one * s * s + two * c * c, (one - two) * c * s
    K = np.diag([1e8, 3e8, axial, yy + axial * y * y, xx + axial * x * x, 2e8])
    K[2, 3] = K[3, 2] = axial * y
    K[2, 4] = K[4, 2] = -axial * x
    K[3, 4] = K[4, 3] = -xy - axial * x * y
    found = section_properties(K, np.diag([100.0, 100.0, 100.0, 5.0, 5.0, 10.0]))
    assert found["bending_1"] == pytest.approx(one, rel=1e-6, abs=1e-5 * axial)
    assert found["bending_2"] == pytest.approx(two, rel=1e-6, abs=1e-5 * axial)
    assert found["twist"] == pytest.approx(turn, abs=1e-3)
    back = np.array([[c, -s], [s, c]]) @ [found["elastic_1"], found["elastic_2"]]
    assert back == pytest.approx([x, y], abs=1e-3)


def test_torsion_is_that_about_the_shear_centre():
    """Shear stiffness of 1e8 and 2e8 N at (0.2, 0.1): K_66 = G J + 1e8 0.1^2 + 2e8 0.2^2."""
    K = np.diag([1e8, 2e8, 1e10, 1e9, 1e9, 5e7 + 1e8 * 0.01 + 2e8 * 0.04])
    K[0, 5] = K[5, 0] = -1e8 * 0.1
    K[1, 5] = K[5, 1] = 2e8 * 0.2
    found = section_properties(K, np.eye(6))
    assert found["torsion"] == pytest.approx(5e7)
    assert (found["shear_center_1"], found["shear_center_2"]) == pytest.approx((0.2, 0.1))


def turned_matrix(turn, one=1e9, two=4e9):
    """Stiffness of a section with turned axes, its elastic and shear centre 0.1 and 0.2 m along axis 1."""
    c, s = np.cos(turn), np.sin(turn)
    (x, y), (x_s, y_s) = (0.1 * c, 0.1 * s), (0.2 * c, 0.2 * s)
    xx, yy, xy = one * c * c + two * s * s, one * s * s + two * c * c, (one - two) * c * s
    axial = 1e10
    K = np.diag([1e8, 1e8, axial, yy + axial * y * y, xx + axial * x * x, 2e8 + 1e8 * 0.2**2])
    for (i, j), value in {
        (2, 3): axial * y,
        (2, 4): -axial * x,
        (3, 4): -xy - axial * x * y,
        (0, 5): -1e8 * y_s,
        (1, 5): 1e8 * x_s,
    }.items():
        K[i, j] = K[j, i] = value
    return K


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_axes_turn_continuously_along_a_blade(sign):
    """Turn of the axes by 170°, through 45° and 135°; a round root and a nearly round section in between."""
    turns = sign * np.radians([0.0, 20.0, 44.0, 46.0, 80.0, 100.0, 134.0, 136.0, 170.0])
    found = [section_properties(turned_matrix(turn), np.eye(6)) for turn in turns]
    found.insert(0, section_properties(turned_matrix(0.0, 4e9), np.eye(6)))
    nearly = section_properties(turned_matrix(sign * np.radians(110.0), 4.001e9, 4e9), np.eye(6))
    found.insert(5, nearly)
    place = np.linspace(0.0, 1.0, len(found))
    axis = np.column_stack([np.zeros((len(found), 2)), 10.0 * place])
    table = beam_table(place, found, axis, np.zeros(len(found)), place)
    own = np.ones(len(found), dtype=bool)
    own[[0, 5]] = False
    assert table.twist[own] == pytest.approx(turns, abs=1e-9)
    assert table.twist[~own] == pytest.approx(sign * np.radians([0.0, 46.0]), abs=1e-9)
    assert table.bending_1[own] == pytest.approx(np.full(9, 1e9))
    assert table.bending_2[own] == pytest.approx(np.full(9, 4e9))
    assert table.bending_1[~own] == pytest.approx([4e9, 4e9], rel=1e-3)
    for name, wanted in (("elastic", 0.1), ("shear_center", 0.2)):
        assert getattr(table, f"{name}_1")[own] == pytest.approx(np.full(9, wanted))
        assert getattr(table, f"{name}_2")[own] == pytest.approx(np.zeros(9), abs=1e-9)
        back = getattr(table, f"{name}_1")[5] + 1j * getattr(table, f"{name}_2")[5]
        there = wanted * np.exp(1j * sign * np.radians(110.0 - 46.0))
        assert back == pytest.approx(there)


def test_matrices_that_are_no_section():
    with pytest.raises(ValueError, match="not positive definite"):
        section_properties(np.diag([1, 1, 1, 1, -1, 1]), np.eye(6))
    with pytest.raises(ValueError, match="negative mass"):
        section_properties(np.eye(6), -np.eye(6))
    with pytest.raises(ValueError, match="not finite"):
        section_properties(np.full((6, 6), np.nan), np.eye(6))
    assert symmetric(range(21)).T.tolist() == symmetric(range(21)).tolist()


WRONG = {
    ("BeamDyn.dat", "49 kp_total"): (
        "50 kp_total",
        "49 is the number of rows before the table",
    ),
    ("BeamDyn.dat", "1 member_total"): ("2 member_total", "2 is the number of members (limit 1)"),
    ("BeamDyn.dat", "kp_xr"): ("x", "kp_xr (BeamDyn.dat): is not the title of a column"),
    ("BeamDyn.dat", "BldFile"): ("File", "another version than a primary file of BeamDyn: it has no BldFile"),
    ("BeamDyn.dat", "Blade.dat"): ("Other.dat", "Other.dat (BeamDyn.dat, line 56): cannot be read"),
    ("BeamDyn.dat", "0.0 61.5 0.0"): ("0.0 6.15 0.0", "kp_zr (BeamDyn.dat, line 5): does not increase"),
    ("Blade.dat", "49 station_total"): (
        "50 station_total",
        "49 is the number of complete stations",
    ),
    ("Blade.dat", "49 station_total"[3:]): ("stations", "station_total"),
    ("Blade.dat", "9.7294800000E+08 0.0"): (
        "-9.72948E+08 0.0",
        "Blade.dat: station 1 (line 7): is not positive definite; correct the matrix",
    ),
    ("Blade.dat", "9.7294800000E+08"): ("9.7x", "'9.7x' is not a number"),
    ("Blade.dat", "9.7294800000E+09 0.0000000000E+00"): (
        "9.7294800000E+09",
        "row 3, column 6 (line 10): nothing is",
    ),
}


@pytest.mark.parametrize("place", WRONG)
def test_mistakes_are_named(primary, place):
    file, old = place
    new, words = WRONG[place]
    path = primary.with_name(file)
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(ModelError) as error:
        read_beamdyn(primary)
    assert words in str(error.value), str(error.value)


@settings(max_examples=80, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    file=st.sampled_from(["BeamDyn.dat", "Blade.dat"]),
    cut=st.floats(0.0, 2.0),
    changes=st.lists(st.tuples(st.floats(0.0, 1.0), st.binary(max_size=4), st.integers(0, 60)), max_size=3),
)
def test_damaged_files_give_a_sentence(tmp_path, file, cut, changes):
    """Bytes replaced, inserted or lost, and files cut: read, or refused with a sentence."""
    primary = write_beamdyn(tmp_path, *matrices())
    path = primary.with_name(file)
    data = path.read_bytes()
    for place, new, lost in changes:
        k = int(place * len(data))
        data = data[:k] + new + data[k + lost :]
    path.write_bytes(data[: int(cut * len(data))] if cut < 1.0 else data)
    try:
        read_beamdyn(primary)
    except PitchpointError as error:
        assert len(str(error)) > 20


def test_hostile_sizes(primary):
    """Counts that no memory has are refused at once."""
    path = primary.with_name("Blade.dat")
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("49 station_total", "99999999999 station_total"), encoding="utf-8")
    with pytest.raises(ModelError, match="station_total"):
        read_beamdyn(primary)
