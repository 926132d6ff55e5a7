# SPDX-License-Identifier: Apache-2.0
"""Differences between two gear units: none for another notation, and exactly the changes that were made."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest

from pitchpoint.io.rexs.comparison.differences import Difference, differences
from pitchpoint.io.rexs.comparison.matching import match
from pitchpoint.io.rexs.document import (
    RexsAttribute,
    RexsComponent,
    RexsLoadCase,
    RexsModel,
    RexsRelation,
)
from pitchpoint.io.rexs.reading import read_rexs
from tests.support.rexs_files import GEARBOX, as_json, rexs, unit
from tests.support.rexs_samples import sample

PLANETARY = "FVA_Planetary_stage_-_Minus_gearing_1.1"
TWINS = (
    ("FVA-Industriegetriebe_2stufig_1-4.rexs", "FVA-Industriegetriebe_2stufig_1-4.rexsj"),
    (f"{PLANETARY}.rexs", f"{PLANETARY}.rexsz"),
    ("example_xml.rexs.zip", "example_json.rexs.zip"),
)


@pytest.fixture
def gearbox(tmp_path) -> RexsModel:
    return _read(tmp_path, GEARBOX)


def _read(folder, text: str, name: str = "unit.rexs") -> RexsModel:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return read_rexs(path)


def _renumbered(model: RexsModel, seed: int = 3) -> RexsModel:
    """The same gear unit with other ids and names, in another order."""
    dice = random.Random(seed)
    ids = dict(zip(model.components, dice.sample(range(1000, 9000), len(model.components)), strict=True))

    def value(a: RexsAttribute) -> RexsAttribute:
        return replace(a, value=ids[a.value]) if a.id == "reference_component_for_position" else a

    parts = [
        replace(
            c,
            id=ids[c.id],
            name=f"part {ids[c.id]}",
            attributes={n: value(a) for n, a in c.attributes.items()},
        )
        for c in model.components.values()
    ]
    relations = [replace(r, roles={k: ids[i] for k, i in r.roles.items()}) for r in model.relations]
    dice.shuffle(parts)
    dice.shuffle(relations)
    spectra = tuple(
        replace(
            s,
            cases=tuple(
                RexsLoadCase(9 - c.id, {ids[i]: v for i, v in c.components.items()})
                for c in reversed(s.cases)
            ),
            accumulation={ids[i]: v for i, v in s.accumulation.items()},
        )
        for s in model.load_spectra
    )
    return replace(
        model, components={c.id: c for c in parts}, relations=tuple(relations), load_spectra=spectra
    )


def _changed(value: object) -> object:
    """Another value of the same type."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, float | int):
        return value * 1.25 + 1
    return tuple(_changed(v) for v in value) if isinstance(value, tuple) else f"{value}x"


@pytest.mark.parametrize("names", TWINS, ids=lambda names: names[0])
def test_formats_of_the_same_gear_unit_have_no_differences(names):
    assert differences(*(read_rexs(sample(name)) for name in names)) == []


def test_the_published_worm_stage_in_json_has_lost_references_and_two_values():
    """In the JSON file the references of positions have the id of the XML file, 1, which is another part."""
    found = differences(*(read_rexs(sample(f"FVA_worm_stage_1-4.{end}")) for end in ("rexs", "rexsj")))
    assert {d.attribute for d in found} == {
        "reference_component_for_position",
        "material_type_din_743_2012",
    }
    assert len(found) == 11


@pytest.mark.parametrize("name", [TWINS[0][0], TWINS[1][0]])
def test_other_ids_names_and_order_are_no_differences(name):
    model = read_rexs(sample(name))
    other = _renumbered(model)
    assert differences(model, other) == []


def test_other_formats_units_and_versions_are_no_differences(gearbox, tmp_path):
    assert differences(gearbox, _read(tmp_path, as_json(GEARBOX), "unit.rexsj")) == []
    assert differences(gearbox, _read(tmp_path, rexs(*unit(), version="1.6"))) == []
    metres = GEARBOX.replace(
        'id="center_distance" unit="mm">69.3', 'id="center_distance" unit="mum">69300.00001'
    )
    assert metres != GEARBOX
    assert differences(gearbox, _read(tmp_path, metres)) == []
    assert len(differences(gearbox, _read(tmp_path, metres), tolerance=0.0)) == 1
    bare = GEARBOX.replace('id="u_axis_vector" unit="mm"', 'id="u_axis_vector" unit="none"')
    assert differences(gearbox, _read(tmp_path, bare)) == []  # a direction of 1 instead of 1 mm


def test_every_changed_value_is_the_only_difference(gearbox):
    for component in gearbox.components.values():
        for name, attribute in component.attributes.items():
            if name == "reference_component_for_position":
                continue
            values = {**component.attributes, name: replace(attribute, value=_changed(attribute.value))}
            new = replace(component, attributes=values)
            other = replace(gearbox, components={**gearbox.components, component.id: new})
            (found,) = differences(gearbox, _renumbered(other))
            assert (found.kind, found.id_a, found.attribute) == ("changed", component.id, name)
            assert (found.si_a, found.si_b) == (attribute.value, _changed(attribute.value))


def test_every_removed_part_is_the_only_difference(gearbox):
    for id in gearbox.components:
        if id == 1:  # the reference of all positions
            continue
        parts = {i: c for i, c in gearbox.components.items() if i != id}
        relations = tuple(r for r in gearbox.relations if id not in r.roles.values())
        spectra = tuple(
            replace(
                s,
                cases=tuple(
                    replace(c, components={i: v for i, v in c.components.items() if i != id}) for c in s.cases
                ),
            )
            for s in gearbox.load_spectra
        )
        other = replace(gearbox, components=parts, relations=relations, load_spectra=spectra)
        assert [(d.kind, d.id_a) for d in differences(gearbox, other)] == [("removed", id)]
        assert [(d.kind, d.id_b) for d in differences(other, gearbox)] == [("added", id)]


def test_differences_are_in_words_and_in_the_units_of_the_file(gearbox, tmp_path):
    text = GEARBOX.replace('id="face_width" unit="mm">20', 'id="face_width" unit="mm">22')
    (found,) = differences(gearbox, _read(tmp_path, text))
    assert str(found) == (
        "pinion of cylindrical_stage 13 (cylindrical_stage 13): face width 20 mm -> 22 mm (+2 mm)"
    )
    (back,) = differences(_read(tmp_path, text), gearbox)
    assert back.difference == "-2 mm"
    text = GEARBOX.replace("<c>0</c><c>0</c><c>69.3</c>", "<c>0</c><c>0</c><c>70</c>")
    (found,) = differences(gearbox, _read(tmp_path, text))
    assert (found.a, found.b, found.difference) == (
        "[0, 0, 69.3] mm",
        "[0, 0, 70] mm",
        "1 of 3, largest +0.7 mm",
    )


def test_a_gear_on_another_shaft_is_moved(tmp_path):
    parts, relations, cases = unit()
    before = _read(tmp_path, rexs(parts, relations, cases))
    place = relations.index(("assembly", {"assembly": 3, "part": 7}))
    relations[place] = ("assembly", {"assembly": 4, "part": 7})
    (found,) = differences(before, _renumbered(_read(tmp_path, rexs(parts, relations, cases))))
    assert (found.kind, found.id_a, found.what, found.a) == ("moved", 7, "assembly", "shaft 3 (shaft 3)")
    assert found.b.startswith("shaft ")


def test_load_cases_are_paired_by_their_values(gearbox):
    (spectrum,) = gearbox.load_spectra
    first, second = spectrum.cases
    torque = first.components[14]["torque_around_u_axis"]
    more = RexsLoadCase(
        1, {**first.components, 14: {"torque_around_u_axis": replace(torque, value=torque.value + 4.0)}}
    )

    def with_cases(*cases: RexsLoadCase) -> RexsModel:
        return _renumbered(replace(gearbox, load_spectra=(replace(spectrum, cases=cases),)))

    (found,) = differences(gearbox, with_cases(second, more))
    assert (found.load_case, found.id_a, found.difference) == ("1", 14, "+4 N m")
    (found,) = differences(gearbox, with_cases(second))
    assert found == Difference("removed", "", load_case="1")


def test_parts_without_anything_in_common_are_not_the_same():
    """Another bearing at another place on another shaft; the same type alone is not enough."""
    one, two = (
        RexsComponent(
            1, "concept_bearing", attributes={n: RexsAttribute(n, None, f"{n} {k}") for n in "abcdefgh"}
        )
        for k in (1, 2)
    )
    parts = {2: RexsComponent(2, "shaft"), 3: RexsComponent(3, "gear_casing")}
    a = RexsModel("1.4", components={1: one, **parts}, relations=(_side(1, 2, 3),))
    b = RexsModel("1.4", components={1: two, **parts})
    assert match(a, b) == {2: 2, 3: 3}
    assert match(a, a) == {1: 1, 2: 2, 3: 3}


def _side(bearing: int, inner: int, outer: int) -> RexsRelation:
    return RexsRelation(1, "side", {"assembly": bearing, "inner_part": inner, "outer_part": outer})
