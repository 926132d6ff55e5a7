# SPDX-License-Identifier: Apache-2.0
"""Model files: what the contract files mean, YAML traps, writing and reading back."""

from __future__ import annotations

import math
import pickle
import subprocess
import sys
from pathlib import Path

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import dump_model, load_model, loads_model
from pitchpoint.model.components.law import Balance, Constant, FormulaLaw, PythonLaw, TableLaw
from pitchpoint.model.components.stiffness import Din3990, Fourier
from tests.support.model_files import ISO_EXAMPLE, TORSIONAL_PAIR, gear, pair


def test_iso_example_means_what_it_says() -> None:
    model = loads_model(ISO_EXAMPLE)
    pinion, wheel = model.gears["pinion"], model.gears["wheel"]
    assert (pinion.number_of_teeth, pinion.normal_module, pinion.tip_diameter) == (17, 0.008, 0.15966)
    assert pinion.geometry.beta == -math.radians(15.8)
    assert wheel.geometry.beta == math.radians(15.8)
    assert wheel.rack.dedendum == 1.4
    assert wheel.geometry.rack.rho_fP_star == 0.39
    stage = model.meshes["stage"]
    assert stage.stiffness == Din3990(stiffness_ratio=0.8, tip_relief_factor=0.0)
    assert stage.a_w == 0.5
    # ISO/TR 6336-30, example 1
    assert model.pairs["stage"].eps_alpha == pytest.approx(1.5491, abs=1e-4)
    assert model.bodies == {}


def test_torsional_pair_means_what_it_says() -> None:
    model = loads_model(TORSIONAL_PAIR)
    stage = model.meshes["stage"]
    assert stage.stiffness == Fourier(mean=4.0e8, cosine=(-0.2, -0.1, -0.05))
    assert model.backlash("stage") == pytest.approx(1e-4, rel=1e-15)
    assert stage.damper is not None
    assert stage.damper.ratio == 0.05
    assert stage.transmission_error is not None
    assert stage.transmission_error.cosine == (1e-6, 5e-7)
    assert model.loads["input"].torque == Constant(150.0)
    assert model.bodies["driven"].origin == (0.15, 0.0, 0.0)
    assert model.body_inertia("driver").polar == 0.0115
    steady, sweep = model.scenarios["steady"], model.scenarios["sweep"]
    assert (steady.kind, steady.duration, steady.sample_rate) == ("time", 0.5, 1e5)
    assert steady.statistics_start == pytest.approx(0.1)
    assert model.start_speeds("steady") == pytest.approx({"driver": 50 * math.pi, "driven": -50 * math.pi})
    assert sweep.sweep is not None
    assert (sweep.kind, sweep.sweep.mesh_frequency, sweep.sweep.points) == ("sweep", (1000.0, 5000.0), 81)
    assert model.sweep_mesh("sweep") == "stage"


@pytest.mark.parametrize("text", [ISO_EXAMPLE, TORSIONAL_PAIR])
def test_writing_and_reading_back_changes_nothing(text: str) -> None:
    model = loads_model(text)
    again = loads_model(dump_model(model))
    assert again == model
    assert pickle.loads(pickle.dumps(model)) == model


EVERYTHING = """\
title: all the keys
gears:
  a:
    number_of_teeth: 20
    normal_module: 3 mm
    helix_angle: 12 deg
    hand: left
    profile_shift_coefficient: 0.2
    face_width: 20.5 mm
    material: {youngs_modulus: 175 GPa, poisson_ratio: 0.29, density: 7200 kg/m^3}
    initial_angle: 3 deg
    bore_diameter: 20 mm
    modifications: {both: {tip_relief: {amount: 10 um, length: 1 mm, shape: parabolic}, lead_crowning: 3 um}}
    deviations: {runout: {amount: 20 um, phase: 30 deg}, flank_maps: [{tooth: 3, flank: left, values: [[1 um, 2 um], [0, 1e-6]]}]}
  b: {number_of_teeth: 40, normal_module: 3 mm, helix_angle: 12 deg, hand: right, face_width: 20 mm,
      tooth_thickness_allowance: -40 um, material: POM, mass: 1.23 kg}
bodies:
  one: {gears: {a: 10 mm}, motion: free}
  two: {gears: [b], motion: planar, mass: 3 kg, inertia: 0.01 kg m^2}
  motor: {motion: torsion, inertia: 0.02 kg m^2}
meshes:
  m:
    gears: [a, b]
    center_distance: 93 mm
    direction: 33 deg
    stiffness: {law: pair_table, single_stiffness: 14 N/(mm um), values: [0.8, 1, 0.8]}
    width: slices
    damping: {d_in: 2000 N s/m, d_out: 500 N s/m, s_0: 2 um}
    friction: {mu: 0.05, v_eps: 20 mm/s}
    transmission_error: {shaft1: {1: [20 um, 30 deg], 2: [3 um, 0]}}
bearings:
  left: {body: one, position: [0, 0, -30 mm], stiffness: {radial: 1e8 N/m, axial: 2e7 N/m, tilt: 1e4 N m/rad}, damping: {ratio: 0.02}}
  right: {body: two, stiffness: {x: 1e8 N/m, y: 2e8 N/m}, damping: {x: 100 N s/m}}
couplings:
  c: {bodies: [motor, one], stiffness: {torsion: 1e4 N m/rad}, damping: {torsion: 0.3 N m s/rad}}
loads:
  drive: {body: motor, torque: "150 N m * (1 + 0.1*sin(2*pi*25*t))"}
  brake: {body: two, torque: balance}
  push: {body: one, force: [0, 100 N, "5 N * cos(angle)"], position: [0, 0, 10 mm]}
  cam: {body: two, torque: {table: [[0 deg, 0], [180 deg, 20 N m], [360 deg, 0]], over: angle}}
  own: {body: one, torque: {python: laws/brake.py:torque, parameters: [1, 2.5]}}
damping: {rayleigh: {mass: 3 1/s, stiffness: 1e-6 s}, modal: 2 %}
scenarios:
  run: {speed: {motor: 1500 rpm}, duration: 1 s, settle_time: 100 ms, step: 5 us, method: rk4, events: [contact]}
  up: {drive: {motor: {angle: "0.1*t^2"}}, duration: 10 s}
  roll: {quasi_static: {points: 50, periods: 2}}
"""  # noqa: E501


def test_every_key_survives_a_round_trip(tmp_path: Path) -> None:
    file = tmp_path / "all.yaml"
    file.write_text(EVERYTHING)
    (tmp_path / "laws").mkdir()
    (tmp_path / "laws" / "brake.py").write_text("def torque(t, angle, p):\n    return p[0] * t + p[1]\n")
    model = load_model(file, allow_code=True)
    copy = tmp_path / "copy.yaml"
    copy.write_text(dump_model(model), encoding="utf-8")
    assert load_model(copy, allow_code=True) == model
    laws = {name: type(load.torque) for name, load in model.loads.items() if load.torque is not None}
    assert laws == {"drive": FormulaLaw, "brake": Balance, "cam": TableLaw, "own": PythonLaw}
    own = model.loads["own"].torque
    assert isinstance(own, PythonLaw)
    assert Path(own.file) == tmp_path / "laws" / "brake.py"
    assert model.bearings["left"].stiffness.matrix6()[3][3] == 1e4
    assert model.gears["b"].x == pytest.approx(-0.2, abs=1.0)
    assert model.start_speeds("run")["two"] == pytest.approx(-25 * math.pi)
    assert model.damping is not None
    assert model.damping.modal == 0.02


def test_python_code_is_refused_unless_allowed() -> None:
    with pytest.raises(ModelError, match="--allow-code") as caught:
        loads_model(EVERYTHING)
    (problem,) = caught.value.problems
    assert problem.where == "loads.own.torque"
    assert problem.line is not None
    assert "python" in EVERYTHING.splitlines()[problem.line - 1]


def test_yaml_1_2_numbers_and_words() -> None:
    text = pair(gear("a"), gear("b"), "stiffness: {law: constant, value: 4e8}")
    assert loads_model(text).meshes["m"].stiffness.value == 4.0e8  # type: ignore[union-attr]
    # `on` and `no` are words in YAML 1.2, so they are fine as names
    text = "gears:\n" + gear("on") + gear("no") + "meshes:\n  off: {gears: [on, no]}\n"
    assert set(loads_model(text).meshes) == {"off"}


def test_pitch_deviations_from_a_file(tmp_path: Path) -> None:
    (tmp_path / "pitch.txt").write_text("# measured\n" + "1 um\n" * 29 + "-2e-6\n")
    file = tmp_path / "m.yaml"
    file.write_text("gears:\n" + gear("a", more="deviations: {pitch: pitch.txt}"))
    found = load_model(file).gears["a"].deviations
    assert found is not None
    assert found.pitch == (1e-6,) * 29 + (-2e-6,)
    file.write_text("gears:\n" + gear("a", more="deviations: {pitch: none.txt}"))
    with pytest.raises(ModelError, match=r"deviations\.pitch \(line 2\): there is no file 'none\.txt'"):
        load_model(file)


def test_file_that_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(ModelError, match="cannot be read"):
        load_model(tmp_path / "absent.yaml")
    with pytest.raises(ModelError, match="cannot be read"):
        load_model(tmp_path)
    bad = tmp_path / "bad.yaml"
    bad.write_bytes(b"title: a\ngears: \xff\xfe")
    with pytest.raises(ModelError, match=r"line 2.*UTF-8"):
        load_model(bad)


def test_loading_imports_nothing_heavy() -> None:
    code = (
        "import sys; from pitchpoint.io.yaml_model import loads_model; loads_model(sys.stdin.read());"
        "heavy = {'numba', 'scipy', 'pint', 'pydantic', 'xarray', 'h5py'} & set(sys.modules);"
        "assert not heavy, heavy"
    )
    subprocess.run([sys.executable, "-c", code], input=TORSIONAL_PAIR, text=True, check=True)


def test_a_model_is_read_from_text_and_from_an_open_file(tmp_path: Path) -> None:
    from pitchpoint import load_model as load

    text = "bodies: {rotor: {inertia: 0.2 kg m^2}}\n"
    file = tmp_path / "model.yaml"
    file.write_text(text)
    with file.open() as stream, file.open("rb") as binary:
        assert load(text=text) == load(file) == load(stream) == load(binary)  # type: ignore[arg-type]
    assert load(text=text).file is None
    with pytest.raises(ModelError, match=r"(?s)^text: 1 problem.*bodies.a.inertia \(line 2\)"):
        load(text="bodies:\n  a: {inertia: 2 kg}\n")
    with pytest.raises(ModelError, match="both a file and a text"):
        load(file, text=text)
    with pytest.raises(ModelError, match="no file is given"):
        load()


def test_a_model_is_written_and_replaces_only_its_own_files(tmp_path: Path) -> None:
    from pitchpoint import load_model as load
    from pitchpoint import write_model

    model = load(text="bodies: {rotor: {inertia: 0.2 kg m^2}}")
    file = write_model(model, tmp_path / "new.yaml")
    assert load(file) == model
    write_model(model.replace("bodies.rotor.inertia", "0.3 kg m^2"), file)
    assert load(file).bodies["rotor"].inertia == 0.3
    (tmp_path / "mine.yaml").write_text("# my model\n")
    with pytest.raises(OSError, match="mine.yaml"):
        write_model(model, tmp_path / "mine.yaml")
