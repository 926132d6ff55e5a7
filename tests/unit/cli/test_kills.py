# SPDX-License-Identifier: Apache-2.0
"""Runs, sweeps and varied runs that are killed at any instant keep every sample that a reader has seen.

A process that has its kernels forks one child after the other and kills each at a random instant; 1000 kills
take minutes and are part of `make validate`.
"""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pitchpoint.io.container import ResultError
from pitchpoint.io.reading import open_result, read_header
from tests.support.cli_files import TORSION, written

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")

SHORT = "short.yaml"
LONGEST = 0.4
"""Longest time between the first sample and the kill [s]."""
KINDS = {
    "run": ["run", "-s", "steady"],
    "sweep": ["sweep"],
    "cases": ["run", "-s", "steady", "-j", "2", "--vary"],
}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("kills", [1, pytest.param(334, marks=pytest.mark.study)])
def test_killed_at_any_instant(kind: str, kills: int, tmp_path: Path) -> None:
    text = TORSION.replace("duration: 0.5 s", "duration: 0.02 s" if kind == "cases" else "duration: 500 s")
    file = written(tmp_path, text.replace("points: 81", "points: 501"))
    short = TORSION.replace("duration: 0.5 s", "duration: 0.01 s").replace("points: 81", "points: 2")
    (tmp_path / SHORT).write_text(short, encoding="utf-8")
    many = ",".join(f"{0.02 + 1e-5 * k:.5f}" for k in range(300))
    arguments = [KINDS[kind][0], file, *KINDS[kind][1:]]
    arguments += [f"meshes.stage.damper.ratio={many}"] if kind == "cases" else []
    command = [sys.executable, "-m", "tests.unit.cli.test_kills", str(tmp_path), str(kills), *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60.0 + 10.0 * kills)
    assert done.returncode == 0, done.stderr[-2000:]
    assert done.stdout.splitlines()[-1] == f"{kills} kills"


def seen(path: Path) -> dict[str, Any] | None:
    """What a reader finds: samples of a run, or points and cases that are computed; None before the first."""
    try:
        with open_result(path) as data:
            data.load()
    except ResultError:
        return None
    if "time" in data.dims:
        found = {name: data[name].values for name in ("time", "mesh_force[stage]")}
        return found if data.sizes["time"] else None
    status = data["point_status" if "point_status" in data else "case_status"].values
    values = data["mesh_force[stage]"].values
    return {"values": values[status >= 0]} if (status >= 0).any() else None


def fits(before: dict[str, Any], after: dict[str, Any] | None) -> bool:
    """Whether everything that was seen is there still, and all of it is finite."""
    if after is None:
        return False
    kept = all(len(after[k]) >= len(v) for k, v in before.items())
    if "time" in before:
        kept = kept and all(np.array_equal(after[k][: len(v)], v) for k, v in before.items())
    else:  # cases come in any order
        rows = {row.tobytes() for row in after["values"]}
        kept = kept and all(row.tobytes() in rows for row in before["values"])
    return kept and all(np.isfinite(v).all() for v in after.values())


def kill_often(folder: Path, kills: int, arguments: list[str]) -> None:
    """Start a command and kill it, again and again; compare what is left with what was seen."""
    from pitchpoint.cli.main import run_command

    chance = random.Random(kills)
    scenario = ["-s", "steady"] if arguments[0] == "run" else []
    run_command([arguments[0], str(folder / SHORT), *scenario, "-o", str(folder / "short.h5"), "-q"])
    for k in range(kills):
        target = folder / f"killed-{k}.h5"
        child = os.fork()
        if child == 0:
            os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
            os._exit(run_command([*arguments, "-o", str(target), "-q"]))
        before, until = None, time.monotonic() + 120.0
        while before is None:
            assert time.monotonic() < until
            assert os.waitpid(child, os.WNOHANG) == (0, 0)
            time.sleep(0.01)
            before = seen(target) if target.exists() else None
        time.sleep(chance.uniform(0.0, LONGEST))
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        assert read_header(target)["status"] == "running"
        assert fits(before, seen(target)), k
        target.unlink()


if __name__ == "__main__":
    kill_often(Path(sys.argv[1]), int(sys.argv[2]), sys.argv[3:])
    print(f"{sys.argv[2]} kills")
