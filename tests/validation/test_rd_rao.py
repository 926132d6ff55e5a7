# SPDX-License-Identifier: Apache-2.0
"""RD-RAO: turbo-alternator with a spur mesh, bending and torsion coupled, of Rao et al. 1998.

Source: tutorial 4 of the ROSS rotordynamics package (petrobras/ross), values attributed to Friswell et al.,
Dynamics of Rotating Machines (2010). One Timoshenko element per length, shear factor of Cowper, consistent
mass. Mapping: the line of centres is our x axis, the mesh vector (sin alpha, cos alpha | r_b) is that of
our front flank, pressed by 1e-10 m so that it touches without load. The printed base radius of the pinion,
0.03567 m, is rounded; ours follows from the ratio of the teeth. Tolerance 1e-4: the frequencies are printed
to 1 mHz, 4e-5 of the smallest.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.stiffness.constant import constant
from pitchpoint.geometry import CylindricalGear, GearPair
from pitchpoint.multibody.beam_section import Beam, tube
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system import evaluate
from pitchpoint.system.rules.gear_mesh import Placement, mesh_row
from pitchpoint.system.rules.mesh_laws import MeshLaws
from pitchpoint.system.system import assemble
from tests.support.beams import damped_frequencies, nodes, shaft, supports

E, G, RHO = 207e9, 79.5e9, 7800.0
SPEED = 1500.0 * math.pi / 30.0
R_B1 = 0.5086
WIDTH = 1e-3
"""Face width [m]: that of the source has none, so its mesh does not resist tilt."""


def pieces(lengths, diameters):
    nu = E / (2.0 * G) - 1.0
    return [
        Beam(section=tube(d, nu=nu), length=h, E=E, G=G, rho=RHO)
        for h, d in zip(lengths, diameters, strict=True)
    ]


def machine():
    """System and state with the front flank touching."""
    one, two = (0.1, 4.24, 1.16, 0.3), (0.3, 5.0, 0.1)
    gear = CylindricalGear(
        z=328,
        m_n=2.0 * R_B1 / (328 * math.cos(math.radians(22.5))),
        beta=0.0,
        b=WIDTH,
        alpha_n=math.radians(22.5),
    )
    pair = GearPair.from_profile_shifts(
        gear, CylindricalGear(z=23, m_n=gear.m_n, beta=0.0, b=WIDTH, alpha_n=gear.alpha_n)
    )
    a = pair.a_w
    gear_place = sum(one)
    generator, alternator, wheel = (525.7, 16.1, 32.2), (116.04, 3.115, 6.23), (726.4, 56.95, 113.9)
    bodies = nodes([0.0, *np.cumsum(one)], {1: generator, 2: alternator, 4: wheel}, name="a")
    discs = {0: (5.0, 0.002, 0.004), 2: (7.45, 0.0745, 0.149)}
    bodies += nodes([0.0, *np.cumsum(two)], discs, origin=(a, 0.0, gear_place), name="b")
    beams = np.concatenate(
        [shaft(pieces(one, (0.3, 0.3, 0.22, 0.22))), shaft(pieces(two, (0.15,) * 3), first=6)]
    )
    first = np.diag([183.9e6, 200.4e6, 0.0, 0.0, 0.0, 0.0]), np.diag([3e3, 3e3, 0.0, 0.0, 0.0, 0.0])
    second = np.diag([10.1e6, 41.6e6, 0.0, 0.0, 0.0, 0.0]), first[1]
    rows = [(1, *first), (4, *first), (7, *second), (9, *second)]
    pool = []

    def keep(array):
        pool.append(np.ravel(array))
        return sum(part.size for part in pool[:-1])

    place = Placement(
        origin1=np.array(bodies[4].position),
        origin2=np.array(bodies[5].position),
        phi2=math.pi - math.pi / 23,
    )
    mesh = np.zeros(1, mesh_row(pair, place, MeshLaws(stiffness=constant(pair, mean=1e8)), keep).dtype)
    mesh[0] = mesh_row(pair, place, MeshLaws(stiffness=constant(pair, mean=1e8)), keep, backlash=1e-6)
    mesh["i"], mesh["j"] = 5, 6
    banks = {"shaft_beam": beams, "bearing": supports(bodies, rows), "gear_mesh": mesh}
    system = assemble(bodies, banks, pools={"gear_mesh": np.concatenate([*pool, np.zeros(1)])})
    state = system.initial_state()
    ratio = 328.0 / 23.0
    turn = (0.5e-6 + 1e-10) / R_B1
    for b in range(5):
        state.q[system.spin(f"a{b}")] = turn
        state.v[system.spin(f"a{b}")] = SPEED
    for b in range(4):
        state.v[system.spin(f"b{b}")] = -SPEED * ratio
    return system, state


def test_damped_frequencies_of_the_geared_rotors():
    system, state = machine()
    assert evaluate.observe(system, state)[system.layout.channel("mesh_stiffness[gear_mesh0]")] == 1e8
    found, growth = damped_frequencies(*evaluate.linearize(system, state))
    f = found[:13]
    assert growth.max() < 1e-3
    assert f[0] == pytest.approx(11.641, rel=1e-4)
    assert f[1] == pytest.approx(12.284, rel=1e-4)
    assert f[2] == pytest.approx(17.268, rel=1e-4)
    assert f[3] == pytest.approx(18.458, rel=1e-4)
    assert f[4] == pytest.approx(23.956, rel=1e-4)
    assert f[5] == pytest.approx(37.681, rel=1e-4)
    assert f[6] == pytest.approx(49.889, rel=1e-4)
    assert f[7] == pytest.approx(50.861, rel=1e-4)
    assert f[8] == pytest.approx(56.248, rel=1e-4)
    assert f[9] == pytest.approx(57.752, rel=1e-4)
    assert f[10] == pytest.approx(59.188, rel=1e-4)
    assert f[11] == pytest.approx(63.113, rel=1e-4)
    assert f[12] == pytest.approx(74.203, rel=1e-4)


def test_modes_about_the_operating_point_are_the_same():
    """The way of users: from a start at speed to named modes, with beams and mesh in the strain energy."""
    system, state = machine()
    modes = find_modes(system, start=state)
    expected, _ = damped_frequencies(*evaluate.linearize(system, state))
    f = np.sort(modes.damped_frequency[modes.damped_frequency > 1.0])
    assert f[:13] == pytest.approx(expected[expected > 1.0][:13], rel=1e-6)
    assert f[12] == pytest.approx(74.203, rel=1e-4)
    assert "beam shaft_beam0" in modes.elements
    assert "mesh gear_mesh0" in modes.elements
    # along x all of the mass takes part: no mode is left out
    mass = 525.7 + 116.04 + 726.4 + 5.0 + 7.45
    mass += sum(float(row["mass"]) for row in system.records["shaft_beam"])
    assert modes.effective_mass[:, 0].sum() == pytest.approx(mass, rel=1e-6)
