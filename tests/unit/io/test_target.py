# SPDX-License-Identifier: Apache-2.0
"""What may be written where: a new file, an empty one, one of the same kind; never an input."""

from __future__ import annotations

import json
import os
import struct
from pathlib import Path

import h5py
import numpy as np
import pytest
import xarray as xr

from pitchpoint.analysis.dataset import analyse
from pitchpoint.contact.potential_fit import PotentialTable
from pitchpoint.core.compiler.memory_image import MemoryImage
from pitchpoint.core.errors import PitchpointError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.io.analysis_table import table_text
from pitchpoint.io.contact_table import write_contact_table
from pitchpoint.io.container import Container, Header
from pitchpoint.io.dataset_store import DatasetFolder
from pitchpoint.io.fmu.model import FmuModel
from pitchpoint.io.fmu.writing import fmu_bytes
from pitchpoint.io.gear_export import FORMATS, export_gear
from pitchpoint.io.mode_animation import write_mode_animation
from pitchpoint.io.rexs.exporting.exporting import export_rexs
from pitchpoint.io.rexs.housing_file import matrix_text
from pitchpoint.io.rexs.writing.text import rexs_bytes
from pitchpoint.io.target import KINDS, PDF_TITLE, TREND_OF_RECORDS, OutputError, check_target, write_file
from pitchpoint.io.wind.turbsim import write_turbsim
from pitchpoint.io.writing import Channel, ResultWriter
from pitchpoint.io.yaml_edit import changed_text
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.schema import json_schema
from pitchpoint.model.wind.box import WindBox
from pitchpoint.report.diagnosis.many import FileRow, FolderDiagnosis
from pitchpoint.report.figure_picture import marked_png
from pitchpoint.report.stiffness_tables import StiffnessTable, csv_text
from pitchpoint.viz.report.page import page

GEAR = CylindricalGear(z=17, m_n=1e-3, b=0.01)


def own_file(kind: str, path: Path) -> Path:
    """Write a file of a kind as the package writes it."""
    if kind == "result":
        with ResultWriter(path, Header("time"), [Channel("x", "m")]) as writer:
            writer.append(np.zeros(1), np.zeros((1, 1)))
    elif kind == "contact":
        table = PotentialTable.of_spring(2e8, 0.0, 3e-5)
        write_contact_table(path, {"front": table, "back": table}, {})
    elif kind == "model":
        text = "bodies: {a: {inertia: 1 kg m^2}}\n"
        path.write_text(changed_text(text, loads_model(text), {}, str(path)), encoding="utf-8")
    elif kind == "rexs":
        text = "bodies: {rotor: {mass: 1 kg, inertia: 1e-3 kg m^2, position: [0, 0, 0]}}\n"
        path.write_bytes(rexs_bytes(export_rexs(loads_model(text)).rexs))
    elif kind == "housing":
        path.write_text(matrix_text(np.eye(6), ["left"]), encoding="utf-8")
    elif kind == "page":
        path.write_text(page("a", [], [], ""), encoding="utf-8")
    elif kind == "index":
        folder = DatasetFolder(path.with_name(f"{path.name}-data"))
        folder.begin("", "")
        folder.write_index("index.csv", ["seed"], [{"case": 0, "seed": 1}]).rename(path)
    elif kind == "analysis":
        record = xr.Dataset({"force": ("time", np.ones(8), {"units": "N"})}, {"time": np.arange(8.0)})
        path.write_text(table_text(analyse(record, "signal_statistics")), encoding="utf-8")
    elif kind == "animation":
        named = path.with_suffix(".json")
        at = {"place": np.zeros((1, 3)), "axes": np.eye(3)[None], "body_shape": np.ones((1, 1, 6))}
        write_mode_animation(named, bodies=["a"], names=["1"], frequency=np.ones(1), **at)
        named.rename(path)
    elif kind == "stiffness":
        table = StiffnessTable(np.zeros(1), np.ones(1), (1.0, 1.0))
        path.write_text(csv_text([("m", "mesh", table)]), encoding="utf-8")
    elif kind == "png":
        head = b"\x89PNG\r\n\x1a\n" + struct.pack(">I", 13) + b"IHDR" + bytes(17)
        path.write_bytes(marked_png(head))
    elif kind == "pdf":
        path.write_bytes(f"%PDF-1.4\n1 0 obj\n<</Title ({PDF_TITLE})>>\nendobj\n".encode())
    elif kind == "diagnoses":
        table = FolderDiagnosis("rig", (FileRow("a.csv", "nothing found"),))
        path.write_text(table.csv_text(), encoding="utf-8")
    elif kind == "schema":
        path.write_text(json.dumps(json_schema(), indent=2), encoding="utf-8")
    elif kind == "fmu":
        start = {"t0": 0.0, "h": 1e-3, "rate": 0.0}
        image = MemoryImage(bytes(8), {}, (), (), ())
        model = FmuModel("a", "a", image, (), (), {"exchange": 0}, start, (), (), 1.0, 0.1)
        path.write_bytes(fmu_bytes(model, 3, [])[0])
    elif kind == "turbsim":
        calm = np.ones((2, 1, 1, 3), np.float32)
        numbers = {"time_step": 1.0, "spacing": (1.0, 1.0), "bottom": 9.0, "hub_height": 9.0}
        write_turbsim(path, WindBox(velocity=calm, mean_speed=1.0, with_mean=True, **numbers))
    else:
        if kind == "step":
            pytest.importorskip("OCP", reason="OCC (the extra cad) is not installed")
        export_gear(GEAR, path, kind, n_flank=5)
    return path


def test_a_table_of_a_trend_may_be_replaced_by_one_of_diagnoses(tmp_path: Path) -> None:
    path = tmp_path / "trend.csv"
    path.write_text(f"{TREND_OF_RECORDS},load\n", encoding="utf-8")
    assert check_target(path, "diagnoses") == path


@pytest.mark.parametrize("kind", KINDS)
def test_a_kind_replaces_itself_and_nothing_else(kind: str, tmp_path: Path) -> None:
    own = own_file(kind, tmp_path / "own")
    assert check_target(own, kind) == own
    for other in KINDS:
        if other != kind:
            with pytest.raises(
                OutputError, match=r"output: .*own exists and is not .*\(limit a new file, or"
            ):
                check_target(own, other)
    empty, text = tmp_path / "empty", tmp_path / "model.yaml"
    empty.touch()
    text.write_text("gears: {}\n", encoding="utf-8")
    assert check_target(empty, kind) == empty
    assert check_target(tmp_path / "none" / "x", kind).name == "x"
    assert check_target(os.devnull, kind) == Path(os.devnull)
    with pytest.raises(OutputError, match="name another file, or delete this one first"):
        check_target(text, kind)


FOREIGN = {
    "page": b"<!DOCTYPE html>\n<html><head><title>mine</title></head></html>",
    "dxf": b"0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n",
    "svg": b"<svg xmlns='http://www.w3.org/2000/svg'></svg>",
    "csv": b"x,y\n1,2\n",
    "index": b"case,file\n1,a\n",
    "analysis": b"# analysis\nx,y\n1,2\n",
    "model": b"gears: {}\n",
    "stl": b"solid mine\nendsolid mine\n",
}


@pytest.mark.parametrize("kind", FOREIGN)
def test_files_of_other_programs_stay_though_their_kind_is_right(kind: str, tmp_path: Path) -> None:
    foreign = tmp_path / f"mine.{kind}"
    foreign.write_bytes(FOREIGN[kind])
    with pytest.raises(OutputError, match="of pitchpoint .*name another file, or delete this one first"):
        check_target(foreign, kind)
    assert foreign.read_bytes() == FOREIGN[kind]


def test_foreign_and_damaged_hdf5_is_no_result(tmp_path: Path) -> None:
    foreign, cut = tmp_path / "measured.h5", tmp_path / "cut.h5"
    with h5py.File(foreign, "w") as file:
        file["force"] = np.arange(3.0)
    with pytest.raises(OutputError, match="is not a readable result file of pitchpoint"):
        Container(foreign, Header("time"))
    with h5py.File(foreign) as file:
        assert file["force"][2] == 2.0
    own = own_file("result", tmp_path / "own.h5").read_bytes()
    for whole in (foreign.read_bytes(), own):
        cut.write_bytes(whole[:-100])
        with pytest.raises(OutputError, match="is not a readable result file of pitchpoint"):
            Container(cut, Header("time"))
        assert cut.read_bytes() == whole[:-100]
    cut.write_bytes(own[:48])
    assert check_target(cut, "result") == cut  # the superblock alone: nothing was written yet


@pytest.mark.parametrize("how", ["itself", "symbolic", "hard", "relative"])
def test_an_input_is_known_by_any_name(how: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    page, other = Path("page.html"), Path("other.html")
    own_file("page", page)
    if how == "symbolic":
        other.symlink_to(page)
    elif how == "hard":
        os.link(page, other)
    else:
        other = page if how == "itself" else Path("..") / tmp_path.name / "page.html"
    with pytest.raises(OutputError, match="is read by the same command .* name another file"):
        check_target(other, "page", ["missing.yaml", page.resolve()])
    assert check_target(other, "page", ["missing.yaml"]) == other


@pytest.mark.parametrize("kind", FORMATS)
def test_an_export_leaves_foreign_files_alone(kind: str, tmp_path: Path) -> None:
    if kind in ("step", "stp"):
        pytest.importorskip("OCP", reason="OCC (the extra cad) is not installed")
    foreign = tmp_path / f"points.{kind}"
    foreign.write_text("x,y\n1,2\n", encoding="utf-8")
    with pytest.raises(PitchpointError, match="exists and is not"):
        export_gear(GEAR, foreign, n_flank=5)
    assert foreign.read_text(encoding="utf-8") == "x,y\n1,2\n"
    again = export_gear(GEAR, tmp_path / "new" / f"gear.{kind}", n_flank=5)
    assert export_gear(GEAR, again, n_flank=5) == again


@pytest.mark.parametrize("where", ["folder", "file/x.html"])
def test_what_cannot_be_written_is_told_with_path_and_reason(where: str, tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    (tmp_path / "file").touch()
    target = tmp_path / where
    with pytest.raises(OutputError, match=r"(folder|x\.html): cannot be written \((Is|Not) a directory\)$"):
        check_target(target, "page")
    with pytest.raises(OutputError, match=r"(folder|x\.html): cannot be written \(\w+"):
        write_file(target, "text")
    with pytest.raises(PitchpointError, match=r"(folder|x\.html): cannot be written \([^()]+\)$"):
        Container(target, Header("time"))


def test_a_folder_that_may_not_be_written_is_told_before_the_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("pitchpoint.io.target.os.access", lambda *_: False)
    with pytest.raises(OutputError, match=r"x\.html: cannot be written \(Permission denied\)$"):
        check_target(tmp_path / "new" / "x.html", "page")


def test_a_file_that_vanishes_during_the_check_is_a_free_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Another process that replaces the same result removes the older file at any moment."""
    path = tmp_path / "r.h5"
    path.write_bytes(b"")

    def access(asked: Path, mode: int) -> bool:
        path.unlink(missing_ok=True)
        return asked.exists()

    monkeypatch.setattr(os, "access", access)
    assert check_target(path, "result") == path
