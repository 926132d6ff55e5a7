# SPDX-License-Identifier: Apache-2.0
"""Shares in the names of modes: what they mean, and that they are shares also of joints on moving bodies."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import eigh

from pitchpoint.cli.main import run_command
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model

CART, BLOCK, NEAR, BETWEEN, FAR = 1.0, 4.0, 1e2, 1e4, 3e4
SLED = f"""\
bodies:
  post: {{motion: fixed, position: [0, 0, -1]}}
  cart: {{mass: {CART} kg}}
  block: {{mass: {BLOCK} kg}}
joints:
  rail: {{type: prismatic, bodies: [ground, cart], position: [0, 0, 0]}}
  slide: {{type: prismatic, bodies: [cart, block], position: [0, 0, 1]}}
springs:
  near: {{ends: [post, cart], stiffness: {NEAR} N/m}}
  between: {{ends: [cart, block], stiffness: {BETWEEN} N/m}}
  far: {{ends: [post, block], stiffness: {FAR} N/m}}
"""


def test_shares_of_a_block_that_slides_on_a_cart() -> None:
    """The joint of the block moves it against its cart: shares of the energy itself are beyond 0 and 1.

    Mass and stiffness in the coordinates of the joints, z of the cart and way of the block on it, are
    [[m1 + m2, m2], [m2, m2]] and diag(k1, k2) + k3 everywhere; shares are those of M_kk phi_k^2.
    """
    M = np.array([[CART + BLOCK, BLOCK], [BLOCK, BLOCK]])
    squares, columns = eigh(np.diag([NEAR, BETWEEN]) + FAR, M)
    modes = find_modes(compile_model(loads_model(SLED)))
    assert modes.frequency == pytest.approx(np.sqrt(squares) / (2.0 * np.pi), rel=1e-9)
    energy = columns.T * (columns.T @ M)
    assert modes.kinetic == pytest.approx(energy, rel=1e-6)
    assert energy.sum(axis=1) == pytest.approx(1.0)
    assert energy.max() > 1.4
    assert energy.min() < 0.0
    for k, name in enumerate(modes.names):
        alone = columns[:, k] ** 2 * np.diag(M)
        shares = dict(zip(("cart", "block"), 100.0 * alone / alone.sum(), strict=True))
        found = re.findall(r"(\w+) translation z (\d+) %", name)
        assert found
        for body, share in found:
            assert float(share) == pytest.approx(shares[body], abs=0.5)  # whole per cent


def test_strain_energy_that_is_negative() -> None:
    """An upright pendulum on a spring: gravity takes energy away, and the name of the spring has a share."""
    text = """\
gravity: [0, -10 m/s^2, 0]
bodies:
  disc: {motion: torsion, inertia: 0.1 kg m^2, position: [0, 0, 0]}
  rod:
    {mass: 1 kg, center_of_mass: [0, 0.5, 0], inertia_tensor: [0.1, 0.1, 0.1, 0, 0, 0], position: [0, 0, 0]}
joints: {pin: {type: revolute, bodies: [ground, rod], position: [0, 0, 0]}}
torsion_springs:
  hold: {bodies: [rod, disc], stiffness: 20 N m/rad}
  foot: {bodies: [disc], stiffness: 100 N m/rad}
"""
    modes = find_modes(compile_model(loads_model(text)))
    assert modes.potential.min() < 0.0
    for share in re.findall(r"(\d+) %", " ".join(modes.names)):
        assert int(share) <= 100


def test_people_see_no_share_above_the_whole(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "sled.yaml"
    file.write_text(SLED, encoding="utf-8")
    assert run_command(["modes", str(file)]) == 0
    shares = [int(share) for share in re.findall(r"translation z\s+(\d+)\s+%", capsys.readouterr().out)]
    assert shares
    assert max(shares) <= 100
