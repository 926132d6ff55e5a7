# SPDX-License-Identifier: Apache-2.0
"""Coupled sections of beams: a quadratic form of the six deformations y of an element.

With the chord e, the normals t and the section axes p and q of both ends, y are the elongation u of the bent
axis, the twist, the bending angle (p_j . t_i - p_i . t_j)/2, the sum (p_i + p_j) . e of the slopes, and both
with q instead of p. Bending is the rotation between both ends; the difference of the slopes would count the
shear angle of a section that twists as curvature. In addition to the terms of a round section (`forces`) the
energy is 1/2 y . Q y and the damping force R dy/dt. All deformations are the same for any motion of the whole
element.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.beams.record import PI, TI, TJ, E
from pitchpoint.multibody.vectors import add, cross, dot, less, row, times


@kernel
def _rate(b, i, j):
    """Rate of the scalar product of two vectors."""
    return dot(row(b["w1"], i), row(b["w"], j)) + dot(row(b["w"], i), row(b["w1"], j))


@kernel
def _change(b, i, j):
    """Change of the scalar product of two vectors."""
    return dot(row(b["dw"], i), row(b["w"], j)) + dot(row(b["w"], i), row(b["dw"], j))


@kernel
def _change_of_rate(b, i, j):
    one = dot(row(b["dw1"], i), row(b["w"], j)) + dot(row(b["w1"], i), row(b["dw"], j))
    return one + dot(row(b["dw"], i), row(b["w1"], j)) + dot(row(b["w"], i), row(b["dw1"], j))


@kernel
def _forces(b, y, to):
    """Forces of deformations and their rates."""
    for i in range(6):
        f = 0.0
        for j in range(6):
            f += b["Q"][i, j] * b["y"][y, j] + b["R"][i, j] * b["y"][y + 1, j]
        b["g"][to, i] = f


@kernel
def coupled_forces(b):
    """Set bending angles and slopes with their rates, and the forces of all deformations; elongation and
    twist are set."""
    for n in range(2):
        i = PI + 2 * n
        j = i + 1
        one = dot(row(b["w"], j), row(b["w"], TI)) - dot(row(b["w"], i), row(b["w"], TJ))
        b["y"][0, 2 + 2 * n] = 0.5 * one
        b["y"][1, 2 + 2 * n] = 0.5 * (_rate(b, j, TI) - _rate(b, i, TJ))
        b["y"][0, 3 + 2 * n] = dot(row(b["w"], i), row(b["w"], E)) + dot(row(b["w"], j), row(b["w"], E))
        b["y"][1, 3 + 2 * n] = _rate(b, i, E) + _rate(b, j, E)
    _forces(b, 0, 0)


@kernel
def coupled_changes(b):
    """Set the changes of bending angles and slopes, of their rates, and of the forces of all deformations for
    one motion."""
    for n in range(2):
        i = PI + 2 * n
        j = i + 1
        b["y"][2, 2 + 2 * n] = 0.5 * (_change(b, j, TI) - _change(b, i, TJ))
        b["y"][3, 2 + 2 * n] = 0.5 * (_change_of_rate(b, j, TI) - _change_of_rate(b, i, TJ))
        b["y"][2, 3 + 2 * n] = _change(b, i, E) + _change(b, j, E)
        b["y"][3, 3 + 2 * n] = _change_of_rate(b, i, E) + _change_of_rate(b, j, E)
    _forces(b, 2, 1)


@kernel
def coupled_chord(b):
    """Generalised force of the chord direction."""
    G = (0.0, 0.0, 0.0)
    for n in range(2):
        i = PI + 2 * n
        G = add(G, times(b["g"][0, 3 + 2 * n], add(row(b["w"], i), row(b["w"], i + 1))))
    return G


@kernel
def coupled_chord_change(b):
    """Change of the generalised force of the chord direction."""
    G = (0.0, 0.0, 0.0)
    for n in range(2):
        i = PI + 2 * n
        G = add(G, times(b["g"][1, 3 + 2 * n], add(row(b["w"], i), row(b["w"], i + 1))))
        G = add(G, times(b["g"][0, 3 + 2 * n], add(row(b["dw"], i), row(b["dw"], i + 1))))
    return G


@kernel
def coupled_moment(b, k):
    """Moment of end k on the element."""
    mu = (0.0, 0.0, 0.0)
    side = 0.5 if k == 1 else -0.5
    t = row(b["w"], TI + k)
    far = row(b["w"], TJ - k)
    for n in range(2):
        p = row(b["w"], PI + 2 * n + k)
        other = row(b["w"], PI + 2 * n + 1 - k)
        bend = less(cross(p, far), cross(t, other))
        mu = add(mu, times(side * b["g"][0, 2 + 2 * n], bend))
        mu = add(mu, times(b["g"][0, 3 + 2 * n], cross(p, row(b["w"], E))))
    return mu


@kernel
def coupled_moment_change(b, k):
    """Change of the moment of end k on the element."""
    mu = (0.0, 0.0, 0.0)
    side = 0.5 if k == 1 else -0.5
    e = row(b["w"], E)
    t = row(b["w"], TI + k)
    far = row(b["w"], TJ - k)
    dt = row(b["dw"], TI + k)
    d_far = row(b["dw"], TJ - k)
    for n in range(2):
        p = row(b["w"], PI + 2 * n + k)
        other = row(b["w"], PI + 2 * n + 1 - k)
        dp = row(b["dw"], PI + 2 * n + k)
        d_other = row(b["dw"], PI + 2 * n + 1 - k)
        bend = less(cross(p, far), cross(t, other))
        turn = less(add(cross(dp, far), cross(p, d_far)), add(cross(dt, other), cross(t, d_other)))
        mu = add(mu, times(side * b["g"][1, 2 + 2 * n], bend))
        mu = add(mu, times(side * b["g"][0, 2 + 2 * n], turn))
        mu = add(mu, times(b["g"][1, 3 + 2 * n], cross(p, e)))
        mu = add(mu, times(b["g"][0, 3 + 2 * n], add(cross(dp, e), cross(p, row(b["dw"], E)))))
    return mu
