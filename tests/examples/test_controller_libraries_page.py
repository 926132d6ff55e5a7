# SPDX-License-Identifier: Apache-2.0
"""The page on controller libraries: its library, its commands, its numbers, its table of records."""

from __future__ import annotations

import math
import re
import shlex
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.discon.records import RECORDS
from pitchpoint.io.reading import open_result

TEXT = (Path(__file__).parents[2] / "docs" / "howto" / "controller_libraries.md").read_text(encoding="utf-8")
WORDS = " ".join(TEXT.split())
J, RPM = 4.37e7, math.pi / 30.0
SPEED = 12.1 * RPM
TORQUE = 5.0e6 / 0.944 / 122.9097


def part(language: str, number: int = 0) -> str:
    return re.findall(rf"^```{language}\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)[number]


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder in which all commands of the page have been run."""
    if shutil.which("cc") is None:
        pytest.skip("no C compiler (cc) for the library of the page")
    folder = tmp_path_factory.mktemp("page")
    (folder / "pitch.c").write_text(part("c"), encoding="utf-8")
    (folder / "turbine.yaml").write_text(part("yaml"), encoding="utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        compiled = re.search(r"^cc .*$", TEXT, re.MULTILINE)
        assert compiled is not None
        subprocess.run(shlex.split(compiled[0]), check=True)
        lines = re.findall(r"^pitchpoint (.*)$", TEXT, re.MULTILINE)
        assert len(lines) == 5
        for line in lines:
            assert run_command(shlex.split(line)) == 0, line
    return folder


def read(folder: Path, scenario: str, *names: str) -> list[np.ndarray]:
    with open_result(folder / f"turbine-{scenario}.h5") as data:
        assert data.attrs["notes"] in ("", "[]"), data.attrs["notes"]
        return [data["time"].values, *(data[name].values for name in names)]


def test_steady_states(results: Path) -> None:
    """The torque of the air, linear in wind and pitch, is that of the generator at constant power."""
    for scenario, wind, shown in (("production", 15.0, "7.52"), ("wind_step", 17.0, "12.53")):
        exact = (4.18e6 + 3.5e5 * (wind - 12.0) - 97.0 * TORQUE) / 8e6
        _, speed, pitch, power = read(results, scenario, "speed[rotor]", "signal[pitch]", "signal[power]")
        assert pitch[-1] == pytest.approx(exact, rel=1e-4)
        assert speed[-1] == pytest.approx(122.9097 / 97.0, rel=1e-6)
        assert power[-1] == pytest.approx(5e6, rel=1e-5)
        assert f"{math.degrees(exact):.2f}" == shown and f"{shown} deg" in WORDS


def test_grid_fault(results: Path) -> None:
    """The impulse that is missing: 80 % of the torque for 0.15 s, and for half of both ramps of 10 ms."""
    t, speed = read(results, "grid_fault", "speed[rotor]")
    rise = 0.8 * 97.0 * TORQUE * 0.16 / J
    assert speed.max() - SPEED == pytest.approx(rise, rel=0.02)  # the torque falls a little at constant power
    assert f"rises to {speed.max() / RPM:.2f} rpm" in WORDS


def test_emergency_stop(results: Path) -> None:
    names = ("speed[rotor]", "signal[air]", "signal[brake_torque]", "signal[pitch]", "signal[torque_demand]")
    t, speed, air, friction, pitch, demand = read(results, "emergency_stop", *names)
    assert np.all((demand >= 0.0) & (demand <= 47402.9 * (1.0 + 1e-7)))  # float32
    slow = 97.0 * speed[:-1] < 70.0  # at the call before
    assert slow.any() and not demand[1:][slow].any()
    assert f"rises to {speed.max() / RPM:.1f} rpm" in WORDS
    # the pitch drive at its largest rate; a step after a jump of the demand has an error of second order
    change, most = np.diff(pitch), math.radians(8.0) * 0.0125
    assert np.median(change[(t[1:] > 11.0) & (t[1:] < 15.0)]) == pytest.approx(most, rel=1e-4)  # float32
    assert change.max() == pytest.approx(most, rel=0.01)
    # without torque of the air, dry friction of 1.5 MN m: the speed falls at a constant rate
    alone = (air == 0.0) & (t > 14.0) & (speed > 0.05)
    slope = np.polyfit(t[alone], speed[alone], 1)[0]
    # the tolerance of the iteration, 1e-11 m at 0.05 m/rad, is up to 3e-8 rad/s per step of 4e-4 rad/s
    assert slope == pytest.approx(-1.5e6 / J, rel=2e-5)
    still = t[np.argmax(speed < 0.004)]
    assert f"stops the rotor at {still:.1f} s" in WORDS
    # energy: what the air and friction did is the change of kinetic energy, with the generator before
    with open_result(results / "turbine-emergency_stop.h5") as data:
        total = data["signal[air]"] + data["signal[electric]"] + data["signal[brake_torque]"]
        work = float((total * data["speed[rotor]"]).integrate("time"))
    assert work == pytest.approx(-0.5 * J * SPEED**2, rel=1e-3)


def test_a_converter_in_python(results: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """No torque in the fault, a recovery with 20 kN m/s, and the speed that follows from the torques."""
    monkeypatch.chdir(results)
    (results / "converter.py").write_text(part("python"), encoding="utf-8")
    lines = part("yaml").splitlines(keepends=True)
    text = "".join(line for line in lines if not line.startswith("  torque: {type: rate_limit"))
    text = text.replace("controllers:\n", part("yaml", 1))
    (results / "converter.yaml").write_text(text, encoding="utf-8")
    assert run_command(["run", "converter.yaml", "-s", "grid_fault", "--allow-code"]) == 0
    with open_result("converter-grid_fault.h5") as data:
        t, torque, speed = (data[name].values for name in ("time", "signal[torque]", "speed[rotor]"))
        total = (data["signal[air]"] + data["signal[electric]"]).sel(time=slice(9.0, 11.9))
        gain = float(total.integrate("time"))
    assert np.all(torque[(t > 10.03) & (t < 10.15)] == 0.0)
    rising = (t > 10.3) & (t < 12.1)
    assert np.polyfit(t[rising], torque[rising], 1)[0] == pytest.approx(20e3, rel=2e-3)
    begun, ended = speed[(t >= 9.0) & (t <= 11.9)][[0, -1]]
    assert J * (ended - begun) == pytest.approx(gain, rel=0.02) and ended > 1.03 * begun


def test_table_of_records() -> None:
    rows = re.findall(r"^\| (\d+) \| `(\w+)` \| (\w+) \| ([^|]+) \| (.*) \|$", TEXT, re.MULTILINE)
    assert rows == [(str(r.number), r.name, r.direction, r.unit, r.meaning) for r in RECORDS]


def test_python_of_the_page(results: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(results)
    found: dict[str, float] = {}
    exec(part("python", 1), found)
    assert found["torque"] == pytest.approx(5e6 / 0.944 / 122.91, rel=1e-6)
    assert found["pitch"] == pytest.approx(
        0.1312418 + (0.018 + 0.008 * 0.0125) * (122.91 - 122.9097), rel=1e-5
    )
