# SPDX-License-Identifier: Apache-2.0
"""Mistakes in the model of a wind turbine: one sentence each, with line, value, limit and remedy."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.model.remarks.beam_sections import implausible_sections, parts_of_other_files
from pitchpoint.model.remarks.wind_rotors import upwind_axes

EXAMPLE = Path(__file__).parents[3] / "examples" / "wind-turbine" / "model.yaml"


def problems_of(text: str) -> list[str]:
    with pytest.raises(ModelError) as error:
        loads_model(text, file=str(EXAMPLE))
    assert all(p.line for p in error.value.problems)
    return [re.sub(r"line \d+", "line N", str(p)) for p in error.value.problems]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            "[blade_1, blade_2, blade_3], wind",
            "[blade_1, blade_2, tower], wind",
            "rotor.beams[2] (line N): 89.42 m is the distance of the root of blade 3 from the end of tower",
        ),
        ("{hub: hub, aero", "{hub: ground, aero", "hub (line N): is on ground, which does not turn"),
        (
            "hub_radius: 1.5 m",
            "hub_radius: 1500 m",
            "1500 m is larger than the blade (limit <= 61.4999 m, the",
        ),
        (
            "rate: 8 deg/s",
            "rate: -8 deg/s",
            "is not positive (limit > 0, in SI units); give the largest rate",
        ),
        (
            "{points: [[10 s, 1]",
            "{points: [[10 m, 1]",
            "points[0][0] (line N): '10 m': 'm' is not the unit of",
        ),
        (
            "speed: 8 m/s, height: 90 m, profile",
            "speed: 8 m/s, profile",
            "winds.steady (line N): has no height",
        ),
        ("step: 10 ms}", "step: 10 s}", "(limit >= 0 and <= 100 ms); write a value >= 0 and <= 100 ms"),
        (
            "position: [0, 1], torsion: [4.7275e11, 8.913e10], axial",
            "axial",
            "gives axial without position; give",
        ),
        ("{hub: hub, aero", "{aero", "add hub: BODY or BODY.MARKER"),
        (
            "blade_1: {ends: [root_1, tip_1],",
            "blade_1: {ends: [root_1, tip_1], diameters: [2 m, 1 m],",
            "beams.blade_1.diameters (line N): are not for blades; remove them",
        ),
        (
            "onshore/AeroDyn.dat",
            "onshore/Aerodyne.dat",
            "did you mean nrel_5mw/onshore/AeroDyn.dat? file names",
        ),
    ],
)
def test_one_sentence(old: str, new: str, words: str) -> None:
    text = EXAMPLE.read_text(encoding="utf-8")
    assert old in text
    [problem] = problems_of(text.replace(old, new, 1))
    assert words in problem


def test_beams_in_the_wrong_order() -> None:
    text = EXAMPLE.read_text(encoding="utf-8").replace("[blade_1, blade_2, b", "[blade_1, blade_3, b", 1)
    told = problems_of(text.replace("blade_3, blade_3], wind", "blade_3, blade_2], wind"))
    assert len(told) == 2
    assert "108.9 m is the distance of the tip of blade 2 from the end of blade_3 (limit <= 12.3 m" in told[0]


def test_an_unknown_name_in_many_places_is_one_problem() -> None:
    text = re.sub(r"(?s)  hub: \{mass.*?(?=  root_1)", "", EXAMPLE.read_text(encoding="utf-8"))
    [problem] = problems_of(text)
    assert "line N): names the body 'hub', which does not exist; so do 8 other values: line" in problem
    text = EXAMPLE.read_text(encoding="utf-8").replace("sample_rate: sampling", "sample_rate: sampled")
    [problem] = problems_of(text)
    assert "unknown name 'sampled'; did you mean sampling" in problem and "nor can 5 other values" in problem


def test_a_removed_drive_train_is_one_problem() -> None:
    [problem] = problems_of(EXAMPLE.read_text(encoding="utf-8").replace("include:", "#"))
    assert problem.startswith("include (line N): is missing: 16 problems are names that this model does not")
    assert "rigid_ratio.yaml and two_mass.yaml has (nacelle, generator, generator_ratio, sampling" in problem


def test_the_file_of_a_tower_for_the_blades() -> None:
    text = EXAMPLE.read_text(encoding="utf-8")
    [problem] = problems_of(text.replace("5MW_Blade.dat", "5MW_Onshore_ElastoDyn_Tower.dat"))
    assert "beams.blade_1.properties.elastodyn (line N): 'NRELOffshrBsline5MW_Onshore_Elasto" in problem
    assert "describes a tower, and the beam is a blade; give a blade file" in problem


def test_the_file_of_a_blade_for_the_tower() -> None:
    text = EXAMPLE.read_text(encoding="utf-8").replace(
        "NRELOffshrBsline5MW_Onshore_ElastoDyn_Tower.dat,\n      position: [0, 1], torsion: [4.7275e11, "
        "8.913e10], axial: [1.3813e11, 6.266e10]",
        "NRELOffshrBsline5MW_Blade.dat",
    )
    [remark] = parts_of_other_files(loads_model(text, file=str(EXAMPLE)))
    assert "beams.tower.properties.elastodyn: describes a blade, and the beam is not among" in remark


@pytest.mark.parametrize(
    ("factor", "scale", "words"),
    [
        ("AdjFlSt", 1000.0, "radius of gyration of the section of 12.3 m even for the stiffest material"),
        ("AdjFlSt", 0.001, "deflects by 1.14e+03 m under its own weight (limit 15.4 m, a quarter of"),
        ("AdjEdSt", 0.001, "deflects by 423 m under its own weight"),
        ("AdjBlMs", 1000.0, "deflects by 1.09e+03 m under its own weight"),
        ("AdjBlMs", 0.001, "radius of gyration of the section of 12.6 m"),
        ("AdjFlSt", 1.0, ""),
    ],
)
def test_a_stiffness_or_mass_in_another_unit(factor: str, scale: float, words: str, tmp_path: Path) -> None:
    blade = EXAMPLE.parent / "nrel_5mw/5MW_Baseline/NRELOffshrBsline5MW_Blade.dat"
    lines = blade.read_text(encoding="utf-8", errors="replace").splitlines()
    lines[[factor in line for line in lines].index(True)] = f"{scale}  {factor}"
    (tmp_path / "blade.dat").write_text("\n".join(lines))
    (tmp_path / "model.yaml").write_text(
        "bodies: {root: {motion: fixed, position: [0, 0, 0]}, "
        "tip: {motion: free, mass: 1 kg, inertia_tensor: [1, 1, 1, 0, 0, 0], position: [61.5 m, 0, 0]}}\n"
        "beams: {blade: {ends: [root, tip], axis: [0, 1, 0], properties: {elastodyn: blade.dat}}}\n"
    )
    found = implausible_sections(load_model(tmp_path / "model.yaml"))
    assert len(found) == bool(words)
    assert all(words in each and "beams.blade.properties.elastodyn" in each for each in found)


def test_keys_of_a_speed_with_a_box(tmp_path: Path) -> None:
    (tmp_path / "w.bts").write_bytes(b"")
    (tmp_path / "model.yaml").write_text(
        "bodies: {a: {motion: fixed, mass: 1 kg}}\n"
        "winds:\n  w: {box: w.bts, direction: 30 deg, height: 90 m}\n"
    )
    with pytest.raises(ModelError) as error:
        load_model(tmp_path / "model.yaml")
    told = [str(p) for p in error.value.problems]
    assert len(told) == 3
    for key in ("direction", "height"):
        assert any(f"winds.w.{key} (line 3): is given together with box" in each for each in told)


@pytest.mark.parametrize(("hub", "count"), [("[1, 0, 0.1]", 0), ("[-1, 0, 0]", 1), ("[0, 0, 1]", 1)])
@pytest.mark.parametrize("direction", ["0 deg", "60 deg"])
def test_a_hub_that_points_upwind(hub: str, count: int, direction: str) -> None:
    model = loads_model(
        f"bodies: {{hub: {{inertia: 1 kg m^2, position: [0, 0, 90 m], axes: {{z: {hub}}}}}}}\n"
        f"winds: {{steady: {{speed: 8 m/s, height: 90 m, direction: {direction}}}}}\n"
        "wind_rotors: {rotor: {hub: hub, hub_radius: 1 m, "
        f"aerodyn: {EXAMPLE.parent / 'nrel_5mw/onshore/AeroDyn.dat'}}}}}\n"
        "scenarios: {run: {speed: {hub: 9 rpm}, duration: 1 s}}\n"
    )
    found = upwind_axes(model)
    assert len(found) == count
    assert all("wind_rotors.rotor.hub" in str(each) and "deg to the wind" in str(each) for each in found)
