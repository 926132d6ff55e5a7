# SPDX-License-Identifier: Apache-2.0
"""Interface of element kinds: control record, body frames, and the functions that unpack them.

There are four channels. *Frame* kinds read frames and add wrenches and world tangents; *coordinate* kinds act
directly on generalised coordinates; *constraint* kinds write rows of g and G; *motion* kinds compute the
displacements of guided joints before the frames. An entry has four lines::

    @kernel
    def entry(ctl, rec, n):
        c, fr, kk = frame_args(ctl)
        return bearing(view(rec, n, RECORD), c, fr, kk)

With jac > 0 frame kinds add ``-(ck dF_i/dx_j + cd dF_i/dxdot_j)`` to ``kk[pair]``, where x is the small
world displacement twist (translation of the origin, rotation) of body j. Kinds with mass subtract their
inertia forces from the wrenches and add ``-cm dF_i/dxddot_j`` if ``ctl["cm"]`` is not zero, for any jac.
Results are written only if ``ctl["out"]`` is not zero, and event functions only if ``ctl["ev"]`` is not
zero.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view

F8 = np.dtype("f8")
I8 = np.dtype("i8")

CTL = np.dtype(
    [
        ("t", "f8"),  # time [s]
        ("ck", "f8"),  # factor of the position tangent [-]
        ("cd", "f8"),  # factor of the velocity tangent [1/s]
        ("cm", "f8"),  # factor of the mass matrix [1/s^2]
        ("jac", "i8"),  # 0 forces only, 1 Newton matrix (may be approximate), 2 exact tangents
        ("held", "i8"),  # 1: in a loop of fixed steps, where slow elements may extrapolate their forces
        ("nb", "i8"),  # number of bodies, ground included
        ("nd", "i8"),  # number of coordinates
        ("np", "i8"),  # number of body-pair blocks in kk
        ("na", "i8"),  # number of 6x6 blocks in A
        ("nc", "i8"),  # number of constraint rows
        ("no", "i8"),  # number of observations
        ("ne", "i8"),  # number of event functions
        ("fr", "i8"),  # address of FRAME[nb]
        ("q", "i8"),  # address of q[nd] [m, rad]; spin as remainder
        ("v", "i8"),  # address of v[nd] [m/s, rad/s]
        ("a", "i8"),  # address of accelerations [nd]
        ("R", "i8"),  # address of the residual [nd]: inertia minus forces
        ("kk", "i8"),  # address of kk[np,6,6], tangents per body pair, world axes
        ("A", "i8"),  # address of A[na,6,6], the block matrix of the coordinates
        ("g", "i8"),  # address of g[nc], constraint residuals
        ("G", "i8"),  # address of G[nc,nd], constraint rows on the coordinates
        ("Gf", "i8"),  # address of Gf[nc,2,6], constraint rows on the frames of bodies i and j
        ("gt", "i8"),  # address of gt[nc], partial time derivative of g
        ("gtt", "i8"),  # address of gtt[nc], the part of d2g/dt2 that is not G a
        ("lam", "i8"),  # address of the multipliers [nc]
        ("out", "i8"),  # address of the observations [no]; 0 = not requested
        ("ev", "i8"),  # address of the event functions [ne]; 0 = not requested
        ("at", "i8"),  # address of this record
        ("bad", "i8"),  # index of the record that failed; set by the kind that returns a status
        ("badkind", "i8"),  # row of the kind that failed; set by the driver
        ("guides", "i8"),  # address of GUIDE[ng], displacements that are functions
        ("ng", "i8"),  # guided bodies
        ("mach", "i8"),  # address of the private arrays of the driver
    ],
    align=True,
)

FRAME = np.dtype(
    [
        ("r", "f8", 3),  # world position of the body origin [m]
        ("R", "f8", (3, 3)),  # non-spinning frame: columns = its axes in world axes; third column = spin axis
        ("tw", "f8", 6),  # world twist: velocity of the origin [m/s], angular velocity with spin [rad/s]
        ("ac", "f8", 6),  # time derivative of tw [m/s^2, rad/s^2]
        ("F", "f8", 6),  # accumulator: force [N] and moment about the origin [N m], world axes; [0] is a sink
        ("S", "f8", (3, 3)),  # body-fixed frame: R rotated by phi; only if `fixed_axes` is set
        ("phi", "f8"),  # spin about the third axis, remainder in (-pi, pi] [rad]
        ("spin", "f8"),  # time derivative of phi [rad/s]
        ("turns", "i8"),  # whole turns: the spin is phi + 2 pi turns
        ("base", "f8"),  # rotation of R about the third axis due to the spins of the parents [rad]
        ("base_turns", "i8"),  # whole turns of these spins
        ("axle", "f8", 3),  # with jac 2 only: a small rotation w of the body [rad] changes phi by axle . w
    ],
    align=True,
)


#: Result of a motion kind for a guided joint: displacements d_m(q, t) = sum f_mk(q_k) + f_m(t).
GUIDE = np.dtype(
    [
        ("d", "f8", 6),  # displacements [m, rad]
        ("rate", "f8", 6),  # first partial derivative by time
        ("second", "f8", 6),  # second partial derivative by time
        ("by", "f8", (6, 6)),  # row m, column k: first derivative of displacement m by coordinate k
        ("by2", "f8", (6, 6)),  # second derivative
        ("by3", "f8", (6, 6)),  # third derivative; with jac 2 only
    ],
    align=True,
)


@kernel
def frame_args(where):
    """Arrays of the frame channel: control (one-element array), frames [nb], pair tangents [np,6,6]."""
    ctl = view(where, 1, CTL)
    c = ctl[0]
    return ctl, view(c["fr"], c["nb"], FRAME), view(c["kk"], (c["np"], 6, 6), F8)


@kernel
def coordinate_args(where):
    """Arrays of the coordinate channel: control, q, v, residual R (R -= force), blocks A[na,6,6]."""
    ctl = view(where, 1, CTL)
    c = ctl[0]
    nd = c["nd"]
    return (
        ctl,
        view(c["q"], nd, F8),
        view(c["v"], nd, F8),
        view(c["R"], nd, F8),
        view(c["A"], (c["na"], 6, 6), F8),
    )


@kernel
def constraint_args(where):
    """Arrays of the constraint channel: control, frames, q, g[nc], G[nc,nd]."""
    ctl = view(where, 1, CTL)
    c = ctl[0]
    nc = c["nc"]
    nd = c["nd"]
    return (
        ctl,
        view(c["fr"], c["nb"], FRAME),
        view(c["q"], nd, F8),
        view(c["g"], nc, F8),
        view(c["G"], (nc, nd), F8),
    )


@kernel
def motion_args(where):
    """Arrays of the motion channel: control, q, guides [ng]."""
    ctl = view(where, 1, CTL)
    c = ctl[0]
    return ctl, view(c["q"], c["nd"], F8), view(c["guides"], c["ng"], GUIDE)


@kernel
def constraint_rates(ctl):
    """Further arrays of the constraint channel: v[nd], gt[nc], gtt[nc], frame rows Gf[nc,2,6]."""
    c = ctl[0]
    nc = c["nc"]
    return (
        view(c["v"], c["nd"], F8),
        view(c["gt"], nc, F8),
        view(c["gtt"], nc, F8),
        view(c["Gf"], (nc, 2, 6), F8),
    )


@kernel
def tangents(ctl):
    """Pair tangents kk[np,6,6], for constraint kinds on frames."""
    c = ctl[0]
    return view(c["kk"], (c["np"], 6, 6), F8)


@kernel
def observations(ctl):
    """Observations [no]; valid only if ``ctl[0]["out"] != 0``."""
    return view(ctl[0]["out"], ctl[0]["no"], F8)


@kernel
def events(ctl):
    """Event functions [ne]; valid only if ``ctl[0]["ev"] != 0``."""
    return view(ctl[0]["ev"], ctl[0]["ne"], F8)


@kernel
def bounded(x):
    """Event function with the sign of x, limited to ±1/4; a change above 1/2 would mean a phase wrap."""
    return 0.25 * x / (1.0 + abs(x))
