# SPDX-License-Identifier: Apache-2.0
"""`new` writes models that run at once; `schema` writes the schema that they refer to."""

from __future__ import annotations

import json

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.cli.new import STARTERS, starter_text
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.collect import odd_shapes, remarks_of, remarks_of_file
from pitchpoint.model.schema import json_schema
from tests.support.cli_files import json_of


@pytest.mark.parametrize("kind", STARTERS)
def test_a_new_model_has_no_problems_and_runs(kind, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run_command(["new", kind]) == 0
    assert f"pitchpoint check {kind}.yaml" in capsys.readouterr().out
    text = (tmp_path / f"{kind}.yaml").read_text()
    model = loads_model(text, file=f"{kind}.yaml")
    assert not [*remarks_of(model), *odd_shapes(model), *remarks_of_file(model)]
    assert text.count("\n# ") >= 4  # it explains itself
    found = json_of(["modes", f"{kind}.yaml", "-s", "steady"], capsys)
    assert max(mode["frequency"] for mode in found["modes"]) > 100.0
    short = ["--set", "scenarios.steady.duration=1 ms"]
    assert json_of(["run", f"{kind}.yaml", "-s", "steady", *short], capsys)["status"] == "finished"


def test_an_existing_file_is_overwritten_by_force_only(tmp_path, capsys):
    target = tmp_path / "model.yaml"
    target.write_text("mine")
    assert run_command(["new", "pair", "-o", str(target)]) == 2
    assert "exists; use --force to overwrite" in capsys.readouterr().err
    assert target.read_text() == "mine"
    assert run_command(["new", "pair", "-o", str(target), "--force"]) == 0
    assert target.read_text() == starter_text("pair")
    assert run_command(["new", "triple"]) == 2


def test_a_new_model_refers_to_the_schema_next_to_it(tmp_path, capsys):
    schema = tmp_path / "pitchpoint.schema.json"
    for _ in range(2):  # its own file may be replaced
        assert run_command(["schema", "-o", str(schema)]) == 0
    assert json.loads(schema.read_text()) == json.loads(json.dumps(json_schema()))
    line = "# yaml-language-server: $schema=pitchpoint.schema.json"
    assert capsys.readouterr().out.rstrip().endswith(line)
    assert run_command(["new", "rotor", "-o", str(tmp_path / "r.yaml")]) == 0
    text = (tmp_path / "r.yaml").read_text()
    assert text == f"{line}\n{starter_text('rotor')}"
    loads_model(text)
    capsys.readouterr()
    assert run_command(["schema"]) == 0
    assert json.loads(capsys.readouterr().out)["title"] == "pitchpoint model file"
    (tmp_path / "other.json").write_text("{}")
    assert run_command(["schema", "-o", str(tmp_path / "other.json")]) == 2
