# SPDX-License-Identifier: Apache-2.0
"""The page on mechanisms: its file, its commands and its numbers are tried as they stand there."""

from __future__ import annotations

import json
import re
import shlex
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.components.joint import COORDINATES
from pitchpoint.model.frames import body_frame
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model

TEXT = (Path(__file__).parents[2] / "docs" / "mechanisms.md").read_text(encoding="utf-8")
WORDS = " ".join(TEXT.split())
R, L = 0.1, 0.3
ROTOR = {"bodies.wheel_body.gears", "joints.seat.bodies[0]", "joints.left.bodies[0]"}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    found = re.search(r"^```yaml\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)
    assert found
    (tmp_path / "slider-crank.yaml").write_text(found[1], encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def height(theta):
    """Moment of the masses about the ground, in metres times kilograms."""
    return (1.0 * 0.04 + 0.8 * (R - 0.12 / L * R)) * np.sin(theta)


def reduced_inertia(theta):
    """Inertia of the whole slider-crank on the crank."""
    phi = np.arcsin(-R * np.sin(theta) / L)
    d_phi = -R * np.cos(theta) / (L * np.cos(phi))
    piston = -R * np.sin(theta) - L * np.sin(phi) * d_phi
    x = -R * np.sin(theta) - 0.12 * np.sin(phi) * d_phi
    y = R * np.cos(theta) + 0.12 * np.cos(phi) * d_phi
    return 1.2e-3 + 0.04**2 + 0.8 * (x * x + y * y) + 8e-3 * d_phi**2 + 0.5 * piston**2


def test_commands_run_and_numbers_are_right(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    lines = re.findall(r"^pitchpoint (.*)$", TEXT, re.MULTILINE)
    assert len(lines) == 3
    for line in lines:
        assert run_command(shlex.split(line)) == 0, line
    capsys.readouterr()

    def numbers(scenario: str) -> dict:
        command = ["run", "slider-crank.yaml", "-s", scenario, "--json", "-o", f"{scenario}-2.h5"]
        assert run_command(command) == 0
        return json.loads(capsys.readouterr().out)["channels"]

    driven = numbers("driven")["displacement[piston.z]"]
    assert "travels 200 mm" in WORDS
    assert driven["max"] - driven["min"] == pytest.approx(0.2, abs=1e-6)
    # energy from rest at 30 deg, fastest where J' w^2/2 balances the weight
    theta = np.linspace(np.radians(-210.0), np.radians(30.0), 20001)
    fall = 9.81 * (height(np.radians(30.0)) - height(theta))
    fastest = np.sqrt(2.0 * np.maximum(fall, 0.0) / reduced_inertia(theta)).max() * 30.0 / np.pi
    assert f"fastest at {fastest:.0f} rpm" in WORDS
    swing = numbers("swing")["speed[crank]"]
    # generalised-alpha with rho = 0.8 at 0.1 ms: second order, (w h)^2 = 1e-4 at most
    assert abs(swing["min"]) * 30.0 / np.pi == pytest.approx(fastest, rel=1e-4)


def test_the_shafts_of_the_page() -> None:
    rig, rod, housing, rotor = re.findall(r"^```yaml\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)[2:]
    model = loads_model(rig)
    assert model.stations["input"][3] == pytest.approx(0.1, rel=1e-12)
    assert "pinion sits on `input.4`" in WORDS
    modes = find_modes(compile_model(model), "run")
    assert modes.frequency[0] == pytest.approx(0.0, abs=1e-3)
    assert f"lowest natural frequency is {modes.frequency[1]:.0f} Hz" in WORDS
    assert modes.names[1] == "axial mode of output"
    # the keys of the other snippets are those of the file; what is missing is told, nothing else
    for text, missing in (
        (rod, {"elastic_bodies.rod.file", "joints.crank_pin.bodies[0]"}),
        (housing, {"gears", "bearings.left.body", "bearings.left.housing"}),
        (rotor, {*ROTOR, "bodies.journal.inertia"}),  # which nothing carries as long as there is no rotor
    ):
        with pytest.raises(ModelError) as error:
            loads_model(text)
        assert {p.where for p in error.value.problems} == missing


def test_the_tilted_gears_of_the_page() -> None:
    snippet = re.findall(r"^```yaml\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)[1]
    teeth = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    gears = f"gears: {{a: {{number_of_teeth: 20, {teeth}}}, b: {{number_of_teeth: 40, {teeth}}}}}\n"
    model = loads_model(gears + snippet)
    z = np.array([np.sin(np.radians(85.0)), 0.0, np.sin(np.radians(5.0))])
    for body in ("pinion", "wheel"):
        np.testing.assert_allclose(body_frame(model, body)[1][:, 2], z, atol=5e-5)
    x, y = np.array([0.0, 1.0, 0.0]), np.cross(z, [0.0, 1.0, 0.0])
    way = 0.09 * (np.cos(np.radians(30.0)) * x + np.sin(np.radians(30.0)) * y)
    np.testing.assert_allclose(model.bodies["wheel"].origin, way, atol=1e-5)


def test_the_table_of_joints_is_complete() -> None:
    joints = TEXT.partition("friction: {coefficient")[0]  # the next table is that of their friction
    rows = dict(re.findall(r"^\| `(\w+)` \| ([^|]*) \|", joints, re.MULTILINE))
    assert set(rows) == set(COORDINATES)
    for word, names in COORDINATES.items():
        if word != "user":
            assert rows[word] == (", ".join(names) or "none")
