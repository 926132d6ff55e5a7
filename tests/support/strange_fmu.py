# SPDX-License-Identifier: Apache-2.0
"""FMUs for tests: one of plain C that can fail in several ways, and files that are wrong or hostile."""

from __future__ import annotations

import platform
import shutil
import struct
import subprocess
import zipfile
from pathlib import Path

import pytest

from pitchpoint.core.fmi.fmu_file import own_platform

DESCRIPTION = """<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="2.0" modelName="strange" guid="{strange}">
  <CoSimulation modelIdentifier="strange"/>
  <UnitDefinitions>
    <Unit name="rpm"><BaseUnit rad="1" s="-1" factor="0.10471975511965977"/></Unit>
    <Unit name="N m"><BaseUnit kg="1" m="2" s="-2"/></Unit>
  </UnitDefinitions>
  <ModelVariables>
    <ScalarVariable name="u" valueReference="0" causality="input">
      <Real start="0" unit="rpm"/>
    </ScalarVariable>
    <ScalarVariable name="mode" valueReference="1" causality="parameter"><Real start="0"/></ScalarVariable>
    <ScalarVariable name="y" valueReference="2" causality="output"><Real unit="N m"/></ScalarVariable>
    <ScalarVariable name="note" valueReference="3" causality="output"><String/></ScalarVariable>
  </ModelVariables>
</fmiModelDescription>
"""


def elf_header(processor: int = 0, end: int = 0) -> bytes:
    """Header of a library of Linux without sections, by the System V ABI; `end` is the place of a table."""
    machine = processor or {"x86_64": 62, "aarch64": 183}.get(platform.machine(), 62)
    head = struct.pack(
        "<6s10xHHIQQQIHHHHHH", b"\x7fELF\2\1", 3, machine, 1, 0, 0, end, 0, 64, 56, 0, 64, 0, 0
    )
    return head if not end else head[:60] + struct.pack("<HH", 9, 0)


def write_fmu(
    path: Path, entries: dict[str, bytes | str] | None = None, changes: dict[str, str] | None = None
) -> Path:
    """File of an FMU; entries replace those of a correct one, changes are made in its description."""
    text = DESCRIPTION
    for old, new in (changes or {}).items():
        assert old in text
        text = text.replace(old, new)
    library = f"binaries/{own_platform()}/strange.so"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in ({"modelDescription.xml": text, library: elf_header()} | (entries or {})).items():
            archive.writestr(name, data)
    return path


def strange_fmu(folder: Path) -> Path:
    """FMU of `strange_fmu.c`; only where there is a compiler, Linux and FMPy."""
    pytest.importorskip("fmpy", reason="fmpy is not installed (extra fmi)")
    compiler = shutil.which("cc")
    if compiler is None or "linux" not in own_platform():
        pytest.skip("there is no compiler of C, or no Linux")
    library = folder / "strange.so"
    source = Path(__file__).with_suffix(".c")
    subprocess.run([compiler, "-shared", "-fPIC", "-o", str(library), str(source), "-lm"], check=True)
    entries = {f"binaries/{own_platform()}/strange.so": library.read_bytes()}
    return write_fmu(folder / "strange.fmu", entries)
