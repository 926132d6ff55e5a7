# SPDX-License-Identifier: Apache-2.0
"""Torques of the engine over the angle of the crankshaft or a camshaft, as tables: `python torques.py`.

Crankshaft: polytropic compression and expansion, heat release by Wiebe's function, slider-crank kinematics.
Camshafts: work against the valve springs over a polynomial lift. The inertia torques of parts/train.yaml are
the orders that `orders` prints.
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
    """Lift (1 - u^2)^3 within its half angle, and its derivatives over the cam angle [m, m/rad, m/rad^2]."""
    s = np.maximum(1.0 - (x / HALF) ** 2, 0.0)
    u = x / HALF
    return LIFT * s**3, -6.0 * LIFT / HALF * u * s**2, LIFT / HALF**2 * (24.0 * u**2 * s - 6.0 * s**2)


def cam_torque(top):
    """Torque of the valve springs on a camshaft [N m] over 0 to 90 deg; `top`: crank angle of largest lift.

    The camshaft turns clockwise at half the speed of the crank: its angle is -theta/2. The torque -dW/dphi of
    the work W in the springs has zero mean.
    """
    angle = np.linspace(0.0, 90.0, 181)
    total = np.zeros(angle.size)
    for lobe in range(-2, 3):
        h, slope, _ = lift(np.radians(angle + (top / 2.0) % 90.0 + 90.0 * (lobe - 1)))
        total -= np.where(h > 0.0, (PRELOAD + RATE * h) * slope, 0.0)
    return angle, total


def orders():
    """Inertia torques over the square of the speed [kg m^2]: sine amplitudes of the crank orders 2, 4 and of
    the cam orders 4, 8, 12 about the middle of a lobe.

    T = -(dJ/dphi)/2 omega^2 with J = sum m (ds/dphi)^2 of all masses.
    """
    theta = np.linspace(0.0, 2.0 * np.pi, 7200, endpoint=False)
    pistons = sum(PISTON * slider(theta + shift)[1] ** 2 for shift in 0.5 * np.pi * np.array([0, 2, 4, 6]))
    valves = sum(
        MASS * lift(np.mod(theta + shift + np.pi, 2.0 * np.pi) - np.pi)[1] ** 2
        for shift in np.arange(4) * np.pi / 2
    )

    def sines(inertia, numbers):
        """-1/2 d/dphi of the cosine series."""
        return [k * np.mean(inertia * np.cos(k * theta)) for k in numbers]

    return sines(pistons, (2, 4)), sines(valves, (4, 8, 12))


def write(name, angle, torque):
    """Write a table for `torque: {table: NAME, over: angle}`."""
    rows = "\n".join(f"{a:g}, {t:.3f}" for a, t in zip(angle, torque, strict=True))
    Path(name).write_text(f"angle [deg], torque [N m]\n{rows}\n")


TABLES = {
    "gas_idle.csv": gas_torque(1.0e5, 230.0),
    "gas_rated.csv": gas_torque(2.2e5, 1900.0),
    "inlet.csv": cam_torque(INLET),
    "exhaust.csv": cam_torque(EXHAUST),
}

if __name__ == "__main__":
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    for name, (angle, torque) in TABLES.items():
        write(folder / name, angle, torque)
        print(
            f"{name:14} mean {torque[:-1].mean():7.2f} N m, from {torque.min():.1f} to {torque.max():.1f} N m"
        )
    for what, sizes in zip(("pistons", "valves"), orders(), strict=True):
        print(f"{what:14} {', '.join(f'{size:.4g} kg m^2' for size in sizes)}")
