# SPDX-License-Identifier: Apache-2.0
"""The page on diagnosis: gearbox, commands, numbers and Python on spectra, run-ups and fault frequencies."""

from __future__ import annotations

import importlib
import json
import re
import shlex
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command

TEXT = (Path(__file__).parents[2] / "docs" / "diagnosis.md").read_text(encoding="utf-8")
TITLES = re.findall(r"^## (.*)$", TEXT, re.MULTILINE)
PARTS = dict(zip(TITLES, re.split(r"^## .*$", TEXT, flags=re.MULTILINE)[1:], strict=True))
FILE = re.search(r"^```yaml\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)[1]  # type: ignore[index]


def words(part: str) -> str:
    """Text of a part of the page without line breaks."""
    return " ".join(PARTS[part].split())


def commands(part: str) -> list[list[str]]:
    """Commands of a part of the page."""
    return [shlex.split(line) for line in re.findall(r"^pitchpoint (.*)$", PARTS[part], re.MULTILINE)]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Folder with the file of the page, where its commands run."""
    (tmp_path / "gearbox.yaml").write_text(FILE, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def run_python(part: str, names: dict) -> dict:
    """Run the Python of a part of the page."""
    for code in re.findall(r"^```python\n(.*?)^```", PARTS[part], re.DOTALL | re.MULTILINE):
        exec(code, names)
    return names


def test_fault_frequencies(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    at_scenario, at_speed = commands("Fault frequencies")
    assert run_command([*at_scenario, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    meshes = found["meshes"]
    assert [round(m["frequency"], 9) for m in meshes.values()] == [960.0, 480.0]
    assert [round(m["assembly_phase"], 9) for m in meshes.values()] == [30.0, 30.0]
    assert [round(m["hunting_tooth"], 9) for m in meshes.values()] == [10.0, 2.0]
    for said in ("960 and 480 Hz", "30 Hz: the teeth", "10 and 2 Hz"):
        assert said in words("Fault frequencies")
    assert run_command(at_speed) == 0
    assert json.loads(capsys.readouterr().out)["meshes"]["first"]["frequency"] == pytest.approx(
        960.0, rel=1e-12
    )


@pytest.mark.slow
def test_spectra(folder: Path) -> None:
    (run,) = commands("Spectra")
    assert run_command(run) == 0
    names = run_python("Spectra", {})
    assert f"{names['mesh'].fundamental:.3f} Hz" == "960.000 Hz"
    ratios = [names[n].ratio[0] for n in ("by_idler", "by_input")]
    for said in ("960.000 Hz", f"{ratios[0]:.3f} of the mesh line", f"apart to {ratios[1]:.3f}", "0.100 s"):
        assert said in words("Spectra")
    period = names["period"]
    assert period.quefrency[0] == pytest.approx(0.1, abs=1e-4)
    # a run without noise, to the errors of its integration
    assert period.value[0] / period.background[0] == pytest.approx(85.7, rel=5e-3)
    assert (names["band"].best_low, names["band"].best_high) == pytest.approx((5000.0, 10_000.0), rel=1e-3)
    assert names["band"].best_kurtosis > 20.0 * names["band"].best_spread
    envelope = names["envelope"]
    top = 1 + int(np.argmax(envelope.amplitude[1:]))
    assert envelope.frequency[top] == pytest.approx(960.0, abs=envelope.resolution)


@pytest.mark.slow
@pytest.mark.study
def test_run_ups(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for command in commands("Run-ups")[:2]:
        assert run_command(command) == 0
    import pitchpoint as pp
    from pitchpoint.analysis.sampled import sample_rate_of

    names = run_python("Run-ups", {"pp": pp, "sample_rate_of": sample_rate_of})
    assert (folder / "waterfall.html").stat().st_size > 10_000
    assert (folder / "orders.html").stat().st_size > 10_000
    orders, waterfall = names["orders"], names["waterfall"]
    mesh = orders.amplitude[:, int(np.argmin(np.abs(orders.order - 32.0)))]
    k = int(np.argmax(mesh))
    speed = orders.speed[k]
    for said in (f"{mesh[k]:.0f} N", f"{speed * 30 / np.pi:.0f} rpm", f"{speed * 32 / (2 * np.pi):.0f} Hz"):
        assert said in words("Run-ups")
    capsys.readouterr()
    assert run_command(["modes", "gearbox.yaml", "--scenario", "run_up", "--json"]) == 0
    lowest = json.loads(capsys.readouterr().out)["modes"][0]["frequency"]
    assert f"{lowest:.0f} Hz" in words("Run-ups")
    # the waterfall has the same resonance at the same time, within the time and frequency of one frame
    at = np.interp(speed, orders.speed, orders.time)
    row = int(np.argmin(np.abs(waterfall.time - at)))
    line = waterfall.frequency[int(np.argmax(waterfall.amplitude[row]))]
    assert line == pytest.approx(speed * 32 / (2 * np.pi), abs=2 * waterfall.frequency[1])


def test_named_functions_exist() -> None:
    for module, name in re.findall(r"`([a-z_]+)\.([a-z_]+)`", PARTS["Fault frequencies"] + PARTS["Spectra"]):
        assert hasattr(importlib.import_module(f"pitchpoint.analysis.{module}"), name), (module, name)
