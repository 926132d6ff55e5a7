# SPDX-License-Identifier: Apache-2.0
"""Bodies that turn with another one, and bearings in housings that move: starts and steps count them."""

from __future__ import annotations

import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.gear_trains import held_spins
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.solvers.step_modes import counted_frequency
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.unit.solvers.test_controls_from_files import DRIVE, ERROR, PAIR, PI
from tests.unit.solvers.test_sticking import MODEL

ROCKER = """\
bodies:
  shaft: {motion: free, mass: 2 kg, inertia: 3e-3, transverse_inertia: 5e-3, position: [0.3, 0, 0]}
  rocker:
    mass: 5 kg
    inertia_tensor: [0.02, 0.03, 0.04, 0, 0, 0]
    position: [0, 0, 0]
    markers: {eye: {position: [300 mm, 0, 0]}}
joints:
  pivot: {type: revolute, bodies: [ground, rocker]}
bearings:
  a: {body: shaft, position: [0, 0, -0.1], stiffness: {radial: 1e7, axial: 1e7, tilt: 1e4}}
  b: {body: shaft, position: [0, 0, 0.1], stiffness: {radial: 1e7, axial: 1e7, tilt: 1e4}}
"""
IN_HOUSING = "  eye: {body: shaft, housing: rocker.eye, stiffness: {radial: 2e7 N/m, axial: 3e7 N/m}}\n"
END = """\
loads:
  push: {body: rocker, torque: 30 N m}
scenarios: {still: {duration: 1 ms, step: 1 us, settle_time: 0 s}}
"""


def begun(text, scenario):
    model = loads_model(text)
    system = compile_model(model, scenario)
    return system, prepare_start(system, model.scenarios[scenario])


def seen(start):
    row = evaluate.observe(start.system, start.state)
    return dict(zip((c.name for c in start.system.layout.channels), row, strict=True))


def test_a_rocker_is_held_through_the_bearing_in_its_eye():
    # 100 N at 0.3 m on two bearings of 1e7 N/m and the one of 2e7: (100/2e7 + 100/2e7)/0.3 rad
    system, start = begun(ROCKER + IN_HOUSING + END, "still")
    assert [system.layout.coordinates[k] for k in held_spins(system)] == ["shaft.spin"]
    angle = start.state.q[system.layout.coordinate("rocker.spin")]
    assert angle == pytest.approx(1e-5 / 0.3, rel=1e-5)
    assert start.notes == ()


def test_a_bearing_in_a_housing_is_called_a_bearing():
    # names of modal energies, such as "coupling flange" between two bodies
    more = "couplings:\n  flange: {bodies: [shaft, fan], stiffness: {torsion: 1e4}}\n"
    fan = "  fan: {motion: torsion, inertia: 0.01, position: [0.3, 0, 0.2]}\n"
    text = (ROCKER + IN_HOUSING + more + END).replace("joints:", fan + "joints:")
    found = find_modes(compile_model(loads_model(text))).elements
    assert {"bearing eye", "bearing a", "coupling flange"} <= set(found)
    assert "coupling eye" not in found


def test_a_bearing_on_a_shaft_without_marker_has_a_station_of_its_own():
    text = """\
shafts:
  outer: {sections: [{length: 400 mm, diameter: 60 mm, bore: 40 mm}], position: [0, 0, 0], markers: MARKERS}
bodies:
  pin: {motion: free, mass: 1 kg, inertia: 1e-3, transverse_inertia: 1e-3, position: [0, 0, 0.15]}
bearings:
  left: {body: outer, position: [0, 0, 0], stiffness: {radial: 1e9, axial: 1e9}}
  right: {body: outer, position: [0, 0, 0.4], stiffness: {radial: 1e9}}
  middle: {body: pin, housing: OUTER, stiffness: {radial: 1e7, axial: 1e7, tilt: 1e4}}
loads: {weight: {body: pin, force: [1 kN, 0 N, 0 N]}}
scenarios: {still: {duration: 1 ms, step: 1 us, settle_time: 0 s}}
"""
    found = []
    for markers, place in (("{}", "outer"), ("{seat: {position: [0, 0, 150 mm]}}", "outer.seat")):
        system, start = begun(text.replace("MARKERS", markers).replace("OUTER", place), "still")
        found.append(start.state.q[system.layout.coordinate("pin.x")])
    assert found[0] == pytest.approx(found[1], rel=1e-9)


def test_a_balancing_load_on_a_flange_lets_the_clutch_carry_its_share():
    plain = MODEL.format(road="balance", capacity=160.0, disc=1500, drive="")
    flange = "  flange: {mass: 0 kg, position: [127.6 mm, 0, 400 mm]}\njoints:\n"
    flange += "  bolts: {type: fixed, bodies: [vehicle, flange]}\nclutches:"
    fixed = plain.replace("clutches:", flange).replace("road: {body: vehicle", "road: {body: flange")
    one, two = (seen(begun(text, "cruise")[1]) for text in (plain, fixed))
    for name in ("torque[road]", "torque[clutch]"):
        assert abs(one[name]) > 1.0
        assert two[name] == pytest.approx(one[name], rel=1e-6)


def test_a_torque_on_a_disc_that_is_fixed_to_a_shaft_sets_the_step():
    text = """\
shafts:
  s:
    sections: [{length: 600 mm, diameter: 30 mm}]
    position: [0, 0, 0]
    markers: {far: {position: [0, 0, 600 mm]}}
bodies:
  disc: {mass: 5 kg, inertia: 0.02, transverse_inertia: 0.01, position: [0, 0, 600 mm]}
joints: {seat: {type: fixed, bodies: [s.far, disc]}}
bearings:
  left: {body: s, position: [0, 0, 0], stiffness: {radial: 1e8, axial: 1e8}}
  right: {body: s, position: [0, 0, 0.5], stiffness: {radial: 1e8}}
loads: {motor: {body: BODY, torque: 10 N m * cos(100*t)}}
scenarios: {go: {duration: 1 s}}
"""
    on_shaft = "s, position: [0, 0, 600 mm]"
    found = [counted_frequency(begun(text.replace("BODY", body), "go")[1]) for body in (on_shaft, "disc")]
    assert found[0] > 10.0
    assert found[1] == pytest.approx(found[0], rel=1e-6)


def test_an_observed_speed_is_none_on_a_slow_roll():
    sensor = "{type: joint, coordinate: motor, derivative: 1}"
    text = PAIR + ERROR + PI % "" + DRIVE
    assert sensor in text
    system = compile_model(
        loads_model(text.replace(sensor, "{type: observation, channel: 'speed[motor]'}")), "roll"
    )
    with pytest.raises(SolverError, match=r"depends on signal\[speed\]"):
        roll_through(system, "roll")
