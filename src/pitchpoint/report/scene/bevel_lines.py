# SPDX-License-Identifier: Apache-2.0
"""Contact lines of bevel meshes over the frames of a scene: where they lie and what they carry.

What a record holds after it was evaluated is kept frame by frame; loads follow from it by the laws of the
mesh, elastic as those of cylindrical gears are. Along the face counts ζ = R_m ln(R/R_m): in it contact lines
are straight, x = x_0 ± tan β_b ζ, with the arc x = R_m σ from the pitch ray (docs/theory/bevel_mesh.md).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.elastic import low_load
from pitchpoint.contact.pair_shape import pair_shape
from pitchpoint.elements.mesh.bevel.record import N_OWN, PROFILE

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

_SIMPSON = np.array([1.0, 4.0, 2.0, 4.0, 2.0, 4.0, 2.0, 4.0, 1.0]) / 24.0
STATIONS = _SIMPSON.size
"""Places along a contact line at which its load is kept."""
_INSIDE = 1e-9
"""Part of a line that its first and last place are away from its ends, where loads may jump."""


def _plain(law: Any, count: int) -> np.ufunc:
    """A law of the core for whole arrays, without the compiler."""
    return np.frompyfunc(getattr(law, "py_func", law), count, 2 if law is low_load else 1)


_SHAPE, _LOW_LOAD = _plain(pair_shape, 4), _plain(low_load, 2)


class MeshLines:
    """What one mesh does over the frames.

    Parameters
    ----------
    record
        Its record in the system, shape (1,).
    n
        Number of frames.

    Attributes
    ----------
    forces, loads
        Of front and back flanks and slots, (n, 2, p) [N], and per width at the places, (n, 2, p, s) [N/m].
    travel
        Place of the line of pair 0 at R_m, (n, 2) [m].
    deflection
        Travel of the gears at R_m, (n,) [m].
    line
        Path from A to E and face in ζ [m], pressure angle and backlash, (n, 6).
    first
        The record in the first frame.
    """

    def __init__(self, record: NDArray[np.void], n: int) -> None:
        self.record = record
        self.pairs = int(record[0]["n_pair"])
        self.forces = np.zeros((n, 2, self.pairs))
        self.loads = np.zeros((n, 2, self.pairs, STATIONS))
        self.travel = np.zeros((n, 2))
        self.deflection = np.zeros(n)
        self.line = np.zeros((n, 6))
        self.first: Any = None


class BevelLines(MeshLines):
    """What one bevel mesh does over the frames; `pool` holds the tables of the records of its kind, (m,).

    Attributes
    ----------
    axes
        Across the pitch ray towards gear 2, along the tangent and along the ray, columns, (n, 3, 3).
    """

    def __init__(self, record: NDArray[np.void], n: int, pool: Array) -> None:
        super().__init__(record, n)
        self.pool = pool
        self.axes = np.zeros((n, 3, 3))
        self.displacement = np.zeros((n, 3))
        self.aside = np.zeros((n, 2))

    @property
    def cone(self) -> tuple[float, float]:
        """Mean cone distance [m] and pitch cone angle of gear 2 [rad], as in the first frame."""
        b = self.first
        now = b["now"]
        return float(b["R_m"]), math.acos(float(now["axis"][1] @ now["m"]))

    def placed(self, width: Array, path: Array, normal: Array) -> Array:
        """Places of the plane of action in the first frame, at ζ and x on the line of action `normal` [m]."""
        b, R_m = self.first, float(self.first["R_m"])
        R, sigma = R_m * np.exp(width / R_m), path / R_m
        along, across = R * np.cos(sigma) - R_m, R * np.sin(sigma)
        return np.asarray(b["now"]["P"] + along[..., None] * b["now"]["m"] + across[..., None] * normal)

    def look(self, frame: int) -> None:
        """Keep what the record holds of the flanks now."""
        b = self.record[0]
        now = b["now"]
        if frame == 0:
            self.first = self.record.copy()[0]
        R, p_bt = b["R_m"], b["p_bt"]
        ways = (b["xi_0"] + now["travel"], b["xi_b"] - now["travel"])
        for k, (side, way) in enumerate(zip((1, -1), ways, strict=True)):
            self.travel[frame, k] = now["xi_A"] + (now["start"][k] + side * now["turn"]) * p_bt + way
        self.deflection[frame] = now["u"]
        face = (R * math.log1p(b["z_lo"] / R), R * math.log1p(b["z_hi"] / R))
        path = (now["xi_A"], now["xi_A"] + now["eps"] * p_bt)
        self.line[frame] = (*path, *face, math.atan2(now["sin_a"], now["cos_a"]), now["gap"])
        self.axes[frame] = np.column_stack([now["e"], now["t"], now["m"]])
        self.displacement[frame] = self.axes[frame].T @ now["d"]
        self.aside[frame] = now["aside"]

    def close(self) -> None:
        """Loads of all frames, once they have been kept."""
        if self.first["source"] != PROFILE or self.pairs == 0:
            return
        for k, side in enumerate((1, -1)):
            self._carry(k, side)

    def _carry(self, k: int, side: int) -> None:
        """Forces and loads of the pairs of one flank."""
        b = self.first
        p_bt, R_m, slope = float(b["p_bt"]), float(b["R_m"]), side * float(b["tan_b"])
        start, end, low, high = self.line[:, :4].T
        ends = np.sort(slope * np.stack([low, high]), axis=0)
        number = np.ceil((self.travel[:, k] + ends[0] - end) / p_bt)
        for later in range(self.pairs):
            pair = number + later
            place = self.travel[:, k] - pair * p_bt
            first, last = low, high
            if slope != 0.0:
                cuts = np.sort(np.stack([start - place, end - place]) / slope, axis=0)
                first, last = np.maximum(low, cuts[0]), np.minimum(high, cuts[1])
            there = last > first
            if slope == 0.0:
                there &= (place >= start) & (place <= end)
            inner, outer, lacks = self._own(side, pair.astype(np.int64), first, last)
            zeta, loads = self._along(side, place, (first, last), lacks)
            loads *= (zeta >= inner[:, None]) & (zeta <= outer[:, None])
            # what is left of a broken tooth has ends between the places of the line
            zeta, left = self._along(side, place, (inner, np.maximum(inner, outer)), lacks)
            # the width of a piece of ζ is R / R_m as long
            force = side * np.maximum(outer - inner, 0.0) * ((left * np.exp(zeta / R_m)) @ _SIMPSON)
            rows = np.flatnonzero(there)
            slot = (pair.astype(np.int64) % self.pairs)[rows]
            self.loads[rows, k, slot] = loads[rows]
            self.forces[rows, k, slot] = force[rows]

    def _along(self, side: int, place: Array, face: tuple[Array, Array], lacks: Array) -> tuple[Array, Array]:
        """Places ζ between two ends of lines [m], and the loads there [N/m], shape (n, s) each."""
        b = self.first
        share = _INSIDE + (1.0 - 2.0 * _INSIDE) * np.linspace(0.0, 1.0, STATIONS)
        zeta = face[0][:, None] + (face[1] - face[0])[:, None] * share
        x = place[:, None] + side * float(b["tan_b"]) * zeta
        R_m = float(b["R_m"])
        return zeta, self._load(side, x, R_m * np.exp(zeta / R_m), lacks)

    def _own(self, side: int, pair: NDArray[np.int64], low: Array, high: Array) -> tuple[Array, Array, Array]:
        """Ends of the face in ζ, gap at R_m of the teeth of a pair [m], as the kernels read them."""
        b, lacks = self.first, np.zeros(pair.size)
        if b["n_sep"] == 0:
            return low, high, lacks
        R_m = float(b["R_m"])
        teeth = (b["t1_0"] - side * pair, b["t2_0"] + side * pair + (1 if side < 0 else 0))
        for gear, tooth in enumerate(teeth):
            n = int(b["n_t"][gear])
            if n > 0:
                start = int(b["teeth"][gear])
                table = self.pool[start : start + n * N_OWN].reshape(n, N_OWN)
                inner, outer, ahead = table[tooth % n].T
                low = np.maximum(low, R_m * np.log1p(inner / R_m))
                high = np.minimum(high, R_m * np.log1p(outer / R_m))
                lacks = lacks - side * ahead
        return low, high, lacks

    def _load(self, side: int, x: Array, R: Array, lacks: Array) -> Array:
        """Load per width along the base tangent at places of the plane of action, teeth with a gap [N/m]."""
        b = self.first
        tan, sigma = side * float(b["tan_b"]), x / float(b["R_m"])
        alpha = self.line[:, 4]
        towards, along, ray = self.displacement.T
        across = side * np.cos(alpha) * along + np.sin(alpha) * towards
        c, s = np.cos(sigma), np.sin(sigma)
        deep = c * (across - tan * ray)[:, None] - s * (ray + tan * across)[:, None]
        # what displaced apexes add to travel and backlash at the pitch point is in the first line
        turned = side * (self.deflection - self.aside[:, 0]) - 0.5 * (self.line[:, 5] - self.aside[:, 1])
        deep += R * ((turned - lacks) / float(b["R_m"]))[:, None]
        start, end = (self.line[:, i, None] for i in range(2))
        eps = (end - start) / float(b["p_bt"])
        p = np.clip((x - start) / float(b["p_bt"]), 0.0, eps)
        ramp = float(b["T_R"]) * (eps - np.floor(eps))
        elastic = np.maximum(deep, 0.0) * float(b["c_prime"]) * _SHAPE(p, eps, float(b["S_R"]), ramp)
        return np.asarray(elastic * _LOW_LOAD(elastic, float(b["load_limit"]))[0], np.float64)


def bevel_tooth_at(model: Model, gear: str, points: Array) -> int:
    """Number of the tooth that has a flank.

    Parameters
    ----------
    model
        The machine.
    gear
        Name of the gear.
    points
        Points of the flank in the frame of its body, over the face and along the path, shape (nz, nx, 3) [m].

    Notes
    -----
    On the pitch cone at R_m a flank is a quarter of a pitch next to the middle of its tooth, or nearly
    so.
    """
    part = model.bevel_gears[gear]
    shape = part.geometry
    apex = model.bodies[str(model.body_of(gear))].bevel_gears[gear]
    own = (points - np.array([0.0, 0.0, apex])) * np.array([1.0, part.direction, part.direction])
    R = np.linalg.norm(own, axis=-1)
    polar = np.arccos(own[..., 2] / R)
    near = np.unravel_index(
        np.argmin(np.abs(polar - shape.delta) + np.abs(np.log(R / shape.R_m))), polar.shape
    )
    x, y, _ = own[near]
    spiral = shape.spiral_rate * math.log(R[near] / shape.R_m)
    angle = math.atan2(y, x) - spiral - part.direction * model.bevel_angles[gear]
    return round(angle * shape.z / math.tau) % shape.z
