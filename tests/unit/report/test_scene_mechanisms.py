# SPDX-License-Identifier: Apache-2.0
"""Scenes of mechanisms: loops stay closed, tumbling bodies turn, what bends ends where it is held."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.report.scene.build import scene_of
from pitchpoint.report.scene.rest import rest_scene
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from pitchpoint.viz.scene.file import scene_texts
from tests.support.scene_reader import Seen

EXAMPLES = Path(__file__).parents[3] / "examples"


def run(model, scenario, **changes):
    model = model.replace_all({f"scenarios.{scenario}.{k}": v for k, v in changes.items()})
    system = compile_model(model, scenario)
    result = solve_time(system)
    return Seen(*scene_texts(scene_of(model, result))), result, system


def place(scene, body, point, frame):
    origin, axes = scene.pose(scene.body(body), frame)
    return origin + axes @ np.asarray(point)


def marked(scene, model, body, point, frame):
    """A point that the file gives in the axes of a body: where these are at rest, moved with the body."""
    part, b = model.bodies[body], scene.body(body)
    z, x = (np.array(v) for v in (part.axes.z, part.axes.x))
    axes = np.column_stack([x, np.cross(z, x), z]) / np.linalg.norm(x)
    origin, rest = scene.rest(b)
    return place(scene, body, rest.T @ (np.array(part.position) + axes @ point - origin), frame)


def test_three_links_of_the_squeezing_mechanism_meet_in_one_pin():
    """Its crank goes round; angles of the links are not part of that, so that they are not magnified."""
    model = load_model(EXAMPLES / "squeezing-mechanism/model.yaml")
    scene, result, _ = run(model, "squeeze", duration="15 ms")
    n = len(scene.times)
    for frame in range(0, n, n // 9):
        knot = marked(scene, model, "rod", [-28e-3, 0, 0], frame)
        for body, point in (
            ("triangle", [0, -35e-3, 0]),
            ("upper_link", [0, -20e-3, 0]),
            ("lower_link", [20e-3, 0, 0]),
        ):
            assert marked(scene, model, body, point, frame) == pytest.approx(knot, abs=2e-6)
    rod = scene.header["bodies"][scene.body("rod")]
    assert "gross" in rod and "spin" not in rod
    # the drawn spring goes from the hanger to the hook
    ends = scene.placed("pull", n - 1)
    hook = marked(scene, model, "triangle", [20e-3, -18e-3, 0], n - 1)
    hanger = np.array([14e-3, 72e-3, 0])
    way = (hook - hanger) / np.linalg.norm(hook - hanger)
    along = (ends - hanger) @ way
    assert along.min() == pytest.approx(0.0, abs=1e-3)
    assert along.max() == pytest.approx(np.linalg.norm(hook - hanger), abs=1e-3)


def test_balls_of_the_governor_swing_out_and_its_rods_keep_their_length():
    model = load_model(EXAMPLES / "flyball-governor/model.yaml")
    scene, result, _ = run(model, "run_up", duration="1.5 s")
    last = len(scene.times) - 1
    assert scene.header["up"] == [0.0, 0.0, 1.0]
    for frame in (0, last // 2, last):
        seat = scene.solid("link_left")["between"]
        ends = []
        for body, end in zip(seat["bodies"], seat["ends"], strict=True):
            origin, axes = scene.pose(body, frame)
            ends.append(origin + axes @ np.array(end))
        assert np.linalg.norm(ends[1] - ends[0]) == pytest.approx(0.12, abs=2e-6)
        # arms hang below their hinges, as drawn
        ball = scene.placed("arm_left", frame)
        assert ball[:, 2].min() < 0.4 - 0.15
    out = [np.hypot(*scene.placed("arm_left", k)[:, :2].T).max() for k in (0, last)]
    swung = abs(float(result["angle[arm_left]"][-1]))
    assert out[1] - out[0] == pytest.approx(0.2 * np.cos(np.radians(25.0)) * swung, rel=0.35)


STONE = """\
bodies:
  stone: {mass: 1 kg, inertia_tensor: [0.01, 0.02, 0.025, 0, 0, 0], position: [0, 0, 0]}
  other: {mass: 1 kg, inertia: 0.01, motion: torsion, position: [0.5, 0, 0]}
joints:
  fly: {type: free, bodies: [ground, stone], speed: {alpha: 0.05, beta: 6.0, spin: 0.03}}
scenarios:
  on: {start: assembled, duration: 2 s, step: 1 ms, settle_time: 0 s}
"""


def test_a_tumbling_body_has_the_attitude_of_the_solver():
    """Angular momentum of a free body stays what it was: I omega in the world, from drawn attitudes."""
    model = loads_model(STONE)
    scene, result, _ = run(model, "on")
    body = scene.header["bodies"][scene.body("stone")]
    assert "quaternion" in body and "turn" not in body
    inertia, momenta, step = np.diag([0.01, 0.02, 0.025]), [], float(scene.times[1] - scene.times[0])
    for frame in range(0, len(scene.times) - 1, 150):
        (_, a), (_, b) = (scene.pose(scene.body("stone"), k) for k in (frame, frame + 1))
        skew = (b @ a.T - a @ b.T) / (2.0 * step)
        omega = np.array([skew[2, 1], skew[0, 2], skew[1, 0]])
        middle = 0.5 * (a + b)
        momenta.append(middle @ inertia @ middle.T @ omega)
    assert np.ptp(momenta, axis=0).max() < 2e-3 * np.linalg.norm(momenta[0])
    # and it does tumble: its tip goes to the other side
    tips = np.array([place(scene, "stone", [0.1, 0, 0], k) for k in range(len(scene.times))])
    assert np.ptp(tips[:, 0]) > 0.15


BEAM = """\
bodies:
  block: {mass: 2 kg, inertia_tensor: [0.01, 0.01, 0.01, 0, 0, 0], position: [0.4, 0, 0]}
joints:
  fly: {type: free, bodies: [ground, block]}
beams:
  blade: {ends: [ground, block], section: {width: 20 mm, height: 4 mm}, pieces: 4}
loads:
  push: {body: block, force: [0, 0, 20 N]}
scenarios:
  on: {duration: 0.1 s, step: 0.2 ms, settle_time: 0 s}
"""


def test_a_beam_ends_at_its_bodies_and_bends_smoothly():
    model = loads_model(BEAM)
    scene, result, _ = run(model, "on")
    last = len(scene.times) - 1
    points = scene.placed("blade", last)
    assert np.isclose(points[:, 0], 0.0, atol=1e-9).any()
    tip = points[np.argsort(points[:, 0])[-4:]].mean(axis=0)
    assert tip == pytest.approx(scene.pose(scene.body("block"), last)[0], abs=1e-6)
    assert abs(tip[2]) > 1e-3 or abs(tip[1]) > 1e-3
    rings = points.reshape(-1, 4, 3).mean(axis=1)
    # clamped at its root: the first ring leaves along the axis
    assert np.abs(rings[1, 1:]).max() < 0.03 * np.abs(rings[-1, 1:]).max()


def test_a_beam_of_a_model_that_is_not_compiled_is_straight():
    """Its stations are not bodies of the file: it goes from end to end."""
    scene = Seen(*scene_texts(rest_scene(loads_model(BEAM))))
    rings = scene.placed("blade", 0).reshape(-1, 4, 3).mean(axis=1)
    block = scene.rest(scene.body("block"))[0]
    assert scene.solid("blade")["blend"]["bodies"] == [-1, scene.body("block")]
    assert rings == pytest.approx(np.outer(np.linspace(0.0, 1.0, len(rings)), block), abs=1e-7)


def test_modes_are_those_of_the_solver_in_the_order_of_the_scene():
    model = load_model(EXAMPLES / "geared-rotor/model.yaml")
    system = compile_model(model)
    found = find_modes(system, count=4)
    scene = Seen(*scene_texts(scene_of(model, modes=4)))
    names = [body["name"] for body in scene.header["bodies"]]
    assert len(scene.header["modes"]) == 4
    for k, mode in enumerate(scene.header["modes"]):
        assert mode["frequency"] == pytest.approx(float(found.frequency[k]))
        shown = scene.array(mode["position"])
        for b, name in enumerate(names):
            exact = found.damped_body_shape[k, found.bodies.index(name), :3]
            assert shown[b, 0] + 1j * shown[b, 1] == pytest.approx(exact, rel=1e-5, abs=1e-9)


def test_an_elastic_rod_bends_through_its_pins():
    """Its nodes at both ends are held by pins: there the drawn rod is where crank and piston are."""
    model = load_model(EXAMPLES / "flexible-slider-crank/elastic.yaml")
    scene, result, _ = run(model, "driven", duration="20 ms")
    solid = scene.solid("rod")
    modal = solid["modal"]
    shapes, node = scene.array(modal["shapes"]), scene.array(modal["node"]).astype(int)
    now = scene.array(modal["coordinates"])
    for frame in (0, len(scene.times) // 3, len(scene.times) - 1):
        origin, axes = scene.pose(solid["body"], frame)
        moved = scene.array(solid["points"]) + np.einsum("k,kni->ni", now[frame], shapes)[node]
        drawn = origin + moved @ axes.T
        ends = [drawn[node == k].mean(axis=0) for k in (node.min(), node.max())]
        pins = place(scene, "crank", [0.1, 0, 0], frame), place(scene, "piston", [0, 0, 0], frame)
        for end, pin in zip(ends, pins, strict=True):
            assert end == pytest.approx(pin, abs=2e-5)


def test_spectra_of_a_run_show_its_mesh_frequency():
    """The transmission error of 23 teeth at 600 rpm has its largest line at 230 Hz."""
    from tests.unit.report.test_scene import PAIR

    scene, _, _ = run(loads_model(PAIR.format(z="[0, 0, 1]", x="[1, 0, 0]")), "on")
    spectra = {s["channel"]: s for s in scene.header["spectra"] if not s["of"]}
    error = spectra["transmission_error[m]"]
    frequency, amplitude = (scene.array(error[key]) for key in ("lines", "amplitude"))
    assert frequency[np.argmax(amplitude)] == pytest.approx(230.0, abs=10.0)
    assert error["unit"] == "m"


@pytest.mark.parametrize(
    ("load", "first"),
    [
        ('{body: mass, force: ["10*sin(60*t)", 0, 0]}', "displacement[mass.x]"),
        ("{body: mass, torque: 2}", "speed[mass]"),
        ("{body: mass, torque: 2*t}", "torque[push]"),
    ],
)
def test_without_teeth_the_first_curve_is_one_that_changes(load, first):
    """A torque that is given as a number and a body that does not turn would be flat lines."""
    model = loads_model(f"""
bodies: {{mass: {{motion: free, mass: 1, inertia: 1e-3, transverse_inertia: 1e-3, position: [0, 0, 0]}}}}
bushings: {{k: {{ends: [mass, ground], stiffness: {{x: 1e4, y: 1e4, axial: 1e4, rx: 9, ry: 9, torsion: 9}}}}}}
loads: {{push: {load}}}
scenarios: {{run: {{start: assembled, duration: 50 ms, step: 1 ms, sample_rate: 1 kHz}}}}
""")
    result = solve_time(compile_model(model, "run"))
    assert [channel.name for channel in scene_of(model, result).channels if channel.first] == [first]
