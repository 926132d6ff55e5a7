# SPDX-License-Identifier: Apache-2.0
"""One mesh element on two frames, called by itself: no tree, no solver.

It is called by the entry that solvers call, so that tests need not compile it a second time.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from pitchpoint.core.kernel import address
from pitchpoint.elements.gear_mesh import entry
from pitchpoint.elements.mesh import record as layout
from pitchpoint.elements.mesh.surface.flexible import flexible_flank
from pitchpoint.elements.mesh.surface.rigid import rigid_flank
from pitchpoint.elements.mesh.surface.tabulated import tabulated_flank
from pitchpoint.elements.mesh.tooth_pairs import deviating_line
from pitchpoint.geometry import CylindricalGear, GearPair
from pitchpoint.multibody.channels import CTL, FRAME
from pitchpoint.system.rules.gear_mesh import Placement, mesh_row
from pitchpoint.system.rules.mesh_laws import MeshLaws
from tests.support.mesh_alone import MeshAlone


def make_pair(z1=25, z2=60, beta=0.3, m_n=3e-3, b=0.03, widening=2e-5, internal=False, **kw):
    """A pair whose centre distance is `widening` off the one without backlash (towards more backlash)."""
    g1 = CylindricalGear(z=z1, m_n=m_n, beta=beta, b=b, **kw)
    g2 = CylindricalGear(z=-z2 if internal else z2, m_n=m_n, beta=beta if internal else -beta, b=b, **kw)
    a = GearPair.from_profile_shifts(g1, g2).a_w
    return GearPair(g1, g2, a + widening)


@dataclass
class OneMesh(MeshAlone):
    """Record, frames and results of one mesh; frames are public and may be moved freely."""

    kind: ClassVar[Any] = entry
    layout: ClassVar[Any] = layout

    pair: GearPair
    laws: MeshLaws
    theta: float = 0.3
    origin: tuple = (0.0, 0.0, 0.0)
    offset: float = 0.0
    fixed: bool = False
    backlash: float | None = None
    n_pair: int = 0
    kept: list = field(default_factory=list)

    def __post_init__(self):
        o1 = np.array(self.origin)
        o2 = o1 + abs(self.pair.a_w) * np.array([math.cos(self.theta), math.sin(self.theta), 0.0])
        o2[2] += self.offset
        internal = self.pair.a_w < 0
        towards = self.theta + (math.pi if internal else 0.0)
        phi2 = towards + (0.0 if internal else math.pi) - math.pi / self.pair.gear2.z
        slope = math.tan(self.pair.gear1.beta_b) * self.offset / (0.5 * self.pair.gear2.d_b)
        place = Placement(origin1=o1, origin2=o2, phi1=towards, phi2=phi2 - slope, fixed=self.fixed)
        self.rec = np.zeros(1, layout.RECORD)
        self.rec[0] = mesh_row(self.pair, place, self.laws, self._keep, self.backlash)
        for name, value in zip(("i", "j", "ii", "ij", "ji", "jj"), (0, 1, 0, 1, 2, 3), strict=True):
            self.rec[name] = value
        self.rec["n_pair"] = self.n_pair
        self.pool = np.concatenate([*self.kept, np.zeros(1)])
        self.rec["pool"] = self.pool.ctypes.data
        if self.row["is_rigid"]:
            self.rec["rigid"] = address(rigid_flank)
        if self.row["is_flexible"]:
            self.rec["flexible"] = address(flexible_flank)
        if self.row["is_tabulated"]:
            self.rec["tabulated"] = address(tabulated_flank)
        self.frames = np.zeros(2, FRAME)
        self.frames["r"] = o1, o2
        self.frames["R"] = np.eye(3)
        self.ctl = np.zeros(1, CTL)
        self.out = np.zeros(layout.N_OUT + self.n_pair + 2 * int(self.row["rubs"]))
        self.ctl["no"] = self.out.size
        self.ctl["out"] = self.out.ctypes.data
        self.kk = np.zeros((4, 6, 6))
        self.ctl["kk"], self.ctl["np"] = self.kk.ctypes.data, len(self.kk)

    def _keep(self, array):
        offset = sum(a.size for a in self.kept)
        self.kept.append(np.ravel(array))
        return offset

    def separate(self, grid1, grid2):
        """Give both gears grids of gaps [flank, tooth, width, roll] over their whole flanks."""
        self.own(gap=(grid1, grid2))

    def own(self, **layers):
        """Give teeth of both gears grids of their own, over their whole flanks.

        `gap`, `soft` and `level` are pairs of arrays [flank, tooth, width, roll], None for a gear without;
        gap and soft share their stations.
        """
        for gear in range(2):
            grids = {k: v[gear] for k, v in layers.items() if v[gear] is not None}
            n_t = next((g.shape[1] for g in grids.values()), 1)
            table = np.full((2, n_t, layout.N_ROW), -1.0)
            for stack, names in enumerate((("gap", "soft"), ("level",))):
                rows = []
                for layer, name in enumerate(names, start=2 * stack):
                    if name in grids:
                        table[:, :, layer] = len(rows) + np.arange(2 * n_t).reshape(2, n_t)
                        rows += list(grids[name].reshape(-1, *grids[name].shape[2:]))
                if rows:
                    self.rec["sep"][0, 2 * stack + gear] = self._keep(np.array(rows))
                    self.rec["n_sz"][0, 2 * stack + gear] = rows[0].shape[0]
                    self.rec["n_sx"][0, 2 * stack + gear] = rows[0].shape[1]
                    table[:, :, 3 + 2 * stack : 5 + 2 * stack] = 0, rows[0].shape[0] - 1
            self.rec["n_t"][0, gear], self.rec["teeth"][0, gear] = n_t, self._keep(table)
            reach = abs(float(self.row[f"rho_a{gear + 1}"]))
            self.rec["roll"][0, gear] = 0.3 * reach, 1.1 * reach
        self.rec["n_sep"] = self.rec["stride"] = 1
        self.rec["deviating"] = address(deviating_line)
        self.pool = np.concatenate([*self.kept, np.zeros(1)])
        self.rec["pool"] = self.pool.ctypes.data
