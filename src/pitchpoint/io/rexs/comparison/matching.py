# SPDX-License-Identifier: Apache-2.0
"""Which component of one gear unit is which of another: by values and by place in the structure.

Ids and names are only hints: the cost of a pair is the mean difference of its values and of its neighbours in
the relations, whose cost again contains that of their neighbours. The pairs of each type are those with the
smallest total cost (assignment problem).
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from typing import TypeAlias

import numpy as np

from pitchpoint.io.rexs.comparison.equality import distance, is_reference
from pitchpoint.io.rexs.document import RexsComponent, RexsModel

IDENTITY = (
    *("number_of_teeth", "normal_module", "catalogue_designation", "support_vector", "center_distance"),
    *("u_coordinate_on_shaft", "u_coordinate_on_shaft_inner_side", "outer_diameter_begin", "length"),
)
"""Values that identify a part; each counts as much as `WEIGHT` others. A value that only one of the files has
counts `MISSING`."""
WEIGHT, MISSING = 3.0, 0.2
STRUCTURE = 0.5
"""Share of the neighbours in the cost of a pair."""
ROUNDS = 4
"""Number of relations over which a difference has an effect on the cost of a pair."""
LARGEST = 0.75
"""Cost above which two components are not the same part."""
NAME, ID = 1e-2, 1e-4
"""Cost of different names and ids, which decide only between pairs that are otherwise equal."""

RENAMED = {
    **dict.fromkeys(("flank_geometry", "bevel_gear_flank", "worm_gear_flank"), "cylindrical_gear_flank"),
    **dict.fromkeys(
        ("stage_gear_data", "bevel_stage_gear_data", "worm_stage_gear_data"), "cylindrical_stage_gear_data"
    ),
    "fixed_coupling": "coupling",
}
"""Types of the same part in different versions of REXS."""

Slots: TypeAlias = dict[tuple[str, str, str], list[int]]
"""Neighbours by type of the relation, own role and their role."""


def match(a: RexsModel, b: RexsModel) -> dict[int, int]:
    """Components of the second gear unit by those of the first; without those that have no counterpart."""
    ids_a, ids_b = list(a.components), list(b.components)
    own = _own_costs(a, b)
    near_a, near_b = _neighbours(a), _neighbours(b)
    cost = dict(own)
    for _ in range(ROUNDS):
        cost = {
            (i, j): (1.0 - STRUCTURE) * own[i, j] + STRUCTURE * _structure(near_a[i], near_b[j], cost)
            for i, j in own
        }
    found: dict[int, int] = {}
    for kind in {_kind(c) for c in a.components.values()}:
        of_a = [i for i in ids_a if _kind(a.components[i]) == kind]
        of_b = [j for j in ids_b if _kind(b.components[j]) == kind]
        table = np.array([[cost[i, j] + _hint(a, b, i, j) for j in of_b] for i in of_a])
        for row, column in _assigned(np.minimum(table, LARGEST)):
            if table[row, column] < LARGEST:
                found[of_a[row]] = of_b[column]
    return {i: found[i] for i in ids_a if i in found}


def _kind(component: RexsComponent) -> str:
    """Type of a component, the same for all versions."""
    return RENAMED.get(component.type, component.type)


def _hint(a: RexsModel, b: RexsModel, i: int, j: int) -> float:
    return NAME * (a.components[i].name != b.components[j].name) + ID * (i != j)


def _own_costs(a: RexsModel, b: RexsModel) -> dict[tuple[int, int], float]:
    """Difference of the values of all pairs of the same type."""
    by_type: dict[str, list[RexsComponent]] = defaultdict(list)
    for component in b.components.values():
        by_type[_kind(component)].append(component)
    return {
        (one.id, two.id): _own_cost(one, two) for one in a.components.values() for two in by_type[_kind(one)]
    }


def _own_cost(one: RexsComponent, two: RexsComponent) -> float:
    total, weights = 0.0, 1.0  # the type is equal
    for name in one.attributes.keys() | two.attributes.keys():
        x, y = one.attributes.get(name), two.attributes.get(name)
        if is_reference(x or y):  # type: ignore[arg-type]
            continue
        weight = WEIGHT if name in IDENTITY else 1.0
        weight *= MISSING if x is None or y is None else 1.0
        total += weight * distance(x, y)
        weights += weight
    return total / weights


def _neighbours(model: RexsModel) -> dict[int, Slots]:
    found: dict[int, Slots] = {id: defaultdict(list) for id in model.components}
    for relation in model.relations:
        for role, id in relation.roles.items():
            for other, neighbour in relation.roles.items():
                if other != role:
                    found[id][relation.type, role, other].append(neighbour)
    return found


def _structure(a: Slots, b: Slots, cost: Mapping[tuple[int, int], float]) -> float:
    """Mean cost of the neighbours, those without a counterpart with 1."""
    total, count = 0.0, 0
    for slot in a.keys() | b.keys():
        one, two = a.get(slot, []), b.get(slot, [])
        count += max(len(one), len(two))
        table = np.array([[cost.get((i, j), 1.0) for j in two] for i in one])
        total += abs(len(one) - len(two)) + sum(table[pair] for pair in _assigned(table))
    return total / count if count else 0.0


def _assigned(table: np.ndarray) -> list[tuple[int, int]]:
    """Pairs of rows and columns with the smallest total cost."""
    if table.size == 0:
        return []
    if table.size == 1:
        return [(0, 0)]
    from scipy.optimize import linear_sum_assignment

    rows, columns = linear_sum_assignment(table)
    return [(int(r), int(c)) for r, c in zip(rows, columns, strict=True)]
