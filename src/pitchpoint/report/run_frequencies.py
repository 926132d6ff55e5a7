# SPDX-License-Identifier: Apache-2.0
"""Mean mesh frequencies of a run, from the angles of its bodies."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz.run_record import settled_part

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model


def mean_mesh_frequencies(model: Model, result: xr.Dataset, settle_time: float = 0.0) -> dict[str, float]:
    """Mean mesh frequencies over the window of the statistics [Hz], in the order of the model.

    Parameters
    ----------
    model
        Model of the run.
    result
        Time response; meshes of bodies without an angle in it are omitted, as are meshes at rest.
    settle_time
        Start of the window after the first sample [s].
    """
    from pitchpoint.report.frequencies import frequencies_of

    time = np.asarray(result["time"].values, dtype=np.float64)
    if time.size < 2:
        return {}
    inside = np.flatnonzero(settled_part(time, settle_time))[[0, -1]]
    spins, unknown = {}, set()
    for body in model.bodies:
        seat = model.mechanism.seats[body]
        if f"angle[{body}]" in result:
            first, last = result[f"angle[{body}]"].values[inside]
            spins[body] = float(last - first) / float(time[inside[1]] - time[inside[0]])
        else:
            spins[body] = 0.0
            unknown |= {body} if "spin" in seat.coordinates else set()
    return {
        name: float(row["frequency"])
        for name, row in frequencies_of(model, spins)["meshes"].items()
        if row["frequency"] > 0.0
        and np.isfinite(row["frequency"])
        and unknown.isdisjoint(str(model.body_of(gear)) for gear in row["gears"])
    }
