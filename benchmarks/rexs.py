# SPDX-License-Identifier: Apache-2.0
"""A two-stage gearbox from REXS: imported, compiled, 100 modes."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from benchmarks.rows import Row, cpu_seconds

FILE = Path(__file__).parent / "two_stage.rexs"
"""`FVA-Industriegetriebe_2stufig_1-4.rexs` of rexs-api-cpp, see `NOTICE`."""


def hundred_modes() -> int:
    """Import the gearbox, compile it, compute its modes; their number, at most 100."""
    from pitchpoint.io.rexs.importing import import_rexs
    from pitchpoint.solvers.modal import solve_modal
    from pitchpoint.system.compile import compile_model

    model = import_rexs(FILE).model
    return len(solve_modal(compile_model(model, "steady"))["frequency"].values[:100])


def rows() -> list[Row]:
    """Measure in a process of its own, with one thread for linear algebra like `pitchpoint` itself."""
    one_thread = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks.rexs"], env=one_thread, capture_output=True, text=True, check=True
    )
    text = "CPU time of one thread, warm; 3-D with elastic shafts, mean stiffness over the mesh cycles"
    return [Row("REXS two-stage gearbox, 100 modes", float(done.stdout), "s", "<= 3", text)]


if __name__ == "__main__":
    assert hundred_modes() == 100
    print(cpu_seconds(hundred_modes, 3))
