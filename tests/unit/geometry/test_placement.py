# SPDX-License-Identifier: Apache-2.0
"""Outlines in mesh: half the backlash on either flank, no overlap, contact where the convention says."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.placement import mesh_outlines

PAIRS = {
    "external": GearPair.at_distance(
        CylindricalGear(z=17, m_n=1e-3, x=0.2), CylindricalGear(z=30, m_n=1e-3), 23.75e-3
    ),
    # the ring's tip is shortened so that it stays clear of the pinion's fillet
    "internal": GearPair.at_distance(
        CylindricalGear(z=20, m_n=1e-3, x=0.3),
        CylindricalGear(z=-60, m_n=1e-3, x=-0.3, tip_alteration=-0.15e-3),
        19.95e-3,
    ),
}
CASES = pytest.mark.parametrize("name", list(PAIRS))


def near(points: np.ndarray, pair: GearPair, direction: float) -> np.ndarray:
    """Part of an outline around the pitch point, as a polyline with breaks removed."""
    pitch = 0.5 * pair.d_w1 * np.array([math.cos(direction), math.sin(direction)])
    return np.hypot(*(points - pitch).T) < 5e-3


def distance(points: np.ndarray, line: np.ndarray, keep: np.ndarray) -> np.ndarray:
    """Distance of each point from the nearest kept segment of a polyline."""
    a, b = line[:-1][keep[:-1]], line[1:][keep[:-1]]
    span = b - a
    share = np.einsum("pij,ij->pi", points[:, None, :] - a[None], span) / (span**2).sum(axis=1)
    foot = a[None] + np.clip(share, 0.0, 1.0)[..., None] * span[None]
    return np.hypot(*np.moveaxis(points[:, None, :] - foot, -1, 0)).min(axis=1)


def inside(points: np.ndarray, polygon: np.ndarray) -> np.ndarray:
    """Even-odd test of points against a closed polygon."""
    (x0, y0), (x1, y1) = polygon[:-1].T, polygon[1:].T
    px, py = points[:, :1], points[:, 1:]
    # edges above, below or to the left of all points are crossed by no ray towards +x
    met = (
        (np.maximum(y0, y1) >= py.min()) & (np.minimum(y0, y1) <= py.max()) & (np.maximum(x0, x1) >= px.min())
    )
    x0, y0, x1, y1 = (c[met] for c in (x0, y0, x1, y1))
    crosses = (y0 > py) != (y1 > py)
    with np.errstate(divide="ignore", invalid="ignore"):
        at = x0 + (py - y0) * (x1 - x0) / (y1 - y0)
    return (crosses & (px < at)).sum(axis=1) % 2 == 1


@CASES
@pytest.mark.parametrize("phi1", [0.0, 0.05, 0.13, -0.3])
@pytest.mark.parametrize("direction", [0.0, 2.1])
def test_half_the_backlash_on_either_flank(name: str, phi1: float, direction: float) -> None:
    pair = PAIRS[name]
    one, two = mesh_outlines(pair, phi1, 150, direction=direction)
    points = one[near(one, pair, direction)]
    gaps = distance(points, two, near(two, pair, direction))
    assert gaps.min() == pytest.approx(0.5 * pair.j_bt, rel=2e-3)
    ring = pair.gear2.is_internal
    assert (inside(points, two) == ring).all()
    assert not inside(two[near(two, pair, direction)], one).any()


@CASES
@pytest.mark.parametrize("side", [1.0, -1.0], ids=["front", "back"])
def test_flanks_touch_at_half_the_backlash(name: str, side: float) -> None:
    pair = PAIRS[name]
    phi1 = 0.04
    for share, expected in ((1.0, 0.0), (0.5, 0.25)):
        u_bt = side * share * 0.5 * pair.j_bt
        phi2 = (u_bt - pair.gear1.r_b * phi1) / pair.gear2.r_b
        one, two = mesh_outlines(pair, phi1, 250, phi2=phi2)
        gaps = distance(one[near(one, pair, 0.0)], two, near(two, pair, 0.0))
        assert gaps.min() == pytest.approx(expected * pair.j_bt, abs=2e-3 * pair.j_bt)


def test_front_flank_is_the_counter_clockwise_one_of_gear_1() -> None:
    pair = PAIRS["external"]
    one, two = mesh_outlines(pair, 0.0, 250, phi2=0.5 * pair.j_bt / pair.gear2.r_b)
    points = one[near(one, pair, 0.0)]
    touching = points[np.argmin(distance(points, two, near(two, pair, 0.0)))]
    # Pushing counter-clockwise, gear 1 touches along the line of action that leaves its base circle on the
    # clockwise side and passes the pitch point towards the counter-clockwise side.
    off = touching - np.array([0.5 * pair.d_w1, 0.0])
    normal = np.array([math.cos(pair.alpha_wt), -math.sin(pair.alpha_wt)])
    assert abs(off @ normal) < pair.j_bt
    mirrored = np.array([math.cos(pair.alpha_wt), math.sin(pair.alpha_wt)])
    assert abs(off @ mirrored) > 5.0 * pair.j_bt


def test_axis_of_gear_2() -> None:
    for pair in PAIRS.values():
        two = mesh_outlines(pair, 0.2, 20, direction=0.5)[1][:-1]
        axis = two.mean(axis=0)
        assert axis == pytest.approx(pair.a_w * np.array([math.cos(0.5), math.sin(0.5)]), abs=1e-9)
