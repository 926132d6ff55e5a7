# SPDX-License-Identifier: Apache-2.0
"""Notes of analyses other than time responses on controllers, and the controllers they cannot include."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.elements.kind import SIGNAL
from pitchpoint.elements.signals.graph import LOADS
from pitchpoint.model.signals import rates_behind
from pitchpoint.system.source import source

if TYPE_CHECKING:
    from pitchpoint.system.system import System


def held_outputs(system: System) -> tuple[str, ...]:
    """A sentence about sampled controllers where they are not called."""
    if not system.controllers:
        return ()
    names = ", ".join(c.name for c in system.controllers)
    return (f"nothing calls the sampled controllers here ({names}): their outputs keep their start values",)


def refuse_sampled(system: System, what: str) -> None:
    """Stop where sampled controllers have no instants.

    Parameters
    ----------
    system
        The system.
    what
        The analysis, for the sentence.
    """
    if system.controllers:
        names = ", ".join(_named(system, "controllers", c.name) for c in system.controllers)
        raise SolverError(
            f"{what} cannot call sampled controllers ({names}); use blocks instead, or run a time response",
            INCONSISTENT,
        )


def refuse_rates(system: System, what: str) -> None:
    """Stop where nothing moves and an actuator follows a speed.

    Parameters
    ----------
    system, what
        As in `refuse_sampled`.
    """
    refuse_sampled(system, what)
    for name, signal in rates_behind(system.model).items() if system.model is not None else ():
        raise SolverError(
            f"{what} has no speeds, and {_named(system, 'actuators', name)} follows one, signal[{signal}]; "
            "give the torque as a load instead, or run a time response",
            INCONSISTENT,
        )


def _named(system: System, section: str, name: str) -> str:
    """Component with its line, if the system comes from a file."""
    line = system.model.line((section, name)) if system.model is not None else None
    return f"{section}.{name}" + (f" (line {line})" if line is not None else "")


def refuse_loads(system: System, what: str) -> None:
    """Stop where bodies and observations get new numbers and signals sense loads by the old ones.

    Parameters
    ----------
    system, what
        As in `refuse_sampled`.
    """
    for kind in system.kinds(SIGNAL):
        for record, name in zip(system.records[kind], system.names.get(kind, ()), strict=True):
            if int(record["op"]) in LOADS:
                raise SolverError(
                    f"{what} cannot keep {source(system, kind, name)}, which senses a load; leave it out",
                    INCONSISTENT,
                )
