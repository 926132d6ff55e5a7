# SPDX-License-Identifier: Apache-2.0
"""One description per key feeds the JSON schema and the reference page."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import jsonschema

from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.keys import keys_of, walk
from pitchpoint.model.model import Model
from pitchpoint.model.reading.yaml_tree import Tree
from pitchpoint.model.reference import reference_page, snippets_of
from pitchpoint.model.remarks.collect import remarks_of_file
from pitchpoint.model.schema import json_schema
from pitchpoint.model.sections import SECTIONS

ROOT = Path(__file__).parents[3]
CLASSES = {cls for _, cls, _, _ in walk(Model)} - {Model}


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
        assert f"| `{name}` |" in page or (path == name and f"| [{name}](#model-" in page), path
    assert "`law: din3990`" in page


def model_files() -> list[Path]:
    """Model files of the examples, of the reference page and of `new`, without plans of data sets."""
    folders = ("examples/*", "docs/reference/snippets", "src/pitchpoint/cli/starters")
    found = [path for folder in folders for path in sorted(ROOT.glob(f"{folder}/*.yaml"))]
    return [path for path in found if "factors" not in Tree(path.read_text()).data]


def test_the_schema_accepts_the_examples_and_their_values_as_formulas() -> None:
    """What the reader accepts must not be marked by an editor; each number may also be a formula."""
    validator = jsonschema.Draft202012Validator(json_schema())
    files = model_files()
    assert len(files) > 40
    for path in files:
        data = Tree(path.read_text()).data
        for each in (data, with_formulas(data)):
            assert [f"{path}: {e.json_path} {e.message[:200]}" for e in validator.iter_errors(each)] == []


def with_formulas(data: Any) -> Any:
    """Data with every number written as a formula."""
    if isinstance(data, dict):
        return {name: with_formulas(value) for name, value in data.items()}
    if isinstance(data, list):
        return [with_formulas(value) for value in data]
    return data if isinstance(data, str | bool) or data is None else f"2*{data}/2"


def test_the_schema_marks_what_the_reader_refuses() -> None:
    validator = jsonschema.Draft202012Validator(json_schema())
    path = next(p for p in model_files() if p.name == "gearbox.yaml")
    good = Tree(path.read_text()).data
    for section, change in {
        "gears": {"pinion": {"number_of_teeth": 20}},
        "meshes": {"stage": {"gears": ["pinion", "wheel"], "stiffness": {"law": "din39990"}}},
        "parameters": [1],
        "shfts": {},
        "include": 3,
    }.items():
        assert not validator.is_valid({**good, section: change}), section
    assert validator.is_valid({**good, "include": ["gears.yaml"]})


NAMES = ("two_mass", "rigid_ratio", "gearbox", "gearbox_all_directions", "turbulent")
PARTS = [("wind-turbine", f"{name}.yaml") for name in NAMES]
"""Files of the wind turbine to be included in its model."""


def test_the_reference_page_has_a_valid_snippet_for_every_section() -> None:
    shown: dict[str, str] = {}
    folders = ("snippets", "bevel-drive", "speed-control", "wind-turbine")
    files = [p for p in model_files() if p.parent.name in folders and (p.parent.name, p.name) not in PARTS]
    files += [ROOT / "examples/flexible-slider-crank/elastic.yaml"]
    for path in files:
        text = path.read_text()
        model = loads_model(text, allow_code=True, file=str(path))
        assert not remarks_of_file(model), path
        shown |= snippets_of(text)
    assert set(SECTIONS) | {"parameters", "damping", "gravity"} <= set(shown)
    page = reference_page(shown)
    assert shown["rods"] in page
    headings = {line.lstrip("# ") for line in page.splitlines() if line.startswith("#")}
    assert set(keys_of(Model)) <= headings
    classes = {part.__name__ for part in CLASSES}
    assert not {word for line in headings for word in line.split(" / ")} & classes


def test_every_link_of_the_reference_page_has_its_target() -> None:
    page = reference_page()
    links = set(re.findall(r"\]\(#([a-z0-9-]+)\)", page))
    targets = re.findall(r"^\(([a-z0-9-]+)\)=$", page, re.MULTILINE)
    assert links <= set(targets)
    assert len(targets) == len(set(targets))
