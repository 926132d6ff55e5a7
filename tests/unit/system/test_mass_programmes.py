# SPDX-License-Identifier: Apache-2.0
"""The short programmes of the mass matrix: same accelerations, used where no mass couples two bodies."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.mass_programmes import mass_programmes
from pitchpoint.system.system import State, System

SHAFTS = """\
gears:
  a: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  b: {number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  one: {gears: {a: 10 mm}, motion: free}
  two: {gears: {b: 10 mm}, motion: free}
  three: {inertia: 0.1 kg m^2, mass: 2 kg, motion: planar, position: [300 mm, 0, 0]}
bearings:
  one: {body: one, stiffness: {radial: 1e8, axial: 1e7, tilt: 1e5}, damping: {radial: 100}}
  two: {body: two, stiffness: {radial: 1e8, axial: 1e7, tilt: 1e5}}
  three: {body: three, stiffness: {radial: 1e8}}
couplings:
  soft: {bodies: [two, three], stiffness: {torsion: 1e4 N m/rad}}
meshes:
  stage: {gears: [a, b], stiffness: {law: constant, value: 3e8 N/m}}
loads: {motor: {body: one, torque: 20 N m}}
scenarios:
  free: {speed: {one: 100 rad/s}, duration: 1 ms}
  driven: {drive: {one: {speed: 100 rad/s}}, duration: 1 ms}
"""
UNBALANCE = "unbalances: {two: {body: two, mass: 20 g, position: [30 mm, 0, 5 mm]}}\n"


def accelerations(system: System, state: State) -> np.ndarray:
    evaluate.prepare(system)
    evaluate.load(system, state)
    assert evaluate.accelerations(system, 0.0) == OK
    return np.concatenate([system.workspace.a, system.workspace.lam])


def shaken(system: System) -> State:
    """A state with deflections of micrometres and tilts of milliradians."""
    state = system.initial_state()
    rng = np.random.default_rng(4)
    state.q += 1e-5 * rng.normal(size=state.q.size)
    state.v += 1e-2 * rng.normal(size=state.v.size)
    return state


@pytest.mark.parametrize("scenario", ["free", "driven"])
@pytest.mark.parametrize("more", ["", UNBALANCE])
def test_accelerations_are_those_of_the_whole_matrix(scenario: str, more: str) -> None:
    system = compile_model(loads_model(SHAFTS + more), scenario)
    short = mass_programmes(system.program, system.records)
    assert len(short["mass_factor"]) == len(system.layout.node_size) < len(system.program["factor"])
    found = accelerations(system, shaken(system))
    whole = system.copy()
    for name in ("proj", "factor", "solve"):  # the same workspace with the programmes of the whole matrix
        whole.workspace.mach[0][f"mass_{name}"] = whole.workspace.mach[0][name]
        whole.workspace.mach[0][f"nmass_{name}"] = whole.workspace.mach[0][f"n{name}"]
    wanted = accelerations(whole, shaken(whole))
    # the blocks are well scaled against each other, so rounding is all that may differ
    np.testing.assert_allclose(found, wanted, rtol=1e-9, atol=1e-9 * np.abs(wanted).max())


def test_masses_between_bodies_keep_the_whole_matrix() -> None:
    text = SHAFTS.replace(
        "bearings:\n", "beams:\n  bar: {ends: [one, two], section: {diameter: 20 mm}}\nbearings:\n"
    )
    text = text.replace("ends: [one, two]", "ends: [two, ground]")
    system = compile_model(loads_model(text), "free")
    assert mass_programmes(system.program, system.records)["mass_factor"] is system.program["factor"]


SEEN = """\
sensors:
  far: {type: frames, quantity: acceleration, ends: [two, ground], axis: y}
  heard: {type: observation, channel: "mesh_force[stage]"}
"""


def test_sensors_that_nobody_reads_are_seen_in_results_and_change_nothing() -> None:
    """The observed acceleration is that of the coordinate: two is free, so its y is the world's y."""
    from pitchpoint.solvers.time import run_time
    from pitchpoint.solvers.time_summary import Memory

    runs = {}
    for name, text in (("bare", SHAFTS), ("seen", SHAFTS + SEEN)):
        system = compile_model(
            loads_model(text.replace("duration: 1 ms", "duration: 1 ms, method: rk4, step: 2 us")), "free"
        )
        memory = Memory()
        assert run_time(system, sink=memory).status == OK
        names = [c.name for c in system.layout.channels]
        runs[name] = names, np.concatenate(memory.rows), np.concatenate(memory.times)
    names, rows, t = runs["seen"]
    bare, plain, _ = runs["bare"]
    # a sensed body has frames of its own, which are rounded otherwise: 500 steps of a smooth motion
    size = np.abs(plain).max(axis=0)
    apart = np.abs(rows[:, [names.index(n) for n in bare]] - plain).max(axis=0)
    assert np.all((apart <= 1e-6 * size) | (size < 1e-9))
    np.testing.assert_array_equal(
        rows[:, names.index("signal[heard]")], rows[:, names.index("mesh_force[stage]")]
    )
    y = rows[:, names.index("displacement[two.y]")]
    seen = rows[:, names.index("signal[far]")]
    h = t[1] - t[0]
    second = (y[2:] - 2.0 * y[1:-1] + y[:-2]) / h**2
    # second differences err by h^2/12 of the fourth derivative: at 20 kHz and 2 us half a per cent
    assert np.abs(second - seen[1:-1]).max() < 0.01 * np.abs(seen).max()
