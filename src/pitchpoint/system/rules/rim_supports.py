# SPDX-License-Identifier: Apache-2.0
"""Supports of flexible rims on the housings that carry their bodies."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.rim_support import RECORD
from pitchpoint.elements.signal import Pool
from pitchpoint.model.frames import body_frame
from pitchpoint.model.mechanism import seat_frame
from pitchpoint.multibody.rim import terms_at
from pitchpoint.multibody.ring_modes import support_shapes
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import frame_at, seat_at
from pitchpoint.system.rules.flexible_rim import rim_of, rims_of, ring_section, set_hidden

if TYPE_CHECKING:
    from pitchpoint.model.components.flexible_rim import RimSupports
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.system.rules.places import Places

Array = NDArray[np.float64]


def rim_support_bank(places: Places) -> Bank:
    """Supports of all flexible rims."""
    model, pool = places.model, Pool()
    rows, names = [], []
    for body, seat in model.mechanism.seats.items():
        for name in rims_of(model, body):
            gear = model.gears[name]
            if gear.flexible_rim.supports is None:
                continue
            row = np.zeros(1, RECORD)[0]
            place, axes = seat_frame(model, seat)
            row["i"], at = seat_at(model, body, model.bodies[body].gears[name])
            row["j"], origin, base = frame_at(model, seat.base, place)
            turned = axes.T @ body_frame(model, body)[1]
            table = _table(gear, gear.flexible_rim.supports, turned, at)
            table[:, 3:6] = (place + table[:, :3] @ axes.T - origin) @ base
            for first in (6, 9):
                table[:, first : first + 3] = table[:, first : first + 3] @ axes.T @ base
            row["count"], row["supports"] = len(table), pool.add(table)
            row["holds"] = gear.flexible_rim.supports.tangential > 0.0
            set_hidden(row, model, body, name, int(row["i"]))
            rows.append(row)
            names.append(f"{name}.supports")
    return pack("rim_support", RECORD, rows, names, pool=pool.array())


def _table(gear: Gear, given: RimSupports, turned: Array, at: float) -> Array:
    """Rows of the supports, with the points and directions on the housing in the axes of the body.

    `turned`: axes of the body in those of its frame; `at`: mid-face along the z axis of the frame [m].
    """
    section = ring_section(gear)
    angles = [math.atan2(*(turned @ (math.cos(a), math.sin(a), 0.0))[1::-1]) for a in given.places]
    shapes = support_shapes(terms_at(rim_of(gear).terms, section.outer), given.places)
    rows = []
    for angle, shape in zip(angles, shapes, strict=True):
        out = np.array((math.cos(angle), math.sin(angle), 0.0))
        along = np.array((-out[1], out[0], 0.0))
        point = section.outer * out + (0.0, 0.0, at)
        moved = np.outer(shape[0], out) + np.outer(shape[1], along)
        rows.append(
            np.concatenate([point, point, out, along, (given.radial, given.tangential), moved.ravel()])
        )
    return np.array(rows)
