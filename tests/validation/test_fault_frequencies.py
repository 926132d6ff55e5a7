# SPDX-License-Identifier: Apache-2.0
"""Published fault frequencies: gear pairs, planet sets, trains of test rigs and of the mining shovel.

FD-BANDS: MathWorks, gearMeshFaultBands (teeth 8/42 at 20 per unit of time). KS-NRELGBX: KISSsoft reports of
the 5 MW reference gearbox; its fault frequencies were recomputed to the digits given. PL-PHASE:
drivetrainhub.com, planets counted counter-clockwise. SEED-SHOVEL: printed frequencies and period of the
founding paper. PHM 2009: kinematics of the generic gearbox of the data challenge. Where a source prints
digits, the tolerance is half a unit of the last one; closed forms to round-off.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.analysis.bearing_frequencies import bearing_frequencies
from pitchpoint.analysis.fault_frequencies import PlanetStage, gear_pair_frequencies, train_frequencies
from pitchpoint.analysis.planet_frequencies import excited_motion, planet_phases, planetary_frequencies
from tests.support.printed import printed

RPM = math.pi / 30.0
HZ = 2.0 * math.pi


def test_fd_bands():
    f = gear_pair_frequencies(8, 42, 20.0 * HZ)
    assert f.rotation_1 == pytest.approx(20.0, rel=1e-12)
    assert f.rotation_2 == printed("3.8095")
    assert f.assembly_phase == pytest.approx(80.0, rel=1e-12)
    assert f.mesh == pytest.approx(160.0, rel=1e-12)
    assert f.hunting_tooth == printed("0.95238")
    assert f.common_factor == 2


def test_nrel_gearbox_stages():
    f = train_frequencies([PlanetStage(19, 17, 56), PlanetStage(18, 36, 93), (95, 24)], 12.1 * RPM)
    assert f.mesh[0] == printed("11.2933")
    assert f.mesh[1] == printed("74.0329")
    assert f.mesh[2] == printed("466.3542")
    assert abs(f.speed[3] / f.speed[0]) == printed("96.354167")
    assert f.shaft[1] * 60.0 == printed("47.8")
    assert f.shaft[3] * 60.0 == printed("1165.9")


def test_nrel_gearbox_faults():
    f = planetary_frequencies(
        z_sun=19, z_planet=17, z_ring=56, planets=3, speed_carrier=12.1 * RPM, speed_ring=0.0
    )
    assert f.sun_fault == printed("1.78316")
    assert f.planet_fault == printed("0.66431")
    assert f.planet_fault_both == pytest.approx(2.0 * f.planet_fault, rel=1e-15)
    assert f.ring_fault == printed("0.60500")


@pytest.mark.parametrize(
    ("teeth", "sequence"),
    [((48, 80), (0, 0, 0, 0)), ((51, 85), (0, 0.75, 0.5, 0.25)), ((54, 90), (0, 0.5, 0, 0.5))],
)
def test_planet_phases(teeth, sequence):
    for phase in (planet_phases(z, HZ * np.arange(4) / 4) for z in (teeth[0], -teeth[1])):
        for found, given in zip(phase, sequence, strict=True):
            assert found == pytest.approx(given, abs=1e-12)


def test_which_modes_the_phases_excite():
    """5 MW stage 1: fundamental sideways, third harmonic in turning; stage 2 and the GRC gearbox in phase."""
    assert excited_motion(19, 3) == ("translational", "translational", "rotational")
    assert excited_motion(18, 3) == ("rotational",) * 3
    assert excited_motion(21, 3) == ("rotational",) * 3


def test_grc_gearbox_ratio():
    f = train_frequencies([PlanetStage(21, 39, 99), (82, 23), (88, 22)], 22.09 * RPM)
    assert f.shaft[1] / f.shaft[0] == printed("5.714286")
    assert abs(f.speed[3] / f.speed[0]) == printed("81.490683")
    assert f.shaft[3] * 60.0 == pytest.approx(1800.0, rel=1e-4)  # 22.09 has four digits


def test_phm_2009_rig():
    """Spur gears 32/96 and 48/80 at 30 Hz; eight balls of 0.3125 inch on 1.319 inch."""
    f = train_frequencies([(32, 96), (48, 80)], 30.0 * HZ)
    assert f.mesh[0] == pytest.approx(960.0, rel=1e-12)
    assert f.mesh[1] == pytest.approx(480.0, rel=1e-12)
    assert f.shaft[0] == pytest.approx(30.0, rel=1e-12)
    assert f.shaft[1] == pytest.approx(10.0, rel=1e-12)
    assert f.shaft[2] == pytest.approx(6.0, rel=1e-12)
    assert f.speed[0] / f.speed[2] == pytest.approx(5.0, rel=1e-12)
    ball = bearing_frequencies(
        elements=8, element_diameter=0.3125, pitch_diameter=1.319, speed_inner=30.0 * HZ
    )
    assert ball.ftf == pytest.approx(30.0 * 0.5 * (1.0 - 0.3125 / 1.319), rel=1e-12)
    assert ball.bpfo == pytest.approx(8.0 * ball.ftf, rel=1e-12)


def test_uconn_rig():
    f = train_frequencies([(32, 80), (48, 64)], 1.0)
    assert f.speed[0] / f.speed[2] == printed("3.3333")


def test_seed_shovel():
    f = train_frequencies([(11, 81), (12, 68), (11, 36)], 740.0 * RPM)
    assert f.mesh[0] == printed("135.667")
    assert f.mesh[1] == printed("20.099")
    assert f.mesh[2] == printed("3.251")
    assert f.shaft[2] * 60.0 == printed("17.734")
    assert f.shaft[2] == printed("0.295570")
    assert 1.0 / f.shaft[2] == printed("3.383292")
    assert 1.0 / f.shaft[3] == printed("11.072593")
    assert abs(f.speed[0] / f.speed[3]) == printed("136.561983")
    assert f.stages[2].rotation_1 == printed("0.295570")
