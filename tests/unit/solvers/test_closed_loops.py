# SPDX-License-Identifier: Apache-2.0
"""Mechanisms at rest: against the minimum of their energy and against moments by hand."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements.force import RECORD as FORCE
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.system import evaluate
from tests.support.engine import torques
from tests.support.machines import compiled
from tests.support.mechanisms import four_bar, slider_crank


def weights(masses, arm):
    """A force on every body: constant in the world, at the origin plus an arm along z only."""
    records = np.zeros(len(masses), FORCE)
    for k, (record, mass) in enumerate(zip(records, masses, strict=True), start=1):
        record["i"], record["value"] = k, 1.0
        record["F"][1] = -9.81 * mass
    return records


def test_a_slider_crank_is_held_by_the_torque_of_virtual_work():
    force = np.zeros(1, FORCE)
    force["i"], force["value"] = 3, 1.0
    force["F"][0, 0] = -100.0
    system = slider_crank(force=force)
    crank = system.layout.coordinate("crank.spin")
    found = find_equilibrium(system, None, [crank])
    theta, r, rod = 0.4, 0.3, 1.0
    by_angle = -r * np.sin(theta) - r**2 * np.sin(theta) * np.cos(theta) / np.sqrt(
        rod**2 - (r * np.sin(theta)) ** 2
    )
    assert found.reaction[0] == pytest.approx(100.0 * by_angle, rel=1e-10)
    # the pin takes the force along x
    reaction = evaluate.observe(system, found.state)[system.layout.channel("reaction_force[pin x]")]
    assert abs(reaction) == pytest.approx(100.0, rel=1e-9)


def test_a_four_bar_hangs_where_its_energy_is_least():
    """Forces at the origins of coupler and rocker: the energy is that of the two moving pins."""
    points = ((0.0, 0.0), (0.5, -0.2), (1.3, -0.3), (1.5, 0.0))
    system = four_bar(points=points, force=weights((0.0, 3.0, 2.0), 0.0))
    found = find_equilibrium(system, None, [])
    fr = system.workspace.fr
    evaluate.residual(system, found.state)
    crank = np.linalg.norm(np.subtract(points[1], points[0]))
    coupler, rocker = (np.linalg.norm(np.subtract(points[k + 1], points[k])) for k in (1, 2))

    def energy(theta):
        b = crank * np.array([np.cos(theta), np.sin(theta)])
        d = np.array(points[3])
        span = np.linalg.norm(d - b)
        along = (span**2 + coupler**2 - rocker**2) / (2.0 * span)
        down = np.sqrt(max(coupler**2 - along**2, 0.0))
        e = (d - b) / span
        c = b + along * e + down * np.array([e[1], -e[0]])
        return 3.0 * 9.81 * b[1] + 2.0 * 9.81 * c[1]

    pin = fr["r"][2][:2]
    theta = float(np.arctan2(pin[1], pin[0]))
    h = 1e-4
    far_low, low, here, high, far_high = (energy(theta + k * h) for k in (-2, -1, 0, 1, 2))
    assert (8.0 * (high - low) - far_high + far_low) / (12 * h) == pytest.approx(0.0, abs=1e-7)
    assert low - 2.0 * here + high > 0.0
    assert np.abs(system.workspace.g).max() < 1e-12


def test_a_moment_on_a_free_mechanism_has_no_rest():
    system = four_bar(torque=torques([(1, 5.0)]))
    with pytest.raises(Exception, match="no equilibrium found"):
        find_equilibrium(system, None, [])


def test_a_four_bar_comes_to_rest_in_line():
    """Springs without moment where all joints are on one line: that is the rest, from wherever it starts.

    There the loop leaves one direction more free than beside it.
    """
    text = """\
bodies:
  crank: {mass: 1 kg, center_of_mass: [50 mm, 0, 0], inertia_tensor: [1e-4, 1e-3, 1e-3, 0, 0, 0],
    position: [0, 0, 0], markers: {pin: {position: [100 mm, 0, 0]}}}
  rod: {mass: 1 kg, center_of_mass: [150 mm, 0, 0], inertia_tensor: [1e-4, 8e-3, 8e-3, 0, 0, 0],
    markers: {big: {}, small: {position: [300 mm, 0, 0]}}}
  rocker: {mass: 1 kg, center_of_mass: [100 mm, 0, 0], inertia_tensor: [1e-4, 5e-3, 5e-3, 0, 0, 0],
    position: [200 mm, 0, 0], markers: {a: {}, b: {position: [200 mm, 0, 0]}}}
joints:
  main: {type: revolute, bodies: [ground, crank], position: [0, 0, 0], start: {spin: 60 deg}}
  first: {type: revolute, bodies: [crank.pin, rod.big]}
  base: {type: revolute, bodies: [ground, rocker.a], position: [200 mm, 0, 0], start: {spin: 80 deg}}
  second: {type: revolute, bodies: [rod.small, rocker.b]}
torsion_springs:
  k: {bodies: [crank], stiffness: 900 N m/rad}
  l: {bodies: [rocker], stiffness: 500 N m/rad}
scenarios:
  on: {duration: 1 s}
"""
    _, system = compiled(text, "on")
    state = prepare_start(system, system.scenario).state
    assert np.abs(state.q).max() < 1e-6
