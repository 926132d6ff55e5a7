# SPDX-License-Identifier: Apache-2.0
"""Compliance of whole gears: symmetry, definiteness, uniform loads, width, couplings, height functions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.polynomial.legendre import leggauss, legvander

from pitchpoint.contact.compliance.blank import Blank
from pitchpoint.contact.compliance.description import FlankCompliance
from pitchpoint.contact.compliance.foundation import foundation
from pitchpoint.contact.compliance.gear import COUPLINGS, flank_compliance, gear_slice
from pitchpoint.contact.compliance.heights import congruence, fitted
from pitchpoint.contact.compliance.plate import PlateTooth
from pitchpoint.contact.compliance.width import plane_means, plate_coupled, springs, wave_numbers
from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.materials import material

STEEL = material("steel")
GEARS = {
    "spur": CylindricalGear(z=43, m_n=1e-3, b=10e-3),
    "pinion": CylindricalGear(z=12, m_n=1e-3, x=0.4, b=14e-3),
    "helical": CylindricalGear(z=31, m_n=2e-3, beta=math.radians(20.0), x=0.2, b=30e-3),
    "large": CylindricalGear(z=250, m_n=1e-3, b=12e-3),
    "ring": CylindricalGear.internal(z=80, m_n=1e-3, x=-0.2, b=10e-3),
}


def middle(found):
    return 0.5 * sum(found.roll)


@pytest.mark.parametrize(
    "body, coupling",
    [
        ("weber_banaschek", "plate"),
        ("ring", "plate"),
        ("rigid", "plate"),
        ("ring", "springs"),
        ("ring", "none"),
    ],
)
@pytest.mark.parametrize("name", GEARS)
def test_symmetric_and_positive(name, body, coupling):
    """Any nodes on any number of teeth, by the worst of random lengths of roll on four teeth."""
    found = flank_compliance(GEARS[name], planes=6, body=body, coupling=coupling)
    own = found.own
    assert np.abs(own - own.transpose(1, 0, 3, 2)).max() <= 1e-12 * np.abs(own).max()
    random = np.random.default_rng(1)
    for _ in range(5):
        rho = random.uniform(*sorted(found.roll), size=(4, 6))
        C = found.matrix(rho, 4)
        assert C == pytest.approx(C.T, rel=1e-12, abs=1e-12 * np.abs(C).max())
        assert np.linalg.eigvalsh(C)[0] > -1e-12 * np.abs(C).max()


@pytest.mark.parametrize("name", GEARS)
def test_chain_of_coefficients_is_positive(name):
    """Stronger than any choice of nodes: all Legendre coefficients of six teeth."""
    found = flank_compliance(GEARS[name], planes=5, blank=Blank(), body="ring")
    n = found.planes * found.order
    own, after = (a.transpose(0, 2, 1, 3).reshape(n, n) for a in (found.own, found.beside))
    chain = np.kron(np.eye(6), own) + np.kron(np.eye(6, k=1), after) + np.kron(np.eye(6, k=-1), after.T)
    values = np.linalg.eigvalsh(chain)
    assert values[0] > -1e-12 * values[-1]


@pytest.mark.parametrize(
    "body, coupling", [("weber_banaschek", "plate"), ("ring", "plate"), ("ring", "springs")]
)
@pytest.mark.parametrize("name", GEARS)
def test_uniform_load_is_plane_strain(name, coupling, body):
    """On the whole face. Equal on all planes to 1e-10; the value up to the fit over the height."""
    gear = GEARS[name]
    found = flank_compliance(gear, planes=6, body=body, coupling=coupling)
    part = gear_slice(gear, body=body)
    rho = found.roll[0] + (found.roll[1] - found.roll[0]) * np.array([0.2, 0.5, 0.9])
    for r in rho:
        row = (found.matrix(np.full(6, r)) - found.windup).sum(axis=1) * gear.b / 6
        assert row == pytest.approx(np.full(6, row[0]), rel=1e-10)
        assert row[0] == pytest.approx(float(part.own(r, r)), rel=0.03)
    next_tooth = found.matrix(np.full((2, 6), rho[1]), 2)[:6, 6:] - found.windup
    expected = float(part.next(rho[1], rho[1]))
    scale = float(part.own(rho[1], rho[1]))
    assert next_tooth.sum(axis=1) * gear.b / 6 == pytest.approx(np.full(6, expected), abs=0.01 * scale)
    assert found.windup * gear.b == pytest.approx(part.common, rel=1e-12)


@pytest.mark.parametrize("name", GEARS)
def test_plate_under_uniform_load_is_the_slice(name):
    """Ritz's method has the exact deflections of the slice among its shapes: error of the quadrature."""
    gear = GEARS[name]
    part = gear_slice(gear, body="ring")
    plate = PlateTooth(part.tooth, STEEL, 4)
    length = gear.b / part.tooth.cos_beta
    ground = foundation(part.tooth, part.radii, STEEL, "ring", wave_numbers(6, length))
    own, following = plate_coupled(plate, ground, np.array([-1.0, 1.0]), length, 6)
    exact, next_exact = plate.uniform(part.ground)
    assert own[0, 0] * gear.b == pytest.approx(exact, abs=1e-4 * np.abs(exact).max())
    assert following[0, 0] * gear.b == pytest.approx(next_exact, abs=1e-4 * np.abs(exact).max())


def test_plate_coefficients_are_those_of_the_influence():
    """Projection by resultants against double quadrature of the influence."""
    part = gear_slice(GEARS["spur"], body="ring")
    t, w = leggauss(200)
    low, high = part.tooth.roll
    rho = 0.5 * (low + high) + 0.5 * (high - low) * t
    shape = legvander(t, 3) * (np.arange(4) + 0.5) * w[:, None]
    direct = shape.T @ part.own(rho[:, None], rho[None]) @ shape
    found = PlateTooth(part.tooth, STEEL, 4).uniform(part.ground)[0]
    assert found == pytest.approx(direct, abs=2e-5 * direct.max())


@pytest.mark.parametrize("share, expected", [(0.15, 9.00), (0.5, 13.00), (0.9, 30.64)])
def test_waves_along_the_face_against_finite_elements(share, expected):
    """Load varying as a cosine, 0.4 rad per module, displacement in um mm/N in the middle of a wide gear.

    Computed for this test with finite elements of order 3 in the section and a cosine along the axis, 20
    teeth, x = 0.2, bore r_f/1.4. Under a uniform load the three points give 11.77, 16.94 and 39.24.
    """
    gear = CylindricalGear(z=20, m_n=1e-3, x=0.2, b=10.0 * math.pi * 1e-3)
    planes = 64
    found = flank_compliance(gear, planes=planes, body="ring", blank=Blank(bore_diameter=gear.d_f / 1.4))
    rho = found.roll[0] + share * (found.roll[1] - found.roll[0])
    z = (np.arange(planes) + 0.5) / planes * gear.b
    wave = np.cos(400.0 * z)  # 2 waves: level at both end faces
    u = (found.matrix(np.full(planes, rho)) - found.windup) @ wave * gear.b / planes
    inner = slice(planes // 4, 3 * planes // 4)
    amplitude = float(u[inner] @ wave[inner] / (wave[inner] @ wave[inner]))
    assert 1e12 * amplitude == pytest.approx(expected, rel=0.07)


def test_planes_converge():
    """Displacement under a linear load at fixed positions; the error falls with the width of the planes."""
    gear, at = GEARS["spur"], np.array([-0.6, 0.0, 0.5])
    found = []
    for planes in (5, 10, 20, 40):
        C = flank_compliance(gear, planes=planes, body="ring")
        z = (np.arange(planes) + 0.5) / planes * 2.0 - 1.0
        u = C.matrix(np.full(planes, middle(C))) @ ((1.0 + z) / planes)
        found.append(np.interp(at, z, u))
    steps = np.abs(np.diff(found, axis=0)).max(axis=1) / np.max(found)
    assert steps[0] > 2.0 * steps[1] > 4.0 * steps[2]
    assert steps[2] < 1e-3


def test_wider_gears_are_stiffer():
    """Teeth beyond the common face width carry: uniform load on 10 mm, face 10, 12 and 20 mm."""
    mean = []
    for b in (10e-3, 12e-3, 20e-3):
        gear = GEARS["spur"].replace(b=b)
        C = flank_compliance(gear, planes=10, width=(-5e-3, 5e-3), body="ring")
        mean.append(float((C.matrix(np.full(10, middle(C))) - C.windup).mean()))
    assert np.all(np.diff(mean) < 0.0)
    assert mean[2] < 0.9 * mean[0]


def test_off_centre_width_is_mirrored():
    """The common width at either end of a wide gear: same planes in reverse order."""
    gear = GEARS["spur"].replace(b=20e-3)
    one, other = (flank_compliance(gear, planes=5, width=w) for w in ((-10e-3, -2e-3), (2e-3, 10e-3)))
    assert one.own == pytest.approx(other.own[::-1, ::-1], abs=1e-10 * one.own.max())


def test_coupling_spreads_the_load():
    """One loaded plane of ten: most of its displacement without coupling goes to its neighbours."""
    gear, rows = GEARS["spur"], {}
    for coupling in COUPLINGS:
        C = flank_compliance(gear, planes=10, coupling=coupling)
        rows[coupling] = (C.matrix(np.full(10, middle(C))) - C.windup)[:, 5]
    assert rows["none"][4] == 0.0
    assert 0.2 * rows["none"][5] < rows["plate"][5] < 0.5 * rows["none"][5]
    assert 0.2 * rows["none"][5] < rows["springs"][5] < 0.6 * rows["none"][5]
    assert np.all(np.diff(rows["plate"][:6]) > 0.0)


def test_springs():
    """The rule: slices C with springs 0.04 N² C between them."""
    n, C = 7, 3.0
    stiffness = np.diag(np.full(n, C))
    for i in range(n - 1):
        spring = 0.04 * n * n * 0.5 * (C + C)
        stiffness[np.ix_([i, i + 1], [i, i + 1])] += spring * np.array([[1.0, -1.0], [-1.0, 1.0]])
    assert springs(n) == pytest.approx(C * np.linalg.inv(stiffness), rel=1e-12)
    assert springs(n).sum(axis=1) == pytest.approx(np.ones(n), rel=1e-12)


def test_small_helix_angle_meets_the_spur_gear():
    spur, almost = (CylindricalGear(z=31, m_n=1e-3, beta=b, b=8e-3) for b in (0.0, 1e-5))
    one, other = (flank_compliance(g, planes=5, body="ring") for g in (spur, almost))
    assert other.own == pytest.approx(one.own, rel=1e-6, abs=1e-8 * one.own.max())
    assert other.beside == pytest.approx(one.beside, rel=1e-6, abs=1e-8 * one.own.max())
    assert other.windup == pytest.approx(one.windup, rel=1e-8)


@pytest.mark.parametrize(
    "z, blank, after, previous",
    [
        (43, Blank(bore_diameter=40.5e-3 / 1.4), 4.31, 4.67),
        (-60, Blank(rim_thickness=3.5e-3), 0.93, 1.57),
    ],
)
def test_next_and_previous_teeth_move_differently(z, blank, after, previous):
    """Loaded near the tip, observed near the root of the next and the previous tooth: finite elements."""
    gear = CylindricalGear(z=z, m_n=1e-3) if z > 0 else CylindricalGear.internal(z=-z, m_n=1e-3)
    part = gear_slice(gear, body="ring", blank=blank)
    low, high = part.tooth.roll
    root, tip = low + 0.1 * (high - low), low + 0.95 * (high - low)
    # the tooth before the loaded one has the force on its next tooth
    assert 1e12 * float(part.next(root, tip) + part.common) == pytest.approx(previous, abs=0.25)
    assert 1e12 * float(part.next(tip, root) + part.common) == pytest.approx(after, abs=0.25)
    assert part.next(root, tip) > part.next(tip, root)


def test_correction_factor():
    plain, measured = (flank_compliance(GEARS["spur"], planes=3, C_M=c) for c in (1.0, 0.8))
    assert measured.own == pytest.approx(plain.own / 0.8, rel=1e-14)
    assert measured.beside == pytest.approx(plain.beside / 0.8, rel=1e-14)
    assert measured.windup == pytest.approx(plain.windup / 0.8, rel=1e-14)
    assert (plain.provenance["C_M"], measured.provenance["C_M"]) == (1.0, 0.8)
    with pytest.raises(ModelError, match="C_M"):
        plain.scaled(0.0)


@pytest.mark.parametrize(
    "name, order, diagonal, rest",
    [
        ("spur", 4, 0.015, 0.12),
        ("spur", 6, 0.015, 0.07),
        ("pinion", 4, 0.015, 0.12),
        ("helical", 4, 0.02, 0.12),
        ("large", 4, 0.03, 0.14),
        ("ring", 4, 0.05, 0.20),
        ("ring", 6, 0.05, 0.09),
    ],
)
def test_polynomials_of_height_reproduce_the_influence(name, order, diagonal, rest):
    """Errors relative to √(C(t, t) C(t', t')) over −0.9 < t < 1: same height, and any two heights."""
    part = gear_slice(GEARS[name], body="ring")
    low, high = part.tooth.roll
    t, w = leggauss(24)
    rho = 0.5 * (low + high) + 0.5 * (high - low) * t
    C = fitted(t, w, part.own(rho[:, None], rho[None]), order)
    s = np.linspace(-0.9, 1.0, 39)
    rho = 0.5 * (low + high) + 0.5 * (high - low) * s
    exact, shape = part.own(rho[:, None], rho[None]), legvander(s, order - 1)
    size = np.sqrt(np.outer(exact.diagonal(), exact.diagonal()))
    error = np.abs(shape @ C @ shape.T - exact) / size
    assert error.diagonal().max() < diagonal
    assert error.max() < rest


def test_fit_falls_back_to_the_projection():
    """A kernel whose fit is not positive, and the congruence of positive matrices."""
    t, w = leggauss(20)
    C = fitted(t, w, np.exp(-40.0 * np.abs(t[:, None] - t)), 4)
    assert np.linalg.eigvalsh(C)[0] > 0.0
    random = np.random.default_rng(4)
    A, B = (m @ m.T + np.eye(4) for m in random.normal(size=(2, 4, 4)))
    T = congruence(A, B)
    assert T == pytest.approx(T.T, abs=1e-12)
    assert T @ A @ T == pytest.approx(B, abs=1e-10)


def test_plane_means():
    edges = np.linspace(-0.8, 1.0, 4)
    x, w = leggauss(12)
    for i in range(3):
        points = 0.5 * (edges[i] + edges[i + 1]) + 0.5 * (edges[i + 1] - edges[i]) * x
        expected = 0.5 * w @ legvander(points, 8)
        assert plane_means(edges, 9)[i] == pytest.approx(expected, abs=1e-14)


def test_scaling_with_the_module():
    """All lengths times k: compliance over 1/k, with the same proportions."""
    one = flank_compliance(GEARS["spur"], planes=4, body="ring")
    gear = CylindricalGear(z=43, m_n=5e-3, b=50e-3)
    five = flank_compliance(gear, planes=4, body="ring")
    assert five.own * 5.0 == pytest.approx(one.own, rel=1e-9, abs=1e-10 * one.own.max())
    assert five.windup * 5.0 == pytest.approx(one.windup, rel=1e-10)


def test_wrong_options_are_listed_together():
    gear = GEARS["spur"]
    with pytest.raises(ModelError) as failure:
        flank_compliance(gear, planes=0, order=True, coupling="glue", width=(-6e-3, 4e-3))
    text = str(failure.value)
    assert "4 problems" in text
    for part in ("planes: 0", "order: True", "plate, springs, none", "within ±5 mm"):
        assert part in text
    with pytest.raises(ModelError, match="width"):
        flank_compliance(gear, planes=3, width=(math.nan, 1e-3))


def test_description_checks_its_arrays():
    good = flank_compliance(GEARS["spur"], planes=2, coupling="none")
    own = good.own.copy()
    assert not good.own.flags.writeable and good.own.flags.c_contiguous and good.beside.flags.c_contiguous
    own[0, 1, 0, 1] += 0.1 * own.max()
    for changes, message in (
        ({"own": own}, "not symmetric"),
        ({"own": good.own[:1]}, "is not"),
        ({"own": np.full_like(own, np.nan)}, "not finite"),
        ({"roll": (1e-3, 1e-3)}, "roll"),
        ({"windup": -1.0}, "windup"),
        ({"windup": math.inf}, "windup"),
    ):
        fields = {name: getattr(good, name) for name in ("roll", "own", "beside", "windup", "provenance")}
        with pytest.raises(ModelError, match=message):
            FlankCompliance(**{**fields, **changes})
    with pytest.raises(TypeError):
        good.provenance["body"] = "other"
