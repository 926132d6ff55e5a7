# SPDX-License-Identifier: Apache-2.0
"""A report shows contact analyses, from files and from datasets."""

from __future__ import annotations

from pathlib import Path

import pytest

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from tests.support.contact_files import fzg

LOADS = "loads:\n  input: {body: a, torque: 302 N m}\n"


def test_report_with_a_file_and_a_dataset(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    model = fzg(tmp_path, planes=5, more=LOADS)
    target, page = tmp_path / "c.h5", tmp_path / "c.html"
    file = str(tmp_path / "fzg.yaml")
    assert run_command(["contact", file, "--positions", "8", "-o", str(target), "-q"]) == 0
    assert run_command(["report", file, str(target), "-o", str(page), "-q"]) == 0
    text = page.read_text(encoding="utf-8")
    assert '<section id="contact"' in text
    assert "contact analysis" in text
    data = pp.solve_contact(model, torque=[100.0, 302.0], positions=8)
    pp.write_report(model, page, data, target)
    text = page.read_text(encoding="utf-8")
    assert "<h3>stage</h3>" in text
    assert "<h3>stage (c.h5)</h3>" in text


def test_a_file_without_its_variables_is_reported(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    import h5py

    fzg(tmp_path, planes=5, more=LOADS)
    target, file = tmp_path / "c.h5", str(tmp_path / "fzg.yaml")
    assert run_command(["contact", file, "--positions", "8", "-o", str(target), "-q"]) == 0
    with h5py.File(target, "a") as stored:
        del stored["plane_force"]
    assert run_command(["report", file, str(target), "-o", str(tmp_path / "c.html"), "-q"]) == 2
    assert "c.h5: is not a readable HDF5 file" in capsys.readouterr().err
