# SPDX-License-Identifier: Apache-2.0
"""Long steps outside of a gear train: order of the error, the found part, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.core.errors import ModelError, SolverError
from pitchpoint.solvers.implicit.gear_part import fast_bodies
from pitchpoint.solvers.initial_state.start import prepare_start

MODEL = """
gears:
  a: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  b: {number_of_teeth: 40, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
meshes: {stage: {gears: [a, b], stiffness: {law: constant, value: 3e8 N/m}, damper: {ratio: 0.05}}}
bodies:
  motor: {inertia: 0.02 kg m^2}
  pinion: {gears: [a], inertia: 0.002 kg m^2}
  wheel: {gears: [b], inertia: 0.02 kg m^2}
  hub: {inertia: 2 kg m^2}
  blade: {inertia: 0.5 kg m^2}
joints:
  hub_bearing: {type: revolute, bodies: [ground, hub], position: [0, 0, 0]}
  pin: {type: revolute, bodies: [hub, blade], position: [0, 0, 0]}
torsion_springs: {root: {bodies: [blade, hub], stiffness: 4000 N m/rad, damping: 2 N m s/rad}}
couplings:
  input: {bodies: [motor, pinion], stiffness: {torsion: 2e4 N m/rad}, damping: {torsion: 1 N m s/rad}}
  shaft: {bodies: [wheel, hub], stiffness: {torsion: SHAFT N m/rad}, damping: {torsion: 2 N m s/rad}}
loads:
  push: {body: motor, torque: "20 + 10*step(t - 0.01)"}
  brake: {body: hub, torque: 40 N m}
scenarios:
  run: {speed: {motor: 500 rpm}, duration: 0.1 s, step: 0.1 ms, settle_time: 0 sMORE}
"""


def solved(more: str = "", shaft: str = "3000"):
    """Result of the run with further keys of the scenario."""
    text = MODEL.replace("MORE", more).replace("SHAFT", shaft)
    return pp.solve_time(pp.compile_model(pp.load_model(text=text), "run"))


def test_the_error_is_of_second_order_in_the_long_step():
    """Speeds of hub, blade and motor after a torque step, against 0.1 ms everywhere."""
    whole = solved()
    errors = []
    for step in (4, 2, 1):
        parts = solved(f", long_step: {step} ms")
        at = slice(39, None, 40)  # at the end of long steps
        errors.append(
            [
                np.abs(parts[f"speed[{b}]"].values[1:][at] - whole[f"speed[{b}]"].values[1:][at]).max()
                for b in ("hub", "blade", "motor")
            ]
        )
    orders = np.log2(np.array(errors[:-1]) / np.array(errors[1:]))
    assert (orders[-1] > 1.6).all(), orders
    assert max(errors[-1]) < 5e-3  # 1e-4 of the speed of the motor


def test_the_gear_train_ends_at_a_body_that_carries_another_one():
    system = pp.compile_model(pp.load_model(text=MODEL.replace("MORE", "").replace("SHAFT", "3000")), "run")
    assert {system.layout.bodies[b] for b in fast_bodies(system)} == {"motor", "pinion", "wheel"}
    assert prepare_start(system, system.scenario).state.q.size == 5


@pytest.mark.parametrize(
    ("more", "text"),
    [
        (", long_step: 1 ms, method: rk4", "long_step .*is not available with rk4"),
        (", long_step: 0.05 ms", "long_step .*is shorter than step"),
    ],
)
def test_impossible_long_steps_are_refused(more, text):
    with pytest.raises(ModelError, match=text):
        solved(more)


def test_a_stiff_shaft_takes_no_long_steps():
    with pytest.raises(SolverError, match="long_step: 0.004 s is too long for hub.spin.*limit"):
        solved(", long_step: 4 ms", shaft="1e6")


def test_drives_take_no_long_steps():
    with pytest.raises(SolverError, match="long_step: the machine has closed loops, rigid ratios or drives"):
        solved(", long_step: 1 ms, drive: {hub: {speed: 100 rpm}}")
