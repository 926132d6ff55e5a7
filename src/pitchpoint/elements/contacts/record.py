# SPDX-License-Identifier: Apache-2.0
"""Record of all contact kinds, and the functions that fill it.

Body i touches body j. Each has a marker, a frame fixed to the body (`S`), in which its shape is defined. The
unit normal n points out of body j. A contact has a point Q on body i, or at the centre of its rounding, at
the signed distance phi from body j; with the radius r of the rounding the gap is h = phi - r. (For a point of
body j on triangles of body i, Q is on j.) Forces act halfway between the two surfaces, at P = Q - (r + h/2)
n, so that exchanging the bodies does not change the result.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.contact.curve import Curve
from pitchpoint.contact.curve_pair import HIT, MAX_CONTACTS
from pitchpoint.contact.impact import CONTACT_LAW
from pitchpoint.contact.surface import TRIANGLES
from pitchpoint.contact.triangle_search import MAX_PLACES, PLACE
from pitchpoint.contact.triangles import TriangleSurface
from pitchpoint.elements.signal import Pool

MAX_STATIONS = 8
"""Maximum number of points along a contact line."""

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + CONTACT_LAW
    + [
        ("row", "i8"),  # constraint row of a permanent contact; written by the layout
        ("pi", "f8", 3),  # marker on body i, axes S [m]
        ("Bi", "f8", (3, 3)),  # its axes, columns in axes S
        ("pj", "f8", 3),  # marker on body j
        ("Bj", "f8", (3, 3)),
        ("form_i", "i8"),  # surface of body i (contact/surface.py)
        ("form_j", "i8"),
        ("size_i", "f8", 2),  # its sizes [m]
        ("size_j", "f8", 2),
        ("sense", "f8"),  # 1: material inside the surface of j, -1: outside
        ("radius", "f8"),  # radius of the roller or sphere on body i [m]
        ("depth", "f8"),  # maximum overlap in contact [m]; a larger overlap is with the opposite side
        ("deepest", "f8"),  # planar curves: overlap up to which at least the nearest point is in contact [m]
        ("margin", "f8"),  # maximum gap that is searched and reported [m]
        ("length", "f8"),  # reference length of the contact line for the law [m]
        ("stations", "i8"),  # Gauss points along the contact line; 0: no line contact
        ("along", "f8", (MAX_STATIONS, 2)),  # their positions from 0 to 1, and weights
        ("ev", "i8"),
        ("pool", "i8"),
        ("start_i", "i8"),  # curve or triangles of body i in the pool
        ("rows_i", "i8"),
        ("start_j", "i8"),
        ("rows_j", "i8"),
        ("oi", "f8", 3),  # scratch from here: markers in world axes
        ("Ei", "f8", (3, 3)),
        ("oj", "f8", 3),
        ("Ej", "f8", (3, 3)),
        ("M", "f8", (3, 3)),  # axes of marker i in those of marker j
        ("d", "f8", 3),  # position of marker i relative to marker j, axes of j
        ("reach", "f8", 7),
        ("hits", "f8", (MAX_CONTACTS, HIT)),
        ("Q", "f8", 3),
        ("n", "f8", 3),
        ("y", "f8", 3),  # a point in axes of the marker of a surface
        ("V", "f8", (3, 3)),  # Hessian of the distance there, in axes of the marker
        ("W", "f8", (3, 3)),  # the same in world axes
        ("hit", "f8", PLACE),  # contact point on triangles
        ("touching", "f8", (MAX_PLACES, PLACE)),
        ("dQ", "f8", (3, 12)),  # derivatives of Q and n for the motions of bodies i and j
        ("dn", "f8", (3, 12)),
        ("h", "f8"),  # gap [m]
        ("r", "f8"),  # from Q to the surface of body i [m]
        ("side", "f8"),  # 1: Q belongs to body i, -1: to body j
        ("weight", "f8"),  # factor of the law: fraction of a line, or an area
        ("gap", "f8"),  # results: smallest gap
        ("normal", "f8"),  # sum of the normal forces
        ("sliding", "f8"),  # sum of the friction forces
        ("loss", "f8"),  # power loss
        ("energy", "f8"),  # stored energy
        ("place", "f8", 5),  # position of the smallest gap: P in axes of marker j, arc lengths on i and j
        ("out", "i8"),
    ],
    align=True,
)

RESULTS = (
    ("contact_force", "N", "normal force of the contact, sum over all contact points"),
    ("friction_force", "N", "friction force of the contact, sum over all contact points"),
    ("gap", "m", "smallest gap; negative in contact"),
    ("contact_power_loss", "W", "power loss in the contact"),
    ("elastic_energy", "J", "energy stored in the contact"),
    ("contact_location[{}.x]", "m", "deepest point of the contact along x of the marker of the second body"),
    ("contact_location[{}.y]", "m", "deepest point of the contact along y of the marker of the second body"),
    ("contact_location[{}.z]", "m", "deepest point of the contact along z of the marker of the second body"),
)
EVENTS = (("contact", "contact opens or closes"),)
PATHS = (
    ("contact_path[{}.i]", "m", "position of the contact along the curve of the first body"),
    ("contact_path[{}.j]", "m", "position of the contact along the curve of the second body"),
)


def new_records(n: int) -> np.ndarray:
    """Records with markers at the body origins, along the body axes.

    Parameters
    ----------
    n
        Number of records.
    """
    records = np.zeros(n, RECORD)
    records["Bi"] = records["Bj"] = np.eye(3)
    records["sense"] = 1
    return records


def set_marker(record: np.void, body: str, point: ArrayLike, axes: ArrayLike | None = None) -> None:
    """Set the marker of a contact on one body.

    Parameters
    ----------
    record
        Record of the contact.
    body
        "i" or "j".
    point
        Origin of the marker in the axes S of the body [m], shape (3,).
    axes
        Axes of the marker as columns in axes S, right-handed, shape (3, 3); None: those of the body.
    """
    record["p" + body] = point
    B = np.eye(3) if axes is None else np.asarray(axes, float)
    if np.abs(B.T @ B - np.eye(3)).max() > 1e-9 or np.linalg.det(B) < 0.0:
        raise ValueError("the axes of a marker are a right-handed orthonormal frame")
    record["B" + body] = B


def set_curve(record: np.void, body: str, pool: Pool, curve: Curve) -> None:
    """Set the curve of one body of a contact.

    Parameters
    ----------
    record
        Record of the contact.
    body
        "i" or "j".
    pool
        Pool of the kind.
    curve
        Curve in the plane of the marker; it encloses the material counter-clockwise about the third axis.
    """
    record["start_" + body], record["rows_" + body] = pool.add(curve.rows), len(curve.rows)
    if body == "j":
        record["reach"][3:6] = curve.circle()


def set_triangles(record: np.void, body: str, pool: Pool, surface: TriangleSurface) -> None:
    """Set the triangle surface of one body of a contact.

    Parameters
    ----------
    record
        Record of the contact.
    body
        "i" or "j".
    pool
        Pool of the kind.
    surface
        Surface in axes of the marker.
    """
    record["start_" + body], record["rows_" + body] = pool.add(surface.packed()), len(surface.faces)
    record["form_" + body] = TRIANGLES
