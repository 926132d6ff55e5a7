# SPDX-License-Identifier: Apache-2.0
"""Laws of users that the compiler cannot take run in Python: what happens in them gets out."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.reading import read_channel, read_header
from tests.support.cli_files import TORSION, written

LAW = """\
import json


def torque(t, x, p):
    json.dumps({{}})  # nothing for the compiler
    if t > 0.01:
        raise {what}
    return 150.0
"""


@pytest.mark.parametrize(
    ("what", "code", "status", "words"),
    [
        ("KeyboardInterrupt", 130, "interrupted", "interrupted by the user; the result so far is kept"),
        ("SystemExit(7)", 3, "failed", "law.py:torque raised SystemExit: 7"),
        ("OSError('no such sensor')", 3, "failed", "law.py:torque raised OSError: no such sensor"),
    ],
)
def test_what_a_law_raises_stops_the_run_and_keeps_the_result(
    what: str, code: int, status: str, words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "law.py").write_text(LAW.format(what=what))
    text = TORSION.replace("duration: 0.5 s", "duration: 0.02 s, settle_time: 0 s").replace(
        "input:  {body: driver, torque: 150 N m}", "input:  {body: driver, torque: {python: 'law.py:torque'}}"
    )
    target = tmp_path / "out.h5"
    command = ["run", written(tmp_path, text), "-s", "steady", "-o", str(target), "--json", "--allow-code"]
    assert run_command(command) == code
    captured = capsys.readouterr()
    assert json.loads(captured.out)["status"] == status
    assert words in captured.err
    assert "Traceback" not in captured.err
    header = read_header(target)
    assert header["status"] == status
    assert words in header["sentence"]
    t, _ = read_channel(target, "mesh_force[stage]")
    assert t.size > 0
    assert t[-1] <= 0.01 + 2e-5
