# SPDX-License-Identifier: Apache-2.0
"""Stations of shafts and beams with their positions and attached components, for `pitchpoint check`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def shaft_stations(model: Model) -> dict[str, dict[str, Any]]:
    """Stations of the shafts with their positions [m] and attached components."""
    from pitchpoint.model.shafts import nearest_station, seats_on_shafts, station_names

    found = {}
    for shaft, seats in seats_on_shafts(model).items():
        places = model.stations[shaft]
        sits: list[list[str]] = [[] for _ in places]
        for at, place in seats:
            what = sits[nearest_station(places, place)]
            word = str(at[3] if at[0] == "shafts" else at[1])
            what.extend([word] if word not in what else [])
        names = station_names(shaft, len(places))
        found[shaft] = {n: {"place": p, "there": s} for n, p, s in zip(names, places, sits, strict=True)}
    return found


def beam_stations(model: Model) -> dict[str, dict[str, Any]]:
    """Stations of the beams: positions from the first end and in the world [m], attached components."""
    from pitchpoint.model.checks.references import ends_of
    from pitchpoint.model.frames import beam_length, place_of

    sits: dict[str, list[str]] = {}
    for _, name, _, given in ends_of(model):
        for end in (given,) if isinstance(given, str) else given:
            sits.setdefault(end, []).append(name)
    for name, load in model.loads.items():
        sits.setdefault(f"{load.body}.{load.marker}", []).append(name)
    found: dict[str, dict[str, Any]] = {}
    for beam, part in model.beams.items():
        length = beam_length(model, part) or 0.0
        found[beam] = {}
        for number, share in part.stations.items():
            station = f"{beam}.{number}"
            world = place_of(model, station)
            found[beam][station] = {
                "place": share * length,
                "world": None if world is None else world.tolist(),
                "there": sits.get(station, []),
            }
    return found
