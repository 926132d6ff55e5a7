# SPDX-License-Identifier: Apache-2.0
"""Gears with flanks, tools and modifications, and meshes as components of REXS."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from pitchpoint.io.rexs.conversion.modifications import CROWNINGS, ENDS
from pitchpoint.io.rexs.exporting.draft import Draft

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.components.modifications import FlankModifications, Relief


def add_gears(draft: Draft) -> None:
    """Add all gears on their shafts."""
    for body, found in draft.model.bodies.items():
        for name, z in found.gears.items():
            if name in draft.model.gears and body in draft.shafts:
                _add_gear(draft, name, draft.model.gears[name], body, z)
    for name in draft.model.gears:
        if name not in draft.gears:
            draft.omit(f"gears.{name}", "is on no shaft or body: not written")


def _add_gear(draft: Draft, name: str, gear: Gear, body: str, z: float) -> None:
    path = f"gears.{name}"
    geometry = gear.geometry
    internal = gear.type == "internal"
    hand = 1.0 if (gear.hand == "right") != internal else -1.0
    id = draft.part(
        "ring_gear" if internal else "cylindrical_gear",
        name,
        draft.shafts[body],
        u_coordinate_on_shaft=z,
        number_of_teeth=gear.number_of_teeth,
        normal_module=gear.normal_module,
        helix_angle_reference_diameter=hand * gear.helix_angle if gear.helix_angle else 0.0,
        face_width=gear.face_width,
        tip_diameter=abs(geometry.d_a),
        root_diameter=gear.root_diameter,
        mass_of_component=gear.mass,
        inner_diameter=None if internal else gear.bore_diameter or None,
        datum_face_orientation=None if gear.modifications is None else "positive",
    )
    draft.gears[name] = id
    if internal and gear.bore_diameter:
        draft.custom(id, "outer_diameter", 1e3 * gear.bore_diameter, "mm")
    draft.relate("reference", origin=id, referenced=draft.material(gear.material_data))
    _add_flanks(draft, id, gear, path)


def _add_flanks(draft: Draft, id: int, gear: Gear, path: str) -> None:
    geometry = gear.geometry
    sides: dict[str, int] = {}
    for side in ("left", "right"):
        sides[side] = draft.add(
            "cylindrical_gear_flank",
            "",
            normal_pressure_angle=gear.normal_pressure_angle,
            addendum_modification_coefficient=float(geometry.x),
        )
        found = None if gear.modifications is None else gear.modifications.side(side)
        if found is not None:
            _add_modifications(draft, sides[side], found, geometry, f"{path}.modifications.{side}")
    draft.relate("flank", gear=id, **sides)
    _add_tool(draft, sides.values(), gear)


def _add_modifications(
    draft: Draft, flank: int, found: FlankModifications, geometry: CylindricalGear, path: str
) -> None:
    for kind in ("tip_relief", "root_relief"):
        relief: Relief | None = getattr(found, kind)
        if relief is None:
            continue
        start = _start_of(relief, geometry, kind)
        if start is None or relief.shape not in ("linear", "parabolic"):
            draft.omit(
                f"{path}.{kind}", "only linear and parabolic reliefs that start on the flank are written"
            )
            continue
        values = {f"{kind}_depth": relief.amount, f"{kind}_datum_diameter": start}
        one = draft.add(kind, "", shape_of_relief=relief.shape, **values)
        draft.relate("reference", origin=flank, referenced=one)
    half = 0.5 * geometry.b
    root, tip = (abs(d) for d in (geometry.d_Ff, geometry.d_Fa))
    ends = {
        "profile_crowning": {f"diameter_where_profile_crowning_{end}_is_specified": d for end, d in
                             (("root", root), ("tip", tip))},
        "helix_crowning": {
            f"coordinate_where_helix_crowning_is_specified_{end}": s
            for end, s in (("datum_face", -half), ("non_datum_face", half))
        },
    }  # fmt: skip
    for kind, (first, second, key) in CROWNINGS.items():
        amount = getattr(found, key)
        if amount:
            _modify(draft, flank, kind, {first: amount, second: amount, **ends[kind]})
    if found.profile_slope:
        slope = {"profile_slope": found.profile_slope}
        _modify(draft, flank, "profile_slope", {
            **slope, "profile_evaluation_start": root, "profile_evaluation_end": tip,
        })  # fmt: skip
    if found.helix_slope:  # the datum face is at the end of the largest z
        places = {"helix_evaluation_start": -half, "helix_evaluation_end": half}
        _modify(draft, flank, "helix_slope", {"helix_slope": -found.helix_slope, **places})
        reason = "REXS does not define its sign: written as positive towards the non-datum face"
        draft.omit(f"{path}.helix_slope", reason)
    both = found.end_relief
    if both is not None:
        for kind, end in ENDS.items():
            values = {f"end_relief_depth_{end}": both.amount, f"end_relief_length_{end}": both.length}
            _modify(draft, flank, kind, {"shape_of_relief": both.shape, **values})


def _modify(draft: Draft, flank: int, kind: str, values: Mapping[str, float | str]) -> None:
    """Add a modification of a flank."""
    one = draft.add(kind, "", **values)
    draft.relate("reference", origin=flank, referenced=one)


def _start_of(relief: Relief, gear: CylindricalGear, kind: str) -> float | None:
    """Diameter at which a relief starts [m], also of one by its roll length; None within the base circle."""
    if relief.start_diameter is not None:
        return relief.start_diameter
    from pitchpoint.geometry.modifications import flank_range

    root, tip = flank_range(gear)
    end, inwards = (tip, root - tip) if kind == "tip_relief" else (root, tip - root)
    roll = end + math.copysign(relief.length or 0.0, inwards)
    return 2.0 * math.hypot(roll, 0.5 * gear.d_b) if roll > 0.0 else None


def _add_tool(draft: Draft, flanks: Iterable[int], gear: Gear) -> None:
    """Add the rack of a gear, or the cutter of an internal gear, as the tool of both flanks."""
    cutter = gear.cutter
    if gear.type != "internal":
        tool = draft.add(
            "rack_shaped_tool",
            addendum_coefficient_reference_profile=gear.rack.dedendum,
            tip_corner_radius_factor_reference_profile=gear.rack.root_radius,
        )
    elif cutter is not None:
        tool = draft.add(
            "cutter_wheel_tool",
            number_of_teeth=cutter.number_of_teeth,
            addendum_modification_coefficient=cutter.profile_shift_coefficient,
            addendum_coefficient_reference_profile=cutter.addendum,
            tip_corner_radius_factor_reference_profile=cutter.tip_radius,
        )
    else:
        return
    settings = draft.add("cylindrical_gear_manufacturing_settings")
    for flank in flanks:
        draft.relate(
            "manufacturing_step", order=1, workpiece=flank, tool=tool, manufacturing_settings=settings
        )


def add_meshes(draft: Draft, stiffness: Mapping[str, MeshStiffness] | None = None) -> None:
    """Add all meshes of cylindrical gears, with their stiffness.

    Parameters
    ----------
    draft
        The draft.
    stiffness
        Stiffness of meshes by name, if it is known.
    """
    for name, mesh in draft.model.meshes.items():
        pair = draft.model.pairs.get(name)
        if pair is None or any(gear not in draft.gears for gear in mesh.gears):
            draft.omit(f"meshes.{name}", "its gears are not in the file: not written")
            continue
        gap = draft.model.backlash(name) / math.cos(pair.alpha_wt)
        id = draft.part(
            "cylindrical_stage",
            name,
            draft.stages.get(mesh.stage or "", draft.unit),
            center_distance=abs(pair.a_w),
            minimum_transverse_backlash=gap,
            maximum_transverse_backlash=gap,
            **(stiffness or {}).get(name, {}),  # type: ignore[arg-type]
        )
        draft.meshes[name] = id
        first, second = mesh.gears
        draft.relate("stage", stage=id, gear_1=draft.gears[first], gear_2=draft.gears[second])


MeshStiffness = Mapping[str, float | Sequence[float]]
