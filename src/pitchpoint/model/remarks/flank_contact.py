# SPDX-License-Identifier: Apache-2.0
"""Remarks on meshes with contact of tooth surfaces: keys without effect, inaccurate tables."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from pitchpoint.contact.potential_accuracy import inaccuracy
from pitchpoint.core.errors import Message, remark
from pitchpoint.model.components.flank_contact import FlexibleContact, PrecomputedContact, RigidContact
from pitchpoint.model.keys import defaults_of
from pitchpoint.model.stage_members import SECTION as STAGES

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def contact_keys(model: Model) -> Iterator[Message]:
    """Keys of a mesh and its contact that other keys replace."""
    for name, mesh in model.meshes.items():
        if mesh.contact is None:
            continue
        usual = defaults_of(type(mesh))
        if mesh.stiffness != usual["stiffness"] or _written(model, name, "stiffness"):
            yield remark(
                f"meshes.{name}.stiffness",
                f"has no effect with contact, level: {mesh.contact.level}, which determines the stiffness",
                "remove stiffness, or contact",
            )
        for key in ("width", "slices"):
            if getattr(mesh, key) != usual[key]:
                yield remark(
                    f"meshes.{name}.{key}",
                    "has no effect with contact, which divides the face width into contact planes",
                    "give planes of the contact",
                )
        at = f"meshes.{name}.contact"
        if isinstance(mesh.contact, FlexibleContact):
            yield from _analytic_keys(mesh.contact, at)
        elif isinstance(mesh.contact, RigidContact):
            yield from _depth(mesh.contact, at)


def _written(model: Model, mesh: str, key: str) -> bool:
    """Whether the file gives a key of a mesh, possibly with the value of its default."""
    places: list[tuple[str | int, ...]] = [("meshes", mesh, key)]
    for name, stage in model.planetary_stages.items():
        places += [(STAGES, name, *group.key, key) for group in stage.groups if mesh in group.names]
    return any(place in (model.lines or {}) for place in places)


def inaccurate_tables(model: Model) -> Iterator[Message]:
    """Contact tables whose measured errors exceed their limits."""
    for name, mesh in model.meshes.items():
        if isinstance(mesh.contact, PrecomputedContact) and mesh.contact.tables is not None:
            poor = inaccuracy({flank: one.errors for flank, one in mesh.contact.tables.tables.items()})
            if poor is not None:
                yield poor.changed(where=f"meshes.{name}.contact.file", kind="remark")


def _analytic_keys(contact: FlexibleContact, at: str) -> Iterator[Message]:
    """Keys of analytic teeth given for teeth from finite elements."""
    if contact.teeth == "analytic":
        return
    usual = defaults_of(FlexibleContact)
    for key in ("body", "clamp"):
        if getattr(contact, key) != usual[key]:
            yield remark(
                f"{at}.{key}",
                "has no effect on teeth: finite_elements, which contain the gear body; only the stiffness to "
                "which damping ratios and overlap refer follows it",
                "write teeth: analytic to use it",
            )
    if contact.coupling != usual["coupling"]:
        yield remark(
            f"{at}.coupling",
            "has no effect with teeth: finite_elements, which are coupled over the face width",
            "write teeth: analytic to use it",
        )


def _depth(contact: RigidContact, at: str) -> Iterator[Message]:
    if contact.exponent == 1.0 and contact.depth != defaults_of(RigidContact)["depth"]:
        yield remark(f"{at}.depth", "has no effect with exponent: 1, where the stiffness is constant")
