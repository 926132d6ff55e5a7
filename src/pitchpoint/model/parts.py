# SPDX-License-Identifier: Apache-2.0
"""The parts of a model while it is read, checked and completed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from pitchpoint.model.components.bearing import Bearing
from pitchpoint.model.components.body import Body
from pitchpoint.model.components.coupling import Coupling
from pitchpoint.model.components.damping import Damping
from pitchpoint.model.components.gear import Gear
from pitchpoint.model.components.housing import Housing
from pitchpoint.model.components.load import Load
from pitchpoint.model.components.lubricant import Lubricant
from pitchpoint.model.components.mesh import Mesh
from pitchpoint.model.mechanism import Mechanism
from pitchpoint.model.scenario import Scenario
from pitchpoint.model.sections import SECTIONS, is_other

if TYPE_CHECKING:
    from pitchpoint.geometry.gear_pair import GearPair


@dataclass
class Parts:
    """The readable parts of a model; `names` contains all names of the file, readable or not."""

    gears: dict[str, Gear]
    bodies: dict[str, Body]
    meshes: dict[str, Mesh]
    bearings: dict[str, Bearing]
    couplings: dict[str, Coupling]
    loads: dict[str, Load]
    damping: Damping | None
    scenarios: dict[str, Scenario]
    housing: Housing | None = None
    lubricant: Lubricant | None = None
    load_case: str | None = None
    sections: dict[str, dict[str, Any]] = field(
        default_factory=dict
    )  # all other sections, available as attributes
    names: dict[str, set[str]] = field(default_factory=dict)
    pairs: dict[str, GearPair] = field(default_factory=dict)
    misshapen: set[str] = field(default_factory=set)  # gears with impossible geometry
    planet_names: dict[str, str] = field(default_factory=dict)
    """`planet_name` of every stage of the file, readable or not."""
    placed: dict[str, tuple[str, str, str]] = field(default_factory=dict)
    """For bodies without a given position: kind and name of the link that locates it, and the neighbouring
    body."""
    mechanism: Mechanism = field(default_factory=Mechanism)
    carriers: dict[str, str] = field(default_factory=dict)  # gear to body; valid for `seen` bodies
    seen: int = 0

    @classmethod
    def of(cls, groups: Mapping[str, Any]) -> Parts:
        """Create parts from the values of the keys of a model: sections, `damping`, `housing`, `lubricant`.

        Missing sections are empty.
        """

        def group(name: str) -> dict[str, Any]:
            """Contents of one section; empty if missing."""
            return dict(groups.get(name) or {})

        return cls(
            gears=group("gears"),
            bodies=group("bodies"),
            meshes=group("meshes"),
            bearings=group("bearings"),
            couplings=group("couplings"),
            loads=group("loads"),
            scenarios=group("scenarios"),
            damping=groups.get("damping"),
            housing=groups.get("housing"),
            lubricant=groups.get("lubricant"),
            load_case=groups.get("load_case"),
            sections={
                name: group(name)
                for name, found in groups.items()
                if (name in SECTIONS or is_other(name)) and name not in cls.__dataclass_fields__
            },
        )

    def __getattr__(self, name: str) -> dict[str, Any]:
        """Section by name; empty if the file does not have it."""
        if name.startswith("__"):
            raise AttributeError(name)
        return self.__dict__.get("sections", {}).get(name, {})

    def section(self, name: str) -> dict[str, Any]:
        """Section by name, for adding components to it."""
        own = self.__dict__.get(name)
        return own if own is not None else self.sections.setdefault(name, {})

    @property
    def others(self) -> dict[str, dict[str, Any]]:
        """Sections of other packages."""
        return {name: part for name, part in self.sections.items() if name not in SECTIONS}

    def known(self, group: str) -> set[str]:
        """All names of a section, including those of unreadable parts."""
        return self.names.get(group, set()) | set(getattr(self, group))

    def has(self, group: str, name: str) -> bool:
        """Whether a section contains a name, possibly of an unreadable part."""
        return name in getattr(self, group) or name in self.names.get(group, ())

    def body_of(self, gear: str) -> str | None:
        """Name of the body of a gear; the first one if there are several."""
        if self.seen != len(self.bodies):  # bodies are added later, gears stay on their bodies
            self.seen, self.carriers = len(self.bodies), carriers_of(self.bodies)
        return self.carriers.get(gear)


def carriers_of(bodies: Mapping[str, Body]) -> dict[str, str]:
    """Body of every gear; the first one if there are several."""
    found: dict[str, str] = {}
    for name, body in bodies.items():
        for gear in (*body.gears, *body.bevel_gears):
            found.setdefault(gear, name)
    return found
