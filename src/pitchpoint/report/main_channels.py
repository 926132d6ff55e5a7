# SPDX-License-Identifier: Apache-2.0
"""Main channels of a run, chosen by meaning: speeds of input and output, meshes, bearings, torques, signals.

Terminal, notebook and report show them first and in this order; the file contains all channels.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from pitchpoint.model.frames import GROUND

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

RESULTANTS = ("radial", "axial")
"""Components of a bearing force that represent all others."""
MESH = ("mesh_force", "transmission_error", "contact_state")
ROTOR = ("hub_wind_speed", "aerodynamic_power", "rotor_thrust", "rotor_torque")
CONNECTIONS = ("torque", "holding_torque", "coupling_force", "tension", "contact_force", "slip_speed")
OTHERS = ("deflection", "mesh_stiffness", "speed", "displacement", "friction_power")
"""Quantities drawn if a machine has no main channels but speeds."""
FEW = 12
"""Number of channels up to which all are main channels."""


@dataclass(frozen=True)
class ChannelGroup:
    """Channels with one meaning.

    Attributes
    ----------
    title
        Title in words, "Speeds of input and output".
    names
        Names of the channels, the most important first.
    """

    title: str
    names: tuple[str, ...]


def main_channels(model: Model, names: Iterable[str], scenario: str = "") -> list[str]:
    """Names of the main channels, the most important first; all of a machine with few.

    Parameters
    ----------
    model
        Model of the run.
    names
        Names of the available channels.
    scenario
        Scenario of the run, whose driven bodies are the inputs.

    Returns
    -------
    list of str
        Main channels; all channels if there are few, or if none is a main channel.
    """
    given = list(names)
    found = [name for group in channel_groups(model, given, scenario) for name in group.names]
    if not found or len(given) <= FEW:
        return [*found, *(name for name in given if name not in set(found))]
    return found


def channel_groups(model: Model, names: Iterable[str], scenario: str = "") -> list[ChannelGroup]:
    """Main channels by meaning; groups without channels are omitted.

    Parameters
    ----------
    model, names, scenario
        As in `main_channels`.
    """
    given = list(dict.fromkeys(names))
    available = set(given)
    ends = end_bodies(model, scenario)
    titles = {
        "Speeds of input and output": [f"speed[{body}]" for body in ends],
        "Rotor in the wind": [f"{quantity}[{rotor}]" for rotor in model.wind_rotors for quantity in ROTOR],
        "Moments at the roots": _root_moments(model),
        "Meshes": [f"{quantity}[{mesh}]" for mesh in model.every_mesh for quantity in MESH],
        "Bearings": _bearing_channels(given),
        "Torques in the middle of shafts": [_middle_torque(model, shaft) for shaft in model.shafts],
        "Connections": [name for kind in CONNECTIONS for name in given if _kind(name) == kind],
        "Signals": [name for name in given if _kind(name) == "signal" and "." not in name],
    }
    found = []
    for title, wanted in titles.items():
        kept = tuple(name for name in wanted if name in available)
        if kept:
            found.append(ChannelGroup(title, kept))
    return found


def _root_moments(model: Model) -> list[str]:
    """Bending moments at the first ends of all beams of a wind turbine: tower base, blade roots."""
    beams = model.beams if model.wind_rotors else {}
    return [f"beam_force[{beam}.1.i.{moment}]" for moment in ("my", "mx") for beam in beams]


def drawn_groups(model: Model, names: Iterable[str], scenario: str = "") -> list[tuple[str, tuple[str, ...]]]:
    """Titles and channels of the curves of a report; the planets of a set have pictures of their own.

    Parameters
    ----------
    model, names, scenario
        As in `main_channels`. Resultants of bearings are drawn even if the result contains only components.
    """
    given = list(dict.fromkeys(names))
    bearings = dict.fromkeys(_bearing(name) for name in given if _kind(name) == "bearing_force")
    given += [f"bearing_force[{b}.{word}]" for b in bearings for word in RESULTANTS]
    found: list[tuple[str, tuple[str, ...]]] = []
    for group in channel_groups(model, given, scenario):
        sets = _planet_sets(model) if group.title == "Meshes" else {}
        in_sets = {mesh for meshes in sets.values() for mesh in meshes}
        single = tuple(n for n in group.names if n.partition("[")[2].rstrip("]") not in in_sets)
        found += [(group.title, single)] if single else []
        for title, meshes in sets.items():
            own = tuple(n for n in group.names if n.partition("[")[2].rstrip("]") in meshes)
            found += [(title, own)] if own else []
    seen = {name for _, own in found for name in own}
    rest = tuple(n for n in given if n not in seen and _kind(n) in OTHERS)
    # machines without meshes, bearings and connections move all the same
    return [*found, ("Motion", rest)] if rest and len({_kind(n) for n in seen} - {"speed"}) == 0 else found


def _planet_sets(model: Model) -> dict[str, list[str]]:
    """Meshes of a common gear with several equal gears on one carrier, by a title."""
    sets: dict[tuple[str, str | None, int], list[str]] = {}
    for name, mesh in model.every_mesh.items():
        for gear, planet in (mesh.gears, mesh.gears[::-1]):
            body = model.body_of(planet)
            seat = model.mechanism.seats.get(str(body))
            if seat is not None and seat.parent != GROUND:
                sets.setdefault((gear, seat.parent, model.toothed[planet].number_of_teeth), []).append(name)
    return {f"Meshes of {key[0]} with planets": names for key, names in sets.items() if len(names) > 1}


def end_bodies(model: Model, scenario: str = "") -> list[str]:
    """Bodies where power enters or leaves: driven bodies, then loaded bodies, in the order of the file.

    Parameters
    ----------
    model
        The model.
    scenario
        Scenario whose drives and given speeds come first; default: those of all scenarios.

    Returns
    -------
    list of str
        Names without repetition; all bodies with gears if nothing is driven or loaded.
    """
    chosen = [model.scenarios[scenario]] if scenario in model.scenarios else list(model.scenarios.values())
    driven = [body for one in chosen for body in (*one.drive, *one.speed)]
    swept = [one.sweep.body for one in chosen if one.sweep is not None]
    loaded = [load.body for load in model.loads.values() if load.torque is not None]
    found = [body for body in dict.fromkeys((*driven, *swept, *loaded)) if body in model.bodies]
    return found or [name for name, body in model.bodies.items() if body.gears or body.bevel_gears]


def _middle_torque(model: Model, shaft: str) -> str:
    """Torque in the middle piece of a shaft; the first and last ones often only carry bearings."""
    pieces = len(model.stations[shaft]) - 1
    return f"beam_force[{shaft}.{pieces // 2 + 1}.i.mz]"


def _kind(name: str) -> str:
    """Quantity of a channel: `speed` of `speed[input]`."""
    return name.partition("[")[0]


def _bearing_channels(names: Sequence[str]) -> list[str]:
    """Resultants of the bearings; components of a bearing without resultants."""
    own = [name for name in names if _kind(name) == "bearing_force"]
    complete = {_bearing(name) for name in own if name.endswith(tuple(f".{r}]" for r in RESULTANTS))}
    return [n for n in own if _bearing(n) not in complete or n.endswith(tuple(f".{r}]" for r in RESULTANTS))]


def _bearing(name: str) -> str:
    """Name of the bearing of a channel: `left` of `bearing_force[left.fx]`."""
    return name.partition("[")[2].rstrip("]").rpartition(".")[0]
