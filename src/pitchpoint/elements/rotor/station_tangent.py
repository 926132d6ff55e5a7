# SPDX-License-Identifier: Apache-2.0
"""Exact tangents of the loads of a blade station: derivative for one motion of one body at a time."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.rotor.slopes import DOWNWIND, THETA, VX, VY, YAW
from pitchpoint.elements.rotor.station import C, E, N, O, RHO, S, T, U, across_rotor
from pitchpoint.elements.wrench import angular_velocity, put
from pitchpoint.multibody.vectors import add, cross, dot, into_world, less, row, times, triple, unit

ZERO = (0.0, 0.0, 0.0)


@kernel
def _moved(b, f, side, c):
    """Changes for motion c of body i, j or the hub (side 0, 1, 2): of the arm, place, span and chord, of the
    velocity at constant twists, of the place as a velocity, of the axis."""
    w = unit(c - 3)
    d_arm = cross(w, row(b["arm"], side))
    swept = cross(angular_velocity(f), d_arm)
    if side == 2:
        shift = add(unit(c), d_arm)
        return d_arm, shift, ZERO, ZERO, swept, cross(w, row(b["x"], N))
    share = b["share_i"] if side == 0 else b["share_j"]
    shift = add(times(share, unit(c)), d_arm)
    span = into_world(f["S"], triple(b["s_i"] if side == 0 else b["s_j"], 0))
    chord = into_world(f["S"], triple(b["c_i"] if side == 0 else b["c_j"], 0))
    return d_arm, shift, cross(w, span), cross(w, chord), swept, ZERO


@kernel
def _axes(b, d_rho, dn, ds):
    """Changes of t, o and of the normal of the blade."""
    x = b["x"]
    n = row(x, N)
    t = row(x, T)
    o = row(x, O)
    e = row(x, E)
    dm = add(cross(dn, row(x, RHO)), cross(n, d_rho))
    dt = times(1.0 / b["radius"], less(dm, times(dot(t, dm), t)))
    do = add(cross(dt, n), cross(t, dn))
    so = b["so"]
    sn = b["sn"]
    dso = dot(ds, o) + dot(row(x, S), do)
    dsn = dot(ds, n) + dot(row(x, S), dn)
    raw = less(add(times(dso, n), times(so, dn)), add(times(dsn, o), times(sn, do)))
    size = b["size"]
    de = times(1.0 / size, less(raw, times((so * dso + sn * dsn) / size, e)))
    return dt, do, de


@kernel
def _yaw(b, ck, cd, dn, do, wind, pushed):
    """Changes of yaw and downwind for changes of the axis and of the air relative to the hub."""
    along, across, size = across_rotor(b)
    n = row(b["x"], N)
    inflow = triple(b["hub_wind"], 0)
    d_inflow = add(times(ck, wind), times(cd, pushed))
    d_along = dot(n, d_inflow) + ck * dot(dn, inflow)
    d_across = less(d_inflow, add(times(d_along, n), times(ck * along, dn)))
    o = row(b["x"], O)
    if size == 0.0:  # the product of yaw and downwind counts
        return (dot(o, d_across) / along if along != 0.0 else 0.0), 0.0
    d_size = dot(across, d_across) / size
    d_yaw = (along * d_size - size * d_along) / (along * along + size * size)
    d_downwind = (dot(o, d_across) + ck * dot(do, across) - dot(o, across) * d_size / size) / size
    return d_yaw, d_downwind


@kernel
def _blown(G, shift):
    """Change of the wind over a displacement."""
    return dot(row(G, 0), shift), dot(row(G, 1), shift), dot(row(G, 2), shift)


@kernel
def station_column(b, f, side, c, ck, cd, force):
    """Changes of the arm, of the force and of the moment of the station for motion c of one body."""
    x = b["x"]
    d_arm, shift, ds, dc, swept, dn = _moved(b, f, side, c)
    nothing = times(0.0, shift)
    moved = nothing if side == 2 else shift
    d_rho = times(-1.0, shift) if side == 2 else shift
    dt, do, de = _axes(b, d_rho, dn, ds)
    t = row(x, T)
    e = row(x, E)
    flow = row(x, U)
    wind = _blown(b["gradient"], moved)
    d_flow = less(times(ck, wind), times(cd, moved))
    if side != 2:
        d_flow = less(d_flow, times(ck, swept))
    d_vx = dot(e, d_flow) + ck * dot(de, flow)
    d_vy = -dot(t, d_flow) - ck * dot(dt, flow)
    chord = row(x, C)
    up = -dot(chord, e)
    ahead = dot(chord, t)
    d_up = -dot(dc, e) - dot(chord, de)
    d_ahead = dot(dc, t) + dot(chord, dt)
    d_theta = ck * (ahead * d_up - up * d_ahead) / (ahead * ahead + up * up)
    d_yaw = 0.0
    d_downwind = 0.0
    if b["air"]["skew"] != 0.0:
        hub = times(-1.0, swept) if side == 2 else nothing
        pushed = times(-1.0, shift) if side == 2 else nothing
        d_yaw, d_downwind = _yaw(b, ck, cd, dn, do, hub, pushed)
    L = b["slopes"]
    loads = (0.0, 0.0, 0.0)
    for r in range(3):
        d = L[r, VX] * d_vx + L[r, VY] * d_vy + L[r, THETA] * d_theta
        d += L[r, YAW] * d_yaw + L[r, DOWNWIND] * d_downwind
        loads = add(loads, times(d, unit(r)))
    p = b["point"]
    dF = add(times(loads[0], e), times(loads[1], t))
    dF = add(dF, times(ck, add(times(p["f_n"], de), times(p["f_t"], dt))))
    along = cross(t, e)
    d_along = add(cross(dt, e), cross(t, de))
    dM = add(times(loads[2], along), times(ck * p["m_c"], d_along))
    length = b["length"]
    return times(ck, d_arm), times(length, dF), times(length, dM)


@kernel
def station_tangent(b, f, g, h, kk, ck, cd, force):
    """Add the tangents of one station to its pair blocks; `force` is its force."""
    for side in range(3):
        at = f if side == 0 else g
        if side == 2:
            at = h
        if side == 1 and b["j"] == 0:
            continue
        to_i = kk[b["ii"]]
        to_j = kk[b["ji"]]
        if side == 1:
            to_i = kk[b["ij"]]
            to_j = kk[b["jj"]]
        elif side == 2:
            to_i = kk[b["ik"]]
            to_j = kk[b["jk"]]
        for c in range(6):
            d_arm, dF, dM = station_column(b, at, side, c, ck, cd, force)
            moment = add(cross(row(b["arm"], 0), dF), times(b["w_i"], dM))
            if side == 0:
                moment = add(moment, cross(d_arm, force))
            put(to_i, c, -1.0, times(b["share_i"], dF), moment)
            if b["j"] != 0:
                moment = add(cross(row(b["arm"], 1), dF), times(b["w_j"], dM))
                if side == 1:
                    moment = add(moment, cross(d_arm, force))
                put(to_j, c, -1.0, times(b["share_j"], dF), moment)
