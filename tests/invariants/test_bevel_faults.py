# SPDX-License-Identifier: Apache-2.0
"""Teeth of bevel gears that are broken or out of their place: surfaces, closed forms, energy, whole turns."""

import math

import numpy as np
import pytest

from pitchpoint.contact.stiffness.description import PairShape
from pitchpoint.elements.mesh.bevel.record import N_OUT
from pitchpoint.model.components.tooth_faults import BrokenBevelTooth, PitchError
from pitchpoint.system.rules.bevel_mesh import Placement, pitch_rays
from pitchpoint.system.rules.mesh_laws import MeshLaws
from tests.invariants.test_bevel_mesh import BARE, PAIR, PAIRS, both_flanks
from tests.support.mesh_alone import moved
from tests.support.one_bevel import OneBevel, make_bevels
from tests.support.true_flanks import true_depths

EVEN = PairShape(c_prime=14e9, S_R=1.0)
some_pairs = pytest.mark.parametrize("pair", ["straight", "right", "spiral 110 deg"])


def mesh(pair, shape=EVEN, faults=({}, {}), sides=(1.0, 1.0), b=15e-3, **laws):
    """A mesh whose gears have faults, by labels."""
    return OneBevel(
        make_bevels(**{"b": b, **PAIRS[pair]}), MeshLaws(stiffness=shape, **laws), sides=sides, faults=faults
    )


def faulty(gear, fault):
    """One fault on gear 1 or 2 (0 or 1)."""
    return ({"it": fault}, {}) if gear == 0 else ({}, {"it": fault})


@some_pairs
@both_flanks
@pytest.mark.parametrize("gear", [0, 1])
@pytest.mark.parametrize("sides", [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0)])
def test_a_displaced_tooth_stands_where_its_surface_does(pair, flank, gear, sides):
    """Forces of a narrow face over its stiffness are the penetrations of surfaces, one of them turned."""
    amount, tooth = 6e-6, 1
    m = mesh(pair, EVEN, faulty(gear, PitchError(tooth=tooth, amount=amount)), sides, b=1e-5)
    shape = (m.pair.gear1, m.pair.gear2)[gear]
    angle = amount / (shape.R_m * math.sin(shape.delta))
    met = 0
    for step in range(4):
        m.roll(0.6 if step else -1.0)
        m.press(20e-6, flank)
        told = np.sort(flank * m.out[N_OUT:]) / (14e9 * 1e-5)
        seen = []
        for k in range(-6, 7):
            mate = -k if flank > 0 else 1 - k
            hit = (k if gear == 0 else mate) % shape.z == tooth
            depth, rolls = true_depths(
                m, flank, k, np.array([m.row["R_m"]]), tuple(angle * (hit and gear == g) for g in range(2))
            )
            if rolls[0, 0] < m.pair.gear1.sigma_a and rolls[1, 0] < m.pair.gear2.sigma_a:
                seen.append(depth[0])
                met += hit
        # pairs enter and leave by the places of sound teeth
        assert np.sort(seen) == pytest.approx(told[told > 0.0], abs=1e-9)
    assert met >= 1


@pytest.mark.nojit
@both_flanks
@pytest.mark.parametrize("at", ["outer", "inner"])
def test_a_straight_tooth_broken_at_an_end_carries_on_the_rest(at, flank):
    """A line load k w R on what is left: (R_2^2 - R_1^2)/(R_e^2 - R_i^2) of the force of the whole tooth."""
    healthy = mesh("straight")
    broken = mesh("straight", faults=faulty(0, BrokenBevelTooth(tooth=0, at=at, width=4e-3)))
    forces = []
    for m in (healthy, broken):
        m.press(2e-5, flank)
        forces.append(flank * m.out[N_OUT:])
    R_i, R_e = healthy.pair.R_i, healthy.pair.R_e
    low, high = (R_i, R_e - 4e-3) if at == "outer" else (R_i + 4e-3, R_e)
    share = forces[1] / np.maximum(forces[0], 1e-9)
    expected = (high**2 - low**2) / (R_e**2 - R_i**2)
    assert sorted(share[forces[0] > 0.0]) == pytest.approx([expected, 1.0], rel=1e-9)


@some_pairs
@both_flanks
@pytest.mark.parametrize("gear", [0, 1])
def test_both_parts_of_a_tooth_are_the_whole_one(pair, flank, gear):
    """Forces of a tooth without its outer 6 mm and of one without the other 9 mm add up; a whole one that is
    missing takes all its force along; none of severity 0 takes anything, to the last bit."""
    found = {}
    for name, at, width, severity in (
        ("sound", "outer", 6e-3, 0.0),
        ("inner part", "outer", 6e-3, 1.0),
        ("outer part", "inner", 18e-3, 0.5),
        ("gone", "inner", None, 1.0),
    ):
        fault = BrokenBevelTooth(tooth=0, at=at, width=width, severity=severity)
        m = mesh(pair, BARE, faulty(gear, fault), d_in=2e4, d_out=1e4, mu=0.05)
        m.frames["tw"][0, 3:] = flank * 5.0 * m.axes[0][:, 2]
        m.press(2e-5, flank)
        found[name] = np.concatenate((m.evaluate().ravel(), m.out[N_OUT:]))
    healthy = mesh(pair, BARE, d_in=2e4, d_out=1e4, mu=0.05)
    healthy.frames["tw"][0, 3:] = flank * 5.0 * healthy.axes[0][:, 2]
    healthy.press(2e-5, flank)
    assert np.array_equal(found["sound"], np.concatenate((healthy.evaluate().ravel(), healthy.out[N_OUT:])))
    parts, whole = found["inner part"] + found["outer part"], found["sound"] + found["gone"]
    assert np.abs(found["sound"] - found["gone"]).max() > 0.1 * np.abs(whole).max()
    assert np.abs(parts - whole).max() < 2e-6 * np.abs(whole).max()


@both_flanks
@pytest.mark.parametrize("gear", [0, 1])
def test_the_faulty_tooth_comes_round_with_its_gear(gear, flank):
    """A straight tooth that is gone is missed while it would be in mesh, eps_alpha base pitches of every
    turn of its gear, whole turns counted or not."""
    fault = BrokenBevelTooth(tooth=3)
    sick, sound = mesh("straight", EVEN, faulty(gear, fault)), mesh("straight", EVEN)
    z = (20, 40)[gear]
    missed = []
    for m in (sick, sound):
        m.press(1e-5, flank)
        forces = []
        for _ in range(8 * z):
            m.roll(0.25)
            m.evaluate()
            forces.append(abs(m.get("mesh_force")))
        missed.append(forces)
    less = np.array(missed[1]) - np.array(missed[0])
    assert np.allclose(less[: 4 * z], less[4 * z :], atol=1e-6 * max(missed[1]))
    away = less > 1e-6 * max(missed[1])
    assert abs(away.sum() / 8.0 - sick.pair.eps_alpha) <= 0.25
    first = sick.evaluate()
    sick.frames["turns"] += [2 * 40, -2 * 20]
    assert np.array_equal(sick.evaluate(), first)
    # the same place with whole turns in the remainders instead
    sick.frames["turns"] = 0
    turns = [1, 0] if gear == 0 else [0, 1]
    for k, n in enumerate(turns):
        sick.frames["phi"][k] -= 2.0 * math.pi * n * sick.row["side"][k]
        sick.frames["turns"][k] += n
    assert np.allclose(sick.evaluate(), first, rtol=1e-8, atol=1e-6 * abs(first).max())


@both_flanks
@pytest.mark.parametrize("sides", [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0)])
def test_teeth_count_from_tooth_0_wherever_it_stands(sides, flank):
    """Counter-clockwise about the axis into the gear. Gears assembled some teeth on and turned back by as
    many meet the same faults."""
    faults = (
        {"a": PitchError(tooth=2, amount=8e-6), "b": BrokenBevelTooth(tooth=1, width=5e-3)},
        {"c": PitchError(tooth=3, amount=-5e-6)},
    )
    m = mesh("right", PAIR, faults, sides)
    rays = pitch_rays(Placement(axes1=m.axes[0], axes2=m.axes[1], apexes=m.apexes, sides=m.sides))
    z = (m.pair.gear1.z, m.pair.gear2.z)
    angles = (
        rays[0] + sides[0] * 2.0 * math.pi * 4 / z[0],
        rays[1] + sides[1] * math.pi / z[1] * (2 * -4 - 1),
    )
    other = OneBevel(m.pair, m.laws, sides=sides, faults=faults, angles=angles)
    other.roll(-4.0)
    for _ in range(12):
        for one in (m, other):
            one.roll(0.4)
            one.press(1e-5, flank)
        assert np.allclose(m.evaluate(), other.evaluate(), rtol=1e-7, atol=1e-6 * abs(m.evaluate()).max())


@some_pairs
@both_flanks
@pytest.mark.parametrize("shape", [PAIR, BARE], ids=["ramp", "bare"])
def test_power_balance(pair, shape, flank):
    """Work of the gears + parametric power = stored energy + losses, with every tooth out of its place or
    broken, for displaced gears in motion."""
    rng = np.random.default_rng(8)
    faults = tuple(
        {f"p{k}": PitchError(tooth=k, amount=4e-6 * rng.normal()) for k in range(20)}
        | {f"b{k}": BrokenBevelTooth(tooth=k, at=at, width=w) for k, at, w in ends}
        for ends in (((0, "outer", 4e-3), (1, "inner", 3e-3)), ((19, "inner", 5e-3), (1, "outer", 2e-3)))
    )
    m = mesh(pair, shape, faults, mu=0.05, d_in=3e4, d_out=2e4)
    twist = rng.normal(size=(2, 6)) * [0.03, 0.03, 0.05, 1.0, 1.0, 1.0]
    for body in range(2):
        m.frames = moved(m.frames, body, 1e-5 * rng.normal(size=6))
    m.roll(0.2)
    m.press(4e-5, flank)
    for k, speed in enumerate((40.0, -40.0 * m.row["r_b1"] / m.row["r_b2"])):
        twist[k, 3:] += speed * m.frames["R"][k][:, 2]
    given, cycle, stored, lost = m.powers(twist)
    largest = max(abs(p) for p in (given, cycle, stored, lost))
    assert abs(given + cycle - stored - lost) < 3e-6 * largest
    assert lost > 0.0
