# SPDX-License-Identifier: Apache-2.0
"""Contacts of a scene as entries of its header, see `docs/scene_format.md`."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.viz.scene_contact import ContactFlank, SceneContact

_LEVELS = 255


class Numbers(Protocol):
    """A block of numbers that grows."""

    def put(self, values: ArrayLike, kind: str) -> dict[str, Any]:
        """Where an array lies."""
        ...

    def put_coarse(self, values: ArrayLike) -> dict[str, Any]:
        """The same in 16 bits, each column between its least and its largest value."""
        ...


def contact_entry(contact: SceneContact, block: Numbers) -> dict[str, Any]:
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
    return {
        "name": contact.name,
        "at": block.put_coarse(contact.at),
        "axes": block.put_coarse(_quaternions(contact.axes)),
        "pressure_angle": block.put_coarse(contact.pressure_angle),
        "base_helix": contact.base_helix,
        "base_pitch": contact.base_pitch,
        "width": list(contact.width),
        "path": list(contact.path),
        **({} if contact.cone is None else {"cone": list(contact.cone)}),
        "penetration": block.put_coarse(contact.penetration),
        "flanks": [_flank(flank, block) for flank in contact.flanks],
    }


def _flank(flank: ContactFlank, block: Numbers) -> dict[str, Any]:
    found: dict[str, Any] = {"side": flank.side, "travel": block.put(flank.travel, "f8")}
    if flank.forces.shape[1]:
        found["forces"] = block.put_coarse(flank.forces)
        found["loads"] = _bytes(flank.loads, block)
    found["surfaces"] = [
        {
            "body": surface.body,
            "gear": surface.gear,
            "teeth": surface.teeth,
            "points": block.put(surface.points, "f4"),
            "turn": surface.turn,
            "tooth": surface.tooth,
            "step": surface.step,
        }
        for surface in flank.surfaces
    ]
    return found


def _bytes(values: NDArray[np.float64], block: Numbers) -> dict[str, Any]:
    """In 8 bits from zero to the largest of all: what a colour tells."""
    step = float(values.max(initial=0.0)) / _LEVELS
    levels = np.rint(values / step) if step > 0.0 else values
    size = values.shape[-1]
    return {**block.put(levels, "u1"), "scale": [step] * size, "offset": [0.0] * size}


def _quaternions(axes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Quaternions (x, y, z, w) of frames, shape (n, 3, 3), each on the side of the one before."""
    from scipy.spatial.transform import Rotation

    found = Rotation.from_matrix(axes).as_quat()
    turned = np.sign(np.einsum("ni,ni->n", found[1:], found[:-1]))
    found[1:] *= np.cumprod(np.where(turned < 0.0, -1.0, 1.0))[:, None]
    return found
