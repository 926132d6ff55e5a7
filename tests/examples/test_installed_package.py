# SPDX-License-Identifier: Apache-2.0
"""What `pip install pitchpoint` brings is enough for the first page: no file of the checkout is used."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from tests.support.fresh_environment import borrow, build_wheel, first_five_minutes


@pytest.mark.study
def test_the_first_five_minutes_of_an_installed_wheel(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Other packages are those of this environment; ``make newest-numba`` installs them, too."""
    monkeypatch.delenv("PYTHONPATH", raising=False)  # it may lead to a checkout
    wheel = build_wheel(tmp_path)
    python = borrow(tmp_path / "environment", wheel)
    ask = "import pitchpoint, sys; print(pitchpoint.__file__); print(*sys.path, sep='\\n')"
    done = subprocess.run([python, "-c", ask], cwd=tmp_path, capture_output=True, text=True, check=True)
    where, *path = done.stdout.splitlines()
    assert Path(where).is_relative_to(tmp_path)
    checkout = Path(__file__).parents[2]
    assert not [p for p in path if p and Path(p).is_relative_to(checkout / "src")]
    work = tmp_path / "work"
    steps = {step.command: step for step in first_five_minutes(python, work)}
    assert "1.568" in steps["gears pair.yaml"].output
    assert "2731" in steps["modes pair.yaml"].output
    assert (work / "pair.html").stat().st_size > 1e5
