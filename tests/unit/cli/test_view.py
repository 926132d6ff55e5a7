# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint view`: one page from a model, a result or two results, and what it refuses."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import h5py
import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.reading import open_result
from tests.support.model_files import TORSIONAL_PAIR
from tests.support.scene_reader import Seen


@pytest.fixture(scope="module")
def result(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("view")
    model = folder / "pair.yaml"
    model.write_text(TORSIONAL_PAIR.replace("duration: 0.5 s", "duration: 0.05 s"), encoding="utf-8")
    out = folder / "pair.h5"
    assert run_command(["run", str(model), "--scenario", "steady", "-o", str(out), "-q"]) == 0
    return out


def scenes(page: Path) -> list[Seen]:
    text = page.read_text(encoding="utf-8")
    found = []
    for mark in ("", "-2"):
        parts = [
            re.search(rf'id="{name}{mark}">(.*?)</script>', text, re.DOTALL)
            for name in ("pp-scene", "pp-scene-numbers")
        ]
        if all(parts):
            found.append(Seen(*(part.group(1).replace("<\\/", "</") for part in parts if part)))
    return found


def test_a_result_keeps_its_model(result: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = result.with_name("scene.html")
    assert run_command(["view", str(result), "-o", str(page)]) == 0
    assert "scene written to" in capsys.readouterr().out
    (scene,) = scenes(page)
    assert {s["name"] for s in scene.header["solids"] if s["kind"] == "gear"} == {"g1", "g2"}
    assert [a["name"] for a in scene.header["arrows"]] == ["stage"]
    assert len(scene.times) > 500
    text = page.read_text(encoding="utf-8")
    # nothing is fetched: no element with a source of its own, and a policy that forbids it
    assert not re.search(r"<(script|link|img|iframe)[^>]*(src|href)=", text)
    assert "default-src 'none'" in text
    assert page.stat().st_size < 3e6


def test_a_model_alone_and_two_side_by_side(result: Path) -> None:
    model, page = result.with_name("pair.yaml"), result.with_name("both.html")
    assert run_command(["view", str(model), "-q"]) == 0
    (alone,) = scenes(model.with_suffix(".view.html"))
    assert len(alone.times) == 1
    assert run_command(["view", str(model), str(result), "-o", str(page), "-q"]) == 0
    found = scenes(page)
    assert [len(s.times) > 1 for s in found] == [False, True]
    assert [s.header["label"] for s in found] == ["pair.yaml", "pair.h5"] and "label" not in alone.header


def test_modes_of_a_result_and_of_a_model_are_the_same(
    result: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Shapes without damping in the one, with it in the other; frequencies are undamped in both."""
    modes, model = result.with_name("modes.h5"), str(result.with_name("pair.yaml"))
    pages = [result.with_name(f"modes-{k}.html") for k in range(2)]
    assert run_command(["modes", model, "-o", str(modes), "-q"]) == 0
    assert run_command(["view", str(modes), "-o", str(pages[0]), "-q"]) == 0
    assert run_command(["view", model, "--modes", "2", "-o", str(pages[1]), "-q"]) == 0
    kept, computed = (scenes(page)[0].header["modes"] for page in pages)
    assert len(kept) == len(computed) == 2
    for one, other in zip(kept, computed, strict=True):
        assert one["name"] == other["name"]
        assert one["frequency"] == pytest.approx(other["frequency"], rel=1e-6, abs=1e-3)
    capsys.readouterr()
    assert run_command(["view", model, str(result), "--modes", "2", "-o", str(pages[1])]) == 2
    assert "only be shown for one" in capsys.readouterr().err


def test_what_does_not_move_is_refused(result: Path, capsys: pytest.CaptureFixture[str]) -> None:
    still = result.with_name("still.h5")
    model = str(result.with_name("pair.yaml"))
    response = [
        "-i",
        "transmission_error[stage]",
        "-r",
        "mesh_force[stage]",
        "--to",
        "1 kHz",
        "--points",
        "5",
    ]
    assert run_command(["frf", model, *response, "-o", str(still), "-q"]) == 0
    capsys.readouterr()
    assert run_command(["view", str(still), "-o", str(result.with_name("no.html"))]) == 2
    assert "contains no motion over time" in capsys.readouterr().err


def test_a_truncated_result_and_a_page_in_place_of_a_file(
    result: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cut = tmp_path / "cut.h5"
    cut.write_bytes(result.read_bytes()[:5000])
    assert run_command(["view", str(cut), "-o", str(tmp_path / "cut.html")]) == 2
    assert "cut.h5" in capsys.readouterr().err
    assert run_command(["view", str(result), str(cut), "-o", str(tmp_path / "cut.html")]) == 2
    assert "cut.h5" in capsys.readouterr().err
    other = tmp_path / "mine.html"
    other.write_text("mine", encoding="utf-8")
    assert run_command(["view", str(result), "-o", str(other)]) == 2
    assert other.read_text(encoding="utf-8") == "mine"


def damaged(result: Path, out: Path, how: str) -> Path:
    """A copy of a result without its model, without samples, or without numbers from the fourth on."""
    shutil.copy(result, out)
    with h5py.File(out, "a") as file:
        if how == "no model":
            del file.attrs["model_text"]
        elif how == "not finite":
            file["angle[driven]"][3:] = np.nan
    if how == "no samples":
        out.unlink()
        with open_result(str(result)) as whole:
            whole.isel(time=slice(0, 0)).to_netcdf(out, engine="h5netcdf")
    return out


@pytest.mark.parametrize(
    ("how", "says"),
    [("no model", "model: is not stored in this result file"), ("no samples", "contains no sample")],
)
def test_results_that_cannot_be_shown_are_refused(
    result: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], how: str, says: str
) -> None:
    file = damaged(result, tmp_path / "damaged.h5", how)
    assert run_command(["view", str(file), "-o", str(tmp_path / "no.html")]) == 2
    assert says in capsys.readouterr().err and not (tmp_path / "no.html").exists()


def test_a_run_that_failed_is_shown_up_to_there(
    result: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, page = damaged(result, tmp_path / "failed.h5", "not finite"), tmp_path / "failed.html"
    assert run_command(["view", str(file), "-o", str(page)]) == 0
    assert "not finite" in capsys.readouterr().out
    (scene,) = scenes(page)
    with open_result(str(result)) as whole:
        assert scene.times == pytest.approx(whole["time"].values[:3], rel=1e-12)


def test_a_model_without_shapes_is_an_empty_scene(tmp_path: Path) -> None:
    model = tmp_path / "fixed.yaml"
    model.write_text("bodies: {base: {motion: fixed, position: [0, 0, 0]}}\n", encoding="utf-8")
    assert run_command(["view", str(model), "-o", str(tmp_path / "fixed.html"), "-q"]) == 0
    (scene,) = scenes(tmp_path / "fixed.html")
    assert scene.header["solids"] == []


def test_a_model_that_runs_in_the_page(result: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """One file with the compiled model, its scene and the sliders that are offered."""
    pytest.importorskip("ziglang", reason="ziglang is not installed (extra fmi)")
    model, page = result.with_name("pair.yaml"), result.with_name("live.html")
    assert run_command(["view", str(model), "--live", "--scenario", "steady", "-o", str(page)]) == 0
    printed = capsys.readouterr().out
    assert "meshes.stage.center_distance" in printed and "live page written to" in printed
    text = page.read_text(encoding="utf-8")
    (scene,) = scenes(page)
    assert [a["name"] for a in scene.header["arrows"]] == ["stage"]
    assert '"follow": {' in text and "'wasm-unsafe-eval'" in text
    assert not re.search(r"<(script|link|img|iframe)[^>]*(src|href)=", text)
    assert page.stat().st_size < 2e6


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("pair.h5", "--live"), "is a result; --live requires a model"),
        (("pair.yaml", "--live", "--modes", "2"), "--live cannot be combined with --modes"),
        (
            ("pair.yaml", "--parameter", "meshes.stage.backlash.normal"),
            "--parameter has no effect without --live",
        ),
        (("pair.yaml", "--set", "bodies.a.mass=2 kg"), "--set has no effect without --live"),
    ],
)
def test_what_a_live_page_is_not(arguments, words, result: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, *options = arguments
    assert run_command(["view", str(result.with_name(file)), *options]) == 2
    assert words in capsys.readouterr().err
