# SPDX-License-Identifier: Apache-2.0
"""The same mechanisms in exudyn 1.13: four-bar, slider-crank, chain of pendulums in space.

exudyn (J. Gerstmayr, Exudyn - a C++-based Python package for flexible multibody systems, Multibody Syst.
Dyn. 60, 2024) has the six coordinates of every body as unknowns and joints as constraints: nothing but the
masses is the same. Its generalised-alpha is of second order, so its distance to our explicit run, which is
tight enough to be exact here, must fall by four when its step is halved. Frames are those of the world on
both sides.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.elements.gravity import gravity_records
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.multibody.joints import PRISMATIC, SPHERICAL
from pitchpoint.solvers.constraints.assembly import assemble_state
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import frame
from tests.support.mechanisms import four_bar, slider_crank
from tests.support.trees import positive_inertia

exu = pytest.importorskip("exudyn", reason="exudyn is not installed (extra `peers`)")
utilities = pytest.importorskip("exudyn.utilities", reason="exudyn is not installed (extra `peers`)")
GRAVITY = (0.5, -9.81, 0.3)


def joint(mbs, motion, ends, place, axis, planar=False):
    """One joint of theirs; in a plane only what it holds there."""
    numbers = {"itemNumbers": ends, "position": list(place), "show": False}
    if planar:
        mbs.CreateSphericalJoint(**numbers, constrainedAxes=[1, 1, 0])
    elif motion == SPHERICAL:
        mbs.CreateSphericalJoint(**numbers)
    elif motion == TORSION:
        mbs.CreateRevoluteJoint(**numbers, axis=list(axis))
    elif motion == PRISMATIC:
        mbs.CreatePrismaticJoint(**numbers, axis=list(axis))


def theirs(system, state, cuts=()):
    """The bodies and joints of a system in exudyn, at the place and with the rates of a state."""
    evaluate.residual(system, state)
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    numbers = [mbs.CreateGround(referencePosition=[0.0, 0.0, 0.0])]
    for f, body in zip(system.workspace.fr[1:].copy(), system.bodies, strict=True):
        arm = f["S"] @ body.center_of_mass()
        inertia = utilities.RigidBodyInertia(
            mass=body.mass, com=[0.0] * 3, inertiaTensor=np.asarray(body.inertia)
        )
        numbers.append(
            mbs.CreateRigidBody(
                inertia=inertia,
                referencePosition=f["r"] + arm,
                referenceRotationMatrix=f["S"],
                initialVelocity=f["tw"][:3] + np.cross(f["tw"][3:], arm),
                initialAngularVelocity=f["tw"][3:],
                gravity=list(GRAVITY),
            )
        )
        joint(mbs, body.motion, [numbers[body.parent], numbers[-1]], f["r"], f["R"][:, 2])
    for one, two, place in cuts:
        joint(mbs, TORSION, [numbers[one], numbers[two]], place, None, planar=True)
    mbs.Assemble()
    return container, mbs, numbers


def their_places(system, state, duration, steps, cuts=()):
    """Centres of all bodies at the end."""
    container, mbs, numbers = theirs(system, state, cuts)
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = duration
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.9
    settings.timeIntegration.newton.relativeTolerance = 1e-12
    settings.timeIntegration.newton.absoluteTolerance = 1e-12
    settings.solution.file.write = False
    settings.show.computationTime = False
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.GeneralizedAlpha)
    kind = exu.OutputVariableType.Position
    return np.array([mbs.GetObjectOutputBody(n, kind, [0.0, 0.0, 0.0]) for n in numbers[1:]])


def our_places(system, state, duration):
    """The same by the explicit method."""
    run = runge_kutta.start_adaptive(system, state, rtol=1e-10, atol=1e-12, atol_rate=1e-10)
    assert run.advance_to(duration).status == OK
    evaluate.residual(system, run.state())
    frames = system.workspace.fr[1:]
    return np.array(
        [f["r"] + f["S"] @ b.center_of_mass() for f, b in zip(frames, system.bodies, strict=True)]
    )


def compare(system, state, duration, steps, cuts=(), most=1e-3):
    begun = our_places(system, state, 0.0)
    ours = our_places(system, state, duration)
    errors = [np.abs(their_places(system, state, duration, n, cuts) - ours).max() for n in (steps, 2 * steps)]
    assert np.abs(ours - begun).max() > 0.3  # it has moved
    assert errors[1] < most
    assert math.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.2)


def with_weights(system):
    """A planar mechanism with weights of its bodies, moving."""
    weights = gravity_records(system.bodies, GRAVITY)
    closure = {"closure": system.records["closure"]}
    made = assemble(system.bodies, {"gravity": weights}, closure, names=system.names)
    state = made.initial_state()
    crank = made.layout.coordinate("crank.spin")
    state.v[crank] = -4.0
    return made, assemble_state(made, state, keep_rates=[crank]).state


def test_four_bar():
    """A crank of 0.4 m that goes round; the loop is cut at the rocker."""
    points = ((0.0, 0.0), (0.0, 0.4), (1.0, 1.2), (1.0, 0.0))
    compare(*with_weights(four_bar(points)), 0.7, 350, [(3, 0, (*points[3], 0.0))])


def test_slider_crank():
    system, state = with_weights(slider_crank())
    end = np.asarray(system.bodies[2].position)
    compare(system, state, 1.0, 500, [(2, 3, end)])


def test_chain_of_pendulums_in_space():
    """Four bodies of random mass on ball joints and hinges, from a place and rates of random."""
    rng = np.random.default_rng(11)
    motions = (SPHERICAL, TORSION, SPHERICAL, TORSION)
    bodies = [
        Body(
            motion=motion,
            parent=k,
            position=(0.4 * k, 0.05 * k, 0.0),
            axes=frame(rng),
            mass=rng.uniform(0.5, 1.5),
            com=0.1 * rng.normal(size=3),
            inertia=0.05 * positive_inertia(rng),
            rate=tuple(rng.normal(size=3 if motion == SPHERICAL else 1)),
            name=f"b{k}",
        )
        for k, motion in enumerate(motions)
    ]
    system = assemble(bodies, {"gravity": gravity_records(bodies, GRAVITY)})
    compare(system, system.initial_state(), 0.5, 500)
