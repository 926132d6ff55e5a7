# SPDX-License-Identifier: Apache-2.0
"""Checks of spheres in seats: on the axis of a hollow cone or a ring they touch along a circle."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pitchpoint.model.frames import GROUND, axes_of, place_of, split
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.contact import ContactSurface, SurfaceContact
    from pitchpoint.model.parts import Parts

CENTRED = 0.02
"""Distance of a sphere from the axis of its seat, over its radius, below which it touches along a circle."""


def seat_of(contact: SurfaceContact) -> tuple[ContactSurface, ContactSurface] | None:
    """Sphere of a contact, and the hollow cone or the ring that it may touch along a circle; or None.

    Parameters
    ----------
    contact
        The contact.
    """
    for ball, seat in ((contact.first, contact.second), (contact.second, contact.first)):
        round_seat = seat.shape == ("cone" if seat.hollow else "torus")
        if ball.shape == "sphere" and not ball.hollow and round_seat:
            return ball, seat
    return None


def check_seats(parts: Parts, report: Reader) -> None:
    """Check that no sphere with a single contact point is on the axis of its seat."""
    for name, contact in parts.surface_contacts.items():
        at: Place = ("surface_contacts", name)
        pair = seat_of(contact)
        if pair is None or contact.line or report.tainted & {at, (*at, "ends"), (*at, "line")}:
            continue
        ball, seat = pair
        offset = _offset(parts, contact, seat)
        if offset is None or ball.radius is None or offset >= CENTRED * ball.radius:
            continue
        if seat.shape == "torus" and not ball.radius > (seat.radius or 0.0) - (seat.tube or 0.0):
            continue  # it passes through the hole
        report.problem(
            at,
            f"is between a sphere and a {'hollow cone' if seat.hollow else 'torus'} that touch along a "
            f"circle: the centre is {1e3 * offset:.3g} mm from the axis",
            limit=f">= {1e3 * CENTRED * ball.radius:.3g} mm for a single contact point",
            remedy="hold the sphere by a joint instead"
            if contact.permanent
            else "write line: true, and the law for the whole circle",
        )


def _offset(parts: Parts, contact: SurfaceContact, seat: ContactSurface) -> float | None:
    """Distance of the centre of the sphere from the axis of its seat [m]; None if a place is unknown."""
    known = (*parts.bodies, *parts.beams, GROUND)
    if any(split(end)[0] not in known for end in contact.ends):
        return None
    ball, base = contact.ends if seat is contact.second else contact.ends[::-1]
    centre, origin = place_of(parts, ball), place_of(parts, base)
    if centre is None or origin is None:
        return None
    axis = axes_of(parts, base)[:, 2]
    along = float((centre - origin) @ axis)
    return math.sqrt(max(0.0, float((centre - origin) @ (centre - origin)) - along * along))
