# SPDX-License-Identifier: Apache-2.0
"""`write_report` takes a model and results as a user has them: files, datasets, or both."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from pitchpoint.core.progress import silent
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.collect import collect
from pitchpoint.report.defaults import defaults
from pitchpoint.report.flanks import flank_lines
from pitchpoint.report.linear_parts import held_bodies
from pitchpoint.report.numbers import geometry_of_model
from pitchpoint.report.overview import power_part, scene_part
from pitchpoint.report.provenance import source_of
from pitchpoint.viz.report.build import TimeRun

TEXT = """
title: pair for a report
gears:
  g1: {number_of_teeth: 50, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 50, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  driver: {gears: [g1], inertia: 0.0115 kg m^2}
  driven: {gears: [g2], inertia: 0.0115 kg m^2}
meshes:
  stage: {gears: [g1, g2], center_distance: 150 mm, backlash: {normal: 0.1 mm}, damper: {ratio: 0.05},
    stiffness: {law: fourier, mean: 4.0e8 N/m, cosine: [-0.2, -0.1]}}
loads:
  input: {body: driver, torque: 150 N m}
  output: {body: driven, torque: 150 N m}
scenarios:
  steady: {speed: {driver: 1500 rpm}, duration: 20 ms, sample_rate: 20 kHz}
  driven: {drive: {driver: {speed: 1500 rpm}}, duration: 20 ms}
  sweep: {sweep: {body: driver, mesh_frequency: [1000 Hz, 1200 Hz], points: 3, direction: both,
    settle_periods: 5, measure_periods: 2}}
"""


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "pair.yaml"
    path.write_text(TEXT, encoding="utf-8")
    return path


def test_a_model_with_datasets(file: Path, tmp_path: Path) -> None:
    model = pp.load_model(file)
    run = pp.solve_time(pp.compile_model(model, "steady"))
    sweep = pp.sweep_speed(pp.compile_model(model, "sweep"))
    page = pp.write_report(model, tmp_path / "new" / "pair.html", run, sweep)
    text = page.read_text(encoding="utf-8")
    sections = "summary scene power gears drawing cycle modes campbell sweep time spectra extremes provenance"
    for section in (*sections.split(), "notes"):
        assert f'<section id="{section}"' in text
    assert "order of driver [" in text
    assert "The scene shows time response" in text
    assert "pp-scene-numbers" in text
    again = pp.write_report(file, tmp_path / "again.html", run, sweep)
    assert again.read_bytes() == page.read_bytes()


def test_a_model_file_alone(file: Path, tmp_path: Path) -> None:
    text = pp.write_report(file, tmp_path / "bare.html").read_text(encoding="utf-8")
    assert "Mesh stiffness over two mesh cycles" in text
    assert '<section id="time"' not in text
    assert "The scene shows the machine at rest." in text


def test_results_of_the_same_name_in_three_folders_are_all_there(file: Path, tmp_path: Path) -> None:
    model = pp.load_model(file)
    places = [tmp_path / name / "steady.h5" for name in "abc"]
    for place in places:
        place.parent.mkdir()
        assert run_command(["run", str(file), "-s", "steady", "-q", "-o", str(place)]) == 0
    found, _ = collect(model, places, silent)
    assert list(found.runs) == ["steady", "steady (steady.h5)", "steady (steady.h5) 2"]


def test_what_has_no_place_in_a_report(file: Path, tmp_path: Path) -> None:
    modes = pp.solve_modal(pp.compile_model(pp.load_model(file)))
    with pytest.raises(pp.PitchpointError, match=r"a dataset over .*mode.* cannot be shown .* solve_time"):
        pp.write_report(file, tmp_path / "x.html", modes)
    with pytest.raises(pp.PitchpointError, match="int cannot be shown"):
        pp.write_report(file, tmp_path / "x.html", 3)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("law", "relieved", "shown"),
    [("din3990", True, True), ("din3990", False, False), ("constant, value: 4.0e8 N/m", True, False)],
)
def test_slices_are_a_default_that_applies_where_flanks_are_read(
    law: str, relieved: bool, shown: bool
) -> None:
    text = TEXT.replace("law: fourier, mean: 4.0e8 N/m, cosine: [-0.2, -0.1]", f"law: {law}")
    if relieved:
        own = "number_of_teeth: 50, modifications: {both: {profile_crowning: 5 um}}"
        text = text.replace("number_of_teeth: 50", own, 1)
    listed = dict(defaults(loads_model(text)))
    assert listed.get("meshes.stage.slices") == ("11" if shown else None)


@pytest.mark.parametrize(
    ("scenario", "shown"),
    [
        ("duration: 1 s, step: 1 us", {"long_step", "statistics"}),
        ("duration: 1 s", {"statistics"}),
        ("duration: 1 s, step: 1 us, method: rk4", {"statistics"}),
        ("duration: 1 s, method: gstiff", set()),
        ("sweep: {body: driver, mesh_frequency: [1000 Hz, 2000 Hz], points: 3}", set()),
    ],
)
def test_keys_that_a_scenario_cannot_have_are_no_defaults(scenario: str, shown: set[str]) -> None:
    text = TEXT.partition("scenarios:")[0] + f"scenarios: {{one: {{{scenario}}}}}\n"
    listed = {key.rpartition(".")[2] for key, _ in defaults(loads_model(text))}
    assert listed & {"long_step", "statistics"} == shown


def test_bodies_that_a_scenario_holds_are_named(file: Path) -> None:
    model = pp.load_model(file)
    assert held_bodies(model.scenarios["driven"]) == ["driver"]
    assert held_bodies(model.scenarios["steady"]) == held_bodies(None) == []
    assert set(geometry_of_model(model)) == {"gears", "meshes", "bevel_gears", "bevel_meshes"}


def test_neither_an_input_nor_a_foreign_file_is_written_over(file: Path, tmp_path: Path) -> None:
    foreign = tmp_path / "notes.txt"
    foreign.write_text("mine", encoding="utf-8")
    model = pp.load_model(file)
    page = pp.write_report(file, tmp_path / "page.html")
    copy = tmp_path / "copy.html"
    copy.symlink_to(page)
    assert pp.write_report(model, copy) == copy  # a page replaces a page
    run = tmp_path / "run.h5"
    assert run_command(["run", str(file), "-s", "steady", "-q", "-o", str(run)]) == 0
    with pp.open_result(run) as data:
        for thing, target, results in (
            (file, file, []),
            (model, file, []),
            (model, run, [run]),
            (model, run, [data]),
        ):
            with pytest.raises(pp.PitchpointError, match="is read by the same command"):
                pp.write_report(thing, target, *results)
    with pytest.raises(pp.PitchpointError, match=r"notes\.txt exists and is not an HTML page"):
        pp.write_report(model, foreign)
    assert foreign.read_text(encoding="utf-8") == "mine"
    assert file.read_text(encoding="utf-8") == TEXT


def test_a_page_that_cannot_be_written(file: Path) -> None:
    with pytest.raises(pp.PitchpointError, match=r"x\.html: cannot be written \(.+\)"):
        pp.write_report(file, file / "x.html")


def test_a_scenario_that_is_not_there_is_told_with_those_that_are(file: Path) -> None:
    model = pp.load_model(file)
    with pytest.raises(
        pp.CompileError, match=r"no 'stedy'; did you mean steady\? there are: steady, driven,"
    ):
        pp.compile_model(model, "stedy")
    with pytest.raises(pp.PitchpointError, match=r"scenario: there is no 'nope'; there are: steady"):
        pp.compile_model(model, "nope")


def test_designers_find_modifications_measures_and_sliding(tmp_path: Path) -> None:
    own = (
        "number_of_teeth: 50, modifications: {left: {tip_relief: {amount: 20 um, length: 2 mm, "
        "shape: parabolic}, lead_crowning: 5 um}, both: {helix_slope: -3 um}}, "
        "deviations: {runout: {amount: 30 um}}, faults: {chip: {type: broken_tooth, tooth: 2, severity: 0}, "
        "cracked: {type: root_crack, tooth: 3, flank: both, depth: 1 mm, severity: 0.5}, "
        "off: {type: eccentricity, amount: 9 um, severity: 0}}"
    )
    model = loads_model(
        TEXT.replace("number_of_teeth: 50", own, 1).replace(
            "law: fourier, mean: 4.0e8 N/m, cosine: [-0.2, -0.1]", "law: din3990"
        )
    )
    assert flank_lines(model) == [
        ("g1", "left", "tip relief", "20 µm", "parabolic, over 2 mm"),
        ("g1", "left", "lead crowning", "5 µm", ""),
        ("g1", "right", "helix slope", "−3 µm", ""),
        ("g1", "left and right", "runout", "30 µm", ""),
        ("g1", "left and right", "cracked: root crack", "severity 0.5", "tooth 3"),
    ]
    text = pp.write_report(model, tmp_path / "x.html").read_text(encoding="utf-8")
    for words in (
        "<p>2 gear faults have severity 0 and no effect.</p>",
        "parabolic, over 2 mm",
        "span",
        "dimension over balls",
        "tip clearance of gear 1",
        "ζ<sub>",
    ):
        assert words in text


def test_where_results_come_from_stands_in_the_report(file: Path, tmp_path: Path) -> None:
    run = tmp_path / "run.h5"
    assert run_command(["run", str(file), "-s", "steady", "-q", "-o", str(run)]) == 0
    model = pp.load_model(file)
    found, _ = collect(model, [run, pp.solve_time(pp.compile_model(model, "steady"))], silent)
    assert [source.name for source in found.sources] == ["steady", "time response"]
    for source in found.sources:
        rows = dict(source.rows)
        assert source.finished
        assert rows["model"].endswith(" (this model)")
        assert rows["solver"] == "generalized alpha"
        assert int(rows["steps"]) > 100 if "steps" in rows else source.name != "steady"
    assert dict(found.sources[0].rows)["file"] == "run.h5"
    assert (
        dict(found.sources[0].rows)["duration"] == f"{float(model.scenarios['steady'].duration) * 1e3:g} ms"
    )


def test_units_of_varied_values_are_in_the_table_of_the_cases_not_in_the_provenance() -> None:
    header = {"kind": "cases", "options": {"vary_units": {"loads.drag.torque": "N m"}, "settle_time": 0.1}}
    rows = dict(source_of("idle", header, "").rows)
    assert "settle time" in rows
    assert not any("N m" in text for text in rows.values())


def test_a_run_that_failed_is_shown_as_far_as_its_numbers_go(file: Path) -> None:
    model = pp.load_model(file)
    run = pp.solve_time(pp.compile_model(model, "steady")).load()
    end = run.sizes["time"] // 2
    run["speed[driver]"][end:] = np.nan
    shown = scene_part(model, {"r": TimeRun(data=run, note="It stopped.")})
    assert shown.scene is not None
    assert shown.run == "r"
    assert shown.scene.times[-1] < float(run["time"][end])
    assert f"It ends at {float(run['time'][end]):.6g} s" in shown.words
    (flow,) = power_part(model, {"r": TimeRun(data=run)}).values()
    assert flow.span[1] < float(run["time"][end])


def test_a_model_without_shapes_says_so() -> None:
    bare = loads_model("bodies:\n  disc: {motion: torsion, inertia: 1 kg m^2, position: [0, 0, 0]}\n")
    shown = scene_part(bare, {})
    assert shown.scene is not None
    assert any("without a shape in the model" in note for note in shown.scene.notes)
    gear = "number_of_teeth: 20, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    alone = scene_part(loads_model(f"gears:\n  a: {{{gear}}}\n"), {})
    assert alone.scene is None
    assert "There is no scene" in alone.words


def test_each_result_of_a_scenario_has_a_column_in_the_provenance(file: Path, tmp_path: Path) -> None:
    """A time response and a Campbell diagram of one scenario once shared a column: that of the last file."""
    run, diagram = tmp_path / "run.h5", tmp_path / "campbell.h5"
    assert run_command(["run", str(file), "-s", "steady", "-q", "-o", str(run)]) == 0
    assert run_command(["campbell", str(file), "-s", "steady", "-q", "-o", str(diagram)]) == 0
    found, _ = collect(pp.load_model(file), [run, diagram], silent)
    assert [source.name for source in found.sources] == ["steady", "steady (campbell.h5)"]
    assert list(found.runs) == ["steady"] and list(found.campbells) == ["steady (campbell.h5)"]
    text = pp.write_report(file, tmp_path / "x.html", run, diagram).read_text(encoding="utf-8")
    provenance = text[text.index('id="provenance"') :]
    for words in ("run.h5", "campbell.h5", "time response", "Campbell diagram", "1500 rpm"):
        assert f"<td>{words}</td>" in provenance
    assert "Campbell diagram <b>steady (campbell.h5)</b>: finished" in text


def test_ranges_in_the_provenance_have_a_unit() -> None:
    sweep = {"speed": [10.0, 20.0], "body": "speed", "settle_periods": 5}
    options = {"operating_speed": [628.318530718, 628.318530718], "sweep": sweep, "speed": {"step": 1.0}}
    options["long_step"] = 1e-3
    rows = dict(source_of("x", {"kind": "sweep", "options": options}, "").rows)
    assert rows["operating speed"] == "6000 rpm"
    assert rows["sweep"] == "speed: 95.493 rpm to 190.99 rpm, body: speed, settle_periods: 5"
    assert rows["speed"] == "step: 9.5493 rpm"
    assert rows["long step"] == "1 ms"
