# SPDX-License-Identifier: Apache-2.0
"""Torques of one cylinder on the camshaft over its angle, as tables: `python torques.py`.

The cams of injection pump and valves have polynomial lifts h = H (1 - u^2)^3 with u = -1 to 1; the torque is
-F dh/dphi with the force F on the follower. The angle is zero at the firing top dead centre of the cylinder.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

# middle [deg], half of the angle [deg], lift [m], preload [N], rate [N/m] of the springs
PUMP = (18.0, 50.0, 25e-3, 2000.0, 40e3)
EXHAUST = (125.0, 65.0, 24e-3, 3000.0, 60e3)  # both valves of a cylinder
INLET = (235.0, 65.0, 24e-3, 3000.0, 60e3)
PLUNGER, PRESSURE = 28e-3, 1000e5  # diameter [m], [Pa]
DELIVERY, RISE = (-10.0, 3.0), 2.0  # of the pump [deg], and the angle in which the pressure rises and falls


def lift(cam, angle):
    """Lift [m] and its slope [m/rad]."""
    middle, half, height = cam[:3]
    u = (np.mod(angle - middle + 180.0, 360.0) - 180.0) / half
    s = np.maximum(1.0 - u**2, 0.0)
    return height * s**3, -6.0 * height / np.radians(half) * u * s**2


def springs(cam, angle):
    """Torque of the springs [N m]; its mean over a revolution is zero."""
    h, slope = lift(cam, angle)
    return -np.where(h > 0.0, cam[3] + cam[4] * h, 0.0) * slope


def injection(angle):
    """Torque of the pressure in the pump [N m]."""
    at = np.mod(angle + 180.0, 360.0) - 180.0
    low, high = DELIVERY
    share = np.clip((at - low) / RISE, 0.0, 1.0) * np.clip((high - at) / RISE, 0.0, 1.0)
    return -PRESSURE * np.pi / 4.0 * PLUNGER**2 * share * lift(PUMP, angle)[1]


ANGLES = np.arange(0.0, 360.5, 0.5)
ONE = injection(ANGLES) + springs(PUMP, ANGLES)
VALVES = springs(EXHAUST, ANGLES) + springs(INLET, ANGLES)
SIX = sum(np.interp((ANGLES - 60.0 * k) % 360.0, ANGLES, ONE + VALVES) for k in range(6))
TABLES = {
    "pump.csv": (ANGLES, ONE),
    "valves.csv": (ANGLES, VALVES),
    "cylinders.csv": (ANGLES[:121], SIX[:121]),  # all six
}

if __name__ == "__main__":
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    for name, (angle, torque) in TABLES.items():
        rows = "\n".join(f"{a:g}, {t + 0.0:.2f}" for a, t in zip(angle, torque, strict=True))
        (folder / name).write_text(f"angle [deg], torque [N m]\n{rows}\n")
        print(
            f"{name:13} mean {torque[:-1].mean():7.2f} N m, from {torque.min():.0f} to {torque.max():.0f} N m"
        )
