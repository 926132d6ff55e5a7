# SPDX-License-Identifier: Apache-2.0
"""A rattling pair without dampers, friction and loads keeps its energy through impacts on both flanks."""

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

MODEL = """
title: rattling helical pair
gears:
  pinion: {{number_of_teeth: 25, normal_module: 3 mm, helix_angle: 15 deg, hand: left, face_width: 40 mm,
           profile_shift_coefficient: 0}}
  wheel: {{number_of_teeth: 60, normal_module: 3 mm, helix_angle: 15 deg, hand: right, face_width: 40 mm,
          profile_shift_coefficient: 0}}
bodies:
  a: {{gears: [pinion], motion: {motion}, mass: 2 kg, inertia: 2e-3 kg m^2, transverse_inertia: 4e-3}}
  b: {{gears: [wheel], motion: {motion}, mass: 10 kg, inertia: 4.5e-2 kg m^2, transverse_inertia: 4e-2}}
bearings:
  at_a: {{body: a, stiffness: {{radial: 3e8 N/m, axial: 1e8 N/m, tilt: 3e5 N m/rad}}}}
  at_b: {{body: b, stiffness: {{radial: 5e8 N/m, axial: 2e8 N/m, tilt: 6e5 N m/rad}}}}
meshes:
  stage:
    gears: [pinion, wheel]
    backlash: {{normal: 0.05 mm}}
    stiffness: {{law: constant, value: 4e8 N/m}}
"""


def energy(system, state):
    """Kinetic energy, springs of the bearings (small displacements), flanks."""
    M = evaluate.matrix(system, state, 1.0, 0.0, 0.0)
    row = evaluate.observe(system, state)
    total = 0.5 * state.v @ M @ state.v + row[system.layout.channel("elastic_energy[stage]")]
    for bearing in system.records["bearing"]:
        first = int(system.program["body"][int(bearing["i"])]["dof"])
        size = int(system.program["body"][int(bearing["i"])]["joint"])
        moves = size - 1  # the spin has no spring
        u = state.q[first : first + moves]
        total += 0.5 * u @ np.array(bearing["K"])[:moves, :moves] @ u
    return total


@pytest.mark.parametrize("motion", ["planar", "free"])
def test_energy_is_kept_through_impacts(motion):
    """Relative to the energy of the approach, but for the integrator. Free gears tilt by about 1e-4 rad."""
    system = compile_model(loads_model(MODEL.format(motion=motion)))
    state = system.initial_state()
    names = list(system.layout.coordinates)
    approach = 0.6
    state.v[names.index("a.spin")] = 50.0
    state.v[names.index("b.spin")] = -50.0 * 25 / 60 + approach
    state.v[names.index("a.y")] = 0.02
    reduced = 1.0 / (1.0 / 2e-3 * (25 / 60) ** 2 + 1.0 / 4.5e-2)
    start = energy(system, state)
    run = runge_kutta.start_adaptive(system, state, rtol=1e-10, atol=1e-15, atol_rate=1e-11)
    touched = set()
    for t in np.linspace(2e-4, 2e-2, 100):
        assert run.advance_to(t).status == 1
        state = run.state()
        touched.add(float(evaluate.observe(system, state)[system.layout.channel("contact_state[stage]")]))
    assert {1.0, 0.0} <= touched
    assert abs(energy(system, state) - start) < 1e-6 * 0.5 * reduced * approach**2
