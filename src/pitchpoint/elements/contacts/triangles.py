# SPDX-License-Identifier: Apache-2.0
"""Contact of triangle surfaces with triangles and simple shapes, at face centroids inside the other body.

Between two triangle surfaces each face has half of its area as weight, against a simple shape all of it. The
distance of any point of a box from a surface is at least that of the centre of the box less half the diagonal
(the distance function has the Lipschitz constant 1).
"""

from __future__ import annotations

import math

from pitchpoint.contact.surface import CYLINDER, distance, of_length
from pitchpoint.contact.triangle_search import (
    box_distance,
    nearest_place,
    point_tree_of,
    points_of,
    signed_place,
    tree_of,
)
from pitchpoint.core.kernel import kernel
from pitchpoint.elements.contacts.surface_place import curvature_in_world, local, point_place
from pitchpoint.elements.contacts.wrench import act
from pitchpoint.multibody.vectors import into_world, plus, triple


@kernel
def _one_way(b, c, f, g, kk, side):
    """Contact of points of body i with triangles of body j (side 1), or of points of j with i (-1)."""
    of_i = side > 0.0
    other = b["pool"] + 8 * (b["start_i"] if of_i else b["start_j"])
    where = b["pool"] + 8 * (b["start_j"] if of_i else b["start_i"])
    E = b["Ei"] if of_i else b["Ej"]
    o = b["oi"] if of_i else b["oj"]
    E_s = b["Ej"] if of_i else b["Ei"]
    o_s = b["oj"] if of_i else b["oi"]
    depth = b["depth"]
    tree = point_tree_of(other)
    points = points_of(other)
    boxes = tree_of(where)
    k = 0
    while k < tree.shape[0]:
        middle = (
            0.5 * (tree[k, 0] + tree[k, 3]),
            0.5 * (tree[k, 1] + tree[k, 4]),
            0.5 * (tree[k, 2] + tree[k, 5]),
        )
        half = (middle[0] - tree[k, 0], middle[1] - tree[k, 1], middle[2] - tree[k, 2])
        reach = depth + math.sqrt(half[0] * half[0] + half[1] * half[1] + half[2] * half[2])
        local(b, E_s, o_s, plus(triple(o, 0), 1.0, into_world(E, middle)))
        if box_distance(boxes, 0, b["y"]) >= reach * reach:
            k = int(tree[k, 6])
            continue
        first = int(tree[k, 7])
        for h in range(first, first + int(tree[k, 8])):
            Q = plus(triple(o, 0), 1.0, into_world(E, (points[h, 0], points[h, 1], points[h, 2])))
            local(b, E_s, o_s, Q)
            if not nearest_place(where, b["y"], depth, b["hit"]):
                continue
            phi, nx, ny, nz = signed_place(where, b["y"], b["hit"], b["V"])
            if phi >= b["gap"] and phi >= 0.0:
                continue
            b["side"] = side
            curvature_in_world(E_s, b["V"], b["W"])
            point_place(b, f, g, Q, into_world(E_s, (nx, ny, nz)), phi, 0.0, 0.5 * points[h, 3])
            act(b, c, f, g, kk)
        k += 1


@kernel
def points_on_triangles(b, c, f, g, kk):
    """Contact of two triangle surfaces: points of each on the triangles of the other."""
    _one_way(b, c, f, g, kk, 1.0)
    _one_way(b, c, f, g, kk, -1.0)


@kernel
def _distance(b, W):
    """Distance of b["y"] from the simple surface of body j; a cylinder of given length has flat ends."""
    if b["form_j"] == CYLINDER and b["size_j"][1] > 0.0:
        return of_length(b["size_j"], b["sense"], b["y"], W)
    return distance(b["form_j"], b["size_j"], b["sense"], b["y"], W)


@kernel
def points_on_shape(b, c, f, g, kk):
    """Contact of the triangles of body i with a plane, cylinder, cone, torus or sphere of body j."""
    where = b["pool"] + 8 * b["start_i"]
    tree = point_tree_of(where)
    points = points_of(where)
    b["side"] = 1.0
    k = 0
    while k < tree.shape[0]:
        middle = (
            0.5 * (tree[k, 0] + tree[k, 3]),
            0.5 * (tree[k, 1] + tree[k, 4]),
            0.5 * (tree[k, 2] + tree[k, 5]),
        )
        half = (middle[0] - tree[k, 0], middle[1] - tree[k, 1], middle[2] - tree[k, 2])
        reach = math.sqrt(half[0] * half[0] + half[1] * half[1] + half[2] * half[2])
        local(b, b["Ej"], b["oj"], plus(triple(b["oi"], 0), 1.0, into_world(b["Ei"], middle)))
        phi, nx, ny, nz = _distance(b, b["V"])
        if phi - reach >= max(b["gap"], 0.0) or phi + reach < -b["depth"]:
            k = int(tree[k, 6])
            continue
        first = int(tree[k, 7])
        for h in range(first, first + int(tree[k, 8])):
            Q = plus(triple(b["oi"], 0), 1.0, into_world(b["Ei"], (points[h, 0], points[h, 1], points[h, 2])))
            local(b, b["Ej"], b["oj"], Q)
            phi, nx, ny, nz = _distance(b, b["V"])
            if phi < -b["depth"] or (phi >= b["gap"] and phi >= 0.0):
                continue
            curvature_in_world(b["Ej"], b["V"], b["W"])
            point_place(b, f, g, Q, into_world(b["Ej"], (nx, ny, nz)), phi, 0.0, points[h, 3])
            act(b, c, f, g, kk)
        k += 1
