# SPDX-License-Identifier: Apache-2.0
"""Files of BeamDyn: what is read, and a sentence with file and line for what is not."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from pitchpoint.core.errors import ModelError, PitchpointError
from pitchpoint.geometry.section_matrix import check_inertia, check_stiffness, mass_lines, symmetric
from pitchpoint.model.openfast.beamdyn import read_beamdyn
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
    stiffness, mass = matrices()
    np.testing.assert_allclose(table.stiffness, stiffness, rtol=1e-3)  # places have six digits
    np.testing.assert_allclose(table.inertia, mass, rtol=1e-3)
    assert table.damping.tolist() == [1e-3, 1e-3, 1e-3, 0.0014, 0.0022, 0.0022]
    assert np.trapezoid(table.inertia[:, 0, 0], table.position) * 61.5 == pytest.approx(16_845.0, rel=1e-3)


@pytest.mark.parametrize(("kind", "damped"), [("0 damp_type", False), ("True damp_flag", True)])
def test_damping_can_be_switched_off(primary, kind, damped):
    path = primary.with_name("Blade.dat")
    path.write_text(path.read_text(encoding="utf-8").replace("1 damp_type", kind), encoding="utf-8")
    assert read_beamdyn(primary).damping.any() == damped


def test_all_terms_are_read_at_their_place(tmp_path):
    """A full matrix with another number in each entry, and the turned ellipse of inertia of a section."""
    stiffness, mass = matrices()
    K = stiffness.copy()
    scale = np.sqrt(np.einsum("ni,nj->nij", *2 * [np.einsum("nii->ni", K)]))
    coupling = symmetric(1e-3 * np.arange(21.0))
    np.fill_diagonal(coupling, 0.0)
    K += coupling * scale
    mass[:, 3, 4] = mass[:, 4, 3] = -0.1 * mass[:, 5, 5]
    table = read_beamdyn(write_beamdyn(tmp_path, K, mass))
    assert len(set(coupling[np.triu_indices(6, 1)])) == 15
    np.testing.assert_allclose(table.stiffness, K, rtol=1e-3)
    np.testing.assert_allclose(table.inertia, mass, rtol=1e-3)


@settings(max_examples=60, deadline=None)
@given(
    mass=st.floats(1.0, 1e3),
    flat=st.floats(0.0, 1.0),
    size=st.floats(1e-3, 1e2),
    turn=st.floats(-1.5, 1.5),
    place=st.tuples(st.floats(-2.0, 2.0), st.floats(-2.0, 2.0)),
)
def test_mass_lines_have_the_matrix_of_the_section(mass, flat, size, turn, place):
    """Sum of the mass matrices of one or two lines: all entries, for any centre and principal axes."""
    c, s = np.cos(turn), np.sin(turn)
    axes = np.array([[c, -s], [s, c]])
    own = mass * size * axes @ np.diag([1.0, 1.0 - flat]) @ axes.T  # moments about both axes
    M = one_mass(mass, place) + np.pad(own, ((3, 1), (3, 1)))
    M[5, 5] += np.trace(own)
    check_inertia(M)
    lines = mass_lines(M)
    found = sum(
        one_mass(part.mass, part.place) + part.mass * part.second * np.diag([0, 0, 0, 1, 1, 2])
        for part in lines
    )
    np.testing.assert_allclose(found, M, atol=1e-6 * np.abs(M).max())
    assert len(lines) == 1 or flat > 1e-7


def one_mass(mass, place):
    """Mass matrix of a point of a section."""
    x, y = place
    arm = np.eye(6)
    arm[0, 5], arm[1, 5], arm[2, 3], arm[2, 4] = -y, x, y, -x
    return arm.T @ np.diag([mass] * 3 + [0.0] * 3) @ arm


def changed(matrix, entries):
    """Matrix with other entries."""
    out = np.array(matrix, dtype=float)
    for (i, j), value in entries.items():
        out[i, j] = value
    return out


@pytest.mark.parametrize(
    ("check", "matrix", "words"),
    [
        (check_stiffness, np.diag([1, 1, 1, 1, -1, 1]), "is not positive definite"),
        (check_stiffness, changed(np.eye(6), {(3, 5): 1.1, (5, 3): 1.1}), "is not positive definite"),
        (
            check_stiffness,
            changed(np.eye(6), {(3, 5): 0.1}),
            "not symmetric: the entries 46 and 64 are 0.1 and 0",
        ),
        (check_stiffness, np.full((6, 6), np.nan), "values that are not finite"),
        (check_inertia, -np.eye(6), "has a negative mass"),
        (check_inertia, np.diag([1, 1, 2, 1, 1, 2]), "has several masses: 1, 1, 2 kg/m"),
        (
            check_inertia,
            changed(np.eye(6), {(3, 5): 0.1, (5, 3): 0.1}),
            "has the entry 46, which a flat section",
        ),
        (check_inertia, changed(np.eye(6), {(2, 3): 0.1, (3, 2): 0.1}), "entries 16 and 34 are not opposite"),
        (check_inertia, one_mass(1.0, (1.0, 0.0)) - np.diag([0, 0, 0, 0, 0, 0.5]), "has a negative moment"),
    ],
)
def test_matrices_that_are_no_section(check, matrix, words):
    with pytest.raises(ValueError, match=words):
        check(matrix)


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
        "Blade.dat: station 1, stiffness (line 8): is not positive definite; correct the matrix",
    ),
    ("Blade.dat", "1 damp_type"): (
        "2 damp_type",
        "damp_type (line 3): 2 is not supported (limit 0 or 1, by the stiffness); set it to 0, and give",
    ),
    ("Blade.dat", "damp_type"): ("type", "damp_type"),
    ("Blade.dat", "1.0E-03 1.0E-03"): (
        "1.0E-03 -1.0E-03",
        "0.001 -0.001 0.001 0.0014 0.0022 0.0022 are out of range",
    ),
    ("Blade.dat", "mu1 mu2"): ("a1 a2", "mu1"),
    ("Blade.dat", "9.7294800000E+08"): ("9.7x", "'9.7x' is not a number"),
    ("Blade.dat", "9.7294800000E+09 0.0000000000E+00"): (
        "9.7294800000E+09",
        "station 1 (line 10): 5 is the number of values of a line (limit 6, row 3 of its matrices); complete",
    ),
}


def test_a_missing_line_is_one_problem(primary):
    path = primary.with_name("Blade.dat")
    lines = path.read_text(encoding="utf-8").splitlines()
    path.write_text("\n".join([*lines[:99], *lines[100:], lines[-1]]), encoding="utf-8")
    with pytest.raises(ModelError) as error:
        read_beamdyn(primary)
    [problem] = error.value.problems
    assert "is the number of values of a line (limit " in problem


def test_matrices_with_the_same_fault_are_one_problem(primary):
    path = primary.with_name("Blade.dat")
    text = path.read_text(encoding="utf-8").replace("9.7294800000E+08 0.0", "-9.7294800000E+08 0.0")
    path.write_text(text.replace("9.7294800000E+09", "-9.7294800000E+09"), encoding="utf-8")
    with pytest.raises(ModelError) as error:
        read_beamdyn(primary)
    assert len(error.value.problems) == 1


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
