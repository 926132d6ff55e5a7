# SPDX-License-Identifier: Apache-2.0
"""SEED-CAM: released loads and run-up of the camshaft drive (NTNU thesis, 2015), gates as numbers.

Released loads (figures 4.1 to 4.5): the closed form of a free vibration through backlash, share of time
without contact r/(pi + r) with r = backlash / static deflection; 1e-4. Run-up (figures 4.10 to 4.13): the
thesis prints no value that its own data reproduce (its 1e5 N/m and its 41.4 Hz exclude each other), so its
statements are gates, with bounds around our numbers: the resonance peak with backlash lies below the natural
frequency, contact is lost and the other flank reached through the gap only with backlash, contact loss grows
with backlash. Stiffness and damper act about the axis of gear 2, the stiffness by the printed frequency (see
the page of the example `camshaft-drive`, which scans the other readings).
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.analysis.statistics import contact_statistics
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.compile import compile_model

FOLDER = Path(__file__).parents[2] / "examples" / "camshaft-drive"
BASE_RADIUS, STIFFNESS = 0.2555964, 1.0e5
NATURAL = 41.4
"""Natural frequency that the thesis prints [Hz]; the mean stiffness of the run-up is chosen to give it."""


def time_share(events, names, mesh):
    """Share of the first half period after the release (0.1 s) without contact, from events of the gaps."""
    mine = [k for k, name in enumerate(names) if name.endswith(f"[{mesh}]")]
    parted, touched, again = [t for t, k, _ in events if int(k) in mine and t > 0.1][:3]
    return (touched - parted) / (again - parted)


@pytest.mark.parametrize(
    ("file", "cases"),
    [
        ("release-backlash", {"gap_015": (5.0, 0.15e-3), "gap_043": (5.0, 0.43e-3)}),
        ("release-torque-low", {f"torque_{T}": (T, 0.15e-3) for T in (10, 15, 20)}),
        ("release-torque-middle", {f"torque_{T}": (T, 0.15e-3) for T in (50, 55, 60)}),
        ("release-torque-high", {f"torque_{T}": (T, 0.15e-3) for T in (1000, 1200, 1500)}),
    ],
)
def test_time_without_contact_after_a_release(file, cases):
    model = load_model(FOLDER / f"{file}.yaml").replace("scenarios.release.duration", 0.4)
    done = run_time(compile_model(model, "release"))
    for mesh, (torque, backlash) in cases.items():
        r = backlash * BASE_RADIUS * STIFFNESS / torque
        ours = time_share(done.events, done.event_names, mesh)
        assert ours == pytest.approx(r / (math.pi + r), abs=1e-4)


def test_without_backlash_a_release_loses_no_contact():
    model = load_model(FOLDER / "release-backlash.yaml").replace("scenarios.release.duration", 0.4)
    system = compile_model(model, "release")
    memory = Memory()
    run_time(system, sink=memory)
    state = np.concatenate(memory.rows)[:, system.layout.channel("contact_state[gap_000]")]
    assert np.count_nonzero(state == 0.0) <= 1  # the one sample before the flanks settle, if any
    assert set(state) >= {1.0, -1.0}


@pytest.fixture(scope="module")
def run_up():
    """Time [s], mesh force [N] and contact statistics by backlash [mm], second 15 to 30 of the run-up."""
    model = load_model(FOLDER / "run-up.yaml").replace("scenarios.run_up.duration", 30.0)
    system = compile_model(model, "run_up")
    memory = Memory()
    run_time(system, sink=memory)
    t, rows = np.concatenate(memory.times), np.concatenate(memory.rows)
    late = t > 15.0
    found = {}
    for gap, mesh in ((0.0, "gap_000"), (0.043, "gap_043"), (0.43, "gap_430")):
        force = rows[late, system.layout.channel(f"mesh_force[{mesh}]")]
        state = rows[late, system.layout.channel(f"contact_state[{mesh}]")]
        found[gap] = (t[late], force, contact_statistics(t[late], state, force))
    return found


def peak_frequency(case):
    """Mesh frequency at the largest force [Hz]; the angle of the crank gear is 0.1 t^2."""
    t, force, _ = case
    return 59 * 0.2 * float(t[np.argmax(force)]) / (2.0 * math.pi)


def test_backlash_pulls_the_resonance_below_the_natural_frequency(run_up):
    peaks = {gap: peak_frequency(case) for gap, case in run_up.items()}
    assert peaks[0.43] == pytest.approx(38.2, abs=1.0)
    assert peaks[0.43] < 0.98 * NATURAL
    assert peaks[0.43] < peaks[0.043] < peaks[0.0] + 0.5


def test_the_other_flank_is_reached_through_the_gap_only_with_backlash(run_up):
    through = {
        gap: sum(s.flank_before != s.flank_after for s in case[2].separations) for gap, case in run_up.items()
    }
    assert through[0.0] == 0
    assert through[0.043] > 30
    assert through[0.43] > 4


def test_contact_loss_grows_with_backlash(run_up):
    lost = [run_up[gap][2].loss_share for gap in (0.0, 0.043, 0.43)]
    assert lost[0] == 0.0
    assert lost[1] == pytest.approx(0.0071, abs=0.0015)
    assert lost[2] == pytest.approx(0.069, abs=0.006)


def test_flanks_part_where_the_gapless_force_first_changes_sign(run_up):
    """Until then the gap has not been seen: without backlash the tooth force reverses at the same moment."""
    t, force, _ = run_up[0.0]
    reversed_at = float(t[np.argmax(force < 0.0)])
    for gap in (0.043, 0.43):
        assert run_up[gap][2].separations[0].start == pytest.approx(reversed_at, abs=0.05)


@pytest.mark.parametrize(
    ("time", "ratio"), [(1.0, 22.04), (4.5, 4.90), (7.0, 3.15), (10.0, 2.20), (19.5, 1.13), (48.0, 0.46)]
)
def test_ratio_of_natural_to_mesh_frequency_in_the_run_up(time, ratio):
    """Table 4.1 prints 33, 5, 3, 2, 1 and 1: first and last row do not follow from 41.4 Hz and 0.1 t^2."""
    teeth = load_model(FOLDER / "run-up.yaml").gears["crank"].number_of_teeth
    assert 41.4 / (teeth * 0.2 * time / (2.0 * math.pi)) == pytest.approx(ratio, abs=0.01)
