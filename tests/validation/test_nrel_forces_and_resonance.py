# SPDX-License-Identifier: Apache-2.0
"""KS-NRELGBX: tooth forces and resonance speeds of the 5 MW reference gearbox, asked of the compiled model.

Source: gfsReboucas/Drivetrain, KISSsoft 03/2017 reports of stages 1 and 3. Mapping: the reports give forces
at the reference circle (F_t, F_r, F_a, F_n) and at the operating circle (F_t, F_r); a mesh acts at its
operating circle, and its normal and axial force are the same on either. Their resonance speed n_E1 is that of
the tooth pair alone with the mesh stiffness c_gamma_alpha b: the torsional natural frequency of gears on
rigid shafts, over the number of teeth of gear 1. Inertias, stiffnesses and torques as printed. Tolerances:
half a unit of the last printed digit, or the rounding of the printed inputs where that is more (noted there).
"""

from __future__ import annotations

import math

import pytest

from pitchpoint.contact.stiffness.description import PhaseStiffness
from pitchpoint.geometry import CylindricalGear, GearPair, missing_profile_shift
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from pitchpoint.system.rules.mesh_laws import MeshLaws
from tests.support.one_mesh import OneMesh


def pressed(pair: GearPair, torque: float) -> OneMesh:
    """A mesh in which gear 1 carries a torque [N m]."""
    mesh = OneMesh(pair, MeshLaws(stiffness=PhaseStiffness(mean=1e10)))
    mesh.press(torque / mesh.row["r_b1"] / 1e10)
    mesh.evaluate()
    return mesh


def stage_3() -> GearPair:
    beta, m_n = math.radians(10.0), 14e-3
    x2 = missing_profile_shift(
        z_sum=119, m_n=m_n, alpha_n=math.radians(20.0), beta=beta, a_w=0.861, x_known=0.48
    )
    return GearPair(
        CylindricalGear(z=24, m_n=m_n, beta=beta, x=0.48, b=0.36),
        CylindricalGear(z=95, m_n=m_n, beta=-beta, x=x2, b=0.36),
        0.861,
    )


def test_forces_of_the_helical_stage():
    """T1 40 953.0 N m at 5000 kW and 1165.9 rpm, which leaves 1e-6 of every force."""
    mesh = pressed(stage_3(), 40953.0)
    printed = {
        "circumferential_force": 235840.3,
        "radial_force": 99409.4,
        "axial_force": 42329.8,
        "normal_force": 259412.2,
    }
    for name, value in printed.items():
        assert abs(mesh.get(name)) == pytest.approx(value, rel=2e-6), name
    reference_circle = 240064.4 * mesh.pair.gear1.d / mesh.pair.d_w1
    assert reference_circle == pytest.approx(235840.3, rel=2e-6)


def test_forces_of_the_planet_stage():
    """Sun torque 999 650.9 N m on three planets; the planets hand on the same force to the ring."""
    sun = CylindricalGear(z=19, m_n=45e-3, x=0.617, b=0.491)
    x_planet = missing_profile_shift(
        z_sum=36, m_n=45e-3, alpha_n=math.radians(20.0), a_w=0.863, x_known=0.617
    )
    planet = CylindricalGear(z=17, m_n=45e-3, x=x_planet, b=0.491)
    x_ring = missing_profile_shift(
        z_sum=-39, m_n=45e-3, alpha_n=math.radians(20.0), a_w=-0.863, x_known=x_planet
    )
    ring = CylindricalGear.internal(z=56, m_n=45e-3, x=x_ring, b=0.491)
    outer = pressed(GearPair(sun, planet, 0.863), 999650.9 / 3.0)
    assert outer.get("circumferential_force") == pytest.approx(731585.690, rel=1e-6)
    planet_torque = 779454.877 * 0.5 * planet.d
    inner = pressed(GearPair.at_distance(planet, ring, 0.863), planet_torque)
    assert inner.get("circumferential_force") == pytest.approx(792551.164, rel=1e-6)
    assert inner.get("normal_force") == pytest.approx(outer.get("normal_force"), rel=1e-6)


def resonance(gears: str, bodies: str, meshes: str, teeth: int) -> float:
    """Speed of gear 1 [rpm] at which the mesh frequency meets the only elastic mode that moves it."""
    model = loads_model(f"gears:\n{gears}bodies:\n{bodies}meshes:\n{meshes}")
    modes = find_modes(compile_model(model))
    return 60.0 * float(max(modes.frequency)) / teeth


def test_resonance_of_the_helical_stage():
    """m_red 0.36503 kg/mm, n_E1 2843 rpm (2842.7 from the printed digits)."""
    J1, J2 = 3.87681, 399.02862
    r_b1, r_b2 = 0.160013, 0.633385
    assert 1.0 / (r_b1**2 / J1 + r_b2**2 / J2) / 360.0 == pytest.approx(0.36503, abs=5e-6)
    wheel = "normal_module: 14 mm, helix_angle: 10 deg, face_width: 360 mm, "
    found = resonance(
        f"  a: {{number_of_teeth: 24, {wheel}hand: right, profile_shift_coefficient: 0.48}}\n"
        f"  b: {{number_of_teeth: 95, {wheel}hand: left}}\n",
        f"  one: {{gears: [a], inertia: {J1} kg m^2}}\n  two: {{gears: [b], inertia: {J2} kg m^2}}\n",
        "  s: {gears: [a, b], center_distance: 861 mm, backlash: {base_tangent: 0.4 mm},\n"
        f"      stiffness: {{law: constant, value: {18.632e9 * 0.36} N/m}}}}\n",
        24,
    )
    assert found == pytest.approx(2842.7, abs=0.1)


def planets(number: int) -> tuple[str, str, str]:
    """Sun and equal planets on a carrier at rest, in the words of a model file."""
    gear = "normal_module: 45 mm, face_width: 491 mm"
    gears = f"  s: {{number_of_teeth: 19, {gear}, profile_shift_coefficient: 0.617}}\n"
    bodies = "  sun: {gears: [s], inertia: 214.70593 kg m^2}\n"
    meshes = ""
    for k in range(number):
        gears += f"  p{k}: {{number_of_teeth: 17, {gear}, profile_shift_coefficient: 0.8021}}\n"
        bodies += f"  planet{k}: {{gears: [p{k}], inertia: 156.0282 kg m^2}}\n"
        meshes += (
            f"  m{k}: {{gears: [s, p{k}], center_distance: 863 mm, direction: {360 * k / number} deg,\n"
            f"       stiffness: {{law: constant, value: {13.426e9 * 0.491} N/m}}}}\n"
        )
    return gears, bodies, meshes


def test_resonance_of_the_sun_with_three_planets():
    """n_E1 2266 rpm, m_red 0.6606 kg/mm: the sun against all three planets."""
    assert resonance(*planets(3), 19) == pytest.approx(2266.0, abs=0.5)


def test_resonance_of_a_planet_in_the_fixed_ring():
    """n_E1 1435 rpm, m_red J_p/(r_bp² b) 2.4597 kg/mm: the ring stands still (here a huge inertia)."""
    gear = "normal_module: 45 mm, face_width: 491 mm"
    found = resonance(
        f"  p: {{number_of_teeth: 17, {gear}, profile_shift_coefficient: 0.8021}}\n"
        f"  r: {{type: internal, number_of_teeth: 56, {gear}}}\n",
        "  planet: {gears: [p], inertia: 156.0282 kg m^2}\n  ring: {gears: [r], inertia: 1.0e10 kg m^2}\n",
        "  m: {gears: [p, r], center_distance: 863 mm,\n"
        f"      stiffness: {{law: constant, value: {16.063e9 * 0.491} N/m}}}}\n",
        17,
    )
    assert found == pytest.approx(1435.0, abs=0.5)
