# SPDX-License-Identifier: Apache-2.0
"""Springs around a flexible rim: bolts, pins, splines or a press fit between rim and housing.

A point of the rim, p in the axes S of body i, is displaced by Phi eta and supported at a point of body j, the
housing. With two directions e of body j, radial and tangential there, the springs have the elongations

    c = e . (r_i + S (p + Phi eta) - r_j - q)

and act with the forces -k c e on the rim, the reaction on the housing, and the modal forces S Phi_k . f: the
gradient of the energy k c^2/2, for motions of both bodies of any size.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import FRAME, FREE, HOLDS, RIM, WITH_RIM, Kind
from pitchpoint.elements.mesh.rim_workspace import GROUP, MAX_MODES, WAY, hidden
from pitchpoint.elements.wrench import origin, push
from pitchpoint.multibody.channels import F8, frame_args, observations
from pitchpoint.multibody.vectors import add, cross, dot, into_world, less, plus, times, triple, unit

SPRINGS = 2
"""Springs of one support: radial and tangential."""
HEAD = 14
"""Numbers of a support in the pool: p, q, both directions, both stiffnesses; then Phi, three per
coordinate."""

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj", *RIM[2:])]
    + [
        ("pairs", "i8", (len(RIM), len(RIM))),
        ("n_rim", "i8"),  # modal coordinates
        ("count", "i8"),
        ("holds", "i8"),  # 1: tangential springs resist a rotation of the rim
        ("supports", "i8"),  # supports, offset in the pool [count, HEAD + 3 n_rim]
        ("pool", "i8"),
        ("eta", "f8", MAX_MODES),  # scratch
        ("shape", "f8", (MAX_MODES, 3)),  # scratch: Phi in world axes
        ("slope", "f8", (SPRINGS, WAY)),  # scratch: elongations by motions of both bodies and coordinates
        ("tangent", "f8", (WAY, WAY)),  # scratch
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS = (("strain_energy", "J", "strain energy of the supports"),)


@kernel
def _cross(a, c):
    """Vector a times a small rotation about axis c - 3 of a motion; zero for displacements."""
    return cross(unit(c - 3), a)


@kernel
def _change_of_arm(b, arm, c):
    """Change of the arm of the rim point about the origin of body i by motion c."""
    if c >= 12:
        return triple(b["shape"][c - 12], 0)
    return _cross(arm, c) if c < 6 else (0.0, 0.0, 0.0)


@kernel
def _slopes(b, arm, reach, axes):
    """Derivatives of the elongations by all motions."""
    for c in range(12 + b["n_rim"]):
        if c < 6 or c >= 12:
            d = _change_of_arm(b, arm, c)
            d = add(d, unit(c)) if c < 6 else d
        else:
            d = times(-1.0, add(unit(c - 6), _cross(reach, c - 6)))
        for s in range(SPRINGS):
            b["slope"][s, c] = dot(axes[s], d)


@kernel
def _stiffness(b, arm, reach, force, stiff):
    """Add the tangent of one support: springs, and rotation of the force and of its arms."""
    A = b["tangent"]
    ways = 12 + b["n_rim"]
    for c in range(ways):
        for r in range(ways):
            A[r, c] += stiff[0] * b["slope"][0, r] * b["slope"][0, c]
            A[r, c] += stiff[1] * b["slope"][1, r] * b["slope"][1, c]
        turned = _cross(force, c - 6) if c >= 9 and c < 12 else (0.0, 0.0, 0.0)
        d_arm = _change_of_arm(b, arm, c)
        d_reach = d_arm
        if c < 6:
            d_reach = add(d_arm, unit(c))
        elif c < 12:
            d_reach = times(-1.0, unit(c - 6))
        one = add(cross(d_arm, force), cross(arm, turned))
        two = add(cross(d_reach, force), cross(reach, turned))
        for r in range(3):
            A[r, c] -= turned[r]
            A[3 + r, c] -= one[r]
            A[6 + r, c] += turned[r]
            A[9 + r, c] += two[r]
        for k in range(b["n_rim"]):
            shape = triple(b["shape"][k], 0)
            A[12 + k, c] -= dot(shape, turned)
            if c < 6:
                A[12 + k, c] -= dot(_cross(shape, c), force)


@kernel
def _spread(b, kk, ck):
    """Add the tangent to the pair blocks."""
    n = b["n_rim"]
    A = b["tangent"]
    pairs = b["pairs"]
    for r in range(12 + n):
        x = r // 6 if r < 12 else 2 + (r - 12) // GROUP
        row = r % 6 if r < 12 else (r - 12) % GROUP
        for c in range(12 + n):
            y = c // 6 if c < 12 else 2 + (c - 12) // GROUP
            kk[pairs[x, y], row, c % 6 if c < 12 else (c - 12) % GROUP] += ck * A[r, c]


@kernel
def _one_support(b, f, g, fr, s, tangents):
    """Forces and tangent of one support; returns its energy."""
    n = b["n_rim"]
    moved = triple(s, 0)
    for k in range(n):
        shape = triple(s, HEAD + 3 * k)
        moved = plus(moved, b["eta"][k], shape)
        world = into_world(f["S"], shape)
        for r in range(3):
            b["shape"][k, r] = world[r]
    arm = into_world(f["S"], moved)
    reach = less(add(origin(f), arm), origin(g))
    axes = (into_world(g["S"], triple(s, 6)), into_world(g["S"], triple(s, 9)))
    d = less(reach, into_world(g["S"], triple(s, 3)))
    stiff = (s[12], s[13])
    c = (dot(axes[0], d), dot(axes[1], d))
    force = add(times(-stiff[0] * c[0], axes[0]), times(-stiff[1] * c[1], axes[1]))
    push(f, arm, force, (0.0, 0.0, 0.0), 1.0)
    push(g, reach, force, (0.0, 0.0, 0.0), -1.0)
    for k in range(n):
        fr[hidden(b, k // GROUP)]["F"][k % GROUP] += dot(triple(b["shape"][k], 0), force)
    if tangents:
        _slopes(b, arm, reach, axes)
        _stiffness(b, arm, reach, force, stiff)
    return 0.5 * (stiff[0] * c[0] * c[0] + stiff[1] * c[1] * c[1])


@kernel
def rim_support(rec, ctl, fr, kk):
    """Forces, tangents and observations of the supports of all rims."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        n = b["n_rim"]
        for k in range(n):
            b["eta"][k] = fr[hidden(b, k // GROUP)]["r"][k % GROUP]
        tangents = c["jac"] != 0 and c["ck"] != 0.0
        if tangents:
            for r in range(12 + n):
                for h in range(12 + n):
                    b["tangent"][r, h] = 0.0
        table = view(b["pool"] + 8 * b["supports"], (b["count"], HEAD + 3 * n), F8)
        energy = 0.0
        for k in range(b["count"]):
            energy += _one_support(b, f, g, fr, table[k], tangents)
        if tangents:
            _spread(b, kk, c["ck"])
        if c["out"] != 0:
            observations(ctl)[b["out"]] = energy
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return rim_support(view(rec, n, RECORD), c, fr, kk)


def spins(record: np.void) -> str:
    """Effect on the rotation of the rim: radial springs do not resist it."""
    return HOLDS if record["holds"] else FREE


KIND = Kind(
    name="rim_support",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    pairs=WITH_RIM,
    paired=RIM,
    body_fixed=True,
    massless=True,
    spins=spins,
    sections={"gears": ""},
    label="springs",
    plural="rim supports",
)
