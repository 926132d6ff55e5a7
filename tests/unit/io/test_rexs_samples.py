# SPDX-License-Identifier: Apache-2.0
"""Every published REXS sample is imported, or refused with its reason."""

from __future__ import annotations

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.rexs.importing import import_rexs
from pitchpoint.io.rexs.reading import read_rexs
from pitchpoint.io.yaml_model import loads_model
from tests.support.rexs_samples import needs_samples, sample, samples

INDUSTRIAL = "FVA-Industriegetriebe_2stufig_1-4"
PLANETARY = "FVA_Planetary_stage_-_Minus_gearing_1.1"
LOSSY = f"{PLANETARY}_vers2.rexsj"
IMPORTED = (f"{INDUSTRIAL}.rexs", f"{INDUSTRIAL}.rexsj", f"{PLANETARY}.rexs", f"{PLANETARY}.rexsz", LOSSY)
NO_SHAFT = "has no shafts, so it is not a gear unit; export the whole gear unit"
NO_FILE = (
    "does not exist; did you mean database_{0}.rexsj? paths start at the folder of placeholder_model.rexsj"
)
LOST = "numbers, texts and vectors"
REFUSED = {
    "FVA_worm_stage_1-4.rexs": ["line 471, worm_stage 3 (Schneckenstufe [3]): cannot be imported"],
    "FVA_worm_stage_1-4.rexsj": ["worm_stage 15 (Schneckenstufe [3]): cannot be imported"],
    f"{PLANETARY}.rexsj": ["support_vector: has no position", f"has false instead of 152 {LOST}"],
    "example_json.rexs.zip": [NO_SHAFT],
    "example_xml.rexs.zip": [NO_SHAFT],
    "no_rexs_file.rexsz": ["is a ZIP archive without a REXS model; it contains gde_file.gde, klingelnberg"],
    "external_sources/example_1/database_bearing.rexs": [NO_SHAFT],
    "external_sources/example_5/database_bearing.rexs": [NO_SHAFT],
    "external_sources/example_8/database_bearing.rexsj": [NO_SHAFT],
    "external_sources/example_1/database_shaft.rexs": [
        "shaft 30 (Shaft [30]), support_vector: has no position"
    ],
    "external_sources/example_5/database_shaft.rexs": [
        "shaft 30 (Shaft [30]), support_vector: has no position"
    ],
    "external_sources/example_8/database_shaft.rexsj": [
        "shaft 1 (Shaft [30]), support_vector: has no position"
    ],
    "external_sources/example_8/placeholder_model.rexsj": [
        NO_FILE.format("shaft"),
        NO_FILE.format("bearing"),
    ],
}
EXTERNAL = (
    "external_sources/example_1/placeholder_model.rexs",
    "external_sources/example_5/placeholder_model.rexs",
)


@needs_samples
def test_every_sample_has_a_test():
    folder = samples()
    assert folder is not None
    files = {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}
    assert files == {*IMPORTED, *EXTERNAL, *REFUSED}


@pytest.mark.parametrize("name", [*IMPORTED, *EXTERNAL])
def test_samples_are_imported(name):
    """The text of the model file reads back to the same model."""
    found = import_rexs(sample(name))
    assert loads_model(found.text()) == found.model


@pytest.mark.parametrize("name", REFUSED)
def test_samples_are_refused_with_their_reason(name):
    path = sample(name)
    with pytest.raises(ModelError) as caught:
        import_rexs(path)
    for reason in REFUSED[name]:
        assert reason in str(caught.value)


def test_xml_json_and_zip_are_the_same_model():
    """The XML and JSON files of the industrial gearbox were exported separately; so were XML and ZIP."""
    one, two = (import_rexs(sample(f"{INDUSTRIAL}.{end}")).model for end in ("rexs", "rexsj"))
    assert {**vars(one), "title": ""}.keys() == vars(two).keys()
    assert (one.gears, one.shafts, one.meshes, one.loads) == (two.gears, two.shafts, two.meshes, two.loads)
    one, two = (import_rexs(sample(f"{PLANETARY}.{end}")).model for end in ("rexs", "rexsz"))
    assert (one.gears, one.planetary_stages) == (two.gears, two.planetary_stages)


def test_lost_values_are_named_and_replaced_by_listed_defaults():
    found = import_rexs(sample(LOSSY))
    (lost,) = [remark for remark in found.source.remarks if "has lost" in remark]
    assert "124 numbers" in lost and "axial_force_absorption (10)" in lost
    listed = [item for item in found.of("default") if item.attribute == "axial_force_absorption"]
    assert len(listed) == 10
    assert {item.value for item in listed} == {"both_directions"}


def test_external_files_bring_sections_materials_and_rows():
    found = read_rexs(sample(EXTERNAL[0]))
    shaft = found.components[3]
    parts = [found.components[r.roles["part"]] for r in found.related("assembly", assembly=3)]
    assert [p.type for p in parts] == ["shaft_section", "shaft_section"]
    assert shaft.get("support_vector") == (0.0, 0.0, 0.0)
    assert found.components[6].get("catalogue_designation") == "22206 E"
    assert (
        import_rexs(sample(EXTERNAL[0])).model.rolling_bearings["rolling_bearing_6"].designation == "22206 E"
    )
    (changed,) = import_rexs(sample(EXTERNAL[0])).of("changed")
    assert changed.reason == "a bearing of this type does not support negative"  # a spherical roller bearing
