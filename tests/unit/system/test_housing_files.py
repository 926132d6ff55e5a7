# SPDX-License-Identifier: Apache-2.0
"""Bearings in housings, rigid and elastic: stiffness by hand, exact tangents, refusals."""

from __future__ import annotations

import json

import numpy as np
import pytest
from scipy.linalg import eigh

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model
from pitchpoint.multibody.beam_section import Beam, rectangle
from pitchpoint.multibody.bodies import FREE, Body
from pitchpoint.multibody.joints import FIXED, FLOATING
from pitchpoint.multibody.structure import beam_line
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.modes.node_shapes import node_shapes
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.residual import EXACT
from pitchpoint.system.system import assemble
from tests.support.engine import bearings, differences, frame, positive

LENGTH, SIDE, E, NU = 0.3, 0.03, 2.1e11, 0.3
RADIAL, AXIAL, TILT = 2e7, 3e7, 4e4
FORCE = {"x": 9.0, "y": 7.0, "z": -5.0}
ARM = """\
bodies:
  shaft: {motion: free, mass: 2 kg, inertia: 3e-3, transverse_inertia: 5e-3, position: [0.3, 0, 0]}
elastic_bodies:
  arm:
    file: arm.npz
    nodes: {foot: {}, eye: {position: [0, 0, 300 mm]}}
    axes: {z: [1, 0, 0], x: [0, 1, 0]}
    position: [0, 0, 0]
    modes: 12
    static_shapes: true
joints:
  clamp: {type: fixed, bodies: [ground, arm.foot]}
bearings:
  eye: {body: shaft, housing: arm.eye, stiffness: {radial: 2e7 N/m, axial: 3e7 N/m, tilt: 4e4}}
loads:
  pull: {body: shaft, force: [9 N, 7 N, -5 N]}
scenarios:
  still: {duration: 1 ms, step: 1 us, settle_time: 0 s}
"""


def pieces(n=4):
    section = rectangle(SIDE, SIDE, NU)
    return [Beam(section=section, length=LENGTH / n, E=E, G=E / (2 * (1 + NU)), rho=7800.0)] * n


def arm_with(tmp_path, text=ARM):
    line = beam_line(pieces())
    np.savez(tmp_path / "arm.npz", K=line.K.toarray(), M=line.M.toarray(), places=line.places)
    file = tmp_path / "arm.yaml"
    file.write_text(text, encoding="utf-8")
    return load_model(file)


def test_the_housing_gives_way_by_hand(tmp_path):
    """Arm of 300 mm, clamped, and bearing in series: L/EA along x, L^3/3EI + L/(kappa GA) across."""
    model = arm_with(tmp_path)
    begin = prepare_start(compile_model(model, "still"), model.scenarios["still"])
    row = evaluate.observe(begin.system, begin.state)
    names = [c.name for c in begin.system.layout.channels]
    frames, bodies = begin.system.workspace.fr, begin.system.layout.bodies
    section, G = pieces()[0].section, E / (2 * (1 + NU))
    across = LENGTH**3 / (3 * E * section.I_1) + LENGTH / (section.kappa_1 * G * section.A)
    wanted = {
        "x": FORCE["x"] * (LENGTH / (E * section.A) + 1 / RADIAL),
        "y": FORCE["y"] * (across + 1 / RADIAL),
        "z": FORCE["z"] * (across + 1 / AXIAL),
    }
    moved = frames[bodies.index("shaft")]["r"] - [LENGTH, 0.0, 0.0]
    # the pull along the arm holds it straight by a share of F L^2/EI = 6e-5; bending shortens it by 1e-10 m
    np.testing.assert_allclose(moved, list(wanted.values()), rtol=1e-4, atol=1e-10)
    for axis in "xyz":
        assert row[names.index(f"bearing_force[eye.f{axis}]")] == pytest.approx(-FORCE[axis], rel=1e-4)


def test_frequencies_are_those_of_the_finite_elements(tmp_path):
    """The whole matrices with the shaft on six springs; 12 modes leave 0.1 % up to a fifth of the highest."""
    model = arm_with(tmp_path, ARM.replace("[9 N, 7 N, -5 N]", "[0 N, 0 N, 0 N]"))
    line = beam_line(pieces())
    n = line.size
    K, M = np.zeros((2, n + 6, n + 6))
    K[:n, :n], M[:n, :n] = line.K.toarray(), line.M.toarray()
    M[n:, n:] = np.diag([2.0, 2.0, 2.0, 5e-3, 3e-3, 5e-3])  # along the axes of the arm: y, z, x of the world
    spring = np.diag([RADIAL, AXIAL, RADIAL, TILT, 0.0, TILT])
    at = np.r_[n - 6 : n, n : n + 6]
    K[np.ix_(at, at)] += np.block([[spring, -spring], [-spring, spring]])
    free = np.r_[6 : n + 6]
    values = eigh(K[np.ix_(free, free)], M[np.ix_(free, free)], eigvals_only=True)
    wanted = np.sqrt(np.maximum(values, 0.0)) / (2 * np.pi)
    found = find_modes(compile_model(model, "still")).frequency
    assert found[0] == pytest.approx(0.0, abs=1e-3)
    np.testing.assert_allclose(found[1:8], wanted[1:8], rtol=1e-3)


def test_a_rigid_housing_is_one_of_bushings(tmp_path):
    """The same machine with the bearing as springs in six directions between markers."""
    text = """\
bodies:
  shaft: {motion: free, mass: 2 kg, inertia: 3e-3, transverse_inertia: 5e-3, position: [0.3, 0, 0]
          MARKED}
  block: {mass: 5 kg, inertia_tensor: [0.02, 0.03, 0.04, 0, 0, 0], position: [0.2, 0.1, 0],
          markers: {seat: {position: [100 mm, -100 mm, 50 mm]}}}
  floor: {motion: fixed, position: [0.2, 0.1, 0]}
joints:
  foot: {type: free, bodies: [ground, block]}
bushings:
  mount: {ends: [block, floor], stiffness: {x: 1e6, y: 2e6, axial: 3e6, tilt: 1e5, torsion: 2e5}}
  HOLD
scenarios: {still: {duration: 1 ms, step: 1 us, settle_time: 0 s}}
"""
    found = []
    for hold in (
        "other: {ends: [shaft.at, block.seat], stiffness: {x: 2e7, y: 1e7, axial: 3e7, tilt: 4e4}}",
        "\nbearings:\n  eye: {body: shaft, position: [0, 0, 50 mm], housing: block.seat, "
        "stiffness: {x: 2e7, y: 1e7, axial: 3e7, tilt: 4e4}}",
    ):
        marked = "" if "housing" in hold else ", markers: {at: {position: [0, 0, 50 mm]}}"
        file = text.replace("  HOLD", hold if "housing" in hold else f"  {hold}").replace("MARKED", marked)
        model = arm_with(tmp_path, file)
        found.append(find_modes(compile_model(model, "still")).frequency)
    np.testing.assert_allclose(found[1][1:], found[0][1:], rtol=1e-6)


@pytest.mark.nojit
@pytest.mark.parametrize(("key", "factors"), [("q", (0.0, 0.0, 1.0)), ("v", (0.0, 1.0, 0.0))])
def test_tangents_of_a_bearing_in_a_housing(key, factors):
    """Shaft and housing move anyhow; differences of 1e-6 leave 1e-7 of the largest entry.

    What acts on the one acts back on the other.
    """
    rng = np.random.default_rng(4)
    axes = frame(rng)
    round_ = {"mass": 1.0, "inertia": np.diag([0.3, 0.4, 0.5])}
    bodies = [
        Body(motion=FREE, axes=axes, position=rng.normal(size=3), name="shaft", **round_),
        Body(motion=FLOATING, axes=frame(rng), position=rng.normal(size=3), name="housing", **round_),
    ]
    bodies.append(
        Body(motion=FIXED, parent=2, axes=axes, position=bodies[0].position + 0.2 * axes[:, 2], name="seat")
    )
    K, D = 1e2 * positive(rng), positive(rng)
    K[5], K[:, 5] = 0.0, 0.0
    rows = bearings([(1, 3, K, D)])
    rows["zi"], rows["housed"] = 0.2, 1
    system = assemble(bodies, {"bearing": rows})
    state = system.initial_state()
    n = system.sizes["nd"]
    state.q[:], state.v[:] = rng.uniform(-0.1, 0.1, n), rng.normal(size=n)
    exact = evaluate.matrix(system, state, *factors, EXACT)
    found = differences(system, state, key)
    np.testing.assert_allclose(exact, found, atol=1e-7 * np.abs(found).max())
    wrenches = []
    for made in (assemble(bodies, {}), system):
        evaluate.residual(made, state)
        wrenches.append(made.workspace.fr["F"].copy())
    F, r = wrenches[1] - wrenches[0], system.workspace.fr["r"]
    np.testing.assert_allclose(F[1, :3] + F[3, :3], 0.0, atol=1e-12)
    total = F[1, 3:] + F[3, 3:] + np.cross(r[1], F[1, :3]) + np.cross(r[3], F[3, :3])
    np.testing.assert_allclose(total, 0.0, atol=1e-11)


def test_modes_for_animation_move_the_nodes_of_the_file(tmp_path):
    """Foot at rest, eye as the body that goes with it but for products of turns of 20 urad."""
    model = arm_with(tmp_path)
    found = find_modes(compile_model(model, "still"), count=6)
    places, shape = node_shapes(model, found)["arm"]
    assert places.shape == (5, 3)
    assert shape.shape == (6, 5, 3)
    np.testing.assert_allclose(places[:, 0], np.linspace(0.0, LENGTH, 5), atol=1e-5)
    eye = found.damped_body_shape[:, found.bodies.index("arm.eye"), :3]
    size = np.abs(eye).max()
    np.testing.assert_allclose(shape[:, 4], eye, atol=2e-6 * size)
    np.testing.assert_allclose(shape[:, 0], 0.0, atol=1e-6 * size)
    file = tmp_path / "modes.json"
    assert run_command(["modes", str(tmp_path / "arm.yaml"), "--count", "3", "--animation", str(file)]) == 0
    told = json.loads(file.read_text(encoding="utf-8"))
    assert np.shape(told["nodes"]["arm"]["motion"]) == (3, 24, 5, 3)
    assert told["nodes"]["arm"]["number"] == [0, 1, 2, 3, 4]
    assert "of nodes: mode" in told["about"]
    assert run_command(["modes", str(tmp_path / "arm.yaml"), "--animation", str(tmp_path / "m.npz")]) == 0
    with np.load(tmp_path / "m.npz") as arrays:
        motion = arrays["node_motion[arm]"]
        bodies = list(arrays["bodies"])
        np.testing.assert_allclose(
            motion[:, :, 4], arrays["motion"][:, :, bodies.index("arm.eye"), :3], atol=1e-5 * 0.01
        )


@pytest.mark.parametrize("spin", ["0 rad", "1 rad"])
def test_nodes_of_a_tilted_body_move_as_its_bodies_do(tmp_path, spin):
    """A rotor turned by a radian and a frame askew: every named node agrees."""
    text = ARM.replace(
        "axes: {z: [1, 0, 0], x: [0, 1, 0]}", "axes: {z: [1, 2, 2], x: [0, 1, -1]}\n    rotor: true"
    )
    text = text.replace("position: [0.3, 0, 0]}", "position: [0.1, 0.2, 0.2]}").replace(
        "housing: arm.eye, ", ""
    )
    text = text.replace(
        "  clamp: {type: fixed, bodies: [ground, arm.foot]}", "  pin: {type: fixed, bodies: [arm.eye, disc]}"
    )
    text = text.replace(
        "bodies:\n", "bodies:\n  disc: {mass: 1 kg, inertia_tensor: [1e-3, 1e-3, 1e-3, 0, 0, 0]}\n", 1
    )
    model = arm_with(tmp_path, text)
    system = compile_model(model, "still")
    start = system.initial_state()
    start.q[system.layout.coordinate("arm.spin")] = float(spin.split()[0])
    found = find_modes(system, "still", count=12, start=start)
    places, shape = node_shapes(model, found)["arm"]
    assert found.state.q[found.coordinates.index("arm.spin")] == pytest.approx(
        float(spin.split()[0]), abs=1e-3
    )
    for word, node in (("foot", 0), ("eye", 4)):
        k = found.bodies.index(f"arm.{word}")
        np.testing.assert_allclose(places[node], found.place[k], atol=1e-9)
        wanted = found.damped_body_shape[:, k, :3]
        np.testing.assert_allclose(shape[:, node], wanted, atol=1e-6 * np.abs(wanted).max())


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("housing: arm.eye", "housing: arm", "names the elastic body arm, without a node"),
        ("housing: arm.eye", "housing: arm.eyes", "did you mean eye?"),
        ("housing: arm.eye", "housing: shaft", "is the body that runs in the bearing"),
        ("housing: arm.eye", "housing: arm.foot", "bearings.eye.housing: is 300 mm away from the bearing"),
        ("tilt: 4e4}", "tilt: 4e4, torsion: 1}", "constrains the spin of shaft relative to the housing arm"),
        ("{body: shaft, housing: arm.eye", "{body: arm", "give housing: arm.foot or arm.eye"),
    ],
)
def test_wrong_housings_are_told(tmp_path, old, new, words):
    assert ARM.count(old) == 1
    with pytest.raises(ModelError) as error:
        arm_with(tmp_path, ARM.replace(old, new))
    told = [f"{p.where}: {p.text} {p.remedy}" for p in error.value.problems]
    assert any(words in t for t in told), told
    assert all(p.line for p in error.value.problems)
