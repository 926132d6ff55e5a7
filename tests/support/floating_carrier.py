# SPDX-License-Identifier: Apache-2.0
"""A carrier with planets that floats in space: a tree with momentum and energy to keep."""

from __future__ import annotations

import numpy as np

from pitchpoint.elements import bushing
from pitchpoint.multibody.bodies import FREE, Body
from pitchpoint.multibody.joints import FLOATING
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import frame, gear_rows
from tests.support.markers import set_markers

CARRIER_MASS, PLANET_MASS = 4.0, 0.6
CARRIER_INERTIA, PLANET_INERTIA = (0.030, 0.020), (4e-4, 3e-4)
"""Polar and transverse inertia [kg m^2]."""
RADIUS = 0.1
STIFFNESS, TORSION = 4e5, 60.0
"""Stiffness of a bushing [N/m, N m/rad]; the planets vibrate at about 130 Hz."""
SPIN = 90.0
"""Speed of the carrier at the start [rad/s]; it wobbles besides."""


def floating_carrier(planets=3, geared=False):
    """System and state at the start: planets out of place on their bushings, everything in motion.

    With `geared` a constraint row makes the first two planets spin alike; it acts between bodies, too.
    """
    axes = frame(np.random.default_rng(7))
    bodies = [
        Body(
            motion=FLOATING,
            axes=axes,
            mass=CARRIER_MASS,
            polar_inertia=CARRIER_INERTIA[0],
            transverse_inertia=CARRIER_INERTIA[1],
            rate=(0.3, -0.2, 0.1, 4.0, -3.0, SPIN),
            name="carrier",
        )
    ]
    angles = 2.0 * np.pi * np.arange(planets) / planets
    places = [axes @ (RADIUS * np.cos(psi), RADIUS * np.sin(psi), 0.02 * k) for k, psi in enumerate(angles)]
    bodies += [
        Body(
            motion=FREE,
            parent=1,
            position=place,
            axes=axes,
            mass=PLANET_MASS,
            polar_inertia=PLANET_INERTIA[0],
            transverse_inertia=PLANET_INERTIA[1],
            start=(2e-4 * k, -1e-4, 1e-4, 1e-3, -1e-3 * k, 0.1),
            rate=(0.02, 0.01 * k, 0.0, 0.0, 0.0, -15.0),
            name=f"planet{k + 1}",
        )
        for k, place in enumerate(places)
    ]
    pins = np.zeros(planets, bushing.RECORD)
    pins["i"], pins["j"] = np.arange(planets) + 2, 1
    for pin, place in zip(pins, places, strict=True):
        bushing.defaults(pin)
        set_markers(pin, bodies, place)
        pin["K"] = np.diag([STIFFNESS, 1.5 * STIFFNESS, STIFFNESS, TORSION, TORSION, TORSION])
    rows = {"ratio": gear_rows([(2, 3, 20, -20)])} if geared else {}
    system = assemble(bodies, {"bushing": pins}, rows)
    return system, system.initial_state()


def kept(system, state):
    """What the motion keeps: momentum (3,), moment of momentum about the origin of the world (3,), energy."""
    evaluate.prepare(system)
    evaluate.load(system, state)
    evaluate.residual(system, state)
    frames = system.workspace.fr
    momentum, moment, energy = np.zeros(3), np.zeros(3), 0.0
    for number, body in enumerate(system.bodies, start=1):
        f = frames[number]
        R, v, w = f["R"], f["tw"][:3], f["tw"][3:]
        about = R @ np.diag([body.transverse_inertia, body.transverse_inertia, body.polar_inertia]) @ R.T
        momentum += body.mass * v
        moment += np.cross(f["r"], body.mass * v) + about @ w
        energy += 0.5 * (body.mass * v @ v + w @ about @ w)
    for pin in system.records["bushing"]:
        x = pin["x"]
        energy += 0.5 * x @ pin["K"] @ x
    return momentum, moment, energy
