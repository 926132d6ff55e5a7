# SPDX-License-Identifier: Apache-2.0
"""Volume and inertia of solids from STL files: closed forms, axes, and everything that can be wrong."""

from __future__ import annotations

import importlib.util
import math
import os

import numpy as np
import pytest

from pitchpoint.core.errors import GeometryError, MissingDependencyError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.mass_properties import gear_mass_properties
from pitchpoint.geometry.shaft_solid import shaft_solid
from pitchpoint.geometry.solid import gear_solid
from pitchpoint.geometry.solid_file import read_solids
from pitchpoint.geometry.solid_mass import Solid, SolidFile, round_inertia, solid_of_triangles
from tests.support import stl

FACES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def box(a, b, c):
    """Triangles of a box around the origin."""
    corners = 0.5 * np.array([[x * a, y * b, z * c] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)])
    quads = [[corners[k] for k in f] for f in FACES]
    return np.array([t for q in quads for t in ([q[0], q[1], q[2]], [q[0], q[2], q[3]])])


def turned(angles):
    """Rotation about x, y and z, one after the other."""
    turn = np.eye(3)
    for k, angle in enumerate(angles):
        c, s = math.cos(angle), math.sin(angle)
        one = np.eye(3)
        i, j = [n for n in range(3) if n != k]
        one[i, i] = one[j, j] = c
        one[i, j], one[j, i] = -s, s
        turn = one @ turn
    return turn


def test_a_box_anywhere_has_the_inertia_of_a_box():
    a, b, c = 0.3, 0.2, 0.1
    turn, shift = turned((0.4, -1.1, 2.3)), np.array([5.0, -7.0, 3.0])
    found = solid_of_triangles(box(a, b, c) @ turn.T + shift)
    volume = a * b * c
    own = volume / 12.0 * np.diag([b * b + c * c, c * c + a * a, a * a + b * b])
    assert found.volume == pytest.approx(volume, rel=1e-12)
    assert found.center == pytest.approx(shift, rel=1e-12)
    # the place is 90 times the size: fourteen digits of it leave twelve
    assert found.matrix == pytest.approx(turn @ own @ turn.T, rel=1e-11, abs=1e-11 * own.max())


def test_units_count_to_the_fifth_power(tmp_path):
    file = tmp_path / "box.stl"
    file.write_bytes(stl.binary(box(30.0, 20.0, 10.0)))
    small, large = read_solids(file, 1e-3).part(), read_solids(file, 1e-2).part()
    assert small.volume == pytest.approx(6e-6, rel=1e-6)  # STL holds seven digits
    assert large.volume / small.volume == pytest.approx(1e3, rel=1e-12)
    assert np.array(large.moments[:3]) / small.moments[:3] == pytest.approx([1e5] * 3, rel=1e-12)
    assert read_solids(file, 1e-3).unit == "1 mm"


@pytest.mark.parametrize("text", [False, True])
def test_both_forms_of_stl_say_the_same(tmp_path, text):
    file = tmp_path / "gear.stl"
    gear = CylindricalGear(z=17, m_n=2e-3, beta=0.1, b=0.02)
    triangles = 1e3 * gear_solid(gear, 12, 3, bore_diameter=0.01)
    if text:
        file.write_text(stl.text(triangles))
    else:
        file.write_bytes(stl.binary(triangles))
    solid = read_solids(file, 1e-3).part()
    exact = gear_mass_properties(gear, 1.0, bore_diameter=0.01)
    found = round_inertia(solid)
    # facets of 12 points a flank, three slices of the helix, a polygon for a bore
    assert solid.volume == pytest.approx(exact.mass, rel=3e-3)
    assert found.polar == pytest.approx(exact.polar_inertia, rel=3e-3)
    assert found.transverse == pytest.approx(exact.transverse_inertia, rel=3e-3)
    assert found.axis == pytest.approx((0.0, 0.0, 1.0), abs=1e-6)
    assert found.uneven < 1e-6


def test_the_axis_of_a_gear_is_found_wherever_it_points():
    turn = turned((0.7, 0.2, -0.9))
    gear = CylindricalGear(z=17, m_n=1e-3, b=0.01)
    found = round_inertia(solid_of_triangles(gear_solid(gear, 10) @ turn.T))
    assert abs(np.array(found.axis) @ turn[:, 2]) == pytest.approx(1.0, abs=1e-12)
    assert max(found.axis, key=abs) > 0.0
    known = round_inertia(solid_of_triangles(gear_solid(gear, 10) @ turn.T), turn[:, 2])
    assert (found.polar, found.transverse) == pytest.approx((known.polar, known.transverse), rel=1e-12)


def test_a_long_shaft_turns_about_its_least_moment():
    found = round_inertia(solid_of_triangles(shaft_solid([(0.3, 0.02, 0.0)], 60)))
    assert found.axis == (0.0, 0.0, 1.0)
    assert found.polar < 0.01 * found.transverse


def test_an_axis_that_the_inertia_does_not_tell_is_asked_for():
    cylinder = solid_of_triangles(shaft_solid([(math.sqrt(3.0) * 0.02, 0.04, 0.0)], 60))
    with pytest.raises(GeometryError, match=r"does not define an axis.*give axes"):
        round_inertia(cylinder)
    given = round_inertia(cylinder, (0.0, 0.0, 2.0))
    # m r^2/2 of a polygon of 60 corners, 0.4 % less
    assert given.polar == pytest.approx(0.5 * cylinder.volume * 0.02**2, rel=5e-3)


def test_a_lever_has_no_axis():
    rod = solid_of_triangles(box(0.3, 0.03, 0.01))
    assert round_inertia(rod).axis == (1.0, 0.0, 0.0)  # round but for 1 % of its moment across
    plate = solid_of_triangles(box(0.3, 0.2, 0.01))
    with pytest.raises(GeometryError, match="is not round about an axis"):
        round_inertia(plate)
    with pytest.raises(GeometryError, match="is not round about an axis"):
        round_inertia(plate, (0.0, 0.0, 1.0))
    with pytest.raises(GeometryError, match="correct axes"):
        round_inertia(solid_of_triangles(shaft_solid([(0.3, 0.02, 0.0)], 60)), (0.0, 1.0, 1.0))


def test_parts_are_chosen_by_name():
    one, two = (Solid(n, 1.0, (0.0,) * 3, (1.0,) * 6) for n in ("shaft", "key"))
    both = SolidFile((one, two), "millimetre")
    assert both.part("key") is two
    with pytest.raises(GeometryError, match="the file has several solids; there are 'shaft', 'key'"):
        both.part()
    with pytest.raises(GeometryError, match="'bolt' is not a solid of the file; there are 'shaft', 'key'"):
        both.part("bolt")
    with pytest.raises(GeometryError, match="there is 'shaft'"):
        SolidFile((one,), "inch").part("key")


GOOD = stl.binary(box(30.0, 20.0, 10.0))


@pytest.mark.parametrize(
    "name, data, unit, said",
    [
        ("a.iges", b"", 1e-3, "'a.iges' is not a supported file type .limit .step"),
        ("a.stl", GOOD, None, "unit: is missing: an STL file does not contain its unit"),
        ("a.stl", GOOD[:-10], 1e-3, "which is not a whole STL file"),
        ("a.stl", GOOD[:50], 1e-3, "is not an STL file"),
        ("a.stl", GOOD, 1e3, "is an unlikely size"),
        ("a.stl", stl.binary(box(30, 20, 10)[:-1]), 1e-3, "3 edges .*surface is open.*; close it$"),
        ("a.stl", stl.binary(box(30, 20, 10)[:, ::-1]), 1e-3, "is inside out"),
        ("a.stl", stl.binary(np.full((2, 3, 3), np.nan)), 1e-3, "not finite numbers"),
        (
            "a.step",
            b"ISO-10303-21;\nHEADER;",
            1e-3,
            "unit: 0.001 m has no effect: a STEP file contains its unit",
        ),
        ("a.step", b"ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1 = CARTES", None, "is cut short"),
        ("a.step", GOOD, None, "is not a STEP file"),
        ("a.step", b"", None, "is not a STEP file"),
    ],
)
def test_what_is_wrong_with_a_file_is_a_sentence(tmp_path, name, data, unit, said):
    file = tmp_path / name
    file.write_bytes(data)
    with pytest.raises(GeometryError, match=said):
        read_solids(file, unit)


def test_a_missing_file_is_a_sentence(tmp_path):
    for name, unit in (("none.stl", 1e-3), ("none.step", None)):
        with pytest.raises(GeometryError, match=f"'{name}' cannot be read: No such file"):
            read_solids(tmp_path / name, unit)


def test_a_changed_file_is_read_again(tmp_path):
    file = tmp_path / "box.stl"
    file.write_bytes(GOOD)
    first = read_solids(file, 1e-3).part().volume
    file.write_bytes(stl.binary(box(30.0, 20.0, 5.0)))
    os.utime(file, ns=(1, 1))
    assert read_solids(file, 1e-3).part().volume == pytest.approx(0.5 * first, rel=1e-6)


def test_without_occ_the_extra_is_named(tmp_path, monkeypatch):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    file = tmp_path / "a.step"
    file.write_bytes(b"ISO-10303-21;\nENDSEC;\nEND-ISO-10303-21;\n")
    with pytest.raises(MissingDependencyError, match=r"pip install 'pitchpoint\[cad\]'"):
        read_solids(file)
