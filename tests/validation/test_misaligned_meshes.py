# SPDX-License-Identifier: Apache-2.0
"""Meshes whose axes are held askew by the housing, against shafts that are really tilted and closed forms.

In the plane of action the lean of axis 2 against axis 1 counts as kappa = f cos(alpha) f_Sigma_beta +
sin(alpha) f_Sigma_delta (per unit of width; deviations of shaft parallelism as in ISO/TR 10064-3). Over a
spur face of width b with the stiffness c per width, at x of the middle of the face, a mesh carries

    F = c b x,  M = c kappa b^3/12            while the whole face carries, kappa b/2 < x
    F = c (x + kappa b/2)^2/(2 kappa)         beyond that, on a part of it
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.rules.gear_mesh import MeshLaws
from tests.invariants.test_gear_mesh import PAIRS, SHAPES
from tests.invariants.test_tangents import LOSSES, compare, gears, pressed
from tests.support.machines import compiled, pair
from tests.support.mesh_alone import moved
from tests.support.one_mesh import OneMesh, make_pair
from tests.validation.test_flank_deviations import WIDTH, machine, rolled

both_flanks = pytest.mark.parametrize("flank", [1, -1])


def one_mesh(kind, shape, tilted, skew):
    """Mesh with gear 2 tilted about the middle of its face, or with the same misalignment."""
    m = OneMesh(make_pair(**PAIRS[kind]), MeshLaws(stiffness=SHAPES[shape]))
    m.evaluate()
    e, t = (np.array(m.row["now"][name]) for name in "et")
    if tilted:
        lean = skew[0] * t + skew[1] * e
        m.frames = moved(m.frames, 1, np.array([0.0, 0.0, 0.0, *np.cross([0.0, 0.0, 1.0], lean)]))
    else:
        m.rec["skew"] = skew
    return m


@both_flanks
@pytest.mark.parametrize("shape", ["constant", "parabola"])
@pytest.mark.parametrize("kind", PAIRS)
@pytest.mark.parametrize("direction", [(1.0, 0.0), (0.0, 1.0), (0.6, -0.8)])
def test_forces_are_those_of_really_tilted_shafts(kind, shape, direction, flank):
    """Same penetration at the middle; the axes of real shafts also turn what acts along them.

    Wrenches differ by a few times the tilt (the line of action leans by it), forces along it by less.
    """
    size = 2e-4
    found = []
    for tilted in (True, False):
        m = one_mesh(kind, shape, tilted, size * np.array(direction))
        m.press(6e-6, flank)
        found.append((m.evaluate().copy(), m.get("mesh_force"), m.get("elastic_energy")))
    (F, force, energy), (G, other, stored) = found
    straight = one_mesh(kind, shape, True, (0.0, 0.0))
    straight.press(6e-6, flank)
    plain = straight.evaluate().copy()
    # what the misalignment does to the tilting moments is far above what the comparison leaves
    assert np.abs(F - plain)[:, 3:5].max() > 20.0 * np.abs(F - G)[:, 3:5].max()
    assert np.abs(F - G).max() < 5.0 * size * np.abs(F).max()
    assert other == pytest.approx(force, rel=1e-3)
    assert stored == pytest.approx(energy, rel=1e-3)


@pytest.mark.parametrize("torque", [3.0, 40.0])
@pytest.mark.parametrize("angles", [(0.0, 3e-4), (2e-4, 0.0), (1e-4, -2e-4)])
def test_load_over_the_face_of_a_misaligned_spur_gear(torque, angles):
    """Rest under a torque with a constant stiffness, on the whole face and on a part of it."""
    text = pair("{law: constant, value: 2e8}", torque=f"{torque} N m")
    model = loads_model(text)
    in_plane, out = angles
    model = model.replace("meshes.stage.misalignment", {"in_plane": in_plane, "out_of_plane": out})
    rest = solve_equilibrium(compile_model(model))
    alpha = model.pairs["stage"].alpha_wt
    force = torque / (0.5 * model.pairs["stage"].gear1.d_b)
    kappa = abs(math.cos(alpha) * out + math.sin(alpha) * in_plane)
    c, b = 2e8 / WIDTH, WIDTH
    x = force / (c * b)
    if 0.5 * kappa * b > x:
        x = math.sqrt(2.0 * kappa * force / c) - 0.5 * kappa * b
    assert (torque == 3.0) == (0.5 * kappa * b > force / (c * b))
    gap = 0.5 * model.backlash("stage")
    assert float(rest["deflection[stage]"]) - gap == pytest.approx(x, abs=1e-12)
    assert float(rest["mesh_force[stage]"]) == pytest.approx(force, rel=1e-9)


def test_moment_of_a_misaligned_face():
    """On free bodies at the same penetration: the moment about the pitch point is c kappa b^3/12."""
    for flank in (1, -1):
        m = one_mesh("spur", "constant", False, (3e-5, 2e-5))
        m.press(20e-6, flank)
        F = m.evaluate()
        kappa = flank * m.row["now"]["cos_a"] * 3e-5 + m.row["now"]["sin_a"] * 2e-5
        n = flank * m.row["now"]["cos_a"] * m.row["now"]["t"] + m.row["now"]["sin_a"] * m.row["now"]["e"]
        about = F[1, 3:] - np.cross(m.row["now"]["P"] - m.frames["r"][1], F[1, :3])
        width = m.row["b1"]
        wanted = -4e8 / width * kappa * width**3 / 12.0
        assert about @ np.cross(m.row["now"]["m"], n) == pytest.approx(wanted, rel=1e-9)


@pytest.mark.parametrize("internal", [False, True])
def test_a_misaligned_gear_touches_with_a_corner(internal):
    """The nearer end of the face leads by kappa b/2, always; 5 nm carry (see `test_eccentric_gears`)."""
    model = machine(21, 60 if internal else 31, internal=internal, direction=0.7)
    model = model.replace("meshes.stage.misalignment", {"in_plane": 2e-4, "out_of_plane": -1e-4})
    alpha = model.pairs["stage"].alpha_wt
    kappa = -math.cos(alpha) * 1e-4 + math.sin(alpha) * 2e-4
    error, _, _ = rolled(model, 6, 1)
    np.testing.assert_allclose(error, -0.5 * WIDTH * abs(kappa), atol=5e-9)


@pytest.mark.parametrize("losses", LOSSES)
@both_flanks
@pytest.mark.parametrize(
    ("kind", "beta", "motion"),
    [
        ("external", 0, "free"),
        ("external", 20, "free"),
        ("internal", 20, "free"),
        ("external", 20, "torsion"),
    ],
)
def test_matrices_of_misaligned_meshes_are_the_whole_derivative(kind, beta, motion, flank, losses):
    model = compiled(gears(kind, beta, motion, LOSSES[losses], "law: constant, value: 3e8"))[0]
    system = compile_model(model.replace("meshes.m.misalignment", {"in_plane": 3e-4, "out_of_plane": -2e-4}))
    for speed in (0.0, 100.0):
        state = pressed(system, np.random.default_rng(7), speed, flank, 1e-4)
        if speed == 0.0:
            state.v[:] = 0.0
        assert evaluate.observe(system, state)[system.layout.channel("contact_state[m]")] == flank
        compare(system, state, 1e-8)


# --- model files ------------------------------------------------------------------------------------------
def test_files_are_written_and_severity_takes_it_away():
    text = pair("{law: din3990}").replace("backlash: {", "misalignment: {in_plane: 0.2 mrad}, backlash: {")
    model = loads_model(text)
    assert loads_model(dump_model(model)) == model
    record = compile_model(model).records["gear_mesh"][0]
    assert record["fixed"] == 0
    np.testing.assert_allclose(record["skew"], [0.0, 2e-4])
    half = compile_model(model.replace("meshes.stage.misalignment.severity", 0.5)).records["gear_mesh"][0]
    np.testing.assert_allclose(half["skew"], [0.0, 1e-4])
    none = compile_model(model.replace("meshes.stage.misalignment.severity", 0.0)).records["gear_mesh"][0]
    assert none == compile_model(model.replace("meshes.stage.misalignment", None)).records["gear_mesh"][0]


@pytest.mark.parametrize(
    ("given", "where", "words"),
    [
        ("{in_plane: 20 deg}", "in_plane", "out of range"),
        ("{in_plane: 20 um}", "in_plane", "write"),
        ("{out_off_plane: 1 mrad}", "out_off_plane", "did you mean out_of_plane?"),
        ("{severity: -1}", "severity", "out of range"),
        ("2 mrad", "", "is not a mapping"),
    ],
)
def test_wrong_misalignments_are_told_with_their_lines(given, where, words):
    text = pair("{law: din3990}").replace("backlash: {", f"misalignment: {given}, backlash: {{")
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    (problem,) = caught.value.problems
    assert problem.where == f"meshes.stage.misalignment{'.' if where else ''}{where}"
    assert words in str(problem)
    assert problem.line == 8
