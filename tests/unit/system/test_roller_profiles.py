# SPDX-License-Identifier: Apache-2.0
"""Rollers with the profile of ISO/TS 16281 between two rings, against a model with both contacts.

In the model a roller is free to move along the line of contact and to tilt in its plane. Each of its slices
has a gap P and a line contact of its own with the inner and with the outer raceway; the roller is where both
contacts have the same resultant. That the rings approach each other by 2 P more than without profile, as in
the standard, is a result of the model.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq, root
from scipy.special import beta

from pitchpoint.contact.rolling import LINE, Raceways, roller_profile, roller_slices, roller_stiffness
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

STEEL = 2.0 * (1.0 - 0.3**2) / 206e9
PAGE = Path(__file__).parents[3] / "docs" / "bearings.md"
MODEL = """\
bodies:
  rotor: {motion: free, mass: 2 kg, inertia: 2e-3, transverse_inertia: 2e-3, axes: {z: AXIS, x: [1, 0, 0]}}
"""
KINDS = {
    "cylindrical": "designation: NU 208 ECP, clearance: 0",
    "needle": "designation: NA4905, clearance: -4 um",
    "long": "type: roller, effective_length: 24 mm, elements: 20, element_diameter: 4 mm, "
    "pitch_diameter: 40 mm",
    "tapered": "designation: 30208, axial_force_absorption: positive, preload_distance: 8 um",
    "given tapered": "type: roller, effective_length: 24 mm, elements: 20, element_diameter: 9 mm, "
    "pitch_diameter: 60 mm, contact_angle: -15 deg",
    "spherical": "designation: 22208, clearance: 0",
}


def model(kind, axis="[0, 0, 1]", more=""):
    bearing = f"rolling_bearings: {{a: {{body: rotor, {KINDS[kind]}}}}}\n"
    return loads_model(MODEL.replace("AXIS", axis) + bearing + more)


def profile(kind, xi, length, diameter):
    """P at one position by the cases of the standard: short and long cylindrical rollers, tapered rollers."""
    if "tapered" in kind:
        return 0.00045 * diameter * math.log(1.0 / (1.0 - (2.0 * xi / length) ** 2))
    if length <= 2.5 * diameter:
        return 0.00035 * diameter * math.log(1.0 / (1.0 - (2.0 * xi / length) ** 2))
    flat = length - 2.5 * diameter
    if abs(xi) <= 0.5 * flat:
        return 0.0
    return 0.0005 * diameter * math.log(1.0 / (1.0 - ((2.0 * abs(xi) - flat) / (2.5 * diameter)) ** 2))


def two_contacts(d, tilt, xi, gap, one):
    """Force and moment about its middle of a roller between rings with the approach d and the tilt [N, N m].

    The unknowns are displacement and tilt of the roller towards the outer ring, over d and over 1e-4; the
    first guess is off the solution. `one` is the constant of one contact.
    """
    if np.max(d + xi * tilt - 2.0 * gap) <= 0.0:
        return 0.0, 0.0

    def loads(place):
        outer = place[0] * abs(d) + xi * place[1] * 1e-4 - gap
        inner = d - place[0] * abs(d) + xi * (tilt - place[1] * 1e-4) - gap
        return (one / len(xi) * np.maximum(depth, 0.0) ** LINE for depth in (inner, outer))

    def unbalance(place):
        inner, outer = loads(place)
        return np.sum(inner - outer), np.sum(xi * (inner - outer)) / xi[-1]

    inner, outer = loads(root(unbalance, (0.5, 0.4e4 * tilt), tol=1e-13).x)
    assert np.sum(outer) == pytest.approx(np.sum(inner), rel=1e-7)
    return np.sum(inner), np.sum(xi * inner)


def bearing_forces(kind, geometry, shift, place):
    """Forces [N] and moments [N m] of all rollers on the inner ring at x, y, z and small tilts about x, y."""
    x, y, z, rx, ry = place
    length, diameter = geometry.effective_length, geometry.element_diameter
    xi = length * ((np.arange(21) + 0.5) / 21 - 0.5)
    gap = np.array([profile(kind, at, length, diameter) for at in xi])
    total = np.zeros(5)
    for k in range(geometry.rows * geometry.elements):
        psi = 2.0 * math.pi * k / (geometry.rows * geometry.elements)
        angle = geometry.contact_angle * (1 if geometry.rows == 1 or k % 2 == 0 else -1)
        c, s = math.cos(angle), math.sin(angle)
        out, across = np.array([math.cos(psi), math.sin(psi)]), np.array([-math.sin(psi), math.cos(psi)])
        tilt, lever = across @ (rx, ry), 0.5 * geometry.pitch_diameter
        if kind == "spherical":  # the raceway of the outer ring has its centre on the axis
            tilt = lever = 0.0
        d = (out @ (x, y) - 0.5 * geometry.clearance) * c + (z + shift - lever * tilt) * s
        force, moment = two_contacts(d, tilt, xi, gap, roller_stiffness(length, STEEL))
        total[:2] -= force * c * out
        total[2] -= force * s
        total[3:] += (lever * s * force - (kind != "spherical") * moment) * across
    return total


@pytest.mark.parametrize("kind", KINDS)
def test_forces_are_those_of_both_contacts(kind):
    system = compile_model(model(kind))
    geometry = system.model.rolling_bearings["a"].geometry
    record = system.records["rolling_bearing"][0]
    state = system.initial_state()
    for place in (
        (6e-6, 2e-6, 0.0, 0.0, 0.0),
        (4e-6, -9e-6, 6e-6, 4e-4, -7e-4),
        (-12e-6, 3e-6, -3e-6, -3e-5, 1e-4),
    ):
        state.q[:5] = place
        found = -evaluate.residual(system, state)[:5]
        wanted = bearing_forces(kind, geometry, float(record["shift"]), place)
        assert np.abs(wanted[:2]).max() > 50.0
        most = np.abs(wanted[:3]).max()
        np.testing.assert_allclose(found[:3], wanted[:3], atol=2e-5 * most)
        np.testing.assert_allclose(  # 1 nm: where the forces act on the moved ring
            found[3:], wanted[3:], atol=2e-5 * np.abs(wanted[3:]).max() + 1e-9 * most
        )


@pytest.mark.parametrize(
    ("size", "tapered"), [((10e-3, 10e-3), False), ((50e-3, 10e-3), False), ((30e-3, 10e-3), True)]
)
def test_a_heavy_load_loses_the_mean_profile_of_both_contacts(size, tapered):
    """d = (Q/K)^0.9 + 2 mean(P), where the ends carry as well; mean of ln(1/(1 - u^2)) over 0..1: 2 - 2 ln 2.

    Long rollers have the profile on 2.5 D_we of their length. Tapered ones may be as long as they like.
    """
    length, diameter = size
    row = Raceways(1, 1e9, LINE, 0.5 * math.pi, slices=roller_slices(*size, 4000, tapered=tapered))
    mean = {10e-3: 0.00035, 30e-3: 0.00045, 50e-3: 0.0005 * 2.5 * diameter / length}[length]
    mean *= diameter * (2.0 - 2.0 * math.log(2.0))
    force = 1e9 * 2e-3**LINE
    assert row.shift_for(force) - 2e-3 == pytest.approx(2.0 * mean, rel=2e-3)


def test_a_light_load_is_that_of_a_parabola():
    """2 P is 0.0007 D_we (2 xi/L)^2 near the middle: Q = K d^p sqrt(d/(0.0007 D_we)) B(1/2, p + 1)/2."""
    slices = roller_slices(10e-3, 10e-3, 20001)
    row = Raceways(1, 1e9, LINE, 0.5 * math.pi, slices=slices)
    d = 10e-9
    reach = math.sqrt(d / 7e-6)
    assert row.thrust(d) == pytest.approx(1e9 * d**LINE * reach * 0.5 * beta(0.5, LINE + 1.0), rel=1e-3)


@pytest.mark.parametrize("axis", ["[0, 0, 1]", "[0, 1, 0]"])
def test_deflection_of_a_cylindrical_roller_bearing(axis):
    """NU 208 ECP, a roller under the load: equilibrium with both contacts; docs/bearings.md prints it."""
    page = PAGE.read_text("utf-8")
    held = "bearings: {turning: {body: rotor, stiffness: {torsion: 100, axial: 1e6, tilt: 1e5}}}\n"
    found = []
    for load in (1, 3, 10):
        push = f"loads: {{push: {{body: rotor, force: [{load} kN, 0, 0], along: world}}}}\n"
        system = compile_model(model("cylindrical", axis, held + push))
        geometry = system.model.rolling_bearings["a"].geometry
        found.append(solve_equilibrium(system)["displacement[rotor.x]"].item())

        def excess(x, geometry=geometry, load=load):
            return bearing_forces("cylindrical", geometry, 0.0, (x, 0.0, 0.0, 0.0, 0.0))[0] + 1e3 * load

        assert found[-1] == pytest.approx(brentq(excess, 1e-6, 1e-4), rel=1e-4)
    assert "{:.2f}, {:.2f} and {:.2f} µm".format(*(1e6 * x for x in found)) in page


def test_the_profile_of_the_standard():
    """All three cases at positions along the roller, symmetric; 0 in the middle."""
    for kind, length, diameter in (("short", 10e-3, 8e-3), ("long", 30e-3, 4e-3), ("tapered", 30e-3, 9e-3)):
        xi = length * np.linspace(-0.49, 0.49, 41)
        wanted = [profile(kind, at, length, diameter) for at in xi]
        found = roller_profile(xi, length, diameter, tapered=kind == "tapered")
        np.testing.assert_allclose(found, wanted, rtol=1e-12, atol=1e-20)
        assert found[20] == 0.0
        assert np.all(np.diff(found[20:]) >= 0.0)
        np.testing.assert_array_equal(roller_slices(length, diameter, 9)[4], 0.0)
