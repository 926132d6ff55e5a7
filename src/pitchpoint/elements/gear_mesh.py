# SPDX-License-Identifier: Apache-2.0
"""Gear mesh: contact forces of two toothed bodies from the motion of their frames.

Frame channel. `mesh.line_of_action` locates the flanks, `mesh.tooth_pairs` integrates the forces along the
contact lines, this file converts the sums to wrenches, tangents and observations. The force of flank f acts
along the normal in the transverse plane plus its axial component: N_f = n_f - f tan(beta_b) m per unit of
base-tangent force.

Tangents hold mesh phase and line of action constant, as the Newton iteration and static equilibrium need.
Exact tangents, for modes about an operating point, also follow the line of action (`mesh.exact_tangent`). The
change of stiffness with the phase appears as parametric power.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pitchpoint.contact.pair_shape import FOURIER, RECTANGULAR, phase_stiffness
from pitchpoint.core.kernel import call, call_law, kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.elements.kind import FRAME, GEARED, MESH, RIM, WITH_RIM, Kind, Power
from pitchpoint.elements.mesh.eccentricity import begin_displaced, damping_alone, end_displaced, whole
from pitchpoint.elements.mesh.exact_tangent import turning
from pitchpoint.elements.mesh.flank_deviations import (
    add_roll_tangent,
    begin_separation,
    runs_damped,
    spin_direction,
)
from pitchpoint.elements.mesh.flexible_rim import bend_rim, release_rim
from pitchpoint.elements.mesh.force_directions import (
    friction_directions,
    normal_directions,
    path_direction,
    travel_direction,
)
from pitchpoint.elements.mesh.line_of_action import (
    begin_flank,
    excitation,
    flank_phase,
    line_of_action,
    motion,
    pooled,
    spin_motion,
)
from pitchpoint.elements.mesh.nodes import phase_flank
from pitchpoint.elements.mesh.observations import (
    add_flank,
    add_friction_torques,
    clear,
    contact_event,
    write_events,
    write_mesh,
)
from pitchpoint.elements.mesh.record import (
    EVENTS,
    N_OUT,
    OUTPUTS,
    PHASE,
    RECORD,
    ROWS,
    SURFACE,
    USER,
    mesh_outputs,
)
from pitchpoint.elements.mesh.sums import (
    add_spin_tangent,
    add_spin_torque,
    add_travel_torque,
    begin_damping,
    begin_request,
    begin_sums,
    end_damping,
    mesh_damper,
    push,
    push_path,
    rate_of_row,
)
from pitchpoint.elements.mesh.surface.flexible import flexible_flank
from pitchpoint.elements.mesh.surface.rigid import rigid_flank
from pitchpoint.elements.mesh.surface.tabulated import tabulated_flank
from pitchpoint.elements.mesh.tooth_pairs import deviating_line, profile_flank
from pitchpoint.multibody.channels import F8, frame_args

__all__ = ["EVENTS", "KIND", "OUTPUTS", "RECORD", "entry", "gear_mesh"]

RECORD_BYTES = RECORD.itemsize
_STEP = 1e-5
"""Maximum phase step of the difference quotient of a user stiffness law (for the parametric power only)."""
_STEP_OF_TIME = 1e-6
"""Maximum time step of the same difference quotient [s]."""


def outputs(record: np.void) -> tuple[tuple[str, str, str], ...]:
    """Observations of one record: those of every mesh, forces of the tooth pairs, friction torques."""
    return mesh_outputs(record, OUTPUTS)


def bends(record: np.void) -> tuple[str, ...]:
    """Event functions of one record at whose zeros the force has a jump or a kink.

    Contact: always. Tooth pairs: unless the stiffness is a sum of harmonics. Sliding velocity: only with
    friction, whose force reverses with it.
    """
    smooth = record["source"] == SURFACE  # tip edges come into contact smoothly
    names = tuple(name for name, _ in EVENTS if not (smooth and "pair" in name))
    if record["contact"]["mu"] > 0.0:
        return names
    harmonic = record["source"] == PHASE and record["form"] == FOURIER
    return tuple(
        name for name in names if not name.endswith("reversal") and not (harmonic and "pair" in name)
    )


@kernel
def _user_ratio(b, t, psi):
    """Ratio of the stiffness k(t, psi) of a user law to its mean."""
    if b["c_prime"] == 0.0:  # solvers remove the mesh spring in this way
        return 0.0
    return call_law(b["law"], t, psi - math.floor(psi), b["pool"] + 8 * b["params"]) / b["c_prime"]


@kernel
def _stiffness_ratio(b, t, watch):
    """Ratio of a prescribed stiffness to its mean, with its rate [1/s]; for a user law only if observed."""
    now = b["now"]
    phase_rate = now["phase_rate"][0 if now["flank"] > 0 else 1]
    if b["form"] == USER:
        rate = 0.0
        if watch:
            step = min(_STEP_OF_TIME, _STEP / max(abs(phase_rate), _STEP))
            ahead = _user_ratio(b, t + step, now["psi"] + step * phase_rate)
            rate = (ahead - _user_ratio(b, t - step, now["psi"] - step * phase_rate)) / (2.0 * step)
        return _user_ratio(b, t, now["psi"]), rate
    n = b["n_k"]
    cosine = view(pooled(b, b["cosine"]), n, F8)
    ratio, slope = phase_stiffness(now["psi"], b["form"], n, cosine, view(pooled(b, b["sine"]), n, F8))
    return ratio, slope * phase_rate


@kernel
def _flank(b, f, g, flank, x_0, spins, rate):
    """Sum one flank; `spins` 1: pure rotation of the gears with the travel rate `rate`."""
    now = b["now"]
    begin_flank(b, flank, 1.0)
    begin_sums(b)
    now["kappa"] = 0.0
    rates = b["rate"]
    if spins == 1:
        rates[0] = flank * rate
        rates[1] = 0.0
    else:
        normal_directions(b, f, g, flank)
        rows = 2
        if b["contact"]["mu"] > 0.0:
            friction_directions(b, f, g, flank)
            rows = ROWS
        for row in range(rows):
            rates[row] = rate_of_row(b, f, g, row)
        rates[0] -= flank * now["e_rate"]
    if b["request"]["out"] != 0 or b["request"]["ev"] != 0:
        return _sum(b, 1, x_0)
    return _sum(b, None, x_0)


@kernel
def _sum(b, watch, x_0):
    """Sum the nodes of one flank; see `mesh.sums` for `watch`."""
    now = b["now"]
    now["tilt"] = now["kappa"]
    now["growth"] = 0.0
    if b["source"] == SURFACE:
        now["x_0"] = x_0
        level = b["flexible"] if b["is_flexible"] == 1 else b["rigid"]
        if b["is_tabulated"] == 1:
            level = b["tabulated"]
        return call(level, b["here"], 1 if watch is not None else 0, 0)
    if b["source"] == PHASE:
        ratio, rate = _stiffness_ratio(b, b["request"]["t"], watch is not None)
        if not math.isfinite(ratio):
            return NOT_FINITE
        phase_flank(b, watch, x_0, ratio, rate)
    else:
        now["tilt"] = now["kappa"] * (1.0 + b["tan_b"] * b["tan_b"])
        now["growth"] = (now["hi_rate"] - now["lo_rate"]) / (now["z_hi"] - now["z_lo"])
        if b["n_sep"] > 0:
            begin_separation(b)
        profile_flank(b, watch, x_0)
    return OK


@kernel
def _turning(b, f, g, flank, x_0):
    """Exact tangents: add the derivative by the line of action; sums the flank again for its damping."""
    kept = begin_damping(b)
    _flank(b, f, g, flank, x_0, 0, 0.0)
    end_damping(b, kept)
    call(b["turning"], b["here"], flank, 0)


@kernel
def _slack(b):
    """Upper bound of the additional penetration of a tilted flank beyond that at mid-face."""
    now = b["now"]
    dn = now["dn"]
    xi_A = now["xi_A"]
    xi_E = xi_A + now["eps"] * b["p_bt"]
    lever = 0.5 * (b["b1"] + b["b2"]) + abs(b["tan_b"]) * (abs(xi_A) + abs(xi_E) + b["b1"] + b["b2"])
    skew = b["skew"]
    return lever * (abs(dn[0]) + abs(dn[1]) + abs(dn[2]) + abs(skew[0]) + abs(skew[1]))


@kernel
def _pair_leaves(b):
    """Path position at which a pair leaves contact [base pitches]; rectangular wave: its falling edge."""
    if b["source"] == PHASE and b["form"] == RECTANGULAR:
        return view(pooled(b, b["cosine"]), 3, F8)[2]
    return b["now"]["eps"]


@kernel
def _observe_flank(b, f, g, flank):
    """Add the sums of one flank to the observations."""
    now = b["now"]
    F = b["sums"]["force"][0]
    parts = (flank * F * now["cos_a"], F * now["sin_a"], -flank * F * b["tan_b"])
    add_flank(b, flank, F, parts, -flank * F * now["e_rate"])


@kernel
def _one_mesh(b, fr, kk):
    """Wrenches, tangents and observations of one mesh, as its `request` requires."""
    now = b["now"]
    request = b["request"]
    f = fr[request["i"]]
    g = fr[request["j"]]
    status = line_of_action(b, f, g)
    if status != OK:
        return status
    rubs = b["contact"]["mu"] > 0.0
    spins = 1 if b["fixed"] == 1 and not rubs else 0
    watch = request["out"] != 0
    u_rate = 0.0
    if b["fixed"] == 1:
        spin_motion(b, f["spin"], g["spin"])
        u_rate = b["r_b1"] * f["spin"] + b["r_b2"] * g["spin"]
    elif b["n_e"] > 0 or runs_damped(b) or watch or request["ev"] != 0 or b["source"] == SURFACE:
        motion(b, f, g)
    psi = flank_phase(b, 1)
    psi -= math.floor(psi)
    excitation(b, f, g, psi)
    u_rate -= now["e_rate"]
    if watch:
        clear(b, N_OUT)
    x = now["u"] - now["e_t"]
    slack = 0.0 if spins == 1 else _slack(b)
    force = 0.0
    front = contact_event(x - 0.5 * now["gap"] - b["sep_min"], 0.0)
    back = contact_event(-x - 0.5 * now["gap"] - b["sep_min"], 0.0)
    tangent = 0.0
    exact = request["jac"] == 2 and request["ck"] != 0.0 and b["fixed"] == 0
    if now["eps"] > 0.0 and now["z_hi"] > now["z_lo"]:
        for flank in (1, -1):
            x_0 = flank * x - 0.5 * now["gap"]
            # no contact while even the deepest corner of the flank is separated
            if x_0 + slack <= b["sep_min"]:
                continue
            status = _flank(b, f, g, flank, x_0, spins, u_rate)
            if status != OK:
                return status
            sums = b["sums"]
            if flank > 0:
                front = contact_event(sums["nearest"], sums["pushed"])
            else:
                back = contact_event(sums["nearest"], sums["pushed"])
            if watch:
                _observe_flank(b, f, g, flank)
            if spins == 1:
                force += flank * sums["force"][0]
                tangent += sums["tangent"][0, 0]
                if b["source"] == SURFACE:
                    add_travel_torque(b, f, g)
                if request["jac"] != 0 and runs_damped(b):
                    spin_direction(b)
                    add_roll_tangent(b, kk, 1)
            else:
                push(b, f, g, kk, ROWS if rubs else 2)
                if watch:
                    add_friction_torques(b, N_OUT, f, g)
                if request["jac"] != 0 and runs_damped(b):
                    add_roll_tangent(b, kk, ROWS if rubs else 2)
                if b["source"] == SURFACE:
                    path_direction(b, f, g)
                    push_path(b, f, g)
                if exact:
                    _turning(b, f, g, flank, x_0)
    damper = 0.0
    if b["d_now"] > 0.0:
        if spins == 1:
            damper = b["d_now"] * u_rate
            force += damper
            tangent += request["cd"] * b["d_now"]
        else:
            travel_direction(b, f, g)
            damper, u_rate = mesh_damper(b, f, g, kk, now["e_rate"])
            if exact:
                call(b["turning"], b["here"], 0, 0)
    if spins == 1:
        add_spin_torque(b, f, g, force)
        if request["jac"] != 0:
            add_spin_tangent(b, kk, tangent)
    if watch:
        write_mesh(b, now["e_rate"], psi, damper, u_rate)
    if request["ev"] != 0:
        write_events(b, x, front, back, _pair_leaves(b))
    return OK


@kernel
def _displaced_mesh(b, ctl, fr, kk):
    """Evaluate the mesh of gears that are eccentric or wobble on their bodies, or whose rim bends."""
    frames = begin_displaced(b, fr)
    if b["n_rim"] > 0:
        call(b["bend_rim"], b["here"], ctl["at"], 0)
    request = b["request"]
    status = OK
    if request["jac"] == 2 and request["ck"] != 0.0:
        kept = begin_damping(b)
        status = _one_mesh(b, frames, damping_alone(b))
        end_damping(b, kept)
        request["jac"] = 2
    status = max(status, _one_mesh(b, frames, whole(b, frames)))
    if b["n_rim"] > 0:
        call(b["release_rim"], b["here"], ctl["at"], 0)
    end_displaced(b, ctl, fr, kk, frames)
    return status


@kernel(inline=True)
def gear_mesh(rec, ctl, fr, kk):
    """Wrenches, tangents and observations of all meshes; see the module text."""
    for r in range(rec.size):
        b = rec[r]
        begin_request(b, ctl[0])
        if b["displaced"] == 1:
            status = _displaced_mesh(b, ctl[0], fr, kk)
        else:
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
        records[r]["here"] = rec + r * RECORD_BYTES
    return gear_mesh(records, c, fr, kk)


def law_call(record: np.void, frames: Any, pool: Any, t: float) -> tuple[float, int, int]:
    """Mesh phase and parameters of the user's stiffness law."""
    return float(record["now"]["psi"]), int(record["params"]), len(pool)


KIND = Kind(
    name="gear_mesh",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=outputs,
    events=EVENTS,
    bends=bends,
    exact={"turning": turning},
    some={
        "deviating": (deviating_line, "n_sep"),
        "rigid": (rigid_flank, "is_rigid"),
        "flexible": (flexible_flank, "is_flexible"),
        "tabulated": (tabulated_flank, "is_tabulated"),
        "bend_rim": (bend_rim, "n_rim"),
        "release_rim": (release_rim, "n_rim"),
    },
    pairs=WITH_RIM,
    paired=RIM,
    role=MESH,
    massless=True,
    spins=GEARED,
    sections={"meshes": ""},
    label="mesh",
    main=True,
    power=Power(),
    law_call=law_call,
)
