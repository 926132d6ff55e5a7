# SPDX-License-Identifier: Apache-2.0
"""Load sharing of the planets of a stage, from the mean forces of their meshes.

The mesh load factor K_gamma (ISO 6336:2019) is the largest load of the parallel meshes over their mean: 1 for
equal planets, N if one of N planets carries all. Planets without load, see `no_load`, have no shares.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from pitchpoint.core.load_sharing import FACTOR, factor_name, factor_row
from pitchpoint.system import planet_positions
from pitchpoint.system.no_load import least_forces
from pitchpoint.system.planet_positions import PositionLoads, loads_at_positions

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model

IDLE = 1e-3
"""Mean force over the largest of all meshes up to which one of several mates of a stage runs idle."""
WORDS = "mesh load factor of the planets, from mean mesh forces"


@dataclass(frozen=True)
class PlanetLoads:
    """Loads of the planets of one stage, from one group of parallel meshes.

    Parameters
    ----------
    planets, meshes
        Names of the planets and of their meshes.
    force
        Mean mesh force along the base tangent by planet [N].
    share
        Share of the sum of the forces by planet [-]; NaN without load.
    factor
        Mesh load factor K_gamma [-]; None without load.
    positions
        Extremes of the shares over the positions of the carrier; None if they are not known.
    """

    planets: tuple[str, ...]
    meshes: tuple[str, ...]
    force: tuple[float, ...]
    share: tuple[float, ...]
    factor: float | None
    positions: PositionLoads | None = None


def mesh_load_factor(forces: Sequence[float], least: float = 0.0) -> float | None:
    """Largest of parallel mesh forces over their mean; None without load.

    Parameters
    ----------
    forces
        Mean force of every mesh, of one sign or zero [N].
    least
        Mean of the forces up to which there is no load [N].

    Examples
    --------
    >>> mesh_load_factor([1200.0, 900.0, 900.0])
    1.2
    """
    total = abs(math.fsum(forces))
    if not total > least * len(forces) or not math.isfinite(total):
        return None
    return len(forces) * max(map(abs, forces)) / total


def load_groups(model: Model) -> dict[str, tuple[tuple[str, ...], tuple[str, ...]]]:
    """Planets and parallel meshes by name: STAGE, or STAGE.MATE where the groups of a stage differ.

    Planets of one gear between sun and ring have equal forces at both; the mates of others do not.
    """
    found = {}
    for name, stage in model.planetary_stages.items():
        groups = stage.groups
        alike = len(stage.wheels) == 1 and set(stage.wheels[0].mates) <= {"sun", "ring"}
        for group in groups[:1] if alike else groups:
            found[name if alike else f"{name}.{group.mate}"] = stage.names, group.names
    return found


def loads_of_planets(model: Model, mean: Callable[[str], float | None]) -> dict[str, PlanetLoads]:
    """Loads of the planets of all stages, by the names of `load_groups`.

    Parameters
    ----------
    model
        The model.
    mean
        Returns the mean of a channel; None if it is not known. Stages without known forces are omitted.
    """
    found: dict[str, PlanetLoads] = {}
    if not model.planetary_stages:
        return found
    every = {mesh: mean(f"mesh_force[{mesh}]") for mesh in model.every_mesh}
    largest = max((abs(f) for f in every.values() if f is not None and math.isfinite(f)), default=0.0)
    least = least_forces(model, largest)
    for name, (planets, meshes) in load_groups(model).items():
        forces = [every[mesh] for mesh in meshes]
        known = [force for force in forces if force is not None and math.isfinite(force)]
        if len(known) < len(meshes):
            continue
        limit = max(least[mesh] for mesh in meshes)
        if "." in name:  # members that run idle only have the rest of a vibration
            limit = max(limit, IDLE * largest)
        factor = mesh_load_factor(known, limit)
        total = math.nan if factor is None else math.fsum(known)
        share = tuple(force / total for force in known)
        found[name] = PlanetLoads(planets, meshes, tuple(known), share, factor)
    return found


def planet_loads(model: Model, result: xr.Dataset, settle_time: float = 0.0) -> dict[str, PlanetLoads]:
    """Loads of the planets of all stages in a result: static solution, slow roll or time response.

    Parameters
    ----------
    model
        The model of the result.
    result
        The result, with the mesh forces.
    settle_time
        Time after the first sample of a time response that is omitted from the means [s].
    """

    def mean(channel: str) -> float | None:
        """Mean of a channel over its samples; the last point of a roll repeats the first one."""
        if channel not in result:
            return None
        values = result[channel]
        if "time" in values.dims:
            values = values.sel(time=slice(float(values["time"][0]) + settle_time, None))
        elif "mesh_phase_position" in values.dims and values.size > 1:
            values = values.isel(mesh_phase_position=slice(None, -1))
        return float(values.mean()) if values.size else None

    return {
        name: replace(loads, positions=loads_at_positions(model, result, loads.meshes, settle_time))
        if loads.factor is not None
        else loads
        for name, loads in loads_of_planets(model, mean).items()
    }


def with_factors(model: Model, channels: Mapping[str, Mapping[str, Any]]) -> dict[str, Mapping[str, Any]]:
    """Statistics of channels with a row for the mesh load factor of every stage."""
    rows = {name: factor_row(value) for name, value in factors_of(model, channels).items()}
    return {**channels, **rows}


def factors_of(model: Model, channels: Mapping[str, Mapping[str, Any]]) -> dict[str, float]:
    """Mesh load factors from statistics of channels, by their names in tables; NaN without load."""
    found = loads_of_planets(model, lambda c: _mean_of(channels, c))
    return {
        factor_name(name): math.nan if loads.factor is None else loads.factor for name, loads in found.items()
    }


def factor_quantities(model: Model) -> list[tuple[str, str, str]]:
    """Names, unit and description of the mesh load factors of all stages."""
    return [(factor_name(name), "1", WORDS) for name in load_groups(model)]


def loads_in(model: Model, channels: Mapping[str, Mapping[str, Any]]) -> dict[str, dict[str, Any]]:
    """Loads of the planets from statistics of channels, as plain data for files and tables."""
    return as_data(loads_of_planets(model, lambda c: _mean_of(channels, c)))


def as_data(stages: Mapping[str, PlanetLoads]) -> dict[str, dict[str, Any]]:
    """Loads of the planets as plain data."""
    return {
        name: {
            "planets": list(loads.planets),
            "meshes": list(loads.meshes),
            "mean_force": list(loads.force),
            "share": list(loads.share),
            FACTOR: loads.factor,
            "positions": planet_positions.as_data(loads.positions),
        }
        for name, loads in stages.items()
    }


def _mean_of(channels: Mapping[str, Mapping[str, Any]], channel: str) -> float | None:
    row = channels.get(channel)
    return None if row is None else row["mean"]
