# SPDX-License-Identifier: Apache-2.0
"""Bearings and couplings lie on the axes of their bodies; couplings hold sideways on one axis only."""

from __future__ import annotations

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.reference import reference_page
from pitchpoint.system.compile import compile_model
from tests.support.model_files import gear, pair

BODIES = """bodies:
  one: {{gears: [a], position: [0, 0, 0], motion: {motion}}}
  two: {{gears: [b], motion: {motion}}}
  motor: {{inertia: 1 kg m^2, mass: 30 kg, transverse_inertia: 1 kg m^2, motion: {motion}, position: {place}}}
"""
COUPLING = "couplings:\n  c: {{bodies: [motor, two], {holds}{more}}}\n"


def machine(motion: str, place: str, holds: str, more: str = "") -> str:
    return pair(
        gear("a"),
        gear("b"),
        "",
        BODIES.format(motion=motion, place=place) + COUPLING.format(holds=holds, more=more),
    )


@pytest.mark.parametrize(
    ("group", "body"),
    [("bearings:\n  s: {body: one, ", "one"), ("couplings:\n  s: {bodies: [two, motor], ", "two")],
)
def test_a_place_beside_the_axis_is_refused(group: str, body: str) -> None:
    text = pair(gear("a"), gear("b"), "", BODIES.format(motion="torsion", place="[90 mm, 0, 1]"))
    spring = group + "stiffness: {torsion: 1e4 N m/rad}, position: [%s, %s, 30 mm]}\n"
    with pytest.raises(ModelError) as caught:
        loads_model(text + spring % ("5 mm", "0"))
    (problem,) = caught.value.problems
    where = group.partition(":")[0] + ".s.position"
    assert (problem.where, problem.value, problem.limit) == (where, "[5, 0, 30] mm", "x = y = 0")
    assert f"the axis of {body}" in problem.text
    assert "write [0, 0, 30 mm]" in str(problem.remedy)
    with pytest.raises(ModelError, match="off the axis"):
        loads_model(text + spring % ("0", "-1 um"))
    (record,) = compile_model(loads_model(text + spring % ("0", "0"))).records["bearing"]
    assert record["zi"] == 0.03


def test_the_reference_says_where_they_may_lie() -> None:
    assert reference_page().count("on its axis: [0, 0, z]") == 4


RADIAL = "stiffness: {radial: 1e8 N/m, torsion: 1e4 N m/rad}"
TORSION = "stiffness: {torsion: 1e4 N m/rad}"


@pytest.mark.parametrize(
    ("motion", "holds"),
    [
        ("planar", RADIAL),
        ("free", "stiffness: {axial: 1e7 N/m}"),
        ("free", f"{TORSION}, damping: {{tilt: 3 N m s/rad}}"),
    ],
)
def test_a_coupling_of_two_axes_is_refused(motion: str, holds: str) -> None:
    with pytest.raises(ModelError) as caught:
        loads_model(machine(motion, "[90 mm, 2 mm, 0]", holds))
    (problem,) = caught.value.problems
    assert problem.where == "couplings.c.bodies"
    assert problem.value == "motor and two"
    assert "have axes 2 mm apart" in problem.text
    assert "put motor and two on one axis, or give the coupling torsion only" in str(problem.remedy)


@pytest.mark.parametrize(
    ("motion", "place", "holds"),
    [
        ("free", "[90 mm, 0, 200 mm]", RADIAL),  # one axis
        ("free", "[90 mm, 0.9 um, 0]", RADIAL),  # apart by less than anybody measures
        ("free", "[90 mm, 2 mm, 0]", f"{TORSION}, damping: {{ratio: 0.02}}"),
        ("torsion", "[90 mm, 2 mm, 0]", RADIAL),  # nothing moves sideways
    ],
)
def test_other_couplings_are_allowed(motion: str, place: str, holds: str) -> None:
    assert compile_model(loads_model(machine(motion, place, holds))).records["bearing"].size == 1


@pytest.mark.parametrize(
    ("position", "mesh", "where"),
    [
        ("[0, 0, 300 mm]", "", "meshes.m.gears"),
        ("[95 mm, 0, 0]", "center_distance: 90 mm", "meshes.m.center_distance"),
    ],
)
def test_places_that_came_by_a_coupling_are_told_at_the_mesh(position: str, mesh: str, where: str) -> None:
    text = pair(
        gear("a"),
        gear("b"),
        mesh,
        f"bodies:\n  motor: {{inertia: 1 kg m^2, position: {position}}}\n"
        "  two: {gears: [b]}\n  one: {gears: [a], position: [0, 0, 0]}\n"
        f"couplings:\n  c: {{bodies: [motor, two], {TORSION}}}\n",
    )
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    problems = [p for p in caught.value.problems if p.where == where]
    assert "(couplings.c locates two at motor)" in str(problems[0].remedy)
