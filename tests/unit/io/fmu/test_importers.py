# SPDX-License-Identifier: Apache-2.0
"""Units in other programs: a plain C program, FMPy, and libraries for other platforms."""

from __future__ import annotations

import io
import shutil
import struct
import subprocess
import xml.etree.ElementTree as ET
import zipfile
from pathlib import Path

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.io.fmu.linking import PLATFORMS
from pitchpoint.io.fmu.writing import fmu_bytes
from pitchpoint.report.exported_model import begin_export, fmu_model
from pitchpoint.solvers.explicit.runge_kutta import start_adaptive
from tests.support import fmi_host
from tests.support.fmu_models import need_linker, own_run, own_start, pair, unit_of

H = 1e-5


def test_a_program_in_c(tmp_path):
    """Without Python in its process: the bits of our own run."""
    need_linker()
    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("there is no compiler of C")
    unit = fmi_host.Unit(unit_of("adams", tmp_path, 3), tmp_path)
    program = tmp_path / "host"
    source = Path(fmi_host.__file__).with_name("fmi_host.c")
    subprocess.run([compiler, "-o", str(program), str(source), "-ldl"], check=True)
    n = len(unit.references("output"))
    assert unit.references("output") == list(range(n))
    arguments = [str(unit.library), unit.token, str(n), "100", repr(4 * H)]
    done = subprocess.run([str(program), *arguments], check=True, capture_output=True)
    got = np.frombuffer(done.stdout).reshape(100, n)
    want = own_run("adams").advance(400, every=4).rows[:, 1:]
    assert np.array_equal(got.view(np.int64), np.ascontiguousarray(want).view(np.int64))


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("version", [2, 3])
def test_fmpy(version, tmp_path):
    """The description is valid; co-simulation has our bits, model exchange agrees within the tolerance."""
    need_linker()
    fmpy = pytest.importorskip("fmpy", reason="FMPy is not installed (extra fmi)")
    from fmpy.validation import validate_fmu

    file = unit_of("adams", tmp_path, version)
    assert validate_fmu(str(file)) == []
    times = dict(stop_time=2e-3, output_interval=4 * H)
    found = fmpy.simulate_fmu(str(file), fmi_type="CoSimulation", **times)
    own = own_run("adams")
    want = own.advance(200, every=4).rows[:, 1:]
    for k, channel in enumerate(own.system.layout.channels):
        got = np.ascontiguousarray(found[channel.name][1:])
        assert np.array_equal(got.view(np.int64), np.ascontiguousarray(want[:, k]).view(np.int64))
    # CVode from outside against our own method with step control; it has 1e-12 rad as absolute tolerance
    outside = fmpy.simulate_fmu(str(file), fmi_type="ModelExchange", relative_tolerance=1e-12, **times)
    exact = start_adaptive(own.system, own_start("adams").state, rtol=1e-9, atol=1e-13, atol_rate=1e-9)
    rows = exact.advance_to(2e-3, sample=4 * H).rows
    for name in ("deflection[stage]", "speed[driver]"):
        k = 1 + [channel.name for channel in own.system.layout.channels].index(name)
        got = np.interp(rows[:, 0], outside["time"], outside[name])
        assert np.abs(got - rows[:, k]).max() < 1e-5 * np.abs(rows[:, k]).max()


@pytest.mark.parametrize("version", [2, 3])
def test_libraries_for_all_platforms(version):
    """They cannot be run here: format, processor, and the libraries of the system that they import."""
    pytest.importorskip("ziglang", reason="ziglang is not installed (extra fmi)")
    run, _ = begin_export(pair("adams"), "steady")
    data, sizes = fmu_bytes(fmu_model(run, (), "pair", "pair"), version, list(PLATFORMS))
    assert all(100_000 < size < 300_000 for size in sizes.values())
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        files = {n.split("/")[1]: archive.read(n) for n in archive.namelist() if n.startswith("binaries/")}
    x86, arm, windows, mac = files.values()
    assert (x86[:4], struct.unpack_from("<H", x86, 18)[0]) == (b"\x7fELF", 62)
    assert (arm[:4], struct.unpack_from("<H", arm, 18)[0]) == (b"\x7fELF", 183)
    assert windows[:2] == b"MZ" and windows.count(b".dll\0") == 1 + 1  # its own name, and
    assert b"ucrtbase.dll\0" in windows
    assert struct.unpack_from("<II", mac) == (0xFEEDFACF, 0x0100000C) and b"libSystem" in mac
    for each in files.values():
        assert f"fmi{version}DoStep".encode() in each


def test_from_python(tmp_path):
    """A parameter, and terminals of the shafts."""
    need_linker()
    file = pp.export_fmu(
        pair("adams"), tmp_path / "pair.fmu", "steady", parameters=["meshes.stage.damper.ratio"]
    )
    unit = fmi_host.Unit(file, tmp_path)
    assert unit.names("parameter") == ["meshes.stage.damper.ratio"]
    ratio = unit.variables["meshes.stage.damper.ratio"]
    assert (ratio.get("min"), ratio.get("max")) == ("0.0", "10.0")  # limits of the model file
    assert [t.get("name") for t in terminals(tmp_path)] == ["loads.input.torque", "loads.output.torque"]
    members = {m.get("memberName"): m.get("variableName") for m in terminals(tmp_path)[0]}
    assert members == {"tau": "loads.input.torque", "phi": "angle[driver]", "w": "speed[driver]"}
    assert set(members.values()) <= set(unit.variables)


def terminals(folder):
    """Terminals of an unpacked unit."""
    path = folder / "terminalsAndIcons" / "terminalsAndIcons.xml"
    return list(ET.parse(path).getroot().find("Terminals"))
