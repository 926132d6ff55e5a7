# SPDX-License-Identifier: Apache-2.0
"""STEP files (ISO 10303-214) of gears and shafts with smooth faces, created by OCC (extra `cad`).

The flanks are Bezier surfaces: curves of the exact tooth, swept along the helix by a polynomial that
approximates the circle with the same tolerance.
"""

from __future__ import annotations

import math
import re
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.mass_properties import RIM_OF_RING, gear_mass_properties
from pitchpoint.geometry.shaft_solid import Section, shaft_outline
from pitchpoint.geometry.step_file import need_occ
from pitchpoint.geometry.tooth_curves import pitch_curves, twist_curves
from pitchpoint.geometry.tooth_form import root_radius
from pitchpoint.io.target import STEP_MARK

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

ComplexArray = NDArray[np.complex128]

TOLERANCE = 1e-6
"""Distance of the faces from the exact teeth, in modules; volume and inertia then agree to about 1e-8."""
_MM = 1e3
_SEW = 1e-5
"""Tolerance for sewing edges [mm]."""
_STAMP = re.compile(r"FILE_NAME\(.*?\);", re.DOTALL)


def gear_step(
    gear: CylindricalGear,
    name: str = "gear",
    *,
    bore_diameter: float = 0.0,
    rim_thickness: float | None = None,
    web_thickness: float | None = None,
    tolerance: float = TOLERANCE,
) -> str:
    """Text of a STEP file with a gear; axis z, middle plane z = 0, tooth 0 on the x axis there.

    Parameters
    ----------
    gear
        External or internal gear; β > 0 turns the section counter-clockwise towards +z.
    name
        Name of the product in the file.
    bore_diameter, rim_thickness, web_thickness
        The blank, as in `pitchpoint.geometry.mass_properties.gear_mass_properties` [m].
    tolerance
        Distance of the faces from the exact teeth, in modules; larger ones make smaller files.

    Raises
    ------
    GeometryError
        If teeth or blank are impossible, or the teeth are measured points.
    MissingDependencyError
        If OCC is not installed.
    """
    blank = {"rim_thickness": rim_thickness, "web_thickness": web_thickness, "bore_diameter": bore_diameter}
    gear_mass_properties(gear, 1.0, **blank)  # type: ignore[arg-type]  # rejects impossible blanks
    corners = _blank(gear, 0.5 * bore_diameter, rim_thickness, web_thickness)
    curves = pitch_curves(gear, tolerance)
    need_occ()
    return _text(_gear(gear, curves, corners, tolerance), name)


def shaft_step(sections: Sequence[Section], name: str = "shaft") -> str:
    """Text of a STEP file with a stepped, hollow shaft along the z axis from z = 0.

    Parameters
    ----------
    sections
        (length, diameter, bore) of each [m].
    name
        Name of the product in the file.

    Raises
    ------
    GeometryError
        If the sections do not form a shaft.
    MissingDependencyError
        If OCC is not installed.
    """
    corners = shaft_outline(sections)
    need_occ()
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeRevol

    face = BRepBuilderAPI_MakeFace(_polygon(corners, closed=True)).Face()
    return _text(BRepPrimAPI_MakeRevol(face, _axis()).Shape(), name)


def _blank(
    gear: CylindricalGear, bore: float, rim: float | None, web: float | None
) -> list[tuple[float, float]]:
    """Profile (radius, z) of the revolved faces of the blank, from the upper to the lower side of the rim."""
    half, r_f = 0.5 * gear.b, root_radius(gear)
    if gear.is_internal:
        outer = bore if bore > 0.0 else r_f + (RIM_OF_RING * gear.m_n if rim is None else rim)
        return [(outer, half), (outer, -half)]
    inner = bore if rim is None else max(bore, r_f - rim)
    upper = [(bore, half)]
    if web is not None and inner > bore and web != gear.b:
        upper = [(inner, half), (inner, 0.5 * web), (bore, 0.5 * web)]
    elif bore == 0.0:
        return []
    return upper + [(r, -z) for r, z in reversed(upper)]


def _gear(
    gear: CylindricalGear, curves: list[ComplexArray], blank: list[tuple[float, float]], tolerance: float
) -> Any:
    """OCC solid, sewn from flanks, both sides and blank."""
    from OCP.BRepBuilderAPI import (
        BRepBuilderAPI_MakeEdge,
        BRepBuilderAPI_MakeFace,
        BRepBuilderAPI_MakeSolid,
        BRepBuilderAPI_MakeWire,
        BRepBuilderAPI_Sewing,
    )
    from OCP.BRepLib import BRepLib
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeRevol
    from OCP.gp import gp_Ax2, gp_Circ, gp_Dir, gp_Pln, gp_Pnt
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopoDS import TopoDS

    z, half = abs(gear.z), 0.5 * gear.b
    around = [c * np.exp(2j * math.pi / z * k) for k in range(z) for c in curves]
    twist = twist_curves(2.0 * math.tan(gear.beta) / abs(gear.d) * gear.b, tolerance * gear.m_n / abs(gear.d))
    levels = np.linspace(-half, half, len(twist) + 1)
    sewing = BRepBuilderAPI_Sewing(_SEW)
    for turn, low, high in zip(twist, levels[:-1], levels[1:], strict=True):
        for poles in around:
            sewing.Add(BRepBuilderAPI_MakeFace(_surface(poles, turn, (low, high)), _SEW).Face())
    hole = blank[0][0] if blank else 0.0
    for level, turn in ((-half, twist[0][0]), (half, twist[-1][-1])):
        teeth = BRepBuilderAPI_MakeWire()
        for poles in around:
            teeth.Add(BRepBuilderAPI_MakeEdge(_curve(poles * turn, level)).Edge())
        plane = gp_Pnt(0.0, 0.0, level * _MM)
        wires = [teeth.Wire()]
        if hole > 0.0:
            circle = gp_Circ(gp_Ax2(plane, gp_Dir(0.0, 0.0, 1.0), gp_Dir(1.0, 0.0, 0.0)), hole * _MM)
            wires.append(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()).Wire())
        if gear.is_internal:
            wires.reverse()
        face = BRepBuilderAPI_MakeFace(gp_Pln(plane, gp_Dir(0.0, 0.0, 1.0)), wires[0])
        for wire in wires[1:]:
            face.Add(TopoDS.Wire(wire.Reversed()))
        sewing.Add(face.Face())
    if blank:
        sewing.Add(BRepPrimAPI_MakeRevol(_polygon(blank, closed=False), _axis()).Shape())
    sewing.Perform()
    shell = sewing.SewedShape()
    if sewing.NbFreeEdges() or shell.ShapeType() != TopAbs_ShapeEnum.TopAbs_SHELL:
        raise GeometryError(
            "leave the surface open",
            where="tooth form",
            value=f"{sewing.NbFreeEdges()} edges",
            remedy="export STL instead",
        )
    solid = BRepBuilderAPI_MakeSolid(TopoDS.Shell(shell)).Solid()
    BRepLib.OrientClosedSolid_s(solid)
    return solid


def _once(degree: int) -> tuple[Any, Any]:
    """Knots and multiplicities of one Bezier piece as a spline."""
    from OCP.collections import Array1_double, Array1_int

    knots, counts = Array1_double(1, 2), Array1_int(1, 2)
    for k in (1, 2):
        knots.SetValue(k, k - 1.0)
        counts.SetValue(k, degree + 1)
    return knots, counts


def _surface(poles: ComplexArray, turn: ComplexArray, levels: tuple[float, float]) -> Any:
    """Surface swept by the curve of `poles` between two levels: its points times those of `turn`."""
    from OCP.collections import Array2_gp_Pnt
    from OCP.Geom import Geom_BSplineSurface
    from OCP.gp import gp_Pnt

    m, n = poles.size - 1, turn.size - 1
    grid = Array2_gp_Pnt(1, m + 1, 1, n + 1)
    for j, q in enumerate(turn):
        level = _MM * (levels[0] + (levels[1] - levels[0]) * j / n)
        for i, point in enumerate(poles * q * _MM):
            grid.SetValue(i + 1, j + 1, gp_Pnt(float(point.real), float(point.imag), level))
    (u, u_counts), (v, v_counts) = _once(m), _once(n)
    return Geom_BSplineSurface(grid, u, v, u_counts, v_counts, m, n)


def _curve(poles: ComplexArray, level: float) -> Any:
    from OCP.collections import Array1_gp_Pnt
    from OCP.Geom import Geom_BSplineCurve
    from OCP.gp import gp_Pnt

    line = Array1_gp_Pnt(1, poles.size)
    for i, point in enumerate(poles * _MM):
        line.SetValue(i + 1, gp_Pnt(float(point.real), float(point.imag), level * _MM))
    return Geom_BSplineCurve(line, *_once(poles.size - 1), poles.size - 1)


def _polygon(corners: Sequence[tuple[float, float]], *, closed: bool) -> Any:
    """Wire through corners (radius, z) [m] in the half plane of x and z."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakePolygon
    from OCP.gp import gp_Pnt

    made = BRepBuilderAPI_MakePolygon()
    for r, z in corners:
        made.Add(gp_Pnt(r * _MM, 0.0, z * _MM))
    if closed:
        made.Close()
    return made.Wire()


def _axis() -> Any:
    from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt

    return gp_Ax1(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0))


def _text(shape: Any, name: str) -> str:
    """Text of a STEP file in millimetres with one product."""
    from OCP.IFSelect import IFSelect_ReturnStatus
    from OCP.Interface import Interface_Static
    from OCP.STEPCAFControl import STEPCAFControl_Writer
    from OCP.STEPControl import STEPControl_StepModelType
    from OCP.TCollection import TCollection_ExtendedString
    from OCP.TDataStd import TDataStd_Name
    from OCP.TDocStd import TDocStd_Document
    from OCP.XCAFDoc import XCAFDoc_DocumentTool

    document = TDocStd_Document(TCollection_ExtendedString("pitchpoint"))
    label = XCAFDoc_DocumentTool.ShapeTool_s(document.Main()).AddShape(shape, False)
    TDataStd_Name.Set_s(label, TCollection_ExtendedString(name))
    writer = STEPCAFControl_Writer()
    Interface_Static.SetIVal_s("write.surfacecurve.mode", 0)  # readers compute curves on surfaces
    Interface_Static.SetCVal_s("write.step.unit", "MM")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "solid.step"
        writer.Transfer(document, STEPControl_StepModelType.STEPControl_AsIs)
        if writer.Write(str(file)) != IFSelect_ReturnStatus.IFSelect_RetDone:
            raise GeometryError("cannot be written as STEP", where=name)
        text = file.read_text(encoding="utf-8")
    plain = re.sub(r"[^A-Za-z0-9 _.-]", "_", name)
    # no time stamp: the same gear gives the same file
    stamp = f"FILE_NAME('{plain}','1970-01-01T00:00:00',(''),(''),'OCC','{STEP_MARK}','');"
    return _STAMP.sub(lambda _: stamp, text, count=1)
