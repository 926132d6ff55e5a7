# SPDX-License-Identifier: Apache-2.0
"""Distances from surfaces: gradient and curvature by differences, triangles against simple shapes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.surface import CONE, CYLINDER, PLANE, SPHERE, TORUS, distance
from pitchpoint.contact.triangle_search import (
    MAX_PLACES,
    PLACE,
    nearest_place,
    points_of,
    signed_place,
    sphere_places,
)
from pitchpoint.contact.triangles import TriangleSurface, bounding_tree
from tests.support.contacts import ball, box

pytestmark = pytest.mark.nojit

FORMS = {
    "plane": (PLANE, (0.0, 0.0)),
    "sphere": (SPHERE, (0.3, 0.0)),
    "cylinder": (CYLINDER, (0.3, 0.0)),
    "cone": (CONE, (0.4, 0.0)),
    "torus": (TORUS, (0.5, 0.2)),
}
POINTS = [(0.2, 0.1, 0.35), (-0.4, 0.3, -0.1), (0.3, -0.5, -0.6), (0.05, 0.02, 0.5)]


@pytest.mark.parametrize("sense", [1.0, -1.0])
@pytest.mark.parametrize("point", POINTS)
@pytest.mark.parametrize("name", FORMS)
def test_normal_and_curvature_are_derivatives_of_the_distance(name, point, sense):
    form, size = FORMS[name]
    W, spare = np.zeros((3, 3)), np.zeros((3, 3))

    def at(y, into=spare):
        return distance(form, np.array(size), sense, np.asarray(y, float), into)

    phi, *n = at(point, W)
    assert np.linalg.norm(n) == pytest.approx(1.0, abs=1e-14)
    np.testing.assert_allclose(W, W.T, atol=1e-14)
    np.testing.assert_allclose(W @ n, 0.0, atol=1e-13)
    h = 1e-6
    for k in range(3):
        e = h * np.eye(3)[k]
        one, two = at(point + e), at(point - e)
        assert (one[0] - two[0]) / (2 * h) == pytest.approx(n[k], abs=1e-9)
        np.testing.assert_allclose((np.array(one[1:]) - two[1:]) / (2 * h), W[k], atol=1e-8)
    foot = np.asarray(point) - phi * np.array(n)  # on the surface, or its tip
    beyond_tip = name == "cone" and sense < 0.0 and foot[2] > 0.0  # there, a funnel is all material
    assert beyond_tip or at(foot)[0] == pytest.approx(0.0, abs=1e-12)


def test_on_an_axis_some_direction_is_taken():
    for form, size in FORMS.values():
        for sense in (1.0, -1.0):
            W = np.zeros((3, 3))
            found = distance(form, np.array(size), sense, np.zeros(3), W)
            assert np.all(np.isfinite(found))
            assert np.all(np.isfinite(W))


def brute(surface, y):
    """Least distance of a point from triangles by many points on each of them."""
    u = np.linspace(0.0, 1.0, 41)
    a, b = (x.ravel() for x in np.meshgrid(u, u))
    keep = a + b <= 1.0 + 1e-12
    weights = np.column_stack([a, b, 1.0 - a - b])[keep]
    corners = surface.vertices[surface.faces]
    return np.linalg.norm(np.einsum("pk,fkc->fpc", weights, corners) - y, axis=2).min()


@pytest.mark.parametrize("surface", [ball(0.3, 1), box((0.4, 0.5, 0.6), 2)], ids=["ball", "box"])
def test_the_nearest_place_is_the_nearest(surface):
    rng = np.random.default_rng(3)
    packed = surface.packed()
    for _ in range(20):
        y = rng.uniform(-0.5, 0.5, 3)
        place = np.zeros(PLACE)
        assert nearest_place(packed.ctypes.data, y, 2.0, place)
        tried = brute(surface, y)  # within 1/40 of an edge of the true place
        assert 0.0 <= tried**2 - place[0] ** 2 + 1e-12 < (0.33 / 40.0) ** 2
        assert np.linalg.norm(y - place[3:]) == pytest.approx(place[0], rel=1e-12)
        inside = bool(np.all(np.abs(y) < (0.2, 0.25, 0.3))) if surface.faces.shape[0] == 48 else None
        phi = signed_place(packed.ctypes.data, y, place, np.zeros((3, 3)))[0]
        if inside is not None:
            assert (phi < 0.0) == inside


def test_a_point_is_inside_whatever_feature_is_nearest():
    """A notched block: the re-entrant edge is the nearest place for points inside it."""
    outline = np.array([(0, 0), (2, 0), (2, 2), (1, 1), (0, 2)], float)
    caps = [(0, 1, 3), (1, 2, 3), (0, 3, 4)]
    low, high = (np.column_stack([outline, np.full(5, z)]) for z in (-1.0, 1.0))
    triangles = [high[list(c)] for c in caps] + [low[list(c)][::-1] for c in caps]
    for k in range(5):
        m = (k + 1) % 5
        triangles += [np.array([low[k], low[m], high[m]]), np.array([low[k], high[m], high[k]])]
    packed = TriangleSurface.from_triangles(np.array(triangles)).packed()
    place, W = np.zeros(PLACE), np.zeros((3, 3))
    for y, wanted in (
        ((1.0, 0.9, 0.0), -0.1),
        ((1.0, 1.1, 0.0), 0.1 / math.sqrt(2)),
        ((-0.1, -0.1, 0.0), 0.1 * math.sqrt(2)),
    ):
        y = np.array(y)
        assert nearest_place(packed.ctypes.data, y, 1.0, place)
        assert signed_place(packed.ctypes.data, y, place, W)[0] == pytest.approx(wanted, rel=1e-12)


def test_a_sphere_touches_once_per_side():
    surface = box((1.0, 1.0, 1.0), 3)
    packed = surface.packed()
    places = np.zeros((MAX_PLACES, PLACE))
    for y, n in (((0.0, 0.0, 0.55), 1), ((0.55, 0.0, 0.55), 1), ((0.55, 0.55, 0.55), 1)):
        assert sphere_places(packed.ctypes.data, np.array(y), 0.1, places) == n
    hollow = TriangleSurface(surface.vertices, surface.faces[:, ::-1]).packed()
    for y, n in (((0.0, 0.0, 0.45), 1), ((0.45, 0.0, 0.45), 2), ((0.45, 0.45, 0.45), 3)):
        assert sphere_places(hollow.ctypes.data, np.array(y), 0.1, places) == n


def test_finer_triangles_do_not_multiply_the_places():
    for times in (1, 2, 3):
        surface = ball(0.3, times)
        hollow = TriangleSurface(surface.vertices, surface.faces[:, ::-1]).packed()
        places = np.zeros((MAX_PLACES, PLACE))
        assert sphere_places(hollow.ctypes.data, np.array([0.1, 0.0, 0.05]), 0.2, places) == 1


def test_areas_and_volume():
    """Areas of the points add up to that of the surface; the box tree holds everything once."""
    surface = box((0.4, 0.5, 0.6), 3)
    normals, areas = surface.normals()
    assert areas.sum() == pytest.approx(2 * (0.2 + 0.24 + 0.3))
    packed = surface.packed()
    assert points_of(packed.ctypes.data)[:, 3].sum() == pytest.approx(areas.sum())
    assert len(surface.vertices) == 56
    tree, order = bounding_tree(surface.vertices, surface.vertices)
    assert sorted(order.tolist()) == list(range(56))
    assert tree[:, 8].sum() == 56
    assert tree[0, 6] == len(tree)


def test_surfaces_that_cannot_be():
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
    with pytest.raises(ValueError, match="walk one edge the same way"):
        TriangleSurface(corners, np.array([[0, 1, 2], [0, 1, 3]])).packed()
    with pytest.raises(ValueError, match="has no area"):
        TriangleSurface(np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0]], float), np.array([[0, 1, 2]])).packed()
