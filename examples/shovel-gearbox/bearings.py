# SPDX-License-Identifier: Apache-2.0
"""Stiffness of the roller bearings of the shovel gearbox from their rollers and their mean load.

Run it with `python bearings.py`. The most loaded roller carries Q = 4.08 F/(Z cos alpha) (R. Stribeck), both
its contacts approach by (Q/K)^0.9 (A. Palmgren), and the radial stiffness is the slope F/(0.9 delta_r). The
axial stiffness of a single row of tapered rollers under the angle alpha is 2 tan^2 alpha of the radial one
(sums of cos^2 alpha/2 and sin^2 alpha over the rollers).
"""

from __future__ import annotations

import math

from pitchpoint.contact.rolling import LINE, in_series, roller_stiffness
from pitchpoint.geometry.materials import material

ANGLE = math.radians(15.0)
"""Contact angle of the tapered rollers."""

#: Mean radial load of the more loaded bearing [N], number of rollers, length of a roller [m], by shaft.
BEARINGS = {
    "input": (27e3, 16, 34e-3),
    "second": (194e3, 19, 66e-3),
    "third": (672e3, 21, 110e-3),
    "output": (638e3, 28, 120e-3),
}


def stiffness(load: float, rollers: int, length: float) -> tuple[float, float]:
    """Radial and axial stiffness of a bearing under a radial load [N/m]."""
    steel = material("steel")
    compliance = 2.0 * (1.0 - steel.poisson_ratio**2) / steel.youngs_modulus
    contact = roller_stiffness(length, compliance)
    roller = in_series(contact, contact, LINE)
    most = 4.08 * load / (rollers * math.cos(ANGLE))
    approach = (most / roller) ** (1.0 / LINE) / math.cos(ANGLE)
    radial = load * LINE / approach
    return radial, 2.0 * math.tan(ANGLE) ** 2 * radial


if __name__ == "__main__":
    print("shaft    load [kN]  radial [N/m]  axial [N/m]")
    for shaft, (load, rollers, length) in BEARINGS.items():
        radial, axial = stiffness(load, rollers, length)
        print(f"{shaft:8} {load / 1e3:9.0f} {radial:13.3g} {axial:12.3g}")
