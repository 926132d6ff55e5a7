# SPDX-License-Identifier: Apache-2.0
"""Bad materials, tooth numbers, inertias and gear bodies: every problem has a limit and a remedy."""

from __future__ import annotations

import pytest

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.io.yaml_model import loads_model
from tests.support.model_files import gear, pair


def problems(text: str) -> list[Message]:
    with pytest.raises(ModelError) as caught:
        loads_model(text, file="bad.yaml")
    return list(caught.value.problems)


def test_an_empty_material_says_what_each_key_means() -> None:
    found = {
        p.where.rpartition(".")[2]: str(p) for p in problems("gears:\n" + gear("a", more="material: {}"))
    }
    assert "is missing: modulus E; add youngs_modulus: 210 GPa" in found["youngs_modulus"]
    assert "is missing: ratio of transverse to axial strain; add poisson_ratio: 0.3" in found["poisson_ratio"]
    assert "is missing: mass per volume; add density: 7850 kg/m^3" in found["density"]


@pytest.mark.parametrize(
    ("teeth", "remedy"),
    [("-24", "write 24"), ("true", "write 20"), ("2", "write 3"), ("'24'", "write 24 without quotes")],
)
def test_numbers_of_teeth(teeth: str, remedy: str) -> None:
    (problem,) = problems("gears:\n" + gear("a").replace("number_of_teeth: 30", f"number_of_teeth: {teeth}"))
    assert problem.limit == ">= 3 and <= 10000"
    assert problem.remedy == remedy


@pytest.mark.parametrize(
    ("key", "limit"),
    [
        ("inertia: -2", "> 0 for a body that moves, else >= 0"),
        ("mass: -2 kg", "> 0 with motion: planar or free, else >= 0"),
        ("transverse_inertia: -2", "> mass * center_of_mass^2 with motion: free, else >= 0"),
    ],
)
def test_the_limit_of_an_inertia_is_the_one_that_counts(key: str, limit: str) -> None:
    bodies = f"bodies:\n  one: {{gears: [a], {key}}}\n  two: {{gears: [b]}}\n"
    (problem,) = problems(pair(gear("a"), gear("b"), "", bodies))
    assert problem.limit == limit


def test_a_tip_diameter_that_points_the_tooth_is_named_with_the_largest_one_that_works() -> None:
    text = "gears:\n" + gear("a", 24, more="tip_diameter: %s mm")
    (problem,) = problems(text % 84)
    assert problem.where == "gears.a.tip_diameter"
    assert problem.value == "84 mm"
    assert problem.limit == "usually 0.2 m_n, at 80.60 mm"
    assert problem.remedy == "use at most 80.60 mm"
    assert loads_model(text % "80.60").gears["a"].tip_diameter == pytest.approx(0.0806)
    assert loads_model(text % "80.62").gears["a"].tip_diameter > 0.0806, "a thin tip can be made"


def test_without_a_tip_diameter_the_profile_shift_is_named() -> None:
    (problem,) = problems("gears:\n" + gear("a", 20, 1.4))
    assert problem.where == "gears.a.profile_shift_coefficient"


@pytest.mark.parametrize(
    ("keys", "where", "limit"),
    [
        ("rim_thickness: 100 mm", "rim_thickness", "<= 41.25 mm"),
        ("rim_thickness: 32 mm, bore_diameter: 20 mm", "rim_thickness", "<= 31.25 mm"),
        ("rim_thickness: 8 mm, web_thickness: 80 mm", "web_thickness", "<= 20 mm"),
        ("type: internal, tip_diameter: 88 mm, web_thickness: 80 mm", "web_thickness", "<= 20 mm"),
    ],
)
def test_rims_and_webs_larger_than_the_gear(keys: str, where: str, limit: str) -> None:
    (problem,) = problems("gears:\n" + gear("a", more=keys))
    assert problem.where == f"gears.a.{where}"
    assert problem.limit == limit
    assert "reduce it, or remove it" in str(problem.remedy)


def test_rims_and_webs_up_to_the_size_of_the_gear() -> None:
    keys = "rim_thickness: 41.25 mm, web_thickness: 20 mm"
    assert loads_model("gears:\n" + gear("a", more=keys)).gears["a"].rim_thickness == 0.04125
    ring = "type: internal, tip_diameter: 88 mm, rim_thickness: 200 mm"
    assert loads_model("gears:\n" + gear("a", more=ring)).gears["a"].rim_thickness == 0.2


@pytest.mark.parametrize(
    ("keys", "place"),
    [
        (
            "modifications: {both: {tip_relief: {amount: 20, length: 1 mm}}}",
            "modifications.both.tip_relief.amount",
        ),
        ("modifications: {left: {lead_crowning: 5}}", "modifications.left.lead_crowning"),
        (
            "modifications: {both: {end_relief: {amount: 9, length: 1 mm}}}",
            "modifications.both.end_relief.amount",
        ),
        ("modifications: {both: {helix_slope: -8}}", "modifications.both.helix_slope"),
        ("deviations: {runout: {amount: 30}}", "deviations.runout.amount"),
        ("deviations: {pitch: {right: [30, -30" + 18 * ", 0" + "]}}", "deviations.pitch"),
        (
            "deviations: {flank_maps: [{tooth: 1, flank: left, values: [[0, 1 um], [-20, 0]]}]}",
            r"deviations.flank_maps\[0\].values",
        ),
    ],
)
def test_forgotten_micrometres_are_seen(keys: str, place: str) -> None:
    gear = "number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    with pytest.raises(ModelError, match=rf"gears\.g\.{place} \(line 2\): .*is larger than the module"):
        loads_model(f"gears:\n  g: {{{gear}, {keys}}}\n")
