# SPDX-License-Identifier: Apache-2.0
"""Channels chosen by meaning: what a user sees first in terminal, notebook and report."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.report.main_channels import channel_groups, end_bodies, main_channels
from pitchpoint.system.compile import compile_model

EXAMPLES = Path(__file__).parents[3] / "examples"


def names_of(file: str, scenario: str) -> tuple[object, list[str]]:
    """Model of an example, and the names of all channels of a scenario."""
    model = load_model(EXAMPLES / file)
    return model, [c.name for c in compile_model(model, scenario).layout.channels]


def test_of_a_shaft_model_the_stations_are_not_main_channels() -> None:
    """Two elastic shafts have 100 displacements of stations; speeds of the ends and forces come first."""
    model, names = names_of("geared-rotor/model.yaml", "fast")
    chosen = main_channels(model, names, "fast")
    assert sum(name.startswith("displacement") for name in names) > 60
    assert chosen[:4] == ["speed[rotor]", "speed[drive]", "mesh_force[stage]", "transmission_error[stage]"]
    assert not any(name.startswith("displacement") or "rotor.2" in name for name in chosen)
    assert len(chosen) < 60


def test_groups_have_the_ends_first_and_each_mesh_once() -> None:
    model, names = names_of("shovel-gearbox/model.yaml", "rated")
    groups = {group.title: group.names for group in channel_groups(model, names, "rated")}
    assert list(groups)[:3] == ["Speeds of input and output", "Meshes", "Bearings"]
    assert groups["Speeds of input and output"][:2] == ("speed[motor]", "speed[motor_right]")
    forces = [name for name in groups["Meshes"] if name.startswith("mesh_force")]
    assert sorted(forces) == sorted({f"mesh_force[{mesh}]" for mesh in model.meshes})
    assert all(name in names for group in groups.values() for name in group)


@pytest.mark.parametrize("file", ["squeezing-mechanism/model.yaml", "flyball-governor/model.yaml"])
def test_a_machine_without_gears_has_main_channels_too(file: str) -> None:
    model = load_model(EXAMPLES / file)
    scenario = next(name for name, one in model.scenarios.items() if one.kind == "time")
    names = [c.name for c in compile_model(model, scenario).layout.channels]
    assert main_channels(model, names, scenario)


def test_a_model_without_loads_has_its_geared_bodies_as_ends() -> None:
    model = loads_model("""
gears:
  pinion: {number_of_teeth: 24, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  wheel: {number_of_teeth: 49, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies: {input: {gears: [pinion]}, output: {gears: [wheel]}}
meshes: {stage: {gears: [pinion, wheel]}}
""")
    assert end_bodies(model) == ["input", "output"]
