# SPDX-License-Identifier: Apache-2.0
"""Bad REXS files: cut, hostile, contradictory, with unknown units; place, value, limit and remedy of each."""

from __future__ import annotations

import json
import time
import zipfile

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.rexs.importing import import_rexs
from tests.support.rexs_files import GEARBOX, as_json, rexs, unit

HEAD = '<?xml version="1.0"?>\n'
BOMB = '<!DOCTYPE model [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;">]>\n<model version="1.4">&b;</model>'
OUTSIDE = '<!DOCTYPE model [<!ENTITY x SYSTEM "file:///etc/passwd">]>\n<model version="1.4">&x;</model>'
FIRST = '<component id="5" type="shaft_section"'


def refusal(tmp_path, text, name="unit.rexs"):
    path = tmp_path / name
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    with pytest.raises(ModelError) as caught:
        import_rexs(path)
    assert str(caught.value).startswith(f"{path}: ")
    return str(caught.value)


def swapped(old, new):
    assert old in GEARBOX
    return GEARBOX.replace(old, new, 1)


TEXTS = {
    "empty": ("", "is empty"),
    "a model file": ("gears:\n  a: {}\n", "is not a REXS file: neither XML nor JSON nor ZIP"),
    "no text": (b"\xff\xfe\x00\x01", "is not well-formed XML"),
    "cut": (GEARBOX[: len(GEARBOX) // 2], "the file is cut off: export or copy it again"),
    "cut JSON": (as_json(GEARBOX)[:4000], "is not JSON"),
    "other XML": ("<html><body/></html>", "<html> (line 1): is not a REXS file; expected: model"),
    "other JSON": ('{"a": 1}', "is not a REXS file: it has no object 'model'"),
    "other element": (
        swapped("<relations>", "<relation/><relations>"),
        "<model> cannot contain it; expected: relations",
    ),
    "entities": (HEAD + BOMB, "<!DOCTYPE> (line 2): is not permitted in REXS files"),
    "external entity": (HEAD + OUTSIDE, "<!DOCTYPE> (line 2): is not permitted in REXS files"),
    "deep XML": ("<model>" * 100_000, "<model> cannot contain it"),
    "deep JSON": ('{"model": ' + "[" * 200_000, "is nested too deeply"),
    "encoding": ('<?xml version="1.0" encoding="none-such"?><model version="1.4"/>', "unknown encoding"),
    "version": (
        swapped('version="1.4"', 'version="3.0"'),
        "model.version: '3.0' is not a version of REXS (limit 1.0, 1.1",
    ),
    "no version": (swapped(' version="1.4"', ""), "<model> (line 2): has no version"),
    "not a number": (
        swapped(">120<", ">12O<"),
        "length: '12O' is not a number (limit floating_point in REXS 1.4)",
    ),
    "infinite": (swapped(">120<", ">1e999<"), "'1e999' is larger than 1e+30"),
    "NaN": (swapped(">120<", ">nan<"), "'nan' is not a number"),
    "fraction": (swapped(">21<", ">21.5<"), "number_of_teeth: '21.5' is not a whole number"),
    "unknown unit": (
        swapped('"outer_diameter_begin" unit="mm"', '"outer_diameter_begin" unit="inch"'),
        "'inch' is not a unit of REXS",
    ),
    "wrong unit": (
        swapped('"face_width" unit="mm"', '"face_width" unit="kg"'),
        "face_width: 'kg' is the unit of another quantity (limit mm in REXS 1.4)",
    ),
    "twice": (swapped(FIRST, '<component id="4" type="shaft_section"'), "4 is the id of two components"),
    "relation": (
        swapped('<ref id="5" role="part"/>', '<ref id="99" role="part"/>'),
        "assembly 5 names the component 99, which does not exist",
    ),
    "id": (
        swapped('component id="6"', 'component id="six"'),
        "'six' is not the id of a component; ids are whole numbers",
    ),
    "role twice": (swapped('role="gear_2"', 'role="gear_1"'), "has the role 'gear_1' twice"),
    "case": (
        swapped('<load_case id="1">\n<component id="3"', '<load_case id="1">\n<component id="77"'),
        "names the component 77",
    ),
    "reference": (
        GEARBOX.replace('position" unit="none">1<', 'position" unit="none">55<'),
        "reference_component_for_position: names the component 55",
    ),
}


@pytest.mark.parametrize("name", TEXTS)
def test_files_that_cannot_be_read(name, tmp_path):
    text, words = TEXTS[name]
    began = time.perf_counter()
    assert words in refusal(tmp_path, text)
    assert time.perf_counter() - began < 5.0


def test_zip_archives(tmp_path):
    path = tmp_path / "unit.rexsz"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("a.rexs", GEARBOX)
        archive.writestr("b.rexsj", as_json(GEARBOX))
    whole = path.read_bytes()
    assert "is a ZIP archive with several models; it contains a.rexs, b.rexsj" in refusal(
        tmp_path, whole, "two.rexsz"
    )
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("a.rexs", GEARBOX)
    whole = path.read_bytes()
    assert "is a damaged ZIP archive" in refusal(tmp_path, whole[: len(whole) // 2], "cut.rexsz")
    middle = whole[:60] + b"\x00" * 200 + whole[260:]
    assert "is a damaged ZIP archive" in refusal(tmp_path, middle, "damaged.rexsz")


def test_a_zip_bomb_is_refused_by_its_size(tmp_path, monkeypatch):
    """Blanks of twice the limit; the stated size decides before anything is unpacked."""
    monkeypatch.setattr("pitchpoint.io.rexs.container.MOST_BYTES", 2**20)
    path = tmp_path / "bomb.rexsz"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("a.rexs", b" " * 2**21)
    whole = path.read_bytes()
    assert len(whole) < 5000
    assert "a.rexs: 2 MiB is too large for a REXS file (limit 1 MiB)" in refusal(tmp_path, whole, "b.rexsz")
    monkeypatch.setattr("pitchpoint.io.rexs.container.MOST_BYTES", 1000)
    assert "is too large for a REXS file" in refusal(tmp_path, GEARBOX, "long.rexs")


def test_a_large_file_is_imported_in_linear_time(tmp_path):
    """5000 more components and relations."""
    parts, relations, cases = unit()
    for number in range(100, 5_100):
        parts[number] = "additional_mass", {"mass_of_component": 1, "length": 5}
        relations.append(("assembly", {"assembly": 3, "part": number}))
    path = tmp_path / "unit.rexs"
    path.write_text(rexs(parts, relations, cases))
    began = time.process_time()
    found = import_rexs(path)
    assert time.process_time() - began < 3.0
    masses = [item for item in found.of("ignored") if "additional" in item.component]
    assert len(masses) == 5000


def changed(tmp_path, change):
    """Refusal of a gear unit after a change of its parts and relations."""
    parts, relations, cases = unit()
    change(parts, relations)
    return refusal(tmp_path, rexs(parts, relations, cases))


def without(parts, number, key):
    kind, values = parts[number]
    parts[number] = kind, {k: v for k, v in values.items() if k != key}


def with_(parts, number, **values):
    parts[number] = parts[number][0], {**parts[number][1], **values}


UNITS = {
    "no teeth": (
        lambda p, r: without(p, 7, "number_of_teeth"),
        "cylindrical_gear 7 (cylindrical_gear 7), number_of_teeth: is missing; give number_of_teeth (none)",
    ),
    "gear on no shaft": (
        lambda p, r: r.remove(("assembly", {"assembly": 3, "part": 7})),
        "cylindrical_gear 7 (cylindrical_gear 7): is on no shaft",
    ),
    "gear beyond the end": (
        lambda p, r: with_(p, 7, u_coordinate_on_shaft=150),
        "150 mm is not a position on the shaft shaft_3 (limit 0 to 120 mm from its start)",
    ),
    "gap": (
        lambda p, r: (
            p.update({30: ("shaft_section", {**p[5][1], "u_coordinate_on_shaft": 130})}),
            r.append(("assembly", {"assembly": 3, "part": 30})),
        ),
        "130 mm leaves a gap after the section before, which ends at 120 mm",
    ),
    "radii": (
        lambda p, r: with_(p, 5, inner_diameter_begin=40, inner_diameter_end=40),
        "inner_diameter_begin: 40 mm is not smaller than the outer diameter (limit from 0, below 30 mm)",
    ),
    "distance": (
        lambda p, r: with_(p, 13, center_distance=69),
        "69 mm differs from the distance of the axes of the shafts (limit 69.3 mm by support_vector)",
    ),
    "flanks": (
        lambda p, r: with_(p, 10, normal_pressure_angle=25),
        "differs from that of the left flank of cylindrical_gear 7",
    ),
    "bearing": (
        lambda p, r: with_(p, 17, catalogue_designation="none-such 7"),
        "'none-such 7', which is not in the catalogue, has no data of a rolling bearing; give a designation",
    ),
    "bearing type": (
        lambda p, r: with_(p, 17, catalogue_designation="x", bearing_type="crossed_roller_bearing"),
        "is a crossed_roller_bearing, which a model does not have",
    ),
    "bearing on nothing": (
        lambda p, r: r.remove(("side", {"assembly": 17, "inner_part": 3, "outer_part": 2})),
        "connects no two parts",
    ),
    "gear": (
        lambda p, r: (
            with_(p, 1, gear_shift_index=3),
            p.update({30: ("switchable_coupling", {"is_engaged": [True]})}),
            r.append(("side", {"assembly": 30, "inner_part": 3, "outer_part": 2})),
        ),
        "3 is the gear_shift_index of the gear unit (limit 1 to 1, the number of its states)",
    ),
    "axes": (
        lambda p, r: with_(p, 4, u_axis_vector=[0, 1, 0]),
        "has an axis that is not parallel to that of its mate",
    ),
    "skew": (
        lambda p, r: with_(p, 4, w_axis_vector=[1, 0, 1]),
        "w_axis_vector: 45 deg is not normal to u_axis_vector (limit 90 deg)",
    ),
    "zero axis": (lambda p, r: with_(p, 4, u_axis_vector=[0, 0, 0]), "is a direction of zero length"),
    "no position": (
        lambda p, r: without(p, 4, "support_vector"),
        "has no position; give support_vector and axes",
    ),
    "circle": (
        lambda p, r: (
            with_(p, 3, reference_component_for_position=4),
            with_(p, 4, reference_component_for_position=3),
        ),
        "leads back to the component itself",
    ),
    "stage": (lambda p, r: r.remove(("stage", {"stage": 13, "gear_1": 7, "gear_2": 8})), "has no two gears"),
    "hands": (
        lambda p, r: with_(p, 8, helix_angle_reference_diameter=12),
        "have hands that do not fit an external pair",
    ),
    "negative": (lambda p, r: with_(p, 5, length=-10), "length: is not above zero"),
}


@pytest.mark.parametrize("name", UNITS)
def test_gear_units_that_cannot_be_a_model(name, tmp_path):
    change, words = UNITS[name]
    found = changed(tmp_path, change)
    assert words in found
    assert "line " in found or "(limit" in found


def test_all_problems_at_once(tmp_path):
    found = changed(
        tmp_path, lambda p, r: (without(p, 7, "normal_module"), with_(p, 19, catalogue_designation="x"))
    )
    assert "2 problems" in found and "normal_module" in found and "'x'" in found


def test_json_places_are_paths(tmp_path):
    data = json.loads(as_json(GEARBOX))
    data["model"]["components"][4]["attributes"][1]["floating_point"] = "wide"
    assert "components[4].attributes[1] (length), shaft_section 5, length: 'wide' is not a number" in refusal(
        tmp_path, json.dumps(data)
    )
    data["model"]["components"][4]["attributes"][1] = {"id": "length", "number": 3}
    assert "components[4].attributes[1]: has the unknown key 'number'" in refusal(tmp_path, json.dumps(data))
