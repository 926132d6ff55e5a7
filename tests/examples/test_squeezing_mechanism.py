# SPDX-License-Identifier: Apache-2.0
"""The example `squeezing-mechanism`: the published end from the file, with loops closed by pins of space.

Coordinates count from the published start, and whole turns apart. Tolerances are ten times what the tolerance
of 1e-8 leaves over (tests/validation/test_andrews.py has the convergence).
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.compile import compile_model
from tests.support.squeezer import END, END_SPEED, START, published

FILE = Path(__file__).parents[2] / "examples" / "squeezing-mechanism" / "model.yaml"


@pytest.mark.parametrize("method", ["wstiff", "dassl"])
def test_the_published_end_is_met(method):
    model = load_model(FILE).replace("scenarios.squeeze.method", method)
    done = run_time(compile_model(model, "squeeze"), sink=Memory())
    miss = np.mod(done.state.q + published(START) - published(END) + math.pi, 2.0 * math.pi) - math.pi
    assert np.abs(miss[:2]).max() < 2e-6  # crank and rod, after two and a half turns
    assert np.abs(miss[2:]).max() < 4e-8
    # crank, rod against the crank, triangle
    np.testing.assert_allclose(done.state.v[:3], END_SPEED, rtol=0, atol=2e-4)


def test_the_rows_that_repeat_others_are_named():
    done = run_time(compile_model(load_model(FILE), "squeeze"), sink=Memory())
    for knot in ("triangle", "upper", "lower"):
        for row in ("z", "zx", "zy"):
            assert any(f"knot_{knot}.{row}" in note for note in done.notes)
