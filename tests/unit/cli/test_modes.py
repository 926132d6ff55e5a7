# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint modes` and `pitchpoint warmup`."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from pitchpoint.cli import warmup
from pitchpoint.cli.main import run_command
from pitchpoint.elements import registry
from pitchpoint.io.reading import open_result
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers import linear_system
from pitchpoint.solvers.multiblade import find_multiblade_modes
from pitchpoint.system.compile import compile_model
from tests.support.cli_files import TORSION, json_of, written
from tests.support.machines import pair


def test_torsional_pair(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """f = sqrt(k (r_b1^2/I_1 + r_b2^2/I_2))/2 pi with the mean stiffness; damping ratio as in the file."""
    target = tmp_path / "modes.h5"
    found = json_of(["modes", written(tmp_path, TORSION), "-o", str(target)], capsys)
    rigid, mesh = found["modes"]
    r_b = 0.075 * math.cos(math.radians(20.0))
    expected = math.sqrt(4.0e8 * 2.0 * r_b**2 / 0.0115) / (2.0 * math.pi)
    assert rigid["frequency"] == 0.0
    assert mesh["undamped_frequency"] == pytest.approx(expected, rel=1e-6)
    assert mesh["damping_ratio"] == pytest.approx(0.05, rel=1e-5)
    assert mesh["frequency"] == pytest.approx(expected * math.sqrt(1.0 - 0.05**2), rel=1e-5)
    assert "stage" in mesh["name"]
    with open_result(target) as ds:
        assert ds["frequency"].values.tolist() == [rigid["frequency"], mesh["frequency"]]
        assert ds["strain_share"].sel(mode=2, component="mesh stage").item() == pytest.approx(1.0)
        assert ds["name"].values.tolist() == [rigid["name"], mesh["name"]]
        assert ds["shape"].sel(mode=2, coordinate="driver.spin") == mesh["shape"]["driver.spin"]
        assert ds.attrs["kind"] == "modes"


def test_a_phase_gives_the_stiffness_there(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, TORSION)
    mean, at_zero = (
        json_of(["modes", file, "--scenario", "steady", *more], capsys)["modes"][1]["undamped_frequency"]
        for more in ([], ["--phase", "0"])
    )
    assert at_zero / mean == pytest.approx(math.sqrt(0.65), rel=1e-4)


def test_people_get_a_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["modes", written(tmp_path, TORSION)]) == 0
    out = capsys.readouterr().out
    assert "natural frequency" in out
    assert "5.000 %" in out


def test_the_table_shows_the_lowest_twenty_and_says_so(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Chain of 25 discs: 20 rows and how to see all 25; JSON has all of them."""
    inertias = "".join(f"  b{k}: {{motion: torsion, inertia: 0.01}}\n" for k in range(25))
    springs = "".join(
        f"  c{k}: {{bodies: [b{k}, b{k + 1}], stiffness: {{torsion: 1e4}}}}\n" for k in range(24)
    )
    file = written(tmp_path, f"bodies:\n{inertias}couplings:\n{springs}")
    assert run_command(["modes", file]) == 0
    out = capsys.readouterr().out
    assert out.count("torsion of") + out.count("rotation") >= 20
    assert "the lowest 20 of 25 modes, up to" in out
    assert "--count N shows N" in out
    assert "undamped: at rest" in out
    assert run_command(["modes", file, "--count", "25"]) == 0
    assert "25 modes, up to" not in capsys.readouterr().out
    found = json_of(["modes", file], capsys)
    assert found["total"] == len(found["modes"]) == 25


def test_the_number_of_modes_is_stated_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of a large system 40 are computed and 20 shown; with a file, the number in the file is stated, too."""
    monkeypatch.setattr(linear_system, "MAX_MODES", 40)
    inertias = "".join(f"  b{k}: {{motion: torsion, inertia: 0.01}}\n" for k in range(50))
    springs = "".join(
        f"  c{k}: {{bodies: [b{k}, b{k + 1}], stiffness: {{torsion: 1e4}}}}\n" for k in range(49)
    )
    file = written(tmp_path, f"bodies:\n{inertias}couplings:\n{springs}")
    for more, words in (([], ""), (["-o", str(tmp_path / "m.h5")], "; 40 are written")):
        assert run_command(["modes", file, *more]) == 0
        lines = [line for line in capsys.readouterr().out.splitlines() if " of 50 modes" in line]
        assert len(lines) == 1 and f"undamped{words}; --count N shows N" in lines[0]
    assert "the lowest 40 of 50 modes" in json_of(["modes", file], capsys)["notes"][0]


def test_unknown_scenario(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["modes", written(tmp_path, TORSION), "--scenario", "stedy"]) == 2
    assert "did you mean steady?" in capsys.readouterr().err


def test_modes_of_a_turning_wind_rotor(capsys: pytest.CaptureFixture[str]) -> None:
    """The rotor names hub and blades: the numbers of the function, and what is refused."""
    file = str(Path(__file__).parents[3] / "examples" / "wind-turbine" / "model.yaml")
    command = ["modes", file, "-s", "production", "--multiblade"]
    blades = ["blade_1", "blade_2", "blade_3"]
    coarse = {f"beams.{name}.pieces": 3 for name in blades}
    rows = json_of([*command, "rotor", *(f"--set={k}={v}" for k, v in coarse.items())], capsys)
    model = load_model(file).replace_all(coarse)
    found = find_multiblade_modes(compile_model(model, "production"), hub="hub", blades=blades)
    assert rows["speed"] == found.speed and rows["total"] == len(found.frequency)
    assert [row["frequency"] for row in rows["modes"]] == found.frequency.tolist()
    assert [row["backward"] for row in rows["modes"]] == found.blades[:, 2].tolist()
    assert run_command([*command, "roter"]) == 2
    assert "no wind rotor 'roter'; did you mean rotor?" in capsys.readouterr().err
    assert run_command([*command, "rotor", "--phase", "0.1"]) == 2
    assert "--phase has no effect with --multiblade" in capsys.readouterr().err
    rigid = ["--set", "wind_rotors.rotor.beams=[]"]
    assert run_command([*command, "rotor", *rigid]) == 2
    assert "the blades of 'rotor' are fixed to the hub" in capsys.readouterr().err


def test_warmup_lists_every_kind_and_method(tmp_path: Path) -> None:
    names = [name for name, _ in warmup.jobs(tmp_path)]
    assert {f"element {kind}" for kind in registry.names()} <= set(names)
    assert {"generalized_alpha", "rk4", "runge_kutta", "driven", "sweep", "modes", "contact"} <= set(names)


def test_warmup_runs_its_jobs(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    done: list[int] = []
    monkeypatch.setattr(warmup, "jobs", lambda folder: [("one", lambda: done.append(1))])
    assert run_command(["warmup"]) == 0
    assert done == [1]
    assert "1 jobs in" in capsys.readouterr().out


def test_a_mesh_whose_stiffness_begins_with_a_load_is_named_without_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """F = K d^1.5 has no tangent at d = 0: what stands in the list is that of a depth nobody chose."""
    law, remedy = "{law: hertz, force: 10 kN, depth: 30 um}", "give the scenario a load"
    file, target = written(tmp_path, pair(law, torque="0 N m")), tmp_path / "modes.h5"
    found = json_of(["modes", file, "-o", str(target)], capsys)
    (note,) = [n for n in found["notes"] if remedy in n]
    assert "stiffness of stage grows with the load from zero at first contact" in note
    assert "1 nm" in note
    with open_result(target) as ds:
        assert remedy in ds.attrs["notes"]
    assert run_command(["modes", file]) == 0
    assert remedy in " ".join(capsys.readouterr().out.split())
    # k = 1.5 K d^0.5: the note is silent where a load chooses the depth, and where the stiffness needs none
    for text in (pair(law), pair("{law: constant, value: 3e8 N/m}", torque="0 N m")):
        notes = json_of(["modes", written(tmp_path, text)], capsys)["notes"]
        assert not any(remedy in n for n in notes)
