# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint dataset`: the table, the files, going on after a kill, shards, dry runs, bad input."""

from __future__ import annotations

import csv
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import h5py
import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.results import open_result, read_header
from tests.support.cli_files import json_of
from tests.support.dataset_files import CASES, MODEL, PLAN, written


def table(folder: Path, name: str = "index.csv") -> list[dict[str, str]]:
    with (folder / name).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def contents(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def test_a_whole_data_set_and_again(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plan, out = written(tmp_path), tmp_path / "out"
    first = json_of(["dataset", plan, "-o", str(out)], capsys)
    assert (first["cases"], first["known"], first["finished"], first["failed"]) == (CASES, 0, CASES, 0)
    rows = table(out)
    assert [int(r["case"]) for r in rows] == list(range(CASES))
    assert list(rows[0])[:8] == [
        "case",
        "file",
        "status",
        "status_code",
        "sentence",
        "torque",
        "damping",
        "seed",
    ]
    assert {r["status"] for r in rows} == {"finished"}
    assert len({r["file"] for r in rows}) == CASES
    assert rows[-1]["damping"] == "weak"
    assert float(rows[-1]["meshes.stage.damper.ratio [1]"]) == 0.03
    assert float(rows[0]["meshes.stage.damper.ratio [1]"]) == 0.05  # what stands in the model
    with open_result(out / rows[-1]["file"]) as data:
        assert data.sizes["time"] == 100
        assert data["force"].attrs["units"] == "N"
        assert data["time"].values[1] == pytest.approx(1.0 / 20000.0)
        assert data["tacho_times"].ndim == 1
    header = read_header(out / rows[-1]["file"])
    assert header["options"]["labels"] == {"torque": "150 N m", "damping": "weak"}
    assert header["options"]["seed"] == 2
    assert header["options"]["numbers"]["loads.input.torque"][0] == float(
        rows[-1]["loads.input.torque [N m]"]
    )
    assert "low-pass" in header["options"]["anti_aliasing"]
    before = contents(out)
    assert json_of(["dataset", plan, "-o", str(out)], capsys)["known"] == CASES
    assert contents(out) == before


def test_equal_inputs_make_equal_files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Also in another order, in another thread, a second later."""
    plan = written(tmp_path)
    json_of(["dataset", plan, "-o", str(tmp_path / "one"), "--jobs", "1"], capsys)
    time.sleep(1.1)
    json_of(["dataset", plan, "-o", str(tmp_path / "two"), "--jobs", "3"], capsys)
    assert contents(tmp_path / "one") == contents(tmp_path / "two")


def test_killed_at_any_instant_it_goes_on(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Killed after its first and sixth file, then left to end: the same bytes as without interruption."""
    plan, out = written(tmp_path, PLAN.replace("length: 5 ms", "length: 100 ms")), tmp_path / "out"
    command = [sys.executable, "-c", "from pitchpoint.cli.main import main; main()"]
    command += ["dataset", plan, "-o", str(out), "-j", "2", "-q"]
    for wanted in (1, 6):
        process = subprocess.Popen(command, env=os.environ)
        until = time.monotonic() + 120.0
        while len(list(out.glob("cases/*.h5"))) < wanted and process.poll() is None:
            assert time.monotonic() < until
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
        process.wait()
        for path in out.glob("cases/*.h5"):
            with h5py.File(path, "r") as file:
                assert file.attrs["status"] == b"finished"
                assert file["force"].shape == (2000,)
                assert np.isfinite(file["force"][...]).all()
    killed = len(list(out.glob("cases/*.h5")))
    last = json_of(["dataset", plan, "-o", str(out)], capsys)
    assert last["known"] == killed
    assert last["finished"] == CASES
    assert not list(out.rglob(".draft-*"))
    json_of(["dataset", plan, "-o", str(tmp_path / "whole")], capsys)
    assert contents(out) == contents(tmp_path / "whole")


def test_two_runs_at_once_share_a_folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Both may compute the same cases; files and table are those of one run."""
    plan, out = written(tmp_path), tmp_path / "out"
    command = [sys.executable, "-c", "from pitchpoint.cli.main import main; main()"]
    command += ["dataset", plan, "-o", str(out), "-q"]
    runs = [subprocess.Popen(command, env=os.environ, stderr=subprocess.PIPE) for _ in range(2)]
    for run in runs:
        said = run.communicate(timeout=120)[1]
        assert (run.returncode, said) == (0, b"")
    json_of(["dataset", plan, "-o", str(tmp_path / "whole")], capsys)
    assert contents(out) == contents(tmp_path / "whole")


@pytest.mark.skipif(sys.platform == "win32", reason="limits of a process")
def test_a_full_disk_ends_the_run_with_a_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Files of more than 20 kB are refused as on a full disk; a case of 2000 samples is larger."""
    plan, out = written(tmp_path, PLAN.replace("length: 5 ms", "length: 100 ms")), tmp_path / "out"
    code = (
        "import resource, signal; signal.signal(signal.SIGXFSZ, signal.SIG_IGN);"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000));"
        "from pitchpoint.cli.main import main; main()"
    )
    run = subprocess.run(
        [sys.executable, "-B", "-c", code, "dataset", plan, "-o", str(out), "-j", "1", "-q"],
        env=os.environ,
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert run.returncode == 3
    assert "cannot be written" in run.stderr
    assert "fix this and rerun" in run.stderr
    assert "Traceback" not in run.stderr
    ways = [r["status"] for r in table(out)]
    assert (ways.count("failed"), ways.count("waiting")) == (1, CASES - 1)
    assert not list(out.rglob("*.h5"))
    assert not list(out.rglob(".draft-*"))
    assert json_of(["dataset", plan, "-o", str(out)], capsys)["finished"] == CASES


def test_shards_share_a_folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plan, out = written(tmp_path), tmp_path / "out"
    for part in (1, 2, 3):
        found = json_of(["dataset", plan, "-o", str(out), "--shard", f"{part}/3"], capsys)
        assert found["cases"] == CASES // 3
        assert [int(r["case"]) % 3 for r in table(out, f"index-{part}-of-3.csv")] == [part - 1] * (CASES // 3)
    assert json_of(["dataset", plan, "-o", str(out)], capsys)["known"] == CASES
    assert {r["status"] for r in table(out)} == {"finished"}


@pytest.mark.parametrize("text", ["3", "0/2", "3/2", "a/b", "1/0", "-1/2"])
def test_shards_that_are_none(tmp_path: Path, text: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["dataset", written(tmp_path), f"--shard={text}"]) == 2
    assert "is not of the form I/N" in capsys.readouterr().err


def test_a_dry_run_computes_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plan, out = written(tmp_path), tmp_path / "out"
    found = json_of(["dataset", plan, "-o", str(out), "--dry-run"], capsys)
    assert (found["cases"], found["left"], found["known"]) == (CASES, CASES, 0)
    assert found["seconds"] > 0.0
    assert not out.exists()
    json_of(["dataset", plan, "-o", str(out)], capsys)
    size = sum(p.stat().st_size for p in out.glob("cases/*.h5"))
    assert 0.2 * found["bytes"] < size < found["bytes"]
    assert run_command(["dataset", plan, "-o", str(out), "--dry-run"]) == 0
    assert f"{CASES} cases, {CASES} completed, 0 remaining" in capsys.readouterr().out


def test_failed_cases_are_listed_and_stop_nobody(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = PLAN.replace(
        "weak: {meshes", "bad: {loads.output.torque: 150 N m * sqrt(0.003 - t)}\n    weak: {meshes"
    )
    plan, out = written(tmp_path, text), tmp_path / "out"
    assert run_command(["dataset", plan, "-o", str(out)]) == 3
    said = capsys.readouterr()
    assert "4 of 16 cases failed; case 2:" in said.err
    rows = table(out)
    bad = [r for r in rows if r["status"] != "finished"]
    assert len(bad) == 4
    assert {r["damping"] for r in bad} == {"bad"}
    assert all("(at t = 0.00" in r["sentence"] for r in bad)
    assert read_header(out / bad[0]["file"])["status"] == "failed"
    # a failure is a result too: it is not computed again, and said again
    assert run_command(["dataset", plan, "-o", str(out)]) == 3
    assert "16 cases failed" in capsys.readouterr().err


def test_a_longer_plan_goes_on_from_the_shorter_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    json_of(["dataset", written(tmp_path), "-o", str(out)], capsys)
    more = PLAN.replace("seeds: 2", "seeds: 3").replace("150 N m]", "150 N m, 200 N m]")
    found = json_of(["dataset", written(tmp_path, more), "-o", str(out)], capsys)
    assert (found["cases"], found["known"], found["finished"]) == (27, CASES, 27)


def test_bad_plans_and_folders(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plan = written(tmp_path, PLAN.replace("pair.yaml", "pear.yaml"))
    assert run_command(["dataset", plan]) == 2
    assert "model (line 2)" in capsys.readouterr().err
    plan = written(tmp_path, PLAN.replace('"mesh_force[stage]"', '"mesh_force[stag]"'))
    assert run_command(["dataset", plan, "-o", str(tmp_path / "o")]) == 2
    assert "did you mean mesh_force[stage]" in capsys.readouterr().err
    assert not (tmp_path / "o").exists()
    plan = written(tmp_path, PLAN, MODEL.replace("duration: 0.5 s", "duration: 0.5 kg"))
    assert run_command(["dataset", plan, "-o", str(tmp_path / "o")]) == 2
    assert "pair.yaml: 1 problem" in capsys.readouterr().err
    used = tmp_path / "used"
    used.mkdir()
    (used / "letter.txt").write_text("dear")
    plan = written(tmp_path)
    assert run_command(["dataset", plan, "-o", str(used)]) == 2
    assert "contains files of other kinds (letter.txt)" in capsys.readouterr().err
    assert run_command(["dataset", plan, "-o", str(used / "letter.txt")]) == 2
    capsys.readouterr()
    out = tmp_path / "out"
    (out / "cases").mkdir(parents=True)
    (out / "index.csv").write_text("my own table\n")
    assert run_command(["dataset", plan, "-o", str(out)]) == 2
    assert "is not a table of cases of pitchpoint" in capsys.readouterr().err
    assert (out / "index.csv").read_text() == "my own table\n"


def test_a_damaged_file_is_computed_again(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plan, out = written(tmp_path), tmp_path / "out"
    json_of(["dataset", plan, "-o", str(out)], capsys)
    before = contents(out)
    first = out / table(out)[0]["file"]
    first.write_bytes(first.read_bytes()[:300])
    assert json_of(["dataset", plan, "-o", str(out)], capsys)["known"] == CASES - 1
    assert contents(out) == before


def test_json_says_nothing_else(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["dataset", written(tmp_path), "-o", str(tmp_path / "o"), "--json", "-q"]) == 0
    said = capsys.readouterr()
    assert json.loads(said.out)["finished"] == CASES
    assert said.err == ""


def test_a_case_with_a_flipped_bit_is_computed_again(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    plan, out = written(tmp_path), tmp_path / "out"
    json_of(["dataset", plan, "-o", str(out)], capsys)
    before = contents(out)
    first, *_, last = sorted(out.glob("cases/*.h5"))
    for path, at in ((first, 0.6), (last, 0.95)):
        data = bytearray(path.read_bytes())
        data[int(at * len(data))] ^= 1
        path.write_bytes(data)
    assert json_of(["dataset", plan, "-o", str(out)], capsys)["known"] == CASES - 2
    assert contents(out) == before


def test_a_table_of_cases_holds_no_formulas(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A label that a spreadsheet would compute stands there as a text; numbers stay numbers."""
    plan = PLAN.replace("weak: {", "'=HYPERLINK(1)': {").replace("seeds: 2", "seeds: 1")
    json_of(["dataset", written(tmp_path, plan), "-o", str(tmp_path / "out")], capsys)
    text = (tmp_path / "out" / "index.csv").read_text()
    assert ",'=HYPERLINK(1)" in text
    assert ",=" not in text


def test_contact_numbers_of_a_recorded_contact_state(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Impacts are columns of the table, and of that of a second run, which reads them from the files."""
    plan, out = Path(written(tmp_path)), tmp_path / "out"
    text = plan.read_text(encoding="utf-8")
    plan.write_text(
        text.replace(
            "channels:\n", 'channels:\n  state: {type: observation, channel: "contact_state[stage]"}\n', 1
        ),
        encoding="utf-8",
    )
    for _ in range(2):
        json_of(["dataset", str(plan), "-o", str(out)], capsys)
        for row in table(out):
            assert float(row["contact_loss_share[stage] [1]"]) + float(
                row["front_contact_share[stage] [1]"]
            ) == pytest.approx(1.0, abs=1e-9)
            assert float(row["impact_rate[stage] [1/s]"]) >= 0.0
        (out / "index.csv").unlink()
