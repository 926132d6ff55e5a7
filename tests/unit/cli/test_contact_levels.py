# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint contact-levels`: table, JSON, and the printed parts of a model file."""

from __future__ import annotations

from pathlib import Path

import pytest
from ruamel.yaml import YAML

from pitchpoint.cli.contact import contact
from pitchpoint.cli.contact_levels import contact_levels
from pitchpoint.cli.main import run_command
from pitchpoint.cli.relief import relief
from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.contact_analysis import levels
from tests.support.cli_files import json_of, written

MODEL = """
gears:
  g1: {number_of_teeth: 16, normal_module: 4.5 mm, face_width: 14 mm, profile_shift_coefficient: 0.1817}
  g2: {number_of_teeth: 24, normal_module: 4.5 mm, face_width: 14 mm, profile_shift_coefficient: 0.1715}
bodies:
  a: {gears: [g1], motion: torsion}
  b: {gears: [g2], motion: torsion}
meshes:
  stage:
    gears: [g1, g2]
    center_distance: 91.5 mm
    contact: {level: flexible, planes: 3}
"""


@pytest.fixture
def file(tmp_path: Path) -> str:
    return written(tmp_path, MODEL)


@pytest.mark.study
def test_printed_lines_are_parts_of_a_model_file(
    file: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = ["--torque", "302 N m", "--table", "small", "--misalignment", "5 um"]
    page = tmp_path / "levels.html"
    assert run_command(["contact-levels", file, *options, "--picture", str(page)]) == 0
    text = page.read_text(encoding="utf-8")
    assert text.count('<div class="plot"') == 4
    assert "contact overlap small" in text
    assert "root stress" not in text  # the page has no values of it
    text = capsys.readouterr().out
    for words in ("rigid", "flexible", "pre-computed", "law din3990", "computed for this comparison"):
        assert words in text
    found = json_of(["contact-levels", file, *options], capsys)
    parts = [
        YAML(typ="safe").load(line)
        for line in text.splitlines()
        if line.startswith(("stiffness:", "contact:"))
    ]
    law, rigid = parts[0]["stiffness"], parts[1]["contact"]
    model = load_model(file).replace_all({"meshes.stage.stiffness": law, "meshes.stage.contact": None})
    assert model.meshes["stage"].stiffness.single_stiffness == pytest.approx(
        found["law"]["single_stiffness"], rel=1e-5
    )
    rigid_model = load_model(file).replace("meshes.stage.contact", rigid)
    assert rigid_model.meshes["stage"].contact.stiffness == pytest.approx(
        found["rigid"]["stiffness"], rel=1e-5
    )
    assert found["flank"] == 1
    assert "302 N m, front flanks: levels of contact" in text
    assert found["misalignment"] == pytest.approx(5e-6 / 14e-3)
    assert set(found["levels"]) == {"rigid", "flexible", "precomputed", "law"}
    assert found["levels"]["precomputed"]["force_max"] < 0.02


@pytest.mark.parametrize(
    ("torque", "options", "expected"),
    [
        ("150 N m", [], (150.0, 1)),
        ("-150 N m", [], (150.0, -1)),
        ("-150 N m", ["--flank", "front"], (150.0, 1)),
        ("-150 N m", ["--torque", "200 N m"], (200.0, 1)),
        ("150 N m", ["--torque", "200 N m", "--flank", "back"], (200.0, -1)),
    ],
)
def test_the_flank_is_that_of_the_loads(
    torque: str,
    options: list[str],
    expected: tuple[float, int],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The sign of the default torque, as of `contact` and `relief`."""
    seen = []

    def compared(*_: object, torque: float, flank: int, **__: object) -> None:
        """Instead of the comparison."""
        seen.append((torque, flank))
        raise SolverError("stopped", INCONSISTENT)

    monkeypatch.setattr(levels, "compare_levels", compared)
    loads = f"loads:\n  drive: {{body: a, torque: {torque}}}\n  brake: {{body: b, torque: balance}}\n"
    assert run_command(["contact-levels", written(tmp_path, MODEL + loads), *options]) != 0
    assert seen == [expected]


def test_commands_share_the_option_of_the_flank() -> None:
    """Same name, same choices, same help."""
    own = [next(p for p in one.params if p.name == "flank") for one in (contact, relief, contact_levels)]
    assert len({(p.opts[0], tuple(p.type.choices), p.help) for p in own}) == 1  # type: ignore[attr-defined]
    assert "sign of the default torque" in own[0].help  # type: ignore[attr-defined]


def test_torque_is_required_without_loads(file: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["contact-levels", file]) == 2
    assert "give --torque" in capsys.readouterr().err
