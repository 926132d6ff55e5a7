# SPDX-License-Identifier: Apache-2.0
"""All that the elastic contact of a mesh depends on, as plain data: identity of a pre-computed contact."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.model.write import plain_component

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

WITHOUT_EFFECT = (
    "mass",
    "polar_inertia",
    "transverse_inertia",
    "solid",
    "drawing_resolution",
    "initial_angle",
)
"""Keys of a gear on which its contact does not depend."""


def contact_inputs(model: Model, mesh: str, contact: Any) -> dict[str, Any]:
    """Both gears with their micro-geometry and materials, their position, and the options of the contact.

    Parameters
    ----------
    model
        The model.
    mesh
        Name of the mesh.
    contact
        Options of the flexible contact, or plain data of them.
    """
    part = model.meshes[mesh]
    found: dict[str, Any] = {}
    for k, name in enumerate(part.gears, start=1):
        gear = model.gears[name]
        keys = {key: v for key, v in plain_component(gear).items() if key not in WITHOUT_EFFECT}
        found[f"gear_{k}"] = {**keys, "profile_shift_coefficient": gear.geometry.x}
    found["center_distance"] = abs(model.pairs[mesh].a_w)
    found["offsets"] = [part.offset1, part.offset2]
    found["contact"] = contact if isinstance(contact, dict) else plain_component(contact)
    return found
