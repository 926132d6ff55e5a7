# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint rexs`: differences between two gear units."""

from __future__ import annotations

import pytest

from pitchpoint.cli.main import run_command
from tests.support.cli_files import json_of
from tests.support.rexs_files import GEARBOX, as_json

CHANGED = (
    GEARBOX.replace('id="face_width" unit="mm">20', 'id="face_width" unit="mm">22')
    .replace('id="torque_around_u_axis" unit="N m">40', 'id="torque_around_u_axis" unit="N m">45')
    .replace('<relation id="7" type="assembly"><ref id="3"', '<relation id="7" type="assembly"><ref id="4"')
)


@pytest.fixture
def files(tmp_path):
    paths = [tmp_path / name for name in ("a.rexs", "b.rexsj", "c.rexs")]
    for path, text in zip(paths, (GEARBOX, as_json(GEARBOX), CHANGED), strict=True):
        path.write_text(text, encoding="utf-8")
    return [str(path) for path in paths]


def test_equal_gear_units(files, capsys):
    assert run_command(["rexs", "diff", files[0], files[1]]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "A: a.rexs: REXS 1.4 by a program 1, 20 components"
    assert lines[-1] == "no differences"
    found = json_of(["rexs", "diff", files[0], files[1]], capsys)
    assert (found["equal"], found["differences"]) == (True, [])


def test_differences_are_listed_by_kind(files, capsys):
    assert run_command(["rexs", "diff", files[1], files[2], "-q"]) == 0
    out = capsys.readouterr().out
    for text in ("moved", "changed", "load case 1", "pinion of cylindrical_stage 13", "face width", "+5 N m"):
        assert text in out
    assert out.rstrip().endswith("3 differences: 1 moved, 2 changed")
    found = json_of(["rexs", "diff", files[1], files[2]], capsys)
    moved, width, torque = found["differences"]
    assert moved["kind"] == "moved"
    assert (width["attribute"], width["si_a"], width["si_b"]) == ("face_width", 0.02, 0.022)
    assert (torque["load_case"], torque["si_b"]) == ("1", 45.0)


def test_a_file_that_is_not_rexs_is_refused(files, tmp_path, capsys):
    other = tmp_path / "x.rexs"
    other.write_text("gears:\n", encoding="utf-8")
    assert run_command(["rexs", "diff", files[0], str(other)]) == 2
    assert "is not a REXS file" in capsys.readouterr().err
