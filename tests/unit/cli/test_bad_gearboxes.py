# SPDX-License-Identifier: Apache-2.0
"""Mistakes in planetary stages, clutches, scissor gears, materials, couplings, housings and lubricants.

Every case is an example with one edit. `check` has exactly the messages that are listed, at their keys: a
mistake has no consequential problems, and exit code 2. Remarks have exit code 0.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.collect import remarks_of, remarks_of_file

ROOT = Path(__file__).parents[3]
PLANETS, SERIES, CLUTCH, SCISSOR, GEARBOX = FILES = (
    "examples/planetary-set/model.yaml",
    "examples/ravigneaux/model.yaml",
    "examples/clutch-driveline/judder.yaml",
    "docs/reference/snippets/scissor.yaml",
    "docs/reference/snippets/gearbox.yaml",
)
SET, FREE, CAST = "planetary_stages.set", "scissor_gears.free", "materials.cast"
BEARING = "{stiffness: {radial: 8e8 N/m}, damping: {ratio: 0.03}, pin_stiffness: 1.5e9 N/m}"
BRAKE = "  brake: {bodies: [engine], capacity: 60 N m}\ntorsion_springs:"


@cache
def text_of(file: str) -> str:
    return (ROOT / file).read_text(encoding="utf-8")


def edited(file: str, edit: str) -> str:
    """Text of a file with an edit `old >> new`."""
    old, new = (part.replace("\\n", "\n") for part in edit.split(" >> "))
    assert text_of(file).count(old), old
    return text_of(file).replace(old, new, 1)


ERRORS = [
    # planetary stages
    (PLANETS, "planets: 3\\n >> number_of_planets: 3\\n", f"{SET}.number_of_planets: did you mean planets?"),
    (PLANETS, "planets: 3 >> planets: 0", f"{SET}.planets: 0 is out of range"),
    (PLANETS, "planets: 3 >> planets: three", f"{SET}.planets: write 3"),
    (PLANETS, "    planets: 3\\n >> ", f"{SET}: gives none of planets, angles"),
    (PLANETS, "planets: 3 >> angles: 120 deg", f"{SET}.angles: is not a list"),
    (
        PLANETS,
        "planets: 3 >> angles: [0 deg, 120 deg, 360 deg]",
        f"{SET}.angles: planet_1 and planet_3 at the same",
    ),
    (PLANETS, "planets: 3 >> planets: 7", f"{SET}.planets: cannot be assembled", f"{SET}.planets: overlap"),
    (PLANETS, "    sun: sun >> \\n    sun: sum", f"{SET}.sun: did you mean sun?"),
    (
        PLANETS,
        "    sun: sun\\n    ring: ring >>     sun: ring\\n    ring: sun",
        f"{SET}.sun: exchange sun and ring",
    ),
    (PLANETS, "type: internal, >> type: intern,", "gears.ring.type: did you mean internal?"),
    (PLANETS, "carrier: carrier >> carrier: ring", f"{SET}.carrier: the body of the ring"),
    (PLANETS, "_teeth: 39 >> _teeth: 38", f"{SET}.center_distance: z_sun + 2 z_planet = 97 teeth, not 99"),
    (PLANETS, "_teeth: 39 >> _teeth: 40", f"{SET}.center_distance: z_sun + 2 z_planet = 101 teeth, not 99"),
    (
        PLANETS,
        "39, normal_module: 3 mm >> 39, normal_module: 2.5 mm",
        f"{SET}: unequal normal modules",
        f"{SET}: unequal normal modules",
    ),
    (
        PLANETS,
        "bore_diameter: 60 mm >> bore_diameter: 120 mm",
        f"{SET}.planet.bore_diameter: root diameter 109.39 mm",
    ),
    (
        PLANETS,
        "motion: planar\\n    bearing >> motion: plane\\n    bearing",
        f"{SET}.motion: did you mean planar?",
    ),
    (
        PLANETS,
        "motion: planar\\n    bearing >> planet_mass: 0\\n    motion: planar\\n    bearing",
        f"{SET}.planet_mass: is zero",
    ),
    (
        PLANETS,
        "stiffness: {radial: 8e8 N/m} >> stiffness: 8e8 N/m",
        f"{SET}.bearing.stiffness: write {{radial: 8e8 N/m}}",
    ),
    (PLANETS, "planets: 3 >> planets: 3\\n    planet_name: p.x", f"{SET}.planet_name: is not a usable name"),
    (
        PLANETS,
        "motion: fixed} >> motion: fixed, position: [10 mm, 0, 0]}",
        "bodies.ring.position: 10 mm is off the axis of sun",
    ),
    (PLANETS, "{mass: 12 kg, inertia: 0.12 kg m^2} >> {}", "bodies.carrier.inertia: is zero"),
    (
        PLANETS,
        "{mass: 12 kg, inertia: 0.12 kg m^2} >> {motion: fixed}",
        "loads.output.body: is fixed",
        "scenarios.steady.speed.sun: ring and carrier of its planetary stage are fixed",
    ),
    (PLANETS, "planetary_stages: >> planetary_gears:", "planetary_gears: did you mean planetary_stages?"),
    (
        PLANETS,
        "planetary_stages:\\n  set:\\n >> planetary_stages:\\n  - set:\\n",
        "planetary_stages: NAME: {...}",
    ),
    (
        PLANETS,
        "sun_mesh: {stiff >> sun_mesh: {backlash: {normal: -2 mm}, stiff",
        f"{SET}.sun_mesh.backlash: limit >= -0.3 mm",
    ),
    (
        PLANETS,
        "sun_mesh: {stiff >> sun_mesh: {backlash: {normal: 80 mm}, stiff",
        f"{SET}.sun_mesh.backlash: the base pitch",
    ),
    (
        PLANETS,
        "bearings:\\n >>   two:\\n    {sun: sun, carrier: carrier, planets: 3, planet: {number_of_teeth: 39, "
        "normal_module: 3 mm, face_width: 40 mm, profile_shift_coefficient: 0}}\\nbearings:\\n",
        "planetary_stages.two.planet_name: is also the planet_name of set",
    ),
    (
        SERIES,
        "large_sun], position: [0, 0, 0] >> large_sun], position: [1 mm, 0, 0]",
        "bodies.large_sun.position: 1 mm is off the axis of small_sun",
    ),
    (
        SERIES,
        "inner_planets: short >> inner_planets: shorts",
        "planetary_stages.long.inner_planets: mean short?",
    ),
    (
        SERIES,
        "18, normal_module: teeth, face_width: 45 mm >> 18, normal_module: 2, face_width: 45 mm",
        "planetary_stages.long.planet.normal_module: write 2 mm",
    ),
    # clutches and brakes
    (CLUTCH, "capacity: 60 N m >> torque: 60 N m", "clutches.clutch.torque: did you mean capacity?"),
    (CLUTCH, "capacity: 60 N m >> capacity: 60 N/m", "clutches.clutch.capacity: a torque such as 150 N m"),
    (CLUTCH, "capacity: 60 N m >> capacity: -60 N m", "clutches.clutch.capacity: friction always brakes"),
    (CLUTCH, "capacity: 60 N m >> capacity: 60 N m * slip", "clutches.clutch.capacity: unknown name 'slip'"),
    (CLUTCH, "[engine, disc], >> [engine, pinion],", "clutches.clutch.bodies: name its body, disc"),
    (CLUTCH, "[engine, disc], >> [engine, ground],", "clutches.clutch.bodies: give one body only"),
    (CLUTCH, "static_ratio: 1.5, >> static_ratio: 0.8,", "clutches.clutch.static_ratio: limit >= 1"),
    (CLUTCH, "clutches:\\n >> brakes:\\n", "brakes: did you mean clutches?"),
    (CLUTCH, "creep: { >> creep: {engaged: [cluch], ", "scenarios.creep.engaged: did you mean clutch?"),
    (
        CLUTCH,
        "creep: { >> creep: {engaged: [clutch], ",
        "scenarios.creep.drive.engine.speed: with clutch engaged",
    ),
    # scissor gears
    (SCISSOR, "gear: cam, >> gear: camm,", f"{FREE}.gear: did you mean cam?"),
    (SCISSOR, "torque: -15 N m >> torque: 0 N m", f"{FREE}.torque: is zero"),
    (SCISSOR, "40 N m/rad >> 40 N/mm", f"{FREE}.stiffness: write a torsional stiffness"),
    (SCISSOR, "friction: 0.5 N m >> friction: {mu: 0.1}", f"{FREE}.friction: write 0.5 N m"),
    (
        SCISSOR,
        "friction: 0.5 >> hub_damping: {radial: 10}, friction: 0.5",
        f"{FREE}.hub_damping: requires hub_stiffness",
    ),
    (
        SCISSOR,
        "meshes: >>   two: {gear: cam, face_width: 6 mm, torque: 9, stiffness: 40}\\nmeshes:",
        "two.position: a free half of the same gear",
    ),
    (
        SCISSOR,
        "meshes: >>   two: {gear: free, face_width: 6 mm, torque: 9, stiffness: 40}\\nmeshes:",
        "two.gear: is part of scissor_gears.free",
    ),
    # materials
    (GEARBOX, "youngs_modulus: 170 GPa >> E: 170 GPa", f"{CAST}.E: did you mean youngs_modulus?"),
    (GEARBOX, "poisson_ratio: 0.28, >> ", f"{CAST}.poisson_ratio: is missing"),
    (GEARBOX, "materials: >> material:", "material: did you mean materials?"),
    (GEARBOX, "poisson_ratio: 0.28 >> poisson_ratio: 28", f"{CAST}.poisson_ratio: limit >= 0 and < 0.5"),
    # couplings
    (
        GEARBOX,
        "bodies: [motor, input], >> ends: [motor, input],",
        "couplings.flange.ends: did you mean bodies?",
    ),
    (
        GEARBOX,
        "[motor, input], >> [motor, ground],",
        "couplings.flange.bodies: use torsion_springs or bushings",
    ),
    (GEARBOX, "[motor, input], >> [motor, pinion],", "couplings.flange.bodies: name its body, input"),
    (
        GEARBOX,
        "damping: {torsion: 1 N m s/rad} >> damping: 0.05",
        "couplings.flange.damping: write {ratio: 0.05}",
    ),
    (
        GEARBOX,
        "input], position: [0, 0, 0] >> input], position: [0, 0]",
        "couplings.flange.position: write [x, y, z]",
    ),
    # housing
    (GEARBOX, "mass: 60 kg >> mass: -60 kg", "housing.mass: write 60 kg"),
    (GEARBOX, "[0.8, 0.9, 0.7, 0, 0, 0] >> [0.8, 0.9, 0.7]", "housing.inertia_tensor: limit 6 entries"),
    (
        GEARBOX,
        "  inertia_tensor: [0.8, 0.9, 0.7, 0, 0, 0] >>   inertia: 0.8",
        "housing.inertia: did you mean inertia_tensor?",
    ),
    (GEARBOX, "  mounts: >>   feet:", "housing.feet: did you mean mounts?"),
    # lubricant
    (
        GEARBOX,
        "temperature: 60 degC >> temperature: '60'",
        "lubricant.temperature: a bare number is in kelvin; write 60 degC",
    ),
    (GEARBOX, "temperature: 75 degC >> temperature: 75", "load_cases.peak.temperature: write 75 degC"),
    (GEARBOX, "grade: ISO VG 220, >> grade: 220,", "lubricant.grade: did you mean ISO VG 220?"),
    (
        GEARBOX,
        "ISO VG 220, >> ISO VG 220, viscosity_at_40_degree_celsius: 320 mm^2/s,",
        "lubricant.viscosity_at_40_degree_celsius: contradicts the grade",
    ),
    (
        GEARBOX,
        "ISO VG 220, >> ISO VG 220, density_at_15_degree_celsius: 0.89,",
        "lubricant.density_at_15_degree_celsius: write 890 kg/m^3",
    ),
    (
        GEARBOX,
        "ISO VG 220, >> ISO VG 220, pressure_viscosity: 22,",
        "lubricant.pressure_viscosity: write 22 1/GPa",
    ),
    (GEARBOX, "lubricant: >> oil:", "oil: did you mean lubricant?"),
]


@pytest.mark.parametrize(("file", "edit", "expected"), [(e[0], e[1], e[2:]) for e in ERRORS])
def test_a_mistake_is_named_alone(file, edit, expected):
    with pytest.raises(ModelError) as caught:
        loads_model(edited(file, edit))
    found = list(caught.value.problems)
    assert len(found) == len(expected), list(map(str, found))
    for words in expected:
        place, _, rest = words.partition(": ")
        fits = [p for p in found if f".{p.where}".endswith(f".{place}") and rest in str(p)]
        assert fits and all(p.line is not None for p in fits), (words, list(map(str, found)))


REMARKS = [
    (
        PLANETS,
        f"    bearing: {BEARING}\\n >> ",
        f"{SET}.bearing: nothing holds planet_1, planet_2 and planet_3",
    ),
    (
        PLANETS,
        "damping: {ratio: 0.03}, pin >> damping: {ratio: 3}, pin",
        f"{SET}.bearing.damping.ratio: 300 %",
    ),
    (
        PLANETS,
        "    sun_mesh: >>     planet_mesh: {stiffness: {law: din3990}}\\n    sun_mesh:",
        f"{SET}.planet_mesh: no effect without inner_planets",
    ),
    (PLANETS, "    ring: ring\\n >> ", f"{SET}.ring_mesh: no effect without ring"),
    (PLANETS, "planets: 3 >> planets: 3\\n    planet_side: clockwise", f"{SET}.planet_side: no effect"),
    (
        PLANETS,
        "sun_mesh: {stiff >> sun_mesh: {contact: {level: rigid}, stiff",
        f"{SET}.sun_mesh.stiffness: no effect with contact, level: rigid",
    ),
    (
        PLANETS,
        "sun_mesh: {stiff >> sun_mesh: {backlash: {normal: -80 um}, stiff",
        f"{SET}.sun_mesh: both flanks are in contact",
    ),
    (CLUTCH, "capacity: 60 N m >> capacity: 0", "clutches.clutch.capacity: always open"),
    (CLUTCH, "capacity: 60 N m >> capacity: 60 N m * cos(10*t)", "clutches.clutch.capacity: down to -60 N m"),
    (
        CLUTCH,
        "stribeck_speed: 60 rad/s, >> ",
        "clutches.clutch.static_ratio: no effect with stribeck_speed: 0",
    ),
    (CLUTCH, "static_ratio: 1.5, >> ", "clutches.clutch.stribeck_speed: no effect with static_ratio: 1"),
    (
        CLUTCH,
        "law: smooth >> law: smooth, wind_up: 1 deg",
        "clutches.clutch.wind_up: no effect with law: smooth",
    ),
    (
        SCISSOR,
        "torque: -15 N m >> torque: -0.01 N m",
        f"{FREE}.torque: before the free half has crossed the backlash",
    ),
    (SCISSOR, "torque: -15 N m >> torque: -15 kN m", f"{FREE}.torque: 59.68 revolutions"),
    (SCISSOR, "friction: 0.5 N m >> friction: 20 N m", f"{FREE}.friction: can stick"),
    (SCISSOR, "cam, face_width: 6 mm >> cam, face_width: 60 mm", f"{FREE}.face_width: 6 of 60 mm"),
    (GEARBOX, "170 GPa >> 170 TPa", f"{CAST}.youngs_modulus: above that of any material"),
    (GEARBOX, "7100 kg/m^3 >> 7.1", f"{CAST}.density: not that of a solid gear"),
    (GEARBOX, "poisson_ratio: 0.28 >> poisson_ratio: 0.028", f"{CAST}.poisson_ratio: below that of metals"),
    (GEARBOX, "material: cast,  >> ", f"{CAST}: is not used"),
    (
        GEARBOX,
        "{torsion: 5e3 N m/rad}, damping: {torsion: 1 N m s/rad} >> {radial: 5e6}",
        "couplings.flange.stiffness: transmits no torque",
    ),
    (
        GEARBOX,
        "lubricant: {grade: ISO VG 220, temperature: 60 degC}\\n >> ",
        "load_cases.peak.temperature: no effect without lubricant",
    ),
    (
        GEARBOX,
        "80 mm, -150 mm, 80 mm], stiffness: {radial: 5e7, axial: 5e7, tilt: 1e6, torsion: 1e6}} >> "
        "80 mm, -150 mm, 80 mm]}",
        "housing.mounts.front: neither stiffness nor damping",
    ),
]


def messages(file: str, text: str) -> list[str]:
    """Remarks on a model read from a file, as printed."""
    model = loads_model(text, file=str(ROOT / file))
    return [str(message) for message in (*remarks_of_file(model), *remarks_of(model))]


@pytest.mark.parametrize(("file", "edit", "expected"), REMARKS)
def test_what_has_no_effect_or_is_unusual_has_a_remark(file, edit, expected):
    found = messages(file, edited(file, edit))
    place, _, rest = expected.partition(": ")
    fits = [
        words for words in found if re.match(rf"{re.escape(place)} \(line \d+\): ", words) and rest in words
    ]
    assert len(fits) == 1, found


@pytest.mark.parametrize("file", FILES)
def test_the_files_themselves_have_no_remark(file):
    assert messages(file, text_of(file)) == []


def test_a_brake_on_a_driven_body(tmp_path, capsys):
    """Exit code 2 and one sentence; the power flow of `check` has no torque of such a brake."""
    text = (
        text_of(CLUTCH).replace("torsion_springs:", BRAKE).replace("creep: {", "creep: {engaged: [brake], ")
    )
    (tmp_path / "model.yaml").write_text(text, encoding="utf-8")
    assert run_command(["check", str(tmp_path / "model.yaml")]) == 2
    assert "limit 0 rpm" in capsys.readouterr().err
    varying = text.replace("{engine: {speed: 70 rad/s}}", "{engine: {speed: 70 rad/s * t/1 s}}")
    (tmp_path / "model.yaml").write_text(varying, encoding="utf-8")
    assert run_command(["check", str(tmp_path / "model.yaml"), "-q"]) == 0
