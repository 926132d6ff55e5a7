# SPDX-License-Identifier: Apache-2.0
"""Load-dependent joint friction: Coulomb and Stribeck, regularised.

The load of a tree joint is the sum of all wrenches of the bodies beyond it, inertia included; that of a cut
joint follows from the multipliers of its rows. With the radial force F_r, the axial force F_a and the bending
moment M_r,

    load = preload + c_r |F_r| + c_a |F_a| + c_m |M_r|,

for a pin of radius r in a bush of length l: c_r = r, c_a = mean radius of the shoulder, c_m = 2 r / l; for a
slide: c_r = 1, c_m = 2 over its length. The friction mu load opposes rotation or sliding. Kinds of this
channel run after all other forces are known; their tangents neglect the change of the load.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.bristle import stribeck
from pitchpoint.contact.friction import coulomb
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.closure import DISTANCE, RIGHT
from pitchpoint.elements.closure import RECORD as CLOSURE
from pitchpoint.elements.kind import FREE, FRICTION, JOINT, Kind
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.channels import F8, I8, bounded, events, frame_args, observations
from pitchpoint.multibody.vectors import add, cross, dot, less, moved_axis, times, triple

TURN, WAY = 0, 1

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("form", "i8"),  # TURN: rotation about the axis; WAY: translation along it
        ("p_i", "f8", 3),  # position of the joint on body i, axes S [m]
        ("p_j", "f8", 3),  # and on body j
        ("axis", "f8", 3),  # axis of the joint, fixed to body j
        ("c_r", "f8"),  # friction radius of the radial force [m], or its factor
        ("c_a", "f8"),  # friction radius of the axial force [m], or its factor
        ("c_m", "f8"),  # factor of the bending moment [1] or [1/m]
        ("preload", "f8"),  # [N m] or [N]
        ("mu", "f8"),  # coefficient of dynamic friction
        ("ratio", "f8"),  # static over dynamic friction
        ("v_s", "f8"),  # Stribeck speed [rad/s] or [m/s]; 0: none
        ("v_eps", "f8"),  # speed of full friction
        ("n_beyond", "i8"),  # number of bodies beyond the joint; 0: cut joint
        ("beyond", "i8"),  # their numbers, as integers in the pool
        ("n_rows", "i8"),  # number of closure records of a cut joint
        ("rows", "i8"),  # the first of them
        ("closures", "i8"),  # address of the closure records; written by the linker
        ("pool", "i8"),
        ("ev", "i8"),
        ("out", "i8"),
    ],
    align=True,
)

#: One function per direction, zero at the speed of full friction. At rest both are far from zero, regardless
#: of round-off and creep; a reversal within one step changes the sign of both.
EVENTS = (
    ("forward_slip", "forward slip of a joint with friction starts or stops"),
    ("backward_slip", "backward slip of a joint with friction starts or stops"),
)

OUTPUTS = (
    ("friction_torque", "N m", "friction of the joint on its moved body"),
    ("friction_power", "W", "friction power loss"),
)


def outputs(record: np.void) -> tuple[tuple[str, str, str], ...]:
    """Observations of one record: friction torque, or friction force of a slide."""
    if record["form"] == WAY:
        return (("friction_force", "N", "friction of the joint on its moved body"), OUTPUTS[1])
    return OUTPUTS


def bodies_beyond(bodies: Sequence[Body], k: int) -> NDArray[np.int64]:
    """Numbers of body k and of all its descendants in the tree.

    Examples
    --------
    >>> bodies_beyond([Body(), Body(parent=1), Body(), Body(parent=2)], 1)
    array([1, 2, 4])
    """
    found = {k}
    for number, body in enumerate(bodies, start=1):
        if body.parent in found and number != k:
            found.add(number)
    return np.array(sorted(found), np.int64)


@kernel
def _hung_load(b, fr, place):
    """Force and moment about the joint of all bodies beyond it."""
    bodies = view(b["pool"] + 8 * b["beyond"], b["n_beyond"], I8)
    force = (0.0, 0.0, 0.0)
    moment = (0.0, 0.0, 0.0)
    for k in range(bodies.size):
        f = fr[bodies[k]]
        own = triple(f["F"], 0)
        force = add(force, own)
        moment = add(moment, add(triple(f["F"], 3), cross(less(triple(f["r"], 0), place), own)))
    return force, moment


@kernel
def _cut_load(b, fr, lam):
    """Force and moment about the joint of the rows of a cut joint, on body i."""
    rows = view(b["closures"], b["rows"] + b["n_rows"], CLOSURE)
    force = (0.0, 0.0, 0.0)
    moment = (0.0, 0.0, 0.0)
    for k in range(b["rows"], rows.size):
        r = rows[k]
        a = moved_axis(fr[r["j"]], r["a_j"])
        if r["form"] == RIGHT:
            moment = add(moment, times(-lam[r["row"]], cross(moved_axis(fr[r["i"]], r["b_i"]), a)))
        elif r["form"] != DISTANCE:
            force = add(force, times(-lam[r["row"]], a))
    return force, moment


@kernel
def _across(x, n):
    """Magnitude of the component of a vector normal to a unit vector."""
    rest = less(x, times(dot(x, n), n))  # a difference of squares would lose half of the digits
    return math.sqrt(dot(rest, rest))


@kernel
def _put(k, s, one_l, one_m, two_l, two_m):
    """Add s times the product of two wrench directions to a pair tangent."""
    for r in range(3):
        for c in range(3):
            k[r, c] += s * one_l[r] * two_l[c]
            k[r, 3 + c] += s * one_l[r] * two_m[c]
            k[3 + r, c] += s * one_m[r] * two_l[c]
            k[3 + r, 3 + c] += s * one_m[r] * two_m[c]


@kernel
def joint_friction(rec, ctl, fr, kk):
    """Friction of all joints with tangents at constant load and observations."""
    c = ctl[0]
    lam = view(c["lam"], c["nc"], F8)
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        n = moved_axis(g, b["axis"])
        s_i = moved_axis(f, b["p_i"])
        place = add(triple(f["r"], 0), s_i)
        s_j = less(place, triple(g["r"], 0))
        nothing = (0.0, 0.0, 0.0)
        # direction of unit friction: about the axis, or along it at the joint
        l_i = n if b["form"] == WAY else nothing
        m_i = cross(s_i, n) if b["form"] == WAY else n
        m_j = cross(s_j, n) if b["form"] == WAY else n
        v = dot(l_i, triple(f["tw"], 0)) + dot(m_i, triple(f["tw"], 3))
        v -= dot(l_i, triple(g["tw"], 0)) + dot(m_j, triple(g["tw"], 3))
        if b["n_beyond"] > 0:
            force, moment = _hung_load(b, fr, place)
        else:
            force, moment = _cut_load(b, fr, lam)
        load = b["preload"] + b["c_r"] * _across(force, n) + b["c_a"] * abs(dot(force, n))
        load += b["c_m"] * _across(moment, n)
        rise, rise_slope = stribeck(v, b["ratio"], b["v_s"])
        sign, sign_slope = coulomb(v, b["v_eps"])
        friction = -b["mu"] * load * rise * sign
        for k in range(3):
            f["F"][k] += friction * l_i[k]
            f["F"][3 + k] += friction * m_i[k]
            g["F"][k] -= friction * l_i[k]
            g["F"][3 + k] -= friction * m_j[k]
        if c["jac"] != 0:
            s = c["cd"] * b["mu"] * load * (rise * sign_slope + rise_slope * sign)
            _put(kk[b["ii"]], s, l_i, m_i, l_i, m_i)
            _put(kk[b["ij"]], -s, l_i, m_i, l_i, m_j)
            _put(kk[b["ji"]], -s, l_i, m_j, l_i, m_i)
            _put(kk[b["jj"]], s, l_i, m_j, l_i, m_j)
        if c["ev"] != 0:
            ev = events(ctl)
            ev[b["ev"]] = bounded(v - b["v_eps"])
            ev[b["ev"] + 1] = bounded(-v - b["v_eps"])
        if c["out"] != 0:
            out = observations(ctl)
            out[b["out"]] = friction
            out[b["out"] + 1] = -friction * v
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return joint_friction(view(rec, n, RECORD), c, fr, kk)


KIND = Kind(
    name="joint_friction",
    role=JOINT,
    channel=FRICTION,
    record=RECORD,
    entry=entry,
    outputs=outputs,
    events=EVENTS,
    body_fixed=True,
    spins=FREE,
    sections={"joints": ""},
)
