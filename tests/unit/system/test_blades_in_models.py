# SPDX-License-Identifier: Apache-2.0
"""Rotors with a blade of lists or of a windIO file, and beams of BeamDyn and windIO files, in models."""

from __future__ import annotations

import os
import shutil
from dataclasses import replace

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.core.provenance import content_hash
from pitchpoint.geometry.rotor.blade import Rotor
from pitchpoint.geometry.rotor.flow import RotorFlow
from pitchpoint.io.yaml_model import dump_model, load_model, loads_model
from pitchpoint.model.beam_tables import beam_table_of
from pitchpoint.model.remarks.collect import remarks_of_file
from pitchpoint.model.rotor_input import rotor_input
from pitchpoint.model.windio.rotor import read_windio_rotor
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.rotor_performance import solve_rotor_performance
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.beamdyn import matrices, write_beamdyn
from tests.support.rotors import AERODYN, AIRFOILS, BLADE, FOLDER, aerodyn
from tests.support.windio import VERSION_1

SPEED, TURNS = 8.0, 0.95
HUB = """\
bodies:
  hub: {inertia: 4.37e7 kg m^2, position: [-5 m, 0, 90 m], axes: {z: [1, 0, 0], x: [0, 0, 1]}}
winds:
  steady: {speed: 8 m/s, height: 90 m, profile: uniform}
wind_rotors:
  rotor:
    hub: hub
"""


def loads(model):
    """Thrust [N] and torque [N m] at a given speed."""
    system = compile_model(model)
    state = system.initial_state()
    state.v[system.spin("hub")] = TURNS
    row = evaluate.observe(system, state)
    return [float(row[system.layout.channel(f"{word}[rotor]")]) for word in ("rotor_thrust", "rotor_torque")]


def listed(values, unit):
    return "[" + ", ".join(f"{float(v)!r} {unit}" for v in values) + "]"


def blade_text(own_tables: bool) -> str:
    """Blade of the NREL 5 MW as lists, its polars from files or as tables."""
    blade = aerodyn().blade
    names = [polar.name for polar in blade.polars]
    lines = ["    hub_radius: 1.5 m", "    precone: 2.5 deg", "    blade:"]
    for key, values, unit in (
        ("radius", blade.span + 1.5, "m"),
        ("chord", blade.chord, "m"),
        ("twist", np.degrees(blade.twist), "deg"),
        ("prebend", blade.prebend, "m"),
        ("sweep", blade.sweep, "m"),
    ):
        lines.append(f"      {key}: {listed(values, unit)}")
    lines.append(f"      airfoils: [{', '.join(names[k] for k in blade.polar_index)}]")
    lines.append("      polars:")
    for polar in blade.polars:
        if own_tables:
            lines.append(f"        {polar.name}:")
            lines.append(f"          angle: {listed(np.degrees(polar.alpha), 'deg')}")
            for key in ("lift", "drag", "moment"):
                lines.append(f"          {key}: {[float(v) for v in getattr(polar, key)]}")
        else:
            lines.append(f"        {polar.name}: {{file: {AIRFOILS / polar.name}.dat}}")
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("own_tables", [False, True])
def test_a_blade_of_lists_is_that_of_aerodyn(own_tables):
    """NREL 5 MW, lists and polars of its files: thrust of `solve_rotor_performance`, and its torque to the
    pitching moment about the rotor axis, 0.3 %. The stations are inclined as the prebend."""
    model = loads_model(HUB + blade_text(own_tables))
    assert loads_model(dump_model(model)) == model
    blade = replace(aerodyn().blade, curve_angle=np.zeros(0))
    assert blade.curve_angle.size == 19
    rotor = Rotor(blade=blade, hub_radius=1.5, precone=np.radians(2.5))
    found = solve_rotor_performance(rotor, SPEED, TURNS, flow=RotorFlow(sectors=1))
    thrust, torque = loads(model)
    assert thrust == pytest.approx(float(found.rotor_thrust[0]), rel=1e-9)
    assert torque == pytest.approx(float(found.rotor_torque[0]), rel=5e-3)


def test_a_rotor_of_windio_has_its_hub_and_cone(tmp_path):
    """Hub radius and precone are those of the file unless they are given."""
    (tmp_path / "small.yaml").write_text(VERSION_1, encoding="utf-8")
    path = tmp_path / "model.yaml"
    path.write_text(HUB + "    windio: small.yaml\n", encoding="utf-8")
    given = read_windio_rotor(tmp_path / "small.yaml")
    flow = RotorFlow(sectors=1)
    for more, changes in (
        ("", {}),
        ("    precone: 0 deg\n    hub_radius: 2 m\n", {"precone": 0.0, "hub_radius": 2.0}),
    ):
        path.write_text(HUB + "    windio: small.yaml\n" + more, encoding="utf-8")
        rotor = replace(given.rotor, tilt=0.0, overhang=0.0, **changes)
        found = solve_rotor_performance(rotor, SPEED, TURNS, flow=flow)
        assert loads(load_model(path))[0] == pytest.approx(float(found.rotor_thrust[0]), rel=1e-9)
    path.write_text(HUB + "    windio: small.yaml\n    tower_flow: true\n", encoding="utf-8")
    assert compile_model(load_model(path)).records["blade_station"]["tower"]["n"][0] > 0


WRONG = {
    "[1.5 m, 10 m, 20 m]": ("[1.5 m, 20 m, 10 m]", "radius[2] (line 11): 10 m does not increase (limit > 20"),
    "[1.5 m,": ("[1 m,", "radius[0] (line 11): 1 m is inside the hub (limit >= 1.5 m, the hub radius)"),
    "[2 m, 2 m, 1 m]": ("[2 m, 2 m]", "chord (line 12): 2 is the number of values (limit 3 as of radius)"),
    "[2 m, 2 m": ("[2 s, 2 m", "chord[0] (line 12)"),
    "thin, thin]": ("thin, thim]", "airfoils[2] (line 14): names the polar 'thim', which does not exist"),
    "180 deg], lift: [0, 0.2": (
        "170 deg], lift: [0, 0.2",
        "polars.thin (line 16): -180 to 170 deg is the range of the angles of attack (limit -180 to 180 deg)",
    ),
    "0 deg, 180 deg], lift": ("-190 deg, 180 deg], lift", "-190 deg at point 2 does not increase"),
    "lift: [0, 0.2, 0],": ("", "polars.thin (line 16): has no lift"),
    "lift: [0, 0.2, 0]": ("lift: [0, 0.2, 0], file: thin.dat", "thin.dat"),
    "drag: [0.1, 0.01, 0.1]": ("drag: [0.1, 0.01]", "polars.thin"),
    "    hub_radius: 1.5 m\n": ("", "wind_rotors.rotor (line 6): has no hub_radius"),
    "    blade:\n": ("    tower_flow: true\n    blade:\n", "is the tower of a windIO file; give windio"),
    "    hub: hub\n": (f"    hub: hub\n    aerodyn: {AERODYN}\n", "exactly one of aerodyn, windio, blade"),
}
LISTS = """\
    hub_radius: 1.5 m
    precone: 0 deg
    blade:
      radius: [1.5 m, 10 m, 20 m]
      chord: [2 m, 2 m, 1 m]
      twist: [10 deg, 5 deg, 0 deg]
      airfoils: [thin, thin, thin]
      polars:
        thin: {angle: [-180 deg, 0 deg, 180 deg], lift: [0, 0.2, 0], drag: [0.1, 0.01, 0.1]}
"""


@pytest.mark.parametrize("word", WRONG)
def test_wrong_blades_are_told(word):
    new, words = WRONG[word]
    text = HUB + LISTS
    assert word in text
    with pytest.raises(ModelError) as error:
        loads_model(text.replace(word, new, 1))
    told = [str(p) for p in error.value.problems]
    assert any(words in each for each in told), told
    assert all(p.line for p in error.value.problems)


def test_all_problems_of_a_blade_at_once():
    text = HUB + LISTS.replace("[1.5 m, 10", "[1.5 m, 30").replace("thin, thin]", "thin, none]")
    with pytest.raises(ModelError, match="3 problems"):
        loads_model(text.replace("[2 m, 2 m, 1 m]", "[2 m]").replace("[2 m]", "[2 m, 2 m]"))


def test_a_short_polar_is_continued_as_a_stalled_plate():
    text = LISTS.replace("-180 deg, 0 deg, 180 deg", "-10 deg, 0 deg, 15 deg").replace("0.2, 0]", "0.2, 1.1]")
    with pytest.raises(ModelError, match="or give aspect_ratio"):
        loads_model(HUB + text)
    model = loads_model(HUB + text.replace("drag:", "aspect_ratio: 17, drag:"))
    thrust, _ = loads(model)
    assert thrust > 0.0


MAST = """\
bodies:
  tip: {motion: free, mass: 0.01 kg, inertia_tensor: [1e-3, 1e-3, 1e-3, 0, 0, 0], position: [0, 0, END m]}
beams:
  blade: {ends: [ground, tip], axis: [1, 0, 0], pieces: 8, properties: {PROPERTIES}}
"""


def mast(properties, length):
    return loads_model(MAST.replace("END", repr(length)).replace("PROPERTIES", properties))


def test_beams_of_files(tmp_path):
    """BeamDyn's blade and both beams of a windIO file; a length that is not that of the file is refused."""
    (tmp_path / "small.yaml").write_text(VERSION_1, encoding="utf-8")
    ontology = tmp_path / "small.yaml"
    primary = write_beamdyn(tmp_path, *matrices())
    for given, length, least, most in (
        (f"beamdyn: {primary}", 61.5, 0.67, 0.70),
        (f"windio: {ontology}, component: blade", 30.0, 3.0, 3.5),
        (f"windio: {ontology}, component: tower", 76.0, 1.1, 1.3),
    ):
        model = mast(given, length)
        assert loads_model(dump_model(model)) == model
        assert least < find_modes(compile_model(model), count=1).frequency[0] < most
        with pytest.raises(ModelError, match=rf"the ends \(limit {length:g} m as in the f"):
            compile_model(mast(given, 1.02 * length))


@pytest.mark.parametrize(
    ("properties", "words"),
    [
        ("windio: FILE", "component"),
        ("component: tower", "windio"),
        ("windio: FILE, component: nacelle", "blade, tower"),
        ("windio: FILE, component: tower, beamdyn: FILE", "is given together with beamdyn"),
        ("windio: FILE, component: tower, mass: [1, 1], position: [0, 1]", "is in the file too"),
        ("beamdyn: FILE", "is not a primary file of BeamDyn"),
    ],
)
def test_wrong_files_of_beams_are_told(tmp_path, properties, words):
    file = tmp_path / "small.yaml"
    file.write_text(VERSION_1, encoding="utf-8")
    with pytest.raises(ModelError, match=words):
        compile_model(mast(properties.replace("FILE", str(file)), 76.0))


def test_forces_beside_the_shear_centre_twist_and_beside_the_elastic_centre_bend():
    """Force along x at y = 0, shear centre at y = 0.1 m: twist F e L/(G J). Tension at x = 0, elastic centre
    at x = 0.05 m: deflection N e L^2/(2 E I) to this side. Neither force does what the other one does."""
    plain = "position: [0, 1], mass: [3, 3], bending_1: [20, 20], bending_2: [20, 20], torsion: [5, 5]"
    centres = ", axial: [1e4, 1e4], shear_1: [1e6, 1e6], shear_2: [1e6, 1e6]"
    centres += ", elastic_1: [0.05 m, 0.05 m], shear_center_1: [0, 0], shear_center_2: [0.1 m, 0.1 m]"
    moved = {}
    for name, force in (("across", "[1e-3 N, 0, 0]"), ("along", "[0, 0, 1e-3 N]")):
        model = mast(plain + centres, 2.0)
        model = loads_model(dump_model(model) + f"loads: {{push: {{body: tip, force: {force}}}}}\n")
        system = compile_model(model)
        rest = find_equilibrium(system).state
        moved[name] = {c: rest.q[system.layout.coordinate(f"tip.{c}")] for c in ("x", "y", "spin")}
    assert moved["across"]["spin"] == pytest.approx(1e-3 * 0.1 * 2.0 / 5.0, rel=1e-3)
    assert moved["along"]["x"] == pytest.approx(1e-3 * 0.05 * 2.0**2 / (2.0 * 20.0), rel=1e-3)
    assert abs(moved["along"]["spin"]) < 1e-3 * moved["across"]["spin"]
    assert moved["across"]["x"] == pytest.approx(1e-3 * 8.0 / 60.0 + 0.1 * moved["across"]["spin"], rel=1e-3)


def test_offset_of_a_beam_is_its_prebend():
    """Clamped uniform mast with its axis bent by 0.3 m: the static deflection across the bend is larger by
    the torsion of the arm; the mass is that of the longer curve."""
    plain = "position: [0, 0.5, 1], mass: [3, 3, 3], bending_1: [20, 20, 20], bending_2: [20, 20, 20]"
    straight = mast(plain, 2.0)
    bent = mast(f"{plain}, torsion: [5, 5, 5], offset_1: [0, 0.1 m, 0.3 m]", 2.0)
    masses = [
        sum(float(r["mass"]) for r in compile_model(model).records["beam"]) for model in (straight, bent)
    ]
    longer = np.hypot(1.0, 0.1) + np.hypot(1.0, 0.2)
    assert masses == pytest.approx([6.0, 3.0 * longer])
    first = [find_modes(compile_model(model), count=2).frequency for model in (straight, bent)]
    assert (np.asarray(first[1]) < np.asarray(first[0])).all()


def test_blade_of_the_page(tmp_path):
    """The blade as lists of docs/howto/wind_turbine.md."""
    page = (FOLDER.parents[2] / "docs" / "howto" / "wind_turbine.md").read_text(encoding="utf-8")
    block = next(b for b in page.split("```yaml\n")[1:] if "aspect_ratio" in b).partition("```")[0]
    block = block.replace("DU30_A17.dat", str(AIRFOILS / "DU30_A17.dat"))
    thrust, torque = loads(loads_model(HUB[: HUB.index("wind_rotors")] + block))
    assert 0.0 < torque < 50.0 * thrust


def test_exit_codes(tmp_path, capsys):
    """Code 2 and one sentence with file and line: `check` of a rotor whose blade file is missing or whose
    windIO file is cut off, and a run with a box of turbulence that is cut off."""
    shutil.copytree(FOLDER, tmp_path / "nrel")
    (tmp_path / "nrel" / "5MW_Baseline" / BLADE.name).unlink()
    path = tmp_path / "model.yaml"
    path.write_text(HUB + "    hub_radius: 1.5 m\n    aerodyn: nrel/onshore/AeroDyn.dat\n", encoding="utf-8")
    assert run_command(["check", str(path)]) == 2
    assert f"{BLADE.name} (AeroDyn.dat, line 60): cannot be read" in capsys.readouterr().err
    (tmp_path / "cut.yaml").write_text(VERSION_1[:1500], encoding="utf-8")
    path.write_text(HUB + "    windio: cut.yaml\n", encoding="utf-8")
    assert run_command(["check", str(path)]) == 2
    assert "(cut.yaml, line" in capsys.readouterr().err
    (tmp_path / "small.yaml").write_text(VERSION_1, encoding="utf-8")
    (tmp_path / "box.bts").write_bytes(bytes(40))
    text = HUB.replace("{speed: 8 m/s, height: 90 m, profile: uniform}", "{box: box.bts}")
    text += "    windio: small.yaml\nscenarios:\n  run: {speed: {hub: 9 rpm}, duration: 1 s, step: 20 ms}\n"
    path.write_text(text, encoding="utf-8")
    assert run_command(["run", str(path)]) == 2
    assert "box.bts: header: 40 bytes are there: the file is cut off" in capsys.readouterr().err


def test_the_place_of_the_hub_is_that_of_the_model(tmp_path):
    """A windIO file without hub height and with a senseless tilt has the same blades."""
    found = []
    for text in (
        VERSION_1,
        VERSION_1.replace("hub_height: 80.0, ", "").replace("uptilt: 0.08", "uptilt: up"),
    ):
        file = tmp_path / f"{len(found)}.yaml"
        file.write_text(text, encoding="utf-8")
        rotor = rotor_input(loads_model(HUB + f"    windio: {file}\n").wind_rotors["rotor"]).rotor
        found.append((rotor.blade.sweep.tolist(), rotor.hub_radius, rotor.precone, rotor.hub_height))
    assert found[0] == found[1]
    file.write_text(VERSION_1.replace("relative_thickness: 0.4", "relative_thickness: 0.2"), encoding="utf-8")
    model = loads_model(HUB + f"    windio: {file}\n")
    remark = (
        "wind_rotors.rotor.windio (line 8): airfoil thin: not used, as thick has the same relative thickness"
    )
    assert remark in [str(each) for each in remarks_of_file(model)]
    file.write_text(text, encoding="utf-8")
    with pytest.raises(ModelError, match="2 problems"):
        read_windio_rotor(file)


def test_a_changed_blade_file_of_beamdyn_is_another_model(tmp_path):
    """The primary file names it: its content is in the hash, and it is read again."""
    primary = write_beamdyn(tmp_path, *matrices())
    model = mast(f"beamdyn: {primary}", 61.5)
    (properties,) = (beam.properties for beam in model.beams.values())
    hash_before, mass = content_hash(model), beam_table_of(properties).inertia
    assert content_hash(model) == hash_before
    stiffness, inertia = matrices()
    write_beamdyn(tmp_path, stiffness, 2.0 * inertia)
    os.utime(tmp_path / "Blade.dat", ns=(1, 1))  # files of one instant have one time
    assert beam_table_of(properties).inertia == pytest.approx(2.0 * mass)
    assert content_hash(model) != hash_before
    write_beamdyn(tmp_path, stiffness, inertia)
    os.utime(tmp_path / "Blade.dat", ns=(2, 2))
    assert content_hash(model) == hash_before
    (tmp_path / "Blade.dat").unlink()
    assert content_hash(model) != hash_before


@pytest.mark.parametrize(
    ("pattern", "old", "new"),
    [
        ("**/*AeroDyn_blade.dat", "3.542", "3.642"),
        ("**/Cylinder1.dat", "0.5000", "0.7000"),
    ],
)
def test_a_changed_file_that_aerodyn_names_is_another_model(tmp_path, pattern, old, new):
    shutil.copytree(FOLDER, tmp_path, dirs_exist_ok=True)
    text = HUB + f"    aerodyn: {tmp_path / AERODYN.relative_to(FOLDER)}\n    hub_radius: 1.5 m\n"
    model = loads_model(text)
    blade, hash_before = rotor_input(model.wind_rotors["rotor"]).rotor.blade, content_hash(model)
    (file,) = tmp_path.glob(pattern)
    data = file.read_text(encoding="utf-8")
    assert old in data
    file.write_text(data.replace(old, new), encoding="utf-8")
    changed = rotor_input(model.wind_rotors["rotor"]).rotor.blade
    assert content_hash(model) != hash_before
    drag = [b.polars[0].drag.tolist() for b in (blade, changed)]
    assert blade.chord.tolist() != changed.chord.tolist() or drag[0] != drag[1]
