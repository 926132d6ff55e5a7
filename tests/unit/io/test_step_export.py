# SPDX-License-Identifier: Apache-2.0
"""Gears and shafts as STEP files: OCC reads them back and finds the mass and inertia of the closed forms."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.mass_properties import gear_mass_properties
from pitchpoint.geometry.rack import BasicRack
from pitchpoint.geometry.shaft_solid import shaft_mass_properties
from pitchpoint.geometry.solid_file import read_solids
from pitchpoint.geometry.solid_mass import round_inertia
from pitchpoint.io.gear_export import export_gear, export_shaft
from pitchpoint.io.step_export import gear_step
from pitchpoint.io.target import OutputError
from tests.support.occ import needs_occ

pytestmark = needs_occ

SPUR = CylindricalGear(z=17, m_n=1e-3, b=0.01)
GEARS = {
    "spur": (SPUR, {}),
    "bore": (SPUR, {"bore_diameter": 5e-3}),
    "undercut": (CylindricalGear(z=8, m_n=1e-3, b=0.01), {"bore_diameter": 2e-3}),
    "shovel pinion": (
        CylindricalGear(z=11, m_n=16e-3, beta=0.28, x=0.4, b=0.13),
        {"bore_diameter": 0.05},
    ),
    "steep left hand": (CylindricalGear(z=12, m_n=1e-3, beta=-0.5, b=0.06), {"bore_diameter": 4e-3}),
    "rim and web": (
        CylindricalGear(z=30, m_n=1e-3, beta=0.2, b=0.02),
        {"bore_diameter": 0.01, "rim_thickness": 2e-3, "web_thickness": 6e-3},
    ),
    "rim and web without bore": (
        CylindricalGear(z=30, m_n=1e-3, b=0.02),
        {"rim_thickness": 2e-3, "web_thickness": 6e-3},
    ),
    "web wider than the rim": (
        CylindricalGear(z=30, m_n=1e-3, b=0.02),
        {"bore_diameter": 0.01, "rim_thickness": 2e-3, "web_thickness": 26e-3},
    ),
    "full rounding": (CylindricalGear(z=20, m_n=1e-3, x=0.2, b=0.01, rack=BasicRack(rho_fP_star=1.0)), {}),
    "ring": (CylindricalGear(z=-36, m_n=1e-3, x=-0.5, b=0.02), {}),
    "helical ring": (CylindricalGear(z=-36, m_n=1e-3, x=-0.5, beta=0.3, b=0.02), {"rim_thickness": 3e-3}),
    "ring with tip inside the base circle": (
        CylindricalGear(z=-30, m_n=1e-3, b=0.01),
        {"bore_diameter": 0.04},
    ),
}


@pytest.mark.parametrize("name", list(GEARS))
def test_occ_finds_the_mass_and_inertia_of_the_closed_form(name: str, tmp_path: Path) -> None:
    """Faces lie within 1e-6 modules of the teeth, mostly on both sides: a few 1e-8 of volume and inertia."""
    gear, blank = GEARS[name]
    file = export_gear(gear, tmp_path / f"{name}.step", **blank)
    solids = read_solids(file)
    solid, exact = solids.part(name), gear_mass_properties(gear, 1.0, **blank)
    found = round_inertia(solid, (0.0, 0.0, 1.0))
    assert solids.unit == "millimetre"
    assert solid.volume == pytest.approx(exact.mass, rel=5e-8)
    assert found.polar == pytest.approx(exact.polar_inertia, rel=5e-8)
    assert found.transverse == pytest.approx(exact.transverse_inertia, rel=5e-8)
    assert solid.center == pytest.approx((0.0, 0.0, 0.0), abs=1e-12)
    assert found.uneven < 1e-10


def test_coarser_faces_make_smaller_files_of_nearly_the_same_volume(tmp_path: Path) -> None:
    fine, coarse = (gear_step(SPUR, "g", tolerance=t) for t in (1e-6, 1e-3))
    assert len(coarse) < 0.6 * len(fine)
    (tmp_path / "g.step").write_text(coarse)
    exact = gear_mass_properties(SPUR, 1.0)
    assert read_solids(tmp_path / "g.step").part().volume == pytest.approx(exact.mass, rel=1e-4)


SHAFTS = {
    "stepped": [(0.1, 0.04, 0.0), (0.05, 0.06, 0.01), (0.05, 0.06, 0.02), (0.1, 0.04, 0.02)],
    "hollow": [(0.1, 0.04, 0.03), (0.2, 0.05, 0.03), (0.05, 0.045, 0.02)],
    "cavity": [(0.05, 0.04, 0.0), (0.05, 0.04, 0.01), (0.05, 0.04, 0.0)],
    "closed in the middle": [(0.1, 0.04, 0.01), (0.02, 0.06, 0.0), (0.1, 0.04, 0.01)],
}


@pytest.mark.parametrize("sections", SHAFTS.values(), ids=SHAFTS)
def test_stepped_hollow_shafts_agree_to_round_off(sections, tmp_path: Path) -> None:
    solid = read_solids(export_shaft(sections, tmp_path / "shaft.stp")).part("shaft")
    exact = shaft_mass_properties(sections, 1.0)
    found = round_inertia(solid, (0.0, 0.0, 1.0))
    assert solid.volume == pytest.approx(exact.mass, rel=1e-12)
    assert solid.center == pytest.approx((0.0, 0.0, exact.center), rel=1e-12, abs=1e-14)
    assert found.polar == pytest.approx(exact.polar_inertia, rel=1e-12)
    assert found.transverse == pytest.approx(exact.transverse_inertia, rel=1e-12)


def test_nothing_is_said_on_stdout_and_the_same_gear_gives_the_same_bytes(tmp_path: Path, capfd) -> None:
    first = export_gear(SPUR, tmp_path / "g.step").read_bytes()
    read_solids(tmp_path / "g.step")
    assert export_gear(SPUR, tmp_path / "g.step").read_bytes() == first  # what it wrote it may replace
    assert capfd.readouterr() == ("", "")


def test_a_file_of_another_program_stays(tmp_path: Path) -> None:
    file = tmp_path / "g.step"
    file.write_text("ISO-10303-21;\nHEADER;\nFILE_NAME('x','','','','','other','');\n")
    with pytest.raises(OutputError, match="is not a solid of pitchpoint .STEP"):
        export_gear(SPUR, file)


def assembly(file: Path, unit: str) -> None:
    """STEP file with a box of 3 x 2 x 1 cm at home, and twice the same rod elsewhere."""
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder
    from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt, gp_Trsf, gp_Vec
    from OCP.Interface import Interface_Static
    from OCP.STEPCAFControl import STEPCAFControl_Writer
    from OCP.STEPControl import STEPControl_StepModelType
    from OCP.TCollection import TCollection_ExtendedString
    from OCP.TDataStd import TDataStd_Name
    from OCP.TDocStd import TDocStd_Document
    from OCP.TopLoc import TopLoc_Location
    from OCP.XCAFDoc import XCAFDoc_DocumentTool

    document = TDocStd_Document(TCollection_ExtendedString("pitchpoint"))
    tool = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    whole = tool.NewShape()
    block = tool.AddShape(BRepPrimAPI_MakeBox(30.0, 20.0, 10.0).Shape(), False)
    rod = tool.AddShape(BRepPrimAPI_MakeCylinder(5.0, 40.0).Shape(), False)
    TDataStd_Name.Set_s(block, TCollection_ExtendedString("block"))
    TDataStd_Name.Set_s(rod, TCollection_ExtendedString("rod"))
    tool.AddComponent(whole, block, TopLoc_Location())
    for turn in (False, True):
        place = gp_Trsf()
        if turn:
            place.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)), 1.5707963267948966)
        place.SetTranslationPart(gp_Vec(100.0, 0.0, 0.0))
        tool.AddComponent(whole, rod, TopLoc_Location(place))
    tool.UpdateAssemblies()
    Interface_Static.SetCVal_s("write.step.unit", unit)
    writer = STEPCAFControl_Writer()
    writer.Transfer(document, STEPControl_StepModelType.STEPControl_AsIs)
    writer.Write(str(file))
    Interface_Static.SetCVal_s("write.step.unit", "MM")


@pytest.mark.parametrize("unit, words", [("MM", "millimetre"), ("INCH", "inch"), ("M", "metre")])
def test_solids_of_an_assembly_lie_where_it_has_them(unit: str, words: str, tmp_path: Path) -> None:
    from pitchpoint.geometry.step_file import need_occ

    need_occ()
    assembly(tmp_path / "a.step", unit)
    found = read_solids(tmp_path / "a.step")
    assert found.unit == words
    assert [s.name for s in found.solids] == ["block", "rod", "rod (2)"]
    block, upright, lying = found.solids
    assert block.volume == pytest.approx(6e-6, rel=1e-9)
    assert block.center == pytest.approx((0.015, 0.01, 0.005), rel=1e-9)
    assert block.moments[:3] == pytest.approx([2.5e-10, 5e-10, 6.5e-10], rel=1e-9)
    assert upright.center == pytest.approx((0.1, 0.0, 0.02), rel=1e-9, abs=1e-12)
    assert lying.center == pytest.approx((0.1, -0.02, 0.0), rel=1e-9, abs=1e-12)
    assert round_inertia(upright).axis == (0.0, 0.0, 1.0)
    assert round_inertia(lying).axis == (0.0, 1.0, 0.0)
    with pytest.raises(GeometryError, match=r"several solids; there are 'block', 'rod', 'rod \(2\)'"):
        found.part()


def test_what_is_no_solid_is_refused(tmp_path: Path) -> None:
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeSolid
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS, TopoDS_Builder, TopoDS_Shell

    from pitchpoint.geometry.step_file import need_occ
    from pitchpoint.io.step_export import _text

    need_occ()
    box = BRepPrimAPI_MakeBox(30.0, 20.0, 10.0).Shape()
    explorer = TopExp_Explorer(box, TopAbs_ShapeEnum.TopAbs_FACE)
    face = explorer.Current()
    file = tmp_path / "a.step"
    file.write_text(_text(face, "sheet"))
    with pytest.raises(GeometryError, match="'a.step' holds no solid"):
        read_solids(file)
    builder, shell = TopoDS_Builder(), TopoDS_Shell()
    builder.MakeShell(shell)
    for _ in range(5):
        builder.Add(shell, explorer.Current())
        explorer.Next()
    file.write_text(_text(BRepBuilderAPI_MakeSolid(TopoDS.Shell(shell)).Solid(), "open"))
    with pytest.raises(GeometryError, match="holds"):
        read_solids(file)


def test_a_damaged_file_is_a_sentence(tmp_path: Path) -> None:
    text = export_gear(SPUR, tmp_path / "g.step").read_text()
    half = len(text) // 2
    head = text[: text.index("DATA;")]
    cases = {
        "cut": (text[:half], "'cut.step' is cut short"),
        "hole": (text[:half] + text[half + 4000 :], "is damaged: it names entities that it does not hold"),
        "word": (text.replace("MANIFOLD_SOLID_BREP", "MANIFOLD_SOLID_BRAP"), "no solid|damaged"),
        "empty": (head + "DATA;\nENDSEC;\nEND-ISO-10303-21;\n", "holds no solid|contents are no model"),
    }
    for name, (data, said) in cases.items():
        file = tmp_path / f"{name}.step"
        file.write_text(data)
        with pytest.raises(GeometryError, match=said):
            read_solids(file)
