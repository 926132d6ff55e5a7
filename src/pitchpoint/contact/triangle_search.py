# SPDX-License-Identifier: Apache-2.0
"""Kernels for triangle surfaces: nearest point, signed distance, and all contacts of a sphere.

The pseudonormal distinguishes inside and outside: face normal, sum of both normals at an edge,
angle-weighted sum at a corner. J. A. Baerentzen and H. Aanaes, IEEE Trans. Vis. Comput. Graph. 11 (2005)
243-253.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.contact.surface import MIN_DISTANCE, radial
from pitchpoint.core.kernel import kernel, view

F8 = np.dtype("f8")
HEADER = 8
BOX = 9
FACE = 33
"""Corners (9), normal (3), nodes (3), owns node (3), sums of normals at edges (9), owns edge (3), far node of
the face across each edge (3)."""
POINT = 4
"""Centroid of a face (3) and its area."""
NODE = 8
"""Position (3), normal (3), first neighbour, number of neighbours."""
CORNER, EDGE, INSIDE = 0, 3, 6
SAME_SIDE = 0.8660254037844386
"""Cosine of the angle between normals (30 deg) below which two contacts of a sphere are merged."""
MAX_PLACES = 4
"""Maximum number of contacts of a sphere."""
PLACE = 6
"""Numbers of a contact: distance, face, feature, point (3)."""


@kernel
def tree_of(where):
    """Face tree of a packed surface at an address.

    >>> from pitchpoint.contact.triangles import TriangleSurface
    >>> one = TriangleSurface(np.eye(3), np.array([[0, 1, 2]])).packed()
    >>> tree_of(one.ctypes.data)[0].tolist()
    [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 1.0]
    """
    return view(where + 8 * HEADER, (int(view(where, HEADER, F8)[0]), BOX), F8)


@kernel
def faces_of(where):
    """Faces of a packed surface at an address, in the order of its tree.

    >>> from pitchpoint.contact.triangles import TriangleSurface
    >>> one = TriangleSurface(np.eye(3), np.array([[0, 1, 2]])).packed()
    >>> faces_of(one.ctypes.data)[0, :3].tolist()
    [1.0, 0.0, 0.0]
    """
    header = view(where, HEADER, F8)
    return view(where + 8 * (HEADER + int(header[0]) * BOX), (int(header[1]), FACE), F8)


@kernel
def point_tree_of(where):
    """Point tree of a packed surface at an address.

    >>> from pitchpoint.contact.triangles import TriangleSurface
    >>> one = TriangleSurface(np.eye(3), np.array([[0, 1, 2]])).packed()
    >>> float(point_tree_of(one.ctypes.data)[0, 8])
    1.0
    """
    header = view(where, HEADER, F8)
    skip = HEADER + int(header[0]) * BOX + int(header[1]) * FACE
    return view(where + 8 * skip, (int(header[2]), BOX), F8)


@kernel
def points_of(where):
    """Centroids and areas of the faces of a packed surface at an address, in the order of the point tree.

    >>> from pitchpoint.contact.triangles import TriangleSurface
    >>> one = TriangleSurface(np.eye(3), np.array([[0, 1, 2]])).packed()
    >>> points_of(one.ctypes.data).round(6).tolist()
    [[0.333333, 0.333333, 0.333333, 0.866025]]
    """
    header = view(where, HEADER, F8)
    skip = HEADER + (int(header[0]) + int(header[2])) * BOX + int(header[1]) * FACE
    return view(where + 8 * skip, (int(header[1]), POINT), F8)


@kernel
def nodes_of(where):
    """Nodes of a packed surface at an address.

    >>> from pitchpoint.contact.triangles import TriangleSurface
    >>> one = TriangleSurface(np.eye(3), np.array([[0, 1, 2]])).packed()
    >>> nodes_of(one.ctypes.data)[0, :3].tolist()
    [1.0, 0.0, 0.0]
    """
    header = view(where, HEADER, F8)
    skip = HEADER + (int(header[0]) + int(header[2])) * BOX + int(header[1]) * (FACE + POINT)
    return view(where + 8 * skip, (int(header[3]), NODE), F8)


@kernel
def neighbours_of(where):
    """Neighbours of all nodes of a packed surface at an address.

    >>> from pitchpoint.contact.triangles import TriangleSurface
    >>> one = TriangleSurface(np.eye(3), np.array([[0, 1, 2]])).packed()
    >>> neighbours_of(one.ctypes.data).tolist()
    [1.0, 2.0, 0.0, 2.0, 0.0, 1.0]
    """
    header = view(where, HEADER, F8)
    skip = HEADER + (int(header[0]) + int(header[2])) * BOX + int(header[1]) * (FACE + POINT)
    return view(where + 8 * (skip + int(header[3]) * NODE), int(header[4]), F8)


@kernel
def box_distance(tree, k, y):
    """Squared distance of a point from box k, 0 inside [m^2].

    >>> tree = np.array([[0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 1.0]])
    >>> float(box_distance(tree, 0, np.array([0.5, 3.0, 2.0])))
    5.0
    """
    s = 0.0
    for i in range(3):
        x = max(tree[k, i] - y[i], y[i] - tree[k, 3 + i])
        if x > 0.0:
            s += x * x
    return s


@kernel
def _edge_place(faces, k, c, t):
    """Point at parameter t on the edge of face k that begins at corner c, and its feature number."""
    a = 3 * c
    b = 3 * ((c + 1) % 3)
    return (
        faces[k, a] + t * (faces[k, b] - faces[k, a]),
        faces[k, a + 1] + t * (faces[k, b + 1] - faces[k, a + 1]),
        faces[k, a + 2] + t * (faces[k, b + 2] - faces[k, a + 2]),
        EDGE + c,
    )


@kernel
def on_triangle(faces, k, y):
    """Point of face k nearest to y and its feature: corner 0 to 2, edge 3 to 5, interior 6.

    C. Ericson, *Real-Time Collision Detection* (2005), section 5.1.5.

    >>> from pitchpoint.contact.triangles import TriangleSurface
    >>> one = TriangleSurface(np.eye(3), np.array([[0, 1, 2]])).packed()
    >>> found = on_triangle(faces_of(one.ctypes.data), 0, np.array([1.0, 1.0, -1.0]))
    >>> tuple(round(float(x), 9) for x in found)
    (0.5, 0.5, 0.0, 3.0)
    """
    p = faces[k]
    d1 = d2 = d3 = d4 = d5 = d6 = 0.0
    for i in range(3):
        ab = p[3 + i] - p[i]
        ac = p[6 + i] - p[i]
        d1 += ab * (y[i] - p[i])
        d2 += ac * (y[i] - p[i])
        d3 += ab * (y[i] - p[3 + i])
        d4 += ac * (y[i] - p[3 + i])
        d5 += ab * (y[i] - p[6 + i])
        d6 += ac * (y[i] - p[6 + i])
    if d1 <= 0.0 and d2 <= 0.0:
        return p[0], p[1], p[2], 0
    if d3 >= 0.0 and d4 <= d3:
        return p[3], p[4], p[5], 1
    if d6 >= 0.0 and d5 <= d6:
        return p[6], p[7], p[8], 2
    vc = d1 * d4 - d3 * d2
    if vc <= 0.0 and d1 >= 0.0 and d3 <= 0.0:
        return _edge_place(faces, k, 0, d1 / (d1 - d3))
    va = d3 * d6 - d5 * d4
    if va <= 0.0 and d4 - d3 >= 0.0 and d5 - d6 >= 0.0:
        return _edge_place(faces, k, 1, (d4 - d3) / ((d4 - d3) + (d5 - d6)))
    vb = d5 * d2 - d1 * d6
    if vb <= 0.0 and d2 >= 0.0 and d6 <= 0.0:
        return _edge_place(faces, k, 2, 1.0 - d2 / (d2 - d6))
    v = vb / (va + vb + vc)
    w = vc / (va + vb + vc)
    return (
        p[0] + v * (p[3] - p[0]) + w * (p[6] - p[0]),
        p[1] + v * (p[4] - p[1]) + w * (p[7] - p[1]),
        p[2] + v * (p[5] - p[2]) + w * (p[8] - p[2]),
        INSIDE,
    )


@kernel
def nearest_place(where, y, reach, place):
    """Store the surface point nearest to y within `reach` [m] in `place`; returns whether there is one.

    The distance in `place` is unsigned. For equal distances the first face in tree order is used.

    >>> from pitchpoint.contact.triangles import TriangleSurface
    >>> one = TriangleSurface(np.eye(3), np.array([[0, 1, 2]])).packed()
    >>> place = np.zeros(PLACE)
    >>> bool(nearest_place(one.ctypes.data, np.ones(3), 2.0, place)), round(float(place[0]), 6), int(place[2])
    (True, 1.154701, 6)
    """
    tree = tree_of(where)
    faces = faces_of(where)
    best = reach * reach
    found = False
    k = 0
    while k < tree.shape[0]:
        if box_distance(tree, k, y) >= best:
            k = int(tree[k, 6])
            continue
        first = int(tree[k, 7])
        for face in range(first, first + int(tree[k, 8])):
            qx, qy, qz, feature = on_triangle(faces, face, y)
            d = (y[0] - qx) ** 2 + (y[1] - qy) ** 2 + (y[2] - qz) ** 2
            if d < best:
                best = d
                found = True
                place[1] = face
                place[2] = feature
                place[3] = qx
                place[4] = qy
                place[5] = qz
        k += 1
    place[0] = math.sqrt(best)
    return found


@kernel
def signed_place(where, y, place, W):
    """Signed distance of y from its nearest point `place` and the outward normal; W is overwritten.

    >>> from pitchpoint.contact.triangles import TriangleSurface
    >>> one = TriangleSurface(np.eye(3), np.array([[0, 1, 2]])).packed()
    >>> place, W = np.zeros(PLACE), np.zeros((3, 3))
    >>> y = np.zeros(3)
    >>> found = nearest_place(one.ctypes.data, y, 2.0, place)
    >>> tuple(round(float(x), 6) for x in signed_place(one.ctypes.data, y, place, W))
    (-0.57735, 0.57735, 0.57735, 0.57735)
    """
    faces = faces_of(where)
    k = int(place[1])
    feature = int(place[2])
    for r in range(3):
        for c in range(3):
            W[r, c] = 0.0
    dx = y[0] - place[3]
    dy = y[1] - place[4]
    dz = y[2] - place[5]
    if feature == INSIDE:
        n = faces[k, 9:12]
        return dx * n[0] + dy * n[1] + dz * n[2], n[0], n[1], n[2]
    if feature >= EDGE:
        at = 18 + 3 * (feature - EDGE)
        nx = faces[k, at]
        ny = faces[k, at + 1]
        nz = faces[k, at + 2]
    else:
        node = nodes_of(where)[int(faces[k, 12 + feature])]
        nx = node[3]
        ny = node[4]
        nz = node[5]
    d = math.sqrt(dx * dx + dy * dy + dz * dz)
    if d < MIN_DISTANCE:
        size = math.sqrt(nx * nx + ny * ny + nz * nz)
        return 0.0, nx / size, ny / size, nz / size
    s = 1.0 if dx * nx + dy * ny + dz * nz >= 0.0 else -1.0
    n = (s * dx / d, s * dy / d, s * dz / d)
    radial(W, n, s, d)
    if feature >= EDGE:
        _remove_edge_curvature(W, faces, k, feature - EDGE, s / d)
    return s * d, n[0], n[1], n[2]


@kernel
def _remove_edge_curvature(W, faces, k, c, curvature):
    """Remove the curvature in the direction of an edge from W."""
    a = 3 * c
    b = 3 * ((c + 1) % 3)
    ex = faces[k, b] - faces[k, a]
    ey = faces[k, b + 1] - faces[k, a + 1]
    ez = faces[k, b + 2] - faces[k, a + 2]
    s = curvature / (ex * ex + ey * ey + ez * ez)
    e = (ex, ey, ez)
    for r in range(3):
        for h in range(3):
            W[r, h] -= s * e[r] * e[h]


@kernel
def is_nearest_around(where, y, face, feature, qx, qy, qz):
    """Whether a point of a face is a local minimum of the distance from y and is owned by this face.

    >>> from pitchpoint.contact.triangles import TriangleSurface
    >>> one = TriangleSurface(np.eye(3), np.array([[0, 1, 2]])).packed()
    >>> bool(is_nearest_around(one.ctypes.data, np.ones(3), 0, INSIDE, 0.0, 0.0, 0.0))
    True
    """
    if feature == INSIDE:
        return True
    faces = faces_of(where)
    nodes = nodes_of(where)
    if feature >= EDGE:
        if faces[face, 27 + feature - EDGE] == 0.0:
            return False
        across = int(faces[face, 30 + feature - EDGE])
        if across < 0:
            return True
        o = nodes[across]
        s = (y[0] - qx) * (o[0] - qx) + (y[1] - qy) * (o[1] - qy) + (y[2] - qz) * (o[2] - qz)
        return s <= 0.0
    if faces[face, 15 + feature] == 0.0:
        return False
    node = nodes[int(faces[face, 12 + feature])]
    around = neighbours_of(where)
    first = int(node[6])
    for h in range(first, first + int(node[7])):
        o = nodes[int(around[h])]
        s = (y[0] - qx) * (o[0] - qx) + (y[1] - qy) * (o[1] - qy) + (y[2] - qz) * (o[2] - qz)
        if s > 0.0:
            return False
    return True


@kernel
def _same_direction(places, h, d, y, qx, qy, qz):
    """Whether contact h and a point at distance d lie within 30 deg of each other as seen from y."""
    s = (y[0] - places[h, 3]) * (y[0] - qx)
    s += (y[1] - places[h, 4]) * (y[1] - qy)
    s += (y[2] - places[h, 5]) * (y[2] - qz)
    return s > SAME_SIDE * d * places[h, 0]


@kernel
def sphere_places(where, y, radius, places):
    """Store the contacts of a sphere about y, outside a surface, in `places`; returns their number.

    Contacts whose normals differ by less than 30 deg are merged to the deepest one, so that a finer
    triangulation does not increase the force; at most MAX_PLACES.

    >>> from pitchpoint.contact.triangles import TriangleSurface
    >>> one = TriangleSurface(np.eye(3), np.array([[0, 1, 2]])).packed()
    >>> places = np.zeros((MAX_PLACES, PLACE))
    >>> int(sphere_places(one.ctypes.data, np.ones(3), 1.2, places)), round(float(places[0, 0]), 6)
    (1, 1.154701)
    """
    tree = tree_of(where)
    faces = faces_of(where)
    n = 0
    k = 0
    while k < tree.shape[0]:
        if box_distance(tree, k, y) >= radius * radius:
            k = int(tree[k, 6])
            continue
        first = int(tree[k, 7])
        for face in range(first, first + int(tree[k, 8])):
            qx, qy, qz, feature = on_triangle(faces, face, y)
            d = math.sqrt((y[0] - qx) ** 2 + (y[1] - qy) ** 2 + (y[2] - qz) ** 2)
            if d >= radius or not is_nearest_around(where, y, face, feature, qx, qy, qz):
                continue
            shadowed = False
            kept = 0
            for h in range(n):  # a deeper similar contact shadows this one; this one shadows shallower ones
                if _same_direction(places, h, d, y, qx, qy, qz):
                    if places[h, 0] <= d:
                        shadowed = True
                    else:
                        continue
                if kept != h:
                    for c in range(PLACE):
                        places[kept, c] = places[h, c]
                kept += 1
            n = kept
            if not shadowed and n < MAX_PLACES:
                places[n, 0] = d
                places[n, 1] = face
                places[n, 2] = feature
                places[n, 3] = qx
                places[n, 4] = qy
                places[n, 5] = qz
                n += 1
        k += 1
    return n
