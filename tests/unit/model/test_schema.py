# SPDX-License-Identifier: Apache-2.0
"""One description per key feeds the JSON schema and the reference page."""

from __future__ import annotations

import json

from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.model.keys import walk
from pitchpoint.model.model import Model
from pitchpoint.model.reference import reference_page
from pitchpoint.model.schema import json_schema


def test_every_key_is_described() -> None:
    rows = list(walk(Model))
    assert len(rows) > 150
    for path, _, _, key in rows:
        assert key.meaning, path
        assert key.dimension in ("", *DIMENSIONS), path


def test_schema_is_json_with_units_and_closed_objects() -> None:
    schema = json.loads(json.dumps(json_schema(), allow_nan=False))
    gear = schema["$defs"]["Gear"]
    assert gear["required"] == ["number_of_teeth", "normal_module", "face_width"]
    assert gear["properties"]["helix_angle"]["unit"] == "rad"
    assert gear["properties"]["normal_pressure_angle"]["default"] == "20 deg"
    for name, part in {"top": schema, **schema["$defs"]}.items():
        assert part["additionalProperties"] is False, name
        assert part["description"], name
    laws = schema["$defs"]["Mesh"]["properties"]["stiffness"]["oneOf"]
    assert {"$ref": "#/$defs/Fourier"} in laws


def test_reference_page_lists_every_key() -> None:
    page = reference_page()
    for path, _, name, _ in walk(Model):
        assert f"| `{name}` |" in page, path
    assert "`law: din3990`" in page
