# SPDX-License-Identifier: Apache-2.0
"""Equilibrium of bodies that do not touch at the start: their load closes the gap, however thin the obstacle.

A body slides along one direction with 1 kN against a fixed one; the law is 1 kN at 10 um, linear. With the
angle between the direction and the contact normal n, the normal force is 1 kN/cos and the body moves the gap
along the direction plus 10 um/cos^2.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.model import Model
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.system.compile import compile_model

GAP, DEPTH = 0.05e-3, 10e-6
TAPER = math.radians(20.0)


def pressed(first, second, place, push, gap, axes=None, line=False):
    """One body at `place`, moved back by `gap`, on a slide along `push`; its equilibrium and its system."""
    along = np.array(push, float)
    body = {
        "mass": 1.0,
        "inertia_tensor": [1e-3, 1e-3, 1e-3, 0, 0, 0],
        "position": (np.array(place) - gap * along).tolist(),
        "markers": {"o": {}, "s": {"axes": axes or {"z": [0, 0, 1]}}},
    }
    model = {
        "bodies": {"base": {"motion": "fixed", "position": [0, 0, 0]}, "b": body},
        "joints": {"g": {"type": "prismatic", "bodies": ["ground", "b"], "axes": {"z": along.tolist()}}},
        "surface_contacts": {
            "c": {
                "ends": ["b.s", "base"],
                "first": first,
                "second": second,
                "law": {"force": 1000.0, "depth": DEPTH, "exponent": 1},
                "line": line,
            }
        },
        "loads": {"f": {"body": "b", "marker": "o", "force": (1000.0 * along).tolist()}},
    }
    system = compile_model(Model.from_dict(model))
    return find_equilibrium(system), system


def cylinder(radius, length, **more):
    return {"shape": "cylinder", "radius": radius, "length": length, **more}


BALL = {"shape": "sphere", "radius": 0.01}
TORUS = {"shape": "torus", "radius": 0.05, "tube": 0.005}
CONE = {"shape": "cone", "half_angle": TAPER, "length": 0.08}
BORE = cylinder(0.01, 0.1, hollow=True)
SIDE = 0.04 * math.tan(TAPER) + 0.01 / math.cos(TAPER)
# first, second, place where they touch, direction of the load, cosine to the normal, axes, line
PAIRS = {
    "crossed cylinders": (
        cylinder(0.007, 0.2),
        cylinder(0.012, 0.2),
        (0, 0.019, 0),
        (0, -1, 0),
        1.0,
        {"z": [1, 0, 0]},
        False,
    ),
    "parallel cylinders": (
        cylinder(0.007, 0.03),
        cylinder(0.012, 0.2),
        (0, 0.019, 0),
        (0, -1, 0),
        1.0,
        None,
        True,
    ),
    "cylinder in a bore": (cylinder(0.0098, 0.03), BORE, (0.0002, 0, 0), (1, 0, 0), 1.0, None, False),
    "ball on a cone": (BALL, CONE, (SIDE, 0, -0.04), (-1, 0, 0), math.cos(TAPER), None, False),
    "ball on a torus": (BALL, TORUS, (0.05, 0, 0.015), (0, 0, -1), 1.0, None, False),
    "ring on a cylinder": (
        {"shape": "torus", "radius": 0.03, "tube": 0.002},
        cylinder(0.01, 0.2),
        (0, -0.018, 0),
        (0, -1, 0),
        1.0,
        None,
        False,
    ),
    "ball on a plane": (BALL, {"shape": "plane"}, (0, 0, 0.01), (0, 0, -1), 1.0, None, False),
}


@pytest.mark.parametrize("gap", [-1e-6, 0.0, GAP, 5e-3])
@pytest.mark.parametrize("pair", PAIRS)
def test_a_load_closes_the_gap(pair, gap):
    first, second, place, push, cosine, axes, line = PAIRS[pair]
    if pair == "cylinder in a bore":
        gap = min(gap, 2e-4)  # from the axis of the bore
    found, system = pressed(first, second, place, push, gap, axes, line)
    assert found.state.q[0] == pytest.approx(gap + DEPTH / cosine**2, rel=1e-6)
    values = dict(zip((c.name for c in system.layout.channels), found.observe(system), strict=True))
    assert values["contact_force[c]"] == pytest.approx(1000.0 / cosine, rel=1e-6)


def test_an_open_contact_that_the_load_does_not_close_is_named():
    first, second, place, push, _, axes, line = PAIRS["crossed cylinders"]
    away = tuple(-x for x in push)
    with pytest.raises(SolverError, match=r"surface_contacts\.c is open by 50 µm"):
        pressed(first, second, place, away, -GAP, axes, line)


def test_a_ball_slides_far_while_it_touches():
    """200 N against 1 N/mm: the ball moves 200 mm along the plane, at a penetration of 10 nm under 1 N."""
    text = """
title: ball drawn touching a plane
bodies:
  base: {motion: fixed, position: [0, 0, 0]}
  b: {mass: 1 kg, inertia_tensor: [1e-3, 1e-3, 1e-3, 0, 0, 0], position: [0, 0, 10 mm], markers: {o: {}}}
joints: {g: {type: free, bodies: [ground, b]}}
bushings: {k: {ends: [b, ground], stiffness: {tilt: 10 N m/rad, torsion: 10 N m/rad, radial: 1 N/mm}}}
surface_contacts:
  c: {ends: [b, base], first: {shape: sphere, radius: 10 mm}, second: {shape: plane},
    law: {force: 1 kN, depth: 1 um, exponent: 1.5}}
loads: {f: {body: b, marker: o, force: [200 N, 0, -1 N]}}
"""
    found = find_equilibrium(compile_model(loads_model(text)))
    np.testing.assert_allclose(found.state.q[:3], [0.2, 0.0, -1e-8], rtol=1e-6, atol=1e-12)
    assert found.iterations < 50
