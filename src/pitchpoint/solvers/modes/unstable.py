# SPDX-License-Identifier: Apache-2.0
"""Modes that grow without excitation: their speeds, and the components from which the energy comes.

The amplitude grows if the damping ratio is negative. Energy flows into a mode from forces that are not
symmetric in the coordinates. The component e with the matrices K_e and D_e at speed feeds the mean power

    P_e = -omega/2 (Im(z^H K_e z) + omega Re(z^H D_e z))

into the mode z of the frequency omega, since its force is -(K_e + i omega D_e) z and the velocity i omega z
[1]_. A damper that rotates with a shaft feeds its forward whirl above the critical speed [1]_, a torque that
follows a tilting axis its forward or backward whirl according to its sign [2]_.

References
----------
.. [1] M. I. Friswell, J. E. T. Penny, S. D. Garvey, A. W. Lees: Dynamics of Rotating Machines, Cambridge
   University Press 2010, chapter 7.
.. [2] E. S. Zorzi, H. D. Nelson: The dynamics of rotor-bearing systems with axial torque, Journal of
   Mechanical Design 102 (1980) 158-161.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, SolverError, note
from pitchpoint.solvers.campbell import Campbell
from pitchpoint.solvers.element_batches import share_of_blocks, stiffness_by_element
from pitchpoint.solvers.linear_system import Linearised
from pitchpoint.solvers.modes.machine_groups import Groups
from pitchpoint.solvers.stiffness_parts import element_list
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    from pitchpoint.solvers.modal import Modes

UNDAMPED = 1e-7
"""Damping ratio, of either sign, up to which a mode counts as undamped: rounding of eigenvalues."""
RIGID = 1e-10
"""Eigenvalue relative to the largest one (of `modes`: the largest frequency of a coordinate with all others
fixed) up to which a mode is a rigid rotation, which does not grow."""
DRIFT = 1e-2
"""The same relative to the speed for the rotation of a rotor in multi-blade coordinates."""
ANTISYMMETRIC = 1e-12
"""Symmetric part of a damping matrix relative to the matrix up to which it is rounding."""
SHOWN = 3
"""Unstable modes that a note names."""
EXACT = 1e-9
"""Relative accuracy of a limit of stability."""


@dataclass(frozen=True)
class UnstableMode:
    """Range of speeds in which a mode is unstable.

    Parameters
    ----------
    mode
        Index of the branch.
    low, high
        Ends of the range [rad/s].
    damping_ratio
        Lowest damping ratio at the computed speeds in the range.
    source
        Component that feeds the largest power into the mode there; "" if it does not oscillate.
    """

    mode: int
    low: float
    high: float
    damping_ratio: float
    source: str


def unstable_modes(found: Campbell) -> tuple[UnstableMode, ...]:
    """Unstable modes in the range of the speeds, lowest damping first."""
    order = np.argsort(found.speed, kind="stable")
    size = np.abs(found.eigenvalue)
    moves = size > RIGID * size.max(axis=1, keepdims=True, initial=0.0)
    if found.rotors:  # the mean over some azimuths leaves a small moment of the weight about the axis
        still = found.modes.modes.omega[: size.shape[1]] == 0.0
        moves &= ~(still & (size < DRIFT * np.abs(found.speed)[:, None]))
    ratio = np.where(moves, found.damping_ratio, 0.0)[order]
    listed = []
    for mode in range(ratio.shape[1]):
        for first, last in _runs(ratio[:, mode] < -UNDAMPED):
            worst = int(order[first + int(np.argmin(ratio[first : last + 1, mode]))])
            low, high = (
                float(found.speed[order[at]])
                if not 0 <= beyond < len(order)
                else _limit(found, mode, int(order[at]), int(order[beyond]))
                for at, beyond in ((first, first - 1), (last, last + 1))
            )
            least = float(found.damping_ratio[worst, mode])
            listed.append(UnstableMode(mode, low, high, least, _source(found, mode, worst)))
    return tuple(sorted(listed, key=lambda u: (u.damping_ratio, u.mode)))


def _runs(wanted: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First and last index of each run of true values."""
    steps = np.diff(np.concatenate([[False], wanted, [False]]).astype(np.int8))
    first, after = np.flatnonzero(steps == 1), np.flatnonzero(steps == -1)
    return list(zip(first.tolist(), (after - 1).tolist(), strict=True))


def _limit(found: Campbell, mode: int, inside: int, outside: int) -> float:
    """Speed at which the damping of a mode changes its sign, between two computed speeds."""
    from scipy.optimize import brentq

    near, away = float(found.speed[inside]), float(found.speed[outside])
    value, shape = complex(found.eigenvalue[inside, mode]), found.shape[inside, mode]
    growth = {near: value.real, away: float(found.eigenvalue[outside, mode].real)}
    if value.imag <= 0.0 or growth[away] >= 0.0:  # divergence, or rounding: no limit to solve for
        return near
    last = (value, shape)

    def growth_at(speed: float) -> float:
        """Real part of the eigenvalue, followed from the speed before."""
        nonlocal last
        if speed not in growth:
            last = found.modes.near(speed, *last)
            growth[speed] = last[0].real
        return growth[speed]

    try:
        return float(brentq(growth_at, near, away, xtol=EXACT * max(abs(near), abs(away))))
    except SolverError:  # no equilibrium at a speed between them
        return near


def _source(found: Campbell, mode: int, at: int) -> str:
    """Component that feeds the largest power into a mode at one of the speeds."""
    linear = found.modes.at(float(found.speed[at]))
    state = linear.state.copy()
    state.v = found.speed[at] * found.rates
    motions = found.motions
    value, z = complex(found.eigenvalue[at, mode]), found.shape[at, mode]
    return feeding(linear.system, state, motions.groups, motions.parts.elements, value, z)


def feeding(
    system: System,
    state: State,
    groups: Groups,
    elements: Sequence[str],
    value: complex,
    z: NDArray[np.complex128],
) -> str:
    """Component that feeds the largest power into a mode; "" if it does not oscillate.

    Parameters
    ----------
    system, state
        System and operating point, at speed.
    groups, elements
        Components of the energies, and labels of their elements.
    value, z
        Eigenvalue [1/s] and shape of the mode, shape (nd,).
    """
    omega = value.imag
    if omega <= 0.0:
        return ""
    component = {name: groups.components[e] for name, e in zip(elements, groups.component, strict=True)}
    power: dict[str, float] = {}
    listed = element_list(system)
    for (_, _, label), (blocks, D, K) in zip(
        listed, stiffness_by_element(system, state, [(kind, k) for kind, k, _ in listed]), strict=True
    ):
        damping, stiffness = (share_of_blocks(system, blocks, A) for A in (D, K))
        x, y = z[damping.places], z[stiffness.places]
        fed = omega * (x.conj() @ damping.matrix @ x).real + (y.conj() @ stiffness.matrix @ y).imag
        name = component.get(label, label)
        power[name] = power.get(name, 0.0) - 0.5 * omega * float(fed)
    return max(power, key=power.__getitem__) if power and max(power.values()) > 0.0 else ""


def growing(linear: Linearised, modes: Modes) -> NDArray[np.bool_]:
    """Whether each mode about a state grows; the eigenvalue of a rigid rotation without load is rounding."""
    mass = linear.at_rest.M.diagonal()
    stiffness = np.abs(linear.K.diagonal())
    largest = np.sqrt(np.divide(stiffness, mass, out=np.zeros(len(mass)), where=mass > 0.0).max(initial=0.0))
    return (modes.damping_ratio < -UNDAMPED) & (np.abs(modes.eigenvalue) > RIGID * largest)


def sources(linear: Linearised, modes: Modes) -> list[str]:
    """Components that feed the unstable modes about a state, by mode; "" for the others."""
    grows = growing(linear, modes)
    return [
        feeding(linear.system, linear.state, modes.groups, modes.elements, value, modes.damped_shape[k])
        if grows[k]
        else ""
        for k, value in enumerate(modes.eigenvalue.tolist())
    ]


def unstable_notes(linear: Linearised, modes: Modes) -> tuple[Message, ...]:
    """Note on the unstable modes about a state: names, damping ratios and what feeds them."""
    grows = growing(linear, modes)
    listed = [
        f"{modes.names[k]} ({100.0 * float(modes.damping_ratio[k]):.2g} %"
        + (f", fed by {source})" if source else ")")
        for k, source in enumerate(sources(linear, modes))
        if grows[k]
    ]
    if not listed:
        return ()
    verb = "modes are" if len(listed) > 1 else "mode is"
    text = f"{len(listed)} {verb} unstable: {'; '.join(listed[:SHOWN])}"
    more = f"; {len(listed) - SHOWN} more" if len(listed) > SHOWN else ""
    remedy = "add damping to shafts or bearings; a Campbell diagram gives the range of speeds"
    return (note(f"{text}{more}", remedy=remedy),)


def is_undamped(linear: Linearised) -> bool:
    """Whether a linear system has no damping: its damping matrix is antisymmetric, gyroscopic terms only."""
    both = abs(linear.D + linear.D.T)
    return float(both.max()) <= ANTISYMMETRIC * float(abs(linear.D).max())


def undamped_note(ratio: float) -> str:
    """Note on unstable modes of a model without damping.

    Parameters
    ----------
    ratio
        Lowest damping ratio, negative.
    """
    return (
        "the model has no damping, so that a mode grows with any force that feeds it, such as a torque that "
        f"follows a tilting axis: damping ratios above {-100.0 * ratio:.2g} % make all listed modes stable"
    )
