# SPDX-License-Identifier: Apache-2.0
"""Large model files: reading them shows how far it is, small ones stay silent."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.cli import progress, reading
from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model
from tests.support.cli_files import TORSION, written

ROWS = "".join(f"        - [{k * 1e-4:.4f}, {150 + k % 7}]\n" for k in range(3000))
LARGE = TORSION.replace(
    "input:  {body: driver, torque: 150 N m}", f"input:\n    body: driver\n    torque:\n      table:\n{ROWS}"
)


def test_reading_tells_how_far_it_is(tmp_path: Path) -> None:
    heard: list[tuple[float, float]] = []
    model = load_model(
        written(tmp_path, LARGE), progress=lambda done, total, note="": heard.append((done, total))
    )
    assert model == load_model(written(tmp_path, LARGE))
    assert {total for _, total in heard} == {len(LARGE)}
    done = [d for d, _ in heard]
    assert len(done) > 10
    assert done == sorted(done)
    assert 0.8 * len(LARGE) < done[-1] <= len(LARGE)


@pytest.mark.parametrize("command", ["check", "gears", "mesh"])
def test_commands_show_it_for_large_files(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(progress, "PATIENCE", 0.0)
    assert run_command([command, written(tmp_path, TORSION)]) == 0
    assert capsys.readouterr().err == ""
    monkeypatch.setattr(reading, "LARGE", 10_000)
    assert run_command([command, written(tmp_path, LARGE)]) == 0
    assert "read " in capsys.readouterr().err


def test_a_forbidden_character_far_down_keeps_its_line(tmp_path: Path) -> None:
    lines = LARGE.splitlines()
    lines[2000] += " # \x07"
    with pytest.raises(ModelError) as refused:
        load_model(written(tmp_path, "\n".join(lines)))
    assert refused.value.problems[0].line == 2001
