# SPDX-License-Identifier: Apache-2.0
"""Natural frequencies of rotating blades and of the NREL 5 MW turbine, whose blades and tower are beams.

Sources: ElastoDyn's files of the turbine in examples/wind-turbine; J. Jonkman, S. Butterfield, W. Musial, G.
Scott, Definition of a 5-MW Reference Wind Turbine, NREL/TP-500-38060 (2009), Table 9-1; a linearisation of
OpenFAST 3.5.1 of the blade alone, file 5MW_Land_Lin_BladeOnly/Main.1.lin of openfast_toolbox (Apache 2.0);
A. D. Wright, C. E. Smith, R. W. Thresher, J. L. C. Wang, J. Appl. Mech. 49 (1982) 197-202, Table 1.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.model.openfast.elastodyn import read_elastodyn
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from tests.support.rotors import FOLDER

LENGTH, NODES = 61.5, 17
SHAPES = {
    "flap 1": (0.0622, 1.7254, -3.2452, 4.7131, -2.2555),
    "edge 1": (0.3627, 2.5337, -3.5772, 2.376, -0.6952),
    "flap 2": (-0.5809, 1.2067, -15.5349, 29.7347, -13.8255),
}
"""Coefficients of x^2 to x^6 of the mode shapes in the blade file of ElastoDyn."""


def curvature(shape, x):
    """Second derivative of a mode shape [1/m^2]."""
    return sum(c * n * (n - 1) * x ** (n - 2) for n, c in enumerate(shape, start=2)) / LENGTH**2


def elastodyn_matrix(table):
    """Stiffness over mass of the three modes as in ElastoDyn: 17 elements, sums over their middles.

    Curvatures act about the twisted axes; slopes and deflections are sums of whole and half elements.
    """
    x, step = (np.arange(NODES) + 0.5) / NODES, LENGTH / NODES
    twist = -np.interp(x, table.position, table.twist)
    along = {
        name: np.interp(x, table.position, getattr(table, name))
        for name in ("mass", "bending_1", "bending_2")
    }

    def total(f):
        """Integral from the root to the middle of each element."""
        return step * (np.cumsum(f) - 0.5 * f)

    parts = []
    for name, shape in SHAPES.items():
        bent = curvature(shape, x)
        edge = name.startswith("edge")
        out = -bent * np.sin(twist) if edge else bent * np.cos(twist)
        across = bent * np.cos(twist) if edge else bent * np.sin(twist)
        parts.append((total(total(out)), total(total(across)), bent, edge))
    M, K = np.zeros((3, 3)), np.zeros((3, 3))
    for i, one in enumerate(parts):
        for j, two in enumerate(parts):
            M[i, j] = step * (along["mass"] * (one[0] * two[0] + one[1] * two[1])).sum()
            if one[3] == two[3]:
                K[i, j] = step * (along["bending_2" if one[3] else "bending_1"] * one[2] * two[2]).sum()
    return np.linalg.solve(M, K)


def test_the_properties_of_the_blade_give_the_matrix_of_openfast():
    """Printed with four digits; the signs of the coupling depend on the sense of the edgewise deflection."""
    printed = np.array([[17.98, -1.349, -5.581], [-8.621e-2, 47.51, -14.64], [-3.410, -11.53, 153.2]])
    table = read_elastodyn(FOLDER / "5MW_Baseline" / "NRELOffshrBsline5MW_Blade.dat")
    np.testing.assert_allclose(np.abs(elastodyn_matrix(table)), np.abs(printed), rtol=5e-4)


BLADE = """\
bodies:
  hub: {motion: fixed, position: [0, 0, 0], markers: {root: {position: [0, 0, 1.5 m]}}}
  tip: {mass: 0.01 kg, inertia_tensor: [1e-3, 1e-3, 1e-3, 0, 0, 0], position: [0, 0, 63 m]}
joints: {tip: {type: free, bodies: [hub, tip]}}
beams:
  blade: {ends: [hub.root, tip], axis: [1, 0, 0], pieces: 34, properties: {elastodyn: FILE}}
"""


def test_the_blade_alone_is_softer_than_its_assumed_modes():
    """Rayleigh: the three assumed modes have higher frequencies than the blade of beams, by 1 % and, of the
    second flapwise mode, by 2 %. The mass of both is 17 609 kg, as integrated over the table."""
    text = BLADE.replace("FILE", str(FOLDER / "5MW_Baseline" / "NRELOffshrBsline5MW_Blade.dat"))
    found = np.asarray(find_modes(compile_model(loads_model(text)), count=3).frequency)
    assumed = np.array([0.68284, 1.09254, 1.99315])  # the sums of ElastoDyn with 4000 elements
    assert (found < assumed).all()
    np.testing.assert_allclose(found, assumed, rtol=2.5e-2)
    np.testing.assert_allclose(found[:2], assumed[:2], rtol=1e-2)


UNIFORM = """\
bodies:
  hub: {motion: torsion, inertia: 1 kg m^2, position: [0, 0, 0], markers: {root: {position: [0, 0, 0]}}}
  tip: {mass: 1 mg, inertia_tensor: [1e-9, 1e-9, 1e-9, 0, 0, 0], position: [1 m, 0, 0]}
joints: {tip: {type: free, bodies: [hub, tip]}}
beams:
  blade:
    ends: [hub.root, tip]
    axis: [0, 0, 1]
    pieces: 8
    properties: {position: [0, 1], mass: [1, 1], bending_1: [1, 1], bending_2: [1, 1], axial: [1e6, 1e6]}
scenarios:
  turn: {drive: {hub: {speed: SPEED rad/s}}, duration: 1 s, step: 1 ms}
"""


@pytest.mark.parametrize(
    ("speed", "flap"),
    [
        (0, (3.5160, 22.0345, 61.6972)),
        (2, (4.1373, 22.6149, 62.2732)),
        (6, (7.3604, 26.8091, 66.6840)),
        (12, (13.1702, 37.6031, 79.6145)),
    ],
)
def test_rotating_blades_stiffen(speed, flap):
    """Uniform blade, E I = rho A = L = 1, hub radius 0; to 1e-3 with eight elements of 0.1 %.

    Lead-lag has the same stiffness and the centrifugal force turns with it: its squares are less by the
    square of the speed.
    """
    system = compile_model(loads_model(UNIFORM.replace("SPEED", str(speed))), "turn")
    found = 2.0 * np.pi * np.asarray(find_modes(system, "turn", count=6).frequency)
    lead_lag = np.sqrt(np.square(flap) - speed**2)
    np.testing.assert_allclose(found, np.sort([*flap, *lead_lag]), rtol=1e-3)


ADAMS = {
    "tower side to side": (0.3164, 0.005),
    "tower fore-aft": (0.3195, 0.005),
    "drive train": (0.6094, 0.01),
    "flap, yaw": (0.6296, 0.01),
    "flap, pitch": (0.6686, 0.005),
    "flap, collective": (0.7019, 0.005),
    "edge, pitch": (1.0740, 0.01),
    "edge, yaw": (1.0877, 0.01),
    "second flap, yaw": (1.6507, 0.03),
    "second flap, pitch": (1.8558, 0.005),
    "second flap, collective": (1.9601, 0.005),
    "second tower fore-aft": (2.8590, 0.01),
    "second tower side to side": (2.9408, 0.005),
}
"""Frequencies of ADAMS [Hz], whose blades and tower are beams, and tolerances. FAST, with assumed modes and a
tower without torsion, differs from ADAMS by 17 % in the second flapwise yaw mode and by 6 % in the first:
they depend on yaw inertia and torsion, of which the report has no more than the nacelle. The masses of the
blades are 0.7 % less here, as integrated over the table."""


def test_modes_of_the_turbine_at_rest():
    """Generator locked, no air, no gravity. The table has no mode between 1.97 and 2.8 Hz; here is one at
    2.66 Hz, collective bending of the blades in their plane with the second lateral mode of the tower. With
    gravity the first modes of the tower are 1.7 % slower, and 1.5 and 1.9 % slower than those of ADAMS, of
    which the report does not say whether weight acts; see test_wind_turbine_matrix.py. The locked generator,
    referred to the slow side, rolls with the nacelle with 97^2 times its inertia, which lowers the second
    lateral modes by 2.3 %: with 534 kg m^2 they are those of the rigid ratio."""
    model = load_model(FOLDER.parent / "model.yaml").replace_all(
        {
            "wind_rotors.rotor": None,
            "gravity": None,
            "scenarios.parked.start": "assembled",
            **{f"beams.blade_{k}.pieces": 24 for k in (1, 2, 3)},
        }
    )
    found = np.asarray(find_modes(compile_model(model, "parked"), "parked", count=14).frequency)
    for name, (published, close) in ADAMS.items():
        nearest = found[np.argmin(np.abs(found - published))]
        assert nearest == pytest.approx(published, rel=close), name
