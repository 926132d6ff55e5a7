# SPDX-License-Identifier: Apache-2.0
"""Planet sets from a model file: Willis's speeds, shared load, and the phases of the meshes.

Phases: with N planets at equal angles the meshes with the sun follow each other by frac(z_s n / N) of a base
pitch, those with the ring by frac(-z_r n / N). Cases 48-16-80 in phase, 51-17-85 one after the other,
54-18-90 in counter-phase, of drivetrainhub.com as listed in cases.md (PL-PHASE). Planets are counted
counter-clockwise, as here; which way phases count is a matter of sign, so both are allowed, alike for all
planets. Closed forms; tolerances are those of the loaded state: twist of the shafts against the base pitch.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model


def planet_set(sun, planet, ring, count, module=4.0):
    """Model file of a set with its ring held, torque into the sun and out of the carrier."""
    gear = (
        "number_of_teeth: {}, normal_module: {} mm, face_width: 40 mm, profile_shift_coefficient: 0, "
        "normal_pressure_angle: 25 deg"
    )
    arm = 0.5 * module * (sun + planet)
    angles = 2.0 * np.pi * np.arange(count) / count
    places = [(float(arm * np.cos(a)), float(arm * np.sin(a))) for a in angles]
    mesh = "stiffness: {law: constant, value: 5e8 N/m}, damper: {ratio: 0.05}"
    lines = [
        "gears:",
        f"  sun: {{{gear.format(sun, module)}}}",
        f"  ring: {{{gear.format(ring, module)}, type: internal}}",
        *(f"  p{k}: {{{gear.format(planet, module)}}}" for k in range(count)),
        "bodies:",
        "  sun: {gears: [sun], position: [0, 0, 0]}",
        "  carrier: {inertia: 0.5 kg m^2, mass: 10 kg, position: [0, 0, 0]}",
        "  ring: {gears: [ring], motion: fixed, position: [0, 0, 0]}",
        *(f"  b{k}: {{gears: [p{k}], position: [{x!r} mm, {y!r} mm, 0]}}" for k, (x, y) in enumerate(places)),
        "joints:",
        *(f"  pin{k}: {{type: revolute, bodies: [carrier, b{k}]}}" for k in range(count)),
        "meshes:",
        *(f"  s{k}: {{gears: [sun, p{k}], {mesh}}}" for k in range(count)),
        *(f"  r{k}: {{gears: [p{k}, ring], {mesh}}}" for k in range(count)),
        "loads:",
        "  in: {body: sun, torque: 300 N m}",
        "  out: {body: carrier, torque: balance}",
        "scenarios:",
        "  steady: {speed: {sun: 1000 rpm}, duration: 20 ms}",
    ]
    return loads_model("\n".join(lines))


def test_speeds_follow_willis_and_the_load_is_shared():
    model = planet_set(21, 39, 99, 3)
    assert model.start_speeds("steady")["carrier"] == pytest.approx(1000.0 * np.pi / 30 * 21 / 120, rel=1e-12)
    found = solve_time(compile_model(model, "steady"))
    rpm = 30.0 / np.pi
    assert found["speed[carrier]"].values.mean() * rpm == pytest.approx(175.0, rel=1e-4)
    # against the carrier: -(1000 - 175) 21/39
    assert found["speed[b0]"].values.mean() * rpm == pytest.approx(-444.2308, rel=1e-4)
    r_b = 0.5 * 21 * 4e-3 * np.cos(np.radians(25.0))
    for k in range(3):
        assert found[f"mesh_force[s{k}]"].values.mean() == pytest.approx(300.0 / (3 * r_b), rel=1e-3)
        assert found[f"mesh_force[r{k}]"].values.mean() == pytest.approx(-300.0 / (3 * r_b), rel=1e-3)


def test_the_carrier_takes_the_sum_of_the_torques():
    """z_r/z_s times the torque of the sun on the ring, the sum on the carrier."""
    found = solve_equilibrium(compile_model(planet_set(21, 39, 99, 3)))
    assert float(found["torque[out]"]) == pytest.approx(-300.0 * (1.0 + 99 / 21), rel=1e-6)


@pytest.mark.parametrize(
    ("teeth", "sequence"),
    [
        ((48, 16, 80), (0.0, 0.0, 0.0, 0.0)),
        ((51, 17, 85), (0.0, 0.75, 0.5, 0.25)),
        ((54, 18, 90), (0.0, 0.5, 0.0, 0.5)),
    ],
)
def test_phases_of_the_meshes(teeth, sequence):
    found = solve_equilibrium(compile_model(planet_set(*teeth, 4)))
    for mesh in "sr":
        phase = np.array([float(found[f"mesh_phase[{mesh}{k}]"]) for k in range(4)])
        relative = phase - phase[0]
        for sign in (1.0, -1.0):
            off = relative - sign * np.array(sequence)
            if np.abs(off - np.round(off)).max() < 2e-3:  # deflection of 20 um over a base pitch of 11.8 mm
                break
        else:
            raise AssertionError(f"{mesh}: {relative % 1.0}")
