# SPDX-License-Identifier: Apache-2.0
"""Error of the steady vibration by the step of generalised-alpha, from the linear system at the start.

For a vibration z^n, z = e^(i omega h), the formulas of the method give the rates and accelerations

    q' = s_1 q,   q'' = s_2 q

instead of i omega q and -omega^2 q. So the method solves (K + s_1 D + s_2 M) q = p exactly: its vibration is
that of the machine at a frequency higher by about (omega h)^2/11 (rho_inf 0.8). Natural frequencies
there come out lower by this share, and a lightly damped mode close to a mesh frequency moves into the
resonance or out of it. The response to the meshes with both matrices gives the error of the forces.

Source of the formulas: M. Arnold, O. Bruels, Multibody System Dynamics 18 (2007) 185-202.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError, SolverError, note
from pitchpoint.core.units import format_quantity
from pitchpoint.core.words import listed
from pitchpoint.solvers.cycle_means import moving_phases
from pitchpoint.solvers.frequency_response import matrices_of, respond
from pitchpoint.solvers.gear_trains import mesh_orders
from pitchpoint.solvers.implicit.generalized_alpha import RHO_INF
from pitchpoint.solvers.implicit.step import coefficients
from pitchpoint.solvers.inputs_outputs import Input, Outputs, find_inputs, find_outputs
from pitchpoint.solvers.linear_system import Linearised, linearise
from pitchpoint.solvers.mesh_excitation import MeshExcitation
from pitchpoint.solvers.mesh_law import mesh_law
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_names

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.solvers.initial_state.start import Start
    from pitchpoint.system.system import State

Array = NDArray[np.float64]

HARMONICS = 6
"""Multiples of every mesh frequency."""
FINE = 100
"""Steps per mesh period from which nothing is computed: natural frequencies at three times the mesh frequency
are lowered by 0.3 %, which changes the flank of a resonance with a damping ratio of 2 % by 8 %."""
NOTED = 0.05
"""Relative error of an alternating force from which it is noted."""
ENOUGH = 0.02
"""Largest error with the step that the note recommends."""
MINOR = 0.05
"""Alternating force over the largest one of its kind up to which its error does not matter."""
NEGLIGIBLE = 1e-3
"""Amplitude over the largest mean force of its kind up to which a force is constant."""
STEADY = 0.02
"""Relative change of a mesh frequency in the run up to which its vibration is steady."""
MOST = 400
"""Largest number of coordinates for which the error is estimated."""
BEARING, MESH = "bearing_force", "mesh_force"
ALONG = (".fx]", ".fy]", ".fz]")


def equivalent(omega: float, h: float, rho_inf: float = RHO_INF) -> tuple[complex, complex]:
    """Factors s_1 and s_2 of rates and accelerations of a vibration in the method.

    Parameters
    ----------
    omega
        Circular frequency [rad/s].
    h
        Step [s]; 0 for the exact factors.
    rho_inf
        Spectral radius at infinite frequency.

    Examples
    --------
    660 Hz with steps of 0.1 ms, 15 per period: as 670.2 Hz with exact factors.

    >>> s_1, s_2 = equivalent(2.0 * math.pi * 660.0, 1e-4)
    >>> round(cmath.sqrt(-s_2).real / 2.0 / math.pi, 1)
    670.2
    """
    if h == 0.0:
        return 1j * omega, complex(-(omega**2))
    beta, gamma, alpha_m, alpha_f = coefficients(rho_inf)
    z = cmath.exp(1j * omega * h)
    rate = h * (1.0 - gamma + gamma * z) / (z - 1.0)  # per unit of the algorithmic acceleration
    place = (h * rate + h * h * (0.5 - beta + beta * z)) / (z - 1.0)
    acceleration = ((1.0 - alpha_m) * z + alpha_m) / ((1.0 - alpha_f) * z + alpha_f)
    return rate / place, acceleration / place


def frequency_shift(omega: float, h: float) -> float:
    """Share by which natural frequencies at a circular frequency come out lower.

    Examples
    --------
    >>> round(frequency_shift(2.0 * math.pi * 660.0, 1e-4), 4)
    0.0154
    """
    return abs(cmath.sqrt(-equivalent(omega, h)[1])) / omega - 1.0


def step_notes(start: Start, scenario: Scenario, h: float, end: State) -> tuple[Message, ...]:
    """Note on the forces that the step changes, with the step that is short enough.

    Parameters
    ----------
    start
        Start of the run.
    scenario
        Its scenario.
    h
        Its step [s].
    end
        State at its end: meshes whose frequency changes have none.
    """
    system = start.system
    if scenario.method != "generalized_alpha" or not 0 < system.sizes["nd"] <= MOST:
        return ()
    after = mesh_orders(system, end.v)
    steady = {
        mesh: omega
        for mesh, omega in mesh_orders(system, start.mean.v).items()
        if omega > 0.0 and abs(after[mesh] - omega) <= STEADY * omega
    }
    if max(steady.values(), default=0.0) * h * FINE <= math.tau:
        return ()
    try:
        linear = linearise(system, scenario, start=start.mean, settled=False)
        response = _response(linear, steady)
    except (SolverError, ModelError):  # without an equilibrium, or a channel without a derivative
        return ()
    return response.notes(h)


@dataclass(frozen=True)
class _Response:
    """Linear vibration by the excitation of the meshes.

    Parameters
    ----------
    linear, outs
        The linear system, and its forces by component.
    forces, mean, mixed
        Names of the forces, their means [N], and their shares of the components: radial forces in the
        direction of their mean.
    excited
        Circular frequency [rad/s], its name, and the excitation by the meshes.
    """

    linear: Linearised
    outs: Outputs
    forces: tuple[str, ...]
    mean: Array
    mixed: Array
    excited: Sequence[tuple[float, str, tuple[Input, ...]]]

    def amplitudes(self, h: float) -> Array:
        """Amplitude of every force at every frequency, with steps of h or exact (0), shape (nf, n)."""
        M, D, K = matrices_of(self.linear)
        found = np.zeros((len(self.excited), len(self.forces)))
        for row, (omega, _, inputs) in zip(found, self.excited, strict=True):
            if omega * h >= math.pi:  # less than two steps per period
                continue
            s_1, s_2 = equivalent(omega, h)
            # the small damping forces of outputs keep the exact rate
            at = (M * (-s_2 / omega**2), D * (s_1 / (1j * omega)), K)
            y = respond(self.linear, at, self.linear.basis, inputs, self.outs, omega).sum(axis=1)
            row[:] = np.abs(self.mixed @ y)
        return found

    def notes(self, h: float) -> tuple[Message, ...]:
        """Note on the largest errors with steps of h."""
        exact, found = self.amplitudes(0.0), self.amplitudes(h)
        errors = self._errors(exact, found)
        worst = [max(own, key=lambda k: abs(errors[k])) for own in self._kinds() if own]
        worst = [k for k in worst if abs(errors[k]) >= NOTED]
        if not worst:
            return ()
        first = max(worst, key=lambda k: abs(errors[k]))
        at = int(np.argmax(np.abs(found[:, first] ** 2 - exact[:, first] ** 2)))
        omega, mesh, _ = self.excited[at]
        parts = [f"{self.forces[k]} by {100.0 * errors[k]:+.0f} %" for k in worst]
        text = (
            "by a linear estimate the step changes the alternating part of "
            f"{listed(parts)}, mostly at {format_quantity(omega / math.tau, 'frequency', 4)} ({mesh}), where "
            f"{math.tau / (omega * h):.1f} steps per period lower natural frequencies by "
            f"{100.0 * frequency_shift(omega, h):.2g} %"
        )
        return (note(text, "step", remedy=f"use {self._short_enough(exact, h)}"),)

    def _kinds(self) -> list[list[int]]:
        """Numbers of the forces of bearings, and of meshes."""
        of = [name.partition("[")[0] for name in self.forces]
        return [[k for k, own in enumerate(of) if own == kind] for kind in (BEARING, MESH)]

    def _errors(self, exact: Array, found: Array) -> Array:
        """Relative error of every alternating force; zero if the force is minor."""
        true, own = (np.sqrt((x**2).sum(axis=0)) for x in (exact, found))
        errors, size = np.zeros(true.size), np.maximum(true, own)
        for kind in self._kinds():
            least = max(
                MINOR * size[kind].max(initial=0.0), NEGLIGIBLE * np.abs(self.mean[kind]).max(initial=0.0)
            )
            major = [k for k in kind if size[k] > least]
            errors[major] = own[major] / np.maximum(true[major], 1e-300) - 1.0
        return errors

    def _short_enough(self, exact: Array, h: float) -> str:
        """Step with errors below `ENOUGH`, in words."""
        for _ in range(6):
            h *= 0.5
            error = float(np.abs(self._errors(exact, self.amplitudes(h))).max())
            if error <= ENOUGH:
                break
        return f"{format_quantity(h, 'time', 3)} ({100.0 * error:.1g} %)"


def _response(linear: Linearised, steady: Mapping[str, float]) -> _Response:
    """The linear system with the excitation by meshes of given circular frequencies."""
    system = linear.system
    channels = [c.name for c in system.layout.channels]
    own = [name for name in channels if name.startswith(f"{BEARING}[") and name.endswith(ALONG)]
    own += [f"{MESH}[{mesh}]" for mesh in mesh_names(system)]
    forces, mixed = list(own), list(np.eye(len(own)))
    observed = evaluate.observe(system, linear.state)
    for k, name in enumerate(own):
        if name.endswith(".fx]"):
            across = np.array([observed[system.layout.channel(name[:-3] + word)] for word in ("fx]", "fy]")])
            if (radial := float(np.linalg.norm(across))) > 0.0:
                forces.append(f"{name[:-3]}radial]")
                mixed.append(np.zeros(len(own)))
                mixed[-1][[k, own.index(f"{name[:-3]}fy]")]] = across / radial
    excited: list[tuple[float, str, tuple[Input, ...]]] = []
    for mesh, h, omega, port in _ports(linear, steady):
        same = next((e for e, found in enumerate(excited) if math.isclose(found[0], omega, rel_tol=1e-6)), -1)
        word = f"mesh frequency of {mesh}" if h == 1 else f"{h} times the mesh frequency of {mesh}"
        if same < 0:
            excited.append((omega, word, (port,)))
        else:
            excited[same] = (omega, excited[same][1], (*excited[same][2], port))
    mean = observed[[system.layout.channel(name) for name in forces]]
    return _Response(linear, find_outputs(linear, own), tuple(forces), mean, np.array(mixed), excited)


def _ports(linear: Linearised, steady: Mapping[str, float]) -> list[tuple[str, int, float, Input]]:
    """Mesh, harmonic, circular frequency and excitation of every harmonic of the loaded meshes."""
    system = linear.system
    phases = moving_phases(system, linear.state, linear.state.v)
    found = []
    for mesh, omega in steady.items():
        law = mesh_law(system, linear.at_rest, mesh_names(system).index(mesh))
        if law.wave is None:
            continue
        e, shuttling = law.excitation(HARMONICS, *phases[mesh])
        forces = np.outer(e, law.stiffness) + shuttling
        excitation = MeshExcitation(e, np.zeros_like(e), forces, e, ())
        port = find_inputs(linear, [f"transmission_error[{mesh}]"])[0]
        found += [(mesh, h, h * omega, excitation.inputs(port, h - 1)[0]) for h in range(1, HARMONICS + 1)]
    return found
