# SPDX-License-Identifier: Apache-2.0
"""Keys of the model file that are in a REXS file; all others that are given are listed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from pitchpoint.io.rexs.exporting.draft import Draft
from pitchpoint.model.stand_ins import own_parts
from pitchpoint.model.write import plain_component

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

_PLACE = ("position", "axes", "markers")
_STIFFNESS = ("position", "stiffness")
WRITTEN: dict[str, tuple[str, ...]] = {
    "gears": (
        *("type", "number_of_teeth", "normal_module", "normal_pressure_angle", "helix_angle", "hand"),
        *(
            "profile_shift_coefficient",
            "face_width",
            "tip_diameter",
            "root_diameter",
            "tip_alteration",
            "mass",
        ),
        *("rack", "cutter", "bore_diameter", "material", "modifications"),
    ),
    "shafts": ("sections", "material", "gears", "bevel_gears", "largest_piece", *_PLACE),
    "bodies": (
        *(
            "gears",
            "bevel_gears",
            "motion",
            "mass",
            "inertia",
            "transverse_inertia",
            "inertia_tensor",
            "center_of_mass",
        ),
        *("solid", *_PLACE),
    ),
    "planetary_stages": (
        *(
            "sun",
            "ring",
            "carrier",
            "planet",
            "planets",
            "angles",
            "planet_name",
            "center_distance",
            "position",
        ),
        *("motion", "bearing", "sun_mesh", "ring_mesh", "planet_mesh", "steps", "inner_planets"),
        *("planet_center_distance", "planet_side", "pin_errors"),
    ),
    "bevel_gears": (
        *("number_of_teeth", "mean_normal_module", "outer_transverse_module", "pitch_cone_angle"),
        *("mate_teeth", "shaft_angle", "normal_pressure_angle", "spiral_angle", "hand", "face_width"),
        *("profile_shift_coefficient", "thickness_modification_coefficient", "rack", "opens", "material"),
        "mass",
    ),
    "bevel_meshes": ("gears", "shaft_angle", "backlash"),
    "meshes": ("gears", "center_distance", "direction", "backlash", "stiffness", "width", "slices"),
    "bearings": ("body", "housing", *_STIFFNESS),
    "rolling_bearings": (
        *("body", "position", "housing", "ends", "designation", "type", "inner_diameter", "outer_diameter"),
        *("width", "radial_dynamic_load_rating", "radial_static_load_rating", "axial_force_absorption"),
        *("elements", "element_diameter", "pitch_diameter", "contact_angle", "clearance", "preload"),
        *("grooves", "effective_length", "slices"),
    ),
    "couplings": ("bodies", *_STIFFNESS),
    "loads": ("body", "torque", "force", "moment", "position", "marker", "reaction", "along"),
}
"""Keys by section of the model file."""
STEP = ("gear", "position", "sun", "ring", "inner_planets", "sun_mesh", "ring_mesh", "planet_mesh", "fitted")
"""Keys of the steps of planets."""
REASONS = {
    "damping": "REXS has no damping",
    "damper": "REXS has no damping",
    "transient_damping": "REXS has no damping",
    "internal_damping": "REXS has no damping",
    "pin_stiffness": "part of the stiffness of the bearing in the file",
    "faults": "REXS has no damaged parts",
    "tooth_thickness_allowance": "not written; the backlash of the mesh contains it",
}
_INSIDE = {
    "planet": "gears",
    "gear": "gears",
    "sun_mesh": "meshes",
    "ring_mesh": "meshes",
    "planet_mesh": "meshes",
    "bearing": "bearings",
}
"""Keys of planetary stages with the keys of another section."""


def list_keys(draft: Draft, model: Model) -> None:
    """List the keys of all parts that are given and not in the file."""
    for section, written in WRITTEN.items():
        for name, part in own_parts(getattr(model, section)).items():
            _list(draft, f"{section}.{name}", plain_component(part), written)


def _list(draft: Draft, path: str, given: Mapping[str, Any], written: tuple[str, ...]) -> None:
    for key, value in given.items():
        if key not in written:
            draft.omit(f"{path}.{key}", REASONS.get(key, "not written"))
        elif key == "steps":
            for step, data in value.items():
                _list(draft, f"{path}.steps.{step}", data, STEP)
        elif key in _INSIDE and isinstance(value, Mapping):
            _list(draft, f"{path}.{key}", value, WRITTEN[_INSIDE[key]])
