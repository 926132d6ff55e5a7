# SPDX-License-Identifier: Apache-2.0
"""Planetary stages: the same machine as written by hand, what is refused, and what is written back."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.checks.planetary_stages import possible_angles
from pitchpoint.model.components.planetary_stage import PlanetBearing
from pitchpoint.model.components.six import Stiffness6
from pitchpoint.model.planetary_stages import at_stages
from pitchpoint.model.write import model_text, plain
from pitchpoint.report.planets import stages_of_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from pitchpoint.system.source import coordinate_source, source
from tests.support.planet_stages import PIN_BEARING, TEETH, by_hand, stage_file

ERRORS = "planets: 3\npin_errors: {planet_1: {tangential: 20 um}, planet_3: {radial: -10 um}}"
BY_HAND = ((0.0, 20e-6), (0.0, 0.0), (-10e-6, 0.0))
BACKLASH = (
    "stiffness: {law: din3990, tip_relief_factor: 0.5}, damper: {ratio: 0.05}, backlash: {normal: 80 um}"
)


def values(data):
    """All channels of a dataset by name."""
    return {str(n): v.values for n, v in data.data_vars.items() if "[" in str(n)}


@pytest.mark.parametrize("motion", ["torsion", "planar", "free"])
@pytest.mark.parametrize("sun", ["torsion", "planar", "free"])
def test_a_stage_is_what_one_writes_by_hand(motion, sun):
    """Equilibrium and natural frequencies. Places differ by rounding: 1e-16 m times 5e8 N/m of each of the
    meshes, and Newton's tolerance of 1e-9 of the loads."""
    more = ERRORS + f"\nmotion: {motion}" + (f"\nbearing: {{{PIN_BEARING}}}" if motion != "torsion" else "")
    one = compile_model(loads_model(stage_file(more, mesh=BACKLASH, sun=sun)))
    two = compile_model(loads_model(by_hand(BY_HAND, motion=motion, mesh=BACKLASH, sun=sun)))
    assert one.layout.bodies == two.layout.bodies
    assert [c.name for c in one.layout.channels] == [c.name for c in two.layout.channels]
    found, wanted = values(solve_equilibrium(one)), values(solve_equilibrium(two))
    for name, value in wanted.items():
        scale = 1e-5 if "force" in name or "torque" in name else 1e-12
        assert found[name] == pytest.approx(value, rel=1e-8, abs=scale), name
    assert find_modes(one).frequency == pytest.approx(find_modes(two).frequency, rel=1e-9, abs=1e-3)


def test_a_run_is_that_of_the_set_by_hand():
    more = ERRORS + f"\nmotion: planar\nbearing: {{{PIN_BEARING}}}"
    runs = [
        values(solve_time(compile_model(loads_model(text), "steady")))
        for text in (
            stage_file(more, mesh=BACKLASH, sun="planar"),
            by_hand(BY_HAND, motion="planar", mesh=BACKLASH, sun="planar"),
        )
    ]
    assert runs[0].keys() == runs[1].keys()
    for name in ("mesh_force[sun-planet_2]", "mesh_force[planet_3-ring]", "displacement[sun.x]"):
        size = np.abs(runs[1][name]).max()
        assert runs[0][name] == pytest.approx(runs[1][name], abs=1e-6 * size), name


def test_shafts_of_any_direction():
    """A stage about the y axis of the world has the forces of that about z."""
    axes = ", axes: {z: [0, 1, 0], x: [0, 0, 1]}"
    forces = []
    for how in ({}, {"axes": axes}):
        model = loads_model(
            stage_file(
                ERRORS + "\nmotion: planar\nbearing: {stiffness: {radial: 1e9 N/m}}", mesh=BACKLASH, **how
            )
        )
        found = solve_equilibrium(compile_model(model))
        forces.append([float(found[f"mesh_force[sun-planet_{k}]"]) for k in (1, 2, 3)])
    assert model.bodies["planet_2"].origin == pytest.approx(
        (0.09 * math.sin(2 * math.pi / 3), 0.0, 0.09 * math.cos(2 * math.pi / 3)), abs=1e-12
    )
    assert forces[1] == pytest.approx(forces[0], rel=1e-9)


def test_only_the_stage_is_written():
    model = loads_model(stage_file(ERRORS, mesh=BACKLASH))
    written = plain(model)
    assert list(written["gears"]) == ["sun", "ring"]
    assert list(written["bodies"]) == ["sun", "ring", "carrier"]
    assert not {"joints", "meshes", "bearings"} & written.keys()
    assert written["planetary_stages"]["set"]["pin_errors"] == {
        "planet_1": {"tangential": "20 um"},
        "planet_3": {"radial": "-10 um"},
    }
    again = loads_model(model_text(model))
    assert again == model
    assert again.meshes == model.meshes


def test_values_are_replaced_in_the_stage():
    model = loads_model(stage_file(ERRORS, mesh=BACKLASH))
    moved = model.replace("planetary_stages.set.pin_errors.planet_1.tangential", "-30 um")
    assert moved.bodies["planet_1"].origin == pytest.approx((0.09, -30e-6, 0.0), abs=1e-12)
    wide = model.replace("planetary_stages.set.planet.face_width", "30 mm")
    assert wide.gears["planet_3"].face_width == 0.03
    assert wide.meshes["sun-planet_2"].b_w == pytest.approx(0.03)
    more = model.replace("planetary_stages.set.planets", 4)
    assert "planet_4-ring" in more.meshes
    with pytest.raises(
        ModelError, match=r"gears.planet_1: belongs to the planetary stage set; replace keys of"
    ):
        model.replace("gears.planet_1.face_width", "20 mm")
    assert model.replace("gears.sun.face_width", "30 mm").gears["planet_1"].face_width == 0.04


def test_errors_and_single_planets_that_the_file_does_not_have():
    """A new component by one of its keys; the others have their defaults."""
    model = loads_model(stage_file("planets: 3", sun="planar"))
    at = "planetary_stages.set.pin_errors"
    both = {f"{at}.planet_1.tangential": "20 um", f"{at}.planet_3.radial": "-10 um"}
    assert model.replace_all(both) == loads_model(stage_file(ERRORS, sun="planar"))
    single = model.replace("planetary_stages.set.single_planets.planet_2.sun_mesh.damper.ratio", 0.1)
    assert single.meshes["sun-planet_2"].damper.ratio == 0.1
    for path, words in (
        (f"{at}.planet_9.radial", "is not a planet of the stage"),
        (f"{at}.planet_1.radius", "pin_errors.planet_1.radius: is an unknown key; did you mean radial"),
    ):
        with pytest.raises(ModelError, match=words):
            model.replace(path, "10 um")


def test_a_fault_of_one_planet():
    crack = "{type: root_crack, tooth: 3, flank: left, depth: 3 mm}"
    more = f"planets: 3\nsingle_planets: {{planet_2: {{faults: {{crack: {crack}}}}}}}"
    law = "stiffness: {law: din3990}, damper: {ratio: 0.05}"
    model = loads_model(stage_file(more, mesh=law))
    assert list(model.gears["planet_2"].faults) == ["crack"]
    assert not model.gears["planet_1"].faults
    deeper = model.replace("planetary_stages.set.single_planets.planet_2.faults.crack.depth", "2 mm")
    assert deeper.gears["planet_2"].faults["crack"].depth == pytest.approx(2e-3)


def test_sun_and_carrier_follow_from_the_axis():
    """Bodies without position are on the axis of the stage: the carrier does not take the place of a pin."""
    text = stage_file().replace("motion: torsion, position: [0, 0, 0]", "motion: torsion")
    text = text.replace("mass: 10 kg, position: [0, 0, 0]", "mass: 10 kg").replace(
        "motion: fixed, position: [0, 0, 0]", "motion: fixed, position: [1 m, 2 m, 3 m]"
    )
    model = loads_model(text)
    for name in ("sun", "carrier", "ring"):
        assert model.bodies[name].origin == pytest.approx((1.0, 2.0, 3.0), abs=1e-15)
    assert model.bodies["planet_1"].origin == pytest.approx((1.09, 2.0, 3.0), abs=1e-12)


@pytest.mark.parametrize(("absent", "kept"), [("sun", "ring"), ("ring", "sun")])
def test_planets_with_one_central_gear(absent, kept):
    text = stage_file().replace(f"    {absent}: {absent}\n", "")
    body = f"  {absent}: {{gears: [{absent}]"
    text = "\n".join(line for line in text.split("\n") if not line.startswith(body))
    text = "\n".join(line for line in text.split("\n") if not line.startswith(f"  {absent}: {{"))
    if absent == "sun":
        text = text.replace("motor: {body: sun", "motor: {body: planet_1").replace(
            "speed: {sun:", "speed: {carrier:"
        )
        text = text.replace("mesh: sun-planet_1", "mesh: planet_1-ring")
    model = loads_model(text)
    assert len(model.meshes) == 3
    assert all(kept in mesh.gears for mesh in model.meshes.values())
    assert model.bodies["planet_2"].origin == pytest.approx(
        (0.09 * math.cos(2 * math.pi / 3), 0.09 * math.sin(2 * math.pi / 3), 0.0), abs=1e-12
    )


@pytest.mark.parametrize(
    ("teeth", "sequence"),
    [
        ((48, 16, 80), (0.0, 0.0, 0.0, 0.0)),
        ((51, 17, 85), (0.0, 0.75, 0.5, 0.25)),
        ((54, 18, 90), (0.0, 0.5, 0.0, 0.5)),
    ],
)
def test_phases_that_check_shows(teeth, sequence):
    """Cases of PL-PHASE: frac(z_s n/N) for the sun, and its opposite for the ring; either sign, as cases.md
    does not say which way the planets are counted."""
    sun, planet, ring = teeth
    gear = TEETH.replace("3 mm", "4 mm") + ", normal_pressure_angle: 25 deg"
    text = stage_file("planets: 4").replace(", tip_diameter: 292.5 mm", "")
    for old, new in ((39, planet), (21, sun), (99, ring)):
        text = text.replace(f"number_of_teeth: {old}, {TEETH}", f"number_of_teeth: {new}, {gear}")
    rows = stages_of_model(loads_model(text))["set"]["planets"].values()
    for side in ("sun", "ring"):
        phases = np.array([row["phases"][side] for row in rows])
        off = [np.abs((phases - sign * np.array(sequence) + 0.5) % 1.0 - 0.5).max() for sign in (1, -1)]
        assert min(off) < 1e-8, (side, phases)


# --- what is refused ----------------------------------------------------------------------------------------
def refused(text):
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    return [str(p) for p in caught.value.problems]


def test_teeth_that_cannot_be_assembled_at_equal_angles():
    """(21 + 99)/7 = 17.14; the nearest angles are multiples of 3 deg."""
    problem, overlap = refused(stage_file("planets: 7"))
    assert "overlap" in overlap
    assert problem.startswith(
        "planetary_stages.set.planets (line 12): 7 cannot be assembled at equal angles: (21 + 99)/7 = 17.1429"
    )
    assert "give angles: [0 deg, 51 deg, 102 deg, 153 deg, 207 deg, 258 deg, 309 deg]" in problem
    assert "or 6 planets" in problem


def test_the_offered_angles_are_accepted_up_to_overlap():
    assert loads_model(stage_file("angles: [0 deg, 87 deg, 180 deg, 267 deg]")).phasing.loops_close
    (problem,) = refused(stage_file("angles: [0 deg, 88 deg, 180 deg, 267 deg]"))
    assert "a planet is 1 deg off the nearest possible angle" in problem
    assert "give angles: [0 deg, 87 deg, 180 deg, 267 deg]" in problem
    assert possible_angles((0.0, math.radians(88.0)), 120)[1] == pytest.approx(math.radians(87.0))


def test_angles_without_unit_are_said_to_be_in_radians():
    (problem,) = refused(stage_file("angles: [0, 87, 180, 267]"))
    assert "87 has no unit and is read as 87 rad = 4984.7 deg; write 87 deg" in problem
    assert "give angles" not in problem


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (
            "tangential: 20",
            "tangential (line 13): 20 m is more than the bottom clearance of the teeth (limit ",
        ),
        ("radial: 0.02", "radial (line 13): 20 mm is more than"),
        ("tangential: -20 mm", "tangential (line 13): -20 mm is more than"),
    ],
)
def test_a_pin_error_in_the_wrong_unit_is_named_alone(error, words):
    """The limit is the bottom clearance of ISO 53, a quarter of the module."""
    (problem,) = refused(stage_file(f"planets: 3\npin_errors: {{planet_2: {{{error}}}}}"))
    assert f"planetary_stages.set.pin_errors.planet_2.{words}" in problem
    assert "= 0.25 m_n, either sign)" in problem and "write 20 um, for instance" in problem
    assert ("a bare number is in metres" in problem) is ("mm" not in error)


def test_pin_errors_up_to_the_clearance_are_valid():
    for error in ("tangential: 0.3 mm", "radial: -0.3 mm"):
        loads_model(stage_file(f"planets: 3\npin_errors: {{planet_2: {{{error}}}}}", sun="planar"))


def test_a_stage_with_unreadable_parameters_has_no_consequences():
    """Meshes, pins and gears of the planets exist, although their module is unknown."""
    text = stage_file().replace("normal_module: 3 mm", "normal_module: sin", 3)
    (problem,) = refused(
        "parameters: {sin: 3 mm}\n" + text.replace("mesh: sun-planet_1", "mesh: planet_1-ring")
    )
    assert problem.startswith("parameters.sin (line 1): is a function or constant of formulas")


def test_planets_that_overlap():
    """Five planets of 123 mm tip diameter on a circle of 90 mm: 2 90 sin 36 deg = 105.80 mm."""
    (problem,) = refused(stage_file("planets: 5"))
    assert "makes planet_1 and planet_2 overlap by 17.2 mm at their tips" in problem


def test_different_centre_distances_are_a_difference():
    ring = f"ring: {{type: internal, number_of_teeth: 99, {TEETH}"
    text = stage_file().replace(ring, f"{ring.removesuffix('0')}-0.2")
    problems = refused(text)
    assert "planetary_stages.set.center_distance" in problems[0]
    assert "0.5" in problems[0] and "than 90 mm from that of sun" in problems[0]
    given = loads_model(text.replace("planets: 3", "planets: 3\n    center_distance: 90 mm"))
    assert given.meshes["planet_1-ring"].a_w == pytest.approx(-0.09)


def test_what_does_not_exist_is_named_once():
    problems = refused(stage_file().replace("    sun: sun", "    sun: sum"))
    assert problems[0].startswith(
        "planetary_stages.set.sun (line 6): names the gear 'sum', which does not exist; did you mean sun?"
    )
    (problem,) = refused(stage_file("planets: 3\npin_errors: {planet_4: {radial: 1 um}}"))
    assert "planetary_stages.set.pin_errors.planet_4" in problem
    assert "its planets are planet_1, planet_2, planet_3" in problem
    (problem,) = refused(stage_file("planets: 3\nbearing: {stiffness: {radial: 1e9 N/m}}"))
    assert "has no effect: planets with motion: torsion cannot move on their pins" in problem


def test_a_name_that_is_taken():
    other = f"gears:\n  planet_2: {{number_of_teeth: 20, {TEETH}}}\n"
    (problem,) = refused(stage_file().replace("gears:\n", other, 1))
    assert "needs the name planet_2, which gears.planet_2 has already" in problem


def test_problems_of_the_planet_gear_are_at_its_key_and_told_once():
    problems = refused(
        stage_file().replace(
            "    planet: {number_of_teeth: 39,", "    planet: {number_of_teeth: 39, rim_thickness: 90 mm,"
        )
    )
    assert len(problems) == 1
    assert problems[0].startswith("planetary_stages.set.planet.rim_thickness (line 9)")


def test_a_warning_about_all_planets_is_told_once_whatever_their_pin_errors():
    """Limits differ by the distance of each pin."""
    model = loads_model(stage_file(ERRORS, mesh=BACKLASH))
    told = [
        Message(
            f"meshes.{mesh}.gears", f"reaches below the root of planet_{k}", "tip of ring", f"{38 + k} mm"
        )
        for k, mesh in enumerate(model.planetary_stages["set"].groups[1].names, start=1)
    ]
    (only,) = at_stages(model, told)
    assert (only.where, only.limit) == ("planetary_stages.set", "39 mm")


def test_planets_off_the_shaft_of_their_carrier_are_named_at_the_carrier():
    """The stage has no keys for the places of pins and bearings."""
    shaft = "shafts:\n  carrier: {sections: [{length: 80 mm, diameter: 60 mm}], position: [0, 0, 30 mm]}\n"
    body = "  carrier: {inertia: 0.1 kg m^2, mass: 10 kg, position: [0, 0, 0]}\n"
    text = stage_file(f"planets: 3\nmotion: planar\nbearing: {{{PIN_BEARING}}}")
    assert body in text
    problems = refused(text.replace(body, "") + shaft)
    assert [p.partition(" (")[0] for p in problems] == ["planetary_stages.set.carrier"], problems


def test_pin_and_bearing_in_series():
    bearing = PlanetBearing(stiffness=Stiffness6(radial=6e8, axial=1e8), pin_stiffness=3e8)
    matrix = np.array(bearing.on_pin().matrix6())
    assert np.diag(matrix) == pytest.approx([2e8, 2e8, 1e8, 0.0, 0.0, 0.0], rel=1e-15)
    assert PlanetBearing(stiffness=Stiffness6(radial=6e8)).on_pin() == Stiffness6(radial=6e8)


SINGLE = """planets: 3
single_planets:
  planet_2:
    sun_mesh: {backlash: {normal: 200 um}, transmission_error: {cosine: [2 um]}}
    ring_mesh:
      backlash: {normal: 120 um}
    faults:
      crack: {type: root_crack, tooth: 3, flank: left, depth: 3 mm}
"""


def test_meshes_of_one_planet_have_their_own_settings():
    """The others, and keys that are not given, are those of the stage; as in a set written by hand."""
    stage = loads_model(stage_file(SINGLE, mesh=BACKLASH))
    gaps = {name: mesh.backlash.normal for name, mesh in stage.meshes.items()}
    assert gaps.pop("sun-planet_2") == pytest.approx(200e-6)
    assert gaps.pop("planet_2-ring") == pytest.approx(120e-6)
    assert set(gaps.values()) == {80e-6}
    assert stage.meshes["sun-planet_2"].transmission_error.cosine == (2e-6,)
    assert stage.meshes["planet_2-ring"].transmission_error is None
    assert stage.meshes["sun-planet_2"].law == stage.meshes["sun-planet_1"].law
    assert stage.meshes["sun-planet_2"].damper == stage.meshes["sun-planet_1"].damper
    again = loads_model(model_text(stage))
    assert again == stage
    assert again.meshes == stage.meshes
    wider = stage.replace("planetary_stages.set.single_planets.planet_2.sun_mesh.backlash.normal", "0.3 mm")
    assert wider.meshes["sun-planet_2"].backlash.normal == pytest.approx(3e-4)
    hand = by_hand(mesh=BACKLASH)
    for mesh, gap in (
        ("sun-planet_2: {gears: [sun, planet_2]", 200),
        ("planet_2-ring: {gears: [planet_2, ring]", 120),
    ):
        head, _, tail = hand.partition(mesh)
        hand = head + mesh + tail.replace("normal: 80 um", f"normal: {gap} um", 1)
    one, two = (
        values(solve_equilibrium(compile_model(loads_model(text))))
        for text in (
            stage_file(
                SINGLE.replace(", transmission_error: {cosine: [2 um]}", "").partition("    faults")[0],
                mesh=BACKLASH,
            ),
            hand,
        )
    )
    for name in two:
        assert one[name] == pytest.approx(two[name], rel=1e-8, abs=1e-5), name


def test_problems_of_a_single_planet_are_at_its_keys():
    text = stage_file(SINGLE, mesh=BACKLASH)
    deep = next(line for line, words in enumerate(text.split("\n"), start=1) if "crack" in words)
    (problem,) = refused(text.replace("depth: 3 mm", "depth: 300 mm"))
    assert problem.startswith(
        f"planetary_stages.set.single_planets.planet_2.faults.crack.depth (line {deep})"
    )
    (other,) = refused(text.replace("planet_2:\n", "planet_7:\n"))
    assert "single_planets.planet_7" in other


def test_components_of_planets_have_the_lines_of_their_stage():
    """Of failed computations, too: the coordinate planet_2.spin and the mesh sun-planet_2."""
    text = stage_file(SINGLE, mesh=BACKLASH)
    model = loads_model(text)
    line = {
        words: number
        for number, text_of in enumerate(text.split("\n"), start=1)
        for words in ("set:", "planet:", "sun_mesh:", "    ring_mesh:", "crack:", "sun_mesh: {backlash")
        if words in text_of
    }
    assert model.line(("bodies", "planet_2")) == line["set:"]
    assert model.line(("gears", "planet_1")) == line["planet:"]
    assert model.line_of("gears.planet_2.faults.crack.depth") == line["crack:"]
    assert model.line(("meshes", "sun-planet_2", "backlash")) == line["sun_mesh: {backlash"]
    system = compile_model(model)
    assert source(system, "gear_mesh", "sun-planet_3").startswith("meshes.sun-planet_3 (line ")
    assert coordinate_source(system, "planet_2.spin") == f"planet_2.spin (line {line['set:']})"
