# SPDX-License-Identifier: Apache-2.0
"""Results as `xarray.Dataset`: fixed dimensions, never squeezed, units in the attributes.

xarray is imported only when a result is created.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.nomenclature import symbol
from pitchpoint.core.provenance import content_hash, provenance
from pitchpoint.core.status import OK
from pitchpoint.model.write import model_text
from pitchpoint.system.system import System

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.solvers.equilibrium.solve import Equilibrium


def attributes(
    system: System, solver: str, status: int = OK, wall_s: float = 0.0, **options: Any
) -> dict[str, Any]:
    """Attributes of a result: provenance, model text and status."""
    model = system.model
    title, text = ("", "") if model is None else (model.title, model_text(model))
    found = provenance(
        model_hash=content_hash(model), solver=solver, options=options, status=status, wall_s=wall_s
    )
    return {"title": title, "model_text": text, **found}


def channel_attributes(channel: Any) -> dict[str, str]:
    """Attributes of a variable: unit and long name of the channel, symbol of the nomenclature."""
    return {"units": channel.unit, "long_name": channel.long_name, "symbol": symbol(channel.name)}


def channel_dataset(
    system: System,
    dimension: str,
    points: NDArray[np.float64],
    rows: NDArray[np.float64],
    attrs: dict[str, Any],
    channels: Sequence[int] | None = None,
) -> xr.Dataset:
    """Channels over one dimension.

    Parameters
    ----------
    system
        Source of channel names and units.
    dimension
        Name of the dimension, `time` or `mesh_phase_position`.
    points
        Its values, shape (n,).
    rows
        Channel values, shape (n, number of channels).
    attrs
        Attributes, see `attributes`.
    channels
        Indices of the channels; default all.
    """
    import xarray as xr

    every = system.layout.channels
    own = every if channels is None else [every[k] for k in channels]
    data = {c.name: ((dimension,), rows[:, k], channel_attributes(c)) for k, c in enumerate(own)}
    return xr.Dataset(data, coords={dimension: points}, attrs=attrs)


def point_dataset(system: System, found: Equilibrium) -> xr.Dataset:
    """Dataset of an equilibrium: scalar channels, coordinates, holding torques."""
    import xarray as xr

    row = found.observe(system)
    data: dict[str, Any] = {
        c.name: ((), row[k], channel_attributes(c)) for k, c in enumerate(system.layout.channels)
    }
    names = list(system.layout.coordinates)
    data["position"] = (("coordinate",), found.state.q, {"units": "SI", "long_name": "coordinate"})
    data["holding_torque"] = (
        ("held",),
        found.reaction,
        {"units": "N m", "long_name": "torque that holds the spin angle; zero if the loads balance"},
    )
    coords = {"coordinate": names, "held": [names[k] for k in found.held]}
    return xr.Dataset(data, coords=coords, attrs=attributes(system, "equilibrium"))
