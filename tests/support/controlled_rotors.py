# SPDX-License-Identifier: Apache-2.0
"""Rotors that a controller, another program or a communication step drives, as model texts."""

from __future__ import annotations


def rotor(loads: str, times: str, *, inertia: float = 2.0, speed: float = 10.0, name: str = "rotor") -> str:
    """A body that rotates under loads {NAME: {...}} and starts as it is given.

    Parameters
    ----------
    loads
        Loads in one line, without braces.
    times
        Duration, step and further keys of the scenario `run`.
    inertia, speed, name
        Of the body [kg m^2], [rad/s].
    """
    return f"""
bodies: {{{name}: {{motion: torsion, inertia: {inertia} kg m^2}}}}
loads: {{{loads}}}
scenarios:
  run: {{speed: {{{name}: {speed} rad/s}}, start: assembled, method: adams, {times}}}
"""


def controlled(controller: str) -> str:
    """Sections of a controller of the rotor: the speed is its input, `wanted` the torque of the motor.

    Parameters
    ----------
    controller
        Keys of the controller `control`, in one line.
    """
    return f"""
sensors:
  speed: {{type: joint, coordinate: rotor, derivative: 1}}
controllers:
  control: {{{controller}}}
actuators:
  motor_torque: {{type: torque, signal: wanted, bodies: [rotor]}}
"""
