# SPDX-License-Identifier: Apache-2.0
"""Blade and air of a rotor, from files of AeroDyn or windIO or from the lists of the model."""

from __future__ import annotations

import functools
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.geometry.rotor.blade import Rotor
from pitchpoint.geometry.rotor.flow import RotorFlow
from pitchpoint.model.blade_stations import blade_of
from pitchpoint.model.openfast.aerodyn import AeroDynInput, read_aerodyn
from pitchpoint.model.windio.rotor import WindIORotor, read_windio_rotor
from pitchpoint.system.rules.structure_files import change_time

if TYPE_CHECKING:
    from pitchpoint.model.components.wind_rotor import WindRotor

TOWER_SECTORS = 72


@dataclass(frozen=True)
class RotorInput:
    """Geometry of a rotor at zero tilt, as the bodies have the tilt, and the air around it."""

    rotor: Rotor
    flow: RotorFlow


def rotor_input(part: WindRotor, at: str, file: str | None) -> RotorInput:
    """Geometry and air of a rotor.

    Parameters
    ----------
    part
        The rotor.
    at
        Its path, for messages.
    file
        Model file.

    Raises
    ------
    ModelError
        With every problem of the files.
    """
    try:
        if part.windio is not None:
            found = _windio(part)
        elif part.blade is not None:
            assert part.hub_radius is not None  # checked with the model
            blade = blade_of(part.blade, part.hub_radius)
            found = RotorInput(_rotor(part, Rotor(blade=blade, hub_radius=part.hub_radius)), RotorFlow())
        else:
            assert part.aerodyn is not None and part.hub_radius is not None
            given = _aerodyn(part.aerodyn, change_time(part.aerodyn))
            found = RotorInput(_rotor(part, Rotor(blade=given.blade, hub_radius=part.hub_radius)), given.flow)
    except ModelError as error:
        key = next(name for name in ("aerodyn", "windio", "blade") if getattr(part, name) is not None)
        problems = [p.changed(where=f"{at}.{key}: {p.where}", file=None) for p in error.problems]
        raise ModelError(problems, file) from None
    return found if part.density is None else replace(found, flow=replace(found.flow, density=part.density))


def _rotor(part: WindRotor, rotor: Rotor) -> Rotor:
    """Rotor with the values of the model."""
    own = {"hub_radius": part.hub_radius, "precone": part.precone}
    given = {name: value for name, value in own.items() if value is not None}
    return replace(rotor, blades=part.blades, tilt=0.0, overhang=0.0, **given)


def _windio(part: WindRotor) -> RotorInput:
    assert part.windio is not None
    given = _ontology(part.windio, change_time(part.windio))
    if given.rotor.blades != part.blades:
        limit = f"{given.rotor.blades} as in the file"
        raise ModelError([Message("blades", "is the number of blades", str(part.blades), limit)])
    flow = RotorFlow()
    if part.tower_flow:
        if given.tower is None:
            raise ModelError([Message("components.tower", "is missing", remedy="give tower_flow: false")])
        flow = RotorFlow(tower=given.tower, sectors=TOWER_SECTORS)
    return RotorInput(_rotor(part, given.rotor), flow)


@functools.lru_cache(maxsize=8)
def _aerodyn(path: str, stamp: int) -> AeroDynInput:
    return read_aerodyn(path)


@functools.lru_cache(maxsize=8)
def _ontology(path: str, stamp: int) -> WindIORotor:
    return read_windio_rotor(path)
