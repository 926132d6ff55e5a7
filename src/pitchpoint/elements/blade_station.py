# SPDX-License-Identifier: Apache-2.0
"""Aerodynamic loads of a blade station by blade-element momentum theory, on rigid and elastic blades.

One record per station; the first record of a rotor has its sums. The station follows bodies i and j, the
rotor axis body k. Induction and loads are those of `rotor.loads`, place and axes those of `rotor.station`.
The load per length acts over the length of blade of the station, as in the trapezoidal rule.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK, OUTSIDE_BOX, TABLE_RANGE
from pitchpoint.elements.kind import FRAME, FREE, WITH_STATE, Kind, Power
from pitchpoint.elements.rotor.extrapolation import (
    WHOLE,
    extrapolate,
    keep_origin,
    read_states,
    write_rates,
)
from pitchpoint.elements.rotor.loads import (
    set_angles,
    set_coefficients,
    set_forces,
    station_loads,
    steady_inflow,
)
from pitchpoint.elements.rotor.polar import coefficient
from pitchpoint.elements.rotor.slopes import load_slopes, steady_slopes
from pitchpoint.elements.rotor.station import (
    BODIES,
    RECORD,
    RHO,
    E,
    N,
    R,
    T,
    V,
    hub_inflow,
    knots_of,
    meet_air,
    place,
    set_gradient,
)
from pitchpoint.elements.rotor.station_tangent import state_tangent, station_tangent
from pitchpoint.elements.rotor.unsteady import (
    attached_lift,
    held_velocities,
    lift_slopes,
    rate_slopes,
    stalling_lift,
    state_rates,
)
from pitchpoint.elements.wrench import angular_velocity
from pitchpoint.multibody.channels import frame_args, observations
from pitchpoint.multibody.vectors import add, cross, dot, row, times, triple

ROTOR = (
    ("rotor_thrust[{}]", "N", "force of the air along the rotor axis, downwind positive"),
    ("rotor_torque[{}]", "N m", "torque of the air about the rotor axis"),
    ("aerodynamic_power[{}]", "W", "power of the air on the moving blades"),
    ("hub_wind_speed[{}]", "m/s", "wind along the rotor axis, relative to the hub"),
)


@kernel
def _share(f, b, side, force, moment):
    """Add the force and moment of the station to a body through the shape functions."""
    share = b["share_i"] if side == 0 else b["share_j"]
    turn = b["w_i"] if side == 0 else b["w_j"]
    m = add(cross(row(b["arm"], side), force), times(turn, moment))
    for r in range(3):
        f["F"][r] += share * force[r]
        f["F"][3 + r] += m[r]


@kernel
def _add_up(b, head, f, g, force, moment):
    """Add thrust, torque and power of a station to the sums of the rotor."""
    n = row(b["x"], N)
    turn = add(times(b["w_i"], angular_velocity(f)), times(b["w_j"], angular_velocity(g)))
    head["sums"][0] += dot(n, force)
    head["sums"][1] += dot(n, add(cross(row(b["x"], RHO), force), moment))
    head["sums"][2] += dot(force, row(b["x"], V)) + dot(moment, turn)


@kernel
def _unsteady_loads(b, knots, fr, jac):
    """Loads with induction and separation as states, their rates and derivatives; status."""
    p = b["point"]
    blade = b["blade"]
    x = b["state"]
    read_states(b, fr)
    ux, uy, status = steady_inflow(blade, b["air"], knots, p)
    steady_n = p["vx"] - ux
    steady_t = uy - p["vy"]
    set_angles(blade, p, p["vx"] - x[1], p["vy"] + x[3])
    i = set_coefficients(blade, knots, p)
    steady_f, by_alpha = coefficient(knots, i, 7, p["alpha"])
    if b["stall"] != 0 and blade["slope"] > 0.0:
        attached = attached_lift(p["alpha"], blade["alpha_0"], blade["slope"])
        separated, _ = coefficient(knots, i, 9, p["alpha"])
        p["lift"] = stalling_lift(p["lift"], steady_f, attached, separated, x[4])
    set_forces(blade, b["air"], p)
    steady = (steady_n, steady_t, steady_f)
    state_rates(blade, p, x, steady, b["rates"])
    write_rates(b, fr)
    if jac != 0:
        steady_slopes(blade, b["air"], p, b["steady"])
        held_velocities(b["flow"])
        lift_slopes(blade, p, knots, i, b["stall"], x, b["lift"])
        load_slopes(blade, b["air"], knots, p, b["flow"], b["lift"], b["slopes"])
        rate_slopes(blade, p, x, steady, (b["steady"], by_alpha), b["flow"], b["by_rate"])
    return status


@kernel
def _steady_loads(b, knots, jac):
    """Loads with steady induction, and their derivatives; status."""
    p = b["point"]
    blade = b["blade"]
    status = station_loads(blade, b["air"], knots, p)
    if jac != 0:
        steady_slopes(blade, b["air"], p, b["flow"])
        lift_slopes(blade, p, knots, p["row"], 0, b["state"], b["lift"])
        load_slopes(blade, b["air"], knots, p, b["flow"], b["lift"], b["slopes"])
    return status


@kernel
def _loads(b, head, fr, c):
    """Place, air and loads of one station; status."""
    jac = c["jac"]
    t = c["t"]
    place(b, fr[b["i"]], fr[b["j"]], fr[b["k"]])
    status = meet_air(b, head, t)
    if jac == 1:
        _forget(b["gradient"])
    if status == OK and jac == 2:
        status = set_gradient(b, row(b["x"], R), t, 1, b["gradient"])
    if status != OK:
        return OUTSIDE_BOX if status == TABLE_RANGE else status
    if c["held"] == 0 or b["hold"] == 0.0 or jac == 2:
        b["since"] = math.nan
        return _solved_loads(b, fr, jac)
    if b["since"] <= t < b["since"] + WHOLE * b["hold"]:
        extrapolate(b, fr)
        return OK
    status = _solved_loads(b, fr, 1)
    if status == OK:
        keep_origin(b, t)
    return status


@kernel
def _solved_loads(b, fr, jac):
    """Loads of one station from its balance of momentum, and with `jac` their derivatives; status."""
    if b["inflow"] != 0:
        return _unsteady_loads(b, knots_of(b), fr, jac)
    return _steady_loads(b, knots_of(b), jac)


@kernel
def _forget(G):
    """Clear the gradient of the wind: Newton matrices do without it."""
    for r in range(3):
        for n in range(3):
            G[r, n] = 0.0


@kernel
def _begin(b, h, t, exact):
    """Set the air relative to the hub and clear the sums of a rotor; status."""
    for r in range(3):
        b["sums"][r] = 0.0
    _forget(b["hub_gradient"])
    return hub_inflow(b, h, t, exact)


@kernel
def blade_station(rec, ctl, fr, kk):
    """Loads, tangents and observations of all stations."""
    c = ctl[0]
    first = 0
    for e in range(rec.size):
        b = rec[e]
        status = OK
        if b["first"] != 0:
            first = e
            status = _begin(b, fr[b["k"]], c["t"], 1 if c["jac"] == 2 else 0)
        head = rec[first]
        if c["jac"] != 0:
            for r in range(3):
                b["hub_wind"][r] = head["hub_wind"][r]
                for n in range(3):
                    b["hub_gradient"][r, n] = head["hub_gradient"][r, n]
        if status == OK:
            status = _loads(b, head, fr, c)
        if status != OK:
            c["bad"] = e
            return status
        f = fr[b["i"]]
        g = fr[b["j"]]
        p = b["point"]
        x = b["x"]
        length = b["length"]
        force = times(length, add(times(p["f_n"], row(x, E)), times(p["f_t"], row(x, T))))
        moment = times(length * p["m_c"], cross(row(x, T), row(x, E)))
        _share(f, b, 0, force, moment)
        if b["j"] != 0:
            _share(g, b, 1, force, moment)
        if c["jac"] != 0:
            station_tangent(b, f, g, fr[b["k"]], kk, c["ck"], c["cd"], force)
            if b["inflow"] != 0:
                state_tangent(b, kk, c["cd"])
        if c["out"] != 0:
            _add_up(b, head, f, g, force, moment)
            if e + 1 == rec.size or rec[e + 1]["first"] != 0:
                out = observations(ctl)
                for r in range(3):
                    out[head["out"] + r] = head["sums"][r]
                out[head["out"] + 3] = dot(row(x, N), triple(head["hub_wind"], 0))
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return blade_station(view(rec, n, RECORD), c, fr, kk)


def _outputs(record):
    """Sums of a rotor at its first station."""
    return ROTOR if record["first"] else ()


def _adds_up(record):
    """Whether this is the station with the sums of a rotor."""
    return bool(record["first"])


PAIRS = (
    *WITH_STATE,
    *((end, state) for end in BODIES[:3] for state in BODIES[3:]),
    ("l1", "l2"),
    ("l3", "l4"),
    ("l2", "l5"),
    ("l4", "l5"),
)
"""Interacting bodies: those of the motion, all with the states, and states with each other."""

KIND = Kind(
    name="blade_station",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=_outputs,
    pairs=PAIRS,
    paired=BODIES,
    body_fixed=True,
    massless=True,
    spins=FREE,
    excites=False,
    large=True,
    sections={"wind_rotors": ""},
    names_modes=False,
    power=Power(total="aerodynamic_power[{}]", body="k", source="wind", where=_adds_up),
)
