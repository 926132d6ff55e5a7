# SPDX-License-Identifier: Apache-2.0
"""Blade and air of a rotor, from files of AeroDyn or windIO or from the lists of the model."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.geometry.rotor.blade import Rotor
from pitchpoint.geometry.rotor.flow import TOWER_SECTORS, RotorFlow
from pitchpoint.model.blade_stations import blade_of
from pitchpoint.model.files import at_key, read_once
from pitchpoint.model.openfast.aerodyn import read_aerodyn
from pitchpoint.model.windio.rotor import read_windio_blades

if TYPE_CHECKING:
    from pitchpoint.model.components.wind_rotor import WindRotor

_aerodyn, _ontology = read_once(8)(read_aerodyn), read_once(8)(read_windio_blades)


@dataclass(frozen=True)
class RotorInput:
    """Geometry of a rotor at zero tilt, as the bodies have the tilt, the air around it, and notes on what its
    file contains that is not used."""

    rotor: Rotor
    flow: RotorFlow
    notes: tuple[str, ...] = ()


def rotor_input(part: WindRotor) -> RotorInput:
    """Geometry and air of a rotor.

    Parameters
    ----------
    part
        The rotor.

    Raises
    ------
    ModelError
        With every problem of its files or lists, at the key of the rotor.
    """
    if part.windio is not None:
        found = _windio(part)
    elif part.blade is not None:
        assert part.hub_radius is not None  # checked before
        try:
            blade = blade_of(part.blade, part.hub_radius)
        except ModelError as error:
            raise ModelError([p.changed(where=f"blade.{p.where}") for p in error.problems]) from None
        found = RotorInput(_rotor(part, Rotor(blade=blade, hub_radius=part.hub_radius)), RotorFlow())
    else:
        assert part.aerodyn is not None and part.hub_radius is not None
        try:
            given = _aerodyn(part.aerodyn, part.further_files)
        except ModelError as error:
            raise at_key(error, "aerodyn") from None
        found = RotorInput(_rotor(part, Rotor(blade=given.blade, hub_radius=part.hub_radius)), given.flow)
    return found if part.density is None else replace(found, flow=replace(found.flow, density=part.density))


def _rotor(part: WindRotor, rotor: Rotor) -> Rotor:
    """Rotor with the values of the model."""
    hub_radius = rotor.hub_radius if part.hub_radius is None else part.hub_radius
    precone = rotor.precone if part.precone is None else part.precone
    try:
        return replace(
            rotor, blades=part.blades, hub_radius=hub_radius, precone=precone, tilt=0.0, overhang=0.0
        )
    except ModelError as error:
        raise ModelError([p.changed(where=p.where.rpartition(".")[2]) for p in error.problems]) from None


def _windio(part: WindRotor) -> RotorInput:
    assert part.windio is not None
    try:
        given = _ontology(part.windio)
    except ModelError as error:
        raise at_key(error, "windio") from None
    if given.rotor.blades != part.blades:
        limit = f"{given.rotor.blades} as in the file"
        remedy = "correct one of them"
        raise ModelError([Message("blades", "is the number of blades", str(part.blades), limit, remedy)])
    flow = RotorFlow()
    if part.tower_flow:
        if given.tower is None:
            text = "has no tower in the windIO file"
            raise ModelError([Message("tower_flow", text, remedy="give tower_flow: false")])
        flow = RotorFlow(tower=given.tower, sectors=TOWER_SECTORS)
    return RotorInput(_rotor(part, given.rotor), flow, given.notes)
