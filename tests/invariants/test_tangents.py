# SPDX-License-Identifier: Apache-2.0
"""Exact matrices against differences of the residual: bodies at speed, tilted, turning in all directions."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.contact.stiffness.description import PhaseStiffness
from pitchpoint.core.kernel import address
from pitchpoint.elements.mesh.exact_tangent import turning
from pitchpoint.multibody.bodies import FIXED, FREE, PLANAR, TORSION, Body
from pitchpoint.system import evaluate
from pitchpoint.system.rules.mesh_laws import MeshLaws
from pitchpoint.system.system import assemble
from tests.support.energy_slopes import shaken as displaced
from tests.support.engine import bearings, differences, frame, positive
from tests.support.machines import SPARE, compiled
from tests.support.mesh_alone import moved
from tests.support.one_mesh import OneMesh, make_pair

ARM = 0.1
"""Length that turns angles into displacements where entries are compared [m]."""


def scaled(A, system):
    """Matrix over displacements of `ARM` alone [N/m]: entries of all coordinates become comparable."""
    turns = np.array([c.rsplit(".", 1)[1] in ("alpha", "beta", "spin") for c in system.layout.coordinates])
    per = np.where(turns, 1.0 / ARM, 1.0)
    return per[:, None] * A * per


def compare(system, state, most):
    """Exact D and K against central differences; `most` is the error over the largest entry."""
    _, D, K = evaluate.linearize(system, state)
    for found, key, step in ((D, "v", 1e-3), (K, "q", 1e-7)):
        wanted = scaled(differences(system, state, key, step), system)
        error = np.abs(scaled(found, system) - wanted).max()
        assert error <= most * np.abs(wanted).max(), (key, error, np.abs(wanted).max())


def shaken(system, rng, speed, tilt=3e-3, offset=1e-5):
    """State with spins of about `speed`, tilts, offsets and rates of all of them."""
    state = system.initial_state()
    for k, name in enumerate(system.layout.coordinates):
        kind = name.rsplit(".", 1)[1]
        if kind == "spin":
            state.q[k], state.v[k] = 1e-3 * rng.normal(), speed * (1.0 + 0.1 * rng.normal())
        elif kind in ("alpha", "beta"):
            state.q[k], state.v[k] = tilt * rng.normal(), 3.0 * rng.normal()
        else:
            state.q[k], state.v[k] = offset * rng.normal(), 0.1 * rng.normal()
    return state


def body(motion, name, rng):
    return Body(
        motion=motion,
        position=(0.0, 0.0, 0.05 * rng.normal()),
        mass=2.0,
        polar_inertia=0.01,
        transverse_inertia=0.02,
        center=0.01,
        name=name,
    )


def full(rng, scale):
    """Full 6 x 6 matrix of a spring [N/m], turns on an arm of `ARM`."""
    arm = np.diag([1.0, 1.0, 1.0, ARM, ARM, ARM])
    return scale * arm @ positive(rng) @ arm


SPEEDS = [100.0, -700.0, 1500.0]
OTHERS = {"ground": None, "fixed": FIXED, "torsion": TORSION, "planar": PLANAR, "free": FREE}


@pytest.mark.parametrize("other", OTHERS)
@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("motion", [TORSION, PLANAR, FREE])
def test_bearings_and_couplings(motion, other, speed):
    """Full springs and dampers with markers off the origins and a preload, on all kinds of bodies."""
    rng = np.random.default_rng(abs(int(speed)) + motion)
    ends = [motion] if other == "ground" else [motion, OTHERS[other]]
    bodies = [body(m, name, rng) for m, name in zip(ends, "ab", strict=False)]
    records = bearings([(1, len(ends) - 1 and 2, full(rng, 1e7), full(rng, 1e3))])
    records["zi"], records["zj"] = 0.07, -0.04
    records["d0"] = bodies[0].position
    if len(ends) == 2:
        records["d0"] -= bodies[1].position
    records["d0"][:, 2] += 0.07 + 0.04
    records["u0"] = 1e-5 * rng.normal(size=6)
    records["B"] = frame(rng)
    records["d0"] = records["d0"] @ records["B"][0]
    system = assemble(bodies, {"bearing": records})
    compare(system, shaken(system, rng, speed), 1e-8)


LOADS = {
    "torque": "torque: '10 - 30*angle + 2*speed'",
    "table": "torque: {table: [[-1, 500], [1, -500]], over: angle}",
    "force": "position: [0.01, 0.02, 0.05], force: ['100*cos(50*angle)', '50*speed/100', 30]",
}


@pytest.mark.nojit
@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize("speed", [100.0, 1500.0])
def test_loads_over_angle_and_speed(load, speed):
    text = SPARE + (
        "bodies:\n  a: {motion: free, mass: 3, inertia: 0.02, transverse_inertia: 0.013}\n"
        f"loads:\n  l: {{body: a, {LOADS[load]}}}\n"
    )
    system = compiled(text)[1]
    state = shaken(system, np.random.default_rng(4), speed)
    compare(system, state, 1e-7)


def gears(kind, beta, motion, losses, law):
    """A pair with faces of different width and all its freedoms, on bearings that stay out of the way."""
    helix = [f", helix_angle: {beta} deg, hand: {h}" if beta else "" for h in ("right", "left", "right")]
    internal = kind == "internal"
    size = "motion: free, mass: 3, inertia: 0.01, transverse_inertia: 0.02"
    other = size if motion == "free" else f"motion: {motion}, mass: 3, inertia: 0.01"
    z2, inner = (70, ", type: internal" + helix[2]) if internal else (45, helix[1])
    return (
        "gears:\n"
        f"  g1: {{number_of_teeth: 23, normal_module: 3 mm, face_width: 25 mm, "
        f"profile_shift_coefficient: 0{helix[0]}}}\n"
        f"  g2: {{number_of_teeth: {z2}, normal_module: 3 mm, face_width: 20 mm, "
        f"profile_shift_coefficient: 0{inner}}}\n"
        f"bodies:\n  a: {{gears: {{g1: 20 mm}}, {size}, position: [0, 0, 0]}}\n"
        f"  b: {{gears: {{g2: -10 mm}}, {other}}}\n"
        "meshes:\n  m: {gears: [g1, g2], direction: 40 deg, backlash: {base_tangent: 50 um}, "
        f"stiffness: {{{law}}}{losses}}}\n"
    )


LOSSES = {
    "elastic": "",
    "damper": ", damper: {value: 5e4}",
    "damping": ", damping: {d_in: 5e4, d_out: 5e4, s_0: 0}",
    "ramp": ", damping: {d_in: 5e4, d_out: 5e4, s_0: 100 um}",
}


def pressed(system, rng, speed, flank, tilt):
    """Rolling gears at 30 um of penetration on one flank, shaken in all other directions."""
    state = shaken(system, rng, speed, tilt, 3e-6)
    r1, r2 = (float(system.records["gear_mesh"][0][k]) for k in ("r_b1", "r_b2"))
    one, two = system.spin("a"), system.spin("b")
    state.v *= 0.1  # not so fast that damped flanks let go
    state.v[one] *= 10.0
    state.v[two] = -state.v[one] * r1 / r2
    for _ in range(3):
        values = evaluate.observe(system, state)
        gap = float(system.records["gear_mesh"][0]["now"]["gap"])
        aim = flank * (0.5 * gap + 3e-5) - float(values[system.layout.channel("deflection[m]")])
        state.q[one] += aim / r1
    return state


@pytest.mark.parametrize("losses", LOSSES)
@pytest.mark.parametrize("flank", [1, -1])
@pytest.mark.parametrize(
    ("kind", "beta", "motion"),
    [
        ("external", 0, "free"),
        ("external", 20, "free"),
        ("internal", 0, "free"),
        ("internal", 20, "free"),
        ("external", 20, "planar"),
        ("internal", 20, "torsion"),
    ],
)
def test_meshes(kind, beta, motion, flank, losses):
    """A constant stiffness has no phase, so the exact matrices are the whole derivative."""
    text = gears(kind, beta, motion, LOSSES[losses], "law: constant, value: 3e8")
    system = compiled(text)[1]
    for speed in (0.0, 100.0, -1500.0):
        rng = np.random.default_rng(7)
        state = pressed(system, rng, speed, flank, 1e-4)
        if speed == 0.0:
            state.v[:] = 0.0
        values = evaluate.observe(system, state)
        assert values[system.layout.channel("contact_state[m]")] == flank
        compare(system, state, 1e-8)


@pytest.mark.parametrize("kind", ["external", "internal"])
@pytest.mark.parametrize("width", ["exact", "slices"])
@pytest.mark.parametrize("flank", [1, -1])
def test_flanks_at_a_phase_have_a_potential(kind, width, flank):
    """At rest, at frozen phase, the forces of tilted flanks are conservative: K is symmetric."""
    law = f"law: din3990, stiffness_ratio: 0.7, tip_relief_factor: 0.4}}, width: {{law: {width}"
    if width == "exact":
        law = law.partition("}, width")[0]
    text = gears(kind, 20, "free", "", law).replace("width: {law: slices}", "width: slices")
    system = compiled(text)[1]
    state = pressed(system, np.random.default_rng(3), 0.0, flank, 1e-4)
    state.v[:] = 0.0
    K = scaled(evaluate.linearize(system, state)[2], system)
    assert np.abs(K - K.T).max() < 1e-10 * np.abs(K).max()


def by_shared_width(m, k, depth):
    """Tangent of a tilted mesh by the change of its shared width with the axial offset, shape (12, 12).

    The force over the width from z_lo to z_hi is k (x - kappa z) / b. Its resultant and its moment are
    k (x - kappa z_m) and k (x z_m - kappa (b^2/12 + z_m^2)), b being the width and z_m its middle. An axial
    offset of the gears changes b by b' and, relative to the motion to which the force is conjugate, z_m by
    z_m'. For two gears of equal width b' = -1 or 1 and z_m' = 0: only the moment changes, by -k kappa b b'/6.
    """
    now, row = m.row["now"], m.row
    b, middle = now["z_hi"] - now["z_lo"], 0.5 * (now["z_hi"] + now["z_lo"])
    grows = now["hi_slope"] - now["lo_slope"]
    moves = 0.5 * (now["hi_slope"] + now["lo_slope"]) - row["w_z"]
    force = -k * now["kappa"] * moves
    moment = k * (depth * moves - now["kappa"] * (b * grows / 6.0 + 2.0 * middle * moves))
    basis = np.hstack([row["basis_i"], row["basis_j"]])
    return -np.outer(force * basis[0] + moment * basis[1], basis[2])


FACES = {
    "narrow gear 2": (30e-3, 20e-3, 3e-3, 1.0),
    "narrow gear 1": (20e-3, 30e-3, -3e-3, 0.0),
    "equal": (30e-3, 30e-3, 0.0, 0.5),
    "equal, shifted": (30e-3, 30e-3, -2e-3, 0.5),
    "overlapping": (30e-3, 20e-3, 8e-3, 1.0),
}
"""Face widths, axial offset [m], and the share of it that the shared width follows."""


@pytest.mark.parametrize("faces", FACES)
@pytest.mark.parametrize("internal", [False, True])
@pytest.mark.parametrize("beta", [0.0, 0.3])
@pytest.mark.parametrize("flank", [1, -1])
def test_tilted_meshes_are_exact_but_for_their_shared_width(beta, internal, flank, faces):
    """Spur and helical gears, tilts up to 10 mrad. A gear within the width of its mate: exact. Otherwise an
    axial offset changes the shared width, which tangents hold constant (docs/decisions/0006); the difference
    is the closed form of this change: for equal widths k kappa b/6, 2.5e6 N times the tilt for 5e8 N/m."""
    b1, b2, offset, follows = FACES[faces]
    k = 5e8
    arms = np.array([1.0, 1.0, 1.0, ARM, ARM, ARM] * 2)
    for tilt in (1e-4, 1e-3, 1e-2):
        pair = make_pair(beta=beta, internal=internal, z2=70)
        m = OneMesh(pair, MeshLaws(stiffness=PhaseStiffness(mean=k)), backlash=2e-3)
        m.rec["b1"], m.rec["b2"], m.rec["w_z"] = b1, b2, follows - m.row["w1"]
        m.rec["turning"] = address(turning)
        m.frames = moved(displaced(m, tilt).frames, 1, np.array([0.0, 0.0, offset, 0.0, 0.0, 0.0]))
        depth = 3e-5 + 0.03 * tilt
        m.press(depth, flank)
        m.evaluate(jac=2)
        found = m.tangent().reshape(12, 12) / arms / arms[:, None]
        left = by_shared_width(m, k, depth) / arms / arms[:, None]
        wanted = np.zeros((12, 12))
        for n in range(12):
            step = np.zeros(6)
            step[n % 6] = 1e-8 if n % 6 < 3 else 1e-7
            ends = [m.evaluate(moved(m.frames, n // 6, sign * step)) for sign in (1, -1)]
            wanted[:, n] = (ends[1] - ends[0]).ravel() / (2.0 * step.max() * arms[n] * arms)
        assert np.abs(found + left - wanted).max() < 1e-8 * np.abs(wanted).max()
        assert (np.abs(left).max() == 0.0) == faces.startswith("narrow")
