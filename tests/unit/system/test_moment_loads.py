# SPDX-License-Identifier: Apache-2.0
"""Moments of `loads`: bearing forces by hand, a couple of forces, markers, bodies that do not tilt."""

from __future__ import annotations

import numpy as np
import pytest

import pitchpoint
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.collect import remarks_of
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system.compile import compile_model

L = 0.4
SHAFT = """
bodies:
  rotor: {{mass: 20 kg, inertia: 0.3 kg m^2, transverse_inertia: 0.2 kg m^2, motion: free,
    position: [0, 0, 0],
    axes: {{z: [{axis}]}}{markers}}}
bearings:
  a: {{body: rotor, stiffness: {{radial: 1e8 N/m, axial: 1e8 N/m, torsion: 1e4 N m/rad}}}}
  b: {{body: rotor, position: [0, 0, 400 mm], stiffness: {{radial: 1e8 N/m}}}}
loads:
  {load}
"""


def written(load, axis="0, 0, 1"):
    """Model file with one load, and with a marker if the load names it."""
    markers = ", markers: {tip: {position: [0, 0, 100 mm]}}" if "tip" in load else ""
    return SHAFT.format(load=load, axis=axis, markers=markers)


def bearing_forces(load, axis="0, 0, 1"):
    """Radial forces of both bearings [N], shape (2, 2)."""
    model = loads_model(written(load, axis))
    found = solve_equilibrium(compile_model(model))
    return np.array([[float(found[f"bearing_force[{b}.{k}]"]) for k in ("fx", "fy")] for b in "ab"])


@pytest.mark.parametrize("where", ["", "marker: tip, ", "marker: tip, along: marker, "])
def test_a_bending_moment_is_taken_by_the_bearings(where):
    """Balance of moments about a, M e_x + l e_z x F_b = 0: F_b = M/l along y, and F_a = -F_b."""
    found = bearing_forces(f"hub: {{body: rotor, {where}moment: [80 N m, 0, 0]}}")
    assert found == pytest.approx(np.array([[0.0, -80 / L], [0.0, 80 / L]]), abs=1e-3)


def test_a_moment_is_a_couple_of_forces():
    moment = bearing_forces("hub: {body: rotor, moment: [30 N m, -50 N m, 0]}")
    couple = bearing_forces(
        "up: {body: rotor, position: [0, 0, 500 mm], force: [-100 N, -60 N, 0]}\n"
        "  down: {body: rotor, position: [0, 0, 0], force: [100 N, 60 N, 0]}"
    )
    assert moment == pytest.approx(couple, abs=1e-3)


def test_a_moment_is_along_the_axes_of_the_world():
    """The shaft along the world's x: a moment about the world's z loads it across, one about x twists it."""
    across = bearing_forces("hub: {body: rotor, moment: [0, 0, 80 N m]}", "1, 0, 0")
    assert np.hypot(*across.T) == pytest.approx([80 / L] * 2, abs=1e-3)
    twist = bearing_forces("hub: {body: rotor, moment: [80 N m, 0, 0]}", "1, 0, 0")
    assert twist == pytest.approx(0.0, abs=1e-6)


def test_a_moment_of_time():

    text = written("hub: {body: rotor, moment: [0, 1 N m * (1 + step(t - 0.01 s)), 0]}")
    damped = text.replace("stiffness", "damping: {ratio: 0.5}, stiffness")
    model = loads_model(f"{damped}scenarios: {{turn: {{duration: 60 ms, step: 20 us, settle_time: 50 ms}}}}")
    run = pitchpoint.solve_time(compile_model(model, "turn"))
    force = run["bearing_force[b.fx]"]
    assert float(force[0]) == pytest.approx(1.0 / -L, rel=1e-6)
    assert float(force[-400:].mean()) == pytest.approx(2.0 / -L, rel=0.02)


@pytest.mark.parametrize(
    ("load", "message"),
    [
        ("hub: {body: rotor}", "has no torque, force or moment"),
        ("hub: {body: rotor, moment: [balance, 0, 0]}", "cannot be balanced"),
        ("hub: {body: rotor, moment: [3 N, 0, 0]}", "N"),
        ("hub: {body: rotor, torque: 3 N m, marker: tip}", "give a force or a moment"),
    ],
)
def test_refused(load, message):
    with pytest.raises(ModelError, match=message):
        loads_model(written(load))


def test_a_moment_across_the_axis_of_a_body_that_only_spins_is_named():
    text = written("hub: {body: rotor, moment: [1 N m, 0, 1 N m]}")
    remarks = [str(m) for m in remarks_of(loads_model(text.replace("motion: free", "motion: torsion")))]
    assert any("loads.hub.moment" in r and "component x has no effect" in r for r in remarks), remarks
    assert not any("component z has no effect" in r for r in remarks)
