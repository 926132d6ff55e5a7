# SPDX-License-Identifier: Apache-2.0
"""A report shows one machine: results of another one are refused, other values are a remark."""

from __future__ import annotations

from pathlib import Path

import pytest

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from tests.unit.report.test_write import TEXT


@pytest.fixture
def files(tmp_path: Path) -> tuple[Path, Path]:
    model, run = tmp_path / "pair.yaml", tmp_path / "run.h5"
    model.write_text(TEXT, encoding="utf-8")
    assert run_command(["run", str(model), "-s", "steady", "-q", "-o", str(run)]) == 0
    return model, run


def test_a_result_of_another_machine_is_refused(
    files: tuple[Path, Path], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    _, run = files
    other = tmp_path / "other.yaml"
    other.write_text(TEXT.replace("driven", "wheel").replace("stage", "m"), encoding="utf-8")
    page = tmp_path / "page.html"
    assert run_command(["report", str(run), str(other), "-q", "-o", str(page)]) == 2
    words = capsys.readouterr().err
    for part in (
        "run.h5",
        "bodies driven and meshes stage, which the model lacks",
        "bodies wheel and meshes m",
    ):
        assert part in words
    assert not page.exists()
    result = pp.solve_time(pp.compile_model(pp.load_model(files[0]), "steady"))
    with pytest.raises(ModelError, match="result 1: was computed with another machine") as caught:
        pp.write_report(other, page, result, run)
    assert len(caught.value.problems) == 2


def test_other_values_stay_a_remark(files: tuple[Path, Path], tmp_path: Path) -> None:
    _, run = files
    other = tmp_path / "other.yaml"
    other.write_text(TEXT.replace("0.0115 kg", "0.0120 kg"), encoding="utf-8")
    notes: list[str] = []
    pp.write_report(other, tmp_path / "page.html", run, on_note=notes.append)
    assert any("run.h5 was computed with" in text for text in notes)
