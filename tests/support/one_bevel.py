# SPDX-License-Identifier: Apache-2.0
"""One bevel mesh on two frames, called by itself: no tree, no solver."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from types import SimpleNamespace

import numpy as np

from pitchpoint.core.kernel import address, invoke
from pitchpoint.core.status import OK
from pitchpoint.elements import bevel_mesh_record as layout
from pitchpoint.elements.bevel_mesh import entry
from pitchpoint.elements.bevel_mesh_turning import turning
from pitchpoint.elements.signal import Pool
from pitchpoint.geometry.bevel_gear import BevelGear
from pitchpoint.geometry.bevel_pair import BevelPair, pitch_angles
from pitchpoint.multibody.channels import CTL, FRAME
from pitchpoint.system.rules.bevel_mesh import Placement, bevel_row, own_teeth
from pitchpoint.system.rules.mesh_laws import MeshLaws
from tests.support.one_mesh import rotation

OUT = {name: k for k, (name, _, _) in enumerate(layout.OUTPUTS)}


def make_bevels(z1=20, z2=40, Sigma=0.5 * math.pi, beta=0.0, m_mn=2.5e-3, b=15e-3, thinner=2e-5, **kw):
    """A pair without profile shift whose teeth are thinner by `thinner` each."""
    cones = pitch_angles(z1, z2, Sigma)
    data = [(z1, cones[0], beta), (z2, cones[1], -beta)]
    gears = [
        BevelGear(z=z, m_mn=m_mn, delta=d, b=b, beta_m=s, thickness_allowance=-thinner, **kw)
        for z, d, s in data
    ]
    return BevelPair(*gears, Sigma)


@dataclass
class OneBevel:
    """Record, frames and results of one bevel mesh; frames are public and may be moved freely."""

    pair: BevelPair
    laws: MeshLaws
    sides: tuple = (1.0, 1.0)
    turn: tuple = (0.3, -0.7, 0.4)
    at: tuple = (0.02, -0.03, 0.05)
    apexes: tuple = (-0.04, 0.03)
    backlash: float | None = None
    faults: tuple = ({}, {})
    angles: tuple | None = None

    def __post_init__(self):
        whole = rotation((0, 0, 1), self.turn[0]) @ rotation((0, 1, 0), self.turn[1])
        tilt = whole @ rotation((1, 0, 0), self.pair.Sigma)
        self.axes = []
        for axes, side, spin in zip((whole, tilt), self.sides, (0.5, self.turn[2]), strict=True):
            flip = np.eye(3) if side > 0 else rotation((1, 0, 0), math.pi)
            self.axes.append(axes @ flip @ rotation((0, 0, 1), spin))
        place = Placement(axes1=self.axes[0], axes2=self.axes[1], apexes=self.apexes, sides=self.sides)
        if self.angles is not None:
            place = replace(place, angles=self.angles)
        self.rec = np.zeros(1, layout.RECORD)
        self.rec[0] = bevel_row(self.pair, place, self.laws, self.backlash)
        pool = Pool()
        shapes = (self.pair.gear1, self.pair.gear2)
        gears = [
            SimpleNamespace(geometry=g, number_of_teeth=g.z, faults=f)
            for g, f in zip(shapes, self.faults, strict=True)
        ]
        own_teeth(self.row, self.pair, gears, pool.add)
        self.pool = pool.array()
        self.rec["pool"] = self.pool.ctypes.data
        for name, value in zip(("i", "j", "ii", "ij", "ji", "jj"), (0, 1, 0, 1, 2, 3), strict=True):
            self.rec[name] = value
        self.rec["turning"] = address(turning)
        self.frames = np.zeros(2, FRAME)
        for k in range(2):
            self.frames["R"][k] = self.axes[k]
            self.frames["r"][k] = np.array(self.at) - self.apexes[k] * self.axes[k][:, 2]
        self.ctl = np.zeros(1, CTL)
        self.out = np.zeros(layout.N_OUT + int(self.row["n_pair"]) + 2 * int(self.row["rubs"]))
        self.events = np.zeros(len(layout.EVENTS))
        self.ctl["no"], self.ctl["ne"] = self.out.size, self.events.size
        self.ctl["out"], self.ctl["ev"] = self.out.ctypes.data, self.events.ctypes.data
        self.kk = np.zeros((4, 6, 6))
        self.ctl["kk"], self.ctl["np"] = self.kk.ctypes.data, len(self.kk)

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

    def press(self, depth, flank=1):
        """Turn gear 1 until the travel is `depth` beyond the gap on a flank, gears turned by equal travel."""
        for _ in range(3):
            self.evaluate()
            aim = flank * (0.5 * self.row["gap"] + depth)
            self.frames["phi"][0] += (aim - self.get("deflection")) / self.row["r_b1"]
        self.evaluate()

    def roll(self, pitches):
        """Turn both gears on by base pitches; the travel stays."""
        way = pitches * self.row["p_bt"]
        self.frames["phi"] += [way / self.row["r_b1"], -way / self.row["r_b2"]]

    def tangent(self):
        """Block tangent, shape (2, 6, 2, 6)."""
        return self.kk.reshape(2, 2, 6, 6).transpose(0, 2, 1, 3).copy()
