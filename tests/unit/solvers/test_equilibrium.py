# SPDX-License-Identifier: Apache-2.0
"""Static equilibrium of gear trains: the torques of every stage follow from the ratios alone."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import listening
from pitchpoint.core.status import SINGULAR
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium import solve
from pitchpoint.solvers.equilibrium.solve import find_equilibrium, solve_equilibrium
from pitchpoint.solvers.equilibrium.unknowns import extents
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.machines import R_B1, compiled, pair
from tests.support.mechanism_files import model_of

STAGES = ((20, 80), (17, 51), (25, 40))
INERTIAS = (
    (2e-3, 2e-3, 2e-3, 2e-3),
    (1e-4, 3e-2, 5e-4, 8e-2),
    (5e-2, 1e-4, 3e-2, 2e-4),
)
FULL = "{radial: 1e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}"
NO_AXIAL = "{radial: 1e8 N/m, tilt: 1e6 N m/rad}"
LAWS = (
    "{law: constant, value: 3e8 N/m}",
    "{law: rectangular, high: 3e8 N/m, low: 2e8 N/m, duty: 0.3}",
    "{law: din3990, stiffness_ratio: 0.8, tip_relief_factor: 0}",
)


def train(inertias: tuple[float, ...], law: str, backlash: float, torque: float) -> str:
    """Three spur stages in a row, module 3 mm, the last body balances."""
    gears, meshes = "gears:\n", "meshes:\n"
    for k, (z1, z2) in enumerate(STAGES):
        for name, z in ((f"p{k}", z1), (f"w{k}", z2)):
            gears += f"  {name}: {{number_of_teeth: {z}, normal_module: 3 mm, face_width: 20 mm, "
            gears += "profile_shift_coefficient: 0}\n"
        meshes += f"  m{k}: {{gears: [p{k}, w{k}], direction: {70 * k} deg, stiffness: {law}, "
        meshes += f"backlash: {{base_tangent: {backlash} mm}}}}\n"
    bodies = "bodies:\n"
    for k, inertia in enumerate(inertias):
        on = [f"w{k - 1}"] * (k > 0) + [f"p{k}"] * (k < len(STAGES))
        bodies += f"  b{k}: {{gears: [{', '.join(on)}], motion: torsion, inertia: {inertia}}}\n"
    loads = f"loads:\n  in: {{body: b0, torque: {torque}}}\n  out: {{body: b3, torque: balance}}\n"
    return gears + bodies + meshes + loads


@pytest.mark.parametrize("inertias", INERTIAS)
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize(("backlash", "torque"), [(0.0, 20.0), (0.1, -3.0), (0.5, 150.0)])
def test_trains_come_to_rest(inertias, law, backlash, torque):
    found = solve_equilibrium(compiled(train(inertias, law, backlash, torque))[1])
    expected = torque
    for k, (z1, z2) in enumerate(STAGES):
        r_b1 = 0.5 * 0.003 * z1 * math.cos(math.radians(20.0))
        assert float(found[f"mesh_force[m{k}]"]) == pytest.approx(expected / r_b1, rel=1e-6)
        expected *= -z2 / z1
    assert float(found["torque[out]"]) == pytest.approx(-expected, rel=1e-6)


JUMPING = ("{law: rectangular, high: 3e8 N/m, low: 1e8 N/m, duty: 0.3}", LAWS[2])


@pytest.mark.parametrize("law", JUMPING)
def test_a_pinion_rests_at_a_jump_of_the_stiffness(law):
    """As a pair enters or leaves the load may lie between the forces of both sides; their mean acts."""
    system = compiled(pair(law, torque="800 N m"))[1]
    driver, driven = (system.spin(name) for name in ("driver", "driven"))
    force = system.layout.channel("mesh_force[stage]")
    pairs = [k for k, c in enumerate(system.layout.channels) if c.name.startswith("pair_force[stage.")]
    resting = 0
    for share in np.linspace(0.0, 1.0, 800):  # of a pitch
        start = system.initial_state()
        start.q[driven] = share * 2.0 * math.pi / 45
        start.q[driver] = -1.5 * start.q[driven]
        found = find_equilibrium(system, start, (driven,))
        row = found.observe(system)
        assert found.reaction[0] == pytest.approx(1200.0, rel=1e-6)
        assert row[force] == pytest.approx(800.0 / R_B1, rel=1e-6)
        if pairs:
            assert row[pairs].sum() == pytest.approx(row[force], rel=1e-9)
            assert row[pairs].min() >= 0.0
        resting += len(found.share)
        assert all(0.0 <= part <= 1.0 for part in found.share)
        rows = np.array([evaluate.observe(system, side) for side in (found.state, *found.other_sides)])
        for column in (force, *pairs):  # each pair has its own, also where a new one enters
            low, high = rows[:, column].min(), rows[:, column].max()
            assert low * (1.0 - 1e-6) <= row[column] <= high * (1.0 + 1e-6)
    assert resting > 0


@pytest.mark.parametrize("motion", ["torsion", "planar"])
@pytest.mark.parametrize("law", JUMPING)
def test_trains_rest_at_any_phase(motion, law):
    """Some stages are at a jump while the others are still on their way."""
    text = train(INERTIAS[0], law, 0.1, 200.0)
    if motion == "planar":
        text = text.replace("motion: torsion,", "motion: planar, mass: 2,") + "bearings:\n"
        text += "".join(f"  s{k}: {{body: b{k}, stiffness: {{radial: 1e9 N/m}}}}\n" for k in range(4))
    system = compiled(text)[1]
    spins = [system.spin(f"b{k}") for k in range(4)]
    forces = [system.layout.channel(f"mesh_force[m{k}]") for k in range(3)]
    expected, torque = [], 200.0
    for z1, z2 in STAGES:
        expected.append(torque / (0.5 * 0.003 * z1 * math.cos(math.radians(20.0))))
        torque *= -z2 / z1
    resting = 0
    for angle in np.linspace(0.0, 0.25, 100):
        start = system.initial_state()
        for spin, ratio in zip(spins, (-19.2, 4.8, -1.6, 1.0), strict=True):
            start.q[spin] = ratio * angle
        found = find_equilibrium(system, start, (spins[3],))
        assert found.reaction[0] == pytest.approx(-torque, rel=1e-6)
        if motion == "torsion":  # a wheel that yields changes its radius and its pressure angle
            assert found.observe(system)[forces] == pytest.approx(expected, rel=1e-6)
        resting += len(found.share)
    assert resting > 0


@pytest.mark.parametrize("motion", ["torsion", "planar"])
@pytest.mark.parametrize("law", JUMPING)
def test_equal_meshes_between_the_same_bodies_jump_together(motion, law):
    """Two pairs side by side: one surface, over which both forces change by one share."""
    size = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    gears = "".join(
        f"  {n}: {{number_of_teeth: {z}, {size}}}\n" for n, z in (("a", 26), ("b", 28), ("c", 26), ("d", 28))
    )
    text = (
        f"gears:\n{gears}bodies:\n  A: {{gears: {{a: 0 mm, c: 30 mm}}, motion: {motion}}}\n"
        f"  B: {{gears: {{b: 0 mm, d: 30 mm}}, motion: {motion}}}\nmeshes:\n"
    )
    for n, pair_of in enumerate(("a, b", "c, d")):
        text += f"  m{n}: {{gears: [{pair_of}], direction: 30 deg, stiffness: {law}}}\n"
    if motion == "planar":
        text += "bearings:\n  sa: {body: A, stiffness: {radial: 3e9 N/m}}\n"
        text += "  sb: {body: B, stiffness: {radial: 3e9 N/m}}\n"
    text += "loads:\n  i: {body: A, torque: 900 N m}\n  o: {body: B, torque: balance}\n"
    system = compiled(text)[1]
    forces = [system.layout.channel(f"mesh_force[m{n}]") for n in range(2)]
    resting = 0
    for phase in np.linspace(0.0, 1.0, 400):
        start = system.initial_state()
        start.q[system.spin("B")] = -phase * 2.0 * math.pi / 28
        start.q[system.spin("A")] = phase * 2.0 * math.pi / 26
        found = find_equilibrium(system, start, (system.spin("B"),))
        assert found.reaction[0] == pytest.approx(900.0 * 28 / 26, rel=1e-6)
        row = found.observe(system)
        assert row[forces[0]] == pytest.approx(row[forces[1]], rel=1e-9)
        resting += len(found.share)
        assert len(found.share) <= 1
        rows = np.array(
            [evaluate.observe(system, side)[forces].sum() for side in (found.state, *found.other_sides)]
        )
        assert rows.min() * (1.0 - 1e-6) <= row[forces].sum() <= rows.max() * (1.0 + 1e-6)
    assert resting > 0


@pytest.mark.parametrize("torque", [50.0, 500.0, 900.0])
@pytest.mark.parametrize("slices", [5, 11])
def test_helical_trains_in_slices_roll_through(torque, slices):
    """Every slice enters and leaves with a jump, in two meshes at once; the torque goes through."""
    helix = ", helix_angle: 8 deg, hand: "
    gears = "".join(
        f"  {n}: {{number_of_teeth: {z}, normal_module: 3 mm, face_width: 20 mm, "
        f"profile_shift_coefficient: 0{helix}{hand}}}\n"
        for n, z, hand in (("a", 20, "right"), ("b", 27, "left"), ("c", 33, "right"))
    )
    mesh = f"width: slices, slices: {slices}, backlash: {{base_tangent: 0.05 mm}}"
    text = (
        f"gears:\n{gears}bodies: {{A: {{gears: [a]}}, B: {{gears: [b]}}, C: {{gears: [c]}}}}\n"
        f"meshes:\n  m0: {{gears: [a, b], {mesh}}}\n  m1: {{gears: [b, c], {mesh}}}\n"
        f"loads: {{i: {{body: A, torque: {torque} N m}}, o: {{body: C, torque: balance}}}}\n"
        "scenarios:\n  roll: {quasi_static: {mesh: m0, points: 31, periods: 10}}\n"
    )
    system = compiled(text)[1]
    roll = roll_through(system, "roll")
    assert len(roll.rows) == 311
    r_b = system.records["gear_mesh"]["r_b1"][0]
    for mesh in ("m0", "m1"):
        forces = roll.rows[:, system.layout.channel(f"mesh_force[{mesh}]")]
        assert np.abs(forces) == pytest.approx(torque / r_b, rel=1e-6)


@pytest.mark.parametrize(
    ("motion", "beta", "driver", "driven", "names", "kinds"),
    [
        ("free", "17 deg", FULL, NO_AXIAL, "driven along its axis", "a bearing with axial"),
        ("free", "17 deg", NO_AXIAL, FULL, "driver along its axis", "a bearing with axial"),
        ("free", "17 deg", NO_AXIAL, NO_AXIAL, "driver and driven along their axes", "bearings with axial"),
        ("free", "", FULL, None, "driven across its axis", "a bearing with radial"),
        ("free", "17 deg", FULL, None, "driven across its axis, along its axis and against tilting",
         "a bearing with radial, axial and tilt"),
        ("planar", "", "{radial: 1e8 N/m}", "{x: 1e8 N/m}", "driven across its axis in y",
         "a bearing with radial"),
    ],
)  # fmt: skip
def test_what_nothing_holds_is_named(motion, beta, driver, driven, names, kinds):
    given = {"driver": driver, "driven": driven}
    rows = "".join(f"  on_{b}: {{body: {b}, stiffness: {k}}}\n" for b, k in given.items() if k)
    law = "{law: din3990, stiffness_ratio: 0.8}"
    system = compiled(pair(law, beta=beta, motion=motion, rest=f"bearings:\n{rows}"))[1]
    with pytest.raises(SolverError) as failure:
        solve_equilibrium(system)
    line = system.model.line(("bodies", names.partition(" ")[0]))
    assert str(failure.value) == f"no equilibrium: nothing holds {names}: add {kinds} stiffness (line {line})"
    assert failure.value.status == SINGULAR


def test_directions_that_no_load_pushes_in_need_no_bearing():
    rest = "bearings:\n" + "".join(
        f"  on_{b}: {{body: {b}, stiffness: {{radial: 1e8 N/m}}}}\n" for b in ("driver", "driven")
    )
    found = solve_equilibrium(compiled(pair(LAWS[0], motion="free", rest=rest))[1])
    assert float(found["torque[output]"]) == pytest.approx(300.0, rel=1e-9)


def hung(n, angle):
    """A chain of links of 0.1 m that starts at an angle from where it hangs [rad]."""
    bodies = {f"b{k}": LINK | {"markers": {"end": {"position": [0.1, 0.0, 0.0]}}} for k in range(n)}
    bodies["b0"]["position"] = [0.0, 0.0, 0.0]
    ends = [("ground" if k == 0 else f"b{k - 1}.end", f"b{k}") for k in range(n)]
    joints = {f"j{k}": {"type": "revolute", "bodies": list(pair)} for k, pair in enumerate(ends)}
    gravity = [9.81 * math.cos(angle), -9.81 * math.sin(angle), 0.0]
    return compile_model(model_of({"bodies": bodies, "joints": joints, "gravity": gravity}))


LINK = {"mass": 1.0, "inertia_tensor": [0.01, 0.02, 0.03, 0.0, 0.0, 0.0], "center_of_mass": [0.05, 0.0, 0.0]}


@pytest.mark.filterwarnings("ignore::pitchpoint.core.errors.ValidityWarning")
@pytest.mark.parametrize(("n", "degrees"), [(1, 179.9), (3, 150.0), (10, 90.0), (40, 1.0), (40, 90.0)])
def test_chains_come_to_hang_from_wherever_they_start(n, degrees, monkeypatch):
    """Straight down, never up, in few steps: what turns with the joints is the only stiffness they have.

    A step without it goes down the slope of the energy, and a chain of 40 is not at rest after 400 of them.
    The angle left over is that of the tolerance: 1e-9 of the largest moment about a joint over the weight of
    the last link, some n^2 1e-9.
    """
    system = hung(n, math.radians(degrees))
    heard: list[str] = []
    monkeypatch.setattr(solve, "SLOW", -1.0)  # searches that take long tell how far they are
    with listening(heard.append):
        found = find_equilibrium(system)
    angles = np.cumsum(found.state.q) + np.radians(degrees)
    assert np.abs(np.sin(angles)).max() < 2e-9 * n**2
    assert np.cos(angles).min() > 0.0
    assert found.iterations < 100
    assert len(heard) > found.iterations // 4 > 0


SOFT = """\
gears:
  p: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  w: {number_of_teeth: 40, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  a: {gears: [p], inertia: 1e-3 kg m^2, motion: torsion}
  b: {gears: [w], motion: fixed}
meshes:
  m: {gears: [p, w], stiffness: {law: fourier, mean: 3e6 N/m, cosine: COSINE}}
loads:
  t: {body: a, torque: TORQUE N m}
"""


@pytest.mark.parametrize(("cosine", "torque"), [("[0, 0.4]", 200), ("[0, 0, 0.4]", 100), ("[-0.5]", 200)])
def test_forces_that_change_with_the_phase_are_balanced_in_few_steps(cosine, torque):
    """The tangent holds the phase constant; without a correction by the last step it takes 145, 50 and 25.

    The deflections of 0.5 to 2 mm are up to a quarter of the base pitch. Force of the flank: T/r_b1.
    """
    system = compile_model(loads_model(SOFT.replace("COSINE", cosine).replace("TORQUE", str(torque))))
    found = find_equilibrium(system, held=())
    values = found.observe(system)
    force = float(values[system.layout.channel("mesh_force[m]")])
    assert abs(force) == pytest.approx(torque / (0.03 * math.cos(math.radians(20.0))), rel=1e-9)
    assert found.iterations <= 17


def test_angles_are_rounded_as_one_radian_and_positions_as_the_height():
    """A disk 150 m above the origin."""
    text = (
        "bodies: {disk: {motion: free, mass: 1 kg, inertia: 1 kg m^2, transverse_inertia: 1 kg m^2, "
        "position: [0, 0, 150 m]}}\n"
        "bearings: {one: {body: disk, stiffness: {radial: 1e8 N/m, axial: 1e8 N/m, tilt: 1e6 N m/rad}}}\n"
    )
    system = compile_model(loads_model(text))
    coordinates = [name.rpartition(".")[2] for name in system.layout.coordinates]
    want = [150.0 if name in ("x", "y", "z") else 1.0 for name in coordinates]
    assert sum(x == 150.0 for x in want) == 3 and extents(system).tolist() == want
