# SPDX-License-Identifier: Apache-2.0
"""Housing matrix of a model as records of its blocks."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.housing_matrix import KIND, RECORD
from pitchpoint.model.components.housing import HousingMatrix
from pitchpoint.model.frames import axes_of
from pitchpoint.model.housing import BARE, seat_name
from pitchpoint.system.housing_matrices import Matrices, housing_matrices
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.places import Places

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]


def housing_bank(places: Places) -> Bank:
    """Blocks of the housing matrix; without records for other housings."""
    model = places.model
    if not isinstance(model.housing, HousingMatrix):
        return Bank(KIND.name, np.zeros(0, RECORD), ())
    found = housing_matrices(model)
    n = model.housing.rows_per_node
    inertia = found.M - BARE * np.eye(len(found.M))  # the bodies of the nodes have the rest
    weight = _weight(model, found)
    rows = []
    for one, first in enumerate(found.nodes):
        for two, second in enumerate(found.nodes):
            cut = np.ix_(n * one + np.arange(n), n * two + np.arange(n))
            blocks = [A[cut] for A in (inertia, found.D, found.K)]
            if one != two and not any(block.any() for block in blocks):
                continue
            row = np.zeros(1, RECORD)[0]
            row["i"], row["j"] = (places.numbers[seat_name(node)] for node in (first, second))
            for field, block in zip("MDK", blocks, strict=True):
                row[field][:n, :n] = block
            if one == two:
                row["f0"][:n] = -weight[n * one : n * one + n]
            rows.append(row)
    return pack(KIND.name, RECORD, rows, ["housing"] * len(rows))


def _weight(model: Model, found: Matrices) -> Array:
    """Forces of gravity on the nodes, in the axes of the matrix [N, N m]; zero without a mass matrix."""
    n = len(found.K) // max(1, len(found.nodes))
    rate = np.zeros(len(found.K))
    if model.gravity is None or not found.weighed:
        return rate
    axes = axes_of(model, seat_name(found.nodes[0]))
    for k in range(3):
        rate[k::n] = (axes.T @ np.array(model.gravity))[k]
    return np.asarray(found.M @ rate)
