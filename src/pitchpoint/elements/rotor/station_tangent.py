# SPDX-License-Identifier: Apache-2.0
"""Exact tangents of the loads of a blade station: derivative for one motion of one body at a time."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.rotor.slopes import DOWNWIND, THETA, VX, VY, YAW
from pitchpoint.elements.rotor.station import OUT, RHO, C, E, N, S, T, U, across_rotor
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
    o = row(x, OUT)
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
    n = row(b["x"], N)
    inflow = triple(b["hub_wind"], 0)
    along, across, size = across_rotor(n, inflow)
    d_inflow = add(times(ck, wind), times(cd, pushed))
    d_along = dot(n, d_inflow) + ck * dot(dn, inflow)
    d_across = less(d_inflow, add(times(d_along, n), times(ck * along, dn)))
    o = row(b["x"], OUT)
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
def station_column(b, f, side, c, ck, cd):
    """Changes of the arm and of both axes of the station for motion c of one body; sets those of the inputs
    of its loads."""
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
        hub = less(_blown(b["hub_gradient"], shift), swept) if side == 2 else nothing
        pushed = times(-1.0, shift) if side == 2 else nothing
        d_yaw, d_downwind = _yaw(b, ck, cd, dn, do, hub, pushed)
    b["inputs"][VX] = d_vx
    b["inputs"][VY] = d_vy
    b["inputs"][THETA] = d_theta
    b["inputs"][YAW] = d_yaw
    b["inputs"][DOWNWIND] = d_downwind
    return times(ck, d_arm), times(ck, de), times(ck, dt)


@kernel
def combined(A, r, x):
    """Product of the inputs x with row r of their derivatives."""
    s = 0.0
    for n in range(5):
        s += A[r, n] * x[n]
    return s


@kernel
def load_changes(b, loads, de, dt):
    """Changes of force and moment of the station for changes of its loads per length and of its axes."""
    e = row(b["x"], E)
    t = row(b["x"], T)
    p = b["point"]
    dF = add(times(loads[0], e), times(loads[1], t))
    dF = add(dF, add(times(p["f_n"], de), times(p["f_t"], dt)))
    dM = times(loads[2], cross(t, e))
    dM = add(dM, times(p["m_c"], add(cross(dt, e), cross(t, de))))
    return times(b["length"], dF), times(b["length"], dM)


@kernel
def station_tangent(b, f, g, h, kk, ck, cd, force):
    """Add the tangents of one station to its pair blocks; `force` is its force."""
    L = b["slopes"]
    x = b["inputs"]
    for side in range(3):
        at = f if side == 0 else g
        if side == 2:
            at = h
        if side == 1 and b["j"] == 0:
            continue
        to_i = kk[b["pairs"][0, side]]
        to_j = kk[b["pairs"][1, side]]
        for c in range(6):
            d_arm, de, dt = station_column(b, at, side, c, ck, cd)
            loads = combined(L, 0, x), combined(L, 1, x), combined(L, 2, x)
            dF, dM = load_changes(b, loads, de, dt)
            moment = add(cross(row(b["arm"], 0), dF), times(b["w_i"], dM))
            if side == 0:
                moment = add(moment, cross(d_arm, force))
            put(to_i, c, -1.0, times(b["share_i"], dF), moment)
            if b["j"] != 0:
                moment = add(cross(row(b["arm"], 1), dF), times(b["w_j"], dM))
                if side == 1:
                    moment = add(moment, cross(d_arm, force))
                put(to_j, c, -1.0, times(b["share_j"], dF), moment)
            if b["inflow"] != 0:
                for r in range(5):
                    kk[b["pairs"][3 + r, side]][5, c] -= combined(b["by_rate"], r, x)


@kernel
def state_tangent(b, kk, cd):
    """Add the tangents with respect to the states, the spin rates of hidden bodies about z of the world."""
    L = b["slopes"]
    Q = b["by_rate"]
    for n in range(5):
        loads = L[0, 5 + n], L[1, 5 + n], L[2, 5 + n]
        dF, dM = load_changes(b, loads, ZERO, ZERO)
        moment = add(cross(row(b["arm"], 0), dF), times(b["w_i"], dM))
        put(kk[b["pairs"][0, 3 + n]], 5, -cd, times(b["share_i"], dF), moment)
        if b["j"] != 0:
            moment = add(cross(row(b["arm"], 1), dF), times(b["w_j"], dM))
            put(kk[b["pairs"][1, 3 + n]], 5, -cd, times(b["share_j"], dF), moment)
        for r in range(5):
            kk[b["pairs"][3 + r, 3 + n]][5, 5] -= cd * Q[r, 5 + n]
