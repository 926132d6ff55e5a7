# SPDX-License-Identifier: Apache-2.0
"""Rotors of the tests: NREL 5 MW from its files and with the stations of its report, polars from formulas."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np

from pitchpoint.geometry.rotor.blade import Blade, Rotor
from pitchpoint.geometry.rotor.polar import Polar
from pitchpoint.model.openfast.aerodyn import AeroDynInput, read_aerodyn

FOLDER = Path(__file__).parents[2] / "examples" / "wind-turbine" / "nrel_5mw"
AERODYN = FOLDER / "onshore" / "AeroDyn.dat"
AIRFOILS = FOLDER / "5MW_Baseline" / "Airfoils"
BLADE = FOLDER / "5MW_Baseline" / "NRELOffshrBsline5MW_AeroDyn_blade.dat"

# stations of NREL/TP-500-38060, Table 3-1: radius, chord [m], twist [deg], airfoil
_REPORT = """
2.8667 3.542 13.308 0 | 5.6 3.854 13.308 0 | 8.3333 4.167 13.308 1 | 11.75 4.557 13.308 2
15.85 4.652 11.48 3 | 19.95 4.458 10.162 3 | 24.05 4.249 9.011 4
28.15 4.007 7.795 5 | 32.25 3.748 6.544 5 | 36.35 3.502 5.361 6
40.45 3.256 4.188 6 | 44.55 3.01 3.125 7 | 48.65 2.764 2.319 7 | 52.75 2.518 1.526 7 | 56.1667 2.313 0.863 7
58.9 2.086 0.37 7 | 61.6333 1.419 0.106 7
"""
HUB, TIP = 1.5, 63.0


@cache
def aerodyn() -> AeroDynInput:
    """AeroDyn's files of the turbine."""
    return read_aerodyn(AERODYN)


def report_rotor(polars: tuple[Polar, ...] | None = None, cone: float = 0.0, tilt: float = 0.0) -> Rotor:
    """Rotor with the stations of the report, with hub and tip, where loads vanish; angles in degrees."""
    table = np.array([row.split() for row in _REPORT.replace("\n", "|").split("|") if row.strip()], float)
    table = np.vstack([table[0], table, table[-1]])
    table[0, 0], table[-1, 0] = HUB, TIP
    blade = Blade(
        span=table[:, 0] - HUB,
        chord=table[:, 1],
        twist=np.radians(table[:, 2]),
        polar_index=table[:, 3].astype(int),
        polars=polars or aerodyn().blade.polars,
    )
    return Rotor(blade=blade, hub_radius=HUB, precone=np.radians(cone), tilt=np.radians(tilt))


def polar_of(lift: Callable, drag: Callable, within: float = 60.0, step: float = 0.05) -> Polar:
    """Polar of two functions of the angle of attack [rad] up to some degrees, then to the closing values."""
    inner = np.radians(np.arange(-within, within + 0.5 * step, step))
    alpha = np.r_[-np.pi, inner, np.pi]
    ends = np.zeros(1), np.full(1, float(drag(inner[-1])))
    return Polar(
        alpha=alpha,
        lift=np.r_[ends[0], lift(inner), ends[0]],
        drag=np.r_[ends[1], drag(inner) * np.ones_like(inner), ends[1]],
    )


def plain_blade(radius: np.ndarray, hub: float, chord: np.ndarray, twist: np.ndarray, polar: Polar) -> Blade:
    """Blade with one polar and stations at distances from the axis."""
    n = len(radius)
    return Blade(
        span=np.asarray(radius) - hub, chord=chord, twist=twist, polars=[polar], polar_index=np.zeros(n, int)
    )
