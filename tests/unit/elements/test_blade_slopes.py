# SPDX-License-Identifier: Apache-2.0
"""Derivatives of the loads of a blade station against differences of the loads."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements.rotor.loads import station_loads
from pitchpoint.elements.rotor.record import AIR, POINT, air_record, polar_rows, station_records
from pitchpoint.elements.rotor.slopes import load_slopes, steady_slopes
from pitchpoint.elements.rotor.unsteady import lift_slopes
from pitchpoint.geometry.rotor.flow import RotorFlow
from tests.support.rotors import report_rotor

INPUTS = ("vx", "vy", "pitch", "yaw", "downwind")
STATIONS = station_records(report_rotor())
KNOTS = polar_rows(report_rotor())
OPTIONS = {
    "all": RotorFlow(),
    "without drag": RotorFlow(drag_in_axial_induction=False, drag_in_tangential_induction=False),
    "axial induction only": RotorFlow(tangential_induction=False),
    "tangential induction only": RotorFlow(axial_induction=False),
    "no induction": RotorFlow(axial_induction=False, tangential_induction=False),
    "no losses": RotorFlow(tip_loss=False, hub_loss=False),
}


def loads(point, station, air):
    """Normal and tangential force and moment of a point."""
    again = point.copy()
    station_loads(STATIONS[station], air[0], KNOTS, again[0])
    return np.array([again[name][0] for name in ("f_n", "f_t", "m_c")]), again


def slopes_of(station, air, found, U, L):
    """Derivatives of the loads with the steady lift."""
    lift = np.zeros(2)
    lift_slopes(station, found, KNOTS, found["row"], 0, np.zeros(5), lift)
    load_slopes(station, air, KNOTS, found, U, lift, L)


@pytest.mark.nojit
@pytest.mark.parametrize("options", OPTIONS)
def test_slopes_are_derivatives_of_the_loads(options):
    """Stations from root to tip in all quadrants, lightly and heavily loaded, to 1e-6 of the largest slope.

    Central differences of 1e-5 m/s and rad have an error of 1e-9, kinks of the slopes of the polars aside.
    """
    rng, checked = np.random.default_rng(5), 0
    air = np.asarray(air_record(OPTIONS[options]))
    assert air.dtype == AIR
    U, L = np.zeros((2, 10)), np.zeros((3, 10))
    for case in range(200):
        station = int(rng.integers(0, STATIONS.size))
        point = np.zeros(1, POINT)
        point["vx"], point["vy"] = rng.uniform(-5.0, 20.0), rng.uniform(-20.0, 80.0)
        point["pitch"], point["yaw"], point["downwind"] = rng.uniform(-0.3, 0.6), 0.3, rng.uniform(-1.0, 1.0)
        if case % 4 == 0:
            point["vx"], point["vy"], point["pitch"] = rng.uniform(1.0, 4.0), rng.uniform(40.0, 80.0), 0.0
        _, found = loads(point, station, air)
        steady_slopes(STATIONS[station], air[0], found[0], U)
        slopes_of(STATIONS[station], air[0], found[0], U, L)
        wanted, rough = np.zeros((3, 5)), np.zeros((3, 5))
        for k, name in enumerate(INPUTS):
            for table, step in ((wanted, 1e-5), (rough, 2e-5)):
                ends = []
                for sign in (1, -1):
                    moved = point.copy()
                    moved[name] += sign * step
                    ends.append(loads(moved, station, air)[0])
                table[:, k] = (ends[0] - ends[1]) / (2.0 * step)
        scale = np.abs(wanted).max(axis=1, keepdims=True) + 1e-9
        if (np.abs(wanted - rough) > 1e-6 * scale).any():
            continue  # a knot of the polar or another branch of the theory is within the step
        checked += 1
        np.testing.assert_allclose(L[:, :5] / scale, wanted / scale, atol=2e-6)
    assert checked >= 150
