# SPDX-License-Identifier: Apache-2.0
"""Mechanisms from model files: the same as assembled by hand, moved, turned round and reversed."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements.closure_rows import cut_joint, rod
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.multibody import joints
from pitchpoint.multibody.bodies import Body
from pitchpoint.solvers.constraints.assembly import assemble_state
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.rules.bodies import CODES, end_of
from pitchpoint.system.system import assemble
from tests.support.engine import frame
from tests.support.mechanism_files import (
    SLIDER_CRANK,
    accelerations,
    axes,
    centers,
    model_of,
    moved,
    random_chain,
    reversed_joints,
    system_of,
    vector,
)

R, L = 0.1, 0.3
TYPES = ("revolute", "prismatic", "cylindrical", "screw", "universal", "spherical", "planar", "shaft", "free")
TURNABLE = ("revolute", "prismatic", "cylindrical", "screw", "universal", "spherical")


# --- closed forms -------------------------------------------------------------------------------------------
def slider_crank(theta):
    """Places and slopes by the crank angle: rod angle, piston; first and second derivatives by the angle."""
    sine = -R * np.sin(theta) / L
    phi = np.arcsin(sine)  # of the rod in space
    c = np.cos(phi)
    d_phi = -R * np.cos(theta) / (L * c)
    dd_phi = (R * np.sin(theta) / L + np.sin(phi) * d_phi**2) / c
    x = R * np.cos(theta) + L * c
    d_x = -R * np.sin(theta) - L * np.sin(phi) * d_phi
    dd_x = -R * np.cos(theta) - L * (np.cos(phi) * d_phi**2 + np.sin(phi) * dd_phi)
    return (phi, x), (d_phi, d_x), (dd_phi, dd_x)


def crank_acceleration(theta, omega):
    """Acceleration of the free slider-crank by its reduced inertia: J a + J'/2 omega^2 = 0."""

    def reduced(theta):
        _, (d_phi, d_x), _ = slider_crank(theta)
        phi = slider_crank(theta)[0][0]
        along = np.array(
            [-R * np.sin(theta) - 0.12 * np.sin(phi) * d_phi, R * np.cos(theta) + 0.12 * np.cos(phi) * d_phi]
        )
        crank = 1.2e-3 + 1.0 * (0.04**2 + 0.005**2)
        return crank + 0.8 * along @ along + 8e-3 * d_phi**2 + 0.5 * d_x**2

    h = 1e-3
    slope = 8.0 * (reduced(theta + h) - reduced(theta - h)) - (
        reduced(theta + 2 * h) - reduced(theta - 2 * h)
    )
    return -0.5 * slope / (12.0 * h) * omega**2 / reduced(theta)


@pytest.mark.parametrize("theta", [0.4, 2.0, -2.5])
def test_a_slider_crank_accelerates_as_in_closed_form(theta):
    omega = 7.0
    text = SLIDER_CRANK.replace(
        "position: [0, 0, 0]}", f"position: [0, 0, 0], start: {{spin: {theta}}}, speed: {{spin: {omega}}}}}"
    )
    system = compile_model(loads_model(text))
    crank, rod_spin, piston = (system.layout.coordinate(c) for c in ("crank.spin", "rod.spin", "piston.z"))
    state = system.initial_state()
    assert state.q[crank] == pytest.approx(theta)
    (phi, x), (d_phi, d_x), (dd_phi, dd_x) = slider_crank(theta)
    state.q[[rod_spin, piston]] = phi - theta + 0.05, x - R - L + 0.01  # near the way of the two to close it
    found = assemble_state(system, state, keep=[crank], keep_rates=[crank])
    assert found.freedoms == 1
    np.testing.assert_allclose(found.state.q[[rod_spin, piston]], [phi - theta, x - R - L], atol=1e-13)
    np.testing.assert_allclose(
        found.state.v[[rod_spin, piston]], [(d_phi - 1.0) * omega, d_x * omega], atol=1e-12
    )
    a, _ = accelerations(system, found.state)
    # differences of fourth order in the closed form: 1e-11 of J''''' h^4
    alpha = crank_acceleration(theta, omega)
    assert a[crank] == pytest.approx(alpha, rel=1e-8)
    assert a[piston] == pytest.approx(d_x * alpha + dd_x * omega**2, rel=1e-8)
    assert a[rod_spin] == pytest.approx((d_phi - 1.0) * alpha + dd_phi * omega**2, rel=1e-8)


def test_a_slider_crank_is_the_one_assembled_by_hand():
    system = compile_model(loads_model(SLIDER_CRANK))
    turned = np.column_stack([(0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)])
    bodies = [
        Body(
            motion=joints.TORSION,
            mass=1.0,
            com=(0.04, 0.005, 0.0),
            inertia=np.diag([2e-4, 1.1e-3, 1.2e-3]),
            name="crank",
        ),
        Body(
            motion=joints.TORSION,
            parent=1,
            position=(0.1, 0.0, 0.0),
            mass=0.8,
            com=(0.12, 0.0, 0.0),
            inertia=np.diag([1e-4, 8e-3, 8e-3]),
            name="rod",
        ),
        Body(
            motion=joints.PRISMATIC,
            position=(0.4, 0.0, 0.0),
            axes=turned,
            mass=0.5,
            inertia=np.zeros((3, 3)),
            name="piston",
        ),
    ]
    rows, words = cut_joint(joints.TORSION, bodies, 3, 2, (0.4, 0.0, 0.0), np.eye(3))
    by_hand = assemble(bodies, {}, {"closure": rows})
    assert system.layout.coordinates == by_hand.layout.coordinates
    assert system.names["closure"] == tuple(f"piston_pin.{w}" for w in words)
    state = by_hand.initial_state()
    state.q[:], state.v[:], state.a[:] = (0.1, -0.2, 0.05), (1.0, 2.0, 3.0), (4.0, 5.0, 6.0)
    state.lam[:] = np.arange(5.0)
    np.testing.assert_allclose(
        evaluate.residual(system, state), evaluate.residual(by_hand, state), rtol=1e-14
    )
    np.testing.assert_allclose(system.workspace.g, by_hand.workspace.g, rtol=1e-14)


def test_a_four_bar_is_the_one_assembled_by_hand():
    lengths = (0.1, 0.4, 0.25)
    corners = np.array([[0.0, 0.0], [0.06, 0.08], [0.0, 0.0], [0.35, 0.0]])
    # the corner between coupler and rocker: circles about both its ends
    base, d = corners[1], corners[3] - corners[1]
    along = (lengths[1] ** 2 - lengths[2] ** 2 + d @ d) / (2.0 * np.sqrt(d @ d))
    up = np.sqrt(lengths[1] ** 2 - along**2)
    corners[2] = base + (along * d + up * np.array([-d[1], d[0]])) / np.sqrt(d @ d)
    starts, ends = (corners[0], corners[1], corners[3]), (corners[1], corners[2], corners[2])
    data = {"bodies": {}, "joints": {}}
    for name, length, p, q in zip(("crank", "coupler", "rocker"), lengths, starts, ends, strict=True):
        data["bodies"][name] = {
            "mass": length,
            "center_of_mass": [length / 2, 0.0, 0.0],
            "inertia_tensor": [0.0, length**3 / 12, length**3 / 12, 0.0, 0.0, 0.0],
            "axes": {"x": [*vector(q - p), 0.0]},
            "markers": {"end": {"position": [length, 0.0, 0.0]}},
        }
    for name, ends_of, place in (
        ("a", ["ground", "crank"], [0.0, 0.0, 0.0]),
        ("b", ["crank.end", "coupler"], None),
        ("d", ["ground", "rocker"], [0.35, 0.0, 0.0]),
        ("c", ["coupler.end", "rocker.end"], None),
    ):
        joint = {"type": "revolute", "bodies": ends_of, "axes": {"z": [0, 0, 1]}}
        data["joints"][name] = joint | ({"position": place} if place else {})
    model, system = system_of(data)
    assert model.mechanism.cut == ("c",)
    bodies = []
    for k, (length, p, q) in enumerate(zip(lengths, starts, ends, strict=True)):
        x = np.array([*(q - p) / length, 0.0])
        local = np.column_stack([x, np.cross((0.0, 0.0, 1.0), x), (0.0, 0.0, 1.0)])
        about = local @ np.diag([0.0, length**3 / 12, length**3 / 12]) @ local.T
        bodies.append(
            Body(
                parent=int(k == 1),
                position=(*p, 0.0),
                mass=length,
                com=0.5 * length * x,
                inertia=about,
                name=("crank", "coupler", "rocker")[k],
            )
        )
    rows, _ = cut_joint(joints.TORSION, bodies, 3, 2, (*corners[2], 0.0), np.eye(3))
    by_hand = assemble(bodies, {}, {"closure": rows})
    state = by_hand.initial_state()
    state.q[:], state.v[:] = (0.1, -0.05, 0.07), (1.0, 2.0, 3.0)
    one = assemble_state(by_hand, state, keep=[0], keep_rates=[0])
    two = assemble_state(system, state, keep=[0], keep_rates=[0])
    assert one.freedoms == two.freedoms == 1
    # the frames of the bodies differ by the directions of the bars at most: joints stand along the world
    np.testing.assert_allclose(two.state.q, one.state.q, atol=1e-14)
    np.testing.assert_allclose(two.state.v, one.state.v, rtol=1e-12)
    np.testing.assert_allclose(
        accelerations(system, two.state)[0], accelerations(by_hand, one.state)[0], rtol=1e-11
    )


def test_a_spatial_chain_is_the_one_assembled_by_hand():
    rng = np.random.default_rng(1)
    types = ("universal", "spherical", "cylindrical", "screw", "free", "planar")
    parents = (0, 1, 2, 2, 0, 4)
    data = random_chain(rng, types, parents)
    data["rods"] = {"link": {"ends": ["b3", "b5"]}}
    _, system = system_of(data)
    bodies = []
    for k, (word, parent) in enumerate(zip(types, parents, strict=True), start=1):
        body, joint = data["bodies"][f"b{k}"], data["joints"][f"j{k}"]
        E, A = (
            np.column_stack([(x := part["axes"])["x"], np.cross(x["z"], x["x"]), x["z"]])
            for part in (joint, body)
        )
        xx, yy, zz, xy, yz, zx = body["inertia_tensor"]
        about = np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]])
        place = np.array(body["position"]) + A @ body["center_of_mass"]
        bodies.append(
            Body(
                motion=CODES[word],
                parent=parent,
                position=joint["position"],
                axes=E,
                mass=body["mass"],
                com=E.T @ (place - joint["position"]),
                inertia=E.T @ A @ about @ A.T @ E,
                lead=0.3 / (2.0 * np.pi) if word == "screw" else 0.0,
                name=f"b{k}",
            )
        )
    places = [np.array(data["bodies"][n]["position"]) for n in ("b3", "b5")]
    by_hand = assemble(bodies, {}, {"closure": rod(bodies, 3, 5, *places)})
    state = by_hand.initial_state()
    n = by_hand.sizes["nd"]
    state.q, state.v, state.a = 0.4 * rng.normal(size=n), rng.normal(size=n), rng.normal(size=n)
    expected = evaluate.residual(by_hand, state)
    found = evaluate.residual(system, state)
    np.testing.assert_allclose(found, expected, atol=1e-13 * np.abs(expected).max())
    np.testing.assert_allclose(system.workspace.g, by_hand.workspace.g, atol=1e-14)


# --- invariance ---------------------------------------------------------------------------------------------
def looped(rng, word):
    """A tree of many joints whose last body is held to another by a joint of a type, at a marker of each."""
    data = random_chain(rng, ("free", "universal", "revolute", "shaft", "cylindrical"), (0, 1, 2, 0, 4))
    data["bodies"]["b3"]["markers"] = {
        "m": {"position": vector(rng.normal(size=3)), "axes": axes(frame(rng))}
    }
    data["joints"]["loop"] = {"type": word, "bodies": ["b3.m", "b5"]} | (
        {"lead": 0.3} if word == "screw" else {}
    )
    return data | {"gravity": vector(rng.normal(size=3))}


@pytest.mark.parametrize("word", [*(t for t in TYPES if t not in ("shaft", "free")), "fixed"])
def test_moving_and_turning_the_world_changes_no_acceleration(word):
    rng = np.random.default_rng(2)
    data = looped(rng, word)
    other = moved(data, rng.normal(size=3), frame(rng))
    found = []
    v = rng.normal(size=21)
    for case in (data, other):
        model, system = system_of(case)
        assert model.mechanism.cut == ("loop",)
        state = system.initial_state()
        state.v[:] = v[: state.v.size]
        state = assemble_state(system, state).state
        found.append((state.v, accelerations(system, state)[0]))
    for one, two in zip(*found, strict=True):
        np.testing.assert_allclose(two, one, rtol=1e-9, atol=1e-10 * np.abs(one).max())


@pytest.mark.parametrize("word", TURNABLE)
def test_a_joint_that_is_turned_round_moves_its_bodies_alike(word):
    """A joint that carries its first body instead of the second: start values keep their meaning."""
    rng = np.random.default_rng(3)
    data = random_chain(rng, ("free", word), (0, 1))
    model = model_of(data)
    values = {c: 0.3 * float(rng.normal()) for c in model.joints["j2"].names}
    data["joints"]["j2"] |= {"start": values, "speed": {c: float(rng.normal()) for c in values}}
    data["joints"]["j1"] |= {"speed": {"x": 1.0, "alpha": 2.0, "beta": -1.0, "spin": 0.5}}
    # with b2 on ground the joint carries b1, its first body
    free = {"type": "free", "bodies": ["ground", "b2"], "position": [0.0, 0.0, 0.0]}
    other = {**data, "joints": {**data["joints"], "j1": free}}
    found = []
    _, system = system_of(data)
    state = system.initial_state()
    _, frames = accelerations(system, state)
    found.append(centers(system, frames))
    body = frames[2]
    model, turned = system_of(other)
    assert model.mechanism.seats["b1"].turned
    state = turned.initial_state()
    first = list(model.mechanism.seats).index("b2")
    S = body["S"]
    reference = system.bodies[1]
    # frame of the joint of b2 in the other system: at the origin of b2, along the world
    seat = turned.bodies[first]
    shift = np.asarray(reference.axes).T @ (np.asarray(seat.position) - np.asarray(reference.position))
    dof = int(turned.program["body"][first + 1]["dof"])
    state.q[dof : dof + 3] = body["r"] + S @ shift - np.asarray(seat.position)
    state.charts[0] = S @ np.asarray(reference.axes).T
    w = body["tw"][3:]
    state.v[dof : dof + 3] = body["tw"][:3] + np.cross(w, S @ shift)
    state.v[dof + 3 : dof + 6] = state.charts[0].T @ w
    _, frames = accelerations(turned, state)
    found.append(centers(turned, frames))
    for name in ("b1", "b2"):
        np.testing.assert_allclose(found[1][name], found[0][name], rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("word", [t for t in TYPES if t != "free"])
def test_reversed_joints_to_ground_carry_the_same_bodies(word):
    rng = np.random.default_rng(4)
    data = random_chain(rng, (word, "revolute", "fixed"), (0, 1, 2))
    other = reversed_joints(data)
    one, two = (model_of(d) for d in (data, other))
    assert not any(s.turned for s in one.mechanism.seats.values())
    assert all(s.turned for s in two.mechanism.seats.values())
    assert {n: s.parent for n, s in one.mechanism.seats.items()} == {
        n: s.parent for n, s in two.mechanism.seats.items()
    }
    # in coordinates that are the same up to their signs and order the mass matrix has the same eigenvalues
    systems = [compile_model(m) for m in (one, two)]
    masses = [evaluate.linearize(s, s.initial_state())[0] for s in systems]
    found = [np.linalg.eigvalsh(M) for M in masses]
    np.testing.assert_allclose(found[1], found[0], rtol=1e-10)


@pytest.mark.parametrize("word", TYPES)
def test_reversed_joints_to_ground_fall_alike(word):
    """From rest, planes and shafts too: what a joint carries does not depend on how it is read."""
    rng = np.random.default_rng(7)
    data = random_chain(rng, (word, "revolute"), (0, 1)) | {"gravity": [1.0, 2.0, -9.0]}
    found = []
    for case in (data, reversed_joints(data)):
        _, system = system_of(case)
        _, frames = accelerations(system, system.initial_state())
        found.append(centers(system, frames))
    for name in ("b1", "b2"):
        np.testing.assert_allclose(found[1][name], found[0][name], rtol=1e-10, atol=1e-10)


def test_reversed_cut_joints_hold_the_same():
    rng = np.random.default_rng(5)
    # a plane and the first axis of a universal joint belong to one of the two bodies
    for word in ("revolute", "screw", "prismatic", "cylindrical", "spherical", "fixed"):
        data = looped(rng, word)
        other = {**data, "joints": {**data["joints"]}}
        other["joints"]["loop"] = {**data["joints"]["loop"], "bodies": ["b5", "b3.m"]}
        found = []
        v = rng.normal(size=21)
        for case in (data, other):
            _, system = system_of(case)
            state = system.initial_state()
            state.v[:] = v[: state.v.size]
            state = assemble_state(system, state).state
            found.append(accelerations(system, state)[0])
        np.testing.assert_allclose(found[1], found[0], rtol=1e-8, atol=1e-9 * np.abs(found[0]).max())


# --- places -------------------------------------------------------------------------------------------------
def test_places_on_bodies_are_where_the_file_has_them():
    rng = np.random.default_rng(6)
    data = random_chain(rng, ("universal", "spherical"), (0, 1))
    data["bodies"]["b2"]["markers"] = {
        "m": {"position": vector(rng.normal(size=3)), "axes": axes(frame(rng))}
    }
    data["rods"] = {"r": {"ends": ["ground", "b2.m"]}}
    model, system = system_of(data)
    number, point, local = end_of(model, "b2.m")
    body = system.bodies[number - 1]
    part = data["bodies"]["b2"]
    A = np.column_stack(
        [part["axes"]["x"], np.cross(part["axes"]["z"], part["axes"]["x"]), part["axes"]["z"]]
    )
    m = part["markers"]["m"]
    np.testing.assert_allclose(
        body.position + body.axes @ point, part["position"] + A @ m["position"], rtol=1e-13, atol=1e-13
    )
    np.testing.assert_allclose((body.axes @ local)[:, 2], A @ m["axes"]["z"], atol=1e-13)
    assert end_of(model, "ground")[0] == 0


def test_round_bodies_on_ground_keep_their_fast_kernels():
    text = """
bodies:
  rotor: {mass: 2, inertia: 0.3, transverse_inertia: 0.2, position: [0, 0, 0.5]}
  plate: {mass: 1, inertia_tensor: [0.1, 0.1, 0.2, 0, 0, 0], position: [1, 0, 0]}
joints:
  a: {type: shaft, bodies: [ground, rotor], position: [0, 0, 0.2]}
  b: {type: planar, bodies: [ground, plate]}
"""
    system = compile_model(loads_model(text))
    rotor, plate = system.bodies
    assert rotor.is_round and plate.is_round
    assert (rotor.center, rotor.polar_inertia, rotor.transverse_inertia) == pytest.approx((0.3, 0.3, 0.2))
    assert plate.polar_inertia == pytest.approx(0.2)


def test_start_values_count_whole_turns():
    text = SLIDER_CRANK.replace("position: [0, 0, 0]}", "position: [0, 0, 0], start: {spin: 725 deg}}")
    state = compile_model(loads_model(text)).initial_state()
    assert state.turns[1] == 2
    assert np.degrees(state.q[0]) == pytest.approx(5.0)


def test_a_mass_without_extent_hangs_from_a_joint():
    data = {
        "gravity": [0.0, 0.0, -9.81],
        "bodies": {"bob": {"mass": 2.0, "center_of_mass": [0.0, 0.0, -0.5]}},
        "joints": {
            "pivot": {
                "type": "revolute",
                "bodies": ["ground", "bob"],
                "axes": {"z": [1, 0, 0]},
                "position": [0, 0, 0],
            }
        },
    }
    _, system = system_of(data)
    state = system.initial_state()
    assert evaluate.linearize(system, state)[0][0, 0] == pytest.approx(0.5)
    state.q[0] = 0.4
    assert accelerations(system, state)[0][0] == pytest.approx(-9.81 / 0.5 * np.sin(0.4), rel=1e-13)


def test_gears_on_an_off_axis_body_give_their_inertia():
    gear = {
        "number_of_teeth": 30,
        "normal_module": 0.003,
        "face_width": 0.02,
        "profile_shift_coefficient": 0.0,
    }
    data = {
        "gears": {"g": gear},
        "bodies": {"b": {"gears": {"g": 0.1}, "center_of_mass": [0.01, 0.02, 0.03]}},
    }
    inertia = model_of(data).body_inertia("b")
    from pitchpoint.model.inertia import gear_inertia

    m, j_p, j_t = gear_inertia(model_of(data).gears["g"])
    d = np.array([0.01, 0.02, 0.03]) - [0.0, 0.0, 0.1]
    expected = np.diag([j_t, j_t, j_p]) + m * (d @ d * np.eye(3) - np.outer(d, d))
    np.testing.assert_allclose(inertia.about_center(), expected, rtol=1e-13)
