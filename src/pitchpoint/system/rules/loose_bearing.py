# SPDX-License-Identifier: Apache-2.0
"""Linear bearings with a loose ring as records."""

from __future__ import annotations

import numpy as np

from pitchpoint.elements import loose_bearing
from pitchpoint.model.components.bearing_fault import play
from pitchpoint.model.frames import body_frame
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bearing import damping_matrix, housing_numbers
from pitchpoint.system.rules.bodies import seat_at
from pitchpoint.system.rules.places import Places

SEAT = 0.1
"""Fraction of the radial play over which the seat stiffness increases to its full value."""
TILTS = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
"""Maps axial displacement and x, y of the shaft axis to axial displacement and rotations about x and y."""


def loose_bearing_bank(places: Places) -> Bank:
    """All bearings with play in the seat; bearings without play are linear, see `bearing_bank`."""
    model = places.model
    rows, names = [], []
    seats = housing_numbers(model)
    for name, part in model.bearings.items():
        clearance = play(part.faults.values())
        if clearance == 0.0:
            continue
        row = np.zeros(1, loose_bearing.RECORD)[0]
        row["i"], row["p_i"][2] = seat_at(model, part.body, part.position[2])
        row["A_i"] = row["A_j"] = np.eye(3)
        if name in seats:
            row["j"] = seats[name]
        else:
            origin = np.array(model.bodies[part.body].origin or (0.0, 0.0, 0.0))
            axes = body_frame(model, part.body)[1]
            row["p_j"], row["A_j"] = origin + axes @ [0.0, 0.0, part.position[2]], axes
        K, D = np.array(part.stiffness.matrix6()), damping_matrix(model, part, (part.body,))
        row["gap"], row["seat"] = 0.5 * clearance, 0.5 * SEAT * clearance
        row["k"], row["d"] = K[0, 0], D[0, 0]
        row["Kt"], row["Dt"] = (TILTS.T @ A[2:5, 2:5] @ TILTS for A in (K, D))
        rows.append(row)
        names.append(name)
    return pack("loose_bearing", loose_bearing.RECORD, rows, names)
