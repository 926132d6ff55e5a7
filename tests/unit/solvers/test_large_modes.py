# SPDX-License-Identifier: Apache-2.0
"""Modes of systems with hundreds of coordinates: closed forms, multiple roots, the dense way beside it."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.elements import maxwell, spring_damper
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.multibody.joints import PRISMATIC
from pitchpoint.solvers import frequency_response, linear_system
from pitchpoint.solvers.constraints import free_directions
from pitchpoint.solvers.frequency_response import find_response
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.system import assemble
from tests.support.engine import couplings, gear_rows

INERTIA, STIFFNESS = 0.02, 3e5
EXAMPLES = Path(__file__).parents[3] / "examples"


def discs(n):
    return [Body(motion=TORSION, polar_inertia=INERTIA, name=f"d{k}") for k in range(n)]


def chains(number, length, damper=0.0):
    """Chains of discs without support, side by side."""
    rows = [
        (c * length + k + 1, c * length + k + 2, STIFFNESS, damper, 0.0)
        for c in range(number)
        for k in range(length - 1)
    ]
    return assemble(discs(number * length), {"coupling": couplings(rows)})


def free_chain(length, j):
    """Circular frequencies of a chain of n discs with both ends free: 2 sqrt(k/J) sin(j pi / 2 n)."""
    return 2.0 * math.sqrt(STIFFNESS / INERTIA) * np.sin(j * math.pi / (2.0 * length))


@pytest.fixture
def sparse_ways(monkeypatch):
    """A switch: systems of any size are taken as large from now on."""

    def switch():
        for name, value in (("MAX_MODES", 1), ("SPARSE", 2.0), ("DENSE", 0)):
            monkeypatch.setattr(linear_system, name, value)
        monkeypatch.setattr(free_directions, "LARGE", 1)
        monkeypatch.setattr(frequency_response, "LARGE", 1)

    return switch


def test_a_chain_of_three_hundred_discs():
    """Rounding of the largest stiffness leaves the fourth-lowest mode eleven digits, whatever the method.

    Dampers beside the springs, d = b k, damp every mode by b omega / 2.
    """
    b = 1e-5
    found = find_modes(chains(1, 300, b * STIFFNESS))
    expected = free_chain(300, np.arange(40))
    assert found.total == 300
    assert len(found.frequency) == 40
    assert found.frequency[0] == 0.0
    assert 2.0 * math.pi * found.frequency == pytest.approx(expected, rel=1e-9)
    assert found.damping_ratio[1:] == pytest.approx(0.5 * b * expected[1:], rel=1e-7)
    assert found.eigenvalue[0] == 0.0
    shape = np.cos((np.arange(300) + 0.5) * 3.0 * math.pi / 300.0) * math.sqrt(2.0 / (300.0 * INERTIA))
    assert np.abs(found.shape[3] * np.sign(found.shape[3, 0])) == pytest.approx(np.abs(shape), abs=1e-7)
    assert "the lowest 40 of 300 modes" in found.notes[-1]


def test_multiple_roots_are_complete():
    """Five equal chains: five free rotations and every frequency five times, cut in the middle of one."""
    found = find_modes(chains(5, 60), count=18)
    expected = np.repeat(free_chain(60, np.arange(4)), 5)[:18]
    assert 2.0 * math.pi * found.frequency == pytest.approx(expected, rel=1e-9)
    assert np.count_nonzero(found.frequency == 0.0) == 5
    mass = INERTIA * found.shape @ found.shape.T
    assert mass == pytest.approx(np.eye(18), abs=1e-8)


@pytest.mark.parametrize("count", [6, 203])
def test_hundreds_of_free_rotations(count):
    """Two hundred pairs of discs: the double zeros are exact, and any number of them can be requested."""
    b = 1e-5
    found = find_modes(chains(200, 2, b * STIFFNESS), count=count)
    high = math.sqrt(2.0 * STIFFNESS / INERTIA)
    expected = np.repeat([0.0, high], 200)[:count]
    assert 2.0 * math.pi * found.frequency == pytest.approx(expected, rel=1e-9)
    assert not found.eigenvalue[:200].any()
    assert found.damping_ratio[200:] == pytest.approx(0.5 * b * expected[200:], rel=1e-9)
    assert INERTIA * found.shape @ found.shape.T == pytest.approx(np.eye(count), abs=1e-8)
    assert found.names[0] in ("rigid rotation of d0, d1", "rigid rotation of d1, d0")


def test_chains_tied_by_a_ratio():
    """Two free chains geared 1 : 2 at one end: 299 free directions, one rotation left.

    Reference: the dense problem in the coordinates that are left (q_0 of the second follows).
    """
    n = 150
    rows = [(c * n + k + 1, c * n + k + 2, STIFFNESS, 0.0, 0.0) for c in range(2) for k in range(n - 1)]
    banks = {"coupling": couplings(rows)}
    found = find_modes(assemble(discs(2 * n), banks, {"ratio": gear_rows([(1, n + 1, 1, 2)])}), count=10)
    line = 2.0 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)
    line[0, 0] = line[-1, -1] = 1.0
    whole = STIFFNESS * np.kron(np.eye(2), line)
    T = np.delete(np.eye(2 * n), n, axis=1)
    T[n, 0] = -0.5  # 1 q_1 + 2 q_2 = 0
    root = np.linalg.cholesky(INERTIA * T.T @ T)
    half = np.linalg.solve(root, np.linalg.solve(root, T.T @ whole @ T).T)
    expected = np.sqrt(np.abs(np.linalg.eigvalsh(half))[:10])
    assert found.total == 2 * n - 1
    assert 2.0 * math.pi * found.frequency[1:] == pytest.approx(expected[1:], rel=1e-8)
    assert found.frequency[0] == 0.0


@pytest.mark.filterwarnings("ignore::pitchpoint.core.errors.ValidityWarning")
@pytest.mark.parametrize(
    ("file", "scenario"), [("geared-rotor/model.yaml", "fast"), ("camshaft-drive/shafts.yaml", "engine")]
)
def test_both_ways_agree_on_machines(file, scenario, sparse_ways):
    """Gyroscopic, damped, with a driven spin; eigenvalues within the 1e-8 that rounding leaves both."""
    system = pp.compile_model(pp.load_model(EXAMPLES / file), scenario)
    one = find_modes(system, scenario)
    sparse_ways()
    two = find_modes(system, scenario, count=12)
    assert two.frequency == pytest.approx(one.frequency[:12], rel=1e-8)
    assert two.eigenvalue == pytest.approx(one.eigenvalue[:12], rel=1e-8)
    assert two.names == one.names[:12]
    assert two.effective_mass == pytest.approx(one.effective_mass[:12], rel=1e-5, abs=1e-5)


def test_states_of_elements(sparse_ways):
    """A mass on a spring and a Maxwell element beside a chain: cubic polynomial of Zener's solid."""
    m, k, k_m, d = 2.0, 8e5, 5e5, 400.0
    along_x = np.column_stack([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
    n = 12
    bodies = [
        *discs(n),
        Body(
            motion=PRISMATIC, axes=along_x, position=(1.0, 0.0, 0.0), mass=m, inertia=np.eye(3), name="mass"
        ),
        Body(motion=TORSION, polar_inertia=1.0, name="state", state=True),
    ]
    spring = np.zeros(1, spring_damper.RECORD)
    spring["i"], spring["free"], spring["k"] = n + 1, 1.0, k
    element = np.zeros(1, maxwell.RECORD)
    element["i"], element["k"], element["stiffness"], element["damping"] = n + 1, n + 2, k_m, d
    line = couplings([(j + 1, j + 2, STIFFNESS, 0.0, 0.0) for j in range(n - 1)])
    system = assemble(bodies, {"coupling": line, "spring_damper": spring, "maxwell": element})
    sparse_ways()
    modes = find_modes(system, count=3)
    roots = np.roots([m, m * k_m / d, k + k_m, k * k_m / d])  # m s^2 + k + k_m s/(s + k_m/d) = 0
    assert 2.0 * math.pi * modes.frequency == pytest.approx(
        [0.0, math.sqrt(k / m), free_chain(n, 1)], rel=1e-9
    )
    assert modes.eigenvalue[1] == pytest.approx(roots[roots.imag > 0][0], rel=1e-8)
    assert modes.state_eigenvalue == pytest.approx([roots[np.abs(roots.imag) < 1e-9][0].real], rel=1e-8)
    assert modes.states == 1 and abs(modes.state_eigenvalue[0]) < modes.state_reach < 1e6


def test_frequency_response_of_a_large_machine(sparse_ways):
    """Sparse and dense elimination differ by rounding."""
    system = pp.compile_model(pp.load_model(EXAMPLES / "geared-rotor/model.yaml"), "fast")
    where = (
        ["disc.fx", "transmission_error[stage]"],
        ["disc.uy", "mesh_force[stage]"],
        [50.0, 700.0],
        "fast",
    )
    one = find_response(system, *where).response
    sparse_ways()
    two = find_response(system, *where).response
    assert np.abs(two - one).max() < 1e-9 * np.abs(one).max()


def test_an_unstable_rest_shows_its_lowest_modes(sparse_ways):
    """Inverted pendulums have negative squares: they come first, as with few coordinates."""
    n = 12
    rows = [(k + 1, 0, 1e3 * (k - 2.5), 0.0, 0.0) for k in range(n)]
    system = assemble(discs(n), {"coupling": couplings(rows)})
    one = find_modes(system)
    sparse_ways()
    two = find_modes(system, count=4)
    assert np.count_nonzero(two.frequency < 0.0) == 3
    assert two.frequency == pytest.approx(one.frequency[:4], rel=1e-9)
