# SPDX-License-Identifier: Apache-2.0
"""REXS files that are written read back to the same contents, and to the same model."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import jsonschema
import numpy as np
import pytest

from pitchpoint.io.rexs import tables
from pitchpoint.io.rexs.comparison.differences import differences
from pitchpoint.io.rexs.document import RexsModel
from pitchpoint.io.rexs.exporting.exporting import export_rexs
from pitchpoint.io.rexs.importing import import_rexs
from pitchpoint.io.rexs.reading import read_rexs
from pitchpoint.io.rexs.writing.text import rexs_bytes
from pitchpoint.io.yaml_model import loads_model
from tests.support.rexs_files import GEARBOX
from tests.support.rexs_samples import needs_samples, sample, samples

INDUSTRIAL, PLANETARY = (
    "FVA-Industriegetriebe_2stufig_1-4.rexs",
    "FVA_Planetary_stage_-_Minus_gearing_1.1.rexs",
)
RIGID = {"radial": 1e11, "axial": 1e11, "tilt": 1e7}
"""Stiffness above which a support is rigid for the import."""


def _written(folder: Path, rexs: RexsModel, format: str = "xml") -> Path:
    path = folder / "written.rexs"
    path.write_bytes(rexs_bytes(rexs, format))
    return path


def _again(folder: Path, model, version: str = tables.NEWEST):
    """The model of the file that is written from a model."""
    return import_rexs(_written(folder, export_rexs(model, version).rexs)).model


def assert_equal(one, two):
    """Two models with the same geometry, masses, places, stiffness, loads and speeds."""
    assert one.gears.keys() == two.gears.keys()
    assert one.bodies.keys() == two.bodies.keys()
    for name, gear in one.gears.items():
        a, b = gear.geometry, two.gears[name].geometry
        for key in ("z", "m_n", "alpha_n", "beta", "x", "b", "d_a", "d_f", "rho_fP_star"):
            if hasattr(a, key):
                assert getattr(a, key) == pytest.approx(getattr(b, key), rel=1e-12, abs=1e-12), (name, key)
        assert vars(gear.mass_properties) == pytest.approx(vars(two.gears[name].mass_properties), rel=1e-9)
        assert gear.modifications == two.gears[name].modifications
    for name, body in one.bodies.items():
        other = two.bodies[name]
        assert body.origin == pytest.approx(other.origin, abs=1e-12), name
        assert (body.motion, body.gears) == (other.motion, pytest.approx(other.gears))
        a, b = one.body_inertia(name), two.body_inertia(name)
        for key in ("mass", "polar", "central", "center"):
            assert getattr(a, key) == pytest.approx(getattr(b, key), rel=1e-9, abs=1e-15), (name, key)
        if body.shaft is not None:
            assert body.shaft.sections == other.shaft.sections
    for name, pair in one.pairs.items():
        assert abs(pair.a_w) == pytest.approx(abs(two.pairs[name].a_w), rel=1e-12)
        assert one.backlash(name) == pytest.approx(two.backlash(name), rel=1e-9)
    assert one.bearings.keys() == two.bearings.keys()
    for name, bearing in one.bearings.items():
        other = two.bearings[name]
        assert (bearing.body, bearing.housing) == (other.body, other.housing)
        assert bearing.position == pytest.approx(other.position, abs=1e-12)
        for key, limit in RIGID.items():
            a, b = (getattr(x.stiffness, key) or 0.0 for x in (bearing, other))
            assert min(a, limit) == pytest.approx(b, rel=1e-12), (name, key)
    assert one.rolling_bearings == two.rolling_bearings
    assert one.couplings == two.couplings
    assert one.gravity == pytest.approx(two.gravity, abs=1e-15) if one.gravity else two.gravity is None
    assert one.loads == two.loads
    assert one.scenarios == two.scenarios


@pytest.mark.parametrize("format", ["xml", "json", "zip"])
@pytest.mark.parametrize("name", [INDUSTRIAL, PLANETARY, "FVA_worm_stage_1-4.rexs"])
def test_contents_are_read_back(name, format, tmp_path):
    model = read_rexs(sample(name))
    again = read_rexs(_written(tmp_path, model, format))
    assert differences(model, again, tolerance=1e-14) == []
    assert list(again.components) == list(model.components)
    assert (again.version, again.application) == (model.version, model.application)


@pytest.mark.parametrize("version", ["1.4", "1.6", "1.7", "2.0.0"])
def test_ids_and_units_are_those_of_the_version(version, tmp_path):
    """Young's modulus is in MPa since 2.0.0, before in N/mm^2; angles are in deg since 1.4."""
    path = tmp_path / "unit.rexs"
    path.write_text(GEARBOX, encoding="utf-8")
    written = _written(tmp_path, replace(read_rexs(path), version=version))
    unit = "MPa" if version == "2.0.0" else "N / mm^2"
    assert f'id="elastic_modulus" unit="{unit}">206000.0<' in written.read_text()
    assert differences(read_rexs(path), read_rexs(written)) == []


@pytest.mark.parametrize("name", [INDUSTRIAL, PLANETARY])
def test_samples_are_the_same_model_after_writing(name, tmp_path):
    model = import_rexs(sample(name)).model
    once = _again(tmp_path, model)
    assert_equal(model, once)
    assert_equal(once, _again(tmp_path, once))


@pytest.mark.parametrize("version", ["1.4", "1.7", "2.0.0"])
def test_a_gear_unit_is_the_same_model_after_writing(version, tmp_path):
    path = tmp_path / "unit.rexs"
    path.write_text(GEARBOX, encoding="utf-8")
    model = import_rexs(path).model
    assert_equal(model, _again(tmp_path, model, version))


MACHINE = """
gears:
  a: {number_of_teeth: 20, normal_module: 2 mm, face_width: 20 mm, helix_angle: 15 deg, hand: left,
      profile_shift_coefficient: 0.1,
      modifications: {both: {tip_relief: {amount: 12 um, start_diameter: 43 mm, shape: parabolic},
                             lead_crowning: 4 um, profile_crowning: 3 um}}}
  b: {type: internal, number_of_teeth: 61, normal_module: 2 mm, face_width: 18 mm, helix_angle: 15 deg,
      hand: left, profile_shift_coefficient: -0.1, bore_diameter: 160 mm, cutter: {number_of_teeth: 18}}
bodies:
  drum: {mass: 3 kg, inertia: 0.006 kg m^2, transverse_inertia: 0.005 kg m^2, motion: free}
shafts:
  one: {sections: [{length: 60 mm, diameter: 25 mm, bore: 8 mm}], gears: {a: 20 mm}, position: [0, 0, 0]}
  two: {sections: [{length: 60 mm, diameter: 30 mm}], gears: {b: 20 mm}}
meshes:
  m: {gears: [a, b], backlash: {circumferential: 0.1 mm}, damping: {ratio: 0.05}}
bearings:
  p: {body: one, position: [0, 0, 5 mm], stiffness: {radial: 2e8 N/m, axial: 1e8 N/m}}
  q: {body: one, position: [0, 0, 55 mm], stiffness: {radial: 3e8 N/m, tilt: 1e4 N m/rad}}
  r: {body: two, position: [0, 0, 30 mm], stiffness: {radial: 4e8 N/m, axial: 5e7 N/m, tilt: 2e5 N m/rad}}
rolling_bearings:
  s: {body: one, position: [0, 0, 40 mm], type: ball, elements: 9, element_diameter: 6 mm,
      pitch_diameter: 32 mm, grooves: [0.52, 0.53], clearance: 5 um, damping: 2}
couplings:
  c: {bodies: [two, drum], position: [0, 0, 60 mm],
      stiffness: {radial: 1e7 N/m, axial: 1e6 N/m, torsion: 1e4 N m/rad}}
loads:
  motor: {body: one, torque: 30 N m, force: [10 N, 20 N, 30 N], position: [0, 0, 2 mm]}
  hub: {body: two, moment: [0 N m, 3 N m, -4 N m], position: [0, 0, 3 mm]}
  rest: {body: two, torque: balance}
scenarios:
  steady: {speed: {one: 900 rpm}, duration: 10 ms}
"""


def test_parts_of_all_kinds_are_written_with_schema_names(tmp_path):
    """Every value is one that the schema has for its type of component; so is every role."""
    model = loads_model(MACHINE)
    rexs = export_rexs(model).rexs
    for component in rexs.components.values():
        for name, value in component.attributes.items():
            if value.number is not None:
                known = tables.definition(tables.NEWEST, name, component.type)
                assert known is not None and component.type in known.components, (component, name)
    again = import_rexs(_written(tmp_path, rexs)).model
    for name, gear in model.gears.items():
        assert again.gears[name].hand == gear.hand
        assert again.gears[name].bore_diameter == pytest.approx(gear.bore_diameter)
    assert again.gears["a"].modifications == model.gears["a"].modifications
    drum = [again.body_inertia("drum"), model.body_inertia("drum")]
    for key in ("mass", "polar", "central", "center"):
        assert getattr(drum[0], key) == pytest.approx(getattr(drum[1], key))
    assert again.bodies["drum"].shaft is None  # still rigid
    force = [law.value for law in again.loads["motor"].force]
    assert force == pytest.approx([10.0, 20.0, 30.0])
    hub = again.loads["hub"]
    assert hub.torque.value == pytest.approx(-4.0)  # the axial moment is a torque
    assert [law.value for law in hub.moment] == pytest.approx([0.0, 3.0, 0.0])
    ball = again.rolling_bearings["s"]
    assert (ball.elements, ball.pitch_diameter, ball.clearance) == (9, 0.032, 5e-6)
    assert again.couplings["c"].stiffness.torsion == 1e4


@pytest.mark.parametrize("kind", ["tip_relief", "root_relief"])
def test_a_relief_by_its_roll_length_starts_at_the_same_place(kind, tmp_path):
    """The removed material is the same at all points of the flank."""
    from pitchpoint.geometry.modifications import deviation, flank_range

    start = "tip_relief: {amount: 12 um, start_diameter: 43 mm, shape: parabolic}"
    model = loads_model(MACHINE.replace(start, f"{kind}: {{amount: 12 um, length: 2 mm}}"))
    again = _again(tmp_path, model)
    gears = [one.gears["a"] for one in (model, again)]
    roll = np.linspace(*flank_range(gears[0].geometry), 21)
    material = [deviation(g.modifications.side("left").of_geometry(), g.geometry, roll) for g in gears]
    np.testing.assert_allclose(material[0], material[1], atol=1e-15)
    assert np.ptp(material[0]) > 10e-6


def test_what_is_not_in_the_file_is_listed():
    text = MACHINE + "torsion_springs: {t: {bodies: [one], stiffness: 10 N m/rad}}\n"
    listed = {str(one) for one in export_rexs(loads_model(text)).omissions}
    assert "meshes.m.damping: REXS has no damping" in listed
    assert "torsion_springs: not written: t" in listed
    assert not any(line.startswith("bodies.drum") for line in listed)


@pytest.mark.parametrize(
    ("given", "motion"),
    [
        ("mass: 3 kg, inertia: 0.02 kg m^2, transverse_inertia: 0.015 kg m^2, center_of_mass: 12 mm", "free"),
        ("mass: 3 kg, inertia: 0.02 kg m^2", "planar"),
        ("inertia: 0.02 kg m^2", "torsion"),
    ],
)
def test_rigid_bodies_keep_their_mass_and_motion(given, motion, tmp_path):
    text = MACHINE.replace(MACHINE[MACHINE.index("{mass: 3 kg") : MACHINE.index("\nshafts:")], "{%s}")
    text = text.replace("stiffness: {radial: 1e7 N/m, axial: 1e6 N/m, torsion", "stiffness: {torsion")
    model = loads_model(text % f"{given}, motion: {motion}")
    again = _again(tmp_path, model)
    assert again.bodies["drum"].motion == motion
    one, two = (m.body_inertia("drum") for m in (model, again))
    for key in ("mass", "polar", "central", "center"):
        assert getattr(one, key) == pytest.approx(getattr(two, key)), key


@needs_samples
def test_json_files_agree_with_the_published_schema():
    """The schema is that of the versions before 2.0.0, with two numbers in the version."""
    schema = json.loads((samples().parent / "spec" / "rexs-file.json").read_text(encoding="utf-8"))
    rexs = export_rexs(loads_model(MACHINE), "1.7").rexs
    jsonschema.validate(json.loads(rexs_bytes(rexs, "json")), schema)


def test_a_shaft_of_any_direction_keeps_its_place(tmp_path):
    axes = "axes: {z: [0, 0.6, 0.8], x: [1, 0, 0]}, position: [10 mm, 20 mm, 30 mm]"
    text = MACHINE.replace("position: [0, 0, 0]}\n  two", f"{axes}}}\n  two")
    model = loads_model(text)
    again = _again(tmp_path, model)
    from pitchpoint.model.frames import frame

    for name in ("one", "two"):
        a, b = model.bodies[name], again.bodies[name]
        assert a.origin == pytest.approx(b.origin, abs=1e-12)
        np.testing.assert_allclose(frame(a.orientation)[:, 2], frame(b.orientation)[:, 2], atol=1e-12)


def test_planets_are_on_their_carrier():
    """Bearings of planets are between planet and carrier, although the planet is next to its axis."""
    model = import_rexs(sample(PLANETARY)).model
    rexs = export_rexs(model).rexs
    ids = {c.name: c.id for c in rexs.components.values() if c.type in ("shaft", "concept_bearing")}
    for k in (1, 2, 3):
        (side,) = rexs.related("side", assembly=ids[f"planet_{k}-bearing"])
        assert side.roles["inner_part"] == ids[f"planet_{k}"]
        assert side.roles["outer_part"] == ids["zweiwangiger_planetentraeger_3 shaft"]


def test_a_housing_next_to_the_axis_is_the_casing(tmp_path):
    text = MACHINE.replace(
        "  q: {body: one, position: [0, 0, 55 mm],",
        "  q: {body: one, position: [0, 0, 55 mm], housing: case.q,",
    )
    place = "position: [0, 30 mm, 0], markers: {q: {position: [0, -30 mm, 55 mm]}}"
    body = f"bodies:\n  case: {{motion: fixed, {place}}}\n"
    exported = export_rexs(loads_model(text.replace("bodies:\n", body)))
    assert "bearings.q.housing: case is the casing in the file: the bearing is not on its axis" in map(
        str, exported.omissions
    )
    again = import_rexs(_written(tmp_path, exported.rexs)).model
    assert again.bearings["q"].housing is None
    assert again.bearings["q"].position == pytest.approx((0.0, 0.0, 0.055))
