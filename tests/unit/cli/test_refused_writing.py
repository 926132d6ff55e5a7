# SPDX-License-Identifier: Apache-2.0
"""Every command that writes, on disks of any size: exit code 0 or 3 and a sentence, never a crash."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from tests.support.cli_files import TORSION, written

pytest.importorskip("resource", reason="limits of sizes are those of Unix")

LIMITS = (0, 1_000, 4_000, 16_000, 40_000, 100_000, 400_000)
"""Bytes that a file can hold; what the commands write here is between 1 kB and 5 MB large."""
CHILD = """
import resource, signal, sys
from pitchpoint.cli.main import main
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv.pop(1)), resource.RLIM_INFINITY))
main()
"""
FLANKS = """
gears:
  g1: {number_of_teeth: 16, normal_module: 4.5 mm, face_width: 14 mm, profile_shift_coefficient: 0.1817}
  g2: {number_of_teeth: 24, normal_module: 4.5 mm, face_width: 14 mm, profile_shift_coefficient: 0.1715}
bodies:
  a: {gears: [g1], motion: torsion}
  b: {gears: [g2], motion: torsion}
meshes:
  stage: {gears: [g1, g2], center_distance: 91.5 mm, contact: {level: flexible, planes: 5}}
loads:
  input: {body: a, torque: 302 N m}
  output: {body: b, torque: balance}
"""
COMMANDS = {
    "drawing": "gears {model} --gear g1 --export {out}.dxf",
    "profile": "gears {model} --gear g1 --export {out}.csv",
    "solid": "gears {model} --gear g1 --export {out}.stl",
    "preview": "gears {model} --gear g1 --preview {out}.svg",
    "clearance": "clearance {model} -o {out}.svg",
    "modes": "modes {model} -o {out}.h5",
    "response": "frf {model} -i driver.mz -r deflection[stage] --to 2kHz -o {out}.h5 --picture {out}.html",
    "run": "run {model} -s steady -o {out}.h5 -q",
    "sweep": "sweep {model} -s sweep -o {out}.h5 -q",
    "cases": "run {model} -s steady --vary meshes.stage.damper.ratio=0.05,0.1 -o {out}.h5 -q",
    "solvers": "compare-solvers {model} -s steady --limit 1 -o {out}.html -q",
    "table": "analyse {record} amplitude_spectrum -c acc --csv {out}.csv",
    "diagnosis": "diagnose {record} --train 16/24 --speed 25Hz -o {out}.html",
    "scene": "view {result} -o {out}.html",
    "report": "report {model} {result} -o {out}.html",
    "contact": "contact {flanks} --positions 8 -o {out}.h5 --picture {out}.html -q",
    "contact table": "contact-table {flanks} --torque 300 -o {out}.gcp.h5 -q",
    "relief": "relief {flanks} --vary gears.g1.modifications.both.profile_crowning=0:20um --analyses 20 "
    "--positions 8 -o {out}.h5 --picture {out}.html --write {out}.yaml -q",
    "copies": "examples copy backlash-oscillator {out}",
}


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """A model with short scenarios, its result and a measured record."""
    folder = tmp_path_factory.mktemp("files")
    text = TORSION.replace("duration: 0.5 s", "duration: 50 ms").replace("points: 81", "points: 3")
    model = written(folder, text.replace("settle_periods: 200", "settle_periods: 5"))
    flanks = written(folder, FLANKS, "flanks.yaml")
    result, record = str(folder / "result.h5"), folder / "record.csv"
    assert run_command(["run", model, "-s", "steady", "-o", result, "-q"]) == 0
    t = np.arange(20_000) / 10_000.0
    noise = np.random.default_rng(1).normal(size=t.size)
    # 25 Hz and its mesh of 16 teeth with two harmonics determine the speed
    lines = sum(np.sin(2.0 * np.pi * f * t) for f in (25.0, 400.0, 800.0, 1200.0))
    np.savetxt(record, np.column_stack([t, lines + 0.3 * noise]), "%.6g", ",", header="time,acc", comments="")
    return {"model": model, "flanks": flanks, "result": result, "record": str(record)}


def limited(command: str, names: dict[str, str], limit: int) -> subprocess.CompletedProcess[str]:
    """Run a command in a process whose files must not grow beyond a limit [bytes].

    Without bytecode: Python would keep files that the limit has cut.
    """
    arguments = [word.format(**names) for word in command.split()]
    return subprocess.run(
        [sys.executable, "-B", "-c", CHILD, str(limit), *arguments],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
        cwd=Path(names["out"]).parent,
    )


@pytest.mark.study
@pytest.mark.parametrize("name", COMMANDS)
def test_no_command_crashes_where_writing_is_refused(
    name: str, files: dict[str, str], tmp_path: Path, record_property: Callable[[str, object], None]
) -> None:
    refused = 0
    for limit in LIMITS:
        folder = tmp_path / str(limit)
        folder.mkdir()
        done = limited(COMMANDS[name], {**files, "out": str(folder / "out")}, limit)
        assert done.returncode in (0, 3), (limit, done.returncode, done.stderr)
        assert "Traceback" not in done.stderr and "internal error" not in done.stderr, (limit, done.stderr)
        if done.returncode == 3:
            refused += 1
            assert "cannot be written" in done.stderr, (limit, done.stderr)
    assert refused, "no limit was reached"
    record_property("refused", refused)
    whole = limited(COMMANDS[name], {**files, "out": str(tmp_path / "out")}, 2**40)
    assert whole.returncode == 0, whole.stderr
