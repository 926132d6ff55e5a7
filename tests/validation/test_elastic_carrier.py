# SPDX-License-Identifier: Apache-2.0
"""Planets on nodes of an elastic carrier, against rigid carriers, springs and beams in closed form.

Rigid limit: Young's modulus 1e7 times that of steel; with 1e8 the round-off of the eigenvalues, 2e-16 of the
highest one, is 2e-6 of the lowest. The check of the wave speed, which refuses such files as errors of units,
is turned off here.

Pins on springs: the springs of `tests/validation/test_planet_load_sharing.py`; there they are bearings.

Wind-up: n forces F at the middle of the pins of a carrier with rigid walls, its torque taken at one of them.
Half of each force is on the free wall, which turns by phi against the other one. Each half of a pin is a beam
from a wall, displaced by phi a/2 across, to the middle, which tilts by theta; with the stiffness k, k', k''
of its end, that of a web k_w at the same radius, torsion of both, and the tilting stiffness c of the teeth

    (k a^2/2 + k_w a^2 + (G J_p + G J_w)/L) phi - k' a theta = F a/2,    (2 k'' + c) theta = k' a phi.

Rotating ring: N point masses m on a regular polygon of massless beams of section A, radius R, kept by a hub
on spokes of section A_s. Equilibrium of a mass is m (R + u) Omega^2 = (2 sin(pi/N) A + A_s) E u/R; without
spokes and with m = 2 R sin(pi/N) rho A it is the growth of a ring, rho R^3 Omega^2/E, with the softening by
it. Massless planets on three of the masses follow.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.multibody.beam_section import Beam, tube
from pitchpoint.multibody.structure import beam_frame, make_structure
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.rules import elastic_body
from tests.support.elastic_carriers import (
    ARM,
    HALF,
    PIN,
    STEEL,
    WEB,
    around,
    carrier_on_springs,
    member,
    models,
    two_wall_carrier,
)
from tests.validation.test_planet_load_sharing import MESH, on_fixed_axes

ROUND = 7e-5
"""Round-off of forces [N], 1e-8 of those of the meshes."""
BEARING = "bearing: {stiffness: {radial: 8e8 N/m}}"


@pytest.fixture(autouse=True)
def any_wave_speed(monkeypatch):
    """Permit bodies of unreal stiffness."""
    monkeypatch.setattr(elastic_body, "check_speed", lambda *_: None)


def history(model):
    """Forces and speed over 2 ms at 1000 rpm."""
    begin = prepare_start(compile_model(model, "steady"), model.scenarios["steady"])
    run = generalized_alpha.start(begin.system, begin.state, 4e-6)
    place = begin.system.layout.channel
    wanted = [
        "mesh_force[sun-planet_1]",
        "mesh_force[planet_2-ring]",
        "speed[carrier]",
        "bearing_force[at_out.fx]",
    ]
    rows = []
    for _ in range(25):
        run.advance(20)
        rows.append(evaluate.observe(begin.system, run.state())[[place(c) for c in wanted]])
    return np.array(rows)


@pytest.mark.parametrize("motion", ["planar", pytest.param("torsion", marks=pytest.mark.study), "free"])
def test_a_stiff_carrier_is_rigid(tmp_path, motion):
    """Modes, statics and time response to 1e-6, with a pin error."""
    more = f"planets: 3\nmotion: {motion}\npin_errors: {{planet_1: {{tangential: 5 um}}}}\n"
    more += {"torsion": "", "planar": BEARING}.get(
        motion, "bearing: {stiffness: {radial: 8e8 N/m, axial: 2e8 N/m, tilt: 2e5 N m/rad}}"
    )
    rigid, elastic = models(tmp_path, two_wall_carrier(1e7 * STEEL), more, mesh=MESH)
    a, b = (find_modes(compile_model(m), None).frequency for m in (rigid, elastic))
    np.testing.assert_allclose(b[: a.size], a, rtol=1e-6, atol=1e-3)
    if motion == "planar":
        one, two = history(rigid), history(elastic)
        np.testing.assert_allclose(two, one, rtol=1e-6, atol=ROUND)
    x, y = (solve_equilibrium(compile_model(m)) for m in (rigid, elastic))
    for name in x:
        if "force" in name and name in y:
            assert float(y[name]) == pytest.approx(float(x[name]), rel=1e-6, abs=ROUND), name


def test_pins_on_springs_are_the_pin_stiffness(tmp_path):
    """In series with the bearing, with pin errors: forces and travel of the teeth to 1e-9, modes to 1e-6.

    The frame is that of the mean motion, not the hub, so that the error is proportional to the mass of the
    pins: 0.1 g for statics, 0.1 mg for modes. Coordinates of still lighter pins are below the tolerance of
    the equilibrium.
    """
    more = (
        f"planets: 3\nmotion: planar\npin_errors: {{planet_1: {{tangential: 8 um, radial: 5 um}}}}\n{BEARING}"
    )
    series = more.replace("N/m}}", "N/m}, pin_stiffness: 1.5e9 N/m}")

    def pair(mass):
        """Models with the rigid carrier and with pins of this mass."""
        rigid = models(tmp_path, carrier_on_springs(1.5e9, mass=mass), series, modes=9, mesh=MESH)[0]
        return rigid, models(tmp_path, carrier_on_springs(1.5e9, mass=mass), more, modes=9, mesh=MESH)[1]

    one, two = (solve_equilibrium(compile_model(m)) for m in pair(1e-4))
    for name in one:
        if name.startswith(("mesh_force", "transmission_error")):
            assert float(two[name]) == pytest.approx(float(one[name]), rel=1e-9), name
    a, b = (find_modes(compile_model(m), None).frequency for m in pair(1e-7))
    np.testing.assert_allclose(b[: a.size], a, rtol=1e-6, atol=1e-3)


@pytest.mark.parametrize(("count", "sun"), [(3, "torsion"), (4, "planar")])
def test_load_sharing_on_elastic_pins(tmp_path, count, sun):
    """Planets without bearings on pins of 5e8 N/m, one ahead by 8 um; the sun is fixed or floats."""
    errors = (8e-6, *[0.0] * (count - 1))
    more = f"planets: {count}\npin_errors: {{planet_1: {{tangential: 8 um}}}}"
    carrier = carrier_on_springs(5e8, count)
    _, model = models(tmp_path, carrier, more, modes=3 * count, mesh=MESH, bearing=1e12, sun=sun)
    found = solve_equilibrium(compile_model(model))
    got = np.array([float(found[f"mesh_force[sun-planet_{k + 1}]"]) for k in range(count)])
    wanted = on_fixed_axes(errors, 600.0, 5e8)
    if sun == "planar":  # what alternates is left
        sign = np.array([1.0, -1.0, 1.0, -1.0])
        wanted = wanted.mean() + sign * (sign @ wanted) / 4
    assert got == pytest.approx(wanted, abs=1e-3 * wanted.mean())
    assert np.ptp(wanted) > 0.04 * wanted.mean()


def half_beam(section, length):
    """Stiffness of a beam by deflection, both, and rotation of one end, the other one fixed [N/m, N, N m]."""
    K = Beam(section=section, length=length, E=STEEL, G=STEEL / 2.6).stiffness()
    return K[0, 0], abs(K[0, 4]), K[4, 4]


@pytest.mark.parametrize("torque", [60.0, 600.0])
def test_wind_up_tilts_the_pins_and_shifts_the_load(tmp_path, torque):
    """Tilt, and the moments of the teeth by it, which shift the load along the face width, to 2e-3."""
    more = "planets: 3\nmotion: free\n"
    more += "bearing: {stiffness: {radial: 8e8 N/m, axial: 2e8 N/m, tilt: 1e10 N m/rad}}"
    _, model = models(tmp_path, two_wall_carrier(wall=1e7), more, mesh=MESH, torque=torque)
    found = solve_equilibrium(compile_model(model))
    force = float(found["bearing_force[planet_1-bearing.fy]"])
    assert abs(force) == pytest.approx(2.0 * torque / (3 * 31.5e-3), rel=1e-4)
    (k, both, turn), (k_w, _, _) = half_beam(PIN, HALF), half_beam(WEB, 2 * HALF)
    width, cos = 40e-3, math.cos(math.radians(20.0))
    teeth = 2.0 * 5e8 * width**2 / 12.0 * cos**2  # of sun and ring, by tilt of the planet about the radius
    torsion = STEEL / 2.6 * (PIN.J + WEB.J) / (2 * HALF)
    K = np.array(
        [[0.5 * k * ARM**2 + k_w * ARM**2 + torsion, -both * ARM], [-both * ARM, 2.0 * turn + teeth]]
    )
    _, tilt = np.linalg.solve(K, [0.5 * abs(force) * ARM, 0.0])
    moment = float(found["bearing_force[planet_1-bearing.mx]"])
    assert abs(moment) == pytest.approx(teeth * tilt, rel=2e-3)
    begin = prepare_start(compile_model(model, "slow"), model.scenarios["slow"])
    evaluate.residual(begin.system, begin.state)
    axis = begin.system.workspace.fr[begin.system.layout.bodies.index("planet_1")]["R"][:, 2]
    assert abs(axis[1]) == pytest.approx(tilt, rel=2e-3)
    share = 0.5 * abs(moment) * 6.0 / (abs(force) / (2.0 * cos) * width * cos)
    assert share == pytest.approx(0.5 * width * tilt * cos * 5e8 / (0.5 * abs(force) / cos), rel=3e-3)


RIM, SPOKE, MASS, COUNT = tube(20e-3), tube(12e-3), 0.5, 9
"""Bars, spokes, mass [kg] and number of the masses of the ring."""


def ring_of_masses():
    """Masses on a ring of bars, on spokes; bending and torsion are condensed, as they have no mass."""
    places = np.array([(0.0, 0.0, 0.0), *((*around(k, COUNT), 0.0) for k in range(COUNT))])
    along = (0.0, 0.0, 1.0)
    members = [member(0, 1 + k, SPOKE, STEEL, along) for k in range(COUNT)]
    members += [member(1 + k, 1 + (k + 1) % COUNT, RIM, STEEL, along) for k in range(COUNT)]
    K = beam_frame(places, members).K.toarray()
    kept = np.r_[:6, [6 + 6 * k + d for k in range(COUNT) for d in range(3)]]
    rest = np.setdiff1d(np.arange(len(K)), kept)
    K = K[np.ix_(kept, kept)] - K[np.ix_(kept, rest)] @ np.linalg.solve(
        K[np.ix_(rest, rest)], K[np.ix_(rest, kept)]
    )
    M = np.diag([1.0] * 3 + [1e-2] * 3 + [MASS] * 3 * COUNT)
    node = [0] * 6 + [1 + k for k in range(COUNT) for _ in range(3)]
    names = {"out": places[0]} | {f"p{k}": places[3 * k - 2] for k in (1, 2, 3)}
    return make_structure(K, M, places, node, [*range(6)] + [0, 1, 2] * COUNT), names


@pytest.mark.parametrize("speed", [1000.0, 20000.0])
def test_pin_circle_of_a_rotating_ring_grows(tmp_path, speed):
    """Growth by centrifugal forces, in equilibrium at the start of a run: to 1e-6."""
    more = "planets: 3\nplanet_mass: 0 kg\nplanet_inertia: 1e-9 kg m^2"
    _, model = models(tmp_path, ring_of_masses(), more, modes=27, mesh=MESH, torque=0.0)
    model = model.replace("scenarios.steady.speed", {"sun": speed * math.pi / 30})
    begin = prepare_start(compile_model(model, "steady"), model.scenarios["steady"])
    evaluate.residual(begin.system, begin.state)
    frames, names = begin.system.workspace.fr, begin.system.layout.bodies
    omega = float(frames[names.index("carrier")]["tw"][5])
    assert omega == pytest.approx(speed * math.pi / 30 * 21 / 120, rel=1e-9)
    stiffness = (2.0 * math.sin(math.pi / COUNT) * RIM.A + SPOKE.A) * STEEL / ARM
    growth = MASS * ARM * omega**2 / (stiffness - MASS * omega**2)
    for k in (1, 2, 3):
        radius = math.hypot(*frames[names.index(f"planet_{k}")]["r"][:2])
        assert radius - ARM == pytest.approx(growth, rel=1e-6)
