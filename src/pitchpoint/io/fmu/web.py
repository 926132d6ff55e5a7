# SPDX-License-Identifier: Apache-2.0
"""Compiled model as WebAssembly, with the functions of FMI 3.0, for pages and other hosts."""

from __future__ import annotations

import tempfile
from pathlib import Path

from pitchpoint.core.errors import MissingDependencyError
from pitchpoint.io.fmu.linking import run_linker, zig
from pitchpoint.io.fmu.model import FmuModel
from pitchpoint.io.fmu.model_data import data_text, glue

FUNCTIONS = (
    *("malloc", "free", "fmi3InstantiateCoSimulation", "fmi3EnterInitializationMode"),
    *("fmi3ExitInitializationMode", "fmi3DoStep", "fmi3GetFloat64", "fmi3SetFloat64", "fmi3Reset"),
    "live_frames",
)
"""Exported functions."""
_SOURCES = ("instance.h", "co_simulation.h", "equilibrium.h", "model_exchange.h", "fmi3.c", "live.c")


def check_web() -> None:
    """Check that a module can be linked.

    Raises
    ------
    MissingDependencyError
        Without ziglang.
    """
    if not zig():
        raise MissingDependencyError(
            "a live page needs ziglang, which is not installed; install it with pip install 'pitchpoint[fmi]'"
        )


def web_assembly(model: FmuModel) -> bytes:
    """Module of a model; its entry points have the intermediate code for WebAssembly.

    The FMI functions are compiled from C here, since their text for 64-bit targets does not fit. Mathematical
    functions are those of the C library of ziglang (musl).

    Parameters
    ----------
    model
        The model.
    """
    from pitchpoint.core.compiler import portable

    check_web()
    with tempfile.TemporaryDirectory(prefix="pitchpoint-") as name:
        folder = Path(name)
        parts = {
            f"entry{k}": portable.object_of_entry(c, *portable.NARROW)
            for k, (_, c) in enumerate(model.entries)
        }
        text = data_text(model) + "define hidden i32 @pp_processor() {\n  ret i32 1\n}\n"
        parts["data"] = portable.object_of_text(text, *portable.NARROW)
        for part, code in parts.items():
            (folder / f"{part}.o").write_bytes(code)
        for source in _SOURCES:
            (folder / source).write_text(glue(source), encoding="utf-8")
        options = ["-target", "wasm32-wasi", "-O2", "-s", "-w", "-mexec-model=reactor", "-fno-sanitize=all"]
        exports = [f"-Wl,--export={function}" for function in FUNCTIONS]
        objects = [f"{part}.o" for part in parts]
        run_linker([zig(), "cc", *options, *exports, "-o", "model.wasm", "live.c", *objects], folder)
        return (folder / "model.wasm").read_bytes()
