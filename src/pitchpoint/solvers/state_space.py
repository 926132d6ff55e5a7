# SPDX-License-Identifier: Apache-2.0
"""State-space form of a linearised system: x' = A x + B u, y = C x + D u.

The matrices are those of `linear_system.linearise`, with damping, gyroscopic and centrifugal terms and with
the states of force elements. Constraints are eliminated: the states are independent coordinates, their rates,
and the element states. An input whose rate acts, too, such as the transmission error of a mesh with a damper,
is subtracted from the rates, x = x' + P u (Kailath, Linear Systems, 1980, section 2.1.2: observer form), so
that its rate does not appear.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.inputs_outputs import (
    Input,
    Outputs,
    check_names,
    coordinate_units,
    find_ports,
)
from pitchpoint.solvers.linear_system import Linearised, linearise, lowest
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

NEGLIGIBLE = 1e-8
"""Share of an output, at the highest natural frequency, below which the rate of an input is round-off."""


@dataclass(frozen=True, repr=False)
class StateSpace:
    """Linear system x' = A x + B u, y = C x + D u in SI units, about an operating point.

    Parameters
    ----------
    A, B, C, D
        Shape (nx, nx), (nx, nu), (ny, nx), (ny, nu).
    states, inputs, outputs
        Names. States: coordinates (`pinion.spin`), their rates (`pinion.spin rate`), element states; with a
        number of modes, modal coordinates and their rates.
    state_units, input_units, output_units
        Their units.
    notes
        Notes on the operating point.
    """

    A: Array
    B: Array
    C: Array
    D: Array
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    state_units: tuple[str, ...]
    input_units: tuple[str, ...]
    output_units: tuple[str, ...]
    notes: tuple[str, ...] = ()

    def __repr__(self) -> str:
        """Number of states, names of inputs and outputs."""
        names = f"inputs {', '.join(self.inputs)}; outputs {', '.join(self.outputs)}"
        return f"<StateSpace: {len(self.states)} states; {names}>"

    def to_control(self) -> Any:
        """The system as `control.StateSpace`, with the names of states, inputs and outputs.

        Raises
        ------
        SolverError
            If the library python-control is not installed.
        """
        try:
            import control
        except ImportError as reason:
            raise SolverError(
                "python-control is not installed; use pip install 'pitchpoint[control]', or the arrays A, B, "
                "C, D",
                INCONSISTENT,
            ) from reason
        names = {"states": self.states, "inputs": self.inputs, "outputs": self.outputs}
        labels = {key: list(value) for key, value in names.items()}
        return control.StateSpace(self.A, self.B, self.C, self.D, **labels)


def state_space(
    system: System,
    inputs: Sequence[str],
    outputs: Sequence[str],
    scenario: Scenario | str | None = None,
    *,
    modes: int | None = None,
    phase: float | None = None,
    start: State | None = None,
    progress: Progress = silent,
) -> StateSpace:
    """State-space form about an operating point, with the response of `solve_frequency_response`.

    Parameters
    ----------
    system
        The compiled model.
    inputs, outputs
        Names as in `solve_frequency_response`: `BODY.COORDINATE`, `BODY.fx … mz`,
        `transmission_error[MESH]`; outputs `BODY.ux … rz` and all channels.
    scenario, phase, start
        As in `solve_modal`.
    modes
        Number of undamped modes, the lowest; default: all coordinates.
    progress
        Called while the system is linearised.

    Returns
    -------
    StateSpace
        Matrices, names and units; coordinates and inputs are deviations from the operating point.

    Raises
    ------
    ModelError
        If a name is unknown, a body cannot move in a direction, or a channel has no derivative.
    SolverError
        If there is no equilibrium, an input rotates (`unbalance[BODY]`), or an output
        contains the rate of an input: the force of a mesh with a damper for its transmission error.
    """
    check_names(system, inputs, outputs)
    linear = linearise(system, scenario, phase=phase, start=start, progress=progress)
    ins, outs = find_ports(linear, inputs, outputs)
    for port in ins:
        if port.turning.any():
            body = port.name.partition("[")[2].rstrip("]")
            raise SolverError(
                f"inputs: {port.name} rotates with the body, so it is not an input of a state space; use "
                f"{body}.fx and {body}.fy with the components of the centrifugal force",
                INCONSISTENT,
            )
    names, units, basis = _coordinates(linear) if modes is None else _modal(linear, modes)
    A, B, C, D = _matrices(linear, basis, ins, outs)
    own = [linear.system.layout.coordinates[s] for s in linear.states]
    rates = [f"{name} rate" for name in names]
    return StateSpace(
        *(A, B, C, D),
        states=(*names, *rates, *own),
        inputs=tuple(port.name for port in ins),
        outputs=outs.names,
        state_units=(*units, *(f"{unit}/s" for unit in units), *("SI" for _ in own)),
        input_units=tuple(port.unit for port in ins),
        output_units=outs.units,
        notes=linear.notes,
    )


def _coordinates(linear: Linearised) -> tuple[list[str], list[str], Array]:
    """Names, units and directions of independent coordinates, which have unit entries in the basis."""
    from scipy.linalg import qr

    basis = linear.basis if isinstance(linear.basis, np.ndarray) else linear.basis.toarray()
    every, known = linear.system.layout.coordinates, coordinate_units(linear.system)
    n = basis.shape[1]
    # a pivoted factorisation chooses the rows that determine all others best
    order = qr(basis.T * linear.system.weight, mode="r", pivoting=True)[1] if n else np.zeros(0, int)
    chosen = np.sort(order[:n])
    names = [every[k] for k in chosen]
    if np.array_equal(basis[chosen], np.eye(n)):
        return names, [known[name] for name in names], basis
    return names, [known[name] for name in names], np.linalg.solve(basis[chosen].T, basis.T).T


def _modal(linear: Linearised, count: int) -> tuple[list[str], list[str], Array]:
    """Names, units and directions of modal coordinates."""
    shapes = lowest(linear, count).shapes
    return [f"mode {k}" for k in range(1, len(shapes) + 1)], ["kg^0.5 m"] * len(shapes), shapes.T


def _matrices(
    linear: Linearised, basis: Array, ins: Sequence[Input], outs: Outputs
) -> tuple[Array, Array, Array, Array]:
    """A, B, C and D over the coordinates of the basis, their rates, and the element states."""
    M, D, K = linear.at_rest.M, linear.D, linear.K
    nd, n, own = len(M), basis.shape[1], list(linear.states)
    nr, nu = n + len(own), len(ins)
    # rates of all coordinates: those of the basis, and element states
    whole = np.hstack([basis, np.eye(nd)[:, own]])
    F = np.column_stack([port.force for port in ins]) if ins else np.zeros((nd, 0))
    R = np.column_stack([port.rate for port in ins]) if ins else np.zeros((nd, 0))
    mass = whole.T @ M @ whole
    size = 1.0 / np.sqrt(np.diag(mass))
    inverse = size[:, None] * np.linalg.solve(mass * np.outer(size, size), np.diag(size))
    P = inverse @ (whole.T @ R)
    accel_z = -inverse @ (whole.T @ K @ basis)
    accel_r = -inverse @ (whole.T @ D @ whole)
    accel_u = inverse @ (whole.T @ F) + accel_r @ P
    A = np.zeros((n + nr, n + nr))
    A[:n, n : 2 * n] = np.eye(n)
    A[n:, :n], A[n:, n:] = accel_z, accel_r
    B = np.vstack([P[:n], accel_u])
    C = np.hstack([outs.place @ basis, outs.rate @ whole])
    feed = outs.rate @ whole @ P
    of_rates = np.zeros((len(outs.names), nu))
    if np.any(outs.react):
        G = evaluate.constraint_jacobian(linear.system, linear.state)
        react = outs.react @ np.linalg.pinv(G.T, rcond=1e-9)
        C -= react @ np.hstack([K @ basis + M @ whole @ accel_z, D @ whole + M @ whole @ accel_r])
        feed += react @ (F - D @ whole @ P - M @ whole @ accel_u)
        of_rates += react @ (R - M @ whole @ P)
    for i, port in enumerate(ins):
        if port.mesh >= 0:
            direct = outs.feed[:, port.mesh]
            feed[:, i] += direct
            of_rates[:, i] -= np.where(direct != 0.0, outs.rate @ port.follows, 0.0)
    _refuse_rates(of_rates, feed, A, ins, outs)
    return A, B, C, feed


def _refuse_rates(of_rates: Array, feed: Array, A: Array, ins: Sequence[Input], outs: Outputs) -> None:
    """Reject outputs that contain the rate of an input."""
    if not of_rates.any():
        return
    highest = float(np.abs(np.linalg.eigvals(A)).max(initial=0.0))
    found = np.argwhere(np.abs(of_rates) * highest > NEGLIGIBLE * np.abs(feed))
    if found.size:
        pairs = "; ".join(f"{outs.names[o]} of {ins[i].name}" for o, i in found)
        raise SolverError(
            f"outputs: these contain the rate of the input and have no state-space form: {pairs}; use the "
            "deflection of the mesh or motions of bodies, or solve_frequency_response",
            INCONSISTENT,
        )
