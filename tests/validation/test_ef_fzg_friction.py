# SPDX-License-Identifier: Apache-2.0
"""EF-FZG: mean friction loss of the simulated mesh against the gear loss factor H_V.

Source: FZG test gears and H_V as published in the reports and the library of GEARpie (Ohlendorf),
H_V = pi (u + 1)/(z1 u cos beta_b) (1 - eps_alpha + eps_1^2 + eps_2^2). With equal stiffness of all pairs
(S_R = 1, T_R = 0) a spur mesh shares its load as the formula assumes: all of it or one half.

Contact lines of a helical mesh share the load by their length, which the formula does not describe: with a
width of whole overlap ratios the load per length is constant and the last factor is
(eps_1^2 + eps_2^2)/eps_alpha (the sliding speed averaged over the path). As the overlap ratio goes
to zero the formula holds, with its cos beta_b from the force normal to the flank.

How: gear 1 at constant speed, constant torque on gear 2, friction 1e-3 so that it hardly changes the normal
force; the slow speed keeps the vibration after each change of pairs short, the small load keeps the
deflection small against the base pitch. The gap is given: the rounded profile shifts of the source leave a
slightly negative one, and both flanks would rub. Loss/(mu P) to 1e-3.
"""

from __future__ import annotations

import math

import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.time import run_time
from pitchpoint.system.compile import compile_model

MU = 1e-3
RPM = 60.0
PERIODS, STEPS = 3, 8000

FZG_C = (
    "g1: {number_of_teeth: 16, normal_module: 4.5 mm, face_width: 14 mm, "
    "profile_shift_coefficient: 0.1817, tip_diameter: 82.636 mm}",
    "g2: {number_of_teeth: 24, normal_module: 4.5 mm, face_width: 14 mm, "
    "profile_shift_coefficient: 0.1715, tip_diameter: 118.544 mm}",
    "center_distance: 91.5 mm, backlash: {normal: 0.1 mm}",
)
S30 = (
    "g1: {number_of_teeth: 30, normal_module: 2 mm, face_width: 14 mm, profile_shift_coefficient: 0}",
    "g2: {number_of_teeth: 30, normal_module: 2 mm, face_width: 14 mm, profile_shift_coefficient: 0}",
    "center_distance: 60 mm, backlash: {normal: 0.1 mm}",
)


def helical(overlap):
    """A pair 20/30, module 3 mm, sin beta = 0.25, with a given overlap ratio."""
    width = overlap * math.pi * 3.0 / 0.25
    beta = math.degrees(math.asin(0.25))
    gear = "{{number_of_teeth: {}, normal_module: 3 mm, helix_angle: {} deg, hand: {}, face_width: {} mm"
    gear += ", profile_shift_coefficient: 0.1}}"
    return (
        "g1: " + gear.format(20, beta, "left", width),
        "g2: " + gear.format(30, beta, "right", width),
        "backlash: {normal: 0.1 mm}",
    )


def simulated(gears, torque=1.0):
    """Friction loss over mu P, from the friction itself and from the torques, and the pair."""
    one, two, mesh = gears
    z1, z2 = (int(g.split("number_of_teeth: ")[1].split(",")[0]) for g in (one, two))
    period = 60.0 / (RPM * z1)
    step = period / STEPS
    motion = f"drive: {{driver: {{speed: {RPM} rpm}}}}"
    text = (
        f"gears:\n  {one}\n  {two}\n"
        "bodies:\n  driver: {gears: [g1], inertia: 1.0e-4 kg m^2}\n"
        "  driven: {gears: [g2], inertia: 1.0e-4 kg m^2}\n"
        f"meshes:\n  stage: {{gears: [g1, g2], {mesh}, damper: {{ratio: 0.1}}, "
        "friction: {mu: 0.001, v_eps: 0.02 mm/s},\n"
        "    stiffness: {law: din3990, stiffness_ratio: 1.0, tip_relief_factor: 0.0}}\n"
        f"loads:\n  brake: {{body: driven, torque: {torque!r} N m}}\n"
        f"scenarios:\n  run: {{{motion}, duration: {(PERIODS + 1) * period!r} s, "
        f"settle_time: {period!r} s, step: {step!r} s}}\n"
    )
    model = loads_model(text)
    done = run_time(compile_model(model, "run"))
    assert done.status == 1
    mean = {name: values["mean"] for name, values in done.channels.items()}
    omega = RPM * math.pi / 30.0
    power = mean["torque[driver]"] * omega
    out = -torque * mean["speed[driven]"]
    scale = MU * power
    return mean["friction_power[stage]"] / scale, (power - out) / scale, model.pairs["stage"]


def shares(pair):
    """eps_1 and eps_2 of the parts of the path beyond the pitch point."""
    return pair.g_a / pair.gear1.p_et, pair.g_f / pair.gear1.p_et


def factor(pair):
    """What stands before the bracket of the formula."""
    u = pair.gear2.z / pair.gear1.z
    return math.pi * (u + 1.0) / (pair.gear1.z * u * math.cos(pair.gear1.beta_b))


def ohlendorf(pair):
    """Gear loss factor of the formula."""
    e1, e2 = shares(pair)
    return factor(pair) * (1.0 - e1 - e2 + e1**2 + e2**2)


@pytest.mark.parametrize(("gears", "H_V"), [(FZG_C, 0.198620), (S30, 0.149443)], ids=["C14", "S30"])
def test_spur(gears, H_V):
    friction, torques, pair = simulated(gears)
    assert ohlendorf(pair) == pytest.approx(H_V, rel=1e-4)
    assert friction == pytest.approx(H_V, rel=1e-3)
    assert torques == pytest.approx(H_V, rel=1e-3)


def test_helical_with_whole_overlap():
    friction, torques, pair = simulated(helical(1.0))
    e1, e2 = shares(pair)
    H_V = factor(pair) * (e1**2 + e2**2) / (e1 + e2)
    assert pair.eps_beta == pytest.approx(1.0, abs=1e-12)
    assert friction == pytest.approx(H_V, rel=1e-3)
    assert torques == pytest.approx(H_V, rel=1e-3)


def test_helical_without_overlap():
    friction, torques, pair = simulated(helical(0.002), torque=0.002)
    assert friction == pytest.approx(ohlendorf(pair), rel=1e-3)
    assert torques == pytest.approx(ohlendorf(pair), rel=1e-3)
