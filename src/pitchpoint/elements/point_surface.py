# SPDX-License-Identifier: Apache-2.0
"""Contact of a point or sphere of body i with a plane, sphere, cylinder, cone, torus or triangles of body j.

The centre of the sphere is the origin of the marker of body i; the surface is given in the axes of the marker
of body j (contact/surface.py). Shapes may be convex or hollow; a hollow cone may be touched along a circle
(elements/contacts/seat.py). With triangles, up to four contacts with
different normals are simultaneous (a ball in an edge of a box); of faces with similar normals the deepest is
used.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.contact.surface import CONE, NAMES, PLANE, TORUS, TRIANGLES, distance
from pitchpoint.contact.triangle_search import PLACE, nearest_place, signed_place, sphere_places
from pitchpoint.contact.triangles import TriangleSurface
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.contacts.record import EVENTS, RECORD, RESULTS, set_triangles
from pitchpoint.elements.contacts.seat import circle_of_contact
from pitchpoint.elements.contacts.surface_place import curvature_in_world, point_place
from pitchpoint.elements.contacts.wrench import act, begin, finish
from pitchpoint.elements.kind import FRAME, Kind
from pitchpoint.elements.signal import Pool
from pitchpoint.multibody.channels import frame_args
from pitchpoint.multibody.vectors import into_world, triple

__all__ = ["EVENTS", "KIND", "OUTPUTS", "RECORD", "entry", "point_surface", "set_mesh", "set_surface"]

OUTPUTS = RESULTS


def set_surface(
    record: np.void,
    form: str,
    size: ArrayLike = (),
    radius: float = 0.0,
    hollow: bool = False,
    line: bool = False,
) -> None:
    """Set the sphere and the surface of body j of a contact.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`); markers and law are set separately.
    form
        "plane", "sphere", "cylinder", "cone" or "torus".
    size
        Radius [m] of sphere and cylinder, half angle [rad] of the cone, radius of the ring and of the tube
        [m] of the torus.
    radius
        Radius of the sphere of body i, 0 for a point [m].
    hollow
        Material outside the surface: a bore, a cup, a groove.
    line
        Hollow cone: contact along a circle, to which the law applies as a whole.
    """
    needed = {PLANE: 0, TORUS: 2}.get(NAMES[form], 1)
    given = np.atleast_1d(np.asarray(size, float))
    if given.size != needed or np.any(given <= 0.0):
        raise ValueError(f"size: a {form} has {needed} sizes (limit above 0)")
    if NAMES[form] == CONE and given[0] >= 0.5 * np.pi:
        raise ValueError(f"size: half angle {given[0]:g} rad of the cone (limit below pi/2)")
    if line and not (NAMES[form] == CONE and hollow):
        raise ValueError("line contact of a sphere requires a hollow cone")
    record["form_j"], record["radius"], record["stations"] = NAMES[form], radius, int(line)
    record["size_j"][:needed] = given
    record["sense"] = -1.0 if hollow else 1.0
    record["margin"] = np.inf


def set_mesh(
    record: np.void, pool: Pool, surface: TriangleSurface, radius: float = 0.0, depth: float | None = None
) -> None:
    """Set the sphere and the triangles of body j of a contact.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`); markers and law are set separately.
    pool
        Pool of the kind.
    surface
        Triangles of body j, closed wherever contact is possible.
    radius
        Radius of the sphere of body i, 0 for a point [m].
    depth
        Maximum depth of the centre of the sphere below the surface for contact, and maximum gap that is
        reported [m]; None: the size of a closed surface, so that contact is never lost, and 5 % of the size
        of an open one.
    """
    set_triangles(record, "j", pool, surface)
    record["radius"] = radius
    usual = surface.size() * (1.0 if surface.is_closed() else 0.05)
    record["depth"] = usual if depth is None else depth
    record["margin"] = record["depth"]


@kernel
def place_on_shape(b, f, g):
    """Place the contact of a sphere with a surface of simple shape; returns the normal in world axes."""
    phi, nx, ny, nz = distance(b["form_j"], b["size_j"], b["sense"], b["d"], b["V"])
    curvature_in_world(b["Ej"], b["V"], b["W"])
    m = into_world(b["Ej"], (nx, ny, nz))
    point_place(b, f, g, triple(b["oi"], 0), m, phi - b["radius"], b["radius"], 1.0)
    return m


@kernel
def _at_hit(b, c, f, g, kk, where):
    """Add the contact of a sphere with one point of a triangle surface."""
    phi, nx, ny, nz = signed_place(where, b["d"], b["hit"], b["V"])
    curvature_in_world(b["Ej"], b["V"], b["W"])
    m = into_world(b["Ej"], (nx, ny, nz))
    point_place(b, f, g, triple(b["oi"], 0), m, phi - b["radius"], b["radius"], 1.0)
    act(b, c, f, g, kk)


@kernel
def _on_triangles(b, c, f, g, kk):
    """Add the contact of a sphere with a triangle surface."""
    where = b["pool"] + 8 * b["start_j"]
    if not nearest_place(where, b["d"], b["radius"] + b["depth"], b["hit"]):
        return
    phi, nx, ny, nz = signed_place(where, b["d"], b["hit"], b["V"])
    if phi < -b["depth"]:
        return
    if phi <= 0.0 or phi >= b["radius"]:
        _at_hit(b, c, f, g, kk, where)
        return
    for k in range(sphere_places(where, b["d"], b["radius"], b["touching"])):
        for h in range(PLACE):
            b["hit"][h] = b["touching"][k, h]
        _at_hit(b, c, f, g, kk, where)


@kernel
def point_surface(rec, ctl, fr, kk):
    """Wrenches, tangents and results of all contacts of spheres with surfaces."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        begin(b, f, g)
        b["side"] = 1.0
        if b["form_j"] == TRIANGLES:
            _on_triangles(b, c, f, g, kk)
        elif b["stations"] > 0:
            circle_of_contact(b, c, f, g, kk)
        else:
            place_on_shape(b, f, g)
            act(b, c, f, g, kk)
        finish(b, ctl, 0)
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return point_surface(view(rec, n, RECORD), c, fr, kk)


KIND = Kind(
    name="point_surface",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    events=EVENTS,
    body_fixed=True,
    sections={"surface_contacts": ""},
)
