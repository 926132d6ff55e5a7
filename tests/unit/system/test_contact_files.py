# SPDX-License-Identifier: Apache-2.0
"""Contacts from files: a cam and its follower in closed form, a ball on a plate, what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.kinematics import moved_to
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.source import row_source, row_unit
from tests.support.mechanism_files import accelerations

CAM = """\
bodies:
  cam: {mass: 1 kg, inertia: 1e-3}
  lifter: {mass: 0.2 kg, markers: {foot: {axes: {z: [0, 0, 1]}}}}
joints:
  shaft: {type: revolute, bodies: [ground, cam], position: [0, 0, 0]}
  guide: {type: prismatic, bodies: [ground, lifter], position: [0, 50 mm, 0], axes: {z: [0, 1, 0]}}
cam_contacts:
  c:
    ends: [lifter.foot, cam]
    curve: {shape: circle, radius: 30 mm, x: [0 mm], y: [10 mm]}
    radius: 10 mm
    permanent: true
scenarios:
  run: {duration: 1 s, drive: {cam: {speed: 20 rad/s}}}
"""
BALL = """\
bodies:
  ball: {mass: 0.5 kg, inertia_tensor: [1e-4, 1e-4, 1e-4, 0, 0, 0], position: [0, 0, 9.9 mm]}
joints:
  j: {type: free, bodies: [ground, ball]}
surface_contacts:
  c:
    ends: [ball, ground]
    first: {shape: sphere, radius: 10 mm}
    second: {shape: plane}
    law: {force: 1 kN, depth: 0.1 mm}
"""


def test_a_follower_stays_on_its_cam():
    model = loads_model(CAM)
    assert loads_model(dump_model(model)) == model
    system = compile_model(model, "run")
    state = moved_to(system, system.initial_state(), 0.0)
    for t in (0.01, 0.02, 0.03):
        state = moved_to(system, state, t)
    theta = math.pi / 2.0 + 20.0 * 0.03  # of the centre of the circle
    e, a = 0.01, 0.04
    root = math.sqrt(a * a - (e * math.cos(theta)) ** 2)
    y = e * math.sin(theta) + root
    slope = e * math.cos(theta) + e * e * math.sin(theta) * math.cos(theta) / root
    d = system.layout.coordinate("lifter.z")
    assert state.q[d] == pytest.approx(y - 0.05, abs=1e-13)
    assert state.v[d] == pytest.approx(20.0 * slope, rel=1e-10)


FLAT = CAM.replace(
    """cam_contacts:
  c:
    ends: [lifter.foot, cam]
    curve: {shape: circle, radius: 30 mm, x: [0 mm], y: [10 mm]}
    radius: 10 mm
""",
    """curve_contacts:
  c:
    ends: [lifter.foot, cam]
    first: {shape: polygon, closed: false, x: [-40 mm, 40 mm], y: [0, 0]}
    second: {shape: circle, radius: 30 mm, x: [0 mm], y: [10 mm]}
""",
)
CUP = """\
gravity: [0, 0, -9.81 m/s^2]
bodies:
  ball: {mass: 0.5 kg, inertia_tensor: [2e-5, 2e-5, 2e-5, 0, 0, 0], position: [0, 0, -90 mm]}
joints:
  j: {type: free, bodies: [ground, ball]}
surface_contacts:
  c:
    ends: [ground, ball]
    first: {shape: sphere, radius: 100 mm, hollow: true}
    second: {shape: sphere, radius: 10 mm}
    permanent: true
scenarios:
  swing: {duration: 1 s}
"""


def test_a_flat_follower_stays_on_its_cam():
    """Lift R + e sin(w t) from the top of the circle, at e cos(w t) from the middle."""
    model = loads_model(FLAT)
    assert loads_model(dump_model(model)) == model
    system = compile_model(model, "run")
    state = system.initial_state()
    for t in (0.0, 0.01, 0.02, 0.03):
        state = moved_to(system, state, t)
    theta = math.pi / 2.0 + 20.0 * 0.03
    d = system.layout.coordinate("lifter.z")
    assert state.q[d] == pytest.approx(0.03 + 0.01 * math.sin(theta) - 0.05, abs=1e-13)
    assert state.v[d] == pytest.approx(20.0 * 0.01 * math.cos(theta), rel=1e-10)
    seen = dict(zip([c.name for c in system.layout.channels], evaluate.observe(system, state), strict=True))
    assert seen["contact_path[c.i]"] == pytest.approx(0.04 + 0.01 * math.cos(theta), abs=1e-12)


def test_rows_of_contacts_name_their_place():
    """Messages of loops that do not close say which contact it is and by what length."""
    for content, section, line in ((CAM, "cam_contacts", 8), (FLAT, "curve_contacts", 8)):
        system = compile_model(loads_model(content), "run")
        row = next(r for r, words in enumerate(system.layout.rows) if words.endswith(" c"))
        assert row_source(system, row) == f"{section}.c (line {line})"
        assert row_unit(system, row) == " m"


def test_a_ball_that_never_leaves_a_cup_is_a_pendulum():
    """Without friction it swings with sqrt(g/l), l = 90 mm, and presses with its weight."""
    model = loads_model(CUP)
    assert loads_model(dump_model(model)) == model
    system = compile_model(model, "swing")
    state = system.initial_state()
    state.q[0] = 1e-5
    a, _ = accelerations(system, state)
    assert a[0] == pytest.approx(-9.81 / 0.09 * 1e-5, rel=1e-7)
    after = evaluate.store(system, state.t)  # with the multiplier
    seen = dict(zip([c.name for c in system.layout.channels], evaluate.observe(system, after), strict=True))
    assert seen["contact_force[c]"] == pytest.approx(0.5 * 9.81, rel=1e-8)
    assert seen["contact_location[c.z]"] == pytest.approx(-0.1, rel=1e-8)
    state.q[[0, 2]] = 0.03, 0.09 - math.sqrt(0.09**2 - 0.03**2)  # it rolls to the bottom
    rest = find_equilibrium(system, state)
    np.testing.assert_allclose(rest.state.q[:3], 0.0, atol=1e-10)


def test_a_ball_is_pressed_out_of_a_plate():
    model = loads_model(BALL)
    assert loads_model(dump_model(model)) == model
    system = compile_model(model)
    a, _ = accelerations(system, system.initial_state())
    assert a[system.layout.coordinate("ball.z")] == pytest.approx(1000.0 / 0.5, rel=1e-9)


FACES = {
    "open": "{shape: polygon, closed: false, x: [-40 mm, 40 mm], y: [0, 0]}",
    "block": "{shape: polygon, x: [-40 mm, 40 mm, 40 mm, -40 mm], y: [0, 0, 30 mm, 30 mm]}",
}


@pytest.mark.parametrize("start", ["0 mm", "2 mm", "40 mm"])
@pytest.mark.parametrize("face", FACES)
def test_a_follower_is_found_at_rest_on_its_cam(face, start):
    """The steps of the search grow in the air and land deep in the cam, from where it comes back.

    At rest the overlap carries the weight: 9.81 N/kg 0.2 kg/(1e7 N/m) = 0.1962 um.
    """
    text = CAM.replace("position: [0, 50 mm, 0]", "position: [0, 40 mm, 0]").replace(
        "guide: {", f"guide: {{start: {{z: {start}}}, "
    )
    head, tail = text.split("cam_contacts:")
    text = f"""gravity: [0, -9.81 m/s^2, 0]
{head}curve_contacts:
  c:
    ends: [lifter.foot, cam]
    first: {FACES[face]}
    second: {{shape: circle, radius: 30 mm, x: [0 mm], y: [10 mm]}}
    law: {{force: 10 N, depth: 1 um, exponent: 1}}
scenarios:{tail.split("scenarios:")[1]}"""
    system = compile_model(loads_model(text), "run")
    found = find_equilibrium(system)
    d = system.layout.coordinate("lifter.z")
    assert found.state.q[d] == pytest.approx(-0.1962e-6, rel=1e-6)


def test_triangles_come_from_a_file(tmp_path):
    corners = np.array([[[-1, -1, 0], [1, -1, 0], [1, 1, 0]], [[-1, -1, 0], [1, 1, 0], [-1, 1, 0]]], float)
    np.save(tmp_path / "plate.npy", corners)
    text = BALL.replace("{shape: plane}", "{shape: triangles, file: plate.npy, open: true}")
    model = loads_model(text, file=str(tmp_path / "m.yaml"))
    assert "file: plate.npy" in dump_model(model)
    system = compile_model(model)
    state = system.initial_state()
    state.q[:2] = 0.2, 0.1  # beside the edge between the two
    a, _ = accelerations(system, state)
    assert a[system.layout.coordinate("ball.z")] > 0.0
    assert np.all(np.isfinite(evaluate.observe(system, state)))


# (file, changes, place, words)
CASES = {
    "no law": (CAM, [("permanent: true", "permanent: false")], "cam_contacts.c.law", "is missing"),
    "a permanent curve with a margin": (
        FLAT,
        [("permanent: true", "permanent: true\n    margin: 1 mm")],
        "curve_contacts.c.margin",
        "has no effect on a permanent contact",
    ),
    "curves without law": (FLAT, [("    permanent: true\n", "")], "curve_contacts.c.law", "is missing"),
    "a cup that never leaves a plane": (
        CUP,
        [
            ("shape: sphere, radius: 10 mm", "shape: torus, radius: 10 mm, tube: 1 mm"),
            ("shape: sphere, radius: 100 mm, hollow: true", "shape: plane"),
        ],
        "surface_contacts.c.permanent",
        "is between a plane and a torus",
    ),
    "a law of what never parts": (
        CAM,
        [("permanent: true", "permanent: true\n    law: {force: 1, depth: 1}")],
        "cam_contacts.c.law",
        "has no effect",
    ),
    "a circle without radius": (
        CAM,
        [("shape: circle, radius: 30 mm,", "shape: circle,")],
        "cam_contacts.c.curve.radius",
        "required for shape circle",
    ),
    "a polygon of two corners": (
        CAM,
        [("shape: circle, radius: 30 mm, x: [0 mm], y: [10 mm]", "shape: polygon, x: [0, 1], y: [0, 1, 2]")],
        "cam_contacts.c.curve.x",
        "has 2 points, and y has 3",
    ),
    "an involute that does not roll": (
        CAM,
        [("shape: circle, radius: 30 mm, x: [0 mm], y: [10 mm]", "shape: involute, radius: 1, roll: [1, 1]")],
        "cam_contacts.c.curve.roll",
        "two different positive angles",
    ),
    "an unknown shape": (
        CAM,
        [("shape: circle", "shape: cirle")],
        "cam_contacts.c.curve.shape",
        "did you mean circle",
    ),
    "damping and restitution": (
        BALL,
        [("depth: 0.1 mm", "depth: 0.1 mm, damping: 1, restitution: 0.5")],
        "surface_contacts.c.law.damping",
        "cannot be combined with restitution",
    ),
    "friction the wrong way round": (
        BALL,
        [("0.1 mm}", "0.1 mm}\n    friction: {static: 0.2, dynamic: 0.1, static_speed: 1, slip_speed: 0.1}")],
        "surface_contacts.c.friction.static_speed",
        "is not below slip_speed",
    ),
    "a sphere without radius": (
        BALL,
        [("shape: sphere, radius: 10 mm", "shape: sphere")],
        "surface_contacts.c.first.radius",
        "required for shape sphere",
    ),
    "a plane on a plane": (
        BALL,
        [("shape: sphere, radius: 10 mm", "shape: plane")],
        "surface_contacts.c",
        "is between two planes without limits",
    ),
    "a cone without height on a plane": (
        BALL,
        [("shape: sphere, radius: 10 mm", "shape: cone, half_angle: 10 deg")],
        "surface_contacts.c.first.length",
        "required for shape cone",
    ),
    "a file that is not there": (
        BALL,
        [("shape: plane", "shape: triangles, file: nowhere.npy")],
        "surface_contacts.c.second.file",
        "names a file that does not exist",
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_wrong_contacts_are_told_with_their_line(case):
    text, changes, where, words = CASES[case]
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    assert [p.where for p in caught.value.problems] == [where], caught.value
    assert words in str(caught.value)
    assert caught.value.problems[0].line is not None
