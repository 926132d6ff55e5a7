# SPDX-License-Identifier: Apache-2.0
"""Lubricant and housing of a model as components of REXS."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pitchpoint.io.rexs.conversion.casing import FIXED, MATRIX, MILLI, condensed
from pitchpoint.io.rexs.conversion.frames import TO_MODEL
from pitchpoint.io.rexs.document import Value
from pitchpoint.io.rexs.exporting.draft import Draft, attribute, placed
from pitchpoint.model.components.housing import HousingBody, HousingMatrix, RigidHousing
from pitchpoint.model.load_cases import oil_of

BASES = {
    "mineral": "mineral_oil",
    "polyalphaolefin": "polyalfaolefin",
    "polyglycol": "non_water_soluble_polyglycol",
}
"""`lubricant_type_iso_6336_2006` by the base oil."""


def add_lubricant(draft: Draft) -> None:
    """Add the lubricant of all stages, and its temperature to the casing."""
    oil = oil_of(draft.model)
    if oil is None:
        return
    at_40, at_100 = oil.viscosities
    id = draft.add(
        "lubricant",
        oil.name or oil.grade or "lubricant",
        kind="oil",
        viscosity_at_40_degree_celsius=at_40,
        viscosity_at_100_degree_celsius=at_100,
        density_at_15_degree_celsius=oil.density_at_15_degree_celsius,
        lubricant_type_iso_6336_2006=BASES.get(oil.base),
    )
    if oil.name or oil.grade:
        _set(draft, id, "name", str(oil.name or oil.grade))
    for origin in (draft.casing, *draft.meshes.values()):
        draft.relate("reference", origin=origin, referenced=id)
    _set(draft, draft.casing, "temperature_lubricant", oil.temperature)
    if oil.pressure_viscosity is not None:
        draft.omit("lubricant.pressure_viscosity", "REXS has it at 38 degrees Celsius: not written")


def _set(draft: Draft, id: int, name: str, value: Value) -> None:
    """Give a component a further value."""
    one = draft.components[id]
    found = attribute(name, value, one.type)
    draft.components[id] = replace(one, attributes={**one.attributes, name: found})


SeatStiffness = tuple[tuple[str, ...], np.ndarray]
"""Nodes of a housing matrix, and the matrix with the springs of its feet, in SI units along its axes."""


def add_housing(draft: Draft, stiffness: SeatStiffness | None) -> None:
    """Add the stiffness matrix of the housing, or its mass."""
    held = draft.model.housing
    if isinstance(held, RigidHousing):
        if held.mass is not None:
            _set(draft, draft.casing, "mass_of_component", held.mass)
            draft.omit("housing", "mounts and moments of inertia are not written: the casing is fixed")
        if held.parts:
            draft.omit("housing.parts", "not written")
    elif isinstance(held, HousingBody):
        draft.omit("housing", f"is the body {held.body}, which is not written: the casing is rigid")
    elif isinstance(held, HousingMatrix) and stiffness is None:
        draft.omit("housing", "its matrix is not given: the casing is rigid")
    elif isinstance(held, HousingMatrix) and stiffness is not None:
        _add_matrix(draft, held, stiffness)


def _add_matrix(draft: Draft, held: HousingMatrix, stiffness: SeatStiffness) -> None:
    """Add the stiffness matrix between the bearings; the feet are on ground or without load."""
    from pitchpoint.model.frames import frame

    nodes, K = stiffness
    if held.rows_per_node != 6 or held.parts:
        reason = "the matrix has bodies of parts" if held.parts else "the matrix has no rotations"
        draft.omit("housing", f"{reason}: not written, the casing is rigid")
        return
    kept = [k for k, node in enumerate(nodes) if node in draft.supports]
    if len(kept) < len(nodes):
        feet = ", ".join(node for node in nodes if node not in draft.supports)
        draft.omit("housing.feet", f"the matrix of the file is reduced to the bearings: {feet}")
    K = condensed(K, kept)
    axes = np.eye(3) if held.axes is None else frame(held.axes)
    turn = np.kron(np.eye(2 * len(kept)), TO_MODEL @ axes)
    K = turn @ K @ turn.T
    meter = np.kron(np.tile([MILLI, 1.0], len(kept)), np.ones(3))  # displacements in mm, rotations in rad
    newton = np.kron(np.tile([1.0, 1.0 / MILLI], len(kept)), np.ones(3))  # forces in N, moments in N mm
    K = newton[:, None] * K * meter[None, :]
    group = draft.add("assembly_group", "housing", **placed(np.zeros(3), np.eye(3), draft.unit))
    _set(draft, group, FIXED, True)
    _set(draft, group, MATRIX, tuple(tuple(float(x) for x in row) for row in 0.5 * (K + K.T)))
    draft.relate("reference", origin=draft.casing, referenced=group)
    for order, k in enumerate(kept, 1):
        support = draft.supports[nodes[k]]
        place = placed(_place(draft, nodes[k]), np.eye(3), draft.unit)
        named = ("reference_component_for_position", "support_vector")
        point = draft.add("reduction_point", nodes[k], **{key: place[key] for key in named})
        draft.relate("ordered_assembly", order=order, assembly=group, part=point)
        draft.relate("reference", origin=point, referenced=support)
    for key in ("mass_file", "damping_file", "stiffness_damping"):
        if getattr(held, key):
            draft.omit(f"housing.{key}", "REXS has neither mass nor damping of a casing")


def _place(draft: Draft, bearing: str) -> np.ndarray:
    """Centre of a bearing in the world [m]."""
    model = draft.model
    part = model.bearings.get(bearing) or model.rolling_bearings[bearing]
    origin, axes = draft.frame(str(part.body).partition(".")[0])
    return origin + np.asarray(axes) @ np.array(part.position)
