# SPDX-License-Identifier: Apache-2.0
"""Settings of the meshes of planets: of all planets of a stage, and of a single one."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.flank_contact import FlankContact
from pitchpoint.model.components.mesh import (
    Backlash,
    ContactDamping,
    Damper,
    Friction,
    Mesh,
    Misalignment,
    TransientDamping,
    TransmissionError,
)
from pitchpoint.model.components.stiffness import StiffnessLaw
from pitchpoint.model.keys import keys_of, same_key


@dataclass(frozen=True, kw_only=True)
class StageMesh(Component):
    """Settings of all meshes of the planets with the sun, with the ring, or with other planets."""

    backlash: Backlash | None = same_key(Mesh, "backlash")
    stiffness: StiffnessLaw = same_key(Mesh, "stiffness")
    contact: FlankContact | None = same_key(Mesh, "contact")
    width: str = same_key(Mesh, "width")
    slices: int = same_key(Mesh, "slices")
    damping: ContactDamping | None = same_key(Mesh, "damping")
    damper: Damper | None = same_key(Mesh, "damper")
    transient_damping: TransientDamping | None = same_key(Mesh, "transient_damping")
    friction: Friction | None = same_key(Mesh, "friction")
    transmission_error: TransmissionError | None = same_key(Mesh, "transmission_error")
    misalignment: Misalignment | None = same_key(Mesh, "misalignment")

    def between(self, gears: tuple[str, str], own: SingleMesh, **more: object) -> Mesh:
        """Mesh of two gears with these settings, and those of a single planet."""
        values = {name: getattr(self, name) for name in keys_of(StageMesh)} | own.given
        return Mesh(gears=gears, **values, **more)  # type: ignore[arg-type]


@dataclass(frozen=True, kw_only=True)
class SingleMesh(Component):
    """Settings of one mesh of a single planet that replace the common ones."""

    backlash: Backlash | None = same_key(Mesh, "backlash")
    damping: ContactDamping | None = same_key(Mesh, "damping")
    damper: Damper | None = same_key(Mesh, "damper")
    friction: Friction | None = same_key(Mesh, "friction")
    transmission_error: TransmissionError | None = same_key(Mesh, "transmission_error")
    misalignment: Misalignment | None = same_key(Mesh, "misalignment")

    @property
    def given(self) -> dict[str, object]:
        """Settings that are not those of the stage."""
        values = {name: getattr(self, name) for name in keys_of(SingleMesh)}
        return {name: value for name, value in values.items() if value is not None}
