# SPDX-License-Identifier: Apache-2.0
"""What is left of a broken tooth is as stiff as it was: by the energy method, and by plane finite elements.

A force on the flank bends the tooth between its root and the point of contact; what stands above it is not
loaded. The energy method integrates up to there, so it cannot tell a stump from a tooth. In the plane the tip
holds the material around the contact together a little: linear elements over the true section of the tooth,
clamped at the root circle, those above the fracture taken away, say how much.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import pytest
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

from pitchpoint.contact.stiffness.tooth_compliance import fillet_section, section, tooth_compliance
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.tooth_form import tooth_form

E, NU = 206e9, 0.3
M_N = 3e-3
GEAR = CylindricalGear(z=21, m_n=M_N, b=20e-3)
STEEL = dict(beta=0.0, E=E, nu=NU, bore=None, body="rigid")


def rho_at(d):
    return np.sqrt(0.25 * d**2 - 0.25 * GEAR.d_b**2)


@pytest.mark.parametrize("broken", [0.2, 0.5, 0.9])
def test_the_energy_method_cannot_tell_a_stump_from_a_tooth(broken):
    """Bending, shear and compression at the same points of the flank, with and without the tip above them."""
    d_F = GEAR.d_Ff + 0.05 * (GEAR.d_a - GEAR.d_Ff)
    tip = GEAR.d_a - broken * (GEAR.d_a - d_F)
    rho = rho_at(np.linspace(d_F, tip - 0.02 * (tip - d_F), 40))
    whole = tooth_compliance(tooth_form(GEAR), rho, **STEEL)
    stump = tooth_compliance(tooth_form(GEAR.replace(tip_diameter=tip)), rho, **STEEL)
    np.testing.assert_allclose(stump.total, whole.total, rtol=1e-12)


ACROSS, ALONG = 32, 96
"""Elements over the thickness and the height."""


@lru_cache
def mesh():
    """Nodes at xi times the half thickness, xi in [-1, 1], in rows from the root up, shape (n, m, 2)."""
    form = tooth_form(GEAR)
    start = np.sqrt((form.r_Ff / form.r_b) ** 2 - 1.0)
    theta = np.linspace(form.fillet.theta_root, form.theta_form, 400)
    roll = np.linspace(start, rho_at(GEAR.d_a) / form.r_b, 800)
    x, eta = (
        np.concatenate(p) for p in zip(fillet_section(form, theta)[:2], section(form, roll)[:2], strict=True)
    )
    heights = np.linspace(0.0, eta[-1], ALONG + 1)
    half = np.interp(heights, eta, x)
    xi = np.linspace(-1.0, 1.0, ACROSS + 1)
    return np.stack([half[:, None] * xi, np.broadcast_to(heights[:, None], (ALONG + 1, ACROSS + 1))], axis=-1)


def element_stiffness(corners):
    """Plane-stress bilinear elements, 2 x 2 points, shape (e, 8, 8); corners (e, 4, 2) counter-clockwise."""
    D = E / (1.0 - NU**2) * np.array([[1.0, NU, 0.0], [NU, 1.0, 0.0], [0.0, 0.0, 0.5 * (1.0 - NU)]])
    K = np.zeros((len(corners), 8, 8))
    signs = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    for point in signs / np.sqrt(3.0):
        slopes = 0.25 * signs * (1.0 + signs[:, ::-1] * point[::-1])  # over the unit square, (4, 2)
        J = np.einsum("na,enk->eak", slopes, corners)
        d = np.einsum("eka,na->enk", np.linalg.inv(J), slopes)
        B = np.zeros((len(corners), 3, 8))
        B[:, 0, 0::2] = B[:, 2, 1::2] = d[..., 0]
        B[:, 1, 1::2] = B[:, 2, 0::2] = d[..., 1]
        K += np.linalg.det(J)[:, None, None] * np.einsum("eia,ij,ejb->eab", B, D, B)
    return K


def compliance(row, rows):
    """Way of a unit force per width on the flank, along the base tangent, of a tooth of so many rows."""
    nodes = mesh()
    m = ACROSS + 1
    i, j = np.meshgrid(np.arange(rows), np.arange(ACROSS), indexing="ij")
    corner = np.stack([i * m + j, i * m + j + 1, (i + 1) * m + j + 1, (i + 1) * m + j], -1).reshape(-1, 4)
    dofs = np.stack([2 * corner, 2 * corner + 1], axis=-1).reshape(-1, 8)
    K = element_stiffness(nodes.reshape(-1, 2)[corner])
    size = 2 * m * (rows + 1)
    where = np.broadcast_to(dofs[:, :, None], K.shape), np.broadcast_to(dofs[:, None, :], K.shape)
    whole = coo_matrix((K.ravel(), (where[0].ravel(), where[1].ravel())), shape=(size, size)).tocsc()
    free = np.arange(2 * m, size)
    load = np.zeros(size)
    force = direction(row)
    for node, share in ((row - 1, 0.25), (row, 0.5), (row + 1, 0.25)):
        load[2 * (node * m + ACROSS) : 2 * (node * m + ACROSS) + 2] = share * force
    way = splu(whole[free][:, free]).solve(load[free])
    return float(load[free] @ way)


def place(row):
    """Length of roll of a row of nodes on the flank [m]."""
    x, eta = mesh()[row, -1]
    form = tooth_form(GEAR)
    root = form.fillet_polar(form.fillet.theta_root)
    return np.sqrt((eta + root[0] * np.cos(root[1])) ** 2 + x**2 - form.r_b**2)


def direction(row):
    """Of a force on the flank: into the tooth, and towards the root."""
    form = tooth_form(GEAR)
    roll = place(row) / form.r_b
    angle = np.arctan(roll) - (form.psi_b - (roll - np.arctan(roll)))
    return np.array([-np.cos(angle), -np.sin(angle)])


def test_elements_give_the_compliance_of_the_energy_method():
    """Bending, shear and compression of both agree within a fifth where the load is high up: the beam has no
    dent at the load and no warped root."""
    row = int(0.85 * ALONG)
    beam = tooth_compliance(tooth_form(GEAR), place(row) + np.array([0.0, 1e-6]), **STEEL).total[0]
    assert compliance(row, ALONG) == pytest.approx(beam, rel=0.2)


@pytest.mark.parametrize(
    ("fracture", "below", "most"),
    [(0.9, 1.0, 5e-4), (0.9, 0.5, 1e-3), (0.7, 0.5, 1.5e-3), (0.9, 0.25, 1.5e-3), (0.7, 0.25, 1e-2)],
)
def test_a_stump_bends_like_the_whole_tooth(fracture, below, most):
    """How much softer a tooth broken at a share of its height is, so many modules below the fracture."""
    rows = round(fracture * ALONG)
    row = rows - round(below * M_N / mesh()[-1, 0, 1] * ALONG)
    whole, stump = compliance(row, ALONG), compliance(row, rows)
    assert 0.0 <= stump / whole - 1.0 < most
