# SPDX-License-Identifier: Apache-2.0
"""REXS files for tests: a single-stage gear unit, and a writer of parts and relations in XML and JSON."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any
from xml.sax.saxutils import escape, quoteattr

UNITS = {
    "deg": (
        *("helix_angle_reference_diameter", "normal_pressure_angle", "pressure_angle", "mean_spiral_angle"),
        *("shaft_angle", "generated_pressure_angle_on_drive_side", "generated_pressure_angle_on_coast_side"),
    ),
    "none": (
        *("number_of_teeth", "addendum_modification_coefficient", "axial_force_absorption", "poisson_ratio"),
        *(
            "radial_force_absorption",
            "catalogue_designation",
            "transmits_torque",
            "defines_torque",
            "bearing_type",
        ),
        *("reference_component_for_position", "defines_speed", "data_source", "referenced_component_id"),
        *(
            "is_engaged",
            "gear_shift_index",
            "shape_of_relief",
            "account_for_gravity",
            "direction_vector_gravity_w",
        ),
        *("addendum_coefficient_reference_profile", "tip_corner_radius_factor_reference_profile"),
        *("datum_face_orientation", "bevel_cone_orientation", "spiral_angle_pitch_direction", "basis"),
        *("reduced_static_stiffness_matrix", "matrix_with_inertial_environment_boundary"),
        *("profile_shift_coefficient", "lubricant_type_iso_6336_2006", "number_of_bearing_rows"),
        "catalogue_value_e",
    ),
    "C": ("temperature_lubricant",),
    "mm^2 / s": ("viscosity_at_40_degree_celsius", "viscosity_at_100_degree_celsius"),
    "%": ("operating_time_fraction",),
    "h": ("operating_time",),
    "N m": ("torque_around_u_axis",),
    "N": ("force_u_direction", "force_v_direction", "force_w_direction"),
    "1 / min": ("rotational_speed",),
    "kN": ("radial_dynamic_load_rating", "radial_static_load_rating"),
    "N / mm^2": ("elastic_modulus",),
    "kg / dm^3": ("density", "density_at_15_degree_celsius"),
    "kg": ("mass_of_component",),
    "kW": ("power",),
    "kg m^2": ("moment_of_inertia_u_axis", "moment_of_inertia_v_axis", "moment_of_inertia_w_axis"),
    "N / m": ("radial_stiffness", "axial_stiffness"),
    "N mm / rad": ("bending_stiffness", "rotational_stiffness"),
    "m / s^2": ("gravitational_acceleration",),
}
"""Units of attributes; the others are lengths in mm."""
_UNIT_OF = {name: unit for unit, names in UNITS.items() for name in names}

Part = tuple[str, Mapping[str, Any]]
"""Type and values of a component."""
Relation = tuple[str, Mapping[str, int]]
"""Type of a relation and components by role."""


def _cells(value: Any) -> str:
    if isinstance(value, Sequence) and not isinstance(value, str) and isinstance(value[0], Sequence):
        rows = ("<r>" + "".join(f"<c>{_cells(v)}</c>" for v in row) + "</r>" for row in value)
        return f"<matrix>{''.join(rows)}</matrix>"
    if isinstance(value, Sequence) and not isinstance(value, str):
        return "<array>" + "".join(f"<c>{_cells(v)}</c>" for v in value) + "</array>"
    return str(value).lower() if isinstance(value, bool) else escape(str(value))


def _values(values: Mapping[str, Any]) -> str:
    rows = ((f"id={quoteattr(n)} unit={quoteattr(_UNIT_OF.get(n, 'mm'))}", v) for n, v in values.items())
    return "".join(f"<attribute {head}>{_cells(value)}</attribute>\n" for head, value in rows)


def rexs(
    parts: Mapping[int, Part],
    relations: Sequence[Relation],
    cases: Sequence[Mapping[int, Mapping[str, Any]]] = (),
    version: str = "1.4",
) -> str:
    """Text of an XML file; load cases have the values of components by their numbers."""
    text = '<?xml version="1.0" encoding="UTF-8"?>\n<model applicationId="a program" applicationVersion="1" '
    text += f'date="2026-01-01T00:00:00+00:00" version="{version}">\n<relations>\n'
    for number, (kind, roles) in enumerate(relations, 1):
        refs = "".join(f'<ref id="{id}" role="{role}"/>' for role, id in roles.items())
        text += f'<relation id="{number}" type="{kind}">{refs}</relation>\n'
    text += "</relations>\n<components>\n"
    for id, (kind, values) in parts.items():
        text += f'<component id="{id}" type="{kind}" name="{kind} {id}">\n{_values(values)}</component>\n'
    text += "</components>\n"
    if cases:
        text += '<load_spectrum id="1">\n'
        for number, case in enumerate(cases, 1):
            rows = "".join(
                f'<component id="{id}" type="{parts[id][0]}">\n{_values(values)}</component>\n'
                for id, values in case.items()
            )
            text += f'<load_case id="{number}">\n{rows}</load_case>\n'
        text += "</load_spectrum>\n"
    return text + "</model>\n"


def place(x: float, y: float, z: float, reference: int = 1) -> dict[str, Any]:
    """Position of a part with its axis along u of the gear unit [mm]."""
    return {
        "support_vector": [x, y, z],
        "u_axis_vector": [1, 0, 0],
        "w_axis_vector": [0, 0, 1],
        "reference_component_for_position": reference,
    }


def unit() -> tuple[dict[int, Part], list[Relation], list[dict[int, dict[str, Any]]]]:
    """Parts, relations and load cases of a helical single-stage gear unit, to be changed by a test."""
    shaft = {"u_coordinate_on_shaft": 0, "length": 120, "outer_diameter_begin": 30, "outer_diameter_end": 30}
    parts: dict[int, Part] = {
        1: ("gear_unit", place(0, 0, 0)),
        2: ("gear_casing", {}),
        3: ("shaft", {**place(0, 0, 0), "defines_speed": True}),
        4: ("shaft", place(0, 0, 69.3)),
        5: ("shaft_section", shaft),
        6: ("shaft_section", shaft),
        7: ("cylindrical_gear", {**_GEAR, "number_of_teeth": 21, "face_width": 20}),
        8: (
            "cylindrical_gear",
            {**_GEAR, "number_of_teeth": 46, "face_width": 18, "helix_angle_reference_diameter": -12},
        ),
        9: ("cylindrical_gear_flank", _FLANK),
        10: ("cylindrical_gear_flank", _FLANK),
        11: ("cylindrical_gear_flank", {"normal_pressure_angle": 20}),
        12: ("cylindrical_gear_flank", {"normal_pressure_angle": 20}),
        13: ("cylindrical_stage", {"center_distance": 69.3}),
        14: ("external_load", {"u_coordinate_on_shaft": 0, "transmits_torque": True}),
        15: ("external_load", {"u_coordinate_on_shaft": 120, "transmits_torque": True}),
        16: ("material", {"elastic_modulus": 206000, "poisson_ratio": 0.3, "density": 7.8}),
    }
    for k, (u, absorbs) in enumerate(((10, "both_directions"), (110, "no_direction"))):
        for number, _ in ((17 + k, 3), (19 + k, 4)):
            parts[number] = (
                "rolling_bearing_with_catalog_geometry",
                {
                    "u_coordinate_on_shaft_inner_side": u,
                    "catalogue_designation": "6206",
                    "axial_force_absorption": absorbs,
                },
            )
    relations: list[Relation] = [
        *(("assembly", {"assembly": 1, "part": n}) for n in (2, 3, 4, 13)),
        *(
            ("assembly", {"assembly": a, "part": b})
            for a, b in ((3, 5), (4, 6), (3, 7), (4, 8), (3, 14), (4, 15))
        ),
        ("stage", {"stage": 13, "gear_1": 7, "gear_2": 8}),
        ("flank", {"gear": 7, "left": 9, "right": 10}),
        ("flank", {"gear": 8, "left": 11, "right": 12}),
        *(("reference", {"origin": n, "referenced": 16}) for n in (3, 4)),
        *(
            ("side", {"assembly": n, "inner_part": s, "outer_part": 2})
            for n, s in ((17, 3), (18, 3), (19, 4), (20, 4))
        ),
    ]
    cases = [
        {3: {"rotational_speed": 1500}, 14: {"torque_around_u_axis": 40}},
        {3: {"rotational_speed": -900}, 14: {"torque_around_u_axis": -40}},
    ]
    return parts, relations, cases


_GEAR = {"u_coordinate_on_shaft": 60, "normal_module": 2, "helix_angle_reference_diameter": 12}
_FLANK = {"normal_pressure_angle": 20, "addendum_modification_coefficient": 0.3}
GEARBOX = rexs(*unit())


CONCEPT = {
    "radial_stiffness": 1e8,
    "axial_stiffness": 1e8,
    "axial_force_absorption": "both_directions",
}
"""Values of a concept bearing without tilting stiffness."""


def bevel_unit(**stage):
    """Text of a bevel gear unit 17/31, m_mn = 3 mm, 35 deg, shaft angle 90 deg; axes along u and w."""
    z, m, beta = (17, 31), 3.0, 35.0
    tan = z[0] / z[1]
    middle = [
        n * m / (2.0 * math.cos(math.radians(beta)) * t) for n, t in zip(z, (tan, 1.0 / tan), strict=True)
    ]
    shaft = {"length": 100, "outer_diameter_begin": 30, "outer_diameter_end": 30, "u_coordinate_on_shaft": 0}
    across = {"support_vector": [0, 0, 10], "u_axis_vector": [0, 0, 1], "w_axis_vector": [-1, 0, 0],
              "reference_component_for_position": 1}  # fmt: skip
    teeth = {"mean_normal_module": m, "face_width": 20}
    parts = {
        1: ("gear_unit", place(0, 0, 0)),
        2: ("gear_casing", {}),
        # the pinion shaft ends before the apex at u = 0, the wheel shaft begins beyond it
        3: ("shaft", {**place(-middle[0] - 60, 0, 0), "defines_speed": True}),
        4: ("shaft", across),
        5: ("shaft_section", shaft),
        6: ("shaft_section", shaft),
        7: ("bevel_gear", {**teeth, "number_of_teeth": z[0], "mean_spiral_angle": -beta,
                           "u_coordinate_on_shaft": 60, "bevel_cone_orientation": "positive",
                           "profile_shift_coefficient": 0.3}),
        8: ("bevel_gear", {**teeth, "number_of_teeth": z[1], "mean_spiral_angle": beta,
                           "u_coordinate_on_shaft": middle[1] - 10, "bevel_cone_orientation": "negative",
                           "profile_shift_coefficient": -0.3}),
        9: ("bevel_stage", {"shaft_angle": 90, "generated_pressure_angle_on_drive_side": 21,
                            "generated_pressure_angle_on_coast_side": 19,
                            "mean_normal_backlash": 0.1, **stage}),
        10: ("external_load", {"u_coordinate_on_shaft": 0, "transmits_torque": True}),
        11: ("external_load", {"u_coordinate_on_shaft": 90, "transmits_torque": True}),
    }  # fmt: skip
    relations = [
        *(("assembly", {"assembly": 1, "part": n}) for n in (2, 3, 4, 9)),
        *(
            ("assembly", {"assembly": a, "part": b})
            for a, b in ((3, 5), (4, 6), (3, 7), (4, 8), (3, 10), (4, 11))
        ),
        ("stage", {"stage": 9, "gear_1": 7, "gear_2": 8}),
    ]
    for number, owner, u in ((12, 3, 10), (13, 3, 80), (14, 4, 10), (15, 4, 80)):
        parts[number] = ("concept_bearing", {**CONCEPT, "u_coordinate_on_shaft_inner_side": u})
        relations.append(("side", {"assembly": number, "inner_part": owner, "outer_part": 2}))
    return parts, relations, [{3: {"rotational_speed": 1000}, 10: {"torque_around_u_axis": 50}}]


def as_json(text: str) -> str:
    """The same file as JSON."""
    from xml.etree import ElementTree

    from pitchpoint.io.rexs.tables import definition

    def number(value: str, kind: str) -> Any:
        if kind == "boolean":
            return value == "true"
        if kind in ("integer", "reference_component"):
            return int(value)
        return float(value) if kind == "floating_point" else value

    root = ElementTree.fromstring(text)

    def attribute(part: Any, one: Any) -> dict[str, Any]:
        known = definition(root.get("version", ""), one.get("id"), part.get("type"))
        assert known is not None, one.get("id")
        base = known.type.removesuffix("_array")
        cells = [number(c.text, base) for c in one.iter("c")]
        value: Any = cells if known.type.endswith("_array") else number(one.text, known.type)
        return {"id": one.get("id"), "unit": one.get("unit"), known.type: value}

    def component(part: Any) -> dict[str, Any]:
        return {
            "id": int(part.get("id")),
            "type": part.get("type"),
            "name": part.get("name", ""),
            "attributes": [attribute(part, one) for one in part],
        }

    model: dict[str, Any] = dict(root.attrib)
    model["relations"] = [
        {
            "id": int(r.get("id")),
            "type": r.get("type"),
            "refs": [{"id": int(ref.get("id")), "role": ref.get("role")} for ref in r],
        }
        for r in root.iter("relation")
    ]
    components = root.find("components")
    assert components is not None
    model["components"] = [component(part) for part in components]
    spectrum = root.find("load_spectrum")
    if spectrum is not None:
        model["load_spectrum"] = {
            "id": 1,
            "load_cases": [
                {"id": int(case.get("id", 0)), "components": [component(part) for part in case]}
                for case in spectrum
            ],
        }
    return json.dumps({"model": model}, indent=1)
