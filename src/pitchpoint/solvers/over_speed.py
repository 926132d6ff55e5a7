# SPDX-License-Identifier: Apache-2.0
"""The linear system over the speed of a body: in one position, in equilibrium, or of turning rotors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Protocol

import numpy as np

from pitchpoint.core.errors import CompileError
from pitchpoint.multibody.bodies import GENERAL
from pitchpoint.solvers.linear_system import ONE_POSITION, Linearised
from pitchpoint.solvers.speed_states import SpeedStates
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.solvers.turning_rotors import TurningRotors
from pitchpoint.system import evaluate
from pitchpoint.system.system import System

AZIMUTHS = 3
"""Positions within the angle between two blades. With the flow around the tower, frequencies of blades are
then within 0.7 % of those of many positions (first flapwise modes, damped by 40 to 60 %)."""
MULTIBLADE = "multi-blade coordinates"
"""What the frequencies of turning rotors refer to, for notes and outputs."""


class OverSpeed(Protocol):
    """The linear system as function of the speed.

    Attributes
    ----------
    reference
        The linear system whose modes at rest name the curves.
    notes
        Notes for the user.
    rotors
        Names of the wind rotors in multi-blade coordinates.
    """

    reference: Linearised
    notes: tuple[str, ...]
    rotors: tuple[str, ...]

    def at(self, speed: float) -> Linearised:
        """The linear system at a speed of the reference body [rad/s]; SolverError without an equilibrium."""

    def prepare(self, speeds: Array) -> None:
        """Prepare the evaluation at some speeds [rad/s]."""

    def rate(self, speed: float) -> float:
        """Speed of the reference body [rad/s] there: the speed itself, unless it is that of the wind."""


class InPlace:
    """Systems without trees of bodies: the same position at every speed; parameters as `SpeedStates`."""

    def __init__(self, linear: Linearised, rates: Array) -> None:
        self.reference, self.rates = linear, rates
        self.notes: tuple[str, ...] = ()
        self.rotors: tuple[str, ...] = ()
        self.stopped = linear.state.copy()
        self.stopped.v[:] = 0.0

    def prepare(self, speeds: Array) -> None:
        """Nothing to prepare."""

    def rate(self, speed: float) -> float:
        """The speed itself."""
        return speed

    def at(self, speed: float) -> Linearised:
        """The linear system at a speed of the reference body [rad/s]."""
        linear, turning = self.reference, self.stopped.copy()
        turning.v = speed * self.rates
        D, K = (
            evaluate.matrix(linear.system, turning, 0.0, cd, ck)
            - evaluate.matrix(linear.system, self.stopped, 0.0, cd, ck)
            for cd, ck in ((1.0, 0.0), (0.0, 1.0))
        )
        return replace(linear, D=linear.at_rest.D + D, K=linear.at_rest.K + K)


class InTrees:
    """Systems with trees of bodies, in relative equilibrium; parameters as `SpeedStates`."""

    def __init__(self, linear: Linearised, rates: Array, notes: Sequence[str] = ()) -> None:
        self.states = SpeedStates(linear, rates)
        self.notes: tuple[str, ...] = tuple(notes)
        self.rotors: tuple[str, ...] = ()
        self.reference = replace(linear, notes=(*linear.notes, *self.notes))

    def prepare(self, speeds: Array) -> None:
        """Equilibria, each from the nearest one, beginning at the operating speed."""
        self.states.prepare(speeds)

    def rate(self, speed: float) -> float:
        """The speed itself."""
        return speed

    def at(self, speed: float) -> Linearised:
        """The linear system at a speed of the reference body [rad/s]."""
        return self.states.at(speed)


class OfTurningRotors(InTrees):
    """Turning rotors with blades, in multi-blade coordinates; `rotors`: their names."""

    def __init__(
        self,
        linear: Linearised,
        rates: Array,
        axes: TurningRotors,
        rotors: Sequence[str],
        azimuths: int = AZIMUTHS,
    ) -> None:
        super().__init__(linear, rates, [_of_multiblade(rotors)])
        axes.basis(linear)  # refuses loops between blades
        self.axes, self.rotors, self.azimuths = axes, tuple(rotors), azimuths
        self.reference = self._mean(linear, self.states.operating)

    def at(self, speed: float) -> Linearised:
        """The linear system at a speed of the reference body [rad/s]."""
        return self._mean(super().at(speed), speed)

    def _mean(self, linear: Linearised, speed: float) -> Linearised:
        """Mean over the azimuth."""
        found = self.axes.mean(self.states, linear, speed, self.azimuths)
        notes = tuple(text for text in linear.notes if ONE_POSITION not in text)
        return replace(found, notes=(*notes, *self.notes), axes=self.axes)


def _of_multiblade(rotors: Sequence[str]) -> str:
    """Note on the coordinates."""
    return (
        f"modes of {', '.join(rotors)} in {MULTIBLADE}: the frequencies are those in axes that do not turn, "
        "and at other speeds the wind changes in proportion to the speed while pitch and controllers remain "
        "as at the operating point"
    )


def over_speed(linear: Linearised, rates: Array) -> OverSpeed:
    """The linear system as function of the speed.

    Parameters
    ----------
    linear
        The system about its operating point.
    rates
        Rates of all coordinates with the reference body at 1 rad/s.
    """
    bladed = bladed_hubs(linear.system, rates)
    if not bladed:
        return at_one_azimuth(linear, rates)
    try:
        axes = TurningRotors(linear.system, list(bladed.values()), rates)
        return OfTurningRotors(linear, rates, axes, tuple(bladed))
    except CompileError as error:
        return InTrees(
            linear,
            rates,
            [f"modes of {', '.join(bladed)} are those at one azimuth, not in {MULTIBLADE}: {error}"],
        )


def at_one_azimuth(linear: Linearised, rates: Array) -> OverSpeed:
    """As `over_speed`, with the coordinates of the model; parameters as there."""
    in_trees = np.any(linear.system.program["body"]["joint"] == GENERAL)
    return InTrees(linear, rates) if in_trees else InPlace(linear, rates)


def bladed_hubs(system: System, rates: Array) -> dict[str, tuple[str, tuple[str, ...]]]:
    """Hub and blades of every wind rotor that turns and has blades on bodies or beams, by name of the rotor.

    Parameters
    ----------
    system, rates
        The system, and rates of all coordinates.
    """
    found = {}
    for name, part in system.model.wind_rotors.items() if system.model is not None else ():
        blades, hub = part.beams or part.bodies, part.hub.split(".")[0]
        if blades and rates[system.spin(hub)] != 0.0:
            found[name] = (hub, tuple(blades))
    return found
