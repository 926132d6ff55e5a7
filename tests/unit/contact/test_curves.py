# SPDX-License-Identifier: Apache-2.0
"""Planar curves: places, directions, curvature against closed forms, nearest places against a search."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.curve import chain, circle, involute_piece, polygon, spline, vertex
from pitchpoint.contact.curve_pair import HIT, MAX_CONTACTS, contacts
from pitchpoint.contact.curve_point import arc_length, nearest, point_of

pytestmark = pytest.mark.nojit

ANGLE = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
OVAL = spline(np.column_stack([0.06 * np.cos(ANGLE), 0.04 * np.sin(ANGLE)]))
ROUNDED = polygon([(0, 0), (0.1, 0), (0.1, 0.06), (0.05, 0.03), (0, 0.06)], [0.01, 0.0, 0.005, 0.01, 0.0])
FLANK = chain([involute_piece(0.05, 0.3, (0.2, 0.9), -1)], False)
CURVES = {"oval": OVAL, "rounded": ROUNDED, "hole": circle(0.05, (0.01, 0.02), hole=True), "flank": FLANK}


@pytest.mark.parametrize("name", CURVES)
def test_directions_and_curvature_are_derivatives(name):
    rows = CURVES[name].rows
    h = 1e-6
    for k in range(len(rows)):
        for t in (0.1, 0.5, 0.9):
            x, y, tx, ty, speed, turn = point_of(rows, k, t)
            ends = [point_of(rows, k, t + s * h) for s in (1.0, -1.0)]
            rate = (complex(*ends[0][:2]) - complex(*ends[1][:2])) / (2 * h)
            assert rate == pytest.approx(speed * complex(tx, ty), abs=1e-9)
            assert math.hypot(tx, ty) == pytest.approx(1.0, abs=1e-15)
            spin = (complex(*ends[0][2:4]) - complex(*ends[1][2:4])) / (2 * h)
            assert spin == pytest.approx(turn * 1j * complex(tx, ty), abs=1e-8)


@pytest.mark.parametrize("name", CURVES)
def test_pieces_join_and_count_their_length(name):
    curve = CURVES[name]
    rows = curve.rows
    length = 0.0
    for k in range(len(rows)):
        t = np.linspace(0.0, 1.0, 2001)
        line = np.array([complex(*point_of(rows, k, s)[:2]) for s in t])
        assert arc_length(rows, k, 0.0) == pytest.approx(length, abs=1e-7)
        length += np.abs(np.diff(line)).sum()
        middle = complex(*rows[k, 1:3])
        assert np.abs(line - middle).max() <= rows[k, 3] * (1.0 + 1e-12)
        if curve.closed or k + 1 < len(rows):
            following = point_of(rows, (k + 1) % len(rows), 0.0)
            assert line[-1] == pytest.approx(complex(*following[:2]), abs=1e-15)
            assert complex(*point_of(rows, k, 1.0)[2:4]).real == pytest.approx(following[2], abs=1.0)
    assert curve.length == pytest.approx(length, rel=1e-6)  # chords of a full circle
    x, y, r = curve.circle()
    assert np.all(np.hypot(rows[:, 1] - x, rows[:, 2] - y) + rows[:, 3] <= r * (1 + 1e-12))


def test_an_involute_is_that_of_the_gears():
    """Radius r_b sqrt(1 + u^2), curvature 1/(r_b u), normal tangent to the base circle."""
    for t in (0.0, 0.4, 1.0):
        x, y, tx, ty, speed, turn = point_of(FLANK.rows, 0, t)
        u = 0.2 + 0.7 * t
        assert math.hypot(x, y) == pytest.approx(0.05 * math.sqrt(1 + u * u), rel=1e-14)
        assert abs(turn / speed) == pytest.approx(1.0 / (0.05 * u), rel=1e-13)
        assert abs(x * ty - y * tx) == pytest.approx(0.05 * u, rel=1e-13)  # arm of the direction
        assert abs(x * tx + y * ty) == pytest.approx(0.05, rel=1e-13)  # arm of the normal


def search(curve, x, y, n=4001):
    """Least distance of a point from a curve by trying places."""
    t = np.linspace(0.0, 1.0, n)
    return min(
        min(math.hypot(point_of(curve.rows, k, s)[0] - x, point_of(curve.rows, k, s)[1] - y) for s in t)
        for k in range(len(curve.rows))
    )


@pytest.mark.parametrize("place", [(0.07, 0.01), (0.0, 0.05), (-0.03, -0.02), (0.059, 0.0), (0.02, 0.055)])
@pytest.mark.parametrize("name", ["oval", "rounded", "hole"])
def test_the_nearest_place_is_the_nearest(name, place):
    curve = CURVES[name]
    found = [nearest(curve.rows, k, *place) for k in range(len(curve.rows))]
    distances = [abs(f[2]) for f in found if f[0]]
    n = 401 if name == "oval" else 4001
    assert min(distances) == pytest.approx(search(curve, *place, n), rel=1e-4, abs=2e-5)  # its grid
    inside = {"oval": (place[0] / 0.06) ** 2 + (place[1] / 0.04) ** 2 < 1.0}.get(name)
    if inside is not None:
        best = min((f for f in found if f[0]), key=lambda f: abs(f[2]))
        assert (best[2] < 0.0) == inside


def touch(A, B, d, angle=0.0, offset=0.0, depth=0.01, deepest=0.01):
    c, s = math.cos(angle), math.sin(angle)
    M = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    hits = np.zeros((MAX_CONTACTS, HIT))
    reach = np.array([offset, depth, 1.0, *B.circle(), deepest])
    return (*contacts(A.rows, B.rows, M, np.array([*d, 0.0]), reach, hits), hits)


def test_a_pin_in_a_slot_touches_both_sides():
    slot = polygon([(0.0, 0.0), (0.0, 0.02), (0.1, 0.02), (0.1, 0.0)])  # clockwise: a hole
    n, gap, hits = touch(circle(0.0101), slot, (0.05, 0.00995))
    assert n == 2
    assert hits[:2, 0] == pytest.approx([-0.00015, -0.00005], abs=1e-15)


def test_deepest_first_and_no_more_than_four():
    star = polygon(
        [(r * math.cos(a), r * math.sin(a)) for a, r in zip(ANGLE, [0.05, 0.03] * 12, strict=True)]
    )
    n, gap, hits = touch(star, circle(0.0499, hole=True), (0.0, 1e-5))
    assert n == MAX_CONTACTS
    assert np.all(np.diff(hits[:, 0]) >= 0.0)
    assert gap == hits[0, 0] == pytest.approx(-0.00011, rel=1e-9)  # the tip at 90 deg goes in first


def test_a_place_at_the_joint_of_two_pieces_counts_once():
    n, gap, hits = touch(OVAL, OVAL, (0.1199, 0.0))
    assert n == 1
    assert gap == pytest.approx(-1e-4, abs=1e-7)  # the spline is the ellipse to that accuracy


STAR = polygon(
    [(r * math.cos(a), r * math.sin(a)) for a, r in zip(ANGLE, [0.05, 0.02] * 12, strict=True)], 5e-4
)


def signed(curve, x, y):
    """Signed distance of a point from an outline by trying places and counting turns around it."""
    t = np.linspace(0.0, 1.0, 81)
    line = np.array([complex(*point_of(curve.rows, k, s)[:2]) for k in range(len(curve.rows)) for s in t])
    away = line - complex(x, y)
    turns = np.angle(np.roll(away, -1) / away).sum() / (2.0 * np.pi)
    return math.copysign(np.abs(away).min(), -1.0 if turns > 0.5 else 1.0)


@pytest.mark.parametrize("name", ["oval", "rounded", "star"])
@pytest.mark.parametrize("offset", [0.0, 0.006])
def test_a_roller_is_never_lost_inside_an_outline(name, offset):
    """Anywhere inside, however deep, there is a contact, and only where the roller overlaps.

    The overlap of deep places is that of the nearest side; 2e-4 m is the grid of the search. The depth is
    thinner than the points of the star: what overlaps less than it counts from both sides.
    """
    curve = {**CURVES, "star": STAR}[name]
    rng = np.random.default_rng(7)
    x, y, r = curve.circle()
    deep = 0
    for _ in range(60):
        place = (x, y) + 1.2 * r * rng.uniform(-1.0, 1.0, 2)
        distance = signed(curve, *place)
        if abs(distance - offset) < 2e-4:
            continue
        n, gap, _ = touch(chain([vertex()], True), curve, place, 0.0, offset, 1e-4, np.inf)
        assert (n > 0) == (distance < offset), (place, distance)
        if n and gap < -1e-4:
            deep += 1
            assert gap == pytest.approx(distance - offset, abs=2e-4)
        elif n == 0:
            assert gap == pytest.approx(distance - offset, abs=2e-4)
    assert deep > 5


def test_two_outlines_part_the_short_way():
    """Ovals whose middles are 20 mm apart along their short axes overlap by 60 mm there; beside it, none."""
    n, gap, hits = touch(OVAL, OVAL, (0.0, 0.02), deepest=np.inf)
    assert n == 1
    assert gap == pytest.approx(-0.06, abs=1e-6)
    n, gap, _ = touch(OVAL, OVAL, (0.0, 0.082), deepest=np.inf)
    assert n == 0
    assert gap == pytest.approx(0.002, abs=1e-6)
    assert touch(OVAL, OVAL, (0.0, 0.02))[0] == 0  # a depth that was given is a limit


def test_gaps_are_those_of_ellipses():
    """Circle and spline of an ellipse side by side, turned: gap against a search over the ellipse."""
    dense = np.linspace(0.0, 2.0 * np.pi, 96, endpoint=False)
    oval = spline(np.column_stack([0.06 * np.cos(dense), 0.04 * np.sin(dense)]))
    for angle in (0.0, 0.4, 1.2):
        n, gap, hits = touch(oval, circle(0.03), (0.09, 0.02), angle)
        t = np.linspace(0.0, 2.0 * np.pi, 200001)
        line = (0.06 * np.cos(t) + 0.04j * np.sin(t)) * np.exp(1j * angle) + complex(0.09, 0.02)
        wanted = np.abs(line).min() - 0.03
        # a cubic spline leaves the ellipse by about h^4/384 of its size, h = 2 pi/96
        assert gap == pytest.approx(wanted, abs=2e-8)


def test_no_common_normal_within_the_margin():
    n, gap, hits = touch(circle(0.01), circle(0.01), (5.0, 0.0))
    assert (n, gap, hits[0, 4]) == (0, 1.0, -1.0)


def test_curves_that_cannot_be():
    with pytest.raises(ValueError, match="does not end where the next one begins"):
        chain([involute_piece(0.05, 0.0, (0.2, 0.5)), involute_piece(0.05, 1.0, (0.2, 0.5))], False)
    with pytest.raises(ValueError, match="overlap"):
        polygon([(0, 0), (1, 0), (1, 1), (0, 1)], 0.6)
    with pytest.raises(ValueError, match="coincide"):
        spline([(0, 0), (1, 0), (1, 0), (0, 1)])
    with pytest.raises(ValueError, match="different positive roll angles"):
        involute_piece(0.05, 0.0, (0.0, 0.5))
