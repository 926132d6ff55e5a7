# SPDX-License-Identifier: Apache-2.0
"""Bevel mesh: force of two bevel gears on each other, from their frames alone.

Frame channel. `bevel_mesh_place` finds where the flanks are and along which rows of a wrench basis they push,
`bevel_mesh_sums` adds up what they do along their contact lines, this file turns the sums into wrenches,
tangents and observations. Straight and spiral teeth, any shaft angle, all pairs in contact, both flanks, open
along a part of the width where gears lean.

Tangents hold at frozen mesh phase and frozen plane of action, exact ones follow the plane of action
(`bevel_mesh_turning`). Quantities along the base tangent are those at the mean cone distance: mesh_force
times a base radius there is the torque, its slope over the travel is the stiffness.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import call, kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.bevel_mesh_place import (
    axes_of_action,
    friction_rows,
    normal_rows,
    phase_of_flank,
    place_flanks,
    rate_of_row,
    rates_of_place,
)
from pitchpoint.elements.bevel_mesh_record import EVENTS, N_OUT, OUTPUTS, PHASE, RECORD, ROWS, mesh_outputs
from pitchpoint.elements.bevel_mesh_sums import (
    DAMPING,
    ENERGY,
    FORCE,
    FRICTION,
    NEAREST,
    PARAMETRIC,
    STIFFNESS,
    begin_sums,
    sum_flank,
)
from pitchpoint.elements.bevel_mesh_turning import turning
from pitchpoint.elements.kind import FRAME, GEARED, MESH, Kind, Power
from pitchpoint.elements.mesh_friction import add_friction_torques
from pitchpoint.elements.mesh_line import countable
from pitchpoint.multibody.channels import bounded, events, frame_args, observations
from pitchpoint.multibody.vectors import add, dot, times, triple

__all__ = ["EVENTS", "KIND", "OUTPUTS", "RECORD", "bevel_mesh", "entry"]


_LEAST = 1e-15
"""Least distance [m] of an event function from contact: it says on which side it is."""
_AWAY = 10.0
"""Added to the event functions of the flank that is farther from contact: no sign changes there."""
_BYTES = RECORD.itemsize


def outputs(record: np.void) -> tuple[tuple[str, str, str], ...]:
    """Observations of one record: those of every mesh, the forces of its tooth pairs, torques of friction."""
    return mesh_outputs(record, OUTPUTS)


def bends(record: np.void) -> tuple[str, ...]:
    """Event functions of one record at whose zeros forces jump or bend: pairs count where there are any."""
    pairs = record["source"] != PHASE
    names = tuple(name for name, _ in EVENTS)
    if record["mu"] > 0.0:
        return names
    return tuple(n for n in names if not n.endswith("reversal") and (pairs or "pair" not in n))


@kernel
def _begin(b, flank, x):
    """Phase, contact lines and penetration of one flank, into the scratch; its rows of the basis."""
    b["flank"] = flank
    psi = phase_of_flank(b, flank)
    whole = math.floor(psi)
    b["psi"] = psi - whole
    b["tooth"] = int(whole) + flank * b["turn"]
    b["lam"] = flank * b["tan_b"] * b["R_m"] / b["p_bt"]
    normal_rows(b, flank)
    d = triple(b["d"], 0)
    for k in range(2):
        b["x"][k] = dot(triple(b["basis_j"][k], 0), d)
    b["x"][2] = (flank * (x - b["aside"][0]) - 0.5 * (b["gap"] - b["aside"][1])) / b["R_m"]


@kernel
def _touches(b):
    """Whether any place of the shared face may be in contact."""
    x = b["x"]
    per_R = x[2] - b["sep_min"] / b["R_m"]
    R = b["R_m"] + (b["z_lo"] if per_R < 0.0 else b["z_hi"])
    return R * per_R + math.sqrt(x[0] * x[0] + x[1] * x[1]) > 0.0


@kernel
def _sum(b, ctl, f, g):
    """Sum the current flank; rows and rates stand afterwards."""
    rows = 3
    if b["mu"] > 0.0:
        friction_rows(b, f, g)
        rows = ROWS
    for row in range(rows):
        b["w"][row] = rate_of_row(b, f, g, row)
    begin_sums(b)
    if ctl["out"] != 0 or ctl["ev"] != 0:
        sum_flank(b, ctl, 1)
    else:
        sum_flank(b, ctl, None)


@kernel
def _push(b, f, g, kk, rows, jac):
    """Add the summed forces of the rows to both bodies, and their tangents."""
    for p in range(rows):
        for k in range(6):
            f["F"][k] += b["acc"][p] * b["basis_i"][p, k]
            g["F"][k] += b["acc"][p] * b["basis_j"][p, k]
        for q in range(rows if jac != 0 else 0):
            c = b["T"][p, q]
            if c != 0.0:
                _tangent(b, kk, c, p, q)


@kernel
def _tangent(b, kk, c, p, q):
    """Add c times the product of two rows to the four pair blocks."""
    for k in range(6):
        one = c * b["basis_i"][p, k]
        two = c * b["basis_j"][p, k]
        for n in range(6):
            kk[b["ii"], k, n] += one * b["basis_i"][q, n]
            kk[b["ij"], k, n] += one * b["basis_j"][q, n]
            kk[b["ji"], k, n] += two * b["basis_i"][q, n]
            kk[b["jj"], k, n] += two * b["basis_j"][q, n]


@kernel
def _follow(b, ctl, f, g, flank):
    """Exact tangents: add what turns with the plane of action; the flank is summed again for its damping."""
    kept = (ctl["ck"], ctl["cd"], ctl["out"], ctl["ev"])
    ctl["ck"] = 0.0
    ctl["cd"] = 1.0
    ctl["out"] = 0
    ctl["ev"] = 0
    _sum(b, ctl, f, g)
    ctl["ck"], ctl["cd"], ctl["out"], ctl["ev"] = kept
    call(b["turning"], b["here"], b["control"], flank)
    normal_rows(b, flank)


@kernel
def _damper(b, ctl, f, g, kk):
    """Damper along the travel, in the gap too; returns its force and its rate."""
    normal_rows(b, 0)
    rate = rate_of_row(b, f, g, 0)
    begin_sums(b)
    b["acc"][0] = b["d_gap"] * rate
    b["T"][0, 0] = ctl["cd"] * b["d_gap"]
    _push(b, f, g, kk, 1, ctl["jac"])
    if ctl["jac"] == 2 and ctl["ck"] != 0.0:
        b["T"][0, 0] = b["d_gap"]
        call(b["turning"], b["here"], b["control"], 0)
    return b["d_gap"] * rate, rate


@kernel
def _write_flank(b, out, flank):
    """Add one flank to the observations, where its pairs are already; the force on gear 2 is that of the
    first two rows."""
    k = b["out"]
    acc = b["acc"]
    more = b["more"]
    V = add(times(acc[0], triple(b["basis_j"][0], 0)), times(acc[1], triple(b["basis_j"][1], 0)))
    if more[FORCE] > 0.0:
        out[k + 5] = 2.0 if out[k + 5] == 1.0 else float(flank)
    out[k + 2] += flank * acc[2] / b["R_m"]
    out[k + 3] += more[STIFFNESS]
    out[k + 6] += more[FORCE] * math.sqrt(1.0 + b["tan_b"] * b["tan_b"])
    out[k + 7] += dot(V, triple(b["t"], 0))
    out[k + 8] += dot(V, triple(b["away"][1], 0))
    out[k + 9] += dot(V, triple(b["axis"][1], 0))
    out[k + 10] += more[FRICTION]
    out[k + 11] += more[DAMPING]
    out[k + 12] += more[PARAMETRIC]
    out[k + 13] += more[ENERGY]
    out[k + 15] += dot(V, triple(b["away"][0], 0))
    out[k + 16] -= dot(V, triple(b["axis"][0], 0))


@kernel
def _write(b, out, psi, force, rate):
    """Observations that do not depend on the flank, and those of the damper."""
    k = b["out"]
    out[k] = b["u"]
    out[k + 1] = b["u"]
    out[k + 2] += force
    out[k + 4] = psi
    out[k + 11] += force * rate
    out[k + 14] = (abs(b["u"]) - 0.5 * b["gap"]) / math.sqrt(1.0 + b["tan_b"] * b["tan_b"])


@kernel
def _nearest_pitch(psi):
    """Distance from the nearest whole base pitch, in [-1/2, 1/2]."""
    return psi - math.floor(psi + 0.5)


@kernel
def _contact(distance, force):
    """Distance from contact [m] as an event function: positive where the flank pushes, else negative."""
    return max(distance, _LEAST) if force > 0.0 else min(distance, -_LEAST)


@kernel
def _write_events(b, ev, front, back):
    """Event functions; those of contact are known. See `gear_mesh_record`."""
    k = b["ev"]
    ev[k] = front
    ev[k + 1] = back
    ev[k + 2] = bounded(b["travel_rate"])
    pitch = b["xi_A"] / b["p_bt"]
    for flank in (1, -1):
        k += 3
        away = _AWAY if flank * b["u"] < 0.0 else 0.0
        psi = phase_of_flank(b, flank)
        ev[k] = away + _nearest_pitch(psi)
        ev[k + 1] = away + _nearest_pitch(psi - b["eps"])
        ev[k + 2] = away + _nearest_pitch(psi + pitch)


@kernel
def _one_mesh(b, ctl, fr, kk):
    """Wrenches, tangents and observations of one mesh."""
    c = ctl[0]
    f = fr[b["i"]]
    g = fr[b["j"]]
    status = axes_of_action(b, f, g)
    if status != OK:
        return status
    place_flanks(b, f, g)
    status = countable(b["u"], b["travel"], b["p_bt"], b["eps"])
    if status != OK:
        return status
    watch = c["out"] != 0
    if watch or c["ev"] != 0:
        rates_of_place(b, f, g)
    if watch:
        out = observations(ctl)
        for k in range(N_OUT + b["n_pair"] + 2 * b["rubs"]):
            out[b["out"] + k] = 0.0
    exact = c["jac"] == 2 and c["ck"] != 0.0
    x = b["u"]
    front = _contact(x - 0.5 * b["gap"] - b["sep_min"], 0.0)
    back = _contact(-x - 0.5 * b["gap"] - b["sep_min"], 0.0)
    for flank in (1, -1):
        _begin(b, flank, x)
        if b["eps"] <= 0.0 or not _touches(b):
            continue
        _sum(b, c, f, g)
        nearest = _contact(b["more"][NEAREST], b["more"][FORCE])
        if flank > 0:
            front = nearest
        else:
            back = nearest
        _push(b, f, g, kk, ROWS if b["mu"] > 0.0 else 3, c["jac"])
        if watch:
            _write_flank(b, observations(ctl), flank)
            if b["rubs"] == 1 and b["mu"] > 0.0:
                add_friction_torques(b, observations(ctl), b["out"] + N_OUT + b["n_pair"], f, g, 3)
        if exact:
            _follow(b, c, f, g, flank)
    force = 0.0
    rate = 0.0
    if b["d_gap"] > 0.0:
        force, rate = _damper(b, c, f, g, kk)
    if watch:
        psi = phase_of_flank(b, 1)
        _write(b, observations(ctl), psi - math.floor(psi), force, rate)
    if c["ev"] != 0:
        _write_events(b, events(ctl), front, back)
    return OK


@kernel(inline=True)
def bevel_mesh(rec, ctl, fr, kk):
    """Wrenches, tangents and observations of all bevel meshes; see the module text."""
    for r in range(rec.size):
        status = _one_mesh(rec[r], ctl, fr, kk)
        if status != OK:
            ctl[0]["bad"] = r
            return status
    return OK


@kernel
def entry(ctl, rec, n):
    """Uniform entry of the kind."""
    c, fr, kk = frame_args(ctl)
    records = view(rec, n, RECORD)
    for r in range(n):
        records[r]["here"] = rec + r * _BYTES
        records[r]["control"] = ctl
    return bevel_mesh(records, c, fr, kk)


KIND = Kind(
    name="bevel_mesh",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=outputs,
    events=EVENTS,
    bends=bends,
    exact={"turning": turning},
    role=MESH,
    massless=True,
    spins=GEARED,
    sections={"bevel_meshes": ""},
    label="mesh",
    main=True,
    power=Power(),
)
