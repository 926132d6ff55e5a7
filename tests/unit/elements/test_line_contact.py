# SPDX-License-Identifier: Apache-2.0
"""Contact along lines: cylinders on planes, beside cylinders and in bores, straight, tilted and crossed.

The reference is written anew: points of one axis, their distance from the other cylinder by vector products,
the law of the lamina model over that, and SciPy's integral along the axis.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from pitchpoint.contact.impact import set_impact
from pitchpoint.elements.contacts.record import new_records, set_marker
from pitchpoint.elements.surface_surface import set_cylinder_on_plane, set_cylinders_in_line
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import FLOATING
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.contacts import read

K = 1e7
"""Stiffness of the whole line [N/m^e]."""
PALMGREN = 10.0 / 9.0


def wrench(setup, position, axes, exponent=1.0, name="contact_force"):
    """Force and moment about its origin on the first cylinder, the second one on ground, and a result."""
    records = new_records(1)
    records["i"] = 1
    setup(records[0])
    set_impact(records[0], K, exponent)
    body = Body(motion=FLOATING, position=position, axes=axes, mass=1.0, inertia=np.eye(3), name="a")
    system = assemble([body], {"surface_surface": records})
    state = system.initial_state()
    found = read(system, state, f"{name}[surface_surface0]")
    evaluate.residual(system, state)
    return system.workspace.fr[1]["F"].copy(), found


def about(axis, angle):
    """Turn about a coordinate axis."""
    c, s = math.cos(angle), math.sin(angle)
    a, b = (axis + 1) % 3, (axis + 2) % 3
    R = np.eye(3)
    R[a, a] = R[b, b] = c
    R[a, b], R[b, a] = -s, s
    return R


def gap(x, position, axis, radii, length, sense):
    """Gap of the slice at x of the first cylinder against the second one, along z from -length/2 on."""
    p = np.asarray(position) + x * np.asarray(axis)
    side = sense * (np.linalg.norm(np.cross(p, (0.0, 0.0, 1.0))) - radii[1])
    beyond = abs(p[2]) - 0.5 * length
    if side > 0.0 and beyond > 0.0:
        return math.hypot(side, beyond) - radii[0]
    return max(side, beyond) - radii[0]


def reference(position, axis, radii, lengths, sense, exponent):
    """Force along -x and its moment about y of the whole line, by adaptive integration."""
    half = 0.5 * lengths[0]
    x = np.linspace(-half, half, 2001)
    gaps = np.array([gap(s, position, axis, radii, lengths[1], sense) for s in x])
    args = (position, axis, radii, lengths[1], sense)
    edges = [-half, half]
    edges += [brentq(gap, x[k], x[k + 1], args, 1e-15) for k in np.flatnonzero(np.diff(np.sign(gaps)))]
    edges += [(s * 0.5 * lengths[1] - position[2]) / axis[2] for s in (-1, 1) if abs(axis[2]) > 1e-9]
    edges = np.unique(np.clip(edges, -half, half))

    def law(s, power):
        return max(0.0, -gap(s, *args)) ** exponent * s**power

    shared = min(lengths)
    return [
        K
        / shared
        * sum(
            quad(law, a, b, (power,), epsabs=1e-18, epsrel=1e-12)[0]
            for a, b in zip(edges[:-1], edges[1:], strict=True)
        )
        for power in (0, 1)
    ]


def test_parallel_cylinders_press_like_the_law():
    """The whole line with one overlap: N = K u^e through the middle, without moment."""
    radii, lengths, u = (0.01, 0.03), (0.03, 0.05), 8e-6
    for sense in (1.0, -1.0):
        apart = radii[1] + sense * (radii[0] - u) if sense > 0 else radii[1] - radii[0] + u

        def setup(record, hollow=sense < 0.0):
            set_cylinders_in_line(record, radii, lengths, hollow)

        F, N = wrench(setup, (apart, 0, 0), np.eye(3), PALMGREN)
        assert pytest.approx(K * u**PALMGREN, rel=1e-9) == N  # 1e-9: the overlap is a difference of 0.04 m
        assert F[0] == pytest.approx(sense * N, rel=1e-12)
        np.testing.assert_allclose(F[1:], 0.0, atol=1e-12 * N)


def test_half_of_the_line_carries_half():
    """A plunger half out of its bore; its edge takes over sqrt(2 r u), where an edge still overlaps.

    Over that the overlap falls like a parabola: a third of K/L u s_0 for the linear law... times two.
    """
    radii, lengths, u = (0.01, 0.0101), (0.04, 0.04), 2e-6
    F, N = wrench(lambda r: set_cylinders_in_line(r, radii, lengths, True), (1e-4 + u, 0, 0.02), np.eye(3))
    edge = math.sqrt(2.0 * radii[0] * u)
    assert pytest.approx(K * u * (0.5 + 2.0 / 3.0 * edge / lengths[0]), rel=1e-4) == N
    assert F[4] == pytest.approx(N * 0.01, rel=2e-2)  # its middle is 10 mm below that of the plunger
    assert F[2] > 0.0  # the edge pushes it out: more overlap is stored energy


CASES = {
    "tilted": ((0.01, 0.03), (0.03, 0.05), 1.0, about(1, 2e-4), 5e-6),
    "tilted and partly lifted": ((0.01, 0.03), (0.03, 0.05), 1.0, about(1, 1e-3), 5e-6),
    "skewed": ((0.01, 0.03), (0.03, 0.05), 1.0, about(0, 0.01), 5e-6),
    "crossed": ((0.01, 0.03), (0.03, 0.05), 1.0, about(0, 0.5 * math.pi), 2e-5),
    "over the end": ((0.01, 0.03), (0.03, 0.02), 1.0, about(1, 3e-4), 1e-5),
    "in a bore": ((0.01, 0.0101), (0.03, 0.05), -1.0, about(1, 2e-4), 5e-6),
    "askew in a bore": ((0.01, 0.0101), (0.03, 0.05), -1.0, about(1, 8e-3), 5e-6),
    "askew in a short bore": ((0.01, 0.0101), (0.05, 0.03), -1.0, about(1, 8e-3), 5e-6),
}


@pytest.mark.nojit
@pytest.mark.parametrize("exponent", [1.0, PALMGREN, 1.5])
@pytest.mark.parametrize("case", CASES)
def test_forces_and_moments_are_integrals(case, exponent):
    """Against adaptive integration of the same law: 1e-6 for eight points a part; 3e-6 for the power 10/9.

    The normal turns with the tilt: force and moment are compared in sum and in the plane of the tilt.
    """
    radii, lengths, sense, axes, u = CASES[case]
    apart = radii[0] + radii[1] - u if sense > 0.0 else radii[1] - radii[0] + u
    position = np.array([apart, 0.0, 0.003])
    if "askew" in case:
        position[0] = 0.0  # both ends touch, on opposite sides

    def setup(record):
        set_cylinders_in_line(record, radii, lengths, sense < 0.0)

    F, N = wrench(setup, position, axes, exponent)
    force, moment = reference(position, axes[:, 2], radii, lengths, sense, exponent)
    tolerance = 3e-6 if exponent == PALMGREN else 1e-6
    assert force > 0.0
    assert pytest.approx(force, rel=tolerance) == N
    if case in ("tilted", "tilted and partly lifted", "in a bore"):
        # the force acts along x right to the square of the tilt, the moment has the arm of the slice besides
        assert F[4] == pytest.approx(sense * moment, rel=1e-4, abs=1e-6 * force)


def test_a_tilted_line_has_the_moment_of_a_layer_of_springs():
    """Linear law: N = K u and M = K tan(t) L^2/12 while all of it touches; K u^2/(2 L tan t) at one end."""
    length, u = 0.08, 4e-5
    for tilt in (2e-4, 4e-3):

        def setup(record):
            set_cylinder_on_plane(record, 0.05, length)
            set_marker(record, "i", (0, 0, 0), [[0, 0, 1], [1, 0, 0], [0, 1, 0]])  # along x

        deep = u + length / 2 * math.sin(tilt) if tilt > 1e-3 else u
        middle = 0.05 * math.cos(tilt) - deep
        if tilt > 1e-3:  # the lower end is u deep
            middle = 0.05 * math.cos(tilt) + length / 2 * math.sin(tilt) - u
        F, N = wrench(setup, (0, 0, middle), about(1, tilt))
        if tilt < 1e-3:
            assert pytest.approx(K * u, rel=1e-12) == N
            about_line = F[4] - N * 0.05 * math.sin(tilt)
            assert about_line == pytest.approx(
                -K * math.sin(tilt) * math.cos(tilt) * length**2 / 12, rel=1e-9
            )
        else:
            assert pytest.approx(K * u * u / (2.0 * length * math.sin(tilt)), rel=1e-9) == N


def test_crossed_lines_grow_like_points():
    """At a right angle the part in touch has the half length sqrt(2 d u): 4/3 K/L u sqrt(2 d u)."""
    radii, lengths = (0.01, 0.03), (0.03, 0.05)
    axes = about(0, 0.5 * math.pi)
    force = []
    for u in (1e-6, 4e-6):
        position = (sum(radii) - u, 0, 0)
        _, N = wrench(lambda r: set_cylinders_in_line(r, radii, lengths), position, axes)
        force.append(N)
        wanted = 4.0 / 3.0 * K / lengths[0] * u * math.sqrt(2.0 * sum(radii) * u)
        assert pytest.approx(wanted, rel=1e-4) == N  # u/d is left out
    assert force[1] / force[0] == pytest.approx(8.0, rel=1e-4)


def test_from_parallel_to_crossed_without_a_jump():
    """The force falls steadily with the angle; no step is larger than those beside it let expect."""
    radii, lengths, u = (0.01, 0.03), (0.03, 0.05), 1e-5
    angles = np.concatenate([[0.0], np.geomspace(1e-13, 0.5 * math.pi, 400)])
    force = np.array(
        [
            wrench(
                lambda r: set_cylinders_in_line(r, radii, lengths),
                (sum(radii) - u, 0, 0.001),
                about(0, a),
                1.5,
            )[1]
            for a in angles
        ]
    )
    assert force[0] == pytest.approx(K * u**1.5, rel=1e-9)
    assert np.all(np.diff(force) <= 1e-9 * force[0])
    assert np.abs(np.diff(force)).max() < 0.07 * force[0]  # 8 % in angle from one to the next


def test_sizes_are_checked():
    record = new_records(1)[0]
    with pytest.raises(ValueError, match="in a bore"):
        set_cylinders_in_line(record, (0.02, 0.02), (0.1, 0.1), True)
    with pytest.raises(ValueError, match="above 0"):
        set_cylinders_in_line(record, (0.02, 0.0), (0.1, 0.1))
    with pytest.raises(ValueError, match="1 to 8"):
        set_cylinder_on_plane(record, 0.02, 0.1, 9)
