# SPDX-License-Identifier: Apache-2.0
"""Cantilevers with full section matrices: model text, and independent solutions of the exact beam equations.

The reference integrates the geometrically exact beam, D. H. Hodges, Nonlinear Composite Beam Theory (2006):
dr/ds = R (gamma + e_z), dR/ds = R kappa~, (gamma, kappa) = K^-1 (R'F, R'M), dF/ds = -f, dM/ds = -r' x F - m.
"""

from __future__ import annotations

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.optimize import brentq, root

#: Composite box beam of Wang et al. (2017), in inches and pounds, in our order: theirs has the
#: beam along axis 1, so axes 1, 2 and the beam are theirs 2, 3 and 1. A bending-torsion coupling of 0.56 of
#: the geometric mean.
_ORDER = [1, 2, 0, 4, 5, 3]
BOX = np.diag([1368.17, 88.56, 38.78, 16.96, 59.12, 141.47])
BOX[3, 4] = BOX[4, 3] = 17.61
BOX[3, 5] = BOX[5, 3] = -0.351
BOX[4, 5] = BOX[5, 4] = -0.37
BOX = 1e3 * BOX[np.ix_(_ORDER, _ORDER)]
BOX_MASS = np.diag([0.08538, 0.08538, 0.08538, 0.014433, 0.0040972, 0.010336])[np.ix_(_ORDER, _ORDER)]
BOX_LENGTH = 10.0

TEXT = """\
bodies:
  hub: {mass: 1 kg, inertia_tensor: [1, 1, 1, 0, 0, 0], position: [0, 0, 0]}
  tip: {mass: 1e-9 kg, inertia_tensor: [1e-9, 1e-9, 1e-9, 0, 0, 0], position: [0, 0, END]}
joints:
  shaft: {type: revolute, bodies: [ground, hub], axes: {z: [1, 0, 0], x: [0, 1, 0]}}
  free: {type: free, bodies: [hub, tip]}
beams:
  blade:
    ends: [hub, tip]
    axis: [1, 0, 0]
    pieces: PIECES
    properties: {position: [0, 1], PROPERTIES}
loads: {pull: {body: tip, force: FORCE}}
"""


def matrices(stiffness, inertia):
    """Lists of a beam with the same section from end to end."""
    return f"stiffness: {2 * [stiffness.tolist()]}, inertia: {2 * [inertia.tolist()]}"


def cantilever_text(properties, length, pieces, force=(0.0, 0.0, 0.0)):
    """Text of a model: a beam along z on a hub that can turn about x."""
    text = TEXT.replace("PROPERTIES", properties).replace("END", repr(length))
    return text.replace("PIECES", str(pieces)).replace("FORCE", str(list(force)))


def _tilde(v):
    return np.array([[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]])


def exact_tip(stiffness, length, force=(0.0, 0.0, 0.0), inertia=None, speed=0.0):
    """Displacement and rotation matrix of the tip of a cantilever under a dead force, turning about x."""
    soft, M = np.linalg.inv(stiffness), np.zeros((6, 6)) if inertia is None else inertia
    m, J = M[0, 0], M[3:, 3:]
    place = np.array([M[1, 5], -M[0, 5], 0.0]) / m if m > 0.0 else np.zeros(3)
    omega, force = np.array([speed, 0.0, 0.0]), np.asarray(force, float)

    def rates(s, y):
        r, R, F, moment = y[:3], y[3:12].reshape(3, 3), y[12:15], y[15:]
        strain = soft @ np.r_[R.T @ F, R.T @ moment]
        way = R @ np.add(strain[:3], (0.0, 0.0, 1.0))
        arm, about = R @ place, R @ J @ R.T @ omega
        f = -m * np.cross(omega, np.cross(omega, r + arm))
        t = -np.cross(omega, about) - m * np.cross(arm, np.cross(omega, np.cross(omega, r)))
        return np.r_[way, (R @ _tilde(strain[3:])).ravel(), -f, -np.cross(way, F) - t]

    def end(root_load):
        start = np.r_[np.zeros(3), np.eye(3).ravel(), root_load]
        return solve_ivp(rates, (0.0, length), start, rtol=1e-9, atol=1e-12).y[:, -1]

    guess = np.r_[force, np.cross([0.0, 0.0, length], force)]
    guess[2] += 0.5 * m * speed**2 * length**2
    found = root(lambda x: end(x)[12:] - np.r_[force, 0.0, 0.0, 0.0], guess, tol=1e-10)
    assert found.success
    last = end(found.x)
    return last[:3] - [0.0, 0.0, length], last[3:12].reshape(3, 3)


def exact_frequencies(stiffness, inertia, length, near):
    """Natural frequencies of a clamped uniform beam next to given ones [Hz], from its transfer matrix."""
    kinematics = np.zeros((6, 6))
    kinematics[0, 4], kinematics[1, 3] = 1.0, -1.0
    size = np.sqrt(np.diag(stiffness))

    def end(f):
        mass = -((2.0 * np.pi * f) ** 2) * inertia
        rates = np.block([[kinematics, np.linalg.inv(stiffness)], [mass, -kinematics.T]])
        scale = np.r_[1.0 / size, size]
        whole = expm(length * rates * (scale[None, :] / scale[:, None]))
        sign, log = np.linalg.slogdet(whole[6:, 6:])
        return sign * np.exp(log)

    return np.array([brentq(end, 0.99 * f, 1.01 * f, xtol=1e-12 * f) for f in near])
