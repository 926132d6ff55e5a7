# SPDX-License-Identifier: Apache-2.0
"""Mechanisms: two bodies in space against exudyn, a planetary set, cost over the number of bodies."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np

from benchmarks.rows import Row, cpu_seconds

STEP = 1e-3
G = 9.81
LENGTH, MASS = 1.0, 1.0
INERTIA = (0.02, 0.09, 0.08)
"""About the centre of each body [kg m^2]; each is hung at one end, its centre at half its length along x."""


def double_pendulum() -> Any:
    """Two bodies in space: one on a revolute joint about y, the other on it by one about z of the first."""
    from pitchpoint.elements.gravity import gravity_records
    from pitchpoint.multibody.bodies import TORSION, Body
    from pitchpoint.system.system import assemble

    y_up = np.column_stack([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    # axes of the first body: x along it, y down to -z of the world, z along y of the world
    swapped = (INERTIA[0], INERTIA[2], INERTIA[1])
    bodies = [
        Body(
            motion=TORSION,
            parent=k,
            position=(k * LENGTH, 0.0, 0.0),
            axes=axes,
            mass=MASS,
            com=(0.5 * LENGTH, 0.0, 0.0),
            inertia=np.diag(inertia),
            rate=(rate,),
            name=f"link{k + 1}",
        )
        for k, (axes, inertia, rate) in enumerate(((y_up, swapped, 1.0), (np.eye(3), INERTIA, 2.0)))
    ]
    return assemble(bodies, {"gravity": gravity_records(bodies, (0.0, 0.0, -G))})


def tip(system: Any, state: Any) -> np.ndarray:
    """End of the second link."""
    from pitchpoint.system import evaluate

    evaluate.residual(system, state)
    f = system.workspace.fr[2]
    return np.asarray(f["r"] + f["S"] @ (LENGTH, 0.0, 0.0))


def ours(n: int) -> tuple[Any, float]:
    """State after n steps of generalised-alpha, and the seconds of CPU."""
    from pitchpoint.core.status import OK
    from pitchpoint.solvers.implicit import generalized_alpha

    system = double_pendulum()
    run = generalized_alpha.start(system, system.initial_state(), STEP)
    statuses: list[int] = []
    taken = cpu_seconds(lambda: statuses.append(run.advance(n).status), 1)
    assert statuses == [OK]
    return tip(system, run.state()), taken


def exudyn_pendulum() -> tuple[Any, Any]:
    """The same two bodies in exudyn, on its joints, and the sensor of the tip."""
    import exudyn as exu
    from exudyn.itemInterface import SensorBody
    from exudyn.utilities import RigidBodyInertia

    SC = exu.SystemContainer()
    mbs = SC.AddSystem()
    ground = mbs.CreateGround(referencePosition=[0.0, 0.0, 0.0])
    inertia = RigidBodyInertia(mass=MASS, com=[0.0, 0.0, 0.0], inertiaTensor=np.diag(INERTIA))
    # positions are those of the centres; rates as ours: 1 rad/s about y, then 2 rad/s about z more
    omegas = [np.array([0.0, 1.0, 0.0]), np.array([0.0, 1.0, 2.0])]
    pin = np.cross(omegas[0], [LENGTH, 0.0, 0.0])
    speeds = [
        np.cross(omegas[0], [0.5 * LENGTH, 0.0, 0.0]),
        pin + np.cross(omegas[1], [0.5 * LENGTH, 0.0, 0.0]),
    ]
    links = [
        mbs.CreateRigidBody(
            inertia=inertia,
            referencePosition=[(0.5 + k) * LENGTH, 0.0, 0.0],
            initialVelocity=list(speeds[k]),
            initialAngularVelocity=list(omegas[k]),
            gravity=[0.0, 0.0, -G],
        )
        for k in range(2)
    ]
    for one, two, place, axis in (
        (ground, links[0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        (links[0], links[1], [LENGTH, 0.0, 0.0], [0.0, 0.0, 1.0]),
    ):
        mbs.CreateRevoluteJoint(itemNumbers=[one, two], position=place, axis=axis, show=False)
    sensor = mbs.AddSensor(
        SensorBody(
            bodyNumber=links[1],
            localPosition=[0.5 * LENGTH, 0.0, 0.0],
            outputVariableType=exu.OutputVariableType.Position,
            writeToFile=False,
        )
    )
    mbs.Assemble()
    return mbs, sensor


def exudyn_run(mbs: Any, n: int, step: float = STEP) -> None:
    """Take n steps of exudyn's generalised-alpha, without output."""
    import exudyn as exu

    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = n
    settings.timeIntegration.endTime = n * step
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
    settings.timeIntegration.newton.useModifiedNewton = True
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = 1e9
    settings.show.computationTime = False
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.GeneralizedAlpha)


def against_exudyn() -> list[Row]:
    """Rates of both at the same step, and that they agree on where the tip is."""
    n = 200_000
    _, taken = ours(2000)
    taken = min(ours(n)[1] for _ in range(5))
    found = [Row("two bodies in space", n / taken, "steps/s", "", f"generalised-alpha, h {STEP:g} s")]
    try:
        import exudyn
    except ImportError:
        return [*found, Row("exudyn", float("nan"), "", "", "not installed, see the extra `peers`")]
    part = n // 10
    peer = math.inf
    for _ in range(3):
        mbs, _ = exudyn_pendulum()
        peer = min(peer, cpu_seconds(partial(exudyn_run, mbs, part), 1) * (n / part))
    mbs, sensor = exudyn_pendulum()
    exudyn_run(mbs, 1000)
    apart = float(np.abs(np.asarray(mbs.GetSensorValues(sensor)) - ours(1000)[0]).max())
    theirs = f"exudyn {exudyn.__version__}, {n / peer:.3g} steps/s on 12 coordinates"
    text = f"{theirs}; after 1 s {apart:.0e} m apart"
    return [*found, Row("two bodies in space against exudyn", peer / taken, "times", ">= 10", text)]


def planetary_row() -> Row:
    """Planar planetary set with 18 degrees of freedom under load, generalised-alpha."""
    from pitchpoint.core.status import OK
    from pitchpoint.elements import torque
    from pitchpoint.solvers.implicit import generalized_alpha
    from pitchpoint.system.system import assemble
    from tests.support.planetary import CARRIER, SUN, lin_parker

    bare = lin_parker(damping=500.0)
    loads = np.zeros(2, torque.RECORD)
    loads["i"] = SUN, CARRIER
    ratio = 1.0 + 86.0 / 24.0
    loads["value"] = 20.0, -20.0 * ratio
    system = assemble(bare.bodies, {**bare.records, "torque": loads}, pools=bare.pools)
    n = 100_000
    start = system.initial_state()
    for body in ("sun", "ring"):  # turned until every mesh touches
        start.q[system.layout.coordinate(f"{body}.spin")] = 1e-6
    run = generalized_alpha.start(system, start, 2e-6)
    assert run.advance(2000).status == OK
    statuses: list[int] = []
    taken = cpu_seconds(lambda: statuses.append(run.advance(n).status), 7)
    assert set(statuses) == {OK}
    text = "6 meshes of constant stiffness, 3 planets on a carrier, h 2 us, sun driven by 20 N m"
    return Row("planar planetary set, 18 DOF", n / taken, "steps/s", ">= 300000", text)


def stages(n: int) -> Any:
    """Gear stages of ten stations each: two shafts of five pieces, a mesh; stage after stage on one line.

    Every station is a body with six coordinates on ground; the wheel shaft of a stage continues as the pinion
    shaft of the next one.
    """
    from pitchpoint.contact.stiffness.constant import constant
    from pitchpoint.elements import torque
    from pitchpoint.elements.mesh.record import RECORD
    from pitchpoint.elements.shaft_beam import shaft_row
    from pitchpoint.elements.signal import Pool
    from pitchpoint.geometry import CylindricalGear, GearPair
    from pitchpoint.multibody.beam_section import Beam, tube
    from pitchpoint.multibody.bodies import FREE, Body
    from pitchpoint.system.rules.gear_mesh import Placement, mesh_row
    from pitchpoint.system.rules.mesh_laws import MeshLaws
    from pitchpoint.system.system import assemble
    from tests.support.engine import bearings

    gear = CylindricalGear(z=30, m_n=3e-3, b=0.02)
    pair = GearPair.from_profile_shifts(gear, gear)
    pitch, bodies, beams, held, rows, pool = 0.04, [], [], [], [], Pool()
    beam = Beam(section=tube(0.03), length=pitch, E=2.06e11, G=7.9e10, rho=7850.0)
    for k in range(n):
        stage, station = divmod(k, 10)
        x = (stage + (station >= 5)) * pair.a_w
        z = (5 * stage + station % 5) * pitch
        bodies.append(
            Body(
                motion=FREE,
                position=(x, 0.0, z),
                mass=0.3,
                polar_inertia=1e-4,
                transverse_inertia=1e-4,
                name=f"s{k}",
            )
        )
        if station not in (0, 5) or (station == 0 and k):
            beams.append(shaft_row(beam, bodies=(k, k + 1), eta=1e-6))
        if station in (1, 3, 6, 8):
            held.append((k + 1, 0, np.diag([1e8, 1e8, 1e7, 0.0, 0.0, 0.0]), np.diag([1e3] * 3 + [0.0] * 3)))
        if station == 7:
            one, two = (np.asarray(bodies[b].position) for b in (k - 5, k))
            place = Placement(origin1=one, origin2=two, phi1=0.0, phi2=math.pi - math.pi / 30)
            laws = MeshLaws(stiffness=constant(pair, mean=3e8), d_in=2e3)
            row = mesh_row(pair, place, laws, pool.add, 0.0)
            row["i"], row["j"] = k - 4, k + 1
            rows.append(row)
    supports = bearings(held)
    for record in supports:
        record["d0"] = bodies[record["i"] - 1].position
    loads = np.zeros(2, torque.RECORD)
    loads["i"] = 1, n
    loads["value"] = 50.0, -50.0 * (-1.0) ** (n // 10)
    banks = {
        "bearing": supports,
        "gear_mesh": np.array(rows, RECORD),
        "shaft_beam": np.concatenate(beams),
        "torque": loads,
    }
    return assemble(bodies, banks, pools={"gear_mesh": pool.array()})


def step_cost(n: int) -> float:
    """Seconds of CPU per step of a machine with n stations."""
    from pitchpoint.core.status import OK
    from pitchpoint.solvers.implicit import generalized_alpha

    system = stages(n)
    run = generalized_alpha.start(system, system.initial_state(), 1e-6)
    assert run.advance(50).status == OK
    steps = 100_000 // n
    statuses: list[int] = []
    taken = cpu_seconds(lambda: statuses.append(run.advance(steps).status), 7)
    assert set(statuses) == {OK}
    return taken / steps


def block_solution(n: int) -> float:
    """Seconds to factorise and solve the matrix of a machine with n stations, the copy of it omitted."""
    from pitchpoint.core.status import OK
    from pitchpoint.multibody.block_lu import factorise, substitute
    from pitchpoint.system import evaluate

    system = stages(n)
    evaluate.matrix(system, system.initial_state(), 1e12, 1e6, 1.0)
    w, program = system.workspace, system.program
    before, x, order = w.A.copy(), np.zeros(6 * n), np.zeros(6, np.int64)
    A, small, y = before.copy(), np.zeros((6, 6)), np.zeros(6)

    def repeat(solve: bool) -> None:
        for _ in range(200):
            A[:] = before
            if solve:
                x[:] = 1.0
                assert factorise(program["factor"], A, small, order) == OK
                substitute(program["solve"], A, x, y)

    repeat(True)
    return (cpu_seconds(lambda: repeat(True)) - cpu_seconds(lambda: repeat(False))) / 200.0


def cost_rows() -> list[Row]:
    """Cost of a step over the number of bodies, and of one solution."""
    costs = {n: step_cost(n) for n in (10, 50, 200)}
    text = ", ".join(f"{n}: {1e6 * c / n:.3g} us" for n, c in costs.items()) + " per body and step"
    ratio = (costs[200] / 200) / (costs[10] / 10)
    return [
        Row("cost per body, 200 stations against 10", ratio, "times", "<= 1.3", text),
        Row("step of 200 stations", costs[200] * 1e6, "us", "", "shafts, bearings, 20 meshes; h 1 us"),
        Row("factor and solve, 1200 unknowns", block_solution(200) * 1e3, "ms", "<= 0.15", "6 x 6 blocks"),
    ]


def mode_rows() -> list[Row]:
    """Modes, frequency response and reduction of a machine with 1200 coordinates."""
    from pitchpoint.solvers.frequency_response import find_response
    from pitchpoint.solvers.modal import find_modes
    from pitchpoint.solvers.reduction.reduce import reduce_system

    system = stages(200)
    start = system.initial_state()
    modes = partial(find_modes, system, start=start)
    hertz = np.geomspace(20.0, 2000.0, 100)
    response = partial(find_response, system, ["s5.fx"], ["s9.uy"], hertz, start=start)
    reduced = reduce_system(system, start=start, limit=1500.0)
    modes()
    left = "{1} of {0} coordinates, frequencies to {2:.1g}".format(
        *reduced.error.coordinates, reduced.error.frequency
    )
    reduction = partial(reduce_system, system, start=start, limit=1500.0)
    return [
        Row(
            "modes of 200 stations", cpu_seconds(modes, 3), "s", "<= 5", "lowest 40 of 1200, damped ones too"
        ),
        Row("response of 200 stations", cpu_seconds(response, 2), "s", "<= 6", "100 frequencies"),
        Row("reduction of 200 stations", cpu_seconds(reduction, 1), "s", "<= 12", f"to 1500 Hz: {left}"),
    ]


def rows() -> list[Row]:
    """Measure all."""
    return [*against_exudyn(), planetary_row(), *cost_rows(), *mode_rows()]
