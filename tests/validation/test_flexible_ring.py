# SPDX-License-Identifier: Apache-2.0
"""Planetary sets with a flexible ring: compliance, load sharing and modes in closed form.

The ring of 99 teeth is fixed in the modes n = 0 and n = 1 and free to bend. A force F along the line of
action of the mesh at theta has the radial component F sin(alpha) and the tangential component F cos(alpha) at
the working pitch circle, so that it does the work F s_k with the coordinate k,

    s = +-sin(alpha) cos(n theta) - V_w cos(alpha) sin(n theta), and a quarter of a wave further,

V_w = V + (r_w - R) Psi. The ring is the compliance matrix C = sum over k of s_k s_k^T / k_k between the ring
meshes. With N planets at equal angles its eigenvalue for equal forces has the modes n = N, 2 N, ..., that for
forces with the sum zero (N = 3) the others.

The torque of 1 N m on the sun deflects the ring by 2e-7 m, 1e-6 of its radius, so that the directions of the
forces are those of the undeflected set.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
from pitchpoint.solvers.time import solve_time
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.rules.flexible_rim import ring_modes, ring_section
from tests.support.planet_stages import stage_file

K, TORQUE = 5e8, 1.0
ALPHA = math.radians(20.0)
R_B, R_W = 0.5 * 21 * 3e-3 * math.cos(ALPHA), 0.5 * 99 * 3e-3
MESH = "stiffness: {law: constant, value: 5e8 N/m}, backlash: {normal: 0.2 mm}"
RIM = {"waves": 9}


def stage(more="planets: 3", rim=RIM, outside="330 mm", **how):
    """Planetary set with a ring of this rim; rigid without `rim`."""
    model = loads_model(stage_file(more, mesh=MESH, torque=TORQUE, **how))
    return model.replace_all({"gears.ring.bore_diameter": outside, "gears.ring.flexible_rim": rim})


def shapes(model, count):
    """Work of unit mesh forces on the coordinates, (count, coordinates), and their stiffness [N/m]."""
    gear = model.gears["ring"]
    R, found, stiffness = ring_section(gear).radius, [], []
    theta = math.tau * np.arange(count) / count
    for m in ring_modes(gear):
        V = m.tangential + (R_W - R) * m.rotation
        s, c = math.sin(ALPHA), V * math.cos(ALPHA)
        found += [s * np.cos(m.waves * theta) - c * np.sin(m.waves * theta)]
        found += [s * np.sin(m.waves * theta) + c * np.cos(m.waves * theta)]
        stiffness += 2 * [m.stiffness]
    return np.array(found).T, np.array(stiffness)


def compliance(model, count):
    """Compliance matrix of the ring between the ring meshes [m/N]; that of either flank."""
    s, k = shapes(model, count)
    return (s / k) @ s.T


@pytest.mark.parametrize("count", [3, 4])
def test_ring_is_a_spring_in_series_with_each_mesh(count):
    """Equal forces: energy N F^2 c/2 of the ring, and as much again by the rotation of the carrier."""
    model, rigid = stage(f"planets: {count}"), stage(f"planets: {count}", None)
    found, known = (solve_equilibrium(compile_model(m)) for m in (model, rigid))
    F = TORQUE / count / R_B
    c = float(compliance(model, count).sum(axis=0)[0])
    assert float(found["strain_energy[ring.rim]"]) == pytest.approx(0.5 * count * F**2 * c, rel=1e-4)
    turned = float(found["angle[carrier]"]) - float(known["angle[carrier]"])  # the sun is held
    assert abs(turned) * TORQUE * (1.0 + 99 / 21) == pytest.approx(count * F**2 * c, rel=1e-4)


def test_a_bending_ring_shares_the_load_better():
    """Three planets on rigid pins, sun on a fixed axis, one pin ahead: springs 2/K and the ring."""
    error = 1e-8
    pins = f"planets: 3\npin_errors: {{planet_1: {{tangential: {error!r} m}}}}"
    loads = {}
    for rim in (None, RIM):
        model = stage(pins, rim)
        found = solve_equilibrium(compile_model(model))
        loads[rim is None] = np.array([float(found[f"mesh_force[sun-planet_{k}]"]) for k in (1, 2, 3)])
        c = 2.0 / K
        if rim is not None:
            c += float(np.array([1.0, -0.5, -0.5]) @ compliance(model, 3) @ np.array([1.0, -0.5, -0.5]) / 1.5)
        shift = 2.0 * error * math.cos(ALPHA) / c
        F = TORQUE / 3 / R_B
        wanted = F + shift * np.array([-2 / 3, 1 / 3, 1 / 3])
        np.testing.assert_allclose(loads[rim is None], wanted, rtol=1e-4)
    spread = {rigid: np.ptp(found) for rigid, found in loads.items()}
    assert spread[False] < 0.6 * spread[True]


def test_stiff_ring_is_rigid():
    """Young's modulus 1e8 times that of steel."""
    stiff = {"density": 7830.0, "youngs_modulus": 206e17, "poisson_ratio": 0.3}
    found = find_modes(compile_model(stage("planets: 3").replace("gears.ring.material", stiff)), None)
    known = find_modes(compile_model(stage("planets: 3", None)), None)
    np.testing.assert_allclose(found.frequency[: known.frequency.size], known.frequency, rtol=1e-6, atol=1e-3)


@pytest.mark.parametrize("count", [3, 4])
def test_modes_of_the_ring_alone(count):
    """Wu and Parker (2008): with 2n/N whole, one mode of n waves has no motion along the lines of action.

    Its frequency is that of the ring without planets, but for the rotation of the mesh forces, 1.5e-5 at this
    load; of the other numbers of waves no mode has it.
    """
    model = stage(f"planets: {count}")
    found = find_modes(compile_model(model), None).frequency
    for mode in ring_modes(model.gears["ring"]):
        same = np.abs(found / mode.frequency - 1.0) < 1e-4
        assert np.count_nonzero(same) == (1 if 2 * mode.waves % count == 0 else 0), mode.waves


def three_waves(model):
    """Amplitude of the ring mode n = 3 under the equal forces of three planets [m]."""
    gear = model.gears["ring"]
    mode = ring_modes(gear)[1]
    V = mode.tangential + (R_W - ring_section(gear).radius) * mode.rotation
    return TORQUE / R_B * math.hypot(math.sin(ALPHA), V * math.cos(ALPHA)) / mode.stiffness


def test_the_deflection_follows_the_planets():
    """Slow roll: three waves go round with the carrier, of constant amplitude; other modes are at rest."""
    model = stage("planets: 3")
    found = solve_quasistatic(compile_model(model), model.scenarios["slow"])
    wanted = three_waves(model)
    z = found["displacement[ring.1.cos3]"].to_numpy() + 1j * found["displacement[ring.2.sin3]"].to_numpy()
    np.testing.assert_allclose(np.abs(z), wanted, rtol=1e-4)
    carrier = np.unwrap(found["angle[carrier]"].to_numpy())
    turned = np.unwrap(np.angle(z))
    np.testing.assert_allclose(turned - turned[0], 3.0 * (carrier - carrier[0]), atol=1e-6)
    assert np.ptp(carrier) > 1e-2
    for other in ("displacement[ring.1.cos2]", "displacement[ring.2.cos4]"):
        assert np.abs(found[other]).max() < 1e-4 * wanted


@pytest.mark.parametrize("ratio", [0.6, pytest.param(1.0, marks=pytest.mark.study)])
def test_planets_going_round_excite_the_ring(ratio):
    """Critical speed of the carrier omega_n/n: the ring mode n = 3 is forced at 3 times this speed.

    A constant mesh stiffness excites nothing else; a heavy ring brings the critical speed down.
    """
    zeta = 0.4
    heavy = {"density": 7.83e5, "youngs_modulus": 206e9, "poisson_ratio": 0.3}
    model = stage("planets: 3", {"waves": 3, "damping_ratio": zeta}).replace("gears.ring.material", heavy)
    mode = ring_modes(model.gears["ring"])[1]
    omega = math.tau * mode.frequency
    sun = ratio * omega / 3.0 * (1.0 + 99 / 21) * 60.0 / math.tau
    settle = 9.0 / (zeta * omega)
    steady = {"speed": {"sun": f"{sun!r} rpm"}, "duration": 1.1 * settle, "settle_time": settle}
    found = solve_time(compile_model(model.replace("scenarios.steady", steady), "steady"))
    z = found["displacement[ring.1.cos3]"].to_numpy() + 1j * found["displacement[ring.2.sin3]"].to_numpy()
    wanted = three_waves(model) / math.hypot(1.0 - ratio**2, 2.0 * zeta * ratio)
    late = found["time"].to_numpy() > settle
    np.testing.assert_allclose(np.abs(z[late]), wanted, rtol=1e-3)


def test_spinning_ring_gear():
    """Coriolis forces couple both modes of n waves, centrifugal forces stretch the ring: Carrier (1945)."""
    ring = "\n".join(stage_file().splitlines()[:3])
    ring = ring.replace("tip_diameter", "bore_diameter: 330 mm, flexible_rim: {waves: 4}, tip_diameter")
    ring += "\nbodies: {ring: {gears: [ring], motion: torsion, position: [0, 0, 0]}}\n"
    model = loads_model(ring)
    system = compile_model(model)
    state, spin = system.initial_state(), 200.0
    state.v[system.layout.coordinate("ring.spin")] = spin
    M, D, K = evaluate.linearize(system, state)
    for mode in ring_modes(model.gears["ring"]):
        own = [
            k
            for k, c in enumerate(system.layout.coordinates)
            if c.endswith((f"cos{mode.waves}", f"sin{mode.waves}"))
        ]
        np.testing.assert_allclose(M[np.ix_(own, own)], mode.mass * np.eye(2), rtol=1e-12, atol=1e-12)
        turned = 2.0 * spin * mode.coriolis * np.array([[0.0, -1.0], [1.0, 0.0]])
        np.testing.assert_allclose(D[np.ix_(own, own)], turned, rtol=1e-12, atol=1e-9)
        k = mode.stiffness + spin**2 * (mode.stretch - mode.mass)
        np.testing.assert_allclose(K[np.ix_(own, own)], k * np.eye(2), rtol=1e-9, atol=1e-3)
        free = math.tau * mode.frequency
        n = mode.waves
        values = np.linalg.eigvals(
            np.block([[np.zeros((2, 2)), np.eye(2)], [-np.eye(2) * k / mode.mass, -turned / mode.mass]])
        )
        root = math.hypot(free, n * (n**2 - 1) / (n**2 + 1) * spin)
        shift = 2 * n / (n**2 + 1) * spin
        wanted = [root - shift, root + shift]
        np.testing.assert_allclose(np.sort(np.abs(values.imag))[::2], wanted, rtol=3e-3)


def test_axes_of_the_world_change_nothing():
    """The set with its axis along x, and with the gears turned about it; unequal supports show the angles."""
    rim = {
        "waves": 5,
        "supports": {"angles": ["10 deg", "80 deg", "200 deg"], "radial": 1e7, "tangential": 3e7},
    }
    names = ("strain_energy[ring.rim]", "strain_energy[ring.supports]", "mesh_force[planet_2-ring]")
    wanted = None
    for axes in ("", ", axes: {z: [1, 0, 0], x: [0, 1, 0]}", ", axes: {z: [1, 0, 0], x: [0, 0.6, 0.8]}"):
        found = solve_equilibrium(compile_model(stage("planets: 3", rim, axes=axes)))
        values = [float(found[name]) for name in names]
        wanted = wanted or values
        assert values[1] > 0.01 * values[0]
        np.testing.assert_allclose(values, wanted, rtol=1e-6)
