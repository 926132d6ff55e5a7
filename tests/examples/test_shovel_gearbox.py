# SPDX-License-Identifier: Apache-2.0
"""examples/shovel-gearbox: forces, penetrations and spectra of a crawler gearbox against hand calculation.

Sources: SEED-SHOVEL (founding paper on the shovel) for teeth, speeds and load; SHOVEL-437 for the mean forces
at 437 kN m, which follow from the torques without losses: F_n = T/(r_b cos beta_b).
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint import compile_model, load_model, solve_time
from pitchpoint.analysis.harmonics import harmonic_table
from pitchpoint.solvers.time import run_time
from tests.support.scripts import script

HERE = Path(__file__).parents[2] / "examples" / "shovel-gearbox"
SHOVEL_437 = {"stage_1": 51.60e3, "stage_2": 261.2e3, "stage_3": 861.2e3}
MESH_FREQUENCIES = {"stage_1": 135.667, "stage_2": 20.099, "stage_3": 3.251}


@pytest.fixture(scope="module")
def paper():
    return load_model(HERE / "paper.yaml")


def rated(model, duration, settle, **more):
    """The rated scenario over another duration, at speed after a fifth of a second."""
    ramp = {"table": [["0 s", "0 rpm"], ["0.2 s", "740 rpm"]]}
    drives = {f"scenarios.rated.drive.{b}.speed": ramp for b in model.scenarios["rated"].drive}
    times = {"scenarios.rated.duration": duration, "scenarios.rated.settle_time": settle}
    return model.replace_all({**drives, **times, **more})


@pytest.mark.parametrize("law", ["impact", "restitution", "din3990"])
@pytest.mark.filterwarnings("ignore:profile shifts")  # x of stage 3 lies outside the polynomial of DIN 3990
def test_mean_forces_follow_from_the_torques(paper, law):
    """SHOVEL-437 asks for 1 %; without friction nothing is lost, and what is left is the window, no whole
    number of mesh periods of stage 3 (1 % ripple over 3.25 periods)."""
    model = script(HERE / "levels.py").with_law(paper, law)
    still = {f"meshes.{m}.friction": None for m in model.meshes}
    done = run_time(compile_model(rated(model, 1.6, 0.6, **still), "rated"))
    for stage, force in SHOVEL_437.items():
        for side in ("", "_right"):
            assert done.channels[f"normal_force[{stage}{side}]"]["mean"] == pytest.approx(force, rel=4e-3)


@pytest.mark.filterwarnings("ignore:profile shifts")
def test_side_by_side_table_closes_along_the_shafts():
    """Axial forces of the four shafts of a side are inner forces of its meshes: their sum is zero, to the
    0.05 kN that one decimal leaves in each."""
    lines = script(HERE / "levels.py").table(1.2)
    rows = [line.split()[-6::2] for line in lines if "axial" in line]
    axial = np.array(rows, float)
    assert axial.shape == (4, 3)
    assert np.all(np.abs(axial) > 10.0)
    assert np.abs(axial.sum(axis=0)).max() <= 4 * 0.05


def test_penetration_of_stage_3_under_one_pair(paper):
    """861.2 kN on one pair: 0.853 mm, where the contact line of a single pair runs over the whole width."""
    still = {f"meshes.{m}.friction": None for m in paper.meshes}
    done = run_time(compile_model(rated(paper, 1.6, 0.6, **still), "rated"))
    assert done.channels["penetration[stage_3]"]["max"] == pytest.approx(0.853e-3, rel=0.01)


@pytest.fixture(scope="module")
def record(paper):
    """Four seconds at speed of the left side, healthy."""
    return solve_time(compile_model(rated(paper, 4.6, 0.6), "rated")).sel(time=slice(0.6, None))


@pytest.mark.parametrize("stage", MESH_FREQUENCIES)
def test_spectra_of_the_tooth_forces_have_the_mesh_frequencies(record, stage):
    """To 0.1 % from four seconds, whose lines are 0.25 Hz apart."""
    force = record[f"mesh_force[{stage}]"].values
    rate = 1.0 / float(np.diff(record.time.values).mean())
    expected = MESH_FREQUENCIES[stage]
    found = harmonic_table(force - force.mean(), rate, expected, harmonics=2)
    assert found.fundamental == pytest.approx(expected, rel=1e-3)
    assert found.amplitude[0] > 10.0 * found.background[0]


def test_the_ripple_of_stage_3_is_felt_in_the_others(record):
    """The third shaft swings at 3.251 Hz; stages 1 and 2 carry that, far above what stands beside it."""
    rate = 1.0 / float(np.diff(record.time.values).mean())
    for stage in ("stage_1", "stage_2"):
        force = record[f"mesh_force[{stage}]"].values
        found = harmonic_table(force - force.mean(), rate, MESH_FREQUENCIES["stage_3"], harmonics=1)
        assert found.amplitude[0] > 3.0 * found.background[0]


def test_support_forces_carry_the_teeth(record):
    """Both bearings of the second shaft against the tooth forces on it, by hand, at every instant."""
    length, z2, z3 = 0.51, 0.13, 0.34
    b_y = record["signal[second_b_y]"].values
    a_y = record["signal[second_a_y]"].values
    one, two = (record[f"circumferential_force[stage_{k}]"].values for k in (1, 2))
    # the circumferential force is that on gear 2 of the mesh; friction turns it by atan(mu) at most (8 %)
    off = a_y + b_y + one - two
    assert np.abs(off).max() < 0.08 * np.abs(a_y + b_y).max()
    # the middle of the contact lines of a helical pair wanders along the width, to both sides alike
    lever = (one * z2 - two * z3) / length
    assert b_y.mean() == pytest.approx(-lever.mean(), rel=0.02)


def test_healthy_and_faulty_models_differ_in_numbers_only(paper):
    """Severity 0 gives the bits of a gearbox without any fault."""
    without = paper.replace("gears.Z5.faults", {})
    ends = []
    for model in (paper, without):
        done = run_time(compile_model(rated(model, 0.3, 0.2), "rated"))
        ends.append(done.channels["mesh_force[stage_3]"])
    assert ends[0] == ends[1]


def test_bearings_of_the_model_have_the_stiffness_of_the_formula():
    """`bearings.py` prints three digits; the loads it starts from are those of the model to 2 %."""
    model, formula = load_model(HERE / "model.yaml"), script(HERE / "bearings.py")
    for shaft, numbers in formula.BEARINGS.items():
        radial, axial = formula.stiffness(*numbers)
        given = model.bearings[f"{shaft}_a"].stiffness
        assert given.radial == pytest.approx(radial, rel=5e-3)
        assert given.axial == pytest.approx(axial, rel=5e-3)


def test_elastic_shafts_carry_the_same_mean_forces():
    """Both sides mirror each other; mean loads are those that the stiffness of the bearings starts from (2 %:
    they are rounded, and a window of 0.6 s is no whole number of periods of stage 3)."""
    model = load_model(HERE / "model.yaml")
    done = run_time(compile_model(rated(model, 0.9, 0.3), "rated")).channels
    for shaft, (load, *_) in script(HERE / "bearings.py").BEARINGS.items():
        radial = [
            math.hypot(*(done[f"bearing_force[{shaft}_{end}.f{axis}]"]["mean"] for axis in "xy"))
            for end in "ab"
        ]
        assert max(radial) == pytest.approx(load, rel=0.02)
        for axis, sign in (("x", 1.0), ("y", 1.0), ("z", -1.0)):
            left = done[f"bearing_force[{shaft}_a.f{axis}]"]["mean"]
            right = done[f"bearing_force[{shaft}_right_a.f{axis}]"]["mean"]
            assert right == pytest.approx(sign * left, rel=2e-3, abs=1.0)
