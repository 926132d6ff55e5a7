# SPDX-License-Identifier: Apache-2.0
"""Reading of REXS files: renamed ids, changed units, value types, containers, external files."""

from __future__ import annotations

import base64
import gzip
import json
import struct
import zipfile
from xml.etree import ElementTree

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.rexs import tables
from pitchpoint.io.rexs.reading import read_rexs, version_of
from pitchpoint.io.rexs.units import UNITS, unit_of
from tests.support.rexs_files import GEARBOX, as_json
from tests.support.rexs_samples import needs_samples, samples


def read(tmp_path, text, name="unit.rexs"):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return read_rexs(path)


def one(tmp_path, attributes, kind="cylindrical_gear", version="1.4"):
    """Component with some attributes in XML."""
    text = f'<model version="{version}"><components><component id="1" type="{kind}">{attributes}'
    return read(tmp_path, f"{text}</component></components></model>").components[1]


# --- the tables against the official files ------------------------------------------------------------------
@needs_samples
def test_tables_are_those_of_the_schemas_and_change_logs():
    """Every id of a schema is found with its number and unit; every renamed one has the new id of the log."""
    spec = samples().parent / "spec"
    for version in tables.VERSIONS:
        with gzip.open(spec / f"rexs_schema_{version}.xml.gz") as file:
            root = ElementTree.parse(file).getroot()
        units = {x.get("id"): x.get("name") for x in root.iter("unit")}
        numbers: dict[str, set[int]] = {}
        for x in root.iter("attribute"):
            numbers.setdefault(x.get("attributeId", ""), set()).add(int(x.get("numericId", 0)))
            known = tables.definition(version, x.get("attributeId", ""))
            assert known is not None
            joined = tables.newest(known.number).until == tables.NEWEST
            assert known.unit == units[x.get("unit")] and (known.number in numbers[known.id] or joined)
        assert set(numbers) == set(tables.ids_of(version))
        assert {units[x.get("unit")] for x in root.iter("attribute")} <= set(UNITS)
    renamed = 0
    for before, after in zip(tables.VERSIONS, tables.VERSIONS[1:], strict=False):
        with gzip.open(spec / f"rexs_changelog_{before}_to_{after}.xml.gz") as file:
            root = ElementTree.parse(file).getroot()
        for change in root.iter("attributeChange"):
            for value in change.iter("changedValue"):
                if value.get("key") != "attributeId":
                    continue
                number = int(change.get("numericId", 0))
                old, new = (
                    tables.definition(v, value.get(k, ""))
                    for v, k in ((before, "oldValue"), (after, "newValue"))
                )
                assert old is not None and new is not None
                assert number in (old.number, new.number) and new.number == number
                renamed += 1
    assert renamed > 100


@pytest.mark.parametrize(
    ("version", "kind", "old", "unit", "new", "number", "value"),
    [
        ("1.0", "cylindrical_gear", "number_of_teeth", "none", "number_of_teeth", 347, 17),
        ("1.0", "cutter_wheel_tool", "tip_radius", "mm", "tip_corner_radius_cutter", 3084, 0.017),
        ("1.0", "rack_shaped_tool", "tip_radius", "mm", "tip_corner_radius_reference_profile", 3062, 0.017),
        (
            "1.1",
            "rack_shaped_tool",
            "tip_radius_factor",
            "none",
            "tip_corner_radius_factor_reference_profile",
            3061,
            17.0,
        ),
        (
            "1.3",
            "cylindrical_gear_flank",
            "normal_pressure_angle",
            "°",
            "normal_pressure_angle",
            1015,
            0.29670597283903604,
        ),
        (
            "1.4",
            "cylindrical_gear_flank",
            "normal_pressure_angle",
            "deg",
            "normal_pressure_angle",
            1015,
            0.29670597283903604,
        ),
        ("2.0.0", "shaft", "rotational_speed", "1 / min", "rotational_speed", 9203, 17 * 0.10471975511965977),
        ("1.4", "material", "elastic_modulus", "N / mm^2", "elastic_modulus", 2898, 17e6),
    ],
)
def test_ids_and_units_of_old_versions(version, kind, old, unit, new, number, value, tmp_path):
    found = one(tmp_path, f'<attribute id="{old}" unit="{unit}">17</attribute>', kind, version).attributes[
        new
    ]
    assert (found.number, found.written_id, found.unit) == (number, old, unit)
    assert found.value == pytest.approx(value, rel=1e-15)


def test_a_length_in_another_unit_is_converted(tmp_path):
    found = one(tmp_path, '<attribute id="face_width" unit="mum">25000</attribute>')
    assert found.get("face_width") == 0.025


def test_corrected_units_keep_the_number(tmp_path):
    """REXS 1.3 has a flash temperature, a rise, in C; later versions in K."""
    changed = [
        (a, b)
        for a in tables.definitions()
        for b in [tables.newest(a.number)]
        if (a.unit, b.unit) == ("C", "K") and a.type == "floating_point"
    ]
    assert changed
    old, new = changed[0]
    kind = sorted(old.components)[0]
    found = one(tmp_path, f'<attribute id="{old.id}" unit="C">80</attribute>', kind, old.since)
    assert found.get(new.id) == 80.0


def test_units():
    assert unit_of("N  mm/rad").to_si(2.0) == 0.002
    assert unit_of("C").from_si(293.15) == 20.0
    assert unit_of("kg / dm^3").to_si(7.85) == 7850.0
    assert unit_of("").si == "1"


def test_versions():
    assert [version_of(v) for v in ("1.0", "2.0", "2.0.0", "1.8", "", "x")] == [
        "1.0",
        "2.0.0",
        "2.0.0",
        None,
        None,
        None,
    ]


# --- values -------------------------------------------------------------------------------------------------
def test_coded_arrays_and_matrices_have_their_columns_one_by_one(tmp_path):
    """Numbers 1 to 6 in base64: a matrix of two rows has 1 and 2 in its first column."""
    data = base64.b64encode(struct.pack("<6d", *range(1, 7))).decode()
    matrix = f'<matrix code="float64" rows="2" columns="3">{data}</matrix>'
    text = f'<attribute id="topographical_deviation_normals">{matrix}</attribute>'
    assert one(tmp_path, text, "gear_flank_data_set").get("topographical_deviation_normals") == (
        (1, 3, 5),
        (2, 4, 6),
    )
    data = base64.b64encode(struct.pack("<3f", 70, 0, -2)).decode()
    text = f'<attribute id="support_vector" unit="mm"><array code="float32">{data}</array></attribute>'
    assert one(tmp_path, text).get("support_vector") == (0.07, 0.0, -0.002)


def test_xml_and_json_and_zip_are_the_same(tmp_path):
    xml = read(tmp_path, GEARBOX)
    found = {"json": read(tmp_path, as_json(GEARBOX), "unit.rexsj")}
    found["mark"] = read(tmp_path, "\ufeff" + as_json(GEARBOX), "mark.rexsj")
    with zipfile.ZipFile(tmp_path / "unit.rexsz", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("model/unit.rexs", GEARBOX)
        archive.writestr("gear.gde", "")
    found["zip"] = read_rexs(tmp_path / "unit.rexsz")
    for other in found.values():
        assert [(c.type, c.name) for c in other.components.values()] == [
            (c.type, c.name) for c in xml.components.values()
        ]
        for mine, theirs in zip(xml.components.values(), other.components.values(), strict=True):
            assert {k: v.value for k, v in mine.attributes.items()} == {
                k: v.value for k, v in theirs.attributes.items()
            }
        assert [(r.type, r.roles) for r in other.relations] == [(r.type, r.roles) for r in xml.relations]
        cases = [
            [{k: v.value for k, v in c.items()} for c in case.components.values()]
            for case in other.load_spectra[0].cases
        ]
        assert cases[1][0] == {"rotational_speed": pytest.approx(-94.24777960769379)}


def test_json_reads_by_the_type_of_the_schema(tmp_path):
    """Integers and references under floating_point; false for a text is lost and named."""
    attributes = [
        {"id": "number_of_teeth", "floating_point": 17.0},
        {"id": "reference_component_for_position", "floating_point": 1.0},
        {"id": "part_number", "boolean": False},
    ]
    component = {"id": 1, "type": "cylindrical_gear", "attributes": attributes}
    found = read(tmp_path, json.dumps({"model": {"version": "1.5", "components": [component]}}))
    assert found.components[1].get("number_of_teeth") == 17
    assert found.components[1].get("reference_component_for_position") == 1
    assert found.components[1].get("part_number") is None
    assert "has false instead of 1 numbers, texts and vectors: part_number (1)" in found.remarks[0]


def test_unknown_and_own_attributes_are_kept_and_named(tmp_path):
    text = '<attribute id="face_with">3</attribute><attribute id="custom_thing">4</attribute>'
    text = f'<component id="1" type="shaft">{text}</component>'
    found = read(tmp_path, f'<model version="1.4"><components>{text}</components></model>')
    assert found.components[1].get("face_with") == "3"
    assert found.components[1].attributes["custom_thing"].number is None
    (remark,) = found.remarks
    assert remark == "line 1, shaft 1, face_with: is unknown in REXS 1.4; did you mean face_width?"


# --- external files -----------------------------------------------------------------------------------------
MAIN = """<model version="1.5"><components>
<component id="7" type="shaft"><attribute id="data_source">{0}</attribute>{1}
<attribute id="support_vector" unit="mm"><array><c>1</c><c>2</c><c>3</c></array></attribute></component>
</components></model>"""
OTHER = """<model version="1.1"><relations>
<relation id="1" type="assembly"><ref id="1" role="assembly"/><ref id="2" role="part"/></relation>
<relation id="2" type="reference"><ref id="1" role="origin"/><ref id="3" role="referenced"/></relation>
</relations><components>
<component id="1" type="shaft">
<attribute id="support_vector" unit="mm"><array><c>9</c><c>9</c><c>9</c></array></attribute>
<attribute id="mean_operating_temperature" unit="C">20</attribute></component>
<component id="2" type="shaft_section"><attribute id="length" unit="mm">10</attribute></component>
<component id="3" type="material"/><component id="4" type="material"/>
</components></model>"""
NUMBER = '<attribute id="referenced_component_id">{0}</attribute>'


def test_external_components_bring_their_parts(tmp_path):
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "shaft.rexs").write_text(OTHER)
    found = read(tmp_path, MAIN.format("sub\\shaft.rexs", NUMBER.format(1)))
    assert [c.type for c in found.components.values()] == ["shaft", "shaft_section", "material"]
    assert found.components[7].get("support_vector") == (
        0.001,
        0.002,
        0.003,
    )  # its own, not that of the database
    assert found.components[7].get("mean_operating_temperature") == 293.15
    assert [r.roles for r in found.relations] == [{"assembly": 7, "part": 8}, {"origin": 7, "referenced": 9}]
    assert found.components[8].file.endswith("shaft.rexs")


@pytest.mark.parametrize(
    ("source", "number", "words"),
    [
        ("none.txt", NUMBER.format(1), "'none.txt' does not exist; paths start at the folder of unit.rexs"),
        ("shaft.rex", NUMBER.format(1), "did you mean shaft.rexs?"),
        ("/etc/passwd", NUMBER.format(1), "is not a path relative to the model"),
        ("http://rexs.info/x", NUMBER.format(1), "is not a path relative to the model"),
        ("C:\\data\\x.rexs", NUMBER.format(1), "is not a path relative to the model"),
        ("shaft.rexs", "", "has no referenced_component_id"),
        ("shaft.rexs", NUMBER.format(8), "8 does not exist in shaft.rexs; shaft there: 1"),
        ("shaft.rexs", NUMBER.format(2), "2 is a shaft_section in shaft.rexs"),
        ("unit.rexs", NUMBER.format(7), "refers back to the model"),
        ("cut.rexs", NUMBER.format(1), "is not well-formed XML"),
    ],
)
def test_wrong_external_files_are_named(source, number, words, tmp_path):
    (tmp_path / "shaft.rexs").write_text(OTHER)
    (tmp_path / "cut.rexs").write_text(OTHER[:200])
    with pytest.raises(ModelError) as caught:
        read(tmp_path, MAIN.format(source, number))
    assert words in str(caught.value)
