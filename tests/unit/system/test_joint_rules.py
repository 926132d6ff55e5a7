# SPDX-License-Identifier: Apache-2.0
"""Ratios, functions and drives of joint coordinates, and gears on bodies that joints carry."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.solvers.constraints.assembly import assemble_state
from pitchpoint.solvers.kinematics import moved_to
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.mechanism_files import SLIDER_CRANK, accelerations

RACK = """\
bodies:
  pinion: {inertia: 0.02 kg m^2, mass: 1 kg}
  rack: {mass: 3 kg}
joints:
  pivot: {type: revolute, bodies: [ground, pinion], position: [0, 0, 0], start: {spin: 10 deg}}
  slide: {type: prismatic, bodies: [ground, rack], position: [0, 30 mm, 0], axes: {z: [1, 0, 0]}}
ratios:
  teeth: {terms: {pinion: 30 mm, slide.z: -1}}
loads:
  motor: {body: pinion, torque: 2 N m}
"""
PAIR = """\
gears:
  g1: {number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 45, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  driver: {gears: [g1], inertia: 0.002, mass: 2, transverse_inertia: 0.0015%s}
  driven: {gears: [g2], inertia: 0.01, mass: 4, transverse_inertia: 0.006%s}
%s
meshes:
  stage: {gears: [g1, g2], direction: 25 deg, stiffness: {law: fourier, mean: 4e8 N/m, cosine: [-0.2]}}
"""


def test_a_rack_moves_with_its_pinion():
    model = loads_model(RACK)
    assert loads_model(dump_model(model)) == model
    system = compile_model(model)
    state = system.initial_state()
    evaluate.residual(system, state)
    assert abs(system.workspace.g[0]) < 1e-17  # the start values are as assembled
    a, _ = accelerations(system, state)
    alpha = 2.0 / (0.02 + 3.0 * 0.03**2)
    np.testing.assert_allclose(a, [alpha, 0.03 * alpha], rtol=1e-13)


def test_tooth_numbers_stay_whole():
    text = """\
bodies:
  a: {inertia: 1, position: [0, 0, 0]}
  b: {inertia: 2, position: [0, 0, 0]}
  c: {inertia: 3, position: [0, 0, 0]}
ratios: {r: {terms: {a: 17, b: 41}}, s: {terms: {b: 13, c: -29}}}
scenarios: {run: {speed: {a: 100 rpm}, duration: 1 s}}
"""
    model = loads_model(text)
    system = compile_model(model)
    assert system.records["ratio"]["c_i"].tolist() == [17.0, 13.0]
    assert system.records["ratio"]["c_j"].tolist() == [41.0, -29.0]
    omega = 100.0 * math.pi / 30.0
    speeds = model.start_speeds("run")
    assert speeds == pytest.approx({"a": omega, "b": -17 / 41 * omega, "c": -17 / 41 * 13 / 29 * omega})


def test_three_terms_are_a_planet_set():
    text = """\
bodies:
  sun: {inertia: 0.1}
  carrier: {inertia: 0.4}
  planet: {inertia: 0.02, mass: 1}
joints:
  hub: {type: revolute, bodies: [ground, carrier], position: [0, 0, 0]}
  pin: {type: revolute, bodies: [carrier, planet], position: [0.1, 0, 0]}
ratios:
  inner: {terms: {sun: 24, planet: 18, carrier: -24}}
loads:
  motor: {body: sun, torque: 1 N m}
"""
    system = compile_model(loads_model(text))
    a, _ = accelerations(system, system.initial_state())
    a = dict(zip(system.layout.coordinates, a, strict=True))
    # Lagrange: sun a, carrier c, planet p on the carrier: 24 a + 18 p - 24 c = 0
    M = np.array([[0.1, 0.0, 0.0], [0.0, 0.4 + 0.02 + 0.01, 0.02], [0.0, 0.02, 0.02]])
    G = np.array([[24.0, -24.0, 18.0]])
    found = np.linalg.solve(np.block([[M, G.T], [G, np.zeros((1, 1))]]), [1.0, 0.0, 0.0, 0.0])
    assert [a["sun.spin"], a["carrier.spin"], a["planet.spin"]] == pytest.approx(found[:3], rel=1e-12)


def test_a_moved_frame_follows_time():
    text = """\
bodies:
  table: {mass: 10 kg}
  bob: {mass: 2 kg, center_of_mass: [0, 0, -0.5]}
joints:
  shaker:
    type: moved
    bodies: [ground, table]
    position: [0, 0, 0]
    motion: {x: [20 mm * sin(2*pi*3 Hz*t), 5 mm], spin: 0.4*t}
  pivot: {type: revolute, bodies: [table, bob], position: [0, 0, 0], axes: {z: [0, 1, 0]}}
"""
    model = loads_model(text)
    assert loads_model(dump_model(model)) == model
    system = compile_model(model)
    state = system.initial_state()
    state.t, state.q[0], state.v[0] = 0.11, 0.3, 0.7
    a, frames = accelerations(system, state)
    w = 2.0 * math.pi * 3.0
    np.testing.assert_allclose(frames["r"][1, 0], 0.005 + 0.02 * math.sin(w * 0.11), rtol=1e-14)
    np.testing.assert_allclose(frames["tw"][1], [0.02 * w * math.cos(w * 0.11), 0, 0, 0, 0, 0.4], atol=1e-12)
    # the turning plane of the pendulum: l a = -x'' cos(spin) cos q + l 0.16 sin q cos q
    push = -0.02 * w * w * math.sin(w * 0.11) * math.cos(0.4 * 0.11)
    expected = push / 0.5 * math.cos(0.3) + 0.16 * math.sin(0.3) * math.cos(0.3)
    # second derivative of a formula by differences of fourth order
    assert a[0] == pytest.approx(expected, rel=1e-7)


def test_a_user_joint_guides_along_a_curve():
    text = """\
bodies:
  bead: {mass: 2 kg}
joints:
  groove:
    type: user
    bodies: [ground, bead]
    position: [0, 0, 0]
    coordinates: {s: angle}
    motion:
      x: 0.3 m * cos(s)
      y: 0.3 m * sin(s)
      z: {table: [[-90 deg, -1 m], [0, 0], [90 deg, 1 m]], over: s}
    start: {s: 20 deg}
    speed: {s: 3 rad/s}
"""
    model = loads_model(text)
    assert loads_model(dump_model(model)) == model
    system = compile_model(model)
    state = system.initial_state()
    assert system.layout.coordinates == ("bead.s",)
    assert state.q[0] == pytest.approx(math.radians(20.0))
    a, frames = accelerations(system, state)
    assert abs(a[0]) < 1e-8  # a helix at constant speed; formulas have their second derivative by differences
    np.testing.assert_allclose(frames["tw"][1, 2], 3.0 * 2.0 / math.pi, rtol=1e-12)
    mass = evaluate.linearize(system, state)[0]
    np.testing.assert_allclose(mass, 2.0 * (0.09 + (2.0 / math.pi) ** 2), rtol=1e-12)


def test_a_moved_frame_may_follow_python(tmp_path):
    (tmp_path / "own.py").write_text(
        "import math\n\ndef way(t, x, p):\n    return p[0] * math.sin(5.0 * t)\n"
    )
    text = """\
bodies: {table: {mass: 10 kg}}
joints:
  j:
    type: moved
    bodies: [ground, table]
    position: [0, 0, 0]
    motion: {z: {python: 'own.py:way', parameters: [0.2]}}
scenarios: {run: {duration: 2 s}}
"""
    model = loads_model(text, allow_code=True, file=str(tmp_path / "m.yaml"))
    system = compile_model(model, "run")
    state = system.initial_state()
    state.t = 1.3
    _, frames = accelerations(system, state)
    assert frames["r"][1, 2] == pytest.approx(0.2 * math.sin(6.5), abs=1e-9)
    assert frames["ac"][1, 2] == pytest.approx(-5.0 * math.sin(6.5), rel=1e-5)


@pytest.mark.parametrize(
    ("drive", "rate"),
    [
        ("main.spin: {speed: 3 rad/s}", "crank.spin"),
        ("crank: {angle: 3*t}", "crank.spin"),
        ("crank_pin.spin: {angle: '-3*t'}", "rod.spin"),
        ("cylinder.z: {velocity: '-50 mm/s'}", "piston.z"),
        ("cylinder.z: {position: '-50 mm/s * t'}", "piston.z"),
    ],
)
def test_any_coordinate_can_be_driven(drive, rate):
    text = SLIDER_CRANK
    model = loads_model(f"{text}scenarios:\n  run: {{duration: 1 s, drive: {{{drive}}}}}\n")
    assert loads_model(dump_model(model)) == model
    system = compile_model(model, "run")
    free = compile_model(
        loads_model(text.replace("position: [0, 0, 0]}", "position: [0, 0, 0], start: {spin: 40 deg}}"))
    )
    start = assemble_state(free, keep=[0]).state
    state = system.initial_state()
    state.q[:] = start.q
    d = system.layout.coordinate(rate)
    record = system.records["drive"][0]
    record["angle"] += state.q[d]  # counted from here
    found = moved_to(system, state, 0.0)
    expected = {"crank.spin": 3.0, "rod.spin": -3.0, "piston.z": -0.05}[rate]
    assert found.v[d] == pytest.approx(expected, rel=1e-9)
    assert abs(found.a[d]) < 1e-6
    unit = {c.name: c.unit for c in system.layout.channels}
    name = drive.split(":")[0]
    assert unit.get(f"torque[{name}]" if rate != "piston.z" else f"force[{name}]") in ("N m", "N")


@pytest.mark.parametrize("frame", ["", ", axes: {z: [0, 0, 1], x: [0.6, 0.8, 0]}"])
@pytest.mark.parametrize("kind", [("torsion", "revolute"), ("planar", "planar"), ("free", "shaft")])
def test_gears_on_joints_mesh_as_by_motions(kind, frame):
    motion, joint = kind
    plain = compile_model(loads_model(PAIR % (f", motion: {motion}", f", motion: {motion}", "")))
    places = ", position: [0, 0, 0]}", "}"
    lines = "\n".join(
        f"  j{k}: {{type: {joint}, bodies: [ground, {b}]{frame}{places[k]}"
        for k, b in enumerate(("driver", "driven"))
    )
    model = loads_model(PAIR % ("", "", f"joints:\n{lines}"))
    jointed = compile_model(model)
    rng = np.random.default_rng(1)
    state = plain.initial_state()
    n = state.q.size // 2
    q = 1e-4 * rng.normal(size=state.q.size)
    q[n - 1], q[-1] = 2.0, -2.0 * 30 / 45 + 2e-3
    v = rng.normal(size=q.size)
    found = []
    for system, x in (
        (plain, np.eye(2)),
        (jointed, np.array([[0.6, -0.8], [0.8, 0.6]]) if frame else np.eye(2)),
    ):
        state = system.initial_state()
        state.q[:], state.v[:] = q, v
        for at in (0, n):  # the same motion seen along turned axes: translations, small tilts
            for i in (0, 3) if n == 6 else (0,) if n == 3 else ():
                for y in (state.q, state.v):
                    y[at + i : at + i + 2] = x.T @ y[at + i : at + i + 2]
        a, _ = accelerations(system, state)
        found.append(np.array([a[n - 1], a[-1]]))
    # alpha comes before beta: about turned axes the same tilt differs by their product, 1e-4 of its size
    np.testing.assert_allclose(found[1], found[0], rtol=1e-3 if frame and motion == "free" else 1e-9)


def test_check_lists_tree_loops_and_count(tmp_path, capsys):
    from pitchpoint.cli.main import run_command

    file = tmp_path / "crank.yaml"
    file.write_text(SLIDER_CRANK)
    assert run_command(["check", str(file)]) == 0
    out = " ".join(capsys.readouterr().out.split())
    assert "carries rod on crank" in out
    assert "closes a loop: 5 constraints" in out
    assert "3 coordinates - 5 constraints = -2 degrees of freedom by count" in out
    assert run_command(["check", "--json", str(file)]) == 0
    import json

    found = json.loads(capsys.readouterr().out)
    assert found["mobility"] == {"coordinates": 3, "constraints": 5, "by_count": -2}
    assert found["joints"]["cylinder"]["coordinates"] == ["cylinder.z"]


@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_a_block_with_friction_on_an_incline(direction):
    slope = {"z": [math.cos(0.5), 0.0, math.sin(0.5)]}
    text = f"""\
gravity: [0, 0, -9.81]
bodies:
  block: {{mass: 3}}
joints:
  slide:
    type: prismatic
    bodies: [ground, block]
    position: [0, 0, 0]
    axes: {{z: {slope["z"]}}}
    speed: {{z: {2.0 * direction}}}
    friction: {{coefficient: 0.2, preload: 4 N}}
"""
    model = loads_model(text)
    assert loads_model(dump_model(model)) == model
    system = compile_model(model)
    a, _ = accelerations(system, system.initial_state())
    rubbing = 0.2 * (9.81 * math.cos(0.5) + 4.0 / 3.0) * direction
    assert a[0] == pytest.approx(-9.81 * math.sin(0.5) - rubbing, rel=1e-12)


@pytest.mark.parametrize("bodies", ["[ground, bob]", "[bob, ground]"])
@pytest.mark.parametrize("cut", [False, True])
def test_a_pin_with_friction_slows_a_pendulum(bodies, cut):
    loose = "  loose: {type: free, bodies: [ground, bob], position: [0, 0, 0]%s}\n"
    pin = (
        f"  pin: {{type: revolute, bodies: {bodies}, position: [0, 0, 0], axes: {{z: [0, 1, 0]}}, "
        "friction: {coefficient: 0.3, radius: 80 mm}%s}\n"
    )
    rate = 1.7
    if cut:
        joints = loose % f", speed: {{beta: {rate}}}" + pin % ", cut: true"
    else:
        sign = rate if bodies == "[ground, bob]" else -rate
        joints = pin % f", speed: {{spin: {sign}}}"
    # hanging at 0.9 rad: a turn about y moves what hangs below towards -x
    x, z = -0.7 * math.sin(0.9), -0.7 * math.cos(0.9)
    text = f"""\
gravity: [0, 0, -9.81]
bodies:
  bob: {{mass: 2, center_of_mass: [{x}, 0, {z}], inertia_tensor: [0.05, 0.05, 0.05, 0, 0, 0]}}
joints:
{joints}"""
    system = compile_model(loads_model(text))
    _, frames = accelerations(system, system.initial_state())
    about, g, m, length = 0.05 + 2.0 * 0.49, 9.81, 2.0, 0.7
    a = 0.0
    for _ in range(200):  # the load depends on the acceleration, which depends on the friction
        radial = m * (length * rate**2 + g * math.cos(0.9))
        tangential = m * (length * a + g * math.sin(0.9))
        a = (-m * g * length * math.sin(0.9) - 0.3 * 0.08 * math.hypot(radial, tangential)) / about
    assert frames["ac"][1, 4] == pytest.approx(a, rel=1e-9)


PLANETS = """\
gears:
  sun: {number_of_teeth: 30, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  planet: {number_of_teeth: 24, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  ring:
    {type: internal, number_of_teeth: 78, normal_module: 2 mm, face_width: 20 mm,
     profile_shift_coefficient: 0, tip_diameter: 154 mm, bore_diameter: 180 mm}
bodies:
  sun: {gears: [sun], motion: torsion, position: [0, 0, 0]}
  ring: {gears: [ring], motion: fixed, position: [0, 0, 0]}
  carrier: {mass: 2 kg, inertia: 0.01 kg m^2, transverse_inertia: 0.006 kg m^2}
  planet: {gears: [planet]}
joints:
  hub: {type: revolute, bodies: [ground, carrier], position: [0, 0, 0]}
  pin: {type: revolute, bodies: [carrier, planet]}
meshes:
  outer: {gears: [sun, planet], stiffness: {law: constant, value: 4e8 N/m}}
  inner: {gears: [planet, ring], stiffness: {law: constant, value: 4e8 N/m}, direction: 180 deg}
loads:
  motor: {body: sun, torque: 10 N m}
  brake: {body: carrier, torque: -35 N m}
scenarios:
  run: {duration: 0.02 s, step: 2 us, settle_time: 0 s}
"""


def test_a_planet_set_of_meshes_turns_by_willis():
    from pitchpoint.solvers.time import run_time
    from pitchpoint.solvers.time_summary import Memory

    model = loads_model(PLANETS)
    assert model.bodies["planet"].origin == pytest.approx((0.054, 0.0, 0.0))  # from its mesh
    system = compile_model(model, "run")
    memory = Memory()
    run_time(system, sink=memory)
    names = [c.name for c in system.layout.channels]
    mean = dict(zip(names, np.concatenate(memory.rows).mean(axis=0), strict=True))
    speeds = {b: mean[f"speed[{b}]"] for b in ("sun", "carrier", "planet")}
    assert speeds["sun"] > 1.0
    # sun against carrier -78/30 of ring against carrier; planet counts on the carrier: +78/24
    assert speeds["sun"] / speeds["carrier"] == pytest.approx(1.0 + 78.0 / 30.0, rel=1e-3)
    assert speeds["planet"] / speeds["carrier"] == pytest.approx(-78.0 / 24.0, rel=1e-3)
