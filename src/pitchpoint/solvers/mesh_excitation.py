# SPDX-License-Identifier: Apache-2.0
"""Excitation by a mesh under load, by harmonics of the mesh frequency, from a slow roll.

With the mean stiffness K of the mesh and the rotation s of `mesh_law`, k = s^T K s, the excitation is

    p = K s e + c

At the force F along the base tangent and the deflection q of the roll, e = s^T K q/k - F/k; where one mesh
carries a constant torque, this is the loaded transmission error. The shuttling forces c tilt helical gears
(`tooth_wave`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import report_step
from pitchpoint.core.status import OK
from pitchpoint.model.scenario import Scenario
from pitchpoint.model.tooth_errors import periods_of_errors
from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.inputs_outputs import Input
from pitchpoint.solvers.linear_system import Linearised
from pitchpoint.solvers.mesh_law import mesh_law
from pitchpoint.solvers.operating_point import scenario_named
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.system.meshes import mesh_names, mesh_record
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class MeshExcitation:
    """Harmonics of the excitation, complex peak amplitudes over the position, from the initial one.

    Parameters
    ----------
    error
        Loaded transmission error [m], shape (n,).
    flank_error
        Error of the flanks [m], whose rate the dampers feel: teeth of varying stiffness move without moving
        the flanks, shape (n,).
    forces
        Generalised forces p, shape (n, nd).
    travel
        Part of p along the base tangent as an error e of the flanks [m], shape (n,).
    notes
        Notes for the user.
    """

    error: Complex
    flank_error: Complex
    forces: Complex
    travel: Complex
    notes: tuple[str, ...]

    def inputs(self, port: Input, h: int) -> tuple[Input, Input]:
        """Excitation by number h of the harmonics, of the transmission error `port`: stiffness, dampers."""
        none = np.zeros_like(port.force)
        stiff = replace(port, force=self.forces[h], rate=none, follows=none, direct=self.travel[h])
        e = self.flank_error[h]
        return stiff, replace(port, force=none, rate=e * port.rate, follows=e * port.follows, direct=0.0)


def mesh_excitation(
    system: System,
    scenario: Scenario | str | None,
    linear: Linearised,
    mesh: str,
    harmonics: int,
    points: int,
    along: Array | None = None,
) -> MeshExcitation:
    """Excitation by a mesh under the loads of a scenario.

    The errors are means over all tooth pairs (`rolled_periods`), so that eccentric gears and single teeth do
    not count as orders of the mesh. The roll goes in the direction of the rates `along`, by default those of
    the scenario, with `points` positions per period.
    """
    chosen, k = scenario_named(system, scenario), mesh_names(system).index(mesh)
    law = mesh_law(linear.system, linear.at_rest, k)
    seen: list[tuple[float, float, float]] = []

    def look(own: System, state: State, row: Array) -> None:
        """Keep error of the flanks, phase of the loaded flank, and deflection along the base tangent."""
        now = mesh_record(own, k)["now"]
        back = row[own.layout.channel(f"contact_state[{mesh}]")] < 0.0
        phase = float(now["psi"]) if back else float(row[own.layout.channel(f"mesh_phase[{mesh}]")])
        force = float(row[own.layout.channel(f"mesh_force[{mesh}]")])
        seen.append((float(now["e_t"]), phase, float(law.force @ state.unwrapped(own)) - force))

    at, share = (
        ((0,), np.ones(1)) if system.model is None else rolled_periods(*periods_of_errors(system.model, mesh))
    )
    roll = roll_through(
        system, chosen, points, mesh=mesh, others=False, look=look, at=at, along=along, progress=_of_roll
    )
    if roll.status != OK:
        raise SolverError(f"slow roll of {mesh}: {roll.sentence}", roll.status)
    curve = roll.rows[:-1, system.layout.channel(f"transmission_error[{mesh}]")]
    flanks, phase, balance = np.array(seen[: curve.size]).T
    travel = balance / law.mean if law.mean > 0.0 and not is_looped(system) else curve
    mean = share @ np.array([curve, flanks, travel]).reshape(3, -1, points)
    error, flank_error, e = (2.0 * np.fft.rfft(mean) / points)[:, 1 : harmonics + 1]
    shuttling = law.excitation(harmonics, phase[0], bool(phase[1] > phase[0]))[1]
    return MeshExcitation(error, flank_error, np.outer(e, law.stiffness) + shuttling, e, roll.notes)


def _of_roll(done: float, total: float, note: str = "") -> None:
    """Report the progress of a roll, which comes before the speeds."""
    report_step(f"{note}, {100.0 * done / total:.0f} %")


def rolled_periods(n_1: int, n_2: int) -> tuple[tuple[int, ...], Array]:
    """Periods of a mesh whose weighted mean is that over all pairs of teeth, and their weights.

    Parameters
    ----------
    n_1, n_2
        Periods after which the errors of gear 1 and of gear 2 repeat.

    Notes
    -----
    With errors of both gears the mean is that over the hunting period of lcm(n_1, n_2) periods for
    e = f(psi) + f_1(psi, tooth of gear 1) + f_2(psi, tooth of gear 2): the mean over the teeth of gear 1 that
    meet one tooth of gear 2, plus that over the teeth of gear 2 that meet one tooth of gear 1, less the pair
    that is in both. Products of errors of both gears are neglected. Tooth numbers with a common divisor g
    have g such sets of pairs.

    Examples
    --------
    >>> rolled_periods(1, 3)
    ((0, 1, 2), array([0.33333333, 0.33333333, 0.33333333]))
    >>> rolled_periods(2, 3)[0]
    (0, 3, 2, 4)
    """
    if min(n_1, n_2) == 1:
        n = max(n_1, n_2)
        return tuple(range(n)), np.full(n, 1.0 / n)
    share: dict[int, float] = {}
    g = math.gcd(n_1, n_2)
    for r in range(g):
        for own, step in ((n_1, n_2), (n_2, n_1)):
            for k in range(own // g):
                share[r + k * step] = share.get(r + k * step, 0.0) + 1.0 / own
        share[r] -= 1.0 / g
    return tuple(share), np.array(list(share.values()))
