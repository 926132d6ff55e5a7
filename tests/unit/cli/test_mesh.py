# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint mesh` without a file: the overlap cases of the SIMPACK user meeting 2006."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from tests.support.cli_files import ISO_EX1, TORSION, json_of, written
from tests.support.model_files import gear


def mesh_of(arguments: str, capsys: pytest.CaptureFixture[str]) -> dict[str, object]:
    """Run `mesh --json` and return its only mesh."""
    assert run_command(["mesh", "--json", *arguments.split()]) == 0
    captured = capsys.readouterr()
    assert captured.err == ""
    (found,) = json.loads(captured.out)["meshes"].values()
    return found


def test_contract_example(capsys: pytest.CaptureFixture[str]) -> None:
    found = mesh_of("--eps-alpha 1.3 --eps-beta 0.85 --stiffness-ratio 0.8 --tip-relief-factor 0", capsys)
    assert found["mean"] == pytest.approx(1.3 * (1 - 0.2 / 3), abs=1e-12)
    assert found["peak_to_peak"] == pytest.approx(0.1408632, abs=1e-6)
    assert found["phase"][0] == 0.0
    assert found["phase"][-1] == 1.0
    assert len(found["phase"]) == len(found["stiffness_ratio"]) == 401
    assert max(found["stiffness_ratio"]) <= found["maximum"] + 1e-12


def test_defaults_are_a_spur_pair_with_stiffness_ratio_08(capsys: pytest.CaptureFixture[str]) -> None:
    found = mesh_of("--eps-alpha 1.3 --points 11", capsys)
    assert found["mean"] == pytest.approx(1.3 * (1 - 0.2 / 3), abs=1e-12)
    assert found["jumps"] == pytest.approx([0.0, 0.3])
    assert len(found["phase"]) == 11


def test_extremes_do_not_depend_on_the_samples(capsys: pytest.CaptureFixture[str]) -> None:
    few = mesh_of("--eps-alpha 1.62 --eps-beta 0.37 --points 2", capsys)
    many = mesh_of("--eps-alpha 1.62 --eps-beta 0.37 --points 2001", capsys)
    assert few["peak_to_peak"] == many["peak_to_peak"]
    samples = many["stiffness_ratio"]
    assert max(samples) - min(samples) == pytest.approx(many["peak_to_peak"], rel=1e-3)


def test_people_get_a_table(capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["mesh", "--eps-alpha", "1.3"]) == 0
    out = capsys.readouterr().out
    assert "peak to peak" in out
    assert "1.213333" in out
    assert "jumps at the phases 0.0000, 0.3000" in out


def test_a_ratio_of_zero_is_a_parabola_that_vanishes_at_its_ends(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """c = 1 - zeta^2 has the mean 2/3 along the way; nothing jumps, and a model file may say it as well."""
    bare = mesh_of("--eps-alpha 1.3 --stiffness-ratio 0", capsys)
    assert bare["mean"] == pytest.approx(1.3 * 2.0 / 3.0, abs=1e-12)
    assert bare["jumps"] == []
    text = ISO_EX1.replace("stiffness_ratio: 0.8", "stiffness_ratio: 0")
    stage = mesh_of(written(tmp_path, text), capsys)
    pair = loads_model(text).pairs["stage"]
    assert stage["mean"] == pytest.approx(pair.eps_alpha * 2.0 / 3.0, rel=1e-9)


@pytest.mark.parametrize("value", ["-0.1", "1.1"])
def test_files_and_options_refuse_the_same_ratios(value: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["mesh", "--eps-alpha", "1.3", "--stiffness-ratio", value]) == 2
    assert "limit 0 to 1" in capsys.readouterr().err
    with pytest.raises(ModelError, match=r"stiffness_ratio .* is out of range \(limit >= 0 and <= 1\)"):
        loads_model(ISO_EX1.replace("stiffness_ratio: 0.8", f"stiffness_ratio: {value}"))


def test_a_run_with_the_ratio_zero_is_the_limit_of_small_ones(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    rms = []
    for ratio in (0, 1e-6):
        law = f"{{law: din3990, stiffness_ratio: {ratio}, low_load: true}}"
        text = TORSION.replace("{law: fourier, mean: 4.0e8 N/m, cosine: [-0.2, -0.1, -0.05]}", law)
        file = written(tmp_path, text.replace("duration: 0.5 s", "duration: 10 ms"))
        target = str(tmp_path / "out.h5")
        channels = json_of(["run", file, "-s", "steady", "-o", target], capsys)["channels"]
        assert all(row["rms"] is not None for row in channels.values())
        rms.append(channels["deflection[stage]"]["rms"])
    assert rms[0] == pytest.approx(rms[1], rel=1e-4)


def test_a_file_without_meshes_gets_a_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, "gears:\n" + gear("a"))
    assert run_command(["mesh", file]) == 0
    assert f"{file}: no meshes" in capsys.readouterr().out
    assert json_of(["mesh", file], capsys) == {"meshes": {}}


@pytest.mark.parametrize("options", ["", " --eps-beta 0.1", " --tip-relief-factor 1"])
def test_a_mesh_without_contact_for_a_while_has_no_least_stiffness_of_round_off(
    options: str, capsys: pytest.CaptureFixture[str]
) -> None:
    found = mesh_of(f"--eps-alpha 0.5 --stiffness-ratio 0{options}", capsys)
    assert found["minimum"] == 0.0 and min(found["stiffness_ratio"]) == 0.0
    assert found["peak_to_peak"] == found["maximum"] >= 0.5  # equal for long ramps: half their height


def test_torsional_and_single_pair_stiffness(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """k r_b^2 about each axis; one pair has c' b at the middle of its path and S_R of that at A and E."""
    file, target = written(tmp_path, ISO_EX1), tmp_path / "k.csv"
    found = json_of(["mesh", file, "-o", str(target)], capsys)["meshes"]["stage"]
    pair = loads_model(ISO_EX1).pairs["stage"]
    mesh, one = found["mesh_table"], found["pair_table"]
    for k, own in ((1, pair.gear1), (2, pair.gear2)):
        for table in (mesh, one):
            expected = [k_t * (0.5 * own.d_b) ** 2 for k_t in table["stiffness"]]
            assert table[f"torsional_stiffness_{k}"] == pytest.approx(expected, rel=1e-12)
    whole = found["unit_stiffness"]
    assert mesh["stiffness"] == pytest.approx([whole * r for r in found["stiffness_ratio"]], rel=1e-12)
    assert one["position"][-1] == pytest.approx(pair.eps_alpha, rel=1e-12)
    assert one["stiffness"][200] == pytest.approx(whole, rel=1e-9)
    assert one["stiffness"][0] == pytest.approx(0.8 * whole, rel=1e-9)
    lines = target.read_text(encoding="utf-8").splitlines()
    assert lines[0].startswith("stiffness of mesh,of,position [base pitches],stiffness [N/m],torsional")
    assert len(lines) == 1 + 401 + 401
    assert run_command(["mesh", file]) == 0
    out = capsys.readouterr().out
    assert "N m/rad" in out and "about gear 2" in out and "One tooth pair from A to E" in out


def test_the_map_names_the_best_overlap_ratio(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "map.html"
    found = json_of(["mesh", "--eps-alpha", "1.3", "--eps-beta", "0.7", "-o", str(target)], capsys)
    assert found["meshes"]["mesh"]["best_overlap_ratio"] == 1.0
    assert "plotly" in target.read_text(encoding="utf-8")
    assert run_command(["mesh", written(tmp_path, TORSION), "-o", str(target)]) == 2
    assert "no mesh has parabolic stiffness" in capsys.readouterr().err
    assert run_command(["mesh", "--eps-alpha", "1.3", "-o", str(tmp_path / "t.csv")]) == 2
    assert "a table requires a model FILE" in capsys.readouterr().err
