# SPDX-License-Identifier: Apache-2.0
"""Contact of tooth surfaces keeps forces between evaluations; a second run gives the same bits."""

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.solvers.time import run_time, solve_time
from pitchpoint.system.compile import compile_model
from tests.support.flank_models import pair_text


@pytest.mark.parametrize("level", ["rigid", "flexible"])
def test_a_second_run_gives_the_same_bits(level):
    model = loads_model(pair_text(f"{{level: {level}, planes: 5}}"))
    system = compile_model(model, "run")
    first = solve_time(system)
    roll_through(system, "slow")  # leaves other forces behind
    second = solve_time(system)
    for name in first.data_vars:
        assert np.array_equal(first[name], second[name]), name


def test_the_result_counts_what_the_solver_did():
    """Every step has one or two evaluations, each with a Newton step at least; no pivoting on real flanks."""
    done = run_time(compile_model(loads_model(pair_text()), "run"))
    counters = done.contact_solver["stage"]
    assert counters["newton"] >= done.steps
    assert 0 < counters["factorisations"] <= counters["newton"]
    assert counters["pivoted"] == counters["singles"] == 0
    assert any("contact solver of mesh stage" in str(note) for note in done.notes)
