# SPDX-License-Identifier: Apache-2.0
"""Cylindrical pairs with flexible contact for whole contact analyses, and their equilibrium with friction."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.contact_analysis.solve import solve_contact


@dataclass(frozen=True, kw_only=True)
class Pair:
    """Pair in mm, N m and degrees; `keys`: more keys of both gears, `contact`: of the contact."""

    z: tuple[int, int]
    m: float
    b: float
    a: float | None = None
    x: tuple[float, float] = (0.0, 0.0)
    beta: float = 0.0
    keys: tuple[str, str] = ("", "")
    contact: str = ""
    mesh: str = ""

    def model(self):
        """Model of the pair."""
        gears = []
        for z, x, hand, more in zip(self.z, self.x, ("left", "right"), self.keys, strict=True):
            helix = f", helix_angle: {self.beta!r} deg, hand: {hand}" if self.beta else ""
            gears.append(
                f"{{number_of_teeth: {z}, normal_module: {self.m!r} mm, face_width: {self.b!r} mm, "
                f"profile_shift_coefficient: {x!r}{helix}{more}}}"
            )
        distance = "" if self.a is None else f", center_distance: {self.a!r} mm"
        return loads_model(
            f"gears:\n  g1: {gears[0]}\n  g2: {gears[1]}\n"
            f"meshes:\n  stage: {{gears: [g1, g2]{distance}, "
            f"contact: {{level: flexible{self.contact}}}{self.mesh}}}\n"
        )

    def analysed(self, torque, **options):
        """Contact analysis of the front flanks."""
        return solve_contact(self.model(), torque=torque, **options)


@dataclass(frozen=True)
class WithFriction:
    """Torques of both gears for Coulomb friction with the load shares of an analysis without friction.

    The friction of a pair acts at right angles to its normal force at the lengths of roll, and reverses at
    the pitch point: T_k = sum of F (r_bk -+ mu rho_k), minus on the path of approach.
    """

    data: object
    mu: float
    T1C: float

    def _arms(self, gear):
        shares = np.nan_to_num(self.data["plane_force"].values[0])
        shares = shares / shares.sum(axis=(1, 2), keepdims=True)
        rolls = [np.nan_to_num(self.data[f"roll_{k}"].values[0]) for k in (1, 2)]
        way = np.sign(rolls[0] - self.T1C)
        r_b = float(self.data["base_radius"].values[gear])
        return (shares * (r_b + self.mu * way * rolls[gear])).sum(axis=(1, 2))

    def normal_force(self, torque):
        """Normal force at each phase for a constant torque on gear 1 [N]."""
        return torque / self._arms(0)

    def output(self, torque):
        """Torque of gear 2 at each phase [N m]."""
        return self.normal_force(torque) * self._arms(1)
