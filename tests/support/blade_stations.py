# SPDX-License-Identifier: Apache-2.0
"""Blade stations between two bodies, for tests of the element alone."""

from __future__ import annotations

import numpy as np

from pitchpoint.elements import blade_station
from pitchpoint.elements.rotor.record import air_record, polar_rows, station_records, tower_rows
from pitchpoint.geometry.rotor.flow import RotorFlow
from pitchpoint.geometry.rotor.tower import Tower
from pitchpoint.model.wind.steady import SteadyWind
from pitchpoint.system.wind import WindField
from tests.support.rotors import report_rotor


def stations_between(rng):
    """Three stations of a blade of the NREL 5 MW between both bodies, the first of them the hub, in wind
    across the axis, with a tower."""
    rotor, flow = report_rotor(), RotorFlow()
    records = np.zeros(3, blade_station.RECORD)
    records["i"], records["j"], records["k"] = 1, 2, 1
    shares = np.array([0.2, 0.5, 1.0])
    records["share_i"], records["share_j"], records["w_i"], records["w_j"] = (
        1 - shares,
        shares,
        1 - shares,
        shares,
    )
    records["a_i"], records["a_j"] = rng.normal(size=(2, 3, 3))
    records["a_i"][:, 0] += np.array([2.0, 3.0, 5.0])
    for end, share in (("i", 1.0 - shares), ("j", shares)):
        records[f"s_{end}"] = share[:, None] * np.array([1.0, 0.1, -0.05])
        records[f"c_{end}"] = share[:, None] * np.array([0.0, 1.0, -0.1])
    records["p_k"], records["axis"] = (0.1, 0.2, 4.0), (0.0, 0.1, np.sqrt(0.99))
    records["a_i"][:, 2] += 4.0
    records["air"], records["blade"] = air_record(flow), station_records(rotor)[[5, 9, 13]]
    wind = SteadyWind(speed=12.0, hub_height=4.0, exponent=0.2, inflow_angle=0.3, direction=0.4)
    records["wind"], records["box"], records["first"][0], records["length"] = (
        WindField(wind).record,
        -1,
        1,
        0.02,
    )
    knots, tower = polar_rows(rotor), tower_rows(Tower(elevation=[0.0, 9.0], diameter=[0.5, 0.3]))
    records["rows"], records["sections"], records["tower"]["n"] = len(knots), knots.size, len(tower)
    records["tower"]["x"] = -3.0
    return records, np.concatenate([knots.ravel(), tower.ravel()])
