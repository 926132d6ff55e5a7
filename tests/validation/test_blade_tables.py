# SPDX-License-Identifier: Apache-2.0
"""Blades from the matrices of BeamDyn and windIO: natural frequencies against ElastoDyn's table of the same
blade, and against a beam with full section matrices.

Sources: tests/support/beamdyn.py; examples/wind-turbine. The reference beam is an independent formulation:
linear displacements, full 6 x 6 matrices, curved axis.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.openfast.beamdyn import read_beamdyn
from pitchpoint.model.openfast.elastodyn import read_elastodyn
from pitchpoint.model.windio.beam import read_windio_beam
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from tests.support.beamdyn import LENGTH, axis_of, frequencies, matrices, write_beamdyn
from tests.support.rotors import FOLDER

BLADE = """\
bodies:
  hub: {motion: fixed, position: [0, 0, 0], markers: {root: {position: [0, 0, 1.5 m]}}}
  tip: {mass: 0.01 kg, inertia_tensor: [1e-3, 1e-3, 1e-3, 0, 0, 0], position: [0, 0, END m]}
joints: {tip: {type: free, bodies: [hub, tip]}}
beams:
  blade: {ends: [hub.root, tip], axis: [1, 0, 0], pieces: 34, properties: {PROPERTIES}}
"""
IEA = FOLDER.parent / "iea_15mw" / "IEA-15-240-RWT.yaml"


def found(properties, length=LENGTH, count=6):
    """Natural frequencies of a clamped blade [Hz]."""
    text = BLADE.replace("END", repr(1.5 + length)).replace("PROPERTIES", properties)
    return np.asarray(find_modes(compile_model(loads_model(text)), count=count).frequency)


def test_the_blade_of_beamdyn_is_that_of_elastodyn(tmp_path):
    """NREL 5 MW. Both files have the same stiffness and twist, and ElastoDyn the factor 1.04536 in mass.

    Without torsion, shear and rotary inertia, which ElastoDyn does not have, the frequencies are those of
    its table; with the torsion and shear of BeamDyn's file the first three are 0.4 to 2.7 % less.
    """
    stiffness, mass = matrices()
    path = write_beamdyn(tmp_path, stiffness, 1.04536 * mass)
    table = read_beamdyn(path)
    file = FOLDER / "5MW_Baseline" / "NRELOffshrBsline5MW_Blade.dat"
    elastodyn = read_elastodyn(file)
    own = {
        "mass": table.inertia[:, 0, 0],
        "bending_1": table.stiffness[:, 4, 4],
        "bending_2": table.stiffness[:, 3, 3],
        "twist": table.twist,
    }
    for name, values in own.items():
        theirs = np.interp(table.position, elastodyn.position, getattr(elastodyn, name))
        np.testing.assert_allclose(values, theirs, rtol=1e-4, atol=1e-5)
    lists = {"position": table.position, **own}
    same = found(", ".join(f"{name}: {values.tolist()}" for name, values in lists.items()))
    theirs = found(f"elastodyn: {file}")
    np.testing.assert_allclose(same, theirs, rtol=1e-6)
    whole = found(f"beamdyn: {path}")
    assert (whole[:3] < theirs[:3]).all()
    np.testing.assert_allclose(whole[:3], theirs[:3], rtol=0.03)


@pytest.mark.parametrize("prebend", [0.0, -4.0])
def test_diagonal_matrices_with_prebend(tmp_path, prebend):
    """NREL 5 MW with its own axis, and bent upwind by 4 m: to 0.6 %, the error of 34 pieces of constant
    section; with 100 pieces it is 0.2 %. The sixth mode, 5.58 Hz, is torsion."""
    stiffness, mass = matrices()
    axis = axis_of(prebend)
    path = write_beamdyn(tmp_path, stiffness, mass, axis)
    np.testing.assert_allclose(found(f"beamdyn: {path}"), frequencies(axis, stiffness, mass), rtol=9e-3)


def test_offset_and_turned_sections(tmp_path):
    """Elastic centre 0.3 m and centre of mass 1.5 m behind the axis, principal axes turned by 5 deg: the
    frequencies are those of the independent beam to 0.9 %. Without the offsets they are up to 2 % higher."""
    stiffness, mass = matrices()
    turn = np.radians(5.0)
    c, s = np.cos(turn), np.sin(turn)
    own = np.kron(np.eye(2), np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]))
    K, M = (
        np.array([moved(own @ m @ own.T, y) for m in each]) for each, y in ((stiffness, 0.3), (mass, 1.5))
    )
    path = write_beamdyn(tmp_path, K, M)
    full = frequencies(axis_of(), K, M)
    np.testing.assert_allclose(found(f"beamdyn: {path}"), full, rtol=9e-3)
    assert np.abs(frequencies(axis_of(), stiffness, mass) / full - 1.0).max() > 0.015


def moved(matrix, y):
    """Matrix about a point that is y behind the centre: N acts there, so that K_34 = E A y."""
    shift = np.eye(6)
    shift[3, 2], shift[5, 0] = y, -y
    return shift @ matrix @ shift.T


IEA_BLADE = [0.50651, 0.69293, 1.48003, 2.13884, 2.93137, 4.08552]
"""IEA 15 MW, BeamDyn files of IEAWindTask37/IEA-15-240-RWT (Apache License 2.0), full matrices, curved axis,
400 elements [Hz]. The matrices of the windIO file are the same, rounded."""


def test_blade_of_the_iea_15mw_from_windio():
    """To 0.8 %, the error of 34 pieces; with 68 pieces 0.3 %. Mass 66.9 t."""
    table = read_windio_beam(IEA, "blade")
    assert table.length == pytest.approx(117.0)
    assert np.trapezoid(table.inertia[:, 0, 0], table.position) * table.length == pytest.approx(
        66_912.0, rel=1e-3
    )
    assert table.offset_1[-1] == pytest.approx(-4.0)
    ours = found(f"windio: {IEA}, component: blade", 117.0)
    np.testing.assert_allclose(ours, IEA_BLADE, rtol=8e-3)


def test_tower_of_the_iea_15mw_from_windio():
    """ElastoDyn's tower of the same repository: 3.0654e12 N m^2 and 10 314.8 kg/m at the base;
    mass 853 t with the outfitting factor 1.07."""
    table = read_windio_beam(IEA, "tower")
    assert table.bending_1[0] == pytest.approx(3.065446681730708e12, rel=1e-5)
    assert table.torsion[0] == pytest.approx(2.4308992186124517e12, rel=1e-5)
    assert table.mass[0] == pytest.approx(10314.844411733615, rel=1e-5)
    assert np.trapezoid(table.mass, table.position) * table.length == pytest.approx(853_463.0, rel=1e-4)
