# SPDX-License-Identifier: Apache-2.0
"""Forced response to the excitation by the meshes: from flanks to bearings and housing, by order.

The loaded transmission error of each mesh and the moving centre of its force (`mesh_excitation`) excite the
linear system. Their harmonics at all speeds give the response by mesh order.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import SolverError, join_notes
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.core.words import ranges
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.frequency_response import matrices_of, respond
from pitchpoint.solvers.gear_trains import mesh_orders
from pitchpoint.solvers.inputs_outputs import check_names, find_inputs, find_outputs
from pitchpoint.solvers.linear_system import linearise, rates_of
from pitchpoint.solvers.mesh_excitation import mesh_excitation
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.over_speed import at_one_azimuth
from pitchpoint.system import evaluate
from pitchpoint.system.system import System

if TYPE_CHECKING:
    import xarray as xr

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

NO_LOAD = 1e-6
"""Force of a mesh relative to the largest one that is the residual of an equilibrium."""
RATES = {"displacement": 0, "velocity": 1, "acceleration": 2}
"""Powers of i omega of a motion."""


@dataclass(frozen=True)
class MeshResponse:
    """Complex peak amplitudes by mesh order and speed.

    Parameters
    ----------
    body
        Body of the speed.
    speed
        Its speeds [rad/s], shape (n_speed,).
    meshes, harmonics
        Mesh and multiple of the mesh frequency of every order, shape (n_order,).
    order
        Orders of the body: periods per revolution [-], shape (n_order,).
    error
        Loaded transmission error along the base tangent [m], e^(i order angle), shape (n_order,).
    response
        Response of each output, in its unit, shape (n_speed, n_order, n_output).
    outputs, units
        Names and SI units.
    mode_frequency, mode_names
        Natural frequencies [Hz] and names of the undamped modes at rest.
    notes
        Notes for the user.
    """

    body: str
    speed: Array
    meshes: tuple[str, ...]
    harmonics: tuple[int, ...]
    order: Array
    error: Complex
    response: Complex
    outputs: tuple[str, ...]
    units: tuple[str, ...]
    mode_frequency: Array
    mode_names: tuple[str, ...]
    notes: tuple[str, ...] = ()

    @property
    def frequency(self) -> Array:
        """Excitation frequency [Hz], shape (n_speed, n_order)."""
        return np.abs(self.speed)[:, None] * self.order / (2.0 * np.pi)


def motion_of(name: str) -> tuple[str, int]:
    """Split an output such as `acceleration[housing.uz]` into the displacement and the power of i omega.

    Examples
    --------
    >>> motion_of("acceleration[housing.uz]"), motion_of("bearing_force[left.fx]")
    (('housing.uz', 2), ('bearing_force[left.fx]', 0))
    """
    word, _, inside = name.partition("[")
    if word in ("velocity", "acceleration") and inside.endswith("]"):
        return inside[:-1], RATES[word]
    return name, 0


def find_mesh_response(
    system: System,
    outputs: Sequence[str],
    body: str,
    speeds: ArrayLike,
    scenario: Scenario | str | None = None,
    *,
    harmonics: int = 3,
    points: int = 64,
    progress: Progress = silent,
) -> MeshResponse:
    """Response to the loaded transmission error and moving force of every mesh, over the speed of a body.

    Parameters
    ----------
    system
        The compiled model.
    outputs
        Outputs as in `inputs_outputs`, and `velocity[NAME]` and `acceleration[NAME]` of a displacement.
    body
        Body of the speed.
    speeds
        [rad/s], shape (n_speed,), not zero. The direction of rotation is that of the scenario, whatever
        their sign.
    scenario
        Scenario with the loads; as in `modal.find_modes`.
    harmonics
        Number of multiples of each mesh frequency.
    points
        Positions of the slow roll per mesh period; harmonics up to a quarter of it.
    progress
        Called after every speed.

    Raises
    ------
    ModelError
        If a name is unknown, a body cannot move in a direction, or a channel has no derivative.
    SolverError
        If a speed is zero, there is no equilibrium, or no mesh turns with the body.

    Notes
    -----
    y(i omega) = H(i omega) p(i omega) + H_D(i omega) e_f(i omega), omega = h z n: H is the response to
    generalised forces, H_D that to a transmission error through the dampers (`frequency_response`), p the
    excitation at constant torque and e_f the error of the flanks (`mesh_excitation`). At low speed the
    gears follow the loaded transmission error. Valid while the flanks stay in contact and the dynamic mesh
    force is small against the mean force, since the variation of the stiffness then excites with the static
    deflection; near parametric resonances and after contact loss run a time response. Excitations of
    different
    meshes have the phases of the initial position.
    """
    displacements, powers = zip(*(motion_of(name) for name in outputs), strict=True)
    check_names(system, (), displacements, (body,))
    turning = np.atleast_1d(np.asarray(speeds, dtype=np.float64))
    if not np.all(np.abs(turning) > 0.0):
        raise SolverError("a speed is zero, at which no mesh excites; use speeds above zero", INCONSISTENT)
    if not 1 <= harmonics <= points // 4:
        raise SolverError(f"harmonics: {harmonics} (limit 1 to {points // 4})", INCONSISTENT)
    linear = linearise(system, scenario, turning=body)
    rates = rates_of(linear, body, scenario)
    orders = {m: o for m, o in mesh_orders(linear.system, rates).items() if o > 0.0}
    if not orders:
        raise SolverError(f"no mesh turns with {body}; choose another body", INCONSISTENT)
    outs = find_outputs(linear, displacements)
    excitations, notes = [], list(linear.notes)
    values = evaluate.observe(linear.system, linear.state)
    forces = {m: abs(float(values[linear.system.layout.channel(f"mesh_force[{m}]")])) for m in orders}
    least = NO_LOAD * max(forces.values())
    loaded = {m: order for m, order in orders.items() if m not in linear.flanks and forces[m] > least}
    if loaded and len(loaded) < len(orders):  # such as idle pairs of a gearbox with several gears
        notes.append(f"{ranges([m for m in orders if m not in loaded])}: without load, not an excitation")
        orders = loaded
    for mesh in orders:
        excitations.append(mesh_excitation(system, scenario, linear, mesh, harmonics, points, along=rates))
        notes += [n for n in excitations[-1].notes if n not in notes]
    ports = find_inputs(linear, [f"transmission_error[{m}]" for m in orders])
    ins = [
        [found.inputs(port, h) for h in range(harmonics)]
        for found, port in zip(excitations, ports, strict=True)
    ]
    response = np.zeros((turning.size, len(orders), harmonics, len(outputs)), complex)
    rise = np.array(powers)
    over = at_one_azimuth(linear, rates)
    for s, speed in enumerate(turning):
        at = over.at(abs(float(speed)))
        matrices = matrices_of(at)
        for m, order in enumerate(orders.values()):
            for h in range(1, harmonics + 1):
                omega = abs(speed) * h * order
                found = respond(at, matrices, at.basis, ins[m][h - 1], outs, omega)
                response[s, m, h - 1] = found.sum(axis=1) * (1j * omega) ** rise
        progress(s + 1, turning.size, "speeds")
    modes = find_modes(system, scenario, linear=linear)
    return MeshResponse(
        body,
        turning,
        tuple(m for m in orders for _ in range(harmonics)),
        tuple(h for _ in orders for h in range(1, harmonics + 1)),
        np.array([h * o for o in orders.values() for h in range(1, harmonics + 1)]),
        np.concatenate([found.error for found in excitations]),
        response.reshape(turning.size, -1, len(outputs)),
        tuple(outputs),
        tuple(f"{u}{('', '/s', '/s^2')[p]}" for u, p in zip(outs.units, powers, strict=True)),
        modes.frequency,
        modes.names,
        tuple(notes),
    )


def solve_mesh_response(
    system: System,
    outputs: Sequence[str],
    body: str,
    speeds: ArrayLike,
    scenario: Scenario | str | None = None,
    *,
    harmonics: int = 3,
    points: int = 64,
    progress: Progress = silent,
) -> xr.Dataset:
    """Response to the excitation by the meshes as a dataset; parameters as in `find_mesh_response`.

    Returns
    -------
    xarray.Dataset
        Over `speed` [rad/s], `order` (of the body) and `output`: response (complex peak amplitude),
        amplitude; over `speed` and `order`: frequency [Hz]; over `order`: mesh, harmonic, error [m]; over
        `output`: unit; over `mode`: mode_frequency [Hz], mode_name.
    """
    began = time.perf_counter()
    found = find_mesh_response(
        system, outputs, body, speeds, scenario, harmonics=harmonics, points=points, progress=progress
    )
    return mesh_response_dataset(system, found, wall_s=time.perf_counter() - began)


def mesh_response_dataset(system: System, found: MeshResponse, **attrs: Any) -> xr.Dataset:
    """Dataset of a response, see `solve_mesh_response`; `attrs` as in `dataset.attributes`."""
    import xarray as xr

    from pitchpoint.solvers.dataset import attributes

    dims = ("speed", "order", "output")
    data = {
        "response": (dims, found.response, {"long_name": "response to the excitation by the meshes"}),
        "amplitude": (dims, np.abs(found.response), {"long_name": "peak amplitude"}),
        "frequency": (dims[:2], found.frequency, {"units": "Hz", "long_name": "excitation frequency"}),
        "error": ("order", np.abs(found.error), {"units": "m", "long_name": "loaded transmission error"}),
        "mode_frequency": ("mode", found.mode_frequency, {"units": "Hz", "long_name": "natural frequency"}),
    }
    coords: dict[str, Any] = {
        "speed": ("speed", found.speed, {"units": "rad/s", "long_name": f"speed of {found.body}"}),
        "order": ("order", found.order, {"units": "1", "long_name": f"order of {found.body}"}),
        "output": list(found.outputs),
        "unit": ("output", list(found.units)),
        "mesh": ("order", list(found.meshes)),
        "harmonic": ("order", list(found.harmonics)),
        "mode_name": ("mode", list(found.mode_names)),
    }
    known = attributes(system, "mesh_response", body=found.body, **attrs)
    return xr.Dataset(data, coords=coords, attrs={**known, "notes": join_notes(found.notes)})
