# SPDX-License-Identifier: Apache-2.0
"""A machine may stand along any axis of the world: turned as a whole, it does the same.

The oracle is the machine as it stands along z. What differs is round-off: places of some 0.1 m are rounded to
1e-17 m, and forces are stiffnesses times differences of them, 1e-8 N beside 1e3 N, which grows over a run
(1e-7). An equilibrium leaves 1e-9 of the largest load over, which soft directions turn into 1e-6 of a force;
what is reckoned there agrees to 1e-5.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.contact.stiffness.description import PairShape
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.campbell import follow_modes
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.frequency_response import find_response
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.solvers.reduction.reduce import reduce_system
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from pitchpoint.system.rules.mesh_laws import MeshLaws
from tests.support.one_bevel import OneBevel, make_bevels
from tests.support.one_mesh import OneMesh, make_pair
from tests.support.turned_world import about, turned

EXAMPLES = Path(__file__).parents[2] / "examples"
REST = 1e-5
"""Share up to which what is reckoned at an equilibrium agrees."""
DIAGRAM = 1e-8
"""Share of the highest frequency up to which diagrams agree: where bodies stand across the axes of the world,
every speed has an equilibrium of its own, found to 1e-9 of the loads (seen: 1e-10)."""
NOTHING = 1e-12
"""What is less in SI units is round-off of zero."""
ALONG_X = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
TILTED = about([1.0, -2.0, 0.5], 1.1)
NEARLY = about([0.0, 1.0, 0.0], np.radians(5.0))
SUPPORTS = """\
bearings:
  one: {body: driver, position: [0, 0, -30 mm], stiffness: {x: 2e8, y: 1e8, axial: 1e8, tilt: 1e5},
      damping: {radial: 800}}
  two: {body: driven, position: [0, 0, 20 mm], stiffness: {radial: 2e8, axial: 2e8, tilt: 2e5},
      damping: {ratio: 0.02}}
loads:
  input: {body: driver, torque: 200 N m}
  output: {body: driven, torque: balance}
  pull: {body: driven, force: [300 N, -200 N, 500 N], position: [10 mm, 5 mm, 25 mm]}
gravity: [0.5, -9.81 m/s^2, 1]
scenarios:
  run: {speed: {driver: 1500 rpm}, duration: 1 ms, step: 2 us, settle_time: 0 s, start: assembled}
  roll: {quasi_static: {mesh: stage, points: 8}}
  steady: {speed: {driver: 1500 rpm}, duration: 1 ms}
"""
INERTIA = "inertia: 0.002 kg m^2, mass: 2 kg, transverse_inertia: 0.0015 kg m^2"


def pair(more="", less="", kind="", second=45, rest=""):
    """Two gears on bearings, the driven one beside its axes of the world."""
    teeth = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    return (
        f"gears:\n  g1: {{number_of_teeth: 30, {teeth}{more}}}\n"
        f"  g2: {{number_of_teeth: {second}, {teeth}{less}{kind}}}\n"
        f"bodies:\n  driver: {{gears: [g1], motion: free, {INERTIA}, center_of_mass: 2 mm}}\n"
        f"  driven: {{gears: {{g2: 3 mm}}, motion: free, {INERTIA}}}\n"
        "meshes:\n  stage: {gears: [g1, g2], direction: 25 deg, backlash: {base_tangent: 0.1 mm}, "
        "stiffness: {law: din3990}, damping: {ratio: 0.05}, friction: {mu: 0.05}}\n" + SUPPORTS + rest
    )


HELICAL = (", helix_angle: 15 deg, hand: right", ", helix_angle: 15 deg, hand: left")
PLANETS = """\
title: planetary set
gears:
  sun: {number_of_teeth: 21, normal_module: 4 mm, face_width: 40 mm, profile_shift_coefficient: 0}
  p1: {number_of_teeth: 39, normal_module: 4 mm, face_width: 40 mm, profile_shift_coefficient: 0}
  p2: {number_of_teeth: 39, normal_module: 4 mm, face_width: 40 mm, profile_shift_coefficient: 0}
  ring: {number_of_teeth: 99, type: internal, normal_module: 4 mm, face_width: 40 mm,
      profile_shift_coefficient: 0}
bodies:
  sun: {gears: [sun], motion: planar, position: [0, 0, 0]}
  carrier: {inertia: 0.5 kg m^2, transverse_inertia: 0.3 kg m^2, mass: 10 kg, position: [0, 0, 0],
      motion: free}
  planet1: {gears: [p1], position: [112.763114494 mm, 41.042417199 mm, 0]}
  planet2: {gears: [p2], position: [-112.763114494 mm, -41.042417199 mm, 0]}
  ring: {gears: [ring], motion: fixed, position: [0, 0, 0]}
joints:
  pin1: {type: revolute, bodies: [carrier, planet1]}
  pin2: {type: revolute, bodies: [carrier, planet2]}
bearings:
  main: {body: carrier, position: [0, 0, 50 mm], stiffness: {radial: 2e8, axial: 2e8, tilt: 1e6},
      damping: {ratio: 0.02}}
  input: {body: sun, stiffness: {radial: 1e7}, damping: {ratio: 0.02}}
meshes:
  s1: {gears: [sun, p1], stiffness: {law: din3990}, damper: {ratio: 0.05}, backlash: {base_tangent: 0.05 mm}}
  s2: {gears: [sun, p2], stiffness: {law: din3990}, damper: {ratio: 0.05}, backlash: {base_tangent: 0.05 mm}}
  r1: {gears: [p1, ring], stiffness: {law: din3990}, damper: {ratio: 0.05}, backlash: {base_tangent: 0.05 mm}}
  r2: {gears: [p2, ring], stiffness: {law: din3990}, damper: {ratio: 0.05}, backlash: {base_tangent: 0.05 mm}}
loads:
  in: {body: sun, torque: 100 N m}
  out: {body: carrier, torque: balance}
scenarios:
  run: {speed: {sun: 1000 rpm}, duration: 1 ms, step: 5 us, settle_time: 0 s, start: assembled}
  roll: {quasi_static: {mesh: s1, points: 6}}
  steady: {speed: {sun: 1000 rpm}, duration: 1 ms}
"""
SHAFTS = """\
gears:
  pinion: {number_of_teeth: 25, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0,
      helix_angle: 12 deg, hand: left}
  wheel: {number_of_teeth: 40, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0,
      helix_angle: 12 deg, hand: right}
  second: {number_of_teeth: 20, normal_module: 4 mm, face_width: 30 mm, profile_shift_coefficient: 0}
  last: {number_of_teeth: 50, normal_module: 4 mm, face_width: 40 mm, profile_shift_coefficient: 0}
shafts:
  input: {sections: [{length: 60 mm, diameter: 40 mm}, {length: 120 mm, diameter: 50 mm, bore: 10 mm}],
      gears: {pinion: 100 mm},
    position: [10 mm, 20 mm, -30 mm], markers: {end: {position: [0, 0, 180 mm]}}}
  middle: {sections: [{length: 180 mm, diameter: 50 mm}], gears: {wheel: 50 mm, second: 120 mm},
      internal_damping: 1 us}
bodies:
  output: {gears: {last: 10 mm}, motion: free}
  lever: {mass: 1 kg, center_of_mass: [0, 30 mm, 0], inertia_tensor: [1e-3, 2e-3, 2e-3, 1e-4, 0, 0]}
joints: {seat: {type: fixed, bodies: [input.end, lever]}}
bearings:
  left: {body: input, position: [0, 0, 20 mm], stiffness: {radial: 2e8 N/m, axial: 1e8 N/m},
      damping: {radial: 900, axial: 900}}
  right: {body: input, position: [0, 0, 170 mm], stiffness: {radial: 2e8 N/m}, damping: {radial: 900}}
  near: {body: middle, position: [0, 0, 20 mm], stiffness: {radial: 2e8 N/m, axial: 1e8 N/m},
      damping: {radial: 900, axial: 900}}
  far: {body: middle, position: [0, 0, 170 mm], stiffness: {radial: 2e8 N/m}, damping: {radial: 900}}
  out: {body: output, stiffness: {radial: 2e8 N/m, axial: 1e8, tilt: 1e6}, damping: {ratio: 0.03}}
meshes:
  stage: {gears: [pinion, wheel], stiffness: {law: din3990}, damping: {ratio: 0.05}}
  next: {gears: [second, last], direction: -50 deg, stiffness: {law: din3990}, damping: {ratio: 0.05}}
loads:
  motor: {body: input, torque: 100 N m}
  brake: {body: output, torque: balance}
  side: {body: middle, force: [400 N, 100 N, 200 N], position: [0, 0, 80 mm]}
scenarios:
  run: {speed: {input: 1500 rpm}, duration: 0.4 ms, step: 1 us, settle_time: 0 s, start: assembled}
  roll: {quasi_static: {mesh: stage, points: 4}}
  steady: {speed: {input: 1500 rpm}, duration: 1 ms}
"""
ROTOR = (
    (EXAMPLES / "geared-rotor" / "model.yaml")
    .read_text()
    .replace("duration: 0.5 s", "duration: 2.5 ms, start: assembled")
)
MACHINES = {
    "spur": pair(),
    "helical": pair(*HELICAL),
    "eccentric": pair(rest="unbalances: {crumb: {body: driver, mass: 20 g, position: [30 mm, 0, 10 mm]}}\n"),
    "internal": pair(HELICAL[0], HELICAL[0], ", type: internal", second=80),
    "planets": PLANETS,
    "shafts": SHAFTS,
    "rotor": ROTOR
    + """  roll: {quasi_static: {mesh: stage, points: 4}}
  steady: {speed: {rotor: 4500 rpm}, duration: 1 ms}
""",
}


STEADY = [name for name in MACHINES if name != "eccentric"]  # its weight and the motor know no rest


def both(name, R, scenario="steady"):
    """A machine as it stands and turned, compiled."""
    model = loads_model(MACHINES[name])
    other = turned(model, R)
    return [compile_model(m, scenario) for m in (model, other)]


def same(found, expected, size=None, share=REST):
    """Equal up to a share of the size of what is compared."""
    found, expected = np.asarray(found), np.asarray(expected)
    size = max(np.abs(expected).max(initial=0.0), NOTHING) if size is None else size
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=share * size)


def channels_agree(system, found, expected, share):
    """Rows of observations, each against the largest value of its kind."""
    kinds = [c.name.split("[")[0] + c.unit for c in system.layout.channels]
    found, expected = directions_compared(system, found, np.asarray(expected))
    for kind in dict.fromkeys(kinds):
        columns = [k for k, other in enumerate(kinds) if other == kind]
        same(found[..., columns], expected[..., columns], share=share)


def directions_compared(system, found, expected):
    """Differences of directions within half a turn, weighted with the force: a small force has none."""
    names = [c.name for c in system.layout.channels]
    radial = {n: k for k, n in enumerate(names) if n.endswith(".radial]")}
    largest = max((np.abs(expected[..., k]).max() for k in radial.values()), default=0.0)
    found = found.copy()
    for k, name in enumerate(names):
        if name.endswith(".direction]"):
            force = expected[..., radial[name.replace(".direction]", ".radial]")]]
            turned = (found[..., k] - expected[..., k] + np.pi) % (2.0 * np.pi) - np.pi
            found[..., k] = expected[..., k] + turned * force / (largest or 1.0)
    return found, expected


ROTATIONS = {"x": ALONG_X, "tilted": TILTED, "nearly": NEARLY}
RUNS = {"rotor": "fast"}
FIRST = {"planets": "sun", "shafts": "input", "rotor": "rotor"}
"""Body whose speed counts in a diagram, where it is not the driver."""


@pytest.mark.parametrize(
    ("name", "R"),
    [*((name, "tilted") for name in MACHINES), ("spur", "nearly"), ("helical", "x"), ("shafts", "x")],
)
def test_runs(name, R):
    one, two = both(name, ROTATIONS[R], RUNS.get(name, "run"))
    names = [c.name for c in one.layout.channels]
    assert names == [c.name for c in two.layout.channels]
    rows = [np.stack([run[n].values for n in names], axis=-1) for run in map(solve_time, (one, two))]
    channels_agree(one, rows[1], rows[0], 1e-7)


@pytest.mark.parametrize("name", STEADY)
def test_statics(name):
    one, two = both(name, TILTED)
    names = [c.name for c in one.layout.channels]
    rows = [np.array([rest[n].item() for n in names]) for rest in map(solve_equilibrium, (one, two))]
    channels_agree(one, rows[1], rows[0], REST)


@pytest.mark.parametrize("name", STEADY)
def test_modes(name):
    one, two = (find_modes(s) for s in both(name, TILTED))
    assert [n for n in one.names if "rigid" in n] == [n for n in two.names if "rigid" in n]
    same(two.frequency, one.frequency)
    swings = one.frequency > 1.0
    same(two.damping_ratio[swings], one.damping_ratio[swings])
    # shapes of equal frequencies mix, so what counts is the sum over all modes: the mass that can move
    total = one.effective_mass.sum(axis=0)
    blocks = [m.participation.T @ m.participation for m in (one, two)]
    turn = np.kron(np.eye(2), TILTED)
    same(turn.T @ blocks[1] @ turn, blocks[0])
    assert total[:3].max() > 0.0
    apart = np.flatnonzero(np.diff(one.frequency, prepend=-1.0, append=1e9)[:-1] > 1.0)
    apart = [k for k in apart if k + 1 == len(one.frequency) or one.frequency[k + 1] - one.frequency[k] > 1.0]
    assert len(apart) > 2
    for k in apart:
        shapes = one.body_shape[k], (two.body_shape[k].reshape(-1, 2, 3) @ TILTED).reshape(-1, 6)
        sign = np.sign(np.sum(shapes[0] * shapes[1]))
        same(sign * shapes[1], shapes[0])
        if name not in ("planets", "rotor"):  # of equal shares round-off names one first
            assert one.names[k] == two.names[k]


@pytest.mark.parametrize("name", STEADY)
def test_rolls(name):
    one, two = both(name, TILTED)
    rolls = [roll_through(s, "roll") for s in (one, two)]
    assert rolls[0].status == rolls[1].status == 1
    channels_agree(one, rolls[1].rows, rolls[0].rows, REST)
    for mesh in rolls[0].meshes:
        same(rolls[1].meshes[mesh].unloaded, rolls[0].meshes[mesh].unloaded, 1e-6)
        same(rolls[1].meshes[mesh].tangent_stiffness, rolls[0].meshes[mesh].tangent_stiffness)


@pytest.mark.parametrize("name", ["shafts", "rotor"])
def test_reductions(name):
    reduced = [reduce_system(s, limit=3000.0) for s in both(name, TILTED)]
    one, two = (find_modes(r.system, start=r.state).frequency for r in reduced)
    same(two[two < 3000.0], one[one < 3000.0])


@pytest.mark.parametrize("name", STEADY)
def test_campbell_diagrams(name):
    body = FIRST.get(name, "driver")
    speeds = np.array([0.0, 100.0, 600.0])
    one, two = (follow_modes(s, speeds, body) for s in both(name, TILTED))
    same(np.sort(two.frequency, axis=1), np.sort(one.frequency, axis=1), share=DIAGRAM)


@pytest.mark.parametrize("R", ["original", "tilted"])
def test_a_diagram_passes_through_the_modes_of_its_scenario(R):
    """With friction: it presses the flanks at rest elsewhere than the matrices of other speeds know."""
    system = both("spur", TILTED)[R == "tilted"]
    speed = 1500.0 * np.pi / 30.0
    at_speed = follow_modes(system, [speed], "driver").frequency[0]
    same(np.sort(at_speed), np.sort(find_modes(system).damped_frequency), share=DIAGRAM)


@pytest.mark.parametrize("name", STEADY)
def test_frequency_responses(name):
    body = FIRST.get(name, "driver")
    mesh = "s1" if name == "planets" else "stage"
    inputs, outputs = [f"transmission_error[{mesh}]", f"{body}.spin"], [f"mesh_force[{mesh}]", f"{body}.spin"]
    one, two = (find_response(s, inputs, outputs, [50.0, 700.0]) for s in both(name, TILTED))
    for k in range(2):
        # slopes of channels are differences over 2e-10 m of places that are rounded to 1e-16 m (seen: 5e-6)
        same(two.response[:, k], one.response[:, k])


@pytest.mark.nojit
@pytest.mark.parametrize("pair", [dict(beta=0.2), dict(beta=0.2, z2=70, internal=True)])
@pytest.mark.parametrize("lag", [0.0, 2e-3])
def test_a_machine_may_turn_any_number_of_times_under_frames_that_do_not(pair, lag):
    """Gears carried round by a housing that their frames do not hang on: the oracle is the machine at rest.

    The line of centres turns past the range of an arc tangent. `lag` is a turn of one frame against the
    other, which leaves an instant where the line has passed half a turn for one frame alone.
    """
    m = OneMesh(make_pair(**pair), MeshLaws(stiffness=PairShape(c_prime=14e9, S_R=0.8, T_R=0.3)), n_pair=4)
    m.frames["R"][1] = about([0.0, 0.0, 1.0], lag) @ np.eye(3)
    m.press(8e-6)
    m.frames["tw"][:, 5] = m.frames["spin"] = 30.0, -12.0
    still, size = m.evaluate(), 0.0
    seen = m.out.copy()
    for angle in np.concatenate([np.linspace(0.1, 13.0, 40), np.pi + np.linspace(-3e-3, 3e-3, 13), [-7.0]]):
        frames, Q = m.frames.copy(), about([0.0, 0.0, 1.0], angle)
        frames["r"] = m.frames["r"] @ Q.T
        whole = round(angle / (2.0 * np.pi))
        frames["phi"] += angle - 2.0 * np.pi * whole
        frames["turns"] += whole
        F = m.evaluate(frames).reshape(-1, 3) @ Q
        size = max(size, abs(F.ravel() - still.ravel()).max())
        assert np.allclose(m.out, seen, rtol=1e-6, atol=1e-9 * abs(seen).max()), angle
    assert size < 1e-6 * abs(still).max()


@pytest.mark.nojit
def test_a_bevel_gear_may_go_any_number_of_times_round_another_whose_frame_does_not_turn():
    """The oracle is the pair at rest; the pitch ray turns past the range of an arc tangent for one frame."""
    m = OneBevel(make_bevels(), MeshLaws(stiffness=PairShape(c_prime=14e9, S_R=0.8, T_R=0.3)))
    m.press(8e-6)
    still = m.evaluate()
    seen, axis, apex = m.out.copy(), m.frames["R"][0][:, 2], np.array(m.at)
    for angle in np.linspace(-7.0, 13.0, 60):
        frames, Q = m.frames.copy(), about(axis, angle)
        frames["r"] = apex + (m.frames["r"] - apex) @ Q.T
        frames["R"][1] = Q @ m.frames["R"][1]
        whole = round(angle / (2.0 * np.pi))
        frames["phi"][0] += angle - 2.0 * np.pi * whole
        frames["turns"][0] += whole
        F = m.evaluate(frames).reshape(-1, 3) @ Q
        assert np.allclose(F.ravel(), still.ravel(), rtol=0.0, atol=1e-6 * abs(still).max()), angle
        assert np.allclose(m.out[:15], seen[:15], rtol=1e-6, atol=1e-9 * abs(seen).max()), angle
