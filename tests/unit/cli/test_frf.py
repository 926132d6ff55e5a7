# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint frf` and the animation of `pitchpoint modes`."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.reading import open_result
from tests.support.cli_files import TORSION, json_of, written

ERROR = ["-i", "transmission_error[stage]", "-r", "mesh_force[stage]"]


def test_response_to_the_error_of_the_flanks(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Free pair with damping ratio zeta: H = -(k + d s) m s^2/(m s^2 + d s + k), at its resonance."""
    file, target, page = written(tmp_path, TORSION), tmp_path / "frf.h5", tmp_path / "frf.html"
    r_b = 0.075 * math.cos(math.radians(20.0))
    m = 0.0115 / (2.0 * r_b**2)
    resonance = math.sqrt(4.0e8 / m) / (2.0 * math.pi)
    limits = ["--from", f"{0.5 * resonance} Hz", "--to", f"{resonance} Hz", "--points", "2", "--linear"]
    found = json_of(["frf", file, *ERROR, *limits, "-o", str(target), "--picture", str(page)], capsys)
    s = 2j * math.pi * np.array(found["frequency"])
    d = 2.0 * 0.05 * math.sqrt(4.0e8 * m)
    expected = -(4.0e8 + d * s) * m * s**2 / (m * s**2 + d * s + 4.0e8)
    response = np.array(found["real"])[:, 0, 0] + 1j * np.array(found["imag"])[:, 0, 0]
    assert response == pytest.approx(expected, rel=1e-6)
    assert found["outputs"] == [{"name": "mesh_force[stage]", "unit": "N"}]
    with open_result(target) as data:
        assert data["response"].values.real[1, 0, 0] == found["real"][1][0][0]
    assert "plotly" in page.read_text(encoding="utf-8")


def test_people_get_a_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["frf", written(tmp_path, TORSION), *ERROR, "--to", "5 kHz", "--points", "50"]) == 0
    assert "mesh_force[stage] by transmission_error[stage]" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "answers"),
    [
        (
            ["-i", "driver.spn", "-r", "mesh_forces[stage]", "--synchronous", "drivr", "--to", "9 Hz"],
            [
                "3 problems",
                "no input is called 'driver.spn'; did you mean driver.spin",
                "no output is called 'mesh_forces[stage]'; did you mean mesh_force[stage]",
                "no body is called 'drivr'; did you mean driver",
            ],
        ),
        (
            [
                "-r",
                "velocity[driver.spn]",
                "--mesh-orders",
                "2",
                "--speed-of",
                "drive",
                "--to-speed",
                "9 rpm",
            ],
            ["2 problems", "no output is called 'driver.spn'", "no body is called 'drive'"],
        ),
    ],
)
def test_unknown_names_are_bad_input(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], options: list[str], answers: list[str]
) -> None:
    """All of them are refused before the computation, with the nearest names; not a failed computation."""
    assert run_command(["frf", written(tmp_path, TORSION), *options]) == 2
    told = capsys.readouterr().err
    assert [answer for answer in answers if answer not in told] == []
    assert "status" not in told


@pytest.mark.parametrize("suffix", ["json", "npz"])
def test_modes_for_animation(tmp_path: Path, capsys: pytest.CaptureFixture[str], suffix: str) -> None:
    target = tmp_path / f"modes.{suffix}"
    found = json_of(["modes", written(tmp_path, TORSION), "--animation", str(target)], capsys)
    if suffix == "json":
        data = {k: np.array(v) for k, v in json.loads(target.read_text(encoding="utf-8")).items()}
    else:
        data = dict(np.load(target))
    assert data["motion"].shape == (2, 24, 3, 6)
    assert list(data["bodies"]) == ["ground", "driver", "driven"]
    assert data["frequency"].tolist() == [row["frequency"] for row in found["modes"]]
    # turns of the gears at radius 0.1 m reach 10 mm; both halves of the cycle are opposite
    assert np.abs(data["motion"][..., 5]).max() == pytest.approx(0.1, rel=1e-9)
    assert data["motion"][:, 12] == pytest.approx(-data["motion"][:, 0], abs=1e-15)


ORDERS = ["--mesh-orders", "2", "--speed-of", "driver", "--to-speed", "2000 rpm", "-r", "mesh_force[stage]"]


def test_levels_by_mesh_order(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """JSON, file and page of the response to the loaded transmission error."""
    file, target, page = written(tmp_path, TORSION), tmp_path / "orders.h5", tmp_path / "orders.html"
    command = ["frf", file, *ORDERS, "--points", "20", "-o", str(target), "--picture", str(page)]
    found = json_of(command, capsys)
    assert [(o["mesh"], o["harmonic"]) for o in found["orders"]] == [("stage", 1), ("stage", 2)]
    assert found["outputs"] == [{"name": "mesh_force[stage]", "unit": "N", "reference": 1e-6}]
    assert np.shape(found["level"]) == (1, 20, 2)
    with open_result(target) as data:
        rms = data["amplitude"].values[:, 0, 0] / math.sqrt(2.0)
    known = rms > 0.0
    expected = 20.0 * np.log10(rms[known] / 1e-6)
    assert np.array(found["level"], float)[0, known, 0] == pytest.approx(expected, abs=1e-4)
    assert "plotly" in page.read_text(encoding="utf-8")
    assert run_command(["frf", file, *ORDERS]) == 0
    printed = capsys.readouterr().out
    assert "mesh_force[stage], 1 × stage" in printed
    assert "dB re 1 µN" in printed


@pytest.mark.parametrize(
    ("more", "message"),
    [
        (["--mesh-orders", "2"], "--mesh-orders needs the speeds"),
        ([*ORDERS, "--to", "1 kHz"], "--to has no effect with --mesh-orders"),
        (["--to", "1 kHz"], "--input is required"),
        ([*ERROR[:2], "--to", "1 kHz", "--speed-of", "driver"], "require --mesh-orders"),
    ],
)
def test_options_that_do_not_fit(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], more: list[str], message: str
) -> None:
    assert run_command(["frf", written(tmp_path, TORSION), "-r", "mesh_force[stage]", *more]) == 2
    assert message in capsys.readouterr().err


def test_a_report_shows_the_responses_of_files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Amplitude and phase of a response, and levels by mesh order, without a remark that they are missing."""
    file = written(tmp_path, TORSION)
    bode, levels, page = (str(tmp_path / name) for name in ("frf.h5", "orders.h5", "page.html"))
    ends = ["--to", "5 kHz", "--points", "20"]
    by_order = ["--mesh-orders", "1", "--speed-of", "driver", "--to-speed", "3000 rpm", "--points", "5"]
    json_of(["frf", file, *ERROR, *ends, "-o", bode], capsys)
    json_of(["frf", file, "-r", "mesh_force[stage]", *by_order, "-o", levels], capsys)
    assert run_command(["report", file, bode, levels, "-o", page]) == 0
    assert "not shown" not in "".join(capsys.readouterr())
    text = Path(page).read_text(encoding="utf-8")
    section = text.partition('<section id="responses"')[2].partition("</section>")[0]
    assert "mesh force, stage by transmission error, stage" in section and "phase [deg]" in section
    assert "speed of driver" in section
