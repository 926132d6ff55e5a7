# SPDX-License-Identifier: Apache-2.0
"""The linear system over the speed of a body: in one position, in equilibrium, or of turning rotors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Protocol

import numpy as np

from pitchpoint.core.errors import CompileError
from pitchpoint.multibody.bodies import GENERAL
from pitchpoint.solvers.linear_system import Linearised
from pitchpoint.solvers.speed_states import SpeedStates
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.solvers.turning_rotors import TurningRotors
from pitchpoint.solvers.whirl_basis import Complex
from pitchpoint.system import evaluate
from pitchpoint.system.system import System

AZIMUTHS = 2
"""Positions within the angle between two blades: the mean of two is free of the blade-passing frequency."""
WAYS = ("collective", "forward", "backward")
"""Motions of all blades, in the order of `TurningRotors.whirl`."""
LARGEST = 0.3
"""Least share of the coordinates of the blades in the kinetic energy of a mode whose whirl is theirs."""
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

    def whirls(self, shapes: Complex, words: Sequence[str]) -> list[str]:
        """Words for the whirl of modes with shapes (n, nd), of the blades where they move most."""


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

    def whirls(self, shapes: Complex, words: Sequence[str]) -> list[str]:
        """The given words."""
        return list(words)

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
        self.states, self.reference = SpeedStates(linear, rates), linear
        self.notes, self.rotors = tuple(notes), ()

    def prepare(self, speeds: Array) -> None:
        """Equilibria, each from the nearest one, beginning at the operating speed."""
        self.states.prepare(speeds)

    def whirls(self, shapes: Complex, words: Sequence[str]) -> list[str]:
        """The given words."""
        return list(words)

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
        super().__init__(linear, rates)
        axes.basis(linear)  # refuses loops between blades
        self.axes, self.rotors, self.azimuths = axes, tuple(rotors), azimuths
        self.reference = axes.mean(self.states, linear, self.states.operating, azimuths)
        self.notes = (
            f"modes of {', '.join(rotors)} in {MULTIBLADE}: the frequencies are those in axes that do not "
            "turn; the wind changes in proportion to the speed, and pitch and controllers are those of the "
            "operating point",
        )

    def at(self, speed: float) -> Linearised:
        """The linear system at a speed of the reference body [rad/s]."""
        return self.axes.mean(self.states, super().at(speed), speed, self.azimuths)

    def whirls(self, shapes: Complex, words: Sequence[str]) -> list[str]:
        """Words for the whirl of modes: of the blades with most of the kinetic energy, if they move most."""
        M = self.reference.at_rest.M
        size = np.sqrt(np.abs(np.diag(M)))
        energy = (shapes.conj() * (shapes @ M)).real
        found = list(words)
        ways = [self.axes.whirl(shapes, size, one) for one in range(len(self.axes.rotors))]
        own = np.array(
            [energy[:, np.concatenate(r.coordinates)].sum(axis=1) for r in self.axes.rotors]
        ) / energy.sum(axis=1)
        for k, most in enumerate(np.argmax(own, axis=0)):
            if own[most, k] >= LARGEST:
                found[k] = WAYS[int(np.argmax(ways[int(most)][k]))]
        return found


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
