# SPDX-License-Identifier: Apache-2.0
"""Bevel mesh: contact forces of two bevel gears from the motion of their frames.

Frame channel. `mesh.bevel.plane_of_action` locates the flanks and sets the rows of a wrench basis along which
they act, `mesh.bevel.flank_forces` integrates the forces along the contact lines, this file converts the sums
to wrenches, tangents and observations. Straight and spiral teeth, any shaft angle, all pairs in contact, both
flanks, with partial contact along the face width if the axes are tilted.

Tangents hold mesh phase and plane of action constant; exact tangents follow the plane of action
(`mesh.bevel.exact_tangent`). Quantities along the base tangent refer to the mean cone distance: mesh_force
times the base radius there is the torque, its derivative by the travel is the stiffness.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import call, kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import FRAME, GEARED, MESH, Kind, Power
from pitchpoint.elements.mesh.bevel.exact_tangent import turning
from pitchpoint.elements.mesh.bevel.flank_forces import sum_flank
from pitchpoint.elements.mesh.bevel.plane_of_action import (
    axes_of_action,
    friction_rows,
    normal_rows,
    place_flanks,
    rates_of_place,
)
from pitchpoint.elements.mesh.bevel.record import EVENTS, N_OUT, OUTPUTS, PHASE, RECORD, ROWS, mesh_outputs
from pitchpoint.elements.mesh.line_of_action import begin_flank, countable, flank_phase
from pitchpoint.elements.mesh.observations import (
    add_flank,
    add_friction_torques,
    clear,
    contact_event,
    write_events,
    write_mesh,
)
from pitchpoint.elements.mesh.sums import (
    begin_damping,
    begin_request,
    begin_sums,
    end_damping,
    mesh_damper,
    push,
    rate_of_row,
)
from pitchpoint.multibody.channels import frame_args
from pitchpoint.multibody.vectors import add, dot, times, triple

__all__ = ["EVENTS", "KIND", "OUTPUTS", "RECORD", "bevel_mesh", "entry"]


OBSERVED = np.dtype([(name, "f8") for name, _, _ in OUTPUTS])
_BYTES = RECORD.itemsize


def outputs(record: np.void) -> tuple[tuple[str, str, str], ...]:
    """Observations of one record: those of every mesh, forces of the tooth pairs, friction torques."""
    return mesh_outputs(record, OUTPUTS)


def bends(record: np.void) -> tuple[str, ...]:
    """Event functions of one record at whose zeros the force has a jump or a kink."""
    pairs = record["source"] != PHASE
    names = tuple(name for name, _ in EVENTS)
    if record["contact"]["mu"] > 0.0:
        return names
    return tuple(n for n in names if not n.endswith("reversal") and (pairs or "pair" not in n))


@kernel
def begin_side(b, flank, x):
    """Set phase, contact lines, penetration and basis rows of one flank in the scratch."""
    now = b["now"]
    begin_flank(b, flank, b["R_m"])
    normal_rows(b, flank)
    d = triple(now["d"], 0)
    for k in range(2):
        now["x"][k] = dot(triple(b["basis_j"][k], 0), d)
    now["x"][2] = (flank * (x - now["aside"][0]) - 0.5 * (now["gap"] - now["aside"][1])) / b["R_m"]


@kernel
def _touches(b):
    """Whether any point of the common face may be in contact."""
    x = b["now"]["x"]
    per_R = x[2] - b["sep_min"] / b["R_m"]
    R = b["R_m"] + (b["z_lo"] if per_R < 0.0 else b["z_hi"])
    return R * per_R + math.sqrt(x[0] * x[0] + x[1] * x[1]) > 0.0


@kernel
def _sum(b, f, g):
    """Sum the current flank; rows and rates remain in the scratch. Returns the number of rows in use."""
    rows = ROWS - 3
    if b["contact"]["mu"] > 0.0:
        friction_rows(b, f, g)
        rows = ROWS
    for row in range(rows):
        b["rate"][row] = rate_of_row(b, f, g, row)
    begin_sums(b)
    if b["request"]["out"] != 0 or b["request"]["ev"] != 0:
        sum_flank(b, 1)
    else:
        sum_flank(b, None)
    return rows


@kernel
def _follow(b, f, g, flank):
    """Exact tangents: add the derivative by the plane of action; sums the flank again for its damping."""
    kept = begin_damping(b)
    _sum(b, f, g)
    end_damping(b, kept)
    call(b["turning"], b["here"], flank, 0)
    normal_rows(b, flank)


@kernel
def _observe_flank(b, flank):
    """Add one flank to the observations; the first two rows give the force on gear 2."""
    now = b["now"]
    force = b["sums"]["force"]
    V = add(times(force[0], triple(b["basis_j"][0], 0)), times(force[1], triple(b["basis_j"][1], 0)))
    parts = (
        dot(V, triple(now["t"], 0)),
        dot(V, triple(now["away"][1], 0)),
        dot(V, triple(now["axis"][1], 0)),
    )
    add_flank(b, flank, force[2] / b["R_m"], parts, 0.0)
    out = view(b["request"]["out"], 1, OBSERVED)[0]
    out["radial_force_1"] += dot(V, triple(now["away"][0], 0))
    out["axial_force_1"] -= dot(V, triple(now["axis"][0], 0))


@kernel
def _one_mesh(b, fr, kk):
    """Wrenches, tangents and observations of one mesh, as its `request` requires."""
    now = b["now"]
    request = b["request"]
    f = fr[request["i"]]
    g = fr[request["j"]]
    status = axes_of_action(b, f, g)
    if status != OK:
        return status
    place_flanks(b, f, g)
    status = countable(now["u"], now["travel"], b["p_bt"], now["eps"])
    if status != OK:
        return status
    watch = request["out"] != 0
    if watch or request["ev"] != 0:
        rates_of_place(b, f, g)
    if watch:
        clear(b, N_OUT)
    exact = request["jac"] == 2 and request["ck"] != 0.0
    x = now["u"]
    front = contact_event(x - 0.5 * now["gap"] - b["sep_min"], 0.0)
    back = contact_event(-x - 0.5 * now["gap"] - b["sep_min"], 0.0)
    for flank in (1, -1):
        begin_side(b, flank, x)
        if now["eps"] <= 0.0 or not _touches(b):
            continue
        rows = _sum(b, f, g)
        nearest = contact_event(b["sums"]["nearest"], b["sums"]["pushed"])
        if flank > 0:
            front = nearest
        else:
            back = nearest
        push(b, f, g, kk, rows)
        if watch:
            _observe_flank(b, flank)
            add_friction_torques(b, N_OUT, f, g)
        if exact:
            _follow(b, f, g, flank)
    force = 0.0
    rate = 0.0
    if b["d_now"] > 0.0:
        normal_rows(b, 0)
        force, rate = mesh_damper(b, f, g, kk, 0.0)
        if exact:
            call(b["turning"], b["here"], 0, 0)
    if watch:
        psi = flank_phase(b, 1)
        write_mesh(b, 0.0, psi - math.floor(psi), force, rate)
    if request["ev"] != 0:
        write_events(b, x, front, back, now["eps"])
    return OK


@kernel(inline=True)
def bevel_mesh(rec, ctl, fr, kk):
    """Wrenches, tangents and observations of all bevel meshes; see the module text."""
    for r in range(rec.size):
        b = rec[r]
        begin_request(b, ctl[0])
        status = _one_mesh(b, fr, kk)
        if status != OK:
            ctl[0]["bad"] = r
            return status
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    records = view(rec, n, RECORD)
    for r in range(n):
        records[r]["here"] = rec + r * _BYTES
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
