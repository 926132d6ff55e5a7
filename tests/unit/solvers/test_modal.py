# SPDX-License-Identifier: Apache-2.0
"""Modes: closed forms of small machines, names, multiple roots, operating points."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import OK
from pitchpoint.solvers.campbell_dataset import solve_campbell
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.modal import find_modes, linearise, solve_modal
from tests.support.engine import differences
from tests.support.machines import R_B1, chain, compiled, pair

REDUCED = 1.0 / (R_B1**2 / 0.002 + (1.5 * R_B1) ** 2 / 0.01)
"""Mass of the pair of `machines.pair` on its line of action [kg]."""
FOURIER = "{law: fourier, mean: 4.0e8 N/m, cosine: [-0.2, -0.1]}"


def hertz(k):
    return math.sqrt(k / REDUCED) / (2.0 * math.pi)


@pytest.fixture(scope="module")
def torsional():
    return compiled(pair(FOURIER))[1]


def test_mean_over_the_mesh_cycle_is_exact(torsional):
    modes = find_modes(torsional)
    assert modes.frequency[0] == 0.0
    assert modes.frequency[1] == pytest.approx(hertz(4e8), rel=1e-9)
    assert modes.names == ("rigid rotation", "mesh mode of stage")


@pytest.mark.parametrize("phase", [0.0, 0.25, 0.5, 0.9])
def test_stiffness_at_a_phase(torsional, phase):
    ratio = 1.0 - 0.2 * math.cos(2 * math.pi * phase) - 0.1 * math.cos(4 * math.pi * phase)
    assert find_modes(torsional, phase=phase).frequency[1] == pytest.approx(hertz(4e8 * ratio), rel=1e-7)


@pytest.mark.parametrize(
    ("law", "mean"),
    [
        ("{law: rectangular, high: 3.0e8 N/m, low: 2.0e8 N/m, duty: 0.3}", 2.3e8),
        ("{law: constant, value: 3.0e8 N/m}", 3e8),
    ],
)
def test_other_waves(law, mean):
    assert find_modes(compiled(pair(law))[1]).frequency[1] == pytest.approx(hertz(mean), rel=1e-9)


@pytest.mark.parametrize("beta", ["", "17 deg"])
def test_mean_of_the_parabola_is_that_of_the_mesh_cycle(beta):
    from pitchpoint.contact.mesh_cycle import mesh_cycle

    model, system = compiled(pair("{law: din3990, stiffness_ratio: 0.7, tip_relief_factor: 0.4}", beta=beta))
    geometry = model.pairs["stage"]
    record = system.records["gear_mesh"][0]
    cycle = mesh_cycle(geometry.eps_alpha_form, geometry.eps_beta, 0.7, 0.4)
    k = cycle.mean * record["c_prime"] * geometry.b_w
    inverse = record["r_b1"] ** 2 / 0.002 + record["r_b2"] ** 2 / 0.01
    assert find_modes(system).frequency[1] == pytest.approx(math.sqrt(k * inverse) / (2 * math.pi), rel=1e-9)


@pytest.mark.parametrize("backlash", ["0.1 mm", "0 mm"])
def test_without_load_the_front_flank_is_taken_as_touching(backlash):
    """Without backlash too: at rest only one flank can carry, whichever way the gears move."""
    text = pair(FOURIER).partition("loads:")[0].replace("0.1 mm", backlash)
    modes = find_modes(compiled(text)[1])
    assert "stage" in modes.notes[0]
    assert modes.frequency[1] == pytest.approx(hertz(4e8), rel=1e-6)


def test_damping_ratio_of_a_damped_disc_on_a_spring():
    text = (
        "bodies:\n  disc: {motion: torsion, inertia: 2.0}\n"
        "bearings:\n  spring: {body: disc, stiffness: {torsion: 800}, damping: {torsion: 4}}\n"
    )
    modes = find_modes(compiled(text)[1])
    assert modes.frequency[0] == pytest.approx(20.0 / (2 * math.pi), rel=1e-14)
    assert modes.damping_ratio[0] == pytest.approx(0.05, rel=1e-12)
    assert modes.eigenvalue[0] == pytest.approx(complex(-1.0, math.sqrt(399.0)), rel=1e-12)
    assert modes.names == ("torsion of disc against ground",)
    assert modes.shape[0, 0] == pytest.approx(1.0 / math.sqrt(2.0), rel=1e-14)


def test_an_overdamped_mode_has_the_ratio_of_a_real_eigenvalue():
    text = (
        "bodies:\n  disc: {motion: torsion, inertia: 2.0}\n"
        "bearings:\n  spring: {body: disc, stiffness: {torsion: 800}, damping: {torsion: 400}}\n"
    )
    modes = find_modes(compiled(text)[1])
    assert modes.damped_frequency[0] == 0.0
    assert modes.damping_ratio[0] == 1.0
    assert modes.eigenvalue[0].real == pytest.approx(-100.0 + math.sqrt(9600.0), rel=1e-9)


def test_multiple_roots_are_settled_and_reproducible():
    text = (
        "bodies:\n  disc: {motion: planar, inertia: 0.1, mass: 4}\n"
        "bearings:\n  support: {body: disc, stiffness: {radial: 4e6 N/m, torsion: 1e3}}\n"
    )
    system = compiled(text)[1]
    one, two = find_modes(system), find_modes(system)
    assert one.shape.tobytes() == two.shape.tobytes()
    double = [k for k, f in enumerate(one.frequency) if abs(f - 1000.0 / (2 * math.pi)) < 1e-9]
    assert len(double) == 2
    assert np.abs(one.shape[double]).max(axis=1) == pytest.approx([0.5, 0.5], rel=1e-12)
    assert one.names[double[0]] == "translation of disc (x)"
    assert one.names[double[1]] == "translation of disc (y)"


def test_several_free_groups_have_a_zero_each():
    text = chain([1.0, 2.0], [50.0]).replace(
        "coupl", "  lone: {motion: torsion, inertia: 3, position: [0, 1, 0]}\ncoupl"
    )
    modes = find_modes(compiled(text)[1])
    assert list(modes.frequency[:2]) == [0.0, 0.0]
    assert sorted(modes.names[:2]) == ["rigid rotation of b2, b1", "rigid rotation of lone"]


def test_shapes_are_mass_normalised_and_energies_complete(torsional):
    modes = find_modes(torsional)
    M = np.diag([0.002, 0.01])
    assert modes.shape @ M @ modes.shape.T == pytest.approx(np.eye(2), abs=1e-12)
    assert modes.kinetic.sum(axis=1) == pytest.approx([1.0, 1.0], rel=1e-12)
    assert modes.potential[1].sum() == pytest.approx(1.0, rel=1e-12)


def test_a_driven_spin_does_not_vibrate():
    text = pair(FOURIER, rest="scenarios:\n  turn: {drive: {driver: {speed: 100 rpm}}, duration: 1 s}\n")
    modes = find_modes(compiled(text, "turn")[1])
    assert len(modes.frequency) == 1
    assert modes.frequency[0] == pytest.approx(
        math.sqrt(4e8 * (1.5 * R_B1) ** 2 / 0.01) / (2 * math.pi), rel=1e-9
    )


def test_dataset(torsional):
    data = solve_modal(torsional)
    assert data["frequency"].dims == ("mode",)
    assert data["frequency"].attrs["units"] == "Hz"
    assert data["shape"].dims == ("mode", "coordinate")
    assert data["name"].values[1] == "mesh mode of stage"
    assert data.attrs["status"] == 1


def test_unknown_scenario_is_named(torsional):
    with pytest.raises(SolverError, match="no scenario 'x'"):
        find_modes(torsional, "x")


def test_gyroscopic_split_of_a_tilting_disc():
    """Forward and backward precession of a disc on two equal tilt springs, the body frame does not spin.

    I_t a'' + I_p W b' + k a = 0, I_t b'' - I_p W a' + k b = 0:
    w = +-g/2 + sqrt(g^2/4 + k/I_t), g = I_p W/I_t.
    """
    text = (
        "bodies:\n  disc: {motion: free, inertia: 0.02, transverse_inertia: 0.012, mass: 3}\n"
        "bearings:\n  support: {body: disc, stiffness: "
        "{radial: 1e8 N/m, axial: 1e8 N/m, tilt: 1e4, torsion: 1}}\n"
    )
    system = compiled(text)[1]
    speeds = np.array([0.0, 100.0, 400.0])
    data = solve_campbell(system, speeds, "disc")
    g = 0.02 * speeds / 0.012
    root = np.sqrt(0.25 * g**2 + 1e4 / 0.012)
    tilts = [k for k, name in enumerate(data["name"].values) if "tilt" in name]
    found = np.sort(data["frequency"].values[:, tilts], axis=1) * 2 * math.pi
    assert found == pytest.approx(np.column_stack([root - 0.5 * g, root + 0.5 * g]), rel=1e-9)
    steps = np.abs(np.diff(data["frequency"].values, axis=0))
    assert steps.max() < 100.0  # modes are followed, not re-sorted


def free_pair(damping: str, rest: str):
    """Helical pair with all twelve freedoms at 6000 rpm, mesh and bearings damped."""
    stiffness = "{radial: 1e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}"
    bearings = "".join(
        f"  on_{b}: {{body: {b}, stiffness: {stiffness}{damping}}}\n" for b in ("driver", "driven")
    )
    rest = f"bearings:\n{bearings}{rest}scenarios:\n  go: {{speed: {{driver: 6000 rpm}}, duration: 1 ms}}\n"
    return pair("{law: constant, value: 3e8 N/m}", beta="17 deg", motion="free", rest=rest)


def test_modal_damping_gives_all_modes_their_ratio():
    """Up to what the torques feed in and take out where they follow the tilting gears (200 N m: 0.4 %)."""
    modes = find_modes(compiled(free_pair("", "damping: {modal: 0.02}\n"), "go")[1])
    assert modes.damping_ratio[0] == 0.0
    assert modes.damping_ratio[1:] == pytest.approx(np.full(11, 0.02), rel=5e-3)


@pytest.mark.parametrize("mode", [1, 7, 8, 10])
def test_a_run_vibrates_and_decays_as_the_damped_modes_say(mode):
    """A little of one mode on top of the steady rotation, after several periods; both are nonlinear runs."""
    text = free_pair(", damping: {ratio: 0.03}", "").replace("backlash:", "damping: {ratio: 0.05}, backlash:")
    model, system = compiled(text, "go")
    modes = find_modes(system)
    begin = prepare_start(system, model.scenarios["go"])
    z, root = modes.damped_shape[mode], modes.eigenvalue[mode]
    small = 1e-7 / np.abs(z * system.weight).max()
    t, ends = 2e-3, []
    for share in (0.0, small):
        state = begin.state.copy()
        state.q += share * z.real
        state.v += share * (root * z).real
        run = generalized_alpha.start(begin.system, state, 1e-6, rho_inf=1.0)
        assert run.advance(round(t / 1e-6)).status == OK
        ends.append(run.state().v)
    expected = small * (root * z * np.exp(root * t)).real
    left = np.linalg.norm((ends[1] - ends[0] - expected) * system.weight)
    assert left < 0.02 * np.linalg.norm(expected * system.weight)


def test_a_campbell_diagram_of_a_machine_whose_spins_are_all_driven_has_no_modes():
    rest = "scenarios:\n  turn: {drive: {driver: {speed: 150}, driven: {speed: -100}}, duration: 1 ms}\n"
    system = compiled(pair(FOURIER, rest=rest), "turn")[1]
    assert solve_campbell(system, np.linspace(0.0, 100.0, 3), "driver")["frequency"].size == 0


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_the_least_load_says_which_flank_touches(side):
    """Two helical stages on soft bearings: frequencies depend on the flank, whatever presses it lightly."""
    gears, bodies, bearings = "gears:\n", "bodies:\n", "bearings:\n"
    for name, z, hand in (("a", 20, "right"), ("b", 45, "left"), ("c", 17, "right"), ("d", 51, "left")):
        gears += f"  {name}: {{number_of_teeth: {z}, normal_module: 3 mm, face_width: 20 mm, "
        gears += f"profile_shift_coefficient: 0, helix_angle: 20 deg, hand: {hand}}}\n"
    for name, on in (("one", "{a: 0 mm}"), ("two", "{b: 0 mm, c: 60 mm}"), ("three", "{d: 60 mm}")):
        bodies += f"  {name}: {{gears: {on}, motion: free}}\n"
        bearings += f"  at_{name}: {{body: {name}, stiffness: {{radial: 4e7 N/m, axial: 2e7 N/m, "
        bearings += "tilt: 4e7 N m/rad}}\n"  # flanks touch over their whole width
    stages = "meshes:\n"
    for name, pair_of, angle in (("first", "a, b", 0), ("second", "c, d", 70)):
        stages += f"  {name}: {{gears: [{pair_of}], direction: {angle} deg, "
        stages += "backlash: {normal: 0.1 mm}, stiffness: {law: constant, value: 3e8 N/m}}\n"
    loads = "loads:\n  in: {body: one, torque: TORQUE}\n  out: {body: three, torque: balance}\n"
    text = gears + bodies + bearings + stages + loads
    found = [
        find_modes(compiled(text.replace("TORQUE", f"{side * torque}"))[1]).frequency
        for torque in (0.002, 0.05)
    ]
    assert found[0] == pytest.approx(found[1], rel=1e-5, abs=1e-3)


DAMPED = "stiffness: {radial: 2e6, axial: 1e6, tilt: 1e4}, damping: {radial: 200, axial: 10, tilt: 0.5}"


@pytest.mark.parametrize("z", [0.0, 0.1])
def test_a_coupling_to_a_fixed_body_damps_like_a_bearing(z):
    """At 1500 rad/s the dampers of both stand still: whirl is damped by 1.83 %, forward and backward."""
    bodies = (
        "bodies:\n"
        "  a: {motion: free, mass: 3, inertia: 0.01, transverse_inertia: 0.013, position: [0, 0, 0]}\n"
        "  post: {motion: fixed, position: [0, 0, 0]}\n"
    )
    run = "scenarios:\n  s: {speed: {a: 1500}, duration: 1}\n"
    found = []
    for part in (f"bearings:\n  b: {{body: a, position: [0, 0, {z}], {DAMPED}}}\n", None):
        part = part or f"couplings:\n  b: {{bodies: [a, post], position: [0, 0, {z}], {DAMPED}}}\n"
        found.append(find_modes(compiled(bodies + part + run, "s")[1]))
    bearing, coupling = found
    assert coupling.damping_ratio == pytest.approx(bearing.damping_ratio, rel=1e-6)
    assert coupling.damped_frequency == pytest.approx(bearing.damped_frequency, rel=1e-9)
    if z == 0.0:
        assert np.sum(np.abs(bearing.damping_ratio - 0.01832) < 1e-5) == 2


SPEED, Z_C, Z_B, D_C = 1500.0, 0.15, 0.3, 200.0
TWO_ROTORS = f"""bodies:
  a: {{motion: free, mass: 3, inertia: 0.004, transverse_inertia: 0.013, position: [0, 0, 0]}}
  b: {{motion: free, mass: 2, inertia: 0.003, transverse_inertia: 0.008, position: [0, 0, {Z_B}]}}
bearings:
  a1: {{body: a, position: [0, 0, -0.1], stiffness: {{radial: 2e6, axial: 1e6}}, damping: {{radial: 20}}}}
  a2: {{body: a, position: [0, 0, 0.1], stiffness: {{radial: 2e6}}, damping: {{radial: 20}}}}
  b1: {{body: b, position: [0, 0, 0.1], stiffness: {{radial: 2e6}}, damping: {{radial: 20}}}}
couplings:
  c:
    bodies: [a, b]
    position: [0, 0, {Z_C}]
    stiffness: {{radial: 1e6, axial: 1e6, tilt: 1e3, torsion: 1e4}}
    damping: {{radial: {D_C}}}
scenarios:
  s: {{speed: {{a: {SPEED}}}, duration: 0.1}}
"""


def whirl_roots(speed=SPEED):
    """Roots of the lateral motion of `TWO_ROTORS` by hand, in w = x + i y and the tilt t = t_y - i t_x.

    A marker at height h moves by w + h t; the axis of a rotor turns t, its moment I_t t'' - i I_p W t'. The
    damper of the coupling spins: to it the difference d of the markers is d exp(-i W t), its rate d' - i W d.
    """
    height = {"a1": (-0.1, None), "a2": (0.1, None), "b1": (None, 0.1), "c": (Z_C, Z_C - Z_B)}
    M = np.diag([3.0, 0.013, 2.0, 0.008]).astype(complex)
    D = np.diag([0.0, -0.004j * speed, 0.0, -0.003j * speed])
    K = np.zeros((4, 4), complex)
    for name, (on_a, on_b) in height.items():
        k, d = (1e6, D_C) if name == "c" else (2e6, 20.0)
        row = np.array([*((0.0, 0.0) if on_a is None else (1.0, on_a))] * 2)
        row[2:] = (0.0, 0.0) if on_b is None else (1.0, on_b)
        row[2:] *= -1.0 if name == "c" else 1.0
        K += (k - (1j * speed * d if name == "c" else 0.0)) * np.outer(row, row)
        D = D + d * np.outer(row, row)
    tilt = np.array([0.0, 1.0, 0.0, -1.0])
    K += 1e3 * np.outer(tilt, tilt)
    A = np.block([[np.zeros((4, 4)), np.eye(4)], [-np.linalg.solve(M, K), -np.linalg.solve(M, D)]])
    return np.linalg.eigvals(A)


def test_a_spinning_damper_between_two_rotors_drives_their_whirl():
    """Above its critical speed internal damping is unstable: +6.71 1/s, and a run grows like that."""
    modes = find_modes(compiled(TWO_ROTORS, "s")[1])
    worst = int(np.argmax(modes.eigenvalue.real))
    roots = whirl_roots()
    least = roots[np.argmax(roots.real)]
    assert least.real == pytest.approx(6.714, abs=2e-3)
    assert modes.eigenvalue[worst].real == pytest.approx(least.real, rel=1e-6)
    assert modes.eigenvalue[worst].imag == pytest.approx(abs(least.imag), rel=1e-9)


def difference_roots(system, state):
    """Eigenvalues with Im > 0 of the residual differentiated by central differences."""
    M, D, K = (differences(system, state, key, step) for key, step in (("a", 1.0), ("v", 1e-3), ("q", 1e-7)))
    n = len(M)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, K), -np.linalg.solve(M, D)]])
    values = np.linalg.eigvals(A)
    values = values[values.imag > 10.0]
    return values[np.argsort(values.imag)]


NARROW = "g2: {number_of_teeth: 45, normal_module: 3 mm, face_width: 18 mm"
"""The narrower gear keeps the whole width: no width that changes with an axial shift."""


def test_torques_that_follow_the_axes_drive_undamped_tilts():
    """Helical gears on bearings without damping, 400 N m: modes know what a follower torque feeds in."""
    text = pair(
        "{law: constant, value: 6e8}, damper: {ratio: 0.1}",
        beta="15 deg",
        motion="free",
        torque="400 N m",
        rest="bearings:\n"
        + "".join(
            f"  {b}{z:+}: {{body: {b}, position: [0, 0, {z} mm], stiffness: {{radial: 1e8{more}}}}}\n"
            for b in ("driver", "driven")
            for z, more in ((60, ", axial: 5e7"), (-60, ""))
        )
        + "scenarios:\n  s: {speed: {driver: 15000 rpm}, duration: 1}\n",
    )
    text = text.replace("g2: {number_of_teeth: 45, normal_module: 3 mm, face_width: 20 mm", NARROW)
    system = compiled(text, "s")[1]
    found = find_modes(system).eigenvalue
    found = found[found.imag > 10.0]
    found = found[np.argsort(found.imag)]
    linear = linearise(system, "s", mean=False)
    expected = difference_roots(linear.system, linear.state)
    assert expected.real.max() > 0.3
    assert found.real == pytest.approx(expected.real, rel=1e-4, abs=1e-3)
    assert found.imag == pytest.approx(expected.imag, rel=1e-6)
    follow = solve_campbell(system, [linear.state.v[system.spin("driver")]], "driver", "s")
    assert np.nanmin(follow["damping_ratio"].values) < 0.0


def test_drag_of_a_turning_machine_loads_its_flanks():
    """Teeth by Hertz get stiffer under load: k = 1.5 K^(2/3) F^(1/3) over the cycle, with the drag in F."""
    from pitchpoint.contact.mesh_cycle import mesh_cycle

    text = pair(
        "{law: hertz, force: 10 kN, depth: 30 um}",
        beta="15 deg",
        torque="60 N m",
        rest="bearings: {b: {body: driver, damping: {torsion: 1}}}\n"
        "scenarios: {s: {speed: {driver: -100 rad/s}, duration: 1}}\n",
    )
    model, system = compiled(text, "s")
    stage = model.pairs["stage"]
    radii = [0.5 * gear.d_b for gear in (stage.gear1, stage.gear2)]
    cos_b = math.cos(stage.gear1.beta_b)
    lines = mesh_cycle(stage.eps_alpha, stage.eps_beta, 1.0, 0.0, 4001).stiffness_ratio[:-1]
    K = 1e4 / 30e-6**1.5 * cos_b**2.5 * np.mean(lines ** (2.0 / 3.0)) ** 1.5
    reduced = 1.0 / (radii[0] ** 2 / 0.002 + radii[1] ** 2 / 0.01)
    for scenario, torque in (("s", 160.0), (None, 60.0)):
        k = 1.5 * K ** (2.0 / 3.0) * (torque / radii[0]) ** (1.0 / 3.0)
        expected = math.sqrt(k / reduced) / (2.0 * math.pi)
        found = find_modes(system if scenario else compiled(text)[1], scenario)
        assert found.frequency[1] == pytest.approx(expected, rel=1e-6)


def test_a_model_of_fixed_bodies_has_no_modes():
    text = "bodies:\n  a: {motion: fixed, position: [0, 0, 0]}\n"
    with pytest.raises(SolverError, match="all bodies are fixed, so there are no modes; free a body"):
        find_modes(compiled(text)[1])
