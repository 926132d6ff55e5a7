# SPDX-License-Identifier: Apache-2.0
"""Reduced systems with trees of bodies that stay: carriers, what gives them coordinates, elastic rotors."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.reduction.reduce import reduce_system
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.cli_files import json_of
from tests.support.machines import compiled
from tests.unit.solvers.test_reduction_mechanisms import PENDULUM
from tests.unit.system.test_elastic_rotor_files import pair

HELD = "stiffness: {x: 4e7, y: 5e7, axial: 6e7, rx: 4e5, ry: 5e5, torsion: 6e5}"
SOFT = "stiffness: {x: 1e6, y: 2e6, axial: 3e6, rx: 1e4, ry: 2e4, torsion: 3e4}"
ARM = f"""\
bodies:
  base: {{mass: 50 kg, inertia_tensor: [1, 1.2, 1.1, 0, 0, 0], markers: {{pin: {{position: [100 mm, 0, 0]}}}},
    position: [0, 0, 0]}}
  arm: {{mass: 10 kg, center_of_mass: [100 mm, 0, 0], inertia_tensor: [0.1, 0.2, 0.2, 0, 0, 0],
    position: [100 mm, 0, 0], markers: {{tip: {{position: [200 mm, 0, 0]}}}}}}
  block: {{mass: 0.5 kg, inertia_tensor: [1e-3, 2e-3, 1e-3, 0, 0, 0], position: [300 mm, 0, 0]}}
  wall: {{motion: fixed, position: [300 mm, 0, 0]}}
joints:
  one: {{type: free, bodies: [ground, base]}}
  two: {{type: free, bodies: [ground, block]}}
  hinge: {{type: revolute, bodies: [base.pin, arm], axes: {{z: [0, 0, 1]}}}}
bushings:
  foot: {{ends: [base, ground], {SOFT}}}
  seat: {{ends: [arm.tip, block], {HELD}}}
  held: {{ends: [block, wall], {HELD}}}
scenarios: {{rest: {{duration: 1 ms, step: 1 us}}}}
"""
"""An arm on a base, and a light block between its tip and a wall."""

BESIDE = """\
  motor: {motion: torsion, inertia: 0.01 kg m^2, position: [0, 0, -100 mm]}
  fan: {motion: torsion, inertia: 1e-5 kg m^2, position: [0, 0, -200 mm]}
  casing: {mass: 30 kg, inertia_tensor: [0.3, 0.4, 0.3, 0, 0, 0], position: [0, 0, 180 mm],
    markers: {seat: {}, side: {position: [300 mm, 0, -180 mm]}}}
  bracket: {mass: 2 kg, inertia_tensor: [1e-3, 2e-3, 1.5e-3, 0, 0, 0], position: [300 mm, 0, 0]}
  floor: {motion: fixed, position: [0, 0, 180 mm]}
"""
TIES = """\
couplings:
  a: {bodies: [motor, journal_1], stiffness: {torsion: 1e5 N m/rad}}
  b: {bodies: [fan, motor], stiffness: {torsion: 1e5 N m/rad}}
bushings:
  foot: {ends: [casing, floor], HELD}
  side: {ends: [casing.side, bracket], HELD}
""".replace("HELD", "stiffness: {radial: 1e8 N/m, axial: 1e8 N/m, tilt: 1e6, torsion: 1e6}")


@pytest.fixture(scope="module")
def arm():
    return reduce_system(compiled(ARM, "rest")[1], "rest", limit=150.0, keep=("arm",))


def test_what_carries_the_end_of_a_condensed_bushing_feels_it(arm):
    """Only the arm is asked for; its base moves the tip too. The block lies above 2 kHz: static shapes alone.

    Statics of what stays are exact in Craig and Bampton's method: 1e-9 for rounding of a matrix of condition
    1e5. Frequencies to 1e-3, that of the wish of the reduction.
    """
    assert arm.kept == ("base", "arm")
    assert arm.reasons == ("carries arm", "requested")
    assert arm.error.coordinates == (13, 7)
    full = evaluate.matrix(arm.full, arm.full_state, 0.0, 0.0, 1.0)
    less = evaluate.matrix(arm.system, arm.state, 0.0, 0.0, 1.0)
    flexible = np.linalg.inv(full)[:7, :7]
    assert np.abs(np.linalg.inv(less) - flexible).max() < 1e-9 * np.abs(flexible).max()
    one = find_modes(arm.full, start=arm.full_state).frequency
    two = find_modes(arm.system, start=arm.state).frequency
    low = one < 150.0
    assert low.sum() >= 3
    assert two[: low.sum()] == pytest.approx(one[low], rel=1e-3)
    assert arm.error.frequency < 1e-3


FREE = """\
joints:
  fly: {type: free, bodies: [ground, casing]}
  hang: {type: free, bodies: [ground, bracket]}
"""


@pytest.fixture(scope="module")
def rotors(tmp_path_factory):
    """Shafts of finite elements in a casing, driven through a motor, with a fan behind it."""

    def change(text):
        if "elastic_bodies" not in text:
            return text
        text = text.replace("bodies:\n  pinion_body", "bodies:\n" + BESIDE + "  pinion_body")
        text = text.replace("{body: journal_2, ", "{body: journal_2, housing: casing.seat, ")
        return text.replace("joints:\n", FREE) + TIES

    folder = tmp_path_factory.mktemp("rotors")
    return folder / "elastic.yaml", pair(folder, "1 m", change)[1]


@pytest.mark.parametrize("scenario", ["still", "turning"])
def test_elastic_rotors_stay_and_the_rest_is_condensed(rotors, scenario):
    """Eigenvalues at speed of both systems agree as far as the frequencies of the error say (4e-6), those of
    the gears in their rotating modes among them."""
    system = compile_model(rotors[1], scenario)
    reduced = reduce_system(system, scenario, limit=300.0)
    gone = set(system.layout.bodies[1:]) - set(reduced.kept)
    assert gone == {"bracket", "fan", "floor"}  # the floor has no coordinates
    why = dict(zip(reduced.kept, reduced.reasons, strict=True))
    assert why["input"] == why["input.1"] == "elastic body input"
    assert why["pinion_body"] == "mounted on elastic body input"
    assert why["casing"] == "carries right.housing"
    assert any(
        "elastic rotors are kept" in n and "input, output" in n and "right" in n for n in reduced.notes
    )
    assert reduced.error.frequency < 1e-4
    assert reduced.error.compliance < 1e-4
    one = find_modes(system, scenario, mean=False).eigenvalue
    two = find_modes(reduced.system, start=reduced.state, mean=False).eigenvalue
    size = np.abs(one[1:10])
    assert np.abs(two[1:10] - one[1:10]).max() < 2e-5 * size.max()


def test_a_turning_rotor_runs_the_same_reduced(rotors):
    """A tenth of a turn and more: the mesh force differs by 1e-3 of it, as frequencies may."""
    system = compile_model(rotors[1], "turning")
    reduced = reduce_system(system, "turning", limit=3000.0)
    found = []
    for own, state in ((reduced.full, reduced.full_state), (reduced.system, reduced.state)):
        run = generalized_alpha.start(own, state, 1e-5)
        channel = own.layout.channel("mesh_force[stage]")
        rows = []
        for _ in range(40):
            run.advance(10)
            rows.append(evaluate.observe(own, run.state())[channel])
        found.append(np.array(rows))
    assert np.abs(found[1] - found[0]).max() < 1e-3 * np.abs(found[0]).max()


def test_people_are_told_why(rotors, capsys):
    found = json_of(["reduce", str(rotors[0]), "--limit", "300 Hz"], capsys)
    assert len(found["kept"]) == len(found["reasons"])
    assert run_command(["reduce", str(rotors[0]), "--limit", "300 Hz"]) == 0
    out = " ".join(capsys.readouterr().out.split())
    assert "input: elastic body input" in out
    assert "casing: carries right.housing" in out
    assert "input.seat" not in out


@pytest.mark.parametrize("motion", ["torsion", "free"])
def test_modes_of_what_is_not_round_say_that_they_hold_for_one_position(motion):
    """A pendulum on a driver that only turns sees the same at all times, on one that moves sideways not."""
    text = PENDULUM.replace("MOTION", f"motion: {motion}").replace("LOAD", "50")
    if motion == "free":
        text += (
            "bearings:\n  b: {body: driver, stiffness: {radial: 1e8, axial: 1e8, tilt: 1e6}}\n"
            "springs:\n  s: {ends: [driver, arm], stiffness: 1e4 N/m}\n"
        )
    notes = find_modes(compiled(text, "run")[1], "run").notes
    told = any("inertia of arm changes as it rotates" in note for note in notes)
    assert told is (motion == "free"), notes
