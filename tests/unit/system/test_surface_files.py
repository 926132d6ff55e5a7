# SPDX-License-Identifier: Apache-2.0
"""Contacts of surfaces from files: lines of contact, triangles from STL, what is refused."""

from __future__ import annotations

import os

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.core.provenance import content_hash
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.contacts import ball, box, read
from tests.support.mechanism_files import accelerations
from tests.support.stl import binary, text

ROLLER = """\
gravity: [0, 0, -9.81 m/s^2]
bodies:
  roller: {mass: 2 kg, inertia_tensor: [1e-3, 1e-3, 1e-3, 0, 0, 0], position: [0, 0, 40 mm], markers: {
    axis: {axes: {z: [1, 0, 0]}}}}
  drum: {motion: fixed, position: [0, 0, 0], markers: {axis: {position: [5 mm, 0, 0], axes: {z: [1, 0, 0]}}}}
joints:
  j: {type: prismatic, bodies: [ground, roller], axes: {z: [0, 0, 1]}}
surface_contacts:
  c:
    ends: [drum.axis, roller.axis]
    first: {shape: cylinder, radius: 30 mm, length: 100 mm}
    second: {shape: cylinder, radius: 10 mm, length: 40 mm}
    line: true
    law: {force: 10 N, depth: 10 um, exponent: 1.111111111111}
"""
PLATE = """\
gravity: [0, 0, -9.81 m/s^2]
bodies:
  part: {mass: 0.5 kg, inertia_tensor: [1e-4, 1e-4, 1e-4, 0, 0, 0], position: [0, 0, 5 mm], markers: {
    file: {position: [0, 0, 2 mm], axes: {z: [0, 1, 0], x: [1, 0, 0]}}}}
joints:
  j: {type: prismatic, bodies: [ground, part], axes: {z: [0, 0, 1]}}
surface_contacts:
  c:
    ends: [part.file, ground]
    first: {shape: triangles, file: part.stl, unit: 1 mm}
    second: {shape: plane}
    law: {force: 1e9 N, depth: 1 mm, exponent: 1}
"""
SURFACE = box((30.0, 10.0, 20.0), 2)
BOX = SURFACE.vertices[SURFACE.faces]


def loads(content, folder):
    return loads_model(content, file=str(folder / "m.yaml"))


def test_a_roller_rests_on_a_drum():
    """Of the law 10 N at 10 um its weight presses u = 10 um 1.962^0.9; the first one is the drum."""
    model = loads_model(ROLLER)
    assert loads_model(dump_model(model)) == model
    system = compile_model(model)
    row = system.records["surface_surface"][0]
    assert row["size_i"].tolist() == [0.01, 0.04]  # the shorter one carries the slices
    found = find_equilibrium(system)
    z = system.layout.coordinate("roller.z")
    assert -found.state.q[z] == pytest.approx(1e-5 * 1.962**0.9, rel=1e-6)
    assert read(system, found.state, "contact_force[c]") == pytest.approx(19.62, rel=1e-9)


def test_a_pin_rests_in_its_bore():
    content = ROLLER.replace("radius: 30 mm, length: 100 mm", "radius: 10.2 mm, length: 100 mm, hollow: true")
    content = content.replace("position: [0, 0, 40 mm]", "position: [0, 0, -0.2 mm]").replace(
        "    line: true\n", ""
    )
    system = compile_model(loads_model(content))
    found = find_equilibrium(system)
    z = system.layout.coordinate("roller.z")
    assert -found.state.q[z] == pytest.approx(1e-5 * 1.962**0.9, rel=1e-6)


@pytest.mark.parametrize("form", ["binary", "text", "numpy"])
def test_triangles_are_placed_by_their_marker(tmp_path, form):
    """A box of 30 x 10 x 20 mm whose y is the height: 5 mm + 2 mm - 5 mm over the plate, 600 mm^2 below."""
    content = PLATE
    if form == "numpy":
        np.save(tmp_path / "part.npy", BOX)
        content = PLATE.replace("part.stl", "part.npy")
    elif form == "text":
        (tmp_path / "part.stl").write_text(text(BOX))
    else:
        (tmp_path / "part.stl").write_bytes(binary(BOX))
    model = loads(content, tmp_path)
    assert loads(dump_model(model), tmp_path) == model
    system = compile_model(model)
    state = system.initial_state()
    assert read(system, state, "gap[c]") == pytest.approx(2e-3, abs=1e-12)
    state.q[:] = -2.1e-3
    a, _ = accelerations(system, state)
    assert a[0] == pytest.approx(1e9 * 0.1 * 600e-6 / 0.5 - 9.81, rel=1e-6)


def test_a_hollow_of_triangles_is_a_cup(tmp_path):
    """The box inside a box that is turned round: it rests on the floor of the other one."""
    (tmp_path / "part.stl").write_bytes(binary(BOX))
    np.save(tmp_path / "room.npy", 2e-3 * BOX)
    content = PLATE.replace(
        "{shape: plane}", "{shape: triangles, file: room.npy, hollow: true}\n    depth: 2 mm"
    )
    system = compile_model(
        loads(content.replace("position: [0, 0, 5 mm]", "position: [0, 0, -6 mm]"), tmp_path)
    )
    state = system.initial_state()
    assert read(system, state, "contact_force[c]") == 0.0
    state.q[:] = -1.1e-3  # the room reaches from -20 to 20 mm along z, the part from -9 - 1.1 mm on
    assert read(system, state, "contact_force[c]") == 0.0
    state.q[:] = -11.1e-3
    # Half of what 600 mm^2 of the part press, and half of what the floor presses, a triangle as deep as its
    # centroid: of eight with 150 mm^2 those four count whose centroids are 10 mm from the middle, below the
    # 30 mm of the part, which are 600 mm^2 again. The rounding of 20 mm is left, where 0.1 mm count.
    assert read(system, state, "contact_force[c]") == pytest.approx(1e9 * 0.1 * 600e-6, rel=1e-12)


def test_the_hash_of_a_model_covers_the_triangles(tmp_path):
    file = tmp_path / "part.stl"
    file.write_bytes(binary(BOX))
    one = loads(PLATE, tmp_path)
    assert content_hash(loads(PLATE, tmp_path)) == content_hash(one)
    before = content_hash(one)
    file.write_bytes(binary(1.5 * BOX))
    os.utime(file, ns=(1, 1))  # the same size, and not the same time
    assert content_hash(loads(PLATE, tmp_path)) != before


@pytest.mark.parametrize(
    ("shape", "start"),
    [("sphere, radius: 40 mm, hollow: true", 5), ("torus, radius: 25 mm, tube: 10 mm", 16)],
)
def test_triangles_rest_in_simple_shapes(tmp_path, shape, start):
    """Tangents and forces are tried with the element; here that either order of the surfaces will do."""
    surface = ball(20.0, 3)
    (tmp_path / "part.stl").write_bytes(binary(surface.vertices[surface.faces]))
    content = PLATE.replace("ends: [part.file, ground]", "ends: [ground, part.file]")
    content = content.replace("[0, 0, 5 mm]", f"[0, 0, {start} mm]")
    content = content.replace("    first: {", "    second: {").replace(
        "    second: {shape: plane}", f"    first: {{shape: {shape}}}"
    )
    system = compile_model(loads(content, tmp_path))
    found = find_equilibrium(system)
    assert read(system, found.state, "contact_force[c]") > 0.0
    assert np.all(np.isfinite(evaluate.observe(system, found.state)))


@pytest.mark.parametrize("start", [18.1, 20, 30])
def test_a_ball_is_found_at_rest_on_triangles(tmp_path, start):
    """The search comes back out of the box from wherever its steps land."""
    (tmp_path / "part.stl").write_bytes(binary(BOX))
    content = PLATE.replace(
        "first: {shape: triangles, file: part.stl, unit: 1 mm}", "first: {shape: sphere, radius: 10 mm}"
    )
    content = content.replace("{shape: plane}", "{shape: triangles, file: part.stl, unit: 1 mm}")
    content = content.replace("force: 1e9 N, depth: 1 mm", "force: 4.905 N, depth: 0.1 mm")
    system = compile_model(loads(content.replace("[0, 0, 5 mm]", f"[0, 0, {start} mm]"), tmp_path))
    found = find_equilibrium(system)
    assert 1e-3 * start + found.state.q[0] == pytest.approx(0.0179, abs=1e-9)  # the marker is 2 mm above


ROUND = binary(BOX)
TURNED = BOX.copy()
TURNED[4] = TURNED[4][::-1]
# (file, changes, content of part.stl, place, words)
CASES = {
    "no unit": (
        PLATE,
        [(", unit: 1 mm", "")],
        ROUND,
        "surface_contacts.c.first.unit",
        "does not contain its unit",
    ),
    "metres in millimetres": (
        PLATE,
        [],
        binary(1e-3 * BOX),
        "surface_contacts.c.first.file",
        "3e-05 m is an unlikely size (limit 0.0002 m to 20 m); check unit",
    ),
    "open": (
        PLATE,
        [],
        binary(BOX[:-1]),
        "surface_contacts.c.first.file",
        "3 edges belong to one triangle only",
    ),
    "turned": (PLATE, [], binary(TURNED), "surface_contacts.c.first.file", "are used in the same direction"),
    "inside out": (PLATE, [], binary(BOX[:, ::-1]), "surface_contacts.c.first.file", "is inside out"),
    "cut off": (PLATE, [], ROUND[:-9], "surface_contacts.c.first.file", "not a whole STL file"),
    "not there": (PLATE, [], None, "surface_contacts.c.first.file", "names a file that does not exist"),
    "a file of a plane": (
        PLATE,
        [("shape: plane", "shape: plane, unit: 1 mm")],
        ROUND,
        "surface_contacts.c.second.unit",
        "has no effect: a plane has no file",
    ),
    "no file": (
        PLATE,
        [("file: part.stl, unit: 1 mm", "unit: 1 mm")],
        ROUND,
        "surface_contacts.c.first.file",
        "required for shape triangles",
    ),
    "side by side": (
        ROLLER,
        [("    line: true\n", "")],
        None,
        "surface_contacts.c",
        "0 deg between their axes is between parallel cylinders",
    ),
    "a line of a plane": (
        ROLLER,
        [
            ("radius: 30 mm, length: 100 mm", "radius: 30 mm"),
            ("shape: cylinder, radius: 30 mm", "shape: plane"),
        ],
        None,
        "surface_contacts.c.line",
        "has no effect",
    ),
    "a bore that is too narrow": (
        ROLLER,
        [("radius: 30 mm, length: 100 mm", "radius: 10 mm, length: 100 mm, hollow: true")],
        None,
        "surface_contacts.c.second.radius",
        "does not fit into the bore",
    ),
    "two bores": (
        ROLLER,
        [
            ("length: 100 mm", "length: 100 mm, hollow: true"),
            ("length: 40 mm", "length: 40 mm, hollow: true"),
        ],
        None,
        "surface_contacts.c",
        "is between a hollow cylinder and a hollow cylinder, which touch at an edge",
    ),
    "a line without length": (
        ROLLER,
        [("radius: 10 mm, length: 40 mm", "radius: 10 mm")],
        None,
        "surface_contacts.c.second.length",
        "required for shape cylinder",
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_wrong_surfaces_are_told_with_their_line(tmp_path, case):
    content, changes, data, where, words = CASES[case]
    for old, new in changes:
        assert old in content
        content = content.replace(old, new)
    if data is not None:
        (tmp_path / "part.stl").write_bytes(data)
    with pytest.raises(ModelError) as caught:
        loads(content, tmp_path)
    assert [p.where for p in caught.value.problems] == [where], caught.value
    assert words in str(caught.value)
    assert caught.value.problems[0].line is not None
