# SPDX-License-Identifier: Apache-2.0
"""One mesh element on two frames, called by itself: no tree, no solver.

It is called by the entry that solvers call, so that tests need not compile it a second time.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from pitchpoint.core.kernel import address, invoke
from pitchpoint.core.status import OK
from pitchpoint.elements import gear_mesh_record as layout
from pitchpoint.elements.gear_mesh import entry
from pitchpoint.elements.mesh_apart import apart
from pitchpoint.geometry import CylindricalGear, GearPair
from pitchpoint.multibody.channels import CTL, FRAME
from pitchpoint.system.rules.gear_mesh import Placement, mesh_row
from pitchpoint.system.rules.mesh_laws import MeshLaws

OUT = {name: k for k, (name, _, _) in enumerate(layout.OUTPUTS)}


def rotation(axis, angle):
    """Rotation matrix about a unit vector (Rodrigues)."""
    a = np.asarray(axis, float)
    K = np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])
    return np.eye(3) + math.sin(angle) * K + (1 - math.cos(angle)) * K @ K


def make_pair(z1=25, z2=60, beta=0.3, m_n=3e-3, b=0.03, widening=2e-5, internal=False, **kw):
    """A pair whose centre distance is `widening` off the one without backlash (towards more backlash)."""
    g1 = CylindricalGear(z=z1, m_n=m_n, beta=beta, b=b, **kw)
    g2 = CylindricalGear(z=-z2 if internal else z2, m_n=m_n, beta=beta if internal else -beta, b=b, **kw)
    a = GearPair.from_profile_shifts(g1, g2).a_w
    return GearPair(g1, g2, a + widening)


@dataclass
class OneMesh:
    """Record, frames and results of one mesh; frames are public and may be moved freely."""

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
        self.rec["apart"] = address(apart)
        self.pool = np.concatenate([*self.kept, np.zeros(1)])
        self.rec["pool"] = self.pool.ctypes.data

    @property
    def row(self):
        return self.rec[0]

    def evaluate(self, frames=None, jac=0, ck=1.0, cd=0.0):
        """Wrenches on both bodies, shape (2, 6); observations and tangents stay in `out` and `kk`."""
        fr = (self.frames if frames is None else frames).copy()
        fr["F"] = 0.0
        self.kk[:] = 0.0
        self.out[:] = 0.0
        self.ctl["jac"], self.ctl["ck"], self.ctl["cd"] = jac, ck, cd
        self.ctl["fr"], self.ctl["nb"] = fr.ctypes.data, fr.size
        assert invoke(entry, self.ctl.ctypes.data, self.rec.ctypes.data, 1) == OK
        return fr["F"].copy()

    def get(self, name):
        return float(self.out[OUT[name]])

    def friction_torques(self):
        """Torques of friction on both gears about their axes."""
        first = layout.N_OUT + int(self.row["n_pair"])
        return self.out[first : first + 2].copy()

    def press(self, depth, flank=1, frames=None):
        """Turn gear 1 until the deflection is `depth` beyond the gap on a flank."""
        fr = self.frames if frames is None else frames
        for _ in range(3):
            self.evaluate(fr)
            aim = flank * (0.5 * self.row["gap"] + depth)
            fr["phi"][0] += (aim - self.get("deflection")) / self.row["r_b1"]
        self.evaluate(fr)

    def tangent(self):
        """Block tangent, shape (2, 6, 2, 6)."""
        return self.kk.reshape(2, 2, 6, 6).transpose(0, 2, 1, 3).copy()


def moved(frames, body, step):
    """Frames after a small world twist of one body; the spin part goes to phi."""
    fr = frames.copy()
    fr["r"][body] += step[:3]
    w = np.asarray(step[3:], float)
    n = fr["R"][body][:, 2].copy()
    spin = w @ n
    tilt = w - spin * n
    angle = np.linalg.norm(tilt)
    if angle > 0:
        fr["R"][body] = rotation(tilt / angle, angle) @ fr["R"][body]
    fr["phi"][body] += spin
    return fr
