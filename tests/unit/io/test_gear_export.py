# SPDX-License-Identifier: Apache-2.0
"""Exports of gears: readable back, closed, and with the right volume."""

from __future__ import annotations

import csv
import math
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.mass_properties import gear_mass_properties
from pitchpoint.geometry.rack import BasicRack
from pitchpoint.geometry.solid import gear_solid
from pitchpoint.geometry.tooth_form import gear_outline
from pitchpoint.io.gear_export import export_gear

SPUR = CylindricalGear(z=17, m_n=1e-3, b=0.01)
SOLIDS = {
    "spur": (SPUR, {}),
    "bore": (SPUR, {"bore_diameter": 5e-3}),
    "undercut": (CylindricalGear(z=8, m_n=1e-3, b=0.01), {"bore_diameter": 2e-3}),
    "left hand": (CylindricalGear(z=24, m_n=1e-3, beta=-0.4, b=0.02), {"bore_diameter": 8e-3}),
    "rim and web": (
        CylindricalGear(z=60, m_n=1e-3, beta=0.2, b=0.02),
        {"bore_diameter": 0.01, "rim_thickness": 4e-3, "web_thickness": 6e-3},
    ),
    "rim and web without bore": (
        CylindricalGear(z=60, m_n=1e-3, b=0.02),
        {"rim_thickness": 4e-3, "web_thickness": 6e-3},
    ),
    "full rounding": (CylindricalGear(z=20, m_n=1e-3, x=0.2, b=0.01, rack=BasicRack(rho_fP_star=1.0)), {}),
    "ring": (CylindricalGear(z=-56, m_n=1e-3, x=-0.5, b=0.02), {}),
    "helical ring": (CylindricalGear(z=-56, m_n=1e-3, x=-0.5, beta=0.3, b=0.02), {"rim_thickness": 3e-3}),
    "ring with tip inside the base circle": (
        CylindricalGear(z=-30, m_n=1e-3, b=0.01),
        {"bore_diameter": 0.04},
    ),
}


def volume(triangles: np.ndarray) -> float:
    return float(np.einsum("ij,ij->", triangles[:, 0], np.cross(triangles[:, 1], triangles[:, 2])) / 6.0)


def assert_watertight(triangles: np.ndarray) -> None:
    """Every edge belongs to exactly two triangles, which run along it in opposite directions."""
    _, index = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
    faces = index.reshape(-1, 3)
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    assert (edges[:, 0] != edges[:, 1]).all()
    n = int(index.max()) + 1
    forward, backward = edges[:, 0] * n + edges[:, 1], edges[:, 1] * n + edges[:, 0]
    assert np.unique(forward).size == forward.size
    assert np.array_equal(np.sort(forward), np.sort(backward))


@pytest.mark.parametrize("name", list(SOLIDS))
def test_stl_is_watertight_and_has_the_volume_of_the_gear(name: str, tmp_path: Path) -> None:
    gear, blank = SOLIDS[name]
    file = export_gear(gear, tmp_path / "gear.stl", n_flank=12, **blank)
    data = file.read_bytes()
    kind = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("spare", "<u2")])
    triangles = np.frombuffer(data, kind, offset=84)["corners"]
    assert len(triangles) == int.from_bytes(data[80:84], "little")
    assert_watertight(triangles)
    exact = gear_mass_properties(gear, 1.0, **blank).mass
    coarse = volume(triangles.astype(float) * 1e-3) / exact - 1.0
    fine = volume(gear_solid(gear, 60, **blank)) / exact - 1.0
    assert abs(coarse) < 1e-2
    assert abs(fine) < 3e-4
    assert abs(fine) < 0.3 * abs(coarse) + 1e-5


def test_right_hand_turns_counter_clockwise_upwards() -> None:
    gear = CylindricalGear(z=20, m_n=1e-3, beta=0.3, b=0.01)
    corners = gear_solid(gear, 10, 4).reshape(-1, 3)
    tip = corners[np.hypot(corners[:, 0], corners[:, 1]) > 0.4999 * gear.d_a]
    angle = np.arctan2(tip[:, 1], tip[:, 0])
    turn = 2.5e-3 * math.tan(0.3) / (0.5 * gear.d)
    middle = []
    for z, expected in ((0.0, 0.0), (2.5e-3, turn)):
        tooth = (abs(tip[:, 2] - z) < 1e-9) & (abs(angle - expected) < math.pi / 20)
        middle.append(0.5 * (angle[tooth].min() + angle[tooth].max()))
    assert middle[1] - middle[0] == pytest.approx(turn, rel=1e-9)


def test_csv_holds_the_outline(tmp_path: Path) -> None:
    with export_gear(SPUR, tmp_path / "gear.csv", n_flank=10).open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    points = np.array([[float(r["x [mm]"]), float(r["y [mm]"])] for r in rows]) * 1e-3
    assert points == pytest.approx(gear_outline(SPUR, 10)[:-1], abs=1e-12)
    assert rows[-1]["tooth"] == "16"
    assert {r["region"] for r in rows} == {"root", "fillet", "involute", "tip"}


@pytest.mark.parametrize("case", ["bore", "undercut", "left hand", "ring"])
def test_dxf_read_by_another_program_is_the_gear(tmp_path: Path, case: str) -> None:
    """Its checker finds nothing wrong; millimetres, outline, reference and base circle, bore or ring."""
    import ezdxf

    gear, blank = SOLIDS[case]
    read = ezdxf.readfile(export_gear(gear, tmp_path / "gear.dxf", n_flank=10, **blank))
    check = read.audit()
    assert not check.errors and not check.fixes
    assert (read.dxfversion, read.header["$INSUNITS"], read.header["$MEASUREMENT"]) == ("AC1009", 4, 1)
    outline, *circles = read.modelspace()
    assert outline.dxf.layer == "OUTLINE" and outline.is_closed and outline.is_2d_polyline
    points = np.array([(point.x, point.y) for point in outline.points()]) * 1e-3
    assert points == pytest.approx(gear_outline(gear, 10)[:-1], abs=1e-12)
    assert all(tuple(circle.dxf.center) == (0, 0, 0) for circle in circles)
    hole = ("RING", abs(gear.d_fE) + 7 * gear.m_n) if gear.is_internal else ("BORE", blank["bore_diameter"])
    expected = {"REFERENCE": abs(gear.d), "BASE": abs(gear.d_b), hole[0]: hole[1]}
    found = {circle.dxf.layer: 2e-3 * circle.dxf.radius for circle in circles}
    assert found == pytest.approx(expected, abs=2e-12)


def test_rings_are_as_large_in_drawing_and_solid(tmp_path: Path) -> None:
    """The same rim as in the mass: 3.5 modules outside the root."""
    ring = SOLIDS["ring"][0]
    radius = 0.5e3 * abs(ring.d_fE) + 3.5e3 * ring.m_n
    assert f"A{radius:.6f} " in export_gear(ring, tmp_path / "ring.svg", n_flank=10).read_text()
    corners = gear_solid(ring, 10).reshape(-1, 3)
    assert 1e3 * np.hypot(corners[:, 0], corners[:, 1]).max() == pytest.approx(radius, rel=1e-12)


@pytest.mark.parametrize("gear", [SPUR, SOLIDS["ring"][0]], ids=["external", "internal"])
def test_svg_is_xml_to_scale(gear: CylindricalGear, tmp_path: Path) -> None:
    root = ElementTree.fromstring(export_gear(gear, tmp_path / "x", "svg").read_text(encoding="utf-8"))
    assert root.tag.endswith("svg")
    radii = [float(c.get("r", "0")) for c in root.iter() if c.tag.endswith("circle")]
    assert radii[0] == pytest.approx(0.5e3 * abs(gear.d), abs=1e-6)
    assert float(root.get("width", "0").removesuffix("mm")) > 1e3 * abs(gear.d_a)


def test_unknown_formats_are_refused(tmp_path: Path) -> None:
    with pytest.raises(GeometryError, match="csv, dxf, svg, stl, step"):
        export_gear(SPUR, tmp_path / "gear.iges")
