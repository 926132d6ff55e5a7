# SPDX-License-Identifier: Apache-2.0
"""Load-dependent joint friction: Coulomb and Stribeck, regularised.

The load of a tree joint is the sum of all wrenches of the bodies beyond it, inertia included; that of a cut
joint follows from the multipliers of its rows. With the force F and the moment M on the moved body about the
joint, across (r) and along (a) its axis,

    load = preload + c_r |F_r| + c_a |F_a| + c_m |M_r|.

* TURN, a pin of radius r in a bush of length l: c_r = r, c_a = mean radius of the shoulder, c_m = 2 r / l;
* WAY, a slide: c_r = 1, c_m = 2 over its length;
* THREAD, a screw with the lead angle lam at the radius r: c_r = 1, c_a = 1 / cos lam. Its friction acts along
  the thread, so it changes the force N normal to the thread (`_thread_load`);
* BUSH, a pin that turns and slides: as a slide, the friction is opposite to the velocity of its surface;
* BALL: load = preload + c_r |F| with its radius c_r, the torque is opposite to the relative rotation;
* PLATE: c_a = 1; its friction is opposite to (v_x, v_y, r omega) with the radius r of the friction torque, an
  ellipsoid of limit loads (S. Goyal, A. Ruina, J. Papadopoulos, *Wear* 143 (1991), 307).

A universal joint has two records TURN, the second with its axis on body i. The friction -mu load s(|v|) v/|v|
acts along up to three directions with the sliding velocities v, so it takes power in every state. Kinds of
this channel run after all other forces are known; their tangents neglect the change of load and directions.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.bristle import stribeck
from pitchpoint.contact.friction import coulomb
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import JAMMED, OK
from pitchpoint.elements.closure import DISTANCE, RIGHT
from pitchpoint.elements.closure import RECORD as CLOSURE
from pitchpoint.elements.kind import FREE, FRICTION, JOINT, Kind
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.channels import F8, I8, bounded, events, frame_args, observations
from pitchpoint.multibody.vectors import add, cross, dot, less, moved_axis, times, triple, unit

TURN, WAY, THREAD, BUSH, BALL, PLATE = 0, 1, 2, 3, 4, 5

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("form", "i8"),  # TURN, WAY, THREAD, BUSH, BALL, PLATE; see the module text
        ("on_i", "i8"),  # 1: the axis is fixed to body i
        ("p_i", "f8", 3),  # position of the joint on body i, axes S [m]
        ("p_j", "f8", 3),  # and on body j
        ("axis", "f8", 3),  # axis of the joint, fixed to body j (or i)
        ("radius", "f8"),  # THREAD, BUSH, PLATE: radius at which rotation slides [m]
        ("lead", "f8"),  # THREAD: travel along the axis [m/rad]
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
        ("along", "f8", (3, 3, 3)),  # scratch: directions of friction; force, moment on body i, on body j
        ("v", "f8", 3),  # scratch: sliding velocities in these directions
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

TORQUE = ("friction_torque", "N m", "friction of the joint on its moved body about its axis")
FORCE = ("friction_force", "N", "friction of the joint on its moved body along its axis")
POWER = ("friction_power", "W", "friction power loss")
OUTPUTS = (TORQUE, POWER)
_OF_FORMS = {
    WAY: (FORCE, POWER),
    THREAD: (FORCE, TORQUE, POWER),
    BUSH: (FORCE, TORQUE, POWER),
    BALL: (("friction_torque", "N m", "magnitude of the friction torque of the joint"), POWER),
    PLATE: (("friction_force", "N", "magnitude of the friction force of the joint"), TORQUE, POWER),
}


def outputs(record: np.void) -> tuple[tuple[str, str, str], ...]:
    """Observations of one record: friction force, friction torque, power."""
    return _OF_FORMS.get(int(record["form"]), OUTPUTS)


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
def _put(k, s, one, two, on_one, on_two):
    """Add s times the product of two wrench directions, on body i (1) or j (2), to a pair tangent."""
    for r in range(3):
        for c in range(3):
            k[r, c] += s * one[0, r] * two[0, c]
            k[r, 3 + c] += s * one[0, r] * two[on_two, c]
            k[3 + r, c] += s * one[on_one, r] * two[0, c]
            k[3 + r, 3 + c] += s * one[on_one, r] * two[on_two, c]


@kernel
def _direct(b, k, linear, angular, s_i, s_j):
    """Store direction k of friction: a force at the joint and a moment."""
    m_i = add(cross(s_i, linear), angular)
    m_j = add(cross(s_j, linear), angular)
    for c in range(3):
        b["along"][k, 0, c] = linear[c]
        b["along"][k, 1, c] = m_i[c]
        b["along"][k, 2, c] = m_j[c]


@kernel
def _directions(b, n, s_i, s_j):
    """Store the unit directions of friction for the axis n; returns their number."""
    nothing = (0.0, 0.0, 0.0)
    form = b["form"]
    if form == TURN:
        _direct(b, 0, nothing, n, s_i, s_j)
        return 1
    if form == WAY:
        _direct(b, 0, n, nothing, s_i, s_j)
        return 1
    if form == THREAD:
        size = math.sqrt(b["radius"] * b["radius"] + b["lead"] * b["lead"])
        _direct(b, 0, times(b["lead"] / size, n), times(b["radius"] * b["radius"] / size, n), s_i, s_j)
        return 1
    if form == BUSH:
        _direct(b, 0, n, nothing, s_i, s_j)
        _direct(b, 1, nothing, times(b["radius"], n), s_i, s_j)
        return 2
    if form == BALL:
        for k in range(3):
            _direct(b, k, nothing, unit(k), s_i, s_j)
        return 3
    # any two directions across the axis: the friction does not depend on the choice
    least = 0 if abs(n[0]) < 0.6 else 1
    across = cross(n, unit(least))
    across = times(1.0 / math.sqrt(dot(across, across)), across)
    _direct(b, 0, across, nothing, s_i, s_j)
    _direct(b, 1, cross(n, across), nothing, s_i, s_j)
    _direct(b, 2, nothing, times(b["radius"], n), s_i, s_j)
    return 3


@kernel
def _thread_load(b, axial, other, k):
    """Load of a thread: its other loads and |N|; negative if it jams.

    N follows from the balance of the moved body along the axis, N cos lam + f sin lam + F_a = 0, in which no
    torque occurs, known or not, such as that of a drive. The friction f = -k (other + |N|) acts along the
    thread, so |N| cos lam (1 -+ k tan lam) = |F_a - k other sin lam|: no finite torque drives a thread uphill
    if k tan lam reaches 1 (lead angle + friction angle = 90 deg). In a cut joint the rows carry N cos lam.
    """
    if b["n_beyond"] == 0:
        return other + b["c_a"] * abs(axial)
    along = k * b["lead"] / math.hypot(b["radius"], b["lead"]) * other - axial
    rise = k * b["lead"] / b["radius"]
    part = 1.0 - (rise if along > 0.0 else -rise)
    return other + b["c_a"] * abs(along) / part if part > 0.0 else -1.0


@kernel
def _load(b, force, moment, n, k):
    """Load of the joint from force and moment about it; k: friction over load, signed, for threads."""
    if b["form"] == BALL:
        return b["preload"] + b["c_r"] * math.sqrt(dot(force, force))
    load = b["preload"] + b["c_r"] * _across(force, n) + b["c_m"] * _across(moment, n)
    if b["form"] == THREAD:
        return _thread_load(b, dot(force, n), load, k)
    return load + b["c_a"] * abs(dot(force, n))


@kernel
def _observe(b, ctl, n, friction, speed):
    """Write the observations: `friction` is the factor of the sliding velocities."""
    out = observations(ctl)
    form = b["form"]
    at = b["out"]
    v = b["v"]
    if form == PLATE:
        out[at] = abs(friction) * math.sqrt(v[0] * v[0] + v[1] * v[1])
        out[at + 1] = friction * v[2] * b["radius"]
        at += 1
    elif form == BALL:
        out[at] = abs(friction) * speed
    elif form == BUSH:
        out[at] = friction * v[0]
        out[at + 1] = friction * v[1] * b["radius"]
        at += 1
    elif form == THREAD:
        out[at] = friction * v[0] * dot(triple(b["along"][0, 0], 0), n)
        out[at + 1] = friction * v[0] * b["radius"] * b["radius"] / math.hypot(b["radius"], b["lead"])
        at += 1
    else:
        out[at] = friction * v[0]
    out[at + 1] = -friction * speed * speed


@kernel
def joint_friction(rec, ctl, fr, kk):
    """Friction of all joints with tangents at constant load and observations."""
    c = ctl[0]
    lam = view(c["lam"], c["nc"], F8)
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        n = moved_axis(f if b["on_i"] != 0 else g, b["axis"])
        s_i = moved_axis(f, b["p_i"])
        place = add(triple(f["r"], 0), s_i)
        count = _directions(b, n, s_i, less(place, triple(g["r"], 0)))
        square = 0.0
        for k in range(count):
            d = b["along"][k]
            v = dot(triple(d[0], 0), triple(f["tw"], 0)) + dot(triple(d[1], 0), triple(f["tw"], 3))
            v -= dot(triple(d[0], 0), triple(g["tw"], 0)) + dot(triple(d[2], 0), triple(g["tw"], 3))
            b["v"][k] = v
            square += v * v
        speed = math.sqrt(square)
        if b["n_beyond"] > 0:
            force, moment = _hung_load(b, fr, place)
        else:
            force, moment = _cut_load(b, fr, lam)
        rise, rise_slope = stribeck(speed, b["ratio"], b["v_s"])
        sign, slope = coulomb(speed, b["v_eps"])
        slope = rise * slope + rise_slope * sign
        factor = rise * sign / speed if speed > 0.0 else slope
        load = b["mu"] * _load(b, force, moment, n, b["mu"] * factor * b["v"][0])
        if load < 0.0:
            c["bad"] = e
            return JAMMED
        for k in range(count):
            friction = -load * factor * b["v"][k]
            d = b["along"][k]
            for r in range(3):
                f["F"][r] += friction * d[0, r]
                f["F"][3 + r] += friction * d[1, r]
                g["F"][r] -= friction * d[0, r]
                g["F"][3 + r] -= friction * d[2, r]
        if c["jac"] != 0:
            for k in range(count):
                for h in range(count):
                    s = factor if k == h else 0.0
                    if speed > 0.0:
                        s += (slope - factor) * (b["v"][k] / speed) * (b["v"][h] / speed)
                    s *= c["cd"] * load
                    _put(kk[b["ii"]], s, b["along"][k], b["along"][h], 1, 1)
                    _put(kk[b["ij"]], -s, b["along"][k], b["along"][h], 1, 2)
                    _put(kk[b["ji"]], -s, b["along"][k], b["along"][h], 2, 1)
                    _put(kk[b["jj"]], s, b["along"][k], b["along"][h], 2, 2)
        if c["ev"] != 0:
            ev = events(ctl)
            forward = b["v"][0] if count == 1 else speed
            ev[b["ev"]] = bounded(forward - b["v_eps"])
            ev[b["ev"] + 1] = bounded(-forward - b["v_eps"])
        if c["out"] != 0:
            _observe(b, ctl, n, -load * factor, speed)
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
