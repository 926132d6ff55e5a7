# SPDX-License-Identifier: Apache-2.0
"""Elastic rotors in model files: a gear pair on shafts of finite elements is the one on elastic shafts."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.shafts import nearest_station
from pitchpoint.multibody.beam_section import Beam, tube
from pitchpoint.multibody.structure import beam_line
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

GEARS = """\
gears:
  pinion: {number_of_teeth: 25, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0,
    bore_diameter: 50 mm}
  wheel: {number_of_teeth: 40, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0,
    bore_diameter: 45 mm}
meshes:
  stage: {gears: [pinion, wheel], stiffness: {law: constant, value: 4e8 N/m}}
scenarios:
  still: {duration: 2 ms, step: 2 us, settle_time: 0 s}
  turning: {speed: {input: 1500 rpm}, duration: 2 ms, step: 2 us, settle_time: 0 s}
"""
HOLDS = "{radial: 2e8 N/m, axial: 1e8 N/m}"
SHAFTS = """\
shafts:
  input:
    sections: [{length: 180 mm, diameter: 50 mm, bore: 10 mm}]
    material: steel
    gears: {pinion: 100 mm}
    position: [0, 0, 0]
    largest_piece: PIECE
  output:
    sections: [{length: 180 mm, diameter: 45 mm}]
    gears: {wheel: 90 mm}
    largest_piece: PIECE
bearings:
  left: {body: input, stiffness: HOLDS}
  right: {body: input, position: [0, 0, 180 mm], stiffness: {radial: 2e8 N/m}}
  near: {body: output, stiffness: HOLDS}
  far: {body: output, position: [0, 0, 180 mm], stiffness: {radial: 2e8 N/m}}
loads:
  motor: {body: input, torque: 100 N m}
  brake: {body: output, torque: balance, position: [0, 0, 180 mm]}
"""
BODY = """\
  NAME:
    file: NAME.npz
    nodes: {start: {}, seat: {position: [0, 0, SEAT mm]}, end: {position: [0, 0, 180 mm]}}
    rotor: true
    modes: 12
    static_shapes: true
    position: PLACE
"""
SEATS = """\
bodies:
  pinion_body: {gears: [pinion]}
  wheel_body: {gears: [wheel]}
  journal_1: {mass: 0 kg}
  journal_2: {mass: 0 kg}
  journal_3: {mass: 0 kg}
  journal_4: {mass: 0 kg}
joints:
  on_input: {type: fixed, bodies: [input.seat, pinion_body]}
  on_output: {type: fixed, bodies: [output.seat, wheel_body]}
  j1: {type: fixed, bodies: [input.start, journal_1]}
  j2: {type: fixed, bodies: [input.end, journal_2]}
  j3: {type: fixed, bodies: [output.start, journal_3]}
  j4: {type: fixed, bodies: [output.end, journal_4]}
bearings:
  left: {body: journal_1, stiffness: HOLDS}
  right: {body: journal_2, stiffness: {radial: 2e8 N/m}}
  near: {body: journal_3, stiffness: HOLDS}
  far: {body: journal_4, stiffness: {radial: 2e8 N/m}}
loads:
  motor: {body: journal_1, torque: 100 N m}
  brake: {body: journal_4, torque: balance}
"""


CLOSE = (1e-9, 1e-8, 0.1)
"""Deflections of 15 um, tilts of 5 urad and forces of 3 kN under 100 N m agree to this [m, rad, N].

Shafts twist by 1 mrad, and the small turns of a node, which follow one another, err by their products.
"""


def same(text):
    return text


def pair(tmp_path, piece, change=same):
    """The rig on elastic shafts, and on the same beams as finite elements in files."""
    file = tmp_path / "shafts.yaml"
    text = GEARS + SHAFTS.replace("HOLDS", HOLDS).replace("PIECE", piece)
    file.write_text(change(text), encoding="utf-8")
    one = load_model(file)
    text = GEARS + "elastic_bodies:\n"
    for name, seat in (("input", "100"), ("output", "90")):
        shaft, places = one.shafts[name], np.array(one.stations[name])
        steel, section = shaft.material_data, shaft.sections[0]
        line = beam_line(
            [
                Beam(
                    section=tube(section.diameter, section.bore, steel.poisson_ratio),
                    length=length,
                    E=steel.youngs_modulus,
                    G=steel.shear_modulus,
                    rho=steel.density,
                )
                for length in np.diff(places)
            ]
        )
        np.savez(tmp_path / f"{name}.npz", K=line.K.toarray(), M=line.M.toarray(), places=line.places)
        place = repr(list(one.bodies[name].origin))
        text += BODY.replace("NAME", name).replace("SEAT", seat).replace("PLACE", place)
    file = tmp_path / "elastic.yaml"
    file.write_text(change(text + SEATS.replace("HOLDS", HOLDS)), encoding="utf-8")
    return one, load_model(file)


def deflections(model, wanted):
    """Place [m] and axis of the gears under the static load, and the forces of mesh and bearings."""
    begin = prepare_start(compile_model(model, "still"), model.scenarios["still"])
    row = evaluate.observe(begin.system, begin.state)
    frames, names = begin.system.workspace.fr, begin.system.layout.bodies
    channel = [c.name for c in begin.system.layout.channels]
    forces = [f"bearing_force[{b}.f{d}]" for b in ("left", "near") for d in "xyz"]
    at = [frames[names.index(w)] for w in wanted]
    return (
        np.concatenate([f["r"] for f in at]),
        np.concatenate([f["R"][:, 2] for f in at]),
        np.array([row[channel.index(c)] for c in ("mesh_force[stage]", *forces)]),
    )


def test_a_coarse_pair_is_the_same_to_round_off(tmp_path):
    """Stations at the bearings and gears alone: all 18 displacements of a shaft are in 12 shapes.

    Stations have 1e-9 of the mass of their shaft, the nodes nothing. At 100 N m the products of the small
    turns of a node, which follow one another, move frequencies by 1e-5 of them; so here it is 1 N m.
    """
    one, two = pair(tmp_path, "1 m", lambda text: text.replace("100 N m", "1 N m"))
    assert [len(places) for places in one.stations.values()] == [3, 3]
    first, second = find_modes(compile_model(one)), find_modes(compile_model(two))
    assert second.frequency.size == first.frequency.size == 36
    np.testing.assert_allclose(second.frequency[1:], first.frequency[1:], rtol=1e-6)
    one, two = pair(tmp_path, "1 m")
    gears = [f"{name}.2" for name in ("input", "output")]
    found = deflections(two, ["pinion_body", "wheel_body"])
    for a, b, near in zip(found, deflections(one, gears), CLOSE, strict=True):
        np.testing.assert_allclose(a, b, rtol=0, atol=near)


def test_a_fine_pair_differs_by_the_reduction(tmp_path):
    """Ten pieces: what the static shapes cannot do costs 0.1 % up to 1.2 kHz; statics have no error."""
    one, two = pair(tmp_path, "18 mm")
    first, second = find_modes(compile_model(one)), find_modes(compile_model(two))
    low = np.count_nonzero(first.frequency < 1.2e3)
    assert low >= 5
    np.testing.assert_allclose(second.frequency[1:low], first.frequency[1:low], rtol=1e-3)
    gears = [f"{n}.{nearest_station(one.stations[n], p) + 1}" for n, p in (("input", 0.1), ("output", 0.09))]
    found = deflections(two, ["pinion_body", "wheel_body"])
    for a, b, near in zip(found, deflections(one, gears), CLOSE, strict=True):
        np.testing.assert_allclose(a, b, rtol=0, atol=near)


@pytest.mark.study
def test_a_fine_pair_of_more_modes_differs_less(tmp_path):
    """Twelve modes with the nodes held beside the twelve static shapes: 0.1 % up to 5 kHz."""
    one, two = pair(tmp_path, "18 mm", lambda text: text.replace("modes: 12", "modes: 24"))
    first, second = find_modes(compile_model(one)), find_modes(compile_model(two))
    low = np.count_nonzero(first.frequency < 5e3)
    assert low >= 11
    np.testing.assert_allclose(second.frequency[1:low], first.frequency[1:low], rtol=1e-3)


def test_speeds_follow_the_teeth_and_whole_turns_change_nothing(tmp_path):
    _, model = pair(tmp_path, "1 m")
    speeds = model.start_speeds("turning")
    assert speeds["output"] == pytest.approx(-25 / 40 * 1500 * np.pi / 30)
    system = compile_model(model, "turning")
    assert any("input, output rotate with the body" in note for note in find_modes(system, count=2).notes)
    assert not any("one position" in note for note in find_modes(compile_model(model), count=2).notes)
    state = prepare_start(system, model.scenarios["turning"]).state
    found = evaluate.residual(system, state).copy()
    for name, turns in (("input", 40 * 10**9), ("output", -25 * 10**9)):
        state.turns[system.layout.bodies.index(name)] += turns
    np.testing.assert_array_equal(evaluate.residual(system, state), found)
    seat = system.workspace.fr[system.layout.bodies.index("pinion_body")]
    assert seat["turns"] == 40 * 10**9


def test_a_turning_pair_runs_like_the_shafts(tmp_path):
    """Half a turn of the pinion: forces as on beams in axes that do not turn.

    The modes turn with the body and the beams do not, so this is the whole floating frame against another
    description. The deflection stays where it is in space while the body turns under it, which it does not
    know at the start: it rings by 2 %, and the mean counts.
    """
    found = []
    for model in pair(tmp_path, "1 m"):
        begin = prepare_start(compile_model(model, "turning"), model.scenarios["turning"])
        run = generalized_alpha.start(begin.system, begin.state, 1e-5)
        channel = [c.name for c in begin.system.layout.channels]
        wanted = ["mesh_force[stage]", "bearing_force[left.fy]", "bearing_force[near.fx]"]
        rows = []
        for _ in range(200):
            run.advance(10)
            row = evaluate.observe(begin.system, run.state())
            rows.append([row[channel.index(c)] for c in wanted])
        found.append(np.array(rows))
    scale = np.abs(found[0]).max(axis=0)
    np.testing.assert_allclose(found[1] / scale, found[0] / scale, atol=3e-2)
    np.testing.assert_allclose(found[1].mean(axis=0) / scale, found[0].mean(axis=0) / scale, atol=1e-3)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            "rotor: true",
            "rotor: false",
            "are fixed to input, which does not count revolutions about their axis",
        ),
        ("{body: journal_1, torque", "{body: input, torque", "body input, without a node"),
        ("modes: 12", "below: 1 kHz", "input.static_shapes: cannot be combined with below"),
        ("rotor: true", "rotor: yes please", "input.rotor: "),
        ("speed: {input:", "speed: {journal_1:", "has no spin"),
    ],
)
def test_wrong_rotors_are_told(tmp_path, old, new, words):
    with pytest.raises(ModelError) as error:
        pair(tmp_path, "1 m", lambda text: text.replace(old, new) if "elastic" in text else text)
    told = [f"{p.where}: {p.text} {p.remedy}" for p in error.value.problems]
    assert any(words in t for t in told), told
    assert all(p.line for p in error.value.problems)


def test_too_many_static_shapes_are_told(tmp_path):
    _, model = pair(tmp_path, "1 m", lambda text: text.replace("modes: 12", "modes: 10"))
    with pytest.raises(ModelError, match="can deflect in 12 shapes, and 10 modes are requested"):
        compile_model(model)
