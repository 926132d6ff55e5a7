# SPDX-License-Identifier: Apache-2.0
"""Solids of STEP files (ISO 10303-21) through OCC, installed by the extra `cad`."""

from __future__ import annotations

import importlib.util
import json
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.child import python_command, python_environment
from pitchpoint.core.errors import GeometryError, MissingDependencyError

if TYPE_CHECKING:
    from pitchpoint.geometry.solid_mass import SolidFile

_MM = 1e-3
_BEGIN, _END = b"ISO-10303-21;", b"END-ISO-10303-21;"
_AGAIN = "export it again"
_QUOTED = re.compile(rb"'[^']*'|/\*.*?\*/", re.DOTALL)
_REFERENCE = re.compile(rb"#(\d+)")
_ENTITY = re.compile(rb"#(\d+)\s*=")


def need_occ() -> None:
    """Import OCC and silence its progress messages on stdout.

    Raises
    ------
    MissingDependencyError
        If OCC is not installed.
    """
    try:
        from OCP.Message import Message, Message_Printer
    except ImportError:
        raise _missing() from None
    Message.DefaultMessenger_s().RemovePrinters(Message_Printer.get_type_descriptor_s())


def _missing() -> MissingDependencyError:
    return MissingDependencyError(
        "STEP files need OCC, which is not installed; install it with pip install 'pitchpoint[cad]', or use "
        "STL files"
    )


def read_step(file: str | Path) -> SolidFile:
    """Read all solids of a STEP file.

    The file is read in a separate process, because OCC may crash on damaged files.

    Parameters
    ----------
    file
        Path of the file.

    Raises
    ------
    GeometryError
        If the file cannot be read or is truncated, or if it has no solid or one that is open or inside out.
    MissingDependencyError
        If OCC is not installed.
    """
    from pitchpoint.geometry.solid_mass import Solid, SolidFile

    found = ask("pitchpoint.geometry.step_file", file)
    solids = (Solid(n, v, tuple(c), tuple(m)) for n, v, c, m in found["solids"])
    return SolidFile(tuple(solids), found["unit"])


def ask(module: str, file: str | Path, *arguments: str) -> dict[str, Any]:
    """Run a module that reads a STEP file in a separate process, and return its result.

    Parameters
    ----------
    module
        Module that is run with the path of the file and the arguments; prints the result of `answered`.
    file
        Path of the file.
    *arguments
        Further arguments of the module.

    Raises
    ------
    GeometryError
        If the module reports a problem, or if its process crashed.
    MissingDependencyError
        If OCC is not installed.
    """
    name = Path(file).name
    _check_whole(name, Path(file))
    if importlib.util.find_spec("OCP") is None:
        raise _missing()
    command = python_command("-m", module, str(Path(file).absolute()), *arguments)
    environment = {**python_environment(), "PYTHONUTF8": "1"}
    run = subprocess.run(command, capture_output=True, check=False, env=environment)
    try:
        found: dict[str, Any] = json.loads(run.stdout)
    except ValueError:
        raise refused(name, "cannot be read: its contents are damaged") from None
    if "problem" in found:
        raise GeometryError(found["problem"].pop("message"), **found["problem"])
    return found


def answered(answer: Callable[..., dict[str, Any]], *arguments: str) -> dict[str, Any]:
    """Result of a function that reads a file, or the problem of the file, as JSON data.

    Parameters
    ----------
    answer
        Function that reads the file.
    *arguments
        Arguments of `answer`, the path of the file first.
    """
    try:
        return answer(*arguments)
    except GeometryError as error:
        p = error.problem
        rest = {"where": p.where, "value": p.value, "limit": p.limit, "remedy": p.remedy}
        return {"problem": {"message": p.text, **rest}}


def named_solids(file: str) -> tuple[str, Iterator[tuple[str, Any]]]:
    """Unit of a file as text, and its solids with unique names as OCC shapes in millimetres.

    Parameters
    ----------
    file
        Path of the file.

    Raises
    ------
    GeometryError
        If the file cannot be read.
    MissingDependencyError
        If OCC is not installed.
    """
    name = Path(file).name
    _check_references(name, Path(file).read_bytes())
    need_occ()
    document, unit = _document(name, file)

    def labelled() -> Iterator[tuple[str, Any]]:
        """Yield the solids with unique names; solids of one product are numbered."""
        seen: dict[str, int] = {}
        for product, shape in _solids(document):
            count = seen[product] = seen.get(product, 0) + 1
            yield (product if count == 1 else f"{product} ({count})"), shape

    return unit, labelled()


def _answer(file: str) -> dict[str, Any]:
    """Unit of the file, and name, volume, centre and moments of every solid."""
    from pitchpoint.geometry.solid_mass import solid_of

    name = Path(file).name
    unit, shapes = named_solids(file)
    solids: list[Any] = []
    for label, shape in shapes:
        _check_closed(name, label, shape)
        volume, center, inertia = solid_integrals(shape)
        if not volume > 0.0:
            raise refused(name, f"holds the solid '{label}' inside out", f"volume {volume:.6g} m^3")
        one = solid_of(label, volume, center, inertia)
        solids.append((one.name, one.volume, one.center, one.moments))
    if not solids:
        raise refused(name, "holds no solid", remedy="export a solid body, not surfaces or a drawing")
    return {"unit": unit, "solids": solids}


def solid_integrals(shape: Any) -> tuple[float, np.ndarray, np.ndarray]:
    """Volume [m³], centre [m] and central inertia for unit density [m⁵] of an OCC shape in millimetres.

    Parameters
    ----------
    shape
        The `TopoDS_Shape`.

    Notes
    -----
    Gauss quadrature over the faces: exact for planes and cylinders, to about 10⁻⁹ for gear flanks.
    """
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    found = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, found)
    at, tensor = found.CentreOfMass(), found.MatrixOfInertia()
    inertia = np.array([[tensor.Value(i, k) for k in (1, 2, 3)] for i in (1, 2, 3)])
    return found.Mass() * _MM**3, np.array([at.X(), at.Y(), at.Z()]) * _MM, inertia * _MM**5


def refused(name: str, message: str, value: str | None = None, remedy: str = _AGAIN) -> GeometryError:
    """Error for a file that cannot be used.

    Parameters
    ----------
    name
        Name of the file.
    message
        Problem, continues the sentence "the file ...".
    value, remedy
        As in `GeometryError`.
    """
    return GeometryError(f"the file '{name}' {message}", where="file", value=value, remedy=remedy)


def _check_whole(name: str, path: Path) -> None:
    """Raise for files that are not STEP files or are truncated; OCC may accept them."""
    try:
        with path.open("rb") as file:
            head = file.read(4096)
            file.seek(max(0, path.stat().st_size - 4096))
            tail = file.read()
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise refused(name, f"cannot be read: {reason}") from None
    if _BEGIN not in head:
        raise refused(name, "is not a STEP file: it does not begin with ISO-10303-21;")
    if _END not in tail:
        raise refused(name, "is cut short: it does not end with END-ISO-10303-21;")


def _check_references(name: str, data: bytes) -> None:
    """Raise for references to missing entities, on which OCC omits solids or crashes."""
    bare = _QUOTED.sub(b"", data)
    lost = set(_REFERENCE.findall(bare)) - set(_ENTITY.findall(bare))
    if lost:
        first = min(lost, key=int).decode()
        raise refused(name, f"is damaged: it names entities that it does not hold, such as #{first}")


def _document(name: str, file: str) -> tuple[Any, str]:
    """OCC document with the products of a file in millimetres, and the unit of the file."""
    from OCP.collections import Sequence_TCollection_AsciiString as Texts
    from OCP.IFSelect import IFSelect_ReturnStatus
    from OCP.STEPCAFControl import STEPCAFControl_Reader
    from OCP.TCollection import TCollection_ExtendedString
    from OCP.TDocStd import TDocStd_Document

    reader = STEPCAFControl_Reader()
    reader.SetNameMode(True)
    document = TDocStd_Document(TCollection_ExtendedString("pitchpoint"))
    try:
        good = reader.ReadFile(file) == IFSelect_ReturnStatus.IFSelect_RetDone and reader.Transfer(document)
    except RuntimeError as error:  # type of all OCC exceptions
        raise refused(name, f"cannot be read: {error}") from None
    if not good:
        raise refused(name, "cannot be read: it contains no model")
    lengths = Texts()
    reader.ChangeReader().FileUnits(lengths, Texts(), Texts())
    words = lengths.Value(1).ToCString() if lengths.Length() else "millimetre"
    return document, words.lower()


def _solids(document: Any) -> Iterator[tuple[str, Any]]:
    """Every solid of a document in its assembly position, with the name of its product."""
    from OCP.collections import Sequence_TDF_Label
    from OCP.TopLoc import TopLoc_Location
    from OCP.XCAFDoc import XCAFDoc_DocumentTool

    tool = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    labels = Sequence_TDF_Label()
    tool.GetFreeShapes(labels)
    for k in range(1, labels.Length() + 1):
        yield from _below(labels.Value(k), TopLoc_Location())


def _below(label: Any, place: Any) -> Iterator[tuple[str, Any]]:
    """Solids of a product, or of the parts of an assembly."""
    from OCP.collections import Sequence_TDF_Label
    from OCP.TDF import TDF_Label
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.XCAFDoc import XCAFDoc_ShapeTool

    if XCAFDoc_ShapeTool.IsAssembly_s(label):
        parts = Sequence_TDF_Label()
        XCAFDoc_ShapeTool.GetComponents_s(label, parts)
        for k in range(1, parts.Length() + 1):
            part, product = parts.Value(k), TDF_Label()
            XCAFDoc_ShapeTool.GetReferredShape_s(part, product)
            yield from _below(product, place.Multiplied(XCAFDoc_ShapeTool.GetLocation_s(part)))
        return
    shape = XCAFDoc_ShapeTool.GetShape_s(label).Moved(place)
    explorer = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_SOLID)
    while explorer.More():
        yield _name(label), explorer.Current()
        explorer.Next()


def _name(label: Any) -> str:
    from OCP.TDataStd import TDataStd_Name

    found = TDataStd_Name()
    return found.Get().ToExtString() if label.FindAttribute(TDataStd_Name.GetID_s(), found) else "solid"


def _check_closed(name: str, label: str, shape: Any) -> None:
    """Raise for a shell with an edge that is not shared by two faces."""
    from OCP.BRep import BRep_Tool
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer

    explorer = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_SHELL)
    while explorer.More():
        if not BRep_Tool.IsClosed_s(explorer.Current()):
            raise refused(name, f"holds the solid '{label}', whose surface is open")
        explorer.Next()


if __name__ == "__main__":
    sys.stdout.write(json.dumps(answered(_answer, *sys.argv[1:])))
