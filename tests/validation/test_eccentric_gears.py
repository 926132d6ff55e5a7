# SPDX-License-Identifier: Apache-2.0
"""Transmission error of gears that sit beside the axis of their body or askew on it.

Oracles: the displacement along the line of action (closed form, first order in the eccentricity e; what is
left is e^2 over the centre distance), two involutes that touch, found point by point with their normals
(exact), the same eccentricity as separations of single flanks (`deviations.runout`), and the corner of a
leaning tooth.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import fsolve

from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system.compile import compile_model
from tests.validation.test_flank_deviations import WIDTH, machine, rolled

E, PHASE = 20e-6, 0.4


def with_faults(model, one=None, two=None):
    return model.replace_all({f"gears.{g}.faults": f for g, f in (("g1", one), ("g2", two)) if f})


def eccentric(amount=E, phase=PHASE):
    return {"e": {"type": "eccentricity", "amount": amount, "phase": phase}}


def normal_angle(model, flank=1):
    """Angle of the line of action of a flank in the world: f cos(alpha) t + sin(alpha) e."""
    pair = model.pairs["stage"]
    towards = model.meshes["stage"].theta + (math.pi if pair.gear2.z < 0 else 0.0)
    return towards + flank * (0.5 * math.pi - pair.alpha_wt)


@pytest.mark.parametrize("internal", [False, True])
@pytest.mark.parametrize("beta", [0.0, 15.0])
@pytest.mark.parametrize("direction", [0.0, 1.1])
def test_error_of_eccentric_gears_to_first_order(internal, beta, direction):
    """What comes out of either gear is its displacement along the line of action, e sin(phi + alpha)."""
    z1, z2 = (21, 60) if internal else (20, 31)
    hands = [f", helix_angle: {beta} deg, hand: {h}" if beta else "" for h in ("right", "left")]
    model = machine(
        z1, z2, hands[0], hands[0 if internal else 1], internal=internal, direction=direction, beta=beta
    )
    model = with_faults(model, eccentric(), eccentric(1.5 * E, -1.0))
    error, angle1, data = rolled(model, 5, z1)
    tooth = [model.phasing.tooth_angle[g] for g in ("g1", "g2")]
    n = normal_angle(model)
    angle2 = data["angle[driven]"].values[:-1]
    wanted = -E * np.cos(tooth[0] + PHASE + angle1 - n) + 1.5 * E * np.cos(tooth[1] - 1.0 + angle2 - n)
    assert np.ptp(error) > 2.0 * E
    # (2.5 e)^2 over a sin(alpha): the line of action turns by the displacement across it over that
    pair = model.pairs["stage"]
    left = (2.5 * E) ** 2 / abs(pair.a_w * math.sin(pair.alpha_wt))
    np.testing.assert_allclose(error, wanted, atol=left)


def touching(model, phi1, phi2):
    """Spin of gear 2 at which its left flanks touch those of gear 1 at spin phi1, near phi2."""
    pair = model.pairs["stage"]
    theta = model.meshes["stage"].theta
    centre2 = pair.a_w * np.array([math.cos(theta), math.sin(theta)])
    tooth = [model.phasing.tooth_angle[g] for g in ("g1", "g2")]
    faults = [model.gears[g].faults["e"] for g in ("g1", "g2")]
    gears = pair.gear1, pair.gear2

    def involute(k, phi, start, roll):
        """Point and normal of a left flank at a roll angle; `start` turns tooth 0 into the one meant."""
        at = tooth[k] + faults[k].phase + phi
        centre = faults[k].amount * np.array([math.cos(at), math.sin(at)]) + (centre2 if k else 0.0)
        a = start + tooth[k] + phi + gears[k].psi_b - roll
        radius, tangent = np.array([math.cos(a), math.sin(a)]), np.array([-math.sin(a), math.cos(a)])
        return centre + 0.5 * gears[k].d_b * (radius + roll * tangent), tangent

    def nearest(k, phi, towards):
        """Tooth nearest to the centre line."""
        step = 2.0 * math.pi / gears[k].z
        return step * round((towards - tooth[k] - phi) / step)

    first = nearest(0, phi1, theta)
    alpha = pair.alpha_wt
    best = None
    for shift in (-1, 0, 1):
        second = nearest(1, phi2, theta + math.pi) + shift * 2.0 * math.pi / gears[1].z

        def residual(x, second=second):
            p, n = involute(0, phi1, first, x[0])
            q, o = involute(1, x[2], second, x[1])
            return [*(1e3 * (p - q)), n[0] * o[1] - n[1] * o[0]]

        x = fsolve(residual, [math.tan(alpha), math.tan(alpha), phi2], xtol=1e-12)
        opposite = involute(0, phi1, first, x[0])[1] @ involute(1, x[2], second, x[1])[1] < 0.0
        real = opposite and min(x[:2]) > 0.0 and np.abs(residual(x)).max() < 1e-9
        if real and (best is None or abs(x[2] - phi2) < abs(best - phi2)):
            best = x[2]
    return best


def test_error_of_eccentric_gears_is_that_of_touching_involutes():
    """A tenth of a millimetre; beyond 0.2 mm together the gears would jam. Both go down to 1e-13 m."""
    model = with_faults(machine(20, 31, direction=0.3), eccentric(60e-6), eccentric(100e-6, 2.0))
    error, angle1, data = rolled(model, 2, 20)
    angle2 = data["angle[driven]"].values[:-1]
    pair = model.pairs["stage"]
    r1, r2, half = 0.5 * pair.gear1.d_b, 0.5 * pair.gear2.d_b, 0.5 * pair.j_bt
    for k in range(0, error.size, 3):
        # with load the teeth bend: the spin without load follows from the error
        there = touching(model, angle1[k], angle2[k])
        assert r1 * angle1[k] + r2 * there - half == pytest.approx(error[k], abs=2e-12)
    assert np.ptp(error) > 2e-4


@pytest.mark.each_value
@pytest.mark.parametrize("internal", [False, True])
@pytest.mark.parametrize("torque", [10.0, -10.0])
def test_small_eccentricities_agree_with_runout(internal, torque):
    """Frames against separations, both flanks; left are e^2/(a sin alpha) and the grids, 3e-6 of e."""
    z1, z2 = (21, 60) if internal else (20, 31)
    e = 2e-6
    model = machine(z1, z2, internal=internal, direction=0.5, torque=torque)
    for k in ("g1", "g2"):
        frame = model.replace(f"gears.{k}.faults", eccentric(e))
        runout = model.replace(f"gears.{k}.deviations", {"runout": {"amount": 2 * e, "phase": PHASE}})
        found, wanted = (rolled(m, 3, z1)[0] for m in (frame, runout))
        assert np.ptp(found) > 0.5 * e
        np.testing.assert_allclose(found, wanted, atol=1e-5 * e + e * e / 0.01)


def test_a_wobbling_gear_touches_with_a_corner():
    """The tooth leans by w along the line of action: its end comes nearer by half of the width, twice a turn.

    Without load a thousandth of the width carries: 5 nm.
    """
    w = 2e-4
    model = with_faults(machine(20, 31), {"w": {"type": "wobble", "amount": w, "phase": PHASE}})
    error, angle1, _ = rolled(model, 4, 20)
    lean = w * np.cos(model.phasing.tooth_angle["g1"] + PHASE + angle1 - normal_angle(model))
    np.testing.assert_allclose(error, -0.5 * WIDTH * np.abs(lean), atol=5e-9)


@pytest.mark.parametrize(
    "law",
    [
        {"law": "constant", "value": 4e8},
        {"law": "rectangular", "high": 4e8, "low": 3e8},
        {"law": "fourier", "mean": 4e8, "cosine": [-0.2]},
        {"law": "energy"},
        {"law": "hertz"},
    ],
)
def test_every_law_sees_an_eccentric_gear(law):
    """At rest under a torque: the travel of the bodies is that of the healthy pair less the displacement.

    The path of contact and the share of the pairs move by e over a base pitch, so the deflection changes by
    less than a hundredth.
    """
    text = machine(40, 51, torque=50.0).replace("meshes.stage.stiffness", law)
    found = []
    for faults in ({}, eccentric()):
        model = text.replace("gears.g1.faults", faults)
        data = solve_equilibrium(compile_model(model))
        found.append([float(data[f"{name}[stage]"]) for name in ("transmission_error", "mesh_force")])
        angle = float(data["angle[driver]"])
    healthy, faulty = found
    assert faulty[1] == pytest.approx(healthy[1], rel=5e-4)
    moved = -E * math.cos(model.phasing.tooth_angle["g1"] + PHASE + angle - normal_angle(model))
    deflection = healthy[0] - 0.5 * model.pairs["stage"].j_bt
    assert faulty[0] - healthy[0] == pytest.approx(moved, abs=0.01 * deflection + 1e-8)
