# SPDX-License-Identifier: Apache-2.0
"""The example `geared-rotor`: whirl of the rotor against a rotor model by hand, and what the mesh adds.

By hand: beams in complex coordinates x + i y (Nelson and McVaugh 1976 with the shear of Cowper's factor),
bearings, disc and pinion as numbers. Nothing of it comes from the package but the inertia of the pinion.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import block_diag, eigh

from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.inertia import gear_inertia
from pitchpoint.solvers.campbell import follow_modes
from pitchpoint.system.compile import compile_model
from tests.support.synchronous import synchronous_speeds

FILE = Path(__file__).parents[2] / "examples" / "geared-rotor" / "model.yaml"
RPM = math.pi / 30.0
YOUNG, POISSON, DENSITY = 206e9, 0.3, 7850.0
SHEAR = YOUNG / (2.0 * (1.0 + POISSON))


def bending(length, diameter, bearings, riders, piece):
    """Mass, gyroscopic (per speed) and stiffness matrices of a shaft, two coordinates a node.

    `bearings` are (place, stiffness), `riders` are (place, (mass, polar, transverse)).
    """
    n = round(length / piece)
    size = 2 * (n + 1)
    M, G, K = (np.zeros((size, size)) for _ in range(3))
    area, second = 0.25 * math.pi * diameter**2, math.pi / 64.0 * diameter**4
    kappa = 6.0 * (1.0 + POISSON) / (7.0 + 6.0 * POISSON)
    shear = 12.0 * YOUNG * second / (kappa * area * SHEAR * piece**2)
    l = piece  # noqa: E741
    k = np.array(
        [
            [12.0, 6.0 * l, -12.0, 6.0 * l],
            [6.0 * l, (4.0 + shear) * l * l, -6.0 * l, (2.0 - shear) * l * l],
            [-12.0, -6.0 * l, 12.0, -6.0 * l],
            [6.0 * l, (2.0 - shear) * l * l, -6.0 * l, (4.0 + shear) * l * l],
        ]
    )
    moved = np.array(
        [
            [156.0, 22.0 * l, 54.0, -13.0 * l],
            [22.0 * l, 4.0 * l * l, 13.0 * l, -3.0 * l * l],
            [54.0, 13.0 * l, 156.0, -22.0 * l],
            [-13.0 * l, -3.0 * l * l, -22.0 * l, 4.0 * l * l],
        ]
    )
    turned = np.array(
        [
            [36.0, 3.0 * l, -36.0, 3.0 * l],
            [3.0 * l, 4.0 * l * l, -3.0 * l, -l * l],
            [-36.0, -3.0 * l, 36.0, -3.0 * l],
            [3.0 * l, -l * l, -3.0 * l, 4.0 * l * l],
        ]
    )
    for e in range(n):
        at = np.ix_(range(2 * e, 2 * e + 4), range(2 * e, 2 * e + 4))
        K[at] += YOUNG * second / (l**3 * (1.0 + shear)) * k
        rotary = DENSITY * second / (30.0 * l) * turned
        M[at] += DENSITY * area * l / 420.0 * moved + rotary
        G[at] += 2.0 * rotary
    for place, radial in bearings:
        K[2 * round(place / piece), 2 * round(place / piece)] += radial
    for place, (mass, polar, transverse) in riders:
        at = 2 * round(place / piece)
        M[at, at] += mass
        M[at + 1, at + 1] += transverse
        G[at + 1, at + 1] += polar
    return M, G, K


def rotor_by_hand(pinion, piece=0.025):
    """The rotor with its disc and its pinion."""
    riders = ((0.6, (4.93, 0.02465, 0.01249)), (0.25, pinion))
    return bending(0.6, 0.03, ((0.05, 1e8), (0.45, 1e8)), riders, piece)


def outside(gear, d):
    """Mass, polar and transverse inertia of a gear 25 mm wide without the shaft in it."""
    mass, polar, transverse = gear_inertia(gear)
    inside = DENSITY * math.pi / 4.0 * d**2 * 0.025
    central = inside * (d**2 / 16.0 + 0.025**2 / 12.0)
    return mass - inside, polar - inside * d**2 / 8.0, transverse - central


def geared_by_hand(pinion, wheel, piece=0.025, rigid=False):
    """Natural frequencies [Hz] at rest of what moves along the line of action and turns.

    `rigid`: the shafts are rigid in bending, and so are the bearings.
    """
    rotor = rotor_by_hand(pinion, piece)
    drive = bending(0.3, 0.05, ((0.02, 2e8), (0.28, 2e8)), ((0.15, wheel),), 0.01)
    n = round(0.6 / piece)
    twist_M, twist_K = np.zeros((n + 1, n + 1)), np.zeros((n + 1, n + 1))
    polar = math.pi / 32.0 * 0.03**4
    for e in range(n):
        twist_K[e : e + 2, e : e + 2] += SHEAR * polar / piece * np.array([[1.0, -1.0], [-1.0, 1.0]])
        twist_M[e : e + 2, e : e + 2] += DENSITY * polar * piece / 6.0 * np.array([[2.0, 1.0], [1.0, 2.0]])
    twist_M[-1, -1] += 0.02465
    twist_M[10, 10] += pinion[1]
    whole_drive = wheel[1] + DENSITY * math.pi / 32.0 * 0.05**4 * 0.3  # stiff: its ends are free
    blocks_M, blocks_K = (
        (rotor[0], twist_M, drive[0], [[whole_drive]]),
        (rotor[2], twist_K, drive[2], [[0.0]]),
    )
    M, K = block_diag(*blocks_M), block_diag(*blocks_K)
    g = np.zeros(len(M))
    g[20], g[len(rotor[0]) + 10] = 1.0, 0.5 * 69e-3 * math.cos(math.radians(20.0))
    g[len(rotor[0]) + n + 1 + 30], g[-1] = -1.0, 0.5 * 207e-3 * math.cos(math.radians(20.0))
    K += 3e8 * np.outer(g, g)
    if rigid:
        turning = [*range(len(rotor[0]), len(rotor[0]) + n + 1), -1]
        M, K = M[np.ix_(turning, turning)], K[np.ix_(turning, turning)]
    return np.sqrt(np.maximum(eigh(K, M, eigvals_only=True), 0.0)) / (2.0 * math.pi)


def whirl(matrices, speed, count):
    """Lowest whirl frequencies [Hz]: forward positive, backward negative."""
    M, G, K = matrices
    n = len(M)
    A = np.block(
        [[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, K), 1j * speed * np.linalg.solve(M, G)]]
    )
    roots = np.linalg.eigvals(A).imag / (2.0 * math.pi)
    return roots[np.argsort(np.abs(roots))][:count]


@pytest.fixture(scope="module")
def model():
    return load_model(FILE)


def test_whirl_of_the_rotor_alone(model):
    alone = model.replace_all({"meshes.stage": None, "loads.motor": None, "loads.fan": None})
    seen = follow_modes(compile_model(alone, "fast"), np.array([0.0, 4500.0, 9000.0]) * RPM, "rotor", "fast")
    by_hand = rotor_by_hand(outside(model.gears["pinion"], 0.03))
    for k, rpm in enumerate((0.0, 4500.0, 9000.0)):
        expected = np.abs(whirl(by_hand, rpm * RPM, 6))
        for frequency in expected:  # seven beams for the rotor here, 24 by hand
            assert np.min(np.abs(seen.frequency[k] - frequency)) < 2e-3 * frequency


def test_geared(model):
    speeds = np.linspace(0.0, 6600.0, 7) * RPM
    seen = follow_modes(compile_model(model, "fast"), speeds, "rotor", "fast")
    by_hand = geared_by_hand(outside(model.gears["pinion"], 0.03), outside(model.gears["wheel"], 0.05))
    for frequency in by_hand[1:6]:  # the drive shaft is stiff in torsion by hand
        assert np.min(np.abs(seen.frequency[0] - frequency)) < 2e-3 * frequency
    assert by_hand[2] == pytest.approx(196.8, abs=0.05)
    rigid = geared_by_hand(
        outside(model.gears["pinion"], 0.03), outside(model.gears["wheel"], 0.05), rigid=True
    )
    assert rigid[1] == pytest.approx(333.1, abs=0.05)
    assert seen.orders == {"stage": 23.0}
    # below 150 Hz there are the two whirls, split at rest already: the mesh holds the rotor in one direction
    low = np.sort(seen.frequency, axis=1)[:, 1:3]
    assert low[0] == pytest.approx([85.37, 88.74], abs=0.02)
    once = synchronous_speeds(speeds[1:], low[1:])
    assert [speed / RPM for speed in once] == pytest.approx([4717.0, 5854.0], abs=2.0)
