# SPDX-License-Identifier: Apache-2.0
"""Ripple of a drive: orders of the mean rotation, exact derivatives, an exact mean speed."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.elements.drive import target_of
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.write import model_text
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.step_choice import shortest_period
from pitchpoint.solvers.time import solve_time
from pitchpoint.sweep.speed import run_sweep
from pitchpoint.system.compile import compile_model
from tests.support.machines import SPARE

RPM = math.pi / 30.0
WAVES = (
    "{second: {order: 2, fluctuation: 2 %}, half: {order: 0.5, angle: 0.3 deg, phase: 40 deg}, "
    "sixth: {order: 6, fluctuation: 0.5 %, phase: -70 deg}}"
)
LAWS = {
    "constant": ("speed: 800 rpm", lambda t: 800.0 * RPM * t),
    "backwards": ("speed: -800 rpm", lambda t: -800.0 * RPM * t),
    "run-up": ("speed: {table: [[0, 20], [1, 120]]}", lambda t: 20.0 * t + 50.0 * t * t),
    "angle": (
        'angle: "3*t + 40*t^2 + 0.2*sin(9*t)"',
        lambda t: 3.0 * t + 40.0 * t * t + 0.2 * np.sin(9.0 * t),
    ),
}


def machine(law: str, ripple: str = WAVES, more: str = "") -> str:
    """A disc of 0.3 kg m^2 with a drive."""
    drive = (
        f"drive: {{disc: {{{law}, ripple: {ripple}}}}}" if law else f"drive: {{disc: {{ripple: {ripple}}}}}"
    )
    return (
        SPARE
        + "bodies:\n  disc: {motion: torsion, inertia: 0.3 kg m^2}\n"
        + f"scenarios:\n  run: {{{drive}, duration: 1 s{more}}}\n"
    )


def drive_of(text: str):
    """The only drive of a model, and the system that owns its pool."""
    system = compile_model(loads_model(text), "run")
    system.workspace  # noqa: B018 - fills in the pool addresses of the records
    return system.records["drive"][0], system


def rippled(phi):
    """Angle of the ripple `WAVES` about a mean angle."""
    waves = ((2.0, 0.02 / 4.0, 0.0), (0.5, math.radians(0.3), 40.0), (6.0, 0.005 / 12.0, -70.0))
    return phi + sum(a * np.sin(k * phi + math.radians(b)) for k, a, b in waves)


@pytest.mark.parametrize("name", LAWS)
def test_angle_speed_and_acceleration_are_those_of_the_waves_over_the_mean_angle(name):
    law, mean = LAWS[name]
    record, _system = drive_of(machine(law))
    h = 2e-4
    for t in (0.0, 0.137, 0.9):
        angle, speed, acceleration = target_of(record, t)
        assert angle == pytest.approx(rippled(mean(t)), abs=1e-11)
        # differences of order 8 of the closed form
        x = np.array([rippled(mean(t + k * h)) for k in range(-4, 5)])
        first = np.array([3, -32, 168, -672, 0, 672, -168, 32, -3]) / 840.0
        second = np.array([-9, 128, -1008, 8064, -14350, 8064, -1008, 128, -9]) / 5040.0
        assert speed == pytest.approx(first @ x / h, rel=1e-8)
        assert acceleration == pytest.approx(second @ x / h**2, rel=1e-5, abs=1e-3)


def test_the_mean_speed_of_whole_periods_is_exact():
    """Two revolutions, the period of order 1/2, take the time of the mean speed; also after a day."""
    record, _system = drive_of(machine("speed: 800 rpm"))
    period = 4.0 * math.pi / (800.0 * RPM)
    for begin in (0.0123, 86400.0):
        turned = target_of(record, begin + period)[0] - target_of(record, begin)[0]
        assert turned == pytest.approx(4.0 * math.pi, abs=1e-8)


def test_fluctuation_is_the_range_of_the_speed_over_its_mean():
    record, _system = drive_of(machine("speed: 800 rpm", "{one: {order: 2, fluctuation: 3 %}}"))
    speeds = [target_of(record, t)[1] for t in np.linspace(0.0, 0.0375, 2001)]  # one period
    assert (max(speeds) - min(speeds)) / (800.0 * RPM) == pytest.approx(0.03, rel=1e-5)


@pytest.mark.parametrize("method", ["generalized_alpha", "rk4", "gstiff", "kinematics"])
def test_a_disc_needs_the_torque_of_its_acceleration(method):
    """0.3 kg m^2 times a (k w)^2 = 0.01 (2 x 800 rpm)^2 / 2 at order 2, whatever the method."""
    ripple = "{one: {order: 2, fluctuation: 2 %}}"
    text = machine("speed: 800 rpm", ripple, f", method: {method}, step: 20 us").replace("1 s", "0.15 s")
    found = solve_time(compile_model(loads_model(text), "run"))
    t, w = found["time"].values, 800.0 * RPM
    expected = -0.3 * 0.005 * (2.0 * w) ** 2 * np.sin(2.0 * w * t)
    np.testing.assert_allclose(found["torque[disc]"].values[3:], expected[3:], atol=2e-3 * expected.max())
    np.testing.assert_allclose(found["speed[disc]"].values, w * (1.0 + 0.01 * np.cos(2.0 * w * t)), rtol=1e-6)


PAIR = """
gears:
  g1: {number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 45, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  crank: {gears: [g1], motion: torsion, inertia: 0.01 kg m^2}
  idler: {gears: [g2], motion: torsion, inertia: 0.02 kg m^2}
meshes:
  stage: {gears: [g1, g2], backlash: {base_tangent: 0.1 mm}, stiffness: {law: constant, value: 4e8 N/m},
    damper: {ratio: 0.05}}
loads: {drag: {body: idler, torque: 8 N m}}
scenarios:
  run:
    drive: {crank: {speed: 600 rpm, ripple: {second: {order: 2, fluctuation: 2 %}}}}
    duration: 0.2 s
    settle_time: 0.1 s
  sweep:
    drive: {crank: {ripple: {second: {order: 2, fluctuation: 2 %}}}}
    sweep: {body: crank, speed: [200 rpm, 600 rpm], points: 3, settle_periods: 60, measure_periods: 30}
"""


def test_a_sweep_steps_the_mean_speed_below_the_ripple():
    """The last point is the run at its speed: order 2 repeats every 15 teeth, 30 are two periods."""
    model = loads_model(PAIR)
    points = run_sweep(compile_model(model, "sweep")).points
    assert [p["direction"] for p in points] == 3 * ["up"] + 3 * ["down"]
    for point in points:
        speed = point["channels"]["speed[crank]"]
        assert speed["mean"] == pytest.approx(point["speed"], rel=1e-6)
        assert (speed["max"] - speed["min"]) / point["speed"] == pytest.approx(0.02, rel=1e-3)
    run = solve_time(compile_model(model, "run"))["mesh_force[stage]"].attrs["statistics"]
    for point in (points[2], points[3]):
        swept = [point["channels"]["mesh_force[stage]"][k] for k in ("mean", "rms", "min", "max")]
        np.testing.assert_allclose(swept, run, rtol=2e-3)


def test_a_held_body_starts_a_sweep_at_the_speed_of_its_first_point():
    text = PAIR.replace(
        "    drive: {crank: {ripple: {second: {order: 2, fluctuation: 2 %}}}}\n", "    hold: [crank]\n"
    )
    text = text.replace("settle_periods: 60", "settle_periods: 0")
    first = run_sweep(compile_model(loads_model(text), "sweep")).points[0]
    assert first["channels"]["mesh_force[stage]"]["rms"] == pytest.approx(0.0, abs=1e-3)


def test_amplitudes_are_paths_of_a_study_and_survive_writing():
    model = loads_model(PAIR)
    other = model.replace("scenarios.run.drive.crank.ripple.second.fluctuation", 0.04)
    assert other.scenarios["run"].drive["crank"].ripple["second"].amplitude == pytest.approx(0.01)
    assert loads_model(model_text(other)).scenarios == other.scenarios
    more = model.replace("scenarios.run.drive.crank.ripple.fourth", {"order": 4, "angle": "0.1 deg"})
    assert list(more.scenarios["run"].drive["crank"].ripple) == ["second", "fourth"]


def test_a_fast_ripple_shortens_the_step():
    model = loads_model(machine("speed: 600 rpm", "{fast: {order: 300, angle: 1e-4}}"))
    start = prepare_start(compile_model(model, "run"), model.scenarios["run"])
    assert shortest_period(start, model.scenarios["run"]) == pytest.approx(1.0 / 3000.0, rel=0.04)


FAULTS = {
    "both amplitudes": (machine("speed: 1", "{w: {order: 2, angle: 1, fluctuation: 1}}"), "angle together"),
    "no amplitude": (machine("speed: 1", "{w: {order: 2}}"), "gives none of fluctuation, angle"),
    "reversal": (machine("speed: 1", "{w: {order: 2, angle: 0.3}, v: {order: 1, angle: 0.4}}"), "reverses"),
    "no law": (
        machine("", WAVES),
        "gives none of speed, angle; give exactly one of them",
    ),
    "a law in a sweep": (
        PAIR.replace("drive: {crank: {ripple", "drive: {crank: {speed: 9, ripple"),
        "drive with ripple only",
    ),
    "order zero": (machine("speed: 1", "{w: {order: 0, angle: 0.1}}"), "out of range"),
    "a translation": (
        SPARE + "bodies: {block: {mass: 1 kg, joint: slide}}\njoints: {slide: {type: prismatic}}\n"
        "scenarios: {run: {drive: {slide.z: {velocity: 1 m/s, ripple: {w: {order: 1, angle: 0.1}}}}, "
        "duration: 1 s}}\n",
        "applies to rotations only",
    ),
}


@pytest.mark.parametrize("name", FAULTS)
def test_impossible_ripples_are_refused_with_their_place(name):
    text, message = FAULTS[name]
    with pytest.raises(ModelError) as error:
        loads_model(text)
    assert message in str(error.value)
    assert "drive" in str(error.value)
