# SPDX-License-Identifier: Apache-2.0
"""Data of a model as LLVM text: memory, places of addresses, variables, as in `glue/instance.h`."""

from __future__ import annotations

import re
import struct
from collections import Counter
from collections.abc import Iterable
from importlib.resources import files

from pitchpoint.core.status import sentence
from pitchpoint.io.fmu.model import SPEED, FmuModel, Variable

STATUSES = 18
"""Number of statuses of `core.status` whose sentences are part of an FMU."""


def glue(name: str) -> str:
    """Text of a file of the folder `glue`."""
    return (files("pitchpoint.io.fmu") / "glue" / name).read_text(encoding="utf-8")


def number_names() -> tuple[list[str], list[str]]:
    """Names of the integers and of the real numbers of `Numbers`, in the order of the C declaration."""
    found = re.search(r"typedef struct \{([^}]*)\} Numbers;", glue("instance.h"))
    lines = re.findall(r"(i64|double) ([^;]*);", found[1] if found else "")
    split = {
        kind: [n for k, names in lines if k == kind for n in names.split(", ")] for kind in ("i64", "double")
    }
    return split["i64"], split["double"]


def data_text(model: FmuModel) -> str:
    """LLVM text of the data of a model."""
    symbols = [symbol for symbol, _ in model.entries]
    words = [(offset, terms) for v in model.variables for offset, terms in v.words]
    often = Counter(offset for offset, _ in words)
    counts = {
        "n_moved": len(model.image.moved),
        "n_code": len(model.code),
        "n_variables": len(model.variables),
        "n_indicators": len(model.indicators),
        "n_drives": len(model.of_kind(SPEED)),
        "n_entries": len(model.rest["entries_of_matrix"]) // 3,
        "n_free": len(model.rest["free"]),
        "n_free_balancing": len(model.rest["free_balancing"]),
        "n_balancing": len(model.rest["balancing"]) // 2,
        "n_instants": len(model.instants) // 2,
        "n_spins": len(model.rest["spins"]),
        "n_gaps": len(model.rest["gaps"]),
    }
    integers, reals = number_names()
    values = [f"i64 {({**model.numbers, **counts})[n]}" for n in integers]
    values += [f"double {_real(model.reals[n])}" for n in reals]
    kinds = ", ".join(["i64"] * len(integers) + ["double"] * len(reals))
    lines = [f"declare i64 @{symbol}(i64, i64, i64)" for symbol in symbols]
    lines.append(_constant("pp_numbers", f"{{ {kinds} }}", f"{{ {', '.join(values)} }}"))
    lines.append(_text("pp_token", model.token))
    lines.append(_constant("pp_image", f"[{len(model.image.data)} x i8]", _bytes(model.image.data)))
    lines.append(_array("pp_moved", "i32", model.image.moved))
    lines.append(_array("pp_code", "i32", (x for pair in model.code for x in pair)))
    lines.append(_array("pp_entries", "ptr", (f"@{symbol}" for symbol in symbols)))
    lines.append(_array("pp_variables", "{ i64, i64, i64, double, double, double }", _variables(model)))
    rows, first = [], 0
    for offset, terms in words:
        head = f"i64 {offset}, i64 {first}, i64 {len(terms)}, i64 {int(often[offset] > 1)}"
        rows.append(f"{{ {head}, double {_real(_word(model, offset))} }}")
        first += len(terms)
    lines.append(_array("pp_places", "{ i64, i64, i64, i64, double }", rows))
    lines.append(_array("pp_coefficients", "double", (_real(c) for _, terms in words for c in terms)))
    lines.append(_array("pp_indicators", "i32", model.indicators))
    lines += [_array(f"pp_{name}", "i32", numbers) for name, numbers in model.rest.items()]
    lines.append(_array("pp_instants", "double", map(_real, model.instants)))
    lines.append(_array("pp_extents", "double", map(_real, model.extents)))
    lines.append(_array("pp_depths", "double", map(_real, model.depths)))
    lines += [_text(f"pp_sentence_{k}", sentence(k)) for k in range(STATUSES)]
    lines.append(_array("pp_sentences", "ptr", (f"@pp_sentence_{k}" for k in range(STATUSES))))
    lines.append(_constant("pp_n_sentences", "i64", str(STATUSES)))
    return "\n".join(lines) + "\n"


def _variables(model: FmuModel) -> Iterable[str]:
    """Rows of the table of variables; inputs and parameters refer to their places."""
    place = 0
    for v in model.variables:
        first = place if v.is_set else v.first
        yield f"{{ i64 {v.kind}, i64 {first}, i64 {len(v.words)}, {_range(v)} }}"
        place += len(v.words)


def _range(v: Variable) -> str:
    """Start, least and largest value."""
    return ", ".join(f"double {_real(x)}" for x in (v.start, v.least, v.most))


def _word(model: FmuModel, offset: int) -> float:
    value: float = struct.unpack_from("<d", model.image.data, offset)[0]
    return value


def _real(x: float) -> str:
    """Exact LLVM text of a number."""
    return f"0x{struct.unpack('<Q', struct.pack('<d', float(x)))[0]:016X}"


def _bytes(data: bytes) -> str:
    return 'c"' + "".join(f"\\{byte:02X}" for byte in data) + '"'


def _constant(name: str, kind: str, value: str) -> str:
    return f"@{name} = hidden constant {kind} {value}, align 64"


def _text(name: str, text: str) -> str:
    data = text.encode() + b"\0"
    return _constant(name, f"[{len(data)} x i8]", _bytes(data))


def _array(name: str, kind: str, values: Iterable[object]) -> str:
    rows = [f"{kind} {value}" for value in values]
    return _constant(name, f"[{len(rows)} x {kind}]", f"[{', '.join(rows)}]" if rows else "zeroinitializer")
