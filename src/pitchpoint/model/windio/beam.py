# SPDX-License-Identifier: Apache-2.0
"""Blade and tower of a windIO file as beams."""

from __future__ import annotations

import itertools
import os

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import ModelError
from pitchpoint.core.nearest import hint
from pitchpoint.geometry.beam_table import BeamTable
from pitchpoint.geometry.section_matrix import check_inertia, check_stiffness, symmetric
from pitchpoint.geometry.section_table import SectionTable
from pitchpoint.model.openfast.beamdyn import between, section_table
from pitchpoint.model.windio.blade import check_length, reference_axis
from pitchpoint.model.windio.ontology import Ontology, read_ontology, smooth

FloatArray = NDArray[np.float64]
_BETWEEN = 8
"""Points of the table of a tower for each interval of the file: stiffness is not linear in the diameter."""
_ENTRIES = [f"K{i + 1}{j + 1}" for i in range(6) for j in range(i, 6)]


def read_windio_beam(path: str | os.PathLike[str], component: str) -> BeamTable | SectionTable:
    """Beam properties of the blade or the tower of a turbine in the ontology windIO, version 1 or 2.

    A blade has the matrices of its elastic properties (`six_x_six` of version 1) and the damping factors of
    version 2. A tower has the tube of its outer diameter, wall thickness and material, with the outfitting
    factor in its mass. Axis 1 is flapwise without twist, or fore-aft.

    Parameters
    ----------
    path
        The file.
    component
        "blade" or "tower".

    Raises
    ------
    ModelError
        With every problem, its file and line.
    """
    file = read_ontology(path)
    file.get("components", component)
    file.stop()
    try:
        return _blade(file) if component == "blade" else _tower(file)
    except ModelError as error:
        if file.problems:
            raise
        raise ModelError([p.changed(file=file.path.name) for p in error.problems], str(path)) from None


def _blade(file: Ontology) -> SectionTable:
    blade: tuple[str, ...] = ("components", "blade")
    damping = np.zeros(6)
    if file.version == 2:
        at = (*blade, "structure", "elastic_properties")
        place, stiffness = _entries(file, (*at, "stiffness_matrix"))
        mass = _masses(file, (*at, "inertia_matrix"), place)
        if file.has(*at, "structural_damping"):
            damping = _damping(file, (*at, "structural_damping", "mu"))
        shape: tuple[str, ...] = (*blade, "outer_shape")
    else:
        at = (*blade, "elastic_properties_mb", "six_x_six")
        place, stiffness = _rows(file, (*at, "stiff_matrix"))
        mass = between(*_rows(file, (*at, "inertia_matrix")), place)
        shape = blade = at
    twist = file.curve(*shape, "twist")
    axis = reference_axis(file, blade)
    file.stop()
    file.check_angle(twist[1], *shape, "twist", "values")
    check_length(file, blade, float(axis[2][-1] - axis[2][0]))
    for k, both in enumerate(zip(stiffness, mass, strict=True)):
        for matrix, check, word in zip(
            both, (check_stiffness, check_inertia), ("stiffness", "mass"), strict=True
        ):
            try:
                check(matrix)
            except ValueError as error:
                file.problem(at, f"at station {k + 1} of the grid the {word} matrix {error}")
    file.stop()
    if place[0] != 0.0 or place[-1] != 1.0:
        file.problem(at, "is the range of the grid", f"{place[0]:g} to {place[-1]:g}", "0 to 1")
    file.stop()
    grid = _grid(file, blade)
    matrices = {"stiffness": stiffness, "inertia": mass, "damping": damping}
    return section_table(place, matrices, axis.T, -np.asarray(file.angle(smooth(twist, grid))), grid)


def _damping(file: Ontology, at: tuple[str, ...]) -> FloatArray:
    """Damping over stiffness of the six strains [s]."""
    found = file.numbers(*at)
    file.stop()
    if found.size != 6 or not (found >= 0.0).all():
        file.problem(at, "is out of range", ", ".join(f"{x:g}" for x in found), "six values >= 0")
        file.stop()
    return found


def _grid(file: Ontology, blade: tuple[str, ...]) -> FloatArray:
    """Shares of the length at the points of the reference axis."""
    return np.unique(np.concatenate([file.curve(*blade, "reference_axis", c)[0] for c in "xyz"]))


def _rows(file: Ontology, at: tuple[str, ...]) -> tuple[FloatArray, FloatArray]:
    """Grid and matrices, shape (n, 6, 6), of 21 values for each station."""
    file.get(*at)
    file.stop()
    grid = file.numbers(*at, "grid")
    count = len(file.entries(*at, "values"))
    rows = [file.numbers(*at, "values", k) for k in range(count)]
    file.stop()
    wrong = next((k for k, row in enumerate(rows) if row.size != len(_ENTRIES)), None)
    if wrong is not None:
        file.problem((*at, "values", wrong), "is the number of values", str(rows[wrong].size), "21")
    elif grid.size != count or count < 2 or (np.diff(grid) <= 0.0).any():
        file.problem((*at, "grid"), "does not increase, or has not one row of values for each point")
    file.stop()
    return grid, np.array([symmetric(row) for row in rows])


def _entries(file: Ontology, at: tuple[str, ...]) -> tuple[FloatArray, FloatArray]:
    """Grid and stiffness matrices, shape (n, 6, 6), of lists for each entry."""
    file.get(*at)
    file.stop()
    columns = []
    grid = file.numbers(*at, "grid")
    for name in _ENTRIES:
        diagonal = name[1] == name[2]
        if diagonal or file.has(*at, name):
            grid, values = file.curve(*at, values=name)
        else:
            values = np.zeros(grid.size)
        columns.append(values)
    file.stop()
    return grid, np.array([symmetric(row) for row in np.array(columns).T])


def _masses(file: Ontology, at: tuple[str, ...], place: FloatArray) -> FloatArray:
    """Mass matrices, shape (n, 6, 6), at given places."""
    names = ("mass", "cm_x", "cm_y", "i_edge", "i_flap", "i_cp", "i_plr")
    curves = {name: file.curve(*at, values=name) for name in names}
    file.stop()
    m, x, y, edge, flap, product, polar = (np.interp(place, *curves[name]) for name in names)
    out = np.zeros((place.size, 6, 6))
    for k in range(3):
        out[:, k, k] = m
    for (i, j), value in {
        (0, 5): -m * y,
        (1, 5): m * x,
        (2, 3): m * y,
        (2, 4): -m * x,
        (3, 4): -product,
    }.items():
        out[:, i, j] = out[:, j, i] = value
    out[:, 3, 3], out[:, 4, 4], out[:, 5, 5] = edge, flap, polar
    return out


def _tower(file: Ontology) -> BeamTable:
    """Tube with the outer diameter, the wall and the material of the file."""
    at = ("components", "tower")
    new = file.version == 2
    outer = (*at, "outer_shape" if new else "outer_shape_bem")
    inner = (*at, "structure" if new else "internal_structure_2d_fem")
    diameter = file.curve(*outer, "outer_diameter")
    layers = range(len(file.entries(*inner, "layers")))
    walls = [file.curve(*inner, "layers", k, "thickness") for k in layers]
    materials = [_material(file, (*inner, "layers", k, "material")) for k in layers]
    factor = file.number(*inner, "outfitting_factor", default=1.0)
    axis = reference_axis(file, at if new else outer)
    file.stop()
    if not walls:
        file.problem((*inner, "layers"), "has no wall")
        file.stop()
    own = _grid(file, at if new else outer)
    grid = np.unique(np.concatenate([own, diameter[0], *(wall[0] for wall in walls)]))
    grid = np.unique(np.concatenate([np.linspace(a, b, _BETWEEN + 1) for a, b in itertools.pairwise(grid)]))
    outside = np.interp(grid, *diameter)
    columns = {name: np.zeros(grid.size) for name in ("mass", "bending_1", "torsion", "axial", "shear_1")}
    polar = np.zeros(grid.size)
    for wall, (E, G, rho) in zip(walls, materials, strict=True):
        thickness = np.interp(grid, *wall)
        bore = outside - 2.0 * thickness
        for k in np.flatnonzero((bore < 0.0) | (thickness <= 0.0))[:1]:
            text = f"is the wall at {grid[k]:.3g} of the length"
            limit = f"> 0, at most half of the diameter {outside[k]:.6g}"
            file.problem((*inner, "layers"), text, f"{thickness[k]:.6g} m", limit)
            file.stop()
        area, second = 0.25 * np.pi * (outside**2 - bore**2), np.pi / 64.0 * (outside**4 - bore**4)
        for name, value in (
            ("mass", factor * rho * area),
            ("bending_1", E * second),
            ("torsion", 2.0 * G * second),
            ("axial", E * area),
            ("shear_1", 0.5 * G * area),
        ):
            columns[name] += value
        polar += 2.0 * factor * rho * second
        outside = bore
    z = np.interp(grid, own, axis[2])
    return BeamTable(
        position=np.r_[0.0, (z[1:-1] - z[0]) / (z[-1] - z[0]), 1.0],
        **columns,
        bending_2=columns["bending_1"],
        shear_2=columns["shear_1"],
        gyration=np.sqrt(polar / columns["mass"]),
        length=float(z[-1] - z[0]),
    )


def _material(file: Ontology, at: tuple[str | int, ...]) -> tuple[float, float, float]:
    """Young's modulus, shear modulus [Pa] and density [kg/m³] of a material by name."""
    name = file.get(*at)
    entries = file.entries("materials")
    k = next((k for k, m in enumerate(entries) if isinstance(m, dict) and m.get("name") == name), None)
    if k is None:
        known = [str(m.get("name")) for m in entries if isinstance(m, dict)]
        if known:
            text, remedy = f"names the material '{name}', which does not exist", hint(str(name), known)
            file.problem(at, text, remedy=remedy)
        return 1.0, 1.0, 1.0
    place = ("materials", k)
    E, rho = file.number(*place, "E", positive=True), file.number(*place, "rho", positive=True)
    if file.has(*place, "G"):
        return E, file.number(*place, "G", positive=True), rho
    return E, E / (2.0 * (1.0 + file.number(*place, "nu"))), rho
