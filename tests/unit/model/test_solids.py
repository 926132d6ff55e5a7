# SPDX-License-Identifier: Apache-2.0
"""Mass and inertia from solids in model files: who wins, which axes count, what is wrong with them."""

from __future__ import annotations

import importlib.util
import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.shaft_solid import shaft_solid
from pitchpoint.geometry.solid import gear_solid
from pitchpoint.io.yaml_model import dump_model, load_model
from pitchpoint.model.inertia import gear_by_geometry, gear_inertia
from pitchpoint.report.masses import masses
from pitchpoint.solvers.modal import solve_modal
from pitchpoint.system.compile import compile_model
from tests.support import stl
from tests.support.occ import needs_occ

A, B, C = 0.3, 0.2, 0.1
"""Sides of the box [m]."""
RHO = 2700.0

MODEL = """
title: solids
gears:
  pinion: {number_of_teeth: 17, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0, solid: {
    file: gear.stl, unit: 1 mm GEAR_SOLID}GEAR}
  wheel: {number_of_teeth: 40, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  low: {gears: [pinion]}
  high: {gears: [wheel]}
  box: {motion: free, position: [1 m, 0, 0], solid: {
    file: box.stl, unit: 1 mm, density: 2700 kg/m^3 BOX_SOLID}BOX}
meshes:
  stage: {gears: [pinion, wheel], center_distance: 57 mm, stiffness: {law: constant, value: 1e8 N/m}}
bushings:
  mount: {ends: [ground, box], stiffness: {radial: 1e6, axial: 2e6, tilt: 1e3, torsion: 2e3}}
"""


def box(shift=(0.0, 0.0, 0.0)):
    """Triangles [m] of the box with one corner at a place."""
    corners = np.array([[x * A, y * B, z * C] for z in (0, 1) for y in (0, 1) for x in (0, 1)]) + shift
    faces = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    quads = [[corners[k] for k in f] for f in faces]
    return np.array([t for q in quads for t in ([q[0], q[1], q[2]], [q[0], q[2], q[3]])])


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

    gear = CylindricalGear(z=17, m_n=2e-3, b=0.02)
    (tmp_path / "gear.stl").write_bytes(stl.binary(1e3 * gear_solid(gear, 20, bore_diameter=0.01)))
    (tmp_path / "box.stl").write_bytes(stl.binary(1e3 * box()))
    return tmp_path


def model_of(folder: Path, text: str = MODEL, **parts: str):
    for word in ("GEAR_SOLID", "BOX_SOLID", "GEAR", "BOX"):
        text = text.replace(word, parts.get(word, ""))
    (folder / "model.yaml").write_text(text)
    return load_model(folder / "model.yaml")


def frequencies(model) -> np.ndarray:
    return np.asarray(solve_modal(compile_model(model))["undamped_frequency"].values)


# --- gears --------------------------------------------------------------------------------------------------
def test_a_solid_takes_the_place_of_the_geometry_of_a_gear(folder: Path) -> None:
    """The solid has a bore that the file does not tell of: it is what counts."""
    model = model_of(folder)
    bored = model.replace("gears.pinion.bore_diameter", 0.01)
    found, exact = gear_inertia(model.gears["pinion"]), gear_by_geometry(bored.gears["pinion"])
    assert found == pytest.approx(exact, rel=1e-3)  # facets of 20 points a flank
    assert model.body_inertia("low").mass == found[0]
    assert found[0] < 0.95 * gear_by_geometry(model.gears["pinion"])[0]


def test_given_values_win_each_for_itself(folder: Path) -> None:
    plain = gear_inertia(model_of(folder).gears["pinion"])
    found = gear_inertia(model_of(folder, GEAR=", polar_inertia: 1 kg m^2").gears["pinion"])
    assert found == (plain[0], 1.0, plain[2])


@pytest.mark.parametrize(
    "more, density",
    [("", 7830.0), (", material: aluminium", None), (", density: 1 g/cm^3", 1000.0)],
)
def test_the_density_is_that_of_the_solid_or_else_of_the_gear(folder: Path, more: str, density) -> None:
    from pitchpoint.geometry.materials import LIBRARY

    name = next((n for n in LIBRARY if "alumin" in n), next(iter(LIBRARY)))
    more = more.replace("aluminium", name)
    model = model_of(folder, GEAR_SOLID=more)
    solid = model.gears["pinion"].solid
    expected = LIBRARY[name].density if density is None else density
    assert gear_inertia(model.gears["pinion"])[0] == pytest.approx(expected * solid.solid().volume, rel=1e-12)


def test_a_gear_drawn_lying_gives_the_same(folder: Path) -> None:
    upright = gear_inertia(model_of(folder).gears["pinion"])
    from pitchpoint.geometry.triangle_file import read_triangles

    triangles = read_triangles(folder / "gear.stl").corners
    (folder / "gear.stl").write_bytes(
        stl.binary(np.roll(triangles, 1, axis=2) + np.array([50.0, 20.0, -30.0]))
    )
    lying = model_of(folder)
    assert gear_inertia(lying.gears["pinion"]) == pytest.approx(upright, rel=1e-5)  # seven digits of STL
    assert lying.gears["pinion"].solid.about_axis().axis == pytest.approx((1.0, 0.0, 0.0), abs=1e-5)
    told = model_of(folder, GEAR_SOLID=", axes: {z: [1, 0, 0]}")
    assert gear_inertia(told.gears["pinion"]) == pytest.approx(upright, rel=1e-5)


# --- bodies -------------------------------------------------------------------------------------------------
def test_a_body_takes_mass_place_and_tensor(folder: Path) -> None:
    found = model_of(folder).body_inertia("box")
    mass = RHO * A * B * C
    assert found.mass == pytest.approx(mass, rel=1e-6)
    assert found.place == pytest.approx((A / 2, B / 2, C / 2), rel=1e-6)
    expected = mass / 12.0 * np.diag([B * B + C * C, C * C + A * A, A * A + B * B])
    assert found.about_center() == pytest.approx(expected, rel=1e-6, abs=1e-6 * expected.max())


def test_axes_and_origin_place_the_solid_in_the_body(folder: Path) -> None:
    """z of the body along x of the file, x along y; the origin in the middle of a face."""
    found = model_of(
        folder, BOX_SOLID=", axes: {z: [1, 0, 0], x: [0, 1, 0]}, origin: [0, 100 mm, 50 mm]"
    ).body_inertia("box")
    assert found.place == pytest.approx((0.0, 0.0, A / 2), abs=1e-9)
    expected = found.mass / 12.0 * np.diag([C * C + A * A, A * A + B * B, B * B + C * C])
    assert found.about_center() == pytest.approx(expected, rel=1e-6, abs=1e-6 * expected.max())


@pytest.mark.parametrize("turn", ["", ", axes: {z: [1, 2, 2]}, origin: [10 mm, 20 mm, 30 mm]"])
def test_the_machine_moves_as_with_the_same_numbers_given(folder: Path, turn: str) -> None:
    model = model_of(folder, BOX_SOLID=turn)
    own = model.body_inertia("box")
    center = ", ".join(repr(v) for v in own.place)
    i = own.about_center()
    tensor = [float(i[a, b]) for a, b in ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))]
    given = MODEL.replace(
        "solid: {\n    file: box.stl, unit: 1 mm, density: 2700 kg/m^3 BOX_SOLID}",
        f"mass: {own.mass!r}, center_of_mass: [{center}], inertia_tensor: {tensor}",
    )
    other = model_of(folder, given)
    assert other.bodies["box"].solid is None
    np.testing.assert_allclose(frequencies(model), frequencies(other), rtol=1e-9, atol=1e-3)


@pytest.mark.parametrize(
    "more, name, value",
    [
        (", mass: 5 kg", "mass", 5.0),
        (", center_of_mass: [1 mm, 2 mm, 3 mm]", "place", (0.001, 0.002, 0.003)),
        (", center_of_mass: 3 mm", "place", (0.0, 0.0, 0.003)),
        (", inertia_tensor: [1, 2, 2.5, 0, 0, 0.1]", "tensor", (1.0, 2.0, 2.5, 0.0, 0.0, 0.1)),
    ],
)
def test_given_values_of_a_body_win_and_leave_the_others(folder: Path, more: str, name: str, value) -> None:
    plain, found = (model_of(folder, BOX=m).body_inertia("box") for m in ("", more))
    assert getattr(found, name) == value
    for other in {"mass", "place", "tensor"} - {name}:
        assert getattr(found, other) == getattr(plain, other)


ROTOR = """
bodies:
  rotor: {motion: free, position: [0, 0, 0], solid: {file: rod.stl, unit: 1 m, density: 7800 SOLID}BODY}
bushings:
  mount: {ends: [ground, rotor], stiffness: {radial: 1e6, axial: 1e6, tilt: 1e3, torsion: 1e2}}
"""


def rotor(folder: Path, axis: int, more: str = "", body: str = ""):
    triangles = np.roll(shaft_solid([(0.2, 0.04, 0.0)], 24), axis + 1, axis=2)
    (folder / "rod.stl").write_bytes(stl.binary(triangles))
    text = ROTOR.replace("SOLID", more).replace("BODY", body)
    (folder / "rotor.yaml").write_text(text)
    return load_model(folder / "rotor.yaml")


def test_a_solid_round_about_z_is_a_round_body(folder: Path) -> None:
    model = rotor(folder, 2)
    assert model.bodies["rotor"].is_round
    found = model.body_inertia("rotor")
    assert found.tensor is None
    assert found.off_axis == (0.0, 0.0)
    assert found.center == pytest.approx(0.1, rel=1e-6)
    # a polygon of 24 corners: 2 % less moment than the circle
    assert found.polar == pytest.approx(0.5 * found.mass * 0.02**2, rel=0.03)
    assert compile_model(model).bodies[0].is_round
    replaced = rotor(folder, 2, body=", inertia: 1 kg m^2").body_inertia("rotor")
    assert (replaced.polar, replaced.central) == (1.0, found.central)


def test_a_rod_drawn_along_x_is_no_round_body_until_it_is_turned(folder: Path) -> None:
    assert not rotor(folder, 0).bodies["rotor"].is_round
    turned = rotor(folder, 0, ", axes: {z: [1, 0, 0]}")
    assert turned.bodies["rotor"].is_round
    assert turned.body_inertia("rotor").polar == pytest.approx(rotor(folder, 2).body_inertia("rotor").polar)
    with pytest.raises(ModelError, match=r"bodies.rotor.inertia .*cannot be combined with a solid that"):
        rotor(folder, 0, body=", inertia: 1 kg m^2")


# --- shafts -------------------------------------------------------------------------------------------------
SHAFT = """
shafts:
  s:
    sections: [{length: 100 mm, diameter: 40 mm}, {length: 100 mm, diameter: 50 mm, bore: 20 mm}]
    position: [0, 0, 0]SOLID
bearings:
  left: {body: s, position: [0, 0, 0], stiffness: {radial: 1e8, axial: 1e8, torsion: 1e4}}
  right: {body: s, position: [0, 0, 200 mm], stiffness: {radial: 1e8}}
"""


def shaft_model(folder: Path, solid: str = ""):
    exact = [(0.1, 0.04, 0.0), (0.1, 0.05, 0.02)]
    (folder / "shaft.stl").write_bytes(stl.binary(1e3 * shaft_solid(exact, 60)))
    (folder / "shaft.yaml").write_text(SHAFT.replace("SOLID", solid))
    return load_model(folder / "shaft.yaml")


def test_a_shaft_has_the_mass_of_its_solid_spread_over_its_sections(folder: Path) -> None:
    plain = shaft_model(folder)
    model = shaft_model(folder, "\n    solid: {file: shaft.stl, unit: 1 mm, density: 3000 kg/m^3}")
    share = 3000.0 / 7830.0 * 30.0 / math.pi * math.sin(math.pi / 30.0)  # what a polygon of 60 corners lacks
    assert model.body_inertia("s").mass / plain.body_inertia("s").mass == pytest.approx(share, rel=1e-6)
    assert model.body_inertia("s").polar / plain.body_inertia("s").polar == pytest.approx(share, rel=1e-6)
    # stations and stiffness stay, so that all elastic frequencies follow the root of the masses
    free = [m.replace_all({"bearings.left": None, "bearings.right": None}) for m in (plain, model)]
    low, high = (frequencies(m) for m in free)
    elastic = low > 100.0
    assert elastic.sum() >= 6
    np.testing.assert_allclose(high[elastic] / low[elastic], 1.0 / math.sqrt(share), rtol=1e-6)


# --- files --------------------------------------------------------------------------------------------------
def test_a_model_with_solids_is_written_and_read_again(folder: Path) -> None:
    model = model_of(folder, BOX_SOLID=", axes: {z: [1, 2, 2]}, origin: [10 mm, 0, 0]")
    text = dump_model(model)
    assert "file: gear.stl" in text
    (folder / "again.yaml").write_text(text)
    again = load_model(folder / "again.yaml")
    assert again.gears == model.gears
    assert again.body_inertia("box") == model.body_inertia("box")


def test_values_of_a_solid_can_be_replaced(folder: Path) -> None:
    model = model_of(folder)
    light = model.replace("bodies.box.solid.density", 1350.0)
    assert light.body_inertia("box").mass == pytest.approx(0.5 * model.body_inertia("box").mass, rel=1e-12)
    bare = model.replace("gears.pinion.solid", None)
    assert gear_inertia(bare.gears["pinion"]) == gear_by_geometry(bare.gears["pinion"])


@pytest.mark.parametrize(
    "parts, said",
    [
        (
            {"GEAR_SOLID": ", part: shaft"},
            r"gears.pinion.solid.part \(line 5\): 'shaft' is not a solid of the file",
        ),
        (
            {"GEAR_SOLID": ", density: 1 g/cm^3, material: steel"},
            "solid.density .line 5.: cannot be combined with material",
        ),
        (
            {"GEAR_SOLID": ", origin: [0, 0, 0]"},
            "solid.origin .line 5.: is for solids of bodies only: the position of a gear",
        ),
        ({"GEAR_SOLID": ", axes: {z: [0, 0, 0]}"}, "solid.axes.z .line 5.: is not a direction"),
        (
            {"GEAR_SOLID": ", axes: {z: [0, 1, 1]}"},
            "a solid with principal moments .* is not round about an axis",
        ),
        ({"GEAR_SOLID": ", color: red"}, "solid.color .line 5.:"),
        (
            {"BOX_SOLID": ", axes: {z: [0, 0, 1], x: [1, 0, 1]}"},
            "solid.axes.x .line 11.: 45 deg is not perpendicular",
        ),
        (
            {"BOX": ", inertia: 1 kg m^2"},
            "bodies.box.inertia .line 11.: cannot be combined with a solid that is not axisymmetric",
        ),
    ],
)
def test_what_is_wrong_with_a_solid_is_told_with_its_line(folder: Path, parts: dict, said: str) -> None:
    with pytest.raises(ModelError, match=said) as caught:
        model_of(folder, **parts)
    assert len(caught.value.problems) == 1


@pytest.mark.parametrize(
    "old, new, said",
    [
        (
            "file: gear.stl",
            "file: none.stl",
            "solid.file .line 5.: 'none.stl' names a file that does not exist",
        ),
        ("gear.stl, unit: 1 mm", "gear.stl", "solid.unit .line 4.: is missing: an STL file does not contain"),
        ("gear.stl, unit: 1 mm", "gear.stl, unit: 1 km", "is an unlikely size"),
        ("file: gear.stl", "file: box.stl", "is not round about an axis"),
        ("file: gear.stl", "file: model.yaml", "'model.yaml' is not a supported file type"),
        ("file: box.stl", "file: open.stl", "3 edges belong to one triangle only"),
        ("file: box.stl", "file: cut.stl", "is not a whole STL file"),
    ],
)
def test_what_is_wrong_with_a_file_is_told_alone(folder: Path, old: str, new: str, said: str) -> None:
    data = stl.binary(1e3 * box())
    (folder / "cut.stl").write_bytes(data[:-100])
    (folder / "open.stl").write_bytes(stl.binary(1e3 * box()[1:]))
    (folder / "model.yaml").touch()
    with pytest.raises(ModelError, match=said) as caught:
        model_of(folder, MODEL.replace(old, new))
    assert len(caught.value.problems) == 1


def test_without_occ_a_model_with_step_says_which_extra(folder: Path, monkeypatch) -> None:
    (folder / "gear.step").write_text("ISO-10303-21;\nENDSEC;\nEND-ISO-10303-21;\n")
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    with pytest.raises(
        ModelError, match=r"solid.file .line 5.: cannot be read.*pip install 'pitchpoint.cad.'"
    ):
        model_of(folder, MODEL.replace("gear.stl, unit: 1 mm", "gear.step"))


@needs_occ
def test_a_gear_from_its_own_step_file_has_its_own_mass(folder: Path) -> None:
    from pitchpoint.io.gear_export import export_gear

    text = MODEL.replace("gear.stl, unit: 1 mm", "gear.step")
    export_gear(model_of(folder).gears["pinion"].geometry, folder / "gear.step")
    model = model_of(folder, text)
    entry = masses(model)[0]
    # faces within 1e-6 modules of the teeth
    assert max(abs(d) for d in entry["differences"]["geometry"].values()) < 5e-8
    assert entry["unit"] == "millimetre"


# --- side by side -------------------------------------------------------------------------------------------
def test_every_way_to_know_a_mass_stands_beside_the_others(folder: Path) -> None:
    model = model_of(folder, GEAR=", mass: 100 g", BOX=", center_of_mass: 1 mm")
    pinion, wheel, low, high, block = masses(model)
    assert [e["name"] for e in (pinion, wheel, low, high, block)] == ["pinion", "wheel", "low", "high", "box"]
    assert list(pinion["sources"]) == ["geometry", "solid", "given", "effective"]
    assert pinion["sources"]["given"] == {"mass": 0.1, "polar_inertia": None, "transverse_inertia": None}
    assert pinion["sources"]["effective"]["mass"] == 0.1
    solid = pinion["sources"]["solid"]["mass"]
    assert pinion["differences"]["solid"]["mass"] == pytest.approx(solid / 0.1 - 1.0, rel=1e-12)
    assert pinion["differences"]["solid"]["polar_inertia"] == 0.0
    assert pinion["differences"]["given"]["polar_inertia"] is None
    assert list(wheel["sources"]) == ["geometry", "effective"]
    assert low["sources"]["gears"] == low["sources"]["effective"]
    assert block["sources"]["solid"]["center"] == pytest.approx((A / 2, B / 2, C / 2), rel=1e-6)
    assert block["sources"]["effective"]["center"] == (0.0, 0.0, 0.001)
    assert block["density"] == RHO


def test_inertia_of_a_body_off_its_axis_is_compared_about_its_centre_of_mass(folder: Path) -> None:
    block = masses(model_of(folder))[-1]
    mass = RHO * A * B * C
    for source in ("solid", "effective"):
        polar = block["sources"][source]["polar_inertia"]
        assert polar == pytest.approx(mass / 12.0 * (A * A + B * B), rel=1e-6)


def test_a_shaft_shows_what_its_sections_cannot_follow(folder: Path) -> None:
    model = shaft_model(folder, "\n    solid: {file: shaft.stl, unit: 1 mm}")
    (entry,) = masses(model)
    assert entry["differences"]["solid"]["mass"] == pytest.approx(0.0, abs=1e-12)
    n = 60
    polar = (2.0 + math.cos(2.0 * math.pi / n)) / 3.0  # of a polygon, per that of its mass as a circle
    assert entry["differences"]["solid"]["polar_inertia"] == pytest.approx(polar - 1.0, rel=1e-3)
