# SPDX-License-Identifier: Apache-2.0
"""Contact analyses in the terminal: a row per torque or mesh, and the flanks in contact."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pitchpoint.cli.output import show, show_notes, shown, table
from pitchpoint.viz.contact_table import (
    FLANKS,
    NEGLIGIBLE,
    columns,
    contact_words,
    flank_cells,
    gear_names,
    meshes_table,
    operation_words,
)


def print_torques(title: str, summary: Mapping[str, Any], *, quiet: bool) -> None:
    """Print one row per torque, the flanks in contact, and the description of the contact."""
    found = summary["numbers"]
    chosen = columns(found)
    rows = [
        [shown(torque, "torque", 5), *(c.text(found[c.key][k]) for c in chosen)]
        for k, torque in enumerate(summary["torque"])
    ]
    table(title, ["torque", *(c.heading for c in chosen)], rows)
    if quiet:
        return
    most = max(range(len(rows)), key=lambda k: summary["torque"][k])
    flanks = _flank_rows(summary, most)
    table(f"Flanks in contact at {rows[most][0]}", ["gear", *FLANKS], flanks)
    show(_about(summary))
    _print_end(summary)


def print_meshes(title: str, summary: Mapping[str, Any], *, quiet: bool) -> None:
    """Print one row per mesh, the flanks in contact, and the descriptions of the contacts."""
    meshes: Mapping[str, Any] = summary["meshes"]
    head, *rows = meshes_table(
        {
            mesh: (one["torque"][0], one["mesh_force"][0], _tilt(one) * one["face_width"], one["numbers"])
            for mesh, one in meshes.items()
        }
    )
    table(title, head, rows)
    if quiet:
        return
    flanks = [[mesh, *row] for mesh, one in meshes.items() for row in _flank_rows(one, 0)]
    table("Flanks in contact", ["mesh", "gear", *FLANKS], flanks, keys=2)
    words: dict[str, list[str]] = {}
    for mesh, one in meshes.items():
        words.setdefault(_about(one, tilted=False), []).append(mesh)
    for text, names in words.items():
        show(f"{', '.join(names)}: {text}")
    _print_end(summary)


def _flank_rows(one: Mapping[str, Any], torque: int) -> list[list[str]]:
    """Rows of the flanks in contact of both gears of a mesh at a torque."""
    flanks = one["active_flanks"][torque] or ()
    return [
        [name, *flank_cells(flank)] for name, flank in zip(gear_names(one["options"]), flanks, strict=False)
    ]


def _print_end(summary: Mapping[str, Any]) -> None:
    """Print notes and the files."""
    show_notes(summary["notes"])
    for name in ("output", "picture"):
        if summary[name] is not None:
            show(f"written to {summary[name]}")


def _tilt(one: Mapping[str, Any]) -> float:
    """Misalignment in the plane of action, with shafts in the mean [rad]."""
    tilts = one.get("misalignment", [one["options"].get("misalignment", 0.0)])
    return float(sum(tilts) / len(tilts))


def _about(one: Mapping[str, Any], *, tilted: bool = True) -> str:
    """Contact, flank, misalignment and operating conditions in words."""
    options, angle = one["options"], _tilt(one) if tilted else 0.0
    words = ["back flanks" if options.get("flank") == -1 else "front flanks"]
    words += ["shafts in equilibrium"] if options.get("shafts") else []
    words += [f"misalignment {shown(angle, 'angle', 4)}"] if abs(angle) > NEGLIGIBLE else []
    phases = f"{len(one['mesh_phase'])} mesh phases"
    return f"{contact_words(options)}; {', '.join([phases, *words, *operation_words(options)])}"
