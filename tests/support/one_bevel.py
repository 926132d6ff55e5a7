# SPDX-License-Identifier: Apache-2.0
"""One bevel mesh on two frames, called by itself: no tree, no solver."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any, ClassVar

import numpy as np

from pitchpoint.core.kernel import address
from pitchpoint.elements.bevel_mesh import entry
from pitchpoint.elements.mesh.bevel import record as layout
from pitchpoint.elements.mesh.bevel.exact_tangent import turning
from pitchpoint.elements.signal import Pool
from pitchpoint.geometry.bevel.cones import pitch_angles
from pitchpoint.geometry.bevel.gear import BevelGear
from pitchpoint.geometry.bevel.pair import BevelPair
from pitchpoint.multibody.channels import CTL, FRAME
from pitchpoint.system.rules.bevel_mesh import Placement, bevel_row, own_teeth
from pitchpoint.system.rules.mesh_laws import MeshLaws
from tests.support.mesh_alone import MeshAlone, rotation


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
class OneBevel(MeshAlone):
    """Record, frames and results of one bevel mesh; frames are public and may be moved freely."""

    kind: ClassVar[Any] = entry
    layout: ClassVar[Any] = layout

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

    def roll(self, pitches):
        """Turn both gears on by base pitches; the travel stays."""
        way = pitches * self.row["p_bt"]
        self.frames["phi"] += [way / self.row["r_b1"], -way / self.row["r_b2"]]
