# SPDX-License-Identifier: Apache-2.0
"""How far a report rolls a mesh, and that it shows the rolls it is given."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from pitchpoint.core.progress import silent
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.core.units import format_quantity
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.model import Model
from pitchpoint.report.collect import collect
from pitchpoint.report.rolls import (
    RollPlan,
    Train,
    given_roll,
    periods_until_repeat,
    plan_of,
    points_to_roll,
    without_given,
)
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.viz.report.build import MeshCycleData, RollData

if TYPE_CHECKING:
    import xarray as xr

PITCH = ", ".join(["0 um"] * 5 + ["30 um", "-30 um"] + ["0 um"] * 12)


def gear(teeth: int, more: str = "") -> str:
    return (
        f"{{number_of_teeth: {teeth}, normal_module: 3 mm, face_width: 20 mm, "
        f"profile_shift_coefficient: 0{more}}}"
    )


def train(motion: str = "planar", middle: tuple[int, int] = (57, 19), deviation: bool = False) -> Model:
    return loads_model(text(motion, middle, deviation))


def text(motion: str = "planar", middle: tuple[int, int] = (57, 19), deviation: bool = False) -> str:
    """Two stages, 19/57 and 19/59 teeth; planar bodies sit on soft bearings."""
    own = f", deviations: {{pitch: [{PITCH}]}}" if deviation else ""
    names = ("input", "middle", "output")
    bearings = "".join(
        f"  b{k}: {{body: {name}, stiffness: {{radial: 5e7 N/m}}, damping: {{ratio: 0.03}}}}\n"
        for k, name in enumerate(names)
    )
    law = "stiffness: {law: din3990, tip_relief_factor: 0.3}, damper: {ratio: 0.04}"
    first = 1.5 * (19 + middle[0]) + 0.1
    second = 1.5 * (middle[1] + 59) + 0.1
    return f"""
gears:
  z1: {gear(19, own)}
  z2: {gear(middle[0])}
  z3: {gear(middle[1])}
  z4: {gear(59)}
bodies:
  input: {{gears: [z1], motion: {motion}, mass: 2 kg, inertia: 2e-3 kg m^2}}
  middle: {{gears: [z2, z3], motion: {motion}, mass: 5 kg, inertia: 6e-3 kg m^2}}
  output: {{gears: [z4], motion: {motion}, mass: 9 kg, inertia: 5e-2 kg m^2}}
meshes:
  first: {{gears: [z1, z2], center_distance: {first} mm, {law}}}
  second: {{gears: [z3, z4], center_distance: {second} mm, direction: 40 deg, {law}}}
{"bearings:" if motion == "planar" else ""}
{bearings if motion == "planar" else ""}
loads:
  motor: {{body: input, torque: 60 N m}}
  brake: {{body: output, torque: balance}}
scenarios:
  roll: {{quasi_static: {{mesh: first, points: 40, periods: 6}}}}
"""


def test_a_mesh_is_rolled_until_the_others_have_come_round() -> None:
    """The second mesh has 19/57 = 1/3 of the tooth frequency of the first one."""
    model = train()
    assert [periods_until_repeat(model, mesh) for mesh in model.meshes] == [3, 1]
    other = train(middle=(57, 20))
    assert [periods_until_repeat(other, mesh) for mesh in other.meshes] == [57, 20]
    assert plan_of(other, "first", 12) == RollPlan(57, 12, 80)


def test_a_roll_has_points_for_the_fastest_mesh_and_fewer_periods_in_a_large_machine() -> None:
    """57 cycles of the first mesh are 20 of the second one: 8 points each, at least 80 per period."""
    other = train(middle=(57, 20))
    assert plan_of(other, "second", 101) == RollPlan(20, 3, 80)
    fast = train(middle=(342, 18))  # 19 cycles of the first mesh per period of the second one
    assert plan_of(fast, "second", 101) == RollPlan(1, 1, 152)
    assert plan_of(fast, "second", 101, Train(loaded=("second",))) == RollPlan(1, 1, 96)


def test_a_gear_whose_teeth_differ_is_rolled_once_round() -> None:
    """The input makes one turn in 19 periods of the first mesh, in 19/3 of the second one."""
    model = train(deviation=True)
    assert [plan_of(model, mesh, 3).periods for mesh in model.meshes] == [57, 19]


BRAKED = """
gears:
  z1: {number_of_teeth: 20, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  z2: {number_of_teeth: 40, normal_module: 2 mm, face_width: 20 mm}
  z3: {number_of_teeth: 20, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  z4: {number_of_teeth: 40, normal_module: 2 mm, face_width: 20 mm}
bodies:
  input: {gears: {z1: 0 mm}, motion: torsion, inertia: 1e-3 kg m^2, position: [0, 0, 0]}
  output: {gears: {z2: 0 mm}, motion: torsion, inertia: 1e-2 kg m^2}
  lay: {gears: {z3: 0 mm}, motion: torsion, inertia: 1e-3 kg m^2, position: [0, 0, 60 mm]}
  ring: {gears: {z4: 0 mm}, motion: torsion, inertia: 1e-2 kg m^2}
meshes:
  first: {gears: [z1, z2], center_distance: 60 mm}
  second: {gears: [z3, z4], center_distance: 60 mm}
clutches:
  B: {bodies: [lay], capacity: 200 N m}
loads:
  motor: {body: input, torque: 10 N m}
  road: {body: output, torque: balance}
  push: {body: ring, torque: 20 N m}
scenarios:
  roll: {engaged: [B], quasi_static: {mesh: first, points: 12}}
"""


def test_meshes_that_clutches_lock_are_not_rolled() -> None:
    """The brake holds the second train: its gears would be forced through the teeth."""
    model = loads_model(BRAKED)
    found, remarks = collect(model, [], silent)
    assert len(found.mesh_cycles["first"].errors) == 2 and not found.mesh_cycles["second"].errors
    assert "second: no slow roll, since the engaged clutches lock their gears." in remarks
    with pytest.raises(pp.SolverError, match="second cannot be rolled: .* while B is locked; roll another"):
        roll_through(pp.compile_model(model, "roll"), mesh="second")


def helical_train() -> Model:
    """The same ratios with helical gears on shafts that tilt in their bearings."""
    gears, bodies, bearings = "", "", ""
    rows = (("z1", 21, 2, 18, "right", 25), ("z2", 57, 2, 18, "left", 24))
    rows += (("z3", 19, 3, 12, "left", 35), ("z4", 59, 3, 12, "right", 34))
    for name, z, m, beta, hand, b in rows:
        gears += (
            f"  {name}: {{number_of_teeth: {z}, normal_module: {m} mm, helix_angle: {beta} deg, "
            f"hand: {hand}, face_width: {b} mm, profile_shift_coefficient: {0.3 if z < 30 else 0.1}}}\n"
        )
    shafts = (("input", "z1: -60 mm"), ("middle", "z2: -60 mm, z3: 20 mm"), ("output", "z4: 20 mm"))
    for name, own in shafts:
        bodies += (
            f"  {name}: {{gears: {{{own}}}, motion: free, mass: 5 kg, inertia: 6e-3 kg m^2, "
            "transverse_inertia: 2e-2 kg m^2}\n"
        )
        for side, sign, axial in (("a", "-", ", axial: 1e8 N/m"), ("b", "", "")):
            bearings += (
                f"  {name}_{side}: {{body: {name}, position: [0, 0, {sign}100 mm], "
                f"stiffness: {{radial: 2e8 N/m{axial}}}, damping: {{ratio: 0.02}}}}\n"
            )
    law = "stiffness: {law: din3990, tip_relief_factor: 0.3}, damper: {ratio: 0.04}"
    return loads_model(
        f"""
gears:
{gears}
bodies:
{bodies}
meshes:
  first: {{gears: [z1, z2], center_distance: 82.9 mm, {law}}}
  second: {{gears: [z3, z4], center_distance: 121 mm, direction: 40 deg, {law}}}
bearings:
{bearings}
loads:
  motor: {{body: input, torque: 60 N m}}
  brake: {{body: output, torque: balance}}
"""
    )


def test_a_cycle_is_drawn_as_long_as_it_is() -> None:
    """Where shafts tilt the meshes disturb each other; spur gears under constant loads do not."""
    found, _ = collect(helical_train(), [], silent)
    first, second = found.mesh_cycles["first"], found.mesh_cycles["second"]
    assert (first.cycles, first.repeats, second.cycles, second.repeats) == (3, 3, 1, 1)
    phase, loaded = np.asarray(first.error_phase), np.asarray(list(first.errors.values())[1])
    assert (phase[0], phase[-1]) == (0.0, 3.0)
    assert loaded[0] == loaded[-1]
    thirds = [np.interp(np.linspace(k, k + 0.99, 50), phase, loaded) for k in range(3)]
    assert np.abs(thirds[0] - thirds[1]).max() > 0.02 * np.ptp(loaded)
    alone, _ = collect(train("torsion"), [], silent)
    assert [(c.cycles, c.repeats) for c in alone.mesh_cycles.values()] == [(1, 1), (1, 1)]


def test_a_faulty_tooth_is_seen_without_a_roll() -> None:
    found, _ = collect(train("torsion", deviation=True), [], silent)
    unloaded = np.asarray(found.mesh_cycles["first"].errors["without load"])
    assert np.ptp(unloaded) == pytest.approx(30e-6 * np.cos(np.radians(20.0)), abs=1e-10)


@pytest.fixture(scope="module")
def rolled() -> xr.Dataset:
    """The roll of its scenario."""
    return pp.solve_quasistatic(pp.compile_model(train("torsion"), "roll"))


@pytest.mark.parametrize("as_file", [True, False])
def test_a_roll_that_is_given_is_drawn_over_all_its_periods(
    as_file: bool, rolled: xr.Dataset, tmp_path: Path
) -> None:
    model = train("torsion")
    given: list[object] = [rolled]
    if as_file:
        (tmp_path / "m.yaml").write_text(text("torsion"), encoding="utf-8")
        target = tmp_path / "roll.h5"
        assert run_command(["run", str(tmp_path / "m.yaml"), "-s", "roll", "-q", "-o", str(target)]) == 0
        given, model = [target], pp.load_model(tmp_path / "m.yaml")
    found, remarks = collect(model, given, silent)  # type: ignore[arg-type]
    assert not remarks
    ((_, roll),) = found.rolls.items()
    assert roll.mesh == "first"
    periods, errors = roll.curves["first"]
    np.testing.assert_allclose(np.asarray(periods)[[0, -1]], [0.0, 6.0], atol=0.02)
    np.testing.assert_allclose(np.asarray(roll.curves["second"][0])[-1], 2.0, atol=0.02)
    np.testing.assert_allclose(errors["without load"], rolled["unloaded_transmission_error[first]"].values)
    assert [name.startswith("mesh force ") for name in errors] == [False, True]
    # the curves of the file are in the place of ones computed anew
    assert not found.mesh_cycles["first"].errors and not found.mesh_cycles["second"].errors


def test_a_mesh_of_which_a_roll_has_less_than_a_period_keeps_its_own_curve() -> None:
    error = {"without load": np.array([0.0, 1e-6])}
    cycles = {mesh: MeshCycleData(errors=error) for mesh in ("rolled", "whole", "part")}
    curves = {mesh: (np.array([0.0, end]), error) for mesh, end in (("whole", 1.0), ("part", 0.4))}
    kept = without_given(cycles, {"roll": RollData(curves=curves, mesh="rolled")})
    assert {mesh: bool(cycle.errors) for mesh, cycle in kept.items()} == {
        "rolled": False,
        "whole": False,
        "part": True,
    }


def test_a_roll_without_load_has_one_curve() -> None:
    model = train().replace("loads.motor.torque", 0.0)
    roll = given_roll(pp.solve_quasistatic(pp.compile_model(model, "roll")))
    assert all(list(errors) == ["without load"] for _, errors in roll.curves.values())


def test_ctrl_c_in_a_roll_ends_the_report() -> None:
    """A roll keeps its results and reports the stop; the report does not continue with the next mesh."""
    told = []

    def stop(done: float, total: float, note: str = "") -> None:
        """What Ctrl-C does during the first roll."""
        told.append((done, note))
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        collect(train(), [], stop)
    ((done, note),) = told
    assert 0.0 < done < 1.0 and note == "first: roll"


def test_rolls_of_large_machines_have_fewer_points_and_the_page_says_which(monkeypatch) -> None:
    """Three periods of the first mesh, of which one is drawn, have 96 points each; 80 where 240 are all."""
    assert points_to_roll(100) == 960 and points_to_roll(101) == 240
    model, told = train(), []
    found, notes = collect(model, [], lambda done, total, note="": told.append((done, total)))
    monkeypatch.setattr("pitchpoint.report.rolls.LARGE", 1)
    fewer, said = collect(model, [], silent)
    counts = [{n: len(c.error_phase) for n, c in x.mesh_cycles.items()} for x in (found, fewer)]
    assert counts[0] == {"first": 96 + 2, "second": 96 + 2}
    assert counts[1] == {"first": 80 + 2, "second": 96 + 2}
    assert [n for n in said if n not in notes] == [
        "Slow rolls have at most 240 points instead of 960, because the machine has more than 1 coordinates: "
        "first. A scenario with a slow roll sets its own number."
    ]
    assert told == sorted(told) and told[-1] == (4.0, 4), "two rolls, matrices, Campbell diagram"


def test_what_no_mesh_can_roll_is_said_once(monkeypatch) -> None:
    """Meshes that are not rolled have no number of points either."""

    def refuse(*given: object, **options: object) -> None:
        """No roll."""
        raise pp.SolverError("a slow roll has no speeds", INCONSISTENT)

    monkeypatch.setattr("pitchpoint.report.rolls.LARGE", 1)
    monkeypatch.setattr("pitchpoint.solvers.quasistatic.roll.roll_through", refuse)
    notes = collect(train(), [], silent)[1]
    assert "first and second: no slow roll: a slow roll has no speeds." in notes
    assert not [note for note in notes if "points" in note]


def test_of_many_meshes_only_the_first_ones_are_rolled_and_the_page_says_so(monkeypatch) -> None:
    monkeypatch.setattr("pitchpoint.report.rolls.MAX_ROLLS", 1)
    found, notes = collect(train(middle=(57, 19)), [], silent)
    assert found.mesh_cycles["first"].errors and not found.mesh_cycles["second"].errors
    assert (
        "Slow rolls of 2 meshes would take too long: those of second are omitted. "
        "Use a scenario with a slow roll."
    ) in notes


def test_the_rolls_of_a_driven_train_are_loaded_in_every_mesh() -> None:
    """Brake of 60 N m behind two stages: F = T/r_b in the second, times z3/z2 in the first.

    A roll of the second mesh that held its own pinion would take the load off the first one.
    """
    driven = text("torsion").replace("  motor: {body: input, torque: 60 N m}\n", "")
    driven = driven.replace("torque: balance", "torque: 60 N m")
    driven = driven.replace("roll: {", "roll: {drive: {input: {speed: 100 rpm}}, ")
    model = loads_model(driven)
    shown, remarks = collect(model, [], silent)
    assert not [r for r in remarks if "no load" in r or "do not balance" in r], remarks
    radius = {n: [g.d_b / 2.0 for g in (p.gear1, p.gear2)] for n, p in model.pairs.items()}
    second = 60.0 / radius["second"][1]
    expected = {"second": second, "first": second * radius["second"][0] / radius["first"][1]}
    system = pp.compile_model(model, "roll")
    for mesh in expected:
        roll = roll_through(system, None, 12, 1, mesh=mesh)
        for name, force in expected.items():
            found = roll.rows[:, system.layout.channel(f"mesh_force[{name}]")]
            assert np.abs(found).mean() == pytest.approx(force, rel=1e-6), (mesh, name)
        [title] = [t for t in shown.mesh_cycles[mesh].errors if t != "without load"]
        assert title == f"mesh force {format_quantity(expected[mesh], 'force', 4)}"
