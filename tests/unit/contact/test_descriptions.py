# SPDX-License-Identifier: Apache-2.0
"""Stiffness descriptions and the prescribed sources: what they hold, what they refuse."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

from pitchpoint.contact.stiffness import REGISTRY
from pitchpoint.contact.stiffness.constant import constant
from pitchpoint.contact.stiffness.description import PairShape, PhaseStiffness
from pitchpoint.contact.stiffness.energy import energy
from pitchpoint.contact.stiffness.fourier import fourier
from pitchpoint.contact.stiffness.rectangular import rectangular
from pitchpoint.contact.stiffness.table import table
from pitchpoint.contact.stiffness.user import user
from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.gear_pair import GearPair

PAIR = GearPair(CylindricalGear(z=50, m_n=3e-3), CylindricalGear(z=50, m_n=3e-3), 0.15)


def test_descriptions_are_frozen():
    shape = PairShape(c_prime=14e9, table=np.array([0.8, 1.0]))
    with pytest.raises(dataclasses.FrozenInstanceError):
        shape.c_prime = 1.0
    with pytest.raises(ValueError, match="read-only"):
        shape.table[0] = 2.0
    mine = np.array([0.8, 1.0])
    kept = PairShape(c_prime=14e9, table=mine)
    mine[0] = 0.1
    assert kept.table[0] == 0.8


def test_jumps_of_a_pair_shape():
    shape = PairShape(c_prime=14e9)
    assert shape.jumps(1.25) == (0.0, 0.25)
    assert shape.jumps(2.0) == ()  # one leaves as the next enters
    assert shape.jumps(1.25, 0.1) == ()
    assert PairShape(c_prime=14e9, T_R=0.1).jumps(1.25) == ()
    assert PairShape(c_prime=14e9, S_R=0.0).jumps(1.25) == ()
    assert PairShape(c_prime=14e9, table=[0.0, 1.0, 0.5]).jumps(1.25) == (0.25,)
    assert PairShape(c_prime=14e9, table=[0.2, 1.0, 0.5]).jumps(2.0) == (0.0,)


@pytest.mark.parametrize(
    ("call", "word"),
    [
        (lambda: PairShape(c_prime=0.0), "c_prime"),
        (lambda: PairShape(c_prime=math.nan), "c_prime"),
        (lambda: PairShape(c_prime=True), "c_prime"),
        (lambda: PairShape(c_prime=1e9, S_R=-0.1), "stiffness_ratio"),
        (lambda: PairShape(c_prime=1e9, T_R=math.nan), "tip_relief_factor"),
        (lambda: PairShape(c_prime=1e9, table=[1.0]), "table"),
        (lambda: PairShape(c_prime=1e9, table=[1.0, -0.1]), "table"),
        (lambda: PhaseStiffness(mean=1e8, table=[1, 1], rectangular=(1.1, 0.9, 0.5)), "one"),
        (lambda: constant(None, mean=-1.0), "mean"),
        (lambda: constant(None, mean=math.inf), "mean"),
        (lambda: fourier(None, mean=1e8, cosine=[1.1]), "lowest stiffness"),
        (lambda: fourier(None, mean=1e8, cosine=[1.0 + 1e-9]), "lowest stiffness"),
        (lambda: fourier(None, mean=1e8, sine=[math.nan]), "sine"),
        (lambda: fourier(None, mean=1e8, cosine=["a"]), "cosine"),
        (lambda: fourier(None, mean=1e8, cosine=[[0.1], [0.2]]), "cosine"),
        (lambda: table(None, values=[1e8]), "values"),
        (lambda: table(None, values=[1e8, 0.0]), "values"),
        (lambda: table(None, values=[-1e8, -1e8]), "mean"),
        (lambda: rectangular(None, high=3e8, low=2e8), "duty"),
        (lambda: rectangular(None, high=3e8, low=2e8, duty=1.0), "duty"),
        (lambda: rectangular(None, high=3e8, low=0.0, duty=0.5), "low"),
        (lambda: user(None, function=lambda psi: 1.0 / (psi - 0.5)), "function"),
        (lambda: user(None, function=lambda psi: math.nan), "values"),
        (lambda: energy(PAIR, points=1), "points"),
        (lambda: energy(PAIR, body="soft"), "body"),
        (lambda: energy(PAIR, moduli=(0.0, 1.0)), "youngs_modulus"),
    ],
)
def test_nonsense_is_refused(call, word):
    with pytest.raises(ModelError, match=word):
        call()


def test_rectangular_wave_takes_its_duty_from_the_pair():
    law = rectangular(PAIR, high=3e8, low=2e8)
    share = PAIR.eps_alpha % 1.0
    assert law.jumps() == (0.0, share)
    assert law.mean == pytest.approx(3e8 * share + 2e8 * (1 - share))
    assert law.mean * law.ratio([0.0, 0.999]) == pytest.approx([3e8, 2e8])


def test_equal_forms_agree():
    psi = np.linspace(0.0, 2.0, 41)
    series = fourier(None, mean=4e8, cosine=[-0.2, -0.1], sine=[0.05])
    own = user(None, function=lambda s: 4e8 * float(series.ratio(s)), points=4096)
    assert own.mean == pytest.approx(4e8, rel=1e-12)
    assert own.ratio(psi) == pytest.approx(series.ratio(psi), abs=1e-6)
    assert constant(None, mean=3e8).ratio(psi) == pytest.approx(np.ones(41))


def test_sine_and_cosine_of_unequal_length():
    law = fourier(None, mean=1e8, cosine=[0.1], sine=[0.0, 0.0, 0.2])
    assert law.cosine.tolist() == [0.1, 0.0, 0.0]
    assert law.sine.tolist() == [0.0, 0.0, 0.2]


def test_registry_is_complete_and_lazy():
    assert set(REGISTRY) == {
        "din3990",
        "energy",
        "hertz",
        "constant",
        "rectangular",
        "fourier",
        "table",
        "user",
    }
    for name, source in REGISTRY.items():
        assert source.function.__name__ == name
        assert source.returns == source.function.__annotations__["return"]
        assert source.summary
