# SPDX-License-Identifier: Apache-2.0
"""Provenance of a result: file, model version, solver, options, status."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from pitchpoint.core.status import OK
from pitchpoint.core.status import sentence as sentence_of
from pitchpoint.viz.quantities import amount, printed
from pitchpoint.viz.report.build import SourceData

KINDS = {
    "time": "time response",
    "quasi_static": "slow roll",
    "sweep": "speed sweep",
    "cases": "cases",
    "contact": "contact analysis",
    "campbell": "Campbell diagram",
    "relief": "relief design",
    "study": "study",
}
UNITS = {
    "duration": "s",
    "settle_time": "s",
    "step": "s",
    "long_step": "s",
    "sample_rate": "Hz",
    "speed": "rad/s",
}
UNITS |= {"operating_speed": "rad/s", "mesh_frequency": "Hz", "misalignment": "rad"}
UNITS |= {"viscosity": "Pa s", "pressure_viscosity": "1/Pa"}
RANGES = ("operating_speed", "mesh_frequency", "speed")
"""Options whose two values are the ends of a range."""
NAMES = ("mesh", "body", "scenario")
"""Options whose values are names of the model."""
KEPT = ("vary_units",)
"""Options that are in the tables of the results."""
EMPTY: tuple[Any, ...] = ("", None, [], {}, ())


def source_of(name: str, header: Mapping[str, Any], model_hash: str, file: str = "") -> SourceData:
    """Facts about a result.

    Parameters
    ----------
    name
        Name in the report.
    header
        Attributes of its file or dataset.
    model_hash
        Fingerprint of the model of the report.
    file
        Name of the file, if any.
    """
    options = header.get("options") or {}
    if isinstance(options, str):
        options = json.loads(options)
    status, sentence = _end(header)
    theirs = str(header.get("model_hash", ""))
    same = "" if not theirs else " (this model)" if theirs == model_hash else " (other version of the model)"
    kind = str(header.get("kind", ""))
    rows = [
        ("file", file),
        ("kind", KINDS.get(kind, kind.replace("_", " "))),
        ("scenario", str(header.get("scenario", ""))),
        ("status", f"{status}: {sentence}" if sentence not in ("", status) else status),
        ("solver", str(header.get("solver", "")).replace("_", " ")),
        ("steps", _text("steps", header.get("steps") or None)),
        ("computing time", _text("duration", header.get("wall_s"))),
        ("computed", str(header.get("created", "")).replace("T", " ").replace("+00:00", " UTC")),
        ("by", str(header.get("source", ""))),
        ("model", f"{theirs}{same}"),
        *(
            (key.replace("_", " "), _text(key, value))
            for key, value in sorted(options.items())
            if key not in KEPT
        ),
    ]
    return SourceData(
        name=name,
        kind=KINDS.get(kind, kind.replace("_", " ")),
        finished=status in ("", "finished"),
        sentence=f"{status}: {sentence}" if sentence else status,
        rows=[(key, text) for key, text in rows if text],
    )


def _end(header: Mapping[str, Any]) -> tuple[str, str]:
    """Status of a result as a word and a sentence; datasets store the number of the status."""
    status, words = header.get("status", ""), str(header.get("sentence", ""))
    if isinstance(status, str):
        return status, words
    code = int(status)
    return ("finished" if code == OK else "failed"), words or sentence_of(code)


def _text(key: str, value: Any) -> str:
    """Option as text; empty if not set."""
    if any(value is x or (type(value) is type(x) and value == x) for x in EMPTY):
        return ""
    if isinstance(value, Mapping):
        # the unit is that of the entry in a sweep, with its step and speeds; else that of the key
        inner = {k: key if key in UNITS or k not in (*NAMES, *UNITS) else k for k in value}
        return ", ".join(f"{k}: {_text(inner[k], v)}" for k, v in value.items())
    if isinstance(value, list | tuple):
        if key in RANGES and len(value) == 2:
            return " to ".join(dict.fromkeys(_text(key, v) for v in value))
        return ", ".join(_text(key, v) for v in value)
    if isinstance(value, bool) or not isinstance(value, int | float):
        # laws are shown in the model file; their representation here is not readable
        text = "" if "(" in str(value) else printed(str(value))
        return text if key in NAMES else text.replace("_", " ")
    return amount(float(value), UNITS.get(key, ""), 5)
