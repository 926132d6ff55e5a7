# SPDX-License-Identifier: Apache-2.0
"""Long steps outside of a gear train: order of the error, the found part, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.core.errors import ModelError, SolverError
from pitchpoint.solvers.implicit import gear_part, generalized_alpha
from pitchpoint.solvers.implicit.gear_part import fast_bodies
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.system import evaluate

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


LOOP = """
sensors: {speed: {type: joint, coordinate: motor, derivative: 1}}
blocks:
  slow: {type: filter, input: speed, time_constant: 1 ms}
  wanted: {type: sum, inputs: {SIGNAL: -GAIN}, offset: GAIN*500 rpm, unit: N m}
actuators: {drive: {type: torque, signal: wanted, bodies: [motor]}}
"""


@pytest.mark.parametrize("signal", ["speed", "slow"])
def test_a_fast_control_loop_of_a_gear_train_takes_no_long_steps(signal):
    """With G H/J = 3 the held torque diverges, with 1.5 its error is 10 %; the limit is 0.1."""
    for gain, refused in ((60, True), (1.5, False)):
        loop = LOOP.replace("SIGNAL", signal).replace("GAIN*500 rpm", str(gain * 52.36))
        text = MODEL.replace("MORE", ", long_step: 1 ms").replace("SHAFT", "3000") + loop.replace(
            "GAIN", str(gain)
        )
        system = pp.compile_model(pp.load_model(text=text), "run")
        begun = prepare_start(system, system.scenario)
        if refused:
            with pytest.raises(
                SolverError, match="long_step: 0.001 s is too long for motor.spin: a control loop"
            ):
                gear_part.start(begun.system, begun.state, 1e-4, 10)
        else:
            gear_part.start(begun.system, begun.state, 1e-4, 10)


def test_long_steps_of_a_body_that_tumbles():
    """A free body beside the gear train: the error is that of equal steps of 1 ms."""
    plate = "  plate: {mass: 1 kg, inertia_tensor: [0.01, 0.02, 0.025, 0, 0, 0]}\n"
    text = MODEL.replace("MORE", "").replace("SHAFT", "3000").replace("bodies:\n", f"bodies:\n{plate}", 1)
    text = text.replace(
        "joints:\n", "joints:\n  fly: {type: free, bodies: [ground, plate], position: [1 m, 0, 0]}\n"
    )
    found = []
    for h, count in ((1e-4, 1), (1e-3, 1), (1e-4, 10)):
        system = pp.compile_model(pp.load_model(text=text), "run")
        state = system.initial_state()
        beta = system.layout.coordinates.index("plate.beta")
        state.v[beta - 1 : beta + 1] = 0.5, 20.0
        begun = (
            generalized_alpha.start(system, state, h)
            if count == 1
            else gear_part.start(system, state, h, count)
        )
        assert begun.advance(round(0.2 / h)).status == 1
        evaluate.residual(system, begun.state())
        found.append(system.workspace.fr[1]["S"].copy())
    equal, long = (np.abs(axes - found[0]).max() for axes in found[1:])
    assert long < 4.0 * equal + 1e-3, (equal, long)


def test_samples_are_at_the_ends_of_long_steps():
    """Period of 0.7 ms, and a window that begins within a long step: statistics are those of all steps."""
    for more in (", sample_rate: 1.43 kHz, statistics: samples", ", sample_rate: 1 kHz"):
        text = MODEL.replace("settle_time: 0 s", "settle_time: 20.5 ms").replace("SHAFT", "3000")
        run = []
        for step in ("", ", long_step: 1 ms"):
            model = pp.load_model(text=text.replace("MORE", more + step))
            run.append(pp.solve_time(pp.compile_model(model, "run")))
        twist = [r["twist[root]"].values for r in run]
        # 1e-3 with values of the last long step; the frequency of the blade in long steps is 0.3 % too low
        assert np.abs(twist[1] - twist[0]).max() < 3e-5


def test_failed_long_steps_are_replaced_by_short_ones():
    """The blade slips against falling friction, which steps of 1 ms do not resolve: the run goes on, with the
    end of the run with short steps; every sample is recorded once."""
    rub = "{bodies: [blade, hub], capacity: 10 N m, static_ratio: 3, stribeck_speed: 0.05 rad/s, law: smooth"
    wave = "loads:\n  wave: {body: blade, torque: 60*sin(300*t)}\n"
    clutches = f"clutches:\n  rub: {rub}, slip_speed: 1e-4 rad/s}}\n"
    text = MODEL.replace("SHAFT", "3000").replace("loads:\n", clutches + wave)
    runs = []
    for step in ("", ", long_step: 1 ms"):
        model = pp.load_model(text=text.replace("MORE", step + ", sample_rate: 10 kHz"))
        runs.append(pp.solve_time(pp.compile_model(model, "run")))
    equal, long = runs
    assert "steps were divided where Newton's method failed" in long.attrs["notes"]
    np.testing.assert_allclose(long["time"].values, 1e-4 * np.arange(1001), atol=1e-12)
    # steps of 1 ms before the first failure deviate by the same 2 % of the range of the speed of the hub
    for body, near in (("hub", 0.02), ("blade", 0.08), ("motor", 0.08)):
        assert np.abs(long[f"speed[{body}]"] - equal[f"speed[{body}]"]).values[::10].max() < near, body
