# SPDX-License-Identifier: Apache-2.0
"""Bodies that turn together, and that their rotation stays undamped: what joins a train and what does not."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.elements import ratio
from pitchpoint.model.scenario import Scenario
from pitchpoint.multibody.bodies import Body
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.gear_trains import exchange, free_spins, held_spins, rotations
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.system import assemble
from tests.support.engine import chain, gear_rows
from tests.support.machines import compiled, pair

GEAR = "number_of_teeth: {}, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
MESH = "stiffness: {law: constant, value: 3e8 N/m}, backlash: {base_tangent: 0.05 mm}"
RAYLEIGH = "damping: {rayleigh: {mass: 5 1/s}}\n"


def two_pairs(joint: str, loads: str, scenario: str) -> str:
    """Gears a-b and c-d, shafts A and C on one axis."""
    gears = "".join(f"  {n}: {{{GEAR.format(z)}}}\n" for n, z in (("a", 20), ("b", 30), ("c", 20), ("d", 30)))
    places = {"A": ", position: [0, 0, 0]", "C": ", position: [0, 0, 40 mm]"}
    bodies = "".join(f"  {n}: {{gears: [{n.lower()}], motion: planar{places.get(n, '')}}}\n" for n in "ABCD")
    meshes = f"  ab: {{gears: [a, b], {MESH}}}\n  cd: {{gears: [c, d], {MESH}}}\n"
    bearings = "".join(f"  s{n}: {{body: {n}, stiffness: {{radial: 1e8 N/m}}}}\n" for n in "ABCD")
    return (
        f"gears:\n{gears}bodies:\n{bodies}meshes:\n{meshes}bearings:\n{bearings}"
        f"couplings:\n  k: {{bodies: [A, C], stiffness: {{{joint}}}}}\n"
        f"loads:\n{loads}{RAYLEIGH}scenarios:\n  on: {scenario}\n"
    )


FREE = "{speed: {A: 100 rad/s, C: 50 rad/s}, duration: 0.05 s}"
BALANCED = (
    "  i: {body: A, torque: 100 N m}\n  o: {body: B, torque: balance}\n"
    "  i2: {body: C, torque: 50 N m}\n  o2: {body: D, torque: balance}\n"
)


def test_a_coupling_without_torsion_joins_no_train():
    """Each keeps the speed it began with, and each has a torque that balances."""
    system = compiled(two_pairs("radial: 1e8 N/m", BALANCED, FREE), "on")[1]
    assert [system.layout.coordinates[s] for s in free_spins(system)] == ["A.spin", "C.spin"]
    assert exchange(system, free_spins(system), system.spin("D")) == (system.spin("A"), system.spin("D"))
    found = solve_time(system)
    for body, speed in (("A", 100.0), ("B", -200 / 3), ("C", 50.0), ("D", -100 / 3)):
        assert found[f"speed[{body}]"].values[-1] == pytest.approx(speed, rel=1e-6)


def test_a_coupling_with_torsion_makes_one_train():
    with pytest.raises(ModelError, match="is balance, like that of o in the same gear train"):
        compiled(two_pairs("radial: 1e8 N/m, torsion: 1e4 N m/rad", BALANCED, FREE))
    loads = BALANCED.replace("o2: {body: D, torque: balance}", "o2: {body: D, torque: 75 N m}")
    system = compiled(two_pairs("torsion: 1e4 N m/rad", loads, FREE.replace(", C: 50 rad/s", "")), "on")[1]
    assert free_spins(system) == (system.spin("A"),)
    rates = rotations(system, [system.spin("C")])[:, 0]
    assert {n: rates[system.spin(n)] for n in "ABCD"} == pytest.approx(
        {"A": 1.0, "B": -2 / 3, "C": 1.0, "D": -2 / 3}
    )


@pytest.mark.parametrize("housing", ["planar", "fixed"])
@pytest.mark.parametrize("brake", ["balance", "140 N m"])
def test_gears_in_a_housing_turn_freely(housing: str, brake: str):
    """The bearing of gear A is a coupling to the housing; loads that do not balance change its speed."""
    inertia = "" if housing == "fixed" else ", mass: 20 kg, inertia: 0.5 kg m^2"
    foot = "" if housing == "fixed" else "  foot: {body: H, stiffness: {radial: 1e9, torsion: 1e8}}\n"
    text = (
        f"gears:\n  a: {{{GEAR.format(20)}}}\n  b: {{{GEAR.format(30)}}}\n"
        "bodies:\n  A: {gears: [a], motion: planar, position: [0, 0, 0]}\n  B: {gears: [b], motion: planar}\n"
        f"  H: {{motion: {housing}, position: [0, 0, 0]{inertia}}}\n"
        f"meshes:\n  ab: {{gears: [a, b], {MESH}}}\n"
        f"bearings:\n{foot}  sb: {{body: B, stiffness: {{radial: 1e8 N/m}}}}\n"
        "couplings:\n  ka: {bodies: [H, A], stiffness: {radial: 1e8 N/m}}\n"
        f"loads:\n  i: {{body: A, torque: 100 N m}}\n  o: {{body: B, torque: {brake}}}\n{RAYLEIGH}"
        "scenarios:\n  on: {speed: {A: 100 rad/s}, duration: 0.05 s}\n"
    )
    system = compiled(text, "on")[1]
    assert free_spins(system) == (system.spin("A"),)
    found = solve_time(system)
    inertia = sum(
        b.polar_inertia * ratio**2 for b, ratio in zip(system.bodies[:2], (1.0, 2 / 3), strict=True)
    )
    torque = 0.0 if brake == "balance" else 100.0 - 140.0 * 2 / 3
    gained = torque / inertia * 0.05
    assert found["speed[A]"].values[-1] == pytest.approx(100.0 + gained, rel=1e-3)
    assert ("the loads do not balance" in found.attrs["notes"]) == (brake != "balance")


@pytest.mark.filterwarnings("ignore:couplings.k.bodies.*parallel axes")
def test_what_closes_a_loop_at_another_ratio_cannot_turn():
    """The mesh turns the driven gear at -2/3, the coupling at 1: every motion is damped."""
    rest = "couplings:\n  k: {bodies: [driver, driven], stiffness: {torsion: 1e5 N m/rad}}\n" + RAYLEIGH
    text = pair("{law: constant, value: 3e8 N/m}", rest=rest).replace("torque: balance", "torque: 0 N m")
    system = compiled(text)[1]
    assert free_spins(system) == ()
    start = prepare_start(system, Scenario())
    assert start.notes == ()
    assert find_equilibrium(start.system).reaction.size == 0


def test_rigid_gears_and_springs_make_trains_too():
    system = chain([1.0, 1.0, 1.0], [5.0], ratio=gear_rows([(2, 3, 20, -60)]))
    assert free_spins(system) == held_spins(system) == (0,)
    np.testing.assert_allclose(rotations(system, [0])[:, 0], [1.0, 1.0, 1 / 3])


def test_a_planet_set_has_two_free_rotations():
    """Sun, carrier with a planet, ring; any two of the three members can be held."""
    bodies = [
        Body(polar_inertia=1.0, name="sun"),
        Body(polar_inertia=1.0, name="carrier"),
        Body(parent=2, mass=1.0, polar_inertia=1.0, position=(0.2, 0.0, 0.0), name="planet"),
        Body(polar_inertia=1.0, name="ring"),
    ]
    rows = np.zeros(2, ratio.RECORD)
    for row, terms in zip(rows, (((1, 20), (3, 30), (2, -20)), ((3, 30), (4, -80), (2, 80))), strict=True):
        for end, (body, c) in zip("ijk", terms, strict=True):
            row[end], row[f"q_{end}"], row[f"c_{end}"] = body, ratio.SPIN, c
    system = assemble(bodies, {}, {"ratio": rows})
    sun, carrier, planet, ring = (system.spin(b.name) for b in bodies)
    assert free_spins(system) == (sun, carrier)
    assert exchange(system, (sun, carrier), ring) in ((sun, ring), (carrier, ring))
    rates = rotations(system, (carrier, ring))
    np.testing.assert_allclose(rates[sun], [1.0 + 80 / 20, -80 / 20])  # Willis
    np.testing.assert_allclose(rates[planet], [-80 / 30, 80 / 30])


PROPORTIONAL = "rayleigh: {mass: 3 1/s, stiffness: 1e-5 s}"


@pytest.mark.parametrize(
    ("damping", "load"),
    [
        (PROPORTIONAL, "500 N m*sin(6*angle)"),
        ("modal: 0.05", "500 N m*sin(6*angle)"),
        (PROPORTIONAL, "-50 N m*sin(6*angle)"),
        ("modal: 0.05", "-50 N m*sin(6*angle)"),
        # no steady motion is found in all tries
        pytest.param(PROPORTIONAL, "-500 N m*sin(6*angle)", marks=pytest.mark.study),
        pytest.param("modal: 0.05", "-500 N m*sin(6*angle)", marks=pytest.mark.study),
        (PROPORTIONAL, "-0.4 N m s*speed"),
        ("modal: 0.05", "-0.4 N m s*speed"),
    ],
)
def test_damping_leaves_a_rotation_alone_whatever_its_loads(damping: str, load: str):
    """D R = 0 for the rotation R, also where the load has a slope over the angle or the speed."""
    rest = f"damping: {{{damping}}}\nscenarios:\n  on: {{speed: {{driver: 100 rad/s}}, duration: 0.1 s}}\n"
    text = pair("{law: constant, value: 3e8 N/m}, damper: {ratio: 0.05}", torque=f'"{load}"', rest=rest)
    system = compiled(text.replace("torque: balance", "torque: 30 N m"), "on")[1]
    start = prepare_start(system, system.scenario)
    D = np.zeros((2, 2))
    for record in start.system.records["damping"]:
        D[record["dof_i"], record["dof_j"]] += record["D"][0, 0]
    R = rotations(system, free_spins(system))
    assert np.abs(D).max() > 1.0
    assert np.abs(D @ R).max() < 1e-12 * np.abs(D).max()
