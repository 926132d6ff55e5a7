# SPDX-License-Identifier: Apache-2.0
"""Bodies that their helical gears load with a moment and whose bearings let them tilt.

The axial force F_a of a helical mesh acts at the radius r of the gear and tilts the body by F_a r. On a
planet the axial forces of sun and ring cancel, and their moments add up to 2 F_a r. Bearings at
one position, with clearance, support little of such a moment.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from pitchpoint.geometry.bearings.inner import NEEDLE_TYPES
from pitchpoint.model.axial_supports import held_otherwise, is_pushed_by_teeth, on_bearings_only
from pitchpoint.model.frames import body_frame
from pitchpoint.model.rings import ring_bodies, rings_of

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

STIFF = ("ball", "roller", "double_row_angular_contact_ball", *NEEDLE_TYPES)
"""Bearings that may support a moment at one position: of two rows, of long rollers, or with data as given."""
TOGETHER = 1e-6
"""Distance of bearings along the axis [m] up to which they support no moment."""


class TiltSupport(NamedTuple):
    """Bearings of a body at one position, which support little or no moment.

    Attributes
    ----------
    body
        Name of the body or shaft.
    bearings
        Names of all its bearings.
    """

    body: str
    bearings: tuple[str, ...]


def without_tilt_support(model: Model) -> Iterator[TiltSupport]:
    """Bodies with helical gears whose bearings, all at one position, support little or no moment.

    Needle roller, double-row angular contact and plain bearings, and linear ones with `tilt`, are assumed to
    support it, and so are springs, contacts, couplings and joints.
    """
    if model.others:
        return
    on_pins = on_bearings_only(model)
    held = held_otherwise(model, on_pins) | {b for c in model.couplings.values() for b in c.bodies}
    bearings = _bearings(model, on_pins)
    for name, body in model.bodies.items():
        helical = any(model.gears[gear].geometry.beta != 0.0 for gear in body.gears)
        if not (body.moves == "free" or name in on_pins) or name in held or not helical:
            continue
        own = bearings.get(name, {})
        places = [place for place, _ in own.values()]
        tilts = bool(own) and not any(stiff for _, stiff in own.values())
        if tilts and max(places) - min(places) <= TOGETHER and is_pushed_by_teeth(model, name):
            yield TiltSupport(name, tuple(own))


def _bearings(model: Model, on_pins: set[str]) -> dict[str, dict[str, tuple[float, bool]]]:
    """Bearings of every body: position along its axis [m], and whether they support a moment."""
    found: dict[str, dict[str, tuple[float, bool]]] = {}
    for name, linear in model.bearings.items():
        matrix = linear.stiffness.matrix6()
        stiff = any(matrix[i][j] != 0.0 for i in (3, 4) for j in (3, 4))
        found.setdefault(linear.body, {})[name] = linear.position[2], stiff
    for name, plain in model.plain_bearings.items():
        for body in ring_bodies(plain):
            found.setdefault(body, {})[name] = 0.0, True
    for name, rolling in model.rolling_bearings.items():
        inner, outer = rings_of(model, rolling)
        own = outer.body if outer.body in on_pins else inner.body
        origin, axes = body_frame(model, own)
        along = 0.0
        if origin is not None and inner.place is not None:
            along = float(axes[:, 2] @ (inner.place - origin))
        found.setdefault(own, {})[name] = along, rolling.geometry.kind in STIFF
    return found
