# SPDX-License-Identifier: Apache-2.0
"""Which teeth of a cylindrical mesh are in contact in a result, numbered as in the model.

Pairs of a mesh are counted as by its kernels: pair 0 is that of the assembly, the next one of a flank has the
next number. `pair_force[MESH.k]` is that of the pairs N with N mod n_pair = k.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.kernel import plain
from pitchpoint.elements.mesh.tooth_pairs import pair_teeth
from pitchpoint.model.carried_trains import line_carrier
from pitchpoint.model.frames import GROUND
from pitchpoint.model.mechanism import base_of, spinner_of
from pitchpoint.system.rules.gear_mesh import assembled_teeth

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.analysis.tooth_pulses import Pulses
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]


def pair_places(model: Model, data: xr.Dataset, mesh: str) -> tuple[Array, Array]:
    """Number of the tooth pair in the middle of its path of contact, of front and back flanks.

    Parameters
    ----------
    model, data
        The model and a result with the channels `angle`.
    mesh
        Name of a cylindrical mesh.

    Returns
    -------
    front, back : ndarray, shape of the time
        Pair N is in the middle of the path where the value is N.

    Raises
    ------
    PitchpointError
        If the result lacks the rotation of a gear.
    """
    row = assembled_teeth(model, mesh)
    now = row["now"]
    bodies = [str(model.body_of(g)) for g in model.meshes[mesh].gears]
    one, two = (_rotation(model, data, b, o) for b, o in (bodies, bodies[::-1]))
    travel = 0.5 * (row["z1"] * one - row["z2"] * two) / math.tau
    skew = 0.5 * row["tan_b"] * (now["z_lo"] + now["z_hi"]) / row["p_bt"]
    front = now["start"][0] + row["xi_0"] / row["p_bt"] + travel - 0.5 * now["eps"] + skew
    back = now["start"][1] + row["xi_b"] / row["p_bt"] - travel - 0.5 * now["eps"] - skew
    return front, back


def tooth_numbers(model: Model, mesh: str, pulses: Pulses, gear: int) -> NDArray[np.int64]:
    """Teeth of gear 1 (`gear` 0) or gear 2 (1) in contact in pulses with numbers of pairs, from 0.

    Counter-clockwise seen from +z, from tooth 0 of the model (docs/conventions.md).
    """
    row = assembled_teeth(model, mesh)
    found = np.zeros(pulses.tooth.size, np.int64)
    for side in (1, -1):
        row["now"]["flank"], row["now"]["tooth"] = side, 0
        first, following = (int(plain(pair_teeth)(row, q)[gear]) for q in (0, -1))
        own = np.sign(pulses.force) == side
        found[own] = first + (following - first) * pulses.tooth[own]
    return found % model.gears[model.meshes[mesh].gears[gear]].number_of_teeth


def _rotation(model: Model, data: xr.Dataset, body: str, other: str) -> Array:
    """Rotation of a gear body since assembly relative to the line of centres with another one [rad]."""
    carrier = line_carrier(model, body, other)  # type: ignore[arg-type]
    angle = _angle(model, data, body)
    if base_of(model, model.mechanism, body) != carrier:
        angle = angle - _angle(model, data, carrier)
    return angle


def _angle(model: Model, data: xr.Dataset, body: str) -> Array:
    """Spin of a body; zero for one that cannot rotate."""
    owner = spinner_of(model, model.mechanism, body)
    name = f"angle[{owner or body}]"
    if name in data:
        return np.asarray(data[name], float)
    seat = model.mechanism.seats.get(body)
    if owner is None and (body == GROUND or seat is None or seat.kind == "fixed"):
        return np.zeros(data.sizes["time"])
    raise PitchpointError(f"the result lacks the channel {name}")
