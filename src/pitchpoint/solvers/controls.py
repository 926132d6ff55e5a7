# SPDX-License-Identifier: Apache-2.0
"""Controllers in analyses other than time responses: notes, and errors for those that cannot be included."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.elements.kind import SIGNAL
from pitchpoint.elements.signals.graph import LOADS
from pitchpoint.model.signals import rates_behind
from pitchpoint.system.source import named, source

if TYPE_CHECKING:
    from pitchpoint.system.system import System


def held_outputs(system: System) -> tuple[str, ...]:
    """Note on sampled controllers that an analysis does not call."""
    if not system.controllers:
        return ()
    names = ", ".join(c.name for c in system.controllers)
    return (f"sampled controllers ({names}) are not called here: their outputs have their initial values",)


def refuse_sampled(system: System, what: str) -> None:
    """Raise an error if the system has sampled controllers, for analyses without time.

    Parameters
    ----------
    system
        The system.
    what
        The analysis, for the message.
    """
    if system.controllers:
        names = ", ".join(named(system, ("controllers", c.name)) for c in system.controllers)
        raise SolverError(
            f"{what} cannot call sampled controllers ({names}); use blocks instead, or run a time response",
            INCONSISTENT,
        )


def refuse_rates(system: System, what: str) -> None:
    """Raise an error if an actuator depends on a speed, for analyses without speeds.

    Parameters
    ----------
    system, what
        As in `refuse_sampled`.
    """
    refuse_sampled(system, what)
    for name, signal in rates_behind(system.model).items() if system.model is not None else ():
        raise SolverError(
            f"{what} has no speeds, but {named(system, ('actuators', name))} depends on signal[{signal}]; "
            "give the torque as a load instead, or run a time response",
            INCONSISTENT,
        )


def refuse_loads(system: System, what: str) -> None:
    """Raise an error if a signal senses a load, for analyses that renumber bodies and channels.

    Parameters
    ----------
    system, what
        As in `refuse_sampled`.
    """
    for kind in system.kinds(SIGNAL):
        for record, name in zip(system.records[kind], system.names.get(kind, ()), strict=True):
            if int(record["op"]) in LOADS:
                raise SolverError(
                    f"{what} cannot include {source(system, kind, name)}, which senses a load; remove it",
                    INCONSISTENT,
                )
