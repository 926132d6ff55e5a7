# SPDX-License-Identifier: Apache-2.0
"""Reduced systems against the full ones: two geared shafts of many stations, and a pair without any."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.stiffness.fourier import fourier
from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import OK
from pitchpoint.geometry import CylindricalGear, GearPair
from pitchpoint.multibody.beam_section import Beam, tube
from pitchpoint.multibody.bodies import Body
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.reduction.reduce import reduce_system
from pitchpoint.system import evaluate
from pitchpoint.system.rules.gear_mesh import Placement, mesh_row
from pitchpoint.system.rules.mesh_laws import MeshLaws
from pitchpoint.system.system import assemble
from tests.support.beams import nodes, shaft, supports
from tests.support.engine import couplings, torques
from tests.support.gearbox_files import TAILS
from tests.support.machines import compiled, pair

LENGTH, SPEED, TORQUE = 0.4, 200.0, 100.0


def geared_shafts(stations):
    """Two steel shafts of 40 mm with gears in the middle, inertias at one end, bearings at both, loaded."""
    gear = CylindricalGear(z=40, m_n=3e-3, beta=0.0, b=0.02)
    pair = GearPair.from_profile_shifts(gear, CylindricalGear(z=60, m_n=3e-3, beta=0.0, b=0.02))
    middle, last = stations // 2, stations - 1
    z = np.linspace(0.0, LENGTH, stations)
    discs = {middle: (2.0, 0.004, 0.007), 0: (3.0, 0.006, 0.01)}
    other = {middle: (4.0, 0.01, 0.02), last: (3.0, 0.006, 0.01)}
    bodies = nodes(z, discs, name="a") + nodes(z, other, origin=(pair.a_w, 0.0, 0.0), name="b")
    piece = Beam(section=tube(0.04, nu=0.3), length=z[1], E=2.1e11, G=8e10, rho=7850.0)
    beams = np.concatenate(
        [shaft([piece] * last, eta=1e-6), shaft([piece] * last, first=stations + 1, eta=1e-6)]
    )
    K = np.diag([1e8, 1e8, 1e8, 1e4, 1e4, 0.0])
    D = np.diag([2e3, 2e3, 2e3, 1.0, 1.0, 0.0])
    rows = [(b, K, D) for b in (1, stations, stations + 1, 2 * stations)]
    kept = []

    def keep(array):
        kept.append(np.ravel(array))
        return sum(part.size for part in kept[:-1])

    one, two = middle + 1, stations + middle + 1
    place = Placement(
        origin1=np.array(bodies[one - 1].position),
        origin2=np.array(bodies[two - 1].position),
        phi2=math.pi - math.pi / 60,
    )
    laws = MeshLaws(stiffness=fourier(pair, mean=3e8, cosine=[-0.15, -0.05]))
    row = mesh_row(pair, place, laws, keep, backlash=1e-4)
    mesh = np.zeros(1, row.dtype)
    mesh[0] = row
    mesh["i"], mesh["j"] = one, two
    loads = torques([(1, TORQUE), (2 * stations, TORQUE * 1.5)])
    banks = {"shaft_beam": beams, "bearing": supports(bodies, rows), "gear_mesh": mesh, "torque": loads}
    system = assemble(bodies, banks, pools={"gear_mesh": np.concatenate([*kept, np.zeros(1)])})
    start = system.initial_state()
    for k in range(stations):
        start.v[system.spin(f"a{k}")] = SPEED
        start.v[system.spin(f"b{k}")] = -SPEED * 40 / 60
    return system, start


@pytest.fixture(scope="module")
def reduced():
    system, start = geared_shafts(13)
    return reduce_system(system, start=start, limit=3000.0)


def test_frequencies_and_compliance(reduced):
    """0.1 % is what is asked of Craig and Bampton's method; compliances differ most beside a resonance, where
    a frequency off by e changes them by e/(2 zeta) of their peak, zeta of a per cent."""
    assert reduced.error.coordinates[0] == 156
    assert reduced.error.coordinates[1] < 60
    assert reduced.error.full.size > 8
    assert reduced.error.frequency < 1e-3
    assert reduced.error.compliance < 2e-2
    assert "natural frequencies up to 3000 Hz" in reduced.error.report()


def test_the_operating_point_is_the_same(reduced):
    """What is kept feels the same forces: both rest to the tolerance of the equilibrium (1e-9 of 6 kN)."""
    for system, state in ((reduced.full, reduced.full_state), (reduced.system, reduced.state)):
        assert np.abs(evaluate.residual(system, state)).max() < 1e-4


def run(system, state, h, steps):
    channel = system.layout.channel("mesh_force[gear_mesh0]")
    machine = generalized_alpha.start(system, state, h)
    found = []
    for _ in range(steps // 10):
        assert machine.advance(10).status == OK
        found.append(machine.state())
    return np.array([evaluate.observe(system, s)[channel] for s in found])


def test_mesh_force_over_time(reduced):
    """Ten mesh periods at 1.3 kHz from the operating point, the mesh nonlinear: what is left out is above the
    limit, one part in fifty of the wave."""
    steps = 800
    force = run(reduced.full, reduced.full_state, 1e-5, steps)
    again = run(reduced.system, reduced.state, 1e-5, steps)
    assert np.ptp(force) > 20.0
    assert np.abs(again - force).max() < 0.02 * np.ptp(force)


def test_whole_turns_change_nothing(reduced):
    state = reduced.state.copy()
    expected = evaluate.residual(reduced.system, state)
    spins = reduced.system.program["body"]["spin"]
    one = [k for k, n in enumerate(reduced.system.layout.bodies) if n.startswith("a")]
    state.turns[one] += 40 * 3
    two = [k for k, n in enumerate(reduced.system.layout.bodies) if n.startswith("b")]
    state.turns[two] -= 40 * 2
    assert spins[one[0]] >= 0
    assert evaluate.residual(reduced.system, state) == pytest.approx(expected, rel=1e-9, abs=1e-6)


def test_modes_of_the_reduced_system_are_found_as_of_any(reduced):
    """Whirl included: damped frequencies at speed agree as well as the undamped ones."""
    one = find_modes(reduced.full, start=reduced.full_state, mean=False)
    two = find_modes(reduced.system, start=reduced.state, mean=False)
    low = np.sort(one.damped_frequency[one.damped_frequency < 2000.0])
    assert np.sort(two.damped_frequency)[: low.size] == pytest.approx(low, rel=1e-3, abs=1e-3)
    assert low.size > 8


def test_a_pair_without_stations_stays_what_it_is():
    """Twelve freedoms: bearings become one linear part, nothing is left out."""
    text = pair(
        "{law: constant, value: 3e8 N/m}",
        beta="17 deg",
        motion="free",
        rest="bearings:\n"
        + "".join(
            f"  on_{b}: {{body: {b}, stiffness: {{radial: 1e8, axial: 1e8, tilt: 1e6}}}}\n"
            for b in ("driver", "driven")
        ),
    )
    found = reduce_system(compiled(text)[1], limit=1e4)
    assert "bearing" not in found.system.records
    assert found.error.coordinates == (12, 12)
    assert found.error.full.size > 5
    assert found.error.frequency < 1e-7  # what turned axes do to the bearings of a tilted gear
    assert found.error.compliance < 1e-6


def test_modal_damping_across_the_mesh_is_kept():
    """Damping ratios tie all coordinates, those of both gears too; the reduced pair has the same ones."""
    rest = "".join(
        f"  on_{b}: {{body: {b}, stiffness: {{radial: 1e8, axial: 1e8, tilt: 1e6}}}}\n"
        for b in ("driver", "driven")
    )
    rest = f"bearings:\n{rest}damping: {{modal: 0.02}}\nscenarios:\n  go: {{duration: 1 ms}}\n"
    text = pair("{law: constant, value: 3e8 N/m}", beta="17 deg", motion="free", rest=rest)
    found = reduce_system(compiled(text, "go")[1], limit=1e4)
    one = find_modes(found.full, start=found.full_state).damping_ratio
    two = find_modes(found.system, start=found.state).damping_ratio
    assert "damping" not in found.system.records
    assert one[1:] == pytest.approx(np.full(11, 0.02), rel=5e-3)
    assert two == pytest.approx(one, rel=1e-6, abs=1e-9)


def test_bodies_that_no_linear_element_touches_stay():
    """A shaft of two discs that nothing loads is one disc and a mode; a disc alone is itself."""
    discs = [Body(polar_inertia=v, name=n) for n, v in (("a", 1.0), ("b", 2.0), ("lone", 3.0))]
    system = assemble(discs, {"coupling": couplings([(1, 2, 50.0, 0.0, 0.0)])})
    found = reduce_system(system, limit=10.0)
    assert found.system.layout.bodies == ("ground", "a", "lone", "part1.mode1")
    assert found.error.reduced == pytest.approx([0.0, 0.0, math.sqrt(50.0 * 1.5) / (2.0 * math.pi)], abs=1e-9)


def test_turns_through_condensed_couplings_count_as_one():
    """The fan turns with the shaft, though what ties them is condensed: its mode on the coupling is no turn.

    Forces left over at rest (1e-9 of the loads) hold the free body at some mHz: that is no vibration either.
    """
    error = reduce_system(compiled(TAILS, "run")[1], "run", limit=500.0).error
    assert error.coordinates[1] < error.coordinates[0] - 20
    assert error.full[:6] == pytest.approx(np.zeros(6), abs=0.0)
    assert error.reduced[:6] == pytest.approx(np.zeros(6), abs=0.0)
    assert error.full[6] == pytest.approx(math.sqrt(1e6 / 5.0) / (2.0 * math.pi), rel=1e-6)
    assert error.full.size > 7
    assert error.frequency < 1e-3


def test_unknown_names():
    system, start = geared_shafts(5)
    with pytest.raises(SolverError, match="nothing to keep is called c9"):
        reduce_system(system, start=start, limit=1000.0, keep=("c9",))
