# SPDX-License-Identifier: Apache-2.0
"""Contact of planar curves: exact tangents, action and reaction, closed forms of cams and involutes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.curve import (
    Curve,
    arc_piece,
    chain,
    circle,
    involute_piece,
    line_piece,
    polygon,
    spline,
)
from pitchpoint.contact.impact import set_friction, set_impact
from pitchpoint.core.errors import SolverError
from pitchpoint.elements.contacts.record import set_marker
from pitchpoint.elements.curve_curve import set_curves
from pitchpoint.elements.point_curve import set_cam
from pitchpoint.system import evaluate
from tests.support.contacts import contact, pair, read, shaken, unmoved
from tests.support.engine import differences
from tests.support.forces import check_balance

ANGLE = np.linspace(0.0, 2.0 * np.pi, 12, endpoint=False)
CAM = spline(
    np.column_stack(
        [(0.05 + 0.01 * np.cos(2 * ANGLE)) * np.cos(ANGLE), (0.04 + 0.01 * np.cos(2 * ANGLE)) * np.sin(ANGLE)]
    )
)
BLOCK = polygon([(0, -0.03), (0.05, -0.03), (0.05, 0.03), (0, 0.03)], 0.004)
ROOF = polygon([(0, 0), (0.05, 0.05), (-0.05, 0.05)])
FLANK = chain([involute_piece(0.05, 0.0, (0.1, 0.6))], False)
OPPOSITE = chain([involute_piece(0.05, math.pi, (0.1, 0.6))], False)

#: kind, shapes, place of the first body in the axes of the second
SHAPES = {
    "roller on cam": ("point_curve", lambda r, p: set_cam(r, p, CAM, 0.01), (0.0695, 0.0, 0.003)),
    "roller lying across": (
        "point_curve",
        lambda r, p: (set_cam(r, p, CAM, 0.01), set_marker(r, "i", (0, 0, 0), np.eye(3)[[1, 2, 0]])),
        (0.0695, 0.0, 0.003),
    ),
    "roller in corner": (
        "point_curve",
        lambda r, p: set_cam(
            r, p, polygon([(0.05, 0.0), (0.0, 0.0), (0.0, 0.05)], closed=False), 0.01, 0.002
        ),
        (0.0097, 0.0096, 0.001),
    ),
    "cam on cam": ("curve_curve", lambda r, p: set_curves(r, p, (CAM, CAM)), (0.1195, 0.002, 0.001)),
    "circles": (
        "curve_curve",
        lambda r, p: set_curves(r, p, (circle(0.05), circle(0.03))),
        (0.0795, 0.001, 0.0),
    ),
    "pin in hole": (
        "curve_curve",
        lambda r, p: set_curves(r, p, (circle(0.03), circle(0.032, hole=True))),
        (0.001, 0.0023, 0.0),
    ),
    "flat on cam": ("curve_curve", lambda r, p: set_curves(r, p, (BLOCK, CAM)), (0.0595, 0.002, 0.0)),
    "cam on flat": ("curve_curve", lambda r, p: set_curves(r, p, (CAM, BLOCK)), (0.1095, 0.002, 0.0)),
    "corner on circle": (
        "curve_curve",
        lambda r, p: set_curves(r, p, (ROOF, circle(0.05))),
        (0.001, 0.0495, 0.0),
    ),
    "circle on corner": (
        "curve_curve",
        lambda r, p: set_curves(r, p, (circle(0.05), ROOF)),
        (0.001, -0.0495, 0.0),
    ),
    "cam on corner": ("curve_curve", lambda r, p: set_curves(r, p, (CAM, ROOF)), (0.001, -0.0295, 0.0)),
    "corner on corner": (
        "curve_curve",
        lambda r, p: set_curves(r, p, (ROOF, polygon([(0, 0), (-0.05, -0.05), (0.05, -0.05)])), 0.01),
        (0.02, -0.0205, 0.0),
    ),
}


def build(name, where, tilt, seed=2):
    kind, setup, apart = SHAPES[name]
    rng = np.random.default_rng(seed)
    system = pair(kind, contact(kind, setup), apart, rng, where)
    state = shaken(system, rng)
    if tilt:
        state.q[-3] += tilt
    return system, state, kind


@pytest.mark.parametrize("tilt", [0.0, 0.02])
@pytest.mark.parametrize("where", ["free", "ground", "tree"])
@pytest.mark.parametrize("name", SHAPES)
def test_tangents_are_derivatives_of_the_force(name, where, tilt):
    """With friction, sliding, damping on its ramp, and out of plane: nothing is frozen.

    The tolerance is that of central differences over 1e-8: 1e-16 of the force of about 10 N over 1e-8.
    """
    system, state, kind = build(name, where, tilt)
    assert read(system, state, f"contact_force[{kind}0]") > 0.01
    assert read(system, state, f"friction_force[{kind}0]") > 0.001
    _, D, K = evaluate.linearize(system, state)
    for found, key, step in ((D, "v", 1e-6), (K, "q", 1e-8)):
        wanted = differences(system, state, key, step)
        np.testing.assert_allclose(found, wanted, atol=1e-7 * np.abs(wanted).max())


@pytest.mark.nojit
@pytest.mark.parametrize("name", ["roller on cam", "cam on cam", "corner on circle"])
def test_tangents_without_the_compiler(name):
    test_tangents_are_derivatives_of_the_force(name, "free", 0.02)


def test_curves_seen_from_the_edge_are_refused():
    system, state, _ = build("cam on cam", "free", 0.0)
    state.q[3] = 1.5
    with pytest.raises(SolverError, match="no possible model"):
        evaluate.residual(system, state)


@pytest.mark.parametrize("where", ["free", "ground"])
@pytest.mark.parametrize("name", SHAPES)
def test_action_is_reaction_about_a_common_point(name, where):
    system, state, _ = build(name, where, 0.02)
    check_balance(system, state)


@pytest.mark.parametrize("name", SHAPES)
def test_power_goes_into_stored_energy_and_stated_loss(name):
    """Power of the wrenches + rate of the energy + loss = 0; the rate by differences along the motion."""
    system, state, kind = build(name, "free", 0.0)
    evaluate.residual(system, state)
    fr = system.workspace.fr
    before = unmoved(system, state)
    power = sum(w @ f["tw"] for w, f in zip(before, fr, strict=True))
    energy = []
    for sign in (1.0, -1.0):
        moved = state.copy()
        moved.q = state.q + sign * 1e-7 * state.v
        energy.append(read(system, moved, f"elastic_energy[{kind}0]"))
    rate = (energy[0] - energy[1]) / 2e-7
    loss = read(system, state, f"contact_power_loss[{kind}0]")
    assert loss > 0.0
    assert power + rate + loss == pytest.approx(0.0, abs=1e-5 * loss)


def test_same_input_same_bits():
    system, state, _ = build("cam on cam", "free", 0.02)
    first = evaluate.residual(system, state)
    other = state.copy()
    other.q = state.q + 0.01
    evaluate.residual(system, other)
    np.testing.assert_array_equal(evaluate.residual(system, state), first)


@pytest.mark.parametrize("name", ["circles", "cam on cam", "flat on cam", "corner on circle", "pin in hole"])
def test_bodies_may_change_places(name):
    """The same contact named the other way round gives the same forces."""
    kind, setup, apart = SHAPES[name]
    found = []
    for swap in (False, True):
        rng = np.random.default_rng(8)
        records, pools = contact(kind, setup)
        if swap:
            r = records[0]
            curves = {}
            for body in "ij":
                start, n = int(r["start_" + body]), int(r["rows_" + body])
                curves[body] = start, n
            for one, other in (("i", "j"), ("j", "i")):
                r["start_" + one], r["rows_" + one] = curves[other]
            rows = pools[kind][r["start_j"] : r["start_j"] + 16 * r["rows_j"]].reshape(-1, 16)
            r["reach"][3:6] = Curve(rows, True).circle()
            r["i"], r["j"] = 2, 1
        system = pair(kind, (records, pools), (*apart[:2], 0.0), rng)
        if swap:
            bank = system.records[kind]
            assert bank["i"] == 2
        state = shaken(system, rng)
        state.q[[3, 4, 9, 10]] = 0.0  # in one plane: a tilted curve is shortened, a cylinder is not
        state.q[8] = state.q[2] = 0.0
        found.append(evaluate.residual(system, state))
    np.testing.assert_allclose(found[1], found[0], atol=1e-9 * np.abs(found[0]).max())


def test_roller_on_an_eccentric_circle_has_the_lift_of_a_crank():
    """Centre of a roller (0.008) in line with the shaft of a circular cam (0.03, eccentricity 0.01).

    The centres keep their distance, so the follower moves as a slider-crank: y = e cos a + sqrt(l^2 - e^2
    sin^2 a), and a force F along y presses with N = F/cos b, sin b = e sin a/l.
    """
    e, radius, roller = 0.01, 0.03, 0.008
    reach = radius + roller
    for a in np.linspace(0.0, 2.0 * np.pi, 13):
        y = e * math.cos(a) + math.sqrt(reach**2 - (e * math.sin(a)) ** 2)
        press = 1e-6

        def shapes(record, pool, a=a):
            set_cam(record, pool, circle(radius, (-e * math.sin(a), e * math.cos(a))), roller)
            set_impact(record, 1e7, 1.0)
            set_friction(record, 0.0, 0.0, 1.0, 2.0)

        system = pair(
            "point_curve", contact("point_curve", shapes), (0.0, y - press, 0.0), np.random.default_rng(1)
        )
        state = system.initial_state()
        cos_b = math.sqrt(1.0 - (e * math.sin(a) / reach) ** 2)
        assert read(system, state, "gap[point_curve0]") == pytest.approx(-press * cos_b, rel=1e-3)
        evaluate.residual(system, state)
        axes = np.asarray(system.bodies[1].axes)
        force = axes.T @ system.workspace.fr[1]["F"][:3]
        assert force[1] / np.linalg.norm(force) == pytest.approx(cos_b, rel=1e-4)  # turned by press/reach
        N = read(system, state, "contact_force[point_curve0]")
        assert force[1] == pytest.approx(N * cos_b, rel=1e-4)


def test_flat_follower_on_an_eccentric_circle():
    """The lift is R + e cos a, and the place of contact on the flat is -e sin a from the middle."""
    e, radius = 0.01, 0.03
    face = chain([polygon([(0.05, 0.0), (-0.05, 0.0)], closed=False).rows[0]], False)
    turned = np.diag([-1.0, -1.0, 1.0])  # material above: walk the face from the left to the right
    for a in np.linspace(0.0, 2.0 * np.pi, 9):

        def shapes(record, pool, a=a):
            center = (-e * math.sin(a), e * math.cos(a))
            set_curves(record, pool, (face, circle(radius, center)), margin=0.1)
            set_marker(record, "i", (0.0, 0.0, 0.0), turned)

        y = radius + e * math.cos(a) - 1e-6
        system = pair("curve_curve", contact("curve_curve", shapes), (0.0, y, 0.0), np.random.default_rng(1))
        state = system.initial_state()
        assert read(system, state, "gap[curve_curve0]") == pytest.approx(-1e-6, abs=1e-15)
        assert read(system, state, "contact_location[curve_curve0.x]") == pytest.approx(
            -e * math.sin(a), abs=1e-12
        )


def test_involutes_press_along_one_line_of_action():
    """Two base circles 0.04 and 0.06 at 0.11: the normal and the overlap are those of a belt between them.

    A flank that turns by x about its own axis moves along the line by r_b x, wherever the flanks touch.
    """
    r1, r2, distance = 0.04, 0.06, 0.11
    alpha = math.acos((r1 + r2) / distance)
    path = distance * math.sin(alpha)
    for share in (0.3, 0.5, 0.7):
        # along the line of action from T1; angle of the base point of each involute from the line of centres
        u1, u2 = share * path / r1, (1.0 - share) * path / r2

        def shapes(record, pool, u1=u1, u2=u2):
            one = chain([involute_piece(r1, 0.0, (1.6, 0.05), -1)], False)
            two = chain([involute_piece(r2, 0.0, (1.6, 0.05), -1)], False)
            set_curves(record, pool, (two, one), depth=1e-3, margin=0.01)
            turn_1 = u1 - alpha + 1e-5 / r1
            turn_2 = math.pi + u2 - alpha
            for body, turn in (("j", turn_1), ("i", turn_2)):
                c, s = math.cos(turn), math.sin(turn)
                set_marker(record, body, (0, 0, 0), [[c, -s, 0], [s, c, 0], [0, 0, 1]])
            set_impact(record, 1e9, 1.0)
            set_friction(record, 0.0, 0.0, 1.0, 2.0)

        system = pair(
            "curve_curve", contact("curve_curve", shapes), (distance, 0, 0), np.random.default_rng(4)
        )
        state = system.initial_state()
        gap = read(system, state, "gap[curve_curve0]")
        assert abs(gap) == pytest.approx(1e-5, rel=1e-9)
        evaluate.residual(system, state)
        axes = np.asarray(system.bodies[1].axes)
        forces = [axes.T @ system.workspace.fr[b]["F"][:3] for b in (1, 2)]
        torque = [(axes.T @ system.workspace.fr[b]["F"][3:])[2] for b in (1, 2)]
        force = np.linalg.norm(forces[0])
        assert force > 0.0
        assert abs(torque[0]) == pytest.approx(r2 * force, rel=1e-9)
        assert abs(torque[1]) == pytest.approx(r1 * force, rel=1e-9)


def gear_outline(z, r_b, alpha, radii, backlash=0.0):
    """Outline of an involute gear with a tooth on the x axis, radial lines and a chord in its spaces.

    The reference circle r_b/cos(alpha) carries teeth of half a pitch, less `backlash` on each flank along the
    base tangent; `radii` are those of root and tip.
    """
    half = math.pi / (2.0 * z) + math.tan(alpha) - alpha - backlash / r_b  # half a tooth at the base circle
    u_a, u_f = math.sqrt((radii[1] / r_b) ** 2 - 1.0), 0.02
    tip = half - (u_a - math.atan(u_a))
    foot = half - (u_f - math.atan(u_f))
    rows = []
    for k in range(z):
        a = 2.0 * math.pi * k / z
        ends = [
            np.array([math.cos(b), math.sin(b)]) for b in (a - foot, a + foot, a + 2.0 * math.pi / z - foot)
        ]
        start = r_b * math.sqrt(1.0 + u_f**2)
        rows += [
            line_piece(radii[0] * ends[0], start * ends[0]),
            involute_piece(r_b, a - half, (u_f, u_a), 1),
            arc_piece((0.0, 0.0), radii[1], a - tip, 2.0 * tip),
            involute_piece(r_b, a + half, (u_a, u_f), -1),
            line_piece(start * ends[1], radii[0] * ends[1]),
            line_piece(radii[0] * ends[1], radii[0] * ends[2]),
        ]
    return chain(rows, True)


def test_two_gears_by_their_outlines():
    """All pairs on the line of action overlap by r_b times the turn, and the pairs are those of the ratio.

    z = 20 and 31, no undercut: between A and E lie floor or ceil of the contact ratio pairs; each presses
    with K x. The reference of a mesh spring: torques -r_b F on both.
    """
    z, m, alpha, x, K = (20, 31), 3e-3, math.radians(20.0), 2e-5, 1e8
    r_b = [0.5 * m * n * math.cos(alpha) for n in z]
    r_a = [0.5 * m * (n + 2) for n in z]
    distance = 0.5 * m * sum(z)
    line = distance * math.sin(alpha)
    p_b = math.pi * m * math.cos(alpha)
    start, end = line - math.sqrt(r_a[1] ** 2 - r_b[1] ** 2), math.sqrt(r_a[0] ** 2 - r_b[0] ** 2)
    outlines = [
        gear_outline(n, r, alpha, (a - 2.25 * m, a), 1e-5) for n, r, a in zip(z, r_b, r_a, strict=True)
    ]

    def shapes(record, pool):
        set_curves(record, pool, (outlines[1], outlines[0]), depth=1e-3, margin=1e-3)
        set_impact(record, K, 1.0)
        set_friction(record, 0.0, 0.0, 1.0, 2.0)

    system = pair("curve_curve", contact("curve_curve", shapes), (distance, 0, 0), np.random.default_rng(4))
    seen = set()
    for phase in np.linspace(0.0, 2.0 * math.pi / z[0], 9)[:-1] + 0.011:
        state = system.initial_state()
        # the wheel is body a; a gap of 2e-5 in all is taken up by half of it on this flank
        state.q[5], state.q[11] = -phase * r_b[0] / r_b[1], phase + (x + 1e-5 + 1e-5) / r_b[0]
        evaluate.residual(system, state)
        # left flank of tooth 0 of the pinion, half a tooth ahead of the line of centres: place from T1
        first = r_b[0] * (math.tan(alpha) + phase) + 0.25 * math.pi * m * math.cos(alpha)
        places = [first + k * p_b for k in range(-4, 5)]
        if min(abs(p - edge) for p in places for edge in (start, end)) < 6e-4:
            continue  # the edge of a tip carries as long as it overlaps: sqrt(2 x rho) = 0.45 mm
        pairs = sum(start < p < end for p in places)
        seen.add(pairs)
        axes = np.asarray(system.bodies[1].axes)
        torque = [(axes.T @ system.workspace.fr[b]["F"][3:])[2] for b in (2, 1)]
        assert torque[0] == pytest.approx(-r_b[0] * K * x * pairs, rel=1e-6)
        assert torque[1] == pytest.approx(-r_b[1] * K * x * pairs, rel=1e-6)
    assert seen == {1, 2}
