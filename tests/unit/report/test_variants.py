# SPDX-License-Identifier: Apache-2.0
"""Variants are told apart by the values of their models, in whatever form these are stored."""

from __future__ import annotations

from pathlib import Path

import pytest

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from pitchpoint.core.progress import silent
from pitchpoint.report.collect import collect
from pitchpoint.report.variants import variant_words

PAIR = """
title: {title}
parameters:
  load: {{value: {load}, text: {words}}}
gears:
  g1: {{number_of_teeth: 50, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
  g2: {{number_of_teeth: 50, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
"""
REST = """
bodies:
  driver: {gears: [g1], inertia: 0.0115 kg m^2}
  driven: {gears: [g2], inertia: 0.0115 kg m^2}
meshes:
  stage: {gears: [g1, g2], center_distance: CENTRE, backlash: {normal: 0.1 mm},
    stiffness: {law: fourier, mean: 4.0e8 N/m, cosine: [-0.2, -0.1]}, damper: {ratio: 0.05}}
loads:
  input: {body: driver, torque: load}
  output: {body: driven, torque: load}
scenarios:
  steady: {speed: {driver: 1500 rpm}, duration: 5 ms, sample_rate: 20 kHz}
  sweep: {sweep: {body: driver, mesh_frequency: [1000 Hz, 1200 Hz], points: 2, direction: up,
    settle_periods: 2, measure_periods: 1}}
"""


def text(load: str = "150 N m", centre: str = "150 mm", title: str = "pair", words: str = "torque") -> str:
    return PAIR.format(load=load, title=title, words=words) + REST.replace("CENTRE", centre)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "pair.yaml"
    path.write_text(text(), encoding="utf-8")
    return path


def changed(load: str) -> str:
    """The model with another parameter as a changed model stores it: JSON."""
    from pitchpoint.io.yaml_model import loads_model
    from pitchpoint.model.write import model_text

    return model_text(loads_model(text()).replace("parameters.load", load))


def test_values_count_not_their_spelling() -> None:
    scenarios = {"a": "steady", "b": "steady"}
    same = text("0.15 kN m", "0.15 m", "another title", "another description")
    same = same.replace("damper: {ratio: 0.05}", "damper: {ratio: 5.0e-2}").replace(
        "face_width: 20 mm,", "face_width: 20 mm, helix_angle: 0 deg,", 1
    )
    assert variant_words({"a": text(), "b": same}, scenarios) == {}
    assert variant_words({"a": text(), "b": changed("150 N m")}, scenarios) == {}
    expected = {"a": "load 150 N m", "b": "load 200 N m"}
    assert variant_words({"a": text(), "b": changed("200 N m")}, scenarios) == expected
    wider = text(centre="0.1502 m")
    assert variant_words({"a": same, "b": wider}, scenarios) == {
        "a": "center distance 0.15 m",
        "b": "center distance 0.1502 m",
    }
    # a number in place of the parameter is the same torque
    plain = text().replace("torque: load", "torque: 150 N m")
    assert variant_words({"a": text(), "b": plain}, scenarios) == {}


def test_a_base_run_and_its_variant_share_their_pictures(file: Path, tmp_path: Path) -> None:
    """As in docs/report.md: a plain run, and one with --set; runs, sweeps and models of several files."""
    part = tmp_path / "gears.yaml"
    part.write_text("".join(text().partition("gears:")[1:]).partition("bodies:")[0], encoding="utf-8")
    whole = tmp_path / "whole.yaml"
    whole.write_text(
        text().partition("gears:")[0] + "include: [gears.yaml]\nbodies:" + text().partition("bodies:")[2],
        encoding="utf-8",
    )
    for model, command, scenario in (
        (file, "run", "steady"),
        (file, "sweep", "sweep"),
        (whole, "run", "steady"),
    ):
        base, other = (str(tmp_path / f"{command}_{name}.h5") for name in ("base", "v"))
        call = [command, str(model), "-s", scenario, "-q"]
        assert run_command([*call, "-o", base]) == 0
        assert run_command([*call, "-o", other, "--set", "parameters.load=200 N m"]) == 0
        found, notes = collect(pp.load_model(model), [base, other], silent)
        names = {"load 150 N m": f"{scenario}: load 150 N m", "load 200 N m": f"{scenario}: load 200 N m"}
        assert found.compared == [(scenario, names)], (model, command)
        assert not any("different version" in note for note in notes)


def test_datasets_are_compared_too(file: Path) -> None:
    model = pp.load_model(file)
    runs = [
        pp.solve_time(pp.compile_model(one, "steady"))
        for one in (model, model.replace("parameters.load", "200 N m"))
    ]
    found, _ = collect(model, runs, silent)
    assert [sorted(names) for _, names in found.compared] == [["load 150 N m", "load 200 N m"]]


def test_variants_share_their_pictures(file: Path, tmp_path: Path) -> None:
    """Two torques of one scenario: the legend has what differs, and the result names it."""
    runs = [str(tmp_path / f"{torque}.h5") for torque in (100, 200)]
    for torque, run in zip((100, 200), runs, strict=True):
        changed = ["--set", f"loads.output.torque={torque} N m", "--set", f"loads.input.torque={torque} N m"]
        assert run_command(["run", str(file), "-s", "steady", "-q", "-o", run, *changed]) == 0
    text = pp.write_report(file, tmp_path / "pair.html", *runs).read_text(encoding="utf-8")
    section = text[text.index('<section id="comparison"') : text.index('<section id="scene"')]
    for torque in (100, 200):
        assert f'"name":"input torque {torque} N m, output torque {torque} N m"' in section
        assert f"steady: input torque {torque} N m, output torque {torque} N m</th>" in text
    assert "mesh force, stage [" in section
    assert ".h5 was computed with a different version" not in text
    assert "different version of the model" not in text  # the scene has the model of its run
