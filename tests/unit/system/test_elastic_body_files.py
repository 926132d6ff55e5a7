# SPDX-License-Identifier: Apache-2.0
"""Elastic bodies in model files: the rod of a slider-crank from a NumPy archive, and what is refused."""

from __future__ import annotations

import json

import numpy as np
import pytest
from scipy.io import mmwrite

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.core.provenance import content_hash
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.write import plain
from pitchpoint.multibody.beam_section import Beam, rectangle
from pitchpoint.multibody.structure import beam_line
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.floating import truss

LENGTH, PIECES = 0.3, 6
CRANK = """\
bodies:
  crank: {mass: 1 kg, inertia_tensor: [2e-4, 1.1e-3, 1.2e-3, 0, 0, 0],
          markers: {pin: {position: [100 mm, 0, 0]}}}
  piston: {mass: 0.5 kg}
elastic_bodies:
  rod:
    file: rod.npz
    nodes: {big: {}, small: {position: [0, 0, 300 mm]}}
    axes: {z: [1, 0, 0], x: [0, 1, 0]}
    modes: 6
    damping_ratio: 0.05
joints:
  main: {type: revolute, bodies: [ground, crank], position: [0, 0, 0]}
  crank_pin: {type: revolute, bodies: [crank.pin, rod.big], axes: {z: [0, 0, 1]}}
  cylinder: {type: prismatic, bodies: [ground, piston], axes: {z: [1, 0, 0]}, position: [400 mm, 0, 0]}
  piston_pin: {type: revolute, bodies: [rod.small, piston], axes: {z: [0, 0, 1]}}
scenarios:
  driven: {drive: {crank: {speed: 300 rpm}}, start: assembled, duration: 0.1 s, step: 0.1 ms}
"""


def rod(E=210e9):
    """Pieces of a square rod along its third axis."""
    section = rectangle(0.02, 0.02)
    return [Beam(section=section, length=LENGTH / PIECES, E=E, G=E / 2.6, rho=7800.0)] * PIECES


def crank_with(tmp_path, text=CRANK, E=210e9):
    """Model of a file beside the archive of its rod."""
    line = beam_line(rod(E))
    np.savez(tmp_path / "rod.npz", K=line.K.toarray(), M=line.M.toarray(), places=line.places)
    file = tmp_path / "crank.yaml"
    file.write_text(text, encoding="utf-8")
    return load_model(file)


def positions(model, steps=400):
    """Time, travel of the piston and strain energy of the rod over a part of a turn."""
    begin = prepare_start(compile_model(model, "driven"), model.scenarios["driven"])
    run = generalized_alpha.start(begin.system, begin.state, 1e-4)
    channel = [c.name for c in begin.system.layout.channels]
    found = []
    for _ in range(20):
        run.advance(steps // 20)
        row = evaluate.observe(begin.system, run.state())
        names = ("displacement[piston.z]", "strain_energy[rod]")
        found.append([run.state().t, *(row[channel.index(n)] for n in names)])
    return begin.system, np.array(found)


def test_a_rod_of_modes_moves_the_piston_like_a_rigid_one(tmp_path):
    """Forces of a few hundred newtons stretch steel by nanometres; the travel is that of the geometry."""
    model = crank_with(tmp_path)
    assert model.bodies["rod"].origin == pytest.approx((0.1, 0.0, 0.0))
    system, found = positions(model)
    angle = 300 * np.pi / 30 * found[:, 0]
    travel = 0.1 * np.cos(angle) + np.sqrt(LENGTH**2 - (0.1 * np.sin(angle)) ** 2) - 0.4
    # bending of the rod under its own inertia shortens it by its square only
    np.testing.assert_allclose(found[:, 1], travel, atol=1e-6)
    assert {"rod", "rod.1", "rod.big", "rod.small"} <= set(system.layout.bodies)
    assert system.records["flexible_body"]["mass"][0] == pytest.approx(7800 * 4e-4 * LENGTH, rel=1e-9)


def energy_by_statics(t):
    """Bending and stretching of the rod by d'Alembert's forces, piston of 0.5 kg, crank at 300 rpm [J]."""
    rate, mass = 300 * np.pi / 30, 7800.0 * 4e-4

    def ends(t):
        big = 0.1 * np.array([np.cos(rate * t), np.sin(rate * t)])
        return big, np.array([big[0] + np.sqrt(LENGTH**2 - big[1] ** 2), 0.0])

    h = 1e-4
    now, before, after = ends(t), ends(t - h), ends(t + h)
    pulls = [(after[k] - 2.0 * now[k] + before[k]) / h**2 for k in (0, 1)]
    along = (now[1] - now[0]) / LENGTH
    across = np.array([-along[1], along[0]])
    s = np.linspace(0.0, LENGTH, 401)
    share = s / LENGTH
    load = mass * ((1.0 - share)[:, None] * pulls[0] + share[:, None] * pulls[1])
    n, q = load @ along, load @ across
    side = -np.trapezoid(s * q, s) / LENGTH  # force on the piston across the rod: moments about the big eye
    push = (0.5 * pulls[1][0] - side * across[0]) / along[0]
    moment = np.array(
        [(LENGTH - x) * side + np.trapezoid((s[k:] - x) * q[k:], s[k:]) for k, x in enumerate(s)]
    )
    tension = np.array([push + np.trapezoid(n[k:], s[k:]) for k in range(s.size)])
    bending = np.trapezoid(moment**2, s) / (2 * 210e9 * 0.02**4 / 12)
    return bending + np.trapezoid(tension**2, s) / (2 * 210e9 * 4e-4)


def test_the_rod_bends_and_stretches_by_its_inertia(tmp_path):
    """A hundred times slower than its first mode the rod bends as if at rest.

    It starts undeformed; what rings of that has settled after 16 ms. Shear adds (h/L)^2 E/G, a percent; 12
    modes leave a few percent out, a fifth of the stretching among them.
    """
    _, found = positions(crank_with(tmp_path, CRANK.replace("modes: 6", "modes: 12")))
    wanted = np.array([energy_by_statics(t) for t in found[:, 0]])
    assert found[8, 0] > 0.016
    np.testing.assert_allclose(found[8:, 2], wanted[8:], rtol=0.05)


def test_loops_are_closed_by_turning_the_rod_not_by_bending_it(tmp_path):
    text = CRANK.replace("position: [0, 0, 0]}", "position: [0, 0, 0], start: {spin: 40 deg}}", 1)
    model = crank_with(tmp_path, text.replace("drive: {crank: {speed: 300 rpm}}", "speed: {crank: 300 rpm}"))
    system = compile_model(model, "driven")
    state = prepare_start(system, model.scenarios["driven"]).state
    names = system.layout.coordinates
    elastic = [k for k, n in enumerate(names) if ".eta" in n]
    assert len(elastic) == 6
    assert state.q[names.index("crank.spin")] == pytest.approx(np.radians(40.0), rel=1e-12)
    assert abs(state.q[names.index("rod.beta")]) > 0.2
    # weights of 1e4 leave 1e-8 of the change to them
    assert np.abs(state.q[elastic]).max() < 1e-6
    assert np.abs(state.v[elastic]).max() < 1e-5


def test_what_a_file_says_is_kept(tmp_path):
    model = crank_with(tmp_path)
    data = plain(model)
    assert data["elastic_bodies"]["rod"]["file"] == "rod.npz"
    assert list(data["bodies"]) == ["crank", "piston"]
    below = crank_with(tmp_path, CRANK.replace("modes: 6", "below: 2 kHz"))
    assert compile_model(below).records["flexible_body"]["n"][0] == 2


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("rod.npz", "rood.npz", "elastic_bodies.rod.file: 'rood.npz' names a file that does not exist"),
        ("modes: 6", "modes: 6\n    below: 1 kHz", "elastic_bodies.rod: gives modes and below together"),
        ("modes: 6", "modes: 40", "elastic_bodies.rod.modes: 40 is out of range"),
        (
            "nodes: {big: {}, small: {position: [0, 0, 300 mm]}}",
            "nodes: {}",
            "elastic_bodies.rod.nodes: is empty",
        ),
        ("[rod.small, piston]", "[rod, piston]", "names the elastic body rod, without a node"),
        ("[rod.small, piston]", "[rod.smal, piston]", "did you mean small?"),
        ("scenarios:", "loads: {t: {body: rod, torque: 1 N m}}\nscenarios:", "which has no axis"),
    ],
)
def test_wrong_elastic_bodies_are_told(tmp_path, old, new, words):
    assert CRANK.count(old) == 1
    with pytest.raises(ModelError) as error:
        crank_with(tmp_path, CRANK.replace(old, new))
    told = [
        f"{p.where}: {p.value or ''} {p.text} {p.remedy}".replace(":  ", ": ") for p in error.value.problems
    ]
    assert any(words in t for t in told), told
    assert all(p.line for p in error.value.problems)


def test_a_torque_on_a_rotor_needs_a_place_on_it(tmp_path):
    """Of a rotor the message says what carries the torque, and at which nodes."""
    text = CRANK.replace("modes: 6", "modes: 6\n    rotor: true")
    text = text.replace("scenarios:", "loads: {t: {body: rod, torque: 1 N m}}\nscenarios:")
    with pytest.raises(ModelError) as error:
        crank_with(tmp_path, text)
    (told,) = [p for p in error.value.problems if p.where == "loads.t.body"]
    assert told.line == 1 + text[: text.index("loads:")].count("\n")
    assert told.text == "names the elastic body rod, without a node"
    assert told.remedy == (
        "name a body {mass: 0 kg} here that a joint of type fixed carries at rod.big or rod.small"
    )


def test_wrong_matrices_are_told_with_the_body(tmp_path):
    model = crank_with(tmp_path, CRANK.replace("300 mm", "290 mm", 1))
    with pytest.raises(
        ModelError, match=r"elastic_bodies\.rod\.nodes\.small \(line 8\): the file has no node.*300\] mm"
    ):
        compile_model(model)
    model = crank_with(tmp_path)
    np.savez(tmp_path / "rod.npz", K=np.eye(6), places=np.zeros((1, 3)))
    with pytest.raises(ModelError, match=r"elastic_bodies\.rod\.file \(line 7\): rod.npz: has no matrix 'M'"):
        compile_model(model)


THREE = "stiffness_file: k.mtx\n    mass_file: m.mtx\n    place_file: places.txt"


def write_parts(tmp_path, scale=1.0):
    """The rod as Matrix Market files and a table of its nodes."""
    line = beam_line(rod())
    mmwrite(tmp_path / "k.mtx", line.K, symmetry="symmetric")
    mmwrite(tmp_path / "m.mtx", line.M, symmetry="symmetric")
    rows = [" ".join(repr(scale * float(x)) for x in p) for p in line.places]
    (tmp_path / "places.txt").write_text("\n".join(rows) + "\n", encoding="utf-8")


def test_matrix_market_files_are_the_archive(tmp_path):
    write_parts(tmp_path)
    wanted = compile_model(crank_with(tmp_path)).records["flexible_body"]
    model = crank_with(tmp_path, CRANK.replace("file: rod.npz", THREE))
    found = compile_model(model).records["flexible_body"]
    for field in ("mass", "first", "inertia", "K"):
        np.testing.assert_allclose(found[field], wanted[field], rtol=1e-9, atol=1e-12)
    data = plain(model)["elastic_bodies"]["rod"]
    assert [data[k] for k in ("stiffness_file", "mass_file", "place_file")] == [
        "k.mtx",
        "m.mtx",
        "places.txt",
    ]


def test_the_hash_of_a_model_covers_its_files(tmp_path):
    write_parts(tmp_path)
    text = CRANK.replace("file: rod.npz", THREE)
    first = content_hash(crank_with(tmp_path, text))
    assert content_hash(crank_with(tmp_path, text)) == first
    for name in ("k.mtx", "m.mtx", "places.txt"):
        kept = (tmp_path / name).read_text(encoding="utf-8")
        (tmp_path / name).write_text(kept + "\n", encoding="utf-8")
        assert content_hash(crank_with(tmp_path, text)) != first
        (tmp_path / name).write_text(kept, encoding="utf-8")


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ("modes_of_nothing: 1", "elastic_bodies.rod: has no matrices"),
        ("file: rod.npz\n    mass_file: m.mtx", "elastic_bodies.rod.mass_file: cannot be combined with file"),
        ("stiffness_file: k.mtx", "requires mass_file and place_file in addition to stiffness_file"),
        ("stiffness_file: kk.mtx", "'kk.mtx' names a file that does not exist"),
    ],
)
def test_wrong_choices_of_files_are_told(tmp_path, given, words):
    write_parts(tmp_path)
    with pytest.raises(ModelError) as error:
        crank_with(tmp_path, CRANK.replace("file: rod.npz", given))
    told = [f"{p.where}: {p.value or ''} {p.text}".replace(":  ", ": ") for p in error.value.problems]
    assert any(words in t for t in told), told
    assert all(p.line for p in error.value.problems)


def millimetres(line):
    return {"K": line.K.toarray(), "M": line.M.toarray(), "places": 1e3 * line.places}


def on_ground(line):
    K = line.K.toarray()
    K[0, 0] *= 1.5
    return {"K": K, "M": line.M.toarray(), "places": line.places}


def lopsided(line):
    K = line.K.toarray()
    K[0, 1] += 0.1 * K[0, 0]
    return {"K": K, "M": line.M.toarray(), "places": line.places}


def cut_through(line):
    """Two halves that nothing joins."""
    half = beam_line(rod()[:3])
    n = half.size
    K, M = np.zeros((2, 2 * n, 2 * n))
    for k in (0, n):
        K[k : k + n, k : k + n], M[k : k + n, k : k + n] = half.K.toarray(), half.M.toarray()
    return {"K": K, "M": M, "places": np.vstack([half.places, half.places + np.array([0, 0, 0.15])])}


def weightless(line):
    return {"K": line.K.toarray(), "M": 0.0 * line.M.toarray(), "places": line.places}


def one_way(line):
    M = line.M.toarray()
    M[0, 0] += 1.0
    return {"K": line.K.toarray(), "M": M, "places": line.places}


def negative(line):
    return {"K": line.K.toarray(), "M": -line.M.toarray(), "places": line.places}


def downhill(line):
    return {"K": -line.K.toarray(), "M": line.M.toarray(), "places": line.places}


def short(line):
    return {"K": line.K.toarray(), "M": line.M.toarray(), "places": line.places[:-1]}


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (millimetres, "rigid-body motion causes a force"),
        (on_ground, "rigid-body motion causes a force.*remove supports"),
        (lopsided, "K: is not symmetric"),
        (cut_through, "connected to no interface node|not have six rigid-body modes|without stiffness"),
        (weightless, "masses along x, y and z are 0, 0, 0 kg.*limit > 0"),
        (one_way, "and must be equal"),
        (negative, "M: has -.* on its diagonal"),
        (downhill, "K: has -.* on its diagonal, row"),
        (short, "neither 3 nor 6 per node|42 displacements of 6 nodes"),
    ],
)
def test_matrices_of_no_free_body_are_told(tmp_path, change, words):
    model = crank_with(tmp_path)
    np.savez(tmp_path / "rod.npz", **change(beam_line(rod())))
    with pytest.raises(ModelError, match=r"elastic_bodies\.rod \(line 6\): .*(" + words + ")"):
        compile_model(model)


def test_places_in_millimetres_are_suspected(tmp_path):
    """Nodes with translations alone fit any unit of length; what betrays it is the speed of waves."""
    solid = truss(stiffness=1e8)
    np.savez(tmp_path / "solid.npz", K=solid.K.toarray(), M=solid.M.toarray(), places=1e3 * solid.places)
    nodes = ", ".join(
        f"n{k}: {{position: [{', '.join(f'{1e3 * x:.12g}' for x in p)}]}}"
        for k, p in enumerate(solid.places[:3])
    )
    (tmp_path / "m.yaml").write_text(
        f"elastic_bodies: {{b: {{file: solid.npz, nodes: {{{nodes}}}, modes: 4}}}}\n", encoding="utf-8"
    )
    with pytest.raises(ModelError, match=r"implies a wave speed of .*positions in m"):
        compile_model(load_model(tmp_path / "m.yaml"))


def test_check_tells_what_is_wrong_with_the_matrices_of_all_bodies(tmp_path, capsys):
    text = CRANK.replace("joints:", "  other: {file: rod.npz, nodes: {a: {}}, modes: 2}\njoints:", 1)
    text = text.replace("scenarios:", "  b: {type: spherical, bodies: [other.a, ground]}\nscenarios:", 1)
    crank_with(tmp_path, text)
    np.savez(tmp_path / "rod.npz", **on_ground(beam_line(rod())))
    assert run_command(["check", str(tmp_path / "crank.yaml")]) == 2
    told = " ".join(capsys.readouterr().err.split())
    assert (
        "elastic_bodies.rod (line 6): K: a rigid-body motion causes a force at node 0; remove supports"
        in told
    )
    assert "elastic_bodies.other (line 12): K: a rigid-body motion" in told
    assert "Traceback" not in told


def test_check_tells_of_elastic_bodies(tmp_path, capsys):
    crank_with(tmp_path)
    assert run_command(["check", str(tmp_path / "crank.yaml")]) == 0
    told = " ".join(capsys.readouterr().out.split())
    assert "rod, unsupported: 6 natural frequencies, 1" in told
    assert "8 coordinates without the modes of rod - 10 constraints" in told
    assert run_command(["check", str(tmp_path / "crank.yaml"), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["elastic_bodies"] == {"rod": ["big", "small"]}
    assert found["bodies"]["rod"]["mass"] == pytest.approx(7800.0 * 4e-4 * LENGTH)
    assert found["bodies"]["rod"]["polar_inertia"] is None
    assert len(found["elastic_frequencies"]["rod"]) == 6
