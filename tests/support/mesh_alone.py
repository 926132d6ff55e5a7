# SPDX-License-Identifier: Apache-2.0
"""What tests ask a mesh on two frames, called by itself: wrenches, observations, tangents, powers."""

from __future__ import annotations

import math
from typing import Any, ClassVar

import numpy as np

from pitchpoint.core.kernel import invoke
from pitchpoint.core.status import OK


class MeshAlone:
    """Record, frames and results of one mesh; subclasses make them and name the entry and what it shows."""

    kind: ClassVar[Any]
    layout: ClassVar[Any]

    @property
    def row(self):
        return self.rec[0]

    def evaluate(self, frames=None, jac=0, ck=1.0, cd=0.0):
        """Wrenches on both bodies, shape (2, 6); observations and tangents stay in `out` and `kk`."""
        status, wrenches = self.attempt(frames, jac, ck, cd)
        assert status == OK
        return wrenches

    def attempt(self, frames=None, jac=0, ck=1.0, cd=0.0):
        """Status, and wrenches as `evaluate`."""
        fr = (self.frames if frames is None else frames).copy()
        fr["F"] = 0.0
        self.kk[:] = 0.0
        self.out[:] = 0.0
        self.ctl["jac"], self.ctl["ck"], self.ctl["cd"] = jac, ck, cd
        self.ctl["fr"], self.ctl["nb"] = fr.ctypes.data, fr.size
        return invoke(type(self).kind, self.ctl.ctypes.data, self.rec.ctypes.data, 1), fr["F"].copy()

    def get(self, name):
        place = next(k for k, (known, _, _) in enumerate(self.layout.OUTPUTS) if known == name)
        return float(self.out[place])

    def friction_torques(self):
        """Torques of friction on both gears about their axes."""
        first = self.layout.N_OUT + int(self.row["n_pair"])
        return self.out[first : first + 2].copy()

    def press(self, depth, flank=1, frames=None):
        """Turn gear 1 until the deflection is `depth` beyond the gap on a flank."""
        fr = self.frames if frames is None else frames
        for _ in range(3):
            self.evaluate(fr)
            aim = flank * (0.5 * self.row["now"]["gap"] + depth)
            fr["phi"][0] += (aim - self.get("deflection")) / self.row["r_b1"]
        self.evaluate(fr)

    def tangent(self):
        """Block tangent, shape (2, 6, 2, 6)."""
        return self.kk.reshape(2, 2, 6, 6).transpose(0, 2, 1, 3).copy()

    def powers(self, twist, h=2e-8):
        """What the gears and the mesh cycle give, what is stored, what is lost at a motion, shape (2, 6)."""
        energy = []
        for sign in (-1, 1):
            frames = self.frames
            for body in range(2):
                frames = moved(frames, body, sign * h * twist[body])
            self.evaluate(frames)
            energy.append(self.get("elastic_energy"))
        self.frames["tw"] = twist
        F = self.evaluate()
        stored = (energy[1] - energy[0]) / (2 * h)
        lost = self.get("friction_power") + self.get("damping_power")
        return -float((F * twist).sum()), self.get("parametric_power"), stored, lost


def rotation(axis, angle):
    """Rotation matrix about a unit vector (Rodrigues)."""
    a = np.asarray(axis, float)
    K = np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])
    return np.eye(3) + math.sin(angle) * K + (1 - math.cos(angle)) * K @ K


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


def wrenches_move_with_the_gearbox(m):
    """Whether the wrenches of a mesh rotate with the gearbox and do not depend on its place, to 1e-7."""
    F = m.evaluate()
    Q = rotation(np.array([1.0, 2.0, 3.0]) / math.sqrt(14.0), 0.9)
    fr = m.frames.copy()
    for k in range(2):
        fr["r"][k] = Q @ fr["r"][k] + [0.3, -0.1, 0.7]
        fr["R"][k] = Q @ fr["R"][k]
    G = m.evaluate(fr)
    parts = ((G[:, k : k + 3], F[:, k : k + 3]) for k in (0, 3))
    return all(np.allclose(g, f @ Q.T, rtol=0, atol=1e-7 * abs(F).max()) for g, f in parts)
