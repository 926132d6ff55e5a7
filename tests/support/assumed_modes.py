# SPDX-License-Identifier: Apache-2.0
"""The onshore NREL 5 MW turbine at rest as in ElastoDyn: assumed modes of tower and blades, from kinematics.

Written from the theory in J. Jonkman, Dynamics Modeling and Loads Analysis of an Offshore Floating Wind
Turbine, NREL/TP-500-41958 (2007), appendix A: point masses in the middle of equal elements, deflections from
polynomials, shortening to second order, and nothing else. No code of the package is used. With polynomials of
increasing degree instead of the modes of the files it converges to beams without shear, from above.

Axes: x downwind, y to the left for a view downwind, z upward. Freedoms: tower fore-aft, then side to side;
yaw, drive train; flapwise, then edgewise modes of blades 1 to 3. The generator is locked and has no inertia.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.polynomial import Legendre, Polynomial

GRAVITY = 9.80665
HEIGHT, LENGTH, HUB_RADIUS = 87.6, 61.5, 1.5
SHAFT_HEIGHT, OVERHANG = 1.96256, -5.0191
NACELLE = np.array([1.9, 0.0, 1.75])
TILT, CONE = np.radians(5.0), np.radians(-2.5)
HUB_MASS, NACELLE_MASS = 56780.0, 240000.0
SHAFT_STIFFNESS, SHAFT_DAMPING = 8.67637e8, 6.215e6
ELASTODYN = ((0.0, 0.0, 2.60789e6 - NACELLE_MASS * 1.9**2), (115926.0, 0.0, 0.0))
"""Moments of inertia of nacelle and hub about their axes [kg m^2], as far as ElastoDyn has them."""
BLADE = {"BldFl1Sh": "BldFlDmp(1)", "BldFl2Sh": "BldFlDmp(2)", "BldEdgSh": "BldEdDmp(1)"}
TOWER = {
    "TwFAM1Sh": "TwrFADmp(1)",
    "TwFAM2Sh": "TwrFADmp(2)",
    "TwSSM1Sh": "TwrSSDmp(1)",
    "TwSSM2Sh": "TwrSSDmp(2)",
}
"""Mode shapes and their damping ratios in the files."""
_TINY = 1e-30


class Part:
    """Tower or blade: columns of its file at the middles of equal elements, modes in two directions."""

    def __init__(self, path: Path, names: Mapping[str, str], length: float, nodes: int, degree: int) -> None:
        words = [line.split() for line in path.read_text().splitlines() if line.strip()]
        start = next(i for i, line in enumerate(words) if line[0] in ("BlFract", "HtFract"))
        end = next(i for i in range(start + 2, len(words)) if words[i][0].startswith("---"))
        lines = [line for line in words[:start] + words[end:] if line[0][-1].isdigit()]
        value = {line[1]: float(line[0]) for line in lines}
        rows = np.array(words[start + 2 : end], dtype=float)
        self.x, self.step, self.length = (np.arange(nodes) + 0.5) / nodes, length / nodes, length
        column = {
            name: np.interp(self.x, rows[:, 0], row) for name, row in zip(words[start], rows.T, strict=True)
        }
        blade = "BlFract" in column
        self.mass = self.step * (value["AdjBlMs"] * column["BMassDen"] if blade else column["TMassDen"])
        stiffness = [column[name] for name in (("FlpStff", "EdgStff") if blade else ("TwFAStif", "TwSSStif"))]
        twist = np.radians(column["StrcTwst"]) if blade else 0.0 * self.x
        axes = np.array([[np.cos(twist), -np.sin(twist)], [np.sin(twist), np.cos(twist)]])
        self.K, self.C = np.zeros((0, 0)), np.zeros((0, 0))
        curved, places, slopes = [], [], []
        for way in (0, 1):
            own = [name for name in names if (name[2:4] in ("SS", "dE")) == bool(way)]
            if degree:
                shapes = [
                    Polynomial([0, 0, 1]) * Legendre.basis(n, [0, 1]).convert(kind=Polynomial)
                    for n in range(degree - 1)
                ]
                ratio = np.zeros(degree - 1)
            else:
                shapes = [Polynomial([0, 0, *(value[f"{name}({n})"] for n in range(2, 7))]) for name in own]
                ratio = np.array([0.01 * value[names[name]] for name in own])
            bent = np.array([shape.deriv(2)(self.x) for shape in shapes]) / length**2
            K = self.step * (bent * stiffness[way]) @ bent.T
            alone = np.sqrt(np.diag(K) / [(self.mass * shape(self.x) ** 2).sum() for shape in shapes])
            self.K, self.C = _joined(self.K, K), _joined(self.C, 2.0 * K * ratio / alone)
            curved += [b * axes[way] for b in bent]
            ends, none = np.r_[self.x, 1.0], np.zeros(nodes + 1)
            for shape in shapes:
                places.append([shape(ends), none] if way == 0 else [none, shape(ends)])
                slope = shape.deriv()(ends) / length
                slopes.append([slope, none] if way == 0 else [none, slope])
        # without twist the polynomials themselves, else the sums over the elements, as in ElastoDyn
        self.slope, self.place = np.array(slopes), np.array(places)
        if blade:
            self.slope = self.integral(np.array(curved))
            self.place = self.integral(self.slope[..., :-1])

    def integral(self, f: np.ndarray) -> np.ndarray:
        """Integral from the root to the nodes and to the end, over the last axis."""
        total = np.cumsum(f, axis=-1)
        return self.step * np.concatenate([total - 0.5 * f, total[..., -1:]], axis=-1)

    def line(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Places of nodes and end (..., n, 3), and slopes at the end (..., 2), of deflections (..., m)."""
        slope, aside = (np.tensordot(q, a, 1) for a in (self.slope, self.place))
        shorter = 0.5 * self.integral((slope**2).sum(axis=-2)[..., :-1])
        along = self.length * np.r_[self.x, 1.0] - shorter
        return np.stack([aside[..., 0, :], aside[..., 1, :], along], axis=-1), slope[..., -1]

    def at(self, q: np.ndarray, x: float) -> tuple[np.ndarray, np.ndarray]:
        """Place (3,) at a fraction of the length and axes of the section (3, 3), to first order in q."""
        points = np.r_[0.0, self.x, 1.0]
        values = np.array(
            [[np.interp(x, points, np.r_[0.0, f]) for f in one] for one in (*self.place, *self.slope)]
        )
        n = len(self.place)
        aside, slope = q @ values[:n], q @ values[n:]
        return np.array([*aside, x * self.length]), inclined(-slope[1], slope[0])


class Turbine:
    """Energies of the turbine at rest.

    Parameters
    ----------
    folder
        Of the files of ElastoDyn.
    gravity
        [m/s^2].
    nodes
        Of a blade and of the tower; 17 and 20 in OpenFAST.
    degree
        Of the polynomials in each direction; 0: the modes of the files.
    inertia
        Moments of inertia of nacelle and hub about their axes [kg m^2].
    """

    def __init__(
        self,
        folder: Path,
        gravity: float = GRAVITY,
        nodes: tuple[int, int] = (17, 20),
        degree: int = 0,
        inertia: tuple[tuple[float, ...], tuple[float, ...]] = ELASTODYN,
    ) -> None:
        self.blade = Part(folder / "NRELOffshrBsline5MW_Blade.dat", BLADE, LENGTH, nodes[0], degree)
        tower = folder / "NRELOffshrBsline5MW_Onshore_ElastoDyn_Tower.dat"
        self.tower = Part(tower, TOWER, HEIGHT, nodes[1], degree)
        self.gravity, self.inertia_moments = gravity, np.array(inertia)
        self.K, self.C = np.zeros((2, 0, 0))
        for part in ((self.tower.K, self.tower.C), *3 * [(self.blade.K, self.blade.C)]):
            self.K, self.C = _joined(self.K, part[0]), _joined(self.C, part[1])
            if len(self.K) == len(self.tower.K):
                self.yaw = len(self.K)
                self.K = _joined(self.K, np.diag([0.0, SHAFT_STIFFNESS]))
                self.C = _joined(self.C, np.diag([0.0, SHAFT_DAMPING]))
        self.mass = np.concatenate([self.tower.mass, [NACELLE_MASS, HUB_MASS], *3 * [self.blade.mass]])
        self.count = len(self.K)

    def top(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Places of the tower (..., n, 3) and the apex (..., 3), axes of nacelle, hub and section."""
        axis, slope = self.tower.line(q[..., : self.yaw])
        section = inclined(-slope[..., 1], slope[..., 0])
        nacelle = section @ turned(2, q[..., self.yaw])
        shaft = nacelle @ turned(1, TILT)
        apex = axis[..., -1, :] + nacelle @ [0.0, 0.0, SHAFT_HEIGHT] + shaft @ [OVERHANG, 0.0, 0.0]
        return axis, apex, nacelle, shaft @ turned(0, q[..., self.yaw + 1]), section

    def bent(self, q: np.ndarray, k: int) -> np.ndarray:
        """Coordinates of a blade."""
        first = self.yaw + 2 + k * len(self.blade.K)
        return q[..., first : first + len(self.blade.K)]

    def frames(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Places of all masses (..., n, 3), axes of nacelle and hub, for coordinates (..., count)."""
        axis, apex, nacelle, hub, _ = self.top(q)
        centre = axis[..., -1, :] + nacelle @ NACELLE
        places = [axis[..., :-1, :], centre[..., None, :], apex[..., None, :]]
        for k in range(3):
            line = self.blade.line(self.bent(q, k))[0][..., :-1, :] + [0.0, 0.0, HUB_RADIUS]
            places.append(apex[..., None, :] + line @ (hub @ ROOTS[k]).swapaxes(-1, -2))
        return np.concatenate(places, axis=-2), nacelle, hub

    def motion(self, name: str, place: np.ndarray) -> np.ndarray:
        """Displacements and rotations, shape (count, 6), of a body of the example, by its name and place."""
        found = np.zeros((self.count, 6))
        for j, q in enumerate(1j * _TINY * np.eye(self.count)):
            axis, apex, nacelle, hub, section = self.top(q)
            part, _, _ = name.partition(".")
            k = int(part[-1]) - 1 if part[-1].isdigit() else -1
            if k >= 0:
                out = np.linalg.norm(place - self.top(np.zeros(self.count))[1].real) - HUB_RADIUS
                point, turn = self.blade.at(self.bent(q, k), min(max(out / LENGTH, 0.0), 1.0))
                R = hub @ ROOTS[k] @ turn @ ROOTS[k].T
                r = apex + hub @ ROOTS[k] @ np.add(point, [0.0, 0.0, HUB_RADIUS])
            elif part == "tower":
                r, R = self.tower.at(q[: self.yaw], place[2] / HEIGHT)
            elif part == "hub":
                r, R = apex, hub @ turned(1, -TILT)
            else:
                R = section if part == "tower_top" else nacelle
                r = axis[-1] + R @ (place - [0.0, 0.0, HEIGHT])
            spin = R.imag / _TINY @ R.real.T
            found[j] = [*r.imag / _TINY, spin[2, 1], spin[0, 2], spin[1, 0]]
        return found

    def forces(self, q: np.ndarray) -> np.ndarray:
        """Derivatives of the potential energy of weight and bending, exact."""
        places, _, _ = self.frames(q + 1j * _TINY * np.eye(self.count))
        return self.gravity * (places[..., 2].imag / _TINY) @ self.mass + self.K @ q

    def stiffness(self, q: np.ndarray, step: float = 1e-4) -> np.ndarray:
        """Second derivatives of the potential energy."""
        steps = step * np.eye(self.count)
        return np.array([self.forces(q + s) - self.forces(q - s) for s in steps]) / (2.0 * step)

    def inertia(self, q: np.ndarray) -> np.ndarray:
        """Mass matrix."""
        places, *frames = self.frames(q + 1j * _TINY * np.eye(self.count))
        J = places.imag / _TINY
        M = np.einsum("ink,jnk,n->ij", J, J, self.mass)
        for moments, R in zip(self.inertia_moments, frames, strict=True):
            spin = R.real.swapaxes(-1, -2) @ (R.imag / _TINY)  # angular velocity about the own axes
            W = np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], axis=1)
            M += (W * moments) @ W.T
        return M

    def equilibrium(self) -> np.ndarray:
        """Coordinates under the weight."""
        q = np.zeros(self.count)
        K = self.stiffness(q)
        K[self.yaw, self.yaw] += 1e7  # yaw is free
        for _ in range(50):
            q = q - np.linalg.solve(K, force := self.forces(q))
            if np.abs(force).max() < 1e-3:
                return q
        raise AssertionError("no equilibrium")

    def modes(self, count: int = 14) -> tuple[np.ndarray, np.ndarray]:
        """Absolute values of the eigenvalues [Hz] and damping ratios, in order, without the free yaw."""
        q = self.equilibrium()
        n, M = self.count, self.inertia(q)
        rates = -np.linalg.solve(M, np.hstack([self.stiffness(q), self.C]))
        s = np.linalg.eigvals(np.vstack([np.eye(n, 2 * n, n), rates]))
        s = s[(s.imag > 0.0) & (np.abs(s) > 0.1)]
        s = s[np.argsort(np.abs(s))][:count]
        return np.abs(s) / (2.0 * np.pi), -s.real / np.abs(s)


def turned(axis: int, angle: complex | np.ndarray) -> np.ndarray:
    """Rotation about a coordinate axis, shape (..., 3, 3)."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R = np.zeros((*np.shape(angle), 3, 3), dtype=complex)
    R[..., axis, axis] = 1.0
    R[..., i, i] = R[..., j, j] = np.cos(angle)
    R[..., j, i] = np.sin(angle)
    R[..., i, j] = -np.sin(angle)
    return R


def inclined(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Rotation by a small vector (x, y, 0), shape (..., 3, 3)."""
    S = np.zeros((*np.shape(x), 3, 3), dtype=complex)
    S[..., 0, 2], S[..., 2, 0], S[..., 1, 2], S[..., 2, 1] = y, -y, -x, x
    return np.eye(3) + S + S @ S / 2.0 + S @ S @ S / 6.0 + S @ S @ S @ S / 24.0


def _joined(one: np.ndarray, two: np.ndarray) -> np.ndarray:
    """Block-diagonal matrix of two."""
    n = len(one)
    whole = np.zeros((n + len(two), n + len(two)))
    whole[:n, :n], whole[n:, n:] = one, two
    return whole


ROOTS = [turned(0, 2.0 * np.pi * k / 3.0) @ turned(1, CONE) for k in range(3)]
"""Axes of the blades in those of the hub, the third from the apex to the tip."""
