# SPDX-License-Identifier: Apache-2.0
"""Slider-crank with a soft rod, against ANCF cable elements of exudyn 1.13.

A rigid crank of 0.1 m (0.001 kg m^2, no drive) starts at 30 rad/s and 90 deg, a plastic rod of 0.4 m and 8
x 8 mm pushes a slider of 0.2 kg along x; at the start all move as if rigid. The rod bends by a centimetre.
exudyn has cubic elements in absolute nodal coordinates without shear (J. Gerstmayr, H. Irschik, J. Sound
Vib. 318, 2008), here are beams in axes that go with them, stiff in shear for this case (with the shear of
the material the two part by 2 %). Left is the rotary inertia of the sections, which cables do not have. x
and y are those of the world on both sides.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.elements.beam import beam_row
from pitchpoint.multibody.beam_section import Beam, rectangle
from pitchpoint.multibody.bodies import PLANAR, TORSION, Body
from pitchpoint.multibody.joints import PRISMATIC
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble

exu = pytest.importorskip("exudyn", reason="exudyn is not installed (extra `peers`)")
items = pytest.importorskip("exudyn.itemInterface", reason="exudyn is not installed (extra `peers`)")

CRANK, ROD, INERTIA, SLIDER, SPEED = 0.1, 0.4, 1e-3, 0.2, 30.0
SIDE, E, G, RHO, PIECES = 0.008, 2e9, 8e13, 1200.0, 16
AREA, SECOND = SIDE**2, SIDE**4 / 12.0
PIN = np.array([0.0, CRANK])
END = np.array([math.sqrt(ROD**2 - CRANK**2), 0.0])
ALONG = (END - PIN) / ROD
PIN_SPEED = SPEED * np.array([-CRANK, 0.0])
# the end stays on y = 0 and at its distance: v_end . along = v_pin . along
END_SPEED = np.array([PIN_SPEED @ ALONG / ALONG[0], 0.0])
TURN = ((END_SPEED - PIN_SPEED) @ np.array([-ALONG[1], ALONG[0]])) / ROD
STEP = 5e-5
TIMES = (0.02, 0.05, 0.1, 0.15)


def ours():
    """Crank, slider, nodes of the rod: the first on the crank, the last on the slider, no loop to close."""
    x = np.array([*ALONG, 0.0])
    axes = np.column_stack([x, np.cross([0.0, 0.0, 1.0], x), [0.0, 0.0, 1.0]])
    along_x = np.column_stack([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
    light = {"mass": 1e-9, "inertia": 1e-12 * np.eye(3), "axes": axes}
    bodies = [
        Body(motion=TORSION, polar_inertia=INERTIA, mass=1.0, rate=(SPEED,), name="crank"),
        Body(
            motion=PRISMATIC,
            position=(*END, 0.0),
            axes=along_x,
            mass=SLIDER,
            inertia=1e-4 * np.eye(3),
            rate=(END_SPEED[0],),
            name="slider",
        ),
    ]
    for k in range(PIECES + 1):
        place = (*(PIN + k * ROD / PIECES * ALONG), 0.0)
        speed = axes[:2, :2].T @ (PIN_SPEED + k / PIECES * (END_SPEED - PIN_SPEED))
        inner = {"motion": PLANAR, "rate": (*speed, TURN)}
        outer = {"motion": TORSION, "parent": 2 if k else 1, "rate": (TURN - (0.0 if k else SPEED),)}
        bodies.append(Body(position=place, name=f"n{k}", **light, **(inner if 0 < k < PIECES else outer)))
    beam = Beam(section=rectangle(SIDE, SIDE), length=ROD / PIECES, E=E, G=G, rho=RHO)
    ends = np.column_stack([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
    rows = [beam_row(beam, bodies=(k + 3, k + 4), axes=(ends, ends)) for k in range(PIECES)]
    return assemble(bodies, {"beam": np.concatenate(rows)})


def theirs():
    """The same in exudyn: system, node of the middle, nodes of both ends."""
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    ground = mbs.AddObject(items.ObjectGround())
    origin = mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=ground))
    fixed = mbs.AddMarker(
        items.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(items.NodePointGround()), coordinate=0)
    )
    turning = mbs.AddNode(
        items.NodeRigidBody2D(
            referenceCoordinates=[0.0, 0.0, 0.5 * math.pi], initialVelocities=[0.0, 0.0, SPEED]
        )
    )
    crank = mbs.AddObject(items.ObjectRigidBody2D(nodeNumber=turning, mass=1.0, inertia=INERTIA))
    nodes = []
    for k in range(PIECES + 1):
        place = PIN + k * ROD / PIECES * ALONG
        speed = PIN_SPEED + k / PIECES * (END_SPEED - PIN_SPEED)
        slope = TURN * np.array([-ALONG[1], ALONG[0]])
        nodes.append(
            mbs.AddNode(
                items.NodePoint2DSlope1(
                    referenceCoordinates=[*place, *ALONG], initialVelocities=[*speed, *slope]
                )
            )
        )
    for one, two in zip(nodes[:-1], nodes[1:], strict=True):
        mbs.AddObject(
            items.ObjectANCFCable2D(
                nodeNumbers=[one, two],
                length=ROD / PIECES,
                massPerLength=RHO * AREA,
                bendingStiffness=E * SECOND,
                axialStiffness=E * AREA,
            )
        )
    mass = mbs.AddNode(items.NodePoint2D(referenceCoordinates=list(END), initialVelocities=list(END_SPEED)))
    slider = mbs.AddObject(items.ObjectMassPoint2D(nodeNumber=mass, mass=SLIDER))
    ends = [mbs.AddMarker(items.MarkerNodePosition(nodeNumber=n)) for n in (nodes[0], nodes[-1])]
    hub, pin = (
        mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=crank, localPosition=[r, 0.0, 0.0]))
        for r in (0.0, CRANK)
    )
    body = mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=slider))
    for markers in ([origin, hub], [pin, ends[0]], [ends[1], body]):
        mbs.AddObject(items.ObjectJointRevolute2D(markerNumbers=markers))
    height = mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=mass, coordinate=1))
    mbs.AddObject(items.ObjectConnectorCoordinate(markerNumbers=[fixed, height]))
    mbs.Assemble()
    return container, mbs, nodes


def seen(pin, middle, end):
    """Place of the slider, and by how much the middle of the rod lies beside the line of its ends."""
    line = (end - pin) / np.linalg.norm(end - pin)
    return np.array([end[0], line[0] * (middle - pin)[1] - line[1] * (middle - pin)[0]])


def their_motion(duration):
    container, mbs, nodes = theirs()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = round(duration / STEP)
    settings.timeIntegration.endTime = duration
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
    settings.solution.file.write = False
    settings.show.computationTime = False
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.GeneralizedAlpha)
    kind = exu.OutputVariableType.Position
    return seen(*(np.array(mbs.GetNodeOutput(nodes[k], kind))[:2] for k in (0, PIECES // 2, PIECES)))


def test_slider_crank_with_a_soft_rod():
    """Over two thirds of a turn: deflections to 0.5 % of the largest one, the slider to 0.01 mm."""
    system = ours()
    run = generalized_alpha.start(system, system.initial_state(), STEP)
    pairs = []
    for t in TIMES:
        assert run.advance(round(t / STEP) - run.steps).status == OK
        state = run.state()
        evaluate.residual(system, state)
        places = system.workspace.fr["r"][:, :2].copy()
        evaluate.load(system, state)
        pairs.append((seen(places[3], places[3 + PIECES // 2], places[3 + PIECES]), their_motion(t)))
    found, wanted = np.transpose(pairs, (1, 0, 2))
    largest = np.abs(wanted[:, 1]).max()
    assert largest > 1e-3
    np.testing.assert_allclose(found[:, 1], wanted[:, 1], atol=0.005 * largest)
    np.testing.assert_allclose(found[:, 0], wanted[:, 0], atol=1e-5)
