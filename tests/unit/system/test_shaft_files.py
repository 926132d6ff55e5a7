# SPDX-License-Identifier: Apache-2.0
"""Elastic shafts in model files: the same system as by hand, stiff ones like rigid bodies, refusals."""

from __future__ import annotations

import copy
from dataclasses import replace

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.elements import bearing, torque
from pitchpoint.elements.mesh import record as layout
from pitchpoint.elements.signal import Pool, set_constant
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.build import build_model
from pitchpoint.model.components.shaft import Shaft, ShaftSection
from pitchpoint.model.inertia import gear_inertia
from pitchpoint.model.model import Model
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.write import plain
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from pitchpoint.system.evaluate import observe
from pitchpoint.system.rules.gear_mesh import Placement, mesh_row
from pitchpoint.system.rules.mesh_laws import mesh_laws
from pitchpoint.system.rules.shaft import Rider, shaft_parts
from pitchpoint.system.system import assemble

TEETH = {"normal_module": 0.003, "face_width": 0.03, "profile_shift_coefficient": 0.0, "helix_angle": 0.2}
RIG = {
    "gears": {
        "g1": {"number_of_teeth": 25, "hand": "left", **TEETH},
        "g2": {"number_of_teeth": 40, "hand": "right", **TEETH},
    },
    "shafts": {
        "input": {
            "sections": [
                {"length": "60 mm", "diameter": "40 mm"},
                {"length": "120 mm", "diameter": "50 mm", "bore": "10 mm"},
            ],
            "gears": {"g1": "100 mm"},
            "position": [0, 0, 0],
            "internal_damping": "2 us",
        },
        "output": {"sections": [{"length": "180 mm", "diameter": "50 mm"}], "gears": {"g2": "90 mm"}},
    },
    "meshes": {"stage": {"gears": ["g1", "g2"], "stiffness": {"law": "constant", "value": 4e8}}},
    "bearings": {
        "a": {"body": "input", "position": [0, 0, "20 mm"], "stiffness": {"radial": 2e8, "axial": 1e8}},
        "b": {"body": "input", "position": [0, 0, "170 mm"], "stiffness": {"radial": 2e8}},
        "c": {"body": "output", "position": [0, 0, "20 mm"], "stiffness": {"radial": 2e8, "axial": 1e8}},
        "d": {"body": "output", "position": [0, 0, "170 mm"], "stiffness": {"radial": 2e8}},
    },
    "loads": {
        "drive": {"body": "input", "torque": 100.0},
        "brake": {"body": "output", "torque": "balance", "position": [0, 0, "180 mm"]},
    },
    "scenarios": {"run": {"speed": {"input": "1500 rpm"}, "duration": "1 ms"}},
}
FILE = """\
gears:
  g1: {number_of_teeth: 25, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 40, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0}
bodies: {}
shafts:
  input:
    sections:
      - {length: 60 mm, diameter: 40 mm}
      - {length: 120 mm, diameter: 50 mm, bore: 10 mm}
    gears: {g1: 100 mm}
    material: steel
    position: [0, 0, 0]
  output:
    sections: [{length: 180 mm, diameter: 50 mm}]
    gears: {g2: 90 mm}
meshes:
  stage: {gears: [g1, g2], stiffness: {law: din3990}}
bearings:
  a: {body: input, position: [0, 0, 20 mm], stiffness: {radial: 2e8 N/m}}
loads:
  drive: {body: input, torque: 100 N m}
"""


def rig(**sections):
    """The rig with sections in place of its own."""
    return copy.deepcopy({**RIG, **sections})


def by_hand(model):
    """The rig from its numbers alone: two rows of stations, four bearings, a mesh, two torques."""
    parts, first = {}, 1
    for name, gear, places, eta in (
        ("input", "g1", (0.0, 0.02, 0.06, 0.1, 0.17, 0.18), 2e-6),
        ("output", "g2", (0.0, 0.02, 0.09, 0.17, 0.18), 0.0),
    ):
        mass, polar, transverse = gear_inertia(model.gears[gear])
        inside = 7830.0 * np.pi / 4.0 * 0.05**2 * 0.03  # of the shaft in the gear
        mass, polar = mass - inside, polar - inside * 0.05**2 / 8.0
        transverse -= inside * (0.05**2 / 16.0 + 0.03**2 / 12.0)
        shaft = model.shafts[name]
        assert shaft.internal_damping == eta
        at = 0.1 if name == "input" else 0.09
        parts[name] = shaft_parts(
            name,
            shaft,
            {f"{k}": Rider(place=z) for k, z in enumerate(places)}
            | {gear: Rider(place=at, mass=mass, polar=polar, central=transverse)},
            first=first,
            origin=model.bodies[name].origin,
        )
        np.testing.assert_allclose(parts[name].places, places, atol=1e-15)
        first += len(places)
    bearings = np.zeros(4, bearing.RECORD)
    for row, (station, stiff, name) in zip(
        bearings, ((2, 1e8, "input"), (5, 0.0, "input"), (8, 1e8, "output"), (10, 0.0, "output")), strict=True
    ):
        row["i"], row["B"] = station, np.eye(3)
        row["K"] = np.diag([2e8, 2e8, stiff, 0.0, 0.0, 0.0])
        row["d0"] = parts[name].bodies[station - 1 - (6 if name == "output" else 0)].position
    pool = Pool()
    origin = [np.array(model.bodies[n].origin) for n in ("input", "output")]
    place = Placement(
        origin1=origin[0] + [0.0, 0.0, 0.1],
        origin2=origin[1] + [0.0, 0.0, 0.09],
        phi1=model.phasing.tooth_angle["g1"],
        phi2=model.phasing.tooth_angle["g2"],
        widths=(0.03, 0.03),
    )
    mesh = np.zeros(1, layout.RECORD)
    mesh[0] = mesh_row(model.pairs["stage"], place, mesh_laws(model, "stage"), pool.add)
    mesh["i"], mesh["j"] = 4, 9
    torques = np.zeros(2, torque.RECORD)
    torques["i"] = 1, 11
    for row, value in zip(torques, (100.0, 0.0), strict=True):
        set_constant(row, value)  # the second one balances
    return assemble(
        [*parts["input"].bodies, *parts["output"].bodies],
        {
            "gear_mesh": mesh,
            "bearing": bearings,
            "shaft_beam": np.concatenate([p.beams for p in parts.values()]),
            "torque": torques,
        },
        names={"gear_mesh": ("stage",), "bearing": ("a", "b", "c", "d"), "torque": ("drive", "brake")},
        pools={"gear_mesh": pool.array()},
    )


def test_a_rig_from_a_file_is_the_one_made_by_hand():
    model = build_model(rig(), Reader())
    system = compile_model(model)
    hand = replace(by_hand(model), model=model)
    assert system.layout.bodies == hand.layout.bodies
    assert system.layout.bodies[1:4] == ("input", "input.2", "input.3")
    found, wanted = find_modes(system, "run"), find_modes(hand, "run")
    scale = np.abs(wanted.frequency).max()
    np.testing.assert_allclose(found.frequency, wanted.frequency, rtol=1e-9, atol=1e-9 * scale)
    start = prepare_start(system, model.scenarios["run"])
    speeds = {n: start.state.v[system.spin(n)] for n in system.layout.bodies[1:]}
    turn = 1500 * np.pi / 30
    for name, speed in speeds.items():  # all stations turn with their shaft
        assert speed == pytest.approx(turn if name.startswith("input") else -turn * 25 / 40, rel=1e-12)
    assert start.system.records["torque"]["value"][1] == pytest.approx(160.0, rel=1e-6)
    assert start.system.records["torque"]["i"].tolist() == [1, 11]


def test_stiff_shafts_become_rigid_bodies():
    """Modulus of elasticity times s: the elastic modes leave as its root, the rest settles as 1/s."""
    rigid = rig()
    del rigid["shafts"], rigid["loads"]["brake"]["position"]
    totals = build_model(rig(), Reader())
    rigid["bodies"] = {}
    for name, gears in (("input", {"g1": 0.1}), ("output", {"g2": 0.09})):
        own = totals.body_inertia(name)
        rigid["bodies"][name] = {
            "gears": gears,
            "motion": "free",
            "mass": own.mass,
            "inertia": own.polar,
            "transverse_inertia": own.transverse,
            "center_of_mass": own.center,
            "position": list(totals.bodies[name].origin),
        }
    wanted = find_modes(compile_model(build_model(rigid, Reader())), "run").frequency
    apart = []
    for factor in (1e3, 1e4):
        stiff = rig()
        for shaft in stiff["shafts"].values():
            shaft["material"] = {
                "youngs_modulus": 206e9 * factor,
                "poisson_ratio": 0.3,
                "density": 7830.0,
            }
            shaft["internal_damping"] = 0.0
        found = find_modes(compile_model(build_model(stiff, Reader())), "run").frequency[: wanted.size]
        apart.append(np.abs(found[1:] / wanted[1:] - 1.0).max())
    assert apart[1] < 0.15 * apart[0]  # first order in 1/s
    assert apart[1] < 1e-3


def test_a_stiff_pair_carries_the_force_of_the_rigid_one():
    """The pair with twelve degrees of freedom over more than a mesh cycle, on short shafts and on bodies."""
    found = []
    for elastic in (False, True):
        data = rig()
        for gear in data["gears"].values():
            gear.update(helix_angle=0.0, bore_diameter=0.06)
        seat = {"radial": 1e8, "axial": 1e8, "tilt": 1e6}
        at = [0, 0, 0.01]
        data["bearings"] = {n: {"body": n, "position": at, "stiffness": seat} for n in ("input", "output")}
        data["meshes"]["stage"]["stiffness"] = {"law": "fourier", "mean": 4e8, "cosine": [-0.2]}
        del data["loads"]["brake"]["position"]
        shafts = data.pop("shafts")
        if elastic:  # a hundred times steel, and next to no mass
            stiff = {"youngs_modulus": 2e13, "poisson_ratio": 0.3, "density": 1.0}
            data["shafts"] = {
                n: {
                    "sections": [{"length": 0.02, "diameter": 0.06}],
                    "material": stiff,
                    "gears": dict.fromkeys(s["gears"], 0.01),
                }
                for n, s in shafts.items()
            }
        else:
            data["bodies"] = {
                n: {"gears": dict.fromkeys(s["gears"], 0.01), "motion": "free"} for n, s in shafts.items()
            }
        model = build_model(data, Reader())
        begin = prepare_start(compile_model(model), model.scenarios["run"])
        run = generalized_alpha.start(begin.system, begin.state, 1e-5)
        channel = [c.name for c in begin.system.layout.channels].index("mesh_force[stage]")
        force = []
        for _ in range(40):
            run.advance(5)
            force.append(observe(begin.system, run.state())[channel])
        found.append(force)
    assert np.ptp(found[0]) > 0.02 * np.mean(found[0])  # the wave of the stiffness is in it
    # compliance of 10 mm of that shaft against that of bearings and mesh: below 1e-4
    np.testing.assert_allclose(found[1], found[0], rtol=1e-3)


def test_places_along_shafts():
    """Couplings, reactions, markers, unbalances and rigid joints find the stations where they sit."""
    data = {
        "shafts": {
            "one": {
                "sections": [{"length": 0.2, "diameter": 0.03}],
                "position": [0, 0, 0],
                "markers": {"m": {"position": [0.01, 0, 0.15]}},
                "largest_piece": 1.0,
            },
            "two": {
                "sections": [{"length": 0.3, "diameter": 0.03}],
                "position": [0, 0, 0.2],
                "largest_piece": 1.0,
            },
        },
        "bodies": {"arm": {"mass": 1.0, "inertia_tensor": [1e-3] * 3 + [0.0] * 3}},
        "joints": {"pin": {"type": "revolute", "bodies": ["one.m", "arm"], "axes": {"z": [1, 0, 0]}}},
        "couplings": {
            "c": {"bodies": ["one", "two"], "position": [0, 0, 0.2], "stiffness": {"torsion": 1e4}}
        },
        "unbalances": {"u": {"body": "two", "mass": 0.1, "position": [0.02, 0, 0.11]}},
        "loads": {"t": {"body": "two", "torque": 1.0, "position": [0, 0, 0.25]}},
    }
    model = build_model(data, Reader())
    assert model.stations["one"] == pytest.approx((0.0, 0.15, 0.2))
    assert model.stations["two"] == pytest.approx((0.0, 0.11, 0.25, 0.3))
    system = compile_model(model)
    name = system.layout.bodies
    assert name[1:] == ("one", "one.2", "one.3", "arm", "two", "two.2", "two.3", "two.4")
    coupling = system.records["bearing"][0]
    assert (name[coupling["i"]], name[coupling["j"]]) == ("one.3", "two")
    assert coupling["zi"] == pytest.approx(0.0, abs=1e-12)
    assert name[system.records["torque"]["i"][0]] == "two.3"
    assert name[system.bodies[name.index("arm") - 1].parent] == "one.2"
    heavy = system.bodies[name.index("two.2") - 1]
    assert heavy.mass == pytest.approx(0.1, rel=1e-6)
    np.testing.assert_allclose(heavy.center_of_mass()[:2], [0.02, 0.0], rtol=1e-6)


def test_a_driven_shaft_starts_untwisted():
    data = rig()
    data["loads"] = {}
    data["scenarios"] = {"turn": {"drive": {"input": {"angle": "2 + 100*t"}}, "duration": "1 ms"}}
    model = build_model(data, Reader())
    system = compile_model(model, "turn")
    start = prepare_start(system, model.scenarios["turn"])
    spins = [system.spin(n) for n in system.layout.bodies[1:7]]
    np.testing.assert_allclose(start.state.q[spins], 2.0, rtol=1e-9)
    np.testing.assert_allclose(start.state.v[spins], 100.0, rtol=1e-12)


def test_a_shaft_survives_writing_and_changing():
    model = build_model(rig(), Reader())
    again = build_model(plain(model), Reader())
    assert plain(again) == plain(model)
    assert again.shafts == model.shafts
    assert "bodies" not in plain(model)
    moved = model.replace("bearings.b.position", ["0 mm", "0 mm", "150 mm"])
    assert 0.15 in moved.stations["input"]
    thick = model.replace("shafts.output.sections", ({"length": 0.18, "diameter": 0.08},))
    more = 7830.0 * np.pi / 4.0 * (0.08**2 - 0.05**2) * (0.18 - 0.03)  # not in the gear
    assert thick.body_inertia("output").mass - model.body_inertia("output").mass == pytest.approx(more)
    with pytest.raises(ModelError, match=r"bodies\.input: does not exist"):
        model.replace("bodies.input.mass", 1.0)


@pytest.mark.parametrize(
    ("line", "new", "words"),
    [
        ("position: [0, 0, 20 mm]", "position: [0, 0, 200 mm]", "a.position: 200 mm is not a position on"),
        ("length: 60 mm, ", "", "shafts.input.sections[0].length: is missing"),
        (
            "bore: 10 mm",
            "bore: 50 mm",
            "sections[1].bore: 50 mm is not smaller than the diameter (limit below",
        ),
        (
            "[{length: 180 mm, diameter: 50 mm}]",
            "[{length: 90 mm, diameter: 50 mm}, {length: 90 mm, diameter: 80 mm, bore: 50 mm}]",
            "shafts.output.sections[1]: diameter 80 mm and bore 50 mm after",
        ),
        ("[{length: 180 mm, diameter: 50 mm}]", "[]", "shafts.output.sections: has 0 entries"),
        ("g2: 90 mm", "g2: 190 mm", "shafts.output.gears.g2: 190 mm is not a position on the shaft output"),
        ("g2: 90 mm", "g1: 90 mm", "shafts.output.gears: carries g1, which is already on input"),
        ("g2: 90 mm", "g3: 90 mm", "shafts.output.gears: names the gear 'g3', which does not exist"),
        ("diameter: 40 mm", "diamter: 40 mm", "is an unknown key"),
        ("bodies: {}", "bodies: {input: {inertia: 1}}", "shafts.input: has the name of a body"),
        ("body: input, torque", "body: inptu, torque", "did you mean input?"),
        ("material: steel", "material: stel", "material"),
    ],
)
def test_wrong_shafts_are_told_with_line_and_remedy(tmp_path, line, new, words):
    assert FILE.count(line) == 1
    file = tmp_path / "rig.yaml"
    file.write_text(FILE.replace(line, new), encoding="utf-8")
    with pytest.raises(ModelError) as error:
        load_model(file)
    where = FILE[: FILE.index(line)].count("\n") + 1
    hits = [p for p in error.value.problems if words in str(p.changed(line=None))]
    assert hits, error.value
    assert hits[0].remedy
    assert hits[0].line in (where, *([6] if "has the name" in words else []))


def test_a_shaft_in_python_is_checked_too():
    with pytest.raises(ModelError, match=r"shafts\.s\.sections: is empty.*one section"):
        Model(shafts={"s": Shaft(sections=(), position=(0.0, 0.0, 0.0))})
    with pytest.raises(
        ModelError, match=r"shafts\.s\.sections\[0\]\.bore: 40 mm is not smaller than the diameter"
    ):
        Model(shafts={"s": Shaft(sections=(ShaftSection(length=0.1, diameter=0.03, bore=0.04),))})
