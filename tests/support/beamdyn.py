# SPDX-License-Identifier: Apache-2.0
"""Files of BeamDyn with the blade of the NREL 5 MW, and a beam of full section matrices to compare with.

Data: NRELOffshrBsline5MW_BeamDyn.dat and NRELOffshrBsline5MW_BeamDyn_Blade.dat of OpenFAST/openfast_toolbox,
folder data/NREL5MW (Apache License 2.0). Their matrices are diagonal, with a tenth of the axial stiffness as
shear stiffness. Columns: place, initial twist [deg], axial stiffness [N], bending edgewise and flapwise,
torsion [N m^2], mass [kg/m], polar inertia [kg m].
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy.sparse import lil_matrix
from scipy.sparse.linalg import eigsh

LENGTH = 61.5
_TABLE = """
0 13.308 9.72948e+09 1.81136e+10 1.811e+10 5.5644e+09 678.935 1945.9
0.00325 13.308 9.72948e+09 1.81136e+10 1.811e+10 5.5644e+09 678.935 1945.9
0.01951 13.308 1.07895e+10 1.95586e+10 1.94249e+10 5.43159e+09 773.363 2157.9
0.03577 13.308 1.006723e+10 1.94978e+10 1.74559e+10 4.99398e+09 740.55 2013.45
0.05203 13.308 9.86778e+09 1.97888e+10 1.52874e+10 4.66659e+09 740.042 1973.56
0.06829 13.308 7.60786e+09 1.48585e+10 1.07824e+10 3.47471e+09 592.496 1521.57
0.08455 13.308 5.49126e+09 1.02206e+10 7.22972e+09 2.32354e+09 450.275 1098.25
0.10081 13.308 4.9713e+09 9.1447e+09 6.30954e+09 1.90787e+09 424.054 994.26
0.11707 13.308 4.49395e+09 8.06316e+09 5.52836e+09 1.57036e+09 400.638 898.79
0.13335 13.308 4.0348e+09 6.88444e+09 4.98006e+09 1.15826e+09 382.062 806.96
0.14959 13.308 4.03729e+09 7.00918e+09 4.93684e+09 1.00212e+09 399.655 807.46
0.16585 13.308 4.16972e+09 7.16768e+09 4.69166e+09 8.559e+08 426.321 833.94
0.18211 13.181 4.08235e+09 7.27166e+09 3.94946e+09 6.7227e+08 416.82 816.47
0.19837 12.848 4.08597e+09 7.0817e+09 3.38652e+09 5.4749e+08 406.186 817.19
0.21465 12.192 3.66834e+09 6.24453e+09 2.93374e+09 4.4884e+08 381.42 733.67
0.23089 11.561 3.14776e+09 5.04896e+09 2.56896e+09 3.3592e+08 352.822 629.55
0.24715 11.072 3.01158e+09 4.94849e+09 2.38865e+09 3.1135e+08 349.477 602.32
0.26341 10.792 2.88262e+09 4.80802e+09 2.27199e+09 2.9194e+08 346.538 576.52
0.29595 10.232 2.61397e+09 4.5014e+09 2.05005e+09 2.61e+08 339.333 522.79
0.32846 9.672 2.35748e+09 4.24407e+09 1.82825e+09 2.2882e+08 330.004 471.5
0.36098 9.11 2.14686e+09 3.99528e+09 1.58871e+09 2.0075e+08 321.99 429.37
0.3935 8.534 1.94409e+09 3.75076e+09 1.36193e+09 1.7438e+08 313.82 388.81
0.42602 7.932 1.6327e+09 3.44714e+09 1.10238e+09 1.4447e+08 294.734 326.54
0.45855 7.321 1.4324e+09 3.13907e+09 8.758e+08 1.1998e+08 287.12 286.48
0.49106 6.711 1.16876e+09 2.73424e+09 6.813e+08 8.119e+07 263.343 233.75
0.52358 6.122 1.04743e+09 2.55487e+09 5.3472e+08 6.909e+07 253.207 209.48
0.5561 5.546 9.2295e+08 2.33403e+09 4.089e+08 5.745e+07 241.666 184.59
0.58862 4.971 7.6082e+08 1.82873e+09 3.1454e+08 4.592e+07 220.638 152.16
0.62115 4.401 6.4803e+08 1.5841e+09 2.3863e+08 3.598e+07 200.293 129.6
0.65366 3.834 5.397e+08 1.32336e+09 1.7588e+08 2.744e+07 179.404 107.94
0.68618 3.332 5.3115e+08 1.18368e+09 1.2601e+08 2.09e+07 165.094 106.23
0.7187 2.89 4.6001e+08 1.02016e+09 1.0726e+08 1.854e+07 154.411 92
0.75122 2.503 3.7575e+08 7.9781e+08 9.088e+07 1.628e+07 138.935 75.15
0.78376 2.116 3.2889e+08 7.0961e+08 7.631e+07 1.453e+07 129.555 65.77
0.81626 1.73 2.4404e+08 5.1819e+08 6.105e+07 9070000 107.264 48.8
0.84878 1.342 2.116e+08 4.5487e+08 4.948e+07 8060000 98.776 42.32
0.8813 0.954 1.8152e+08 3.9512e+08 3.936e+07 7080000 90.248 36.3
0.89756 0.76 1.6025e+08 3.5372e+08 3.467e+07 6090000 83.001 32.05
0.91382 0.574 1.0923e+08 3.0473e+08 3.041e+07 5750000 72.906 21.84
0.93008 0.404 1.0008e+08 2.8142e+08 2.652e+07 5330000 68.772 20.02
0.93821 0.319 9.224e+07 2.6171e+08 2.384e+07 4940000 66.264 18.45
0.94636 0.253 6.323e+07 1.5881e+08 1.963e+07 4240000 59.34 12.65
0.95447 0.216 5.332e+07 1.3788e+08 1.6e+07 3660000 55.914 10.66
0.9626 0.178 4.453e+07 1.1879e+08 1.283e+07 3130000 52.484 8.9
0.97073 0.14 3.69e+07 1.0163e+08 1.008e+07 2640000 49.114 7.38
0.97886 0.101 2.992e+07 8.507e+07 7550000 2170000 45.818 5.99
0.98699 0.062 2.131e+07 6.426e+07 4600000 1580000 41.669 4.26
0.99512 0.023 4850000 6610000 250000 250000 11.453 0.98
1 0 3530000 5010000 170000 190000 10.319 0.7
"""
TABLE = np.array([row.split() for row in _TABLE.strip().splitlines()], dtype=float)


def matrices() -> tuple[np.ndarray, np.ndarray]:
    """Stiffness and mass matrices of the stations, shape (n, 6, 6)."""
    _, _, axial, edge, flap, torsion, mass, polar = TABLE.T
    stiffness, inertia = np.zeros((2, len(TABLE), 6, 6))
    for k, values in enumerate((0.1 * axial, 0.1 * axial, axial, edge, flap, torsion)):
        stiffness[:, k, k] = values
    for k, values in enumerate((mass, mass, mass, 0.5 * polar, 0.5 * polar, polar)):
        inertia[:, k, k] = values
    return stiffness, inertia


def axis_of(prebend: float = 0.0) -> np.ndarray:
    """Points of the axis with a quadratic prebend [m], shape (n, 3)."""
    place = TABLE[:, 0]
    return np.column_stack([prebend * place**2, np.zeros(place.size), LENGTH * place])


def write_beamdyn(
    folder: Path, stiffness: np.ndarray, mass: np.ndarray, axis: np.ndarray | None = None
) -> Path:
    """Primary file of BeamDyn and its blade file; the path of the primary one."""
    points = axis_of() if axis is None else axis
    lines = ["--- BeamDyn ---", "1 member_total", f"{len(points)} kp_total", f"1 {len(points)} of the member"]
    lines += ["kp_xr kp_yr kp_zr initial_twist", "(m) (m) (m) (deg)"]
    lines += [" ".join(map(repr, map(float, (*p, t)))) for p, t in zip(points, TABLE[:, 1], strict=True)]
    lines += ['"Blade.dat" BldFile - properties']
    (folder / "BeamDyn.dat").write_text("\n".join(lines), encoding="utf-8")
    arc = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
    lines = ["--- blade ---", f"{len(points)} station_total", "1 damp_type", "mu1 mu2 mu3 mu4 mu5 mu6"]
    lines += ["(-) (-) (-) (-) (-) (-)", "1.0E-03 1.0E-03 1.0E-03 0.0014 0.0022 0.0022"]
    for share, *both in zip(arc / arc[-1], stiffness, mass, strict=True):
        lines.append(f" {share:.17g}")
        for matrix in both:
            lines += [" ".join(f"{x:.10E}" for x in row) for row in matrix]
            lines.append("")
    (folder / "Blade.dat").write_text("\n".join(lines), encoding="utf-8")
    return folder / "BeamDyn.dat"


def frequencies(
    axis: np.ndarray, stiffness: np.ndarray, mass: np.ndarray, count: int = 6, elements: int = 300
) -> np.ndarray:
    """Natural frequencies of a clamped curved beam with full section matrices [Hz].

    Elements with linear displacements and rotations and one point of integration for the strains.
    """
    arc = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(axis, axis=0), axis=1))]
    share = arc / arc[-1]
    ends = np.linspace(0.0, 1.0, elements + 1)
    middle = 0.5 * (ends[1:] + ends[:-1])
    line = np.array([np.interp(ends, share, axis[:, c]) for c in range(3)]).T
    twist = -np.radians(np.interp(middle, share, TABLE[:, 1]))
    K, M = (lil_matrix((6 * elements + 6, 6 * elements + 6)) for _ in range(2))
    for e in range(elements):
        way = line[e + 1] - line[e]
        h = float(np.linalg.norm(way))
        x, y, z = way / h
        cross = np.array([[0, 0, x], [0, 0, y], [-x, -y, 0]])
        c, s = np.cos(twist[e]), np.sin(twist[e])
        turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        own = ((np.eye(3) + cross + cross @ cross / (1.0 + z)) @ turn).T
        both = np.kron(np.eye(4), own)
        strain = np.hstack([-np.eye(6), np.eye(6)]) / h
        for row, column, sign in ((0, 4, -1.0), (1, 3, 1.0)):
            strain[row, [column, 6 + column]] += 0.5 * sign
        one, two = (
            np.array([[np.interp(middle[e], share, m[:, i, j]) for j in range(6)] for i in range(6)])
            for m in (stiffness, mass)
        )
        at = np.ix_(np.arange(6 * e, 6 * e + 12), np.arange(6 * e, 6 * e + 12))
        K[at] += h * (strain @ both).T @ one @ strain @ both
        for xi in (0.5 - 0.5 / np.sqrt(3.0), 0.5 + 0.5 / np.sqrt(3.0)):
            shape = np.hstack([(1.0 - xi) * np.eye(6), xi * np.eye(6)]) @ both
            M[at] += 0.5 * h * shape.T @ two @ shape
    K, M = (m.tocsc()[6:, 6:] for m in (K, M))
    values = eigsh(K, k=count, M=M, sigma=0, which="LM", return_eigenvectors=False)
    return np.sqrt(np.sort(values)) / (2.0 * np.pi)
