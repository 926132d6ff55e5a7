# SPDX-License-Identifier: Apache-2.0
"""Rayleigh and modal damping of machines that are constrained, driven or soft: the ratio is as given."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.modal import find_modes
from tests.support.machines import compiled

J = (0.02, 0.05, 0.03)
"""Inertias of the discs [kg m^2]."""
K = (4e4, 9e4)
"""Stiffness between them [N m/rad]."""


def discs(damping: str, scenario: str, more: str = "") -> str:
    """Three discs on one shaft, joined by two springs."""
    bodies = "".join(
        f"  {n}: {{motion: torsion, inertia: {j} kg m^2, position: [0, 0, {k} m]}}\n"
        for k, (n, j) in enumerate(zip("abc", J, strict=True))
    )
    return (
        f"bodies:\n{bodies}torsion_springs:\n"
        f"  ab: {{bodies: [a, b], stiffness: {K[0]} N m/rad}}\n"
        f"  bc: {{bodies: [b, c], stiffness: {K[1]} N m/rad}}\n"
        f"{more}damping: {damping}\nscenarios:\n  on: {scenario}\n"
    )


def closed_form(M, stiffness):
    """Frequencies [Hz] of a small matrix pencil, lowest first."""
    return np.sqrt(np.abs(np.sort(np.linalg.eigvals(np.linalg.solve(M, stiffness)).real))) / (2.0 * math.pi)


CHAIN = np.array([[K[0], -K[0], 0.0], [-K[0], K[0] + K[1], -K[1]], [0.0, -K[1], K[1]]])


@pytest.mark.parametrize("drive", ["", "drive: {a: {speed: 100 rad/s}}, "])
def test_a_driven_disc_leaves_the_modal_ratio_as_it_is(drive):
    text = discs("{modal: 0.02}", f"{{{drive}duration: 1 s}}")
    modes = find_modes(compiled(text, "on")[1])
    places = slice(1, None) if drive else slice(None)
    hertz = closed_form(np.diag(J)[places, places], CHAIN[places, places])
    assert modes.frequency == pytest.approx(hertz, rel=1e-9, abs=1e-6)
    assert modes.damping_ratio[-2:] == pytest.approx([0.02, 0.02], rel=1e-9)


def test_a_ratio_between_discs_leaves_the_modal_ratio_as_it_is():
    """The row a + 2 c = 0 leaves q = T (a, b) with T = [[1, 0], [0, 1], [-1/2, 0]]."""
    text = discs("{modal: 0.02}", "{duration: 1 s}", "ratios:\n  r: {terms: {a: 1, c: 2}}\n")
    modes = find_modes(compiled(text, "on")[1])
    T = np.array([[1.0, 0.0], [0.0, 1.0], [-0.5, 0.0]])
    hertz = closed_form(T.T @ np.diag(J) @ T, T.T @ CHAIN @ T)
    assert modes.frequency == pytest.approx(hertz, rel=1e-9)
    assert modes.damping_ratio == pytest.approx([0.02, 0.02], rel=1e-9)


def test_mass_proportional_damping_with_a_driven_disc_is_that_of_the_discs_that_vibrate():
    """With a held, D = a M of the others: zeta = a / (2 omega)."""
    rate = 5.0
    text = discs(f"{{rayleigh: {{mass: {rate} 1/s}}}}", "{drive: {a: {speed: 100 rad/s}}, duration: 1 s}")
    modes = find_modes(compiled(text, "on")[1])
    wanted = rate / (2.0 * 2.0 * math.pi * closed_form(np.diag(J[1:]), CHAIN[1:, 1:]))
    assert modes.damping_ratio == pytest.approx(wanted, rel=1e-9)


@pytest.mark.parametrize("damping", ["{modal: 0.1}", "{rayleigh: {mass: 5 1/s, stiffness: 1e-5 s}}"])
def test_what_a_drive_turns_is_not_braked(damping):
    """Under a constant drive all discs turn as one, and the drive needs no torque."""
    text = discs(damping, "{drive: {a: {speed: 100 rad/s}}, duration: 1 s}")
    system = compiled(text, "on")[1]
    start = prepare_start(system, system.scenario)
    D = np.zeros((3, 3))
    for record in start.system.records["damping"]:
        D[record["dof_i"], record["dof_j"]] += record["D"][0, 0]
    assert np.abs(D).max() > 0.01
    assert np.abs(D @ np.ones(3)).max() < 1e-12 * np.abs(D).max()
    assert D == pytest.approx(D.T, abs=1e-12 * np.abs(D).max())


CRANK = """\
bodies:
  crank: {motion: torsion, inertia: 0.01 kg m^2, position: [0, 0, 0]}
  hub: {motion: torsion, inertia: 0.01 kg m^2, position: [0, 0, 100 mm]}
  wheel: {motion: torsion, inertia: 0.05 kg m^2, position: [0, 0, 200 mm]}
torsion_springs:
  shaft: {bodies: [hub, wheel], stiffness: 8000 N m/rad}
ratios:
  teeth: {terms: {crank: 1, hub: -2}}
loads:
  shaking: {body: wheel, torque: 0 N m}
damping: {modal: 0.1}
scenarios:
  on: {drive: {crank: {speed: 0 rad/s}}, duration: 1 s}
"""


def test_amplification_at_resonance_is_that_of_the_ratio_asked_for():
    """One freedom with 10 %: a torque at the undamped frequency gives 1/(2 zeta) = 5 times static."""
    system = compiled(CRANK, "on")[1]
    omega = math.sqrt(8000.0 / 0.05)
    modes = find_modes(system)
    assert modes.frequency == pytest.approx([omega / (2.0 * math.pi)], rel=1e-9)
    assert modes.damping_ratio == pytest.approx([0.1], rel=1e-9)
    assert 1.0 / (2.0 * modes.damping_ratio[0]) == pytest.approx(5.0, rel=1e-9)


def test_a_soft_mode_of_a_stiff_machine_is_damped():
    """Two elastic shafts on a soft coupling: omega^2 = k (1/J1 + 1/J2), far below that of the pieces."""
    text = """\
shafts:
  left: {sections: [{length: 200 mm, diameter: 60 mm}], position: [0, 0, 0], largest_piece: 10 mm}
  right: {sections: [{length: 200 mm, diameter: 60 mm}], position: [0, 0, 200 mm], largest_piece: 10 mm}
bearings:
  l1: {body: left, position: [0, 0, 20 mm], stiffness: {radial: 1e9 N/m, axial: 1e9 N/m}}
  l2: {body: left, position: [0, 0, 180 mm], stiffness: {radial: 1e9 N/m}}
  r1: {body: right, position: [0, 0, 20 mm], stiffness: {radial: 1e9 N/m, axial: 1e9 N/m}}
  r2: {body: right, position: [0, 0, 180 mm], stiffness: {radial: 1e9 N/m}}
couplings:
  soft: {bodies: [left, right], position: [0, 0, 200 mm], stiffness: {torsion: 2 N m/rad}}
damping: {modal: 0.02}
scenarios:
  on: {duration: 1 s}
"""
    modes = find_modes(compiled(text, "on")[1])
    inertia = math.pi / 32 * 0.06**4 * 7850.0 * 0.2
    assert modes.frequency[0] == 0.0
    assert modes.frequency[1] == pytest.approx(math.sqrt(2 * 2.0 / inertia) / (2.0 * math.pi), rel=1e-2)
    assert modes.damping_ratio[1] == pytest.approx(0.02, rel=1e-6)  # rounding of the stiffest pieces
    # iterations about the lowest mode lose digits of those far above it
    assert modes.damping_ratio[2:] == pytest.approx(np.full(len(modes.damping_ratio) - 2, 0.02), rel=1e-4)
