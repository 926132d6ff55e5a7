# SPDX-License-Identifier: Apache-2.0
"""Conversion of flank modifications, casings, oil, load spectra, bevel stages, hubs, bearings of two rows."""

from __future__ import annotations

import math

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.modifications import deviation, flank_range, roll_length
from pitchpoint.io.rexs.exporting.exporting import export_rexs
from pitchpoint.io.rexs.importing import import_rexs
from pitchpoint.io.rexs.writing.text import rexs_bytes
from pitchpoint.io.yaml_model import load_model
from tests.support.rexs_files import CONCEPT, bevel_unit, place, rexs
from tests.unit.io.test_rexs_conversion import imported, rows, with_


# --- flank modifications ------------------------------------------------------------------------------------
def modified(relations, parts, sides):
    """Give the flanks of gear 7 (9 left, 10 right) their modifications: type and values."""
    number = 40
    for flank, several in sides.items():
        for kind, values in several:
            parts[number] = (kind, values)
            relations.append(("reference", {"origin": flank, "referenced": number}))
            number += 1


def removed(gear, side, diameter, z):
    """Material removed from a flank at a diameter and a place along the face width [um]."""
    found = gear.modifications.side(side)
    parts = (
        np.zeros(1)
        if found is None
        else deviation(found.of_geometry(), gear.geometry, diameter, z, coordinate="diameter")
    )
    return 1e6 * float(np.asarray(parts).ravel()[0])


RELIEF = (
    "tip_relief",
    {"tip_relief_depth": 0.02, "tip_relief_datum_diameter": 45, "shape_of_relief": "linear"},
)


def test_flanks_are_seen_from_the_datum_face(tmp_path):
    """The left flank from the datum face at the smallest z is the right one from the end of the z axis."""
    for word, side in (("negative", "right"), ("positive", "left")):

        def change(parts, relations, word=word):
            with_(parts, 7, datum_face_orientation=word)
            modified(relations, parts, {9: [RELIEF]})

        gear = imported(tmp_path, change).model.gears["cylindrical_gear_7"]
        tip = abs(gear.geometry.d_Fa)
        other = {"left": "right", "right": "left"}[side]
        assert removed(gear, side, tip, 0.0) == pytest.approx(20.0)
        assert removed(gear, other, tip, 0.0) == 0.0


def test_helix_slopes_add_material_towards_the_non_datum_face(tmp_path):
    """8 um over 16 of 20 mm are 10 um over the face width, half of it at each end."""
    slope = ("helix_slope", {"helix_slope": 0.008, "helix_evaluation_start": -8, "helix_evaluation_end": 8})
    for word, sign in (("negative", 1.0), ("positive", -1.0)):

        def change(parts, relations, word=word):
            with_(parts, 7, datum_face_orientation=word)
            modified(relations, parts, {9: [slope], 10: [slope]})

        found = imported(tmp_path, change)
        gear = found.model.gears["cylindrical_gear_7"]
        ends = [removed(gear, "left", gear.geometry.d, z) for z in (-0.01, 0.01)]
        assert ends == pytest.approx([5.0 * sign, -5.0 * sign])
        assert "REXS does not define its sign" in rows(found, "changed", "helix_slope")[0].reason


def test_crownings_are_those_at_the_places_of_the_file(tmp_path):
    """Parabolas through the amounts: along the face width, and along the profile by roll lengths."""
    helix = ("helix_crowning", {
        "helix_crowning_amount_datum_face": 0.004,
        "helix_crowning_amount_non_datum_face": 0.004,
        "coordinate_where_helix_crowning_is_specified_datum_face": -8,
        "coordinate_where_helix_crowning_is_specified_non_datum_face": 8,
    })  # fmt: skip
    found = imported(tmp_path, lambda p, r: modified(r, p, {9: [helix], 10: [helix]}))
    gear = found.model.gears["cylindrical_gear_7"]
    assert removed(gear, "left", gear.geometry.d, 0.008) == pytest.approx(4.0)
    root, tip = flank_range(gear.geometry)
    middle, half = 0.5 * (root + tip), 0.25 * (tip - root)  # of the half of the flank in its middle
    low, high = (2e3 * math.hypot(roll, 0.5 * gear.geometry.d_b) for roll in (middle - half, middle + half))
    profile = ("profile_crowning", {
        "profile_crowning_at_tip": 0.003,
        "profile_crowning_at_root": 0.003,
        "diameter_where_profile_crowning_root_is_specified": low,
        "diameter_where_profile_crowning_tip_is_specified": high,
    })  # fmt: skip
    gear = imported(tmp_path, lambda p, r: modified(r, p, {9: [profile], 10: [profile]})).model.gears[
        "cylindrical_gear_7"
    ]
    assert roll_length(gear.geometry, 1e-3 * high) == pytest.approx(middle + half)
    assert removed(gear, "left", 1e-3 * high, 0.0) == pytest.approx(3.0, rel=1e-5)
    assert removed(gear, "left", 1e-3 * low, 0.0) == pytest.approx(3.0, rel=1e-5)
    assert gear.modifications.both.profile_crowning == pytest.approx(12e-6, rel=1e-5)


def test_end_reliefs_and_profile_slopes(tmp_path):
    ends = [
        (f"end_relief_{end}", {f"end_relief_depth_{end}": 0.01, f"end_relief_length_{end}": 5})
        for end in ("datum_face", "non_datum_face")
    ]
    slope = ("profile_slope", {"profile_slope": 0.006})
    found = imported(tmp_path, lambda p, r: modified(r, p, {9: [*ends, slope], 10: [*ends, slope]}))
    gear = found.model.gears["cylindrical_gear_7"]
    assert gear.modifications.both.end_relief.amount == 10e-6
    middle = 2.0 * math.hypot(0.5 * sum(flank_range(gear.geometry)), 0.5 * gear.geometry.d_b)
    assert [removed(gear, "left", middle, z) for z in (-0.01, -0.0075, 0.0, 0.01)] == pytest.approx(
        [10.0, 5.0, 0.0, 10.0]
    )
    assert removed(gear, "left", abs(gear.geometry.d_Fa), 0.0) == pytest.approx(-3.0)


def test_modifications_without_counterpart_are_listed_with_their_values(tmp_path):
    one_end = (
        "end_relief_datum_face",
        {"end_relief_depth_datum_face": 0.01, "end_relief_length_datum_face": 5},
    )
    uneven = ("helix_crowning", {
        "helix_crowning_amount_datum_face": 0.004, "helix_crowning_amount_non_datum_face": 0.006,
    })  # fmt: skip
    twist = ("profile_twist", {"profile_twist": 0.005})
    found = imported(tmp_path, lambda p, r: modified(r, p, {9: [one_end, uneven, twist]}))
    assert found.model.gears["cylindrical_gear_7"].modifications is None
    listed = {item.attribute: item.value for item in found.of("ignored")}
    assert listed["end_relief_depth_datum_face"] == "0.01 mm"
    assert listed["helix_crowning_amount_non_datum_face"] == "0.006 mm"
    assert "profile_twist" in listed


# --- casing -------------------------------------------------------------------------------------------------
AXES = {  # axes of the matrix in the gear unit: u and w
    "u_axis_vector": [0, 0, 1],
    "w_axis_vector": [-1, 0, 0],
}
SEAT = (2e4, 3e4, 5e4, 4e7, 5e7, 6e7)
"""Stiffness of each seat along and about u, v, w of the gear unit [N/mm], [N mm/rad]."""


def housed(parts, relations, matrix, offset=0.0):
    """Four concept bearings in a casing whose matrix is along axes of its own."""
    for k, number in enumerate((17, 18, 19, 20)):
        u = parts[number][1]["u_coordinate_on_shaft_inner_side"]
        parts[number] = ("concept_bearing", {**CONCEPT, "u_coordinate_on_shaft_inner_side": u})
        point = {"reference_component_for_position": 1, "support_vector": [u, offset, 69.3 * (k > 1)]}
        parts[60 + k] = ("reduction_point", point)
        relations.append(("reference", {"origin": 60 + k, "referenced": number}))
        relations.append(("ordered_assembly", {"assembly": 59, "part": 60 + k}))
    parts[59] = ("assembly_group", {
        **place(0, 0, 0), **AXES, "reduced_static_stiffness_matrix": matrix.tolist(),
        "matrix_with_inertial_environment_boundary": True,
    })  # fmt: skip
    relations.append(("reference", {"origin": 2, "referenced": 59}))


def in_own_axes(seats):
    """Matrix along the axes of the assembly group: u' = w, v' = v, w' = -u of the gear unit."""
    turn = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])
    whole = np.kron(np.eye(2 * len(seats)), turn)
    return whole @ np.diag(np.concatenate(seats)) @ whole.T


def test_casing_and_bearings_are_springs_in_series(tmp_path):
    """10 kN along v and w between two bearings: the shaft moves by F/2 of bearing and seat in series."""

    def change(parts, relations):
        housed(parts, relations, in_own_axes([SEAT] * 4))
        with_(parts, 14, force_v_direction=1e4, u_coordinate_on_shaft=60)
        with_(parts, 15, force_w_direction=1e4, u_coordinate_on_shaft=60)

    found = imported(tmp_path, change, cases=[])
    assert list(found.model.housing.nodes) == [f"concept_bearing_{n}" for n in (17, 18, 19, 20)]
    rigid = imported(tmp_path, lambda p, r: (change(p, r), r.pop()), cases=[])
    assert rigid.model.housing is None
    moved = [pp.solve_equilibrium(pp.compile_model(one.model)) for one in (found, rigid)]
    for shaft, channel, seat in (("shaft_3", "y", SEAT[1]), ("shaft_4", "x", SEAT[2])):
        mesh = [float(m["mesh_force[cylindrical_stage_13]"]) for m in moved]
        assert mesh == pytest.approx([0.0, 0.0], abs=1e-3)
        ends = [float(m[f"displacement[{shaft}.3.{channel}]"]) for m in moved]
        extra = abs(ends[0] - ends[1])
        assert extra == pytest.approx(1e4 / (2.0 * 1e3 * seat), rel=1e-4), (shaft, ends)


def test_a_reduction_point_beside_its_bearing(tmp_path):
    """The matrix is transformed rigidly: a force at the bearing also turns the seat about the axis."""
    found = imported(tmp_path, lambda p, r: housed(p, r, in_own_axes([SEAT] * 4), 10.0), cases=[])
    K = np.loadtxt(found.model.housing.stiffness_file, delimiter=",")
    # x = w, y = -v, z = u: the point is at y = -10 mm from the bearing; [N/m], [N], [N m/rad]
    assert K[0, 0] == pytest.approx(5e7) and K[2, 2] == pytest.approx(2e7)
    assert K[5, 5] == pytest.approx(4e4 + 5e7 * 0.01**2)
    assert K[0, 5] == pytest.approx(5e7 * 0.01)
    assert K[2, 3] == pytest.approx(-2e7 * 0.01)
    (first, *_) = rows(found, "changed", "support_vector")
    assert "is 10 mm from the bearing" in first.reason


def test_the_matrix_is_saved_next_to_the_model(tmp_path):
    found = imported(tmp_path, lambda p, r: housed(p, r, in_own_axes([SEAT] * 4)))
    path = found.save(tmp_path / "gearbox.yaml")
    assert (tmp_path / "unit_housing.csv").is_file()
    again = load_model(path)
    assert again.housing.nodes == found.model.housing.nodes
    frequencies = [pp.solve_modal(pp.compile_model(m))["frequency"].values[:30] for m in (found.model, again)]
    np.testing.assert_allclose(*frequencies, rtol=1e-9, atol=1e-6)


def test_a_housing_matrix_is_written_and_read_back(tmp_path):
    """A foot without load between a bearing and ground, of equal springs, leaves half of the stiffness."""
    found = imported(tmp_path, lambda p, r: housed(p, r, in_own_axes([SEAT] * 4)))
    K = np.loadtxt(found.model.housing.stiffness_file, delimiter=",")
    rexs_model = export_rexs(found.model, housing=(found.model.housing.nodes, K)).rexs
    path = tmp_path / "written.rexs"
    path.write_bytes(rexs_bytes(rexs_model, "xml"))
    again = import_rexs(path).model
    assert again.housing.nodes == found.model.housing.nodes
    read = np.loadtxt(again.housing.stiffness_file, delimiter=",")
    np.testing.assert_allclose(read, K, rtol=1e-12, atol=1e-3)
    nodes = (*found.model.housing.nodes, "foot")
    whole = np.zeros((30, 30))  # the first bearing on the foot, which is on ground by the same spring
    whole[:24, :24] = K
    own = slice(0, 6), slice(24, 30)
    for a in own:
        for b in own:
            whole[a, b] = K[:6, :6] * (1.0 if a == b else -1.0)
    whole[24:, 24:] += K[:6, :6]
    half = export_rexs(found.model, housing=(nodes, whole))
    assert any(one.where == "housing.feet" for one in half.omissions)
    path.write_bytes(rexs_bytes(half.rexs, "xml"))
    reduced = np.loadtxt(import_rexs(path).model.housing.stiffness_file, delimiter=",")
    np.testing.assert_allclose(reduced[:6, :6], 0.5 * K[:6, :6], rtol=1e-9, atol=1e-3)


@pytest.mark.parametrize("fault", ["free", "skew", "short"])
def test_casings_without_a_usable_matrix_are_rigid_and_listed(fault, tmp_path):
    matrix = in_own_axes([SEAT] * 4)
    if fault == "skew":
        matrix[0, 1] += 1e3
    if fault == "short":
        matrix = matrix[:6, :6]

    def change(parts, relations):
        housed(parts, relations, matrix)
        if fault == "free":
            with_(parts, 59, matrix_with_inertial_environment_boundary=False)

    found = imported(tmp_path, change)
    assert found.model.housing is None
    words = {"free": "that of a free casing", "skew": "is not symmetric", "short": "is 6 x 6"}[fault]
    assert any(words in item.reason for item in found.of("ignored"))


# --- lubricant and load cases -------------------------------------------------------------------------------
OIL = {
    "viscosity_at_40_degree_celsius": 220,
    "viscosity_at_100_degree_celsius": 19,
    "density_at_15_degree_celsius": 0.9,
}


def oiled(parts, relations, **values):
    parts[50] = ("lubricant", {**OIL, **values})
    relations += [("reference", {"origin": n, "referenced": 50}) for n in (2, 13)]
    with_(parts, 2, temperature_lubricant=70)


def test_the_lubricant_of_the_meshes(tmp_path):
    def change(parts, relations):
        oiled(parts, relations, lubricant_type_iso_6336_2006="polyalfaolefin")
        parts[50] = (parts[50][0], {**parts[50][1], "density_at_15_degree_celsius": 0.9})

    oil = imported(tmp_path, change).model.lubricant
    assert oil.viscosities == pytest.approx((220e-6, 19e-6))
    assert (oil.base, oil.temperature) == ("polyalphaolefin", pytest.approx(343.15))
    assert oil.density_at_15_degree_celsius == pytest.approx(900.0)


def test_a_lubricant_without_temperature_is_listed(tmp_path):
    def change(parts, relations):
        oiled(parts, relations)
        parts[2] = ("gear_casing", {})

    found = imported(tmp_path, change)
    assert found.model.lubricant is None
    assert any("temperature_lubricant of gear_casing is missing" in i.reason for i in found.of("ignored"))


def test_load_spectra_are_load_cases(tmp_path):
    """Speeds, torques, temperature and share of the time of each case; hours are listed."""
    cases = [
        {1: {"operating_time_fraction": 80}, 2: {"temperature_lubricant": 70}, 3: {"rotational_speed": 1500},
         14: {"torque_around_u_axis": 40}},
        {1: {"operating_time_fraction": 20}, 2: {"temperature_lubricant": 85}, 3: {"rotational_speed": 300},
         14: {"torque_around_u_axis": 120, "force_v_direction": 50}},
    ]  # fmt: skip

    def change(parts, relations):
        oiled(parts, relations)
        with_(parts, 1, operating_time=20000)

    found = imported(tmp_path, change, cases=cases)
    first, second = found.model.load_cases.values()
    assert [c.load_duration_fraction for c in (first, second)] == [0.8, 0.2]
    assert second.speed["shaft_3"] == pytest.approx(300 * math.pi / 30)
    assert second.loads["external_load_14"].torque == 120.0
    assert second.loads["external_load_14"].force == pytest.approx((0.0, -50.0, 0.0))
    assert second.temperature == pytest.approx(358.15)
    hours = rows(found, "ignored", "operating_time")
    assert [item.value for item in hours] == ["20000 h"]
    # the case in effect: power of the input and oil
    slow = found.model.replace("load_case", "case_2")
    assert slow.loads["external_load_14"].torque.value == 120.0
    assert slow.start_speeds("steady")["shaft_4"] == pytest.approx(-300 * math.pi / 30 * 21 / 46)


# --- bevel stages -------------------------------------------------------------------------------------------
def test_a_bevel_stage(tmp_path):
    """Cones, ratio and tooth forces of ISO 23509 and ISO 10300; the apex is where the axes intersect."""
    path = tmp_path / "bevel.rexs"
    path.write_text(rexs(*bevel_unit()), encoding="utf-8")
    found = import_rexs(path)
    model = found.model
    pair = model.bevel_pairs["bevel_stage_9"]
    assert pair.Sigma == pytest.approx(math.pi / 2)
    assert math.tan(pair.gear1.delta) == pytest.approx(17 / 31)
    assert pair.gear1.R_m == pytest.approx(
        17 * 3e-3 / (2.0 * math.cos(math.radians(35)) * math.sin(pair.gear1.delta))
    )
    assert [g.hand for g in model.bevel_gears.values()] == ["left", "right"]
    assert model.bevel_gears["bevel_gear_7"].normal_pressure_angle == pytest.approx(math.radians(20))
    assert model.backlash("bevel_stage_9") * math.cos(pair.beta_b) == pytest.approx(0.1e-3)
    assert not rows(found, "changed", "u_coordinate_on_shaft")
    speeds = model.start_speeds("steady")
    assert abs(speeds["shaft_4"] / speeds["shaft_3"]) == pytest.approx(17 / 31)
    rest = pp.solve_equilibrium(pp.compile_model(model, "slow"))
    # at rest 50 N m on the pinion: force along the base tangent at the mean cone distance
    force = abs(float(rest["mesh_force[bevel_stage_9]"]))
    base = pair.gear1.R_m * math.sin(pair.gear1.delta) * math.cos(pair.alpha_t)
    assert force * base == pytest.approx(50.0, rel=0.01)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"hypoid_offset": 20}, "20 mm is a hypoid stage"),
        ({"shaft_angle": 80}, "80 deg differs from the angle of the axes of the shafts (limit 90 deg"),
    ],
)
def test_bevel_stages_that_a_model_cannot_have(change, words, tmp_path):
    path = tmp_path / "bevel.rexs"
    path.write_text(rexs(*bevel_unit(**change)), encoding="utf-8")
    with pytest.raises(ModelError) as caught:
        import_rexs(path)
    assert words in str(caught.value)


def test_a_bevel_gear_beside_its_pitch_cone_is_listed(tmp_path):
    parts, relations, cases = bevel_unit()
    with_(parts, 7, u_coordinate_on_shaft=60.5)
    path = tmp_path / "bevel.rexs"
    path.write_text(rexs(parts, relations, cases), encoding="utf-8")
    (item,) = rows(import_rexs(path), "changed", "u_coordinate_on_shaft")
    assert item.value == "on the pitch cone"


# --- hubs and bearings of two rows --------------------------------------------------------------------------
def test_a_gear_on_a_press_fit_is_a_gear_of_the_shaft(tmp_path):
    def change(parts, relations):
        relations.remove(("assembly", {"assembly": 4, "part": 8}))
        parts[30] = ("cylindrical_interference_fit", {})
        relations.append(("side", {"assembly": 30, "inner_part": 4, "outer_part": 8}))

    found, plain = imported(tmp_path, change), imported(tmp_path)
    assert found.model.bodies["shaft_4"].gears == plain.model.bodies["shaft_4"].gears
    assert found.of("changed")[-1].reason == "gears are fixed rigidly to their shaft"


def test_a_pair_of_tapered_bearings(tmp_path):
    """Two rows, face to face: each of half the width, of 2^(-7/9) of C and half of C_0 (ISO 281)."""

    def change(parts, relations):
        parts[17] = ("rolling_bearing_with_catalog_geometry", {
            "bearing_type": "radial_tapered_roller_bearing", "catalogue_designation": "30206-A DF",
            "number_of_bearing_rows": 2, "inner_diameter": 30, "outer_diameter": 62, "width": 34.5,
            "catalogue_value_e": 0.37,
            "axial_force_absorption": "both_directions", "radial_dynamic_load_rating": 43.5 * 2 ** (7 / 9),
            "radial_static_load_rating": 96, "u_coordinate_on_shaft_inner_side": 20,
        })  # fmt: skip

    model = imported(tmp_path, change).model
    one, two = (b for n, b in model.rolling_bearings.items() if "_17_" in n)
    assert [b.position[2] for b in (one, two)] == pytest.approx([0.020 - 0.0345 / 4, 0.020 + 0.0345 / 4])
    assert [b.axial_force_absorption for b in (one, two)] == ["negative", "positive"]
    assert one.radial_dynamic_load_rating == pytest.approx(43.5e3)
    assert one.radial_static_load_rating == pytest.approx(48e3)
