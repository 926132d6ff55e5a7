# SPDX-License-Identifier: Apache-2.0
"""Every kernel is compiled once: a second signature means that some array has another type or layout."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

MODEL = """
gears:
  g1: {number_of_teeth: 50, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 50, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  driver: {gears: [g1], motion: torsion, inertia: 0.0115 kg m^2}
  driven: {gears: [g2], motion: torsion, inertia: 0.0115 kg m^2}
meshes:
  stage: {gears: [g1, g2], center_distance: 150 mm, stiffness: {law: din3990}, damper: {ratio: 0.05}}
loads:
  input: {body: driver, torque: "150 N m * (1 + 0.1*sin(2*pi*25 Hz*t))"}
  output: {body: driven, torque: 150 N m}
scenarios:
  steady: {speed: {driver: 1500 rpm}, duration: 2 ms, sample_rate: 100 kHz}
"""

CODE = """
import contextlib, io, sys
from pitchpoint.cli.main import run_command
with contextlib.redirect_stdout(io.StringIO()):
    status = run_command(["run", sys.argv[1], "--scenario", "steady", "-o", sys.argv[2], "--json", "--quiet"])
assert status == 0, status
from numba import types
from pitchpoint.core.kernel import Kernel
kernels = {}
for name, module in list(sys.modules.items()):
    if name.startswith("pitchpoint"):
        kernels.update({v.py_func: v for v in vars(module).values() if isinstance(v, Kernel)})
for function, kernel in kernels.items():
    found = {tuple(types.unliteral(t) for t in signature) for signature in kernel.signatures}
    if len(found) > 1:
        print(function.__name__)
"""

# these hand out memory of any type and shape
GENERIC = {"view", "call", "call_law", "pooled"}


@pytest.mark.slow
@pytest.mark.skipif(os.environ.get("NUMBA_DISABLE_JIT") == "1", reason="nothing is compiled")
def test_every_kernel_has_one_signature(tmp_path):
    file = tmp_path / "model.yaml"
    file.write_text(MODEL)
    command = [sys.executable, "-c", CODE, str(file), str(tmp_path / "out.h5")]
    # an empty cache, because kernels that come from it do not show the signatures of those they call
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path / "cache")}
    run = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
    assert run.returncode == 0, run.stderr
    assert set(run.stdout.split()) <= GENERIC
