# SPDX-License-Identifier: Apache-2.0
"""Contacts of a scene as entries of its header, see `docs/scene_format.md`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.viz.scene_contact import ContactFlank, SceneContact
from pitchpoint.viz.scene_numbers import LENGTH, Block, unseen

_LOADS, _FORCES = 255, 8191
"""Steps from zero to the largest load, which is a colour, and to the largest force, which is a number."""
_GAP = 5e-9
"""Largest error of a penetration [m]."""


def contact_entry(contact: SceneContact, block: Block) -> dict[str, Any]:
    """Header of one mesh; its numbers go into the block.

    Parameters
    ----------
    contact
        The mesh.
    block
        Numbers of the scene.

    Raises
    ------
    ValueError
        If a number is not finite.
    """
    for track in (contact.at, contact.axes, contact.pressure_angle, contact.penetration):
        if not np.isfinite(track).all():
            raise ValueError(f"{contact.name}: holds numbers that are not finite")
    # an angle is as exact as what it places: the ends of the lines
    angle = LENGTH / max(map(abs, (*contact.width, *contact.path)))
    found = {
        "name": contact.name,
        "at": block.put_track(contact.at, LENGTH),
        "axes": block.put_track(_quaternions(contact.axes), 0.5 * angle),
        "pressure_angle": block.put_track(contact.pressure_angle, angle),
        "base_helix": contact.base_helix,
        "base_pitch": contact.base_pitch,
        "width": list(contact.width),
        "path": list(contact.path),
        **({} if contact.cone is None else {"cone": list(contact.cone)}),
        "penetration": block.put_track(contact.penetration, unseen(contact.penetration, _GAP)),
        "flanks": [_flank(flank, block) for flank in contact.flanks],
    }
    if contact.unit_pressure is not None:
        found["unit_pressure"] = block.put(contact.unit_pressure, "f4")
    return found


def _flank(flank: ContactFlank, block: Block) -> dict[str, Any]:
    found: dict[str, Any] = {"side": flank.side, "travel": block.put_track(flank.travel, LENGTH)}
    if flank.forces.shape[1]:
        # zero stays zero: it states that a pair does not touch
        found["forces"] = block.put_steps(flank.forces, _largest(flank.forces) / _FORCES)
        found["loads"] = block.put_steps(flank.loads, _largest(flank.loads) / _LOADS, across=True)
    found["surfaces"] = [
        {
            "body": surface.body,
            "gear": surface.gear,
            "teeth": surface.teeth,
            "points": block.put_steps(surface.points, 1e-7 * _largest(surface.points)),
            "turn": surface.turn,
            "tooth": surface.tooth,
            "step": surface.step,
        }
        for surface in flank.surfaces
    ]
    return found


def _largest(values: NDArray[np.float64]) -> float:
    return float(np.abs(values).max(initial=0.0))


def _quaternions(axes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Quaternions (x, y, z, w) of frames, shape (n, 3, 3), each on the side of the one before."""
    from scipy.spatial.transform import Rotation

    found = Rotation.from_matrix(axes).as_quat()
    turned = np.sign(np.einsum("ni,ni->n", found[1:], found[:-1]))
    found[1:] *= np.cumprod(np.where(turned < 0.0, -1.0, 1.0))[:, None]
    return found
