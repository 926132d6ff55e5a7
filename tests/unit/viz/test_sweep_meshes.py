# SPDX-License-Identifier: Apache-2.0
"""Tables and plots of the meshes of a sweep stay readable with many equal or different meshes."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.mesh_sweep import mesh_sweeps
from pitchpoint.viz import theme
from pitchpoint.viz.report.sweeps import sweep_section
from pitchpoint.viz.sweep_meshes import MAX_MESHES, contact_sentences, mesh_rows, percent
from pitchpoint.viz.sweep_plot import plot_meshes

FREQUENCIES = np.linspace(1000.0, 3000.0, 9)


def points(shares: dict[str, float]) -> list[dict[str, object]]:
    """Points up and down; the share of contact loss at 2000 Hz by mesh, forces that grow with it."""
    found = []
    for direction, grid in (("up", FREQUENCIES), ("down", FREQUENCIES[::-1])):
        for f in grid:
            meshes = {
                mesh: {
                    "deflection": {"mean": 0.0, "rms": 1e-6, "min": -1e-6, "max": 2e-6},
                    "mesh_force": {"mean": 1e3, "rms": 0.0, "min": -2e3 - 1e4 * share, "max": 1e3},
                    "contact_loss_share": share if f == 2000.0 else 0.0,
                    "closing_speed_max": share,
                }
                for mesh, share in shares.items()
            }
            first = next(iter(meshes.values()))
            found.append({"direction": direction, "mesh_frequency": float(f), **first, "meshes": meshes})
    return found


def cells(one):
    """Force and contact loss."""
    return [one.direction, f"{one.force:.4g}", percent(one.loss)]


def test_equal_meshes_of_planets_have_common_rows_and_curves():
    names = {f"sun-planet_{k}": 0.0 for k in range(1, 6)} | {f"planet_{k}-ring": 0.3 for k in range(1, 6)}
    rows, note = mesh_rows(mesh_sweeps(points(names)), cells)
    assert [row[:2] for row in rows] == [
        ["sun-planet_1 … sun-planet_5", "up"],
        ["sun-planet_1 … sun-planet_5", "down"],
        ["planet_1-ring … planet_5-ring", "up"],
        ["planet_1-ring … planet_5-ring", "down"],
    ]
    assert note == ""
    figure, left = plot_meshes(points(names), "mesh_force")
    assert [line.name for line in figure.data] == [", ".join(row[:2]) for row in rows]
    assert left == ""
    assert contact_sentences(mesh_sweeps(points(names))) == [
        "The flanks of planet_1-ring … planet_5-ring separate at 2 of 18 points, for up to 30 % of the time "
        "at 2000 Hz upwards.",
        "The flanks of sun-planet_1 … sun-planet_5 stay in contact at every point.",
    ]


def test_curves_of_sun_and_ring_meshes_have_both_names():
    names = {name.format(k): 0.0 for name in ("sun-planet_{}", "planet_{}-ring") for k in range(1, 5)}
    figure, _ = plot_meshes(points(names), "mesh_force")
    both = "sun-planet_1 … sun-planet_4, planet_1-ring … planet_4-ring"
    assert [line.name for line in figure.data] == [f"{both}, up", f"{both}, down"]


def test_of_many_meshes_the_swept_one_and_the_worst_are_listed():
    names = {f"m{k}": 0.01 * k for k in range(20)}
    rows, note = mesh_rows(mesh_sweeps(points(names)), cells)
    assert len(rows) == 2 * MAX_MESHES
    assert [row[0] for row in rows[::2]] == ["m0", *(f"m{k}" for k in range(21 - MAX_MESHES, 20))]
    worst = 20 - MAX_MESHES
    assert note.startswith(f"{worst} more meshes have contact loss up to {worst} % and forces up to 3000 N;")
    figure, left = plot_meshes(points(names), "contact_shares")
    assert len(figure.data) == 2 * len(theme.SERIES)
    assert {figure.data[0].name, figure.data[-1].name} == {"m0, up", "m19, down"}
    assert left == f"{20 - len(theme.SERIES)} more meshes with smaller values are not drawn."
    assert len(contact_sentences(mesh_sweeps(points(names)))) == 6


def test_the_section_names_the_meshes_and_escapes_them():
    section = sweep_section({"s": {"points": points({"<a>": 0.0, "b": 0.5}), "jumps": []}})
    html = "".join(section.parts)
    assert "The flanks of b separate at 2 of 18 points" in html
    assert "The flanks of &lt;a&gt; stay in contact at every point." in html
    assert '<th scope="row">&lt;a&gt;</th>' in html
    assert list(section.figures) == ["deflection", "mesh_force", "contact_shares", "closing_speed_max"]
    assert "No jump found in the deflection of &lt;a&gt;." in html


def test_a_single_mesh_has_no_table_and_the_colours_of_the_directions():
    section = sweep_section({"s": {"points": points({"stage": 0.5}), "jumps": []}})
    assert "<table" not in "".join(section.parts)
    assert "The flanks of stage separate at 2 of 18 points" in "".join(section.parts)
    lines = section.figures["closing_speed_max"].data
    assert [(line.name, line.line.color) for line in lines] == [
        (f"speed {d}", theme.SWEEP[d][0]) for d in ("up", "down")
    ]
    assert max(lines[0].y) == pytest.approx(0.5)
    drawn = section.figures["mesh_force"]
    assert drawn.layout.yaxis.title.text == "maximum magnitude of mesh force [N]"
    assert max(drawn.data[0].y) == pytest.approx(7e3)


def test_no_mesh_loses_contact():
    found = mesh_sweeps(points({"a": 0.0, "b": 0.0}))
    assert contact_sentences(found) == ["The flanks of a and b stay in contact at every point of this sweep."]
