# SPDX-License-Identifier: Apache-2.0
"""Remarks on clutches, brakes and couplings that transmit no torque, and on their keys without effect."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import Message, remark
from pitchpoint.core.units import format_quantity
from pitchpoint.model.checks.forces import TURNING
from pitchpoint.model.components.law import Constant, FormulaLaw, Law
from pitchpoint.model.frames import GROUND, bodies_of
from pitchpoint.model.keys import defaults_of

if TYPE_CHECKING:
    from pitchpoint.model.components.clutch import Clutch
    from pitchpoint.model.model import Model

OF_BRISTLES = ("wind_up", "holding", "damping_time")
"""Keys of a clutch that only its bristles read; `slip_speed` also limits their events."""
FASTEST = 300.0
"""Slip speed up to which the capacity is evaluated [rad/s]."""


def idle_clutches(model: Model) -> Iterator[Message]:
    """Clutches that are never closed, keys that their law does not read, elements on fixed bodies."""
    for group in TURNING:
        for name, part in getattr(model, group).items():
            ends = [b for b in bodies_of(part.bodies) if b != GROUND]
            if all(b in model.bodies and model.bodies[b].moves == "fixed" for b in ends):
                what = " and ".join(ends) + (" are" if ends[1:] else " is")
                yield remark(f"{group}.{name}", f"has no effect: {what} fixed", "name a body that rotates")
    for name, clutch in model.clutches.items():
        if clutch.stage is None:
            yield from _keys(clutch, f"clutches.{name}")
            yield from _capacity(model, clutch.capacity, f"clutches.{name}.capacity")


def _keys(clutch: Clutch, at: str) -> Iterator[Message]:
    """Keys of bristles without bristles, and a Stribeck curve with only one of its two values."""
    usual = defaults_of(type(clutch))
    for key in OF_BRISTLES:
        if clutch.law != "bristles" and getattr(clutch, key) != usual[key]:
            yield remark(f"{at}.{key}", f"has no effect with law: {clutch.law}", "write law: bristles")
    if clutch.static_ratio > 1.0 and clutch.stribeck_speed == 0.0:
        yield remark(
            f"{at}.static_ratio",
            "has no effect with stribeck_speed: 0: the friction torque is that of sliding at any speed",
            "give the slip speed over which friction decreases, such as stribeck_speed: 10 rad/s",
        )
    elif clutch.static_ratio == 1.0 and clutch.stribeck_speed > 0.0:
        yield remark(
            f"{at}.stribeck_speed",
            "has no effect with static_ratio: 1: static and sliding friction are equal",
            "give static_ratio, such as 1.2, or remove it",
        )


def _capacity(model: Model, capacity: Law, at: str) -> Iterator[Message]:
    """A capacity that is always zero, or that is negative for a time."""
    if isinstance(capacity, Constant) and capacity.value == 0.0:
        yield remark(at, "is zero: the clutch is always open and transmits no torque", "give its torque")
    if not isinstance(capacity, FormulaLaw):
        return
    from pitchpoint.core.formula.formula import Formula

    formula = Formula.parse(capacity.text, capacity.variables)
    ends = max((s.duration or 0.0 for s in model.scenarios.values()), default=0.0) or 1.0
    ranges = {
        "t": np.linspace(0.0, ends, 201),
        "angle": np.linspace(0.0, math.tau, 73),
        "speed": np.linspace(-FASTEST, FASTEST, 61),
    }
    axes = [ranges[v] if formula.uses(v) else np.zeros(1) for v in capacity.variables]
    values = np.asarray(formula(*np.meshgrid(*axes, indexing="ij")), dtype=float)
    least, most = float(np.nanmin(values)), float(np.nanmax(np.abs(values)))
    if least < -1e-9 * most:
        yield remark(
            at,
            f"has negative values, down to {format_quantity(least, 'torque', 4)}, which count as 0: the "
            "clutch is open there",
            'if this is not intended, correct the formula; "max(0, ...)" states it',
        )


def couplings_without_torque(model: Model) -> Iterator[Message]:
    """Couplings that transmit forces, but no torque, between two bodies that rotate."""
    seats = model.mechanism.seats
    for name, coupling in model.couplings.items():
        damped = coupling.damping is not None and coupling.damping.matrix6()[5][5] > 0.0
        acts = any(v != 0.0 for row in coupling.stiffness.matrix6() for v in row)
        turning = all("spin" in seats[b].coordinates for b in coupling.bodies)
        if coupling.stage is None and acts and turning and not coupling.carries_torque and not damped:
            yield remark(
                f"couplings.{name}.stiffness",
                f"has no torsion: the coupling transmits no torque between {' and '.join(coupling.bodies)}",
                "if this is not intended, give torsion: 1e5 N m/rad, for instance",
            )
