# SPDX-License-Identifier: Apache-2.0
"""Couplings of bodies on inclined axes: no torque and no power is lost, and the stiffness is symmetric."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.frames import body_frame
from pitchpoint.multibody.bodies import FREE, Body
from pitchpoint.solvers.modal import solve_modal
from pitchpoint.solvers.time import solve_time
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.system import assemble
from tests.invariants.test_tangents import compare, shaken
from tests.support.engine import bearings

TWO = """
title: two discs on inclined axes
bodies:
  s: {{inertia: 1 kg m^2, axes: {{z: [1, 0, 0], x: [0, 1, 0]}}{more}}}
  generator: {{inertia: 1 kg m^2{axes}}}
couplings:
  c: {{bodies: [{ends}], stiffness: {{torsion: 1e5 N m/rad}}, damping: {{torsion: 5 N m s/rad}}{place}}}
loads:
  motor: {{body: s, torque: 100 N m}}
  gen: {{body: generator, torque: balance}}
scenarios:
  r: {{speed: {{s: 600 rpm}}, duration: 20 ms, step: 0.1 ms}}
"""


def two(
    angle: float | None, ends: str = "s, generator", place: str = "", more: str = "", **other: str
) -> str:
    """Model file with the z axis of the generator at an angle [deg] from that of s; None: not given."""
    c, s = (0.0, 0.0) if angle is None else (math.cos(math.radians(angle)), math.sin(math.radians(angle)))
    axes = "" if angle is None else f", axes: {{z: [{c:.12f}, 0, {s:.12f}]}}"
    return TWO.format(axes=axes + other.get("generator", ""), ends=ends, place=place, more=more)


@pytest.mark.parametrize("angle", [None, 0.0, 5.0, -45.0])
@pytest.mark.parametrize("ends", ["s, generator", "generator, s"])
def test_the_balancing_torque_is_that_of_the_motor_at_any_angle(angle: float | None, ends: str) -> None:
    system = compile_model(loads_model(two(angle, ends)), "r")
    found = solve_time(system)
    power = found["torque[motor]"] * found["speed[s]"] + found["torque[gen]"] * found["speed[generator]"]
    assert abs(power).max() < 1e-6 * 100.0 * 62.8
    assert float(found["torque[gen]"][-1]) == pytest.approx(-100.0, rel=1e-6)
    # two discs on a torsion spring: sqrt(2 k / J) / 2 pi
    modes = solve_modal(system)
    np.testing.assert_allclose(
        modes["undamped_frequency"], [0.0, math.sqrt(2e5) / math.tau], rtol=1e-6, atol=1e-3
    )
    _, _, K = evaluate.linearize(system, system.initial_state())
    np.testing.assert_allclose(K, 1e5 * np.array([[1, -1], [-1, 1]]), rtol=1e-9)


@pytest.mark.parametrize("angle", [60.0, 90.0, 180.0])
def test_larger_angles_are_refused(angle: float) -> None:
    with pytest.raises(ModelError) as caught:
        loads_model(two(angle))
    (problem,) = caught.value.problems
    assert (problem.where, problem.value, problem.limit) == (
        "couplings.c.bodies",
        "s and generator",
        "45 deg",
    )
    assert f"have z axes {angle:g} deg apart" in problem.text
    assert ("reverse the z axis" if angle == 180.0 else "the same z axis") in str(problem.remedy)


def test_a_fixed_body_keeps_the_axes_of_the_world() -> None:
    text = two(None, generator=", motion: fixed").replace("  gen: {body: generator, torque: balance}\n", "")
    with pytest.raises(ModelError, match="torsion_springs with s only"):
        loads_model(text)


def test_a_body_is_at_its_coupling_with_the_axes_of_the_other() -> None:
    model = loads_model(two(None, place=", position: [0, 0, 700 mm]", more=", position: [1, 2, 3]"))
    origin, axes = body_frame(model, "generator")
    np.testing.assert_allclose(origin, [1.7, 2.0, 3.0])
    np.testing.assert_allclose(axes, body_frame(model, "s")[1])
    # the first body from the second one
    back = loads_model(two(None, "generator, s", ", position: [0, 0, 700 mm]", ", position: [1, 2, 3]"))
    np.testing.assert_allclose(body_frame(back, "generator")[0], [0.3, 2.0, 3.0])


def inclined(angle: float) -> tuple[np.ndarray, np.ndarray]:
    """Axes of two bodies."""
    c, s = math.cos(angle), math.sin(angle)
    return np.eye(3), np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])


@pytest.mark.nojit
@pytest.mark.parametrize("angle", [0.0, 0.3, 0.78])
def test_the_exact_tangent_under_torque_is_the_derivative(angle: float) -> None:
    """Full freedom of both bodies, at speed, with a preload about the axis."""
    rng = np.random.default_rng(3)
    bodies = [
        Body(motion=FREE, mass=2.0, polar_inertia=0.01, transverse_inertia=0.02, axes=axes, name=name)
        for name, axes in zip("ab", inclined(angle), strict=True)
    ]
    K, D = np.zeros((6, 6)), np.zeros((6, 6))
    K[5, 5], D[5, 5] = 1e4, 10.0
    records = bearings([(1, 2, K, D)])
    records["u0"][:, 5] = 0.05
    system = assemble(bodies, {"bearing": records})
    compare(system, shaken(system, rng, 100.0), 1e-7)
    # nothing is lost to the ground: the moments on both bodies are opposite
    state = system.initial_state()
    evaluate.residual(system, state)
    moments = [f["F"][3:] for f in system.workspace.fr[1:3]]
    np.testing.assert_allclose(moments[0], -moments[1], atol=1e-9)
    for axes, moment, sign in zip(inclined(angle), moments, (1.0, -1.0), strict=True):
        assert moment @ axes[:, 2] == pytest.approx(sign * 1e4 * 0.05)
