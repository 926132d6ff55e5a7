# SPDX-License-Identifier: Apache-2.0
"""Stepped planets and planets in series: the same machine by hand, what is written back, what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.write import model_text, plain
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from tests.support.planet_gearboxes import MESH, gear, ravigneaux, simpson, stepped

LOADS = "loads:\n  in: {body: sun, torque: 200 N m}\n  out: {body: carrier, torque: balance}\n"
IN_FIRST = "loads:\n  in: {body: small_sun, torque: 100 N m}\n  out: {body: ring, torque: balance}\n"
HELD = "scenarios:\n  run: {hold: [carrier], speed: {small_sun: 1000 rpm}, duration: 1 ms}\n"


def refused(text: str) -> list[str]:
    """Problems of a model file."""
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    return [str(each) for each in caught.value.problems]


def values(text: str, scenario: str | None = None) -> dict[str, float]:
    """Forces, torques and displacements of an equilibrium."""
    found = solve_equilibrium(compile_model(loads_model(text), scenario))
    return {str(n): float(v) for n, v in found.data_vars.items() if "[" in str(n) and v.ndim == 0}


def by_hand() -> str:
    """The stepped planets of `stepped`, on rigid pins."""
    text = stepped(loads=LOADS)
    head, _, tail = text.partition("planetary_stages:\n")
    loads = tail[tail.index("loads:") :]
    gears, bodies, joints, meshes = "", "", "joints:\n", "meshes:\n"
    for k in (1, 2, 3):
        x, y = (90e-3 * f(math.tau * (k - 1) / 3) for f in (math.cos, math.sin))
        name = f"planet_{k}"
        gears += f"  {name}: {gear(39, module=3.0)}\n  {name}-small: {gear(18, module=3.0)}\n"
        on_it = f"{{{name}: 0, {name}-small: 30 mm}}"
        bodies += f"  {name}: {{gears: {on_it}, position: [{x!r} m, {y!r} m, 0]}}\n"
        joints += f"  {name}-pin: {{type: revolute, bodies: [carrier, {name}]}}\n"
        for one, two in (("sun", name), (f"{name}-small", "output_ring")):
            meshes += f"  {one}-{two}: {{gears: [{one}, {two}], {MESH[1:-1]}}}\n"
    head = head.replace("bodies:\n", gears + "bodies:\n", 1) + bodies
    place = "position: [0, 0, 0]"
    head = head.replace("gears: [output_ring]", f"gears: {{output_ring: 30 mm}}, {place}")
    head = head.replace("mass: 5 kg}", f"mass: 5 kg, {place}}}")
    return head + joints + meshes + loads


def test_stepped_planets_are_what_one_writes_by_hand():
    one, two = stepped(loads=LOADS), by_hand()
    found, wanted = values(one), values(two)
    assert {n for n in wanted if n.startswith("mesh_force")} <= found.keys()
    for name in wanted:
        if name.startswith(("mesh_force", "torque", "transmission_error")):
            assert found[name] == pytest.approx(wanted[name], rel=1e-8, abs=1e-9), name
    modes = [find_modes(compile_model(loads_model(text))).frequency for text in (one, two)]
    assert modes[0] == pytest.approx(modes[1], rel=1e-9, abs=1e-3)


@pytest.mark.parametrize("text", [stepped(step_more="fitted: true"), ravigneaux(), simpson()])
def test_only_the_stages_are_written(text):
    model = loads_model(text)
    written = plain(model)
    assert not {"joints", "meshes", "bearings"} & written.keys()
    assert not any("planet" in g or "short" in g for g in written["gears"])
    again = loads_model(model_text(model))
    assert again == model
    assert again.meshes == model.meshes
    assert [b.origin for b in again.bodies.values()] == [b.origin for b in model.bodies.values()]


def test_values_are_replaced_in_steps_and_single_planets():
    model = loads_model(stepped())
    moved = model.replace("planetary_stages.planet.steps.small.position", "35 mm")
    assert moved.bodies["planet_2"].gears == {"planet_2": 0.0, "planet_2-small": pytest.approx(0.035)}
    at = "planetary_stages.planet.single_planets.planet_3.steps.small"
    thin = model.replace(f"{at}.tooth_thickness_allowance", "-90 um")
    assert thin.gears["planet_3-small"].tooth_thickness_allowance == pytest.approx(-90e-6)
    assert thin.gears["planet_3"].tooth_thickness_allowance == pytest.approx(-30e-6)
    assert thin.gears["planet_1-small"].tooth_thickness_allowance == pytest.approx(-30e-6)
    wide = model.replace(f"{at}.ring_mesh", {"backlash": {"normal": "0.2 mm"}})
    assert wide.meshes["planet_3-small-output_ring"].backlash.normal == pytest.approx(2e-4)
    assert wide.meshes["planet_1-small-output_ring"].backlash is None


def test_a_fault_of_a_step_is_named_there():
    crack = "{crack: {type: root_crack, tooth: 99, flank: left, depth: 1 mm}}"
    step = f"planet_2: {{steps: {{small: {{faults: {crack}}}}}}}"
    problem = refused(stepped(more=f"single_planets: {{{step}}}"))[0]
    assert problem.startswith(
        "planetary_stages.planet.single_planets.planet_2.steps.small.faults.crack.tooth (line"
    )


def test_planets_in_series_about_any_axis():
    """Forces about the y axis of the world are those about z, on either side of the inner planets."""
    text = ravigneaux(IN_FIRST, HELD, more="bearing: {stiffness: {radial: 3e8 N/m}}", motion="planar")
    turned = text.replace("position: [0, 0, 25 mm]}", "position: [0, 25 mm, 0], axes: {z: [0, 1, 0]}}")
    turned = turned.replace("[0, 0, 0]}", "[0, 0, 0], axes: {z: [0, 1, 0]}}")
    clockwise = text.replace("inner_planets: short", "inner_planets: short\n    planet_side: clockwise")
    wanted = values(text, "run")
    for other in (turned, clockwise):
        found = values(other, "run")
        for k in (1, 2, 3):
            for mesh in (f"small_sun-short_{k}", f"short_{k}-long_{k}", f"long_{k}-ring"):
                name = f"mesh_force[{mesh}]"
                assert abs(found[name]) == pytest.approx(abs(wanted[name]), rel=1e-5), name
    places = [loads_model(t).bodies["long_1"].origin for t in (text, turned, clockwise)]
    assert places[0][:2] == pytest.approx((54e-3 * 0.75, 54e-3 * math.sqrt(1 - 0.75**2)), rel=1e-9)
    assert places[2][1] == pytest.approx(-places[0][1], rel=1e-12)
    assert np.hypot(places[1][0], places[1][2]) == pytest.approx(54e-3, rel=1e-12)
    assert places[1][1] == pytest.approx(12.5e-3, rel=1e-12)


SERIES = "planetary_stages.long.inner_planets"


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            "inner_planets: short",
            "inner_planets: shrt",
            f"{SERIES} (line 31): names the planets 'shrt', which",
        ),
        (
            "planets: 3\n    carrier: carrier\n    sun_m",
            "planets: 2\n    carrier: carrier\n    sun_m",
            "names 2 pl",
        ),
        (
            "planet_name: long",
            "planet_name: short",
            f"{SERIES} (line 31): names its own planets, short; give",
        ),
        (
            "sun: small_sun",
            "sun: small_sun\n    inner_planets: long",
            "planetary_stages.short.inner_planets (line 20): is a loop",
        ),
        ("number_of_teeth: 27", "number_of_teeth: 28", "equal angles: 4/3 = 1.33333 is not a whole number"),
        ("[0, 0, 25 mm]", "[0, 0, 15 mm]", "makes short_1 and large_sun overlap by 13 mm"),
        (
            "inner_planets: short",
            "inner_planets: short\n    planet_center_distance: 50 mm",
            "planet_center_distance (line 32): 50.0000 mm keeps the tips apart",
        ),
    ],
)
def test_planets_in_series_that_are_refused(old, new, words):
    text = ravigneaux()
    assert old in text
    assert words in refused(text.replace(old, new, 1))[0]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (f"planet: {gear(18)}", f"planet: {gear(18)}".replace("20.0 mm", "20 kg"), "short.planet.face_width"),
        ("    planets: 3\n", "", "planetary_stages.short (line 11): gives none of planets, angles"),
        (
            "number_of_teeth: 27",
            "number_of_teeth: 28",
            "planetary_stages.short.planets (line 14): 3 cannot be",
        ),
    ],
)
def test_one_mistake_is_one_problem(old, new, words):
    """Of an unreadable stage, of planets without a number, and of teeth that do not fit."""
    text = ravigneaux()
    assert old in text
    (problem,) = refused(text.replace(old, new, 1))
    assert words in problem


@pytest.mark.parametrize(
    ("how", "words"),
    [
        (
            {"step_more": "sun: sun"},
            "steps.small.sun (line 23): names sun, as does planetary_stages.planet.sun",
        ),
        ({"step_more": "rng: x"}, "steps.small.rng (line 23): is an unknown key; did you mean ring?"),
        ({"step": 20}, "the planets would be 87 mm from the axis of output_ring, 3 mm less than 90 mm from"),
        ({"more": "single_planets: {planet_1: {steps: {big: {}}}}"}, "steps.big (line 18): is not a step of"),
        ({"count": 5}, "overlap by 17.2 mm at their tips; use fewer planets, 4 at most at equal angles"),
    ],
)
def test_stepped_planets_that_are_refused(how, words):
    assert words in refused(stepped(**how))[0]


def test_a_large_step_in_the_plane_of_another_gear():
    """Planets of 39 teeth reach 151.5 mm, beyond the teeth of a ring of 78 at their position."""
    problems = refused(stepped().replace("position: 30 mm", "position: 10 mm"))
    assert "planetary_stages.planet (line 9): makes planet_1 and output_ring overlap by 36 mm" in problems[0]


def test_hands_of_a_step():
    """Equal hands with a ring; the key of the stage is that of all meshes."""
    text = stepped(more="center_distance: 90 mm")
    for z, hand in ((18, "left"), (78, "right")):
        text = text.replace(
            f"{{number_of_teeth: {z}, normal_module: 3.0 mm",
            f"{{number_of_teeth: {z}, helix_angle: 10 deg, hand: {hand}, normal_module: 2.954 mm",
        )
    assert any("have hands that do not fit an internal pair" in problem for problem in refused(text))
