# SPDX-License-Identifier: Apache-2.0
"""Housing as a stiffness matrix between the seats of its bearings: the matrices assembled by hand."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import eigh

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.components.marker import Axes
from pitchpoint.model.frames import frame
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.residual import EXACT
from tests.support.engine import differences

MASS, POLAR, ACROSS = 4.0, 0.02, 0.03
BEARING = np.array([2e8, 2e8, 1e8, 3e5, 3e5, 0.0])
PLACES = {"left": -0.1, "right": 0.15}
FORCE = (0.3, -0.2, 0.1)
"""Small: tilts of 1e-8 rad leave the linear equations exact to 1e-7."""
ROTOR = """\
bodies:
  rotor: {motion: free, mass: 4 kg, inertia: 0.02, transverse_inertia: 0.03, position: [0.2, 0.1, 0],
          axes: {z: [1, 0.5, 0.2]}, markers: {end: {position: [0, 0, 150 mm]}}}
bearings:
  left: {body: rotor, position: [0, 0, -100 mm], stiffness: {radial: 2e8, axial: 1e8, tilt: 3e5}}
  right: {body: rotor, position: [0, 0, 150 mm], stiffness: {radial: 2e8, axial: 1e8, tilt: 3e5}}
loads:
  push: {body: rotor, marker: end, force: [0.3 N, -0.2 N, 0.1 N]}
housing:
  type: stiffness_matrix
  stiffness_file: K.csv
  nodes: [right, left]
  axes: {z: [0, 1, 0], x: [0, 0, 1]}
scenarios:
  still: {duration: 1 ms}
"""
OWN = frame(Axes(z=(1.0, 0.5, 0.2)))
HOUSING = frame(Axes(z=(0.0, 1.0, 0.0), x=(0.0, 0.0, 1.0)))
ORDER = ("right", "left")


def positive(seed, n=12, scale=1e8):
    """Positive definite matrix with lengths of 0.1 m between forces and moments."""
    rng = np.random.default_rng(seed)
    A = rng.normal(size=(n, n))
    units = np.tile([1.0, 1.0, 1.0, 0.1, 0.1, 0.1], n // 6) if n % 6 == 0 else np.ones(n)
    return scale * (A @ A.T / n + 0.2 * np.eye(n)) * np.outer(units, units)


def model_with(folder, K=None, text=ROTOR, **files):
    """Model of a file with its matrices."""
    np.savetxt(folder / "K.csv", positive(1) if K is None else K, delimiter=", ")
    for name, matrix in files.items():
        np.save(folder / f"{name}.npy", matrix)
    file = folder / "rotor.yaml"
    file.write_text(text, encoding="utf-8")
    return load_model(file)


def turn(axes):
    return np.kron(np.eye(2), axes)


def assembled(K, M=None):
    """Stiffness and mass of rotor (world axes, 6) and seats (axes of the matrix, 12), by hand."""
    whole = np.zeros((18, 18))
    whole[6:, 6:] = K
    for k, name in enumerate(ORDER):
        arm = OWN[:, 2] * PLACES[name]
        # world displacement of the journal: u + phi x arm
        journal = np.eye(6)
        journal[:3, 3:] = np.cross(np.eye(3), arm).T
        B = np.zeros((6, 18))
        B[:, :6] = turn(OWN).T @ journal
        B[:, 6 + 6 * k : 12 + 6 * k] = -turn(OWN).T @ turn(HOUSING)
        whole += B.T @ np.diag(BEARING) @ B
    inertia = np.zeros((18, 18))
    inertia[:3, :3] = MASS * np.eye(3)
    inertia[3:6, 3:6] = OWN @ np.diag([ACROSS, ACROSS, POLAR]) @ OWN.T
    if M is not None:
        inertia[6:, 6:] = M
    return whole, inertia


def without_spin(n=18):
    """Basis without the rotation of the rotor about its axis."""
    spin = np.zeros(n)
    spin[3:6] = OWN[:, 2]
    return np.linalg.qr(np.column_stack([spin, np.eye(n)]))[0][:, 1:]


def loads():
    """Force at the right bearing."""
    force = np.zeros(18)
    force[:3] = FORCE
    force[3:6] = np.cross(OWN[:, 2] * PLACES["right"], FORCE)
    return force


def displaced(K):
    basis = without_spin()
    whole, _ = assembled(K)
    return basis @ np.linalg.solve(basis.T @ whole @ basis, basis.T @ loads())


SIX = ("x", "y", "z", "alpha", "beta", "spin")


def moved(model, ways=SIX):
    """Displacements of rotor (world) and seats (axes of the matrix), and forces on the rotor by bearing."""
    found = solve_equilibrium(compile_model(model))
    at = {str(c): float(v) for c, v in zip(found.coordinate.values, found.position.values, strict=True)}
    rotor = OWN @ [at[f"rotor.{c}"] for c in "xyz"]
    seats = [at[f"housing-{n}.{c}"] for n in ORDER for c in ways]
    forces = {n: OWN @ [float(found[f"bearing_force[{n}.f{c}]"]) for c in "xyz"] for n in ORDER}
    return rotor, np.array(seats), forces


def test_static_displacements_are_those_of_the_assembled_matrix(tmp_path):
    """Rotor and seats move as the 18 equations say; a force at one bearing moves the other seat."""
    K = positive(1)
    rotor, seats, forces = moved(model_with(tmp_path, K))
    wanted = displaced(K)
    np.testing.assert_allclose(rotor, wanted[:3], atol=1e-6 * np.abs(rotor).max())
    np.testing.assert_allclose(seats, wanted[6:], atol=1e-6 * np.abs(seats).max())
    np.testing.assert_allclose(forces["left"] + forces["right"], -np.array(FORCE), atol=1e-7)
    assert np.abs(seats[6:9]).max() > 1e-10


def test_a_seat_moves_by_the_compliance_of_the_housing(tmp_path):
    """u = K^-1 f with the forces and moments of both bearings on their seats."""
    K = positive(2)
    model = model_with(tmp_path, K)
    found = solve_equilibrium(compile_model(model))
    _, seats, _ = moved(model)
    way = turn(HOUSING).T @ turn(OWN)
    parts = ("fx", "fy", "fz", "mx", "my", "mz")
    force = np.concatenate([-way @ [float(found[f"bearing_force[{n}.{c}]"]) for c in parts] for n in ORDER])
    np.testing.assert_allclose(seats, np.linalg.solve(K, force), atol=1e-6 * np.abs(seats).max())


def test_a_diagonal_matrix_is_a_spring_in_series(tmp_path):
    """1/k = 1/k_bearing + 1/k_housing in every direction: a pull along the axis of a shaft along x."""
    text = ROTOR.replace("[1, 0.5, 0.2]", "[0, 1, 0]").replace("[0.3 N, -0.2 N, 0.1 N]", "[0, 0.7 N, 0]")
    K = np.diag([5e7, 5e7, 2.5e7, 1e5, 1e5, 1e5] * 2)
    found = solve_equilibrium(compile_model(model_with(tmp_path, K, text)))
    at = dict(zip(found.coordinate.values.tolist(), found.position.values.tolist(), strict=True))
    # both bearings and seats along z of the matrix, which is y of the world
    assert at["rotor.z"] == pytest.approx(0.7 * (1 / 1e8 + 1 / 2.5e7) / 2, rel=1e-9)


def test_frequencies_are_those_of_the_assembled_matrices(tmp_path):
    """Mass matrix of the housing included, all 17 modes; the rotor turns freely."""
    K, M = positive(3), 5.0 * positive(4, scale=1.0)
    text = ROTOR.replace("  nodes:", "  mass_file: M.npy\n  nodes:").replace("  push: ", "  none: ")
    text = text.replace("[0.3 N, -0.2 N, 0.1 N]", "[0, 0, 0]")
    model = model_with(tmp_path, K, text, M=M)
    modes = find_modes(compile_model(model), mean=False)
    basis = without_spin()
    whole, inertia = (basis.T @ A @ basis for A in assembled(K, M))
    wanted = np.sqrt(eigh(whole, inertia, eigvals_only=True)) / (2 * np.pi)
    assert modes.frequency[0] == 0.0
    np.testing.assert_allclose(modes.frequency[1:], wanted, rtol=1e-8)
    assert {"matrix housing", "bearing left", "bearing right"} == set(modes.groups.components)


def test_tangents_are_the_derivatives_of_the_forces(tmp_path):
    """Stiffness, damping and mass, against differences."""
    text = ROTOR.replace("  nodes:", "  mass_file: M.npy\n  stiffness_damping: 1 ms\n  nodes:")
    system = compile_model(model_with(tmp_path, None, text, M=positive(5, scale=2.0)))
    state = system.initial_state()
    rng = np.random.default_rng(3)
    state.q[:], state.v[:] = 1e-5 * rng.normal(size=(2, state.q.size))
    steps = {"a": (1e2, (1.0, 0.0, 0.0)), "v": (1e-2, (0.0, 1.0, 0.0)), "q": (1e-7, (0.0, 0.0, 1.0))}
    for key, (step, factors) in steps.items():
        exact = evaluate.matrix(system, state, *factors, EXACT)
        found = differences(system, state, key, step)
        np.testing.assert_allclose(found, exact, atol=1e-6 * np.abs(exact).max())


def test_three_rows_per_node_are_a_seat_that_does_not_tilt(tmp_path):
    """Rigid rotor between seats with translations only; the tilt stiffness of the bearings is to ground."""
    K = positive(6, 6)
    text = ROTOR.replace("  nodes:", "  rows_per_node: 3\n  nodes:")
    _, _, forces = moved(model_with(tmp_path, K, text), ("x", "y", "z"))
    own = np.concatenate([HOUSING.T @ -forces[n] for n in ORDER])
    _, seats, _ = moved(model_with(tmp_path, K, text), ("x", "y", "z"))
    np.testing.assert_allclose(seats, np.linalg.solve(K, own), atol=1e-6 * np.abs(seats).max())


def free_beam():
    """Frame of two nodes at the bearings and two feet: springs between points, no force in rigid motions."""
    places = np.array([[0.3, 0.15, 0.02], [0.1, 0.05, -0.02], [0.0, -0.2, 0.1], [0.4, -0.2, -0.1]])
    K = np.zeros((24, 24))
    for a in range(4):
        for b in range(a):
            arm = places[b] - places[a]
            left, right = np.zeros((6, 24)), np.zeros((6, 24))
            left[:, 6 * a : 6 * a + 6] = np.eye(6)
            left[:3, 6 * a + 3 : 6 * a + 6] = np.cross(np.eye(3), arm).T
            right[:, 6 * b : 6 * b + 6] = np.eye(6)
            own = positive(10 * a + b, 6)
            K += (left - right).T @ own @ (left - right)
    return places, K


FEET = """\
  nodes: [right, left, front, rear]
  feet:
    front: {position: [0, -0.2, 0.1]}
    rear: {position: [0.4, -0.2, -0.1], stiffness: {radial: 1e7, axial: 1e7, tilt: 1e5, torsion: 1e5}}
"""


def with_feet(tmp_path, K, feet=FEET):
    """The rotor in a housing with feet, matrix in world axes, bearings at the places of `free_beam`."""
    text = ROTOR.replace("  nodes: [right, left]\n  axes: {z: [0, 1, 0], x: [0, 0, 1]}\n", feet)
    text = text.replace("axes: {z: [1, 0.5, 0.2]}", "axes: {z: [0.2, 0.1, 0.04]}")
    arm = float(np.linalg.norm([0.1, 0.05, 0.02]))
    text = text.replace("-100 mm", f"{-arm!r}").replace("150 mm", f"{arm!r}")
    return model_with(tmp_path, K, text)


def test_feet_are_fixed_or_on_springs(tmp_path):
    """The free housing on one fixed foot and one of 1e7 N/m: K with rows removed and springs added."""
    _, K = free_beam()
    model = with_feet(tmp_path, K)
    found = solve_equilibrium(compile_model(model))
    at = dict(zip(found.coordinate.values.tolist(), found.position.values.tolist(), strict=True))
    kept = [*range(12), *range(18, 24)]
    stiff = K[np.ix_(kept, kept)] + np.diag([0.0] * 12 + [1e7, 1e7, 1e7, 1e5, 1e5, 1e5])
    parts = ("fx", "fy", "fz", "mx", "my", "mz")
    own = frame(Axes(z=(0.2, 0.1, 0.04)))
    force = np.concatenate(
        [-turn(own) @ [float(found[f"bearing_force[{n}.{c}]"]) for c in parts] for n in ORDER] + [np.zeros(6)]
    )
    seats = [at[f"housing-{n}.{c}"] for n in (*ORDER, "rear") for c in SIX]
    np.testing.assert_allclose(seats, np.linalg.solve(stiff, force), atol=1e-6 * np.abs(seats).max())


def test_weight_of_the_mass_matrix(tmp_path):
    """With gravity the feet carry the mass of the housing: f = M g."""
    K, M = positive(3), np.kron(np.eye(2), np.diag([3.0, 3.0, 3.0, 0.1, 0.1, 0.1]))
    text = "gravity: [0, 0, -9.81]\n" + ROTOR.replace("  nodes:", "  mass_file: M.npy\n  nodes:")
    text = text.replace("mass: 4 kg", "mass: 1e-9 kg").replace("[0.3 N, -0.2 N, 0.1 N]", "[0, 0, 0]")
    _, seats, _ = moved(model_with(tmp_path, K, text, M=M))
    basis, whole = without_spin(), assembled(K)[0]
    force = np.zeros(18)
    force[6:] = M @ np.tile([*(HOUSING.T @ [0, 0, -9.81]), 0, 0, 0], 2)
    wanted = (basis @ np.linalg.solve(basis.T @ whole @ basis, basis.T @ force))[6:]
    np.testing.assert_allclose(seats, wanted, atol=1e-5 * np.abs(wanted).max())  # tilts of 1e-6


def wrong(change):
    """Positive matrix with one change."""
    K = positive(1)
    change(K)
    return K


def _unsymmetric(K):
    K[1, 7] *= 1.01


def _indefinite(K):
    K[1, 7] = K[7, 1] = 3.0 * np.sqrt(K[1, 1] * K[7, 7])


def _no_number(K):
    K[2, 2] = np.nan


@pytest.mark.parametrize(
    ("K", "words"),
    [
        (positive(1, 6), "has 6 rows (limit 12, 6 for each of 2 nodes)"),
        (wrong(_unsymmetric), "is not symmetric: row 2, column 8 (right y, left y)"),
        (wrong(_indefinite), "is not positive semidefinite: a motion, mostly of "),
        (wrong(_no_number), "has entries that are not finite"),
        (np.zeros((12, 11)), "is not a square matrix: 12 x 11"),
        (np.diag([0.0] + [1e8] * 11), "leaves 1 motions of the housing free"),
    ],
)
def test_wrong_matrices_are_refused_at_their_key(tmp_path, K, words):
    model = model_with(tmp_path, K)
    with pytest.raises(ModelError, match="housing.stiffness_file") as caught:
        compile_model(model)
    assert words in str(caught.value)
    assert "(line 11)" in str(caught.value)


def test_a_free_matrix_of_other_places_is_refused(tmp_path):
    """The nodes in another order: its six free motions are not those of the positions."""
    _, K = free_beam()
    compile_model(with_feet(tmp_path, K))
    with pytest.raises(ModelError, match=r"six motions without stiffness, but .* is none of them"):
        compile_model(
            with_feet(tmp_path, K, FEET.replace("[right, left, front, rear]", "[front, right, left, rear]"))
        )


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            "[right, left]",
            "[right, lefd]",
            "'lefd', which is neither a bearing in the housing nor a foot or part",
        ),
        ("[right, left]", "[right, lefd]", "did you mean left?"),
        ("[right, left]", "[right, right]", "names right twice"),
        ("[right, left]", "[right]", "does not contain bearings.left, which is in the housing"),
        ("  nodes:", "  rows_per_node: 4\n  nodes:", "is neither 3 nor 6"),
        ("  nodes:", "  parts: [ring]\n  nodes:", "names the body 'ring', which does not exist"),
        ("K.csv", "L.csv", "'L.csv' names a file that does not exist"),
        ("stiffness_matrix", "matrix", "allowed are rigid, stiffness_matrix, body"),
        ("  rotor: {", "  housing-left: {inertia: 1}\n  rotor: {", "needs the name housing-left"),
    ],
)
def test_wrong_nodes_are_refused(tmp_path, old, new, words):
    with pytest.raises(ModelError) as caught:
        model_with(tmp_path, None, ROTOR.replace(old, new))
    assert words in str(caught.value)


def test_written_models_have_the_housing_once(tmp_path):
    """The text reads back to an equal model; bearings keep no seat, and another file replaces the matrix."""
    model = model_with(tmp_path)
    assert "housing-left" not in model.to_yaml()
    (tmp_path / "again.yaml").write_text(model.to_yaml(), encoding="utf-8")
    again = load_model(tmp_path / "again.yaml")
    assert again.housing == model.housing
    assert again.bearings == model.bearings
    assert model.replace("housing", None).bearings["left"].housing is None
    assert model.replace_all({"bearings.left.housing": "ground", "housing.nodes": ["right"]})
    with pytest.raises(ModelError, match=r"housing.type: determines the other keys and cannot change alone"):
        model.replace("housing.type", "rigid")
