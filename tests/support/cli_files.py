# SPDX-License-Identifier: Apache-2.0
"""The two model files that the command line must read verbatim, and how to run a command on them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from pitchpoint.cli.main import run_command
from tests.support.model_files import ISO_EXAMPLE as ISO_EX1
from tests.support.model_files import TORSIONAL_PAIR as TORSION

__all__ = ["ISO_EX1", "TORSION", "json_of", "written"]


def written(folder: Path, text: str, name: str = "model.yaml") -> str:
    """Write a model file and return its path."""
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return str(path)


def json_of(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> Any:
    """Run a command with --json and return what it prints; stdout must be JSON and nothing else."""
    code = run_command([*arguments, "--json"])
    captured = capsys.readouterr()
    assert code == 0, captured.err
    return json.loads(captured.out)
