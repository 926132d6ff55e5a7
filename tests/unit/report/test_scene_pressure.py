# SPDX-License-Identifier: Apache-2.0
"""Hertzian pressure on the flanks of a scene: closed form, and ISO 6336-2 for one pair."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq

from pitchpoint.io.yaml_model import loads_model
from tests.support.bevel_teeth import PAIR as PAIR_OF_BEVELS
from tests.support.bevel_teeth import RUN
from tests.support.scene_models import CARRIER, PAIR, seen

STEEL, IRON = (206e9, 0.3), (175e9, 0.26)
BETA, ALPHA_N, MODULE, WIDTH = math.radians(15.0), math.radians(20.0), 3e-3, 30e-3
TEETH, SHIFT = (23, 41), 0.2
ALPHA_T = math.atan(math.tan(ALPHA_N) / math.cos(BETA))
BETA_B = math.asin(math.sin(BETA) * math.cos(ALPHA_N))
BRIEF = PAIR.replace("duration: 0.2 s", "duration: 0.01 s")
MIXED = BRIEF.replace(
    "hand: right, face_width: 30 mm,",
    "hand: right, face_width: 30 mm, material: {{youngs_modulus: 175 GPa, poisson_ratio: 0.26, "
    "density: 7200 kg/m^3}},",
)


def involute(alpha: float) -> float:
    return math.tan(alpha) - alpha


@pytest.fixture(scope="module")
def alpha_wt() -> float:
    """Working pressure angle without clearance for the sum of profile shifts."""
    wanted = involute(ALPHA_T) + 2.0 * SHIFT * math.tan(ALPHA_N) / sum(TEETH)
    return float(brentq(lambda alpha: involute(alpha) - wanted, 0.1, 0.8))


def unit_pressures(text: str, name: str = "m", scenario: str = "on") -> tuple[np.ndarray, np.ndarray]:
    """Places from the pitch point and pressures of 1 N/m, as the page holds them."""
    scene, _, _ = seen(text, scenario)
    contact = scene.contact(name)
    pressure = scene.array(contact["unit_pressure"])
    return np.linspace(*contact["path"], len(pressure)), pressure


def at_pitch_point(text: str, name: str = "m", scenario: str = "on") -> float:
    places, pressure = unit_pressures(text, name, scenario)
    return float(np.interp(0.0, places, pressure))


@pytest.mark.parametrize(("text", "wheel"), [(BRIEF, STEEL), (MIXED, IRON)], ids=["steel", "steel on iron"])
def test_nominal_contact_stress_of_iso_6336_2_for_one_pair(text, wheel, alpha_wt):
    """σ_H0 = Z_H Z_E sqrt(F_t/(d_1 b) (u + 1)/u) where one pair carries all, so that Z_ε = 1, without Z_β,
    which no theory gives. Z_E of steel on steel is printed in the standard, 189.8 sqrt(MPa)."""
    c = [(1.0 - nu * nu) / E for E, nu in (STEEL, wheel)]
    Z_E = math.sqrt(1.0 / (math.pi * sum(c)))
    if wheel is STEEL:
        assert Z_E * 1e-3 == pytest.approx(189.8, abs=0.05)
    Z_H = math.sqrt(
        2.0 * math.cos(BETA_B) * math.cos(alpha_wt) / (math.cos(ALPHA_T) ** 2 * math.sin(alpha_wt))
    )
    d_1 = MODULE * TEETH[0] / math.cos(BETA)
    torque, u = 100.0, TEETH[1] / TEETH[0]
    F_t = 2.0 * torque / d_1
    sigma = Z_H * Z_E * math.sqrt(F_t / (d_1 * WIDTH) * (u + 1.0) / u)
    load = F_t / math.cos(ALPHA_T) / WIDTH  # per width along the base tangent, as lines have it
    # linear between 65 places: 1e-4
    assert at_pitch_point(text.format(z="[0, 0, 1]", x="[1, 0, 0]")) * math.sqrt(load) == pytest.approx(
        sigma, rel=2e-4
    )


def test_pressure_of_the_ends_has_their_radii(alpha_wt):
    """Tip circles of 23 + 2 (1 + 0.2) and 41 + 2 modules end the path; there ρ is the leg of tip and base."""
    places, pressure = unit_pressures(BRIEF.format(z="[0, 0, 1]", x="[1, 0, 0]"))
    c = 2.0 * (1.0 - STEEL[1] ** 2) / STEEL[0]
    base = [0.5 * MODULE * z / math.cos(BETA) * math.cos(ALPHA_T) for z in TEETH]
    whole = sum(base) * math.tan(alpha_wt)
    first = base[0] * math.tan(alpha_wt) + places[[0, -1]]
    for rho, found in zip(first, pressure[[0, -1]], strict=True):
        radius = rho * (whole - rho) / whole / math.cos(BETA_B)
        assert found == pytest.approx(math.sqrt(1.0 / (math.pi * c * radius)), rel=1e-6)


def test_flank_of_an_internal_gear_is_hollow():
    """Planet of 18 in a ring of 60 teeth, module 2 mm: 1/ρ is the difference of both."""
    text = CARRIER.replace("{law: constant, value: 3e8 N/m}", "{law: din3990}").replace("0.4 s", "0.02 s")
    rho = [0.5 * 2e-3 * z * math.sin(ALPHA_N) for z in (18, 60)]
    radius = rho[0] * rho[1] / (rho[1] - rho[0])
    c = 2.0 * (1.0 - STEEL[1] ** 2) / STEEL[0]
    assert at_pitch_point(text, "pr") == pytest.approx(math.sqrt(1.0 / (math.pi * c * radius)), rel=2e-4)


def test_laws_without_pairs_have_no_pressure():
    scene, _, _ = seen(CARRIER.replace("0.4 s", "0.02 s"))
    assert all("unit_pressure" not in contact for contact in scene.header["contacts"])


@pytest.mark.parametrize("beta", [0.0, 30.0], ids=["straight", "spiral"])
def test_bevel_flanks_have_the_radii_of_their_virtual_gears_at_the_pitch_cones(beta):
    """There the geodesic radius of the involute, R tan σ, is r_v sin α_t with r_v = R tan δ (Tredgold)."""
    text = PAIR_OF_BEVELS if beta else PAIR_OF_BEVELS.replace("spiral_angle: 30 deg, hand: left, ", "")
    text = text if beta else text.replace("spiral_angle: 30 deg, hand: right, ", "")
    text += RUN % 60
    pair = loads_model(text).bevel_pairs["stage"]
    alpha_t = math.atan(math.tan(ALPHA_N) / math.cos(math.radians(beta)))
    beta_b = math.atan(math.tan(math.radians(beta)) * math.cos(alpha_t))
    curvature = sum(
        1.0 / (pair.R_m * math.tan(gear.delta) * math.sin(alpha_t)) for gear in (pair.gear1, pair.gear2)
    )
    c = 2.0 * (1.0 - STEEL[1] ** 2) / STEEL[0]
    wanted = math.sqrt(curvature * math.cos(beta_b) / (math.pi * c))
    assert at_pitch_point(text, "stage", "turn") == pytest.approx(wanted, rel=2e-4)
