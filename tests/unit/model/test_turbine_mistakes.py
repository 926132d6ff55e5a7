# SPDX-License-Identifier: Apache-2.0
"""Mistakes in the model of a wind turbine: one sentence each, with line, value, limit and remedy."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model, loads_model

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
    told = problems_of(EXAMPLE.read_text(encoding="utf-8").replace("include:", "#"))
    assert len(told) <= 16
    assert any("define sampling in parameters" in each and "so are 5 other values" in each for each in told)


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
