# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint report`: model and result files become one page; the model may come from a result file."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.cli.progress import ProgressDisplay
from pitchpoint.io.container import Header
from pitchpoint.io.sweep_store import SweepWriter
from pitchpoint.io.writing import Channel, ResultWriter
from tests.support.cli_files import ISO_EX1, TORSION, written


def write_run(path: Path, text: str = "", status: str = "finished") -> str:
    """Write a short run with one channel."""
    t = np.arange(0.0, 0.1, 1e-4)
    header = Header("time", "x", "steady", model_text=text, options={"settle_time": 0.02})
    writer = ResultWriter(path, header, [Channel("deflection[stage]", "m", "deflection")])
    writer.append(t, 1e-6 * np.sin(2e3 * t)[:, None])
    writer.finish(status, "the Newton iteration diverged")
    return str(path)


def write_sweep(path: Path) -> str:
    """Write a sweep of two points."""
    values = {"mean": 0.0, "rms": 1e-6, "min": -1e-6, "max": 1e-6}
    point = dict.fromkeys(("transmission_error", "deflection", "mesh_force"), values)
    with SweepWriter(
        path, Header("sweep", scenario="sweep"), "stage", ["up"], [20.0, 40.0], [1e3, 2e3]
    ) as sweep:
        for k in range(2):
            sweep.put("up", k, point | {"contact_loss_share": 0.1 * k, "back_contact_share": 0.0})
    return str(path)


def test_model_alone(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, ISO_EX1)
    assert run_command(["report", file]) == 0
    page = (tmp_path / "model.html").read_text(encoding="utf-8")
    assert "ISO/TR 6336-30 example 1" in page
    assert "ISO 21771:2007" in page
    assert "model.html" in capsys.readouterr().out


def test_model_with_results(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    steps: list[str] = []
    monkeypatch.setattr(ProgressDisplay, "aside", lambda _, words: steps.append(words))
    file = written(tmp_path, TORSION)
    results = [write_run(tmp_path / "run.h5", status="failed"), write_sweep(tmp_path / "sweep.h5")]
    target = tmp_path / "page.html"
    assert run_command(["report", file, *results, "-o", str(target), "--quiet"]) == 0
    assert capsys.readouterr().out == ""
    page = target.read_text(encoding="utf-8")
    assert "This run is not complete: failed. the Newton iteration diverged" in page
    assert "Speed sweep" in page
    said = " ".join(steps)
    for part in (
        "result run.h5",
        "critical speeds of order",
        "power flow of steady",
        "scene, 0 %",
        "page, 50 %",
    ):
        assert part in said, part


def test_the_model_of_a_result_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    result = write_run(tmp_path / "run.h5", text=TORSION)
    assert run_command(["report", result]) == 0
    assert "torsional pair" in (tmp_path / "run.html").read_text(encoding="utf-8")
    bare = write_run(tmp_path / "bare.h5")
    assert run_command(["report", bare]) == 2
    assert "give the model file, too" in capsys.readouterr().err


def test_values_of_set(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The page shows the changed model; without a model file nothing can be changed."""
    file = written(tmp_path, TORSION)
    assert run_command(["report", file, "--set", "title=two changed wheels", "--quiet"]) == 0
    assert "two changed wheels" in (tmp_path / "model.html").read_text(encoding="utf-8")
    result = write_run(tmp_path / "run.h5", text=TORSION)
    assert run_command(["report", result, "--set", "title=x"]) == 2
    assert "--set has no effect without a model file" in capsys.readouterr().err


def test_bad_input(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "no.h5").write_text("no")
    assert run_command(["report", str(tmp_path / "no.h5")]) == 2
    one, two = written(tmp_path, ISO_EX1, "one.yaml"), written(tmp_path, ISO_EX1, "two.yaml")
    assert run_command(["report", one, two]) == 2
    assert "Traceback" not in capsys.readouterr().err


def test_the_model_alone_has_what_follows_from_it(tmp_path: Path) -> None:
    """Errors with and without load, load sharing, modes, Campbell diagram: computed by the report itself."""
    text = TORSION.replace(
        "{law: fourier, mean: 4.0e8 N/m, cosine: [-0.2, -0.1, -0.05]}", "{law: din3990}"
    ).replace(
        "output: {body: driven, torque: 150 N m}", "output: {body: driven, torque: 150 N m * cos(angle)}"
    )
    assert run_command(["report", written(tmp_path, text), "-o", str(tmp_path / "page.html")]) == 0
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    for words in (
        "without load (mean 50",
        "mesh force 2128 N (mean 5",
        "load share",
        "mesh mode of stage",
        "2× mesh stage",
        "Campbell diagram",
    ):
        assert words in page, words


def test_what_cannot_be_computed_is_said(tmp_path: Path) -> None:
    (tmp_path / "law.py").write_text("def torque(t, x, p):\n    return float('nan')\n")
    text = TORSION.replace("driven, torque: 150 N m", "driven, torque: {python: 'law.py:torque'}")
    target = tmp_path / "page.html"
    assert run_command(["report", written(tmp_path, text), "-o", str(target), "--allow-code"]) == 0
    assert "No slow roll: " in target.read_text(encoding="utf-8")


def test_results_of_another_state_of_the_model_are_marked(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """On the page and on the terminal, with the values that `--set` changed."""
    file, target = written(tmp_path, TORSION.replace("0.5 s", "0.01 s")), tmp_path / "page.html"
    result = str(tmp_path / "run.h5")
    assert run_command(["run", file, "-s", "steady", "-o", result, "-q"]) == 0
    assert run_command(["report", file, result, "-o", str(target)]) == 0
    assert "different version of the model" not in target.read_text(encoding="utf-8")
    assert "note:" not in capsys.readouterr().out
    other = str(tmp_path / "set.h5")
    load = "loads.output.torque=100 N m"
    assert run_command(["run", file, "-s", "steady", "-o", other, "-q", "--set", load]) == 0
    assert run_command(["report", file, other, "-o", str(target)]) == 0
    words = "set.h5 was computed with loads.output.torque = 100 N m (the model: 150 N m)."
    assert words in target.read_text(encoding="utf-8")
    assert f"note: {words}" in capsys.readouterr().out
    changed = TORSION.replace("150 N m", "100 N m").replace("0.0115", "0.02").replace("0.1 mm", "0.2 mm")
    written(tmp_path, changed)  # too many values for a list
    assert run_command(["report", file, result, "-o", str(target)]) == 0
    assert "note: run.h5 was computed with a different version of the model." in capsys.readouterr().out
    assert run_command(["report", file, result, "-o", str(target), "-q"]) == 0
    assert capsys.readouterr().out == ""
