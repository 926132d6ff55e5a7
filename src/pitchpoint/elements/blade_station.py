# SPDX-License-Identifier: Apache-2.0
"""Aerodynamic loads of a blade station by blade-element momentum theory, on rigid and elastic blades.

One record per station; the first record of a rotor has its sums. The station follows bodies i and j, the
rotor axis body k. Induction and loads are those of `rotor.loads`, place and axes those of `rotor.station`.
The load per length acts over the length of blade of the station, as in the trapezoidal rule.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import FRAME, FREE, WITH_STATE, Kind
from pitchpoint.elements.rotor.loads import station_loads
from pitchpoint.elements.rotor.slopes import load_slopes, steady_slopes
from pitchpoint.elements.rotor.station import (
    RECORD,
    RHO,
    E,
    N,
    T,
    V,
    hub_inflow,
    knots_of,
    meet_air,
    place,
    set_gradient,
)
from pitchpoint.elements.rotor.station_tangent import station_tangent
from pitchpoint.elements.wrench import angular_velocity, push
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
def blade_station(rec, ctl, fr, kk):
    """Loads, tangents and observations of all stations."""
    c = ctl[0]
    first = 0
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        h = fr[b["k"]]
        if b["first"] != 0:
            first = e
            status = hub_inflow(b, h, c["t"])
            if status != OK:
                c["bad"] = e
                return status
            for r in range(3):
                b["sums"][r] = 0.0
        head = rec[first]
        for r in range(3):
            b["hub_wind"][r] = head["hub_wind"][r]
        place(b, f, g, h)
        status = meet_air(b, c["t"])
        knots = knots_of(b)
        if status == OK:
            status = station_loads(b["blade"], b["air"], knots, b["point"])
        if status != OK:
            c["bad"] = e
            return status
        p = b["point"]
        x = b["x"]
        length = b["length"]
        force = times(length, add(times(p["f_n"], row(x, E)), times(p["f_t"], row(x, T))))
        moment = times(length * p["m_c"], cross(row(x, T), row(x, E)))
        _share(f, b, 0, force, moment)
        if b["j"] != 0:
            _share(g, b, 1, force, moment)
        if c["jac"] != 0:
            if c["jac"] == 2:
                status = set_gradient(b, c["t"])
                if status != OK:
                    c["bad"] = e
                    return status
            steady_slopes(b["blade"], b["air"], knots, p, b["flow"])
            load_slopes(b["blade"], b["air"], knots, p, b["flow"], b["slopes"])
            station_tangent(b, f, g, h, kk, c["ck"], c["cd"], force)
        if c["out"] != 0:
            _add_up(b, head, f, g, force, moment)
            if e + 1 == rec.size or rec[e + 1]["first"] != 0:
                out = observations(ctl)
                for r in range(3):
                    out[head["out"] + r] = head["sums"][r]
                out[head["out"] + 3] = dot(row(x, N), triple(b["hub_wind"], 0))
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return blade_station(view(rec, n, RECORD), c, fr, kk)


def _outputs(record):
    """Sums of a rotor at its first station."""
    return ROTOR if record["first"] else ()


KIND = Kind(
    name="blade_station",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=_outputs,
    pairs=WITH_STATE,
    body_fixed=True,
    massless=True,
    spins=FREE,
    excites=False,
    large=True,
    sections={"wind_rotors": ""},
    names_modes=False,
)
