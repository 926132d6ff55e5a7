# SPDX-License-Identifier: Apache-2.0
"""Load shares of the planets at every position of their carrier, from mesh forces over time or over a roll.

Weight and bending moments load each planet once per turn of the carrier. The factor for the design is the
largest share of a planet at any position of the carrier times the number of planets; means over whole turns
hide it. A position is a sector of the turn: shares are means over the whole mesh periods in 1/12 of a turn,
at least one. This removes the mesh frequency, and reduces a variation once per turn by 1.1 %.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.load_sharing import FACTOR
from pitchpoint.system.planet_windows import turning_body

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model

FEWEST = 6
"""Samples per mesh period below which the mean over a period is not known."""
SECTORS = 12
"""Sectors of a turn of the carrier: a variation once per turn is reduced by sinc(1/12)."""
LOADED = 0.5
"""Load of all planets, over its largest value, from which a position counts."""

Array = NDArray[np.float64]


@dataclass(frozen=True)
class PositionLoads:
    """Extremes of the load shares over the positions of the carrier.

    Parameters
    ----------
    least_share, largest_share
        Smallest and largest share by planet [-].
    factor
        Largest mesh load factor K_gamma at any position [-].
    angle
        Angle of the carrier in the middle of this position, from its initial position, in [0, 2 pi) [rad].
    turns
        Turns of the carrier in the result [-]; less than one does not have all positions.
    """

    least_share: tuple[float, ...]
    largest_share: tuple[float, ...]
    factor: float
    angle: float
    turns: float


def shares_at_positions(
    phase: ArrayLike, forces: ArrayLike, periods: int = 1
) -> tuple[Array, NDArray[np.intp]]:
    """Share of every planet in the mean over the last mesh periods.

    Parameters
    ----------
    phase
        Phase of one of the meshes [mesh periods], shape (n,), with or without whole periods.
    forces
        Mesh force of every planet [N], shape (n, planets).
    periods
        Mesh periods of the mean.

    Returns
    -------
    tuple
        Shares [-], shape (m, planets), and indices of their last samples, shape (m,), without positions at
        which all planets together carry less than half of their largest load. m = 0 for fewer periods, or for
        less than 6 samples per period.

    Examples
    --------
    Two planets, of which the first carries 2/3 in the second period:

    >>> import numpy as np
    >>> phase = np.linspace(0.0, 2.0, 41)
    >>> forces = np.where(phase[:, None] < 1.0, [3.0, 3.0], [4.0, 2.0])
    >>> shares, index = shares_at_positions(phase, forces)
    >>> [round(float(x), 2) for x in shares[-1]], int(index[-1])
    ([0.67, 0.33], 40)
    """
    force = np.asarray(forces, dtype=np.float64)
    turned = np.unwrap(np.asarray(phase, dtype=np.float64), period=1.0)
    nothing = np.zeros((0, force.shape[1])), np.zeros(0, dtype=np.intp)
    if turned.size < 2 or not np.isfinite(turned).all() or not np.isfinite(force).all():
        return nothing
    if np.abs(np.diff(turned)).max() > 1.0 / FEWEST:
        return nothing
    way = np.maximum.accumulate(np.abs(turned - turned[0]))
    index = np.flatnonzero(way >= periods - 1e-9)
    parts = 0.5 * np.diff(way)[:, None] * (force[1:] + force[:-1])
    sums = np.vstack([np.zeros(force.shape[1]), np.cumsum(parts, axis=0)])
    before = np.column_stack([np.interp(way[index] - periods, way, column) for column in sums.T])
    mean = sums[index] - before
    total = mean.sum(axis=1)
    loaded = (np.abs(total) >= LOADED * np.abs(total).max(initial=0.0)) & (total != 0.0)
    return mean[loaded] / total[loaded, None], index[loaded]


def loads_at_positions(
    model: Model, result: xr.Dataset, meshes: Sequence[str], settle_time: float = 0.0
) -> PositionLoads | None:
    """Extremes of the load shares of a stage in a time response or slow roll.

    None if the carrier is at rest, if channels are not in the result, or if it is shorter than a position.

    Parameters
    ----------
    model, result
        The model and its result, over time or the periods of a roll, with all turns of angles.
    meshes
        Parallel meshes of the planets of a stage.
    settle_time
        Time after the first sample that is omitted [s].
    """
    carriers = (s.carrier for s in model.planetary_stages.values() for g in s.groups if meshes[0] in g.names)
    body = turning_body(model, next(carriers), "angle", {str(name) for name in result})
    names = [f"angle[{body}]", f"mesh_phase[{meshes[0]}]", *(f"mesh_force[{mesh}]" for mesh in meshes)]
    if any(name not in result or result[name].ndim != 1 for name in names):
        return None
    window = result[names]
    if "time" in window.dims:
        window = window.sel(time=slice(float(result["time"][0]) + settle_time, None))
    angle, phase = window[names[0]].values, window[names[1]].values
    if not angle.size or not np.isfinite(angle).all():
        return None
    turns = float(np.ptp(angle)) / math.tau
    rolled = float(np.abs(np.diff(np.unwrap(phase, period=1.0))).sum())
    if not turns > 0.0 or not math.isfinite(rolled):
        return None
    periods = max(1, int(rolled / turns / SECTORS))
    shares, index = shares_at_positions(
        phase, np.column_stack([window[n].values for n in names[2:]]), periods
    )
    if not len(shares):
        return None
    at, _ = np.unravel_index(int(np.argmax(shares)), shares.shape)
    middle = float(angle[index[at]]) - math.copysign(
        0.5 * periods * turns / rolled * math.tau, angle[-1] - angle[0]
    )
    return PositionLoads(
        least_share=tuple(shares.min(axis=0).tolist()),
        largest_share=tuple(shares.max(axis=0).tolist()),
        factor=float(shares.shape[1] * shares.max()),
        angle=middle % math.tau,
        turns=turns,
    )


def as_data(loads: PositionLoads | None) -> dict[str, Any] | None:
    """Extremes of the load shares as plain data."""
    if loads is None:
        return None
    return {
        "least_share": list(loads.least_share),
        "largest_share": list(loads.largest_share),
        FACTOR: loads.factor,
        "carrier_angle": loads.angle,
        "turns": loads.turns,
    }


def with_positions(
    model: Model, stages: Mapping[str, Mapping[str, Any]], result: xr.Dataset, settle_time: float = 0.0
) -> dict[str, dict[str, Any]]:
    """Loads of the planets as plain data (`planet_loads.as_data`), with the extremes over the positions.

    Parameters
    ----------
    stages
        Loads by stage.
    model, result, settle_time
        As in `loads_at_positions`.
    """
    return {
        name: {
            **stage,
            "positions": None
            if stage[FACTOR] is None
            else as_data(loads_at_positions(model, result, stage["meshes"], settle_time)),
        }
        for name, stage in stages.items()
    }
