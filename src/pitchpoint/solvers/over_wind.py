# SPDX-License-Identifier: Apache-2.0
"""The linear system of a turbine over the wind speed, in multi-blade coordinates."""

from __future__ import annotations

from dataclasses import replace

from pitchpoint.core.errors import CompileError, SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.solvers.linear_system import ONE_POSITION, Linearised
from pitchpoint.solvers.over_speed import MULTIBLADE, bladed_hubs
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.solvers.turning_rotors import TurningRotors
from pitchpoint.solvers.wind_states import WindStates

AZIMUTHS = 6
"""Positions within the angle between two blades, see `multiblade.AZIMUTHS`."""


class OverWind:
    """An `OverSpeed` whose speeds are those of the wind [m/s].

    Parameters
    ----------
    linear
        The system about the operating point of a scenario.
    rates
        Rates of all coordinates with the hub at 1 rad/s.

    Raises
    ------
    SolverError
        If no rotor with blades on bodies or beams turns in a steady wind.
    """

    def __init__(self, linear: Linearised, rates: Array) -> None:
        bladed = bladed_hubs(linear.system, rates)
        if not bladed:
            raise SolverError(
                "no rotor with elastic blades or blades on bodies turns, so there are no modes over the wind "
                "speed; give the scenario a speed of the rotor, and the rotor beams or bodies",
                INCONSISTENT,
            )
        try:
            self.axes = TurningRotors(linear.system, list(bladed.values()), rates)
            self.axes.basis(linear)  # refuses loops between blades
        except CompileError as error:
            raise SolverError(f"no modes in {MULTIBLADE}: {error}", INCONSISTENT) from error
        self.states, self.rotors = WindStates(linear, rates), tuple(bladed)
        self.notes: tuple[str, ...] = (
            f"modes of {', '.join(bladed)} in {MULTIBLADE}: "
            "the frequencies are those in axes that do not turn",
        )
        self.reference = linear

    def prepare(self, speeds: Array) -> None:
        """Find the operation at some wind speeds [m/s]; the first one names the modes."""
        self.states.prepare(speeds)
        known = [float(wind) for wind in speeds if float(wind) in self.states.found]
        if not known:
            raise self.states.failed[float(speeds[0])]
        self.reference = self.at(known[0])

    def rate(self, speed: float) -> float:
        """Speed of the hub [rad/s] at a wind speed [m/s]."""
        return self.states.operation(speed).speed

    def at(self, speed: float) -> Linearised:
        """The linear system at a wind speed [m/s], the mean over the azimuth."""
        linear = self.states.at(speed)
        found = self.axes.mean(self.states, linear, self.rate(speed), AZIMUTHS)
        notes = tuple(text for text in linear.notes if ONE_POSITION not in text)
        return replace(found, notes=(*notes, *self.notes), axes=self.axes)
