# SPDX-License-Identifier: Apache-2.0
"""Contact of two surfaces: cylinders, cones and rings in line or point contact, triangles.

A cylinder extends along the z axis of its marker, from -length/2 to length/2; a ring (torus; a disc if its
tube radius is zero) is in the plane z = 0. For spheres use the kind point_surface.

* cylinder on a plane, on a cylinder or in a bore: line contact (elements/contacts/line.py), parallel or
  tilted; the law is for the whole line; flat ends;
* cone on a plane: line contact along its flank, as a cylinder;
* ring on a plane: contact at the lowest point of the circle;
* ring on a cylinder, cone or ring, also in a hollow one; ring around a sphere; cone on a cylinder or cone:
  contact points of swept balls (elements/contacts/swept.py);
* crossed cylinders: one contact point, on the common normal of the axes, which must not be parallel; round
  ends;
* triangles: contact at the centroid of every face that is inside the other body, weighted with half of the
  face area in either direction, so that finer triangles converge to an elastic foundation (law per area);
* triangles on a plane, cylinder, cone, torus or sphere: contact at the face centroids, weighted with the full
  face area, on the exact surface;
* plate on a plane: elastic foundation at Gauss points of the rectangle (contact/plate.py); law for the plate.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pitchpoint.contact.plate import plate_points
from pitchpoint.contact.surface import CONE, CYLINDER, PLANE, RIM, TRIANGLES
from pitchpoint.contact.triangles import TriangleSurface
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.contacts.crossed_cylinders import rim_place, rods_place
from pitchpoint.elements.contacts.line import line_of_contact
from pitchpoint.elements.contacts.record import EVENTS, MAX_STATIONS, RECORD, RESULTS, set_triangles
from pitchpoint.elements.contacts.swept import cone_of_contact, ring_of_contact
from pitchpoint.elements.contacts.triangles import points_on_shape, points_on_triangles
from pitchpoint.elements.contacts.wrench import act, begin, finish
from pitchpoint.elements.kind import FRAME, Kind
from pitchpoint.elements.point_surface import set_surface
from pitchpoint.elements.signal import Pool
from pitchpoint.multibody.channels import frame_args

__all__ = [
    "EVENTS",
    "KIND",
    "OUTPUTS",
    "RECORD",
    "entry",
    "set_cone_on_plane",
    "set_cone_on_surface",
    "set_crossed_cylinders",
    "set_cylinder_on_plane",
    "set_cylinders_in_line",
    "set_mesh_on_shape",
    "set_meshes",
    "set_plate_on_plane",
    "set_ring_on_plane",
    "set_ring_on_surface",
    "surface_surface",
]

OUTPUTS = RESULTS


def _set_line(record: np.void, radius: float, length: float, shared: float, stations: int) -> None:
    """Set the cylinder of body i and the Gauss points along its axis."""
    if not 1 <= stations <= MAX_STATIONS or not min(radius, length) > 0.0:
        raise ValueError("line contact: radius and length (limit above 0), stations (limit 1 to 8)")
    x, w = np.polynomial.legendre.leggauss(stations)
    record["form_i"], record["stations"], record["length"] = CYLINDER, stations, shared
    record["size_i"] = radius, length
    record["along"][:stations, 0], record["along"][:stations, 1] = 0.5 + 0.5 * x, 0.5 * w
    record["margin"] = np.inf


def set_cylinder_on_plane(record: np.void, radius: float, length: float, stations: int = 8) -> None:
    """Set the contact of a cylinder of body i with a plane of body j.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`); markers and law are set separately, the law for
        the whole length.
    radius, length
        Radius and length of the cylinder [m].
    stations
        Gauss points along every part of the line in contact, 1 to 8.
    """
    _set_line(record, radius, length, length, stations)
    record["form_j"] = PLANE


def set_cylinders_in_line(
    record: np.void,
    radii: Sequence[float],
    lengths: Sequence[float],
    hollow: bool = False,
    stations: int = 8,
) -> None:
    """Set the contact of a cylinder of body i with a cylinder or bore of body j, with nearly parallel axes.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`); markers and law are set separately, the law for
        the whole length of the shorter cylinder.
    radii, lengths
        Of bodies i and j [m]; without `hollow` the first cylinder should be the shorter one.
    hollow
        Body j is a bore.
    stations
        Gauss points along every part of the line in contact, 1 to 8.
    """
    if hollow and not radii[0] < radii[1]:
        raise ValueError(f"cylinder of radius {radii[0]:g} m in a bore (limit below {radii[1]:g} m)")
    if not min(*radii, *lengths) > 0.0:
        raise ValueError("cylinders: radii and lengths (limit above 0)")
    _set_line(record, radii[0], lengths[0], min(lengths), stations)
    record["form_j"], record["size_j"] = CYLINDER, (radii[1], lengths[1])
    record["sense"] = -1.0 if hollow else 1.0


def set_ring_on_plane(record: np.void, radius: float, tube: float = 0.0) -> None:
    """Set the contact of a ring or disc of body i with a plane of body j.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`); markers and law are set separately.
    radius
        Radius of the centre circle of the tube [m].
    tube
        Radius of the tube, 0 for the edge of a disc [m].
    """
    if radius <= 0.0 or tube < 0.0:
        raise ValueError("ring: radius (limit above 0), tube (limit 0 or above)")
    record["form_i"], record["form_j"] = RIM, PLANE
    record["size_i"] = radius, tube
    record["margin"] = np.inf


def set_ring_on_surface(
    record: np.void,
    ring: Sequence[float],
    form: str,
    size: Sequence[float],
    hollow: bool = False,
    line: bool = False,
) -> None:
    """Set the contact of a ring of body i with a cylinder, cone, torus or sphere of body j.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`); markers and law are set separately.
    ring
        Radius of the centre circle and of the tube [m]; the tube may be 0.
    form, size, hollow
        As in `point_surface.set_surface`; a cylinder with its length [m] as second size has flat ends.
    line
        The law is for the whole ring instead of each contact point.
    """
    if ring[0] <= 0.0 or ring[1] < 0.0:
        raise ValueError("ring: radius (limit above 0), tube (limit 0 or above)")
    _set_convex(record, form, size, hollow)
    record["form_i"], record["size_i"] = RIM, ring
    record["stations"] = 1 if line else 0


def _set_convex(record: np.void, form: str, size: Sequence[float], hollow: bool) -> None:
    """Set the surface of body j, a cylinder with its length if given."""
    of_length = form == "cylinder" and len(size) == 2
    if of_length and not size[1] > 0.0:
        raise ValueError(f"size: length {size[1]:g} m of the cylinder (limit above 0)")
    set_surface(record, form, size[:1] if of_length else size, 0.0, hollow)
    if of_length:
        record["size_j"][1] = size[1]


def _set_cone(record: np.void, half_angle: float, height: float) -> None:
    """Set the cone of body i."""
    if not (0.0 < half_angle < 0.5 * np.pi and height > 0.0):
        raise ValueError("cone: half angle (limit 0 to pi/2), height (limit above 0)")
    record["form_i"], record["size_i"] = CONE, (np.tan(half_angle), height)
    record["margin"] = np.inf


def set_cone_on_plane(record: np.void, half_angle: float, height: float, stations: int = 8) -> None:
    """Set the contact of a cone of body i with a plane of body j.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`); markers and law are set separately, the law for
        the whole flank from the tip, at the origin of the marker, to the base.
    half_angle, height
        Half angle [rad] and height [m] of the cone.
    stations
        Gauss points along every part of the line in contact, 1 to 8.
    """
    _set_line(record, np.tan(half_angle), height, height, stations)
    _set_cone(record, half_angle, height)
    record["form_j"] = PLANE


def set_cone_on_surface(
    record: np.void, half_angle: float, height: float, form: str, size: Sequence[float]
) -> None:
    """Set the contact of a cone of body i with a cylinder or cone of body j.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`); markers and law are set separately.
    half_angle, height
        Half angle [rad] and height [m] of the cone of body i; that of body j has no base.
    form, size
        As in `point_surface.set_surface`; a cylinder with its length [m] as second size has flat ends.
    """
    _set_convex(record, form, size, False)
    _set_cone(record, half_angle, height)
    record["radius"] = half_angle


def set_crossed_cylinders(record: np.void, radii: Sequence[float], lengths: Sequence[float]) -> None:
    """Set the contact of two crossed cylinders.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`); markers and law are set separately.
    radii, lengths
        Of the cylinders of bodies i and j [m].
    """
    if min(*radii, *lengths) <= 0.0:
        raise ValueError("cylinders: radii and lengths (limit above 0)")
    record["form_i"] = record["form_j"] = CYLINDER
    record["size_i"], record["size_j"] = (radii[0], lengths[0]), (radii[1], lengths[1])
    record["margin"] = np.inf


def set_meshes(
    record: np.void, pool: Pool, surfaces: Sequence[TriangleSurface], depth: float | None = None
) -> None:
    """Set the contact of two triangle surfaces.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`); markers and law are set separately, the law per
        area: K in N/m^(e+2), C in N s/m^3.
    pool
        Pool of the kind.
    surfaces
        Closed surfaces of bodies i and j.
    depth
        Maximum depth of a point inside the other body for contact, and maximum gap that is reported [m];
        None: 1 % of the smaller surface. Small values save time.
    """
    set_triangles(record, "i", pool, surfaces[0])
    set_triangles(record, "j", pool, surfaces[1])
    record["depth"] = 0.01 * min(s.size() for s in surfaces) if depth is None else depth
    record["margin"] = record["depth"]


def set_mesh_on_shape(
    record: np.void,
    pool: Pool,
    surface: TriangleSurface,
    form: str,
    size: Sequence[float] = (),
    hollow: bool = False,
    depth: float | None = None,
) -> None:
    """Set the contact of triangles of body i with a surface of simple shape of body j.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`); markers and law are set separately, the law per
        area: K in N/m^(e+2), C in N s/m^3.
    pool
        Pool of the kind.
    surface
        Triangles of body i.
    form, size, hollow
        As in `point_surface.set_surface`; a cylinder with its length [m] as second size has flat ends.
    depth
        Maximum depth of a point below the surface for contact [m]; None: no limit.
    """
    _set_convex(record, form, size, hollow)
    set_triangles(record, "i", pool, surface)
    record["depth"] = np.inf if depth is None else depth
    record["margin"] = np.inf


def set_plate_on_plane(
    record: np.void, pool: Pool, sides: Sequence[float], depth: float | None = None
) -> None:
    """Set the contact of a rectangular plate of body i with a plane of body j.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`); markers and law are set separately, the law for
        the whole plate.
    pool
        Pool of the kind.
    sides
        Lengths of the plate along x and y of its marker [m].
    depth
        Maximum penetration of a point for contact [m]; None: no limit.
    """
    if not min(sides) > 0.0:
        raise ValueError(f"plate: sides {sides[0]:g} m and {sides[1]:g} m (limit above 0)")
    record["form_i"], record["form_j"], record["start_i"] = TRIANGLES, PLANE, pool.add(plate_points(sides))
    record["depth"] = np.inf if depth is None else depth
    record["margin"] = np.inf


@kernel
def surface_surface(rec, ctl, fr, kk):
    """Wrenches, tangents and results of all surface pairs."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        begin(b, f, g)
        if b["form_j"] == TRIANGLES:
            points_on_triangles(b, c, f, g, kk)
        elif b["form_i"] == TRIANGLES:
            points_on_shape(b, c, f, g, kk)
        elif b["form_i"] == RIM and b["form_j"] != PLANE:
            ring_of_contact(b, c, f, g, kk, b["size_i"][0], b["size_i"][1], 0.0)
        elif b["form_i"] == CONE and b["form_j"] != PLANE:
            cone_of_contact(b, c, f, g, kk)
        elif b["stations"] > 0:
            line_of_contact(b, c, f, g, kk)
        elif b["form_j"] == CYLINDER:
            rods_place(b, f, g)
            act(b, c, f, g, kk)
        else:
            rim_place(b, f, g, b["size_i"][0], b["size_i"][1], 0.0, 1.0)
            act(b, c, f, g, kk)
        finish(b, ctl, 0)
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return surface_surface(view(rec, n, RECORD), c, fr, kk)


KIND = Kind(
    name="surface_surface",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    events=EVENTS,
    body_fixed=True,
    sections={"surface_contacts": ""},
)
