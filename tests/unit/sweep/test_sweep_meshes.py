# SPDX-License-Identifier: Apache-2.0
"""Contact loss, closing speed and force of every mesh of a swept machine.

The two-stage machine loses contact in its second stage, while the swept input has the mesh of the first one.
"""

from __future__ import annotations

import h5py
import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.analysis.by_component import by_component
from pitchpoint.cli.main import run_command
from pitchpoint.io.case_store import read_cases
from pitchpoint.io.reading import open_result
from pitchpoint.io.sweep_store import CONTACTS, read_sweep
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.study_data import case_table, sweep_of
from pitchpoint.solvers.time import solve_time
from pitchpoint.sweep.cases import cases_dataset, run_cases
from pitchpoint.sweep.speed import run_sweep, sweep_speed
from pitchpoint.system.compile import compile_model
from pitchpoint.viz.report.sweeps import sweep_section
from tests.support.cli_files import json_of, written

GEAR = "normal_module: 2 mm, face_width: 20 mm, tooth_thickness_allowance: -40 um"
TWO_STAGES = f"""
gears:
  a: {{number_of_teeth: 24, {GEAR}, profile_shift_coefficient: 0}}
  b: {{number_of_teeth: 49, {GEAR}, profile_shift_coefficient: 0}}
  c: {{number_of_teeth: 20, {GEAR}, profile_shift_coefficient: 0.2}}
  d: {{number_of_teeth: 50, {GEAR}, profile_shift_coefficient: -0.2}}
bodies:
  s1: {{gears: [a], inertia: 1e-3 kg m^2}}
  s2: {{gears: [b], inertia: 2e-2 kg m^2}}
  s3: {{gears: [c], inertia: 1e-3 kg m^2}}
  s4: {{gears: [d], inertia: 4e-3 kg m^2}}
couplings:
  k: {{bodies: [s2, s3], position: [0, 0, 100 mm], stiffness: {{torsion: 2000 N m/rad}},
    damping: {{torsion: 0.5 N m s/rad}}}}
meshes:
  st1: {{gears: [a, b], stiffness: {{law: constant, value: 3e8 N/m}}, damper: {{ratio: 0.05}}}}
  st2: {{gears: [c, d], stiffness: {{law: din3990}}, damper: {{ratio: 0.02}}}}
loads:
  m: {{body: s1, torque: 40 N m}}
  o: {{body: s4, torque: balance}}
scenarios:
  sw: {{sweep: {{body: s1, mesh_frequency: [6400 Hz, 9000 Hz], points: 2, settle_periods: 120,
    measure_periods: 49}}}}
  other: {{sweep: {{body: s4, speed: [3150 rpm, 3300 rpm], points: 2, direction: up, settle_periods: 100,
    measure_periods: 40}}}}
  at: {{speed: {{s1: 16000 rpm}}, duration: 60 ms, settle_time: 40 ms, sample_rate: 1.28 MHz}}
"""
NAMES = [name for name, _, _ in CONTACTS]


@pytest.fixture(scope="module")
def system():
    return compile_model(loads_model(TWO_STAGES), "sw")


@pytest.fixture(scope="module")
def data(system):
    return sweep_speed(system)


@pytest.fixture(scope="module")
def stored(tmp_path_factory):
    """Result file of the sweep, and the output of its command."""
    folder = tmp_path_factory.mktemp("sweep")
    file, target = written(folder, TWO_STAGES), folder / "sweep.h5"
    assert run_command(["sweep", file, "-s", "sw", "-o", str(target), "--quiet"]) == 0
    return file, target


def test_shares_of_the_mesh_that_is_not_swept_are_those_of_a_time_run(data):
    """Separated samples of a time response at the speed of the first point, counted here.

    16000 rpm of 24 teeth are 6400 Hz. Both directions have the same periodic motion there. A sample in 200 of
    a period of the first mesh is 0.5 % of it; closing speeds are differences of samples, within their spread.
    """
    run = solve_time(compile_model(loads_model(TWO_STAGES), "at"))
    kept = run.time.values >= 0.04
    for mesh in ("st1", "st2"):
        apart = run[f"contact_state[{mesh}]"].values[kept] == 0.0
        force, x = run[f"mesh_force[{mesh}]"].values[kept], run[f"deflection[{mesh}]"].values[kept]
        point = data.sel(mesh_frequency=6400.0)
        assert point[f"contact_loss_share[{mesh}]"].values == pytest.approx(apart.mean(), abs=5e-3)
        wanted = force[np.argmax(np.abs(force))]
        extremes = point[f"mesh_force[{mesh}]"].sel(statistic=["min", "max"]).values
        assert extremes[:, int(wanted > 0.0)] == pytest.approx(wanted, rel=2e-2)
        lands = np.flatnonzero(apart[:-1] & ~apart[1:])
        speeds = np.abs(np.diff(x)[lands]) * 1.28e6
        assert point[f"closing_speed_max[{mesh}]"].values == pytest.approx(speeds.max(initial=0.0), rel=5e-2)
    assert (run["contact_state[st2]"].values[kept] == 0.0).mean() > 0.4


def test_every_mesh_has_its_contact_numbers_over_mesh(system, data):
    """By name in the dataset, over `mesh` by component; the swept mesh also without its name."""
    found = run_sweep(system)
    assert (found.mesh, data.attrs["swept_mesh"]) == ("st1", "st1")
    assert list(found.points[0]["meshes"]) == ["st1", "st2"]
    for name in NAMES:
        by_mesh = by_component(data)[name]
        assert by_mesh.dims == ("direction", "mesh_frequency", "mesh")
        np.testing.assert_array_equal(by_mesh.sel(mesh="st1"), data[name])
        for p in found.points:
            at = {"direction": p["direction"], "mesh_frequency": p["mesh_frequency"]}
            assert data[f"{name}[st2]"].sel(at).values == p["meshes"]["st2"][name]
    for mesh in ("st1", "st2"):  # contact is state 1 or -1: its share is the mean square of the state
        mean, rms = (data[f"contact_state[{mesh}]"].sel(statistic=s).values for s in ("mean", "rms"))
        np.testing.assert_allclose(data[f"contact_loss_share[{mesh}]"], 1.0 - mean**2 - rms**2, atol=1e-12)
    assert data["contact_loss_share"].values.max() == 0.0
    assert data["contact_loss_share[st2]"].values.min(axis=1) == pytest.approx([0.0, 0.0])
    assert data["contact_loss_share[st2]"].attrs["units"] == "1"


def test_a_sweep_of_another_body_puts_its_mesh_first():
    found = run_sweep(compile_model(loads_model(TWO_STAGES), "other"))
    assert (found.mesh, list(found.points[0]["meshes"])) == ("st2", ["st2", "st1"])
    assert (
        found.points[0]["contact_loss_share"] == found.points[0]["meshes"]["st2"]["contact_loss_share"] > 0.2
    )


def test_the_file_keeps_every_mesh(stored, data):
    kept = read_sweep(stored[1])
    assert kept["mesh"] == "st1"
    assert kept["points"] == [p | {"status": 1} for p in sweep_of(data)["points"]]
    with open_result(stored[1]) as file:
        for mesh in ("st1", "st2"):
            for name in NAMES:
                np.testing.assert_array_equal(file[f"{name}[{mesh}]"], data[f"{name}[{mesh}]"])


def test_files_of_earlier_versions_open_and_say_what_they_lack(stored, tmp_path):
    """They have the contact numbers of the swept mesh only, and do not name it."""
    old = tmp_path / "old.h5"
    old.write_bytes(stored[1].read_bytes())
    with h5py.File(old, "r+") as file:
        for name in NAMES:
            del file[f"{name}[st2]"]
        file.attrs["options"] = file.attrs["options"].replace(', "swept_mesh": "st1"', "")
    kept = read_sweep(old)
    assert kept["mesh"] == "st1"
    assert "contact_loss_share" not in kept["points"][0]["meshes"]["st2"]
    assert kept["points"][0]["meshes"]["st2"]["mesh_force"]["min"] < -1e4
    text = "".join(sweep_section({"": kept}).parts)
    assert "The flanks of st1 stay in contact at every point of this sweep." in text
    assert "no contact numbers of st2; repeat the sweep" in text


def test_people_read_which_mesh_loses_contact(stored, tmp_path, capsys):
    command = ["sweep", stored[0], "-s", "sw", "-o", str(tmp_path / "again.h5")]
    assert run_command(command) == 0
    out = capsys.readouterr().out
    lines = [line.split() for line in out.splitlines()]
    rows = [line for line in lines if line[:1] in (["st1"], ["st2"])]
    assert [row[:2] for row in rows] == [["st1", "up"], ["st1", "down"], ["st2", "up"], ["st2", "down"]]
    sentence = "The flanks of st2 separate at 2 of 4 points, for up to"
    assert sentence in out and "The flanks of st1 stay in contact at every point." in out
    page = tmp_path / "page.html"
    assert run_command(["report", stored[0], str(stored[1]), "-o", str(page), "--quiet"]) == 0
    text = page.read_text(encoding="utf-8")
    assert sentence in text
    assert "stay in contact at every point of this sweep" not in text
    assert '<th scope="row">st2</th><td>up</td>' in text
    summary = text[text.index("peak of mesh force") :][:2000]
    assert "kN at 6400 Hz, 16000 rpm, st2" in summary


def test_json_has_every_mesh(stored, tmp_path, capsys):
    found = json_of(["sweep", stored[0], "-s", "sw", "-o", str(tmp_path / "again.h5")], capsys)
    assert found["points"] == [
        {key: value for key, value in p.items() if key != "status"} for p in read_sweep(stored[1])["points"]
    ]


def test_pictures_of_every_mesh(stored, data):
    for result in (data, open_result(stored[1])):
        for name in ("mesh_force", "contact_shares", "closing_speed_max"):
            lines = {line.name: line for line in pp.plot(result, name).data}
            assert set(lines) == {"st1, up", "st1, down", "st2, up", "st2, down"}
        share = pp.plot(result, "contact_shares").data[2].y
        assert share == pytest.approx(100.0 * data["contact_loss_share[st2]"].values[0])
        one = pp.plot(result, "mesh_force[st2]")
        assert one.layout.yaxis.title.text == "maximum magnitude of mesh force, st2 [kN]"
        assert one.layout.xaxis.title.text == "mesh frequency of st1 [Hz]"
        force = np.abs(data["mesh_force[st2]"].sel(statistic=["min", "max"]).values[0]).max(axis=1)
        assert one.data[0].y == pytest.approx(1e-3 * force)
        for name in ("deflection[st2]", "contact_shares[st2]", "closing_speed_max[st2]", "deflection[st1]"):
            assert pp.plot(result, name).data


def test_cases_of_sweeps_have_every_mesh(stored, tmp_path, capsys):
    target, path = tmp_path / "cases.h5", "loads.m.torque"
    command = ["sweep", stored[0], "-s", "other", "--vary", f"{path}=40 N m,60 N m", "-o", str(target)]
    assert run_command(command) == 0
    out = " ".join(capsys.readouterr().out.split())
    assert "st1" in out and "st2" in out
    results = run_cases(loads_model(TWO_STAGES), [{path: f"{t} N m"} for t in (40, 60)], "other", jobs=1)
    cases = cases_dataset(results)
    assert cases["contact_loss_share[st2]"].dims == ("case", "direction", "point")
    np.testing.assert_array_equal(cases["contact_loss_share[st2]"], cases["contact_loss_share"])
    for kept in (read_cases(target), case_table(cases).cases):
        for case, result in zip(kept, results, strict=True):
            assert case["points"] == result.points
