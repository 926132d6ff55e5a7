# SPDX-License-Identifier: Apache-2.0
"""Operating range: lowest and highest speed of a body in the scenarios of a model file."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from pitchpoint.model.components.law import Law
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Drive, Scenario
    from pitchpoint.system.system import System

    Array = NDArray[np.float64]

MOMENTS = 1001
"""Number of times at which a drive is evaluated, in addition to the nodes of its table."""


def model_of(system: System) -> Model:
    """Model from which a system of a report was compiled."""
    if system.model is None:
        raise SolverError("the system was not compiled from a model", INCONSISTENT)
    return system.model


def operating_range(
    system: System, body: str, scenarios: Iterable[Scenario] | None = None
) -> tuple[float, float] | None:
    """Lowest and highest speed of a body in some or all scenarios [rad/s]; None if it rotates in none."""
    chosen = model_of(system).scenarios.values() if scenarios is None else scenarios
    found = [own for scenario in chosen if (own := speed_range(system, scenario, body))[1] > 0.0]
    return (min(low for low, _ in found), max(high for _, high in found)) if found else None


def speed_range(system: System, scenario: Scenario, body: str) -> tuple[float, float]:
    """Lowest and highest speed of a body in a scenario [rad/s], as far as the model file defines it.

    Prescribed motions and sweeps count with their whole range and with the fluctuation of their ripples;
    given speeds count for bodies that no drive rotates. The direction of rotation does not matter: a reversal
    begins at zero.

    Parameters
    ----------
    system
        System compiled from the model of the scenario.
    scenario
        The scenario.
    body
        The body; its speed follows from the gear ratios.

    Returns
    -------
    tuple
        Magnitudes; zeros if the scenario does not rotate the body.
    """
    model = model_of(system)
    motions = {n: own for n, own in prescribed(system, scenario).items() if n in model.bodies}
    fastest = {name: float(np.abs(speeds).max()) for name, (speeds, _) in motions.items()}
    driven = model.start_speeds(replace(scenario, speed=fastest)) if motions else {}
    free = {
        n: (np.array([w]), 0.0) for n, w in scenario.speed.items() if not driven.get(n) and n not in motions
    }
    given = {**motions, **free}
    mean: Array = np.zeros(1)
    spread: Array = np.zeros(1)
    for name, (speeds, ripple) in given.items():
        # the same bodies are given each time: the speeds are linear in the given ones
        alone = {other: float(other == name) for other in given}
        ratio = model.start_speeds(replace(scenario, speed=alone)).get(body, 0.0)
        mean = mean + ratio * speeds
        spread = spread + abs(ratio * ripple) * np.abs(speeds)
    low, high = float((mean - spread).min()), float((mean + spread).max())
    least, most = sorted((abs(low), abs(high)))
    return (0.0 if low < 0.0 < high else least), most


def prescribed(system: System, scenario: Scenario) -> dict[str, tuple[Array, float]]:
    """Prescribed mean speeds [rad/s] over common times, and relative fluctuation, by body.

    Motions that only a run can evaluate are omitted.
    """
    from pitchpoint.solvers.sweep_speeds import sweep_range

    moments = moments_of(scenario)
    found: dict[str, tuple[Array, float]] = {}
    for name, drive in scenario.drive.items():
        speeds = drive_speeds(drive, moments)
        if speeds is not None:
            found[name] = (speeds, fluctuation(drive))
    sweep = scenario.sweep
    if sweep is not None:
        own, ends = scenario.drive.get(sweep.body), np.array(sweep_range(system, scenario))
        found[sweep.body] = (ends, 0.0 if own is None else fluctuation(own))
        found |= {n: (s[:1], ripple) for n, (s, ripple) in found.items() if n != sweep.body}
    return found


def fluctuation(drive: Drive) -> float:
    """Largest deviation of the speed of a drive from its mean by its ripples, over the mean speed.

    The angle phi + sum a_k sin(k phi + beta_k) has the rate (1 + sum k a_k cos(...)) dphi/dt. Several waves
    count with the sum of their amplitudes, an upper bound.

    Examples
    --------
    >>> from pitchpoint.model.components.law import Constant
    >>> from pitchpoint.model.scenario import Drive, Ripple
    >>> fluctuation(Drive(speed=Constant(100.0), ripple={"engine": Ripple(order=2.0, fluctuation=0.02)}))
    0.01
    """
    return float(sum(wave.order * wave.amplitude for wave in drive.ripple.values()))


def moments_of(scenario: Scenario) -> Array:
    """Times from zero to the end of a scenario, with the nodes of the tables of its drives [s]."""
    from pitchpoint.model.components.law import TableLaw

    end = scenario.duration or 0.0
    laws = [law for drive in scenario.drive.values() for law in (drive.speed, drive.angle)]
    nodes = [np.array(law.abscissa) for law in laws if isinstance(law, TableLaw)]
    times = np.concatenate([np.linspace(0.0, end, MOMENTS if end > 0.0 else 1), *nodes])
    return np.unique(times[(times >= 0.0) & (times <= end)])


def drive_speeds(drive: Drive, moments: Array) -> Array | None:
    """Mean speed of a drive at some times [rad/s]; None if only a run can evaluate it."""
    if drive.speed is not None:
        return _values(drive.speed, moments, "angular_speed")
    if drive.angle is None:
        return None
    angles = _values(drive.angle, moments, "angle")
    if angles is None or moments.size < 2:
        return angles if angles is None else np.zeros(1)
    rates = np.diff(angles) / np.diff(moments)
    return np.append(rates, rates[-1])


def _values(law: Law, moments: Array, dimension: str) -> Array | None:
    """Values of a law at some times; None if only a run can evaluate it."""
    from pitchpoint.core.formula.formula import Formula
    from pitchpoint.model.components.law import Constant, FormulaLaw, TableLaw

    if isinstance(law, Constant):
        return np.full(moments.size, law.value)
    if isinstance(law, TableLaw):
        return np.interp(moments, law.abscissa, law.values)
    if isinstance(law, FormulaLaw):
        rest = (0.0,) * (len(law.variables) - 1)
        formula = Formula.parse(law.text, law.variables, dimension)
        return np.array([float(formula(t, *rest)) for t in moments])
    return None
