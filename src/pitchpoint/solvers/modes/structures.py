# SPDX-License-Identifier: Apache-2.0
"""Beams and blades of a machine as parts and components: all pieces of a beam, all blades of a rotor."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from pitchpoint.elements import registry
from pitchpoint.elements.kind import SIGNAL

if TYPE_CHECKING:
    from pitchpoint.system.system import System

BLADES = "blades of"
"""First words of the part and component of all blades of a rotor."""
AIR, ACTUATOR = "air on", "actuator"
"""First words of components: of the air on the blades of a rotor, of an actuator."""
LINK = ".link"
"""Begin of the end of the name of a tangent of an actuator."""


@dataclass(frozen=True)
class Structures:
    """Names of the parts and components of beams and blades.

    Parameters
    ----------
    bodies
        Part of every body that belongs to a beam or blade, by its name.
    beams
        Component of every beam that is a blade, by the name of the beam; "" for others: a component each.
    rotors
        Names of the wind rotors.
    """

    bodies: dict[str, str] = field(default_factory=dict)
    beams: dict[str, str] = field(default_factory=dict)
    rotors: tuple[str, ...] = ()

    def component(self, kind: str, label: str) -> str:
        """Component of an element, from its kind and its label, "KIND NAME"; the label for others."""
        words, _, name = label.rpartition(" ")
        base = name.partition(".")[0]
        if registry.find(kind).role == SIGNAL:
            actuator, link, _ = name.partition(LINK)
            return f"{ACTUATOR} {actuator}" if link else label
        if base in self.beams and base != name:
            return self.beams[base] or f"{words} {base}"
        if base in self.rotors:
            return f"{AIR} {base}"
        return label


def structures_of(system: System) -> Structures:
    """Beams and blades of a system; none without a model."""
    model = system.model
    if model is None:
        return Structures()
    names, table = list(system.layout.bodies), system.program["body"]
    beams = dict.fromkeys(model.beams, "")
    bodies = {name: base for name in names if (base := name.partition(".")[0]) in beams and base != name}
    for rotor, part in model.wind_rotors.items():
        if not (part.beams or part.bodies):
            continue
        group, hub = f"{BLADES} {rotor}", names.index(part.hub.partition(".")[0])
        beams |= dict.fromkeys(part.beams, group)
        carried = {hub}
        for b in range(hub + 1, len(names)):
            if int(table[b]["parent"]) in carried and not table[b]["state"]:
                carried.add(b)
                bodies[names[b]] = group
    return Structures(bodies, beams, tuple(model.wind_rotors))
