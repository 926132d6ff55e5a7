# SPDX-License-Identifier: Apache-2.0
"""One event per turn in the wavelet level of a mesh, and which gear of a shaft an event is due to."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.diagnosis import Diagnosis, diagnose
from pitchpoint.analysis.line_tests import fine_spectrum
from pitchpoint.analysis.shaft_periods import shaft_period, shaft_periods, tooth_level
from pitchpoint.analysis.shaft_tests import ShaftView
from pitchpoint.analysis.tooth_energy import share_of_finer
from pitchpoint.analysis.turning_parts import train_parts
from pitchpoint.analysis.wavelets import approximation, wavelet_levels
from tests.support.bearing_signal import RATE, bearing_force, noisy

SHOVEL = train_parts([(11, 81), (12, 68), (11, 36)])
PER_TURN = RATE / (740.0 / 60.0)
RIG = train_parts([(32, 96), (48, 80)])


def _view(x: np.ndarray, shaft: int) -> ShaftView:
    spectrum = fine_spectrum(x, PER_TURN)
    return ShaftView(spectrum, SHOVEL, SHOVEL.shafts[shaft], float(x.std()), PER_TURN)


def _of_rig(shaft: int, seed: int = 1) -> Diagnosis:
    """A tooth that carries less once per turn of one of three shafts with speeds of 1, 1/3 and 1/5."""
    turned = np.arange(90_000) / 300.0
    turning, teeth = float(RIG.shafts[shaft].order), (32, 48, 80)[shaft]
    gap = np.exp(-((((turned * turning + 0.37) % 1 - 0.5) * teeth / 0.5) ** 2))
    x = 0.5 * np.random.default_rng(seed).standard_normal(turned.size) - gap
    x += np.cos(2 * np.pi * 32 * turned) + np.cos(2 * np.pi * 16 * turned)
    return diagnose({"acc": x}, 300.0, RIG)


def test_the_level_is_the_lowest_with_two_harmonics_of_the_mesh() -> None:
    """Meshes of 3.25, 20.1 and 135.7 Hz at 430.4 Hz: a5 to 6.7 Hz, a2 to 53.8 Hz, and the signal itself."""
    x = bearing_force()
    orders = [SHOVEL.mesh_order(mesh) for mesh in SHOVEL.meshes]
    levels = [tooth_level(x, PER_TURN, order) for order in orders]
    assert [one.level for one in levels] == [0, 2, 5]
    assert levels[0].values is x and levels[2].values.size == -(-x.size // 8)
    # fewer samples, the same values as the first row of the decomposition
    assert levels[2].values == pytest.approx(wavelet_levels(x, RATE).signals[0][::8], abs=1e-9)


def test_samples_of_a_file_are_read_only() -> None:
    x = bearing_force()
    x.flags.writeable = False
    assert approximation(x, 2).shape == wavelet_levels(x, RATE).signals[0].shape


@pytest.mark.parametrize("seed", range(3))
def test_a_wide_ranking_misses_what_the_level_shows(seed: int) -> None:
    """20 raised orders of 655 are a small part of each band that is ranked; the level holds no others."""
    x = noisy(bearing_force(1.5), 0.0, seed)
    view = _view(x, 2)
    assert view.comb().probability > 1e-3
    assert shaft_period(x, PER_TURN, view, 11).probability < 1e-7
    assert view.highest > 600


def test_noise_and_meshes_are_no_period() -> None:
    """Of 40 draws with three shafts each, the least probable is above a tenth of the share of one test."""
    lowest = 1.0
    for seed in range(40):
        x = noisy(bearing_force(), 0.0, seed)
        views = {shaft.name: _view(x, k) for k, shaft in enumerate(SHOVEL.shafts)}
        tests = shaft_periods(x, PER_TURN, views, SHOVEL)
        assert [(shaft, gear) for _, shaft, gear, _ in tests] == [
            ("shaft 1", "Z1"),
            ("shaft 2", "Z2"),
            ("shaft 2", "Z3"),
            ("shaft 3", "Z4"),
            ("shaft 3", "Z5"),
        ]
        lowest = min(lowest, *(found.probability for *_, found in tests))
    assert lowest > 1.0 / (10 * 40 * 5)


def test_a_strong_line_of_an_unbalance_is_no_period() -> None:
    turned = np.arange(6456) / PER_TURN
    x = noisy(bearing_force(), 0.0, 1) + 20.0 * np.cos(2 * np.pi * float(SHOVEL.shafts[2].order) * turned)
    assert shaft_period(x, PER_TURN, _view(x, 2), 11).probability > 0.01


@pytest.mark.parametrize(("shaft", "name"), [(0, "shaft 1"), (1, "shaft 2"), (2, "shaft 3")])
def test_the_period_of_a_slower_shaft_is_not_that_of_a_faster_one(shaft: int, name: str) -> None:
    """All orders of the input are orders of both slower shafts."""
    found = _of_rig(shaft)
    assert [(one.kind, one.shaft) for one in found.findings] == [("local fault", name)]
    causes = {e.explained for e in found.evidence if e.kind == "period" and e.shaft == "shaft 1"}
    assert causes == ({f"the period of {name}"} if shaft else {""})


@pytest.mark.parametrize(("pitches", "share"), [(1.0, 2 * 12 / 80), (0.5, 4 * 12 / 80), (0.1, 1.0)])
def test_the_length_of_an_event_tells_the_coarse_gear(pitches: float, share: float) -> None:
    """Constant over a part of a pitch of 12 teeth, over noise that counts for neither gear."""
    turn = 0.05 * np.random.default_rng(1).standard_normal(960 * 5)
    turn[1000 : 1000 + round(400 * pitches)] += 1.0
    assert share_of_finer(turn, coarse=12, fine=80) == pytest.approx(share, abs=0.03)


def test_a_short_event_names_both_gears_and_a_long_one_the_coarse_gear() -> None:
    """Over a pitch of Z3 (12 teeth) or of Z2 (81 teeth), in noise with the lines of both meshes."""
    named = {}
    for teeth in (12, 81):
        turned = np.arange(100_000) / 400.0
        inside = (turned * 11 / 81 + 0.3) % 1 < 1.0 / teeth
        x = np.cos(2 * np.pi * 11 * turned) + np.cos(2 * np.pi * 11 * 12 / 81 * turned) + 2.0 * inside
        x += 0.5 * np.random.default_rng(1).standard_normal(turned.size)
        (found,) = diagnose({"acc": x}, 400.0, train_parts([(11, 81), (12, 68)])).findings
        named[teeth] = found.shaft, found.gears
    assert named == {12: ("shaft 2", ("Z3",)), 81: ("shaft 2", ("Z2", "Z3"))}
