# SPDX-License-Identifier: Apache-2.0
"""Object files of a model and their link to a shared library, for every platform.

The linker is that of ziglang (extra `fmi`), which links for all platforms; for the own platform on Linux the
linker of the system is sufficient. The link takes some milliseconds; no compiler of C is used on Linux and
Windows.
"""

from __future__ import annotations

import importlib.util
import re
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from pitchpoint.core.errors import MissingDependencyError, PitchpointError
from pitchpoint.core.fmi.fmu_file import own_platform
from pitchpoint.io.fmu.model import FmuModel
from pitchpoint.io.fmu.model_data import data_text, glue

MATHEMATICS = (
    "acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh erf exp exp2 expm1 fabs floor fma "
    "fmax fmin fmod hypot ldexp lgamma log log10 log1p log2 nearbyint pow rint round sin sincos sinh sqrt "
    "tan tanh tgamma trunc"
).split()
MEMORY = ("calloc", "free", "memcpy", "memmove", "memset", "strlen")

#: Machine code that returns 1 if processor and system have AVX2, FMA, BMI1 and BMI2 (cpuid leaves 1 and 7,
#: xgetbv), else 0. It is given as bytes because not every host has an assembler for it.
_PROCESSOR = (
    "53b80100000031c90fa281e10010001881f900100018752b31c90f01d083e00683f806751eb80700000031c90fa281e328010000"
    "81fb280100007507b8010000005bc331c05bc3"
)


@dataclass(frozen=True)
class Platform:
    """Platform of a shared library.

    Parameters
    ----------
    triple, processor
        Target of the code.
    suffix
        Ending of the library.
    folder_2
        Its folder in units of FMI 2.0; in those of FMI 3.0 it is the name of the platform.
    """

    triple: str
    processor: str
    suffix: str
    folder_2: str

    @property
    def plain_processor(self) -> str:
        """Processor of the FMI functions, which check the actual one."""
        return "x86-64" if self.triple.startswith("x86_64") else self.processor


PLATFORMS = {
    "x86_64-linux": Platform("x86_64-unknown-linux-gnu", "x86-64-v3", "so", "linux64"),
    "aarch64-linux": Platform("aarch64-unknown-linux-gnu", "generic", "so", "aarch64-linux"),
    "x86_64-windows": Platform("x86_64-pc-windows-msvc", "x86-64-v3", "dll", "win64"),
    "aarch64-darwin": Platform("arm64-apple-macosx11.0.0", "apple-m1", "dylib", "darwin64"),
}
"""Platforms by their names in FMI 3.0."""


def library(model: FmuModel, name: str, version: int, folder: Path) -> Path:
    """Link the shared library of a model.

    Parameters
    ----------
    model
        The model.
    name
        Platform, a key of `PLATFORMS`.
    version
        Version of FMI, 2 or 3.
    folder
        Folder for the library and the object files.

    Raises
    ------
    MissingDependencyError
        If there is no linker for the platform.
    PitchpointError
        If the code needs functions that a platform does not have, or the link fails.
    """
    check_linker(name)
    target = PLATFORMS[name]
    folder.mkdir(parents=True, exist_ok=True)
    text = glue(f"fmi{version}.ll")
    objects = _objects(model, target, text, folder)
    out = folder / f"{model.name}.{target.suffix}"
    if target.suffix == "so":
        command = [
            *_elf_linker(name),
            *_ELF,
            "-o",
            str(out),
            *objects,
            *_stubs(target, folder, _elf_linker(name)),
        ]
    elif target.suffix == "dll":
        command = _windows_command(text, out, objects, folder)
    else:
        install = ["-install_name", f"@rpath/{out.name}"]
        command = [zig(), "cc", "-target", "aarch64-macos", "-shared", *install, "-o", str(out), *objects]
    run_linker(command, folder)
    return out


def check_linker(name: str) -> None:
    """Check that there is a linker for a platform.

    Raises
    ------
    MissingDependencyError
        If there is none.
    """
    if not (zig() or (PLATFORMS[name].suffix == "so" and _elf_linker(name))):
        raise MissingDependencyError(
            f"the library for {name} needs a linker, and none is installed; install it with "
            "pip install 'pitchpoint[fmi]'"
        )


# --------------------------------------------------------------------------------------------- object files


def _objects(model: FmuModel, target: Platform, text: str, folder: Path) -> list[str]:
    """Write the object files of the entry points, the data and the FMI functions."""
    from pitchpoint.core.compiler import portable

    known = {*MATHEMATICS, *MEMORY}
    unknown = {s for _, code in model.entries for s in portable.external_symbols(code)} - known
    if unknown:
        raise PitchpointError(
            f"the compiled model calls {', '.join(sorted(unknown))}, which an FMU does not have; it cannot "
            "be exported"
        )
    parts = {
        f"entry{k}": portable.object_of_entry(code, target.triple, target.processor)
        for k, (_, code) in enumerate(model.entries)
    }
    data = data_text(model) + ("@_fltused = global i32 0\n" if target.suffix == "dll" else "")
    for name, each in (("data", data), ("fmi", text), ("processor", _processor_text(target))):
        parts[name] = portable.object_of_text(each, target.triple, target.plain_processor)
    for name, code in parts.items():
        (folder / f"{name}.o").write_bytes(code)
    return [str(folder / f"{name}.o") for name in parts]


def _processor_text(target: Platform) -> str:
    """LLVM text of the function that tests the processor."""
    if not target.triple.startswith("x86_64"):
        return "define hidden i32 @pp_processor() {\n  ret i32 1\n}\n"
    code = bytes.fromhex(_PROCESSOR)
    data = "".join(f"\\{byte:02X}" for byte in code)
    return f'define hidden i32 @pp_processor() prologue [{len(code)} x i8] c"{data}" {{\n  ret i32 0\n}}\n'


# --------------------------------------------------------------------------------------------------- linkers

_ELF = (
    *("-shared", "-s", "--gc-sections", "--as-needed", "--no-undefined", "--hash-style=gnu"),
    *("-z", "noexecstack", "-z", "relro"),
)


def zig() -> str:
    """Program of ziglang; empty without it."""
    found = importlib.util.find_spec("ziglang")
    if found is None or not found.submodule_search_locations:
        return ""
    return shutil.which("zig", path=str(list(found.submodule_search_locations)[0])) or ""


def _elf_linker(name: str) -> list[str]:
    """Command of a linker of shared libraries for Linux; empty without one."""
    if zig():
        return [zig(), "ld.lld"]
    for program in ("ld.lld", *(["ld"] if name == own_platform() else [])):
        if found := shutil.which(program):
            return [found]
    return []


def _stubs(target: Platform, folder: Path, linker: Sequence[str]) -> list[str]:
    """Empty libraries with the names and symbols of the C library: the link needs no files of the system."""
    from pitchpoint.core.compiler import portable

    made = []
    for library_name, symbols in (("libm.so.6", MATHEMATICS), ("libc.so.6", MEMORY)):
        text = "".join(f"define void @{symbol}() {{\n ret void\n}}\n" for symbol in symbols)
        stub = folder / "stub.o"
        stub.write_bytes(portable.object_of_text(text, target.triple, target.plain_processor))
        out = folder / library_name
        run_linker([*linker, "-shared", "-soname", library_name, "-o", str(out), str(stub)], folder)
        made.append(str(out))
    return made


def _windows_command(text: str, out: Path, objects: Sequence[str], folder: Path) -> list[str]:
    """Link command for Windows; the library of the C functions is ucrtbase.dll, part of the system."""
    lines = ["LIBRARY ucrtbase", "EXPORTS", *MATHEMATICS, *MEMORY]
    (folder / "ucrt.def").write_text("\n".join(lines) + "\n", encoding="ascii")
    run_linker([zig(), "dlltool", "-m", "i386:x86-64", "-d", "ucrt.def", "-l", "ucrt.lib"], folder)
    exports = [f"/export:{name}" for name in re.findall(r"^define [^\n]*@(fmi\w+)\(", text, re.MULTILINE)]
    return [zig(), "lld-link", "/dll", "/noentry", f"/out:{out}", *objects, "ucrt.lib", *exports]


def run_linker(command: Sequence[str], folder: Path) -> None:
    """Run a linker.

    Raises
    ------
    PitchpointError
        With the last line of its messages.
    """
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    if done.returncode:
        lines = (done.stderr or done.stdout).strip().splitlines() or [f"exit code {done.returncode}"]
        raise PitchpointError(f"{Path(command[0]).name}: the link failed: {lines[-1]}")
