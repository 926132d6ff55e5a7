# SPDX-License-Identifier: Apache-2.0
"""Names without a linear response: magnitudes with zero mean, and directions in which a body cannot move."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.solvers.frequency_response import find_response
from pitchpoint.solvers.mesh_response import find_mesh_response
from pitchpoint.solvers.state_space import state_space
from tests.support.machines import compiled, pair

LAW = "{law: constant, value: 3.0e8 N/m}"
HERTZ = [20.0, 70.0, 300.0]
PARTS = ["bearing_force[seat.fx]", "bearing_force[seat.fy]"]
RADIAL, DIRECTION = "bearing_force[seat.radial]", "bearing_force[seat.direction]"


def rotor(fx: str = "0 N", fy: str = "0 N"):
    return compiled(
        "bodies:\n  disc: {motion: planar, mass: 3.0, inertia: 0.01}\n"
        "bearings:\n  seat: {body: disc, stiffness: {radial: 5e6}, damping: {radial: 300}}\n"
        f"loads:\n  x: {{body: disc, force: [{fx}, {fy}, 0 N]}}\n"
    )[1]


def test_magnitude_and_direction_at_zero_mean_force():
    system = rotor()
    problem = (
        r"seat.radial\]: the mean force is zero, so its magnitude has no linear response; use "
        r"bearing_force\[seat.fx\] and bearing_force\[seat.fy\]"
        r"(.|\n)*seat.direction\]: the mean force is zero, so its direction has no"
    )
    with pytest.raises(ModelError, match=problem):
        find_response(system, ["unbalance[disc]"], [RADIAL, DIRECTION, *PARTS], HERTZ)
    with pytest.raises(ModelError, match=problem):
        state_space(system, ["disc.fx"], [RADIAL, DIRECTION])
    response = find_response(system, ["disc.fy"], [PARTS[1]], HERTZ).response[:, 0, 0]
    w = 2.0 * np.pi * np.array(HERTZ)
    support = 5e6 + 300j * w
    assert response == pytest.approx(-support / (support - 3.0 * w**2), rel=1e-6)


@pytest.mark.parametrize("mean", [(300.0, -500.0), (-800.0, 0.0), (0.0, 20.0)])
def test_magnitude_and_direction_at_a_mean_force(mean):
    # d|F| = F . dF/|F|, d(psi) = F x dF/F^2; under 800 N along x the bearing acts along -x, where the angle
    # jumps by a whole turn
    for sign in (1.0, -1.0):
        x, y = sign * mean[0], sign * mean[1]
        system = rotor(f"{x} N", f"{y} N")
        found = find_response(system, ["disc.fx", "disc.fy"], [RADIAL, DIRECTION, *PARTS], HERTZ).response
        size, (of_x, of_y) = np.hypot(x, y), (found[:, 2], found[:, 3])
        force = -np.array([x, y])
        assert found[:, 0] == pytest.approx((force[0] * of_x + force[1] * of_y) / size, rel=1e-5, abs=1e-6)
        turned = (force[0] * of_y - force[1] * of_x) / size**2
        assert found[:, 1] == pytest.approx(turned, rel=1e-4, abs=1e-6 / size)


def test_square_is_no_kink():
    """The power of a damper at rest is a square of the rate: its linear response is zero."""
    system = compiled(
        "bodies:\n  disc: {motion: torsion, inertia: 2.0}\n"
        "bearings:\n  spring: {body: disc, stiffness: {torsion: 800}, damping: {torsion: 4}}\n"
        "sensors:\n  rate: {type: joint, coordinate: disc, derivative: 1}\n"
        "blocks:\n  power: {type: formula, formula: 4*rate^2, inputs: [rate]}\n"
        "  amount: {type: formula, formula: abs(rate), inputs: [rate]}\n"
    )[1]
    found = find_response(system, ["disc.mz"], ["signal[rate]", "signal[power]"], HERTZ).response[1, :, 0]
    assert abs(found[0]) > 1e-4 and abs(found[1]) < 1e-9
    with pytest.raises(ModelError, match=r"signal\[amount\]: has a kink or jump at the operating point"):
        find_response(system, ["disc.mz"], ["signal[amount]"], HERTZ)


def test_loads_and_motions_in_directions_without_freedom():
    system = compiled(pair(LAW))[1]
    problem = (
        r"driver.fx: excites nothing, since driver only rotates about its axis; use driver.mz, or give "
        r"the body more freedom \(motion: planar or free, or a joint\)(.|\n)*"
        r"unbalance\[driven\]: excites nothing"
        r"(.|\n)*driven.ux: is always zero, since driven only rotates about its axis; use driven.rz"
    )
    inputs, outputs = ["driver.mz", "driver.fx", "unbalance[driven]"], ["driven.rz", "driven.ux"]
    with pytest.raises(ModelError, match=problem) as found:
        find_response(system, inputs, outputs, HERTZ)
    assert len(found.value.problems) == 3
    with pytest.raises(ModelError, match=problem):
        state_space(system, inputs, outputs)
    with pytest.raises(
        ModelError, match=r"disc.uz: is always zero, since disc moves only in its plane; use disc.ux"
    ):
        find_response(rotor(), ["disc.fx"], ["disc.uz"], HERTZ)


def test_displacements_of_mesh_orders():
    system = compiled(pair(LAW))[1]
    with pytest.raises(
        ModelError, match="driven.uy: is always zero, since driven only rotates about its axis"
    ):
        find_mesh_response(system, ["acceleration[driven.uy]"], "driver", [50.0])
