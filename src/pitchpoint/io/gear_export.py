# SPDX-License-Identifier: Apache-2.0
"""Export of gears and shafts: points (CSV), drawings (DXF R12, SVG), solids (STL, STEP).

All lengths in these files are in millimetres.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.bevel.sector import bevel_solid
from pitchpoint.geometry.mass_properties import RIM_OF_RING
from pitchpoint.geometry.shaft_solid import ROUND, Section, shaft_solid
from pitchpoint.geometry.solid import gear_solid
from pitchpoint.geometry.tooth_form import REGIONS, gear_outline, root_radius, tooth_form, tooth_profile
from pitchpoint.io.target import DXF_MARK, SVG_MARK, check_target, write_file

if TYPE_CHECKING:
    from pitchpoint.geometry.bevel.gear import BevelGear
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

FORMATS = ("csv", "dxf", "svg", "stl", "step")
SHAFT_FORMATS = ("stl", "step")
BEVEL_FORMATS = ("stl",)
_OTHER_ENDINGS = {"stp": "step"}
_MM = 1e3


def points_csv(gear: CylindricalGear, n_flank: int = 40) -> str:
    """Outline of the gear as CSV text: x and y in mm, tooth number and region of every point.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> points_csv(CylindricalGear(z=17, m_n=1e-3), 10).splitlines()[0]
    'x [mm],y [mm],tooth,region'
    """
    region = tooth_profile(gear, n_flank).region
    points = gear_outline(gear, n_flank)[:-1] * _MM
    rows = (
        f"{x:.9f},{y:.9f},{i // region.size},{REGIONS[region[i % region.size]]}"
        for i, (x, y) in enumerate(points)
    )
    return "\n".join(["x [mm],y [mm],tooth,region", *rows]) + "\n"


def _bore_radius(gear: CylindricalGear, bore_diameter: float) -> float:
    """Radius of the bore, or outer radius of an internal gear, with the default rim if none is given [m]."""
    if gear.is_internal and bore_diameter == 0.0:
        return root_radius(gear) + RIM_OF_RING * gear.m_n
    return 0.5 * bore_diameter


def drawing_dxf(gear: CylindricalGear, n_flank: int = 40, bore_diameter: float = 0.0) -> str:
    """Outline of the gear as DXF R12 text: one closed polyline, reference and base circle, bore.

    Parameters
    ----------
    gear
        External or internal gear.
    n_flank
        Points per flank.
    bore_diameter
        Bore, or outer diameter of an internal gear [m]; 0 = none, or a ring of the usual rim.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> drawing_dxf(CylindricalGear(z=17, m_n=1e-3), 10).split()[:6]
    ['999', 'pitchpoint', '0', 'SECTION', '2', 'HEADER']
    """
    lines: list[str] = []

    def put(code: int, value: str | float | int) -> None:
        """Write one pair of group code and value."""
        lines.append(str(code))
        lines.append(f"{value:.9f}" if isinstance(value, float) else str(value))

    def pairs(*items: tuple[int, str | float | int]) -> None:
        """Write several of them."""
        for code, value in items:
            put(code, value)

    pairs((0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009"))
    pairs((9, "$INSUNITS"), (70, 4), (9, "$MEASUREMENT"), (70, 1), (0, "ENDSEC"))  # millimetres
    pairs((0, "SECTION"), (2, "ENTITIES"))
    pairs((0, "POLYLINE"), (8, "OUTLINE"), (66, 1), (10, 0.0), (20, 0.0), (30, 0.0), (70, 1))
    for x, y in gear_outline(gear, n_flank)[:-1] * _MM:
        pairs((0, "VERTEX"), (8, "OUTLINE"), (10, float(x)), (20, float(y)), (30, 0.0))
    pairs((0, "SEQEND"), (8, "OUTLINE"))
    circles = [("REFERENCE", abs(gear.d)), ("BASE", abs(gear.d_b))]
    bore = 2.0 * _bore_radius(gear, bore_diameter)
    if bore > 0.0:
        circles.append(("RING" if gear.is_internal else "BORE", bore))
    for layer, diameter in circles:
        pairs((0, "CIRCLE"), (8, layer), (10, 0.0), (20, 0.0), (30, 0.0), (40, 0.5 * diameter * _MM))
    pairs((0, "ENDSEC"), (0, "EOF"))
    return DXF_MARK + "\n".join(lines) + "\n"


def drawing_svg(gear: CylindricalGear, n_flank: int = 40, bore_diameter: float = 0.0) -> str:
    """Drawing of the gear as SVG text, to scale in millimetres, with its characteristic circles.

    Parameters
    ----------
    gear
        External or internal gear.
    n_flank
        Points per flank.
    bore_diameter
        Bore, or outer diameter of an internal gear [m]; 0 = none, or a ring of the usual rim.

    Notes
    -----
    Fill: the gear. Chain line: reference circle; dashed: base circle; dotted: root form circle.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> drawing_svg(CylindricalGear(z=17, m_n=1e-3), 10)[:4]
    '<svg'
    """
    form = tooth_form(gear)
    points = gear_outline(gear, n_flank)[:-1] * _MM
    hole = _MM * _bore_radius(gear, bore_diameter)
    outer = hole if gear.is_internal else float(np.hypot(points[:, 0], points[:, 1]).max())
    path = "M" + "L".join(f"{x:.6f} {-y:.6f}" for x, y in points) + "Z"
    if hole > 0.0:
        arc = f"A{hole:.6f} {hole:.6f} 0 1 0"
        path += f"M{hole:.6f} 0{arc} {-hole:.6f} 0{arc} {hole:.6f} 0Z"
    size, pen = 1.04 * outer, 0.0025 * outer
    circles = (
        (0.5 * abs(gear.d), f"{12 * pen:.4f} {3 * pen:.4f} {2 * pen:.4f} {3 * pen:.4f}"),
        (form.r_b, f"{6 * pen:.4f} {4 * pen:.4f}"),
        (form.r_Ff, f"{1.5 * pen:.4f} {3 * pen:.4f}"),
    )
    dashed = "".join(
        f'<circle r="{r * _MM:.6f}" fill="none" stroke="#666" stroke-width="{0.6 * pen:.4f}" '
        f'stroke-dasharray="{dash}"/>\n'
        for r, dash in circles
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{2 * size:.4f}mm" height="{2 * size:.4f}mm" '
        f'viewBox="{-size:.6f} {-size:.6f} {2 * size:.6f} {2 * size:.6f}">\n{SVG_MARK}\n'
        f"<title>{abs(gear.z)} teeth, m_n {gear.m_n * _MM:g} mm</title>\n"
        f'<path d="{path}" fill="#cdd6df" fill-rule="evenodd" stroke="#1b2733" stroke-width="{pen:.4f}" '
        f'stroke-linejoin="round"/>\n{dashed}</svg>\n'
    )


def _binary(triangles: NDArray[np.float64], title: str) -> bytes:
    """Binary STL in millimetres."""
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    norm = np.linalg.norm(normals, axis=1, keepdims=True)
    records = np.zeros(
        len(triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("spare", "<u2")]
    )
    records["normal"] = normals / np.where(norm > 0.0, norm, 1.0)
    records["corners"] = triangles * _MM
    return title.encode().ljust(80) + struct.pack("<I", len(triangles)) + records.tobytes()


def export_gear(
    gear: CylindricalGear,
    path: str | Path,
    format: str | None = None,
    *,
    n_flank: int = 40,
    n_slices: int | None = None,
    bore_diameter: float = 0.0,
    rim_thickness: float | None = None,
    web_thickness: float | None = None,
) -> Path:
    """Write a gear to a file.

    Parameters
    ----------
    gear
        External or internal gear.
    path
        File to write; its ending names the format unless `format` does. An existing file is replaced if
        pitchpoint wrote it, in the same format.
    format
        "csv", "dxf", "svg", "stl" or "step".
    n_flank
        Points per flank, at least 5.
    n_slices
        Slices of the STL along the face width; None = fine enough for the helix.
    bore_diameter, rim_thickness, web_thickness
        The blank [m]; rim and web only matter for solids.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    GeometryError
        If the format is unknown or there is no such tooth.
    MissingDependencyError
        For STEP, if OCC is not installed.
    OutputError
        If the file cannot be written, or an existing file is of another kind or program.
    """
    path = Path(path)
    kind = _kind(path, format, FORMATS)
    check_target(path, kind)
    blank = {"bore_diameter": bore_diameter, "rim_thickness": rim_thickness, "web_thickness": web_thickness}
    if kind == "stl":
        triangles = gear_solid(gear, n_flank, n_slices, **blank)  # type: ignore[arg-type]
        return write_file(path, _binary(triangles, "pitchpoint gear, millimetres"))
    if kind == "step":
        from pitchpoint.io.step_export import gear_step

        return write_file(path, gear_step(gear, path.stem, **blank))  # type: ignore[arg-type]
    if kind == "csv":
        text = points_csv(gear, n_flank)
    else:
        text = (drawing_dxf if kind == "dxf" else drawing_svg)(gear, n_flank, bore_diameter)
    return write_file(path, text)


def export_shaft(
    sections: Sequence[Section], path: str | Path, format: str | None = None, *, n_round: int = ROUND
) -> Path:
    """Write a stepped, hollow shaft to a file, along the z axis from z = 0.

    Parameters
    ----------
    sections
        (length, diameter, bore) of each [m].
    path
        File to write, as in `export_gear`.
    format
        "stl" or "step".
    n_round
        Corners of a circle in STL; 180 of them lack 2·10⁻⁴ of the mass.

    Raises
    ------
    GeometryError
        If the format is unknown or the sections do not form a shaft.
    MissingDependencyError
        For STEP, if OCC is not installed.
    OutputError
        If the file cannot be written, or an existing file is of another kind or program.
    """
    path = Path(path)
    kind = _kind(path, format, SHAFT_FORMATS)
    check_target(path, kind)
    if kind == "stl":
        return write_file(path, _binary(shaft_solid(sections, n_round), "pitchpoint shaft, millimetres"))
    from pitchpoint.io.step_export import shaft_step

    return write_file(path, shaft_step(sections, path.stem))


def export_bevel_gear(
    gear: BevelGear,
    path: str | Path,
    format: str | None = None,
    *,
    n_flank: int = 40,
    bore_diameter: float = 0.0,
    rim_thickness: float | None = None,
) -> Path:
    """Write a bevel gear to a file, its apex at the origin and its axis along z.

    Parameters
    ----------
    gear
        The gear.
    path
        File to write, as in `export_gear`.
    format
        "stl".
    n_flank
        Points per flank, at least 5.
    bore_diameter, rim_thickness
        The body, as in `pitchpoint.geometry.bevel.blank.bevel_blank` [m].

    Raises
    ------
    GeometryError
        If the format is unknown or there is no such tooth or body.
    OutputError
        If the file cannot be written, or an existing file is of another kind or program.
    """
    path = Path(path)
    check_target(path, _kind(path, format, BEVEL_FORMATS))
    corners = bevel_solid(gear, n_flank, bore_diameter=bore_diameter, rim_thickness=rim_thickness)
    return write_file(path, _binary(corners, "pitchpoint gear, millimetres"))


def _kind(path: Path, format: str | None, known: Sequence[str]) -> str:
    """Name of the selected format."""
    kind = (format or path.suffix.lstrip(".")).lower()
    kind = _OTHER_ENDINGS.get(kind, kind)
    if kind not in known:
        raise GeometryError(
            "is not a supported format",
            where="format",
            value=f"{kind!r}",
            limit=", ".join(known),
            remedy="change the file extension or give the format",
        )
    return kind
