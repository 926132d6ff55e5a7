# SPDX-License-Identifier: Apache-2.0
"""Rigid housing on mounts, elastic body as housing, and the same body as a matrix of its seats."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import eigh

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.multibody.beam_section import Beam, rectangle
from pitchpoint.multibody.structure import beam_line
from pitchpoint.report.housing import gearbox_facts
from pitchpoint.report.masses import masses
from pitchpoint.report.scene.build import scene_of
from pitchpoint.solvers.contact_analysis.on_shafts import solve_contacts_on_shafts
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model

RIGID = """\
bodies:
  rotor: {motion: free, mass: 4 kg, inertia: 0.02, transverse_inertia: 0.03, position: [0, 0, 0.1]}
bearings:
  left: {body: rotor, position: [0, 0, -80 mm], stiffness: {radial: 2e8, axial: 1e8}}
  right: {body: rotor, position: [0, 0, 120 mm], stiffness: {radial: 1e8}}
loads:
  push: {body: rotor, position: [0, 0, 40 mm], force: [0.3 N, -0.2 N, 0.1 N]}
housing:
  type: rigid
  mass: 12 kg
  center_of_mass: [10 mm, -50 mm, 100 mm]
  inertia_tensor: [0.2, 0.3, 0.25, 0.01, 0, 0]
  mounts:
    a: {position: [-0.1, -0.15, 0], stiffness: {radial: 3e7, axial: 2e7}}
    b: {position: [0.1, -0.15, 0.05], stiffness: {radial: 2e7, axial: 4e7}}
    c: {position: [0, -0.15, 0.2], stiffness: {radial: 2e7, axial: 2e7}}
"""


def cross(arm):
    """Matrix of arm x."""
    return np.cross(np.eye(3), arm).T * -1.0


def moved_by(arm):
    """Displacement of a point at an arm from the motion (u, phi) of a body, 3 x 6."""
    return np.hstack([np.eye(3), -cross(arm)])


def test_a_rigid_housing_on_mounts_has_the_frequencies_of_its_matrices():
    """Rotor and housing, 12 equations by hand; a free rotation of the rotor."""
    model = loads_model(RIGID.replace("[0.3 N, -0.2 N, 0.1 N]", "[0, 0, 0]"))
    modes = find_modes(compile_model(model), mean=False)
    centre = np.array([0.01, -0.05, 0.1])
    K, M = np.zeros((12, 12)), np.zeros((12, 12))
    for z, k in ((0.02, (2e8, 2e8, 1e8)), (0.22, (1e8, 1e8, 0.0))):
        B = np.hstack([moved_by([0, 0, z - 0.1]), -moved_by(np.array([0, 0, z]) - centre)])
        K += B.T @ np.diag(k) @ B
    for place, k in (
        ([-0.1, -0.15, 0], (3e7, 3e7, 2e7)),
        ([0.1, -0.15, 0.05], (2e7, 2e7, 4e7)),
        ([0, -0.15, 0.2], (2e7, 2e7, 2e7)),
    ):
        B = np.hstack([np.zeros((3, 6)), moved_by(np.array(place) - centre)])
        K += B.T @ np.diag(k) @ B
    M[:6, :6] = np.diag([4.0, 4.0, 4.0, 0.03, 0.03, 0.02])
    M[6:9, 6:9] = 12.0 * np.eye(3)
    M[9:, 9:] = [[0.2, 0.01, 0.0], [0.01, 0.3, 0.0], [0.0, 0.0, 0.25]]
    kept = [0, 1, 2, 3, 4, *range(6, 12)]
    wanted = np.sqrt(eigh(K[np.ix_(kept, kept)], M[np.ix_(kept, kept)], eigvals_only=True)) / (2 * np.pi)
    assert modes.frequency[0] == 0.0
    np.testing.assert_allclose(modes.frequency[1:], wanted, rtol=1e-8)


def test_the_mounts_carry_what_the_bearings_transmit():
    """Sum of the bearing forces on the rotor = minus the load; the mounts carry it, and its moment."""
    model = loads_model(RIGID)
    found = solve_equilibrium(compile_model(model))
    push = np.array([0.3, -0.2, 0.1])

    def force(name):
        """Force of an element on its first body."""
        return np.array([float(found[f"{name}.f{c}]"]) for c in "xyz"])

    bearings = {n: force(f"bearing_force[{n}") for n in ("left", "right")}
    mounts = {n: force(f"bushing_force[housing-{n}") for n in "abc"}
    np.testing.assert_allclose(sum(bearings.values()), -push, atol=1e-7)
    np.testing.assert_allclose(sum(mounts.values()), -push, atol=1e-7)
    places = {"a": [-0.1, -0.15, 0], "b": [0.1, -0.15, 0.05], "c": [0, -0.15, 0.2]}
    moment = sum(np.cross(places[n], f) for n, f in mounts.items())
    # the spin of the rotor is free; forces on its axis have no moment about it
    np.testing.assert_allclose(moment, -np.cross([0, 0, 0.14], push), atol=1e-7)


# --- elastic body -------------------------------------------------------------------------------------------
SIDE, LENGTH, PIECES, E, NU = 0.04, 0.4, 8, 2.1e11, 0.3
BEAM = """\
bodies:
  rotor: {motion: free, mass: 4 kg, inertia: 0.02, transverse_inertia: 0.03, position: [0, 0, 0.2]}
bearings:
  left: {body: rotor, position: [0, 0, -100 mm], stiffness: {radial: 2e8, axial: 1e8, tilt: 1e5}}
  right: {body: rotor, position: [0, 0, 100 mm], stiffness: {radial: 1e8, axial: 1e8, tilt: 1e5}}
loads:
  push: {body: rotor, position: [0, 0, 50 mm], force: [0.3 N, -0.2 N, 0.1 N]}
"""
BODY = """\
elastic_bodies:
  case:
    file: case.npz
    position: [0, 0, 0]
    modes: 22
    static_shapes: true
    nodes: {foot: {}, left: {position: [0, 0, 100 mm]}, far: {position: [0, 0, 300 mm]}}
joints:
  clamp: {type: fixed, bodies: [ground, case.foot]}
housing: {type: body, body: case}
"""


def line():
    section = rectangle(SIDE, 0.6 * SIDE, NU)
    piece = Beam(section=section, length=LENGTH / PIECES, E=E, G=E / (2 * (1 + NU)), rho=7800.0)
    return beam_line([piece] * PIECES)


def whole(K, M, seats):
    """Rotor on six springs at the seats (first rows) of a housing without its foot: stiffness and mass."""
    n = 6 + len(K)
    stiff, mass = np.zeros((n, n)), np.zeros((n, n))
    stiff[6:, 6:], mass[6:, 6:] = K, M
    for (z, row), k in zip(seats.items(), ([2e8, 2e8, 1e8], [1e8, 1e8, 1e8]), strict=True):
        B = np.zeros((6, n))
        B[:3, :6], B[3:, 3:6] = moved_by([0, 0, z]), np.eye(3)
        B[:, 6 + row : 12 + row] = -np.eye(6)
        stiff += B.T @ np.diag([*k, 1e5, 1e5, 0.0]) @ B
    mass[:6, :6] = np.diag([4.0, 4.0, 4.0, 0.03, 0.03, 0.02])
    return stiff, mass


def displaced(stiff):
    """Displacement of the rotor under the push, its rotation held."""
    kept = np.setdiff1d(np.arange(len(stiff)), [5])
    force = np.zeros(len(stiff))
    force[:3] = 0.3, -0.2, 0.1
    force[3:6] = np.cross([0, 0, 0.05], force[:3])
    found = np.zeros(len(stiff))
    found[kept] = np.linalg.solve(stiff[np.ix_(kept, kept)], force[kept])
    return found


def of_file(folder, text):
    frame = line()
    np.savez(folder / "case.npz", K=frame.K.toarray(), M=frame.M.toarray(), places=frame.places)
    file = folder / "rotor.yaml"
    file.write_text(text, encoding="utf-8")
    return load_model(file)


def rotor_of(model):
    found = solve_equilibrium(compile_model(model))
    at = dict(zip(found.coordinate.values.tolist(), found.position.values.tolist(), strict=True))
    return np.array([at[f"rotor.{c}"] for c in ("x", "y", "z", "alpha", "beta")])


def test_an_elastic_housing_is_its_finite_elements(tmp_path):
    """Clamped beam of 8 elements with seats at two nodes, one by name, one nearest: statics and modes."""
    model = of_file(tmp_path, BEAM + BODY)
    assert model.bearings["left"].housing == "case.left"
    assert model.bearings["right"].housing == "case.far"
    frame = line()
    kept = np.arange(6, frame.size)
    K, M = (A.toarray()[np.ix_(kept, kept)] for A in (frame.K, frame.M))
    stiff, mass = whole(K, M, {-0.1: 6, 0.1: 30})  # nodes 2 and 6 at 100 and 300 mm; the foot is node 0
    np.testing.assert_allclose(rotor_of(model), displaced(stiff)[:5], rtol=2e-6, atol=1e-13)
    free = model.replace("loads.push.force", [0, 0, 0])
    modes = find_modes(compile_model(free), mean=False)
    inner = np.setdiff1d(np.arange(len(stiff)), [5])
    wanted = np.sqrt(eigh(stiff[np.ix_(inner, inner)], mass[np.ix_(inner, inner)], eigvals_only=True))
    np.testing.assert_allclose(modes.frequency[1:9], wanted[:8] / (2 * np.pi), rtol=2e-3)


def test_its_condensed_matrix_gives_the_same_deflections(tmp_path):
    """Static condensation to both seats, as other programs export it."""
    frame = line()
    K = frame.K.toarray()
    seats = np.concatenate([frame.displacements(2), frame.displacements(6)])
    inner = np.setdiff1d(np.arange(6, frame.size), seats)
    condensed = K[np.ix_(seats, seats)] - K[np.ix_(seats, inner)] @ np.linalg.solve(
        K[np.ix_(inner, inner)], K[np.ix_(inner, seats)]
    )
    np.savetxt(tmp_path / "K.csv", condensed, fmt="%.9e", delimiter=";")
    text = "housing: {type: stiffness_matrix, stiffness_file: K.csv, nodes: [left, right]}\n"
    by_matrix, by_body = (rotor_of(of_file(tmp_path, BEAM + part)) for part in (text, BODY))
    np.testing.assert_allclose(by_matrix, by_body, rtol=2e-6, atol=1e-13)
    free = np.concatenate([frame.displacements(n) for n in (0, 2, 6)])
    inner = np.setdiff1d(np.arange(frame.size), free)
    condensed = K[np.ix_(free, free)] - K[np.ix_(free, inner)] @ np.linalg.solve(
        K[np.ix_(inner, inner)], K[np.ix_(inner, free)]
    )
    np.savetxt(tmp_path / "K.csv", condensed, fmt="%.12e", delimiter=",")
    text = """\
housing:
  type: stiffness_matrix
  stiffness_file: K.csv
  nodes: [foot, left, right]
  feet: {foot: {position: [0, 0, 0]}}
"""
    np.testing.assert_allclose(rotor_of(of_file(tmp_path, BEAM + text)), by_body, rtol=2e-6, atol=1e-13)


# --- parts of the housing -----------------------------------------------------------------------------------
RING = """\
gears:
  sun: {number_of_teeth: 20, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  ring: {type: internal, number_of_teeth: 80, normal_module: 2 mm, face_width: 20 mm,
         profile_shift_coefficient: 0}
bodies:
  s: {gears: [sun], motion: free, position: [0, 0, 0], transverse_inertia: 1e-3}
  r: {gears: [ring], mass: 3 kg, inertia: 0.01, transverse_inertia: 0.01}
  c: {motion: free, mass: 2 kg, inertia: 0.01, transverse_inertia: 0.01}
planetary_stages:
  set:
    {sun: sun, ring: ring, carrier: c, planets: 4, motion: planar,
     planet: {number_of_teeth: 30, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0},
     bearing: {stiffness: {radial: 1e8 N/m}}}
bearings:
  front: {body: c, position: [0, 0, 50 mm], stiffness: {radial: 1e8, axial: 1e8, tilt: 1e5}}
  rear: {body: s, position: [0, 0, -50 mm], stiffness: {radial: 1e8, axial: 1e8, tilt: 1e5}}
loads:
  drive: {body: s, torque: 10 N m}
  brake: {body: c, torque: balance}
"""
SOFT = """\
housing: {type: stiffness_matrix, stiffness_file: K.csv, nodes: [front, rear, r], parts: [r]}
"""


def test_a_ring_gear_in_the_housing_twists_it(tmp_path):
    """The ring turns its node against the drive by T_s z_r/(z_s k); the bearings have nodes, too."""
    np.savetxt(tmp_path / "K.csv", np.diag([1e8, 1e8, 1e8, 1e6, 1e6, 2e5] * 3), delimiter=",")
    model = of_file(tmp_path, RING + SOFT)
    assert model.bearings["front"].housing == "housing-front"
    assert model.bearings["planet_1-bearing"].housing == "c"
    found = solve_equilibrium(compile_model(model))
    assert float(found["angle[housing-r]"]) == pytest.approx(-40.0 / 2e5, rel=1e-3)
    assert "r-housing" not in model.to_yaml()


def test_a_ring_gear_on_a_rigid_housing_twists_the_mounts():
    """Two mounts 200 mm apart in x: 40 N m turn the housing by T/(2 k a^2); on ground the ring is at rest."""
    rigid = """\
housing:
  type: rigid
  mass: 20 kg
  inertia_tensor: [1, 1, 1, 0, 0, 0]
  parts: [r]
  mounts:
    left: {position: [-0.1, 0, 0], stiffness: {radial: 1e7, axial: 1e7, tilt: 1e6}}
    right: {position: [0.1, 0, 0], stiffness: {radial: 1e7, axial: 1e7, tilt: 1e6}}
"""
    found = solve_equilibrium(compile_model(loads_model(RING + rigid)))
    assert float(found["angle[housing]"]) == pytest.approx(-40.0 / (2 * 1e7 * 0.01), rel=2e-3)
    at_rest = loads_model(RING + "housing: {type: rigid, parts: [r]}\n")
    assert at_rest.bearings["front"].housing is None
    assert at_rest.joints["r-housing"].bodies == ("ground", "r")


@pytest.mark.parametrize(
    ("text", "old", "new", "words"),
    [
        (RIGID, "  mounts:", "  feet:", "housing.feet (line 13): is an unknown key; did you mean mounts?"),
        (RIGID, "  mass: 12 kg\n", "", "have no effect on a housing that is ground"),
        (
            RIGID,
            RIGID[RIGID.index("  inertia_tensor") : RIGID.index("  mounts")],
            "",
            "a housing on mounts tilts",
        ),
        (RIGID, "bearings:", "  housing: {inertia: 1}\nbearings:", "needs the name housing"),
        (RIGID, "0.2, 0.3, 0.25", "0.2, 0.3, 0.9", "are not physically possible"),
        (
            BEAM + BODY,
            "body: case}",
            "body: cas}",
            "names the body 'cas', which does not exist; did you mean case?",
        ),
        (
            BEAM + BODY,
            "[0, 0, 300 mm]",
            "[0, 0, 290 mm]",
            "has no node of the housing case; the nearest, far, is 10 mm",
        ),
        (
            RING,
            "loads:",
            "housing: {type: rigid, parts: [rr]}\nloads:",
            "names the body 'rr', which does not exist",
        ),
        (
            RING.replace("  r: {gears", "  r: {motion: fixed, gears"),
            "loads:",
            "housing: {type: rigid, parts: [r]}\nloads:",
            "bodies.r.motion (line 7): fixed does not apply to r, which is fixed in the housing",
        ),
    ],
)
def test_wrong_housings_are_refused(tmp_path, text, old, new, words):
    assert old in text
    with pytest.raises(ModelError) as caught:
        of_file(tmp_path, text.replace(old, new, 1))
    assert words in str(caught.value)


def test_own_housings_are_kept():
    """A bearing with a housing of its own, ground included, is not in the housing of the model."""
    text = RIGID.replace("position: [0, 0, 120 mm], ", "position: [0, 0, 120 mm], housing: ground, ")
    model = loads_model(text)
    assert model.bearings["right"].housing == "ground"
    assert model.bearings["left"].housing == "housing"


# --- misalignment -------------------------------------------------------------------------------------------
PAIR = """\
gears:
  g1: {number_of_teeth: 20, normal_module: 4 mm, face_width: 14 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 30, normal_module: 4 mm, face_width: 14 mm, profile_shift_coefficient: 0}
bodies:
  a: {gears: [g1], motion: free, position: [0, 0, 0]}
  b: {gears: [g2], motion: free}
meshes:
  m: {gears: [g1, g2], direction: 0 deg, contact: {level: rigid, planes: 7}}
bearings:
  a1: {body: a, position: [0, 0, -50 mm], stiffness: {radial: 4e8, axial: 1e8}}
  a2: {body: a, position: [0, 0, 50 mm], stiffness: {radial: 4e8, axial: 1e8}}
  b1: {body: b, position: [0, 0, -50 mm], stiffness: {radial: 4e8, axial: 1e8}}
  b2: {body: b, position: [0, 0, 50 mm], stiffness: {radial: 4e8, axial: 1e8}}
loads:
  drive: {body: a, torque: 40 N m}
  brake: {body: b, torque: balance}
"""


def test_a_housing_of_unequal_seats_misaligns_the_mesh(tmp_path):
    """Shaft and seats tilt by (F_2/k_2 - F_1/k_1)/l with the forces of the bearings; k_2 = 3 k_1.

    The forces are unequal, because the tilted teeth shift their resultant from the middle of the face width.
    """
    seats, bearing, span = {"1": 1e8, "2": 3e8}, 4e8, 0.1
    rows = [[k, k, 1e8, 1e5, 1e5, 1e5] for k in seats.values()]
    np.savetxt(tmp_path / "K.csv", np.diag([*rows[0], *rows[1]] * 2), delimiter=",")
    housing = "housing: {type: stiffness_matrix, stiffness_file: K.csv, nodes: [a1, a2, b1, b2]}\n"
    mean = {}
    for name, text in (("ground", PAIR), ("housing", PAIR + housing)):
        model = of_file(tmp_path, text)
        data = solve_contacts_on_shafts(model, positions=4).meshes["m"]
        mean[name] = float(np.abs(data["misalignment"]).mean())
    found = solve_equilibrium(compile_model(model))
    tilts = []
    for body in "ab":
        force = {n: float(found[f"bearing_force[{body}{n}.radial]"]) for n in seats}
        ends = {n: force[n] * (1.0 / bearing + 1.0 / k) for n, k in seats.items()}
        tilts.append((ends["1"] - ends["2"]) / span)
    assert min(tilts) > 1e-5
    assert mean["ground"] < 1e-3 * sum(tilts)
    assert mean["housing"] == pytest.approx(sum(tilts), rel=0.01)


def test_nodes_of_a_matrix_have_one_frame_and_are_no_parts(tmp_path):
    """The scene shows one frame of the housing; masses and bodies of `check` are those of real parts."""
    text = "housing: {type: stiffness_matrix, stiffness_file: K.csv, nodes: [left, right]}\n"
    np.savetxt(tmp_path / "K.csv", np.diag([1e8, 1e8, 1e8, 1e5, 1e5, 1e5] * 2), delimiter=",")
    model = of_file(tmp_path, BEAM + text)
    names = [solid.name for solid in scene_of(model).solids]
    assert "housing (frame)" in names
    assert not [name for name in names if name.startswith("housing-")]
    assert [entry["name"] for entry in masses(model)] == ["rotor"]
    seats = gearbox_facts(model)["housing"]["seats"]
    assert seats["left"] == {"seat": "housing-left", "stiffness": pytest.approx([1e8] * 3)}
