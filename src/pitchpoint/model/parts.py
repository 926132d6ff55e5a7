# SPDX-License-Identifier: Apache-2.0
"""The parts of a model while they are read, checked and settled."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from pitchpoint.model.components.bearing import Bearing
from pitchpoint.model.components.body import Body
from pitchpoint.model.components.coupling import Coupling
from pitchpoint.model.components.damping import Damping
from pitchpoint.model.components.gear import Gear
from pitchpoint.model.components.load import Load
from pitchpoint.model.components.mesh import Mesh
from pitchpoint.model.mechanism import Mechanism
from pitchpoint.model.scenario import Scenario

if TYPE_CHECKING:
    from pitchpoint.geometry.gear_pair import GearPair


@dataclass
class Parts:
    """The readable parts of a model; `names` holds every name of the file, readable or not."""

    gears: dict[str, Gear]
    bodies: dict[str, Body]
    meshes: dict[str, Mesh]
    bearings: dict[str, Bearing]
    couplings: dict[str, Coupling]
    loads: dict[str, Load]
    damping: Damping | None
    scenarios: dict[str, Scenario]
    sections: dict[str, dict[str, Any]] = field(default_factory=dict)  # all others, found as attributes
    names: dict[str, set[str]] = field(default_factory=dict)
    pairs: dict[str, GearPair] = field(default_factory=dict)
    misshapen: set[str] = field(default_factory=set)  # gears whose own shape is impossible
    placed: dict[str, tuple[str, str, str]] = field(default_factory=dict)
    """For bodies without a position: kind and name of the link that placed it, and the body it hangs on."""
    mechanism: Mechanism = field(default_factory=Mechanism)
    carriers: dict[str, str] = field(default_factory=dict)  # gear to body, for so many bodies as were seen
    seen: int = 0

    @classmethod
    def of(cls, groups: Mapping[str, Any], damping: Damping | None) -> Parts:
        """Parts from mappings of names to components, by group; missing groups are empty."""

        def group(name: str) -> dict[str, Any]:
            """Contents of one section; none if it is missing."""
            return dict(groups.get(name) or {})

        return cls(
            gears=group("gears"),
            bodies=group("bodies"),
            meshes=group("meshes"),
            bearings=group("bearings"),
            couplings=group("couplings"),
            loads=group("loads"),
            scenarios=group("scenarios"),
            damping=damping,
            sections={
                name: group(name)
                for name, found in groups.items()
                if isinstance(found, Mapping) and name not in cls.__dataclass_fields__
            },
        )

    def __getattr__(self, name: str) -> dict[str, Any]:
        """Section of this name; one that a file does not have is empty."""
        if name.startswith("__"):
            raise AttributeError(name)
        return self.__dict__.get("sections", {}).get(name, {})

    def known(self, group: str) -> set[str]:
        """All names of a group, those of unreadable parts included."""
        return self.names.get(group, set()) | set(getattr(self, group))

    def has(self, group: str, name: str) -> bool:
        """Whether a group has a name, be it that of an unreadable part."""
        return name in getattr(self, group) or name in self.names.get(group, ())

    def body_of(self, gear: str) -> str | None:
        """Name of the body that carries a gear, the first one if there are several."""
        if self.seen != len(self.bodies):  # bodies are added while a model is settled, gears stay on theirs
            self.seen, self.carriers = len(self.bodies), carriers_of(self.bodies)
        return self.carriers.get(gear)


def carriers_of(bodies: Mapping[str, Body]) -> dict[str, str]:
    """First body that carries a gear, by gear."""
    found: dict[str, str] = {}
    for name, body in bodies.items():
        for gear in (*body.gears, *body.bevel_gears):
            found.setdefault(gear, name)
    return found
