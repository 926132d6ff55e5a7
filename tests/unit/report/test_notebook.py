# SPDX-License-Identifier: Apache-2.0
"""Models and results in notebooks: tables, summary and scene; other people's datasets stay as they were."""

from __future__ import annotations

import html
import re
import sys
import types
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.report import notebook
from pitchpoint.report.notebook import dataset_html, is_result, model_html
from pitchpoint.report.scene.build import scene_of
from pitchpoint.report.scene.rest import rest_scene
from pitchpoint.report.view import write_view
from pitchpoint.viz import notebook as drawings
from tests.support.gearbox_files import GEARBOX
from tests.support.model_files import TORSIONAL_PAIR
from tests.support.report_data import pair
from tests.support.scene_reader import Seen

SHORT = TORSIONAL_PAIR.replace("duration: 0.5 s", "duration: 0.01 s")


@pytest.fixture(scope="module")
def result() -> xr.Dataset:
    return pp.solve_time(pp.compile_model(loads_model(SHORT), "steady"))


def framed(text: str) -> Seen:
    """The scene in the frame of an output; it needs nothing from outside."""
    (frame,) = re.findall(r'<iframe [^>]*sandbox="allow-scripts allow-downloads"[^>]*>', text)
    page = html.unescape(re.search(r'srcdoc="([^"]*)"', frame).group(1))  # type: ignore[union-attr]
    assert "default-src 'none'" in page
    assert not re.search(r"<(script|link|img|iframe)[^>]*(src|href)=", page)
    found = [
        re.search(rf'id="{name}">(.*?)</script>', page, re.DOTALL)
        for name in ("pp-scene", "pp-scene-numbers")
    ]
    return Seen(*(part.group(1).replace("<\\/", "</") for part in found if part))


def test_a_model_shows_its_scene_without_compiling(monkeypatch: pytest.MonkeyPatch) -> None:
    from pitchpoint.system import compile

    monkeypatch.delattr(compile, "compile_model")
    text = model_html(loads_model(SHORT))
    assert "<table" in text and "<svg" in text
    seen = framed(text)
    assert {s["name"] for s in seen.header["solids"] if s["kind"] == "gear"} == {"g1", "g2"}
    assert len(seen.times) == 1


@pytest.mark.parametrize("name", ["pair", "housing", "joints"])
def test_bodies_at_rest_are_where_the_system_has_them(name: str) -> None:
    """Places in the world and axes, those of bodies on joints as well."""
    texts = {"pair": SHORT, "housing": GEARBOX}
    file = Path(__file__).parents[3] / "examples/flyball-governor/model.yaml"
    model = loads_model(texts[name]) if name in texts else load_model(file)
    here, there = rest_scene(model), scene_of(model)
    assert [b.name for b in here.bodies] == [b.name for b in there.bodies]
    frames: list[tuple[Any, Any]] = []
    for one, two in zip(here.bodies, there.bodies, strict=True):
        origin, axes = frames[two.parent] if two.parent >= 0 else (np.zeros(3), np.eye(3))
        frames.append((origin + axes @ two.place, axes @ two.axes))
        np.testing.assert_allclose(one.place, frames[-1][0], atol=1e-12)
        np.testing.assert_allclose(one.axes, frames[-1][1], atol=1e-12)
    assert [s.name for s in here.solids] == [s.name for s in there.solids]


def test_a_shaft_at_rest_is_a_row_of_stations() -> None:
    text = SHORT.replace(
        "bodies:",
        "shafts: {stick: {position: [0, 1, 0], sections: [{length: 0.2 m, diameter: 30 mm}]}}\nbodies:",
    )
    model = loads_model(text)
    places = [b.place for b in rest_scene(model).bodies if b.name.partition(".")[0] == "stick"]
    np.testing.assert_allclose([p[2] - places[0][2] for p in places], model.stations["stick"], atol=1e-15)


def test_a_result_shows_summary_scene_and_variables(result: xr.Dataset) -> None:
    text = dataset_html(result)
    seen = framed(text)
    assert len(seen.times) > 100
    assert [a["name"] for a in seen.header["arrows"]] == ["stage"]
    # statistics of the window of the scenario, as in the terminal and in a report
    mean = result["mesh_force[stage]"].attrs["statistics"][0]
    assert "Statistics from 2 to 10 ms" in text
    row = re.search(r"mesh force, stage</th><td class=\"unit\">N</td><td class=\"num\">([\d.]+)", text)
    assert row and float(row.group(1)) == pytest.approx(mean, rel=1e-4)
    assert f"{result.sizes['time']} samples" in text
    assert f"all {len(result.data_vars)} variables" in text
    # xarray's own display comes along, folded
    assert "xr-wrap" in text.partition("<details>")[2]


def test_modes_show_their_frequencies() -> None:
    """A mass on springs: √(k/m) three times, √(k/J) about three axes; damping d/(2 √(k m))."""
    text = """
bodies: {mass: {motion: free, mass: 1, inertia: 1e-3, transverse_inertia: 1e-3, position: [0, 0, 0]}}
bushings: {k: {ends: [mass, ground], stiffness: {x: 1e4, y: 1e4, axial: 1e4, rx: 100, ry: 100, torsion: 100},
  damping: {x: 2, y: 2, axial: 2, rx: 0, ry: 0, torsion: 0}}}
scenarios: {run: {duration: 1 s}}
"""
    shown = dataset_html(pp.solve_modal(pp.compile_model(loads_model(text), "run")))
    rows = re.findall(
        r'scope="row">(\d)</th><td class="num">([\d.]+)</td><td class="num">([\d.]+)</td>', shown
    )
    found = np.array(rows, dtype=float)
    np.testing.assert_array_equal(found[:, 0], np.arange(1, 7))
    np.testing.assert_allclose(found[:, 1], np.repeat(np.sqrt([1e4, 1e5]) / (2 * np.pi), 3), rtol=1e-4)
    np.testing.assert_allclose(found[:, 2], np.repeat([1.0, 0.0], 3), rtol=1e-4, atol=1e-12)


def test_sweeps_show_where_they_vibrate_most_and_jump(tmp_path: Path) -> None:
    """In memory and from its file: both directions, their maximum rms, all jumps."""
    example = Path(__file__).parents[3] / "examples" / "backlash-oscillator" / "model.yaml"
    model = tmp_path / "model.yaml"
    model.write_text(
        re.sub(r"points: \d+", "points: 13", example.read_text(encoding="utf-8")), encoding="utf-8"
    )
    swept = pp.sweep_speed(pp.compile_model(pp.load_model(model), "sweep"))
    assert swept["jump_direction"].size
    file = str(tmp_path / "sweep.h5")
    assert run_command(["sweep", str(model), "-s", "sweep", "-o", file, "-q"]) == 0
    for data in (swept, pp.open_result(file)):
        text = dataset_html(data)
        for k, direction in enumerate(("up", "down")):
            row = re.search(rf"stage, {direction}</th>(.*?)</tr>", text)
            assert row
            greatest, place, jumps = re.findall(r"<td[^>]*>([^<]*)</td>", row.group(1))
            rms = swept["deflection_rms"].sel(direction=direction)
            assert float(greatest.removesuffix(" µm")) == pytest.approx(1e6 * float(rms.max()), rel=1e-4)
            assert float(place) == pytest.approx(float(rms.idxmax("mesh_frequency")), rel=1e-4)
            found = swept["jump_mesh_frequency"].values[swept["jump_direction"].values == k]
            told = [] if jumps == "none" else [float(jump) for jump in jumps.split(", ")]
            assert told == pytest.approx(list(found), rel=1e-4)


def test_a_result_in_memory_keeps_its_model(result: xr.Dataset, tmp_path: Any) -> None:
    assert loads_model(result.attrs["model_text"]) == loads_model(SHORT)
    written, _ = write_view(tmp_path / "page.html", result)
    assert written.stat().st_size > 600_000


def test_what_cannot_be_drawn_is_said(result: xr.Dataset) -> None:
    bare = result.assign_attrs(model_text="")
    assert "no scene: this result does not contain its model" in dataset_html(bare)
    broken = dataset_html(result.assign_attrs(model_text="gears: 3"))
    assert "<iframe" not in broken and "no scene: " in broken and "mesh force, stage" in broken
    gears_only = SHORT.partition("bodies:")[0]
    text = model_html(loads_model(gears_only))
    assert "<table" in text and "no scene: the model has no body" in text
    stopped = result.assign_attrs(status=-7, status_text="the step <became> too small")
    assert "not finished, status -7: the step &lt;became&gt; too small" in dataset_html(stopped)


def test_bevel_gears_and_their_pairs_show_tables() -> None:
    """The drive of 17 to 43 teeth: 21.571 and 68.429 deg, outer pitch diameters of 68 and 172 mm."""
    model = load_model(Path(__file__).parents[3] / "examples/bevel-drive/straight.yaml")
    told = notebook.shown()

    def cells(thing: Any, meaning: str) -> list[float]:
        made = told[type(thing).__module__, type(thing).__name__](thing)
        row = re.search(rf"<tr><th scope=\"row\">{meaning}.*?</tr>", made)
        assert row, meaning
        return [float(cell) for cell in re.findall(r'class="num">([^<]*)<', row.group())]

    for pinion in (model.bevel_gears["pinion"], model.bevel_gears["pinion"].geometry):
        assert cells(pinion, "pitch cone angle") == pytest.approx([21.571], abs=1e-2)
        assert cells(pinion, "outer pitch diameter") == pytest.approx([68.0])
    stage = model.bevel_pairs["stage"]
    assert cells(stage, "shaft angle") == pytest.approx([90.0])
    assert cells(stage, "outer pitch diameter") == pytest.approx([68.0, 172.0])
    html = drawings.model_html(model)
    assert "<th>bevel gear</th>" in html and "<th>gear</th>" not in html and "<tbody></tbody>" not in html


def test_a_scene_that_is_too_large_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(notebook, "MAX_BYTES", 100_000)
    text = model_html(loads_model(SHORT))
    assert "<iframe" not in text and "pitchpoint view" in text


def test_foreign_datasets_stay_as_they_are() -> None:
    foreign = xr.Dataset({"mesh_force": ("time", [1.0, 2.0])}, attrs={"title": "mine", "source": "a lathe"})
    assert not is_result(foreign)
    plain = re.sub(r"[0-9a-f]{8}-[0-9a-f-]{27}", "", foreign._repr_html_())
    assert re.sub(r"[0-9a-f]{8}-[0-9a-f-]{27}", "", dataset_html(foreign)) == plain


def test_registering_tells_ipython_by_name_only(monkeypatch: pytest.MonkeyPatch) -> None:
    told: dict[tuple[str, str], Any] = {}
    formatter = types.SimpleNamespace(for_type_by_name=lambda m, n, f: told.update({(m, n): f}))
    shell = types.SimpleNamespace(
        display_formatter=types.SimpleNamespace(formatters={"text/html": formatter})
    )
    module = types.ModuleType("IPython")
    module.get_ipython = lambda: shell  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "IPython", module)
    assert notebook.register()
    for thing in (pair(), pair().gear1, loads_model(SHORT), xr.Dataset()):
        made = told[type(thing).__module__, type(thing).__name__](thing)
        assert "<svg" in made or "<div" in made
    monkeypatch.delitem(sys.modules, "IPython", raising=False)
    assert not notebook.register()


def test_a_real_ipython_shows_them(result: xr.Dataset) -> None:
    """The display of IPython itself; what it keeps for text stays that of the objects."""
    from IPython.core.formatters import DisplayFormatter

    formatter = DisplayFormatter()
    for (module, name), function in notebook.shown().items():
        formatter.formatters["text/html"].for_type_by_name(module, name, function)
    for thing in (result, loads_model(SHORT)):
        made, _ = formatter.format(thing)
        assert "<iframe" in made["text/html"]
        assert made["text/plain"] == repr(thing) or made["text/plain"]
    foreign, _ = formatter.format(xr.Dataset({"a": ("x", [1.0])}))
    assert "<iframe" not in foreign["text/html"] and "xr-wrap" in foreign["text/html"]
