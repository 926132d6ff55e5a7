# SPDX-License-Identifier: Apache-2.0
"""Checks of the contact of tooth surfaces: no stiffness law with it, gear body and clamp within range."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError, Message
from pitchpoint.model.components.flank_contact import FlexibleContact
from pitchpoint.model.components.gear import Gear
from pitchpoint.model.keys import Place, defaults_of, keys_of

if TYPE_CHECKING:
    from pitchpoint.model.components.mesh import Mesh
    from pitchpoint.model.parts import Parts
    from pitchpoint.model.reading.reader import Reader

FITTED = ("sainsot", "half_plane")
"""Gear bodies that do not apply to every blank."""


def check_flank_contacts(parts: Parts, report: Reader) -> None:
    """Report a stiffness law with a contact, and flexible contacts whose teeth have no such body."""
    for name, mesh in parts.meshes.items():
        if mesh.contact is None:
            continue
        if mesh.stiffness != defaults_of(type(mesh))["stiffness"]:
            report.problem(
                ("meshes", name, "stiffness"),
                "cannot be combined with contact, whose forces follow from the tooth surfaces",
                value=f"law: {mesh.stiffness.law}",
                remedy="remove stiffness or contact",
                taint=False,
            )
        if isinstance(mesh.contact, FlexibleContact) and mesh.contact.teeth == "analytic":
            _check_bodies(parts, name, mesh, mesh.contact, report)


def _check_bodies(parts: Parts, name: str, mesh: Mesh, contact: FlexibleContact, report: Reader) -> None:
    """Report gears to which body, clamp or blank of an analytic tooth do not apply."""
    from pitchpoint.contact.compliance.blank import Blank
    from pitchpoint.contact.compliance.gear import gear_slice

    for label in mesh.gears:
        gear = parts.gears.get(label)
        if gear is None or ("gears", label) in report.tainted:
            continue
        try:
            part = gear_slice(
                gear.geometry,
                material=gear.material_data,
                blank=Blank(
                    bore_diameter=gear.bore_diameter or None,
                    rim_thickness=gear.rim_thickness,
                    web_thickness=gear.web_thickness,
                ),
                body=contact.body,
                clamp=contact.clamp,
            )
            if contact.body in FITTED:
                part.ground  # noqa: B018 - computed for its range
        except GeometryError as error:
            _report(error.problem, label, ("meshes", name, "contact"), report)


def _report(found: Message, gear: str, contact: Place, report: Reader) -> None:
    """Report a problem of the teeth of a gear at its key in the gear, else at the contact."""
    key = found.where.removeprefix("compliance.")
    if key.startswith("tooth_profile"):  # reported by the check of the gear
        return
    if key in keys_of(Gear):
        report.hand_on(("gears", gear), found, taint=False)
        return
    if key in keys_of(FlexibleContact):
        found = found.changed(where=key, text=f"{found.text}, for gear {gear}")
    else:
        found = found.changed(where="body", text=f"is the {key} of gear {gear} and {found.text}")
    report.hand_on(contact, found, taint=False)
