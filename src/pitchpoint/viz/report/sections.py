# SPDX-License-Identifier: Apache-2.0
"""Sections of a report: one function per section, from data to HTML."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from typing import Any

from pitchpoint.viz.gear_drawing import mesh_zone_svg, pair_svg
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.tables import (
    BEVEL_GEAR_ROWS,
    BEVEL_MESH_ROWS,
    GEAR_ROWS,
    MEASURE_ROWS,
    MESH_ROWS,
    common_name,
    key_html,
    plain_table,
    quantity_table,
    value_html,
)


def gear_section(
    gears: Mapping[str, Mapping[str, Any]],
    meshes: Mapping[str, Mapping[str, Any]],
    flanks: Sequence[Sequence[str]] = (),
    bevels: tuple[Mapping[str, Mapping[str, Any]], Mapping[str, Mapping[str, Any]]] = ({}, {}),
    inactive_faults: int = 0,
) -> Section:
    """Section with tables of gear and mesh data, inspection dimensions, flank modifications and deviations.

    `bevels`: bevel gears and their meshes; `inactive_faults`: number of tooth faults with severity 0.
    """
    section = Section("gears", "Gears and meshes")
    section.add(quantity_table(GEAR_ROWS, gears))
    if gears:
        section.add(
            "<p>Mass and moment of inertia are those of the gear alone, including the material in the place "
            "of its shaft.</p>"
        )
    table = quantity_table(MEASURE_ROWS, gears)
    section.add(f"<h3>Inspection dimensions</h3>{table}" if table else "")
    narrow = [name for name, gear in gears.items() if gear.get("span_measurable") is False]
    if narrow:
        section.add(f"<p>Face width too small for the span measurement: {escape(', '.join(narrow))}.</p>")
    if flanks:
        rows = [f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in line)}</tr>" for line in flanks]
        head = ("gear", "flanks", "modification or deviation", "amount", "extent")
        section.add(f"<h3>Flanks</h3>{plain_table(head, rows, numbers=False)}")
    if inactive_faults:
        one = inactive_faults == 1
        waiting = "1 gear fault has" if one else f"{inactive_faults} gear faults have"
        section.add(f"<p>{waiting} severity 0 and no effect.</p>")
    table = quantity_table(MESH_ROWS, meshes)
    section.add(f"<h3>Meshes</h3>{table}" if table else "")
    for title, rows_of, things in zip(
        ("Bevel gears", "Bevel meshes"), (BEVEL_GEAR_ROWS, BEVEL_MESH_ROWS), bevels, strict=True
    ):
        table = quantity_table(rows_of, things)
        section.add(f"<h3>{title}</h3>{table}" if table else "")
    return section


def drawing_section(pairs: Mapping[str, tuple[Any, str, str]]) -> Section:
    """Section with drawings of both gears in mesh and of the mesh zone, per pair."""
    section = Section("drawing", "Gears in mesh")
    # mirrored gears and planets look alike in the transverse section
    looks: dict[tuple[str, ...], list[str]] = {}
    for mesh, (pair, _, _) in pairs.items():
        sizes = (pair.a_w, *(v for g in (pair.gear1, pair.gear2) for v in (g.z, g.m_t, g.x, g.d_a, g.d_f)))
        looks.setdefault(tuple(f"{v:.4g}" for v in sizes), []).append(mesh)
    for meshes in looks.values():
        pair, first, second = pairs[meshes[0]]
        heading = f"<h3>{escape(common_name(meshes))}</h3>" if len(pairs) > 1 else ""
        section.add(
            f'{heading}<div class="pair"><figure>{pair_svg(pair, names=(first, second))}</figure>'
            f"<figure>{mesh_zone_svg(pair)}</figure></div>"
        )
    return section


def notes_section(
    assumptions: Sequence[tuple[str, Sequence[tuple[str, str]]]], sources: Sequence[str]
) -> Section:
    """Section with assumptions, as component and values in effect, and sources."""
    section = Section("notes", "Assumptions and sources")
    rows = [
        f'<tr><th scope="row">{escape(part)}</th>'
        f"<td>{'; '.join(f'{key_html(key)}: {value_html(value)}' for key, value in keys)}</td></tr>"
        for part, keys in assumptions
    ]
    if rows:
        section.add(
            "<h3>Assumptions</h3><p>Keys that the model file omits, with the values in effect. "
            "Features that are absent are not listed; pitchpoint check lists all keys.</p>"
        )
        section.add(f'<div class="scroll"><table class="plain"><tbody>{"".join(rows)}</tbody></table></div>')
    items = "".join(f"<li>{escape(line)}</li>" for line in sources)
    section.add(f'<h3>Sources</h3><ul class="notes">{items}</ul>' if items else "")
    return section
