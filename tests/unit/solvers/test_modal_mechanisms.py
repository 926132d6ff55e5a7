# SPDX-License-Identifier: Apache-2.0
"""Modes of mechanisms: pendulums, loops, steady rotation, states of elements, many stations."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.elements import gravity, guide, maxwell, spring_damper
from pitchpoint.elements import torque as torque_kind
from pitchpoint.elements.flexible_body import flexible_row, modal_bodies
from pitchpoint.multibody.beam_section import Beam, Section
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.multibody.joints import GUIDED, PRISMATIC
from pitchpoint.multibody.mass_invariants import mass_invariants
from pitchpoint.multibody.structure import beam_line
from pitchpoint.solvers.campbell import follow_modes
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.modal import find_modes, solve_modal
from pitchpoint.system.system import assemble
from tests.support.beam_modes import axial_stiffening, held_modes
from tests.support.engine import bearings
from tests.support.mechanisms import bar, four_bar

G = 9.81
DOWN = (0.0, -G, 0.0)


def weighed(bodies, acceleration=DOWN):
    return gravity.gravity_records(bodies, acceleration)


def point(mass, at, arm, **more):
    """Point mass at the end of an arm along x, turning about z."""
    tiny = 1e-12 * mass * arm**2 * np.eye(3)
    return Body(mass=mass, com=(arm, 0.0, 0.0), inertia=tiny, position=at, **{"motion": TORSION, **more})


HANGING = np.column_stack([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


def test_pendulum():
    """A bar of length L: omega^2 = 3 g/(2 L); all of its stiffness is weight."""
    bodies = [bar((0.0, 0.0), (0.0, -0.8), mass=2.0, name="arm")]
    modes = find_modes(assemble(bodies, {"gravity": weighed(bodies)}))
    assert modes.frequency[0] == pytest.approx(math.sqrt(1.5 * G / 0.8) / (2.0 * math.pi), rel=1e-9)
    assert modes.elements == ("gravity gravity0",)
    assert modes.potential[0, 0] == pytest.approx(1.0, rel=1e-12)
    assert modes.names == ("rotation of arm",)
    # a base along x drives it with m L/2, one about z with its inertia m L^2/3; modal mass m L^2/3
    root = math.sqrt(2.0 * 0.8**2 / 3.0)
    assert np.abs(modes.participation[0, [0, 1, 5]]) == pytest.approx([0.8 / root, 0.0, root], abs=1e-12)
    assert modes.body_shape[0, 1, 5] == pytest.approx(1.0 / root, rel=1e-12)


def test_double_pendulum():
    """Equal point masses and lengths: omega^2 = (2 -+ sqrt 2) g/l."""
    bodies = [
        point(1.5, (0.0, 0.0, 0.0), 0.6, axes=HANGING, name="upper"),
        point(1.5, (0.0, -0.6, 0.0), 0.6, axes=HANGING, name="lower", parent=1),
    ]
    modes = find_modes(assemble(bodies, {"gravity": weighed(bodies)}))
    expected = np.sqrt((2.0 + math.sqrt(2.0) * np.array([-1.0, 1.0])) * G / 0.6) / (2.0 * math.pi)
    assert modes.frequency == pytest.approx(expected, rel=1e-9)
    assert modes.effective_mass[:, 0].sum() == pytest.approx(3.0, rel=1e-9)  # both masses move along x
    ratio = modes.body_shape[0, 2, 0] / modes.body_shape[0, 1, 5]  # the lower pivot moves by l times the turn
    assert ratio == pytest.approx(0.6, rel=1e-9)


def hanging_four_bar():
    """Bars of 1 m between two pivots 1.6 m apart, at rest under their weight, symmetric about the middle."""
    drop = math.sqrt(1.0 - 0.3**2)
    points = ((0.0, 0.0), (0.3, -drop), (1.3, -drop), (1.6, 0.0))
    bare = four_bar(points)
    return four_bar(points, gravity=weighed(list(bare.bodies)))


def four_bar_by_energy():
    """Frequency [rad/s] from potential and kinetic energy over the crank angle, by differences."""
    d = 1.6

    def places(phi):
        b = np.array([math.cos(phi), math.sin(phi)])
        e = np.array([d, 0.0])
        reach = np.linalg.norm(e - b)
        along = (e - b) / reach
        half = 0.5 * reach  # both further bars are 1 m long: the joint lies on the bisector, below
        height = math.sqrt(1.0 - half**2)
        c = b + half * along + height * np.array([along[1], -along[0]])
        angles = [phi, math.atan2(*(c - b)[::-1]), math.atan2(*(e - c)[::-1])]
        return [0.5 * b, 0.5 * (b + c), 0.5 * (c + e)], np.array(angles)

    phi0 = -math.acos(0.3)
    h = 1e-3

    def height(phi):
        return sum(G * p[1] for p in places(phi)[0])

    second = (height(phi0 + h) - 2.0 * height(phi0) + height(phi0 - h)) / h**2
    (p1, a1), (p0, a0) = places(phi0 + h), places(phi0 - h)
    turn = np.angle(np.exp(1j * (a1 - a0))) / (2.0 * h)
    inertia = sum(np.sum(((u - w) / (2.0 * h)) ** 2) for u, w in zip(p1, p0, strict=True))
    return math.sqrt(second / (inertia + np.sum(turn**2) / 12.0))


def test_four_bar_hanging():
    """Reactions of the loop belong to the stiffness: the energy over the crank angle has no need of them."""
    modes = find_modes(hanging_four_bar())
    assert modes.frequency.size == 1
    assert modes.frequency[0] * 2.0 * math.pi == pytest.approx(four_bar_by_energy(), rel=1e-5)
    assert any(name.startswith("reaction") for name in modes.elements)
    assert modes.potential[0].sum() == pytest.approx(1.0, rel=1e-12)


def test_four_bar_against_a_run():
    """Period of a small oscillation of the nonlinear system, by its passages through the middle."""
    system = hanging_four_bar()
    modes = find_modes(system)
    state = modes.state.copy()
    state.v = 1e-4 * modes.shape[0]
    run = generalized_alpha.start(system, state, 1e-3, rho_inf=1.0)
    crank = system.spin("crank")
    seen = []
    for _ in range(4000):
        assert run.advance(1).status == OK
        seen.append(run.state().v[crank])
    seen = np.array(seen)
    down = [k + seen[k] / (seen[k] - seen[k + 1]) for k in range(len(seen) - 1) if seen[k] > 0 >= seen[k + 1]]
    period = 1e-3 * (down[-1] - down[0]) / (len(down) - 1)
    assert 1.0 / period == pytest.approx(modes.frequency[0], rel=2e-5)  # (omega h)^2/12 and crossings


ARM, OMEGA = 0.5, 8.0


def governor(inertia=1e4, **more):
    """Vertical shaft along z, a hinged point mass on its axis: the rotating pendulum."""
    lean = math.acos(G / (ARM * OMEGA**2))
    hinge = np.column_stack([[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
    shaft = Body(motion=TORSION, polar_inertia=inertia, rate=(OMEGA,), name="shaft")
    ball = point(2.0, (0.0, 0.0, 0.0), ARM, axes=hinge, parent=1, start=(lean - 0.3,), name="ball", **more)
    bodies = [shaft, ball]
    return assemble(bodies, {"gravity": weighed(bodies, (0.0, 0.0, -G))}), lean


def test_rotating_pendulum():
    """About cos theta = g/(l W^2) it oscillates with W sin theta on a heavy shaft, whose speed stays."""
    system, lean = governor()
    modes = find_modes(system)
    ball = system.spin("ball")
    assert abs(modes.state.q[ball]) == pytest.approx(lean, rel=1e-8)
    expected = OMEGA * math.sin(lean)
    # the shaft is not infinitely heavy: 4 m l^2 cos^2 theta/J beside sin^2
    assert modes.damped_frequency.max() * 2.0 * math.pi == pytest.approx(expected, rel=1e-3)
    assert "steady rotation" in modes.elements


def test_rotating_pendulum_on_a_light_shaft():
    """With the shaft free, momentum is kept: w^2 = W^2 (sin^2 + 4 cos^2 m l^2 sin^2/(J + m l^2 sin^2))."""
    J = 0.3
    system, lean = governor(J)
    s2, c2 = math.sin(lean) ** 2, math.cos(lean) ** 2
    carried = 2.0 * ARM**2 * s2
    expected = OMEGA * math.sqrt(s2 + 4.0 * c2 * carried / (J + carried))
    assert find_modes(system).damped_frequency.max() * 2.0 * math.pi == pytest.approx(expected, rel=1e-6)


def test_campbell_of_the_rotating_pendulum():
    system, _ = governor(1e6)
    speeds = np.array([6.0, 8.0, 12.0])
    found = follow_modes(system, speeds, "shaft").frequency.max(axis=1) * 2.0 * math.pi
    lean = np.arccos(G / (ARM * speeds**2))
    assert found == pytest.approx(speeds * np.sin(lean), rel=1e-4)


def test_a_state_of_an_element():
    """Mass on a spring and a Maxwell element beside it: cubic polynomial of Zener's solid."""
    m, k, k_m, d = 2.0, 800.0, 500.0, 40.0
    along_x = np.column_stack([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
    bodies = [
        Body(
            motion=PRISMATIC, axes=along_x, position=(1.0, 0.0, 0.0), mass=m, inertia=np.eye(3), name="mass"
        ),
        Body(motion=TORSION, polar_inertia=1.0, name="state", state=True),
    ]
    spring = np.zeros(1, spring_damper.RECORD)
    spring["i"], spring["free"], spring["k"] = 1, 1.0, k
    element = np.zeros(1, maxwell.RECORD)
    element["i"], element["k"], element["stiffness"], element["damping"] = 1, 2, k_m, d
    system = assemble(bodies, {"spring_damper": spring, "maxwell": element})
    modes = find_modes(system)
    # m s^2 + k + k_m s/(s + k_m/d) = 0
    roots = np.roots([m, m * k_m / d, k + k_m, k * k_m / d])
    pair = roots[roots.imag > 0][0]
    assert modes.frequency == pytest.approx([math.sqrt(k / m) / (2.0 * math.pi)], rel=1e-9)
    assert modes.eigenvalue[0] == pytest.approx(pair, rel=1e-9)
    assert modes.state_eigenvalue == pytest.approx([roots[np.abs(roots.imag) < 1e-9][0].real], rel=1e-9)


def test_dataset_has_participation_and_motions():
    bodies = [bar((0.0, 0.0), (0.0, -0.8), mass=2.0, name="arm")]
    data = solve_modal(assemble(bodies, {"gravity": weighed(bodies)}))
    assert data["body_shape"].dims == ("mode", "body", "direction")
    assert data["effective_mass"].sel(direction="x").item() == pytest.approx(
        1.5, rel=1e-9
    )  # m (L/2)^2/(L^2/3)


def test_a_preload_that_follows_the_body_counts():
    """A pendulum in space with a constant torque: names of elements are complete, energies sum up."""
    bodies = [bar((0.0, 0.0), (0.0, -0.8), mass=2.0, name="arm")]
    torque = np.zeros(1, torque_kind.RECORD)
    torque["i"], torque["value"] = 1, 3.0
    support = bearings([(1, 0, np.diag([0.0] * 5 + [5.0]), np.zeros((6, 6)))])
    modes = find_modes(assemble(bodies, {"gravity": weighed(bodies), "torque": torque, "bearing": support}))
    turn = float(modes.state.q[0])
    assert 5.0 * turn + 2.0 * G * 0.4 * math.sin(turn) == pytest.approx(3.0, rel=1e-7)
    k = 5.0 + 2.0 * G * 0.4 * math.cos(turn)
    expected = math.sqrt(k / (2.0 * 0.64 / 3.0)) / (2.0 * math.pi)
    assert modes.frequency[0] == pytest.approx(expected, rel=1e-7)


def test_a_rotating_blade():
    """Thin blade turned over time: 13.1702 at 12 rad/s, Wright et al. 1982, Table 1 (six modes: 1e-3)."""
    n = 24
    thin = Section(A=1e-2, I_1=1e-8, I_2=1e-8, J=2e-8, kappa_1=0.0, kappa_2=0.0)
    beams = [Beam(section=thin, length=1.0 / n, E=1e8, G=4e13, rho=1e2)] * n
    line = beam_line(beams)
    held = held_modes(line, [0], 12)
    geo = np.einsum("ka,rkl,lb->rab", held.shape, axial_stiffening(beams, line, 0.0), held.shape)
    hub = Body(motion=GUIDED, guided_by=(), inertia=np.zeros((3, 3)), name="hub")
    turn = np.zeros(1, guide.RECORD)
    turn["i"], turn["m"], turn["k"], turn["slope"], turn["first"] = 1, 3, guide.TIME, 12.0, 1
    hidden, guides = modal_bodies("blade", 12, first=2)
    row = flexible_row(
        mass_invariants(line, held.shape, (0.0, 0.0, 0.0)),
        (2.0 * math.pi * held.frequency) ** 2,
        frame=1,
        hidden=tuple(range(2, 2 + len(hidden))),
        stiffening=geo,
    )
    banks = {"flexible_body": row, "guide": np.concatenate([turn, guides])}
    modes = find_modes(assemble([hub, *hidden], banks))
    assert 2.0 * math.pi * modes.frequency[1] == pytest.approx(13.1702, rel=1e-3)
    assert 2.0 * math.pi * modes.frequency[3] == pytest.approx(37.6031, rel=1e-3)
    assert modes.elements == ("flexible body flexible_body0",)
