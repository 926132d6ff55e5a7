# SPDX-License-Identifier: Apache-2.0
"""Flexible rims in model files: what is refused, what `check` and `modes` print, and the scene."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.cli.check import summary
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.report.machine_tables import rim_table
from pitchpoint.report.scene.build import scene_of
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from pitchpoint.system.rules.flexible_rim import coordinates_of_rim
from tests.support.beam_ring import beam_ring
from tests.support.planet_stages import stage_file

RIM = "flexible_rim: {waves: 4}"
MESH = "stiffness: {law: constant, value: 5e8 N/m}, backlash: {normal: 0.2 mm}"


def text(rim=RIM, outside="bore_diameter: 330 mm", **how):
    """Model file whose ring has these keys."""
    keys = ", ".join(k for k in ("tip_diameter: 292.5 mm", outside, rim) if k)
    return stage_file(**how).replace("tip_diameter: 292.5 mm", keys, 1)


@pytest.mark.parametrize(
    ("found", "where", "words"),
    [
        (text(outside=""), "gears.ring.flexible_rim", "requires the outside of the ring"),
        (text(outside="rim_thickness: 150 mm"), "gears.ring.rim_thickness", "too thick to bend as a ring"),
        (text().replace("type: internal, ", "", 1), "gears.ring.flexible_rim", "is for internal gears only"),
        (text("flexible_rim: {waves: 1}"), "gears.ring.flexible_rim.waves", "out of range"),
        (text("flexible_rim: {waves: 17}"), "gears.ring.flexible_rim.waves", "out of range"),
        (
            text("flexible_rim: {supports: {number: 8}}"),
            "gears.ring.flexible_rim.supports",
            "have no stiffness",
        ),
        (
            text("flexible_rim: {supports: {radial: 1e8}}"),
            "gears.ring.flexible_rim.supports",
            "gives none of number, angles",
        ),
        (
            text("flexible_rim: {supports: {angles: [10 deg, 90 deg, 370 deg], radial: 1e8}}"),
            "gears.ring.flexible_rim.supports.angles[2]",
            "is the angle of entry 1 as well",
        ),
    ],
)
def test_impossible_rims_are_refused(found, where, words):
    with pytest.raises(ModelError) as error:
        loads_model(found)
    problems = {p.where: str(p) for p in error.value.problems}
    assert words in problems[where]
    assert "line 3" in problems[where]


def test_a_rim_on_a_shaft_is_refused():
    found = text().replace("  ring: {gears: [ring], motion: fixed, position: [0, 0, 0]}\n", "")
    found += "shafts:\n  ring: {gears: {ring: 50 mm}, sections: [{length: 100 mm, diameter: 50 mm}]}\n"
    with pytest.raises(ModelError, match="is on the shaft ring"):
        loads_model(found)


def test_check_lists_the_ring_modes():
    supports = "supports: {number: 8, radial: 20 N/um, tangential: 20 N/um}"
    model = loads_model(text(f"flexible_rim: {{waves: 4, {supports}}}"))
    found = summary(model)
    rim = found["flexible_rims"]["ring"]
    assert rim["waves"] == [2, 3, 4]
    table = rim_table(found["flexible_rims"])  # also in the report
    assert [row[:2] for row in table.rows] == [["ring", "2"], ["ring", "3"], ["ring", "4"]]
    assert rim["free"][0] == pytest.approx(283.400, abs=1e-3)
    assert [len(pair) for pair in rim["supported"]] == [2, 2, 2]
    one, two = rim["supported"][2]  # n = 4 on eight supports
    assert two > 1.01 * one > rim["free"][2]
    system = compile_model(model)
    assert found["degrees_of_freedom"] == len(system.layout.coordinates)
    assert found["mobility"]["coordinates"] == len(system.layout.coordinates)


def test_modes_are_named_by_their_waves():
    found = find_modes(compile_model(loads_model(text())))
    assert found.names[:5].count("ring mode of ring, n = 3") == 1
    assert sum("ring mode of ring, n = 2" in name for name in found.names) == 2


def test_whole_ring_gear_bends_in_the_scene():
    model = loads_model(text())
    scene = scene_of(model, modes=4)
    solid = next(s for s in scene.solids if s.name == "ring")
    shapes, node = solid.modal.shapes, solid.modal.node
    assert solid.modal.names == tuple(coordinates_of_rim(model, "ring"))
    assert shapes.shape[0] == 6
    x, y, _ = (np.eye(3) if solid.axes is None else solid.axes) @ solid.points.T
    radial = np.einsum("ni,ni->n", shapes[0, node], solid.points) / np.hypot(x, y)
    wanted = np.cos(2.0 * np.arctan2(y, x))
    assert np.abs(radial - wanted).max() < 0.05  # a quarter of a pitch
    assert {"ring"} == set(scene.modes[1].modal)


ELEMENTS = (
    "flexible_rim: {waves: 8, finite_elements: {file: ring.npz, modes: 24, depth: 3, held_nodes: "
    "{a: {position: [158.5 mm, 0, 0]}, b: {position: [-79.25 mm, 137.2650265 mm, 0]}, "
    "c: {position: [-79.25 mm, -137.2650265 mm, 0]}}}}"
)


def elements(tmp_path, rim=ELEMENTS):
    """Model whose ring is made of beams at a radius of 158.5 mm, held at three nodes, and its structure."""
    ring = beam_ring(0.1585, 0.0125, 0.04, 48)
    np.savez(tmp_path / "ring.npz", K=ring.K.toarray(), M=ring.M.toarray(), places=ring.places)
    file = tmp_path / "model.yaml"
    between = "angles: [60 deg, 180 deg, 300 deg]"
    file.write_text(text(rim, outside="", more=between, torque=1.0, mesh=MESH), encoding="utf-8")
    return load_model(file), ring


def test_rim_of_finite_elements_deflects_like_the_whole_structure(tmp_path):
    """Strain energy under the ring forces of three planets between the held nodes, by all displacements.

    The forces act at the working pitch circle of the planets. Modes omitted and waves above 8 have 5 %.
    """
    model, ring = elements(tmp_path)
    found = solve_equilibrium(compile_model(model))
    F = np.array([float(found[f"mesh_force[planet_{k}-ring]"]) for k in (1, 2, 3)])
    alpha, r_w = np.radians(20.0), 0.5 * 99 * 3e-3
    load = np.zeros(ring.size)
    for node, force in zip((8, 24, 40), F, strict=True):  # 60 deg from the held nodes
        theta = 2.0 * np.pi * node / 48
        out, along = (np.cos(theta), np.sin(theta)), (-np.sin(theta), np.cos(theta))
        radial, tangential = abs(force) * np.sin(alpha), force * np.cos(alpha)
        load[6 * node : 6 * node + 2] = radial * np.array(out) + tangential * np.array(along)
        load[6 * node + 5] = (r_w - 0.1585) * tangential
    free = np.flatnonzero(~np.isin(ring.node, (0, 16, 32)))
    K = ring.K[free][:, free].toarray()
    exact = 0.5 * load[free] @ np.linalg.solve(K, load[free])
    assert float(found["strain_energy[ring.rim]"]) == pytest.approx(exact, rel=0.05)
    assert summary(model)["flexible_rims"]["ring"]["waves"] == [0] * 24
    assert len(scene_of(model).solids) > 4


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (("depth: 3", "depth: 1"), "0 sections with nodes at radii"),
        (("158.5 mm, 0, 0", "150 mm, 0, 0"), r"held_nodes.a .*has no node at this position"),
        (("ring.npz", "none.npz"), "none.npz"),
        (("waves: 8", "supports: {number: 3, radial: 1e8}"), "cannot be combined with finite_elements"),
    ],
)
def test_impossible_finite_elements_are_refused(tmp_path, change, words):
    with pytest.raises(ModelError, match=words) as error:
        compile_model(elements(tmp_path, ELEMENTS.replace(*change))[0])
    assert "gears.ring.flexible_rim" in str(error.value)


def test_ring_on_springs_moves_as_a_whole_and_bends():
    """Twelve springs hold a planar ring alone: N (k_r + k_t)/2 in x and y, N k_t r^2 about the axis."""
    radial, tangential, count = 2e7, 3e7, 12
    supports = f"supports: {{number: {count}, radial: {radial}, tangential: {tangential}}}"
    ring = text(f"flexible_rim: {{waves: 4, {supports}}}").partition("planetary_stages")[0]
    ring += "bodies: {ring: {gears: [ring], motion: planar, position: [0, 0, 0]}}\n"
    model = loads_model(ring.replace("  sun:", "  spare:"))
    found = find_modes(compile_model(model))
    inertia, outer = model.body_inertia("ring"), 0.165
    lateral = 0.5 * count * (radial + tangential) / inertia.mass
    turning = count * tangential * outer**2 / inertia.polar
    wanted = np.sqrt([lateral, lateral, turning]) / (2.0 * np.pi)
    pairs = np.concatenate(summary(model)["flexible_rims"]["ring"]["supported"])
    np.testing.assert_allclose(found.frequency, np.sort([*wanted, *pairs]), rtol=1e-9)
    names = found.names
    assert {"translation x of ring", "translation y of ring", "rotation z of ring"} <= set(names)
    assert sum("ring mode of ring" in n for n in names) == 6
