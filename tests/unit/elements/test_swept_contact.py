# SPDX-License-Identifier: Apache-2.0
"""Rings and cones on curved surfaces: gaps against minimisation over both surfaces, tangents, power."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import minimize

from pitchpoint.core.errors import ModelError
from pitchpoint.elements.surface_surface import (
    set_cone_on_plane,
    set_cone_on_surface,
    set_ring_on_surface,
)
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.contacts import contact, pair, read, shaken, unmoved
from tests.support.engine import differences
from tests.support.forces import check_balance

RING, CONE = (0.05, 0.01), (0.45, 0.08)
KIND = "surface_surface"
CROSSED = np.array([[0, 0, 1], [1, 0, 0], [0, 1, 0]], float)
"""Axis of the first body along x of the second one."""


def turned(a, b):
    """Axes turned by a about x, then by b about y."""
    one = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
    return np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]]) @ one


# skeletons (points of a curve or flank by parameters, with their limits) and the radius around them
def ring(R, tube):
    return lambda u: np.array([R * np.cos(u[0]), R * np.sin(u[0]), 0.0]), [(0.0, 2.0 * np.pi)], tube


def rod(r, length):
    return lambda u: np.array([0.0, 0.0, u[0]]), [(-0.5 * length, 0.5 * length)], r


def flank(half, height):
    def point(u):
        rho = u[0] * np.tan(half)
        return np.array([rho * np.cos(u[1]), rho * np.sin(u[1]), -u[0]])

    return point, [(0.0, height), (-np.pi, 3.0 * np.pi)], 0.0


def least_distance(one, two, place, axes):
    """Smallest distance of two separated bodies, by minimisation from many starting points."""
    (p, limits_p, r_p), (q, limits_q, r_q) = one, two
    limits = limits_p + limits_q
    n = len(limits_p)

    def apart(u):
        return np.linalg.norm(place + axes @ p(u[:n]) - q(u[n:]))

    lo, hi = np.transpose(limits)
    tried = lo + (hi - lo) * np.random.default_rng(0).random((4000, lo.size))
    found = []
    for start in sorted(tried, key=apart)[:8]:
        done = minimize(apart, start, bounds=limits, options={"ftol": 1e-16, "gtol": 1e-12})
        found.append(done.fun)
    return min(found) - r_p - r_q


# name: setup, skeletons of both bodies, axes of the first one, its place off a gap of the first entry
PAIRS = {
    "ring on cylinder": (lambda r, p: set_ring_on_surface(r, RING, "cylinder", (0.02,)), ring(*RING),
                         rod(0.02, 1.0), turned(0.2, 1.3), (1.0, 0.1, 0.2)),
    "ring beside cylinder": (lambda r, p: set_ring_on_surface(r, RING, "cylinder", (0.02,)), ring(*RING),
                             rod(0.02, 1.0), turned(0.3, 0.2), (1.0, 0.4, 0.2)),
    "ring on cone": (lambda r, p: set_ring_on_surface(r, RING, "cone", (0.45,)), ring(*RING),
                     flank(0.45, 0.6), turned(0.4, 0.9), (1.0, -0.3, 0.1)),
    "rings": (lambda r, p: set_ring_on_surface(r, RING, "torus", (0.06, 0.012)), ring(*RING),
              ring(0.06, 0.012), turned(0.5, 1.2), (1.0, 0.4, 0.3)),
    "cone on cylinder": (lambda r, p: set_cone_on_surface(r, *CONE, "cylinder", (0.02,)), flank(*CONE),
                         rod(0.02, 1.0), turned(0.3, 1.4), (-0.3, 1.0, 0.2)),
    "edge of cone on cylinder": (lambda r, p: set_cone_on_surface(r, *CONE, "cylinder", (0.02,)),
                                 flank(*CONE), rod(0.02, 1.0), turned(0.2, 1.8), (1.0, 0.2, 0.1)),
    "tip of cone on cylinder": (lambda r, p: set_cone_on_surface(r, *CONE, "cylinder", (0.02,)),
                                flank(*CONE), rod(0.02, 1.0), turned(0.3, -1.5), (1.0, 0.1, 0.3)),
    "cones": (lambda r, p: set_cone_on_surface(r, *CONE, "cone", (0.3,)), flank(*CONE), flank(0.3, 0.8),
              turned(0.9, 0.7), (1.0, 0.7, 0.1)),
}  # fmt: skip


def system_of(name, place, seed=3, where="free"):
    setup, _, _, axes, _ = PAIRS[name]

    def whole(record, pool):
        setup(record, pool)
        record["Bi"] = axes

    rng = np.random.default_rng(seed)
    system = pair(KIND, contact(KIND, whole), place, rng, where)
    return system, shaken(system, rng)


BASE = {"ring on cone": (0.0, 0.0, -0.2), "cones": (0.0, 0.0, -0.3)}
"""Starting point of the way, for cones below their tip."""


def gap_of(system):
    return read(system, system.initial_state(), f"gap[{KIND}0]")


def placed(name, gap):
    """Place of the first body in axes of the second one at which the element has a given gap."""
    way = np.array(PAIRS[name][4]) / np.linalg.norm(PAIRS[name][4])
    base = np.array(BASE.get(name, (0.0, 0.0, 0.0)))
    lo, hi = 0.02, 0.4
    for _ in range(30):
        middle = 0.5 * (lo + hi)
        lo, hi = (middle, hi) if gap_of(system_of(name, base + middle * way)[0]) < gap else (lo, middle)
    return base + hi * way


@pytest.mark.parametrize("name", PAIRS)
def test_the_gap_is_the_least_distance_of_the_surfaces(name):
    """1e-8: the minimisation of scipy, which starts from points all over both surfaces."""
    _, one, two, axes, _ = PAIRS[name]
    place = placed(name, 2e-3)
    assert least_distance(one, two, place, axes) == pytest.approx(gap_of(system_of(name, place)[0]), abs=1e-8)


@pytest.mark.parametrize("name", PAIRS)
def test_tangents_balance_and_power(name):
    """Sliding with friction and damping, 0.6 mm deep."""
    check_contact(*system_of(name, placed(name, -6e-4)))


def check_contact(system, state):
    """Balance of forces and moments, tangents against differences, power against energy and losses."""
    assert read(system, state, f"contact_force[{KIND}0]") > 0.01
    check_balance(system, state)
    _, D, K = evaluate.linearize(system, state)
    for found, key, step in ((D, "v", 1e-6), (K, "q", 1e-8)):
        wanted = differences(system, state, key, step)
        np.testing.assert_allclose(found, wanted, atol=1e-6 * np.abs(wanted).max())
    wrenches = unmoved(system, state)
    power = sum(w @ f["tw"] for w, f in zip(wrenches, system.workspace.fr, strict=True))
    energy = []
    for sign in (1.0, -1.0):
        moved = state.copy()
        moved.q = state.q + sign * 1e-7 * state.v
        energy.append(read(system, moved, f"elastic_energy[{KIND}0]"))
    loss = read(system, state, f"contact_power_loss[{KIND}0]")
    assert loss > 0.0
    assert power + (energy[0] - energy[1]) / 2e-7 + loss == pytest.approx(0.0, abs=1e-5 * loss)


def lying(tilt):
    """Axes of a cone with its flank on the plane, its base raised by an angle."""
    c, s = math.cos(CONE[0] + tilt), math.sin(CONE[0] + tilt)
    return np.array([[s, 0.0, c], [0.0, 1.0, 0.0], [c, 0.0, -s]]) @ np.diag([1.0, -1.0, 1.0])


SEAT = -(RING[0] * math.cos(0.6) + RING[1] - 3e-4) / math.sin(0.6)
# name: setup, axes of the first body and its place: contact along a line or all around, 0.3 mm deep
LINES = {
    "cone on plane": (lambda r, p: set_cone_on_plane(r, *CONE), lying(0.0), (0.0, 0.0, -3e-4)),
    "part of a cone on plane, to its base": (
        lambda r, p: set_cone_on_plane(r, *CONE), lying(-0.006), (0.0, 0.0, 2.5e-4)),
    "part of a cone on plane, to its tip": (
        lambda r, p: set_cone_on_plane(r, *CONE), lying(0.006), (0.0, 0.0, -2.5e-4)),
    "ring in a seat": (
        lambda r, p: set_ring_on_surface(r, RING, "cone", (0.6,), True, True), np.eye(3), (0, 0, SEAT)),
    "ring in a bore": (
        lambda r, p: set_ring_on_surface(r, RING, "cylinder", (0.0597,), True, True), np.eye(3), (0, 0, 0)),
    "ring around a shaft": (
        lambda r, p: set_ring_on_surface(r, RING, "cylinder", (0.0403,), False, True), np.eye(3), (0, 0, 0)),
    "ring around a cone": (
        lambda r, p: set_ring_on_surface(r, RING, "cone", (0.3,), False, True), np.eye(3),
        (0.0, 0.0, -(RING[0] * math.cos(0.3) - RING[1] + 3e-4) / math.sin(0.3))),
    "rings": (
        lambda r, p: set_ring_on_surface(r, RING, "torus", (0.05, 0.012), False, True), np.eye(3),
        (0.0, 0.0, 0.0217)),
}  # fmt: skip


@pytest.mark.parametrize("where", ["free", "ground", "tree"])
@pytest.mark.parametrize("name", LINES)
def test_tangents_balance_and_power_along_a_line(name, where):
    setup, axes, place = LINES[name]

    def whole(record, pool):
        setup(record, pool)
        record["Bi"] = axes

    rng = np.random.default_rng(5)
    system = pair(KIND, contact(KIND, whole), place, rng, where)
    check_contact(system, shaken(system, rng, places=2e-5))


def file(first, second, more="", place="[0, 0, 100 mm]"):
    return f"""
bodies:
  part: {{mass: 1 kg, inertia_tensor: [1e-3, 1e-3, 1e-3, 0, 0, 0], motion: free, position: {place}}}
surface_contacts:
  c: {{ends: [part, ground], first: {first}, second: {second}, law: {{force: 1 kN, depth: 0.1 mm}}{more}}}
"""


SHAPES = {
    "plane": "{shape: plane}",
    "sphere": "{shape: sphere, radius: 10 mm}",
    "cylinder": "{shape: cylinder, radius: 10 mm, length: 50 mm}",
    "cone": "{shape: cone, half_angle: 20 deg, length: 40 mm}",
    "torus": "{shape: torus, radius: 30 mm, tube: 5 mm}",
}


@pytest.mark.parametrize("one", SHAPES)
@pytest.mark.parametrize("two", SHAPES)
def test_every_pair_of_shapes_touches_in_either_order(one, two):
    """The gap does not depend on the order; two planes are refused with a remedy."""
    gaps = []
    for first, second in ((one, two), (two, one)):
        text = file(SHAPES[first], SHAPES[second])
        if one == two == "plane":
            with pytest.raises(ModelError, match="two planes without limits; give the plate"):
                loads_model(text)
            return
        if first == second == "cylinder":
            text = text.replace("position:", "axes: {z: [1, 0, 0]}, position:")
        # the second body of the pair is at the origin in both cases
        if (first, second) != (one, two):
            text = text.replace("ends: [part, ground]", "ends: [ground, part]")
        system = compile_model(loads_model(text))
        found = evaluate.observe(system, system.initial_state())[system.layout.channel("gap[c]")]
        assert np.isfinite(found)
        gaps.append(found)
    assert gaps[1] == pytest.approx(gaps[0], abs=1e-12)


def test_a_cone_lies_on_its_flank_with_its_whole_line():
    """Weight W on the flank of length h/cos(a): equal penetration u along the line, law of the whole line."""
    half, height, depth = 0.3, 0.08, 2e-5
    up = math.cos(half), math.sin(half)  # direction from the base to the tip
    text = file(
        f"{{shape: cone, half_angle: {half} rad, length: {height} m}}",
        "{shape: plane}",
        place=f"[0, 0, {-depth!r}]",
    ).replace("position:", f"axes: {{z: [{up[0]!r}, 0, {-up[1]!r}]}}, position:")
    system = compile_model(loads_model(text))
    state = system.initial_state()
    row = evaluate.observe(system, state)
    assert row[system.layout.channel("gap[c]")] == pytest.approx(-depth, abs=1e-12)
    force = row[system.layout.channel("contact_force[c]")]
    assert force == pytest.approx(1e3 * (depth / 1e-4) ** 1.5, rel=1e-6)


@pytest.mark.parametrize(
    ("first", "second", "words"),
    [
        (
            "cone",
            "{shape: cylinder, radius: 50 mm, hollow: true}",
            "touch at an edge.*torus with a small tube",
        ),
        ("cone", "{shape: cone, half_angle: 30 deg, length: 50 mm, hollow: true}", "touch at an edge"),
        ("cylinder", "{shape: cone, half_angle: 30 deg, length: 50 mm, hollow: true}", "touch at an edge"),
    ],
)
def test_contact_at_an_edge_is_refused_with_its_remedy(first, second, words):
    with pytest.raises(ModelError, match=words):
        loads_model(file(SHAPES[first], second))


def test_a_ring_in_its_seat_carries_all_around():
    """Coaxial ring in a hollow cone, with `line`: the axial force is N sin(a), N of the whole ring."""
    half, tube, ring_radius, depth = 0.6, 0.004, 0.03, 5e-5
    # gap of the ring: -(R cos a + z sin a) - tube = -depth below the tip
    z = -(ring_radius * math.cos(half) + tube - depth) / math.sin(half)
    text = file(
        f"{{shape: torus, radius: {ring_radius} m, tube: {tube} m}}",
        f"{{shape: cone, half_angle: {half} rad, hollow: true}}",
        ", line: true",
        f"[0, 0, {z!r}]",
    )
    system = compile_model(loads_model(text))
    state = system.initial_state()
    row = evaluate.observe(system, state)
    assert row[system.layout.channel("gap[c]")] == pytest.approx(-depth, abs=1e-12)
    evaluate.residual(system, state)
    force = 1e3 * (depth / 1e-4) ** 1.5
    np.testing.assert_allclose(
        system.workspace.fr["F"][1][:3], [0.0, 0.0, -force * np.sin(half)], atol=1e-9 * force
    )
