# SPDX-License-Identifier: Apache-2.0
"""Numbers of planetary stages: places of the planets, phases of their meshes, room between them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.model.checks.planetary_stages import planet_gaps
from pitchpoint.model.components.planetary_stage import PinError
from pitchpoint.model.planetary_stages import nominal_distance
from pitchpoint.system.planet_loads import loads_of_planets
from pitchpoint.viz.quantities import stored_statistics

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model

ROUNDING = 1e-9
"""Base pitches by which a phase may miss a whole period."""


def stages_of_model(model: Model) -> dict[str, dict[str, Any]]:
    """Numbers of all planetary stages.

    Returns
    -------
    dict
        By stage: gears and carrier, center_distance [m] without pin errors, planet_gap [m]: least distance
        between the tips of neighbouring planets (None for one planet), and by planet its angle [rad], pin
        errors [m] and the phases of its meshes after those of the first planet [base pitches], in [0, 1).
    """
    found = {}
    for name, stage in model.planetary_stages.items():
        gaps = planet_gaps(model, stage)
        phases = {side: _phases(model, meshes) for side, meshes in _sides(model, name).items()}
        planets = {}
        for k, planet in enumerate(stage.names):
            error = stage.pin_errors.get(planet, PinError())
            planets[planet] = {
                "angle": stage.places[k],
                "tangential_pin_error": error.tangential,
                "radial_pin_error": error.radial,
                **{f"phase_{side}": values[k] for side, values in phases.items()},
            }
        found[name] = {
            "sun": stage.sun,
            "ring": stage.ring,
            "carrier": stage.carrier,
            "center_distance": nominal_distance(model, stage),
            "planet_gap": min((gap for gap, _ in gaps), default=None),
            "planets": planets,
        }
    return found


def load_sharing(model: Model, run: xr.Dataset, settle_time: float = 0.0) -> dict[str, float]:
    """Mesh load factor of every loaded planetary stage in a run.

    Parameters
    ----------
    model
        The model of the run.
    run
        Time response; the means are those of all steps, if stored.
    settle_time
        Start of the window of the statistics after the first sample [s].
    """

    def mean(name: str) -> float | None:
        """Mean of a channel over the window."""
        if name not in run:
            return None
        stored = stored_statistics(run[name].attrs)
        if stored is not None:
            return stored["mean"]
        inside = run[name].sel(time=slice(float(run["time"][0]) + settle_time, None))
        return float(inside.mean()) if inside.size else None

    found = loads_of_planets(model, mean)
    return {name: loads.factor for name, loads in found.items() if loads.factor is not None}


def _sides(model: Model, name: str) -> dict[str, tuple[str, ...]]:
    stage = model.planetary_stages[name]
    sides = {"sun": stage.sun_meshes(), "ring": stage.ring_meshes()}
    return {side: meshes for side, meshes in sides.items() if meshes}


def _phases(model: Model, meshes: tuple[str, ...]) -> list[float]:
    """Phases of parallel meshes after the first one [base pitches]."""
    travel = [model.phasing.travel[mesh] for mesh in meshes]
    p_bt = abs(model.pairs[meshes[0]].p_et)
    return [round((t - travel[0]) / p_bt / ROUNDING) * ROUNDING % 1.0 for t in travel]
