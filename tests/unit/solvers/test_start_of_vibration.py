# SPDX-License-Identifier: Apache-2.0
"""Runs under pulsating torques start in the steady vibration: no natural mode is excited by any order."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.operating_point import operating_point
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

J_1, J_2, K, C, MEAN, WAVE = 0.04, 0.08, 1e4, 0.5, 100.0, 50.0
SPEED = 100.0 * np.pi
JUMP = "the loads do not balance"


def rotors(motor, load="balance", more="", duration="20 ms", bodies="motor, load"):
    """Two inertias on a torsion spring; the natural frequency is 97.5 Hz."""
    return (
        f"bodies:\n  motor: {{motion: torsion, inertia: {J_1} kg m^2}}\n"
        f"  load: {{motion: torsion, inertia: {J_2} kg m^2}}\n"
        f"couplings:\n  c: {{bodies: [{bodies}], stiffness: {{torsion: {K} N m/rad}}, "
        f"damping: {{torsion: {C}}}}}\n"
        f"loads:\n  m: {{body: motor, torque: '{motor}'}}\n  l: {{body: load, torque: '{load}'}}\n"
        f"scenarios:\n  s: {{{more or 'speed: {motor: 3000 rpm}, '}duration: {duration}, step: 5 us}}\n"
    )


def started(text, name="s"):
    model = loads_model(text)
    return prepare_start(compile_model(model, name), model.scenarios[name])


def solved(text, name="s"):
    model = loads_model(text)
    return solve_time(compile_model(model, name))


def twist(order, inertia=J_1):
    """Complex amplitude of the twist [rad] for a wave of torque on the body of an inertia; rigid: none.

    M q = T with q = (q_1, q_2): J_1 J_2/(J_1 + J_2) twist'' + C twist' + K twist = T J_other/(J_1 + J_2).
    """
    omega, both = order * SPEED, J_1 + J_2
    return WAVE * (both - inertia) / both / (K + 1j * omega * C - omega**2 * J_1 * J_2 / both)


@pytest.mark.parametrize("wave", ["cos", "sin"])
@pytest.mark.parametrize("order, argument", [(0.05, "t"), (1, "t"), (2, "t"), (48, "t"), (48, "angle")])
def test_the_start_is_the_steady_vibration(order, argument, wave):
    of_angle = argument == "angle"
    start = started(rotors(f"100*(1 + 0.5*{wave}({order * (1.0 if of_angle else SPEED)!r}*{argument}))"))
    system, state = start.system, start.state
    at = [system.spin("motor"), system.spin("load")]
    amplitude = twist(order) * (1.0 if wave == "cos" else -1j)
    if of_angle:  # the mean torque twists the motor by 0.01 rad, 27 degrees of the wave
        amplitude *= np.exp(1j * order * start.mean.q[at[0]])
    ripple = start.cycle.offset[at]
    twisted, sheared = state.q[at] @ [1.0, -1.0], (state.v[at] - ripple) @ [1.0, -1.0]
    assert twisted == pytest.approx(MEAN / K + amplitude.real, abs=2e-4 * abs(amplitude))
    rate = 1j * order * SPEED * amplitude
    assert sheared == pytest.approx(rate.real, abs=2e-4 * abs(rate))
    assert (state.v[at] - ripple - SPEED) @ [J_1, J_2] == pytest.approx(0.0, abs=1e-9 * SPEED)


def test_a_fast_ripple_of_the_motor_does_not_reach_the_coupling():
    """Hand value of the amplitude 0.069 N m; the deflection of the torque at t = 0 gave 139 N m."""
    data = solved(rotors("100*(1 + 0.5*cos(48*angle))", duration="40 ms"))
    torque = -data["coupling_force[c.mz]"].values.ravel()
    size = abs((K + 1j * 48.0 * SPEED * C) * twist(48))
    assert torque[0] == pytest.approx(MEAN, abs=1.01 * size)
    assert torque.max() - torque.min() == pytest.approx(2.0 * size, rel=0.02)


def test_a_slow_wave_is_carried_by_the_coupling():
    """Two thirds of the wave accelerate the load: the coupling carries them from the start."""
    data = solved(rotors("100*(1 + 0.5*cos(15*t))", duration="0.1 s"))
    torque = -data["coupling_force[c.mz]"].values.ravel()
    wave = J_2 / (J_1 + J_2) * WAVE * np.cos(15.0 * data["time"].values)
    assert torque == pytest.approx(MEAN + wave, abs=1e-3 * WAVE)


@pytest.mark.parametrize(
    "name, text",
    {
        "over time": rotors("100*(1 + 0.5*cos(15080*t))"),
        "on the load": rotors("balance", "-100*(1 + 0.5*cos(48*angle))"),
        "balanced by hand": rotors("100*(1 + 0.5*cos(48*angle))", "-100"),
        "driven": rotors("-100*(1 + 0.5*cos(48*angle))", more="drive: {load: {speed: 3000 rpm}}, ", load="0"),
        "reversed": rotors("balance", "-100*(1 + 0.5*cos(48*angle))", bodies="load, motor"),
        "no common period": rotors(
            "100*(1 + 0.5*cos(48*angle))", "-100*(1 + 0.2*sin(40*sqrt(2)*angle))", duration="20 ms"
        ),
    }.items(),
)
def test_no_mode_is_excited(name, text):
    data = solved(text)
    torque = data["coupling_force[c.mz]"].values.ravel()
    assert np.abs(np.abs(torque) - MEAN).max() < 0.25
    assert JUMP not in str(data.attrs.get("notes", ""))


def test_the_linear_system_is_that_of_the_mean():
    model = loads_model(rotors("100*(1 + 0.5*cos(48*angle))"))
    point = operating_point(compile_model(model, "s"), "s")
    spins = [point.system.spin("motor"), point.system.spin("load")]
    assert point.state.q[spins] @ [1.0, -1.0] == pytest.approx(MEAN / K, rel=1e-9)
    assert point.state.v[spins] == pytest.approx([SPEED, SPEED], rel=1e-9)


def gears(wave, more="damper: {ratio: 0.05}"):
    gear = "normal_module: 3 mm, face_width: 20 mm, helix_angle: 15 deg, profile_shift_coefficient: 0"
    return (
        f"gears:\n  a: {{number_of_teeth: 20, hand: left, {gear}}}\n  b: {{number_of_teeth: 60, {gear}, "
        "hand: right}\nbodies:\n  driver: {gears: [a], motion: free, mass: 1 kg, inertia: 2e-3 kg m^2, "
        "transverse_inertia: 2e-3 kg m^2}\n  driven: {gears: [b], motion: free, mass: 5 kg, "
        "inertia: 0.05 kg m^2, transverse_inertia: 0.03 kg m^2}\n"
        "  machine: {motion: torsion, inertia: 1 kg m^2}\n"
        "bearings:\n  one: {body: driver, stiffness: {radial: 2e8 N/m, axial: 1e8 N/m, tilt: 1e5}, "
        "damping: {ratio: 0.02}}\n  two: {body: driven, stiffness: {radial: 3e8 N/m, axial: 1e8 N/m, "
        "tilt: 2e5}, damping: {ratio: 0.02}}\ncouplings:\n  axle: {bodies: [driven, machine], "
        "stiffness: {torsion: 2e4}, damping: {torsion: 2}}\n"
        f"meshes:\n  stage: {{gears: [a, b], backlash: {{normal: 60 um}}, stiffness: {{law: constant, "
        f"value: 4e8 N/m}}, {more}}}\n"
        f"loads:\n  in: {{body: driver, torque: '60*(1 + {wave})'}}\n"
        "  out: {body: machine, torque: balance}\n"
        "scenarios:\n  s: {speed: {driver: 3000 rpm}, duration: 30 ms, step: 10 us}\n"
    )


@pytest.mark.parametrize("order", [2, 8])
def test_gears_on_bearings_start_in_the_steady_vibration(order):
    """The first period does not differ from the last one; the axle mode of 24 Hz is not excited."""
    data = solved(gears(f"0.3*cos({order}*angle)"))
    for name in ("mesh_force[stage]", "coupling_force[axle.mz]", "bearing_force[two.radial]"):
        values = data[name].values.ravel()
        count = values.size // 3
        first, last = values[:count], values[-count:]
        assert first.mean() == pytest.approx(last.mean(), rel=2e-3)
        assert np.ptp(first) == pytest.approx(np.ptp(last), rel=0.05)


def test_gears_that_separate_start_from_the_mean_deflection():
    """A wave of four times the mean torque has no linear vibration."""
    start = started(gears("4*cos(8*angle)"))
    assert np.array_equal(start.state.q, start.mean.q)
    free = started(gears("0.3*cos(8*angle)"))
    assert not np.array_equal(free.state.q, free.mean.q)


def test_a_resonance_without_damping_starts_from_the_mean_deflection():
    order = np.sqrt(K * (J_1 + J_2) / (J_1 * J_2)) / SPEED
    text = rotors(f"100*(1 + 0.5*cos({float(order)!r}*angle))").replace(f"torsion: {C}}}", "torsion: 0}")
    start = started(text)
    twisted = start.state.q[start.system.spin("motor")] - start.state.q[start.system.spin("load")]
    assert np.isfinite(twisted)
