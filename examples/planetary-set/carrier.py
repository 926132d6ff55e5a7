# SPDX-License-Identifier: Apache-2.0
"""Matrices of the carrier of `elastic_carrier.yaml` from finite elements; requires scikit-fem.

Usage: ``python carrier.py carrier.npz``. Two walls of 20 mm are joined by three webs. The pins, beams of
40 mm diameter, are held rigidly in the walls. Kept are the middle of each pin, both bores, and some points
of the walls for the modes and the picture.
"""

from __future__ import annotations

import math
import sys

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import block_diag, csc_array, hstack, identity, vstack
from scipy.sparse.linalg import splu

from pitchpoint.multibody.beam_section import Beam, tube
from pitchpoint.multibody.structure import Structure, beam_line, make_structure

E, NU, DENSITY = 2.1e11, 0.3, 7850.0  # steel [Pa, -, kg/m^3]
HALF, WALL = 22.5e-3, 20e-3  # half of the distance of the walls, their thickness [m]
BORE, PIN = 60e-3, 40e-3  # diameters of the bores of the walls and of the pins [m]
ARM = 90e-3  # distance of the pins from the axis [m]
RADII = 1e-3 * np.array([30, 52, 75, 90, 105, 115])
CELL = math.radians(12.0)
TURN = CELL * np.arange(30)
WEB = 75e-3, math.radians(12.0)  # inner radius [m], half of the angle

Array = NDArray[np.float64]


def solid() -> tuple[csc_array, csc_array, Array, NDArray[np.int64]]:
    """Stiffness and mass of walls and webs, place and direction of every displacement."""
    from skfem import Basis, BilinearForm, ElementHex2, ElementVector, MeshHex
    from skfem.helpers import dot
    from skfem.models.elasticity import lame_parameters, linear_elasticity

    heights = np.array([-HALF - WALL, -HALF, 0.0, HALF, HALF + WALL])
    number = np.arange(len(RADII) * len(TURN) * len(heights)).reshape(len(RADII), len(TURN), len(heights))
    r, turn, z = np.meshgrid(RADII, TURN, heights, indexing="ij")
    cells = []
    for i in range(len(RADII) - 1):
        for j in range(len(TURN)):
            # webs are half-way between the pins, at 60, 180 and 300 deg
            aside = abs(math.remainder(TURN[j] + 0.5 * CELL - math.pi / 3.0, math.tau / 3.0))
            web = WEB[0] <= RADII[i] and aside < WEB[1]
            for k in (0, 1, 2, 3) if web else (0, 3):
                corners = [(a, b, c) for a in (0, 1) for b in (0, 1) for c in (0, 1)]
                cells.append([number[i + a, (j + b) % len(TURN), k + c] for a, b, c in corners])
    used, renumbered = np.unique(np.array(cells), return_inverse=True)
    points = np.stack([r * np.cos(turn), r * np.sin(turn), z]).reshape(3, -1)[:, used]
    # order of the corners of a hexahedron of scikit-fem
    order = [0, 1, 2, 4, 3, 5, 6, 7]
    mesh = MeshHex(np.ascontiguousarray(points), renumbered.reshape(-1, 8)[:, order].T)
    basis = Basis(mesh, ElementVector(ElementHex2()))
    mass = BilinearForm(lambda u, v, w: DENSITY * dot(u, v))
    K = linear_elasticity(*lame_parameters(E, NU)).assemble(basis)
    direction = np.zeros(basis.N, np.int64)
    for rows in (basis.nodal_dofs, basis.edge_dofs, basis.facet_dofs, basis.interior_dofs):
        direction[rows] = np.arange(len(rows))[:, None] % 3
    return csc_array(K), csc_array(mass.assemble(basis)), basis.doflocs.T, direction


def tie(places: Array, direction: NDArray[np.int64], rows: NDArray[np.int64], at: Array) -> Array:
    """Displacements of some rows by a rigid motion about a point (rows, 6)."""
    found = np.zeros((len(rows), 6))
    found[np.arange(len(rows)), direction[rows]] = 1.0
    for d in range(3):
        turned = np.cross(np.eye(3)[d], places[rows] - at)
        found[:, 3 + d] = turned[np.arange(len(rows)), direction[rows]]
    return found


def carrier() -> Structure:
    """The reduced carrier."""
    K, M, places, direction = solid()
    radius = np.hypot(places[:, 0], places[:, 1])
    walls = (places[:, 2] < -HALF + 1e-9, places[:, 2] > HALF - 1e-9)
    middles = np.array([(0.0, 0.0, s * (HALF + 0.5 * WALL)) for s in (-1.0, 1.0)])
    held = [(wall & (radius < 0.5 * BORE + 1e-6), at) for wall, at in zip(walls, middles, strict=True)]
    for k in range(3):
        x, y = ARM * math.cos(math.tau * k / 3), ARM * math.sin(math.tau * k / 3)
        inside = np.hypot(places[:, 0] - x, places[:, 1] - y) < 0.5 * PIN + 1e-6
        held += [(wall & inside, np.array((x, y, s * HALF))) for wall, s in zip(walls, (-1, 1), strict=True)]
    tied = np.zeros(len(places), bool)
    columns = []
    for mask, at in held:
        rows = np.flatnonzero(mask)
        tied[rows] = True
        block = np.zeros((len(places), 6))
        block[rows] = tie(places, direction, rows, at)
        columns.append(csc_array(block))
    free = np.flatnonzero(~tied)
    T = hstack([*columns, identity(len(places), format="csc")[:, free]]).tocsc()
    # beams of the pins: ends in the walls, and a node in the middle
    beam = Beam(section=tube(PIN), length=HALF, E=E, G=0.5 * E / (1.0 + NU), rho=DENSITY)
    pin = beam_line([beam, beam])
    size = T.shape[1]
    K, M = T.T @ K @ T, T.T @ M @ T
    K, M = (block_diag([matrix, csc_array((18, 18))], format="csc") for matrix in (K, M))
    for k in range(3):
        at = np.r_[12 + 12 * k : 18 + 12 * k, size + 6 * k : size + 6 * k + 6, 18 + 12 * k : 24 + 12 * k]
        place = csc_array((np.ones(18), (at, np.arange(18))), (size + 18, 18))
        K, M = K + place @ pin.K @ place.T, M + place @ pin.M @ place.T
    # keep both bores, the middles of the pins, and corners on the circumference of both walls
    ring = np.flatnonzero(np.isclose(radius[free], RADII[-1]) & (np.abs(places[free, 2]) > HALF + 0.9 * WALL))
    angle = np.degrees(np.arctan2(places[free[ring], 1], places[free[ring], 0]))
    corners = 48 + ring[np.abs((angle + 30.0) % 60.0 - 30.0) < 0.1]
    kept = np.r_[:12, size : size + 18, corners]
    spots = [*middles, *(0.5 * (held[2 + 2 * k][1] + held[3 + 2 * k][1]) for k in range(3))]
    return condensed(
        K.tocsc(), M.tocsc(), kept, spots, places[free[corners - 48]], direction[free[corners - 48]]
    )


def condensed(
    K: csc_array,
    M: csc_array,
    kept: NDArray[np.int64],
    spots: list[Array],
    corners: Array,
    direction: NDArray[np.int64],
) -> Structure:
    """Static condensation to the kept displacements."""
    rest = np.setdiff1d(np.arange(K.shape[0]), kept)
    symmetric = {"permc_spec": "MMD_AT_PLUS_A", "diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True}}
    shape = -splu(K[rest][:, rest].tocsc(), **symmetric).solve(K[rest][:, kept].toarray())
    T = vstack([identity(len(kept)), csc_array(shape)]).toarray()
    order = np.r_[kept, rest]
    K, M = K[order][:, order], M[order][:, order]
    places, inverse = np.unique(np.round(corners, 9), axis=0, return_inverse=True)
    node = np.r_[np.repeat(np.arange(5), 6), 5 + inverse.reshape(-1)]
    how = np.r_[np.tile(np.arange(6), 5), direction]
    K, M = (T.T @ (matrix @ T) for matrix in (K, M))
    return make_structure(0.5 * (K + K.T), 0.5 * (M + M.T), np.vstack([*spots, *places]), node, how)


def main() -> None:
    """Write the archive."""
    found = carrier()
    np.savez_compressed(
        sys.argv[1] if len(sys.argv) > 1 else "carrier.npz",
        K=found.K.toarray(),
        M=found.M.toarray(),
        places=found.places,
        node=found.node,
        direction=found.direction,
    )
    along = found.rigid()[:, 0]
    print(f"{found.size} displacements, {along @ (found.M @ along):.4g} kg")


if __name__ == "__main__":
    main()
