# SPDX-License-Identifier: Apache-2.0
"""examples/shovel-gearbox, the story: geometry, contact parameters, the fault in noise, and the page.

Sources: SEED-SHOVEL (founding paper on the shovel) and SHOVEL-437 for geometry, stiffness and forces,
FD-WAVELET for the period that a5 must show.
"""

from __future__ import annotations

import re
import sys
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

HERE = Path(__file__).parents[2] / "examples" / "shovel-gearbox"
NAMES = ("study", "diagnosis", "levels", "story_sections", "story_diagnosis", "story")
TURN = 60.0 * (81 / 11) * (68 / 12) / 740.0
"""Period of the third shaft [s], from teeth and speed."""


@pytest.fixture(scope="module")
def modules():
    """The scripts of the example, by name; they import each other as their folder is that of the script."""
    sys.path.insert(0, str(HERE))
    kept = {name: sys.modules.pop(name, None) for name in NAMES}
    try:
        yield {name: import_module(name) for name in NAMES}
    finally:
        sys.path.remove(str(HERE))
        for name, module in kept.items():
            sys.modules.pop(name, None)
            if module is not None:
                sys.modules[name] = module


@pytest.fixture(scope="module")
def runs(modules):
    """Fifteen seconds at rated speed, healthy and with the broken tooth."""
    return modules["study"].healthy_and_faulty()


@pytest.fixture(scope="module")
def frictionless(modules):
    return modules["study"].without_friction(1.5)


@pytest.fixture(scope="module")
def forces(modules, runs):
    return modules["diagnosis"].pair_of(*runs)


def test_stiffness_is_that_of_table_4_with_the_operating_diameter(modules):
    """1e-4; with the standard diameter that the paper names it is lower by sqrt(cos a_wt/cos a_t) each."""
    study = modules["study"]
    stages = study.stages(study.load_model(HERE / "paper.yaml"))
    low = (6.78996e5, 8.03634e5, 10.72487e5)
    for stage, table4, standard in zip(stages, study.PRINTED["stiffness"], low, strict=True):
        assert study.in_mm(stage.stiffness_working, 1.5) == pytest.approx(table4, rel=1e-4)
        assert study.in_mm(stage.stiffness_reference, 1.5) == pytest.approx(standard, rel=1e-5)
    assert [round(100 * s.damping_share, 3) for s in stages] == [0.147, 0.123, 0.091]
    assert stages[2].penetration == pytest.approx(0.853e-3, rel=1e-3)


def test_kinematics_are_those_printed(modules):
    study = modules["study"]
    train = study.frequencies(study.load_model(HERE / "paper.yaml"))
    assert np.round(train.mesh, 3).tolist() == [135.667, 20.099, 3.251]
    assert 60.0 * train.shaft[2] == pytest.approx(17.734205, rel=1e-7)
    assert modules["diagnosis"].TURN == pytest.approx(TURN, rel=1e-12)


def test_record_is_that_of_the_paper(forces):
    """6456 steps in 15 s."""
    assert forces.healthy.shape == forces.faulty.shape == forces.angle.shape == (6456,)
    turned = abs(forces.angle[-1] - forces.angle[0]) / (2 * np.pi)
    assert turned == pytest.approx(6455 / 430.4 / TURN, rel=1e-4)


@pytest.mark.parametrize("stage", [0, 1, 2])
def test_mean_forces_and_mesh_frequencies(modules, runs, frictionless, stage):
    """Frequencies to 0.1 % by the interpolated peak, forces to 1 % of T/(r_b cos beta_b) without friction;
    every stage feels both others, far above what stands beside these lines."""
    study = modules["study"]
    expected = study.frequencies(study.load_model(HERE / "paper.yaml")).mesh
    found = study.tooth_forces(runs[0], frictionless, expected)[stage]
    assert found.frequency == pytest.approx(expected[stage], rel=1e-3)
    assert found.lossless == pytest.approx(study.LOSSLESS[stage], rel=0.01)
    assert np.all(found.others > 100.0 * found.background)


def test_the_broken_tooth_moves_the_load_once_per_turn(forces):
    """Both forces are the same but for the meshes of the broken tooth: of 11 tooth pitches per turn it takes
    part in less than three (total contact ratio 1.95, and what swings after it)."""
    apart = np.abs(forces.faulty - forces.healthy)
    share = np.mean(apart > 0.02 * apart.max())
    assert 1.0 / 11.0 < share < 3.0 / 11.0
    assert apart.max() > 2.0 * forces.healthy.std()


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [pytest.param(0.0, marks=pytest.mark.study), -5.0])
@pytest.mark.study
def test_period_is_read_from_a5_for_twenty_of_twenty_seeds(modules, forces, ratio):
    """3.383 s within 0.5 %; the healthy gearbox shows no period: allowed is a chance of 0.1 % each."""
    found = modules["diagnosis"].readings(forces, ratio, seeds=20, healthy_seeds=20)
    assert found.hits == 20
    assert found.worst < 5e-3
    assert found.false_alarms == 0
    assert np.nanmean(found.faulty) == pytest.approx(TURN, rel=1e-3)


def test_the_comb_in_a5_outlasts_the_other_indicators(modules, forces):
    """At -10 dB it finds every one of twenty signals; kurtosis and FM4, which see only what the noise leaves
    of the impact, have lost half of them."""
    found = modules["diagnosis"].curves(forces, seeds=20, snr=(-10.0,))
    rate = dict(zip(found.detectors, found.rate[:, 0], strict=True))
    assert rate["comb in a5"] == 1.0
    assert max(rate["kurtosis"], rate["FM4 of the synchronous average"]) <= 0.5


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore:profile shifts")  # x of stage 3 lies outside the polynomial of DIN 3990
@pytest.mark.study
def test_page_holds_the_numbers_and_where_they_come_from(modules, runs, frictionless, monkeypatch):
    """Few seeds, short runs of the laws and half of the run-up; the page is the same. Its other runs are
    those of the tests above."""

    def shorter(*which, record, **more):
        return modules["study"].simulate(*which, record=min(record, 8.0), **more)

    monkeypatch.setattr(modules["story"], "simulate", shorter)
    monkeypatch.setattr(modules["story"], "healthy_and_faulty", lambda: runs)
    monkeypatch.setattr(modules["story"], "without_friction", lambda: frictionless)
    told = modules["story"].tell(law_seconds=1.5, seeds=2, healthy_seeds=19, elastic=False)
    text = modules["story"].html(told)
    assert [int(n) for n in re.findall(r"<h2[^>]*>(\d) ", text)] == list(range(1, 10))
    for number in ("135.667", "6.8239", "8.1018", "10.9403", "17.7342", "3.3833", "2 of 2", "0 of 19"):
        assert number in text
    for source in (
        "hertz_constant(",
        "run healthy: normal_force[stage_3]",
        "find_period of a5",
        "signal[third_a_y]",
    ):
        assert source in text
    for run in (told.healthy, told.faulty, told.run_up):
        assert run.data.attrs["model_hash"] in text
    assert told.healthy.data.attrs["model_hash"] != told.faulty.data.attrs["model_hash"]
    assert text.count('class="plot"') >= 18
    assert not re.search(r"""(src|href)=["']?https?:""", text.split("<script>")[0])
