# SPDX-License-Identifier: Apache-2.0
"""Harris map: peak-to-peak transmission error of spur gears over load and tip relief.

S. L. Harris, Proc. Inst. Mech. Eng. 172 (1958) 87-112: with constant pair stiffness k and 1 < eps_alpha < 2
the error F/k of one pair alternates with F/(2k) of two. A linear relief C from the ends of single contact,
eps_alpha - 1 base pitches long on both tips, leaves |F/k - C|/2, nothing at the design load F = k C. The
closed forms follow from two springs in parallel (`tests.support.relief_theory`). Tolerance 1e-9 of F/k.

Tip edges carry load before A and beyond E (`contact.tip_contact`), which the closed forms leave out. They
touch if the deflection exceeds the relief at the tip, so relief of at least F/k makes the whole curve exact;
with less relief the steps become ramps, but the extremes in single and double contact stay until the edges
of both neighbouring pairs carry over all of the single contact.
"""

from __future__ import annotations

import functools
import math

import numpy as np
import pytest

from pitchpoint.contact.tip_contact import tip_gap
from pitchpoint.elements.mesh.surface.nodes import ON_PATH
from pitchpoint.geometry.bisection import bisect
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from tests.support.relief_theory import Relief, best_relief, deflection, harris

K, FORCE = 3e8, 3000.0
SCALE = FORCE / K
POSITIONS = 90
"""Phases, with those where single contact begins and ends, and the middle of double contact."""


@functools.lru_cache
def flanks(amount=0.0, length=None, planes=1):
    """Pair 25/31, m 3 mm, b 20 mm, with equal tip reliefs [m], [base pitches]."""
    eps, p_bt = contact_ratio()
    length = eps - 1.0 if length is None else length
    relief = ""
    if amount:
        keys = f"amount: {amount!r} m, length: {length * p_bt!r} m"
        relief = f", modifications: {{both: {{tip_relief: {{{keys}}}}}}}"
    return FlankStates(model(relief, planes), "stage")


def model(relief="", planes=1):
    gear = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    return loads_model(f"""
gears:
  pinion: {{number_of_teeth: 25, {gear}{relief}}}
  wheel: {{number_of_teeth: 31, {gear}{relief}}}
meshes:
  stage:
    gears: [pinion, wheel]
    contact: {{level: rigid, stiffness: {K} N/m, planes: {planes}}}
""")


@functools.lru_cache
def contact_ratio():
    """eps_alpha and the base pitch."""
    pair = model().pairs["stage"]
    return pair.eps_alpha, math.pi * pair.gear1.d_b / 25


def phases():
    """Equidistant phases, the ends of single contact and the middle of double contact."""
    eps, _ = contact_ratio()
    return np.sort(np.append(np.arange(POSITIONS) / POSITIONS, [0.5 * (eps - 1.0), eps - 1.0]))


def solved(found, force):
    """Approach over the phases, and the share of the force on tip edges."""
    states = found.states(phases())
    states["by_force"], states["force"] = 1, force
    nodes = found.solve(states, keep_nodes=True)
    assert (states["status"] == 1).all()
    held = np.arange(nodes.shape[1]) < states["n_nodes"][:, None]
    edges = np.where(held & (nodes["place"] != ON_PATH), nodes["force"], 0.0).sum(axis=1)
    return states["x_0"].copy(), edges / force


def theory(force, amount=0.0, length=None):
    """Approach over the phases without contact of tip edges."""
    eps, _ = contact_ratio()
    relief = Relief(amount, eps - 1.0 if length is None else length)
    return np.array([deflection(s, force, K, eps, relief, relief) for s in phases()])


def test_no_error_at_the_design_load():
    """L* = (eps_alpha - 1) p_bt and C = F/k: constant transmission error without any tip edge in contact."""
    eps, _ = contact_ratio()
    length, amount = best_relief(eps, K, FORCE)
    x, edges = solved(flanks(amount, length), FORCE)
    assert np.ptp(x) / SCALE == pytest.approx(0.0, abs=1e-9)
    assert edges.max() == 0.0


@pytest.mark.parametrize("planes", [1, 7])
@pytest.mark.parametrize("share", [0.1, 0.5, 0.9, 1.0])
def test_enough_relief_makes_the_whole_curve_exact(share, planes):
    """Loads up to k C: no tip edge carries, and the error is that of springs at every phase."""
    force = share * FORCE
    x, edges = solved(flanks(SCALE, planes=planes), force)
    assert edges.max() == 0.0
    assert np.abs(x - theory(force, SCALE)).max() / SCALE == pytest.approx(0.0, abs=1e-9)
    assert np.ptp(x) / SCALE == pytest.approx(harris(force, K, SCALE) / SCALE, abs=1e-9)


@pytest.mark.parametrize("share", [1.2, 2.0, 3.0])
def test_overload_of_long_relief(share):
    """Tip edges carry, but the peak-to-peak error is still |F/k - C|/2."""
    force = share * FORCE
    x, edges = solved(flanks(SCALE), force)
    assert edges.max() > 0.01
    assert np.abs(x - theory(force, SCALE)).max() / SCALE > 0.01
    assert np.ptp(x) / SCALE == pytest.approx(harris(force, K, SCALE) / SCALE, abs=1e-9)


@pytest.mark.parametrize(("amount", "length"), [(0.0, 0.1), (2.0, 0.1), (1.0, 0.2), (3.0, 0.3)])
def test_none_or_short_relief(amount, length):
    """w/(2c'): relief over less than half of double contact leaves both levels, F/k and F/(2k)."""
    x, _ = solved(flanks(amount * SCALE, length), FORCE)
    assert np.ptp(x) / SCALE == pytest.approx(0.5, abs=1e-9)
    curve = theory(FORCE, amount * SCALE, length)
    assert np.ptp(curve) / SCALE == pytest.approx(0.5, abs=1e-9)


def edge_reach(force):
    """Path beyond E and before A over which sharp tip edges touch at the approach F/k [base pitches]."""
    pair = model().pairs["stage"]
    _, p_bt = contact_ratio()
    r = [0.5 * g.d_b for g in (pair.gear1, pair.gear2)]
    tip = [math.sqrt((0.5 * g.d_a) ** 2 - (0.5 * g.d_b) ** 2) for g in (pair.gear1, pair.gear2)]
    tan_a = math.tan(pair.alpha_wt)

    def reach(k):
        """Path of the edge of one gear, whose flank is half the approach ahead of the mean."""
        gap = force / K
        return (
            bisect(lambda eta: tip_gap(eta, r[k], r[1 - k], tip[k], tan_a)[0] - gap, 0.0, 0.5 * p_bt)
            - gap / 2
        )

    return (reach(0) + reach(1)) / p_bt


def test_tip_edges_over_all_of_single_contact():
    """Without relief the step F/(2k) stays until the edges of both neighbours span 2 - eps_alpha pitches."""
    eps, _ = contact_ratio()
    limit = bisect(lambda force: edge_reach(force) - (2.0 - eps), 1.0, 1e5)
    for share, held in ((0.5, True), (0.95, True), (1.05, False), (1.5, False)):
        force = share * limit
        states = flanks().states(np.linspace(eps - 1.0, 1.0, 2001))
        states["by_force"], states["force"] = 1, force
        flanks().solve(states)
        single = states["x_0"].max() * K / force
        assert (single == pytest.approx(1.0, abs=1e-9)) == held
        assert single > 0.5


@pytest.mark.parametrize("share", [0.5, 0.8, 1.0])
@pytest.mark.parametrize("steep", [1.2, 1.7])
def test_steeper_reliefs_of_equal_slope(steep, share):
    """Slope e, lengths that add up to L* + C/e: also |F/k - C|/2, with a shorter path of contact."""
    eps, _ = contact_ratio()
    slope = steep * SCALE / (eps - 1.0)
    length = 0.5 * (eps - 1.0 + SCALE / slope)
    x, _ = solved(flanks(slope * length, length), share * FORCE)
    assert np.ptp(x) / SCALE == pytest.approx(0.5 * abs(share - 1.0), abs=1e-9)


@pytest.mark.parametrize(("low", "high"), [(0.5, 1.0), (0.25, 1.5)])
def test_best_relief_of_a_range_of_torques(low, high):
    """C = (F1 + F2)/(2k) has the least maximum error over F1 to F2, (F2 - F1)/(4k)."""
    eps, _ = contact_ratio()
    forces = np.linspace(low, high, 6) * FORCE
    length, best = best_relief(eps, K, *map(float, forces))

    def worst(amount):
        found = flanks(float(amount), length)
        return max(float(np.ptp(solved(found, force)[0])) for force in forces) / SCALE

    assert worst(best) == pytest.approx(0.25 * (high - low), abs=1e-9)
    for factor in (0.9, 0.97, 1.03, 1.1):
        change = abs(factor - 1.0) * best / SCALE
        assert worst(factor * best) == pytest.approx(0.25 * (high - low) + 0.5 * change, abs=1e-9)
