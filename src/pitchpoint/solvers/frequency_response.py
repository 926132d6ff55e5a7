# SPDX-License-Identifier: Apache-2.0
"""Frequency response about an operating point: y = C (K + i omega D - omega^2 M)^-1 B, direct or modal.

M, D and K are those of `linear_system.linearise`: they include gyroscopic and centrifugal terms; mesh
stiffness is the mean over the mesh cycle or the value at one phase. Closed loops are projected onto their
free directions; the reactions follow. Driven spins are fixed. With a synchronous body, the rotational
frequency of that body equals the excitation frequency, as for its unbalance response: the direction of
rotation is that of the operating point, and the other bodies follow by their speed ratios.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import Message, ModelError, SolverError, join_notes
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import SINGULAR
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.equilibrium.unknowns import LARGE
from pitchpoint.solvers.harmonic_response import harmonic_response
from pitchpoint.solvers.inputs_outputs import Input, Outputs, check_names, find_ports
from pitchpoint.solvers.linear_system import Linearised, linearise, lowest, rates_of
from pitchpoint.solvers.over_speed import at_one_azimuth
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    import xarray as xr

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

SAME = 1e-6
"""Relative difference of speeds up to which an unbalance rotates with the synchronous body."""


@dataclass(frozen=True)
class FrequencyResponse:
    """Complex response per unit of each input.

    Parameters
    ----------
    frequency
        [Hz], shape (nf,).
    response
        Amplitude and phase of every output per unit of every input, e^(i omega t), shape (nf, no, ni).
    outputs, inputs, output_units, input_units
        Names and units.
    notes
        Notes for the user.
    """

    frequency: Array
    response: Complex
    outputs: tuple[str, ...]
    inputs: tuple[str, ...]
    output_units: tuple[str, ...]
    input_units: tuple[str, ...]
    notes: tuple[str, ...] = ()


def find_response(
    system: System,
    inputs: Sequence[str],
    outputs: Sequence[str],
    frequencies: ArrayLike,
    scenario: Scenario | str | None = None,
    *,
    modes: int | None = None,
    synchronous: str | None = None,
    phase: float | None = None,
    start: State | None = None,
    progress: Progress = silent,
) -> FrequencyResponse:
    """Complex frequency response.

    Parameters
    ----------
    system
        The compiled model.
    inputs, outputs
        Names as in `inputs_outputs`.
    frequencies
        [Hz], shape (nf,).
    scenario, phase, start
        As in `modal.find_modes`.
    modes
        Number of undamped modes of a modal solution; default: the direct solution.
    synchronous
        Body whose speed equals the excitation frequency, in the direction of the scenario; other bodies
        follow by their speed ratios. An unbalance must rotate with the speed of this body.
    progress
        Called after every frequency.

    Raises
    ------
    ModelError
        If a name is unknown, a body cannot move in a direction, a channel has no derivative (the magnitude of
        a force with zero mean), or an unbalance rotates with another speed than the synchronous body.
    SolverError
        If there is no equilibrium, or the system is singular at a frequency.
    """
    check_names(system, inputs, outputs, () if synchronous is None else (synchronous,))
    linear = linearise(system, scenario, phase=phase, start=start, turning=synchronous)
    rates = None if synchronous is None else rates_of(linear, synchronous, scenario)
    ins, outs = find_ports(linear, inputs, outputs, rates)
    if synchronous is not None:
        _refuse_other_speeds(ins, synchronous)
    hertz = np.atleast_1d(np.asarray(frequencies, dtype=np.float64))
    basis = linear.basis if modes is None else lowest(linear, modes).shapes.T
    found = np.zeros((hertz.size, len(outs.names), len(ins)), complex)
    matrices = matrices_of(linear)
    over = None if rates is None else at_one_azimuth(linear, rates)
    for f, omega in enumerate(2.0 * np.pi * hertz):
        at = linear if over is None else over.at(float(omega))
        matrices = matrices if over is None else matrices_of(at)
        found[f] = respond(at, matrices, basis, ins, outs, float(omega))
        progress(f + 1, hertz.size, "frequencies")
    names, units = tuple(i.name for i in ins), tuple(i.unit for i in ins)
    return FrequencyResponse(hertz, found, outs.names, names, outs.units, units, linear.notes)


def _refuse_other_speeds(ins: Sequence[Input], synchronous: str) -> None:
    """Refuse an unbalance that does not rotate with the frequency of the response."""
    problems = []
    for port in ins:
        if port.speed is None or abs(abs(port.speed) - 1.0) <= SAME:
            continue
        body = port.name.partition("[")[2].rstrip("]")
        what = f"excites at {abs(port.speed):.6g} times the frequency of {synchronous}"
        if not port.speed:
            what = f"does not excite, since {body} does not rotate with {synchronous}"
        remedy = f"choose {body} as the synchronous body; the other bodies follow by their speed ratios"
        problems.append(Message(port.name, what, remedy=remedy))
    if problems:
        raise ModelError(problems)


def matrices_of(linear: Linearised) -> tuple[Any, Any, Any]:
    """M, D and K at speed, sparse if the system is large."""
    whole = (linear.at_rest.M, linear.D, linear.K)
    if len(linear.K) < LARGE:
        return whole
    from scipy.sparse import csc_array

    M, D, K = (csc_array(A) for A in whole)
    return M, D, K


def respond(
    linear: Linearised,
    matrices: tuple[Any, Any, Any],
    basis: Any,
    ins: Sequence[Input],
    outs: Outputs,
    omega: float,
) -> Complex:
    """Outputs per unit of each input at one circular frequency [rad/s], shape (no, ni)."""
    B = np.column_stack([port.at(omega) for port in ins])
    found = harmonic_response(matrices, basis, linear.states, omega, B)
    if not np.all(np.isfinite(found.place)):
        raise SolverError(f"nothing resists at {omega / (2.0 * np.pi):.6g} Hz: a rigid motion", SINGULAR)
    values = outs.place @ found.place + outs.rate @ found.rate
    if np.any(outs.react):
        G = evaluate.constraint_jacobian(linear.system, linear.state)
        values = values + outs.react @ np.linalg.lstsq(G.T.astype(complex), found.left, rcond=1e-9)[0]
    for i, port in enumerate(ins):
        if port.mesh >= 0:
            feed = outs.feed[:, port.mesh]
            damper = np.where(feed != 0.0, outs.rate @ port.follows, 0.0)
            values[:, i] += port.direct * feed - 1j * omega * damper
    return np.asarray(values)


def solve_frequency_response(
    system: System,
    inputs: Sequence[str],
    outputs: Sequence[str],
    frequencies: ArrayLike,
    scenario: Scenario | str | None = None,
    *,
    modes: int | None = None,
    synchronous: str | None = None,
    phase: float | None = None,
    start: State | None = None,
    progress: Progress = silent,
) -> xr.Dataset:
    """Frequency response as a dataset; parameters as in `find_response`.

    Returns
    -------
    xarray.Dataset
        Over `frequency` [Hz], `output` and `input`: response (complex), amplitude, phase [rad]; over
        `output` and `input`: their units.
    """
    began = time.perf_counter()
    found = find_response(
        system,
        inputs,
        outputs,
        frequencies,
        scenario,
        modes=modes,
        synchronous=synchronous,
        phase=phase,
        start=start,
        progress=progress,
    )
    wall = time.perf_counter() - began
    return response_dataset(system, found, wall_s=wall, modes=modes or "all")


def response_dataset(system: System, found: FrequencyResponse, **attrs: Any) -> xr.Dataset:
    """Dataset of a response, see `solve_frequency_response`; `attrs` as in `dataset.attributes`."""
    import xarray as xr

    from pitchpoint.solvers.dataset import attributes

    dims = ("frequency", "output", "input")
    data = {
        "response": (dims, found.response, {"long_name": "response per unit of the input"}),
        "amplitude": (dims, np.abs(found.response), {"long_name": "amplitude per unit of the input"}),
        "phase": (dims, np.angle(found.response), {"units": "rad", "long_name": "phase lead"}),
    }
    coords = {
        "frequency": ("frequency", found.frequency, {"units": "Hz", "long_name": "frequency"}),
        "output": list(found.outputs),
        "input": list(found.inputs),
        "output_unit": ("output", list(found.output_units)),
        "input_unit": ("input", list(found.input_units)),
    }
    known = attributes(system, "frequency_response", **attrs)
    return xr.Dataset(data, coords=coords, attrs={**known, "notes": join_notes(found.notes)})
