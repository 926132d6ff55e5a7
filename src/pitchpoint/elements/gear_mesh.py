# SPDX-License-Identifier: Apache-2.0
"""Gear mesh: force of two toothed bodies on each other, from their frames alone.

Frame channel. `mesh_line` finds where the flanks are, `mesh_pairs` sums what they do along their contact
lines, this file turns the sums into wrenches, tangents and observations. Forces act along the normal in the
transverse plane of each flank plus their axial share: N_f = n_f - f tan(beta_b) m per unit of base-tangent
force.

Tangents hold at frozen mesh phase and frozen line of action: what the Newton iteration and static equilibrium
need. Exact ones, for modes about an operating point, follow the line of action too (`mesh_turning`). The
change of the stiffness with the phase shows up as parametric power.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.contact.pair_shape import FOURIER, RECTANGULAR, phase_stiffness
from pitchpoint.core.kernel import call, call_law, kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.elements.gear_mesh_record import (
    EVENTS,
    N_ACC,
    NEAREST,
    OUTPUTS,
    PHASE,
    RECORD,
    USER,
    mesh_outputs,
)
from pitchpoint.elements.kind import FRAME, GEARED, MESH, Kind, Power
from pitchpoint.elements.mesh_apart import apart
from pitchpoint.elements.mesh_eccentric import begin_displaced, damping_alone, end_displaced, whole
from pitchpoint.elements.mesh_gradient import normal_directions
from pitchpoint.elements.mesh_line import (
    excitation,
    flank_phase,
    line_of_action,
    pooled,
)
from pitchpoint.elements.mesh_motion import motion, spin_motion
from pitchpoint.elements.mesh_nodes import phase_flank
from pitchpoint.elements.mesh_observed import clear, write_flank, write_friction_torques, write_mesh
from pitchpoint.elements.mesh_pairs import profile_flank
from pitchpoint.elements.mesh_separation import (
    add_roll_tangent,
    begin_separation,
    runs_damped,
    spin_direction,
)
from pitchpoint.elements.mesh_turning import turning
from pitchpoint.elements.mesh_wrench import (
    add_spin_tangent,
    add_spin_torque,
    add_tangent,
    add_wrench,
    flank_rates,
    friction_directions,
    mesh_damper,
    spin_flank_rates,
)
from pitchpoint.multibody.channels import F8, bounded, events, frame_args, observations

__all__ = ["EVENTS", "KIND", "OUTPUTS", "RECORD", "entry", "gear_mesh"]


_LEAST = 1e-15
"""Least distance [m] of an event function from contact: it says on which side it is."""

_NOWHERE = -0.1
"""Distance from contact [m] of a flank without stiffness: no pair of teeth is there."""

RECORD_BYTES = RECORD.itemsize
#: Added to the event functions of the flank that is farther from contact: no sign changes there.
AWAY = 10.0

_STEP = 1e-5
"""Largest step of phase for the rate of a user's stiffness law; only the parametric power needs it."""
_STEP_OF_TIME = 1e-6
"""Largest step of time for the same [s]."""


def outputs(record: np.void) -> tuple[tuple[str, str, str], ...]:
    """Observations of one record: those of every mesh, the forces of its tooth pairs, torques of friction."""
    return mesh_outputs(record, OUTPUTS)


def bends(record: np.void) -> tuple[str, ...]:
    """Event functions of one record at whose zeros forces jump or bend.

    Those of contact always; those of pairs unless the stiffness is a sum of harmonics; where sliding turns
    round only if there is friction, which turns with it.
    """
    names = tuple(name for name, _ in EVENTS)
    if record["mu"] > 0.0:
        return names
    harmonic = record["source"] == PHASE and record["form"] == FOURIER
    return tuple(
        name for name in names if not name.endswith("reversal") and not (harmonic and "pair" in name)
    )


@kernel
def _begin(b, flank):
    """Phase and contact-line slope of one flank, into the scratch; empty sums."""
    b["flank"] = flank
    psi = flank_phase(b, flank)
    whole = math.floor(psi)
    b["psi"] = psi - whole
    b["tooth"] = int(whole) + flank * b["turn"]
    b["lam"] = flank * b["tan_b"] / b["p_bt"]
    acc = b["acc"]
    for k in range(N_ACC):
        acc[k] = 0.0
    acc[NEAREST] = _NOWHERE


@kernel
def _user_ratio(b, t, psi):
    """k(t, psi)/mean by a user's law."""
    if b["c_prime"] == 0.0:  # solvers take the spring of a mesh out like this
        return 0.0
    return call_law(b["law"], t, psi - math.floor(psi), b["pool"] + 8 * b["params"]) / b["c_prime"]


@kernel
def _stiffness_ratio(b, t, watch):
    """k/mean of a prescribed stiffness and its rate [1/s]; that of a user's law only if observed."""
    phase_rate = b["phase_rate"][0 if b["flank"] > 0 else 1]
    if b["form"] == USER:
        rate = 0.0
        if watch:
            step = min(_STEP_OF_TIME, _STEP / max(abs(phase_rate), _STEP))
            ahead = _user_ratio(b, t + step, b["psi"] + step * phase_rate)
            rate = (ahead - _user_ratio(b, t - step, b["psi"] - step * phase_rate)) / (2.0 * step)
        return _user_ratio(b, t, b["psi"]), rate
    n = b["n_k"]
    cosine = view(pooled(b, b["cosine"]), n, F8)
    ratio, slope = phase_stiffness(b["psi"], b["form"], n, cosine, view(pooled(b, b["sine"]), n, F8))
    return ratio, slope * phase_rate


@kernel
def _flank(b, ctl, f, g, flank, x_0, spins, rate):
    """Sum one flank into `acc`; `spins` 1: the gears only spin and their travel rate is `rate`."""
    watched = ctl["out"] != 0 or ctl["ev"] != 0
    _begin(b, flank)
    b["kappa"] = 0.0
    if spins == 1:
        spin_flank_rates(b, rate)
    else:
        normal_directions(b, f, g, flank)
        if b["mu"] > 0.0:
            friction_directions(b, f, g, flank)
        flank_rates(b, f, g)
    if watched:
        return _sum(b, ctl, 1, x_0)
    return _sum(b, ctl, None, x_0)


@kernel
def _sum(b, ctl, watch, x_0):
    """Sum the nodes of one flank; see `mesh_nodes` for `watch`."""
    b["tilt"] = b["kappa"]
    b["growth"] = 0.0
    if b["source"] == PHASE:
        ratio, rate = _stiffness_ratio(b, ctl["t"], watch is not None)
        if not math.isfinite(ratio):
            return NOT_FINITE
        phase_flank(b, ctl, watch, x_0, ratio, rate)
    else:
        b["tilt"] = b["kappa"] * (1.0 + b["tan_b"] * b["tan_b"])
        b["growth"] = (b["hi_rate"] - b["lo_rate"]) / (b["z_hi"] - b["z_lo"])
        if b["n_sep"] > 0:
            begin_separation(b)
        profile_flank(b, ctl, watch, x_0)
    return OK


@kernel
def _turning(b, c, f, g, flank, x_0):
    """Exact tangents: add what turns with the line of action; the flank is summed again for its damping."""
    kept = (c["ck"], c["cd"], c["out"], c["ev"])
    c["ck"] = 0.0
    c["cd"] = 1.0
    c["out"] = 0
    c["ev"] = 0
    _flank(b, c, f, g, flank, x_0, 0, 0.0)
    c["ck"], c["cd"], c["out"], c["ev"] = kept
    call(b["turning"], b["here"], b["control"], flank)


@kernel
def _slack(b):
    """How much deeper than the middle of the face a tilted flank can reach."""
    dn = b["dn"]
    xi_A = b["xi_A"]
    xi_E = xi_A + b["eps"] * b["p_bt"]
    lever = 0.5 * (b["b1"] + b["b2"]) + abs(b["tan_b"]) * (abs(xi_A) + abs(xi_E) + b["b1"] + b["b2"])
    skew = b["skew"]
    return lever * (abs(dn[0]) + abs(dn[1]) + abs(dn[2]) + abs(skew[0]) + abs(skew[1]))


@kernel
def _place(psi):
    """Distance from the nearest whole base pitch, in [-1/2, 1/2]."""
    return psi - math.floor(psi + 0.5)


@kernel
def _contact(distance, force):
    """Distance from contact [m] as an event function: positive where the flank pushes, else negative."""
    return max(distance, _LEAST) if force > 0.0 else min(distance, -_LEAST)


@kernel
def _roots(b, ev, x, front, back):
    """Event functions at the deflection x; those of contact are known. See `gear_mesh_record`."""
    k = b["ev"]
    ev[k] = front
    ev[k + 1] = back
    ev[k + 2] = bounded(b["travel_rate"])
    leaves = b["eps"]
    if b["source"] == PHASE and b["form"] == RECTANGULAR:
        leaves = view(pooled(b, b["cosine"]), 3, F8)[2]  # the second jump of the wave
    for flank in (1, -1):
        away = AWAY if flank * x < 0.0 else 0.0
        psi = flank_phase(b, flank)
        k += 3
        ev[k] = away + _place(psi)
        ev[k + 1] = away + _place(psi - leaves)
        ev[k + 2] = away + _place(psi + b["xi_A"] / b["p_bt"])


@kernel
def _one_mesh(b, ctl, fr, kk):
    """Wrenches, tangents and observations of one mesh."""
    c = ctl[0]
    f = fr[b["i"]]
    g = fr[b["j"]]
    status = line_of_action(b, f, g)
    if status != OK:
        return status
    spins = 1 if b["fixed"] == 1 and b["mu"] == 0.0 else 0
    u_rate = 0.0
    if b["fixed"] == 1:
        spin_motion(b, f["spin"], g["spin"])
        u_rate = b["r_b1"] * f["spin"] + b["r_b2"] * g["spin"]
    elif b["n_e"] > 0 or runs_damped(b) or c["out"] != 0 or c["ev"] != 0:
        motion(b, f, g)
    psi = flank_phase(b, 1)
    psi -= math.floor(psi)
    excitation(b, f, g, psi)
    u_rate -= b["e_rate"]
    watch = c["out"] != 0
    if watch:
        clear(b, observations(ctl))
    x = b["u"] - b["e_t"]
    slack = 0.0 if spins == 1 else _slack(b)
    force = 0.0
    front = _contact(x - 0.5 * b["gap"] - b["sep_min"], 0.0)
    back = _contact(-x - 0.5 * b["gap"] - b["sep_min"], 0.0)
    tangent = 0.0
    exact = c["jac"] == 2 and c["ck"] != 0.0 and b["fixed"] == 0
    if b["eps"] > 0.0 and b["z_hi"] > b["z_lo"]:
        for flank in (1, -1):
            x_0 = flank * x - 0.5 * b["gap"]
            # a flank cannot touch while even its deepest corner is open
            if x_0 + slack <= b["sep_min"]:
                continue
            status = _flank(b, c, f, g, flank, x_0, spins, u_rate)
            if status != OK:
                return status
            if flank > 0:
                front = _contact(b["acc"][NEAREST], b["acc"][0])
            else:
                back = _contact(b["acc"][NEAREST], b["acc"][0])
            if watch:
                write_flank(b, observations(ctl), flank)
            if spins == 1:
                force += flank * b["acc"][0]
                tangent += b["acc"][5]
                if c["jac"] != 0 and runs_damped(b):
                    spin_direction(b)
                    add_roll_tangent(b, kk, 1)
            else:
                add_wrench(b, f, g)
                if watch:
                    write_friction_torques(b, observations(ctl), f, g)
                if c["jac"] != 0:
                    add_tangent(b, kk)
                    if runs_damped(b):
                        add_roll_tangent(b, kk, 5 if b["mu"] > 0.0 else 2)
                    if exact:
                        _turning(b, c, f, g, flank, x_0)
    damper = 0.0
    if b["d_gap"] > 0.0:
        if spins == 1:
            damper = b["d_gap"] * u_rate
            force += damper
            tangent += c["cd"] * b["d_gap"]
        else:
            damper, u_rate = mesh_damper(b, c, f, g, kk)
            if exact:
                b["acc"][0] = damper
                b["acc"][5] = b["d_gap"]
                call(b["turning"], b["here"], b["control"], 0)
    if spins == 1:
        add_spin_torque(b, f, g, force)
        if c["jac"] != 0:
            add_spin_tangent(b, kk, tangent)
    if watch:
        write_mesh(b, observations(ctl), psi, damper, u_rate)
    if c["ev"] != 0:
        _roots(b, events(ctl), x, front, back)
    return OK


@kernel
def _displaced_mesh(b, ctl, fr, kk):
    """A mesh of gears that sit beside or askew to the axes of their bodies."""
    c = ctl[0]
    held = begin_displaced(b, c, fr)
    frames = held[0]
    tangents = held[1]
    kept = (0.0, 0.0, 0, 0, 0)
    twice = c["jac"] == 2 and c["ck"] != 0.0
    status = OK
    for last in range(0 if twice else 1, 2):
        if last == 0:
            tangents, kept = damping_alone(b, c)
        elif twice:
            tangents = whole(b, c, frames, kept)
        status = max(status, _one_mesh(b, ctl, frames, tangents))
    end_displaced(b, ctl, fr, kk, held)
    return status


@kernel(inline=True)
def gear_mesh(rec, ctl, fr, kk):
    """Wrenches, tangents and observations of all meshes; see the module text."""
    for r in range(rec.size):
        b = rec[r]
        if b["displaced"] == 1:
            status = _displaced_mesh(b, ctl, fr, kk)
        else:
            status = _one_mesh(b, ctl, fr, kk)
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
        records[r]["here"] = rec + r * RECORD_BYTES
        records[r]["control"] = ctl
    return gear_mesh(records, c, fr, kk)


KIND = Kind(
    name="gear_mesh",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=outputs,
    events=EVENTS,
    bends=bends,
    exact={"turning": turning},
    some={"apart": (apart, "n_sep")},
    role=MESH,
    massless=True,
    spins=GEARED,
    sections={"meshes": ""},
    label="mesh",
    main=True,
    power=Power(),
)
