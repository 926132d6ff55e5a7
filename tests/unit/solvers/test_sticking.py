# SPDX-License-Identifier: Apache-2.0
"""Runs that start with a clutch that sticks: its bristles carry the load from the first instant on."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.compile import compile_model

MODEL = """\
title: engine, clutch, gears, vehicle
gears:
  pinion: {{number_of_teeth: 17, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0.3}}
  wheel: {{number_of_teeth: 68, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: -0.3}}
bodies:
  engine: {{motion: torsion, inertia: 0.25 kg m^2, position: [0, 0, -200 mm]}}
  disc: {{gears: [pinion], motion: torsion, inertia: 0.06 kg m^2, position: [0, 0, 0]}}
  output: {{gears: [wheel], motion: torsion, inertia: 0.64 kg m^2}}
  vehicle: {{motion: torsion, inertia: 80 kg m^2, position: [127.6 mm, 0, 300 mm]}}
clutches:
  clutch: {{bodies: [engine, disc], capacity: {capacity} N m}}
torsion_springs:
  half_shafts: {{bodies: [output, vehicle], stiffness: 8000 N m/rad}}
meshes:
  gearbox: {{gears: [pinion, wheel], center_distance: 127.6 mm, stiffness: {{law: constant, value: 4e8 N/m}}}}
loads:
  gas: {{body: engine, torque: 60 N m}}
  road: {{body: vehicle, torque: {road}}}
scenarios:
  cruise: {{{drive} speed: {{engine: 1500 rpm, disc: {disc} rpm}}, duration: 20 ms, step: 0.02 ms,
    settle_time: 0 s}}
"""


def cruise(road="balance", capacity=160.0, disc=1500, drive=""):
    text = MODEL.format(road=road, capacity=capacity, disc=disc, drive=drive)
    system = compile_model(loads_model(text), "cruise")
    memory = Memory()
    done = run_time(system, sink=memory)
    assert done.status == OK, done.sentence
    rows = np.concatenate(memory.rows)
    return done, lambda name: rows[:, system.layout.channel(name)]


def test_a_clutch_that_sticks_carries_the_load_from_the_start():
    """60 N m at the engine, four times that at the half shafts, and nothing moves against anything else.

    1e-5: what the contact ratio of the gears does at 4e8 N/m is nothing, for their stiffness is constant.
    """
    done, channel = cruise()
    assert not done.notes
    np.testing.assert_allclose(channel("torque[clutch]"), -60.0, rtol=1e-5)
    np.testing.assert_allclose(channel("torque[half_shafts]"), 240.0, rtol=1e-5)
    assert np.abs(channel("slip_speed[clutch]")).max() < 1e-5


def test_a_load_that_is_given_bends_the_bristles_of_a_driven_engine():
    """Nothing else can carry the 200 N m of the road: 50 N m at the clutch, the rest is the drive's.

    The vehicle turns against the engine, so a positive torque brakes it.
    """
    _, channel = cruise(road="200 N m", drive="drive: {engine: {speed: 1500 rpm}},")
    np.testing.assert_allclose(channel("torque[clutch]"), -50.0, rtol=1e-5)


def test_the_balancing_torque_does_what_both_could_do():
    """A driven engine, a road that balances: without a load on the way it balances nothing."""
    _, channel = cruise(drive="drive: {engine: {speed: 1500 rpm}},")
    assert np.abs(channel("torque[clutch]")).max() < 1e-5


def test_a_load_beyond_the_capacity_is_said():
    done, channel = cruise(capacity=40.0)
    assert any("cannot hold its load and begins to slip" in note for note in done.notes)
    assert channel("torque[clutch]")[0] == pytest.approx(-40.0, rel=1e-9)
    assert channel("slip_speed[clutch]")[-1] > 0.1


def test_a_clutch_that_slips_starts_with_the_torque_of_slip():
    _, channel = cruise(disc=500)
    np.testing.assert_allclose(channel("torque[clutch]"), -160.0, rtol=1e-6)


def test_a_sticking_clutch_is_a_spring_of_the_linear_system():
    """Two inertias J with a clutch of stiffness k = capacity/wind_up: omega^2 = 2 k/J, and their response.

    Free of any state, as the bristles do not yield; the open clutch leaves two free rotations.
    """
    from pitchpoint.solvers.frequency_response import find_response
    from pitchpoint.solvers.modal import find_modes

    model = loads_model(
        "bodies:\n"
        "  a: {motion: torsion, inertia: 1 kg m^2, position: [0, 0, 0]}\n"
        "  b: {motion: torsion, inertia: 1 kg m^2, position: [0, 0, 0]}\n"
        "clutches:\n  c: {bodies: [a, b], capacity: 1 kN m, damping_time: 10 us}\n"
        "scenarios:\n"
        "  engaged: {speed: {a: 100 rpm}, engaged: [c], duration: 10 ms}\n"
        "  open: {speed: {a: 100 rpm}, engaged: [], duration: 10 ms}\n"
    )
    system = compile_model(model, "engaged")
    modes = find_modes(system)
    np.testing.assert_allclose(modes.frequency, [0.0, np.sqrt(2e6) / (2.0 * np.pi)], rtol=1e-9)
    assert modes.damping_ratio[1] == pytest.approx(0.5 * 2.0 * 10.0 / np.sqrt(2e6), rel=1e-9)
    assert modes.elements == ("friction clutch c",)
    hertz = np.array([50.0, 150.0, 300.0])
    found = find_response(system, ["a.mz"], ["torque[c]", "b.rz"], hertz).response[:, :, 0]
    w = 2.0 * np.pi * hertz
    k = 1e6 + 10j * w
    b = k / (w**4 - 2.0 * k * w**2)  # of [[k - w^2, -k], [-k, k - w^2]] x = [1, 0]
    np.testing.assert_allclose(found[:, 1], b, rtol=1e-6)
    np.testing.assert_allclose(found[:, 0], w**2 * b, rtol=1e-6)  # torque on a = -(torque on b) = w^2 x_b
    assert np.count_nonzero(find_modes(compile_model(model, "open")).frequency == 0.0) == 2


def test_a_train_beyond_a_sticking_clutch_rotates_with_it():
    """One free rotation of engine and vehicle with the gear ratio, whatever the scale of each train."""
    from pitchpoint.solvers.modal import find_modes

    text = MODEL.format(road="balance", capacity=160.0, disc=1500, drive="")
    first = "  output: {gears: [wheel], motion: torsion, inertia: 0.64 kg m^2"
    text = text.replace(first + "}\n", "").replace(
        "bodies:\n", f"bodies:\n{first}, position: [127.6 mm, 0, 0]}}\n"
    )
    modes = find_modes(compile_model(loads_model(text), "cruise"))
    (rigid,) = np.flatnonzero(modes.frequency == 0.0)
    names = list(modes.coordinates)
    spins = [modes.shape[rigid, names.index(f"{b}.spin")] for b in ("engine", "disc", "output", "vehicle")]
    np.testing.assert_allclose(np.array(spins) / spins[0], [1.0, 1.0, -0.25, -0.25], rtol=1e-9)
