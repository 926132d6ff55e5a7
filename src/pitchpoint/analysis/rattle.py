# SPDX-License-Identifier: Apache-2.0
"""Rattle of a gear mesh: impacts, closing speeds, impulses, contact shares, and the rattle index."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import SignalError, as_increasing, as_signal, positive, same_length
from pitchpoint.analysis.statistics import BACK, BOTH, FRONT, SEPARATED, contact_statistics, time_weights


@dataclass(frozen=True)
class Rattle:
    """Impacts and contact shares of a mesh.

    Attributes
    ----------
    front_impacts, back_impacts
        Number of contacts that begin after a separation, by flank [-].
    impact_rate
        Impacts per time [1/s].
    contact_frequency
        Frequency with which contact of one flank begins, from its first to its last beginning [Hz]; 0 with
        fewer than two. Of the flank with more contacts.
    closing_speed_mean, closing_speed_rms, closing_speed_max
        Speed at which the flanks meet, normal to them [m/s]; 0 without impacts.
    impulse_mean, impulse_max
        Integral of the force over a contact that begins with an impact and ends within the record and one
        natural period [N s]; 0 without any.
    front_contact_share, back_contact_share, both_flanks_share, contact_loss_share
        Shares of the time with contact of the front flanks, of the back flanks, of both, and without contact
        [-]; contact of both flanks is included in front and back.
    longest_loss
        Longest time without contact [s].
    shortest_contact
        Shortest contact between an impact and the next separation [s]; 0 without any.
    resolution
        Largest interval between two samples [s]: shorter contacts and separations may be missed.
    """

    front_impacts: int
    back_impacts: int
    impact_rate: float
    contact_frequency: float
    closing_speed_mean: float
    closing_speed_rms: float
    closing_speed_max: float
    impulse_mean: float
    impulse_max: float
    front_contact_share: float
    back_contact_share: float
    both_flanks_share: float
    contact_loss_share: float
    longest_loss: float
    shortest_contact: float
    resolution: float


def rattle(
    time: ArrayLike,
    contact_state: ArrayLike,
    deflection: ArrayLike,
    force: ArrayLike,
    *,
    normal: float = 1.0,
    period: float = math.inf,
) -> Rattle:
    """Impacts, closing speeds, impulses and contact shares of one mesh.

    Parameters
    ----------
    time
        Times [s], shape (n,), increasing.
    contact_state
        Shape (n,): 1 front flank, 0 separated, -1 back flank, 2 both.
    deflection
        Deflection along the base tangent [m], shape (n,).
    force
        Mesh force along the base tangent [N], shape (n,).
    normal
        1/cos(beta_b), to convert speeds along the base tangent to speeds normal to the flanks [-].
    period
        Natural period of the flanks in contact [s]: impulses of longer contacts do not count. Runs use that
        of both gears on the mesh stiffness.

    Returns
    -------
    Rattle
        The numbers.

    Raises
    ------
    SignalError
        If the channels do not match, or another contact state occurs.

    Notes
    -----
    An impact is a contact after a separation; without backlash the flanks change without impacts. Its
    closing speed is the change of the deflection over the interval in which contact begins, divided by that
    interval; with the step h it is low by up to (omega h)^2/6, with omega the natural frequency of the flanks
    in contact. The impulse is the integral of the magnitude of the force by the trapezoidal rule, up to the
    loss of contact or the change of the flank. For a mass m that hits an elastic flank at the speed v and
    carries no load it is 2 m v. Under a constant load the flanks rebound within one natural period or not at
    all: the integral over a longer contact is that of the load. The contact frequency is that of an
    oscillation through the backlash; without backlash, contact of a flank begins where the other one ends.
    Times as in `contact_statistics` [1]_.

    References
    ----------
    .. [1] Definitions of this package; contact states as in A. Kahraman, R. Singh, Non-linear dynamics of a
       spur gear pair, Journal of Sound and Vibration 142(1), 1990, 49-75.

    Examples
    --------
    >>> t = np.arange(7) * 0.1
    >>> state, force = [1, 0, 0, -1, -1, 0, 1], [5, 0, 0, -8, -4, 0, 3]
    >>> r = rattle(t, state, [1.0, 0.5, -0.5, -1.5, -1.2, 0.2, 1.1], force)
    >>> r.front_impacts, r.back_impacts, round(r.closing_speed_max, 9), round(r.impulse_max, 9)
    (1, 1, 10.0, 1.2)
    """
    shares = contact_statistics(time, contact_state)
    clock, x, load = as_increasing(time), as_signal(deflection, "deflection"), as_signal(force, "force")
    same_length(clock, x, "time, deflection")
    same_length(clock, load, "time, force")
    positive(normal, "normal")
    if not period > 0.0:
        raise SignalError(f"period: {period:g} s; a natural period is above 0")
    state = np.asarray(contact_state, dtype=np.int64)
    h = np.diff(clock)
    swapped = state[1:] * state[:-1] == -1
    begins = np.flatnonzero((state[1:] != SEPARATED) & (state[:-1] == SEPARATED))
    ends = np.flatnonzero((state[:-1] != SEPARATED) & ((state[1:] == SEPARATED) | swapped))
    speeds = np.abs(np.diff(x)[begins]) / (h[begins] * normal)
    weights = time_weights(clock)
    middle = 0.5 * (clock[1:] + clock[:-1])
    impulses, lasting = [], []
    for first in begins:
        last = ends[ends > first]
        if last.size:
            touching = slice(first + 1, last[0] + 1)
            lasting.append(float(middle[last[0]] - middle[first]))
            if lasting[-1] <= period:
                impulses.append(float(weights[touching] @ np.abs(load[touching])))
    back = int(np.sum(state[begins + 1] == BACK))
    total = float(clock[-1] - clock[0])
    begun = [
        middle[np.flatnonzero(np.isin(state[1:], own) & ~np.isin(state[:-1], own))]
        for own in ((FRONT, BOTH), (BACK, BOTH))
    ]
    often = max(begun, key=len)
    both = float(weights[state == BOTH].sum()) / total
    return Rattle(
        front_impacts=int(begins.size) - back,
        back_impacts=back,
        impact_rate=begins.size / total,
        contact_frequency=(often.size - 1) / float(often[-1] - often[0]) if often.size > 1 else 0.0,
        closing_speed_mean=float(speeds.mean()) if speeds.size else 0.0,
        closing_speed_rms=float(np.sqrt(np.mean(speeds**2))) if speeds.size else 0.0,
        closing_speed_max=float(speeds.max(initial=0.0)),
        impulse_mean=float(np.mean(impulses)) if impulses else 0.0,
        impulse_max=max(impulses, default=0.0),
        front_contact_share=shares.front_contact_share,
        back_contact_share=shares.back_contact_share,
        both_flanks_share=both,
        contact_loss_share=shares.loss_share,
        longest_loss=shares.longest_loss,
        shortest_contact=min(lasting, default=0.0),
        resolution=float(h.max()),
    )


def rattle_index(acceleration: ArrayLike, inertia: float, drag_torque: float, *, ratio: float = 1.0) -> float:
    """Rattle index: largest inertia torque of an idle gear over the drag torque that keeps it in contact.

    Parameters
    ----------
    acceleration
        Angular acceleration of the driving gear over whole periods [rad/s^2], shape (n,), positive in its
        direction of rotation.
    inertia
        Moment of inertia of the idle gear and all that is fixed to it [kg m^2].
    drag_torque
        Drag torque on the idle gear [N m], positive if it opposes the rotation.
    ratio
        Speed of the idle gear over that of the driving gear, magnitude [-].

    Returns
    -------
    float
        The index [-]: the flanks separate if it exceeds 1.

    Raises
    ------
    SignalError
        If inertia, drag torque or ratio is not positive.

    Notes
    -----
    I = J ratio max(-alpha)/T [1]_: the driving gear can push, but not pull the idle gear. While the driving
    gear slows down, the drag torque must slow down the idle gear at the same rate. Valid for rigid teeth and
    a driving gear whose motion does not depend on the idle gear; for alpha = A sin(Omega t): I = J ratio A/T.

    References
    ----------
    .. [1] T. G. Brosey, R. L. Seaman, C. E. Johnson, R. F. Hamilton, Effect of transmission design on gear
       rattle and shiftability, International Journal of Vehicle Design 7(1/2), 1986, 45-66: rattle begins
       where the inertia torque by the acceleration of the input exceeds the drag torque.

    Examples
    --------
    >>> alpha = 400.0 * np.sin(2.0 * np.pi * np.arange(100) / 100)
    >>> round(rattle_index(alpha, 2e-3, 0.5, ratio=0.5), 9)
    0.8
    """
    values = as_signal(acceleration, "acceleration", minimum=1)
    for number, name in ((inertia, "inertia"), (drag_torque, "drag_torque"), (ratio, "ratio")):
        positive(number, name)
    return float(inertia * ratio * max(float((-values).max()), 0.0) / drag_torque)
