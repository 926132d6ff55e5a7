# SPDX-License-Identifier: Apache-2.0
"""Contact of surfaces in space: exact tangents, action and reaction, convergence of triangles."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.contact.impact import set_friction, set_impact
from pitchpoint.elements.point_surface import set_mesh, set_surface
from pitchpoint.elements.surface_surface import (
    set_crossed_cylinders,
    set_cylinder_on_plane,
    set_cylinders_in_line,
    set_mesh_on_shape,
    set_meshes,
    set_ring_on_plane,
)
from pitchpoint.system import evaluate
from tests.support.contacts import ball, box, contact, pair, read, shaken, unmoved
from tests.support.engine import differences
from tests.support.forces import check_balance

BALL = ball(0.05, 2)
BOX = box((0.1, 0.1, 0.1))


def crossed(record):
    """Axis of the first cylinder along x, seen from the second one."""
    record["Bi"] = [[0, 0, 1], [1, 0, 0], [0, 1, 0]]


def ring(record, pool):
    set_ring_on_plane(record, 0.05, 0.01)
    crossed(record)


def cylinder(record, pool):
    set_cylinder_on_plane(record, 0.05, 0.08)
    crossed(record)


def rods(record, pool):
    set_crossed_cylinders(record, (0.01, 0.02), (0.2, 0.3))
    crossed(record)


def rod_ends(record, pool):
    set_crossed_cylinders(record, (0.01, 0.02), (0.2, 0.3))
    crossed(record)


def line(radii, lengths, hollow=False, turn=(0.0, 0.0)):
    """Cylinders in line, the first one turned about x and y of the second one."""

    def setup(record, pool):
        set_cylinders_in_line(record, radii, lengths, hollow)
        (a, b), (c, d) = np.cos(turn), np.sin(turn)
        record["Bi"] = np.array([[1, 0, 0], [0, a, -c], [0, c, a]]) @ [[b, 0, d], [0, 1, 0], [-d, 0, b]]

    return setup


def smooth(record):
    """For parts of a line whose ends move: laws without kinks between them, which quadrature would smear."""
    set_impact(record, 1e8, 2.0, 30.0, 1e-2)
    set_friction(record, 3.0, 2.0, 10.0, 20.0)


def area(record):
    """Law per area."""
    set_impact(record, 1e9, 1.5, 3e4, 1e-3)
    record["depth"] = 2e-3


#: kind, shapes, place of the first body, law
SHAPES = {
    "plane": ("point_surface", lambda r, p: set_surface(r, "plane", (), 0.02), (0.1, 0.2, 0.0195)),
    "point in plane": ("point_surface", lambda r, p: set_surface(r, "plane"), (0.1, 0.2, -0.0005)),
    "sphere": ("point_surface", lambda r, p: set_surface(r, "sphere", 0.03, 0.02), (0.0295, 0.0295, 0.0265)),
    "cup": ("point_surface", lambda r, p: set_surface(r, "sphere", 0.03, 0.02, True), (0.006, 0.006, 0.0061)),
    "cylinder": ("point_surface", lambda r, p: set_surface(r, "cylinder", 0.03, 0.02), (0.03, 0.0395, 0.3)),
    "bore": (
        "point_surface",
        lambda r, p: set_surface(r, "cylinder", 0.03, 0.02, True),
        (0.006, 0.0085, 0.3),
    ),
    "cone": ("point_surface", lambda r, p: set_surface(r, "cone", 0.5, 0.02), (0.03, 0.04, -0.05)),
    "tip of cone": ("point_surface", lambda r, p: set_surface(r, "cone", 0.5, 0.02), (0.003, 0.004, 0.0188)),
    "funnel": (
        "point_surface",
        lambda r, p: set_surface(r, "cone", 0.5, 0.02, True),
        (0.003, 0.004, -0.0503),
    ),
    "torus": ("point_surface", lambda r, p: set_surface(r, "torus", (0.1, 0.03), 0.02), (0.0, 0.1295, 0.04)),
    "groove": (
        "point_surface",
        lambda r, p: set_surface(r, "torus", (0.1, 0.03), 0.02, True),
        (0.0, 0.1063, 0.0083),
    ),
    "ball of triangles": ("point_surface", lambda r, p: set_mesh(r, p, BALL, 0.01), (0.0339, 0.034, 0.0342)),
    "edge of box": ("point_surface", lambda r, p: set_mesh(r, p, BOX, 0.01), (0.0566, 0.0566, 0.01)),
    "corner of box": ("point_surface", lambda r, p: set_mesh(r, p, BOX, 0.01), (0.0553, 0.0552, 0.0554)),
    "point in box": ("point_surface", lambda r, p: set_mesh(r, p, BOX, 0.0), (0.0495, 0.02, 0.01)),
    "ring": ("surface_surface", ring, (0.1, 0.2, 0.0595)),
    "cylinder on plane": ("surface_surface", cylinder, (0.1, 0.2, 0.0495)),
    "tilted cylinder on plane": (
        "surface_surface",
        lambda r, p: (
            cylinder(r, p),
            r.__setitem__("Bi", np.array([[0.02, 0, 1], [1, 0, 0], [0, 1, -0.02]])),
        ),
        (0.1, 0.2, 0.0498),
        smooth,
    ),
    "beside each other": ("surface_surface", line((0.01, 0.02), (0.06, 0.09)), (0.02, 0.0215, 0.01)),
    "askew": (
        "surface_surface",
        line((0.01, 0.02), (0.06, 0.09), turn=(0.3, 0.1)),
        (0.02, 0.0215, 0.01),
        smooth,
    ),
    "in a bore": ("surface_surface", line((0.01, 0.0102), (0.03, 0.05), True), (0.0004, 0.0003, 0.004)),
    "askew in a bore": (
        "surface_surface",
        line((0.01, 0.0102), (0.06, 0.05), True, (0.013, 0.01)),
        (2e-5, 1e-5, 0.003),
        smooth,
    ),
    "out of a bore": (
        "surface_surface",
        line((0.01, 0.0102), (0.03, 0.05), True),
        (0.0004, 0.0003, 0.027),
        smooth,
    ),
    "across an end": (
        "surface_surface",
        line((0.01, 0.02), (0.06, 0.05), turn=(1.5, 0.0)),
        (0.0298, 0.0, 0.0255),
        smooth,
    ),
    "crossed cylinders": ("surface_surface", rods, (0.02, 0.0295, 0.05)),
    "ends of cylinders": ("surface_surface", rod_ends, (0.11, 0.028, 0.05)),
    "boxes": ("surface_surface", lambda r, p: set_meshes(r, p, (BOX, BOX), 2e-3), (0.04, 0.03, 0.0995), area),
    "ball on plane": (
        "surface_surface",
        lambda r, p: set_mesh_on_shape(r, p, BALL, "plane"),
        (0.1, 0.2, 0.0485),
        area,
    ),
    "box on ball": (
        "surface_surface",
        lambda r, p: set_mesh_on_shape(r, p, BOX, "sphere", (0.04,)),
        (0.01, 0.0885, 0.02),
        area,
    ),
    "ball in tube": (
        "surface_surface",
        lambda r, p: set_mesh_on_shape(r, p, BALL, "cylinder", (0.06, 0.1), True),
        (0.008, 0.009, 0.045),
        area,
    ),
    "ball on the edge of a cylinder": (
        "surface_surface",
        lambda r, p: set_mesh_on_shape(r, p, BALL, "cylinder", (0.06, 0.1)),
        (0.06, 0.072, 0.07),
        area,
    ),
    "ball on cone": (
        "surface_surface",
        lambda r, p: set_mesh_on_shape(r, p, BALL, "cone", (0.5,)),
        (0.0, 0.0765, -0.043),
        area,
    ),
    "ball on torus": (
        "surface_surface",
        lambda r, p: set_mesh_on_shape(r, p, BALL, "torus", (0.1, 0.03)),
        (0.0, 0.1, 0.0765),
        area,
    ),
    "balls": (
        "surface_surface",
        lambda r, p: set_meshes(r, p, (BALL, BALL), 2e-3),
        (0.0, 0.06, 0.0775),
        area,
    ),
}
#: Parts of a line in touch: the derivative of an integral differs by the quadrature of eight points from that
#: of its sum; with four, six and eight points the error of "across an end" is 7e-2, 9e-4, 3e-6.
QUADRATURE = {"tilted cylinder on plane": 1e-6, "askew": 1e-6, "across an end": 1e-5}


def build(name, where, seed=3):
    kind, setup, apart, *law = SHAPES[name]
    rng = np.random.default_rng(seed)
    system = pair(kind, contact(kind, setup, *law), apart, rng, where)
    return system, shaken(system, rng), kind


@pytest.mark.parametrize("where", ["free", "ground", "tree"])
@pytest.mark.parametrize("name", SHAPES)
def test_tangents_are_derivatives_of_the_force(name, where):
    """Sliding with friction and damping; the tolerance is that of central differences over 1e-8."""
    system, state, kind = build(name, where)
    assert read(system, state, f"contact_force[{kind}0]") > 0.01
    assert read(system, state, f"friction_force[{kind}0]") > 0.001
    _, D, K = evaluate.linearize(system, state)
    for found, key, step in ((D, "v", 1e-6), (K, "q", 1e-8)):
        wanted = differences(system, state, key, step)
        np.testing.assert_allclose(found, wanted, atol=QUADRATURE.get(name, 2e-7) * np.abs(wanted).max())


@pytest.mark.nojit
@pytest.mark.parametrize("name", ["groove", "edge of box", "ring", "crossed cylinders"])
def test_tangents_without_the_compiler(name):
    test_tangents_are_derivatives_of_the_force(name, "free")


@pytest.mark.parametrize("where", ["free", "ground"])
@pytest.mark.parametrize("name", SHAPES)
def test_action_is_reaction_about_a_common_point(name, where):
    system, state, _ = build(name, where)
    check_balance(system, state)


@pytest.mark.parametrize("name", SHAPES)
def test_power_goes_into_stored_energy_and_stated_loss(name):
    system, state, kind = build(name, "free")
    wrenches = unmoved(system, state)
    power = sum(w @ f["tw"] for w, f in zip(wrenches, system.workspace.fr, strict=True))
    energy = []
    for sign in (1.0, -1.0):
        moved = state.copy()
        moved.q = state.q + sign * 1e-7 * state.v
        energy.append(read(system, moved, f"elastic_energy[{kind}0]"))
    rate = (energy[0] - energy[1]) / 2e-7
    loss = read(system, state, f"contact_power_loss[{kind}0]")
    assert loss > 0.0
    most = 1e-5 * loss if name not in QUADRATURE else 30.0 * QUADRATURE[name] * abs(rate)  # one power more
    assert power + rate + loss == pytest.approx(0.0, abs=most)
