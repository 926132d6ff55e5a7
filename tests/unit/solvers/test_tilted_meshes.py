# SPDX-License-Identifier: Apache-2.0
"""Modes of meshes whose gears are tilted, so that the flanks touch at one end of the face only."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.solvers.cycle_means import shift
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.linear_system import linearise
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_records
from pitchpoint.system.system import System
from tests.support.machines import compiled

CONSTANT = "stiffness: {law: constant, value: 1e9}"


def machine(
    torque: float,
    *,
    law: str = CONSTANT,
    helix: float = 0.0,
    internal: bool = False,
    side: float = 0.0,
    gap: str = "0.4 mm",
) -> str:
    """A pinion on a fixed axis and a wheel, which tilts on a bearing beside it."""
    teeth = "normal_module: 4 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    hands = ("right", "right") if internal else ("right", "left")
    slope = [f", helix_angle: {helix} deg, hand: {hand}" if helix else "" for hand in hands]
    kind = ", type: internal" if internal else ""
    return f"""\
gears:
  a: {{number_of_teeth: 30, {teeth}{slope[0]}}}
  b: {{number_of_teeth: {75 if internal else 30}, {teeth}{slope[1]}{kind}}}
bodies:
  pinion: {{gears: [a]}}
  wheel: {{gears: [b], motion: free, mass: 6 kg, inertia_tensor: [0.02, 0.02, 0.04, 0, 0, 0]}}
meshes:
  m: {{gears: [a, b], backlash: {{base_tangent: {gap}}}, {law}}}
bearings:
  r: {{body: wheel, position: [0, 0, 0.4 m], stiffness: {{radial: 2e8, axial: 1e8, tilt: 2e5}}}}
torsion_springs:
  s: {{bodies: [wheel], stiffness: 1e6}}
loads:
  turn: {{body: pinion, torque: {torque} N m}}
  push: {{body: wheel, force: [{side} N, {side} N, 0]}}
"""


def cycle_mean(system: System, points: int) -> tuple[np.ndarray, np.ndarray]:
    """Mass matrix, and stiffness matrix averaged over loaded equilibria at equal steps of the mesh cycle."""
    own, total = system.copy(), 0.0
    at = find_equilibrium(own).state
    M = evaluate.matrix(own, at, 1.0, 0.0, 0.0)
    for _ in range(points):
        shift(mesh_records(own)[0], 1.0 / points)
        at = find_equilibrium(own, at).state
        assert np.abs(evaluate.residual(own, at)).max() < 1e-4
        total = total + evaluate.matrix(own, at, 0.0, 0.0, 1.0) / points
    return M, np.asarray(total)


def frequencies(M: np.ndarray, K: np.ndarray) -> np.ndarray:
    """Natural frequencies with the symmetric part of K [Hz]."""
    root = np.linalg.inv(np.linalg.cholesky(M))
    values = np.linalg.eigvalsh(root @ (0.5 * (K + K.T)) @ root.T)
    return np.sign(values) * np.sqrt(np.abs(values)) / math.tau


@pytest.mark.parametrize("helix", [0.0, 15.0])
@pytest.mark.parametrize("internal", [False, True])
@pytest.mark.parametrize("torque", [60.0, -60.0, 0.1])
def test_edge_contact_has_the_frequencies_of_the_tangents_at_its_equilibrium(helix, internal, torque):
    _, system = compiled(machine(torque, helix=helix, internal=internal))
    rest = find_equilibrium(system).state
    observed = evaluate.observe(system, rest)
    touching, penetration = (
        observed[system.layout.channel(f"{name}[m]")] for name in ("contact_state", "penetration")
    )
    assert penetration < 0.0  # a gap at mid-face, though the flank carries the torque
    assert touching == (1.0 if torque > 0.0 else -1.0)
    M, _, K = evaluate.linearize(system, rest)
    expected = frequencies(M, K)
    assert expected[0] > 0.0
    found = find_modes(system)
    assert not [note for note in found.notes if "carry no load" in note]
    assert np.sort(found.frequency) == pytest.approx(expected, rel=1e-8)


@pytest.mark.parametrize("width", ["exact", "slices, slices: 15"])
@pytest.mark.parametrize("helix", [0.0, 15.0])
def test_edge_contact_has_the_mean_stiffness_of_its_loaded_cycle(helix, width):
    law = f"stiffness: {{law: din3990}}, width: {width}"
    _, system = compiled(machine(60.0, law=law, helix=helix))
    found = linearise(system).at_rest
    M, K = cycle_mean(system, 64)
    # 64 equal steps across the jumps of the stiffness of a tooth pair, which the quadrature resolves
    assert np.sort(find_modes(system).frequency) == pytest.approx(frequencies(M, K), rel=2e-3)
    assert np.linalg.norm(found.K - K) < 2e-3 * np.linalg.norm(K)


LAWS = {
    "constant": CONSTANT,
    "slices": "stiffness: {law: din3990}, width: slices",
    "rigid": "contact: {level: rigid, stiffness: 4e8, planes: 9}",
}


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("helix", [0.0, 15.0])
def test_an_unloaded_mesh_of_tilted_gears_is_taken_at_first_contact(law, helix):
    """A force on the wheel tilts it. Contact at mid-face would press one end with a force that no load has.

    Flanks without force add k g g^T, which is positive semidefinite, to the stiffness without the mesh. The
    force at 1 nm is less than 1 N; its geometric stiffness is of the order of force over centre distance.
    """
    _, system = compiled(machine(0.0, law=LAWS[law], helix=helix, side=3000.0))
    apart, rest = system.copy(), find_equilibrium(system).state
    evaluate.residual(apart, rest)
    (mesh,) = mesh_records(apart)
    mesh["u0"] -= mesh["now"]["u"]  # the teeth centred in the backlash
    assert evaluate.observe(apart, rest)[system.layout.channel("contact_state[m]")] == 0.0
    M, _, K = evaluate.linearize(apart, rest)
    more = linearise(system).at_rest.K - K
    assert np.linalg.eigvalsh(0.5 * (more + more.T)).min() > -1.0 / 0.12
    found = find_modes(system)
    assert np.all(np.sort(found.frequency) * (1.0 + 1e-6) + 1e-3 >= frequencies(M, K))
    notes = " ".join(found.notes)
    assert "the flanks of m carry no load" in notes
    assert "the stiffness of m grows with the load from zero at first contact" in notes
