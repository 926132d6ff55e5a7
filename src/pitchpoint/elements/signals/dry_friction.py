# SPDX-License-Identifier: Apache-2.0
"""Dry friction as a signal: the clutch law for brakes whose capacity another signal gives.

The rate of the bristle deflection y is that of `contact.bristle` without Stribeck effect, with the slip speed
w and the plastic fraction alpha(|y|):

    y' = (w - alpha sign(y) max(w y, 0)) / wind_up,   friction = -(y + damping_time y')
"""

from __future__ import annotations

from pitchpoint.core.formula.formula import Formula
from pitchpoint.elements.signals.net import SignalNet

DEFLECTION = ".deflection"
"""End of the name of the state y."""


def add_dry_friction(
    net: SignalNet, name: str, x: str, wind_up: float, holding: float, damping_time: float
) -> None:
    """Add the friction of a slip speed per unit of capacity, opposite to the slip.

    Parameters
    ----------
    net
        Receives the signals.
    name, x
        Name of the signal and of the slip speed.
    wind_up
        Angle of twist or displacement at the capacity [rad, m].
    holding
        Fraction of the capacity below which the brake sticks without creep.
    damping_time
        Ratio of damping to stiffness before slip [s].
    """
    share = f"min(max((abs(y) - {holding!r})/{1.0 - holding!r}, 0), 1)"
    rate = f"(w - 0.5*(1 - cos(pi*{share}))*max(w*y, 0)*sign(y))/{wind_up!r}"
    deflection = f"{name}{DEFLECTION}"
    net.formula(f"{name}.yielding", Formula.parse(rate, ("y", "w")), (deflection, x))
    net.integrator(deflection, f"{name}.yielding")
    net.linear(name, {deflection: -1.0, f"{name}.yielding": -damping_time})
