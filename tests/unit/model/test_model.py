# SPDX-License-Identifier: Apache-2.0
"""The model itself: values that geometry decides, places of bodies, inertia, copies, bad parts."""

from __future__ import annotations

import copy
import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.components.body import Body
from pitchpoint.model.components.gear import Gear
from pitchpoint.model.components.law import Constant
from pitchpoint.model.components.mesh import Mesh
from pitchpoint.model.components.stiffness import ConstantStiffness
from pitchpoint.model.model import Model
from tests.support import machines
from tests.support.model_files import ISO_EXAMPLE, TORSIONAL_PAIR, gear, pair


def test_open_profile_shift_follows_from_the_centre_distance() -> None:
    text = ISO_EXAMPLE.replace("profile_shift_coefficient: 0.145, ", "")
    model = loads_model(text)
    # cases.md: 0.14522 from a, printed as 0.145
    assert model.gears["pinion"].x == pytest.approx(0.14522, abs=5e-6)
    assert model.gears["pinion"].profile_shift_coefficient is None
    assert model.backlash("stage") == pytest.approx(0.0, abs=1e-12)


def test_open_shifts_run_through_a_train() -> None:
    text = (
        "gears:\n" + gear("a", 20) + gear("b", 30, None) + gear("c", 40, None) + "meshes:\n"
        "  one: {gears: [a, b], center_distance: 75.5 mm}\n  two: {gears: [c, b], center_distance: 105 mm}\n"
    )
    model = loads_model(text)
    x_b, x_c = model.gears["b"].x, model.gears["c"].x
    assert x_b is not None
    assert x_c is not None
    assert x_b > 0.1
    assert x_b + x_c == pytest.approx(0.0, abs=1e-12)


def test_centre_distance_follows_from_the_shifts() -> None:
    model = loads_model(pair(gear("a", 12, 0.6), gear("b", 24, 0.36)))
    # KHK gear technical reference, external spur pair: a = 56.4999 mm
    assert model.meshes["m"].a_w == pytest.approx(56.4999e-3, abs=5e-8)
    assert model.meshes["m"].center_distance is None


def test_internal_pair_has_signed_geometry() -> None:
    model = loads_model(pair(gear("a", 20), gear("b", 60, 0.0, "type: internal, tip_diameter: 176 mm")))
    assert model.meshes["m"].a_w == pytest.approx(-0.06)
    assert model.gears["b"].geometry.z == -60
    assert model.gears["b"].geometry.d_a == -0.176


def test_backlash_in_all_three_directions() -> None:
    helix = "helix_angle: 15 deg, hand: "
    base = pair(gear("a", 20, 0, helix + "left"), gear("b", 30, 0, helix + "right"), "backlash: {%s: 0.1 mm}")
    j_bt = {k: loads_model(base % k).backlash("m") for k in ("normal", "base_tangent", "circumferential")}
    beta_b = math.asin(math.sin(math.radians(15)) * math.cos(math.radians(20)))
    alpha_t = math.atan(math.tan(math.radians(20)) / math.cos(math.radians(15)))
    assert j_bt["base_tangent"] == pytest.approx(1e-4, rel=1e-14)
    assert j_bt["normal"] == pytest.approx(1e-4 / math.cos(beta_b), rel=1e-12)
    assert j_bt["circumferential"] == pytest.approx(1e-4 * math.cos(alpha_t), rel=1e-12)


def test_bodies_are_placed_along_meshes_and_couplings() -> None:
    text = pair(
        gear("a"),
        gear("b"),
        "direction: 90 deg",
        "bodies:\n  one: {gears: {a: 5 mm}}\n  two: {gears: {b: 2 mm}}\n  motor: {inertia: 1 kg m^2}\n"
        "couplings:\n  c: {bodies: [motor, two], stiffness: {torsion: 1e4 N m/rad}}\n",
    )
    bodies = loads_model(text).bodies
    assert bodies["one"].origin == (0.0, 0.0, 0.0)
    assert bodies["two"].origin == pytest.approx((0.0, 0.09, 0.003), abs=1e-17)
    assert bodies["motor"].origin == bodies["two"].origin


def test_direction_follows_from_positions() -> None:
    text = pair(
        gear("a"),
        gear("b"),
        "",
        "bodies:\n  one: {gears: [a], position: [1, 0, 0]}\n  two: {gears: [b], position: [1, -90 mm, 0]}\n",
    )
    mesh = loads_model(text).meshes["m"]
    assert mesh.theta == pytest.approx(-math.pi / 2)
    assert mesh.direction is None


def test_inertia_of_a_body_is_the_sum_over_its_gears() -> None:
    keys = "mass: 2 kg, polar_inertia: 0.01 kg m^2, transverse_inertia: 0.006 kg m^2"
    text = "gears:\n" + gear("a", more=keys) + gear("b", more=keys)
    text += "bodies:\n  one: {gears: {a: 0, b: 100 mm}, motion: free}\n"
    total = loads_model(text).body_inertia("one")
    assert (total.mass, total.polar, total.transverse) == pytest.approx((4.0, 0.02, 0.012 + 2 * 0.1**2))
    assert total.center == pytest.approx(0.05)


def test_both_gears_may_be_driven_against_their_ratio() -> None:
    drive = "drive: {driver: {speed: 100 rpm}, driven: {speed: -99.5 rpm}}, duration: 1 s"
    model = loads_model(TORSIONAL_PAIR.replace("speed: {driver: 1500 rpm}, duration: 0.5 s", drive))
    assert model.scenarios["steady"].drive["driver"].speed == Constant(pytest.approx(100 * math.tau / 60))


def test_replace_gives_a_new_checked_model() -> None:
    model = loads_model(TORSIONAL_PAIR)
    shifted = model.replace("gears.g1.profile_shift_coefficient", 0.1)
    assert shifted.gears["g1"].x == 0.1
    assert model.gears["g1"].x == 0.0
    assert shifted.pairs["stage"].j_bt < model.pairs["stage"].j_bt
    assert model.replace("meshes.stage.center_distance", "150.2 mm").pairs["stage"].a_w == 0.1502
    assert model.replace("gears.g1.number_of_teeth", np.int64(49)).gears["g1"].number_of_teeth == 49
    other = model.replace("meshes.stage.stiffness", {"law": "constant", "value": "1e8 N/m"})
    assert other.meshes["stage"].stiffness == ConstantStiffness(value=1e8)
    assert other.replace("meshes.stage.stiffness.value", 2e8).meshes["stage"].stiffness.value == 2e8  # type: ignore[union-attr]
    assert model.replace("loads.input.torque", Constant(3.0)).loads["input"].torque == Constant(3.0)
    assert model.replace("meshes.stage.damper", None).meshes["stage"].damper is None


def test_replace_by_none_takes_components_away() -> None:
    model = loads_model(TORSIONAL_PAIR)
    assert list(model.replace("loads.input", None).loads) == ["output"]
    assert list(model.loads) == ["input", "output"]
    assert list(model.replace("scenarios.sweep", None).scenarios) == ["steady"]
    assert dict(model.replace("scenarios.steady.speed.driver", None).scenarios["steady"].speed) == {}
    with pytest.raises(ModelError, match="names the gear 'g1', which does not exist"):
        model.replace("gears.g1", None)
    with pytest.raises(ModelError, match="does not exist"):
        model.replace("loads.brake", None)


@pytest.mark.parametrize(
    ("path", "value", "words"),
    [
        ("gears.g1.profile_shift", 0.1, "did you mean profile_shift_coefficient"),
        ("gears.g9.face_width", 0.1, "does not exist"),
        ("gears.g1.face_width", "3 kg", "such as 3 mm"),
        ("gears.g1.face_width", float("nan"), "finite"),
        ("meshes.stage.center_distance", 0.2, "reduce"),
        ("gears.g1.face_width.left", 0.1, "replace the whole value"),
        ("", 1, "unknown key"),
    ],
)
def test_replace_refuses(path: str, value: object, words: str) -> None:
    with pytest.raises(ModelError, match=words):
        loads_model(TORSIONAL_PAIR).replace(path, value)


def test_a_model_is_frozen_and_can_be_copied() -> None:
    model = loads_model(TORSIONAL_PAIR)
    with pytest.raises(AttributeError):
        model.title = "other"  # type: ignore[misc]
    with pytest.raises(TypeError, match="frozen"):
        model.gears["g1"] = model.gears["g2"]  # type: ignore[index]
    assert copy.deepcopy(model) == model


@pytest.mark.parametrize(
    "change",
    [
        {"normal_module": float("nan")},
        {"normal_module": "3 kg"},
        {"number_of_teeth": True},
        {"number_of_teeth": -20},
        {"rack": 1.0},
        {"hand": "up"},
        {"face_width": 0.0},
    ],
)
def test_parts_made_in_python_are_checked_too(change: dict[str, object]) -> None:
    good = {
        "number_of_teeth": 20,
        "normal_module": 0.003,
        "face_width": 0.02,
        "profile_shift_coefficient": 0.0,
    }
    assert Model(gears={"a": Gear(**good)}).gears["a"].x == 0.0  # type: ignore[arg-type]
    with pytest.raises(ModelError, match=next(iter(change))):
        Model(gears={"a": Gear(**{**good, **change})})  # type: ignore[arg-type]


def test_model_made_in_python_equals_that_of_a_file() -> None:
    spur = Gear(number_of_teeth=30, normal_module=0.003, face_width=0.02, profile_shift_coefficient=0.0)
    model = Model(
        gears={"a": spur, "b": spur},
        bodies={"one": Body(gears={"a": 0.0}), "two": Body(gears={"b": 0.0})},
        meshes={"m": Mesh(gears=("a", "b"))},
    )
    text = pair(gear("a"), gear("b"), "", "bodies:\n  one: {gears: [a]}\n  two: {gears: [b]}\n")
    assert loads_model(text) == model


def test_tables_for_notebooks_escape_text() -> None:
    html = loads_model(ISO_EXAMPLE.replace("ISO/TR", "<b>ISO")).replace("title", "<script>")._repr_html_()
    assert "<script>" not in html
    assert "pinion - wheel" in html


def test_the_remedy_for_a_number_lies_within_its_limits() -> None:
    """0.05, the usual number without unit, is no exponent of a contact."""
    with pytest.raises(ModelError) as caught:
        loads_model(machines.pair("{law: hertz, exponent: 0.5}"))
    (problem,) = caught.value.problems
    assert (problem.limit, problem.remedy) == (">= 1 and <= 5", "write 1")
