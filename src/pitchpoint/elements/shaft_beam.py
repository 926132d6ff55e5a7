# SPDX-License-Identifier: Apache-2.0
"""Beam element of a round shaft between two bodies (body 0 = ground) that spin about its axis.

The nodes are on the spin axes of the bodies, and the section axes of both ends are the non-spinning frames of
the bodies. The twist is the difference of the spin angles, without trigonometric functions of the spin and
without loss of precision over whole turns. The bodies must not tumble, since their spin angles would be
redefined. Formulas: `beams.forces`.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.beams.forces import internal, loads, node, turned
from pitchpoint.elements.beams.record import OUTPUTS, RECORD, beam_row
from pitchpoint.elements.beams.tangent import tangent
from pitchpoint.elements.kind import FRAME, TOGETHER, Kind, Power
from pitchpoint.multibody.beam_section import Beam
from pitchpoint.multibody.channels import frame_args, observations

__all__ = ["KIND", "OUTPUTS", "RECORD", "entry", "shaft_beam", "shaft_row"]


TWO_PI = 6.283185307179586


def shaft_row(
    beam: Beam,
    *,
    bodies: tuple[int, int],
    places: tuple[float, float] = (0.0, 0.0),
    senses: tuple[int, int] = (1, 1),
    eta: float = 0.0,
    twist: float = 0.0,
    gravity: ArrayLike = (0.0, 0.0, 0.0),
) -> NDArray[np.void]:
    """Record of one shaft element, shape (1,).

    Parameters
    ----------
    beam
        Section, length and material; the section must be round.
    bodies
        Numbers of the bodies at both ends; 0 = ground.
    places
        Positions of the ends on the spin axes of their bodies, from the origins [m].
    senses
        1 if the spin axis points from the first end to the second, -1 if it is opposite.
    eta, twist, gravity
        See `beam_row`.
    """
    if not beam.section.round:
        raise CompileError("the section of a spinning shaft must be round; use a beam fixed to its bodies")
    axes = tuple(np.diag([1.0, float(s), float(s)]) for s in senses)
    nodes = tuple((0.0, 0.0, float(z)) for z in places)
    return beam_row(
        beam,
        bodies=bodies,
        nodes=(nodes[0], nodes[1]),
        axes=(axes[0], axes[1]),
        eta=eta,
        twist=twist,
        gravity=gravity,
    )


@kernel
def _spun(b, f, g, turn):
    """Twist angle of the second end relative to the first: angle of the frames plus difference of the spins.

    Frames of bodies with a spinning parent rotate with it; the spins of the parents determine the whole turns
    of the angle between the frames.
    """
    si = b["B_i"][2, 2]
    sj = b["B_j"][2, 2]
    whole = si * f["base_turns"] - sj * g["base_turns"]
    base = sj * g["base"] - si * f["base"]
    off = turn - base
    off -= TWO_PI * math.floor(off / TWO_PI + 0.5)
    turns = sj * g["turns"] - si * f["turns"] - whole
    return (sj * g["phi"] - si * f["phi"]) + base + off + TWO_PI * turns


@kernel
def shaft_beam(rec, ctl, fr, kk):
    """Forces, tangents and observations of all shaft elements."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        second_i = node(b, 0, f, f["R"], b["p_i"], b["B_i"])
        second_j = node(b, 1, g, g["R"], b["p_j"], b["B_j"])
        loads(b, f, g, _spun(b, f, g, turned(b, second_i, second_j)))
        if c["jac"] != 0:
            tangent(b, kk, c["cm"], c["cd"], c["ck"])
        elif c["cm"] != 0.0 and b["mass"] > 0.0:
            tangent(b, kk, c["cm"], 0.0, 0.0)
        if c["out"] != 0:
            internal(b, observations(ctl), b["out"], f["R"], g["R"])
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return shaft_beam(view(rec, n, RECORD), c, fr, kk)


KIND = Kind(
    name="shaft_beam",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    spins=TOGETHER,
    linear=True,
    fine=True,
    excites=False,
    sections={"shafts": ""},
    label="beam",
    power=Power(),
)
