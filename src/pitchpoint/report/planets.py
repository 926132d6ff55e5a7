# SPDX-License-Identifier: Apache-2.0
"""Numbers of planetary stages: places of the planets, phases of their meshes, room between them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.model.checks.planetary_stages import planet_gaps
from pitchpoint.model.components.planetary_stage import PinError
from pitchpoint.model.planetary_stages import nominal_distance
from pitchpoint.system.planet_loads import as_data, loads_in, planet_loads

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model

ROUNDING = 1e-9
"""Base pitches by which a phase may miss a whole period."""


def load_sharing(model: Model, data: xr.Dataset, settle_time: float = 0.0) -> dict[str, dict[str, Any]]:
    """Loads of the planets in a result, by the statistics of the run if they are stored.

    Parameters
    ----------
    model, data
        The model and its result: slow roll or time response.
    settle_time
        Start of the means of a time response without stored statistics [s].
    """
    from pitchpoint.viz.quantities import stored_statistics

    if not model.planetary_stages:
        return {}
    stored = {str(n): s for n, v in data.data_vars.items() if (s := stored_statistics(v.attrs)) is not None}
    return loads_in(model, stored) or as_data(model, planet_loads(model, data, settle_time))


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


def _sides(model: Model, name: str) -> dict[str, tuple[str, ...]]:
    stage = model.planetary_stages[name]
    sides = {"sun": stage.sun_meshes(), "ring": stage.ring_meshes()}
    return {side: meshes for side, meshes in sides.items() if meshes}


def _phases(model: Model, meshes: tuple[str, ...]) -> list[float]:
    """Phases of parallel meshes after the first one [base pitches]."""
    travel = [model.phasing.travel[mesh] for mesh in meshes]
    p_bt = abs(model.pairs[meshes[0]].p_et)
    return [round((t - travel[0]) / p_bt / ROUNDING) * ROUNDING % 1.0 for t in travel]
