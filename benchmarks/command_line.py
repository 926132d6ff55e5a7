# SPDX-License-Identifier: Apache-2.0
"""What a user waits for: start of the commands, cold and warm, and the memory of a long run."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from benchmarks.rows import Row

HERE = Path(__file__).parent
BYTE_CODE = tempfile.TemporaryDirectory()


def _wall(arguments: list[str], repeats: int, **environment: str) -> float:
    best = float("inf")
    # as users have it: the interpreter keeps what it made of the sources, here in a folder of its own
    settings = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    for _ in range(repeats):
        begun = time.perf_counter()
        subprocess.run(
            [sys.executable, "-m", "pitchpoint", *arguments],
            check=True,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            env={**settings, "PYTHONPYCACHEPREFIX": BYTE_CODE.name, **environment},
        )
        best = min(best, time.perf_counter() - begun)
    return best


def _peak_memory(steps: int) -> float:
    """Peak memory of a process that runs so many steps into a file [MB]."""
    with tempfile.TemporaryDirectory() as folder:
        code = (
            "import resource, dataclasses;"
            "from pitchpoint.io.yaml_model import load_model;"
            "from pitchpoint.io.container import Header;"
            "from pitchpoint.io.writing import Channel, ResultWriter;"
            "from pitchpoint.system.compile import compile_model;"
            "from pitchpoint.solvers.time import run_time;"
            f"m = load_model({str(HERE / 'pair_12dof.yaml')!r});"
            f"s = dataclasses.replace(m.scenarios['steady'], duration={steps * 5e-6!r}, sample_rate=2e4);"
            "system = compile_model(m, s);"
            "c = [Channel(x.name, x.unit, x.long_name) for x in system.layout.channels];"
            f"w = ResultWriter({str(Path(folder) / 'run.h5')!r}, Header('time'), c);"
            "d = run_time(system, s, sink=w); w.finish('finished', d.sentence);"
            "print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)"
        )
        done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
        return float(done.stdout.split()[-1])


def rows() -> list[Row]:
    """Measure in fresh processes."""
    model = str(HERE / "pair_12dof.yaml")
    found = [Row("pitchpoint --help", _wall(["--help"], 5), "s", "<= 0.3", "wall, fresh process")]
    with tempfile.TemporaryDirectory() as folder:
        out = str(Path(folder) / "run.h5")
        run = ["run", model, "--scenario", "steady", "-o", out, "--json"]
        cold = _wall(run, 1, NUMBA_CACHE_DIR=str(Path(folder) / "cache"))
        warm = _wall(run, 3, NUMBA_CACHE_DIR=str(Path(folder) / "cache"))
    found.append(Row("run, cold", cold, "s", "<= 20", "12-DOF pair, 40 000 steps, empty kernel cache"))
    found.append(Row("run, warm", warm, "s", "", "the same command again, 40 000 steps included"))
    with tempfile.TemporaryDirectory() as folder:
        brief = ["run", model, "--scenario", "brief", "-o", str(Path(folder) / "run.h5"), "--json"]
        text = "12-DOF pair, 200 steps: start, compiled kernels from the cache, file"
        found.append(Row("run, warm start", _wall(brief, 5), "s", "<= 1", text))
    text = "12-DOF pair: start, compiled kernels from the cache, table"
    found.append(Row("modes, warm start", _wall(["modes", model], 5), "s", "<= 1", text))
    found.append(Row("gears, warm", _wall(["gears", model, "--json"], 3), "s", "<= 1", "wall, fresh process"))
    with tempfile.TemporaryDirectory() as folder:
        text = "every kernel compiled, empty kernel cache"
        found.append(Row("warmup", _wall(["warmup"], 1, NUMBA_CACHE_DIR=folder), "s", "<= 120", text))
    short, long = _peak_memory(200_000), _peak_memory(2_000_000)
    text = f"peak {short:.0f} MB after 2e5 steps, {long:.0f} MB after 2e6"
    found.append(Row("memory of a run ten times as long", long / short, "times", "<= 1.05", text))
    return found
