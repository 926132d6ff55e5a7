# SPDX-License-Identifier: Apache-2.0
"""Rolling bearing with discrete elements: varying compliance, clearance, radial, axial and tilting forces.

Element k is at the azimuth psi_k = psi_0 + c T + 2 pi k/n of the outer ring, where T is the rotation of the
inner ring relative to it with all whole turns, and c = (1 - (D/d_m) cos(alpha))/2 the cage ratio for pure
rolling. The approach of the raceways there is

    radial   a_r = X cos(psi) + Y sin(psi) - gap
    axial    a_z = Z - (d_m/2)(n_x cos(psi) + n_y sin(psi))

With constant contact angle the approach is d = a_r cos(alpha) + a_z sin(alpha) (rollers, simple model of
balls). With a distance A of the groove centres it is that of Jones and Harris, with a load-dependent contact
angle: d = |(p, q)| - A with p = A cos(alpha) + a_r and q = A sin(alpha) + a_z, the radial and axial distance
of the groove centres. A groove carries only within its arc, a right angle to either side of the radial
direction: a negative p, where the groove centres have passed each other, counts as 0 (except in washers). So
does a negative q of balls with one shoulder: the rings come apart. The load of each element is

    Q = K d^p max(0, 1 + chi d')   for d > 0

(p = 3/2 or 10/9; damping after Hunt and Crossley, J. Appl. Mech. 42, 1975, which vanishes at separation and
never pulls). Forces are conjugate to d, including the rotation: an element that lifts the shaft also has a
torque on it. T. A. Harris, *Rolling Bearing Analysis*; centrifugal forces of the elements are neglected.

The rows of a double-row bearing are half a spacing apart and have opposite contact angles; those of a rigid
one are at the distance e below and above the centre (O arrangement), where the radial approach has the
additional term e (n_x cos(psi) + n_y sin(psi)). Self-aligning bearings (spherical raceway) have neither e nor
the lever d_m/2 in a_z: their rings tilt without resistance. Rollers with an effective length are divided into
slices (`rolling_slices`); flanges of cylindrical rollers follow `rolling_flange`. Z includes `shift`, an
axial preload. A floating bearing follows the shaft along the axis: a_z = 0.

Over a spall the approach of an element is reduced by the depth that it drops (`bearing_fault`); with uneven
spacing in the cage each element has an additional angle in psi_k.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.bearing_fault import lost_approach, shifted
from pitchpoint.elements.kind import FRAME, FREE, Kind
from pitchpoint.elements.ring import (
    CLOSED,
    RESULTANTS,
    RING,
    close_ring,
    ring_forces,
    ring_motion,
    ring_observations,
    ring_tangents,
    whole_turns,
)
from pitchpoint.elements.ring import OUTPUTS as RING_OUTPUTS
from pitchpoint.elements.rolling_bearing_forces import WASHER, push_elements
from pitchpoint.elements.rolling_flange import push_flange
from pitchpoint.elements.rolling_slices import add_slices, push_slices, slice_sums, tilt_gradient, tilt_of
from pitchpoint.multibody.channels import frame_args, observations

TWO_PI = 6.283185307179586
SPLIT = 67108864.0
"""2^26: the cage ratio is split after 26 binary digits, so that its product with whole turns is exact."""


RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + RING
    + [
        ("n", "i8"),  # number of rolling elements
        ("pitch", "f8"),  # pitch diameter d_m [m]
        ("element", "f8"),  # diameter of a rolling element D [m]
        ("angle", "f8"),  # contact angle; positive: the axial force on the inner ring is along -z [rad]
        ("gap", "f8"),  # half of the radial internal clearance [m]
        ("grooves", "f8"),  # distance A of the groove centres, 0 = constant contact angle [m]
        ("stiffness", "f8"),  # K of an element between both raceways [N/m^p]
        ("exponent", "f8"),  # p
        ("chi", "f8"),  # damping factor [s/m]
        ("azimuth", "f8"),  # psi_0 [rad]
        ("rows", "i8"),  # 0, 1: single-row; 2: double-row
        ("aligns", "i8"),  # 1: self-aligning, one raceway is a sphere about the centre
        ("floats", "i8"),  # 1: no axial force
        ("one_sided", "i8"),  # 1: balls have a shoulder on one side only, towards their axial force
        ("offset", "f8"),  # distance of either row from the centre [m]
        ("flange", "f8"),  # stiffness of the flanges, 0: none [N/m]
        ("flange_low", "f8"),
        ("flange_high", "f8"),  # axial displacements of the inner ring at which flanges touch [m]
        ("shift", "f8"),  # axial displacement of the inner ring to the outer one as assembled [m]
        ("n_slices", "i8"),  # number of slices of a roller, 0: one point
        ("slices", "i8"),  # their rows, offset in the pool; see `rolling_slices`
        ("n_faults", "i8"),  # number of spalls
        ("faults", "i8"),  # their rows, offset in the pool; see `bearing_fault`
        ("uneven", "i8"),  # 1: uneven spacing of the elements
        ("spacing", "i8"),  # additional azimuth of every element [rad], offset in the pool
        ("pool", "i8"),  # address of the float array that holds all tables
        ("known_n", "i8"),  # n and angle for which the next five fields were computed
        ("known_angle", "f8"),
        ("ca", "f8"),
        ("sa", "f8"),  # cosine and sine of the contact angle
        ("step_c", "f8"),
        ("step_s", "f8"),  # and of the angle from one element to the next
        ("half", "f8"),  # lever of the tilt in the axial approach: d_m/2, or 0 if self-aligning [m]
        ("place", "f8"),  # scratch: position of the current row from the centre [m]
        ("G", "f8", (4, 6)),  # scratch: gradients of radial and axial approach, of d, and normal to d
        ("H", "f8", (6, 6)),  # scratch: second derivative of d
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS = (*RING_OUTPUTS, ("cage_angle", "rad", "angle of the cage relative to the outer ring, modulo 2 pi"))


@kernel
def cage_angle(share, turn, turns):
    """Rotation of the cage without whole turns: `share` times (turn + 2 pi turns) [rad].

    The product of the leading digits of `share` and the number of turns has no round-off error, so that the
    angle is exact up to 1e8 turns.
    """
    lead = math.floor(share * SPLIT) / SPLIT
    x = lead * turns
    x -= math.floor(x)
    x += (share - lead) * turns
    x -= math.floor(x)
    return share * turn + TWO_PI * x


@kernel
def roll_angle(share, turn, turns):
    """Angle of a body with the speed ratio `share` to the inner ring, without whole turns [rad]."""
    whole = math.floor(share)
    return whole * turn + cage_angle(share - whole, turn, turns)


@kernel
def _remember_angles(b):
    """Compute constant cosines and sines once."""
    if b["known_n"] != b["n"] or b["known_angle"] != b["angle"]:
        b["known_n"] = b["n"]
        b["known_angle"] = b["angle"]
        b["ca"] = math.cos(b["angle"])
        b["sa"] = math.sin(b["angle"]) if b["floats"] == 0 else 0.0
        b["half"] = 0.5 * b["pitch"] if b["aligns"] == 0 and b["floats"] == 0 else 0.0
        b["step_c"] = math.cos(TWO_PI / b["n"])
        b["step_s"] = math.sin(TWO_PI / b["n"])


@kernel
def _gradients(b, c, s, share):
    """Write the gradients of radial and axial approach to G[0] and G[1]."""
    x = b["x"]
    G = b["G"]
    half = b["half"]
    e = b["place"]
    for r in range(6):
        G[0, r] = 0.0
        G[1, r] = 0.0
    G[0, 0] = c
    G[0, 1] = s
    G[0, 3] = e * c
    G[0, 4] = e * s
    G[0, 5] = share * ((x[1] + e * x[4]) * c - (x[0] + e * x[3]) * s)
    G[1, 2] = 1.0
    G[1, 3] = -half * c
    G[1, 4] = -half * s
    G[1, 5] = share * half * (x[3] * s - x[4] * c)


@kernel
def _curvatures(b, c, s, share, ca, sa, bend):
    """Write the second derivative of the approach to H."""
    x = b["x"]
    G = b["G"]
    H = b["H"]
    half = b["half"]
    for r in range(6):
        G[3, r] = ca * G[1, r] - sa * G[0, r]
    for r in range(6):
        for e in range(6):
            H[r, e] = bend * G[3, r] * G[3, e]
    e_ca = b["place"] * ca
    mixed_x = -share * s * ca
    mixed_y = share * c * ca
    mixed_n = share * (half * sa - e_ca)
    H[0, 5] += mixed_x
    H[5, 0] += mixed_x
    H[1, 5] += mixed_y
    H[5, 1] += mixed_y
    H[3, 5] += mixed_n * s
    H[5, 3] += mixed_n * s
    H[4, 5] -= mixed_n * c
    H[5, 4] -= mixed_n * c
    H[5, 5] += share * share * ((half * sa - e_ca) * (x[3] * c + x[4] * s) - ca * (x[0] * c + x[1] * s))


@kernel
def _slopes(b, by_approach, by_rate, force):
    """Add the slopes of one element to K and D."""
    G = b["G"]
    H = b["H"]
    for r in range(6):
        for e in range(6):
            s = by_approach * G[2, e]
            for h in range(6):
                s += by_rate * H[e, h] * b["w"][h]
            b["K"][r, e] += G[2, r] * s + force * H[r, e]
            b["D"][r, e] += by_rate * G[2, r] * G[2, e]


@kernel
def _approach(b, c, s, sa):
    """Approach of the raceways at an element, cosine and sine of its contact angle, curvature of the path.

    `sa` is the sine of the initial contact angle, opposite in the second row.
    """
    x = b["x"]
    tilt = tilt_of(b, c, s)
    radial = x[0] * c + x[1] * s + b["place"] * tilt - b["gap"]
    axial = x[2] + b["shift"] - b["half"] * tilt
    ca = b["ca"]
    A = b["grooves"]
    if A > 0.0 and b["floats"] == 0:
        p = A * ca + radial
        q = A * sa + axial
        bend = 1.0
        if p < 0.0 and ca > WASHER:
            p = 0.0
            bend = 0.0
        if b["one_sided"] != 0 and q * sa < 0.0:
            q = 0.0
            bend = 0.0
        length = math.sqrt(p * p + q * q)
        if length <= A:
            return length - A, ca, sa, 0.0
        inverse = 1.0 / length
        return length - A, p * inverse, q * inverse, bend * inverse
    return radial * ca + axial * sa, ca, sa, 0.0


@kernel
def _element(b, c, s, share, jac, loss, sa):
    """Add force and slopes of one element at an azimuth with cosine c and sine s.

    `loss`: loss of approach over spalls, with first and second derivative by the rotation. `sa`: as of
    `_approach`.
    """
    d, ca, sa, bend = _approach(b, c, s, sa)
    lost, lost_slope, lost_bend = loss
    d -= lost
    sliced = b["n_slices"] > 0
    if not (d > 0.0 or sliced):
        return
    _gradients(b, c, s, share)
    G = b["G"]
    rate = 0.0
    for r in range(6):
        G[2, r] = ca * G[0, r] + sa * G[1, r]
    G[2, 5] -= lost_slope
    for r in range(6):
        rate += G[2, r] * b["w"][r]
    if sliced:
        if jac != 0:
            _curvatures(b, c, s, share, ca, sa, bend)
            b["H"][5, 5] -= lost_bend
        tilt_rate = tilt_gradient(b, c, s, share)
        add_slices(b, c, s, share, slice_sums(b, d, rate, tilt_of(b, c, s), tilt_rate), jac)
        return
    damped = 1.0 + b["chi"] * rate
    if damped <= 0.0:
        return
    elastic = b["stiffness"] * (d * math.sqrt(d) if b["exponent"] == 1.5 else d ** b["exponent"])
    for r in range(6):
        b["f"][r] -= elastic * damped * G[2, r]
    if jac != 0:
        _curvatures(b, c, s, share, ca, sa, bend)
        b["H"][5, 5] -= lost_bend
        _slopes(b, b["exponent"] * elastic / d * damped, elastic * b["chi"], elastic * damped)


@kernel
def _spun(b, turns):
    """Angle of the elements about their axes relative to the cage, and its derivative by the rotation."""
    gamma = b["element"] / b["pitch"] * b["ca"]
    share = -0.5 * b["pitch"] / b["element"] * (1.0 - gamma * gamma)
    return roll_angle(share, b["x"][5], turns), share


@kernel
def _faulty_element(b, k, place, cage, spun, jac):
    """Add element k of a bearing with faults.

    `place`: cosine and sine of its azimuth with even spacing, sine of its contact angle; `cage`: ratio and
    angle of the cage.
    """
    c, s, sa = place
    share, turned = cage
    psi = b["azimuth"] + turned + TWO_PI * k / b["n"]
    if b["uneven"] == 1:
        c, s, by = shifted(b, k, c, s)
        psi += by
    loss = (0.0, 0.0, 0.0)
    if b["n_faults"] > 0:
        loss = lost_approach(b, k, psi, share, spun)
    _element(b, c, s, share, jac, loss, sa)


@kernel
def _row(b, start, cage, spun, sa, jac):
    """Add all elements of one row, the first at the azimuth `start`; other arguments as of `_element`."""
    share = cage[0]
    c = math.cos(start)
    s = math.sin(start)
    whole = b["n_faults"] == 0 and b["uneven"] == 0
    if jac == 0 and whole:
        if b["n_slices"] > 0:
            push_slices(b, c, s, share, sa)
        else:
            push_elements(b, c, s, share, sa)
        return
    for k in range(b["n"]):
        if whole:
            _element(b, c, s, share, jac, (0.0, 0.0, 0.0), sa)
        else:
            _faulty_element(b, k, (c, s, sa), cage, spun, jac)
        turned = c * b["step_c"] - s * b["step_s"]
        s = s * b["step_c"] + c * b["step_s"]
        c = turned


@kernel
def rolling_bearing(rec, ctl, fr, kk):
    """Wrenches, tangents and observations of all rolling bearings."""
    ctl0 = ctl[0]
    jac = ctl0["jac"]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        line = ring_motion(b, f, g)
        _remember_angles(b)
        share = 0.5 * (1.0 - b["element"] / b["pitch"] * b["ca"])
        turns = whole_turns(f, g, b["j"], line, b["x"][5])
        cage = cage_angle(share, b["x"][5], turns)
        for r in range(6):
            b["f"][r] = 0.0
            if jac != 0:
                for h in range(6):
                    b["K"][r, h] = 0.0
                    b["D"][r, h] = 0.0
        spun = (0.0, 0.0)
        if b["n_faults"] > 0:
            spun = _spun(b, turns)
        start = b["azimuth"] + cage
        b["place"] = -b["offset"]
        _row(b, start, (share, cage), spun, b["sa"], jac)
        push_flange(b, jac)
        if b["rows"] == 2:
            b["place"] = b["offset"]
            _row(b, start + math.pi / b["n"], (share, cage), spun, -b["sa"], jac)
        if ctl0["out"] != 0:
            out = observations(ctl)
            ring_observations(b, fr, line, out)
            out[b["out"] + RESULTANTS] = cage - TWO_PI * math.floor(cage / TWO_PI)
        ring_forces(b, f, g, line)
        if jac != 0:
            ring_tangents(b, f, g, kk, ctl, line)
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return rolling_bearing(view(rec, n, RECORD), c, fr, kk)


def close(records: Any) -> None:
    """Remove the radial clearance and the axial play of flanges, in place."""
    close_ring(records)
    for field, side in (("flange_low", 1.0), ("flange_high", -1.0)):
        records[field] = np.where(np.isfinite(records[field]), side * CLOSED, records[field])


KIND = Kind(
    name="rolling_bearing",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    body_fixed=True,
    massless=True,
    spins=FREE,
    close=close,
    sections={"rolling_bearings": ""},
    plural="rolling bearings",
    arrow="ring",
)
