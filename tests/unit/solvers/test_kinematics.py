# SPDX-License-Identifier: Apache-2.0
"""Driven mechanisms: positions, rates, accelerations and torques against closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.elements import drive
from pitchpoint.elements.ratio import SPIN
from pitchpoint.solvers.kinematics import moved_to
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.mechanisms import slider_crank


def driven(speed):
    """The slider-crank with its crank at constant speed."""
    plain = slider_crank()
    row = np.zeros(1, drive.RECORD)
    row["i"], row["q_i"], row["speed"] = 1, SPIN, speed
    return assemble(
        plain.bodies,
        {},
        {"closure": plain.records["closure"], "drive": row},
        names={"drive": ["crank"], "closure": plain.names["closure"]},
    )


def followed(system, times):
    """States of the mechanism at some times, each from the one before."""
    here, found = system.initial_state(), []
    for t in times:
        here = moved_to(system, here, float(t))
        found.append(here)
    return found


def test_a_slider_crank_at_constant_speed():
    """Two revolutions; slider against the closed form, torque against the power of all kinetic energy."""
    speed, r, rod = 7.0, 0.3, 1.0
    system = driven(speed)
    times = np.linspace(0.0, 2.0 * 2.0 * np.pi / speed, 401)
    states = followed(system, times)
    slider = list(system.layout.coordinates).index("slider.z")
    theta = 0.4 + speed * times
    root = np.sqrt(rod**2 - (r * np.sin(theta)) ** 2)
    x = r * np.cos(theta) + root
    z = np.array([state.q[slider] for state in states])
    np.testing.assert_allclose(z, x - x[0], atol=1e-11)
    by_angle = -r * np.sin(theta) - r**2 * np.sin(theta) * np.cos(theta) / root
    np.testing.assert_allclose([state.v[slider] for state in states], speed * by_angle, atol=1e-10)
    spin, body = system.program["spins"][0]
    assert states[-1].q[spin] + 2.0 * np.pi * states[-1].turns[body] == pytest.approx(4.0 * np.pi)
    # energy of slider and rod (slender, mass 1): T dtheta = dE
    phi = np.arcsin(r * np.sin(theta) / rod)
    phi_rate = speed * r * np.cos(theta) / root
    middle = np.array(
        [
            -r * speed * np.sin(theta) - 0.5 * rod * np.sin(phi) * phi_rate,
            r * speed * np.cos(theta) - 0.5 * rod * np.cos(phi) * phi_rate,
        ]
    )
    energy = 0.5 * (speed * by_angle) ** 2 + 0.5 * (middle**2).sum(axis=0)
    energy += 0.5 * (rod**2 / 12.0) * phi_rate**2
    power = np.gradient(energy, times, edge_order=2)
    channel = [c.name for c in system.layout.channels].index("torque[crank]")
    torque = np.array([evaluate.observe(system, state)[channel] for state in states])
    np.testing.assert_allclose(torque[2:-2] * speed, power[2:-2], atol=2e-3 * np.abs(power).max())


def test_freedoms_that_are_left_are_named():
    with pytest.raises(SolverError, match=r"drives and loops leave 1 degree of freedom, with slider\.z"):
        followed(slider_crank(), [0.0, 0.1])


def test_drives_that_lead_too_far_are_named():
    """A slider driven away by more than crank and rod can reach."""
    plain = slider_crank()
    row = np.zeros(1, drive.RECORD)
    row["i"], row["q_i"], row["linear"], row["speed"] = 3, 0, 1, 1.0
    system = assemble(
        plain.bodies, {}, {"closure": plain.records["closure"], "drive": row}, names={"drive": ["slider"]}
    )
    with pytest.raises(SolverError, match="loops do not close"):
        followed(system, np.linspace(0.0, 0.2, 41))
    assert followed(system, np.linspace(0.0, 0.01, 3))[-1].t == pytest.approx(0.01)
