# SPDX-License-Identifier: Apache-2.0
"""Files of triangles: STL in both forms and NumPy, and what is found wrong with them."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.solid import gear_solid
from pitchpoint.geometry.triangle_file import (
    MAX_TRIANGLES,
    Triangles,
    placed_triangles,
    read_triangles,
    triangle_faults,
)
from pitchpoint.io.gear_export import export_gear
from tests.support.contacts import box
from tests.support.stl import binary, text

SURFACE = box((30.0, 20.0, 10.0), 2)
BOX = SURFACE.vertices[SURFACE.faces]


def triangles(corners, normals=None):
    corners = np.asarray(corners, float)
    return Triangles(corners, np.zeros((len(corners), 3)) if normals is None else normals)


def volume(corners):
    return np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6.0


@pytest.mark.parametrize("form", ["binary", "binary that begins with solid", "text", "two solids", "numpy"])
def test_every_form_gives_the_same_triangles(tmp_path, form):
    """Binary files hold 32-bit numbers, whole ones here."""
    file = tmp_path / ("part.npy" if form == "numpy" else "part.stl")
    if form == "numpy":
        np.save(file, BOX)
    elif form == "text":
        file.write_text(text(BOX))
    elif form == "two solids":
        file.write_text(text(BOX[:7]) + text(BOX[7:]).upper())
    else:
        file.write_bytes(binary(BOX, b"solid box" if "solid" in form else b"box"))
    found = read_triangles(file)
    np.testing.assert_array_equal(found.corners, BOX)
    assert triangle_faults(found, 1e-3) == []
    placed = placed_triangles(found, 1e-3)
    assert volume(placed) == pytest.approx(6e-6, rel=1e-12)
    assert volume(placed_triangles(found, 1e-3, hollow=True)) == pytest.approx(-6e-6, rel=1e-12)


def test_the_solid_of_a_gear_comes_back(tmp_path):
    gear = CylindricalGear(z=17, m_n=2e-3, b=0.01)
    export_gear(gear, tmp_path / "gear.stl", n_flank=20)
    found = read_triangles(tmp_path / "gear.stl")
    assert triangle_faults(found, 1e-3) == []
    # 32-bit millimetres
    assert volume(placed_triangles(found, 1e-3)) == pytest.approx(volume(gear_solid(gear, 20)), rel=1e-6)


def test_a_changed_file_is_read_again(tmp_path):
    file = tmp_path / "part.stl"
    for scale in (1.0, 2.0):
        file.write_text(text(scale * BOX) + " " * int(scale))
        assert read_triangles(file).corners.max() == 15.0 * scale


def moved(corner, by):
    found = BOX.copy()
    found[corner] += by
    return found


TURNED = BOX.copy()
TURNED[4] = TURNED[4][::-1]
SLIVER = np.concatenate([BOX, [[[-15, -10, -5], [0, -10, -5], [15, -10, -5]]]])
POINT = np.concatenate([BOX, [[[-15, -10, -5], [-15, -10, -5], [0, -10, -5]]]])
FAULTS = {
    "nothing": (triangles(np.zeros((0, 3, 3))), {}, "has no triangles"),
    "too many": (triangles(np.zeros((MAX_TRIANGLES + 1, 3, 3))), {}, "are too many"),
    "not a number": (triangles(moved((3, 1), np.nan)), {}, "the first is number 4"),
    "metres instead of millimetres": (triangles(1e-3 * BOX), {}, "is an unlikely size"),
    "millimetres taken as metres": (triangles(10.0 * BOX), {"unit": 1.0}, "is an unlikely size"),
    "one place": (triangles(np.zeros((4, 3, 3))), {}, "is an unlikely size"),
    "no area": (triangles(SLIVER), {"open_edges": True}, "have no area, the first is number 49"),
    "reversed": (triangles(TURNED), {}, "are used in the same direction by two triangles"),
    "a hole": (triangles(BOX[1:]), {}, "belong to one triangle only"),
    "a crack": (triangles(moved((3, 1), 0.01)), {}, "belong to one triangle only"),
    "inside out": (triangles(BOX[:, ::-1]), {}, "is inside out"),
    "against its normals": (
        triangles(BOX, -np.ones((48, 1)) * np.cross(BOX[:, 1] - BOX[:, 0], BOX[:, 2] - BOX[:, 0])),
        {},
        "are opposite to their normals, the first is number 1",
    ),
}


@pytest.mark.parametrize("name", FAULTS)
def test_faults_are_found(name):
    found, keys, words = FAULTS[name]
    faults = triangle_faults(found, **{"unit": 1e-3, **keys})
    assert words in faults[0].text, faults
    assert len(faults) == 1 or name == "no area"


@pytest.mark.parametrize(
    ("found", "keys"),
    [(triangles(BOX[1:]), {"open_edges": True}), (triangles(POINT), {}), (triangles(BOX - 0.0), {})],
)
def test_what_does_no_harm_is_no_fault(found, keys):
    """Borders that were requested; triangles with two corners in one place, which are omitted."""
    assert triangle_faults(found, 1e-3, **keys) == []


BROKEN = {
    "empty.stl": (b"", "is not an STL file: it has 0 bytes"),
    "short.stl": (binary(BOX)[:-1], "which is not a whole STL file"),
    "long.stl": (binary(BOX) + b"\n", "which is not a whole STL file"),
    "cut.stl": (text(BOX)[:3000].encode(), "is not a whole STL file"),
    "words.stl": (text(BOX).replace("vertex 1.5", "vertex x1.5", 1).encode(), "has no vector in line"),
    "text.npy": (b"1 2 3", "cannot be read"),
    "none.npy": (b"", "cannot be read"),
}


@pytest.mark.parametrize("name", BROKEN)
def test_broken_files_are_refused(tmp_path, name):
    data, words = BROKEN[name]
    (tmp_path / name).write_bytes(data)
    with pytest.raises(GeometryError, match=words) as caught:
        read_triangles(tmp_path / name)
    assert name in str(caught.value)


def test_arrays_of_other_shapes_are_refused(tmp_path):
    for name, array in (("flat", np.zeros((4, 9))), ("words", np.array([["a"]])), ("complex", BOX + 0j)):
        np.save(tmp_path / f"{name}.npy", array)
        with pytest.raises(GeometryError, match="cannot be read: it"):
            read_triangles(tmp_path / f"{name}.npy")
    with pytest.raises(GeometryError, match="No such file"):
        read_triangles(tmp_path / "nowhere.stl")
