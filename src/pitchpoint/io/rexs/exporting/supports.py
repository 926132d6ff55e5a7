# SPDX-License-Identifier: Apache-2.0
"""Bearings and couplings as components of REXS."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.io.rexs.conversion.rolling import TYPES
from pitchpoint.io.rexs.exporting.draft import Draft

if TYPE_CHECKING:
    from pitchpoint.model.components.rolling_bearing import RollingBearing
    from pitchpoint.model.components.six import Stiffness6

NAMES = {name: word for word, name in TYPES.items()}
"""`bearing_type` of REXS by the type of the model file."""
GROUND = "ground"
COAXIAL = 1e-6
"""Distance from the axis above which a bearing is in a housing, not on a shaft [m]."""


def add_supports(draft: Draft) -> None:
    """Add linear bearings, rolling bearings and couplings."""
    for name, bearing in draft.model.bearings.items():
        inner, outer = bearing.body, (bearing.given or bearing).housing or GROUND
        path = f"bearings.{name}"
        if bearing.stage is not None:
            path = f"planetary_stages.{bearing.stage}.bearing"
        turning = bearing.stiffness.torsion > 0.0
        values = _stiffness(draft, bearing.stiffness, path, turning)
        kind = "coupling" if turning else "concept_bearing"
        _connect(draft, kind, name, (inner, outer), bearing.position, path, values)
    for name, coupling in draft.model.couplings.items():
        path = f"couplings.{name}"
        values = _stiffness(draft, coupling.stiffness, path, True)
        _connect(draft, "coupling", name, coupling.bodies, coupling.position, path, values)
    for name, rolling in draft.model.rolling_bearings.items():
        _add_rolling(draft, name, rolling)


def _stiffness(draft: Draft, found: Stiffness6, path: str, turning: bool) -> dict[str, Any]:
    """Stiffness of a concept bearing or coupling; REXS has one for all radial directions."""
    if found.matrix is not None:
        if any(found.matrix[i][j] for i in range(6) for j in range(6) if i != j):
            draft.omit(f"{path}.stiffness.matrix", "only its diagonal is written")
        k = [float(found.matrix[i][i]) for i in range(6)]
    else:
        radial, tilt = found.radial or 0.0, found.tilt or 0.0
        k = [found.x or radial, found.y or radial, found.axial, found.rx or tilt, found.ry or tilt]
        k.append(found.torsion)
    for a, b, key in ((k[0], k[1], "x, y"), (k[3], k[4], "rx, ry")):
        if a != b:
            draft.omit(f"{path}.stiffness", f"the mean of {key} is written: REXS has one value")
    values: dict[str, Any] = {
        "radial_force_absorption": k[0] + k[1] > 0.0,
        "axial_force_absorption": "both_directions" if k[2] > 0.0 else "no_direction",
        "radial_stiffness": 0.5 * (k[0] + k[1]),
        "axial_stiffness": k[2],
        "bending_stiffness": 0.5 * (k[3] + k[4]),
    }
    return {**values, "rotational_stiffness": k[5]} if turning else values


def _connect(
    draft: Draft,
    kind: str,
    name: str,
    ends: tuple[str, str],
    position: tuple[float, float, float],
    path: str,
    values: dict[str, Any],
) -> int | None:
    """Add a component between two bodies, at a position on the first one."""
    from pitchpoint.model.frames import marker_of, split

    bodies = [split(end)[0] for end in ends]
    sides = [draft.casing if body == GROUND else draft.shafts.get(body) for body in bodies]
    inner, outer = sides
    own = marker_of(draft.model, ends[0])
    x, y, z = (a + b for a, b in zip(position, (0.0,) * 3 if own is None else own.position, strict=True))
    marker = marker_of(draft.model, ends[1])
    there = (0.0, 0.0, 0.0)
    if marker is not None:
        there = marker.position
    elif GROUND not in bodies and None not in sides:
        there = _seen(draft, bodies, z)
    planet = any(body in draft.model.bodies and draft.model.bodies[body].stage for body in bodies)
    if max(map(abs, there[:2])) > COAXIAL and not planet:
        draft.omit(
            f"{path}.housing", f"{bodies[1]} is the casing in the file: the bearing is not on its axis"
        )
        bodies[1], outer = GROUND, draft.casing
    if inner is None or outer is None:
        draft.omit(path, f"is between {ends[0]} and {ends[1]}, which are not both shafts of the file")
        return None
    if max(abs(x), abs(y)) > 0.0:
        draft.omit(f"{path}.position", "only the position along the axis is written")
    values = {**values, "u_coordinate_on_shaft_inner_side": float(z)}
    if bodies[1] != GROUND:
        values["u_coordinate_on_shaft_outer_side"] = float(there[2])
    id = draft.add(kind, name, **values)
    draft.supports[name] = id
    draft.relate("side", assembly=id, inner_part=inner, outer_part=outer)
    return id


def _seen(draft: Draft, bodies: list[str], z: float) -> tuple[float, float, float]:
    """Point of the axis of the first body at z, in the axes of the second body [m]."""
    (origin, axes), (other, axes_other) = (draft.frame(body) for body in bodies)
    x, y, along = (float(value) for value in axes_other.T @ (origin + z * axes[:, 2] - other))
    return x, y, along


def _add_rolling(draft: Draft, name: str, bearing: RollingBearing) -> None:
    """Add a rolling bearing: by designation, by its load ratings, or by its elements."""
    path = f"rolling_bearings.{name}"
    ends = bearing.ends or (str(bearing.body), (bearing.given or bearing).housing or GROUND)
    geometry = bearing.geometry
    values: dict[str, Any] = {
        "axial_force_absorption": bearing.axial_force_absorption,
        "operating_radial_bearing_clearance": bearing.clearance,
        "preload_force": bearing.preload,
    }
    detailed = bearing.designation is None and bearing.radial_dynamic_load_rating is None
    if bearing.designation is not None:
        values["catalogue_designation"] = bearing.designation
    for key in ("inner_diameter", "outer_diameter", "width"):
        values[key] = getattr(geometry, key, None) or getattr(bearing, key)
    if not detailed:
        load = "axial" if bearing.type == "thrust_ball" else "radial"
        values["bearing_type"] = NAMES.get(str(bearing.type))
        values[f"{load}_dynamic_load_rating"] = bearing.radial_dynamic_load_rating
        values[f"{load}_static_load_rating"] = bearing.radial_static_load_rating
    kind = f"rolling_bearing_with_{'detailed' if detailed else 'catalog'}_geometry"
    id = _connect(draft, kind, name, ends, bearing.position, path, values)
    if id is None or not detailed:
        if id is not None and bearing.contact_angle:
            row = draft.add("rolling_bearing_row", pressure_angle=abs(bearing.contact_angle))
            draft.relate("ordered_assembly", order=1, assembly=id, part=row)
        return
    grooves = bearing.grooves or (None, None)
    radii: dict[str, Any] = {
        f"raceway_radius_of_{ring}_ring": None if g is None else g * float(bearing.element_diameter or 0.0)
        for ring, g in zip(("inner", "outer"), grooves, strict=True)
    }
    row = draft.add(
        "rolling_bearing_row",
        number_of_rolling_elements=bearing.elements,
        reference_diameter_rolling_bearing=bearing.pitch_diameter,
        pressure_angle=bearing.contact_angle,
        **radii,
    )
    element = draft.add(
        "rolling_element",
        diameter_of_rolling_element=bearing.element_diameter,
        length_of_rolling_element=bearing.effective_length,
    )
    draft.relate("ordered_assembly", order=1, assembly=id, part=row)
    draft.relate("ordered_assembly", order=1, assembly=row, part=element)
