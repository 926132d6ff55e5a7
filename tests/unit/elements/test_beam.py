# SPDX-License-Identifier: Apache-2.0
"""Beams against linear theory, closed forms of large bending, conservation laws and whirling shafts."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_bvp

from pitchpoint.core.errors import CompileError
from pitchpoint.elements import guide
from pitchpoint.elements.beam import beam_row
from pitchpoint.elements.force import RECORD as FORCE
from pitchpoint.elements.shaft_beam import shaft_row
from pitchpoint.multibody.beam_section import Beam, Section, rectangle, tube
from pitchpoint.multibody.bodies import FREE, PLANAR, Body
from pitchpoint.multibody.joints import FLOATING, GUIDED
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.beams import damped_frequencies, fixed_beams, nodes, shaft, supports
from tests.support.engine import differences, frame

SOFT = {"E": 2e7, "G": 8e6, "rho": 7800.0}
STEEL = {"E": 2e11, "G": 8e10, "rho": 7800.0}
ROUND, FLAT = tube(0.05, 0.02), rectangle(0.06, 0.03)
HEAVY = (1.0, 0.1, 0.2)
"""Mass [kg], transverse and polar inertia [kg m^2] of the bodies at the ends."""


def one(kind, eta=1e-3, motion=FREE, turn=None, shift=None, beam=None, **more):
    """One beam between two bodies; the assembly is turned and shifted as a whole."""
    Q = np.eye(3) if turn is None else turn
    o = np.zeros(3) if shift is None else shift
    beam = beam or Beam(section=ROUND if kind == "shaft_beam" else FLAT, length=0.4, **SOFT)
    bodies = [
        Body(
            motion=motion,
            position=o + Q @ p,
            axes=Q,
            mass=1.0,
            polar_inertia=0.2,
            transverse_inertia=0.1,
            name=n,
        )
        for n, p in (
            ("a", (0.0, 0.0, 0.0)),
            ("b", (0.01, 0.02, 0.45) if kind == "beam" else (0.0, 0.0, 0.45)),
        )
    ]
    if kind == "shaft_beam":
        row = shaft_row(beam, bodies=(1, 2), places=(0.02, -0.03), eta=eta, **more)
    else:
        ends = (0.02, 0.02, 0.03), (0.01, 0.0, -0.02)
        row = beam_row(beam, bodies=(1, 2), nodes=ends, eta=eta, **more)
    return assemble(bodies, {kind: row})


def stirred(system, seed=3, size=0.1, spin=2.7):
    """State with displacements, rates and accelerations; both spins near `spin`."""
    rng = np.random.default_rng(seed)
    state = system.initial_state()
    n = state.q.size
    state.q, state.v, state.a = size * rng.normal(size=n), rng.normal(size=n), rng.normal(size=n)
    state.q[[5, n - 1]] += spin
    state.v[[5, n - 1]] += 5.0
    return state


@pytest.mark.nojit
@pytest.mark.parametrize("kind", ["beam", "shaft_beam"])
def test_tangents_are_derivatives(kind):
    system = one(kind, gravity=(1.0, 2.0, -9.81))
    state = stirred(system)
    M, D, K = evaluate.linearize(system, state)
    for found, key, step in ((M, "a", 1e-2), (D, "v", 1e-5), (K, "q", 1e-6)):
        # differences of second order: 1e-9 of the largest entry beside round-off
        np.testing.assert_allclose(found, differences(system, state, key, step), atol=1e-8 * np.abs(K).max())


def test_tangents_on_ground_and_in_a_tree():
    carrier = Body(motion=FREE, mass=2.0, polar_inertia=0.2, transverse_inertia=0.3, name="carrier")
    axes = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    rider = Body(
        motion=14,
        parent=1,
        position=(0.3, 0.1, 0.2),
        axes=axes,
        mass=1.0,
        inertia=np.diag([0.1, 0.12, 0.15]),
        name="r",
    )
    rows = np.concatenate(
        [
            beam_row(
                Beam(section=FLAT, length=0.3, **SOFT),
                bodies=(2, 0),
                nodes=((0, 0, 0), (0.3, 0.1, 0.5)),
                axes=(axes.T, np.eye(3)),
                eta=1e-3,
            ),
            beam_row(
                Beam(section=FLAT, length=0.2, **SOFT),
                bodies=(1, 2),
                nodes=((0.3, 0.1, 0.0), (0, 0, 0)),
                axes=(np.eye(3), axes.T),
                eta=1e-3,
            ),
        ]
    )
    system = assemble([carrier, rider], {"beam": rows})
    rng = np.random.default_rng(4)
    state = system.initial_state()
    for name in ("q", "v", "a"):
        setattr(state, name, 0.1 * rng.normal(size=state.q.size))
    M, D, K = evaluate.linearize(system, state)
    for found, key, step in ((M, "a", 1e-2), (D, "v", 1e-4), (K, "q", 1e-6)):
        np.testing.assert_allclose(found, differences(system, state, key, step), atol=1e-8 * np.abs(K).max())


@pytest.mark.parametrize("kind", ["beam", "shaft_beam"])
def test_small_motion_is_that_of_the_matrices(kind):
    section = (
        ROUND if kind == "shaft_beam" else Section(A=1e-3, I_1=2e-7, I_2=5e-8, J=1e-7, kappa_1=0, kappa_2=0)
    )
    beam = Beam(section=section, length=0.4, **STEEL)
    make = shaft_row if kind == "shaft_beam" else beam_row
    system = assemble(nodes([0.0, 0.4]), {kind: make(beam, bodies=(1, 2))})
    state = system.initial_state()
    speed = 300.0 if kind == "shaft_beam" else 0.0
    state.v[[5, 11]] = speed
    M, D, K = evaluate.linearize(system, state)
    np.testing.assert_allclose(K, beam.stiffness(), atol=1e-15 * np.abs(K).max() + 1e-6)
    expected = beam.consistent_mass()
    if kind == "beam":  # the rotary inertia of a flat section is taken as the mean of both planes
        mean = Beam(section=Section(**{**vars(section), "I_1": 1.25e-7, "I_2": 1.25e-7}), length=0.4, **STEEL)
        expected = mean.consistent_mass()
    np.testing.assert_allclose(M, expected, atol=3e-9)  # masses of the nodes
    if speed:
        np.testing.assert_allclose(D, speed * beam.gyroscopic(), atol=3e-9 * speed)


@pytest.mark.parametrize("kind", ["beam", "shaft_beam"])
def test_moved_and_turned_world_changes_nothing(kind):
    rng = np.random.default_rng(5)
    first = one(kind)
    state = stirred(first)
    second = one(kind, turn=frame(rng), shift=rng.normal(size=3))
    before, after = evaluate.residual(first, state), evaluate.residual(second, state)
    np.testing.assert_allclose(after, before, atol=1e-11 * np.abs(before).max())
    # in the axes of its ends the beam feels the same
    np.testing.assert_allclose(
        evaluate.observe(second, state), evaluate.observe(first, state), atol=1e-11 * np.abs(before).max()
    )


def test_whole_turns_change_no_bit():
    system = one("shaft_beam")
    state = stirred(system)
    before = evaluate.residual(system, state)
    state.turns[1:] += 100_000
    np.testing.assert_array_equal(evaluate.residual(system, state), before)


def test_spin_of_a_round_shaft_turns_no_force():
    system = one("shaft_beam", eta=0.0)
    state = stirred(system)
    state.v[:], state.a[:] = 0.0, 0.0
    before = evaluate.residual(system, state)
    state.q[[5, 11]] += 0.4
    np.testing.assert_allclose(evaluate.residual(system, state), before, atol=1e-12 * np.abs(before).max())


def test_shaft_and_fixed_beam_agree():
    """The same round piece, once in frames that do not spin and once fixed to the spinning bodies."""
    beam = Beam(section=ROUND, length=0.4, **SOFT)
    bodies = nodes([0.0, 0.4], {0: HEAVY, 1: HEAVY})
    systems = [
        assemble(bodies, {name: make(beam, bodies=(1, 2), eta=1e-2)})
        for name, make in (("beam", beam_row), ("shaft_beam", shaft_row))
    ]
    state = stirred(systems[0])
    a, b = (evaluate.residual(s, state) for s in systems)
    np.testing.assert_allclose(a, b, atol=1e-12 * np.abs(a).max())


def test_forces_in_the_section():
    beam = Beam(section=FLAT, length=0.5, E=2e11, G=8e10)
    body = Body(
        motion=FREE, position=(0, 0, 0.5), mass=1.0, polar_inertia=1.0, transverse_inertia=1.0, name="tip"
    )
    system = assemble([body], {"beam": beam_row(beam, bodies=(0, 1))}, names={"beam": ["rod"]})
    state = system.initial_state()
    load = np.array([10.0, -20.0, 30.0, 4.0, -5.0, 6.0])
    order = [system.layout.coordinate(f"tip.{c}") for c in ("x", "y", "z", "alpha", "beta", "spin")]
    state = settled(system, state, load[order], steps=1)
    seen = dict(zip((c.name for c in system.layout.channels), evaluate.observe(system, state), strict=True))
    end = [seen[f"beam_force[rod.j.{w}]"] for w in ("fx", "fy", "fz", "mx", "my", "mz")]
    root = [seen[f"beam_force[rod.i.{w}]"] for w in ("fx", "fy", "fz", "mx", "my", "mz")]
    np.testing.assert_allclose(end, load, rtol=2e-3)  # the tip tilts by 1e-4
    expected = np.concatenate([load[:3], load[3:] + np.cross([0, 0, 0.5], load[:3])])
    np.testing.assert_allclose(root, expected, rtol=2e-3, atol=1e-2)


def planar_cantilever(n, section, length=1.0, E=2e11):
    """Bodies that move in x, y and turn about z, beams along x, the first end on ground."""
    along_x = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])  # axis 1 = y, 2 = z, beam = x
    beam = Beam(section=section, length=length / n, E=E, G=0.4 * E)
    bodies = [
        Body(motion=PLANAR, position=(length * (k + 1) / n, 0, 0), mass=1.0, polar_inertia=1.0, name=f"n{k}")
        for k in range(n)
    ]
    records = fixed_beams([beam] * n, first=0, axes=(along_x, along_x))
    return bodies, records


def settled(system, state, load, steps=20, tolerance=None):
    """Newton from state to equilibrium under generalised forces, the load raised in steps."""
    enough = tolerance or 1e-9 * np.abs(load).max()
    for share in np.linspace(0.0, 1.0, steps + 1)[1:]:
        count = 0
        while True:
            rest = evaluate.residual(system, state) - share * load
            if np.abs(rest).max() < enough:
                break
            state.q -= np.linalg.solve(evaluate.matrix(system, state, 0.0, 0.0, 1.0), rest)
            count += 1
            assert count < 20  # the first steps of a thin beam stretch it
    return state


THIN = Section(A=1e-4, I_1=1e-9, I_2=1e-9, J=2e-9, kappa_1=0.0, kappa_2=0.0)


@pytest.mark.parametrize("n", [5, 10])
def test_end_moment_rolls_a_cantilever_up(n):
    """M = 2 pi E I / L bends it into a circle; the angle is exact for any number of elements."""
    bodies, records = planar_cantilever(n, THIN)
    system = assemble(bodies, {"beam": records})
    state = system.initial_state()
    load = np.zeros(state.q.size)
    load[system.spin(f"n{n - 1}")] = 2.0 * math.pi * 2e11 * 1e-9
    state = settled(system, state, load)
    spins = [system.spin(f"n{k}") for k in range(n)]
    np.testing.assert_allclose(state.q[spins], 2.0 * math.pi * np.arange(1, n + 1) / n, rtol=1e-8)
    tip = [system.layout.coordinate(f"n{n - 1}.{c}") for c in "xy"]
    np.testing.assert_allclose(state.q[tip] + [1.0, 0.0], 0.0, atol=1e-8)


def elastica(alpha):
    """Tip (x, y)/L and slope of a cantilever under a dead transverse end load P with alpha = P L^2 / E I."""

    def slopes(s, y):
        return np.vstack([y[1], -alpha * np.cos(y[0]), np.cos(y[0]), np.sin(y[0])])

    def ends(a, b):
        return np.array([a[0], b[1], a[2], a[3]])

    s = np.linspace(0.0, 1.0, 200)
    found = solve_bvp(slopes, ends, s, np.vstack([s, 1.0 - s, s, 0.0 * s]), tol=1e-10, max_nodes=20000)
    assert found.success
    return found.y[2, -1], found.y[3, -1], found.y[0, -1]


def test_elastica_under_a_dead_end_load():
    x, y, slope = elastica(10.0)
    assert (1.0 - x, y) == pytest.approx((0.5550, 0.8106), abs=1e-4)  # Mattiasson 1981, Table 1
    found = []
    for n in (10, 20):
        bodies, records = planar_cantilever(n, THIN)
        system = assemble(bodies, {"beam": records})
        state = system.initial_state()
        load = np.zeros(state.q.size)
        load[system.layout.coordinate(f"n{n - 1}.y")] = 10.0 * 2e11 * 1e-9
        state = settled(system, state, load, steps=5)
        at = [system.layout.coordinate(f"n{n - 1}.{c}") for c in ("x", "y", "spin")]
        found.append(state.q[at] + [1.0, 0.0, 0.0] - [x, y, slope])
    # stretch P L / E A is 1e-4 of the length, the elements are finer than that
    assert np.abs(found[0]).max() < 2e-4
    assert np.abs(found[1]).max() < 1e-4


def test_45_degree_bend_under_a_load_out_of_plane():
    """Bathe and Bolourchi 1979, tip after P = 600: (15.79, 47.23, 53.37) by Simo and Vu-Quoc 1986 (8
    elements).

    Published codes scatter between 15.6 and 15.9, 46.8 and 47.3, 53.3 and 53.6.
    """
    n, R = 8, 100.0
    angles = np.linspace(0.0, math.pi / 4.0, n + 1)
    points = np.stack([R * np.sin(angles), R * (1.0 - np.cos(angles)), 0.0 * angles], axis=1)  # in plane x, y
    bodies = [
        Body(motion=FLOATING, position=p, mass=1.0, inertia=np.eye(3), name=f"n{k}")
        for k, p in enumerate(points[1:])
    ]
    section = Section(A=1.0, I_1=1.0 / 12, I_2=1.0 / 12, J=1.0 / 6, kappa_1=5.0 / 6, kappa_2=5.0 / 6)
    rows = []
    for k in range(n):
        d = points[k + 1] - points[k]
        e = d / np.linalg.norm(d)
        axes = np.stack([[0.0, 0.0, 1.0], np.cross(e, [0.0, 0.0, 1.0]), e], axis=1)
        beam = Beam(section=section, length=float(np.linalg.norm(d)), E=1e7, G=5e6)
        ends = (points[0], np.zeros(3)) if k == 0 else (np.zeros(3), np.zeros(3))
        rows.append(beam_row(beam, bodies=(k, k + 1), nodes=ends, axes=(axes, axes)))
    force = np.zeros(1, FORCE)
    force["i"], force["value"], force["F"] = n, 600.0, [0, 0, 1.0, 0, 0, 0]
    system = assemble(bodies, {"beam": np.concatenate(rows)})
    state = system.initial_state()
    load = np.zeros(state.q.size)
    load[system.layout.coordinate(f"n{n - 1}.z")] = 600.0
    state = settled(system, state, load, steps=10)
    tip = points[-1] + state.q[[system.layout.coordinate(f"n{n - 1}.{c}") for c in "xyz"]]
    np.testing.assert_allclose(sorted(tip), [15.79, 47.23, 53.37], atol=0.3)


def energy(system, kind):
    """Kinetic and strain energy and momentum of one beam and its bodies, from the frames (NumPy)."""
    fr = system.workspace.fr
    b = system.records[kind][0]
    kinetic, momentum = 0.0, np.zeros(3)
    for body, f in zip(system.bodies, fr[1:], strict=True):
        n = f["R"][:, 2]
        w, v = f["tw"][3:], f["tw"][:3]
        inertia = body.transverse_inertia * np.eye(3) + (
            body.polar_inertia - body.transverse_inertia
        ) * np.outer(n, n)
        kinetic += 0.5 * body.mass * v @ v + 0.5 * w @ inertia @ w
        momentum += body.mass * v
    w1, w = b["w1"][:5], b["w"]
    kinetic += 0.5 * np.einsum("kl,ki,li->", b["M"], w1, w1)
    spins = np.array([b["omega"][k] @ w[3 + k] for k in range(2)])
    kinetic += 0.5 * spins @ b["polar"] @ spins
    momentum += np.einsum("l,li->i", b["M"][0] + b["M"][1], w1)
    u = b["axial"] / b["k_u"]
    angle = math.atan2(np.linalg.norm(np.cross(w[3], w[4])), w[3] @ w[4])
    across = (w[3] + w[4]) - (w[3] + w[4]) @ w[2] * w[2]
    strain = 0.5 * b["k_u"] * u**2 + 0.5 * b["k_t"] * (b["torque"] / b["k_t"]) ** 2
    strain += 0.5 * b["k_d"] * angle**2 + 0.5 * b["k_s"] * across @ across
    y = w[5:7] @ w[2]
    strain += 0.5 * b["c_a"] * (y @ y) + b["c_b"] * y[0] * y[1]
    return kinetic + strain, momentum


@pytest.mark.parametrize("kind", ["beam", "shaft_beam"])
def test_energy_and_momentum_of_a_free_beam_stay(kind):
    """Rates of energy and momentum along the motion, by differences of fourth order over a path in time."""
    system = one(kind, eta=0.0)
    state = stirred(system)
    evaluate.prepare(system)
    evaluate.load(system, state)
    evaluate.check(system, evaluate.accelerations(system, 0.0))
    start = evaluate.store(system, 0.0)
    h, found = 1e-5, {}
    for k in (-2, -1, 1, 2):
        moved = start.copy()
        moved.q = start.q + k * h * start.v + 0.5 * (k * h) ** 2 * start.a
        moved.v = start.v + k * h * start.a
        evaluate.residual(system, moved)
        found[k] = energy(system, kind)
    rates = [(8 * (found[1][i] - found[-1][i]) - (found[2][i] - found[-2][i])) / (12 * h) for i in range(2)]
    evaluate.residual(system, start)
    force = np.abs(system.records[kind]["V"]).max()
    assert force > 100.0
    assert abs(rates[0]) < 1e-8 * force * np.abs(start.v).max()
    np.testing.assert_allclose(rates[1], 0.0, atol=1e-8 * force)


def test_damping_takes_energy_whatever_the_motion():
    lossy, free = one("shaft_beam"), one("shaft_beam", eta=0.0)
    for seed in range(5):
        state = stirred(lossy, seed)
        change = evaluate.residual(lossy, state) - evaluate.residual(free, state)
        twists = [J @ state.v[6 * k : 6 * k + 6] for k, J in enumerate(lossy.workspace.arrays["J"][:2])]
        lost = sum(
            (b["F"] - a["F"]) @ t
            for a, b, t in zip(free.workspace.fr[1:], lossy.workspace.fr[1:], twists, strict=True)
        )
        assert lost < 0.0
        assert np.abs(change).max() > 0.0


def pinned_shaft(n=12, eta=0.0, length=1.0, diameter=0.05):
    """Uniform shaft, both ends held across, one against axial motion and none against spin."""
    beam = Beam(section=tube(diameter), length=length / n, **STEEL)
    bodies = nodes(np.linspace(0.0, length, n + 1))
    hold = np.diag([1e13, 1e13, 1e10, 0.0, 0.0, 0.0]), np.zeros((6, 6))
    rows = supports(bodies, [(1, *hold), (n + 1, *hold)])
    return beam, assemble(bodies, {"shaft_beam": shaft([beam] * n, eta=eta), "bearing": rows})


def spinning(system, speed):
    state = system.initial_state()
    for b in range(len(system.bodies)):
        state.v[system.spin(f"n{b}")] = speed
    return state


def whirl(beam, length, speed, mode=1):
    """Whirl speeds [rad/s] of a pinned spinning Timoshenko shaft; positive forward.

    w = W sin(kz), psi = P cos(kz) with complex W, P and exp(i p t): rho A w'' = kAG (w_zz - psi_z),
    rho I psi'' - 2 i speed rho I psi' = EI psi_zz + kAG (w_z - psi).
    """
    s, k = beam.section, mode * math.pi / length
    shear, bend, rho_i = s.kappa_1 * s.A * beam.G, beam.E * s.I_1, beam.rho * s.I_1
    # (-rho A p^2 + S k^2) W = S k P;  (-rho I p^2 + 2 rho I speed p + bend k^2 + S) P = S k W
    first = np.array([-beam.rho * s.A, 0.0, shear * k**2])
    second = np.array([-rho_i, 2.0 * rho_i * speed, bend * k**2 + shear])
    return np.sort(np.roots(np.polysub(np.polymul(first, second), [(shear * k) ** 2])).real)[1:3]


@pytest.mark.parametrize("speed", [0.0, 3000.0])
def test_whirl_of_a_pinned_shaft(speed):
    beam, system = pinned_shaft()
    found, _ = damped_frequencies(*evaluate.linearize(system, spinning(system, speed)))
    found = found[found > 1.0]  # the free spin creeps by round-off
    back, forward = whirl(beam, 1.0, speed)
    expected = np.sort([-back, forward]) / (2.0 * math.pi)
    # twelve pieces: 1e-4 from the shear strain that is constant in each
    np.testing.assert_allclose(found[:2], expected, rtol=2e-4)
    if speed:
        assert found[1] / found[0] - 1.0 == pytest.approx(expected[1] / expected[0] - 1.0, rel=1e-2)
        assert found[1] / found[0] > 1.005


def test_damping_of_the_shaft_itself_drives_it_above_its_critical_speed():
    beam, system = pinned_shaft(n=4, eta=1e-5)
    critical = damped_frequencies(*evaluate.linearize(system, system.initial_state()))[0][0] * 2.0 * math.pi
    growth = {}
    for share in (0.0, 0.9, 0.99, 1.02, 1.5):
        state = spinning(system, share * critical)
        frequency, real = damped_frequencies(*evaluate.linearize(system, state))
        growth[share] = real[np.argmax(real)]
        if share == 0.0:  # ratio eta omega/2
            assert -real[0] / (2 * math.pi * frequency[0]) == pytest.approx(0.5e-5 * critical, rel=1e-3)
    assert growth[0.9] < 0.0
    assert growth[0.99] < 0.0
    assert growth[1.02] > 0.0
    assert growth[1.5] > growth[1.02]


def test_tension_stiffens_and_euler_load_unloads():
    beam, system = pinned_shaft(n=4)
    state = system.initial_state()
    euler = math.pi**2 * beam.E * beam.section.I_1
    sheared = euler / (1.0 + euler / (beam.section.kappa_1 * beam.section.A * beam.G))
    rest = damped_frequencies(*evaluate.linearize(system, state))[0][0]
    compressed = state.copy()
    stiffness = beam.E * beam.section.A
    for b in range(5):
        compressed.q[system.layout.coordinate(f"n{b}.z")] = -0.5 * sheared / stiffness * b / 4.0
    found = damped_frequencies(*evaluate.linearize(system, compressed))[0][0]
    # f^2 falls in proportion; the element's own bowing counts, so four pieces do
    assert (found / rest) ** 2 == pytest.approx(0.5, abs=5e-3)


def test_flat_sections_do_not_spin():
    with pytest.raises(CompileError, match="must be round"):
        shaft_row(Beam(section=FLAT, length=0.4, **STEEL), bodies=(1, 2))


def test_shaft_between_opposite_axes():
    """The second body turned upside down: the same matrices in its coordinates."""
    beam = Beam(section=ROUND, length=0.4, **STEEL)
    bodies = nodes([0.0, 0.4], {0: HEAVY, 1: HEAVY})
    flip = np.diag([1.0, -1.0, -1.0])
    upside = Body(**{**vars(bodies[1]), "axes": flip})
    plain = assemble(bodies, {"shaft_beam": shaft_row(beam, bodies=(1, 2), eta=1e-4)})
    row = shaft_row(beam, bodies=(1, 2), senses=(1, -1), eta=1e-4)
    turned = assemble([bodies[0], upside], {"shaft_beam": row})
    P = np.diag([1.0] * 6 + [1.0, -1.0, -1.0] * 2)
    state = plain.initial_state()
    state.v[[5, 11]] = 200.0
    expected = evaluate.linearize(plain, state)
    state.v[11] = -200.0
    for X, Y in zip(evaluate.linearize(turned, state), expected, strict=True):
        np.testing.assert_allclose(X, P @ Y @ P, atol=1e-9 * np.abs(Y).max())
    state = stirred(turned)
    state.v[11] -= 10.0
    M, D, K = evaluate.linearize(turned, state)
    for found, key, step in ((M, "a", 1e-2), (D, "v", 1e-5), (K, "q", 1e-7)):
        np.testing.assert_allclose(found, differences(turned, state, key, step), atol=2e-7 * np.abs(K).max())


def test_shaft_from_a_spinning_carrier():
    """A body on a carrier that spins, joined to a coaxial body on ground: turns of the carrier count."""
    carrier = Body(mass=1.0, polar_inertia=0.3, name="carrier")
    heavy = {"mass": 1.0, "polar_inertia": 0.2, "transverse_inertia": 0.1}
    rider = Body(motion=FREE, parent=1, position=(0, 0, 0.1), name="r", **heavy)
    other = Body(motion=FREE, position=(0, 0, 0.5), name="o", **heavy)
    beam = Beam(section=ROUND, length=0.4, **SOFT)
    system = assemble([carrier, rider, other], {"shaft_beam": shaft_row(beam, bodies=(2, 3), eta=1e-3)})
    torque = system.layout.channel("beam_force[shaft_beam0.i.mz]")
    seen = []
    for turn in (0.0, 1.0, 3.0, 3.3 - 2 * math.pi, 6.0 - 2 * math.pi):
        state = system.initial_state()
        state.q[system.spin("carrier")] = turn
        state.q[system.spin("o")] = turn + 0.1
        state.q[system.spin("r")] = -0.02
        seen.append(evaluate.observe(system, state)[torque])
    np.testing.assert_allclose(seen, beam.G * beam.section.J / 0.4 * 0.12, rtol=1e-12)
    state.turns[1] += 7
    state.turns[3] += 7
    assert evaluate.observe(system, state)[torque] == pytest.approx(seen[0], rel=1e-12)
    state = stirred(system)
    M, D, K = evaluate.linearize(system, state)
    for found, key, step in ((M, "a", 1e-2), (D, "v", 1e-5), (K, "q", 1e-6)):
        np.testing.assert_allclose(found, differences(system, state, key, step), atol=1e-7 * np.abs(K).max())


@pytest.mark.parametrize(("speed", "first"), [(0.0, 3.5160), (6.0, 7.3604), (12.0, 13.1702)])
def test_blade_of_beams_stiffens_as_it_turns(speed, first):
    """Wright, Smith, Thresher, Wang, J. Appl. Mech. 49 (1982) 197-202, hub radius 0, flapping.

    E I = rho A = 1. Eight beams on a hub that turns; their tension is found, not given. Their number errs by
    less than 1e-3.
    """
    n = 8
    thin = Section(A=1e-2, I_1=1e-8, I_2=1e-8, J=2e-8, kappa_1=0.0, kappa_2=0.0)
    beam = Beam(section=thin, length=1.0 / n, E=1e8, G=4e7, rho=1e2)
    hub = Body(motion=GUIDED, inertia=np.zeros((3, 3)), name="hub")
    light = {"mass": 1e-9, "polar_inertia": 1e-9, "transverse_inertia": 1e-9}
    bodies = [
        Body(motion=FREE, parent=1, position=(0, 0, k / n), name=f"n{k}", **light) for k in range(1, n + 1)
    ]
    bodies.insert(0, hub)
    turn = np.zeros(1, guide.RECORD)
    turn["i"], turn["m"], turn["k"], turn["slope"], turn["first"] = 1, 3, guide.TIME, speed, 1
    system = assemble(bodies, {"beam": fixed_beams([beam] * n), "guide": turn})
    state = system.initial_state()
    state = settled(system, state, np.zeros(state.q.size), steps=1, tolerance=1e-8)
    M, _, K = evaluate.linearize(system, state)
    x = [system.layout.coordinate(f"n{k}.{c}") for k in range(1, n + 1) for c in ("x", "beta")]
    found = np.sqrt(np.min(np.linalg.eigvals(np.linalg.solve(M[np.ix_(x, x)], K[np.ix_(x, x)])).real))
    assert found == pytest.approx(first, rel=1e-3)
