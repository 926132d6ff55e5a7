# SPDX-License-Identifier: Apache-2.0
"""Housing of a model: what it is, and the seat of every bearing in it with its stiffness."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.model.components.housing import HousingBody, HousingMatrix, RigidHousing
from pitchpoint.model.housing import bearings_in, node_bodies, seat_name
from pitchpoint.report.load_cases import load_case_facts, lubricant_facts

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def gearbox_facts(model: Model) -> dict[str, Any]:
    """Housing, lubricant and load cases of a model."""
    return {
        "housing": housing_facts(model),
        "lubricant": lubricant_facts(model),
        "load_cases": load_case_facts(model),
    }


def housing_facts(model: Model) -> dict[str, Any]:
    """Type, words, seats and bodies of the housing of a model; `type` is None without one.

    Returns
    -------
    dict
        Keys `type`, `words`, `seats`: for every node the body or marker of its seat and, of a matrix, its
        stiffness along the axes of the matrix with all other nodes free [N/m]; `hidden`: bodies and joints
        that only represent its nodes.

    Raises
    ------
    ModelError
        If the matrices of the housing are not valid.
    """
    held = model.housing
    if held is None:
        return {"type": None, "words": "", "parts": [], "seats": {}, "hidden": []}
    seats: dict[str, Any] = {
        name: {"seat": part.housing or "ground", "stiffness": None}
        for name, (_, part) in bearings_in(model).items()
    }
    hidden: list[str] = []
    if isinstance(held, HousingMatrix):
        words, seats = _of_matrix(model, held)
        hidden = [*node_bodies(model)]
    elif isinstance(held, HousingBody):
        kind = "elastic body" if held.body in model.elastic_bodies else "body"
        words = f"{kind} {held.body}"
    elif isinstance(held, RigidHousing) and held.mass is not None:
        words = f"rigid, {held.mass:.6g} kg on {len(held.mounts)} mounts"
    else:
        words = "rigid on ground"
    return {"type": held.type, "words": words, "parts": list(held.parts), "seats": seats, "hidden": hidden}


def _of_matrix(model: Model, held: HousingMatrix) -> tuple[str, dict[str, Any]]:
    """Words of a housing matrix, and the stiffness of its nodes."""
    from pitchpoint.system.housing_matrices import supported_stiffness

    nodes, K = supported_stiffness(model)
    n = held.rows_per_node
    own = 1.0 / np.diag(np.linalg.inv(K))
    mass = "with mass matrix" if held.mass_file is not None else "without mass"
    seats: dict[str, Any] = {
        node: {"seat": seat_name(node), "stiffness": [float(v) for v in own[n * k : n * k + 3]]}
        for k, node in enumerate(nodes)
    }
    seats |= {node: {"seat": "ground", "stiffness": None} for node in held.nodes if node not in seats}
    return f"stiffness matrix of {len(held.nodes)} nodes, {mass}", seats
