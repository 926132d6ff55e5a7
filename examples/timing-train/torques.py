# SPDX-License-Identifier: Apache-2.0
"""Torques of the engine over the crank angle or the cam angle, as text files: `python torques.py`.

Crank: polytropic compression and expansion, heat release by Wiebe's function, slider-crank kinematics. Cams: work
against the valve springs over a polynomial lift. `python torques.py` also prints the coefficients of the inertia torques
in train.yaml.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

BORE, STROKE, ROD = 81e-3, 95.5e-3, 144e-3  # [m]
COMPRESSION, AMBIENT, PISTON = 16.5, 1e5, 0.9  # [-], [Pa], oscillating mass [kg]
CYLINDERS = {
    0.0: 1.00,
    180.0: 0.97,
    360.0: 1.02,
    540.0: 1.01,
}  # firing TDC [deg]: heat of the cylinder, relative
LIFT, HALF, LOBES = 8.5e-3, np.radians(60.0), 4  # cam: lift [m], half of its angle [rad], lobes
PRELOAD, RATE, MASS = 400.0, 8e4, 0.2  # both valves of a cylinder [N], [N/m], [kg]
INLET, EXHAUST = 470.0, 250.0  # crank angles of largest lift after the firing TDC [deg]


def slider(theta):
    """Distance of the piston from its top dead centre [m] and its derivative [m/rad]."""
    r = STROKE / 2.0
    low = np.sqrt(ROD**2 - (r * np.sin(theta)) ** 2)
    return r * (1.0 - np.cos(theta)) + ROD - low, r * np.sin(theta) * (1.0 + r * np.cos(theta) / low)


def pressure(theta, charge, heat):
    """Gauge pressure in a cylinder [Pa] over 720 deg, firing TDC in the middle; charge [Pa], heat [J]."""
    area = np.pi / 4.0 * BORE**2
    clearance = area * STROKE / (COMPRESSION - 1.0)
    volume = clearance + area * slider(theta)[0]
    p = np.full(theta.size, charge)
    begin, end = np.searchsorted(theta, np.radians([540.0, 850.0]))  # inlet closes, exhaust opens
    burned = 1.0 - np.exp(-6.9 * np.clip((theta - np.radians(718.0)) / np.radians(50.0), 0.0, None) ** 2)
    for k in range(begin + 1, end):
        mean = 0.5 * (volume[k] + volume[k - 1])
        gain = 0.33 * heat * (burned[k] - burned[k - 1]) / mean
        p[k] = p[k - 1] * (volume[k - 1] / volume[k]) ** 1.33 + gain
    fall = (theta[end:] - theta[end]) / np.radians(40.0)  # blowdown
    p[end:] = AMBIENT + (p[end - 1] - AMBIENT) * np.exp(-3.0 * fall)
    return p - AMBIENT


def gas_torque(charge, heat):
    """Crank torque of four cylinders [N m] over 0 to 720 deg in steps of 1 deg."""
    fine = np.radians(np.arange(360.0, 1081.0, 0.1))
    area = np.pi / 4.0 * BORE**2
    angle, total = np.arange(0.0, 721.0), np.zeros(721)
    for top, share in CYLINDERS.items():
        one = pressure(fine, charge, share * heat) * area * slider(fine)[1]
        after = (angle - top + 360.0) % 720.0 + 360.0  # the cylinder fires at 720
        total += np.interp(after, np.degrees(fine), one)
    total[-1] = total[0]
    return angle, total


def lift(x):
    """Lift (1 - x^2)^3 within its half angle, and its derivatives over the cam angle [m, m/rad, m/rad^2]."""
    s = np.maximum(1.0 - (x / HALF) ** 2, 0.0)
    u = x / HALF
    return LIFT * s**3, -6.0 * LIFT / HALF * u * s**2, LIFT / HALF**2 * (24.0 * u**2 * s - 6.0 * s**2)


def cam_torque(top, speed=0.0):
    """Torque on a camshaft [N m] over 0 to 90 deg of its angle; `top` is the crank angle of largest lift [deg].

    The camshaft turns clockwise at half the speed of the crank: its angle is -theta/2.
    """
    angle = np.linspace(0.0, 90.0, 181)
    total = np.zeros(angle.size)
    for lobe in range(-2, 3):
        x = np.radians(angle + (top / 2.0) % 90.0 + 90.0 * (lobe - 1))
        h, dh, ddh = lift(x)
        total -= np.where(h > 0.0, (PRELOAD + RATE * h) * dh + MASS * speed**2 * dh * ddh, 0.0)
    return angle, total


def write(name, angle, torque):
    """Write a table for `torque: {table: NAME, over: angle}`."""
    rows = "\n".join(f"{a:g}, {t:.3f}" for a, t in zip(angle, torque, strict=True))
    Path(name).write_text(f"angle [deg], torque [N m]\n{rows}\n")


if __name__ == "__main__":
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    for name, (angle, torque) in {
        "gas_idle.csv": gas_torque(1.0e5, 230.0),
        "gas_rated.csv": gas_torque(2.2e5, 1900.0),
        "inlet.csv": cam_torque(INLET),
        "exhaust.csv": cam_torque(EXHAUST),
    }.items():
        write(folder / name, angle, torque)
        print(
            f"{name:14} mean {np.mean(torque[:-1]):8.3f} N m, from {torque.min():8.2f} to {torque.max():8.2f} N m"
        )
