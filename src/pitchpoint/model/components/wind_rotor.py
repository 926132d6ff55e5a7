# SPDX-License-Identifier: Apache-2.0
"""Rotor of a wind turbine with the loads of the air on its blades."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.blade import BladeStations
from pitchpoint.model.keys import (
    boolean,
    choice,
    component,
    end,
    integer,
    key,
    positive,
    quantities,
    quantity,
    text,
)

WAYS = ("steady", "dynamic")


@dataclass(frozen=True, kw_only=True)
class WindRotor(Component):
    """Identical blades in the wind, by blade-element momentum theory, on rigid bodies or elastic beams."""

    hub: str = end(
        "centre of the rotor, BODY or BODY.MARKER: z is its axis, downwind, about which it rotates in the "
        "positive direction; blade 1 is in the direction of x"
    )
    aerodyn: str | None = key(
        "file",
        "input file of AeroDyn v15: blade, airfoils, tower and options of the theory",
        None,
        one_of="blade",
    )
    windio: str | None = key(
        "file",
        "turbine in the ontology windIO, version 1 or 2: blade, airfoils, hub radius and precone",
        None,
        one_of="blade",
        later=True,
    )
    blade: BladeStations | None = component(
        BladeStations, "stations of the blade as lists", None, one_of="blade", later=True
    )
    blades: int = integer("number of blades", 3, minimum=1, maximum=100)
    hub_radius: float | None = positive(
        "length",
        "distance of the blade roots from the rotor axis, along the blade; required without windio",
        None,
        display="that of the windIO file",
        sample="1.5 m",
    )
    precone: float | None = quantity(
        "angle",
        "inclination of the blades from the rotor plane, upwind",
        None,
        minimum=-0.5,
        maximum=0.5,
        display="0, or that of the windIO file",
    )
    pitch: float = quantity(
        "angle", "pitch of the blades with the bodies in their initial position, leading edge upwind", 0.0
    )
    bodies: tuple[str, ...] = key(
        "names",
        "body of each blade, such as one on a pitch bearing",
        (),
        length=(0, 100),
        names="bodies",
        display="that of the hub",
    )
    beams: tuple[str, ...] = key(
        "names",
        "elastic beam of each blade, from the root to the tip, instead of bodies",
        (),
        length=(0, 100),
        names="beams",
    )
    inflow: str = choice(
        WAYS,
        "induced velocity; steady: from the balance of momentum at every instant; dynamic: follows it with "
        "two time constants (Oye)",
        "steady",
    )
    stall: str = choice(
        WAYS,
        "lift; steady: of the polar; dynamic: the point of separation follows with a time constant (Oye); "
        "requires inflow: dynamic",
        "steady",
    )
    wind: str | None = text(
        "wind at the rotor, unless a scenario names another one", None, display="the only one", names="winds"
    )
    density: float | None = positive(
        "density",
        "density of the air",
        None,
        display="that of the AeroDyn file, otherwise 1.225 kg/m^3",
        sample="1.225 kg/m^3",
    )
    tower_position: tuple[float, float] = quantities(
        "length",
        "axis of the tower in the world [x, y], if the AeroDyn file has the flow around it, or with "
        "tower_flow",
        (0.0, 0.0),
        length=(2, 2),
    )
    step: float = quantity(
        "time",
        "time over which loads are extrapolated with their derivatives before the balance of momentum is "
        "solved again; 0: it is solved at every evaluation; methods of fixed steps only",
        0.0,
        minimum=0.0,
        maximum=0.1,
        later=True,
    )
    tower_flow: bool = boolean("potential flow around the tower of the windIO file", False, later=True)

    @property
    def further_files(self) -> tuple[str, ...]:
        """Files that the file of AeroDyn names."""
        if self.aerodyn is None:
            return ()
        from pitchpoint.model.openfast.aerodyn import aerodyn_files

        return aerodyn_files(self.aerodyn)
