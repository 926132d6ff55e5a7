# SPDX-License-Identifier: Apache-2.0
"""Data of single flanks in model files: reliefs that fit, pitch by flank, maps from files at their place."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.deviations import index_deviations
from pitchpoint.io.yaml_model import dump_model, load_model, loads_model
from pitchpoint.system.rules.separation import GAP, own_teeth
from tests.support.model_files import gear

FLANKS = {"left": 0, "right": 1}


def flank_grid(part, mate):
    """Gaps of all teeth of a gear, [flank, tooth, width, roll], and the lengths of roll they span."""
    own = own_teeth(part, mate=mate)
    none = np.zeros_like(own.smooth[0])
    rows = own.rows[:, :, GAP]
    return np.array([[own.smooth[k] if k >= 0 else none for k in flank] for flank in rows]), own.span


@pytest.mark.parametrize(
    ("keys", "where", "words"),
    [
        (
            "both: {tip_relief: {amount: 20 um, length: 40 mm}}",
            "both.tip_relief.length",
            "longer than the flank",
        ),
        (
            "left: {root_relief: {amount: 20 um, start_diameter: 100 mm}}",
            "left.root_relief.start_diameter",
            "does not lie on the usable flank",
        ),
        (
            "right: {end_relief: {amount: 5 um, length: 11 mm}}",
            "right.end_relief.length",
            "reaches over the middle of the teeth",
        ),
    ],
)
def test_reliefs_that_do_not_fit_are_found_on_reading(
    keys: str, where: str, words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "model.yaml"
    file.write_text("gears:\n" + gear("a", more=f"\n      modifications: {{{keys}}}"))
    with pytest.raises(ModelError, match=words) as caught:
        load_model(file)
    (problem,) = caught.value.problems
    assert problem.where == f"gears.a.modifications.{where}"
    assert problem.line == 3
    assert problem.limit and problem.remedy
    assert run_command(["check", str(file)]) == 2
    assert words in capsys.readouterr().err


def test_pitch_of_either_flank(tmp_path: Path) -> None:
    """Lists, files with and without a unit in the heading; each side only on its own flanks."""
    rng = np.random.default_rng(5)
    left, right = (rng.integers(-9, 9, 30) for _ in range(2))
    (tmp_path / "left.csv").write_text("f_p [um]\n" + "\n".join(str(v) for v in left) + "\n")
    given = ", ".join(f"{v} um" for v in right)
    file = tmp_path / "model.yaml"
    file.write_text(
        "gears:\n" + gear("a", more=f"deviations: {{pitch: {{left: left.csv, right: [{given}]}}}}")
    )
    model = load_model(file)
    assert loads_model(dump_model(model)) == model
    part = model.gears["a"]
    grid = flank_grid(part, mate=False)[0]
    for flank, sign, values in (("left", -1.0, left), ("right", 1.0, right)):
        expected = sign * index_deviations(1e-6 * values) * np.cos(np.radians(20.0))
        assert grid[FLANKS[flank], :, 0, 0] == pytest.approx(expected, abs=1e-15)
    file.write_text("gears:\n" + gear("a", more="deviations: {pitch: {left: left.csv}}"))
    grid = flank_grid(load_model(file).gears["a"], mate=False)[0]
    assert grid[0].any()
    assert not grid[1].any()


def test_pitch_of_either_flank_is_checked() -> None:
    with pytest.raises(ModelError) as caught:
        loads_model(
            "gears:\n" + gear("a", more="deviations: {pitch: {left: [1 um], right: [1 kg], both: []}}")
        )
    places = sorted(p.where for p in caught.value.problems)
    assert places[:2] == ["gears.a.deviations.pitch.both", "gears.a.deviations.pitch.left"]
    assert places[2].startswith("gears.a.deviations.pitch.right")


@pytest.mark.parametrize("kind", ["external", "internal"])
def test_flank_maps_from_files_reach_their_tooth_and_flank(kind: str, tmp_path: Path) -> None:
    """A map on every flank of every tooth, each another one; corners at root and tip, low and high z."""
    z = 60
    entries = []
    for tooth in range(z):
        for flank, base in (("left", 1.0), ("right", 2.0)):
            name = f"{flank}{tooth}.csv"
            rows = [[base, base + 4.0], [base + 8.0 + tooth, base + 16.0]]
            (tmp_path / name).write_text("[um]\n" + "\n".join(",".join(map(str, r)) for r in rows) + "\n")
            entries.append(f"{{tooth: {tooth}, flank: {flank}, values: {name}}}")
    file = tmp_path / "model.yaml"
    more = f"type: {kind}, deviations: {{flank_maps: [{', '.join(entries)}]}}"
    file.write_text("gears:\n" + gear("a", z, more=more))
    model = load_model(file)
    assert loads_model(dump_model(model)) == model
    grid, span = flank_grid(model.gears["a"], mate=False)
    assert grid.shape[:2] == (2, z)
    assert (span[0] > span[1]) == (kind == "internal")
    for tooth in range(z):
        for flank, base in (("left", 1.0), ("right", 2.0)):
            found = -1e6 * grid[FLANKS[flank], tooth]
            corners = [found[0, 0], found[-1, 0], found[0, -1], found[-1, -1]]
            assert corners == pytest.approx([base, base + 4.0, base + 8.0 + tooth, base + 16.0], abs=1e-9)


def test_flank_map_files_are_checked(tmp_path: Path) -> None:
    file = tmp_path / "model.yaml"
    entry = "deviations: {flank_maps: [{tooth: 0, flank: left, values: map.csv}]}"
    file.write_text("gears:\n" + gear("a", more=entry))
    for text, words in (
        ("[um]\n1,2\n3\n", "rows of different length"),
        ("[um]\n", "has 0 entries"),
        ("[kg]\n1,2\n", "kg"),
        ("[um]\n1,nan\n", "nan"),
    ):
        (tmp_path / "map.csv").write_text(text)
        with pytest.raises(ModelError, match=words):
            load_model(file)


def with_map(name: str, folder: Path):
    """Model with one gear whose left flank 3 is that of a file beside it."""
    deviations = f"deviations: {{flank_maps: [{{tooth: 3, flank: left, values: {name}}}]}}"
    (folder / "model.yaml").write_text("gears:\n" + gear("a", more=deviations))
    return load_model(folder / "model.yaml")


def test_a_map_may_come_from_numpy_with_one_unit_for_all(tmp_path: Path) -> None:
    """np.savetxt puts blanks between the numbers."""
    values = np.round(np.random.default_rng(5).normal(scale=4.0, size=(5, 3)), 3)
    np.savetxt(tmp_path / "blanks.txt", values, header="[um]", comments="")
    (tmp_path / "commas.csv").write_text("\n".join(",".join(f"{v} um" for v in row) for row in values))
    found = []
    for name in ("blanks.txt", "commas.csv"):
        found.append(with_map(name, tmp_path).gears["a"].deviations.flank_maps[0].values)
    assert np.array(found[0]) == pytest.approx(1e-6 * values, rel=1e-12)
    assert np.array(found[1]) == pytest.approx(np.array(found[0]), rel=1e-12)


def test_bad_numbers_of_a_file_are_told_with_file_and_line(tmp_path: Path) -> None:
    (tmp_path / "map.txt").write_text("0 1e-6\n0, 2 bananas\n" + "x\n" * 9)
    with pytest.raises(ModelError) as caught:
        with_map("map.txt", tmp_path)
    found = [str(problem) for problem in caught.value.problems]
    assert "(file 'map.txt', line 2)" in found[0]
    assert "bananas" in found[0]
    assert "there are 5 more such lines in 'map.txt'" in found[-1]
    assert len(found) == 6
