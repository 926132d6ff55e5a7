# SPDX-License-Identifier: Apache-2.0
"""Conversion of parts: places in any direction, profile shifts, bearings, couplings, loads, the list."""

from __future__ import annotations

import math

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.core.errors import ModelError
from pitchpoint.io.rexs.conversion.bearings import sum_of_stiffness
from pitchpoint.io.rexs.importing import import_rexs
from pitchpoint.io.yaml_model import loads_model
from tests.support.rexs_files import as_json, place, rexs, unit
from tests.validation.test_rexs_five_megawatt import gearbox


def imported(tmp_path, change=lambda parts, relations: None, cases=None, **more):
    parts, relations, own = unit()
    change(parts, relations)
    path = tmp_path / "unit.rexs"
    path.write_text(rexs(parts, relations, own if cases is None else cases), encoding="utf-8")
    return import_rexs(path, **more)


def with_(parts, number, **values):
    parts[number] = parts[number][0], {**parts[number][1], **values}


def rows(found, kind, attribute):
    return [item for item in found.of(kind) if item.attribute == attribute]


def frequencies(model):
    return pp.solve_modal(pp.compile_model(model, "steady"))["frequency"].values


# --- places -------------------------------------------------------------------------------------------------
def test_the_axes_of_the_model(tmp_path):
    """z is u, x is w, and y therefore -v."""
    found = imported(
        tmp_path, lambda p, r: (with_(p, 3, **place(5, 7, 0)), with_(p, 4, **place(5, 7, 69.3)))
    ).model
    np.testing.assert_allclose(found.shafts["shaft_3"].position, (0.0, -7e-3, 5e-3))
    np.testing.assert_allclose(found.shafts["shaft_4"].position, (69.3e-3, -7e-3, 5e-3))
    assert [g.hand for g in found.gears.values()] == ["right", "left"]


def test_a_gear_unit_in_any_direction_has_the_same_frequencies(tmp_path):
    """Axes turned in space, and positions relative to a shaft instead of the gear unit."""
    plain = imported(tmp_path).model
    turn = np.linalg.qr(np.array([[1.0, 2.0, -1.0], [0.5, -1.0, 3.0], [2.0, 0.3, 1.0]]))[0]
    turn *= np.sign(np.linalg.det(turn))

    def turned(parts, relations):
        for number in (3, 4):
            values = parts[number][1]
            vectors = ("support_vector", "u_axis_vector", "w_axis_vector")
            with_(parts, number, **{key: [*(turn @ np.array(values[key]))] for key in vectors})

    other = imported(tmp_path, turned).model
    assert other.shafts["shaft_3"].axes is not None
    np.testing.assert_allclose(frequencies(other), frequencies(plain), rtol=1e-8, atol=1e-4)

    def chained(parts, relations):
        with_(parts, 3, u_axis_vector=[0, 0, 1], w_axis_vector=[0, 1, 0])
        # w of the wheel shaft, 69.3 mm away along w of shaft 3
        with_(parts, 4, reference_component_for_position=3)

    third = imported(tmp_path, chained).model
    np.testing.assert_allclose(third.shafts["shaft_4"].position, (0.0, -69.3e-3, 0.0), atol=1e-12)


def test_a_shaft_with_its_axis_in_the_other_direction(tmp_path):
    """The same wheel shaft counted from its other end, equal frequencies and hands."""

    def tapered(parts, relations, absorbs=("negative", "positive")):
        for number, direction in zip((19, 20), absorbs, strict=True):
            with_(parts, number, catalogue_designation="30206", axial_force_absorption=direction)

    def reversed_(parts, relations):
        tapered(parts, relations, ("positive", "negative"))
        with_(parts, 4, support_vector=[120, 0, 69.3], u_axis_vector=[-1, 0, 0])
        with_(parts, 15, u_coordinate_on_shaft=0)
        for number, u in ((19, 110), (20, 10)):
            with_(parts, number, u_coordinate_on_shaft_inner_side=u)

    plain, other = imported(tmp_path, tapered).model, imported(tmp_path, reversed_).model
    assert [g.hand for g in other.gears.values()] == [g.hand for g in plain.gears.values()]
    assert other.rolling_bearings == plain.rolling_bearings
    np.testing.assert_allclose(frequencies(other), frequencies(plain), rtol=1e-8, atol=1e-4)


def test_sections(tmp_path):
    """A cone has cylinders of its volume; a section without coordinate follows the one before."""

    def change(parts, relations):
        parts[5] = ("shaft_section", {**parts[5][1], "length": 70})
        cone = {"length": 50, "outer_diameter_begin": 30, "outer_diameter_end": 24}
        parts[30] = ("shaft_section", cone)
        relations.append(("assembly", {"assembly": 3, "part": 30}))

    found = imported(tmp_path, change)
    sections = found.model.shafts["shaft_3"].sections
    assert len(sections) == 5 and sections[0].diameter == 0.03
    volume = sum(s.length * s.diameter**2 for s in sections[1:])
    assert volume == pytest.approx(50e-9 * (30**2 + 30 * 24 + 24**2) / 3.0, rel=1e-9)
    assert rows(found, "default", "u_coordinate_on_shaft")[0].value == "70 mm"


# --- profile shifts -----------------------------------------------------------------------------------------
def test_the_centre_distance_wins_over_a_placeholder(tmp_path):
    def zero(parts, relations):
        for number in (11, 12):
            with_(parts, number, addendum_modification_coefficient=0.0)

    found, plain = imported(tmp_path, zero), imported(tmp_path)
    (changed,) = rows(found, "changed", "addendum_modification_coefficient")
    assert "0 is a placeholder: it gives 69.0794 mm" in changed.reason and "is 69.3 mm" in changed.reason
    assert (
        found.model.pairs["cylindrical_stage_13"].gear2.x == plain.model.pairs["cylindrical_stage_13"].gear2.x
    )
    (default,) = rows(plain, "default", "addendum_modification_coefficient")
    assert default.reason == (
        "from the centre distance 69.3 mm of cylindrical_stage 13 (cylindrical_stage 13), "
        "cylindrical_gear_7 / cylindrical_gear_8"
    )


def test_without_any_profile_shift_gear_1_has_none(tmp_path):
    def none(parts, relations):
        for number in (9, 10):
            parts[number] = parts[11]

    pair = imported(tmp_path, none).model.pairs["cylindrical_stage_13"]
    assert pair.gear1.x == 0.0
    assert pair.j_bt == pytest.approx(0.0, abs=1e-12)
    assert pair.gear2.x == pytest.approx(0.41, abs=0.01)


def test_tools_and_diameters(tmp_path):
    def change(parts, relations):
        tool = {
            "addendum_coefficient_reference_profile": 1.4,
            "tip_corner_radius_factor_reference_profile": 0.2,
        }
        parts[30] = ("rack_shaped_tool", tool)
        parts[31] = ("cylindrical_gear_manufacturing_settings", {})
        steps = {"workpiece": 7, "tool": 30, "manufacturing_settings": 31}
        relations.append(("manufacturing_step", steps))
        with_(parts, 7, tip_diameter=48, root_diameter=500)

    found = imported(tmp_path, change)
    gear = found.model.gears["cylindrical_gear_7"]
    assert (gear.rack.dedendum, gear.rack.root_radius, gear.rack.addendum) == (1.4, 0.2, 1.0)
    assert (gear.tip_diameter, gear.root_diameter) == (0.048, None)
    assert "500 mm is a placeholder" in rows(found, "changed", "root_diameter")[0].reason


# --- bearings and couplings ---------------------------------------------------------------------------------
RATINGS = {
    "inner_diameter": 30,
    "outer_diameter": 62,
    "width": 17.25,
    "axial_force_absorption": "positive",
    "radial_dynamic_load_rating": 43.5,
    "radial_static_load_rating": 48,
    "u_coordinate_on_shaft_inner_side": 10,
}


def test_bearings_by_data_elements_or_stiffness(tmp_path):
    kind = "rolling_bearing_with_catalog_geometry"

    def change(parts, relations):
        parts[17] = (
            kind,
            {**RATINGS, "bearing_type": "radial_tapered_roller_bearing", "catalogue_designation": "X 1"},
        )
        parts[30] = ("rolling_bearing_row", {"pressure_angle": 14})
        parts[19] = (
            kind,
            {"u_coordinate_on_shaft_inner_side": 10, "inner_diameter": 30, "outer_diameter": 62},
        )
        parts[31] = ("rolling_bearing_row", {})
        relations += [("ordered_assembly", {"assembly": a, "part": b}) for a, b in ((17, 30), (19, 31))]
        for k in range(8):
            parts[40 + k] = ("rolling_element", {"diameter_of_rolling_element": 9.5})
            relations.append(("ordered_assembly", {"assembly": 31, "part": 40 + k}))
        parts[20] = (
            kind,
            {
                "u_coordinate_on_shaft_inner_side": 110,
                "radial_stiffness": 3e8,
                "axial_force_absorption": "no_direction",
            },
        )

    model = imported(tmp_path, change).model
    tapered = model.rolling_bearings[f"{kind}_17"]
    assert (tapered.type, tapered.width, tapered.radial_static_load_rating) == (
        "tapered_roller",
        0.01725,
        48e3,
    )
    assert tapered.contact_angle == pytest.approx(math.radians(14.0))
    ball = model.rolling_bearings[f"{kind}_19"]
    assert (ball.type, ball.elements, ball.pitch_diameter) == ("ball", 8, 0.046)
    assert model.bearings[f"{kind}_20"].stiffness.matrix6()[0][0] == 3e8
    assert model.bearings[f"{kind}_20"].stiffness.matrix6()[2][2] == 0.0


def test_couplings_to_shafts_and_to_the_casing(tmp_path):
    def change(parts, relations):
        parts[30] = ("shaft", place(120, 0, 0))
        parts[31] = ("shaft_section", {"length": 50, "outer_diameter_begin": 25, "outer_diameter_end": 25})
        relations += [("assembly", {"assembly": 1, "part": 30}), ("assembly", {"assembly": 30, "part": 31})]
        stiff = {
            "rotational_stiffness": 2e6,
            "bending_stiffness": 1e5,
            "radial_stiffness": 1e20,
            "axial_stiffness": 1e6,
        }
        sides = {"u_coordinate_on_shaft_inner_side": 120, "u_coordinate_on_shaft_outer_side": 0}
        parts[32] = ("coupling", {**stiff, **sides})
        parts[33] = (
            "switchable_coupling",
            {**stiff, "u_coordinate_on_shaft_inner_side": 60, "is_engaged": [False, True]},
        )
        parts[34] = (
            "switchable_coupling",
            {**stiff, "u_coordinate_on_shaft_inner_side": 60, "is_engaged": [True, False]},
        )
        for number, inner, outer in ((32, 3, 30), (33, 4, 2), (34, 4, 2)):
            relations.append(("side", {"assembly": number, "inner_part": inner, "outer_part": outer}))
        with_(parts, 1, gear_shift_index=2)

    found = imported(tmp_path, change)
    coupling = found.model.couplings["coupling_32"]
    assert coupling.bodies == ("shaft_3", "shaft_30") and coupling.position == (0.0, 0.0, 0.12)
    six = coupling.stiffness.matrix6()
    assert (six[0][0], six[2][2], six[3][3], six[5][5]) == (1e11, 1e6, 100.0, 2000.0)
    assert found.model.bearings["switchable_coupling_33"].stiffness.matrix6()[5][5] == 2000.0
    assert "switchable_coupling_34" not in found.model.bearings
    assert rows(found, "changed", "radial_stiffness")[0].reason == "1e+20 N/m is rigid"


def test_additional_masses_are_bodies_on_their_shafts(tmp_path):
    """A flywheel on the input shaft; a mass without moments of inertia has no body."""
    moments = {f"moment_of_inertia_{a}_axis": 0.02 for a in "vw"} | {"moment_of_inertia_u_axis": 0.04}

    def change(parts, relations):
        parts[30] = ("additional_mass", {"mass_of_component": 5, "u_coordinate_on_shaft": 20, **moments})
        parts[31] = ("additional_mass", {"mass_of_component": 5})
        relations += [("assembly", {"assembly": 3, "part": n}) for n in (30, 31)]

    found = imported(tmp_path, change)
    body = found.model.bodies["additional_mass_30"]
    assert (body.mass, body.inertia, body.transverse_inertia) == (5.0, 0.04, 0.02)
    np.testing.assert_allclose(body.position, (0, 0, 0.02))
    assert found.model.couplings["additional_mass_30"].bodies == ("shaft_3", "additional_mass_30")
    assert "additional_mass_31" not in found.model.bodies
    (left,) = [item for item in found.of("ignored") if "additional_mass 31" in item.component]
    assert left.reason == "mass and moments of inertia about u, v and w are required"


def test_several_planet_bearings_are_one_stiffness():
    """Two bearings of k at -a and b: k of each, moments k (a^2 + b^2), and coupling k (b - a)."""
    six = sum_of_stiffness([({"radial": 2e8, "axial": 1e7}, -0.01), ({"radial": 2e8}, 0.03)])
    assert six[0, 0] == six[1, 1] == 4e8 and six[2, 2] == 1e7
    assert six[3, 3] == six[4, 4] == pytest.approx(2e8 * (0.01**2 + 0.03**2))
    assert six[0, 4] == six[4, 0] == pytest.approx(2e8 * 0.02)
    assert six[1, 3] == six[3, 1] == pytest.approx(-2e8 * 0.02)
    # a force F at z = 0.03 moves the shaft there by F/k, and not at z = -0.01
    x, ry = np.linalg.solve(six[np.ix_((0, 4), (0, 4))], [100.0, 100.0 * 0.03])
    assert x + 0.03 * ry == pytest.approx(100.0 / 2e8)
    assert x - 0.01 * ry == pytest.approx(0.0, abs=1e-12)


# --- loads --------------------------------------------------------------------------------------------------
def test_loads_of_a_case(tmp_path):
    """The second case runs and drives backwards; the output balances it."""
    found = imported(tmp_path, load_case=2)
    loads = found.model.loads
    assert loads["external_load_14"].torque.value == -40.0
    assert type(loads["external_load_15"].torque).__name__ == "Balance"
    assert found.model.scenarios["steady"].speed == {"shaft_3": pytest.approx(-900 * math.pi / 30)}
    speeds = [case.speed["shaft_3"] for case in found.model.load_cases.values()]
    assert speeds == pytest.approx([1500 * math.pi / 30, -900 * math.pi / 30])
    f = 900 / 60 * 21
    assert found.model.scenarios["steady"].duration == pytest.approx(20 / f, rel=0.05)
    assert found.model.scenarios["steady"].step == pytest.approx(1 / (50 * f), rel=0.05)


def test_power_gravity_and_forces(tmp_path):
    def change(parts, relations):
        with_(parts, 1, account_for_gravity=True, direction_vector_gravity_w=-2)
        with_(parts, 3, rotational_speed=1000)
        with_(parts, 14, power=3, force_v_direction=5, force_u_direction=7)

    found = imported(tmp_path, change, cases=[])
    assert found.load_case is None
    np.testing.assert_allclose(found.model.gravity, (-9.80665, 0, 0), atol=1e-12)
    load = found.model.loads["external_load_14"]
    assert load.torque.value == pytest.approx(3000.0 / (1000 * math.pi / 30))
    assert [law.value for law in load.force] == [0.0, -5.0, 7.0]


def test_without_speed_and_torque_there_is_a_slow_roll(tmp_path):
    found = imported(tmp_path, cases=[])
    assert list(found.model.scenarios) == ["slow"]
    assert not found.model.loads
    assert len(rows(found, "ignored", "all")) >= 2


# --- the list -----------------------------------------------------------------------------------------------
def test_every_value_of_the_file_is_in_the_list(tmp_path):
    """Taken, changed or ignored: no value of a component is left without mention."""
    found = imported(tmp_path)
    named = {item.attribute for item in found.items}
    whole = {item.component.split(" (")[0] for item in found.of("ignored") if item.attribute == "all"}
    for component in found.source.components.values():
        if component.type in whole or str(component).split(" (")[0] in whole:
            continue
        assert set(component.attributes) <= named, component


def test_texts_of_the_file_stay_within_comments(tmp_path):
    """A line break in a name must not become a key of the model file."""
    parts, relations, cases = unit()
    text = as_json(rexs(parts, relations, cases)).replace('"a program"', '"x\\ninjected: {a: 1}\\u2028y: 2"')
    path = tmp_path / "unit.rexs"
    path.write_text(text.replace('"cylindrical_stage 13"', '"a\\n\\"#: [\\u0007 {0}"'), encoding="utf-8")
    found = import_rexs(path)
    assert loads_model(found.text()) == found.model
    assert "a_0" in found.model.meshes
    path.write_text(
        text.replace('"shaft 3"', '"\\u4e2d\\u6587"').replace('"shaft 4"', '""'), encoding="utf-8"
    )
    assert list(import_rexs(path).model.shafts) == ["part", "shaft_4"]


def test_a_carrier_is_one_rigid_body(tmp_path):
    """Shaft 500 x 800 mm and three pins 600 x 250 mm on a circle of 863 mm, closed form."""
    path = tmp_path / "unit.rexs"
    path.write_text(gearbox(), encoding="utf-8")
    model = import_rexs(path).model
    (stage,) = model.planetary_stages.values()
    carrier = model.bodies[stage.carrier]
    rho = stage.planet.material_data.density
    shaft, pin = (rho * math.pi / 4 * d**2 * length for d, length in ((0.8, 0.5), (0.25, 0.6)))
    assert carrier.mass == pytest.approx(shaft + 3 * pin)
    polar = shaft * 0.8**2 / 8 + 3 * pin * (0.25**2 / 8 + 0.863**2)
    assert carrier.inertia == pytest.approx(polar)
    # origin at the start of the carrier shaft, 600 mm before the pins
    assert carrier.center_of_mass == pytest.approx((shaft * 0.25 + 3 * pin * 0.9) / (shaft + 3 * pin))
    own = shaft * (0.8**2 / 16 + 0.5**2 / 3) + 3 * pin * (0.25**2 / 16 + 0.6**2 / 12 + 0.9**2 + 0.863**2 / 2)
    assert carrier.transverse_inertia == pytest.approx(own)
    np.testing.assert_allclose(stage.angles, [0.0, math.tau / 3, 2 * math.tau / 3], atol=1e-12)


def test_hands_of_a_helical_planetary_stage(tmp_path):
    """Planet and ring have opposite signs in REXS, as gears of an external pair, but equal hands."""
    text, teeth = gearbox(), '"number_of_teeth" unit="none">{0}</attribute>'
    for z, beta in ((19, 4), (17, -4), (56, 4)):
        helix = f'<attribute id="helix_angle_reference_diameter" unit="deg">{beta}</attribute>'
        text = text.replace(teeth.format(z), teeth.format(z) + helix)
    path = tmp_path / "unit.rexs"
    path.write_text(text, encoding="utf-8")
    model = import_rexs(path).model
    (stage,) = model.planetary_stages.values()
    hands = [model.gears[stage.sun].hand, stage.planet.hand, model.gears[stage.ring].hand]
    assert hands == ["right", "left", "left"]


def test_planets_that_a_stage_cannot_have(tmp_path):
    """Another number of teeth, another distance."""
    for old, new, words in (
        ('"number_of_teeth" unit="none">17<', '"number_of_teeth" unit="none">18<', "planets are equal"),
        ("<c>863.0</c>", "<c>866.0</c>", "differs from the distance of shaft"),
    ):
        path = tmp_path / "unit.rexs"
        assert old in gearbox()
        path.write_text(gearbox().replace(old, new, 1), encoding="utf-8")
        with pytest.raises(ModelError) as caught:
            import_rexs(path)
        assert words in str(caught.value)
