# SPDX-License-Identifier: Apache-2.0
"""The section on measured files: its lines and its commands are tried as they stand there."""

from __future__ import annotations

import doctest
import re
import shlex
from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command

PAGE = Path(__file__).parents[2] / "docs" / "diagnosis.md"
SECTION = PAGE.read_text(encoding="utf-8").partition("## Measured files\n")[2].partition("\n## ")[0]


def test_lines_and_commands(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (lines,) = re.findall(r"^```python\n(.*?)^```", SECTION, re.DOTALL | re.MULTILINE)
    test = doctest.DocTestParser().get_doctest(lines, {}, "measured files", str(PAGE), 0)
    assert test.examples
    assert doctest.DocTestRunner().run(test).failed == 0, capsys.readouterr().out
    (block,) = re.findall(r"^```console\n(.*?)^```", SECTION, re.DOTALL | re.MULTILINE)
    for line in block.splitlines():
        assert run_command(shlex.split(line)[1:]) == 0, line
    assert (tmp_path / "case.html").stat().st_size > 1e5
    assert "order [1],amplitude [m/s]" in (tmp_path / "orders.csv").read_text(encoding="utf-8")
